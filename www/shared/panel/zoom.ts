/** The buttons that enlarge a picture. */
import { button } from './dom';
import { say } from '../text/words';

const STEP = 1.5;

/** `prefix` of their test ids; `whole` says what Fit shows; `picture` is asked at each press. */
export function zoomButtons(prefix: string, whole: string, picture: () => { fit: () => void; zoomMiddle: (factor: number) => void }): HTMLButtonElement[] {
  return [
    labelled('−', `${prefix}zoom-out`, say('zoom-out'), () => picture().zoomMiddle(1 / STEP)),
    labelled('+', `${prefix}zoom-in`, say('zoom-in'), () => picture().zoomMiddle(STEP)),
    labelled(say('fit'), `${prefix}zoom-fit`, say('fit-0', { whole }), () => picture().fit()),
  ];
}

/** A button whose sign says less than its label. */
export function labelled(text: string, testid: string, label: string, action: () => void): HTMLButtonElement {
  const made = button(text, testid, action, label);
  made.setAttribute('aria-label', label);
  return made;
}
