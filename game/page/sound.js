// SPDX-License-Identifier: MIT
// A few synthesised sounds: a band that snaps, a thud, a fanfare.

let context = null;
export const sound = { isOn: true };

// Browsers require a user gesture first.
for (const gesture of ['pointerdown', 'keydown']) {
  addEventListener(gesture, () => { context ??= new AudioContext(); }, { once: true });
}

function tone(from, to, seconds, volume, type = 'triangle', delay = 0) {
  if (!context || !sound.isOn || context.state !== 'running') return;
  const start = context.currentTime + delay;
  const oscillator = new OscillatorNode(context, { type });
  const gain = new GainNode(context, { gain: volume });
  oscillator.frequency.setValueAtTime(from, start);
  oscillator.frequency.exponentialRampToValueAtTime(to, start + seconds);
  gain.gain.exponentialRampToValueAtTime(0.001, start + seconds);
  oscillator.connect(gain).connect(context.destination);
  oscillator.start(start);
  oscillator.stop(start + seconds);
}

export const snap = () => tone(520, 140, 0.16, 0.12);
export const thud = (force) => tone(130, 45, 0.18, 0.1 + 0.25 * force, 'sine');
export const fanfare = () => [523, 659, 784, 1047].forEach((pitch, i) => tone(pitch, pitch, 0.28, 0.09, 'triangle', 0.13 * i));
