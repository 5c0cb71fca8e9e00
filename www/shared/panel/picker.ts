/** A hidden field for files, and the button that opens it. */
import { button, h } from './dom';

export interface Picked {
  testid: string;
  /** What is asked for, for those who cannot see the button. */
  label: string;
  accept?: string;
  multiple?: boolean;
  folder?: boolean;
}

/** The field of files; `take` gets what was chosen, and the same file can be chosen again. */
function fileInput({ testid, label, accept, multiple = false, folder = false }: Picked, take: (files: File[]) => void): HTMLInputElement {
  const input = h('input', { type: 'file', class: 'visually-hidden', tabindex: -1, testid: `${testid}-input`, aria: { label } });
  if (accept !== undefined) input.accept = accept;
  input.multiple = multiple || folder;
  input.webkitdirectory = folder;
  input.addEventListener('change', () => {
    const files = [...(input.files ?? [])];
    if (files.length > 0) take(files);
    input.value = '';
  });
  return input;
}

/** The button with its field. */
export function fileButton(text: string, picked: Picked, take: (files: File[]) => void, title?: string): [HTMLButtonElement, HTMLInputElement] {
  const input = fileInput(picked, take);
  return [button(text, picked.testid, () => input.click(), title), input];
}
