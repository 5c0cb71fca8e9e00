/** Footprints, ground sample distances and recorded positions of an oriented block, in its worker. */
import { local_positions } from '../../../pkg/wasm/tiepoint.js';
import type { BlockModel, Camera, FinishedBlock, Pose } from '../../../pkg/wasm/tiepoint.js';
import { median } from '../state/ground';
import type { ViewGround } from '../state/ground';

/** A corner that lies farther away than so many times the height above ground is not drawn: its ray hardly goes down. */
const FARTHEST = 12;

export function groundOf(block: FinishedBlock): ViewGround {
  const model = block.model();
  const heights = heightsOf(model);
  const depths = depthsOf(model);
  const count = model.images.length;
  const footprints = new Float64Array(8 * count).fill(NaN);
  const gsd = new Float64Array(count).fill(NaN);
  model.images.forEach(({ camera: index, pose }, i) => {
    const camera = model.cameras[index];
    if (pose == null || camera === undefined) return;
    footprints.set(footprintOf(camera, pose, heights[i] ?? NaN), 8 * i);
    gsd[i] = (depths[i] ?? NaN) / camera.focal_px;
  });
  return { footprints, gsd, gnss: gnssOf(block, model), origin: model.origin ?? null };
}

/** Of each image the median height of the points that it shows; where it shows none that of all. */
function heightsOf({ images, points }: BlockModel): Float64Array {
  const own: number[][] = images.map(() => []);
  const all: number[] = [];
  for (const { position, rays } of points) {
    if (position == null) continue;
    all.push(position[2]);
    for (const { image } of rays) own[image]?.push(position[2]);
  }
  const usual = median(all);
  return Float64Array.from(own, (heights) => (heights.length === 0 ? usual : median(heights)));
}

/** Of each image the median distance along its axis to the points that it shows: its height above them where it looks straight down. */
function depthsOf({ images, points }: BlockModel): Float64Array {
  const own: number[][] = images.map(() => []);
  for (const { position, rays } of points) {
    if (position == null) continue;
    for (const { image } of rays) {
      const pose = images[image]?.pose;
      if (pose != null) own[image]?.push(Math.abs(depthOf(pose, position)));
    }
  }
  return Float64Array.from(own, median);
}

function depthOf({ rotation, position: centre }: Pose, position: Pose['position']): number {
  return rotation[2].reduce((sum, value, axis) => sum + value * ((position[axis] ?? 0) - (centre[axis] ?? 0)), 0);
}

/** The corners of an image on the level plane at a height, its distortion left aside; all NaN where one of them does not meet the plane. */
function footprintOf(
  { width_px: width, height_px: height, focal_px: focal, principal_point_px: [cx, cy] }: Camera,
  { rotation, position }: Pose,
  ground: number,
): number[] {
  const corners: readonly (readonly [number, number])[] = [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ];
  const places = corners.flatMap(([column, row]) => {
    const photo = [column - cx, cy - row, -focal];
    const ray = [0, 1, 2].map((axis) => rotation.reduce((sum, line, i) => sum + (line[axis] ?? 0) * (photo[i] ?? 0), 0));
    const [x = 0, y = 0, z = 0] = ray;
    const along = (ground - position[2]) / z;
    const isNear = along > 0 && Math.hypot(x, y) < FARTHEST * Math.abs(z);
    return isNear ? [position[0] + along * x, position[1] + along * y] : [NaN, NaN];
  });
  return places.some(Number.isNaN) ? places.map(() => NaN) : places;
}

/** Recorded positions from the origin of the block. */
function gnssOf(block: FinishedBlock, { origin, images }: BlockModel): Float64Array {
  if (origin == null) return new Float64Array(3 * images.length).fill(NaN);
  const recorded = block
    .overview()
    .images.flatMap(({ gnss }) => (gnss === null ? [NaN, NaN, NaN] : [gnss.longitude_deg, gnss.latitude_deg, gnss.height_m ?? NaN]));
  return local_positions(Float64Array.from([origin.longitude_deg, origin.latitude_deg, origin.height_m, ...recorded])).subarray(3);
}
