/** Takes what is dropped over the pair. */
import type { Taker } from '../../shared/files/drop';
import { contains } from '../../shared/view/transform';
import { SIDES } from '../state/state';
import type { Store } from '../state/store';
import { panesOf } from '../view/geometry';
import type { View } from '../view/view';
import type { Files } from './open';

/** Takes what is dropped on the page while no other part does; a single image goes to the pane that it is dropped on. */
export function takerOf(store: Store, view: View, files: Files): Taker {
  const sideAt = (event: DragEvent) => {
    const box = view.host.getBoundingClientRect();
    const panes = panesOf(store.state, box.width, box.height);
    return SIDES.find((side) => contains(panes[side], event.clientX - box.left, event.clientY - box.top));
  };
  return {
    isActive: () => true,
    markAt: (event) => sideAt(event) ?? 'page',
    take: (found, at) => void files.give(found, SIDES.find((side) => side === at) ?? null, true),
  };
}
