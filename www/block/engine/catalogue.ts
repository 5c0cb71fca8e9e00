/** What the crate says of blocks, read on the main thread once its module is there. */
import { block_flight_defaults, block_flight_parameters, block_parameters, block_settings } from '../../../pkg/wasm/tiepoint.js';
import type { Catalogue } from '../../shared/crate';
import { SMALL_PHOTOS } from '../panel/flight';
import type { BlockCatalogue } from '../state/state';

/** The page offers this one of the features' parameters; the strategy of the pair explains the others. */
const FEATURES = 'multiscale.number';

export function blockCatalogue({ parameters }: Catalogue): BlockCatalogue {
  return {
    parameters: [...block_parameters(), ...parameters.filter(({ key }) => key === FEATURES)],
    defaults: block_settings({}),
    flightParameters: block_flight_parameters(),
    flight: { ...block_flight_defaults(), ...SMALL_PHOTOS },
  };
}
