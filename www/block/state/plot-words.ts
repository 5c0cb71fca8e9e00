/** What the values of a plot are like, in words. */
import { count, fixed } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import type { PlotData } from './plots';
import { unitText } from '../../shared/text/units';

/** A label as a sentence goes on with it: "image", but "X EPSG:25832". */
function withinSentence(label: string): string {
  return label.replace(/^\p{Lu}(?=\p{Ll})/u, (first) => first.toLowerCase());
}

/** `isOriented`: of a block that has been; it has whatever it will have. */
export function plotText({ x, y }: PlotData, isOriented = false): string {
  const sorted = y.values.filter(Number.isFinite).sort();
  const unchecked = y.values.length - sorted.length;
  const more = unchecked === 0 ? '' : say('unchecked-at-the-top', { unchecked });
  if (sorted.length === 0) return unchecked === 0 ? say(isOriented ? 'this-block-has-none' : 'there-are-no-such-values') : more;
  // What is counted has no decimals.
  const areCounts = y.unit === '' && sorted.every(Number.isInteger);
  const written = (value: number) => (areCounts ? count(value) : fixed(value, 3));
  const at = (share: number) => written(sorted[Math.round(share * (sorted.length - 1))] ?? NaN);
  const text = say('values-over-median-from-to', {
    sorted: sorted.length,
    to_lower_case: withinSentence(x.label),
    label: y.label,
    at: at(0.5),
    at_2: at(0),
    at_3: at(1),
    what: y.unit === '' ? '' : say('n--2', { unit: unitText(y.unit) }),
  });
  return more === '' ? text : `${text} ${more}`;
}
