/** What is done to a finished block by hand: reject, restore, measure, undo, redo, the history, and what became of the adjustment. */
import { choice } from '../../shared/panel/choice';
import { declare } from '../../shared/view/commands';
import type { Command } from '../../shared/view/commands';
import { listenKeys } from '../../shared/view/gestures';
import { button, byId, fill, h, row } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { set, showHistory, showSteps, undoKeys } from '../../shared/panel/history';
import { count, fixed } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { isGiven, stepOfDraft } from '../state/draft';
import { comparedText, figuresOf, figureText } from '../state/edited';
import type { Figures } from '../state/edited';
import { editsInForce, isEditable } from '../state/editing';
import { editOfChoice, indexOfSource, standingOf } from '../state/edits';
import { addedPoints } from '../state/added';
import { remember } from '../../shared/state/remember';
import { marksByHand } from '../state/marks';
import type { MarkStep } from '../state/marks';
import { nameOfEdit, nameOfMarks, nameOfStep, namesOf, NO_NAMES } from '../state/naming';
import type { BlockEdit, PointDetail, PointSource } from '../../../pkg/wasm/tiepoint.js';
import type { EditStep, Standing } from '../state/edits';
import type { Names } from '../state/naming';
import { takesPlaces } from '../state/places';
import { blockOnOrthophoto } from '../state/showing';
import { apart, joined, split } from '../state/joining';
import { shownImages } from '../state/panes';
import { pointsOf } from '../state/selection';
import { removable, removesOthers } from '../state/removing';
import { heldAt, timelineOf } from '../state/timeline';
import type { Held, TimedStep } from '../state/timeline';
import { isBusy } from '../state/state';
import type { BlockState } from '../state/state';
import type { BlockView } from '../state/view';
import { nameOfPair, nameOfPoint } from '../state/words';
import { say } from '../../shared/text/words';

/** What measures points, once the images view is there. */
export interface Measures {
  toggle: (anew: boolean) => void;
  match: () => void;
  accept: () => void;
  leave: () => void;
}

/** What an edit of the choice would be; null where it cannot be made. */
function editOf({ selection, shown }: BlockState, kind: 'reject' | 'restore', whole = false): BlockEdit | null {
  return shown === null ? null : editOfChoice(kind, selection.chosen, shown.view, standingOf(shown.edits), whole);
}

function make(store: BlockStore, edit: BlockEdit | null): void {
  if (edit === null) return;
  if (store.state.running.kind === 'yes') store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('edits-wait-for-the-run'), beside: true } });
  else store.dispatch({ type: 'edit', edits: [edit] });
}

function makeStep(store: BlockStore, edits: readonly BlockEdit[] | null): void {
  if (edits !== null) store.dispatch({ type: 'edit', edits });
}

/** So many points may be one. */
const MOST_JOINED = 8;

/** The points that are chosen to be one; null where they cannot be, and while their figures are on their way. */
function toJoin({ selection, shown }: BlockState, facts: Facts): readonly PointDetail[] | null {
  const points = pointsOf(selection.chosen);
  if (shown === null || points.length < 2 || points.length > MOST_JOINED || points.some((point) => point >= shown.view.points.taking)) return null;
  const details = [...points].flatMap((point) => facts.point(point) ?? []);
  return details.length < points.length || joined(details) === null ? null : details;
}

/** Joins the chosen points, or says where they lie apart. */
function join(store: BlockStore, facts: Facts): void {
  const points = toJoin(store.state, facts);
  if (points === null) return;
  const far = apart(points);
  if (far === null) {
    makeStep(store, joined(points));
    return;
  }
  const image = store.state.shown?.view.images[far.image]?.name ?? '';
  store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('not-joined', { image, px: fixed(far.px, 0) }), beside: true } });
}

/** The step that splits the chosen point by the images that are shown. */
function splitOf({ selection, shown, panes }: BlockState, facts: Facts): readonly BlockEdit[] | null {
  const [point, ...more] = pointsOf(selection.chosen);
  if (shown === null || point === undefined || more.length > 0 || point >= shown.view.points.taking) return null;
  const detail = facts.point(point);
  return detail === null ? null : split(detail, shownImages(panes, shown.view));
}

