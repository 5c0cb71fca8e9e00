/** The steps of the test command, one after the other or side by side: each is timed, counted, and listed at the end. */

/**
 * @typedef {object} Outcome
 * @property {number} [passed] @property {number} [failed] @property {number} [skipped]
 * @property {string[]} [skips] what was skipped and why
 * @property {string} [note] what went wrong, in a line
 * @typedef {Outcome & { name: string, seconds: number }} Row
 */

export class Steps {
  /** @type {Row[]} */
  #rows = [];

  /** @param {(group: string) => boolean} wanted which groups of steps run */
  constructor(wanted) {
    this.wanted = wanted;
  }

  /** A step that only prepares: it counts when it fails.  @template T @param {string} name @param {() => Promise<T>} action @returns {Promise<T | null>} null when it failed */
  async prepare(name, action) {
    /** @type {T | null} */
    let value = null;
    await this.#timed(`set up: ${name}`, async () => {
      value = await action();
      return {};
    });
    return value;
  }

  /**
   * A step that checks.
   * @param {string} group @param {string} name @param {() => Promise<Outcome | void>} action no outcome: one thing passed
   */
  async check(group, name, action) {
    if (this.wanted(group)) await this.#timed(name, async () => (await action()) ?? { passed: 1 });
  }

  /** @param {string} name @param {() => Promise<Outcome>} action */
  async #timed(name, action) {
    console.log(`\n--- ${name}`);
    const start = performance.now();
    /** @type {Outcome} */
    let outcome;
    try {
      outcome = await action();
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      console.error(message);
      outcome = { failed: 1, note: message.split('\n')[0] ?? '' };
    }
    const seconds = (performance.now() - start) / 1000;
    console.log(`--- ${name}: ${outcome.failed ? 'failed' : 'done'} in ${seconds.toFixed(1)} s`);
    this.#rows.push({ name, seconds, ...outcome });
  }

  /** Prints the table and the totals.  @returns {number} how many failed */
  report() {
    const total = { passed: 0, failed: 0, skipped: 0 };
    const width = Math.max(...this.#rows.map((row) => row.name.length));
    console.log(`\n${'step'.padEnd(width)}   passed  failed  skipped  seconds`);
    for (const { name, seconds, passed = 0, failed = 0, skipped = 0, note } of this.#rows) {
      const counts = [passed, failed, skipped].map((n, i) => String(n).padStart([8, 7, 8][i] ?? 0)).join(' ');
      console.log(`${name.padEnd(width)} ${counts} ${seconds.toFixed(1).padStart(8)}${note ? `  ${note}` : ''}`);
      total.passed += passed;
      total.failed += failed;
      total.skipped += skipped;
    }
    const skips = this.#rows.flatMap((row) => (row.skips ?? []).map((skip) => `${row.name}: ${skip}`));
    if (skips.length > 0) console.log(`\nskipped:\n${skips.map((skip) => `  ${skip}`).join('\n')}`);
    console.log(`\n${total.passed} passed, ${total.failed} failed, ${total.skipped} skipped`);
    return total.failed;
  }
}
