/** What the adjustment of a block says of its images, cameras and points, laid over what the page shows of it. */
import type { ReconstructedModel, Reconstruction } from '../../../pkg/wasm/tiepoint.js';
import { message } from '../../../pkg/wasm/tiepoint.js';
import type { BlockView, ViewImage } from '../state/view';

/** `reason`: why there is no model at all; null where there is one. */
export function withReconstruction(view: BlockView, reconstruction: Reconstruction | null, reason: string | null): BlockView {
  const why = (images: readonly ViewImage[], of: (index: number) => string) => images.map((image, i) => (image.oriented ? image : { ...image, why: of(i) }));
  const [model, ...others] = reconstruction?.models ?? [];
  const unoriented = new Map(reconstruction?.unoriented.map(({ image, reason: own }) => [image, message('unoriented', own)]));
  const apart = (index: number) => others.find(({ images }) => images.includes(index))?.images.length;
  const whyNot = (index: number) => {
    const size = apart(index);
    return size === undefined ? (unoriented.get(index) ?? reason ?? 'not oriented') : `in a model of its own, of ${String(size)} images`;
  };
  const told = { ...view, images: why(view.images, whyNot) };
  if (model === undefined) return { ...told, warnings: [reason === null ? 'No image could be oriented.' : `No image could be oriented: ${reason}.`] };
  return withModel({ ...told, warnings: [...model.warnings.map((warning) => message('block_warning', warning)), ...others.map(({ images }) => `${String(images.length)} images are oriented apart from the others, in a model of their own.`)] }, model);
}

function withModel(view: BlockView, { adjusted, images, cameras }: ReconstructedModel): BlockView {
  const statistics = new Map(images.map((image, i) => [image, adjusted.images[i]]));
  const errors = new Map(cameras.map((camera, i) => [camera, adjusted.cameras[i]?.standard_errors[0] ?? null]));
  // The exchanged block leaves out the points without accepted rays.
  const points = adjusted.points.filter((point) => point !== null);
  return {
    ...view,
    images: view.images.map((image, i) => {
      const own = statistics.get(i);
      return own === undefined ? image : { ...image, rays: own.rays, rmsePx: own.rays > 0 ? own.rmse_px : null };
    }),
    cameras: view.cameras.map((camera, i) => ({ ...camera, focalErrorPx: errors.get(i) ?? null })),
    points: points.length === view.points.count
      ? { ...view.points, errors: Float64Array.from(points.flatMap(({ errors: of }) => of ?? [NaN, NaN, NaN])) }
      : view.points,
    byRays: adjusted.rmse_by_rays.map(({ rays, points: count, rmse_px: rmsePx }) => ({ rays, points: count, rmsePx })),
    rmsePx: adjusted.rmse_px,
    sigma0Px: adjusted.sigma0_px,
  };
}
