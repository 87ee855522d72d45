// SPDX-License-Identifier: MIT
// Populations over time: species, sizes, shapes, heredity, and what became of individuals.
import * as Plot from '@observablehq/plot';
import { groupBy, list, shown } from './data.js';
import { absent, figure, make, panels, section, swatch } from './dom.js';
import { chart, generationAxis, grid, largest, smallest, tip, zero } from './charts.js';
import { curvePanel, legend } from './overview.js';

const columns = (names) => names.map((name) => ({ name, title: name.replaceAll('_', ' '), number: name !== 'setting' }));
const last = (report, setting, column) => report.overRuns(setting.setting, column).at(-1)?.median;
const eachGroup = (report, say) => report.groups.map((group) => `${group.title}: ${list(group.settings.map((setting) => `${setting.short} ${say(setting)}`))}`).join('; ');

/** A curve of each setting of a group: the median over runs of a column of generations.csv, with quartiles. */
function medians(report, group, column, title, unit) {
  return { group, title, unit, curves: group.settings.map((setting) => ({ setting,
    line: report.overRuns(setting.setting, column).map((row) => ({ generation: row.generation, value: row.median, low: row.runs > 3 ? row.low : null, high: row.high })),
    runs: report.rows('generations', setting.setting).map((row) => ({ generation: row.generation, value: row[column], seed: row.seed })) })) };
}

const hues = 10; // of report.css, --species-0 …

function speciesPanel(report, setting, width) {
  const rows = report.rows('species', setting.setting);
  const group = report.groups.find((each) => each.settings.includes(setting));
  const present = [...new Set(rows.map((row) => row.species))].sort((a, b) => a - b);
  const sizes = new Map(rows.map((row) => [`${row.generation} ${row.species}`, row.size]));
  const full = [...groupBy(rows, (row) => row.generation).keys()].flatMap((generation) => present.map((species) =>
    ({ generation, species, size: sizes.get(`${generation} ${species}`) ?? 0 })));
  return make('div', { class: 'panel' }, make('h3', {}, `${group.title}: ${setting.short}, seed ${rows[0].seed}`), chart(width, {
    height: 190, ariaLabel: `species of ${setting.setting}`, x: generationAxis(setting.generations - 1, width), y: { label: 'individuals', labelArrow: 'none', ticks: 4 },
    marks: [
      Plot.areaY(full, Plot.stackY({ x: 'generation', y: 'size', z: 'species', order: 'z', fill: (row) => `var(--species-${row.species % hues})`,
        stroke: 'var(--paper)', strokeWidth: 0.7 })),
      Plot.tip(rows, Plot.pointerX(Plot.stackY({ x: 'generation', y: 'size', z: 'species', order: 'z', ...tip,
        title: (row) => `species ${row.species}: ${row.size} individuals\ngeneration ${row.generation}` }))),
    ],
    color: { type: 'identity' },
  }));
}

export function species(report) {
  const composed = report.settings.filter((setting) => report.rows('species', setting.setting).length);
  return section('species', 'Species over time', figure({
    id: 'figure-species',
    title: 'How many species there are.',
    explanation: 'Species in the population: median over runs, with quartiles from four runs on; thin lines are single runs.',
    summary: `Species in the last generation, median over runs. ${eachGroup(report, (setting) => shown(last(report, setting, 'species')))}.`,
    controls: legend(report),
    draw: (width) => panels(report.groups, width, { least: 320, most: 2 }, (group, each) => curvePanel(report, medians(report, group, 'species', group.title, 'species'), each)),
    data: { columns: columns(['setting', 'seed', 'generation', 'species', 'mean_links', 'mean_hidden', 'archive']), rows: report.tables.generations,
      note: 'Of long runs every k-th generation; generations.csv of each run has all.' },
  }), composed.length ? figure({
    id: 'figure-species-sizes',
    title: 'How species grow and vanish.',
    explanation: 'The species of each setting’s best run: the height of a band is its number of individuals, the oldest species lies at the bottom. Colours only tell neighbours apart.',
    summary: `Species that the best run of a setting had in all. ${eachGroup(report, (setting) => shown(new Set(report.rows('species', setting.setting).map((row) => row.species)).size))}.`,
    draw: (width) => panels(composed, width, { least: 320, most: 2 }, (setting, each) => speciesPanel(report, setting, each)),
    data: { columns: columns(['setting', 'seed', 'generation', 'species', 'size', 'age']), rows: report.tables.species },
  }) : absent('No run of this experiment records species.'));
}

