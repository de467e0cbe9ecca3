// Elements of the page. Text from a study goes in as text, never as markup.

/**
 * @param {string} tag @param {Record<string, any>} [attributes] functions become listeners @param {...(Node | string | null)} children
 * @returns {HTMLElement}
 */
export function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) set(node, name, value);
  node.append(...children.filter((child) => child !== null));
  return node;
}

/** @param {Element} node @param {string} name @param {any} value */
function set(node, name, value) {
  if (typeof value === 'function') node.addEventListener(name, value);
  else if (value === true) node.setAttribute(name, '');
  else if (value !== false && value !== null && value !== undefined) node.setAttribute(name, String(value));
}

/** @param {string} tag @param {Record<string, any>} attributes @param {...Node} children @returns {SVGElement} */
export function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) set(node, name, value);
  node.append(...children);
  return /** @type {SVGElement} */ (node);
}

/** @param {string} label @param {(event: Event) => void} click @param {Record<string, any>} [more] */
export const button = (label, click, more = {}) => el('button', {type: 'button', click, ...more}, label);

/** A name that goes on in the next line behind an underscore, where there is no room for it. @param {string} name @returns {(Node | string)[]} */
export const breakable = (name) => name.split(/(?<=_)/).flatMap((part, i) => (i === 0 ? [part] : [el('wbr'), part]));

/** Label and value in two columns. @param {[string, string][]} pairs @param {string} [name] its class */
export const pairs = (pairs, name = 'pairs') => el('dl', {class: name}, ...pairs.flatMap(([label, value]) => [el('dt', {}, label), el('dd', {}, value)]));

/** A sentence in which numbers are not torn from their exponents and units. @param {string} text @returns {(Node | string)[]} */
export const prose = (text) => text.split(/((?:(?:tolerance|step) )?\d[^\s,;()]*e-\d+(?: [µmn]?s\b)?|\d[\d.\u202f]* (?:times|[µmn]?s)\b)/)
  .map((part, i) => i % 2 === 1 ? el('span', {class: 'whole'}, part) : part);
