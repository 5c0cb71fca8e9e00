/** Files of settings of one's own, told by what they hold. */

/** The field that says what the settings are of. */
export const OWN_SETTINGS = 'tiepoint_settings';

/** Whether a text says that it holds settings, of whatever. */
export function isOwnSettings(text: string): boolean {
  try {
    const read: unknown = JSON.parse(text);
    return typeof read === 'object' && read !== null && OWN_SETTINGS in read;
  } catch {
    return false;
  }
}
