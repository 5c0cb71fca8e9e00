// @ts-check
import { FinishedBlock } from '../node.js';
import { about, UsageError } from './errors.js';
import { makeFolder, readBytes, writeInto } from './files.js';
import { path, valueOption } from './options.js';
import { print } from './output.js';

/** @type {import('./args.js').Command} */
export const accuracy = {
  name: 'accuracy',
  summary: 'Maps of the standard errors, in plan and height, that are expected of points measured in an oriented block.',
  positionals: ['PROJECT'],
  options: [path('out', 'DIR', 'The folder for what is written; required.'), valueOption('cell'), valueOption('sigma_px')],
  details:
    'PROJECT is the project.tiepoint of a block of up to 300 images. In the middle of each cell, on the ground of the tie points, a point is intersected from all images that show it: its standard errors follow from those of its observations and ' +
    'from the covariances of orientations and cameras. It writes plan.tif, height.tif and images.tif, GeoTIFF of floating-point numbers, and accuracy.csv. All are with respect to the datum of the block.',
  run({ positionals: [project = ''], values }) {
    const [out, cell, sigma] = [values.get('out'), values.get('cell'), values.get('point-sigma-px')];
    if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder for what is written');
    const bytes = readBytes(project);
    const given = (/** @type {unknown} */ value) => (typeof value === 'number' ? value : undefined);
    const { summary, ...files } = about(project, () => FinishedBlock.open(bytes).accuracy(given(cell), given(sigma)));
    makeFolder(out);
    /** @type {[string, string | Uint8Array][]} */
    const all = [
      ['plan.tif', files.plan],
      ['height.tif', files.height],
      ['images.tif', files.images],
      ['accuracy.csv', files.table],
    ];
    for (const [name, content] of all) print(`written: ${writeInto(out, name, content)}`);
    const figures = (/** @type {[number, number]} */ [middle, most]) => `${middle.toPrecision(3)} in the median, ${most.toPrecision(3)} at 95 % of the cells`;
    print(
      `${summary.cells} cells of ${summary.cell.toPrecision(3)} that two or more images show, ${(100 * summary.three_or_more).toFixed(0)} % of them three or more`,
    );
    print(`standard error in plan:   ${figures(summary.plan)}`);
    print(`standard error in height: ${figures(summary.height)}`);
  },
};
