// SPDX-License-Identifier: MIT
// A report of the tracked runs with the module of `make wasm`: the champion of each of the eight settings is opened,
// simulated again in the browser and compared by its hash; a slider makes another life, which is marked. Without network.
// A report without the module has none of this.
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';

const runs = 'data/runs/replication', module = 'build/wasm/planula.js', script = 'experiments/paper/replication.lua';

// Runs in the page: opens a champion, simulates it, moves a slider, simulates it as recorded again, and closes it.
const use = `
  const [setting] = args, soon = () => new Promise((resolve) => setTimeout(resolve, 5));
  const dialog = document.querySelector('dialog');
  location.hash = '#run/' + setting + '/1';
  while (!dialog.querySelector('.pl-laboratory')) await soon();
  const laboratory = dialog.querySelector('.pl-laboratory'), verdict = laboratory.querySelector('.pl-verdict');
  const [recorded, hash] = laboratory.querySelectorAll('code'), slider = laboratory.querySelector('input');
  const after = async (act) => {
    verdict.textContent = '';
    act();
    while (!verdict.textContent) await soon();
    const header = dialog.querySelector('.stage header');
    return { verdict: verdict.className.replace('pl-verdict ', ''), words: verdict.textContent, life: hash.textContent,
      played: dialog.querySelector('.stage footer code').textContent, isMarked: header.offsetHeight > 0 && /^Not the recorded life/.test(header.textContent) };
  };
  const again = laboratory.querySelector('button');
  const equal = await after(() => again.click());
  const changed = await after(() => { slider.value = 1; slider.dispatchEvent(new Event('input')); slider.dispatchEvent(new Event('change')); });
  const back = await after(() => again.click());
  dialog.close();
  await soon();
  return { recorded: recorded.textContent, equal, changed, back, slider: slider.getAttribute('aria-label') };`;

async function tryChampion(browser, check, setting) {
  const { recorded, equal, changed, back, slider } = await browser.run(use, setting);
  const demand = (what, holds, detail) => check(`${setting}: ${what}`, holds, detail);
  demand('the life is equal', equal.verdict === 'equal' && recorded.length === 64 && equal.life === recorded, equal);
  demand('it is played, and not marked', equal.played === recorded && !equal.isMarked, equal);
  demand(`${slider} makes another life, which is marked`, changed.verdict === 'changed' && changed.life !== recorded && changed.played === changed.life && changed.isMarked, changed);
  demand('the recorded life comes back', back.verdict === 'equal' && back.played === recorded && !back.isMarked, back);
  return recorded;
}

export async function test({ browser, planula, folder, check }) {
  const report = (...words) => planula('report', runs, '--seeds', '1', '--script', script, ...words).trim();
  const page = report('--out', join(folder, 'with'), '--module', module);
  console.log(`test-pages: report with the module: ${(statSync(page).size / 2 ** 20).toFixed(2)} MiB`);
  await browser.go('file://' + resolve(page));
  await browser.run(`while (!('ready' in document.documentElement.dataset)) await new Promise((resolve) => setTimeout(resolve, 20));`);
  const lives = new Set(), settings = readdirSync(runs).sort();
  for (const setting of settings) lives.add(await tryChampion(browser, check, setting));
  check('each setting has a life of its own', lives.size === settings.length && settings.length === 8, [...lives]);
  check('no request leaves the page', await browser.run(`return performance.getEntriesByType('resource').every((entry) => /^(blob|data):/.test(entry.name))`));
  const errors = await browser.errors();
  check('the console is silent', errors.length === 0, errors.map((error) => error.slice(0, 200)));
  const plain = readFileSync(report('--out', join(folder, 'without')), 'utf8');
  check('a report without the module allows no WebAssembly', !plain.includes('id="module"') && !/wasm-unsafe-eval|worker-src/.test(plain));
}
