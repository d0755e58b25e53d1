// SPDX-License-Identifier: MIT
// A player's machine: an instance of the module and its view of the match.

const one = 65536;
export const kinds = ['none', 'rock', 'wood', 'stone', 'king', 'ball'];
export const advanced = ['yes', 'connecting', 'catching up', 'starved', 'ahead', 'paused', 'over', 'joining'];
const tooSlow = 8, desync = 10, desyncField = 11;

export class Peer {
  constructor(module) {
    this.wasm = new WebAssembly.Instance(module, {}).exports;
  }

  // With a life it joins late: the others send the match so far.
  start(seed, self, players = 2, life = 0, delay = 2) {
    this.seed = seed;
    this.self = self;
    this.desync = null;
    this.isLost = false;
    this.wasm.start(seed, self, delay, players, life);
  }

  bytes(size) {
    return new Uint8Array(this.wasm.memory.buffer, this.wasm.buffer(), size);
  }

  receive(from, packet, now) {
    if (packet.length > 4096) return;
    this.bytes(packet.length).set(packet);
    this.wasm.receive(from, packet.length, now);
  }

  // Plays a frame. Returns the packets to send, each with its recipient.
  play(pad, now) {
    this.result = advanced[this.wasm.advance(pad.angle, pad.power, pad.fire ? 1 : 0)];
    for (let kind; (kind = this.wasm.next_event()) >= 0;) this.note(kind);
    const bytes = this.bytes(this.wasm.poll(now)).slice(), packets = [];
    for (let i = 0; i < bytes.length;) {
      const size = bytes[i + 1] | bytes[i + 2] << 8;
      packets.push({ to: bytes[i], packet: bytes.subarray(i + 3, i + 3 + size) });
      i += 3 + size;
    }
    return packets;
  }

  note(kind) {
    const frame = this.wasm.event_frame();
    if (kind === desync) this.desync = { frame, field: null };
    if (kind === desyncField) {
      const text = this.bytes(128);
      const field = new TextDecoder().decode(text.slice(0, text.indexOf(0)));
      this.desync = { frame, field, object: this.wasm.event_object(), known: this.wasm.frame() };
    }
    if (kind === tooSlow && !this.wasm.is_player()) this.isLost = true;  // it rejoins
  }

  digest(frame) { return BigInt.asUintN(64, this.wasm.digest(frame)); }

  match() { return readMatch(this.wasm, this.wasm.view()); }

  simulatedPad(player, frame) {
    const word = this.wasm.simulated(this.seed, player, frame);
    return { angle: word >> 16, power: (word >> 8) & 255, fire: (word & 1) !== 0 };
  }

  save() { return this.bytes(this.wasm.save_replay()).slice(); }

  // null if the bytes are not a replay of this game
  load(bytes) {
    if (bytes.length > this.wasm.buffer_size()) return null;
    this.bytes(bytes.length).set(bytes);
    return this.wasm.load_replay(bytes.length) === 0 ? this : null;
  }
  replayMatch() { return readMatch(this.wasm, this.wasm.replay_view()); }
}

function readMatch(wasm, count) {
  const numbers = new Int32Array(wasm.memory.buffer, wasm.view_at(), count);
  let i = 0;
  const next = () => numbers[i++];
  const match = { tick: next(), round: next(), pause: next(), wind: next() / one, catapults: [], sides: [], pieces: [] };
  for (let left = next(); left > 0; --left) match.catapults.push({ angle: next(), power: next(), reload: next() });
  for (let side = 0; side < 2; ++side) match.sides.push({ score: next(), fallen: next() !== 0 });
  for (let left = next(); left > 0; --left) {
    match.pieces.push({
      index: next(), generation: next(), kind: kinds[next()], owner: next(), x: next() / one, y: next() / one,
      turn: Math.atan2(numbers[i + 1], numbers[i]), halfX: numbers[i + 2] / one, halfY: numbers[i + 3] / one,
      age: numbers[i + 4], asleep: numbers[i + 5] !== 0,
    });
    i += 6;
  }
  return match;
}
