/** The answer: what came of a run in one sentence, the figures that decided, and what to do next. It stands beside the picture, where nothing has to be scrolled. */
import { button, fill, h } from './dom';
import { byKeys } from './scrolled';
import { say } from '../text/words';

export interface Figure {
  value: string;
  label: string;
}

/** The one thing to do next. */
export interface Next {
  text: string;
  act: () => void;
}

export interface Answer {
  /** `partial`: not oriented, or weakly. */
  kind: 'idle' | 'busy' | 'done' | 'partial' | 'problem';
  /** What the result is worth; null while there is none. */
  verdict: 'oriented' | 'weak' | 'not_oriented' | null;
  text: string;
  /** What is said after it, smaller. */
  more?: string;
  /** What was done since, as a file that was saved; it comes after that. */
  said?: string;
  /** What went wrong since: the answer stays. */
  problem?: string;
  figures?: readonly Figure[];
  next?: Next | null;
  /** What can be done in its place. */
  others?: readonly Next[];
}

/** Shows answers in `host`, whose line for the sentence is `line`; the button for what is next comes before the others. */
export function answerCard(host: HTMLElement, line: HTMLElement, buttons: HTMLElement, prefix: string): (answer: Answer) => void {
  const figures = h('dl', { class: 'figures', testid: `${prefix}figures` });
  let act: () => void = () => undefined;
  let instead: readonly Next[] = [];
  const press = button('', `${prefix}next`, () => act());
  press.className = 'primary';
  const others = h('span', { class: 'answer-others' });
  let offered = '';
  // What does not fit on a phone is uncovered by a press.
  const more = button('', `${prefix}more`, () => uncover(!host.classList.contains('is-open')));
  more.className = 'link uncover';
  line.after(figures);
  const uncover = (open: boolean) => {
    host.classList.toggle('is-open', open);
    more.textContent = say(open ? 'less-of-the-answer' : 'more-of-the-answer');
    more.setAttribute('aria-expanded', String(open));
  };
  const scrolled = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target !== line || getComputedStyle(line).overflowY !== 'visible') byKeys(target);
      else line.removeAttribute('tabindex');
    }
    const isCut = [host, line, ...line.children].some(({ clientHeight, scrollHeight }) => clientHeight > 0 && scrollHeight > clientHeight + 1);
    more.hidden = !host.classList.contains('is-open') && !isCut;
  });
  more.hidden = true;
  uncover(false);
  buttons.prepend(press, others);
  buttons.append(more);
  /** How high it is while nothing runs, as the browser has laid it out. */
  let height = 0;
  new ResizeObserver(() => {
    if (host.dataset.kind !== 'busy' && !host.classList.contains('is-open')) ({ height } = host.getBoundingClientRect());
  }).observe(host);
  return ({ kind, verdict, text, more: after = '', said = '', problem = '', figures: found = [], next = null, others: now = [] }) => {
    instead = now;
    host.dataset.kind = kind;
    // While something runs it says less: what is beside it stays where it is.
    host.style.minHeight = kind === 'busy' && height > 0 ? `${String(height)}px` : '';
    host.dataset.verdict = verdict ?? '';
    line.dataset.kind = kind;
    // What is said already would be read out again.
    if (line.textContent !== [text, after, said, problem].filter((part) => part !== '').join(' ')) {
      const rest = [h('span', {}, after), h('span', { class: 'done-since' }, said), h('span', { class: 'wrong' }, problem)].filter(
        (part) => part.textContent !== '',
      );
      fill(line, h('strong', {}, text), ...rest.flatMap((part) => [' ', part]));
      scrolled.disconnect();
      uncover(false);
      for (const part of [line, ...rest]) scrolled.observe(part);
    }
    fill(figures, ...found.map(({ value, label }) => h('div', {}, h('dt', {}, label), h('dd', {}, value))));
    figures.hidden = found.length === 0;
    act = next?.act ?? (() => undefined);
    press.hidden = next === null;
    if (press.textContent !== (next?.text ?? '')) press.textContent = next?.text ?? '';
    host.classList.toggle('has-choice', instead.length > 0);
    // What is offered already keeps its focus.
    const texts = instead.map(({ text: own }) => own).join('\n');
    if (texts === offered) return;
    offered = texts;
    fill(others, ...instead.map(({ text: own }, i) => button(own, `${prefix}other-${String(i + 1)}`, () => instead[i]?.act())));
    others.hidden = instead.length === 0;
  };
}
