/** What is said of images on an orthophoto. */
import { sentence } from '../../shared/text/format';
import type { PlacedFile } from '../state/placed';
import type { BlockState } from '../state/state';
import { readable } from '../../shared/text/names';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

/** What the place of an image is worth, and how it was sought by its GNSS position, with the names of the page's settings. */
export function verdictText({ result, problem }: Pick<PlacedFile, 'result' | 'problem'>, { catalogue }: Pick<BlockState, 'catalogue'>): string {
  if (result === null) return say('not-read', { problem: sentence(problem) });
  const verdict = message('placing_verdict', result.verdict);
  return readable(catalogue?.labels ?? null, result.search === undefined ? verdict : `${verdict} ${message('place_search', result.search)}`);
}
