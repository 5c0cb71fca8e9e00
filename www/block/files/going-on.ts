/** A run that ended with its tab goes on by itself when its block is opened again. */
import type { Kept } from '../../shared/files/database';
import { likeOf, objectOf } from '../../shared/files/keepable';
import type { BlockEngine, BlockStore } from '../engine/engine';

const RUNNING = 'block/running';
const BYTES = 64;

/** Keeps that a run is under way, as long as it is. */
export class RunUnderWay {
  /** Null while nothing runs. */
  private kept: { records: number } | null = null;

  constructor(store: BlockStore, engine: BlockEngine) {
    store.watch(
      (s) => [s.running.kind === 'yes'] as const,
      ([runs]) => {
        this.kept = runs ? { records: engine.records.size } : null;
      },
    );
  }

  parts(): readonly (readonly [string, Kept])[] {
    return this.kept === null ? [] : [[RUNNING, { value: this.kept, bytes: BYTES }]];
  }
}

/** Whether a run was under way that had made some of these records. One that ended its tab before it made any would end the next one, too: it waits. */
export function goesOn(parts: ReadonlyMap<string, unknown>, records: number): boolean {
  return parts.has(RUNNING) && likeOf(objectOf(parts.get(RUNNING), 'running').records, 0, 'running.records') < records;
}
