/** The release of the page that the browser keeps, so that it starts offline, and the one that comes after it. */
import { besideFiles } from './platform';
import { scriptAddress } from './trusted';

/** As `tools/lib/page.mjs` names it. */
const SCRIPT = 'service-worker.js';

/** A page that stays open asks so often, in ms, whether there is a later release. */
const ASK_AGAIN_MS = 3600_000;

export interface Releases {
  /** A later release is ready; `take` replaces this one by it, in all tabs. */
  ready: (take: () => void) => void;
  /** A later release has taken the place of this one: the page no longer fits the files. */
  replaced: () => void;
}

/** Has the browser keep the page's files. What stands in the way is no fault: the page then needs its host at each start. */
export async function keepRelease({ ready, replaced }: Releases): Promise<void> {
  // Absent where the page comes by plain http from another machine.
  const { serviceWorker } = navigator as { serviceWorker?: ServiceWorkerContainer };
  if (serviceWorker === undefined || !besideFiles() || import.meta.env.DEV) return;
  const isKept = serviceWorker.controller !== null;
  const registration = await serviceWorker.register(scriptAddress(new URL(SCRIPT, document.baseURI).href), { updateViaCache: 'none' });
  const offer = () => {
    const { waiting } = registration;
    if (waiting !== null && isKept) ready(() => waiting.postMessage('take over'));
  };
  offer();
  registration.addEventListener('updatefound', () => registration.installing?.addEventListener('statechange', offer));
  serviceWorker.addEventListener('controllerchange', () => {
    if (isKept) replaced();
  });
  let asked = Date.now();
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState !== 'visible' || Date.now() - asked < ASK_AGAIN_MS) return;
    asked = Date.now();
    void registration.update().catch(() => undefined);
  });
}

interface Launch {
  files: readonly { getFile: () => Promise<File> }[];
}
declare const launchQueue: { setConsumer: (take: (launch: Launch) => void) => void } | undefined;

/** Files that the system opens with the installed page. */
export function watchLaunches(open: (file: File) => Promise<void>): void {
  if (typeof launchQueue === 'undefined') return;
  launchQueue.setConsumer(({ files }) => {
    for (const file of files) void file.getFile().then(open);
  });
}
