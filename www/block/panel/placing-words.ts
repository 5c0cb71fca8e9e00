/** What is said of images on an orthophoto. */
import { sentence } from '../../shared/text/format';
import type { PlacedFile } from '../state/placed';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

/** What the place of an image is worth, in a sentence. */
export function verdictText({ result, problem }: Pick<PlacedFile, 'result' | 'problem'>): string {
  return result === null ? say('not-read', { problem: sentence(problem) }) : message('placing_verdict', result.verdict);
}
