/** The camera: typed, loaded, or from EXIF; and the offset between the images. */
import { allowedOfCamera, allowedOfOffset } from '../engine/checks';
import { message } from '../../shared/crate';
import type { CameraMm, ExifCamera } from '../../shared/crate';
import { comparesGradients, pairCameras } from '../state/keys';
import { interiorInUse } from '../state/interior';
import { pixelMm } from '../state/residuals';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { button, fill, h } from '../../shared/panel/dom';
import { fixed, significant } from '../../shared/text/format';
import { firstRefused, numberField, problemLine, readNumber, readPair, showNumber } from '../../shared/panel/numberfield';

/** The numbers of a camera: where each stands, and a camera of which nothing else is said. */
interface CameraNumber {
  label: string;
  unit: string;
  testid: string;
  of: (camera: CameraMm) => number | null | undefined;
  alone: (value: number) => Partial<CameraMm>;
}

const NUMBERS = [
  { label: 'Focal length', unit: 'mm', testid: 'camera-focal', of: (c) => c.focal_mm, alone: (v) => ({ focal_mm: v }) },
  { label: 'Pixel size', unit: 'mm', testid: 'camera-pixel', of: (c) => c.pixel_mm, alone: (v) => ({ pixel_mm: v }) },
  { label: 'Principal pt x', unit: 'mm', testid: 'camera-x0', of: (c) => c.principal_point_mm?.[0], alone: (v) => ({ principal_point_mm: [v, 0] }) },
  { label: 'Principal pt y', unit: 'mm', testid: 'camera-y0', of: (c) => c.principal_point_mm?.[1], alone: (v) => ({ principal_point_mm: [0, v] }) },
  { label: 'k1', unit: 'mm⁻²', testid: 'camera-k1', of: (c) => c.radial_distortion?.[0], alone: (v) => ({ radial_distortion: [v, 0, 0] }) },
  { label: 'k2', unit: 'mm⁻⁴', testid: 'camera-k2', of: (c) => c.radial_distortion?.[1], alone: (v) => ({ radial_distortion: [0, v, 0] }) },
  { label: 'k3', unit: 'mm⁻⁶', testid: 'camera-k3', of: (c) => c.radial_distortion?.[2], alone: (v) => ({ radial_distortion: [0, 0, v] }) },
  { label: 'p1', unit: 'mm⁻¹', testid: 'camera-p1', of: (c) => c.tangential_distortion?.[0], alone: (v) => ({ tangential_distortion: [v, 0] }) },
  { label: 'p2', unit: 'mm⁻¹', testid: 'camera-p2', of: (c) => c.tangential_distortion?.[1], alone: (v) => ({ tangential_distortion: [0, v] }) },
] as const satisfies readonly CameraNumber[];

/** A camera of its numbers, in the order of `NUMBERS`; null without a focal length. */
function cameraOf([focal, pixel, x0 = 0, y0 = 0, k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0]: readonly (number | undefined)[]): CameraMm | null {
  if (focal === undefined) return null;
  const lens = { radial_distortion: [k1, k2, k3] as [number, number, number], tangential_distortion: [p1, p2] as [number, number] };
  return { focal_mm: focal, principal_point_mm: [x0, y0], ...(pixel === undefined ? {} : { pixel_mm: pixel }), ...lens };
}

export function mountCamera(host: HTMLElement, store: Store, loadFile: () => void): void {
  const change = () => {
    const last = store.state.camera;
    const camera = cameraOf(
      fields.map((field, i) => {
        const number = NUMBERS[i];
        return number === undefined
          ? undefined
          : readNumber(field, (value) => allowedOfCamera(number.alone(value)), (last === null ? null : number.of(last)) ?? undefined);
      }),
    );
    // A field whose value is not taken goes on showing it.
    const same = NUMBERS.every(({ of }) => (camera === null ? null : (of(camera) ?? null)) === (last === null ? null : (of(last) ?? null)));
    if (!same) store.dispatch({ type: 'camera', camera });
    store.dispatch({ type: 'refused', part: 'camera', label: firstRefused(fields.map(({ input }, i) => [NUMBERS[i]?.label ?? '', input])) });
  };
  const fields = NUMBERS.map(({ label, unit, testid }) => numberField(label, unit, testid, change));
  const source = h('p', { class: 'note', testid: 'camera-source' });
  const load = button('Load camera.json …', 'load-camera', loadFile);
  const clear = button('Clear', 'clear-camera', () => store.dispatch({ type: 'camera', camera: null }));
  host.append(
    h(
      'fieldset',
      { class: 'group' },
      h('legend', {}, 'Camera'),
      source,
      h('div', { class: 'pairs' }, ...fields.map(({ element }) => element)),
      h('div', { class: 'buttons' }, load, clear),
    ),
    offsetGroup(store),
  );
  store.watch(['camera'], ([camera]) => {
    fields.forEach((field, i) => {
      showNumber(field, camera === null ? null : NUMBERS[i]?.of(camera));
    });
    clear.disabled = camera === null;
  });
  store.watch(
    (s) => [s.camera, s.results.openLeft, s.results.openRight, s.results.match, s.photos, s.truth] as const,
    () => fill(source, sourceText(store.state)),
  );
}

