// SPDX-License-Identifier: MIT
// Once loaded, the page works offline. So does the corpus, which is loaded on demand. game/build
// replaces the names in capitals.
const cacheName = 'slingshot-VERSION';
const files = FILES;

addEventListener('install', (event) => {
  event.waitUntil(caches.open(cacheName).then((cache) => cache.addAll(files)).then(() => skipWaiting()));
});
addEventListener('activate', (event) => {
  event.waitUntil((async () => {
    for (const name of await caches.keys()) if (name !== cacheName) await caches.delete(name);
    await clients.claim();
  })());
});
addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET') return;
  event.respondWith(request.url.includes('/corpus/') ? fetchCorpus(request)
    : caches.match(request, { ignoreSearch: true }).then((found) => found ?? fetch(request)));
});

// Files of this version come from the cache; the list comes from the server if it is reachable.
async function fetchCorpus(request) {
  const cache = await caches.open(cacheName), isList = request.url.endsWith('.json');
  const kept = await cache.match(request);
  if (kept && !isList) return kept;
  try {
    const response = await fetch(request);
    if (response.ok) await cache.put(request, response.clone());
    return response;
  } catch {
    return kept ?? Response.error();
  }
}
