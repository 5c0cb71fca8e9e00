/** What of a block, finished or under way, the page shows. */
import { connected_groups, export_formats } from '../../../pkg/wasm/tiepoint.js';
import { message } from '../../shared/text/messages';
import type { Connection, FinishedBlock, PairRow, ReadImage, TwoView } from '../../../pkg/wasm/tiepoint.js';
import { layoutOf } from './layout';
import { codeOfSource } from '../state/edits';
import type { BlockView, ViewConnection, ViewGeometry } from '../state/view';

export function viewOf(block: FinishedBlock): BlockView {
  const onOrthophoto = block.on_orthophoto();
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
    verdict,
    components,
    checks,
    surveyed,
    given_control: givenControl,
    origin,
    crs,
    geoid_m,
    geoid,
    points,
  } = block.overview();
  const connections = pairs.map(connectionOf);
  const ids = block.point_ids();
  // Surveyed points stand in the order of the points.
  const added = new Set(block.edits().flatMap((edit) => (edit.kind === 'add_control' ? [edit.name] : [])));
  const controls = ids.flatMap((id, point) => ('ground_control' in id ? [{ control: id.ground_control, point }] : []));
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
        position,
        exif_orientation: exifOrientation,
        reason: why,
      }) => ({
        name,
        width,
        height,
        camera,
        features,
        places,
        rays,
        rmsePx,
        oriented: is_oriented,
        position,
        exifOrientation,
        why: why === null ? '' : message('image_reason', why),
      }),
    ),
    leftOut: skipped.map(({ name, reason }) => ({ name, reason: message('failure', reason) })),
    strayMasks: unused_masks,
    strayMarks: unknown_images,
    remarks: remarks.map((remark) => message('remark', remark)),
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
      taking: points.rays.length,
      lost: new Set(),
      sources: Float64Array.from(ids, codeOfSource),
      numbers: points.numbers,
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
    verdict: { kind: verdict.kind, text: message('block_verdict', verdict) },
    orthophoto:
      onOrthophoto === null
        ? null
        : {
            kind: onOrthophoto.kind,
            inCrs: onOrthophoto.kind !== 'not_linked' && onOrthophoto.in_crs === true,
            text: message('on_orthophoto', onOrthophoto),
          },
    origin,
    crs,
    system: remarks.find((remark) => remark.kind === 'result_system')?.crs ?? null,
    geoidM: geoid_m,
    geoid,
    rmsePx: rmse_px,
    sigma0Px: sigma0_px,
    components,
    checks,
    surveyed: surveyed.map((known, i) => ({
      ...known,
      ...(controls[i] ?? { control: -1, point: -1 }),
      isUsed: known.refused?.is_used ?? true,
      byHand: added.has(known.name),
    })),
    givenControl,
    score: null,
    warnings: warnings.map((warning) => message('overview_warning', warning)),
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
    geometry: geometryOf(geometries[i] ?? null),
    shared: 0,
    chosen: 0,
    rejected: false,
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
      position: null,
      exifOrientation: exif.orientation,
      why: null,
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
      read.map(({ exif, given }) => given?.position ?? exif.position),
      links,
    ),
    points: {
      count: 0,
      taking: 0,
      lost: new Set(),
      sources: none,
      numbers: new Uint32Array(),
      rays: new Uint16Array(),
      rmsePx: none,
      positions: none,
      errors: none,
      confidence: none,
    },
    found: null,
    refinement: null,
    byRays: [],
    oriented: 0,
    verdict: null,
    orthophoto: null,
    origin: null,
    crs: null,
    geoidM: null,
    rmsePx: null,
    sigma0Px: null,
    components: [],
    checks: null,
    surveyed: [],
    givenControl: 0,
    score: null,
    warnings: [],
    formats: export_formats(),
  };
}

function connectionOf({ images, rule, outcome, geometry, common_points: shared, chosen_points: chosen, rejected_by_hand: rejected }: PairRow): ViewConnection {
  return { images, rule, outcome, reason: message('connection', { images, rule, outcome }), geometry: geometryOf(geometry), shared, chosen, rejected };
}

function geometryOf(geometry: TwoView | null): ViewGeometry | null {
  if (geometry === null) return null;
  const { model, degenerate, sigma_px: sigmaPx } = geometry;
  return { kind: model.kind, degenerate, sigmaPx };
}
