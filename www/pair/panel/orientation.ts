/** The relative orientation with its precision: the paper's Tables 2 and 3, and the correlations. */
import type { FiveParameters, Paper, RelativeOrientation } from '../../shared/crate';
import { focalOf } from '../state/focal';
import { interiorInUse } from '../state/interior';
import { isCurrent, isStale } from '../state/keys';
import { failureOf, whyNone } from '../state/no-orientation';
import { hasPaperCamera } from '../state/paper';
import { countsOf, pixelMm } from '../state/residuals';
import { atBase } from '../../../pkg/pair/at-base.js';
import { truthOf } from '../state/truth';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, row, section } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { count, decimalsOfError, fixed, significant } from '../../shared/text/format';
import { correlationPicture, ellipsePicture } from './matrix';
import { UNKNOWNS } from './unknowns';
import { scrolledByKeys } from '../../shared/panel/scrolled';
import { whenInSight } from '../../shared/panel/sight';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';
import { unitText, withUnit } from '../../shared/text/units';

const SIGMA_CAVEAT = say('is-computed-from-y-parallaxes');

export function mountOrientation(host: HTMLElement, store: Store): void {
  const body = h('div', {});
  const panel = section(say('relative-orientation'), 'orientation-section', body);
  host.append(panel);
  store.watch(
    ['results', 'settings', 'images', 'failures', 'camera', 'photos', 'offset', 'fiducialModel'],
    whenInSight(host, () => {
      const { state } = store;
      // Why there is none is said of the settings that are there.
      panel.classList.toggle('is-stale', whyNotOriented(state) === null && isStale(state, 'orientation'));
      fill(body, ...content(state));
    }),
  );
}

function content(state: State): HTMLElement[] {
  const reason = whyNotOriented(state);
  if (reason !== null) return [h('p', { class: 'note', testid: 'orientation-reason' }, reason)];
  const result = state.results.orientation?.value;
  if (result === undefined) return [h('p', { class: 'note', testid: 'orientation-reason' }, say('not-computed-yet'))];
  return [
    ...estimatedFocal(state),
    valueTable(state, result),
    ...(result.turn_deg === 0 ? [] : [h('p', { class: 'note', testid: 'axes-turned' }, say('axes-turned'))]),
    ...warnings(result),
    precision(state, result),
    h('p', { class: 'caveat', testid: 'sigma-caveat' }, SIGMA_CAVEAT),
    pictures(state, result),
  ];
}

/** Says which focal length the matches gave, where no camera is known: that of this very orientation, not what the geometry of the views began with. */
function estimatedFocal(state: State): HTMLElement[] {
  const text = estimatedFocalText(state);
  return text === null ? [] : [h('p', { class: 'note', testid: 'estimated-focal' }, text)];
}

/** What is said of it; null where a camera is known, or where the matches do not tell it. */
export function estimatedFocalText(state: State): string | null {
  const focal = focalOf(state);
  return focal?.isEstimated === true ? say('estimated-focal', { focal_px: focal.focalPx, error_px: focal.errorPx }) : null;
}

/** Why there is no orientation for what is wanted now; null where there is one, or one to come. */
export function whyNotOriented(state: State): string | null {
  if (state.images.left === null || state.images.right === null) return say('two-images-are-needed');
  const reason = whyNone(state);
  if (reason === null || reason.kind === 'refused') {
    const failure = failureOf(state);
    return failure === null ? null : say('not-oriented-3', { message: failure.message });
  }
  switch (reason.kind) {
    case 'no_geometry':
      return say('not-oriented-do-both-photos', { message: message('no_geometry', reason.no_geometry) });
    case 'no_camera':
    case 'no_focal_length':
    case 'no_pixel_size': {
      const isTold = isCurrent(state, 'match') && state.results.match?.value.geometry != null;
      const untold = isTold ? say('and-the-matches-do-not') : '';
      return say('not-oriented-give-the-focal', { message: message('no_orientation', reason), untold });
    }
    default:
      // These say themselves what can be given, if anything.
      return say('not-oriented-2', { message: message('no_orientation', reason) });
  }
}

