// SPDX-License-Identifier: MIT
// node module_test.mjs MODULE < CASES: simulates the cases of module_cases again by the module of scripting/wasm, and
// compares the hashes of each life and of its recording with those of the program. Prints each that differs, then how
// many were equal, with time and memory; exits 1 if one differs.
import { createHash } from 'node:crypto';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { createInterface } from 'node:readline';

const makeModule = createRequire(import.meta.url)(resolve(process.argv[2]));
let module = await makeModule(), equal = 0, different = 0, milliseconds = 0, longest = 0;

function simulate({ genome, conditions }) {
  try {
    return module.ccall('simulate', 'string', ['string', 'string', 'number'], [genome, conditions, 0]);
  } catch (error) {
    if (typeof error !== 'number') throw error;
    return 'error: ' + module.ccall('message_of', 'string', ['number'], [error]);
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  const known = JSON.parse(line), began = performance.now(), text = simulate(known), time = performance.now() - began;
  const life = text.startsWith('error') ? text : JSON.parse(text).life;
  const recording = createHash('sha256').update(text).digest('hex');
  if (life === known.life && recording === known.recording) ++equal;
  else {
    ++different;
    console.log(`module: ${known.name}: ${life === known.life ? 'the recording differs' : `life ${life}, not ${known.life}`}`);
  }
  milliseconds += time;
  longest = Math.max(longest, time);
}

// A mistake must arrive as a message.
const message = simulate({ genome: 'inputs nine\n', conditions: '' });
if (message !== "error: line 1: 'nine' is not a whole number") {
  ++different;
  console.log('module: a wrong genome gives ' + message);
}
const megabytes = (bytes) => (bytes / 2 ** 20).toFixed(0) + ' MiB';
console.log(`module: ${equal} lives equal to the bit, ${different} different; ${(milliseconds / 1000).toFixed(1)} s, ` +
  `longest ${longest.toFixed(0)} ms; memory ${megabytes(module.HEAP8.length)}`);
process.exit(equal > 0 && different === 0 ? 0 : 1);
