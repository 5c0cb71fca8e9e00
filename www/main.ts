/** What starts the page: it has the texts of the language and the program loaded. */
import './shared/style/base.css';
import './shared/style/layout.css';
import './shared/style/answer.css';
import './shared/style/panels.css';
import './shared/style/view.css';
import './shared/style/direction.css';
import './block/style/block.css';
import './pair/style/pair.css';
import './shared/style/forced.css';
import { wasmModule } from './shared/engine/platform';
import { fetchEarly } from './shared/engine/parts';
import { learnPart } from './shared/engine/texts';
import { mountDrop } from './shared/files/drop';
import { sayDocument, showDocument } from './shared/panel/language';
import { say } from './shared/text/words';

/** A page that is out of sight may draw no frame, whatever its document says of that: it is not waited for longer than this. */
const LONGEST_WAIT_MS = 1000;

/** Resolves once what the document holds is drawn: what is fetched from then on, and runs, does not hold the first view up. */
function firstView(): Promise<void> {
  return new Promise((drawn) => {
    if (document.hidden) drawn();
    else {
      requestAnimationFrame(() => window.setTimeout(drawn));
      window.setTimeout(drawn, LONGEST_WAIT_MS);
    }
  });
}

async function start(): Promise<void> {
  // First of all: the browser would show a file that nobody takes in place of the page.
  const answer = document.getElementById('status');
  let [given, hasTexts] = [0, false];
  const tell = () => {
    const hasFailed = document.getElementById('answer')?.dataset.kind === 'problem';
    if (hasTexts && !hasFailed && given > 0) answer?.replaceChildren(say('loading-the-program-files', { files: given }));
  };
  const serveDrop = mountDrop((waiting) => {
    given = waiting;
    tell();
  });
  await firstView();
  fetchEarly('program.js');
  // It takes longest. Where it fails the program asks again, and says why.
  wasmModule().catch(() => undefined);
  await learnPart('program');
  sayDocument();
  hasTexts = true;
  tell();
  const { startProgram } = await import('./program');
  await startProgram(serveDrop);
}

// Nothing is on the page yet that a new start would lose.
document.getElementById('load-again')?.addEventListener('click', () => location.reload());
start().catch(() => {
  document.getElementById('status')?.replaceChildren();
  document.getElementById('not-loaded')?.removeAttribute('hidden');
  showDocument();
});
