// SPDX-License-Identifier: MIT
// Runs machine.cpp and lists what it found.

const at = (id) => document.getElementById(id);
const { instance: { exports: wasm } } = await WebAssembly.instantiateStreaming(fetch('machine.wasm'));
const rows = [];
const start = performance.now();
for (let part = 0, length; (length = wasm.run_part(part)) >= 0; ++part) {
  const text = new TextDecoder().decode(new Uint8Array(wasm.memory.buffer, wasm.text_at(), length));
  for (const line of text.trim().split('\n')) rows.push(line.split(' '));
}
const seconds = (performance.now() - start) / 1000;
for (const [name, digest, isGolden] of rows) {
  const row = at('rows').tBodies[0].insertRow();
  for (const cell of [name, digest, isGolden === '1' ? 'yes' : 'NO']) row.insertCell().textContent = cell;
}
const golden = rows.filter(([, , isGolden]) => isGolden === '1').length;
const system = navigator.userAgentData?.platform || navigator.platform || 'an unknown system';
const browser = /(Firefox|Edg|OPR|Chrome|Version)\/[\d.]+/.exec(navigator.userAgent)?.[0] ?? 'a browser';
const card = `detent on ${system}, ${browser}: ${golden} of ${rows.length} queries have the golden digests`
  + ` (${seconds.toFixed(2)} s, WebAssembly)`;
at('card').textContent = card;
at('card').classList.toggle('bad', golden !== rows.length);
at('copy').addEventListener('click', async () => {
  const isCopied = await navigator.clipboard.writeText(card).then(() => true, () => false);
  at('copy').textContent = isCopied ? 'Copied' : 'Not allowed here';
});
window.machine = { golden, count: rows.length };
