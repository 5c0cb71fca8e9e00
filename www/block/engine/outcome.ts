/** What of a block, finished or under way, the page shows. */
import { connected_groups, export_formats, message } from '../../../pkg/wasm/tiepoint.js';
import type { Connection, FinishedBlock, PairRow, ReadImage, TwoView } from '../../../pkg/wasm/tiepoint.js';
import { page } from '../../shared/text/words';
import { layoutOf } from './layout';
import type { BlockView, ViewConnection } from '../state/view';

export function viewOf(block: FinishedBlock): BlockView {
  const {
    images,
    skipped,
    unused_masks,
    unknown_images,
    remarks,
    cameras,
    pairs,
    groups,
    found,
    refinement,
    by_rays,
    oriented,
    rmse_px,
    sigma0_px,
    warnings,
    verdict: { kind, text },
    checks,
    points,
  } = block.overview();
  const connections = pairs.map(connectionOf);
  return {
    partial: false,
    images: images.map(
      ({
        name,
        width_px: width,
        height_px: height,
        camera,
        features,
        positions: places,
        observations: rays,
        rmse_px: rmsePx,
        is_oriented,
        exif_orientation: exifOrientation,
        reason: why,
      }) => ({ name, width, height, camera, features, places, rays, rmsePx, oriented: is_oriented, exifOrientation, why: why?.text ?? '' }),
    ),
    leftOut: skipped.map(({ name, reason }) => ({ name, reason: reason.text })),
    strayMasks: unused_masks,
    strayMarks: unknown_images,
    remarks: remarks.map(({ text }) => text),
    cameras: cameras.map(({ label, images: count, given, calibrated, focal_error_px: focalErrorPx }) => ({
      label,
      images: count,
      given,
      calibrated,
      focalErrorPx,
    })),
    connections,
    groups,
    layout: layoutOf(
      images.map(({ position }) => position),
      images.map(({ gnss }) => gnss),
      connections,
    ),
    points: {
      count: points.rays.length,
      rays: points.rays,
      rmsePx: points.rmse_px,
      positions: points.positions,
      errors: points.errors,
      confidence: points.confidence,
    },
    found,
    refinement,
    byRays: by_rays.map(({ rays, points: count, rmse_px: rmsePx }) => ({ rays, points: count, rmsePx })),
    oriented,
    verdict: { kind, text },
    rmsePx: rmse_px,
    sigma0Px: sigma0_px,
    checks,
    score: null,
    warnings: warnings.map(({ text }) => text),
    formats: export_formats(),
  };
}

/** A block whose points are not made yet. */
export function viewOfParts(read: readonly ReadImage[], connections: readonly Connection[], geometries: readonly (TwoView | null)[]): BlockView {
  // Images of one camera say the same of it.
  const own = read.map(({ camera }) => JSON.stringify(camera));
  const kinds = [...new Set(own)];
  const cameras = kinds.map((kind) => read[own.indexOf(kind)]?.camera).filter((camera) => camera !== undefined);
  const links: ViewConnection[] = connections.map((connection, i) => ({
    ...connection,
    reason: message('connection', connection),
    geometry: geometryName(geometries[i] ?? null),
    shared: 0,
    chosen: 0,
  }));
  const none = new Float64Array();
  return {
    partial: true,
    images: read.map(({ name, width_px: width, height_px: height, features, exif }, i) => ({
      name,
      width,
      height,
      camera: kinds.indexOf(own[i] ?? ''),
      features,
      places: null,
      rays: 0,
      rmsePx: null,
      oriented: false,
      exifOrientation: exif.orientation,
      why: 'not oriented yet',
    })),
    leftOut: [],
    strayMasks: [],
    strayMarks: [],
    remarks: [],
    cameras: cameras.map(({ label, fixed: _, focal_px, ...camera }, i) => ({
      label,
      images: own.filter((kind) => kind === kinds[i]).length,
      given: focal_px === null ? null : { ...camera, focal_px },
      calibrated: null,
      focalErrorPx: null,
    })),
    connections: links,
    groups: connected_groups(read.length, [...connections]),
    layout: layoutOf(
      read.map(() => null),
      read.map(({ exif }) => exif.position),
      links,
    ),
    points: { count: 0, rays: new Uint16Array(), rmsePx: none, positions: none, errors: none, confidence: none },
    found: null,
    refinement: null,
    byRays: [],
    oriented: 0,
    verdict: null,
    rmsePx: null,
    sigma0Px: null,
    checks: null,
    score: null,
    warnings: [],
    formats: export_formats(),
  };
}

function connectionOf({ images, rule, outcome, reason, geometry, common_points: shared, chosen_points: chosen }: PairRow): ViewConnection {
  return { images, rule, outcome, reason, geometry: geometryName(geometry), shared, chosen };
}

function geometryName(geometry: TwoView | null): string {
  if (geometry === null) return '';
  const {
    model: { kind },
    sigma_px: sigma,
    degenerate,
  } = geometry;
  const weak = degenerate === null ? null : message('degeneracy', degenerate, 'short');
  return page('geometry', { model: message('two_view_model', { kind }, 'short'), weak, sigma_px: sigma });
}
