// SPDX-License-Identifier: MIT
//
// usage: node relay.mjs [--port N] [--page FOLDER] [--open]
// Serves the page and passes packets within a room: two or four players, and up to four spectators,
// who are numbered after them. The first byte of an incoming packet is its recipient; of an
// outgoing packet, its sender. The relay reads nothing else. Peers detect anything that it loses,
// alters or forges.
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
  '.wasm': 'application/wasm', '.json': 'application/json',
};
const server = createServer(async (request, response) => {
  const path = normalize(decodeURIComponent(new URL(request.url, 'http://here').pathname));
  const name = path.endsWith('/') ? `${path}index.html` : path;
  const head = { 'content-type': types[extname(name)] ?? 'application/octet-stream', 'cache-control': 'no-cache' };
  try {
    // The corpus is large, so game/build compresses it.
    const file = join(values.page, name);
    const packed = (request.headers['accept-encoding'] ?? '').includes('gzip') ? await readFile(`${file}.gz`).catch(() => null) : null;
    const body = packed ?? await readFile(file);
    response.writeHead(200, packed ? { ...head, 'content-encoding': 'gzip' } : head);
    response.end(body);
  } catch {
    response.writeHead(404).end('not found');
  }
});

const spectators = 4;
const rooms = new Map();
const relay = new WebSocketServer({ server, maxPayload: 2048, perMessageDeflate: false });

// Assigns a number: the wanted one if it is free, else the first free one; in a running match also
// the seats of players who left. Those who only watch, or find no free seat, become spectators.
function seatFor(room, wanted, isWatching) {
  const free = (from, to) => {
    for (let i = from; i < to; ++i) if (!room.seats[i]) return i;
    return -1;
  };
  if (!isWatching && wanted >= 0 && wanted < room.size && !room.seats[wanted]) return wanted;
  const seat = isWatching ? -1 : free(0, room.size);
  return seat >= 0 ? seat : free(room.size, room.size + spectators);
}

relay.on('connection', (socket, request) => {
  const { pathname, searchParams } = new URL(request.url, 'http://here');
  const name = /\/room\/([0-9a-z]{1,32})$/.exec(pathname)?.[1];
  if (!name) return socket.close(1008, 'no room');
  const room = rooms.get(name) ?? {
    seats: [], isPlaying: false, lives: 0,
    size: searchParams.get('players') === '4' ? 4 : 2, seed: searchParams.get('seed')?.slice(0, 20) ?? '1',
  };
  // A waiting player has the first free seat; seats are final when the match begins.
  const wanted = room.isPlaying ? Number(searchParams.get('seat') ?? -1) : -1;
  const self = seatFor(room, wanted, searchParams.has('watch'));
  if (self < 0) {
    socket.send(JSON.stringify({ is: 'full' }));
    return socket.close(1008, 'full');
  }
  rooms.set(name, room);
  room.seats[self] = socket;
  const players = () => room.seats.slice(0, room.size).filter((seat) => seat).length;
  const tell = (seat, what) => room.seats[seat]?.send(JSON.stringify({ ...what, self: seat, players: room.size }));
  const say = (what) => room.seats.forEach((seat, i) => tell(i, what));
  const begin = (seat, isLate) => tell(seat, {
    is: 'start', seed: room.seed, life: isLate ? ++room.lives : 0,
    here: [...room.seats.keys()].filter((i) => room.seats[i] && i !== seat),
  });
  socket.on('message', (data, isBinary) => {
    if (!isBinary || !room.isPlaying) return;
    const other = room.seats[data[0]], from = room.seats.indexOf(socket);
    if (from < 0 || !other || other === socket || other.bufferedAmount > 65536) return;
    data[0] = from;
    other.send(data);
  });
  socket.on('error', () => socket.terminate());
  socket.on('close', () => {
    const who = room.seats.indexOf(socket);
    room.seats[who] = null;
    if (players() === 0) {
      // Nobody has the match any more.
      rooms.delete(name);
      room.seats.forEach((seat) => seat?.close(1000, 'over'));
    } else if (room.isPlaying) say({ is: 'left', who });
    else say({ is: 'waiting', here: players() });
  });
  if (room.isPlaying) {
    begin(self, true);
    room.seats.forEach((seat, i) => { if (i !== self) tell(i, { is: 'came', who: self }); });
    return;
  }
  room.isPlaying = players() === room.size;
  if (room.isPlaying) room.seats.forEach((seat, i) => begin(i, i >= room.size));
  else say({ is: 'waiting', here: players() });
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
