// SPDX-License-Identifier: MIT
// The page: two machines side by side, or one of them connected through a relay.
import { Peer } from './peer.js';
import { Link, weather } from './link.js';
import { View, directionOf } from './view.js';
import { sound, snap, thud, fanfare } from './sound.js';

const at = (id) => document.getElementById(id);
const asked = new URLSearchParams(location.search);
const isAuto = asked.has('auto');  // all players are simulated
const speed = Number(asked.get('speed') ?? 1);
const redraw = Number(asked.get('redraw') ?? 4000);  // milliseconds, when fast-forwarding
const tick = 1000 / 60, milestone = 600;
const names = ['Red', 'Blue'], raws = 65536 / 360;
const most = 4;  // players
const clock = () => performance.now() * speed;
const noPad = { angle: 8192, power: 160, fire: false };

const module = await WebAssembly.compileStreaming(fetch('game.wasm'));
const peers = [new Peer(module), new Peer(module)];
const viewer = new Peer(module);  // plays replays
const players = Array.from({ length: most }, () => ({ angle: 8192, power: 160, fire: 0 }));
const views = [0, 1].map((i) => {
  try {
    return new View(at(`canvas-${i}`), [i]);
  } catch {
    return null;  // no WebGL: the match is played but not drawn
  }
}).map((view) => view ?? { update() {}, draw() {}, accuse() {}, burst() {} });
let links, mode, self, life = 0, count = 2, present = [], socket, sent = 0, local = clock(), isFlipped = false, last = null;
let strip = [], compared = 0, milestones = {}, isHere = false, isSeated = false;

const say = (text) => { at('status').textContent = text; };
function playerName(player) {
  if (player >= count) return `Spectator ${player - count + 1}`;
  return names[player % 2] + (count === 2 ? '' : player < 2 ? ' at the back' : ' in front');
}
const lower = (name) => name[0].toLowerCase() + name.slice(1);
function notice(text) {
  at('notice').hidden = text === '';
  at('notice').textContent = text;
}

// ---- matches

const randomSeed = () => crypto.getRandomValues(new BigUint64Array(1))[0];

function begin(newMode, seed) {
  mode = newMode;
  if (mode !== 'remote') count = 2;
  links = [new Link(), new Link()];
  strip = [];
  compared = sent = 0;
  milestones = {};
  isFlipped = isHere = isSeated = false;
  last = null;
  at('desync').textContent = '';
  at('pause').setAttribute('aria-pressed', false);
  at('verdict').textContent = 'equal';
  at('verdict').className = '';
  views.forEach((view) => view.accuse(-1));
  if (mode === 'local') peers.forEach((peer, i) => peer.start(seed, i));
  if (mode === 'remote') peers[0].start(seed, self, count, life);
  arrange();
}

function arrange() {
  const isAlone = mode !== 'local', side = mode === 'remote' ? self : 0;
  at('peers').className = isAlone ? 'alone' : '';
  document.querySelector('.peer.right').hidden = isAlone;
  document.querySelector('.peer').className = `peer ${side % 2 === 0 ? 'left' : 'right'}`;
  at('name-0').textContent = mode === 'replay' ? 'Replay'
    : isWatching() ? 'You are watching' : mode === 'remote' ? `You are ${lower(playerName(side))}` : "Red's machine";
  views[0].controlled = mode === 'replay' || isWatching() ? [] : [side];
  at('pad-0').classList.toggle('idle', mode === 'replay' || isAuto || isWatching());
  at('pad-1').classList.toggle('idle', isComputer(1));
  at('computer-label').hidden = isAlone;
  at('flip').hidden = at('save').hidden = mode === 'replay';
  at('pause').hidden = mode === 'replay' || isWatching();
  at('flip').textContent = `Flip one bit on ${mode === 'remote' ? 'this' : "blue's"} machine`;
  at('digest-name-0').textContent = mode === 'remote' ? 'here' : 'red';
  at('digest-name-0').className = side % 2 === 0 ? 'left' : 'right';
  at('digest-name-1').className = mode === 'remote' && count > 2 ? '' : side === 0 ? 'right' : 'left';
  at('digest-name-1').textContent = mode !== 'remote' ? 'blue' : count > 2 ? 'all others' : 'there';
}

