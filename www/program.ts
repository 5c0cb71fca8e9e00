/** The program of the page: starts the part of the pair, has that of the block loaded when it is first needed, and joins them. */
import { hasGround } from './block/files/rasters';
import type { Block } from './block/mount';
import { mountPair } from './pair/mount';
import type { Pair } from './pair/mount';
import { checkRules } from './pair/state/codes';
import { project_kind } from './shared/crate';
import type { Catalogue } from './shared/crate';
import { breath } from './shared/engine/breath';
import { LatePart, loadPart } from './shared/engine/parts';
import { watchLaunches } from './shared/engine/release';
import { loadCatalogue } from './shared/engine/start';
import { learnPart } from './shared/engine/texts';
import { Database } from './shared/files/database';
import type { FoundFile, ServeDrop, Taker } from './shared/files/drop';
import { Keeper } from './shared/files/keeper';
import { LateKeepable } from './shared/files/late';
import { nameVersion } from './shared/panel/version';
import { beforeSearch, mountActions } from './shared/panel/actions';
import { byId } from './shared/panel/dom';
import { mountLanguage } from './shared/panel/language';
import { mountMenu } from './shared/panel/menu';
import { modeSwitch, showIn } from './shared/panel/mode';
import { mountProjects } from './shared/panel/projects';
import { mountReleases } from './shared/panel/releases';
import { mountTheme } from './shared/panel/theme';
import { isMode, makeModes } from './shared/state/mode';
import type { Mode } from './shared/state/mode';
import type { Notice } from './shared/state/notice';
import { sentence } from './shared/text/format';
import { messageOf } from './shared/text/messages';
import { say } from './shared/text/words';

/** So much of a project file says what it holds. */
const START_BYTES = 1024;

/** What keeps the work, once it is there. */
let keeping: Keeper | null = null;

/** `serveDrop`: takes who gets dropped files, and gives what was dropped before. */
export async function startProgram(serveDrop: ServeDrop): Promise<void> {
  mountTheme(byId('theme'));
  mountLanguage(byId('language'), () => keeping);
  mountActions(byId('actions'));
  mountMenu(byId('menu'), byId('bar-menu'));
  const opening = Database.open();
  // `startParts` waits for it, once the module is there.
  opening.catch(() => undefined);
  try {
    await startParts(opening, serveDrop);
  } catch (error) {
    byId('answer').dataset.kind = 'problem';
    byId('status').textContent = messageOf(error);
  }
}

