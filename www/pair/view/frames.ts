/** Scales and directions of points: a circle of twice the scale, a tick in the direction; only where they are few enough to be read. */
import { isCodeShown } from '../state/display';
import type { Shown } from '../state/display';
import { CELLS } from '../state/descriptor';
import { comparesGradients } from '../state/keys';
import type { Settings } from '../../shared/crate';
import type { State } from '../state/state';
import type { Rect, Transform } from '../../shared/view/transform';
import { toCanvas } from '../../shared/view/transform';
import { SELECTED } from '../../shared/view/palette';
import { STYLES } from './palette';
import type { Pane } from './scene';

/** Radius of the circle in scales. */
const SCALES = 2;
/** Least radius in CSS px at which a circle is drawn, and how many are: where more are in sight, zooming in shows them. */
const LEAST_RADIUS = 6;
const MOST_DRAWN = 250;
/** CSS px of an image px from which on frames of matches are drawn, where these alone are shown. */
const LEAST_SCALE = 1;

/** Whether the directions of the frames were sought. */
function haveDirections(settings: Settings | null): boolean {
  return settings !== null && comparesGradients(settings) && !settings.gradient.upright;
}

/** Draws the frames of the shown points that `clip` shows. */
export function drawFrames(context: CanvasRenderingContext2D, state: State, shown: Shown, pane: Pane, transform: Transform, clip: Rect): void {
  const { points, frames, codes } = pane;
  if (points === null || frames === null || frames.length === 0 || state.display.points === 'none') return;
  // Over whole images matches alone are to be seen.
  if (state.display.points === 'matched' && transform.scale < LEAST_SCALE) return;
  const ticks = haveDirections(state.settings);
  const paths = new Map<number, Path2D>();
  let drawn = 0;
  codes.forEach((code, i) => {
    const radius = SCALES * (frames[2 * i] ?? 0) * transform.scale;
    if (drawn > MOST_DRAWN || radius < LEAST_RADIUS || !isCodeShown(shown, code)) return;
    const [x, y] = toCanvas(transform, points[3 * i] ?? 0, points[3 * i + 1] ?? 0);
    if (x + radius < clip.left || x - radius > clip.left + clip.width || y + radius < clip.top || y - radius > clip.top + clip.height) return;
    drawn += 1;
    const path = paths.get(code) ?? new Path2D();
    paths.set(code, path);
    addFrame(path, [x, y], radius, ticks ? (frames[2 * i + 1] ?? 0) : null);
  });
  if (drawn > MOST_DRAWN) return;
  context.lineWidth = 1;
  for (const [code, path] of paths) {
    context.strokeStyle = STYLES[code]?.colour ?? '#ffffff';
    context.stroke(path);
  }
}

function addFrame(path: Path2D, [x, y]: [number, number], radius: number, direction: number | null): void {
  path.moveTo(x + radius, y);
  path.arc(x, y, radius, 0, 2 * Math.PI);
  if (direction === null) return;
  path.moveTo(x, y);
  path.lineTo(x + radius * Math.cos(direction), y + radius * Math.sin(direction));
}

/** Draws what the gradient descriptor of a point describes: its cells' outline, turned and scaled, with the direction. */
export function drawSupport(context: CanvasRenderingContext2D, settings: Settings, { points, frames, transform }: Pane, index: number): void {
  if (index < 0) return;
  const [x, y] = points?.subarray(3 * index, 3 * index + 2) ?? [];
  const [scale, direction = 0] = frames?.subarray(2 * index, 2 * index + 2) ?? [];
  if (x === undefined || y === undefined || scale === undefined) return;
  const half = 0.5 * CELLS * settings.gradient.cell * scale * transform.scale;
  context.save();
  context.translate(...toCanvas(transform, x, y));
  context.rotate(direction);
  context.lineWidth = 1.5;
  context.strokeStyle = SELECTED;
  context.strokeRect(-half, -half, 2 * half, 2 * half);
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(half, 0);
  context.stroke();
  context.restore();
}
