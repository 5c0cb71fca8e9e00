/** How far a run is: a line for each stage, and for the one that runs a bar with the time that is left. */
import type { StageName, Step } from '../../../pkg/block/index.js';
import { fill, h, section } from '../../shared/panel/dom';
import { count } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { Steps } from '../state/state';

const STAGES: Readonly<Record<StageName, string>> = {
  photos: 'Photos',
  images: 'Images: features',
  likeness: 'Similarity of images',
  pairs: 'Pairs: matches',
  points: 'Tie points',
  windows: 'Windows of observations',
  refinement: 'Refinement',
  orientation: 'Orientation',
};

/** Stages whose steps are parts of one computation, none that the user counts. */
const OF_ONE_PIECE: ReadonlySet<StageName> = new Set(['points', 'orientation']);

/** Stages in their order. */
const NAMES = Object.keys(STAGES) as StageName[];

export function mountProgress(host: HTMLElement, store: BlockStore): void {
  const body = h('div', { class: 'stages' });
  const whole = section('Run', 'block-progress', body);
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
    OF_ONE_PIECE.has(stage) ? '' : `${count(done)} of ${count(total)}${found > 0 ? `, ${count(found)} from an earlier run` : ''}`,
    `${duration(seconds)}${secondsLeft === undefined || !goesOn ? '' : `, about ${duration(secondsLeft)} left`}`,
    goesOn ? (name ?? '') : '',
  ];
  return parts.filter((part) => part !== '').join('; ');
}

/** What the status line says of the stage that runs. */
export function runText(steps: Steps): string {
  const name = NAMES.findLast((stage) => steps[stage] !== undefined);
  const step = name === undefined ? undefined : steps[name];
  return name === undefined || step === undefined ? 'Starting …' : `${STAGES[name]}: ${stepText(name, step)}`;
}

export function duration(seconds: number): string {
  if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
  if (seconds < 90) return `${String(Math.round(seconds))} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? `${String(minutes)} min` : `${(seconds / 3600).toFixed(1)} h`;
}
