/** Gradient descriptors as pictures: the patch around a point, and a star of eight directions in each of its 4 x 4 cells. */
import { PATCH_SIDE, SURROUNDINGS } from '../engine/inspect';
import { CELLS, DIRECTIONS } from '../state/descriptor';
import type { FeatureView, Inspection, Side } from '../state/state';
import { h } from '../../shared/panel/dom';
import { fixed } from '../../shared/text/format';

/** Canvas px of a sample. */
const PIXEL = 3;
const SIZE = PATCH_SIDE * PIXEL;
const STAR = '#ffd400';
const GRID = 'rgb(255 212 0 / 0.55)';

/** Both points: as they lie in their images with the grid of their descriptors, then turned and scaled to their frames. */
export function featurePictures({ features }: Inspection): HTMLElement[] {
  if (features === null) return [];
  const both = (name: string, testid: string, picture: (feature: FeatureView) => HTMLCanvasElement, text: (feature: FeatureView) => string) => {
    const one = (side: Side, label: string) => {
      const feature = features[side];
      if (feature === null) return h('figure', {}, h('p', { class: 'note' }, 'No point.'), h('figcaption', {}, label));
      const canvas = picture(feature);
      canvas.setAttribute('aria-label', `${label} point, ${name}`);
      return h('figure', {}, canvas, h('figcaption', {}, `${label}${text(feature)}`));
    };
    return [h('h4', {}, name), h('div', { class: 'windows', testid }, one('left', 'Left'), one('right', 'Right'))];
  };
  return [
    ...both('Turned and scaled to the point, contrast stretched', 'point-patches', turnedPicture, () => ''),
    ...both(
      'Descriptor, as it lies in the image',
      'point-descriptors',
      uprightPicture,
      ({ scale, direction, reach }) => ` · scale ${fixed(scale, 1)} px, direction ${fixed((direction * 180) / Math.PI, 0)}°, ${fixed(reach, 0)} px wide`,
    ),
  ];
}

/** Grey values from black to white: what is dull would show nothing. */
function stretched(grey: Uint8Array): Uint8Array {
  const [low, high] = grey.reduce<[number, number]>(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [255, 0]);
  return grey.map((value) => (255 * (value - low)) / Math.max(1, high - low));
}

function canvasOf(grey: Uint8Array): [HTMLCanvasElement, CanvasRenderingContext2D | null] {
  const canvas = h('canvas', { class: 'window', role: 'img' });
  canvas.width = SIZE;
  canvas.height = SIZE;
  const context = canvas.getContext('2d');
  stretched(grey).forEach((value, i) => {
    if (context === null) return;
    context.fillStyle = `rgb(${String(value)} ${String(value)} ${String(value)})`;
    context.fillRect((i % PATCH_SIDE) * PIXEL, Math.floor(i / PATCH_SIDE) * PIXEL, PIXEL, PIXEL);
  });
  return [canvas, context];
}

/** What the descriptor describes: of a right match it is the same in both images. */
function turnedPicture({ turned }: FeatureView): HTMLCanvasElement {
  return canvasOf(turned)[0];
}

function uprightPicture({ upright, descriptor, direction }: FeatureView): HTMLCanvasElement {
  const [canvas, context] = canvasOf(upright);
  if (context === null) return canvas;
  context.translate(SIZE / 2, SIZE / 2);
  context.rotate(direction);
  drawGrid(context, SIZE / SURROUNDINGS);
  drawStars(context, SIZE / SURROUNDINGS, descriptor);
  return canvas;
}

/** The cells, and their first direction, which is that of the point. */
function drawGrid(context: CanvasRenderingContext2D, side: number): void {
  context.strokeStyle = GRID;
  context.lineWidth = 1.5;
  context.beginPath();
  for (let k = 0; k <= CELLS; k++) {
    const at = side * (k / CELLS - 0.5);
    context.moveTo(at, -side / 2);
    context.lineTo(at, side / 2);
    context.moveTo(-side / 2, at);
    context.lineTo(side / 2, at);
  }
  context.moveTo(side / 2, 0);
  context.lineTo(side / 2 + 14, 0);
  context.stroke();
}

/** In each cell a ray a direction, as long as the descriptor's number; the longest of all reaches the cell's border. */
function drawStars(context: CanvasRenderingContext2D, side: number, descriptor: Uint8Array): void {
  const cell = side / CELLS;
  const most = descriptor.reduce((a, b) => Math.max(a, b), 1);
  context.strokeStyle = STAR;
  context.lineWidth = 2.5;
  context.beginPath();
  descriptor.forEach((value, i) => {
    const place = Math.floor(i / DIRECTIONS);
    const x = ((place % CELLS) + 0.5) * cell - side / 2;
    const y = (Math.floor(place / CELLS) + 0.5) * cell - side / 2;
    const angle = ((i % DIRECTIONS) * 2 * Math.PI) / DIRECTIONS;
    const length = (0.5 * cell * value) / most;
    context.moveTo(x, y);
    context.lineTo(x + length * Math.cos(angle), y + length * Math.sin(angle));
  });
  context.stroke();
}
