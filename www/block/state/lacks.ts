/** What is lacking for what can be done in a block; empty where it is there. */
import { say } from '../../shared/text/words';
import type { BlockState } from './state';

export const lackOfBlock = ({ shown }: BlockState): string => (shown === null ? say('needs-a-block') : '');

export const lackOfImages = ({ files }: BlockState): string => (files.length === 0 ? say('needs-images') : '');

export const lackOfOrthophoto = ({ placing }: BlockState): string => (placing.orthophoto === null ? say('needs-an-orthophoto') : '');
