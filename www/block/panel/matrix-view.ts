/** The matrix of matches on the stage. */
import { fill, h } from '../../shared/panel/dom';
import { mostMatches } from '../state/words';
import { Matrix } from '../view/matrix';
import { KEYS_ID } from './view';
import type { StageView } from './view';
import { say } from '../../shared/text/words';

export const MATRIX_VIEW: StageView = {
  name: 'matrix',
  title: say('matrix'),
  mount: (store, looking) => {
    const element = h('div', {
      class: 'view block-matrix',
      testid: 'block-matrix',
      tabindex: 0,
      role: 'group',
      aria: { roledescription: say('matrix-of-matches'), label: say('images-by-images-arrow-keys'), describedby: KEYS_ID },
    });
    const cells = h('span', { class: 'note', testid: 'block-cells' });
    store.watch(['shown'], ([shown]) => fill(cells, shown === null ? '' : say('strongest-cell-matches-small-square', { view: mostMatches(shown.view) })));
    return {
      element,
      tools: [],
      legend: cells,
      zoomable: new Matrix(element, store, looking),
      keys: say('press-a-cell-to-choose'),
    };
  },
};