const isWatching = () => mode === 'remote' && self >= count;
const isComputer = (side) => isAuto || (mode === 'local' && side === 1 && at('computer').checked);

function padOf(peer, side) {
  if (isComputer(side)) return peer.simulatedPad(side, peer.wasm.frame());
  const player = players[side];
  return { angle: player.angle, power: player.power, fire: player.fire > 0 };
}
// If released too early, the catapult shoots as soon as it is ready.
function played(peer, side) {
  const player = players[side];
  if (peer.result !== 'yes' || player.fire === 0) return;
  const { reload } = peer.match().catapults[side];
  player.fire = reload > player.reload ? 0 : player.fire - 1;
  player.reload = reload;
}

function step(now) {
  if (mode === 'local') {
    peers.forEach((peer, i) => {
      links[i].deliver(now, (packet) => peer.receive(1 - i, packet, now));
      const packets = peer.play(padOf(peer, i), now);
      played(peer, i);
      for (const { to, packet } of packets) links[to].send(packet, now);
    });
    compare(peers[0], Math.min(peers[0].wasm.final_frame(), peers[1].wasm.final_frame()));
  } else if (mode === 'remote') {
    const packets = peers[0].play(isWatching() ? noPad : padOf(peers[0], self), now);
    if (!isWatching()) played(peers[0], self);
    if (peers[0].result === 'joining') return send(packets, now);
    if (!isHere) arrive();
    if (life > 0 && !isSeated && peers[0].wasm.is_player()) {
      isSeated = true;
      notice('');
      banner('You are playing again');
    }
    send(packets, now);
    compare(peers[0], peers[0].wasm.matched_frame());
  } else if (mode === 'replay') {
    const state = viewer.wasm.replay_step();
    if (state === 2) notice(`The replay differs before frame ${viewer.wasm.replay_frame()}.`);
    if (state === 1) {
      const isWhole = viewer.wasm.replay_state() === 0, frames = `${viewer.wasm.replay_frame()} frames, all digests equal`;
      notice(isWhole ? `The replay is over: ${frames}. Press New match to continue.`
        : `The file is cut off or has changed after ${frames}. Press New match to continue.`);
    }
    if (state !== 0) mode = 'shown';
  }
}

function send(packets, now) {
  for (const { to, packet } of packets) {
    sent += packet.length;
    links[0].send([to, ...packet], now);
  }
  links[0].deliver(now, (flown) => { if (socket?.readyState === WebSocket.OPEN) socket.send(new Uint8Array(flown)); });
}

// A late joiner has received the match so far.
function arrive() {
  isHere = true;
  if (life === 0) return;
  const from = peers[0].wasm.start_frame();
  compared = from;
  notice(isWatching() ? `You have been watching since frame ${from}.` : `You are back since frame ${from}, and get your seat as soon as you have caught up.`);
  say(at('notice').textContent);
}

function compare(peer, until) {
  if (mode === 'remote' && peer.desync) until = peer.wasm.final_frame();
  compared = Math.max(compared, until - 200);
  for (; compared < until; ++compared) {
    const ours = peer.digest(compared);
    const theirs = mode === 'local' ? peers[1].digest(compared)
      : peer.desync && compared >= peer.desync.frame ? null : ours;
    strip.push({ ours, theirs });
    if (ours !== theirs && at('verdict').className === '') {
      at('verdict').textContent = 'DIFFERENT';
      at('verdict').className = 'bad';
      say(`The digests differ since frame ${compared}`);
    }
    if ((compared + 1) % milestone === 0) milestones[compared + 1] = hex(ours);
  }
  strip = strip.slice(-300);
}

const hex = (digest) => digest.toString(16).padStart(16, '0');

