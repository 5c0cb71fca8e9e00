/** The camera: typed, loaded, or from EXIF; and the offset between the images. */
import { allowedOfCamera, allowedOfFocalPx, allowedOfOffset } from '../engine/checks';
import type { CameraMm, ExifCamera } from '../../shared/crate';
import { calibrationGroup } from './calibration';
import { pairCameras } from '../state/cameras';
import { comparesGradients, isCurrent } from '../state/keys';
import { focalOf } from '../state/focal';
import type { FocalLength } from '../state/focal';
import { cameraForBoth, focalPxOf, withFocalPx, withoutFocalPx } from '../state/given-camera';
import { interiorInUse } from '../state/interior';
import { wholeMarks } from '../state/marks';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { button, fill, h } from '../../shared/panel/dom';
import { significant } from '../../shared/text/format';
import { firstRefused, numberField, problemLine, readNumber, readPair, showNumber } from '../../shared/panel/numberfield';
import type { NumberField } from '../../shared/panel/numberfield';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';
import { declareLack } from '../../shared/panel/lack';

/** The numbers of a camera: where each stands, and a camera of which nothing else is said. */
interface CameraNumber {
  label: string;
  unit: string;
  testid: string;
  of: (camera: CameraMm) => number | null | undefined;
  alone: (value: number) => Partial<CameraMm>;
}

const NUMBERS = [
  { label: say('focal-length'), unit: 'mm', testid: 'camera-focal', of: (c) => c.focal_mm, alone: (v) => ({ focal_mm: v }) },
  { label: say('pixel-size'), unit: 'mm', testid: 'camera-pixel', of: (c) => c.pixel_mm, alone: (v) => ({ pixel_mm: v }) },
  { label: say('principal-pt-x'), unit: 'mm', testid: 'camera-x0', of: (c) => c.principal_point_mm?.[0], alone: (v) => ({ principal_point_mm: [v, 0] }) },
  { label: say('principal-pt-y'), unit: 'mm', testid: 'camera-y0', of: (c) => c.principal_point_mm?.[1], alone: (v) => ({ principal_point_mm: [0, v] }) },
  { label: 'k1', unit: 'mm⁻²', testid: 'camera-k1', of: (c) => c.radial_distortion?.[0], alone: (v) => ({ radial_distortion: [v, 0, 0] }) },
  { label: 'k2', unit: 'mm⁻⁴', testid: 'camera-k2', of: (c) => c.radial_distortion?.[1], alone: (v) => ({ radial_distortion: [0, v, 0] }) },
  { label: 'k3', unit: 'mm⁻⁶', testid: 'camera-k3', of: (c) => c.radial_distortion?.[2], alone: (v) => ({ radial_distortion: [0, 0, v] }) },
  { label: 'p1', unit: 'mm⁻¹', testid: 'camera-p1', of: (c) => c.tangential_distortion?.[0], alone: (v) => ({ tangential_distortion: [v, 0] }) },
  { label: 'p2', unit: 'mm⁻¹', testid: 'camera-p2', of: (c) => c.tangential_distortion?.[1], alone: (v) => ({ tangential_distortion: [0, v] }) },
] as const satisfies readonly CameraNumber[];

/** A camera of its numbers, in the order of `NUMBERS`, as uncertain as the last one; null without a focal length. */
export function cameraOf(numbers: readonly (number | undefined)[], last: CameraMm | null): CameraMm | null {
  const [focal, pixel, x0 = 0, y0 = 0, k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0] = numbers;
  if (focal === undefined) return null;
  const lens = { radial_distortion: [k1, k2, k3] as [number, number, number], tangential_distortion: [p1, p2] as [number, number] };
  const uncertain = last?.uncertainty === undefined ? {} : { uncertainty: last.uncertainty };
  return { focal_mm: focal, principal_point_mm: [x0, y0], ...(pixel === undefined ? {} : { pixel_mm: pixel }), ...lens, ...uncertain };
}

/** The focal length in px: another way to say what stands in mm, with what it changes. */
function focalPxField(store: Store): NumberField & { note: HTMLElement } {
  const label = say('focal-length');
  const change = () => {
    const last = store.state.camera;
    const before = (last === null ? null : focalPxOf(last)) ?? undefined;
    const px = readNumber(field, (value) => allowedOfFocalPx(value, (given) => withFocalPx(last, given)), before);
    if (px !== before) store.dispatch({ type: 'camera', camera: px === undefined ? withoutFocalPx(last) : withFocalPx(last, px) });
    store.dispatch({ type: 'refused', part: 'camera', label: firstRefused([[label, field.input]]) });
  };
  const field = numberField(label, 'px', 'camera-focal-px', change);
  const note = h('p', { class: 'note', id: 'focal-px-note', testid: 'focal-px-note' });
  field.input.setAttribute('aria-describedby', `${field.problem.id} ${note.id}`);
  store.watch(
    (s) => [s.camera, SIDES.some((side) => wholeMarks(s.photos[side]).length > 0)] as const,
    ([camera, areScans]) => {
      showNumber(field, camera === null ? null : focalPxOf(camera));
      // Their photo coordinates are in mm: fiducial marks say how large a pixel is.
      field.input.disabled = areScans;
      note.textContent = say('focal-length-in-px-sets', { what: areScans ? 'scans' : camera !== null && camera.pixel_mm == null ? 'pixel' : 'focal' });
    },
  );
  return { ...field, note };
}

