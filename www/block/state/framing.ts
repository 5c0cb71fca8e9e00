/**
 * Images of one camera in the place of scans of film, as a step beside the edits that is undone and done again: with the images change their masks, the
 * files of cameras and of image measurements, what was given of the film, and the measurements of the steps before, which are in px of the images. Pure.
 */
import type { BlockFile, TextFile } from './file';
import type { GivenFilm } from './film';
import { isFramesStep } from './marks';
import type { Framing, FramesStep, MarkStep } from './marks';
import { withoutRunUnderWay } from './state';
import type { BlockOptions, BlockState } from './state';
import type { History } from '../../shared/state/history';

/** The places of such steps from one place of a history on, as far as another. */
function between({ edits }: History<MarkStep>, from: number, to: number): number[] {
  return edits.flatMap((step, at) => (at >= from && at < to && isFramesStep(step) ? [at] : []));
}

/** Whether scans are in the place of their images, or these in place of the scans, by one history and not by another that has as many steps. */
export function framesOthers(marks: History<MarkStep>, done: number): boolean {
  return between(marks, Math.min(marks.done, done), Math.max(marks.done, done)).length > 0;
}

/** The state with what the steps beside the edits say now, of what it had after `before` of them. */
export function withFrames(state: BlockState, before: number): BlockState {
  const { marks } = state;
  const back = between(marks, marks.done, before).reverse();
  const again = between(marks, before, marks.done);
  const undone = back.reduce((now, at) => exchanged(now, at, ({ scans, frames }) => [frames, scans]), state);
  return again.reduce((now, at) => exchanged(now, at, ({ scans, frames }) => [scans, frames]), undone);
}

/** By the step at a place: one after it may have put another in that place, which is the same but for its object. What was given meanwhile stays. */
function exchanged(state: BlockState, at: number, of: (step: FramesStep) => [from: Framing, into: Framing]): BlockState {
  const { files, removed, options, placing, marks } = state;
  const step = marks.edits[at];
  if (step === undefined || !isFramesStep(step)) return state;
  const [from, into] = of(step);
  return {
    ...state,
    files: imagesAfter(files, from, into),
    removed: without(removed, from.images),
    options: { ...options, ...optionsAfter(options, from, into) },
    placing: { ...placing, film: filmAfter(placing.film, from.film, into.film) },
    marks: { ...marks, edits: stepsAfter(marks.edits, at, into.steps) },
    running: withoutRunUnderWay(state.running),
  };
}

function without(files: readonly BlockFile[], gone: readonly BlockFile[]): readonly BlockFile[] {
  const ids = new Set(gone.map(({ id }) => id));
  return files.some(({ id }) => ids.has(id)) ? files.filter(({ id }) => !ids.has(id)) : files;
}

/** In the places of those that go, where they are all there; an image that has the name of one keeps it. */
function imagesAfter(files: readonly BlockFile[], from: Framing, into: Framing): readonly BlockFile[] {
  const successors = new Map(from.images.map(({ id }, k) => [id, into.images[k]]));
  const names = new Set(without(files, from.images).map(({ name }) => name));
  const isFree = (file: BlockFile | undefined): file is BlockFile => file !== undefined && !names.has(file.name);
  return files.flatMap((file) => {
    if (!successors.has(file.id)) return [file];
    const next = successors.get(file.id);
    return isFree(next) ? [next] : [];
  });
}

/** Files that somebody gave in place of those of the step stay. */
function optionsAfter(options: BlockOptions, from: Framing, into: Framing): Pick<BlockOptions, 'masks' | 'cameras' | 'marks'> {
  const given = (now: TextFile | null, before: TextFile | null, then: TextFile | null) => (now?.text === before?.text ? then : now);
  const isSame = options.masks.length === from.masks.length && options.masks.every(({ id }, k) => id === from.masks[k]?.id);
  const others = without(options.masks, without(from.masks, into.masks));
  return {
    // In their order, by which a block knows what it was made from.
    masks: isSame ? into.masks : [...others, ...without(into.masks, [...from.masks, ...others])],
    cameras: given(options.cameras, from.cameras, into.cameras),
    marks: given(options.marks, from.marks, into.marks),
  };
}

/** With what else is given of film. */
function filmAfter(now: GivenFilm, from: GivenFilm, into: GivenFilm): GivenFilm {
  const names = new Set([...from.marks, ...into.marks].map(({ name }) => name));
  const images = new Set([...from.begun, ...into.begun].map(({ image }) => image));
  return {
    camera: now.camera?.text === from.camera?.text ? into.camera : now.camera,
    marks: [...into.marks, ...now.marks.filter(({ name }) => !names.has(name))],
    areScans: into.areScans || (now.areScans && !from.areScans),
    begun: [...into.begun, ...now.begun.filter(({ image }) => !images.has(image))],
  };
}

/** After as many edits of the block as the steps that they take the place of. */
function stepsAfter(edits: readonly MarkStep[], at: number, before: readonly MarkStep[]): readonly MarkStep[] {
  const placed = before.slice(0, at).map((step, i) => {
    const { after = step.after } = edits[i] ?? {};
    return after === step.after ? step : { ...step, after };
  });
  return [...placed, ...edits.slice(placed.length)];
}
