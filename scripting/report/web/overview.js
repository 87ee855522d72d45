// SPDX-License-Identifier: MIT
// The top of the page: what was asked, on which share of the design it rests, and the headline numbers.
import * as Plot from '@observablehq/plot';
import { counted, list, median, quantile, shown } from './data.js';
import { figure, make, panels, section, swatch, table } from './dom.js';
import { chart, curveMarks, generationAxis, grid, largest, tip, zero } from './charts.js';

/** "8 settings, 24 runs, …": what was done, in a sentence or two. */
function asked(report) {
  const { facts } = report;
  const populations = [...new Set(report.settings.map((setting) => setting.population))];
  const generations = [...new Set(report.settings.map((setting) => setting.generations))];
  const searches = [...new Set(report.groups.flatMap((group) => group.settings.map((setting) => setting.short)))];
  const range = (values, one) => values.length === 1 ? counted(values[0], one) : `${shown(Math.min(...values))} to ${shown(Math.max(...values))} ${one}s`;
  return `${counted(report.settings.length, 'setting')} and ${counted(report.tables.runs.length, 'run')}. In each run `
    + `${list(searches)} evolve${searches.length === 1 ? 's' : ''} ${range(populations, 'individual')} over ${range(generations, 'generation')}: `
    + `${counted(Number(facts.evaluations), 'evaluation')} in all. Fitness is a distance, in cells (one cell diameter), unless the experiment states another.`;
}

/** Shares of the planned design that are there. */
function shares(report) {
  const { facts } = report;
  return [['seeds', 'runs of a setting'], ['generations', 'generations'], ['population', 'individuals in a generation']]
    .map(([name, words]) => ({ words, there: Number(facts[name]), planned: Number(facts[`${name}_planned`]) }))
    .filter(({ there, planned }) => there < planned);
}

function missing(report) {
  const sentences = shares(report).map(({ words, there, planned }) => `${shown(there)} of ${shown(planned)} planned ${words}`);
  const items = [
    sentences.length && `The design is not complete: ${list(sentences)}.`,
    report.tables.runs.length && Number(report.facts.seeds) < report.interval_runs
      && `A setting has fewer than ${report.interval_runs} runs: there are no intervals of means; thin lines show each run.`,
    ...report.missing,
  ].filter(Boolean);
  if (!items.length) return make('p', { class: 'complete' }, 'All runs of the design are here.');
  return make('aside', { class: 'missing', 'aria-label': 'What is missing' }, make('h3', {}, 'What is missing'),
    make('ul', {}, items.map((item) => make('li', {}, item))));
}

function numbers(report) {
  const best = report.tables.runs.reduce((a, b) => (b.best_fitness > a.best_fitness ? b : a));
  const claims = report.tables.claims;
  const reached = claims.filter((claim) => (claim.verdict_reached || claim.verdict) === 'reproduced').length;
  const isOpen = claims.some((claim) => claim.verdict === 'open');
  const items = [
    [shown(report.tables.runs.length), `of ${shown(report.settings.length * Number(report.facts.seeds_planned))} planned runs`],
    [shown(Number(report.facts.evaluations)), 'evaluations'],
    [`${shown(best.best_fitness)}`, `cells: the highest fitness, ${report.bySetting.get(best.setting).title || best.setting}, seed ${best.seed}`],
    claims.length ? [`${reached} of ${claims.length}`, `claims reproduced${isOpen ? ', on these data' : ''}`] : [shown(report.settings.length), 'settings'],
  ];
  return make('dl', { class: 'numbers' }, items.map(([value, words]) => make('div', {}, make('dt', {}, words), make('dd', {}, value))));
}

