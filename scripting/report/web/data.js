// SPDX-License-Identifier: MIT
// What a report shows (scripting/report/report_data.h), with numbers as numbers, and its settings in groups of those that
// only their search distinguishes.

/** The lines of a CSV text (RFC 4180) as lists of fields. */
export function parseCsv(text) {
  const rows = [];
  let row = [], at = 0;
  while (at < text.length) {
    let field = '';
    if (text[at] === '"') {
      for (++at; text[at] !== '"' || text[at + 1] === '"'; ++at) {
        if (text[at] === undefined) throw new Error('a table of the page is damaged: a quote has no end');
        if (text[at] === '"') ++at;
        field += text[at];
      }
      ++at;
    } else {
      const comma = text.indexOf(',', at), line = text.indexOf('\n', at);
      const end = Math.min(comma < 0 ? text.length : comma, line < 0 ? text.length : line);
      field = text.slice(at, end);
      at = end;
    }
    row.push(field);
    if (text[at] !== ',') {
      rows.push(row);
      row = [];
    }
    ++at;
  }
  return rows;
}

/** A table as a list of objects. Columns of which the dictionary knows no unit are texts; of others an empty field is null. */
export function readTable(text, isText) {
  const [columns = [], ...lines] = parseCsv(text);
  const rows = lines.map((fields) => Object.fromEntries(columns.map((name, i) =>
    [name, isText(name) ? fields[i] : fields[i] === '' ? null : Number(fields[i])])));
  rows.columns = columns;
  return rows;
}

/** The values of a list by a key, in order of first appearance. */
export function groupBy(list, key) {
  const groups = new Map();
  for (const each of list) {
    const name = key(each);
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(each);
  }
  return groups;
}

/** The value below which a share of the sorted list lies, interpolated; of an empty list null. */
export function quantile(values, share) {
  const sorted = values.filter((value) => value !== null && !Number.isNaN(value)).sort((a, b) => a - b);
  if (!sorted.length) return null;
  const at = share * (sorted.length - 1), low = Math.floor(at);
  return sorted[low] + (at - low) * ((sorted[low + 1] ?? sorted[low]) - sorted[low]);
}
export const median = (values) => quantile(values, 0.5);

// The colours of report.css, --series-0 …: the first two as in the article's figures.
const fixedColours = { neat: 0, novelty: 1 };
const colours = 8;
const searchNames = { neat: 'NEAT', novelty: 'novelty search' };
const actuationNames = { oscillator: 'Oscillators', grn: 'Gene networks' };
const worldNames = { aquatic: 'in water', terrestrial: 'on land' };

/** Gives each setting of a group a colour and a short name that no other of the group has. */
function tellApart(settings) {
  const taken = new Set();
  const free = (wanted) => {
    let colour = wanted ?? 2;
    while (taken.has(colour) && taken.size < colours) colour = (colour + 1) % colours;
    taken.add(colour);
    return colour;
  };
  const searches = groupBy(settings, (setting) => setting.search);
  for (const setting of settings) {
    const isFirst = searches.get(setting.search)[0] === setting;
    setting.colour = `var(--series-${free(isFirst ? fixedColours[setting.search] : undefined)})`;
    const isOnly = searches.get(setting.search).length === 1;
    setting.short = isOnly ? searchNames[setting.search] ?? setting.search : setting.setting;
  }
}

const mostTogether = 8; // settings that one panel can show
const fewTogether = 6;  // of each panel, where there are more

/** Lists of at most so many. */
function parts(members) {
  if (members.length <= mostTogether) return [members];
  const lists = [];
  for (let at = 0; at < members.length; at += fewTogether) lists.push(members.slice(at, at + fewTogether));
  return lists;
}