function advance() {
  const now = clock();
  if (now - local > 30 * tick * Math.max(1, speed)) local = now - tick;  // this page was suspended
  while (local + tick <= now) {
    local += tick;
    step(local);
  }
  const found = [...(mode === 'local' ? peers : [peers[0]])].find((peer) => peer.desync?.field);
  if (found && at('desync').textContent === '') report(found.desync);
  if (mode === 'remote' && peers[0].isLost) comeBack('You fell behind.');
}

// ---- display

function nameOf(index, match) {
  const piece = match.pieces.find((each) => each.index === index);
  if (!piece) return `body ${index}`;
  const what = { king: 'the king', ball: 'a ball', wood: 'a wooden block', stone: 'a stone block', rock: 'the ground' };
  return piece.kind === 'rock' ? 'the ground' : `${what[piece.kind]} of ${names[piece.owner].toLowerCase()}`;
}

function report({ frame, field, object, known }) {
  const after = !isFlipped ? ''
    : `, which was detected ${known - frame} frames later`;
  const what = object >= 0 ? `, ${nameOf(object, peers[0].match())}` : '';
  at('desync').textContent = `The machines diverged in frame ${frame}${after}. First field that differs: ${field}${what}.`;
  views.forEach((view) => view.accuse(object));
}

function banner(text) {
  for (const i of [0, 1]) {
    at(`banner-${i}`).textContent = text;
    at(`banner-${i}`).classList.add('shown');
  }
  clearTimeout(banner.timer);
  banner.timer = setTimeout(() => [0, 1].forEach((i) => at(`banner-${i}`).classList.remove('shown')), 2200);
  say(text);
}

function noteChanges(match) {
  const before = last;
  last = match;
  at('score-left').textContent = match.sides[0].score;
  at('score-right').textContent = match.sides[1].score;
  const wind = match.wind * 60;
  const arrows = wind === 0 ? '' : (wind < 0 ? '◀' : '▶').repeat(Math.ceil(Math.abs(wind) / 1.3));
  const weatherText = wind === 0 ? 'No wind' : `Wind ${Math.abs(wind).toFixed(1)} to the ${wind < 0 ? 'left' : 'right'} ${arrows}`;
  if (at('weather').textContent !== weatherText) at('weather').textContent = weatherText;
  if (!before) return;
  if (match.catapults.some((each, i) => each.reload > before.catapults[i]?.reload)) snap();
  match.sides.forEach((side, i) => {
    if (!side.fallen || before.sides[i].fallen) return;
    const winner = match.sides[1 - i];
    const king = match.pieces.find((piece) => piece.kind === 'king' && piece.owner === i);
    if (king) views.forEach((view) => view.burst(king.x, king.y, 60, 9, [0xffd75e, 0xff7a6b, 0x7db4ff, 0xffffff]));
    fanfare();
    banner(winner.score >= 3 ? `${names[1 - i]} wins the match` : `${names[i]}'s king has fallen`);
  });
  if (match.round > before.round) banner(`Round ${match.round}`);
}

function drawStrip() {
  const canvas = at('strip'), context = canvas.getContext('2d');
  context.clearRect(0, 0, canvas.width, canvas.height);
  strip.forEach(({ ours, theirs }, i) => {
    const x = canvas.width - 2 * (strip.length - i);
    context.fillStyle = ours === theirs ? '#4fd08a' : '#ff5a5a';
    const up = 3 + Number(ours & 7n);
    const down = theirs === null ? 10 : 3 + Number(theirs & 7n);
    context.fillRect(x, 12 - up, 1.4, up + down);
  });
  const newest = strip.at(-1);
  if (!newest) return;
  at('digest-frame').textContent = compared - 1;
  at('digest-0').textContent = hex(newest.ours);
  at('digest-1').textContent = newest.theirs === null ? 'another one' : hex(newest.theirs);
  const frames = Math.max(1, peers[0].wasm.frame()), { result } = peers[0];
  if (result === 'yes' || result === 'ahead') moved = performance.now();
  at('figures').textContent = `${(peers[0].wasm.resimulated() / frames).toFixed(2)} frames resimulated per frame played`
    + (performance.now() - moved < 400 ? '' : `; ${obstacle()}`);
}

