/** Takes the camera and the fiducial marks of scanned film in, as the crate reads them. */
import { parse_camera, parse_fiducials } from '../../../pkg/wasm/tiepoint.js';
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { TextFile } from '../state/file';
import { NO_FILM, withMarks } from '../state/film';

export class FilmFiles {
  constructor(private readonly store: BlockStore) {}

  /** In place of the camera that is there. */
  async takeCamera(file: File): Promise<void> {
    const camera = await this.read(file, parse_camera);
    if (camera === null) return;
    this.store.dispatch({ type: 'film', film: { ...this.store.state.placing.film, camera } });
    this.tell('info', say('from', { texts: say('film-camera'), name: file.name }));
  }

  /** Marks of scans, beside those of others. */
  async takeMarks(files: readonly File[]): Promise<void> {
    const marks: TextFile[] = [];
    for (const file of files) {
      const read = await this.read(file, parse_fiducials);
      if (read === null) return;
      marks.push(read);
    }
    this.store.dispatch({ type: 'film', film: withMarks(this.store.state.placing.film, marks) });
    this.tell('info', say('from', { texts: say('marks-of-scans'), name: files.map(({ name }) => name).join(', ') }));
  }

  /** Leaves no image a scan of film. */
  clear(): void {
    this.store.dispatch({ type: 'film', film: NO_FILM });
  }

  /** A file that the crate reads; null where it does not, which is said. */
  private async read(file: File, check: (text: string) => unknown): Promise<TextFile | null> {
    const text = await file.text();
    try {
      check(text);
      return { name: file.name, text };
    } catch (error) {
      this.tell('problem', say('cannot-be-used-of-film', { name: file.name, problem: sentence(messageOf(error)) }));
      return null;
    }
  }

  private tell(kind: 'info' | 'problem', text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text } });
  }
}
