/** The answer of a block: what came of it; while there is none what runs, how far it is, what went wrong, and what to do. */
import type { Parameter } from '../../shared/crate';
import { button, h } from '../../shared/panel/dom';
import { answerCard } from '../../shared/panel/answer';
import type { Answer, Figure, Next } from '../../shared/panel/answer';
import { count, fixed, sentence } from '../../shared/text/format';
import { firstNamed, readable } from '../../shared/text/names';
import type { Labels } from '../../shared/text/names';
import type { BlockStore } from '../engine/engine';
import { heightsText, placingAnswer, placingRuns } from './placing-answer';
import { duration, progressBar, runText } from './progress';
import { orthophotoText } from '../files/ground';
import { doubtOf } from '../state/doubt';
import { medianErrors } from '../state/ground';
import { lackingText } from '../state/lacking';
import { collectedOf, waitsForMarks } from '../state/marks';
import { countedPoints } from '../state/point-kinds';
import { controlText } from '../state/words';
import { unplacedFiles } from '../state/placed';
import type { Purpose } from '../state/placing';
import { framesStep } from '../state/frames-step';
import { asksPurpose, isHeldByHand, isOffGround, lacksPlaceAlone, purposeOf } from '../state/purpose';
import { unitOf } from '../state/scale';
import { isInSystemOf } from '../state/showing';
import { isBusy, isOutdated } from '../state/state';
import type { BlockCatalogue, BlockState, Shown } from '../state/state';
import type { CheckSummary } from '../../../pkg/wasm/tiepoint.js';
import type { BlockView } from '../state/view';
import { ofLine } from '../../shared/state/notice';
import { refusedText, say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';
import { declareLack } from '../../shared/panel/lack';
import { lackOfImages } from '../state/lacks';

/** What the button beside the answer can do. */
export interface BlockAnswerActions {
  run: () => void;
  /** Shows what speaks against the result. */
  why: () => void;
  save: () => void;
  /** Opens photos of one's own. */
  open: () => void;
  /** Places images on the orthophoto. */
  place: () => void;
  /** Does it with the orthophoto, from now on. */
  decide: (purpose: Purpose) => void;
  /** Ends whatever goes on. */
  cancel: () => void;
  openHeights: () => void;
  /** Saves what was placed. */
  savePlaced: () => void;
  /** Shows the table of what was placed. */
  whyPlaced: () => void;
  /** Shows the field of a setting. */
  openSetting: (key: string) => void;
}

/** `details`: the button that shows them. */
export function mountBlockStatus(store: BlockStore, actions: BlockAnswerActions, details: HTMLElement): HTMLElement {
  const line = h('p', { class: 'status', testid: 'block-status', role: 'status', aria: { live: 'polite' } });
  const run = button(say('run'), 'block-run', () => {
    if (places(store.state)) actions.place();
    else actions.run();
  });
  const cancel = button(say('cancel'), 'block-cancel', actions.cancel);
  declareLack([run], () => lackOfImages(store.state));
  declareLack([cancel], () => (cancel.disabled || cancel.hidden ? say('nothing-is-running') : ''));
  const buttons = h('div', { class: 'answer-actions' }, progressBar(store), run, cancel, details);
  const card = h('div', { class: 'answer', testid: 'block-answer' }, line, buttons);
  const show = answerCard(card, line, buttons, 'block-');
  store.watch(
    (s) => [s] as const,
    ([state]) => {
      const { catalogue } = state;
      const answer = readableAnswer(doubted(offeringSetting(answerOf(state, actions), catalogue, actions), doubtOf(state)), catalogue?.labels ?? null);
      // Each image and pair would be read out.
      line.setAttribute('aria-live', answer.kind === 'busy' ? 'off' : 'polite');
      show(answer);
      run.disabled = isBusy(state) || asksForOrthophoto(state) || (places(state) ? unplacedFiles(state).length === 0 : state.files.length < 2);
      run.textContent = places(state) ? say('place-them') : state.running.kind === 'ended' ? say('go-on') : say('run');
      run.classList.toggle('primary', answer.next == null && !run.disabled && (state.onStage !== 'orthophoto' || places(state)));
      cancel.disabled = !isBusy(state);
    },
  );
  return card;
}

/** Messages of the crate name parameters by their keys, and by options of the command. */
function readableAnswer({ text, more, said, problem, ...answer }: Answer, labels: Labels | null): Answer {
  return {
    ...answer,
    text: readable(labels, text),
    ...(more === undefined ? {} : { more: readable(labels, more) }),
    ...(said === undefined ? {} : { said: readable(labels, said) }),
    ...(problem === undefined ? {} : { problem: readable(labels, problem) }),
  };
}

/** Of a problem that names a setting: its field is what comes next. */
function offeringSetting(answer: Answer, catalogue: BlockCatalogue | null, actions: BlockAnswerActions): Answer {
  if (answer.kind !== 'problem' || answer.next != null || catalogue === null) return answer;
  const named = firstNamed([...catalogue.parameters, ...catalogue.placingParameters], answer.text);
  return named === null ? answer : { ...answer, next: openField(named, actions) };
}

function openField({ key, label }: Parameter, { openSetting }: BlockAnswerActions): Next {
  return { text: say('open-the-setting', { label }), act: () => openSetting(key) };
}

function doubted(answer: Answer, doubt: string): Answer {
  return doubt === '' ? answer : { ...answer, more: `${answer.more ?? ''} ${doubt}`.trimStart() };
}

function placed(state: BlockState, actions: BlockAnswerActions): Answer {
  return placingAnswer(state, { ...actions, asBlock: () => actions.decide('block'), save: actions.savePlaced, why: actions.whyPlaced });
}

/** Whether it is about images on an orthophoto, each by itself. */
function places(state: BlockState): boolean {
  return state.onStage === 'orthophoto' && purposeOf(state) === 'images';
}

/** Whether the view of the orthophoto has none yet: it offers to open one, and nothing else is done there. */
function asksForOrthophoto({ onStage, placing }: BlockState): boolean {
  return onStage === 'orthophoto' && placing.orthophoto === null;
}

/** Whether what is said is of the orthophoto: of images on it, or of a block that is not there yet. */
function isOfGround(state: BlockState): boolean {
  const { onStage, placing, shown } = state;
  if (onStage !== 'orthophoto') return false;
  const purpose = purposeOf(state);
  return placing.orthophoto === null || purpose === 'images' || (purpose === 'block' && (shown === null || shown.view.partial));
}

/** Whether a whole block is shown, of what is given now. */
function isFinished(state: BlockState): boolean {
  return state.shown !== null && !state.shown.view.partial && !isOutdated(state);
}

/** The verdict of a finished block with what is said of its orthophoto: that is no other verdict. */
function besideVerdict(state: BlockState, actions: BlockAnswerActions, text: string): Answer {
  const { shown } = state;
  if (shown === null || !isFinished(state)) return { kind: 'idle', verdict: null, text };
  return { ...answered(state, shown, actions), more: text };
}

/** An answer with what can be done with the orthophoto. */
function offering(state: BlockState, actions: BlockAnswerActions, answer: Answer): Answer {
  const { more, ...offer } = offered(state, actions);
  return { ...answer, ...offer, more: [answer.more ?? '', more ?? ''].join(' ').trim() };
}

/** What can be done with an orthophoto under a finished block: one choice. */
function offered(state: BlockState, { decide }: BlockAnswerActions): Pick<Answer, 'more' | 'next' | 'others'> {
  const lies = !isHeldByHand(state) && state.shown?.view.surveyed.some(({ role, isUsed }) => role === 'control' && isUsed) === true;
  const place = { text: say('place-the-block-on-the'), act: () => decide('block') };
  return {
    more: [
      lies ? say('control-places-the-block') : toBePlacedText(state, say('a-block-on-an-orthophoto')),
      state.placing.heights.kind === 'level' ? heightsText(state) : '',
    ]
      .join(' ')
      .trim(),
    // A block that control points georeference lies where it is to lie: nothing more is to be done with it.
    ...(lies ? {} : { next: place }),
    others: [
      ...(lies ? [place] : []),
      { text: say('place-each-image'), act: () => decide('images') },
      // In the block's own system it does not lie there.
      { text: lies ? say('only-under-the-map') : say('not-now'), act: () => decide('map') },
    ],
  };
}

/** What is said of a block that can be placed on the orthophoto: one that places by hand hold lies there already. */
function toBePlacedText(state: BlockState, text: string): string {
  return isHeldByHand(state) ? `${state.shown?.view.orthophoto?.text ?? ''} ${say('places-found-hold-it-too')}` : text;
}

function placeBlock({ run }: BlockAnswerActions): Next {
  return { text: say('place-the-block-on-the'), act: run };
}

function answerOf(state: BlockState, actions: BlockAnswerActions): Answer {
  const { running, shown, files, placing } = state;
  const passed = state.notice?.passing === true && running.kind !== 'yes' && placing.running === null;
  const notice = passed ? null : ofLine(state.notice);
  const line = (kind: Answer['kind'], text: string): Answer => ({ kind, text, verdict: null });
  const beside = notice?.beside === true ? notice.text : '';
  if (running.kind === 'yes') return { ...line('busy', runText(running.steps)), more: beside };
  if (state.placing.running !== null) return { ...placingRuns(state.placing.running), more: beside };
  if (notice?.beside === true) {
    return { ...answerOf({ ...state, notice: null }, actions), said: notice.text };
  }
  if (notice !== null) {
    const said = line(notice.kind === 'info' ? 'idle' : notice.kind, notice.text);
    const isInfo = notice.kind === 'info';
    if (notice.kind !== 'busy' && asksPurpose(state)) return offering(state, actions, isInfo ? besideVerdict(state, actions, notice.text) : said);
    // What was taken in is said; what is next stays.
    if (isInfo && lacksPlaceAlone(state)) return { ...besideVerdict(state, actions, notice.text), next: placeBlock(actions) };
    if (notice.kind !== 'busy' && shown !== null && isFinished(state) && !isOfGround(state)) {
      const answer = answered(state, shown, actions);
      return { ...answer, ...(isInfo ? { said: notice.text } : { problem: notice.text }) };
    }
    if (!isInfo || state.placing.orthophoto === null || !isOfGround(state)) return said;
    const { next = null, others = [] } = placed(state, actions);
    return { ...said, next, others };
  }
  if (state.refused !== null) return { ...line('problem', refusedText(state.refused.label)), next: openField(state.refused, actions) };
  if (asksPurpose(state) && state.placing.orthophoto !== null)
    return offering(state, actions, besideVerdict(state, actions, orthophotoText(state.placing.orthophoto)));
  if (isOfGround(state)) return placed(state, actions);
  if (running.kind === 'ended') {
    const former = shown !== null && !shown.view.partial ? say('the-screen-shows-the-former') : '';
    if (running.failure === null) return line('idle', say('cancelled-the-work-done-is', { former, what: former === '' ? say('shown-and') : '' }));
    return line(
      'problem',
      say('the-block-was-not-finished', { failure: sentence(running.failure), what: former === '' ? say('the-work-done-is-kept') : former }),
    );
  }
  if (shown !== null && !shown.view.partial && !isOutdated(state)) {
    if (isOffGround(state))
      return { ...besideVerdict(state, actions, `${toBePlacedText(state, say('the-block-is-not-on'))} ${heightsText(state)}`), next: placeBlock(actions) };
    const answer = answered(state, shown, actions);
    return waitsForMarks(state) ? { ...answer, more: `${answer.more ?? ''} ${controlText(state)}`.trimStart() } : answer;
  }
  if (shown !== null && !shown.view.partial && takesMarks(state)) {
    const text = say('control-can-be-taken', { twice: collectedOf(state).twice });
    return { ...line('idle', text), more: say('taking-the-control', { kept: state.history.done > 0 ? 'edits' : 'none' }), next: takeControl(actions) };
  }
  if (files.length >= 2) {
    const first = framesStep(state);
    const run = shown === null || shown.view.partial ? say('press-run') : say('images-or-settings-have-changed');
    const why = first === '' ? run : first;
    return line('idle', `${say('block-images', { images: files.length })} ${why}`);
  }
  return line('idle', say('open-the-images-of-a'));
}

/** Whether measurements of control points by hand are what the block would be run anew for. */
function takesMarks(state: BlockState): boolean {
  const { run, asGiven } = collectedOf(state);
  return run !== null && !asGiven && state.files.length >= 2;
}

function takeControl({ run }: BlockAnswerActions): Next {
  return { text: say('take-the-control'), act: run };
}

function answered(state: BlockState, shown: Shown, actions: BlockAnswerActions): Answer {
  const { view, files } = shown;
  const why: Next = { text: say('show-why'), act: actions.why };
  // A block that was opened may never have been oriented.
  if (view.oriented > 0 || files.length === 0) {
    const sound = view.verdict?.kind === 'oriented';
    const next = state.truth === null ? { text: say('save-the-project'), act: actions.save } : { text: say('open-your-photos'), act: actions.open };
    return {
      kind: sound ? 'done' : 'partial',
      verdict: view.verdict?.kind ?? 'weak',
      text: view.verdict?.text ?? '',
      // Where it lies says more than its counts, which the results have.
      more: [view.orthophoto !== null && isInSystemOf(view) ? view.orthophoto.text : countsOf(shown), lackingText(state)].join(' ').trim(),
      figures: figuresOf(view),
      next: sound ? next : why,
    };
  }
  const group = view.groups[0]?.length ?? 0;
  const figures = {
    why: view.warnings[0] ?? message('overview_warning', { kind: 'none_oriented' }),
    group: group < view.images.length ? group : null,
    images: view.images.length,
    pairs: connectedPairs(view),
    points: view.points.taking,
  };
  // Images that show no common ground may each lie on the orthophoto.
  const others = state.placing.orthophoto === null ? [] : [{ text: say('place-each-image'), act: () => actions.decide('images') }];
  return { kind: 'problem', verdict: 'not_oriented', text: say('block-not-oriented', figures), next: why, others };
}

function figuresOf(view: BlockView): Figure[] {
  return [
    { value: say('of-4', { oriented: view.oriented, images: view.images.length }), label: say('images-oriented-2') },
    { value: count(view.points.taking), label: say('tie-points-used') },
    ...(view.sigma0Px === null ? [] : [{ value: say('px-2', { value: view.sigma0Px }), label: say('sigma-of-image-observations') }]),
    // What took no part judges the block from outside: σ₀ does not.
    ...(view.checks === null ? groundFigure(view) : [checkFigure(view.checks)]),
  ];
}

/** What the adjustment expects of its tie points: pixels say nothing of metres. */
function groundFigure(view: BlockView): Figure[] {
  const [plan, height] = medianErrors(view);
  if (unitOf(view) === '' || !Number.isFinite(plan) || !Number.isFinite(height)) return [];
  const written = (error: number) => fixed(error, error < 1 ? 3 : 2);
  return [{ value: say('plan-and-height-of', { plan: written(plan), height: written(height) }), label: say('median-errors-of-tie-points') }];
}

function checkFigure({ points, plan_rmse_m: plan, height_rmse_m: height }: CheckSummary): Figure {
  return { value: say('plan-and-height-m', { plan, height }), label: say('rmse-of-check-points', { points }) };
}

function connectedPairs({ connections }: BlockView): number {
  return connections.filter(({ outcome }) => outcome.kind === 'connected').length;
}

/** What there is of it, after its verdict. */
function countsOf({ view, seconds }: Shown): string {
  const counted = countedPoints(view);
  return say('block-done', {
    images: view.images.length,
    verdict: '',
    skipped: view.leftOut.length,
    name: view.leftOut[0]?.name ?? '',
    reason: view.leftOut[0]?.reason ?? '',
    pairs: connectedPairs(view),
    points: counted.tie.points,
    surveyed: counted.surveyed.points,
    found: view.found?.points ?? null,
    time: seconds === 0 ? null : duration(seconds),
    warnings: view.warnings.length,
  }).trim();
}