function settingsTable(report) {
  const rows = report.settings.map((setting) => {
    const runs = report.runsOf.get(setting.setting);
    const values = runs.map((run) => run.best_fitness);
    return { ...setting, best: Math.max(...values), median: median(values), low: quantile(values, 0.25), high: quantile(values, 0.75),
      cells: median(runs.map((run) => run.best_cells)), entropy: report.rows('entropy', setting.setting)[0]?.median ?? null, own: setting };
  });
  const most = largest(rows.map((row) => row.best));
  const bar = (row) => make('span', { class: 'bar', style: `--share: ${most ? Math.max(0, row.median / most) : 0}; --colour: ${row.own.colour}` }, shown(row.median));
  return table([
    { title: 'Setting', show: (row) => make('span', { class: 'setting' }, swatch(row.own), make('span', {}, row.title || row.setting, make('code', { class: 'name' }, row.setting))) },
    { title: 'Champion’s fitness, median', unit: 'cells', number: true, show: bar },
    { title: 'Quartiles', unit: 'cells', number: true, show: (row) => `${shown(row.low)} to ${shown(row.high)}` },
    { title: 'Best', unit: 'cells', number: true, name: 'best' },
    { title: 'Its size, median', unit: 'cells', number: true, name: 'cells' },
    { title: 'Size entropy, median', unit: 'nat', number: true, name: 'entropy' },
    { title: 'Runs', number: true, name: 'runs' },
    { title: 'Generations', number: true, name: 'generations' },
  ], rows, { label: 'settings and what they reached' });
}

export function overview(report) {
  return section('overview', 'At a glance', make('p', {}, asked(report)), numbers(report), missing(report), settingsTable(report));
}

/** Best fitness and the median of the population over the generations. */
export function fitness(report) {
  const best = (setting) => ({ setting,
    line: report.rows('curves', setting.setting).map((row) => ({ generation: row.generation, value: row.mean, low: row.low, high: row.high })),
    runs: report.rows('generations', setting.setting).map((row) => ({ generation: row.generation, value: row.best_fitness, seed: row.seed })) });
  const middle = (setting) => ({ setting,
    line: report.overRuns(setting.setting, 'fitness_median').map((row) => ({ generation: row.generation, value: row.median,
      low: row.runs > 3 ? row.low : null, high: row.high })),
    runs: report.rows('generations', setting.setting).map((row) => ({ generation: row.generation, value: row.fitness_median, seed: row.seed })) });
  const items = report.groups.flatMap((group) => [
    { group, title: `${group.title}: best of the generation`, curves: group.settings.map(best) },
    { group, title: `${group.title}: median of the valid`, curves: group.settings.map(middle) }]);
  const ends = report.groups.map((group) => {
    const last = group.settings.map((setting) => ({ setting, value: best(setting).line.at(-1)?.value ?? 0 })).sort((a, b) => b.value - a.value);
    return `${group.title}: ${list(last.map(({ setting, value }) => `${setting.short} ${shown(value)}`))} cells`;
  });
  const percent = shown(report.confidence * 100);
  return section('fitness', 'Fitness over the generations', figure({
    id: 'figure-fitness',
    title: 'How far they move.',
    explanation: `Left, the best individual of each generation: mean over runs, with the ${percent} % bootstrap interval from ${report.interval_runs} runs on. `
      + 'Right, the median of the valid individuals: median over runs, with quartiles from four runs on. Thin lines are single runs.',
    summary: `Best fitness in the last generation, mean over runs. ${ends.join('; ')}.`,
    controls: legend(report),
    draw: (width) => panels(items, width, { least: 320, most: 2 }, (item, each) => curvePanel(report, item, each)),
    data: { columns: ['setting', 'generation', 'runs', 'mean', 'low', 'high'].map((name) => ({ name, title: name, number: name !== 'setting', unit: report.unit('curves.csv', name) === 'cell' ? 'cells' : '' })),
      rows: report.tables.curves, note: 'Best fitness in the generation, mean over runs and its interval. curves.csv beside this page has every generation.' },
  }));
}

/** A panel of curves of a group. */
export function curvePanel(report, { group, title, curves, unit = 'cells', domain }, width) {
  const last = Math.max(...group.settings.map((setting) => setting.generations)) - 1;
  const picture = chart(width, {
    height: 230, x: generationAxis(last, width), y: { label: unit, nice: true, zero: true, labelArrow: 'none', ticks: 5, domain },
    marks: [grid(), zero, ...curveMarks(curves)], ariaLabel: title,
  });
  return make('div', { class: 'panel' }, make('h3', {}, title), picture);
}

