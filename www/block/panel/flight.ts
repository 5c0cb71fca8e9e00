/** The simulated block: a control for each parameter of its flight that photos depend on. */
import { button, fill, h } from '../../shared/panel/dom';
import { makeSections } from '../../shared/panel/sections';
import { withSetting } from '../../shared/panel/settings';
import type { BlockStore } from '../engine/engine';
import type { BlockFiles } from '../files/files';
import { isBusy } from '../state/state';
import { say } from '../../shared/text/words';

export function mountFlight(host: HTMLElement, store: BlockStore, files: BlockFiles): void {
  store.watch(['catalogue'], ([catalogue]) => {
    if (catalogue === null) return;
    const sections = makeSections(catalogue.flightParameters, {
      change: (key, value) => {
        const { flight } = store.state;
        if (flight !== null) store.dispatch({ type: 'flight', flight: withSetting(flight, key, value) });
      },
      defaults: () => catalogue.flight,
    });
    const take = button(say('photograph-this-block'), 'block-photograph', () => void files.simulated.photograph());
    take.className = 'primary';
    fill(host, h('p', { class: 'note' }, say('a-flight-in-strips-over')), h('div', { class: 'buttons' }, take), ...sections.elements);
    store.watch(['flight'], ([flight]) => {
      if (flight !== null) sections.show(flight);
    });
    store.watch(['running', 'notice', 'placing'], () => {
      take.disabled = isBusy(store.state);
    });
  });
}
