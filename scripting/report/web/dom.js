// SPDX-License-Identifier: MIT
// Elements of the page: sections, tables, and figures with a summary in words and a table of their data.
import { shown } from './data.js';

/** An element with attributes (functions are listeners) and children; texts are never read as HTML. */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** Calls action once, when the element comes near the window. */
const waiting = new Map();
const observer = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    observer.unobserve(target);
    waiting.get(target)();
    waiting.delete(target);
  }
}, { rootMargin: '600px 0px' });
function whenNear(element, action) {
  waiting.set(element, action);
  observer.observe(element);
}

/** A section with a heading that the contents list. */
export function section(id, title, ...children) {
  return make('section', { id, 'aria-labelledby': `${id}-title` }, make('h2', { id: `${id}-title` }, title), children);
}

export function swatch(setting) { return make('span', { class: 'swatch', style: `--colour: ${setting.colour}`, 'aria-hidden': 'true' }); }

/** A table. Columns: {name, title, unit, number, show}; show(row) gives a text or an element. */
export function table(columns, rows, attributes = {}) {
  const head = make('tr', {}, columns.map((column) => make('th', { scope: 'col', class: column.number && 'number' },
    column.title, column.unit && make('span', { class: 'unit' }, ` ${column.unit}`))));
  const body = rows.map((row) => make('tr', {}, columns.map((column, i) => {
    const value = column.show ? column.show(row) : row[column.name];
    return make(i === 0 ? 'th' : 'td', { scope: i === 0 && 'row', class: column.number && 'number' },
      typeof value === 'number' || value === null || value === undefined ? shown(value) : value);
  })));
  return make('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': attributes.label ?? 'table' },
    make('table', {}, attributes.caption && make('caption', {}, attributes.caption), make('thead', {}, head), make('tbody', {}, body)));
}

function toCsv(columns, rows) {
  const field = (value) => /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
  const lines = rows.map((row) => columns.map((column) => field(String(row[column.name] ?? ''))).join(','));
  return [columns.map((column) => column.name).join(','), ...lines].join('\n') + '\n';
}

const longest = 400; // rows that a table shows at once

/** The data behind a figure: made when it is opened. */
function dataTable(title, { columns, rows, note }) {
  const details = make('details', { class: 'data' }, make('summary', {}, `Data: ${shown(rows.length)} rows`));
  details.addEventListener('toggle', () => {
    if (details.childElementCount > 1) return;
    const url = URL.createObjectURL(new Blob([toCsv(columns, rows)], { type: 'text/csv' }));
    const more = rows.length > longest ? ` The first ${longest} of ${shown(rows.length)} rows are shown.` : '';
    details.append(
      make('p', { class: 'note' }, make('a', { href: url, download: `${title.replace(/[^a-z0-9]+/gi, '-').toLowerCase()}.csv` },
        'Save these rows as CSV'), `.${more} ${note ?? ''}`),
      table(columns, rows.slice(0, longest), { label: `data of: ${title}` }));
  });
  return details;
}

/** Whether the page is dark. Figures are drawn again when that changes. */
export const isDark = matchMedia('(prefers-color-scheme: dark)');
isDark.addEventListener('change', () => { for (const each of document.querySelectorAll('figure[data-drawn]')) each.redraw(); });

// On paper there are all figures, as wide as a page.
const pageWidth = 680; // of A4 and of Letter, pixels
addEventListener('beforeprint', () => { for (const each of document.querySelectorAll('figure')) each.redraw(pageWidth); });
addEventListener('afterprint', () => { for (const each of document.querySelectorAll('figure')) each.redraw(); });

let figures = 0;

/** A figure: title and what it shows, a sentence on what is seen, the picture, made when it comes near and again for another
    width, and its data. `draw(width)` returns an element. */
export function figure({ id, title, explanation, summary, draw, data, controls }) {
  const number = ++figures;
  const canvas = make('div', { class: 'picture', id: `${id}-picture`, role: 'group', 'aria-label': `${title}. ${summary}` });
  const element = make('figure', { id, 'data-figure': number },
    make('figcaption', {}, make('span', { class: 'label' }, `Figure ${number}`), make('strong', {}, title), ' ', explanation),
    make('p', { class: 'summary' }, summary), controls, canvas, data && dataTable(title, data));
  let width = 0; // unknown until it comes near
  element.redraw = (at = width) => {
    if (!at) return;
    canvas.replaceChildren(draw(at));
    element.dataset.drawn = '';
  };
  whenNear(element, () => new ResizeObserver(() => {
    const now = Math.floor(canvas.clientWidth);
    if (now > 0 && now !== width) { width = now; element.redraw(); }
  }).observe(canvas));
  return element;
}

/** Panels side by side, as many as the width has room for: panel(item, width) returns an element. */
export function panels(items, width, { least = 300, most = 3, gap = 28 }, panel) {
  const columns = Math.max(1, Math.min(most, items.length, Math.floor((width + gap) / (least + gap))));
  const each = Math.floor((width - gap * (columns - 1)) / columns);
  return make('div', { class: 'panels', style: `grid-template-columns: repeat(${columns}, ${each}px); column-gap: ${gap}px` },
    items.map((item) => panel(item, each)));
}

export function panel(title, ...children) { return make('div', { class: 'panel' }, make('h3', {}, title), children); }

/** One of several words, chosen by radio buttons. */
export function choice(legend, name, options, chosen, change) {
  return make('fieldset', { class: 'choice' }, make('legend', {}, legend), options.map(([value, text]) => make('label', {},
    make('input', { type: 'radio', name, value, checked: value === chosen, change: () => change(value) }), make('span', {}, text))));
}

export function absent(text) { return make('p', { class: 'absent' }, text); }

/** A command, with a button that copies it. */
export function command(text) {
  const said = make('span', { class: 'said', role: 'status' });
  return make('div', { class: 'command' }, make('code', {}, text), make('button', {
    type: 'button',
    click: async () => {
      try { await navigator.clipboard.writeText(text); said.textContent = 'copied'; } catch { said.textContent = 'select the text to copy it'; }
    },
  }, 'Copy'), said);
}
