/** Takes the camera and the fiducial marks of scanned film in, as the crate reads them. */
import { parse_camera, parse_fiducials } from '../../../pkg/wasm/tiepoint.js';
import type { Here, TakeHere } from '../../shared/files/leaving';
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { TextFile } from '../state/file';
import { NO_FILM, withMarks } from '../state/film';
import { framesStep } from '../state/frames-step';
import { textIn } from '../../shared/files/text';

/** So many files are named in a message. */
const LISTED = 5;

/** The first of these. */
function namesOf(files: readonly { name: string }[]): string {
  const names = files.slice(0, LISTED).map(({ name }) => name);
  return names.join(', ') + (files.length > LISTED ? ' …' : '');
}

/** What is said of files: what they are, or what is wrong with one. */
interface Said {
  kind: 'info' | 'problem';
  text: string;
}

export class FilmFiles {
  constructor(
    private readonly store: BlockStore,
    private readonly takeHere: TakeHere,
  ) {}

  /** In place of the camera that is there. */
  takeCamera(file: File): Promise<void> {
    return this.takeHere([file.name], async (here) => this.tell(await this.camera(file, here)));
  }

  /** Marks of scans, beside those of others. */
  takeMarks(files: readonly File[]): Promise<void> {
    return this.takeHere(
      files.map(({ name }) => name),
      async (here) => this.tell(await this.marks(files, here)),
    );
  }

  /** Takes the camera, and gives what is said of it. */
  async camera(file: File, here: Here): Promise<Said> {
    const camera = await this.read(file, parse_camera);
    here();
    if (typeof camera === 'string') return { kind: 'problem', text: camera };
    this.store.dispatch({ type: 'film', film: { ...this.store.state.placing.film, camera } });
    return { kind: 'info', text: say('from', { texts: say('film-camera'), name: file.name }) };
  }

  /** Takes marks, all of them or none, and gives what is said of them. */
  async marks(files: readonly File[], here: Here): Promise<Said> {
    const marks: TextFile[] = [];
    for (const file of files) {
      const read = await this.read(file, parse_fiducials);
      if (typeof read === 'string') return { kind: 'problem', text: read };
      marks.push(read);
    }
    here();
    this.store.dispatch({ type: 'film', film: withMarks(this.store.state.placing.film, marks) });
    return { kind: 'info', text: say('from', { texts: say('marks-of-scans'), name: namesOf(files) }) };
  }

  /** All images are scans from now on, whose marks are measured. */
  areScans(): void {
    this.store.dispatch({ type: 'film', film: { ...this.store.state.placing.film, areScans: true } });
  }

  /** Takes marks that were measured in scans, as if their tables were given. */
  takeMeasured(tables: readonly TextFile[]): void {
    const { film } = this.store.state.placing;
    this.store.dispatch({ type: 'film', film: withMarks(film, tables) });
    const said = say('from', { texts: say('marks-of-scans'), name: namesOf(tables) });
    this.tell({ kind: 'info', text: `${said} ${framesStep(this.store.state)}`.trimEnd() });
  }

  /** Leaves no image a scan of film. */
  clear(): void {
    this.store.dispatch({ type: 'film', film: NO_FILM });
  }

  /** A file that the crate reads; where it does not, what is wrong with it. */
  private async read(file: File, check: (text: string) => unknown): Promise<TextFile | string> {
    const text = await textIn(file);
    try {
      check(text);
      return { name: file.name, text };
    } catch (error) {
      return say('cannot-be-used-of-film', { name: file.name, problem: sentence(messageOf(error)) });
    }
  }

  private tell(notice: Said): void {
    this.store.dispatch({ type: 'notice', notice });
  }
}
