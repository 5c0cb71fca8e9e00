// @ts-check
/** A progress bar on stderr, when it is a terminal; in a pipe or a file, nothing. */

const WIDTH = 24;

export class Progress {
  #done = 0;
  #shown = process.stderr.isTTY === true;

  /** @param {number} steps how many there will be */
  constructor(steps) {
    this.steps = steps;
  }

  /**
   * Shows what is being done, does it, and counts it.
   * @template T @param {string} what @param {() => T} action @returns {T}
   */
  step(what, action) {
    this.#draw(what);
    try {
      const result = action();
      this.#done += 1;
      return result;
    } catch (error) {
      this.end();
      throw error;
    }
  }

  /**
   * As `step`, for what takes its time elsewhere.
   * @template T @param {string} what @param {() => Promise<T>} action @returns {Promise<T>}
   */
  async stepAsync(what, action) {
    this.#draw(what);
    try {
      const result = await action();
      this.#done += 1;
      return result;
    } catch (error) {
      this.end();
      throw error;
    }
  }

  /** Removes the bar. */
  end() {
    if (this.#shown) process.stderr.write('\r\x1b[K');
  }

  /** @param {string} what */
  #draw(what) {
    if (!this.#shown) return;
    const filled = Math.round((WIDTH * this.#done) / this.steps);
    process.stderr.write(`\r\x1b[K[${'#'.repeat(filled)}${'.'.repeat(WIDTH - filled)}] ${what}`);
  }
}
