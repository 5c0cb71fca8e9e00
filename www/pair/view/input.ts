/** Pointer, wheel, touch and keys on the images. */
import { listen } from '../../shared/view/gestures';
import { otherSide } from '../state/state';
import type { Side } from '../state/state';
import type { Store } from '../state/store';
import type { Navigator } from './navigate';
import { paneAt } from './scene';
import type { View } from './view';

export function mountInput(view: View, store: Store, navigator: Navigator): void {
  const { host } = view;
  const activate = (side: Side) => {
    if (store.state.activeSide !== side) store.dispatch({ type: 'activeSide', side });
  };
  listen<Side>(
    host,
    {
      at: (x, y) => {
        const pane = paneAt(view.scene(), x, y);
        return pane?.picture == null ? null : pane.side;
      },
      focused: () => store.state.activeSide,
      pan: (side, dx, dy) => navigator.pan(side, dx, dy),
      zoom: (side, factor, x, y) => navigator.zoom(side, factor, x, y),
      zoomMiddle: (factor) => navigator.zoomMiddle(factor),
      fit: () => navigator.fit(),
      grabbed: activate,
      pressed: (x, y) => navigator.select(view.hit(x, y)),
      pointed: (at) => view.point(at),
      command: (key) => command(key, store, navigator),
      // The bar of the view belongs to it: after a press there the keys go on.
    },
    host.closest<HTMLElement>('.stage') ?? host,
  );
}

/** Runs the command of a key; false where it has none. */
function command(key: string, store: Store, navigator: Navigator): boolean {
  const { activeSide, display } = store.state;
  switch (key) {
    case '1':
      navigator.actualSize();
      return true;
    case 'n':
    case 'N':
      navigator.step(1);
      return true;
    case 'p':
    case 'P':
      navigator.step(-1);
      return true;
    case 'o':
    case 'O':
      store.dispatch({ type: 'activeSide', side: otherSide(activeSide) });
      return true;
    case 'l':
    case 'L':
      store.dispatch({ type: 'display', display: { linked: !display.linked } });
      return true;
    case 'm':
    case 'M':
      store.dispatch({ type: 'display', display: { magnifier: !display.magnifier } });
      return true;
    case 'Escape':
      navigator.select(null);
      return true;
    default:
      return false;
  }
}