function sizePanel(report, group, width) {
  const bins = 40, most = largest(group.settings.flatMap((setting) => report.rows('sizes', setting.setting).map((row) => row.cells)));
  const step = Math.max(1, Math.ceil((most + 1) / bins));
  const rows = group.settings.flatMap((setting) => {
    const sizes = report.rows('sizes', setting.setting), all = sizes.reduce((sum, row) => sum + row.individuals, 0);
    const counts = new Map();
    for (const row of sizes) counts.set(Math.floor(row.cells / step), (counts.get(Math.floor(row.cells / step)) ?? 0) + row.individuals);
    return Array.from({ length: Math.floor(most / step) + 1 }, (_, bin) =>
      ({ setting, cells: (bin + 0.5) * step, low: bin * step, share: (counts.get(bin) ?? 0) / Math.max(1, all) }));
  });
  const marks = group.settings.flatMap((setting) => {
    const own = rows.filter((row) => row.setting === setting);
    return [Plot.areaY(own, { x: 'cells', y: (row) => 100 * row.share, fill: setting.colour, fillOpacity: 0.16, curve: 'step' }),
      Plot.lineY(own, { x: 'cells', y: (row) => 100 * row.share, stroke: setting.colour, strokeWidth: 1.8, curve: 'step' })];
  });
  return make('div', { class: 'panel' }, make('h3', {}, group.title), chart(width, {
    height: 210, ariaLabel: `sizes, ${group.title}`, x: { label: 'cells of the body', labelAnchor: 'right', labelArrow: 'none' }, y: { label: '% of the individuals', labelArrow: 'none', ticks: 5 },
    marks: [grid(), zero, ...marks, Plot.tip(rows, Plot.pointer({ x: 'cells', y: (row) => 100 * row.share, ...tip,
      title: (row) => `${row.setting.short}\n${row.low}${step > 1 ? ` to ${row.low + step - 1}` : ''} cells\n${shown(100 * row.share)} %` }))],
  }));
}

function entropyPanel(report, width) {
  const runs = report.tables.runs.map((run) => ({ ...run, own: report.bySetting.get(run.setting) }));
  const name = (setting) => setting.title || setting.setting;
  const rows = report.settings.map((own) => ({ ...report.rows('entropy', own.setting)[0], own }));
  const wide = Math.max(...report.settings.map((setting) => name(setting).length));
  return chart(width, {
    height: 46 + 34 * rows.length, marginLeft: Math.min(20 + wide * 6.6, width * 0.45), marginTop: 8, color: { type: 'identity' }, ariaLabel: 'size entropy',
    x: { label: 'size entropy, nat', labelAnchor: 'right', labelArrow: 'none', zero: true, nice: true }, y: { domain: report.settings.map(name), label: null, tickSize: 0, padding: 0.4 },
    marks: [grid('x'),
      Plot.dot(runs, { x: 'size_entropy', y: (run) => name(run.own), r: 2.6, fill: (run) => run.own.colour, fillOpacity: 0.45 }),
      Plot.link(rows.filter((row) => row.low !== null), { x1: 'low', x2: 'high', y1: (row) => name(row.own), y2: (row) => name(row.own), stroke: (row) => row.own.colour, strokeWidth: 2 }),
      Plot.dot(rows, { x: 'mean', y: (row) => name(row.own), r: 5, fill: 'var(--paper)', stroke: (row) => row.own.colour, strokeWidth: 2.2 })],
  });
}

export function sizes(report) {
  const mean = (setting) => { const row = report.rows('entropy', setting.setting)[0]; return `${shown(row?.mean)} nat`; };
  return section('sizes', 'Sizes and shapes', figure({
    id: 'figure-sizes',
    title: 'How many cells they have.',
    explanation: 'Individuals with fitness above 0, all generations and runs of a setting together.',
    summary: `Most frequent size. ${eachGroup(report, (setting) => { const rows = report.rows('sizes', setting.setting); return rows.length ? `${rows.reduce((a, b) => (b.individuals > a.individuals ? b : a)).cells} cells` : 'none'; })}.`,
    controls: legend(report),
    draw: (width) => panels(report.groups, width, { least: 320, most: 2 }, (group, each) => sizePanel(report, group, each)),
    data: { columns: columns(['setting', 'cells', 'individuals']), rows: report.tables.sizes },
  }), figure({
    id: 'figure-entropy',
    title: 'How diverse their sizes are.',
    explanation: `Size entropy of a run, Eq. 8 of the paper: dots are runs, the ring is their mean, the line its ${shown(report.confidence * 100)} % bootstrap interval from ${report.interval_runs} runs on.`,
    summary: `Mean size entropy. ${eachGroup(report, mean)}.`,
    draw: (width) => entropyPanel(report, Math.min(width, 760)),
    data: { columns: columns(['setting', 'runs', 'mean', 'low', 'high', 'median']), rows: report.tables.entropy },
  }), figure({
    id: 'figure-shapes',
    title: 'How much their shapes differ.',
    explanation: 'Mean distance between the shapes of two viable individuals of a generation (D2 shape distributions), mean over runs; thin lines are single runs.',
    summary: `Shape diversity in the last generation. ${eachGroup(report, (setting) => shown(report.rows('shape_diversity', setting.setting).at(-1)?.mean))}.`,
    controls: legend(report),
    draw: (width) => panels(report.groups, width, { least: 320, most: 2 }, (group, each) => curvePanel(report, { group, title: group.title, unit: 'distance',
      curves: group.settings.map((setting) => ({ setting,
        line: report.rows('shape_diversity', setting.setting).map((row) => ({ generation: row.generation, value: row.mean, low: row.low, high: row.high })),
        runs: report.rows('generations', setting.setting).map((row) => ({ generation: row.generation, value: row.shape_diversity, seed: row.seed })) })) }, each)),
    data: { columns: columns(['setting', 'generation', 'runs', 'mean', 'low', 'high']), rows: report.tables.shape_diversity },
  }));
}

