/** Announces the selected point to screen readers. */
import { UNDECIDED } from '../state/codes';
import { textOfCode } from '../state/labels';
import { leftCodes, rightCodes, shownPair } from '../state/select';
import type { Store } from '../state/store';
import { count, fixed } from '../../shared/text/format';

export function mountAnnouncements(host: HTMLElement, store: Store): void {
  store.watch(['selection'], ([selection]) => {
    if (selection === null) {
      host.textContent = '';
      return;
    }
    const shown = shownPair(store.state);
    const points = shown[selection.side];
    const codes = selection.side === 'left' ? leftCodes(shown.left, shown.match, shown.orientation) : rightCodes(shown.right, shown.match, shown.orientation);
    const [x, y] = points?.subarray(3 * selection.index, 3 * selection.index + 2) ?? [];
    host.textContent = `${selection.side} point ${count(selection.index + 1)} at ${fixed(x, 1)}, ${fixed(y, 1)}. ${textOfCode(codes[selection.index] ?? UNDECIDED, 'label')}.`;
  });
}
