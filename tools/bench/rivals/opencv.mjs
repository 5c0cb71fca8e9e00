/** What native OpenCV finds on the pairs, and the score of anybody's matches: both by the rivals' script, which is no part of the project. */

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { DATA, TARGET, readJson } from '../../lib/paths.mjs';

/** @typedef {import('./ours.mjs').Entry} Entry */
/** @typedef {{ case: string, a: string, b: string, matches: number, right: number | null, share: number | null, rotation_error_deg?: number, direction_error_deg?: number }} Score */

/** The rivals' script. */
export const PEERS = process.env.TIEPOINT_PEERS ?? join(dirname(DATA), 'peers', 'peers.py');
/** What is measured once and kept. */
const CACHES = join(TARGET, 'bench');

/** The reason why nothing can be told, if there is one.  @returns {string | null} */
export function missing() {
  if (!process.env.TIEPOINT_PYTHON) return 'TIEPOINT_PYTHON names no Python that has OpenCV';
  return existsSync(PEERS) ? null : `${PEERS} is not there (TIEPOINT_PEERS names its place)`;
}

/** @param {string[]} args @returns {string} what Python wrote */
function python(args) {
  const { status, stdout, stderr } = spawnSync(String(process.env.TIEPOINT_PYTHON), args, { maxBuffer: 1 << 28 });
  if (status !== 0) throw new Error(`the rivals' script did not run: ${stderr}`);
  return String(stdout);
}

/** The entries of a file of this name, measured where it is not there.  @param {string} name @param {boolean} fresh measures again @param {(file: string) => unknown} measure writes the file @returns {Promise<Entry[]>} */
export async function kept(name, fresh, measure) {
  const file = join(CACHES, `${name}.json`);
  if (fresh || !existsSync(file)) {
    mkdirSync(CACHES, { recursive: true });
    await measure(file);
  }
  return readJson(file);
}

/** OpenCV's SIFT on every pair: its default threshold of contrast, or one so low that it has as many points as ours.  @param {boolean} many @param {boolean} fresh */
export function nativeSift(many, fresh) {
  const program = `import sys
sys.path.insert(0, sys.argv[1])
import cv2, peers, json, pathlib
create = cv2.SIFT_create
${many ? 'cv2.SIFT_create = lambda points: create(points, contrastThreshold=0.005)' : ''}
pathlib.Path(sys.argv[3]).write_text(json.dumps(peers.run(pathlib.Path(sys.argv[2]), 10000)))`;
  return kept(many ? 'sift-many' : 'sift', fresh, (file) => python(['-c', program, dirname(PEERS), DATA, file]));
}

/** The figures of the entries, which are written to a result file of this name.  @param {string} name @param {Entry[]} entries @returns {Score[]} */
export function scores(name, entries) {
  const file = join(CACHES, `${name}-scored.json`);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, JSON.stringify(entries));
  const program = `import json, pathlib, sys
sys.path.insert(0, sys.argv[1])
import peers
print(json.dumps([peers.score_pair(pathlib.Path(sys.argv[2]) / e['case'], e) for e in json.load(open(sys.argv[3]))]))`;
  return JSON.parse(python(['-c', program, dirname(PEERS), DATA, file]));
}
