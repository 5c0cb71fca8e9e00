/** What given files are: images, fiducial marks, camera data. Judged by name and media type alone; decoding decides in the end. */

export interface SortedFiles {
  images: File[];
  tables: File[];
  cameras: File[];
}

export function sortFiles(files: readonly File[]): SortedFiles {
  const isTable = (file: File) => /\.(csv|txt)$/iu.test(file.name) || file.type === 'text/csv';
  const isCamera = (file: File) => /\.json$/iu.test(file.name) || file.type === 'application/json';
  return {
    tables: files.filter(isTable),
    cameras: files.filter(isCamera),
    // Two images given at once come in the order of their names, numbers counted as numbers: IMG_9 before IMG_10.
    images: files.filter((file) => !isTable(file) && !isCamera(file)).sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true })),
  };
}
