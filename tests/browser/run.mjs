// SPDX-License-Identifier: MIT
// node run.mjs PLANULA FOLDER TEST...: opens pages in headless Chromium, as tests/browser/TEST.mjs says, which exports
//
//   async function test({ browser, planula, folder, check })
//     browser              tests/browser/browser.mjs
//     planula(words…)      runs a command and returns what it prints
//     folder               for the pages, empty at first
//     check(name, holds, detail)
//
// The last line counts the checks.
import { execFileSync } from 'node:child_process';
import { mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { openBrowser } from './browser.mjs';

const [program, folder, ...tests] = process.argv.slice(2);
let passed = 0, failed = 0;

for (const name of tests) {
  const own = join(folder, name);
  rmSync(own, { recursive: true, force: true });
  mkdirSync(own, { recursive: true });
  const check = (what, holds, detail = '') => {
    if (holds) return ++passed;
    ++failed;
    console.log(`test-pages: ${name}: ${what}${detail === '' ? '' : `: ${typeof detail === 'string' ? detail : JSON.stringify(detail)}`}`);
  };
  const browser = await openBrowser();
  try {
    const { test } = await import(`./${name}.mjs`);
    await test({ browser, folder: own, check, planula: (...words) => execFileSync(program, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] }) });
  } catch (error) {
    check('ends without an error', false, error.stack);
  } finally {
    await browser.close();
  }
}
console.log(`test-pages: ${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