/** Which colour is which search, of all groups. */
export function legend(report) {
  const items = new Map();
  for (const group of report.groups) for (const setting of group.settings) items.set(`${setting.short} ${setting.colour}`, setting);
  return make('ul', { class: 'legend', 'aria-label': 'colours' }, [...items.values()].map((setting) => make('li', {}, swatch(setting), setting.short)));
}

/** The champions' fitness of all runs, searches side by side. */
export function searches(report) {
  const most = largest(report.tables.runs.map((run) => run.best_fitness));
  const medians = report.groups.map((group) => `${group.title}: ${list(group.settings.map((setting) =>
    `${setting.short} ${shown(median(report.runsOf.get(setting.setting).map((run) => run.best_fitness)))}`))} cells`);
  return section('searches', 'Searches side by side', figure({
    id: 'figure-searches',
    title: 'What the runs reached.',
    explanation: 'A dot is the champion of a run, its best individual; the bar is the median of the runs, the box reaches from quartile to quartile. A click opens the champion.',
    summary: `Median fitness of the champions. ${medians.join('; ')}.`,
    draw: (width) => panels(report.groups, width, { least: 320, most: 2 }, (group, each) => searchPanel(report, group, each, most)),
    data: { columns: ['setting', 'seed', 'best_fitness', 'best_generation', 'best_cells', 'size_entropy'].map((name) => ({ name, title: name.replaceAll('_', ' '), number: name !== 'setting' })),
      rows: report.tables.runs, note: 'runs.csv beside this page has all columns.' },
  }));
}

function searchPanel(report, group, width, most) {
  const runs = group.settings.flatMap((setting) => report.runsOf.get(setting.setting).map((run) => ({ ...run, own: setting })));
  const boxes = group.settings.map((own) => {
    const values = report.runsOf.get(own.setting).map((run) => run.best_fitness);
    return { own, low: quantile(values, 0.25), median: median(values), high: quantile(values, 0.75), runs: values.length };
  });
  const names = group.settings.map((setting) => setting.short);
  const picture = chart(width, {
    height: 44 + 56 * names.length, marginLeft: 16 + 7 * Math.max(...names.map((name) => Math.min(name.length, 18))), marginTop: 6,
    x: { domain: [0, most * 1.02], label: 'fitness of the champion, cells', labelAnchor: 'right', labelArrow: 'none', nice: true },
    fy: { domain: names, label: null, padding: 0.15, axis: 'left', tickFormat: (name) => (name.length > 18 ? `${name.slice(0, 17)}…` : name) },
    y: { axis: null, domain: [-1, 1] },
    marks: [
      grid('x'),
      Plot.rect(boxes.filter((box) => box.runs > 3), { fy: (box) => box.own.short, x1: 'low', x2: 'high', y1: -0.55, y2: 0.55, fill: (box) => box.own.colour, fillOpacity: 0.16 }),
      Plot.ruleX(boxes, { fy: (box) => box.own.short, x: 'median', y1: -0.75, y2: 0.75, stroke: (box) => box.own.colour, strokeWidth: 3 }),
      Plot.dot(runs, Plot.dodgeY('middle', { fy: (run) => run.own.short, x: 'best_fitness', r: 4.5, fill: (run) => run.own.colour,
        stroke: 'var(--paper)', strokeWidth: 1, href: (run) => `#run/${run.setting}/${run.seed}`, ariaLabel: (run) =>
          `${run.own.short}, seed ${run.seed}: ${shown(run.best_fitness)} cells` })),
      Plot.tip(runs, Plot.pointer({ fy: (run) => run.own.short, x: 'best_fitness', y: () => 0, ...tip, anchor: 'bottom',
        title: (run) => `${run.own.short}, seed ${run.seed}\n${shown(run.best_fitness)} cells\nsize ${run.best_cells} cells, generation ${run.best_generation}` })),
    ],
    color: { type: 'identity' },
  });
  picture.addEventListener('click', (event) => { if (!event.target.closest('a') && picture.value) location.hash = `#run/${picture.value.setting}/${picture.value.seed}`; });
  return make('div', { class: 'panel' }, make('h3', {}, group.title), picture);
}
