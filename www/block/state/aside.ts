/** Places of an orthophoto by hand of a block that is taken off it: their steps are undone, and redo makes them again. Pure. */
import type { BlockEdit } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import { isPlaceByHand } from './added';
import type { EditStep } from './edits';

export interface SetAside {
  history: History<EditStep>;
  /** Of the first so many former steps so many stand before the next one. */
  left: readonly number[];
  /** So many steps were undone. */
  aside: number;
}

/** `given`: how many surveyed points the block was found with. The other steps that hold go on doing so. */
export function placesSetAside({ edits: steps, done }: History<EditStep>, given: number): SetAside {
  const held = steps.slice(0, done);
  const added = held.flat().filter((edit) => edit.kind === 'add_control');
  const stays = added.map(({ name }) => !isPlaceByHand(name));
  const isPlace = (edit: BlockEdit) => (edit.kind === 'add_control' ? isPlaceByHand(edit.name) : controlsOf(edit).some((one) => stays[one - given] === false));
  // Those that stay are numbered before those that come again.
  const order = [...stays.keys()].sort((a, b) => Number(stays[b]) - Number(stays[a]));
  const numberOf = (control: number) => {
    const at = order.indexOf(control - given);
    return at < 0 ? control : given + at;
  };
  const numbered = (step: EditStep) => step.map((edit) => withControls(edit, numberOf));
  const kept: EditStep[] = [];
  const aside: EditStep[] = [];
  const left = [0];
  for (const step of held) {
    // Points that were added stay in the step that added them: later ones are numbered behind them.
    const isWhole = !step.some(({ kind }) => kind === 'add_point');
    const isAside = isWhole && step.some(isPlace) ? () => true : isPlace;
    const [stay, go] = [step.filter((edit) => !isAside(edit)), step.filter((edit) => isAside(edit))];
    if (stay.length > 0) kept.push(stay);
    if (go.length > 0) aside.push(go);
    left.push(kept.length);
  }
  if (aside.length === 0) return { history: { edits: steps, done }, left: [...steps.keys(), steps.length], aside: 0 };
  const undone = steps.slice(done);
  return {
    history: { edits: [...[...kept, ...aside].map(numbered), ...undone], done: kept.length },
    left: [...left, ...undone.map((_, i) => kept.length + aside.length + i + 1)],
    aside: aside.length,
  };
}

/** The surveyed points that an edit is about, by their numbers. */
function controlsOf(edit: BlockEdit): number[] {
  const found: number[] = [];
  withControls(edit, (control) => {
    found.push(control);
    return control;
  });
  return found;
}

/** An edit with other numbers of surveyed points. */
function withControls(edit: BlockEdit, number: (control: number) => number): BlockEdit {
  const renumbered = <P extends object>(point: P): P =>
    'ground_control' in point ? { ...point, ground_control: number(point.ground_control as number) } : point;
  switch (edit.kind) {
    case 'measure':
      return { ...edit, point: renumbered(edit.point) };
    case 'reject_points':
    case 'restore_points':
      return { ...edit, points: edit.points.map(renumbered) };
    case 'reject_observations':
    case 'restore_observations':
      return { ...edit, observations: edit.observations.map((one) => ({ ...one, point: renumbered(one.point) })) };
    case 'set_use':
      return { ...edit, point: number(edit.point) };
    default:
      return edit;
  }
}
