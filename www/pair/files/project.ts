/** The project file of a pair: saved, opened, and joined with the files of its images. */
import type { Engine } from '../engine/engine';
import { save } from '../../shared/files/save';
import type { ImageSource, Overview } from '../state/data';
import { projectOf } from '../state/project';
import type { OpenedProject } from '../state/project';
import { SIDES } from '../state/state';
import type { GivenImage, GivenMask, Side, State } from '../state/state';
import type { Store } from '../state/store';
import { baseName } from './export';
import { say } from '../../shared/text/words';

/** Longest side of what stands for an image that is not there, px. */
const STANDING_SIDE = 256;
/** Its grey value. */
const STANDING_GREY = 0x80;

/** Writes all that is known of the pair; gives the name of the file. */
export async function exportProject(store: Store, engine: Engine): Promise<string> {
  const { state } = store;
  const text = await projectText(state, engine);
  if (text === null) throw new Error(say('the-pair-is-not-matched'));
  return save(new Blob([text], { type: 'application/octet-stream' }), `${baseName(state)}.tiepoint`);
}

/** The text of the pair's project file; null while parts of it are missing or out of date. */
export async function projectText(state: State, engine: Engine): Promise<string | null> {
  const [left, right] = await Promise.all(SIDES.map((side) => contentOf(state, engine, side)));
  const project = projectOf(state, { left: left ?? null, right: right ?? null });
  return project === null ? null : engine.client('pair').call('projectWrite', project);
}

/** Digests that were made: files are large. */
const digests = new WeakMap<Blob, string>();

/** The digest of a file that a project file already says: the file itself may no longer be readable when the next one is written. */
export function knowDigest(source: ImageSource, digest: string | null): void {
  if (source.kind === 'file' && digest !== null) digests.set(source.file, digest);
}

/** The digest of an image's file; null for an image that was simulated. */
function contentOf({ images }: State, engine: Engine, side: Side): Promise<string | null> {
  return digestOf(images[side]?.source, engine);
}

async function digestOf(source: ImageSource | undefined, engine: Engine): Promise<string | null> {
  switch (source?.kind) {
    case 'file': {
      const digest = digests.get(source.file) ?? (await engine.client('pair').call('digest', { file: source.file }));
      digests.set(source.file, digest);
      return digest;
    }
    case 'project':
      return source.content;
    default:
      return null;
  }
}

/** Whether two images are of the same content; those that were simulated do not say. */
export async function haveSameContent(a: ImageSource, b: ImageSource, engine: Engine): Promise<boolean> {
  const content = await digestOf(a, engine);
  return content !== null && content === (await digestOf(b, engine));
}

/** Reads a project; what stands for its images has their names and sizes. `nextId` numbers images and masks. */
export async function readProject(engine: Engine, file: Blob, nextId: () => number): Promise<OpenedProject> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const project = await engine.client('pair').call('projectOpen', { bytes }, [bytes.buffer]);
  const [left, right] = project.images;
  const of = { left, right };
  const image = (side: Side): GivenImage => ({ id: nextId(), name: of[side].name, source: { kind: 'project', content: of[side].content ?? null } });
  const overviews = { left: await standingFor(left.width_px, left.height_px), right: await standingFor(right.width_px, right.height_px) };
  const mask = (side: Side): GivenMask | null => {
    const { mask: name, width_px: width, height_px: height } = of[side];
    return name == null
      ? null
      : {
          id: nextId(),
          name,
          source: { kind: 'project', content: null },
          width,
          height,
          grey: new Uint8Array(),
          leftOut: NaN,
          overlay: overviews[side].clear,
        };
  };
  return { project, overviews, images: { left: image('left'), right: image('right') }, masks: { left: mask('left'), right: mask('right') } };
}

/** A grey area of the size of an image, and a clear one. */
async function standingFor(width: number, height: number): Promise<Overview & { clear: ImageBitmap }> {
  const halvings = Math.max(0, Math.ceil(Math.log2(Math.max(width, height) / STANDING_SIDE)));
  const data = new ImageData(Math.ceil(width / 2 ** halvings), Math.ceil(height / 2 ** halvings));
  const clear = await createImageBitmap(data);
  data.data.fill(STANDING_GREY).forEach((_, i) => {
    if (i % 4 === 3) data.data[i] = 0xff;
  });
  return { bitmap: await createImageBitmap(data), halvings, clear };
}

/** The side of a project that was opened to which this very file belongs; null where there is none. */
export async function sideOfFile({ images }: State, engine: Engine, file: File): Promise<Side | null> {
  for (const side of SIDES) {
    const image = images[side];
    if (image?.source.kind !== 'project' || image.name !== file.name || image.source.content === null) continue;
    if ((await engine.client('pair').call('digest', { file })) === image.source.content) return side;
  }
  return null;
}
