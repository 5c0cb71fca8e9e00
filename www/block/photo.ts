/** Photos of a simulated block, taken one at a time and written as image files. */
import { BlockScene } from '../../pkg/wasm/tiepoint.js';
import type { BlockFlight } from '../../pkg/wasm/tiepoint.js';
import type { FlightPlan, MadeFile } from './calls';

/** The scene of the flight that was photographed last: building it takes longer than a photo. */
let built: { key: string; scene: BlockScene } | null = null;

function sceneOf(flight: BlockFlight): BlockScene {
  const key = JSON.stringify(flight);
  if (built?.key !== key) {
    built?.scene.free();
    built = null;
    built = { key, scene: new BlockScene(flight) };
  }
  return built.scene;
}

/** How many photos a flight takes, and its cameras. */
export function blockPlan(flight: BlockFlight): FlightPlan {
  const scene = sceneOf(flight);
  const { cameras, images } = scene.truth();
  const rules = images.map(({ camera }, index) => ({ images: nameOf(index), focal_px: cameras[camera]?.focal_px, pixel_mm: cameras[camera]?.pixel_mm }));
  const one = cameras.length === 1 ? rules.slice(0, 1).map((rule) => ({ ...rule, images: '*' })) : rules;
  return { photos: scene.photos, cameras: JSON.stringify({ cameras: one }) };
}

export function blockPhoto({ flight, index }: { flight: BlockFlight; index: number }): MadeFile {
  const { width, height, grey } = sceneOf(flight).photo(index);
  const header = new TextEncoder().encode(`P5\n${String(width)} ${String(height)}\n255\n`);
  const bytes = new Uint8Array(header.length + grey.length);
  bytes.set(header);
  bytes.set(grey, header.length);
  return { name: nameOf(index), type: 'image/x-portable-graymap', bytes };
}

function nameOf(index: number): string {
  return `photo_${String(index).padStart(5, '0')}.pgm`;
}
