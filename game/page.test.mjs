// SPDX-License-Identifier: MIT
//
// usage: node page.test.mjs FOLDER [FRAMES | corpus]
// Tests the page that game/build made in FOLDER, in Chromium: two machines in one page; two pages
// with the relay and lost packets; then a match of four, played by two pages and two processes of
// game/check's program. Players leave and return, and others watch. It also flips a bit, saves and
// drops a replay, plays by keyboard, mouse and touch, goes offline, and visits the two other rooms. Pictures go to FOLDER. Most of it runs at several times normal speed;
// pages then draw only once a minute and for pictures, because drawing without a GPU is slow. With FRAMES,
// plays only the match of four, for that many frames, with one program on an emulated big-endian machine.
// With `corpus`, checks only the whole corpus.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const folder = `${resolve(process.argv[2])}/`;
const parsed = (text) => Object.fromEntries(text.trim().split('\n').map((line) => line.split(' ')));
const goldenOf = (file) => parsed(readFileSync(new URL(file, import.meta.url), 'utf8'));
const golden = goldenOf('golden.txt'), isLong = process.argv.length > 3, isCorpus = process.argv[3] === 'corpus';
// game/check plays all 3,000 frames of the match of four on both of its machines.
const frames = isLong && !isCorpus ? Number(process.argv[3]) : 600;
const { chromium } = createRequire(folder)('playwright-core');
const { WebSocket } = createRequire(folder)('ws');
const seed = 2026;  // the seed of golden.txt

const relay = spawn('node', [`${folder}relay.mjs`, '--port', '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
const address = await new Promise((done) => { relay.stdout.once('data', (line) => done(String(line).trim())); });
const profile = mkdtempSync(join(tmpdir(), 'slingshot-'));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: '/usr/bin/chromium',
  acceptDownloads: true,
  viewport: { width: 1280, height: 860 },
  args: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});
const errors = [];

async function open(query, path = '') {
  const page = await browser.newPage();
  page.setDefaultTimeout(isLong ? 7_200_000 : 600_000);
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  page.on('pageerror', (error) => errors.push(error.stack));
  await page.goto(`${address}${path}?${query}`);
  if (path === '') await page.waitForFunction(() => window.slingshot);
  return page;
}
async function check(name, body) {
  const start = Date.now();
  await body();
  console.log(`${name}: ${((Date.now() - start) / 1000).toFixed(1)} s`);
}
const upTo = (frames, digests) => Object.fromEntries(Object.entries(digests).filter(([frame]) => frame <= frames));
// The digests of all frames played so far.
async function untilPlayed(page, frames) {
  await page.waitForFunction((n) => slingshot.milestones()[n], frames, { polling: isLong ? 1000 : 50 });
  return upTo(frames, await page.evaluate(() => slingshot.milestones()));
}

// A picture of a page that draws rarely.
async function picture(page, name) {
  await page.evaluate(() => new Promise((done) => {
    slingshot.redraw();
    requestAnimationFrame(() => requestAnimationFrame(done));
  }));
  await page.screenshot({ path: `${folder}${name}.png` });
}

async function drop(page, file) {
  const dataTransfer = await page.evaluateHandle((bytes) => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array(bytes)], 'match.dtnr'));
    return data;
  }, [...readFileSync(file)]);
  await page.dispatchEvent('body', 'dragover', { dataTransfer });
  await page.dispatchEvent('body', 'drop', { dataTransfer });
}

