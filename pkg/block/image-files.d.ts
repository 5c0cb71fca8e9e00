/** Names of files that are taken for images. */
export const IMAGE_FILE: RegExp;
