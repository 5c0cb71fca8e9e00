/** How the project of this tab is kept, and what stands in the way. */
import { Holder } from './store';

/**
 * What stands in the way of keeping. `project`: the one that it is about, with its title. `no-room`: the storage is full, and has all that is on the page;
 * `closed`: it was closed and cannot be opened again; `cleared`: what it had was deleted and cannot be written again.
 */
export interface Trouble {
  kind: 'absent' | 'no-room' | 'full' | 'failed' | 'closed' | 'cleared' | 'elsewhere' | 'reading' | 'taken' | 'unreadable' | 'broke-off';
  reason: string;
  project: { id: string; title: string } | null;
}

/** Where one of these stands in the way what is on the page is not kept; the others are about another project. */
const NOT_KEPT: readonly Trouble['kind'][] = ['absent', 'full', 'failed', 'closed', 'cleared', 'reading', 'taken'];

/** These are over as soon as something is written again. */
const UNTIL_WRITTEN: readonly Trouble['kind'][] = ['no-room', 'full', 'failed', 'closed', 'cleared'];

export interface Keeping {
  /** The project of this tab. */
  project: string;
  name: string | null;
  trouble: Trouble | null;
  /** Whether the browser keeps anything. */
  works: boolean;
  /** The title of the project that a start is reading. */
  opening: string | null;
}

export type KeepingState = Holder<Keeping, Partial<Keeping>>;

export function makeKeeping(): KeepingState {
  const none: Keeping = { project: '', name: null, trouble: null, works: false, opening: null };
  return new Holder(none, (state, changed: Partial<Keeping>) => ({ ...state, ...changed }));
}

/** Whether what is on the page is kept. */
export function isKept({ works, trouble }: Keeping): boolean {
  return works && (trouble === null || !NOT_KEPT.includes(trouble.kind));
}

/** Whether what stood in the way is over when something was written. */
export function endsWhenWritten({ trouble }: Keeping): boolean {
  return trouble !== null && UNTIL_WRITTEN.includes(trouble.kind);
}
