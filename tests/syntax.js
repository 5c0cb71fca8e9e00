/** What the sources of the page say, read from their syntax. */

import { parseSync } from 'vite';

/** @typedef {{ type: string, start: number, end: number, [key: string]: any }} AstNode */

/**
 * Goes through the nodes of a file, outer ones first.
 * @param {string} name @param {string} code
 * @param {(node: AstNode, path: AstNode[]) => boolean | void} visit `path`: the nodes around; false: nothing in this node is visited
 */
export function walk(name, code, visit) {
  const go = (/** @type {any} */ node, /** @type {AstNode[]} */ path) => {
    if (Array.isArray(node)) {
      for (const one of node) go(one, path);
      return;
    }
    if (node === null || typeof node !== 'object' || typeof node.type !== 'string' || visit(node, path) === false) return;
    for (const value of Object.values(node)) go(value, [...path, node]);
  };
  go(parseSync(name, code, { lang: 'ts' }).program.body, []);
}

/** The addresses that a file imports from, types too; `isLoaded`: before the file itself runs.  @param {string} name @param {string} code */
export function importsOf(name, code) {
  /** @type {{ from: string, isLoaded: boolean }[]} */
  const found = [];
  walk(name, code, ({ type, source, importKind, exportKind }) => {
    if (!/^(?:Import(?:Declaration|Expression)|Export(?:Named|All)Declaration|TSImportType)$/u.test(type) || typeof source?.value !== 'string') return;
    const isType = type === 'TSImportType' || importKind === 'type' || exportKind === 'type';
    found.push({ from: source.value, isLoaded: !isType && type !== 'ImportExpression' });
  });
  return found;
}

/** The texts that a file says by name; `figures` is null where they are not written where it is said.  @param {string} name @param {string} code */
export function saidIn(name, code) {
  /** @type {{ name: string, figures: string[] | null }[]} */
  const found = [];
  walk(name, code, ({ type, callee, arguments: given }) => {
    if (type !== 'CallExpression' || !/^say(?:Named)?$/u.test(callee.name)) return;
    for (const said of namesIn(given[0])) found.push({ name: said, figures: figuresIn(given[1]) });
  });
  return found;
}

/** The names that an argument can be.  @param {AstNode | undefined} node @returns {string[]} */
function namesIn(node) {
  if (node?.type === 'ConditionalExpression') return [...namesIn(node.consequent), ...namesIn(node.alternate)];
  return node?.type === 'Literal' && typeof node.value === 'string' ? [node.value] : [];
}

/** @param {AstNode | undefined} node @returns {string[] | null} */
function figuresIn(node) {
  if (node === undefined) return [];
  if (node.type !== 'ObjectExpression') return null;
  const properties = /** @type {AstNode[]} */ (node.properties);
  if (properties.some(({ type, computed }) => type !== 'Property' || computed)) return null;
  return properties.map(({ key }) => key.name ?? key.value);
}
