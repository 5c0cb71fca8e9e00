/** The libraries of types that the module's own types name, for programs that are checked without them. */
/// <reference lib="es2022" />
/// <reference lib="esnext.disposable" />
/// <reference lib="dom" />