/** A point that is being measured is given up first. */
function step(store: BlockStore, by: 1 | -1): void {
  if (store.state.draft !== null) {
    store.dispatch({ type: 'draft', draft: null });
    return;
  }
  go(store, heldAt(store.state, timelineOf(store.state).done + by));
}

/** Goes to where so many edits and so many steps beside them hold. */
function go(store: BlockStore, { edits, marks: steps }: Held): void {
  const { state } = store;
  if (edits !== state.history.done && !isEditable(state)) return;
  // The block is run for other images.
  if (removesOthers(state.marks, { ...state.marks, done: steps }) && isBusy(state)) {
    store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('edits-wait-for-the-run'), beside: true } });
    return;
  }
  if (edits !== state.history.done) store.dispatch({ type: 'goto', done: edits });
  if (steps !== state.marks.done) store.dispatch({ type: 'gotoMark', done: steps });
}

/** Takes the chosen images out of the block; null where they cannot be. */
function removalOf({ files, selection, shown, history }: BlockState): Extract<MarkStep, { kind: 'remove_images' }> | null {
  const out = removable(files, selection.chosen, shown?.view.images ?? []);
  return out.length === 0 ? null : { kind: 'remove_images', files: out.map(({ id }) => id), after: history.done };
}

/** The keyboard stays with what is chosen. */
function removeImages(store: BlockStore): void {
  const step = removalOf(store.state);
  if (step !== null) store.dispatch({ type: 'mark', step });
}

function nameOfTimed({ history, marks }: Pick<BlockState, 'history' | 'marks'>, { of, at }: TimedStep, names: Names): string {
  const [edit, mark] = [history.edits[at], marks.edits[at]];
  if (of === 'edits') return edit === undefined ? '' : nameOfStep(edit, names);
  return mark === undefined ? '' : nameOfMarks(mark);
}

/** Of the block as it was found, and of the points that its edits add. */
function namesIn({ shown, history }: BlockState): Names {
  return shown === null ? NO_NAMES : namedIn(shown.found, history.edits);
}

const namedIn = remember((found: BlockView, steps: readonly EditStep[]): Names => {
  const names = namesOf(found);
  const added = [...addedPoints(steps.flat(), found.givenControl).values()].map(({ edit, control }): [number, string] => [control, edit.name]);
  return added.length === 0 ? names : { ...names, surveyed: new Map([...names.surveyed, ...added]) };
});

/** The points that edits in force add. */
function addedIn({ shown, history }: BlockState) {
  return addedPoints(editsInForce(history), shown?.view.givenControl ?? 0);
}

/** "Reject 14 points", with the noun of what is chosen. */
function titleOf(edit: BlockEdit | null, otherwise: string, names: Names): string {
  return capital(edit === null ? otherwise : nameOfEdit(edit, names)).replace(/ 1 /u, ' ');
}

function capital(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}

