/** The one worker script of the page: any worker can do the work of a pair and of a block. */
import { BLOCK_HANDLERS } from './block/engine/handlers';
import type { BlockCalls } from './block/engine/calls';
import { PAIR_HANDLERS } from './pair/engine/handlers';
import type { PairCalls } from './pair/engine/calls';
import { serve } from './shared/engine/serve';

serve<BlockCalls & PairCalls>({ ...PAIR_HANDLERS, ...BLOCK_HANDLERS });
