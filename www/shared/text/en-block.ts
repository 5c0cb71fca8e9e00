/** The texts of the block, in English. */
import block from './en/block.ftl?raw';

export const TEXTS = [block];
