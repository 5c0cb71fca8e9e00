/** What the panes show, gathered from the state once a drawing. */
import { remember } from '../../../shared/state/remember';
import type { PaneView, Position } from '../../../shared/state/pane';
import { fitView, inPane, transformOf } from '../../../shared/view/panes';
import { contains } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import type { Facts } from '../../engine/facts';
import type { ImagePoints } from '../../state/facts';
import { shownImages } from '../../state/panes';
import type { Panes } from '../../state/panes';
import type { BlockFile, BlockState } from '../../state/state';
import type { BlockView } from '../../state/view';
import { gridOf } from './grid';

export interface Pane {
  /** Index of the image in the block. */
  image: number;
  width: number;
  height: number;
  /** Null where the image was not given with its block. */
  file: BlockFile | null;
  rect: Rect;
  transform: Transform;
  /** Null while they are on their way. */
  points: ImagePoints | null;
}

/** Files by the names of their images. */
const byName = remember(
  (files: readonly BlockFile[], made: readonly BlockFile[]): ReadonlyMap<string, BlockFile> => new Map([...files, ...made].map((file) => [file.name, file])),
);

const NO_FILES: readonly BlockFile[] = [];

/** The panes on a canvas of `width` x `height` CSS px. */
export function panesOf(state: BlockState, view: BlockView, facts: Facts, columns: number, width: number, height: number): Pane[] {
  const images = shownImages(state.panes, view);
  const files = byName(state.files, state.shown?.files ?? NO_FILES);
  const rects = gridOf(images.length, columns, width, height);
  return images.flatMap((image, i): Pane[] => {
    const [of, rect] = [view.images[image], rects[i]];
    if (of === undefined || rect === undefined) return [];
    return [
      {
        image,
        width: of.width,
        height: of.height,
        file: files.get(of.name) ?? null,
        rect,
        transform: transformOf(rect, paneView(state.panes, image, rect, of)),
        points: facts.points(image),
      },
    ];
  });
}

/** A place of an image. */
export interface At {
  image: number;
  at: Position;
}

interface Size {
  width: number;
  height: number;
}

/** Where a pane looks: where it was moved to, else at the whole of its image. */
export function paneView({ views }: Panes, image: number, rect: Rect, of: Size): PaneView {
  const own = views.get(image);
  return own === undefined ? fitView(rect, of.width, of.height) : inPane(own, rect);
}

/** The scale at which an image leaves no bands beside it. */
export function fillScale({ width, height }: Rect, of: Size): number {
  return Math.max(width / of.width, height / of.height);
}

/** The pane at a place of the canvas. */
export function paneAt(panes: readonly Pane[], x: number, y: number): Pane | null {
  return panes.find(({ rect }) => contains(rect, x, y)) ?? null;
}

/** Whether a position lies on the image of a pane. */
export function isOn({ width, height }: Pane, [x, y]: Position): boolean {
  return x >= 0 && y >= 0 && x <= width && y <= height;
}