/** The true orientation at the scale of a result's base; null where it is not known. */
function truthFor(state: State, { base_mm: base }: RelativeOrientation): FiveParameters | null {
  const truth = truthOf(state);
  return truth === null ? null : atBase(truth.orientation, truth.baseMm, base);
}

function valueTable(state: State, result: RelativeOrientation): HTMLElement {
  const truth = truthFor(state, result);
  const paper = truth === null && hasPaperCamera(state) ? state.catalogue?.paper : undefined;
  const { standard_errors: errors, total_standard_errors: total, half_widths_95: half } = result;
  const number = (testid: string, value: number | null | undefined, digits: number, kind = '') =>
    h('td', { testid, class: `number ${kind}` }, fixed(value, digits));
  const rows = UNKNOWNS.map(({ field, symbol, unit, digits: printedDigits }) => {
    const digits = decimalsOfError(errors?.[field], printedDigits);
    const error = truth === null ? NaN : result[field] - truth[field];
    const own = [number(`orientation-${field}`, result[field], digits), number(`error-${field}`, errors?.[field], digits)];
    const withInterior = total === null ? [] : [number(`total-error-${field}`, total[field], digits)];
    const interval = number(`interval-${field}`, half?.[field], digits);
    const printed =
      paper === undefined
        ? []
        : [
            number(`paper-${field}`, paper.orientations[2].values[field], printedDigits, 'paper'),
            number(`paper-error-${field}`, paper.standard_errors[field], printedDigits, 'paper'),
          ];
    const compared =
      truth === null
        ? printed
        : [number(`deviation-${field}`, error, digits), number(`deviation-ratio-${field}`, error / ((total ?? errors)?.[field] ?? NaN), 1)];
    return row(h('span', {}, h('i', {}, symbol), h('span', { class: 'unit' }, ` ${unitText(unit)}`)), ...own, ...withInterior, interval, ...compared);
  });
  const heads: [text: string, title: string, kind?: string][] = [
    [say('value'), say('the-right-photo-relative-to')],
    [say('std-error'), say('what-the-scatter-of-the')],
    ...(total === null ? [] : [[say('in-total'), say('standard-error-including-what-does')] satisfies [string, string]]),
    ['95 % ±', say('half-width-of-the-interval')],
    ...(paper !== undefined
      ? ([
          [say('paper-2'), say('the-papers-table-3-of'), 'paper'],
          [say('its-error'), say('the-papers-table-2'), 'paper'],
        ] satisfies [string, string, string][])
      : []),
    ...(truth === null
      ? []
      : ([
          [say('true-error'), say('value-minus-truth-by-and')],
          [say('in-std-errors'), say('the-true-error-divided-by')],
        ] satisfies [string, string][])),
  ];
  const note = paper !== undefined ? h('p', { class: 'note' }, paperNote(state, paper)) : null;
  return h(
    'div',
    {},
    scrolledByKeys(
      h(
        'div',
        { class: 'scroll' },
        h(
          'table',
          { class: 'tight', aria: { label: say('relative-orientation') } },
          h(
            'thead',
            {},
            h(
              'tr',
              {},
              h('th', { scope: 'col' }, say('unknown')),
              ...heads.map(([text, title, kind = '']) => h('th', { scope: 'col', title, class: kind }, text)),
            ),
          ),
          h('tbody', {}, ...rows),
        ),
      ),
    ),
    note,
  );
}

/** Whose pair it was, and with what it was photographed. */
function paperNote({ catalogue }: State, { pixel_mm: pixel }: Paper): string {
  const flight = catalogue?.flights.find(({ name }) => name === 'paper')?.flight;
  return say('paper', { focal_mm: flight?.focal_mm ?? null, base_mm: flight?.base_mm ?? null, pixel_um: 1000 * pixel });
}

