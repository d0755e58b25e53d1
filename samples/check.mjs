// SPDX-License-Identifier: MIT
//
// usage: node check.mjs FOLDER
// Plays the samples of the page in FOLDER, without the page, and prints their digests as
// `detent-samples all --ticks 240` does.
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = resolve(process.argv[2]);
const { load } = await import(pathToFileURL(join(folder, 'module.js')));
const machine = await load(readFileSync(join(folder, 'samples.wasm')));
for (const sample of machine.samples) {
  machine.start(sample);
  for (let tick = 1; tick <= 240; ++tick) {
    machine.step();
    if (tick % 60 === 0) console.log(`${sample.name} ${tick} ${machine.digest()}`);
  }
  const { triangles, lines } = machine.draw(1.6);
  if (triangles.length + lines.length === 0) throw new Error(`${sample.name} draws nothing`);
}
