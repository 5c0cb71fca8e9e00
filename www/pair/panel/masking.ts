/** While areas of the pictures are masked: what to do next, and buttons for each key. */
import { button, byId, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { hasOwnUndo, showSteps, undoKeys } from '../../shared/panel/history';
import { declare } from '../../shared/view/commands';
import { save } from '../../shared/files/save';
import { say } from '../../shared/text/words';
import { marksHaveKeys } from './marking';
import { nameOfMaskStep, stepsWithOutline } from '../state/mask-steps';
import type { Masking } from '../state/masking';
import { SIDES } from '../state/state';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { declareLack } from '../../shared/panel/lack';

/** What takes a moment: the outlined area is masked, or no longer; the last step is taken back, or made again. */
export interface MaskDeeds {
  paint: (masked: boolean) => void;
  step: (by: 1 | -1) => void;
  giveUp: () => void;
}

/** The tool with those of the pictures, its buttons in the bar above them. */
export function mountMasking(host: HTMLElement, bar: HTMLElement, store: Store, masking: Masking, { paint, step, giveUp }: MaskDeeds): void {
  const tool = button(say('mask-areas'), 'tool-mask', () => masking.toggle(), say('outline-areas-in-which-no'));
  const text = h('span', { testid: 'mask-text', role: 'status' });
  const mask = button(say('mask-it'), 'mask-area', () => paint(true), say('no-points-in-the-outlined'));
  const unmask = button(say('unmask-it'), 'unmask-area', () => paint(false), say('points-in-the-outlined-area'));
  const undo = button(say('undo-sign'), 'mask-undo', () => step(-1));
  const redo = button(say('redo-sign'), 'mask-redo', () => step(1));
  const keep = button(say('save-masks'), 'mask-save', () => saveMasks(store), say('masks-as-png-files-for'));
  const end = button(say('end-masking'), 'mask-end', () => masking.toggle());
  const buttons = h(
    'div',
    { class: 'drafting', testid: 'masking', role: 'group', aria: { label: say('masks-of-the-pictures') } },
    text,
    mask,
    unmask,
    undo,
    redo,
    keep,
    end,
  );
  declareLack([buttons], () => (store.state.tool === 'mask' ? '' : say('nothing-is-outlined')));
  host.append(tool);
  undoKeys(
    // Where the pair is what is shown.
    () => byId('view').offsetParent !== null && store.state.tool === 'mask' && !marksHaveKeys(store.state),
    step,
  );
  // Of the outline, wherever the keyboard is; in the pictures their own keys have done it before.
  const leave = declare({
    where: say('anywhere-while-masking'),
    host: buttons,
    list: [{ keys: ['Escape'], does: say('gives-the-outline-up'), can: () => store.state.outline !== null && byId('view').offsetParent !== null, run: giveUp }],
  });
  document.addEventListener('keydown', (event) => {
    // A list of choices that is unfolded is folded by it.
    if (event.defaultPrevented || hasOwnUndo(event.target) || (event.target instanceof Element && event.target.closest('select') !== null)) return;
    if (leave(event.key, event.shiftKey)) event.preventDefault();
  });
  bar.append(buttons);
  store.watch(
    (s) => [s.tool, s.outline, s.images, s.masks, s.maskSteps] as const,
    () => {
      const { state } = store;
      const held = document.activeElement;
      tool.setAttribute('aria-pressed', String(state.tool === 'mask'));
      tool.disabled = !masking.can();
      buttons.hidden = state.tool !== 'mask';
      mask.disabled = !masking.isArea();
      unmask.disabled = mask.disabled;
      showSteps(undo, redo, stepsWithOutline(state), (one) => nameOfMaskStep(one, state.images));
      keep.disabled = SIDES.every((side) => fileOf(state, side) === null);
      // Keys of the pictures go on from a button that has done its work.
      if (buttons.contains(held)) passFocus(held, [byId('view')]);
      const corners = state.outline?.corners.length ?? 0;
      const now = masking.isArea() ? say('the-area-is-outlined', { corners }) : say('draw-round-an-area-or', { corners });
      if (text.textContent !== now) text.textContent = now;
    },
  );
}

function fileOf(state: State, side: Side): Blob | null {
  const source = state.masks[side]?.source;
  return source?.kind === 'file' ? source.file : null;
}

/** What was said of an earlier deed is over then. */
function saveMasks(store: Store): void {
  const { state } = store;
  for (const side of SIDES) {
    const file = fileOf(state, side);
    if (file !== null) save(file, state.masks[side]?.name ?? 'mask.png');
  }
  if (state.notice?.kind !== 'busy') store.dispatch({ type: 'notice', notice: null });
}
