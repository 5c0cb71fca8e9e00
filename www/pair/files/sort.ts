/** What given files are: images, masks, fiducial marks, camera data, projects. Judged by name and media type alone; decoding decides in the end. */

export interface SortedFiles {
  images: File[];
  /** Images whose names say so. */
  masks: File[];
  tables: File[];
  cameras: File[];
  /** Projects that were saved. */
  projects: File[];
}

export function sortFiles(files: readonly File[]): SortedFiles {
  const isTable = (file: File) => /\.(csv|txt)$/iu.test(file.name) || file.type === 'text/csv';
  const isCamera = (file: File) => /\.json$/iu.test(file.name) || file.type === 'application/json';
  const isProject = (file: File) => /\.tiepoint$/iu.test(file.name);
  const isMask = (file: File) => !isTable(file) && !isCamera(file) && !isProject(file) && /(^|[^a-z])masks?([^a-z]|$)/iu.test(file.name);
  return {
    masks: files.filter(isMask),
    tables: files.filter(isTable),
    cameras: files.filter(isCamera),
    projects: files.filter(isProject),
    // Two images given at once come in the order of their names, numbers counted as numbers: IMG_9 before IMG_10.
    images: files
      .filter((file) => !isTable(file) && !isCamera(file) && !isMask(file) && !isProject(file))
      .sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true })),
  };
}