function obstacle() {
  const awaited = mode !== 'remote' ? [] : present.filter((player) => peers[0].wasm.is_awaited(player));
  return awaited.length === 0 ? `now ${peers[0].result}` : `waiting for ${awaited.map(playerName).map(lower).join(', ')}`;
}

let drawn = -Infinity, moved = 0;  // times of the last redraw and of the last frame played
function draw(now) {
  requestAnimationFrame(draw);
  advance();
  if (speed > 1 && now - drawn < redraw) return;  // fast-forwarding
  const seconds = Math.min(0.1, (now - drawn) / 1000);
  drawn = now;
  if (mode === 'waiting' || (mode === 'remote' && !isHere)) return;
  const match = mode === 'replay' || mode === 'shown' ? viewer.replayMatch() : peers[0].match();
  noteChanges(match);
  views[0].update(match);
  views[0].draw(seconds);
  if (mode === 'local') {
    views[1].update(peers[1].match());
    views[1].draw(seconds);
  }
  if (mode === 'local' || mode === 'remote') drawStrip();
}
views[0].onHit = thud;

// ---- input

const clamp = (value, low, high) => Math.max(low, Math.min(high, value));
function setAim(side, angle, power) {
  const player = players[side], slot = mode === 'remote' ? 0 : side;
  player.angle = Math.round(clamp(angle, -1820, 15290));
  player.power = Math.round(clamp(power, 64, 255));
  at(`angle-${slot}`).value = player.angle / raws;
  at(`power-${slot}`).value = player.power / 2.55;
  at(`angle-text-${slot}`).textContent = `${Math.round(player.angle / raws)}°`;
  at(`power-text-${slot}`).textContent = `${Math.round(player.power / 2.55)} %`;
}
const fire = (side) => Object.assign(players[side], { fire: 90, reload: 1e6 });
const sideOf = (slot) => (mode === 'remote' ? self : slot);

for (const slot of [0, 1]) {
  const fromSliders = () => setAim(sideOf(slot), at(`angle-${slot}`).value * raws, at(`power-${slot}`).value * 2.55);
  at(`angle-${slot}`).addEventListener('input', fromSliders);
  at(`power-${slot}`).addEventListener('input', fromSliders);
  at(`pad-${slot}`).addEventListener('submit', (event) => {
    event.preventDefault();
    fire(sideOf(slot));
  });
  const canvas = at(`canvas-${slot}`);
  let from = null;
  canvas.addEventListener('pointerdown', (event) => {
    if (mode === 'replay' || mode === 'shown' || isWatching() || isComputer(sideOf(slot))) return;
    from = { x: event.clientX, y: event.clientY };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!from) return;
    const x = (from.x - event.clientX) * directionOf(sideOf(slot)), y = event.clientY - from.y;
    const length = Math.hypot(x, y);
    if (length < 6) return;
    setAim(sideOf(slot), (Math.atan2(y, x) * 65536) / (2 * Math.PI), (length / (0.42 * canvas.clientHeight)) * 255);
    from.isDrawn = true;
  });
  const release = () => {
    if (from?.isDrawn) fire(sideOf(slot));
    from = null;
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', () => { from = null; });
}

