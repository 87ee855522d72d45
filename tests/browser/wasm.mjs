// SPDX-License-Identifier: MIT
// The champions of all settings of the replication in pages with the module of `make wasm`: each is simulated again in
// the browser and compared by its hash, each slider makes another life, and the recorded one comes back. Without network.
import { readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';

const runs = 'data/runs/replication', module = 'build/wasm/planula.js';

// Runs in the page: clicks or moves a slider, waits for the verdict, and tells what the page shows then.
const use = `
  const [what] = args, laboratory = document.querySelector('.pl-laboratory');
  const verdict = laboratory.querySelector('.pl-verdict'), before = verdict.className, hash = laboratory.querySelectorAll('code')[1];
  let frames = 0, counts = true;
  (function count() { ++frames; if (counts) requestAnimationFrame(count); })();
  const began = performance.now();
  verdict.textContent = '';
  if (what === 'again') laboratory.querySelector('button').click();
  else {
    const slider = laboratory.querySelector('[aria-label="' + what + '"]');
    slider.value = 1;
    slider.dispatchEvent(new Event('input'));
    slider.dispatchEvent(new Event('change'));
  }
  while (!verdict.textContent) await new Promise((resolve) => setTimeout(resolve, 2));
  counts = false;
  return {
    verdict: verdict.className.replace('pl-verdict ', ''), words: verdict.textContent, life: hash.textContent, frames,
    milliseconds: performance.now() - began, title: document.querySelector('h1').textContent,
    recorded: laboratory.querySelector('code').textContent,
    sliders: [...laboratory.querySelectorAll('input')].map((input) => input.getAttribute('aria-label')),
    played: document.querySelector('footer code').textContent,
    requests: performance.getEntriesByType('resource').map((entry) => entry.name).filter((name) => !/^(blob|data):/.test(name)),
  };`;

async function tryPage(browser, check, file, setting) {
  const demand = (what, holds, detail) => check(`${setting}: ${what}`, holds, detail);
  await browser.go('file://' + resolve(file));
  await browser.run(`while (!document.querySelector('.pl-laboratory')) await new Promise((resolve) => setTimeout(resolve, 20));`);
  const first = await browser.run(use, 'again'), second = await browser.run(use, 'again');
  for (const seen of [first, second]) {
    demand('the life is equal', seen.verdict === 'equal' && seen.life === seen.recorded && seen.life.length === 64, seen.words);
    demand('the viewer plays it', seen.played === seen.recorded, seen.played);
  }
  demand('the page goes on while it waits', first.frames > 1, first.frames);
  await browser.screenshot(file.replace('.html', '-equal.png'));
  for (const slider of first.sliders) {
    const changed = await browser.run(use, slider);
    demand(slider + ' makes another life, and says so', changed.verdict === 'changed' && changed.words.includes(slider) &&
      changed.life !== changed.recorded && changed.played === changed.life, changed.words);
    demand(slider + ' is named in the viewer', changed.title.startsWith('Not the recorded life'), changed.title);
  }
  await browser.screenshot(file.replace('.html', '-changed.png'));
  const back = await browser.run(use, 'again'), errors = await browser.errors();
  demand('the recorded life comes back', back.verdict === 'equal' && !back.title.startsWith('Not'), back.words);
  demand('the console is silent', errors.length === 0, errors);
  demand('nothing is asked for', back.requests.length === 0, back.requests);
  console.log(`${setting}: ${first.life.slice(0, 12)}… equal; ${first.words.match(/\d+ ms/)}, then ${second.words.match(/\d+ ms/)}; ` +
    `the first click took ${first.milliseconds.toFixed(0)} ms; sliders: ${first.sliders.join(', ')}`);
}

export async function test({ browser, planula, folder, check }) {
  for (const setting of readdirSync(runs).sort()) {
    const file = join(folder, setting + '.html');
    planula('replay', join(runs, setting, 'seed-001'), '--html', file, '--module', module);
    await tryPage(browser, check, file, setting);
  }
}
