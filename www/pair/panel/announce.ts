/** Says beside the picture what became of the selected point, and why. */
import { leftCodes, rightCodes, shownPair } from '../state/select';
import { UNDECIDED } from '../state/codes';
import { textOfCode } from '../state/labels';
import type { Store } from '../state/store';
import { button, byId, fill, h } from '../../shared/panel/dom';
import { verdictOf } from './verdict';
import { say } from '../../shared/text/words';

/** `details` shows all that is known of it. */
export function mountAnnouncements(host: HTMLElement, store: Store, details: () => void): void {
  const keys = byId('keys');
  const text = h('span', {});
  const press = button(say('details'), 'selected-details', details);
  press.ariaLabel = say('details-of-the-point');
  fill(host, text, ' ', press);
  // What became of it changes by edits and by new results, too.
  store.watch(['selection', 'history', 'results'], ([selection]) => {
    const { state } = store;
    host.hidden = selection === null;
    keys.hidden = selection !== null;
    if (selection === null) {
      text.textContent = '';
      return;
    }
    const shown = shownPair(state);
    const points = shown[selection.side];
    const codes = selection.side === 'left' ? leftCodes(shown.left, shown.match, shown.orientation) : rightCodes(shown.right, shown.match, shown.orientation);
    const [x, y] = points?.subarray(3 * selection.index, 3 * selection.index + 2) ?? [];
    const label = textOfCode(codes[selection.index] ?? UNDECIDED, 'label');
    const why = shown.match === null ? '' : verdictOf(state, shown, shown.match).text;
    const said = say('point-at', { side: selection.side, index: selection.index + 1, x, y, what: why === '' ? say('n--4', { label }) : why });
    // What is said already would be read out again.
    if (text.textContent !== said) text.textContent = said;
  });
}
