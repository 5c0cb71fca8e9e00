/** Dropping and pasting files and folders anywhere on the page: the part that is shown takes them. */
/** What a drag of files says of itself. */
const FILES = 'Files';

/** A file with its path below the folder that was given; the path is empty for a file given by itself. */
export interface FoundFile {
  file: File;
  path: string;
}

export interface Taker {
  /** Whether files are its own now. */
  isActive: () => boolean;
  /** What the page marks while files are over a place: the value of `data-drop`. */
  markAt: (event: DragEvent) => string;
  /** `at`: what was marked where the files were dropped; null for pasted ones. */
  take: (found: FoundFile[], at: string | null) => void;
}

/** Takes those who get files, once they are there. */
export type ServeDrop = (takers: readonly Taker[]) => void;

/** The first taker that is active gets what is given. Takers come once the program has loaded: what is given before is kept for them, and `tell` says how much. */
export function mountDrop(tell: (waiting: number) => void): ServeDrop {
  let serving: readonly Taker[] | null = null;
  const waiting: FoundFile[] = [];
  const take = (found: FoundFile[]) => {
    waiting.push(...found);
    tell(waiting.length);
  };
  const loading: Taker = { isActive: () => true, markAt: () => 'page', take };
  const active = () => (serving ?? [loading]).find(({ isActive }) => isActive());
  const unmark = () => {
    delete document.body.dataset.drop;
  };
  document.addEventListener('dragover', (event) => {
    const taker = active();
    if (!hasFiles(event) || taker === undefined) return;
    event.preventDefault();
    document.body.dataset.drop = taker.markAt(event);
  });
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) unmark();
  });
  document.addEventListener('drop', (event) => {
    unmark();
    const taker = active();
    if (!hasFiles(event) || taker === undefined) return;
    event.preventDefault();
    const at = taker.markAt(event);
    // The list is empty once this call has returned; entries and files stay.
    const items = [...(event.dataTransfer?.items ?? [])].map((item) => ({ entry: item.webkitGetAsEntry(), file: item.getAsFile() }));
    void Promise.all(items.map(({ entry, file }) => found(entry, file))).then((lists) => {
      const late = taker === loading && serving !== null;
      (late ? active() : taker)?.take(lists.flat(), late ? null : at);
    });
  });
  document.addEventListener('paste', (event) => {
    const pasted = [...(event.clipboardData?.files ?? [])];
    const taker = active();
    if (pasted.length === 0 || taker === undefined) return;
    event.preventDefault();
    taker.take(
      pasted.map((file) => ({ file, path: '' })),
      null,
    );
  });
  return (takers) => {
    serving = takers;
    if (waiting.length > 0) active()?.take(waiting.splice(0), null);
  };
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes(FILES) === true;
}

/** The files of an entry, those of folders below it too. */
async function found(entry: FileSystemEntry | null, file: File | null): Promise<FoundFile[]> {
  if (entry?.isDirectory !== true) return file === null ? [] : [{ file, path: '' }];
  return below(entry as FileSystemDirectoryEntry);
}

async function below(folder: FileSystemDirectoryEntry): Promise<FoundFile[]> {
  const lists = await Promise.all(
    (await entriesOf(folder)).map(async (entry) => {
      if (entry.isDirectory) return below(entry as FileSystemDirectoryEntry);
      const file = await new Promise<File | null>((resolve) => (entry as FileSystemFileEntry).file(resolve, () => resolve(null)));
      return file === null ? [] : [{ file, path: entry.fullPath.replace(/^\//u, '') }];
    }),
  );
  return lists.flat();
}

/** All entries of a folder; the reader gives them in portions, the last of which is empty. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const portion = await new Promise<FileSystemEntry[]>((resolve) => reader.readEntries(resolve, () => resolve([])));
    if (portion.length === 0) return all;
    all.push(...portion);
  }
}
