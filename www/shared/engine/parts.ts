/** Parts of the page that are loaded when they are first needed. */
import { say } from '../text/words';
import { besideFiles } from './platform';

/**
 * Imports a part. Its file is fetched first: a browser remembers for as long as the document lasts that an import failed, and would not try again.
 * `file`: as `tools/lib/page.mjs` names it. @throws Error that names the file, where it cannot be had
 */
export async function loadPart<T>(file: string, load: () => Promise<T>): Promise<T> {
  if (besideFiles() && !import.meta.env.DEV) await reach(file);
  return load();
}

/** Has the file of a part fetched that is needed soon. */
export function fetchEarly(file: string): void {
  if (!besideFiles() || import.meta.env.DEV) return;
  const link = document.createElement('link');
  Object.assign(link, { rel: 'modulepreload', href: new URL(file, document.baseURI).href });
  document.head.append(link);
}

async function reach(file: string): Promise<void> {
  const answer = await fetch(new URL(file, document.baseURI)).catch(() => null);
  if (answer?.ok !== true) throw new Error(say('the-file-of-the-page', { file, status: answer?.status ?? null }));
  // To its end: the import then has it at hand.
  await answer.arrayBuffer();
}

/** A part that is made once, when it is first asked for; where that fails, the next one who asks tries again. */
export class LatePart<T> {
  private made: Promise<T> | null = null;

  constructor(private readonly make: () => Promise<T>) {}

  get(): Promise<T> {
    this.made ??= this.make().catch((error: unknown) => {
      this.made = null;
      throw error;
    });
    return this.made;
  }
}