const inherited = [
  ['heredity_fitness', 'fitness of mother and child', 'rank correlation'],
  ['heredity_cells', 'size of mother and child', 'rank correlation'],
  ['near_mother', 'children within a tenth of the mother’s fitness', 'share'],
];

export function heredity(report) {
  const rows = report.tables.heredity;
  if (!inherited.some(([column]) => rows.some((row) => row[column] !== null)))
    return section('heredity', 'Heredity', absent('Too few children have mothers with fitness: heredity cannot be measured.'));
  const lowest = smallest(inherited.flatMap(([column]) => rows.map((row) => row[column] ?? 0)));
  const items = report.groups.flatMap((group) => inherited.map(([column, title, unit]) => ({ group, title: `${group.title}: ${title}`, unit,
    domain: unit === 'share' ? [0, 1] : [Math.min(0, Math.floor(lowest * 5) / 5), 1],
    curves: group.settings.map((setting) => ({ setting, line: report.rows('heredity', setting.setting).filter((row) => row[column] !== null)
      .map((row) => ({ generation: row.generation, value: row[column] })) })) })));
  const later = (setting) => { const own = report.rows('heredity', setting.setting).filter((row) => row.heredity_fitness !== null); return shown(own.at(-1)?.heredity_fitness); };
  return section('heredity', 'Heredity', figure({
    id: 'figure-heredity',
    title: 'How alike mothers and children are.',
    explanation: 'Medians over runs of Spearman’s rank correlation between mother and child, and of the share of children whose fitness is within a tenth of the mother’s.',
    summary: `Correlation of fitness in the last generation. ${eachGroup(report, later)}.`,
    controls: legend(report),
    draw: (width) => panels(items, width, { least: 250, most: 3 }, (item, each) => curvePanel(report, item, each)),
    data: { columns: columns(['setting', 'generation', 'runs', 'heredity_fitness', 'heredity_cells', 'kept_fitness', 'near_mother', 'near_best', 'cyclic']), rows },
  }));
}

const outcomeNames = { viable: 'viable', died_out: 'died out', too_small: 'too small', overgrown: 'overgrown', never_settled: 'never settled', exploded: 'exploded' };

export function outcomes(report) {
  const keys = Object.keys(outcomeNames).filter((key) => report.tables.outcomes.some((row) => row[key] > 0));
  const bars = report.tables.outcomes.flatMap((row) => keys.map((key) => ({ ...row, key, share: 100 * row[key], own: report.bySetting.get(row.setting),
    when: row.generation === 0 ? 'first generation' : 'last generation' })));
  const whens = [...new Set(bars.map((bar) => bar.when))];
  const name = (setting) => setting.title || setting.setting;
  const colour = (key) => `var(--outcome-${Object.keys(outcomeNames).indexOf(key)})`;
  const wide = Math.max(...report.settings.map((setting) => name(setting).length));
  return section('outcomes', 'What became of individuals', figure({
    id: 'figure-outcomes',
    title: 'How simulations ended.',
    explanation: 'Shares of all individuals of a generation, mean over runs.',
    summary: `Viable in the last generation. ${eachGroup(report, (setting) => `${shown(100 * (report.rows('outcomes', setting.setting).at(-1)?.viable ?? 0))} %`)}.`,
    controls: make('ul', { class: 'legend', 'aria-label': 'colours' }, keys.map((key) => make('li', {}, swatch({ colour: colour(key) }), outcomeNames[key]))),
    draw: (width) => panels(whens, width, { least: 380, most: 2 }, (when, each) => make('div', { class: 'panel' }, make('h3', {}, when), chart(each, {
      height: 46 + 26 * report.settings.length, marginLeft: Math.min(16 + wide * 6.6, each * 0.5), marginTop: 6, color: { type: 'identity' }, ariaLabel: when,
      x: { label: '% of the individuals', labelAnchor: 'right', labelArrow: 'none', domain: [0, 100] }, y: { domain: report.settings.map(name), label: null, tickSize: 0 },
      marks: [Plot.barX(bars.filter((bar) => bar.when === when), { x: 'share', y: (bar) => name(bar.own), fill: (bar) => colour(bar.key), order: null, stroke: 'var(--paper)', strokeWidth: 0.6,
        title: (bar) => `${outcomeNames[bar.key]}: ${shown(bar.share)} %` })],
    }))),
    data: { columns: columns(['setting', 'generation', ...keys, 'overborn']), rows: report.tables.outcomes },
  }));
}