// A match of four, played by two pages and two programs.
async function playFour() {
  const isBig = isLong && existsSync(`${folder}s390x`);
  const join = (...program) => {
    const process = spawn('node', [`${folder}relay_peer.mjs`, '--room', 'four', '--players', '4', '--seed', seed,
      '--speed', '8', '--loss', '0.15', address, ...program], { stdio: ['ignore', 'pipe', 'inherit'] });
    const peer = { process, said: '', left: new Promise((done) => { process.on('exit', done); }) };
    process.stdout.on('data', (text) => { peer.said += text; });
    return peer;
  };
  const programs = [[`${folder}native`], isBig ? ['qemu-s390x', `${folder}s390x`] : [`${folder}native`]];
  await check(`two pages, a program and one ${isBig ? 'on s390x' : 'more'} play ${frames} frames`, async () => {
    const peers = programs.map((program) => join(...program));
    const query = `room=four&players=4&auto&seed=${seed}&speed=8&loss=15&latency=60&redraw=60000`;
    const start = Date.now(), pages = [await open(query)];
    await pages[0].waitForFunction(() => document.getElementById('notice').textContent.includes('3 of 4 are here'));
    pages.push(await open(query));
    const all = isLong ? parsed(execFileSync(programs[0][0], ['steps', String(frames), '4'], { encoding: 'utf8' }))
      : upTo(frames, goldenOf('golden-4.txt'));
    assert.ok(all[frames]);
    assert.deepEqual(await Promise.all(pages.map((page) => untilPlayed(page, frames))), [all, all]);
    const seconds = Math.round((Date.now() - start) / 1000);
    const last = new RegExp(`^${frames} .*\\n`, 'm');
    for (const peer of peers) {
      while (!last.test(peer.said)) await pages[0].waitForTimeout(50);
      const { index, 0: line } = last.exec(peer.said);
      assert.deepEqual(parsed(peer.said.slice(0, index + line.length)), all);
    }
    const [again, bytes] = await pages[0].evaluate(() => [slingshot.peers[0].wasm.resimulated() / slingshot.peers[0].wasm.frame(),
      (slingshot.sent() / slingshot.peers[0].wasm.frame()) * 60 / 3]);
    console.log(`${Object.keys(all).length} digests equal, the last ${all[frames]}; ${seconds} s; a page simulated `
      + `${again.toFixed(2)} frames again for each and sent ${Math.round(bytes)} bytes per 60 frames to each other player`);
    await picture(pages[0], 'four');

    // One player leaves and the others continue.
    await pages[1].close();
    await pages[0].waitForFunction(() => document.getElementById('notice').textContent.includes('has left; the match goes on'));
    const reached = await pages[0].evaluate(() => slingshot.peers[0].wasm.matched_frame());
    await pages[0].waitForFunction((frame) => slingshot.peers[0].wasm.matched_frame() > frame + 60, reached);
    // A program takes the seat and has the digests of all frames before it joined.
    peers.push(join(...programs[0]));
    while (!peers[2].said.includes('\n')) await pages[0].waitForTimeout(50);
    const [[frame, digest]] = Object.entries(parsed(peers[2].said));
    assert.equal((await untilPlayed(pages[0], Number(frame)))[frame], digest);
    assert.equal(await pages[0].textContent('#verdict'), 'equal');
    for (const peer of peers) peer.process.kill();
    assert.deepEqual(await Promise.all(peers.map((peer) => peer.left)), [0, 0, 0]);
    await pages[0].close();
  });
}

// The whole corpus: the digest of all digests is the one that `detent verify` prints.
async function askAll() {
  const [, expected] = /^ *all +\d+ +([0-9a-f]{16}) +ok$/m.exec(readFileSync(new URL('../docs/verify.md', import.meta.url), 'utf8'));
  await check(`this machine gives the golden answers to all questions: ${expected}`, async () => {
    const page = await open('', 'machine.html');
    await page.click('#whole');
    await page.waitForFunction(() => window.machine.isDone, null, { polling: 1000 });
    const { golden: right, count, total, all } = await page.evaluate(() => window.machine);
    assert.deepEqual([right, count, all], [total, total, expected]);
    assert.ok((await page.textContent('#card')).includes(`all: ${expected}`));
    await page.screenshot({ path: `${folder}corpus.png` });
    await page.close();
  });
}

