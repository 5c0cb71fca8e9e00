/** The texts of the program without its block, in Arabic, and those of the crate's options. */
import options from '../../../src/catalogue/ar-options.ftl?raw';
import pair from './ar/pair.ftl?raw';
import shared from './ar/shared.ftl?raw';

export const TEXTS = [shared, pair, options];
