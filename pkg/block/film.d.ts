/**
 * The side of a pixel in mm of images of film, which is that of images of the same film that were made before, so that all have one camera: another one, by a
 * part of a per cent, would make a second camera.
 * `focal_mm`: principal distance of the camera of the film. `pixel_mm`: the largest pixel of the scans that are added. `given`: cameras of the images that are there.
 */
export function pixelOfFilm(focal_mm: number, pixel_mm: number, given: readonly { focal_px: number; pixel_mm?: number | null }[]): number;
