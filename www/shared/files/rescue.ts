/** The parts of a kept project as files in one archive, whatever state they are in. */
import { Archive } from '../engine/archive';

export async function archiveOf(parts: ReadonlyMap<string, unknown>): Promise<Blob> {
  const archive = new Archive();
  for (const [part, value] of parts) {
    for (const [name, content] of filesOf(part, value)) archive.add(name, await bytesOf(content), true);
  }
  return archive.end();
}

/** Files that a part holds, and the part itself as JSON. */
function filesOf(part: string, value: unknown): [string, Blob | string][] {
  if (value instanceof Blob) return [[part, value]];
  const { project, file } = (typeof value === 'object' && value !== null ? value : {}) as { project?: unknown; file?: unknown };
  const held: [string, Blob | string][] = [];
  if (file instanceof Blob) held.push([`${part}/${file instanceof File ? file.name : 'file'}`, file]);
  if (typeof project === 'string' || project instanceof Blob) held.push([`${part}.tiepoint`, project]);
  // Points and pixels are many numbers: they stand in the project file, or can be made again.
  const text = JSON.stringify(value, (name, one: unknown) => (ArrayBuffer.isView(one) || (name === 'project' && typeof one === 'string') ? undefined : one));
  return [...held, [`${part}.json`, text ?? '']];
}

async function bytesOf(content: Blob | string): Promise<Uint8Array> {
  if (typeof content === 'string') return new TextEncoder().encode(content);
  try {
    return new Uint8Array(await content.arrayBuffer());
  } catch (error) {
    return new TextEncoder().encode(String(error));
  }
}
