/** Simulated photographs for the tests of the page: rendered once for a build of the module, whatever files of tests need them. */

import { createHash } from 'node:crypto';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { BlockScene, grey_png, simulate } from '../../pkg/node.js';
import { PKG_WASM, TARGET } from '../../tools/lib/paths.mjs';

/** @typedef {{ name: string, bytes: Uint8Array }} Rendered */

/** What is rendered follows from the module alone. */
const OF_BUILD = join(
  TARGET,
  'rendered-photos',
  createHash('sha256')
    .update(readFileSync(join(PKG_WASM, 'tiepoint_bg.wasm')))
    .digest('hex')
    .slice(0, 16),
);

/** Files that are made once, by their description.  @param {object} description @param {() => Rendered[]} make @returns {Rendered[]} */
function once(description, make) {
  const folder = join(OF_BUILD, createHash('sha256').update(JSON.stringify(description)).digest('hex').slice(0, 16));
  try {
    return readdirSync(folder)
      .sort()
      .map((name) => ({ name, bytes: readFileSync(join(folder, name)) }));
  } catch {
    // Not rendered yet.
  }
  const made = make();
  mkdirSync(OF_BUILD, { recursive: true });
  const writing = mkdtempSync(join(OF_BUILD, 'writing-'));
  for (const { name, bytes } of made) writeFileSync(join(writing, name), bytes);
  try {
    renameSync(writing, folder);
  } catch {
    // Another file of tests was faster.
    rmSync(writing, { recursive: true });
  }
  return made;
}

/** Both photos of a flight over a synthetic scene: left.png, right.png.  @param {object} flight what differs from the sample */
export const pairPhotos = (flight) =>
  once({ pair: flight }, () => {
    const pair = simulate(flight);
    return /** @type {const} */ (['left', 'right']).map((side) => ({
      name: `${side}.png`,
      bytes: grey_png(pair[side].width, pair[side].height, pair[side].grey),
    }));
  });

/** All photos of a block, as the page writes them when it simulates it.  @param {object} flight */
export const blockPhotos = (flight) =>
  once({ block: flight }, () => {
    const scene = new BlockScene(flight);
    const made = scene.truth().images.map(({ name }, index) => ({ name: `${name}.png`, bytes: scene.photo_file(index) }));
    scene.free();
    return made;
  });

/** The orthophoto of a block's scene with pixels of so many m, and the heights of its ground.  @param {object} flight @param {number} gsd */
export const blockGround = (flight, gsd) =>
  once({ ground: flight, gsd }, () => {
    const scene = new BlockScene(flight);
    const { picture, heights } = scene.orthophoto(gsd);
    scene.free();
    // Sorted by name, as they are read again.
    return [
      { name: 'heights.tif', bytes: heights },
      { name: 'orthophoto.tif', bytes: picture },
    ];
  });

/** The first photos of a block without anything but their pixels: photo_0.png …  @param {object} flight @param {number} count */
export const barePhotos = (flight, count) =>
  once({ bare: flight, count }, () => {
    const scene = new BlockScene(flight);
    const made = Array.from({ length: count }, (_, index) => {
      const { width, height, grey } = scene.photo(index);
      return { name: `photo_${index}.png`, bytes: grey_png(width, height, grey) };
    });
    scene.free();
    return made;
  });
