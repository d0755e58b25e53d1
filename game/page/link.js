// SPDX-License-Identifier: MIT
// A simulated link that delays and loses packets. The caller passes the time.

export const weather = { latency: 60, loss: 0.1 };

export class Link {
  constructor() { this.flying = []; }

  send(packet, now) {
    if (Math.random() < weather.loss) return;
    this.flying.push({ packet, when: now + weather.latency * (1 + 0.2 * Math.random()) });
  }

  deliver(now, take) {
    const due = this.flying.filter((flight) => flight.when <= now);
    this.flying = this.flying.filter((flight) => flight.when > now);
    for (const flight of due) take(flight.packet);
  }
}
