// @ts-check
import { basename, join } from 'node:path';
import { block_flight_parameters, block_flight_preset, BlockScene } from '../node.js';
import { UsageError } from './errors.js';
import { makeFolder, removeUnfinished, replaceInto, writeInto } from './files.js';
import { DEFAULT_WORKERS, flag, JSON_FLAG, optionsOf, path, settingsOf, valueOption, WORKERS } from './options.js';
import { print, printJson } from './output.js';
import { ThreadPool } from './pool.js';
import { Progress } from './progress.js';
import { shellCommand } from './text.js';
import { timed } from '../block/timed.js';

/** @typedef {import('../node.js').BlockFlight} BlockFlight */

const DEFAULTS = block_flight_preset('photos');
const OPTIONS = optionsOf(block_flight_parameters(), DEFAULTS);

/** @type {import('./args.js').Command} */
export const simulateBlock = {
  name: 'simulate --block',
  summary: 'Flies over a synthetic scene in strips and writes a block of photos with GNSS positions, and the truth to compare with.',
  positionals: [],
  options: [
    flag('block', 'A block of photos, not a pair.'),
    path('out', 'DIR', 'Folder that receives the files; required.'),
    valueOption('gsd_m'),
    WORKERS,
    JSON_FLAG,
    ...OPTIONS,
  ],
  details:
    'Files: photos/photo_00000.png and so on, grey, with camera and GNSS position as EXIF; truth.json with the flight, the cameras and the exterior orientations: photo = M (X - X0), ' +
    'photo x right, y up; X east, north, up of the origin in m. JSON: photos, truth, and block, the command to try next as a list of words.',
  run,
};

/** @param {import('./args.js').Call} call */
async function run({ values }) {
  const out = values.get('out');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the files');
  const flight = settingsOf(OPTIONS, values, { ...DEFAULTS });
  const truth = truthOf(flight);
  makeFolder(out);
  removeUnfinished(out);
  const pool = new ThreadPool(Number(values.get('workers') ?? DEFAULT_WORKERS));
  const shown = new Progress({ quiet: values.has('json') });
  try {
    const step = timed(pool.size);
    const total = truth.images.length;
    let done = 0;
    const tell = (name = '') => shown.stage(step({ stage: 'photos', done, total, found: 0, name }));
    tell();
    const photos = await Promise.all(
      truth.images.map(async ({ name: file }, index) => {
        const name = `photos/${file}`;
        replaceInto(out, name, await pool.run('photo', { flight, index }));
        done += 1;
        tell(name);
        return join(out, name);
      }),
    );
    replaceInto(
      out,
      'truth.json',
      `${JSON.stringify({ convention: 'px: the centre of the top-left pixel at (0.5, 0.5); photo = M (X - X0), photo x right, y up, against the view', flight, block: truth }, null, 1)}\n`,
    );
    const gsd = values.get('orthophoto');
    const ground = typeof gsd === 'number' ? orthophoto(flight, gsd, out) : [];
    const [picture, heights] = ground;
    const onGround = picture && heights ? ['--orthophoto', picture, '--heights', heights] : [];
    const words = ['tiepoint', 'block', join(out, 'photos'), ...onGround, '--out', join(out, 'block'), '--truth', join(out, 'truth.json')];
    if (values.has('json')) printJson({ photos, truth: join(out, 'truth.json'), block: words, orthophoto: ground });
    else
      print(
        `written to ${out}: ${[`${photos.length} photos`, 'truth.json', ...ground.map((file) => basename(file))].join(', ')}`,
        '',
        'Try:',
        shellCommand(words),
      );
  } finally {
    shown.end();
    await pool.close();
  }
}

/** The orthophoto of a flight's scene and its heights: the files.  @param {BlockFlight} flight @param {number} gsd @param {string} out */
function orthophoto(flight, gsd, out) {
  const scene = new BlockScene(flight);
  try {
    const { picture, heights } = scene.orthophoto(gsd);
    return [writeInto(out, 'orthophoto.tif', picture), writeInto(out, 'heights.tif', heights)];
  } finally {
    scene.free();
  }
}

/** The truth, with the names of the files. A flight that cannot be flown is refused here.  @param {BlockFlight} flight */
function truthOf(flight) {
  const scene = new BlockScene(flight);
  const truth = scene.truth();
  scene.free();
  return { ...truth, images: truth.images.map((image) => ({ ...image, name: `${image.name}.png` })) };
}
