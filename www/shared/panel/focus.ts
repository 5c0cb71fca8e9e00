/** The keyboard stays with what was pressed: where that can no longer be, what takes its place gets it. */

/** Whether an element can have the keyboard. */
function canHold(element: HTMLElement): boolean {
  return element.isConnected && element.closest('[hidden], :disabled') === null;
}

/** Gives the keyboard from a part of a host that was hidden, disabled or replaced to the first of others that can have it. `held`: what had it. */
export function passFocus(held: Element | null, others: readonly (HTMLElement | null | undefined)[]): void {
  if (!(held instanceof HTMLElement) || canHold(held)) return;
  // Somebody else has it already.
  const { activeElement } = document;
  if (activeElement !== held && activeElement !== null && activeElement !== document.body) return;
  others.find((other) => other != null && canHold(other))?.focus({ preventScroll: true });
}
