/** The relative orientation with its precision: the paper's Tables 2 and 3, and the correlations. */
import { message } from '../../shared/crate';
import type { FiveParameters, Paper, RelativeOrientation } from '../../shared/crate';
import { interiorInUse } from '../state/interior';
import { isCurrent, isStale, pairCameras, wantedKeys } from '../state/keys';
import { hasPaperCamera } from '../state/paper';
import { pixelMm } from '../state/residuals';
import { orientationAt, truthOf } from '../state/truth';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, row, section } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { count, fixed, significant } from '../../shared/text/format';
import { page } from '../../shared/text/words';
import { correlationPicture, ellipsePicture } from './matrix';
import { UNKNOWNS } from './unknowns';

const SIGMA_CAVEAT =
  'σ₀ is computed from y-parallaxes. It sees only the component of an error across the epipolar line, and cannot prove a match right: a wrong match along the line leaves it unchanged.';

export function mountOrientation(host: HTMLElement, store: Store): void {
  const body = h('div', {});
  const panel = section('Relative orientation', 'orientation-section', body);
  host.append(panel);
  store.watch(['results', 'settings', 'images', 'failures', 'camera', 'photos', 'offset', 'fiducialModel'], () => {
    const { state } = store;
    panel.classList.toggle('is-stale', isStale(state, 'orientation'));
    fill(body, ...content(state));
  });
}

function content(state: State): HTMLElement[] {
  const reason = whyNotOriented(state);
  if (reason !== null) return [h('p', { class: 'note', testid: 'orientation-reason' }, reason)];
  const result = state.results.orientation?.value;
  if (result === undefined) return [h('p', { class: 'note', testid: 'orientation-reason' }, 'Not computed yet.')];
  return [
    ...estimatedFocal(state),
    valueTable(state, result),
    ...warnings(result),
    precision(state, result),
    h('p', { class: 'caveat', testid: 'sigma-caveat' }, SIGMA_CAVEAT),
    pictures(state, result),
  ];
}

/** Says where the focal length is from, where no camera is known. */
function estimatedFocal(state: State): HTMLElement[] {
  const { match } = state.results;
  const focal = match?.value.geometry?.focal ?? null;
  if (!('missing' in pairCameras(state)) || focal === null || match?.value.estimated == null) return [];
  return [h('p', { class: 'note', testid: 'estimated-focal' }, page('estimated_focal', { focal_px: focal.focal_px, error_px: focal.standard_error_px }))];
}

/** Images are equal where nine tenths of the matches (stride 5) lie this near to the same place of both, px. */
const EQUAL_PX = 0.05;

function areEqual(matches: Float64Array): boolean {
  let equal = 0;
  for (let i = 0; i < matches.length; i += 5) {
    const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = matches.subarray(i, i + 4);
    if (Math.abs(xr - xl) < EQUAL_PX && Math.abs(yr - yl) < EQUAL_PX) equal += 1;
  }
  return matches.length > 0 && equal > 0.9 * (matches.length / 5);
}

/** Why there is no orientation for what is wanted now; null where there is one, or one to come. */
export function whyNotOriented(state: State): string | null {
  const keys = wantedKeys(state);
  if (state.images.left === null || state.images.right === null) return 'Two images are needed.';
  const match = isCurrent(state, 'match') ? (state.results.match?.value ?? null) : null;
  if (match?.geometry?.degenerate === 'pure-rotation') {
    return areEqual(match.matches)
      ? 'Not oriented: both images show the same at the same positions. Is it one photo twice?'
      : `Not oriented: ${message('no_orientation', { kind: 'pure_rotation' })}.`;
  }
  if (match?.no_geometry != null) return `Not oriented: ${message('no_geometry', match.no_geometry)}. Do both photos show the same ground?`;
  const cameras = pairCameras(state);
  if (state.results.openLeft !== undefined && state.results.openRight !== undefined && 'missing' in cameras && keys.orientation === null) {
    if (cameras.missing.kind === 'panorama') return `Not oriented: ${message('no_orientation', cameras.missing)}.`;
    const untold = match?.geometry == null ? '' : ', and the matches do not determine the focal length';
    return `Not oriented: ${message('no_orientation', cameras.missing)}${untold}. Give the focal length, and the pixel size or fiducial marks, under “Camera”.`;
  }
  for (const stage of ['interiorLeft', 'interiorRight', 'orientation'] as const) {
    const failure = state.failures[stage];
    if (failure !== undefined && failure.key === keys[stage]) return `Not oriented. ${failure.message}`;
  }
  return null;
}

