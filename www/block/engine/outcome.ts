/** What of a run, or of a project that was opened, the page shows. */
import { chosenOf, knownCamera } from '../../../pkg/block/index.js';
import type { BlockRun, GroupedCamera, ReadImage } from '../../../pkg/block/index.js';
import { connected_groups, export_formats, message } from '../../../pkg/wasm/tiepoint.js';
import type { BlockModel, Connection, Camera, Project } from '../../../pkg/wasm/tiepoint.js';
import { withReconstruction } from './adjustment';
import { layoutOf } from './layout';
import type { BlockView, RayCount, ViewCamera, ViewConnection, ViewImage, ViewPoints } from '../state/view';

/** A block as its worker holds it. */
export interface Held {
  /** Null where the block was opened from its file. */
  run: BlockRun | null;
  project: Project;
}

export function viewOfRun(run: BlockRun): BlockView {
  const { model, points, reconstruction } = run;
  const shared = new Map<string, number>();
  for (let i = 0; i < points.shared.length; i += 3) shared.set(points.shared.slice(i, i + 2).join(), points.shared[i + 2] ?? 0);
  const view = viewOf(model, run.connections, run.images.map(({ exif }) => exif), shared, run.geometries.map(geometryName));
  const cameras = withLabels(view.cameras, run.cameras);
  const images = view.images.map((image, i) => ({ ...image, features: run.images[i]?.features ?? null, places: run.selection.placesOfImages[i] ?? null }));
  const whole: BlockView = { ...view, cameras, images, leftOut: run.leftOut, strayMasks: run.strayMasks, strayMarks: run.strayMarks, remarks: run.remarks, found: { points: points.count, rays: points.rays }, refinement: run.refinement?.counts ?? null };
  return withReconstruction(whole, reconstruction, run.reconstructionReason);
}

/** A block whose points are not made yet. */
export function viewOfParts(
  read: readonly ReadImage[], cameras: readonly GroupedCamera[], of: readonly number[], connections: readonly Connection[], geometries: BlockRun['geometries'],
): BlockView {
  const images = read.map(({ name }, i) => ({ name, camera: of[i] ?? 0, pose: null }));
  const view = viewOf({ cameras, images, points: [] }, connections, read.map(({ head }) => head.exif), new Map(), geometries.map(geometryName));
  return {
    ...view,
    partial: true,
    images: view.images.map((image, i) => ({ ...image, features: read[i]?.count ?? null, why: 'not oriented yet' })),
    cameras: withLabels(view.cameras, cameras),
  };
}

/** What is known of cameras beside the block's model. */
function withLabels(cameras: readonly ViewCamera[], grouped: readonly GroupedCamera[]): ViewCamera[] {
  return cameras.map((camera, i) => ({ ...camera, label: grouped[i]?.label ?? camera.label, given: grouped[i] === undefined ? null : knownCamera(grouped[i]) }));
}

export function viewOfProject({ block, connections }: Project): BlockView {
  return viewOf(block, connections, block.images.map(() => null), chosenOf(block), connections.map(() => ''));
}

/** A block of whose cameras the focal length may not be known, as long as none of their images is oriented. */
type Block = Omit<BlockModel, 'cameras'> & { cameras: readonly (Camera | GroupedCamera)[] };

function viewOf(
  model: Block, connections: readonly Connection[], exif: Parameters<typeof layoutOf>[1], shared: ReadonlyMap<string, number>, geometries: readonly string[],
): BlockView {
  const groups = connected_groups(model.images.length, [...connections]);
  const chosen = chosenOf(model);
  const links: ViewConnection[] = connections.map(({ images, rule, outcome }, i) => ({
    images, rule, outcome, reason: message('connection', connections[i] as Connection), geometry: geometries[i] ?? '', shared: shared.get(images.join()) ?? 0, chosen: chosen.get(images.join()) ?? 0,
  }));
  const images = imagesOf(model).map((image, i) => ({ ...image, exifOrientation: exif[i]?.orientation ?? null }));
  return {
    partial: false,
    images,
    leftOut: [],
    strayMasks: [],
    strayMarks: [],
    remarks: [],
    cameras: camerasOf(model),
    connections: links,
    groups,
    layout: layoutOf(model.images, exif, links),
    points: pointsOf(model),
    found: null,
    refinement: null,
    byRays: byRays(model),
    oriented: images.filter(({ oriented }) => oriented).length,
    rmsePx: rmseOf(model),
    sigma0Px: null,
    score: null,
    warnings: [],
    formats: export_formats(),
  };
}

function camerasOf({ cameras, images }: Block): ViewCamera[] {
  return cameras.map((camera, i) => {
    const own = images.filter((image) => image.camera === i);
    const calibrated = camera.focal_px !== null && own.some(({ pose }) => pose != null) ? { ...camera, focal_px: camera.focal_px } : null;
    return { label: `${String(camera.width_px)} × ${String(camera.height_px)} px`, images: own.length, given: null, calibrated, focalErrorPx: null };
  });
}

function imagesOf(model: Block): ViewImage[] {
  const rays = model.images.map(() => 0);
  for (const point of model.points) for (const { image } of point.rays) rays[image] = (rays[image] ?? 0) + 1;
  return model.images.map(({ name, camera, pose }, i) => {
    const { width_px: width = 0, height_px: height = 0 } = model.cameras[camera] ?? {};
    return { name, camera, width, height, features: null, places: null, rays: rays[i] ?? 0, rmsePx: null, oriented: pose != null, exifOrientation: null, why: pose == null ? 'not oriented' : '' };
  });
}

function pointsOf({ points }: Block): ViewPoints {
  const none = [NaN, NaN, NaN];
  return {
    count: points.length,
    rays: Uint16Array.from(points, ({ rays }) => rays.length),
    rmsePx: Float64Array.from(points, ({ rmse_px }) => rmse_px ?? NaN),
    positions: Float64Array.from(points.flatMap(({ position }) => position ?? none)),
    errors: Float64Array.from(points.flatMap(() => none)),
    confidence: Float64Array.from(points, ({ confidence }) => confidence ?? NaN),
  };
}

/** Root mean square length of the residuals of all rays; null where points are not adjusted. */
function rmseOf({ points }: Pick<Block, 'points'>): number | null {
  const known = points.filter(({ rmse_px }) => rmse_px != null);
  const rays = known.reduce((sum, point) => sum + point.rays.length, 0);
  const squares = known.reduce((sum, point) => sum + point.rays.length * (point.rmse_px ?? 0) ** 2, 0);
  return rays === 0 ? null : Math.sqrt(squares / rays);
}

/** Points by their number of rays. */
function byRays({ points }: Block): RayCount[] {
  const groups = new Map<number, BlockModel['points']>();
  for (const point of points) groups.set(point.rays.length, [...(groups.get(point.rays.length) ?? []), point]);
  return [...groups].sort(([a], [b]) => a - b).map(([rays, group]) => ({ rays, points: group.length, rmsePx: rmseOf({ points: group }) }));
}

function geometryName(geometry: BlockRun['geometries'][number]): string {
  if (geometry === null) return '';
  const { model: { kind }, sigma_px: sigma, degenerate } = geometry;
  const weak = degenerate === null ? '' : `, ${message('degeneracy', degenerate, 'short')}`;
  return `${message('two_view_model', { kind }, 'short')}${weak}, ± ${sigma.toFixed(2)} px`;
}
