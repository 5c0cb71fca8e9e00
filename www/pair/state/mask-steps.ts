/** Steps on the masks of a pair: a mask is what the steps that hold make of the file that was there before them. */
import { recorded } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { say } from '../../shared/text/words';
import type { Area, GivenMask, MaskFile, MaskStep, Side, State } from './state';

/** What a mask is made of: areas over a file, or over nothing. */
export interface Composition {
  file: MaskFile | null;
  areas: readonly Area[];
}

/** What the mask of an image is made of after the steps that hold. */
export function compositionOf(given: MaskFile | null, { edits, done }: History<MaskStep>, side: Side): Composition {
  let file = given;
  let areas: Area[] = [];
  for (const step of edits.slice(0, done)) {
    if (step.side !== side) continue;
    if ('given' in step) [file, areas] = [step.given, []];
    else areas.push(step);
  }
  return { file, areas };
}

/** The areas that are to be painted over one mask to have another; null where it is made of another file, or of fewer areas. */
export function areasAfter(now: Composition, then: Composition): readonly Area[] | null {
  const goesOn = now.file === then.file && now.areas.every((area, i) => area === then.areas[i]);
  return goesOn ? then.areas.slice(now.areas.length) : null;
}

/** A mask of a file, or none, in place of the one that an image has. What it has first is no step, nor is what takes the place of a file that is not there. */
export function withGivenMask({ masks, givenMasks, maskSteps }: State, side: Side, mask: GivenMask | null): Pick<State, 'masks' | 'givenMasks' | 'maskSteps'> {
  const given = mask === null ? null : { name: mask.name, source: mask.source };
  const before = masks[side];
  const isFirst = (before === null || before.source.kind === 'project') && maskSteps.edits.every((step) => step.side !== side);
  const isGiven = isFirst ? { givenMasks: { ...givenMasks, [side]: given }, maskSteps } : { givenMasks, maskSteps: recorded(maskSteps, { side, given }) };
  return { masks: { ...masks, [side]: mask }, ...isGiven };
}

/** What is done of an area before it is masked: a corner of its outline. */
export const CORNER = 'corner';

/** The steps as they are undone: while an area is outlined its last corner is the last of them, after which none can be made again. */
export function stepsWithOutline({ maskSteps, outline }: Pick<State, 'maskSteps' | 'outline'>): History<MaskStep | typeof CORNER> {
  return outline === null ? maskSteps : recorded<MaskStep | typeof CORNER>(maskSteps, CORNER);
}

/** What a step did, as in "Undo: mask an area of left.png". */
export function nameOfMaskStep(step: MaskStep | typeof CORNER, images: State['images']): string {
  if (step === CORNER) return say('step-of-outline');
  const image = images[step.side]?.name ?? '';
  if (!('given' in step)) return say('step-of-mask', { deed: step.masked ? 'masked' : 'unmasked', mask: '', image });
  return say('step-of-mask', { deed: step.given === null ? 'removed' : 'given', mask: step.given?.name ?? '', image });
}
