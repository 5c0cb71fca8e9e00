/** What the page loads first: it settles the language, and has its texts and the program loaded. */
import './shared/style/base.css';
import './shared/style/layout.css';
import './shared/style/answer.css';
import './shared/style/panels.css';
import './shared/style/view.css';
import './shared/style/direction.css';
import './block/style/block.css';
import './pair/style/pair.css';
import { wasmModule } from './shared/engine/platform';
import { learnPart } from './shared/engine/texts';
import { sayDocument, turnDocument } from './shared/panel/language';

async function start(): Promise<void> {
  turnDocument();
  // It takes longest. Where it fails the program asks again, and says why.
  wasmModule().catch(() => undefined);
  await learnPart('program');
  sayDocument();
  const { startProgram } = await import('./program');
  await startProgram();
}

// Nothing is on the page yet that a new start would lose.
document.getElementById('load-again')?.addEventListener('click', () => location.reload());
start().catch(() => {
  document.getElementById('status')?.replaceChildren();
  document.getElementById('not-loaded')?.removeAttribute('hidden');
});
