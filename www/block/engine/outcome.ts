/** What of a block, finished or under way, the page shows. */
import { knownCamera } from '../../../pkg/block/index.js';
import type { BlockRun, GroupedCamera, ReadImage } from '../../../pkg/block/index.js';
import { connected_groups, export_formats, message } from '../../../pkg/wasm/tiepoint.js';
import type { Connection, FinishedBlock, PairRow } from '../../../pkg/wasm/tiepoint.js';
import { layoutOf } from './layout';
import type { BlockView, ViewConnection } from '../state/view';

export function viewOf(block: FinishedBlock): BlockView {
  const { images, skipped, unused_masks, unknown_images, remarks, cameras, pairs, groups, found, refinement, by_rays, oriented, rmse_px, sigma0_px, warnings, points } = block.overview();
  const connections = pairs.map(connectionOf);
  return {
    partial: false,
    images: images.map(({ name, width_px: width, height_px: height, camera, features, positions: places, observations: rays, rmse_px: rmsePx, is_oriented, exif_orientation: exifOrientation, reason: why }) => (
      { name, width, height, camera, features, places, rays, rmsePx, oriented: is_oriented, exifOrientation, why })),
    leftOut: skipped,
    strayMasks: unused_masks,
    strayMarks: unknown_images,
    remarks,
    cameras: cameras.map(({ label, images: count, given, calibrated, focal_error_px: focalErrorPx }) => ({ label, images: count, given, calibrated, focalErrorPx })),
    connections,
    groups,
    layout: layoutOf(images.map(({ position }) => position), images.map(({ gnss }) => gnss), connections),
    points: { count: points.rays.length, rays: points.rays, rmsePx: points.rmse_px, positions: points.positions, errors: points.errors, confidence: points.confidence },
    found,
    refinement,
    byRays: by_rays.map(({ rays, points: count, rmse_px: rmsePx }) => ({ rays, points: count, rmsePx })),
    oriented,
    rmsePx: rmse_px,
    sigma0Px: sigma0_px,
    score: null,
    warnings,
    formats: export_formats(),
  };
}

/** A block whose points are not made yet. */
export function viewOfParts(
  read: readonly ReadImage[], cameras: readonly GroupedCamera[], of: readonly number[], connections: readonly Connection[], geometries: BlockRun['geometries'],
): BlockView {
  const links: ViewConnection[] = connections.map((connection, i) => (
    { ...connection, reason: message('connection', connection), geometry: geometryName(geometries[i] ?? null), shared: 0, chosen: 0 }));
  const none = new Float64Array();
  return {
    partial: true,
    images: read.map(({ name, head, count }, i) => (
      { name, width: head.width, height: head.height, camera: of[i] ?? 0, features: count, places: null, rays: 0, rmsePx: null, oriented: false, exifOrientation: head.exif.orientation, why: 'not oriented yet' })),
    leftOut: [],
    strayMasks: [],
    strayMarks: [],
    remarks: [],
    cameras: cameras.map((camera, i) => ({ label: camera.label, images: of.filter((own) => own === i).length, given: knownCamera(camera), calibrated: null, focalErrorPx: null })),
    connections: links,
    groups: connected_groups(read.length, [...connections]),
    layout: layoutOf(read.map(() => null), read.map(({ head }) => head.exif.position), links),
    points: { count: 0, rays: new Uint16Array(), rmsePx: none, positions: none, errors: none, confidence: none },
    found: null,
    refinement: null,
    byRays: [],
    oriented: 0,
    rmsePx: null,
    sigma0Px: null,
    score: null,
    warnings: [],
    formats: export_formats(),
  };
}

function connectionOf({ images, rule, outcome, reason, geometry, common_points: shared, chosen_points: chosen }: PairRow): ViewConnection {
  return { images, rule, outcome, reason, geometry: geometryName(geometry), shared, chosen };
}

function geometryName(geometry: BlockRun['geometries'][number]): string {
  if (geometry === null) return '';
  const { model: { kind }, sigma_px: sigma, degenerate } = geometry;
  const weak = degenerate === null ? '' : `, ${message('degeneracy', degenerate, 'short')}`;
  return `${message('two_view_model', { kind }, 'short')}${weak}, ± ${sigma.toFixed(2)} px`;
}
