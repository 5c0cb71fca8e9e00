/** What came of a block: images oriented, points by rays, residuals, calibrated cameras, warnings, and what was skipped. */
import { byReason } from '../../../pkg/block/refused-files.js';
import { namesText } from '../../shared/files/refused';
import { button, fill, h, row, section } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { asFigure } from '../../shared/text/direction';
import { count, fixed } from '../../shared/text/format';
import { readable } from '../../shared/text/names';
import type { BlockStore } from '../engine/engine';
import type { MarkStep } from '../state/marks';
import { placedFiles } from '../state/placed';
import { countedPoints } from '../state/point-kinds';
import { isStale } from '../state/purpose';
import { removableFiles } from '../state/removing';
import { isBusy } from '../state/state';
import type { BlockState, Shown } from '../state/state';
import type { BlockScore, CheckSummary, RefinementOutcome } from '../../../pkg/wasm/tiepoint.js';
import type { BlockView, ViewCamera } from '../state/view';
import { matchesOf } from '../state/words';
import { componentTable } from './components';
import { heightsText } from './placing-answer';
import { verdictText } from './placing-words';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

/** Reasons listed one by one; the others are in the table of images. */
const LISTED = 50;

/** `takeOff`: gives the block as it was before it was placed on an orthophoto. */
export function mountResults(host: HTMLElement, store: BlockStore, takeOff: () => void): void {
  const body = h('div', { testid: 'block-results' });
  host.append(body);
  const off = button(say('without-the-orthophoto'), 'block-off-ground', takeOff, say('the-block-as-it-was'));
  const out = button(say('take-these-out'), 'block-remove-left-out', () => {
    const step = outOf(store.state);
    if (step !== null) store.dispatch({ type: 'mark', step });
  });
  store.watch(['shown', 'files', 'options', 'placing', 'skipped'], ([shown, , , , skipped]) => {
    out.hidden = outOf(store.state) === null;
    body.classList.toggle('is-stale', isStale(store.state));
    const placed = placedOf(store.state);
    const none = placed === null ? h('p', { class: 'note' }, say('no-block-yet-drop-images')) : null;
    fill(
      body,
      ...(shown === null ? [none] : sectionsOf(shown, off, out, (text) => readable(store.state.catalogue?.labels ?? null, text))),
      placed,
      shown === null ? null : strays(say('other-files-skipped'), 'block-other-files', skipped, say('no-images-by-their-names')),
    );
  });
  store.watch(['running', 'notice', 'placing'], () => {
    off.disabled = isBusy(store.state);
    out.disabled = isBusy(store.state);
  });
}

/** What speaks against a block, the first of these that there is. */
const REASONS = ['block-warnings', 'block-not-oriented', 'block-facts'];

/** Brings what speaks against the block into sight, and the keyboard to it. */
export function showReasons(host: HTMLElement): void {
  const [first] = REASONS.flatMap((testid) => host.querySelector<HTMLElement>(`[data-testid="${testid}"]`) ?? []);
  if (first === undefined) return;
  first.tabIndex = -1;
  first.scrollIntoView({ block: 'start' });
  first.focus({ preventScroll: true });
}

/** `written`: a message of the crate as the page writes it. */
function sectionsOf(shown: Shown, off: HTMLElement, out: HTMLElement, written: (text: string) => string): (HTMLElement | null)[] {
  const { view } = shown;
  if (view.partial)
    return [leftOut(view, out), section(say('so-far'), 'block-facts', facts(partialFacts(view))), section(say('cameras'), 'block-cameras', cameraTable(view))];
  return [
    leftOut(view, out),
    strays(say('masks-without-an-image'), 'block-stray-masks', view.strayMasks, say('no-image-has-their-name')),
    strays(say('image-measurements-without-an-image'), 'block-stray-marks', view.strayMarks, say('not-among-the-images-read')),
    listOf(say('remarks'), 'block-remarks', view.remarks.map(written)),
    section(say('block'), 'block-facts', facts(factsOf(view))),
    onGround(shown, off, written),
    view.score === null ? null : section(say('against-the-truth'), 'block-score', facts(scoreFacts(view.score))),
    listOf(say('warnings'), 'block-warnings', view.warnings.map(written)),
    notOriented(view),
    section(say('tie-points-by-number-of'), 'block-by-rays', rayTable(view)),
    section(say('cameras'), 'block-cameras', cameraTable(view)),
    view.components.length === 0 ? null : section(say('stated-standard-errors'), 'block-components', ...componentTable(view.components)),
  ];
}

