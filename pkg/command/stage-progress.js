// @ts-check
/** The progress of a block on stderr: a bar on a terminal, elsewhere one line a stage. */

/** @typedef {import('../block/index.js').Step} Step */

const WIDTH = 24;

/** The bar is drawn again after so many milliseconds. */
const PAUSE_MS = 100;

/** What the steps of each stage are; those of one piece have one step, which is not counted.  @type {Record<Step['stage'], string>} */
const WORDS = {
  photos: 'photos', images: 'images', likeness: 'likeness of images', pairs: 'pairs', points: 'tie points', windows: 'images for windows of rays',
  refinement: 'groups of points refined', orientation: 'orientation',
};

/** Stages that are one computation. */
const OF_ONE_PIECE = ['points', 'orientation'];

export class StageProgress {
  #bar = process.stderr.isTTY === true;
  #quiet;
  #drawn = 0;
  #open = false;

  /** @param {boolean} quiet no lines where there is no terminal */
  constructor(quiet) {
    this.#quiet = quiet;
  }

  /** @param {Step} step */
  show(step) {
    const ended = step.done === step.total;
    if (this.#bar) this.#draw(step, ended);
    if (ended && !(this.#quiet && !this.#bar)) {
      this.end();
      const found = step.found > 0 ? ` (${step.found} from an earlier run)` : '';
      const counted = OF_ONE_PIECE.includes(step.stage) ? '' : `: ${step.total}`;
      process.stderr.write(`${WORDS[step.stage]}${counted}${found} in ${duration(step.seconds)}\n`);
    }
  }

  /** Removes the bar. */
  end() {
    if (this.#open) process.stderr.write('\r\x1b[K');
    this.#open = false;
  }

  /** @param {Step} step @param {boolean} ended */
  #draw({ stage, done, total, name, secondsLeft }, ended) {
    const now = performance.now();
    if (!ended && now - this.#drawn < PAUSE_MS) return;
    this.#drawn = now;
    this.#open = true;
    const filled = total > 0 ? Math.round((WIDTH * done) / total) : WIDTH;
    const left = secondsLeft === undefined ? '' : `, ${duration(secondsLeft)} left`;
    process.stderr.write(`\r\x1b[K[${'#'.repeat(filled)}${'.'.repeat(WIDTH - filled)}] ${WORDS[stage]} ${done}/${total}${left}${name ? ` ${name}` : ''}`);
  }
}

/** @param {number} seconds */
function duration(seconds) {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const minutes = Math.floor(seconds / 60);
  return minutes < 60 ? `${minutes} min ${Math.round(seconds % 60)} s` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}
