/** Which part of the page is shown: the pair or the block. */
import { Holder } from './store';

export type Mode = 'pair' | 'block';

export type Modes = Holder<{ mode: Mode }, Mode>;

export function isMode(text: string): text is Mode {
  return text === 'pair' || text === 'block';
}

export function makeModes(): Modes {
  return new Holder<{ mode: Mode }, Mode>({ mode: 'pair' }, (_, mode) => ({ mode }));
}
