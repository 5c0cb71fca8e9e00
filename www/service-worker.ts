/**
 * Keeps the files of one release of the page, so that it starts without a network, and always with files that belong together. A later release is fetched
 * whole, and waits until the user asks for it.
 */

/** What `tools/lib/compose.mjs` writes before this script: the name of the release, and its files with their digests. */
declare const RELEASE: { name: string; files: Readonly<Record<string, string>> };

interface Lasting extends Event {
  waitUntil: (until: Promise<unknown>) => void;
}
interface Asking extends Event {
  request: Request;
  respondWith: (answer: Promise<Response>) => void;
}
/** What of its surroundings it uses. */
interface Surroundings {
  addEventListener: {
    (type: 'install' | 'activate', listener: (event: Lasting) => void): void;
    (type: 'fetch', listener: (event: Asking) => void): void;
    (type: 'message', listener: (event: MessageEvent) => void): void;
  };
  skipWaiting: () => Promise<void>;
  registration: { scope: string };
}
const here = self as unknown as Surroundings;

const PREFIX = `tiepoint ${here.registration.scope} `;
const OWN = `${PREFIX}${RELEASE.name}`;

const addressOf = (file: string) => new URL(file, here.registration.scope).href;

/** Fetches all files of the release; one that is of another release is refused by its digest. */
async function fetchRelease(): Promise<void> {
  const kept = await caches.open(OWN);
  const files = Object.entries(RELEASE.files).map(async ([file, integrity]) => {
    const address = addressOf(file);
    const answer = await fetch(address, { integrity, cache: 'no-cache' });
    if (!answer.ok) throw new Error(`${address}: HTTP ${String(answer.status)}`);
    await kept.put(address, answer);
  });
  try {
    await Promise.all(files);
  } catch (error) {
    await caches.delete(OWN);
    throw error;
  }
}

async function dropOthers(): Promise<void> {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== OWN).map((name) => caches.delete(name)));
}

/** The file of the release that a request asks for; null where it is none. What stands behind ? and # is the page's own affair. */
function fileOf({ method, url }: Request): string | null {
  const { origin, pathname } = new URL(url);
  const { scope } = here.registration;
  const address = `${origin}${pathname}`;
  if (method !== 'GET' || !address.startsWith(scope)) return null;
  const file = address.slice(scope.length).replace(/^index\.html$/, '');
  return file in RELEASE.files ? file : null;
}

here.addEventListener('install', (event) => event.waitUntil(fetchRelease()));
here.addEventListener('activate', (event) => event.waitUntil(dropOthers()));
here.addEventListener('fetch', (event) => {
  const file = fileOf(event.request);
  if (file === null) return;
  event.respondWith(
    caches
      .open(OWN)
      .then((kept) => kept.match(addressOf(file)))
      .then((answer) => answer ?? fetch(event.request)),
  );
});
here.addEventListener('message', ({ data }) => {
  if (data === 'take over') void here.skipWaiting();
});
