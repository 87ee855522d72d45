// SPDX-License-Identifier: MIT
// Replays in a browser, of a swimmer with oscillators and a walker with gene networks: they grow and move, cells and
// nodes can be chosen by mouse and keyboard, what is written agrees with the run, and the page asks for nothing.
import { statSync } from 'node:fs';
import { join, resolve } from 'node:path';

const ready = `while (!globalThis.planula?.replay) await new Promise((resolve) => setTimeout(resolve, 20)); planula.replay.pause();`;
const picture = `document.querySelector('canvas').toDataURL()`;
const text = (selector) => `document.querySelector('${selector}').textContent`;

/** Whether something is drawn: not one colour all over. */
const drawn = `
  const canvas = document.querySelector('canvas'), { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const colours = new Set();
  for (let at = 0; at < data.length; at += 4 * 97) colours.add(data[at] << 16 | data[at + 1] << 8 | data[at + 2]);
  return colours.size;`;

async function checkTime(browser, check, name) {
  const seen = await browser.run(`
    const seen = {};
    for (const step of [0, 300, 600, 2600, 1e9]) {
      planula.replay.seek(step);
      seen[step] = { picture: ${picture}, time: ${text('.pl-time')}, badge: ${text('.pl-badge')}, label: document.querySelector('canvas').getAttribute('aria-label') };
    }
    return { ...seen, cells: document.querySelectorAll('dd')[1].textContent, distance: document.querySelectorAll('dd')[2].textContent };`);
  check(`${name}: it grows`, seen[0].picture !== seen[300].picture && seen[0].badge === '1 cell', seen[0].badge);
  check(`${name}: it moves`, seen[600].picture !== seen[2600].picture);
  check(`${name}: steps are told`, seen[300].time === 'Growth, step 300 of 600 (3.0 t.u.)' && seen[2600].time === 'Gait, step 2000 of 4000 (20.0 t.u.)', seen[2600].time);
  // The path that is drawn ends where the life ended.
  const end = seen[1e9].badge.match(/^(\d+) cells, ([\d.]+) cells from rest$/);
  check(`${name}: it ends where the record says`, end && end[1] === seen.cells && Math.abs(end[2] - parseFloat(seen.distance)) < 0.015, [seen[1e9].badge, seen.distance]);
  check(`${name}: the picture has words`, seen[2600].label.startsWith('Gait, step 2000 of 4000'), seen[2600].label);
  const plays = await browser.run(`
    planula.replay.seek(700); planula.replay.speed(8); planula.replay.play();
    await new Promise((resolve) => setTimeout(resolve, 1500));
    planula.replay.pause(); return ${text('.pl-time')};`);
  check(`${name}: it plays`, plays !== 'Gait, step 100 of 4000 (1.0 t.u.)', plays);
}

async function checkChoices(browser, check, name) {
  const found = await browser.run(`
    planula.replay.seek(1600);
    const canvas = document.querySelector('canvas'), before = ${picture}, first = ${text('.pl-cell h2')};
    const select = [...document.querySelectorAll('select')].find((each) => [...each.options].some((option) => option.value === 'pressure'));
    const pictures = [before];
    for (const value of ['pressure', 'birth', 'none', 'node 12']) {
      select.value = value; select.dispatchEvent(new Event('change'));
      pictures.push(${picture});
    }
    document.querySelectorAll('.node')[3].dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }));
    const byNode = select.value;
    // Somewhere in the picture is a cell that a click chooses.
    let chosen = first;
    for (let x = 0.2; x < 0.8 && chosen === first; x += 0.01)
      for (let y = 0.2; y < 0.9 && chosen === first; y += 0.02) {
        const box = canvas.getBoundingClientRect();
        canvas.dispatchEvent(new MouseEvent('click', { clientX: box.left + x * box.width, clientY: box.top + y * box.height, bubbles: true }));
        chosen = ${text('.pl-cell h2')};
      }
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: ']', bubbles: true }));
    const next = ${text('.pl-cell h2')};
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'Home', bubbles: true }));
    const home = ${text('.pl-time')};
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: ' ', bubbles: true }));
    const label = document.querySelector('.pl-play').getAttribute('aria-label');
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: ' ', bubbles: true }));
    return { different: new Set(pictures).size, byNode, first, chosen, next, home, label, values: document.querySelectorAll('.value').length,
      links: document.querySelectorAll('.pl-picture path').length };`);
  check(`${name}: every colouring is another picture`, found.different === 5, found.different);
  check(`${name}: a node colours the cells`, found.byNode === 'node 3', found.byNode);
  check(`${name}: a click chooses a cell`, found.chosen !== found.first, found.chosen);
  check(`${name}: the keyboard chooses the next`, found.next !== found.chosen, found.next);
  check(`${name}: the keyboard goes to the beginning and plays`, found.home.startsWith('Growth, step 0 ') && found.label === 'Pause', found);
  check(`${name}: the network is drawn`, found.links > 20 && found.values >= 14, found);
}

