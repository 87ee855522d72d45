// SPDX-License-Identifier: MIT
// Where individuals ended, and what the archive keeps: maps whose points open the individual.
import * as Plot from '@observablehq/plot';
import { counted, list, listOfTitles, shown } from './data.js';
import { absent, choice, figure, isDark, make, panels, section } from './dom.js';
import { chart, generationAxis, grid, tip } from './charts.js';

/** Colours of generations: light for the first to dark for the last, as in the article; on a dark page the other way. */
const ages = ['#fde725', '#5ec962', '#21918c', '#3b528b', '#440154'];
const age = (report) => ({ type: 'linear', domain: ages.map((_, i) => (i / (ages.length - 1)) * Math.max(1, Math.max(...report.settings.map((s) => s.generations)) - 1)),
  range: isDark.matches ? [...ages].reverse() : ages, interpolate: 'rgb' });

function scaleOfGenerations(report) {
  const last = Math.max(...report.settings.map((setting) => setting.generations)) - 1;
  return make('p', { class: 'ramp', 'aria-hidden': 'true' }, 'generation 0', make('span', { style: `--ages: ${ages.join(', ')}` }), shown(last));
}

export const linkOf = (row) => `#individual/${row.setting}/${row.seed}/${row.generation}/${row.slot}`;

function points(report, setting, role) {
  const seed = report.chosen.get(setting.setting)[role];
  return {
    seed,
    individuals: report.rows('individuals', setting.setting).filter((row) => row.seed === seed)
      .map((row) => ({ ...row, x: row.finish_x - row.rest_x, y: row.finish_y - row.rest_y })),
    champions: report.rows('champions', setting.setting).filter((row) => row.seed === seed),
  };
}

/** Left and right, or all sides, with the same scale in both directions. */
function domains(report, group, role) {
  const all = group.settings.flatMap((setting) => { const { individuals, champions } = points(report, setting, role); return [...individuals, ...champions]; });
  const reach = Math.max(1, ...all.map((row) => Math.abs(row.x)));
  const height = Math.max(1, ...all.map((row) => Math.abs(row.y)));
  return { x: [-reach, reach], y: [-height, height], all: Math.max(reach, height) };
}

const says = (row) => `generation ${shown(row.generation)}, slot ${row.slot}\nfitness ${shown(row.fitness)} cells\n${counted(row.cells, 'cell')}`;

function map(report, group, setting, role, width) {
  const { seed, individuals, champions } = points(report, setting, role);
  const reach = domains(report, group, role);
  const y = group.isLand ? (row) => row.generation : 'y';
  const aria = (row) => says(row).replaceAll('\n', ', ');
  const picture = chart(width, {
    height: group.isLand ? 300 : width, marginRight: 12, color: age(report), ariaLabel: `${setting.short}, end points of seed ${seed}`,
    x: { domain: group.isLand ? reach.x : [-reach.all, reach.all], label: 'horizontal displacement, cells', labelArrow: 'none', nice: true, ticks: Math.floor(width / 70) },
    y: group.isLand
      ? { ...generationAxis(setting.generations - 1, 300), labelAnchor: 'top', reverse: true }
      : { domain: [-reach.all, reach.all], label: 'vertical displacement, cells', labelArrow: 'none', nice: true, ticks: Math.floor(width / 70) },
    marks: [
      grid('x'), grid('y'), Plot.ruleX([0], { stroke: 'var(--axis)', strokeOpacity: 0.5 }), group.isLand ? null : Plot.ruleY([0], { stroke: 'var(--axis)', strokeOpacity: 0.5 }),
      Plot.dot(individuals, { x: 'x', y, r: 2.4, fill: 'generation', fillOpacity: 0.75, stroke: 'var(--edge)', strokeWidth: 0.4, href: linkOf, ariaLabel: aria }),
      Plot.line(champions, { x: 'x', y, stroke: 'var(--ink)', strokeWidth: 1.2, strokeDasharray: '3,2' }),
      Plot.dot(champions, { x: 'x', y, r: 4.5, fill: 'generation', stroke: 'var(--ink)', strokeWidth: 1.4, href: linkOf, ariaLabel: (row) => `champion, ${aria(row)}` }),
      Plot.tip([...individuals, ...champions], Plot.pointer({ x: 'x', y, ...tip, title: says, maxRadius: 30 })),
    ],
  });
  if (!individuals.length) return make('div', { class: 'panel' }, make('h3', {}, setting.short), absent('No individual of this run moved to the end.'));
  quietLinks(picture);
  picture.addEventListener('click', (event) => { if (!event.target.closest('a') && picture.value) location.hash = linkOf(picture.value); });
  return make('div', { class: 'panel map' }, make('h3', {}, `${group.title}: ${setting.short}, seed ${seed}`), picture);
}

