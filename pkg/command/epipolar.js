// @ts-check
import { createHash } from 'node:crypto';
import { join } from 'node:path';
import { EpipolarPair } from '../node.js';
import { about, DataError, UsageError } from './errors.js';
import { isFolder, makeFolder, readBytes, writeInto } from './files.js';
import { JSON_FLAG, path } from './options.js';
import { print, printJson } from './output.js';

/** @type {import('./args.js').Command} */
export const epipolar = {
  name: 'epipolar',
  summary: 'Epipolar images of an oriented pair: what both images show lies in the same row of either.',
  positionals: ['PROJECT', 'FOLDER'],
  options: [
    path('out', 'DIR', 'The folder for what is written; required.'),
    path('left', 'NAME', 'The left image; with --right. By default the one from which the base goes to the right.'),
    path('right', 'NAME', 'The right image; with --left.'),
    JSON_FLAG,
  ],
  details:
    'PROJECT is the project.tiepoint of a pair or a block, FOLDER that of its images. Of a block the two images with most points in common are taken, unless two are named; points whose rays are nearly parallel count less. It writes left.png and right.png, in the colours of their files, ' +
    'without distortion, of one size and focal length; anaglyph.png, both in one for red-cyan glasses; and epipolar.json, how they lie, with the residual y-parallax of the points that both show. JSON: files, and what epipolar.json holds.',
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals: [project = '', folder = ''], values }) {
  const [out, left, right] = [values.get('out'), values.get('left'), values.get('right')];
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder for what is written');
  if ((left === undefined) !== (right === undefined)) throw new UsageError('--left and --right belong together: name both images, or neither');
  if (!isFolder(folder)) throw new DataError(`${folder}: it is no folder; name that of the images`);
  const bytes = readBytes(project);
  const pair = about(project, () => EpipolarPair.open(bytes, typeof left === 'string' && typeof right === 'string' ? [left, right] : undefined));
  const paths = pair.names.map((name) => join(folder, name));
  const photos = paths.map((file, k) => {
    const photo = readBytes(file);
    const content = createHash('sha256').update(photo).digest('hex');
    if (pair.contents[k] !== null && pair.contents[k] !== content) throw new DataError(`${file}: it is another file than the ${pair.names[k]} of the project`);
    return photo;
  });
  const [ofLeft, ofRight] = photos;
  if (!ofLeft || !ofRight) throw new Error('a pair has two images');
  const files = about(paths.join(' and '), () => pair.resample_files(ofLeft, ofRight));
  makeFolder(out);
  /** @type {[string, string | Uint8Array][]} */
  const all = [
    ['left.png', files.left],
    ['right.png', files.right],
    ['anaglyph.png', files.anaglyph],
    ['epipolar.json', files.parameters],
  ];
  const written = all.map(([name, content]) => writeInto(out, name, content));
  if (values.has('json')) {
    printJson({ files: written, ...JSON.parse(files.parameters) });
    return 0;
  }
  const { width_px: width, height_px: height, parallaxes } = pair.geometry;
  const told = parallaxes && `; residual y-parallax of ${parallaxes.points} points: ${parallaxes.y_rms_px.toFixed(2)} px RMS`;
  print(...written.map((file) => `written: ${file}`), `${pair.names.join(' and ')}: ${width} x ${height} px${told ?? ''}`);
  return 0;
}
