/** The relative orientation with its precision: the paper's Tables 2 and 3, and the correlations. */
import type { FiveParameters, RelativeOrientation } from '../engine/wasm';
import { isStale, pairCameras, wantedKeys } from '../state/keys';
import { pixelMm } from '../state/residuals';
import { truthOf } from '../state/score';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, row, section } from './dom';
import { count, fixed, significant } from './format';

type Field = keyof FiveParameters;

interface Unknown {
  field: Field;
  symbol: string;
  unit: string;
  digits: number;
  /** Standard error in the paper's Table 2, and the proposed method's value in its Table 3. */
  paperError: number;
  paperValue: number;
}

const UNKNOWNS: readonly Unknown[] = [
  { field: 'omega_deg', symbol: 'ω', unit: '°', digits: 4, paperError: 0.0477, paperValue: 0.9137 },
  { field: 'phi_deg', symbol: 'φ', unit: '°', digits: 4, paperError: 0.0688, paperValue: 0.0187 },
  { field: 'kappa_deg', symbol: 'κ', unit: '°', digits: 4, paperError: 0.0202, paperValue: 0.3708 },
  { field: 'by_mm', symbol: 'by', unit: 'mm', digits: 4, paperError: 0.1373, paperValue: -2.2811 },
  { field: 'bz_mm', symbol: 'bz', unit: 'mm', digits: 4, paperError: 0.0746, paperValue: 0.0605 },
];

export const SIGMA_CAVEAT =
  'σ₀ is computed from y-parallaxes. It sees only the component of an error across the epipolar line, and cannot prove a match right: a wrong match along the line leaves it unchanged.';

export function mountOrientation(host: HTMLElement, store: Store): void {
  const body = h('div', {});
  const panel = section('Relative orientation', 'orientation-section', body);
  host.append(panel);
  store.watch((s) => [s.results, s.settings, s.images, s.failures, s.camera, s.photos, s.offset] as const, () => {
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
  return [valueTable(state, result), precision(state, result), h('p', { class: 'caveat', testid: 'sigma-caveat' }, SIGMA_CAVEAT), correlations(result)];
}

/** Why there is no orientation for what is wanted now; null where there is one, or one to come. */
export function whyNotOriented(state: State): string | null {
  const keys = wantedKeys(state);
  if (state.images.left === null || state.images.right === null) return 'Two images are needed.';
  const cameras = pairCameras(state);
  if (state.results.openLeft !== undefined && state.results.openRight !== undefined && 'missing' in cameras) {
    return `Not oriented: ${cameras.missing}. Give the focal length, and the pixel size or fiducial marks, under “Camera”.`;
  }
  for (const stage of ['interiorLeft', 'interiorRight', 'orientation'] as const) {
    const failure = state.failures[stage];
    if (failure !== undefined && failure.key === keys[stage]) return `Not oriented. ${failure.message}`;
  }
  return null;
}

function valueTable(state: State, result: RelativeOrientation): HTMLElement {
  const truth = truthOf(state)?.orientation ?? null;
  const errors = result.standard_errors;
  const number = (testid: string, value: number | null | undefined, digits: number, kind = '') =>
    h('td', { testid, class: `number ${kind}` }, fixed(value, digits));
  const rows = UNKNOWNS.map(({ field, symbol, unit, digits, paperError, paperValue }) => row(
    h('span', {}, h('i', {}, symbol), h('span', { class: 'unit' }, ` ${unit}`)),
    number(`orientation-${field}`, result[field], digits),
    number(`error-${field}`, errors?.[field], digits),
    ...(truth === null
      ? [number(`paper-${field}`, paperValue, digits, 'paper'), number(`paper-error-${field}`, paperError, digits, 'paper')]
      : [number(`truth-${field}`, truth[field], digits), number(`deviation-${field}`, result[field] - truth[field], digits), number(`paper-error-${field}`, paperError, digits, 'paper')]),
  ));
  const heads = truth === null ? ['Value', 'Std error', 'Paper', 'its error'] : ['Value', 'Std error', 'Truth', 'Deviation', 'Paper’s error'];
  return h('div', { class: 'scroll' }, h('table', { class: 'tight', aria: { label: 'Relative orientation' } },
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Unknown'), ...heads.map((text) => h('th', { scope: 'col', class: text.toLowerCase().includes('paper') || text.startsWith('its') ? 'paper' : '' }, text)))),
    h('tbody', {}, ...rows)), h('p', { class: 'note' }, 'Paper: its Tables 2 and 3, of its own pair (f = 153.38 mm, pixel 254 µm, assumed b = 92 mm).'));
}

function precision(state: State, result: RelativeOrientation): HTMLElement {
  const interior = state.results.interiorLeft?.value.interior;
  const pixel = interior === undefined ? null : pixelMm(interior);
  const sigma = result.sigma0_mm;
  const used = result.residuals_mm.length - result.rejected.length;
  const term = (name: string, testid: string, text: string) => [h('dt', {}, name), h('dd', { testid }, text)];
  return h('dl', { class: 'facts' },
    ...term('σ₀ of a photo coordinate', 'sigma0', sigma == null ? '–' : `${fixed(1000 * sigma, 2)} µm${pixel === null ? '' : ` = ${fixed(sigma / pixel, 3)} px`}`),
    ...term('of a y-parallax (√2 σ₀)', 'sigma-parallax', sigma == null || pixel === null ? '–' : `${fixed((Math.SQRT2 * sigma) / pixel, 3)} px`),
    ...term('Degrees of freedom', 'degrees-of-freedom', count(result.degrees_of_freedom)),
    ...term('Matches used', 'matches-used', `${count(used)} of ${count(result.residuals_mm.length)}`),
    ...term('Iterations', 'iterations', String(result.iterations)),
    ...term('Last step (below 1: converged)', 'last-step', significant(result.last_step)),
    ...term('Base b, principal distance', 'base', `${significant(result.base_mm)} mm, ${significant(result.focal_mm)} mm`),
    ...term('Paper', 'paper-sigma0', 'σ₀ 0.150 mm = 0.6 px'));
}

/** The correlation matrix; cells are shaded by magnitude, in steps that classes can carry. */
function correlations(result: RelativeOrientation): HTMLElement {
  const names = UNKNOWNS.map(({ symbol }) => symbol);
  const cell = (value: number | undefined, i: number, j: number) =>
    h('td', { class: `number shade-${i === j || value === undefined ? '0' : String(Math.min(5, Math.floor(Math.abs(value) * 6)))}`, testid: `correlation-${String(i)}-${String(j)}` }, fixed(value, 2));
  return h('div', {},
    h('h4', {}, 'Correlations'),
    h('table', { class: 'matrix', aria: { label: 'Correlations of the unknowns' } },
      h('thead', {}, h('tr', {}, h('td', {}), ...names.map((name) => h('th', { scope: 'col' }, h('i', {}, name))))),
      h('tbody', {}, ...names.map((name, i) => row(h('i', {}, name), ...names.map((_, j) => cell(result.correlations[i]?.[j], i, j)))))));
}
