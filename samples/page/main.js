// SPDX-License-Identifier: MIT
//
// The gallery, and the sample named after # in the address.
import { Key, load } from './module.js';
import { Painter } from './painter.js';

const $ = (id) => document.getElementById(id);
const keyOf = {
  ArrowLeft: Key.left, ArrowRight: Key.right, ArrowUp: Key.up, ArrowDown: Key.down, ' ': Key.action,
  a: Key.left, d: Key.right, w: Key.up, s: Key.down,
};

const machine = await load(await (await fetch('samples.wasm')).arrayBuffer());
let painter = null, running = null, tick = 0, isPaused = false, isPainted = false;
let held = 0, pointer = null, before = 0, owed = 0;

function showGallery() {
  const list = $('cards');
  for (const sample of machine.samples) {
    const item = document.createElement('li'), link = document.createElement('a');
    const picture = document.createElement('span'), name = document.createElement('b'), what = document.createElement('span');
    link.href = `#${sample.name}`;
    picture.className = 'picture';
    picture.style.backgroundPosition = `${sample.index % 2 * 100}% ${Math.floor(sample.index / 2) * 25}%`;
    name.textContent = sample.name;
    what.textContent = sample.sentence;
    link.append(picture, name, what);
    item.append(link);
    list.append(item);
  }
}

// The address determines what is shown.
function route() {
  const name = decodeURIComponent(location.hash.slice(1));
  const sample = machine.samples.find((each) => each.name === name) ?? null;
  $('gallery').hidden = sample !== null;
  $('stage').hidden = sample === null;
  running = sample;
  document.title = sample ? `${sample.name} – detent samples` : 'detent samples';
  if (!sample) return;
  $('name').textContent = sample.name;
  $('sentence').textContent = sample.sentence;
  $('keys').textContent = `${sample.keys}.`;
  $('source').href = `source/${sample.name}.cpp`;
  $('canvas').setAttribute('aria-label', sample.sentence);
  const i = sample.index, all = machine.samples;
  $('next').href = `#${all[(i + 1) % all.length].name}`;
  try {
    painter ??= new Painter($('canvas'));
  } catch (error) {
    $('status').textContent = error.message;
  }
  pause(false);
  reset();
  $('canvas').focus({ preventScroll: true });
}

function say() {
  $('tick').textContent = tick;
  $('digest').textContent = machine.digest();
  $('status').textContent = machine.status();
}
function paint() {
  if (painter) painter.paint(machine.draw(painter.fit()));
  isPainted = true;
}
function reset() {
  held = 0;
  pointer = null;
  tick = 0;
  owed = 0;
  machine.start(running);
  step();
}
function step() {
  machine.step({ keys: held, pointer });
  ++tick;
  say();
  isPainted = false;
}
function pause(is) {
  isPaused = is;
  $('pause').setAttribute('aria-pressed', String(is));
  $('pause').textContent = is ? 'Resume' : 'Pause';
}

// Sixty ticks per second at any frame rate. A page that was hidden does not catch up.
function frame(now) {
  requestAnimationFrame(frame);
  owed = Math.min(owed + (now - before) * 0.06, 4);
  before = now;
  if (!running) return;
  if (isPaused) {
    owed = 0;
    if (!isPainted) paint();
    return;
  }
  let count = 0;
  for (; owed >= 1; owed -= 1, ++count) {
    machine.step({ keys: held, pointer });
    ++tick;
  }
  if (count === 0) return;
  if (tick % 6 < count) say();
  paint();
}

function press(key, is) { held = is ? held | key : held & ~key; }
addEventListener('keydown', (event) => {
  const key = keyOf[event.key];
  if (!running || !key || event.ctrlKey || event.metaKey || event.altKey) return;
  // Space presses a focused button.
  if (key === Key.action && event.target.closest('button, a')) return;
  press(key, true);
  event.preventDefault();
});
addEventListener('keyup', (event) => { if (keyOf[event.key]) press(keyOf[event.key], false); });
addEventListener('blur', () => { held = 0; });
for (const button of document.querySelectorAll('#pad button')) {
  const key = Key[button.dataset.key];
  button.addEventListener('pointerdown', () => press(key, true));
  for (const end of ['pointerup', 'pointerleave', 'pointercancel']) button.addEventListener(end, () => press(key, false));
  button.addEventListener('keydown', (event) => { if (event.key === 'Enter' || event.key === ' ') press(key, true); });
  button.addEventListener('keyup', () => press(key, false));
}
// The pointer, in thousandths of half the height, from the center.
function point(event) {
  const box = $('canvas').getBoundingClientRect(), clamp = (x) => Math.max(-4000, Math.min(4000, Math.round(x)));
  pointer = {
    x: clamp((event.clientX - box.left - box.width / 2) / box.height * 2000),
    y: clamp((box.top + box.height / 2 - event.clientY) / box.height * 2000),
  };
}
$('canvas').addEventListener('pointermove', point);
$('canvas').addEventListener('pointerdown', point);
$('canvas').addEventListener('pointerleave', () => { pointer = null; });

$('pause').addEventListener('click', () => pause(!isPaused));
$('step').addEventListener('click', () => { pause(true); step(); });
$('reset').addEventListener('click', reset);
addEventListener('hashchange', route);
addEventListener('resize', () => { isPainted = false; });

showGallery();
route();
requestAnimationFrame(frame);
window.gallery = { names: machine.samples.map((each) => each.name), tick: () => tick };