/** The module holds words and options of the page: its parts are made once it is there, and show what the browser has kept. */
async function startParts(opening: Promise<Database>, serveDrop: ServeDrop): Promise<void> {
  const catalogue = await loadCatalogue();
  checkRules(catalogue.rules);
  nameVersion(byId('about'), catalogue.version);
  await breath();
  const modes = makeModes();
  const takers: Taker[] = [];
  const pair = await mountPair(catalogue, {
    openProject,
    toBlock,
    toGround,
    sampleBlock,
    putAside: (kept) => keeper.putAside(kept),
    left: () => keeper.left(),
  });
  showIn(modes, 'pair', [...document.querySelectorAll<HTMLElement>('.bar .actions, .bar .drawers, body > main')]);
  document.querySelector('.bar h1')?.after(modeSwitch(modes, (mode) => void show(mode)));
  await breath();
  const blocks = new LatePart(async () => {
    const block = await loadBlock(catalogue, pair, {
      modes,
      openProject,
      putAside: (kept) => keeper.putAside(kept),
      left: () => keeper.left(),
      stays: () => keeper.stays(),
    });
    keptBlock.arrive(block.kept);
    takers.unshift(block.taker);
    return block;
  });
  beforeSearch(() => blocks.get());
  const keptBlock = new LateKeepable('block', () => blocks.get());
  /** What cannot be loaded is said, and tried again the next time. */
  async function withBlock(act: (block: Block) => void | Promise<void>): Promise<void> {
    const block = await blocks.get().catch((error: unknown) => {
      pair.store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('the-block-was-not-loaded', { error: sentence(messageOf(error)) }) } });
    });
    if (block !== undefined) await act(block);
  }
  async function show(mode: Mode, isKept = false): Promise<void> {
    const to = isKept ? { kept: mode } : mode;
    if (mode === 'pair') modes.dispatch(to);
    else await withBlock(() => modes.dispatch(to));
  }
  const inBlock = (act: (block: Block) => void | Promise<void>) =>
    withBlock(async (block) => {
      modes.dispatch('block');
      await act(block);
    });
  /** What a file holds decides which part shows it; what is no project is refused by the part that it was given to. */
  async function openProject(file: File): Promise<void> {
    // The one that is being opened shows its own part.
    await keeper.left();
    const mode = project_kind(new Uint8Array(await file.slice(0, START_BYTES).arrayBuffer())) ?? modes.state.mode;
    if (mode === 'block') return inBlock((block) => block.open(file));
    modes.dispatch(mode);
    await pair.open(file);
  }
  /** More images than two are a block. */
  function toBlock(files: readonly File[], masks: readonly File[]): void {
    void inBlock((block) => block.give(files, masks));
  }
  /** An orthophoto with photographs is nothing for a pair. */
  async function toGround(found: FoundFile[]): Promise<boolean> {
    if (!(await hasGround(found))) return false;
    await inBlock((block) => block.taker.take(found, null));
    return true;
  }
  function sampleBlock(): void {
    void inBlock((block) => block.sample());
  }
  const keeper = new Keeper([keptBlock, pair.kept], {
    now: () => modes.state.mode,
    show: (kept) => {
      if (isMode(kept)) void show(kept, true);
    },
    watch: (changed) => modes.watch(['mode'], changed),
  });
  keeping = keeper;
  mountProjects(keeper, (near) => (modes.state.mode === 'pair' ? void pair.save(near) : void withBlock((block) => block.save(near))));
  sayOpening(keeper, pair);
  await keeper.start(opening, () => {
    pair.store.dispatch({ type: 'ready', catalogue });
    return breath();
  });
  pair.begin();
  takers.push(pair.taker);
  serveDrop(takers);
  watchLaunches(openProject);
  mountReleases(byId('update'), keeper);
}

/** Says which kept work is being opened; nobody is welcomed meanwhile. */
function sayOpening(keeper: Keeper, { store }: Pair): void {
  let said: Notice | null = null;
  keeper.keeping.watch(['opening'], ([title]) => {
    document.body.classList.toggle('is-opening', title !== null);
    if (title === null && (said === null || store.state.notice !== said)) return;
    said = title === null ? null : { kind: 'info', text: say('opening-kept-work', { title }) };
    store.dispatch({ type: 'notice', notice: said });
  });
}

/** The part of the block, with its texts. */
async function loadBlock(
  catalogue: Catalogue,
  pair: Pair,
  elsewhere: Omit<Parameters<typeof import('./block/mount').mountBlock>[1], 'openPair' | 'pair' | 'scans'>,
): Promise<Block> {
  // Its words are said as soon as it is there.
  await learnPart('block');
  const { blockCatalogue, masksOf, matchesOf, mountBlock, openPair, scansBeside } = await loadPart('block.js', () => import('./block'));
  const ofBlocks = blockCatalogue(catalogue);
  const projects = { putAside: () => elsewhere.putAside(pair.kept), stays: elsewhere.stays };
  const block = await mountBlock(ofBlocks, {
    ...elsewhere,
    pair: {
      names: () => [pair.store.state.images.left?.name ?? null, pair.store.state.images.right?.name ?? null],
      masks: () => masksOf(pair.store.state),
      matches: () => matchesOf(pair.store.state),
      watch: (changed) => pair.store.watch(['images', 'masks'], changed),
      watchMatches: (changed) => pair.store.watch(['results', 'history'], changed),
    },
    openPair: (store, images) => openPair(store, elsewhere.modes, pair, projects, images),
    scans: (store) => scansBeside(store, elsewhere.modes, pair, projects),
  });
  block.store.dispatch({ type: 'ready', catalogue: ofBlocks });
  return block;
}
