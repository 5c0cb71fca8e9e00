/** The button that names the version of the program, and opens what is known about it. */
import { aboutDialog } from './about-dialog';
import { LatePart, loadPart } from '../engine/parts';
import { sentence } from '../text/format';
import { messageOf } from '../text/messages';
import { say } from '../text/words';

export function nameVersion(press: HTMLElement, version: string): void {
  const name = `Tiepoint ${version}`;
  press.textContent = name;
  press.title = say('version-and-licences');
  const dialog = new LatePart(async () => {
    const made = aboutDialog(name, await loadPart('about.js', () => import('./about')));
    document.body.append(made);
    return made;
  });
  press.addEventListener('click', () => {
    dialog.get().then(
      (made) => {
        press.textContent = name;
        made.showModal();
      },
      (error: unknown) => {
        press.textContent = `${name}: ${sentence(messageOf(error))}`;
      },
    );
  });
}
