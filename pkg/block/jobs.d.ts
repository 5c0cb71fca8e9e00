import type { Jobs } from './types.js';

/** What a worker does: jobs by name. Its host has initialised the module, takes `{ name, input }` of `Pool.run` and answers with the output. */
export const jobs: { [N in keyof Jobs]: (input: Jobs[N]['input']) => Promise<Jobs[N]['output']> };
