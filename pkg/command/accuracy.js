// @ts-check
import { FinishedBlock } from '../node.js';
import { about, UsageError } from './errors.js';
import { makeFolder, readBytes, writeInto } from './files.js';
import { JSON_FLAG, path, valueOption } from './options.js';
import { print, printJson } from './output.js';

/** @type {import('./args.js').Command} */
export const accuracy = {
  name: 'accuracy',
  summary: 'Maps of the standard errors, in plan and height, that are expected of points measured in an oriented block.',
  positionals: ['PROJECT'],
  options: [path('out', 'DIR', 'The folder for what is written; required.'), valueOption('cell'), valueOption('sigma_px'), JSON_FLAG],
  details:
    'PROJECT is the project.tiepoint of a block of up to 300 images. In the middle of each cell, on the ground of the tie points, a point is intersected from all images that show it: its standard errors follow from those of its observations and ' +
    'from the covariances of orientations and cameras. It writes plan.tif, height.tif and images.tif, GeoTIFF of floating-point numbers, and accuracy.csv. All are with respect to the datum of the block. ' +
    'JSON: files, unit (of the standard errors: m, or null where the block has no scale), sigma_px, cell (the side of one, in the unit of the coordinates), cells (that two or more images show), three_or_more (the share of these that three or more show), plan and height (the median of the standard errors, and what 95 % of the cells do not exceed), images (the mean number that shows a cell).',
  run({ positionals: [project = ''], values }) {
    const [out, cell, sigma] = [values.get('out'), values.get('cell'), values.get('point-sigma-px')];
    if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder for what is written');
    const bytes = readBytes(project);
    const given = (/** @type {unknown} */ value) => (typeof value === 'number' ? value : undefined);
    const block = about(project, () => FinishedBlock.open(bytes));
    const { summary, ...made } = about(project, () => block.accuracy(given(cell), given(sigma)));
    const { crs, ...scaled } = block.overview();
    const unit = unitOf(scaled);
    makeFolder(out);
    /** @type {[string, string | Uint8Array][]} */
    const all = [
      ['plan.tif', made.plan],
      ['height.tif', made.height],
      ['images.tif', made.images],
      ['accuracy.csv', made.table],
    ];
    const files = all.map(([name, content]) => writeInto(out, name, content));
    if (values.has('json')) printJson({ files, unit, ...summary });
    else print(...files.map((file) => `written: ${file}`), ...describe(summary, unit, crs === null ? unit : 'units of the coordinate system'));
  },
};

/** The unit of a block's lengths: it has one where it lies on the earth or on control points.  @param {Pick<import('../node.js').BlockOverview, 'origin' | 'surveyed'>} block */
const unitOf = ({ origin, surveyed }) => (origin !== null || surveyed.some(({ role }) => role === 'control') ? 'm' : null);

/** @param {import('../node.js').AccuracySummary} summary @param {string | null} unit @param {string | null} unitOfCells @returns {string[]} */
function describe({ cell, cells, three_or_more: three, plan, height }, unit, unitOfCells) {
  const length = (/** @type {number} */ value, of = unit) => [value.toPrecision(3), ...(of === null ? [] : [of])].join(' ');
  const figures = (/** @type {[number, number]} */ [middle, most]) => `${length(middle)} in the median, ${length(most)} at 95 % of the cells`;
  return [
    `${cells} cells of ${length(cell, unitOfCells)} that two or more images show, ${(100 * three).toFixed(0)} % of them three or more`,
    `standard error in plan:   ${figures(plan)}`,
    `standard error in height: ${figures(height)}`,
  ];
}
