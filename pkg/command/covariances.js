// @ts-check
import { basename, dirname } from 'node:path';
import { FinishedBlock } from '../node.js';
import { about, UsageError } from './errors.js';
import { makeFolder, readBytes, writeInto } from './files.js';
import { JSON_FLAG, path } from './options.js';
import { print, printJson } from './output.js';

/** @type {import('./args.js').Command} */
export const covariances = {
  name: 'covariances',
  summary: 'Writes the covariances of chosen images, points and cameras of an oriented block, and between all of them.',
  positionals: ['PROJECT'],
  options: [
    path(
      'of',
      'NAMES',
      'Images, ground control points and check points by their names, point:N as in points.csv, camera:N as in images.csv, with commas between; or all; required.',
    ),
    path('out', 'FILE.csv', 'The table that is written; required.'),
    JSON_FLAG,
  ],
  details:
    'PROJECT is the project.tiepoint of a block. Each row is an unknown with its unit, adjusted value and standard error, then its covariances with all others, whose unit is the product of both units. ' +
    'They account for all that the printed standard errors account for, with respect to the same datum. A matrix has at most 2,000 unknowns: six per image, three per point. JSON: file, unknowns (their number).',
  run({ positionals: [project = ''], values }) {
    const [of, out] = [values.get('of'), values.get('out')];
    if (typeof of !== 'string') throw new UsageError('--of is missing: name images, points or cameras, with commas between, or all');
    if (typeof out !== 'string') throw new UsageError('--out is missing: name the file that receives the table');
    const text = about(project, () => FinishedBlock.open(readBytes(project)).covariances(of.split(',').filter(Boolean)));
    makeFolder(dirname(out));
    const file = writeInto(dirname(out), basename(out), text);
    // Each row below the head is an unknown.
    if (values.has('json')) printJson({ file, unknowns: text.trimEnd().split('\n').length - 1 });
    else print(`written: ${file}`);
  },
};
