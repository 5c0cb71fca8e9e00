/** Words as they are looked for: without what may be left out in writing. */

/** Letters of Arabic that many write as another one. */
const ALIKE: Readonly<Record<string, string>> = { ى: 'ي', ة: 'ه' };

/** In small letters, without marks above and below letters, which hamza and madda on alif are too, and without tatweel. */
export function folded(text: string): string {
  return text
    .normalize('NFD')
    .replaceAll(/[\p{M}\u0640]/gu, '')
    .replaceAll(/[ىة]/gu, (letter) => ALIKE[letter] ?? letter)
    .toLowerCase();
}
