/** The generated JavaScript of the module, with what a caller does wrong said in words of the package. */

/** As the crate says it, which can say nothing before it is loaded. */
const UNLOADED = 'the module is not loaded: call load(), the default export of tiepoint, and wait for it first';

/** Throws what the crate throws where it refuses an input.  @param {string} error code of it */
const thrown = (error) =>
  `const error = ${error};
        throw Object.assign(new Error(message('error', error)), { name: 'TiepointError', code: 'invalid-input', usage: false, error });`;

/** Pieces of generated code, how often each stands there, and what takes its place. @type {readonly (readonly [string, number, string])[]} */
const PIECES = [
  [
    'let wasmModule, wasmInstance, wasm;',
    1,
    `const unloaded = new Proxy({}, { get() {
    throw Object.assign(new Error('${UNLOADED}'), { name: 'TiepointError', code: 'not-loaded', usage: false, error: { kind: 'not-loaded' } });
} });\nlet wasmModule, wasmInstance, wasm = unloaded;`,
  ],
  ['if (wasm !== undefined) return wasm;', 2, 'if (wasm !== unloaded) return wasm;'],
  [
    // Refused as the crate refuses a value of another type.
    `throw new Error(\`expected instance of \${klass.name}\`);`,
    1,
    `const got = instance?.constructor?.name ?? (instance === null ? 'null' : typeof instance);
        ${thrown("{ kind: 'invalid-argument', what: 'argument', got, wanted: klass.name }")}`,
  ],
  [
    'throw new Error(getStringFromWasm0(arg0, arg1));',
    1,
    `const words = getStringFromWasm0(arg0, arg1);
        if (words !== 'null pointer passed to rust') throw new Error(words);
        ${thrown("{ kind: 'invalid-input', refusal: { kind: 'freed_object' } }")}`,
  ],
];

/** @param {string} code as the binding generator writes it @returns {string} */
export function explained(code) {
  const made = PIECES.reduce((made, [piece, times, other]) => {
    check(piece, made.split(piece).length - 1, times);
    return made.replaceAll(piece, () => other);
  }, code);
  return freedOnce(made);
}

/**
 * The types with arguments that may be left out where all behind them may: the generator asks for `undefined` in their place.
 * @param {string} types as the generator writes them @returns {string}
 */
export function withOptional(types) {
  const made = types.replaceAll(/(\w+): ([^,():]+) \| undefined(, \w+\?: )/g, '$1?: $2$3');
  return made === types ? made : withOptional(made);
}

/** @param {string} piece @param {number} found @param {number} times */
function check(piece, found, times) {
  if (found !== times) throw new Error(`the generated JavaScript has "${piece}" ${found} times; ${times} were expected: see tools/lib/glue.mjs`);
}

/** An object that is disposed of again, or that was moved into another one, has nothing left to free.  @param {string} code */
function freedOnce(code) {
  const call = / (?=wasm\.__wbg_\w+_free\(ptr, 0\);)/g;
  check('wasm.…_free(ptr, 0)', code.match(call)?.length ?? 0, code.split('\n    free() {').length - 1);
  return code.replaceAll(call, ' if (ptr !== 0) ');
}
