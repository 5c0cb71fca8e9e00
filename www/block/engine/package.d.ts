/** Parts of the package that its users do not see, plain JavaScript without types beside it. */

declare module '*/pkg/block/photo.js' {
  export function photoTruth(flight: object): import('../../../pkg/wasm/tiepoint.js').BlockModel;
  export function photoFile(job: { flight: object; index: number }): Uint8Array<ArrayBuffer>;
}