/** The many links of a map are one stop of the Tab key: the arrow keys go from one to the next. */
function quietLinks(picture) {
  const links = [...picture.querySelectorAll('a')];
  links.forEach((link, i) => link.setAttribute('tabindex', i === 0 ? '0' : '-1'));
  picture.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, PageDown: 50, PageUp: -50 }[event.key];
    const at = links.indexOf(event.target.closest('a'));
    if (!step || at < 0) return;
    event.preventDefault();
    links[at].setAttribute('tabindex', '-1');
    const next = links[(at + step + links.length) % links.length];
    next.setAttribute('tabindex', '0');
    next.focus();
  });
}

export function exploration(report) {
  const groups = report.groups.filter((group) => group.settings.some((setting) => report.rows('individuals', setting.setting).length));
  if (!groups.length) return section('exploration', 'Exploration', absent('No individual is recorded: no map of end points can be drawn.'));
  let role = 'best';
  const items = groups.flatMap((group) => group.settings.map((setting) => ({ group, setting })));
  const summary = groups.map((group) => `${group.title}: ${list(group.settings.map((setting) => {
    const reach = Math.max(0, ...points(report, setting, role).individuals.map((row) => Math.hypot(row.x, row.y)));
    return `${setting.short} up to ${shown(reach)} cells`;
  }))}`).join('; ');
  const element = figure({
    id: 'figure-exploration',
    title: 'Where individuals ended.',
    explanation: 'Each point is the place of an individual’s end seen from where it rested, of about a thousand drawn at random from a run; of walkers, the horizontal place by generation. '
      + 'Larger points are the champions of the run one after the other. Colour is the generation. A click, or Enter on a point, opens the individual; the arrow keys go from point to point.',
    summary: `How far the individuals of the best run got. ${summary}.`,
    controls: make('div', { class: 'controls' },
      choice('Run', 'role', [['best', 'best of the setting'], ['median', 'below the median']], role, (value) => { role = value; element.redraw(); }), scaleOfGenerations(report)),
    draw: (width) => panels(items, width, { least: 300, most: 2 }, ({ group, setting }, each) => map(report, group, setting, role, Math.min(each, 460))),
    data: { columns: ['setting', 'seed', 'generation', 'slot', 'fitness', 'cells', 'finish_x', 'finish_y', 'rest_x', 'rest_y'].map((name) => ({ name, title: name.replaceAll('_', ' '), number: name !== 'setting' })),
      rows: report.tables.individuals, note: 'endpoints.csv beside this page has the larger sample that the article draws.' },
  });
  return section('exploration', 'Exploration', element);
}

export function archive(report) {
  const settings = report.settings.filter((setting) => report.rows('archives', setting.setting).length);
  if (!settings.length) return section('archive', 'Archive', absent('No search of this experiment keeps an archive.'));
  const groupOf = (setting) => report.groups.find((group) => group.settings.includes(setting));
  const untold = report.settings.filter((setting) => !settings.includes(setting) && (report.overRuns(setting.setting, 'archive').at(-1)?.median ?? 0) > 0);
  const hasTwo = (setting) => report.rows('archives', setting.setting).some((row) => row.y !== null);
  return section('archive', 'Archive', untold.length > 0 && absent(`The experiment does not ask for the end points of ${listOfTitles(untold.map((setting) => setting.title || setting.setting))}: their archives are not tabled.`), figure({
    id: 'figure-archive',
    title: 'What the archive keeps.',
    explanation: 'The descriptors of the individuals in the archive of each setting’s best run, in the paper where they ended. Colour is the generation that added them.',
    summary: `Entries in the archive at the end. ${settings.map((setting) => `${groupOf(setting).title}, ${setting.short}: ${shown(report.overRuns(setting.setting, 'archive').at(-1)?.median)}`).join('; ')}.`,
    controls: make('div', { class: 'controls' }, scaleOfGenerations(report)),
    draw: (width) => panels(settings, width, { least: 300, most: 2 }, (setting, each) => {
      const rows = report.rows('archives', setting.setting), two = hasTwo(setting);
      return make('div', { class: 'panel' }, make('h3', {}, `${groupOf(setting).title}: ${setting.short}, seed ${rows[0].seed}`), chart(each, {
        height: 280, color: age(report), ariaLabel: `archive of ${setting.setting}`,
        x: { label: 'first number of the descriptor', labelArrow: 'none', nice: true, ticks: Math.floor(each / 70) },
        y: two ? { label: 'second number of the descriptor', labelArrow: 'none', nice: true } : { ...generationAxis(setting.generations - 1, 280), labelAnchor: 'top' },
        marks: [grid('x'), grid('y'), Plot.dot(rows, { x: 'x', y: two ? 'y' : 'generation', r: 2, fill: 'generation', fillOpacity: 0.8, stroke: 'var(--edge)', strokeWidth: 0.3 })],
      }));
    }),
    data: { columns: ['setting', 'seed', 'generation', 'x', 'y'].map((name) => ({ name, title: name, number: name !== 'setting' })), rows: report.tables.archives,
      note: 'Of a large archive some 2000 entries; archives.csv beside this page has all.' },
  }));
}
