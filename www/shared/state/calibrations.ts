/** Cameras as blocks calibrated them, remembered by this browser: a photograph by the same camera has a known one from then on. */
import type { Camera } from '../../../pkg/wasm/tiepoint.js';
import { keepChoice, keptChoice } from '../choices';

const NAME = 'tiepoint-cameras';
/** The oldest ones make room. */
const MOST = 50;

export interface Calibration {
  /** Make, model, focal length and size: photographs of one label are of one camera. */
  label: string;
  camera: Camera;
  focalErrorPx: number;
  /** Images of the block. */
  images: number;
  /** When it was calibrated, in ms since 1970. */
  at: number;
}

/** The latest first. What cannot be read is not there. */
function remembered(): Calibration[] {
  try {
    const kept: unknown = JSON.parse(keptChoice(NAME) ?? '[]');
    return Array.isArray(kept) ? kept.filter(isCalibration) : [];
  } catch {
    return [];
  }
}

function isCalibration(value: unknown): value is Calibration {
  const { label, camera, focalErrorPx, images, at } = (value ?? {}) as Partial<Calibration>;
  return typeof label === 'string' && [camera?.focal_px, focalErrorPx, images, at].every(Number.isFinite);
}

const write = (kept: readonly Calibration[]) => keepChoice(NAME, JSON.stringify(kept.slice(0, MOST)));

export function calibrationOf(label: string): Calibration | null {
  return remembered().find((kept) => kept.label === label) ?? null;
}

/** Each takes the place of the former one of its camera. */
export function rememberCalibrations(made: readonly Calibration[]): void {
  if (made.length > 0) write([...made, ...remembered().filter(({ label }) => !made.some((other) => other.label === label))]);
}

export function forgetCalibration(label: string): void {
  write(remembered().filter((kept) => kept.label !== label));
}
