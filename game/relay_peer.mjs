// SPDX-License-Identifier: MIT
//
// usage: node relay_peer.mjs [--room NAME] [--seed N] [--speed N] [--loss SHARE] ADDRESS PROGRAM...
// Lets a program that speaks `peer pipe` join a room of the relay, natively or in an emulator, such
// as `qemu-s390x peer`. It says when a frame is due and passes packets; it prints digests.
import { spawn } from 'node:child_process';
import { parseArgs } from 'node:util';
import { WebSocket } from 'ws';

const { values, positionals: [address, ...program] } = parseArgs({
  allowPositionals: true,
  options: {
    room: { type: 'string', default: 'test' },
    seed: { type: 'string', default: '2026' },
    speed: { type: 'string', default: '1' },
    loss: { type: 'string', default: '0' },
  },
});

const room = new URL(`room/${values.room}?seed=${values.seed}`, address);
room.protocol = room.protocol === 'https:' ? 'wss:' : 'ws:';
const socket = new WebSocket(room);
const tick = 1000 / 60;
let peer, played = 0, rest = Buffer.alloc(0);

const clock = () => performance.now() * Number(values.speed);

// One record: when, and a packet, or nothing for a frame.
function tell(now, packet = Buffer.alloc(0)) {
  const head = Buffer.alloc(6);
  head.writeUInt32LE(Math.floor(now) % 2 ** 32, 0);
  head.writeUInt16LE(packet.length, 4);
  peer.stdin.write(Buffer.concat([head, packet]));
}

function start(self, seed) {
  peer = spawn(program[0], [...program.slice(1), 'pipe', String(self), seed], { stdio: ['pipe', 'pipe', 'inherit'] });
  peer.stdin.on('error', () => {});
  peer.on('exit', (status) => process.exit(status ?? 1));
  peer.stdout.on('data', (bytes) => {
    rest = Buffer.concat([rest, bytes]);
    while (rest.length >= 2) {
      const size = rest.readUInt16LE(0), isDigest = size === 65535, length = 2 + (isDigest ? 12 : size);
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
    if (peer) tell(played, data);
    return;
  }
  const said = JSON.parse(data);
  if (said.is === 'start') start(said.self, said.seed);
});
socket.on('close', () => (peer ? peer.stdin.end() : process.exit(1)));
socket.on('error', (error) => {
  console.error(`relay_peer: ${error.message}`);
  process.exit(1);
});
