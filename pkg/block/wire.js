// @ts-check
/** Errors between workers: a copy of an `Error` that passes between threads loses its name and its fields. */

/** @typedef {import('./wire.js').PlainError} PlainError */

/** @type {typeof import('./wire.js').plainError} */
export function plainError(thrown) {
  if (typeof thrown !== 'object' || thrown === null || !('message' in thrown)) return { name: 'Error', message: String(thrown) };
  const { name, message, code, usage, error } = /** @type {Record<string, unknown>} */ (thrown);
  return {
    name: typeof name === 'string' ? name : 'Error',
    message: String(message),
    ...(typeof code === 'string' && { code }),
    ...(typeof usage === 'boolean' && { usage }),
    ...(typeof error === 'object' && error !== null && { error: /** @type {{ kind: string }} */ (error) }),
  };
}

/** @type {typeof import('./wire.js').errorOf} */
export const errorOf = ({ message, ...fields }) => Object.assign(new Error(message), fields);
