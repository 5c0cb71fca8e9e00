/** How far a run is: a bar beside Cancel for the stage that runs, and in the results a line for each stage with the time that is left. */
import type { StageName, Step } from '../../../pkg/block/index.js';
import { fill, h, section } from '../../shared/panel/dom';
import type { BlockStore } from '../engine/engine';
import type { Placing } from '../state/placing';
import type { Running, Steps } from '../state/state';
import { say } from '../../shared/text/words';

const STAGES: Readonly<Record<StageName, string>> = {
  photos: say('photos'),
  images: say('images-features'),
  geoid: say('geoid'),
  likeness: say('similarity-of-images'),
  pairs: say('pairs-matches'),
  points: say('tie-points'),
  windows: say('windows-of-observations'),
  refinement: say('refinement'),
  orientation: say('orientation'),
};

/** Stages whose steps are parts of one computation, none that the user counts. */
const OF_ONE_PIECE: ReadonlySet<StageName> = new Set(['geoid', 'points', 'orientation']);

/** Stages in their order. */
const NAMES = Object.keys(STAGES) as StageName[];

export function mountProgress(host: HTMLElement, store: BlockStore): void {
  const body = h('div', { class: 'stages' });
  const whole = section(say('run'), 'block-progress', body);
  host.append(whole);
  store.watch(['running', 'shown'], ([running, shown]) => {
    const steps = running.kind === 'no' ? (shown?.steps ?? {}) : running.steps;
    const begun = NAMES.flatMap((name) => (steps[name] === undefined ? [] : [stage(name, steps[name])]));
    whole.hidden = begun.length === 0;
    fill(body, ...begun);
  });
}

/** The bar beside Cancel: of the stage that runs, or of the images that are placed on an orthophoto; away while neither goes on. */
export function progressBar(store: BlockStore): HTMLElement {
  const bar = h('progress', { testid: 'block-bar' });
  store.watch(['running', 'placing'], ([running, placing]) => {
    const { label, done, total, counts } = runsNow(running, placing) ?? NOTHING;
    // One piece of work says nothing until it is done.
    bar.classList.toggle('is-on', total > 1);
    bar.max = Math.max(1, total);
    bar.value = done;
    bar.setAttribute('aria-label', label);
    if (counts) bar.setAttribute('aria-valuetext', say('of-3', { done, total, what: '' }));
    else bar.removeAttribute('aria-valuetext');
  });
  return bar;
}

/** What goes on, by its pieces; `counts`: they are images or pairs, which the user counts too. */
interface Going {
  label: string;
  done: number;
  total: number;
  counts: boolean;
}

const NOTHING: Going = { label: say('progress-of-the-run'), done: 0, total: 0, counts: false };

function runsNow(running: Running, { running: placed }: Placing): Going | null {
  if (running.kind !== 'yes') return placed === null ? null : { ...placed, label: placed.text, counts: true };
  const [name, step] = present(running.steps) ?? [];
  return name === undefined || step === undefined ? null : { ...step, label: STAGES[name], counts: !OF_ONE_PIECE.has(name) };
}

function stage(name: StageName, step: Step): HTMLElement {
  const line = (...parts: HTMLElement[]) =>
    h('div', { class: 'stage-line', testid: `stage-${name}` }, h('span', {}, STAGES[name]), ...parts, h('span', { class: 'note' }, stepText(name, step)));
  if (step.done === step.total) return line();
  const bar = h('progress', { aria: { label: STAGES[name] } });
  bar.max = Math.max(1, step.total);
  bar.value = step.done;
  return line(bar);
}

/** "7 of 12, 3 from an earlier run; 8 s, about 5 s left; IMG_9428.jpg"; of a stage that is done what there was and how long it took. */
function stepText(stage: StageName, { done, total, found, seconds, secondsLeft, name }: Step): string {
  const goesOn = done < total;
  const parts = [
    OF_ONE_PIECE.has(stage) ? '' : say('of-3', { done, total, what: found > 0 ? say('from-an-earlier-run', { found }) : '' }),
    `${duration(seconds)}${secondsLeft === undefined || !goesOn ? '' : say('about-left', { seconds_left: duration(secondsLeft) })}`,
    goesOn ? (name ?? '') : '',
  ];
  return parts.filter((part) => part !== '').join('; ');
}

/** The stage that was begun last; null before the first one. */
function present(steps: Steps): [StageName, Step] | null {
  const name = NAMES.findLast((stage) => steps[stage] !== undefined);
  const step = name === undefined ? undefined : steps[name];
  return name === undefined || step === undefined ? null : [name, step];
}

/** What the status line says of the stage that runs. */
export function runText(steps: Steps): string {
  const [name, step] = present(steps) ?? [];
  return name === undefined || step === undefined ? say('starting') : `${STAGES[name]}: ${stepText(name, step)}`;
}

export function duration(seconds: number): string {
  if (seconds < 9.95) return say('seconds', { value: seconds.toFixed(1) });
  if (seconds < 90) return say('seconds', { value: String(Math.round(seconds)) });
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? say('min', { minutes }) : say('hours', { value: (seconds / 3600).toFixed(1) });
}
