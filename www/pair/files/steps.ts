/** Steps on masks and fiducial marks of a pair, as the browser keeps them. */
import type { Fiducial } from '../../shared/crate';
import { likeOf, listOf, objectOf, orNull, positionFrom } from '../../shared/files/keepable';
import { remember } from '../../shared/state/remember';
import type { History } from '../../shared/state/history';
import { say } from '../../shared/text/words';
import type { KeptMask } from '../state/kept';
import type { Area, Deed, MarkStep, MaskStep, Side } from '../state/state';
import { keptMask, maskFrom } from './sources';

/** A step on a mask, whose file is kept by itself. */
export type KeptMaskStep = { side: Side } & (Area | { given: KeptMask | null });

/** About what a step, a corner of an area and a mark take, in bytes. */
const OF_STEP = 80;
const OF_CORNER = 24;
const OF_MARK = 80;

/** The same of the same step. */
const keptSteps = new WeakMap<MaskStep, KeptMaskStep>();

export const keptMaskSteps = remember(({ edits, done }: History<MaskStep>): History<KeptMaskStep> => ({ edits: edits.map(keptMaskStep), done }));

function keptMaskStep(step: MaskStep): KeptMaskStep {
  const kept = keptSteps.get(step) ?? ('given' in step ? { side: step.side, given: orNull(step.given, keptMask) } : step);
  keptSteps.set(step, kept);
  return kept;
}

/** @throws Error where a file of theirs is not there */
export function maskStepsFrom(parts: ReadonlyMap<string, unknown>, { edits, done }: History<KeptMaskStep>): History<MaskStep> {
  const own = (kept: KeptMaskStep): MaskStep => {
    const step = 'given' in kept ? { side: kept.side, given: orNull(kept.given, (mask) => maskFrom(parts, mask)) } : kept;
    keptSteps.set(step, kept);
    return step;
  };
  return { edits: edits.map(own), done };
}

export function bytesOfMaskStep(step: KeptMaskStep): number {
  return OF_STEP + ('given' in step ? 0 : OF_CORNER * step.corners.length);
}

export function bytesOfMarkStep({ out, put }: MarkStep): number {
  return OF_STEP + OF_MARK * (out.length + put.length);
}

/** @throws Error naming the field that is damaged */
export function maskStepFrom(value: unknown, name: string): KeptMaskStep {
  const { side, given, corners, masked } = objectOf(value, name);
  const own = { side: sideFrom(side, `${name}.side`) };
  if (given !== undefined) return { ...own, given: orNull(given, (mask) => keptMaskFrom(mask, `${name}.given`)) };
  return { ...own, corners: listOf(corners, `${name}.corners`, positionFrom), masked: likeOf<boolean>(masked, true, `${name}.masked`) };
}

/** @throws Error naming the field that is damaged */
export function markStepFrom(value: unknown, name: string): MarkStep {
  const { side, deed, at, out, put } = objectOf(value, name);
  return {
    side: sideFrom(side, `${name}.side`),
    deed: likeOf(deed, '', `${name}.deed`) as Deed,
    at: likeOf(at, 0, `${name}.at`),
    out: listOf(out, `${name}.out`, markFrom),
    put: listOf(put, `${name}.put`, markFrom),
  };
}

/** @throws Error where it is none */
export function markFrom(value: unknown, name: string): Fiducial {
  return objectOf(value, name) as unknown as Fiducial;
}

/** @throws Error naming the field that is damaged */
export function keptMaskFrom(value: unknown, name: string): KeptMask {
  const { name: called, file } = objectOf(value, name);
  return { name: likeOf(called, '', `${name}.name`), file: likeOf(file, '', `${name}.file`) };
}

function sideFrom(value: unknown, name: string): Side {
  if (value !== 'left' && value !== 'right') throw new Error(say('the-field-is-damaged', { name }));
  return value;
}
