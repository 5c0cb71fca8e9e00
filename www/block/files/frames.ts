/** Scans of film in place of which a block takes their frames: images of one ideal camera, with what belongs to the scans. */
import {
  film_cameras,
  film_measurements,
  film_pattern,
  image_measurement_table,
  masks_of_images,
  parse_camera_rules,
  parse_image_measurements,
} from '../../../pkg/wasm/tiepoint.js';
import type { CameraRule, FrameOfScan, ImageMeasurementRow } from '../../../pkg/wasm/tiepoint.js';
import type { Here } from '../../shared/files/leaving';
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { MadeFrame } from '../engine/frames';
import type { PlacingEngine } from '../engine/placing';
import type { TextFile } from '../state/file';
import { filmOf, frameName, framesOf, isOfFrames, NO_FILM, stemOf } from '../state/film';
import { marksFarOff } from '../state/scan-marks';
import { marksByHand, withMeasurements } from '../state/marks';
import type { BlockFile, BlockOptions } from '../state/state';
import { newId } from './ids';

/** So many measurements are named in a message. */
const LISTED = 3;

/** Puts frames in the place of all images that have fiducial marks, with their masks and their camera. */
export async function takeFrames(store: BlockStore, engine: PlacingEngine, here: Here): Promise<void> {
  const { files, placing, options } = store.state;
  const scans = framesOf(placing.film, files);
  const stems = scans.map(({ name }) => stemOf(name));
  const twice = scans.find(({ name }, k) => stems.indexOf(stemOf(name)) !== k);
  if (twice !== undefined) {
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('two-scans-of-one-name', { name: twice.name }) } });
    return;
  }
  try {
    const masks = masksOf(scans, options.masks);
    const films = scans.flatMap((file, k) => {
      const film = filmOf(placing.film, file.name);
      return film === null ? [] : [{ file, film, mask: masks[k] ?? null }];
    });
    const frames = await engine.frames(films, camerasThere(files, options.cameras));
    here();
    if (frames === null) store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('cancelled-nothing-was-changed') } });
    else replace(store, frames);
  } catch (error) {
    here();
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('no-frames-were-made', { sentence: sentence(messageOf(error)) }) } });
  }
}

/** The mask of each scan. */
function masksOf(scans: readonly BlockFile[], masks: readonly BlockFile[]): (BlockFile | undefined)[] {
  const names = (files: readonly BlockFile[]) => files.map(({ name }) => name);
  return [...masks_of_images(names(scans), names(masks))].map((index) => masks[index]);
}

/** One step, which is undone and done again. What was given meanwhile stays. */
function replace(store: BlockStore, frames: readonly MadeFrame[]): void {
  const { files, options, marks, placing, history } = store.state;
  const made = new Map(frames.map((frame) => [frame.of, frame]));
  const scans = files.filter(({ id }) => made.has(id));
  const { pattern, file: cameras } = camerasOf(frames, files, options.cameras);
  const names = new Set(files.filter(({ id }) => !made.has(id)).map(({ name }) => name.toLowerCase()));
  const taken = scans.map(({ name }) => frameName(name, pattern)).find((name) => names.has(name.toLowerCase()));
  if (taken !== undefined) {
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('frame-is-there', { name: taken }) } });
    return;
  }
  const ownMasks = frames.map(({ of, mask }) => imageOf(files, of, mask, pattern));
  // Those of the scans are in the masks of their frames.
  const former = new Set([...masksOf(scans, options.masks), ...options.masks.filter(({ name }) => ownMasks.some((own) => own.name === name))]);
  const images = scans.flatMap(({ id }) => {
    const frame = made.get(id);
    return frame === undefined ? [] : [imageOf(files, id, frame.image, pattern)];
  });
  const measured = new Carried(
    scans.flatMap(({ id, name }) => {
      const frame = made.get(id);
      return frame === undefined ? [] : [{ scan: name, image: frameName(name, pattern), film: frame.scan }];
    }),
  );
  const ofFile = measured.table(options.marks);
  const steps = marks.edits.slice(0, marks.done);
  const masks = [...options.masks.filter((mask) => !former.has(mask)), ...ownMasks];
  store.dispatch({
    type: 'mark',
    step: {
      kind: 'make_frames',
      scans: { images: scans, masks: options.masks, cameras: options.cameras, marks: options.marks, film: placing.film, steps },
      frames: { images, masks, cameras, marks: ofFile, film: NO_FILM, steps: withMeasurements(steps, (rows) => measured.rows(rows)) },
      after: history.done,
    },
  });
  // Measurements that were replaced go along, too; told is what holds.
  measured.count(marksByHand(marks));
  const far = marksFarOff(placing.film.marks, files);
  const isKnown = frames.every(({ camera }) => camera.fixed);
  const text = say('scans-became-frames', { frames: frames.length, known: isKnown ? 'yes' : 'no' });
  store.dispatch({ type: 'notice', notice: { kind: 'info', text: [text, far, ...measured.said()].filter((said) => said !== '').join(' ') } });
}

