// SPDX-License-Identifier: MIT
// Bundles the scripts of a report with the packages that they use, and lists the licences of what is in the bundle:
// report.js, report.css and licences.txt in the folder OUT, where planula report looks for them.
//
//   node build.mjs OUT
import { build } from 'esbuild';
import { copyFileSync, existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const out = process.argv[2];
const { metafile } = await build({
  entryPoints: ['main.js'], outfile: join(out, 'report.js'), bundle: true, minify: true, format: 'iife', target: 'es2022', charset: 'utf8',
  legalComments: 'none', metafile: true, logLevel: 'warning',
});
copyFileSync('report.css', join(out, 'report.css'));

// A package is in the bundle if a byte of it is.
const inputs = Object.entries(Object.values(metafile.outputs)[0].inputs).filter(([, { bytesInOutput }]) => bytesInOutput > 0);
const folders = [...new Set(inputs.map(([file]) => file.match(/^.*node_modules\/((@[^/]+\/)?[^/]+)/)?.[0]).filter(Boolean))].sort();
const licences = folders.map((folder) => {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json')));
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  if (!file || !existsSync(join(folder, file))) throw new Error(`${name} has no file with its licence`);
  return `${name} ${version} (${license})\n\n${readFileSync(join(folder, file), 'utf8').trim()}\n`;
});
writeFileSync(join(out, 'licences.txt'), licences.join(`\n${'-'.repeat(72)}\n\n`));
