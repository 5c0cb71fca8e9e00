/** What files of JSON hold, told by their fields. */

/** The field that says what settings of one's own are of. */
export const OWN_SETTINGS = 'tiepoint_settings';

/** Whether a text is an object with this field. */
export function hasField(text: string, field: string): boolean {
  try {
    const read: unknown = JSON.parse(text);
    return typeof read === 'object' && read !== null && field in read;
  } catch {
    return false;
  }
}
