/** What the crate says of blocks, read on the main thread once its module is there. */
import { block_flight_defaults, block_flight_parameters, block_parameters, block_settings } from '../../../pkg/wasm/tiepoint.js';
import type { BlockFlight } from '../../../pkg/wasm/tiepoint.js';
import type { Catalogue } from '../../shared/crate';
import type { BlockCatalogue } from '../state/state';

/** The page offers one parameter of the features, and those of the block; the strategy of the pair explains the others. */
const offered = (key: string) => key === 'multiscale.number' || !/^(?:multiscale|gradient|nearest|geometry)\./u.test(key);

/** Photos small enough to be rendered in a second or two, by a wide angle: bases are then long against heights. */
const SMALL_PHOTOS: Partial<BlockFlight> = { width_px: 800, height_px: 600, pixel_mm: 0.09, relief_m: 40 };

export function blockCatalogue({ parameters, flightParameters }: Catalogue): BlockCatalogue {
  const own = block_parameters();
  const ofFlight = block_flight_parameters();
  return {
    parameters: own.filter(({ key }) => offered(key)),
    defaults: block_settings({}),
    flightParameters: ofFlight,
    flight: { ...block_flight_defaults(), ...SMALL_PHOTOS },
    labels: { parameters: [...parameters, ...own], flightParameters: [...flightParameters, ...ofFlight] },
  };
}