async function playAll() {
  await check('the relay passes packets to the player that they are for, and nothing else', async () => {
    const sockets = [], heard = [[], []];
    for (const i of [0, 1]) {
      const socket = new WebSocket(`${address.replace('http', 'ws')}room/relay`);
      socket.on('message', (data, isBinary) => heard[i].push(isBinary ? [...data] : JSON.parse(data)));
      await new Promise((done) => { socket.once('message', done); });
      sockets.push(socket);
    }
    assert.deepEqual(heard[1], [{ is: 'start', seed: '1', life: 0, here: [0], self: 1, players: 2 }]);
    for (const packet of [[], [0, 1], [2, 1], [255], [7, 7]]) sockets[0].send(new Uint8Array(packet));
    sockets[0].send('text');
    sockets[0].send(new Uint8Array([1, 42, 43]));
    await new Promise((done) => { sockets[1].once('message', done); });
    // Four more may watch; further peers are rejected.
    const watchers = [], answers = [];
    for (let i = 0; i < 5; ++i) {
      watchers.push(new WebSocket(`${address.replace('http', 'ws')}room/relay?watch`));
      answers.push(JSON.parse(await new Promise((done) => { watchers[i].once('message', done); })));
    }
    assert.deepEqual(answers.map((each) => each.self ?? each.is), [2, 3, 4, 5, 'full']);
    assert.deepEqual(answers[1], { is: 'start', seed: '1', life: 2, here: [0, 1, 2], self: 3, players: 2 });
    const isSaid = (i, what) => heard[i].some((each) => JSON.stringify(each) === JSON.stringify(what));
    const until = async (holds) => { while (!holds()) await new Promise((done) => { setTimeout(done, 5); }); };
    await until(() => isSaid(1, { is: 'came', who: 5, self: 1, players: 2 }));
    watchers[0].close();
    await until(() => isSaid(1, { is: 'left', who: 2, self: 1, players: 2 }));
    sockets[0].send(new Uint8Array(5000));  // too large: the relay disconnects
    await until(() => isSaid(1, { is: 'left', who: 0, self: 1, players: 2 }));
    assert.deepEqual(heard[1][1], [0, 42, 43]);
    assert.deepEqual(heard[1].filter(Array.isArray).length, 1);
    assert.deepEqual(heard[0].slice(0, 2).map((each) => each.is), ['waiting', 'start']);
    // A returning player gets the free seat.
    const again = new WebSocket(`${address.replace('http', 'ws')}room/relay?seat=1`);
    const { self, life } = JSON.parse(await new Promise((done) => { again.once('message', done); }));
    assert.deepEqual([self, life], [0, 5]);
    for (const socket of [...watchers, again, sockets[1]]) socket.close();
  });

  const alone = await open(`auto&seed=${seed}&speed=10&latency=100&loss=15&redraw=60000`);
  await check('two machines in a page play 3,000 frames as every other machine does', async () => {
    assert.deepEqual(await untilPlayed(alone, 3000), golden);
    assert.equal(await alone.textContent('#verdict'), 'equal');
    await picture(alone, 'alone');
  });

  await check('a replay is saved, dropped on the page and plays to the same digests', async () => {
    const [download] = await Promise.all([alone.waitForEvent('download'), alone.click('#save')]);
    const file = join(profile, 'match.dtnr');
    await download.saveAs(file);
    const frames = Number(/-(\d+)\.dtnr$/.exec(download.suggestedFilename())[1]);
    assert.ok(frames >= 3000);
    await drop(alone, file);
    await alone.waitForFunction(() => document.getElementById('notice').textContent.includes('over'));
    const said = await alone.textContent('#notice');
    assert.equal(Number(/(\d+) frames, all digests equal/.exec(said)?.[1]), frames);
    const bytes = readFileSync(file);
    bytes[bytes.length >> 1] ^= 1;
    writeFileSync(file, bytes);
    await drop(alone, file);
    await alone.waitForFunction(() => document.getElementById('notice').textContent.includes('has changed after'));
    assert.ok(Number(/after (\d+) frames/.exec(await alone.textContent('#notice'))[1]) < frames);
    bytes[0] ^= 1;
    writeFileSync(file, bytes);
    await alone.setInputFiles('#open', file);
    await alone.waitForFunction(() => document.getElementById('notice').textContent.includes('no replay'));
  });
  await alone.close();

  await check('a bit that is flipped is named, by frame, object and field, within 60 frames', async () => {
    const page = await open('auto&seed=7&speed=2&redraw=60000'), heard = [];
    await page.exposeFunction('hear', (text) => heard.push(text));
    await page.evaluate(() => new MutationObserver(() => window.hear(document.querySelector('[role=status]#status').textContent))
      .observe(document.getElementById('status'), { childList: true }));
    await page.waitForFunction(() => slingshot.peers[1].wasm.frame() > 30);
    await page.click('#flip');
    await page.waitForFunction(() => document.getElementById('desync').textContent !== '');
    const said = await page.textContent('#desync');
    assert.match(said, /in frame \d+, .*bodies body \d+:\d+ \(obb\) velocity\.x, a wooden block of (red|blue)/);
    const frames = Number(/detected (\d+) frames later/.exec(said)[1]);
    assert.ok(frames > 0 && frames <= 60, said);
    assert.equal(await page.textContent('#verdict'), 'DIFFERENT');
    // Screen readers announce both: the digests from a live region, and the field at once.
    assert.match(heard.join(), /The digests differ since frame \d+/);
    assert.equal(await page.locator('#desync').getAttribute('role'), 'alert');
    await picture(page, 'desync');
    await page.close();
  });

  await check('two pages and the relay play 1,200 frames', async () => {
    const query = `room=test&auto&seed=${seed}&speed=8&loss=15&latency=60&redraw=60000`;
    const pages = [await open(query), await open(query)];
    const said = await Promise.all(pages.map((page) => untilPlayed(page, 1200)));
    assert.deepEqual(said, [upTo(1200, golden), upTo(1200, golden)]);
    await picture(pages[1], 'remote');

    // One reloads the page and returns to its seat, and another one watches.
    const name = await pages[1].textContent('#name-0');
    await pages[1].reload();
    await pages[1].waitForFunction(() => window.slingshot?.peers[0].wasm.is_player()
      && slingshot.peers[0].wasm.start_frame() > 1200);
    assert.equal(await pages[1].textContent('#name-0'), name);
    pages.push(await open(`${query}&watch`));
    await pages[2].waitForFunction(() => slingshot.mode() === 'remote' && slingshot.peers[0].wasm.start_frame() > 1200);
    assert.equal(await pages[2].textContent('#name-0'), 'You are watching');
    const last = 600 * Math.ceil(await pages[2].evaluate(() => slingshot.peers[0].wasm.frame()) / 600);
    const digests = await Promise.all(pages.map(async (page) => (await untilPlayed(page, last))[last]));
    assert.deepEqual(digests, [digests[0], digests[0], digests[0]]);
    for (const page of pages) assert.equal(await page.textContent('#verdict'), 'equal');
    const [download] = await Promise.all([pages[1].waitForEvent('download'), pages[1].click('#save')]);
    const file = join(profile, 'late.dtnr');
    await download.saveAs(file);
    await picture(pages[2], 'watch');
    await pages[2].setInputFiles('#open', file);  // of a match, from the middle on
    await pages[2].waitForFunction(() => /over: \d+ frames, all digests equal/.test(document.getElementById('notice').textContent));
    await pages[2].close();

    // The relay fails and comes back, and so do the peers it lost.
    await pages[1].evaluate(() => slingshot.hangUp());
    await pages[0].waitForFunction(() => document.getElementById('notice').textContent.includes('comes back'));
    await pages[1].waitForFunction((frame) => slingshot.peers[0].wasm.is_player()
      && slingshot.peers[0].wasm.start_frame() > frame, last);
    await pages[1].close();
    await pages[0].waitForFunction(() => document.getElementById('notice').textContent.includes('has left'));
    await pages[0].close();
  });

  await playFour();

  await check('it is played by keyboard, mouse, touch and labelled sliders', async () => {
    const page = await open('seed=3&loss=0&latency=0&speed=2');
    await page.uncheck('#computer');
    const shots = () => page.waitForFunction(() => slingshot.peers[0].match().pieces
      .some((piece) => piece.kind === 'ball' && piece.owner === 0 && piece.age < 120));
    const isReady = () => page.waitForFunction(() => slingshot.peers[0].match().catapults[0].reload === 0
      && !slingshot.peers[0].match().pieces.some((piece) => piece.kind === 'ball' && piece.age < 120));
    const angle = () => page.evaluate(() => Number(document.getElementById('angle-0').value));
    await isReady();
    const before = await angle();
    await page.keyboard.down('KeyW');
    await page.waitForTimeout(300);
    await page.keyboard.up('KeyW');
    assert.ok(await angle() > before);
    await page.fill('#angle-0', '-8');  // aim at the ground: no king falls, no round ends
    await page.fill('#power-0', '30');
    await page.keyboard.press('Space');
    await shots();
    await isReady();
    const box = await page.locator('#canvas-0').boundingBox();
    await page.mouse.move(box.x + 200, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x + 120, box.y + 150, { steps: 4 });
    await page.screenshot({ path: `${folder}play.png` });
    assert.ok(Math.abs(await angle() - 32) < 1);
    await page.mouse.up();
    await shots();
    await isReady();
    const finger = await browser.newCDPSession(page);
    await finger.send('Emulation.setTouchEmulationEnabled', { enabled: true });
    const touch = (type, ...points) => finger.send('Input.dispatchTouchEvent', {
      type, touchPoints: points.map(([x, y]) => ({ x: box.x + x, y: box.y + y })),
    });
    await touch('touchStart', [200, 100]);
    await touch('touchMove', [160, 140]);
    await touch('touchMove', [150, 150]);
    assert.ok(Math.abs(await angle() - 45) < 1);
    await touch('touchEnd');
    await shots();
    await page.close();
  });

  await check('two machines stand side by side; a link invites another; sliders change the wire', async () => {
    const pages = [await open('seed=4&speed=2&redraw=60000')];
    const boxes = await Promise.all([0, 1].map((i) => pages[0].locator(`#canvas-${i}`).boundingBox()));
    assert.ok(boxes[0].y === boxes[1].y && boxes[0].x + boxes[0].width <= boxes[1].x);
    await pages[0].fill('#loss', '30');
    await pages[0].fill('#latency', '20');
    assert.deepEqual(await Promise.all(['loss', 'latency'].map((each) => pages[0].textContent(`#${each}-text`))), ['30 %', '20 ms']);
    await pages[0].click('#invite');
    await pages[0].waitForFunction(() => document.getElementById('notice').textContent.includes('1 of 2 are here'));
    const [link] = /http\S+/.exec(await pages[0].textContent('#notice'));
    assert.equal(link, pages[0].url());
    pages.push(await open(`${new URL(link).search.slice(1)}&speed=2&redraw=60000`));
    for (const page of pages) await page.waitForFunction(() => slingshot.peers[0].wasm.matched_frame() > 60);
    const [red, blue] = await Promise.all(pages.map((page) => page.textContent('#name-0')));
    assert.deepEqual([red, blue], ['You are red', 'You are blue']);
    for (const page of pages) await page.close();
  });

  const everywhere = ['The match', 'Exact against float', 'Your machine'];
  for (const [path, names] of [
    ['', ['New match', 'Invite a friend', 'Invite three', 'Pause', 'Sound', 'Blue is the computer', ...everywhere, /^The field as red/,
      'Angle', 'Power', 'Shoot', /^The field as blue/, 'Latency, one way', 'Packets lost', /^Flip one bit/, 'Save replay', 'Open replay']],
    ['exact.html', [...everywhere, 'Distance from the origin, along both axes', 'Again']],
    ['machine.html', [...everywhere, 'Ask 64 questions of each kind', 'Ask all of them']],
  ]) {
    await check(`/${path} is reached by keyboard and read by screen readers`, async () => {
      const page = await open('seed=3&speed=2&redraw=60000', path);
      await page.emulateMedia({ reducedMotion: 'reduce' });
      await page.waitForFunction(() => !document.querySelector('button:disabled'));
      await page.addScriptTag({ path: createRequire(folder).resolve('axe-core') });
      const { violations, passes } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map(({ id, nodes }) => [id, ...nodes.map(({ html }) => html)]), []);
      assert.ok(passes.length > 15);
      // Checks what the browser tells a screen reader, then the tab order.
      const reader = await browser.newCDPSession(page);
      const { nodes } = await reader.send('Accessibility.getFullAXTree');
      const has = (node, what) => node.properties?.some(({ name, value }) => name === what && value.value);
      const controls = nodes.filter((node) => has(node, 'focusable') && node.role.value !== 'RootWebArea');
      assert.equal(controls.length, names.length);
      for (const { role } of controls) assert.match(role.value, /^(button|checkbox|link|slider|image|img)$/i);
      for (const each of names) {
        const fits = ({ name }) => (each instanceof RegExp ? each.test(name.value) : each === name.value);
        assert.equal(controls.filter(fits).length, 1, `${each}: ${controls.map(({ name }) => name.value)}`);
      }
      const inOrder = await page.evaluate(() => [...document.querySelectorAll('a, button, input, canvas[tabindex]')]
        .filter((each) => each.checkVisibility({ checkVisibilityCSS: true })).map((each) => each.id || each.textContent));
      for (const each of inOrder) {
        await page.keyboard.press('Tab');
        const [is, outline] = await page.evaluate(() => {
          const { activeElement: here } = document;
          return [here.id || here.textContent, getComputedStyle(here.closest('.file') ?? here).outline];
        });
        assert.equal(is, each);
        assert.match(outline, /solid 3px/);
      }
      if (path === '') {
        assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById('banner-0')).transitionDuration), '0s');
      }
      await page.close();
    });
  }

  await check('far from the origin q16_16 is equal, bit by bit, and float is not', async () => {
    const page = await open('', 'exact.html');
    await page.waitForFunction(() => window.exact);
    const [fixed, floating] = await page.evaluate(() => {
      const { wasm } = window.exact, rays = [0, 0];
      wasm.begin(20000);
      for (let i = 0; i < 300; ++i) {
        wasm.step();
        for (const scalar of [0, 1]) rays[scalar] += wasm.other_rays(scalar);
      }
      return [0, 1].map((scalar) => ({ far: wasm.farthest(scalar), rays: rays[scalar] }));
    });
    assert.deepEqual(fixed, { far: 0, rays: 0 });
    assert.ok(floating.far > 0.1 && floating.rays > 1000, JSON.stringify(floating));
    await page.screenshot({ path: `${folder}exact.png` });
    await page.close();
  });

  await check('this machine gives the golden answers to what is compiled of the corpus', async () => {
    const page = await open('', 'machine.html');
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.waitForFunction(() => !document.getElementById('quick').disabled);
    assert.match(await page.textContent('#offer'), /^Both load \d+\.\d MB, in \d+ parts?, once/);
    await page.click('#quick');
    await page.waitForFunction(() => window.machine.isDone);
    const { golden: right, count, total, all } = await page.evaluate(() => window.machine);
    assert.ok(count >= 35 && right === count && total >= 199, `${right} of ${count}, ${total}`);
    assert.equal(all !== '', count === total);
    assert.ok((await page.textContent('#card')).includes(`${count} of ${count} queries have the golden digests`));
    await page.screenshot({ path: `${folder}machine.png` });
    await page.close();
  });

  await check('it works offline', async () => {
    const page = await open('auto&seed=5&speed=2&redraw=60000');
    await page.evaluate(() => navigator.serviceWorker.ready);
    relay.kill();
    await browser.setOffline(true);
    await page.reload();
    await page.waitForFunction(() => window.slingshot?.peers[0].wasm.frame() > 10);
    await page.goto(`${address}machine.html`);
    await page.click('#quick');
    await page.waitForFunction(() => window.machine.isDone);
    await page.close();
  });
}

try {
  await (isCorpus ? askAll() : isLong ? playFour() : playAll());
  assert.deepEqual(errors, []);
  console.log('no console errors');
} finally {
  relay.kill();
  await browser.close();
  rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
}
