// SPDX-License-Identifier: MIT
//
// usage: node bench.mjs game.wasm [bodies.wasm]; `game/build --bench` makes both and runs it
// Measures a frame of the match in WebAssembly: two peers, 3,000 frames, a latency of seven frames,
// so up to eight frames are resimulated in each, and every tenth packet lost. With bodies.wasm,
// also measures a frame of 200 bodies with eight resimulated frames. Times are CPU times, so that
// other programs matter little: the least of seven runs, frame by frame.
import { readFileSync } from 'node:fs';
import { Peer } from './page/peer.js';

const module = new WebAssembly.Module(readFileSync(process.argv[2]));
const frames = 3000, latency = 7, seed = 2026n, runs = 7;
const milliseconds = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};
const best = [];
let peers, bytes;

for (let run = 0; run < runs; ++run) {
  peers = [new Peer(module), new Peer(module)];
  peers.forEach((peer, i) => peer.start(seed, i));
  const flying = [[], []];
  let lost = 0;
  bytes = 0;
  for (let tick = 0; tick < frames + 100; ++tick) {
    const now = (tick * 1000) / 60;
    peers.forEach((peer, i) => {
      const start = milliseconds();
      for (; flying[i].length > 0 && flying[i][0].tick <= tick; flying[i].shift()) peer.receive(1 - i, flying[i][0].packet, now);
      const [sent] = peer.play(peer.simulatedPad(i, peer.wasm.frame()), now);
      const at = 2 * tick + i;
      best[at] = Math.min(best[at] ?? Infinity, milliseconds() - start);
      if (!sent) return;
      bytes += sent.packet.length;
      if (++lost % 10 !== 0) flying[sent.to].push({ tick: tick + latency, packet: sent.packet });
    });
  }
}
const spread = (times) => {
  times.sort((a, b) => a - b);
  const at = (share) => times[Math.floor(share * (times.length - 1))].toFixed(2);
  return `${at(0.5)} ms a frame; 99 % within ${at(0.99)}; ${at(1)} at most`;
};
const again = peers[0].wasm.resimulated() / peers[0].wasm.frame();
console.log(`${spread(best)}; ${again.toFixed(2)} frames simulated again a frame`);
console.log(`${Math.round((bytes / 2 / best.length) * 2 * 60)} bytes a second each way; a replay has ${(peers[0].save().length / peers[0].wasm.final_frame()).toFixed(1)} bytes a frame`);
if (peers[0].digest(peers[0].wasm.final_frame() - 20) !== peers[1].digest(peers[0].wasm.final_frame() - 20)) throw new Error('different');

if (process.argv[3]) {
  const { exports: wasm } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(process.argv[3])), {});
  for (const again of [0, 8]) {
    const times = [];
    let bodies, awake = Infinity;
    for (let run = 0; run < runs; ++run) {
      bodies = wasm.start();
      for (let i = 0; i < 300; ++i) {
        const start = milliseconds();
        wasm.play(again);
        times[i] = Math.min(times[i] ?? Infinity, milliseconds() - start);
        if (i < 100) awake = Math.min(awake, wasm.awake());
      }
    }
    console.log(`${bodies} bodies, ${again} frames again: ${spread(times)}; at least ${awake} awake for 100 frames; digest ${BigInt.asUintN(64, wasm.digest()).toString(16)}`);
  }
}
