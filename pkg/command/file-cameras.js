// @ts-check
/** The cameras that the files of a pair name. */

import { withText } from '../messages.js';
import { message } from '../node.js';
import { fixed, significant } from './text.js';

/** @typedef {import('../node.js').ExifCamera | null} FileCamera */

/** The JSON form.  @param {readonly FileCamera[]} cameras */
export const fileCamerasOf = (cameras) =>
  cameras.map((camera) => camera && { ...camera, cautions: (camera.cautions ?? []).map((caution) => withText('camera_caution', caution)) });

/** In text: where each camera is known from, and what speaks against it.  @param {readonly string[]} names @param {readonly FileCamera[]} cameras @returns {string[]} */
export function describeFileCameras(names, cameras) {
  return cameras.flatMap((camera, k) => {
    if (camera === null) return [];
    const cautions = (camera.cautions ?? []).map((caution) => `caution, ${names[k]}: ${message('camera_caution', caution)}`);
    if (camera.origin === 'panorama') return cautions;
    return [`camera of ${names[k]}: ${nameOf(camera)}${focalOf(camera)}, from ${message('camera_origin', camera.origin ?? 'exif_focal_plane')}`, ...cautions];
  });
}

/** Many makers repeat their name in the model's.  @param {NonNullable<FileCamera>} camera */
function nameOf({ make, model }) {
  const maker = make != null && model?.startsWith(make) === true ? null : make;
  return [maker, model]
    .filter((part) => part != null)
    .map((part) => `${part} `)
    .join('');
}

/** @param {NonNullable<FileCamera>} camera */
const focalOf = ({ focal_mm: focal, pixel_mm: pixel }) => (pixel == null ? `${significant(focal)} mm` : `${fixed(focal / pixel, 1)} px`);
