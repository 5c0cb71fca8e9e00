#!/usr/bin/env node
/** `npm run bench`: the project's figures, measured now. Names of parts run these alone: `npm run bench -- strategies calibration statistics default loops totals presets verdict accuracy speed features geometry rivals refinement sizes workers map edit lighthouse page blocks orthophoto orthophoto-reference large-orthophoto geotiffs components rendered memory former kills crashes`. */

/** @type {Record<string, () => Promise<void>>} */
const PARTS = {
  strategies: async () => (await import('./bench/strategies.mjs')).strategies(),
  calibration: async () => (await import('./bench/calibration.mjs')).calibration(),
  default: async () => (await import('./bench/default.mjs')).byDefault(),
  loops: async () => (await import('./bench/loops.mjs')).loops(),
  totals: async () => (await import('./bench/totals.mjs')).totals(),
  presets: async () => (await import('./bench/presets.mjs')).presets(),
  verdict: async () => (await import('./bench/verdict.mjs')).verdict(),
  statistics: async () => (await import('./bench/statistics.mjs')).statistics(),
  accuracy: async () => (await import('./bench/accuracy.mjs')).accuracy(),
  speed: async () => (await import('./bench/speed.mjs')).speed(),
  features: async () => (await import('./bench/features.mjs')).featureBench(),
  geometry: async () => (await import('./bench/geometry.mjs')).geometry(),
  rivals: async () => (await import('./bench/rivals.mjs')).rivals(),
  refinement: async () => (await import('./bench/refinement.mjs')).refinementBench(),
  sizes: async () => (await import('./bench/sizes.mjs')).sizesOfAll(),
  workers: async () => (await import('./bench/workers.mjs')).workers(),
  map: async () => (await import('./bench/map.mjs')).map(),
  edit: async () => (await import('./bench/edit.mjs')).edit(),
  lighthouse: async () => (await import('./bench/lighthouse.mjs')).lighthouse(),
  page: async () => (await import('./bench/page.mjs')).page(),
  blocks: async () => (await import('./bench/blocks.mjs')).blocks(),
  orthophoto: async () => (await import('./bench/orthophoto.mjs')).orthophoto(),
  'orthophoto-reference': async () => (await import('./bench/orthophoto-reference.mjs')).orthophotoReference(),
  'large-orthophoto': async () => (await import('./bench/large-orthophoto.mjs')).largeOrthophoto(),
  geotiffs: async () => (await import('./bench/geotiffs.mjs')).geotiffs(),
  components: async () => (await import('./bench/components.mjs')).components(),
  rendered: async () => (await import('./bench/rendered.mjs')).rendered(),
  memory: async () => (await import('./bench/memory.mjs')).memory(),
  former: async () => (await import('./bench/former.mjs')).former(),
  kills: async () => (await import('./bench/kills.mjs')).kills(),
  crashes: async () => (await import('./bench/crashes.mjs')).crashes(),
};

if (process.argv.includes('--help')) {
  console.log(`parts: ${Object.keys(PARTS).join(' ')}; all of them where none is named, which takes hours`);
  process.exit(0);
}
const named = process.argv.slice(2).filter((part) => !part.startsWith('--'));
const stranger = named.find((part) => !(part in PARTS));
if (stranger) {
  console.error(`there is no part ${stranger}; allowed: ${Object.keys(PARTS).join(', ')}`);
  process.exit(2);
}
for (const [name, part] of Object.entries(PARTS)) {
  if (named.length === 0 || named.includes(name)) await part();
}
