/** All settings of a block as one object: those of its method, and whether recorded positions are used, which a run is given beside them. */
import type { BlockSettings, Parameter } from '../../../pkg/wasm/tiepoint.js';
import type { BlockOptions } from './state';
import { say } from '../../shared/text/words';

/** Controls and files of settings read it by the keys of parameters. */
export type OwnSettings = BlockSettings & { recorded: { gnss: boolean } };

export const USE_GNSS: Parameter = {
  key: 'recorded.gnss',
  path: 'recorded.gnss',
  section: say('method'),
  label: say('use-gnss-positions'),
  unit: '',
  help: say('they-choose-near-pairs-and'),
  absent: '',
  acts: '',
  named: '',
  kind: 'flag',
};

export function ownSettings(settings: BlockSettings, gps: BlockOptions['gps']): OwnSettings {
  return { ...settings, recorded: { gnss: gps === 'use' } };
}

export function optionsOfOwn({ recorded, ...settings }: OwnSettings): Pick<BlockOptions, 'settings' | 'gps'> {
  return { settings, gps: recorded.gnss ? 'use' : 'ignore' };
}
