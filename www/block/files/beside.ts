/** Takes what is given beside the images of a block: cameras, tables, masks, the geoid, and what belongs to scanned film. */
import type { FoundFile } from '../../shared/files/drop';
import { fieldsOf, OWN_SETTINGS } from '../../shared/files/json';
import type { Here, TakeHere } from '../../shared/files/leaving';
import { sentence } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import { marksOfNone } from '../state/film';
import { PARTNER_MISSING, problemsOf } from '../state/given';
import type { GivenText } from '../state/given';
import { waitsForMarks } from '../state/marks';
import { withMasks } from '../state/masks';
import type { PairMask } from '../state/masks';
import { controlText } from '../state/words';
import type { FilmFiles } from './film';
import { newId } from './ids';
import { hasFiducials, hasNumbers, kindOfTable } from './tables';
import type { Telling } from './told';
import { textIn } from '../../shared/files/text';

export const TABLE = /\.(?:csv|txt)$/iu;
const CSV = /\.csv$/iu;
export const CAMERAS = /\.json$/iu;
/** The field that cameras of film have, and files of cameras and settings do not. */
const FOCAL_LENGTH = 'focal_mm';

const TEXTS: Readonly<Record<GivenText, string>> = {
  cameras: say('cameras'),
  control: say('ground-control-points'),
  marks: say('image-measurements'),
  positions: say('image-positions'),
};

export class BesideFiles {
  constructor(
    private readonly store: BlockStore,
    private readonly telling: Telling,
    private readonly film: FilmFiles,
    private readonly takeHere: TakeHere,
  ) {}

  /** Takes cameras that were given with these photos; a file that cannot be used is put aside, and changes nothing: what is said of it. */
  async cameras(file: File, photos: readonly FoundFile[], here: Here): Promise<string> {
    const { state } = this.store;
    const text = await textIn(file);
    here();
    const files = [...state.files, ...photos.map((photo) => ({ id: 0, name: photo.file.name, file: photo.file }))];
    const { cameras: problem } = problemsOf({ ...state, files, options: { ...state.options, cameras: { name: file.name, text } } });
    if (problem === undefined) {
      await this.takesText('cameras', file, here);
      return '';
    }
    const fields = fieldsOf(text);
    if (OWN_SETTINGS in fields) return say('holds-settings', { name: file.name });
    return say('cameras' in fields ? 'cameras-are-put-aside' : 'holds-no-cameras', { problem: sentence(problem) });
  }

  /** Takes the camera and the fiducial marks of scanned film, told by what they hold. `marks`: their names; `aside`: what is wrong with them. */
  async ofFilm(given: readonly File[], here: Here): Promise<{ files: Set<File>; marks: readonly string[]; said: string; aside: string }> {
    const cameras: File[] = [];
    const marks: File[] = [];
    for (const file of given) {
      if (CAMERAS.test(file.name) && FOCAL_LENGTH in fieldsOf(await textIn(file))) cameras.push(file);
      else if (TABLE.test(file.name) && hasFiducials(await textIn(file))) marks.push(file);
    }
    const [camera] = cameras;
    const said = [...(camera === undefined ? [] : [await this.film.camera(camera, here)]), ...(marks.length === 0 ? [] : [await this.film.marks(marks, here)])];
    const texts = (kind: 'info' | 'problem') => said.flatMap((one) => (one.kind === kind ? [one.text] : [])).join(' ');
    return {
      files: new Set([...(camera === undefined ? [] : [camera]), ...marks]),
      marks: marks.map(({ name }) => name),
      said: texts('info'),
      aside: texts('problem'),
    };
  }

  /** What is said of fiducial marks, of those with these names, that are of no image. */
  marksOfNone(names: readonly string[]): string {
    const { placing, files } = this.store.state;
    const lone = marksOfNone(placing.film, files).filter((name) => names.includes(name));
    return lone.map((name) => say('marks-of-no-image', { name })).join(' ');
  }

  /** Takes tables of control points, of image measurements and of GNSS positions, given with these photos; what is none is left aside, and changes nothing. `files`: those that are said something of. */
  async tables(given: readonly File[], photos: readonly FoundFile[], here: Here): Promise<{ files: ReadonlySet<File>; aside: string }> {
    const names = new Set([...this.store.state.files, ...photos.map(({ file }) => file)].map(({ name }) => name));
    const aside: string[] = [];
    const files = new Set<File>();
    for (const file of given) {
      const text = await textIn(file);
      const found = kindOfTable(text, names);
      // Any other text, such as notes, is no table.
      if (found.kind === 'neither' && !CSV.test(file.name) && !hasNumbers(text)) continue;
      files.add(file);
      if (found.kind === 'neither') aside.push(say('is-no-table-of', { name: file.name, why: sentence(found.why) }));
      else if (found.kind !== 'fiducials') await this.takesText(found.kind, file, here);
    }
    return { files, aside: aside.join(' ') };
  }

  /** Takes a file of text and says what is wrong with it; it stays beside its field until another is given or it is removed. */
  takeText(given: GivenText, file: File): Promise<void> {
    return this.takeHere([file.name], (here) => this.takesText(given, file, here));
  }

  private async takesText(given: GivenText, file: File, here: Here): Promise<void> {
    const text = await textIn(file);
    here();
    this.store.dispatch({ type: 'options', options: { [given]: { name: file.name, text } } });
    const problem = problemsOf(this.store.state)[given];
    const said = say('from', { texts: TEXTS[given], name: file.name });
    if (problem === undefined)
      this.telling.tellTaken((given === 'control' || given === 'marks') && waitsForMarks(this.store.state) ? `${said} ${controlText(this.store.state)}` : said);
    else if (problem === PARTNER_MISSING[given]) this.telling.tellTaken(say('from-2', { texts: TEXTS[given], name: file.name, problem }));
    else this.telling.tell('problem', say('the-block-cannot-be-run', { problem: sentence(problem) }));
  }

  /** Takes masks in place of those that are there. */
  takeMasks(files: readonly File[]): void {
    this.store.dispatch({ type: 'options', options: { masks: files.map((file) => ({ id: newId(), name: file.name, file })) } });
    const problem = problemsOf(this.store.state).masks;
    if (problem !== undefined) this.telling.tell('problem', say('the-block-cannot-be-run-with', { problem: sentence(problem) }));
  }

  /** Takes the masks of a pair of the block, in place of those of the same images; where the pair has none any more, neither has the block. */
  takePairMasks(masks: readonly PairMask[]): void {
    this.store.dispatch({ type: 'options', options: { masks: withMasks(this.store.state.options.masks, masks, newId) } });
    const said = (['masks-are-of-the-block', 'block-has-no-mask-of'] as const).map((text) => {
      const names = masks.filter(({ file }) => (file === null) === (text === 'block-has-no-mask-of')).map(({ image }) => image);
      return names.length === 0 ? '' : say(text, { names: names.join(', ') });
    });
    this.telling.tellTaken(said.filter((part) => part !== '').join(' '));
  }

  /** Takes the geoid from which heights count, in place of the one that is there. */
  takeGeoid(file: File): void {
    this.store.dispatch({ type: 'options', options: { geoid: { id: newId(), name: file.name, file } } });
    const problem = problemsOf(this.store.state).geoid;
    if (problem === undefined) this.telling.tellTaken(say('from', { texts: say('geoid'), name: file.name }));
    else this.telling.tell('problem', say('the-block-cannot-be-run', { problem: sentence(problem) }));
  }
}
