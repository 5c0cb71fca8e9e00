/** An edit of a block as it is read from the browser's storage. */
import { likeOf, listOf, objectOf } from '../../shared/files/keepable';
import type { BlockEdit, HandMeasurement, PointImage, PointSource, Remark } from '../../../pkg/wasm/tiepoint.js';

import type { AddedControl } from '../state/added';
import type { EditStep } from '../state/edits';
import type { FramesStep, MarkStep } from '../state/marks';
import { say } from '../../shared/text/words';

/** About what a point, an image or a place takes in an edit, in bytes. */
const OF_ONE = 60;

export function bytesOfStep(step: EditStep): number {
  return step.reduce((sum, edit) => sum + bytesOf(edit), 0);
}

function bytesOf(edit: BlockEdit): number {
  const lists = Object.values(edit).filter((value) => Array.isArray(value));
  return OF_ONE * Math.max(1, ...lists.map(({ length }) => length));
}

export function bytesOfMarks(step: Exclude<MarkStep, FramesStep>): number {
  return OF_ONE * Math.max(1, step.kind === 'remove_images' ? step.files.length : step.marks.length);
}

/** @throws Error naming the field that is damaged */
export function markStepFrom(value: unknown, name: string): Exclude<MarkStep, FramesStep> {
  const { kind, marks, files, after } = objectOf(value, name);
  if (kind === 'remove_images') return { kind, files: listOf(files, `${name}.files`, (id, at) => likeOf(id, 0, at)), after: likeOf(after, 0, `${name}.after`) };
  return {
    kind: kind === 'remove' ? kind : 'measure',
    marks: listOf(marks, `${name}.marks`, (one, at) => {
      const { image, point, x_px, y_px } = objectOf(one, at);
      return {
        image: likeOf(image, '', `${at}.image`),
        point: likeOf(point, '', `${at}.point`),
        x_px: likeOf(x_px, 0, `${at}.x_px`),
        y_px: likeOf(y_px, 0, `${at}.y_px`),
      };
    }),
    after: likeOf(after, 0, `${name}.after`),
  };
}

/** @throws Error naming the field that is damaged */
export function stepFrom(value: unknown, name: string): EditStep {
  return listOf(value, name, editFrom);
}

function editFrom(value: unknown, name: string): BlockEdit {
  const edit = objectOf(value, name);
  const kind = likeOf<string>(edit.kind, '', `${name}.kind`);
  switch (kind) {
    case 'reject_observations':
    case 'restore_observations':
      return { kind, observations: listOf(edit.observations, `${name}.observations`, observationFrom) };
    case 'reject_points':
    case 'restore_points':
      return { kind, points: listOf(edit.points, `${name}.points`, sourceFrom) };
    case 'reject_images':
    case 'restore_images':
      return { kind, images: listOf(edit.images, `${name}.images`, (image, at) => likeOf(image, 0, at)) };
    case 'reject_pairs':
    case 'restore_pairs':
      return { kind, pairs: listOf(edit.pairs, `${name}.pairs`, pairFrom) };
    case 'measure':
      return { kind, point: sourceFrom(edit.point, `${name}.point`), ...placeFrom(edit, name) };
    case 'add_point':
      return { kind, observations: listOf(edit.observations, `${name}.observations`, placeFrom) };
    case 'add_control':
      return addedFrom(edit, name);
    case 'set_use': {
      const use = edit.use;
      return { kind, point: likeOf(edit.point, 0, `${name}.point`), ...(use === 'control' || use === 'check' ? { use } : {}) };
    }
    default:
      throw new Error(say('the-field-kind-is-damaged', { name }));
  }
}

function addedFrom(
  { name: called, position, standard_errors: errors, sigma_px: sigmaPx, use, epsg, remarks }: Record<string, unknown>,
  name: string,
): AddedControl {
  const [x = NaN, y = NaN, z = NaN] = listOf(position, `${name}.position`, numberFrom);
  const [across, up] = errors === undefined ? [] : listOf(errors, `${name}.standard_errors`, numberFrom);
  return {
    kind: 'add_control',
    name: likeOf(called, '', `${name}.name`),
    position: [x, y, z],
    ...(across === undefined || up === undefined ? {} : { standard_errors: [across, up] as [number, number] }),
    ...(sigmaPx === undefined ? {} : { sigma_px: likeOf(sigmaPx, 0, `${name}.sigma_px`) }),
    use: use === 'check' ? 'check' : 'control',
    ...(epsg === undefined ? {} : { epsg: likeOf(epsg, 0, `${name}.epsg`) }),
    // The crate reads what they say.
    ...(remarks === undefined ? {} : { remarks: listOf(remarks, `${name}.remarks`, (one, at) => objectOf(one, at) as unknown as Remark) }),
  };
}

const numberFrom = (value: unknown, name: string) => likeOf(value, 0, name);

function observationFrom(value: unknown, name: string): PointImage {
  const { point, image } = objectOf(value, name);
  return { point: sourceFrom(point, `${name}.point`), image: likeOf(image, 0, `${name}.image`) };
}

function pairFrom(value: unknown, name: string): [number, number] {
  const [a, b] = listOf(value, name, (image, at) => likeOf(image, 0, at));
  if (a === undefined || b === undefined) throw new Error(say('the-field-is-damaged', { name }));
  return [a, b];
}

export function sourceFrom(value: unknown, name: string): PointSource {
  const source = objectOf(value, name);
  for (const kind of ['tie_point', 'ground_control', 'manual'] as const) {
    if (source[kind] !== undefined) return { [kind]: likeOf(source[kind], 0, `${name}.${kind}`) } as PointSource;
  }
  throw new Error(say('the-field-is-damaged', { name }));
}

export function placeFrom(value: unknown, name: string): Required<HandMeasurement> {
  const { image, x_px, y_px, by } = objectOf(value, name);
  return {
    image: likeOf(image, 0, `${name}.image`),
    x_px: likeOf(x_px, 0, `${name}.x_px`),
    y_px: likeOf(y_px, 0, `${name}.y_px`),
    by: by === 'least_squares' ? by : 'hand',
  };
}
