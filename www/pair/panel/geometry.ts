/** What relates the two views, by which matches of gradients were verified: the kind of model, its precision, where it is degenerate. */
import { message } from '../../shared/crate';
import type { MatchResult } from '../../shared/crate';
import { comparesGradients, isStale } from '../state/keys';
import { shownPair } from '../state/select';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, section } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { count, fixed } from '../../shared/text/format';

export function mountGeometry(host: HTMLElement, store: Store): void {
  const body = h('div', {});
  const panel = section('Geometry of the two views', 'geometry-section', body);
  host.append(panel);
  store.watch(['results', 'settings', 'images', 'camera', 'photos', 'masks'], () => {
    const { state } = store;
    panel.hidden = state.settings === null || !comparesGradients(state.settings);
    panel.classList.toggle('is-stale', isStale(state, 'match'));
    if (!panel.hidden) fill(body, ...content(state));
  });
}

function content(state: State): HTMLElement[] {
  const { match } = shownPair(state);
  if (match === null) return [h('p', { class: 'note' }, 'Not computed yet.')];
  if (match.geometry === null) {
    // Matches of another strategy stay on the screen until those of this one come.
    const none = match.no_geometry;
    return [
      h(
        'p',
        { class: none === null ? 'note' : 'field-problem', testid: 'geometry-reason' },
        none === null ? 'Not computed yet.' : `None: ${message('no_geometry', none)}.`,
      ),
    ];
  }
  const { degenerate } = match.geometry;
  return [
    ...(degenerate === null ? [] : [h('p', { class: 'field-problem', testid: `degenerate-${degenerate}` }, message('degeneracy', degenerate))]),
    facts(figures(match, match.geometry)),
  ];
}

function figures(match: MatchResult, { model: { kind }, sigma_px: sigma, threshold_px: threshold, focal }: NonNullable<MatchResult['geometry']>): Fact[] {
  return [
    { name: 'Model', testid: 'geometry-kind', value: message('two_view_model', { kind }, 'label'), help: message('two_view_model', { kind }, 'help') },
    {
      name: 'Matches that agree',
      testid: 'geometry-matches',
      value: count(match.counts.matches),
      help: 'All others are rejected. Matches that only the geometry made unambiguous are among them.',
    },
    {
      name: 'Standard error of a coordinate',
      testid: 'geometry-sigma',
      value: `${fixed(sigma, 3)} px`,
      help: 'From the distances of these matches to their epipolar lines, or to their predicted positions.',
    },
    {
      name: 'Threshold',
      testid: 'geometry-threshold',
      value: `${fixed(threshold, 2)} px`,
      help: 'Largest distance of a match that agrees. It follows from the scatter of the matches where none is given.',
    },
    ...(focal === null
      ? []
      : [
          {
            name: 'Focal length, estimated',
            testid: 'geometry-focal',
            value: `${fixed(focal.focal_px, 0)} ± ${fixed(focal.standard_error_px, 0)} px`,
            help: 'Of both cameras, from the matches alone, with its standard error. The principal point is assumed at the image centre. A relative error of a tenth is small enough for the relative orientation.',
          },
        ]),
  ];
}
