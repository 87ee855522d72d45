// SPDX-License-Identifier: MIT
// The champions: a gallery in which each moves, and a window with one individual: its replay where the page holds one, its
// numbers, and the command that shows it again.
import { counted, shown } from './data.js';
import { absent, command, make, section, swatch } from './dom.js';

const viewer = () => globalThis.planula;
const shownFirst = 3; // champions of a setting that are shown without opening the rest

/** The recording of a run's champion: a promise; null if the page holds none. */
function recordingOf(run) {
  const element = document.querySelector(`script[data-run="${run?.index}"]`);
  return element ? viewer().unpack(element.textContent) : null;
}

/** The text of the module that simulates lives in this page: a promise, made once; null if the page holds none. */
let module = null;
function moduleText() {
  const element = document.getElementById('module');
  if (element) module ??= viewer().unpack(element.textContent);
  return module;
}

/** Plays the champion in an element while that is seen. */
function moveWhenSeen(element, run) {
  let player = null, seen = false;
  new IntersectionObserver(async ([entry]) => {
    seen = entry.isIntersecting;
    if (!seen) {
      if (!player) return;
      const still = element.querySelector('canvas'); // its last picture stays
      player.destroy();
      player = null;
      element.replaceChildren(still);
    } else if (!player && !element.dataset.failed) {
      try {
        const recording = await recordingOf(run);
        if (!seen || player) return;
        element.replaceChildren();
        player = viewer().mountReplay(element, recording, { compact: true });
        if (!matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
      } catch (error) {
        element.dataset.failed = '';
        element.replaceChildren(absent(`The recording cannot be shown: ${error.message}`));
      }
    }
  }, { rootMargin: '80px 0px' }).observe(element);
}

const championLink = (run) => `#run/${run.setting}/${run.seed}`;

function card(report, run) {
  const stage = make('div', { class: 'stage' });
  if (document.querySelector(`script[data-run="${run.index}"]`)) moveWhenSeen(stage, run);
  else stage.append(absent('not recorded'));
  return make('article', { class: 'card', 'aria-label': `champion of seed ${run.seed}` }, stage,
    make('p', {}, make('a', { href: championLink(run) }, `Seed ${run.seed}`), ` · ${shown(run.best_displacement)} cells far`, make('br'),
      make('span', { class: 'quiet' }, `${counted(run.best_cells, 'cell')}, of generation ${shown(run.best_generation)}`)));
}

export function gallery(report) {
  const hasAny = document.querySelector('script[data-run]');
  return section('champions', 'Champions',
    make('p', {}, 'The best individual of every run, as it grows and moves. Each plays while it is on the screen; its name opens it with all its numbers.'
      + (document.getElementById('module') ? ' There the core of planula simulates it again in this page, where you ask for it.' : '')),
    hasAny ? null : absent('This page holds no recordings.'),
    report.groups.flatMap((group) => group.settings.map((setting) => {
      const runs = [...report.runsOf.get(setting.setting)].sort((a, b) => a.rank - b.rank);
      const cards = (some) => make('div', { class: 'gallery' }, some.map((run) => card(report, run)));
      const rest = runs.slice(shownFirst);
      return make('div', { class: 'champions' }, make('h3', {}, swatch(setting), setting.title || setting.setting),
        cards(runs.slice(0, shownFirst)),
        rest.length > 0 && make('details', {}, make('summary', {}, `${counted(rest.length, 'further champion')}`), cards(rest)));
    })));
}

// ---- One individual ---------------------------------------------------------------------------------------------------

const quoted = (word) => (/^[\w./:@%+=-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
const replayCommand = (run, row) => `planula replay ${quoted(run.record.folder)} --generation ${row.generation} --slot ${row.slot}`;

const bare = /^(1|id|slot|generation|0 or 1|as .*|see .*|)$/; // units that are not written
const plural = (unit) => ({ cell: 'cells', step: 'steps' })[unit] ?? unit;

/** Name, value and meaning of everything that a row of a table says. */
function numbersOf(report, row, file) {
  return Object.keys(row).filter((name) => report.meanings.has(`${file} ${name}`) && row[name] !== null && row[name] !== '').map((name) => {
    const { unit, meaning } = report.meanings.get(`${file} ${name}`);
    const words = name.replaceAll('_', ' '), value = shown(row[name]);
    return [words, typeof row[name] !== 'number' || bare.test(unit) || unit === words ? value : `${value} ${plural(unit)}`, meaning];
  });
}

/** What a link of the page names: {run, row, file}, or null. */
function named(report, hash) {
  const [kind, setting, seed, generation, slot] = decodeURIComponent(hash.slice(1)).split('/');
  const run = report.run.get(`${setting}/${seed}`);
  if (!run) return null;
  const champions = report.rows('champions', setting).filter((row) => row.seed === run.seed);
  const find = (rows) => rows.find((row) => row.seed === run.seed && row.generation === Number(generation) && row.slot === Number(slot));
  if (kind === 'run') return { run, row: champions.at(-1), file: 'champions.csv', isBest: true };
  if (kind !== 'individual') return null;
  const champion = find(champions), row = find(report.rows('individuals', setting));
  return row || champion ? { run, row: row ?? champion, file: row ? 'individuals.csv.gz' : 'champions.csv', isBest: champion === champions.at(-1) } : null;
}

/** Adds the window; it opens for links #run/… and #individual/…, and closes with Escape, its button or the way back. */
export function individualWindow(report) {
  const dialog = make('dialog', { 'aria-labelledby': 'individual-title' });
  let player = null, laboratory = null, opened = 0, from = null;
  const stop = () => { player?.destroy(); laboratory?.destroy(); player = laboratory = null; };
  const leave = () => { if (/^#(run|individual)\//.test(location.hash)) history.replaceState(null, '', location.pathname + location.search); };
  dialog.addEventListener('close', () => { stop(); leave(); from?.focus?.(); });
  dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });

  async function show({ run, row, file, isBest }) {
    const setting = report.bySetting.get(run.setting), mine = ++opened;
    const stage = make('div', { class: 'stage large' }), again = make('div', { class: 'again' });
    stop();
    dialog.replaceChildren(
      make('form', { method: 'dialog' }, make('button', { class: 'close', 'aria-label': 'Close' }, '×')),
      make('h2', { id: 'individual-title' }, swatch(setting), `${setting.title || setting.setting}, seed ${run.seed}`),
      make('p', {}, `${isBest ? 'The champion of the run: ' : ''}generation ${shown(row.generation)}, slot ${row.slot}; fitness ${shown(row.fitness)} cells.`),
      stage, again, make('p', { class: 'quiet' }, isBest ? 'To see it with its network and signals, or as a picture or a film:' : 'The page holds the recordings of the champions alone. To see this individual, simulate it again from the run:'),
      command(replayCommand(run, row)),
      make('dl', { class: 'facts' }, numbersOf(report, row, file).map(([name, value, meaning]) => make('div', {}, make('dt', { title: meaning }, name), make('dd', {}, value)))));
    if (!dialog.open) dialog.showModal();
    const recording = isBest ? recordingOf(run) : null;
    if (!recording) return stage.remove();
    try {
      const read = await recording, core = await moduleText();
      if (mine !== opened || !dialog.open) return;
      const play = (life) => {
        player?.destroy();
        stage.classList.toggle('changed', life.life !== read.life);
        player = viewer().mountReplay(stage, life, {});
      };
      play(read);
      if (core) laboratory = viewer().mountLaboratory(again, read, core, play);
    } catch (error) {
      stage.replaceChildren(absent(`The recording cannot be shown: ${error.message}`));
    }
  }

  function follow() {
    const found = named(report, location.hash);
    if (!found) return;
    if (!dialog.open) from = document.activeElement;
    show(found);
  }
  document.body.append(dialog);
  addEventListener('hashchange', follow);
  follow();
}
