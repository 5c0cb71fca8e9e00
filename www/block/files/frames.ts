/** Scans of film in place of which a block takes their frames: images of one ideal camera. */
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { MadeFrame, PlacingEngine } from '../engine/placing';
import { filmOf, framesOf, NO_FILM, stemOf } from '../state/film';
import type { BlockFile } from '../state/state';
import { newId } from './ids';

/** Puts frames in the place of all images that have fiducial marks, with their masks and their camera. */
export async function takeFrames(store: BlockStore, engine: PlacingEngine): Promise<void> {
  const { files, truth, placing } = store.state;
  const scans = framesOf(placing.film, files);
  try {
    const frames = await engine.frames(scans.map((file) => ({ file, film: filmOf(placing.film, file.name) })));
    if (frames === null) {
      store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('cancelled-nothing-was-changed') } });
      return;
    }
    const made = new Map(frames.map((frame) => [frame.of, frame]));
    const { options } = store.state;
    const stems = new Set(scans.map(({ name }) => stemOf(name)));
    const masks = [...options.masks.filter(({ name }) => !stems.has(stemOf(name))), ...frames.map(({ name, mask }) => imageOf(name, mask))];
    store.dispatch({ type: 'files', files: files.map((file) => frameOf(file, made)), truth });
    store.dispatch({ type: 'options', options: { masks, cameras: camerasOf(frames, scans.length === files.length, options.cameras?.text ?? null) } });
    store.dispatch({ type: 'film', film: NO_FILM });
    store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('scans-became-frames', { frames: frames.length }) } });
  } catch (error) {
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('no-frames-were-made', { sentence: sentence(messageOf(error)) }) } });
  }
}

function frameOf(file: BlockFile, made: ReadonlyMap<number, MadeFrame>): BlockFile {
  const frame = made.get(file.id);
  return frame === undefined ? file : imageOf(frame.name, frame.image);
}

function imageOf(name: string, bytes: Uint8Array<ArrayBuffer>): BlockFile {
  return { id: newId(), name, file: new File([bytes], name, { type: 'image/png' }) };
}

/** The camera of the frames, before those that were given for other images. Frames of one film have one. */
function camerasOf(frames: readonly MadeFrame[], areAll: boolean, given: string | null): { name: string; text: string } {
  const [first] = frames;
  const like = ({ camera: { images: _, ...others } }: MadeFrame) => JSON.stringify(others);
  const isOne = first !== undefined && frames.every((frame) => like(frame) === like(first));
  const own = areAll && isOne ? [{ ...first.camera, images: '*' }] : frames.map(({ camera }) => camera);
  const others = given === null || areAll ? [] : (JSON.parse(given) as { cameras: object[] }).cameras;
  return { name: say('camera-of-frames'), text: JSON.stringify({ cameras: [...own, ...others] }) };
}
