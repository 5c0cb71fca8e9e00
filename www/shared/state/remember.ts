/** Remembers the last result of a function of a few arguments, compared by identity. */
export function remember<A extends readonly unknown[], R>(compute: (...args: A) => R): (...args: A) => R {
  let last: { args: A; result: R } | null = null;
  return (...args) => {
    if (last === null || last.args.some((arg, i) => !Object.is(arg, args[i]))) last = { args, result: compute(...args) };
    return last.result;
  };
}

/** As `remember`; while the codes are the same, so is their array, so that nothing is drawn anew for them. */
export function rememberCodes<A extends readonly unknown[]>(compute: (...args: A) => Uint8Array): (...args: A) => Uint8Array {
  let last: Uint8Array = new Uint8Array();
  return remember((...args: A) => {
    const codes = compute(...args);
    if (codes.length !== last.length || codes.some((code, i) => code !== last[i])) last = codes;
    return last;
  });
}
