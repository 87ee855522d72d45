// SPDX-License-Identifier: MIT
// Reports in a browser, of the tracked runs and of a single one: every figure is drawn, champions move, points open the
// individual by mouse and by keyboard, links lead somewhere, and no page asks for anything or complains.
import { statSync } from 'node:fs';
import { join, resolve } from 'node:path';

const ready = `while (!('ready' in document.documentElement.dataset)) await new Promise((resolve) => setTimeout(resolve, 20));`;

/** Scrolls every figure into view, and tells how much each shows. */
const figures = `
  const shown = [];
  for (const figure of document.querySelectorAll('figure')) {
    figure.scrollIntoView();
    for (let i = 0; i < 250 && !('drawn' in figure.dataset); ++i) await new Promise((resolve) => setTimeout(resolve, 20));
    const svgs = [...figure.querySelectorAll('.picture svg')];
    const marks = svgs.map((svg) => svg.querySelectorAll('path, circle, rect, line').length);
    const bad = svgs.some((svg) => /NaN|undefined|null/.test(svg.outerHTML.replace(/class="[^"]*"/g, '')));
    shown.push({ id: figure.id, marks, bad, summary: figure.querySelector('.summary').textContent });
  }
  return shown;`;

/** Whether the pictures of a canvas differ within two seconds. */
const moves = `
  const stage = document.querySelector('#champions .stage');
  stage.scrollIntoView({ block: 'center' });
  let first = '';
  for (let i = 0; i < 250; ++i) {
    await new Promise((resolve) => setTimeout(resolve, 40));
    const canvas = stage.querySelector('canvas');
    const picture = canvas && canvas.width > 0 ? canvas.toDataURL() : '';
    if (!first) first = picture;
    else if (picture && picture !== first) return true;
  }
  return false;`;

const isOpen = `
  await new Promise((resolve) => setTimeout(resolve, 60));
  const dialog = document.querySelector('dialog');
  const said = dialog.open && { title: dialog.querySelector('h2').textContent, command: dialog.querySelector('.command code').textContent,
    numbers: dialog.querySelectorAll('dd').length, canvas: Boolean(dialog.querySelector('canvas')), focus: dialog.contains(document.activeElement) };
  dialog.close();
  await new Promise((resolve) => setTimeout(resolve, 60));
  return said && { ...said, hash: location.hash };`;

const click = (selector) => `document.querySelector(${JSON.stringify(selector)}).dispatchEvent(new MouseEvent('click', { bubbles: true, cancelable: true }));` + isOpen;

async function checkPage(browser, check, page, name, runs) {
  const began = performance.now();
  await browser.go('file://' + resolve(page));
  await browser.run(ready);
  console.log(`test-pages: report of ${name}: ${(statSync(page).size / 2 ** 20).toFixed(2)} MiB, ready after ${((performance.now() - began) / 1000).toFixed(1)} s`);
  for (const { id, marks, bad, summary } of await browser.run(figures)) {
    check(`${name}: ${id} is drawn`, marks.length > 0 && marks.every((count) => count > 2), marks);
    check(`${name}: ${id} has no number that is none`, !bad && !/NaN|undefined/.test(summary), summary);
  }
  check(`${name}: a card for each champion`, await browser.run(`return document.querySelectorAll('.card').length`) === runs);
  check(`${name}: a champion moves`, await browser.run(moves));
  const champion = await browser.run(click('.card a'));
  check(`${name}: a card opens its champion`, champion && champion.numbers > 10 && champion.focus && champion.command.startsWith('planula replay '), champion);
  const point = await browser.run(click('#figure-exploration svg a'));
  check(`${name}: a point opens the individual`, point && /--generation \d+ --slot \d+$/.test(point.command) && point.numbers > 10, point);
  check(`${name}: closing the window leaves the address clean`, point && point.hash === '', point);
  const links = await browser.run(`return [...document.querySelectorAll('nav a')].map((link) => [link.getAttribute('href'), Boolean(document.querySelector(link.getAttribute('href')))])`);
  check(`${name}: the contents lead to sections`, links.length > 8 && links.every(([, leads]) => leads), links);
  check(`${name}: every table opens and has rows`, await browser.run(`
    for (const details of document.querySelectorAll('details')) details.open = true;
    await new Promise((resolve) => setTimeout(resolve, 300));
    return [...document.querySelectorAll('table')].every((table) => table.rows.length > 1)`));
  check(`${name}: it is not wider than a phone`, await browser.run(`return document.documentElement.scrollWidth <= innerWidth + 1`));
  check(`${name}: no request leaves the page`, await browser.run(`return performance.getEntriesByType('resource').every((entry) => /^(blob|data):/.test(entry.name))`));
  const errors = await browser.errors();
  check(`${name}: the console is silent`, errors.length === 0, errors);
}

/** A page whose address names a run opens its champion, whose recording plays. */
async function checkAddress(browser, check, page) {
  await browser.go('about:blank');
  await browser.go(`file://${resolve(page)}#run/osc-te-neat/3`);
  await browser.run(ready);
  await browser.run(`for (let i = 0; i < 250 && !document.querySelector('dialog canvas'); ++i) await new Promise((resolve) => setTimeout(resolve, 20));`);
  const opened = await browser.run(isOpen);
  check('an address opens its champion', opened && opened.canvas && opened.title.includes('seed 3'), opened);
  const printed = await browser.run(`
    dispatchEvent(new Event('beforeprint'));
    const widths = [...document.querySelectorAll('figure')].map((figure) => Math.max(0, ...[...figure.querySelectorAll('.picture svg')].map((svg) => svg.width.baseVal.value)));
    dispatchEvent(new Event('afterprint'));
    return widths;`);
  check('on paper every figure is drawn, also those that were not seen yet', printed.length > 8 && printed.every((width) => width > 0 && width <= 680), printed);
}

/** The keyboard alone: from point to point of a map, and into the individual. */
async function checkKeyboard(browser, check) {
  const reached = await browser.run(`
    const map = document.querySelector('#figure-exploration svg'), links = [...map.querySelectorAll('a')];
    const stops = links.filter((link) => link.getAttribute('tabindex') === '0').length;
    links[0].focus();
    document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }));
    const label = document.activeElement.querySelector('[aria-label]')?.getAttribute('aria-label') ?? '';
    return { stops, moved: document.activeElement === links[1], label }`);
  check('keyboard: a map is one stop, arrows go on', reached.stops === 1 && reached.moved, reached);
  check('keyboard: a point says what it is', /generation .*fitness/.test(reached.label), reached);
  const unnamed = await browser.run(`return [...document.querySelectorAll('button, a, input, [role=region], nav, section, figure .picture')].filter((element) =>
    !(element.textContent.trim() || element.getAttribute('aria-label') || element.labels?.length || element.querySelector?.('[aria-label]'))).length`);
  check('keyboard: everything that can be used has a name', unnamed === 0, unnamed);
}

const script = 'experiments/paper/replication.lua'; // the one of today: the runs keep an older one

export async function test({ browser, planula, folder, check }) {
  const all = planula('report', 'data/runs/replication', '--seeds', '1:3', '--script', script, '--out', join(folder, 'all')).trim();
  await checkPage(browser, check, all, 'all runs', 24);
  await checkKeyboard(browser, check);
  await checkAddress(browser, check, all);
  const one = planula('report', 'data/runs/replication/osc-te-ns/seed-002', '--script', script, '--out', join(folder, 'one')).trim();
  await checkPage(browser, check, one, 'one run', 1);
}
