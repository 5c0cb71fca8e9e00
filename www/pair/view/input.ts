/** Pointer, wheel, touch and keys on the images. */
import { isCodeShown } from '../state/display';
import { listen } from '../../shared/view/gestures';
import { toPosition } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { keysWithin } from '../state/choice';
import { editedPair } from '../state/edited';
import type { Editing } from '../state/editing';
import { otherSide } from '../state/state';
import type { Selection, Side } from '../state/state';
import type { Store } from '../state/store';
import type { Navigator } from './navigate';
import { paneAt } from './scene';
import type { View } from './view';

export function mountInput(view: View, store: Store, navigator: Navigator, editing: Editing): void {
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
      pressed: (x, y, more) => {
        if (store.state.tool === 'measure') measure(view, x, y, editing, navigator);
        else press(view.hit(x, y), more, editing, navigator);
      },
      encloses: (shift) => shift || store.state.tool === 'choose',
      enclosed: (side, from, to, ended) => enclose(view, store, side, from, to, ended),
      pointed: (at) => view.point(at),
      command: (key, shift) => (store.state.tool === 'measure' && measuring(key, shift, store, navigator, editing)) || command(key, store, navigator, editing),
      // The bar of the view belongs to it: after a press there the keys go on.
    },
    host.closest<HTMLElement>('.stage') ?? host,
  );
}

/** Selects a point; with `more` its match is chosen beside the others, or no longer. */
function press(hit: Selection | null, more: boolean, editing: Editing, navigator: Navigator): void {
  if (more) {
    editing.choose(hit);
    return;
  }
  editing.chooseNone();
  navigator.select(hit);
}

/** Chooses the matches in a rectangle of the canvas. */
function enclose(view: View, store: Store, side: Side, from: [number, number], to: [number, number] | null, ended: boolean): void {
  const rect = to === null ? null : between(from, to);
  view.enclose(ended ? null : rect);
  const edited = editedPair(store.state);
  if (!ended || rect === null || edited === null) return;
  const { transform, codes } = view.scene().panes[side];
  const [left, top] = toPosition(transform, rect.left, rect.top);
  const [right, bottom] = toPosition(transform, rect.left + rect.width, rect.top + rect.height);
  const { display } = store.state;
  const ofLefts = side === 'left' ? codes : view.scene().panes.left.codes;
  store.dispatch({ type: 'choose', chosen: keysWithin(edited, side, [left, top, right, bottom], (index) => isCodeShown(display, ofLefts[index] ?? 0)) });
}

function between([x, y]: [number, number], [u, v]: [number, number]): Rect {
  return { left: Math.min(x, u), top: Math.min(y, v), width: Math.abs(u - x), height: Math.abs(v - y) };
}

/** Places a point of the match that is measured. */
function measure(view: View, x: number, y: number, editing: Editing, navigator: Navigator): void {
  const pane = paneAt(view.scene(), x, y);
  if (pane?.picture == null) return;
  editing.place(pane.side, toPosition(pane.transform, x, y));
  navigator.followDraft();
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** How far an arrow moves a point, px; with Shift. */
const FINE = 0.1;
const COARSE = 1;

/** Runs the command of a key while a match is measured; false where it has none then. */
function measuring(key: string, shift: boolean, store: Store, navigator: Navigator, editing: Editing): boolean {
  const { draft } = store.state;
  if (draft === null) {
    const middle = key === 'Enter' ? navigator.middle() : null;
    if (middle === null) return false;
    editing.place(...middle);
    navigator.followDraft();
    return true;
  }
  const arrow = ARROWS[key];
  if (arrow !== undefined) {
    const step = shift ? COARSE : FINE;
    editing.nudge(step * arrow[0], step * arrow[1]);
    navigator.followDraft();
    return true;
  }
  switch (key) {
    case 'Enter':
      editing.accept();
      return true;
    case 'o':
    case 'O':
      editing.exchange();
      navigator.followDraft();
      return true;
    case 'f':
    case 'F':
      void editing.fit();
      return true;
    default:
      return false;
  }
}

/** Runs the command of a key; false where it has none. */
function command(key: string, store: Store, navigator: Navigator, editing: Editing): boolean {
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
    case 'Delete':
    case 'Backspace':
      editing.edit('reject');
      return true;
    case 'r':
    case 'R':
      editing.edit('restore');
      return true;
    case 'x':
    case 'X':
      editing.choose(store.state.selection);
      return true;
    case 's':
    case 'S':
      editing.toggle('choose');
      return true;
    case 'a':
    case 'A':
      editing.toggle('measure');
      return true;
    case 'e':
    case 'E':
      editing.move();
      navigator.followDraft();
      return true;
    case 'Escape':
      if (!editing.leave()) navigator.select(null);
      return true;
    default:
      return false;
  }
}
