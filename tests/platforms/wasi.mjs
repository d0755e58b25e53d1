// SPDX-License-Identifier: MIT
//
// usage: node --no-warnings wasi.mjs PROGRAM.wasm [ARGUMENT...]
// Runs a WebAssembly program built for WASI and exits with its status.

import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';

const program = process.argv[2];
const wasi = new WASI({ version: 'preview1', args: process.argv.slice(2), returnOnExit: true });
const module = new WebAssembly.Module(readFileSync(program));
const instance = new WebAssembly.Instance(module, {
  wasi_snapshot_preview1: wasi.wasiImport,
});
process.exitCode = wasi.start(instance);
