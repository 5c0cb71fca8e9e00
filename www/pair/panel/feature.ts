/** Gradient descriptors as pictures: the patch around a point, and a star of eight directions in each of its 4 x 4 cells. */
import { PATCH_SIDE, SURROUNDINGS } from '../engine/inspect';
import { CELLS, DIRECTIONS } from '../state/descriptor';
import type { FeatureView, Inspection, PlaceView, Side } from '../state/state';
import { h } from '../../shared/panel/dom';
import { remember } from '../../shared/state/remember';
import { say } from '../../shared/text/words';

/** Canvas px of a sample. */
const PIXEL = 3;
const SIZE = PATCH_SIDE * PIXEL;
const STAR = '#ffd400';
const GRID = 'rgb(255 212 0 / 0.55)';

/** Both points: as they lie in their images with the grid of their descriptors, then turned and scaled to their frames. The same ones of the same inspection. */
export const featurePictures = remember(({ features }: Inspection): HTMLElement[] => {
  if (features === null) return [];
  const both = (
    name: string,
    testid: string,
    placed: boolean,
    picture: (feature: FeatureView) => HTMLCanvasElement,
    text: (feature: FeatureView) => string,
  ) => {
    const one = (side: Side, label: string) => {
      const feature = features[side];
      if (feature === null) return h('figure', {}, h('p', { class: 'note' }, say('no-point')), h('figcaption', {}, label));
      if (feature.descriptor === null) return placeFigure(feature, label, placed);
      const canvas = picture(feature);
      canvas.setAttribute('aria-label', say('point-2', { label, name }));
      return h('figure', {}, canvas, h('figcaption', {}, `${label}${text(feature)}`));
    };
    return [h('h4', {}, name), h('div', { class: 'windows', testid }, one('left', say('left')), one('right', say('right')))];
  };
  return [
    ...both(say('turned-and-scaled-to-the'), 'point-patches', false, turnedPicture, () => ''),
    ...both(say('descriptor-as-it-lies-in'), 'point-descriptors', true, uprightPicture, ({ scale, direction, reach }) =>
      say('scale-px-direction-px-wide', { scale, direction: (direction * 180) / Math.PI, reach }),
    ),
  ];
});

/** Of a place that is no interest point why nothing of it was compared, or, as it lies in the image, what is there. */
function placeFigure({ upright, byHand }: PlaceView, label: string, placed: boolean): HTMLElement {
  const why = say('no-interest-point-here', { by: byHand ? 'hand' : 'least_squares' });
  if (!placed) return h('figure', {}, h('p', { class: 'note' }, why), h('figcaption', {}, label));
  const [canvas] = canvasOf(upright);
  canvas.setAttribute('aria-label', say('point-2', { label, name: why }));
  return h('figure', {}, canvas, h('figcaption', {}, label));
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
  if (context === null) return [canvas, context];
  const samples = stretched(grey);
  const pixels = context.createImageData(SIZE, SIZE);
  // Pixel by pixel: a rectangle of a colour a sample takes as long as all of an edit may.
  for (let i = 0; i < SIZE * SIZE; i++) {
    const sample = PATCH_SIDE * Math.floor(i / SIZE / PIXEL) + Math.floor((i % SIZE) / PIXEL);
    pixels.data.fill(samples[sample] ?? 0, 4 * i, 4 * i + 3);
    pixels.data[4 * i + 3] = 255;
  }
  context.putImageData(pixels, 0, 0);
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
