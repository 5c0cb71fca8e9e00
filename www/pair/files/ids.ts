/** Numbers of images and masks. */
let nextId = 1;

/** Differs for every image and mask ever given. */
export const freshId = (): number => nextId++;
