/** The simulated block: a control for each parameter of its flight that photos depend on. */
import { makeControl } from '../../shared/panel/control';
import { button, fill, h } from '../../shared/panel/dom';
import type { BlockFlight } from '../../../pkg/wasm/tiepoint.js';
import type { BlockStore } from '../engine/engine';
import type { BlockFiles } from '../files/files';
import { isBusy } from '../state/state';

/** Parameters of blocks whose features are made without photos. */
const OF_FEATURES: readonly string[] = ['features', 'clutter', 'matched', 'wrong', 'repeated', 'noise_px'];

export function mountFlight(host: HTMLElement, store: BlockStore, files: BlockFiles): void {
  store.watch((s) => [s.catalogue] as const, ([catalogue]) => {
    if (catalogue === null) return;
    const controls = catalogue.flightParameters.flatMap((parameter) => {
      const field = parameter.key.replace('block_flight.', '') as keyof BlockFlight;
      if (OF_FEATURES.includes(field)) return [];
      return [{ field, control: makeControl(parameter, {
        set: (value) => {
          const { flight } = store.state;
          if (flight !== null && value !== null) store.dispatch({ type: 'flight', flight: { ...flight, [field]: value } });
        },
        standard: () => catalogue.flight[field] ?? null,
        whenEmpty: () => null,
      }) }];
    });
    const take = button('Photograph this block', 'block-photograph', () => { void files.simulate(); });
    take.className = 'primary';
    fill(host, h('p', { class: 'note' }, 'A flight in strips over a made town. Larger photos take longer: 12 million pixels some seconds each.'), h('div', { class: 'buttons' }, take),
      h('fieldset', { class: 'group' }, ...controls.map(({ control }) => control.element)));
    store.watch((s) => [s.flight] as const, ([flight]) => {
      if (flight !== null) for (const { field, control } of controls) control.show(flight[field] ?? null);
    });
    store.watch((s) => [s.running, s.notice] as const, () => { take.disabled = isBusy(store.state); });
  });
}
