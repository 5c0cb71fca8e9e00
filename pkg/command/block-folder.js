// @ts-check
/** The folder that receives the files of a block, and what is printed of them. */

import { planned_files } from '../node.js';
import { describe } from './block-text.js';
import { DataError, VERDICT_CODES } from './errors.js';
import { removeUnfinished } from './files.js';
import { lockFolder } from './lock.js';
import { note, print, printJson } from './output.js';
import { listed } from './text.js';
import { skippedTexts } from './skipped.js';
import { Written } from './written.js';

/** @typedef {import('../node.js').ExportFormat} ExportFormat @typedef {import('../node.js').Summary} Summary */

export class BlockFolder {
  /** @type {string} */
  #out;
  /** @type {readonly ExportFormat[]} */
  #formats;
  #written;
  #release;

  /**
   * Locks the folder, and refuses, before anything is computed, what would write over files of the user.
   * @param {string} out @param {readonly string[]} names of the images @param {readonly ExportFormat[]} formats
   */
  constructor(out, names, formats) {
    const planned = planned_files(names, formats);
    this.#release = lockFolder(out);
    try {
      removeUnfinished(out);
      this.#written = new Written(out);
      this.#written.refuseOthers(planned, formats);
    } catch (error) {
      this.#release();
      throw error;
    }
    [this.#out, this.#formats] = [out, formats];
  }

  /**
   * Writes all files.
   * @param {import('../node.js').FinishedBlock} block @param {import('../node.js').BlockScore | null} score
   * @param {string} [language] of the report @returns {Summary}
   */
  write(block, score, language) {
    const writing = block.files(this.#formats, score, language);
    let summary = null;
    while (!summary) summary = writing.step((path, text) => this.#written.put(path, text));
    this.#written.finish();
    for (const { path: was, kept } of this.#written.setAside) note(`${was} was changed while the run went on: what it held is now ${kept}`);
    return summary;
  }

  /** Prints what came of the block.  @param {Summary} summary @param {boolean} json @returns {import('./errors.js').ExitCode} */
  tell(summary, json) {
    const { images, remarks } = summary;
    for (const text of skippedTexts(images.left_out.map(({ name, reason }) => ({ name, reason: reason.text })))) note(text);
    for (const name of images.stray_masks) note(`the mask ${name} belongs to none of the images`);
    if (images.stray_marks.length > 0) note(`the image measurements name images that are none of the block: ${listed(images.stray_marks)}`);
    for (const { text } of remarks) note(text);
    if (json) printJson(summary);
    else print(...describe(this.#out, summary));
    const refused = summary.exports.filter((e) => e.refused !== null);
    if (refused.length > 0)
      throw new DataError(`not exported: ${refused.map(({ format, refused: why }) => `${format} (${why})`).join('; ')}; all other files were written`);
    return VERDICT_CODES[summary.verdict.kind];
  }

  /** Another run may write into it. */
  release() {
    this.#release();
  }
}

/** The formats of `--export`.  @param {import('./args.js').Call['values']} values @returns {ExportFormat[]} */
export function formatsOf(values) {
  const named = String(values.get('export') ?? '').split(',');
  return /** @type {ExportFormat[]} */ (named.filter(Boolean));
}
