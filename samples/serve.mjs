// SPDX-License-Identifier: MIT
//
// usage: node serve.mjs FOLDER [--port N]
// Serves the page and prints its address.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve } from 'node:path';
import { parseArgs } from 'node:util';

function refuse(why) {
  console.error(`serve: ${why}`);
  process.exit(2);
}
function options() {
  try {
    return parseArgs({ allowPositionals: true, options: { port: { type: 'string', default: '8081' } } });
  } catch (error) {
    return refuse(error.message.split('. ')[0]);
  }
}
const { values, positionals } = options();
if (positionals.length !== 1) refuse('name one folder');
const folder = resolve(positionals[0]), port = Number(values.port);
if (!/^\d+$/.test(values.port) || port > 65535) {
  refuse(`'${values.port}' is no port; write a number from 0 to 65535`);
}
const types = {
  '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.png': 'image/png',
  '.wasm': 'application/wasm', '.cpp': 'text/plain; charset=utf-8',
};
const server = createServer(async (request, response) => {
  try {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://here').pathname));
    const name = path.endsWith('/') ? `${path}index.html` : path;
    const body = await readFile(join(folder, name));
    response.writeHead(200, { 'content-type': types[extname(name)] ?? 'application/octet-stream', 'cache-control': 'no-cache' });
    response.end(body);
  } catch {
    response.writeHead(404).end('not found');
  }
});
server.on('error', (error) => refuse(`${error.message}; choose another --port`));
server.listen(port, '127.0.0.1', () => console.log(`http://localhost:${server.address().port}/`));
