/** What files of JSON hold, told by their fields. */

/** The field that says what settings of one's own are of. */
export const OWN_SETTINGS = 'tiepoint_settings';

/** The fields of an object; none of any other text. */
export function fieldsOf(text: string): Record<string, unknown> {
  let read: unknown;
  try {
    read = JSON.parse(text);
  } catch {
    read = null;
  }
  return typeof read === 'object' && read !== null ? (read as Record<string, unknown>) : {};
}
