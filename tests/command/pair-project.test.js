/** The project file that `match --out` writes: it holds all that the command said of the pair. */

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { describe, resultOf } from '../../pkg/command/match.js';
import { scoreOf } from '../../pkg/command/truth.js';
import { FinishedBlock, open_pair_project, project_kind, write_pair_project } from '../../pkg/node.js';
import { folder, image, samplePair, tiepoint } from './command.js';

const { at, call } = samplePair();
const [left = '', right = ''] = call.slice(1, 3);
const half = image(at, 'half.png', 450, 700, (col) => (col < 225 ? 0 : 255));
const flat = image(folder(), 'flat.png', 80, 60, () => 50);

/** A run of the command: what it printed, and the project that it wrote.  @param {string[]} args */
function run(...args) {
  const out = folder();
  const { code, stdout, stderr } = tiepoint(...args, '--out', out, '--json');
  assert.ok([0, 3, 4].includes(code ?? 1), stderr);
  const bytes = readFileSync(join(out, 'project.tiepoint'));
  return { result: JSON.parse(stdout), bytes, project: open_pair_project(bytes) };
}

for (const [name, ...args] of [
  ['oriented, with its truth', ...call, '--refine', 'least-squares'],
  ['with a mask, by gradients', ...call, '--strategy', 'gradient', '--mask-left', half],
  ['by gradients of unknown cameras', 'match', left, right, '--strategy', 'gradient'],
  ['without a camera', 'match', left, right, '--strategy', 'moments'],
  ['without a match', ...call, '--offset', '4000,0', '--strategy', 'moments'],
  ['of equal grey values', 'match', flat, flat, '--strategy', 'gradient', '--focal-px', '600'],
]) {
  test(`a pair that is opened says what the command said of it: ${name}`, () => {
    const { result, bytes, project } = run(...args);
    const { output, settings, truth } = project;
    const score = truth && scoreOf(output, truth, truth.score);
    // Through text, in which JSON has null for what is not finite.
    const opened = JSON.parse(
      JSON.stringify({
        ...resultOf(
          output,
          settings,
          project.images.map(({ camera }) => camera ?? null),
          result.hint,
        ),
        ...(score ? { score } : {}),
      }),
    );
    assert.deepEqual(opened, result);
    const files = { names: args.slice(1, 3), cameras: project.images.map(({ camera }) => camera ?? null) };
    assert.ok(tiepoint(...args).stdout.startsWith(describe(output, result.hint, project.input, files).join('\n')));
    assert.equal(write_pair_project(project), bytes.toString());
  });
}

test('a project names its images by file, digest, size and mask', () => {
  const { project } = run(...call, '--mask-left', half);
  const content = createHash('sha256').update(readFileSync(left)).digest('hex');
  assert.deepEqual(project.images[0], {
    name: 'left.png',
    content,
    width_px: 450,
    height_px: 700,
    format: 'PNG',
    bits_per_sample: 8,
    mask: 'half.png',
    camera: null,
  });
  assert.equal(project.images[1].mask, null);
  assert.ok(project.input.left?.fiducials?.length && project.input.camera);
});

test('the project of a pair is the same for any number of workers', () => {
  const texts = ['1', '3'].map((workers) => run(...call, '--strategy', 'gradient', '--workers', workers).bytes.toString());
  assert.equal(texts[0], texts[1]);
});

test('a project of a pair is no block, and one of a block no pair', () => {
  const { bytes } = run('match', left, right);
  assert.equal(project_kind(bytes.subarray(0, 1024)), 'pair');
  assert.throws(() => FinishedBlock.open(bytes), /project file .*holds a pair/);
  const older = readFileSync(new URL('../project/version-1.tiepoint', import.meta.url));
  assert.equal(project_kind(older), 'block');
  assert.throws(() => open_pair_project(older), /project file .*holds a block/);
  FinishedBlock.open(older).free();
  assert.equal(project_kind(Buffer.from('no project')), null);
});

test('a pair that does not fit together is refused', () => {
  const { project } = run(...call);
  const { output } = project;
  const changed = { ...project, output: { ...output, match: { ...output.match, rules: output.match.rules.subarray(1) } } };
  assert.throws(() => write_pair_project(changed), { name: 'TiepointError', code: 'invalid-input' });
});
