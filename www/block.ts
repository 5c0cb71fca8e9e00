/** The part of the block as the program loads it, when it is first needed. */
export { blockCatalogue } from './block/engine/catalogue';
export { mountBlock } from './block/mount';
export { masksOf, matchesOf, openPair } from './block/pair';
export { scansBeside } from './block/scans';
