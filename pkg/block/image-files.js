// @ts-check

/** Names of files that are taken for images; native programs take the same (`ENDINGS` in `src/pipeline/host.rs`). */
export const IMAGE_FILE = /\.(?:jpe?g|png|tiff?|bmp|webp|pgm|ppm|pnm)$/iu;