const keys = {
  KeyW: [0, 110, 0], KeyS: [0, -110, 0], KeyD: [0, 0, 2], KeyA: [0, 0, -2],
  ArrowUp: [1, 110, 0], ArrowDown: [1, -110, 0], ArrowLeft: [1, 0, 2], ArrowRight: [1, 0, -2],
};
const held = new Set();
const whose = (side) => (mode === 'remote' ? self : isComputer(1) ? 0 : side);
addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || isWatching()) return;
  // Arrow keys stay with sliders; space and enter stay with buttons and boxes.
  if (event.target.matches('input[type=range]') && event.code.startsWith('Arrow')) return;
  if (event.target.matches('button, input:not([type=range])') && !event.code.startsWith('Key')) return;
  if (event.code in keys) held.add(event.code);
  else if (event.code === 'Space') fire(whose(0));
  else if (event.code === 'Enter') fire(whose(1));
  else return;
  event.preventDefault();
});
// After a click the space bar shoots again.
addEventListener('click', (event) => {
  if (event.detail > 0 && event.target.matches('button, input[type=checkbox]')) event.target.blur();
});
addEventListener('keyup', (event) => held.delete(event.code));
addEventListener('blur', () => held.clear());
setInterval(() => {
  for (const code of held) {
    const [side, angle, power] = keys[code], player = players[whose(side)];
    // In a game for one, and for blue over a network, right means right.
    const flip = code === 'ArrowLeft' || code === 'ArrowRight' ? -directionOf(whose(side)) : 1;
    setAim(whose(side), player.angle + angle, player.power + power * flip);
  }
  advance();  // pages that are not drawn keep playing
}, speed > 1 ? 1 : 1000 / 60);

at('new-match').addEventListener('click', () => {
  socket?.close();
  socket = null;
  history.replaceState(null, '', location.pathname);
  notice('');
  begin('local', randomSeed());
});
at('computer').addEventListener('change', () => arrange());
at('sound').addEventListener('change', () => { sound.isOn = at('sound').checked; });
at('pause').addEventListener('click', () => {
  const isPaused = at('pause').getAttribute('aria-pressed') !== 'true';
  at('pause').setAttribute('aria-pressed', isPaused);
  peers[0].wasm.set_paused(isPaused ? 1 : 0);
});
at('flip').addEventListener('click', () => {
  isFlipped = true;
  peers[mode === 'remote' ? 0 : 1].wasm.flip_a_bit();
});
function readWeather() {
  weather.latency = Number(at('latency').value);
  weather.loss = Number(at('loss').value) / 100;
  at('latency-text').textContent = `${weather.latency} ms`;
  at('loss-text').textContent = `${at('loss').value} %`;
}
for (const name of ['latency', 'loss']) {
  if (asked.has(name)) at(name).value = asked.get(name);
  at(name).addEventListener('input', readWeather);
}

// ---- replays

at('save').addEventListener('click', () => {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([peers[0].save()], { type: 'application/octet-stream' }));
  link.download = `slingshot-${peers[0].wasm.final_frame()}.dtnr`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
});
async function open(file) {
  if (!file) return;
  if (!viewer.load(new Uint8Array(await file.arrayBuffer()))) {
    notice(`${file.name} is no replay of this game.`);
    return;
  }
  socket?.close();
  socket = null;
  begin('replay');
  notice(`Replaying ${file.name} and checking every digest in it.`);
}
at('open').addEventListener('change', () => open(at('open').files[0]));
addEventListener('dragover', (event) => {
  event.preventDefault();
  document.body.classList.add('dropping');
});
addEventListener('dragleave', () => document.body.classList.remove('dropping'));
addEventListener('drop', (event) => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  open(event.dataTransfer.files[0]);
});

// ---- matches of two or four browsers

const roomNow = { name: '', seed: 0n, wanted: 2, isWatching: false };

function linkTo(room, wanted, isWatching = false) {
  return new URL(`?room=${room}${wanted === 2 ? '' : `&players=${wanted}`}${isWatching ? '&watch' : ''}`, location.href).href;
}
// A returning player asks for the seat that this tab had.
const seatKey = (room) => `seat in ${room}`;

