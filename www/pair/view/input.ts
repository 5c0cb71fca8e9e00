/** Pointer, wheel, touch and keys on the images. */
import { isCodeShown } from '../state/display';
import { declare } from '../../shared/view/commands';
import type { Command } from '../../shared/view/commands';
import { listen } from '../../shared/view/gestures';
import { toPosition } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { keysWithin, lackOfBegun, lackOfEdit, lackOfSelected } from '../state/choice';
import { editedPair } from '../state/edited';
import type { Editing } from '../state/editing';
import type { Masking } from '../state/masking';
import { markInHand, placeOfMark } from '../state/marks';
import type { Marking } from '../state/marking';
import { otherSide } from '../state/state';
import type { Selection, Side, State } from '../state/state';
import type { Store } from '../state/store';
import type { Navigator } from './navigate';
import { paneAt } from './scene';
import type { View } from './view';
import { say } from '../../shared/text/words';

/** What is done by hand in the pictures; `paint` masks the outlined area, or no longer. */
export interface ByHand {
  editing: Editing;
  masking: Masking;
  marking: Marking;
  paint: (masked: boolean) => void;
}

export function mountInput(view: View, store: Store, navigator: Navigator, { editing, masking, marking, paint }: ByHand): void {
  const { host } = view;
  const activate = (side: Side) => {
    if (store.state.activeSide !== side) store.dispatch({ type: 'activeSide', side });
  };
  // In the order of the list of keys: what is needed most comes first.
  const look = declare({ where: say('pictures-of-a-pair'), host, list: pictureKeys(view, store, navigator, editing, masking) });
  const measuring = declare({
    where: say('pictures-of-a-pair-while'),
    host,
    list: measuringKeys(store, navigator, editing),
    lacks: say('nothing-is-measured'),
  });
  const masks = declare({
    where: say('pictures-of-a-pair-while-masking'),
    host,
    list: maskingKeys(store, navigator, masking, paint),
    lacks: say('nothing-is-outlined'),
  });
  const marks = declare({
    where: say('pictures-of-a-pair-while-marking'),
    host,
    list: markingKeys(store, navigator, marking),
    lacks: say('nothing-is-measured'),
  });
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
        else if (store.state.tool === 'mask') corner(view, x, y, masking);
        else if (store.state.tool === 'fiducials') mark(view, x, y, marking);
        else press(view.hit(x, y), more, editing, navigator);
      },
      encloses: (shift) => shift || store.state.tool === 'choose' || store.state.tool === 'mask',
      enclosed: (side, from, to, ended, path) => {
        if (store.state.tool === 'mask') outline(view, side, path, ended, masking);
        else enclose(view, store, side, from, to, ended);
      },
      pointed: (at) => view.point(at),
      command: (key, shift) => measuring(key, shift) || masks(key, shift) || marks(key, shift) || look(key, shift),
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
  const { panes, shown } = view.scene();
  const { transform } = panes[side];
  const [left, top] = toPosition(transform, rect.left, rect.top);
  const [right, bottom] = toPosition(transform, rect.left + rect.width, rect.top + rect.height);
  const { codes } = panes.left;
  store.dispatch({ type: 'choose', chosen: keysWithin(edited, side, [left, top, right, bottom], (index) => isCodeShown(shown, codes[index] ?? 0)) });
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

/** Places a corner of an area. */
function corner(view: View, x: number, y: number, masking: Masking): void {
  const pane = paneAt(view.scene(), x, y);
  if (pane?.picture != null) masking.place(pane.side, toPosition(pane.transform, x, y));
}

/** Outlines an area by a line that is drawn; one without places is given up. */
function outline(view: View, side: Side, path: readonly [number, number][], ended: boolean, masking: Masking): void {
  const { transform } = view.scene().panes[side];
  const corners = path.map(([x, y]) => toPosition(transform, x, y));
  if (corners.length === 0) masking.giveUp();
  else masking.trace(side, corners, ended);
}

/** Measures the mark in hand. */
function mark(view: View, x: number, y: number, marking: Marking): void {
  const pane = paneAt(view.scene(), x, y);
  if (pane?.picture != null) marking.place(pane.side, toPosition(pane.transform, x, y));
}

/** While fiducial marks are measured. */
function markingKeys(store: Store, navigator: Navigator, marking: Marking): Command[] {
  const marks = () => store.state.tool === 'fiducials' && store.state.mark !== null;
  const isMeasured = () => marks() && placeOfMark(store.state.photos[store.state.mark?.side ?? 'left'], markInHand(store.state)) !== null;
  const nudge = (key: string, dx: number, dy: number): Command => ({
    keys: [key],
    does: say('moves-the-mark-by'),
    can: isMeasured,
    run: (shift) => marking.nudge((shift ? COARSE : FINE) * dx, (shift ? COARSE : FINE) * dy),
  });
  const middle = () => {
    const at = navigator.middle(store.state.mark?.side);
    if (at !== null) marking.place(...at);
  };
  return [
    nudge('ArrowLeft', -1, 0),
    nudge('ArrowRight', 1, 0),
    nudge('ArrowUp', 0, -1),
    nudge('ArrowDown', 0, 1),
    { keys: ['Enter'], does: say('goes-to-the-next-mark'), can: isMeasured, run: () => void marking.go(1) },
    { keys: ['Enter'], does: say('measures-the-mark-in-the-middle'), can: marks, run: middle },
    { keys: ['n'], does: say('goes-to-the-next-mark'), can: marks, run: () => void marking.go(1) },
    { keys: ['p'], does: say('goes-to-the-mark-before'), can: marks, run: () => void marking.go(-1) },
    { keys: ['Backspace', 'Delete'], does: say('takes-the-mark-back'), can: marks, run: () => marking.clear() },
  ];
}

