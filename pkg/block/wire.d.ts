/**
 * An error as plain data, which passes between workers whole: a copy of an `Error` is called `Error` on the other side, and has neither
 * `code` nor `usage`.
 */
export interface PlainError {
  name: string;
  message: string;
  /** Of a `TiepointError`, as of the next ones. */
  code?: string;
  usage?: boolean;
  /** Its figures, as `message('error', …)` takes them. */
  error?: { kind: string };
}

/** What a job threw, for `postMessage`. What is no error becomes one with its text as the message. */
export function plainError(thrown: unknown): PlainError;

/** The error that `plainError` was given, with another stack, for `Pool.run` to reject with. */
export function errorOf(plain: PlainError): Error;
