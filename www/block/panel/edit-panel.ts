import { button, fill, h, row } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { showHistory } from '../../shared/panel/history';
import { count, fixed } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import { figuresOf, figureText } from '../state/edited';
import type { Figures } from '../state/edited';
import { indexOfSource, standingOf } from '../state/edits';
import { marksByHand } from '../state/marks';
import type { BlockEdit, PointSource } from '../../../pkg/wasm/tiepoint.js';
import type { Standing } from '../state/edits';
import { heldAt, timelineOf } from '../state/timeline';
import type { BlockView } from '../state/view';
import { nameOfPair, nameOfPoint } from '../state/words';
import { say } from '../../shared/text/words';
import { goTo, makeEdit, nameOfTimed, namesIn } from './edits';

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
      (done) => goTo(store, heldAt(store.state, done)),
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
  const made = button(say('restore'), `restore-${name}`, () => makeEdit(store, edit));
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