/** Over the views: what can be done to what is chosen, and what the latest edit did. */
export function mountEditBar(store: BlockStore, facts: Facts, measures: () => Measures | null): HTMLElement {
  const undo = button(say('undo-sign'), 'block-undo', () => step(store, -1));
  const redo = button(say('redo-sign'), 'block-redo', () => step(store, 1));
  const reject = button(say('reject'), 'block-reject', () => make(store, editOf(store.state, 'reject')), say('take-what-is-chosen-out'));
  const whole = button(say('reject-point'), 'block-reject-point', () => make(store, editOf(store.state, 'reject', true)), say('take-the-point-with-all'));
  const restore = button(say('restore'), 'block-restore', () => make(store, editOf(store.state, 'restore')), say('use-what-is-chosen-again'));
  const remove = button(say('remove-image'), 'block-remove-image', () => removeImages(store), say('take-the-chosen-image-out'));
  const measure = button(
    say('measure-it'),
    'block-measure',
    () => {
      if (store.state.onStage !== 'images') store.dispatch({ type: 'stage', view: 'images' });
      measures()?.toggle(false);
    },
    say('measure-the-chosen-point-in'),
  );
  const add = button(say('add-point'), 'block-add-point', () => measures()?.toggle(true), say('measure-a-new-tie-point'));
  const joining = button(say('join'), 'block-join', () => join(store, facts), say('the-chosen-points-are-one'));
  const parting = button(say('split'), 'block-split', () => makeStep(store, splitOf(store.state, facts)), say('the-point-is-two-one'));
  const match = button(say('match-it'), 'block-match', () => measures()?.match(), say('match-the-point-in-the'));
  const accept = button(say('accept'), 'block-accept', () => measures()?.accept(), say('the-point-is-measured-enter'));
  const leave = button(say('cancel'), 'block-leave', () => measures()?.leave(), say('give-what-is-measured-up'));
  const [use, useSelect] = choice(say('use-as'), 'block-use', USES, (value) => {
    const surveyed = surveyedChoice(store.state, facts);
    const role = value === 'control' || value === 'check' ? value : null;
    if (surveyed !== null) make(store, { kind: 'set_use', point: surveyed.point, use: role });
  });
  const text = h('span', { class: 'edit-text', testid: 'block-edit-text', role: 'status', aria: { live: 'polite' } });
  const bar = h(
    'div',
    { class: 'toolbar edit-bar', testid: 'block-edit-bar', role: 'toolbar', aria: { label: say('edits-by-hand') } },
    ...[undo, redo, reject, whole, restore, remove, joining, parting, measure, add, match, accept, leave, use, text],
  );
  const counterparts = new Map<Element | null, readonly HTMLElement[]>([
    [reject, [restore]],
    [whole, [restore]],
    [restore, [reject]],
    [undo, [redo]],
    [redo, [undo]],
  ]);
  const show = () => {
    const { state } = store;
    const held = bar.contains(document.activeElement) ? document.activeElement : null;
    const { chosen } = state.selection;
    bar.hidden = !isEditable(state);
    const names = namesIn(state);
    showSteps(undo, redo, timelineOf(state), (one) => nameOfTimed(state, one, names));
    const [off, point, on] = [editOf(state, 'reject'), editOf(state, 'reject', true), editOf(state, 'restore')];
    const drafting = state.draft !== null;
    set(reject, titleOf(off, say('reject'), NO_NAMES), off === null);
    set(restore, titleOf(on, say('restore'), NO_NAMES), on === null);
    reject.hidden = drafting || (off === null && on !== null);
    restore.hidden = drafting || on === null;
    whole.hidden = drafting || chosen?.kind !== 'observation' || point === null;
    const removal = removalOf(state);
    remove.hidden = drafting || removal === null;
    set(remove, removal === null || removal.files.length === 1 ? say('remove-image') : capital(nameOfMarks(removal)), false);
    const inImages = state.onStage === 'images';
    // A point that no image shows yet is measured in the images, whatever view it was chosen in.
    const given = chosen?.kind === 'given';
    measure.hidden = drafting || !(inImages || given);
    const { taking = 0 } = state.shown?.view.points ?? {};
    measure.disabled = chosen?.kind !== 'given' && ((chosen?.kind !== 'point' && chosen?.kind !== 'observation') || chosen.point >= taking);
    add.hidden = drafting || !inImages;
    joining.hidden = drafting || toJoin(state, facts) === null;
    parting.hidden = drafting || !inImages || splitOf(state, facts) === null;
    match.hidden = !inImages || ((measure.disabled || given) && !drafting);
    accept.hidden = !drafting;
    accept.disabled =
      state.draft === null || stepOfDraft(state.draft, state.shown?.view.images.map(({ name }) => name) ?? [], state.history.done, addedIn(state)) === null;
    leave.hidden = !drafting;
    const said = textOf(state);
    if (text.textContent !== said) text.textContent = said;
    const surveyed = surveyedChoice(state, facts);
    use.hidden = surveyed === null || drafting;
    if (surveyed !== null) useSelect.value = surveyed.role ?? '';
    // What is pressed to take the last press back comes first.
    passFocus(held, [...(counterparts.get(held) ?? []), measure, add, undo, redo, byId('block-view')]);
  };
  store.watch(['history', 'marks', 'files', 'selection', 'shown', 'running', 'adjusting', 'before', 'draft', 'onStage', 'panes'], show);
  facts.watch(show);
  return bar;
}

const USES = [
  ['control', say('control-point')],
  ['check', say('check-point')],
  ['', say('not-used')],
] as const;

/** The surveyed point that is chosen alone, with its role; null for another one, and while its figures are on their way. */
function surveyedChoice({ selection }: BlockState, facts: Facts): { point: number; role: PointDetail['role'] } | null {
  const [point, ...more] = pointsOf(selection.chosen);
  const detail = point === undefined || more.length > 0 ? null : facts.point(point);
  return detail?.id != null && 'ground_control' in detail.id ? { point: detail.id.ground_control, role: detail.role } : null;
}

