/** Files and folders dropped or pasted while the block is shown. */
import type { BlockStore } from '../engine/engine';
import type { BlockFiles, FoundFile } from './files';

/** Comes before the pair's own handlers, which then see nothing of it. */
export function mountBlockDrop(store: BlockStore, files: BlockFiles): void {
  const on = <K extends 'dragover' | 'dragleave' | 'drop' | 'paste'>(type: K, act: (event: DocumentEventMap[K]) => void) => {
    document.addEventListener(type, (event) => {
      if (store.state.mode !== 'block') return;
      event.stopImmediatePropagation();
      act(event);
    }, { capture: true });
  };
  on('dragover', (event) => {
    if (event.dataTransfer?.types.includes('Files') !== true) return;
    event.preventDefault();
    document.body.dataset['drop'] = 'block';
  });
  on('dragleave', (event) => { if (event.relatedTarget === null) delete document.body.dataset['drop']; });
  on('drop', (event) => {
    delete document.body.dataset['drop'];
    if (event.dataTransfer?.types.includes('Files') !== true) return;
    event.preventDefault();
    // The list is empty once this call has returned; entries and files stay.
    const items = [...event.dataTransfer.items].map((item) => ({ entry: item.webkitGetAsEntry(), file: item.getAsFile() }));
    void Promise.all(items.map(({ entry, file }) => found(entry, file))).then((lists) => files.take(lists.flat()));
  });
  on('paste', (event) => {
    const pasted = [...(event.clipboardData?.files ?? [])];
    if (pasted.length === 0) return;
    event.preventDefault();
    void files.take(pasted.map((file) => ({ file, path: '' })));
  });
}

/** The files of an entry, those of folders below it too. */
async function found(entry: FileSystemEntry | null, file: File | null): Promise<FoundFile[]> {
  if (entry?.isDirectory !== true) return file === null ? [] : [{ file, path: '' }];
  return below(entry as FileSystemDirectoryEntry);
}

async function below(folder: FileSystemDirectoryEntry): Promise<FoundFile[]> {
  const lists = await Promise.all((await entriesOf(folder)).map(async (entry) => {
    if (entry.isDirectory) return below(entry as FileSystemDirectoryEntry);
    const file = await new Promise<File | null>((resolve) => { (entry as FileSystemFileEntry).file(resolve, () => { resolve(null); }); });
    return file === null ? [] : [{ file, path: entry.fullPath.replace(/^\//u, '') }];
  }));
  return lists.flat();
}

/** All entries of a folder; the reader gives them in portions, the last of which is empty. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const portion = await new Promise<FileSystemEntry[]>((resolve) => { reader.readEntries(resolve, () => { resolve([]); }); });
    if (portion.length === 0) return all;
    all.push(...portion);
  }
}
