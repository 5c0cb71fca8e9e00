/** Whether a place lies on an image. */
import type { Position } from '../../shared/state/pane';
import type { Side, State } from './state';

/** The size of an image, px; null while it is not open. */
export function sizeOf({ results }: Pick<State, 'results'>, side: Side): { width: number; height: number } | null {
  return results[side === 'left' ? 'openLeft' : 'openRight']?.value.info ?? null;
}

/** Its border belongs to it. */
export function isOnImage(state: Pick<State, 'results'>, side: Side, [x, y]: Position): boolean {
  const size = sizeOf(state, side);
  return size === null || (x >= 0 && y >= 0 && x <= size.width && y <= size.height);
}
