/** How far a run is: a line for each stage, and for the one that runs a bar with the time that is left. */
import type { StageName, Step } from '../../../pkg/block/index.js';
import { fill, h, section } from '../../shared/panel/dom';
import type { BlockStore } from '../engine/engine';
import type { Steps } from '../state/state';
import { say } from '../../shared/text/words';

const STAGES: Readonly<Record<StageName, string>> = {
  photos: say('photos'),
  images: say('images-features'),
  likeness: say('similarity-of-images'),
  pairs: say('pairs-matches'),
  points: say('tie-points'),
  windows: say('windows-of-observations'),
  refinement: say('refinement'),
  orientation: say('orientation'),
};

/** Stages whose steps are parts of one computation, none that the user counts. */
const OF_ONE_PIECE: ReadonlySet<StageName> = new Set(['points', 'orientation']);

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

/** What the status line says of the stage that runs. */
export function runText(steps: Steps): string {
  const name = NAMES.findLast((stage) => steps[stage] !== undefined);
  const step = name === undefined ? undefined : steps[name];
  return name === undefined || step === undefined ? say('starting') : `${STAGES[name]}: ${stepText(name, step)}`;
}

export function duration(seconds: number): string {
  if (seconds < 9.95) return say('seconds', { value: seconds.toFixed(1) });
  if (seconds < 90) return say('seconds', { value: String(Math.round(seconds)) });
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? say('min', { minutes }) : say('hours', { value: (seconds / 3600).toFixed(1) });
}
