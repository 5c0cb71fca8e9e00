/** Files that the page gives. */

/** Gives the name, by which it is said. */
export function save(blob: Blob, name: string): string {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has taken the address by then.
  window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  return name;
}
