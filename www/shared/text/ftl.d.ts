/** A catalogue of texts, as it is written. */
declare module '*.ftl?raw' {
  const text: string;
  export default text;
}
