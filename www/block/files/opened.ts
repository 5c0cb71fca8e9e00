/** What a project file says of how its block was made, as the settings of the next run. */
import { block_settings, image_measurement_table, parse_image_measurements } from '../../../pkg/wasm/tiepoint.js';
import type { RunInput } from '../../../pkg/wasm/tiepoint.js';
import type { ProjectInput } from '../engine/project-input';
import type { BlockFile, BlockOptions, TextFile } from '../state/state';
import { standIn } from '../state/lacking';
import { newId } from './ids';

/** Places of an orthophoto stand among the control points of a block that lies on it; a run finds them anew. */
const PLACE = 'orthophoto_';

/** `name`: of the project file, of which the texts are said to be. */
export function optionsOf({ input, geoid }: ProjectInput, name: string): BlockOptions {
  const text = (given: string | null | undefined): TextFile | null => (given == null ? null : { name, text: given });
  const { points, marks } = withoutPlaces(input.control ?? null);
  return {
    settings: block_settings(input.settings ?? {}),
    gps: input.use_gnss === false ? 'ignore' : 'use',
    cameras: text(input.cameras),
    control: text(points),
    marks: text(marks),
    positions: text(input.positions),
    masks: (input.masks ?? []).map((mask) => fileOf(mask, null)),
    geoid: input.geoid === undefined ? null : fileOf(input.geoid, geoid),
  };
}

function fileOf(name: string, bytes: Uint8Array<ArrayBuffer> | null): BlockFile {
  return { id: newId(), name, file: bytes === null ? standIn(name) : new File([bytes], name) };
}

function withoutPlaces(control: RunInput['control'] | null): { points: string | null; marks: string | null } {
  if (control == null) return { points: null, marks: null };
  const { points, marks } = control;
  const lines = points.split('\n');
  const own = lines.filter((line) => !line.startsWith(PLACE));
  if (own.length === lines.length) return { points, marks };
  // The crate wrote a table anew, with a line of columns.
  if (own.filter((line) => line.trim() !== '').length < 2) return { points: null, marks: null };
  const measured = parse_image_measurements(marks).filter(({ point }) => !point.startsWith(PLACE));
  return { points: own.join('\n'), marks: image_measurement_table(measured) };
}
