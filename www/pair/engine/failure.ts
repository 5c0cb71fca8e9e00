/** What the page says when a stage has no result: what happened, what is kept, what to try. */
import { readable } from '../../shared/text/names';
import type { StageName } from '../state/state';
import type { Catalogue } from '../../shared/crate';
import { CallError } from '../../shared/engine/client';
import { STAGES } from '../state/stages';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

const KEPT = say('images-settings-and-earlier-results');

function advice(stage: StageName): string {
  switch (stage) {
    case 'openLeft':
    case 'openRight':
      return say('try-a-smaller-image-or');
    case 'pointsLeft':
    case 'pointsRight':
      return say('try-a-higher-threshold-or');
    case 'descriptorsLeft':
    case 'descriptorsRight':
    case 'match':
      return say('try-fewer-points-a-higher');
    default:
      return say('change-a-setting-or-run');
  }
}

/** A sentence or two for the user. */
export function plainMessage(stage: StageName, error: unknown, catalogue: Catalogue | null): string {
  const text = readable(catalogue, messageOf(error));
  if (!(error instanceof CallError)) return say('failed', { label: capital(STAGES[stage].label), text, kept: KEPT });
  switch (error.failure.kind) {
    case 'refused':
      // Of two images it says which; what is wrong with a setting is wrong with both.
      return error.failure.code === 'image-too-small' ? `${sideOf(stage)}${text}.` : `${capital(text)}.`;
    case 'memory':
      return say('memory-ran-out-while', { label: STAGES[stage].label, text, kept: KEPT, stage: advice(stage) });
    case 'fault':
      return say('the-program-broke-off-while', { label: STAGES[stage].label, text, kept: KEPT, stage: advice(stage) });
    case 'other':
      return say('failed-2', { label: capital(STAGES[stage].label), text, kept: KEPT, stage: advice(stage) });
  }
}

function sideOf(stage: StageName): string {
  const side = /(Left|Right)$/u.exec(stage)?.[1];
  return side === undefined ? '' : say('image-3', { side });
}

function capital(text: string): string {
  const trimmed = text.endsWith('.') ? text.slice(0, -1) : text;
  return trimmed.charAt(0).toUpperCase() + trimmed.slice(1);
}
