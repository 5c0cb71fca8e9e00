/** What the crate says of blocks, read on the main thread once its module is there. */
import {
  block_flight_parameters,
  block_flight_preset,
  block_parameters,
  block_settings,
  call_parameters,
  placing_defaults,
  placing_parameters,
} from '../../../pkg/wasm/tiepoint.js';
import type { Catalogue } from '../../shared/crate';
import { optionInLanguage } from '../../shared/text/options';
import type { BlockCatalogue } from '../state/state';

/** The page offers one parameter of the features, and those of the block; the strategy of the pair explains the others. */
const offered = (key: string) => key === 'multiscale.number' || !/^(?:multiscale|gradient|nearest|geometry)\./u.test(key);

export function blockCatalogue({ parameters, flightParameters }: Catalogue): BlockCatalogue {
  const own = block_parameters().map(optionInLanguage);
  const ofFlight = block_flight_parameters().map(optionInLanguage);
  const ofPlacing = placing_parameters().map(optionInLanguage);
  return {
    parameters: own.filter(({ key }) => offered(key)),
    defaults: block_settings({}),
    flightParameters: ofFlight,
    flight: block_flight_preset('small_photos'),
    placingParameters: ofPlacing,
    placing: placing_defaults(),
    levelParameter: call_parameters().find(({ key }) => key === 'heights'),
    labels: { parameters: [...parameters, ...own, ...ofPlacing], flightParameters: [...flightParameters, ...ofFlight] },
  };
}
