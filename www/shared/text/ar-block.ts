/** The texts of the block, in Arabic. */
import block from './ar/block.ftl?raw';

export const TEXTS = [block];
