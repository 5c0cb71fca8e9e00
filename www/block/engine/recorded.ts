/** The GNSS positions that images record: each file is read once, in a worker of its own, which ends when all are read. */
import type { ExifPosition } from '../../../pkg/wasm/tiepoint.js';
import type { WorkerClient } from '../../shared/engine/client';
import type { BlockFile } from '../state/state';
import type { BlockCalls } from './calls';

export class RecordedPositions {
  /** By the ids of files; null: none is recorded. */
  private readonly known = new Map<number, Promise<ExifPosition | null>>();

  constructor(private readonly reader: Pick<WorkerClient<BlockCalls>, 'call' | 'cancel'>) {}

  /** Of these images, those that record one; null as soon as they are no longer wanted. */
  async of(files: readonly BlockFile[], areWanted: () => boolean): Promise<ExifPosition[] | null> {
    const given = new Set(files.map(({ id }) => id));
    for (const id of [...this.known.keys()]) if (!given.has(id)) this.known.delete(id);
    const positions: ExifPosition[] = [];
    for (const { id, file } of files) {
      // What cannot be read is told when it is placed.
      const asked = this.known.get(id) ?? this.reader.call('imagePosition', { file }).catch(() => null);
      this.known.set(id, asked);
      const position = await asked;
      if (!areWanted()) return null;
      if (position !== null) positions.push(position);
    }
    this.reader.cancel();
    return positions;
  }
}
