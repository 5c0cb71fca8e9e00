/** What the page says when a stage has no result: what happened, what is kept, what to try. */
import { readable } from '../../shared/text/names';
import type { StageName } from '../state/state';
import type { Catalogue } from '../../shared/crate';
import { CallError } from '../../shared/engine/client';
import { STAGES } from '../state/stages';
import { messageOf } from '../../shared/text/format';

const KEPT = 'Images, settings and earlier results are kept.';

function advice(stage: StageName): string {
  switch (stage) {
    case 'openLeft':
    case 'openRight':
      return 'Try a smaller image, or close other tabs.';
    case 'pointsLeft':
    case 'pointsRight':
      return 'Try a higher threshold or a smaller image, then run again.';
    case 'descriptorsLeft':
    case 'descriptorsRight':
    case 'match':
      return 'Try fewer points (a higher threshold, a larger suppression window) or a smaller search window, then run again.';
    default:
      return 'Change a setting or run again.';
  }
}

/** A sentence or two for the user. */
export function plainMessage(stage: StageName, error: unknown, catalogue: Catalogue | null): string {
  const text = readable(catalogue, messageOf(error));
  if (!(error instanceof CallError)) return `${capital(STAGES[stage].label)} failed: ${text}. ${KEPT}`;
  switch (error.failure.kind) {
    case 'refused':
      // Of two images it says which; what is wrong with a setting is wrong with both.
      return error.failure.code === 'image-too-small' ? `${sideOf(stage)}${text}.` : `${capital(text)}.`;
    case 'memory':
      return `Memory ran out while ${STAGES[stage].label} (${text}). ${KEPT} ${advice(stage)}`;
    case 'fault':
      return `The program broke off while ${STAGES[stage].label} (${text}): a fault of its own, please report it. ${KEPT} ${advice(stage)}`;
    case 'other':
      return `${capital(STAGES[stage].label)} failed: ${text}. ${KEPT} ${advice(stage)}`;
  }
}

function sideOf(stage: StageName): string {
  const side = /(Left|Right)$/u.exec(stage)?.[1];
  return side === undefined ? '' : `${side} image: `;
}

function capital(text: string): string {
  const trimmed = text.endsWith('.') ? text.slice(0, -1) : text;
  return trimmed.charAt(0).toUpperCase() + trimmed.slice(1);
}