/** What came of the orthophoto. */
function onGround(shown: Shown, off: HTMLElement, written: (text: string) => string): HTMLElement | null {
  const { view, ground } = shown;
  if (view.orthophoto === null) return null;
  return section(
    say('orthophoto'),
    'block-on-orthophoto',
    h('p', {}, written(view.orthophoto.text)),
    ground === null ? null : h('p', { class: 'buttons' }, off),
    ground === null || ground.verdicts.length === 0
      ? null
      : reasons(ground.verdicts.map(({ name, verdict }) => ({ name, reason: written(message('placing_verdict', verdict)) }))),
  );
}

/** What came of images that were placed on the orthophoto by themselves; null where none was tried. */
function placedOf(state: BlockState): HTMLElement | null {
  const tried = placedFiles(state);
  if (tried.length === 0) return null;
  const list = tried.map((one) => ({ name: one.file.name, reason: `${verdictText(one, state)}${one.isStale ? say('earlier-settings') : ''}` }));
  return section(say('placed-images'), 'block-placed-images', reasons(list), h('p', {}, heightsText(state)));
}

/** What is known before there are points. */
function partialFacts(view: BlockView): Fact[] {
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected');
  return [
    { name: say('images-read'), testid: 'block-read', value: count(view.images.length), help: say('images-whose-features-are-detected') },
    {
      name: say('connected-pairs'),
      testid: 'block-connected',
      value: say('of-tried', { connected: connected.length, connections: view.connections.length }),
      help: say('pairs-with-enough-matches-that'),
    },
    {
      name: say('matches-2'),
      testid: 'block-matches',
      value: count(connected.reduce((sum, connection) => sum + matchesOf(connection), 0)),
      help: say('verified-matches-of-all-connected'),
    },
  ];
}

function strays(title: string, testid: string, names: readonly string[], why: string): HTMLElement | null {
  if (names.length === 0) return null;
  return section(title, testid, h('p', {}, `${asFigure(`${names.slice(0, LISTED).join(', ')}${names.length > LISTED ? ' …' : ''}`)}: ${why}.`));
}

function listOf(title: string, testid: string, texts: readonly string[]): HTMLElement | null {
  return texts.length === 0 ? null : section(title, testid, h('ul', {}, ...texts.map((text) => h('li', {}, text))));
}

function checkFacts({ points, rmse_m: rmse, mean_m: mean, ratio }: CheckSummary): Fact[] {
  const ofAxes = (values: readonly number[]) => values.map((value) => fixed(value, 3)).join(' ');
  return [
    {
      name: say('check-points-rmse'),
      testid: 'block-checks',
      value: say('m-points', { join: ofAxes(rmse), points, what: ratio === null ? '' : say('predicted', { ratio }) }),
      help: say('root-mean-square-difference-of'),
    },
    { name: say('check-points-mean'), testid: 'block-checks-mean', value: say('mean-m', { join: ofAxes(mean) }), help: say('mean-difference-of-check-points') },
  ];
}

