// SPDX-License-Identifier: MIT
//
// usage: node relay.mjs [--port N] [--page FOLDER] [--open]
// Serves the page, and passes packets between the players of a room, two or four. A packet that comes
// in begins with the number of the player that it is for; one that goes out, of the one who sent it.
// The relay reads nothing else: whatever it loses, changes or makes up, the peers notice.
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
  const room = rooms.get(name) ?? {
    seats: [], isPlaying: false,
    size: searchParams.get('players') === '4' ? 4 : 2, seed: searchParams.get('seed')?.slice(0, 20) ?? '1',
  };
  if (room.isPlaying) {
    socket.send(JSON.stringify({ is: 'full' }));
    return socket.close(1008, 'full');
  }
  rooms.set(name, room);
  room.seats.push(socket);
  const say = (what) => room.seats.forEach((seat, self) => seat?.send(JSON.stringify({ ...what, self, players: room.size })));
  const sayWhoIsHere = () => say({ is: 'waiting', here: room.seats.length });
  socket.on('message', (data, isBinary) => {
    if (!isBinary || !room.isPlaying) return;
    const other = room.seats[data[0]];
    if (!other || other === socket || other.bufferedAmount > 65536) return;
    data[0] = room.seats.indexOf(socket);
    other.send(data);
  });
  socket.on('error', () => socket.terminate());
  socket.on('close', () => {
    const who = room.seats.indexOf(socket);
    // A seat is used once: nobody can join a match that runs.
    if (room.isPlaying) room.seats[who] = null;
    else room.seats.splice(who, 1);
    if (!room.seats.some((seat) => seat)) rooms.delete(name);
    else if (room.isPlaying) say({ is: 'left', who });
    else sayWhoIsHere();
  });
  room.isPlaying = room.seats.length === room.size;
  if (room.isPlaying) say({ is: 'start', seed: room.seed });
  else sayWhoIsHere();
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
