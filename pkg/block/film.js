// @ts-check
/** What scans of film that are added to others take over from these. */

/** Pixels of scans of one film differ by less, by the paper's and the scanner's scale; those of another resolution by more. */
const SAME_FILM = 0.01;
/** So near, as a share, principal distances are one. */
const ROUNDING = 1e-9;

/** @type {typeof import('./film.js').pixelOfFilm} */
export function pixelOfFilm(focal_mm, pixel_mm, given) {
  const share = (/** @type {number} */ own, /** @type {number} */ wanted) => Math.abs(own / wanted - 1);
  const pixels = given.flatMap(({ focal_px, pixel_mm: own }) =>
    typeof own === 'number' && share(focal_px * own, focal_mm) <= ROUNDING && share(own, pixel_mm) <= SAME_FILM ? [own] : [],
  );
  return pixels.sort((a, b) => share(a, pixel_mm) - share(b, pixel_mm))[0] ?? pixel_mm;
}
