/** What the marks on the images mean: those that are drawn now, each with its picture. */
import { fill, h } from '../../shared/panel/dom';
import { lineSwatch, swatch } from '../../shared/panel/swatch';
import { say } from '../../shared/text/words';
import { ACCEPTED, CANDIDATE, EPIPOLAR, MEASURED, REJECTED, REJECTED_BY_HAND, RESIDUAL, RESIDUAL_REJECTED, SELECTED, SHAPES } from '../../shared/view/palette';
import { pointsOf } from '../state/selection';
import type { ImagesView } from '../view/images/images';

interface Entry {
  text: string;
  mark: () => SVGSVGElement;
  isDrawn: (view: ImagesView) => boolean;
}

const RING = 'M13 8a5 5 0 1 0-10 0a5 5 0 1 0 10 0z';
const ARROW = 'M2 8H14M10.5 5L14 8L10.5 11';
/** Its middle is free, as that of the mark over the picture. */
const CROSS = 'M8 1.5v4M8 10.5v4M1.5 8h4M10.5 8h4';

const look = ({ seen }: ImagesView) => seen.store.state.panes.look;
const hasPoints = (view: ImagesView) => look(view).points;
const hasResiduals = (view: ImagesView) => look(view).vectors > 0;
const hasChosen = ({ seen }: ImagesView) => pointsOf(seen.store.state.selection.chosen).length > 0;
const isMeasuring = ({ measuring }: ImagesView) => measuring.draft !== null;

const ENTRIES: readonly Entry[] = [
  { text: say('accepted'), mark: () => swatch(ACCEPTED), isDrawn: hasPoints },
  { text: say('legend-measured-by-hand'), mark: () => swatch(MEASURED), isDrawn: hasPoints },
  { text: say('rejected-2'), mark: () => swatch(REJECTED), isDrawn: hasPoints },
  { text: say('rejected-by-hand-2'), mark: () => swatch(REJECTED_BY_HAND), isDrawn: hasPoints },
  { text: say('legend-residual'), mark: () => lineSwatch(ARROW, RESIDUAL), isDrawn: hasResiduals },
  { text: say('legend-residual-rejected'), mark: () => lineSwatch(ARROW, RESIDUAL_REJECTED), isDrawn: hasResiduals },
  { text: say('legend-chosen'), mark: () => lineSwatch(RING, SELECTED), isDrawn: hasChosen },
  { text: say('legend-predicted'), mark: () => swatch({ colour: CANDIDATE, shape: SHAPES.cross }), isDrawn: hasChosen },
  { text: say('legend-placed'), mark: () => lineSwatch(CROSS, SELECTED), isDrawn: isMeasuring },
  {
    text: say('predicted-not-measured'),
    mark: () => lineSwatch(RING, CANDIDATE, '3 2'),
    isDrawn: (view) => isMeasuring(view) || (hasChosen(view) && look(view).unmeasured),
  },
  {
    text: say('legend-epipolar'),
    mark: () => lineSwatch('M1 12L15 4', EPIPOLAR, '4 2.5'),
    isDrawn: (view) => isMeasuring(view) || hasChosen(view) || look(view).loupe,
  },
];

export function imageLegend(testid: string, view: ImagesView): HTMLElement {
  const legend = h('div', { class: 'note image-legend', testid, role: 'group', aria: { label: say('legend-of-marks') } });
  let shown = '';
  view.watch(() => {
    const now = ENTRIES.filter(({ isDrawn }) => isDrawn(view));
    const texts = now.map(({ text }) => text).join('|');
    if (texts === shown) return;
    shown = texts;
    fill(legend, ...now.map(({ text, mark }) => h('span', { class: 'legend' }, mark(), text)));
  });
  return legend;
}