/** Settings with the same actuation and world, in the order of the experiment. */
function groupsOf(settings) {
  const groups = [];
  for (const [key, all] of groupBy(settings, (setting) => `${setting.actuation}-${setting.world}`))
    parts(all).forEach((members, part, { length }) => {
      tellApart(members);
      const title = `${actuationNames[all[0].actuation] ?? all[0].actuation} ${worldNames[all[0].world] ?? all[0].world}`
        + (length > 1 ? `, part ${part + 1} of ${length}` : '');
      groups.push({ key: `${key}-${part}`, title, settings: members, isLand: all[0].world === 'terrestrial' });
    });
  return groups;
}

/** What the page knows: the object of scripting/report/report_data.h, read. */
export class Report {
  constructor(data) {
    Object.assign(this, data);
    const dictionary = readTable(data.dictionary, () => true);
    this.meanings = new Map(dictionary.map((row) => [`${row.file} ${row.column}`, row]));
    this.meaningOfColumn = new Map(dictionary.map((row) => [row.column, row]));
    const texts = new Set(dictionary.filter((row) => row.unit === '' && row.column !== 'seed').map((row) => row.column));
    this.tables = {};
    for (const [name, text] of Object.entries(data.tables))
      this.tables[name] = readTable(text, name === 'manifest' || name.startsWith('own ') ? () => true : (column) => texts.has(column));
    this.facts = Object.fromEntries(this.tables.manifest.map((row) => [row.key, row.value]));
    this.settings = this.tables.settings;
    this.groups = groupsOf(this.settings);
    this.bySetting = new Map(this.settings.map((setting) => [setting.setting, setting]));
    this.runsOf = groupBy(this.tables.runs, (run) => run.setting);
    this.rankRuns();
  }

  /** Each run by setting and seed, with its rank in its setting; of equals the lower seed comes first. */
  rankRuns() {
    this.run = new Map();
    this.chosen = new Map(); // of each setting the seeds of its best run, and of its best below the median
    for (const [setting, runs] of this.runsOf) {
      const ranked = [...runs].sort((a, b) => b.best_fitness - a.best_fitness || a.seed - b.seed);
      ranked.forEach((run, rank) => this.run.set(`${setting}/${run.seed}`, Object.assign(run, { rank })));
      const middle = Math.min(Math.floor((ranked.length + 1) / 2), ranked.length - 1);
      this.chosen.set(setting, { best: ranked[0].seed, median: ranked[middle].seed });
    }
    this.runs.forEach((record, index) => {
      const run = this.run.get(`${record.setting}/${record.seed}`);
      if (run) Object.assign(run, { index, record });
    });
  }

  rows(table, setting) {
    this.cache ??= new Map();
    if (!this.cache.has(table)) this.cache.set(table, groupBy(this.tables[table], (row) => row.setting));
    return this.cache.get(table).get(setting) ?? [];
  }

  /** Of each shown generation the median and quartiles over the runs of a setting of a column of generations.csv. */
  overRuns(setting, column) {
    return [...groupBy(this.rows('generations', setting), (row) => row.generation)].map(([generation, rows]) => {
      const values = rows.map((row) => row[column]);
      return { generation, runs: values.length, median: median(values), low: quantile(values, 0.25), high: quantile(values, 0.75) };
    }).sort((a, b) => a.generation - b.generation);
  }

  unit(file, column) { return this.meanings.get(`${file} ${column}`)?.unit ?? ''; }
  meaning(file, column) { return this.meanings.get(`${file} ${column}`)?.meaning ?? ''; }
  generations(setting) { return this.bySetting.get(setting).generations; }
}

const whole = new Intl.NumberFormat('en-GB', { maximumFractionDigits: 0 });
/** A number for people: three digits, or a whole one with separators. */
export function shown(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (typeof value !== 'number') return value;
  if (Number.isInteger(value) || Math.abs(value) >= 1000) return whole.format(value).replace('-', '−');
  return String(Number(value.toPrecision(3))).replace('-', '−');
}
export const counted = (count, one, many = one + 's') => `${shown(count)} ${count === 1 ? one : many}`;
export const list = (items) => items.length < 2 ? items.join('') : `${items.slice(0, -1).join(', ')} and ${items.at(-1)}`;
/** The same of texts that may contain commas. */
export const listOfTitles = (titles) => titles.join('; ');
