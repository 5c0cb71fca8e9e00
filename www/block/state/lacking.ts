/** What an opened project file names and does not hold, and a run of its block needs. Pure. */
import type { BlockFile, BlockState } from './state';
import { say } from '../../shared/text/words';

/** The type of a file without bytes that stands for one that has to be given again. */
const NOT_HELD = 'application/x-not-held';

export function standIn(name: string): File {
  return new File([], name, { type: NOT_HELD });
}

export function isLacking({ file }: BlockFile): boolean {
  return file.type === NOT_HELD;
}

/** What is said of a block before it is run anew; empty where nothing is lacking. */
export function lackingText({ shown, options, placing }: Pick<BlockState, 'shown' | 'options' | 'placing'>): string {
  const { masks, geoid } = options;
  const files = [...masks, ...(geoid === null ? [] : [geoid])].filter(isLacking);
  const lies = shown !== null && shown.ground === null && shown.view.orthophoto?.kind === 'linked' && placing.orthophoto === null;
  return [files.length === 0 ? '' : say('a-run-needs-files', { files: files.length }), lies ? say('a-run-needs-its-orthophoto') : '']
    .filter((part) => part !== '')
    .join(' ');
}