function join(room, seed, wanted, isWatching) {
  Object.assign(roomNow, { name: room, seed, wanted, isWatching });
  socket?.close();
  const seat = sessionStorage.getItem(seatKey(room));
  const address = new URL(`room/${room}?seed=${seed}&players=${wanted}`
    + `${seat === null ? '' : `&seat=${seat}`}${isWatching ? '&watch' : ''}`, location.href);
  address.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  socket = new WebSocket(address);
  socket.binaryType = 'arraybuffer';
  const here = linkTo(room, wanted);
  mode = 'waiting';
  let isAnswered = false;
  notice('Joining the match…');
  if (!isWatching) navigator.clipboard?.writeText(here).catch(() => {});
  const own = socket;
  own.onmessage = ({ data }) => {
    if (socket !== own) return;
    if (typeof data !== 'string') {
      const bytes = new Uint8Array(data);
      if (mode === 'remote') peers[0].receive(bytes[0], bytes.subarray(1), local);
      return;
    }
    isAnswered = true;
    const said = JSON.parse(data);
    if (said.is === 'waiting') {
      notice(`${said.here} of ${said.players} are here. The match begins when everyone is. Link for the others: ${here}`
        + ` To watch: ${linkTo(room, wanted, true)}`);
      say(`${said.here} of ${said.players} are here`);
    }
    if (said.is === 'full') notice('This match is full. Press New match to start another one.');
    if (said.is === 'left' && mode === 'remote') left(said.who);
    if (said.is === 'came' && mode === 'remote') came(said.who);
    if (said.is !== 'start') return;
    ({ self, life, players: count } = said);
    present = said.here.filter((player) => player < count);
    sessionStorage.setItem(seatKey(room), self);
    notice(life > 0 ? 'The others are sending the match so far…' : '');
    begin('remote', BigInt(said.seed));
    if (self >= count) return banner('You are watching');
    setAim(self, 8192, 160);
    banner(`You are ${lower(playerName(self))}`);
  };
  own.onclose = () => {
    if (socket !== own) return;
    if (mode === 'remote') return comeBack('The relay is gone.');
    if (mode !== 'waiting') return;
    if (life > 0 && !isAnswered) return comeBack('The relay is gone.');
    begin('local', randomSeed());
    if (!isAnswered) notice('No relay is running here: ./dev play starts one.');
  };
}
// Joins again, as a late joiner.
function comeBack(why) {
  mode = 'waiting';
  life = Math.max(life, 1);
  socket?.close();
  socket = null;
  notice(`${why} Coming back…`);
  const { name, seed, wanted, isWatching } = roomNow;
  setTimeout(() => { if (mode === 'waiting' && !socket) join(name, seed, wanted, isWatching); }, 1000);
}
function left(who) {
  peers[0].wasm.drop(who);
  present = present.filter((player) => player !== who);
  if (who >= count) return notice(`${playerName(who)} has left.`);
  notice(`${playerName(who)} has left; the match goes on. The link of this page leads to the free seat.`);
}
function came(who) {
  if (who >= count) return notice(`${playerName(who)} has joined.`);
  present.push(who);
  notice(`${playerName(who)} comes back.`);
}
for (const [button, wanted] of [['invite', 2], ['invite-three', 4]]) {
  at(button).addEventListener('click', () => {
    const room = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, '0')).join('');
    history.replaceState(null, '', linkTo(room, wanted));
    life = 0;
    join(room, randomSeed(), wanted, false);
  });
}

readWeather();
begin('local', asked.has('seed') ? BigInt(asked.get('seed')) : randomSeed());
for (const side of [0, 1]) setAim(side, 8192, 160);
if (asked.has('room')) {
  join(asked.get('room'), asked.has('seed') ? BigInt(asked.get('seed')) : randomSeed(), asked.get('players') === '4' ? 4 : 2,
    asked.has('watch'));
}
requestAnimationFrame(draw);
if (!isAuto) banner('Round 1');
if (!(views[0] instanceof View)) notice('This browser has no WebGL, so nothing is drawn.');
window.slingshot = { peers, milestones: () => milestones, mode: () => mode, sent: () => sent, redraw: () => { drawn = -Infinity; }, hangUp: () => socket.close() };
navigator.serviceWorker?.register('worker.js').catch(() => {});
