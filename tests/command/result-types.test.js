/** Real results fit the types that the package declares of them, under the strict compiler: absent fields are optional, and there is none beside them. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import {
  call_parameters,
  FinishedBlock,
  grey_png,
  match_pair,
  open_pair_project,
  orient_fiducials,
  Photo,
  simulate,
  write_pair_project,
} from '../../pkg/node.js';
import { photographed } from './blocks.js';
import { file, folder, json } from './command.js';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const COMPILER = join(ROOT, 'node_modules/typescript/bin/tsc');
const SKIP = existsSync(COMPILER) ? false : 'the npm packages are not set up';

/** Of a long list so many stand for all, from its start and its end. */
const SHOWN = 20;

/** A value as a program writes it; of typed arrays and long texts their kind alone counts.  @param {unknown} value @returns {string} */
function literal(value) {
  if (ArrayBuffer.isView(value)) return `new ${value.constructor.name}(0)`;
  if (typeof value === 'string') return JSON.stringify(value);
  if (Array.isArray(value)) return `[${(value.length > 2 * SHOWN ? [...value.slice(0, SHOWN), ...value.slice(-SHOWN)] : value).map(literal).join(', ')}]`;
  if (typeof value !== 'object' || value === null) return String(value);
  const fields = Object.entries(value).map(([name, field]) => `${JSON.stringify(name)}: ${literal(field)}`);
  return `{ ${fields.join(', ')} }`;
}

/** What the compiler says of values of these types.  @param {readonly (readonly [string, unknown])[]} values */
function said(values) {
  const home = folder();
  mkdirSync(join(home, 'node_modules'));
  symlinkSync(join(ROOT, 'pkg'), join(home, 'node_modules/tiepoint'), 'junction');
  file(home, 'package.json', '{ "private": true, "type": "module" }');
  const program = values.map(([type, value], index) => `export const value${index}: tiepoint.${type} = ${literal(value)};`);
  file(home, 'program.ts', ["import type * as tiepoint from 'tiepoint';", ...program].join('\n'));
  const compilerOptions = {
    target: 'es2022',
    lib: ['es2022'],
    module: 'nodenext',
    types: [],
    strict: true,
    exactOptionalPropertyTypes: true,
    noEmit: true,
    preserveSymlinks: true,
  };
  file(home, 'tsconfig.json', JSON.stringify({ compilerOptions, files: ['program.ts'] }));
  return spawnSync(process.execPath, [COMPILER, '-p', home, '--pretty', 'false'], { encoding: 'utf8' }).stdout;
}

/** @param {FinishedBlock} block @returns {[string, unknown][]} */
const ofBlock = (block) => [
  ['BlockModel', block.model()],
  ['PointSource[]', block.point_ids()],
  ['PointDetail', block.point(0)],
  ['BlockEdit[]', block.edits()],
  ['BlockPlaces', block.places()],
];

test('summaries and models of blocks, with what may be absent and without it', { skip: SKIP }, () => {
  const { call, truthFile } = photographed();
  const runs = [
    ['--refine', 'none'],
    ['--gnss-errors', 'strip-drifts', '--truth', truthFile],
  ].map((options) => {
    const out = folder();
    const summary = json(...call, ...options, '--out', out);
    return { summary, block: FinishedBlock.open(readFileSync(join(out, 'project.tiepoint'))) };
  });
  const [plain, full] = runs.map(({ summary }) => summary);
  assert.deepEqual([plain.refinement, 'systematic' in plain.orientation.models[0], 'score' in plain], [null, false, false]);
  assert.ok(full.orientation.models[0].systematic.length > 0 && 'no_texture' in full.refinement.kept && 'score' in full);
  assert.equal(said(runs.flatMap(({ summary, block }) => /** @type {[string, unknown][]} */ ([['Summary', summary], ...ofBlock(block)]))), '');
});

test('results of pairs, of every strategy, with a camera and without', { skip: SKIP }, () => {
  const pair = simulate({});
  const [left, right] = /** @type {const} */ (['left', 'right']).map((side) => Photo.from_grey(pair[side].width, pair[side].height, pair[side].grey));
  if (!left || !right) throw new Error('a pair has two photos');
  const input = {
    camera: pair.camera,
    left: { fiducials: pair.left_fiducials, origin: pair.left_origin },
    right: { fiducials: pair.right_fiducials, origin: pair.right_origin },
  };
  const images = ['left', 'right'].map((name) => ({
    name,
    content: null,
    width_px: 450,
    height_px: 700,
    format: 'PNG',
    bits_per_sample: 8,
    mask: null,
    camera: null,
  }));
  const strategies = /** @type {const} */ (['moments', 'least-squares', 'gradient']);
  const outputs = strategies.map((strategy) => match_pair(left, right, input, { matching: { strategy } }));
  const [first, second] = images;
  if (!first || !second || !outputs[0]) throw new Error('a pair has two images');
  const project = write_pair_project({ images: [first, second], input, settings: {}, output: outputs[0], truth: null });
  const { width, height, grey } = pair.left;
  assert.equal(
    said([
      ['SamplePair', pair],
      ...outputs.map((output) => /** @type {const} */ (['PairOutput', output])),
      ['PairOutput', match_pair(left, right, {}, {})],
      ['PairOutput', match_pair(left, left, {}, {})],
      ['PairProject', open_pair_project(new TextEncoder().encode(project))],
      ['FiducialOrientation', orient_fiducials(pair.left_fiducials, 'similarity')],
      ['PhotoInfo', Photo.decode(grey_png(width, height, grey)).info()],
      ['DescribedPoints', left.describe_points({})],
      ['Parameter[]', call_parameters()],
    ]),
    '',
  );
});

test('a value that a type does not have is told', { skip: SKIP }, () => {
  assert.match(said([['ErrorCode', 'gone']]), /program\.ts\(2,/);
  assert.match(said([['ReducedImage', { width: 1, height: 1, halvings: 0, grey: new Uint8Array(0), more: 1 }]]), /program\.ts\(2,/);
});