function factsOf(view: BlockView): Fact[] {
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected');
  const matches = connected.reduce((sum, connection) => sum + matchesOf(connection), 0);
  const { tie, surveyed } = countedPoints(view);
  return [
    {
      name: say('images-oriented-3'),
      testid: 'block-oriented',
      value: say('of-4', { oriented: view.oriented, images: view.images.length }),
      help: say('images-with-an-exterior-orientation'),
    },
    {
      name: say('connected-pairs'),
      testid: 'block-connected',
      value: say('of-tried', { connected: connected.length, connections: view.connections.length }),
      help: say('pairs-with-enough-matches-that-agree'),
    },
    {
      name: say('groups'),
      testid: 'block-groups',
      value: groupText(view),
      help: say('images-that-are-connected-directly'),
    },
    { name: say('matches-2'), testid: 'block-matches', value: count(matches), help: say('verified-matches-of-all-connected') },
    ...(view.found === null
      ? []
      : [
          {
            name: say('tie-points'),
            testid: 'block-found',
            value: say('observations-2', { points: view.found.points, rays: view.found.rays }),
            help: say('points-seen-in-two-or'),
          },
        ]),
    ...(view.refinement === null ? [] : [refinementFact(view.refinement)]),
    {
      name: say('selected-tie-points'),
      testid: 'block-points-count',
      value: say('observations-2', { points: tie.points, rays: tie.observations }),
      help: say('the-tie-points-of-the'),
    },
    ...(surveyed.points === 0
      ? []
      : [
          {
            name: say('control-and-check-points'),
            testid: 'block-surveyed-count',
            value: say('observations-2', { points: surveyed.points, rays: surveyed.observations }),
            help: say('control-and-check-points-of-the'),
          },
        ]),
    ...(view.checks === null ? [] : checkFacts(view.checks)),
    {
      name: 'RMSE',
      testid: 'block-rmse',
      value: say('px-3', { value: view.rmsePx }),
      help: say('root-mean-square-length-of'),
    },
    { name: 'σ₀', testid: 'block-sigma0', value: say('px-3', { value: view.sigma0Px }), help: say('standard-error-of-one-image') },
  ];
}

/** Why observations keep their positions. */
const KEPT: Readonly<Record<Exclude<RefinementOutcome, 'reference' | 'refined'>, string>> = {
  not_converged: say('did-not-converge'),
  left_image: say('at-the-border'),
  moved_too_far: say('moved-too-far'),
  low_correlation: say('low-correlation-2'),
  no_texture: say('no-texture'),
  inconsistent: say('inconsistent'),
};

function refinementFact(counts: NonNullable<BlockView['refinement']>): Fact {
  const { reference, refined, ...kept } = counts;
  const others = Object.values(kept).reduce((sum, number) => sum + number, 0);
  const reasons = Object.entries(KEPT).flatMap(([outcome, words]) => {
    const number = kept[outcome as keyof typeof KEPT];
    return number === 0 ? [] : [`${count(number)} ${words}`];
  });
  return {
    name: say('refined-observations'),
    testid: 'block-refined',
    value: say('of-5', { refined, refined_2: refined + others }),
    help: say('observations-moved-by-least-squares', { reference, what: reasons.length > 0 ? say('n--3', { join: reasons.join(', ') }) : '' }),
  };
}

function scoreFacts(score: BlockScore): Fact[] {
  const positions = score.position_rmse_m?.map((error) => fixed(error, 3)).join(', ');
  return [
    {
      name: say('right-points'),
      testid: 'score-points',
      value: say('of-6', { right_points: score.right_points, points: score.points }),
      help: say('points-whose-observations-all-agree'),
    },
    {
      name: say('their-observations'),
      testid: 'score-rays',
      value: say('px-3', { value: score.right_rmse_px }),
      help: say('root-mean-square-distance-of'),
    },
    {
      name: say('positions'),
      testid: 'score-positions',
      value: positions === undefined ? '–' : `${positions} m`,
      help: say('root-mean-square-errors-of'),
    },
    {
      name: say('angles'),
      testid: 'score-angles',
      value: `${fixed(score.angle_rmse_deg, 4)}°`,
      help: say('root-mean-square-angle-between'),
    },
  ];
}