/** While areas are masked. */
function maskingKeys(store: Store, navigator: Navigator, masking: Masking, paint: (masked: boolean) => void): Command[] {
  const masks = () => store.state.tool === 'mask';
  const encloses = () => masks() && masking.isArea();
  const place = () => {
    const middle = navigator.middle();
    if (middle !== null) masking.place(...middle);
  };
  return [
    { keys: ['Enter'], does: say('places-a-corner-in-the-middle'), can: masks, run: place },
    // Also where there is no corner: nothing else is rejected by them meanwhile.
    { keys: ['Backspace', 'Delete'], does: say('takes-the-last-corner-back'), can: masks, run: () => masking.back() },
    { keys: ['k'], does: say('masks-the-outlined-area'), can: encloses, run: () => paint(true) },
    { keys: ['u'], does: say('unmasks-the-outlined-area'), can: encloses, run: () => paint(false) },
  ];
}

/** How far an arrow moves a point, px; with Shift. */
const FINE = 0.1;
const COARSE = 1;

/** While a match is measured. */
function measuringKeys(store: Store, navigator: Navigator, editing: Editing): Command[] {
  const measures = () => store.state.tool === 'measure';
  const drafts = () => measures() && store.state.draft !== null;
  const nudge = (key: string, dx: number, dy: number): Command => ({
    keys: [key],
    does: say('moves-the-measured-point-by'),
    can: drafts,
    run: (shift) => {
      const step = shift ? COARSE : FINE;
      editing.nudge(step * dx, step * dy);
      navigator.followDraft();
    },
  });
  const begin = () => {
    const middle = navigator.middle();
    if (middle === null) return;
    editing.place(...middle);
    navigator.followDraft();
  };
  const exchange = () => {
    editing.exchange();
    navigator.followDraft();
  };
  return [
    {
      keys: ['Enter'],
      does: say('takes-the-middle-of-the-picture'),
      can: () => measures() && !drafts() && navigator.middle() !== null,
      run: begin,
    },
    nudge('ArrowLeft', -1, 0),
    nudge('ArrowRight', 1, 0),
    nudge('ArrowUp', 0, -1),
    nudge('ArrowDown', 0, 1),
    { keys: ['Enter'], does: say('accepts-the-measured-match'), can: drafts, run: () => editing.accept() },
    { keys: ['o'], does: say('goes-to-the-point-in'), can: drafts, run: exchange },
    { keys: ['f'], does: say('fits-the-point-by-least'), can: drafts, run: () => void editing.fit() },
  ];
}

function pictureKeys(view: View, store: Store, navigator: Navigator, editing: Editing, masking: Masking): Command[] {
  const show = (display: Partial<State['display']>) => store.dispatch({ type: 'display', display });
  const measures = (begins: () => void) => () => {
    begins();
    navigator.followDraft();
    // Else Enter would press the button that had the keyboard.
    if (store.state.tool === 'measure') view.takeKeys();
  };
  // Where there is nothing to give up the key is of what lies over the pictures.
  const isBegun = () => lackOfBegun(store.state) === '';
  const leave = () => {
    if (!editing.leave()) navigator.select(null);
  };
  return [
    { keys: ['n'], does: say('selects-the-next-point'), run: () => navigator.step(1) },
    { keys: ['p'], does: say('selects-the-previous-point'), run: () => navigator.step(-1) },
    { keys: ['1'], does: say('shows-one-image-pixel-as'), run: () => navigator.actualSize() },
    { keys: ['o'], does: say('goes-to-the-other-picture'), run: () => store.dispatch({ type: 'activeSide', side: otherSide(store.state.activeSide) }) },
    { keys: ['l'], does: say('links-both-pictures-or-no'), run: () => show({ linked: !store.state.display.linked }) },
    { keys: ['m'], does: say('shows-the-magnifier-or-no'), run: () => show({ magnifier: !store.state.display.magnifier }) },
    { keys: ['x'], does: say('chooses-the-selected-match-beside'), lacks: () => lackOfSelected(store.state), run: () => editing.choose(store.state.selection) },
    { keys: ['s'], does: say('chooses-matches-by-rectangles'), run: () => editing.toggle('choose') },
    {
      keys: ['Delete', 'Backspace'],
      does: say('rejects-the-chosen-matches'),
      lacks: () => lackOfEdit(store.state, 'reject'),
      run: () => editing.edit('reject'),
    },
    { keys: ['r'], does: say('restores-the-chosen-matches'), lacks: () => lackOfEdit(store.state, 'restore'), run: () => editing.edit('restore') },
    { keys: ['a'], does: say('adds-a-match-by-measuring'), run: measures(() => editing.toggle('measure')) },
    { keys: ['w'], does: say('outlines-areas-to-be-masked'), run: () => masking.toggle() },
    { keys: ['e'], does: say('measures-the-selected-match-anew'), lacks: () => lackOfSelected(store.state), run: measures(() => editing.move()) },
    { keys: ['Escape'], does: say('gives-up-or-selects-nothing'), can: isBegun, lacks: () => lackOfBegun(store.state), run: leave },
  ];
}