async function checkPage(browser, check, page, name) {
  const began = performance.now();
  await browser.go('file://' + resolve(page));
  await browser.run(ready);
  const size = statSync(page).size;
  console.log(`test-pages: replay of ${name}: ${(size / 2 ** 10).toFixed(0)} KiB, ready after ${((performance.now() - began) / 1000).toFixed(1)} s`);
  check(`${name}: it is small`, size < 2 * 2 ** 20, size);
  check(`${name}: something is drawn`, await browser.run(drawn) > 5);
  check(`${name}: the life has a hash`, /^life [0-9a-f]{64}$/.test(await browser.run(`return ${text('.pl-hash')}`)));
  await checkTime(browser, check, name);
  await checkChoices(browser, check, name);
  const unnamed = await browser.run(`return [...document.querySelectorAll('button, input, select, canvas, [role=button]')].filter((element) =>
    !(element.textContent.trim() || element.getAttribute('aria-label') || element.labels?.length)).length`);
  check(`${name}: everything that can be used has a name`, unnamed === 0, unnamed);
  check(`${name}: it is not wider than the window`, await browser.run(`return document.documentElement.scrollWidth <= innerWidth + 1`));
  check(`${name}: no request leaves the page`, await browser.run(`return performance.getEntriesByType('resource').every((entry) => /^(blob|data):/.test(entry.name))`));
  const errors = await browser.errors();
  check(`${name}: the console is silent`, errors.length === 0, errors);
}

/** As galleries use it. */
async function checkCompact(browser, check) {
  const found = await browser.run(`
    const recording = await planula.unpack(document.getElementById('recording').textContent);
    const card = document.body.appendChild(document.createElement('div'));
    card.style.cssText = 'width: 200px; height: 140px';
    const player = planula.mountReplay(card, recording, { compact: true });
    const buttons = card.querySelectorAll('button').length, canvas = card.querySelector('canvas');
    player.seek(1000);
    const first = canvas.toDataURL();
    player.seek(1500);
    const second = canvas.toDataURL();
    player.destroy();
    return { buttons, moves: first !== second, left: card.children.length };`);
  check('compact: a picture and a button, and nothing left afterwards', found.buttons === 1 && found.moves && found.left === 0, found);
}

/** A life that ended in growth. */
async function checkDead(browser, check, page) {
  await browser.go('file://' + resolve(page));
  await browser.run(ready);
  const found = await browser.run(`
    planula.replay.seek(5); planula.replay.play();
    await new Promise((resolve) => setTimeout(resolve, 300));
    return { outcome: document.querySelector('dd').textContent, badge: ${text('.pl-badge')}, bad: /NaN/.test(document.body.innerHTML) };`);
  check('died out: it is shown as far as it went', found.outcome === 'died out' && /^\d+ cells?$/.test(found.badge) && !found.bad, found);
  const errors = await browser.errors();
  check('died out: the console is silent', errors.length === 0, errors);
}

export async function test({ browser, planula, folder, check }) {
  for (const [name, run] of [['a swimmer', 'osc-aq-ns'], ['a walker with gene networks', 'grn-te-ns']]) {
    const page = join(folder, run + '.html');
    planula('replay', `data/runs/replication/${run}/seed-001`, '--html', page);
    await checkPage(browser, check, page, name);
  }
  await checkCompact(browser, check);
  const page = join(folder, 'dead.html');
  planula('replay', 'data/runs/replication/osc-te-ns/seed-001', '--generation', '0', '--slot', '0', '--html', page);
  await checkDead(browser, check, page);
}
