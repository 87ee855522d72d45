// SPDX-License-Identifier: MIT
// Headless Chromium for tests, by the WebDriver protocol (W3C Recommendation, 2018) and Node alone.
//
//   const browser = await openBrowser();     chromedriver and Chromium, with a profile of their own
//   await browser.go(address);
//   await browser.run('return document.title');      the text of a function; `await` works in it
//   await browser.errors();                  what the console said at the level of an error, since the last call
//   await browser.close();
import { spawn } from 'node:child_process';
import { writeFile } from 'node:fs/promises';
import { createInterface } from 'node:readline';

const chromium = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--window-size=1280,1400'];

/** The port on which a chromedriver that has just been started listens. */
async function portOf(driver) {
  for await (const line of createInterface({ input: driver.stdout })) {
    const [, port] = line.match(/started successfully on port (\d+)/) ?? [];
    if (port) return port;
  }
  throw new Error('chromedriver does not start');
}

export async function openBrowser(more = []) {
  const driver = spawn('chromedriver', ['--port=0'], { stdio: ['ignore', 'pipe', 'ignore'] });
  const root = `http://localhost:${await portOf(driver)}/session`;
  const ask = async (method, path, body) => {
    const answer = await fetch(root + path, { method, body: body && JSON.stringify(body) });
    const { value } = await answer.json();
    if (value?.error) throw new Error(value.message);
    return value;
  };
  const { sessionId } = await ask('POST', '', { capabilities: { alwaysMatch: {
    'goog:chromeOptions': { args: [...chromium, ...more] }, 'goog:loggingPrefs': { browser: 'ALL' }, timeouts: { script: 300000 },
  } } });
  const at = '/' + sessionId;
  return {
    go: (url) => ask('POST', at + '/url', { url }),
    async run(script, ...args) {
      const outcome = await ask('POST', at + '/execute/async', {
        script: `const done = arguments[arguments.length - 1], given = [...arguments].slice(0, -1);
          (async (...args) => { ${script} })(...given).then((value) => done({ value }), (error) => done({ error: String(error) }));`,
        args,
      });
      if (outcome.error) throw new Error(outcome.error);
      return outcome.value;
    },
    async errors() {
      const log = await ask('POST', at + '/se/log', { type: 'browser' });
      return log.filter((entry) => entry.level === 'SEVERE').map((entry) => entry.message);
    },
    async screenshot(file) {
      await writeFile(file, Buffer.from(await ask('GET', at + '/screenshot'), 'base64'));
    },
    async close() {
      await ask('DELETE', at).catch(() => {});
      driver.kill();
    },
  };
}
