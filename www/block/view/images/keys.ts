/** What keys do in the panes, while a point is measured and otherwise. */
import type { Command } from '../../../shared/view/commands';
import { toPosition } from '../../../shared/view/transform';
import type { Measuring } from './measuring';
import type { Moving } from './moving';
import type { Opening } from './opening';
import type { Pane } from './scene';
import type { Seen } from './seen';
import { say } from '../../../shared/text/words';

/** What keys command. */
export interface Commanded {
  seen: Seen;
  measuring: Measuring;
  moving: Moving;
  opening: Opening;
  match: () => void;
  matchAlone: () => void;
  step: (by: 1 | -1) => void;
  turn: (by: 1 | -1) => void;
  other: () => void;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** How far an arrow moves a point that is measured, px; with Shift. */
const FINE = 0.1;
const COARSE = 1;

/** What keys do while a point is measured, and what begins it. */
export function measuringKeys(view: Commanded): Command[] {
  const { measuring } = view;
  const drafts = () => measuring.draft !== null;
  const lacksPoint = () => (drafts() || measuring.canBegin() ? '' : say('no-point-is-chosen'));
  const lacksPlace = () => {
    const pane = view.seen.active();
    return drafts() && (pane === null || measuring.placeIn(pane) === null) ? say('nothing-is-measured') : lacksPoint();
  };
  const shown = (act: (shift: boolean) => void) => (shift: boolean) => {
    act(shift);
    view.opening.showDraft();
  };
  const inPane = (act: (pane: Pane, shift: boolean) => void) =>
    shown((shift) => {
      const pane = view.seen.active();
      if (pane !== null) act(pane, shift);
    });
  const places = () => drafts() && view.seen.active() !== null;
  const nudge = ([key, [dx, dy]]: [string, readonly [number, number]]): Command => ({
    keys: [key],
    does: say('moves-the-measured-point-by'),
    can: places,
    run: inPane((pane, shift) => {
      const step = shift ? COARSE : FINE;
      measuring.nudge(pane, step * dx, step * dy);
    }),
  });
  const settle = (pane: Pane) => {
    const { rect, transform } = pane;
    void measuring.settle(pane, toPosition(transform, rect.left + rect.width / 2, rect.top + rect.height / 2));
  };
  return [
    { keys: ['e'], does: say('measures-the-chosen-point'), lacks: lacksPoint, run: shown(() => measuring.toggle(false)) },
    { keys: ['a'], does: say('measures-a-new-tie-point'), run: shown(() => measuring.toggle(true)) },
    { keys: ['f'], does: say('matches-the-point-in-the'), lacks: lacksPlace, run: shown((shift) => (shift ? view.matchAlone() : view.match())) },
    { keys: ['Escape'], does: say('gives-up-measuring'), can: places, run: shown(() => measuring.leave()) },
    { keys: ['Enter'], does: say('takes-the-middle-of-the'), can: places, run: inPane(settle) },
    ...Object.entries(ARROWS).map(nudge),
  ];
}

/** What else keys do in the panes. */
export function looking(view: Commanded): Command[] {
  const { store } = view.seen;
  const look = () => store.state.panes.look;
  // What is measured is not given up by the way.
  const step = (by: 1 | -1) => {
    if (view.measuring.draft === null) view.step(by);
  };
  return [
    { keys: ['n'], does: say('chooses-the-next-tie-point'), run: () => step(1) },
    { keys: ['p'], does: say('chooses-the-previous-tie-point'), run: () => step(-1) },
    { keys: ['1'], does: say('shows-one-image-pixel-as'), run: () => view.moving.actualSize() },
    { keys: ['PageDown'], does: say('shows-the-next-images'), run: () => view.turn(1) },
    { keys: ['PageUp'], does: say('shows-the-previous-images'), run: () => view.turn(-1) },
    { keys: ['o'], does: say('goes-to-the-next-pane'), run: () => view.other() },
    { keys: ['l'], does: say('links-all-panes-or-no'), run: () => store.dispatch({ type: 'look', look: { linked: !look().linked } }) },
    { keys: ['m'], does: say('shows-the-loupe-or-no'), run: () => store.dispatch({ type: 'look', look: { loupe: !look().loupe } }) },
    {
      keys: ['u'],
      does: say('shows-images-in-which-the'),
      run: () => store.dispatch({ type: 'look', look: { unmeasured: !look().unmeasured } }),
    },
    {
      keys: ['Escape'],
      does: say('chooses-nothing'),
      lacks: () => (store.state.selection.chosen === null ? say('nothing-is-chosen') : ''),
      run: () => store.dispatch({ type: 'choose', choice: null }),
    },
  ];
}
