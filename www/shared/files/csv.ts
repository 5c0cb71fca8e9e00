/** Rows of a table or of a plot, saved as they are shown: with the heads and words of the page's language. */
import { csvOf } from '../state/rows';
import type { Column } from '../state/rows';
import { LANGUAGE } from '../text/language';
import { save } from './save';

/** Spreadsheets take a file that does not begin with this mark for one in letters of the system, which spoils Arabic ones. English files go without it, as those of the command. */
const MARK = LANGUAGE === 'en' ? '' : '\ufeff';

export function saveCsv(columns: readonly Column[], rows: Iterable<number>, name: string): void {
  save(new Blob([MARK, csvOf(columns, rows)], { type: 'text/csv' }), name);
}
