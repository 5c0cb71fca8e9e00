/** Building the document from code, with types and without inline styles. */
import { say } from '../text/words';

type Child = Node | string | null;

export interface Attributes {
  class?: string;
  id?: string;
  testid?: string;
  key?: string;
  role?: string;
  for?: string;
  type?: string;
  title?: string;
  scope?: string;
  colspan?: number;
  hidden?: boolean;
  tabindex?: number;
  aria?: Record<string, string>;
}

/** An element with attributes and children. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes) as [keyof Attributes, Attributes[keyof Attributes]][]) {
    setAttribute(element, name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

function setAttribute(element: HTMLElement, name: keyof Attributes, value: Attributes[keyof Attributes]): void {
  if (value === undefined || value === false) return;
  if (typeof value === 'object') {
    for (const [aria, text] of Object.entries(value)) element.setAttribute(`aria-${aria}`, text);
    return;
  }
  const names: Partial<Record<keyof Attributes, string>> = { testid: 'data-testid', key: 'data-key' };
  element.setAttribute(names[name] ?? name, value === true ? '' : String(value));
}

/** Replaces what an element holds. */
export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren(...children.filter((child) => child !== null));
}

/** Gives an element these children, and moves none that stands where it is to stand: a press on it, or its focus, lasts. */
export function arrange(element: Element, ...children: Element[]): void {
  const wanted = new Set(children);
  for (const child of [...element.children]) if (!wanted.has(child)) child.remove();
  let next = element.firstElementChild;
  for (const child of children) {
    if (child === next) next = next.nextElementSibling;
    else element.insertBefore(child, next);
  }
}

export function button(text: string, testid: string, onClick: () => void, title?: string): HTMLButtonElement {
  const made = h('button', { type: 'button', testid, ...(title === undefined ? {} : { title }) }, text);
  made.addEventListener('click', onClick);
  return made;
}

const SVG = 'http://www.w3.org/2000/svg';

export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Record<string, string | number>, ...children: Child[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** An element that must be in the page. */
export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no element "${id}"`);
  return element;
}

/** A section of a panel with a heading. */
export function section(title: string, testid: string, ...children: Child[]): HTMLElement {
  const id = `h-${testid}`;
  return h('section', { class: 'section', testid, aria: { labelledby: id } }, h('h3', { id }, title), ...children);
}

/** Marks a row or a figure, within a panel that is up to date, whose numbers other settings made. */
export function markStale<E extends HTMLElement>(element: E, stale: boolean): E {
  if (stale) {
    element.classList.add('is-earlier');
    element.querySelector('th, figcaption')?.append(h('span', { class: 'earlier' }, say('earlier-settings-2')));
  }
  return element;
}

/** A table row: a heading and cells. */
export function row(heading: Child, ...cells: (Child | HTMLTableCellElement)[]): HTMLTableRowElement {
  return h('tr', {}, h('th', { scope: 'row' }, heading), ...cells.map((cell) => (cell instanceof HTMLTableCellElement ? cell : h('td', {}, cell))));
}
