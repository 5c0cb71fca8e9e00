/** A line that offers a later release of the page. It is taken when the user says so; what is on the page is kept and shown again. */
import { keepRelease } from '../engine/release';
import type { Keeper } from '../files/keeper';
import { button, fill, h } from './dom';
import { say } from '../text/words';

export function mountReleases(host: HTMLElement, keeper: Keeper): void {
  const tell = (text: string, ...buttons: HTMLElement[]) => {
    fill(host, h('p', {}, text), ...buttons);
    host.hidden = false;
  };
  const reload = () => void keeper.flush().then(() => location.reload());
  const ready = (take: () => void) => {
    const update = button(say('update'), 'update-take', () => void keeper.flush().then(() => (keeper.isLost ? lose(take) : take())));
    tell(
      say('a-new-version-of-tiepoint'),
      update,
      button(say('later'), 'update-later', () => {
        host.hidden = true;
      }),
    );
  };
  const lose = (take: () => void) => {
    tell(say('the-last-changes-on-the-page'), button(say('update-all-the-same'), 'update-take', take));
  };
  // Where something would be lost, another tab that updates does not reload this one.
  const replaced = () => {
    void keeper.flush().then(() => {
      if (!keeper.isLost) location.reload();
      else tell(say('another-tab-has-updated-tiepoint'), button(say('load-again'), 'update-reload', reload));
    });
  };
  // A browser that keeps no files shows the page all the same.
  keepRelease({ ready, replaced }).catch(() => undefined);
}
