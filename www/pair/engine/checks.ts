/** What the crate takes of what is typed. The crate itself is asked, so that no range stands here a second time; none of this takes time. */
import { check_flight, constant_offset, interior, parse_camera } from '../../../pkg/wasm/tiepoint.js';
import type { CameraMm, Flight } from '../../shared/crate';
import { refusalText } from '../../shared/text/allowed';

/** The message of the crate's refusal; null where it takes what it is given. */
function refusalOf(call: () => unknown): string | null {
  try {
    call();
    return null;
  } catch (error) {
    if (error instanceof Error && 'code' in error) return refusalText(error);
    throw error;
  }
}

/** What is allowed instead, in the crate's words; null where it takes what it is given. */
function allowedInstead(call: () => unknown): string | null {
  const message = refusalOf(call);
  return message === null ? null : message.replace(/^.*(?:; allowed|؛ المسموح): /u, '');
}

/** What of a camera is allowed; the rest of it is taken for granted. */
export function allowedOfCamera(part: Partial<CameraMm>): string | null {
  return allowedInstead(() => parse_camera(JSON.stringify({ focal_mm: 1, ...part })));
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

/** Why a flight cannot be flown; null where it can. */
export function problemOfFlight(flight: Flight): string | null {
  return refusalOf(() => check_flight(flight));
}
