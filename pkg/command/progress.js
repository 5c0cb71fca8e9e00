// @ts-check
/** Progress on stderr: a bar on a terminal; elsewhere nothing, or a line for each stage of a block and each step of a report. */

/** @typedef {import('../block/index.js').Step} Step */

const WIDTH = 24;

/** The bar of a stage is drawn again after so many milliseconds. */
const PAUSE_MS = 100;

/** What the steps of each stage are; those of one piece have one step, which is not counted.  @type {Record<Step['stage'], string>} */
const WORDS = {
  photos: 'photos',
  images: 'images',
  geoid: 'geoid',
  likeness: 'similarity of images',
  pairs: 'pairs',
  points: 'tie points',
  windows: 'images for windows of observations',
  refinement: 'groups of points refined',
  orientation: 'orientation',
};

/** Stages that are one computation. */
const OF_ONE_PIECE = ['geoid', 'points', 'orientation'];

export class Progress {
  #bar = process.stderr.isTTY === true;
  #open = false;
  #drawn = 0;
  #done = 0;

  /** @param {{ steps?: number, quiet?: boolean }} how how many steps there will be; whether ended steps and stages get no line where there is no terminal */
  constructor({ steps = 1, quiet = true } = {}) {
    this.steps = steps;
    this.quiet = quiet;
  }

  /**
   * Shows what is being done, does it, and counts it.
   * @template T @param {string} what @param {() => T} action at once, or with a promise @returns {T}
   */
  step(what, action) {
    this.#draw(this.#done / this.steps, what);
    this.#done += 1;
    const begun = performance.now();
    const failed = (/** @type {unknown} */ error) => {
      this.end();
      throw error;
    };
    const ended = (/** @type {any} */ result) => {
      if (!this.quiet && !this.#bar) process.stderr.write(`${what} in ${duration((performance.now() - begun) / 1000)}\n`);
      return result;
    };
    try {
      const result = action();
      return result instanceof Promise ? /** @type {T} */ (result.then(ended, failed)) : ended(result);
    } catch (error) {
      return failed(error);
    }
  }

  /** Shows a step of a stage; one that ends its stage leaves a line.  @param {Step} step */
  stage({ stage, done, total, found, name, seconds, secondsLeft }) {
    const ended = done === total;
    const now = performance.now();
    if (ended || now - this.#drawn >= PAUSE_MS) {
      this.#drawn = now;
      const left = secondsLeft === undefined ? '' : `, ${duration(secondsLeft)} left`;
      this.#draw(total > 0 ? done / total : 1, `${WORDS[stage]} ${done}/${total}${left}${name ? ` ${name}` : ''}`);
    }
    if (!ended || (this.quiet && !this.#bar)) return;
    this.end();
    const earlier = found > 0 ? ` (${found} from an earlier run)` : '';
    const counted = OF_ONE_PIECE.includes(stage) ? '' : `: ${total}`;
    process.stderr.write(`${WORDS[stage]}${counted}${earlier} in ${duration(seconds)}\n`);
  }

  /** Removes the bar. */
  end() {
    if (this.#open) process.stderr.write('\r\x1b[K');
    this.#open = false;
  }

  /** @param {number} share @param {string} text */
  #draw(share, text) {
    if (!this.#bar) return;
    this.#open = true;
    const filled = Math.round(WIDTH * share);
    process.stderr.write(`\r\x1b[K[${'#'.repeat(filled)}${'.'.repeat(WIDTH - filled)}] ${text}`);
  }
}

/** @param {number} seconds */
function duration(seconds) {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const minutes = Math.floor(seconds / 60);
  return minutes < 60 ? `${minutes} min ${Math.round(seconds % 60)} s` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}
