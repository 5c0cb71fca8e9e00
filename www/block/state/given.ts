/** What is wrong with the files that a run is given beside its images: read as the run reads them, once they are there. */
import {
  check_cameras,
  check_control,
  check_geoid,
  masks_of_images,
  parse_image_measurements,
  parse_ground_control_points,
  positions_of_images,
  system_positions,
} from '../../../pkg/wasm/tiepoint.js';
import type { GeoreferencingOptions } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import { collectedOf } from './marks';
import { purposeOf } from './purpose';
import { isLacking } from './lacking';
import type { BlockOptions, BlockState } from './state';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

/** What a run can be given beside its images; `crs`: the coordinate reference system of what is. */
export type Given = 'crs' | 'cameras' | 'control' | 'marks' | 'positions' | 'masks' | 'geoid';

/** A file that is given as text. */
export type GivenText = Exclude<Given, 'crs' | 'masks' | 'geoid'>;

export type Problems = Readonly<Partial<Record<Given, string>>>;

/** Marks are of use with their points; points without marks wait for them. */
export const PARTNER_MISSING: Readonly<Partial<Record<Given, string>>> = {
  marks: say('image-measurements-need-their-ground'),
};

type WithGiven = Pick<BlockState, 'files' | 'options' | 'marks' | 'shown' | 'placing'>;

export function problemsOf(state: WithGiven): Problems {
  const { files, options } = state;
  const { settings, cameras, control, marks, positions, masks, geoid } = options;
  return problems(files, settings?.placing ?? null, cameras, control, marks, positions, masks, geoid, collectedOf(state), purposeOf(state) === 'block');
}

/** The first of them; null where there is none. */
export function firstProblem(state: WithGiven): string | null {
  return Object.values(problemsOf(state))[0] ?? null;
}

/** Of a coordinate reference system the crate says why a library cannot read it, in the words of that. */
function isUnread(error: unknown): boolean {
  return error instanceof Error && 'error' in error && (error.error as { refusal?: { kind?: string } } | null)?.refusal?.kind === 'crs_text';
}

const problems = remember(
  (
    files: BlockState['files'],
    placing: GeoreferencingOptions | null,
    cameras: BlockOptions['cameras'],
    control: BlockOptions['control'],
    marks: BlockOptions['marks'],
    positions: BlockOptions['positions'],
    masks: BlockOptions['masks'],
    geoid: BlockOptions['geoid'],
    { run }: ReturnType<typeof collectedOf>,
    onOrthophoto: boolean,
  ): Problems => {
    // Nothing is given before the crate is there to read it.
    if (placing === null) return {};
    const names = files.map(({ name }) => name);
    const found: Partial<Record<Given, string>> = {};
    const { crs } = placing;
    const look = (given: Given, name: string, read: () => unknown): boolean => {
      try {
        read();
        return true;
      } catch (error) {
        found[given] = `${name === '' ? '' : `${name}: `}${isUnread(error) ? say('system-cannot-be-read') : messageOf(error)}`;
        return false;
      }
    };
    // What counts in a system that cannot be read is not to blame for it.
    const isRead = crs === null || look('crs', 'placing.crs', () => system_positions(crs, []));
    if (cameras !== null) look('cameras', cameras.name, () => check_cameras(cameras.text, names));
    const pointsRead = control !== null && look('control', control.name, () => parse_ground_control_points(control.text));
    const marksRead = marks === null || look('marks', marks.name, () => parse_image_measurements(marks.text));
    if (isRead && pointsRead && marksRead && run !== null)
      look('marks', marks?.name ?? '', () => check_control(run.points, run.marks, names, placing, onOrthophoto));
    if (marks !== null && control === null) found.marks ??= PARTNER_MISSING.marks ?? '';
    if (isRead && positions !== null) look('positions', positions.name, () => positions_of_images(positions.text, names, placing));
    const lacking = masks.filter(isLacking);
    look('masks', '', () =>
      masks_of_images(
        names,
        masks.map(({ name }) => name),
      ),
    );
    if (lacking.length > 0) found.masks = say('masks-are-not-in-the-file', { masks: lacking.length, name: lacking[0]?.name ?? '' });
    if (geoid !== null && isLacking(geoid)) found.geoid = say('geoid-is-not-in-the-file', { name: geoid.name });
    else if (geoid !== null) look('geoid', '', () => check_geoid(geoid.name, placing));
    return found;
  },
);
