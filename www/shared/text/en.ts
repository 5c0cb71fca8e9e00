/** The texts of the program without its block, in English. The crate has the texts of its options in English itself. */
import pair from './en/pair.ftl?raw';
import shared from './en/shared.ftl?raw';

export const TEXTS = [shared, pair];
