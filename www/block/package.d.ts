/** Parts of the package that workers alone take, plain JavaScript without types beside it. */

/** `Jobs` in pkg/block/types.d.ts says what each job takes and gives. */
declare module '*/pkg/block/jobs.js' {
  export const jobs: Record<string, (input: never) => Promise<Uint8Array | Uint32Array>>;
}

declare module '*/pkg/block/photo.js' {
  export function photoTruth(flight: object): import('../../pkg/wasm/tiepoint.js').BlockModel;
  export function photoFile(flight: object, index: number, deflate: (bytes: Uint8Array) => Uint8Array): Uint8Array<ArrayBuffer>;
}
