/** Histograms: the measure of the matches, what the adjustment left, the interest value. */
import { interiorInUse } from '../state/interior';
import { isStale } from '../state/keys';
import { measuresOf } from '../state/predicted';
import { parallaxResiduals } from '../state/residuals';
import { columnOf, histogram } from '../state/histogram';
import type { Histogram } from '../state/histogram';
import { shownPair } from '../state/select';
import { remember } from '../../shared/state/remember';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, markStale, section, svg } from '../../shared/panel/dom';
import { count, significant } from '../../shared/text/format';
import { whenInSight } from '../../shared/panel/sight';
import { say } from '../../shared/text/words';
import { unitText } from '../../shared/text/units';

const BINS = 40;
const WIDTH = 320;
const HEIGHT = 84;

const measures = remember((compared: Float64Array) => histogram(compared, BINS, { from: 0 }));
const residuals = remember((values: Float64Array) => histogram(values, BINS, { symmetric: true }));
const interestLeft = remember((points: Float64Array) => histogram(columnOf(points, 3, 2), BINS));
const interestRight = remember((points: Float64Array) => histogram(columnOf(points, 3, 2), BINS));

export function mountHistograms(host: HTMLElement, store: Store): void {
  const body = h('div', { class: 'histograms' });
  const panel = section(say('histograms'), 'histograms-section', body);
  host.append(panel);
  let round = 0;
  store.watch(
    ['results', 'history', 'images', 'settings', 'camera', 'photos', 'offset', 'fiducialModel', 'failures'],
    whenInSight(host, () => {
      panel.classList.toggle('is-stale', isStale(store.state, 'match'));
      round += 1;
      void update(body, store, () => round, round);
    }),
  );
}

/** Draws the charts one after the other, each in its own task: with many points each takes some ms, and input comes between. */
async function update(body: HTMLElement, store: Store, round: () => number, own: number): Promise<void> {
  const charts: HTMLElement[] = [];
  for (const make of CHARTS) {
    await new Promise((resolve) => window.setTimeout(resolve, 0));
    if (round() !== own) return;
    const made = make(store.state);
    if (made !== null) charts.push(made);
  }
  fill(body, ...(charts.length > 0 ? charts : [h('p', { class: 'note' }, say('no-points-yet'))]));
}

const CHARTS: readonly ((state: State) => HTMLElement | null)[] = [
  (state) => {
    const { match } = shownPair(state);
    return match === null || match.counts.matches === 0 ? null : chart(say('measure-of-the-matches'), '', measures(measuresOf(match)), 'histogram-measure');
  },
  (state) => {
    const { orientation } = shownPair(state);
    const interior = interiorInUse(state)?.left;
    if (orientation === null || interior === undefined) return null;
    const figure = chart(say('y-parallax-residuals-of-the'), 'px', residuals(parallaxResiduals(orientation, interior)), 'histogram-residuals');
    return markStale(figure, isStale(state, 'orientation') && !isStale(state, 'match'));
  },
  (state) => {
    const { left } = shownPair(state);
    return left === null || left.length === 0 ? null : chart(say('interest-value-left'), '', interestLeft(left), 'histogram-interest-left');
  },
  (state) => {
    const { right } = shownPair(state);
    return right === null || right.length === 0 ? null : chart(say('interest-value-right'), '', interestRight(right), 'histogram-interest-right');
  },
];

function chart(title: string, unit: string, data: Histogram, testid: string): HTMLElement {
  const most = Math.max(...data.counts, 1);
  const width = WIDTH / data.counts.length;
  const bars = data.counts
    .map((n, i) => {
      const bar = Math.round(((HEIGHT * n) / most) * 100) / 100;
      return n === 0 ? '' : `M${String(i * width + 0.5)} ${String(HEIGHT)}v-${String(bar)}h${String(width - 1)}v${String(bar)}z`;
    })
    .join('');
  const at = (value: number) => (WIDTH * (value - data.low)) / (data.high - data.low);
  const suffix = unit === '' ? '' : ` ${unitText(unit)}`;
  const words = say('values-median-shown-from-to', {
    title,
    total: data.total,
    median: significant(data.median),
    suffix,
    low: significant(data.low),
    high: significant(data.high),
    most,
  });
  const picture = svg(
    'svg',
    { viewBox: `0 0 ${String(WIDTH)} ${String(HEIGHT + 1)}`, class: 'histogram', role: 'img', 'aria-label': words, preserveAspectRatio: 'none' },
    svg('path', { d: bars, class: 'bars' }),
    svg('path', { d: `M0 ${String(HEIGHT + 0.5)}h${String(WIDTH)}`, class: 'axis' }),
    svg('path', { d: `M${String(at(data.median))} 0v${String(HEIGHT)}`, class: 'median' }),
  );
  return h(
    'figure',
    { testid },
    h('figcaption', {}, title, h('span', { class: 'unit' }, `${suffix} · n = ${count(data.total)}`)),
    picture,
    h(
      'div',
      { class: 'scale' },
      h('span', {}, significant(data.low)),
      h('span', {}, say('median', { median: significant(data.median) })),
      h('span', {}, significant(data.high)),
    ),
  );
}
