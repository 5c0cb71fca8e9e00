/** What is wrong with the files that a run is given beside its images: read as the run reads them, once they are there. */
import { check_cameras, check_control, check_masks, parse_image_measurements, parse_ground_control_points } from '../../../pkg/wasm/tiepoint.js';
import type { GeoreferencingOptions } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import type { BlockOptions, BlockState } from './state';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

/** What a run can be given beside its images. */
export type Given = 'cameras' | 'control' | 'marks' | 'masks';

/** A file that is given as text. */
export type GivenText = Exclude<Given, 'masks'>;

export type Problems = Readonly<Partial<Record<Given, string>>>;

/** Control points and their marks are of use together. */
export const PARTNER_MISSING: Readonly<Partial<Record<Given, string>>> = {
  control: say('ground-control-points-need-their'),
  marks: say('image-measurements-need-their-ground'),
};

export function problemsOf({ files, options }: Pick<BlockState, 'files' | 'options'>): Problems {
  return problems(files, options.settings?.placing ?? null, options.cameras, options.control, options.marks, options.masks);
}

/** The first of them; null where there is none. */
export function firstProblem(state: Pick<BlockState, 'files' | 'options'>): string | null {
  return Object.values(problemsOf(state))[0] ?? null;
}

const problems = remember(
  (
    files: BlockState['files'],
    placing: GeoreferencingOptions | null,
    cameras: BlockOptions['cameras'],
    control: BlockOptions['control'],
    marks: BlockOptions['marks'],
    masks: BlockOptions['masks'],
  ): Problems => {
    // Nothing is given before the crate is there to read it.
    if (placing === null) return {};
    const names = files.map(({ name }) => name);
    const found: Partial<Record<Given, string>> = {};
    const look = (given: Given, name: string, read: () => unknown): boolean => {
      try {
        read();
        return true;
      } catch (error) {
        found[given] = `${name === '' ? '' : `${name}: `}${messageOf(error)}`;
        return false;
      }
    };
    if (cameras !== null) look('cameras', cameras.name, () => check_cameras(cameras.text, names));
    const pointsRead = control !== null && look('control', control.name, () => parse_ground_control_points(control.text));
    const marksRead = marks !== null && look('marks', marks.name, () => parse_image_measurements(marks.text));
    if (pointsRead && marksRead) look('marks', marks.name, () => check_control(control.text, marks.text, names, placing));
    if (control !== null && marks === null) found.control ??= PARTNER_MISSING.control ?? '';
    if (marks !== null && control === null) found.marks ??= PARTNER_MISSING.marks ?? '';
    look('masks', '', () =>
      check_masks(
        names,
        masks.map(({ name }) => name),
      ),
    );
    return found;
  },
);
