import { ACCEPTED, Archive, BY_HAND as BY_HAND$3, CANDIDATE, CallError, Cancelled, EPIPOLAR, GEO_KEYS, Holder, IMAGE_FILE, Journal, Layers, MASK_SIDE, MEASURED, MODEL_TYPE, NO_HISTORY, NotListed, OWN_LIGHT, PointGrid, REDO_KEYS, REJECTED as REJECTED$1, REJECTED_BY_HAND, RESIDUAL, RESIDUAL_REJECTED, SCALE, SELECTED, SHAPES, SIDES, TIES, TRANSFORMATION, Table, UNDO_KEYS, WorkerClient, WorkerPool, acting_block_parameters, affine as affine$1, answerCard, asGiven, beforeSearch, block_flight_parameters, block_flight_preset, block_parameters, block_settings, breakdownOf, breath, byKeys, byReason, call_parameters, cameraFrom, carried_steps, check_cameras, check_control, check_geoid, choice, clamped, contains, crosshair, crossing, declare, declareLack, declarePlace, doHere, doneFrom, drawCross as drawCross$1, drawExpected, drawLine, drawView, draw_points, draw_vectors, drawerButton, facts, fieldsOf, fileButton, film_cameras, film_measurements, film_pattern, firstNamed, fitView, fitted as fitted$1, fitted$1 as fitted, geoKeys, geographic_positions, halfSize, hasData, hasKeys, image_measurement_table, inPane, interior, inverse, isCurrent, isHidden, isMeasured, isMode, isNothing, isOpen, isWhole, isWorthKeeping, keeping, kindsText, labelled, lensFrame, lensRect, lensTransform, likeOf, lineSwatch, listOf as listOf$1, listen, listenKeys, local_positions, makeFolded, makeLight, makeNear, makeSections, mapped, maskOf as maskOf$1, masks_of_images, message, messageOf, mountMenu, movedWith, nameOf as nameOf$2, namesText, numberInput, numbers, objectOf, ofLine, onLine, optionInLanguage, orNull, orient_fiducials, otherSide, paintBitmap, panned, parse_camera, parse_camera_rules, parse_fiducials, parse_ground_control_points, parse_image_measurements, parse_image_positions, passFocus, photo_camera, placeOfLeft, placeOfMark, placed_tables, placesByHand, placing_defaults, placing_parameters, positionFrom, positions_of_images, problemLine, readable, recorded, refusedKinds, remember, rememberCalibrations, resized, reveal as reveal$1, reveal$1 as reveal, ring, roundedPx, save, saveCsv, set, setDrawer, settingsText, showHistory, showIn, showSteps, showTab, shownPair, sidewaysNote, smooth, sortRasters, standingOf as standingOf$1, swatch, system_coordinates, system_positions, tabbed, takeHere, targetOfLeft, textIn, tiffDirectory, titleOf as titleOf$2, toCanvas, toPosition, toggle, transformOf, typed, uncoverPictures, undoKeys, unfolded, unitText, unlessLeft, vectorChoice, visiblePart, wantedLevel, watchDrawers, watchSideways, wentTo, whenInSight, withCoordinatesOf, withSetting, withUnit, within, words, zoomButtons, zoomed, zoomedAbout } from "./program.js";
import { arrange, asFigure, asSentence, button, byId, count, fill, fixed, h, keepChoice, keptChoice, refusedText, row, say, section, sentence } from "./page.js";
// www/block/engine/catalogue.ts
var offered$1 = (key) => key === "multiscale.number" || !/^(?:multiscale|gradient|nearest|geometry)\./u.test(key);
function blockCatalogue({ parameters, flightParameters }) {
	const own = block_parameters().map(optionInLanguage);
	const ofFlight = block_flight_parameters().map(optionInLanguage);
	const ofPlacing = placing_parameters().map(optionInLanguage);
	return {
		parameters: own.filter(({ key }) => offered$1(key)),
		defaults: block_settings({}),
		flightParameters: ofFlight,
		flight: block_flight_preset("small_photos"),
		placingParameters: ofPlacing,
		placing: placing_defaults(),
		levelParameter: call_parameters().find(({ key }) => key === "heights"),
		labels: {
			parameters: [
				...parameters,
				...own,
				...ofPlacing
			],
			flightParameters: [...flightParameters, ...ofFlight]
		}
	};
}
// www/block/engine/facts.ts
var MOST_LINES = 16;
var Facts = class {
	store;
	engine;
	of = null;
	answers = new Map();
	asked = new Set();
	listeners = [];
	waiting = [];
	constructor(store, engine) {
		this.store = store;
		this.engine = engine;
	}
	watch(arrived) {
		this.listeners.push(arrived);
	}
	get isAsked() {
		return this.asked.size > 0;
	}
	answered() {
		return new Promise((resolve) => this.waiting.push(resolve));
	}
	points(image) {
		return this.get(`points ${String(image)}`, () => this.engine.imagePoints(image));
	}
	observations() {
		const images = this.store.state.shown?.view.images.length ?? 0;
		return this.get("observations", () => this.engine.observations(images));
	}
	ground() {
		return (this.store.state.shown?.view.oriented ?? 0) === 0 ? null : this.get("ground", () => this.engine.ground());
	}
	point(index) {
		return this.get(`point ${String(index)}`, () => this.engine.pointDetail(index));
	}
	line(from, [x, y], to) {
		const name = `line ${[
			from,
			to,
			x,
			y
		].join(" ")}`;
		const lines = [...this.asked].filter((other) => other.startsWith("line"));
		if (!this.answers.has(name) && !this.asked.has(name) && lines.length >= MOST_LINES) return null;
		return this.get(name, () => this.engine.epipolarLine(from, x, y, to));
	}
	get(name, ask) {
		const { shown, running } = this.store.state;
		if (this.of !== (shown?.view ?? null)) this.forget(shown?.view ?? null);
		if (this.answers.has(name)) return this.answers.get(name);
		if (shown === null || shown.view.partial || running.kind === "yes" || this.asked.has(name)) return null;
		const { of } = this;
		this.asked.add(name);
		ask().then((answer) => {
			if (this.of !== of) return;
			this.asked.delete(name);
			this.keep(name, answer);
			for (const listener of this.listeners) listener();
			this.goOn(true);
		}, () => {
			if (this.of !== of) return;
			this.asked.delete(name);
			this.goOn(false);
		});
		return null;
	}
	keep(name, answer) {
		this.answers.set(name, answer);
		const lines = [...this.answers.keys()].filter((other) => other.startsWith("line"));
		for (const old of lines.slice(0, Math.max(0, lines.length - 128))) this.answers.delete(old);
	}
	forget(of) {
		this.of = of;
		this.answers.clear();
		this.asked.clear();
		this.goOn(true);
	}
	goOn(goesOn) {
		const { waiting } = this;
		this.waiting = [];
		for (const resolve of waiting) resolve(goesOn);
	}
};
// www/block/state/former.ts
function awaitedOf({ awaiting, history }) {
	return awaiting?.kept.edits === history.edits && awaiting.kept.done === history.done ? awaiting : null;
}
function nameOfTiePoints({ images, points }) {
	let code = 2166136261;
	const add = (value) => {
		code = Math.imul(code ^ value & 65535, 16777619);
		code = Math.imul(code ^ Math.floor(value / 65536), 16777619) >>> 0;
	};
	points.sources.forEach(add);
	points.rays.forEach(add);
	return JSON.stringify([
		images.map(({ name, features }) => [name, features]),
		points.count,
		code
	]);
}
function formerOf(former, before, after, left) {
	const last = former.at(-1);
	if (last === void 0 || last.kept.edits !== before.edits || last.kept.done !== before.done) return former;
	return [...former.slice(0, -1), {
		...last,
		kept: after,
		left: last.left.map((count) => left[count] ?? after.edits.length)
	}];
}
function withFormer(former, one) {
	return [...former.filter(({ tiePoints }) => tiePoints !== one.tiePoints), one].slice(-20);
}
function wayBack(former, tiePoints, history) {
	const way = [];
	let now = history;
	for (const one of [...former].reverse()) {
		if (one.kept.edits !== now.edits || one.kept.done !== now.done) continue;
		way.push(one);
		if (one.tiePoints === tiePoints) return way;
		now = one.history;
	}
	return [];
}
function placesBefore({ left, places }, now) {
	return now.length === places.length ? places : now.map(({ after }) => Math.max(0, left.lastIndexOf(after)));
}
// www/block/state/film.ts
var NO_FILM = {
	camera: null,
	marks: [],
	areScans: false,
	begun: []
};
function filmOf({ camera, marks }, image) {
	const own = marks.find(({ name }) => stemOf(name) === stemOf(image));
	return own === void 0 ? null : {
		camera: camera?.text ?? null,
		marks: own.text
	};
}
var isOfFrames = (pattern) => /^\*-film\d*\.png$/u.test(pattern);
var isFrame = (name) => /-film\d*\.png$/u.test(name);
function frameName(scan, pattern) {
	return pattern.replace("*", () => scan.replace(/\.[^.]*$/u, ""));
}
function possibleScans(images) {
	return images.filter(({ name }) => !isFrame(name));
}
function scansOf(film, images) {
	return film.camera !== null || film.areScans || framesOf(film, images).length > 0 ? possibleScans(images) : [];
}
function framesOf(film, images) {
	return images.filter(({ name }) => filmOf(film, name) !== null);
}
function awaitsFrames(film, images) {
	return scansOf(film, images).length > 0;
}
function withMarks(film, marks) {
	const byStem = new Map([...film.marks, ...marks].map((own) => [stemOf(own.name), own]));
	const given = new Set(marks.map(({ name }) => stemOf(name)));
	return {
		...film,
		marks: [...byStem.values()],
		begun: film.begun.filter(({ image }) => !given.has(stemOf(image)))
	};
}
function withBegun(film, shown, begun) {
	const others = film.begun.filter(({ image }) => !shown.includes(image));
	return begun.length === 0 && others.length === film.begun.length ? film : {
		...film,
		begun: [...others, ...begun]
	};
}
function marksOfNone({ marks }, images) {
	const stems = new Set(images.map(({ name }) => stemOf(name)));
	return marks.map(({ name }) => name).filter((name) => !stems.has(stemOf(name)));
}
function stemOf(name) {
	return name.replace(/\.[^.]*$/u, "").toLowerCase();
}
// www/block/state/placing.ts
function isLookedAtAlone(orthophoto) {
	return (orthophoto?.raster.degrees ?? null) !== null;
}
var NOTHING_LOOKED_AT = {
	image: null,
	link: null
};
var NO_PLACING = {
	orthophoto: null,
	heights: {
		kind: "level",
		height: 0
	},
	film: NO_FILM,
	options: null,
	purpose: null,
	placed: new Map(),
	running: null,
	elsewhere: "",
	chosen: NOTHING_LOOKED_AT,
	pointed: NOTHING_LOOKED_AT,
	picks: false,
	adds: false,
	draft: null,
	adjusting: null,
	uses: new Set([
		"used",
		"check",
		"rejected"
	])
};
function reducePlacing(placing, action) {
	switch (action.type) {
		case "orthophoto": return {
			...NO_PLACING,
			options: placing.options,
			film: placing.film,
			orthophoto: action.orthophoto
		};
		case "heights": return {
			...placing,
			heights: action.heights,
			orthophoto: placing.orthophoto === null ? null : {
				...placing.orthophoto,
				info: action.info
			}
		};
		case "film": return {
			...placing,
			film: action.film
		};
		case "placingOptions": return placing.options === null ? placing : {
			...placing,
			options: {
				...placing.options,
				...action.options
			},
			picks: false
		};
		case "purpose": return placing.purpose === action.purpose ? placing : {
			...placing,
			purpose: action.purpose,
			draft: null,
			picks: false,
			adds: false
		};
		case "placing": return {
			...placing,
			running: action.running
		};
		case "elsewhere": return placing.elsewhere === action.text ? placing : {
			...placing,
			elsewhere: action.text
		};
		case "placed": return {
			...placing,
			placed: new Map([...placing.placed, [action.image.id, action.placed]])
		};
		case "choosePlaced":
			if (isSameLooked(placing.chosen, action.looked)) return placing;
			return {
				...placing,
				chosen: action.looked,
				draft: placing.chosen.image === action.looked.image ? placing.draft : null
			};
		case "pointPlaced": return isSameLooked(placing.pointed, action.looked) ? placing : {
			...placing,
			pointed: action.looked
		};
		case "picksPlace": return {
			...placing,
			picks: action.picks,
			draft: null,
			adds: false
		};
		case "addsPlace": return {
			...placing,
			adds: action.adds,
			draft: null,
			picks: false
		};
		case "linkDraft": return {
			...placing,
			draft: action.draft,
			picks: false
		};
		case "adjustsLinks": return {
			...placing,
			adjusting: action.image
		};
		case "showLinks": {
			const uses = new Set(placing.uses);
			if (action.on) uses.add(action.use);
			else uses.delete(action.use);
			return {
				...placing,
				uses
			};
		}
	}
}
function isSameLooked(a, b) {
	return a.image === b.image && a.link === b.link;
}
// www/block/state/given-positions.ts
function givenPositions({ files, placing: { orthophoto }, options: { settings, positions } }) {
	return read(positions?.text ?? null, files, settings?.placing ?? null, orthophoto?.info.epsg ?? null);
}
var NONE$1 = new Map();
var read = remember((text, files, placing, epsg) => {
	if (text === null || placing === null) return NONE$1;
	const names = files.map(({ name }) => name);
	try {
		const crs = placing.crs ?? (epsg === null ? null : `EPSG:${String(epsg)}`);
		const given = positions_of_images(text, names, {
			...placing,
			crs
		});
		return new Map(names.flatMap((name, index) => given[index] ? [[name, given[index]]] : []));
	} catch {
		return NONE$1;
	}
});
// www/block/state/placed.ts
function placingKey({ placing: { orthophoto, heights, options }, options: { cameras } }) {
	const ground = heights.kind === "level" ? heights.height : `file ${String(heights.model.id)}`;
	return JSON.stringify([
		orthophoto?.raster.id ?? null,
		ground,
		options,
		cameras
	]);
}
function placingKeyOf(key, { film, positions }, image) {
	return keyWith(key, filmOf(film, image), positions.get(image) ?? null);
}
function keyWith(key, film, position) {
	return film === null && position === null ? key : JSON.stringify([
		key,
		film,
		position
	]);
}
function placedFiles(state) {
	return listed$1(state.files, state.placing.placed, placingKey(state), state.placing.film, givenPositions(state));
}
var listed$1 = remember((files, all, key, film, positions) => files.flatMap((file) => {
	const placed = all.get(file.id);
	return placed === void 0 ? [] : [{
		...placed,
		file,
		isStale: placed.key !== placingKeyOf(key, {
			film,
			positions
		}, file.name)
	}];
}));
function unplacedFiles(state) {
	const key = placingKey(state);
	const given = {
		film: state.placing.film,
		positions: givenPositions(state)
	};
	return state.files.filter(({ id, name }) => state.placing.placed.get(id)?.key !== placingKeyOf(key, given, name));
}
// www/block/state/edited.ts
var UNEDITED = {
	history: NO_HISTORY,
	before: null,
	adjusting: false,
	draft: null,
	former: [],
	awaiting: null
};
function figuresOf$3(view) {
	const { sigma0Px, rmsePx, oriented, points, checks, images } = view;
	const ofChecks = checks === null ? null : {
		rmseM: Math.hypot(...checks.rmse_m),
		points: checks.points
	};
	return {
		sigma0Px,
		rmsePx,
		oriented,
		points: points.taking,
		observations: images.reduce((sum, image) => sum + image.rays, 0),
		checks: ofChecks
	};
}
function comparedText(before, now) {
	const [checks, checksNow] = [before.checks, now.checks];
	const points = {
		points: checks?.points ?? 0,
		points_2: checksNow?.points ?? 0
	};
	const of = points.points === points.points_2 ? "" : say("of-so-many-check-points", points);
	return [
		say("n-0-px", {
			sigma0_px: figureText(before.sigma0Px),
			sigma0_px_2: figureText(now.sigma0Px)
		}),
		say("rmse-px", {
			rmse_px: figureText(before.rmsePx),
			rmse_px_2: figureText(now.rmsePx)
		}),
		checks === null && checksNow === null ? "" : say("check-points-m", {
			checks_m: figureText(checks?.rmseM ?? null),
			checks_m_2: figureText(checksNow?.rmseM ?? null),
			of
		}),
		before.oriented === now.oriented ? "" : say("images-oriented", {
			oriented: before.oriented,
			oriented_2: now.oriented
		})
	].filter((part) => part !== "").join(" · ");
}
function figureText(value) {
	return value === null ? "–" : fixed(value, 3);
}
var NO_PANES = {
	images: [],
	views: new Map(),
	active: null,
	look: {
		points: true,
		vectors: 0,
		linked: false,
		loupe: false,
		...OWN_LIGHT,
		unmeasured: false
	}
};
function reducePanes(panes, action) {
	switch (action.type) {
		case "showImages": return withImages(panes, action.images);
		case "moveViews": return {
			...panes,
			views: new Map([...panes.views, ...action.views].filter(([image]) => panes.images.includes(image)))
		};
		case "wholeImages": return {
			...panes,
			views: new Map()
		};
		case "activeImage": return panes.active === action.image ? panes : {
			...panes,
			active: action.image
		};
		case "look": return {
			...panes,
			look: {
				...panes.look,
				...action.look
			}
		};
	}
}
function withImages(panes, wanted) {
	const images = [...new Set(wanted)].slice(0, 9);
	const views = new Map([...panes.views].filter(([image]) => images.includes(image)));
	const active = panes.active !== null && images.includes(panes.active) ? panes.active : images[0] ?? null;
	return {
		...panes,
		images,
		views,
		active
	};
}
function shownImages(panes, view) {
	if (panes.images.length > 0) return panes.images;
	return view.images.slice(0, 4).map((_, image) => image);
}
function panesInOtherView(panes, before, after) {
	if (before === null || panes.images.length === 0) return {
		...NO_PANES,
		look: panes.look
	};
	const places = new Map(after.images.map(({ name }, image) => [name, image]));
	const place = (image) => places.get(before.images[image]?.name ?? "") ?? -1;
	const images = panes.images.map(place).filter((image) => image >= 0);
	const views = new Map([...panes.views].map(([image, looks]) => [place(image), looks]));
	const active = panes.active === null ? -1 : place(panes.active);
	return withImages({
		...panes,
		views,
		active: active < 0 ? null : active
	}, images);
}
// www/block/state/marks.ts
var LEAST_POINTS = 3;
var LEAST_PLACED = 1;
var LEAST_IMAGES$1 = 2;
var isFramesStep = (step) => step.kind === "make_frames";
var isMeasureStep = (step) => "marks" in step;
var pointsOfFile = remember((control) => readOr(control, parse_ground_control_points));
var coordinatesOf = remember((control) => new Map(pointsOfFile(control).map(({ name, position }) => [name, position])));
var marksOfFile = remember((marks, images) => {
	const names = images.map(({ name }) => name);
	return readOr(marks, (text) => parse_image_measurements(text, names));
});
function readOr(file, read) {
	try {
		return file === null ? [] : read(file.text);
	} catch {
		return [];
	}
}
var keyOf$1 = ({ image, point }) => JSON.stringify([image, point]);
var marksByHand = remember(({ edits, done }) => {
	const held = new Map();
	for (const step of edits.slice(0, done)) {
		if (!isMeasureStep(step)) continue;
		for (const mark of step.marks) {
			held.delete(keyOf$1(mark));
			if (step.kind === "measure") held.set(keyOf$1(mark), mark);
		}
	}
	return [...held.values()];
});
var allMarks = remember((file, history, images) => {
	const all = [...marksOfFile(file, images), ...marksByHand(history)];
	return [...new Map(all.map((mark) => [keyOf$1(mark), mark])).values()];
});
var collected = remember((control, file, history, files, isPlaced) => {
	const byHand = marksByHand(history);
	const needed = isPlaced ? LEAST_PLACED : LEAST_POINTS;
	if (control === null) return {
		twice: 0,
		needed,
		run: null,
		asGiven: true
	};
	if (file !== null && byHand.length === 0) return {
		twice: 0,
		needed,
		run: {
			points: control.text,
			marks: file.text
		},
		asGiven: true
	};
	const points = pointsOfFile(control);
	const [names, images] = [new Set(points.map(({ name }) => name)), new Set(files.map(({ name }) => name))];
	const ofHand = new Set(byHand);
	const marks = allMarks(file, history, files).filter((mark) => !ofHand.has(mark) || names.has(mark.point) && images.has(mark.image));
	const seen = new Map();
	for (const { point, image } of marks) if (images.has(image)) seen.set(point, (seen.get(point) ?? 0) + 1);
	const counts = ({ role }) => role === "control" || isPlaced && role === "check";
	const twice = points.filter((point) => counts(point) && (seen.get(point.name) ?? 0) >= LEAST_IMAGES$1).length;
	return {
		twice,
		needed,
		run: twice < needed ? null : {
			points: control.text,
			marks: image_measurement_table(marks)
		},
		asGiven: false
	};
});
function isPlaced({ shown, placing }) {
	if (placing.purpose === "block" || shown !== null && shown.ground !== null) return true;
	return shown !== null && shown.found.origin !== null && shown.found.crs !== null && shown.found.geoidM !== null;
}
function collectedOf(state) {
	const { files, options, marks } = state;
	return collected(options.control, options.marks, marks, files, isPlaced(state));
}
function waitsForMarks(state) {
	return state.options.control !== null && collectedOf(state).run === null;
}
function givenToRun(state) {
	const { control, marks } = state.options;
	const { run, asGiven } = collectedOf(state);
	if (control === null || asGiven && run !== null) return {
		control,
		marks
	};
	return run === null ? {
		control: null,
		marks: null
	} : {
		control,
		marks: {
			name: marks?.name ?? "",
			text: run.marks
		}
	};
}
var placesOfGiven = remember((name, view, file, history) => {
	const index = new Map(view.images.map((image, i) => [image.name, i]));
	return new Map(allMarks(file, history, view.images).flatMap(({ point, image, x_px, y_px }) => {
		const at = index.get(image);
		return point === name && at !== void 0 ? [[at, [x_px, y_px]]] : [];
	}));
});
function besideEdits(marks, place) {
	const places = marks.edits.map(({ after }, at) => place(after, at));
	if (marks.edits.every(({ after }, at) => after === places[at])) return marks;
	return {
		...marks,
		edits: marks.edits.map((step, at) => ({
			...step,
			after: places[at] ?? step.after
		}))
	};
}
function withMeasurements(steps, other) {
	return steps.map((step) => isMeasureStep(step) ? {
		...step,
		marks: other(step.marks)
	} : step);
}
// www/block/state/selection.ts
var NOTHING_SELECTED = {
	chosen: null,
	pointed: null,
	filters: {}
};
function reduceSelection(selection, action) {
	switch (action.type) {
		case "choose": return isSame(selection.chosen, action.choice) ? selection : {
			...selection,
			chosen: action.choice
		};
		case "point": return isSame(selection.pointed, action.choice) ? selection : {
			...selection,
			pointed: action.choice
		};
		case "filter": return {
			...selection,
			filters: {
				...selection.filters,
				[action.subject]: action.filter
			}
		};
	}
}
function choiceOfPoints(points) {
	const given = Uint32Array.from(points);
	const sorted = given.every((point, i) => i === 0 || point > (given[i - 1] ?? 0)) ? given : Uint32Array.from(new Set(given)).sort();
	const [first] = sorted;
	if (first === void 0) return null;
	return sorted.length === 1 ? {
		kind: "point",
		point: first
	} : {
		kind: "points",
		points: sorted
	};
}
function withMore(chosen, points) {
	const before = new Set(pointsOf(chosen));
	const [only] = points;
	if (points.length === 1 && only !== void 0 && before.has(only)) before.delete(only);
	else for (const point of points) before.add(point);
	return choiceOfPoints(before);
}
function choiceOfImages(images) {
	const sorted = [...new Set(images)].sort((a, b) => a - b);
	const [first] = sorted;
	if (first === void 0) return null;
	return sorted.length === 1 ? {
		kind: "image",
		image: first
	} : {
		kind: "images",
		images: sorted
	};
}
function withMoreImages(chosen, images) {
	const before = new Set(chosen?.kind === "image" || chosen?.kind === "images" ? imagesOf(chosen) : []);
	const [only] = images;
	if (only === void 0) return chosen;
	if (images.length === 1 && before.has(only)) before.delete(only);
	else for (const image of images) before.add(image);
	return choiceOfImages(before);
}
function choiceOfPairs(pairs) {
	const sorted = [...new Map([...pairs].map(([a, b]) => [keyOfPair([a, b]), a < b ? [a, b] : [b, a]])).values()].sort(([a, b], [c, d]) => a - c || b - d);
	const [first] = sorted;
	if (first === void 0) return null;
	return sorted.length === 1 ? {
		kind: "pair",
		images: [...first]
	} : {
		kind: "pairs",
		pairs: sorted
	};
}
function withMorePairs(chosen, pairs) {
	const before = new Map(pairsOf(chosen).map((pair) => [keyOfPair(pair), pair]));
	const [only] = pairs;
	if (only === void 0) return chosen;
	if (pairs.length === 1 && before.has(keyOfPair(only))) before.delete(keyOfPair(only));
	else for (const pair of pairs) before.set(keyOfPair(pair), pair);
	return choiceOfPairs(before.values());
}
function keyOfPair([a, b]) {
	return a < b ? `${String(a)},${String(b)}` : `${String(b)},${String(a)}`;
}
function pairsOf(choice) {
	if (choice?.kind === "pairs") return choice.pairs;
	return choice?.kind === "pair" ? [choice.images] : [];
}
function imagesOf(choice) {
	switch (choice?.kind) {
		case "image":
		case "observation": return [choice.image];
		case "images":
		case "pair": return choice.images;
		case "pairs": return [...new Set(choice.pairs.flat())].sort((a, b) => a - b);
		default: return [];
	}
}
var NO_POINTS = new Uint32Array();
function pointsOf(choice) {
	switch (choice?.kind) {
		case "point":
		case "observation": return Uint32Array.of(choice.point);
		case "observations": return choice.points.filter((point, i) => point !== choice.points[i - 1]);
		case "points": return choice.points;
		default: return NO_POINTS;
	}
}
function isSame(a, b) {
	if (a === b) return true;
	if (a === null || b === null || a.kind !== b.kind) return false;
	if (a.kind === "given" && b.kind === "given") return a.name === b.name;
	if (a.kind === "observations" && b.kind === "observations") return isSameList$1(a.points, b.points) && isSameList$1(a.images, b.images);
	if (a.kind === "pairs") return pairsOf(a).map(keyOfPair).join(" ") === pairsOf(b).map(keyOfPair).join(" ");
	const [images, others] = [imagesOf(a), imagesOf(b)];
	const [points, others_] = [pointsOf(a), pointsOf(b)];
	return images.length === others.length && images.every((image) => others.includes(image)) && isSameList$1(points, others_);
}
var isSameList$1 = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);
function inOtherView(selection, before, after) {
	const { chosen, filters } = selection;
	return {
		chosen: before === null ? null : moved(chosen, before, after),
		pointed: null,
		filters
	};
}
function moved(choice, before, after) {
	if (choice?.kind === "given") return choice;
	if (choice?.kind !== "image" && choice?.kind !== "images" && choice?.kind !== "pair" && choice?.kind !== "pairs") return null;
	const place = (image) => after.images.findIndex(({ name }) => name === before.images[image]?.name);
	if (choice.kind === "images") return choiceOfImages(choice.images.map(place).filter((image) => image >= 0));
	if (choice.kind === "image") return place(choice.image) < 0 ? null : {
		kind: "image",
		image: place(choice.image)
	};
	const kept = pairsOf(choice).map(([a, b]) => [place(a), place(b)]).filter((pair) => !pair.includes(-1));
	return choice.kind === "pair" && kept[0] !== void 0 ? {
		kind: "pair",
		images: [...kept[0]]
	} : choiceOfPairs(kept);
}
// www/block/state/state.ts
var BLOCK_INITIAL = {
	catalogue: null,
	files: [],
	removed: [],
	skipped: [],
	truth: null,
	options: {
		settings: null,
		gps: "use",
		cameras: null,
		control: null,
		marks: null,
		positions: null,
		masks: [],
		geoid: null
	},
	refused: null,
	flight: null,
	running: { kind: "no" },
	shown: null,
	selection: NOTHING_SELECTED,
	marks: NO_HISTORY,
	panes: NO_PANES,
	placing: NO_PLACING,
	...UNEDITED,
	onStage: "map",
	opened: null,
	notice: null
};
function wantedKey(state) {
	return JSON.stringify([state.files.map(({ id }) => id), toRun(state)]);
}
function toRun(state) {
	const { geoid, positions } = state.options;
	return {
		...state.options,
		...givenToRun(state),
		geoid: geoid ?? void 0,
		positions: positions ?? void 0
	};
}
function openedKey(state) {
	return JSON.stringify(toRun(state));
}
function isOutdated(state) {
	const { shown, files } = state;
	if (shown === null) return false;
	if (shown.files.length > 0) return shown.key !== wantedKey(state);
	return shown.key !== "" && files.length >= 2 && shown.key !== openedKey(state);
}
function withoutRunUnderWay(running) {
	return running.kind === "yes" ? running : { kind: "no" };
}
function isBusy({ running, notice, placing }) {
	return running.kind === "yes" || notice?.kind === "busy" || placing.running !== null;
}
function imagesOfBlock({ shown, files }) {
	if (shown === null) return [];
	const byName = new Map([...files, ...shown.files].map((file) => [file.name, file]));
	return shown.view.images.flatMap(({ name }) => byName.get(name) ?? []);
}
// www/block/state/purpose.ts
function orientedBlock({ shown }) {
	return shown === null || shown.view.partial || shown.view.oriented === 0 ? null : shown;
}
function cameOnGround({ view, ground }) {
	return ground === null && view.orthophoto?.kind === "linked";
}
function isHeldByHand({ shown }) {
	return shown?.view.orthophoto?.kind === "by_hand";
}
function purposeOf({ placing, shown, files }) {
	const { orthophoto, purpose, placed, heights } = placing;
	if (orthophoto === null) return null;
	if (isLookedAtAlone(orthophoto)) return "map";
	if (purpose !== null) return purpose;
	if (orthophoto.ofBlock !== null || placed.size > 0) return "images";
	const block = orientedBlock({ shown });
	if (block !== null) return cameOnGround(block) ? "map" : null;
	return !(shown !== null && !shown.view.partial) && heights.kind === "model" && files.length >= 2 ? "block" : "images";
}
function asksPurpose(state) {
	return state.placing.orthophoto !== null && purposeOf(state) === null;
}
function groundKey({ placing }) {
	return placingKey({
		placing,
		options: { cameras: null }
	});
}
function isOffGround(state) {
	const block = orientedBlock(state);
	return block !== null && purposeOf(state) === "block" && block.ground?.key !== groundKey(state);
}
function lacksPlaceAlone(state) {
	return isOffGround(state) && !isOutdated(state) && state.shown !== null && !cameOnGround(state.shown);
}
function liesElsewhere(state) {
	return isOffGround(state) && !isHeldByHand(state);
}
function isStale(state) {
	return isOutdated(state) || liesElsewhere(state);
}
// www/block/state/links.ts
var USES$1 = [
	"used",
	"check",
	"rejected"
];
function inRows({ placement, size: _, ...image }) {
	return {
		...image,
		placement: placement === null ? null : {
			...placement,
			links: Array.from({ length: placement.links.count }, (_, i) => linkOf(placement.links, i))
		}
	};
}
function linkOf({ at, places, residuals, sigmas, uses, byHand }, link) {
	const pair = (of) => [of[2 * link] ?? NaN, of[2 * link + 1] ?? NaN];
	return {
		at: pair(at),
		place: [
			places[3 * link] ?? NaN,
			places[3 * link + 1] ?? NaN,
			places[3 * link + 2] ?? NaN
		],
		residual_px: Number.isNaN(residuals[2 * link]) ? null : pair(residuals),
		sigma_px: sigmaOf(sigmas?.[link]),
		role: USES$1[uses[link] ?? 0] ?? "used",
		by_hand: byHand[link] === 1
	};
}
function usedSo({ uses }, use) {
	const code = USES$1.indexOf(use);
	return uses.reduce((sum, own) => sum + (own === code ? 1 : 0), 0);
}
var sigmaOf = (sigma) => sigma === void 0 || Number.isNaN(sigma) ? null : sigma;
// www/block/state/steps.ts
function givenLinks(found, steps) {
	const links = found?.placement?.links ?? null;
	const given = Array.from({ length: links?.count ?? 0 }, (_, i) => {
		const { at, place, role } = linkOf(links, i);
		return {
			at,
			place: [place[0], place[1]],
			use: role === "check" ? "check" : "used",
			by_hand: false
		};
	});
	for (const step of steps) if (step.kind === "add") given.push({
		at: step.at,
		place: step.place,
		use: "used",
		by_hand: true
	});
	else {
		const link = given[step.link];
		const isCheck = links !== null && step.link < links.count && linkOf(links, step.link).role === "check";
		if (link !== void 0) link.use = step.kind === "reject" ? "rejected" : isCheck ? "check" : "used";
	}
	return given;
}
function shownLinks({ result, steps, done }) {
	return result?.placement?.links ?? addedLinks(steps, done);
}
var addedLinks = remember((steps, done) => {
	const added = steps.slice(0, done).filter((step) => step.kind === "add");
	if (added.length === 0) return null;
	return {
		count: added.length,
		at: Float64Array.from(added.flatMap(({ at }) => at)),
		places: Float64Array.from(added.flatMap(({ place: [x, y] }) => [
			x,
			y,
			NaN
		])),
		residuals: new Float64Array(2 * added.length).fill(NaN),
		sigmas: new Float64Array(added.length).fill(NaN),
		uses: new Uint8Array(added.length),
		byHand: new Uint8Array(added.length).fill(1)
	};
});
function useWord({ steps, done }, link, use, byHand = false) {
	const isByUser = steps.slice(0, done).findLast((step) => step.kind !== "add" && step.link === link)?.kind === "reject";
	if (byHand) return say("link-measured-by-hand", { use: use !== "rejected" ? use : isByUser ? "by_hand" : "gross_error" });
	if (use !== "rejected") return say("link-use", { use });
	return isByUser ? say("rejected-by-hand-2") : say("rejected-as-a-gross-error");
}
function stepName(step) {
	return step.kind === "add" ? say("add-a-link") : say("link-2", {
		kind: step.kind,
		link: step.link + 1
	});
}
// www/block/state/ground.ts
function systemOf(view, ground) {
	if (view.layout.kind === "recorded" || ground?.origin != null) return "geographic";
	return view.surveyed.some(({ role }) => role === "control") ? "surveyed" : "own";
}
var medianGsd = remember((view, ground) => {
	if (ground === null || systemOf(view, ground) === "own") return null;
	return numberOf(median([...ground.gsd].filter(Number.isFinite)));
});
function gsdOf(view, ground, image) {
	return ground === null || systemOf(view, ground) === "own" ? null : numberOf(ground.gsd[image] ?? NaN);
}
var medianErrors = remember(({ points: { errors, taking } }) => {
	const of = (error) => median(Array.from({ length: taking }, (_, point) => error(3 * point)).filter(Number.isFinite));
	return [of((at) => Math.hypot(errors[at] ?? NaN, errors[at + 1] ?? NaN)), of((at) => errors[at + 2] ?? NaN)];
});
function median(values) {
	const sorted = Float64Array.from(values).sort();
	return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}
function numberOf(value) {
	return Number.isFinite(value) ? value : null;
}
// www/block/state/scale.ts
function unitOf({ origin, surveyed }) {
	return origin !== null || surveyed.some(({ role }) => role === "control") ? "m" : "";
}
function inUnitOf(view, coordinates) {
	return withUnit(coordinates, unitOf(view));
}
// www/block/state/result-system.ts
var APART_M$1 = 500;
var FOOT_M$2 = .3048;
var MOST_SCALE$1 = .02;
var DIGITS_OF_DEGREES$1 = 5;
var resultSystem = remember((view) => chosenSystem(view) ?? ownSystem(view));
function ownSystem(view) {
	const unit = unitOf(view);
	return {
		name: "",
		code: "",
		unit: [unit, unit],
		more: 0,
		coordinates: (positions) => positions,
		toBlock: null
	};
}
function countedFrom({ geoidM, geoid = null }) {
	return geoid === null ? { geoid_m: geoidM } : { geoid };
}
function inSystem$1(view, crs, positions) {
	const { origin } = view;
	const all = new Float64Array(positions.length + 3);
	if (origin !== null) all.set([
		origin.longitude_deg,
		origin.latitude_deg,
		origin.height_m
	]);
	all.set(positions, 3);
	return system_coordinates(crs, geographic_positions(all), countedFrom(view));
}
function chosenSystem(view) {
	const { crs, system = null, origin, points } = view;
	if (system === null || crs === null || origin === null) return null;
	const coordinates = (positions) => inSystem$1(view, crs, positions);
	const ground = median(points.positions.filter((value, i) => i % 3 === 2 && !Number.isNaN(value)));
	const z = Number.isNaN(ground) ? 0 : ground;
	try {
		const [x = NaN, y = NaN, up = NaN, ...others] = coordinates(Float64Array.of(0, 0, z, APART_M$1, 0, z, 0, APART_M$1, z, 0, 0, z + APART_M$1));
		const [xe = NaN, ye = NaN, , xn = NaN, yn = NaN, , , , over = NaN] = others;
		const [a, b, c, d] = [
			(xe - x) / APART_M$1,
			(ye - y) / APART_M$1,
			(xn - x) / APART_M$1,
			(yn - y) / APART_M$1
		];
		const determinant = a * d - b * c;
		if (!(Math.abs(determinant) > 0)) return null;
		const across = unitOfLength(Math.sqrt(Math.abs(determinant)));
		const turned = {
			a: d / determinant,
			b: -b / determinant,
			c: -c / determinant,
			d: a / determinant,
			e: 0,
			f: 0
		};
		const [e, f] = mapped(turned, x, y);
		return {
			name: system,
			code: /^epsg:\d+$/iu.test(crs) ? crs.toUpperCase() : system,
			unit: [across, unitOfLength((over - up) / APART_M$1)],
			more: across === "°" ? DIGITS_OF_DEGREES$1 : 0,
			coordinates,
			toBlock: {
				...turned,
				e: -e,
				f: -f
			}
		};
	} catch {
		return null;
	}
}
function unitOfLength(perM) {
	const is = (wanted) => Math.abs(perM / wanted - 1) < MOST_SCALE$1;
	if (is(1)) return "m";
	return is(1 / FOOT_M$2) ? "ft" : perM < .001 ? "°" : "";
}
function headOf({ code }, axis) {
	return code === "" ? axis : say("in-system", {
		axis,
		code
	});
}
function unitOn({ unit }, axis) {
	return unit[axis < 2 ? 0 : 1];
}
var converted = new WeakMap();
function pointCoordinates(view) {
	const { positions } = view.points;
	const coordinates = converted.get(positions) ?? resultSystem(view).coordinates(positions);
	converted.set(positions, coordinates);
	return coordinates;
}
var imageCoordinates = remember((view) => {
	const positions = Float64Array.from(view.images.flatMap(({ position }) => position ?? [
		NaN,
		NaN,
		NaN
	]));
	return resultSystem(view).coordinates(positions);
});
var surveyedCoordinates = remember((view) => resultSystem(view).coordinates(Float64Array.from(view.surveyed.flatMap(({ position }) => [...position]))));
function coordinatesText(view, position, digits) {
	const system = resultSystem(view);
	const at = system.name === "" ? position : system.coordinates(Float64Array.from(position));
	const { unit, more } = system;
	const [x, y, z] = [
		at[0] ?? NaN,
		at[1] ?? NaN,
		at[2] ?? NaN
	];
	const plan = `${fixed(x, digits + more)} ${fixed(y, digits + more)}`;
	if (unit[0] === unit[1]) return withUnit(`X Y Z ${plan} ${fixed(z, digits)}`, unit[0]);
	return `${withUnit(`X Y ${plan}`, unit[0])} ${withUnit(`Z ${fixed(z, digits)}`, unit[1])}`;
}
// www/block/engine/frames.ts
async function makeFrames(worker, scans, given, tell) {
	const made = [];
	const at = (name) => tell(made.length, scans.length, say("resampling-scan", { name }));
	at(scans[0]?.file.name ?? "");
	const plan = await worker.call("filmPlan", {
		films: scans.map(({ film }) => film),
		given
	});
	for (const { file, film, mask } of scans) {
		at(file.name);
		made.push({
			...await worker.call("filmFrame", {
				file: file.file,
				film,
				plan,
				image: file.name,
				mask
			}),
			of: file.id
		});
	}
	return made;
}
// www/block/engine/recorded.ts
var RecordedPositions = class {
	reader;
	known = new Map();
	constructor(reader) {
		this.reader = reader;
	}
	async of(files, areWanted) {
		const given = new Set(files.map(({ id }) => id));
		for (const id of [...this.known.keys()]) if (!given.has(id)) this.known.delete(id);
		const positions = [];
		for (const { id, file } of files) {
			const asked = this.known.get(id) ?? this.reader.call("imagePosition", { file }).catch(() => null);
			this.known.set(id, asked);
			const position = await asked;
			if (!areWanted()) return null;
			if (position !== null) positions.push(position);
		}
		this.reader.cancel();
		return positions;
	}
};
// www/block/engine/placing.ts
var MOST_SHARED = 4e7;
var PlacingEngine = class {
	store;
	shower = new WorkerClient("orthophoto");
	placers = [1, 2].map((number) => new WorkerClient(`placing ${String(number)}`));
	maker = new WorkerClient("mosaic");
	recorded = new RecordedPositions(new WorkerClient("positions"));
	stopped = false;
	waits = 0;
	constructor(store) {
		this.store = store;
	}
	async open(raster, ofBlock = null) {
		return {
			raster,
			info: await this.asked(groundOf$1(raster, NO_PLACING.heights)),
			ofBlock
		};
	}
	async setHeights(heights) {
		const { orthophoto } = this.store.state.placing;
		if (orthophoto === null) return;
		const info = await this.asked(groundOf$1(orthophoto.raster, heights));
		this.store.dispatch({
			type: "heights",
			heights,
			info
		});
	}
	asked(ground) {
		return this.waited(() => this.shower.call("orthoInfo", ground));
	}
	async waited(ask) {
		this.waits += 1;
		try {
			return await ask();
		} catch (error) {
			throw named$1(error);
		} finally {
			this.waits -= 1;
		}
	}
	tile(level, column, row) {
		const { ground } = this;
		if (ground === null) return Promise.reject(new Error("no orthophoto is given"));
		return this.shower.call("orthoTile", {
			ground,
			level,
			column,
			row
		});
	}
	async lookElsewhere() {
		const { files, placing } = this.store.state;
		const { orthophoto, options } = placing;
		const { ground } = this;
		const given = givenPositions(this.store.state);
		let doubt = null;
		if (orthophoto?.ofBlock === null && orthophoto.info.on_earth && ground !== null && options !== null) {
			const areWanted = () => {
				const now = this.store.state;
				return now.files === files && now.placing.orthophoto?.raster === orthophoto.raster && now.placing.options === options && givenPositions(now) === given;
			};
			const recorded = await this.recorded.of(files.filter(({ name }) => !given.has(name)), areWanted);
			if (recorded === null) return;
			const positions = [...[...given.values()].map(({ position }) => position), ...recorded];
			if (positions.length > 0) doubt = await this.shower.call("orthoElsewhere", {
				ground,
				options,
				positions
			}).catch(() => null);
			if (!areWanted()) return;
		}
		this.store.dispatch({
			type: "elsewhere",
			text: doubt === null ? "" : sentence(message("remark", doubt))
		});
	}
	async place(files = unplacedFiles(this.store.state)) {
		const { state } = this.store;
		const { placing, options } = state;
		const { ground } = this;
		if (ground === null || placing.options === null || placing.orthophoto === null || placing.running !== null || files.length === 0) return 0;
		const { width, height, in_parts: isInParts } = placing.orthophoto.info;
		const isLight = isInParts || width * height <= MOST_SHARED;
		const key = placingKey(state);
		const workers = this.placers.slice(0, isLight && (navigator.hardwareConcurrency || 1) > 2 ? 2 : 1);
		const waiting = [...files];
		const { options: given, film } = placing;
		const cameras = options.cameras?.text ?? null;
		const positions = givenPositions(state);
		let done = 0;
		this.stopped = false;
		const tell = (text) => this.store.dispatch({
			type: "placing",
			running: {
				done,
				total: files.length,
				text
			}
		});
		tell(say("looking-for-points-of-the"));
		const work = async (worker) => {
			await worker.call("orthoSearch", {
				ground,
				options: given
			});
			for (let file = waiting.shift(); file !== void 0; file = waiting.shift()) {
				tell(say("placing", { name: file.name }));
				const { id, name } = file;
				const [found, problem] = await this.tried(worker, {
					ground,
					options: given,
					name,
					file: file.file,
					cameras,
					film: filmOf(film, name),
					position: positions.get(name) ?? null
				});
				done += 1;
				const former = this.store.state.placing.placed.get(id);
				const steps = (former?.steps.slice(0, former.done) ?? []).filter(({ kind }) => kind === "add");
				const result = steps.length === 0 ? found : await this.adjust(file, found, steps).catch(() => found);
				this.store.dispatch({
					type: "placed",
					image: file,
					placed: {
						key: placingKeyOf(key, {
							film,
							positions
						}, name),
						result,
						problem,
						found,
						steps,
						done: steps.length
					}
				});
				tell(waiting[0] === void 0 ? say("placing-2") : say("placing", { name: waiting[0].name }));
			}
		};
		try {
			await Promise.all(workers.slice(0, files.length).map(work));
			return done;
		} catch (error) {
			this.release();
			if (this.stopped || error instanceof Cancelled) return null;
			throw named$1(error);
		} finally {
			if (!isLight) this.release();
			this.store.dispatch({
				type: "placing",
				running: null
			});
		}
	}
	async tried(worker, input) {
		try {
			return [await worker.call("orthoPlace", input), ""];
		} catch (error) {
			if (error instanceof Cancelled) throw error;
			return [null, breakdownOf(error) ?? messageOf(error)];
		}
	}
	cancel() {
		this.stopped = true;
		for (const worker of [...this.placers, this.maker]) worker.cancel();
		if (this.waits > 0) this.shower.cancel();
	}
	async adjust(file, found, steps) {
		const { placing, options } = this.store.state;
		const { ground } = this;
		const { options: settings } = placing;
		if (found === null || ground === null || settings === null || steps.length === 0) return found;
		const links = givenLinks(found, steps);
		if (found.placement === null && links.filter(({ use }) => use === "used").length < 4) return found;
		const start = found.placement === null ? null : {
			...found.placement,
			links: []
		};
		const { name, file: bytes } = file;
		this.store.dispatch({
			type: "adjustsLinks",
			image: file.id
		});
		try {
			const cameras = options.cameras?.text ?? null;
			return await this.waited(() => this.shower.call("orthoAdjust", {
				ground,
				options: settings,
				name,
				file: bytes,
				cameras,
				film: filmOf(placing.film, name),
				position: givenPositions(this.store.state).get(name) ?? null,
				links,
				start,
				size: found.size
			}));
		} finally {
			this.store.dispatch({
				type: "adjustsLinks",
				image: null
			});
		}
	}
	async predict(placement, given) {
		const { ground } = this;
		return ground === null ? null : this.shower.call("orthoPredict", {
			ground,
			placement: {
				...placement,
				links: []
			},
			...given
		});
	}
	controlByHand(place, number, view) {
		const { ground } = this;
		const { options } = this.store.state.placing;
		if (ground === null || options === null) return Promise.reject(new Error("no orthophoto is given"));
		return this.waited(() => this.shower.call("orthoControl", {
			ground,
			options,
			place,
			number,
			crs: view.crs,
			heights: countedFrom(view)
		}));
	}
	async rectified(file) {
		const { ground } = this;
		const placement = this.store.state.placing.placed.get(file.id)?.result?.placement ?? null;
		if (ground === null || placement === null) throw new Error(say("is-not-placed", { name: file.name }));
		return await this.waited(() => this.shower.call("orthoRectified", {
			ground,
			file: file.file,
			placement: {
				...placement,
				links: []
			}
		}));
	}
	laid(file, placement, side) {
		const { ground } = this;
		if (ground === null) return Promise.reject(new Error("no orthophoto is given"));
		return this.shower.call("orthoLaid", {
			ground,
			file: file.file,
			placement: {
				...placement,
				links: []
			},
			side
		});
	}
	mosaic(project, files, how) {
		return this.made(async (tell) => {
			tell(0, files.length, say("laying-out-the-orthomosaic"));
			const byName = new Map(files.map(({ name, file }) => [name, file]));
			const { order, remark } = await this.maker.call("mosaicOpen", {
				project,
				heights: null,
				...how,
				names: [...byName.keys()]
			});
			for (const [done, { name, index }] of order.entries()) {
				const file = byName.get(name);
				if (file === void 0) continue;
				tell(done, order.length, say("orthomosaic", { name }));
				await this.maker.call("mosaicAdd", {
					index,
					file
				});
			}
			tell(order.length, order.length, say("writing-the-orthomosaic"));
			return {
				picture: await this.maker.call("mosaicFinish", null),
				remark
			};
		});
	}
	frames(scans, given) {
		return this.made((tell) => makeFrames(this.maker, scans, given, tell));
	}
	async made(make) {
		this.stopped = false;
		try {
			return await make((done, total, text) => this.store.dispatch({
				type: "placing",
				running: {
					done,
					total,
					text
				}
			}));
		} catch (error) {
			if (this.stopped || error instanceof Cancelled) return null;
			throw named$1(error);
		} finally {
			this.maker.cancel();
			this.store.dispatch({
				type: "placing",
				running: null
			});
		}
	}
	async scene(flight, gsd) {
		const { picture, heights } = await this.maker.call("sceneOrthophoto", {
			flight,
			gsd
		});
		this.maker.cancel();
		const type = "image/tiff";
		return {
			picture: new Blob([picture], { type }),
			heights: new Blob([heights], { type })
		};
	}
	release() {
		for (const worker of this.placers) worker.cancel();
	}
	get ground() {
		const { orthophoto, heights } = this.store.state.placing;
		return orthophoto === null ? null : groundOf$1(orthophoto.raster, heights);
	}
};
function groundOf$1(raster, heights) {
	const own = heights.kind === "level" ? heights.height : sourceOf$2(heights.model);
	const name = heights.kind === "level" ? `level ${String(heights.height)}` : `file ${String(heights.model.id)}`;
	return {
		picture: sourceOf$2(raster),
		heights: own,
		keys: {
			picture: String(raster.id),
			heights: name
		}
	};
}
function sourceOf$2({ file, world, projection, degrees = null }) {
	if (degrees !== null) return {
		file,
		sidecars: {
			world_file: degrees.world,
			projection: degrees.shownIn
		}
	};
	return {
		file,
		sidecars: {
			world_file: world?.text ?? null,
			projection: projection?.text ?? null
		}
	};
}
function named$1(error) {
	if (error instanceof Cancelled) return error;
	return new Error(breakdownOf(error) ?? messageOf(error));
}
// www/block/engine/block-placing.ts
var BlockPlacing = class {
	store;
	engine;
	placing;
	worker = new WorkerClient("georeferencing");
	stopped = false;
	constructor(store, engine, placing) {
		this.store = store;
		this.engine = engine;
		this.placing = placing;
	}
	async place() {
		const { shown, placing } = this.store.state;
		const { ground } = this.placing;
		if (shown === null || ground === null || placing.options === null) return false;
		const key = groundKey(this.store.state);
		this.stopped = false;
		this.tell(0, 1, say("looking-for-points-of-the"));
		try {
			this.placing.release();
			const before = shown.ground?.before ?? await this.engine.project();
			const { project, verdicts } = await this.linked({
				project: before,
				ground,
				options: placing.options
			});
			const read = await this.engine.read(project, this.store.state.truth);
			const awaited = awaitedOf(this.store.state);
			const [places, again] = [await read.places(), await read.placesAgain(awaited?.spots ?? null)];
			if (this.stopped || this.store.state.shown?.found !== shown.found) return false;
			read.hold();
			this.store.dispatch({
				type: "onGround",
				view: read.view,
				edits: read.steps.flat(),
				ground: {
					key,
					before,
					places,
					verdicts
				},
				again
			});
			return true;
		} catch (error) {
			if (this.stopped || error instanceof Cancelled) return false;
			throw named$1(error);
		} finally {
			this.worker.cancel();
			this.store.dispatch({
				type: "placing",
				running: null
			});
		}
	}
	async takeOff() {
		const { shown } = this.store.state;
		if (shown?.ground == null) return;
		const read = await this.engine.read(new Uint8Array(await shown.ground.before.arrayBuffer()), this.store.state.truth);
		if (this.store.state.shown?.found !== shown.found) return;
		read.hold();
		this.store.dispatch({
			type: "onGround",
			view: read.view,
			edits: read.steps.flat(),
			ground: null
		});
	}
	cancel() {
		this.stopped = true;
		this.worker.cancel();
	}
	async linked(input) {
		const names = await this.worker.call("linksOpen", input);
		const files = new Map(imagesOfBlock(this.store.state).map(({ name, file }) => [name, file]));
		const images = names.flatMap((name, index) => {
			const file = name === null ? void 0 : files.get(name);
			return name === null || file === void 0 ? [] : [{
				name,
				index,
				file
			}];
		});
		const verdicts = [];
		for (const [done, { name, index, file }] of images.entries()) {
			this.tell(done, images.length, say("placing-on-the-orthophoto", { name }));
			const verdict = await this.worker.call("linksPlace", {
				index,
				file
			});
			if (verdict !== null) verdicts.push({
				name,
				verdict
			});
		}
		this.tell(1, 1, say("adjusting-by-the-orthophoto"));
		return {
			project: await this.worker.call("linksFinish", null),
			verdicts
		};
	}
	tell(done, total, text) {
		this.store.dispatch({
			type: "placing",
			running: {
				done,
				total,
				text
			}
		});
	}
};
// www/block/state/calibrated.ts
var MOST_FOCAL_ERROR = .01;
function calibrationsOf({ verdict, cameras }, isSimulated, at) {
	if (isSimulated || verdict?.kind !== "oriented") return [];
	return cameras.flatMap(({ label, images, given, calibrated: camera, focalErrorPx }) => {
		if (!(cameras.filter((other) => other.label === label).length === 1) || given === null || camera === null || focalErrorPx === null || focalErrorPx > MOST_FOCAL_ERROR * camera.focal_px) return [];
		const { radial = [
			0,
			0,
			0
		], tangential = [0, 0] } = given;
		return [{
			label,
			recorded: {
				radial,
				tangential
			},
			camera,
			focalErrorPx,
			images,
			at
		}];
	});
}
// www/block/state/observations.ts
var IMAGES = 2 ** 20;
var keyOf = (point, image) => point * IMAGES + image;
var keysOf = ({ points, images }) => Float64Array.from(points, (point, i) => keyOf(point, images[i] ?? 0));
function observationsIn(choice) {
	if (choice?.kind === "observations") return choice;
	const one = choice?.kind === "observation" ? choice : null;
	return {
		points: Uint32Array.from(one === null ? [] : [one.point]),
		images: Uint32Array.from(one === null ? [] : [one.image])
	};
}
function choiceOfKeys(keys) {
	const sorted = Float64Array.from(new Set(keys)).sort();
	const points = Uint32Array.from(sorted, (key) => Math.floor(key / IMAGES));
	const images = Uint32Array.from(sorted, (key) => key % IMAGES);
	const [point, image] = [points[0], images[0]];
	if (point === void 0 || image === void 0) return null;
	return sorted.length === 1 ? {
		kind: "observation",
		point,
		image
	} : {
		kind: "observations",
		points,
		images
	};
}
var choiceOfObservations = (of) => choiceOfKeys(keysOf(of));
function withMoreObservations(chosen, more) {
	const keys = new Set(keysOf(observationsIn(chosen)));
	const added = keysOf(more);
	const [only] = added;
	if (added.length === 1 && only !== void 0 && keys.has(only)) keys.delete(only);
	else for (const key of added) keys.add(key);
	return choiceOfKeys(keys);
}
function observationsKept(of, keeps) {
	const at = Uint32Array.from(of.points.keys()).filter(keeps);
	return {
		points: Uint32Array.from(at, (i) => of.points[i] ?? 0),
		images: Uint32Array.from(at, (i) => of.images[i] ?? 0)
	};
}
function among(of) {
	const keys = new Set(keysOf(of));
	return (point, image) => keys.has(keyOf(point, image));
}
// www/block/state/edits.ts
function keyOfPoint(point) {
	const [[kind, number] = []] = Object.entries(point);
	return `${kind ?? ""} ${String(number)}`;
}
var SOURCES = [
	"tie_point",
	"ground_control",
	"manual"
];
function codeOfSource(source) {
	const kind = SOURCES.findIndex((name) => name in source);
	const [number = 0] = Object.values(source);
	return SOURCES.length * number + kind;
}
function sourceOf$1({ points }, point) {
	const code = points.sources[point];
	const kind = code === void 0 ? void 0 : SOURCES[code % SOURCES.length];
	if (code === void 0 || kind === void 0) return null;
	return { [kind]: Math.floor(code / SOURCES.length) };
}
var places$3 = remember((sources) => new Map([...sources].map((code, point) => [code, point])));
function indexOfSource({ points }, source) {
	return places$3(points.sources).get(codeOfSource(source)) ?? -1;
}
function choiceAfterEdit(choice, before, after) {
	if (choice === null || choice.kind === "given") return choice;
	if (choice.kind === "image" || choice.kind === "images" || choice.kind === "pair" || choice.kind === "pairs") return choice;
	if (choice.kind === "observations") return choiceOfObservations(observationsAfter(choice, before, after));
	const moved = [...pointsOf(choice)].flatMap((point) => {
		const source = sourceOf$1(before, point);
		const index = source === null ? -1 : indexOfSource(after, source);
		return index < 0 ? [] : [index];
	});
	const [first] = moved;
	if (first === void 0) return null;
	if (choice.kind === "observation") return {
		...choice,
		point: first
	};
	return moved.length === 1 ? {
		kind: "point",
		point: first
	} : {
		kind: "points",
		points: Uint32Array.from(moved).sort()
	};
}
function observationsAfter({ points, images }, before, after) {
	const places = Array.from(points, (point) => {
		const source = sourceOf$1(before, point);
		return source === null ? -1 : indexOfSource(after, source);
	});
	const stays = (_, i) => (places[i] ?? -1) >= 0;
	return {
		points: Uint32Array.from(places.filter(stays)),
		images: images.filter(stays)
	};
}
function choiceOfSamePoints(choice, before, after) {
	const points = pointsOf(choice);
	const nameOf = ({ surveyed }, number) => surveyed.find(({ control }) => control === number)?.name;
	const isSame = (point) => {
		const source = sourceOf$1(before, point);
		return source !== null && (!("ground_control" in source) || nameOf(before, source.ground_control) === nameOf(after, source.ground_control));
	};
	return points.length > 0 && points.every(isSame) ? choiceAfterEdit(choice, before, after) : null;
}
var keyOfObservation = ({ point, image }) => `${keyOfPoint(point)} ${String(image)}`;
var standingOf = remember((edits) => {
	const observations = new Map();
	const points = new Map();
	const images = new Set();
	const pairs = new Map();
	const unused = new Set();
	const measured = new Map();
	const measure = (image, point) => {
		measured.set(image, (measured.get(image) ?? new Set()).add(codeOfSource(point)));
		observations.delete(keyOfObservation({
			point,
			image
		}));
	};
	let added = 0;
	for (const edit of edits) switch (edit.kind) {
		case "reject_observations":
			for (const one of edit.observations) observations.set(keyOfObservation(one), one);
			break;
		case "restore_observations":
			for (const one of edit.observations) observations.delete(keyOfObservation(one));
			break;
		case "reject_points":
			for (const point of edit.points) points.set(keyOfPoint(point), point);
			break;
		case "restore_points":
			for (const point of edit.points) {
				points.delete(keyOfPoint(point));
				if ("ground_control" in point) unused.delete(point.ground_control);
			}
			break;
		case "reject_images":
			for (const image of edit.images) images.add(image);
			break;
		case "restore_images":
			for (const image of edit.images) images.delete(image);
			break;
		case "reject_pairs":
			for (const pair of edit.pairs) pairs.set(keyOfPair(pair), pair);
			break;
		case "restore_pairs":
			for (const pair of edit.pairs) pairs.delete(keyOfPair(pair));
			break;
		case "measure":
			measure(edit.image, edit.point);
			break;
		case "add_point":
			for (const { image } of edit.observations) measure(image, { manual: added });
			added += 1;
			break;
		case "add_control": break;
		case "set_use": if (edit.use == null) unused.add(edit.point);
		else unused.delete(edit.point);
	}
	return {
		observations,
		points,
		images,
		pairs,
		unused,
		measured
	};
});
var connectedPairs$1 = remember(({ connections }) => new Set(connections.filter(({ outcome }) => outcome.kind === "connected").map(({ images }) => keyOfPair(images))));
function editOfChoice(kind, choice, view, standing, whole = false) {
	const rejects = kind === "reject";
	switch (choice?.kind) {
		case "image":
		case "images": {
			const images = imagesOf(choice).filter((image) => standing.images.has(image) !== rejects);
			return images.length === 0 ? null : {
				kind: `${kind}_images`,
				images
			};
		}
		case "pair":
		case "pairs": {
			const isInBlock = (image) => view.images[image]?.oriented !== false || standing.images.has(image);
			const pairs = pairsOf(choice).filter((pair) => connectedPairs$1(view).has(keyOfPair(pair)) && pair.every(isInBlock)).filter((pair) => standing.pairs.has(keyOfPair(pair)) !== rejects).map(([a, b]) => [a, b]);
			return pairs.length === 0 ? null : {
				kind: `${kind}_pairs`,
				pairs
			};
		}
		case "observation": {
			const point = sourceOf$1(view, choice.point);
			if (point === null) return null;
			if (whole || isOut(point, standing)) return editOfPoints(kind, [point], standing);
			const one = {
				point,
				image: choice.image
			};
			return standing.observations.has(keyOfObservation(one)) === rejects ? null : {
				kind: `${kind}_observations`,
				observations: [one]
			};
		}
		case "observations": return editOfObservations(kind, choice, view, standing);
		case "point":
		case "points": return editOfPoints(kind, [...pointsOf(choice)].flatMap((point) => sourceOf$1(view, point) ?? []), standing);
		default: return null;
	}
}
function editOfObservations(kind, { points, images }, view, standing) {
	const observations = [...points].flatMap((number, i) => {
		const point = sourceOf$1(view, number);
		const one = point === null ? null : {
			point,
			image: images[i] ?? 0
		};
		return one === null || isOut(one.point, standing) || standing.observations.has(keyOfObservation(one)) === (kind === "reject") ? [] : [one];
	});
	return observations.length === 0 ? null : {
		kind: `${kind}_observations`,
		observations
	};
}
function isOut(point, { points, unused }) {
	return points.has(keyOfPoint(point)) || "ground_control" in point && unused.has(point.ground_control);
}
function editOfPoints(kind, all, standing) {
	const points = all.filter((point) => isOut(point, standing) !== (kind === "reject"));
	if (points.length > 0) return {
		kind: `${kind}_points`,
		points
	};
	if (kind === "reject") return null;
	const keys = new Set(all.map(keyOfPoint));
	const observations = [...standing.observations.values()].filter(({ point }) => keys.has(keyOfPoint(point)));
	return observations.length === 0 ? null : {
		kind: "restore_observations",
		observations
	};
}
// www/block/state/added.ts
var NONE = new Map();
var addedPoints = remember((edits, given) => {
	if (!edits.some(({ kind }) => kind === "add_control")) return NONE;
	const points = [];
	const find = (point) => "ground_control" in point ? points[point.ground_control - given] : void 0;
	for (const edit of edits) if (edit.kind === "add_control") points.push({
		edit,
		control: given + points.length,
		places: new Map()
	});
	else if (edit.kind === "measure") find(edit.point)?.places.set(edit.image, [edit.x_px, edit.y_px]);
	const { observations, images } = standingOf(edits);
	for (const { point, image } of observations.values()) find(point)?.places.delete(image);
	for (const image of images) for (const { places } of points) places.delete(image);
	return new Map(points.map((point) => [point.edit.name, point]));
});
var BY_HAND$2 = /^orthophoto_hand_(\d+)$/u;
var isPlaceByHand = (name) => BY_HAND$2.test(name);
function nextPlace({ edits }) {
	const numbers = edits.flat().map((edit) => edit.kind === "add_control" ? Number(BY_HAND$2.exec(edit.name)?.[1] ?? 0) : 0);
	return 1 + Math.max(0, ...numbers);
}
// www/block/state/aside.ts
function placesSetAside({ edits: steps, done }, given) {
	const held = steps.slice(0, done);
	const stays = held.flat().filter((edit) => edit.kind === "add_control").map(({ name }) => !isPlaceByHand(name));
	const isPlace = (edit) => edit.kind === "add_control" ? isPlaceByHand(edit.name) : controlsOf(edit).some((one) => stays[one - given] === false);
	const order = [...stays.keys()].sort((a, b) => Number(stays[b]) - Number(stays[a]));
	const numberOf = (control) => {
		const at = order.indexOf(control - given);
		return at < 0 ? control : given + at;
	};
	const numbered = (step) => step.map((edit) => withControls(edit, numberOf));
	const kept = [];
	const aside = [];
	const left = [0];
	for (const step of held) {
		const isAside = !step.some(({ kind }) => kind === "add_point") && step.some(isPlace) ? () => true : isPlace;
		const [stay, go] = [step.filter((edit) => !isAside(edit)), step.filter((edit) => isAside(edit))];
		if (stay.length > 0) kept.push(stay);
		if (go.length > 0) aside.push(go);
		left.push(kept.length);
	}
	if (aside.length === 0) return {
		history: {
			edits: steps,
			done
		},
		left: [...steps.keys(), steps.length],
		aside: 0
	};
	const undone = steps.slice(done);
	return {
		history: {
			edits: [...[...kept, ...aside].map(numbered), ...undone],
			done: kept.length
		},
		left: [...left, ...undone.map((_, i) => kept.length + aside.length + i + 1)],
		aside: aside.length
	};
}
function controlsOf(edit) {
	const found = [];
	withControls(edit, (control) => {
		found.push(control);
		return control;
	});
	return found;
}
function withControls(edit, number) {
	const renumbered = (point) => "ground_control" in point ? {
		...point,
		ground_control: number(point.ground_control)
	} : point;
	switch (edit.kind) {
		case "measure": return {
			...edit,
			point: renumbered(edit.point)
		};
		case "reject_points":
		case "restore_points": return {
			...edit,
			points: edit.points.map(renumbered)
		};
		case "reject_observations":
		case "restore_observations": return {
			...edit,
			observations: edit.observations.map((one) => ({
				...one,
				point: renumbered(one.point)
			}))
		};
		case "set_use": return {
			...edit,
			point: number(edit.point)
		};
		default: return edit;
	}
}
// www/block/state/carrying.ts
var NO_PLACES_AGAIN = {
	held: 0,
	lost: 0,
	edits: 0
};
function carriedOver({ edits, done }, before, after, sameTiePoints = false, again = []) {
	const steps = edits.map((step) => [...step]);
	const carried = carried_steps({
		steps,
		done,
		before: numbered(before),
		after: numbered(after),
		same_tie_points: sameTiePoints,
		again: [...again]
	});
	return {
		history: {
			edits: carried.steps,
			done: carried.left[done] ?? carried.steps.length
		},
		left: carried.left,
		lost: carried.lost,
		places: {
			held: carried.places_held,
			lost: carried.places_lost,
			edits: carried.lost_for_places
		},
		aside: carried.aside.flatMap((step) => edits.slice(step, step + 1))
	};
}
function numbered({ images, surveyed, connected, givenControl, system }) {
	const pairs = [...connected].map((pair) => {
		const [a = -1, b = -1] = pair.split(",").map(Number);
		return [a, b];
	});
	return {
		images: [...images],
		surveyed: [...surveyed],
		connected: pairs,
		found: givenControl,
		system
	};
}
// www/block/state/naming.ts
var NO_NAMES = {
	images: [],
	surveyed: new Map(),
	connected: new Set(),
	givenControl: 0,
	system: null
};
function namesOf$2({ images, surveyed, connections, givenControl, crs }) {
	const connected = connections.filter(({ outcome }) => outcome.kind === "connected").map((pair) => keyOfPair(pair.images));
	return {
		images: images.map(({ name }) => name),
		surveyed: new Map(surveyed.map(({ control, name }) => [control, name])),
		connected: new Set(connected),
		givenControl,
		system: crs
	};
}
var isPlace = (name) => /^orthophoto_\d+$/u.test(name);
function withoutPlaces$1({ surveyed, ...names }) {
	return {
		...names,
		surveyed: new Map([...surveyed].filter(([, name]) => !isPlace(name)))
	};
}
function nameOfStep(step, names = NO_NAMES) {
	const [first, ...more] = step;
	if (first === void 0) return say("nothing");
	if (more.length === 0) return nameOfEdit(first, names);
	if (step.every((edit) => edit.kind === "measure")) return nameOfMeasures(step, names);
	const added = step.filter(({ kind }) => kind === "add_point").length;
	const surveyed = first.kind === "reject_points" && more.every((edit) => edit.kind === "measure") ? more[0] : void 0;
	if (first.kind === "reject_points" && surveyed !== void 0) return say("step-join", { points: first.points.length + 1 });
	if (first.kind === "reject_points" && added === more.length) {
		if (added === 1) return say("step-join", { points: first.points.length });
		if (first.points.length === 1) return say("step-split", { added });
	}
	return say("step-edits", { edits: step.length });
}
function nameOfMarks(step) {
	if (step.kind === "remove_images") return say("step-remove-images", { images: step.files.length });
	if (step.kind === "make_frames") return say("step-make-frames", { scans: step.scans.images.length });
	const { kind, marks } = step;
	const [first] = marks;
	if (first === void 0) return say("step-beside-images");
	const images = marks.length === 1 ? first.image : say("so-many-images", { images: marks.length });
	return kind === "measure" ? say("step-measure-in", {
		verb: "measure",
		what: first.point,
		images
	}) : say("step-unmark", {
		what: first.point,
		images
	});
}
function nameOfMeasures(step, names) {
	const [first, ...more] = step;
	const verb = step.every(({ by }) => by === "least_squares") ? "match" : "measure";
	if (first === void 0) return say("nothing");
	const what = "ground_control" in first.point ? names.surveyed.get(first.point.ground_control) : void 0;
	if (what !== void 0) return say("step-measure-in", {
		verb,
		what,
		images: more.length === 0 ? imageName(first.image, names) : say("so-many-images", { images: step.length })
	});
	return say("step-measure", {
		verb,
		observations: step.length,
		place: more.length === 0 ? inImage(first.image, names) : ""
	});
}
function nameOfEdit(edit, names = NO_NAMES) {
	switch (edit.kind) {
		case "reject_observations":
		case "restore_observations": {
			const [only, ...more] = edit.observations;
			return say("step-observations", {
				verb: verbOf(edit.kind),
				observations: edit.observations.length,
				place: only === void 0 || more.length > 0 ? "" : inImage(only.image, names)
			});
		}
		case "reject_points":
		case "restore_points": {
			const [only, ...more] = edit.points;
			const name = only !== void 0 && more.length === 0 && "ground_control" in only ? names.surveyed.get(only.ground_control) : void 0;
			return name === void 0 ? say("step-points", {
				verb: verbOf(edit.kind),
				points: edit.points.length
			}) : say("step-named", {
				verb: verbOf(edit.kind),
				name
			});
		}
		case "reject_images":
		case "restore_images": {
			const [only, ...more] = edit.images;
			return say("step-named", {
				verb: verbOf(edit.kind),
				name: only === void 0 || more.length > 0 ? say("so-many-images", { images: edit.images.length }) : imageName(only, names)
			});
		}
		case "reject_pairs":
		case "restore_pairs": {
			const [only, ...more] = edit.pairs;
			const named = only === void 0 || more.length > 0 ? null : only.map((image) => names.images[image]);
			return say("step-named", {
				verb: verbOf(edit.kind),
				name: named === null || named.includes(void 0) ? say("so-many-pairs", { pairs: edit.pairs.length }) : named.join(" – ")
			});
		}
		case "measure": return nameOfMeasures([edit], names);
		case "add_point": return say("step-add-point", { images: edit.observations.length });
		case "add_control": return say("step-add-place", { name: edit.name });
		case "set_use": {
			const name = names.surveyed.get(edit.point) ?? say("one-surveyed-point");
			return say("step-use", {
				name,
				use: edit.use ?? "none"
			});
		}
	}
}
var verbOf = (kind) => kind.startsWith("reject") ? "reject" : "restore";
function imageName(image, { images }) {
	return images[image] ?? say("so-many-images", { images: 1 });
}
function inImage(image, { images }) {
	const name = images[image];
	return name === void 0 ? "" : say("in-image", { name });
}
// www/block/state/removing.ts
var LEAST_IMAGES = 2;
var idsRemoved = remember(({ edits, done }) => new Set(edits.slice(0, done).flatMap((step) => step.kind === "remove_images" ? step.files : [])));
function removesOthers(before, after) {
	const [a, b] = [idsRemoved(before), idsRemoved(after)];
	return a.size !== b.size || [...a].some((id) => !b.has(id));
}
function withRemoved(state) {
	const { files, removed, marks } = state;
	const out = idsRemoved(marks);
	const stay = files.filter(({ id }) => !out.has(id));
	const names = new Set(stay.map(({ name }) => name));
	const back = removed.filter(({ id, name }) => !out.has(id) && !names.has(name));
	if (stay.length === files.length && back.length === 0) return state;
	const aside = [...files.filter(({ id }) => out.has(id)), ...removed.filter((file) => !back.includes(file))];
	return {
		...state,
		files: [...stay, ...back].sort((a, b) => a.name < b.name ? -1 : 1),
		removed: aside
	};
}
function removable(files, choice, names) {
	if (choice?.kind !== "image" && choice?.kind !== "images") return [];
	return removableFiles(files, new Set(imagesOf(choice).map((image) => names[image]?.name ?? "")));
}
function removableFiles(files, names) {
	const found = files.filter(({ name }) => names.has(name));
	return found.length === names.size && files.length - found.length >= LEAST_IMAGES ? found : [];
}
// www/block/state/point-kinds.ts
var surveyedOf = remember((surveyed) => new Map(surveyed.map((known) => [known.point, known])));
function surveyedAt({ surveyed }, point) {
	return surveyedOf(surveyed).get(point);
}
function isMeasurable({ points: { taking, lost } }, point) {
	return point < taking || lost.has(point);
}
function pointText$1(view, point) {
	return surveyedAt(view, point)?.name ?? count(view.points.numbers[point] ?? null);
}
function pointColumn(view, key, point, help) {
	const index = (row) => point(row) ?? NaN;
	return {
		...numbers(key, say("point"), "", 0, (row) => view.points.numbers[index(row)], help),
		text: (row) => pointText$1(view, index(row))
	};
}
var countedPoints = remember(({ points, surveyed }) => {
	const all = [...surveyedOf(surveyed).keys()].filter((point) => point >= 0);
	const known = all.filter((point) => point < points.taking);
	const observations = points.rays.subarray(0, points.taking).reduce((sum, rays) => sum + rays, 0);
	const own = known.reduce((sum, point) => sum + (points.rays[point] ?? 0), 0);
	return {
		tie: {
			points: points.taking - known.length,
			observations: observations - own
		},
		surveyed: {
			points: known.length,
			observations: own
		},
		gone: points.count - points.taking - points.lost.size - (all.length - known.length)
	};
});
// www/block/state/words.ts
function connectionOf(view, pair) {
	return connectionsOf(view).get(keyOfPair(pair));
}
function outcomeText({ reason, rejected }) {
	return rejected ? say("pair-rejected-by-hand", { reason }) : reason;
}
var CONNECTIONS = new WeakMap();
function connectionsOf(view) {
	const known = CONNECTIONS.get(view);
	if (known !== void 0) return known;
	const made = new Map(view.connections.map((connection) => [keyOfPair(connection.images), connection]));
	CONNECTIONS.set(view, made);
	return made;
}
function matchesOf$1({ outcome }) {
	return outcome.kind === "connected" ? outcome.matches : 0;
}
function mostMatches({ connections }) {
	return connections.reduce((high, connection) => Math.max(high, matchesOf$1(connection)), 0);
}
function describe({ view, given }, choice, gsd = "") {
	switch (choice.kind) {
		case "image": return describeImage(view, choice.image, gsd);
		case "images": return describeImages(view, choice.images);
		case "pair": return describePair(view, choice.images);
		case "pairs": return describePairs(view, choice.pairs);
		case "point": return describePoint(view, choice.point);
		case "observation": return `${asFigure(view.images[choice.image]?.name ?? "")}, ${describePoint(view, choice.point)}`;
		case "observations": return say("several-observations", {
			observations: choice.points.length,
			points: pointsOf(choice).length
		});
		case "points": return describePoints(view, choice.points);
		case "given": return describeGiven(view, given, choice.name);
	}
}
function describeImage(view, index, gsd) {
	const image = view.images[index];
	if (image === void 0) return "";
	const partners = view.connections.filter(({ images, outcome }) => images.includes(index) && outcome.kind === "connected").length;
	return `${[
		say("observations-4", {
			name: image.name,
			what: image.features === null ? "" : say("features-2", { features: image.features }),
			rays: image.rays,
			what_2: image.places === null ? "" : say("in-of-9-von-gruber", { places: image.places })
		}),
		say("connected-with-of-images", {
			partners,
			images: view.images.length - 1
		}),
		image.rmsePx === null ? "" : say("rmse-px-3", { rmse_px: image.rmsePx }),
		gsd,
		image.oriented ? say("oriented") : image.why ?? say("not-oriented-yet"),
		image.exifOrientation === null || image.exifOrientation === 1 ? "" : say("used-as-stored-exif-orientation", { exif_orientation: image.exifOrientation })
	].filter((part) => part !== "").join("; ")}.`;
}
var MOST_NAMES$2 = 6;
function describeImages({ images }, chosen) {
	const names = chosen.slice(0, MOST_NAMES$2).map((image) => images[image]?.name ?? "");
	return say("several-images", {
		images: chosen.length,
		names: [...names, ...chosen.length > MOST_NAMES$2 ? ["…"] : []].join(", ")
	});
}
var GEOMETRIES = new WeakMap();
function geometryText(geometry) {
	if (geometry === null) return "";
	const { kind, degenerate, sigmaPx } = geometry;
	const weak = degenerate === null ? null : message("degeneracy", degenerate, "short");
	const text = GEOMETRIES.get(geometry) ?? say("geometry", {
		model: message("two_view_model", { kind }, "short"),
		weak,
		sigma_px: sigmaPx
	});
	GEOMETRIES.set(geometry, text);
	return text;
}
function describePair(view, images) {
	const names = nameOfPair(view, images);
	const connection = connectionOf(view, images);
	if (connection === void 0) return say("this-pair-was-not-tried", { names });
	const { geometry, shared, chosen } = connection;
	const parts = [
		outcomeText(connection).replace(/\.$/u, ""),
		geometryText(geometry),
		shared > 0 ? say("common-points-selected", {
			shared,
			chosen
		}) : ""
	];
	return `${asFigure(names)}: ${parts.filter((part) => part !== "").join("; ")}.`;
}
function nameOfPair({ images }, pair) {
	return pair.map((image) => images[image]?.name ?? "").join(" – ");
}
function describePairs(view, pairs) {
	const names = pairs.slice(0, MOST_NAMES$2).map((pair) => nameOfPair(view, pair));
	return say("several-pairs", {
		pairs: pairs.length,
		names: [...names, ...pairs.length > MOST_NAMES$2 ? ["…"] : []].join(", ")
	});
}
function nameOfPoint(view, point) {
	return surveyedAt(view, point)?.name ?? say("point-of-number", { number: view.points.numbers[point] ?? 0 });
}
function describePoint(view, point) {
	const { points } = view;
	const axes = [
		0,
		1,
		2
	].map((axis) => 3 * point + axis);
	const [x = NaN, y = NaN, z = NaN] = axes.map((at) => points.positions[at]);
	const errors = axes.map((at) => points.errors[at] ?? NaN);
	return `${[
		say("rays-3", {
			name: nameOfPoint(view, point),
			rays: points.rays[point] ?? 0
		}),
		known$1(points.rmsePx[point]) ? say("rmse-px-3", { rmse_px: points.rmsePx[point] ?? NaN }) : "",
		known$1(points.positions[3 * point]) ? coordinatesText(view, [
			x,
			y,
			z
		], 2) : say("not-intersected"),
		errors.every(known$1) ? inUnitOf(view, `± ${errors.map((error) => fixed(error, 3)).join(" ")}`) : "",
		point < points.taking ? "" : say(points.lost.has(point) ? "too-few-rays" : "rejected-by-hand-2")
	].filter((part) => part !== "").join("; ")}.`;
}
function describeGiven(view, given, name) {
	const point = given.find((own) => own.name === name);
	if (point === void 0) return name;
	const place = point.place === null ? point.position : resultSystem(view).coordinates(Float64Array.from(point.place));
	const said = {
		name,
		place: Array.from(place, (value) => fixed(value, 3)).join(" "),
		use: givenUse(point)
	};
	return point.place === null ? say("given-point-of-file", said) : say("given-point", said);
}
function controlText(state) {
	const { twice, needed } = collectedOf(state);
	return say("control-waits", {
		twice,
		needed
	});
}
function givenUse({ role, images }) {
	return say("given-use", {
		role: role ?? "none",
		images
	});
}
function describePoints(view, chosen) {
	const { points } = view;
	let [least, most, squares, adjusted] = [
		Infinity,
		0,
		0,
		0
	];
	for (const point of chosen) {
		const rays = points.rays[point] ?? 0;
		[least, most] = [Math.min(least, rays), Math.max(most, rays)];
		const rmse = points.rmsePx[point] ?? NaN;
		if (!known$1(rmse)) continue;
		squares += rays * rmse * rmse;
		adjusted += rays;
	}
	const gone = chosen.length - chosen.filter((point) => point < points.taking || points.lost.has(point)).length;
	const rays = least === most ? count(most) : say("to", {
		least,
		most
	});
	return say("tie-points-of-rays", {
		chosen: chosen.length,
		surveyed: chosen.filter((point) => surveyedAt(view, point) !== void 0).length,
		rays,
		what: adjusted > 0 ? say("rmse-px-5", { squares: Math.sqrt(squares / adjusted) }) : "",
		what_2: gone > 0 ? say("rejected-by-hand-3", { gone }) : ""
	});
}
function known$1(value) {
	return value !== void 0 && !Number.isNaN(value);
}
// www/block/state/draft.ts
function choiceOfDraft({ of }, view) {
	if (of === null) return null;
	if (isGiven(of)) return {
		kind: "given",
		name: of.given
	};
	const point = indexOfSource(view, of);
	return point < 0 ? null : {
		kind: "point",
		point
	};
}
function draftInOtherView(draft, before, after) {
	if (draft === null || draft.of !== null || before === void 0) return null;
	const indices = new Map(after.images.map(({ name }, image) => [name, image]));
	const places = [...draft.places].flatMap(([image, place]) => {
		const index = indices.get(before.images[image]?.name ?? "");
		return index === void 0 ? [] : [[index, place]];
	});
	return places.length === 0 ? null : {
		of: null,
		places: new Map(places)
	};
}
function begun(of) {
	return {
		of,
		places: new Map()
	};
}
function placed$1(draft, image, [x, y], { width, height }, by = "hand") {
	const at = [roundedPx(Math.min(width, Math.max(0, x))), roundedPx(Math.min(height, Math.max(0, y)))];
	return {
		...draft,
		places: new Map([...draft.places, [image, {
			at,
			by
		}]])
	};
}
function nameOfDraft({ of }, view) {
	if (of === null) return say("new-point");
	return isGiven(of) ? of.given : nameOfPoint(view, indexOfSource(view, of));
}
function withoutLast({ of, places }) {
	return places.size === 0 ? null : {
		of,
		places: new Map([...places].slice(0, -1))
	};
}
function placesAsSteps({ places }) {
	return {
		edits: [...places.keys()],
		done: places.size
	};
}
function isGiven(of) {
	return of !== null && "given" in of;
}
function stepOfDraft(draft, names, after, added) {
	const { of, places } = draft;
	if (!isGiven(of)) {
		const edits = editsOfDraft(draft);
		return edits === null ? null : {
			type: "edit",
			edits
		};
	}
	const own = added.get(of.given);
	if (own !== void 0) {
		const edits = editsOfDraft({
			of: { ground_control: own.control },
			places
		});
		return edits === null ? null : {
			type: "edit",
			edits
		};
	}
	const marks = [...places].flatMap(([image, { at }]) => {
		const name = names[image];
		return name === void 0 ? [] : [{
			image: name,
			point: of.given,
			x_px: at[0],
			y_px: at[1]
		}];
	});
	return marks.length === 0 ? null : {
		type: "mark",
		step: {
			kind: "measure",
			marks,
			after
		}
	};
}
function editsOfDraft({ of, places }) {
	if (isGiven(of)) return null;
	const observations = [...places].map(([image, { at, by }]) => ({
		image,
		x_px: at[0],
		y_px: at[1],
		by
	}));
	if (of !== null) return observations.length === 0 ? null : observations.map((one) => ({
		kind: "measure",
		point: of,
		...one
	}));
	return observations.length < 2 ? null : [{
		kind: "add_point",
		observations
	}];
}
// www/block/state/framing.ts
function between({ edits }, from, to) {
	return edits.flatMap((step, at) => at >= from && at < to && isFramesStep(step) ? [at] : []);
}
function framesOthers(marks, done) {
	return between(marks, Math.min(marks.done, done), Math.max(marks.done, done)).length > 0;
}
function withFrames(state, before) {
	const { marks } = state;
	const back = between(marks, marks.done, before).reverse();
	const again = between(marks, before, marks.done);
	const undone = back.reduce((now, at) => exchanged(now, at, ({ scans, frames }) => [frames, scans]), state);
	return again.reduce((now, at) => exchanged(now, at, ({ scans, frames }) => [scans, frames]), undone);
}
function exchanged(state, at, of) {
	const { files, removed, options, placing, marks } = state;
	const step = marks.edits[at];
	if (step === void 0 || !isFramesStep(step)) return state;
	const [from, into] = of(step);
	return {
		...state,
		files: imagesAfter(files, from, into),
		removed: without(removed, from.images),
		options: {
			...options,
			...optionsAfter(options, from, into)
		},
		placing: {
			...placing,
			film: filmAfter(placing.film, from.film, into.film)
		},
		marks: {
			...marks,
			edits: stepsAfter(marks.edits, at, into.steps)
		},
		running: withoutRunUnderWay(state.running)
	};
}
function without(files, gone) {
	const ids = new Set(gone.map(({ id }) => id));
	return files.some(({ id }) => ids.has(id)) ? files.filter(({ id }) => !ids.has(id)) : files;
}
function imagesAfter(files, from, into) {
	const successors = new Map(from.images.map(({ id }, k) => [id, into.images[k]]));
	const names = new Set(without(files, from.images).map(({ name }) => name));
	const isFree = (file) => file !== void 0 && !names.has(file.name);
	return files.flatMap((file) => {
		if (!successors.has(file.id)) return [file];
		const next = successors.get(file.id);
		return isFree(next) ? [next] : [];
	});
}
function optionsAfter(options, from, into) {
	const given = (now, before, then) => now?.text === before?.text ? then : now;
	const isSame = options.masks.length === from.masks.length && options.masks.every(({ id }, k) => id === from.masks[k]?.id);
	const others = without(options.masks, without(from.masks, into.masks));
	return {
		masks: isSame ? into.masks : [...others, ...without(into.masks, [...from.masks, ...others])],
		cameras: given(options.cameras, from.cameras, into.cameras),
		marks: given(options.marks, from.marks, into.marks)
	};
}
function filmAfter(now, from, into) {
	const names = new Set([...from.marks, ...into.marks].map(({ name }) => name));
	const images = new Set([...from.begun, ...into.begun].map(({ image }) => image));
	return {
		camera: now.camera?.text === from.camera?.text ? into.camera : now.camera,
		marks: [...into.marks, ...now.marks.filter(({ name }) => !names.has(name))],
		areScans: into.areScans || now.areScans && !from.areScans,
		begun: [...into.begun, ...now.begun.filter(({ image }) => !images.has(image))]
	};
}
function stepsAfter(edits, at, before) {
	const placed = before.slice(0, at).map((step, i) => {
		const { after = step.after } = edits[i] ?? {};
		return after === step.after ? step : {
			...step,
			after
		};
	});
	return [...placed, ...edits.slice(placed.length)];
}
// www/block/state/editing.ts
function isEditable({ shown, running }) {
	return shown !== null && !shown.view.partial && shown.view.oriented > 0 && running.kind !== "yes";
}
var editsInForce = remember(({ edits, done }) => edits.slice(0, done).flat());
function nextEdits(history, now, single) {
	const wanted = editsInForce(history);
	let count = 0;
	const at = history.edits.findIndex((step) => {
		if (count === now.length) return true;
		count += step.length;
		return false;
	});
	const several = at >= 0 && isSameList(wanted.slice(0, now.length), now) && history.done > at + 1;
	return {
		edits: several && single ? history.edits.slice(0, at + 1).flat() : wanted,
		several
	};
}
function isSameList(a, b) {
	return a === b || a.length === b.length && a.every((edit, i) => edit === b[i]);
}
function reduceEdits(state, action) {
	switch (action.type) {
		case "edit":
			if (!isEditable(state)) return state;
			return {
				...state,
				...withStep(state, action.edits),
				draft: null,
				notice: afterEdit(state)
			};
		case "goto":
			if (!isEditable(state)) return state;
			return {
				...state,
				history: wentTo(state.history, action.done),
				draft: null,
				notice: afterEdit(state)
			};
		case "adjusting": return {
			...state,
			adjusting: action.adjusting
		};
		case "edited": return state.shown === null ? state : withEdited(state, state.shown, action.view, action.edits);
		case "editRefused": {
			const notice = {
				kind: "problem",
				text: say("the-edit-was-not-made", { reason: action.reason })
			};
			return {
				...state,
				...refused(state),
				notice
			};
		}
		case "mark":
			if (action.step.kind !== "remove" && !isFramesStep(action.step) && !isEditable(state)) return state;
			return withSteps(state, recorded(state.marks, action.step));
		case "gotoMark": return withSteps(state, wentTo(state.marks, action.done));
		case "accept": return accepted(state, action.leaves);
		case "draft": return {
			...state,
			draft: isEditable(state) ? action.draft : null,
			notice: action.draft === null && state.notice?.beside === true ? null : state.notice
		};
	}
}
function accepted(state, leaves) {
	const { draft, shown, history } = state;
	if (draft === null || shown === null) return state;
	const step = stepOfDraft(draft, shown.view.images.map(({ name }) => name), history.done, addedPoints(editsInForce(history), shown.view.givenControl));
	const taken = step === null ? state : reduceEdits(state, step);
	if (!leaves) return taken;
	if (taken === state) return {
		...state,
		draft: null
	};
	return {
		...taken,
		notice: taken.notice ?? {
			kind: "info",
			text: say("accepted-as-placed", {
				name: nameOfDraft(draft, shown.view),
				images: draft.places.size
			}),
			beside: true
		}
	};
}
function withSteps(state, marks) {
	return withRemoved(withFrames({
		...state,
		marks,
		draft: null,
		notice: afterEdit(state)
	}, state.marks.done));
}
function afterEdit({ notice }) {
	return notice?.kind === "busy" ? notice : null;
}
function withoutRefused(history, made) {
	const { edits, done } = history;
	const kept = stepsOf(history, made);
	if (kept.some((step, i) => step !== edits[i])) return {
		edits: kept,
		done: kept.length
	};
	if (kept.length >= done) return {
		edits,
		done: kept.length
	};
	return {
		edits: edits.filter((_, i) => i !== kept.length),
		done: done - 1
	};
}
function refused(state) {
	const history = withoutRefused(state.history, state.shown?.edits ?? []);
	const gone = state.history.edits.findIndex((step, i) => step !== history.edits[i]);
	const place = (after) => Math.min(history.edits.length, gone < 0 || after <= gone ? after : after - 1);
	return {
		history,
		marks: besideEdits(state.marks, place)
	};
}
function withStep({ history, marks }, step) {
	const after = recorded(history, step);
	return {
		history: after,
		marks: besideEdits(marks, (place, at) => at < marks.done ? place : Math.max(place, after.done))
	};
}
function stepsOf({ edits: steps }, edits) {
	let count = 0;
	const kept = steps.filter((step) => {
		const stays = count + step.length <= edits.length && step.every((edit, i) => edit === edits[count + i]);
		count = stays ? count + step.length : Infinity;
		return stays;
	});
	return [...kept, ...edits.slice(kept.flat().length).map((edit) => [edit])];
}
function withEdited(state, shown, view, edits) {
	const { selection, draft } = state;
	const next = (edits.length > shown.edits.length ? newPoint(edits, view) ?? takenIn(selection.chosen, view) : null) ?? choiceAfterEdit(selection.chosen, shown.view, view);
	const measured = draft === null ? null : choiceOfDraft(draft, view);
	const chosen = measured?.kind === "point" && !pointsOf(next).includes(measured.point) ? measured : next;
	return {
		...state,
		shown: {
			...shown,
			view,
			edits
		},
		before: figuresOf$3(shown.view),
		selection: {
			...selection,
			chosen,
			pointed: null
		}
	};
}
function newPoint(edits, view) {
	if (edits.at(-1)?.kind !== "add_point") return null;
	const point = indexOfSource(view, { manual: edits.filter(({ kind }) => kind === "add_point").length - 1 });
	return point < 0 ? null : {
		kind: "point",
		point
	};
}
function takenIn(chosen, { surveyed }) {
	const point = chosen?.kind === "given" ? surveyed.find(({ name }) => name === chosen.name)?.point ?? -1 : -1;
	return point < 0 ? null : {
		kind: "point",
		point
	};
}
var NOTHING_CARRIED = {
	history: NO_HISTORY,
	left: [0],
	lost: 0,
	places: NO_PLACES_AGAIN,
	aside: []
};
function carried(state, view) {
	const { history, marks, shown, former } = state;
	if (shown === null || history.edits.length === 0 && former.length === 0) return keptOf(NOTHING_CARRIED, marks, NO_NAMES);
	const after = nameOfTiePoints(view);
	const way = shown.tiePoints === after ? [] : wayBack(former, after, history);
	const [last] = way.slice(-1);
	if (last !== void 0) {
		const back = way.reduce((steps, one) => marksBefore(one, steps), marks);
		const regained = carriedOver(last.history, last.names, namesOf$2(view), true);
		if (regained.lost + regained.aside.length > 0 || last.names.givenControl !== view.givenControl) {
			const { edits, said, ofPlaces } = keptMeanwhile(regained, back, last.names);
			const places = back.edits.map((step) => step.after);
			const awaiting = {
				...last,
				kept: regained.history,
				left: regained.left,
				places,
				sameTiePoints: true,
				ofPlaces
			};
			return {
				edits: {
					...edits,
					former,
					awaiting
				},
				said
			};
		}
		return {
			edits: {
				...UNEDITED,
				former,
				history: last.history,
				marks: back
			},
			said: saidOfKept(last.history)
		};
	}
	const waiting = awaitedOf(state);
	const now = {
		tiePoints: shown.tiePoints,
		names: namesOf$2(shown.found),
		history,
		spots: shown.ground?.places ?? null
	};
	const { tiePoints, names, history: steps, spots } = waiting ?? now;
	const beside = waiting === null ? marks : marksBefore(waiting, marks);
	const isSame = tiePoints === after;
	const found = carriedOver(steps, names, namesOf$2(view), isSame);
	if (isSame && found.lost + found.aside.length === 0 && names.givenControl === view.givenControl) return {
		edits: {
			...UNEDITED,
			former,
			history: steps,
			marks: beside
		},
		said: saidOfKept(steps)
	};
	const { edits, said, ofPlaces } = keptMeanwhile(found, beside, names);
	const places = beside.edits.map((step) => step.after);
	const one = {
		tiePoints,
		names,
		history: steps,
		kept: found.history,
		left: found.left,
		places,
		spots
	};
	return {
		edits: {
			...edits,
			former: tiePoints === "" ? [] : withFormer(former, one),
			awaiting: {
				...one,
				sameTiePoints: isSame,
				ofPlaces
			}
		},
		said
	};
}
function keptMeanwhile(found, marks, names) {
	const ofPlaces = found.places.edits;
	const { edits, said } = keptOf({
		...found,
		places: {
			...NO_PLACES_AGAIN,
			edits: ofPlaces
		}
	}, marks, names);
	return {
		edits,
		said: [said, ofPlaces === 0 ? "" : say("edits-of-places-wait", { edits: ofPlaces })].filter((part) => part !== "").join(" "),
		ofPlaces
	};
}
function awaitingAgain(former, history, shown) {
	const last = former.at(-1);
	if (last === void 0 || last.spots === null || shown === null || shown.ground !== null) return null;
	if (last.kept.edits !== history.edits || last.kept.done !== history.done) return null;
	const ofPlaces = editsInForce(last.history).length - editsInForce(history).length;
	return {
		...last,
		sameTiePoints: last.tiePoints === shown.tiePoints,
		ofPlaces: Math.max(0, ofPlaces)
	};
}
function saidOfKept(history) {
	const held = editsInForce(history).length;
	return held === 0 ? "" : say("by-hand-kept", { edits: held });
}
function carriedToGround(state, view, isOff, again) {
	const awaited = isOff ? null : awaitedOf(state);
	if (awaited !== null) return arrived(awaited, state, view, again);
	const { history, marks, shown, former } = state;
	const gone = isOff ? 0 : state.awaiting?.ofPlaces ?? 0;
	const saidOfGone = gone === 0 ? "" : say("of-points-of-the-former", { lost: gone });
	const names = shown === null ? NO_NAMES : namesOf$2(shown.found);
	const isSame = names.givenControl === view.givenControl && withoutPlaces$1(names).surveyed.size === names.surveyed.size;
	const found = isSame ? allCarried(history) : carriedOver(history, names, withoutPlaces$1(namesOf$2(view)), true, again);
	const { history: left, left: places, aside } = isOff ? placesSetAside(found.history, view.givenControl) : {
		...allCarried(found.history),
		aside: 0
	};
	if (isSame && aside === 0) return {
		edits: {
			...UNEDITED,
			former,
			history,
			marks
		},
		said: saidOfGone
	};
	const ofPlaces = isOff ? NO_PLACES_AGAIN : found.places;
	const now = {
		...found,
		places: ofPlaces,
		history: left,
		left: found.left.map((count) => places[count] ?? left.edits.length)
	};
	const { edits, said } = keptOf(now, marks, names);
	return {
		edits: {
			...edits,
			former: formerOf(former, history, now.history, now.left)
		},
		said: [
			said,
			saidOfGone,
			aside === 0 ? "" : say("places-set-aside", { steps: aside })
		].filter((part) => part !== "").join(" ")
	};
}
function arrived(awaited, { marks, former }, view, again) {
	const { history, names, sameTiePoints } = awaited;
	const found = carriedOver(history, names, withoutPlaces$1(namesOf$2(view)), sameTiePoints, again);
	const { edits, said } = keptOf(found, marksBefore(awaited, marks), names);
	const ofIt = former.map((one) => one.history === history ? {
		...one,
		kept: found.history,
		left: found.left
	} : one);
	return {
		edits: {
			...edits,
			former: sameTiePoints ? formerOf(former, history, found.history, found.left) : ofIt
		},
		said
	};
}
function marksBefore(former, marks) {
	const places = placesBefore(former, marks.edits);
	return besideEdits(marks, (after, at) => places[at] ?? after);
}
function allCarried(history) {
	return {
		history,
		left: [...history.edits.keys(), history.edits.length],
		lost: 0,
		places: NO_PLACES_AGAIN,
		aside: []
	};
}
var MOST_NAMED$1 = 3;
function keptOf({ history, left, lost: ofAll, places, aside }, marks, names) {
	const steps = [...aside.slice(0, MOST_NAMED$1).map((step) => nameOfStep(step, names)), ...aside.length > MOST_NAMED$1 ? ["…"] : []].join(", ");
	const lost = ofAll - places.edits;
	const said = [
		saidOfKept(history),
		lost === 0 ? "" : say("of-points-of-the-former", { lost }),
		places.held + places.lost === 0 ? "" : say("edits-of-places", {
			held: places.held,
			lost: places.lost
		}),
		aside.length === 0 ? "" : say("cannot-be-done-again", {
			undone: aside.length,
			steps
		})
	];
	const moved = besideEdits(marks, (after) => left[after] ?? history.edits.length);
	return {
		edits: {
			...UNEDITED,
			history,
			marks: moved
		},
		said: said.filter((part) => part !== "").join(" ")
	};
}
// www/block/state/lacking.ts
var NOT_HELD = "application/x-not-held";
function standIn(name) {
	return new File([], name, { type: NOT_HELD });
}
function isLacking({ file }) {
	return file.type === NOT_HELD;
}
function lackingText({ shown, options, placing }) {
	const { masks, geoid } = options;
	const files = [...masks, ...geoid === null ? [] : [geoid]].filter(isLacking);
	const lies = shown !== null && shown.ground === null && shown.view.orthophoto?.kind === "linked" && placing.orthophoto === null;
	return [files.length === 0 ? "" : say("a-run-needs-files", { files: files.length }), lies ? say("a-run-needs-its-orthophoto") : ""].filter((part) => part !== "").join(" ");
}
// www/block/state/given.ts
var PARTNER_MISSING = { marks: say("image-measurements-need-their-ground") };
function problemsOf(state) {
	const { files, options } = state;
	const { settings, cameras, control, marks, positions, masks, geoid } = options;
	return problems(files, settings?.placing ?? null, cameras, control, marks, positions, masks, geoid, collectedOf(state), purposeOf(state) === "block");
}
function firstProblem(state) {
	return Object.values(problemsOf(state))[0] ?? null;
}
function isUnread(error) {
	return error instanceof Error && "error" in error && error.error?.refusal?.kind === "crs_text";
}
var problems = remember((files, placing, cameras, control, marks, positions, masks, geoid, { run }, onOrthophoto) => {
	if (placing === null) return {};
	const names = files.map(({ name }) => name);
	const found = {};
	const { crs } = placing;
	const look = (given, name, read) => {
		try {
			read();
			return true;
		} catch (error) {
			found[given] = `${name === "" ? "" : `${name}: `}${isUnread(error) ? say("system-cannot-be-read") : messageOf(error)}`;
			return false;
		}
	};
	const isRead = crs === null || look("crs", "placing.crs", () => system_positions(crs, []));
	if (cameras !== null) look("cameras", cameras.name, () => check_cameras(cameras.text, names));
	const pointsRead = control !== null && look("control", control.name, () => parse_ground_control_points(control.text));
	const marksRead = marks === null || look("marks", marks.name, () => parse_image_measurements(marks.text));
	if (isRead && pointsRead && marksRead && run !== null) look("marks", marks?.name ?? "", () => check_control(run.points, run.marks, names, placing, onOrthophoto));
	if (marks !== null && control === null) found.marks ??= PARTNER_MISSING.marks ?? "";
	if (isRead && positions !== null) look("positions", positions.name, () => positions_of_images(positions.text, names, placing));
	const lacking = masks.filter(isLacking);
	look("masks", "", () => masks_of_images(names, masks.map(({ name }) => name)));
	if (lacking.length > 0) found.masks = say("masks-are-not-in-the-file", {
		masks: lacking.length,
		name: lacking[0]?.name ?? ""
	});
	if (geoid !== null && isLacking(geoid)) found.geoid = say("geoid-is-not-in-the-file", { name: geoid.name });
	else if (geoid !== null) look("geoid", "", () => check_geoid(geoid.name, placing));
	return found;
});
// www/block/engine/engine.ts
var PATIENCE_MS = 80;
var EXPORT_PATIENCE_MS = 3e3;
var BlockEngine = class {
	store;
	pool = new WorkerPool();
	block = new WorkerClient("block");
	kept = new Map();
	recorded = () => void 0;
	port = null;
	told = null;
	reading = null;
	heldIn = -1;
	spare = null;
	regaining = null;
	writing = null;
	constructor(store) {
		this.store = store;
	}
	async run() {
		const { state } = this.store;
		const { settings } = state.options;
		if (settings === null || state.running.kind === "yes") return;
		const problem = firstProblem(state);
		if (problem !== null) {
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "problem",
					text: say("not-run", { problem: sentence(problem) })
				}
			});
			return;
		}
		const key = wantedKey(state);
		const { files, truth } = state;
		const started = performance.now();
		this.store.dispatch({
			type: "started",
			key
		});
		const channel = new MessageChannel();
		this.listen(channel.port1, files);
		try {
			const input = {
				files,
				options: {
					...runOptions({
						...state.options,
						...givenToRun(state)
					}, settings),
					onOrthophoto: purposeOf(state) === "block"
				},
				masks: state.options.masks,
				geoid: state.options.geoid,
				truth,
				workers: this.pool.size,
				kept: this.kept,
				port: channel.port2
			};
			const view = await this.block.call("blockRun", input, [channel.port2]);
			this.heldIn = this.block.generation;
			this.spare = null;
			rememberCalibrations(calibrationsOf(view, truth !== null, Date.now()));
			this.store.dispatch({
				type: "done",
				key,
				view,
				files,
				seconds: (performance.now() - started) / 1e3
			});
		} catch (error) {
			this.pool.cancel();
			const stopped = this.port !== channel.port1;
			this.store.dispatch({
				type: "ended",
				failure: stopped || error instanceof Cancelled ? null : reasonOf$1(error)
			});
		} finally {
			channel.port1.close();
			if (this.port === channel.port1) this.port = null;
			if (this.told === channel.port1) this.told = null;
		}
	}
	cancel() {
		const { port, writing } = this;
		this.port = null;
		this.writing = null;
		this.pool.cancel();
		port?.postMessage({ kind: "stop" });
		writing?.postMessage("stop");
		if (port === null && writing === null) return;
		window.setTimeout(() => {
			if (isBusy(this.store.state) && this.port === null && this.writing === null) this.block.cancel();
		}, port === null ? EXPORT_PATIENCE_MS : PATIENCE_MS);
	}
	leave() {
		if (this.told === null) return;
		this.told.onmessage = null;
		this.port = null;
		this.pool.cancel();
		this.block.cancel();
	}
	get records() {
		return this.kept;
	}
	takeRecords(records) {
		this.kept.clear();
		for (const [key, record] of records) this.kept.set(key, record);
	}
	watchRecords(recorded) {
		this.recorded = recorded;
	}
	async project() {
		await this.regained();
		const { port1, port2 } = new MessageChannel();
		try {
			const { bytes } = await this.block.call("blockExport", {
				kind: "project",
				name: "block",
				stop: port2
			}, [port2]);
			return new Blob([bytes]);
		} finally {
			port1.close();
		}
	}
	async read(bytes, truth = null) {
		this.reading?.cancel();
		const worker = new WorkerClient("block");
		this.reading = worker;
		const opened = await worker.call("blockOpen", {
			bytes,
			truth
		}, [bytes.buffer]);
		const hold = () => {
			this.block.cancel();
			this.block = worker;
			this.reading = null;
			this.heldIn = worker.generation;
			this.spare = null;
		};
		const ofShown = async () => {
			await this.regained();
			return this.block.call("blockPlaces", null);
		};
		const placesAgain = async (before) => worker.call("blockPlacesAgain", { before: before ?? await ofShown() });
		return {
			...opened,
			hold,
			places: () => worker.call("blockPlaces", null),
			placesAgain
		};
	}
	async edited(edits) {
		await this.regained();
		if (this.port !== null) throw new Cancelled("cancelled");
		return this.block.call("blockEdited", this.inSteps(edits));
	}
	keepSpare(project) {
		this.spare = project;
	}
	async regained() {
		const { spare } = this;
		if (this.heldIn === this.block.generation || spare === null) return;
		this.regaining ??= this.regain(spare).finally(() => {
			this.regaining = null;
		});
		await this.regaining;
	}
	async regain(spare) {
		const { block } = this;
		const bytes = new Uint8Array(await spare.arrayBuffer());
		await block.call("blockOpen", {
			bytes,
			truth: null
		}, [bytes.buffer]);
		if (block !== this.block || this.port !== null) return;
		this.heldIn = block.generation;
		const { shown } = this.store.state;
		if (shown !== null) await this.block.call("blockEdited", this.inSteps(shown.edits));
	}
	inSteps(edits) {
		const { history, truth } = this.store.state;
		return {
			steps: stepsOf(history, edits),
			truth
		};
	}
	async imagePoints(image) {
		await this.regained();
		return this.block.call("blockImagePoints", { image });
	}
	async observations(images) {
		await this.regained();
		return this.block.call("blockObservations", { images });
	}
	async ground() {
		await this.regained();
		return this.block.call("blockGround", null);
	}
	async pointDetail(point) {
		await this.regained();
		return this.block.call("blockPoint", { point });
	}
	async epipolarLine(from, x, y, to) {
		await this.regained();
		return this.block.call("blockLine", {
			from,
			x,
			y,
			to
		});
	}
	grey(file) {
		return this.pool.call("blockGrey", { file });
	}
	window(file, at, turn) {
		return this.pool.call("blockWindow", {
			file,
			at,
			turn
		});
	}
	async matched(left, file, near, turn) {
		const by = await this.pool.call("blockFit", {
			left,
			right: await this.window(file, near, turn)
		});
		if (by === null) return null;
		const [ax, ay, bx, by_] = turn;
		return [near[0] + by[0] * ax + by[1] * bx, near[1] + by[0] * ay + by[1] * by_];
	}
	async export(kind, name) {
		const { port1, port2 } = new MessageChannel();
		this.writing = port1;
		try {
			await this.regained();
			return await this.block.call("blockExport", {
				kind,
				name,
				stop: port2
			}, [port2]);
		} catch (error) {
			throw this.writing === port1 ? error : new Cancelled("cancelled");
		} finally {
			if (this.writing === port1) this.writing = null;
			port1.close();
		}
	}
	async photograph(flight, done) {
		const truth = await this.pool.call("blockPlan", flight);
		let count = 0;
		return {
			files: await Promise.all(truth.images.map(async ({ name }, index) => {
				const bytes = await this.pool.call("blockPhoto", {
					flight,
					index
				});
				count += 1;
				done(count, truth.images.length);
				return {
					name,
					file: new Blob([bytes], { type: "image/png" })
				};
			})),
			truth
		};
	}
	listen(port, files) {
		this.port = port;
		this.told = port;
		port.onmessage = (event) => {
			const message = event.data;
			if (message.kind === "keep") {
				this.kept.set(message.key, message.record);
				this.recorded();
			} else if (message.kind === "job") this.perform(port, message.id, message.job);
			else if (message.kind === "part") this.store.dispatch({
				type: "part",
				view: message.view,
				files
			});
			else if (this.port === port) this.store.dispatch({
				type: "step",
				step: message.step
			});
		};
	}
	async perform(port, id, job) {
		const tell = (message, transfer = []) => port.postMessage(message, transfer);
		try {
			if (this.port !== port) return;
			const answer = await this.pool.call("blockJob", job, buffersOf(job));
			tell({
				kind: "answer",
				id,
				answer
			}, "made" in answer ? [answer.made.buffer] : []);
		} catch (error) {
			if (!(error instanceof Cancelled)) tell({
				kind: "broke",
				id,
				message: reasonOf$1(error)
			});
		}
	}
};
function runOptions({ gps, cameras, control, marks, positions }, settings) {
	return {
		settings,
		gps,
		...cameras === null ? {} : { cameras },
		...control === null || marks === null ? {} : { control: {
			points: control.text,
			marks: marks.text
		} },
		...positions === null ? {} : { positions: positions.text }
	};
}
function buffersOf({ inputs }) {
	return [...new Set(inputs.map(({ buffer }) => buffer))];
}
function reasonOf$1(error) {
	return breakdownOf(error) ?? messageOf(error);
}
// www/block/engine/follow.ts
var MOST_FAILURES = 1;
var EditFollower = class {
	store;
	engine;
	busy = false;
	singly = false;
	failures = 0;
	constructor(store, engine) {
		this.store = store;
		this.engine = engine;
		store.watch([
			"history",
			"shown",
			"running"
		], () => void this.follow());
	}
	async follow() {
		if (this.busy) return;
		this.busy = true;
		while (await this.step());
		this.busy = false;
		if (this.store.state.adjusting) this.store.dispatch({
			type: "adjusting",
			adjusting: false
		});
	}
	async step() {
		const { history, shown } = this.store.state;
		const wanted = editsInForce(history);
		if (!isEditable(this.store.state) || shown === null || isSameList(wanted, shown.edits)) return false;
		const { edits, several } = nextEdits(history, shown.edits, this.singly);
		if (!this.store.state.adjusting) this.store.dispatch({
			type: "adjusting",
			adjusting: true
		});
		try {
			const view = await this.engine.edited(edits);
			this.failures = 0;
			if (edits.length === wanted.length) this.singly = false;
			if (this.store.state.shown?.found === shown.found) this.store.dispatch({
				type: "edited",
				view,
				edits
			});
			return true;
		} catch (error) {
			if (this.store.state.shown?.found !== shown.found) return true;
			return this.failed(error, several && !this.singly);
		}
	}
	failed(error, several) {
		if (error instanceof Cancelled) return false;
		if (error instanceof CallError && error.ended && this.failures < MOST_FAILURES) {
			this.failures += 1;
			return true;
		}
		this.failures = 0;
		this.singly = several;
		if (!several) this.store.dispatch({
			type: "editRefused",
			reason: sentence(messageOf(error))
		});
		return true;
	}
};
// www/block/state/joining.ts
function placesOf$4({ observations }) {
	return observations.filter(({ part }) => part !== "rejected_by_hand").map(({ image, x_px, y_px, by_hand }) => ({
		image,
		x_px,
		y_px,
		by: by_hand ? "hand" : "least_squares"
	}));
}
var ONE_PLACE_PX = 5;
function apart$1(points) {
	let farthest = null;
	const seen = new Map();
	for (const point of points) for (const { image, x_px, y_px } of placesOf$4(point)) {
		const others = seen.get(image) ?? [];
		for (const [x, y] of others) {
			const px = Math.hypot(x - x_px, y - y_px);
			if (px > (farthest?.px ?? ONE_PLACE_PX)) farthest = {
				image,
				px
			};
		}
		seen.set(image, [...others, [x_px, y_px]]);
	}
	return farthest;
}
function joined(points) {
	const [first, ...others] = [...points].sort((a, b) => rank(b) - rank(a));
	if (first?.id == null || others.length === 0 || others.some(isSurveyed)) return null;
	const rejected = (isSurveyed(first) ? others : [first, ...others]).flatMap(({ id }) => id ?? []);
	const places = new Map();
	for (const point of [first, ...others]) for (const place of placesOf$4(point)) if (!places.has(place.image)) places.set(place.image, place);
	const reject = {
		kind: "reject_points",
		points: rejected
	};
	if (!isSurveyed(first)) return places.size < 2 ? null : [reject, {
		kind: "add_point",
		observations: [...places.values()]
	}];
	const { id } = first;
	const own = new Set(first.observations.map(({ image }) => image));
	const measured = [...places.values()].filter(({ image }) => !own.has(image));
	return measured.length === 0 ? null : [reject, ...measured.map((place) => ({
		kind: "measure",
		point: id,
		...place
	}))];
}
function isSurveyed({ id }) {
	return id !== null && "ground_control" in id;
}
function rank(point) {
	return isSurveyed(point) ? Infinity : placesOf$4(point).length;
}
function split(point, images) {
	if (point.id === null || isSurveyed(point)) return null;
	const places = placesOf$4(point);
	const [within, beside] = [true, false].map((is) => places.filter(({ image }) => images.includes(image) === is));
	if (within === void 0 || beside === void 0 || within.length < 2 || beside.length < 2) return null;
	return [
		{
			kind: "reject_points",
			points: [point.id]
		},
		{
			kind: "add_point",
			observations: beside
		},
		{
			kind: "add_point",
			observations: within
		}
	];
}
// www/block/state/judged.ts
function judgedOf({ role, difference_m: difference, standard_errors_m: errors, left_out: leftOut }) {
	return role === "control" && leftOut !== void 0 ? {
		isLeftOut: true,
		difference: leftOut.difference,
		errors: leftOut.standard_errors
	} : {
		isLeftOut: false,
		difference,
		errors
	};
}
function ratioOf({ difference, errors }, axis) {
	const error = errors[axis] ?? NaN;
	return error > 0 ? (difference[axis] ?? NaN) / error : NaN;
}
function planOf({ difference: [x = NaN, y = NaN], errors: [sx, sy] }) {
	const length = Math.hypot(x, y);
	const [ex, ey] = [sx ?? NaN, sy ?? NaN];
	return {
		length,
		error: length > 0 ? Math.hypot(x * ex, y * ey) / length : Math.max(ex, ey)
	};
}
// www/block/state/columns.ts
var NO_ROWS = {
	count: 0,
	columns: []
};
var moreOn = ({ more }, axis) => axis < 2 ? more : 0;
function helpOf({ name }, axis, own) {
	return name === "" ? own : say("coordinate-in-system", {
		axis,
		name
	});
}
function imageRows(view) {
	const { images, leftOut, cameras } = view;
	const system = resultSystem(view);
	const axis = (key, i) => numbers(key, headOf(system, key), unitOn(system, i), 2 + moreOn(system, i), (row) => imageCoordinates(view)[3 * row + i], helpOf(system, key, say("projection-centre-in-m-where", { key })));
	return {
		count: images.length + leftOut.length,
		columns: [
			words("name", say("image-2"), (i) => images[i]?.name ?? leftOut[i - images.length]?.name ?? "", say("file-name-press-it-to")),
			numbers("number", say("no"), "", 0, (i) => i < images.length ? i + 1 : NaN, say("row-and-column-in-the")),
			numbers("features", say("features"), "", 0, (i) => images[i]?.features, say("points-detected-and-described"), { total: "sum" }),
			numbers("rays", say("obs"), "", 0, (i) => images[i]?.rays, say("observations-of-selected-tie-points"), { total: "sum" }),
			numbers("places", say("cov"), "", 0, (i) => images[i]?.places, say("coverage-how-many-of-the"), { total: "mean" }),
			numbers("rmse", "RMSE", "px", 2, (i) => images[i]?.rmsePx, say("root-mean-square-length-of-the"), { total: "rms" }),
			...cameras.length > 1 ? [numbers("camera", say("camera"), "", 0, (i) => (images[i]?.camera ?? NaN) + 1, say("images-of-one-camera-are", { join: cameras.map(({ label }, c) => `${String(c + 1)} ${label}`).join("; ") }))] : [],
			words("state", say("state"), (i) => stateOf(i < images.length ? images[i]?.why : leftOut[i - images.length]?.reason), say("whether-the-image-is-oriented")),
			axis("X", 0),
			axis("Y", 1),
			axis("Z", 2)
		]
	};
}
function stateOf(why) {
	return why === "" ? say("oriented") : why ?? say("not-oriented-yet");
}
function pairRows({ images, connections }) {
	const name = (row, side) => images[connections[row]?.images[side] ?? -1]?.name ?? "";
	const matches = (row) => {
		const connection = connections[row];
		return connection?.outcome.kind === "connected" ? matchesOf$1(connection) : NaN;
	};
	const outcome = (row) => connections[row] === void 0 ? "" : outcomeText(connections[row]);
	return {
		count: connections.length,
		columns: [
			words("first", say("image-2"), (i) => name(i, 0), say("the-image-of-the-pair")),
			words("second", say("with"), (i) => name(i, 1), say("the-other-image-of-the")),
			numbers("matches", say("matches-2"), "", 0, matches, say("verified-matches-of-a-connected"), { total: "sum" }),
			numbers("shared", say("common"), "", 0, (i) => connections[i]?.shared, say("tie-points-that-both-images"), { total: "sum" }),
			numbers("chosen", say("selected"), "", 0, (i) => connections[i]?.chosen, say("of-them-those-that-were"), { total: "sum" }),
			words("geometry", say("geometry-2"), (i) => geometryText(connections[i]?.geometry ?? null), say("what-relates-the-two-views")),
			words("reason", say("outcome"), outcome, say("why-the-images-are-connected"))
		]
	};
}
function pointRows(view) {
	const { points } = view;
	const system = resultSystem(view);
	const unit = unitOf(view);
	const axis = (label, offset) => [numbers(label.toLowerCase(), headOf(system, label), unitOn(system, offset), 2 + moreOn(system, offset), (i) => pointCoordinates(view)[3 * i + offset] ?? NaN, helpOf(system, label, say("object-coordinate-in-m-where"))), numbers(`sigma-${label.toLowerCase()}`, `σ ${label}`, unit, 3, (i) => points.errors[3 * i + offset] ?? NaN, say("standard-error-of-from-the", { label }), { total: "rms" })];
	const parts = points.count === points.taking ? [] : [{
		label: say("accepted"),
		has: (row) => row < points.taking
	}];
	const kindOf = (point) => KINDS[surveyedAt(view, point)?.role ?? "tie"];
	return {
		count: points.count,
		columns: [
			pointColumn(view, "point", (i) => i, say("number-of-the-point-press")),
			...view.surveyed.length === 0 ? [] : [words("point-kind", say("kind"), kindOf, say("tie-point-or-control"))],
			numbers("point-rays", say("rays-2"), "", 0, (i) => points.rays[i] ?? NaN, say("observations-of-the-point"), { total: "mean" }),
			numbers("point-rmse", "RMSE", "px", 2, (i) => points.rmsePx[i] ?? NaN, say("root-mean-square-length-of-the"), { total: "rms" }),
			...axis("X", 0),
			...axis("Y", 1),
			...axis("Z", 2),
			numbers("confidence", say("probability"), "", 3, (i) => points.confidence[i] ?? NaN, say("probability-that-all-its-observations"), { total: "mean" }),
			{
				...words("point-part", say("part"), (i) => partOfPoint(points, i), say("whether-the-point-takes-part")),
				parts
			}
		]
	};
}
function partOfPoint({ taking, lost }, point) {
	if (point < taking) return say("accepted");
	return say(lost.has(point) ? "too-few-rays" : "rejected-by-hand-2");
}
var KINDS = {
	tie: say("tie-point-2"),
	control: say("control-point"),
	check: say("check-point")
};
var NO_COORDINATES = new Map();
var SAME_COORDINATE = .001;
function surveyedRows(view, given, asGiven = NO_COORDINATES) {
	const { surveyed } = view;
	const axes = [
		"X",
		"Y",
		"Z"
	];
	const system = resultSystem(view);
	const within = system.name === "" ? 0 : SAME_COORDINATE;
	const differs = (value, other) => !(Math.abs(value - (other ?? NaN)) <= within);
	const own = surveyedCoordinates(view);
	const places = given.map(({ place }) => place === null ? null : system.coordinates(Float64Array.from(place)));
	const isOther = (row, name) => asGiven.get(name)?.some((value, k) => differs(value, own[3 * row + k])) === true;
	const areOthers = given.some(({ position }, i) => places[i] == null || position.some((value, k) => differs(value, places[i]?.[k]))) || surveyed.some(({ name }, row) => isOther(row, name));
	const judged = surveyed.map(judgedOf);
	const parts = ["control", "check"].map((role) => ({
		label: roleText(role),
		has: (row) => surveyed[row]?.isUsed === true && surveyed[row].role === role
	}));
	const beside = (row) => given[row - surveyed.length];
	const useText = (row) => {
		const own = beside(row);
		const use = own === void 0 ? surveyed[row]?.isUsed === false ? say("not-used") : roleText(surveyed[row]?.role) : givenUse(own);
		return (own ?? surveyed[row])?.byHand === true ? say("use-by-hand", { use }) : use;
	};
	return {
		count: surveyed.length + given.length,
		columns: [
			words("surveyed", say("point"), (i) => surveyed[i]?.name ?? beside(i)?.name ?? "", say("name-of-the-surveyed-point")),
			{
				...words("use", say("use"), useText, say("control-points-place-the-block")),
				parts
			},
			numbers("surveyed-rays", say("rays-2"), "", 0, (i) => surveyed[i]?.rays ?? NaN, say("image-measurements-that-took-part"), { total: "sum" }),
			...areOthers ? axes.map((axis, k) => numbers(`given-${axis}`, say("as-given", { axis }), "", 3, (i) => beside(i)?.position[k] ?? asGiven.get(surveyed[i]?.name ?? "")?.[k] ?? NaN, say("in-the-unit-and-the", { axis }))) : [],
			...axes.map((axis, k) => numbers(`surveyed-${axis}`, headOf(system, axis), system.name === "" ? "m" : unitOn(system, k), 3 + moreOn(system, k), (i) => (i < surveyed.length ? own[3 * i + k] : places[i - surveyed.length]?.[k]) ?? NaN, helpOf(system, axis, say("surveyed-in-the-system-of", { axis })))),
			...axes.map((axis, k) => numbers(`difference-${axis}`, `Δ${axis}`, "m", 3, (i) => surveyed[i]?.difference_m[k] ?? NaN, say("adjusted-minus-surveyed", { axis }), { total: "rms" })),
			...axes.map((axis, k) => numbers(`difference-sigma-${axis}`, `σ Δ${axis}`, "m", 3, (i) => surveyed[i]?.standard_errors_m[k], say("standard-error-of", { axis }), { total: "rms" })),
			...axes.map((axis, k) => numbers(`difference-ratio-${axis}`, `Δ/σ ${axis}`, "", 1, (i) => judged[i] && ratioOf(judged[i], k), say("difference-by-standard-error", { axis }), { total: "rms" })),
			...axes.map((axis, k) => numbers(`left-out-${axis}`, say("difference-left-out", { axis }), "m", 3, (i) => surveyed[i]?.left_out?.difference[k], say("where-the-other-observations-have", { axis }), { total: "rms" })),
			...axes.map((axis, k) => numbers(`left-out-sigma-${axis}`, say("standard-error-left-out", { axis }), "m", 3, (i) => surveyed[i]?.left_out?.standard_errors[k], say("standard-error-of-where-the", { axis }), { total: "rms" }))
		]
	};
}
function roleText(role) {
	return role === void 0 ? "" : say("role", { role });
}
var AXES = ["x", "y"];
var PARTS$1 = [
	say("accepted"),
	say("rejected-2"),
	say("rejected-by-hand-2")
];
var observationRows = remember((view, of) => {
	const { images, points } = view;
	const parts = PARTS$1.map((label, part) => ({
		label,
		has: (row) => of.parts[row] === part
	}));
	const residual = (row) => Math.hypot(of.residuals[2 * row] ?? NaN, of.residuals[2 * row + 1] ?? NaN);
	return {
		count: of.points.length,
		columns: [
			{
				...words("observation-image", say("image-2"), (i) => images[of.images[i] ?? -1]?.name ?? "", say("the-image-that-shows-the")),
				parts
			},
			pointColumn(view, "observation-point", (i) => of.points[i], say("number-of-the-point")),
			numbers("observation-x", "x", "px", 2, (i) => of.places[2 * i] ?? NaN, say("column-the-centre-of-the")),
			numbers("observation-y", "y", "px", 2, (i) => of.places[2 * i + 1] ?? NaN, say("row")),
			numbers("observation-vx", "vx", "px", 2, (i) => of.residuals[2 * i] ?? NaN, say("residual-in-x-observed-minus"), { total: "rms" }),
			numbers("observation-vy", "vy", "px", 2, (i) => of.residuals[2 * i + 1] ?? NaN, say("residual-in-y-observed-minus"), { total: "rms" }),
			numbers("observation-v", say("residual"), "px", 2, residual, say("length-of-the-residual"), { total: "rms" }),
			numbers("observation-rays", say("rays-2"), "", 0, (i) => points.rays[of.points[i] ?? -1] ?? NaN, say("observations-of-the-point")),
			...AXES.flatMap((axis, k) => [
				numbers(`observation-r${axis}`, `r ${axis}`, "", 2, (i) => of.redundancy[2 * i + k] ?? NaN, say("redundancy-number-of-an-observation", { axis }), { total: "mean" }),
				numbers(`observation-w${axis}`, `w ${axis}`, "", 2, (i) => of.w[2 * i + k] ?? NaN, say("w-statistic-of-an-observation", { axis }), { total: "rms" }),
				numbers(`observation-mdb${axis}`, `MDB ${axis}`, "px", 2, (i) => of.detectable[2 * i + k] ?? NaN, say("mdb-of-an-observation", { axis }))
			]),
			words("observation-part", say("part"), (i) => PARTS$1[of.parts[i] ?? 0] ?? "", say("whether-the-adjustment-accepted-the"))
		]
	};
});
function observationsOf(of, choice) {
	if (choice === null) return () => true;
	if (choice.kind === "image" || choice.kind === "images") {
		const images = new Set(imagesOf(choice));
		return (row) => images.has(of.images[row] ?? -1);
	}
	if (choice.kind === "pair" || choice.kind === "pairs") {
		const seen = pairsOf(choice).map((pair) => ({
			pair,
			points: commonPoints(of, pair)
		}));
		return (row) => seen.some(({ pair, points }) => pair.includes(of.images[row] ?? -1) && points.has(of.points[row] ?? -1));
	}
	const points = new Set(pointsOf(choice));
	return (row) => points.has(of.points[row] ?? -1);
}
function commonPoints({ images, points }, [a, b]) {
	const first = new Set(points.filter((_, row) => images[row] === a));
	return new Set(points.filter((point, row) => images[row] === b && first.has(point)));
}
var COLUMNS$1 = {
	images: imageRows,
	pairs: pairRows,
	points: pointRows,
	surveyed: surveyedRows
};
var ofView = {
	images: remember(imageRows),
	pairs: remember(pairRows),
	points: remember(pointRows)
};
var withGiven = remember(surveyedRows);
function rowsOf(subject, { view, given, asGiven }) {
	return subject === "surveyed" ? withGiven(view, given, asGiven) : ofView[subject](view);
}
function choiceOfRow(subject, { view, given }, row) {
	if (subject === "images") return row < view.images.length ? {
		kind: "image",
		image: row
	} : null;
	if (subject === "points") return {
		kind: "point",
		point: row
	};
	if (subject === "surveyed") {
		const beside = given[row - view.surveyed.length];
		if (beside !== void 0) return {
			kind: "given",
			name: beside.name
		};
		return (view.surveyed[row]?.point ?? -1) < 0 ? null : {
			kind: "point",
			point: view.surveyed[row]?.point ?? -1
		};
	}
	const images = subject === "pairs" ? view.connections[row]?.images : void 0;
	return images === void 0 ? null : {
		kind: "pair",
		images
	};
}
function rowsOfChoice(subject, { view, given }, choice) {
	if (subject === "points") return pointsOf(choice);
	if (subject === "surveyed") {
		if (choice?.kind === "given") return Uint32Array.from(given.flatMap(({ name }, i) => name === choice.name ? [view.surveyed.length + i] : []));
		const points = new Set(pointsOf(choice));
		return Uint32Array.from(view.surveyed.flatMap(({ point }, row) => points.has(point) ? [row] : []));
	}
	if (subject === "images") return Uint32Array.from(imagesOf(choice));
	if (subject !== "pairs") return new Uint32Array();
	const pairs = new Set(pairsOf(choice).map(keyOfPair));
	return Uint32Array.from(view.connections.flatMap(({ images }, row) => pairs.has(keyOfPair(images)) ? [row] : []));
}
var EMPTY = {};
function kept(subject, view, filter) {
	const { count: rows, columns } = COLUMNS$1[subject](view, []);
	return maskOf$1(rows, columns, filter);
}
function testOf(subject) {
	return remember((view, own, ofImages) => {
		const mask = kept(subject, view, own);
		const images = subject === "pairs" ? kept("images", view, ofImages) : null;
		if (mask === null && images === null) return () => true;
		const keeps = (row) => mask === null || mask[row] === 1;
		return images === null ? keeps : (row) => keeps(row) && view.connections[row]?.images.every((image) => images[image] === 1) === true;
	});
}
var TESTS = {
	images: testOf("images"),
	pairs: testOf("pairs"),
	points: testOf("points"),
	surveyed: testOf("surveyed")
};
function keptBy(subject, view, { filters }) {
	return TESTS[subject](view, filters[subject] ?? EMPTY, subject === "pairs" ? filters.images ?? EMPTY : EMPTY);
}
// www/block/state/listed.ts
var places$2 = remember(({ connections }) => new Map(connections.map(({ images }, row) => [keyOfPair(images), row])));
function keepsPair(view, filters) {
	const keeps = keptBy("pairs", view, { filters });
	return (pair) => keeps(places$2(view).get(keyOfPair(pair)) ?? -1);
}
function keepsObservation(view, filters, of) {
	const { observations: filter = {} } = filters;
	if (Object.keys(filter).length === 0) return () => true;
	const meets = of === null ? () => false : keeping(observationRows(view, of).columns, filter);
	if (of === null || meets === null) return meets ?? (() => true);
	return among(observationsKept(of, meets));
}
var listed = remember((view, chosen, filters, observations) => {
	const of = (all, keeps, choiceOf) => {
		const [every, kept] = [[...all], []];
		for (const one of every) if (keeps(one)) kept.push(one);
		const others = every.length - kept.length;
		return {
			choice: others === 0 ? chosen : choiceOf(kept),
			others
		};
	};
	switch (chosen?.kind) {
		case "points": return of(chosen.points, keptBy("points", view, { filters }), choiceOfPoints);
		case "images": return of(chosen.images, keptBy("images", view, { filters }), choiceOfImages);
		case "pairs": return of(chosen.pairs, keepsPair(view, filters), choiceOfPairs);
		case "observations": {
			const keeps = keepsObservation(view, filters, observations);
			const kept = observationsKept(chosen, (i) => keeps(chosen.points[i] ?? -1, chosen.images[i] ?? -1));
			const others = chosen.points.length - kept.points.length;
			return {
				choice: others === 0 ? chosen : choiceOfObservations(kept),
				others
			};
		}
		default: return {
			choice: chosen,
			others: 0
		};
	}
});
function listedChoice({ chosen, filters }, view, observations) {
	return listed(view, chosen, filters, chosen?.kind === "observations" ? observations() : null);
}
// www/block/state/timeline.ts
var timeline = remember((history, marks) => {
	const steps = [];
	let next = 0;
	const editsUpTo = (end) => {
		for (; next < Math.min(end, history.edits.length); next += 1) steps.push({
			of: "edits",
			at: next
		});
	};
	marks.edits.forEach(({ after }, at) => {
		editsUpTo(after);
		steps.push({
			of: "marks",
			at
		});
	});
	editsUpTo(Infinity);
	const holds = ({ of, at }) => at < (of === "edits" ? history : marks).done;
	return {
		edits: [...steps.filter(holds), ...steps.filter((step) => !holds(step))],
		done: history.done + marks.done
	};
});
function timelineOf({ history, marks }) {
	return timeline(history, marks);
}
function heldAt(both, place) {
	const first = timelineOf(both).edits.slice(0, Math.max(0, place));
	const marks = first.filter(({ of }) => of === "marks").length;
	return {
		edits: first.length - marks,
		marks
	};
}
// www/block/panel/edits.ts
function chosenOf({ selection, shown }, facts) {
	return shown === null ? null : listedChoice(selection, shown.view, () => facts.observations()).choice;
}
function editOf(state, facts, kind, whole = false) {
	const { shown } = state;
	return shown === null ? null : editOfChoice(kind, chosenOf(state, facts), shown.view, standingOf(shown.edits), whole);
}
function makeEdit(store, edit) {
	if (edit === null) return;
	if (store.state.running.kind === "yes") store.dispatch({
		type: "notice",
		notice: {
			kind: "info",
			text: say("edits-wait-for-the-run"),
			beside: true
		}
	});
	else store.dispatch({
		type: "edit",
		edits: [edit]
	});
}
function stepBy(store, by) {
	if (store.state.draft !== null) {
		if (by < 0) store.dispatch({
			type: "draft",
			draft: withoutLast(store.state.draft)
		});
		return;
	}
	goTo(store, heldAt(store.state, timelineOf(store.state).done + by));
}
function goTo(store, { edits, marks: steps }) {
	const { state } = store;
	if (edits !== state.history.done && !isEditable(state)) return;
	if ((removesOthers(state.marks, {
		...state.marks,
		done: steps
	}) || framesOthers(state.marks, steps)) && isBusy(state)) {
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: say("edits-wait-for-the-run"),
				beside: true
			}
		});
		return;
	}
	if (edits !== state.history.done) store.dispatch({
		type: "goto",
		done: edits
	});
	if (steps !== state.marks.done) store.dispatch({
		type: "gotoMark",
		done: steps
	});
}
function nameOfTimed({ history, marks }, { of, at }, names) {
	const [edit, mark] = [history.edits[at], marks.edits[at]];
	if (of === "edits") return edit === void 0 ? "" : nameOfStep(edit, names);
	return mark === void 0 ? "" : nameOfMarks(mark);
}
function namesIn({ shown, history }) {
	return shown === null ? NO_NAMES : namedIn(shown.found, history.edits);
}
var namedIn = remember((found, steps) => {
	const names = namesOf$2(found);
	const added = [...addedPoints(steps.flat(), found.givenControl).values()].map(({ edit, control }) => [control, edit.name]);
	return added.length === 0 ? names : {
		...names,
		surveyed: new Map([...names.surveyed, ...added])
	};
});
// www/block/state/lacks.ts
var lackOfBlock = ({ shown }) => shown === null ? say("needs-a-block") : "";
var lackOfImages = ({ files }) => files.length === 0 ? say("needs-images") : "";
var lackOfOrthophoto = ({ placing }) => placing.orthophoto === null ? say("needs-an-orthophoto") : "";
// www/block/panel/edit-bar.ts
function makeStep(store, edits) {
	if (edits !== null) store.dispatch({
		type: "edit",
		edits
	});
}
var MOST_JOINED = 8;
function toJoin(state, facts) {
	const { shown } = state;
	const chosen = chosenOf(state, facts);
	const points = chosen?.kind === "points" ? chosen.points : pointsOf(null);
	if (shown === null || points.length < 2 || points.length > MOST_JOINED || points.some((point) => point >= shown.view.points.taking)) return null;
	const details = [...points].flatMap((point) => facts.point(point) ?? []);
	return details.length < points.length || joined(details) === null ? null : details;
}
function join(store, facts) {
	const points = toJoin(store.state, facts);
	if (points === null) return;
	const far = apart$1(points);
	if (far === null) {
		makeStep(store, joined(points));
		return;
	}
	const image = store.state.shown?.view.images[far.image]?.name ?? "";
	store.dispatch({
		type: "notice",
		notice: {
			kind: "problem",
			text: say("not-joined", {
				image,
				px: fixed(far.px, 0)
			}),
			beside: true
		}
	});
}
function splitOf({ selection, shown, panes }, facts) {
	const [point, ...more] = pointsOf(selection.chosen);
	if (shown === null || point === void 0 || more.length > 0 || point >= shown.view.points.taking) return null;
	const detail = facts.point(point);
	return detail === null ? null : split(detail, shownImages(panes, shown.view));
}
function removalOf(state, facts) {
	const { files, shown, history } = state;
	const out = removable(files, chosenOf(state, facts), shown?.view.images ?? []);
	return out.length === 0 ? null : {
		kind: "remove_images",
		files: out.map(({ id }) => id),
		after: history.done
	};
}
function removeImages(store, facts) {
	const step = removalOf(store.state, facts);
	if (step !== null) store.dispatch({
		type: "mark",
		step
	});
}
function addedIn({ shown, history }) {
	return addedPoints(editsInForce(history), shown?.view.givenControl ?? 0);
}
function titleOf$1(edit, otherwise, names) {
	return capital(edit === null ? otherwise : nameOfEdit(edit, names)).replace(/ 1 /u, " ");
}
function capital(name) {
	return name.charAt(0).toUpperCase() + name.slice(1);
}
function mountEditBar(store, facts, measures) {
	const undo = button(say("undo-sign"), "block-undo", () => stepBy(store, -1));
	const redo = button(say("redo-sign"), "block-redo", () => stepBy(store, 1));
	const reject = button(say("reject"), "block-reject", () => makeEdit(store, editOf(store.state, facts, "reject")), say("take-what-is-chosen-out"));
	const whole = button(say("reject-point"), "block-reject-point", () => makeEdit(store, editOf(store.state, facts, "reject", true)), say("take-the-point-with-all"));
	const restore = button(say("restore"), "block-restore", () => makeEdit(store, editOf(store.state, facts, "restore")), say("use-what-is-chosen-again"));
	const remove = button(say("remove-image"), "block-remove-image", () => removeImages(store, facts), say("take-the-chosen-image-out"));
	const measure = button(say("measure-it"), "block-measure", () => {
		if (store.state.onStage !== "images") store.dispatch({
			type: "stage",
			view: "images"
		});
		measures()?.toggle(false);
		toImages();
	}, say("measure-the-chosen-point-in"));
	const add = button(say("add-point"), "block-add-point", () => {
		measures()?.toggle(true);
		toImages();
	}, say("measure-a-new-tie-point"));
	const joining = button(say("join"), "block-join", () => join(store, facts), say("the-chosen-points-are-one"));
	const parting = button(say("split"), "block-split", () => makeStep(store, splitOf(store.state, facts)), say("the-point-is-two-one"));
	const match = button(say("match-it"), "block-match", () => {
		measures()?.match();
		toImages();
	}, say("match-the-point-in-the"));
	const alone = button(say("match-here"), "block-match-alone", () => {
		measures()?.matchAlone();
		toImages();
	}, say("match-the-point-here"));
	const accept = button(say("accept"), "block-accept", () => store.dispatch({
		type: "accept",
		leaves: false
	}), say("the-point-is-measured-enter"));
	const leave = button(say("cancel"), "block-leave", () => store.dispatch({
		type: "draft",
		draft: null
	}), say("give-what-is-measured-up"));
	const [use, useSelect] = choice(say("use-as"), "block-use", USES, (value) => {
		const surveyed = surveyedChoice(store.state, facts);
		const role = value === "control" || value === "check" ? value : null;
		if (surveyed !== null) makeEdit(store, {
			kind: "set_use",
			point: surveyed.point,
			use: role
		});
	});
	const notListed = new NotListed("block-not-listed", [
		reject,
		restore,
		remove
	]);
	const text = h("span", {
		class: "edit-text",
		testid: "block-edit-text",
		role: "status",
		aria: { live: "polite" }
	});
	const bar = h("div", {
		class: "toolbar edit-bar",
		testid: "block-edit-bar",
		role: "toolbar",
		aria: { label: say("edits-by-hand") }
	}, ...[
		undo,
		redo,
		reject,
		whole,
		restore,
		remove,
		notListed.element,
		joining,
		parting,
		measure,
		add,
		match,
		alone,
		accept,
		leave,
		use,
		text
	]);
	for (const [made, lack] of [
		[reject, say("nothing-to-reject-is-chosen")],
		[whole, say("no-point-is-chosen")],
		[restore, say("nothing-rejected-is-chosen")],
		[remove, say("no-chosen-image")],
		[joining, say("no-points-to-join")],
		[parting, say("no-point-to-split")],
		[measure, say("no-point-is-chosen")],
		[match, say("no-point-is-chosen")],
		[alone, say("no-point-is-chosen")]
	]) declareLack([made], () => lackOfBlock(store.state) || lack);
	declareLack([accept, leave], () => store.state.draft === null ? say("nothing-is-measured") : "");
	declarePlace([measure, add], {
		title: say("images-2"),
		show: () => store.dispatch({
			type: "stage",
			view: "images"
		}),
		can: () => isEditable(store.state) && store.state.onStage !== "images" && store.state.draft === null
	});
	const counterparts = new Map([
		[reject, [restore]],
		[whole, [restore]],
		[restore, [reject]],
		[undo, [redo]],
		[redo, [undo]]
	]);
	const show = () => {
		const { state } = store;
		const held = bar.contains(document.activeElement) ? document.activeElement : null;
		const { chosen } = state.selection;
		bar.hidden = !isEditable(state);
		const names = namesIn(state);
		if (state.draft === null) showSteps(undo, redo, timelineOf(state), (one) => nameOfTimed(state, one, names));
		else showSteps(undo, redo, placesAsSteps(state.draft), (image) => say("step-place-in", { image: state.shown?.view.images[image]?.name ?? "" }));
		const [off, point, on] = [
			editOf(state, facts, "reject"),
			editOf(state, facts, "reject", true),
			editOf(state, facts, "restore")
		];
		const drafting = state.draft !== null;
		set(reject, titleOf$1(off, say("reject"), NO_NAMES), off === null);
		set(restore, titleOf$1(on, say("restore"), NO_NAMES), on === null);
		reject.hidden = drafting || off === null && on !== null;
		restore.hidden = drafting || on === null;
		whole.hidden = drafting || chosen?.kind !== "observation" || point === null;
		const removal = removalOf(state, facts);
		remove.hidden = drafting || removal === null;
		set(remove, removal === null || removal.files.length === 1 ? say("remove-image") : capital(nameOfMarks(removal)), false);
		notListed.show(state.shown === null || drafting ? 0 : listedChoice(state.selection, state.shown.view, () => facts.observations()).others);
		const inImages = state.onStage === "images";
		const given = chosen?.kind === "given";
		measure.hidden = drafting || !(inImages || given);
		const isPoint = chosen?.kind === "point" || chosen?.kind === "observation";
		measure.disabled = !given && !(isPoint && state.shown !== null && isMeasurable(state.shown.view, chosen.point));
		add.hidden = drafting || !inImages;
		joining.hidden = drafting || toJoin(state, facts) === null;
		parting.hidden = drafting || !inImages || splitOf(state, facts) === null;
		match.hidden = !inImages || (measure.disabled || given) && !drafting;
		alone.hidden = match.hidden || state.shown === null || shownImages(state.panes, state.shown.view).length < 2;
		accept.hidden = !drafting;
		accept.disabled = state.draft === null || stepOfDraft(state.draft, state.shown?.view.images.map(({ name }) => name) ?? [], state.history.done, addedIn(state)) === null;
		leave.hidden = !drafting;
		const said = textOf(state);
		if (text.textContent !== said) text.textContent = said;
		const surveyed = surveyedChoice(state, facts);
		use.hidden = surveyed === null || drafting;
		if (surveyed !== null) useSelect.value = surveyed.role ?? "";
		passFocus(held, [
			...counterparts.get(held) ?? [],
			measure,
			add,
			undo,
			redo,
			byId("block-view")
		]);
	};
	store.watch([
		"history",
		"marks",
		"files",
		"selection",
		"shown",
		"running",
		"adjusting",
		"before",
		"draft",
		"onStage",
		"panes"
	], show);
	facts.watch(show);
	return bar;
}
var toImages = () => byId("block-view").focus({ preventScroll: true });
var USES = [
	["control", say("control-point")],
	["check", say("check-point")],
	["", say("not-used")]
];
function surveyedChoice({ selection }, facts) {
	const [point, ...more] = pointsOf(selection.chosen);
	const detail = point === void 0 || more.length > 0 ? null : facts.point(point);
	return detail?.id != null && "ground_control" in detail.id ? {
		point: detail.id.ground_control,
		role: detail.role
	} : null;
}
function unplacedText({ of }, { shown, options }) {
	const point = isGiven(of) ? shown?.given.find(({ name }) => name === of.given) : void 0;
	if (shown === null || point === void 0 || point.place !== null || point.images > 0) return "";
	return say("where-it-lies-is-not-known", { by: shown.view.origin !== null && options.settings?.placing.crs == null ? "system" : "points" });
}
function textOf(state) {
	const { draft, adjusting, before, shown } = state;
	if (draft !== null) {
		const placed = draft.places.size;
		const what = shown === null ? "" : nameOfDraft(draft, shown.view);
		const more = draft.of === null && placed < 2 ? say("two-images-or-more-are") : placed === 0 ? unplacedText(draft, state) : "";
		return say("placed-in-press-its-place", {
			what,
			placed,
			more
		});
	}
	if (adjusting) return say("adjusting-the-block");
	if (before === null || shown === null || shown.edits.length === 0) return "";
	return comparedText(before, figuresOf$3(shown.view));
}
// www/block/state/under.ts
var SAME = {
	a: 1,
	b: 0,
	c: 0,
	d: 1,
	e: 0,
	f: 0
};
function affineOf({ origin, by_column: column, by_row: row }) {
	return {
		a: column[0],
		b: column[1],
		c: row[0],
		d: row[1],
		e: origin[0],
		f: origin[1]
	};
}
function after(outer, inner) {
	const [a, b] = mapped({
		...outer,
		e: 0,
		f: 0
	}, inner.a, inner.b);
	const [c, d] = mapped({
		...outer,
		e: 0,
		f: 0
	}, inner.c, inner.d);
	const [e, f] = mapped(outer, inner.e, inner.f);
	return {
		a,
		b,
		c,
		d,
		e,
		f
	};
}
function scaleOf({ a, b, c, d }) {
	return Math.sqrt(Math.abs(a * d - b * c));
}
function similarity(from, to) {
	if (from.length < 2 || from.length !== to.length) return null;
	const [fx, fy] = middle(from);
	const [tx, ty] = middle(to);
	let [along, across, size] = [
		0,
		0,
		0
	];
	from.forEach(([x, y], i) => {
		const [u, v] = [x - fx, y - fy];
		const [p, q] = [(to[i]?.[0] ?? 0) - tx, (to[i]?.[1] ?? 0) - ty];
		along += u * p + v * q;
		across += u * q - v * p;
		size += u * u + v * v;
	});
	if (!(size > 0)) return null;
	const [a, b] = [along / size, across / size];
	if (!(Math.hypot(a, b) > 0)) return null;
	const turned = {
		a,
		b,
		c: -b,
		d: a,
		e: 0,
		f: 0
	};
	const [x, y] = mapped(turned, fx, fy);
	return {
		...turned,
		e: tx - x,
		f: ty - y
	};
}
function affine(from, to) {
	const place = (i) => [
		from[i]?.[0] ?? NaN,
		from[i]?.[1] ?? NaN,
		to[i]?.[0] ?? NaN,
		to[i]?.[1] ?? NaN
	];
	const map = from.length < 3 || from.length !== to.length ? null : fitted(from.length, place, ON_A_LINE);
	return map !== null && Math.abs(map.a * map.d - map.b * map.c) > 0 ? map : similarity(from, to);
}
var ON_A_LINE = 1e-9;
function departure(by, from, to) {
	return from.reduce((most, [x, y], i) => {
		const [u, v] = mapped(by, x, y);
		return Math.max(most, Math.hypot(u - (to[i]?.[0] ?? NaN), v - (to[i]?.[1] ?? NaN)));
	}, 0);
}
function middle(places) {
	const sum = places.reduce(([x, y], [px, py]) => [x + px, y + py], [0, 0]);
	return [(sum[0] ?? 0) / places.length, (sum[1] ?? 0) / places.length];
}
// www/block/state/between.ts
var MOST_PIXELS = 3;
var MOST_SHARE = .001;
var ENOUGH = 4e3;
var BEYOND$1 = .02;
function crsOf({ epsg, described }, chosen) {
	if (epsg !== null) return `EPSG:${String(epsg)}`;
	return (described ?? null) === null ? chosen : null;
}
var betweenSystems = remember((orthophoto, view) => {
	const { origin } = view;
	const crs = crsOf(orthophoto.info, view.crs);
	const places = placesOf$3(view);
	if (origin === null || crs === null || places === null) return null;
	const { from, height } = places;
	try {
		const local = from.flatMap(([x, y]) => [
			x,
			y,
			height
		]);
		const onEarth = geographic_positions(Float64Array.from([
			origin.longitude_deg,
			origin.latitude_deg,
			origin.height_m,
			...local
		]));
		const there = system_coordinates(crs, onEarth);
		return judged(orthophoto, crs, from, from.map((_, i) => [there[3 * i] ?? NaN, there[3 * i + 1] ?? NaN]));
	} catch (error) {
		return {
			kind: "problem",
			text: say("the-orthophoto-is-not-laid-under", { reason: messageOf(error) })
		};
	}
});
function judged({ info }, crs, from, to) {
	const toOrthophoto = to.every(([x, y]) => Number.isFinite(x + y)) ? affine(from, to) : null;
	if (toOrthophoto === null) return {
		kind: "problem",
		text: say("the-block-is-outside-the-system", { crs })
	};
	const unitsPerMetre = scaleOf(toOrthophoto);
	const most = departure(toOrthophoto, from, to) / unitsPerMetre;
	const limit = Math.max(MOST_PIXELS * info.gsd / unitsPerMetre, MOST_SHARE * Math.hypot(span(from, 0), span(from, 1)));
	const toPixels = inverse(affineOf(info.georeference));
	const pixels = to.map(([x, y]) => mapped(toPixels, x, y));
	return [0, 1].every((axis) => {
		const own = pixels.map((place) => place[axis]);
		return Math.max(...own) >= 0 && Math.min(...own) <= (axis === 0 ? info.width : info.height);
	}) ? {
		kind: "affine",
		toOrthophoto,
		crs,
		isNear: most <= limit
	} : {
		kind: "problem",
		text: say("the-orthophoto-lies-elsewhere", { crs })
	};
}
function span(places, axis) {
	const own = places.map((place) => place[axis]);
	return Math.max(...own) - Math.min(...own);
}
var groundOf = remember((view) => placesOf$3(view)?.height ?? 0);
function placesOf$3({ images, points }) {
	const centres = images.flatMap(({ position }) => position === null ? [] : [position]);
	const step = Math.ceil(points.taking / ENOUGH);
	const coordinates = [
		0,
		1,
		2
	].map((axis) => Float64Array.from({ length: Math.ceil(points.taking / step) || 0 }, (_, i) => points.positions[3 * step * i + axis] ?? NaN).filter((value) => !Number.isNaN(value)).sort());
	const at = (axis, share) => coordinates[axis]?.[Math.round(share * (coordinates[axis].length - 1))] ?? NaN;
	const height = at(2, .5);
	if (centres.length === 0 || Number.isNaN(height)) return null;
	const [columns, rows] = [0, 1].map((axis) => {
		const [low, high] = [
			...centres.map((centre) => centre[axis]),
			at(axis, BEYOND$1),
			at(axis, .98)
		].reduce(([least, largest], value) => [Math.min(least, value), Math.max(largest, value)], [Infinity, -Infinity]);
		return [
			low,
			(low + high) / 2,
			high
		];
	});
	return {
		from: (rows ?? []).flatMap((y) => (columns ?? []).map((x) => [x, y])),
		height
	};
}
// www/block/state/showing.ts
function blockOnOrthophoto(state) {
	const { shown, placing } = state;
	const { orthophoto } = placing;
	if (orthophoto === null || orthophoto.ofBlock !== null || shown === null || shown.view.partial) return null;
	if (!isInSystemOf(shown.view) || purposeOf(state) === "images") return null;
	const toOrthophoto = toSystemOf(orthophoto, shown.view);
	return toOrthophoto !== null && hasPlaceOn(orthophoto, shown.view, toOrthophoto) ? shown : null;
}
function isInSystemOf({ orthophoto }) {
	return orthophoto?.kind === "linked" || orthophoto?.kind === "by_hand";
}
function toSystemOf(orthophoto, view) {
	if (view.orthophoto?.inCrs !== true) return SAME;
	const between = betweenSystems(orthophoto, view);
	return between?.kind === "affine" && between.isNear ? between.toOrthophoto : null;
}
var hasPlaceOn = remember(({ info: { width, height, georeference } }, { surveyed }, toOrthophoto) => {
	const toPixels = inverse(affineOf(georeference));
	return surveyed.some(({ position: [x, y] }) => {
		const [column, row] = mapped(toPixels, ...mapped(toOrthophoto, x, y));
		return column >= 0 && row >= 0 && column <= width && row <= height;
	});
});
function chosenPlaced(state) {
	const { image } = state.placing.chosen;
	return image === null || blockOnOrthophoto(state) !== null ? null : placedFiles(state).find(({ file }) => file.id === image) ?? null;
}
// www/block/state/places.ts
function takesPlaces(state) {
	const { orthophoto } = state.placing;
	if (orthophoto === null || isLookedAtAlone(orthophoto) || orthophoto.ofBlock !== null || state.shown === null || state.shown.view.partial || state.shown.view.oriented === 0) return false;
	return blockOnOrthophoto(state) !== null || purposeOf(state) === "block";
}
// www/block/panel/edit-keys.ts
function hasSteps({ history, marks, draft }) {
	return history.edits.length + marks.edits.length > 0 || draft !== null;
}
function mountBlockEditKeys(store, facts, hosts) {
	const isBlockSeen = () => store.state.onStage !== "orthophoto" || blockOnOrthophoto(store.state) !== null || takesPlaces(store.state);
	undoKeys(() => byId("block-view").offsetParent !== null && hasSteps(store.state) && isBlockSeen(), (by) => stepBy(store, by));
	const idle = () => store.state.draft === null && isBlockSeen();
	const lack = (kind) => {
		const block = lackOfBlock(store.state);
		if (block !== "") return block;
		return editOf(store.state, facts, kind) === null ? say(kind === "reject" ? "nothing-to-reject-is-chosen" : "nothing-rejected-is-chosen") : "";
	};
	const list = [{
		keys: ["Delete", "Backspace"],
		does: say("rejects-what-is-chosen-with"),
		can: idle,
		lacks: () => lack("reject"),
		run: (shift) => makeEdit(store, editOf(store.state, facts, "reject", shift))
	}, {
		keys: ["r"],
		does: say("uses-what-is-chosen-again"),
		can: idle,
		lacks: () => lack("restore"),
		run: (shift) => makeEdit(store, editOf(store.state, facts, "restore", shift))
	}];
	const edits = declare({
		where: say("views-and-tables-of-a"),
		host: byId("block-view"),
		list
	});
	for (const host of hosts) listenKeys(host, edits);
}
// www/block/panel/edit-panel.ts
function mountEditPanel(host, store) {
	const compared = h("div", { testid: "block-compared" });
	const rejected = h("ul", {
		class: "rejected",
		testid: "block-rejected"
	});
	const history = h("ol", {
		class: "history",
		testid: "block-history"
	});
	const marked = h("div", { testid: "block-marked" });
	const hint = h("p", { class: "note" }, say("choose-an-image-a-tie"));
	host.append(h("div", { class: "edits" }, hint, compared, marked, h("h3", {}, say("rejected-by-hand")), rejected, h("h3", {}, say("history")), history));
	mountMarks(marked, store, history);
	store.watch([
		"history",
		"marks",
		"shown",
		"before",
		"adjusting"
	], ([edits, marks, shown, before, adjusting]) => {
		const names = namesIn(store.state);
		const both = {
			history: edits,
			marks
		};
		showHistory(history, "block-", say("as-found"), timelineOf(both), (one) => nameOfTimed(both, one, names), (done) => goTo(store, heldAt(store.state, done)));
		fill(compared, ...shown === null || before === null || shown.edits.length === 0 ? [] : [comparison(before, adjusting ? null : figuresOf$3(shown.view))]);
		const standing = shown === null ? [] : rejectedRows(shown.view, standingOf(shown.edits));
		const at = [...rejected.querySelectorAll("button")].indexOf(document.activeElement);
		const held = at < 0 ? null : document.activeElement;
		fill(rejected, ...standing.length === 0 ? [h("li", {}, say("nothing"))] : standing.map(({ name, edit }) => h("li", {}, `${name} `, restoreButton(store, name, edit))));
		const buttons = rejected.querySelectorAll("button");
		passFocus(held, [
			buttons[at],
			buttons[at - 1],
			history.querySelector("[aria-current]")
		]);
	});
}
function mountMarks(host, store, after) {
	const list = h("ul", {
		class: "rejected",
		testid: "block-marks-list"
	});
	store.watch(["marks"], ([marks]) => {
		const at = [...list.querySelectorAll("button")].indexOf(document.activeElement);
		const held = at < 0 ? null : document.activeElement;
		const byHand = marksByHand(marks);
		fill(list, ...byHand.map((mark) => {
			const name = say("mark-of", {
				point: mark.point,
				image: mark.image
			});
			const remove = button(say("remove"), `remove-mark-${mark.point}-${mark.image}`, () => store.dispatch({
				type: "mark",
				step: {
					kind: "remove",
					marks: [mark],
					after: store.state.history.done
				}
			}));
			remove.className = "link";
			remove.setAttribute("aria-label", say("remove-2", { title: name }));
			return h("li", {}, `${name}: ${fixed(mark.x_px, 1)} ${fixed(mark.y_px, 1)} `, remove);
		}));
		fill(host, ...byHand.length === 0 ? [] : [h("h3", {}, say("marks-by-hand")), list]);
		const buttons = list.querySelectorAll("button");
		passFocus(held, [
			buttons[at],
			buttons[at - 1],
			after.querySelector("[aria-current]")
		]);
	});
}
function restoreButton(store, name, edit) {
	const made = button(say("restore"), `restore-${name}`, () => makeEdit(store, edit));
	made.className = "link";
	made.setAttribute("aria-label", say("restore-2", { name }));
	return made;
}
var LISTED$4 = 200;
function rejectedRows(view, { images, pairs, points, unused, observations }) {
	const imageName = (image) => view.images[image]?.name ?? "";
	const pointName = (point) => {
		const index = indexOfSource(view, point);
		if (index >= 0) return nameOfPoint(view, index);
		return Object.entries(point).map(([kind, number]) => say("point-of-kind", {
			kind,
			number: Number(number)
		})).join("");
	};
	return [
		...[...images].map((image) => ({
			name: imageName(image),
			edit: {
				kind: "restore_images",
				images: [image]
			}
		})),
		...[...pairs.values()].map((pair) => ({
			name: nameOfPair(view, pair),
			edit: {
				kind: "restore_pairs",
				pairs: [pair]
			}
		})),
		...[...points.values()].map((point) => ({
			name: pointName(point),
			edit: {
				kind: "restore_points",
				points: [point]
			}
		})),
		...[...unused].map((point) => ({
			name: pointName({ ground_control: point }),
			edit: {
				kind: "restore_points",
				points: [{ ground_control: point }]
			}
		})),
		...[...observations.values()].map((one) => ({
			name: say("in", {
				point: pointName(one.point),
				image: imageName(one.image)
			}),
			edit: {
				kind: "restore_observations",
				observations: [one]
			}
		}))
	].slice(0, LISTED$4);
}
function comparison(before, now) {
	const line = (name, testid, text) => row(name, h("td", {
		class: "number",
		testid: `${testid}-before`
	}, text(before)), h("td", {
		class: "number",
		testid: `${testid}-now`
	}, now === null ? "…" : text(now)));
	const head = h("tr", {}, h("th", { scope: "col" }, say("block")), h("th", { scope: "col" }, say("before")), h("th", { scope: "col" }, say("now")));
	const checks = before.checks !== null || now?.checks != null;
	const areOthers = now !== null && before.checks?.points !== now.checks?.points;
	const body = h("tbody", {}, line("σ₀, px", "block-compared-sigma0", ({ sigma0Px }) => figureText(sigma0Px)), line(say("rmse-px-2"), "block-compared-rmse", ({ rmsePx }) => figureText(rmsePx)), checks ? line(say("check-points-rmse-m"), "block-compared-checks", (of) => figureText(of.checks?.rmseM ?? null)) : null, areOthers ? line(say("check-points-compared"), "block-compared-check-points", (of) => count(of.checks?.points ?? 0)) : null, line(say("images-oriented-2"), "block-compared-images", ({ oriented }) => count(oriented)), line(say("points-2"), "block-compared-points", ({ points }) => count(points)), line(say("observations-5"), "block-compared-observations", ({ observations }) => count(observations)));
	return h("table", {
		class: "tight",
		aria: { label: say("block-before-and-after-the") }
	}, h("thead", {}, head), body);
}
// www/block/state/in-common.ts
function inSystemOfBlock(view, rows, { crs, heights }) {
	const { orthophoto, origin } = view;
	if (orthophoto !== null && orthophoto.kind !== "not_linked" && !orthophoto.inCrs) return rows.map(({ position }) => position);
	return (crs === null || origin === null ? null : byEarth(rows, crs, heights, origin)) ?? byCommonPoints(view, rows);
}
function byEarth(rows, crs, heights, { longitude_deg, latitude_deg, height_m }) {
	try {
		const geographic = system_positions(crs, rows.flatMap(({ position }) => position), heights);
		const local = local_positions([
			longitude_deg,
			latitude_deg,
			height_m,
			...geographic
		]);
		const places = rows.map((_, i) => {
			const [x = NaN, y = NaN, z = NaN] = local.subarray(3 * i + 3, 3 * i + 6);
			return Number.isNaN(x + y + z) ? null : [
				x,
				y,
				z
			];
		});
		return places.every((place) => place === null) ? null : places;
	} catch {
		return null;
	}
}
function byCommonPoints({ surveyed }, rows) {
	const inBlock = new Map(surveyed.map(({ name, position }) => [name, position]));
	const common = rows.flatMap(({ name, position }) => {
		const own = inBlock.get(name);
		return own === void 0 ? [] : [[position, own]];
	});
	const plan = similarity(common.map(([[x, y]]) => [x, y]), common.map(([, [x, y]]) => [x, y]));
	if (plan === null) return rows.map(() => null);
	const scale = scaleOf(plan);
	const rise = common.reduce((sum, [given, own]) => sum + own[2] - scale * given[2], 0) / common.length;
	return rows.map(({ position: [x, y, z] }) => [...mapped(plan, x, y), scale * z + rise]);
}
// www/block/state/given-points.ts
var NONE_GIVEN = [];
var besideBlock = remember((view, control, crs, geoid_m) => {
	const known = new Set(view.surveyed.map(({ name }) => name));
	const heights = geoid_m === null ? countedFrom(view) : { geoid_m };
	const places = inSystemOfBlock(view, pointsOfFile(control), {
		crs,
		heights
	});
	return pointsOfFile(control).flatMap(({ name, position, role }, i) => known.has(name) ? [] : [{
		name,
		position,
		place: places[i] ?? null,
		role: role ?? null,
		byHand: false
	}]);
});
var measured$1 = remember((points, view, file, history) => {
	if (points.length === 0) return NONE_GIVEN;
	const images = new Map();
	for (const { point } of allMarks(file, history, view.images)) images.set(point, (images.get(point) ?? 0) + 1);
	return points.map((point) => ({
		...point,
		images: images.get(point.name) ?? 0
	}));
});
var added = remember((view, points, unused) => {
	if (points.size === 0) return NONE_GIVEN;
	const known = new Set(view.surveyed.map(({ name }) => name));
	const waiting = [...points.values()].filter(({ edit }) => !known.has(edit.name));
	if (waiting.length === 0) return NONE_GIVEN;
	const places = inSystemOfBlock(view, waiting.map(({ edit: { name, position } }) => ({
		name,
		position,
		standard_errors: null,
		role: "control",
		sigma_px: null
	})), {
		crs: view.crs,
		heights: countedFrom(view)
	});
	return waiting.map(({ edit, control, places: seen }, i) => {
		const { name, position, use } = edit;
		return {
			name,
			position,
			place: places[i] ?? null,
			role: unused.has(control) ? null : use ?? "control",
			images: seen.size,
			byHand: true
		};
	});
});
var together$1 = remember((given, byHand) => byHand.length === 0 ? given : given.length === 0 ? byHand : [...given, ...byHand]);
function givenBeside(view, state) {
	if (view.partial) return NONE_GIVEN;
	const edits = editsInForce(state.history);
	return together$1(ofFile(view, state), added(view, addedPoints(edits, view.givenControl), standingOf(edits).unused));
}
function pendingPoints(state) {
	if (state.shown === null || !(waitsForMarks(state) || isOutdated(state))) return 0;
	return state.shown.given.filter(({ byHand, images }) => !byHand && images > 0).length;
}
function ofFile(view, { options, marks }) {
	if (options.control === null) return NONE_GIVEN;
	const { crs = null, geoid_m = null } = options.settings?.placing ?? {};
	return measured$1(besideBlock(view, options.control, crs ?? view.crs, geoid_m), view, options.marks, marks);
}
var AIM_PX = .25;
var MOST_CELLS = 24;
function wholeOf(exact, size) {
	const pixels = latticeOf(size, 4);
	const there = exact(flat(pixels));
	if (!there.every(([x, y]) => Number.isFinite(x + y))) return null;
	const whole = affine(pixels, there);
	return whole === null ? null : {
		whole,
		cells: null,
		departs: departure(whole, pixels, there) / scaleOf(whole)
	};
}
function sheetOf(exact, size) {
	const plain = wholeOf(exact, size);
	if (plain === null || plain.departs <= .5) return plain;
	const { whole, departs } = plain;
	const number = Math.min(MOST_CELLS, Math.ceil(Math.sqrt(departs / AIM_PX)));
	const fine = exact(flat(latticeOf(size, 2 * number)));
	if (!fine.every(([x, y]) => Number.isFinite(x + y))) return plain;
	const side = 2 * number + 1;
	const cells = {
		number,
		corners: fine.filter((_, i) => i % side % 2 === 0 && Math.floor(i / side) % 2 === 0),
		margin: Math.ceil(2 * departs)
	};
	return {
		whole,
		cells,
		departs: latticeOf(size, 2 * number).reduce((most, pixel, i) => {
			const [x, y] = placeIn(cells, size, pixel);
			return Math.max(most, Math.hypot(x - (fine[i]?.[0] ?? NaN), y - (fine[i]?.[1] ?? NaN)));
		}, 0) / scaleOf(whole)
	};
}
function placeIn({ number, corners }, { width, height }, [x, y]) {
	const [across, down] = [x / width * number, y / height * number];
	const [column, row] = [across, down].map((at) => Math.min(number - 1, Math.max(0, Math.floor(at))));
	const [u, v] = [across - column, down - row];
	const corner = (right, below) => corners[(row + below) * (number + 1) + column + right] ?? [NaN, NaN];
	const between = (axis) => (1 - v) * ((1 - u) * corner(0, 0)[axis] + u * corner(1, 0)[axis]) + v * ((1 - u) * corner(0, 1)[axis] + u * corner(1, 1)[axis]);
	return [between(0), between(1)];
}
function affineOfPart({ whole, cells }, size, [left, top, right, bottom]) {
	if (cells === null) return whole;
	const pixels = [
		[left, top],
		[right, top],
		[left, bottom],
		[right, bottom]
	];
	return affine(pixels, pixels.map((pixel) => placeIn(cells, size, pixel))) ?? whole;
}
function latticeOf({ width, height }, steps) {
	const along = Array.from({ length: steps + 1 }, (_, i) => i / steps);
	return along.flatMap((y) => along.map((x) => [x * width, y * height]));
}
function flat(places) {
	return Float64Array.from(places.flat());
}
function throughout(by) {
	return {
		whole: by,
		cells: null,
		departs: 0
	};
}
function byAffine(by, pixels) {
	return Array.from({ length: pixels.length / 2 }, (_, i) => mapped(by, pixels[2 * i] ?? NaN, pixels[2 * i + 1] ?? NaN));
}
// www/block/state/orthophoto-unit.ts
var FOOT_M$1 = .3048;
var MOST_SCALE = .002;
var APART$1 = 1e3;
var unitOfInfo = remember((info) => {
	const { epsg, described } = info;
	if (epsg === null) return /(?:^|[^a-z])(?:ft|ftUS|feet|foot)(?:[^a-z]|$)/iu.test(described ?? "") ? "ft" : "m";
	return Math.abs(unitM(`EPSG:${String(epsg)}`, info) / FOOT_M$1 - 1) < MOST_SCALE ? "ft" : "m";
});
function unitOfOrthophoto(orthophoto) {
	return orthophoto === null ? "m" : unitOfInfo(orthophoto.info);
}
function unitM(crs, { width, height, georeference }) {
	const [x, y] = mapped(affineOf(georeference), width / 2, height / 2);
	try {
		const places = local_positions(system_positions(crs, Float64Array.of(x, y, 0, x + APART$1, y, 0)));
		return Math.hypot(...places.subarray(3)) / APART$1;
	} catch {
		return NaN;
	}
}
// www/block/state/level.ts
var FOOT_M = .3048;
var APART_M = 100;
function isLevelOpen(heights) {
	return heights.kind === "level" && (heights.by === "block" || heights.by === void 0 && heights.height === 0);
}
function levelByBlock({ orthophoto, heights }, shown) {
	if (orthophoto === null || shown === null || !isLevelOpen(heights)) return null;
	const height = heightOf(orthophoto, shown);
	return height === null || Number.isNaN(height) ? null : {
		kind: "level",
		height: Math.round(10 * height) / 10,
		by: "block"
	};
}
function heightOf(orthophoto, { key, view }) {
	if (view.partial || view.layout.kind !== "oriented") return null;
	const [x, y, z] = [
		0,
		1,
		2
	].map((axis) => medianOf(view, axis));
	if (x === void 0 || y === void 0 || z === void 0) return null;
	const between = betweenSystems(orthophoto, view);
	if (between?.kind === "affine") {
		const [, , low = NaN, , , high = NaN] = inSystem$1(view, between.crs, Float64Array.of(x, y, z, x, y, z + APART_M));
		const metres = low / ((high - low) / APART_M);
		return unitOfOrthophoto(orthophoto) === "ft" ? metres / FOOT_M : metres;
	}
	const isOwn = orthophoto.ofBlock === key || isInSystemOf(view) && view.orthophoto?.inCrs !== true;
	return between === null && isOwn ? z : null;
}
function medianOf({ points: { positions, taking } }, axis) {
	return median(positions.subarray(0, 3 * taking).filter((value, i) => i % 3 === axis && !Number.isNaN(value)));
}
// www/block/files/degrees.ts
var [RASTER_TYPE, GEOGRAPHIC_SYSTEM, ANGULAR_UNIT] = [
	1025,
	2048,
	2054
];
var [PIXEL_IS_POINT, DEGREE, USER_DEFINED] = [
	2,
	9102,
	32767
];
var [WIDTH, HEIGHT$1] = [256, 257];
var WGS84 = "EPSG:4326";
var MOST_SHIFT_DEG = .01;
var LARGEST_DEG = .001;
async function projectedOf(raster) {
	const directory = await tiffDirectory(raster.file);
	const said = directory === null ? saidByWorld(raster) : await saidByTags(raster, directory);
	const size = said === null ? null : await sizeOf$1(raster.file, directory);
	if (said === null || size === null) return null;
	try {
		const degrees = utmOf(said, size);
		return degrees === null ? null : {
			...raster,
			file: said.file,
			degrees
		};
	} catch {
		return null;
	}
}
function utmOf({ crs, georeference }, size) {
	const toDegrees = affineOf(georeference);
	const [longitude, latitude] = mapped(toDegrees, size.width / 2, size.height / 2);
	if (!isInDegrees(crs, longitude, latitude)) return null;
	const zone = Math.min(60, Math.floor((longitude + 180) / 6) + 1);
	const shownIn = `EPSG:${String((latitude < 0 ? 32700 : 32600) + zone)}`;
	const sheet = wholeOf((pixels) => planeOf(system_coordinates(shownIn, system_positions(crs, withHeights(byAffine(toDegrees, pixels))))), size);
	return sheet === null ? null : {
		crs,
		georeference,
		shownIn,
		world: worldFileOf(sheet.whole),
		departs: sheet.departs
	};
}
function isInDegrees(crs, longitude, latitude) {
	if (!(Math.abs(longitude) <= 180 && Math.abs(latitude) <= 90)) return false;
	const [east = NaN, north = NaN] = system_positions(crs, Float64Array.of(longitude, latitude, 0));
	return Math.hypot(east - longitude, north - latitude) < MOST_SHIFT_DEG;
}
function withHeights(places) {
	return Float64Array.from(places.flatMap(([x, y]) => [
		x,
		y,
		0
	]));
}
function planeOf(coordinates) {
	return Array.from({ length: coordinates.length / 3 }, (_, i) => [coordinates[3 * i] ?? NaN, coordinates[3 * i + 1] ?? NaN]);
}
function worldFileOf(by) {
	return `${[
		by.a,
		by.b,
		by.c,
		by.d,
		...mapped(by, .5, .5)
	].map(String).join("\n")}\n`;
}
async function saidByTags(raster, directory) {
	const valuesOf = (tag, most) => directory.entries.find((entry) => entry.tag === tag)?.values(most) ?? Promise.resolve([]);
	const keys = await geoKeys(directory);
	const kind = keys.get(MODEL_TYPE);
	const unit = keys.get(ANGULAR_UNIT) ?? DEGREE;
	if (kind !== void 0 && kind !== 2 || unit !== DEGREE) return null;
	const [matrix, scale, ties] = await Promise.all([
		valuesOf(TRANSFORMATION, 16),
		valuesOf(SCALE, 3),
		valuesOf(TIES, 6)
	]);
	const place = placeOf$1(matrix, scale, ties);
	const half = keys.get(RASTER_TYPE) === PIXEL_IS_POINT ? -.5 : 0;
	const georeference = place === null ? placeOfWorld(raster) : {
		...place,
		origin: mapped(affineOf(place), half, half)
	};
	const code = keys.get(GEOGRAPHIC_SYSTEM) ?? USER_DEFINED;
	const own = code === USER_DEFINED || code === 0 ? null : `EPSG:${String(code)}`;
	const crs = kind === void 0 ? crsBeside(raster, georeference) : own ?? WGS84;
	return georeference === null || crs === null ? null : {
		crs,
		georeference,
		file: withoutPlace(raster, directory)
	};
}
function placeOf$1(matrix, scale, ties) {
	const [a, b, , x, d, e, , y] = matrix;
	if (a !== void 0 && b !== void 0 && x !== void 0 && d !== void 0 && e !== void 0 && y !== void 0) return {
		origin: [x, y],
		by_column: [a, d],
		by_row: [b, e]
	};
	const [sx, sy] = scale;
	const [i, j, , u, v] = ties;
	if (sx === void 0 || sy === void 0 || i === void 0 || j === void 0 || u === void 0 || v === void 0) return null;
	return {
		origin: [u - i * sx, v + j * sy],
		by_column: [sx, 0],
		by_row: [0, -sy]
	};
}
function withoutPlace({ file, name }, { little, entries }) {
	const parts = [];
	let at = 0;
	const ofPlace = [
		SCALE,
		TIES,
		TRANSFORMATION,
		GEO_KEYS
	];
	for (const { tag, from } of entries.filter((entry) => ofPlace.includes(entry.tag))) {
		const number = new DataView(new ArrayBuffer(2));
		number.setUint16(0, tag - 1, little);
		parts.push(file.slice(at, from), number);
		at = from + 2;
	}
	return new File([...parts, file.slice(at)], name, { type: file.type });
}
function saidByWorld(raster) {
	const georeference = placeOfWorld(raster);
	const crs = crsBeside(raster, georeference);
	return georeference === null || crs === null ? null : {
		crs,
		georeference,
		file: raster.file
	};
}
function crsBeside({ projection }, georeference) {
	if (projection !== null) return projection.text.trim();
	return georeference !== null && scaleOf(affineOf(georeference)) < LARGEST_DEG ? WGS84 : null;
}
function placeOfWorld({ world }) {
	const [a = NaN, d = NaN, b = NaN, e = NaN, x = NaN, y = NaN] = (world?.text ?? "").trim().split(/\s+/u).map(Number);
	if (!Number.isFinite(a + b + d + e + x + y)) return null;
	return {
		origin: [x - (a + b) / 2, y - (d + e) / 2],
		by_column: [a, d],
		by_row: [b, e]
	};
}
async function sizeOf$1(file, directory) {
	if (directory === null) {
		const bitmap = await createImageBitmap(file, { imageOrientation: "none" }).catch(() => null);
		const size = bitmap === null ? null : {
			width: bitmap.width,
			height: bitmap.height
		};
		bitmap?.close();
		return size;
	}
	const [width, height] = await Promise.all([WIDTH, HEIGHT$1].map(async (tag) => (await directory.entries.find((entry) => entry.tag === tag)?.values(1))?.[0]));
	return width === void 0 || height === void 0 ? null : {
		width,
		height
	};
}
// www/block/files/ids.ts
var nextId$1 = 1;
function newId() {
	return nextId$1++;
}
function passIds(taken) {
	for (const id of taken) nextId$1 = Math.max(nextId$1, id + 1);
}
// www/block/files/ground.ts
var GroundFiles = class {
	store;
	engine;
	constructor(store, engine) {
		this.store = store;
		this.engine = engine;
	}
	async take({ orthophotos, heights, worlds, projections }, here) {
		const said = [];
		const [orthophoto, ...more] = orthophotos;
		if (orthophoto !== void 0) {
			const taken = await this.takeOrthophoto(orthophoto, here);
			if (taken === null) return null;
			said.push(taken);
		}
		if (more.length > 0) said.push(say("skipped-a-project-has-one", { more: named(more) }));
		const [model, ...others] = heights;
		if (model !== void 0) {
			const taken = await this.takeHeights(model, here);
			if (taken === null) return null;
			said.push(taken);
		} else if (orthophoto !== void 0) {
			const taken = await this.takeLevelOfBlock(here);
			if (taken === null) return null;
			said.push(taken);
		}
		if (others.length > 0) said.push(say("skipped-an-orthophoto-has-one", { others: named(others) }));
		for (const world of worlds) {
			const taken = await this.takeWorld(world, projections.find(({ name }) => stemOf(name) === stemOf(world.name)) ?? null, here);
			if (taken === null) return null;
			said.push(taken);
		}
		return said.filter((text) => text !== "").join(" ");
	}
	async takeOrthophoto(found, here) {
		const { file } = found;
		this.tell("busy", say("reading-the-orthophoto", { name: file.name }));
		try {
			const orthophoto = await this.opened(await rasterOf(found));
			here();
			this.store.dispatch({
				type: "orthophoto",
				orthophoto
			});
			this.store.dispatch({
				type: "stage",
				view: "orthophoto"
			});
			this.quiet();
			return orthophotoText(orthophoto);
		} catch (error) {
			here();
			this.refused(say("cannot-be-used-as-an", { name: file.name }), error);
			return null;
		}
	}
	async opened(raster) {
		try {
			return await this.engine.open(raster);
		} catch (error) {
			const projected = error instanceof Cancelled ? null : await projectedOf(raster);
			if (projected === null) throw error;
			return await this.engine.open(projected).catch((other) => {
				throw other instanceof Cancelled ? other : error;
			});
		}
	}
	takeHeights(found, here) {
		return this.setHeights(here, found.file.name, async () => ({
			kind: "model",
			model: await rasterOf(found)
		}));
	}
	takeLevel(height, here) {
		return this.setHeights(here, withUnit(fixed(height, 2), unitOfOrthophoto(this.store.state.placing.orthophoto)), () => Promise.resolve({
			kind: "level",
			height,
			by: "hand"
		}));
	}
	async takeLevelOfBlock(here) {
		const heights = this.otherLevel();
		if (heights === null) return "";
		const name = withUnit(fixed(heights.height, 1), unitOfOrthophoto(this.store.state.placing.orthophoto));
		return await this.setHeights(here, name, () => Promise.resolve(heights)) === null ? null : say("level-of-block", { height: name });
	}
	hasOtherLevel() {
		return this.otherLevel() !== null;
	}
	otherLevel() {
		const { placing, shown } = this.store.state;
		const heights = levelByBlock(placing, shown);
		if (heights?.kind !== "level") return null;
		const { heights: set } = placing;
		return set.kind === "level" && set.height === heights.height && set.by === "block" ? null : heights;
	}
	async setHeights(here, name, made) {
		if (this.store.state.placing.orthophoto === null) {
			this.tell("problem", say("holds-heights-give-their-orthophoto", { name }));
			return null;
		}
		this.tell("busy", say("reading-the-heights", { name }));
		try {
			const heights = await made();
			here();
			await this.engine.setHeights(heights);
			here();
			this.quiet();
			const { orthophoto } = this.store.state.placing;
			const [from, to] = orthophoto?.info.heights ?? [];
			if (heights.kind === "level") return say("the-ground-is-level-at", { name });
			return say("heights-from-to", {
				name,
				from,
				to,
				unit: unitText(unitOfOrthophoto(orthophoto))
			});
		} catch (error) {
			here();
			this.refused(say("cannot-be-used-as-heights", { name }), error);
			return null;
		}
	}
	async takeWorld(world, projection, here) {
		const stem = stemOf(world.name);
		const { files, truth } = this.store.state;
		const image = files.find(({ name }) => stemOf(name) === stem);
		if (image === void 0) {
			this.tell("problem", say("says-where-a-picture-of", { name: world.name }));
			return null;
		}
		const taken = await this.takeOrthophoto({
			file: new File([image.file], image.name, { type: image.file.type }),
			world,
			projection
		}, here);
		if (taken !== null) this.store.dispatch({
			type: "files",
			files: files.filter((file) => file !== image),
			truth
		});
		return taken;
	}
	tell(kind, text) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind,
				text
			}
		});
	}
	refused(what, error) {
		if (error instanceof Cancelled) this.tell("info", say("cancelled-nothing-was-changed"));
		else this.tell("problem", `${what}: ${sentence(messageOf(error))}`);
	}
	quiet() {
		this.store.dispatch({
			type: "notice",
			notice: null
		});
	}
};
async function rasterOf({ file, world, projection }) {
	const textOf = async (beside) => beside === null ? null : {
		name: beside.name,
		text: await beside.text()
	};
	return {
		id: newId(),
		name: file.name,
		file,
		world: await textOf(world),
		projection: await textOf(projection)
	};
}
function orthophotoText(orthophoto) {
	const { raster, info } = orthophoto;
	const { width, height, gsd, epsg } = info;
	const by = raster.world === null ? "" : say("placed-by", { name: raster.world.name });
	const system = raster.projection === null ? "" : say("in-the-system-of", { name: raster.projection.name });
	return say("orthophoto-px-of", {
		name: raster.name,
		width,
		height,
		gsd: gsdText$1(gsd, unitOfOrthophoto(orthophoto)),
		what: epsg === null || isLookedAtAlone(orthophoto) ? "" : say("epsg", { epsg }),
		by: by + system,
		degrees: degreesText(raster)
	});
}
function degreesText({ degrees = null }) {
	if (degrees === null) return "";
	const { crs, shownIn, departs } = degrees;
	return say("an-orthophoto-in-degrees", {
		crs,
		shown: shownIn,
		departs: departs > .5 ? departs : null
	});
}
function gsdText$1(gsd, unit) {
	return say(unit === "m" ? "metres" : "feet", { value: Number(gsd.toPrecision(3)) });
}
function named(rasters) {
	return rasters.map(({ file }) => file.name).join(", ");
}
// www/block/files/placed.ts
function placedCsv(names, placed) {
	return placed_tables([...names], placed);
}
// www/block/panel/placing-exports.ts
var EXPORT$1 = "placed-export";
var NAMES$3 = {
	placed: say("positions-placed-csv"),
	links: say("links-links-csv"),
	result: say("all-results-result-json"),
	rectified: say("chosen-image-on-the-ground"),
	all: say("all-images-on-the-ground")
};
function placingExports(store, engine) {
	const select = h("select", {
		testid: "placed-export-kind",
		aria: { label: say("what-of-the-placed-images") }
	});
	const kinds = Object.keys(NAMES$3);
	fill(select, ...kinds.map((kind) => new Option(NAMES$3[kind], kind)));
	const press = button(say("save"), EXPORT$1, () => void savePlaced(store, engine, select.value));
	const show = () => {
		const needsChosen = select.value === "rectified";
		const has = placedFiles(store.state).some(({ result }) => result !== null && (result.placement !== null || !needsChosen));
		press.disabled = isBusy(store.state) || !has || needsChosen && (chosenPlaced(store.state)?.result?.placement ?? null) === null;
	};
	select.addEventListener("change", show);
	store.watch([
		"placing",
		"files",
		"running",
		"notice"
	], show);
	return h("span", {
		class: "placed-exports",
		role: "group",
		aria: { label: say("export-of-the-placed-images") }
	}, select, press);
}
async function savePlaced(store, engine, kind, near = EXPORT$1) {
	const tell = (sort, text, where = {}) => store.dispatch({
		type: "notice",
		notice: {
			kind: sort,
			text,
			...where
		}
	});
	tell("busy", say("writing", { names: NAMES$3[kind] }));
	try {
		const [content, name] = await made$1(store, engine, kind, (text) => tell("busy", text));
		save(content, name);
		tell("info", say("was-saved", { name }), { beside: true });
	} catch (error) {
		if (error instanceof Cancelled) tell("info", say("cancelled-nothing-was-saved"), { beside: true });
		else tell("problem", say("nothing-was-saved", { sentence: sentence(messageOf(error)) }), { near });
	}
}
async function made$1(store, engine, kind, tell) {
	const tried = placedFiles(store.state).flatMap(({ file, result }) => result === null ? [] : [{
		file,
		result
	}]);
	const tables = () => placedCsv(tried.map(({ file }) => file.name), tried.map(({ result }) => inRows(result)));
	const tiff = (bytes) => new Blob([bytes], { type: "image/tiff" });
	switch (kind) {
		case "placed": return [new Blob([tables().placed], { type: "text/csv" }), "placed.csv"];
		case "links": return [new Blob([tables().links], { type: "text/csv" }), "links.csv"];
		case "result": {
			const { orthophoto } = store.state.placing;
			const all = {
				orthophoto: {
					name: orthophoto?.raster.name ?? "",
					...orthophoto?.info
				},
				images: tried.map(({ file, result }) => ({
					name: file.name,
					...inRows(result)
				}))
			};
			return [new Blob([`${JSON.stringify(all, null, 1)}\n`], { type: "application/json" }), "result.json"];
		}
		case "rectified": {
			const chosen = chosenPlaced(store.state);
			if (chosen === null) throw new Error(say("no-image-is-chosen-2"));
			return [tiff(await engine.rectified(chosen.file)), rectifiedName(chosen.file.name)];
		}
		case "all": {
			const placed = tried.filter(({ result }) => result.placement !== null);
			const archive = new Archive();
			for (const [i, { file }] of placed.entries()) {
				tell(say("resampling-to-the-ground-of", {
					name: file.name,
					i: i + 1,
					placed: placed.length
				}));
				archive.add(rectifiedName(file.name), await engine.rectified(file), true);
			}
			return [archive.end(), "rectified.zip"];
		}
	}
}
function rectifiedName(name) {
	return `${(name.split("/").at(-1) ?? name).replace(/\.[^.]*$/u, "")}-rectified.tif`;
}
// www/block/panel/mosaic.ts
var NAME = "orthomosaic.tif";
async function saveMosaic(store, engine, placing, near, pixel, images) {
	const mosaic = await made(store, engine, placing, {
		inAdjustment: false,
		gsd: pixel ?? null,
		images
	}, near);
	if (mosaic === null) return;
	const [alone, ...others] = images ?? [];
	const name = alone === void 0 || others.length > 0 ? NAME : rectifiedName(alone);
	save(mosaic.picture, name);
	tell$2(store, "info", [say("was-saved-2", {
		name,
		store: missingText(store, images)
	}), ...mosaic.remark === null ? [] : [say("noted", { remark: sentence(message("remark", mosaic.remark)) })]].join(" "), { beside: true });
}
async function makeMosaic(store, engine, placing, near) {
	const key = store.state.shown?.key ?? "";
	const mosaic = await made(store, engine, placing, {
		inAdjustment: true,
		gsd: null,
		images: null
	}, near);
	if (mosaic === null) return;
	tell$2(store, "busy", say("laying-the-orthomosaic-under-the"));
	try {
		const file = new File([mosaic.picture], NAME, { type: mosaic.picture.type });
		const orthophoto = await placing.open(await rasterOf({
			file,
			world: null,
			projection: null
		}), key);
		store.dispatch({
			type: "orthophoto",
			orthophoto
		});
		tell$2(store, "info", say("the-orthomosaic-lies-under-the", {
			orthophoto: orthophotoText(orthophoto),
			store: missingText(store, null)
		}), { beside: true });
	} catch (error) {
		tell$2(store, "problem", say("the-orthomosaic-cannot-be-shown", { sentence: sentence(messageOf(error)) }), { near });
	}
}
async function made(store, engine, placing, how, near) {
	const files = there(store, how.images);
	if (files.length === 0) {
		tell$2(store, "problem", say("an-orthomosaic-is-made-of"), { near });
		return null;
	}
	try {
		const mosaic = await placing.mosaic(await engine.project(), files, how);
		if (mosaic !== null) return mosaic;
		tell$2(store, "info", say("cancelled-no-orthomosaic-was-made"), { beside: true });
	} catch (error) {
		tell$2(store, "problem", say("no-orthomosaic-was-made", { sentence: sentence(messageOf(error)) }), { near });
	}
	return null;
}
function there({ state }, images) {
	return imagesOfBlock(state).filter(({ name }) => images === null || images.includes(name));
}
function missingText(store, images) {
	const missing = (images ?? store.state.shown?.view.images ?? []).length - there(store, images).length;
	return missing > 0 ? say("missing-in-it-add-to", { missing }) : "";
}
function tell$2(store, kind, text, where = {}) {
	store.dispatch({
		type: "notice",
		notice: {
			kind,
			text,
			...where
		}
	});
}
// www/block/panel/exports.ts
var NAMES$2 = {
	project: say("project-file"),
	everything: say("everything-zip"),
	colmap: "COLMAP",
	micmac: "MicMac",
	bundler: say("bundler"),
	nvm: say("nvm-visualsfm"),
	opensfm: "OpenSfM",
	bingo: "BINGO",
	isat: "ISAT",
	agisoft: say("agisoft"),
	patb: "PAT-B",
	csv: say("csv-tables"),
	json: "JSON",
	geojson: "GeoJSON"
};
var MOSAICS = {
	mosaic: say("orthomosaic-geotiff"),
	chosen: say("chosen-images-on-the-ground")
};
var isMosaic = (kind) => kind in MOSAICS;
var EXPORT = "block-export";
function mountExports(host, store, engine, facts, placing) {
	const select = h("select", {
		id: "block-export-kind",
		testid: "block-export-kind",
		aria: { label: say("format") }
	});
	const press = button(say("save"), EXPORT, () => {
		const { value } = select;
		if (isMosaic(value)) saveMosaic(store, engine, placing, EXPORT, typed(pixel), value === "chosen" ? chosenImages(store, facts) : null);
		else saveAs(store, engine, value);
	});
	const pixel = h("input", {
		id: "block-mosaic-pixel",
		type: "number",
		testid: "block-mosaic-pixel",
		aria: { label: say("pixel-of-the-orthomosaic") }
	});
	pixel.placeholder = say("pixel-as-the-images");
	pixel.title = say("pixel-of-the-orthomosaic");
	pixel.step = "any";
	pixel.hidden = true;
	const offer = () => {
		const { shown, history } = store.state;
		pixel.hidden = !isMosaic(select.value);
		const whole = shown !== null && !shown.view.partial;
		const lacksImages = select.value === "chosen" && chosenImages(store, facts).length === 0;
		press.disabled = !whole || isBusy(store.state) || lacksImages || !isSameList(editsInForce(history), shown.edits);
		press.title = lacksImages ? say("choose-one-or-more-images") : "";
		select.disabled = pixel.disabled = !whole;
	};
	select.addEventListener("change", offer);
	host.append(h("span", { class: "group-label" }, say("export")), select, pixel, press);
	store.watch(["shown"], ([shown]) => {
		const formats = shown?.view.formats ?? [];
		const kinds = [
			"project",
			"everything",
			...(shown?.view.oriented ?? 0) > 0 ? ["mosaic", "chosen"] : [],
			...formats
		];
		const { value } = select;
		fill(select, ...kinds.map((kind) => new Option(isMosaic(kind) ? MOSAICS[kind] : NAMES$2[kind], kind)));
		if (kinds.some((kind) => kind === value)) select.value = value;
	});
	store.watch([
		"shown",
		"running",
		"notice",
		"history",
		"placing",
		"selection"
	], offer);
}
function chosenImages({ state }, facts) {
	const { shown } = state;
	return imagesOf(chosenOf(state, facts)).flatMap((image) => shown?.view.images[image]?.name ?? []);
}
async function saveAs(store, engine, kind, near = EXPORT) {
	store.dispatch({
		type: "notice",
		notice: {
			kind: "busy",
			text: say("writing", { names: NAMES$2[kind] })
		}
	});
	try {
		const { name, type, bytes } = await engine.export(kind, "block");
		save(new Blob([bytes], { type }), name);
		const pending = kind === "project" || kind === "everything" ? pendingPoints(store.state) : 0;
		const text = [say("was-saved", { name }), pending === 0 ? "" : say("measured-points-are-not-in-it", { points: pending })].join(" ").trimEnd();
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text,
				beside: true
			}
		});
	} catch (error) {
		if (error instanceof Cancelled) {
			store.dispatch({
				type: "notice",
				notice: {
					kind: "info",
					text: say("cancelled-nothing-was-saved-the"),
					beside: true
				}
			});
			return;
		}
		const reason = messageOf(error);
		store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text: say("was-not-written", {
					names: NAMES$2[kind],
					reason
				}),
				near
			}
		});
	}
}
// www/block/state/poor-marks.ts
var MOST_SIGMA0_PX = 3;
var CLEARLY = 2;
function poorMarks(marks) {
	const { sigma0_mm: sigma, parameters } = orient_fiducials([...marks], "affine");
	const [[a, b], [d, e]] = parameters;
	const sigmaPx = (sigma ?? 0) / Math.sqrt(Math.abs(a * e - b * d));
	return sigmaPx > MOST_SIGMA0_PX ? {
		sigmaPx,
		worst: worstOf(marks)
	} : null;
}
function worstOf(marks) {
	const [best, next] = marks.map((mark) => {
		const others = marks.filter((other) => other !== mark);
		return {
			mark,
			sigma: orient_fiducials(others, "similarity").sigma0_mm ?? 0
		};
	}).sort((one, other) => one.sigma - other.sigma);
	return best !== void 0 && next !== void 0 && CLEARLY * best.sigma < next.sigma ? best.mark : null;
}
// www/block/state/scan-marks.ts
var LEAST_MARKS = 4;
var TOGETHER = 2;
var COLUMNS = [
	"col",
	"row",
	"x_mm",
	"y_mm"
];
function tableOfMarks(image, marks) {
	const rows = marks.map((mark) => COLUMNS.map((column) => String(mark[column])));
	return {
		name: `${image.replace(/\.[^.]*$/u, "")}.csv`,
		text: [COLUMNS, ...rows].map((row) => `${row.join(",")}\n`).join("")
	};
}
function marksOfScan(film, image) {
	const own = filmOf(film, image);
	return own === null ? [] : parse_fiducials(own.marks);
}
function begunIn(film, scans) {
	return scans.filter((scan) => !isInBlock(film, scan)).map(({ image, all }) => ({
		image,
		marks: all
	}));
}
function marksToMeasure(film, image) {
	const begun = film.begun.find((scan) => scan.image === image);
	if (begun !== void 0) return [...begun.marks];
	const own = marksOfScan(film, image);
	if (own.length > 0) return own;
	return film.marks.map(({ text }) => parse_fiducials(text)).reduce((best, marks) => marks.length > best.length ? marks : best, []).map(({ x_mm, y_mm }) => ({
		col: NaN,
		row: NaN,
		x_mm,
		y_mm
	}));
}
function nextScans(film, images, shown = []) {
	const scans = scansOf(film, images);
	const isOther = ({ name }) => !shown.includes(name);
	const lacking = scans.filter(({ name }) => filmOf(film, name) === null);
	if (lacking.length > 0) return lacking.filter(isOther).slice(0, TOGETHER);
	const after = scans.findLastIndex(({ name }) => shown.includes(name)) + 1;
	return [...scans.slice(after), ...scans.slice(0, after)].filter(isOther).slice(0, TOGETHER);
}
function countedScans(film, images) {
	const scans = scansOf(film, images);
	return {
		measured: scans.filter(({ name }) => filmOf(film, name) !== null).length,
		scans: scans.length
	};
}
function isInBlock(film, { image, marks, withoutMm }) {
	return withoutMm === 0 && (marks.length === 0 || !differs(film, image, marks));
}
function differs(film, image, marks) {
	return tableOfMarks(image, marks).text !== tableOfMarks(image, marksOfScan(film, image)).text;
}
function tablesToTake(film, scans) {
	return scans.flatMap((scan) => {
		const { image, marks } = scan;
		return marks.length > 0 && differs(film, image, marks) && faultOf(film, scan) === "" ? [tableOfMarks(image, marks)] : [];
	});
}
function lackOf(film, scans) {
	return scans.flatMap((scan) => {
		const { image, marks, all, withoutMm } = scan;
		const lone = withoutMm === 0 ? "" : say("marks-without-mm", {
			name: image,
			marks: withoutMm
		});
		const fault = marks.length === 0 ? "" : faultOf(film, scan);
		const off = marks.length === 0 || fault !== "" ? "" : farOff(image, marks, all);
		return [
			lone,
			fault === "" ? "" : `${image}: ${fault}`,
			off
		].filter((text) => text !== "");
	}).join(" ");
}
function farOff(name, marks, all) {
	const poor = poorMarks(marks);
	return poor === null ? "" : say("marks-far-off", {
		name,
		px: poor.sigmaPx,
		worst: poor.worst === null ? 0 : all.indexOf(poor.worst) + 1
	});
}
var NAMED$1 = 3;
var marksFarOff = remember((marks, images) => {
	const off = images.map(({ name }) => {
		const own = marksOfScan({
			...NO_FILM,
			marks
		}, name);
		return own.length < LEAST_MARKS ? "" : farOff(name, own, own);
	}).filter((text) => text !== "");
	const more = off.length - NAMED$1;
	return [...off.slice(0, NAMED$1), ...more > 0 ? [say("marks-of-more-far-off", { scans: more })] : []].join(" ");
});
function faultOf({ camera }, { marks, size }) {
	try {
		if (camera === null || size === null) orient_fiducials([...marks], "affine");
		else interior(parse_camera(camera.text), {
			width: size[0],
			height: size[1],
			fiducials: [...marks]
		});
		return "";
	} catch (error) {
		return sentence(messageOf(error));
	}
}
// www/block/state/frames-step.ts
function framesStep(state) {
	const { film } = state.placing;
	if (purposeOf(state) === "images" || !awaitsFrames(film, state.files)) return "";
	const { measured, scans } = countedScans(film, state.files);
	if (framesOf(film, state.files).length === 0) return say("press-measure-marks", { measure: say("measure-marks") });
	const step = film.camera === null ? say("marks-need-their-camera") : say("press-frames", { make: say("make-frames") });
	return measured === scans ? step : `${step} ${say("marks-of-some-scans", {
		measured,
		scans
	})}`;
}
// www/block/state/of-file.ts
var PROJECT_FILE = /\.tiepoint$/iu;
function defaultOptions({ catalogue }) {
	return {
		...BLOCK_INITIAL.options,
		settings: catalogue?.defaults ?? null
	};
}
function areDefault({ catalogue, options: { settings, gps, cameras, control, marks, positions, masks, geoid } }) {
	const noFile = cameras === null && control === null && marks === null && positions === null && masks.length === 0 && geoid === null;
	return (settings === null || settings === catalogue?.defaults) && gps === "use" && noFile;
}
function areOfFile({ shown, options }) {
	const { cameras, control, marks, positions } = options;
	return shown?.files.length === 0 || [
		cameras,
		control,
		marks,
		positions
	].some((text) => text !== null && PROJECT_FILE.test(text.name));
}
function imagesFor({ shown, files }, view) {
	const named = new Set(view.images.map(({ name }) => name));
	return shown === null ? files.filter(({ name }) => named.has(name)) : [];
}
function isReplaced(state, view) {
	return state.shown !== null || !areDefault(state) || imagesFor(state, view).length < state.files.length;
}
function placingFor({ placing }, files) {
	const { orthophoto, placed, film, options } = placing;
	const stay = new Set(files.map(({ id }) => id));
	if (orthophoto !== null && orthophoto.ofBlock !== null) return {
		...NO_PLACING,
		film,
		options
	};
	return {
		...placing,
		placed: new Map([...placed].filter(([id]) => stay.has(id))),
		chosen: NO_PLACING.chosen,
		pointed: NO_PLACING.pointed,
		draft: null
	};
}
// www/block/files/frames.ts
var LISTED$3 = 3;
async function takeFrames(store, engine, here) {
	const { files, placing, options } = store.state;
	const scans = framesOf(placing.film, files);
	const stems = scans.map(({ name }) => stemOf(name));
	const twice = scans.find(({ name }, k) => stems.indexOf(stemOf(name)) !== k);
	if (twice !== void 0) {
		store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text: say("two-scans-of-one-name", { name: twice.name })
			}
		});
		return;
	}
	try {
		const masks = masksOf$1(scans, options.masks);
		const films = scans.flatMap((file, k) => {
			const film = filmOf(placing.film, file.name);
			return film === null ? [] : [{
				file,
				film,
				mask: masks[k] ?? null
			}];
		});
		const frames = await engine.frames(films, camerasThere(files, options.cameras));
		here();
		if (frames === null) store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: say("cancelled-nothing-was-changed")
			}
		});
		else replace(store, frames);
	} catch (error) {
		here();
		store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text: say("no-frames-were-made", { sentence: sentence(messageOf(error)) })
			}
		});
	}
}
function masksOf$1(scans, masks) {
	const names = (files) => files.map(({ name }) => name);
	return [...masks_of_images(names(scans), names(masks))].map((index) => masks[index]);
}
function replace(store, frames) {
	const { files, options, marks, placing, history } = store.state;
	const made = new Map(frames.map((frame) => [frame.of, frame]));
	const scans = files.filter(({ id }) => made.has(id));
	const { pattern, file: cameras } = camerasOf(frames, files, options.cameras);
	const names = new Set(files.filter(({ id }) => !made.has(id)).map(({ name }) => name.toLowerCase()));
	const taken = scans.map(({ name }) => frameName(name, pattern)).find((name) => names.has(name.toLowerCase()));
	if (taken !== void 0) {
		store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text: say("frame-is-there", { name: taken })
			}
		});
		return;
	}
	const ownMasks = frames.map(({ of, mask }) => imageOf$2(files, of, mask, pattern));
	const former = new Set([...masksOf$1(scans, options.masks), ...options.masks.filter(({ name }) => ownMasks.some((own) => own.name === name))]);
	const images = scans.flatMap(({ id }) => {
		const frame = made.get(id);
		return frame === void 0 ? [] : [imageOf$2(files, id, frame.image, pattern)];
	});
	const measured = new Carried(scans.flatMap(({ id, name }) => {
		const frame = made.get(id);
		return frame === void 0 ? [] : [{
			scan: name,
			image: frameName(name, pattern),
			film: frame.scan
		}];
	}));
	const ofFile = measured.table(options.marks);
	const steps = marks.edits.slice(0, marks.done);
	const masks = [...options.masks.filter((mask) => !former.has(mask)), ...ownMasks];
	store.dispatch({
		type: "mark",
		step: {
			kind: "make_frames",
			scans: {
				images: scans,
				masks: options.masks,
				cameras: options.cameras,
				marks: options.marks,
				film: placing.film,
				steps
			},
			frames: {
				images,
				masks,
				cameras,
				marks: ofFile,
				film: NO_FILM,
				steps: withMeasurements(steps, (rows) => measured.rows(rows))
			},
			after: history.done
		}
	});
	measured.count(marksByHand(marks));
	const far = marksFarOff(placing.film.marks, files);
	const isKnown = frames.every(({ camera }) => camera.fixed);
	const text = say("scans-became-frames", {
		frames: frames.length,
		known: isKnown ? "yes" : "no"
	});
	store.dispatch({
		type: "notice",
		notice: {
			kind: "info",
			text: [
				text,
				far,
				...measured.said()
			].filter((said) => said !== "").join(" ")
		}
	});
}
var Carried = class {
	frames;
	moved = 0;
	beside = new Set();
	constructor(frames) {
		this.frames = frames;
	}
	rows(rows) {
		return film_measurements([...rows], this.frames).measurements;
	}
	count(rows) {
		const { moved, beside } = film_measurements([...rows], this.frames);
		this.moved += moved;
		for (const { image, point } of beside) this.beside.add(say("in", {
			point,
			image
		}));
	}
	table(file) {
		if (file === null) return null;
		const scans = new Set(this.frames.map(({ scan }) => scan));
		let rows;
		try {
			rows = parse_image_measurements(file.text, [...scans]);
		} catch {
			return file;
		}
		if (!rows.some(({ image }) => scans.has(image))) return file;
		this.count(rows);
		return {
			name: file.name,
			text: image_measurement_table(this.rows(rows))
		};
	}
	said() {
		const names = [...this.beside];
		const listed = names.slice(0, LISTED$3).join(", ") + (names.length > LISTED$3 ? " …" : "");
		return [...this.moved > 0 ? [say("measurements-carried", { moved: this.moved })] : [], ...names.length > 0 ? [say("measurements-beside-frames", {
			count: names.length,
			listed
		})] : []];
	}
};
function imageOf$2(files, scan, png, pattern) {
	const name = frameName(nameOf$1(files, scan), pattern);
	return {
		id: newId(),
		name,
		file: new File([png], name, { type: png.type })
	};
}
function nameOf$1(files, scan) {
	return files.find(({ id }) => id === scan)?.name ?? "";
}
function camerasThere(files, given) {
	return (given === null ? [] : parse_camera_rules(given.text)).filter(({ images = "*" }) => !isOfFrames(images) || files.some(({ name }) => name.endsWith(images.slice(1))));
}
function camerasOf(frames, files, given) {
	const others = camerasThere(files, given);
	const [first] = frames;
	const pattern = first === void 0 ? "" : film_pattern(first.camera, others);
	const own = frames.map(({ camera, of }) => ({
		...camera,
		images: frameName(nameOf$1(files, of), pattern)
	}));
	return {
		pattern,
		file: {
			name: say("camera-of-frames"),
			text: JSON.stringify({ cameras: film_cameras(pattern, own, others) })
		}
	};
}
// www/block/files/actions.ts
var NOTHING_LOST = {
	lost: 0,
	aside: []
};
var BlockActions = class {
	store;
	placing;
	runs;
	telling;
	aside;
	stays;
	constructor(store, placing, runs, telling, aside, stays) {
		this.store = store;
		this.placing = placing;
		this.runs = runs;
		this.telling = telling;
		this.aside = aside;
		this.stays = stays;
		let before = store.state;
		store.watch(["marks", "shown"], ([marks, shown]) => {
			const others = shown !== null && shown.found === before.shown?.found && removesOthers(before.marks, marks);
			before = store.state;
			if (others && isOutdated(before)) queueMicrotask(() => void this.run());
		});
	}
	decide(purpose) {
		return doHere(this.stays, async (here) => {
			this.store.dispatch({
				type: "purpose",
				purpose
			});
			this.store.dispatch({
				type: "notice",
				notice: null
			});
			if (purpose === "images") await this.runs.placeImages(here);
			else if (purpose === "block") await this.runOf(here);
			else this.store.dispatch({
				type: "stage",
				view: "map"
			});
		});
	}
	run() {
		return doHere(this.stays, (here) => this.runOf(here));
	}
	async runOf(here) {
		this.store.dispatch({
			type: "accept",
			leaves: false
		});
		const { shown, history } = this.store.state;
		const names = shown === null ? null : namesOf$2(shown.found);
		const isSame = shown !== null && shown.tiePoints !== "" && shown.key === wantedKey(this.store.state);
		const { lost, aside } = names === null ? NOTHING_LOST : carriedOver(history, names, withoutPlaces$1(names), isSame);
		if (lost + aside.length === 0 || lacksPlaceAlone(this.store.state)) return this.runs.run(here);
		this.telling.tell("busy", say("keeping-the-edited-block"));
		const stays = await this.aside.leave(say("run-it-again"), here);
		this.store.dispatch({
			type: "notice",
			notice: null
		});
		if (stays === null) return;
		await this.runs.run(here);
		here();
		const { notice, running } = this.store.state;
		if (!stays || running.kind !== "no" || notice === null) return;
		this.store.dispatch({
			type: "notice",
			notice: {
				...notice,
				text: say("the-former-block-stays-under-projects", { text: notice.text })
			}
		});
	}
	place() {
		return doHere(this.stays, (here) => this.runs.placeImages(here));
	}
	takeOff() {
		return doHere(this.stays, (here) => this.runs.takeOff(here));
	}
	frames() {
		return doHere(this.stays, (here) => takeFrames(this.store, this.placing, here));
	}
	clear() {
		return doHere(this.stays, async (here) => {
			const { shown, history, marks, draft } = this.store.state;
			const isEdited = history.edits.length + marks.edits.length + (draft?.places.size ?? 0) > 0;
			const stays = await this.aside.leave(say("remove-all-images"), here);
			if (stays === null) return;
			this.store.dispatch({ type: "clear" });
			const what = shown === null ? say("project") : isEdited ? say("edited-block") : say("oriented-block");
			if (stays) this.telling.tell("info", say("the-stays-under-projects", { what }));
		});
	}
};
// www/block/files/aside.ts
var BlockAside = class {
	store;
	putAside;
	constructor(store, putAside) {
		this.store = store;
		this.putAside = putAside;
	}
	async leave(step, here, isSetUp = false) {
		const { state } = this.store;
		const { shown, truth, history, marks, draft, placing } = state;
		const length = history.edits.length + marks.edits.length + (draft !== null && draft.places.size > 0 ? 1 : 0);
		const isFound = shown !== null && !shown.view.partial && shown.view.oriented > 0 && truth === null;
		const isMade = length > 0 || placing.placed.size > 0 || isFound;
		if (!isMade && !isSetUp) return false;
		const stays = await this.putAside();
		here();
		if (stays) return true;
		if (!isMade && truth !== null && areDefault(state)) return false;
		const what = placing.placed.size > 0 ? say("what-was-placed-on-the") : isMade ? say("the-block-of-these-photos") : say("what-was-set-up");
		const edits = length === 0 ? what : length === 1 ? say("the-edit-by-hand-of") : say("the-edits-by-hand-of", { length });
		return window.confirm(say("cannot-be-kept-in-this", {
			edits,
			step,
			length: Math.max(1, length)
		})) ? false : null;
	}
};
// www/block/state/masks.ts
function maskOf(masks, image) {
	const [index = -1] = masks_of_images([image], masks.map(({ name }) => name));
	return masks[index] ?? null;
}
function otherMasks(masks, ofPair) {
	return ofPair.filter(({ image, file }) => {
		const own = maskOf(masks, image);
		return file === null ? own !== null && !isLacking(own) : own?.file !== file;
	});
}
function withMasks(masks, others, newId) {
	const former = new Set(others.map(({ image }) => maskOf(masks, image)));
	const given = others.flatMap(({ image, file }) => file === null ? [] : [{
		id: newId(),
		name: `${image}.png`,
		file
	}]);
	return [...masks.filter((mask) => !former.has(mask)), ...given];
}
// www/block/files/tables.ts
var OF_TIE_POINTS = ["confidence", "rmse_px"];
var OF_RESULT_IMAGES = [
	"image",
	"name",
	"camera"
];
var OF_FIDUCIALS = [
	"col",
	"row",
	"x_mm",
	"y_mm"
];
var OF_IMAGES = /^(?:image|img|photo|picture|frame|bild|foto)/iu;
var OF_HEIGHTS = /^(?:z|h|up|height|alt|elev|hoehe|höhe)/iu;
var OF_PLACES = /^(?:[xyz][/_ ]|(?:gps|utm|wgs|etrs|grid|local)\w*[ _-])?(?:gps)?(?:lon|lng|lat|alt|elev|east|north|rechts|hoch|ost\b|nord\b|öst|norr|höjd|länge|laenge|breite|höhe|hoehe|height|z\b)/iu;
var COORDINATE = /^[+-]?\d+[.,]\d/u;
var LEAST_NUMBERS = 3;
function linesOf$1(text) {
	return text.split(/\r?\n/u).filter((line) => line.trim() !== "" && !line.startsWith("#"));
}
function columnsOf$1(text) {
	return (linesOf$1(text)[0] ?? "").split(/[,;\t]/u).map((column) => column.trim());
}
function hasNumbers(text) {
	const lines = linesOf$1(text);
	return 2 * lines.filter((line) => line.split(/[\s,;]+/u).filter((cell) => cell !== "" && Number.isFinite(Number(cell))).length >= LEAST_NUMBERS).length > lines.length;
}
function hasFiducials(text) {
	const columns = columnsOf$1(text);
	if (OF_FIDUCIALS.every((column) => columns.includes(column))) return true;
	try {
		return parse_fiducials(text).length > 0;
	} catch {
		return false;
	}
}
function kindOfTable(text, images) {
	if (hasFiducials(text)) return { kind: "fiducials" };
	const stems = new Set([...images].map((name) => name.replace(/\.[^.]*$/u, "").toLowerCase()));
	const isImage = (name) => images.has(name) || IMAGE_FILE.test(name) || stems.has(name.toLowerCase());
	const areImages = (names) => names.length > 0 && names.every(isImage);
	const marks = measurementsOf(text);
	const positions = positionsOf(text);
	const columns = columnsOf$1(text);
	if (OF_RESULT_IMAGES.every((column) => columns.includes(column))) return {
		kind: "neither",
		why: say("its-rows-are-images")
	};
	const havePlaces = hasPlaces(columns, marks);
	if (!havePlaces && "rows" in marks && areImages(marks.rows.map(({ image }) => image))) return { kind: "marks" };
	if ("rows" in positions && areImages(positions.rows.map(({ image }) => image))) return { kind: "positions" };
	try {
		const names = parse_ground_control_points(text).map(({ name }) => name);
		if (names.length === 0) return {
			kind: "neither",
			why: say("it-has-no-rows")
		};
		if (areImages(names)) return {
			kind: "neither",
			why: "why" in positions ? positions.why : say("its-rows-are-images")
		};
		if (OF_TIE_POINTS.every((column) => columns.includes(column))) return {
			kind: "neither",
			why: say("its-rows-are-tie-points")
		};
		return { kind: "control" };
	} catch (error) {
		if (hasNumbers(text) && !/[,;\t]/u.test(text)) return {
			kind: "neither",
			why: say("its-values-stand-between-spaces")
		};
		if (havePlaces && columns.some((column) => OF_IMAGES.test(column))) return {
			kind: "neither",
			why: whyNoPositions(positions)
		};
		return {
			kind: "neither",
			why: isOfImages(columns, marks) ? whyNoMarks(marks) : messageOf(error)
		};
	}
}
function measurementsOf(text) {
	try {
		return { rows: parse_image_measurements(text) };
	} catch (error) {
		return { why: messageOf(error) };
	}
}
function positionsOf(text) {
	try {
		return { rows: parse_image_positions(text).rows };
	} catch (error) {
		return { why: messageOf(error) };
	}
}
function hasPlaces(columns, marks) {
	if (columns.every((column) => !Number.isFinite(Number(column.replace(",", "."))) || column === "") && columns.some((column) => OF_PLACES.test(column))) return true;
	return "rows" in marks && marks.rows.length > 0 && marks.rows.every(({ point }) => COORDINATE.test(point));
}
function whyNoPositions(positions) {
	return "why" in positions ? positions.why : say("its-rows-name-no-images", { name: positions.rows[0]?.image ?? "" });
}
function isOfImages(columns, marks) {
	if (columns.some((column) => OF_IMAGES.test(column))) return true;
	return "rows" in marks && marks.rows.length > 0 && marks.rows.every(({ point }) => !COORDINATE.test(point)) && !columns.some((column) => OF_HEIGHTS.test(column));
}
function whyNoMarks(marks) {
	return "why" in marks ? marks.why : say("its-first-column-names-no-images", { name: marks.rows.find(({ image }) => !IMAGE_FILE.test(image))?.image ?? "" });
}
// www/block/files/beside.ts
var TABLE = /\.(?:csv|txt)$/iu;
var CSV = /\.csv$/iu;
var CAMERAS$1 = /\.json$/iu;
var FOCAL_LENGTH = "focal_mm";
var TEXTS = {
	cameras: say("cameras"),
	control: say("ground-control-points"),
	marks: say("image-measurements"),
	positions: say("image-positions")
};
var BesideFiles = class {
	store;
	telling;
	film;
	takeHere;
	constructor(store, telling, film, takeHere) {
		this.store = store;
		this.telling = telling;
		this.film = film;
		this.takeHere = takeHere;
	}
	async cameras(file, photos, here) {
		const { state } = this.store;
		const text = await textIn(file);
		here();
		const files = [...state.files, ...photos.map((photo) => ({
			id: 0,
			name: photo.file.name,
			file: photo.file
		}))];
		const { cameras: problem } = problemsOf({
			...state,
			files,
			options: {
				...state.options,
				cameras: {
					name: file.name,
					text
				}
			}
		});
		if (problem === void 0) {
			await this.takesText("cameras", file, here);
			return "";
		}
		const fields = fieldsOf(text);
		if ("tiepoint_settings" in fields) return say("holds-settings", { name: file.name });
		return say("cameras" in fields ? "cameras-are-put-aside" : "holds-no-cameras", { problem: sentence(problem) });
	}
	async ofFilm(given, here) {
		const cameras = [];
		const marks = [];
		for (const file of given) if (CAMERAS$1.test(file.name) && FOCAL_LENGTH in fieldsOf(await textIn(file))) cameras.push(file);
		else if (TABLE.test(file.name) && hasFiducials(await textIn(file))) marks.push(file);
		const [camera] = cameras;
		const said = [...camera === void 0 ? [] : [await this.film.camera(camera, here)], ...marks.length === 0 ? [] : [await this.film.marks(marks, here)]];
		const texts = (kind) => said.flatMap((one) => one.kind === kind ? [one.text] : []).join(" ");
		return {
			files: new Set([...camera === void 0 ? [] : [camera], ...marks]),
			marks: marks.map(({ name }) => name),
			said: texts("info"),
			aside: texts("problem")
		};
	}
	marksOfNone(names) {
		const { placing, files } = this.store.state;
		return marksOfNone(placing.film, files).filter((name) => names.includes(name)).map((name) => say("marks-of-no-image", { name })).join(" ");
	}
	async tables(given, photos, here) {
		const names = new Set([...this.store.state.files, ...photos.map(({ file }) => file)].map(({ name }) => name));
		const aside = [];
		const files = new Set();
		for (const file of given) {
			const text = await textIn(file);
			const found = kindOfTable(text, names);
			if (found.kind === "neither" && !CSV.test(file.name) && !hasNumbers(text)) continue;
			files.add(file);
			if (found.kind === "neither") aside.push(say("is-no-table-of", {
				name: file.name,
				why: sentence(found.why)
			}));
			else if (found.kind !== "fiducials") await this.takesText(found.kind, file, here);
		}
		return {
			files,
			aside: aside.join(" ")
		};
	}
	takeText(given, file) {
		return this.takeHere([file.name], (here) => this.takesText(given, file, here));
	}
	async takesText(given, file, here) {
		const text = await textIn(file);
		here();
		this.store.dispatch({
			type: "options",
			options: { [given]: {
				name: file.name,
				text
			} }
		});
		const problem = problemsOf(this.store.state)[given];
		const said = say("from", {
			texts: TEXTS[given],
			name: file.name
		});
		if (problem === void 0) this.telling.tellTaken((given === "control" || given === "marks") && waitsForMarks(this.store.state) ? `${said} ${controlText(this.store.state)}` : said);
		else if (problem === PARTNER_MISSING[given]) this.telling.tellTaken(say("from-2", {
			texts: TEXTS[given],
			name: file.name,
			problem
		}));
		else this.telling.tell("problem", say("the-block-cannot-be-run", { problem: sentence(problem) }));
	}
	takeMasks(files) {
		this.store.dispatch({
			type: "options",
			options: { masks: files.map((file) => ({
				id: newId(),
				name: file.name,
				file
			})) }
		});
		const problem = problemsOf(this.store.state).masks;
		if (problem !== void 0) this.telling.tell("problem", say("the-block-cannot-be-run-with", { problem: sentence(problem) }));
	}
	takePairMasks(masks) {
		this.store.dispatch({
			type: "options",
			options: { masks: withMasks(this.store.state.options.masks, masks, newId) }
		});
		const said = ["masks-are-of-the-block", "block-has-no-mask-of"].map((text) => {
			const names = masks.filter(({ file }) => file === null === (text === "block-has-no-mask-of")).map(({ image }) => image);
			return names.length === 0 ? "" : say(text, { names: names.join(", ") });
		});
		this.telling.tellTaken(said.filter((part) => part !== "").join(" "));
	}
	takeGeoid(file) {
		this.store.dispatch({
			type: "options",
			options: { geoid: {
				id: newId(),
				name: file.name,
				file
			} }
		});
		const problem = problemsOf(this.store.state).geoid;
		if (problem === void 0) this.telling.tellTaken(say("from", {
			texts: say("geoid"),
			name: file.name
		}));
		else this.telling.tell("problem", say("the-block-cannot-be-run", { problem: sentence(problem) }));
	}
};
// www/block/files/film.ts
var LISTED$2 = 5;
function namesOf$1(files) {
	return files.slice(0, LISTED$2).map(({ name }) => name).join(", ") + (files.length > LISTED$2 ? " …" : "");
}
var FilmFiles = class {
	store;
	takeHere;
	constructor(store, takeHere) {
		this.store = store;
		this.takeHere = takeHere;
	}
	takeCamera(file) {
		return this.takeHere([file.name], async (here) => this.tell(await this.camera(file, here)));
	}
	takeMarks(files) {
		return this.takeHere(files.map(({ name }) => name), async (here) => this.tell(await this.marks(files, here)));
	}
	async camera(file, here) {
		const camera = await this.read(file, parse_camera);
		here();
		if (typeof camera === "string") return {
			kind: "problem",
			text: camera
		};
		this.store.dispatch({
			type: "film",
			film: {
				...this.store.state.placing.film,
				camera
			}
		});
		return {
			kind: "info",
			text: say("from", {
				texts: say("film-camera"),
				name: file.name
			})
		};
	}
	async marks(files, here) {
		const marks = [];
		for (const file of files) {
			const read = await this.read(file, parse_fiducials);
			if (typeof read === "string") return {
				kind: "problem",
				text: read
			};
			marks.push(read);
		}
		here();
		this.store.dispatch({
			type: "film",
			film: withMarks(this.store.state.placing.film, marks)
		});
		return {
			kind: "info",
			text: say("from", {
				texts: say("marks-of-scans"),
				name: namesOf$1(files)
			})
		};
	}
	areScans() {
		this.store.dispatch({
			type: "film",
			film: {
				...this.store.state.placing.film,
				areScans: true
			}
		});
	}
	takeMeasured(tables) {
		const { film } = this.store.state.placing;
		this.store.dispatch({
			type: "film",
			film: withMarks(film, tables)
		});
		const said = say("from", {
			texts: say("marks-of-scans"),
			name: namesOf$1(tables)
		});
		this.tell({
			kind: "info",
			text: `${said} ${framesStep(this.store.state)}`.trimEnd()
		});
	}
	clear() {
		this.store.dispatch({
			type: "film",
			film: NO_FILM
		});
	}
	async read(file, check) {
		const text = await textIn(file);
		try {
			check(text);
			return {
				name: file.name,
				text
			};
		} catch (error) {
			return say("cannot-be-used-of-film", {
				name: file.name,
				problem: sentence(messageOf(error))
			});
		}
	}
	tell(notice) {
		this.store.dispatch({
			type: "notice",
			notice
		});
	}
};
// www/block/files/opened.ts
var PLACE = "orthophoto_";
function optionsOf({ input, geoid }, name) {
	const text = (given) => given == null ? null : {
		name,
		text: given
	};
	const { points, marks } = withoutPlaces(input.control ?? null);
	return {
		settings: block_settings(input.settings ?? {}),
		gps: input.use_gnss === false ? "ignore" : "use",
		cameras: text(input.cameras),
		control: text(points),
		marks: text(marks),
		positions: text(input.positions),
		masks: (input.masks ?? []).map((mask) => fileOf$3(mask, null)),
		geoid: input.geoid === void 0 ? null : fileOf$3(input.geoid, geoid)
	};
}
function fileOf$3(name, bytes) {
	return {
		id: newId(),
		name,
		file: bytes === null ? standIn(name) : new File([bytes], name)
	};
}
function withoutPlaces(control) {
	if (control == null) return {
		points: null,
		marks: null
	};
	const { points, marks } = control;
	const lines = points.split("\n");
	const own = lines.filter((line) => !line.startsWith(PLACE));
	if (own.length === lines.length) return {
		points,
		marks
	};
	if (own.filter((line) => line.trim() !== "").length < 2) return {
		points: null,
		marks: null
	};
	const measured = parse_image_measurements(marks).filter(({ point }) => !point.startsWith(PLACE));
	return {
		points: own.join("\n"),
		marks: image_measurement_table(measured)
	};
}
// www/block/files/simulated.ts
var SimulatedFiles = class {
	store;
	engine;
	placing;
	ground;
	runs;
	telling;
	aside;
	takeHere;
	waits;
	constructor(store, engine, placing, ground, runs, telling, aside, takeHere, waits) {
		this.store = store;
		this.engine = engine;
		this.placing = placing;
		this.ground = ground;
		this.runs = runs;
		this.telling = telling;
		this.aside = aside;
		this.takeHere = takeHere;
		this.waits = waits;
	}
	sample(flight) {
		return this.takeHere([say("simulated-block")], async (here) => {
			if (await this.simulate(flight, here)) await this.runs.run(here);
		});
	}
	sampleOnOrthophoto(flight, gsd) {
		return this.takeHere([say("simulated-block")], async (here) => {
			if (!await this.simulate(flight, here)) return;
			this.telling.tell("busy", say("making-the-orthophoto-of-the"));
			try {
				const { picture, heights } = await this.placing.scene(flight, gsd);
				here();
				const rasters = {
					orthophotos: [{
						file: new File([picture], "orthophoto.tif"),
						world: null,
						projection: null
					}],
					heights: [{
						file: new File([heights], "heights.tif"),
						world: null,
						projection: null
					}],
					worlds: [],
					projections: []
				};
				const taken = await this.ground.take(rasters, here);
				here();
				if (taken !== null) await this.runs.placeImages(here);
			} catch (error) {
				this.telling.failed(say("the-orthophoto-could-not-be"), error, here);
			}
		});
	}
	photograph() {
		return this.takeHere([say("simulated-block")], async (here) => {
			const { flight } = this.store.state;
			if (flight === null || !await this.simulate(flight, here)) return;
			if (this.waits()) this.telling.tell("info", say("photos-of-a-simulated-block", { files: this.store.state.files.length }));
			else await this.runs.run(here);
		});
	}
	async simulate(flight, here) {
		this.telling.tell("busy", say("building-the-synthetic-scene"));
		try {
			const { files, truth } = await this.engine.photograph(flight, (count, of) => {
				here();
				this.telling.tell("busy", say("photographing-the-simulated-block-of", {
					count,
					of
				}));
			});
			here();
			const stays = await this.aside.leave(say("photograph-another-block"), here);
			if (stays === null) {
				this.store.dispatch({
					type: "notice",
					notice: null
				});
				return false;
			}
			const { state } = this.store;
			if (stays || state.history.edits.length + state.marks.edits.length > 0 || state.placing.orthophoto !== null || areOfFile(state)) this.store.dispatch({ type: "clear" });
			this.store.dispatch({
				type: "files",
				files: files.map((file) => ({
					...file,
					id: newId()
				})),
				truth
			});
			return true;
		} catch (error) {
			this.telling.failed(say("the-block-could-not-be"), error, here);
			return false;
		}
	}
};
// www/block/files/told.ts
var Telling = class {
	store;
	constructor(store) {
		this.store = store;
	}
	tell(kind, text) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind,
				text
			}
		});
	}
	tellTaken(text) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text,
				beside: isOutdated(this.store.state)
			}
		});
	}
	tellUnread(text) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text,
				beside: this.runsNow()
			}
		});
	}
	runsNow() {
		const { running, placing } = this.store.state;
		return running.kind === "yes" || placing.running !== null;
	}
	failed(what, error, here) {
		here();
		if (error instanceof Cancelled) this.tell("info", say("cancelled-nothing-was-changed"));
		else this.tell("problem", say("the-block-is-unchanged", {
			what,
			error: messageOf(error)
		}));
	}
	tellBeside(said, text) {
		const notice = said === null ? {
			kind: "info",
			text,
			beside: true
		} : {
			...said,
			text: `${said.text} ${text}`
		};
		this.store.dispatch({
			type: "notice",
			notice
		});
	}
};
// www/block/files/files.ts
var GEOID = /\.gtx$/iu;
var NEEDS_MORE = say("a-block-needs-two-images");
var WAITS = "tiepoint-wait";
var BlockFiles = class {
	store;
	engine;
	runs;
	openProject;
	left;
	beside;
	film;
	simulated;
	actions;
	ground;
	telling;
	aside;
	takeHere;
	waiting = keptChoice(WAITS) === "yes";
	constructor(store, engine, placing, runs, openProject, putAside, left, stays) {
		this.store = store;
		this.engine = engine;
		this.runs = runs;
		this.openProject = openProject;
		this.left = left;
		const telling = new Telling(store);
		const aside = new BlockAside(store, putAside);
		this.takeHere = (names, take) => takeHere(left, take, () => telling.tell("info", say("were-not-taken-the-project", {
			files: names.length,
			names: namesText(names)
		})));
		this.telling = telling;
		this.aside = aside;
		this.ground = new GroundFiles(store, placing);
		this.film = new FilmFiles(store, this.takeHere);
		this.beside = new BesideFiles(store, telling, this.film, this.takeHere);
		this.simulated = new SimulatedFiles(store, engine, placing, this.ground, runs, telling, aside, this.takeHere, () => this.waiting);
		this.actions = new BlockActions(store, placing, runs, telling, aside, stays);
	}
	get waits() {
		return this.waiting;
	}
	set waits(waits) {
		this.waiting = waits;
		keepChoice(WAITS, waits ? "yes" : "no");
	}
	take(given, why = "") {
		return this.takeHere(given.map(({ file }) => file.name), (here) => this.takeKinds(given, why, here));
	}
	async takeKinds(given, why, here) {
		const before = this.store.state.notice;
		const kinds = await refusedKinds(given.map(({ file }) => file));
		const unread = kindsText(kinds);
		const { others: found, taken, degrees, ...rasters } = asGiven(await sortRasters(given.filter(({ file }) => !kinds.has(file))));
		here();
		const lone = rasters.projections.filter(({ name }) => !rasters.worlds.some((world) => stemOf(world.name) === stemOf(name)));
		const ground = await this.ground.take(rasters, here);
		here();
		const several = taken === 0 ? "" : say("that-say-where-they-lie", { taken: images$1(taken) });
		if (ground === null) {
			if (unread !== "") this.telling.tellBeside(this.store.state.notice, unread);
			return;
		}
		const alone = found.filter(({ path }) => path === "");
		const project = alone.find(({ file }) => PROJECT_FILE.test(file.name));
		const film = await this.beside.ofFilm(alone.map(({ file }) => file), here);
		here();
		const said = [
			ground,
			several,
			film.said
		].filter((text) => text !== "").join(" ");
		const cameras = alone.find(({ file }) => CAMERAS$1.test(file.name) && !film.files.has(file));
		const geoid = alone.find(({ file }) => GEOID.test(file.name));
		const photos = found.filter(({ file }) => IMAGE_FILE.test(file.name) || file.type.startsWith("image/"));
		if (project !== void 0) await this.openProject(project.file);
		here();
		if (geoid !== void 0) this.beside.takeGeoid(geoid.file);
		const notCameras = cameras === void 0 ? "" : await this.beside.cameras(cameras.file, photos, here);
		const tables = await this.beside.tables(alone.map(({ file }) => file).filter((file) => TABLE.test(file.name) && !film.files.has(file)), photos, here);
		here();
		const known = new Set([
			...photos,
			project,
			cameras,
			geoid
		].map((one) => one?.file));
		const aside = [...found.map(({ file }) => file).filter((file) => !known.has(file) && !film.files.has(file) && !tables.files.has(file)), ...lone].map(({ name }) => name);
		if (photos.length > 0 || aside.length > 0) this.add(here, photos, aside, [why, said].filter((text) => text !== "").join(" "), before);
		else await this.said(here, [said, film.said === "" ? "" : framesStep(this.store.state)].filter((text) => text !== "").join(" "));
		const putAside = [
			unread,
			degrees.map(({ file }) => say("is-a-grid-at-longitudes", { name: file.name })).join(" "),
			film.aside,
			this.beside.marksOfNone(film.marks),
			notCameras,
			tables.aside
		].filter((text) => text !== "").join(" ");
		if (putAside === "") return;
		const { notice } = this.store.state;
		if (given.length > 0 && kinds.size === given.length) this.telling.tellUnread(unread);
		else this.telling.tellBeside(notice === before ? null : notice, putAside);
	}
	takeGround(given, asHeights = false) {
		return this.takeHere(given.map(({ name }) => name), (here) => this.takeRasters(given, asHeights, here));
	}
	async takeRasters(given, asHeights, here) {
		const kinds = await refusedKinds(given);
		const { others, ...sorted } = await sortRasters(given.filter((file) => !kinds.has(file)).map((file) => ({
			file,
			path: ""
		})));
		here();
		const unknown = others.map(({ file }) => ({
			file,
			world: null,
			projection: null
		}));
		const pictures = asHeights ? [] : [...sorted.orthophotos, ...sorted.orthophotos.length > 0 ? [] : unknown];
		const heights = [
			...sorted.heights,
			...sorted.degrees,
			...asHeights ? [...sorted.orthophotos, ...unknown] : []
		];
		const text = await this.ground.take({
			orthophotos: pictures,
			heights,
			worlds: sorted.worlds,
			projections: sorted.projections
		}, here);
		here();
		await this.said(here, text, kindsText(kinds));
	}
	takeLevel(height) {
		return doHere(this.left, async (here) => this.said(here, await this.ground.takeLevel(height, here)));
	}
	async said(here, text, unread = "") {
		here();
		if (text !== null && text !== "") this.telling.tell("info", text);
		if (unread !== "" && text === "") this.telling.tellUnread(unread);
		else if (unread !== "") this.telling.tellBeside(this.store.state.notice, unread);
		if (text === null || text === "") return;
		const { shown, placing, files, running } = this.store.state;
		if (shown === null && running.kind !== "yes" && !this.waits && files.length > 0 && placing.placed.size === 0) await this.start(here);
	}
	async start(here) {
		const { state } = this.store;
		if (purposeOf(state) === "images") await this.runs.placeImages(here);
		else if (awaitsFrames(state.placing.film, state.files)) return;
		else if (state.files.length >= 2 && !asksPurpose(state)) await this.runs.run(here);
	}
	give(files, masks) {
		return this.takeHere([...files, ...masks].map(({ name }) => name), async (here) => {
			await this.takeKinds(files.map((file) => ({
				file,
				path: ""
			})), say("more-than-two-images-are"), here);
			if (masks.length > 0) this.beside.takeMasks(masks);
		});
	}
	open(file) {
		return this.takeHere([file.name], async (here) => {
			this.telling.tell("busy", say("reading", { name: file.name }));
			try {
				const { view, steps, made, hold } = await this.engine.read(new Uint8Array(await file.arrayBuffer()));
				here();
				const options = optionsOf(made, file.name);
				const stays = await this.aside.leave(say("open-the-other-project"), here, isReplaced(this.store.state, view));
				if (stays === null) {
					this.store.dispatch({
						type: "notice",
						notice: null
					});
					return;
				}
				hold();
				this.store.dispatch({
					type: "openedFile",
					view,
					steps,
					options
				});
				const former = stays ? say("the-former-block-stays-under") : "";
				this.telling.tell("info", say("was-opened-the-file-does", {
					name: file.name,
					former
				}));
			} catch (error) {
				this.telling.failed(say("cannot-be-opened", { name: file.name }), error, here);
			}
		});
	}
	add(here, found, aside, why, noticed) {
		const files = new Map(this.store.state.files.map((file) => [file.name, file]));
		const before = files.size;
		for (const { file, path } of found) {
			const name = [file.name, path].find((text) => text !== "" && !files.has(text));
			if (name !== void 0) files.set(name, {
				id: newId(),
				name,
				file
			});
		}
		const twice = found.length - (files.size - before);
		const sorted = [...files.values()].sort((a, b) => a.name < b.name ? -1 : 1);
		const own = ofOpened(this.store.state, sorted);
		if (sorted.length > before) {
			this.store.dispatch({
				type: "files",
				files: sorted,
				truth: this.store.state.truth
			});
			if (!this.waits && own === null) this.start(here);
		}
		if (aside.length > 0) this.store.dispatch({
			type: "skipped",
			names: aside
		});
		const runs = this.telling.runsNow();
		const notImages = aside.length > 0 ? say("skipped-not-an-image-by", { aside: aside.length }) : "";
		const notes = [
			why,
			runs || own !== null ? "" : say("in-the-block", { sorted: images$1(sorted.length) }),
			own ?? "",
			twice > 0 ? say("skipped-their-names-are-in", { twice: images$1(twice) }) : "",
			notImages,
			runs || own !== null ? "" : this.nextStep(sorted.length)
		].filter((note) => note !== "");
		const { notice } = this.store.state;
		if (notes.length === 0 || notice?.kind === "problem" && notice !== noticed) return;
		const passing = notes.every((note) => note === why || note === notImages);
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: notes.join(" "),
				beside: runs,
				passing
			}
		});
	}
	nextStep(count) {
		if (purposeOf(this.store.state) === "images") return say("press-place");
		const frames = framesStep(this.store.state);
		if (frames !== "") return frames;
		return count >= 2 ? say("press-run") : NEEDS_MORE;
	}
};
function ofOpened({ shown }, files) {
	if (shown === null || shown.view.partial || shown.files.length > 0) return null;
	const names = new Set(shown.view.images.map(({ name }) => name));
	if (!files.every(({ name }) => names.has(name))) return null;
	return files.length === names.size ? say("all-images-of-the-block") : say("of-of-the-block-are", {
		files: files.length,
		size: images$1(names.size)
	});
}
function images$1(count) {
	return say("so-many-images", { images: count });
}
// www/block/state/kept.ts
function isBlank({ catalogue, files, shown, options, flight, placing }) {
	const untouched = areDefault({
		catalogue,
		options
	}) && flight === catalogue?.flight && placing.options === catalogue?.placing;
	return catalogue === null || files.length === 0 && shown === null && placing.orthophoto === null && placing.film.camera === null && placing.film.marks.length === 0 && untouched;
}
// www/block/files/edit.ts
var OF_ONE = 60;
function bytesOfStep(step) {
	return step.reduce((sum, edit) => sum + bytesOf$1(edit), 0);
}
function bytesOf$1(edit) {
	const lists = Object.values(edit).filter((value) => Array.isArray(value));
	return OF_ONE * Math.max(1, ...lists.map(({ length }) => length));
}
function bytesOfMarks(step) {
	return OF_ONE * Math.max(1, step.kind === "remove_images" ? step.files.length : step.marks.length);
}
function markStepFrom(value, name) {
	const { kind, marks, files, after } = objectOf(value, name);
	if (kind === "remove_images") return {
		kind,
		files: listOf$1(files, `${name}.files`, (id, at) => likeOf(id, 0, at)),
		after: likeOf(after, 0, `${name}.after`)
	};
	return {
		kind: kind === "remove" ? kind : "measure",
		marks: listOf$1(marks, `${name}.marks`, (one, at) => {
			const { image, point, x_px, y_px } = objectOf(one, at);
			return {
				image: likeOf(image, "", `${at}.image`),
				point: likeOf(point, "", `${at}.point`),
				x_px: likeOf(x_px, 0, `${at}.x_px`),
				y_px: likeOf(y_px, 0, `${at}.y_px`)
			};
		}),
		after: likeOf(after, 0, `${name}.after`)
	};
}
function stepFrom(value, name) {
	return listOf$1(value, name, editFrom);
}
function editFrom(value, name) {
	const edit = objectOf(value, name);
	const kind = likeOf(edit.kind, "", `${name}.kind`);
	switch (kind) {
		case "reject_observations":
		case "restore_observations": return {
			kind,
			observations: listOf$1(edit.observations, `${name}.observations`, observationFrom)
		};
		case "reject_points":
		case "restore_points": return {
			kind,
			points: listOf$1(edit.points, `${name}.points`, sourceFrom)
		};
		case "reject_images":
		case "restore_images": return {
			kind,
			images: listOf$1(edit.images, `${name}.images`, (image, at) => likeOf(image, 0, at))
		};
		case "reject_pairs":
		case "restore_pairs": return {
			kind,
			pairs: listOf$1(edit.pairs, `${name}.pairs`, pairFrom)
		};
		case "measure": return {
			kind,
			point: sourceFrom(edit.point, `${name}.point`),
			...placeFrom(edit, name)
		};
		case "add_point": return {
			kind,
			observations: listOf$1(edit.observations, `${name}.observations`, placeFrom)
		};
		case "add_control": return addedFrom(edit, name);
		case "set_use": {
			const use = edit.use;
			return {
				kind,
				point: likeOf(edit.point, 0, `${name}.point`),
				...use === "control" || use === "check" ? { use } : {}
			};
		}
		default: throw new Error(say("the-field-kind-is-damaged", { name }));
	}
}
function addedFrom({ name: called, position, standard_errors: errors, sigma_px: sigmaPx, use, epsg, remarks }, name) {
	const [x = NaN, y = NaN, z = NaN] = listOf$1(position, `${name}.position`, numberFrom);
	const [across, up] = errors === void 0 ? [] : listOf$1(errors, `${name}.standard_errors`, numberFrom);
	return {
		kind: "add_control",
		name: likeOf(called, "", `${name}.name`),
		position: [
			x,
			y,
			z
		],
		...across === void 0 || up === void 0 ? {} : { standard_errors: [across, up] },
		...sigmaPx === void 0 ? {} : { sigma_px: likeOf(sigmaPx, 0, `${name}.sigma_px`) },
		use: use === "check" ? "check" : "control",
		...epsg === void 0 ? {} : { epsg: likeOf(epsg, 0, `${name}.epsg`) },
		...remarks === void 0 ? {} : { remarks: listOf$1(remarks, `${name}.remarks`, (one, at) => objectOf(one, at)) }
	};
}
var numberFrom = (value, name) => likeOf(value, 0, name);
function observationFrom(value, name) {
	const { point, image } = objectOf(value, name);
	return {
		point: sourceFrom(point, `${name}.point`),
		image: likeOf(image, 0, `${name}.image`)
	};
}
function pairFrom(value, name) {
	const [a, b] = listOf$1(value, name, (image, at) => likeOf(image, 0, at));
	if (a === void 0 || b === void 0) throw new Error(say("the-field-is-damaged", { name }));
	return [a, b];
}
function sourceFrom(value, name) {
	const source = objectOf(value, name);
	for (const kind of [
		"tie_point",
		"ground_control",
		"manual"
	]) if (source[kind] !== void 0) return { [kind]: likeOf(source[kind], 0, `${name}.${kind}`) };
	throw new Error(say("the-field-is-damaged", { name }));
}
function placeFrom(value, name) {
	const { image, x_px, y_px, by } = objectOf(value, name);
	return {
		image: likeOf(image, 0, `${name}.image`),
		x_px: likeOf(x_px, 0, `${name}.x_px`),
		y_px: likeOf(y_px, 0, `${name}.y_px`),
		by: by === "least_squares" ? by : "hand"
	};
}
// www/block/files/earlier-keys.ts
function withPresentKeys(placing, files, options) {
	if (placing.placed.size === 0) return placing;
	const names = new Map(files.map(({ id, name }) => [id, name]));
	const positionIn = (positions, image) => givenPositions({
		files,
		placing,
		options: {
			...options,
			positions
		}
	}).get(image) ?? null;
	const placed = [...placing.placed].map(([id, own]) => {
		const key = presentKey(own.key, (table) => positionIn(table, names.get(id) ?? ""));
		return [id, key === own.key ? own : {
			...own,
			key
		}];
	});
	return {
		...placing,
		placed: new Map(placed)
	};
}
function presentKey(key, positionIn) {
	let parts;
	try {
		const given = JSON.parse(key);
		const [all, ...own] = given;
		parts = typeof all === "string" ? {
			all: JSON.parse(all),
			own
		} : {
			all: given,
			own: []
		};
	} catch {
		return key;
	}
	const { all, own } = parts;
	if (own.length > 1) return key;
	const [orthophoto, heights, options, cameras, table = null] = all;
	const position = table === null ? null : positionIn(table);
	return keyWith(JSON.stringify([
		orthophoto,
		heights,
		options,
		cameras
	]), own[0] ?? null, position);
}
// www/block/files/going-on.ts
var RUNNING = "block/running";
var BYTES = 64;
var RunUnderWay = class {
	kept = null;
	constructor(store, engine) {
		store.watch((s) => [s.running.kind === "yes"], ([runs]) => {
			this.kept = runs ? { records: engine.records.size } : null;
		});
	}
	parts() {
		return this.kept === null ? [] : [[RUNNING, {
			value: this.kept,
			bytes: BYTES
		}]];
	}
};
function goesOn(parts, records) {
	return parts.has(RUNNING) && likeOf(objectOf(parts.get(RUNNING), "running").records, 0, "running.records") < records;
}
// www/block/files/keep-draft.ts
var DRAFT = "block/draft";
var LINK$1 = "block/link";
var OF_PLACE = 60;
function draftParts(draft, images) {
	return new Map(draft === null ? [] : [[DRAFT, keptDraft(draft, images)]]);
}
var keptDraft = remember(({ of, places }, images) => ({
	value: {
		of,
		places: [...places],
		images
	},
	bytes: OF_PLACE * (1 + places.size)
}));
function linkParts({ draft, chosen }) {
	return new Map(draft === null || chosen.image === null ? [] : [[LINK$1, keptLink(draft, chosen.image)]]);
}
var keptLink = remember(({ at, place }, image) => ({
	value: {
		image,
		at,
		place
	},
	bytes: 120
}));
function withLink(placing, parts) {
	if (!parts.has(LINK$1)) return placing;
	const kept = objectOf(parts.get(LINK$1), "link");
	const image = likeOf(kept.image, 0, "link.image");
	const [at, place] = [orNull(kept.at, (own) => positionFrom(own, "link.at")), orNull(kept.place, (own) => positionFrom(own, "link.place"))];
	return placing.placed.has(image) ? {
		...placing,
		draft: {
			at,
			place
		},
		chosen: {
			image,
			link: null
		}
	} : placing;
}
function draftFrom(parts, images) {
	if (!parts.has(DRAFT)) return null;
	const { of, places, images: shown } = objectOf(parts.get(DRAFT), "draft");
	const placed = listOf$1(places, "draft.places", (entry, name) => {
		const [image, place] = listOf$1(entry, name, (one) => one);
		const { at, by } = objectOf(place, name);
		const [x_px, y_px] = listOf$1(at, `${name}.at`, (one) => one);
		return placeFrom({
			image,
			x_px,
			y_px,
			by
		}, name);
	});
	const isThere = (image) => image < images;
	return {
		of: orNull(of, ofFrom),
		places: new Map(placed.flatMap(({ image, x_px, y_px, by }) => isThere(image) ? [[image, {
			at: [x_px, y_px],
			by
		}]] : [])),
		images: listOf$1(shown, "draft.images", (image, name) => likeOf(image, 0, name)).filter(isThere)
	};
}
function ofFrom(of) {
	return "given" in of ? { given: likeOf(of.given, "", "draft.of.given") } : sourceFrom(of, "draft.of");
}
// www/block/files/keep-former.ts
var FORMER = "block/former";
var SPOT = 60;
function formerParts(former, { edits }) {
	if (former.length === 0) return new Map();
	const isOfThem = former.some(({ history, kept }) => history.edits === edits || kept.edits === edits);
	return new Map([[FORMER, keptFormers(former, isOfThem ? edits : null)]]);
}
var keptFormers = remember((former, now) => ({
	value: {
		now: now === null ? "" : nameOf$2(now),
		former: former.map((one) => ({
			...one,
			historyName: nameOf$2(one.history.edits),
			keptName: nameOf$2(one.kept.edits)
		}))
	},
	bytes: former.reduce((sum, one) => sum + bytesOf(one), 0)
}));
function bytesOf({ history, kept, spots }) {
	const places = spots?.places.reduce((sum, { seen }) => sum + SPOT * seen.length, 0) ?? 0;
	return [...history.edits, ...kept.edits].reduce((sum, step) => sum + bytesOfStep(step), places);
}
function formerFrom(parts, history) {
	if (!parts.has(FORMER)) return [];
	const value = objectOf(parts.get(FORMER), "former");
	const now = likeOf(value.now, "", "former.now");
	const lists = new Map(now === "" ? [] : [[now, history.edits]]);
	if (now !== "") nameOf$2(history.edits, now);
	const historyFrom = (own, called, name) => {
		const { edits, done } = objectOf(own, name);
		const list = likeOf(called, "", `${name}.name`);
		const read = lists.get(list) ?? listOf$1(edits, `${name}.edits`, stepFrom);
		lists.set(list, read);
		nameOf$2(read, list);
		return {
			edits: read,
			done: doneFrom(done, read.length, `${name}.done`)
		};
	};
	return listOf$1(value.former, "former", (one, name) => {
		const { tiePoints, names, history: own, kept: left, left: counts, places, spots, historyName, keptName } = objectOf(one, name);
		return {
			tiePoints: likeOf(tiePoints, "", `${name}.tiePoints`),
			names: namesFrom(names, `${name}.names`),
			history: historyFrom(own, historyName, `${name}.history`),
			kept: historyFrom(left, keptName, `${name}.kept`),
			left: listOf$1(counts, `${name}.left`, (count, at) => likeOf(count, 0, at)),
			places: listOf$1(places, `${name}.places`, (place, at) => likeOf(place, 0, at)),
			spots: orNull(spots ?? null, (own) => placesFrom(own, `${name}.spots`))
		};
	});
}
function namesFrom(value, name) {
	const { images, surveyed, connected, givenControl, system } = objectOf(value, name);
	if (!(surveyed instanceof Map && connected instanceof Set)) throw new Error(say("the-field-is-damaged", { name }));
	return {
		images: listOf$1(images, `${name}.images`, (image, at) => likeOf(image, "", at)),
		surveyed: new Map([...surveyed].map(([point, called]) => [likeOf(point, 0, `${name}.surveyed`), likeOf(called, "", `${name}.surveyed`)])),
		connected: new Set([...connected].map((pair) => likeOf(pair, "", `${name}.connected`))),
		givenControl: likeOf(givenControl, 0, `${name}.givenControl`),
		system: orNull(system ?? null, (own) => likeOf(own, "", `${name}.system`))
	};
}
function placesFrom(value, name) {
	const places = objectOf(value, name);
	const { images, given, places: all } = places;
	listOf$1(images, `${name}.images`, (image, at) => likeOf(image, "", at));
	likeOf(given, 0, `${name}.given`);
	listOf$1(all, `${name}.places`, (place, at) => listOf$1(objectOf(place, at).seen, `${at}.seen`, objectOf));
	return places;
}
// www/block/files/keep-placing.ts
var PURPOSES$1 = [
	"block",
	"images",
	"map"
];
var LINK = 57;
var SMALL$1 = 2048;
function rastersOf({ orthophoto, heights }) {
	return [...orthophoto === null ? [] : [orthophoto.raster], ...heights.kind === "model" ? [heights.model] : []];
}
function keptPlacing(orthophoto, heights, film, options, purpose) {
	return {
		orthophoto: orNull(orthophoto, ({ raster, info, ofBlock }) => ({
			raster: keptRaster(raster),
			info,
			ofBlock
		})),
		heights: heights.kind === "level" ? heights : {
			kind: "model",
			model: keptRaster(heights.model)
		},
		film,
		options,
		purpose
	};
}
function keptRaster({ id, name, file, world, projection, degrees = null }) {
	return {
		id,
		name,
		file: nameOf$2(file),
		world,
		projection,
		degrees
	};
}
function sizeOfPlaced({ result }) {
	return SMALL$1 + LINK * (result?.placement?.links.count ?? 0);
}
function placingFrom(given, placed, catalogue, readFile, open) {
	const none = {
		...NO_PLACING,
		options: catalogue.placing
	};
	if (given === void 0) return none;
	const kept = objectOf(given, "placing");
	const raster = (value, name) => {
		const { world, projection, degrees } = objectOf(value, name);
		return {
			...open(readFile(value, name)),
			world: orNull(world, (text) => textFrom(text, `${name}.world`)),
			projection: orNull(projection ?? null, (text) => textFrom(text, `${name}.projection`)),
			degrees: orNull(degrees ?? null, (own) => degreesFrom(own, `${name}.degrees`))
		};
	};
	const orthophoto = orNull(kept.orthophoto, (value) => {
		const { raster: picture, info, ofBlock } = objectOf(value, "placing.orthophoto");
		return {
			raster: raster(picture, "placing.orthophoto.raster"),
			info: objectOf(info, "placing.orthophoto.info"),
			ofBlock: orNull(ofBlock, (key) => likeOf(key, "", "placing.orthophoto.ofBlock"))
		};
	});
	const { kind, height, by, model } = objectOf(kept.heights, "placing.heights");
	const heights = kind === "model" ? {
		kind,
		model: raster(model, "placing.heights.model")
	} : {
		kind: "level",
		height: likeOf(height, 0, "placing.heights.height"),
		...by === "hand" || by === "block" ? { by } : {}
	};
	const options = orNull(kept.options, (value) => fitted$1(value, catalogue.placing, "placing.options")) ?? catalogue.placing;
	const purpose = PURPOSES$1.find((one) => one === kept.purpose) ?? null;
	return {
		...none,
		orthophoto,
		heights,
		options: same(options, catalogue),
		purpose,
		film: filmFrom(kept.film),
		placed: placedFrom(placed)
	};
}
function filmFrom(given) {
	if (given === void 0) return NO_FILM;
	const { camera, marks, areScans, begun = [] } = objectOf(given, "placing.film");
	return {
		camera: orNull(camera, (text) => textFrom(text, "placing.film.camera")),
		marks: listOf$1(marks, "placing.film.marks", textFrom),
		areScans: areScans === true,
		begun: listOf$1(begun, "placing.film.begun", begunFrom)
	};
}
function begunFrom(given, name) {
	const { image, marks } = objectOf(given, name);
	return {
		image: likeOf(image, "", `${name}.image`),
		marks: listOf$1(marks, `${name}.marks`, markFrom)
	};
}
function markFrom(given, name) {
	const mark = objectOf(given, name);
	const number = (value) => typeof value === "number" ? value : NaN;
	return {
		col: number(mark.col),
		row: number(mark.row),
		x_mm: number(mark.x_mm),
		y_mm: number(mark.y_mm)
	};
}
function textFrom(given, name) {
	const { name: called, text } = objectOf(given, name);
	return {
		name: likeOf(called, "", `${name}.name`),
		text: likeOf(text, "", `${name}.text`)
	};
}
function degreesFrom(given, name) {
	const { crs, georeference, shownIn, world, departs } = objectOf(given, name);
	return {
		crs: likeOf(crs, "", `${name}.crs`),
		georeference: objectOf(georeference, `${name}.georeference`),
		shownIn: likeOf(shownIn, "", `${name}.shownIn`),
		world: likeOf(world, "", `${name}.world`),
		departs: likeOf(departs, 0, `${name}.departs`)
	};
}
function same(options, { placing }) {
	return JSON.stringify(options) === JSON.stringify(placing) ? placing : options;
}
function placedFrom(parts) {
	return new Map([...parts].map(([id, value]) => {
		const name = `placed ${String(id)}`;
		const { key, result, problem } = objectOf(value, name);
		likeOf(key, "", `${name}.key`);
		likeOf(problem, "", `${name}.problem`);
		orNull(result, (found) => objectOf(found, `${name}.result`));
		const placed = value;
		likeOf(placed.done, 0, `${name}.done`);
		listOf$1(placed.steps, `${name}.steps`, objectOf);
		return [id, placed];
	}));
}
// www/block/files/keep-steps.ts
var OF_FILE = 120;
var keptSteps = new WeakMap();
function keptMarkSteps(keptFile) {
	const framing = ({ images, masks, steps, ...texts }) => ({
		...texts,
		images: images.map(keptFile),
		masks: masks.map(keptFile),
		steps: steps.map(kept)
	});
	const kept = (step) => {
		if (!isFramesStep(step)) return step;
		const own = keptSteps.get(step) ?? {
			...step,
			scans: framing(step.scans),
			frames: framing(step.frames)
		};
		keptSteps.set(step, own);
		return own;
	};
	return remember(({ edits, done }) => ({
		edits: edits.map(kept),
		done
	}));
}
function markStepsFrom({ edits, done }, fileFrom) {
	const framing = ({ images, masks, steps, ...texts }) => ({
		...texts,
		images: images.map(fileFrom),
		masks: masks.map(fileFrom),
		steps: steps.map(own)
	});
	const own = (kept) => {
		if (kept.kind !== "make_frames") return kept;
		const step = {
			...kept,
			scans: framing(kept.scans),
			frames: framing(kept.frames)
		};
		keptSteps.set(step, kept);
		return step;
	};
	return {
		edits: edits.map(own),
		done
	};
}
var filesOfSteps = remember(({ edits }) => edits.filter(isFramesStep).flatMap(({ scans, frames }) => [
	...scans.images,
	...scans.masks,
	...frames.images,
	...frames.masks
]));
function bytesOfKept(step) {
	if (step.kind !== "make_frames") return bytesOfMarks(step);
	return [step.scans, step.frames].reduce((sum, { images, masks, cameras, marks, film, steps }) => {
		const texts = [
			cameras,
			marks,
			film.camera,
			...film.marks
		].reduce((length, text) => length + (text?.text.length ?? 0), 0);
		return sum + OF_FILE * (images.length + masks.length) + texts + steps.reduce((bytes, one) => bytes + bytesOfKept(one), 0);
	}, 0);
}
function keptStepFrom(fileOf) {
	const framing = (value, name) => {
		const { images, masks, cameras, marks, film, steps } = objectOf(value, name);
		return {
			images: listOf$1(images, `${name}.images`, fileOf),
			masks: listOf$1(masks, `${name}.masks`, fileOf),
			cameras: orNull(cameras, (text) => textFrom(text, `${name}.cameras`)),
			marks: orNull(marks, (text) => textFrom(text, `${name}.marks`)),
			film: filmFrom(film),
			steps: listOf$1(steps, `${name}.steps`, stepFrom)
		};
	};
	const stepFrom = (value, name) => {
		const { kind, scans, frames, after } = objectOf(value, name);
		if (kind !== "make_frames") return markStepFrom(value, name);
		return {
			kind,
			scans: framing(scans, `${name}.scans`),
			frames: framing(frames, `${name}.frames`),
			after: likeOf(after, 0, `${name}.after`)
		};
	};
	return stepFrom;
}
// www/block/files/keep.ts
var GIVEN = "block";
var SHOWN = "block/shown";
var PLACED = "block/placed/";
var FILE = "block/file/";
var RECORD = "block/record/";
var SMALL = 4096;
var KeptBlocks = class {
	store;
	engine;
	catalogue;
	end;
	run;
	mode = "block";
	made = null;
	journal = new Journal("block/edits", stepFrom, bytesOfStep);
	marks = new Journal("block/marks", keptStepFrom(fileOf$2), bytesOfKept);
	keptMarks = keptMarkSteps(keptFile);
	underWay;
	making = null;
	changed = () => void 0;
	constructor(store, engine, catalogue, end, run) {
		this.store = store;
		this.engine = engine;
		this.catalogue = catalogue;
		this.end = end;
		this.run = run;
		this.underWay = new RunUnderWay(store, engine);
	}
	watch(changed) {
		this.changed = changed;
		this.engine.watchRecords(changed);
		this.store.watch([
			"files",
			"options",
			"flight",
			"truth",
			"shown",
			"opened",
			"running",
			"history",
			"former",
			"marks",
			"draft",
			"panes",
			"placing"
		], () => {
			changed();
			this.settled();
		});
	}
	async settled() {
		const { shown, running } = this.store.state;
		if (shown === null || shown.view.partial || running.kind === "yes" || this.made?.found === shown.found) return;
		const before = this.making;
		this.making ??= this.make(shown).finally(() => {
			this.making = null;
		});
		await this.making;
		if (before !== null || this.store.state.shown?.found !== shown.found) await this.settled();
	}
	images() {
		const { files, shown, placing } = this.store.state;
		const names = (files.length > 0 ? files : shown?.view.images ?? []).map(({ name }) => name);
		return names.length === 0 && placing.orthophoto !== null ? [placing.orthophoto.raster.name] : names;
	}
	parts() {
		const { state } = this.store;
		const parts = new Map();
		if (isBlank(state)) return parts;
		const { files, removed, options, flight, truth, opened, shown, placing } = state;
		parts.set(GIVEN, {
			value: given$1(files, removed, options, flight, truth, opened, placing.orthophoto, placing.heights, placing.film, placing.options, placing.purpose),
			bytes: SMALL
		});
		for (const [id, placed] of placing.placed) parts.set(PLACED + String(id), {
			value: placed,
			bytes: sizeOfPlaced(placed)
		});
		if (truth !== null) parts.set(FILE + nameOf$2(truth), {
			value: truth,
			bytes: SMALL,
			alone: true
		});
		for (const { file } of [
			...files,
			...removed,
			...besidesOf(options),
			...shown?.files ?? [],
			...rastersOf(placing),
			...filesOfSteps(state.marks)
		]) parts.set(FILE + nameOf$2(file), {
			value: file,
			bytes: file.size,
			alone: true
		});
		const { made } = this;
		for (const [name, part] of this.journal.parts(state.history)) parts.set(name, part);
		for (const [name, part] of this.marks.parts(this.keptMarks(state.marks))) parts.set(name, part);
		for (const [name, part] of formerParts(state.former, state.history)) parts.set(name, part);
		for (const [name, part] of [
			...draftParts(state.draft, state.panes.images),
			...linkParts(placing),
			...this.underWay.parts()
		]) parts.set(name, part);
		if (made !== null && made.found === shown?.found) parts.set(SHOWN, {
			value: made.kept,
			bytes: SMALL + made.kept.project.size + (made.kept.ground?.before.size ?? 0)
		});
		if (files.length > 0) for (const [key, record] of this.engine.records) parts.set(RECORD + key, {
			value: record,
			bytes: record.size,
			again: true
		});
		return parts;
	}
	async read(parts, looks) {
		if (!parts.has(GIVEN)) return () => void 0;
		const kept = givenFrom(parts.get(GIVEN), this.catalogue);
		const files = kept.files.map((file) => fileFrom(parts, file));
		const removed = kept.removed.map((file) => fileFrom(parts, file));
		const masks = kept.masks.map((file) => fileFrom(parts, file));
		const geoid = orNull(kept.geoid, (file) => fileFrom(parts, file));
		const placed = new Map([...parts].flatMap(([part, value]) => part.startsWith(PLACED) ? [[Number(part.slice(13)), value]] : []));
		const placing = withLink(withPresentKeys(placingFrom(kept.placing, placed, this.catalogue, fileOf$2, (file) => fileFrom(parts, file)), files, kept.options), parts);
		const history = this.journal.read(parts);
		const marks = markStepsFrom(this.marks.read(parts), (file) => fileFrom(parts, file));
		const { former, damage } = formerOrNone(parts, history);
		const finished = await this.finished(parts, history);
		const truth = orNull(kept.truth, (name) => truthFrom(parts, name));
		const records = new Map([...parts].flatMap(([part, record]) => part.startsWith(RECORD) && record instanceof Blob ? [[part.slice(13), record]] : []));
		const shown = finished?.shown ?? null;
		const runs = !looks && shown === null && goesOn(parts, records.size);
		const count = shown?.view.images.length ?? 0;
		const draft = shown === null ? null : draftFrom(parts, count);
		const opened = kept.opened?.every((image) => image < count) === true ? kept.opened : null;
		return () => {
			passIds([
				...files,
				...removed,
				...besidesOf({
					masks,
					geoid
				}),
				...shown?.files ?? [],
				...rastersOf(placing),
				...filesOfSteps(marks)
			].map(({ id }) => id));
			this.engine.takeRecords(records);
			this.made = finished === null ? null : {
				found: finished.shown.found,
				kept: finished.kept
			};
			finished?.hold();
			this.engine.keepSpare(finished?.kept.project ?? null);
			this.store.dispatch({
				type: "restored",
				restored: {
					files,
					removed,
					options: {
						...kept.options,
						masks,
						geoid
					},
					flight: kept.flight,
					truth,
					shown,
					opened,
					history,
					former,
					marks,
					draft,
					placing
				}
			});
			const names = this.images();
			if (names.length === 0) return;
			const work = records.size > 0 && shown === null ? say("the-work-that-was-done") : "";
			const restored = say("restored-from-this-browser", {
				title_of: titleOf$2({
					name: null,
					images: names
				}),
				goes_on: runs ? "" : work
			});
			const text = damage === "" ? restored : `${restored} ${damage}`;
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "info",
					text,
					beside: true
				}
			});
			if (runs) queueMicrotask(this.run);
		};
	}
	clear() {
		this.made = null;
		this.engine.keepSpare(null);
		this.end();
		this.engine.takeRecords(new Map());
		this.store.dispatch({ type: "cleared" });
	}
	async make(shown) {
		try {
			const project = await this.engine.project();
			const { key, tiePoints, files, steps, seconds, view, ground } = shown;
			if (this.store.state.shown?.found === shown.found) this.made = {
				found: shown.found,
				kept: {
					project,
					key,
					tiePoints,
					files: files.map(keptFile),
					steps,
					seconds,
					score: view.score,
					ground
				}
			};
		} catch {}
		this.changed();
		if (this.made?.found === this.store.state.shown?.found) this.engine.keepSpare(this.made?.kept.project ?? null);
	}
	async finished(parts, history) {
		if (!parts.has(SHOWN)) return null;
		const value = objectOf(parts.get(SHOWN), "shown");
		const { project } = value;
		if (!(project instanceof Blob)) throw new Error(say("the-finished-block-is-damaged"));
		const kept = {
			project,
			key: likeOf(value.key, "", "shown.key"),
			tiePoints: likeOf(value.tiePoints ?? "", "", "shown.tiePoints"),
			files: listOf$1(value.files, "shown.files", fileOf$2),
			steps: objectOf(value.steps, "shown.steps"),
			seconds: likeOf(value.seconds, 0, "shown.seconds"),
			score: orNull(value.score, (score) => objectOf(score, "shown.score")),
			ground: orNull(value.ground, groundFrom)
		};
		const files = kept.files.map((file) => fileFrom(parts, file));
		const opened = await this.engine.read(new Uint8Array(await project.arrayBuffer()));
		const { key, tiePoints, steps, seconds, score, ground } = kept;
		const view = {
			...opened.view,
			score
		};
		return {
			shown: {
				key,
				files,
				steps,
				seconds,
				view,
				given: NONE_GIVEN,
				found: view,
				tiePoints,
				edits: theSame(opened.steps.flat(), history.edits.flat()),
				ground
			},
			kept: value,
			hold: opened.hold
		};
	}
};
function formerOrNone(parts, history) {
	try {
		return {
			former: formerFrom(parts, history),
			damage: ""
		};
	} catch (error) {
		return {
			former: [],
			damage: say("edits-of-former-blocks-are-left-out", { error: messageOf(error) })
		};
	}
}
function theSame(edits, history) {
	return edits.map((edit, i) => {
		const known = history[i];
		return known !== void 0 && JSON.stringify(known) === JSON.stringify(edit) ? known : edit;
	});
}
function groundFrom(value) {
	const { key, before, places, verdicts } = objectOf(value, "shown.ground");
	if (!(before instanceof Blob)) throw new Error(say("the-finished-block-is-damaged"));
	return {
		key: likeOf(key, "", "shown.ground.key"),
		before,
		places: orNull(places ?? null, (own) => placesFrom(own, "shown.ground.places")),
		verdicts: listOf$1(verdicts ?? [], "shown.ground.verdicts", (one, name) => {
			const { name: image, verdict } = objectOf(one, name);
			return {
				name: likeOf(image, "", `${name}.name`),
				verdict: objectOf(verdict, `${name}.verdict`)
			};
		})
	};
}
function besidesOf({ masks, geoid }) {
	return geoid === null ? masks : [...masks, geoid];
}
function keptFile({ id, name, file }) {
	return {
		id,
		name,
		file: nameOf$2(file)
	};
}
var given$1 = remember((files, removed, { masks, geoid, ...options }, flight, truth, opened, orthophoto, heights, film, placing, purpose) => ({
	files: files.map(keptFile),
	removed: removed.map(keptFile),
	options,
	masks: masks.map(keptFile),
	geoid: orNull(geoid, keptFile),
	flight,
	truth: orNull(truth, (known) => nameOf$2(known)),
	opened,
	placing: keptPlacing(orthophoto, heights, film, placing, purpose)
}));
function fileOf$2(value, name) {
	const { id, name: called, file } = objectOf(value, name);
	return {
		id: likeOf(id, 0, `${name}.id`),
		name: likeOf(called, "", `${name}.name`),
		file: likeOf(file, "", `${name}.file`)
	};
}
function givenFrom(value, catalogue) {
	const kept = objectOf(value, "block");
	const options = objectOf(kept.options, "options");
	const text = (name) => orNull(options[name], (given) => {
		const { name: called, text: content } = objectOf(given, `options.${name}`);
		return {
			name: likeOf(called, "", `options.${name}.name`),
			text: likeOf(content, "", `options.${name}.text`)
		};
	});
	const opened = orNull(kept.opened, (pair) => listOf$1(pair, "opened", (image, name) => likeOf(image, 0, name)));
	return {
		files: listOf$1(kept.files, "files", fileOf$2),
		removed: listOf$1(kept.removed ?? [], "removed", fileOf$2),
		masks: listOf$1(kept.masks, "masks", fileOf$2),
		geoid: orNull(kept.geoid ?? null, (file) => fileOf$2(file, "geoid")),
		options: {
			settings: orNull(options.settings, (settings) => fitted$1(settings, catalogue.defaults, "options.settings")),
			gps: options.gps === "ignore" ? "ignore" : "use",
			cameras: text("cameras"),
			control: text("control"),
			marks: text("marks"),
			positions: options.positions === void 0 ? null : text("positions")
		},
		flight: orNull(kept.flight, (flight) => fitted$1(flight, catalogue.flight, "flight")),
		truth: orNull(kept.truth, (name) => likeOf(name, "", "truth")),
		opened: opened?.length === 2 ? opened : null,
		placing: kept.placing
	};
}
function fileFrom(parts, { id, name, file: at }) {
	const file = parts.get(FILE + at);
	if (!(file instanceof Blob)) throw new Error(say("the-image-is-damaged", { name }));
	nameOf$2(file, at);
	return {
		id,
		name,
		file
	};
}
function truthFrom(parts, name) {
	const truth = objectOf(parts.get(FILE + name), "truth");
	nameOf$2(truth, name);
	return truth;
}
// www/block/files/runs.ts
var BlockRuns = class {
	store;
	engine;
	images;
	block;
	ground;
	constructor(store, engine, images, block, ground) {
		this.store = store;
		this.engine = engine;
		this.images = images;
		this.block = block;
		this.ground = ground;
	}
	run(here) {
		return unlessLeft(this.runBlock(here));
	}
	placeImages(here) {
		return unlessLeft(this.placeEach(here));
	}
	takeOff(here) {
		return unlessLeft(this.takeBlockOff(here));
	}
	async runBlock(here) {
		const { state } = this.store;
		if (purposeOf(state) === "block") this.store.dispatch({
			type: "purpose",
			purpose: "block"
		});
		if (state.onStage === "orthophoto") this.store.dispatch({
			type: "stage",
			view: "map"
		});
		const runs = !lacksPlaceAlone(state);
		if (runs) await this.engine.run();
		here();
		const { running, notice } = this.store.state;
		const said = runs && notice?.beside === true ? notice.text : "";
		if (running.kind === "no" && lacksPlaceAlone(this.store.state)) await this.placeBlock(here, said);
	}
	async placeEach(here) {
		this.store.dispatch({
			type: "purpose",
			purpose: "images"
		});
		this.store.dispatch({
			type: "stage",
			view: "orthophoto"
		});
		this.store.dispatch({
			type: "notice",
			notice: null
		});
		try {
			if (this.ground.hasOtherLevel() && await this.ground.takeLevelOfBlock(here) === null) return;
			const done = await this.images.place();
			here();
			if (done === null) this.tell("info", say("cancelled-what-was-placed-stays"));
		} catch (error) {
			here();
			this.tell("problem", say("nothing-was-placed", { sentence: sentence(messageOf(error)) }));
		}
	}
	async takeBlockOff(here) {
		this.tell("busy", say("taking-the-block-off-the"));
		try {
			await this.block.takeOff();
			here();
			if (this.store.state.notice?.kind === "busy") this.store.dispatch({
				type: "notice",
				notice: null
			});
		} catch (error) {
			here();
			this.tell("problem", say("the-block-stays-as-it", { sentence: sentence(messageOf(error)) }));
		}
	}
	async placeBlock(here, said) {
		const andSaid = (text) => [text, said].join(" ").trimEnd();
		if (imagesOfBlock(this.store.state).length === 0) {
			this.tell("info", andSaid(say("a-block-is-placed-by")), true);
			return;
		}
		this.store.dispatch({
			type: "notice",
			notice: null
		});
		try {
			const isPlaced = await this.block.place();
			here();
			if (!isPlaced) this.tell("info", andSaid(say("cancelled-the-block-is-as")), true);
		} catch (error) {
			here();
			this.tell("problem", andSaid(say("the-block-stays-as-it", { sentence: sentence(messageOf(error)) })));
		}
	}
	tell(kind, text, beside = false) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind,
				text,
				...beside ? { beside } : {}
			}
		});
	}
};
// www/block/state/address.ts
var VIEWS = [
	"map",
	"matrix",
	"images",
	"plots",
	"orthophoto"
];
var MOST_POINTS = 100;
var MOST_IMAGES = 50;
var MOST_PAIRS = 25;
var places$1 = remember((numbers) => new Map([...numbers].map((number, point) => [number, point])));
function addressOf({ shown, onStage, selection: { chosen } }) {
	if (shown === null) return "";
	const named = new URLSearchParams({ view: onStage });
	const name = (image) => shown.view.images[image]?.name ?? "";
	const { numbers } = shown.view.points;
	const points = chosen?.kind === "observations" ? new Uint32Array() : pointsOf(chosen);
	if (points.length > 0 && points.length <= MOST_POINTS) named.set("point", [...points].map((point) => String(numbers[point] ?? 0)).join(","));
	if (chosen?.kind === "image" || chosen?.kind === "observation") named.append("image", name(chosen.image));
	if (chosen?.kind === "images" && chosen.images.length <= MOST_IMAGES) for (const image of chosen.images) named.append("images", name(image));
	if (chosen?.kind === "pair") for (const image of chosen.images) named.append("image", name(image));
	if (chosen?.kind === "pairs" && chosen.pairs.length <= MOST_PAIRS) for (const image of chosen.pairs.flat()) named.append("pairs", name(image));
	return named.toString();
}
var PAIR = "pair";
function addressOfPair({ images }, pair) {
	const named = new URLSearchParams({ view: PAIR });
	for (const image of pair) named.append("image", images[image]?.name ?? "");
	return named.toString();
}
function isOtherPage(address, other) {
	const [a, b] = [address, other].map((one) => {
		const named = new URLSearchParams(one.replace(/^#/u, ""));
		const view = named.get("view") ?? "";
		return [view, ...view === PAIR ? named.getAll("image") : []];
	});
	const views = [a?.[0], b?.[0]];
	if (views.includes("") && views.includes(PAIR)) return false;
	return String(a) !== String(b);
}
function viewNamed(address) {
	const named = new URLSearchParams(address.replace(/^#/u, ""));
	return VIEWS.find((name) => name === named.get("view"));
}
function askedPair(address, view) {
	const named = new URLSearchParams(address.replace(/^#/u, ""));
	const [a = -1, b = -1] = named.getAll("image").map((name) => view.images.findIndex((image) => image.name === name));
	return named.get("view") !== PAIR || a < 0 || b < 0 || a === b ? null : [a, b];
}
function asked(address, view) {
	const wanted = viewNamed(address);
	if (wanted === void 0) return null;
	const named = new URLSearchParams(address.replace(/^#/u, ""));
	const indexOf = (name) => view.images.findIndex((image) => image.name === name);
	const images = named.getAll("image").map(indexOf);
	const several = named.getAll("images").map(indexOf).filter((image) => image >= 0);
	const ofPairs = named.getAll("pairs").map(indexOf);
	const pairs = ofPairs.flatMap((a, at) => at % 2 === 0 ? [[a, ofPairs[at + 1] ?? -1]] : []).filter((pair) => !pair.includes(-1));
	const points = (named.get("point") ?? "").split(",").map((number) => places$1(view.points.numbers).get(Number(number)) ?? -1).filter((point) => point >= 0);
	if (pairs.length > 0) return {
		view: wanted,
		choice: choiceOfPairs(pairs)
	};
	return {
		view: wanted,
		choice: several.length > 0 ? choiceOfImages(several) : choiceOf$2(images, points)
	};
}
function choiceOf$2(images, points) {
	const [image, other] = images;
	const [point] = points;
	if (images.includes(-1)) return null;
	if (point !== void 0 && image !== void 0) return {
		kind: "observation",
		point,
		image
	};
	if (point !== void 0) return choiceOfPoints(points);
	if (image === void 0) return null;
	return other === void 0 ? {
		kind: "image",
		image
	} : {
		kind: "pair",
		images: [image, other]
	};
}
// www/block/panel/address.ts
function mountAddress(store, modes, pair) {
	let waiting = window.location.hash === "" ? null : {
		address: window.location.hash,
		part: null
	};
	let isViewed = false;
	let isFollowing = false;
	let isMissed = false;
	let isOpening = false;
	let later = null;
	let hadBlock = null;
	const goTo = (wanted) => {
		if (isOpening) later = wanted;
		waiting = wanted;
		isViewed = false;
		tell();
	};
	const show = async (images) => {
		if (isOpening) return;
		const isThere = isShown(store, pair) || pair.names().every((name) => name === null);
		if (String(store.state.opened) === String(images) && isThere) {
			modes.dispatch("pair");
			return;
		}
		isOpening = true;
		try {
			await pair.open(images);
		} finally {
			isOpening = false;
			const next = later;
			later = null;
			if (next === null) tell(false);
			else goTo(next);
		}
	};
	const follow = ({ address, part }) => {
		const { shown, history, draft } = store.state;
		if (address === "") {
			waiting = null;
			modes.dispatch(part ?? "pair");
			return;
		}
		if (shown === null || shown.view.partial) {
			if (part !== null) showPart(part, address);
			return;
		}
		const wanted = asked(address, shown.view);
		if (wanted !== null && !isViewed) {
			isViewed = true;
			modes.dispatch("block");
			store.dispatch({
				type: "stage",
				view: wanted.view
			});
		}
		if (!isSameList(editsInForce(history), shown.edits)) return;
		const images = askedPair(address, shown.view);
		waiting = null;
		if (images !== null) show(images);
		if (wanted !== null && (draft === null || part !== null)) store.dispatch({
			type: "choose",
			choice: wanted.choice
		});
	};
	const showPart = (part, address) => {
		waiting = null;
		modes.dispatch(part);
		const view = viewNamed(address);
		if (view !== void 0) store.dispatch({
			type: "stage",
			view
		});
	};
	const tell = (turns = true) => {
		if (isFollowing) isMissed = true;
		else if (waiting === null) put(turns);
		else {
			isFollowing = true;
			isMissed = false;
			follow(waiting);
			queueMicrotask(() => {
				isFollowing = false;
				if (waiting !== null && isMissed) tell(false);
				else put(false);
			});
		}
	};
	const put = (turns) => {
		if (waiting !== null || isOpening) return;
		const hasBlock = store.state.shown !== null;
		const { mode } = modes.state;
		write(mode, mode === "block" ? addressOf(store.state) : addressNow(store, pair), turns && hadBlock === hasBlock);
		hadBlock = hasBlock;
	};
	window.addEventListener("popstate", ({ state }) => {
		const part = partOf$1(state);
		if (part !== null) goTo({
			address: window.location.hash,
			part
		});
	});
	window.addEventListener("hashchange", () => {
		if (partOf$1(window.history.state) === null) goTo({
			address: window.location.hash,
			part: null
		});
	});
	store.watch([
		"shown",
		"onStage",
		"selection",
		"history",
		"opened"
	], () => tell());
	modes.watch(["mode"], () => tell(!modes.state.isKept));
	pair.watch(() => tell());
}
function partOf$1(entry) {
	const part = typeof entry === "object" && entry !== null && "part" in entry ? entry.part : null;
	return typeof part === "string" && isMode(part) ? part : null;
}
function write(part, address, turns) {
	const { hash, pathname, search } = window.location;
	const before = partOf$1(window.history.state);
	if (hash === (address === "" ? "" : `#${address}`) && before === part) return;
	const to = address === "" ? pathname + search : `#${address}`;
	const isOther = before !== null && before !== part || isOtherPage(hash, address);
	if (turns && isOther) window.history.pushState({ part }, "", to);
	else window.history.replaceState({ part }, "", to);
}
function addressNow(store, pair) {
	const { shown, opened } = store.state;
	return shown === null || opened === null || !isShown(store, pair) ? "" : addressOfPair(shown.view, opened);
}
function isShown({ state: { shown, opened } }, pair) {
	const names = opened?.map((image) => shown?.view.images[image]?.name) ?? [];
	return names.length > 0 && names.every((name, i) => name === pair.names()[i]);
}
// www/block/panel/dock.ts
var TABLES = [
	["images", say("images-2")],
	["pairs", say("pairs")],
	["points", say("points")],
	["observations", say("observations")],
	["surveyed", say("control-and-check-points")]
];
var HEIGHT = "tiepoint-dock";
var TAB = "tiepoint-table";
var STEP$2 = 24;
var LEAST = 170;
var ABOVE = 240;
function makeDock(store, looking, facts, others) {
	const sources = TABLES.map(([subject, title]) => subject === "observations" ? observationSource(facts, () => draw()) : sourceOf(subject, title));
	const { element, panels } = tabbed("dock", say("tables"), [...sources.map(({ subject, title }) => [`block-${subject}`, title]), ...others.map(({ id, title }) => [id, title])]);
	element.prepend(splitter(element));
	declareLack(panels.slice(0, sources.length), () => lackOfBlock(store.state));
	const tables = sources.map((source, i) => oneTable(panels[i] ?? element, store, looking, facts, source));
	const further = others.map((other, i) => other.make(panels[sources.length + i] ?? element));
	const draw = () => {
		for (const table of [...tables, ...further]) table.draw();
	};
	let isFallback = false;
	element.addEventListener("click", (event) => {
		const tab = event.target.closest("[role=\"tab\"]");
		if (tab === null) return;
		if (!isFallback) keepChoice(TAB, tab.id);
		draw();
	});
	facts.watch(() => {
		for (const table of tables) table.refresh();
	});
	watchDrawers(() => {
		if (isOpen("table")) queueMicrotask(draw);
	});
	const tabs = [...element.querySelectorAll("[role=\"tab\"]")];
	store.watch((s) => [
		s.shown,
		s.onStage,
		blockOnOrthophoto(s) !== null
	], ([shown, onStage, isBlockOn]) => {
		const own = others.map(({ view }) => view);
		const isOwn = own.includes(onStage) && !isBlockOn;
		tabs.forEach((tab, i) => {
			const view = own[i - sources.length];
			tab.hidden = view === void 0 ? isOwn || sources[i]?.subject === "surveyed" && (shown?.view.surveyed.length ?? 0) + (shown?.given.length ?? 0) === 0 : !isOwn || view !== onStage;
		});
		const selected = tabs.find((tab) => tab.getAttribute("aria-selected") === "true");
		const seen = tabs.filter((tab) => !tab.hidden);
		const wanted = seen.find(({ id }) => id === keptChoice(TAB)) ?? (selected?.hidden === true ? seen[0] : selected);
		if (wanted === selected) return;
		isFallback = true;
		wanted?.click();
		isFallback = false;
	});
	return element;
}
function sourceOf(subject, title) {
	return {
		subject,
		title,
		rows: (shown) => rowsOf(subject, shown),
		keeps: ({ view }, selection) => subject === "pairs" ? keptBy(subject, view, selection) : void 0,
		choice: (shown, row) => choiceOfRow(subject, shown, row),
		chosen: (shown, choice) => {
			const rows = rowsOfChoice(subject, shown, choice);
			return {
				has: (row) => rows.includes(row),
				first: rows[0] ?? -1
			};
		}
	};
}
function observationSource(facts, redraw) {
	let only = false;
	const press = toggle(say("of-what-is-chosen"), "block-observations-only", say("shows-the-observations-of-the"), (on) => {
		only = on;
		press.setAttribute("aria-pressed", String(on));
		redraw();
	});
	return {
		subject: "observations",
		title: say("observations"),
		rows: ({ view }) => {
			const of = facts.observations();
			return of === null ? NO_ROWS : observationRows(view, of);
		},
		keeps: (_, { chosen }) => {
			const of = facts.observations();
			return of === null || !only ? void 0 : observationsOf(of, chosen);
		},
		choice: (_, row) => {
			const of = facts.observations();
			const [point, image] = [of?.points[row], of?.images[row]];
			return point === void 0 || image === void 0 ? null : {
				kind: "observation",
				point,
				image
			};
		},
		chosen: (_, choice) => {
			const of = facts.observations();
			if (of === null || choice === null || pointsOf(choice).length === 0) return {
				has: () => false,
				first: -1
			};
			const ofPoints = observationsOf(of, choice);
			const isOne = choice.kind === "observation" || choice.kind === "observations" ? among(observationsIn(choice)) : null;
			const has = isOne === null ? ofPoints : (row) => isOne(of.points[row] ?? -1, of.images[row] ?? -1);
			return {
				has,
				first: of.points.findIndex((_, row) => has(row))
			};
		},
		tools: [press]
	};
}
function oneTable(host, store, looking, facts, source) {
	const { subject, title, tools = [] } = source;
	const ofRow = (row) => {
		const { shown } = store.state;
		return shown === null || row < 0 ? null : source.choice(shown, row);
	};
	const isInBlock = (row) => row < (store.state.shown?.view.images.length ?? 0);
	let own = null;
	let seeks = false;
	let chosen = {
		has: () => false,
		first: -1
	};
	const choose = (choice) => {
		own = choice;
		looking.choose(choice);
	};
	const sideways = sidewaysNote(`block-${subject}-sideways`);
	const table = new Table(host, {
		testid: `block-${subject}`,
		words: {
			table: title,
			region: say("table", { title })
		},
		file: `block-${subject}.csv`,
		...subject === "points" ? { order: "point" } : {},
		tools: [sideways, ...tools],
		point: (row) => looking.point(ofRow(row)),
		filter: (filter) => store.dispatch({
			type: "filter",
			subject,
			filter
		}),
		choose: (row) => choose(ofRow(row)),
		isChosen: (row) => chosen.has(row),
		...subject === "points" ? { chooseMore: (rows) => choose(withMore(store.state.selection.chosen, rows)) } : {},
		...subject === "observations" ? { chooseMore: (rows) => {
			const of = facts.observations();
			const more = {
				points: Uint32Array.from(rows, (row) => of?.points[row] ?? 0),
				images: Uint32Array.from(rows, (row) => of?.images[row] ?? 0)
			};
			if (of !== null) choose(withMoreObservations(store.state.selection.chosen, more));
		} } : {},
		...subject === "pairs" ? { chooseMore: (rows) => choose(withMorePairs(store.state.selection.chosen, rows.flatMap((row) => pairsOf(ofRow(row))))) } : {},
		...subject === "images" ? { chooseMore: (rows) => choose(withMoreImages(store.state.selection.chosen, rows.filter(isInBlock))) } : {}
	});
	watchSideways(sideways, table);
	let shownRows = NO_ROWS;
	const draw = whenInSight(host, () => {
		const { shown, selection } = store.state;
		shownRows = shown === null ? NO_ROWS : source.rows(shown);
		table.show(shownRows.count, shownRows.columns, shown === null ? void 0 : source.keeps(shown, selection), selection.filters[subject]);
		mark();
	});
	const mark = () => {
		const { shown, selection } = store.state;
		if (shown !== null) chosen = source.chosen(shown, selection.chosen);
		if (seeks && shown !== null) table.reveal(chosen.first);
		else table.redraw();
		seeks = false;
	};
	store.watch((s) => [
		s.shown,
		s.selection.filters[subject],
		subject === "pairs" ? s.selection.filters.images : null
	], () => draw());
	store.watch((s) => [s.selection.chosen], ([now]) => {
		seeks = now !== null && !isSame(now, own);
		own = null;
		if (subject === "observations" || isHidden(host)) draw();
		else mark();
	});
	const refresh = () => {
		const { shown } = store.state;
		if (isHidden(host) || shown !== null && source.rows(shown) !== shownRows) draw();
	};
	return {
		draw,
		refresh
	};
}
function splitter(dock) {
	const line = h("div", {
		class: "splitter",
		role: "separator",
		tabindex: 0,
		testid: "block-splitter",
		aria: {
			orientation: "horizontal",
			label: say("height-of-the-tables")
		}
	});
	const kept = Number(keptChoice(HEIGHT));
	const highest = () => Math.max(LEAST, (dock.parentElement?.clientHeight ?? Infinity) - ABOVE);
	const tell = () => {
		for (const [name, value] of [
			["min", LEAST],
			["max", highest()],
			["now", dock.clientHeight]
		]) line.setAttribute(`aria-value${name}`, String(Math.round(value)));
	};
	const set = (wanted) => {
		const height = Math.round(Math.min(highest(), Math.max(LEAST, wanted)));
		dock.style.height = `${String(height)}px`;
		tell();
		keepChoice(HEIGHT, String(height));
	};
	if (kept > 0) dock.style.height = `${String(kept)}px`;
	new ResizeObserver(tell).observe(dock);
	line.addEventListener("pointerdown", (event) => {
		const [from, height] = [event.clientY, dock.clientHeight];
		line.setPointerCapture(event.pointerId);
		const move = (moved) => set(height + from - moved.clientY);
		line.addEventListener("pointermove", move);
		line.addEventListener("lostpointercapture", () => line.removeEventListener("pointermove", move), { once: true });
	});
	line.addEventListener("keydown", (event) => {
		const by = {
			ArrowUp: STEP$2,
			ArrowDown: -24
		}[event.key];
		if (by === void 0) return;
		event.preventDefault();
		set(dock.clientHeight + by);
	});
	return line;
}
// www/block/panel/flight.ts
function mountFlight(host, store, files) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue === null) return;
		const sections = makeSections(catalogue.flightParameters, {
			change: (key, value) => {
				const { flight } = store.state;
				if (flight !== null) store.dispatch({
					type: "flight",
					flight: withSetting(flight, key, value)
				});
			},
			defaults: () => catalogue.flight
		});
		const take = button(say("photograph-this-block"), "block-photograph", () => void files.simulated.photograph());
		take.className = "primary";
		fill(host, h("p", { class: "note" }, say("a-flight-in-strips-over")), h("div", { class: "buttons" }, take), ...sections.elements);
		store.watch(["flight"], ([flight]) => {
			if (flight !== null) sections.show(flight);
		});
		store.watch([
			"running",
			"notice",
			"placing"
		], () => {
			take.disabled = isBusy(store.state);
		});
	});
}
// www/block/state/strongest.ts
function strongestPair(state) {
	const { shown } = state;
	if (shown === null || shown.view.partial) return null;
	const there = new Set(imagesOfBlock(state).map(({ name }) => name));
	const isThere = (image) => there.has(shown.view.images[image]?.name ?? "");
	const [first, ...others] = shown.view.connections.filter((connection) => matchesOf$1(connection) > 0 && !connection.rejected && connection.images.every(isThere));
	return first === void 0 ? null : others.reduce((best, other) => matchesOf$1(other) > matchesOf$1(best) ? other : best, first).images;
}
// www/block/state/pair-matches.ts
var SAME_PLACE_PX = 1.5;
var SAME_MEASUREMENT_PX = .01;
var REJECTED = 2;
var cellOf$1 = (x, y) => [Math.floor(x / SAME_PLACE_PX), Math.floor(y / SAME_PLACE_PX)];
var sharedPoints = remember((view, left, right) => {
	const rows = new Map([...right.points].map((point, row) => [point, row]));
	const cells = new Map();
	left.points.forEach((point, row) => {
		const [other, source] = [rows.get(point), sourceOf$1(view, point)];
		if (other === void 0 || source === null || "ground_control" in source) return;
		const [x = NaN, y = NaN] = left.places.subarray(2 * row, 2 * row + 2);
		const [xr = NaN, yr = NaN] = right.places.subarray(2 * other, 2 * other + 2);
		const key = cellOf$1(x, y).join(" ");
		const parts = [left.parts[row], right.parts[other]];
		const shared = {
			source,
			at: [
				x,
				y,
				xr,
				yr
			],
			isUsed: parts.every((part) => part === 0),
			isRejected: parts.includes(REJECTED)
		};
		cells.set(key, [...cells.get(key) ?? [], shared]);
	});
	return cells;
});
function apart([xl, yl, xr, yr], { at }) {
	return Math.max(Math.hypot(xl - at[0], yl - at[1]), Math.hypot(xr - at[2], yr - at[3]));
}
var AROUND = [
	-1,
	0,
	1
].flatMap((dy) => [
	-1,
	0,
	1
].map((dx) => [dx, dy]));
function pointsAbout(cells, [x, y]) {
	const [column, row] = cellOf$1(x, y);
	return AROUND.flatMap(([dx, dy]) => cells.get(`${String(column + dx)} ${String(row + dy)}`) ?? []);
}
function pointsAt(cells, place) {
	return pointsAbout(cells, place).filter((point) => apart(place, point) <= SAME_PLACE_PX).sort((a, b) => apart(place, a) - apart(place, b));
}
var measuredAt = (cells, place) => pointsAt(cells, place).filter((point) => apart(place, point) <= SAME_MEASUREMENT_PX);
function pointsOfRejected(cells, { rejected, used }) {
	const nearest = new Map();
	for (const place of rejected) for (const point of pointsAt(cells, place)) if (point.isUsed) nearest.set(point, Math.min(nearest.get(point) ?? Infinity, apart(place, point)));
	for (let row = 0; nearest.size > 0 && 5 * row < used.length; row++) {
		const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = used.subarray(5 * row, 5 * row + 4);
		const place = [
			xl,
			yl,
			xr,
			yr
		];
		for (const point of pointsAt(cells, place)) if (apart(place, point) < (nearest.get(point) ?? -Infinity)) nearest.delete(point);
	}
	return new Set(nearest.keys());
}
function movedPoint(cells, { of, had }, isFree) {
	const former = [...had].reverse();
	const isAtLeft = ({ source, at }, [x, y]) => "manual" in source && Math.hypot(x - at[0], y - at[1]) <= SAME_MEASUREMENT_PX;
	return [...former.flatMap((place) => measuredAt(cells, place)), ...former.flatMap((place) => pointsAbout(cells, place).filter((point) => isAtLeft(point, place)))].find((point) => !point.isRejected && isFree(point)) ?? (of === null ? void 0 : pointsAt(cells, of).find(({ isUsed }) => isUsed));
}
function additionOf(cells, a, b, match, isFree) {
	const { at } = match;
	if (measuredAt(cells, at).length > 0) return [];
	const places = [{
		image: a,
		x_px: at[0],
		y_px: at[1]
	}, {
		image: b,
		x_px: at[2],
		y_px: at[3]
	}];
	const moved = movedPoint(cells, match, isFree);
	if (moved === void 0) return pointsAt(cells, at).length > 0 ? [] : [{
		kind: "add_point",
		observations: places
	}];
	const isElsewhere = ({ x_px, y_px }, end) => Math.hypot(x_px - (moved.at[2 * end] ?? NaN), y_px - (moved.at[2 * end + 1] ?? NaN)) > SAME_MEASUREMENT_PX;
	return places.filter(isElsewhere).map((place) => ({
		kind: "measure",
		point: moved.source,
		...place
	}));
}
var forBlock = remember((view, a, b, left, right, matches) => {
	const cells = sharedPoints(view, left, right);
	const refused = pointsOfRejected(cells, matches);
	const observations = [...refused].flatMap(({ source }) => [a, b].map((image) => ({
		point: source,
		image
	})));
	let [joined, without] = [0, 0];
	for (const place of matches.rejected) {
		const points = pointsAt(cells, place);
		if (points.some((point) => refused.has(point))) joined += 1;
		else if (points.every(({ isUsed }) => isUsed)) without += 1;
	}
	const had = new Set(matches.measured.flatMap(({ at }) => measuredAt(cells, at)));
	const added = matches.measured.map((one) => additionOf(cells, a, b, one, (point) => !had.has(point))).filter((edits) => edits.length > 0);
	return {
		rejection: observations.length === 0 ? [] : [{
			kind: "reject_observations",
			observations
		}],
		matches: joined,
		without,
		addition: added.flat(),
		measured: added.length
	};
});
// www/block/panel/from-pair.ts
var NOTHING$1 = {
	rejection: [],
	matches: 0,
	without: 0,
	addition: [],
	measured: 0
};
function makeFromPair(store, facts, pair) {
	let given = null;
	const give = (step) => {
		if (store.state.draft !== null) store.dispatch({
			type: "accept",
			leaves: true
		});
		given = {
			step,
			to: store.state.shown?.found ?? null,
			of: pair.matches()
		};
		store.dispatch({
			type: "edit",
			edits: step
		});
	};
	const now = () => ofPair(store, facts, pair);
	const reject = button("", "matches-to-block", () => give(now().rejection), say("rejects-their-observations"));
	const add = button("", "measured-to-block", () => give(now().addition), say("they-become-tie-points"));
	const draw = (isOfBlock) => {
		const { matches, without, measured } = isOfBlock ? now() : NOTHING$1;
		reject.textContent = say("reject-matches-in-the-block", { matches });
		add.textContent = say("measured-matches-into-the-block", { matches: measured });
		reject.hidden = matches === 0;
		add.hidden = measured === 0;
		reject.disabled = add.disabled = isBusy(store.state);
		const rejected = isOfBlock ? pair.matches()?.rejected.length ?? 0 : 0;
		const lacking = without === 0 ? "" : say("rejected-without-tie-point", {
			without,
			rejected
		});
		return [isOfBlock && given?.of === pair.matches() ? saidOf$1(store.state, given) : "", lacking].filter((part) => part !== "").join(" ");
	};
	return {
		buttons: [reject, add],
		draw
	};
}
function ofPair(store, facts, pair) {
	const { shown, adjusting } = store.state;
	const matches = pair.matches();
	if (shown === null || matches === null || adjusting || !isEditable(store.state)) return NOTHING$1;
	const [a = -1, b = -1] = pair.names().map((name) => shown.view.images.findIndex((image) => image.name === name));
	if (a < 0 || b < 0 || a === b) return NOTHING$1;
	const [left, right] = [facts.points(a), facts.points(b)];
	return left === null || right === null ? NOTHING$1 : forBlock(shown.view, a, b, left, right, matches);
}
function saidOf$1(state, given) {
	const { history, shown, before, adjusting, notice } = state;
	if (given === null || shown === null || shown.found !== given.to) return "";
	if (!history.edits.includes(given.step)) return notice?.kind === "problem" ? notice.text : "";
	if (history.edits[history.done - 1] !== given.step) return "";
	if (adjusting || before === null) return say("adjusting-the-block");
	return say("edit-and-figures", {
		edit: nameOfStep(given.step, namesIn(state)),
		figures: comparedText(before, figuresOf$3(shown.view))
	});
}
// www/block/panel/back.ts
function mountBack(store, facts, modes, pair, takeMasks) {
	const [ofPair, ofMatches] = [h("span"), h("span", { role: "status" })];
	const text = h("span", { testid: "of-block" }, ofPair, " ", ofMatches);
	const back = button(say("back-to-the-block"), "back-to-block", () => {
		modes.dispatch("block");
		document.getElementById("block-view")?.focus({ preventScroll: true });
	});
	const open = button(say("open-this-pair"), "open-strongest", () => {
		const images = strongestPair(store.state);
		if (images !== null) pair.open(images);
	});
	const masks = button(say("use-masks-in-the-block"), "masks-to-block", () => takeMasks(othersOf(store, pair)), say("what-they-mask-holds-no"));
	const matches = makeFromPair(store, facts, pair);
	const line = h("div", {
		class: "of-block",
		role: "region",
		aria: { label: say("pair-and-its-block") }
	}, back, text, ...matches.buttons, masks, open);
	const draw = () => {
		const held = document.activeElement;
		const offered = pair.names().every((name) => name === null) ? strongestPair(store.state) : null;
		const said = offered === null ? saidOf(store) : say("pairs-of-the-block-open-here", { names: namesOf(store, offered) });
		line.hidden = said === null || modes.state.mode !== "pair";
		const saidOfMatches = matches.draw(!line.hidden && offered === null);
		fill(ofPair, said ?? "");
		if (ofMatches.textContent !== saidOfMatches) fill(ofMatches, saidOfMatches);
		back.hidden = offered !== null;
		open.hidden = offered === null;
		masks.hidden = offered !== null || othersOf(store, pair).length === 0;
		open.disabled = masks.disabled = isBusy(store.state);
		if (line.contains(held)) passFocus(held, [back]);
	};
	store.watch([
		"opened",
		"shown",
		"files",
		"options",
		"running",
		"notice",
		"placing",
		"history",
		"adjusting"
	], draw);
	modes.watch(["mode"], draw);
	pair.watch(draw);
	pair.watchMatches(draw);
	facts.watch(draw);
	return line;
}
function othersOf({ state: { opened, options } }, pair) {
	return opened === null ? [] : otherMasks(options.masks, pair.masks());
}
function saidOf({ state: { opened, shown } }) {
	return opened === null || shown === null ? null : describe(shown, {
		kind: "pair",
		images: opened
	});
}
function namesOf({ state: { shown } }, images) {
	return images.map((image) => shown?.view.images[image]?.name ?? "").join(" – ");
}
// www/block/panel/progress.ts
var STAGES = {
	photos: say("photos"),
	images: say("images-features"),
	geoid: say("geoid"),
	likeness: say("similarity-of-images"),
	pairs: say("pairs-matches"),
	points: say("tie-points"),
	windows: say("windows-of-observations"),
	refinement: say("refinement"),
	orientation: say("orientation")
};
var OF_ONE_PIECE = new Set([
	"geoid",
	"points",
	"orientation"
]);
var NAMES$1 = Object.keys(STAGES);
function mountProgress(host, store) {
	const body = h("div", { class: "stages" });
	const whole = section(say("run"), "block-progress", body);
	host.append(whole);
	store.watch(["running", "shown"], ([running, shown]) => {
		const steps = running.kind === "no" ? shown?.steps ?? {} : running.steps;
		const begun = NAMES$1.flatMap((name) => steps[name] === void 0 ? [] : [stage(name, steps[name])]);
		whole.hidden = begun.length === 0;
		fill(body, ...begun);
	});
}
function progressBar(store) {
	const bar = h("progress", { testid: "block-bar" });
	store.watch(["running", "placing"], ([running, placing]) => {
		const { label, done, total, counts } = runsNow(running, placing) ?? NOTHING;
		bar.classList.toggle("is-on", total > 1);
		bar.max = Math.max(1, total);
		bar.value = done;
		bar.setAttribute("aria-label", label);
		if (counts) bar.setAttribute("aria-valuetext", say("of-3", {
			done,
			total,
			what: ""
		}));
		else bar.removeAttribute("aria-valuetext");
	});
	return bar;
}
var NOTHING = {
	label: say("progress-of-the-run"),
	done: 0,
	total: 0,
	counts: false
};
function runsNow(running, { running: placed }) {
	if (running.kind !== "yes") return placed === null ? null : {
		...placed,
		label: placed.text,
		counts: true
	};
	const [name, step] = present(running.steps) ?? [];
	return name === void 0 || step === void 0 ? null : {
		...step,
		label: STAGES[name],
		counts: !OF_ONE_PIECE.has(name)
	};
}
function stage(name, step) {
	const line = (...parts) => h("div", {
		class: "stage-line",
		testid: `stage-${name}`
	}, h("span", {}, STAGES[name]), ...parts, h("span", { class: "note" }, stepText$1(name, step)));
	if (step.done === step.total) return line();
	const bar = h("progress", { aria: { label: STAGES[name] } });
	bar.max = Math.max(1, step.total);
	bar.value = step.done;
	return line(bar);
}
function stepText$1(stage, { done, total, found, seconds, secondsLeft, name }) {
	const goesOn = done < total;
	return [
		OF_ONE_PIECE.has(stage) ? "" : say("of-3", {
			done,
			total,
			what: found > 0 ? say("from-an-earlier-run", { found }) : ""
		}),
		`${duration(seconds)}${secondsLeft === void 0 || !goesOn ? "" : say("about-left", { seconds_left: duration(secondsLeft) })}`,
		goesOn ? name ?? "" : ""
	].filter((part) => part !== "").join("; ");
}
function present(steps) {
	const name = NAMES$1.findLast((stage) => steps[stage] !== void 0);
	const step = name === void 0 ? void 0 : steps[name];
	return name === void 0 || step === void 0 ? null : [name, step];
}
function runText(steps) {
	const [name, step] = present(steps) ?? [];
	return name === void 0 || step === void 0 ? say("starting") : `${STAGES[name]}: ${stepText$1(name, step)}`;
}
function duration(seconds) {
	if (seconds < 9.95) return say("seconds", { value: seconds.toFixed(1) });
	if (seconds < 90) return say("seconds", { value: String(Math.round(seconds)) });
	const minutes = Math.round(seconds / 60);
	return minutes < 90 ? say("min", { minutes }) : say("hours", { value: (seconds / 3600).toFixed(1) });
}
// www/block/state/resumed.ts
function resumed(kept, view) {
	if (kept === null || view === null) return { draft: null };
	const { images, ...draft } = kept;
	const shown = reducePanes(NO_PANES, {
		type: "showImages",
		images
	});
	return {
		draft,
		panes: draft.of === null ? shown : reducePanes(shown, {
			type: "look",
			look: { unmeasured: true }
		}),
		selection: {
			...NOTHING_SELECTED,
			chosen: choiceOfDraft(draft, view)
		},
		onStage: "images"
	};
}
// www/block/state/together.ts
function together(before, after) {
	if (after.shown === null || after.placing.placed.size === 0) return after;
	const [was, is] = [before.selection.chosen, after.selection.chosen];
	if (is !== was) return {
		...after,
		placing: placedAfter(after, before)
	};
	if (after.placing.chosen.image !== before.placing.chosen.image) return {
		...after,
		selection: selectedAfter(after, before)
	};
	return after;
}
function placedAfter({ selection: { chosen }, ...after }, before) {
	const { placing } = after;
	const id = chosen?.kind === "image" || chosen?.kind === "observation" ? fileOf$1(after, chosen.image) : null;
	if (id !== null && placing.placed.has(id)) return id === placing.chosen.image ? placing : reducePlacing(placing, {
		type: "choosePlaced",
		looked: {
			image: id,
			link: null
		}
	});
	return chosen === null && imagesOf(before.selection.chosen).some((image) => fileOf$1(after, image) === placing.chosen.image) ? reducePlacing(placing, {
		type: "choosePlaced",
		looked: NOTHING_LOOKED_AT
	}) : placing;
}
function selectedAfter({ selection, placing, ...after }, before) {
	const { chosen } = selection;
	const now = imageOf$1(after, placing.chosen.image);
	if (now !== null) return imagesOf(chosen).includes(now) ? selection : reduceSelection(selection, {
		type: "choose",
		choice: {
			kind: "image",
			image: now
		}
	});
	const former = imageOf$1(after, before.placing.chosen.image);
	return chosen?.kind === "image" && chosen.image === former ? reduceSelection(selection, {
		type: "choose",
		choice: null
	}) : selection;
}
function fileOf$1({ shown, files }, image) {
	const name = shown?.view.images[image]?.name;
	return files.find((file) => file.name === name)?.id ?? null;
}
function imageOf$1({ shown, files }, id) {
	const name = files.find((file) => file.id === id)?.name;
	const image = shown?.view.images.findIndex((own) => own.name === name) ?? -1;
	return image < 0 ? null : image;
}
// www/block/state/reducer.ts
function reduceBlock(state, action) {
	const after = withGivenPoints(reduced(state, action));
	return action.type === "choose" || action.type === "choosePlaced" ? together(state, after) : after;
}
function withGivenPoints(state) {
	const { shown, selection } = state;
	if (shown === null) return state;
	const { chosen } = selection;
	const given = givenBeside(shown.view, state);
	const stays = chosen?.kind !== "given" || given.some(({ name }) => name === chosen.name);
	const asGiven = coordinatesOf(state.options.control);
	if (given === shown.given && asGiven === shown.asGiven && stays) return state;
	return {
		...state,
		shown: {
			...shown,
			given,
			asGiven
		},
		selection: stays ? selection : {
			...selection,
			chosen: null
		}
	};
}
function reduced(state, action) {
	switch (action.type) {
		case "ready": return {
			...state,
			catalogue: action.catalogue,
			options: {
				...state.options,
				settings: action.catalogue.defaults
			},
			flight: action.catalogue.flight,
			placing: {
				...state.placing,
				options: action.catalogue.placing
			}
		};
		case "files": return {
			...state,
			files: action.files,
			truth: action.truth,
			running: withoutRunUnderWay(state.running)
		};
		case "skipped": return {
			...state,
			skipped: [...new Set([...state.skipped, ...action.names])]
		};
		case "options": return {
			...state,
			options: {
				...state.options,
				...action.options
			},
			running: withoutRunUnderWay(state.running),
			notice: null,
			refused: action.options.settings === void 0 ? state.refused : null
		};
		case "refused": return {
			...state,
			refused: action.parameter,
			notice: state.notice?.kind === "busy" ? state.notice : null
		};
		case "flight": return {
			...state,
			flight: action.flight
		};
		case "choose":
		case "point":
		case "filter": {
			const selection = reduceSelection(state.selection, action);
			if (selection === state.selection) return state;
			return {
				...action.type === "choose" && state.draft?.of != null ? reduceEdits(state, {
					type: "accept",
					leaves: true
				}) : state,
				selection
			};
		}
		case "showImages":
		case "moveViews":
		case "wholeImages":
		case "activeImage":
		case "look": return {
			...state,
			panes: reducePanes(state.panes, action)
		};
		case "stage": return {
			...state,
			onStage: action.view
		};
		case "edit":
		case "goto":
		case "adjusting":
		case "edited":
		case "editRefused":
		case "draft":
		case "accept":
		case "mark":
		case "gotoMark": return reduceEdits(state, action);
		case "placed": return state.files.includes(action.image) ? {
			...state,
			placing: reducePlacing(state.placing, action)
		} : state;
		case "orthophoto":
		case "heights":
		case "film":
		case "placingOptions":
		case "purpose":
		case "placing":
		case "elsewhere":
		case "choosePlaced":
		case "pointPlaced":
		case "picksPlace":
		case "addsPlace":
		case "linkDraft":
		case "adjustsLinks":
		case "showLinks": {
			const placing = reducePlacing(state.placing, action);
			if (placing === state.placing) return state;
			const isAnother = action.type === "placingOptions" || action.type === "purpose" || action.type === "orthophoto" && action.orthophoto === null;
			return {
				...state,
				placing,
				notice: isAnother && state.notice?.kind !== "busy" ? null : state.notice,
				refused: action.type === "placingOptions" ? null : state.refused
			};
		}
		case "openedPair": return {
			...state,
			opened: action.images
		};
		case "notice": return {
			...state,
			notice: action.notice
		};
		case "onGround": return state.shown === null ? state : onGround$1(state, state.shown, action);
		case "openedFile": {
			const files = imagesFor(state, action.view);
			const opened = {
				...state,
				...blank(state),
				files,
				placing: placingFor(state, files),
				options: action.options,
				refused: null,
				panes: panesInOtherView(state.panes, null, action.view),
				...UNEDITED,
				history: {
					edits: action.steps,
					done: action.steps.length
				},
				marks: NO_HISTORY,
				removed: [],
				skipped: [],
				truth: null,
				running: { kind: "no" },
				shown: {
					key: "",
					view: action.view,
					given: NONE_GIVEN,
					found: action.view,
					tiePoints: "",
					edits: action.steps.flat(),
					files: [],
					steps: {},
					seconds: 0,
					ground: null
				}
			};
			return {
				...opened,
				shown: opened.shown && {
					...opened.shown,
					key: openedKey(opened)
				}
			};
		}
		case "restored": {
			const { draft, ...restored } = action.restored;
			const { former, history, shown } = restored;
			const awaiting = awaitingAgain(former, history, shown);
			return {
				...BLOCK_INITIAL,
				catalogue: state.catalogue,
				...restored,
				awaiting,
				onStage: viewOf(restored),
				...resumed(draft, shown?.view ?? null)
			};
		}
		case "cleared": return state.catalogue === null ? state : reduceBlock(BLOCK_INITIAL, {
			type: "ready",
			catalogue: state.catalogue
		});
		case "clear": return {
			...BLOCK_INITIAL,
			catalogue: state.catalogue,
			options: areOfFile(state) ? defaultOptions(state) : state.options,
			flight: state.flight,
			placing: {
				...NO_PLACING,
				options: state.placing.options
			}
		};
		default: return withRun(state, action);
	}
}
function viewOf({ shown, placing }) {
	return placing.draft !== null || shown === null && placing.orthophoto !== null ? "orthophoto" : BLOCK_INITIAL.onStage;
}
function blank(state) {
	return {
		selection: NOTHING_SELECTED,
		opened: null,
		notice: state.notice?.kind === "busy" ? null : state.notice
	};
}
function inOther({ selection, panes, shown }, view, hasSamePoints) {
	const before = shown?.view ?? null;
	const other = inOtherView(selection, before, view);
	const points = before !== null && hasSamePoints ? choiceOfSamePoints(selection.chosen, before, view) : null;
	return {
		selection: {
			...other,
			chosen: points ?? other.chosen
		},
		panes: panesInOtherView(panes, before, view)
	};
}
function onGround$1(state, shown, { view, edits: own, ground, again = [] }) {
	const { edits, said } = carriedToGround(state, view, ground === null, again);
	const { orthophoto } = state.placing;
	const given = orthophoto?.ofBlock === shown.key ? {
		...state.placing,
		orthophoto: {
			...orthophoto,
			ofBlock: ""
		}
	} : state.placing;
	const placing = ground === null ? reducePlacing(given, {
		type: "purpose",
		purpose: "map"
	}) : given;
	return {
		...state,
		...blank(state),
		...inOther(state, view, true),
		...edits,
		...said === "" ? {} : { notice: {
			kind: "info",
			text: said,
			beside: true
		} },
		placing,
		shown: {
			...shown,
			view,
			found: view,
			edits: own,
			ground
		}
	};
}
function withRun(state, action) {
	const { running } = state;
	switch (action.type) {
		case "started": return {
			...state,
			running: {
				kind: "yes",
				key: action.key,
				steps: {}
			},
			notice: null
		};
		case "step": return running.kind === "yes" ? {
			...state,
			running: {
				...running,
				steps: {
					...running.steps,
					[action.step.stage]: action.step
				}
			}
		} : state;
		case "part": {
			if (running.kind !== "yes" || state.shown !== null && !state.shown.view.partial) return state;
			const { view, files } = action;
			const shown = {
				key: running.key,
				view,
				given: NONE_GIVEN,
				found: view,
				tiePoints: "",
				edits: [],
				files,
				seconds: 0,
				steps: {},
				ground: null
			};
			return {
				...state,
				shown,
				opened: null,
				...inOther(state, view, false)
			};
		}
		case "done": {
			const { key, view, files, seconds } = action;
			const { edits, said } = carried(state, view);
			const tiePoints = nameOfTiePoints(view);
			const draft = draftInOtherView(state.draft, state.shown?.view, view);
			return {
				...state,
				...blank(state),
				...inOther(state, view, tiePoints === state.shown?.tiePoints),
				...edits,
				draft,
				...said === "" ? {} : { notice: {
					kind: "info",
					text: said,
					beside: true
				} },
				running: { kind: "no" },
				shown: {
					key,
					view,
					given: NONE_GIVEN,
					found: view,
					tiePoints,
					edits: [],
					files,
					seconds,
					steps: running.kind === "yes" ? running.steps : {},
					ground: null
				}
			};
		}
		case "ended": return running.kind === "yes" ? {
			...state,
			running: {
				kind: "ended",
				steps: running.steps,
				failure: action.failure
			}
		} : state;
	}
}
// www/block/state/observed.ts
var placesOf$2 = new WeakMap();
function placesByPoint(of) {
	const known = placesOf$2.get(of);
	if (known !== void 0) return known;
	const made = new Map([...of.points].map((point, i) => [point, [of.places[2 * i] ?? NaN, of.places[2 * i + 1] ?? NaN]]));
	placesOf$2.set(of, made);
	return made;
}
function placeOfPoint(of, point) {
	return placesByPoint(of).get(point) ?? null;
}
function nearest$1(list, [x, y]) {
	return list.map((twice) => ({
		twice,
		distance: (twice[0] - x) ** 2 + (twice[1] - y) ** 2
	})).sort((a, b) => a.distance - b.distance).slice(0, 12).map(({ twice }) => twice);
}
var commonOf = new WeakMap();
function common(from, to) {
	const known = commonOf.get(from)?.get(to);
	if (known !== void 0) return known;
	const others = placesByPoint(to);
	const rejected = new Set([...to.points].filter((_, i) => to.parts[i] !== 0));
	const made = [...from.points].flatMap((point, i) => {
		const other = others.get(point);
		if (other === void 0 || from.parts[i] !== 0 || rejected.has(point)) return [];
		return [[
			from.places[2 * i] ?? NaN,
			from.places[2 * i + 1] ?? NaN,
			...other
		]];
	});
	const ofFrom = commonOf.get(from) ?? new WeakMap();
	commonOf.set(from, ofFrom.set(to, made));
	return made;
}
function inOtherImage(from, to, at) {
	return movedWith(nearest$1(common(from, to), at), at);
}
var groundAt = remember((of, { positions }, x, y) => {
	const at = [x, y];
	const coordinate = (point, axis) => positions[3 * point + axis] ?? NaN;
	const known = [...of.points].flatMap((point, i) => {
		const twice = [
			of.places[2 * i] ?? NaN,
			of.places[2 * i + 1] ?? NaN,
			coordinate(point, 0),
			coordinate(point, 1)
		];
		return of.parts[i] === 0 && !Number.isNaN(twice[2]) ? [[twice, coordinate(point, 2)]] : [];
	});
	const heights = new Map(known);
	const near = nearest$1([...heights.keys()], at);
	const plan = affine$1(near, at);
	const height = affine$1(near.map((twice) => [
		twice[0],
		twice[1],
		heights.get(twice) ?? NaN,
		0
	]), at);
	return plan === null || height === null ? null : [...plan, height[0]];
});
function placeOfGround(of, { positions }, at) {
	const known = [...of.points].flatMap((point, i) => {
		const twice = [
			positions[3 * point] ?? NaN,
			positions[3 * point + 1] ?? NaN,
			of.places[2 * i] ?? NaN,
			of.places[2 * i + 1] ?? NaN
		];
		return of.parts[i] === 0 && !Number.isNaN(twice[0]) ? [twice] : [];
	});
	return affine$1(nearest$1(known, at), at);
}
function photoMm({ calibrated, given }, [x, y]) {
	const camera = calibrated ?? given;
	const side = camera?.pixel_mm ?? given?.pixel_mm;
	if (camera === null || side == null) return null;
	return [side * (x - camera.principal_point_px[0]), side * (camera.principal_point_px[1] - y)];
}
// www/block/state/likely.ts
function likeliest({ images, connections }, near) {
	const all = images.map((_, image) => image);
	if (near === void 0) return all;
	const matches = new Map([[near, Infinity]]);
	for (const connection of connections) {
		const [a, b] = connection.images;
		if (a === near || b === near) matches.set(a === near ? b : a, matchesOf$1(connection));
	}
	return all.sort((a, b) => (matches.get(b) ?? 0) - (matches.get(a) ?? 0) || a - b);
}
function turned(shown, order, kept, by) {
	const stay = shown.filter((image) => kept.has(image));
	const others = order.filter((image) => !stay.includes(image));
	const free = Math.min(Math.max(1, shown.length - stay.length), 9 - stay.length, others.length);
	const places = shown.map((image) => others.indexOf(image)).filter((place) => place >= 0);
	const first = by > 0 ? Math.max(-1, ...places) + 1 : Math.min(others.length, ...places) - free;
	const next = Array.from({ length: free }, (_, i) => others[((first + i) % others.length + others.length) % others.length] ?? 0);
	return [...stay, ...next];
}
// www/shared/engine/colour.ts
var MOST_BYTES = 2 ** 25;
async function decodeColour(bytes) {
	if (bytes.length > MOST_BYTES) return null;
	try {
		return await createImageBitmap(new Blob([withoutExif(bytes)]));
	} catch {
		return null;
	}
}
function withoutExif(bytes) {
	const kept = [];
	let [from, at] = [0, 2];
	const isJpeg = bytes[0] === 255 && bytes[1] === 216;
	while (isJpeg && bytes[at] === 255 && bytes[at + 1] !== 218 && at + 4 < bytes.length) {
		const next = at + 2 + 256 * (bytes[at + 2] ?? 0) + (bytes[at + 3] ?? 0);
		if (bytes[at + 1] === 225 && String.fromCharCode(...bytes.subarray(at + 4, at + 8)) === "Exif") {
			kept.push(bytes.subarray(from, at));
			from = next;
		}
		at = next;
	}
	kept.push(bytes.subarray(from));
	const whole = new Uint8Array(kept.reduce((sum, { length }) => sum + length, 0));
	let end = 0;
	for (const piece of kept) {
		whole.set(piece, end);
		end += piece.length;
	}
	return whole;
}
// www/block/view/images/bitmaps.ts
var COPY_SIDE = 1024;
var MOST_DECODED = 1e8;
var MARGIN$1 = .25;
var LEAST_MARGIN = 96;
var Bitmaps = class {
	grey;
	arrived;
	held = new Map();
	decoded = new Map();
	wishes = new Map();
	working = false;
	constructor(grey, arrived) {
		this.grey = grey;
		this.arrived = arrived;
	}
	hasFailed(file) {
		return this.held.get(file.id)?.failed === true;
	}
	pieces(file, size, slot, part, density) {
		const held = this.held.get(file.id) ?? {
			copy: null,
			details: new Map(),
			failed: false
		};
		this.held.set(file.id, held);
		if (held.failed) return [];
		const level = wantedLevel(density, 1);
		const { copy } = held;
		const detail = held.details.get(slot);
		if (copy === null) this.wish({
			file,
			size,
			slot,
			part: null,
			level: 0
		});
		else if (2 ** level < copy.step && !(detail !== void 0 && detail.level <= level && covers(detail.part, part))) this.wish({
			file,
			size,
			slot,
			part: withMargin(part, size),
			level
		});
		return [copy, detail].filter((piece) => piece != null);
	}
	keep(files) {
		for (const [id, held] of this.held) {
			if (files.has(id)) continue;
			for (const piece of [held.copy, ...held.details.values()]) piece?.bitmap.close();
			this.held.delete(id);
		}
		for (const [name, { file }] of this.wishes) if (!files.has(file.id)) this.wishes.delete(name);
		for (const [id, bitmap] of this.decoded) {
			if (files.has(id)) continue;
			bitmap.close();
			this.decoded.delete(id);
		}
	}
	get bytes() {
		return [...[...this.held.values()].flatMap(({ copy, details }) => [copy, ...details.values()].map((piece) => piece?.bitmap)), ...this.decoded.values()].reduce((sum, bitmap) => sum + (bitmap == null ? 0 : sizeOf(bitmap)), 0);
	}
	wish(wish) {
		this.wishes.set(nameOfWish(wish), wish);
		if (!this.working) this.work();
	}
	async work() {
		this.working = true;
		for (let next = this.wishes.values().next().value; next !== void 0; next = this.wishes.values().next().value) {
			this.wishes.delete(nameOfWish(next));
			await this.fulfil(next);
			this.arrived();
		}
		this.working = false;
	}
	async fulfil({ file, size, slot, part, level }) {
		const whole = await this.whole(file, size).catch((error) => error instanceof Cancelled ? void 0 : null);
		const held = this.held.get(file.id);
		if (held === void 0 || whole === void 0) return;
		if (whole === null) {
			held.failed = true;
			return;
		}
		try {
			if (part === null) {
				const step = 2 ** Math.max(0, Math.ceil(Math.log2(Math.max(size.width, size.height) / COPY_SIDE)));
				held.copy = await pieceOf(whole, [
					0,
					0,
					size.width,
					size.height
				], step);
			} else {
				const detail = await pieceOf(whole, part, 2 ** level);
				held.details.get(slot)?.bitmap.close();
				held.details.set(slot, {
					...detail,
					part,
					level
				});
			}
		} catch {}
		this.forgetOldest();
	}
	async whole(file, size) {
		const known = this.decoded.get(file.id);
		if (known !== void 0) {
			this.decoded.delete(file.id);
			this.decoded.set(file.id, known);
			return known;
		}
		const fits = (bitmap) => bitmap.width === size.width && bitmap.height === size.height;
		const colour = await decodeColour(new Uint8Array(await file.file.arrayBuffer()));
		if (colour !== null && !fits(colour)) colour.close();
		const made = colour !== null && fits(colour) ? colour : await this.grey(file.file);
		if (!fits(made)) return null;
		if (this.held.has(file.id)) this.decoded.set(file.id, made);
		return made;
	}
	forgetOldest() {
		let sum = [...this.decoded.values()].reduce((all, bitmap) => all + sizeOf(bitmap), 0);
		for (const [id, bitmap] of this.decoded) {
			if (sum <= MOST_DECODED) return;
			sum -= sizeOf(bitmap);
			bitmap.close();
			this.decoded.delete(id);
		}
	}
};
function nameOfWish({ file, slot }) {
	return `${String(file.id)} ${slot}`;
}
function sizeOf({ width, height }) {
	return 4 * width * height;
}
function covers(outer, inner) {
	return outer[0] <= inner[0] && outer[1] <= inner[1] && outer[2] >= inner[2] && outer[3] >= inner[3];
}
function withMargin([left, top, right, bottom], { width, height }) {
	const [dx, dy] = [right - left, bottom - top].map((length) => Math.max(MARGIN$1 * length, LEAST_MARGIN));
	return [
		Math.max(0, Math.floor(left - dx)),
		Math.max(0, Math.floor(top - dy)),
		Math.min(width, Math.ceil(right + dx)),
		Math.min(height, Math.ceil(bottom + dy))
	];
}
async function pieceOf(whole, [left, top, right, bottom], step) {
	const [width, height] = [Math.max(1, Math.floor((right - left) / step)), Math.max(1, Math.floor((bottom - top) / step))];
	return {
		bitmap: await createImageBitmap(whole, left, top, width * step, height * step, {
			resizeWidth: width,
			resizeHeight: height,
			resizeQuality: "medium"
		}),
		x: left,
		y: top,
		step
	};
}
// www/block/view/images/keys.ts
var ARROWS = {
	ArrowLeft: [-1, 0],
	ArrowRight: [1, 0],
	ArrowUp: [0, -1],
	ArrowDown: [0, 1]
};
var FINE = .1;
var COARSE = 1;
function measuringKeys(view) {
	const { measuring } = view;
	const drafts = () => measuring.draft !== null;
	const lacksPoint = () => drafts() || measuring.canBegin() ? "" : say("no-point-is-chosen");
	const lacksPlace = () => {
		const pane = view.seen.active();
		return drafts() && (pane === null || measuring.placeIn(pane) === null) ? say("nothing-is-measured") : lacksPoint();
	};
	const shown = (act) => (shift) => {
		act(shift);
		view.opening.showDraft();
	};
	const inPane = (act) => shown((shift) => {
		const pane = view.seen.active();
		if (pane !== null) act(pane, shift);
	});
	const places = () => drafts() && view.seen.active() !== null;
	const nudge = ([key, [dx, dy]]) => ({
		keys: [key],
		does: say("moves-the-measured-point-by"),
		can: places,
		run: inPane((pane, shift) => {
			const step = shift ? COARSE : FINE;
			measuring.nudge(pane, step * dx, step * dy);
		})
	});
	const settle = (pane) => {
		const { rect, transform } = pane;
		measuring.settle(pane, toPosition(transform, rect.left + rect.width / 2, rect.top + rect.height / 2));
	};
	return [
		{
			keys: ["e"],
			does: say("measures-the-chosen-point"),
			lacks: lacksPoint,
			run: shown(() => measuring.toggle(false))
		},
		{
			keys: ["a"],
			does: say("measures-a-new-tie-point"),
			run: shown(() => measuring.toggle(true))
		},
		{
			keys: ["f"],
			does: say("matches-the-point-in-the"),
			lacks: lacksPlace,
			run: shown((shift) => shift ? view.matchAlone() : view.match())
		},
		{
			keys: ["Escape"],
			does: say("gives-up-measuring"),
			can: places,
			run: shown(() => measuring.leave())
		},
		{
			keys: ["Enter"],
			does: say("takes-the-middle-of-the"),
			can: places,
			run: inPane(settle)
		},
		...Object.entries(ARROWS).map(nudge)
	];
}
function looking(view) {
	const { store } = view.seen;
	const look = () => store.state.panes.look;
	const step = (by) => {
		if (view.measuring.draft === null) view.step(by);
	};
	return [
		{
			keys: ["n"],
			does: say("chooses-the-next-tie-point"),
			run: () => step(1)
		},
		{
			keys: ["p"],
			does: say("chooses-the-previous-tie-point"),
			run: () => step(-1)
		},
		{
			keys: ["1"],
			does: say("shows-one-image-pixel-as"),
			run: () => view.moving.actualSize()
		},
		{
			keys: ["PageDown"],
			does: say("shows-the-next-images"),
			run: () => view.turn(1)
		},
		{
			keys: ["PageUp"],
			does: say("shows-the-previous-images"),
			run: () => view.turn(-1)
		},
		{
			keys: ["o"],
			does: say("goes-to-the-next-pane"),
			run: () => view.other()
		},
		{
			keys: ["l"],
			does: say("links-all-panes-or-no"),
			run: () => store.dispatch({
				type: "look",
				look: { linked: !look().linked }
			})
		},
		{
			keys: ["m"],
			does: say("shows-the-loupe-or-no"),
			run: () => store.dispatch({
				type: "look",
				look: { loupe: !look().loupe }
			})
		},
		{
			keys: ["u"],
			does: say("shows-images-in-which-the"),
			run: () => store.dispatch({
				type: "look",
				look: { unmeasured: !look().unmeasured }
			})
		},
		{
			keys: ["Escape"],
			does: say("chooses-nothing"),
			lacks: () => store.state.selection.chosen === null ? say("nothing-is-chosen") : "",
			run: () => store.dispatch({
				type: "choose",
				choice: null
			})
		}
	];
}
// www/block/view/images/grid.ts
var GAP = 4;
function columnsOf(count, width, height, ratio, narrow) {
	if (narrow) return 1;
	const scale = (columns) => Math.min(width / columns, ratio * height / Math.ceil(count / columns));
	return Array.from({ length: count }, (_, i) => i + 1).reduce((best, columns) => scale(columns) > scale(best) * 1.001 ? columns : best, 1);
}
function gridOf(count, columns, width, height) {
	const rows = Math.ceil(count / columns);
	return Array.from({ length: count }, (_, i) => {
		const row = Math.floor(i / columns);
		const [left, right] = edges(width, row === rows - 1 ? count - row * columns : columns, i - row * columns);
		const [top, bottom] = edges(height, rows, row);
		return {
			left,
			top,
			width: Math.max(1, right - left),
			height: Math.max(1, bottom - top)
		};
	});
}
function edges(length, parts, part) {
	const side = (length - GAP * (parts - 1)) / parts;
	return [Math.round(part * (side + GAP)), Math.round(part * (side + GAP) + side)];
}
// www/block/view/images/scene.ts
var byName = remember((files, made) => new Map([...files, ...made].map((file) => [file.name, file])));
var NO_FILES = [];
function panesOf(state, view, facts, columns, width, height) {
	const images = shownImages(state.panes, view);
	const files = byName(state.files, state.shown?.files ?? NO_FILES);
	const rects = gridOf(images.length, columns, width, height);
	return images.flatMap((image, i) => {
		const [of, rect] = [view.images[image], rects[i]];
		if (of === void 0 || rect === void 0) return [];
		return [{
			image,
			width: of.width,
			height: of.height,
			file: files.get(of.name) ?? null,
			rect,
			transform: transformOf(rect, paneView(state.panes, image, rect, of)),
			points: facts.points(image)
		}];
	});
}
function paneView({ views }, image, rect, of) {
	const own = views.get(image);
	return own === void 0 ? fitView(rect, of.width, of.height) : inPane(own, rect);
}
function fillScale({ width, height }, of) {
	return Math.max(width / of.width, height / of.height);
}
function paneAt(panes, x, y) {
	return panes.find(({ rect }) => contains(rect, x, y)) ?? null;
}
function isOn({ width, height }, [x, y]) {
	return x >= 0 && y >= 0 && x <= width && y <= height;
}
// www/block/view/images/lenses.ts
var DRAFT_SCALE = 6;
var EDGE$2 = 8;
function lensesAt(seen, panes, pointer, pointed) {
	const from = panes.find(({ image }) => image === pointed.image);
	const scale = Math.min(48, Math.max(4, (from?.transform.scale ?? 1) * 4));
	return panes.flatMap((pane) => {
		const own = pane === from;
		const at = own ? pointed.at : seen.sameGround(from, pane, pointed.at);
		if (at === null || !isOn(pane, at)) return [];
		const rect = own ? besidePointer(pointer, pane.rect) : cornerOf(pane.rect);
		return [{
			pane,
			rect,
			transform: lensTransform(rect, at, scale)
		}];
	});
}
function draftLenses(measuring, panes) {
	return panes.flatMap((pane) => {
		const at = measuring.placeIn(pane);
		if (at === null || !isOn(pane, at)) return [];
		const rect = cornerOf(pane.rect, toCanvas(pane.transform, ...at));
		return [{
			pane,
			rect,
			transform: lensTransform(rect, at, Math.max(DRAFT_SCALE, pane.transform.scale))
		}];
	});
}
function besidePointer([x, y], { left, top, width, height }) {
	const rect = lensRect([x - left, y - top], {
		left: 0,
		top: 0,
		width,
		height
	});
	return {
		...rect,
		left: left + rect.left,
		top: top + Math.min(rect.top, height - rect.height)
	};
}
function cornerOf({ left, top, width, height }, [x] = [left, top]) {
	const side = Math.max(40, Math.min(176, width * .45, height * .45));
	return {
		left: x > left + width / 2 ? left + EDGE$2 : left + width - EDGE$2 - side,
		top: top + height - EDGE$2 - side,
		width: side,
		height: side
	};
}
// www/block/view/images/turn.ts
var STEP$1 = 20;
var STRAIGHT = [
	1,
	0,
	0,
	1
];
function turnOf(from, to, [x, y]) {
	const { points: own } = from;
	const { points: other } = to;
	if (own === null || other === null) return STRAIGHT;
	const [middle, across, down] = [
		[x, y],
		[x + STEP$1, y],
		[x, y + STEP$1]
	].map(([u = 0, v = 0]) => inOtherImage(own, other, [u, v]));
	if (middle == null || across == null || down == null) return STRAIGHT;
	return [
		(across[0] - middle[0]) / STEP$1,
		(across[1] - middle[1]) / STEP$1,
		(down[0] - middle[0]) / STEP$1,
		(down[1] - middle[1]) / STEP$1
	];
}
// www/block/view/images/measuring.ts
var MOST_NAMES$1 = 3;
var NOWHERE = new Map();
var Measuring = class {
	store;
	engine;
	facts;
	panes;
	matching = false;
	constructor(store, engine, facts, panes) {
		this.store = store;
		this.engine = engine;
		this.facts = facts;
		this.panes = panes;
	}
	get draft() {
		return this.store.state.draft;
	}
	toggle(anew) {
		const { state } = this.store;
		if (state.draft !== null || !isEditable(state) || state.shown === null) {
			this.store.dispatch({
				type: "accept",
				leaves: true
			});
			return;
		}
		const { chosen } = state.selection;
		if (!anew && chosen?.kind === "given") {
			this.set(begun({ given: chosen.name }));
			return;
		}
		const [point, ...more] = pointsOf(chosen);
		if (!anew && point !== void 0 && !isMeasurable(state.shown.view, point)) return;
		const of = anew || point === void 0 || more.length > 0 ? null : sourceOf$1(state.shown.view, point);
		if (of === null && !anew) return;
		if (of === null) this.store.dispatch({
			type: "choose",
			choice: null
		});
		else this.store.dispatch({
			type: "look",
			look: { unmeasured: true }
		});
		this.set(begun(of));
	}
	canBegin() {
		const { selection, shown } = this.store.state;
		if (selection.chosen?.kind === "given") return true;
		const [point] = pointsOf(selection.chosen);
		return shown !== null && point !== void 0 && isMeasurable(shown.view, point);
	}
	placeIn(pane) {
		return this.draft?.places.get(pane.image)?.at ?? this.measured(pane.image) ?? this.expected(pane);
	}
	expected(pane) {
		const { draft } = this;
		if (draft === null || draft.places.has(pane.image)) return null;
		if (isGiven(draft.of) && this.known().has(pane.image)) return null;
		const elsewhere = this.detail()?.elsewhere.find(({ image }) => image === pane.image);
		if (elsewhere !== void 0) return [elsewhere.x_px, elsewhere.y_px];
		if (draft.of !== null && !isGiven(draft.of)) return null;
		const [one, other] = this.sources(pane.image).map(({ image, at }) => this.facts.line(image, at, pane.image));
		const both = one == null || other == null ? null : crossing(one, other);
		if (both !== null) return both;
		const [first] = this.known();
		const from = first === void 0 ? void 0 : this.panes().find(({ image }) => image === first[0]);
		const near = this.ofGround(pane) ?? (first === void 0 || from?.points == null || pane.points === null ? null : inOtherImage(from.points, pane.points, first[1]));
		if (first === void 0) return near;
		const line = this.facts.line(first[0], first[1], pane.image);
		return near === null || line === null ? near : onLine(line, near);
	}
	ofGround(pane) {
		const { shown, selection } = this.store.state;
		const { chosen } = selection;
		if (shown === null || chosen?.kind !== "given" || pane.points === null) return null;
		const place = shown.given.find(({ name }) => name === chosen.name)?.place;
		if (place == null) return null;
		const at = placeOfGround(pane.points, shown.view.points, [place[0], place[1]]);
		return at !== null && isOn(pane, at) ? at : null;
	}
	marks() {
		const { shown, selection, options, marks } = this.store.state;
		if (shown === null || selection.chosen?.kind !== "given") return NOWHERE;
		return this.added().get(selection.chosen.name)?.places ?? placesOfGiven(selection.chosen.name, shown.view, options.marks, marks);
	}
	added() {
		const { shown, history } = this.store.state;
		return addedPoints(editsInForce(history), shown?.view.givenControl ?? 0);
	}
	ownPlaces() {
		const { draft } = this;
		return draft?.of == null ? NOWHERE : placesOf$1(draft);
	}
	known() {
		const { draft } = this;
		if (draft === null) return NOWHERE;
		return new Map([...isGiven(draft.of) ? this.marks() : [], ...placesOf$1(draft)]);
	}
	sources(image) {
		return [...this.known()].filter(([other]) => other !== image).slice(-2).map(([other, at]) => ({
			image: other,
			at
		}));
	}
	place(pane, at) {
		if (this.draft !== null) this.set(placed$1(this.draft, pane.image, at, pane));
	}
	nudge(pane, dx, dy) {
		const at = this.placeIn(pane);
		if (at !== null) this.place(pane, [at[0] + dx, at[1] + dy]);
	}
	async settle(pane, middle) {
		const { draft } = this;
		if (draft === null) return;
		if (draft.places.has(pane.image) || this.measured(pane.image) !== null) return this.accept();
		let own = pane;
		let expected = this.expected(own);
		while (expected === null && this.facts.isAsked && await this.facts.answered()) {
			own = this.panes().find(({ image }) => image === pane.image);
			if (this.draft !== draft || own === void 0) return;
			expected = this.expected(own);
		}
		if (this.draft === draft) this.place(own, expected ?? middle);
	}
	accept() {
		this.store.dispatch({
			type: "accept",
			leaves: false
		});
	}
	leave() {
		if (this.draft === null) return false;
		this.set(null);
		return true;
	}
	async match(from) {
		await this.matched(from, "matching-in-the-other-images", async (of, at, file) => {
			const left = await this.engine.window(file, at, null);
			const others = this.panes().filter((pane) => pane.image !== of.image && pane.file !== null);
			const found = await Promise.all(others.map(async (pane) => {
				const near = this.placeIn(pane);
				if (near === null || pane.file === null) return null;
				return {
					pane,
					place: await this.engine.matched(left, pane.file.file, near, turnOf(of, pane, at))
				};
			}));
			return () => this.take(of, at, found.filter((one) => one !== null));
		});
	}
	async matchAlone(to) {
		await this.matched(to, "matching-in-one-image", async (of, near, file) => {
			const others = this.others(of);
			for (const { pane, at, source } of others) {
				const left = await this.engine.window(source, at, null);
				const place = await this.engine.matched(left, file, near, turnOf(pane, of, at));
				if (place !== null) return () => this.takeAlone(of, place, pane);
			}
			const done = others.length === 0 ? say("no-other-has-the-point") : say("no-match-is-confirmed-in", {
				done: "",
				where: this.nameOf(of)
			}).trim();
			return () => this.tell("info", done);
		});
	}
	async matched(pane, busy, job) {
		if (this.draft === null) this.toggle(false);
		const at = pane === null ? null : this.placeIn(pane);
		if (this.matching || this.draft === null || pane?.file == null || at === null) return;
		this.matching = true;
		const { draft } = this;
		this.tell("busy", say(busy, { image: this.nameOf(pane) }));
		try {
			const take = await job(pane, at, pane.file.file);
			if (this.draft === draft) take();
			else if (this.store.state.notice?.kind === "busy") this.store.dispatch({
				type: "notice",
				notice: null
			});
		} catch (error) {
			if (error instanceof Cancelled) this.tell("info", say("cancelled-nothing-was-matched"));
			else this.tell("problem", say("not-matched", { error: messageOf(error) }));
		}
		this.matching = false;
	}
	others(than) {
		const places = this.draft?.places;
		const all = this.panes().flatMap((pane) => {
			const at = places?.get(pane.image)?.at ?? this.measured(pane.image);
			return pane.image === than.image || pane.file === null || at === null ? [] : [{
				pane,
				at,
				source: pane.file.file
			}];
		});
		const isPlaced = ({ pane }) => places?.has(pane.image) === true;
		return [...all.filter(isPlaced), ...all.filter((one) => !isPlaced(one))];
	}
	nameOf({ image }) {
		return this.store.state.shown?.view.images[image]?.name ?? "";
	}
	takeAlone(pane, place, by) {
		if (this.draft !== null) this.set(placed$1(this.draft, pane.image, place, pane, "least_squares"));
		this.tell("info", say("matched-in-one-image", {
			image: this.nameOf(pane),
			by: this.nameOf(by),
			what: say("enter-accepts")
		}));
	}
	take(from, at, found) {
		if (this.draft === null) return;
		const own = this.draft.of === null || isGiven(this.draft.of) && this.measured(from.image) === null ? placed$1(this.draft, from.image, at, from) : this.draft;
		this.set(found.reduce((draft, { pane, place }) => place === null ? draft : placed$1(draft, pane.image, place, pane, "least_squares"), own));
		const lost = found.filter(({ place }) => place === null).map(({ pane }) => this.nameOf(pane));
		const count = found.length - lost.length;
		const done = say("matched-in-of-images", {
			count,
			found: found.length,
			what: count > 0 ? say("enter-accepts") : ""
		}).trim();
		const where = lost.length > MOST_NAMES$1 ? say("images-4", { lost: lost.length }) : lost.join(", ");
		this.tell("info", lost.length === 0 ? done : say("no-match-is-confirmed-in", {
			done,
			where
		}));
	}
	measured(image) {
		if (isGiven(this.draft?.of ?? null)) return this.marks().get(image) ?? null;
		const own = this.detail()?.observations.find((one) => one.image === image);
		return own === void 0 ? null : [own.x_px, own.y_px];
	}
	detail() {
		const { draft, shown } = this.store.state;
		if (draft?.of == null || isGiven(draft.of) || shown === null) return null;
		const point = indexOfSource(shown.view, draft.of);
		return point < 0 ? null : this.facts.point(point);
	}
	set(draft) {
		if (draft !== this.store.state.draft) this.store.dispatch({
			type: "draft",
			draft
		});
	}
	tell(kind, text) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind,
				text,
				beside: kind !== "problem"
			}
		});
	}
};
function placesOf$1(draft) {
	return new Map([...draft.places].map(([image, { at }]) => [image, at]));
}
// www/block/view/images/moving.ts
var Moving = class {
	seen;
	constructor(seen) {
		this.seen = seen;
	}
	pan(image, dx, dy) {
		this.change(image, (pane, own) => ({
			...own,
			x: own.x - dx / pane.transform.scale,
			y: own.y - dy / pane.transform.scale
		}));
	}
	zoom(image, factor, x, y) {
		this.change(image, (pane, own, least) => zoomed(pane.rect, own, factor, x, y, least));
	}
	fit() {
		this.seen.store.dispatch({ type: "wholeImages" });
	}
	zoomMiddle(factor) {
		const pane = this.seen.active();
		if (pane === null) return;
		const { rect } = pane;
		const middle = [rect.left + rect.width / 2, rect.top + rect.height / 2];
		const [point] = pointsOf(this.seen.store.state.selection.chosen);
		const place = point === void 0 || pane.points === null ? null : placeOfPoint(pane.points, point);
		const at = place === null ? middle : toCanvas(pane.transform, ...place);
		this.zoom(pane.image, factor, ...contains(rect, ...at) ? at : middle);
	}
	actualSize() {
		const pane = this.seen.active();
		if (pane !== null) this.zoomMiddle(1 / pane.transform.scale);
	}
	change(image, next) {
		const { state } = this.seen.store;
		const panes = this.seen.panes();
		const moved = (pane) => {
			const { scale } = fitView(pane.rect, pane.width, pane.height);
			return clamped(next(pane, paneView(state.panes, pane.image, pane.rect, pane), scale / 4), pane);
		};
		const leader = panes.find((pane) => pane.image === image);
		if (leader === void 0) return;
		const own = moved(leader);
		const views = new Map([[image, own]]);
		if (state.panes.look.linked) {
			for (const pane of panes) if (pane !== leader) views.set(pane.image, followed(leader, own, pane, moved(pane)));
		}
		this.seen.store.dispatch({
			type: "moveViews",
			views
		});
	}
};
function followed(leader, { x, y }, pane, own) {
	const ground = leader.points === null || pane.points === null ? null : inOtherImage(leader.points, pane.points, [x, y]);
	return ground === null ? own : clamped({
		x: ground[0],
		y: ground[1],
		scale: own.scale
	}, pane);
}
// www/block/view/images/observations.ts
var STYLES$1 = [
	ACCEPTED,
	REJECTED$1,
	REJECTED_BY_HAND,
	MEASURED
];
var BY_HAND$1 = 3;
var drawnOf = new WeakMap();
function drawn(of) {
	const known = drawnOf.get(of);
	if (known !== void 0) return known;
	const made = {
		points: new Float64Array(3 * of.points.length),
		vectors: new Float64Array(4 * of.points.length)
	};
	for (let i = 0; i < of.points.length; i++) {
		made.points.set(of.places.subarray(2 * i, 2 * i + 2), 3 * i);
		made.vectors.set(of.places.subarray(2 * i, 2 * i + 2), 4 * i);
		made.vectors.set(of.residuals.subarray(2 * i, 2 * i + 2), 4 * i + 2);
	}
	drawnOf.set(of, made);
	return made;
}
var grids = new WeakMap();
function nearestRow(of, { width, height }, x, y, radius, keeps) {
	const grid = grids.get(of) ?? new PointGrid(drawn(of).points, width, height);
	grids.set(of, grid);
	return grid.nearest(x, y, radius, (row) => keeps(of.points[row] ?? -1));
}
var NOT_DRAWN$1 = 255;
function codesOf$1({ points, parts }, { byHand, keeps }) {
	return parts.map((part, i) => {
		const point = points[i] ?? -1;
		if (!keeps(point)) return NOT_DRAWN$1;
		return part === 0 && byHand.has(point) ? BY_HAND$1 : part;
	});
}
function drawObservations(context, of, marked, t, clip) {
	const half = halfSize(t.scale);
	const styles = Float64Array.from(STYLES$1.flatMap(({ shape }, code) => [
		shape,
		code === 1 || code === 2 ? .85 * half : half,
		1.6
	]));
	draw_points(context, drawn(of).points, codesOf$1(of, marked), styles, STYLES$1.map(({ colour }) => colour), drawView(t, clip));
}
function drawResiduals(context, of, marked, factor, { transform, rect }) {
	const colours = [
		RESIDUAL,
		RESIDUAL_REJECTED,
		RESIDUAL_REJECTED,
		RESIDUAL
	];
	draw_vectors(context, drawn(of).vectors, codesOf$1(of, marked), Float64Array.of(1.4, 1.4, 1.4, 1.4), colours, factor, drawView(transform, rect));
}
var BAR$1 = 70;
function drawScaleBar(context, factor, { transform, rect }) {
	const { px, length } = barOf(factor * transform.scale);
	const [x, y] = [rect.left + 10, rect.top + rect.height - 10];
	const text = asSentence(say("px-4", {
		px,
		factor
	}));
	within(context, rect, () => {
		context.font = "11px system-ui, sans-serif";
		const width = Math.max(length, context.measureText(text).width) + 12;
		context.fillStyle = "rgb(20 23 26 / 0.72)";
		context.fillRect(x - 6, y - 22, width, 28);
		context.fillStyle = "#f2f4f5";
		context.fillText(text, x, y - 10);
		context.strokeStyle = RESIDUAL;
		context.lineWidth = 2;
		context.beginPath();
		for (const [from, to] of [
			[[x, y], [x + length, y]],
			[[x, y - 4], [x, y + 4]],
			[[x + length, y - 4], [x + length, y + 4]]
		]) {
			context.moveTo(...from);
			context.lineTo(...to);
		}
		context.stroke();
	});
}
function barOf(scale) {
	const wanted = BAR$1 / scale;
	const power = 10 ** Math.floor(Math.log10(wanted));
	const digit = [
		5,
		2,
		1
	].find((step) => step * power <= wanted) ?? 1;
	const px = Number((digit * power).toPrecision(1));
	return {
		px,
		length: px * scale
	};
}
// www/block/state/footprints.ts
function footprintsAt(footprints, [x, y]) {
	const found = [];
	for (let image = 0; 8 * image < footprints.length; image += 1) {
		const corners = footprints.subarray(8 * image, 8 * image + 8);
		if (!holds(corners, x, y)) continue;
		const middle = (axis) => [
			0,
			1,
			2,
			3
		].reduce((sum, corner) => sum + (corners[2 * corner + axis] ?? NaN), 0) / 4;
		found.push({
			image,
			far: Math.hypot(middle(0) - x, middle(1) - y)
		});
	}
	return found.sort((a, b) => a.far - b.far).map(({ image }) => image);
}
function holds(corners, x, y) {
	const sides = [
		0,
		1,
		2,
		3
	].map((i) => {
		const [ax, ay, bx, by] = [
			corners[2 * i],
			corners[2 * i + 1],
			corners[(2 * i + 2) % 8],
			corners[(2 * i + 3) % 8]
		].map((value) => value ?? NaN);
		return ((bx ?? NaN) - (ax ?? NaN)) * (y - (ay ?? NaN)) - ((by ?? NaN) - (ay ?? NaN)) * (x - (ax ?? NaN));
	});
	return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}
// www/block/view/images/opening.ts
var LEAST_SCALE = 1;
var Opening = class {
	seen;
	measuring;
	openedAt = null;
	shownFor = null;
	pending = new Set();
	last = null;
	constructor(seen, measuring) {
		this.seen = seen;
		this.measuring = measuring;
	}
	again() {
		this.openedAt = null;
	}
	follow() {
		const { onStage, panes, selection, shown } = this.seen.store.state;
		if (shown === null) return;
		const { view, found } = shown;
		this.afterEdit(found, view);
		if (onStage !== "images" || !this.seen.isLaid) return;
		const chosen = this.seen.chosen();
		if (chosen === null) {
			if (selection.chosen === null) this.openedAt = null;
			if (selection.chosen?.kind === "given") {
				this.showGiven(selection.chosen, shown);
				return;
			}
			if (selection.chosen !== this.shownFor) this.showChosenImages(selection.chosen, view);
			return;
		}
		const { unmeasured } = panes.look;
		const { openedAt } = this;
		const source = this.sourceOf(view, chosen.point);
		if (openedAt?.found === found && openedAt.source === source && openedAt.unmeasured === unmeasured) return;
		this.openedAt = {
			found,
			source,
			unmeasured
		};
		this.open(chosen.detail, view);
	}
	showDraft() {
		const panes = this.seen.panes();
		const scale = Math.max(LEAST_SCALE, ...panes.map(({ transform }) => transform.scale));
		const views = panes.flatMap((pane) => {
			const at = this.measuring.placeIn(pane);
			if (at === null || !isOn(pane, at)) return [];
			const { left, top, width, height } = pane.rect;
			const inner = {
				left: left + width / 8,
				top: top + height / 8,
				width: .75 * width,
				height: .75 * height
			};
			return contains(inner, ...toCanvas(pane.transform, ...at)) ? [] : [[pane.image, viewAt(at, scale)]];
		});
		if (views.length > 0) this.seen.store.dispatch({
			type: "moveViews",
			views: new Map(views)
		});
	}
	afterEdit(found, view) {
		const { last } = this;
		this.last = {
			found,
			view
		};
		if (last?.found !== found || last.view === view || this.openedAt === null) return;
		const [point] = pointsOf(this.seen.store.state.selection.chosen);
		if (point !== void 0) this.openedAt = {
			...this.openedAt,
			source: this.sourceOf(view, point)
		};
	}
	sourceOf({ points }, point) {
		return points.sources[point] ?? codeOfSource({ tie_point: point });
	}
	showGiven(chosen, shown) {
		const { store } = this.seen;
		if (chosen !== this.shownFor) {
			const images = this.imagesOfGiven(chosen.name, shown);
			if (images === null) return;
			this.shownFor = chosen;
			this.openedAt = null;
			store.dispatch({
				type: "showImages",
				images
			});
			this.pending = new Set(images);
		}
		if (this.pending.size === 0) return;
		const known = this.knownPlaces();
		const panes = this.seen.panes().filter(({ image }) => this.pending.has(image));
		const full = Math.max(LEAST_SCALE, ...panes.map((pane) => fillScale(pane.rect, pane)));
		const views = panes.flatMap((pane) => {
			const at = known.get(pane.image) ?? this.measuring.ofGround(pane);
			return at === null ? [] : [[pane.image, viewAt(at, full)]];
		});
		const moved = new Set(views.map(([image]) => image));
		const done = new Set(panes.filter(({ image, points }) => moved.has(image) || points !== null).map(({ image }) => image));
		if (done.size > 0) this.pending = new Set([...this.pending].filter((image) => !done.has(image)));
		if (views.length > 0) store.dispatch({
			type: "moveViews",
			views: new Map(views)
		});
	}
	imagesOfGiven(name, { view, given }) {
		const { panes } = this.seen.store.state;
		const measured = [...this.knownPlaces().keys()];
		const place = given.find((own) => own.name === name)?.place ?? null;
		const within = place === null ? null : this.seen.facts.ground();
		if (place !== null && within === null) return null;
		const likely = place === null || within === null ? [] : footprintsAt(within.footprints, [place[0], place[1]]);
		if (likely.length > 0) return [...new Set([...measured, ...likely])].slice(0, 9);
		const [near] = measured;
		const others = near === void 0 ? [...shownImages(panes, view), ...likeliest(view, near)] : likeliest(view, near);
		return [...new Set([...measured, ...others])].slice(0, Math.min(9, Math.max(4, measured.length)));
	}
	knownPlaces() {
		return new Map([...this.measuring.marks(), ...this.measuring.ownPlaces()]);
	}
	showChosenImages(chosen, view) {
		this.shownFor = chosen;
		const images = chosen?.kind === "image" || chosen?.kind === "images" || chosen?.kind === "pair" ? imagesOf(chosen).slice(0, 9) : [];
		const shown = shownImages(this.seen.store.state.panes, view);
		const is = images.every((image) => shown.includes(image)) && (chosen?.kind === "image" || shown.length === images.length);
		if (images.length > 0 && !is) this.seen.store.dispatch({
			type: "showImages",
			images
		});
	}
	open(detail, view) {
		const { store } = this.seen;
		const { panes } = store.state;
		const places = new Map(detail.observations.map(({ image, x_px, y_px }) => [image, [x_px, y_px]]));
		const isSurveyed = detail.id !== null && "ground_control" in detail.id;
		if (panes.look.unmeasured || isSurveyed) for (const { image, x_px, y_px } of detail.elsewhere) places.set(image, [x_px, y_px]);
		for (const [image, at] of this.measuring.ownPlaces()) places.set(image, at);
		if (places.size === 0) return;
		const before = shownImages(panes, view);
		const scale = this.seen.active()?.transform.scale ?? 0;
		const images = [...before.filter((image) => places.has(image)), ...[...places.keys()].filter((image) => !before.includes(image))].slice(0, 9);
		store.dispatch({
			type: "showImages",
			images
		});
		const full = Math.max(LEAST_SCALE, scale, ...this.seen.panes().map((pane) => fillScale(pane.rect, pane)));
		store.dispatch({
			type: "moveViews",
			views: new Map(images.map((image) => [image, viewAt(places.get(image), full)]))
		});
	}
};
function viewAt(at, scale) {
	const [x, y] = at ?? [0, 0];
	return {
		x,
		y,
		scale
	};
}
// www/block/view/images/paint.ts
var MOST_RINGS = 3e3;
function paintPictures(context, bitmaps, panes, ratio) {
	for (const pane of panes) paintPart(context, bitmaps, pane, pane.transform, pane.rect, "pane", ratio);
	bitmaps.keep(new Set(panes.flatMap(({ file }) => file?.id ?? [])));
}
function paintLenses(context, bitmaps, lenses, ratio) {
	for (const { pane, rect, transform } of lenses) paintPart(context, bitmaps, pane, transform, rect, "loupe", ratio);
}
function paintPart(context, bitmaps, pane, t, clip, slot, ratio) {
	within(context, clip, () => {
		context.fillStyle = "#0c0e10";
		context.fillRect(clip.left, clip.top, clip.width, clip.height);
		if (pane.file === null) return;
		smooth(context, t.scale, ratio);
		const part = visiblePart(pane, t, clip);
		for (const { bitmap, x, y, step } of bitmaps.pieces(pane.file, pane, slot, part, t.scale * ratio)) paintBitmap(context, bitmap, x, y, step, part, t);
	});
}
function paintMarks(context, seen, panes) {
	const { points: shown, vectors } = seen.store.state.panes.look;
	for (const pane of panes) {
		const { points, rect, transform } = pane;
		if (points !== null) within(context, rect, () => {
			if (shown) drawObservations(context, points, seen.marked(pane.image), transform, rect);
			if (vectors > 0) drawResiduals(context, points, seen.marked(pane.image), vectors, pane);
		});
		if (vectors > 0) drawScaleBar(context, vectors, pane);
	}
}
function paintOverlay(context, seen, measuring, panes, lenses, pointed) {
	paintChosen(context, seen, panes);
	paintGiven(context, measuring, panes);
	paintLines$1(context, seen, measuring, panes, pointed);
	paintDraft(context, seen, measuring, panes);
	for (const { pane, rect, transform } of lenses) {
		within(context, rect, () => {
			if (pane.points !== null) drawObservations(context, pane.points, seen.marked(pane.image), transform, rect);
			crosshair(context, rect);
		});
		lensFrame(context, rect);
	}
}
function paintChosen(context, seen, panes) {
	const { chosen, pointed } = seen.store.state.selection;
	const alone = seen.chosen();
	for (const pane of panes) {
		const { points } = pane;
		if (points === null) continue;
		within(context, pane.rect, () => {
			for (const point of pointsOf(chosen).subarray(0, MOST_RINGS)) {
				const place = placeOfPoint(points, point);
				if (place !== null) ring(context, pane, place, 9, SELECTED, 2.5);
			}
			for (const point of pointsOf(pointed).subarray(0, 1)) {
				const place = placeOfPoint(points, point);
				if (place !== null) ring(context, pane, place, 7, CANDIDATE, 1.5);
			}
			const predicted = alone?.detail.observations.find(({ image }) => image === pane.image)?.predicted_px;
			if (predicted != null) paintPredicted(context, pane, predicted);
			const elsewhere = alone?.detail.elsewhere.find(({ image }) => image === pane.image);
			if (elsewhere !== void 0) drawExpected(context, pane, [elsewhere.x_px, elsewhere.y_px]);
		});
	}
}
function paintGiven(context, measuring, panes) {
	const marks = measuring.marks();
	for (const pane of panes) within(context, pane.rect, () => {
		const place = marks.get(pane.image);
		const expected = place === void 0 && measuring.draft === null ? measuring.ofGround(pane) : null;
		if (place !== void 0) ring(context, pane, place, 9, SELECTED, 2.5);
		if (expected !== null) drawExpected(context, pane, expected);
	});
}
function sourceOfLines(seen, panes, pointed) {
	const pane = pointed === null ? seen.active() : panes.find(({ image }) => image === pointed.image) ?? null;
	const [point] = pointsOf(seen.store.state.selection.chosen);
	const place = point === void 0 || pane?.points == null ? null : placeOfPoint(pane.points, point);
	if (pane !== null && place !== null) return {
		image: pane.image,
		at: place
	};
	return seen.store.state.panes.look.loupe ? pointed : null;
}
function paintLines$1(context, seen, measuring, panes, pointed) {
	const source = sourceOfLines(seen, panes, pointed);
	for (const pane of panes) {
		const measured = measuring.sources(pane.image);
		for (const { image, at } of measured.length > 0 || source === null || source.image === pane.image ? measured : [source]) {
			const line = seen.facts.line(image, at, pane.image);
			if (line !== null && line.length > 0) drawLine(context, pane, line);
		}
	}
}
function paintDraft(context, seen, measuring, panes) {
	if (measuring.draft === null) return;
	const active = seen.active()?.image;
	for (const pane of panes) {
		const expected = measuring.expected(pane);
		if (expected !== null) drawExpected(context, pane, expected);
		const at = measuring.placeIn(pane);
		if (at !== null) drawCross$1(context, pane, at, pane.image === active);
	}
}
function paintPredicted(context, pane, at) {
	const [x, y] = toCanvas(pane.transform, ...at);
	const path = new Path2D();
	path.moveTo(x - 4, y - 4);
	path.lineTo(x + 4, y + 4);
	path.moveTo(x - 4, y + 4);
	path.lineTo(x + 4, y - 4);
	context.lineWidth = 3;
	context.strokeStyle = "rgb(0 0 0 / 0.6)";
	context.stroke(path);
	context.lineWidth = 1.5;
	context.strokeStyle = CANDIDATE;
	context.stroke(path);
}
// www/block/view/images/seen.ts
var NARROW = 720;
var NOBODY = new Set();
var Seen = class {
	store;
	facts;
	size;
	constructor(store, facts, size) {
		this.store = store;
		this.facts = facts;
		this.size = size;
	}
	get isLaid() {
		return this.size().isLaid;
	}
	view() {
		return this.store.state.shown?.view ?? null;
	}
	get isNarrow() {
		return window.innerWidth < NARROW;
	}
	panes() {
		const view = this.view();
		if (view === null) return [];
		const { width, height } = this.size();
		return panesOf(this.store.state, view, this.facts, this.columns(view, width, height), width, height);
	}
	active() {
		const panes = this.panes();
		return panes.find(({ image }) => image === this.store.state.panes.active) ?? panes[0] ?? null;
	}
	chosen() {
		const [point, ...more] = pointsOf(this.store.state.selection.chosen);
		if (point === void 0 || more.length > 0) return null;
		const detail = this.facts.point(point);
		return detail === null ? null : {
			point,
			detail
		};
	}
	marked(image) {
		const { shown, selection } = this.store.state;
		if (shown === null) return {
			byHand: NOBODY,
			keeps: () => false
		};
		return {
			byHand: handMeasured(shown.view, shown.edits).get(image) ?? NOBODY,
			keeps: keptBy("points", shown.view, selection)
		};
	}
	sameGround(from, to, at) {
		if (from?.points == null || to.points === null) return null;
		const moved = inOtherImage(from.points, to.points, at);
		const [point] = pointsOf(this.store.state.selection.chosen);
		const [own, other] = point === void 0 ? [null, null] : [placeOfPoint(from.points, point), placeOfPoint(to.points, point)];
		const known = own === null ? null : inOtherImage(from.points, to.points, own);
		if (moved === null || own === null || other === null || known === null) return moved;
		return [moved[0] + other[0] - known[0], moved[1] + other[1] - known[1]];
	}
	columns(view, across, down) {
		const images = shownImages(this.store.state.panes, view);
		const { width = 4, height = 3 } = view.images[images[0] ?? 0] ?? {};
		return columnsOf(images.length, across, down, width / height, this.isNarrow);
	}
};
var handMeasured = remember((view, edits) => {
	const { measured } = standingOf(edits);
	const indices = new Map([...view.points.sources].map((code, point) => [code, point]));
	return new Map([...measured].map(([image, codes]) => [image, new Set([...codes].flatMap((code) => indices.get(code) ?? []))]));
});
// www/block/view/images/images.ts
var LAYERS = [
	"pictures",
	"marks",
	"lenses",
	"overlay"
];
var REACH$3 = 14;
var NARROW_HEIGHT = 220;
var ImagesView = class {
	host;
	store;
	looking;
	seen;
	measuring;
	moving;
	opening;
	layers;
	bitmaps;
	pointer = null;
	listeners = [];
	constructor(host, store, looking$1, facts, engine) {
		this.host = host;
		this.store = store;
		this.looking = looking$1;
		this.layers = new Layers(host, LAYERS, (name, context) => this.draw(name, context));
		this.seen = new Seen(store, facts, () => this.layers);
		this.bitmaps = new Bitmaps((file) => engine.grey(file), () => this.layers.redraw("pictures", "lenses"));
		this.measuring = new Measuring(store, engine, facts, () => this.seen.panes());
		this.moving = new Moving(this.seen);
		this.opening = new Opening(this.seen, this.measuring);
		const looks = declare({
			where: say("images-of-a-block"),
			host,
			list: looking(this)
		});
		const measures = declare({
			where: say("images-of-a-block-measuring"),
			host,
			list: measuringKeys(this),
			lacks: say("nothing-is-measured")
		});
		listen(host, {
			at: (x, y) => paneAt(this.seen.panes(), x, y)?.image ?? null,
			focused: () => this.seen.active()?.image ?? null,
			pan: (image, dx, dy) => this.moving.pan(image, dx, dy),
			zoom: (image, factor, x, y) => this.moving.zoom(image, factor, x, y),
			zoomMiddle: (factor) => this.moving.zoomMiddle(factor),
			fit: () => this.moving.fit(),
			grabbed: (image) => store.dispatch({
				type: "activeImage",
				image
			}),
			pressed: (x, y, more) => this.press(x, y, more),
			pointed: (at, dragging) => this.point(at, dragging),
			command: (key, shift) => measures(key, shift) || looks(key, shift)
		}, host.parentElement ?? host);
		facts.watch(() => {
			this.opening.follow();
			this.changed();
		});
		store.watch([
			"shown",
			"panes",
			"selection",
			"files",
			"running",
			"onStage",
			"draft"
		], () => {
			this.opening.follow();
			this.changed();
		});
		new ResizeObserver(() => this.lay()).observe(host.parentElement ?? host);
		new ResizeObserver(() => {
			this.opening.follow();
			this.tell();
		}).observe(host);
	}
	watch(changed) {
		this.listeners.push(changed);
	}
	pointedAt() {
		if (this.pointer === null) return null;
		const pane = paneAt(this.seen.panes(), ...this.pointer);
		if (pane === null) return null;
		const at = toPosition(pane.transform, ...this.pointer);
		return isOn(pane, at) ? {
			image: pane.image,
			at
		} : null;
	}
	hasFailed({ file }) {
		return file !== null && this.bitmaps.hasFailed(file);
	}
	turn(by) {
		const view = this.seen.view();
		if (view === null) return;
		const known = this.measuring.known();
		const order = likeliest(view, [...known.keys()][0]);
		this.store.dispatch({
			type: "showImages",
			images: turned(shownImages(this.store.state.panes, view), order, new Set(known.keys()), by)
		});
	}
	step(by) {
		const pane = this.seen.active();
		const of = pane?.points;
		if (pane === null || of == null || of.points.length === 0) return;
		const rows = [...of.points.keys()].sort((a, b) => (of.places[2 * a + 1] ?? 0) - (of.places[2 * b + 1] ?? 0) || (of.places[2 * a] ?? 0) - (of.places[2 * b] ?? 0));
		const [now] = pointsOf(this.store.state.selection.chosen);
		const at = rows.findIndex((row) => of.points[row] === now);
		const next = rows[at < 0 ? by > 0 ? 0 : rows.length - 1 : (at + by + rows.length) % rows.length];
		const point = next === void 0 ? void 0 : of.points[next];
		if (point !== void 0) this.looking.choose({
			kind: "observation",
			point,
			image: pane.image
		});
	}
	other() {
		const panes = this.seen.panes();
		const next = panes[(panes.findIndex(({ image }) => image === this.seen.active()?.image) + 1) % Math.max(1, panes.length)];
		if (next !== void 0) this.store.dispatch({
			type: "activeImage",
			image: next.image
		});
	}
	match() {
		this.measuring.match(this.seen.active()).then(() => this.opening.showDraft());
	}
	matchAlone() {
		this.measuring.matchAlone(this.seen.active()).then(() => this.opening.showDraft());
	}
	changed() {
		this.lay();
		this.layers.redraw();
		this.tell();
	}
	tell() {
		for (const listener of this.listeners) listener();
	}
	lay() {
		const view = this.seen.view();
		const count = view === null ? 0 : shownImages(this.store.state.panes, view).length;
		const wanted = this.seen.isNarrow && count > 1 ? `${String(count * NARROW_HEIGHT)}px` : "";
		if (this.host.style.minHeight !== wanted) this.host.style.minHeight = wanted;
	}
	hit(x, y) {
		const pane = paneAt(this.seen.panes(), x, y);
		if (pane?.points == null || !this.store.state.panes.look.points) return null;
		const { keeps } = this.seen.marked(pane.image);
		const row = nearestRow(pane.points, pane, ...toPosition(pane.transform, x, y), REACH$3 / pane.transform.scale, keeps);
		const point = row < 0 ? void 0 : pane.points.points[row];
		return point === void 0 ? null : {
			pane,
			point
		};
	}
	press(x, y, more) {
		const panes = this.seen.panes();
		if (this.measuring.draft !== null) {
			const { pane, transform } = this.lenses(panes).find(({ rect }) => contains(rect, x, y)) ?? {
				pane: paneAt(panes, x, y),
				transform: paneAt(panes, x, y)?.transform
			};
			if (pane !== null && transform !== void 0) this.measuring.place(pane, toPosition(transform, x, y));
			this.opening.showDraft();
			return;
		}
		const hit = this.hit(x, y);
		if (more) {
			if (hit !== null) this.looking.choose(withMore(this.store.state.selection.chosen, [hit.point]));
			return;
		}
		this.opening.again();
		this.looking.choose(hit === null ? null : {
			kind: "observation",
			point: hit.point,
			image: hit.pane.image
		});
		this.opening.follow();
	}
	point(at, dragging) {
		this.pointer = at;
		if (!dragging) {
			const hit = at === null ? null : this.hit(...at);
			this.looking.point(hit === null ? null : {
				kind: "observation",
				point: hit.point,
				image: hit.pane.image
			});
		}
		this.layers.redraw("overlay", "lenses");
		this.tell();
	}
	lenses(panes) {
		if (this.measuring.draft !== null) return draftLenses(this.measuring, panes);
		const pointed = this.pointedAt();
		if (!this.store.state.panes.look.loupe || pointed === null || this.pointer === null) return [];
		return lensesAt(this.seen, panes, this.pointer, pointed);
	}
	draw(name, context) {
		const panes = this.seen.panes();
		const { ratio } = this.layers;
		if (name === "pictures") paintPictures(context, this.bitmaps, panes, ratio);
		else if (name === "marks") paintMarks(context, this.seen, panes);
		else if (name === "lenses") paintLenses(context, this.bitmaps, this.lenses(panes), ratio);
		else paintOverlay(context, this.seen, this.measuring, panes, this.lenses(panes), this.pointedAt());
	}
};
// www/block/state/place-on.ts
function placeOnOrthophoto({ placing: { orthophoto }, shown, selection: { chosen } }) {
	if (orthophoto === null || orthophoto.ofBlock !== null || shown === null || chosen === null) return null;
	const { view, given } = shown;
	const [point, ...more] = pointsOf(chosen);
	const known = point === void 0 || more.length > 0 ? void 0 : surveyedAt(view, point);
	const waits = chosen.kind === "given" ? given.find(({ name }) => name === chosen.name) : void 0;
	if (!isPlaceByHand(known?.name ?? waits?.name ?? "")) return null;
	if (waits !== void 0 && view.crs === null) return [waits.position[0], waits.position[1]];
	const place = known?.position ?? waits?.place ?? null;
	const to = toSystemOf(orthophoto, view);
	return place === null || to === null ? null : mapped(to, place[0], place[1]);
}
// www/block/view/orthophoto/links.ts
var LINK_STYLES = {
	used: {
		...ACCEPTED,
		name: say("link-use", { use: "used" })
	},
	check: {
		colour: CANDIDATE,
		shape: SHAPES.square,
		name: say("link-use", { use: "check" })
	},
	rejected: {
		...REJECTED$1,
		name: say("link-use", { use: "rejected" })
	}
};
var STYLES = [...USES$1.map((use) => LINK_STYLES[use]), MEASURED];
function useOf$1(code) {
	return USES$1[code] ?? "used";
}
var REACH$2 = 12;
function linksOnImage({ count, at, residuals, uses, byHand }) {
	const points = new Float64Array(3 * count);
	const vectors = new Float64Array(4 * count);
	for (let i = 0; i < count; i++) {
		const place = at.subarray(2 * i, 2 * i + 2);
		points.set(place, 3 * i);
		vectors.set(place, 4 * i);
		vectors.set(residuals.subarray(2 * i, 2 * i + 2), 4 * i + 2);
	}
	return {
		points,
		box: spreadOf(points),
		codes: codesOf(uses, byHand),
		vectors
	};
}
function linksOnGround({ places, uses, byHand }) {
	return pointsOnGround(places, codesOf(uses, byHand));
}
function pointsOnGround(places, codes) {
	const points = Float64Array.from(places, (value, i) => i % 3 === 0 ? value : i % 3 === 1 ? -value : 0);
	return {
		points,
		box: spreadOf(points),
		codes: Uint8Array.from(codes),
		vectors: new Float64Array()
	};
}
var BY_HAND = USES$1.length;
function codeOfUse(use, byHand) {
	return use === "used" && byHand ? BY_HAND : USES$1.indexOf(use);
}
function codesOf(uses, byHand) {
	return uses.map((use, i) => use === 0 && byHand[i] === 1 ? BY_HAND : use);
}
function spreadOf(points) {
	const box = [
		Infinity,
		Infinity,
		-Infinity,
		-Infinity
	];
	for (let i = 0; i < points.length; i += 3) {
		const [x = 0, y = 0] = points.subarray(i, i + 2);
		box[0] = Math.min(box[0], x);
		box[1] = Math.min(box[1], y);
		box[2] = Math.max(box[2], x);
		box[3] = Math.max(box[3], y);
	}
	return points.length === 0 ? [0, 0] : [box[2] - box[0], box[3] - box[1]];
}
function linkAt({ points, codes }, uses, t, x, y) {
	let [found, least] = [-1, REACH$2];
	for (let link = 0; 3 * link < points.length; link++) {
		if (!uses.has(useOf$1(codes[link] ?? 0))) continue;
		const [px, py] = toCanvas(t, points[3 * link] ?? 0, points[3 * link + 1] ?? 0);
		const distance = Math.hypot(px - x, py - y);
		if (distance < least) [found, least] = [link, distance];
	}
	return found;
}
function drawLinks(context, links, t, clip, uses) {
	const half = markSize(links, t);
	const styles = Float64Array.from(STYLES.flatMap(({ shape }, code) => [
		shape,
		code === BY_HAND ? LARGEST$1 : half,
		Math.min(1.6, .6 + .35 * half)
	]));
	draw_points(context, links.points, shownCodes(links, uses), styles, STYLES.map(({ colour }) => colour), drawView(t, clip));
}
var [SMALLEST, LARGEST$1] = [1, 4.5];
function markSize({ points, box: [width, height] }, { scale }) {
	const apart = scale * Math.sqrt(width * height / Math.max(1, points.length / 3));
	return Math.min(LARGEST$1, Math.max(SMALLEST, .3 * apart));
}
var NOT_DRAWN = 255;
function shownCodes({ codes }, uses) {
	const shown = STYLES.map((_, code) => uses.has(useOf$1(code)));
	return codes.map((code) => shown[code] === true ? code : NOT_DRAWN);
}
function drawLinkResiduals(context, links, factor, t, clip, uses) {
	draw_vectors(context, links.vectors, shownCodes(links, uses), Float64Array.of(1.2, 1.2, 1.2, 1.2), [
		RESIDUAL,
		CANDIDATE,
		RESIDUAL_REJECTED,
		RESIDUAL
	], factor, drawView(t, clip));
}
function drawCross(context, [x, y], colour) {
	context.save();
	for (const [stroke, width] of [["rgb(0 0 0 / 0.6)", 4], [colour, 2]]) {
		context.strokeStyle = stroke;
		context.lineWidth = width;
		context.beginPath();
		for (const [dx, dy] of [[1, 0], [0, 1]]) {
			context.moveTo(x - 12 * dx, y - 12 * dy);
			context.lineTo(x - 3 * dx, y - 3 * dy);
			context.moveTo(x + 3 * dx, y + 3 * dy);
			context.lineTo(x + 12 * dx, y + 12 * dy);
		}
		context.stroke();
	}
	context.restore();
}
function drawRing(context, { points }, link, t, chosen) {
	const [x, y] = points.subarray(3 * link, 3 * link + 2);
	if (x === void 0 || y === void 0) return;
	const [cx, cy] = toCanvas(t, x, y);
	context.save();
	for (const [colour, width] of [["rgb(0 0 0 / 0.6)", chosen ? 5 : 3.5], [SELECTED, chosen ? 2.5 : 1.5]]) {
		context.strokeStyle = colour;
		context.lineWidth = width;
		context.beginPath();
		context.arc(cx, cy, 10, 0, 2 * Math.PI);
		context.stroke();
	}
	context.restore();
}
// www/block/view/orthophoto/tiles.ts
var MOST_TILES = 400;
var AT_ONCE = 2;
var OVER_PX = .5;
var OrthophotoTiles = class {
	make;
	arrived;
	of = null;
	made = new Map();
	wanted = [];
	asked = new Set();
	constructor(make, arrived) {
		this.make = make;
		this.arrived = arrived;
	}
	paint(context, { raster, info }, lies, t, [width, height, ratio]) {
		this.keepOnly(raster);
		const ofMap = {
			a: t.scale,
			b: 0,
			c: 0,
			d: -t.scale,
			e: t.x,
			f: t.y
		};
		const toCanvas = after(ofMap, lies.whole);
		const coarsest = Math.max(0, Math.ceil(Math.log2(Math.max(info.width, info.height) / 512)));
		const level = Math.min(coarsest, Math.max(0, Math.floor(Math.log2(1 / (scaleOf(toCanvas) * ratio)))));
		const seen = partSeen(toCanvas, info, [width, height], lies.cells?.margin ?? 0);
		context.save();
		context.imageSmoothingEnabled = scaleOf(toCanvas) * ratio < 2 || level > 0;
		const missing = tilesOf(coarsest, seen, info).filter((tile) => !this.made.has(nameOf(tile)));
		for (const tile of tilesOf(level, seen, info)) {
			if (level < coarsest && !this.made.has(nameOf(tile))) missing.push(tile);
			const { a, b, c, d, e, f } = lies.cells === null ? toCanvas : after(ofMap, affineOfPart(lies, info, partOf(tile, info)));
			context.save();
			context.transform(a, b, c, d, e, f);
			const over = lies.cells === null ? 0 : OVER_PX / (scaleOf({
				a,
				b,
				c,
				d,
				e,
				f
			}) * ratio);
			this.paintTile(context, tile, coarsest, info, over);
			context.restore();
		}
		context.restore();
		this.ask(missing, seen);
	}
	paintTile(context, { level, column, row }, coarsest, { width, height }, over) {
		const side = 256 * 2 ** level;
		const [x, y] = [column * side, row * side];
		for (let up = 0; level + up <= coarsest; up++) {
			const name = nameOf({
				level: level + up,
				column: column >> up,
				row: row >> up
			});
			const bitmap = this.made.get(name);
			if (bitmap == null) continue;
			this.made.delete(name);
			this.made.set(name, bitmap);
			const step = 2 ** (level + up);
			const [left, top] = [x / step % 256, y / step % 256];
			const across = Math.min(256 / 2 ** up, bitmap.width - left, Math.ceil((width - x) / step));
			const down = Math.min(256 / 2 ** up, bitmap.height - top, Math.ceil((height - y) / step));
			context.drawImage(bitmap, left, top, across, down, x - over, y - over, across * step + 2 * over, down * step + 2 * over);
			return;
		}
	}
	ask(missing, [left, top, right, bottom]) {
		const [x, y] = [(left + right) / 2, (top + bottom) / 2];
		const far = ({ level, column, row }) => {
			const side = 256 * 2 ** level;
			return Math.hypot((column + .5) * side - x, (row + .5) * side - y);
		};
		this.wanted = missing.sort((a, b) => b.level - a.level || far(a) - far(b));
		this.next();
	}
	next() {
		while (this.asked.size < AT_ONCE) {
			const tile = this.wanted.find((candidate) => !this.asked.has(nameOf(candidate)));
			if (tile === void 0) return;
			this.wanted = this.wanted.filter((other) => other !== tile);
			this.fetch(tile, this.of);
		}
	}
	async fetch(tile, of) {
		const name = nameOf(tile);
		this.asked.add(name);
		try {
			const bitmap = await this.make(tile.level, tile.column, tile.row);
			if (this.of === of) this.made.set(name, bitmap);
			else bitmap.close();
		} catch (error) {
			if (this.of === of && !(error instanceof Cancelled)) this.made.set(name, null);
		}
		this.asked.delete(name);
		this.forgetOldest();
		this.next();
		this.arrived();
	}
	forgetOldest() {
		for (const [name, bitmap] of this.made) {
			if (this.made.size <= MOST_TILES) return;
			bitmap?.close();
			this.made.delete(name);
		}
	}
	keepOnly(raster) {
		if (this.of === raster) return;
		this.of = raster;
		for (const bitmap of this.made.values()) bitmap?.close();
		this.made.clear();
		this.wanted = [];
	}
};
function partSeen(toCanvas, { width, height }, [across, down], margin) {
	const back = inverse(toCanvas);
	const corners = [
		mapped(back, 0, 0),
		mapped(back, across, 0),
		mapped(back, 0, down),
		mapped(back, across, down)
	];
	const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
	const [left, top, right, bottom] = [
		Math.min(...xs) - margin,
		Math.min(...ys) - margin,
		Math.max(...xs) + margin,
		Math.max(...ys) + margin
	];
	return [
		Math.max(0, left),
		Math.max(0, top),
		Math.min(width, right),
		Math.min(height, bottom)
	];
}
function partOf({ level, column, row }, { width, height }) {
	const side = 256 * 2 ** level;
	return [
		column * side,
		row * side,
		Math.min(width, (column + 1) * side),
		Math.min(height, (row + 1) * side)
	];
}
function tilesOf(level, [left, top, right, bottom], { width, height }) {
	const side = 256 * 2 ** level;
	const last = (length, end) => Math.min(Math.ceil(length / side), Math.ceil(end / side));
	const tiles = [];
	for (let row = Math.floor(top / side); row < last(height, bottom); row++) for (let column = Math.floor(left / side); column < last(width, right); column++) tiles.push({
		level,
		column,
		row
	});
	return tiles;
}
function nameOf({ level, column, row }) {
	return `${String(level)} ${String(column)} ${String(row)}`;
}
// www/block/view/images/place-crop.ts
var PX = 3;
var PlaceCrop = class {
	frame;
	store;
	layers;
	tiles;
	constructor(frame, host, store, engine) {
		this.frame = frame;
		this.store = store;
		this.tiles = new OrthophotoTiles((level, column, row) => engine.tile(level, column, row), () => this.layers.redraw());
		this.layers = new Layers(host, ["picture"], (_, context) => this.paint(context));
		store.watch([
			"placing",
			"shown",
			"selection"
		], () => {
			frame.hidden = placeOnOrthophoto(store.state) === null;
			this.layers.redraw();
		});
	}
	paint(context) {
		const place = placeOnOrthophoto(this.store.state);
		const { orthophoto } = this.store.state.placing;
		if (place === null || orthophoto === null || this.frame.hidden) return;
		const { width, height, ratio } = this.layers;
		const scale = PX / orthophoto.info.gsd;
		const t = {
			scale,
			x: width / 2 - scale * place[0],
			y: height / 2 + scale * place[1]
		};
		this.tiles.paint(context, orthophoto, throughout(affineOf(orthophoto.info.georeference)), t, [
			width,
			height,
			ratio
		]);
		drawCross(context, [width / 2, height / 2], MEASURED.colour);
	}
};
// www/block/panel/image-legend.ts
var RING = "M13 8a5 5 0 1 0-10 0a5 5 0 1 0 10 0z";
var ARROW = "M2 8H14M10.5 5L14 8L10.5 11";
var CROSS = "M8 1.5v4M8 10.5v4M1.5 8h4M10.5 8h4";
var look = ({ seen }) => seen.store.state.panes.look;
var hasPoints = (view) => look(view).points;
var hasResiduals = (view) => look(view).vectors > 0;
var hasChosen = ({ seen }) => pointsOf(seen.store.state.selection.chosen).length > 0;
var isMeasuring = ({ measuring }) => measuring.draft !== null;
var ENTRIES = [
	{
		text: say("accepted"),
		mark: () => swatch(ACCEPTED),
		isDrawn: hasPoints
	},
	{
		text: say("legend-measured-by-hand"),
		mark: () => swatch(MEASURED),
		isDrawn: hasPoints
	},
	{
		text: say("rejected-2"),
		mark: () => swatch(REJECTED$1),
		isDrawn: hasPoints
	},
	{
		text: say("rejected-by-hand-2"),
		mark: () => swatch(REJECTED_BY_HAND),
		isDrawn: hasPoints
	},
	{
		text: say("legend-residual"),
		mark: () => lineSwatch(ARROW, RESIDUAL),
		isDrawn: hasResiduals
	},
	{
		text: say("legend-residual-rejected"),
		mark: () => lineSwatch(ARROW, RESIDUAL_REJECTED),
		isDrawn: hasResiduals
	},
	{
		text: say("legend-chosen"),
		mark: () => lineSwatch(RING, SELECTED),
		isDrawn: hasChosen
	},
	{
		text: say("legend-predicted"),
		mark: () => swatch({
			colour: CANDIDATE,
			shape: SHAPES.cross
		}),
		isDrawn: hasChosen
	},
	{
		text: say("legend-placed"),
		mark: () => lineSwatch(CROSS, SELECTED),
		isDrawn: isMeasuring
	},
	{
		text: say("predicted-not-measured"),
		mark: () => lineSwatch(RING, CANDIDATE, "3 2"),
		isDrawn: (view) => isMeasuring(view) || hasChosen(view) && look(view).unmeasured
	},
	{
		text: say("legend-epipolar"),
		mark: () => lineSwatch("M1 12L15 4", EPIPOLAR, "4 2.5"),
		isDrawn: (view) => isMeasuring(view) || hasChosen(view) || look(view).loupe
	}
];
function imageLegend(testid, view) {
	const legend = h("div", {
		class: "note image-legend",
		testid,
		role: "group",
		aria: { label: say("legend-of-marks") }
	});
	let shown = "";
	view.watch(() => {
		const now = ENTRIES.filter(({ isDrawn }) => isDrawn(view));
		const texts = now.map(({ text }) => text).join("|");
		if (texts === shown) return;
		shown = texts;
		fill(legend, ...now.map(({ text, mark }) => h("span", { class: "legend" }, mark(), text)));
	});
	return legend;
}
// www/block/panel/view.ts
var KEYS_ID = "block-keys";
// www/block/panel/images-view.ts
var KEYS$3 = say("press-a-point-every-image");
function imagesView(engine, placing, facts, addImages, ready) {
	return {
		name: "images",
		title: say("images-2"),
		mount: (store, looking) => {
			const host = h("div", {
				class: "view image-panes",
				testid: "block-panes",
				tabindex: 0,
				role: "group",
				aria: {
					roledescription: say("images-of-the-block-2"),
					label: say("images-side-by-side-with"),
					describedby: KEYS_ID
				}
			});
			const place = h("p", {
				class: "image-place",
				testid: "image-place"
			});
			const point = h("p", {
				class: "image-point",
				testid: "image-point",
				role: "status",
				aria: { live: "polite" }
			});
			const element = h("div", {
				class: "images-view",
				tabindex: -1
			}, h("div", { class: "image-row" }, cropOf(store, placing), h("div", { class: "image-scroll" }, host)), h("div", { class: "image-said" }, point, place));
			element.addEventListener("focus", () => host.focus());
			const view = new ImagesView(host, store, looking, facts, engine);
			mountFrames(host, view, store, addImages);
			ready({
				toggle: (anew) => {
					view.measuring.toggle(anew);
					if (view.measuring.draft === null) return;
					view.opening.showDraft();
					host.focus();
				},
				match: () => view.match(),
				matchAlone: () => view.matchAlone()
			});
			view.watch(() => {
				setText$1(place, placeText$1(store, view));
				setText$1(point, pointText(store, view));
			});
			return {
				element,
				tools: [toolsOf$2(host, store, view, looking)],
				legend: imageLegend("image-legend", view),
				zoomable: view.moving,
				keys: KEYS$3
			};
		}
	};
}
function cropOf(store, placing) {
	const picture = h("div", {
		class: "view",
		testid: "place-crop-picture",
		role: "img",
		aria: { label: say("the-place-on-the-orthophoto") }
	});
	const crop = h("div", {
		class: "place-crop",
		testid: "place-crop"
	}, picture, h("p", { class: "ortho-name" }, say("orthophoto")));
	crop.hidden = true;
	new PlaceCrop(crop, picture, store, placing);
	return crop;
}
function setText$1(element, text) {
	if (element.textContent !== text) element.textContent = text;
}
function mountFrames(host, view, store, addImages) {
	let frames = new Map();
	let of = null;
	view.watch(() => {
		const found = store.state.shown?.found ?? null;
		const panes = view.seen.panes();
		const known = found === of ? frames : new Map();
		of = found;
		const next = new Map(panes.map((pane) => [pane.image, known.get(pane.image) ?? frameOf(pane.image, view, store, addImages)]));
		for (const [image, { element }] of frames) if (next.get(image)?.element !== element) element.remove();
		for (const [, { element }] of next) if (element.parentElement === null) host.append(element);
		frames = next;
		for (const pane of panes) frames.get(pane.image)?.show(pane);
	});
}
function frameOf(image, view, store, addImages) {
	const name = h("span", {});
	const figures = h("span", {
		class: "pane-figures",
		testid: `figures-${String(image)}`
	});
	const close = button("×", `close-image-${String(image)}`, () => {
		const { panes, shown } = store.state;
		if (shown !== null) store.dispatch({
			type: "showImages",
			images: shownImages(panes, shown.view).filter((other) => other !== image)
		});
		passFocus(close, [view.host]);
	});
	const absent = h("div", { class: "pane-absent" });
	const add = button(say("add-images"), `add-image-${String(image)}`, addImages);
	add.className = "invitation";
	const head = h("div", { class: "pane-head" }, h("span", { class: "pane-name" }, name), figures, close);
	const element = h("div", {
		class: "pane-frame",
		testid: `pane-image-${String(image)}`
	}, head, absent);
	let said = "";
	return {
		element,
		show: (pane) => {
			const { left, top, width, height } = pane.rect;
			Object.assign(element.style, {
				left: `${String(left)}px`,
				top: `${String(top)}px`,
				width: `${String(width)}px`,
				height: `${String(height)}px`
			});
			const { panes, shown } = store.state;
			const own = shown?.view.images[image]?.name ?? "";
			setText$1(name, own);
			close.setAttribute("aria-label", say("close", { own }));
			close.hidden = shown === null || shownImages(panes, shown.view).length < 2;
			element.classList.toggle("is-active", panes.active === image);
			const figure = view.measuring.marks().has(image) ? say("measured") : figuresOf$2(view.seen.chosen()?.detail ?? null, image);
			setText$1(figures, figure);
			head.title = figure === "" ? own : `${asFigure(own)}: ${figure}`;
			const why = pane.file === null ? say("the-file-of-this-image") : view.hasFailed(pane) ? say("this-image-cannot-be-decoded") : "";
			if (why === said) return;
			said = why;
			fill(absent, ...why === "" ? [] : [h("p", {}, why), ...pane.file === null ? [add] : []]);
		}
	};
}
var PARTS = {
	accepted: "",
	gross_error: say("rejected-gross-error"),
	behind: say("rejected-behind-the-image"),
	lost_point: say("rejected-its-point-has-too"),
	does_not_fit: say("rejected-does-not-fit"),
	rejected_by_hand: say("rejected-by-hand-2"),
	not_adjusted: say("not-adjusted")
};
function largest(pair) {
	const known = pair?.filter((value) => value !== null) ?? [];
	return known.length === 0 ? null : Math.max(...known.map(Math.abs));
}
function figuresOf$2(detail, image) {
	const observation = detail?.observations.find((own) => own.image === image);
	if (observation === void 0) return detail?.elsewhere.some((other) => other.image === image) === true ? say("predicted-not-measured") : "";
	const { residual_px: residual, part, by_hand } = observation;
	const [w, mdb] = [largest(observation.w), largest(observation.detectable_px)];
	return [
		residual === null ? "" : say("v-px", {
			residual: residual[0],
			residual_2: residual[1]
		}),
		w === null ? "" : `w ${fixed(w, 1)}`,
		mdb === null ? "" : say("mdb-px", { mdb }),
		PARTS[part],
		by_hand ? say("by-hand") : ""
	].filter((part) => part !== "").join(" · ");
}
function pointText({ state }, view) {
	const chosen = view.seen.chosen();
	if (state.shown === null) return "";
	if (chosen === null) return state.selection.chosen === null ? "" : describe(state.shown, state.selection.chosen);
	const { view: shown } = state.shown;
	const { id, name, position, errors, rmse_px, observations, elsewhere } = chosen.detail;
	const panes = shownImages(state.panes, shown);
	const seen = observations.filter(({ image }) => panes.includes(image)).length;
	const of = (...parts) => observations.filter(({ part }) => parts.includes(part)).length;
	const taking = of("accepted") || of("lost_point", "rejected_by_hand") || observations.length;
	const rejected = observations.length - taking;
	const [worst] = observations.map(({ image, w }) => ({
		image,
		w: largest(w) ?? 0
	})).sort((a, b) => b.w - a.w);
	return [
		name ?? `${id !== null && "manual" in id ? say("point-by-hand") : say("tie-point")} ${count(shown.points.numbers[chosen.point] ?? null)}`,
		position === null ? say("not-intersected") : coordinatesText(shown, position, 3),
		errors === null ? "" : inUnitOf(shown, `± ${errors.map((value) => fixed(value, 3)).join(" ")}`),
		say("rays", {
			observations: taking,
			what: (rejected > 0 ? say("rays-rejected", { rejected }) : "") + (seen < observations.length ? say("shown", { seen }) : "")
		}),
		rmse_px === null ? "" : say("rmse-px-3", { rmse_px }),
		worst === void 0 || worst.w === 0 ? "" : say("largest-w-in", {
			w: worst.w,
			name: shown.images[worst.image]?.name ?? ""
		}),
		elsewhere.length === 0 ? "" : say("not-measured-in-more", { elsewhere: elsewhere.length })
	].filter((part) => part !== "").join(" · ");
}
function placeText$1({ state }, view) {
	const pointed = view.pointedAt();
	const shown = state.shown?.view;
	return pointed === null || shown === void 0 ? "" : textOfPlace(pointed, shown, view);
}
function textOfPlace({ image, at }, shown, view) {
	const { name = "", camera = -1 } = shown.images[image] ?? {};
	const of = shown.cameras[camera];
	const mm = of === void 0 ? null : photoMm(of, at);
	const points = view.seen.panes().find((pane) => pane.image === image)?.points ?? null;
	const ground = points === null ? null : groundAt(points, shown.points, ...at);
	return [
		say("px", {
			name,
			at: at[0],
			at_2: at[1]
		}),
		mm === null ? "" : say("mm", {
			mm: mm[0],
			mm_2: mm[1]
		}),
		ground === null ? "" : say("ground-about", { join: coordinatesText(shown, ground, 2) })
	].filter((part) => part !== "").join(" · ");
}
function toolsOf$2(host, store, view, looking) {
	const set = (look) => store.dispatch({
		type: "look",
		look
	});
	const points = toggle(say("points"), "images-points", say("show-the-observations-of-tie"), (on) => set({ points: on }));
	const [vectors, vectorSelect] = vectorChoice("images-vectors", (factor) => set({ vectors: factor }));
	const linked = toggle(say("linked"), "images-linked", say("pan-and-zoom-all-images"), (on) => set({ linked: on }));
	const loupe = toggle(say("loupe"), "images-loupe", say("enlarge-what-is-under-the"), (on) => set({ loupe: on }));
	const unmeasured = toggle(say("unmeasured"), "images-unmeasured", say("show-a-chosen-point-where"), (on) => set({ unmeasured: on }));
	const [adding, addSelect] = choice(say("show"), "images-add", [["", say("image")]], (value) => {
		const { panes, shown } = store.state;
		addSelect.value = "";
		if (shown === null || value === "") return;
		const before = shownImages(panes, shown.view);
		store.dispatch({
			type: "showImages",
			images: [...before.slice(0, 8), Number(value)]
		});
	});
	const pair = button(say("open-as-pair"), "images-pair", () => {
		const images = pairOf(store);
		if (images !== null) looking.open(images);
	});
	declareLack([pair], () => pairOf(store) === null ? say("needs-two-shown") : "");
	pair.title = say("match-the-two-images-that");
	const unfold = h("button", {
		type: "button",
		class: "menu-button",
		testid: "images-menu"
	}, say("view"));
	const light = makeLight("images-", host, set, [[unfold, say("view-2")]]);
	const more = h("div", {
		class: "more image-more",
		id: "images-more"
	}, labelled("1:1", "images-actual", say("n-1-1-one-image-pixel"), () => view.moving.actualSize()), ...light.elements, adding, imageLegend("images-menu-legend", view));
	const other = button(say("other-images"), "images-other", () => view.turn(1), say("other-images-title"));
	mountMenu(unfold, more);
	store.watch(["panes", "shown"], ([panes, shown]) => {
		const { look } = panes;
		for (const [made, on] of [
			[points, look.points],
			[linked, look.linked],
			[loupe, look.loupe],
			[unmeasured, look.unmeasured]
		]) made.setAttribute("aria-pressed", String(on));
		vectorSelect.value = String(look.vectors);
		light.show(look);
		pair.hidden = pairOf(store) === null;
		other.hidden = shown === null || shownImages(panes, shown.view).length >= shown.view.images.length;
		const names = shown?.view.images.map(({ name }) => name) ?? [];
		if (addSelect.dataset.names === names.join("\n")) return;
		addSelect.dataset.names = names.join("\n");
		fill(addSelect, new Option(say("image"), ""), ...names.map((name, image) => new Option(name, String(image))));
	});
	store.watch([
		"running",
		"notice",
		"placing"
	], () => {
		pair.disabled = isBusy(store.state);
	});
	return h("div", { class: "image-tools" }, points, vectors, linked, loupe, unmeasured, pair, other, unfold, more);
}
function pairOf({ state: { panes, shown } }) {
	const [a, b, ...more] = shown === null ? [] : shownImages(panes, shown.view);
	return a === void 0 || b === void 0 || more.length > 0 ? null : [a, b];
}
// www/shared/view/colours.ts
var NAMES = [
	"text",
	"muted",
	"line",
	"accent",
	"problem",
	"good",
	"bars",
	"ground",
	"surface"
];
var known = null;
function themeColours() {
	known ??= readColours();
	return known;
}
function readColours() {
	const probe = document.createElement("span");
	probe.style.setProperty("forced-color-adjust", "none");
	document.body.append(probe);
	const colours = Object.fromEntries(NAMES.map((name) => {
		probe.style.color = `var(--${name})`;
		return [name, getComputedStyle(probe).color];
	}));
	probe.remove();
	return colours;
}
function onRecolour(callback) {
	const changed = () => {
		known = null;
		callback();
	};
	new MutationObserver(changed).observe(document.documentElement, {
		attributes: true,
		attributeFilter: ["data-theme"]
	});
	matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
	matchMedia("(forced-colors: active)").addEventListener("change", changed);
}
// www/block/view/looking.ts
function press(store, looking, choice) {
	const again = isSame(choice, store.state.selection.chosen);
	if (choice?.kind === "pair" && again && !isBusy(store.state)) looking.open(choice.images);
	else looking.choose(choice);
}
// www/block/view/chart.ts
var WHERE = {
	map: say("map"),
	matrix: say("matrix"),
	plot: say("plots")
};
var Chart = class {
	store;
	looking;
	layers;
	moved = null;
	of = null;
	constructor(host, name, store, looking) {
		this.store = store;
		this.looking = looking;
		this.layers = new Layers(host, [name], (_, context) => {
			const view = this.view();
			if (view !== null && view.images.length > 0) this.paint(context, themeColours(), view, this.current(view));
		});
		onRecolour(() => this.layers.redraw());
		const ofChoice = declare({
			where: WHERE[name] ?? "",
			host,
			list: this.choiceKeys(),
			lacks: say("no-pair-is-chosen")
		});
		listen(host, {
			at: () => this.view(),
			focused: () => this.view(),
			pan: (view, dx, dy) => this.move(view, panned(this.current(view), dx, dy)),
			zoom: (view, factor, x, y) => this.zoom(view, factor, x, y),
			zoomMiddle: (factor) => this.zoomMiddle(factor),
			fit: () => this.fit(),
			pressed: (x, y) => press(store, looking, this.choiceAt(x, y)),
			encloses: (shift) => shift && this.enclosed !== null,
			enclosed: (view, from, to, ended, path) => this.enclosed?.(view, {
				from,
				to,
				path
			}, ended),
			pointed: (at, dragging) => {
				this.placed?.(at);
				if (!dragging) this.looking.point(at === null ? null : this.choiceAt(...at));
			},
			command: (key) => this.command(key) || ofChoice(key, false)
		});
		store.watch(["shown", "selection"], ([shown]) => {
			if (shown?.view !== this.of && !isSameBlock(this.of, shown?.view ?? null)) this.moved = null;
			this.of = shown?.view ?? null;
			this.layers.redraw();
		});
	}
	enclosed = null;
	placed = null;
	held(_view, t) {
		return t;
	}
	fit() {
		this.moved = null;
		this.layers.redraw();
	}
	zoomMiddle(factor) {
		const view = this.view();
		if (view !== null) this.zoom(view, factor, this.layers.width / 2, this.layers.height / 2);
	}
	view() {
		return this.store.state.shown?.view ?? null;
	}
	current(view) {
		return this.moved === null ? this.whole(view) : this.held(view, resized(this.moved.t, this.moved.on, this.layers));
	}
	move(view, t) {
		const { width, height } = this.layers;
		this.moved = {
			t: this.held(view, t),
			on: {
				width,
				height
			}
		};
		this.layers.redraw();
	}
	zoom(view, factor, x, y) {
		this.move(view, zoomedAbout(this.current(view), factor, x, y, this.limits(this.whole(view).scale)));
	}
	choiceAt(x, y) {
		const view = this.view();
		return view === null ? null : this.hit(view, this.current(view), x, y);
	}
	choiceKeys() {
		const pair = () => {
			const { chosen } = this.store.state.selection;
			return chosen?.kind === "pair" ? chosen.images : null;
		};
		const open = () => {
			const images = pair();
			if (images !== null) this.looking.open(images);
		};
		return [{
			keys: ["Enter"],
			does: say("opens-the-chosen-pair"),
			can: () => pair() !== null,
			run: open
		}, {
			keys: ["Escape"],
			does: say("chooses-nothing"),
			lacks: () => this.store.state.selection.chosen === null ? say("nothing-is-chosen") : "",
			run: () => this.looking.choose(null)
		}];
	}
};
function isSameBlock(before, after) {
	if (before === null || after === null || before.layout.kind !== after.layout.kind || before.partial !== after.partial) return false;
	return after.partial || before.images.length === after.images.length;
}
// www/block/view/matrix.ts
var LARGEST_WHOLE = 44;
var LARGEST = 160;
var HEAD = 30;
var NUMBERED = 30;
var Matrix = class extends Chart {
	constructor(host, store, looking) {
		super(host, "matrix", store, looking);
	}
	whole({ images: { length } }) {
		const room = Math.min(this.layers.width, this.layers.height) - HEAD - 4;
		const side = Math.min(LARGEST_WHOLE, room / Math.max(1, length));
		return {
			scale: side > 4 ? Math.floor(side) : side,
			x: HEAD,
			y: HEAD
		};
	}
	limits(whole) {
		return {
			least: whole,
			most: LARGEST
		};
	}
	held({ images: { length } }, { scale, x, y }) {
		const within = (shift, room) => Math.min(HEAD, Math.max(Math.min(HEAD, (HEAD + room) / 2 - length * scale), shift));
		return {
			scale,
			x: within(x, this.layers.width),
			y: within(y, this.layers.height)
		};
	}
	hit(view, t, x, y) {
		const [column, row] = toPosition(t, x, y).map(Math.floor);
		const inside = (index) => index >= 0 && index < view.images.length;
		return x >= HEAD && y >= HEAD && inside(column) && inside(row) ? choiceOf$1([row, column]) : null;
	}
	command(key) {
		const step = {
			ArrowLeft: [0, -1],
			ArrowRight: [0, 1],
			ArrowUp: [-1, 0],
			ArrowDown: [1, 0]
		}[key];
		const view = this.view();
		if (step === void 0 || view === null) return false;
		const [row, column] = cellOf(this.store.state.selection.chosen) ?? [0, 0];
		const inside = (index) => Math.min(Math.max(index, 0), view.images.length - 1);
		const cell = [inside(row + (step[0] ?? 0)), inside(column + (step[1] ?? 0))];
		this.looking.choose(choiceOf$1(cell));
		this.reveal(view, cell);
		return true;
	}
	reveal(view, [row, column]) {
		const t = this.current(view);
		const brought = (index, shift, room) => Math.max(HEAD - index * t.scale, Math.min(shift, room - (index + 1) * t.scale - 2));
		this.move(view, {
			scale: t.scale,
			x: brought(column, t.x, this.layers.width),
			y: brought(row, t.y, this.layers.height)
		});
	}
	paint(context, colours, view, t) {
		const { width, height } = this.layers;
		paintHeads(context, colours, view.images.length, t, width, height);
		within(context, {
			left: 29,
			top: 29,
			width,
			height
		}, () => {
			this.paintCells(context, colours, view, t);
			this.paintMarks(context, colours, view, t);
		});
	}
	paintCells(context, colours, view, t) {
		const { scale: side } = t;
		const count = view.images.length;
		const most = view.connections.reduce((high, connection) => Math.max(high, matchesOf$1(connection)), 1);
		const keeps = keptBy("pairs", view, this.store.state.selection);
		for (const [pair, connection] of view.connections.entries()) {
			if (!keeps(pair)) continue;
			const [a, b] = connection.images;
			const matches = matchesOf$1(connection);
			const tried = connection.outcome.kind === "connected";
			const alpha = tried ? .15 + .85 * Math.sqrt(matches / most) : .6;
			for (const [row, column] of [[a, b], [b, a]]) {
				const [x, y] = toCanvas(t, column, row);
				if (x > this.layers.width || y > this.layers.height || x + side < HEAD || y + side < HEAD) continue;
				context.globalAlpha = alpha;
				context.fillStyle = tried ? colours.bars : connection.outcome.kind === "failed" ? colours.problem : colours.muted;
				if (connection.rejected) paintRejected(context, colours, x, y, side);
				else paintCell(context, x, y, side, tried);
				context.globalAlpha = 1;
				if (tried && side >= NUMBERED) paintNumber(context, colours, x + side / 2, y + side / 2 + 3.5, matches);
			}
		}
		context.strokeStyle = colours.line;
		context.lineWidth = 1;
		context.strokeRect(t.x - .5, t.y - .5, count * side + 1, count * side + 1);
		context.fillStyle = colours.line;
		for (let i = 0; i < count; i++) context.fillRect(...toCanvas(t, i, i), side, side);
	}
	paintMarks(context, colours, view, t) {
		const { chosen, pointed } = this.store.state.selection;
		const { scale: side } = t;
		context.strokeStyle = colours.accent;
		context.lineWidth = 2;
		const cells = [...pairsOf(chosen), cellOf(pointed)].filter((cell) => cell !== null);
		for (const [row, column] of cells) {
			context.strokeRect(...toCanvas(t, column, row), side, side);
			if (connectionOf(view, [row, column]) !== void 0) context.strokeRect(...toCanvas(t, row, column), side, side);
		}
		if (chosen?.kind !== "image" && chosen?.kind !== "images") return;
		const length = view.images.length * side;
		for (const image of imagesOf(chosen)) {
			context.strokeRect(...toCanvas(t, 0, image), length, side);
			context.strokeRect(...toCanvas(t, image, 0), side, length);
		}
	}
};
function choiceOf$1([row, column]) {
	return row === column ? {
		kind: "image",
		image: row
	} : {
		kind: "pair",
		images: [row, column]
	};
}
function cellOf(choice) {
	const [row, column = row] = imagesOf(choice);
	return row === void 0 || column === void 0 ? null : [row, column];
}
function paintCell(context, x, y, side, connected) {
	const gap = side > 8 ? 1 : 0;
	const share = side > 12 ? .28 : .6;
	if (connected) context.fillRect(x, y, side - gap, side - gap);
	else context.fillRect(x + .5 * (1 - share) * side, y + .5 * (1 - share) * side, share * side, share * side);
}
function paintRejected(context, colours, x, y, side) {
	const width = side > 8 ? 2 : 1;
	context.globalAlpha = 1;
	context.strokeStyle = colours.problem;
	context.lineWidth = width;
	context.strokeRect(x + width, y + width, side - 2 * width - 1, side - 2 * width - 1);
}
function paintNumber(context, colours, x, y, matches) {
	context.font = "10px system-ui, sans-serif";
	context.textAlign = "center";
	context.lineWidth = 3;
	context.strokeStyle = colours.surface;
	context.strokeText(String(matches), x, y);
	context.fillStyle = colours.text;
	context.fillText(String(matches), x, y);
}
function paintHeads(context, colours, count, t, width, height) {
	const step = [
		1,
		2,
		5,
		10,
		20,
		50,
		100,
		200,
		500
	].find((s) => s * t.scale >= 24) ?? 1e3;
	context.font = "10px system-ui, sans-serif";
	context.fillStyle = colours.muted;
	for (let i = 0; i < count; i += step) {
		const [x, y] = toCanvas(t, i + .5, i + .5);
		context.textAlign = "center";
		if (x > HEAD && x < width) context.fillText(String(i + 1), x, 24);
		context.textAlign = "right";
		if (y > HEAD && y < height) context.fillText(String(i + 1), 25, y + 3.5);
	}
}
// www/block/panel/matrix-view.ts
var MATRIX_VIEW = {
	name: "matrix",
	title: say("matrix"),
	mount: (store, looking) => {
		const element = h("div", {
			class: "view block-matrix",
			testid: "block-matrix",
			tabindex: 0,
			role: "group",
			aria: {
				roledescription: say("matrix-of-matches"),
				label: say("images-by-images-arrow-keys"),
				describedby: KEYS_ID
			}
		});
		const cells = h("span", {
			class: "note",
			testid: "block-cells"
		});
		store.watch(["shown"], ([shown]) => fill(cells, shown === null ? "" : say("strongest-cell-matches-small-square", { view: mostMatches(shown.view) })));
		return {
			element,
			tools: [],
			legend: cells,
			zoomable: new Matrix(element, store, looking),
			keys: say("press-a-cell-to-choose")
		};
	}
};
// www/block/state/laid.ts
var laidUnder = remember((orthophoto, placed, files, shown, ground, system) => {
	if (orthophoto === null || shown === null || ground === null || shown.view.layout.kind !== "oriented") return null;
	if (orthophoto.ofBlock !== null) return orthophoto.ofBlock === shown.key ? byOne(orthophoto, SAME) : null;
	if (system === "surveyed" && overlap(orthophoto, ground.footprints)) return byOne(orthophoto, SAME);
	return byImages(orthophoto, placed, files, shown, ground) ?? onEarth(orthophoto, shown);
});
function byOne({ info }, toBlock, images = 0) {
	return {
		toBlock,
		sheet: throughout(after(toBlock, affineOf(info.georeference))),
		images,
		crs: null
	};
}
function byImages(orthophoto, placed, files, shown, { footprints }) {
	const [from, to] = [[], []];
	let images = 0;
	const index = new Map(shown.view.images.map(({ name }, i) => [name, i]));
	for (const { id, name } of files) {
		const result = placed.get(id)?.result ?? null;
		const image = index.get(name);
		if (image === void 0 || result?.verdict.kind !== "placed" || result.placement === null) continue;
		const corners = footprints.subarray(8 * image, 8 * image + 8);
		if (corners.length < 8 || Number.isNaN(corners[0])) continue;
		images += 1;
		cornersOf$2(result.placement).forEach((corner, i) => {
			from.push(corner);
			to.push([corners[2 * i] ?? 0, corners[2 * i + 1] ?? 0]);
		});
	}
	const toBlock = similarity(from, to);
	return toBlock === null ? null : byOne(orthophoto, toBlock, images);
}
function onEarth(orthophoto, { view }) {
	const between = betweenSystems(orthophoto, view);
	const { origin } = view;
	if (between?.kind !== "affine" || origin === null) return null;
	const toBlock = inverse(between.toOrthophoto);
	const crs = orthophoto.raster.degrees?.crs ?? between.crs;
	const height = Math.round(origin.height_m + groundOf(view));
	return {
		toBlock,
		sheet: sheetOnEarth(orthophoto, crs, origin.longitude_deg, origin.latitude_deg, origin.height_m, height) ?? byOne(orthophoto, toBlock).sheet,
		images: 0,
		crs
	};
}
var sheetOnEarth = remember(({ raster, info }, crs, longitude, latitude, origin, height) => {
	const toGround = affineOf(raster.degrees?.georeference ?? info.georeference);
	const exact = (pixels) => {
		const places = byAffine(toGround, pixels);
		const onEarth = system_positions(crs, Float64Array.from(places.flatMap(([x, y]) => [
			x,
			y,
			0
		])));
		for (let i = 2; i < onEarth.length; i += 3) onEarth[i] = height;
		const local = local_positions([
			longitude,
			latitude,
			origin,
			...onEarth
		]);
		return places.map((_, i) => [local[3 * i + 3] ?? NaN, local[3 * i + 4] ?? NaN]);
	};
	try {
		return sheetOf(exact, info);
	} catch {
		return null;
	}
});
function placeUnder({ crs, toBlock }, view, [x, y]) {
	const near = mapped(inverse(toBlock), x, y);
	const { origin } = view;
	if (crs === null || origin === null) return near;
	try {
		const onEarth = geographic_positions([
			origin.longitude_deg,
			origin.latitude_deg,
			origin.height_m,
			x,
			y,
			groundOf(view)
		]);
		const [u = NaN, v = NaN] = system_coordinates(crs, onEarth);
		return [u, v];
	} catch {
		return [NaN, NaN];
	}
}
function whyNotLaid(orthophoto, view) {
	const between = betweenSystems(orthophoto, view);
	return between?.kind === "problem" ? between.text : "";
}
function cornersOf$2({ footprint }) {
	return [
		0,
		1,
		2,
		3
	].map((corner) => footprint[Math.round(corner * footprint.length / 4)] ?? [NaN, NaN]);
}
function overlap({ info: { width, height, georeference } }, footprints) {
	const toGround = affineOf(georeference);
	const corners = [
		mapped(toGround, 0, 0),
		mapped(toGround, width, 0),
		mapped(toGround, 0, height),
		mapped(toGround, width, height)
	];
	const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
	const within = (value, all) => value >= Math.min(...all) && value <= Math.max(...all);
	for (let i = 0; i < footprints.length; i += 2) if (within(footprints[i] ?? NaN, xs) && within(footprints[i + 1] ?? NaN, ys)) return true;
	return false;
}
// www/block/view/map/colouring.ts
var VIRIDIS = [
	"#440154",
	"#472d7b",
	"#3b528b",
	"#2c728e",
	"#21918c",
	"#28ae80",
	"#5ec962",
	"#addc30",
	"#fde725"
];
var [LOW, HIGH] = [.02, .98];
var GRADIENT = `linear-gradient(to right, ${VIRIDIS.join(", ")})`;
var WORDS = (() => {
	const parsed = VIRIDIS.map((colour) => [
		1,
		3,
		5
	].map((at) => Number.parseInt(colour.slice(at, at + 2), 16)));
	const words = new Uint32Array(256);
	const bytes = new Uint8Array(words.buffer);
	for (let step = 0; step < 256; step++) {
		const along = step / 255 * (parsed.length - 1);
		const [low, high] = [parsed[Math.floor(along)] ?? [], parsed[Math.ceil(along)] ?? []];
		for (let band = 0; band < 3; band++) bytes[4 * step + band] = Math.round((low[band] ?? 0) + ((high[band] ?? 0) - (low[band] ?? 0)) * (along % 1));
		bytes[4 * step + 3] = 255;
	}
	return words;
})();
var colouredPoints = remember((points, colouring) => {
	if (colouring === "none" || points.count === 0) return null;
	const values = Float64Array.from({ length: points.count }, (_, i) => i < points.taking ? figureOf(points, colouring, i) : NaN);
	const sorted = values.filter((value) => !Number.isNaN(value)).sort();
	if (sorted.length === 0) return null;
	const at = (share) => sorted[Math.round(share * (sorted.length - 1))] ?? NaN;
	const from = colouring === "height" ? at(LOW) : colouring === "rays" ? sorted[0] ?? 2 : 0;
	const to = Math.max(at(HIGH), from + 1e-9);
	const steps = Uint8Array.from(values, (value) => Math.round(255 * Math.min(1, Math.max(0, (value - from) / (to - from)))));
	return {
		scale: {
			from,
			to,
			...{
				residual: {
					unit: "px",
					digits: 2,
					title: say("rmse-of-the-residuals")
				},
				rays: {
					unit: "",
					digits: 0,
					title: say("rays-2")
				},
				height: {
					unit: "",
					digits: 1,
					title: "Z"
				}
			}[colouring]
		},
		steps
	};
});
function figureOf({ rmsePx, rays, positions }, colouring, point) {
	if (colouring === "residual") return rmsePx[point] ?? NaN;
	return (colouring === "rays" ? rays[point] : positions[3 * point + 2]) ?? NaN;
}
// www/block/view/map/frame.ts
var GRID = 120;
var BAR = 130;
function niceBelow(value) {
	const power = 10 ** Math.floor(Math.log10(value));
	return ([5, 2].find((step) => step * power <= value) ?? 1) * power;
}
function stepText(value, step) {
	return value.toFixed(Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)))).replace("-", "−");
}
function lengthText(length, system, unit = "m") {
	const twoDigits = (value) => String(Number(value.toPrecision(2)));
	if (unit === "ft") return withUnit(twoDigits(length), unit);
	if (system === "own") return say("length-in-units-of-the-block", { length: twoDigits(length) });
	const [factor, metric] = length >= 1e3 ? [.001, "km"] : length >= 1 ? [1, "m"] : length >= .01 ? [100, "cm"] : [1e3, "mm"];
	return withUnit(twoDigits(length * factor), metric);
}
function paintGrid(context, colours, t, width, height, toBlock = null) {
	const to = toBlock ?? SAME;
	const from = inverse(to);
	const corners = [
		[0, 0],
		[width, 0],
		[0, height],
		[width, height]
	].map(([x = 0, y = 0]) => {
		const [left, down] = toPosition(t, x, y);
		return mapped(from, left, -down);
	});
	const [west, east] = rangeOf(corners.map(([x]) => x));
	const [south, north] = rangeOf(corners.map(([, y]) => y));
	const step = niceBelow(1.6 * GRID / (t.scale * scaleOf(to)));
	const place = (x, y) => {
		const [u, v] = mapped(to, x, y);
		return toCanvas(t, u, -v);
	};
	const columns = ticks(west, east, step).map((x) => ({
		at: x,
		ends: [place(x, south), place(x, north)]
	}));
	const rows = ticks(south, north, step).map((y) => ({
		at: y,
		ends: [place(west, y), place(east, y)]
	}));
	context.save();
	context.strokeStyle = colours.muted;
	context.lineWidth = .5;
	context.globalAlpha = .35;
	context.beginPath();
	for (const { ends: [one, other] } of [...columns, ...rows]) {
		context.moveTo(...one);
		context.lineTo(...other);
	}
	context.stroke();
	context.globalAlpha = 1;
	context.font = "10px system-ui, sans-serif";
	context.textAlign = "start";
	for (const { at, ends } of columns) haloed(context, colours, stepText(at, step), crossingOf(ends, 1, 0) + 3, 11);
	for (const { at, ends } of rows) {
		const y = crossingOf(ends, 0, 0);
		if (y > 28 && y < height - 52) haloed(context, colours, stepText(at, step), 3, y - 3);
	}
	context.restore();
}
function rangeOf(values) {
	return [Math.min(...values), Math.max(...values)];
}
function crossingOf([one, other], axis, at) {
	const share = (at - one[axis]) / (other[axis] - one[axis]);
	return one[1 - axis] + share * (other[1 - axis] - one[1 - axis]);
}
function ticks(from, to, step) {
	const first = Math.ceil(from / step);
	return Array.from({ length: Math.min(100, Math.max(0, Math.floor(to / step) - first + 1)) }, (_, i) => (first + i) * step);
}
function gsdText(gsd) {
	return say("gsd", { gsd: lengthText(gsd, "geographic") });
}
function paintScale(context, colours, t, height, system, gsd = null, unit = "m") {
	const length = niceBelow(BAR / t.scale);
	const wide = length * t.scale;
	const [left, base] = [12, height - 12];
	context.save();
	for (const [colour, line] of [[colours.ground, 5], [colours.text, 2]]) {
		context.strokeStyle = colour;
		context.lineWidth = line;
		context.beginPath();
		context.moveTo(left, base - 5);
		context.lineTo(left, base);
		context.lineTo(left + wide, base);
		context.lineTo(left + wide, base - 5);
		context.stroke();
	}
	context.font = "11px system-ui, sans-serif";
	context.textAlign = "center";
	haloed(context, colours, asSentence(lengthText(length, system, unit)), left + wide / 2, base - 6);
	context.textAlign = "left";
	if (gsd !== null) haloed(context, colours, asSentence(gsdText(gsd)), left + wide + 12, base);
	context.restore();
}
function paintNorth(context, colours, width, system) {
	const [x, y] = [width - 24, 18];
	context.save();
	context.beginPath();
	context.moveTo(x, y);
	context.lineTo(x + 6, y + 20);
	context.lineTo(x, y + 15);
	context.lineTo(x - 6, y + 20);
	context.closePath();
	context.lineWidth = 3;
	context.strokeStyle = colours.ground;
	context.stroke();
	context.fillStyle = colours.text;
	context.fill();
	context.font = "600 12px system-ui, sans-serif";
	context.textAlign = "center";
	haloed(context, colours, system === "geographic" ? "N" : "Y", x, y + 34);
	context.restore();
}
function haloed(context, colours, text, x, y) {
	context.lineJoin = "round";
	context.lineWidth = 3;
	context.strokeStyle = colours.ground;
	context.strokeText(text, x, y);
	context.fillStyle = colours.text;
	context.fillText(text, x, y);
}
// www/block/view/map/ground.ts
var GNSS = "#e69f00";
var SURVEYED = "#cc79a7";
var LONGEST = 46;
var MOST_NAMED = 30;
var ALL$1 = () => true;
function offsetsOf(view, ground, keepsImage = ALL$1, keepsSurveyed = ALL$1) {
	const gnss = view.images.flatMap(({ position }, i) => {
		const [x = NaN, y = NaN, z = NaN] = ground?.gnss.subarray(3 * i, 3 * i + 3) ?? [];
		if (position === null || Number.isNaN(x) || !keepsImage(i)) return [];
		return [{
			x: position[0],
			y: position[1],
			dx: x - position[0],
			dy: y - position[1],
			dz: z - position[2]
		}];
	});
	const surveyed = view.surveyed.filter((_, i) => keepsSurveyed(i)).map(({ name, role, isUsed, position: [x, y], difference_m: [dx, dy, dz], standard_errors_m: [sx, sy] }) => ({
		name,
		isUsed,
		isCheck: role === "check",
		x,
		y,
		dx,
		dy,
		dz,
		sigma: sx === null || sy === null ? null : [sx, sy]
	}));
	const most = (lengths) => lengths.reduce((high, length) => length > high ? length : high, 0);
	const longest = (offsets) => ({
		plan: most(offsets.map(({ dx, dy }) => Math.hypot(dx, dy))),
		height: most(offsets.map(({ dz }) => Math.abs(dz)))
	});
	return {
		gnss,
		surveyed,
		longest: {
			gnss: longest(gnss),
			surveyed: longest(surveyed)
		}
	};
}
function longestText({ plan, height }, system) {
	return say("in-plan-and-height", {
		plan: lengthText(plan, system),
		height: height > 0 ? lengthText(height, system) : null
	});
}
function factorOf(longest, t) {
	return longest > 0 ? Math.max(1, niceBelow(LONGEST / (longest * t.scale))) : 1;
}
function paintFootprints(context, colours, { footprints }, t, all, marked) {
	context.save();
	for (let image = 0; 8 * image < footprints.length; image++) {
		const on = marked(image);
		const corners = footprints.subarray(8 * image, 8 * image + 8);
		if (!on && !all(image) || Number.isNaN(corners[0])) continue;
		context.beginPath();
		for (let corner = 0; corner < 8; corner += 2) context.lineTo(...toCanvas(t, corners[corner] ?? 0, -(corners[corner + 1] ?? 0)));
		context.closePath();
		context.fillStyle = context.strokeStyle = on ? colours.accent : colours.bars;
		context.globalAlpha = on ? .14 : .05;
		context.fill();
		context.globalAlpha = on ? 1 : .5;
		context.lineWidth = on ? 1.5 : .8;
		context.stroke();
	}
	context.restore();
}
function paintOnGround(context, thumb, { footprints }, t, image) {
	const [x0 = NaN, y0 = NaN, x1 = NaN, y1 = NaN, , , x3 = NaN, y3 = NaN] = footprints.subarray(8 * image, 8 * image + 8);
	if (Number.isNaN(x0)) return;
	const [left, top] = toCanvas(t, x0, -y0);
	const across = [t.scale * (x1 - x0) / thumb.width, -t.scale * (y1 - y0) / thumb.width];
	const down = [t.scale * (x3 - x0) / thumb.height, -t.scale * (y3 - y0) / thumb.height];
	context.save();
	context.transform(...across, ...down, left, top);
	context.drawImage(thumb, 0, 0);
	context.restore();
}
function paintGnss(context, { gnss }, t, factor) {
	context.save();
	context.strokeStyle = context.fillStyle = GNSS;
	context.lineWidth = 2;
	for (const offset of gnss) {
		const end = arrow(context, t, offset, factor);
		context.beginPath();
		context.arc(...end, 2.5, 0, 2 * Math.PI);
		context.fill();
	}
	context.restore();
}
function paintSurveyed(context, colours, { surveyed }, t, factor, offsets, size) {
	const inSight = surveyed.map((point) => ({
		point,
		at: toCanvas(t, point.x, -point.y)
	})).filter(({ at }) => at.every((coordinate, axis) => coordinate > -46 && coordinate < (size[axis] ?? 0) + LONGEST));
	const isCrowded = inSight.length > MOST_NAMED;
	const side = isCrowded ? .5 : 1;
	context.save();
	context.font = "11px system-ui, sans-serif";
	context.textAlign = "start";
	for (const { point, at: [x, y] } of inSight) {
		context.strokeStyle = SURVEYED;
		context.lineWidth = 2;
		if (offsets && point.isUsed) {
			const [ex, ey] = arrow(context, t, point, factor);
			if (point.sigma !== null && !isCrowded) {
				const [a, b] = point.sigma.map((sigma) => sigma * factor * t.scale);
				context.lineWidth = 1;
				context.beginPath();
				context.ellipse(ex, ey, Math.max(1, a ?? 0), Math.max(1, b ?? 0), 0, 0, 2 * Math.PI);
				context.stroke();
			}
		}
		context.beginPath();
		if (point.isCheck) context.rect(x - 5 * side, y - 5 * side, 10 * side, 10 * side);
		else for (const [dx, dy] of [
			[0, -7],
			[6, 4],
			[-6, 4]
		]) context.lineTo(x + dx * side, y + dy * side);
		context.closePath();
		context.fillStyle = SURVEYED;
		if (point.isUsed) context.fill();
		context.lineWidth = isCrowded ? 1 : 1.5;
		context.strokeStyle = point.isUsed ? colours.surface : SURVEYED;
		context.stroke();
		if (!isCrowded) haloed(context, colours, point.name, x + 9, y + 4);
	}
	context.restore();
}
function arrow(context, t, { x, y, dx, dy }, factor) {
	const end = toCanvas(t, x + factor * dx, -(y + factor * dy));
	context.beginPath();
	context.moveTo(...toCanvas(t, x, -y));
	context.lineTo(...end);
	context.stroke();
	return end;
}
// www/block/view/map/plan.ts
var MARGIN = 62;
var MARGIN_OF_GROUND = 22;
var MARK_REACH = 12;
var LINE_REACH = 6;
function fitPlan({ layout: { kind, places }, surveyed }, footprints, width, height) {
	const box = [
		Infinity,
		Infinity,
		-Infinity,
		-Infinity
	];
	const points = kind === "oriented" ? surveyed.flatMap(({ position: [x, y] }) => [x, y]) : [];
	for (const flat of [
		places,
		points,
		...footprints === null ? [] : [footprints]
	]) for (let i = 0; i < flat.length; i += 2) {
		const [x = NaN, y = NaN] = [flat[i], flat[i + 1]];
		if (Number.isNaN(x)) continue;
		box[0] = Math.min(box[0], x);
		box[1] = Math.min(box[1], y);
		box[2] = Math.max(box[2], x);
		box[3] = Math.max(box[3], y);
	}
	if (box[0] > box[2]) return {
		scale: 1,
		x: 0,
		y: 0
	};
	const margin = footprints === null ? MARGIN : MARGIN_OF_GROUND;
	const room = (length) => Math.max(10, length - 2 * margin);
	const spread = (low, high) => Math.max(high - low, 1e-9);
	const scale = Math.min(room(width) / spread(box[0], box[2]), room(height) / spread(box[1], box[3]));
	return {
		scale,
		x: width / 2 - scale * (box[0] + box[2]) / 2,
		y: height / 2 + scale * (box[1] + box[3]) / 2
	};
}
function placeOf(view, plan, image) {
	const [x = 0, y = 0] = view.layout.places.subarray(2 * image, 2 * image + 2);
	return toCanvas(plan, x, -y);
}
var SPACINGS = new WeakMap();
function spacingOf(view) {
	const known = SPACINGS.get(view);
	if (known !== void 0) return known;
	const { places } = view.layout;
	const across = Array.from({ length: places.length / 2 }, (_, i) => [places[2 * i] ?? NaN, places[2 * i + 1] ?? NaN]).filter(([x]) => !Number.isNaN(x)).sort(([a], [b]) => a - b);
	let least = Infinity;
	across.forEach(([x, y], i) => {
		for (let j = i - 1; j >= 0; j -= 1) {
			const [u, v] = across[j] ?? [-Infinity, 0];
			if (x - u >= least) break;
			least = Math.min(least, Math.hypot(x - u, y - v));
		}
	});
	SPACINGS.set(view, least);
	return least;
}
function nearestImages(view, plan, keeps, [x, y], most) {
	const kept = Array.from(view.images.keys()).filter(keeps);
	if (kept.length <= most) return kept;
	return kept.flatMap((image) => {
		const [px, py] = placeOf(view, plan, image);
		return Number.isNaN(px) ? [] : [[image, Math.hypot(px - x, py - y)]];
	}).sort(([, a], [, b]) => a - b).slice(0, most).map(([image]) => image);
}
var WIDEST_THUMB = 110;
var LEAST_THUMB = 26;
function thumbWidth(view, plan) {
	const width = Math.min(WIDEST_THUMB, .8 * spacingOf(view) * plan.scale);
	return width < LEAST_THUMB ? 0 : width;
}
var LINES = new WeakMap();
function linesOf(view) {
	const known = LINES.get(view);
	if (known !== void 0) return known;
	const connected = view.connections.map((connection, pair) => ({
		...connection,
		pair
	})).filter(({ outcome }) => outcome.kind === "connected");
	const joined = connected.some(({ shared }) => shared > 0);
	const weight = (connection) => joined ? connection.shared : matchesOf$1(connection);
	const most = connected.reduce((high, connection) => Math.max(high, weight(connection)), 1);
	const made = connected.map((connection) => ({
		...connection,
		strength: Math.sqrt(weight(connection) / most)
	})).map(({ pair, images, strength, rejected }) => ({
		pair,
		images,
		strength,
		rejected,
		width: rejected ? 1 : .6 + 6.4 * strength
	})).sort((a, b) => a.width - b.width);
	LINES.set(view, made);
	return made;
}
function imageAt(view, plan, keeps, width, x, y) {
	let image = -1;
	let least = Math.max(MARK_REACH, width / 2);
	view.images.forEach((_, i) => {
		if (!keeps(i)) return;
		const [px, py] = placeOf(view, plan, i);
		const distance = Math.hypot(px - x, py - y);
		if (distance < least) [image, least] = [i, distance];
	});
	return image;
}
function lineAt(view, plan, keeps, x, y) {
	let found = null;
	let nearest = Infinity;
	for (const line of linesOf(view)) {
		if (!keeps(line.pair)) continue;
		const distance = toSegment(placeOf(view, plan, line.images[0]), placeOf(view, plan, line.images[1]), x, y);
		if (distance <= Math.max(LINE_REACH, line.width / 2 + 2) && distance < nearest) [found, nearest] = [line, distance];
	}
	return found === null ? null : found.images;
}
function toSegment([ax, ay], [bx, by], x, y) {
	const [dx, dy] = [bx - ax, by - ay];
	const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / Math.max(dx * dx + dy * dy, 1e-9)));
	return Math.hypot(ax + along * dx - x, ay + along * dy - y);
}
// www/block/view/map/images.ts
var NAMED = 60;
var NAME_GAP = 6;
function isMarked({ marked }, image) {
	return marked.some((choice) => imagesOf(choice).includes(image));
}
function soundness(view) {
	const largest = new Set(view.groups[0]);
	return (image) => view.partial || (view.layout.kind === "oriented" ? view.images[image]?.oriented === true : largest.has(image));
}
function isOf(choice, images) {
	if (choice.kind === "pairs") return pairsOf(choice).map(keyOfPair).includes(keyOfPair(images));
	const own = imagesOf(choice);
	return own.length === 1 ? own.every((image) => images.includes(image)) : images.every((image) => own.includes(image));
}
var DASHES = [4, 4];
function paintLines(context, colours, view, plan, keepsPair) {
	const alpha = context.globalAlpha;
	context.lineCap = "round";
	for (const line of linesOf(view)) {
		if (!keepsPair(line.pair)) continue;
		context.strokeStyle = line.rejected ? colours.problem : colours.bars;
		context.setLineDash(line.rejected ? DASHES : []);
		context.globalAlpha = line.rejected ? alpha : alpha * (.3 + .5 * line.strength);
		context.lineWidth = line.width;
		paintLine(context, view, plan, line.images);
	}
	context.setLineDash([]);
	context.globalAlpha = alpha;
}
function paintMarkedLines(context, colours, view, plan, { marked, keepsPair }) {
	if (marked.length === 0) return;
	const isOn = (images) => marked.some((choice) => isOf(choice, images));
	context.strokeStyle = colours.accent;
	for (const { pair, images, width, rejected } of linesOf(view)) {
		if (!keepsPair(pair) || !isOn(images)) continue;
		context.setLineDash(rejected ? DASHES : []);
		context.lineWidth = Math.max(width, 2);
		paintLine(context, view, plan, images);
	}
	context.setLineDash(DASHES);
	context.lineWidth = 1;
	for (const [pair, { images, outcome }] of view.connections.entries()) {
		if (outcome.kind === "connected" || !keepsPair(pair) || !isOn(images)) continue;
		context.strokeStyle = outcome.kind === "failed" ? colours.problem : colours.muted;
		paintLine(context, view, plan, images);
	}
	context.setLineDash([]);
}
function paintLine(context, view, plan, [a, b]) {
	context.beginPath();
	context.moveTo(...placeOf(view, plan, a));
	context.lineTo(...placeOf(view, plan, b));
	context.stroke();
}
function paintImages(context, colours, view, plan, shown) {
	const isSound = soundness(view);
	view.images.forEach((_, i) => {
		if (!shown.keepsImage(i)) return;
		const [x, y] = placeOf(view, plan, i);
		const on = isMarked(shown, i);
		const radius = on ? 7 : view.images.length > 300 ? 3 : 5;
		const sound = isSound(i);
		context.beginPath();
		context.arc(x, y, radius, 0, 2 * Math.PI);
		context.fillStyle = sound ? on ? colours.accent : colours.bars : colours.surface;
		context.fill();
		context.lineWidth = sound ? 1.5 : 2;
		context.strokeStyle = sound ? colours.surface : colours.problem;
		context.stroke();
	});
}
function paintNames(context, colours, view, plan, shown, below) {
	context.font = "11px system-ui, sans-serif";
	context.textAlign = "center";
	const all = view.images.map((_, image) => image).filter(shown.keepsImage);
	const on = new Set(all.filter((image) => isMarked(shown, image)));
	const named = [...on, ...all.length > NAMED ? [] : all.filter((image) => !on.has(image))];
	const taken = [];
	for (const image of named) {
		const text = (view.images[image]?.name ?? "").replace(/\.[^.]+$/u, "");
		const [x, middle] = placeOf(view, plan, image);
		const [y, half] = [middle + below, .5 * context.measureText(text).width];
		if (taken.some((other) => Math.abs(other.x - x) < other.half + half + NAME_GAP && Math.abs(other.y - y) < 13) && !on.has(image)) continue;
		taken.push({
			x,
			y,
			half
		});
		haloed(context, colours, text, x, y);
	}
}
// www/block/view/map/look.ts
var FIRST_LOOK = {
	colouring: "residual",
	connections: true,
	footprints: false,
	photos: true,
	lasso: false,
	offsets: true,
	orthophoto: true
};
// www/block/view/map/points.ts
var FEW$1 = 5e3;
var drawnPoints = remember((points, keeps) => {
	const drawn = new Uint32Array(points.count);
	let count = 0;
	for (let point = 0; point < points.count; point++) if (!Number.isNaN(points.positions[3 * point]) && keeps(point)) drawn[count++] = point;
	return drawn.subarray(0, count);
});
function pointPlace({ positions }, t, point) {
	return toCanvas(t, positions[3 * point] ?? NaN, -(positions[3 * point + 1] ?? NaN));
}
function pointAt(points, keeps, t, x, y) {
	let [nearest, least] = [-1, 49];
	for (const point of drawnPoints(points, keeps)) {
		const [px, py] = [t.scale * (points.positions[3 * point] ?? 0) + t.x - x, t.y - t.scale * (points.positions[3 * point + 1] ?? 0) - y];
		const distance = px * px + py * py;
		if (distance < least) [nearest, least] = [point, distance];
	}
	return nearest;
}
function pointsWithin(points, keeps, t, outline) {
	const xs = outline.map(([x]) => x);
	const ys = outline.map(([, y]) => y);
	const reduced = (values, of) => values.reduce((a, b) => of(a, b), values[0] ?? 0);
	const [left, right, top, bottom] = [
		reduced(xs, Math.min),
		reduced(xs, Math.max),
		reduced(ys, Math.min),
		reduced(ys, Math.max)
	];
	const inside = [];
	for (const point of drawnPoints(points, keeps)) {
		const x = t.scale * (points.positions[3 * point] ?? 0) + t.x;
		const y = t.y - t.scale * (points.positions[3 * point + 1] ?? 0);
		if (x >= left && y >= top && x <= right && y <= bottom && isWithin(xs, ys, x, y)) inside.push(point);
	}
	return inside;
}
function isWithin(xs, ys, x, y) {
	let odd = false;
	for (let i = 0, before = xs.length - 1; i < xs.length; before = i++) {
		const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [
			xs[before],
			ys[before],
			xs[i],
			ys[i]
		];
		if (y0 > y !== y1 > y && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0)) odd = !odd;
	}
	return odd;
}
function wordOf(colour) {
	const [red = 0, green = 0, blue = 0] = (colour.match(/[\d.]+/gu) ?? []).map(Number);
	return new Uint32Array(Uint8Array.of(red, green, blue, 255).buffer)[0] ?? 0;
}
var GONE = wordOf([
	1,
	3,
	5
].map((at) => String(Number.parseInt(REJECTED_BY_HAND.colour.slice(at, at + 2), 16))).join(" "));
var PointBitmap = class {
	canvas = document.createElement("canvas");
	image = null;
	words = new Uint32Array();
	paint(context, t, width, height, ratio, painted) {
		const [columns, rows] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
		const own = this.canvas.getContext("2d");
		if (own === null) return;
		if (this.image === null || this.image.width !== columns || this.image.height !== rows) {
			Object.assign(this.canvas, {
				width: columns,
				height: rows
			});
			this.image = own.createImageData(columns, rows);
			this.words = new Uint32Array(this.image.data.buffer);
		} else this.words.fill(0);
		const { points, coloured, keeps, chosen, pointed, mark, edge } = painted;
		const drawn = drawnPoints(points, keeps);
		const few = drawn.length <= FEW$1;
		const side = Math.max(2, Math.round((few ? 4 : 2.4) * ratio));
		const device = {
			scale: t.scale * ratio,
			x: t.x * ratio,
			y: t.y * ratio
		};
		const canvas = {
			words: this.words,
			columns,
			rows
		};
		const [edged, marked] = [wordOf(edge), wordOf(mark)];
		const [kept, under] = [chosen.filter(keeps), pointed.filter(keeps)];
		if (few) squares(canvas, points, device, drawn, side + 2, () => edged);
		squares(canvas, points, device, drawn, side, (point) => point < points.taking ? WORDS[coloured.steps[point] ?? 0] ?? 0 : GONE);
		const firstGone = drawn.findIndex((point) => point >= points.taking);
		if (firstGone >= 0) squares(canvas, points, device, drawn.subarray(firstGone), side - 2, () => edged);
		const isLarge = kept.length <= FEW$1;
		if (isLarge) squares(canvas, points, device, kept, side + 6, () => edged);
		squares(canvas, points, device, kept, isLarge ? side + 4 : side, () => marked);
		squares(canvas, points, device, under, side + 4, () => marked);
		own.putImageData(this.image, 0, 0);
		context.save();
		context.setTransform(1, 0, 0, 1, 0, 0);
		context.drawImage(this.canvas, 0, 0);
		context.restore();
	}
};
function squares({ words, columns, rows }, { positions }, t, points, size, colour) {
	for (const point of points) {
		const left = Math.floor(t.scale * (positions[3 * point] ?? 0) + t.x - size / 2);
		const top = Math.floor(t.y - t.scale * (positions[3 * point + 1] ?? 0) - size / 2);
		if (left <= -size || top <= -size || left >= columns || top >= rows) continue;
		const word = colour(point);
		const right = Math.min(columns, left + size);
		const bottom = Math.min(rows, top + size);
		for (let row = Math.max(0, top); row < bottom; row++) for (let column = Math.max(0, left); column < right; column++) words[row * columns + column] = word;
	}
}
// www/block/view/map/still.ts
var REST_MS = 120;
var BEYOND = .25;
var Still = class {
	redraw;
	canvas = document.createElement("canvas");
	at = {
		scale: 1,
		x: 0,
		y: 0
	};
	of = [];
	moving = null;
	now = this.at;
	constructor(redraw) {
		this.redraw = redraw;
	}
	paint(context, t, [width, height, ratio], what, draw) {
		const key = [
			...what,
			width,
			height,
			ratio
		];
		const isOther = key.length !== this.of.length || key.some((part, i) => part !== this.of[i]);
		const rests = this.now.scale === t.scale && this.now.x === t.x && this.now.y === t.y;
		const isAt = this.at.scale === t.scale && this.at.x === t.x && this.at.y === t.y;
		if (isOther || rests && !isAt && this.moving === null) this.renew(t, width, height, ratio, key, draw);
		else if (!rests) this.wait();
		this.now = t;
		const larger = t.scale / this.at.scale;
		const [left, top] = [-.25 * width, -.25 * height].map((edge, i) => larger * (edge - (i === 0 ? this.at.x : this.at.y)) + (i === 0 ? t.x : t.y));
		context.drawImage(this.canvas, left ?? 0, top ?? 0, larger * 1.5 * width, larger * 1.5 * height);
	}
	wait() {
		if (this.moving !== null) clearTimeout(this.moving);
		this.moving = setTimeout(() => {
			this.moving = null;
			this.redraw();
		}, REST_MS);
	}
	renew(t, width, height, ratio, key, draw) {
		const own = this.canvas.getContext("2d");
		if (own === null) return;
		Object.assign(this.canvas, {
			width: Math.ceil(1.5 * width * ratio),
			height: Math.ceil(1.5 * height * ratio)
		});
		own.setTransform(ratio, 0, 0, ratio, 0, 0);
		draw(own, {
			scale: t.scale,
			x: t.x + BEYOND * width,
			y: t.y + BEYOND * height
		});
		Object.assign(this, {
			at: t,
			of: key
		});
	}
};
// www/block/view/map/thumbs.ts
var SIDE$1 = 240;
var MOST_KEPT = 450;
var Thumbs = class {
	arrived;
	made = new Map();
	waiting = [];
	making = false;
	constructor(arrived) {
		this.arrived = arrived;
	}
	get(file) {
		const found = this.made.get(file.id);
		if (found === void 0 && !this.waiting.includes(file)) {
			this.waiting.push(file);
			this.make();
		}
		return found ?? null;
	}
	shows(files) {
		this.waiting = this.waiting.filter(({ id }) => files.has(id));
		for (const [id, copy] of this.made) {
			if (this.made.size <= MOST_KEPT) break;
			if (files.has(id)) continue;
			copy?.close();
			this.made.delete(id);
		}
	}
	async make() {
		if (this.making) return;
		this.making = true;
		for (let next = this.waiting[0]; next !== void 0; next = this.waiting[0]) {
			const { id } = next;
			this.made.set(id, await copyOf(next.file));
			this.waiting = this.waiting.filter((file) => file.id !== id);
			this.arrived();
		}
		this.making = false;
	}
};
async function copyOf(file) {
	try {
		return await createImageBitmap(file, {
			resizeWidth: SIDE$1,
			resizeQuality: "medium",
			imageOrientation: "none"
		});
	} catch {
		return null;
	}
}
// www/block/view/map/map.ts
var BlockMap = class extends Chart {
	facts;
	thumbs = new Thumbs(() => this.layers.redraw());
	bitmap = new PointBitmap();
	lines = new Still(() => this.layers.redraw());
	look = FIRST_LOOK;
	outline = [];
	listeners = [];
	pointer = null;
	tiles;
	hadOrthophoto = false;
	constructor(host, store, looking, facts, placing) {
		super(host, "map", store, looking);
		this.facts = facts;
		this.keys = declare({
			where: say("map"),
			host,
			lacks: say("no-pair-is-chosen"),
			list: [
				{
					keys: ["n"],
					does: say("chooses-the-next-image"),
					run: () => this.step(1)
				},
				{
					keys: ["p"],
					does: say("chooses-the-previous-image"),
					run: () => this.step(-1)
				},
				{
					keys: ["c"],
					does: say("chooses-the-next-pair-of"),
					run: () => this.stepPair()
				}
			]
		});
		this.tiles = new OrthophotoTiles((level, column, row) => placing.tile(level, column, row), () => this.layers.redraw());
		facts.watch(() => this.changed());
		store.watch(["shown", "selection"], () => this.tell());
		store.watch((s) => [s.placing.orthophoto, s.placing.placed], () => this.changed());
	}
	keys;
	watch(changed) {
		this.listeners.push(changed);
		changed();
	}
	get shows() {
		return this.look;
	}
	show(look) {
		this.look = {
			...this.look,
			...look
		};
		this.changed();
	}
	get place() {
		return this.view()?.layout.kind === "connections" ? null : this.pointer;
	}
	ground() {
		return this.facts.ground();
	}
	get orthophoto() {
		return this.store.state.placing.orthophoto;
	}
	laid() {
		const { placing, files, shown } = this.store.state;
		const view = shown?.view ?? null;
		if (view === null || placing.orthophoto === null) return null;
		const ground = this.ground();
		return laidUnder(placing.orthophoto, placing.placed, files, shown, ground, systemOf(view, ground));
	}
	changed() {
		const has = this.laid() !== null;
		if (has && !this.hadOrthophoto) this.look = {
			...this.look,
			photos: false,
			footprints: true
		};
		this.hadOrthophoto = has;
		this.layers.redraw();
		this.tell();
	}
	tell() {
		for (const listener of this.listeners) listener();
	}
	placed = (at) => {
		const view = this.view();
		const place = at === null || view === null ? null : toPosition(this.current(view), ...at);
		this.pointer = place === null ? null : [place[0], -place[1]];
		this.tell();
	};
	enclosed = (view, drawn, ended) => {
		const outline = drawn.to === null ? [] : this.look.lasso ? [...drawn.path] : cornersOf$1(drawn.from, drawn.to);
		this.outline = ended ? [] : outline;
		if (ended && this.look.colouring !== "none") this.looking.choose(choiceOfPoints(pointsWithin(view.points, this.keeps(view, "points"), this.current(view), outline)));
		this.layers.redraw();
	};
	whole(view) {
		return fitPlan(view, view.layout.kind === "oriented" ? this.ground()?.footprints ?? null : null, this.layers.width, this.layers.height);
	}
	limits(whole) {
		return {
			least: .2 * whole,
			most: 200 * whole
		};
	}
	keeps(view, subject) {
		return keptBy(subject, view, this.store.state.selection);
	}
	hit(view, t, x, y) {
		const { colouring, connections } = this.look;
		const point = colouring === "none" ? -1 : pointAt(view.points, this.keeps(view, "points"), t, x, y);
		const image = imageAt(view, t, this.keeps(view, "images"), this.thumbSide(view, t, this.ground()), x, y);
		if (image >= 0 && (point < 0 || distance(placeOf(view, t, image), x, y) <= distance(pointPlace(view.points, t, point), x, y))) return {
			kind: "image",
			image
		};
		if (point >= 0) return {
			kind: "point",
			point
		};
		const images = connections ? lineAt(view, t, this.keeps(view, "pairs"), x, y) : null;
		return images === null ? null : {
			kind: "pair",
			images
		};
	}
	command(key) {
		return this.keys(key, false);
	}
	step(by) {
		const view = this.view();
		if (view === null) return;
		const kept = view.images.map((_, image) => image).filter(this.keeps(view, "images"));
		const now = kept.indexOf(imagesOf(this.store.state.selection.chosen)[0] ?? -1);
		const image = kept[now < 0 ? by > 0 ? 0 : kept.length - 1 : (now + by + kept.length) % kept.length];
		if (image !== void 0) this.looking.choose({
			kind: "image",
			image
		});
	}
	stepPair() {
		const view = this.view();
		const { chosen } = this.store.state.selection;
		const [image] = imagesOf(chosen);
		if (view === null || image === void 0) return;
		const keeps = this.keeps(view, "pairs");
		const own = view.connections.filter((_, pair) => keeps(pair)).map(({ images }) => images).filter((images) => images.includes(image)).map(([a, b]) => a === image ? [a, b] : [b, a]);
		const next = own[((chosen?.kind === "pair" ? own.findIndex(([, b]) => b === chosen.images[1]) : -1) + 1) % Math.max(1, own.length)];
		if (next !== void 0) this.looking.choose({
			kind: "pair",
			images: next
		});
	}
	paint(context, colours, view, t) {
		const { width, height } = this.layers;
		const { chosen, pointed } = this.store.state.selection;
		const { look } = this;
		const ground = this.ground();
		const system = systemOf(view, ground);
		const hasPlaces = view.layout.kind !== "connections";
		const shown = {
			marked: [chosen, pointed].filter((choice) => choice !== null).filter((choice) => imagesOf(choice).length > 0),
			keepsImage: this.keeps(view, "images"),
			keepsPair: this.keeps(view, "pairs")
		};
		const outlined = (image) => look.footprints && shown.keepsImage(image);
		const { orthophoto } = this.store.state.placing;
		const laid = look.orthophoto && orthophoto !== null ? this.laid() : null;
		if (laid !== null && orthophoto !== null) this.tiles.paint(context, orthophoto, laid.sheet, t, [
			width,
			height,
			this.layers.ratio
		]);
		if (ground !== null) this.paintPhotos(context, colours, view, t, ground, shown);
		if (hasPlaces) paintGrid(context, colours, t, width, height, resultSystem(view).toBlock);
		if (ground !== null && hasPlaces) paintFootprints(context, colours, ground, t, outlined, (image) => isMarked(shown, image));
		if (look.connections) this.paintConnections(context, colours, view, t, shown);
		const below = ground === null ? this.paintPhotos(context, colours, view, t, ground, shown) : 19;
		this.paintPoints(context, colours, view, t, chosen, pointed);
		if (below === 19) paintImages(context, colours, view, t, shown);
		paintNames(context, colours, view, t, shown, below);
		if (!hasPlaces) return;
		const offsets = offsetsOf(view, ground, shown.keepsImage, this.keeps(view, "surveyed"));
		const factor = factorOf(Math.max(offsets.longest.gnss.plan, offsets.longest.surveyed.plan), t);
		if (look.offsets) paintGnss(context, offsets, t, factor);
		paintSurveyed(context, colours, offsets, t, factor, look.offsets, [width, height]);
		paintScale(context, colours, t, height, system, medianGsd(view, ground));
		if (system !== "own") paintNorth(context, colours, width, system);
		if (look.offsets) this.paintOffsetLegend(context, colours, offsets, factor, system);
		this.paintOutline(context, colours);
	}
	paintConnections(context, colours, view, t, shown) {
		const { keepsPair, marked } = shown;
		const { width, height, ratio } = this.layers;
		context.globalAlpha = marked.length > 0 ? .4 : 1;
		const draw = (on, plan) => paintLines(on, colours, view, plan, keepsPair);
		if (linesOf(view).length < 500) draw(context, t);
		else this.lines.paint(context, t, [
			width,
			height,
			ratio
		], [
			view,
			keepsPair,
			colours
		], draw);
		context.globalAlpha = 1;
		paintMarkedLines(context, colours, view, t, shown);
	}
	paintOffsetLegend(context, colours, { longest }, factor, system) {
		const parts = [longest.gnss.plan > 0 ? say("gnss-minus-adjusted-up-to", { gnss: longestText(longest.gnss, system) }) : "", longest.surveyed.plan > 0 ? say("adjusted-minus-surveyed-up-to", { surveyed: longestText(longest.surveyed, system) }) : ""].filter((part) => part !== "");
		if (parts.length === 0) return;
		context.font = "11px system-ui, sans-serif";
		context.textAlign = "start";
		const [first = "", ...others] = [...parts, say("drawn-longer", { factor })];
		const clauses = [first.charAt(0).toUpperCase() + first.slice(1), ...others];
		const whole = clauses.join(say("between-clauses"));
		const { width, height } = this.layers;
		const lines = context.measureText(whole).width <= width - 24 ? [whole] : clauses;
		for (const [i, line] of lines.reverse().entries()) haloed(context, colours, asSentence(line), 12, height - 38 - 14 * i);
	}
	paintOutline(context, colours) {
		if (this.outline.length === 0) return;
		context.strokeStyle = colours.accent;
		context.lineWidth = 1.5;
		context.setLineDash([5, 3]);
		context.beginPath();
		for (const place of this.outline) context.lineTo(...place);
		context.closePath();
		context.stroke();
		context.setLineDash([]);
	}
	paintPoints(context, colours, view, t, chosen, pointed) {
		const { points } = view;
		const coloured = colouredPoints(points, this.look.colouring);
		if (coloured === null || view.layout.kind !== "oriented") return;
		const { width, height, ratio } = this.layers;
		const keeps = this.keeps(view, "points");
		this.bitmap.paint(context, t, width, height, ratio, {
			points,
			coloured,
			keeps,
			chosen: pointsOf(chosen),
			pointed: pointsOf(pointed),
			mark: colours.problem,
			edge: colours.surface
		});
	}
	paintPhotos(context, colours, view, t, ground, { keepsImage, ...marks }) {
		const { shown, files, running } = this.store.state;
		const width = this.thumbSide(view, t, ground);
		if (!this.look.photos || ground === null && width === 0 || shown === null || running.kind === "yes") return 19;
		const ofName = new Map([...files, ...shown.files].map((file) => [file.name, file]));
		const fileOf = (image) => ofName.get(view.images[image]?.name ?? "");
		const near = nearestImages(view, t, (image) => keepsImage(image) && fileOf(image) !== void 0, [this.layers.width / 2, this.layers.height / 2], 150);
		const thumbs = new Map(near.flatMap((image) => fileOf(image) ?? []).map((file) => [file.id, this.thumbs.get(file)]));
		this.thumbs.shows(new Set(thumbs.keys()));
		const isSound = soundness(view);
		let below = 19;
		for (const i of near.sort((a, b) => a - b)) {
			const thumb = thumbs.get(fileOf(i)?.id ?? -1) ?? null;
			if (thumb === null) continue;
			if (ground !== null) {
				paintOnGround(context, thumb, ground, t, i);
				continue;
			}
			const height = width * thumb.height / thumb.width;
			const [x, y] = placeOf(view, t, i);
			context.drawImage(thumb, x - width / 2, y - height / 2, width, height);
			const on = isMarked({
				keepsImage,
				...marks
			}, i);
			context.lineWidth = on ? 3 : 1.5;
			context.strokeStyle = on ? colours.accent : isSound(i) ? colours.surface : colours.problem;
			context.strokeRect(x - width / 2, y - height / 2, width, height);
			below = Math.max(below, height / 2 + 13);
		}
		return below;
	}
	thumbSide(view, t, ground) {
		return ground === null && this.look.photos ? thumbWidth(view, t) : 0;
	}
};
function cornersOf$1([x0, y0], [x1, y1]) {
	return [
		[x0, y0],
		[x1, y0],
		[x1, y1],
		[x0, y1]
	];
}
function distance([px, py], x, y) {
	return Math.hypot(px - x, py - y);
}
// www/block/panel/map-view.ts
var LAYOUTS = {
	oriented: say("oriented-positions-from-above"),
	recorded: say("gnss-positions-from-above"),
	connections: say("arranged-by-connections-positions-have")
};
var SYSTEMS = {
	geographic: say("metres-east-and-north-of"),
	surveyed: say("system-of-the-control-points"),
	own: say("the-blocks-own-system-without")
};
var COLOURINGS = [
	["residual", say("by-residual")],
	["rays", say("by-rays")],
	["height", say("by-height")],
	["none", say("not-shown")]
];
var KEYS$2 = say("press-an-image-a-point");
var DIGITS_OF_DEGREES = 7;
function mapView(facts, placing, mosaic) {
	return {
		name: "map",
		title: say("map"),
		mount: (store, looking) => {
			const words = h("p", {
				class: "visually-hidden",
				id: "block-map-words",
				testid: "block-map-words"
			});
			const canvas = h("div", {
				class: "view block-view",
				testid: "block-map",
				tabindex: 0,
				role: "group",
				aria: {
					roledescription: say("map-of-the-block"),
					label: say("images-and-tie-points-of"),
					describedby: `${words.id} ${KEYS_ID}`
				}
			});
			const map = new BlockMap(canvas, store, looking, facts, placing);
			const place = h("p", {
				class: "map-place",
				testid: "map-place"
			});
			const legend = h("span", {
				class: "note map-legend",
				testid: "block-layout"
			});
			const bar = h("span", {
				class: "map-scale",
				aria: { hidden: "true" }
			});
			bar.style.background = GRADIENT;
			map.watch(() => {
				const { shown } = store.state;
				setText(place, placeText(map, shown?.view ?? null));
				showLegend(legend, bar, map, shown?.view ?? null);
				setText(words, shown === null ? "" : inWords(map, shown.view));
			});
			const element = h("div", {
				class: "map",
				tabindex: -1
			}, canvas, place, words);
			element.addEventListener("focus", () => canvas.focus());
			return {
				element,
				tools: [toolsOf$1(store, map, mosaic)],
				legend,
				zoomable: map,
				keys: KEYS$2
			};
		}
	};
}
function setText(element, text) {
	if (element.textContent !== text) element.textContent = text;
}
function toolsOf$1(store, map, mosaic) {
	const [points, select] = choice(say("tie-points"), "map-points", COLOURINGS, (colouring) => map.show({ colouring }));
	const switches = [
		["connections", toggle(say("pairs"), "map-connections", say("lines-between-connected-images-wider"), (connections) => map.show({ connections }))],
		["photos", toggle(say("photos"), "map-photos", say("small-photos-where-they-have"), (photos) => map.show({ photos }))],
		["footprints", toggle(say("footprints"), "map-footprints", say("what-each-image-covers-of"), (footprints) => map.show({ footprints }))],
		["offsets", toggle(say("offsets"), "map-offsets", say("gnss-positions-and-differences-of"), (offsets) => map.show({ offsets }))],
		["orthophoto", toggle(say("orthophoto"), "map-orthophoto", say("the-orthophoto-that-is-given"), (orthophoto) => map.show({ orthophoto }))],
		["lasso", toggle(say("lasso"), "map-lasso", say("shift-and-a-drag-chooses"), (lasso) => map.show({ lasso }))]
	];
	declareLack(switches.flatMap(([name, press]) => name === "orthophoto" ? press : []), () => lackOfOrthophoto(store.state));
	map.watch(() => {
		const { shows } = map;
		select.value = shows.colouring;
		for (const [name, press] of switches) press.setAttribute("aria-pressed", String(shows[name]));
	});
	const make = button(say("orthomosaic-2"), "map-mosaic", mosaic, say("makes-a-quick-orthomosaic-of"));
	map.watch(() => {
		const press = switches.find(([name]) => name === "orthophoto")?.[1];
		if (press === void 0) return;
		press.hidden = map.laid() === null;
		const isOwn = map.orthophoto?.ofBlock != null;
		setText(press, say(isOwn ? "orthomosaic-2" : "orthophoto"));
		press.title = say(isOwn ? "the-orthomosaic-of-the-block" : "the-orthophoto-that-is-given");
	});
	store.watch([
		"shown",
		"files",
		"placing",
		"running",
		"notice"
	], ([shown, , { orthophoto }]) => {
		make.hidden = shown?.view.layout.kind !== "oriented" || orthophoto !== null && (orthophoto.ofBlock === null || orthophoto.ofBlock === shown.key);
		make.disabled = isBusy(store.state) || imagesOfBlock(store.state).length === 0;
	});
	store.watch(["shown"], ([shown]) => {
		const oriented = shown?.view.layout.kind === "oriented";
		for (const part of [points, ...switches.filter(([name]) => name === "footprints" || name === "offsets" || name === "lasso").map(([, press]) => press)]) part.hidden = !oriented;
	});
	return unfolded("map-menu", points, ...switches.map(([, press]) => press), make);
}
function showLegend(legend, bar, map, view) {
	const scale = view === null || view.layout.kind !== "oriented" ? void 0 : colouredPoints(view.points, map.shows.colouring)?.scale;
	const text = view === null ? "" : legendText(view, map);
	const ends = scale === void 0 ? [] : [scale.from, scale.to].map((value) => withUnit(fixed(value, scale.digits), scale.unit));
	const now = [text, ...ends].join("|");
	if (legend.dataset.text === now) return;
	legend.dataset.text = now;
	fill(legend, text, ...scale === void 0 ? [] : [h("span", { class: "map-colours" }, `${scale.title}: ${ends[0] ?? ""}`, bar, ends[1] ?? "")]);
}
function systemText(view, map) {
	const { name } = resultSystem(view);
	if (name !== "") return asFigure(name);
	const system = systemOf(view, map.ground());
	return system === "surveyed" && isInSystemOf(view) ? say("system-of-the-orthophoto") : SYSTEMS[system];
}
function legendText(view, map) {
	const most = view.connections.reduce((high, { shared }) => Math.max(high, shared), 0);
	const matches = mostMatches(view);
	const widest = most > 0 ? say("common-points", { most }) : say("matches", { matches });
	const system = view.layout.kind === "connections" ? "" : ` (${systemText(view, map)})`;
	return `${LAYOUTS[view.layout.kind]}${system}.${orthophotoNote(map, view)} ${map.shows.connections && most + matches > 0 ? say("widest-line", { widest }) : ""}`;
}
function orthophotoNote(map, view) {
	const { orthophoto } = map;
	if (orthophoto === null || view.layout.kind !== "oriented") return "";
	const laid = map.laid();
	if (laid === null) {
		if (orthophoto.ofBlock !== null) return say("the-orthomosaic-is-of-an");
		const why = whyNotLaid(orthophoto, view);
		return why === "" ? say("the-orthophoto-is-in-another") : why;
	}
	if (map.shows.orthophoto && laid.crs !== null) {
		const { departs } = laid.sheet;
		return say("orthophoto-laid-under-by-positions", {
			crs: laid.crs,
			departs: departs > .5 ? departs : null
		});
	}
	if (!map.shows.orthophoto || laid.images === 0) return "";
	return say("orthophoto-laid-under-by-placed", { images: laid.images });
}
function placeText(map, view) {
	const { place } = map;
	if (view === null || place === null) return "";
	const system = systemOf(view, map.ground());
	const { code, toBlock, unit: units, more } = resultSystem(view);
	if (toBlock !== null) {
		const [x = "", y = ""] = mapped(inverse(toBlock), place[0], place[1]).map((value) => fixed(value, 2 + more));
		return `${withUnit(`X ${x}  Y ${y}`, units[0])}  ${code}`;
	}
	const unit = system === "own" ? "" : " m";
	const own = `${system === "geographic" ? "E" : "X"} ${fixed(place[0], 2)}${unit}  ${system === "geographic" ? "N" : "Y"} ${fixed(place[1], 2)}${unit}`;
	const laid = map.laid();
	if (laid === null || laid.crs === null) return own;
	const [x, y] = placeUnder(laid, view, place).map((value) => fixed(value, isLookedAtAlone(map.orthophoto) ? DIGITS_OF_DEGREES : 2));
	return `${own}  ${laid.crs} ${x ?? ""} ${y ?? ""}`;
}
function inWords(map, view) {
	const ground = map.ground();
	const system = systemOf(view, ground);
	const connected = view.connections.filter(({ outcome }) => outcome.kind === "connected").length;
	const parts = [say("images-oriented-connected-pairs", {
		view: legendText(view, map),
		images: view.images.length,
		oriented: view.oriented,
		connected
	})];
	const coloured = colouredPoints(view.points, map.shows.colouring);
	if (coloured !== null) {
		const { title, from, to, digits, unit } = coloured.scale;
		const { tie, gone } = countedPoints(view);
		parts.push(say("tie-points-from-to", {
			taking: tie.points,
			what: gone > 0 ? say("and-rejected-by-hand", { gone }) : "",
			title,
			from: fixed(from, digits),
			to: fixed(to, digits),
			unit: unitText(unit)
		}).trimEnd());
	}
	if (view.layout.kind !== "connections") parts.push(extentText(view, system));
	const gsd = medianGsd(view, ground);
	if (gsd !== null) parts.push(say("ground-sample-distance", { gsd: lengthText(gsd, system) }));
	const { longest } = offsetsOf(view, ground);
	if (longest.gnss.plan > 0) parts.push(say("gnss-positions-differ-by-up", { gnss: longestText(longest.gnss, system) }));
	if (longest.surveyed.plan > 0) parts.push(say("surveyed-points-differ-by-up", {
		surveyed: view.surveyed.length,
		surveyed_2: longestText(longest.surveyed, system)
	}));
	return `${parts.join(". ")}.`;
}
function extentText({ layout: { kind, places }, images }, system) {
	const span = (axis) => {
		const own = places.filter((_, i) => i % 2 === axis && (kind !== "oriented" || images[Math.floor(i / 2)]?.oriented === true));
		return own.length === 0 ? 0 : own.reduce((high, value) => Math.max(high, value), -Infinity) - own.reduce((low, value) => Math.min(low, value), Infinity);
	};
	return say("the-images-lie-within-by", {
		length_text: lengthText(Math.max(span(0), 1e-9), system),
		length_text_2: lengthText(Math.max(span(1), 1e-9), system)
	});
}
// www/block/engine/link-hands.ts
var LinkHands = class {
	store;
	engine;
	constructor(store, engine) {
		this.store = store;
		this.engine = engine;
	}
	get image() {
		const placed = chosenPlaced(this.store.state);
		const isFree = !isBusy(this.store.state) && this.store.state.placing.adjusting === null;
		return placed !== null && placed.result !== null && isFree ? placed : null;
	}
	use(kind) {
		const { link } = this.store.state.placing.chosen;
		if (link !== null) this.step({
			kind,
			link
		});
	}
	measure() {
		const begins = this.store.state.placing.draft === null && this.image !== null;
		this.store.dispatch({
			type: "linkDraft",
			draft: begins ? {
				at: null,
				place: null
			} : null
		});
	}
	place(end, position) {
		const { draft } = this.store.state.placing;
		if (draft === null || this.image === null) return Promise.resolve(null);
		this.store.dispatch({
			type: "linkDraft",
			draft: {
				...draft,
				[end]: position
			}
		});
		return this.expected();
	}
	async expected() {
		const { draft } = this.store.state.placing;
		const placement = this.image?.result?.placement ?? null;
		if (draft === null || placement === null || draft.at === null === (draft.place === null)) return null;
		try {
			return await this.engine.predict(placement, draft);
		} catch {
			return null;
		}
	}
	accept() {
		const { draft } = this.store.state.placing;
		if (draft?.at == null || draft.place === null || this.image === null) return;
		const { at, place } = draft;
		this.store.dispatch({
			type: "linkDraft",
			draft: null
		});
		this.step({
			kind: "add",
			at,
			place
		});
	}
	go(by) {
		const { image } = this;
		if (image === null) return;
		const done = image.done + by;
		if (done >= 0 && done <= image.steps.length) this.follow(image, image.steps, done);
	}
	step(step) {
		const { image } = this;
		if (image !== null) this.follow(image, [...image.steps.slice(0, image.done), step], image.done + 1);
	}
	async follow({ file, key, result, problem, found, steps: former, done: before }, steps, done) {
		const own = {
			key,
			problem,
			found
		};
		const tell = (text) => this.store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text
			}
		});
		this.store.dispatch({
			type: "notice",
			notice: null
		});
		this.store.dispatch({
			type: "placed",
			image: file,
			placed: {
				...own,
				result,
				steps,
				done
			}
		});
		try {
			const adjusted = await this.engine.adjust(file, found, steps.slice(0, done));
			this.store.dispatch({
				type: "placed",
				image: file,
				placed: {
					...own,
					result: adjusted,
					steps,
					done
				}
			});
			const added = steps[done - 1]?.kind === "add" && done > before ? shownLinks({
				result: adjusted,
				steps,
				done
			}) : null;
			if (added !== null) this.store.dispatch({
				type: "choosePlaced",
				looked: {
					image: file.id,
					link: added.count - 1
				}
			});
		} catch (error) {
			this.store.dispatch({
				type: "placed",
				image: file,
				placed: {
					...own,
					result,
					steps: former,
					done: before
				}
			});
			const last = steps[done - 1];
			if (!(error instanceof Cancelled)) tell(say("not-done", {
				what: last === void 0 ? "" : say("n-", { last: stepName(last) }),
				sentence: sentence(messageOf(error))
			}));
		}
	}
};
// www/block/engine/place-hands.ts
var PlaceHands = class {
	store;
	engine;
	measure;
	constructor(store, engine, measure) {
		this.store = store;
		this.engine = engine;
		this.measure = measure;
	}
	get can() {
		const { state } = this.store;
		return takesPlaces(state) && isEditable(state) && !isBusy(state);
	}
	toggle() {
		this.store.dispatch({
			type: "addsPlace",
			adds: !this.store.state.placing.adds && this.can
		});
	}
	async take(place) {
		if (!this.can) return;
		const { shown, history } = this.store.state;
		if (shown === null) return;
		const number = nextPlace(history);
		try {
			const edit = await this.engine.controlByHand(place, number, shown.view);
			if (!this.store.state.placing.adds || this.store.state.shown?.found !== shown.found) return;
			this.store.dispatch({
				type: "addsPlace",
				adds: false
			});
			this.store.dispatch({
				type: "edit",
				edits: [edit]
			});
			this.store.dispatch({
				type: "choose",
				choice: {
					kind: "given",
					name: edit.name
				}
			});
			this.measure();
		} catch (error) {
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "problem",
					text: sentence(messageOf(error))
				}
			});
		}
	}
};
// www/block/view/orthophoto/picture.ts
var EDGE$1 = 24;
var SPARE = .96;
var LinkPicture = class {
	store;
	hands;
	layers;
	moved = null;
	part = null;
	pointer = null;
	listeners = [];
	constructor(host, store, hands, keys) {
		this.store = store;
		this.hands = hands;
		this.layers = new Layers(host, ["picture", "marks"], (name, context) => {
			const box = this.whole();
			if (box === null) return;
			const t = this.current(box);
			if (name === "picture") this.paintPicture(context, t);
			else this.paintMarks(context, themeColours(), t);
		});
		onRecolour(() => this.layers.redraw());
		listen(host, {
			at: () => this.whole(),
			focused: () => this.whole(),
			pan: (box, dx, dy) => this.move(panned(this.current(box), dx, dy)),
			zoom: (box, factor, x, y) => this.zoom(box, factor, x, y),
			zoomMiddle: (factor) => this.zoomMiddle(factor),
			fit: () => this.fit(),
			pressed: (x, y) => this.pressed(x, y),
			pointed: (at, dragging) => this.hover(at, dragging),
			command: keys
		});
	}
	other(_x, _y) {
		return null;
	}
	watch(changed) {
		this.listeners.push(changed);
	}
	get place() {
		return this.pointer;
	}
	redraw() {
		this.layers.redraw();
	}
	fit() {
		this.show(null);
	}
	show(part) {
		this.part = part;
		this.moved = null;
		this.layers.redraw();
	}
	reveal(link) {
		const [x, y] = this.links()?.points.subarray(3 * link, 3 * link + 2) ?? [];
		if (x !== void 0 && y !== void 0) this.bring([x, y]);
	}
	bring(at) {
		const box = this.whole();
		const { width, height } = this.layers;
		if (box === null || width < 48 || height < 48) return;
		const t = this.current(box);
		const [x, y] = toCanvas(t, ...at);
		if (this.moved === null && x >= 0 && y >= 0 && x <= width && y <= height) return;
		const [dx, dy] = [into(x, width), into(y, height)];
		if (dx !== 0 || dy !== 0) this.move(panned(t, dx, dy));
	}
	zoomMiddle(factor) {
		const box = this.whole();
		if (box !== null) this.zoom(box, factor, this.layers.width / 2, this.layers.height / 2);
	}
	chosen() {
		return chosenPlaced(this.store.state);
	}
	current(box) {
		if (this.moved !== null) return resized(this.moved.t, this.moved.on, this.layers);
		const { width, height } = this.layers;
		const [left, top, right, bottom] = this.part ?? box;
		const scale = SPARE * Math.min(width / Math.max(right - left, 1e-9), height / Math.max(bottom - top, 1e-9));
		return {
			scale,
			x: width / 2 - scale * (left + right) / 2,
			y: height / 2 - scale * (top + bottom) / 2
		};
	}
	move(t) {
		const { width, height } = this.layers;
		this.moved = {
			t,
			on: {
				width,
				height
			}
		};
		this.layers.redraw();
	}
	zoom(box, factor, x, y) {
		const t = this.current(box);
		const fits = Math.min(this.layers.width / (box[2] - box[0]), this.layers.height / (box[3] - box[1]));
		this.move(zoomedAbout(t, factor, x, y, {
			least: .2 * fits,
			most: this.mostScale(fits)
		}));
	}
	mostScale(fits) {
		return 400 * fits;
	}
	predicted = null;
	expect(at) {
		this.predicted = at;
		if (at !== null) this.bring(at);
		this.layers.redraw("marks");
	}
	paintEnd(context, t) {
		if (this.store.state.placing.draft === null) return;
		const end = this.end();
		if (end !== null) drawCross(context, toCanvas(t, ...end), MEASURED.colour);
		else if (this.predicted !== null) drawCross(context, toCanvas(t, ...this.predicted), CANDIDATE);
	}
	pressed(x, y) {
		const box = this.whole();
		if (this.store.state.placing.draft !== null && box !== null) {
			this.measured(toPosition(this.current(box), x, y));
			return;
		}
		this.store.dispatch({
			type: "choosePlaced",
			looked: this.lookedAt(x, y)
		});
	}
	point(at) {
		this.store.dispatch({
			type: "pointPlaced",
			looked: at === null ? NOTHING_LOOKED_AT : this.lookedAt(...at)
		});
	}
	lookedAt(x, y) {
		const box = this.whole();
		const links = this.links();
		const { chosen, uses } = this.store.state.placing;
		const link = box === null || links === null ? -1 : linkAt(links, uses, this.current(box), x, y);
		if (link >= 0) return {
			image: chosen.image,
			link
		};
		return this.other(x, y) ?? NOTHING_LOOKED_AT;
	}
	hover(at, dragging) {
		const box = this.whole();
		this.pointer = at === null || box === null ? null : toPosition(this.current(box), ...at);
		if (!dragging) this.point(at);
		for (const listener of this.listeners) listener();
	}
};
function into(at, length) {
	return at < EDGE$1 ? 72 - at : at > length - EDGE$1 ? length - 72 - at : 0;
}
// www/block/view/orthophoto/image.ts
var PlacedImageView = class extends LinkPicture {
	bitmaps;
	drawn = remember(linksOnImage);
	of = -1;
	longer = 50;
	constructor(host, store, hands, keys, grey) {
		super(host, store, hands, keys);
		this.bitmaps = new Bitmaps(grey, () => this.layers.redraw("picture"));
		store.watch(["placing", "files"], () => {
			const { id } = this.chosen()?.file ?? { id: -1 };
			this.bitmaps.keep(new Set([id]));
			if (this.of !== id) this.fit();
			this.of = id;
			this.layers.redraw();
		});
	}
	get factor() {
		return this.longer;
	}
	set factor(factor) {
		this.longer = factor;
		this.layers.redraw("marks");
	}
	size() {
		const [width, height] = this.chosen()?.result?.size ?? [];
		return width === void 0 || height === void 0 ? null : {
			width,
			height
		};
	}
	whole() {
		const size = this.size();
		return size === null ? null : [
			0,
			0,
			size.width,
			size.height
		];
	}
	mostScale(fits) {
		return Math.max(32, 4 * fits);
	}
	links() {
		const chosen = this.chosen();
		const links = chosen === null ? null : shownLinks(chosen);
		return links === null ? null : this.drawn(links);
	}
	other() {
		return {
			image: this.store.state.placing.chosen.image,
			link: null
		};
	}
	end() {
		return this.store.state.placing.draft?.at ?? null;
	}
	measured(at) {
		const size = this.size();
		if (size === null || at[0] < 0 || at[1] < 0 || at[0] > size.width || at[1] > size.height) return;
		this.hands.place("at", at).then((place) => this.ground?.expectPlace(place));
	}
	ground = null;
	get clip() {
		return {
			left: 0,
			top: 0,
			width: this.layers.width,
			height: this.layers.height
		};
	}
	paintPicture(context, t) {
		const [chosen, size] = [this.chosen(), this.size()];
		if (chosen === null || size === null) return;
		const { ratio } = this.layers;
		const part = visiblePart(size, t, this.clip);
		smooth(context, t.scale, ratio);
		for (const { bitmap, x, y, step } of this.bitmaps.pieces(chosen.file, size, "pane", part, t.scale * ratio)) paintBitmap(context, bitmap, x, y, step, part, t);
	}
	paintMarks(context, _colours, t) {
		const links = this.links();
		if (links === null) {
			this.paintEnd(context, t);
			return;
		}
		const { clip } = this;
		const { chosen, pointed, uses } = this.store.state.placing;
		if (this.longer > 0) drawLinkResiduals(context, links, this.longer, t, clip, uses);
		drawLinks(context, links, t, clip, uses);
		if (pointed.image === chosen.image && pointed.link !== null) drawRing(context, links, pointed.link, t, false);
		if (chosen.link !== null) drawRing(context, links, chosen.link, t, true);
		this.paintEnd(context, t);
		if (this.longer > 0) drawScaleBar(context, this.longer, {
			transform: t,
			rect: clip
		});
	}
};
// www/block/view/orthophoto/keys.ts
function placeKeys(store, hands, middle) {
	const adds = () => store.state.placing.adds;
	return [
		{
			keys: ["a"],
			does: say("adds-a-place-or"),
			can: () => adds() || hands.can && chosenPlaced(store.state) === null,
			run: () => hands.toggle()
		},
		{
			keys: ["Enter"],
			does: say("takes-the-place-under-the-cross"),
			can: adds,
			run: middle
		},
		{
			keys: ["Escape"],
			does: say("adds-no-place"),
			can: adds,
			run: () => hands.toggle()
		}
	];
}
function blockKeys(store, { step, leave }) {
	const can = () => blockOnOrthophoto(store.state) !== null && !store.state.placing.picks;
	return [
		{
			keys: ["n"],
			does: say("chooses-the-next-place-of"),
			can,
			run: () => step("place", 1)
		},
		{
			keys: ["p"],
			does: say("chooses-the-previous-place-of"),
			can,
			run: () => step("place", -1)
		},
		{
			keys: ["PageDown"],
			does: say("chooses-the-next-image"),
			can,
			run: () => step("image", 1)
		},
		{
			keys: ["PageUp"],
			does: say("chooses-the-previous-image"),
			can,
			run: () => step("image", -1)
		},
		{
			keys: ["Escape"],
			does: say("chooses-nothing"),
			can,
			lacks: () => store.state.selection.chosen === null ? say("nothing-is-chosen") : "",
			run: leave
		}
	];
}
function linkKeys(store, hands) {
	const now = () => store.state.placing;
	const isImageChosen = () => chosenPlaced(store.state) !== null;
	const isLinkChosen = () => isImageChosen() && now().chosen.link !== null;
	const links = () => {
		const chosen = chosenPlaced(store.state);
		return chosen === null ? 0 : shownLinks(chosen)?.count ?? 0;
	};
	const tried = () => store.state.files.filter(({ id }) => now().placed.has(id)).map(({ id }) => id);
	const toLink = (by) => {
		const { image, link } = now().chosen;
		store.dispatch({
			type: "choosePlaced",
			looked: {
				image,
				link: stepped$1(link ?? -1, by, links())
			}
		});
	};
	const toImage = (by) => {
		const all = tried();
		store.dispatch({
			type: "choosePlaced",
			looked: {
				image: all[stepped$1(all.indexOf(now().chosen.image ?? -1), by, all.length)] ?? null,
				link: null
			}
		});
	};
	const leave = () => {
		const { draft, picks, chosen } = now();
		if (draft !== null) hands.measure();
		else if (picks) store.dispatch({
			type: "picksPlace",
			picks: false
		});
		else store.dispatch({
			type: "choosePlaced",
			looked: chosen.link === null ? NOTHING_LOOKED_AT : {
				image: chosen.image,
				link: null
			}
		});
	};
	const isAtWork = () => now().draft !== null || now().picks || now().chosen.image !== null;
	const hasLinks = () => links() > 0;
	const hasImages = () => tried().length > 0;
	return [
		{
			keys: ["n"],
			does: say("chooses-the-next-link-of"),
			can: hasLinks,
			run: () => toLink(1)
		},
		{
			keys: ["p"],
			does: say("chooses-the-previous-link-of"),
			can: hasLinks,
			run: () => toLink(-1)
		},
		{
			keys: ["PageDown"],
			does: say("chooses-the-next-image-that"),
			can: hasImages,
			run: () => toImage(1)
		},
		{
			keys: ["PageUp"],
			does: say("chooses-the-previous-image-that"),
			can: hasImages,
			run: () => toImage(-1)
		},
		{
			keys: ["Delete"],
			does: say("rejects-the-chosen-link"),
			can: isLinkChosen,
			run: () => hands.use("reject")
		},
		{
			keys: ["r"],
			does: say("uses-the-chosen-link-again"),
			can: isLinkChosen,
			run: () => hands.use("restore")
		},
		{
			keys: ["a"],
			does: say("measures-a-new-link-or"),
			can: isImageChosen,
			run: () => hands.measure()
		},
		{
			keys: ["Enter"],
			does: say("accepts-the-link-that-is"),
			can: () => now().draft !== null,
			run: () => hands.accept()
		},
		{
			keys: ["Escape"],
			does: say("gives-up-or-chooses-nothing"),
			lacks: () => isAtWork() ? "" : say("nothing-is-chosen"),
			run: leave
		}
	];
}
function stepped$1(now, by, count) {
	return now < 0 ? by > 0 ? 0 : count - 1 : (now + by + count) % count;
}
// www/block/view/orthophoto/footprints.ts
var REACH$1 = 12;
var MOST_NAMES = 60;
function footprintAt(all, t, x, y) {
	const [east, south] = toPosition(t, x, y);
	const [first] = all.map((of) => {
		const [cx, cy] = toCanvas(t, of.centre[0], -of.centre[1]);
		return {
			of,
			distance: Math.hypot(cx - x, cy - y)
		};
	}).filter(({ of, distance }) => distance < REACH$1 || isInside(of.outline, east, -south)).sort((a, b) => a.distance - b.distance);
	return first ?? null;
}
function isInside(outline, x, y) {
	let inside = false;
	outline.forEach(([ax, ay], i) => {
		const [bx, by] = outline[(i + 1) % outline.length] ?? [ax, ay];
		if (ay > y !== by > y && x < ax + (bx - ax) * (y - ay) / (by - ay)) inside = !inside;
	});
	return inside;
}
function paintFootprint(context, t, { outline, colour, isStale }, chosen, pointed) {
	context.save();
	context.beginPath();
	for (const [x, y] of outline) context.lineTo(...toCanvas(t, x, -y));
	context.closePath();
	context.strokeStyle = "rgb(0 0 0 / 0.55)";
	context.lineWidth = chosen ? 5 : 3;
	context.stroke();
	context.strokeStyle = colour;
	context.lineWidth = chosen ? 2.5 : pointed ? 2 : 1.2;
	if (isStale) context.setLineDash([6, 4]);
	context.stroke();
	if (pointed && !chosen) {
		context.fillStyle = colour;
		context.globalAlpha = .1;
		context.fill();
	}
	context.restore();
}
function paintCentres(context, colours, t, all, isChosen) {
	for (const of of all) paintCentre(context, colours, t, of, isChosen(of), all.length <= MOST_NAMES);
}
function paintCentre(context, colours, t, of, chosen, hasName) {
	const [x, y] = toCanvas(t, of.centre[0], -of.centre[1]);
	context.save();
	context.beginPath();
	context.arc(x, y, chosen ? 7 : 5, 0, 2 * Math.PI);
	context.fillStyle = of.colour;
	context.fill();
	context.lineWidth = 2;
	context.strokeStyle = colours.surface;
	context.stroke();
	if (hasName || chosen) {
		context.font = chosen ? "600 12px system-ui, sans-serif" : "11px system-ui, sans-serif";
		context.textAlign = "center";
		haloed(context, colours, of.name, x, y + 20);
	}
	context.restore();
}
// www/block/view/orthophoto/block.ts
var isOnOrthophoto = (name) => isPlace(name) || isPlaceByHand(name);
var inSystem = remember((view, ground, to) => {
	if (to === SAME) return {
		view,
		ground
	};
	const turn = {
		...to,
		e: 0,
		f: 0
	};
	const footprints = ground?.footprints.slice() ?? new Float64Array();
	for (let i = 0; i < footprints.length; i += 2) footprints.set(mapped(to, footprints[i] ?? NaN, footprints[i + 1] ?? NaN), i);
	return {
		view: {
			...view,
			images: view.images.map((image) => image.position === null ? image : {
				...image,
				position: [...mapped(to, image.position[0], image.position[1]), image.position[2]]
			}),
			surveyed: view.surveyed.map((point) => ({
				...point,
				position: [...mapped(to, point.position[0], point.position[1]), point.position[2]],
				difference_m: [...mapped(turn, point.difference_m[0], point.difference_m[1]), point.difference_m[2]]
			}))
		},
		ground: ground === null ? null : {
			...ground,
			footprints
		}
	};
});
var onOrthophoto = remember((view, ground, isStale, keepsImage, keepsPoint) => ({
	view,
	images: view.images.flatMap(({ name, position }, image) => position === null || !keepsImage(image) ? [] : [{
		image,
		name,
		isStale,
		colour: ACCEPTED.colour,
		centre: [position[0], position[1]],
		outline: outlineOf(ground, image)
	}]),
	places: pointsWhere(view, (row, name) => isOnOrthophoto(name) && keepsPoint(row)),
	surveyed: pointsWhere(view, (row, name) => !isOnOrthophoto(name) && keepsPoint(row))
}));
function outlineOf(ground, image) {
	const corners = ground?.footprints.subarray(8 * image, 8 * image + 8) ?? [];
	return [
		0,
		2,
		4,
		6
	].map((at) => [corners[at] ?? NaN, corners[at + 1] ?? NaN]).filter(([x]) => !Number.isNaN(x));
}
function pointsWhere({ surveyed }, keeps) {
	const rows = surveyed.flatMap(({ name }, row) => keeps(row, name) ? [row] : []);
	const own = rows.flatMap((row) => surveyed[row] ?? []);
	return {
		rows,
		drawn: pointsOnGround(own.flatMap(({ position }) => position), own.map((point) => codeOfUse(useOf(point), point.byHand)))
	};
}
function useOf({ role, isUsed }) {
	return !isUsed ? "rejected" : role === "check" ? "check" : "used";
}
var ALL = new Set(USES$1);
function choiceAt(of, uses, t, x, y) {
	const image = footprintAt(of.images, t, x, y);
	const [point] = [nearest(of.places, uses, t, x, y), nearest(of.surveyed, ALL, t, x, y)].filter((found) => found !== null).sort((a, b) => a.distance - b.distance);
	if (point !== void 0 && (image === null || point.distance < image.distance)) return choiceOf(of.view, point.row);
	return image === null ? null : {
		kind: "image",
		image: image.of.image
	};
}
function nearest({ rows, drawn }, uses, t, x, y) {
	const found = linkAt(drawn, uses, t, x, y);
	const row = rows[found];
	if (row === void 0) return null;
	const [px, py] = toCanvas(t, drawn.points[3 * found] ?? 0, drawn.points[3 * found + 1] ?? 0);
	return {
		row,
		distance: Math.hypot(px - x, py - y)
	};
}
function choiceOf({ surveyed }, row) {
	const point = surveyed[row]?.point ?? -1;
	return point < 0 ? null : {
		kind: "point",
		point
	};
}
function stepped({ view, images, places: { rows } }, uses, of, chosen, by) {
	const isThere = (row) => {
		const own = view.surveyed[row];
		return own !== void 0 && own.point >= 0 && uses.has(useOf(own));
	};
	const all = of === "image" ? images.map(({ image }) => image) : rows.filter(isThere);
	const [point = -1] = pointsOf(chosen);
	const now = of === "image" ? all.indexOf(imagesOf(chosen)[0] ?? -1) : all.findIndex((row) => view.surveyed[row]?.point === point);
	const next = all[now < 0 ? by > 0 ? 0 : all.length - 1 : (now + by + all.length) % all.length];
	if (next === void 0) return null;
	return of === "image" ? {
		kind: "image",
		image: next
	} : choiceOf(view, next);
}
function placeOfChoice({ view, images }, chosen) {
	if (chosen?.kind === "image") return images.find(({ image }) => image === chosen.image)?.centre ?? null;
	const [point] = pointsOf(chosen);
	const [x, y] = view.surveyed.find((own) => point !== void 0 && own.point === point)?.position ?? [];
	return x === void 0 || y === void 0 ? null : [x, y];
}
function paintBlock(context, colours, t, clip, of, uses, { chosen, pointed }) {
	const isOf = (choice) => (own) => imagesOf(choice).includes(own.image);
	for (const own of of.images) paintFootprint(context, t, own, isOf(chosen)(own), isOf(pointed)(own));
	drawLinks(context, of.places.drawn, t, clip, uses);
	const isSurveyed = new Set(of.surveyed.rows);
	paintSurveyed(context, colours, offsetsOf(of.view, null, () => false, (row) => isSurveyed.has(row)), t, 1, false, [clip.width, clip.height]);
	for (const points of [of.places, of.surveyed]) {
		paintRings(context, t, of.view, points, pointed, false);
		paintRings(context, t, of.view, points, chosen, true);
	}
	paintCentres(context, colours, t, of.images, isOf(chosen));
}
function paintRings(context, t, { surveyed }, { rows, drawn }, of, isChosen) {
	const points = new Set(pointsOf(of));
	if (points.size === 0) return;
	rows.forEach((row, i) => {
		if (points.has(surveyed[row]?.point ?? -1)) drawRing(context, drawn, i, t, isChosen);
	});
}
// www/block/view/orthophoto/over.ts
var SIDE = 3e3;
var ImageOver = class {
	make;
	arrived;
	of = null;
	picture = null;
	constructor(make, arrived) {
		this.make = make;
		this.arrived = arrived;
	}
	paint(context, placed, t) {
		const placement = placed?.result?.placement ?? null;
		if (placed === null || placement === null) return;
		if (this.of !== placement) this.ask(placed, placement);
		if (this.picture === null) return;
		const { bitmap, step, georeference } = this.picture;
		const { a, b, c, d, e, f } = after({
			a: t.scale,
			b: 0,
			c: 0,
			d: -t.scale,
			e: t.x,
			f: t.y
		}, affineOf(georeference));
		context.save();
		context.transform(a, b, c, d, e, f);
		context.drawImage(bitmap, 0, 0, bitmap.width * step, bitmap.height * step);
		context.restore();
	}
	ask(placed, placement) {
		this.of = placement;
		this.picture?.bitmap.close();
		this.picture = null;
		this.make(placed, placement, SIDE).then((picture) => {
			if (this.of === placement) this.picture = picture;
			else picture.bitmap.close();
			this.arrived();
		}, (error) => {
			if (this.of === placement && error instanceof Cancelled) this.of = null;
		});
	}
};
// www/block/view/orthophoto/plan.ts
var SYSTEM$1 = "surveyed";
var VERDICTS$1 = {
	placed: ACCEPTED.colour,
	weak: "#ffb000",
	not_placed: REJECTED$1.colour
};
var OrthophotoPlan = class extends LinkPicture {
	places;
	looking;
	facts;
	tiles;
	over;
	lays = false;
	followed = null;
	drawn = remember(linksOnGround);
	constructor(host, store, hands, places, keys, engine, looking, facts) {
		super(host, store, hands, keys);
		this.places = places;
		this.looking = looking;
		this.facts = facts;
		this.tiles = new OrthophotoTiles((level, column, row) => engine.tile(level, column, row), () => this.layers.redraw("picture"));
		this.over = new ImageOver(({ file }, placement, side) => engine.laid(file, placement, side), () => this.layers.redraw("picture"));
		store.watch([
			"placing",
			"files",
			"options",
			"shown",
			"history"
		], () => this.layers.redraw());
		store.watch(["selection"], ([{ chosen }]) => this.follow(chosen));
		facts.watch(() => this.layers.redraw("marks"));
	}
	block() {
		const { state } = this.store;
		const shown = blockOnOrthophoto(state);
		const { orthophoto } = state.placing;
		if (shown === null || orthophoto === null) return null;
		const drawn = inSystem(shown.view, this.facts.ground(), toSystemOf(orthophoto, shown.view) ?? SAME);
		const keeps = (subject) => keptBy(subject, shown.view, state.selection);
		return onOrthophoto(drawn.view, drawn.ground, liesElsewhere(state), keeps("images"), keeps("surveyed"));
	}
	follow(chosen) {
		this.layers.redraw("marks");
		const block = this.block();
		const place = block === null || chosen === this.followed ? null : placeOfChoice(block, chosen);
		this.followed = chosen;
		if (place !== null) this.bring([place[0], -place[1]]);
	}
	step(of, by) {
		const block = this.block();
		if (block !== null) this.looking.choose(stepped(block, this.store.state.placing.uses, of, this.store.state.selection.chosen, by));
	}
	get isLaid() {
		return this.lays;
	}
	set isLaid(lays) {
		this.lays = lays;
		this.layers.redraw("picture");
	}
	whole() {
		const { orthophoto } = this.store.state.placing;
		return orthophoto === null ? null : boxOf(cornersOf(orthophoto));
	}
	showImage({ footprint, pose }) {
		this.show(boxOf([...footprint, [pose.position[0], pose.position[1]]]));
	}
	mostScale(fits) {
		const { orthophoto } = this.store.state.placing;
		return Math.max(4 * fits, 40 / (orthophoto?.info.gsd ?? 1));
	}
	links() {
		const chosen = this.chosen();
		const links = chosen === null ? null : shownLinks(chosen);
		return links === null ? null : this.drawn(links);
	}
	end() {
		const place = this.store.state.placing.draft?.place ?? null;
		return place === null ? null : [place[0], -place[1]];
	}
	measured([east, south]) {
		this.hands.place("place", [east, -south]).then((at) => this.image?.expect(at));
	}
	image = null;
	expectPlace(place) {
		this.expect(place === null ? null : [place[0], -place[1]]);
	}
	takeMiddle() {
		this.take(this.layers.width / 2, this.layers.height / 2);
	}
	take(x, y) {
		const box = this.whole();
		if (box === null) return;
		const [east, south] = toPosition(this.current(box), x, y);
		this.places.take([east, -south]);
	}
	pressed(x, y) {
		const box = this.whole();
		if (this.store.state.placing.adds) {
			this.take(x, y);
			return;
		}
		if (!this.store.state.placing.picks || box === null) {
			const block = this.block();
			if (block === null || box === null) super.pressed(x, y);
			else {
				this.followed = this.choiceAt(block, box, x, y);
				this.looking.choose(this.followed);
			}
			return;
		}
		const [east, south] = toPosition(this.current(box), x, y);
		const { gsd } = this.store.state.placing.orthophoto?.info ?? { gsd: 1 };
		const round = (value) => Number(value.toFixed(Math.max(0, Math.ceil(-Math.log10(gsd)))));
		this.store.dispatch({
			type: "placingOptions",
			options: {
				near_x: round(east),
				near_y: round(-south)
			}
		});
	}
	point(at) {
		const [block, box] = [this.block(), this.whole()];
		if (block === null || box === null) super.point(at);
		else this.looking.point(at === null ? null : this.choiceAt(block, box, ...at));
	}
	choiceAt(block, box, x, y) {
		return choiceAt(block, this.store.state.placing.uses, this.current(box), x, y);
	}
	other(x, y) {
		const box = this.whole();
		const found = box === null ? null : footprintAt(this.footprints(), this.current(box), x, y);
		return found === null ? null : {
			image: found.of.file,
			link: null
		};
	}
	footprints() {
		return placedFiles(this.store.state).flatMap(({ file, result, isStale }) => {
			const placement = result?.placement ?? null;
			if (result === null || placement === null) return [];
			const [x, y] = placement.pose.position;
			return [{
				file: file.id,
				name: file.name,
				isStale,
				colour: VERDICTS$1[result.verdict.kind],
				centre: [x, y],
				outline: placement.footprint
			}];
		});
	}
	paintPicture(context, t) {
		const { orthophoto } = this.store.state.placing;
		const { width, height, ratio } = this.layers;
		if (orthophoto === null) return;
		this.tiles.paint(context, orthophoto, throughout(affineOf(orthophoto.info.georeference)), t, [
			width,
			height,
			ratio
		]);
		if (this.lays) this.over.paint(context, this.chosen(), t);
	}
	paintMarks(context, colours, t) {
		const { width, height } = this.layers;
		const clip = {
			left: 0,
			top: 0,
			width,
			height
		};
		paintGrid(context, colours, t, width, height);
		this.paintNear(context, colours, t);
		const block = this.block();
		if (block !== null) paintBlock(context, colours, t, clip, block, this.store.state.placing.uses, this.store.state.selection);
		else this.paintPlaced(context, colours, t, clip);
		this.paintWaiting(context, colours, t);
		if (this.store.state.placing.adds) drawCross(context, [width / 2, height / 2], MEASURED.colour);
		paintScale(context, colours, t, height, SYSTEM$1, null, unitOfOrthophoto(this.store.state.placing.orthophoto));
		paintNorth(context, colours, width, SYSTEM$1);
	}
	paintPlaced(context, colours, t, clip) {
		const { chosen, pointed, uses } = this.store.state.placing;
		const all = this.footprints();
		for (const own of all) paintFootprint(context, t, own, own.file === chosen.image, own.file === pointed.image);
		const links = this.links();
		if (links !== null) {
			drawLinks(context, links, t, clip, uses);
			if (pointed.image === chosen.image && pointed.link !== null) drawRing(context, links, pointed.link, t, false);
			if (chosen.link !== null) drawRing(context, links, chosen.link, t, true);
		}
		this.paintEnd(context, t);
		paintCentres(context, colours, t, all, ({ file }) => file === chosen.image);
	}
	paintWaiting(context, colours, t) {
		const { shown, selection } = this.store.state;
		if (shown === null || shown.view.crs !== null || !takesPlaces(this.store.state)) return;
		context.save();
		for (const { name, position } of shown.given.filter(({ byHand }) => byHand)) {
			const at = toCanvas(t, position[0], -position[1]);
			drawCross(context, at, selection.chosen?.kind === "given" && selection.chosen.name === name ? SELECTED : CANDIDATE);
			context.font = "11px system-ui, sans-serif";
			context.textAlign = "start";
			haloed(context, colours, name, at[0] + 9, at[1] - 6);
		}
		context.restore();
	}
	paintNear(context, colours, t) {
		const { options } = this.store.state.placing;
		if (options?.near_x == null || options.near_y == null) return;
		const [x, y] = toCanvas(t, options.near_x, -options.near_y);
		context.save();
		context.strokeStyle = colours.accent;
		context.lineWidth = 2;
		context.setLineDash([6, 4]);
		context.beginPath();
		context.arc(x, y, Math.max(1, options.within_m * t.scale), 0, 2 * Math.PI);
		context.stroke();
		context.setLineDash([]);
		context.beginPath();
		for (const [dx, dy] of [[1, 0], [0, 1]]) {
			context.moveTo(x - 7 * dx, y - 7 * dy);
			context.lineTo(x + 7 * dx, y + 7 * dy);
		}
		context.stroke();
		context.font = "11px system-ui, sans-serif";
		context.textAlign = "start";
		haloed(context, colours, say("sought-from-here"), x + 9, y - 6);
		context.restore();
	}
};
function cornersOf({ info: { width, height, georeference } }) {
	const toGround = affineOf(georeference);
	return [
		[0, 0],
		[width, 0],
		[width, height],
		[0, height]
	].map(([x = 0, y = 0]) => mapped(toGround, x, y));
}
function boxOf(places) {
	const [xs, ys] = [places.map(([x]) => x), places.map(([, y]) => -y)];
	return [
		Math.min(...xs),
		Math.min(...ys),
		Math.max(...xs),
		Math.max(...ys)
	];
}
// www/block/panel/placing-words.ts
function verdictText({ result, problem }, { catalogue }) {
	if (result === null) return say("not-read", { problem: sentence(problem) });
	const verdict = message("placing_verdict", result.verdict);
	return readable(catalogue?.labels ?? null, result.search === void 0 ? verdict : `${verdict} ${message("place_search", result.search)}`);
}
// www/block/panel/orthophoto-view.ts
var KEYS$1 = say("press-a-footprint-to-see");
function orthophotoView(engine, facts, placing, { open, sample, measure }) {
	return {
		name: "orthophoto",
		title: say("orthophoto"),
		mount: (store, looking) => {
			const host = (testid, label) => h("div", {
				class: "view",
				testid,
				tabindex: 0,
				role: "group",
				aria: {
					roledescription: say("role-picture"),
					label,
					describedby: KEYS_ID
				}
			});
			const [ground, picture] = [host("ortho-plan", say("orthophoto-with-the-images-that")), host("ortho-image", say("the-chosen-image-with-its"))];
			const [place, at] = [h("p", {
				class: "map-place",
				testid: "ortho-place"
			}), h("p", {
				class: "map-place",
				testid: "ortho-at"
			})];
			const name = h("p", { class: "ortho-name" });
			const beside = h("div", {
				class: "ortho-pane",
				testid: "ortho-beside"
			}, picture, name, at);
			const chosen = h("p", {
				class: "image-point",
				testid: "ortho-chosen",
				role: "status",
				aria: { live: "polite" }
			});
			const element = h("div", {
				class: "ortho-view",
				tabindex: -1
			}, h("div", { class: "ortho-panes" }, h("div", { class: "ortho-pane" }, ground, place, invited$1(store, {
				open,
				sample
			})), beside), h("div", { class: "image-said" }, chosen, legendOf(store)));
			element.addEventListener("focus", () => ground.focus());
			const hands = new LinkHands(store, placing);
			const places = new PlaceHands(store, placing, measure);
			undoKeys(() => place.offsetParent !== null && blockOnOrthophoto(store.state) === null && !takesPlaces(store.state), (by) => hands.go(by));
			const steps = {
				step: (of, by) => plan.step(of, by),
				leave: () => looking.choose(null)
			};
			const keys = declare({
				where: say("orthophoto"),
				host: element,
				list: [
					...placeKeys(store, places, () => plan.takeMiddle()),
					...blockKeys(store, steps),
					...linkKeys(store, hands)
				]
			});
			const plan = new OrthophotoPlan(ground, store, hands, places, keys, placing, looking, facts);
			const image = new PlacedImageView(picture, store, hands, keys, (file) => engine.grey(file));
			plan.image = image;
			image.ground = plan;
			plan.watch(() => fill(place, plan.place === null ? "" : `X ${fixed(plan.place[0], 2)}  Y ${fixed(-plan.place[1], 2)}`));
			image.watch(() => fill(at, image.place === null ? "" : say("column-row", {
				place: image.place[0],
				place_2: image.place[1]
			})));
			follow(store, hands, plan, image, beside, name);
			store.watch([
				"placing",
				"files",
				"options",
				"shown",
				"history"
			], () => {
				element.classList.toggle("has-block", blockOnOrthophoto(store.state) !== null);
				const text = chosenText(store);
				if (chosen.textContent !== text) chosen.textContent = text;
				element.classList.toggle("picks", store.state.placing.picks || store.state.placing.adds);
			});
			const [residuals, select] = vectorChoice("ortho-residuals", (factor) => {
				image.factor = factor;
			});
			select.value = String(image.factor);
			return {
				element,
				tools: [
					toolsOf(store, placing, plan, residuals),
					handsOf(store, hands),
					placesOf(store, places, ground)
				],
				zoomable: plan,
				keys: KEYS$1
			};
		}
	};
}
function follow(store, hands, plan, image, beside, name) {
	let [of, link] = [store.state.placing.chosen.image, store.state.placing.chosen.link];
	let isMeasured = false;
	store.watch([
		"placing",
		"files",
		"options",
		"shown"
	], ([{ chosen, draft }]) => {
		const placed = chosenPlaced(store.state);
		const placement = placed?.result?.placement ?? null;
		beside.hidden = (placed?.result ?? null) === null;
		fill(name, placed?.file.name ?? "");
		if (chosen.image !== of && placement !== null) plan.showImage(placement);
		if (chosen.image === null && of !== null) plan.fit();
		if (chosen.link !== link && chosen.link !== null) for (const picture of [plan, image]) picture.reveal(chosen.link);
		if (draft === null) for (const picture of [plan, image]) picture.predicted = null;
		else if (!isMeasured && placed !== null) hands.expected().then((at) => draft.at === null ? image.expect(at) : plan.expectPlace(at));
		isMeasured = draft !== null && placed !== null;
		[of, link] = [chosen.image, chosen.link];
	});
}
function chosenText({ state }) {
	const { placing } = state;
	const placed = chosenPlaced(state);
	if (placing.picks) return say("press-the-orthophoto-where-images");
	if (placing.adds) return say("press-the-place-on-the-orthophoto");
	const waiting = state.shown?.given.filter(({ byHand }) => byHand) ?? [];
	if (takesPlaces(state) && blockOnOrthophoto(state) === null && waiting.length > 0) return say("places-by-hand-wait", {
		places: waiting.length,
		measured: waiting.filter(({ images }) => images >= 2).length
	});
	if (blockOnOrthophoto(state) !== null) return "";
	if (placed === null && purposeOf(state) === "block") return say("a-block-that-is-placed");
	if (placed === null) return placing.placed.size > 0 ? say("press-a-footprint-or-a") : "";
	if (placing.draft !== null) {
		const { at, place } = placing.draft;
		if (at === null && place === null) return say("a-new-link-press-the");
		return at === null ? say("press-the-point-in-the") : place === null ? say("press-the-point-on-the") : say("press-again-to-move-an");
	}
	if (placing.adjusting === placed.file.id) return say("adjusting");
	const links = shownLinks(placed);
	const added = links?.count ?? 0;
	if (placed.result?.placement === null && added > 0 && placing.chosen.link === null && placed.result === placed.found) return say("of-at-least-links-by", {
		name: placed.file.name,
		added,
		least_links: 4
	});
	if (placing.chosen.link === null || links === null || placing.chosen.link >= links.count) return `${asFigure(placed.file.name)}: ${verdictText(placed, state)}`;
	const link = linkOf(links, placing.chosen.link);
	const residual = link.residual_px;
	const off = residual === null ? say("the-image-does-not-see") : say("residual-px-px", {
		residual: residual[0],
		residual_2: residual[1],
		hypot: Math.hypot(...residual)
	});
	return `${say("link-of", {
		link: placing.chosen.link + 1,
		count: links.count,
		what: link.by_hand ? say("measured-by-hand-3") : "",
		name: useWord(placed, placing.chosen.link, link.role),
		off
	})}X ${fixed(link.place[0], 2)}, Y ${fixed(link.place[1], 2)}, Z ${fixed(link.place[2], 2)}.`;
}
function legendOf(store) {
	const switches = USES$1.map((use) => {
		const press = toggle(LINK_STYLES[use].name, `links-${use}`, HELP.links[use], (on) => store.dispatch({
			type: "showLinks",
			use,
			on
		}));
		press.prepend(h("span", {
			class: `link-mark is-${use}`,
			aria: { hidden: "true" }
		}), " ");
		return press;
	});
	const title = h("span", {});
	const legend = h("p", {
		class: "ortho-legend",
		testid: "ortho-legend"
	}, title, ...switches);
	store.watch([
		"placing",
		"files",
		"options",
		"shown"
	], ([{ uses }]) => {
		const of = blockOnOrthophoto(store.state) === null ? "links" : "places";
		fill(title, of === "links" ? say("links") : say("places-of-the-block"));
		for (const [i, use] of USES$1.entries()) {
			const press = switches[i];
			press?.setAttribute("aria-pressed", String(uses.has(use)));
			if (press !== void 0) press.title = HELP[of][use];
		}
		legend.hidden = of === "links" && (chosenPlaced(store.state)?.result?.placement ?? null) === null;
	});
	return legend;
}
var HELP = {
	links: {
		used: say("links-by-which-the-image"),
		check: say("links-that-took-no-part"),
		rejected: say("links-that-were-rejected-as")
	},
	places: {
		used: say("places-by-which-the-block"),
		check: say("places-that-took-no-part"),
		rejected: say("places-that-were-rejected")
	}
};
function toolsOf(store, engine, plan, residuals) {
	const exports = placingExports(store, engine);
	const near = toggle(say("rough-place"), "ortho-near", say("the-next-press-on-the"), (picks) => store.dispatch({
		type: "picksPlace",
		picks
	}));
	const over = toggle(say("over-the-orthophoto"), "ortho-over", say("the-chosen-image-on-the"), (on) => {
		plan.isLaid = on;
		over.setAttribute("aria-pressed", String(on));
	});
	const everywhere = button(say("everywhere"), "ortho-everywhere", () => store.dispatch({
		type: "placingOptions",
		options: {
			near_x: null,
			near_y: null
		}
	}), say("images-are-sought-on-the"));
	const whole = button(say("whole-orthophoto"), "ortho-whole", () => store.dispatch({
		type: "choosePlaced",
		looked: {
			image: null,
			link: null
		}
	}), say("no-image-is-chosen"));
	store.watch([
		"placing",
		"running",
		"notice",
		"files",
		"shown"
	], ([placing]) => {
		near.setAttribute("aria-pressed", String(placing.picks));
		near.disabled = placing.orthophoto === null || isBusy(store.state);
		everywhere.hidden = placing.options?.near_x == null && placing.options?.near_y == null;
		whole.hidden = chosenPlaced(store.state) === null;
		over.hidden = (chosenPlaced(store.state)?.result?.placement ?? null) === null;
		for (const own of [residuals, exports]) own.hidden = blockOnOrthophoto(store.state) !== null;
	});
	return unfolded("ortho-menu", near, everywhere, residuals, over, whole, exports);
}
function handsOf(store, hands) {
	const reject = button(say("reject-link"), "link-reject", () => hands.use("reject"), say("leaves-the-chosen-link-out"));
	const restore = button(say("use-link"), "link-restore", () => hands.use("restore"), say("lets-the-chosen-link-take"));
	declareLack([reject, restore], () => store.state.placing.chosen.link === null ? say("no-link-is-chosen") : "");
	const add = toggle(say("add-link"), "link-add", say("measures-a-link-by-hand"), () => hands.measure());
	const accept = button(say("accept"), "link-accept", () => hands.accept(), say("takes-the-link-that-is"));
	const undo = button(say("undo"), "link-undo", () => hands.go(-1));
	const redo = button(say("redo"), "link-redo", () => hands.go(1));
	hasKeys(undo, UNDO_KEYS);
	hasKeys(redo, REDO_KEYS);
	store.watch([
		"placing",
		"running",
		"notice",
		"files",
		"options",
		"shown"
	], ([{ chosen, draft, adjusting }]) => {
		const held = document.activeElement;
		const placed = chosenPlaced(store.state);
		const busy = isBusy(store.state);
		for (const press of [
			reject,
			restore,
			add,
			accept,
			undo,
			redo
		]) press.setAttribute("aria-busy", String(adjusting !== null));
		const link = chosen.link === null || placed === null ? null : shownLinks(placed);
		const use = link === null || chosen.link === null ? null : linkOf(link, chosen.link).role;
		for (const press of [
			reject,
			restore,
			add,
			accept,
			undo,
			redo
		]) press.disabled = busy;
		reject.hidden = use === null || use === "rejected";
		restore.hidden = use !== "rejected";
		add.hidden = placed?.result == null;
		add.setAttribute("aria-pressed", String(draft !== null));
		accept.hidden = placed === null || draft?.at == null || draft.place === null;
		const [last, next] = [placed?.steps[placed.done - 1], placed?.steps[placed.done]];
		undo.hidden = last === void 0;
		redo.hidden = next === void 0;
		undo.title = last === void 0 ? "" : say("undo-2", { last: stepName(last) });
		redo.title = next === void 0 ? "" : say("redo-2", { next: stepName(next) });
		passFocus(held, [
			reject,
			restore,
			undo,
			redo,
			add
		]);
	});
	return h("div", { class: "map-tools" }, reject, restore, add, accept, undo, redo);
}
function placesOf(store, hands, ground) {
	const add = toggle(say("add-place"), "place-add", say("measures-a-place-by-hand"), () => {
		hands.toggle();
		if (store.state.placing.adds) ground.focus();
	});
	store.watch([
		"placing",
		"running",
		"notice",
		"files",
		"options",
		"shown"
	], ([{ adds }]) => {
		add.hidden = !takesPlaces(store.state);
		add.disabled = !adds && !hands.can;
		add.setAttribute("aria-pressed", String(adds));
	});
	return h("div", { class: "map-tools" }, add);
}
function invited$1(store, { open, sample }) {
	const own = button(say("open-an-orthophoto"), "ortho-open-first", open);
	own.className = "primary";
	const simulate = button(say("try-a-sample"), "ortho-sample", sample);
	const welcome = h("div", {
		class: "welcome",
		testid: "ortho-welcome"
	}, h("h2", {}, say("photographs-placed-on-an-orthophoto")), h("p", {}, say("drop-an-orthophoto-and-photographs")), h("ul", {}, h("li", {}, say("where-each-was-taken-and")), h("li", {}, say("how-precise-that-is-and")), h("li", {}, say("each-photograph-on-the-ground"))), h("p", { class: "buttons" }, own, simulate), h("p", { class: "note" }, say("an-orthophoto-is-a-geotiff")));
	store.watch([
		"placing",
		"running",
		"notice",
		"catalogue"
	], ([placing, , , catalogue]) => {
		welcome.hidden = placing.orthophoto !== null;
		for (const press of [own, simulate]) press.disabled = catalogue === null || isBusy(store.state);
	});
	return welcome;
}
// www/block/panel/film-settings.ts
var LISTED$1 = 3;
function filmFields(store, files, measureMarks) {
	const { film: taken } = files;
	const [camera, cameraInput] = fileButton(`${say("film-camera")} …`, {
		testid: "block-film-camera",
		label: say("file", { title: say("film-camera") }),
		accept: ".json,application/json"
	}, ([file]) => {
		if (file !== void 0) taken.takeCamera(file);
	});
	const [marks, marksInput] = fileButton(`${say("marks-of-scans")} …`, {
		testid: "block-film-marks",
		label: say("file", { title: say("marks-of-scans") }),
		multiple: true,
		accept: ".csv,.txt,text/*"
	}, (given) => void taken.takeMarks(given));
	const measure = button(`${say("measure-marks")} …`, "block-film-measure", measureMarks, say("measure-marks-help"));
	const remove = button(say("remove"), "block-film-remove", () => taken.clear());
	remove.setAttribute("aria-label", say("remove-2", { title: say("scanned-film") }));
	const frames = button(say("make-frames"), "block-film-frames", () => void files.actions.frames());
	declareLack([measure], () => lackOfImages(store.state));
	declareLack([frames], () => {
		const { film } = store.state.placing;
		return film.camera === null || film.marks.length === 0 ? say("needs-marked-scans") : "";
	});
	const undo = button("", "block-film-undo", () => {
		stepBy(store, -1);
		passFocus(undo, [frames]);
	});
	const cameraName = h("p", {
		class: "note",
		testid: "block-film-camera-name"
	});
	const marksNames = h("p", {
		class: "note",
		testid: "block-film-marks-names"
	});
	const counted = h("p", {
		class: "note",
		testid: "block-film-counted"
	});
	const problem = h("p", {
		class: "field-problem",
		testid: "block-film-problem"
	});
	store.watch([
		"placing",
		"files",
		"running",
		"notice"
	], ([{ film, placed }, images]) => {
		const busy = isBusy(store.state);
		for (const press of [
			camera,
			marks,
			remove
		]) press.disabled = busy;
		measure.disabled = busy || possibleScans(images).length === 0;
		remove.hidden = film.camera === null && film.marks.length === 0 && !film.areScans;
		const count = countedScans(film, images);
		counted.hidden = count.scans === 0;
		fill(counted, say("marks-of-some-scans", count));
		const scans = framesOf(film, images);
		frames.disabled = busy || film.camera === null || scans.length === 0 || scans.some(({ id }) => placed.has(id));
		fill(cameraName, film.camera?.name ?? say("none-film-camera", { example: "{\"focal_mm\": 152.82, \"principal_point_mm\": [0.004, -0.012]}" }));
		const names = film.marks.slice(0, LISTED$1).map(({ name }) => name);
		const more = film.marks.length > LISTED$1 ? " …" : "";
		fill(marksNames, names.length === 0 ? say("none-marks-of-scans", {
			example: "1963_017.csv",
			image: "1963_017.tif"
		}) : names.join(", ") + more);
		const [lone] = marksOfNone(film, images);
		const lacksCamera = film.marks.length > 0 && film.camera === null ? say("marks-need-their-camera") : "";
		const text = lone !== void 0 ? say("marks-of-no-image", { name: lone }) : lacksCamera || marksFarOff(film.marks, images);
		if (problem.textContent !== text) problem.textContent = text;
	});
	store.watch([
		"history",
		"marks",
		"draft",
		"running",
		"notice"
	], ([, marks, draft]) => {
		const { edits, done } = timelineOf(store.state);
		const last = edits[done - 1];
		const step = last?.of === "marks" ? marks.edits[last.at] : void 0;
		const isLast = step !== void 0 && isFramesStep(step) && draft === null;
		undo.hidden = !isLast;
		set(undo, isLast ? say("undo-3", { undo: nameOfMarks(step) }) : "", isBusy(store.state));
	});
	return h("fieldset", { class: "group" }, h("legend", {}, say("scanned-film")), h("div", { class: "control" }, h("div", { class: "buttons" }, camera, marks, measure, remove), cameraName, marksNames, counted, problem, cameraInput, marksInput), h("div", { class: "control" }, h("div", { class: "buttons" }, frames, undo), h("p", { class: "help" }, say("make-frames-help"))));
}
// www/block/panel/placing-settings.ts
var ORTHOPHOTO = say("none-a-geotiff-in-a");
var HEIGHTS = say("none-the-ground-is-level");
function mountPlacingSettings(host, store, files, measureMarks) {
	const [orthophoto, orthophotoInput] = fileButton(say("orthophoto-2"), {
		testid: "block-orthophoto",
		label: say("file-orthophoto"),
		multiple: true,
		accept: "image/*,.tif,.tiff,.tfw,.jgw,.pgw,.wld,.prj,.asc,.txt"
	}, (given) => void files.takeGround(given));
	const [heights, heightsInput] = fileButton(say("heights"), {
		testid: "block-heights",
		label: say("file-heights"),
		multiple: true,
		accept: ".tif,.tiff,.asc,.txt,.tfw,.wld,.prj,image/tiff"
	}, (given) => void files.takeGround(given, true));
	declareLack([heights], () => lackOfOrthophoto(store.state));
	const remove = button(say("remove"), "block-orthophoto-remove", () => store.dispatch({
		type: "orthophoto",
		orthophoto: null
	}));
	remove.setAttribute("aria-label", say("remove-orthophoto"));
	const name = h("p", {
		class: "note",
		testid: "block-orthophoto-name"
	});
	const model = h("p", {
		class: "note",
		testid: "block-heights-name"
	});
	const [level, problem] = levelField(store, files);
	const given = h("fieldset", { class: "group" }, h("legend", {}, say("orthophoto")), h("div", { class: "control" }, h("div", { class: "buttons" }, orthophoto, remove), name, orthophotoInput), h("div", { class: "control" }, h("div", { class: "buttons" }, heights), model, heightsInput, level, problem), purposeField(store));
	store.watch([
		"placing",
		"running",
		"notice"
	], ([placing]) => {
		const busy = isBusy(store.state);
		orthophoto.disabled = busy;
		remove.hidden = placing.orthophoto === null;
		remove.disabled = busy;
		heights.disabled = busy || placing.orthophoto === null;
		fill(name, placing.orthophoto === null ? ORTHOPHOTO : orthophotoText(placing.orthophoto));
		const [from, to] = placing.orthophoto?.info.heights ?? [];
		const unit = unitText(unitOfOrthophoto(placing.orthophoto));
		fill(model, heightsText$1(placing, from, to, unit));
	});
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue === null) return;
		const sections = makeSections(catalogue.placingParameters, {
			change: (key, value) => {
				const { options } = store.state.placing;
				if (options !== null) store.dispatch({
					type: "placingOptions",
					options: withSetting({ placing: options }, key, value).placing
				});
			},
			defaults: () => ({ placing: catalogue.placing }),
			refused: (parameter) => store.dispatch({
				type: "refused",
				parameter
			})
		});
		fill(host, given, filmFields(store, files, measureMarks), ...sections.elements);
		store.watch((s) => [s.placing.options], ([options]) => {
			if (options !== null) sections.show({ placing: options });
		});
	});
	return {
		orthophoto: () => orthophotoInput.click(),
		heights: () => heightsInput.click()
	};
}
function heightsText$1({ heights, orthophoto }, from, to, unit) {
	if (heights.kind === "model") return say("from-to", {
		name: heights.model.name,
		from,
		to,
		unit
	});
	if (heights.by !== "block") return HEIGHTS;
	return `${HEIGHTS} ${say("level-of-block", { height: withUnit(fixed(heights.height, 1), unitOfOrthophoto(orthophoto)) })}`;
}
var PURPOSES = [
	["block", say("purpose-block")],
	["images", say("purpose-images")],
	["map", say("purpose-map")]
];
function purposeField(store) {
	const select = h("select", {
		id: "orthophoto-purpose",
		testid: "orthophoto-purpose"
	});
	fill(select, new Option("–", ""), ...PURPOSES.map(([purpose, text]) => new Option(text, purpose)));
	select.addEventListener("change", () => {
		const purpose = PURPOSES.find(([own]) => own === select.value)?.[0];
		if (purpose !== void 0) store.dispatch({
			type: "purpose",
			purpose
		});
	});
	store.watch([
		"placing",
		"files",
		"shown",
		"running",
		"notice"
	], ([{ orthophoto }]) => {
		select.disabled = orthophoto === null || isLookedAtAlone(orthophoto) || orthophoto.ofBlock !== null || isBusy(store.state);
		select.value = purposeOf(store.state) ?? "";
	});
	return h("div", { class: "control compact" }, h("label", { for: select.id }, say("what-is-done-with-it")), select);
}
function levelField(store, files) {
	const problem = problemLine("block-level");
	const unit = h("span", { class: "unit" });
	const input = numberInput("block-level", problem, () => {
		const { valueAsNumber: height } = input;
		const allowed = store.state.catalogue?.levelParameter;
		if (allowed?.kind !== "real") return;
		const isHeight = height >= allowed.min && height <= allowed.max;
		problem.textContent = isHeight ? "" : say("allowed-the-last-valid-value", {
			parameter: message("allowed", allowed),
			what: ""
		});
		if (isHeight) files.takeLevel(height);
	});
	store.watch((s) => [s.placing.heights, s.placing.orthophoto], ([heights, orthophoto]) => {
		input.disabled = orthophoto === null;
		if (document.activeElement !== input) input.value = heights.kind === "level" ? String(heights.height) : "";
		unit.textContent = ` ${unitText(unitOfOrthophoto(orthophoto))}`;
	});
	const label = h("label", { for: input.id }, say("level-ground-at"), unit);
	return [h("div", { class: "control compact" }, label, input), problem];
}
// www/block/state/placed-columns.ts
var VERDICTS = {
	placed: say("placed-2"),
	weak: say("with-doubt-2"),
	not_placed: say("not-placed-2")
};
function placedWord({ result }) {
	return result === null ? say("not-read-2") : VERDICTS[result.verdict.kind];
}
function placedColumns(rows, said, unit) {
	const of = (row) => rows[row]?.result?.placement ?? null;
	const axes = [
		"X",
		"Y",
		"Z"
	];
	const angles = [
		"ω",
		"φ",
		"κ"
	];
	const uses = (row, use) => {
		const placement = of(row);
		return placement === null ? null : usedSo(placement.links, use);
	};
	const text = (row, made) => {
		const shown = rows[row];
		return shown === void 0 ? "" : made(shown);
	};
	return [
		words("placed-image", say("image-2"), (i) => rows[i]?.file.name ?? "", say("file-name-press-a-row")),
		words("placed-verdict", say("verdict"), (i) => text(i, (row) => `${placedWord(row)}${row.isStale ? say("earlier-settings") : ""}`), say("what-the-place-of-the")),
		...axes.map((axis, k) => numbers(`placed-${axis.toLowerCase()}`, axis, unit, 2, (i) => of(i)?.pose.position[k], say("projection-centre-in-the-system", { axis }))),
		...axes.map((axis, k) => numbers(`placed-s${axis.toLowerCase()}`, `σ ${axis}`, unit, 2, (i) => of(i)?.position_errors_m?.[k], say("standard-error-of-2", { axis }))),
		...angles.map((angle, k) => numbers(`placed-angle${String(k)}`, angle, "°", 3, (i) => of(i)?.angles_deg[k], say("rotation", { angle }))),
		...angles.map((angle, k) => numbers(`placed-sangle${String(k)}`, `σ ${angle}`, "°", 3, (i) => of(i)?.angle_errors_deg?.[k], say("standard-error-of-3", { angle }))),
		numbers("placed-links", say("links-2"), "", 0, (i) => uses(i, "used"), say("points-of-the-image-and")),
		numbers("placed-rejected", say("rejected"), "", 0, (i) => uses(i, "rejected"), say("links-rejected-as-gross-errors")),
		numbers("placed-rmse", "RMSE", "px", 2, (i) => of(i)?.rmse_px, say("root-mean-square-length-of-the-residuals")),
		numbers("placed-checks", say("checks"), "", 0, (i) => of(i)?.checks?.number, say("links-that-took-no-part-and")),
		numbers("placed-check-rmse", say("check-rmse"), "px", 2, (i) => of(i)?.checks?.rmse_px, say("root-mean-square-length-of-the-residuals-of")),
		numbers("placed-check-ground", say("on-the-ground"), unit, 2, (i) => of(i)?.checks?.rmse_m, say("the-same-on-the-ground")),
		numbers("placed-gsd", "GSD", unit, 3, (i) => of(i)?.gsd_m, say("ground-sample-distance-the-side")),
		numbers("placed-above", say("above-ground"), unit, 1, (i) => of(i)?.above_ground_m, say("height-of-the-projection-centre")),
		words("placed-why", say("why"), (i) => text(i, said), say("the-verdict-in-a-sentence"))
	];
}
function linkColumns({ links: { at, places, residuals, uses, byHand } }, steps, done, unit) {
	return [
		numbers("link", say("link"), "", 0, (i) => i + 1, say("number-of-the-link-press")),
		words("link-use", say("use"), (i) => useWord({
			steps,
			done
		}, i, USES$1[uses[i] ?? 0] ?? "used", byHand[i] === 1), say("used-for-the-orientation-kept")),
		numbers("link-column", say("column"), "px", 2, (i) => at[2 * i], say("position-in-the-image-the")),
		numbers("link-row", say("row-2"), "px", 2, (i) => at[2 * i + 1], say("position-in-the-image")),
		numbers("link-x", "X", unit, 2, (i) => places[3 * i], say("place-on-the-orthophoto-2")),
		numbers("link-y", "Y", unit, 2, (i) => places[3 * i + 1], say("place-on-the-orthophoto-2")),
		numbers("link-z", "Z", unit, 2, (i) => places[3 * i + 2], say("height-of-the-ground-at")),
		numbers("link-dx", say("residual-x"), "px", 2, (i) => residuals[2 * i], say("observed-minus-computed-column")),
		numbers("link-dy", say("residual-y"), "px", 2, (i) => residuals[2 * i + 1], say("observed-minus-computed-row")),
		numbers("link-length", say("length"), "px", 2, (i) => Math.hypot(residuals[2 * i] ?? NaN, residuals[2 * i + 1] ?? NaN), say("length-of-the-residual"))
	];
}
// www/block/panel/placing-tables.ts
function placingTables(store) {
	return [{
		id: "block-placed",
		title: say("placed-images"),
		view: "orthophoto",
		make: (host) => placedTable(host, store)
	}, {
		id: "block-links",
		title: say("links-2"),
		view: "orthophoto",
		make: (host) => linksTable(host, store)
	}];
}
function placedTable(host, store) {
	let rows = [];
	let filter = {};
	const lookedAt = (row) => ({
		image: rows[row]?.file.id ?? null,
		link: null
	});
	const table = new Table(host, {
		testid: "block-placed",
		words: {
			table: say("placed-images"),
			region: say("table-placed-images")
		},
		file: "placed-images.csv",
		choose: (row) => store.dispatch({
			type: "choosePlaced",
			looked: lookedAt(row)
		}),
		point: (row) => store.dispatch({
			type: "pointPlaced",
			looked: lookedAt(row)
		}),
		isChosen: (row) => rows[row]?.file.id === store.state.placing.chosen.image,
		filter: (wanted) => {
			filter = wanted;
			draw();
		}
	});
	const columns = remember((shown, unit) => placedColumns(shown, (one) => verdictText(one, store.state), unit));
	const draw = whenInSight(host, () => {
		rows = placedFiles(store.state);
		table.show(rows.length, columns(rows, unitOfOrthophoto(store.state.placing.orthophoto)), void 0, filter);
		table.reveal(rows.findIndex(({ file }) => file.id === store.state.placing.chosen.image));
	});
	store.watch((s) => [
		s.placing.placed,
		s.files,
		s.placing.options,
		s.placing.heights,
		s.options.cameras,
		s.placing.chosen.image
	], () => draw());
	return { draw };
}
function linksTable(host, store) {
	let filter = {};
	const lookedAt = (row) => ({
		image: store.state.placing.chosen.image,
		link: row < 0 ? null : row
	});
	const table = new Table(host, {
		testid: "block-links",
		words: {
			table: say("links-of-the-chosen-image"),
			region: say("table-links-of-the-chosen")
		},
		file: "links.csv",
		choose: (row) => store.dispatch({
			type: "choosePlaced",
			looked: lookedAt(row)
		}),
		point: (row) => store.dispatch({
			type: "pointPlaced",
			looked: lookedAt(row)
		}),
		isChosen: (row) => row === store.state.placing.chosen.link,
		filter: (wanted) => {
			filter = wanted;
			draw();
		}
	});
	const columns = remember(linkColumns);
	const draw = whenInSight(host, () => {
		const placed = chosenPlaced(store.state);
		const placement = placed?.result?.placement ?? null;
		table.show(placement?.links.count ?? 0, placed === null || placement === null ? [] : columns(placement, placed.steps, placed.done, unitOfOrthophoto(store.state.placing.orthophoto)), void 0, filter);
		table.reveal(store.state.placing.chosen.link ?? -1);
	});
	store.watch((s) => [
		s.placing.placed,
		s.placing.chosen,
		s.files
	], () => draw());
	return { draw };
}
// www/block/state/normal.ts
var STEP = .001;
function normalQuantiles(count) {
	const quantiles = new Float64Array(count);
	const density = (x) => Math.exp(-.5 * x * x) / Math.sqrt(2 * Math.PI);
	let [x, below] = [-6.2, 0];
	for (let i = 0; i < Math.floor(count / 2); i++) {
		const wanted = (i + .5) / count;
		for (;;) {
			const next = x < 0 ? STEP / 6 * (density(x) + 4 * density(x + STEP / 2) + density(x + STEP)) : Infinity;
			if (below + next >= wanted) {
				quantiles[i] = x + STEP * (wanted - below) / next;
				break;
			}
			[x, below] = [x + STEP, below + next];
		}
		quantiles[count - 1 - i] = -(quantiles[i] ?? 0);
	}
	return quantiles;
}
// www/block/state/plots.ts
var PLOTS = [
	["images", say("residuals-by-image")],
	["residuals", say("residuals-of-observations")],
	["w", say("w-against-the-normal-distribution")],
	["detectable", say("minimal-detectable-biases-by-image")],
	["rays", say("tie-points-by-rays")],
	["sigma-plan", say("standard-errors-in-plan-along")],
	["sigma-height", say("standard-errors-in-height-along")],
	["gnss", say("gnss-positions")],
	["surveyed-plan", say("control-and-check-points-plan")],
	["surveyed-height", say("control-and-check-points-height")]
];
function plotOf(name, view, facts) {
	switch (name) {
		case "images": return byImage(view);
		case "rays": return byRays(view);
		case "sigma-plan":
		case "sigma-height": return alongBlock(view, name === "sigma-plan");
		case "surveyed-plan":
		case "surveyed-height": return surveyedPoints(view, name === "surveyed-plan");
		case "residuals":
		case "w":
		case "detectable": {
			const of = facts.observations();
			if (of === null) return null;
			return name === "residuals" ? residuals(view, of) : name === "w" ? sortedTests(view, of) : detectable(view, of);
		}
		case "gnss": {
			const ground = facts.ground();
			return ground === null ? null : positions(view, ground);
		}
	}
}
function ofImages({ images }, y, value) {
	const rows = Array.from(images.keys()).filter((image) => !Number.isNaN(value(image)));
	const names = rows.map((image) => images[image]?.name ?? "");
	return {
		x: {
			label: say("image-2"),
			unit: "",
			values: Float64Array.from(rows.keys()),
			names
		},
		y: {
			...y,
			values: Float64Array.from(rows, value)
		},
		bars: true,
		square: false,
		choice: (row) => rows[row] === void 0 ? null : {
			kind: "image",
			image: rows[row]
		},
		chosen: (choice) => {
			const chosen = new Set(imagesOf(choice));
			return (row) => chosen.has(rows[row] ?? -1);
		},
		together: (chosen) => choiceOfImages(chosen.flatMap((row) => rows[row] ?? []))
	};
}
var byImage = remember((view) => ofImages(view, {
	label: say("rmse-of-the-residuals"),
	unit: "px"
}, (image) => view.images[image]?.rmsePx ?? NaN));
var positions = remember((view, { gnss }) => ofImages(view, {
	label: say("gnss-minus-adjusted-position"),
	unit: "m"
}, (image) => {
	const { position } = view.images[image] ?? {};
	return position == null ? NaN : Math.hypot(...position.map((value, axis) => (gnss[3 * image + axis] ?? NaN) - value));
}));
function ofPoints(points, x, y, bars = false) {
	return {
		x,
		y,
		bars,
		square: false,
		choice: (row) => points[row] === void 0 ? null : {
			kind: "point",
			point: points[row]
		},
		chosen: (choice) => {
			const chosen = new Set(pointsOf(choice));
			return (row) => chosen.has(points[row] ?? -1);
		},
		together: (rows) => choiceOfPoints(rows.flatMap((row) => points[row] ?? []))
	};
}
var alongBlock = remember((view, plan) => {
	const { points } = view;
	const system = resultSystem(view);
	const coordinate = (point, axis) => points.positions[3 * point + axis] ?? NaN;
	const error = (point) => {
		const [x = NaN, y = NaN, z = NaN] = points.errors.subarray(3 * point, 3 * point + 3);
		return plan ? Math.hypot(x, y) : z;
	};
	const rows = Uint32Array.from({ length: points.taking }, (_, point) => point).filter((point) => !Number.isNaN(error(point)) && !Number.isNaN(coordinate(point, 0)));
	const span = [0, 1].map((axis) => {
		let [low, high] = [Infinity, -Infinity];
		for (const point of rows) [low, high] = [Math.min(low, coordinate(point, axis)), Math.max(high, coordinate(point, axis))];
		return high - low;
	});
	const axis = (span[1] ?? 0) > (span[0] ?? 0) ? 1 : 0;
	const coordinates = pointCoordinates(view);
	return {
		...ofPoints(rows, {
			label: headOf(system, axis === 0 ? "X" : "Y"),
			unit: unitOn(system, axis),
			values: Float64Array.from(rows, (point) => coordinates[3 * point + axis] ?? NaN)
		}, {
			label: plan ? say("standard-error-in-plan") : say("standard-error-in-height"),
			unit: unitOf(view),
			values: Float64Array.from(rows, error)
		}),
		about: [pointColumn(view, "point", (row) => rows[row], "")]
	};
});
var SURVEYED_KINDS = [
	{
		key: "check",
		label: say("check-point"),
		mark: "square"
	},
	{
		key: "left_out",
		label: say("control-point-left-out"),
		mark: "triangle"
	},
	{
		key: "adjusted",
		label: say("control-point-adjusted"),
		mark: "outline"
	}
];
var WITHIN_95 = 1.96;
var surveyedPoints = remember(({ surveyed }, plan) => {
	const used = surveyed.filter(({ isUsed }) => isUsed);
	const judged = used.map(judgedOf);
	const values = Float64Array.from(judged, (one) => plan ? planOf(one).length : one.difference[2] ?? NaN);
	const errors = Float64Array.from(judged, (one) => plan ? planOf(one).error : one.errors[2] ?? NaN);
	const ratio = (row) => (errors[row] ?? NaN) > 0 ? (values[row] ?? NaN) / (errors[row] ?? NaN) : NaN;
	const groupOf = (row) => used[row]?.role === "check" ? "check" : judged[row]?.isLeftOut === true ? "left_out" : "adjusted";
	const kinds = SURVEYED_KINDS.filter(({ key }) => used.some((_, row) => groupOf(row) === key));
	const kindText = (row) => kinds.find(({ key }) => key === groupOf(row))?.label ?? "";
	const role = (row) => say("role", { role: used[row]?.role ?? "check" });
	return {
		...ofPoints(Uint32Array.from(used, ({ point }) => point), {
			label: say("point"),
			unit: "",
			values: Float64Array.from(used.keys()),
			names: used.map(({ name }) => name)
		}, {
			label: plan ? say("adjusted-minus-surveyed-place") : say("adjusted-minus-surveyed-height"),
			unit: "m",
			values
		}),
		whiskers: {
			from: values.map((value, row) => Math.max(plan ? 0 : -Infinity, value - WITHIN_95 * (errors[row] ?? NaN))),
			to: values.map((value, row) => value + WITHIN_95 * (errors[row] ?? NaN))
		},
		groups: {
			kinds,
			of: (row) => kinds.findIndex(({ key }) => key === groupOf(row))
		},
		about: [words("use", say("use"), role, ""), words("kind", say("kind"), kindText, "")],
		more: [numbers("sigma", "σ", "m", 4, (row) => errors[row], ""), numbers("ratio", "Δ/σ", "", 2, ratio, "")],
		said: (row) => say("surveyed-value", {
			name: used[row]?.name ?? "",
			kind: kindText(row),
			difference: values[row] ?? NaN,
			error: errors[row] ?? NaN,
			ratio: ratio(row),
			known: Number.isNaN(ratio(row)) ? "no" : "yes"
		})
	};
});
var byRays = remember((view) => {
	const { taking, rays: all } = view.points;
	const tied = Uint32Array.from({ length: taking }, (_, point) => point).filter((point) => surveyedAt(view, point) === void 0);
	const counts = new Map();
	for (const point of tied) counts.set(all[point] ?? 0, (counts.get(all[point] ?? 0) ?? 0) + 1);
	const rays = [...counts.keys()].sort((a, b) => a - b);
	const withRays = (wanted) => choiceOfPoints(tied.filter((point) => wanted.has(all[point])));
	return {
		x: {
			label: say("rays-2"),
			unit: "",
			values: Float64Array.from(rays.keys()),
			names: rays.map(String)
		},
		y: {
			label: say("tie-points"),
			unit: "",
			values: Float64Array.from(rays, (number) => counts.get(number) ?? 0)
		},
		bars: true,
		square: false,
		choice: (row) => withRays(new Set([rays[row]])),
		chosen: (choice) => {
			const chosen = new Set([...pointsOf(choice)].map((point) => all[point]));
			return (row) => chosen.has(rays[row]);
		},
		together: (rows) => withRays(new Set(rows.map((row) => rays[row])))
	};
});
function ofObservations(view, of, row, x, y, drawn) {
	const pointAt = (value) => of.points[row(value)] ?? -1;
	const imageAt = (value) => of.images[row(value)] ?? -1;
	return {
		x,
		y,
		bars: false,
		about: [...x.names === void 0 ? [words("image", say("image-2"), (value) => view.images[imageAt(value)]?.name ?? "", "")] : [], pointColumn(view, "point", pointAt, "")],
		...drawn,
		choice: (value) => ({
			kind: "observation",
			point: pointAt(value),
			image: imageAt(value)
		}),
		chosen: (choice) => {
			if (choice?.kind === "observations") {
				const isOne = among(choice);
				return (value) => isOne(pointAt(value), imageAt(value));
			}
			const [points, images] = [new Set(pointsOf(choice)), new Set(imagesOf(choice))];
			return (value) => (points.size === 0 || points.has(pointAt(value))) && (images.size === 0 || images.has(imageAt(value))) && points.size + images.size > 0;
		},
		together: (chosen) => choiceOfPoints(new Set(chosen.map(pointAt)))
	};
}
function rowsWith(of, value) {
	return Uint32Array.from(of.points.keys()).filter((row) => !Number.isNaN(value(row)) && of.parts[row] === 0);
}
var residuals = remember((view, of) => {
	const rows = rowsWith(of, (row) => of.residuals[2 * row]);
	const axis = (label, offset) => ({
		label,
		unit: "px",
		values: Float64Array.from(rows, (row) => of.residuals[2 * row + offset] ?? NaN)
	});
	return ofObservations(view, of, (value) => rows[value] ?? -1, axis(say("residual-vx"), 0), axis(say("residual-vy"), 1), { square: true });
});
var sortedTests = remember((view, of) => {
	const places = Uint32Array.from(of.w.keys()).filter((place) => !Number.isNaN(of.w[place]) && of.parts[place >> 1] === 0);
	const values = Float64Array.from(places, (place) => of.w[place] ?? NaN);
	const sorted = values.slice().sort();
	const quantiles = normalQuantiles(sorted.length);
	const expected = values.map((value) => quantiles[firstAt(sorted, value)] ?? NaN);
	const data = ofObservations(view, of, (value) => (places[value] ?? -2) >> 1, {
		label: say("w-of-normal-errors"),
		unit: "",
		values: expected
	}, {
		label: say("w-statistic"),
		unit: "",
		values
	}, {
		square: false,
		equal: true
	});
	const axis = words("coordinate", say("image-coordinate"), (value) => (places[value] ?? 0) % 2 === 0 ? "x" : "y", "");
	return {
		...data,
		about: [...data.about ?? [], axis]
	};
});
function firstAt(sorted, value) {
	let [low, high] = [0, sorted.length];
	while (low < high) {
		const middle = low + high >> 1;
		if ((sorted[middle] ?? Infinity) < value) low = middle + 1;
		else high = middle;
	}
	return low;
}
var BESIDE$1 = .8;
var detectable = remember((view, of) => {
	const { images } = view;
	const larger = (row) => {
		const largest = Math.max(of.detectable[2 * row] ?? NaN, of.detectable[2 * row + 1] ?? NaN);
		return Number.isNaN(largest) ? Infinity : largest;
	};
	const rows = rowsWith(of, (row) => of.redundancy[2 * row]);
	const across = (row) => {
		const image = of.images[row] ?? -1;
		return image + BESIDE$1 * ((of.places[2 * row] ?? NaN) / (images[image]?.width ?? NaN) - .5);
	};
	return ofObservations(view, of, (value) => rows[value] ?? -1, {
		label: say("image-2"),
		unit: "",
		values: Float64Array.from(rows, across),
		names: images.map(({ name }) => name)
	}, {
		label: say("minimal-detectable-bias"),
		unit: "px",
		values: Float64Array.from(rows, larger),
		logarithmic: true
	}, { square: false });
});
// www/block/state/plot-words.ts
function withinSentence(label) {
	return label.replace(/^\p{Lu}(?=\p{Ll})/u, (first) => first.toLowerCase());
}
function plotText({ x, y }, isOriented = false) {
	const sorted = y.values.filter(Number.isFinite).sort();
	const unchecked = y.values.length - sorted.length;
	const more = unchecked === 0 ? "" : say("unchecked-at-the-top", { unchecked });
	if (sorted.length === 0) return unchecked === 0 ? say(isOriented ? "this-block-has-none" : "there-are-no-such-values") : more;
	const areCounts = y.unit === "" && sorted.every(Number.isInteger);
	const written = (value) => areCounts ? count(value) : fixed(value, 3);
	const at = (share) => written(sorted[Math.round(share * (sorted.length - 1))] ?? NaN);
	const text = say("values-over-median-from-to", {
		sorted: sorted.length,
		to_lower_case: withinSentence(x.label),
		label: y.label,
		at: at(.5),
		at_2: at(0),
		at_3: at(1),
		what: y.unit === "" ? "" : say("n--2", { unit: unitText(y.unit) })
	});
	return more === "" ? text : `${text} ${more}`;
}
// www/block/view/plot/axes.ts
var ROOM = {
	left: 64,
	right: 16,
	top: 14,
	bottom: 40
};
var UPRIGHT = {
	most: 96,
	apart: 13
};
var BETWEEN = 8;
var LEGEND = {
	line: 16,
	mark: 16,
	between: 14
};
function laidOut({ x, groups, whiskers }, width, measure) {
	const across = Math.max(1, width - ROOM.left - ROOM.right);
	const widest = (x.names ?? []).reduce((most, name) => Math.max(most, measure(name)), 0);
	const upright = x.names !== void 0 && widest + BETWEEN > across / Math.max(1, x.names.length);
	const texts = groups === void 0 ? [] : [...groups.kinds.map(({ label }) => label), ...whiskers === void 0 ? [] : [say("whiskers-of-95")]];
	let [at, line] = [0, 0];
	const legend = texts.map((text, group) => {
		const wide = LEGEND.mark + measure(text);
		if (at > 0 && at + wide > across) [at, line] = [0, line + 1];
		const entry = {
			text,
			group,
			x: ROOM.left + at,
			line
		};
		at += wide + LEGEND.between;
		return entry;
	});
	const lines = legend.length === 0 ? 0 : line + 1;
	return {
		room: {
			...ROOM,
			top: ROOM.top + LEGEND.line * lines,
			bottom: ROOM.bottom + (upright ? Math.min(UPRIGHT.most, widest) - 10 : 0)
		},
		upright,
		legend
	};
}
function namesWritten([from, to], names, apart) {
	const needed = Math.ceil(UPRIGHT.apart / Math.max(1e-9, apart));
	const step = needed % 2 === 0 ? needed + 1 : needed;
	return Array.from(names.keys()).filter((at) => at % step === 0 && at >= from && at <= to);
}
var UPRIGHT_MOST = UPRIGHT.most;
var BESIDE = .04;
function endsOf({ x, y, bars, square, groups, whiskers }, width, height) {
	const across = x.names === void 0 ? spread(x.values) : [-.5, Math.max(0, x.names.length - 1) + .5];
	const values = whiskers === void 0 ? y.values : Float64Array.from([
		...y.values,
		...whiskers.from,
		...whiskers.to
	]);
	const up = spread(y.logarithmic === true ? values.map(Math.log10) : values, bars || groups !== void 0);
	if (!square) return {
		x: across,
		y: up
	};
	const most = Math.max(...across.map(Math.abs), ...up.map(Math.abs));
	const [wide, high] = [Math.max(1, width - ROOM.left - ROOM.right), Math.max(1, height - ROOM.top - ROOM.bottom)];
	const least = Math.min(wide, high);
	return {
		x: [-most * wide / least, most * wide / least],
		y: [-most * high / least, most * high / least]
	};
}
function spread(values, zero = false) {
	let [low, high] = zero ? [0, 0] : [Infinity, -Infinity];
	for (const value of values) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
	if (!(high > low)) return Number.isFinite(low) && low !== 0 ? [low - Math.abs(low) / 2, low + Math.abs(low) / 2] : [0, 1];
	const beside = BESIDE * (high - low);
	return [zero && low === 0 ? 0 : low - beside, zero && high === 0 ? 0 : high + beside];
}
function ticksBetween([from, to], about) {
	const step = roundStep((to - from) / Math.max(1, about));
	if (!(step > 0) || !Number.isFinite(step)) return [];
	const first = Math.ceil(from / step - 1e-9);
	const last = Math.floor(to / step + 1e-9);
	return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}
var FEW_POWERS = .7;
function ticksOfPowers([from, to], about) {
	if (to - from < FEW_POWERS) return ticksBetween([10 ** from, 10 ** to], about);
	const digits = (to - from) * 3 <= about ? [
		1,
		2,
		5
	] : [1];
	return Array.from({ length: Math.max(0, Math.floor(to) - Math.floor(from) + 1) }, (_, i) => Math.floor(from) + i).flatMap((power) => digits.map((digit) => Number((digit * 10 ** power).toPrecision(12)))).filter((tick) => Math.log10(tick) >= from && Math.log10(tick) <= to);
}
function roundStep(length) {
	const power = 10 ** Math.floor(Math.log10(length));
	return ([
		1,
		2,
		5,
		10
	].find((digit) => digit * power >= length * (1 - 1e-9)) ?? 10) * power;
}
function decimalsOf(ticks) {
	const [first = 0, second = first + 1] = ticks;
	return Math.max(0, Math.min(9, Math.ceil(-Math.log10(Math.abs(second - first)) - 1e-9)));
}
function titleOf({ label, unit }) {
	return unit === "" ? asSentence(label) : asSentence(say("axis-title", {
		label,
		unit: unitText(unit)
	}));
}
var EDGE = 4;
function titleWithin(length, axis, side) {
	const most = Math.max(1, side - 8);
	const half = Math.min(length, most) / 2;
	return {
		middle: Math.min(Math.max(axis, EDGE + half), side - EDGE - half),
		most
	};
}
// www/block/view/plot/plot.ts
var REACH = 9;
var APART = {
	x: 90,
	y: 46
};
var LEAST_TICKS = 3;
var FEW = 3e3;
var FONT = "11px system-ui, sans-serif";
var INSIDE = 4;
var MARK = 4;
var CAP = 3;
var Plot = class extends Chart {
	facts;
	name = "images";
	outline = null;
	listeners = [];
	constructor(host, store, looking, facts) {
		super(host, "plot", store, looking);
		this.facts = facts;
		facts.watch(() => this.changed());
		store.watch(["shown", "onStage"], () => this.changed());
	}
	watch(changed) {
		this.listeners.push(changed);
	}
	get shows() {
		return this.name;
	}
	show(name) {
		this.name = name;
		this.fit();
		this.changed();
	}
	data() {
		const view = this.view();
		return view === null || this.store.state.onStage !== "plots" ? null : plotOf(this.name, view, this.facts);
	}
	picture() {
		return this.layers.snapshot();
	}
	changed() {
		this.layers.redraw();
		for (const listener of this.listeners) listener();
	}
	enclosed = (_, drawn, ended) => {
		this.outline = ended || drawn.to === null ? null : drawn;
		const data = this.data();
		const view = this.view();
		if (ended && drawn.to !== null && data !== null && view !== null) {
			const [[x0, y0], [x1, y1]] = [drawn.from, drawn.to];
			const [left, right, top, bottom] = [
				Math.min(x0, x1),
				Math.max(x0, x1),
				Math.min(y0, y1),
				Math.max(y0, y1)
			];
			const place = this.placing(data, this.current(view));
			const rows = [];
			for (let row = 0; row < data.x.values.length; row++) {
				const [x, y] = place(row);
				const meets = data.bars ? y <= bottom && this.base(data, this.current(view)) >= top : y >= top && y <= bottom;
				if (x >= left && x <= right && meets) rows.push(row);
			}
			this.looking.choose(data.together(rows));
		}
		this.layers.redraw();
	};
	whole() {
		return {
			scale: 1,
			x: 0,
			y: 0
		};
	}
	limits() {
		return {
			least: 1,
			most: 500
		};
	}
	held(_, { scale, x, y }) {
		const { width, height } = this.layers;
		return {
			scale,
			x: Math.min(0, Math.max((1 - scale) * width, x)),
			y: Math.min(0, Math.max((1 - scale) * height, y))
		};
	}
	hit(_, t, x, y) {
		const data = this.data();
		const row = data === null ? -1 : this.nearest(data, t, x, y);
		return data === null || row < 0 ? null : data.choice(row);
	}
	command() {
		return false;
	}
	laid(data) {
		return laidWithin(data, this.layers.width);
	}
	area(data) {
		const { width, height } = this.layers;
		const { left, right, top, bottom } = this.laid(data).room;
		return {
			left,
			top,
			width: Math.max(1, width - left - right),
			height: Math.max(1, height - top - bottom)
		};
	}
	placing(data, t) {
		const at = this.scaling(data, t);
		return (row) => at(data.x.values[row] ?? NaN, data.y.values[row] ?? NaN);
	}
	scaling(data, t) {
		const { left, top, width, height } = this.area(data);
		const ends = endsOf(data, this.layers.width, this.layers.height);
		const [x0, across] = [ends.x[0], width / (ends.x[1] - ends.x[0])];
		const [y0, up] = [ends.y[0], height / (ends.y[1] - ends.y[0])];
		const upwards = data.y.logarithmic === true ? Math.log10 : (y) => y;
		const upper = (y) => y === Infinity ? top + INSIDE : top + height - (upwards(y) - y0) * up;
		return (x, y) => toCanvas(t, left + (x - x0) * across, upper(y));
	}
	seen(data, t) {
		const { left, top, width, height } = this.area(data);
		const ends = endsOf(data, this.layers.width, this.layers.height);
		const value = (x, y) => {
			const [u, v] = toPosition(t, x, y);
			return [ends.x[0] + (u - left) / width * (ends.x[1] - ends.x[0]), ends.y[0] + (top + height - v) / height * (ends.y[1] - ends.y[0])];
		};
		const [from, to] = [value(left, top + height), value(left + width, top)];
		return {
			x: [from[0], to[0]],
			y: [from[1], to[1]]
		};
	}
	base(data, t) {
		return this.scaling(data, t)(0, 0)[1];
	}
	barWidth(data, t) {
		const [[x0], [x1]] = [this.scaling(data, t)(0, 0), this.scaling(data, t)(1, 0)];
		return Math.max(1, .75 * (x1 - x0));
	}
	nearest(data, t, x, y) {
		const place = this.placing(data, t);
		const alone = data.bars || data.groups !== void 0;
		let [found, least] = [-1, alone ? this.barWidth(data, t) / 2 + 2 : REACH];
		for (let row = 0; row < data.x.values.length; row++) {
			const [px, py] = place(row);
			const distance = alone ? Math.abs(px - x) : Math.hypot(px - x, py - y);
			if (distance <= least) [found, least] = [row, distance];
		}
		return found;
	}
	paint(context, colours, _, t) {
		const data = this.data();
		context.font = FONT;
		if (data === null || data.x.values.length === 0) return;
		const area = this.area(data);
		this.paintAxes(context, colours, data, t, area);
		this.paintLegend(context, colours, data);
		within(context, area, () => this.paintValues(context, colours, data, t, area));
		if (this.outline?.to != null) {
			const [[x0, y0], [x1, y1]] = [this.outline.from, this.outline.to];
			context.strokeStyle = colours.accent;
			context.setLineDash([5, 3]);
			context.strokeRect(x0, y0, x1 - x0, y1 - y0);
			context.setLineDash([]);
		}
	}
	paintAxes(context, colours, data, t, { left, top, width, height }) {
		const at = this.scaling(data, t);
		const seen = this.seen(data, t);
		const { names } = data.x;
		const { upright } = this.laid(data);
		const across = names === void 0 ? ticksBetween(seen.x, width / APART.x) : namesWritten(seen.x, names, at(1, 0)[0] - at(0, 0)[0]);
		const isLogarithmic = data.y.logarithmic === true;
		const most = Math.max(LEAST_TICKS, height / APART.y);
		const up = isLogarithmic ? ticksOfPowers(seen.y, most) : ticksBetween(seen.y, most);
		const digitsX = decimalsOf(across);
		const digitsOf = (tick) => isLogarithmic ? String(tick).split(".")[1]?.length ?? 0 : decimalsOf(up);
		context.strokeStyle = colours.line;
		context.fillStyle = colours.muted;
		context.lineWidth = 1;
		context.textBaseline = "middle";
		for (const tick of up) {
			const [, y] = at(0, tick);
			line(context, [left, y], [left + width, y]);
			context.textAlign = "end";
			context.fillText(fixed(tick, digitsOf(tick)), left - 6, y);
		}
		for (const tick of across) {
			const [x] = at(tick, 0);
			if (names === void 0) line(context, [x, top], [x, top + height]);
			if (upright) upwards(context, shortened(context, names?.[tick] ?? "", UPRIGHT_MOST), x, top + height + 6);
			else {
				context.textAlign = "center";
				context.fillText(names?.[tick] ?? fixed(tick, digitsX), x, top + height + 10);
			}
		}
		context.strokeStyle = colours.muted;
		if (data.groups !== void 0) within(context, {
			left,
			top,
			width,
			height
		}, () => line(context, [left, at(0, 0)[1]], [left + width, at(0, 0)[1]]));
		context.strokeRect(left, top, width, height);
		context.fillStyle = colours.text;
		context.textAlign = "center";
		const [titleX, titleY] = [titleOf(data.x), titleOf(data.y)];
		const x = titleWithin(context.measureText(titleX).width, left + width / 2, this.layers.width);
		context.fillText(titleX, x.middle, this.layers.height - ROOM.bottom + 28, x.most);
		const y = titleWithin(context.measureText(titleY).width, top + height / 2, this.layers.height);
		context.save();
		context.translate(12, y.middle);
		context.rotate(-Math.PI / 2);
		context.fillText(titleY, 0, 0, y.most);
		context.restore();
	}
	paintLegend(context, colours, data) {
		const { groups } = data;
		if (groups === void 0) return;
		for (const { text, group, x, line: below } of this.laid(data).legend) {
			const [middle, y] = [x + 5, ROOM.top / 2 + 4 + below * LEGEND.line];
			const mark = groups.kinds[group]?.mark;
			if (mark === void 0) paintWhisker(context, colours.text, middle, y - 6, y + 6);
			else paintMark(context, mark, colourOf(mark, colours), colours.surface, middle, y, MARK);
			context.fillStyle = colours.text;
			context.textAlign = "left";
			context.textBaseline = "middle";
			context.fillText(asSentence(text), x + LEGEND.mark, y);
		}
	}
	paintValues(context, colours, data, t, area) {
		const { chosen, pointed } = this.store.state.selection;
		const place = this.placing(data, t);
		const rows = data.x.values.length;
		const [isChosen, isPointed] = [data.chosen(chosen), data.chosen(pointed)];
		const width = this.barWidth(data, t);
		const base = data.bars ? this.base(data, t) : 0;
		const half = rows <= FEW ? 2.5 : 1.5;
		const { groups, whiskers } = data;
		const at = this.scaling(data, t);
		const draw = (row, larger, colour) => {
			const [x, y] = place(row);
			if (groups !== void 0) {
				const mark = groups.kinds[groups.of(row)]?.mark ?? "square";
				const own = colour ?? colourOf(mark, colours);
				const [from, to] = [whiskers?.from[row] ?? NaN, whiskers?.to[row] ?? NaN];
				if (!Number.isNaN(from)) paintWhisker(context, own, x, at(0, from)[1], at(0, to)[1]);
				paintMark(context, mark, own, colours.surface, x, y, MARK + larger);
			} else if (data.bars) context.fillRect(x - width / 2, Math.min(y, base), width, Math.max(1, Math.abs(base - y)));
			else if (x > area.left - 4 && y > area.top - 4 && x < area.left + area.width + 4 && y < area.top + area.height + 4) context.fillRect(x - half - larger, y - half - larger, 2 * (half + larger), 2 * (half + larger));
		};
		if (data.equal === true) this.paintEqual(context, colours, data, t);
		context.fillStyle = colours.bars;
		for (let row = 0; row < rows; row++) draw(row, 0);
		context.fillStyle = colours.problem;
		let under = -1;
		for (let row = 0; row < rows; row++) {
			if (chosen !== null && isChosen(row)) draw(row, 1, colours.problem);
			if (under < 0 && pointed !== null && isPointed(row)) under = row;
		}
		context.strokeStyle = colours.problem;
		context.lineWidth = 2;
		const [ux, uy] = place(under);
		if (under >= 0 && data.bars) context.strokeRect(ux - width / 2, Math.min(uy, base), width, Math.abs(base - uy));
		else if (under >= 0) context.strokeRect(ux - 5, uy - 5, 10, 10);
		if (under >= 0) this.paintValue(context, colours, data, under, place(under), area);
	}
	paintEqual(context, colours, data, t) {
		const at = this.scaling(data, t);
		const [from, to] = endsOf(data, this.layers.width, this.layers.height).x;
		context.strokeStyle = colours.text;
		context.lineWidth = 1;
		line(context, at(from, from), at(to, to));
	}
	paintValue(context, colours, { x, y, said }, row, [px, py], area) {
		const value = ({ unit, values, names }) => {
			const name = names?.[Math.round(values[row] ?? NaN)];
			return name === void 0 ? withUnit(figure(values[row] ?? NaN), unit) : asFigure(name);
		};
		const text = asSentence(said === void 0 ? `${value(x)}: ${value(y)}` : said(row));
		const wide = context.measureText(text).width + 12;
		const left = Math.max(Math.min(area.left, this.layers.width - wide), 0, Math.min(px + 8, area.left + area.width - wide));
		const top = Math.max(area.top, Math.min(py - 24, area.top + area.height - 20));
		context.fillStyle = colours.surface;
		context.fillRect(left, top, wide, 18);
		context.strokeStyle = colours.line;
		context.lineWidth = 1;
		context.strokeRect(left, top, wide, 18);
		context.fillStyle = colours.text;
		context.textAlign = "start";
		context.textBaseline = "middle";
		context.fillText(text, left + 6, top + 9);
	}
};
function colourOf(mark, colours) {
	return mark === "square" ? colours.text : colours.accent;
}
function paintMark(context, mark, colour, ground, x, y, half) {
	context.beginPath();
	if (mark === "square") context.rect(x - half, y - half, 2 * half, 2 * half);
	else {
		context.moveTo(x, y - half - 1);
		context.lineTo(x + half + 1, y + half);
		context.lineTo(x - half - 1, y + half);
		context.closePath();
	}
	context.fillStyle = mark === "outline" ? ground : colour;
	context.fill();
	context.strokeStyle = colour;
	context.lineWidth = 1;
	context.stroke();
}
function paintWhisker(context, colour, x, from, to) {
	context.strokeStyle = colour;
	context.lineWidth = 1;
	line(context, [x, from], [x, to]);
	for (const end of [from, to]) line(context, [x - CAP, end], [x + CAP, end]);
}
function upwards(context, text, x, y) {
	context.save();
	context.translate(x, y);
	context.rotate(-Math.PI / 2);
	context.textAlign = "right";
	context.fillText(text, 0, 0);
	context.restore();
}
var ruler = null;
function measured(text) {
	ruler ??= document.createElement("canvas").getContext("2d");
	if (ruler === null) return 0;
	ruler.font = FONT;
	return ruler.measureText(text).width;
}
var laidWithin = remember((data, width) => laidOut(data, width, measured));
function line(context, from, to) {
	context.beginPath();
	context.moveTo(...from);
	context.lineTo(...to);
	context.stroke();
}
function figure(value) {
	if (Number.isInteger(value)) return fixed(value, 0);
	return fixed(value, Math.min(7, Math.max(3, 2 - Math.floor(Math.log10(Math.abs(value))))));
}
function shortened(context, text, most) {
	if (context.measureText(text).width <= most) return text;
	let from = 1;
	while (from < text.length - 1 && context.measureText(`…${text.slice(from)}`).width > most) from += 1;
	return `…${text.slice(from)}`;
}
// www/block/panel/plots-view.ts
var KEYS = say("press-a-value-to-choose");
function plotsView(facts) {
	return {
		name: "plots",
		title: say("plots"),
		mount: (store, looking) => {
			const words = h("span", {
				class: "note",
				id: "block-plot-words",
				testid: "block-plot-words",
				role: "status",
				aria: { live: "polite" }
			});
			const element = h("div", {
				class: "view block-plot",
				testid: "block-plot",
				tabindex: 0,
				role: "group",
				aria: {
					roledescription: say("role-plot"),
					label: say("plot-of-the-block"),
					describedby: `${words.id} ${KEYS_ID}`
				}
			});
			const plot = new Plot(element, store, looking, facts);
			const [chosen, select] = choice(say("plot"), "plot-name", PLOTS, (name) => plot.show(name));
			select.value = plot.shows;
			const saved = (name) => {
				if (store.state.notice?.kind !== "busy") store.dispatch({
					type: "notice",
					notice: {
						kind: "info",
						text: say("was-saved", { name }),
						beside: true
					}
				});
			};
			const picture = button("PNG", "plot-png", () => void savePicture(plot, saved), say("saves-the-plot-as-it"));
			const values = button("CSV", "plot-csv", () => saveValues(plot, saved), say("saves-the-values-of-the"));
			declareLack([picture, values], () => picture.disabled ? say("no-plot-is-shown") : "");
			const show = () => {
				const data = plot.data();
				const text = data === null ? "" : plotText(data, (store.state.shown?.view.oriented ?? 0) > 0);
				if (words.textContent !== text) words.textContent = text;
				picture.disabled = values.disabled = data === null || data.x.values.length === 0;
			};
			plot.watch(show);
			show();
			return {
				element,
				tools: [
					chosen,
					picture,
					values
				],
				legend: words,
				zoomable: plot,
				keys: KEYS
			};
		}
	};
}
async function savePicture(plot, saved) {
	const picture = plot.picture();
	const blob = await new Promise((resolve) => {
		picture.toBlob(resolve);
	});
	if (blob === null) return;
	const name = `block-${plot.shows}.png`;
	save(blob, name);
	saved(name);
}
function saveValues(plot, saved) {
	const data = plot.data();
	if (data === null) return;
	const column = ({ label, unit, values, names }) => ({
		key: label,
		label,
		unit,
		help: "",
		value: (row) => values[row] ?? NaN,
		text: (row) => names?.[Math.round(values[row] ?? NaN)] ?? String(values[row] ?? ""),
		...names === void 0 ? {} : { words: true }
	});
	const name = `block-${plot.shows}.csv`;
	saveCsv([
		...data.about ?? [],
		column(data.x),
		column(data.y),
		...data.more ?? []
	], data.x.values.keys(), name);
	saved(name);
}
// www/block/panel/components.ts
function componentTable(components) {
	const names = [
		say("observations"),
		say("by-residuals-stated"),
		say("interval-of-95"),
		say("weights-by")
	];
	const head = h("thead", {}, h("tr", {}, ...names.map((text) => h("th", { scope: "col" }, text))));
	const number = (text) => h("td", { class: "number" }, text);
	const rows = components.map((one) => row(message("observation_group", { kind: one.group }), number(one.held ? "–" : fixed(one.factor, 2)), number(one.interval == null ? "–" : one.interval.map((limit) => fixed(limit, 2)).join(" – ")), weightsOf(one)));
	return [h("div", { class: "scroll" }, h("table", {
		class: "tight",
		testid: "components"
	}, head, h("tbody", {}, ...rows))), h("p", { class: "note" }, say("components-explained"))];
}
function weightsOf({ applied, held }) {
	if (applied) return say("weights-by-residuals");
	return held ? say("weights-by-stated-held") : say("weights-by-stated");
}
// www/block/panel/placing-answer.ts
function placingRuns({ done, total, text }) {
	return {
		kind: "busy",
		verdict: null,
		text: `${text}${total > 1 ? say("of", {
			total: Math.min(total, done + 1),
			total_2: total
		}) : ""} …`
	};
}
function placingAnswer(state, actions) {
	const { placing, files } = state;
	const { orthophoto } = placing;
	const idle = (text, next, more = "") => ({
		kind: "idle",
		verdict: null,
		text,
		more,
		next
	});
	if (orthophoto === null) return idle(say("open-an-orthophoto-photographs-are"), null);
	const tried = placedFiles(state);
	if (tried.length > 0) return answered$1(state, tried, actions);
	const what = orthophotoText(orthophoto);
	if (files.length === 0) return idle(what, {
		text: say("open-photos"),
		act: actions.open
	}, heightsText(state));
	const text = say("can-be-placed", {
		files: images(files.length),
		what
	});
	const each = {
		text: say(files.length < 2 ? "place-on-the-orthophoto" : "place-each-image"),
		act: actions.place
	};
	if (files.length < 2) return idle(text, each, heightsText(state));
	const block = {
		text: say("place-them-as-a-block"),
		act: actions.asBlock
	};
	const [next, other] = purposeOf(state) === "block" ? [block, each] : [each, block];
	return {
		...idle(text, next, heightsText(state)),
		others: [other]
	};
}
var MOSTLY = .95;
function heightsText({ placing: { heights, orthophoto } }) {
	const unit = unitText(unitOfOrthophoto(orthophoto));
	if (heights.kind === "level") return say("its-ground-is-taken-as", {
		height: heights.height,
		unit
	});
	const [from, to] = orthophoto?.info.heights ?? [];
	const share = orthophoto?.info.heights_share ?? 1;
	const part = share < MOSTLY ? say("they-lie-under-of-the", { share: Math.round(100 * share) }) : "";
	const from_what = orthophoto?.info.heights_from ?? null;
	const given_in = orthophoto?.info.heights_given_in ?? null;
	return say("heights-of-to", {
		name: heights.model.name,
		from,
		to,
		unit,
		given_in,
		from_what,
		part
	});
}
function answered$1(state, tried, actions) {
	const of = (kind) => tried.filter(({ result }) => result?.verdict.kind === kind).length;
	const [placed, weak] = [of("placed"), of("weak")];
	const without = tried.length - placed - weak;
	const waiting = unplacedFiles(state).length;
	const stale = tried.filter(({ isStale }) => isStale).length;
	const [first] = tried;
	const text = tried.length === 1 && waiting <= stale && first !== void 0 ? verdictText(first, state) : say("of-placed", {
		placed: placed + weak,
		tried: images(tried.length + Math.max(0, waiting - stale)),
		what: weak > 0 ? say("with-doubt", {
			weak,
			of: placed > 0 ? "some" : weak > 1 ? "all" : "one"
		}) : "",
		what_2: without > 0 ? say("not-placed", { without }) : ""
	});
	const more = [
		tried.length > 1 ? reasonOf(tried, state) : "",
		stale > 0 ? say("settings-heights-or-cameras-have", { what: stale === tried.length ? say("then") : say("placed", {
			stale: images(stale),
			stale_2: stale
		}) }) : "",
		waiting > stale ? say("not-tried-yet-press-place", { waiting: images(waiting - stale) }) : "",
		state.placing.heights.kind === "level" ? heightsText(state) : ""
	];
	const isSound = without === 0 && weak === 0;
	const needsHeights = !isSound && state.placing.heights.kind === "level";
	const save = {
		text: say("save-positions-csv"),
		act: actions.save
	};
	const why = needsHeights ? {
		text: say("open-heights"),
		act: actions.openHeights
	} : {
		text: say("show-why"),
		act: actions.why
	};
	const next = waiting > 0 ? {
		text: say("place-them"),
		act: actions.place
	} : isSound ? save : why;
	return {
		kind: isSound ? "done" : placed + weak > 0 ? "partial" : "problem",
		verdict: isSound ? "oriented" : placed + weak > 0 ? "weak" : "not_oriented",
		text,
		more: more.filter((part) => part !== "").join(" "),
		figures: figuresOf$1(tried, unitOfOrthophoto(state.placing.orthophoto)),
		next
	};
}
function reasonOf(tried, state) {
	const first = tried.find(({ result }) => result?.verdict.kind !== "placed");
	return first === void 0 ? "" : say("reason-of", {
		name: first.file.name,
		reason: verdictText(first, state)
	});
}
function figuresOf$1(tried, unit) {
	const placements = tried.flatMap(({ result }) => result?.placement ?? []);
	const links = placements.reduce((sum, placement) => sum + usedSo(placement.links, "used"), 0);
	const checks = placements.flatMap(({ checks: own }) => own ?? []);
	const number = checks.reduce((sum, own) => sum + own.number, 0);
	const widths = tried.flatMap(({ result }) => result?.verdict.kind === "placed" ? [result.verdict.half_width_m] : []);
	const rmse = Math.sqrt(checks.reduce((sum, own) => sum + own.number * own.rmse_m ** 2, 0) / number);
	return [
		{
			value: say("of-2", {
				placements: placements.length,
				tried: tried.length
			}),
			label: say("images-placed")
		},
		...placements.length > 0 ? [{
			value: count(links),
			label: say("links-3")
		}] : [],
		...widths.length > 0 ? [{
			value: say("within", { length: gsdText$1(Number(Math.max(...widths).toPrecision(2)), unit) }),
			label: say("projection-centres-95")
		}] : [],
		...number > 0 ? [{
			value: gsdText$1(Number(rmse.toFixed(3)), unit),
			label: say("rmse-of-check-links-on")
		}] : []
	];
}
function images(number) {
	return say("so-many-images", { images: number });
}
// www/block/panel/results.ts
var LISTED = 50;
function mountResults(host, store, takeOff) {
	const body = h("div", { testid: "block-results" });
	host.append(body);
	const off = button(say("without-the-orthophoto"), "block-off-ground", takeOff, say("the-block-as-it-was"));
	const out = button(say("take-these-out"), "block-remove-left-out", () => {
		const step = outOf(store.state);
		if (step !== null) store.dispatch({
			type: "mark",
			step
		});
	});
	store.watch([
		"shown",
		"files",
		"options",
		"placing",
		"skipped"
	], ([shown, , , , skipped]) => {
		out.hidden = outOf(store.state) === null;
		body.classList.toggle("is-stale", isStale(store.state));
		const placed = placedOf(store.state);
		const none = placed === null ? h("p", { class: "note" }, say("no-block-yet-drop-images")) : null;
		fill(body, ...shown === null ? [none] : sectionsOf(shown, off, out, (text) => readable(store.state.catalogue?.labels ?? null, text)), placed, shown === null ? null : strays(say("other-files-skipped"), "block-other-files", skipped, say("no-images-by-their-names")));
	});
	store.watch([
		"running",
		"notice",
		"placing"
	], () => {
		off.disabled = isBusy(store.state);
		out.disabled = isBusy(store.state);
	});
}
var REASONS = [
	"block-warnings",
	"block-not-oriented",
	"block-facts"
];
function showReasons(host) {
	const [first] = REASONS.flatMap((testid) => host.querySelector(`[data-testid="${testid}"]`) ?? []);
	if (first === void 0) return;
	first.tabIndex = -1;
	first.scrollIntoView({ block: "start" });
	first.focus({ preventScroll: true });
}
function sectionsOf(shown, off, out, written) {
	const { view } = shown;
	if (view.partial) return [
		leftOut(view, out),
		section(say("so-far"), "block-facts", facts(partialFacts(view))),
		section(say("cameras"), "block-cameras", cameraTable(view))
	];
	return [
		leftOut(view, out),
		strays(say("masks-without-an-image"), "block-stray-masks", view.strayMasks, say("no-image-has-their-name")),
		strays(say("image-measurements-without-an-image"), "block-stray-marks", view.strayMarks, say("not-among-the-images-read")),
		listOf(say("remarks"), "block-remarks", view.remarks.map(written)),
		section(say("block"), "block-facts", facts(factsOf(view))),
		onGround(shown, off, written),
		view.score === null ? null : section(say("against-the-truth"), "block-score", facts(scoreFacts(view.score))),
		listOf(say("warnings"), "block-warnings", view.warnings.map(written)),
		notOriented(view),
		section(say("tie-points-by-number-of"), "block-by-rays", rayTable(view)),
		section(say("cameras"), "block-cameras", cameraTable(view)),
		view.components.length === 0 ? null : section(say("stated-standard-errors"), "block-components", ...componentTable(view.components))
	];
}
function onGround(shown, off, written) {
	const { view, ground } = shown;
	if (view.orthophoto === null) return null;
	return section(say("orthophoto"), "block-on-orthophoto", h("p", {}, written(view.orthophoto.text)), ground === null ? null : h("p", { class: "buttons" }, off), ground === null || ground.verdicts.length === 0 ? null : reasons(ground.verdicts.map(({ name, verdict }) => ({
		name,
		reason: written(message("placing_verdict", verdict))
	}))));
}
function placedOf(state) {
	const tried = placedFiles(state);
	if (tried.length === 0) return null;
	const list = tried.map((one) => ({
		name: one.file.name,
		reason: `${verdictText(one, state)}${one.isStale ? say("earlier-settings") : ""}`
	}));
	return section(say("placed-images"), "block-placed-images", reasons(list), h("p", {}, heightsText(state)));
}
function partialFacts(view) {
	const connected = view.connections.filter(({ outcome }) => outcome.kind === "connected");
	return [
		{
			name: say("images-read"),
			testid: "block-read",
			value: count(view.images.length),
			help: say("images-whose-features-are-detected")
		},
		{
			name: say("connected-pairs"),
			testid: "block-connected",
			value: say("of-tried", {
				connected: connected.length,
				connections: view.connections.length
			}),
			help: say("pairs-with-enough-matches-that")
		},
		{
			name: say("matches-2"),
			testid: "block-matches",
			value: count(connected.reduce((sum, connection) => sum + matchesOf$1(connection), 0)),
			help: say("verified-matches-of-all-connected")
		}
	];
}
function strays(title, testid, names, why) {
	if (names.length === 0) return null;
	return section(title, testid, h("p", {}, `${asFigure(`${names.slice(0, LISTED).join(", ")}${names.length > LISTED ? " …" : ""}`)}: ${why}.`));
}
function listOf(title, testid, texts) {
	return texts.length === 0 ? null : section(title, testid, h("ul", {}, ...texts.map((text) => h("li", {}, text))));
}
function checkFacts({ points, rmse_m: rmse, mean_m: mean, ratio }) {
	const ofAxes = (values) => values.map((value) => fixed(value, 3)).join(" ");
	return [{
		name: say("check-points-rmse"),
		testid: "block-checks",
		value: say("m-points", {
			join: ofAxes(rmse),
			points,
			what: ratio === null ? "" : say("predicted", { ratio })
		}),
		help: say("root-mean-square-difference-of")
	}, {
		name: say("check-points-mean"),
		testid: "block-checks-mean",
		value: say("mean-m", { join: ofAxes(mean) }),
		help: say("mean-difference-of-check-points")
	}];
}
function factsOf(view) {
	const connected = view.connections.filter(({ outcome }) => outcome.kind === "connected");
	const matches = connected.reduce((sum, connection) => sum + matchesOf$1(connection), 0);
	const { tie, surveyed } = countedPoints(view);
	return [
		{
			name: say("images-oriented-3"),
			testid: "block-oriented",
			value: say("of-4", {
				oriented: view.oriented,
				images: view.images.length
			}),
			help: say("images-with-an-exterior-orientation")
		},
		{
			name: say("connected-pairs"),
			testid: "block-connected",
			value: say("of-tried", {
				connected: connected.length,
				connections: view.connections.length
			}),
			help: say("pairs-with-enough-matches-that-agree")
		},
		{
			name: say("groups"),
			testid: "block-groups",
			value: groupText(view),
			help: say("images-that-are-connected-directly")
		},
		{
			name: say("matches-2"),
			testid: "block-matches",
			value: count(matches),
			help: say("verified-matches-of-all-connected")
		},
		...view.found === null ? [] : [{
			name: say("tie-points"),
			testid: "block-found",
			value: say("observations-2", {
				points: view.found.points,
				rays: view.found.rays
			}),
			help: say("points-seen-in-two-or")
		}],
		...view.refinement === null ? [] : [refinementFact(view.refinement)],
		{
			name: say("selected-tie-points"),
			testid: "block-points-count",
			value: say("observations-2", {
				points: tie.points,
				rays: tie.observations
			}),
			help: say("the-tie-points-of-the")
		},
		...surveyed.points === 0 ? [] : [{
			name: say("control-and-check-points"),
			testid: "block-surveyed-count",
			value: say("observations-2", {
				points: surveyed.points,
				rays: surveyed.observations
			}),
			help: say("control-and-check-points-of-the")
		}],
		...view.checks === null ? [] : checkFacts(view.checks),
		{
			name: "RMSE",
			testid: "block-rmse",
			value: say("px-3", { value: view.rmsePx }),
			help: say("root-mean-square-length-of")
		},
		{
			name: "σ₀",
			testid: "block-sigma0",
			value: say("px-3", { value: view.sigma0Px }),
			help: say("standard-error-of-one-image")
		}
	];
}
var KEPT = {
	not_converged: say("did-not-converge"),
	left_image: say("at-the-border"),
	moved_too_far: say("moved-too-far"),
	low_correlation: say("low-correlation-2"),
	no_texture: say("no-texture"),
	inconsistent: say("inconsistent")
};
function refinementFact(counts) {
	const { reference, refined, ...kept } = counts;
	const others = Object.values(kept).reduce((sum, number) => sum + number, 0);
	const reasons = Object.entries(KEPT).flatMap(([outcome, words]) => {
		const number = kept[outcome];
		return number === 0 ? [] : [`${count(number)} ${words}`];
	});
	return {
		name: say("refined-observations"),
		testid: "block-refined",
		value: say("of-5", {
			refined,
			refined_2: refined + others
		}),
		help: say("observations-moved-by-least-squares", {
			reference,
			what: reasons.length > 0 ? say("n--3", { join: reasons.join(", ") }) : ""
		})
	};
}
function scoreFacts(score) {
	const positions = score.position_rmse_m?.map((error) => fixed(error, 3)).join(", ");
	return [
		{
			name: say("right-points"),
			testid: "score-points",
			value: say("of-6", {
				right_points: score.right_points,
				points: score.points
			}),
			help: say("points-whose-observations-all-agree")
		},
		{
			name: say("their-observations"),
			testid: "score-rays",
			value: say("px-3", { value: score.right_rmse_px }),
			help: say("root-mean-square-distance-of")
		},
		{
			name: say("positions"),
			testid: "score-positions",
			value: positions === void 0 ? "–" : `${positions} m`,
			help: say("root-mean-square-errors-of")
		},
		{
			name: say("angles"),
			testid: "score-angles",
			value: `${fixed(score.angle_rmse_deg, 4)}°`,
			help: say("root-mean-square-angle-between")
		}
	];
}
function groupText({ groups, images }) {
	const sizes = groups.map(({ length }) => length);
	const alone = sizes.filter((size) => size === 1).length;
	const largest = sizes[0] ?? 0;
	if (largest === images.length) return say("one-group");
	return say("the-largest-of", {
		sizes: sizes.length - alone,
		largest,
		what: alone > 0 ? say("single", { alone }) : ""
	});
}
function leftOut(view, out) {
	if (view.leftOut.length === 0) return null;
	return section(say("skipped-that-cannot-be-read", { left_out: view.leftOut.length }), "block-left-out", reasons(view.leftOut), out);
}
function outOf({ shown, files, history }) {
	const out = removableFiles(files, new Set(shown?.view.leftOut.map(({ name }) => name)));
	return out.length === 0 ? null : {
		kind: "remove_images",
		files: out.map(({ id }) => id),
		after: history.done
	};
}
function notOriented(view) {
	const lost = view.images.filter(({ oriented }) => !oriented);
	if (view.oriented === 0 || lost.length === 0) return null;
	return section(say("not-oriented", { lost: lost.length }), "block-not-oriented", reasons(lost.map(({ name, why }) => ({
		name,
		reason: why ?? ""
	}))));
}
function reasons(list) {
	const together = [...byReason(list)];
	const rest = together.slice(LISTED).reduce((sum, [, names]) => sum + names.length, 0);
	return h("ul", { class: "reasons" }, ...together.slice(0, LISTED).map(([reason, names]) => h("li", {}, h("b", {}, namesText(names)), `: ${reason}`)), rest > 0 ? h("li", {}, say("and-more-in-the-table", { rest })) : null);
}
function rayTable({ byRays }) {
	const head = h("thead", {}, h("tr", {}, ...[
		say("rays-2"),
		say("points"),
		say("rmse-px-4")
	].map((text) => h("th", { scope: "col" }, text))));
	const number = (text) => h("td", { class: "number" }, text);
	return h("table", { testid: "by-rays" }, head, h("tbody", {}, ...byRays.map(({ rays, points, rmsePx }) => row(count(rays), number(count(points)), number(fixed(rmsePx, 3))))));
}
function cameraTable({ cameras, found }) {
	const given = ({ given: known }) => known === null ? found === null ? "–" : say("unknown-2") : fixed(known.focal_px, 1);
	const head = h("thead", {}, h("tr", {}, ...[
		say("camera"),
		say("images-2"),
		say("given-f-px"),
		say("calibrated-f-px")
	].map((text) => h("th", { scope: "col" }, text))));
	const number = (text) => h("td", { class: "number" }, text);
	return h("div", { class: "scroll" }, h("table", {
		class: "tight",
		testid: "cameras"
	}, head, h("tbody", {}, ...cameras.map((camera, i) => row(`${String(i + 1)}: ${camera.label.replace(/(\d) x (?=\d)/gu, "$1 × ")}`, number(count(camera.images)), number(given(camera)), number(camera.calibrated === null ? "–" : `${fixed(camera.calibrated.focal_px, 1)}${camera.focalErrorPx === null ? "" : ` ± ${fixed(camera.focalErrorPx, 1)}`}`))))));
}
// www/block/panel/scans-line.ts
function mountScansLine(store, modes, pair, block) {
	const text = h("span", { testid: "of-scans" });
	const back = button(say("back-to-the-block"), "scans-to-block", () => {
		modes.dispatch("block");
		block.back();
		document.getElementById("block-view")?.focus({ preventScroll: true });
	});
	const measure = [0, 1].map((place) => button("", `scan-marks-${String(place)}`, () => {
		const scan = pair.shown()[place];
		if (scan !== void 0) pair.measure(scan.image);
	}));
	const take = button(say("use-marks-in-the-block"), "marks-to-block", () => block.take(toTake()), say("the-tables-of-marks-become"));
	const next = button(say("next-scans"), "next-scans", () => void pair.open(others()), say("next-scans-help"));
	const line = h("div", {
		class: "of-block of-scans",
		role: "region",
		aria: { label: say("marks-of-scans") }
	});
	const toTake = () => tablesToTake(store.state.placing.film, pair.shown());
	const others = () => {
		const names = pair.shown().map(({ image }) => image);
		return nextScans(store.state.placing.film, store.state.files, names);
	};
	const draw = () => {
		const shown = pair.shown();
		line.hidden = shown.length === 0 || modes.state.mode !== "pair";
		if (line.hidden) return;
		const held = document.activeElement;
		const { film } = store.state.placing;
		fill(text, [say("marks-of-some-scans", countedScans(film, store.state.files)), lackOf(film, shown)].filter((said) => said !== "").join(" "));
		const presses = measure.filter((_, place) => shown[place] !== void 0);
		for (const [place, press] of presses.entries()) fill(press, say("marks-of-this-scan", { name: shown[place]?.image ?? "" }));
		take.hidden = toTake().length === 0;
		next.hidden = others().length === 0;
		back.hidden = store.state.opened !== null;
		for (const press of [
			...presses,
			take,
			next
		]) press.disabled = isBusy(store.state);
		arrange(line, back, text, ...presses, take, next);
		passFocus(held, [next, back]);
	};
	store.watch([
		"placing",
		"files",
		"opened",
		"running",
		"notice"
	], draw);
	modes.watch(["mode"], draw);
	pair.watch(draw);
	return line;
}
// www/block/state/own-settings.ts
var USE_GNSS = {
	key: "recorded.gnss",
	path: "recorded.gnss",
	section: say("method"),
	label: say("use-gnss-positions"),
	unit: "",
	help: say("they-choose-near-pairs-and"),
	absent: "",
	acts: "",
	named: "",
	kind: "flag"
};
function ownSettings(settings, gps) {
	return {
		...settings,
		recorded: { gnss: gps === "use" }
	};
}
function optionsOfOwn({ recorded, ...settings }) {
	return {
		settings,
		gps: recorded.gnss ? "use" : "ignore"
	};
}
// www/block/panel/settings.ts
var SYSTEM = "placing.crs";
function mountSettings(host, store, files, opener) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue === null) return;
		const defaults = ownSettings(catalogue.defaults, BLOCK_INITIAL.options.gps);
		const take = (own) => store.dispatch({
			type: "options",
			options: optionsOfOwn(own)
		});
		const bound = {
			change: (key, value) => {
				const { settings, gps } = store.state.options;
				if (settings !== null) take(withSetting(ownSettings(settings, gps), key, value));
			},
			defaults: () => defaults,
			refused: (parameter) => store.dispatch({
				type: "refused",
				parameter
			})
		};
		const sections = makeFolded([...catalogue.parameters, USE_GNSS], bound, {
			title: say("method"),
			first: [
				"pairs.rule",
				"refinement.method",
				USE_GNSS.key
			],
			of: "block",
			take,
			changed: (count) => fill(opener, settingsText(count))
		});
		const [back, method, ...others] = sections.elements;
		fill(host, back ?? null, method ?? null, waiting(files), besides(store, files), ...others);
		store.watch((s) => [s.options.settings, s.options.gps], ([settings, gps]) => {
			if (settings === null) return;
			sections.show(ownSettings(settings, gps), [...acting_block_parameters(settings), USE_GNSS.key]);
			const { crs } = problemsOf(store.state);
			if (crs !== void 0) sections.controls.find(({ parameter }) => parameter.key === SYSTEM)?.refuse(readable(catalogue.labels, crs));
		});
	});
}
function waiting(files) {
	const input = h("input", {
		id: "block-wait",
		type: "checkbox",
		testid: "block-wait"
	});
	input.checked = files.waits;
	input.addEventListener("change", () => {
		files.waits = input.checked;
	});
	return h("div", { class: "control" }, h("div", { class: "control-head" }, input, h("label", { for: input.id }, say("wait-for-run"))), h("p", { class: "help" }, say("images-that-are-given-wait")));
}
var CAMERAS = say("from-exif-a-json-file", { example: "{\"cameras\": [{\"images\": \"DJI_*.JPG\", \"focal_px\": 3666.7}]}" });
var CONTROL = say("none-two-files-georeference-the");
function besides(store, files) {
	return h("fieldset", { class: "group" }, h("legend", {}, say("files")), textFile(store, files, "cameras", say("cameras"), CAMERAS, ".json,application/json"), textFile(store, files, "control", say("ground-control-points"), CONTROL, ".txt,.csv,text/*"), textFile(store, files, "marks", say("image-measurements"), "", ".txt,.csv,text/*"), textFile(store, files, "positions", say("image-positions"), say("none-positions-of-images"), ".txt,.csv,text/*"), masks(store, files), geoid(store, files));
}
var MASKS = say("none-images-of-the-same");
function problemOf(store, given) {
	const line = h("p", {
		class: "field-problem",
		testid: `block-${given}-problem`
	});
	store.watch([
		"files",
		"options",
		"marks"
	], () => {
		const found = problemsOf(store.state)[given] ?? (given === "control" && waitsForMarks(store.state) ? controlText(store.state) : "");
		const text = readable(store.state.catalogue?.labels ?? null, found);
		if (line.textContent !== text) line.textContent = text;
	});
	return line;
}
function masks(store, files) {
	const part = besideField(store, "masks", say("masks"), {
		multiple: true,
		accept: "image/*,.tif,.tiff,.pgm,.pnm"
	}, (given) => files.beside.takeMasks(given), () => store.dispatch({
		type: "options",
		options: { masks: [] }
	}));
	store.watch((s) => [s.options.masks], ([given]) => {
		const names = given.slice(0, 3).map(({ name }) => name).join(", ");
		part.show(given.length === 0 ? null : given.length === 1 ? names : say("masks-2", {
			given: given.length,
			names,
			what: given.length > 3 ? " …" : ""
		}), MASKS);
	});
	return part.element;
}
function geoid(store, files) {
	const part = besideField(store, "geoid", say("geoid"), { accept: ".gtx,.tif,.tiff,.pgm" }, ([file]) => {
		if (file !== void 0) files.beside.takeGeoid(file);
	}, () => store.dispatch({
		type: "options",
		options: { geoid: null }
	}));
	store.watch((s) => [s.options.geoid], ([given]) => part.show(given?.name ?? null, say("none-a-file-from-which")));
	return part.element;
}
function textFile(store, files, option, title, none, accept) {
	const part = besideField(store, option, title, { accept }, ([file]) => {
		if (file !== void 0) files.beside.takeText(option, file);
	}, () => store.dispatch({
		type: "options",
		options: { [option]: null }
	}));
	store.watch((s) => [s.options[option]], ([given]) => part.show(given?.name ?? null, none));
	return part.element;
}
function besideField(store, given, title, how, take, clear) {
	const [press, input] = fileButton(`${title} …`, {
		testid: `block-${given}`,
		label: say("file", { title }),
		...how
	}, take);
	const remove = button(say("remove"), `block-${given}-remove`, clear);
	remove.setAttribute("aria-label", say("remove-2", { title }));
	const name = h("p", {
		class: "note",
		testid: `block-${given}-name`
	});
	return {
		element: h("div", { class: "control" }, h("div", { class: "buttons" }, press, remove), name, problemOf(store, given), input),
		show: (text, none) => {
			fill(name, text ?? none);
			remove.hidden = text === null;
		}
	};
}
// www/block/panel/stage.ts
function mountStage(host, store, looking, facts, views, dock, invitation) {
	const shelf = h("div", {
		class: "views",
		id: "block-view",
		tabindex: -1
	}, invited(store, invitation));
	const tools = h("div", { class: "view-tools" });
	const legends = h("div", { class: "legends" });
	const line = h("div", { class: "edit-line" }, legends);
	const keys = h("p", {
		class: "keys",
		id: KEYS_ID
	});
	const mounted = new Map();
	const now = () => mounted.get(store.state.onStage);
	const buttons = views.map((view) => ({
		view,
		press: button(view.title, `block-show-${view.name}`, () => store.dispatch({
			type: "stage",
			view: view.name
		}))
	}));
	const switched = h("div", {
		class: "mode",
		role: "group",
		aria: { label: say("view-2") }
	}, ...buttons.map(({ press }) => press));
	const zoom = h("div", { class: "actions" }, ...zoomButtons("block-", say("whole-block"), () => ({
		fit: () => now()?.zoomable.fit(),
		zoomMiddle: (factor) => now()?.zoomable.zoomMiddle(factor)
	})));
	shelf.addEventListener("focus", () => now()?.element.focus());
	host.append(h("div", {
		class: "toolbar",
		role: "toolbar",
		aria: { label: say("view-of-the-block") }
	}, switched, drawerButton("table", say("table-2"), "block-table", dock), zoom, tools), line, shelf, said(store, looking, facts), dock, keys);
	const lacksBlock = () => lackOfBlock(store.state);
	declareLack([line], lacksBlock);
	const make = ({ name, title, mount }, isShown) => {
		if (mounted.has(name)) return;
		const made = mount(store, looking);
		mounted.set(name, made);
		const parts = partsOf(made);
		for (const part of parts) part.hidden = !isShown;
		declarePlace(parts, {
			title,
			show: () => store.dispatch({
				type: "stage",
				view: name
			})
		});
		declareLack(parts, name === "orthophoto" ? () => lackOfOrthophoto(store.state) : lacksBlock);
		shelf.append(made.element);
		tools.append(...made.tools);
		if (made.legend !== void 0) legends.append(made.legend);
	};
	store.watch(["onStage"], ([onStage]) => {
		const wanted = views.find(({ name }) => name === onStage) ?? views[0];
		if (wanted === void 0) return;
		for (const { view, press } of buttons) press.setAttribute("aria-pressed", String(view === wanted));
		make(wanted, true);
		for (const [name, view] of mounted) for (const part of partsOf(view)) part.hidden = name !== wanted.name;
		fill(keys, mounted.get(wanted.name)?.keys ?? "");
	});
	beforeSearch(() => {
		for (const view of views) make(view, false);
	});
	return line;
}
var partsOf = ({ element, tools, legend }) => [
	element,
	...tools,
	...legend === void 0 ? [] : [legend]
];
function said(store, looking, facts) {
	const pointedAt = h("p", {
		class: "pointed",
		testid: "block-pointed"
	});
	const chosenNow = h("p", {
		class: "chosen",
		testid: "block-chosen",
		role: "status",
		aria: { live: "polite" }
	});
	const open = button(say("open-this-pair"), "block-open-pair", () => {
		const { chosen } = store.state.selection;
		if (chosen?.kind === "pair") looking.open(chosen.images);
	});
	const describeNow = () => {
		const { selection, onStage } = store.state;
		const { chosen, pointed } = selection;
		tell$1(chosenNow, store, facts, chosen, "");
		tell$1(pointedAt, store, facts, pointed, onStage === "plots" ? "" : say("point-at-an-image-a"));
		if (pointed !== null && isSame(pointed, chosen)) pointedAt.textContent = "";
	};
	facts.watch(describeNow);
	store.watch([
		"selection",
		"shown",
		"running",
		"notice",
		"placing",
		"onStage"
	], ([{ chosen }, shown]) => {
		describeNow();
		open.hidden = chosen?.kind !== "pair" || shown === null;
		open.disabled = isBusy(store.state);
	});
	const text = h("div", {}, chosenNow, pointedAt);
	const line = h("div", { class: "said" }, text, open);
	const sized = new ResizeObserver(() => byKeys(line));
	for (const element of [text, line]) sized.observe(element);
	return line;
}
function tell$1(element, store, facts, choice, otherwise) {
	const { shown } = store.state;
	const gsd = choice?.kind === "image" && shown !== null ? gsdOf(shown.view, facts.ground(), choice.image) : null;
	const text = choice === null || shown === null ? otherwise : describe(shown, choice, gsd === null ? "" : gsdText(gsd));
	if (element.textContent !== text) element.textContent = text;
}
function invited(store, { sample, placedSample, open }) {
	const own = button(say("open-your-photos"), "block-open-first", open);
	const simulate = button(say("try-a-sample-block"), "block-simulate-first", sample);
	const placed = button(say("try-a-sample-orthophoto"), "block-place-first", placedSample);
	const list = h("p", {
		class: "note",
		testid: "block-given"
	});
	const gains = [
		say("where-each-photo-was-taken"),
		say("points-that-several-photos-show"),
		say("a-plain-word-on-whether"),
		say("files-for-other-programs-colmap")
	];
	const welcome = h("div", {
		class: "welcome",
		testid: "block-welcome"
	}, h("h2", {}, say("where-did-each-photo-stand")), h("p", {}, say("drop-the-photographs-of-a")), h("ul", {}, ...gains.map((gain) => h("li", {}, gain))), h("p", { class: "buttons" }, own, simulate, placed), list, h("p", { class: "note" }, say("nothing-leaves-this-computer-work")));
	store.watch([
		"shown",
		"files",
		"running",
		"notice",
		"catalogue",
		"onStage",
		"placing"
	], ([shown, given, , , catalogue, onStage, placing]) => {
		welcome.hidden = shown !== null || onStage === "orthophoto";
		for (const press of [
			own,
			simulate,
			placed
		]) press.disabled = catalogue === null || isBusy(store.state);
		const names = given.map(({ name }) => name);
		own.classList.toggle("primary", names.length < 2);
		const there = say("images-3", {
			names: names.length,
			join: names.slice(0, 8).join(", "),
			what: names.length > 8 ? " …" : ""
		});
		const onOrthophoto = placing.placed.size;
		fill(list, names.length === 0 ? "" : onOrthophoto === 0 ? there : `${there} ${say("are-placed-on-the-orthophoto", { placed: onOrthophoto })}`);
	});
	return welcome;
}
// www/block/state/doubt.ts
function doubtOf(state) {
	const purpose = purposeOf(state);
	return (purpose === "images" || purpose === "block" && state.options.gps === "use") && !hasPlace(state) ? state.placing.elsewhere : "";
}
function hasPlace(state) {
	const { placing, shown } = state;
	if (purposeOf(state) === "images") return [...placing.placed.values()].some(({ result }) => (result?.placement ?? null) !== null);
	return shown !== null && isInSystemOf(shown.view) && !isOffGround(state);
}
// www/block/panel/status.ts
function mountBlockStatus(store, actions, details) {
	const line = h("p", {
		class: "status",
		testid: "block-status",
		role: "status",
		aria: { live: "polite" }
	});
	const run = button(say("run"), "block-run", () => {
		if (places(store.state)) actions.place();
		else actions.run();
	});
	const cancel = button(say("cancel"), "block-cancel", actions.cancel);
	declareLack([run], () => lackOfImages(store.state));
	declareLack([cancel], () => cancel.disabled || cancel.hidden ? say("nothing-is-running") : "");
	const buttons = h("div", { class: "answer-actions" }, progressBar(store), run, cancel, details);
	const card = h("div", {
		class: "answer",
		testid: "block-answer"
	}, line, buttons);
	const show = answerCard(card, line, buttons, "block-");
	store.watch((s) => [s], ([state]) => {
		const { catalogue } = state;
		const answer = readableAnswer(doubted(offeringSetting(answerOf(state, actions), catalogue, actions), doubtOf(state)), catalogue?.labels ?? null);
		line.setAttribute("aria-live", answer.kind === "busy" ? "off" : "polite");
		show(answer);
		run.disabled = isBusy(state) || asksForOrthophoto(state) || (places(state) ? unplacedFiles(state).length === 0 : state.files.length < 2);
		run.textContent = places(state) ? say("place-them") : state.running.kind === "ended" ? say("go-on") : say("run");
		run.classList.toggle("primary", answer.next == null && !run.disabled && (state.onStage !== "orthophoto" || places(state)));
		cancel.disabled = !isBusy(state);
	});
	return card;
}
function readableAnswer({ text, more, said, problem, ...answer }, labels) {
	return {
		...answer,
		text: readable(labels, text),
		...more === void 0 ? {} : { more: readable(labels, more) },
		...said === void 0 ? {} : { said: readable(labels, said) },
		...problem === void 0 ? {} : { problem: readable(labels, problem) }
	};
}
function offeringSetting(answer, catalogue, actions) {
	if (answer.kind !== "problem" || answer.next != null || catalogue === null) return answer;
	const named = firstNamed([...catalogue.parameters, ...catalogue.placingParameters], answer.text);
	return named === null ? answer : {
		...answer,
		next: openField(named, actions)
	};
}
function openField({ key, label }, { openSetting }) {
	return {
		text: say("open-the-setting", { label }),
		act: () => openSetting(key)
	};
}
function doubted(answer, doubt) {
	return doubt === "" ? answer : {
		...answer,
		more: `${answer.more ?? ""} ${doubt}`.trimStart()
	};
}
function placed(state, actions) {
	return placingAnswer(state, {
		...actions,
		asBlock: () => actions.decide("block"),
		save: actions.savePlaced,
		why: actions.whyPlaced
	});
}
function places(state) {
	return state.onStage === "orthophoto" && purposeOf(state) === "images";
}
function asksForOrthophoto({ onStage, placing }) {
	return onStage === "orthophoto" && placing.orthophoto === null;
}
function isOfGround(state) {
	const { onStage, placing, shown } = state;
	if (onStage !== "orthophoto") return false;
	const purpose = purposeOf(state);
	return placing.orthophoto === null || purpose === "images" || purpose === "block" && (shown === null || shown.view.partial);
}
function isFinished(state) {
	return state.shown !== null && !state.shown.view.partial && !isOutdated(state);
}
function besideVerdict(state, actions, text) {
	const { shown } = state;
	if (shown === null || !isFinished(state)) return {
		kind: "idle",
		verdict: null,
		text
	};
	return {
		...answered(state, shown, actions),
		more: text
	};
}
function offering(state, actions, answer) {
	const { more, ...offer } = offered(state, actions);
	return {
		...answer,
		...offer,
		more: [answer.more ?? "", more ?? ""].join(" ").trim()
	};
}
function offered(state, { decide }) {
	const lies = !isHeldByHand(state) && state.shown?.view.surveyed.some(({ role, isUsed }) => role === "control" && isUsed) === true;
	const place = {
		text: say("place-the-block-on-the"),
		act: () => decide("block")
	};
	return {
		more: [lies ? say("control-places-the-block") : toBePlacedText(state, say("a-block-on-an-orthophoto")), state.placing.heights.kind === "level" ? heightsText(state) : ""].join(" ").trim(),
		...lies ? {} : { next: place },
		others: [
			...lies ? [place] : [],
			{
				text: say("place-each-image"),
				act: () => decide("images")
			},
			{
				text: lies ? say("only-under-the-map") : say("not-now"),
				act: () => decide("map")
			}
		]
	};
}
function toBePlacedText(state, text) {
	return isHeldByHand(state) ? `${state.shown?.view.orthophoto?.text ?? ""} ${say("places-found-hold-it-too")}` : text;
}
function placeBlock({ run }) {
	return {
		text: say("place-the-block-on-the"),
		act: run
	};
}
function answerOf(state, actions) {
	const { running, shown, files, placing } = state;
	const notice = state.notice?.passing === true && running.kind !== "yes" && placing.running === null ? null : ofLine(state.notice);
	const line = (kind, text) => ({
		kind,
		text,
		verdict: null
	});
	const beside = notice?.beside === true ? notice.text : "";
	if (running.kind === "yes") return {
		...line("busy", runText(running.steps)),
		more: beside
	};
	if (state.placing.running !== null) return {
		...placingRuns(state.placing.running),
		more: beside
	};
	if (notice?.beside === true) return {
		...answerOf({
			...state,
			notice: null
		}, actions),
		said: notice.text
	};
	if (notice !== null) {
		const said = line(notice.kind === "info" ? "idle" : notice.kind, notice.text);
		const isInfo = notice.kind === "info";
		if (notice.kind !== "busy" && asksPurpose(state)) return offering(state, actions, isInfo ? besideVerdict(state, actions, notice.text) : said);
		if (isInfo && lacksPlaceAlone(state)) return {
			...besideVerdict(state, actions, notice.text),
			next: placeBlock(actions)
		};
		if (notice.kind !== "busy" && shown !== null && isFinished(state) && !isOfGround(state)) return {
			...answered(state, shown, actions),
			...isInfo ? { said: notice.text } : { problem: notice.text }
		};
		if (!isInfo || state.placing.orthophoto === null || !isOfGround(state)) return said;
		const { next = null, others = [] } = placed(state, actions);
		return {
			...said,
			next,
			others
		};
	}
	if (state.refused !== null) return {
		...line("problem", refusedText(state.refused.label)),
		next: openField(state.refused, actions)
	};
	if (asksPurpose(state) && state.placing.orthophoto !== null) return offering(state, actions, besideVerdict(state, actions, orthophotoText(state.placing.orthophoto)));
	if (isOfGround(state)) return placed(state, actions);
	if (running.kind === "ended") {
		const former = shown !== null && !shown.view.partial ? say("the-screen-shows-the-former") : "";
		if (running.failure === null) return line("idle", say("cancelled-the-work-done-is", {
			former,
			what: former === "" ? say("shown-and") : ""
		}));
		return line("problem", say("the-block-was-not-finished", {
			failure: sentence(running.failure),
			what: former === "" ? say("the-work-done-is-kept") : former
		}));
	}
	if (shown !== null && !shown.view.partial && !isOutdated(state)) {
		if (isOffGround(state)) return {
			...besideVerdict(state, actions, `${toBePlacedText(state, say("the-block-is-not-on"))} ${heightsText(state)}`),
			next: placeBlock(actions)
		};
		const answer = answered(state, shown, actions);
		return waitsForMarks(state) ? {
			...answer,
			more: `${answer.more ?? ""} ${controlText(state)}`.trimStart()
		} : answer;
	}
	if (shown !== null && !shown.view.partial && takesMarks(state)) return {
		...line("idle", say("control-can-be-taken", { twice: collectedOf(state).twice })),
		more: say("taking-the-control", { kept: state.history.done > 0 ? "edits" : "none" }),
		next: takeControl(actions)
	};
	if (files.length >= 2) {
		const first = framesStep(state);
		const run = shown === null || shown.view.partial ? say("press-run") : say("images-or-settings-have-changed");
		const why = first === "" ? run : first;
		return line("idle", `${say("block-images", { images: files.length })} ${why}`);
	}
	return line("idle", say("open-the-images-of-a"));
}
function takesMarks(state) {
	const { run, asGiven } = collectedOf(state);
	return run !== null && !asGiven && state.files.length >= 2;
}
function takeControl({ run }) {
	return {
		text: say("take-the-control"),
		act: run
	};
}
function answered(state, shown, actions) {
	const { view, files } = shown;
	const why = {
		text: say("show-why"),
		act: actions.why
	};
	if (view.oriented > 0 || files.length === 0) {
		const sound = view.verdict?.kind === "oriented";
		const next = state.truth === null ? {
			text: say("save-the-project"),
			act: actions.save
		} : {
			text: say("open-your-photos"),
			act: actions.open
		};
		return {
			kind: sound ? "done" : "partial",
			verdict: view.verdict?.kind ?? "weak",
			text: view.verdict?.text ?? "",
			more: [view.orthophoto !== null && isInSystemOf(view) ? view.orthophoto.text : countsOf(shown), lackingText(state)].join(" ").trim(),
			figures: figuresOf(view),
			next: sound ? next : why
		};
	}
	const group = view.groups[0]?.length ?? 0;
	const figures = {
		why: view.warnings[0] ?? message("overview_warning", { kind: "none_oriented" }),
		group: group < view.images.length ? group : null,
		images: view.images.length,
		pairs: connectedPairs(view),
		points: view.points.taking
	};
	const others = state.placing.orthophoto === null ? [] : [{
		text: say("place-each-image"),
		act: () => actions.decide("images")
	}];
	return {
		kind: "problem",
		verdict: "not_oriented",
		text: say("block-not-oriented", figures),
		next: why,
		others
	};
}
function figuresOf(view) {
	return [
		{
			value: say("of-4", {
				oriented: view.oriented,
				images: view.images.length
			}),
			label: say("images-oriented-2")
		},
		{
			value: count(view.points.taking),
			label: say("tie-points-used")
		},
		...view.sigma0Px === null ? [] : [{
			value: say("px-2", { value: view.sigma0Px }),
			label: say("sigma-of-image-observations")
		}],
		...view.checks === null ? groundFigure(view) : [checkFigure(view.checks)]
	];
}
function groundFigure(view) {
	const [plan, height] = medianErrors(view);
	if (unitOf(view) === "" || !Number.isFinite(plan) || !Number.isFinite(height)) return [];
	const written = (error) => fixed(error, error < 1 ? 3 : 2);
	return [{
		value: say("plan-and-height-of", {
			plan: written(plan),
			height: written(height)
		}),
		label: say("median-errors-of-tie-points")
	}];
}
function checkFigure({ points, plan_rmse_m: plan, height_rmse_m: height }) {
	return {
		value: say("plan-and-height-m", {
			plan,
			height
		}),
		label: say("rmse-of-check-points", { points })
	};
}
function connectedPairs({ connections }) {
	return connections.filter(({ outcome }) => outcome.kind === "connected").length;
}
function countsOf({ view, seconds }) {
	const counted = countedPoints(view);
	return say("block-done", {
		images: view.images.length,
		verdict: "",
		skipped: view.leftOut.length,
		name: view.leftOut[0]?.name ?? "",
		reason: view.leftOut[0]?.reason ?? "",
		pairs: connectedPairs(view),
		points: counted.tie.points,
		surveyed: counted.surveyed.points,
		found: view.found?.points ?? null,
		time: seconds === 0 ? null : duration(seconds),
		warnings: view.warnings.length
	}).trim();
}
// www/block/mount.ts
var SAMPLE = {
	strips: 3,
	exposures: 4
};
var PLACED_SAMPLE = {
	strips: 2,
	exposures: 2,
	pixel_mm: .045
};
var PLACED_GSD_M = .5;
async function mountBlock(catalogue, { modes, openPair, pair, scans: scansOf, openProject, putAside, left, stays }) {
	const store = new Holder(BLOCK_INITIAL, reduceBlock);
	const engine = new BlockEngine(store);
	const placing = new PlacingEngine(store);
	const onGround = new BlockPlacing(store, engine, placing);
	const facts = new Facts(store, engine);
	const runs = new BlockRuns(store, engine, placing, onGround, new GroundFiles(store, placing));
	const leave = () => {
		placing.cancel();
		onGround.cancel();
		engine.leave();
	};
	const kept = new KeptBlocks(store, engine, catalogue, leave, () => void files.actions.run());
	const files = new BlockFiles(store, engine, placing, runs, openProject, () => putAside(kept), left, stays);
	const looking = {
		choose: (choice) => store.dispatch({
			type: "choose",
			choice
		}),
		point: (choice) => store.dispatch({
			type: "point",
			choice
		}),
		open: (images) => void openPair(store, images)
	};
	const beside = {
		...pair,
		open: (images) => openPair(store, images)
	};
	const scans = scansOf(store);
	const toMarks = () => {
		files.film.areScans();
		const { film } = store.state.placing;
		scans.open(nextScans(film, store.state.files));
	};
	const actions = h("div", {
		class: "actions",
		role: "group",
		aria: { label: say("images-of-the-block") }
	});
	const exports = h("div", {
		class: "actions",
		role: "group",
		aria: { label: say("export-of-the-block") }
	});
	declareLack([actions], () => lackOfImages(store.state));
	declareLack([exports], () => lackOfBlock(store.state));
	const settings = tabbed("settings", say("settings"), [
		["block-settings", say("settings")],
		["block-orthophoto", say("orthophoto")],
		["block-flight", say("simulate")]
	]);
	const results = tabbed("details", say("results"), [["block-results", say("results")], ["block-edits", say("edits")]]);
	const stage = h("section", {
		class: "stage",
		aria: { label: say("views-of-the-block") }
	});
	const main = h("main", { class: "block" }, settings.element, stage, results.element);
	const opener = drawerButton("settings", say("settings"), "block-settings", settings.element);
	const drawers = h("div", {
		class: "drawers",
		role: "group",
		aria: { label: say("settings-of-the-block") }
	}, opener);
	byId("page-actions").before(actions, exports);
	byId("menu").before(drawers);
	document.querySelector("body > main")?.after(main);
	document.querySelector("body > main")?.before(mountBack(store, facts, modes, beside, (masks) => files.beside.takePairMasks(masks)));
	document.querySelector("body > main")?.before(mountScansLine(store, modes, scans, {
		take: (tables) => files.film.takeMeasured(tables),
		back: () => {
			setDrawer("settings", true);
			showTab("tab-block-orthophoto");
		}
	}));
	showIn(modes, "block", [
		actions,
		exports,
		drawers,
		main
	]);
	const pick = mountActions(actions, store, files);
	mountExports(exports, store, engine, facts, placing);
	const status = mountBlockStatus(store, {
		run: () => void files.actions.run(),
		why: () => {
			showTab("tab-block-results");
			setDrawer("details", true);
			reveal(results.element);
			showReasons(results.panels[0]);
		},
		save: () => void saveAs(store, engine, "project", "block-next"),
		open: pick,
		place: () => void files.actions.place(),
		decide: (purpose) => void files.actions.decide(purpose),
		cancel: () => {
			placing.cancel();
			onGround.cancel();
			engine.cancel();
		},
		openHeights: () => pickers.heights(),
		savePlaced: () => void savePlaced(store, placing, "placed", "block-next"),
		whyPlaced: () => {
			setDrawer("table", true);
			showTab("tab-block-placed");
		},
		openSetting: (key) => {
			const field = settings.element.querySelector(`[data-key="${key}"]`);
			if (field === null) return;
			reveal$1(field);
			field.focus();
		}
	}, drawerButton("details", say("details"), "block-details", results.element, say("details-of-the-results")));
	await breath();
	mountSettings(settings.panels[0], store, files, opener);
	await breath();
	const pickers = mountPlacingSettings(settings.panels[1], store, files, toMarks);
	mountFlight(settings.panels[2], store, files);
	mountProgress(results.panels[0], store);
	mountResults(results.panels[0], store, () => void files.actions.takeOff());
	await breath();
	const placedSample = () => void files.simulated.sampleOnOrthophoto({
		...catalogue.flight,
		...PLACED_SAMPLE
	}, PLACED_GSD_M);
	const sample = () => void files.simulated.sample({
		...catalogue.flight,
		...SAMPLE
	});
	let measures = null;
	const images = imagesView(engine, placing, facts, pick, (made) => {
		measures = made;
	});
	const editLine = mountStage(stage, store, looking, facts, [
		mapView(facts, placing, () => void makeMosaic(store, engine, placing, "map-mosaic")),
		images,
		MATRIX_VIEW,
		plotsView(facts),
		orthophotoView(engine, facts, placing, {
			open: pickers.orthophoto,
			sample: placedSample,
			measure: () => {
				store.dispatch({
					type: "stage",
					view: "images"
				});
				measures?.toggle(false);
			}
		})
	], makeDock(store, looking, facts, placingTables(store)), {
		sample,
		placedSample,
		open: pick
	});
	stage.prepend(status);
	editLine.prepend(mountEditBar(store, facts, () => measures));
	mountEditPanel(results.panels[1], store);
	mountBlockEditKeys(store, facts, [stage, results.element]);
	const near = makeNear("block-near", () => store.dispatch({
		type: "notice",
		notice: null
	}));
	main.append(near.element);
	store.watch(["notice"], ([notice]) => near.show(notice));
	store.watch((s) => [
		s.files,
		s.placing.orthophoto?.raster ?? null,
		s.placing.options,
		givenPositions(s)
	], () => void placing.lookElsewhere());
	new EditFollower(store, engine);
	mountAddress(store, modes, beside);
	store.watch(["running"], ([running]) => {
		if (running.kind === "yes") showTab("tab-block-results");
	});
	return {
		store,
		kept,
		taker: {
			isActive: () => modes.state.mode === "block",
			markAt: () => "block",
			take: (found) => void files.take(found)
		},
		give: (given, masks) => void files.give(given, masks),
		sample,
		open: (file) => files.open(file),
		save: (near) => saveAs(store, engine, "project", near)
	};
}
function mountActions(host, store, files) {
	const take = (given) => void files.take(given.map((file) => ({
		file,
		path: file.webkitRelativePath
	})));
	const [images, imagesInput] = fileButton(say("images"), {
		testid: "block-files",
		label: say("images-cameras-or-project-of"),
		multiple: true,
		accept: "image/*,.tif,.tiff,.pgm,.ppm,.pnm,.json,.tiepoint"
	}, take, say("image-files-a-cameras-file"));
	const [folder, folderInput] = fileButton(say("folder"), {
		testid: "block-folder",
		label: say("folder-of-images"),
		folder: true
	}, take, say("all-images-of-a-folder"));
	const buttons = [
		images,
		folder,
		button(say("simulated-block"), "block-simulate", () => void files.simulated.photograph(), say("photos-of-a-synthetic-scene")),
		button(say("clear"), "block-clear", () => void files.actions.clear(), say("removes-all-images-an-edited"))
	];
	fill(host, ...buttons, imagesInput, folderInput);
	store.watch([
		"running",
		"notice",
		"files",
		"shown",
		"catalogue",
		"placing"
	], ([, , given, shown, catalogue, placing]) => {
		for (const press of buttons) press.disabled = catalogue === null || isBusy(store.state);
		const last = buttons.at(-1);
		if (last !== void 0) last.disabled ||= given.length === 0 && shown === null && placing.orthophoto === null;
	});
	return () => imagesInput.click();
}
// www/block/state/pair-camera.ts
function cameraOfImages({ images, cameras }, a, b) {
	const [left, right] = [images[a], images[b]];
	const camera = left !== void 0 && left.camera === right?.camera ? cameras[left.camera] : void 0;
	if (camera?.calibrated != null) return photo_camera(camera.calibrated);
	return camera?.given == null ? null : cameraFrom(camera.given, "exif35_mm");
}
// www/block/pair.ts
var nextId = -1;
var GIVEN_PARTS = [
	"camera",
	"offset",
	"photos",
	"masks"
];
var given = null;
function isAsGiven({ camera, offset, photos, masks }) {
	given = {
		camera,
		offset,
		photos,
		masks
	};
}
function isOwn(state) {
	const before = given;
	if (before !== null && GIVEN_PARTS.every((part) => state[part] === before[part])) return false;
	const { photos, masks, truth } = state;
	return isWorthKeeping(state) || SIDES.some((side) => masks[side] !== null || truth === null && hasData(photos[side]));
}
async function leave(block, state, putAside, here) {
	block.dispatch({
		type: "notice",
		notice: {
			kind: "busy",
			text: say("keeping-the-pair")
		}
	});
	const stays = await putAside();
	here();
	block.dispatch({
		type: "notice",
		notice: null
	});
	if (stays) return titleOf$2({
		name: null,
		images: SIDES.flatMap((side) => state.images[side]?.name ?? [])
	});
	return window.confirm(say("cannot-be-kept-in-this", {
		edits: say("the-pair-with-its-marks"),
		step: say("open-the-pair-of-the-block"),
		length: 1
	})) ? "" : null;
}
function openPair(block, modes, pair, { putAside, stays }, images) {
	return doHere(stays, (here) => opened(block, modes, pair, putAside, images, here));
}
async function opened(block, modes, pair, putAside, [a, b], here) {
	const { shown } = block.state;
	if (shown === null) return;
	const [left, right] = [a, b].map((image) => fileOf(block, shown.view.images[image]?.name));
	if (left === void 0 || right === void 0) {
		tell(block, modes, say("the-files-of-these-images"));
		return;
	}
	await showFiles(block, modes, pair, putAside, {
		left,
		right,
		camera: () => cameraOfImages(shown.view, a, b),
		opened: [a, b]
	}, here);
}
async function showFiles(block, modes, { store, engine }, putAside, { left, right, camera: cameraOf, marks, opened: ofBlock }, here) {
	const images = {
		left: imageOf(left),
		right: right && imageOf(right)
	};
	let camera;
	let masks;
	try {
		camera = cameraOf();
		await Promise.all(SIDES.map((side) => images[side] && engine.open(side, images[side])));
		masks = {
			left: await maskFor(engine, block, left),
			right: right && await maskFor(engine, block, right)
		};
		here();
	} catch (error) {
		here();
		tell(block, modes, say("the-pair-cannot-be-shown", { error: messageOf(error) }));
		return false;
	}
	const stays = isOwn(store.state) ? await leave(block, store.state, putAside, here) : "";
	if (stays === null) return false;
	store.dispatch({
		type: "images",
		images
	});
	readyFor(store, block, camera);
	for (const side of SIDES) {
		if (masks[side] !== null) store.dispatch({
			type: "mask",
			side,
			mask: masks[side]
		});
		if (marks !== void 0 && images[side] !== null) store.dispatch({
			type: "photo",
			side,
			photo: { fiducials: marks(side) }
		});
	}
	if (marks !== void 0) store.dispatch({ type: "wait" });
	isAsGiven(store.state);
	if (stays !== "") store.dispatch({
		type: "notice",
		notice: {
			kind: "info",
			text: say("stay-under-projects", { title_of: stays })
		}
	});
	block.dispatch({
		type: "openedPair",
		images: ofBlock
	});
	modes.dispatch("pair");
	return true;
}
function readyFor(store, block, camera) {
	const { settings } = store.state;
	const features = block.state.options.settings?.features;
	if (settings !== null && features !== void 0) {
		const { points, matching } = settings;
		store.dispatch({
			type: "settings",
			settings: {
				...settings,
				...features,
				points: {
					...points,
					operator: null
				},
				matching: {
					...matching,
					strategy: "gradient"
				}
			}
		});
	}
	store.dispatch({
		type: "camera",
		camera
	});
	store.dispatch({
		type: "offset",
		offset: null
	});
	for (const side of SIDES) store.dispatch({
		type: "photo",
		side,
		photo: {
			fiducials: [],
			origin: null
		}
	});
}
async function maskFor(engine, { state }, image) {
	const mask = maskOf(state.options.masks, image.name);
	if (mask === null || isLacking(mask)) return null;
	return {
		...await engine.client("pair").call("mask", {
			file: mask.file,
			overlaySide: MASK_SIDE
		}),
		id: nextId--,
		name: mask.name,
		source: {
			kind: "file",
			file: mask.file
		}
	};
}
function masksOf({ images, masks, maskSteps }) {
	return SIDES.flatMap((side) => {
		const [image, mask] = [images[side], masks[side]];
		if (image === null) return [];
		if (mask === null) return maskSteps.edits.some((step) => step.side === side) ? [{
			image: image.name,
			file: null
		}] : [];
		return mask.source.kind === "file" ? [{
			image: image.name,
			file: mask.source.file
		}] : [];
	});
}
function matchesOf(state) {
	const standing = standingOf$1(state.history.edits, state.history.done);
	if (isNothing(standing)) return null;
	const { edited } = shownPair(state);
	return edited === null ? null : byHandOf(edited, standing, placesByHand(state.history.edits));
}
var byHandOf = remember((edited, standing, places) => {
	const rejected = [];
	edited.match.rules.forEach((rule, left) => {
		if (rule !== BY_HAND$3) return;
		const target = targetOfLeft(edited, left);
		rejected.push(target === null || typeof target === "number" ? placeOfLeft(edited, left) : target);
	});
	const measured = [...standing.placed].filter(([key]) => !standing.rejected.has(key));
	return {
		rejected,
		used: edited.match.matches,
		measured: measured.map(([key, { target, at }]) => ({
			at,
			of: typeof target === "number" ? null : target,
			had: places.get(key) ?? []
		}))
	};
});
function fileOf(block, name) {
	const { shown, files } = block.state;
	return [...shown?.files ?? [], ...files].find((file) => file.name === name);
}
function imageOf({ name, file }) {
	return {
		id: nextId--,
		name,
		source: {
			kind: "file",
			file
		}
	};
}
function tell(block, modes, text) {
	modes.dispatch("block");
	block.dispatch({
		type: "notice",
		notice: {
			kind: "problem",
			text
		}
	});
}
// www/block/scans.ts
function scansBeside(block, modes, pair, projects) {
	const { store } = pair;
	return {
		shown: () => SIDES.flatMap((side) => scanOn(block, store.state, side) ?? []),
		watch: (changed) => store.watch((s) => [
			s.images,
			s.photos,
			s.results.openLeft,
			s.results.openRight
		], changed),
		open: (scans) => openScans(block, modes, pair, projects, scans),
		measure: (image) => {
			const side = SIDES.find((one) => store.state.images[one]?.name === image);
			if (side !== void 0) measure(pair, side);
		}
	};
}
function scanOn({ state: { placing, files } }, state, side) {
	const image = state.images[side];
	const scan = scansOf(placing.film, files).find(({ name }) => name === image?.name);
	if (scan === void 0 || image?.source.kind !== "file" || image.source.file.size !== scan.file.size) return null;
	const photo = state.photos[side];
	const all = photo.fiducials.map((mark) => {
		const [col, row] = placeOfMark(photo, mark) ?? [NaN, NaN];
		return {
			...mark,
			col,
			row
		};
	});
	const stage = side === "left" ? "openLeft" : "openRight";
	const info = isCurrent(state, stage) ? state.results[stage]?.value.info : void 0;
	const withoutMm = all.filter((mark) => isMeasured(mark) && !isWhole(mark)).length;
	return {
		image: scan.name,
		all,
		marks: all.filter(isWhole),
		withoutMm,
		size: info === void 0 ? null : [info.width, info.height]
	};
}
function openScans(block, modes, pair, { putAside, stays }, given) {
	return doHere(stays, async (here) => {
		const [left, right] = given;
		if (left === void 0) return;
		const shown = SIDES.flatMap((side) => scanOn(block, pair.store.state, side) ?? []);
		const film = withBegun(block.state.placing.film, shown.map(({ image }) => image), begunIn(block.state.placing.film, shown));
		if (film !== block.state.placing.film) block.dispatch({
			type: "film",
			film
		});
		if (hasNothingElse(block, pair.store.state)) isAsGiven(pair.store.state);
		const scans = {
			left,
			right: right ?? null
		};
		if (await showFiles(block, modes, pair, putAside, {
			...scans,
			camera: () => film.camera === null ? null : parse_camera(film.camera.text),
			marks: (side) => marksToMeasure(film, scans[side]?.name ?? ""),
			opened: null
		}, here)) measure(pair, "left");
	});
}
function hasNothingElse(block, state) {
	const { placing, options } = block.state;
	const isThere = (side) => {
		if (state.images[side] === null) return true;
		const scan = scanOn(block, state, side);
		return scan !== null && (isInBlock(placing.film, scan) || placing.film.begun.some(({ image }) => image === scan.image));
	};
	const hasMasks = SIDES.every((side) => state.masks[side] === null || state.masks[side].source.kind === "file");
	return SIDES.every(isThere) && hasMasks && otherMasks(options.masks, masksOf(state)).length === 0;
}
function measure({ store, measureMarks }, side) {
	const { photos, tool, mark } = store.state;
	if (tool === "fiducials" && mark?.side === side) return;
	const { fiducials } = photos[side];
	const taken = fiducials.length > 0 ? null : withCoordinatesOf([], photos[otherSide(side)].fiducials);
	if (taken !== null) store.dispatch({
		type: "photo",
		side,
		photo: { fiducials: taken }
	});
	measureMarks(side);
	if (store.state.photos[side].fiducials.length > 0) return;
	setDrawer("settings", true);
	showTab("tab-camera");
	uncoverPictures();
}
export { blockCatalogue, masksOf, matchesOf, mountBlock, openPair, scansBeside };
