/** How the command is called: help, exit codes, and one line that says what to change. */

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { closeSync, existsSync, mkdirSync, openSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { caller } from './called.js';
import { asProcess, file, folder, image, json, PROGRAM, samplePair, speckle, tiepoint } from './command.js';

const at = folder();
const picture = image(at, 'speckle.png', 64, 48, speckle);

/** @param {number} code @param {RegExp} line @param {string[]} args */
function refuses(code, line, ...args) {
  const ended = tiepoint(...args);
  assert.equal(ended.code, code, `exit code of tiepoint ${args.join(' ')}: ${ended.stderr}`);
  assert.equal(ended.stdout, '', 'nothing on stdout');
  assert.match(ended.stderr, /^tiepoint: [^\n]+\n$/, 'one line on stderr');
  assert.match(ended.stderr, line);
}

test('help names every command, and every command tells its options', () => {
  const { code, stdout } = tiepoint('help');
  assert.equal(code, 0);
  assert.match(stdout, /of match, orient, report, block, edit and place\nalso 3 done with a weak orientation, 4 done without one\./);
  const named = [...stdout.matchAll(/^ {2}([a-z]+) {2,}/gm)].map(([, name = '']) => name);
  assert.ok(named.length === 16 && named.includes('points') && named.includes('epipolar'), named.join(' '));
  for (const name of named) {
    const help = tiepoint(name, '--help');
    assert.equal(help.code, 0);
    assert.match(help.stdout, /--json/);
    assert.equal(help.stdout, tiepoint('help', name).stdout);
  }
  assert.match(tiepoint('match', '--help').stdout, /--search PX\n.*\n?.*allowed: odd whole numbers from 1 to 1023; default: 25/s);
});

test('a process of its own gives what a call within the tests gives, whatever the exit code', () => {
  const { at: pair, call } = samplePair();
  const calls = [['--version'], ['help', 'match'], ['matsch'], ['points', join(pair, 'none.png')], call, ['match', picture, picture, '--json']];
  const ended = calls.map((args) => asProcess(...args));
  assert.deepEqual(
    ended.map(({ code }) => code),
    [0, 0, 2, 1, 0, 4],
  );
  assert.deepEqual(
    calls.map((args) => tiepoint(...args)),
    ended,
  );
});

test('what a call leaves to break is its own failure, and the next call gets its own answer', () => {
  // Breaks at once, later, and by the exception of a timer.
  const main = `export async function main([name, ms]) {
    process.stdout.write(name);
    if (name === 'rejects') Promise.reject(new Error('left behind'));
    if (name === 'throws') setTimeout(() => { throw new Error('too late'); });
    if (name === 'waits') await new Promise((resolve) => setTimeout(resolve, Number(ms)));
    return 0;
  }`;
  const call = caller(PROGRAM, `data:text/javascript,${encodeURIComponent(main)}`);
  assert.deepEqual(call(['first']), { code: 0, stdout: 'first', stderr: '' });
  const broken = call(['rejects']);
  assert.deepEqual([broken.code, broken.stdout], [1, 'rejects']);
  assert.match(broken.stderr, /left behind/);
  assert.deepEqual(call(['second']), { code: 0, stdout: 'second', stderr: '' });
  // A call that was answered before is the next one's failure at the latest.
  const both = [call(['throws']), call(['waits', '50'])];
  assert.equal(
    both.map(({ code }) => code).reduce((sum, code) => Number(sum) + Number(code)),
    1,
  );
  assert.match(both.map(({ stderr }) => stderr).join(''), /too late/);
  assert.deepEqual(call(['third']), { code: 0, stdout: 'third', stderr: '' });
});

test('one version everywhere', () => {
  const { stdout } = asProcess('--version');
  const packageVersion = JSON.parse(readFileSync(new URL('../../pkg/package.json', import.meta.url), 'utf8')).version;
  const crateVersion = /^version = "(.+)"$/m.exec(readFileSync(new URL('../../Cargo.toml', import.meta.url), 'utf8'))?.[1];
  assert.deepEqual([stdout.trim(), packageVersion], [crateVersion, crateVersion]);
});

test('a bad call exits with 2 and names what is allowed', () => {
  refuses(2, /name a command: points, match/);
  refuses(2, /no command matsch; did you mean match\?/, 'matsch');
  refuses(2, /no command xyzzy; allowed: points/, 'xyzzy');
  refuses(2, /IMAGE is missing: tiepoint points IMAGE/, 'points');
  refuses(2, /RIGHT is missing/, 'match', picture);
  refuses(2, /b\.png is one argument too many/, 'points', picture, 'b.png');
  refuses(2, /no option --treshold; did you mean --threshold\?/, 'points', picture, '--treshold', '40');
  refuses(2, /no option --frobnicate; see tiepoint points --help/, 'points', picture, '--frobnicate', '40');
  refuses(2, /--threshold needs a value/, 'points', picture, '--threshold');
  refuses(2, /--threshold is forty; allowed: a number/, 'points', picture, '--threshold', 'forty');
  refuses(2, /--threshold is NaN; allowed: a number/, 'points', picture, '--threshold', 'NaN');
  refuses(2, /--threshold is Infinity; allowed: a number/, 'points', picture, '--threshold=Infinity');
  refuses(2, /--threshold is empty; allowed: a number/, 'points', picture, '--threshold=');
  refuses(2, /--threshold is given twice/, 'points', picture, '--threshold', '40', '--threshold', '41');
  refuses(2, /--json takes no value/, 'points', picture, '--json=yes');
  refuses(2, /--operator is ground3; allowed: .*did you mean ground/, 'points', picture, '--operator', 'ground3');
  refuses(2, /--suppress is 4; allowed: odd whole numbers/, 'points', picture, '--suppress', '4');
  refuses(2, /--fraction is 1.5; allowed/, 'points', picture, '--fraction', '1.5');
  refuses(2, /--roundness is -1; allowed/, 'points', picture, '--roundness', '-1');
  refuses(2, /--threshold.*--fraction|--fraction.*--threshold/, 'points', picture, '--threshold', '40', '--fraction', '0.1');
  refuses(2, /--search is 24; allowed: odd whole numbers from 1 to 1023/, 'match', picture, picture, '--search', '24');
  refuses(2, /--window is 10; allowed: odd/, 'match', picture, picture, '--window', '10');
  refuses(2, /--ambiguity is 2; allowed: 0 to 1/, 'match', picture, picture, '--ambiguity', '2');
  refuses(2, /--offset is 3; allowed: two numbers/, 'match', picture, picture, '--offset', '3');
  refuses(2, /--left-fiducials needs --right-fiducials/, 'match', picture, picture, '--left-fiducials', 'f.csv');
  refuses(2, /--left-origin needs --left-fiducials/, 'match', picture, picture, '--left-origin', '1,2');
  refuses(2, /--at is missing/, 'moments', picture);
  refuses(2, /--at is -1,3; allowed/, 'moments', picture, '--at', '-1,3');
  refuses(2, /--brightness is sun; allowed: .*did you mean sum/, 'moments', picture, '--at', '20,20', '--brightness', 'sun');
  refuses(2, /--model is afine; allowed: affine, similarity/, 'interior', 'f.csv', '--model', 'afine');
  refuses(2, /--focal-mm is missing/, 'orient', 'o.csv', '--base-mm', '92');
  refuses(2, /--focal-mm is 0; allowed: 0\.001 to 100000/, 'orient', 'o.csv', '--focal-mm', '0', '--base-mm', '92');
  refuses(2, /--out is missing/, 'sample');
  refuses(2, /--seed is 1.5; allowed: whole numbers/, 'sample', '--out', at, '--seed', '1.5');
});

test('bad data exits with 1 and names the file', () => {
  const missing = join(at, 'missing.png');
  refuses(1, /cannot read .*missing\.png: there is no such file/, 'points', missing);
  refuses(1, /cannot read .*: it is a folder/, 'points', at);
  refuses(1, /notes\.png: this kind of file is not supported; allowed: JPEG/, 'points', file(at, 'notes.png', 'no image at all'));
  refuses(1, /empty\.png: /, 'points', file(at, 'empty.png', ''));
  refuses(1, /cut\.png: the image cannot be read/, 'points', file(at, 'cut.png', readFileSync(picture).subarray(0, 400)));
  refuses(
    1,
    /pixel\.png|needs at least/,
    'points',
    image(at, 'pixel.png', 1, 1, () => 7),
  );
  refuses(1, /camera\.json: /, 'match', picture, picture, '--camera', file(at, 'camera.json', '{"focal_mm": "long"}'));
  const ofBlock = file(at, 'cameras.json', '{"cameras": [{"images": "a*", "focal_px": 1500}, {"focal_px": 900}]}');
  refuses(
    1,
    /cameras\.json: the camera of a pair: got 2 cameras of a block, by the names of their images; allowed: one camera/,
    'match',
    picture,
    picture,
    '--camera',
    ofBlock,
  );
  refuses(1, /camera2\.json: .*focal_length/, 'match', picture, picture, '--camera', file(at, 'camera2.json', '{"focal_mm": 153, "focal_length": 1}'));
  refuses(1, /marks\.csv: /, 'interior', file(at, 'marks.csv', 'col,row,x_mm,y_mm\n1,2,3\n'));
  refuses(1, /few\.csv: /, 'interior', file(at, 'few.csv', 'col,row,x_mm,y_mm\n1,2,3,4\n'));
  refuses(1, /obs\.csv: /, 'orient', file(at, 'obs.csv', 'x_left_mm,y_left_mm,x_right_mm,y_right_mm\n1,2,3,NaN\n'), '--focal-mm', '153', '--base-mm', '92');
  refuses(
    1,
    /constant/,
    'moments',
    image(at, 'flat.png', 32, 32, () => 9),
    '--at',
    '16,16',
  );
  refuses(1, /leaves the image/, 'moments', picture, '--at', '2,2');
});

test('a header that declares too much is refused before it is decoded', () => {
  const bytes = Buffer.from(readFileSync(picture));
  bytes.writeUInt32BE(60000, 16);
  bytes.writeUInt32BE(60000, 20);
  const huge = file(at, 'huge.png', bytes);
  refuses(1, /huge\.png: /, 'points', huge);
});

test('a folder that cannot be written to is named before the work starts', () => {
  const taken = file(at, 'taken', 'a file');
  refuses(1, /cannot write to the folder .*taken/, 'match', picture, picture, '--out', taken);
  refuses(1, /cannot write to the folder .*taken/, 'sample', '--out', join(taken, 'below'));
  mkdirSync(join(at, 'left.png'), { recursive: true });
  refuses(1, /cannot write .*left\.png: it is a folder/, 'sample', '--out', at);
});

test('a folder that the system refuses to make is an error, not a search without end', { skip: !existsSync('/proc/self') && 'there is no /proc' }, () => {
  refuses(1, /cannot write to the folder \/proc\/nothing\/below: /, 'sample', '--out', '/proc/nothing/below');
});

test('folders are made with all that is missing above them', () => {
  const out = join(at, 'made', 'by', 'parts');
  const { code, stderr } = tiepoint('simulate', '--out', `${out}/.`, '--width-px', '40', '--height-px', '40');
  assert.deepEqual([code, stderr], [0, '']);
  assert.ok(existsSync(join(out, 'truth.json')));
});

test('output that cannot be written is told in one line', { skip: !existsSync('/dev/full') && 'there is no /dev/full' }, () => {
  const full = openSync('/dev/full', 'w');
  const { status, stderr } = spawnSync(process.execPath, [PROGRAM, 'points', picture, '--json'], { encoding: 'utf8', stdio: ['ignore', full, 'pipe'] });
  closeSync(full);
  assert.deepEqual([status, stderr], [1, 'tiepoint: cannot write the output: the disk is full\n']);
});

test('help names a unit only where the value is given in it', () => {
  const help = tiepoint('simulate', '--help').stdout;
  assert.match(help, /--distortion N\n[\s\S]*?Its unit is mm⁻²/);
  assert.match(help, /--offset-grey GREY\n/);
  assert.match(help, /--kappa-deg DEG\n/);
});

test('values may start with a minus sign or follow an equals sign', () => {
  const { offset_px: offset } = json('match', picture, picture, '--offset', '-3,-4.5');
  assert.deepEqual(offset, [-3, -4.5]);
  assert.deepEqual(json('match', picture, picture, '--offset=-3,2').offset_px, [-3, 2]);
});

test('a reader that stops early is no error, and a pipe gets no progress bar', async () => {
  const child = spawn(process.execPath, [PROGRAM, 'points', image(at, 'large.png', 600, 600, speckle), '--json', '--suppress', '1']);
  let errors = '';
  child.stderr.on('data', (chunk) => {
    errors += chunk;
  });
  child.stdout.once('data', () => child.stdout.destroy());
  const code = await new Promise((resolve) => {
    child.on('close', resolve);
  });
  assert.deepEqual([code, errors], [0, '']);
});
