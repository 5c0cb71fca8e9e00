// @ts-check
/** A block in the system of an orthophoto: its images are placed one after the other, then it is adjusted by what they show of its ground. */

import { BlockOnOrthophoto, message, placing_defaults, placing_parameters } from '../node.js';
import { UsageError } from './errors.js';
import { elsewhereOf, GROUND_OPTIONS, groundOf, NO_HEIGHTS, openReference, ORTHOPHOTO_HELP, placingOf } from './ground.js';
import { optionsOf, path } from './options.js';
import { note } from './output.js';
import { Progress } from './progress.js';

/**
 * @typedef {import('./args.js').Call['values']} Values
 * @typedef {import('../node.js').FinishedBlock} FinishedBlock
 * @typedef {import('../node.js').OrthophotoReference} OrthophotoReference
 */

/** A block has names of its own for some settings. */
const NAMES = { 'placing.points': 'orthophoto-points', 'placing.seed': 'orthophoto-seed' };

const OPTIONS = optionsOf(placing_parameters(), placing_defaults(), NAMES);

export const ORTHOPHOTO_OPTIONS = [
  path(
    'orthophoto',
    'FILE',
    `Georeferences the block by it, without a control point or beside those of --control, in its system or in that of --crs. ${ORTHOPHOTO_HELP} --heights or --level beside it.`,
  ),
  ...GROUND_OPTIONS,
  ...OPTIONS,
];

/** The orthophoto of a call, which the caller frees; null where none is named.  @param {Values} values @returns {OrthophotoReference | null} */
export function orthophotoOf(values) {
  const file = values.get('orthophoto');
  if (typeof file !== 'string') {
    const alone = ORTHOPHOTO_OPTIONS.find(({ name }) => values.has(name));
    if (alone) throw new UsageError(`--${alone.name} needs --orthophoto beside it`);
    return null;
  }
  const ground = groundOf(values);
  if (!ground) note(NO_HEIGHTS);
  return openReference(file, ground, placingOf(OPTIONS, values));
}

/** Says before anything is matched that the orthophoto is of elsewhere.  @param {OrthophotoReference} reference @param {readonly string[]} images @param {import('./ground.js').Given} given */
export function noteElsewhere(reference, images, given) {
  const doubt = elsewhereOf(reference, images, given);
  if (doubt) note(message('remark', doubt));
}

/**
 * The block in the system of an orthophoto, or as it was, with the reason.
 * @param {FinishedBlock} block which is freed @param {readonly import('../block/index.js').Source[]} sources @param {OrthophotoReference} reference
 * @returns {Promise<FinishedBlock>}
 */
export async function onOrthophoto(block, sources, reference) {
  const links = new BlockOnOrthophoto();
  const images = block.model().images;
  const shown = new Progress({ steps: images.length + 1 });
  try {
    for (const [index, { name, pose }] of images.entries()) {
      const source = sources.find((one) => one.name === name);
      if (!source || !pose) continue;
      const bytes = await source.bytes();
      shown.step(`placing ${name} on the orthophoto`, () => links.place(block, index, bytes, reference));
    }
    return shown.step('adjusting by the orthophoto', () => links.linked(block, reference));
  } finally {
    shown.end();
    links.free();
    block.free();
  }
}
