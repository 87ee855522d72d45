// SPDX-License-Identifier: MIT
// Claims with their verdicts, and the tables of the experiment's own.
import { counted, groupBy, list, shown } from './data.js';
import { absent, make, section, table } from './dom.js';

const verdicts = { reproduced: ['✓', 'reproduced'], contradicted: ['✗', 'contradicted'], inconclusive: ['~', 'inconclusive'], open: ['…', 'open'] };
const badge = (verdict) => make('span', { class: `verdict ${verdict in verdicts ? verdict : ''}` },
  make('span', { 'aria-hidden': 'true' }, verdicts[verdict]?.[0] ?? ''), verdict);

const p = (value) => (value === null ? '–' : value < 0.001 ? '< 0.001' : shown(value));

/** The effect with its interval; of an effect from 0 to 1 also drawn, with a mark at 0.5 for no difference. */
function effect(row) {
  if (row.effect === null) return '–';
  const interval = row.low === null ? '' : ` [${shown(row.low)}, ${shown(row.high)}]`;
  const isShare = row.effect_name === 'A12';
  const place = (value) => `${(100 * value).toFixed(1)}%`;
  return make('span', { class: 'effect' }, `${row.effect_name} ${shown(row.effect)}${interval}`,
    isShare && make('span', { class: 'track', 'aria-hidden': 'true' },
      row.low !== null && make('span', { class: 'interval', style: `left: ${place(row.low)}; right: ${place(1 - row.high)}` }),
      make('span', { class: 'point', style: `left: ${place(row.effect)}` })));
}

export function claims(report) {
  const rows = report.tables.claims;
  if (!rows.length) return section('claims', 'Claims', absent('The experiment states no claims.'));
  const counts = (key) => list([...groupBy(rows.filter((row) => row[key]), (row) => row[key])].map(([verdict, some]) => `${some.length} ${verdict}`));
  const isOpen = rows.some((row) => row.verdict === 'open' && row.verdict_reached);
  const reason = (row) => [row.calibrated && 'The claim was used to choose the model: its verdict is no evidence.', row.note, row.note_reached].filter(Boolean).map((text) => text[0].toUpperCase() + text.slice(1).replace(/\.?$/, '.')).join(' ');
  return section('claims', 'Claims',
    make('p', {}, `${counted(rows.length, 'claim')}: ${counts('verdict')}.`
      + (isOpen ? ` An open claim lacks data; on the data that there are: ${counts('verdict_reached')}.` : '')
      + ' p is corrected after Holm over all tests of the table.'),
    table([
      { title: 'Claim', show: (row) => make('span', { id: `claim-${row.id}` }, row.id) },
      { title: 'Statement', show: (row) => make('span', { class: 'statement' }, row.statement, row.section && make('span', { class: 'quiet' }, ` ${row.section}${row.paper ? `: ${row.paper}` : ''}`),
        reason(row) && make('span', { class: 'reason' }, reason(row))) },
      { title: 'Verdict', show: (row) => badge(row.verdict) },
      isOpen && { title: 'On these data', show: (row) => (row.verdict_reached ? badge(row.verdict_reached) : '–') },
      { title: 'Effect and interval', show: effect },
      { title: 'p, Holm', number: true, show: (row) => p(row.p_holm) },
      { title: 'p of equivalence, Holm', number: true, show: (row) => p(row.p_equivalence_holm) },
      { title: 'Runs', number: true, show: (row) => (row.setting_b ? `${row.runs_a}, ${row.runs_b}` : shown(row.runs_a)) },
      { title: 'After', unit: 'generations', number: true, show: (row) => shown(row.at_generation) },
    ].filter(Boolean), rows, { label: 'claims' }));
}

/** Tables that the experiment makes itself. */
export function ownTables(report) {
  if (!report.own.length) return null;
  return section('own', 'Tables of the experiment', report.own.map((name) => {
    const rows = report.tables[`own ${name}`];
    return make('details', { class: 'data' }, make('summary', {}, `${name}: ${counted(rows.length, 'row')}`),
      table(rows.columns.map((column) => ({ name: column, title: column })), rows.slice(0, 400), { label: name }));
  }));
}
