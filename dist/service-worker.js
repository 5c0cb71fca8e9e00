(function() {
	// www/service-worker.ts
	var here = self;
	var PREFIX = `tiepoint ${here.registration.scope} `;
	var OWN = `${PREFIX}${RELEASE.name}`;
	var addressOf = (file) => new URL(file, here.registration.scope).href;
	async function fetchRelease() {
		const kept = await caches.open(OWN);
		const files = Object.entries(RELEASE.files).map(async ([file, integrity]) => {
			const address = addressOf(file);
			const answer = await fetch(address, {
				integrity,
				cache: "no-cache"
			});
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
	async function dropOthers() {
		const names = await caches.keys();
		await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== OWN).map((name) => caches.delete(name)));
	}
	function fileOf({ method, url }) {
		const { origin, pathname } = new URL(url);
		const { scope } = here.registration;
		const address = `${origin}${pathname}`;
		if (method !== "GET" || !address.startsWith(scope)) return null;
		const file = address.slice(scope.length).replace(/^index\.html$/, "");
		return file in RELEASE.files ? file : null;
	}
	here.addEventListener("install", (event) => event.waitUntil(fetchRelease()));
	here.addEventListener("activate", (event) => event.waitUntil(dropOthers()));
	here.addEventListener("fetch", (event) => {
		const file = fileOf(event.request);
		if (file === null) return;
		event.respondWith(caches.open(OWN).then((kept) => kept.match(addressOf(file))).then((answer) => answer ?? fetch(event.request)));
	});
	here.addEventListener("message", ({ data }) => {
		if (data === "take over") here.skipWaiting();
	});
})();