/** Brings the keyboard to where a camera is given: in px a focal length says enough alone, in mm where the photos are scans. */
export function focusFocalLength(host: HTMLElement): void {
  host.querySelector<HTMLInputElement>('[data-testid^="camera-focal"]:enabled')?.focus();
}

/** What takes the camera that the file of one photo names for the other one too: the keyboard goes on in the fields that then show it. */
function sharedCamera(store: Store, fields: readonly NumberField[]): HTMLElement {
  const use = button('', 'camera-for-both', () => {
    const shared = cameraForBoth(store.state);
    if (shared === null) return;
    store.dispatch({ type: 'camera', camera: shared.camera });
    fields.find(({ input }) => !input.disabled)?.input.focus();
  });
  const group = h('div', { class: 'buttons' }, use);
  store.watch(
    (s) => [s.camera, s.photos, s.results.openLeft, s.results.openRight],
    () => {
      const shared = cameraForBoth(store.state);
      group.hidden = shared === null;
      if (shared !== null) use.textContent = say('use-the-camera-for-both', { side: shared.side });
    },
  );
  return group;
}

/** The stages whose results the text about the camera tells. */
const IN_TEXT = ['openLeft', 'openRight', 'interiorLeft', 'interiorRight', 'match', 'orientation'] as const;

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
      last,
    );
    // A field whose value is not taken goes on showing it.
    const same = NUMBERS.every(({ of }) => (camera === null ? null : (of(camera) ?? null)) === (last === null ? null : (of(last) ?? null)));
    if (!same) store.dispatch({ type: 'camera', camera });
    store.dispatch({ type: 'refused', part: 'camera', label: firstRefused(fields.map(({ input }, i) => [NUMBERS[i]?.label ?? '', input])) });
  };
  const fields = NUMBERS.map(({ label, unit, testid }) => numberField(label, unit, testid, change));
  const inPixels = focalPxField(store);
  const source = h('p', { class: 'note', testid: 'camera-source' });
  const load = button(say('load-camera-json'), 'load-camera', loadFile);
  const clear = button(say('clear'), 'clear-camera', () => store.dispatch({ type: 'camera', camera: null }));
  declareLack([clear], () => (store.state.camera === null ? say('no-camera-is-given') : ''));
  host.append(
    h(
      'fieldset',
      { class: 'group' },
      h('legend', {}, say('camera')),
      source,
      calibrationGroup(store),
      sharedCamera(store, [inPixels, ...fields]),
      h('div', { class: 'pairs' }, inPixels.element, ...fields.map(({ element }) => element)),
      inPixels.note,
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
    (s) => [s.camera, s.photos, s.truth, isCurrent(s, 'orientation'), ...IN_TEXT.map((stage) => s.results[stage])],
    () => fill(source, sourceText(store.state)),
  );
}

function exifText(name: string, exif: ExifCamera): string {
  if (exif.origin === 'panorama')
    return (exif.cautions ?? []).map((caution) => say('the-image-is', { name, message: message('camera_caution', caution) })).join(' ');
  // Many makers repeat their name in the model's.
  const make = exif.make != null && exif.model?.startsWith(exif.make) === true ? null : exif.make;
  const camera = [make, exif.model].filter((part) => part != null).join(' ');
  const pixel = exif.pixel_mm == null ? say('no-pixel-size') : say('pixel-mm', { pixel_mm: significant(exif.pixel_mm) });
  const cautions = (exif.cautions ?? []).map((caution) => say('caution', { message: message('camera_caution', caution) })).join('');
  return say('f-mm', {
    message: message('camera_origin', exif.origin ?? 'exif_focal_plane'),
    name,
    what: camera === '' ? say('camera-not-named') : camera,
    focal_mm: significant(exif.focal_mm),
    pixel,
    cautions,
  });
}

/** Which camera is in use, and from where. */
export function sourceText(state: State): string {
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
  const focal = focalOf(state);
  const told = focalText(focal);
  if (state.camera !== null && 'missing' in used) return say('the-focal-length-is-not-used-yet', { exif });
  if (state.camera !== null) return say('in-use-the-values-below', { what: state.truth === null ? '' : say('they-came-with-the-sample'), told, exif });
  if (!('missing' in used)) return say('in-use-the-photos-own', { told, exif });
  if (interiorInUse(state) !== null) return say('no-camera-is-known', { source: focal?.isEstimated === true ? 'estimated' : 'assumed', told, exif });
  return say('orientation-needs-a-focal-length', { exif });
}

/** What is known of a camera that is not known without error. */
function focalText(focal: FocalLength | null): string {
  return focal === null ? '' : say('focal-length-px', { focal: focal.focalPx, error: focal.errorPx });
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
        [say('offset-dx'), dx.input],
        [say('offset-dy'), dy.input],
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
        fill(found, say('matching-by-gradients-searches-the'));
        return;
      }
      if (given !== null || result === undefined) {
        fill(found, given !== null ? say('given-clear-both-fields-to') : say('right-minus-left-position-empty'));
        return;
      }
      const [mx, my] = result.value.median_px;
      const correlation = result.value.correlation;
      fill(
        found,
        say('estimated-median-px', {
          mx: significant(mx),
          my: significant(my),
          what: correlation == null ? '' : say('correlation-2', { correlation }),
          what_2: correlation != null && correlation < 0.5 ? say('low-do-the-images-overlap') : '',
        }),
      );
    },
  );
  return h(
    'fieldset',
    { class: 'group' },
    h('legend', {}, say('offset-of-the-right-image')),
    found,
    h('div', { class: 'pairs' }, dx.element, dy.element),
    problem,
  );
}
