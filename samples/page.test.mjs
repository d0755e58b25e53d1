// SPDX-License-Identifier: MIT
//
// usage: node page.test.mjs FOLDER
// Opens the gallery in FOLDER/page in Chromium, plays each sample with the button *Step* and
// compares its digests with golden.txt. It also presses keys, moves the pointer and goes offline.
// Pictures of the gallery and of each sample go to FOLDER.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = `${resolve(process.argv[2])}/`;
const { chromium } = createRequire(folder)('playwright-core');
const golden = new Map(readFileSync(new URL('golden.txt', import.meta.url), 'utf8').trim().split('\n').map((line) => {
  const [name, tick, digest] = line.split(' ');
  return [`${name} ${tick}`, digest];
}));

const serve = fileURLToPath(new URL('serve.mjs', import.meta.url));
const server = spawn('node', [serve, `${folder}page`, '--port', '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
const address = await new Promise((done) => { server.stdout.once('data', (line) => done(String(line).trim())); });
const profile = mkdtempSync(join(tmpdir(), 'samples-'));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: '/usr/bin/chromium', viewport: { width: 1000, height: 900 },
  args: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});
let failed = true;
try {
  const errors = [];
  const page = await browser.newPage();
  page.setDefaultTimeout(120_000);
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  page.on('pageerror', (error) => errors.push(error.stack));
  page.on('requestfailed', (request) => errors.push(`${request.url()} failed`));
  await page.goto(address);
  await page.waitForFunction(() => window.gallery);
  const names = await page.evaluate(() => gallery.names);
  assert.equal(names.length, 10);
  assert.equal(await page.locator('#cards a').count(), 10);
  await page.screenshot({ path: `${folder}gallery.png`, fullPage: true });

  // By keyboard: the first card has the focus after one Tab.
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.getElementById('name').textContent === 'rays');
  // It runs by itself.
  await page.waitForFunction(() => Number(document.getElementById('tick').textContent) > 3);
  await browser.setOffline(true);  // nothing more is fetched

  let compared = 0;
  for (const name of names) {
    const start = Date.now();
    await page.evaluate((to) => { location.hash = to; }, name);
    await page.waitForFunction((to) => document.getElementById('name').textContent === to, name);
    await page.click('#pause');
    assert.equal(await page.getAttribute('#pause', 'aria-pressed'), 'true');
    await page.click('#reset');
    const digests = await page.evaluate(() => {
      const text = (id) => document.getElementById(id).textContent, said = {};
      while (Number(text('tick')) < 240) {
        document.getElementById('step').click();
        if (Number(text('tick')) % 60 === 0) said[text('tick')] = text('digest');
      }
      return said;
    });
    for (const [tick, digest] of Object.entries(digests)) {
      assert.equal(digest, golden.get(`${name} ${tick}`), `${name} at tick ${tick}`);
      ++compared;
    }
    assert.ok((await page.textContent('#status')).length > 5);
    assert.ok((await page.getAttribute('#canvas', 'aria-label')).length > 20);
    // The canvas shows more than its background.
    const colours = await page.evaluate(() => new Promise((done) => {
      // The page draws in an earlier callback of the same frame, so what it drew is still there.
      document.getElementById('step').click();
      requestAnimationFrame(() => {
        const canvas = document.getElementById('canvas'), gl = canvas.getContext('webgl2');
        const pixels = new Uint32Array(canvas.width * canvas.height);
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
        done(new Set(pixels).size);
      });
    }));
    assert.ok(colours >= 8, `${name} shows ${colours} colours`);
    await page.locator('#canvas').screenshot({ path: `${folder}${name}.png` });
    console.log(`${name}: ${((Date.now() - start) / 1000).toFixed(1)} s`);
  }
  assert.equal(compared, golden.size);

  // Keys and the pointer affect the sample, and the page follows.
  const changed = async (name, act, ticks) => {
    await page.evaluate((to) => { location.hash = to; }, name);
    await page.waitForFunction((to) => document.getElementById('name').textContent === to, name);
    await page.click('#pause');
    await page.click('#reset');
    await act();
    const digest = await page.evaluate((until) => {
      while (Number(document.getElementById('tick').textContent) < until) document.getElementById('step').click();
      return document.getElementById('digest').textContent;
    }, ticks);
    assert.notEqual(digest, golden.get(`${name} ${ticks}`));
  };
  await changed('vehicle', async () => {
    await page.focus('#canvas');
    await page.keyboard.down('ArrowLeft');
  }, 60);
  await page.keyboard.up('ArrowLeft');
  await changed('rays', () => page.mouse.move(500, 400), 60);
  await changed('character', async () => {
    await page.locator('#pad [data-key=left]').dispatchEvent('pointerdown');
  }, 60);
  await browser.setOffline(false);
  const source = await page.evaluate(async () => (await fetch(document.getElementById('source').href)).text());
  assert.ok(source.includes('class Character'));
  assert.deepEqual(errors, []);
  console.log(`10 samples, ${compared} golden digests`);
  failed = false;
} finally {
  await browser.close();
  server.kill();
  rmSync(profile, { recursive: true, force: true });
  if (failed) process.exitCode = 1;
}
