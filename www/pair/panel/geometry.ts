/** What relates the two views, by which matches of gradients were verified: the kind of model, its precision, where it is degenerate. */
import type { MatchResult } from '../../shared/crate';
import { comparesGradients, isStale } from '../state/keys';
import { oneImage } from '../state/one-image';
import { shownPair } from '../state/select';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, section } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { count } from '../../shared/text/format';
import { whenInSight } from '../../shared/panel/sight';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

export function mountGeometry(host: HTMLElement, store: Store): void {
  const body = h('div', {});
  const panel = section(say('geometry-of-the-two-views'), 'geometry-section', body);
  host.append(panel);
  store.watch(
    ['results', 'settings', 'images', 'camera', 'photos', 'masks'],
    whenInSight(host, () => {
      const { state } = store;
      panel.hidden = state.settings === null || !comparesGradients(state.settings);
      panel.classList.toggle('is-stale', isStale(state, 'match'));
      if (!panel.hidden) fill(body, ...content(state));
    }),
  );
}

function content(state: State): HTMLElement[] {
  const { match } = shownPair(state);
  if (match === null) return [h('p', { class: 'note' }, say('not-computed-yet'))];
  if (match.geometry === null) {
    // Matches of another strategy stay on the screen until those of this one come.
    const none = match.no_geometry;
    return [
      h(
        'p',
        { class: none === null ? 'note' : 'field-problem', testid: 'geometry-reason' },
        none === null ? say('not-computed-yet') : say('none', { message: message('no_geometry', none) }),
      ),
    ];
  }
  // Of one photo twice it is said that it is one: a rotation by nothing fits, too.
  const degenerate = oneImage(state) === null ? match.geometry.degenerate : null;
  return [
    ...(degenerate === null ? [] : [h('p', { class: 'field-problem', testid: `degenerate-${degenerate}` }, message('degeneracy', degenerate))]),
    facts(figures(match, match.geometry)),
  ];
}

type Geometry = NonNullable<MatchResult['geometry']>;

/** The kind of model in words: cameras whose focal length the matches gave are none that anybody calibrated. */
export function modelText({ model: { kind }, focal }: Pick<Geometry, 'model' | 'focal'>): string {
  return message('two_view_model', { kind }, kind === 'calibrated' && focal !== null ? 'estimated' : 'label');
}

function figures(match: MatchResult, geometry: Geometry): Fact[] {
  const {
    model: { kind },
    sigma_px: sigma,
    threshold_px: threshold,
    focal,
  } = geometry;
  return [
    { name: say('model'), testid: 'geometry-kind', value: modelText(geometry), help: message('two_view_model', { kind }, 'help') },
    {
      name: say('matches-that-agree'),
      testid: 'geometry-matches',
      value: count(match.counts.matches),
      help: say('all-others-are-rejected-matches'),
    },
    {
      name: say('standard-error-of-a-coordinate'),
      testid: 'geometry-sigma',
      value: say('px-3', { value: sigma }),
      help: say('from-the-distances-of-these'),
    },
    {
      name: say('threshold'),
      testid: 'geometry-threshold',
      value: say('px-2', { value: threshold }),
      help: say('largest-distance-of-a-match'),
    },
    ...(focal === null
      ? []
      : [
          {
            name: say('focal-length-estimated'),
            testid: 'geometry-focal',
            value: say('px-5', { focal_px: focal.focal_px, standard_error_px: focal.standard_error_px }),
            help: say('of-both-cameras-from-the'),
          },
        ]),
  ];
}
