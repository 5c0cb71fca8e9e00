/** Parts of the package that its users do not see, plain JavaScript without types beside it. */

/** `Jobs` in pkg/block/types.d.ts says what each job takes and gives. */
declare module '*/pkg/block/jobs.js' {
  export const jobs: Record<string, (input: never) => Promise<Uint8Array | Uint32Array>>;
}

declare module '*/pkg/block/description.js' {
  /** The page asks it for its refusals alone: names of images are enough for that. */
  export function describeBlock(
    images: readonly { name: string; camera: number }[], cameras: readonly object[], useGps: false, placing: object, control: import('../../../pkg/block/index.js').ControlText,
  ): unknown;
}

declare module '*/pkg/block/cameras.js' {
  export function strayRules(names: readonly string[], rulesText?: string): string[];
}

declare module '*/pkg/block/masks.js' {
  export function masksOf(sources: readonly { name: string }[], given: readonly { name: string }[]): unknown;
}

declare module '*/pkg/block/photo.js' {
  export function photoTruth(flight: object): import('../../../pkg/wasm/tiepoint.js').BlockModel;
  export function photoFile(job: { flight: object; index: number }): Uint8Array<ArrayBuffer>;
}
