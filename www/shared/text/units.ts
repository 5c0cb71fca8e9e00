/** Units in the language of the page. Exchange files, whose heads are fixed, have their signs. */
import { asFigure, asSentence } from './direction';
import { known } from './words';

/** The unit in letters of the language; its sign where that has none. */
function ofLanguage(unit: string): string | null {
  return known(`unit-${unit.replaceAll(' ', '-').replace('µ', 'u')}`);
}

/** As heads of tables, labels of fields and titles of axes have it. */
export function unitText(unit: string): string {
  return ofLanguage(unit) ?? unit;
}

/** A figure that is written already, with its unit, if it has one. */
export function withUnit(figure: string, unit: string): string {
  if (unit === '') return figure;
  const own = ofLanguage(unit);
  return own === null ? `${figure} ${unit}` : asSentence(`${asFigure(figure)} ${own}`);
}
