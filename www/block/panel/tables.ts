/** The tables of a block: its images, and its points. */
import { count, fixed } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { Looking } from '../view/looking';
import { fill, h } from '../../shared/panel/dom';
import { Table } from '../../shared/panel/table';
import type { Column } from '../../shared/state/rows';
import type { BlockView } from '../state/view';

export function mountImages(host: HTMLElement, store: BlockStore, looking: Looking): void {
  const table = captioned(host, 'block-images', 'Images', (image) => looking.choose({ kind: 'image', image }));
  store.watch(['shown'], ([shown]) => table.show(shown === null ? NONE : imageRows(shown.view)));
  store.watch(['choice'], ([choice]) => table.mark(choice?.kind === 'image' ? choice.image : -1));
}

export function mountPoints(host: HTMLElement, store: BlockStore): void {
  const table = captioned(host, 'block-points', 'Points');
  store.watch(['shown'], ([shown]) => table.show(shown === null ? NONE : pointRows(shown.view)));
}

interface Rows {
  count: number;
  columns: readonly Column[];
}

const NONE: Rows = { count: 0, columns: [] };

/** A table under a line that counts its rows. */
function captioned(
  host: HTMLElement,
  testid: string,
  words: string,
  choose?: (row: number) => void,
): { show: (rows: Rows) => void; mark: (row: number) => void } {
  const caption = h('p', { class: 'note' });
  host.append(caption);
  const table = new Table(host, { testid, words: { table: words, region: `Table: ${words}` }, ...(choose === undefined ? {} : { choose }) });
  return {
    show: (rows) => fill(caption, `${words}: ${count(table.show(rows.count, rows.columns))}`),
    mark: (row) => table.mark(row),
  };
}

/** A column of numbers with so many decimals. */
function numbers(key: string, label: string, unit: string, digits: number, value: (row: number) => number, help: string): Column {
  return { key, label, unit, help, value, text: (row) => (digits === 0 ? count(Number.isNaN(value(row)) ? null : value(row)) : fixed(value(row), digits)) };
}

function words(key: string, label: string, value: (row: number) => string, help: string): Column {
  return { key, label, unit: '', help, value, text: value };
}

function imageRows({ images, leftOut, cameras }: BlockView): Rows {
  const known = (value: number | null | undefined) => value ?? NaN;
  return {
    count: images.length + leftOut.length,
    columns: [
      words('name', 'Image', (i) => images[i]?.name ?? leftOut[i - images.length]?.name ?? '', 'File name. Press it to choose the image in the picture.'),
      numbers('number', 'No.', '', 0, (i) => (i < images.length ? i + 1 : NaN), 'Row and column in the matrix.'),
      numbers('features', 'Features', '', 0, (i) => known(images[i]?.features), 'Points detected and described.'),
      numbers('rays', 'Obs.', '', 0, (i) => known(images[i]?.rays), 'Observations of selected tie points, without rejected ones.'),
      numbers('places', 'Cov.', '', 0, (i) => known(images[i]?.places), 'Coverage: how many of the nine von Gruber positions hold a selected tie point.'),
      numbers('rmse', 'RMSE', 'px', 2, (i) => known(images[i]?.rmsePx), 'Root mean square length of the residuals of its observations.'),
      ...(cameras.length > 1
        ? [
            numbers(
              'camera',
              'Camera',
              '',
              0,
              (i) => known(images[i]?.camera) + 1,
              `Images of one camera are calibrated together: ${cameras.map(({ label }, c) => `${String(c + 1)} ${label}`).join('; ')}.`,
            ),
          ]
        : []),
      words('state', 'State', (i) => stateOf(images[i]?.why ?? leftOut[i - images.length]?.reason ?? ''), 'Whether the image is oriented, and if not, why.'),
    ],
  };
}

function stateOf(why: string): string {
  return why === '' ? 'oriented' : why;
}

function pointRows({ points }: BlockView): Rows {
  const axis = (key: string, label: string, offset: number) => [
    numbers(key, label, '', 2, (i) => points.positions[3 * i + offset] ?? NaN, 'Object coordinate, in m where the block has a scale.'),
    numbers(`sigma-${key}`, `σ ${label}`, '', 3, (i) => points.errors[3 * i + offset] ?? NaN, `Standard error of ${label}, from the adjustment.`),
  ];
  return {
    count: points.count,
    columns: [
      numbers('point', 'Point', '', 0, (i) => i + 1, 'Number of the point.'),
      numbers('point-rays', 'Rays', '', 0, (i) => points.rays[i] ?? NaN, 'Number of images that see the point.'),
      numbers('point-rmse', 'RMSE', 'px', 2, (i) => points.rmsePx[i] ?? NaN, 'Root mean square length of the residuals of its observations.'),
      ...axis('x', 'X', 0),
      ...axis('y', 'Y', 1),
      ...axis('z', 'Z', 2),
      numbers(
        'confidence',
        'Probability',
        '',
        3,
        (i) => points.confidence[i] ?? NaN,
        'Probability that all its observations show one point, from the matches alone.',
      ),
    ],
  };
}