function warnings({ warnings: found }: RelativeOrientation): HTMLElement[] {
  return found.map((warning) => h('p', { class: 'field-problem', testid: `warning-${warning.kind}` }, message('warning', warning)));
}

function precision(state: State, result: RelativeOrientation): HTMLElement {
  const interior = interiorInUse(state)?.left;
  const pixel = interior === undefined ? null : pixelMm(interior);
  const sigma = result.sigma0_mm;
  const { all, used } = countsOf(result);
  const test = result.global_test;
  const printed = hasPaperCamera(state) ? state.catalogue?.paper : undefined;
  const list: Fact[] = [
    {
      name: say('of-a-photo-coordinate'),
      testid: 'sigma0',
      value: sigma == null ? '–' : `${withUnit(fixed(1000 * sigma, 2), 'µm')}${pixel === null ? '' : say('px-6', { sigma: sigma / pixel })}`,
      help: say('standard-error-of-one-photo', { sigma_caveat: SIGMA_CAVEAT }),
    },
    {
      name: say('of-a-y-parallax-2'),
      testid: 'sigma-parallax',
      value: sigma == null || pixel === null ? '–' : say('px-3', { value: (Math.SQRT2 * sigma) / pixel }),
      help: say('standard-error-of-the-y'),
    },
    ...(test === null
      ? []
      : [
          {
            name: say('global-test-2'),
            testid: 'global-test',
            value: `${fixed(test.statistic, 1)}: ${test.passed ? say('passed') : say('failed-3')}`,
            ...(test.passed ? {} : { kind: 'problem' as const }),
            help: say('global-test', { lower: test.lower, upper: test.upper }),
          },
        ]),
    { name: say('degrees-of-freedom'), testid: 'degrees-of-freedom', value: count(result.degrees_of_freedom), help: say('matches-used-minus-the-five') },
    {
      name: say('matches-used'),
      testid: 'matches-used',
      value: say('of-7', { used, residuals_mm: all }),
      help: say('data-snooping-rejected-the-others'),
    },
    {
      name: say('condition'),
      testid: 'condition',
      value: significant(result.condition),
      help: say('largest-by-smallest-eigenvalue-of'),
    },
    {
      name: say('misfit-to-a-plane'),
      testid: 'plane-misfit',
      value: result.plane_misfit === null ? '–' : `${significant(result.plane_misfit)} σ₀`,
      help: say('how-far-the-matches-deviate'),
    },
    {
      name: say('parallax-beside-a-rotation'),
      testid: 'rotation-parallax',
      value:
        pixel === null
          ? say('mm-2', { value: significant(result.parallax_beside_rotation_mm) })
          : say('px-7', { value: significant(result.parallax_beside_rotation_mm / pixel) }),
      help: say('median-parallax-that-the-best'),
    },
    {
      name: say('spread'),
      testid: 'spread',
      value: `${fixed(result.spread, 3)} f`,
      help: say('root-mean-square-distance-of-the'),
    },
    {
      name: say('iterations-last-step'),
      testid: 'iterations',
      value: say('of-the-tolerance', { iterations: String(result.iterations), step: significant(result.last_step) }),
      help: say('the-last-step-relative-to'),
    },
    {
      name: say('base-b-principal-distance'),
      testid: 'base',
      value: say('mm-mm', { base_mm: significant(result.base_mm), focal_mm: significant(result.focal_mm) }),
      help: say('the-base-component-that-was'),
    },
    ...(printed !== undefined
      ? [
          {
            name: say('paper-2'),
            testid: 'paper-sigma0',
            value: say('paper-sigma', { sigma0_mm: printed.sigma0_mm, sigma0_px: printed.sigma0_mm / printed.pixel_mm }),
            help: say('what-the-paper-printed-for'),
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
  return h(
    'div',
    { class: 'precision-pictures' },
    correlationPicture(result),
    ellipse === null ? null : ellipsePicture(ellipse, result.base_ellipse_95_mm ?? undefined, deviation),
  );
}
