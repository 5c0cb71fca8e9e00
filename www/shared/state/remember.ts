/** Remembers the last result of a function of a few arguments, compared by identity. */
export function remember<A extends readonly unknown[], R>(compute: (...args: A) => R): (...args: A) => R {
  let last: { args: A; result: R } | null = null;
  return (...args) => {
    if (last === null || last.args.some((arg, i) => !Object.is(arg, args[i]))) last = { args, result: compute(...args) };
    return last.result;
  };
}
