// SPDX-License-Identifier: MIT
//
// usage: node relay_peer.mjs [--room NAME] [--players N] [--seed N] [--speed N] [--loss SHARE] [--watch] ADDRESS PROGRAM...
// Connects a program that speaks `peer pipe` to a room of the relay. The program runs natively or
// in an emulator, such as `qemu-s390x peer`, and joins a running match late. This script paces its
// frames, passes its packets and prints its digests. When terminated, it leaves the match and exits
// with the program's status.
import { spawn } from 'node:child_process';
import { parseArgs } from 'node:util';
import { WebSocket } from 'ws';

const { values, positionals: [address, ...program] } = parseArgs({
  allowPositionals: true,
  options: {
    room: { type: 'string', default: 'test' },
    players: { type: 'string', default: '2' },
    seed: { type: 'string', default: '2026' },
    speed: { type: 'string', default: '1' },
    loss: { type: 'string', default: '0' },
    watch: { type: 'boolean', default: false },
  },
});

const room = new URL(`room/${values.room}?seed=${values.seed}&players=${values.players}${values.watch ? '&watch' : ''}`, address);
room.protocol = room.protocol === 'https:' ? 'wss:' : 'ws:';
const socket = new WebSocket(room);
const tick = 1000 / 60;
let peer, others = new Set(), played = 0, rest = Buffer.alloc(0);

const clock = () => performance.now() * Number(values.speed);

// One record: the time, and a packet with its sender; or nothing, to play a frame; or who has left.
function tell(now, from = 0, packet = Buffer.alloc(0), size = packet.length) {
  const head = Buffer.alloc(7);
  head.writeUInt32LE(Math.floor(now) % 2 ** 32, 0);
  head.writeUInt16LE(size, 4);
  head[6] = from;
  peer.stdin.write(Buffer.concat([head, packet]));
}

function start({ self, seed, players, here, life }) {
  others = new Set(here);
  peer = spawn(program[0], [...program.slice(1), 'pipe', self, seed, players, life].map(String), { stdio: ['pipe', 'pipe', 'inherit'] });
  peer.stdin.on('error', () => {});
  peer.on('exit', (status) => process.exit(status ?? 1));
  peer.stdout.on('data', (bytes) => {
    rest = Buffer.concat([rest, bytes]);
    while (rest.length >= 2) {
      const size = rest.readUInt16LE(0), isDigest = size === 65535, length = isDigest ? 14 : 3 + size;
      if (rest.length < length) return;
      if (isDigest) console.log(`${rest.readUInt32LE(2)} ${rest.readBigUInt64LE(6).toString(16).padStart(16, '0')}`);
      else if (Math.random() >= Number(values.loss)) socket.send(rest.subarray(2, length));
      rest = rest.subarray(length);
    }
  });
  played = clock();
  setInterval(() => {
    const now = clock();
    if (now - played > 30 * tick * Number(values.speed)) played = now - tick;
    for (; played + tick <= now; played += tick) tell(played);
  }, 1);
}

socket.on('message', (data, isBinary) => {
  if (isBinary) {
    if (peer) tell(played, data[0], data.subarray(1));
    return;
  }
  const said = JSON.parse(data);
  if (said.is === 'start') start(said);
  if (said.is === 'came') others.add(said.who);
  if (said.is !== 'left') return;
  others.delete(said.who);
  if (others.size === 0) socket.close();
  else tell(played, said.who, undefined, 65535);
});
process.on('SIGTERM', () => socket.close());
socket.on('close', () => (peer ? peer.stdin.end() : process.exit(1)));
socket.on('error', (error) => {
  console.error(`relay_peer: ${error.message}`);
  process.exit(1);
});
