// SPDX-License-Identifier: MIT
// Plays the scene of exact.cpp in both scalars, draws it and reports differences.

const at = (id) => document.getElementById(id);
const rays = 360, ticks = 480;
const { instance: { exports: wasm } } = await WebAssembly.instantiateStreaming(fetch('exact.wasm'));
const numbers = (place, count) => new Float64Array(wasm.memory.buffer, place, count).slice();
let tick = 0, others = [0, 0];

function begin() {
  const distance = Number(at('distance').value);
  at('distance-text').textContent = `${distance} units`;
  tick = 0;
  others = [0, 0];
  wasm.begin(distance);
}

function path(context, [x, y, cosine, sine, halfX, halfY]) {
  context.beginPath();
  if (halfY === 0) {
    context.arc(x, y, halfX, 0, 7);
  } else {
    [[1, 1], [-1, 1], [-1, -1], [1, -1]].forEach(([i, j], corner) => {
      const dx = i * halfX, dy = j * halfY;
      context[corner === 0 ? 'moveTo' : 'lineTo'](x + dx * cosine - dy * sine, y + dx * sine + dy * cosine);
    });
  }
  context.closePath();
}

function draw(scalar, home) {
  const canvas = at(`scene-${scalar}`), context = canvas.getContext('2d');
  const width = canvas.clientWidth * devicePixelRatio, height = canvas.clientHeight * devicePixelRatio;
  if (canvas.width !== width) Object.assign(canvas, { width, height });
  const scale = width / 30;
  context.setTransform(scale, 0, 0, -scale, width / 2, height * 0.86);
  context.fillStyle = '#0d1524';
  context.fillRect(-20, -10, 40, 40);
  const lines = numbers(wasm.rays_at(scalar), rays + 2), [x, y] = lines.slice(rays);
  context.lineWidth = 0.02;
  context.strokeStyle = 'rgba(255, 215, 94, 0.35)';
  context.beginPath();
  for (let i = 0; i < rays; ++i) {
    const turn = (2 * Math.PI * i) / rays, reach = lines[i] < 0 ? 20 : lines[i];
    context.moveTo(x, y);
    context.lineTo(x + reach * Math.cos(turn), y + reach * Math.sin(turn));
  }
  context.stroke();
  const bodies = numbers(wasm.bodies_at(scalar), 6 * wasm.body_count());
  for (let i = 0; i < bodies.length; i += 6) {
    path(context, bodies.slice(i, i + 6));
    context.fillStyle = i === 0 ? '#3f5a3c' : bodies[i + 5] === 0 ? '#d8483c' : '#b98850';
    context.fill();
    context.strokeStyle = '#2a1a0c';
    context.lineWidth = 0.05;
    context.stroke();
  }
  context.strokeStyle = '#ffab4a';
  context.lineWidth = 0.04;
  for (let i = 6; i < home.length; i += 6) {
    path(context, home.slice(i, i + 6));
    context.stroke();
  }
}

function say(scalar) {
  const far = wasm.farthest(scalar);
  others[scalar] += wasm.other_rays(scalar);
  const text = far === 0 && others[scalar] === 0
    ? 'Every body and every ray is equal, bit for bit.'
    : `A body is ${far.toPrecision(2)} units off; ${others[scalar].toLocaleString('en')} of ${(rays * tick).toLocaleString('en')} rays give another result.`;
  at(`said-${scalar}`).textContent = text;
  at(`said-${scalar}`).classList.toggle('bad', far !== 0 || others[scalar] !== 0);
}

let due = performance.now();
function frame(now) {
  requestAnimationFrame(frame);
  if (now < due) return;
  due = Math.max(due + 1000 / 60, now - 50);
  if (tick === ticks) return;
  ++tick;
  wasm.step();
  for (const scalar of [0, 1]) {
    draw(scalar, numbers(wasm.home_at(scalar), 6 * wasm.body_count()));
    say(scalar);
  }
}

at('distance').addEventListener('input', begin);
at('again').addEventListener('click', begin);
begin();
requestAnimationFrame(frame);
window.exact = { wasm, ticks: () => tick, others: () => others };
