// SPDX-License-Identifier: MIT
// How it was done: environments, departures from the paper, parameters, and where the data come from.
import { groupBy, list, listOfTitles, shown } from './data.js';
import { absent, command, make, section, table } from './dom.js';

const titleOf = (report, name) => report.bySetting.get(name)?.title || name;

function environments(report) {
  const same = groupBy(Object.entries(report.environments), ([, text]) => text);
  return make('ul', { class: 'plain' }, [...same].map(([text, settings]) => make('li', {},
    make('strong', {}, same.size === 1 ? 'All settings' : listOfTitles(settings.map(([name]) => titleOf(report, name)))), `: ${text}`)));
}

function departureItem(departure) {
  const name = departure.part === departure.name ? departure.name : `${departure.part} ${departure.name}`;
  const origin = departure.origin ? `, ${departure.origin}` : '';
  return make('li', {}, make('strong', {}, name), departure.part === 'function' ? ' of ' : ': ', departure.value,
    make('span', { class: 'quiet' }, ` (paper: ${departure.paper}${origin})`), departure.note && `; ${departure.note}`,
    departure.lines.length > 0 && make('details', {}, make('summary', {}, 'Source'), make('pre', {}, departure.lines.join('\n'))));
}

/** Departures with the settings that have them; those of all settings first. */
function departures(report) {
  if (!report.departures.length)
    return make('p', { class: 'complete' }, 'Every setting is as in the paper: environment, functions, search, engine, start and parameters.');
  const key = ({ setting, ...rest }) => JSON.stringify(rest);
  const each = [...groupBy(report.departures, key).values()];
  const groups = groupBy(each, (some) => some.map((row) => row.setting).join('\n'));
  const inOrder = [...groups].sort((a, b) => b[0].split('\n').length - a[0].split('\n').length);
  return inOrder.map(([names, some]) => {
    const settings = names.split('\n');
    const who = settings.length === report.settings.length && settings.length > 1 ? 'All settings' : listOfTitles(settings.map((name) => titleOf(report, name)));
    return make('div', {}, make('h3', {}, who), make('ul', { class: 'plain' }, some.map((rows) => departureItem(rows[0]))));
  });
}

function parameters(report) {
  const rows = report.tables.parameters.filter((row) => row.value !== '');
  const changed = rows.filter((row) => row.value !== row.standard);
  const columns = [
    { title: 'Parameter', show: (row) => make('code', {}, row.name) },
    { title: 'Value', number: true, show: (row) => (row.value === row.standard ? shown(row.value) : make('strong', {}, shown(row.value))) },
    { title: 'Standard', number: true, name: 'standard' },
    { title: 'Unit', name: 'unit' }, { title: 'Origin', name: 'origin' }, { title: 'Meaning', name: 'meaning' },
  ];
  return [make('p', {}, changed.length ? `${shown(changed.length)} of ${shown(rows.length)} parameters differ from their standard: ${list(changed.map((row) => row.name))}.`
    : `All ${shown(rows.length)} parameters have their standard values.`),
  make('details', { class: 'data' }, make('summary', {}, `All parameters: ${shown(rows.length)} rows`),
    [...groupBy(rows, (row) => row.section)].map(([name, some]) => [make('h4', {}, name), table(columns, some, { label: `parameters: ${name}` })]).flat())];
}

export function method(report) {
  return section('method', 'Parameters and departures from the paper', environments(report), departures(report), parameters(report));
}

const different = (report, key) => [...new Set(report.runs.map((run) => run[key]))];

export function provenance(report, licences) {
  const hash = (text) => make('code', { class: 'hash', title: text }, text);
  const facts = [
    ['Experiment', report.experiment],
    ['Folder of the runs', make('code', {}, report.folder)],
    ['planula', list(different(report, 'version'))],
    ['Compiler', list(different(report, 'compiler'))],
    ['Revision of the model', different(report, 'model').map(hash)],
    ['Hash over all results', hash(report.facts.results_sha256)],
    ['Seeds', `${report.facts.seeds} of ${report.facts.seeds_planned} planned`],
    ['Generations', `${shown(Number(report.facts.generations))} of ${shown(Number(report.facts.generations_planned))} planned`],
    ['Population', `${shown(Number(report.facts.population))} of ${shown(Number(report.facts.population_planned))} planned`],
  ];
  const another = different(report, 'model').some((model) => model !== report.revision);
  return section('provenance', 'Provenance',
    make('p', {}, 'The same experiment and seed give the same bytes on every machine. Each run’s chain of hashes has a link for every generation; the last one stands for the whole run.'),
    another && absent('The runs were made by another revision of the model than the program that made this page.'),
    make('dl', { class: 'facts wide' }, facts.map(([name, value]) => make('div', {}, make('dt', {}, name), make('dd', {}, value)))),
    make('details', { class: 'data' }, make('summary', {}, `Runs and their hashes: ${shown(report.runs.length)} rows`), table([
      { title: 'Setting', name: 'setting' }, { title: 'Seed', name: 'seed' }, { title: 'Generations', name: 'generations' }, { title: 'Recorded', name: 'record' },
      { title: 'Identity', show: (run) => hash(run.identity) }, { title: 'Last link of the chain', show: (run) => hash(run.link) },
    ], report.runs, { label: 'runs and their hashes' })),
    make('h3', {}, 'Check it'),
    make('p', {}, 'Compares all files of the runs with their hashes and simulates a random part again:'), command(`planula verify ${report.folder}`),
    make('h3', {}, 'Licences'),
    make('p', {}, 'The page and its data are part of planula (MIT). Its charts are drawn with the following packages, which the page contains:'),
    make('details', { class: 'data' }, make('summary', {}, 'Packages and their licences'), make('pre', { class: 'licences' }, licences)));
}
