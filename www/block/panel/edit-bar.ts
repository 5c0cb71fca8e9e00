/** Over the views: what can be done to what is chosen, and what the latest edit did. */
import { choice } from '../../shared/panel/choice';
import { button, byId, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { set, showSteps } from '../../shared/panel/history';
import { declareLack } from '../../shared/panel/lack';
import { NotListed } from '../../shared/panel/not-listed';
import { declarePlace } from '../../shared/panel/reach';
import { fixed } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { isGiven, nameOfDraft, placesAsSteps, stepOfDraft } from '../state/draft';
import { comparedText, figuresOf } from '../state/edited';
import type { Draft } from '../state/edited';
import { editsInForce, isEditable } from '../state/editing';
import { addedPoints } from '../state/added';
import type { MarkStep } from '../state/marks';
import { nameOfEdit, nameOfMarks, NO_NAMES } from '../state/naming';
import type { BlockEdit, PointDetail } from '../../../pkg/wasm/tiepoint.js';
import type { Names } from '../state/naming';
import { apart, joined, split } from '../state/joining';
import { shownImages } from '../state/panes';
import { listedChoice } from '../state/listed';
import { isMeasurable } from '../state/point-kinds';
import { pointsOf } from '../state/selection';
import { removable } from '../state/removing';
import { timelineOf } from '../state/timeline';
import type { BlockState } from '../state/state';
import { say } from '../../shared/text/words';
import { chosenOf, editOf, makeEdit, nameOfTimed, namesIn, stepBy } from './edits';
import { lackOfBlock } from '../state/lacks';

/** What measures points, once the images view is there. */
export interface Measures {
  toggle: (anew: boolean) => void;
  match: () => void;
  matchAlone: () => void;
}

function makeStep(store: BlockStore, edits: readonly BlockEdit[] | null): void {
  if (edits !== null) store.dispatch({ type: 'edit', edits });
}

/** So many points may be one. */
const MOST_JOINED = 8;

/** The points that are chosen to be one; null where they cannot be, and while their figures are on their way. */
function toJoin(state: BlockState, facts: Facts): readonly PointDetail[] | null {
  const { shown } = state;
  const chosen = chosenOf(state, facts);
  const points = chosen?.kind === 'points' ? chosen.points : pointsOf(null);
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

/** Takes the chosen images out of the block; null where they cannot be. */
function removalOf(state: BlockState, facts: Facts): Extract<MarkStep, { kind: 'remove_images' }> | null {
  const { files, shown, history } = state;
  const out = removable(files, chosenOf(state, facts), shown?.view.images ?? []);
  return out.length === 0 ? null : { kind: 'remove_images', files: out.map(({ id }) => id), after: history.done };
}

/** The keyboard stays with what is chosen. */
function removeImages(store: BlockStore, facts: Facts): void {
  const step = removalOf(store.state, facts);
  if (step !== null) store.dispatch({ type: 'mark', step });
}

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
  const undo = button(say('undo-sign'), 'block-undo', () => stepBy(store, -1));
  const redo = button(say('redo-sign'), 'block-redo', () => stepBy(store, 1));
  const reject = button(say('reject'), 'block-reject', () => makeEdit(store, editOf(store.state, facts, 'reject')), say('take-what-is-chosen-out'));
  const whole = button(
    say('reject-point'),
    'block-reject-point',
    () => makeEdit(store, editOf(store.state, facts, 'reject', true)),
    say('take-the-point-with-all'),
  );
  const restore = button(say('restore'), 'block-restore', () => makeEdit(store, editOf(store.state, facts, 'restore')), say('use-what-is-chosen-again'));
  const remove = button(say('remove-image'), 'block-remove-image', () => removeImages(store, facts), say('take-the-chosen-image-out'));
  const measure = button(
    say('measure-it'),
    'block-measure',
    () => {
      if (store.state.onStage !== 'images') store.dispatch({ type: 'stage', view: 'images' });
      measures()?.toggle(false);
      toImages();
    },
    say('measure-the-chosen-point-in'),
  );
  const add = button(
    say('add-point'),
    'block-add-point',
    () => {
      measures()?.toggle(true);
      toImages();
    },
    say('measure-a-new-tie-point'),
  );
  const joining = button(say('join'), 'block-join', () => join(store, facts), say('the-chosen-points-are-one'));
  const parting = button(say('split'), 'block-split', () => makeStep(store, splitOf(store.state, facts)), say('the-point-is-two-one'));
  const match = button(
    say('match-it'),
    'block-match',
    () => {
      measures()?.match();
      toImages();
    },
    say('match-the-point-in-the'),
  );
  const alone = button(
    say('match-here'),
    'block-match-alone',
    () => {
      measures()?.matchAlone();
      toImages();
    },
    say('match-the-point-here'),
  );
  const accept = button(say('accept'), 'block-accept', () => store.dispatch({ type: 'accept', leaves: false }), say('the-point-is-measured-enter'));
  const leave = button(say('cancel'), 'block-leave', () => store.dispatch({ type: 'draft', draft: null }), say('give-what-is-measured-up'));
  const [use, useSelect] = choice(say('use-as'), 'block-use', USES, (value) => {
    const surveyed = surveyedChoice(store.state, facts);
    const role = value === 'control' || value === 'check' ? value : null;
    if (surveyed !== null) makeEdit(store, { kind: 'set_use', point: surveyed.point, use: role });
  });
  const notListed = new NotListed('block-not-listed', [reject, restore, remove]);
  const text = h('span', { class: 'edit-text', testid: 'block-edit-text', role: 'status', aria: { live: 'polite' } });
  const bar = h(
    'div',
    { class: 'toolbar edit-bar', testid: 'block-edit-bar', role: 'toolbar', aria: { label: say('edits-by-hand') } },
    ...[undo, redo, reject, whole, restore, remove, notListed.element, joining, parting, measure, add, match, alone, accept, leave, use, text],
  );
  for (const [made, lack] of [
    [reject, say('nothing-to-reject-is-chosen')],
    [whole, say('no-point-is-chosen')],
    [restore, say('nothing-rejected-is-chosen')],
    [remove, say('no-chosen-image')],
    [joining, say('no-points-to-join')],
    [parting, say('no-point-to-split')],
    [measure, say('no-point-is-chosen')],
    [match, say('no-point-is-chosen')],
    [alone, say('no-point-is-chosen')],
  ] as const)
    declareLack([made], () => lackOfBlock(store.state) || lack);
  declareLack([accept, leave], () => (store.state.draft === null ? say('nothing-is-measured') : ''));
  declarePlace([measure, add], {
    title: say('images-2'),
    show: () => store.dispatch({ type: 'stage', view: 'images' }),
    can: () => isEditable(store.state) && store.state.onStage !== 'images' && store.state.draft === null,
  });
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
    // While a point is measured its places are what is taken back, so that nothing else is offered.
    if (state.draft === null) showSteps(undo, redo, timelineOf(state), (one) => nameOfTimed(state, one, names));
    else showSteps(undo, redo, placesAsSteps(state.draft), (image) => say('step-place-in', { image: state.shown?.view.images[image]?.name ?? '' }));
    const [off, point, on] = [editOf(state, facts, 'reject'), editOf(state, facts, 'reject', true), editOf(state, facts, 'restore')];
    const drafting = state.draft !== null;
    set(reject, titleOf(off, say('reject'), NO_NAMES), off === null);
    set(restore, titleOf(on, say('restore'), NO_NAMES), on === null);
    reject.hidden = drafting || (off === null && on !== null);
    restore.hidden = drafting || on === null;
    whole.hidden = drafting || chosen?.kind !== 'observation' || point === null;
    const removal = removalOf(state, facts);
    remove.hidden = drafting || removal === null;
    set(remove, removal === null || removal.files.length === 1 ? say('remove-image') : capital(nameOfMarks(removal)), false);
    notListed.show(state.shown === null || drafting ? 0 : listedChoice(state.selection, state.shown.view, () => facts.observations()).others);
    const inImages = state.onStage === 'images';
    // A point that no image shows yet is measured in the images, whatever view it was chosen in.
    const given = chosen?.kind === 'given';
    measure.hidden = drafting || !(inImages || given);
    const isPoint = chosen?.kind === 'point' || chosen?.kind === 'observation';
    measure.disabled = !given && !(isPoint && state.shown !== null && isMeasurable(state.shown.view, chosen.point));
    add.hidden = drafting || !inImages;
    joining.hidden = drafting || toJoin(state, facts) === null;
    parting.hidden = drafting || !inImages || splitOf(state, facts) === null;
    match.hidden = !inImages || ((measure.disabled || given) && !drafting);
    alone.hidden = match.hidden || state.shown === null || shownImages(state.panes, state.shown.view).length < 2;
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

/** What is begun by a button goes on by the keys of the images: Enter accepts, Escape gives up. */
const toImages = () => byId('block-view').focus({ preventScroll: true });

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

/** What would say where images show a given point, where nothing does; empty where something does. */
function unplacedText({ of }: Draft, { shown, options }: BlockState): string {
  const point = isGiven(of) ? shown?.given.find(({ name }) => name === of.given) : undefined;
  if (shown === null || point === undefined || point.place !== null || point.images > 0) return '';
  return say('where-it-lies-is-not-known', { by: shown.view.origin !== null && options.settings?.placing.crs == null ? 'system' : 'points' });
}

function textOf(state: BlockState): string {
  const { draft, adjusting, before, shown } = state;
  if (draft !== null) {
    const placed = draft.places.size;
    const what = shown === null ? '' : nameOfDraft(draft, shown.view);
    const more = draft.of === null && placed < 2 ? say('two-images-or-more-are') : placed === 0 ? unplacedText(draft, state) : '';
    return say('placed-in-press-its-place', { what, placed, more });
  }
  if (adjusting) return say('adjusting-the-block');
  if (before === null || shown === null || shown.edits.length === 0) return '';
  return comparedText(before, figuresOf(shown.view));
}
