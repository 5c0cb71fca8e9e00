/**
 * The parts of the page as one script, for the page in one file, which can load nothing: each part becomes a function of the script that starts the
 * page, and what was its import calls that function. It relies on how Vite writes a part: imports in its first lines, each on a line of its own, and
 * one export at its end.
 */

/** A line that imports names of another part. */
const IMPORT = /^import \{ (.*) \} from "\.\/([\w.-]+)";\n/;
const EXPORT = /\nexport \{ (.*) \};\s*$/;

/** The function that a part becomes.  @param {string} file */
const called = (file) => `part$${file.replace(/\.js$/, '').replaceAll('-', '_')}`;

/** Names of an import or export as those of an object.  @param {string} names @param {boolean} given */
const fields = (names, given) =>
  names
    .split(', ')
    .map((name) => name.split(' as '))
    .map(([own = '', other = own]) => (own === other ? own : given ? `${other}: ${own}` : `${own}: ${other}`))
    .join(', ');

/**
 * What a part takes from others, does, and gives.
 * @param {string} file @param {string} code @returns {{ takes: [names: string, from: string][], does: string, gives: string }}
 */
function read(file, code) {
  /** @type {[string, string][]} */
  const takes = [];
  let rest = code;
  for (let found = IMPORT.exec(rest); found !== null; found = IMPORT.exec(rest)) {
    takes.push([found[1] ?? '', found[2] ?? '']);
    rest = rest.slice(found[0].length);
  }
  const gives = EXPORT.exec(rest)?.[1] ?? '';
  const does = rest.replace(EXPORT, '\n').replaceAll(/\bimport\("\.\/([\w.-]+)"\)/g, (_, part) => `${called(part)}()`);
  if (/^(?:import|export)\b/m.test(does)) throw new Error(`${file} is not written as the page in one file needs it`);
  return { takes, does, gives };
}

/** @param {string} start the script that starts the page @param {readonly string[]} parts @param {(file: string) => string} text @returns {string} */
export function joined(start, parts, text) {
  const first = read(start, text(start));
  const made = parts.map((file) => {
    const { takes, does, gives } = read(file, text(file));
    const taken = takes.map(([names, from]) => `const { ${fields(names, false)} } = ${from === start ? '' : 'await '}${called(from)}();\n`).join('');
    return `function ${called(file)}() {\nreturn ${called(file)}.made ??= (async () => {\n${taken}${does}return { ${fields(gives, true)} };\n})();\n}\n`;
  });
  // Functions are there from the first line on.
  return `${first.does}function ${called(start)}() {\nreturn { ${fields(first.gives, true)} };\n}\n${made.join('')}`;
}
