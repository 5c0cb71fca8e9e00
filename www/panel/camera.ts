/** The camera: typed, loaded, or from EXIF; and the offset between the images. */
import type { Camera, ExifCamera } from '../engine/wasm';
import { pairCameras } from '../state/keys';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { button, fill, h } from './dom';
import { significant } from './format';

interface NumberField {
  element: HTMLElement;
  input: HTMLInputElement;
}

function numberField(label: string, unit: string, testid: string, onChange: () => void): NumberField {
  const id = `c-${testid}`;
  const input = h('input', { id, type: 'number', testid });
  input.step = 'any';
  input.inputMode = 'decimal';
  input.addEventListener('change', onChange);
  const name = h('label', { for: id }, label, unit === '' ? null : h('span', { class: 'unit' }, ` ${unit}`));
  return { input, element: h('div', { class: 'control compact' }, name, input) };
}

/** The number typed; undefined where the field is empty or no number. */
function typed({ input }: NumberField): number | undefined {
  return Number.isFinite(input.valueAsNumber) ? input.valueAsNumber : undefined;
}

export function mountCamera(host: HTMLElement, store: Store, loadFile: () => void): void {
  const change = () => { store.dispatch({ type: 'camera', camera: read() }); };
  const fields = {
    focal: numberField('Focal length', 'mm', 'camera-focal', change),
    pixel: numberField('Pixel size', 'mm', 'camera-pixel', change),
    x0: numberField('Principal pt x', 'mm', 'camera-x0', change),
    y0: numberField('Principal pt y', 'mm', 'camera-y0', change),
    k1: numberField('k1', 'mm⁻²', 'camera-k1', change),
    k2: numberField('k2', 'mm⁻⁴', 'camera-k2', change),
    k3: numberField('k3', 'mm⁻⁶', 'camera-k3', change),
  };
  const read = (): Camera | null => {
    const focal = typed(fields.focal);
    if (focal === undefined) return null;
    const pixel = typed(fields.pixel);
    return {
      focal_mm: focal,
      principal_point_mm: [typed(fields.x0) ?? 0, typed(fields.y0) ?? 0],
      ...(pixel === undefined ? {} : { pixel_mm: pixel }),
      radial_distortion: [typed(fields.k1) ?? 0, typed(fields.k2) ?? 0, typed(fields.k3) ?? 0],
    };
  };
  const source = h('p', { class: 'note', testid: 'camera-source' });
  const load = button('Load camera.json …', 'load-camera', loadFile);
  const clear = button('Clear', 'clear-camera', () => { store.dispatch({ type: 'camera', camera: null }); });
  host.append(h('fieldset', { class: 'group' }, h('legend', {}, 'Camera'), source,
    h('div', { class: 'pairs' }, ...Object.values(fields).map(({ element }) => element)), h('div', { class: 'buttons' }, load, clear)), offsetGroup(store));
  store.watch((s) => [s.camera] as const, ([camera]) => {
    show(fields.focal, camera?.focal_mm);
    show(fields.pixel, camera?.pixel_mm);
    [fields.x0, fields.y0].forEach((field, i) => { show(field, camera?.principal_point_mm?.[i]); });
    [fields.k1, fields.k2, fields.k3].forEach((field, i) => { show(field, camera?.radial_distortion?.[i]); });
    clear.disabled = camera === null;
  });
  store.watch((s) => [s.camera, s.results.openLeft, s.results.openRight, s.photos, s.truth] as const, () => { fill(source, sourceText(store.state)); });
}

/** Shows a number, unless the field already says the same. */
function show({ input }: NumberField, value: number | null | undefined): void {
  if (value == null) input.value = '';
  else if (input.valueAsNumber !== value) input.value = String(value);
}

function exifText(name: string, exif: ExifCamera): string {
  // Many makers repeat their name in the model's.
  const make = exif.make != null && exif.model?.startsWith(exif.make) === true ? null : exif.make;
  const camera = [make, exif.model].filter((part) => part != null).join(' ');
  const pixel = exif.pixel_mm == null ? 'no pixel size' : `pixel ${significant(exif.pixel_mm)} mm`;
  return `EXIF, ${name}: ${camera === '' ? 'camera not named' : camera}, f = ${significant(exif.focal_mm)} mm, ${pixel}.`;
}

function sourceText(state: State): string {
  const exif = ([['left', state.results.openLeft], ['right', state.results.openRight]] as const)
    .map(([name, opened]) => (opened?.value.info.camera == null ? '' : exifText(name, opened.value.info.camera)))
    .filter((text) => text !== '')
    .join(' ');
  const used = pairCameras(state);
  if (state.camera !== null) return `In use: the values below${state.truth === null ? '' : ' (they came with the sample)'}. ${exif}`;
  if (!('missing' in used)) return `In use: EXIF. Values below take its place. ${exif}`;
  return `Without a principal distance, and a pixel size or fiducial marks, matches are not oriented. ${exif}`;
}

/** The offset of the right image: estimated, or given. */
function offsetGroup(store: Store): HTMLElement {
  const change = () => {
    const [x, y] = [typed(dx), typed(dy)];
    store.dispatch({ type: 'offset', offset: x === undefined || y === undefined ? null : [x, y] });
  };
  const dx = numberField('dx', 'px', 'offset-dx', change);
  const dy = numberField('dy', 'px', 'offset-dy', change);
  const found = h('p', { class: 'note', testid: 'offset-found' });
  store.watch((s) => [s.offset] as const, ([offset]) => {
    if (offset !== null) {
      show(dx, offset[0]);
      show(dy, offset[1]);
    }
  });
  store.watch((s) => [s.results.offset, s.offset] as const, ([result, given]) => {
    if (given !== null || result === undefined) {
      fill(found, given !== null ? 'Given. Empty both fields to estimate it.' : 'Right minus left position; empty: estimated by correlation, coarse to fine.');
      return;
    }
    const [mx, my] = result.value.median_px;
    const correlation = result.value.correlation;
    fill(found, `Estimated: median ${significant(mx)}, ${significant(my)} px${correlation == null ? '' : `, correlation ${correlation.toFixed(2)}`}${correlation != null && correlation < 0.5 ? ': low, so the images may not overlap; a given offset may help' : ''}.`);
  });
  return h('fieldset', { class: 'group' }, h('legend', {}, 'Offset of the right image'), found, h('div', { class: 'pairs' }, dx.element, dy.element));
}