/** The true orientation at the scale of a result's base; null where it is not known. */
function truthFor(state: State, { base_mm: base }: RelativeOrientation): FiveParameters | null {
  const truth = truthOf(state);
  return truth === null ? null : orientationAt(truth, base);
}

function valueTable(state: State, result: RelativeOrientation): HTMLElement {
  const truth = truthFor(state, result);
  const paper = truth === null && hasPaperCamera(state) ? state.catalogue?.paper : undefined;
  const { standard_errors: errors, total_standard_errors: total, half_widths_95: half } = result;
  const number = (testid: string, value: number | null | undefined, digits: number, kind = '') =>
    h('td', { testid, class: `number ${kind}` }, fixed(value, digits));
  const rows = UNKNOWNS.map(({ field, symbol, unit, digits }) => {
    const error = truth === null ? NaN : result[field] - truth[field];
    const own = [number(`orientation-${field}`, result[field], digits), number(`error-${field}`, errors?.[field], digits)];
    const withInterior = total === null ? [] : [number(`total-error-${field}`, total[field], digits)];
    const interval = number(`interval-${field}`, half?.[field], digits);
    const printed =
      paper === undefined
        ? []
        : [
            number(`paper-${field}`, paper.orientations[2].values[field], digits, 'paper'),
            number(`paper-error-${field}`, paper.standard_errors[field], digits, 'paper'),
          ];
    const compared =
      truth === null
        ? printed
        : [number(`deviation-${field}`, error, digits), number(`deviation-ratio-${field}`, error / ((total ?? errors)?.[field] ?? NaN), 1)];
    return row(h('span', {}, h('i', {}, symbol), h('span', { class: 'unit' }, ` ${unit}`)), ...own, ...withInterior, interval, ...compared);
  });
  const heads: [string, string][] = [
    ['Value', 'The right photo relative to the left one, dependent relative orientation.'],
    ['Std error', 'What the scatter of the matches leaves uncertain.'],
    ...(total === null
      ? []
      : [
          [
            'In total',
            'Standard error including what does not average out: neighbouring matches share errors because their windows overlap, and all share those of the measured fiducial marks.',
          ] satisfies [string, string],
        ]),
    [
      '95 % ±',
      'Half-width of the interval that holds the unknown in 95 of 100 cases: of the last standard error, by the distribution of Student for the degrees of freedom.',
    ],
    ...(paper !== undefined
      ? ([
          ['Paper', "The paper's Table 3, of its own pair"],
          ['its error', "The paper's Table 2"],
        ] satisfies [string, string][])
      : []),
    ...(truth === null
      ? []
      : ([
          ['True error', 'Value minus truth; by and bz at the scale of the base used.'],
          ['in std errors', 'The true error divided by the standard error, with that of the interior orientations where known: beyond 3 in 3 of 1,000 cases.'],
        ] satisfies [string, string][])),
  ];
  const note = paper !== undefined ? h('p', { class: 'note' }, paperNote(state, paper)) : null;
  return h(
    'div',
    {},
    h(
      'div',
      { class: 'scroll' },
      h(
        'table',
        { class: 'tight', aria: { label: 'Relative orientation' } },
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', { scope: 'col' }, 'Unknown'),
            ...heads.map(([text, title]) => h('th', { scope: 'col', title, class: text === 'Paper' || text === 'its error' ? 'paper' : '' }, text)),
          ),
        ),
        h('tbody', {}, ...rows),
      ),
    ),
    note,
  );
}

/** Whose pair it was, and with what it was photographed. */
function paperNote({ catalogue }: State, { pixel_mm: pixel }: Paper): string {
  const flight = catalogue?.flights.find(({ name }) => name === 'paper')?.flight;
  return page('paper', { focal_mm: flight?.focal_mm ?? null, base_mm: flight?.base_mm ?? null, pixel_um: 1000 * pixel });
}

function warnings({ warnings: found }: RelativeOrientation): HTMLElement[] {
  return found.map((warning) => h('p', { class: 'field-problem', testid: `warning-${warning.kind}` }, message('warning', warning)));
}

