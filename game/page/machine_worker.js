// SPDX-License-Identifier: MIT
// Runs one module of the corpus. Sends a message for each group and one at the end, or the digest
// of all digests of queries.

const fromText = (text) => text.split('\n').map((line) => line.split(' '));

onmessage = async ({ data: { name, version, isFull, digests } }) => {
  try {
    const response = await fetch(`corpus/${name}.wasm?${version}`);
    if (!response.ok) throw new Error(`corpus/${name}.wasm cannot be loaded`);
    const { instance: { exports: wasm } } = await WebAssembly.instantiateStreaming(response);
    const text = (length) => new Uint8Array(wasm.memory.buffer, wasm.text_at(), length);
    if (digests) {
      const bytes = new DataView(wasm.memory.buffer, wasm.text_at());
      digests.forEach((digest, i) => bytes.setBigUint64(8 * i, BigInt(`0x${digest}`), true));
      const all = BigInt.asUintN(64, wasm.digest_of(digests.length)).toString(16).padStart(16, '0');
      return postMessage({ all });
    }
    const groups = wasm.group_count();
    for (let group = 0; group < groups; ++group) {
      const length = wasm.run_group(group, isFull ? 1 : 0);
      const rows = fromText(new TextDecoder().decode(text(length)).trimEnd());
      postMessage({ cell: wasm.first_cell_of(group), rows, groups });
    }
    postMessage({ total: wasm.row_count() });
  } catch (error) {
    postMessage({ error: error.message });
  }
};
