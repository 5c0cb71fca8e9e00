/** Dropping and pasting files anywhere on the page. */
import { SIDES } from '../state/state';
import type { Side } from '../state/state';
import type { View } from '../view/view';
import { panesOf } from '../view/geometry';
import type { Files } from './open';

/** The side at a place of the page: that of the pane there, else none. */
function sideAt(view: View, event: DragEvent): Side | null {
  const box = view.host.getBoundingClientRect();
  const panes = panesOf(view.width, view.height);
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  return SIDES.find((side) => {
    const { left, top, width, height } = panes[side];
    return x >= left && x < left + width && y >= top && y < top + height;
  }) ?? null;
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') === true;
}

export function mountDrop(view: View, files: Files): void {
  const mark = (over: Side | 'page' | null) => {
    if (over === null) delete document.body.dataset['drop'];
    else document.body.dataset['drop'] = over;
  };
  document.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    mark(sideAt(view, event) ?? 'page');
  });
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) mark(null);
  });
  document.addEventListener('drop', (event) => {
    mark(null);
    if (!hasFiles(event)) return;
    event.preventDefault();
    void files.take([...(event.dataTransfer?.files ?? [])], sideAt(view, event));
  });
  document.addEventListener('paste', (event) => {
    const pasted = [...(event.clipboardData?.files ?? [])];
    if (pasted.length === 0) return;
    event.preventDefault();
    void files.take(pasted, null);
  });
}