function precision(state: State, result: RelativeOrientation): HTMLElement {
  const interior = interiorInUse(state)?.left;
  const pixel = interior === undefined ? null : pixelMm(interior);
  const sigma = result.sigma0_mm;
  const used = result.residuals_mm.length - result.rejected.length;
  const test = result.global_test;
  const printed = hasPaperCamera(state) ? state.catalogue?.paper : undefined;
  const list: Fact[] = [
    {
      name: 'σ₀ of a photo coordinate',
      testid: 'sigma0',
      value: sigma == null ? '–' : `${fixed(1000 * sigma, 2)} µm${pixel === null ? '' : ` = ${fixed(sigma / pixel, 3)} px`}`,
      help: `Standard error of one photo coordinate of weight 1, from the residuals. ${SIGMA_CAVEAT}`,
    },
    {
      name: 'of a y-parallax (√2 σ₀)',
      testid: 'sigma-parallax',
      value: sigma == null || pixel === null ? '–' : `${fixed((Math.SQRT2 * sigma) / pixel, 3)} px`,
      help: 'Standard error of the y-parallax of a match: the distance at which its two rays pass each other.',
    },
    ...(test === null
      ? []
      : [
          {
            name: 'Global test',
            testid: 'global-test',
            value: `${fixed(test.statistic, 1)}: ${test.passed ? 'passed' : 'FAILED'}`,
            ...(test.passed ? {} : { kind: 'problem' as const }),
            help: page('global_test', { lower: test.lower, upper: test.upper }),
          },
        ]),
    { name: 'Degrees of freedom', testid: 'degrees-of-freedom', value: count(result.degrees_of_freedom), help: 'Matches used minus the five unknowns.' },
    {
      name: 'Matches used',
      testid: 'matches-used',
      value: `${count(used)} of ${count(result.residuals_mm.length)}`,
      help: 'Data snooping rejected the others as gross errors, or their rays meet behind a camera.',
    },
    {
      name: 'Condition',
      testid: 'condition',
      value: significant(result.condition),
      help: 'Largest by smallest eigenvalue of the matrix of correlations: 1 where the unknowns are independent, some thousands for vertical photographs, far more where they are hardly separable.',
    },
    {
      name: 'Misfit to a plane',
      testid: 'plane-misfit',
      value: result.plane_misfit === null ? '–' : `${significant(result.plane_misfit)} σ₀`,
      help: 'How far the matches deviate from the best map of one plane onto another, in standard errors: about 1 over a plane, where a second orientation may fit as well; large over relief.',
    },
    {
      name: 'Parallax beside a rotation',
      testid: 'rotation-parallax',
      value: pixel === null ? `${significant(result.parallax_beside_rotation_mm)} mm` : `${significant(result.parallax_beside_rotation_mm / pixel)} px`,
      help: 'Median parallax that the best rotation of the right photo leaves: what of the difference of the photos only a base explains. Next to nothing where the camera only turned.',
    },
    {
      name: 'Spread',
      testid: 'spread',
      value: `${fixed(result.spread, 3)} f`,
      help: 'Root mean square distance of the points from their middle in the left photo, in principal distances. Small where they cover little of the photo.',
    },
    {
      name: 'Iterations, last step',
      testid: 'iterations',
      value: `${String(result.iterations)}, ${significant(result.last_step)}`,
      help: 'The last step relative to a millionth of the standard errors: below 1 the adjustment has converged.',
    },
    {
      name: 'Base b, principal distance',
      testid: 'base',
      value: `${significant(result.base_mm)} mm, ${significant(result.focal_mm)} mm`,
      help: 'The base component that was fixed gives by and bz their scale.',
    },
    ...(printed !== undefined
      ? [
          {
            name: 'Paper',
            testid: 'paper-sigma0',
            value: page('paper_sigma', { sigma0_mm: printed.sigma0_mm, sigma0_px: printed.sigma0_mm / printed.pixel_mm }),
            help: 'What the paper printed for its own pair.',
          },
        ]
      : []),
  ];
  return facts(list);
}

function pictures(state: State, result: RelativeOrientation): HTMLElement {
  const truth = truthFor(state, result);
  const deviation: [number, number] | null = truth === null || Number.isNaN(truth.by_mm) ? null : [result.by_mm - truth.by_mm, result.bz_mm - truth.bz_mm];
  const ellipse = result.base_ellipse_mm;
  return h('div', { class: 'precision-pictures' }, correlationPicture(result), ellipse === null ? null : ellipsePicture(ellipse, deviation));
}
