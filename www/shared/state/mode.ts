/** Which part of the page is shown: the pair or the block. */
import { Holder } from './store';

export type Mode = 'pair' | 'block';

/** `isKept`: it came with a project that the browser kept, and nobody chose it. */
export type Modes = Holder<{ mode: Mode; isKept: boolean }, Mode | { kept: Mode }>;

export function isMode(text: string): text is Mode {
  return text === 'pair' || text === 'block';
}

export function makeModes(): Modes {
  const first: Modes['state'] = { mode: 'pair', isKept: true };
  return new Holder(first, (_, to: Mode | { kept: Mode }) => (typeof to === 'string' ? { mode: to, isKept: false } : { mode: to.kept, isKept: true }));
}
