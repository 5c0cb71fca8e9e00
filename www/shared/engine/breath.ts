/** Lets the browser answer what the user did, and draw, between two pieces of work that are long together. */
export const breath = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** So long a page may have something else to do, before what nobody waits for is done all the same, in ms. */
const PATIENCE_MS = 1000;

/** What waits for a quiet page. */
const waiting = new Set<() => void>();

/** Does something once the page has nothing else to do, or when somebody looks for it. */
export function whenQuiet(work: () => void): void {
  const once = () => {
    if (waiting.delete(once)) work();
  };
  waiting.add(once);
  // Safari does not say when.
  if ('requestIdleCallback' in window) window.requestIdleCallback(once, { timeout: PATIENCE_MS });
  else setTimeout(once);
}

/** Does at once what waits for a quiet page. */
export function hasten(): void {
  for (const work of [...waiting]) work();
}

/** Gives a function that calls back once the next frame is on the screen, once for all calls until then. */
export function afterFrame(callback: () => void): () => void {
  let waits = false;
  return () => {
    if (waits) return;
    waits = true;
    requestAnimationFrame(() =>
      setTimeout(() => {
        waits = false;
        callback();
      }),
    );
  };
}
