/** Control and check points that were given, or added by hand, and are not in the block: tables list them, and they can be measured. Pure. */
import { remember } from '../../shared/state/remember';
import type { History } from '../../shared/state/history';
import type { TextFile } from './file';
import { editsInForce } from './editing';
import { standingOf } from './edits';
import { inSystemOfBlock } from './in-common';
import { allMarks, pointsOfFile, waitsForMarks } from './marks';
import type { MarkStep } from './marks';
import { countedFrom } from './result-system';
import { addedPoints } from './added';
import type { AddedPoint } from './added';
import { isOutdated } from './state';
import type { BlockState } from './state';
import type { BlockView, ViewGiven } from './view';

export const NONE_GIVEN: readonly ViewGiven[] = [];

type Beside = Omit<ViewGiven, 'images'>;

/** They stay the same while only measurements change. `geoid_m`: what their heights count from; null: from where those of the block do. */
const besideBlock = remember((view: BlockView, control: TextFile | null, crs: string | null, geoid_m: number | null): readonly Beside[] => {
  const known = new Set(view.surveyed.map(({ name }) => name));
  const heights = geoid_m === null ? countedFrom(view) : { geoid_m };
  const places = inSystemOfBlock(view, pointsOfFile(control), { crs, heights });
  return pointsOfFile(control).flatMap(({ name, position, role }, i) =>
    known.has(name) ? [] : [{ name, position, place: places[i] ?? null, role: role ?? null, byHand: false }],
  );
});

const measured = remember((points: readonly Beside[], view: BlockView, file: TextFile | null, history: History<MarkStep>): readonly ViewGiven[] => {
  if (points.length === 0) return NONE_GIVEN;
  const images = new Map<string, number>();
  for (const { point } of allMarks(file, history, view.images)) images.set(point, (images.get(point) ?? 0) + 1);
  return points.map((point) => ({ ...point, images: images.get(point.name) ?? 0 }));
});

/** Those that edits add, as long as the block is not adjusted by them. */
const added = remember((view: BlockView, points: ReadonlyMap<string, AddedPoint>, unused: ReadonlySet<number>): readonly ViewGiven[] => {
  if (points.size === 0) return NONE_GIVEN;
  const known = new Set(view.surveyed.map(({ name }) => name));
  const waiting = [...points.values()].filter(({ edit }) => !known.has(edit.name));
  if (waiting.length === 0) return NONE_GIVEN;
  const places = inSystemOfBlock(
    view,
    waiting.map(({ edit: { name, position } }) => ({ name, position, standard_errors: null, role: 'control', sigma_px: null })),
    { crs: view.crs, heights: countedFrom(view) },
  );
  return waiting.map(({ edit, control, places: seen }, i): ViewGiven => {
    const { name, position, use } = edit;
    return { name, position, place: places[i] ?? null, role: unused.has(control) ? null : (use ?? 'control'), images: seen.size, byHand: true };
  });
});

const together = remember((given: readonly ViewGiven[], byHand: readonly ViewGiven[]): readonly ViewGiven[] =>
  byHand.length === 0 ? given : given.length === 0 ? byHand : [...given, ...byHand],
);

/** The points beside a block, in the order of their file, and behind them those that were added by hand. */
export function givenBeside(view: BlockView, state: Pick<BlockState, 'options' | 'marks' | 'history'>): readonly ViewGiven[] {
  if (view.partial) return NONE_GIVEN;
  const edits = editsInForce(state.history);
  return together(ofFile(view, state), added(view, addedPoints(edits, view.givenControl), standingOf(edits).unused));
}

/** So many points are measured that neither the block nor its project file has: they are taken in by a run. */
export function pendingPoints(state: BlockState): number {
  if (state.shown === null || !(waitsForMarks(state) || isOutdated(state))) return 0;
  return state.shown.given.filter(({ byHand, images }) => !byHand && images > 0).length;
}

function ofFile(view: BlockView, { options, marks }: Pick<BlockState, 'options' | 'marks'>): readonly ViewGiven[] {
  if (options.control === null) return NONE_GIVEN;
  const { crs = null, geoid_m = null } = options.settings?.placing ?? {};
  // Of a block that was opened by an earlier release the settings are not those that it was made with.
  return measured(besideBlock(view, options.control, crs ?? view.crs, geoid_m), view, options.marks, marks);
}
