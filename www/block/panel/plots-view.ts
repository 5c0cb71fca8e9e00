/** The plots of a block on the stage: which one, what it says in words, its picture and its values as files. */
import { saveCsv } from '../../shared/files/csv';
import { save } from '../../shared/files/save';
import { choice } from '../../shared/panel/choice';
import { button, h } from '../../shared/panel/dom';
import type { Column } from '../../shared/state/rows';
import type { Facts } from '../engine/facts';
import { PLOTS } from '../state/plots';
import type { Axis, PlotName } from '../state/plots';
import { plotText } from '../state/plot-words';
import { Plot } from '../view/plot/plot';
import { KEYS_ID } from './view';
import type { StageView } from './view';
import { say } from '../../shared/text/words';
import { declareLack } from '../../shared/panel/lack';

const KEYS = say('press-a-value-to-choose');

export function plotsView(facts: Facts): StageView {
  return {
    name: 'plots',
    title: say('plots'),
    mount: (store, looking) => {
      const words = h('span', { class: 'note', id: 'block-plot-words', testid: 'block-plot-words', role: 'status', aria: { live: 'polite' } });
      const element = h('div', {
        class: 'view block-plot',
        testid: 'block-plot',
        tabindex: 0,
        role: 'group',
        aria: { roledescription: say('role-plot'), label: say('plot-of-the-block'), describedby: `${words.id} ${KEYS_ID}` },
      });
      const plot = new Plot(element, store, looking, facts);
      const [chosen, select] = choice(say('plot'), 'plot-name', PLOTS, (name) => plot.show(name as PlotName));
      select.value = plot.shows;
      const saved = (name: string) => {
        // What goes on says itself when it ends.
        if (store.state.notice?.kind !== 'busy') store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('was-saved', { name }), beside: true } });
      };
      const picture = button('PNG', 'plot-png', () => void savePicture(plot, saved), say('saves-the-plot-as-it'));
      const values = button('CSV', 'plot-csv', () => saveValues(plot, saved), say('saves-the-values-of-the'));
      declareLack([picture, values], () => (picture.disabled ? say('no-plot-is-shown') : ''));
      const show = () => {
        const data = plot.data();
        const text = data === null ? '' : plotText(data, (store.state.shown?.view.oriented ?? 0) > 0);
        if (words.textContent !== text) words.textContent = text;
        picture.disabled = values.disabled = data === null || data.x.values.length === 0;
      };
      plot.watch(show);
      show();
      return { element, tools: [chosen, picture, values], legend: words, zoomable: plot, keys: KEYS };
    },
  };
}

/** `saved`: says which file was saved. */
async function savePicture(plot: Plot, saved: (name: string) => void): Promise<void> {
  const picture = plot.picture();
  const blob = await new Promise<Blob | null>((resolve) => {
    picture.toBlob(resolve);
  });
  if (blob === null) return;
  const name = `block-${plot.shows}.png`;
  save(blob, name);
  saved(name);
}

function saveValues(plot: Plot, saved: (name: string) => void): void {
  const data = plot.data();
  if (data === null) return;
  const column = ({ label, unit, values, names }: Axis): Column => ({
    key: label,
    label,
    unit,
    help: '',
    value: (row) => values[row] ?? NaN,
    text: (row) => names?.[Math.round(values[row] ?? NaN)] ?? String(values[row] ?? ''),
    ...(names === undefined ? {} : { words: true }),
  });
  const name = `block-${plot.shows}.csv`;
  saveCsv([...(data.about ?? []), column(data.x), column(data.y), ...(data.more ?? [])], data.x.values.keys(), name);
  saved(name);
}
