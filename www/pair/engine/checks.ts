/** What the crate takes of what is typed. The crate itself is asked, so that no range stands here a second time; none of this takes time. */
import { camera_of_focal_px, check_flight, constant_offset, interior, parse_camera } from '../../../pkg/wasm/tiepoint.js';
import type { CameraMm, Flight } from '../../shared/crate';
import { message, messageOf } from '../../shared/text/messages';

/** An option that is refused, as the crate says it. */
interface InvalidOption {
  kind: 'invalid-option';
  field: string;
  allowed: { kind: string };
}

/** What the crate throws; null where it takes what it is given. */
function refusalOf(call: () => unknown): Error | null {
  try {
    call();
    return null;
  } catch (error) {
    if (error instanceof Error && 'code' in error) return error;
    throw error;
  }
}

function optionOf(refusal: Error): InvalidOption | null {
  const error = 'error' in refusal ? (refusal.error as InvalidOption | null) : null;
  return error?.kind === 'invalid-option' ? error : null;
}

/** What is allowed instead, in the crate's words; null where it takes what it is given. */
function allowedInstead(call: () => unknown): string | null {
  const refusal = refusalOf(call);
  if (refusal === null) return null;
  const option = optionOf(refusal);
  return option === null ? messageOf(refusal) : message('allowed', option.allowed);
}

/** What of a camera is allowed; the rest of it is taken for granted. */
export function allowedOfCamera(part: Partial<CameraMm>): string | null {
  return allowedInstead(() => parse_camera(JSON.stringify({ focal_mm: 1, ...part })));
}

/** `camera`: what the focal length in px would make of the camera. */
export function allowedOfFocalPx(px: number, camera: (px: number) => CameraMm): string | null {
  return allowedInstead(() => camera_of_focal_px(px)) ?? allowedOfCamera(camera(px));
}

export function allowedOfOffset(dx: number, dy: number): string | null {
  return allowedInstead(() => constant_offset(dx, dy));
}

/** Three marks that any camera can be oriented by. */
const MARKS = [
  [0, 0],
  [1, 0],
  [0, 1],
].map(([col = 0, row = 0]) => ({ col, row, x_mm: col, y_mm: -row }));

export function allowedOfOrigin(col: number, row: number): string | null {
  return allowedInstead(() => interior({ focal_mm: 1 }, { width: 1, height: 1, fiducials: MARKS, origin: [col, row] }));
}

/** Why a flight cannot be flown, and by which of its parameters; null where it can. */
export function problemOfFlight(flight: Flight): { field: string | null; text: string } | null {
  const refusal = refusalOf(() => check_flight(flight));
  return refusal === null ? null : { field: optionOf(refusal)?.field ?? null, text: messageOf(refusal) };
}
