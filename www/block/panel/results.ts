/** What came of a block: images oriented, points by rays, residuals, calibrated cameras, warnings, and what was skipped. */
import { fill, h, row, section } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { count, fixed } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import { isOutdated } from '../state/state';
import type { BlockScore, CheckSummary, RefinementOutcome } from '../../../pkg/wasm/tiepoint.js';
import type { BlockView, ViewCamera } from '../state/view';
import { matchesOf } from '../state/words';

/** Reasons listed one by one; the others are in the table of images. */
const LISTED = 50;

export function mountResults(host: HTMLElement, store: BlockStore): void {
  const body = h('div', { testid: 'block-results' });
  host.append(body);
  store.watch(['shown', 'files', 'options'], ([shown]) => {
    body.classList.toggle('is-stale', isOutdated(store.state));
    if (shown === null) fill(body, h('p', { class: 'note' }, 'No block yet. Drop images or a folder, or simulate a block, then press Run.'));
    else fill(body, ...sectionsOf(shown.view));
  });
}

function sectionsOf(view: BlockView): (HTMLElement | null)[] {
  if (view.partial) return [leftOut(view), section('So far', 'block-facts', facts(partialFacts(view))), section('Cameras', 'block-cameras', cameraTable(view))];
  return [
    leftOut(view),
    strays('Masks without an image', 'block-stray-masks', view.strayMasks, 'no image has their name'),
    strays('Image measurements without an image', 'block-stray-marks', view.strayMarks, 'not among the images read'),
    listOf('Remarks', 'block-remarks', view.remarks),
    section('Block', 'block-facts', facts(factsOf(view))),
    view.score === null ? null : section('Against the truth', 'block-score', facts(scoreFacts(view.score))),
    listOf('Warnings', 'block-warnings', view.warnings),
    notOriented(view),
    section('Tie points by number of rays', 'block-by-rays', rayTable(view)),
    section('Cameras', 'block-cameras', cameraTable(view)),
  ];
}

/** What is known before there are points. */
function partialFacts(view: BlockView): Fact[] {
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected');
  return [
    { name: 'Images read', testid: 'block-read', value: count(view.images.length), help: 'Images whose features are detected.' },
    {
      name: 'Connected pairs',
      testid: 'block-connected',
      value: `${count(connected.length)} of ${count(view.connections.length)} tried`,
      help: 'Pairs with enough matches that agree with one geometry.',
    },
    {
      name: 'Matches',
      testid: 'block-matches',
      value: count(connected.reduce((sum, connection) => sum + matchesOf(connection), 0)),
      help: 'Verified matches of all connected pairs.',
    },
  ];
}

function strays(title: string, testid: string, names: readonly string[], why: string): HTMLElement | null {
  if (names.length === 0) return null;
  return section(title, testid, h('p', {}, `${names.slice(0, LISTED).join(', ')}${names.length > LISTED ? ' …' : ''}: ${why}.`));
}

function listOf(title: string, testid: string, texts: readonly string[]): HTMLElement | null {
  return texts.length === 0 ? null : section(title, testid, h('ul', {}, ...texts.map((text) => h('li', {}, text))));
}

function checkFact({ points, rmse_m: rmse, ratio }: CheckSummary): Fact {
  return {
    name: 'Check points, RMSE',
    testid: 'block-checks',
    value: `${rmse.map((value) => fixed(value, 3)).join(' ')} m, ${count(points)} points${ratio === null ? '' : `, ${fixed(ratio, 2)} predicted`}`,
    help: 'Root mean square difference of x, y, z between adjusted and surveyed check points, whose coordinates took no part; then the same in predicted standard errors, about 1 where these hold.',
  };
}

function factsOf(view: BlockView): Fact[] {
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected');
  const matches = connected.reduce((sum, connection) => sum + matchesOf(connection), 0);
  const rays = view.images.reduce((sum, image) => sum + image.rays, 0);
  return [
    {
      name: 'Images oriented',
      testid: 'block-oriented',
      value: `${count(view.oriented)} of ${count(view.images.length)}`,
      help: 'Images with an exterior orientation: position and attitude in object space.',
    },
    {
      name: 'Connected pairs',
      testid: 'block-connected',
      value: `${count(connected.length)} of ${count(view.connections.length)} tried`,
      help: 'Pairs with enough matches that agree with one geometry. The matrix states for each pair why it is connected or not.',
    },
    {
      name: 'Groups',
      testid: 'block-groups',
      value: groupText(view),
      help: 'Images that are connected directly or through others. Images are oriented to each other only within a group.',
    },
    { name: 'Matches', testid: 'block-matches', value: count(matches), help: 'Verified matches of all connected pairs.' },
    ...(view.found === null
      ? []
      : [
          {
            name: 'Tie points',
            testid: 'block-found',
            value: `${count(view.found.points)}, ${count(view.found.rays)} observations`,
            help: 'Points seen in two or more images. A well distributed selection of them is adjusted.',
          },
        ]),
    ...(view.refinement === null ? [] : [refinementFact(view.refinement)]),
    {
      name: 'Selected tie points',
      testid: 'block-points-count',
      value: `${count(view.points.count)}, ${count(rays)} observations`,
      help: 'The tie points of the block and their image observations.',
    },
    ...(view.checks === null ? [] : [checkFact(view.checks)]),
    {
      name: 'RMSE',
      testid: 'block-rmse',
      value: `${fixed(view.rmsePx, 3)} px`,
      help: 'Root mean square length of the residuals of all accepted observations after the adjustment.',
    },
    { name: 'σ₀', testid: 'block-sigma0', value: `${fixed(view.sigma0Px, 3)} px`, help: 'Standard error of one image coordinate, from the adjustment.' },
  ];
}

