// SPDX-License-Identifier: MIT
//
// usage: node relay.mjs [--port N] [--page FOLDER] [--open]
// Serves the page, and passes packets between the two players of a room. It reads none of them:
// whatever it loses, changes or makes up, the peers notice.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { WebSocketServer } from 'ws';

const { values } = parseArgs({
  options: {
    port: { type: 'string', default: '8080' },
    page: { type: 'string', default: fileURLToPath(new URL('page', import.meta.url)) },
    open: { type: 'boolean', default: false },
  },
});

const types = {
  '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};
const server = createServer(async (request, response) => {
  const path = normalize(decodeURIComponent(new URL(request.url, 'http://here').pathname));
  const name = path.endsWith('/') ? `${path}index.html` : path;
  try {
    const body = await readFile(join(values.page, name));
    response.writeHead(200, { 'content-type': types[extname(name)] ?? 'application/octet-stream', 'cache-control': 'no-cache' });
    response.end(body);
  } catch {
    response.writeHead(404).end('not found');
  }
});

const rooms = new Map();
const relay = new WebSocketServer({ server, maxPayload: 2048, perMessageDeflate: false });
relay.on('connection', (socket, request) => {
  const { pathname, searchParams } = new URL(request.url, 'http://here');
  const name = /\/room\/([0-9a-z]{1,32})$/.exec(pathname)?.[1];
  if (!name) return socket.close(1008, 'no room');
  const room = rooms.get(name) ?? { players: [], seed: searchParams.get('seed')?.slice(0, 20) ?? '1' };
  if (room.players.length === 2) {
    socket.send(JSON.stringify({ is: 'full' }));
    return socket.close(1008, 'full');
  }
  rooms.set(name, room);
  room.players.push(socket);
  const others = () => room.players.filter((player) => player !== socket);
  socket.on('message', (data, isBinary) => {
    if (!isBinary) return;
    for (const other of others()) if (other.bufferedAmount < 65536) other.send(data);
  });
  socket.on('error', () => socket.terminate());
  socket.on('close', () => {
    for (const other of others()) other.send(JSON.stringify({ is: 'left' }));
    // A room is used once: nobody can join a match that runs.
    room.players.forEach((player) => player !== socket && player.close());
    rooms.delete(name);
  });
  if (room.players.length < 2) return;
  room.players.forEach((player, self) => player.send(JSON.stringify({ is: 'start', self, seed: room.seed })));
});

server.on('error', (error) => {
  console.error(`relay: ${error.message}`);
  process.exit(1);
});
server.listen(Number(values.port), () => {
  const address = `http://localhost:${server.address().port}/`;
  console.log(address);
  if (!values.open || !(process.env.DISPLAY || process.env.WAYLAND_DISPLAY)) return;
  import('node:child_process').then(({ spawn }) => {
    spawn('xdg-open', [address], { stdio: 'ignore', detached: true }).on('error', () => {}).unref();
  });
});
