// SPDX-License-Identifier: MIT
// usage: node browser.mjs CHROMIUM FOLDER
// Plays the match in a browser with the modules in FOLDER and prints its digest.

import { spawn } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

const [, , chromium, folder] = process.argv;
const page = `<!doctype html><script type="module">
  const say = (text) => fetch('/said', { method: 'POST', body: text });
  addEventListener('error', (event) => say('error: ' + event.message));
  addEventListener('unhandledrejection', (event) => say('error: ' + event.reason));
  const { play } = await import('/examples/match.mjs');
  await say(await play());
</script>`;
const types = { mjs: 'text/javascript', wasm: 'application/wasm' };

const profile = await mkdtemp(join(tmpdir(), 'detent-browser-'));
let browser;
const finish = async (text, code) => {
  console.log(text);
  browser.kill();
  await new Promise((done) => setTimeout(done, 300));
  await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  process.exit(code);
};
const server = createServer(async (request, response) => {
  const path = new URL(request.url, 'http://localhost').pathname;
  if (path === '/said') {
    let text = '';
    for await (const part of request) text += part;
    response.end();
    await finish(text, text.startsWith('error') ? 1 : 0);
  } else if (path === '/') {
    response.writeHead(200, { 'content-type': 'text/html' }).end(page);
  } else {
    try {
      const name = path.startsWith('/examples/') ? join('examples', basename(path)) : basename(path);
      const bytes = await readFile(join(folder, name));
      response.writeHead(200, { 'content-type': types[path.split('.').pop()] }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  }
});
server.listen(0, '127.0.0.1', () => {
  const address = `http://127.0.0.1:${server.address().port}/`;
  browser = spawn(chromium, ['--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${profile}`,
    address], { stdio: 'ignore' });
});
setTimeout(() => finish('error: the browser says nothing', 1), 100_000);
