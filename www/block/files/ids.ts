/** Numbers of files: no two that were ever given have the same. */

let nextId = 1;

export function newId(): number {
  return nextId++;
}

/** Later files have other numbers than these. */
export function passIds(taken: readonly number[]): void {
  for (const id of taken) nextId = Math.max(nextId, id + 1);
}
