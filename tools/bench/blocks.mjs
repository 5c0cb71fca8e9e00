/** Blocks: real photographs beside COLMAP, simulated ones beside their truth, large ones by time and memory. */

import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { DATA, ROOT } from '../lib/paths.mjs';
import { run } from '../lib/process.mjs';
import { findChromium } from '../lib/setup.mjs';
import { servePage } from '../lib/page-server.mjs';
import { have } from './data.mjs';
import { example } from './example.mjs';
import { numberOption } from './options.mjs';
import { PYTHON, pythonLacks } from './python.mjs';

const NAME = 'block_caliterra';
const WORKERS = 2;

/** `cpu`: seconds of all processors, where they are known.  @typedef {{ seconds: number, cpu?: number, stages: Record<string, number>, oriented: number, rmsePx: number, centres: string }} Ours */

/** @param {number[]} values */
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;

export async function blocks() {
  if (have(NAME)) await besideColmap(numberOption('runs', 3));
  await examples(String(numberOption('seeds', 3)));
}

/** Each round runs the command, COLMAP and the page one after the other: all meet the same machine.  @param {number} rounds */
async function besideColmap(rounds) {
  const lacks = pythonLacks({ pycolmap: 'pycolmap' });
  if (lacks) console.log(`COLMAP: skipped: ${lacks}`);
  console.log(`${NAME}, ${WORKERS} workers or threads each, seconds from the files to the adjusted block (medians of ${rounds})`);
  const page = await pageOf();
  /** @type {{ command: Ours[], page: Ours[], colmap: { seconds: number, cpu: number, version: string, oriented: number, residual_px: number, centres: string }[] }} */
  const found = { command: [], page: [], colmap: [] };
  for (let round = 0; round < rounds; round += 1) {
    if (!lacks) {
      const { command, colmap } = JSON.parse(
        await jsonOf(PYTHON, [join(ROOT, 'tools/bench/block.py'), join(DATA, NAME), '--threads', String(WORKERS), '--runs', '1', '--json']),
      );
      found.command.push(command);
      found.colmap.push(colmap);
    } else found.command.push(await byCommand());
    if (page) found.page.push(await page.run());
  }
  await page?.close();
  const { colmap } = found;
  tell('command', found.command, colmap);
  if (page) tell('page in Chromium', found.page, colmap);
  const [first] = colmap;
  if (!first) return;
  console.log(
    `  COLMAP ${first.version}: ${median(colmap.map(({ seconds }) => seconds)).toFixed(1)}, processor ${median(colmap.map(({ cpu }) => cpu)).toFixed(1)}`,
  );
  console.log(`    ${first.oriented} oriented, mean residual ${first.residual_px.toFixed(3)} px, centres ${first.centres} from the reference`);
}

/** @param {string} name @param {Ours[]} runs @param {{ seconds: number, cpu: number }[]} colmap of the same rounds, or none */
function tell(name, runs, colmap) {
  const [{ stages, oriented, rmsePx, centres }] = /** @type {[Ours]} */ (runs);
  const parts = Object.keys(stages).map((stage) => `${stage} ${median(runs.map((one) => one.stages[stage] ?? NaN)).toFixed(1)}`);
  const cpu = runs.flatMap((one) => one.cpu ?? []);
  const spent = cpu.length > 0 ? `, processor ${median(cpu).toFixed(1)}` : '';
  console.log(`  ${name}: ${median(runs.map(({ seconds }) => seconds)).toFixed(1)}${spent} (${parts.join(', ')})`);
  if (colmap.length > 0) {
    const ratio = (/** @type {(one: { seconds: number, cpu?: number }) => number} */ of) =>
      median(runs.map((one, i) => of(one) / of(/** @type {Ours} */ (colmap[i])))).toFixed(3);
    console.log(`    ratio to COLMAP ${ratio(({ seconds }) => seconds)}${cpu.length > 0 ? `, of processor time ${ratio((one) => one.cpu ?? NaN)}` : ''}`);
  }
  console.log(`    ${oriented} oriented, RMSE ${rmsePx.toFixed(3)} px${centres ? `, centres ${centres} from the reference` : ''}`);
}

