/** The time in archives: that of their making would give the same files other bytes. */
export const ARCHIVE_TIME = '1980-01-01T00:00:00';
