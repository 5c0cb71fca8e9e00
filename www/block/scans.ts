/** Scans of the block in the pair's part of the page, where their fiducial marks are measured. */
import { parse_camera } from '../../pkg/wasm/tiepoint.js';
import { isMeasured, isWhole, placeOfMark, withCoordinatesOf } from '../pair/state/marks';
import { isCurrent } from '../pair/state/keys';
import { otherSide, SIDES } from '../pair/state/state';
import type { Side, State } from '../pair/state/state';
import { doHere } from '../shared/files/leaving';
import { setDrawer, uncoverPictures } from '../shared/panel/drawers';
import { showTab } from '../shared/panel/tabs';
import type { Modes } from '../shared/state/mode';
import type { BlockStore } from './engine/engine';
import { isAsGiven, masksOf, showFiles } from './pair';
import type { Pair, Projects } from './pair';
import type { ScansBeside } from './panel/scans-line';
import { scansOf, withBegun } from './state/film';
import { otherMasks } from './state/masks';
import { begunIn, isInBlock, marksToMeasure } from './state/scan-marks';
import type { MeasuredScan } from './state/scan-marks';
import type { BlockFile } from './state/state';

interface MarkedPair extends Pair {
  /** Begins to measure marks in the image of a side, or ends it there. */
  measureMarks: (side: Side) => void;
}

/** What the block needs of the pair for that. */
export function scansBeside(block: BlockStore, modes: Modes, pair: MarkedPair, projects: Projects): ScansBeside {
  const { store } = pair;
  return {
    shown: () => SIDES.flatMap((side) => scanOn(block, store.state, side) ?? []),
    watch: (changed) => store.watch((s) => [s.images, s.photos, s.results.openLeft, s.results.openRight] as const, changed),
    open: (scans) => openScans(block, modes, pair, projects, scans),
    measure: (image) => {
      const side = SIDES.find((one) => store.state.images[one]?.name === image);
      if (side !== undefined) measure(pair, side);
    },
  };
}

/** The scan of the block that a side of the pair shows; null where it shows none. */
function scanOn({ state: { placing, files } }: BlockStore, state: State, side: Side): MeasuredScan | null {
  const image = state.images[side];
  const scan = scansOf(placing.film, files).find(({ name }) => name === image?.name);
  // Another file may have its name.
  if (scan === undefined || image?.source.kind !== 'file' || image.source.file.size !== scan.file.size) return null;
  const photo = state.photos[side];
  // The table of a scan has positions in its own file, which may be a part of what was measured.
  const all = photo.fiducials.map((mark) => {
    const [col, row] = placeOfMark(photo, mark) ?? [NaN, NaN];
    return { ...mark, col, row };
  });
  const stage = side === 'left' ? 'openLeft' : 'openRight';
  const info = isCurrent(state, stage) ? state.results[stage]?.value.info : undefined;
  const withoutMm = all.filter((mark) => isMeasured(mark) && !isWhole(mark)).length;
  return { image: scan.name, all, marks: all.filter(isWhole), withoutMm, size: info === undefined ? null : [info.width, info.height] };
}

/** Opens scans, one or two, with the marks that were begun or that the block has of them, and begins to measure those of the first one. */
function openScans(block: BlockStore, modes: Modes, pair: MarkedPair, { putAside, stays }: Projects, given: readonly BlockFile[]): Promise<void> {
  return doHere(stays, async (here) => {
    const [left, right] = given;
    if (left === undefined) return;
    // Marks stay with their scan.
    const shown = SIDES.flatMap((side) => scanOn(block, pair.store.state, side) ?? []);
    const film = withBegun(
      block.state.placing.film,
      shown.map(({ image }) => image),
      begunIn(block.state.placing.film, shown),
    );
    if (film !== block.state.placing.film) block.dispatch({ type: 'film', film });
    // What the block has is not kept once more.
    if (hasNothingElse(block, pair.store.state)) isAsGiven(pair.store.state);
    const scans = { left, right: right ?? null };
    const isShown = await showFiles(
      block,
      modes,
      pair,
      putAside,
      {
        ...scans,
        camera: () => (film.camera === null ? null : parse_camera(film.camera.text)),
        marks: (side) => marksToMeasure(film, scans[side]?.name ?? ''),
        opened: null,
      },
      here,
    );
    if (isShown) measure(pair, 'left');
  });
}

/** Whether the pair shows scans of the block, and all that was measured and masked in them is in the block, or begun there. */
function hasNothingElse(block: BlockStore, state: State): boolean {
  const { placing, options } = block.state;
  const isThere = (side: Side) => {
    if (state.images[side] === null) return true;
    const scan = scanOn(block, state, side);
    return scan !== null && (isInBlock(placing.film, scan) || placing.film.begun.some(({ image }) => image === scan.image));
  };
  const hasMasks = SIDES.every((side) => state.masks[side] === null || state.masks[side].source.kind === 'file');
  return SIDES.every(isThere) && hasMasks && otherMasks(options.masks, masksOf(state)).length === 0;
}

/** Begins to measure marks; in a scan without any, those of the other one are to be found. */
function measure({ store, measureMarks }: MarkedPair, side: Side): void {
  const { photos, tool, mark } = store.state;
  if (tool === 'fiducials' && mark?.side === side) return;
  const { fiducials } = photos[side];
  const taken = fiducials.length > 0 ? null : withCoordinatesOf([], photos[otherSide(side)].fiducials);
  if (taken !== null) store.dispatch({ type: 'photo', side, photo: { fiducials: taken } });
  measureMarks(side);
  if (store.state.photos[side].fiducials.length > 0) return;
  // Where photo coordinates are typed.
  setDrawer('settings', true);
  showTab('tab-camera');
  uncoverPictures();
}
