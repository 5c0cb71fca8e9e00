/** The report of the pair on the screen: made in a worker of its own, step by step, and saved as one file. */
import { Cancelled } from '../../shared/engine/client';
import type { ReportEdits } from '../../shared/crate';
import type { ReportInput } from '../engine/calls';
import type { Engine } from '../engine/engine';
import { countsByHand, editedPair } from '../state/edited';
import { isEdited } from '../state/kept';
import { measuredPhoto } from '../state/marks';
import { truthOf } from '../state/truth';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { baseName } from './export';
import { save } from '../../shared/files/save';
import { say } from '../../shared/text/words';

/** The matches with the edits by hand; null where nothing of them stands. */
function editsOf(state: State): ReportEdits | null {
  const edited = isEdited(state) ? editedPair(state) : null;
  if (edited === null || edited.match === edited.found) return null;
  const { left, match, found } = edited;
  const { matches, fits, indices } = match;
  const added = left.subarray(3 * found.rules.length);
  const { rejected, manual } = countsByHand(match);
  return {
    match: { matches, fits, indices },
    added_px: Float64Array.from({ length: (2 * added.length) / 3 }, (_, i) => added[3 * Math.floor(i / 2) + (i % 2)] ?? NaN),
    rejected,
    measured: manual,
  };
}

/** What the report is made of; null where an image is missing. */
function inputOf(state: State): ReportInput | null {
  const { left, right } = state.images;
  const { settings, camera, photos, masks, offset, fiducialModel } = state;
  if (left === null || right === null || settings === null) return null;
  const truth = truthOf(state);
  const photo = (side: Side) => ({ ...measuredPhoto(photos[side]), model: fiducialModel });
  return {
    images: [left.source, right.source],
    names: [left.name, right.name],
    input: { camera, offset, left: photo('left'), right: photo('right') },
    settings,
    truth: truth === null ? null : { orientation: truth.orientation, base_mm: truth.baseMm, right_position: truth.rightPosition },
    masks: [masks.left?.grey ?? null, masks.right?.grey ?? null],
    edits: editsOf(state),
  };
}

/** Says itself what came of it, as the steps before. */
export async function exportReport(store: Store, engine: Engine): Promise<null> {
  const input = inputOf(store.state);
  if (input === null) return null;
  const tell = (text: string) => store.dispatch({ type: 'notice', notice: { kind: 'busy', text } });
  const client = engine.client('report');
  try {
    tell(say('report-reading-the-images'));
    const steps = await client.call('reportOpen', input);
    for (const [i, step] of steps.entries()) {
      tell(say('report-step-of-matching', { i: i + 1, steps: steps.length + 1, step }));
      await client.call('reportStep', null);
    }
    tell(say('report-step-of-writing', { steps: steps.length + 1 }));
    const page = await client.call('reportPage', null);
    const name = save(new Blob([page], { type: 'text/html' }), `${baseName(store.state)}-report.html`);
    // Other strategies match by themselves.
    const text = [say('was-saved', { name }), input.edits === null ? '' : say('its-run-has-the-edits')].join(' ').trimEnd();
    store.dispatch({ type: 'notice', notice: { kind: 'info', text, beside: true } });
  } catch (error) {
    if (!(error instanceof Cancelled)) throw error;
    store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('the-report-was-cancelled') } });
  } finally {
    // Its images and results would stay in memory.
    client.cancel();
  }
  return null;
}