/** Why observations keep their positions. */
const KEPT: Readonly<Record<Exclude<RefinementOutcome, 'reference' | 'refined'>, string>> = {
  not_converged: 'did not converge',
  left_image: 'at the border',
  moved_too_far: 'moved too far',
  low_correlation: 'low correlation',
  no_texture: 'no texture',
  inconsistent: 'inconsistent',
};

function refinementFact(counts: NonNullable<BlockView['refinement']>): Fact {
  const { reference, refined, ...kept } = counts;
  const others = Object.values(kept).reduce((sum, number) => sum + number, 0);
  const reasons = Object.entries(KEPT).flatMap(([outcome, words]) => {
    const number = kept[outcome as keyof typeof KEPT];
    return number === 0 ? [] : [`${count(number)} ${words}`];
  });
  return {
    name: 'Refined observations',
    testid: 'block-refined',
    value: `${count(refined)} of ${count(refined + others)}`,
    help: `Observations moved by least squares matching to the reference observations of ${count(reference)} points. The others keep their positions${reasons.length > 0 ? `: ${reasons.join(', ')}` : ''}.`,
  };
}

function scoreFacts(score: BlockScore): Fact[] {
  const positions = score.position_rmse_m?.map((error) => fixed(error, 3)).join(', ');
  return [
    {
      name: 'Right points',
      testid: 'score-points',
      value: `${count(score.right_points)} of ${count(score.points)}`,
      help: 'Points whose observations all agree within 1.5 px in each image, by the true orientations.',
    },
    {
      name: 'Their observations',
      testid: 'score-rays',
      value: `${fixed(score.right_rmse_px, 3)} px`,
      help: 'Root mean square distance of the observations of right points from their intersection.',
    },
    {
      name: 'Positions',
      testid: 'score-positions',
      value: positions === undefined ? '–' : `${positions} m`,
      help: 'Root mean square errors of x, y, z of the projection centres after the best similarity transformation to the truth.',
    },
    {
      name: 'Angles',
      testid: 'score-angles',
      value: `${fixed(score.angle_rmse_deg, 4)}°`,
      help: 'Root mean square angle between the oriented and the true attitudes after the same transformation.',
    },
  ];
}

function groupText({ groups, images }: BlockView): string {
  const sizes = groups.map(({ length }) => length);
  const alone = sizes.filter((size) => size === 1).length;
  const largest = sizes[0] ?? 0;
  if (largest === images.length) return 'one';
  return `${count(sizes.length - alone)} (the largest of ${count(largest)})${alone > 0 ? `, ${count(alone)} single` : ''}`;
}

function leftOut(view: BlockView): HTMLElement | null {
  if (view.leftOut.length === 0) return null;
  return section(`Skipped: ${count(view.leftOut.length)} that cannot be read`, 'block-left-out', reasons(view.leftOut));
}

function notOriented(view: BlockView): HTMLElement | null {
  const lost = view.images.filter(({ oriented }) => !oriented);
  // Before any is oriented there is nothing to say of one.
  if (view.oriented === 0 || lost.length === 0) return null;
  return section(`Not oriented: ${count(lost.length)}`, 'block-not-oriented', reasons(lost.map(({ name, why }) => ({ name, reason: why }))));
}

function reasons(list: readonly { name: string; reason: string }[]): HTMLElement {
  const rest = list.length - LISTED;
  return h(
    'ul',
    { class: 'reasons' },
    ...list.slice(0, LISTED).map(({ name, reason }) => h('li', {}, h('b', {}, name), `: ${reason}`)),
    rest > 0 ? h('li', {}, `and ${count(rest)} more in the table of images`) : null,
  );
}

function rayTable({ byRays }: BlockView): HTMLElement {
  const head = h('thead', {}, h('tr', {}, ...['Rays', 'Points', 'RMSE px'].map((text) => h('th', { scope: 'col' }, text))));
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
  const given = ({ given: known }: ViewCamera) => (known === null ? (found === null ? '–' : 'unknown') : fixed(known.focal_px, 1));
  const head = h('thead', {}, h('tr', {}, ...['Camera', 'Images', 'Given f px', 'Calibrated f px'].map((text) => h('th', { scope: 'col' }, text))));
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
