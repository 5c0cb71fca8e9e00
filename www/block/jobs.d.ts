/** The jobs of workers are plain JavaScript; `Jobs` in types.d.ts beside them says what each takes and gives. */
declare module '*/pkg/block/jobs.js' {
  export const jobs: Record<string, (input: never) => Promise<Uint8Array | Uint32Array>>;
}
