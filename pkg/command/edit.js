// @ts-check
import { export_formats, FinishedBlock, project_kind } from '../node.js';
import { BlockFolder, formatsOf } from './block-folder.js';
import { about, DataError, UsageError } from './errors.js';
import { readBytes } from './files.js';
import { textOf } from '../block/text-of.js';
import { JSON_FLAG, LANGUAGE, languageOf, list, path } from './options.js';
import { note } from './output.js';

/** So much of a project says what it holds; all of a large one would be too long for a text. */
const START_BYTES = 1024;

/** @type {import('./args.js').Command} */
export const edit = {
  name: 'edit',
  summary: 'Applies edits by hand to the project of a block, adjusts it anew and writes all of its files; without edits it writes them again.',
  positionals: ['PROJECT'],
  options: [
    path('out', 'DIR', 'Folder that receives the files; required.'),
    path(
      'edits',
      'FILE',
      'Edits in their order, in place of those of the project: [{"kind": "reject_observations", "observations": [{"point": {"tie_point": 7}, "image": 0}]}, …]; [] undoes all. Or the project of the same block as it was placed on an orthophoto before, whose edits are carried over.',
    ),
    list('export', export_formats(), 'Formats for other programs, with commas between; each in a folder of its name.'),
    LANGUAGE,
    JSON_FLAG,
  ],
  details:
    'PROJECT is the project.tiepoint of a block. Kinds of edits: reject_observations, restore_observations, reject_points, restore_points, reject_images, restore_images, reject_pairs, restore_pairs (pairs: two images each), measure (point, image, x_px, y_px; ' +
    'moves an observation or adds one), add_point (observations in two or more images), add_control (name, position, standard_errors, sigma_px, use; measured by edits behind it), set_use (point, use: control, check or null). The project keeps the block as it was found beside the edits: they can be undone. ' +
    'Images are not needed. The exit code is that of the verdict: 0 oriented, 3 weak, 4 not oriented.',
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals: [project = ''], values }) {
  const [out, file] = [values.get('out'), values.get('edits')];
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the files');
  const opened = about(project, () => FinishedBlock.open(readBytes(project)));
  const block = typeof file === 'string' ? about(file, () => opened.edited(editsOf(file, opened))) : opened;
  const folder = new BlockFolder(
    out,
    block.model().images.map(({ name }) => name),
    formatsOf(values),
  );
  try {
    return folder.tell(folder.write(block, null, languageOf(values)), values.has('json'));
  } finally {
    folder.release();
  }
}

/**
 * A list of edits, or those of another project of the block, as they hold of this one.
 * @param {string} file @param {import('../node.js').FinishedBlock} block @returns {import('../node.js').BlockEdit[]}
 */
function editsOf(file, block) {
  const bytes = readBytes(file);
  if (project_kind(bytes.subarray(0, START_BYTES)) !== null) return carriedOver(FinishedBlock.open(bytes), block);
  const edits = parsed(file, textOf(bytes));
  if (Array.isArray(edits)) return edits;
  throw new DataError(`${file}: it holds no list of edits`);
}

/** @param {string} file @param {string} text @returns {unknown} */
function parsed(file, text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
    throw new DataError(`${file}: it is no JSON (${error.message})`);
  }
}

/**
 * @param {import('../node.js').FinishedBlock} before which is freed @param {import('../node.js').FinishedBlock} block
 * @returns {import('../node.js').BlockEdit[]}
 */
function carriedOver(before, block) {
  try {
    const { edits, held, lost } = block.carried_edits(before);
    if (held + lost > 0)
      note(
        `what was done to places of the orthophoto holds for ${held} that lie there again, and not for ${lost}: nothing was found there, what was measured is of another spot, or coordinates are of another system`,
      );
    return edits;
  } finally {
    before.free();
  }
}