function exifText(name: string, exif: ExifCamera): string {
  if (exif.origin === 'panorama') return (exif.cautions ?? []).map((caution) => `The ${name} image is ${message('camera_caution', caution)}.`).join(' ');
  // Many makers repeat their name in the model's.
  const make = exif.make != null && exif.model?.startsWith(exif.make) === true ? null : exif.make;
  const camera = [make, exif.model].filter((part) => part != null).join(' ');
  const pixel = exif.pixel_mm == null ? 'no pixel size' : `pixel ${significant(exif.pixel_mm)} mm`;
  const cautions = (exif.cautions ?? []).map((caution) => ` Caution: ${message('camera_caution', caution)}.`).join('');
  return `${message('camera_origin', exif.origin ?? 'exif_focal_plane')}, ${name}: ${camera === '' ? 'camera not named' : camera}, f = ${significant(exif.focal_mm)} mm, ${pixel}.${cautions}`;
}

function sourceText(state: State): string {
  const exif = (
    [
      ['left', state.results.openLeft],
      ['right', state.results.openRight],
    ] as const
  )
    .map(([name, opened]) => (opened?.value.info.camera == null ? '' : exifText(name, opened.value.info.camera)))
    .filter((text) => text !== '')
    .join(' ');
  const used = pairCameras(state);
  const told = estimatedText(state);
  if (state.camera !== null) return `In use: the values below${state.truth === null ? '' : ' (they came with the sample)'}. ${exif}`;
  if (!('missing' in used)) return `In use: the photos' own camera${told}. Values below replace it. ${exif}`;
  if (used.missing.kind !== 'panorama' && state.results.match?.value.estimated != null) {
    return `No camera is known: that of most photographs is assumed${told}. Values below replace it. ${exif}`;
  }
  return `Orientation needs a focal length, and a pixel size or fiducial marks. With matches of gradients it does without. ${exif}`;
}

/** What is known of a camera that nobody calibrated. */
function estimatedText(state: State): string {
  const camera = state.results.orientation?.value.cameras?.[0];
  const interior = interiorInUse(state)?.left;
  if (camera == null || interior === undefined) return '';
  const [focal, error] = [camera.focal_mm, camera.focal_standard_error_mm].map((v) => v / pixelMm(interior));
  return `, focal length ${fixed(focal ?? NaN, 0)} ± ${fixed(error ?? NaN, 0)} px`;
}

/** The offset of the right image: estimated, or given. */
function offsetGroup(store: Store): HTMLElement {
  const change = () => {
    const offset = readPair([dx.input, dy.input], problem, allowedOfOffset);
    if (offset !== undefined) store.dispatch({ type: 'offset', offset });
    store.dispatch({
      type: 'refused',
      part: 'offset',
      label: firstRefused([
        ['Offset dx', dx.input],
        ['Offset dy', dy.input],
      ]),
    });
  };
  const problem = problemLine('offset');
  const dx = numberField('dx', 'px', 'offset-dx', change, problem);
  const dy = numberField('dy', 'px', 'offset-dy', change, problem);
  const found = h('p', { class: 'note', testid: 'offset-found' });
  store.watch(['offset'], ([offset]) => {
    showNumber(dx, offset?.[0]);
    showNumber(dy, offset?.[1]);
  });
  store.watch(
    (s) => [s.results.offset, s.offset, s.settings] as const,
    ([result, given, settings]) => {
      if (settings !== null && comparesGradients(settings)) {
        fill(found, 'Matching by gradients searches the whole right image: it needs no offset.');
        return;
      }
      if (given !== null || result === undefined) {
        fill(
          found,
          given !== null ? 'Given. Clear both fields to estimate it.' : 'Right minus left position. Empty: estimated by correlation, coarse to fine.',
        );
        return;
      }
      const [mx, my] = result.value.median_px;
      const correlation = result.value.correlation;
      fill(
        found,
        `Estimated: median ${significant(mx)}, ${significant(my)} px${correlation == null ? '' : `, correlation ${correlation.toFixed(2)}`}${correlation != null && correlation < 0.5 ? ': low. Do the images overlap? A given offset may help' : ''}.`,
      );
    },
  );
  return h('fieldset', { class: 'group' }, h('legend', {}, 'Offset of the right image'), found, h('div', { class: 'pairs' }, dx.element, dy.element), problem);
}
