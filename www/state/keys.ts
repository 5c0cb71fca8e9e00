/**
 * What each stage's result depends on, as a key. A result is current where its key equals the wanted one; a stage whose key did not
 * change is not computed again, whatever was changed elsewhere.
 */
import type { Camera, Settings } from '../engine/wasm';
import { truthOf } from './truth';
import { SIDES } from './state';
import type { Side, StageName, State } from './state';

/** The wanted key of each stage; null where an input is missing. */
export type WantedKeys = Record<StageName, string | null>;

const numbers = new Map<string, string>();

/** A short name for a value: equal values get equal names. Keys of keys would otherwise grow with every stage. */
function shortName(parts: readonly unknown[]): string {
  const text = JSON.stringify(parts);
  let name = numbers.get(text);
  if (name === undefined) {
    name = `k${String(numbers.size)}`;
    numbers.set(text, name);
  }
  return name;
}

/** The key of a stage from its inputs; null where one of them is missing. */
function keyOf(kind: string, inputs: readonly (string | null)[], options: unknown = null): string | null {
  return inputs.includes(null) ? null : shortName([kind, inputs, options]);
}

/** The cameras of a pair and where they are known from; or, in words, what is missing. */
export type PairCameras = { left: Camera; right: Camera; from: 'given' | 'exif' } | { missing: string };

/** The camera of both images where one is given, else that of each image's EXIF, as the crate's `match_pair` takes them. */
export function pairCameras(state: State): PairCameras {
  const cameras = SIDES.map((side) => cameraOf(state, side));
  const [left, right] = cameras;
  if (typeof left === 'string') return { missing: left };
  if (typeof right === 'string') return { missing: right };
  if (left === undefined || right === undefined) throw new Error('a pair has two sides');
  return { left, right, from: state.camera === null ? 'exif' : 'given' };
}

function cameraOf(state: State, side: Side): Camera | string {
  const exif = state.results[side === 'left' ? 'openLeft' : 'openRight']?.value.info.camera ?? null;
  const marked = state.photos[side].fiducials.length > 0;
  const camera = state.camera ?? (exif === null ? null : { focal_mm: exif.focal_mm, pixel_mm: exif.pixel_mm });
  if (camera === null) return marked ? 'fiducial marks are given, but no principal distance' : `no camera is given, and the ${side} image’s EXIF names none`;
  if (!marked && camera.pixel_mm == null) return `the ${side} image has neither fiducial marks nor a pixel size`;
  return camera;
}

/** Whether a strategy searches the right image itself, in place of its interest points. */
export function comparesGreyValues({ matching }: Settings): boolean {
  return matching.strategy === 'correlation' || matching.strategy === 'least-squares';
}

function openKey(state: State, side: Side): string | null {
  const image = state.images[side];
  return image === null ? null : keyOf('open', [], image.id);
}

function compute(state: State): WantedKeys {
  const { settings } = state;
  const openLeft = openKey(state, 'left');
  const openRight = openKey(state, 'right');
  const known = settings === null ? null : '';
  const pointsLeft = keyOf('points', [openLeft, known], settings?.points);
  const pointsRight = keyOf('points', [openRight, known], settings?.points);
  const described = settings === null || comparesGreyValues(settings) ? [] : [settings.window, settings.matching.strategy];
  const descriptorsLeft = keyOf('descriptors', [pointsLeft], described);
  const descriptorsRight = keyOf('descriptors', [pointsRight], described);
  const offset = state.offset === null ? keyOf('offset', [openLeft, openRight]) : keyOf('offset', [], state.offset);
  const cameras = pairCameras(state);
  const interior = (side: Side, open: string | null) =>
    'missing' in cameras ? null : keyOf('interior', [open], [cameras[side], cameras.left.focal_mm, state.photos[side], state.fiducialModel]);
  const interiorLeft = interior('left', openLeft);
  const interiorRight = interior('right', openRight);
  // Only matching along epipolar lines needs to know the camera.
  const along = settings?.matching.epipolar === true ? [interiorLeft, interiorRight, settings.orientation] : [];
  const match = keyOf('match', [descriptorsLeft, descriptorsRight, offset], [settings?.matching, along]);
  const truth = truthOf(state);
  return {
    openLeft, openRight, pointsLeft, pointsRight, descriptorsLeft, descriptorsRight, offset, match, interiorLeft, interiorRight,
    orientation: keyOf('orientation', [match, interiorLeft, interiorRight], settings?.orientation),
    score: keyOf('score', [match, truth === null ? null : ''], [truth?.leftId, truth?.rightId]),
    inspection: keyOf('inspection', [match, state.selection === null ? null : ''], [state.selection, settings?.window]),
  };
}

let last: { state: State; keys: WantedKeys } | null = null;

/** The wanted keys of a state; computed once a state. */
export function wantedKeys(state: State): WantedKeys {
  if (last?.state !== state) last = { state, keys: compute(state) };
  return last.keys;
}

/** Whether a stage's result is there and made by the settings that are wanted now. */
export function isCurrent(state: State, stage: StageName): boolean {
  const key = wantedKeys(state)[stage];
  return key !== null && state.results[stage]?.key === key;
}

/** Whether a stage shows a result that other settings made. */
export function isStale(state: State, stage: StageName): boolean {
  return state.results[stage] !== undefined && !isCurrent(state, stage);
}
