/** The calibrated camera that is offered for the images, taken, and left with them. */
import { cameraOfPair, forgetCalibration } from '../../shared/state/calibrations';
import { button, fill, h } from '../../shared/panel/dom';
import { LANGUAGE } from '../../shared/text/language';
import { say } from '../../shared/text/words';
import { isOfOthers, offeredCalibration } from '../state/calibration';
import type { Store } from '../state/store';

const DAY = new Intl.DateTimeFormat(LANGUAGE === 'en' ? 'en-GB' : `${LANGUAGE}-u-nu-latn`, { dateStyle: 'medium' });

/** Takes the calibration that this browser remembers of the images' camera. */
export function useCalibration(store: Store): void {
  const offered = offeredCalibration(store.state);
  if (offered !== null) store.dispatch({ type: 'camera', camera: cameraOfPair(offered) });
}

/** What is offered, with the button that takes it; nothing where nothing is. */
export function calibrationGroup(store: Store): HTMLElement {
  const text = h('p', { class: 'note', testid: 'calibration' });
  const use = button(say('use-the-calibrated-camera'), 'use-calibration', () => useCalibration(store));
  const forget = button(say('forget-this-calibration'), 'forget-calibration', () => {
    const offered = offeredCalibration(store.state);
    if (offered === null) return;
    forgetCalibration(offered.label);
    store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('the-calibration-is-forgotten') } });
  });
  const group = h('div', {}, text, h('div', { class: 'buttons' }, use, forget));
  store.watch(
    (state) => [offeredCalibration(state)] as const,
    ([offered]) => {
      group.hidden = offered === null;
      if (offered === null) return;
      const { camera, focalErrorPx: error, images, at } = offered;
      fill(text, say('a-block-calibrated-such-a-camera', { images, focal: camera.focal_px, error, day: DAY.format(at) }));
    },
  );
  // It was taken for certain photographs: others have their own camera.
  store.watch(
    (state) => [isOfOthers(state)] as const,
    ([others]) => {
      if (!others) return;
      store.dispatch({ type: 'camera', camera: null });
      store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('the-calibrated-camera-is-not') } });
    },
  );
  return group;
}
