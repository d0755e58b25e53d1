// SPDX-License-Identifier: MIT
// Runs the modules built from machine.cpp in workers and lists their results. They are large, so
// they are loaded on demand.

const at = (id) => document.getElementById(id);
const buttons = [at('quick'), at('whole')];
const machine = { isDone: false };  // for the tests
window.machine = machine;

// [{ name, version, bytes }], where bytes is the download size.
const list = await fetch('corpus/list.json').then((response) => (response.ok ? response.json() : []), () => []);
const bytes = list.reduce((sum, each) => sum + each.bytes, 0);
at('offer').textContent = list.length === 0 ? 'The corpus is not installed: ./dev play compiles it.'
  : `Both load ${(bytes / 1e6).toFixed(1)} MB, in ${list.length} part${list.length === 1 ? '' : 's'}, once, and then work offline.`;
for (const button of buttons) {
  button.disabled = list.length === 0;
  button.addEventListener('click', () => run(button === at('whole')));
}

// Calls take(what) with each message of a worker; the last one is the result.
function ask(question, take = () => {}) {
  return new Promise((done, fail) => {
    const worker = new Worker('machine_worker.js');
    const end = (settle, value) => {
      worker.terminate();
      settle(value);
    };
    worker.onerror = (event) => end(fail, new Error(event.message));
    worker.onmessage = ({ data }) => {
      if (data.error) end(fail, new Error(data.error));
      else if (data.rows) take(data);
      else end(done, data);
    };
    worker.postMessage(question);
  });
}

function showRows(groups) {
  at('rows').tBodies[0].replaceChildren(...groups.flatMap(({ rows }) => rows.map(([query, digest, wrong]) => {
    const row = document.createElement('tr');
    for (const text of [query, digest, wrong ? `NO, ${wrong.replace(',', ' ')}` : 'yes']) row.insertCell().textContent = text;
    row.className = wrong ? 'bad' : '';
    return row;
  })));
}

async function run(isFull) {
  for (const button of buttons) button.disabled = true;
  at('card').hidden = at('copy').hidden = at('share').hidden = true;
  machine.isDone = false;
  const groups = [], waiting = [...list], counts = new Map(), start = performance.now();
  let total = 0;
  showRows(groups);
  const work = async () => {
    for (let each; (each = waiting.shift());) {
      at('doing').textContent = `${each.name}…`;
      ({ total } = await ask({ ...each, isFull }, (group) => {
        counts.set(each.name, group.groups);
        groups.push(group);
        groups.sort((a, b) => a.cell - b.cell);
        const known = [...counts.values()].reduce((sum, count) => sum + count, 0);
        at('progress').max = known * list.length / counts.size;
        at('progress').value = Math.min(groups.length, at('progress').max);
        showRows(groups);
      }));
    }
  };
  try {
    await Promise.all(Array.from({ length: Math.min(4, navigator.hardwareConcurrency || 1) }, work));
    const seconds = (performance.now() - start) / 1000, rows = groups.flatMap((group) => group.rows);
    const golden = rows.filter(([, , wrong]) => !wrong).length;
    const { all } = rows.length < total ? { all: '' }
      : await ask({ ...list[0], digests: rows.map(([, digest]) => digest) });
    at('progress').value = at('progress').max;
    at('doing').textContent = '';
    showCard({ golden, count: rows.length, total, all, seconds, isFull });
    Object.assign(machine, { isDone: true, golden, count: rows.length, total, all });
  } catch (error) {
    at('doing').textContent = `Stopped: ${error.message}.`;
  }
  for (const button of buttons) button.disabled = false;
}

function showCard({ golden, count, total, all, seconds, isFull }) {
  const system = navigator.userAgentData?.platform || navigator.platform || 'an unknown system';
  const browser = /(Firefox|Edg|OPR|Chrome|Version)\/[\d.]+/.exec(navigator.userAgent)?.[0] ?? 'a browser';
  const lines = [
    `detent on ${system}, ${browser}, WebAssembly`,
    `${golden} of ${count} queries have the golden digests${golden === count ? '' : `; ${count - golden} DIFFER`}`,
    `${isFull ? 'All questions' : '64 questions of each kind'}, ${seconds.toFixed(1)} s`
      + (count < total ? `; ${total - count} queries were not run` : ''),
    ...(all ? [`all: ${all}`] : []),
  ];
  at('card').replaceChildren(...lines.map((line) => {
    const paragraph = document.createElement('p');
    paragraph.textContent = line;
    return paragraph;
  }));
  at('card').classList.toggle('bad', golden !== count);
  at('card').hidden = at('copy').hidden = false;
  at('share').hidden = !navigator.share;
  at('copy').textContent = 'Copy this card';
  at('copy').onclick = async () => {
    const isCopied = await navigator.clipboard.writeText(lines.join('\n')).then(() => true, () => false);
    at('copy').textContent = isCopied ? 'Copied' : 'Not allowed here';
  };
  at('share').onclick = () => navigator.share({ text: lines.join('\n') }).catch(() => {});
}
navigator.serviceWorker?.register('worker.js').catch(() => {});
