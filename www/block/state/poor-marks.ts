/** Fiducial marks of a scan that fit each other worse than marks are measured. Pure. */
import { orient_fiducials } from '../../../pkg/wasm/tiepoint.js';
import type { Fiducial } from '../../../pkg/wasm/tiepoint.js';

/** Marks on film that has shrunk unevenly stay below this. */
const MOST_SIGMA0_PX = 3;
/** A mark is named where the others fit so much better without it than without any other one. */
const CLEARLY = 2;

interface PoorMarks {
  /** Standard error of one photo coordinate, px of the scan. */
  sigmaPx: number;
  /** The mark that fits worst; null where none stands out. */
  worst: Fiducial | null;
}

/** Null where the marks fit, and where there are too few to tell. */
export function poorMarks(marks: readonly Fiducial[]): PoorMarks | null {
  const { sigma0_mm: sigma, parameters } = orient_fiducials([...marks], 'affine');
  const [[a, b], [d, e]] = parameters;
  const sigmaPx = (sigma ?? 0) / Math.sqrt(Math.abs(a * e - b * d));
  return sigmaPx > MOST_SIGMA0_PX ? { sigmaPx, worst: worstOf(marks) } : null;
}

/** An affine map spreads the error of one mark evenly over four in the corners: by a similarity the others fit without it, and not without another one. */
function worstOf(marks: readonly Fiducial[]): Fiducial | null {
  const without = marks.map((mark) => {
    const others = marks.filter((other) => other !== mark);
    return { mark, sigma: orient_fiducials(others, 'similarity').sigma0_mm ?? 0 };
  });
  const [best, next] = without.sort((one, other) => one.sigma - other.sigma);
  return best !== undefined && next !== undefined && CLEARLY * best.sigma < next.sigma ? best.mark : null;
}
