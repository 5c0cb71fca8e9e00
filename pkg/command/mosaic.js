// @ts-check
import { dirname, join } from 'node:path';
import { withText } from '../messages.js';
import { check_heights, message, OrthoMosaic } from '../node.js';
import { about, DataError, UsageError } from './errors.js';
import { filesIn, isFolder, makeFolder, readBytes, writeInParts } from './files.js';
import { GROUND_OPTIONS, groundOf } from './ground.js';
import { JSON_FLAG, path, valueOption } from './options.js';
import { note, print, printJson } from './output.js';
import { Progress } from './progress.js';

/** @type {import('./args.js').Command} */
export const mosaic = {
  name: 'mosaic',
  summary: 'A quick orthomosaic of an oriented block: a GeoTIFF in which each place is taken from the nearest image.',
  positionals: ['PROJECT', 'FOLDER'],
  options: [
    path('out', 'FILE.tif', 'The GeoTIFF that is written; required.'),
    path(
      'images',
      'NAMES',
      'Oriented images of the block by their names, with commas between, of which the mosaic is made: of one it is that image resampled to the ground. All without it.',
    ),
    valueOption('gsd'),
    ...GROUND_OPTIONS,
    JSON_FLAG,
  ],
  details:
    'PROJECT is the project.tiepoint of a block, FOLDER that of its images. Without heights the ground is that of the tie points. The mosaic has the colours of the images and at most 4000 MP, north up in the system of the block; its file is written tile by tile. Seams are not ' +
    'balanced, and walls may show twice: the mosaic is for checking an orientation, and a reference for `tiepoint place`. JSON: file, width_px, height_px, images (of which it is made), missing (that the folder has not), remark (on the heights or the coordinate system, or null).',
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals: [project = '', folder = ''], values }) {
  const [out, gsd, named] = [values.get('out'), values.get('gsd'), values.get('images')];
  const chosen = typeof named === 'string' ? named.split(',').filter(Boolean) : [];
  if (typeof named === 'string' && chosen.length === 0)
    throw new UsageError('--images names no image; allowed: names of oriented images of the block, with commas between');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the GeoTIFF that is written');
  if (isFolder(out)) throw new UsageError(`--out ${out}: it is a folder; name the GeoTIFF that is written`);
  if (!/\.tiff?$/iu.test(out)) throw new UsageError(`--out ${out}: it is no name of a GeoTIFF, which is written; allowed: names that end in .tif or .tiff`);
  if (!isFolder(folder)) throw new DataError(`${folder}: it is no folder; name that of the images`);
  const ground = groundOf(values);
  const bytes = readBytes(project);
  if (ground) about(ground.file ?? '--level', () => check_heights(ground.heights, ground.sidecars));
  const made = about(project, () =>
    OrthoMosaic.open(bytes, ground?.heights ?? null, ground?.sidecars, typeof gsd === 'number' ? gsd : undefined, false, chosen),
  );
  const [{ names }, remark] = [made, made.remark()];
  const wanted = chosen.length > 0 ? chosen : names;
  const files = new Set(filesIn(folder));
  const missing = wanted.filter((name) => !files.has(name));
  if (missing.length === wanted.length) throw new DataError(`${folder}: it has none of the images of the project, ${wanted.slice(0, 3).join(', ')} …`);
  if (missing.length > 0) note(`${folder} has not ${missing.join(', ')}: the mosaic is made of the others`);
  makeFolder(dirname(out));
  // In the order of the mosaic: the tiles that an image completes are written before the next one is read.
  const order = [...made.order()];
  const [width_px, height_px] = made.size();
  const shown = new Progress({ steps: order.length + 1 });
  writeInParts(out, (append) => {
    for (const index of order.filter((index) => !files.has(names[index] ?? ''))) append(made.leave_out(index));
    for (const index of order) {
      const name = names[index] ?? '';
      if (!files.has(name)) continue;
      const file = join(folder, name);
      shown.step(name, () => append(about(file, () => made.add(index, readBytes(file)))));
    }
    return shown.step('writing', () => {
      const { end, beginning } = made.finish();
      append(end);
      return beginning;
    });
  });
  shown.end();
  if (remark) note(message('remark', remark));
  if (values.has('json')) {
    const images = order.map((index) => names[index] ?? '').filter((name) => files.has(name));
    printJson({ file: out, width_px, height_px, images, missing, remark: remark ? withText('remark', remark) : null });
  } else print(`written: ${out}`);
  return 0;
}