/** The last line that a program writes, which must succeed.  @param {string} program @param {string[]} args @returns {Promise<string>} */
async function jsonOf(program, args) {
  const { code, output } = await run(program, args, { quiet: true });
  if (code !== 0) throw new Error(`${program} ${args.join(' ')} ended with ${code}\n${output.slice(-2000)}`);
  return output.trimEnd().split('\n').at(-1) ?? '';
}

/** Without COLMAP, the command by itself.  @returns {Promise<Ours>} */
async function byCommand() {
  const out = mkdtempSync(join(tmpdir(), 'tiepoint-bench-'));
  try {
    const began = performance.now();
    const { output } = await run(process.execPath, [join(ROOT, 'pkg/bin/tiepoint.js'), 'block', join(DATA, NAME), '--out', out, '--workers', String(WORKERS)], {
      quiet: true,
    });
    const seconds = (performance.now() - began) / 1000;
    const { orientation } = JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8'));
    const stages = [...output.matchAll(/^([a-z ]+?)(?:: \d+.*)? in ([\d.]+) s$/gm)].map(([, name, s]) => [name, Number(s)]);
    return { seconds, stages: Object.fromEntries(stages), oriented: orientation.oriented, rmsePx: orientation.models[0].rmse_px, centres: '' };
  } finally {
    rmSync(out, { recursive: true });
  }
}

/** The page with two workers; null, and said so, where there is no Chromium. */
async function pageOf() {
  const executablePath = findChromium();
  if (!executablePath) {
    console.log('  page: skipped: no Chromium (install it or name it in CHROMIUM)');
    return null;
  }
  const server = await servePage();
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-quic', '--no-first-run'] });
  const files = readdirSync(join(DATA, NAME))
    .filter((name) => name.endsWith('.jpg'))
    .map((name) => join(DATA, NAME, name));
  /** @returns {Promise<Ours>} */
  const once = async () => {
    const context = await browser.newContext();
    await context.addInitScript(`Object.defineProperty(Navigator.prototype, 'hardwareConcurrency', { get: () => ${WORKERS} })`);
    // The clock starts with Run.
    await context.addInitScript("localStorage.setItem('tiepoint-wait', 'yes')");
    const tab = await context.newPage();
    const part = (/** @type {string} */ id) => tab.locator(`[data-testid="${id}"]`);
    await tab.goto(server.url);
    await part('mode-block').click();
    await tab.waitForFunction(() => document.querySelector('[data-testid="block-simulate"]')?.hasAttribute('disabled') === false);
    await part('block-files-input').setInputFiles(files);
    await tab.waitForFunction(() => /Press Run/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''));
    const began = performance.now();
    await part('block-run').click();
    await tab.waitForFunction(
      () => /^(Oriented|Weak orientation)|Kept:|not finished/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''),
      undefined,
      {
        timeout: 600_000,
      },
    );
    const seconds = (performance.now() - began) / 1000;
    const text = async (/** @type {string} */ id) => (await part(id).textContent()) ?? '';
    /** @type {Record<string, number>} */
    const stages = {};
    for (const stage of ['images', 'pairs', 'points', 'orientation']) stages[stage] = Number(/([\d.]+) s/.exec(await text(`stage-${stage}`))?.[1]);
    const ours = {
      seconds,
      stages,
      oriented: Number.parseInt(await text('block-oriented'), 10),
      rmsePx: Number.parseFloat(await text('block-rmse')),
      centres: '',
    };
    await context.close();
    return ours;
  };
  return {
    run: once,
    close: async () => {
      await browser.close();
      await server.close();
    },
  };
}

/** Blocks whose every answer is known, natively.  @param {string} seeds of each kind of block */
async function examples(seeds) {
  console.log('Simulated blocks beside their truth (native, one thread)');
  await example('block_truth', seeds);
  console.log('Wrong control points of simulated blocks (native, one thread)');
  await example('control_detection', seeds);
  console.log('Large simulated blocks (native, one thread): joining and orientation');
  await example('reconstruction_scale', '1000', '5000');
}
