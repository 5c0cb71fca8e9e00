/** Takes files of a block in: images, a folder of them, texts that say more of them, a block that was saved. */
import type { FoundFile, Taker } from '../../shared/files/drop';
import { Cancelled } from '../../shared/engine/client';
import type { BlockFlight } from '../../../pkg/wasm/tiepoint.js';
import { keepChoice, keptChoice } from '../../shared/state/choices';
import { messageOf, sentence } from '../../shared/text/format';
import type { BlockFile } from '../state/state';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { PARTNER_MISSING, problemsOf } from '../state/given';
import type { GivenText } from '../state/given';

const IMAGE = /\.(?:jpe?g|png|tiff?|bmp|webp|p[gpn]m)$/iu;
const PROJECT = /\.tiepoint$/iu;
const CAMERAS = /\.json$/iu;

let nextId = 1;

/** Later files have other numbers than these. */
export function passIds(taken: readonly number[]): void {
  for (const id of taken) nextId = Math.max(nextId, id + 1);
}

const TEXTS: Readonly<Record<GivenText, string>> = { cameras: 'Cameras', control: 'Ground control points', marks: 'Image measurements' };

const WAITS = 'tiepoint-wait';

export class BlockFiles {
  /** Images that are given wait until Run is pressed: large blocks have settings and files that come first. */
  private waiting = keptChoice(WAITS) === 'yes';

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    /** Opens a project of whatever kind where it belongs. */
    private readonly openProject: (file: File) => Promise<void>,
  ) {}

  get waits(): boolean {
    return this.waiting;
  }

  set waits(waits: boolean) {
    this.waiting = waits;
    keepChoice(WAITS, waits ? 'yes' : 'no');
  }

  /** Takes what is dropped on the page while the block is shown. */
  readonly taker: Taker = {
    isActive: () => this.store.state.mode === 'block',
    markAt: () => 'block',
    take: (found) => void this.take(found),
  };

  /** Adds images to the block; what a folder holds besides images is left aside. `why` is said first. */
  async take(found: readonly FoundFile[], why = ''): Promise<void> {
    const alone = found.filter(({ path }) => path === '');
    const project = alone.find(({ file }) => PROJECT.test(file.name));
    const cameras = alone.find(({ file }) => CAMERAS.test(file.name));
    const images = found.filter(({ file }) => IMAGE.test(file.name) || file.type.startsWith('image/'));
    if (project !== undefined) await this.openProject(project.file);
    if (cameras !== undefined) await this.takeText('cameras', cameras.file);
    const aside = found.length - images.length - (project === undefined ? 0 : 1) - (cameras === undefined ? 0 : 1);
    if (images.length > 0 || aside > 0) this.add(images, aside, why);
  }

  /** Takes more images than a pair has, which were given there. */
  async give(files: readonly File[], masks: readonly File[]): Promise<void> {
    await this.take(
      files.map((file) => ({ file, path: '' })),
      'More than two images are a block.',
    );
    if (masks.length > 0) this.takeMasks(masks);
  }

  /** Photographs a block and runs it, whatever waits. */
  async sample(flight: BlockFlight): Promise<void> {
    if (await this.simulate(flight)) await this.engine.run();
  }

  /** Photographs the simulated block that is set and runs it. */
  async photograph(): Promise<void> {
    const { flight } = this.store.state;
    if (flight === null || !(await this.simulate(flight))) return;
    if (this.waits) this.say('info', `${String(this.store.state.files.length)} photos of a simulated block. Press Run.`);
    else await this.engine.run();
  }

  /** Photographs a flight, in place of the images that are there; false where that failed. */
  private async simulate(flight: BlockFlight): Promise<boolean> {
    this.say('busy', 'Building the synthetic scene …');
    try {
      const { files, truth } = await this.engine.photograph(flight, (count, of) =>
        this.say('busy', `Photographing the simulated block: ${String(count)} of ${String(of)} …`),
      );
      this.store.dispatch({ type: 'files', files: files.map((file) => ({ ...file, id: nextId++ })), truth });
      return true;
    } catch (error) {
      this.failed('The block could not be simulated', error);
      return false;
    }
  }

  /** Takes a file of text and says what is wrong with it; it stays beside its field until another is given or it is removed. */
  async takeText(given: GivenText, file: File): Promise<void> {
    this.store.dispatch({ type: 'options', options: { [given]: { name: file.name, text: await file.text() } } });
    const problem = problemsOf(this.store.state)[given];
    if (problem === undefined) this.say('info', `${TEXTS[given]} from ${file.name}.`);
    else if (problem === PARTNER_MISSING[given]) this.say('info', `${TEXTS[given]} from ${file.name}. ${problem}.`);
    else this.say('problem', `${sentence(problem)} The block cannot be run with it.`);
  }

  /** Takes masks in place of those that are there. */
  takeMasks(files: readonly File[]): void {
    this.store.dispatch({ type: 'options', options: { masks: files.map((file) => ({ id: nextId++, name: file.name, file })) } });
    const problem = problemsOf(this.store.state).masks;
    if (problem !== undefined) this.say('problem', `${sentence(problem)} The block cannot be run with them.`);
  }

  /** Opens a block that was saved. */
  async open(file: File): Promise<void> {
    this.say('busy', `Reading ${file.name} …`);
    try {
      await this.engine.open(new Uint8Array(await file.arrayBuffer()));
      this.say('info', `${file.name} was opened. The file does not hold its images: drop them too to open pairs.`);
    } catch (error) {
      this.failed(`${file.name} cannot be opened`, error);
    }
  }

  private add(found: readonly FoundFile[], aside: number, why: string): void {
    const files = new Map(this.store.state.files.map((file) => [file.name, file]));
    const before = files.size;
    for (const { file, path } of found) {
      // Images of one name in two folders are told apart by their paths.
      const name = [file.name, path].find((text) => text !== '' && !files.has(text));
      if (name !== undefined) files.set(name, { id: nextId++, name, file });
    }
    const twice = found.length - (files.size - before);
    const sorted: BlockFile[] = [...files.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
    if (sorted.length > before) {
      this.store.dispatch({ type: 'files', files: sorted, truth: this.store.state.truth });
      // What is given is run; what was given before goes on.
      if (sorted.length >= 2 && !this.waits) void this.engine.run();
    }
    const runs = this.store.state.running.kind === 'yes';
    const notes = [
      why,
      runs ? '' : `${images(sorted.length)} in the block.`,
      twice > 0 ? `${images(twice)} skipped: their names are in the block already.` : '',
      aside > 0 ? `${String(aside)} ${aside === 1 ? 'file' : 'files'} skipped: not an image by name.` : '',
      runs ? '' : sorted.length >= 2 ? 'Press Run.' : 'A block needs two images or more.',
    ].filter((note) => note !== '');
    // Why it cannot be run was said.
    if (notes.length === 0 || this.store.state.notice?.kind === 'problem') return;
    this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: notes.join(' '), beside: runs } });
  }

  private say(kind: 'info' | 'busy' | 'problem', text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text } });
  }

  private failed(what: string, error: unknown): void {
    if (error instanceof Cancelled) this.say('info', 'Cancelled. Nothing was changed.');
    else this.say('problem', `${what}: ${messageOf(error)}. The block is unchanged.`);
  }
}

function images(count: number): string {
  return `${String(count)} ${count === 1 ? 'image' : 'images'}`;
}
