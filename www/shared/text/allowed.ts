/** What the crate allows in place of a number, in the language of the page. */
import { LANGUAGE } from './language';
import { message, messageOf } from './messages';
import { say } from './words';

type Write = (from: string, to: string) => string;

/** As the crate writes ranges. */
const FORMS: readonly (readonly [RegExp, Write])[] = [
  [/^(\S+) to (\S+)$/u, (from, to) => say('allowed-between', { from, to })],
  [/^whole numbers from (\S+) to (\S+)$/u, (from, to) => say('allowed-whole', { from, to })],
  [/^odd whole numbers from (\S+) to (\S+)$/u, (from, to) => say('allowed-odd', { from, to })],
  [/^two numbers from (\S+) to (\S+)$/u, (from, to) => say('allowed-two', { from, to })],
  [/^two numbers of px from (\S+) to (\S+)$/u, (from, to) => say('allowed-two-px', { from, to })],
  [/^above (\S+), up to (\S+)$/u, (from, to) => say('allowed-above-up-to', { from, to })],
  [/^above (\S+)$/u, (from) => say('allowed-above', { from })],
];

/** What is written otherwise stays as it is. */
export function allowedText(allowed: string): string {
  if (LANGUAGE === 'en') return allowed;
  for (const [form, write] of FORMS) {
    const [found, from = '', to = ''] = form.exec(allowed) ?? [];
    if (found !== undefined) return write(from, to);
  }
  return allowed;
}

/** Why the crate refused what was typed or given. */
export function refusalText(thrown: unknown): string {
  const error = thrown instanceof Error && 'error' in thrown ? thrown.error : null;
  return ownWords(error) ?? messageOf(thrown);
}

/** The text of a refusal whose range the page writes; null where it is another, or English, as the crate writes it. */
export function ownWords(error: unknown): string | null {
  if (LANGUAGE === 'en' || typeof error !== 'object' || error === null || !('allowed' in error) || !('kind' in error)) return null;
  const { kind, allowed } = error;
  if (typeof kind !== 'string' || typeof allowed !== 'string') return null;
  return message('error', { ...error, kind, allowed: allowedText(allowed) } as Parameters<typeof message>[1]);
}