function textOf({ draft, adjusting, before, shown }: BlockState): string {
  if (draft !== null) {
    const placed = draft.places.size;
    const what = draft.of === null ? say('new-point') : isGiven(draft.of) ? draft.of.given : say('point');
    const more = draft.of === null && placed < 2 ? say('two-images-or-more-are') : '';
    return say('placed-in-press-its-place', { what, placed, more });
  }
  if (adjusting) return say('adjusting-the-block');
  if (before === null || shown === null || shown.edits.length === 0) return '';
  return comparedText(before, figuresOf(shown.view));
}

/** The keys of edits: undo and redo wherever the block is shown, the others on the stage and in the tables. */
export function mountBlockEditKeys(store: BlockStore, hosts: readonly HTMLElement[]): void {
  // Links of images that were placed by themselves have keys of their own.
  const isBlockSeen = () => store.state.onStage !== 'orthophoto' || blockOnOrthophoto(store.state) !== null || takesPlaces(store.state);
  undoKeys(
    () => byId('block-view').offsetParent !== null && store.state.history.edits.length + store.state.marks.edits.length > 0 && isBlockSeen(),
    (by) => step(store, by),
  );
  const idle = () => store.state.draft === null && isBlockSeen();
  const list: Command[] = [
    {
      keys: ['Delete', 'Backspace'],
      does: say('rejects-what-is-chosen-with'),
      can: idle,
      run: (shift) => make(store, editOf(store.state, 'reject', shift)),
    },
    { keys: ['r'], does: say('uses-what-is-chosen-again'), can: idle, run: (shift) => make(store, editOf(store.state, 'restore', shift)) },
  ];
  const edits = declare({ where: say('views-and-tables-of-a'), host: byId('block-view'), list });
  for (const host of hosts) listenKeys(host, edits);
}

/** In the details: the figures before and after, what is rejected, and all edits. */
export function mountEditPanel(host: HTMLElement, store: BlockStore): void {
  const compared = h('div', { testid: 'block-compared' });
  const rejected = h('ul', { class: 'rejected', testid: 'block-rejected' });
  const history = h('ol', { class: 'history', testid: 'block-history' });
  const marked = h('div', { testid: 'block-marked' });
  const hint = h('p', { class: 'note' }, say('choose-an-image-a-tie'));
  host.append(h('div', { class: 'edits' }, hint, compared, marked, h('h3', {}, say('rejected-by-hand')), rejected, h('h3', {}, say('history')), history));
  mountMarks(marked, store, history);
  store.watch(['history', 'marks', 'shown', 'before', 'adjusting'], ([edits, marks, shown, before, adjusting]) => {
    const names = namesIn(store.state);
    const both = { history: edits, marks };
    showHistory(
      history,
      'block-',
      say('as-found'),
      timelineOf(both),
      (one) => nameOfTimed(both, one, names),
      (done) => go(store, heldAt(store.state, done)),
    );
    fill(compared, ...(shown === null || before === null || shown.edits.length === 0 ? [] : [comparison(before, adjusting ? null : figuresOf(shown.view))]));
    const standing = shown === null ? [] : rejectedRows(shown.view, standingOf(shown.edits));
    const at = [...rejected.querySelectorAll('button')].indexOf(document.activeElement as HTMLButtonElement);
    const held = at < 0 ? null : document.activeElement;
    fill(
      rejected,
      ...(standing.length === 0 ? [h('li', {}, say('nothing'))] : standing.map(({ name, edit }) => h('li', {}, `${name} `, restoreButton(store, name, edit)))),
    );
    const buttons = rejected.querySelectorAll('button');
    passFocus(held, [buttons[at], buttons[at - 1], history.querySelector<HTMLElement>('[aria-current]')]);
  });
}

