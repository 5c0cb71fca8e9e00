// @ts-check
/** The files of a block: its project, its tables, its summary, and what other programs read. */

import { connected_groups, csv_field, export_block, message, write_project } from '../wasm/tiepoint.js';
import { withText } from '../messages.js';
import { refinementSummary, withOutcomes } from './refinement-table.js';

/**
 * @typedef {import('./types.js').BlockRun} BlockRun
 * @typedef {import('../wasm/tiepoint.js').ExportFormat} ExportFormat
 * @typedef {(path: string, text: string) => void} Write takes a path with slashes, relative to the folder of the block
 */

export const PROJECT_FILE = 'project.tiepoint';

export const FIXED_FILES = [PROJECT_FILE, 'images.csv', 'points.csv', 'rays.csv', 'orientation.json', 'pairs.csv', 'summary.json'];

/**
 * Writes everything. A format that this block cannot be written in is told, and the others are written.
 * @param {BlockRun} run @param {readonly ExportFormat[]} formats @param {Write} write @param {object} [beside] what the summary holds beside the run
 * @returns {object} the summary
 */
export function writeBlock(run, formats, write, beside = {}) {
  const steps = writing(run, formats, write, beside);
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

/**
 * As `writeBlock`, in steps of about one file, between which the caller may do otherwise or break off.
 * @param {BlockRun} run @param {readonly ExportFormat[]} formats @param {Write} write @param {object} [beside]
 * @returns {Generator<void, object, void>}
 */
export function* writing(run, formats, write, beside = {}) {
  write(PROJECT_FILE, write_project(run.project));
  yield;
  const groups = connected_groups(run.images.length, run.connections);
  export_block(run.model, 'csv', (path, text) => write(path, path === 'images.csv' ? withFacts(run, text) : path === 'rays.csv' && run.refinement ? withOutcomes(run.refinement, text) : text));
  if (run.reconstruction) write('orientation.json', `${JSON.stringify(run.reconstruction)}\n`);
  write('pairs.csv', pairTable(run));
  /** @type {{ format: ExportFormat, refused: string | null }[]} */
  const exports = [];
  for (const format of formats) {
    yield;
    exports.push({ format, refused: writeFormat(run, format, write) });
  }
  const summary = { ...summaryOf(run, groups, exports), ...beside };
  write('summary.json', `${JSON.stringify(summary, null, 2)}\n`);
  return summary;
}

/** Why a format was refused; null where it was written.  @param {BlockRun} run @param {ExportFormat} format @param {Write} write */
function writeFormat(run, format, write) {
  try {
    export_block(run.model, format, (path, text) => write(`${format}/${path}`, text));
    return null;
  } catch (error) {
    if (error instanceof Error && error.name === 'TiepointError') return error.message;
    throw error;
  }
}

/** The crate's table of images with what only the run knows.  @param {BlockRun} run @param {string} table */
function withFacts(run, table) {
  const [header = '', ...lines] = table.trimEnd().split('\n');
  // As texts number them.
  const models = new Map((run.reconstruction?.models ?? []).flatMap(({ images }, model) => images.map((image) => [image, model + 1])));
  const facts = run.images.map(({ features, exif }, index) => {
    const { longitude_deg = '', latitude_deg = '', height_m = '' } = exif.position ?? {};
    return [models.get(index) ?? '', features, run.selection.raysOfImages[index], run.selection.placesOfImages[index], exif.orientation ?? '', longitude_deg, latitude_deg, height_m ?? ''];
  });
  const columns = 'model,features,rays,places,exif_orientation,recorded_longitude_deg,recorded_latitude_deg,recorded_height_m';
  return [`${header},${columns}`, ...lines.map((line, index) => [line, ...(facts[index] ?? [])].join(',')), ''].join('\n');
}

/** @param {BlockRun} run */
function pairTable({ images, connections, geometries, points, model }) {
  /** @type {Map<string, number>} */
  const common = new Map();
  for (let i = 0; i < points.shared.length; i += 3) common.set(points.shared.slice(i, i + 2).join(), points.shared[i + 2] ?? 0);
  const chosen = chosenOf(model);
  const rows = connections.map((connection, index) => {
    const { images: [a, b], rule, outcome } = connection;
    const geometry = geometries[index];
    const matches = 'matches' in outcome ? outcome.matches : '';
    const names = [a, b].map((image) => csv_field(images[image]?.name ?? ''));
    const facts = [geometry?.model.kind ?? '', geometry?.degenerate ?? '', geometry?.sigma_px ?? '', common.get([a, b].join()) ?? 0, chosen.get([a, b].join()) ?? 0];
    return [a, b, ...names, rule, outcome.kind, matches, ...facts, csv_field(message('connection', connection))].join(',');
  });
  return ['first,second,first_name,second_name,rule,outcome,matches,geometry,degenerate,sigma_px,common_points,chosen_points,reason', ...rows, ''].join('\n');
}

/** How many points of a block both images of a pair see, by both their numbers.  @param {Pick<import('../wasm/tiepoint.js').BlockModel, 'points'>} model */
export function chosenOf({ points }) {
  /** @type {Map<string, number>} */
  const seen = new Map();
  for (const { rays } of points) {
    const images = rays.map(({ image }) => image).sort((a, b) => a - b);
    images.forEach((a, i) => {
      for (const b of images.slice(i + 1)) seen.set([a, b].join(), (seen.get([a, b].join()) ?? 0) + 1);
    });
  }
  return seen;
}

/**
 * @param {BlockRun} run @param {number[][]} groups @param {{ format: ExportFormat, refused: string | null }[]} exports
 */
function summaryOf(run, groups, exports) {
  const { images, leftOut, strayMasks, strayMarks, remarks, cameras, connections, points, selection, model } = run;
  const oriented = model.images.flatMap(({ pose }, image) => (pose ? [image] : []));
  // Images that are not oriented have no rays in a model that has others.
  const fewest = (/** @type {number[]} */ counts) => least(oriented.length > 0 ? oriented.map((image) => counts[image] ?? 0) : counts);
  const kinds = ['connected', 'too_few_matches', 'not_oriented', 'failed'];
  return {
    images: { read: images.length, left_out: leftOut, masked: images.filter(({ masked }) => masked).length, stray_masks: strayMasks, stray_marks: strayMarks, features: images.reduce((sum, { features }) => sum + features, 0) },
    remarks,
    cameras: cameras.map((camera, index) => ({ ...camera, images: images.filter((image) => image.camera === index).length })),
    pairs: {
      tried: connections.length,
      ...Object.fromEntries(kinds.map((kind) => [kind, connections.filter(({ outcome }) => outcome.kind === kind).length])),
      matches: connections.reduce((sum, { outcome }) => sum + (outcome.kind === 'connected' ? outcome.matches : 0), 0),
    },
    groups: groups.map((group) => group.map((image) => images[image]?.name)),
    points: { found: points.count, rays: points.rays, with_rays: withRays(points.histogram), joining: points.join },
    selection: { points: selection.points, rays: selection.raysOfImages.reduce((a, b) => a + b, 0), least_rays_of_an_image: fewest(selection.raysOfImages), least_places_of_an_image: fewest(selection.placesOfImages) },
    refinement: refinementSummary(run),
    orientation: orientationOf(run),
    exports,
    settings: run.settings,
  };
}

/** @param {BlockRun} run */
function orientationOf({ reconstruction, reconstructionReason, images, model }) {
  if (!reconstruction) return { oriented: 0, reason: reconstructionReason };
  const poses = model.images.filter(({ pose }) => pose).length;
  return {
    oriented: poses,
    points: model.points.length,
    rays: model.points.reduce((sum, { rays }) => sum + rays.length, 0),
    models: reconstruction.models.map(({ images: own, adjusted, rejected, in_system, warnings }) => ({
      images: own.length, names: own.map((image) => images[image]?.name), in_system, datum: adjusted.datum, sigma0_px: adjusted.sigma0_px, rmse_px: adjusted.rmse_px, rmse_by_rays: adjusted.rmse_by_rays,
      degrees_of_freedom: adjusted.degrees_of_freedom,
      rays_rejected: rejected.length + adjusted.rays.filter(({ verdict }) => verdict !== 'accepted').length,
      position_rmse_m: rootMeanSquare(adjusted.images.flatMap(({ gnss }) => (gnss?.accepted ? [gnss.residual] : []))), warnings: warnings.map((warning) => withText('block_warning', warning)),
    })),
    cameras: model.cameras,
    unoriented: reconstruction.unoriented.map(({ image, reason }) => ({ name: images[image]?.name, reason: withText('unoriented', reason) })),
    origin: model.origin ?? null,
  };
}

/** Of each coordinate; null without any.  @param {number[][]} residuals */
function rootMeanSquare(residuals) {
  if (residuals.length === 0) return null;
  return [0, 1, 2].map((axis) => Math.sqrt(residuals.reduce((sum, residual) => sum + (residual[axis] ?? 0) ** 2, 0) / residuals.length));
}

/** @param {number[]} histogram */
const withRays = (histogram) => Object.fromEntries(histogram.map((points, rays) => [rays, points]).filter(([, points]) => points !== 0));

/** @param {number[]} values */
const least = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);
