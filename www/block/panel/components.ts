/** What the residuals say of stated standard errors. */
import { h, row } from '../../shared/panel/dom';
import { fixed } from '../../shared/text/format';
import { message } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { VarianceComponent } from '../../../pkg/wasm/tiepoint.js';

/** A row for each group of observations, and what the figures mean. */
export function componentTable(components: readonly VarianceComponent[]): HTMLElement[] {
  const names = [say('observations'), say('by-residuals-stated'), say('interval-of-95'), say('weights-by')];
  const head = h('thead', {}, h('tr', {}, ...names.map((text) => h('th', { scope: 'col' }, text))));
  const number = (text: string) => h('td', { class: 'number' }, text);
  const rows = components.map((one) =>
    row(
      message('observation_group', { kind: one.group }),
      number(one.held ? '–' : fixed(one.factor, 2)),
      number(one.interval == null ? '–' : one.interval.map((limit) => fixed(limit, 2)).join(' – ')),
      weightsOf(one),
    ),
  );
  return [
    h('div', { class: 'scroll' }, h('table', { class: 'tight', testid: 'components' }, head, h('tbody', {}, ...rows))),
    h('p', { class: 'note' }, say('components-explained')),
  ];
}

function weightsOf({ applied, held }: VarianceComponent): string {
  if (applied) return say('weights-by-residuals');
  return held ? say('weights-by-stated-held') : say('weights-by-stated');
}
