/** Finds texts for people that stand in the code of the page, where only the catalogues may hold them. */

import { walk } from './syntax.js';

/**
 * @typedef {import('./syntax.js').AstNode} AstNode
 * @typedef {{ line: number, text: string }} Found
 */

/** Calls whose arguments are shown from the place on that is given. */
const SHOWING = new Map([
  ['h', 2],
  ['svg', 2],
  ['fill', 1],
  ['row', 0],
]);

/** Calls of which only one argument is shown. */
const SHOWS_ONE = new Map([
  ['button', [0, 3]],
  ['toggle', [0, 2]],
  ['section', [0]],
  ['numbers', [1, 5]],
  ['words', [1, 3]],
  ['choice', [0, 2]],
  ['Option', [0]],
  ['confirm', [0]],
]);

/** Properties that are shown wherever they are set. */
const SHOWN = new Set(['title', 'label', 'placeholder', 'textContent', 'text', 'does', 'where', 'help', 'more', 'roledescription', 'said', 'problem']);

/** Properties and arguments that people never read. */
const HIDDEN = new Set(['class', 'className', 'testid', 'key', 'id', 'name', 'font', 'accept', 'describedby', 'type', 'role']);

/** Calls that take selectors, names and addresses. */
const TECHNICAL =
  /^(?:say|message|byId|closest|matches|querySelector(?:All)?|getElementById|getAttribute|setAttribute|addEventListener|spawnWorker|call|text|log|warn|add|remove|contains)$/u;

/** Symbols, units, keys, names of programs and formats: the same in every language. */
export const SAME =
  /^(?:[A-Z]{2,}\d*|px|mm|cm|km|m|µm|kB|GB|MB|EPSG|COLMAP|MicMac|OpenSfM|BINGO|ISAT|PAT-B|GeoJSON|GeoTIFF|RMSE|GSD|MDB|Tiepoint|Ctrl|Control|Shift|Enter|Escape|Delete|Backspace|Esc|Del|Page|Down|Up|by|bz|vx|vy|dx|dy|[a-zA-Zσδ]\d?|Δ[A-Z]?|tif|tiff|zip|csv|json|png|html|tiepoint)$/u;

/** The texts for people in the code of one file.  @param {string} name @param {string} code @returns {Found[]} */
export function englishIn(name, code) {
  /** @type {Found[]} */
  const found = [];
  walk(name, code, (node, path) => {
    if (isNoCode(node)) return false;
    const text = textOf(node);
    if (text !== null && isForPeople(node, text, path)) found.push({ line: code.slice(0, node.start).split('\n').length, text });
    return true;
  });
  return found;
}

/** Types and addresses of modules.  @param {AstNode} node */
function isNoCode({ type, source }) {
  if (type === 'ImportDeclaration' || type === 'ExportAllDeclaration' || (type === 'ExportNamedDeclaration' && source !== null)) return true;
  return type.startsWith('TS') && !/^TS(?:As|Satisfies|NonNull|Instantiation|Type)\w*Expression$|^TSTypeAssertion$|^TSParameterProperty$/u.test(type);
}

/** A text with a gap for each expression in it.  @param {AstNode} node @returns {string | null} */
function textOf(node) {
  if (node.type === 'Literal') return typeof node.value === 'string' ? node.value : null;
  return node.type === 'TemplateLiteral' ? node.quasis.map((/** @type {AstNode} */ { value }) => value.cooked).join('{}') : null;
}

/** @param {AstNode} node @param {string} text @param {AstNode[]} path */
function isForPeople(node, text, path) {
  const words = text.replaceAll(/\{\}/gu, ' ').match(/\p{L}[\p{L}\d’'-]*/gu) ?? [];
  if (!words.some((word) => !SAME.test(word))) return false;
  const place = placeOf(node, path);
  if (place === 'hidden') return false;
  if (place === 'shown') return true;
  // Elsewhere it is told by its looks: a sentence, or a word with a capital.
  return (
    /[a-z]{2,}[,:;.…]? \(?(?:[A-Za-z]{2,}|\{\})|^[A-Z][a-z]+(?: …)?$|\{\}[,:;]? [a-z]{3,}/u.test(text) &&
    !/^[.#[]|^\w+(?:-\w+)+ |px [\w-]+, sans-serif$|^\((?:prefers|forced)-|gradient\(/u.test(text)
  );
}

/** Where a text stands: what it is for goes through conditions, concatenations and brackets.  @param {AstNode} node @param {AstNode[]} path @returns {'shown' | 'hidden' | 'open'} */
function placeOf(node, path) {
  let inner = node;
  for (const outer of [...path].reverse()) {
    if (outer.type === 'ConditionalExpression' || outer.type === 'LogicalExpression') {
      if (outer.test === inner) return 'hidden';
    } else if (outer.type === 'BinaryExpression') {
      if (outer.operator !== '+') return 'hidden';
    } else if (outer.type === 'Property') return outer.key === inner ? 'hidden' : ofProperty(outer.key.name ?? outer.key.value);
    else if (outer.type === 'AssignmentExpression') return ofProperty(outer.left.property?.name);
    else if (outer.type === 'CallExpression' || outer.type === 'NewExpression') return ofArgument(outer, inner);
    else if (outer.type === 'MemberExpression' || outer.type === 'SwitchCase') return 'hidden';
    else if (!/^(?:Template|TS|Spread|Parenthesized|Chain)/u.test(outer.type)) return 'open';
    inner = outer;
  }
  return 'open';
}

/** @param {string | undefined} name @returns {'shown' | 'hidden' | 'open'} */
function ofProperty(name) {
  if (name === undefined) return 'open';
  return SHOWN.has(name) ? 'shown' : HIDDEN.has(name) ? 'hidden' : 'open';
}

/** @param {AstNode} call @param {AstNode} argument @returns {'shown' | 'hidden' | 'open'} */
function ofArgument(call, argument) {
  const name = call.callee.name ?? call.callee.property?.name ?? '';
  const at = call.arguments.indexOf(argument);
  const isMethod = call.callee.type === 'MemberExpression';
  // Of classes and of what is held in sets.
  if (at < 0 || TECHNICAL.test(name) || (isMethod && name === 'toggle')) return 'hidden';
  const from = isMethod ? undefined : SHOWING.get(name);
  if (from !== undefined) return at >= from ? 'shown' : 'hidden';
  const ones = isMethod && name !== 'confirm' ? undefined : SHOWS_ONE.get(name);
  if (ones !== undefined) return ones.includes(at) ? 'shown' : 'hidden';
  return 'open';
}