/** Image measurements that are carried from scans to their frames. */
class Carried {
  private moved = 0;
  private readonly beside = new Set<string>();

  constructor(private readonly frames: FrameOfScan[]) {}

  rows(rows: readonly ImageMeasurementRow[]): ImageMeasurementRow[] {
    return film_measurements([...rows], this.frames).measurements;
  }

  /** Counts what becomes of these. */
  count(rows: readonly ImageMeasurementRow[]): void {
    const { moved, beside } = film_measurements([...rows], this.frames);
    this.moved += moved;
    for (const { image, point } of beside) this.beside.add(say('in', { point, image }));
  }

  /** Those of a file; one that cannot be read, or has none of a scan, stays as it is. */
  table(file: TextFile | null): TextFile | null {
    if (file === null) return null;
    const scans = new Set(this.frames.map(({ scan }) => scan));
    let rows: ImageMeasurementRow[];
    try {
      rows = parse_image_measurements(file.text, [...scans]);
    } catch {
      return file;
    }
    if (!rows.some(({ image }) => scans.has(image))) return file;
    this.count(rows);
    return { name: file.name, text: image_measurement_table(this.rows(rows)) };
  }

  /** What became of them; nothing where there were none. */
  said(): string[] {
    const names = [...this.beside];
    const listed = names.slice(0, LISTED).join(', ') + (names.length > LISTED ? ' …' : '');
    return [
      ...(this.moved > 0 ? [say('measurements-carried', { moved: this.moved })] : []),
      ...(names.length > 0 ? [say('measurements-beside-frames', { count: names.length, listed })] : []),
    ];
  }
}

function imageOf(files: readonly BlockFile[], scan: number, png: Blob, pattern: string): BlockFile {
  const name = frameName(nameOf(files, scan), pattern);
  return { id: newId(), name, file: new File([png], name, { type: png.type }) };
}

function nameOf(files: readonly BlockFile[], scan: number): string {
  return files.find(({ id }) => id === scan)?.name ?? '';
}

/** The cameras that were given; those of frames of a film of which no image is left are gone. */
function camerasThere(files: readonly BlockFile[], given: BlockOptions['cameras']): CameraRule[] {
  const rules: readonly CameraRule[] = given === null ? [] : parse_camera_rules(given.text);
  return rules.filter(({ images = '*' }) => !isOfFrames(images) || files.some(({ name }) => name.endsWith(images.slice(1))));
}

/** The camera of the frames beside those that were given, and the pattern of their names. Frames of one film have one. */
function camerasOf(
  frames: readonly MadeFrame[],
  files: readonly BlockFile[],
  given: BlockOptions['cameras'],
): { pattern: string; file: { name: string; text: string } } {
  const others = camerasThere(files, given);
  const [first] = frames;
  // Without a frame nothing has a name by it.
  const pattern = first === undefined ? '' : film_pattern(first.camera, others);
  const own = frames.map(({ camera, of }) => ({ ...camera, images: frameName(nameOf(files, of), pattern) }));
  return { pattern, file: { name: say('camera-of-frames'), text: JSON.stringify({ cameras: film_cameras(pattern, own, others) }) } };
}