function groupText({ groups, images }: BlockView): string {
  const sizes = groups.map(({ length }) => length);
  const alone = sizes.filter((size) => size === 1).length;
  const largest = sizes[0] ?? 0;
  if (largest === images.length) return say('one-group');
  return say('the-largest-of', { sizes: sizes.length - alone, largest, what: alone > 0 ? say('single', { alone }) : '' });
}

function leftOut(view: BlockView, out: HTMLElement): HTMLElement | null {
  if (view.leftOut.length === 0) return null;
  return section(say('skipped-that-cannot-be-read', { left_out: view.leftOut.length }), 'block-left-out', reasons(view.leftOut), out);
}

/** Takes the files out that cannot be used; null where they are not there, or too few would be left. */
function outOf({ shown, files, history }: BlockState): MarkStep | null {
  const names = new Set(shown?.view.leftOut.map(({ name }) => name));
  const out = removableFiles(files, names);
  return out.length === 0 ? null : { kind: 'remove_images', files: out.map(({ id }) => id), after: history.done };
}

function notOriented(view: BlockView): HTMLElement | null {
  const lost = view.images.filter(({ oriented }) => !oriented);
  // Before any is oriented there is nothing to say of one.
  if (view.oriented === 0 || lost.length === 0) return null;
  return section(say('not-oriented', { lost: lost.length }), 'block-not-oriented', reasons(lost.map(({ name, why }) => ({ name, reason: why ?? '' }))));
}

function reasons(list: readonly { name: string; reason: string }[]): HTMLElement {
  const together = [...byReason(list)];
  const rest = together.slice(LISTED).reduce((sum, [, names]) => sum + names.length, 0);
  return h(
    'ul',
    { class: 'reasons' },
    ...together.slice(0, LISTED).map(([reason, names]) => h('li', {}, h('b', {}, namesText(names)), `: ${reason}`)),
    rest > 0 ? h('li', {}, say('and-more-in-the-table', { rest })) : null,
  );
}

function rayTable({ byRays }: BlockView): HTMLElement {
  const head = h('thead', {}, h('tr', {}, ...[say('rays-2'), say('points'), say('rmse-px-4')].map((text) => h('th', { scope: 'col' }, text))));
  const number = (text: string) => h('td', { class: 'number' }, text);
  return h(
    'table',
    { testid: 'by-rays' },
    head,
    h('tbody', {}, ...byRays.map(({ rays, points, rmsePx }) => row(count(rays), number(count(points)), number(fixed(rmsePx, 3))))),
  );
}

function cameraTable({ cameras, found }: BlockView): HTMLElement {
  // A block that was opened does not say what was known before.
  const given = ({ given: known }: ViewCamera) => (known === null ? (found === null ? '–' : say('unknown-2')) : fixed(known.focal_px, 1));
  const head = h(
    'thead',
    {},
    h('tr', {}, ...[say('camera'), say('images-2'), say('given-f-px'), say('calibrated-f-px')].map((text) => h('th', { scope: 'col' }, text))),
  );
  const number = (text: string) => h('td', { class: 'number' }, text);
  return h(
    'div',
    { class: 'scroll' },
    h(
      'table',
      { class: 'tight', testid: 'cameras' },
      head,
      h(
        'tbody',
        {},
        ...cameras.map((camera, i) =>
          row(
            `${String(i + 1)}: ${camera.label.replace(/(\d) x (?=\d)/gu, '$1 × ')}`,
            number(count(camera.images)),
            number(given(camera)),
            number(
              camera.calibrated === null
                ? '–'
                : `${fixed(camera.calibrated.focal_px, 1)}${camera.focalErrorPx === null ? '' : ` ± ${fixed(camera.focalErrorPx, 1)}`}`,
            ),
          ),
        ),
      ),
    ),
  );
}