/** The measurements of control and check points by hand, each of which can be taken away. `after`: has the keyboard where none is left. */
function mountMarks(host: HTMLElement, store: BlockStore, after: HTMLElement): void {
  const list = h('ul', { class: 'rejected', testid: 'block-marks-list' });
  store.watch(['marks'], ([marks]) => {
    const at = [...list.querySelectorAll('button')].indexOf(document.activeElement as HTMLButtonElement);
    const held = at < 0 ? null : document.activeElement;
    const byHand = marksByHand(marks);
    fill(
      list,
      ...byHand.map((mark) => {
        const name = say('mark-of', { point: mark.point, image: mark.image });
        const remove = button(say('remove'), `remove-mark-${mark.point}-${mark.image}`, () =>
          store.dispatch({ type: 'mark', step: { kind: 'remove', marks: [mark], after: store.state.history.done } }),
        );
        remove.className = 'link';
        remove.setAttribute('aria-label', say('remove-2', { title: name }));
        return h('li', {}, `${name}: ${fixed(mark.x_px, 1)} ${fixed(mark.y_px, 1)} `, remove);
      }),
    );
    fill(host, ...(byHand.length === 0 ? [] : [h('h3', {}, say('marks-by-hand')), list]));
    const buttons = list.querySelectorAll('button');
    passFocus(held, [buttons[at], buttons[at - 1], after.querySelector<HTMLElement>('[aria-current]')]);
  });
}

function restoreButton(store: BlockStore, name: string, edit: BlockEdit): HTMLElement {
  const made = button(say('restore'), `restore-${name}`, () => make(store, edit));
  made.className = 'link';
  made.setAttribute('aria-label', say('restore-2', { name }));
  return made;
}

/** Of what was rejected so many are listed one by one. */
const LISTED = 200;

function rejectedRows(view: BlockView, { images, pairs, points, unused, observations }: Standing): { name: string; edit: BlockEdit }[] {
  const imageName = (image: number) => view.images[image]?.name ?? '';
  const pointName = (point: PointSource) => {
    const index = indexOfSource(view, point);
    if (index >= 0) return nameOfPoint(view, index);
    return Object.entries(point)
      .map(([kind, number]) => say('point-of-kind', { kind, number: Number(number) }))
      .join('');
  };
  return [
    ...[...images].map((image) => ({ name: imageName(image), edit: { kind: 'restore_images' as const, images: [image] } })),
    ...[...pairs.values()].map((pair) => ({ name: nameOfPair(view, pair), edit: { kind: 'restore_pairs' as const, pairs: [pair] } })),
    ...[...points.values()].map((point) => ({ name: pointName(point), edit: { kind: 'restore_points' as const, points: [point] } })),
    ...[...unused].map((point) => ({
      name: pointName({ ground_control: point }),
      edit: { kind: 'restore_points' as const, points: [{ ground_control: point }] },
    })),
    ...[...observations.values()].map((one) => ({
      name: say('in', { point: pointName(one.point), image: imageName(one.image) }),
      edit: { kind: 'restore_observations' as const, observations: [one] },
    })),
  ].slice(0, LISTED);
}

function comparison(before: Figures, now: Figures | null): HTMLElement {
  const line = (name: string, testid: string, text: (of: Figures) => string) =>
    row(
      name,
      h('td', { class: 'number', testid: `${testid}-before` }, text(before)),
      h('td', { class: 'number', testid: `${testid}-now` }, now === null ? '…' : text(now)),
    );
  const head = h('tr', {}, h('th', { scope: 'col' }, say('block')), h('th', { scope: 'col' }, say('before')), h('th', { scope: 'col' }, say('now')));
  const checks = before.checks !== null || now?.checks != null;
  const areOthers = now !== null && before.checks?.points !== now.checks?.points;
  const body = h(
    'tbody',
    {},
    line('σ₀, px', 'block-compared-sigma0', ({ sigma0Px }) => figureText(sigma0Px)),
    line(say('rmse-px-2'), 'block-compared-rmse', ({ rmsePx }) => figureText(rmsePx)),
    checks ? line(say('check-points-rmse-m'), 'block-compared-checks', (of) => figureText(of.checks?.rmseM ?? null)) : null,
    areOthers ? line(say('check-points-compared'), 'block-compared-check-points', (of) => count(of.checks?.points ?? 0)) : null,
    line(say('images-oriented-2'), 'block-compared-images', ({ oriented }) => count(oriented)),
    line(say('points-2'), 'block-compared-points', ({ points }) => count(points)),
    line(say('observations-5'), 'block-compared-observations', ({ observations }) => count(observations)),
  );
  return h('table', { class: 'tight', aria: { label: say('block-before-and-after-the') } }, h('thead', {}, head), body);
}
