/** Cameras as blocks calibrated them, remembered by this browser, for photographs that name a camera of the same make, model, focal length and size. */
import { cameraFrom } from './camera';
import type { Camera, CameraMm } from '../crate';
import { keepChoice, keptChoice } from '../choices';

const NAME = 'tiepoint-cameras';
/** The oldest ones make room. */
const MOST = 50;

/** The distortion that a file records; two cameras of one name differ in it where one photo was freed of its distortion. */
export type RecordedLens = Pick<Camera, 'radial' | 'tangential'>;

export interface Calibration {
  /** Make, model, focal length and size. */
  label: string;
  recorded: RecordedLens;
  camera: Camera;
  focalErrorPx: number;
  /** Images of the camera in the block. */
  images: number;
  /** When it was calibrated, in ms since 1970. */
  at: number;
}

/** The latest first; null until they are read. */
let all: readonly Calibration[] | null = null;

/** What cannot be read or used is not there. */
function read(): Calibration[] {
  try {
    const kept: unknown = JSON.parse(keptChoice(NAME) ?? '[]');
    return Array.isArray(kept) ? kept.filter(isCalibration) : [];
  } catch {
    return [];
  }
}

function isCalibration(value: unknown): value is Calibration {
  const kept = (value ?? {}) as Calibration;
  const { label, focalErrorPx, images, at } = kept;
  if (typeof label !== 'string' || ![focalErrorPx, images].every(Number.isFinite) || Number.isNaN(new Date(at).getTime())) return false;
  try {
    cameraOfPair(kept);
    return true;
  } catch {
    return false;
  }
}

function remembered(): readonly Calibration[] {
  all ??= read();
  return all;
}

function keep(kept: readonly Calibration[]): void {
  all = kept.slice(0, MOST);
  keepChoice(NAME, JSON.stringify(all));
}

const lensOf = ({ radial = [0, 0, 0], tangential = [0, 0] }: RecordedLens) => JSON.stringify([radial, tangential]);

export function calibrationOf(label: string, recorded: RecordedLens): Calibration | null {
  return remembered().find((kept) => kept.label === label && lensOf(kept.recorded) === lensOf(recorded)) ?? null;
}

/** The one that a pair's camera was taken from. */
export function calibrationBehind(camera: CameraMm): Calibration | null {
  const text = JSON.stringify(camera);
  return remembered().find((kept) => JSON.stringify(cameraOfPair(kept)) === text) ?? null;
}

/** Each takes the place of the former one of its name. */
export function rememberCalibrations(made: readonly Calibration[]): void {
  if (made.length > 0) keep([...made, ...remembered().filter(({ label }) => !made.some((other) => other.label === label))]);
}

export function forgetCalibration(label: string): void {
  keep(remembered().filter((kept) => kept.label !== label));
}

/** The camera for a pair, as uncertain as if its files recorded the calibration: another day, another specimen of the model. */
export function cameraOfPair({ camera }: Calibration): CameraMm {
  return cameraFrom(camera, 'xmp_calibration');
}
