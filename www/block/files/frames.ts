/** Scans of film in place of which a block takes their frames: images of one ideal camera. */
import { parse_camera_rules } from '../../../pkg/wasm/tiepoint.js';
import type { CameraRule } from '../../../pkg/wasm/tiepoint.js';
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { MadeFrame } from '../engine/frames';
import type { PlacingEngine } from '../engine/placing';
import { filmOf, FRAMES, frameName, framesOf, NO_FILM, stemOf } from '../state/film';
import type { BlockFile, BlockOptions } from '../state/state';
import { newId } from './ids';

/** Puts frames in the place of all images that have fiducial marks, with their masks and their camera. */
export async function takeFrames(store: BlockStore, engine: PlacingEngine): Promise<void> {
  const { files, placing } = store.state;
  const scans = framesOf(placing.film, files);
  const stems = scans.map(({ name }) => stemOf(name));
  const twice = scans.find(({ name }, k) => stems.indexOf(stemOf(name)) !== k);
  if (twice !== undefined) {
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('two-scans-of-one-name', { name: twice.name }) } });
    return;
  }
  try {
    const films = scans.flatMap((file) => {
      const film = filmOf(placing.film, file.name);
      return film === null ? [] : [{ file, film }];
    });
    const frames = await engine.frames(films);
    if (frames === null) store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('cancelled-nothing-was-changed') } });
    else replace(store, frames);
  } catch (error) {
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('no-frames-were-made', { sentence: sentence(messageOf(error)) }) } });
  }
}

/** What was given meanwhile stays. */
function replace(store: BlockStore, frames: readonly MadeFrame[]): void {
  const { files, truth, options } = store.state;
  const made = new Map(frames.map((frame) => [frame.of, frame]));
  const cameras = camerasOf(frames, options.cameras);
  const ownMasks = frames.map(({ of, mask }) => imageOf(files, of, mask));
  const masks = [...options.masks.filter(({ name }) => !ownMasks.some((own) => own.name === name)), ...ownMasks];
  const images = files.map((file) => {
    const frame = made.get(file.id);
    return frame === undefined ? file : imageOf(files, file.id, frame.image);
  });
  store.dispatch({ type: 'files', files: images, truth });
  store.dispatch({ type: 'options', options: { masks, cameras } });
  store.dispatch({ type: 'film', film: NO_FILM });
  const isKnown = frames.every(({ camera }) => camera.fixed);
  const text = say('scans-became-frames', { frames: frames.length, known: isKnown ? 'yes' : 'no' });
  store.dispatch({ type: 'notice', notice: { kind: 'info', text } });
}

function imageOf(files: readonly BlockFile[], scan: number, png: Blob): BlockFile {
  const name = frameName(files.find(({ id }) => id === scan)?.name ?? '');
  return { id: newId(), name, file: new File([png], name, { type: png.type }) };
}

/** The camera of the frames, before those that were given for other images. Frames of one film have one. */
function camerasOf(frames: readonly MadeFrame[], given: BlockOptions['cameras']): { name: string; text: string } {
  const others: readonly CameraRule[] = given === null ? [] : parse_camera_rules(given.text);
  const own = [...new Map(frames.map(({ camera }) => [JSON.stringify(camera), camera])).values()];
  return { name: say('camera-of-frames'), text: JSON.stringify({ cameras: [...own, ...others.filter(({ images }) => images !== FRAMES)] }) };
}
