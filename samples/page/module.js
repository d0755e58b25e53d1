// SPDX-License-Identifier: MIT
//
// The samples as WebAssembly, for the page and check.mjs. `load` takes the bytes of samples.wasm.

export const Key = { left: 1, right: 2, up: 4, down: 8, action: 16 };

export async function load(bytes) {
  // The compiler's library imports functions to write messages and exit, which the samples never
  // call.
  const system = new Proxy({}, { get: (_, name) => () => { throw new Error(`the samples called ${name}`); } });
  const module = await WebAssembly.compile(bytes);
  const { exports: wasm } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: system });
  wasm._initialize?.();

  const text = (at) => {
    const memory = new Uint8Array(wasm.memory.buffer);
    return new TextDecoder().decode(memory.slice(at, memory.indexOf(0, at)));
  };
  const samples = Array.from({ length: wasm.count() }, (_, i) => (
    { index: i, name: text(wasm.name(i)), sentence: text(wasm.sentence(i)), keys: text(wasm.keys(i)) }));
  return {
    samples,
    start: (sample) => wasm.start(sample.index),
    step: ({ keys = 0, pointer = null } = {}) => wasm.step(keys, pointer ? 1 : 0, pointer?.x ?? 0, pointer?.y ?? 0),
    digest: () => BigInt.asUintN(64, wasm.digest()).toString(16).padStart(16, '0'),
    status: () => text(wasm.status()),
    // The bytes of the vertices, valid until the next call.
    draw(aspect) {
      wasm.draw();
      const matrix = wasm.matrix(aspect), { buffer } = wasm.memory;
      return {
        matrix: new Float32Array(buffer, matrix, 16),
        triangles: new Uint8Array(buffer, wasm.triangles(), 16 * wasm.triangle_vertices()),
        lines: new Uint8Array(buffer, wasm.lines(), 16 * wasm.line_vertices()),
      };
    },
  };
}
