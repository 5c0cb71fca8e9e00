/** Choices of the page's looks that last from one visit to the next. */

/** Storage may be switched off, or absent on file://: a choice then lasts as long as the page. */
export function keptChoice(name: string): string | null {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

export function keepChoice(name: string, value: string): void {
  try {
    localStorage.setItem(name, value);
  } catch {
    // See `keptChoice`.
  }
}
