import { LANGUAGE, LANGUAGES, LatePart, __vitePreload, arrange, asClauses, asFigure, asSentence, besideFiles, button, byId, count, decimalsOfError, fill, fixed, grouped, h, keepChoice, keptChoice, known as known$1, learnPart, loadPart, markStale, mountLanguage, percent, refusedText as refusedText$1, row, say, scriptAddress, section, sentence, significant, spawnWorker, svg, wasmModule, withMinus, withoutParts } from "./page.js";
// pkg/wasm/tiepoint.js
var BlockOnOrthophoto = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		BlockOnOrthophotoFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_blockonorthophoto_free(ptr, 0);
	}
	linked(block, reference) {
		_assertClass(block, FinishedBlock);
		_assertClass(reference, OrthophotoReference);
		const ret = wasm.blockonorthophoto_linked(this.__wbg_ptr, block.__wbg_ptr, reference.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return FinishedBlock.__wrap(ret[0]);
	}
	constructor() {
		const ret = wasm.blockonorthophoto_new();
		this.__wbg_ptr = ret;
		BlockOnOrthophotoFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	place(block, index, file, reference) {
		_assertClass(block, FinishedBlock);
		_assertClass(reference, OrthophotoReference);
		const ret = wasm.blockonorthophoto_place(this.__wbg_ptr, block.__wbg_ptr, index, file, reference.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) BlockOnOrthophoto.prototype[Symbol.dispose] = BlockOnOrthophoto.prototype.free;
var BlockScene = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		BlockSceneFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_blockscene_free(ptr, 0);
	}
	constructor(flight) {
		const ret = wasm.blockscene_new(flight);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		this.__wbg_ptr = ret[0];
		BlockSceneFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	orthophoto(gsd_m) {
		const ret = wasm.blockscene_orthophoto(this.__wbg_ptr, gsd_m);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	photo(index) {
		const ret = wasm.blockscene_photo(this.__wbg_ptr, index);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	photo_file(index) {
		const ret = wasm.blockscene_photo_file(this.__wbg_ptr, index);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	get photos() {
		return wasm.blockscene_photos(this.__wbg_ptr) >>> 0;
	}
	surface_at(index, positions) {
		const ret = wasm.blockscene_surface_at(this.__wbg_ptr, index, positions);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	truth() {
		return wasm.blockscene_truth(this.__wbg_ptr);
	}
};
if (Symbol.dispose) BlockScene.prototype[Symbol.dispose] = BlockScene.prototype.free;
var BlockWriting = class BlockWriting {
	static __wrap(ptr) {
		const obj = Object.create(BlockWriting.prototype);
		obj.__wbg_ptr = ptr;
		BlockWritingFinalization.register(obj, obj.__wbg_ptr, obj);
		return obj;
	}
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		BlockWritingFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_blockwriting_free(ptr, 0);
	}
	step(emit) {
		const ret = wasm.blockwriting_step(this.__wbg_ptr, emit);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) BlockWriting.prototype[Symbol.dispose] = BlockWriting.prototype.free;
var EpipolarPair = class EpipolarPair {
	static __wrap(ptr) {
		const obj = Object.create(EpipolarPair.prototype);
		obj.__wbg_ptr = ptr;
		EpipolarPairFinalization.register(obj, obj.__wbg_ptr, obj);
		return obj;
	}
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		EpipolarPairFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_epipolarpair_free(ptr, 0);
	}
	get contents() {
		return wasm.epipolarpair_contents(this.__wbg_ptr);
	}
	get geometry() {
		return wasm.epipolarpair_geometry(this.__wbg_ptr);
	}
	get is_swapped() {
		return wasm.epipolarpair_is_swapped(this.__wbg_ptr) !== 0;
	}
	get names() {
		const ret = wasm.epipolarpair_names(this.__wbg_ptr);
		var v1 = getArrayJsValueFromWasm0(ret[0], ret[1]);
		wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
		return v1;
	}
	static open(project, names) {
		const ret = wasm.epipolarpair_open(project, isLikeNone(names) ? 0 : addToExternrefTable0(names));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return EpipolarPair.__wrap(ret[0]);
	}
	resample(left, right) {
		_assertClass(left, Photo);
		_assertClass(right, Photo);
		const ret = wasm.epipolarpair_resample(this.__wbg_ptr, left.__wbg_ptr, right.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	resample_files(left, right) {
		const ret = wasm.epipolarpair_resample_files(this.__wbg_ptr, left, right);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) EpipolarPair.prototype[Symbol.dispose] = EpipolarPair.prototype.free;
var FinishedBlock = class FinishedBlock {
	static __wrap(ptr) {
		const obj = Object.create(FinishedBlock.prototype);
		obj.__wbg_ptr = ptr;
		FinishedBlockFinalization.register(obj, obj.__wbg_ptr, obj);
		return obj;
	}
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		FinishedBlockFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_finishedblock_free(ptr, 0);
	}
	accuracy(cell, sigma_px) {
		const ret = wasm.finishedblock_accuracy(this.__wbg_ptr, isLikeNone(cell) ? 0 : addToExternrefTable0(cell), isLikeNone(sigma_px) ? 0 : addToExternrefTable0(sigma_px));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	carried_edits(before) {
		_assertClass(before, FinishedBlock);
		const ret = wasm.finishedblock_carried_edits(this.__wbg_ptr, before.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	covariances(names) {
		let deferred2_0;
		let deferred2_1;
		try {
			const ret = wasm.finishedblock_covariances(this.__wbg_ptr, names);
			var ptr1 = ret[0];
			var len1 = ret[1];
			if (ret[3]) {
				ptr1 = 0;
				len1 = 0;
				throw takeFromExternrefTable0(ret[2]);
			}
			deferred2_0 = ptr1;
			deferred2_1 = len1;
			return getStringFromWasm0(ptr1, len1);
		} finally {
			wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
		}
	}
	edit_steps() {
		return wasm.finishedblock_edit_steps(this.__wbg_ptr);
	}
	edited(edits, steps) {
		const ret = wasm.finishedblock_edited(this.__wbg_ptr, edits, steps);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return FinishedBlock.__wrap(ret[0]);
	}
	edits() {
		return wasm.finishedblock_edits(this.__wbg_ptr);
	}
	epipolar_line(from, x_px, y_px, to) {
		const ret = wasm.finishedblock_epipolar_line(this.__wbg_ptr, from, x_px, y_px, to);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	export(format, emit) {
		const ret = wasm.finishedblock_export(this.__wbg_ptr, format, emit);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	files(formats, score, language) {
		const ret = wasm.finishedblock_files(this.__wbg_ptr, formats, score, isLikeNone(language) ? 0 : addToExternrefTable0(language));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return BlockWriting.__wrap(ret[0]);
	}
	image_points(image) {
		const ret = wasm.finishedblock_image_points(this.__wbg_ptr, image);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	meeting_place(measurements) {
		const ret = wasm.finishedblock_meeting_place(this.__wbg_ptr, measurements);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		let v1;
		if (ret[0] !== 0) {
			v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
			wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		}
		return v1;
	}
	model() {
		return wasm.finishedblock_model(this.__wbg_ptr);
	}
	on_orthophoto() {
		return wasm.finishedblock_on_orthophoto(this.__wbg_ptr);
	}
	static open(file) {
		const ret = wasm.finishedblock_open(file);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return FinishedBlock.__wrap(ret[0]);
	}
	overview() {
		const ret = wasm.finishedblock_overview(this.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	places() {
		const ret = wasm.finishedblock_places(this.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	places_again(before) {
		const ret = wasm.finishedblock_places_again(this.__wbg_ptr, before);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	point(point) {
		const ret = wasm.finishedblock_point(this.__wbg_ptr, point);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	point_ids() {
		return wasm.finishedblock_point_ids(this.__wbg_ptr);
	}
	point_number(point) {
		const ret = wasm.finishedblock_point_number(this.__wbg_ptr, point);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] === Number.MAX_SAFE_INTEGER ? void 0 : ret[0];
	}
	project() {
		let deferred2_0;
		let deferred2_1;
		try {
			const ret = wasm.finishedblock_project(this.__wbg_ptr);
			var ptr1 = ret[0];
			var len1 = ret[1];
			if (ret[3]) {
				ptr1 = 0;
				len1 = 0;
				throw takeFromExternrefTable0(ret[2]);
			}
			deferred2_0 = ptr1;
			deferred2_1 = len1;
			return getStringFromWasm0(ptr1, len1);
		} finally {
			wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
		}
	}
	score(truth) {
		const ret = wasm.finishedblock_score(this.__wbg_ptr, truth);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) FinishedBlock.prototype[Symbol.dispose] = FinishedBlock.prototype.free;
var OrthoMosaic = class OrthoMosaic {
	static __wrap(ptr) {
		const obj = Object.create(OrthoMosaic.prototype);
		obj.__wbg_ptr = ptr;
		OrthoMosaicFinalization.register(obj, obj.__wbg_ptr, obj);
		return obj;
	}
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		OrthoMosaicFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_orthomosaic_free(ptr, 0);
	}
	add(index, file) {
		const ret = wasm.orthomosaic_add(this.__wbg_ptr, index, file);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	finish() {
		const ptr = this.__destroy_into_raw();
		const ret = wasm.orthomosaic_finish(ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	heights() {
		const ret = wasm.orthomosaic_heights(this.__wbg_ptr);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		let v1;
		if (ret[0] !== 0) {
			v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
			wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		}
		return v1;
	}
	leave_out(index) {
		const ret = wasm.orthomosaic_leave_out(this.__wbg_ptr, index);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	get names() {
		const ret = wasm.orthomosaic_names(this.__wbg_ptr);
		var v1 = getArrayJsValueFromWasm0(ret[0], ret[1]);
		wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
		return v1;
	}
	static open(project, heights, heights_sidecars, gsd, in_adjustment, images) {
		const ret = wasm.orthomosaic_open(project, heights, heights_sidecars, isLikeNone(gsd) ? 0 : addToExternrefTable0(gsd), isLikeNone(in_adjustment) ? 16777215 : in_adjustment ? 1 : 0, isLikeNone(images) ? 0 : addToExternrefTable0(images));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return OrthoMosaic.__wrap(ret[0]);
	}
	order() {
		const ret = wasm.orthomosaic_order(this.__wbg_ptr);
		var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
		return v1;
	}
	remark() {
		return wasm.orthomosaic_remark(this.__wbg_ptr);
	}
	size() {
		const ret = wasm.orthomosaic_size(this.__wbg_ptr);
		var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
		return v1;
	}
};
if (Symbol.dispose) OrthoMosaic.prototype[Symbol.dispose] = OrthoMosaic.prototype.free;
var OrthophotoReference = class OrthophotoReference {
	static __wrap(ptr) {
		const obj = Object.create(OrthophotoReference.prototype);
		obj.__wbg_ptr = ptr;
		OrthophotoReferenceFinalization.register(obj, obj.__wbg_ptr, obj);
		return obj;
	}
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		OrthophotoReferenceFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_orthophotoreference_free(ptr, 0);
	}
	adjust(name, file, given) {
		const ret = wasm.orthophotoreference_adjust(this.__wbg_ptr, name, file, given);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	colours(column, row, width, height, halvings) {
		const ret = wasm.orthophotoreference_colours(this.__wbg_ptr, column, row, width, height, halvings);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	control_by_hand(given) {
		const ret = wasm.orthophotoreference_control_by_hand(this.__wbg_ptr, given);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	elsewhere(positions, options) {
		const ret = wasm.orthophotoreference_elsewhere(this.__wbg_ptr, positions, options);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	ground_positions(placement, positions) {
		const ret = wasm.orthophotoreference_ground_positions(this.__wbg_ptr, placement, positions);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	heights_at(places) {
		const ret = wasm.orthophotoreference_heights_at(this.__wbg_ptr, places);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	image_positions(placement, places) {
		const ret = wasm.orthophotoreference_image_positions(this.__wbg_ptr, placement, places);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	info() {
		return wasm.orthophotoreference_info(this.__wbg_ptr);
	}
	static open(file, sidecars) {
		const ret = wasm.orthophotoreference_open(file, sidecars);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return OrthophotoReference.__wrap(ret[0]);
	}
	picture(column, row, width, height, halvings) {
		const ret = wasm.orthophotoreference_picture(this.__wbg_ptr, column, row, width, height, halvings);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	place(name, file, cameras, film, position) {
		const ret = wasm.orthophotoreference_place(this.__wbg_ptr, name, file, isLikeNone(cameras) ? 0 : addToExternrefTable0(cameras), film, position);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	rectified(file, placement) {
		const ret = wasm.orthophotoreference_rectified(this.__wbg_ptr, file, placement);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	search(options) {
		const ret = wasm.orthophotoreference_search(this.__wbg_ptr, options);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] >>> 0;
	}
	set_heights(heights, sidecars) {
		const ret = wasm.orthophotoreference_set_heights(this.__wbg_ptr, heights, sidecars);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) OrthophotoReference.prototype[Symbol.dispose] = OrthophotoReference.prototype.free;
var Photo = class Photo {
	static __wrap(ptr) {
		const obj = Object.create(Photo.prototype);
		obj.__wbg_ptr = ptr;
		PhotoFinalization.register(obj, obj.__wbg_ptr, obj);
		return obj;
	}
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		PhotoFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_photo_free(ptr, 0);
	}
	static decode(bytes) {
		const ret = wasm.photo_decode(bytes);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return Photo.__wrap(ret[0]);
	}
	describe(point_list, window, strategy) {
		const ret = wasm.photo_describe(this.__wbg_ptr, point_list, window, strategy);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	describe_points(settings, mask) {
		const ret = wasm.photo_describe_points(this.__wbg_ptr, settings, isLikeNone(mask) ? 0 : addToExternrefTable0(mask));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	detect(settings, mask) {
		const ret = wasm.photo_detect(this.__wbg_ptr, settings, isLikeNone(mask) ? 0 : addToExternrefTable0(mask));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	features(options, mask) {
		const ret = wasm.photo_features(this.__wbg_ptr, options, isLikeNone(mask) ? 0 : addToExternrefTable0(mask));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	static from_grey(width, height, grey) {
		const ret = wasm.photo_from_grey(width, height, grey);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return Photo.__wrap(ret[0]);
	}
	grey() {
		const ret = wasm.photo_grey(this.__wbg_ptr);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	get height() {
		return wasm.photo_height(this.__wbg_ptr) >>> 0;
	}
	info() {
		return wasm.photo_info(this.__wbg_ptr);
	}
	reduced(max_side) {
		const ret = wasm.photo_reduced(this.__wbg_ptr, max_side);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	get width() {
		return wasm.photo_width(this.__wbg_ptr) >>> 0;
	}
	window_moments(col, row, window) {
		const ret = wasm.photo_window_moments(this.__wbg_ptr, col, row, window);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) Photo.prototype[Symbol.dispose] = Photo.prototype.free;
var Report = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		ReportFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_report_free(ptr, 0);
	}
	html(language) {
		let deferred2_0;
		let deferred2_1;
		try {
			const ret = wasm.report_html(this.__wbg_ptr, isLikeNone(language) ? 0 : addToExternrefTable0(language));
			var ptr1 = ret[0];
			var len1 = ret[1];
			if (ret[3]) {
				ptr1 = 0;
				len1 = 0;
				throw takeFromExternrefTable0(ret[2]);
			}
			deferred2_0 = ptr1;
			deferred2_1 = len1;
			return getStringFromWasm0(ptr1, len1);
		} finally {
			wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
		}
	}
	constructor(left, right, names, input, settings, truth, left_mask, right_mask, edits) {
		_assertClass(left, Photo);
		_assertClass(right, Photo);
		const ret = wasm.report_new(left.__wbg_ptr, right.__wbg_ptr, names, input, settings, truth, isLikeNone(left_mask) ? 0 : addToExternrefTable0(left_mask), isLikeNone(right_mask) ? 0 : addToExternrefTable0(right_mask), edits);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		this.__wbg_ptr = ret[0];
		ReportFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	step() {
		const ret = wasm.report_step(this.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] !== 0;
	}
	steps(language) {
		const ret = wasm.report_steps(this.__wbg_ptr, isLikeNone(language) ? 0 : addToExternrefTable0(language));
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	verdict() {
		return wasm.report_verdict(this.__wbg_ptr);
	}
};
if (Symbol.dispose) Report.prototype[Symbol.dispose] = Report.prototype.free;
var Run = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		RunFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		if (ptr !== 0) wasm.__wbg_run_free(ptr, 0);
	}
	complete(id, bytes) {
		const ret = wasm.run_complete(this.__wbg_ptr, id, bytes);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	failed(id, failure) {
		const ret = wasm.run_failed(this.__wbg_ptr, id, failure);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	finish() {
		const ptr = this.__destroy_into_raw();
		const ret = wasm.run_finish(ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return FinishedBlock.__wrap(ret[0]);
	}
	found(id, record) {
		const ret = wasm.run_found(this.__wbg_ptr, id, record);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] !== 0;
	}
	constructor(input) {
		const ret = wasm.run_new(input);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		this.__wbg_ptr = ret[0];
		RunFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	news() {
		return wasm.run_news(this.__wbg_ptr);
	}
	next(most) {
		const ret = wasm.run_next(this.__wbg_ptr, most);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	prepare(id, digests) {
		const ret = wasm.run_prepare(this.__wbg_ptr, id, digests);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) Run.prototype[Symbol.dispose] = Run.prototype.free;
function acting_block_parameters(settings) {
	const ret = wasm.acting_block_parameters(settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function acting_parameters(settings) {
	const ret = wasm.acting_parameters(settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function assumed_interior(geometry, left, right) {
	const ret = wasm.assumed_interior(geometry, left, right);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function block_flight_parameters() {
	return wasm.block_flight_parameters();
}
function block_flight_preset(name) {
	const ret = wasm.block_flight_preset(name);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function block_parameters() {
	return wasm.block_parameters();
}
function block_settings(given) {
	const ret = wasm.block_settings(given);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function call_parameters() {
	return wasm.call_parameters();
}
function camera_label(camera, width, height) {
	let deferred2_0;
	let deferred2_1;
	try {
		const ret = wasm.camera_label(camera, width, height);
		var ptr1 = ret[0];
		var len1 = ret[1];
		if (ret[3]) {
			ptr1 = 0;
			len1 = 0;
			throw takeFromExternrefTable0(ret[2]);
		}
		deferred2_0 = ptr1;
		deferred2_1 = len1;
		return getStringFromWasm0(ptr1, len1);
	} finally {
		wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
	}
}
function camera_of_exif(exif) {
	const ret = wasm.camera_of_exif(exif);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function camera_of_focal_px(focal_px) {
	const ret = wasm.camera_of_focal_px(focal_px);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function carried_steps(carrying) {
	const ret = wasm.carried_steps(carrying);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function check_cameras(text, names) {
	const ret = wasm.check_cameras(text, names);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
function check_control(points, marks, names, placing, on_orthophoto) {
	const ret = wasm.check_control(points, marks, names, placing, isLikeNone(on_orthophoto) ? 16777215 : on_orthophoto ? 1 : 0);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
function check_flight(flight) {
	const ret = wasm.check_flight(flight);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
function check_geoid(name, placing) {
	const ret = wasm.check_geoid(name, placing);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
function constant_offset(dx, dy) {
	const ret = wasm.constant_offset(dx, dy);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function defaults() {
	return wasm.defaults();
}
function draw_match_lines(context, matches, codes, widths, colours, left_view, right_view, most) {
	const ret = wasm.draw_match_lines(context, matches, codes, widths, colours, left_view, right_view, most);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return ret[0] >>> 0;
}
function draw_points(context, points, codes, styles, colours, view) {
	const ret = wasm.draw_points(context, points, codes, styles, colours, view);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return ret[0] >>> 0;
}
function draw_vectors(context, vectors, codes, widths, colours, factor, view) {
	const ret = wasm.draw_vectors(context, vectors, codes, widths, colours, factor, view);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return ret[0] >>> 0;
}
function few_matches(matches) {
	const ret = wasm.few_matches(matches);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function film_cameras(pattern, rules, given) {
	const ret = wasm.film_cameras(pattern, rules, given);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function film_measurements(measurements, frames) {
	const ret = wasm.film_measurements(measurements, frames);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function film_pattern(rule, given) {
	let deferred2_0;
	let deferred2_1;
	try {
		const ret = wasm.film_pattern(rule, given);
		var ptr1 = ret[0];
		var len1 = ret[1];
		if (ret[3]) {
			ptr1 = 0;
			len1 = 0;
			throw takeFromExternrefTable0(ret[2]);
		}
		deferred2_0 = ptr1;
		deferred2_1 = len1;
		return getStringFromWasm0(ptr1, len1);
	} finally {
		wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
	}
}
function flight_parameters() {
	return wasm.flight_parameters();
}
function flight_preset(name) {
	const ret = wasm.flight_preset(name);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function flight_presets() {
	return wasm.flight_presets();
}
function geographic_positions(positions) {
	const ret = wasm.geographic_positions(positions);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function image_measurement_table(measurements) {
	let deferred2_0;
	let deferred2_1;
	try {
		const ret = wasm.image_measurement_table(measurements);
		var ptr1 = ret[0];
		var len1 = ret[1];
		if (ret[3]) {
			ptr1 = 0;
			len1 = 0;
			throw takeFromExternrefTable0(ret[2]);
		}
		deferred2_0 = ptr1;
		deferred2_1 = len1;
		return getStringFromWasm0(ptr1, len1);
	} finally {
		wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
	}
}
function interior$1(camera, photo) {
	const ret = wasm.interior(camera, photo);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function local_positions(geographic) {
	const ret = wasm.local_positions(geographic);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function masks_of_images(names, masks) {
	const ret = wasm.masks_of_images(names, masks);
	if (ret[3]) throw takeFromExternrefTable0(ret[2]);
	var v1 = getArrayI32FromWasm0(ret[0], ret[1]).slice();
	wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
	return v1;
}
function message$1(family, message, attribute, language) {
	let deferred2_0;
	let deferred2_1;
	try {
		const ret = wasm.message(family, message, isLikeNone(attribute) ? 0 : addToExternrefTable0(attribute), isLikeNone(language) ? 0 : addToExternrefTable0(language));
		var ptr1 = ret[0];
		var len1 = ret[1];
		if (ret[3]) {
			ptr1 = 0;
			len1 = 0;
			throw takeFromExternrefTable0(ret[2]);
		}
		deferred2_0 = ptr1;
		deferred2_1 = len1;
		return getStringFromWasm0(ptr1, len1);
	} finally {
		wasm.__wbindgen_free(deferred2_0, deferred2_1, 1);
	}
}
function one_image(matches, left_width, left_height, right_width, right_height) {
	const ret = wasm.one_image(matches, left_width, left_height, right_width, right_height);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function orient_fiducials(fiducials, model) {
	const ret = wasm.orient_fiducials(fiducials, model);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function pair_cameras(given, left, right) {
	const ret = wasm.pair_cameras(given, left, right);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function pair_hint(verdict, settings, difference, offset) {
	const ret = wasm.pair_hint(verdict, settings, difference, offset);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function pair_preset(name) {
	const ret = wasm.pair_preset(name);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function pair_presets() {
	return wasm.pair_presets();
}
function paper() {
	return wasm.paper();
}
function parameters() {
	return wasm.parameters();
}
function parse_camera(json) {
	const ret = wasm.parse_camera(json);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function parse_camera_rules(json) {
	const ret = wasm.parse_camera_rules(json);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function parse_fiducials(csv) {
	const ret = wasm.parse_fiducials(csv);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function parse_ground_control_points(text) {
	const ret = wasm.parse_ground_control_points(text);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function parse_image_measurements(text, images) {
	const ret = wasm.parse_image_measurements(text, isLikeNone(images) ? 0 : addToExternrefTable0(images));
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function parse_image_positions(text) {
	const ret = wasm.parse_image_positions(text);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function photo_camera(camera) {
	const ret = wasm.photo_camera(camera);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function placed_tables(names, placed) {
	const ret = wasm.placed_tables(names, placed);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function placing_defaults() {
	return wasm.placing_defaults();
}
function placing_parameters() {
	return wasm.placing_parameters();
}
function positions_of_images(text, names, placing) {
	const ret = wasm.positions_of_images(text, names, placing);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function project_kind(start) {
	const ret = wasm.project_kind(start);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function refused_kind(name, start) {
	const ret = wasm.refused_kind(name, start);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function resolved(settings) {
	const ret = wasm.resolved(settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function rule_names() {
	return wasm.rule_names();
}
function system_coordinates(crs, geographic, heights) {
	const ret = wasm.system_coordinates(crs, geographic, heights);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function system_positions(crs, coordinates, heights) {
	const ret = wasm.system_positions(crs, coordinates, heights);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
function version() {
	let deferred1_0;
	let deferred1_1;
	try {
		const ret = wasm.version();
		deferred1_0 = ret[0];
		deferred1_1 = ret[1];
		return getStringFromWasm0(ret[0], ret[1]);
	} finally {
		wasm.__wbindgen_free(deferred1_0, deferred1_1, 1);
	}
}
function __wbg_get_imports() {
	return {
		__proto__: null,
		"./tiepoint_bg.js": {
			__proto__: null,
			__wbg___wbindgen_debug_string_f249a2a76caa9a55: function(arg0, arg1) {
				const ptr1 = passStringToWasm0(debugString(arg1), wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
				const len1 = WASM_VECTOR_LEN;
				getDataViewMemory0().setInt32((arg0 >>> 0) + 4, len1, true);
				getDataViewMemory0().setInt32((arg0 >>> 0) + 0, ptr1, true);
			},
			__wbg___wbindgen_is_bigint_5fa10641e039d3ef: function(arg0) {
				return typeof arg0 === "bigint";
			},
			__wbg___wbindgen_is_function_741ff2bb612836f5: function(arg0) {
				return typeof arg0 === "function";
			},
			__wbg___wbindgen_is_null_c22311b1cc228e3a: function(arg0) {
				return arg0 === null;
			},
			__wbg___wbindgen_is_object_8b968c3ab8e96595: function(arg0) {
				const val = arg0;
				return typeof val === "object" && val !== null;
			},
			__wbg___wbindgen_is_symbol_f846131a047725ea: function(arg0) {
				return typeof arg0 === "symbol";
			},
			__wbg___wbindgen_is_undefined_be5b34249ff1fc15: function(arg0) {
				return arg0 === void 0;
			},
			__wbg___wbindgen_number_get_934b640d0889af78: function(arg0, arg1) {
				const obj = arg1;
				const ret = typeof obj === "number" ? obj : void 0;
				getDataViewMemory0().setFloat64((arg0 >>> 0) + 8, isLikeNone(ret) ? 0 : ret, true);
				getDataViewMemory0().setInt32((arg0 >>> 0) + 0, !isLikeNone(ret), true);
			},
			__wbg___wbindgen_rethrow_d953c34c2e20677f: function(arg0) {
				throw arg0;
			},
			__wbg___wbindgen_string_get_7ce8eee7fd327545: function(arg0, arg1) {
				const obj = arg1;
				const ret = typeof obj === "string" ? obj : void 0;
				var ptr1 = isLikeNone(ret) ? 0 : passStringToWasm0(ret, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
				var len1 = WASM_VECTOR_LEN;
				getDataViewMemory0().setInt32((arg0 >>> 0) + 4, len1, true);
				getDataViewMemory0().setInt32((arg0 >>> 0) + 0, ptr1, true);
			},
			__wbg___wbindgen_throw_4c88d8bf264fd984: function(arg0, arg1) {
				const words = getStringFromWasm0(arg0, arg1);
				if (words !== "null pointer passed to rust") throw new Error(words);
				const error = {
					kind: "invalid-input",
					refusal: { kind: "freed_object" }
				};
				throw Object.assign(new Error(message$1("error", error)), {
					name: "TiepointError",
					code: "invalid-input",
					usage: false,
					error
				});
			},
			__wbg___wbindgen_typeof_ee4990276e02f607: function(arg0) {
				return typeof arg0;
			},
			__wbg__wbg_cb_unref_09736879a3f67559: function(arg0) {
				arg0._wbg_cb_unref();
			},
			__wbg_arc_df3f7eb77e59876f: function() {
				return handleError(function(arg0, arg1, arg2, arg3, arg4, arg5) {
					arg0.arc(arg1, arg2, arg3, arg4, arg5);
				}, arguments);
			},
			__wbg_assign_6b6bb30388088072: function(arg0, arg1) {
				return Object.assign(arg0, arg1);
			},
			__wbg_beginPath_ab690dc0c7efe6dc: function(arg0) {
				arg0.beginPath();
			},
			__wbg_call_fc92fee6137d452d: function() {
				return handleError(function(arg0, arg1, arg2, arg3) {
					return arg0.call(arg1, arg2, arg3);
				}, arguments);
			},
			__wbg_closePath_e9e11e034c5d75a3: function(arg0) {
				arg0.closePath();
			},
			__wbg_deleteProperty_3ad7a085da623822: function() {
				return handleError(function(arg0, arg1) {
					return Reflect.deleteProperty(arg0, arg1);
				}, arguments);
			},
			__wbg_fill_cb36fe21a8d46cd7: function(arg0) {
				arg0.fill();
			},
			__wbg_from_eac91875c8a5ffa4: function(arg0) {
				return Array.from(arg0);
			},
			__wbg_get_2080c49015e35254: function() {
				return handleError(function(arg0, arg1) {
					return Reflect.get(arg0, arg1);
				}, arguments);
			},
			__wbg_get_unchecked_e6325ad374eff861: function(arg0, arg1) {
				return arg0[arg1 >>> 0];
			},
			__wbg_instanceof_Error_74e3cca0c4a69161: function(arg0) {
				let result;
				try {
					result = arg0 instanceof Error;
				} catch (_) {
					result = false;
				}
				return result;
			},
			__wbg_instanceof_Float32Array_94718abab7dc1d7f: function(arg0) {
				let result;
				try {
					result = arg0 instanceof Float32Array;
				} catch (_) {
					result = false;
				}
				return result;
			},
			__wbg_instanceof_Uint32Array_ba721c3060d01f9a: function(arg0) {
				let result;
				try {
					result = arg0 instanceof Uint32Array;
				} catch (_) {
					result = false;
				}
				return result;
			},
			__wbg_instanceof_Uint8Array_d7aeb0dcb3108fea: function(arg0) {
				let result;
				try {
					result = arg0 instanceof Uint8Array;
				} catch (_) {
					result = false;
				}
				return result;
			},
			__wbg_isArray_bcf1376d0d732d08: function(arg0) {
				return Array.isArray(arg0);
			},
			__wbg_length_03a2b32a9178fe11: function(arg0) {
				return arg0.length;
			},
			__wbg_length_186163212ffe79c3: function(arg0) {
				return arg0.length;
			},
			__wbg_length_5a8bb8abe1e54e15: function(arg0) {
				return arg0.length;
			},
			__wbg_length_6e9d2869242cabf3: function(arg0) {
				return arg0.length;
			},
			__wbg_length_b03a0fabb109b1e9: function(arg0) {
				return arg0.length;
			},
			__wbg_length_c702d06d28b96b72: function(arg0) {
				return arg0.length;
			},
			__wbg_lineTo_91262b25fb37c461: function(arg0, arg1, arg2) {
				arg0.lineTo(arg1, arg2);
			},
			__wbg_message_43d8c8f1d543a349: function(arg0) {
				return arg0.message;
			},
			__wbg_moveTo_b4cd3b0b7e1585a5: function(arg0, arg1, arg2) {
				arg0.moveTo(arg1, arg2);
			},
			__wbg_new_13de428334042d26: function(arg0) {
				return new Uint8Array(arg0);
			},
			__wbg_new_22589e9be6cca455: function(arg0) {
				return new Float64Array(arg0);
			},
			__wbg_new_37eb45aaf5eeb820: function() {
				return new Array();
			},
			__wbg_new_68957d2a912dfa0a: function(arg0) {
				return new Int32Array(arg0);
			},
			__wbg_new_787b9fb330d55d78: function(arg0, arg1) {
				return new Error(getStringFromWasm0(arg0, arg1));
			},
			__wbg_new_a2eeb1f991f36b47: function(arg0) {
				return new Uint32Array(arg0);
			},
			__wbg_new_cd4348290afae586: function() {
				return new Object();
			},
			__wbg_new_from_slice_1ed4a41a79189233: function(arg0, arg1) {
				return new Uint16Array(getArrayU16FromWasm0(arg0, arg1));
			},
			__wbg_new_from_slice_3512352010266e02: function(arg0, arg1) {
				return new Uint32Array(getArrayU32FromWasm0(arg0, arg1));
			},
			__wbg_new_from_slice_355c10c5d8f2addb: function(arg0, arg1) {
				return new Float32Array(getArrayF32FromWasm0(arg0, arg1));
			},
			__wbg_new_from_slice_aaf85a9746711968: function(arg0, arg1) {
				return new Float64Array(getArrayF64FromWasm0(arg0, arg1));
			},
			__wbg_new_from_slice_b8daf545a41c6aa0: function(arg0, arg1) {
				return new Uint8Array(getArrayU8FromWasm0(arg0, arg1));
			},
			__wbg_new_from_slice_e0c60a796e12bb7c: function(arg0, arg1) {
				return new Int32Array(getArrayI32FromWasm0(arg0, arg1));
			},
			__wbg_new_with_length_07edd8a7019b8c30: function(arg0) {
				return new Float64Array(arg0 >>> 0);
			},
			__wbg_parse_c3f72b5a24f83c01: function() {
				return handleError(function(arg0, arg1) {
					return JSON.parse(getStringFromWasm0(arg0, arg1));
				}, arguments);
			},
			__wbg_prototypesetcall_13162965d1fe7aa3: function(arg0, arg1, arg2) {
				Uint8Array.prototype.set.call(getArrayU8FromWasm0(arg0, arg1), arg2);
			},
			__wbg_prototypesetcall_153eecd0d28a42a5: function(arg0, arg1, arg2) {
				Int32Array.prototype.set.call(getArrayI32FromWasm0(arg0, arg1), arg2);
			},
			__wbg_prototypesetcall_22b1bb88c4ec5c5a: function(arg0, arg1, arg2) {
				Float32Array.prototype.set.call(getArrayF32FromWasm0(arg0, arg1), arg2);
			},
			__wbg_prototypesetcall_4aea6470234c8414: function(arg0, arg1, arg2) {
				Uint32Array.prototype.set.call(getArrayU32FromWasm0(arg0, arg1), arg2);
			},
			__wbg_prototypesetcall_a366c038a3918afa: function(arg0, arg1, arg2) {
				Float64Array.prototype.set.call(getArrayF64FromWasm0(arg0, arg1), arg2);
			},
			__wbg_read_c75dcf30dfdc2d25: function() {
				return handleError(function(arg0, arg1, arg2) {
					return arg0.read(arg1, arg2);
				}, arguments);
			},
			__wbg_rect_ab5601e64afdbc33: function(arg0, arg1, arg2, arg3, arg4) {
				arg0.rect(arg1, arg2, arg3, arg4);
			},
			__wbg_set_2793479888329cb6: function() {
				return handleError(function(arg0, arg1, arg2) {
					return Reflect.set(arg0, arg1, arg2);
				}, arguments);
			},
			__wbg_set_fillStyle_95fde67582a9c695: function(arg0, arg1, arg2) {
				arg0.fillStyle = getStringFromWasm0(arg1, arg2);
			},
			__wbg_set_lineWidth_12f039d09cd36dad: function(arg0, arg1) {
				arg0.lineWidth = arg1;
			},
			__wbg_set_name_822e3903f3184979: function(arg0, arg1, arg2) {
				arg0.name = getStringFromWasm0(arg1, arg2);
			},
			__wbg_set_strokeStyle_b90c8a6e0d37c80d: function(arg0, arg1, arg2) {
				arg0.strokeStyle = getStringFromWasm0(arg1, arg2);
			},
			__wbg_size_161b8a6e60abe336: function(arg0) {
				return arg0.size;
			},
			__wbg_stringify_b090af1e2fcbfede: function() {
				return handleError(function(arg0, arg1) {
					return JSON.stringify(arg0, arg1);
				}, arguments);
			},
			__wbg_stroke_19fa3f3ec093bc25: function(arg0) {
				arg0.stroke();
			},
			__wbg_toStringTag_1bdd39ac5d866229: function() {
				return Symbol.toStringTag;
			},
			__wbindgen_generic_0000000000000001: function(arg0, arg1) {
				return makeClosure(arg0, arg1, wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9);
			},
			__wbindgen_generic_0000000000000002: function(arg0) {
				return arg0;
			},
			__wbindgen_generic_0000000000000003: function(arg0, arg1) {
				return getStringFromWasm0(arg0, arg1);
			},
			__wbindgen_init_externref_table: function() {
				const table = wasm.__wbindgen_externrefs;
				table.set(0, void 0);
				table.set(1024, void 0);
				table.set(1025, null);
				table.set(1026, true);
				table.set(1027, false);
			}
		}
	};
}
function wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9(arg0, arg1, arg2, arg3) {
	const ret = wasm.wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9(arg0, arg1, arg2, arg3);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
var BlockOnOrthophotoFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_blockonorthophoto_free(ptr, 1));
var BlockSceneFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_blockscene_free(ptr, 1));
var BlockWritingFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_blockwriting_free(ptr, 1));
var EpipolarPairFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_epipolarpair_free(ptr, 1));
var FinishedBlockFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_finishedblock_free(ptr, 1));
var OrthoMosaicFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_orthomosaic_free(ptr, 1));
var OrthophotoReferenceFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_orthophotoreference_free(ptr, 1));
var PhotoFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_photo_free(ptr, 1));
var ReportFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_report_free(ptr, 1));
var RunFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_run_free(ptr, 1));
function addToExternrefTable0(obj) {
	const idx = wasm.__externref_table_alloc();
	wasm.__wbindgen_externrefs.set(idx, obj);
	return idx;
}
function _assertClass(instance, klass) {
	if (!(instance instanceof klass)) {
		const error = {
			kind: "invalid-argument",
			what: "argument",
			got: instance?.constructor?.name ?? (instance === null ? "null" : typeof instance),
			wanted: klass.name
		};
		throw Object.assign(new Error(message$1("error", error)), {
			name: "TiepointError",
			code: "invalid-input",
			usage: false,
			error
		});
	}
}
var CLOSURE_DTORS = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((state) => wasm.__wbindgen_destroy_closure(state.a, state.b));
function debugString(val) {
	switch (typeof val) {
		case "number":
		case "boolean":
		case "undefined": return `${val}`;
		case "string": return JSON.stringify(val);
		case "bigint": return `${val}n`;
		case "symbol": return val.description !== void 0 ? `Symbol(${val.description})` : "Symbol";
		case "function": return typeof val.name === "string" && val.name !== "" ? `Function(${val.name})` : "Function";
		case "object": {
			if (val === null) return "null";
			if (Array.isArray(val)) return "[" + Array.from(val, debugString).join(", ") + "]";
			if (val instanceof Error) return `${val.name}: ${val.message}\n${val.stack}`;
			const toStringOutput = toString.call(val);
			const className = /\[object ([^\]]+)\]/.exec(toStringOutput)?.[1];
			if (className === void 0) return toStringOutput;
			if (className === "Object") try {
				return "Object(" + JSON.stringify(val) + ")";
			} catch (_) {
				return "Object";
			}
			return className;
		}
	}
}
function getArrayF32FromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return getFloat32ArrayMemory0().subarray(ptr / 4, ptr / 4 + len);
}
function getArrayF64FromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return getFloat64ArrayMemory0().subarray(ptr / 8, ptr / 8 + len);
}
function getArrayI32FromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return getInt32ArrayMemory0().subarray(ptr / 4, ptr / 4 + len);
}
function getArrayJsValueFromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	const mem = getDataViewMemory0();
	const result = [];
	for (let i = ptr; i < ptr + 4 * len; i += 4) result.push(wasm.__wbindgen_externrefs.get(mem.getUint32(i, true)));
	wasm.__externref_drop_slice(ptr, len);
	return result;
}
function getArrayU16FromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return getUint16ArrayMemory0().subarray(ptr / 2, ptr / 2 + len);
}
function getArrayU32FromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return getUint32ArrayMemory0().subarray(ptr / 4, ptr / 4 + len);
}
function getArrayU8FromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return getUint8ArrayMemory0().subarray(ptr / 1, ptr / 1 + len);
}
var cachedDataViewMemory0 = null;
function getDataViewMemory0() {
	if (cachedDataViewMemory0 === null || cachedDataViewMemory0.buffer.detached === true || cachedDataViewMemory0.buffer.detached === void 0 && cachedDataViewMemory0.buffer !== wasm.memory.buffer) cachedDataViewMemory0 = new DataView(wasm.memory.buffer);
	return cachedDataViewMemory0;
}
var cachedFloat32ArrayMemory0 = null;
function getFloat32ArrayMemory0() {
	if (cachedFloat32ArrayMemory0 === null || cachedFloat32ArrayMemory0.byteLength === 0) cachedFloat32ArrayMemory0 = new Float32Array(wasm.memory.buffer);
	return cachedFloat32ArrayMemory0;
}
var cachedFloat64ArrayMemory0 = null;
function getFloat64ArrayMemory0() {
	if (cachedFloat64ArrayMemory0 === null || cachedFloat64ArrayMemory0.byteLength === 0) cachedFloat64ArrayMemory0 = new Float64Array(wasm.memory.buffer);
	return cachedFloat64ArrayMemory0;
}
var cachedInt32ArrayMemory0 = null;
function getInt32ArrayMemory0() {
	if (cachedInt32ArrayMemory0 === null || cachedInt32ArrayMemory0.byteLength === 0) cachedInt32ArrayMemory0 = new Int32Array(wasm.memory.buffer);
	return cachedInt32ArrayMemory0;
}
function getStringFromWasm0(ptr, len) {
	ptr = ptr >>> 0;
	return decodeText(getUint8ArrayMemory0().subarray(ptr, ptr + len));
}
var cachedUint16ArrayMemory0 = null;
function getUint16ArrayMemory0() {
	if (cachedUint16ArrayMemory0 === null || cachedUint16ArrayMemory0.byteLength === 0) cachedUint16ArrayMemory0 = new Uint16Array(wasm.memory.buffer);
	return cachedUint16ArrayMemory0;
}
var cachedUint32ArrayMemory0 = null;
function getUint32ArrayMemory0() {
	if (cachedUint32ArrayMemory0 === null || cachedUint32ArrayMemory0.byteLength === 0) cachedUint32ArrayMemory0 = new Uint32Array(wasm.memory.buffer);
	return cachedUint32ArrayMemory0;
}
var cachedUint8ArrayMemory0 = null;
function getUint8ArrayMemory0() {
	if (cachedUint8ArrayMemory0 === null || cachedUint8ArrayMemory0.byteLength === 0) cachedUint8ArrayMemory0 = new Uint8Array(wasm.memory.buffer);
	return cachedUint8ArrayMemory0;
}
function handleError(f, args) {
	try {
		return f.apply(this, args);
	} catch (e) {
		const idx = addToExternrefTable0(e);
		wasm.__wbindgen_exn_store(idx);
	}
}
function isLikeNone(x) {
	return x === void 0 || x === null;
}
function makeClosure(arg0, arg1, f) {
	const state = {
		a: arg0,
		b: arg1,
		cnt: 1
	};
	const real = (...args) => {
		state.cnt++;
		try {
			return f(state.a, state.b, ...args);
		} finally {
			real._wbg_cb_unref();
		}
	};
	real._wbg_cb_unref = () => {
		if (--state.cnt === 0) {
			wasm.__wbindgen_destroy_closure(state.a, state.b);
			state.a = 0;
			CLOSURE_DTORS.unregister(state);
		}
	};
	CLOSURE_DTORS.register(real, state, state);
	return real;
}
function passStringToWasm0(arg, malloc, realloc) {
	if (realloc === void 0) {
		const buf = cachedTextEncoder.encode(arg);
		const ptr = malloc(buf.length, 1) >>> 0;
		getUint8ArrayMemory0().subarray(ptr, ptr + buf.length).set(buf);
		WASM_VECTOR_LEN = buf.length;
		return ptr;
	}
	let len = arg.length;
	let ptr = malloc(len, 1) >>> 0;
	const mem = getUint8ArrayMemory0();
	let offset = 0;
	for (; offset < len; offset++) {
		const code = arg.charCodeAt(offset);
		if (code > 127) break;
		mem[ptr + offset] = code;
	}
	if (offset !== len) {
		if (offset !== 0) arg = arg.slice(offset);
		ptr = realloc(ptr, len, len = offset + arg.length * 3, 1) >>> 0;
		const view = getUint8ArrayMemory0().subarray(ptr + offset, ptr + len);
		const ret = cachedTextEncoder.encodeInto(arg, view);
		offset += ret.written;
		ptr = realloc(ptr, len, offset, 1) >>> 0;
	}
	WASM_VECTOR_LEN = offset;
	return ptr;
}
function takeFromExternrefTable0(idx) {
	const value = wasm.__wbindgen_externrefs.get(idx);
	wasm.__externref_table_dealloc(idx);
	return value;
}
var cachedTextDecoder = new TextDecoder("utf-8", { ignoreBOM: true });
cachedTextDecoder.decode();
var MAX_SAFARI_DECODE_BYTES = 2146435072;
var numBytesDecoded = 0;
function decodeText(bytes) {
	numBytesDecoded += bytes.length;
	if (numBytesDecoded >= MAX_SAFARI_DECODE_BYTES) {
		cachedTextDecoder = new TextDecoder("utf-8", { ignoreBOM: true });
		cachedTextDecoder.decode();
		numBytesDecoded = bytes.length;
	}
	return cachedTextDecoder.decode(bytes);
}
var cachedTextEncoder = new TextEncoder();
if (!("encodeInto" in cachedTextEncoder)) cachedTextEncoder.encodeInto = function(arg, view) {
	const buf = cachedTextEncoder.encode(arg);
	view.set(buf);
	return {
		read: arg.length,
		written: buf.length
	};
};
var WASM_VECTOR_LEN = 0;
var unloaded = new Proxy({}, { get() {
	throw Object.assign(new Error("the module is not loaded: call load(), the default export of tiepoint, and wait for it first"), {
		name: "TiepointError",
		code: "not-loaded",
		usage: false,
		error: { kind: "not-loaded" }
	});
} });
var wasm = unloaded;
function __wbg_finalize_init(instance, module) {
	wasm = instance.exports;
	cachedDataViewMemory0 = null;
	cachedFloat32ArrayMemory0 = null;
	cachedFloat64ArrayMemory0 = null;
	cachedInt32ArrayMemory0 = null;
	cachedUint16ArrayMemory0 = null;
	cachedUint32ArrayMemory0 = null;
	cachedUint8ArrayMemory0 = null;
	wasm.__wbindgen_start();
	return wasm;
}
async function __wbg_load(module, imports) {
	if (typeof Response === "function" && module instanceof Response) {
		if (!module.ok) throw new Error(`failed to fetch Wasm: ${module.status} ${module.statusText} fetching '${module.url}'`);
		if (typeof WebAssembly.instantiateStreaming === "function") try {
			return await WebAssembly.instantiateStreaming(module, imports);
		} catch (e) {
			if (expectedResponseType(module.type) && module.headers.get("Content-Type") !== "application/wasm") console.warn("`WebAssembly.instantiateStreaming` failed because your server does not serve Wasm with `application/wasm` MIME type. Falling back to `WebAssembly.instantiate` which is slower. Original error:\n", e);
			else throw e;
		}
		const bytes = await module.arrayBuffer();
		return await WebAssembly.instantiate(bytes, imports);
	} else {
		const instance = await WebAssembly.instantiate(module, imports);
		if (instance instanceof WebAssembly.Instance) return {
			instance,
			module
		};
		else return instance;
	}
	function expectedResponseType(type) {
		switch (type) {
			case "basic":
			case "cors":
			case "default": return true;
		}
		return false;
	}
}
var __wbg_init_promise;
async function __wbg_init(module_or_path) {
	if (wasm !== unloaded) return wasm;
	if (__wbg_init_promise === void 0) {
		__wbg_init_promise = __wbg_init_once(module_or_path);
		__wbg_init_promise.catch(() => {
			__wbg_init_promise = void 0;
		});
	}
	return __wbg_init_promise;
}
async function __wbg_init_once(module_or_path) {
	if (module_or_path !== void 0) {
		if (Object.getPrototypeOf(module_or_path) === Object.prototype) ({module_or_path} = module_or_path);
		else console.warn("using deprecated parameters for the initialization function; pass a single object instead");
	}
	const imports = __wbg_get_imports();
	if (typeof module_or_path === "string" || typeof Request === "function" && module_or_path instanceof Request || typeof URL === "function" && module_or_path instanceof URL) module_or_path = fetch(module_or_path);
	const { instance, module } = await __wbg_load(await module_or_path, imports);
	return __wbg_finalize_init(instance, module);
}
// www/shared/text/units.ts
function ofLanguage(unit) {
	return known$1(`unit-${unit.replaceAll(" ", "-").replace("µ", "u")}`);
}
function unitText(unit) {
	return ofLanguage(unit) ?? unit;
}
function withUnit(figure, unit) {
	if (unit === "") return figure;
	const own = ofLanguage(unit);
	return own === null ? `${figure} ${unit}` : asSentence(`${asFigure(figure)} ${own}`);
}
// www/shared/text/options.ts
function optionInLanguage(parameter) {
	const { key, label, help, absent, section, unit } = parameter;
	const name = key.replaceAll(/[._]/gu, "-");
	const own = {
		label: known$1(name) ?? label,
		help: known$1(name, "help") ?? help,
		absent: known$1(name, "absent") ?? absent,
		unit: unitText(unit),
		section: known$1(`section-${section.toLowerCase().replaceAll(" ", "-")}`) ?? section
	};
	if (parameter.kind !== "choice") return {
		...parameter,
		...own
	};
	return {
		...parameter,
		...own,
		labels: parameter.labels.map((text, i) => known$1(name, parameter.values[i] ?? null) ?? text)
	};
}
function catalogueInLanguage(catalogue) {
	const { parameters, flightParameters } = catalogue;
	return {
		...catalogue,
		parameters: parameters.map(optionInLanguage),
		flightParameters: flightParameters.map(optionInLanguage)
	};
}
// www/shared/engine/breath.ts
var breath = () => new Promise((resolve) => setTimeout(resolve));
var PATIENCE_MS$2 = 1e3;
var waiting = new Set();
function whenQuiet(work) {
	const once = () => {
		if (waiting.delete(once)) work();
	};
	waiting.add(once);
	if ("requestIdleCallback" in window) window.requestIdleCallback(once, { timeout: PATIENCE_MS$2 });
	else setTimeout(once);
}
function hasten() {
	for (const work of [...waiting]) work();
}
function afterFrame(callback) {
	let waits = false;
	return () => {
		if (waits) return;
		waits = true;
		requestAnimationFrame(() => setTimeout(() => {
			waits = false;
			callback();
		}));
	};
}
// www/shared/panel/drawers.ts
var NAME$4 = "tiepoint-open";
var AT_FIRST = window.innerHeight >= 900 && window.innerWidth >= 1180 ? "table" : "";
var open$2 = new Set((keptChoice(NAME$4) ?? AT_FIRST).split(" "));
var watchers = [];
var OVER = window.matchMedia("(width < 1180px)");
var ROOM = window.matchMedia("(width >= 1500px)");
var BESIDE$1 = {
	settings: ["details"],
	details: ["settings"]
};
if (OVER.matches) open$2.delete("settings");
ROOM.addEventListener("change", () => !ROOM.matches && isOpen("details") && setDrawer("settings", false));
function watchDrawers(callback) {
	watchers.push(callback);
	callback();
}
function isOpen(drawer) {
	return open$2.has(drawer);
}
function setDrawer(drawer, wanted) {
	if (isOpen(drawer) === wanted) return;
	if (wanted && drawer === "settings") hasten();
	if (wanted) open$2.add(drawer);
	else open$2.delete(drawer);
	if (wanted && !ROOM.matches) for (const other of BESIDE$1[drawer] ?? []) open$2.delete(other);
	keepChoice(NAME$4, [...open$2].filter((name) => name !== "").join(" "));
	for (const callback of watchers) callback();
}
function uncoverPictures() {
	if (OVER.matches) setDrawer("settings", false);
}
function drawerButton(drawer, text, testid, element, name = "") {
	const made = button(text, testid, () => {
		setDrawer(drawer, !isOpen(drawer));
		if (isOpen(drawer)) reveal$1(element);
	});
	if (name !== "") made.ariaLabel = name;
	const close = button("×", `close-${testid}`, () => {
		setDrawer(drawer, false);
		made.focus();
	});
	close.className = "icon close";
	close.setAttribute("aria-label", say("close-3", { text }));
	element.append(close);
	watchDrawers(() => {
		element.classList.toggle("is-closed", !isOpen(drawer));
		made.setAttribute("aria-expanded", String(isOpen(drawer)));
	});
	return made;
}
function reveal$1(element) {
	const { top } = element.getBoundingClientRect();
	if (top < 0 || top > .8 * window.innerHeight) element.scrollIntoView({ block: "start" });
}
// www/shared/panel/lack.ts
var lacks = new WeakMap();
function declareLack(elements, lack) {
	for (const element of elements) {
		const former = lacks.get(element);
		lacks.set(element, former === void 0 ? lack : () => lack() || former());
	}
}
var ownLack = (element) => lacks.get(element)?.() ?? "";
// www/shared/panel/tabs.ts
function tabbed(place, label, tabs) {
	const buttons = tabs.map(([id, text]) => h("button", {
		type: "button",
		role: "tab",
		id: `tab-${id}`,
		testid: `tab-${id}`,
		aria: { controls: `panel-${id}` }
	}, text));
	const panels = tabs.map(([id]) => h("div", {
		class: "panel",
		role: "tabpanel",
		id: `panel-${id}`,
		tabindex: 0,
		aria: { labelledby: `tab-${id}` }
	}));
	const choose = (chosen) => {
		buttons.forEach((tab, i) => {
			tab.setAttribute("aria-selected", String(i === chosen));
			tab.tabIndex = i === chosen ? 0 : -1;
		});
		panels.forEach((panel, i) => {
			panel.hidden = i !== chosen;
		});
	};
	buttons.forEach((tab, i) => {
		tab.addEventListener("click", () => choose(i));
		tab.addEventListener("keydown", (event) => {
			const forward = LANGUAGES[LANGUAGE].direction === "rtl" ? -1 : 1;
			const step = {
				ArrowRight: forward,
				ArrowLeft: -forward
			}[event.key];
			if (step === void 0) return;
			event.preventDefault();
			const next = (i + step + tabs.length) % tabs.length;
			buttons[next]?.click();
			buttons[next]?.focus();
		});
	});
	choose(0);
	return {
		element: h("section", {
			class: place === "dock" ? "dock" : `side of-${place}`,
			aria: { label }
		}, h("h2", { class: "visually-hidden" }, label), h("div", {
			class: "tabs",
			role: "tablist",
			aria: { label }
		}, ...buttons), ...panels),
		panels
	};
}
function showTab(id) {
	document.getElementById(id)?.click();
}
// www/shared/panel/reach.ts
var places = new WeakMap();
function declarePlace(elements, place) {
	for (const element of elements) places.set(element, place);
}
function around(element) {
	const all = [];
	for (let now = element; now !== null; now = now.parentElement) all.push(now);
	return all;
}
var placeOf$1 = (hidden) => {
	const place = places.get(hidden);
	return place?.can?.() === false ? void 0 : place;
};
var isHiddenItself = (element) => element.hasAttribute("hidden");
var isPanel = (element) => element.getAttribute("role") === "tabpanel";
var tabOfPanel = (panel) => document.getElementById(panel.getAttribute("aria-labelledby") ?? "");
function reachable(element) {
	return around(element).filter(isHiddenItself).every((hidden) => placeOf$1(hidden) !== void 0 || isPanel(hidden) && tabOfPanel(hidden)?.hidden === false);
}
function waysTo(element) {
	return around(element).filter(isHiddenItself).reverse().flatMap((one) => placeOf$1(one) ?? []);
}
function partOf(element) {
	return around(element).reverse().flatMap((one) => places.get(one) ?? [])[0] ?? null;
}
function lackOf(element) {
	return around(element).reverse().map((one) => ownLack(one)).find((text) => text !== "") ?? "";
}
function reveal(element) {
	for (const one of around(element).reverse()) {
		if (isHiddenItself(one)) placeOf$1(one)?.show();
		if (one.classList.contains("side")) setDrawer(one.classList.contains("of-settings") ? "settings" : "details", true);
		if (one.classList.contains("dock")) setDrawer("table", true);
		if (isPanel(one) && isHiddenItself(one)) showTab(one.getAttribute("aria-labelledby") ?? "");
		if (one.matches("[id].more, [id].menu") && !element.checkVisibility()) unfold(one.id);
		if (one instanceof HTMLDetailsElement) one.open = true;
	}
}
function unfold(menu) {
	const press = document.querySelector(`[aria-controls="${menu}"][aria-expanded="false"]`);
	if (press?.checkVisibility() === true) press.click();
}
// www/shared/panel/mode.ts
var MODES = [["pair", say("pair")], ["block", say("block")]];
function modeSwitch(modes, show) {
	const skip = document.querySelector(".skip");
	skip?.addEventListener("click", (event) => {
		event.preventDefault();
		document.getElementById(skip.hash.slice(1))?.focus();
	});
	const buttons = MODES.map(([mode, text]) => ({
		mode,
		press: button(text, `mode-${mode}`, () => show(mode))
	}));
	modes.watch(["mode"], ([mode]) => {
		for (const { mode: own, press } of buttons) press.setAttribute("aria-pressed", String(own === mode));
		skip?.setAttribute("href", mode === "pair" ? "#view" : "#block-view");
		document.body.dataset.mode = mode;
	});
	return h("div", {
		class: "mode",
		role: "group",
		aria: { label: say("what-is-matched") }
	}, ...buttons.map(({ press }) => press));
}
function showIn(modes, mode, elements) {
	declarePlace(elements, {
		title: say(mode),
		show: () => modes.dispatch(mode)
	});
	modes.watch(["mode"], ([now]) => {
		for (const element of elements) element.hidden = now !== mode;
	});
}
// www/shared/panel/picker.ts
function fileInput({ testid, label, accept, multiple = false, folder = false }, take) {
	const input = h("input", {
		type: "file",
		class: "visually-hidden",
		tabindex: -1,
		testid: `${testid}-input`,
		aria: { label }
	});
	if (accept !== void 0) input.accept = accept;
	input.multiple = multiple || folder;
	input.webkitdirectory = folder;
	input.addEventListener("change", () => {
		const files = [...input.files ?? []];
		if (files.length > 0) take(files);
		input.value = "";
	});
	return input;
}
function fileButton(text, picked, take, title) {
	const input = fileInput(picked, take);
	return [button(text, picked.testid, () => input.click(), title), input];
}
// www/shared/panel/near.ts
var GAP$1 = 6;
function makeNear(testid, close) {
	const text = h("p", {});
	const shut = button("×", `${testid}-close`, () => {
		const { near } = element.dataset;
		close();
		if (near !== void 0) pressed(near)?.focus();
	});
	shut.className = "icon";
	shut.setAttribute("aria-label", say("close-2"));
	const element = h("div", {
		class: "near",
		testid,
		hidden: true,
		role: "alert"
	}, text, shut);
	const place = () => {
		if (!element.hidden) lay(element, pressed(element.dataset.near ?? ""));
	};
	window.addEventListener("resize", place);
	window.addEventListener("scroll", place, {
		capture: true,
		passive: true
	});
	document.addEventListener("keydown", ({ key, defaultPrevented }) => {
		if (key === "Escape" && !element.hidden && !defaultPrevented) close();
	});
	return {
		element,
		show: (notice) => {
			element.hidden = notice?.near === void 0;
			if (notice?.near === void 0) {
				text.textContent = "";
				return;
			}
			element.dataset.near = notice.near;
			element.dataset.kind = notice.kind;
			if (text.textContent !== notice.text) text.textContent = notice.text;
			place();
		}
	};
}
function pressed(testid) {
	const own = document.querySelector(`[data-testid="${testid}"]`);
	return own?.checkVisibility({ visibilityProperty: true }) === true ? own : document.getElementById("menu");
}
function lay(element, at) {
	const box = at?.getBoundingClientRect() ?? new DOMRect();
	const { width, height } = element.getBoundingClientRect();
	const { clientWidth, clientHeight } = document.documentElement;
	const wanted = getComputedStyle(element).direction === "rtl" ? box.right - width : box.left;
	const below = box.bottom + GAP$1;
	const top = below + height > clientHeight && box.top - GAP$1 - height >= 0 ? box.top - GAP$1 - height : below;
	element.style.left = `${String(Math.max(GAP$1, Math.min(wanted, clientWidth - GAP$1 - width)))}px`;
	element.style.top = `${String(top)}px`;
}
// www/shared/state/store.ts
var Holder = class {
	current;
	reduce;
	listeners = [];
	dispatching = false;
	waiting = [];
	constructor(current, reduce) {
		this.current = current;
		this.reduce = reduce;
	}
	get state() {
		return this.current;
	}
	dispatch(action) {
		this.waiting.push(action);
		if (this.dispatching) return;
		this.dispatching = true;
		try {
			for (let next = this.waiting.shift(); next !== void 0; next = this.waiting.shift()) {
				this.current = this.reduce(this.current, next);
				for (const listener of this.listeners) listener(this.current);
			}
		} finally {
			this.dispatching = false;
		}
	}
	watch(what, callback) {
		const select = typeof what === "function" ? what : (state) => what.map((name) => state[name]);
		let seen = select(this.current);
		this.listeners.push((state) => {
			const values = select(state);
			if (values.every((value, i) => Object.is(value, seen[i]))) return;
			seen = values;
			callback(values);
		});
		callback(seen);
	}
};
// www/shared/crate.ts
function readCatalogue() {
	return {
		version: version(),
		parameters: parameters(),
		defaults: defaults(),
		presets: pair_presets().map((name) => ({
			name,
			settings: pair_preset(name)
		})),
		rules: rule_names(),
		flightParameters: flight_parameters(),
		paper: paper(),
		flights: flight_presets().map((name) => ({
			name,
			flight: flight_preset(name)
		}))
	};
}
// www/shared/text/messages.ts
var WITH_FIGURES = /verdict$|^(?:warning|no_geometry|no_orientation|connection)$/u;
function message(family, of, attribute = null) {
	const text = message$1(family, of, attribute, LANGUAGE).replaceAll("σ0", "σ₀").replaceAll("± ", "±\xA0");
	return asClauses(WITH_FIGURES.test(family) ? grouped(withMinus(text)) : text);
}
function messageOf(thrown) {
	if (!(thrown instanceof Error)) return String(thrown);
	const error = "error" in thrown && LANGUAGE !== "en" ? thrown.error : null;
	return typeof error?.kind === "string" ? message("error", {
		...error,
		kind: error.kind
	}) : thrown.message || thrown.name;
}
// www/shared/engine/client.ts
var CallError = class extends Error {
	failure;
	ended;
	name = "CallError";
	constructor(failure, ended) {
		super(failure.message);
		this.failure = failure;
		this.ended = ended;
	}
};
function breakdownOf(error) {
	if (!(error instanceof CallError) || !error.ended) return null;
	return error.failure.kind === "memory" ? say("the-worker-ran-out-of", { message: error.message }) : say("the-worker-broke-off-at", { message: error.message });
}
var Cancelled = class extends Error {
	name = say("cancelled");
};
var WorkerClient = class {
	name;
	worker = null;
	pending = new Map();
	nextId = 1;
	generation = 0;
	constructor(name) {
		this.name = name;
	}
	async call(call, input, transfer = []) {
		this.worker ??= this.start();
		const worker = this.worker;
		return new Promise((resolve, reject) => {
			const id = this.nextId++;
			this.pending.set(id, {
				resolve,
				reject
			});
			const request = {
				id,
				call,
				input
			};
			if (worker.isReady) {
				worker.handle.postMessage(request, transfer);
				return;
			}
			worker.ready.then(() => {
				if (this.pending.has(id)) worker.handle.postMessage(request, transfer);
			}, (error) => this.end(new CallError(otherFailure(error), true)));
		});
	}
	cancel() {
		this.end(new Cancelled("cancelled"));
	}
	start() {
		const handle = spawnWorker(this.name);
		handle.onmessage = (event) => this.receive(event.data);
		handle.onerror = (event) => {
			event.preventDefault();
			this.end(new CallError({
				kind: "fault",
				code: null,
				message: event.message || say("the-worker-could-not-start")
			}, true));
		};
		const started = {
			handle,
			isReady: false,
			ready: wasmModule().then((module) => {
				const start = { module };
				handle.postMessage(start);
				started.isReady = true;
			})
		};
		return started;
	}
	receive(response) {
		const waiting = this.pending.get(response.id);
		if (waiting === void 0) return;
		this.pending.delete(response.id);
		if ("output" in response) {
			waiting.resolve(response.output);
			return;
		}
		const ended = response.failure.kind === "fault" || response.failure.kind === "memory";
		const error = new CallError(response.failure, ended);
		waiting.reject(error);
		if (ended) this.end(error);
	}
	end(error) {
		this.worker?.handle.terminate();
		this.worker = null;
		this.generation += 1;
		const waiting = [...this.pending.values()];
		this.pending.clear();
		for (const { reject } of waiting) reject(error);
	}
};
function otherFailure(error) {
	return {
		kind: "other",
		code: null,
		message: messageOf(error)
	};
}
// www/shared/state/remember.ts
function remember(compute) {
	let last = null;
	return (...args) => {
		if (last === null || last.args.some((arg, i) => !Object.is(arg, args[i]))) last = {
			args,
			result: compute(...args)
		};
		return last.result;
	};
}
function rememberCodes(compute) {
	let last = new Uint8Array();
	return remember((...args) => {
		const codes = compute(...args);
		if (codes.length !== last.length || codes.some((code, i) => code !== last[i])) last = codes;
		return last;
	});
}
// www/shared/state/history.ts
var NO_HISTORY = {
	edits: [],
	done: 0
};
function recorded({ edits, done }, edit) {
	return {
		edits: [...edits.slice(0, done), edit],
		done: done + 1
	};
}
function wentTo({ edits }, done) {
	return {
		edits,
		done: Math.min(edits.length, Math.max(0, done))
	};
}
function steps({ edits, done }, nameOf) {
	const [last, next] = [edits[done - 1], edits[done]];
	return {
		undo: last === void 0 ? null : nameOf(last),
		redo: next === void 0 ? null : nameOf(next)
	};
}
function inSight({ edits, done }, reach) {
	return {
		from: Math.max(0, done - reach),
		to: Math.min(edits.length, done + reach)
	};
}
// www/shared/state/light.ts
var OWN_LIGHT = {
	brightness: 1,
	contrast: 1
};
var isOwnLight = ({ brightness, contrast }) => brightness === OWN_LIGHT.brightness && contrast === OWN_LIGHT.contrast;
// www/shared/state/plane-map.ts
function mapped({ a, b, c, d, e, f }, x, y) {
	return [a * x + c * y + e, b * x + d * y + f];
}
function inverse({ a, b, c, d, e, f }) {
	const determinant = a * d - b * c;
	const turned = {
		a: d / determinant,
		b: -b / determinant,
		c: -c / determinant,
		d: a / determinant,
		e: 0,
		f: 0
	};
	const [x, y] = mapped(turned, e, f);
	return {
		...turned,
		e: -x,
		f: -y
	};
}
function fitted$2(count, place, least) {
	const [mx, my, mu, mv] = middle$1(count, place);
	let [xx, xy, yy, xu, yu, xv, yv] = [
		0,
		0,
		0,
		0,
		0,
		0,
		0
	];
	for (let i = 0; i < count; i++) {
		const [px, py, pu, pv] = place(i);
		const [x, y, u, v] = [
			px - mx,
			py - my,
			pu - mu,
			pv - mv
		];
		xx += x * x;
		xy += x * y;
		yy += y * y;
		xu += x * u;
		yu += y * u;
		xv += x * v;
		yv += y * v;
	}
	const determinant = xx * yy - xy * xy;
	if (!(determinant > least * xx * yy)) return null;
	const [a, c] = [(yy * xu - xy * yu) / determinant, (xx * yu - xy * xu) / determinant];
	const [b, d] = [(yy * xv - xy * yv) / determinant, (xx * yv - xy * xv) / determinant];
	return {
		a,
		b,
		c,
		d,
		e: mu - a * mx - c * my,
		f: mv - b * mx - d * my
	};
}
function middle$1(count, place) {
	const sum = [
		0,
		0,
		0,
		0
	];
	for (let i = 0; i < count; i++) for (const [k, value] of place(i).entries()) sum[k] = (sum[k] ?? 0) + value;
	return [
		sum[0] / count,
		sum[1] / count,
		sum[2] / count,
		sum[3] / count
	];
}
// www/shared/engine/pool.ts
var MOST_WORKERS = 8;
var WorkerPool = class {
	size = Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency || 1));
	idle = Array.from({ length: this.size }, (_, i) => new WorkerClient(`pool ${String(i + 1)}`));
	all = [...this.idle];
	waiting = [];
	call(call, input, transfer = []) {
		return new Promise((resolve, reject) => {
			const start = (client) => client.call(call, input, transfer).then(resolve, reject);
			this.waiting.push({
				start,
				drop: () => reject(new Cancelled("cancelled"))
			});
			this.next();
		});
	}
	cancel() {
		const { waiting } = this;
		this.waiting = [];
		for (const { drop } of waiting) drop();
		for (const client of this.all) client.cancel();
	}
	next() {
		while (this.waiting.length > 0) {
			const client = this.idle.pop();
			const task = client === void 0 ? void 0 : this.waiting.shift();
			if (client === void 0 || task === void 0) return;
			task.start(client).finally(() => {
				this.idle.push(client);
				this.next();
			});
		}
	}
};
// www/shared/state/camera.ts
function cameraFrom(camera, origin) {
	const pixel = camera.pixel_mm ?? null;
	return camera_of_exif({
		make: null,
		model: null,
		focal_mm: camera.focal_px * (pixel ?? 1),
		pixel_mm: pixel,
		origin,
		lens: camera
	});
}
// www/shared/state/calibrations.ts
var NAME$3 = "tiepoint-cameras";
var MOST$1 = 50;
var all = null;
function read$1() {
	try {
		const kept = JSON.parse(keptChoice(NAME$3) ?? "[]");
		return Array.isArray(kept) ? kept.filter(isCalibration) : [];
	} catch {
		return [];
	}
}
function isCalibration(value) {
	const kept = value ?? {};
	const { label, focalErrorPx, images, at } = kept;
	if (typeof label !== "string" || ![focalErrorPx, images].every(Number.isFinite) || Number.isNaN(new Date(at).getTime())) return false;
	try {
		cameraOfPair(kept);
		return true;
	} catch {
		return false;
	}
}
function remembered$1() {
	all ??= read$1();
	return all;
}
function keep(kept) {
	all = kept.slice(0, MOST$1);
	keepChoice(NAME$3, JSON.stringify(all));
}
var lensOf = ({ radial = [
	0,
	0,
	0
], tangential = [0, 0] }) => JSON.stringify([radial, tangential]);
function calibrationOf(label, recorded) {
	return remembered$1().find((kept) => kept.label === label && lensOf(kept.recorded) === lensOf(recorded)) ?? null;
}
function calibrationBehind(camera) {
	const text = JSON.stringify(camera);
	return remembered$1().find((kept) => JSON.stringify(cameraOfPair(kept)) === text) ?? null;
}
function rememberCalibrations(made) {
	if (made.length > 0) keep([...made, ...remembered$1().filter(({ label }) => !made.some((other) => other.label === label))]);
}
function forgetCalibration(label) {
	keep(remembered$1().filter((kept) => kept.label !== label));
}
function cameraOfPair({ camera }) {
	return cameraFrom(camera, "xmp_calibration");
}
// www/shared/state/pane.ts
var STEPS_OF_PX = 100;
var roundedPx = (value) => Math.round(value * STEPS_OF_PX) / STEPS_OF_PX;
// www/shared/state/columns.ts
function numbers$2(key, label, unit, digits, value, help, told = {}) {
	const known = (row) => value(row) ?? NaN;
	return {
		key,
		label,
		unit,
		help,
		value: known,
		text: digits === 0 ? (row) => count(Number.isNaN(known(row)) ? null : known(row)) : (row) => fixed(known(row), digits),
		...told
	};
}
function words(key, label, value, help) {
	return {
		key,
		label,
		unit: "",
		help,
		value,
		text: value,
		words: true
	};
}
// www/shared/panel/choice.ts
var VECTOR_FACTORS = [
	0,
	10,
	20,
	50,
	100,
	200,
	500,
	1e3
];
function choice(label, testid, options, onChange) {
	const select = h("select", { testid });
	for (const [value, text] of options) select.append(new Option(text, value));
	select.addEventListener("change", () => onChange(select.value));
	return [h("label", { class: "choice" }, h("span", {}, label), select), select];
}
function toggle(label, testid, title, onChange) {
	const made = button(label, testid, () => onChange(made.getAttribute("aria-pressed") !== "true"), title);
	made.setAttribute("aria-pressed", "false");
	return made;
}
function vectorChoice(testid, onChange) {
	const factors = VECTOR_FACTORS.map((factor) => [String(factor), factor === 0 ? say("no-residuals") : `× ${String(factor)}`]);
	return choice(say("residuals"), testid, factors, (value) => onChange(Number(value)));
}
// www/shared/panel/focus.ts
function canHold(element) {
	return element.isConnected && element.closest("[hidden], :disabled") === null;
}
function passFocus(held, others) {
	if (!(held instanceof HTMLElement) || canHold(held)) return;
	const { activeElement } = document;
	if (activeElement !== held && activeElement !== null && activeElement !== document.body) return;
	others.find((other) => other != null && canHold(other))?.focus({ preventScroll: true });
}
// www/shared/view/commands.ts
var known = [];
var declared = () => known;
function declare(commands) {
	known.push(commands);
	return (key, shift) => {
		const name = key.length === 1 ? key.toLowerCase() : key;
		const command = commands.list.find(({ keys, can }) => keys.includes(name) && can?.() !== false);
		command?.run(shift);
		return command !== void 0;
	};
}
var SIGNS = {
	Delete: "Del",
	Escape: "Esc",
	PageDown: "Page Down",
	PageUp: "Page Up",
	ArrowLeft: "←",
	ArrowRight: "→",
	ArrowUp: "↑",
	ArrowDown: "↓",
	"-": "−"
};
var keyText = (key) => SIGNS[key] ?? (key.length === 1 ? key.toUpperCase() : key);
// www/shared/panel/history.ts
var UNDO_KEYS = ["Ctrl+Z"];
var REDO_KEYS = ["Ctrl+Shift+Z", "Ctrl+Y"];
function hasKeys(made, keys) {
	made.setAttribute("aria-keyshortcuts", keys.join(" ").replaceAll("Ctrl", "Control"));
}
function set(made, text, disabled) {
	if (made.textContent !== text) made.textContent = text;
	made.disabled = disabled;
}
function showSteps(undo, redo, history, nameOf) {
	const names = steps(history, nameOf);
	for (const [made, name, keys] of [[
		undo,
		names.undo === null ? say("undo") : say("undo-3", { undo: names.undo }),
		UNDO_KEYS
	], [
		redo,
		names.redo === null ? say("redo") : say("redo-3", { redo: names.redo }),
		REDO_KEYS
	]]) {
		made.title = `${name} (${keys[0]})`;
		hasKeys(made, keys);
		made.setAttribute("aria-label", name);
		made.hidden = history.edits.length === 0;
	}
	declareLack([undo], () => names.undo === null ? say("no-edit-to-undo") : "");
	declareLack([redo], () => names.redo === null ? say("no-edit-to-redo") : "");
	undo.disabled = names.undo === null;
	redo.disabled = names.redo === null;
}
var LISTED = 50;
var reaches = new WeakMap();
function showHistory(host, prefix, first, history, nameOf, go) {
	const { edits, done } = history;
	const reach = reaches.get(host) ?? LISTED;
	const { from, to } = inSight(history, reach);
	const focused = host.contains(document.activeElement);
	const entry = (place, name) => {
		const press = button(name, `${prefix}history-${String(place)}`, () => go(place));
		press.className = "link";
		if (place === done) press.setAttribute("aria-current", "step");
		return h("li", { class: place > done ? "undone" : "" }, press);
	};
	const more = (testid, text) => {
		const press = button(text, `${prefix}history-${testid}`, () => {
			reaches.set(host, 4 * reach);
			showHistory(host, prefix, first, history, nameOf, go);
		});
		press.className = "link";
		return h("li", {}, press);
	};
	const listed = edits.slice(from, to).map((edit, i) => entry(from + i + 1, nameOf(edit)));
	const earlier = from > 0 ? [more("earlier", say("history-earlier", { edits: from }))] : [];
	const later = to < edits.length ? [more("later", say("history-later", { edits: edits.length - to }))] : [];
	fill(host, entry(0, first), ...earlier, ...listed, ...later);
	if (focused) host.querySelector("[aria-current]")?.focus({ preventScroll: true });
}
var hasOwnUndo = (target) => target instanceof Element && target.closest("input:not([type=\"range\"], [type=\"checkbox\"], [type=\"radio\"]), textarea, dialog") !== null;
function undoKeys(isActive, step) {
	const act = declare({
		where: say("anywhere-after-edits"),
		host: document.body,
		list: [{
			keys: UNDO_KEYS,
			does: say("takes-back-the-last-edit"),
			can: isActive,
			run: () => step(-1)
		}, {
			keys: REDO_KEYS,
			does: say("makes-the-edit-again"),
			can: isActive,
			run: () => step(1)
		}]
	});
	document.addEventListener("keydown", (event) => {
		const { target, key } = event;
		if (!(event.ctrlKey || event.metaKey) || event.altKey || hasOwnUndo(target)) return;
		if (act(`Ctrl+${event.shiftKey ? "Shift+" : ""}${key.toUpperCase()}`, event.shiftKey)) event.preventDefault();
	});
}
// www/shared/panel/not-listed.ts
var NotListed = class {
	element;
	constructor(testid, of) {
		this.element = h("span", {
			class: "note",
			id: testid,
			testid,
			hidden: true
		});
		for (const made of of) made.setAttribute("aria-describedby", testid);
	}
	show(others) {
		this.element.hidden = others === 0;
		const text = others === 0 ? "" : say("chosen-not-listed", { others });
		if (this.element.textContent !== text) this.element.textContent = text;
	}
};
// www/shared/state/rows.ts
function ordered(count, columns, { key, descending }) {
	const rows = Uint32Array.from({ length: count }, (_, row) => row);
	const column = columns.find((candidate) => candidate.key === key);
	if (column === void 0) return rows;
	const sign = descending ? -1 : 1;
	const values = Array.from(rows, column.value);
	if (values.some((value) => typeof value === "string")) {
		const words = new Intl.Collator("en", { numeric: true });
		return rows.sort((a, b) => sign * words.compare(String(values[a]), String(values[b])) || a - b);
	}
	const keys = Float64Array.from(values, (value) => typeof value === "number" && !Number.isNaN(value) ? sign * value : Infinity);
	return rows.sort((a, b) => (keys[a] ?? 0) < (keys[b] ?? 0) ? -1 : (keys[a] ?? 0) > (keys[b] ?? 0) ? 1 : a - b);
}
function keptOf(rows, keep) {
	const kept = new Uint32Array(rows.length);
	let length = 0;
	for (const row of rows) if (keep(row)) kept[length++] = row;
	return kept.subarray(0, length);
}
function keeping$1(columns, filter) {
	const tests = columns.flatMap(({ key, value, text, words }) => {
		const condition = filter[key];
		if (condition === void 0 || condition.kind === "contains" !== (words === true)) return [];
		if (condition.kind === "contains") {
			const wanted = condition.text.toLowerCase();
			return [(row) => text(row).toLowerCase().includes(wanted)];
		}
		const [from, to] = [condition.from ?? -Infinity, condition.to ?? Infinity];
		return [(row) => {
			const number = Number(value(row));
			return number >= from && number <= to;
		}];
	});
	const [only = null] = tests;
	return tests.length < 2 ? only : (row) => tests.every((test) => test(row));
}
function maskOf(count, columns, filter) {
	const meets = keeping$1(columns, filter);
	if (meets === null) return null;
	const mask = new Uint8Array(count);
	for (let row = 0; row < count; row++) mask[row] = Number(meets(row));
	return mask;
}
var NUMBER = String.raw`[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?`;
var BETWEEN = new RegExp(`^(${NUMBER})\\s*(?:\\.\\.+|…|–|-|to)\\s*(${NUMBER})$`, "iu");
var LIMIT = new RegExp(`^(>=|<=|≥|≤|>|<)\\s*(${NUMBER})$`, "iu");
var EQUAL = new RegExp(`^=?\\s*(${NUMBER})$`, "iu");
function conditionOf(typed, words) {
	const text = typed.trim();
	if (text === "") return null;
	if (words) return {
		kind: "contains",
		text
	};
	const plain = text.replaceAll("−", "-").replaceAll(/[\u202f ](?=\d{3})/gu, "");
	const between = BETWEEN.exec(plain);
	if (between !== null) return {
		kind: "range",
		from: Number(between[1]),
		to: Number(between[2])
	};
	const limit = LIMIT.exec(plain);
	if (limit !== null) return limited(limit[1] ?? "", Number(limit[2]));
	const equal = EQUAL.exec(plain)?.[1];
	if (equal === void 0) return void 0;
	const half = /e/iu.test(equal) ? 0 : .5 * 10 ** -(equal.split(".")[1]?.length ?? 0);
	return {
		kind: "range",
		from: Number(equal) - half,
		to: Number(equal) + half
	};
}
function limited(sign, number) {
	const next = Math.max(Math.abs(number) * Number.EPSILON, Number.MIN_VALUE);
	if (sign === ">") return {
		kind: "range",
		from: number + next,
		to: null
	};
	if (sign === "<") return {
		kind: "range",
		from: null,
		to: number - next
	};
	return sign === ">=" || sign === "≥" ? {
		kind: "range",
		from: number,
		to: null
	} : {
		kind: "range",
		from: null,
		to: number
	};
}
function conditionText(condition) {
	if (condition === void 0) return "";
	if (condition.kind === "contains") return condition.text;
	const { from, to } = condition;
	if (from !== null && to !== null) return `${String(from)}..${String(to)}`;
	if (from !== null) return limitText(">", "≥", from);
	return to === null ? "" : limitText("<", "≤", to);
}
function limitText(beyond, up, limit) {
	const typed = Math.abs(limit) === Number.MIN_VALUE ? 0 : Number(limit.toPrecision(15));
	const { from, to } = limited(beyond, typed);
	return (from ?? to) === limit ? `${beyond}${String(typed)}` : `${up}${String(limit)}`;
}
function totalOf(column, rows) {
	let [sum, squares, count] = [
		0,
		0,
		0
	];
	for (const row of rows) {
		const value = column.value(row);
		if (typeof value !== "number" || Number.isNaN(value)) continue;
		sum += value;
		squares += value * value;
		count += 1;
	}
	if (count === 0) return NaN;
	return column.total === "sum" ? sum : column.total === "mean" ? sum / count : Math.sqrt(squares / count);
}
function headText({ label, unit }) {
	const text = withoutParts(label).replaceAll(/[\u200e\u200f]/gu, "");
	return unit === "" ? text : `${text} [${unitText(unit)}]`;
}
function guarded(text) {
	return /^'*[=+\-@\t\r]/u.test(text) ? `'${text}` : text;
}
function plain(column, row) {
	const text = withoutParts(column.text(row));
	if (column.words === true) return guarded(text);
	const figure = text.replaceAll(" ", "").replaceAll("−", "-").replace(/^–$/u, "");
	return Number.isNaN(Number(figure)) ? guarded(figure) : figure;
}
function csvOf(columns, rows) {
	const field = (text) => /[",\r\n]/u.test(text) ? `"${text.replaceAll("\"", "\"\"")}"` : text;
	return linesOf(columns, rows, field, ",");
}
function tabbedOf(columns, rows) {
	return linesOf(columns, rows, (text) => text.replaceAll(/[\t\r\n]/gu, " "), "	");
}
function linesOf(columns, rows, field, between) {
	const lines = [columns.map((column) => field(guarded(headText(column)))).join(between)];
	for (const row of rows) lines.push(columns.map((column) => field(plain(column, row))).join(between));
	return `${lines.join("\n")}\n`;
}
// www/shared/view/gestures.ts
var CLICK_SLACK = 5;
var KEY_PAN = 60;
var KEY_ZOOM = 1.25;
var LINE_PX = 24;
var WHEEL_RATE = .0016;
var PINCH_RATE = .01;
var pan = (dx, dy) => (movable, far) => {
	const target = movable.focused();
	const step = KEY_PAN * (far ? 4 : 1);
	if (target !== null) movable.pan(target, dx * step, dy * step);
};
var MOVES = [
	{
		keys: ["ArrowLeft"],
		does: say("moves-the-picture-with-shift"),
		run: pan(1, 0)
	},
	{
		keys: ["ArrowRight"],
		does: say("moves-the-picture-with-shift"),
		run: pan(-1, 0)
	},
	{
		keys: ["ArrowUp"],
		does: say("moves-the-picture-with-shift"),
		run: pan(0, 1)
	},
	{
		keys: ["ArrowDown"],
		does: say("moves-the-picture-with-shift"),
		run: pan(0, -1)
	},
	{
		keys: ["+", "="],
		does: say("key-enlarges"),
		run: (movable) => movable.zoomMiddle(KEY_ZOOM)
	},
	{
		keys: ["-", "_"],
		does: say("makes-smaller"),
		run: (movable) => movable.zoomMiddle(1 / KEY_ZOOM)
	},
	{
		keys: ["0"],
		does: say("shows-the-whole-picture"),
		run: (movable) => movable.fit()
	}
];
function listen(host, movable, keyHost = host) {
	new Gestures(host, movable, keyHost);
}
function listenKeys(host, command) {
	host.addEventListener("keydown", (event) => {
		if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input, select") !== null) return;
		if (command(event.key, event.shiftKey)) event.preventDefault();
	});
}
var Gestures = class {
	host;
	movable;
	presses = new Map();
	target = null;
	clicked = false;
	encloses = false;
	path = [];
	constructor(host, movable, keyHost) {
		this.host = host;
		this.movable = movable;
		host.addEventListener("pointerdown", (event) => this.down(event));
		host.addEventListener("pointermove", (event) => this.move(event));
		host.addEventListener("pointerup", (event) => this.up(event));
		host.addEventListener("pointercancel", (event) => this.leave(event));
		host.addEventListener("pointerleave", () => movable.pointed(null, false));
		host.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
		keyHost.addEventListener("keydown", (event) => this.key(event));
	}
	place(event) {
		const box = this.host.getBoundingClientRect();
		return [event.clientX - box.left, event.clientY - box.top];
	}
	down(event) {
		if (event.button !== 0 || event.target.closest("button") !== null) return;
		const [x, y] = this.place(event);
		const target = this.movable.at(x, y);
		if (target === null) return;
		this.host.setPointerCapture(event.pointerId);
		this.clicked = this.presses.size === 0;
		if (!this.clicked) this.giveUp();
		this.encloses = this.clicked && this.movable.encloses?.(event.shiftKey) === true;
		this.path = [[x, y]];
		this.target = target;
		this.presses.set(event.pointerId, {
			x,
			y,
			startX: x,
			startY: y
		});
		this.movable.grabbed?.(target);
	}
	move(event) {
		const [x, y] = this.place(event);
		const press = this.presses.get(event.pointerId);
		this.movable.pointed([x, y], press !== void 0);
		if (press === void 0 || this.target === null) return;
		if (this.clicked && Math.hypot(x - press.startX, y - press.startY) <= CLICK_SLACK) return;
		this.clicked = false;
		if (this.encloses) {
			this.path.push([x, y]);
			this.movable.enclosed?.(this.target, [press.startX, press.startY], [x, y], false, this.path);
			return;
		}
		const still = [...this.presses].find(([id]) => id !== event.pointerId)?.[1];
		if (still === void 0) this.movable.pan(this.target, x - press.x, y - press.y);
		else this.pinch(this.target, press, still, x, y);
		press.x = x;
		press.y = y;
	}
	pinch(target, moved, still, x, y) {
		const before = Math.hypot(moved.x - still.x, moved.y - still.y);
		const after = Math.hypot(x - still.x, y - still.y);
		this.movable.pan(target, (x - moved.x) / 2, (y - moved.y) / 2);
		if (before > 1 && after > 1) this.movable.zoom(target, after / before, (x + still.x) / 2, (y + still.y) / 2);
	}
	up(event) {
		const press = this.presses.get(event.pointerId);
		if (press === void 0) return;
		this.presses.delete(event.pointerId);
		if (this.clicked) this.movable.pressed(...this.place(event), event.ctrlKey || event.metaKey);
		else if (this.encloses && this.target !== null) this.movable.enclosed?.(this.target, [press.startX, press.startY], this.place(event), true, this.path);
		this.encloses = false;
	}
	leave(event) {
		this.presses.delete(event.pointerId);
		this.giveUp();
	}
	giveUp() {
		if (this.encloses && this.target !== null) this.movable.enclosed?.(this.target, [0, 0], null, false, []);
		this.encloses = false;
	}
	wheel(event) {
		const [x, y] = this.place(event);
		const target = this.movable.at(x, y);
		if (target === null) return;
		event.preventDefault();
		const px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_PX * event.deltaY : event.deltaY;
		this.movable.zoom(target, Math.exp(-(event.ctrlKey ? PINCH_RATE : WHEEL_RATE) * px), x, y);
	}
	key(event) {
		if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input, select, .welcome") !== null) return;
		if ((event.key === "Enter" || event.key === " ") && event.target.closest("button") !== null) return;
		if (this.movable.command(event.key, event.shiftKey) || this.moved(event)) event.preventDefault();
	}
	moved({ key, shiftKey }) {
		const move = MOVES.find(({ keys }) => keys.includes(key));
		move?.run(this.movable, shiftKey);
		return move !== void 0;
	}
};
// www/shared/panel/numberfield.ts
var STAYS = say("the-last-valid-value-stays");
function numberInput(testid, problem, change) {
	const input = h("input", {
		id: `c-${testid}`,
		type: "number",
		testid,
		aria: { describedby: problem.id }
	});
	input.step = "any";
	input.inputMode = "decimal";
	input.addEventListener("change", change);
	return input;
}
function problemLine(testid) {
	return h("p", {
		class: "field-problem",
		id: `c-${testid}-problem`,
		testid: `${testid}-problem`,
		role: "alert"
	});
}
function numberField$1(label, unit, testid, change, problem) {
	const line = problem ?? problemLine(testid);
	const input = numberInput(testid, line, change);
	const name = h("label", { for: input.id }, label, unit === "" ? null : h("span", { class: "unit" }, ` ${unitText(unit)}`));
	return {
		input,
		problem: line,
		element: h("div", { class: "control compact" }, name, input, problem === void 0 ? line : null)
	};
}
function firstRefused(fields) {
	return fields.find(([, input]) => input.getAttribute("aria-invalid") === "true" && typed(input) !== void 0)?.[0] ?? null;
}
function typed({ value, valueAsNumber, validity }) {
	return value === "" && !validity.badInput ? void 0 : valueAsNumber;
}
function mark$1(input, wrong) {
	if (wrong) input.setAttribute("aria-invalid", "true");
	else input.removeAttribute("aria-invalid");
}
function showNumber({ input, problem }, value) {
	if (value == null) input.value = "";
	else if (input.valueAsNumber !== value) input.value = String(value);
	mark$1(input, false);
	problem.textContent = "";
}
function readNumber({ input, problem }, allowed, last) {
	const value = typed(input);
	const instead = value === void 0 ? null : Number.isNaN(value) ? say("a-number") : allowed(value);
	mark$1(input, instead !== null);
	problem.textContent = instead === null ? "" : say("allowed-or-empty", {
		instead,
		stays: STAYS
	});
	return instead === null ? value : last;
}
function readPair(inputs, problem, allowed) {
	const [a, b] = [typed(inputs[0]), typed(inputs[1])];
	const tell = (text, wrong) => {
		problem.textContent = text;
		inputs.forEach((input, i) => {
			mark$1(input, wrong[i] === true);
		});
	};
	if (a === void 0 && b === void 0) {
		tell("", [false, false]);
		return null;
	}
	if (a === void 0 || b === void 0) {
		tell(say("give-both-numbers-or-empty", { stays: STAYS }), [a === void 0, b === void 0]);
		return;
	}
	const instead = Number.isNaN(a + b) ? say("two-numbers") : allowed(a, b);
	if (instead === null) {
		tell("", [false, false]);
		return [a, b];
	}
	const alone = [allowed(a, 0) !== null, allowed(0, b) !== null];
	tell(say("allowed", {
		instead,
		stays: STAYS
	}), alone);
}
// www/shared/files/save.ts
function save(blob, name) {
	const link = document.createElement("a");
	link.href = URL.createObjectURL(blob);
	link.download = name;
	link.click();
	window.setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
	return name;
}
// www/shared/files/tiff-directory.ts
var MOST_ENTRIES = 4096;
var KINDS$1 = new Map([
	[3, [2, (view, at, little) => view.getUint16(at, little)]],
	[4, [4, (view, at, little) => view.getUint32(at, little)]],
	[12, [8, (view, at, little) => view.getFloat64(at, little)]],
	[16, [8, (view, at, little) => Number(view.getBigUint64(at, little))]]
]);
async function tiffDirectory(file) {
	const read = async (from, length) => new DataView(await file.slice(from, from + length).arrayBuffer());
	try {
		const head = await read(0, 16);
		const order = head.getUint16(0);
		const little = order === 18761;
		const version = head.getUint16(2, little);
		if (!little && order !== 19789 || version !== 42 && version !== 43) return null;
		const isBig = version === 43;
		const at = isBig ? Number(head.getBigUint64(8, little)) : head.getUint32(4, little);
		const [before, each, offset] = isBig ? [
			8,
			20,
			12
		] : [
			2,
			12,
			8
		];
		const start = await read(at, before);
		const entries = Math.min(MOST_ENTRIES, isBig ? Number(start.getBigUint64(0, little)) : start.getUint16(0, little));
		const directory = await read(at + before, entries * each);
		const entry = (index) => {
			const own = index * each;
			const type = directory.getUint16(own + 2, little);
			const count = isBig ? Number(directory.getBigUint64(own + 4, little)) : directory.getUint32(own + 4, little);
			const values = async (most) => {
				const kind = KINDS$1.get(type);
				const number = Math.min(most, count);
				if (kind === void 0 || number === 0) return [];
				const [size, value] = kind;
				const isHere = size * count <= each - offset;
				const place = isBig ? Number(directory.getBigUint64(own + offset, little)) : directory.getUint32(own + offset, little);
				const view = isHere ? directory : await read(place, size * number);
				return Array.from({ length: number }, (_, i) => value(view, (isHere ? own + offset : 0) + size * i, little));
			};
			return {
				tag: directory.getUint16(own, little),
				type,
				count,
				from: at + before + own,
				values
			};
		};
		return {
			little,
			entries: Array.from({ length: entries }, (_, index) => entry(index))
		};
	} catch {
		return null;
	}
}
async function geoKeys(directory) {
	const all = await directory.entries.find(({ tag, type }) => tag === 34735 && type === 3)?.values(4 * MOST_ENTRIES) ?? [];
	const keys = new Map();
	for (let at = 4; at + 4 <= all.length; at += 4) if (all[at + 1] === 0) keys.set(all[at] ?? 0, all[at + 3] ?? 0);
	return keys;
}
var GEO_KEYS = 34735;
var [SCALE, TIES, TRANSFORMATION] = [
	33550,
	33922,
	34264
];
var MODEL_TYPE = 1024;
// node_modules/fflate/esm/browser.js
var u8 = Uint8Array;
var u16 = Uint16Array;
var i32 = Int32Array;
var fleb = new u8([
	0,
	0,
	0,
	0,
	0,
	0,
	0,
	0,
	1,
	1,
	1,
	1,
	2,
	2,
	2,
	2,
	3,
	3,
	3,
	3,
	4,
	4,
	4,
	4,
	5,
	5,
	5,
	5,
	0,
	0,
	0,
	0
]);
var fdeb = new u8([
	0,
	0,
	0,
	0,
	1,
	1,
	2,
	2,
	3,
	3,
	4,
	4,
	5,
	5,
	6,
	6,
	7,
	7,
	8,
	8,
	9,
	9,
	10,
	10,
	11,
	11,
	12,
	12,
	13,
	13,
	0,
	0
]);
var clim = new u8([
	16,
	17,
	18,
	0,
	8,
	7,
	9,
	6,
	10,
	5,
	11,
	4,
	12,
	3,
	13,
	2,
	14,
	1,
	15
]);
var freb = function(eb, start) {
	var b = new u16(31);
	for (var i = 0; i < 31; ++i) b[i] = start += 1 << eb[i - 1];
	var r = new i32(b[30]);
	for (var i = 1; i < 30; ++i) for (var j = b[i]; j < b[i + 1]; ++j) r[j] = j - b[i] << 5 | i;
	return {
		b,
		r
	};
};
var _a = freb(fleb, 2);
var fl = _a.b;
var revfl = _a.r;
fl[28] = 258, revfl[258] = 28;
var _b = freb(fdeb, 0);
_b.b;
var revfd = _b.r;
var rev = new u16(32768);
for (var i = 0; i < 32768; ++i) {
	var x = (i & 43690) >> 1 | (i & 21845) << 1;
	x = (x & 52428) >> 2 | (x & 13107) << 2;
	x = (x & 61680) >> 4 | (x & 3855) << 4;
	rev[i] = ((x & 65280) >> 8 | (x & 255) << 8) >> 1;
}
var hMap = (function(cd, mb, r) {
	var s = cd.length;
	var i = 0;
	var l = new u16(mb);
	for (; i < s; ++i) if (cd[i]) ++l[cd[i] - 1];
	var le = new u16(mb);
	for (i = 1; i < mb; ++i) le[i] = le[i - 1] + l[i - 1] << 1;
	var co;
	if (r) {
		co = new u16(1 << mb);
		var rvb = 15 - mb;
		for (i = 0; i < s; ++i) if (cd[i]) {
			var sv = i << 4 | cd[i];
			var r_1 = mb - cd[i];
			var v = le[cd[i] - 1]++ << r_1;
			for (var m = v | (1 << r_1) - 1; v <= m; ++v) co[rev[v] >> rvb] = sv;
		}
	} else {
		co = new u16(s);
		for (i = 0; i < s; ++i) if (cd[i]) co[i] = rev[le[cd[i] - 1]++] >> 15 - cd[i];
	}
	return co;
});
var flt = new u8(288);
for (var i = 0; i < 144; ++i) flt[i] = 8;
for (var i = 144; i < 256; ++i) flt[i] = 9;
for (var i = 256; i < 280; ++i) flt[i] = 7;
for (var i = 280; i < 288; ++i) flt[i] = 8;
var fdt = new u8(32);
for (var i = 0; i < 32; ++i) fdt[i] = 5;
var flm = hMap(flt, 9, 0);
var fdm = hMap(fdt, 5, 0);
var shft = function(p) {
	return (p + 7) / 8 | 0;
};
var slc = function(v, s, e) {
	if (s == null || s < 0) s = 0;
	if (e == null || e > v.length) e = v.length;
	return new u8(v.subarray(s, e));
};
var ec = [
	"unexpected EOF",
	"invalid block type",
	"invalid length/literal",
	"invalid distance",
	"stream finished",
	"no stream handler",
	,
	"no callback",
	"invalid UTF-8 data",
	"extra field too long",
	"date not in range 1980-2099",
	"filename too long",
	"stream finishing",
	"invalid zip data"
];
var err = function(ind, msg, nt) {
	var e = new Error(msg || ec[ind]);
	e.code = ind;
	if (Error.captureStackTrace) Error.captureStackTrace(e, err);
	if (!nt) throw e;
	return e;
};
var wbits = function(d, p, v) {
	v <<= p & 7;
	var o = p / 8 | 0;
	d[o] |= v;
	d[o + 1] |= v >> 8;
};
var wbits16 = function(d, p, v) {
	v <<= p & 7;
	var o = p / 8 | 0;
	d[o] |= v;
	d[o + 1] |= v >> 8;
	d[o + 2] |= v >> 16;
};
var hTree = function(d, mb) {
	var t = [];
	for (var i = 0; i < d.length; ++i) if (d[i]) t.push({
		s: i,
		f: d[i]
	});
	var s = t.length;
	var t2 = t.slice();
	if (!s) return {
		t: et,
		l: 0
	};
	if (s == 1) {
		var v = new u8(t[0].s + 1);
		v[t[0].s] = 1;
		return {
			t: v,
			l: 1
		};
	}
	t.sort(function(a, b) {
		return a.f - b.f;
	});
	t.push({
		s: -1,
		f: 25001
	});
	var l = t[0], r = t[1], i0 = 0, i1 = 1, i2 = 2;
	t[0] = {
		s: -1,
		f: l.f + r.f,
		l,
		r
	};
	while (i1 != s - 1) {
		l = t[t[i0].f < t[i2].f ? i0++ : i2++];
		r = t[i0 != i1 && t[i0].f < t[i2].f ? i0++ : i2++];
		t[i1++] = {
			s: -1,
			f: l.f + r.f,
			l,
			r
		};
	}
	var maxSym = t2[0].s;
	for (var i = 1; i < s; ++i) if (t2[i].s > maxSym) maxSym = t2[i].s;
	var tr = new u16(maxSym + 1);
	var mbt = ln(t[i1 - 1], tr, 0);
	if (mbt > mb) {
		var i = 0, dt = 0;
		var lft = mbt - mb, cst = 1 << lft;
		t2.sort(function(a, b) {
			return tr[b.s] - tr[a.s] || a.f - b.f;
		});
		for (; i < s; ++i) {
			var i2_1 = t2[i].s;
			if (tr[i2_1] > mb) {
				dt += cst - (1 << mbt - tr[i2_1]);
				tr[i2_1] = mb;
			} else break;
		}
		dt >>= lft;
		while (dt > 0) {
			var i2_2 = t2[i].s;
			if (tr[i2_2] < mb) dt -= 1 << mb - tr[i2_2]++ - 1;
			else ++i;
		}
		for (; i >= 0 && dt; --i) {
			var i2_3 = t2[i].s;
			if (tr[i2_3] == mb) {
				--tr[i2_3];
				++dt;
			}
		}
		mbt = mb;
	}
	return {
		t: new u8(tr),
		l: mbt
	};
};
var ln = function(n, l, d) {
	return n.s == -1 ? Math.max(ln(n.l, l, d + 1), ln(n.r, l, d + 1)) : l[n.s] = d;
};
var lc = function(c) {
	var s = c.length;
	while (s && !c[--s]);
	var cl = new u16(++s);
	var cli = 0, cln = c[0], cls = 1;
	var w = function(v) {
		cl[cli++] = v;
	};
	for (var i = 1; i <= s; ++i) if (c[i] == cln && i != s) ++cls;
	else {
		if (!cln && cls > 2) {
			for (; cls > 138; cls -= 138) w(32754);
			if (cls > 2) {
				w(cls > 10 ? cls - 11 << 5 | 28690 : cls - 3 << 5 | 12305);
				cls = 0;
			}
		} else if (cls > 3) {
			w(cln), --cls;
			for (; cls > 6; cls -= 6) w(8304);
			if (cls > 2) w(cls - 3 << 5 | 8208), cls = 0;
		}
		while (cls--) w(cln);
		cls = 1;
		cln = c[i];
	}
	return {
		c: cl.subarray(0, cli),
		n: s
	};
};
var clen = function(cf, cl) {
	var l = 0;
	for (var i = 0; i < cl.length; ++i) l += cf[i] * cl[i];
	return l;
};
var wfblk = function(out, pos, dat) {
	var s = dat.length;
	var o = shft(pos + 2);
	out[o] = s & 255;
	out[o + 1] = s >> 8;
	out[o + 2] = out[o] ^ 255;
	out[o + 3] = out[o + 1] ^ 255;
	for (var i = 0; i < s; ++i) out[o + i + 4] = dat[i];
	return (o + 4 + s) * 8;
};
var wblk = function(dat, out, final, syms, lf, df, eb, li, bs, bl, p) {
	wbits(out, p++, final);
	++lf[256];
	var _a = hTree(lf, 15), dlt = _a.t, mlb = _a.l;
	var _b = hTree(df, 15), ddt = _b.t, mdb = _b.l;
	var _c = lc(dlt), lclt = _c.c, nlc = _c.n;
	var _d = lc(ddt), lcdt = _d.c, ndc = _d.n;
	var lcfreq = new u16(19);
	for (var i = 0; i < lclt.length; ++i) ++lcfreq[lclt[i] & 31];
	for (var i = 0; i < lcdt.length; ++i) ++lcfreq[lcdt[i] & 31];
	var _e = hTree(lcfreq, 7), lct = _e.t, mlcb = _e.l;
	var nlcc = 19;
	for (; nlcc > 4 && !lct[clim[nlcc - 1]]; --nlcc);
	var flen = bl + 5 << 3;
	var ftlen = clen(lf, flt) + clen(df, fdt) + eb;
	var dtlen = clen(lf, dlt) + clen(df, ddt) + eb + 14 + 3 * nlcc + clen(lcfreq, lct) + 2 * lcfreq[16] + 3 * lcfreq[17] + 7 * lcfreq[18];
	if (bs >= 0 && flen <= ftlen && flen <= dtlen) return wfblk(out, p, dat.subarray(bs, bs + bl));
	var lm, ll, dm, dl;
	wbits(out, p, 1 + (dtlen < ftlen)), p += 2;
	if (dtlen < ftlen) {
		lm = hMap(dlt, mlb, 0), ll = dlt, dm = hMap(ddt, mdb, 0), dl = ddt;
		var llm = hMap(lct, mlcb, 0);
		wbits(out, p, nlc - 257);
		wbits(out, p + 5, ndc - 1);
		wbits(out, p + 10, nlcc - 4);
		p += 14;
		for (var i = 0; i < nlcc; ++i) wbits(out, p + 3 * i, lct[clim[i]]);
		p += 3 * nlcc;
		var lcts = [lclt, lcdt];
		for (var it = 0; it < 2; ++it) {
			var clct = lcts[it];
			for (var i = 0; i < clct.length; ++i) {
				var len = clct[i] & 31;
				wbits(out, p, llm[len]), p += lct[len];
				if (len > 15) wbits(out, p, clct[i] >> 5 & 127), p += clct[i] >> 12;
			}
		}
	} else lm = flm, ll = flt, dm = fdm, dl = fdt;
	for (var i = 0; i < li; ++i) {
		var sym = syms[i];
		if (sym > 255) {
			var len = sym >> 18 & 31;
			wbits16(out, p, lm[len + 257]), p += ll[len + 257];
			if (len > 7) wbits(out, p, sym >> 23 & 31), p += fleb[len];
			var dst = sym & 31;
			wbits16(out, p, dm[dst]), p += dl[dst];
			if (dst > 3) wbits16(out, p, sym >> 5 & 8191), p += fdeb[dst];
		} else wbits16(out, p, lm[sym]), p += ll[sym];
	}
	wbits16(out, p, lm[256]);
	return p + ll[256];
};
var deo = new i32([
	65540,
	131080,
	131088,
	131104,
	262176,
	1048704,
	1048832,
	2114560,
	2117632
]);
var et = new u8(0);
var dflt = function(dat, lvl, plvl, pre, post, st) {
	var s = st.z || dat.length;
	var o = new u8(pre + s + 5 * (1 + Math.ceil(s / 7e3)) + post);
	var w = o.subarray(pre, o.length - post);
	var lst = st.l;
	var pos = (st.r || 0) & 7;
	if (lvl) {
		if (pos) w[0] = st.r >> 3;
		var opt = deo[lvl - 1];
		var n = opt >> 13, c = opt & 8191;
		var msk_1 = (1 << plvl) - 1;
		var prev = st.p || new u16(32768), head = st.h || new u16(msk_1 + 1);
		var bs1_1 = Math.ceil(plvl / 3), bs2_1 = 2 * bs1_1;
		var hsh = function(i) {
			return (dat[i] ^ dat[i + 1] << bs1_1 ^ dat[i + 2] << bs2_1) & msk_1;
		};
		var syms = new i32(25e3);
		var lf = new u16(288), df = new u16(32);
		var lc_1 = 0, eb = 0, i = st.i || 0, li = 0, wi = st.w || 0, bs = 0;
		for (; i + 2 < s; ++i) {
			var hv = hsh(i);
			var imod = i & 32767, pimod = head[hv];
			prev[imod] = pimod;
			head[hv] = imod;
			if (wi <= i) {
				var rem = s - i;
				if ((lc_1 > 7e3 || li > 24576) && (rem > 423 || !lst)) {
					pos = wblk(dat, w, 0, syms, lf, df, eb, li, bs, i - bs, pos);
					li = lc_1 = eb = 0, bs = i;
					for (var j = 0; j < 286; ++j) lf[j] = 0;
					for (var j = 0; j < 30; ++j) df[j] = 0;
				}
				var l = 2, d = 0, ch_1 = c, dif = imod - pimod & 32767;
				if (rem > 2 && hv == hsh(i - dif)) {
					var maxn = Math.min(n, rem) - 1;
					var maxd = Math.min(32767, i);
					var ml = Math.min(258, rem);
					while (dif <= maxd && --ch_1 && imod != pimod) {
						if (dat[i + l] == dat[i + l - dif]) {
							var nl = 0;
							for (; nl < ml && dat[i + nl] == dat[i + nl - dif]; ++nl);
							if (nl > l) {
								l = nl, d = dif;
								if (nl > maxn) break;
								var mmd = Math.min(dif, nl - 2);
								var md = 0;
								for (var j = 0; j < mmd; ++j) {
									var ti = i - dif + j & 32767;
									var cd = ti - prev[ti] & 32767;
									if (cd > md) md = cd, pimod = ti;
								}
							}
						}
						imod = pimod, pimod = prev[imod];
						dif += imod - pimod & 32767;
					}
				}
				if (d) {
					syms[li++] = 268435456 | revfl[l] << 18 | revfd[d];
					var lin = revfl[l] & 31, din = revfd[d] & 31;
					eb += fleb[lin] + fdeb[din];
					++lf[257 + lin];
					++df[din];
					wi = i + l;
					++lc_1;
				} else {
					syms[li++] = dat[i];
					++lf[dat[i]];
				}
			}
		}
		for (i = Math.max(i, wi); i < s; ++i) {
			syms[li++] = dat[i];
			++lf[dat[i]];
		}
		pos = wblk(dat, w, lst, syms, lf, df, eb, li, bs, i - bs, pos);
		if (!lst) {
			st.r = pos & 7 | w[pos / 8 | 0] << 3;
			pos -= 7;
			st.h = head, st.p = prev, st.i = i, st.w = wi;
		}
	} else {
		for (var i = st.w || 0; i < s + lst; i += 65535) {
			var e = i + 65535;
			if (e >= s) {
				w[pos / 8 | 0] = lst;
				e = s;
			}
			pos = wfblk(w, pos + 1, dat.subarray(i, e));
		}
		st.i = s;
	}
	return slc(o, 0, pre + shft(pos) + post);
};
var crct = (function() {
	var t = new Int32Array(256);
	for (var i = 0; i < 256; ++i) {
		var c = i, k = 9;
		while (--k) c = (c & 1 && -306674912) ^ c >>> 1;
		t[i] = c;
	}
	return t;
})();
var crc = function() {
	var c = -1;
	return {
		p: function(d) {
			var cr = c;
			for (var i = 0; i < d.length; ++i) cr = crct[cr & 255 ^ d[i]] ^ cr >>> 8;
			c = cr;
		},
		d: function() {
			return ~c;
		}
	};
};
var dopt = function(dat, opt, pre, post, st) {
	if (!st) {
		st = { l: 1 };
		if (opt.dictionary) {
			var dict = opt.dictionary.subarray(-32768);
			var newDat = new u8(dict.length + dat.length);
			newDat.set(dict);
			newDat.set(dat, dict.length);
			dat = newDat;
			st.w = dict.length;
		}
	}
	return dflt(dat, opt.level == null ? 6 : opt.level, opt.mem == null ? st.l ? Math.ceil(Math.max(8, Math.min(13, Math.log(dat.length))) * 1.5) : 20 : 12 + opt.mem, pre, post, st);
};
var mrg = function(a, b) {
	var o = {};
	for (var k in a) o[k] = a[k];
	for (var k in b) o[k] = b[k];
	return o;
};
var wbytes = function(d, b, v) {
	for (; v; ++b) d[b] = v, v >>>= 8;
};
var Deflate = function() {
	function Deflate(opts, cb) {
		if (typeof opts == "function") cb = opts, opts = {};
		this.ondata = cb;
		this.o = opts || {};
		this.s = {
			l: 0,
			i: 32768,
			w: 32768,
			z: 32768
		};
		this.b = new u8(98304);
		if (this.o.dictionary) {
			var dict = this.o.dictionary.subarray(-32768);
			this.b.set(dict, 32768 - dict.length);
			this.s.i = 32768 - dict.length;
		}
	}
	Deflate.prototype.p = function(c, f) {
		this.ondata(dopt(c, this.o, 0, 0, this.s), f);
	};
	Deflate.prototype.push = function(chunk, final) {
		if (!this.ondata) err(5);
		if (this.s.l) err(4);
		var endLen = chunk.length + this.s.z;
		if (endLen > this.b.length) {
			if (endLen > 2 * this.b.length - 32768) {
				var newBuf = new u8(endLen & -32768);
				newBuf.set(this.b.subarray(0, this.s.z));
				this.b = newBuf;
			}
			var split = this.b.length - this.s.z;
			this.b.set(chunk.subarray(0, split), this.s.z);
			this.s.z = this.b.length;
			this.p(this.b, false);
			this.b.set(this.b.subarray(-32768));
			this.b.set(chunk.subarray(split), 32768);
			this.s.z = chunk.length - split + 32768;
			this.s.i = 32766, this.s.w = 32768;
		} else {
			this.b.set(chunk, this.s.z);
			this.s.z += chunk.length;
		}
		this.s.l = final & 1;
		if (this.s.z > this.s.w + 8191 || final) {
			this.p(this.b, final || false);
			this.s.w = this.s.i, this.s.i -= 2;
		}
		if (final) {
			this.s = this.o = {};
			this.b = et;
		}
	};
	Deflate.prototype.flush = function(sync) {
		if (!this.ondata) err(5);
		if (this.s.l) err(4);
		this.p(this.b, false);
		this.s.w = this.s.i, this.s.i -= 2;
		if (sync) {
			var c = new u8(6);
			c[0] = this.s.r >> 3;
			var ep = wfblk(c, this.s.r, et);
			this.s.r = 0;
			this.ondata(c.subarray(0, ep >> 3), false);
		}
	};
	return Deflate;
}();
var te = typeof TextEncoder != "undefined" && new TextEncoder();
var td = typeof TextDecoder != "undefined" && new TextDecoder();
try {
	td.decode(et, { stream: true });
} catch (e) {}
function strToU8(str, latin1) {
	if (latin1) {
		var ar_1 = new u8(str.length);
		for (var i = 0; i < str.length; ++i) ar_1[i] = str.charCodeAt(i);
		return ar_1;
	}
	if (te) return te.encode(str);
	var l = str.length;
	var ar = new u8(str.length + (str.length >> 1));
	var ai = 0;
	var w = function(v) {
		ar[ai++] = v;
	};
	for (var i = 0; i < l; ++i) {
		if (ai + 5 > ar.length) {
			var n = new u8(ai + 8 + (l - i << 1));
			n.set(ar);
			ar = n;
		}
		var c = str.charCodeAt(i);
		if (c < 128 || latin1) w(c);
		else if (c < 2048) w(192 | c >> 6), w(128 | c & 63);
		else if (c > 55295 && c < 57344) c = 65536 + (c & 1047552) | str.charCodeAt(++i) & 1023, w(240 | c >> 18), w(128 | c >> 12 & 63), w(128 | c >> 6 & 63), w(128 | c & 63);
		else w(224 | c >> 12), w(128 | c >> 6 & 63), w(128 | c & 63);
	}
	return slc(ar, 0, ai);
}
var dbf = function(l) {
	return l == 1 ? 3 : l < 6 ? 2 : l == 9 ? 1 : 0;
};
var exfl = function(ex) {
	var le = 0;
	if (ex) for (var k in ex) {
		var l = ex[k].length;
		if (l > 65535) err(9);
		le += l + 4;
	}
	return le;
};
var wzh = function(d, b, f, fn, u, c, ce, co) {
	var fl = fn.length, ex = f.extra, col = co && co.length;
	var exl = exfl(ex);
	wbytes(d, b, ce != null ? 33639248 : 67324752), b += 4;
	if (ce != null) d[b++] = 20, d[b++] = f.os;
	d[b] = 20, b += 2;
	d[b++] = f.flag << 1 | (c < 0 && 8), d[b++] = u && 8;
	d[b++] = f.compression & 255, d[b++] = f.compression >> 8;
	var dt = new Date(f.mtime == null ? Date.now() : f.mtime), y = dt.getFullYear() - 1980;
	if (y < 0 || y > 119) err(10);
	wbytes(d, b, y << 25 | dt.getMonth() + 1 << 21 | dt.getDate() << 16 | dt.getHours() << 11 | dt.getMinutes() << 5 | dt.getSeconds() >> 1), b += 4;
	if (c != -1) {
		wbytes(d, b, f.crc);
		wbytes(d, b + 4, c < 0 ? -c - 2 : c);
		wbytes(d, b + 8, f.size);
	}
	wbytes(d, b + 12, fl);
	wbytes(d, b + 14, exl), b += 16;
	if (ce != null) {
		wbytes(d, b, col);
		wbytes(d, b + 6, f.attrs);
		wbytes(d, b + 10, ce), b += 14;
	}
	d.set(fn, b);
	b += fl;
	if (exl) for (var k in ex) {
		var exf = ex[k], l = exf.length;
		wbytes(d, b, +k);
		wbytes(d, b + 2, l);
		d.set(exf, b + 4), b += 4 + l;
	}
	if (col) d.set(co, b), b += col;
	return b;
};
var wzf = function(o, b, c, d, e) {
	wbytes(o, b, 101010256);
	wbytes(o, b + 8, c);
	wbytes(o, b + 10, c);
	wbytes(o, b + 12, d);
	wbytes(o, b + 16, e);
};
var ZipPassThrough = function() {
	function ZipPassThrough(filename) {
		this.filename = filename;
		this.c = crc();
		this.size = 0;
		this.compression = 0;
	}
	ZipPassThrough.prototype.process = function(chunk, final) {
		this.ondata(null, chunk, final);
	};
	ZipPassThrough.prototype.push = function(chunk, final) {
		if (!this.ondata) err(5);
		this.c.p(chunk);
		this.size += chunk.length;
		if (final) this.crc = this.c.d();
		this.process(chunk, final || false);
	};
	return ZipPassThrough;
}();
var ZipDeflate = function() {
	function ZipDeflate(filename, opts) {
		var _this = this;
		if (!opts) opts = {};
		ZipPassThrough.call(this, filename);
		this.d = new Deflate(opts, function(dat, final) {
			_this.ondata(null, dat, final);
		});
		this.compression = 8;
		this.flag = dbf(opts.level);
	}
	ZipDeflate.prototype.process = function(chunk, final) {
		try {
			this.d.push(chunk, final);
		} catch (e) {
			this.ondata(e, null, final);
		}
	};
	ZipDeflate.prototype.push = function(chunk, final) {
		ZipPassThrough.prototype.push.call(this, chunk, final);
	};
	return ZipDeflate;
}();
var Zip = function() {
	function Zip(cb) {
		this.ondata = cb;
		this.u = [];
		this.d = 1;
	}
	Zip.prototype.add = function(file) {
		var _this = this;
		if (!this.ondata) err(5);
		if (this.d & 2) this.ondata(err(4 + (this.d & 1) * 8, 0, 1), null, false);
		else {
			var f = strToU8(file.filename), fl_1 = f.length;
			var com = file.comment, o = com && strToU8(com);
			var u = fl_1 != file.filename.length || o && com.length != o.length;
			var hl_1 = fl_1 + exfl(file.extra) + 30;
			if (fl_1 > 65535) this.ondata(err(11, 0, 1), null, false);
			var header = new u8(hl_1);
			wzh(header, 0, file, f, u, -1);
			var chks_1 = [header];
			var pAll_1 = function() {
				for (var _i = 0, chks_2 = chks_1; _i < chks_2.length; _i++) {
					var chk = chks_2[_i];
					_this.ondata(null, chk, false);
				}
				chks_1 = [];
			};
			var tr_1 = this.d;
			this.d = 0;
			var ind_1 = this.u.length;
			var uf_1 = mrg(file, {
				f,
				u,
				o,
				t: function() {
					if (file.terminate) file.terminate();
				},
				r: function() {
					pAll_1();
					if (tr_1) {
						var nxt = _this.u[ind_1 + 1];
						if (nxt) nxt.r();
						else _this.d = 1;
					}
					tr_1 = 1;
				}
			});
			var cl_1 = 0;
			file.ondata = function(err, dat, final) {
				if (err) {
					_this.ondata(err, dat, final);
					_this.terminate();
				} else {
					cl_1 += dat.length;
					chks_1.push(dat);
					if (final) {
						var dd = new u8(16);
						wbytes(dd, 0, 134695760);
						wbytes(dd, 4, file.crc);
						wbytes(dd, 8, cl_1);
						wbytes(dd, 12, file.size);
						chks_1.push(dd);
						uf_1.c = cl_1, uf_1.b = hl_1 + cl_1 + 16, uf_1.crc = file.crc, uf_1.size = file.size;
						if (tr_1) uf_1.r();
						tr_1 = 1;
					} else if (tr_1) pAll_1();
				}
			};
			this.u.push(uf_1);
		}
	};
	Zip.prototype.end = function() {
		var _this = this;
		if (this.d & 2) {
			this.ondata(err(4 + (this.d & 1) * 8, 0, 1), null, true);
			return;
		}
		if (this.d) this.e();
		else this.u.push({
			r: function() {
				if (!(_this.d & 1)) return;
				_this.u.splice(-1, 1);
				_this.e();
			},
			t: function() {}
		});
		this.d = 3;
	};
	Zip.prototype.e = function() {
		var bt = 0, l = 0, tl = 0;
		for (var _i = 0, _a = this.u; _i < _a.length; _i++) {
			var f = _a[_i];
			tl += 46 + f.f.length + exfl(f.extra) + (f.o ? f.o.length : 0);
		}
		var out = new u8(tl + 22);
		for (var _b = 0, _c = this.u; _b < _c.length; _b++) {
			var f = _c[_b];
			wzh(out, bt, f, f.f, f.u, -f.c - 2, l, f.o);
			bt += 46 + f.f.length + exfl(f.extra) + (f.o ? f.o.length : 0), l += f.b;
		}
		wzf(out, bt, this.u.length, tl, l);
		this.ondata(null, out, true);
		this.d = 2;
	};
	Zip.prototype.terminate = function() {
		for (var _i = 0, _a = this.u; _i < _a.length; _i++) _a[_i].t();
		this.d = 2;
	};
	return Zip;
}();
// www/shared/engine/archive.ts
var ARCHIVE_TIME = "1980-01-01T00:00:00";
var Archive = class {
	chunks = [];
	zip = new Zip((error, chunk) => {
		if (error !== null) throw error;
		this.chunks.push(chunk);
	});
	add(name, content, compressed) {
		const entry = compressed ? new ZipPassThrough(name) : new ZipDeflate(name, { level: 6 });
		entry.mtime = ARCHIVE_TIME;
		this.zip.add(entry);
		entry.push(content, true);
	}
	end() {
		this.zip.end();
		return new Blob(this.chunks, { type: "application/zip" });
	}
};
// pkg/block/image-files.js
var IMAGE_FILE = /\.(?:jpe?g|png|tiff?|bmp|webp|pgm|ppm|pnm)$/iu;
// www/shared/files/leaving.ts
var ProjectLeft = class extends Error {
	name = "ProjectLeft";
};
var Leaving = class {
	turns = Promise.resolve();
	count = 0;
	inTurn(way) {
		const turn = this.turns.then(way);
		this.turns = turn.catch(() => void 0).then(breath);
		return turn;
	}
	leave() {
		this.count += 1;
	}
	async left() {
		for (let turns = null; turns !== this.turns;) {
			turns = this.turns;
			await turns;
		}
		return this.here();
	}
	async stays() {
		const here = this.here();
		await this.left();
		here();
		return here;
	}
	here() {
		const { count } = this;
		return () => {
			if (this.count !== count) throw new ProjectLeft();
		};
	}
};
async function takeHere(left, take, tell) {
	const here = await left();
	try {
		await take(here);
	} catch (error) {
		if (!(error instanceof ProjectLeft)) throw error;
		await left();
		tell();
	}
}
function doHere(stays, act) {
	return unlessLeft(stays().then(act));
}
async function unlessLeft(action) {
	try {
		await action;
	} catch (error) {
		if (!(error instanceof ProjectLeft)) throw error;
	}
}
var DIRECTORY_BYTES = 65536;
function bytesOfKind([a, b, c, d]) {
	return a === 73 && b === 73 && c === 42 && d === 0 || a === 77 && b === 77 && c === 0 && d === 42 ? DIRECTORY_BYTES : 64;
}
function byReason(files) {
	const names = new Map();
	for (const { name, reason } of files) {
		const of = names.get(reason);
		if (of === void 0) names.set(reason, [name]);
		else of.push(name);
	}
	return names;
}
// www/shared/files/refused.ts
var AT_ONCE = 32;
var NAMED = 5;
async function refusedKinds(files) {
	const refused = new Map();
	for (let first = 0; first < files.length; first += AT_ONCE) {
		const told = await Promise.all(files.slice(first, first + AT_ONCE).map(async (file) => [file, await refusedKind(file)]));
		for (const [file, reason] of told) if (reason !== null) refused.set(file, reason);
	}
	return refused;
}
async function refusedKind(file) {
	const start = await startOf(file, 64);
	const bytes = IMAGE_FILE.test(file.name) ? 64 : bytesOfKind(start);
	const refusal = refused_kind(file.name, bytes > 64 ? await startOf(file, bytes) : start);
	return refusal === null ? null : message("error", refusal);
}
async function startOf(file, length) {
	const start = file.slice(0, length).arrayBuffer();
	return new Uint8Array(await start.catch(() => new ArrayBuffer(0)));
}
function kindsText(kinds) {
	return refusedText([...kinds].map(([{ name }, reason]) => ({
		name,
		reason
	})));
}
function refusedText(refused) {
	return [...byReason(refused)].map(([reason, names]) => say("files-cannot-be-opened", {
		files: names.length,
		names: namesText(names),
		reason: sentence(reason)
	})).join(" ");
}
function namesText(names) {
	const first = names.slice(0, NAMED).join(say("comma-between-names"));
	const more = names.length - NAMED;
	return more > 0 ? say("names-and-more", {
		first,
		more
	}) : first;
}
// www/shared/files/json.ts
var OWN_SETTINGS = "tiepoint_settings";
function fieldsOf(text) {
	let read;
	try {
		read = JSON.parse(text);
	} catch {
		read = null;
	}
	return typeof read === "object" && read !== null ? read : {};
}
// pkg/block/text-of.js
var UTF_16 = [[
	"utf-16le",
	255,
	254
], [
	"utf-16be",
	254,
	255
]];
var OTHERWISE = "windows-1252";
function textOf$3(bytes) {
	const marked = UTF_16.find(([, first, second]) => bytes[0] === first && bytes[1] === second);
	if (marked !== void 0) return new TextDecoder(marked[0]).decode(bytes);
	try {
		return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
	} catch {
		return new TextDecoder(OTHERWISE).decode(bytes);
	}
}
// www/shared/files/text.ts
async function textIn(file) {
	return textOf$3(new Uint8Array(await file.arrayBuffer()));
}
// www/block/files/rasters.ts
var WORLD = /\.(?:tfw|jgw|pgw|bpw|gfw|tifw|tiffw|jpgw|jpegw|pngw|wld)$/iu;
var PROJECTION = /\.prj$/iu;
var TIFF = /\.tiff?$/iu;
var PICTURE = /\.(?:jpe?g|png|bmp|webp|p[gpn]m)$/iu;
var GRID$1 = /\.(?:asc|grd|txt|agr)$/iu;
async function sortRasters(found) {
	const sorted = {
		orthophotos: [],
		heights: [],
		degrees: [],
		worlds: [],
		projections: [],
		others: []
	};
	const worlds = found.filter(({ file }) => WORLD.test(file.name));
	const projections = found.filter(({ file }) => PROJECTION.test(file.name));
	const used = new Set();
	for (const one of found) {
		const { file } = one;
		if (WORLD.test(file.name) || PROJECTION.test(file.name)) continue;
		const [world = null, projection = null] = [worlds, projections].map((beside) => beside.find((other) => stemOf(other) === stemOf(one))?.file ?? null);
		const kind = await kindOf$2(file, world !== null);
		if (kind === "photograph") {
			sorted.others.push(one);
			continue;
		}
		for (const beside of [world, projection]) if (beside !== null) used.add(beside);
		sorted[LISTS[kind]].push({
			file,
			world,
			projection
		});
	}
	sorted.projections = projections.map(({ file }) => file).filter((file) => !used.has(file));
	sorted.worlds = worlds.map(({ file }) => file).filter((file) => !used.has(file));
	return sorted;
}
function asGiven(sorted) {
	const { orthophotos } = sorted;
	if (orthophotos.length < 2) return {
		...sorted,
		taken: 0
	};
	return {
		...sorted,
		orthophotos: [],
		others: [...sorted.others, ...orthophotos.map(({ file }) => ({
			file,
			path: ""
		}))],
		taken: orthophotos.length
	};
}
async function hasGround(found) {
	const { orthophotos, heights, degrees, others } = await sortRasters(found);
	const [picture] = orthophotos;
	const stands = orthophotos.length === 1 && (others.length > 0 || picture?.world !== null || picture.projection !== null);
	return heights.length > 0 || degrees.length > 0 || stands;
}
function stemOf({ file, path }) {
	return (path === "" ? file.name : path).replace(/\.[^./]*$/u, "").toLowerCase();
}
var LISTS = {
	orthophoto: "orthophotos",
	heights: "heights",
	degrees: "degrees"
};
async function kindOf$2(file, hasWorld) {
	if (GRID$1.test(file.name)) return /^\s*(?:ncols|nrows)\s/iu.test(await file.slice(0, 64).text()) ? "heights" : "photograph";
	if (TIFF.test(file.name) || file.type === "image/tiff") return kindOfTiff(await tiffTags(file), hasWorld);
	return hasWorld && (file.type.startsWith("image/") || PICTURE.test(file.name)) ? "orthophoto" : "photograph";
}
var [BITS, SAMPLES, FORMAT] = [
	258,
	277,
	339
];
var UNSIGNED = 1;
function kindOfTiff(tags, hasWorld) {
	const isPlaced = hasWorld || tags.has(TRANSFORMATION) || tags.has(SCALE) && tags.has(TIES) || tags.has(34735);
	if ((tags.get(SAMPLES) ?? 1) === 1 && isPlaced && ((tags.get(FORMAT) ?? UNSIGNED) !== UNSIGNED || (tags.get(BITS) ?? 1) > 16)) return tags.get(1024) === 2 ? "degrees" : "heights";
	return isPlaced ? "orthophoto" : "photograph";
}
var FEW = 64;
async function tiffTags(file) {
	const tags = new Map();
	const directory = await tiffDirectory(file);
	if (directory === null) return tags;
	try {
		for (const { tag, type, count, values } of directory.entries) tags.set(tag, type === 3 && count < FEW ? (await values(1))[0] ?? 0 : 0);
		const kind = (await geoKeys(directory)).get(MODEL_TYPE);
		if (kind !== void 0) tags.set(MODEL_TYPE, kind);
	} catch {}
	return tags;
}
// www/shared/files/keepable.ts
var names = new WeakMap();
function nameOf$1(value, kept) {
	const name = names.get(value) ?? kept ?? randomName();
	names.set(value, name);
	return name;
}
function randomName() {
	return Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
function wrong(name) {
	return new Error(say("the-field-is-damaged", { name }));
}
function objectOf(value, name) {
	if (typeof value !== "object" || value === null || Array.isArray(value)) throw wrong(name);
	return value;
}
function likeOf(value, like, name) {
	if (typeof value !== typeof like || typeof value === "number" && Number.isNaN(value)) throw wrong(name);
	return value;
}
function listOf$1(value, name, element) {
	if (!Array.isArray(value)) throw wrong(name);
	return value.map((one, i) => element(one, `${name}[${String(i)}]`));
}
function positionFrom(value, name) {
	const [x, y, ...more] = listOf$1(value, name, (number, at) => likeOf(number, 0, at));
	if (x === void 0 || y === void 0 || more.length > 0) throw wrong(name);
	return [x, y];
}
function orNull(value, read) {
	return value == null ? null : read(value);
}
function fitted$1(value, defaults, name) {
	const kept = objectOf(value, name);
	const fields = Object.entries(defaults).map(([field, normal]) => {
		const own = kept[field];
		const path = `${name}.${field}`;
		if (own === void 0) return [field, normal];
		if (own === null || normal === null || Array.isArray(normal)) return [field, own];
		if (typeof normal === "object") return [field, fitted$1(own, normal, path)];
		return [field, likeOf(own, normal, path)];
	});
	return Object.fromEntries(fields);
}
// www/shared/files/journal.ts
var SIDE = 64;
var OF_HEAD = 40;
var Journal$1 = class {
	name;
	editFrom;
	bytesOf;
	head = {
		done: 0,
		pieces: 0
	};
	pieces = [];
	constructor(name, editFrom, bytesOf) {
		this.name = name;
		this.editFrom = editFrom;
		this.bytesOf = bytesOf;
	}
	parts({ edits, done }) {
		const parts = new Map();
		const pieces = Math.ceil(edits.length / SIDE);
		this.pieces = Array.from({ length: pieces }, (_, i) => same(this.pieces[i], edits, i * SIDE));
		if (this.head.done !== done || this.head.pieces !== pieces) this.head = {
			done,
			pieces
		};
		if (pieces === 0) return parts;
		parts.set(this.name, {
			value: this.head,
			bytes: OF_HEAD
		});
		for (const [i, piece] of this.pieces.entries()) parts.set(`${this.name}/${String(i)}`, {
			value: piece,
			bytes: this.size(piece)
		});
		return parts;
	}
	read(parts) {
		const value = parts.get(this.name);
		if (value === void 0) return NO_HISTORY;
		const { done, pieces } = objectOf(value, "edits");
		const edits = Array.from({ length: likeOf(pieces, 0, "edits.pieces") }, (_, i) => parts.get(`${this.name}/${String(i)}`)).flatMap((piece, i) => listOf$1(piece, `edits[${String(i)}]`, this.editFrom));
		return {
			edits,
			done: doneFrom(done, edits.length, "edits.done")
		};
	}
	size(edits) {
		return edits.reduce((sum, edit) => sum + this.bytesOf(edit), 0);
	}
};
function doneFrom(value, edits, name) {
	return Math.min(edits, Math.max(0, Math.trunc(likeOf(value, 0, name))));
}
function same(earlier, edits, from) {
	const length = Math.min(SIDE, edits.length - from);
	return earlier?.length === length && earlier.every((edit, i) => edit === edits[from + i]) ? earlier : edits.slice(from, from + length);
}
// www/shared/text/project.ts
function titleOf({ name, images }) {
	if (name !== null) return name;
	const [first, second] = images;
	if (first === void 0) return say("without-images");
	if (second === void 0) return first;
	return images.length === 2 ? say("two-names", {
		first,
		second
	}) : say("and-more-images", {
		first,
		images: images.length - 1
	});
}
function sizeText(bytes) {
	if (bytes < 1e6) return say("kb", { bytes: Math.ceil(bytes / 1e3) });
	if (bytes < 1e9) return `${(bytes / 1e6).toFixed(1)} MB`;
	return `${(bytes / 1e9).toFixed(1)} GB`;
}
// www/shared/state/mode.ts
function isMode(text) {
	return text === "pair" || text === "block";
}
function makeModes() {
	return new Holder({
		mode: "pair",
		isKept: true
	}, (_, to) => typeof to === "string" ? {
		mode: to,
		isKept: false
	} : {
		mode: to.kept,
		isKept: true
	});
}
// www/shared/panel/sideways.ts
function sidewaysNote(testid) {
	return h("p", {
		class: "note sideways",
		hidden: true,
		testid
	}, say("scroll-sideways-for-more-columns"));
}
function watchSideways(note, { scroller, head }) {
	const sized = new ResizeObserver(() => {
		note.hidden = scroller.scrollWidth <= scroller.clientWidth;
	});
	for (const element of [head, scroller]) sized.observe(element);
}
// www/shared/panel/sight.ts
var HIDING = "[hidden], .is-closed";
function isHidden(element) {
	return element.closest(HIDING) !== null;
}
function whenInSight(host, draw) {
	let due = false;
	const observer = new MutationObserver(() => {
		if (!isHidden(host)) show();
	});
	function show() {
		observer.disconnect();
		due = false;
		draw();
	}
	return () => {
		if (!isHidden(host)) return show();
		if (due) return;
		due = true;
		for (let around = host; around !== null; around = around.parentElement) observer.observe(around, {
			attributes: true,
			attributeFilter: ["hidden", "class"]
		});
	};
}
// www/shared/files/csv.ts
var MARK = LANGUAGE === "en" ? "" : "﻿";
function saveCsv(columns, rows, name) {
	save(new Blob([MARK, csvOf(columns, rows)], { type: "text/csv" }), name);
}
// www/shared/panel/rows.ts
var ROW = 24;
var MARGIN = 12;
var COLUMNS$1 = 30;
var RowsInSight = class {
	key;
	row;
	columns = h("colgroup", {});
	head = h("thead", {});
	foot = h("tfoot", {});
	scroller;
	table;
	body = h("tbody", {});
	above = filler();
	below = filler();
	lines = new Map();
	count = 0;
	drawn = [0, 0];
	frame = 0;
	heights = null;
	top = 0;
	constructor(testid, words, key, row) {
		this.key = key;
		this.row = row;
		this.table = h("table", {
			testid,
			class: "statistics",
			role: "grid",
			tabindex: 0,
			aria: { label: words.table }
		}, this.columns, this.head, this.body, this.foot);
		this.scroller = h("div", {
			class: "rows",
			role: "region",
			aria: { label: words.region }
		}, this.table);
		this.scroller.addEventListener("scroll", () => this.scrolled());
		new ResizeObserver(() => {
			this.laidOut();
			this.draw();
		}).observe(this.scroller);
		const fixed = new ResizeObserver(() => this.laidOut());
		for (const part of [this.head, this.foot]) fixed.observe(part);
	}
	laidOut() {
		this.top = this.scroller.scrollTop;
		const heights = {
			all: this.scroller.clientHeight,
			fixed: this.head.offsetHeight + this.foot.offsetHeight
		};
		this.heights = heights.all === 0 ? null : heights;
		return heights;
	}
	get room() {
		const { all, fixed } = this.heights ?? this.laidOut();
		return all - fixed;
	}
	show(count) {
		this.count = count;
		this.draw();
	}
	reveal(place, near = false) {
		const { room } = this;
		const top = place * ROW;
		if (place >= 0 && top < this.top) this.scrollTo(near ? top : Math.max(0, top - room / 2));
		else if (place >= 0 && top + ROW > this.top + room) this.scrollTo(near ? top + ROW - room : Math.max(0, top - room / 2));
		this.draw();
	}
	scrollTo(top) {
		this.scroller.scrollTop = top;
		this.top = this.scroller.scrollTop;
	}
	get page() {
		return Math.max(1, Math.floor(this.room / ROW) - 1);
	}
	markOrder(key, descending) {
		for (const cell of this.head.querySelectorAll("tr:first-child > th")) cell.setAttribute("aria-sort", cell.dataset.key === key ? descending ? "descending" : "ascending" : "none");
	}
	scrolled() {
		this.top = this.scroller.scrollTop;
		const [first, last] = this.inSight(0);
		if (first >= this.drawn[0] && last <= this.drawn[1]) return;
		if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
	}
	inSight(margin) {
		const { all, fixed } = this.heights ?? this.laidOut();
		const top = Math.min(this.top, Math.max(0, this.count * ROW + Math.min(0, fixed - all)));
		return [Math.max(0, Math.floor(top / ROW) - margin), Math.min(this.count, Math.ceil((top + all) / ROW) + margin)];
	}
	draw() {
		cancelAnimationFrame(this.frame);
		this.frame = 0;
		if (isHidden(this.scroller)) return;
		const [first, last] = this.inSight(MARGIN);
		this.drawn = [first, last];
		this.table.removeAttribute("aria-activedescendant");
		const lines = new Map();
		for (let place = first; place < last; place++) {
			const key = this.key(place);
			lines.set(key, this.row(place, this.lines.get(key)));
		}
		this.lines = lines;
		stretch(this.above, first);
		stretch(this.below, this.count - last);
		arrange(this.body, this.above, ...lines.values(), this.below);
	}
};
function sortHead({ key, label, unit, help, words }, press) {
	const button = h("button", {
		type: "button",
		class: "sort",
		testid: `sort-${key}`,
		title: help
	}, label, unit === "" ? null : h("span", { class: "unit" }, ` ${unitText(unit)}`));
	button.addEventListener("click", press);
	return h("th", {
		scope: "col",
		key,
		class: words === true ? "of-words" : ""
	}, button);
}
function filler() {
	return h("tr", {
		class: "filler",
		aria: { hidden: "true" }
	}, h("td", { colspan: COLUMNS$1 }));
}
function stretch(filler, rows) {
	const cell = filler.firstElementChild;
	const height = `${String(Math.max(0, rows) * ROW)}px`;
	if (cell.style.height !== height) cell.style.height = height;
}
// www/shared/panel/table-bar.ts
var TableBar = class {
	doing;
	element;
	rows = h("span", {});
	caption;
	list = h("div", { class: "menu" });
	clear;
	hidden;
	name;
	constructor(testid, words, doing, tools) {
		this.doing = doing;
		this.name = `tiepoint-hidden-${testid}`;
		this.hidden = new Set((keptChoice(this.name) ?? "").split(" ").filter((key) => key !== ""));
		this.caption = h("span", {
			class: "note",
			role: "status",
			testid: `${testid}-caption`,
			aria: {
				live: "polite",
				atomic: "true"
			}
		}, h("span", { class: "rows-of" }, `${words}: `), this.rows);
		this.clear = button(say("show-all"), `${testid}-clear`, doing.clear, say("takes-away-what-is-typed"));
		const csv = button("CSV", `${testid}-csv`, doing.csv, say("saves-the-rows-and-columns"));
		const copy = button(say("copy-2"), `${testid}-copy`, () => void this.copy(copy), say("copies-the-rows-and-columns"));
		const columns = button(say("columns"), `${testid}-columns`, () => this.unfold(columns, this.list.classList.toggle("is-open")));
		columns.setAttribute("aria-expanded", "false");
		const menu = h("div", { class: "exports" }, columns, this.list);
		menu.addEventListener("keydown", (event) => {
			if (event.key !== "Escape") return;
			this.unfold(columns, false);
			columns.focus();
		});
		menu.addEventListener("focusout", (event) => {
			if (!menu.contains(event.relatedTarget)) this.unfold(columns, false);
		});
		this.element = h("div", { class: "table-bar" }, this.caption, ...tools, this.clear, menu, copy, csv);
	}
	say(shown, all, filtered, clears) {
		const text = `${filtered ? say("of-8", { shown: count(shown) }) : ""}${count(all)}`;
		if (this.rows.textContent !== text) this.rows.textContent = text;
		this.clear.hidden = !clears;
	}
	get left() {
		return this.hidden;
	}
	offer(columns) {
		fill(this.list, ...columns.map(({ key, label, unit }) => {
			const box = h("input", {
				type: "checkbox",
				key
			});
			box.checked = !this.hidden.has(key);
			box.addEventListener("change", () => {
				if (box.checked) this.hidden.delete(key);
				else this.hidden.add(key);
				keepChoice(this.name, [...this.hidden].join(" "));
				this.doing.hide(this.hidden);
			});
			return h("label", { class: "choice" }, box, unit === "" ? label : `${label} ${unitText(unit)}`);
		}));
		return this.hidden;
	}
	unfold(columns, open) {
		this.list.classList.toggle("is-open", open);
		columns.setAttribute("aria-expanded", String(open));
	}
	async copy(press) {
		tellOn(press, await toClipboard(this.doing.copied()) ? say("copied") : say("not-copied"));
	}
};
function tellOn(press, text) {
	const own = press.dataset.own ?? press.textContent;
	press.dataset.own = own;
	press.textContent = text;
	window.setTimeout(() => fill(press, own), 2e3);
}
async function toClipboard(text) {
	try {
		await navigator.clipboard.writeText(text);
		return true;
	} catch {
		const field = h("textarea", {
			class: "visually-hidden",
			aria: { hidden: "true" }
		});
		field.value = text;
		document.body.append(field);
		field.select();
		const done = document.execCommand("copy");
		field.remove();
		return done;
	}
}
// www/shared/panel/table.ts
var ALL$1 = () => true;
var NONE$2 = new Set();
function sameHeads(a, b) {
	const head = ({ key, label, unit, help, words }) => [
		key,
		label,
		unit,
		help,
		words
	].join("\n");
	return a.length === b.length && a.every((column, i) => head(column) === head(b[i] ?? column));
}
var MEASURED$1 = 200;
var TOTALS = {
	sum: "Σ",
	mean: say("mean"),
	rms: "RMS"
};
var Table = class {
	options;
	help;
	problem;
	table;
	bar;
	all = [];
	columns = [];
	count = 0;
	keep = ALL$1;
	conditions = {};
	shown = new Uint32Array();
	order;
	inOrder = remember(ordered);
	marked = -1;
	anchor = -1;
	active = -1;
	constructor(host, options) {
		this.options = options;
		this.order = {
			key: options.order ?? "",
			descending: false
		};
		const { testid, words, file } = options;
		this.help = h("p", {
			class: "help",
			hidden: true,
			testid: `${testid}-help`
		});
		this.problem = h("p", {
			class: "field-problem",
			id: `${testid}-filter-problem`,
			testid: `${testid}-filter-problem`,
			role: "status",
			aria: { live: "polite" }
		});
		this.table = new RowsInSight(testid, words, (place) => this.shown[place] ?? -1, (place, former) => this.row(this.shown[place] ?? 0, place, former));
		this.bar = file === void 0 ? null : new TableBar(testid, words.table, {
			hide: (hidden) => this.hide(hidden),
			csv: () => saveCsv(this.columns, this.shown, file),
			copied: () => tabbedOf(this.columns, this.shown),
			clear: () => {
				if (options.showAll === void 0) options.filter?.({});
				else options.showAll();
			}
		}, options.tools ?? []);
		host.append(...this.bar === null ? [] : [this.bar.element], this.help, this.problem, this.table.scroller);
		this.table.table.addEventListener("keydown", (event) => this.key(event));
		if (options.choose !== void 0 && (options.chooseMore !== void 0 || options.isChosen !== void 0)) this.table.table.setAttribute("aria-multiselectable", "true");
		this.table.scroller.addEventListener("pointerleave", () => options.point?.(-1));
	}
	get scroller() {
		return this.table.scroller;
	}
	get head() {
		return this.table.head;
	}
	show(count, columns, keep = ALL$1, conditions = {}) {
		const before = this.all;
		Object.assign(this, {
			count,
			all: columns,
			keep,
			conditions
		});
		if (columns !== before) {
			const hidden = sameHeads(before, columns) ? this.bar?.left ?? NONE$2 : this.bar?.offer(columns) ?? NONE$2;
			this.columns = columns.filter(({ key }) => !hidden.has(key));
			if (!sameHeads(before, columns)) this.showHeads();
		}
		this.showConditions();
		return this.sort();
	}
	mark(row) {
		if (row === this.marked) return;
		this.marked = row;
		this.reveal(row);
	}
	reveal(row) {
		this.table.reveal(row < 0 ? -1 : this.shown.indexOf(row));
	}
	redraw() {
		this.table.show(this.shown.length);
	}
	get listed() {
		return this.shown;
	}
	hide(hidden) {
		this.columns = this.all.filter(({ key }) => !hidden.has(key));
		this.showHeads();
		this.showConditions();
		this.sort();
	}
	showHeads() {
		const { columns } = this;
		const heads = columns.map((column) => this.headCell(column));
		const filters = this.options.filter === void 0 || columns.length === 0 ? null : h("tr", {}, ...columns.map((column) => this.filterCell(column)));
		fill(this.table.head, columns.length === 0 ? null : h("tr", {}, ...heads), filters);
		this.table.table.setAttribute("aria-colcount", String(columns.length));
	}
	headCell(column) {
		const { key, label, help } = column;
		return sortHead(column, () => {
			this.order = {
				key,
				descending: this.order.key === key && !this.order.descending
			};
			fill(this.help, h("b", {}, label), `: ${help}`);
			this.help.hidden = false;
			this.sort();
		});
	}
	filterCell({ key, label, unit, words }) {
		const hint = words === true ? say("contains") : "2..5  >2  ≤0.5";
		const input = h("input", {
			type: "text",
			class: "filter",
			key,
			testid: `${this.options.testid}-filter-${key}`,
			title: `${label}: ${words === true ? say("rows-that-contain-this-text") : say("rows-within-these-limits-as")}`,
			aria: { label: say("filter", {
				label,
				what: unit === "" ? "" : say("in-2", { unit: unitText(unit) })
			}) }
		});
		input.placeholder = hint;
		input.size = 1;
		input.addEventListener("input", () => {
			const condition = conditionOf(input.value, words === true);
			input.setAttribute("aria-invalid", String(condition === void 0));
			this.showProblem();
			if (condition === void 0) return;
			const { [key]: _, ...others } = this.conditions;
			this.options.filter?.(condition === null ? others : {
				...others,
				[key]: condition
			});
		});
		return h("td", {}, input);
	}
	showConditions() {
		for (const input of this.table.head.querySelectorAll("input.filter")) {
			const key = input.dataset.key ?? "";
			const column = this.columns.find((candidate) => candidate.key === key);
			const typed = conditionOf(input.value, column?.words === true);
			if (typed !== void 0 && JSON.stringify(typed) === JSON.stringify(this.conditions[key] ?? null) || input === document.activeElement) continue;
			input.value = conditionText(this.conditions[key]);
			input.removeAttribute("aria-invalid");
		}
		this.showProblem();
	}
	showProblem() {
		const fields = [...this.table.head.querySelectorAll("input.filter")];
		const wrong = fields.find((field) => field.getAttribute("aria-invalid") === "true");
		for (const field of fields) if (field === wrong) field.setAttribute("aria-describedby", this.problem.id);
		else field.removeAttribute("aria-describedby");
		const text = wrong === void 0 ? "" : say("is-no-number-or-range", { typed: wrong.value.trim() });
		if (this.problem.textContent !== text) this.problem.textContent = text;
	}
	press(row, { shiftKey, ctrlKey, metaKey }) {
		const { choose, chooseMore } = this.options;
		this.active = row;
		const [from, to] = [this.shown.indexOf(this.anchor), this.shown.indexOf(row)];
		if (chooseMore !== void 0 && shiftKey && from >= 0) chooseMore([...this.shown.subarray(Math.min(from, to), Math.max(from, to) + 1)]);
		else if (chooseMore !== void 0 && (ctrlKey || metaKey)) chooseMore([row]);
		else choose?.(row);
		if (!shiftKey || from < 0) this.anchor = row;
		this.redraw();
	}
	key(event) {
		if (event.target !== this.table.table || event.altKey || this.shown.length === 0) return;
		const last = this.shown.length - 1;
		const at = this.shown.indexOf(this.active);
		const place = {
			ArrowDown: at + 1,
			ArrowUp: at - 1,
			PageDown: at + this.table.page,
			PageUp: at - this.table.page,
			Home: 0,
			End: last
		}[event.key];
		if (place !== void 0) {
			if (this.anchor < 0) this.anchor = this.active;
			this.active = this.shown[Math.min(last, Math.max(0, place))] ?? -1;
			if (event.shiftKey && this.options.chooseMore !== void 0) this.press(this.active, {
				shiftKey: true,
				ctrlKey: false,
				metaKey: false
			});
			else this.options.point?.(this.active);
			this.table.reveal(this.shown.indexOf(this.active), true);
		} else if ((event.key === "Enter" || event.key === " ") && at >= 0) this.press(this.active, event);
		else if (event.key === "a" && (event.ctrlKey || event.metaKey) && this.options.chooseMore !== void 0) this.options.chooseMore([...this.shown]);
		else return;
		event.preventDefault();
	}
	sort() {
		const { columns, order, keep } = this;
		const meets = keeping$1(this.all, this.conditions);
		const rows = this.inOrder(this.count, columns, order);
		const keeps = meets === null || keep === ALL$1 ? meets ?? keep : (row) => keep(row) && meets(row);
		this.shown = keeps === ALL$1 ? rows : keptOf(rows, keeps);
		this.table.markOrder(order.key, order.descending);
		this.measure();
		this.showFoot(meets !== null);
		const heads = this.table.head.childElementCount;
		this.table.table.setAttribute("aria-rowcount", String(this.shown.length + heads));
		this.table.show(this.shown.length);
		return this.shown.length;
	}
	measure() {
		const step = Math.max(1, Math.floor(this.shown.length / MEASURED$1));
		const longest = this.columns.map(({ text }) => {
			let most = 0;
			for (let place = this.shown.length - 1; place >= 0; place -= step) most = Math.max(most, text(this.shown[place] ?? 0).length);
			return most;
		});
		fill(this.table.columns, ...longest.map((length) => {
			const column = h("col", {});
			column.style.minWidth = column.style.width = `calc(${String(Math.min(length, 48))}ch + 8px)`;
			return column;
		}));
	}
	showFoot(filtered) {
		if (this.bar === null) return;
		const fewer = this.shown.length < this.count;
		this.bar.say(this.shown.length, this.count, filtered || fewer, filtered || fewer && this.options.showAll !== void 0);
		const parts = this.columns.flatMap((column) => (column.parts ?? []).map((part) => ({
			column,
			part,
			rows: this.shown.filter(part.has)
		})));
		const lines = parts.length === 0 ? [this.totals(this.shown)] : parts.filter(({ rows }) => rows.length > 0).map((of) => this.totals(of.rows, of));
		fill(this.table.foot, ...lines.filter((cells) => cells.some((cell) => cell.textContent !== "")).map((cells) => h("tr", {}, ...cells)));
	}
	totals(rows, named = null) {
		return this.columns.map((column) => {
			const { total, value, text } = column;
			if (column === named?.column) return h("td", {}, named.part.label);
			if (total === void 0 || rows.length === 0) return h("td", {});
			const number = totalOf(column, rows);
			if (named !== null && Number.isNaN(number)) return h("td", {});
			const digits = Math.max(total === "sum" ? 0 : 1, ...[...rows.subarray(0, 20)].filter((row) => !Number.isNaN(value(row))).map((row) => decimals(text(row))));
			return h("td", { class: "number" }, h("span", { class: "unit" }, `${TOTALS[total]} `), digits === 0 ? count(Number.isNaN(number) ? null : Math.round(number)) : fixed(number, digits));
		});
	}
	row(row, place, former = this.line(row)) {
		const { testid, choose, isChosen } = this.options;
		const chosen = row === this.marked;
		const together = isChosen?.(row) === true;
		const active = row === this.active;
		if (former.childElementCount !== this.columns.length) fill(former, ...this.columns.map(() => h("td", {})));
		this.columns.forEach(({ value, text }, column) => {
			const cell = former.children[column];
			const shown = text(row);
			if (cell.textContent !== shown) cell.textContent = shown;
			cell.classList.toggle("number", typeof value(row) === "number");
		});
		former.classList.toggle("best", chosen);
		former.classList.toggle("chosen", together);
		former.classList.toggle("active", active);
		former.dataset.testid = chosen ? `${testid}-selected` : `${testid}-row`;
		former.setAttribute("aria-rowindex", String(place + 1 + this.table.head.childElementCount));
		if (choose !== void 0) former.setAttribute("aria-selected", String(chosen || together));
		if (active) this.table.table.setAttribute("aria-activedescendant", former.id);
		return former;
	}
	line(row) {
		const { testid, choose, point } = this.options;
		const line = h("tr", {
			id: `${testid}-row-${String(row)}`,
			class: choose === void 0 ? "plain" : ""
		});
		if (choose !== void 0) line.addEventListener("click", (event) => this.press(row, event));
		if (point !== void 0) line.addEventListener("pointerenter", () => point(row));
		return line;
	}
};
function decimals(text) {
	return text.split(".")[1]?.length ?? 0;
}
// www/shared/panel/control.ts
var SLIDER_STEPS = 200;
var WIDEST_SLIDER = 20;
function makeControl(parameter, binding) {
	const id = `p-${parameter.key.replace(".", "-")}`;
	const field = makeField(parameter, id, binding);
	const help = h("p", {
		class: "help",
		id: `${id}-help`,
		hidden: true
	}, parameter.help);
	const problem = h("p", {
		class: "field-problem",
		id: `${id}-problem`,
		role: "alert"
	});
	const reset = button("↺", `reset-${parameter.key}`, () => binding.set(binding.standard()), say("default"));
	reset.className = "icon";
	reset.setAttribute("aria-label", say("default-2", { label: parameter.label }));
	const flag = parameter.kind === "flag";
	const element = h("div", { class: "control" }, h("div", { class: "control-head" }, ...flag ? field.elements : [], h("label", { for: id }, parameter.label, parameter.unit === "" ? null : h("span", { class: "unit" }, ` ${parameter.unit}`)), reset, helpButton(parameter, help)), ...flag ? [] : field.elements, problem, help);
	const show = (value) => {
		field.show(value);
		problem.textContent = "";
		const changed = binding.standard() !== value;
		reset.hidden = !changed;
		element.classList.toggle("is-changed", changed);
	};
	field.onProblem((text) => {
		problem.textContent = text;
		binding.refused?.();
	});
	const refuse = (text) => {
		problem.textContent = text;
		element.querySelector(`[id="${id}"]`)?.setAttribute("aria-invalid", "true");
	};
	return {
		parameter,
		element,
		show,
		refuse
	};
}
function helpButton(parameter, help) {
	const made = button("?", `help-${parameter.key}`, () => {
		help.hidden = !help.hidden;
		made.setAttribute("aria-expanded", String(!help.hidden));
	}, parameter.help);
	made.className = "icon";
	made.setAttribute("aria-expanded", "false");
	made.setAttribute("aria-controls", help.id);
	made.setAttribute("aria-label", say("help", { label: parameter.label }));
	return made;
}
function makeField(parameter, id, binding) {
	const { key } = parameter;
	switch (parameter.kind) {
		case "flag": return flagField(parameter, id, binding);
		case "choice": return choiceField(parameter, id, binding);
		case "integer":
		case "real": return numberField(parameter, id, binding);
		default: return textField(key, id, binding);
	}
}
function textField(key, id, { set }) {
	const input = h("input", {
		id,
		type: "text",
		key,
		aria: { describedby: `${id}-help ${id}-problem` }
	});
	input.dir = "ltr";
	input.spellcheck = false;
	input.addEventListener("change", () => set(input.value.trim() || null));
	const show = (value) => {
		input.removeAttribute("aria-invalid");
		input.value = String(value ?? "");
	};
	return {
		elements: [input],
		show,
		onProblem: () => void 0
	};
}
function flagField(parameter, id, { set }) {
	const input = h("input", {
		id,
		type: "checkbox",
		key: parameter.key,
		aria: { describedby: `${id}-help` }
	});
	input.addEventListener("change", () => set(input.checked));
	return {
		elements: [input],
		show: (value) => {
			input.checked = value === true;
		},
		onProblem: () => void 0
	};
}
function choiceField(parameter, id, { set, standard, whenEmpty }) {
	const { key, values, labels, absent } = parameter;
	const select = h("select", {
		id,
		key,
		aria: { describedby: `${id}-help` }
	});
	const empty = new Option(say("default-4"), "");
	empty.title = absent;
	if (standard() === null) select.append(empty);
	values.forEach((value, i) => {
		select.append(new Option(labels[i] ?? value, value));
	});
	select.addEventListener("change", () => set(select.value === "" ? null : select.value));
	const show = (value) => {
		const meant = labels[values.indexOf(String(whenEmpty()))];
		empty.text = meant === void 0 ? say("default-4") : say("default-3", { meant });
		select.value = String(value ?? "");
	};
	return {
		elements: [select],
		show,
		onProblem: () => void 0
	};
}
function stepOf(parameter) {
	if (parameter.kind === "real") return null;
	return parameter.odd ? 2 : 1;
}
function numberField(parameter, id, { set, standard, whenEmpty }) {
	const step = stepOf(parameter);
	const input = h("input", {
		id,
		type: "number",
		key: parameter.key,
		aria: { describedby: `${id}-help ${id}-problem` }
	});
	input.inputMode = step === null ? "decimal" : "numeric";
	input.min = String(parameter.min);
	input.max = String(parameter.max);
	input.step = step === null ? "any" : String(step);
	const slider = makeSlider(parameter, step);
	let tell = () => void 0;
	const optional = () => standard() === null;
	input.addEventListener("input", () => {
		if (input.value === "" && !input.validity.badInput && optional()) {
			set(null);
			return;
		}
		if (!input.validity.valid || input.value === "") {
			input.setAttribute("aria-invalid", "true");
			tell(say("allowed-the-last-valid-value", {
				parameter: message("allowed", parameter),
				what: optional() ? say("or-empty") : ""
			}));
			return;
		}
		set(input.valueAsNumber);
	});
	slider?.addEventListener("input", () => set(slider.valueAsNumber));
	const show = (value) => {
		input.removeAttribute("aria-invalid");
		const absent = optional() ? whenEmpty() : null;
		input.placeholder = optional() ? String(absent ?? say("default-4")) : "";
		input.title = optional() ? say("empty", { absent: absent ?? parameter.absent }) : "";
		if (input.value === "" || input.valueAsNumber !== value) input.value = value === null ? "" : String(value);
		const shown = value ?? absent;
		if (slider !== null) slider.value = String(typeof shown === "number" ? shown : parameter.min);
	};
	return {
		elements: slider === null ? [input] : [h("div", { class: "with-slider" }, slider, input)],
		show,
		onProblem: (listener) => {
			tell = listener;
		}
	};
}
function makeSlider(parameter, step) {
	const range = parameter.max - parameter.min;
	if (step === null ? range > WIDEST_SLIDER : range / step > SLIDER_STEPS) return null;
	const slider = h("input", {
		type: "range",
		aria: { label: say("slider", { label: parameter.label }) }
	});
	slider.min = String(parameter.min);
	slider.max = String(parameter.max);
	slider.step = String(step ?? range / 100);
	return slider;
}
// www/shared/panel/settings.ts
function pathOf(settings, key) {
	const [group = "", field = ""] = key.split(".");
	if (group in settings) return [group, field];
	return typeof settings.features === "object" ? [
		"features",
		group,
		field
	] : [field];
}
function readSetting(settings, key) {
	return pathOf(settings, key).reduce((at, name) => at?.[name], settings) ?? null;
}
function withSetting(settings, key, value) {
	return changed$1(settings, pathOf(settings, key), value);
}
function changed$1(at, [name = "", ...rest], value) {
	const inside = at[name] ?? {};
	return {
		...at,
		[name]: rest.length === 0 ? value : changed$1(inside, rest, value)
	};
}
// www/shared/panel/own.ts
function writeOwn(of, parameters, defaults, settings) {
	const own = parameters.map(({ key }) => [key, readSetting(settings, key)]).filter(([key, value]) => readSetting(defaults, key) !== value);
	return `${JSON.stringify({
		[OWN_SETTINGS]: of,
		changed: Object.fromEntries(own)
	}, null, 2)}\n`;
}
function readOwn(text, of, parameters, defaults) {
	const { [OWN_SETTINGS]: subject, changed } = fieldsOf(text);
	if (typeof changed !== "object" || changed === null || Array.isArray(changed)) throw new Error(say("the-file-holds-no-settings"));
	if (subject !== of) throw new Error(say("the-file-holds-settings-of", {
		subject: String(subject),
		of
	}));
	return Object.entries(changed).reduce((settings, [key, value]) => {
		const parameter = parameters.find((one) => one.key === key);
		if (parameter === void 0) throw new Error(say("there-is-no-setting", { key }));
		if (!isAllowed(parameter, value, readSetting(defaults, key) === null)) throw new Error(say("is-not-allowed", {
			label: parameter.label,
			value: JSON.stringify(value)
		}));
		return withSetting(settings, key, value);
	}, defaults);
}
function isAllowed(parameter, value, optional) {
	if (value === null) return optional;
	switch (parameter.kind) {
		case "flag": return typeof value === "boolean";
		case "choice": return typeof value === "string" && parameter.values.includes(value);
		default:
			if (!("min" in parameter)) return typeof value === "string";
			if (typeof value !== "number" || !(value >= parameter.min && value <= parameter.max)) return false;
			return parameter.kind === "real" || Number.isInteger(value) && (!parameter.odd || value % 2 !== 0);
	}
}
// www/shared/panel/sections.ts
function makeSections(parameters, bound) {
	const controls = parameters.map((parameter) => controlOf(parameter, bound));
	const groups = groupsOf(controls, (title, elements) => h("fieldset", { class: "group" }, h("legend", {}, title), ...elements));
	const show = (settings, acting) => showAll(controls, groups, settings, acting);
	return {
		controls,
		elements: groups.map(({ element }) => element),
		show
	};
}
function makeFolded(parameters, bound, { title, first, of, take, changed }) {
	const controls = parameters.map((parameter) => controlOf(parameter, bound));
	const ahead = controls.filter(({ parameter }) => first.includes(parameter.key));
	const folds = [];
	const groups = groupsOf(controls.filter((control) => !ahead.includes(control)), (name, elements) => {
		const fold = h("details", { class: "group" }, h("summary", {}, name, " ", h("span", { class: "changed" })), ...elements);
		folds.push(fold);
		return fold;
	});
	const number = h("span", { testid: `${of}-changed-settings` });
	const back = h("p", { class: "buttons" }, number, button(say("set-all-back"), `${of}-reset-settings`, () => take(bound.defaults())));
	const unfold = button("", `${of}-all-settings`, () => setDrawer("all-settings", !isOpen("all-settings")));
	let unfolded = null;
	watchDrawers(() => {
		if (unfolded === isOpen("all-settings")) return;
		unfolded = isOpen("all-settings");
		for (const fold of folds) fold.open = unfolded;
		unfold.textContent = unfolded ? say("fold-all") : say("unfold-all");
	});
	let now = bound.defaults();
	const files = settingsFiles(of, parameters, bound, () => now, take);
	const show = (settings, acting) => {
		now = settings;
		showAll(controls, groups, settings, acting);
		const all = controls.filter(({ element }) => element.classList.contains("is-changed")).length;
		for (const { own, element } of groups) {
			const here = own.filter((control) => control.element.classList.contains("is-changed")).length;
			fill(element.querySelector(".changed") ?? element, here === 0 ? "" : say("changed", { here }));
		}
		back.hidden = all === 0;
		number.textContent = all === 1 ? say("n-1-setting-differs-from-its") : say("settings-differ-from-their-defaults", { all });
		changed(all);
	};
	return {
		controls,
		elements: [
			back,
			h("fieldset", { class: "group" }, h("legend", {}, title), ...ahead.map(({ element }) => element)),
			h("p", { class: "buttons folds" }, unfold),
			...groups.map(({ element }) => element),
			files
		],
		show
	};
}
function settingsFiles(of, parameters, { defaults }, now, take) {
	const problem = h("p", {
		class: "field-problem",
		role: "alert",
		testid: `${of}-settings-problem`
	});
	const write = () => save(new Blob([writeOwn(of, parameters, defaults(), now())], { type: "application/json" }), `tiepoint-${of}-settings.json`);
	const read = async ([file]) => {
		problem.textContent = "";
		try {
			if (file !== void 0) take(readOwn(await file.text(), of, parameters, defaults()));
		} catch (error) {
			problem.textContent = sentence(messageOf(error));
		}
	};
	const [load, input] = fileButton(say("load"), {
		testid: `${of}-settings-load`,
		label: say("settings-of-a-as-a", { of }),
		accept: ".json,application/json"
	}, (files) => void read(files), say("takes-settings-that-were-saved"));
	const give = button(say("save"), `${of}-settings-save`, write, say("saves-what-differs-from-the"));
	return h("fieldset", { class: "group" }, h("legend", {}, say("settings-as-a-file")), h("div", { class: "buttons" }, give, load, input), problem);
}
function settingsText(changed) {
	return changed === 0 ? say("settings") : say("settings-2", { changed });
}
function controlOf(parameter, { change, defaults, resolved, refused }) {
	return makeControl(parameter, {
		set: (value) => change(parameter.key, value),
		standard: () => readSetting(defaults(), parameter.key),
		whenEmpty: () => resolved === void 0 ? null : readSetting(resolved(), parameter.key),
		refused: () => refused?.(parameter)
	});
}
function groupsOf(controls, made) {
	return [...new Set(controls.map(({ parameter }) => parameter.section))].map((section) => {
		const own = controls.filter(({ parameter }) => parameter.section === section);
		return {
			own,
			element: made(section, own.map(({ element }) => element))
		};
	});
}
function showAll(controls, groups, settings, acting) {
	const used = ({ parameter }) => acting === void 0 || acting.includes(parameter.key);
	for (const control of controls) {
		control.show(readSetting(settings, control.parameter.key));
		control.element.hidden = !used(control);
	}
	for (const { own, element } of groups) element.hidden = !own.some(used);
}
// www/shared/panel/light.ts
var MOST = 3;
function makeLight(prefix, host, set, presses) {
	const brightness = slider(say("brightness"), `${prefix}brightness`, (share) => set({ brightness: share }));
	const contrast = slider(say("contrast"), `${prefix}contrast`, (share) => set({ contrast: share }));
	const reset = button(say("light-reset"), `${prefix}light-reset`, () => {
		set(OWN_LIGHT);
		passFocus(reset, [brightness.input]);
	});
	reset.title = say("light-reset-title");
	declareLack([reset], () => reset.disabled ? say("nothing-is-changed") : "");
	return {
		elements: [
			brightness.element,
			contrast.element,
			reset
		],
		show: (light) => {
			brightness.show(light.brightness);
			contrast.show(light.contrast);
			reset.disabled = isOwnLight(light);
			for (const [press, label] of presses) markChanged(press, label, light);
			host.style.setProperty("--light", isOwnLight(light) ? "none" : `brightness(${String(light.brightness)}) contrast(${String(light.contrast)})`);
		}
	};
}
function markChanged(press, label, light) {
	const text = isOwnLight(light) ? label : say("light-changed", {
		label,
		brightness: percentOf(light.brightness),
		contrast: percentOf(light.contrast)
	});
	press.classList.toggle("has-own-light", !isOwnLight(light));
	press.title = text;
	press.setAttribute("aria-label", text);
}
var percentOf = (share) => Math.round(100 * share);
function slider(label, testid, onChange) {
	const input = h("input", {
		type: "range",
		testid
	});
	Object.assign(input, {
		min: "-1",
		max: "1",
		step: "0.05",
		value: "0"
	});
	input.addEventListener("input", () => onChange(MOST ** Number(input.value)));
	input.addEventListener("dblclick", () => onChange(1));
	const show = (share) => {
		input.value = String(Math.log(share) / Math.log(MOST));
		input.setAttribute("aria-valuetext", say("light-percent", { percent: percentOf(share) }));
	};
	return {
		element: h("label", { class: "choice" }, h("span", {}, label), input),
		input,
		show
	};
}
// www/shared/panel/menu.ts
function unfolded(testid, ...tools) {
	const more = h("div", {
		class: "more",
		id: `${testid}-tools`
	}, ...tools);
	const press = h("button", {
		type: "button",
		class: "menu-button",
		testid
	}, say("view"));
	mountMenu(press, more);
	return h("div", { class: "view-tools" }, press, more);
}
function mountMenu(press, panel) {
	const isUnfolded = () => panel.classList.contains("is-open");
	let covered = [];
	const cover = () => {
		for (const control of covered) control.inert = false;
		covered = isUnfolded() ? controlsUnder(panel) : [];
		for (const control of covered) control.inert = true;
	};
	const show = (unfolded) => {
		panel.classList.toggle("is-open", unfolded);
		press.setAttribute("aria-expanded", String(unfolded));
		cover();
	};
	press.setAttribute("aria-controls", panel.id);
	press.addEventListener("click", () => show(!isUnfolded()));
	document.addEventListener("pointerdown", ({ target }) => {
		if (isUnfolded() && target instanceof Node && !panel.contains(target) && !press.contains(target)) show(false);
	});
	panel.addEventListener("click", ({ target }) => {
		if (!isUnfolded() || !(target instanceof Element) || target.closest("button:not([aria-expanded])") === null) return;
		const held = panel.contains(document.activeElement);
		show(false);
		if (held) press.focus();
	});
	document.addEventListener("keydown", (event) => {
		if (event.key !== "Escape" || !isUnfolded()) return;
		event.stopImmediatePropagation();
		const held = panel.contains(document.activeElement);
		show(false);
		if (held) press.focus();
	}, { capture: true });
	show(false);
	const resized = new ResizeObserver(cover);
	for (const element of [panel, document.documentElement]) resized.observe(element);
}
function controlsUnder(panel) {
	const over = panel.getBoundingClientRect();
	return [...document.querySelectorAll("button, select, input, a")].filter((control) => {
		if (control.inert || panel.contains(control)) return false;
		const { left, right, top, bottom } = control.getBoundingClientRect();
		return left < over.right && right > over.left && top < over.bottom && bottom > over.top;
	});
}
// www/shared/panel/zoom.ts
var STEP = 1.5;
function zoomButtons(prefix, whole, picture) {
	return [
		labelled("−", `${prefix}zoom-out`, say("zoom-out"), () => picture().zoomMiddle(1 / STEP)),
		labelled("+", `${prefix}zoom-in`, say("zoom-in"), () => picture().zoomMiddle(STEP)),
		labelled(say("fit"), `${prefix}zoom-fit`, say("fit-0", { whole }), () => picture().fit())
	];
}
function labelled(text, testid, label, action) {
	const made = button(text, testid, action, label);
	made.setAttribute("aria-label", label);
	return made;
}
// www/shared/state/neighbours.ts
var LEAST_OF_MAP = 6;
var ALONG_A_LINE$1 = .001;
function middle(values) {
	const sorted = [...values].sort((a, b) => a - b);
	return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}
function affine(places, at) {
	if (places.length < LEAST_OF_MAP) return null;
	const map = fitted$2(places.length, (i) => places[i] ?? [
		NaN,
		NaN,
		NaN,
		NaN
	], ALONG_A_LINE$1);
	return map === null ? null : mapped(map, ...at);
}
function movedWith(places, at) {
	if (places.length === 0) return null;
	return affine(places, at) ?? [at[0] + middle(places.map((p) => p[2] - p[0])), at[1] + middle(places.map((p) => p[3] - p[1]))];
}
function onLine(positions, [x, y]) {
	let best = null;
	for (let i = 0; i + 3 < positions.length; i += 2) {
		const [ax = NaN, ay = NaN, bx = NaN, by = NaN] = positions.subarray(i, i + 4);
		const [dx, dy] = [bx - ax, by - ay];
		const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
		const place = [ax + share * dx, ay + share * dy];
		const distance = (place[0] - x) ** 2 + (place[1] - y) ** 2;
		if (best === null || distance < best[1]) best = [place, distance];
	}
	if (best !== null) return best[0];
	const [px, py] = positions;
	return px === void 0 || py === void 0 ? [x, y] : [px, py];
}
var LEAST_SINE = .1;
function crossing(a, b) {
	for (let i = 0; i + 3 < a.length; i += 2) for (let k = 0; k + 3 < b.length; k += 2) {
		const [ax = NaN, ay = NaN, ux = NaN, uy = NaN] = [
			a[i],
			a[i + 1],
			(a[i + 2] ?? NaN) - (a[i] ?? NaN),
			(a[i + 3] ?? NaN) - (a[i + 1] ?? NaN)
		];
		const [bx = NaN, by = NaN, vx = NaN, vy = NaN] = [
			b[k],
			b[k + 1],
			(b[k + 2] ?? NaN) - (b[k] ?? NaN),
			(b[k + 3] ?? NaN) - (b[k + 1] ?? NaN)
		];
		const across = ux * vy - uy * vx;
		if (!(Math.abs(across) > LEAST_SINE * Math.hypot(ux, uy) * Math.hypot(vx, vy))) continue;
		const along = ((bx - ax) * vy - (by - ay) * vx) / across;
		const other = ((bx - ax) * uy - (by - ay) * ux) / across;
		if (along >= 0 && along <= 1 && other >= 0 && other <= 1) return [ax + along * ux, ay + along * uy];
	}
	return null;
}
// www/shared/view/layers.ts
function contextOf(canvas) {
	const context = canvas.getContext("2d");
	if (context === null) throw new Error(say("this-browser-offers-no-canvas"));
	return context;
}
function within(context, rect, draw) {
	context.save();
	context.beginPath();
	context.rect(rect.left, rect.top, rect.width, rect.height);
	context.clip();
	draw();
	context.restore();
}
var Layers = class {
	host;
	names;
	paint;
	contexts;
	dirty = new Set();
	frame = 0;
	ratio = 1;
	width = 1;
	height = 1;
	constructor(host, names, paint) {
		this.host = host;
		this.names = names;
		this.paint = paint;
		this.contexts = Object.fromEntries(names.map((name) => [name, contextOf(canvasIn(host, name))]));
		new ResizeObserver(() => this.resize()).observe(host);
	}
	get isLaid() {
		return this.width > 1 && this.height > 1;
	}
	redraw(...names) {
		for (const name of names.length > 0 ? names : this.names) this.dirty.add(name);
		if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
	}
	place(event) {
		const box = this.host.getBoundingClientRect();
		return [event.clientX - box.left, event.clientY - box.top];
	}
	snapshot() {
		this.draw();
		const canvas = document.createElement("canvas");
		canvas.width = Math.round(this.width * this.ratio);
		canvas.height = Math.round(this.height * this.ratio);
		const context = contextOf(canvas);
		for (const name of this.names) {
			const layer = this.contexts[name].canvas;
			context.filter = getComputedStyle(layer).filter;
			context.drawImage(layer, 0, 0);
		}
		return canvas;
	}
	resize() {
		this.ratio = window.devicePixelRatio || 1;
		this.width = Math.max(1, this.host.clientWidth);
		this.height = Math.max(1, this.host.clientHeight);
		for (const name of this.names) {
			const { canvas } = this.contexts[name];
			canvas.width = Math.round(this.width * this.ratio);
			canvas.height = Math.round(this.height * this.ratio);
			this.dirty.add(name);
		}
		this.draw();
	}
	draw() {
		cancelAnimationFrame(this.frame);
		this.frame = 0;
		if (this.host.closest("[hidden]") !== null) return;
		const names = this.names.filter((name) => this.dirty.has(name));
		this.dirty.clear();
		for (const name of names) {
			const context = this.contexts[name];
			context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
			context.clearRect(0, 0, this.width, this.height);
			context.lineCap = "butt";
			this.paint(name, context);
		}
	}
};
function canvasIn(host, name) {
	const canvas = document.createElement("canvas");
	canvas.className = "layer";
	canvas.dataset.testid = `layer-${name}`;
	canvas.setAttribute("aria-hidden", "true");
	host.append(canvas);
	return canvas;
}
// www/shared/view/transform.ts
function contains(rect, x, y) {
	return x >= rect.left && x < rect.left + rect.width && y >= rect.top && y < rect.top + rect.height;
}
function toCanvas(t, x, y) {
	return [t.scale * x + t.x, t.scale * y + t.y];
}
function toPosition(t, x, y) {
	return [(x - t.x) / t.scale, (y - t.y) / t.scale];
}
function resized(t, from, to) {
	const [x, y] = toPosition(t, from.width / 2, from.height / 2);
	const scale = t.scale * Math.min(to.width / from.width, to.height / from.height);
	return {
		scale,
		x: to.width / 2 - scale * x,
		y: to.height / 2 - scale * y
	};
}
function panned(t, dx, dy) {
	return {
		scale: t.scale,
		x: t.x + dx,
		y: t.y + dy
	};
}
function zoomedAbout(t, factor, x, y, { least, most }) {
	const scale = Math.min(most, Math.max(least, t.scale * factor));
	const actual = scale / t.scale;
	return {
		scale,
		x: x + actual * (t.x - x),
		y: y + actual * (t.y - y)
	};
}
// www/shared/view/bitmap.ts
function visiblePart(picture, t, clip) {
	const [left, top] = toPosition(t, clip.left, clip.top);
	const [right, bottom] = toPosition(t, clip.left + clip.width, clip.top + clip.height);
	return [
		Math.max(0, left),
		Math.max(0, top),
		Math.min(picture.width, right),
		Math.min(picture.height, bottom)
	];
}
function wantedLevel(scale, ratio) {
	return Math.max(0, Math.floor(Math.log2(1 / (scale * ratio))));
}
function paintBitmap(context, bitmap, x, y, step, part, t) {
	const left = Math.max(0, Math.floor((part[0] - x) / step));
	const top = Math.max(0, Math.floor((part[1] - y) / step));
	const right = Math.min(bitmap.width, Math.ceil((part[2] - x) / step));
	const bottom = Math.min(bitmap.height, Math.ceil((part[3] - y) / step));
	if (right <= left || bottom <= top) return;
	const size = step * t.scale;
	context.drawImage(bitmap, left, top, right - left, bottom - top, t.scale * x + t.x + left * size, t.scale * y + t.y + top * size, (right - left) * size, (bottom - top) * size);
}
function smooth(context, scale, ratio) {
	context.imageSmoothingEnabled = scale * ratio < 2;
	context.imageSmoothingQuality = "medium";
}
// www/shared/view/palette.ts
var SHAPES = {
	dot: 0,
	circle: 1,
	plus: 2,
	cross: 3,
	square: 4,
	triangleUp: 5,
	triangleDown: 6,
	diamond: 7
};
var ACCEPTED = {
	colour: "#00c08b",
	shape: SHAPES.circle
};
var REJECTED$1 = {
	colour: "#d55e00",
	shape: SHAPES.diamond
};
var REJECTED_BY_HAND = {
	colour: "#ff3b30",
	shape: SHAPES.cross
};
var MEASURED = {
	colour: "#9cff57",
	shape: SHAPES.square
};
var SELECTED = "#ffd400";
var CANDIDATE = "#56b4e9";
var EPIPOLAR = "#ff9ee0";
var RESIDUAL = "#f0e442";
var RESIDUAL_REJECTED = "#ff7a1a";
// www/shared/view/pointer.ts
var ARM = 12;
var LENS_SIDE = 176;
function ring(context, pane, at, radius, colour, width) {
	const [x, y] = toCanvas(pane.transform, at[0], at[1]);
	context.beginPath();
	context.arc(x, y, radius, 0, 2 * Math.PI);
	context.lineWidth = width + 2;
	context.strokeStyle = "rgb(0 0 0 / 0.65)";
	context.stroke();
	context.lineWidth = width;
	context.strokeStyle = colour;
	context.stroke();
}
function drawLine(context, pane, positions) {
	const places = Array.from({ length: positions.length / 2 }, (_, i) => toCanvas(pane.transform, positions[2 * i] ?? 0, positions[2 * i + 1] ?? 0));
	const path = new Path2D();
	for (const [i, [x, y]] of places.entries()) {
		if (places.length > 1) {
			if (i === 0) path.moveTo(x, y);
			else path.lineTo(x, y);
			continue;
		}
		path.moveTo(x - 14, y);
		path.lineTo(x + 14, y);
		path.moveTo(x, y - 14);
		path.lineTo(x, y + 14);
	}
	within(context, pane.rect, () => {
		context.lineWidth = 3;
		context.strokeStyle = "rgb(0 0 0 / 0.5)";
		context.stroke(path);
		context.setLineDash([9, 5]);
		context.lineWidth = 1.5;
		context.strokeStyle = EPIPOLAR;
		context.stroke(path);
		context.setLineDash([]);
	});
}
function drawExpected(context, pane, at) {
	const [x, y] = toCanvas(pane.transform, ...at);
	within(context, pane.rect, () => {
		context.beginPath();
		context.arc(x, y, 7, 0, 2 * Math.PI);
		context.setLineDash([4, 3]);
		context.lineWidth = 1.5;
		context.strokeStyle = CANDIDATE;
		context.stroke();
		context.setLineDash([]);
	});
}
function drawCross(context, pane, at, active) {
	const [x, y] = toCanvas(pane.transform, ...at);
	const path = new Path2D();
	for (const [ux, uy] of [
		[1, 0],
		[-1, 0],
		[0, 1],
		[0, -1]
	]) {
		path.moveTo(x + 3 * ux, y + 3 * uy);
		path.lineTo(x + ARM * ux, y + ARM * uy);
	}
	within(context, pane.rect, () => {
		context.lineWidth = active ? 4.5 : 3.5;
		context.strokeStyle = "rgb(0 0 0 / 0.65)";
		context.stroke(path);
		context.lineWidth = active ? 2.2 : 1.4;
		context.strokeStyle = SELECTED;
		context.stroke(path);
	});
}
function lensRect([x, y], bounds) {
	const side = Math.min(LENS_SIDE, bounds.width, bounds.height);
	const left = x + 24 + side > bounds.width ? x - 24 - side : x + 24;
	const top = y + 24 + side > bounds.height ? y - 24 - side : y + 24;
	return {
		left: Math.max(1, left),
		top: Math.max(1, top),
		width: side,
		height: side
	};
}
function crosshair(context, rect) {
	const x = rect.left + rect.width / 2;
	const y = rect.top + rect.height / 2;
	context.beginPath();
	for (const [ux, uy] of [
		[1, 0],
		[-1, 0],
		[0, 1],
		[0, -1]
	]) {
		context.moveTo(x + 6 * ux, y + 6 * uy);
		context.lineTo(x + 18 * ux, y + 18 * uy);
	}
	context.lineWidth = 1;
	context.strokeStyle = SELECTED;
	context.stroke();
}
function lensFrame(context, rect) {
	context.lineWidth = 2;
	context.strokeStyle = SELECTED;
	context.strokeRect(rect.left, rect.top, rect.width, rect.height);
}
function lensTransform({ left, top, width, height }, [x, y], scale) {
	return {
		scale,
		x: left + width / 2 - scale * x,
		y: top + height / 2 - scale * y
	};
}
// www/shared/view/panes.ts
function transformOf(pane, view) {
	return {
		scale: view.scale,
		x: pane.left + pane.width / 2 - view.scale * view.x,
		y: pane.top + pane.height / 2 - view.scale * view.y
	};
}
function drawView(t, clip) {
	return Float64Array.of(t.scale, t.x, t.y, clip.left, clip.top, clip.left + clip.width, clip.top + clip.height);
}
var HEAD$1 = 40;
function fitView(pane, width, height) {
	const head = Math.min(HEAD$1, pane.height / 4);
	const scale = Math.min(pane.width / width, (pane.height - head) / height);
	const top = Math.max(head, (pane.height - scale * height) / 2);
	return {
		x: width / 2,
		y: (pane.height / 2 - top) / scale,
		scale
	};
}
var MAX_SCALE = 64;
var SHOWN_IN = new WeakMap();
function inPane(view, { width, height }) {
	if (width <= 1 || height <= 1) return view;
	const first = SHOWN_IN.get(view);
	if (first === void 0) SHOWN_IN.set(view, {
		width,
		height
	});
	if (first === void 0) return view;
	const scale = view.scale * Math.min(width / first.width, height / first.height);
	return {
		...view,
		scale: Math.min(scale, Math.max(MAX_SCALE, view.scale))
	};
}
function zoomed(pane, view, factor, x, y, least) {
	const t = zoomedAbout(transformOf(pane, view), factor, x, y, {
		least,
		most: MAX_SCALE
	});
	const [centreX, centreY] = toPosition(t, pane.left + pane.width / 2, pane.top + pane.height / 2);
	return {
		scale: t.scale,
		x: centreX,
		y: centreY
	};
}
function clamped(view, { width, height }) {
	return {
		scale: view.scale,
		x: Math.min(width, Math.max(0, view.x)),
		y: Math.min(height, Math.max(0, view.y))
	};
}
function halfSize(scale) {
	return Math.min(7, Math.max(1.5, 2.6 * scale));
}
// www/shared/view/grid.ts
var PointGrid = class {
	points;
	start;
	order;
	columns;
	rows;
	side;
	constructor(points, width, height) {
		this.points = points;
		const count = points.length / 3;
		this.side = Math.max(4, Math.sqrt(2 * width * height / Math.max(count, 1)));
		this.columns = Math.ceil(width / this.side) || 1;
		this.rows = Math.ceil(height / this.side) || 1;
		this.start = new Uint32Array(this.columns * this.rows + 1);
		this.order = new Uint32Array(count);
		const cells = Uint32Array.from({ length: count }, (_, i) => this.cell(points[3 * i] ?? 0, points[3 * i + 1] ?? 0));
		for (const cell of cells) this.start[cell + 1] = (this.start[cell + 1] ?? 0) + 1;
		for (let c = 1; c < this.start.length; c++) this.start[c] = (this.start[c] ?? 0) + (this.start[c - 1] ?? 0);
		const next = this.start.slice();
		cells.forEach((cell, i) => {
			const at = next[cell] ?? 0;
			this.order[at] = i;
			next[cell] = at + 1;
		});
	}
	nearest(x, y, radius, accept) {
		let found = -1;
		let least = radius * radius;
		const [firstColumn, lastColumn] = this.range(x, radius, this.columns);
		const [firstRow, lastRow] = this.range(y, radius, this.rows);
		for (let row = firstRow; row <= lastRow; row++) {
			const line = row * this.columns;
			for (let k = this.start[line + firstColumn] ?? 0; k < (this.start[line + lastColumn + 1] ?? 0); k++) {
				const index = this.order[k] ?? 0;
				const dx = (this.points[3 * index] ?? 0) - x;
				const dy = (this.points[3 * index + 1] ?? 0) - y;
				const distance = dx * dx + dy * dy;
				if (distance <= least && accept(index)) {
					least = distance;
					found = index;
				}
			}
		}
		return found;
	}
	cell(x, y) {
		const column = Math.min(this.columns - 1, Math.max(0, Math.floor(x / this.side)));
		return Math.min(this.rows - 1, Math.max(0, Math.floor(y / this.side))) * this.columns + column;
	}
	range(centre, radius, count) {
		const clamp = (value) => Math.min(count - 1, Math.max(0, Math.floor(value / this.side)));
		return [clamp(centre - radius), clamp(centre + radius)];
	}
};
// www/shared/panel/swatch.ts
var OUTLINES = {
	[SHAPES.dot]: "M6 6h4v4h-4z",
	[SHAPES.circle]: "M12 8a4 4 0 1 0-8 0a4 4 0 1 0 8 0z",
	[SHAPES.plus]: "M8 4v8M4 8h8",
	[SHAPES.cross]: "M4.5 4.5l7 7M11.5 4.5l-7 7",
	[SHAPES.square]: "M4.5 4.5h7v7h-7z",
	[SHAPES.triangleUp]: "M8 4l4 7h-8z",
	[SHAPES.triangleDown]: "M8 12l4-7h-8z",
	[SHAPES.diamond]: "M8 3.5l4.5 4.5l-4.5 4.5l-4.5-4.5z"
};
function swatch({ shape, colour }) {
	return drawn({
		d: OUTLINES[shape] ?? "",
		fill: shape === SHAPES.dot ? colour : "none",
		stroke: colour
	});
}
function lineSwatch(d, colour, dashes = "none") {
	return drawn({
		d,
		fill: "none",
		stroke: colour,
		"stroke-dasharray": dashes
	});
}
function drawn(path) {
	return svg("svg", {
		viewBox: "0 0 16 16",
		width: 16,
		height: 16,
		class: "swatch",
		"aria-hidden": "true"
	}, svg("rect", {
		width: 16,
		height: 16,
		rx: 3,
		fill: "#3a3f44"
	}), svg("path", {
		...path,
		"stroke-width": 1.6
	}));
}
// pkg/block/option-name.js
var optionName = ({ key, named }) => named || key.replace(/^.*\./, "").replaceAll("_", "-");
// www/shared/text/names.ts
var OTHER$1 = {
	"camera.focal_mm": say("focal-length"),
	"camera.pixel_mm": say("pixel-size"),
	"camera.principal_point_mm": say("principal-point"),
	"camera.radial_distortion": say("radial-distortion"),
	"camera.tangential_distortion": say("tangential-distortion"),
	focal_mm: say("focal-length"),
	origin: say("origin-in-the-scan-2")
};
var FILES = {
	geoid: say("geoid"),
	orthophoto: say("orthophoto")
};
var IN_BRACKETS = /\(([^()]*--[a-z][^()]*)\)/gu;
var OPTION = /`?\u200f?--([a-z]+(?:-[a-z]+)*)`?/gu;
var NAME$2 = /--[a-z]+(?:-[a-z]+)*|[a-z_]+\.[a-z0-9_]+/gu;
function readable(catalogue, message) {
	const labels = new Map(Object.entries(OTHER$1));
	for (const { key, label } of [...catalogue?.parameters ?? [], ...catalogue?.flightParameters ?? []]) labels.set(key, label);
	return withSettings(catalogue, message).replace(/[a-z]+\.[a-z0-9_]+/gu, (key) => quoted(labels.get(key)) ?? key).replace(/^(\w+)(?= is )/u, (key) => quoted(labels.get(key)) ?? key).replace(/(\d) x (?=\d)/gu, "$1 × ");
}
function withSettings(catalogue, message) {
	if (!message.includes("--")) return message;
	const labels = new Map(Object.entries(FILES));
	for (const parameter of catalogue?.parameters ?? []) labels.set(optionName(parameter), parameter.label);
	const labelled = (text) => text.replace(OPTION, (option, name) => quoted(labels.get(name)) ?? option);
	const inBrackets = (brackets, inner) => {
		const settings = labelled(inner);
		return settings === inner ? brackets : `(${say("named-settings", { settings })})`;
	};
	return labelled(message.replace(IN_BRACKETS, inBrackets));
}
function firstNamed(parameters, message) {
	const named = new Map(parameters.flatMap((parameter) => [parameter.key, `--${optionName(parameter)}`].map((name) => [name, parameter])));
	for (const [name] of message.matchAll(NAME$2)) {
		const parameter = named.get(name);
		if (parameter !== void 0) return parameter;
	}
	return null;
}
function quoted(label) {
	return label === void 0 ? void 0 : `“${label}”`;
}
// www/shared/panel/facts.ts
var open$1 = new Set();
function facts(list) {
	return h("dl", { class: "facts" }, ...list.flatMap(({ name, testid, value, help, kind }) => {
		const text = h("dd", {
			class: "help",
			id: `${testid}-help`,
			hidden: !open$1.has(testid)
		}, help);
		const press = button(name, `${testid}-name`, () => {
			text.hidden = !text.hidden;
			if (text.hidden) open$1.delete(testid);
			else open$1.add(testid);
			press.setAttribute("aria-expanded", String(!text.hidden));
		}, help);
		press.className = "explained";
		press.setAttribute("aria-expanded", String(!text.hidden));
		press.setAttribute("aria-controls", text.id);
		return [
			h("dt", {}, press),
			h("dd", {
				testid,
				class: kind ?? ""
			}, value),
			text
		];
	}));
}
// www/shared/panel/offers.ts
function actions() {
	const buttons = [...document.querySelectorAll("button")].filter(isNamed);
	const offers = [
		...ofButtons(buttons),
		...ofCommands(buttons),
		...ofLists(),
		...ofSettings()
	];
	const rank = ({ away, disabled = false }) => (disabled ? MOST_AWAY : 0) + away;
	const known = new Set();
	return offers.sort((a, b) => rank(a) - rank(b)).filter(({ name, more }) => {
		const own = `${name}\n${more}`;
		const isFirst = !known.has(own);
		if (name === "") return false;
		known.add(own);
		return isFirst;
	});
}
var MOST_AWAY = 9;
function offer(element, texts, made, off) {
	const ways = waysTo(element);
	const disabled = off !== false;
	const more = [
		disabled ? off : "",
		...ways.map(({ title }) => title),
		...texts
	];
	return {
		...made,
		disabled,
		away: ways.length,
		more: [...new Set(more)].filter((text) => text !== "").join(" · ")
	};
}
var isNamed = (button) => button.closest("dialog, table, .control-head, .history, .facts") === null && !button.matches(UNNAMED) && (reachable(button) || button.closest("[role=\"toolbar\"]") !== null);
function ofButtons(buttons) {
	const isEmpty = (button) => button.closest("[role=\"tabpanel\"]") !== null && lackOf(button) !== "";
	const isOff = (button) => button.disabled || !reachable(button) || isEmpty(button);
	return once(buttons.map((button) => ({
		button,
		off: Number(isOff(button)),
		away: waysTo(button).length
	})).sort((a, b) => a.off - b.off || a.away - b.away).map(({ button }) => button)).map((button) => {
		const texts = [
			groupOf(twinOf(button) ?? button),
			legendOf(button),
			tabOf(button),
			kindOf$1(button),
			button.title
		].filter((text) => !saysName(button, text));
		const run = () => {
			reveal(button);
			button.click();
		};
		return offer(button, texts, {
			name: nameOf(button),
			keys: keysOfButton(button),
			run
		}, isOff(button) && lackOf(button));
	});
}
function ofCommands(buttons) {
	return declared().filter(({ host, list }) => list.length > 0 && reachable(host)).flatMap((of) => {
		const part = partOf(of.host);
		const around = buttons.filter((button) => part === null ? waysTo(button).length === 0 : partOf(button) === part);
		const taken = new Set(around.flatMap(keysOfButton));
		return of.list.filter(({ keys }) => !keys.some((key) => taken.has(key))).map((command) => ofCommand(of, command));
	});
}
function ofCommand({ where, host, lacks: otherwise = "" }, command) {
	const { keys, does, can, run, lacks } = command;
	const possible = () => can?.() !== false;
	const lack = lackOf(host) || (lacks?.() ?? "");
	const go = () => {
		if (host.checkVisibility()) return run(false);
		reveal(host);
		if (host instanceof HTMLElement) host.focus();
		afterFrame(() => {
			if (possible()) run(false);
		})();
	};
	return offer(host, [where], {
		name: sentenceOf(does),
		keys,
		run: go
	}, (!possible() || lack !== "") && (lack || otherwise));
}
function ofSettings() {
	return [...document.querySelectorAll(".control label")].filter(reachable).map((label) => {
		const run = () => {
			reveal(label);
			label.control?.focus();
		};
		return offer(label, [say("setting"), legendOf(label)], {
			name: label.textContent,
			keys: [],
			run
		}, false);
	});
}
function ofLists() {
	return [...document.querySelectorAll("select, input[type=\"range\"]")].filter((control) => control.closest("dialog, table, .control") === null && reachable(control)).flatMap((control) => {
		const about = control.ariaLabel ?? control.labels?.[0]?.querySelector("span")?.textContent ?? "";
		const goTo = () => {
			reveal(control);
			control.focus();
		};
		const made = (name, run) => offer(control, [groupOf(control)], {
			name,
			keys: [],
			run
		}, control.disabled && lackOf(control));
		if (!(control instanceof HTMLSelectElement)) return [made(about, goTo)];
		return [...control.options].filter((option) => !option.selected && !option.disabled).map((option) => made(say("action-about", {
			about,
			action: option.text
		}), () => {
			control.value = option.value;
			control.dispatchEvent(new Event("change", { bubbles: true }));
			goTo();
		}));
	});
}
var legendOf = (made) => made.closest("fieldset, details")?.querySelector("legend, summary")?.firstChild?.textContent ?? "";
var UNNAMED = ".close, .menu-button, #export-menu";
function nameOf(made) {
	const label = made.getAttribute("aria-label");
	const shown = label ?? made.textContent;
	const own = /\p{L}|\d/u.test(shown) || made.title === "" ? shown : made.title;
	const about = label === null && keysOfButton(made).length === 0 ? twinOf(made)?.getAttribute("aria-label") : null;
	return about == null ? own : say("action-about", {
		about,
		action: own
	});
}
var twinOf = (made) => made.closest(".twin");
var saysName = (button, text) => [nameOf(button), `${nameOf(button)} (${keysOfButton(button)[0] ?? ""})`].includes(text);
var keysOfButton = (button) => button.getAttribute("aria-keyshortcuts")?.replaceAll("Control", "Ctrl").split(" ") ?? [];
function once(buttons) {
	const known = new Set();
	return buttons.filter((button) => {
		const keys = keysOfButton(button);
		const name = [
			partOf(button)?.title ?? "",
			nameOf(button),
			...keys
		].join("\n");
		const isFirst = !known.has(name);
		if (keys.length > 0) known.add(name);
		return isFirst;
	});
}
function tabOf(made) {
	const tab = made.closest("[role=\"tabpanel\"]")?.getAttribute("aria-labelledby");
	return tab == null ? "" : document.getElementById(tab)?.textContent ?? "";
}
var kindOf$1 = (made) => made.getAttribute("role") === "tab" ? say("tab") : "";
var sentenceOf = (does) => does.charAt(0).toUpperCase() + does.slice(1);
var groupOf = (made) => made.parentElement?.closest("[aria-label]")?.getAttribute("aria-label") ?? "";
// www/shared/text/folded.ts
var ALIKE = {
	ى: "ي",
	ة: "ه"
};
function folded(text) {
	return text.normalize("NFD").replaceAll(/[\p{M}\u0640]/gu, "").replaceAll(/[ىة]/gu, (letter) => ALIKE[letter] ?? letter).toLowerCase();
}
// www/shared/panel/actions.ts
var late = new Set();
function beforeSearch(make) {
	late.add(make);
}
function makeLate(made) {
	hasten();
	let waits = 0;
	for (const make of [...late]) {
		late.delete(make);
		const making = make();
		if (!(making instanceof Promise)) continue;
		waits += 1;
		making.then(made, () => {
			late.add(make);
			made();
		});
	}
	return waits;
}
function mountActions(press) {
	const keys = new KeyList();
	const search = new Search(() => keys.open());
	document.body.append(keys.dialog, search.dialog);
	press.addEventListener("click", () => search.open());
	const everywhere = declare({
		where: say("anywhere"),
		host: document.body,
		list: [{
			keys: ["Ctrl+K"],
			does: say("finds-any-action"),
			run: () => search.open()
		}, {
			keys: ["?"],
			does: say("lists-all-keys"),
			run: () => keys.open()
		}]
	});
	document.addEventListener("keydown", (event) => {
		const typing = event.target instanceof Element && event.target.closest("input, textarea, select, dialog") !== null;
		const held = event.ctrlKey || event.metaKey;
		if (event.altKey || typing && !held || document.querySelector("dialog[open]") !== null) return;
		if (everywhere(held ? `Ctrl+${event.key.toUpperCase()}` : event.key, event.shiftKey)) event.preventDefault();
	});
}
var Search = class {
	dialog = h("dialog", {
		class: "dialog search",
		testid: "search",
		aria: { label: say("find-an-action") }
	});
	input = h("input", {
		type: "text",
		id: "search-text",
		testid: "search-text",
		role: "combobox"
	});
	list = h("ul", {
		id: "search-list",
		class: "found",
		testid: "search-list",
		role: "listbox",
		aria: { label: say("actions") }
	});
	said = h("p", {
		class: "note",
		role: "status",
		testid: "search-said"
	});
	all = [];
	found = [];
	active = 0;
	waits = 0;
	constructor(keys) {
		const close = button(say("close-2"), "search-close", () => this.dialog.close());
		const list = button(say("all-keys"), "search-keys", () => {
			this.dialog.close();
			keys();
		});
		this.input.autocomplete = "off";
		for (const [name, value] of [
			["controls", this.list.id],
			["expanded", "true"],
			["autocomplete", "list"]
		]) this.input.setAttribute(`aria-${name}`, value);
		this.dialog.append(h("label", { for: this.input.id }, say("what-do-you-want-to")), this.input, this.list, h("div", { class: "dialog-head" }, this.said, h("div", { class: "buttons" }, list, close)));
		this.input.addEventListener("input", () => this.narrow());
		this.input.addEventListener("keydown", (event) => {
			const by = {
				ArrowDown: 1,
				ArrowUp: -1
			}[event.key];
			if (event.key === "Enter") this.run(this.active);
			else if (by !== void 0) this.mark(this.active + by);
			else return;
			event.preventDefault();
		});
	}
	open() {
		this.gather();
		this.input.value = "";
		this.dialog.showModal();
		this.narrow();
		this.input.focus();
	}
	gather() {
		this.waits += makeLate(() => {
			this.waits -= 1;
			this.arrived();
		});
		this.list.setAttribute("aria-busy", String(this.waits > 0));
		this.all = actions();
	}
	arrived() {
		if (!this.dialog.open) return;
		const now = this.found[this.active];
		this.gather();
		this.narrow();
		const again = this.found.findIndex(({ name, more }) => name === now?.name && more === now.more);
		if (again > 0) this.mark(again);
	}
	narrow() {
		const words = folded(this.input.value).split(/\s+/u);
		const text = ({ name, more }) => folded(`${name} ${more}`);
		const rank = ({ name, disabled }) => (words.every((word) => folded(name).includes(word)) ? 0 : 1) + (disabled === true ? 2 : 0);
		this.found = this.all.filter((action) => words.every((word) => text(action).includes(word))).sort((a, b) => rank(a) - rank(b));
		const rows = this.found.map(({ name, more, keys, disabled = false }, place) => {
			const row = h("li", {
				role: "option",
				id: `search-${String(place)}`,
				aria: disabled ? { disabled: "true" } : {}
			}, h("span", {}, name), h("small", {}, [disabled ? say("not-possible-now") : "", more].filter((text) => text !== "").join(" · ")), keys.length === 0 ? null : keysOf(keys));
			row.addEventListener("click", () => this.run(place));
			return row;
		});
		fill(this.list, ...rows);
		const { length } = this.found;
		this.said.textContent = length === 0 ? say("no-action-has-these-words") : say("so-many-actions", { actions: length });
		this.mark(0);
	}
	mark(wanted) {
		const rows = [...this.list.children];
		this.active = rows.length === 0 ? 0 : (wanted + rows.length) % rows.length;
		for (const [place, option] of rows.entries()) option.setAttribute("aria-selected", String(place === this.active));
		const row = rows[this.active];
		if (row === void 0) this.input.removeAttribute("aria-activedescendant");
		else this.input.setAttribute("aria-activedescendant", row.id);
		row?.scrollIntoView({ block: "nearest" });
	}
	run(place) {
		const action = this.found[place];
		if (action === void 0 || action.disabled === true) return;
		this.dialog.close();
		action.run();
	}
};
function rowsOf$1(list) {
	const rows = new Map();
	for (const does of new Set(list.map((one) => one.does))) {
		const keys = [...new Set(list.filter((one) => one.does === does).flatMap((one) => one.keys))];
		const row = rows.get(keys.join(" "));
		if (row === void 0) rows.set(keys.join(" "), {
			keys,
			does: [does]
		});
		else row.does.push(does);
	}
	return [...rows.values()];
}
function keysOf(keys) {
	const between = keys.every((key) => /^Arrow/u.test(key)) ? " " : say("or");
	return h("span", { class: "keys-of" }, ...keys.flatMap((key, i) => [...i === 0 ? [] : [between], h("kbd", {}, keyText(key))]));
}
var KeyList = class {
	dialog = h("dialog", {
		class: "dialog",
		testid: "keys-dialog",
		aria: { labelledby: "keys-heading" }
	});
	open() {
		makeLate(() => void 0);
		const own = declared().map(({ where, host, list }) => ({
			where,
			seen: host.checkVisibility(),
			list
		}));
		const all = [
			...own.filter(({ seen }) => seen),
			{
				where: say("every-picture"),
				seen: true,
				list: MOVES
			},
			...own.filter(({ seen }) => !seen)
		];
		const tables = [...new Set(all.map(({ where }) => where))].map((name) => {
			const rows = rowsOf$1(all.filter(({ where }) => where === name).flatMap((of) => [...of.list])).map(({ keys, does }) => h("div", {}, h("dt", {}, keysOf(keys)), h("dd", {}, does.join("; "))));
			return h("section", {}, h("h3", {}, name), h("dl", { class: "key-list" }, ...rows));
		});
		const close = button(say("close-2"), "keys-close", () => this.dialog.close());
		fill(this.dialog, h("div", { class: "dialog-head" }, h("h2", { id: "keys-heading" }, say("keys")), close), h("div", { class: "key-lists" }, ...tables));
		this.dialog.showModal();
	}
};
// www/shared/panel/scrolled.ts
function byKeys(text) {
	if (text.scrollHeight > text.clientHeight || text.scrollWidth > text.clientWidth) text.setAttribute("tabindex", "0");
	else text.removeAttribute("tabindex");
}
function scrolledByKeys(table) {
	new ResizeObserver(() => byKeys(table)).observe(table);
	return table;
}
// www/shared/panel/answer.ts
function answerCard(host, line, buttons, prefix) {
	const figures = h("dl", {
		class: "figures",
		testid: `${prefix}figures`
	});
	let act = () => void 0;
	let instead = [];
	const press = button("", `${prefix}next`, () => act());
	press.className = "primary";
	const others = h("span", { class: "answer-others" });
	let offered = "";
	const more = button("", `${prefix}more`, () => uncover(!host.classList.contains("is-open")));
	more.className = "link uncover";
	line.after(figures);
	const uncover = (open) => {
		host.classList.toggle("is-open", open);
		more.textContent = say(open ? "less-of-the-answer" : "more-of-the-answer");
		more.setAttribute("aria-expanded", String(open));
	};
	const scrolled = new ResizeObserver((entries) => {
		for (const { target } of entries) if (target !== line || getComputedStyle(line).overflowY !== "visible") byKeys(target);
		else line.removeAttribute("tabindex");
		const isCut = [
			host,
			line,
			...line.children
		].some(({ clientHeight, scrollHeight }) => clientHeight > 0 && scrollHeight > clientHeight + 1);
		more.hidden = !host.classList.contains("is-open") && !isCut;
	});
	more.hidden = true;
	uncover(false);
	buttons.prepend(press, others);
	buttons.append(more);
	let height = 0;
	new ResizeObserver(() => {
		if (host.dataset.kind !== "busy" && !host.classList.contains("is-open")) ({height} = host.getBoundingClientRect());
	}).observe(host);
	return ({ kind, verdict, text, more: after = "", said = "", problem = "", figures: found = [], next = null, others: now = [] }) => {
		instead = now;
		host.dataset.kind = kind;
		host.style.minHeight = kind === "busy" && height > 0 ? `${String(height)}px` : "";
		host.dataset.verdict = verdict ?? "";
		line.dataset.kind = kind;
		if (line.textContent !== [
			text,
			after,
			said,
			problem
		].filter((part) => part !== "").join(" ")) {
			const rest = [
				h("span", {}, after),
				h("span", { class: "done-since" }, said),
				h("span", { class: "wrong" }, problem)
			].filter((part) => part.textContent !== "");
			fill(line, h("strong", {}, text), ...rest.flatMap((part) => [" ", part]));
			scrolled.disconnect();
			uncover(false);
			for (const part of [line, ...rest]) scrolled.observe(part);
		}
		fill(figures, ...found.map(({ value, label }) => h("div", {}, h("dt", {}, label), h("dd", {}, value))));
		figures.hidden = found.length === 0;
		act = next?.act ?? (() => void 0);
		press.hidden = next === null;
		if (press.textContent !== (next?.text ?? "")) press.textContent = next?.text ?? "";
		host.classList.toggle("has-choice", instead.length > 0);
		const texts = instead.map(({ text: own }) => own).join("\n");
		if (texts === offered) return;
		offered = texts;
		fill(others, ...instead.map(({ text: own }, i) => button(own, `${prefix}other-${String(i + 1)}`, () => instead[i]?.act())));
		others.hidden = instead.length === 0;
	};
}
// www/shared/state/notice.ts
function ofLine(notice) {
	return notice?.near === void 0 ? notice : null;
}
// www/pair/state/edits.ts
var NOTHING = {
	rejected: new Map(),
	placed: new Map()
};
var keys = new WeakMap();
function keyOfTarget(target) {
	if (typeof target === "number") return `#${String(target)}`;
	const key = keys.get(target) ?? target.join(" ");
	keys.set(target, key);
	return key;
}
var stood = new WeakMap();
function standingOf(edits, done) {
	if (done === 0) return NOTHING;
	const known = stood.get(edits);
	if (known?.done === done) return known.standing;
	const standing = after(edits.slice(0, done));
	stood.set(edits, {
		done,
		standing
	});
	return standing;
}
function after(edits) {
	const rejected = new Map();
	const placed = new Map();
	for (const edit of edits) switch (edit.kind) {
		case "reject":
			for (const target of edit.of) rejected.set(keyOfTarget(target), target);
			break;
		case "restore":
			for (const target of edit.of) rejected.delete(keyOfTarget(target));
			break;
		case "add":
			placed.set(keyOfTarget(edit.id), {
				target: edit.id,
				at: edit.at
			});
			break;
		case "move": placed.set(keyOfTarget(edit.of), {
			target: edit.of,
			at: edit.to
		});
	}
	return rejected.size === 0 && placed.size === 0 ? NOTHING : {
		rejected,
		placed
	};
}
var placesByHand = remember((edits) => {
	const places = new Map();
	for (const edit of edits) {
		if (edit.kind !== "add" && edit.kind !== "move") continue;
		const [target, place] = edit.kind === "add" ? [edit.id, edit.at] : [edit.of, edit.to];
		const key = keyOfTarget(target);
		places.set(key, [...places.get(key) ?? [], place]);
	}
	return places;
});
function isNothing({ rejected, placed }) {
	return rejected.size === 0 && placed.size === 0;
}
function freshNumber({ edits }) {
	return edits.reduce((most, edit) => edit.kind === "add" ? Math.max(most, edit.id) : most, 0) + 1;
}
function nameOfEdit(edit) {
	switch (edit.kind) {
		case "reject":
		case "restore": return say("step-matches", {
			kind: edit.kind,
			matches: edit.of.length
		});
		case "add": return say("step-add-match");
		case "move": return say("step-move-match");
	}
}
var exchangedPlace = ([xl, yl, xr, yr]) => [
	xr,
	yr,
	xl,
	yl
];
function exchangedTarget(of) {
	return typeof of === "number" ? of : exchangedPlace(of);
}
function exchanged({ edits, done }) {
	if (edits.length === 0) return NO_HISTORY;
	const other = (edit) => {
		switch (edit.kind) {
			case "reject":
			case "restore": return {
				kind: edit.kind,
				of: edit.of.map(exchangedTarget)
			};
			case "add": return {
				...edit,
				at: exchangedPlace(edit.at)
			};
			case "move": return {
				kind: "move",
				of: exchangedTarget(edit.of),
				to: exchangedPlace(edit.to)
			};
		}
	};
	return {
		edits: edits.map(other),
		done
	};
}
// www/pair/state/marks.ts
var UNMEASURED = {
	col: NaN,
	row: NaN,
	x_mm: NaN,
	y_mm: NaN
};
var isMeasured$1 = ({ col, row }) => Number.isFinite(col) && Number.isFinite(row);
var isWhole$1 = (mark) => isMeasured$1(mark) && Number.isFinite(mark.x_mm) && Number.isFinite(mark.y_mm);
function withCoordinatesOf(marks, others) {
	const known = ({ x_mm, y_mm }) => Number.isFinite(x_mm) && Number.isFinite(y_mm);
	let isSame = true;
	const all = Array.from({ length: Math.max(marks.length, others.length) }, (_, i) => {
		const [own, other] = [marks[i] ?? UNMEASURED, others[i]];
		if (other === void 0 || !known(other) || known(own)) return own;
		isSame = false;
		return {
			...own,
			x_mm: other.x_mm,
			y_mm: other.y_mm
		};
	});
	return isSame ? null : all;
}
var wholeMarks = ({ fiducials }) => fiducials.filter(isWhole$1);
var measuredPhoto = (photo) => ({
	...photo,
	fiducials: wholeMarks(photo)
});
function placeOfMark({ origin }, mark) {
	const [left, top] = origin ?? [0, 0];
	return mark !== void 0 && isMeasured$1(mark) ? [mark.col - left, mark.row - top] : null;
}
var markInHand = ({ mark, photos }) => mark === null ? void 0 : photos[mark.side].fiducials[mark.index];
// www/pair/state/cameras.ts
var factsOf = remember((left, right, areMarksLeft, areMarksRight) => {
	const facts = (info, other, has_marks) => {
		const { width, height } = info ?? other ?? {
			width: 1,
			height: 1
		};
		return {
			width_px: width,
			height_px: height,
			exif: info?.camera ?? null,
			has_marks
		};
	};
	return [facts(left, right, areMarksLeft), facts(right, left, areMarksRight)];
});
function photoFacts({ photos, results: { openLeft, openRight } }) {
	const areMarks = (side) => wholeMarks(photos[side]).length > 0;
	return factsOf(openLeft?.value.info, openRight?.value.info, areMarks("left"), areMarks("right"));
}
var camerasOf$1 = remember((given, facts) => pair_cameras(given, ...facts));
function pairCameras(state) {
	return camerasOf$1(state.camera, photoFacts(state));
}
// www/pair/state/interior.ts
var paired = remember((left, right, cameras) => ({
	...cameras,
	left: left.interior,
	right: right.interior,
	focal_mm: cameras.left.focal_mm
}));
function knownInterior(state) {
	const cameras = pairCameras(state);
	const { interiorLeft, interiorRight } = state.results;
	if ("missing" in cameras || interiorLeft === void 0 || interiorRight === void 0) return null;
	return paired(interiorLeft.value, interiorRight.value, cameras);
}
var assumed = remember((geometry, facts) => geometry === null ? null : assumed_interior(geometry, ...facts));
function assumedInterior(state) {
	const cameras = pairCameras(state);
	const { match } = state.results;
	if (!("missing" in cameras) || cameras.missing.kind === "panorama" || state.camera !== null || match === void 0) return null;
	return assumed(match.value.geometry, photoFacts(state));
}
function interiorInUse(state) {
	return "missing" in pairCameras(state) ? assumedInterior(state) : knownInterior(state);
}
// www/pair/state/truth.ts
function truthOf(state) {
	const { truth, images } = state;
	return truth !== null && images.left?.id === truth.leftId && images.right?.id === truth.rightId ? truth : null;
}
// www/pair/state/state.ts
var SIDES = ["left", "right"];
function otherSide(side) {
	return side === "left" ? "right" : "left";
}
var ALL_MATCHES = {
	kind: "all",
	conditions: {}
};
var TYPED_PARTS = [
	"settings",
	"camera",
	"photos",
	"offset"
];
var UNEDITED = {
	history: NO_HISTORY,
	maskSteps: NO_HISTORY,
	markSteps: NO_HISTORY,
	chosen: [],
	filter: ALL_MATCHES,
	before: null,
	draft: null,
	outline: null,
	mark: null
};
var INITIAL = {
	catalogue: null,
	settings: null,
	refused: {},
	images: {
		left: null,
		right: null
	},
	photos: {
		left: {
			fiducials: [],
			origin: null
		},
		right: {
			fiducials: [],
			origin: null
		}
	},
	masks: {
		left: null,
		right: null
	},
	givenMasks: {
		left: null,
		right: null
	},
	camera: null,
	fiducialModel: "affine",
	offset: null,
	truth: null,
	flight: null,
	results: {},
	running: {},
	failures: {},
	paused: false,
	selection: null,
	...UNEDITED,
	shelf: new Map(),
	tool: "look",
	activeSide: "left",
	views: {
		left: null,
		right: null
	},
	display: {
		points: "matched",
		lines: "some",
		vectors: 0,
		linked: true,
		magnifier: false,
		hidden: [],
		...OWN_LIGHT
	},
	notice: null
};
// www/pair/state/one-image.ts
var reasonOf$1 = remember(({ matches }, { info: left }, { info: right }) => one_image(matches, left.width, left.height, right.width, right.height));
function oneImage({ photos, results: { match, openLeft, openRight } }) {
	if (SIDES.every((side) => wholeMarks(photos[side]).length > 0)) return null;
	return match === void 0 || openLeft === void 0 || openRight === void 0 ? null : reasonOf$1(match.value, openLeft.value, openRight.value);
}
// www/pair/state/keys.ts
var numbers$1 = new Map();
function shortName(parts) {
	const text = JSON.stringify(parts);
	let name = numbers$1.get(text);
	if (name === void 0) {
		name = `k${String(numbers$1.size)}`;
		numbers$1.set(text, name);
	}
	return name;
}
var standings = new WeakMap();
var lastStanding = 0;
function withEdits({ history }, match) {
	const standing = standingOf(history.edits, history.done);
	if (isNothing(standing)) return match;
	const number = standings.get(standing) ?? ++lastStanding;
	standings.set(standing, number);
	return keyOf("edited", [match], number);
}
function keyOf(kind, inputs, options = null) {
	return inputs.includes(null) ? null : shortName([
		kind,
		inputs,
		options
	]);
}
function comparesGreyValues({ matching }) {
	return matching.strategy === "correlation" || matching.strategy === "least-squares";
}
function comparesGradients(settings) {
	return inFull(settings).matching.strategy === "gradient";
}
var inFull = remember(resolved);
function comparesMoments(settings) {
	return !comparesGreyValues(settings) && !comparesGradients(settings);
}
function pointSettings(settings) {
	const gradients = comparesGradients(settings);
	const scales = gradients || settings.points.operator === "multiscale";
	return [
		settings.points,
		scales ? settings.multiscale : null,
		gradients ? settings.gradient : null
	];
}
function estimatedFrom(state, settings, match) {
	const result = state.results.match;
	const tellsNone = result !== void 0 && result.key === match && assumedInterior(state) === null;
	return comparesGradients(settings) && !tellsNone ? keyOf("assumed", [], photoFacts(state)) : null;
}
function withoutBase(state, match) {
	const result = state.results.match;
	return result !== void 0 && result.key === match && (result.value.geometry?.degenerate === "pure-rotation" || oneImage(state) !== null);
}
function isPoor({ results, failures }, match, orientation) {
	if (match === null || results.match?.key !== match) return false;
	if (orientation === null || failures.orientation?.key === orientation) return true;
	return results.orientation?.key === orientation && results.orientation.value.verdict.kind !== "oriented";
}
function openKey(state, side) {
	const image = state.images[side];
	return image === null ? null : keyOf("open", [], image.id);
}
function ofCameras(settings, interiors) {
	if (settings === null) return [];
	if (comparesGradients(settings)) return [...interiors, settings.geometry];
	return settings.matching.epipolar ? [...interiors, settings.orientation] : [];
}
function knownOfDraft({ draft }) {
	return draft === null ? null : [draft.side, draft.places[otherSide(draft.side)]];
}
function compute(state) {
	const { settings } = state;
	const openLeft = openKey(state, "left");
	const openRight = openKey(state, "right");
	const points = (side, open) => settings === null ? null : keyOf("points", [open], [pointSettings(settings), state.masks[side]?.id]);
	const pointsLeft = points("left", openLeft);
	const pointsRight = points("right", openRight);
	const described = settings === null || !comparesMoments(settings) ? [] : [settings.window, settings.matching.strategy];
	const descriptorsLeft = keyOf("descriptors", [pointsLeft], described);
	const descriptorsRight = keyOf("descriptors", [pointsRight], described);
	const gradients = settings !== null && comparesGradients(settings);
	const given = state.offset === null ? keyOf("offset", [openLeft, openRight]) : keyOf("offset", [], state.offset);
	const offset = gradients ? null : given;
	const cameras = pairCameras(state);
	const interior = (side, open) => "missing" in cameras ? null : keyOf("interior", [open], [
		cameras[side],
		cameras.left.focal_mm,
		side,
		measuredPhoto(state.photos[side]),
		state.fiducialModel
	]);
	const interiorLeft = interior("left", openLeft);
	const interiorRight = interior("right", openRight);
	const together = "missing" in cameras ? null : keyOf("together", [], [cameras.doubt, cameras.one_lens]);
	const match = keyOf("match", [
		descriptorsLeft,
		descriptorsRight,
		gradients ? "" : offset
	], [settings?.matching, ofCameras(settings, [
		interiorLeft,
		interiorRight,
		together
	])]);
	const unknown = settings === null || "missing" in cameras && cameras.missing.kind === "panorama" ? null : estimatedFrom(state, settings, match);
	const interiors = "missing" in cameras ? [unknown] : [
		interiorLeft,
		interiorRight,
		together
	];
	const orientable = withoutBase(state, match) ? null : "";
	const truth = truthOf(state);
	const edited = withEdits(state, match);
	const placed = standingOf(state.history.edits, state.history.done).placed.size > 0;
	const orientation = (matches) => keyOf("orientation", [
		matches,
		orientable,
		...interiors
	], settings?.orientation);
	return {
		keys: {
			openLeft,
			openRight,
			pointsLeft,
			pointsRight,
			descriptorsLeft,
			descriptorsRight,
			offset,
			match,
			interiorLeft,
			interiorRight,
			orientation: orientation(edited),
			score: keyOf("score", [edited, truth === null ? null : ""], [truth?.leftId, truth?.rightId]),
			difference: gradients || !isPoor(state, match, orientation(edited)) ? null : keyOf("difference", [openLeft, openRight]),
			line: keyOf("line", [match, state.draft === null ? null : ""], knownOfDraft(state)),
			inspection: keyOf("inspection", [placed ? edited : match, state.selection === null ? null : ""], [state.selection, settings?.window])
		},
		run: orientation(match)
	};
}
var last = null;
function computed(state) {
	if (last?.state !== state) last = {
		state,
		...compute(state)
	};
	return last;
}
function wantedKeys(state) {
	return computed(state).keys;
}
function runKey(state) {
	return computed(state).run;
}
function isCurrent(state, stage) {
	const key = wantedKeys(state)[stage];
	return key !== null && state.results[stage]?.key === key;
}
function isStale(state, stage) {
	const key = wantedKeys(state)[stage];
	return key !== null && state.results[stage] !== void 0 && state.results[stage].key !== key;
}
// www/pair/state/codes.ts
var RULES = [
	"matched",
	"no_descriptor",
	"no_candidate",
	"threshold",
	"ambiguous",
	"many_to_one",
	"parallax",
	"border",
	"left_right",
	"not_converged",
	"imprecise",
	"frame"
];
var CODES = [
	...RULES,
	"gross_error",
	"undecided",
	"rejected_by_hand",
	"manual"
];
function codeOf(name) {
	return CODES.indexOf(name);
}
var MATCHED = codeOf("matched");
var GROSS_ERROR = codeOf("gross_error");
var UNDECIDED = codeOf("undecided");
var BY_HAND = codeOf("rejected_by_hand");
var MANUAL = codeOf("manual");
var OF_MATCHES = [
	MATCHED,
	GROSS_ERROR,
	BY_HAND,
	MANUAL
];
var REFUSALS = RULES.filter((rule) => rule !== "matched");
function checkRules(names) {
	if (names.length !== RULES.length || RULES.some((rule, i) => names[i] !== rule)) throw new Error(`the page and the program do not fit each other: rules ${names.join(", ")}`);
}
// www/pair/state/edited.ts
var NO_POINT = 4294967295;
var SAME_PLACE_PX = .5;
function isManual({ matches }, row) {
	return matches[5 * row + 4] === -1;
}
function isMeasured(edited, { placed }, left) {
	const row = rowOfEdited(edited.match)[left] ?? -1;
	if (row >= 0) return isManual(edited.match, row);
	const target = targetOfLeft(edited, left);
	return target !== null && placed.has(keyOfTarget(target));
}
var rowsByPixel = remember((matches) => {
	const cells = new Map();
	for (let row = 0; 5 * row < matches.length; row++) {
		const cell = pixelOf(matches[5 * row] ?? NaN, matches[5 * row + 1] ?? NaN);
		const rows = cells.get(cell);
		if (rows === void 0) cells.set(cell, [row]);
		else rows.push(row);
	}
	return cells;
});
var COLUMNS = 2 ** 24;
function pixelOf(x, y) {
	return Math.floor(y) * COLUMNS + Math.floor(x);
}
var HERE = [[0, 0]];
var AROUND = [
	-1,
	0,
	1
].flatMap((dy) => [
	-1,
	0,
	1
].map((dx) => [dx, dy]));
function distances(matches, row, [xl, yl, xr, yr]) {
	const [ul = NaN, vl = NaN, ur = NaN, vr = NaN] = matches.subarray(5 * row, 5 * row + 4);
	return [(ul - xl) ** 2 + (vl - yl) ** 2, (ur - xr) ** 2 + (vr - yr) ** 2];
}
function rowsOf(matches, targets) {
	const cells = rowsByPixel(matches);
	const taken = new Set();
	const rows = new Map();
	const claim = (key, place, around, accepts) => {
		let best = null;
		for (const [dx, dy] of around) for (const row of cells.get(pixelOf(place[0] + dx, place[1] + dy)) ?? []) {
			const [left, right] = distances(matches, row, place);
			if (taken.has(row) || !accepts(left, right)) continue;
			if (best === null || left < best[1] || left === best[1] && right < best[2]) best = [
				row,
				left,
				right
			];
		}
		if (best === null) return;
		taken.add(best[0]);
		rows.set(key, best[0]);
	};
	for (const [key, place] of targets) claim(key, place, HERE, (left, right) => left === 0 && right === 0);
	for (const [key, place] of targets) if (!rows.has(key)) claim(key, place, AROUND, (left) => left <= SAME_PLACE_PX ** 2);
	return rows;
}
var Rows = class {
	found;
	matches;
	fits;
	indices;
	count = 0;
	constructor(found, most) {
		this.found = found;
		this.matches = new Float64Array(5 * most);
		this.fits = new Float64Array(5 * most);
		this.indices = new Uint32Array(2 * most);
	}
	keep(row) {
		for (let k = 0; k < 5; k++) {
			this.matches[5 * this.count + k] = this.found.matches[5 * row + k] ?? NaN;
			this.fits[5 * this.count + k] = this.found.fits[5 * row + k] ?? NaN;
		}
		this.indices[2 * this.count] = this.found.indices[2 * row] ?? 0;
		this.indices[2 * this.count + 1] = this.found.indices[2 * row + 1] ?? 4294967295;
		this.count += 1;
	}
	place(left, at) {
		this.matches.set([...at, -1], 5 * this.count);
		this.fits.fill(NaN, 5 * this.count, 5 * this.count + 5);
		this.indices.set([left, NO_POINT], 2 * this.count);
		this.count += 1;
	}
	get all() {
		const { matches, fits, indices, count } = this;
		return {
			matches: matches.slice(0, 5 * count),
			fits: fits.slice(0, 5 * count),
			indices: indices.slice(0, 2 * count)
		};
	}
};
function longer(values, more) {
	const copy = new values.constructor(values.length + more);
	copy.set(values);
	return copy;
}
function applied(left, found, standing) {
	return isNothing(standing) ? {
		left,
		match: found,
		found,
		appended: [],
		lost: 0
	} : new Applying(left, found, standing).edited();
}
function placesOf({ rejected, placed }) {
	const places = new Map();
	for (const [key, { target }] of placed) if (typeof target !== "number") places.set(key, target);
	for (const [key, target] of rejected) if (typeof target !== "number") places.set(key, target);
	for (const [key, { target, at }] of placed) if (typeof target === "number" && !rejected.has(key)) places.set(key, at);
	return places;
}
var Applying = class {
	left;
	found;
	standing;
	count;
	rows;
	points;
	rules;
	best;
	places;
	measures;
	appended = [];
	constructor(left, found, standing) {
		this.left = left;
		this.found = found;
		this.standing = standing;
		this.count = left.length / 3;
		const most = standing.placed.size;
		this.rows = new Rows(found, found.matches.length / 5 + most);
		this.points = longer(left, 3 * most);
		this.rules = longer(found.rules, most);
		this.best = longer(found.best, most);
		this.places = longer(found.places, 2 * most);
		this.measures = longer(found.measures, 2 * most);
	}
	edited() {
		const { found, left, standing, appended } = this;
		const rowOf = rowsOf(found.matches, placesOf(standing));
		const keyOfRow = new Map([...rowOf].map(([key, row]) => [row, key]));
		const handled = new Set();
		for (let row = 0; 5 * row < found.matches.length; row++) {
			const key = keyOfRow.get(row);
			if (key === void 0) this.rows.keep(row);
			else if (this.change(row, key)) handled.add(key);
		}
		for (const [key, { target, at }] of standing.placed) if (!handled.has(key)) this.append(key, target, at);
		const lost = [...standing.rejected.keys()].filter((key) => !rowOf.has(key) && !standing.placed.has(key)).length;
		const all = this.count + appended.length;
		return {
			left: appended.length === 0 ? left : this.points.slice(0, 3 * all),
			match: this.match(all),
			found,
			appended,
			lost
		};
	}
	change(row, key) {
		const { found, standing } = this;
		const own = found.indices[2 * row] ?? 0;
		const { target, at } = standing.placed.get(key) ?? {};
		if (!(at === void 0 || typeof target !== "number" && at[0] === found.matches[5 * row] && at[1] === found.matches[5 * row + 1])) {
			this.rules[own] = UNDECIDED;
			this.decide(own, NaN, NaN);
			return false;
		}
		if (at !== void 0) this.decide(own, at[2], at[3]);
		if (standing.rejected.has(key)) this.rules[own] = BY_HAND;
		else if (at === void 0) this.rows.keep(row);
		else this.rows.place(own, at);
		return true;
	}
	append(key, target, at) {
		const index = this.count + this.appended.length;
		const rejected = this.standing.rejected.has(key);
		this.appended.push(target);
		this.points.set([
			at[0],
			at[1],
			0
		], 3 * index);
		this.rules[index] = rejected ? BY_HAND : MATCHED;
		this.decide(index, at[2], at[3]);
		if (!rejected) this.rows.place(index, at);
	}
	decide(index, x, y) {
		this.best[index] = -1;
		this.places.set([x, y], 2 * index);
		this.measures.fill(Infinity, 2 * index, 2 * index + 2);
	}
	match(all) {
		const used = this.rows.all;
		return {
			...this.found,
			...used,
			counts: {
				...this.found.counts,
				matches: used.matches.length / 5
			},
			rules: this.rules.slice(0, all),
			best: this.best.slice(0, all),
			places: this.places.slice(0, 2 * all),
			measures: this.measures.slice(0, 2 * all)
		};
	}
};
function countsByHand(match) {
	let manual = 0;
	for (let row = 0; 5 * row < match.matches.length; row++) manual += Number(isManual(match, row));
	return {
		rejected: match.rules.reduce((sum, rule) => sum + Number(rule === BY_HAND), 0),
		manual
	};
}
function keptText({ match, found, lost }) {
	if (match === found && lost === 0) return null;
	const { rejected, manual } = countsByHand(match);
	const of = (number, what) => number === 0 ? [] : [say("matches-by-hand", {
		number,
		what
	})];
	const kept = [...of(rejected, "rejected"), ...of(manual, "measured")];
	const none = lost === 0 ? "" : say("of-more-there-is-no", { lost });
	return `${kept.length === 0 ? say("no-edits-by-hand-apply") : say("kept", { join: kept.join(", ") })}${none}`;
}
var remembered = remember(applied);
function editedPair({ results, history }) {
	const left = results.pointsLeft?.value.points;
	const match = results.match?.value;
	if (left === void 0 || match === void 0 || match.rules.length * 3 !== left.length) return null;
	return remembered(left, match, standingOf(history.edits, history.done));
}
function targetOfLeft({ found, match, appended }, left) {
	const rule = match.rules[left];
	if (rule !== MATCHED && rule !== BY_HAND) return null;
	const count = found.rules.length;
	if (left >= count) return appended[left - count] ?? null;
	const row = rowOfLeft(found)[left] ?? -1;
	if (row < 0) return null;
	const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = found.matches.subarray(5 * row, 5 * row + 4);
	return [
		xl,
		yl,
		xr,
		yr
	];
}
function rowsOfLefts(match) {
	const rows = new Int32Array(match.rules.length).fill(-1);
	for (let i = 0; i < match.indices.length; i += 2) rows[match.indices[i] ?? 4294967295] = i / 2;
	return rows;
}
var rowOfLeft = remember(rowsOfLefts);
var leftsByTarget = remember((edited) => {
	const lefts = new Map();
	edited.match.rules.forEach((rule, left) => {
		if (rule !== MATCHED && rule !== BY_HAND) return;
		const target = targetOfLeft(edited, left);
		if (target !== null) lefts.set(keyOfTarget(target), left);
	});
	return lefts;
});
function placeOfLeft({ left, match }, index) {
	const [x = NaN, y = NaN] = left.subarray(3 * index, 3 * index + 2);
	const row = rowOfEdited(match)[index] ?? -1;
	const [xr = NaN, yr = NaN] = row >= 0 ? match.matches.subarray(5 * row + 2, 5 * row + 4) : match.places.subarray(2 * index, 2 * index + 2);
	return [
		x,
		y,
		xr,
		yr
	];
}
var rowOfEdited = remember(rowsOfLefts);
// www/pair/state/stages.ts
var STAGES = {
	openLeft: {
		label: say("decoding-the-left-image"),
		worker: "left",
		needs: []
	},
	openRight: {
		label: say("decoding-the-right-image"),
		worker: "right",
		needs: []
	},
	pointsLeft: {
		label: say("detecting-points-left"),
		worker: "left",
		needs: ["openLeft"]
	},
	pointsRight: {
		label: say("detecting-points-right"),
		worker: "right",
		needs: ["openRight"]
	},
	descriptorsLeft: {
		label: say("describing-points-left"),
		worker: "left",
		needs: ["pointsLeft"]
	},
	descriptorsRight: {
		label: say("describing-points-right"),
		worker: "right",
		needs: ["pointsRight"]
	},
	offset: {
		label: say("estimating-the-offset-of-the"),
		worker: "pair",
		needs: ["openLeft", "openRight"]
	},
	match: {
		label: say("matching-2"),
		worker: "pair",
		needs: [
			"descriptorsLeft",
			"descriptorsRight",
			"offset"
		],
		uses: ["interiorLeft", "interiorRight"]
	},
	interiorLeft: {
		label: say("interior-orientation-left"),
		worker: "pair",
		needs: ["openLeft"]
	},
	interiorRight: {
		label: say("interior-orientation-right"),
		worker: "pair",
		needs: ["openRight"]
	},
	orientation: {
		label: say("relative-orientation-2"),
		worker: "pair",
		needs: [
			"match",
			"interiorLeft",
			"interiorRight"
		]
	},
	score: {
		label: say("comparing-with-the-truth"),
		worker: "pair",
		needs: ["match"]
	},
	difference: {
		label: say("comparing-how-the-photos-lie"),
		worker: "pair",
		needs: ["openLeft", "openRight"]
	},
	line: {
		label: say("looking-where-the-point-may"),
		worker: "pair",
		needs: ["match"]
	},
	inspection: {
		label: say("loading-the-selected-point"),
		worker: "pair",
		needs: ["match"]
	}
};
var STAGE_NAMES = Object.keys(STAGES);
// www/pair/state/residuals.ts
function pixelMm(interior) {
	const [[a, b], [d, e]] = interior.parameters;
	return Math.sqrt(Math.abs(a * e - b * d));
}
function countsOf$1({ residuals_mm: residuals, rejected }) {
	const all = residuals.length / 4;
	return {
		all,
		used: all - rejected.length
	};
}
function vectorsOf(side) {
	return remember((match, orientation, interior) => {
		const [[a, b], [d, e]] = interior.parameters;
		const determinant = a * e - b * d;
		const first = side === "left" ? 0 : 2;
		const residuals = orientation.residuals_mm;
		const vectors = new Float64Array(residuals.length);
		for (let i = 0; 4 * i < residuals.length; i++) {
			const vx = residuals[4 * i + first] ?? NaN;
			const vy = residuals[4 * i + first + 1] ?? NaN;
			vectors[4 * i] = match.matches[5 * i + first] ?? NaN;
			vectors[4 * i + 1] = match.matches[5 * i + first + 1] ?? NaN;
			vectors[4 * i + 2] = (e * vx - b * vy) / determinant;
			vectors[4 * i + 3] = (a * vy - d * vx) / determinant;
		}
		return vectors;
	});
}
var residualVectors = {
	left: vectorsOf("left"),
	right: vectorsOf("right")
};
var parallaxResiduals = remember((orientation, interior) => {
	const rejected = new Set(orientation.rejected);
	const pixel = pixelMm(interior);
	const residuals = orientation.residuals_mm;
	const across = (i) => (residuals[4 * i + 3] ?? NaN) - (residuals[4 * i + 1] ?? NaN);
	return Float64Array.from({ length: countsOf$1(orientation).all }, (_, i) => across(i) / pixel).filter((_, i) => !rejected.has(i));
});
// www/pair/state/select.ts
function shownPair(state) {
	const found = pointsOfShownImage(state, "left");
	const right = pointsOfShownImage(state, "right");
	const made = state.results.match?.value ?? null;
	const edited = made !== null && found !== null && right !== null && made.rules.length * 3 === found.length && matchIsOf(made, found, right) ? editedPair(state) : null;
	const result = wantedKeys(state).orientation !== null && !isBarred(state, "orientation") ? state.results.orientation : void 0;
	const key = state.results.match?.key ?? "";
	const orientation = edited === null || result === void 0 ? null : orientationOf(result.value, result.of ?? null, edited, key);
	return {
		left: edited?.left ?? found,
		right,
		match: edited?.match ?? null,
		orientation,
		edited
	};
}
var orientationOf = remember((orientation, of, { match }, key) => {
	const count = match.matches.length / 5;
	if (of === null || of.match === match) return countsOf$1(orientation).all === count ? orientation : null;
	if (of.key !== key) return null;
	const then = rowsThen(of.match, match);
	const wasRejected = new Set(orientation.rejected);
	const points = new Float64Array(9 * count).fill(NaN);
	const residuals = new Float64Array(4 * count).fill(NaN);
	const rejected = [];
	then.forEach((own, row) => {
		if (own < 0) return;
		for (let k = 0; k < 9; k++) points[9 * row + k] = orientation.points[9 * own + k] ?? NaN;
		for (let k = 0; k < 4; k++) residuals[4 * row + k] = orientation.residuals_mm[4 * own + k] ?? NaN;
		if (wasRejected.has(own)) rejected.push(row);
	});
	return {
		...orientation,
		points,
		residuals_mm: residuals,
		rejected
	};
});
function rowsThen(earlier, now) {
	const rowOfLeft = rowsOfLefts(earlier);
	const rows = new Int32Array(now.indices.length / 2).fill(-1);
	for (let row = 0; row < rows.length; row++) {
		const then = rowOfLeft[now.indices[2 * row] ?? 4294967295] ?? -1;
		let same = then >= 0;
		for (let k = 0; same && k < 4; k++) same = earlier.matches[5 * then + k] === now.matches[5 * row + k];
		if (same) rows[row] = then;
	}
	return rows;
}
function pointsOfShownImage(state, side) {
	const opened = side === "left" ? "openLeft" : "openRight";
	if (state.results[opened] === void 0 || state.results[opened].key !== wantedKeys(state)[opened]) return null;
	return state.results[side === "left" ? "pointsLeft" : "pointsRight"]?.value.points ?? null;
}
function matchIsOf(match, left, right) {
	const count = match.indices.length / 2;
	return [0, count - 1].every((i) => {
		if (i < 0 || count === 0) return true;
		const l = match.indices[2 * i] ?? 0;
		const r = match.indices[2 * i + 1] ?? 4294967295;
		return left[3 * l] === match.matches[5 * i] && (r === 4294967295 || 3 * r < right.length);
	});
}
var leftCodes = rememberCodes((left, match, orientation) => {
	const codes = new Uint8Array((left?.length ?? 0) / 3).fill(UNDECIDED);
	if (match === null) return codes;
	codes.set(match.rules);
	for (let row = 0; 5 * row < match.matches.length; row++) if (isManual(match, row)) codes[match.indices[2 * row] ?? 4294967295] = MANUAL;
	for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i] ?? 0] = GROSS_ERROR;
	return codes;
});
var rightCodes = rememberCodes((right, match, orientation) => {
	const codes = new Uint8Array((right?.length ?? 0) / 3).fill(UNDECIDED);
	if (match === null) return codes;
	match.rules.forEach((rule, left) => {
		if (rule === BY_HAND) codes[match.best[left] ?? -1] = BY_HAND;
	});
	for (let i = 1; i < match.indices.length; i += 2) codes[match.indices[i] ?? 4294967295] = MATCHED;
	for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i + 1] ?? 4294967295] = GROSS_ERROR;
	return codes;
});
var matchCodes = rememberCodes((match, orientation) => {
	const codes = new Uint8Array((match?.matches.length ?? 0) / 5);
	for (let row = 0; match !== null && row < codes.length; row++) codes[row] = isManual(match, row) ? MANUAL : MATCHED;
	for (const i of orientation?.rejected ?? []) codes[i] = GROSS_ERROR;
	return codes;
});
var loosePlaces = remember((match, codes) => {
	const most = match === null ? 0 : match.rules.length + codes.length;
	const [points, ofPlaces, lefts] = [
		new Float64Array(3 * most),
		new Uint8Array(most),
		new Uint32Array(most)
	];
	let count = 0;
	const put = (left, code, x, y, measure) => {
		points[3 * count] = x;
		points[3 * count + 1] = y;
		points[3 * count + 2] = measure;
		ofPlaces[count] = code;
		lefts[count] = left;
		count += 1;
	};
	match?.rules.forEach((rule, left) => {
		if (rule !== BY_HAND || (match.best[left] ?? -1) >= 0) return;
		const [x = NaN, y = NaN] = match.places.subarray(2 * left, 2 * left + 2);
		if (!Number.isNaN(x)) put(left, BY_HAND, x, y, 0);
	});
	codes.forEach((code, row) => {
		if (match?.indices[2 * row + 1] !== 4294967295) return;
		const at = (k) => match.matches[5 * row + k] ?? NaN;
		put(match.indices[2 * row] ?? 0, code, at(2), at(3), at(4));
	});
	return {
		points: points.slice(0, 3 * count),
		codes: ofPlaces.slice(0, count),
		lefts: lefts.slice(0, count)
	};
});
var matchOfLeft = remember(rowsOfLefts);
var RUN_STAGES = [
	"openLeft",
	"openRight",
	"pointsLeft",
	"pointsRight",
	"descriptorsLeft",
	"descriptorsRight",
	"offset",
	"match",
	"interiorLeft",
	"interiorRight",
	"orientation",
	"score"
];
function isBarred(state, stage) {
	const failure = state.failures[stage];
	return failure !== void 0 && failure.key === wantedKeys(state)[stage] || STAGES[stage].needs.some((needed) => isBarred(state, needed));
}
function progress(state) {
	const keys = wantedKeys(state);
	const wanted = RUN_STAGES.filter((stage) => keys[stage] !== null);
	return {
		wanted: wanted.length,
		done: wanted.filter((stage) => state.results[stage]?.key === keys[stage] || isBarred(state, stage)).length,
		running: RUN_STAGES.filter((stage) => state.running[stage] !== void 0)
	};
}
function isBusy(state) {
	return Object.keys(state.running).length > 0 || state.notice?.kind === "busy";
}
function currentFailure(state) {
	const keys = wantedKeys(state);
	for (const stage of [
		...RUN_STAGES,
		"inspection",
		"line"
	]) {
		const failure = state.failures[stage];
		if (failure !== void 0 && failure.key === keys[stage]) return {
			stage,
			message: failure.message,
			ended: failure.ended
		};
	}
	return null;
}
function anyStale(state) {
	return RUN_STAGES.some((stage) => isStale(state, stage));
}
// www/pair/state/no-orientation.ts
function whyNone(state) {
	const { results } = state;
	const cameras = pairCameras(state);
	const areOpen = results.openLeft !== void 0 && results.openRight !== void 0;
	const keys = wantedKeys(state);
	const match = isCurrent(state, "match") ? results.match?.value : void 0;
	const missing = areOpen && "missing" in cameras && (match === void 0 ? keys.orientation === null : interiorInUse(state) === null) ? cameras.missing : null;
	if (missing?.kind === "panorama") return missing;
	if (match?.no_geometry != null) return {
		kind: "no_geometry",
		no_geometry: match.no_geometry
	};
	const one = match === void 0 ? null : oneImage(state);
	if (one !== null) return one;
	const few = match === void 0 ? null : few_matches((shownPair(state).match ?? match).counts.matches);
	if (few !== null) return few;
	if (missing !== null) return missing;
	if (match?.geometry?.degenerate === "pure-rotation") return { kind: "pure_rotation" };
	const error = failureOf(state)?.error ?? null;
	return error === null ? null : {
		kind: "refused",
		error
	};
}
function failureOf(state) {
	const keys = wantedKeys(state);
	const stage = [
		"interiorLeft",
		"interiorRight",
		"orientation"
	].find((own) => state.failures[own]?.key === keys[own]);
	return stage === void 0 ? null : state.failures[stage] ?? null;
}
// www/pair/state/shelf.ts
function measuredOn(draft, tool) {
	return {
		draft,
		tool: draft === null ? tool : "measure"
	};
}
function keyOfPair(images) {
	const parts = [images.left, images.right].map((image) => {
		if (image?.source.kind !== "file") return null;
		const { file } = image.source;
		return [
			image.name,
			file.size,
			file instanceof File ? file.lastModified : 0
		];
	});
	return parts.includes(null) ? null : JSON.stringify(parts);
}
function exchangedPair(state, images) {
	const [before, next] = [keyOfPair(state.images), keyOfPair(images)];
	const shelf = new Map(state.shelf);
	const { history: left, draft: leaves } = state;
	if (before !== null && (left.edits.length > 0 || leaves !== null)) shelf.set(before, {
		...left,
		draft: leaves
	});
	const comes = next === null ? void 0 : shelf.get(next);
	const history = comes === void 0 ? NO_HISTORY : {
		edits: comes.edits,
		done: comes.done
	};
	if (next !== null) shelf.delete(next);
	const same = shelf.size === 0 && state.shelf.size === 0;
	return {
		history,
		...measuredOn(comes?.draft ?? null, state.tool),
		shelf: same ? state.shelf : shelf
	};
}
// www/pair/state/project.ts
var NOT_YET = {
	kind: "no_camera",
	side: "left"
};
function projectOf(state, contents) {
	const { settings, camera, offset, photos, fiducialModel, results } = state;
	const { openLeft, openRight, pointsLeft, pointsRight, match, orientation } = results;
	if (![
		"pointsLeft",
		"pointsRight",
		"match"
	].every((stage) => isCurrent(state, stage)) || settings === null || openLeft === void 0 || openRight === void 0) return null;
	const edited = editedPair(state);
	if (pointsLeft === void 0 || pointsRight === void 0 || match === void 0 || edited === null) return null;
	const opened = {
		left: openLeft,
		right: openRight
	};
	const photo = (side) => {
		const { width, height, format, bits_per_sample, camera: named } = opened[side].value.info;
		const name = state.images[side]?.name ?? "";
		const mask = state.masks[side]?.name ?? null;
		return {
			name,
			content: contents[side],
			width_px: width,
			height_px: height,
			format,
			bits_per_sample,
			mask,
			camera: named
		};
	};
	const oriented = isCurrent(state, "orientation") ? orientation?.value ?? null : null;
	const none = oriented === null ? whyNone(state) ?? NOT_YET : null;
	const interior = interiorInUse(state);
	const points = ({ counts, threshold, points: at, frames }) => ({
		counts,
		threshold,
		points: at,
		frames
	});
	const given = (side) => ({
		...measuredPhoto(photos[side]),
		model: fiducialModel
	});
	return {
		images: [photo("left"), photo("right")],
		input: {
			camera,
			offset,
			left: given("left"),
			right: given("right")
		},
		settings,
		output: {
			left: points({
				...pointsLeft.value,
				...appendedTo(pointsLeft.value, edited.left)
			}),
			right: points(pointsRight.value),
			offset: isCurrent(state, "offset") ? results.offset?.value ?? null : null,
			match: filed(edited.match),
			interior,
			pixel_mm: null,
			orientation: oriented,
			no_orientation: none,
			verdict: oriented?.verdict ?? {
				kind: "not_oriented",
				no_orientation: none ?? NOT_YET
			}
		},
		truth: truthFor$1(state),
		edited: editsFor(state, edited)
	};
}
function editsFor({ history: { edits, done } }, { found }) {
	return done === 0 ? null : {
		edits: edits.slice(0, done),
		found
	};
}
function appendedTo({ points, frames }, left) {
	const more = (left.length - points.length) / 3;
	if (more === 0) return {
		points,
		frames
	};
	const own = Array.from({ length: frames.length === 0 ? 0 : more }, () => [1, 0]).flat();
	return {
		points: left,
		frames: Float64Array.from([...frames, ...own])
	};
}
var NO_CANDIDATE = codeOf("no_candidate");
function filed(match) {
	const own = match.rules.reduce((sum, rule) => sum + Number(rule === BY_HAND || rule === UNDECIDED), 0);
	if (own === 0) return match;
	const rules = match.rules.map((rule) => rule === BY_HAND || rule === UNDECIDED ? NO_CANDIDATE : rule);
	return {
		...match,
		rules,
		counts: {
			...match.counts,
			no_candidate: match.counts.no_candidate + own
		}
	};
}
function unfiled(match) {
	const byHand = (rule, left) => rule === NO_CANDIDATE && !Number.isNaN(match.places[2 * left]);
	const own = match.rules.reduce((sum, rule, left) => sum + Number(byHand(rule, left)), 0);
	if (own === 0) return match;
	const rules = match.rules.map((rule, left) => byHand(rule, left) ? BY_HAND : rule);
	return {
		...match,
		rules,
		counts: {
			...match.counts,
			no_candidate: match.counts.no_candidate - own
		}
	};
}
function editsOfFile({ output, edited }) {
	return edited == null ? countsByHand(unfiled(output.match)) : {
		rejected: 0,
		manual: 0
	};
}
function truthFor$1(state) {
	const truth = truthOf(state);
	const score = isCurrent(state, "score") ? state.results.score?.value : void 0;
	return truth === null || score === void 0 ? null : {
		orientation: truth.orientation,
		base_mm: truth.baseMm,
		score
	};
}
function withProject(state, { project, images, overviews, masks }) {
	const { input, settings, truth, edited } = project;
	const [left] = project.images;
	const photo = (side) => ({
		fiducials: input[side]?.fiducials ?? [],
		origin: input[side]?.origin ?? null
	});
	return withResults({
		...state,
		settings,
		camera: input.camera ?? null,
		photos: {
			left: photo("left"),
			right: photo("right")
		},
		fiducialModel: input.left?.model ?? "affine",
		offset: input.offset ?? null,
		images,
		masks,
		givenMasks: masks,
		truth: truth === null ? null : {
			leftId: images.left.id,
			rightId: images.right.id,
			orientation: truth.orientation,
			baseMm: truth.base_mm,
			rightPosition: new Float32Array(),
			leftWidth: left.width_px,
			leftHeight: left.height_px
		},
		refused: {},
		failures: {},
		paused: false,
		selection: null,
		...UNEDITED,
		...exchangedPair(state, images),
		...edited == null ? {} : { history: {
			edits: edited.edits,
			done: edited.edits.length
		} },
		views: {
			left: null,
			right: null
		}
	}, project, standingFor$1({
		project,
		overviews
	}), {});
}
function standingFor$1({ project: { images }, overviews }) {
	const [left, right] = images;
	const info = ({ width_px, height_px, format, bits_per_sample, camera }) => ({
		width: width_px,
		height: height_px,
		format,
		bits_per_sample,
		camera: camera ?? null,
		drone: null
	});
	return {
		openLeft: {
			info: info(left),
			overview: overviews.left
		},
		openRight: {
			info: info(right),
			overview: overviews.right
		}
	};
}
function withResults(state, project, beside, times) {
	const { output, truth, edited } = project;
	let next = {
		...state,
		results: {}
	};
	const put = (stage, value, of) => {
		const key = wantedKeys(next)[stage];
		if (value != null && key !== null) next = {
			...next,
			results: {
				...next.results,
				[stage]: {
					key,
					value,
					milliseconds: times[stage] ?? 0,
					...of === void 0 ? {} : { of }
				}
			}
		};
	};
	const { descriptorsLeft = nothing(), descriptorsRight = nothing() } = beside;
	put("openLeft", beside.openLeft);
	put("openRight", beside.openRight);
	const match = edited == null ? unfiled(output.match) : {
		...output.match,
		...edited.found
	};
	put("pointsLeft", {
		...firstOf(output.left, match.rules.length),
		gradients: descriptorsLeft.gradients
	});
	put("pointsRight", {
		...output.right,
		gradients: descriptorsRight.gradients
	});
	put("descriptorsLeft", descriptorsLeft);
	put("descriptorsRight", descriptorsRight);
	put("offset", output.offset);
	put("interiorLeft", beside.interiorLeft);
	put("interiorRight", beside.interiorRight);
	put("match", match);
	const used = editedPair(next) ?? {
		match,
		found: match
	};
	if (used.match.matches.length === output.match.matches.length) {
		put("orientation", output.orientation, {
			...used,
			key: next.results.match?.key ?? ""
		});
		put("score", truth?.score);
	}
	return next;
}
function firstOf(all, count) {
	return 3 * count === all.points.length ? all : {
		...all,
		points: all.points.slice(0, 3 * count),
		frames: all.frames.slice(0, 2 * count)
	};
}
var nothing = () => ({
	moments: new Float64Array(),
	gradients: new Uint8Array()
});
function withFiles(state, images) {
	const results = { ...state.results };
	for (const side of SIDES.filter((one) => images[one] !== void 0)) {
		const [open, points, descriptors] = OF_IMAGE[side];
		delete results[open];
		if (state.masks[side] === null) {
			delete results[points];
			delete results[descriptors];
		}
	}
	return {
		...state,
		results,
		failures: {},
		images: {
			...state.images,
			...images
		}
	};
}
var OF_IMAGE = {
	left: [
		"openLeft",
		"pointsLeft",
		"descriptorsLeft"
	],
	right: [
		"openRight",
		"pointsRight",
		"descriptorsRight"
	]
};
// www/pair/state/kept.ts
function typedOf({ settings, camera, photos, fiducialModel, offset }) {
	return settings === null ? null : {
		settings,
		camera,
		photos,
		fiducialModel,
		offset
	};
}
function isBlank(state) {
	const { catalogue, settings, flight, images, camera, photos, fiducialModel, offset } = state;
	return catalogue === null || images.left === null && images.right === null && settings === catalogue.defaults && flight === (catalogue.flights[0]?.flight ?? null) && camera === null && photos === INITIAL.photos && fiducialModel === INITIAL.fiducialModel && offset === null;
}
function isWorthKeeping(state) {
	const areOwn = SIDES.every((side) => (state.images[side]?.source.kind ?? "grey") !== "grey");
	const isMatched = state.results.match !== void 0 && isCurrent(state, "openLeft") && isCurrent(state, "openRight");
	return areOwn && isMatched || isEdited(state) || state.draft !== null || SIDES.some((side) => state.masks[side] !== null);
}
function hasMarks({ images, photos, truth }) {
	return truth === null && SIDES.some((side) => images[side] !== null && hasData(photos[side]));
}
function hasData({ fiducials, origin }) {
	return fiducials.length > 0 || origin !== null;
}
var BESIDE = [
	"interiorLeft",
	"interiorRight",
	"descriptorsLeft",
	"descriptorsRight"
];
function isWhole(state) {
	const { wanted, done, running } = progress(state);
	return running.length === 0 && done === wanted && isCurrent(state, "match");
}
function besideOf(state) {
	const beside = {};
	const take = (stage) => {
		const result = state.results[stage];
		if (result !== void 0 && isCurrent(state, stage)) beside[stage] = result.value;
	};
	BESIDE.forEach(take);
	const times = Object.entries(state.results).map(([stage, { milliseconds }]) => [stage, milliseconds]);
	return {
		beside,
		times: Object.fromEntries(times)
	};
}
function unedited(state) {
	return {
		...state,
		history: NO_HISTORY
	};
}
function isEdited({ history }) {
	return !isNothing(standingOf(history.edits, history.done));
}
var OF_EDITS = "edits";
function resultsOf(state) {
	const keys = wantedKeys(state);
	const changes = isEdited(state) ? new Set(["orientation", "score"]) : new Set();
	const stages = [
		"pointsLeft",
		"pointsRight",
		"offset",
		"match",
		"orientation",
		"score",
		...BESIDE
	];
	const value = (stage) => changes.has(stage) ? OF_EDITS : state.results[stage]?.value;
	return [
		...stages.map((stage) => keys[stage] === null ? null : value(stage)),
		state.images,
		state.masks
	];
}
function areSame(kept, now) {
	return now.every((value, i) => value === OF_EDITS || value === kept[i]);
}
function withKept(state, { typed, history, draft, opened, result, ...others }) {
	const given = {
		...typed,
		...others,
		...measuredOn(draft, INITIAL.tool)
	};
	const fresh = {
		...INITIAL,
		catalogue: state.catalogue,
		notice: state.notice,
		...given
	};
	if (result === null) return withOpened({
		...fresh,
		history
	}, opened);
	const made = withResults({
		...fresh,
		...result.typed
	}, result.project, {
		...result.beside,
		...opened
	}, result.times);
	const { orientation } = made.results;
	const before = history.done === 0 || orientation === void 0 ? null : {
		run: runKey(made),
		orientation: orientation.value
	};
	return {
		...made,
		...typed,
		history,
		before
	};
}
function withOpened(state, opened) {
	const results = {};
	for (const stage of ["openLeft", "openRight"]) {
		const [key, value] = [wantedKeys(state)[stage], opened[stage]];
		if (key !== null && value !== void 0) results[stage] = {
			key,
			value,
			milliseconds: 0
		};
	}
	return {
		...state,
		results
	};
}
function bothSides(of) {
	const [left, right] = SIDES.map(of);
	return {
		left,
		right
	};
}
// www/pair/files/ids.ts
var nextId = 1;
var freshId = () => nextId++;
// www/pair/files/of-block.ts
var READERS = [
	(text) => parse_ground_control_points(text).length > 0,
	(text) => areImages(parse_image_measurements(text)),
	(text) => areImages(parse_image_positions(text).rows)
];
function areImages(rows) {
	return rows.length > 0 && rows.every(({ image }) => IMAGE_FILE.test(image));
}
function isOfBlock(text) {
	return READERS.some((reads) => {
		try {
			return reads(text);
		} catch {
			return false;
		}
	});
}
// www/pair/files/told.ts
var problem = (text) => ({
	kind: "problem",
	text
});
var info = (text) => ({
	kind: "info",
	text
});
var unchanged = () => info(say("cancelled-nothing-was-changed"));
var Telling = class {
	store;
	constructor(store) {
		this.store = store;
	}
	tell(told, before = this.store.state.images) {
		const said = [...this.saidMeanwhile(), ...told.filter((one) => one !== null)];
		const bad = said.some(({ kind }) => kind === "problem");
		const { images } = this.store.state;
		const areKept = SIDES.every((side) => images[side] === before[side]) && SIDES.some((side) => before[side] !== null);
		const kept = bad && areKept ? say("the-open-images-are-kept") : "";
		const text = `${said.map((one) => one.text).join(" ")}${kept}`;
		const choices = said.flatMap((one) => one.choices ?? []);
		const notice = {
			kind: bad ? "problem" : "info",
			text,
			...choices.length > 0 && { choices }
		};
		this.store.dispatch({
			type: "notice",
			notice: said.length === 0 ? null : notice
		});
	}
	saidMeanwhile() {
		const { notice } = this.store.state;
		return notice?.kind !== "info" || notice.choices !== void 0 ? [] : [{
			kind: "info",
			text: notice.text
		}];
	}
	failed(what, error, here) {
		here();
		if (error instanceof Cancelled) return unchanged();
		return problem(`${what}: ${sentence(readable(this.store.state.catalogue, messageOf(error)))}`);
	}
};
// www/pair/files/beside.ts
var MASK_SIDE = 1024;
function sideOfMask(mask, index) {
	const [, painted] = /-mask-(left|right)\./u.exec(mask.name) ?? [];
	if (painted !== void 0) return painted;
	if (/right/iu.test(mask.name)) return "right";
	return /left/iu.test(mask.name) || index === 0 ? "left" : "right";
}
function looksLikeTable(text) {
	return /[,;\t]/u.test(text.trimStart().split("\n", 1)[0] ?? "");
}
var BesideFiles = class {
	store;
	engine;
	telling;
	constructor(store, engine, telling) {
		this.store = store;
		this.engine = engine;
		this.telling = telling;
	}
	async mask(file, side, here) {
		const opened = this.store.state.images[side];
		if (opened === null) return problem(say("is-a-mask-of-the", {
			name: file.name,
			side
		}));
		try {
			const { info: photo } = await this.engine.open(side, opened);
			const mask = await this.engine.client("pair").call("mask", {
				file,
				overlaySide: MASK_SIDE
			});
			here();
			if (mask.width !== photo.width || mask.height !== photo.height) return problem(say("has-px-the-image-px", {
				name: file.name,
				width: mask.width,
				height: mask.height,
				side,
				width_2: photo.width,
				height_2: photo.height
			}));
			this.store.dispatch({
				type: "mask",
				side,
				mask: {
					...mask,
					id: freshId(),
					name: file.name,
					source: {
						kind: "file",
						file
					}
				}
			});
			return info(say("masks-of-the-image", {
				name: file.name,
				left_out: 100 * mask.leftOut,
				side
			}));
		} catch (error) {
			return this.telling.failed(say("cannot-be-used-as-a", { name: file.name }), error, here);
		}
	}
	sideOfTable(table, index) {
		if (/right/iu.test(table.name)) return "right";
		if (/left/iu.test(table.name)) return "left";
		return index > 0 || this.store.state.photos.left.fiducials.length > 0 ? "right" : "left";
	}
	async fiducials(file, side, here) {
		let text = "";
		try {
			text = await textIn(file);
		} catch (error) {
			return this.telling.failed(say("cannot-be-opened", { name: file.name }), error, here);
		}
		try {
			const fiducials = await this.engine.client("pair").call("parseFiducials", { text });
			here();
			const { fiducials: out } = this.store.state.photos[side];
			this.store.dispatch({
				type: "marked",
				step: {
					side,
					deed: "given",
					at: 0,
					out,
					put: fiducials
				}
			});
			return info(say("fiducial-of-the-image-from", {
				fiducials: fiducials.length,
				side,
				name: file.name
			}));
		} catch (error) {
			here();
			if (isOfBlock(text)) return problem(say("is-a-table-of-a-block", { name: file.name }));
			const what = say("is-no-photograph-and-no-table", { name: file.name });
			if (!looksLikeTable(text) && !(error instanceof Cancelled)) return problem(sentence(what));
			return this.telling.failed(what, error, here);
		}
	}
	async camera(file, here) {
		try {
			const text = await textIn(file);
			here();
			const { [OWN_SETTINGS]: subject } = fieldsOf(text);
			if (subject === "pair") return info(say("holds-settings", { name: file.name }));
			if (subject !== void 0) return problem(`${file.name}: ${sentence(say("the-file-holds-settings-of", {
				subject: String(subject),
				of: "pair"
			}))}`);
			const camera = await this.engine.client("pair").call("parseCamera", { text });
			here();
			this.store.dispatch({
				type: "camera",
				camera
			});
			return info(say("camera-data-from", { name: file.name }));
		} catch (error) {
			return this.telling.failed(say("holds-no-camera-data", { name: file.name }), error, here);
		}
	}
};
// www/pair/engine/failure.ts
var KEPT = say("images-settings-and-earlier-results");
function advice(stage) {
	switch (stage) {
		case "openLeft":
		case "openRight": return say("try-a-smaller-image-or");
		case "pointsLeft":
		case "pointsRight": return say("try-a-higher-threshold-or");
		case "descriptorsLeft":
		case "descriptorsRight":
		case "match": return say("try-fewer-points-a-higher");
		default: return say("change-a-setting-or-run");
	}
}
function plainMessage(stage, error, catalogue) {
	const text = readable(catalogue, messageOf(error));
	if (!(error instanceof CallError)) return say("failed", {
		label: capital(STAGES[stage].label),
		text,
		kept: KEPT
	});
	switch (error.failure.kind) {
		case "refused": return error.failure.code === "image-too-small" ? `${sideOf$1(stage)}${text}.` : `${capital(text)}.`;
		case "memory": return say("memory-ran-out-while", {
			label: STAGES[stage].label,
			text,
			kept: KEPT,
			stage: advice(stage)
		});
		case "fault": return say("the-program-broke-off-while", {
			label: STAGES[stage].label,
			text,
			kept: KEPT,
			stage: advice(stage)
		});
		case "other": return say("failed-2", {
			label: capital(STAGES[stage].label),
			text,
			kept: KEPT,
			stage: advice(stage)
		});
	}
}
function sideOf$1(stage) {
	const side = /(Left|Right)$/u.exec(stage)?.[1];
	return side === void 0 ? "" : say("image-3", { side });
}
function capital(text) {
	const trimmed = text.endsWith(".") ? text.slice(0, -1) : text;
	return trimmed.charAt(0).toUpperCase() + trimmed.slice(1);
}
// www/pair/engine/nearest.ts
var LEAST_PAIRS = 2e6;
function nearestPieces(left, right, workers, search) {
	const count = left.length / 128;
	const pieces = Math.min(workers, Math.floor(count * (right.length / 128) / LEAST_PAIRS));
	if (pieces < 2) return null;
	const cut = (piece) => Math.round(count * piece / pieces);
	return Promise.all(Array.from({ length: pieces }, (_, piece) => search(cut(piece), cut(piece + 1))));
}
// www/pair/engine/inputs.ts
function needed(state, stage) {
	const result = state.results[stage];
	if (result === void 0) throw new Error(`the stage ${stage} has no result`);
	return result.value;
}
function settingsOf(state) {
	if (state.settings === null) throw new Error("the settings are not loaded");
	return state.settings;
}
function given$1(state, side) {
	const { points: at, frames } = needed(state, side === "left" ? "pointsLeft" : "pointsRight");
	return {
		points: at,
		frames,
		...needed(state, side === "left" ? "descriptorsLeft" : "descriptorsRight")
	};
}
function matchInput(state) {
	const placed = !comparesGradients(settingsOf(state));
	return {
		left: given$1(state, "left"),
		right: given$1(state, "right"),
		offset: placed ? needed(state, "offset") : null
	};
}
// www/pair/state/selected.ts
function placeOf(places, index) {
	if (index < 0) return null;
	const [x = NaN, y = NaN] = places.subarray(2 * index, 2 * index + 2);
	return Number.isNaN(x) || Number.isNaN(y) ? null : [x, y];
}
function leftIndexOf(state, best, rules) {
	const { selection } = state;
	if (selection === null) return -1;
	if (selection.side === "left") return selection.index;
	let found = -1;
	for (let i = 0; i < best.length; i++) {
		if (best[i] !== selection.index) continue;
		if (rules[i] === MATCHED) return i;
		if (found < 0 || rules[i] === BY_HAND && rules[found] !== BY_HAND) found = i;
	}
	return found;
}
var SURROUNDINGS = 1.5;
var MOST_CANDIDATES = 50;
function comparedWindow(state) {
	const settings = settingsOf(state);
	return comparesGreyValues(settings) ? {
		side: settings.matching.template,
		shape: "square"
	} : settings.window;
}
function matchOf$1(state) {
	return editedPair(state)?.match ?? needed(state, "match");
}
function pointsOf(state, side) {
	return needed(state, side === "left" ? "pointsLeft" : "pointsRight");
}
function pointAt(state, side, index) {
	if (index < 0) return null;
	const [x, y] = ((side === "left" ? editedPair(state)?.left : void 0) ?? pointsOf(state, side).points).subarray(3 * index, 3 * index + 2);
	return x === void 0 || y === void 0 ? null : [x, y];
}
async function windowAt(workers, state, side, at) {
	if (at === null) return null;
	const col = Math.floor(at[0]);
	const row = Math.floor(at[1]);
	const worker = await workers.withImage(side, state);
	try {
		return {
			col,
			row,
			report: await worker.call("moments", {
				col,
				row,
				window: comparedWindow(state)
			}),
			problem: null
		};
	} catch (error) {
		if (error instanceof CallError && error.failure.kind === "refused") return {
			col,
			row,
			report: null,
			problem: readable(state.catalogue, error.message)
		};
		throw error;
	}
}
async function featureAt(workers, state, side, index) {
	const at = pointAt(state, side, index);
	if (at === null) return null;
	const { frames, gradients } = pointsOf(state, side);
	if (128 * index >= gradients.length) return null;
	const [scale = 1, direction = 0] = frames.subarray(2 * index, 2 * index + 2);
	const reach = reachOf(state, scale);
	const worker = await workers.withImage(side, state);
	const patch = (factor, turn) => worker.call("patch", {
		x: at[0],
		y: at[1],
		direction: turn,
		reach: factor * reach,
		side: 112
	});
	const [turned, upright] = await Promise.all([patch(1, direction), patch(SURROUNDINGS, 0)]);
	return {
		descriptor: gradients.slice(128 * index, 128 * (index + 1)),
		scale,
		direction,
		reach,
		turned,
		upright
	};
}
function reachOf(state, scale) {
	return 4 * settingsOf(state).gradient.cell * scale;
}
async function placeAt(workers, state, side, at, like, byHand) {
	if (at === null) return null;
	const worker = await workers.withImage(side, state);
	const reach = SURROUNDINGS * (like?.reach ?? reachOf(state, 1));
	return {
		descriptor: null,
		byHand,
		upright: await worker.call("patch", {
			x: at[0],
			y: at[1],
			direction: 0,
			reach,
			side: 112
		})
	};
}
async function lineOf(workers, state) {
	const { selection } = state;
	const at = selection === null ? null : pointAt(state, selection.side, selection.index);
	return selection === null || at === null ? null : seenFrom(workers, state, selection.side, at);
}
async function seenFrom(workers, state, from, at) {
	const { geometry } = needed(state, "match");
	if (geometry === null) return null;
	const side = otherSide(from);
	const { width, height } = needed(state, side === "left" ? "openLeft" : "openRight").info;
	return {
		side,
		positions: await workers.client("pair").call("epipolarLine", {
			from,
			x: at[0],
			y: at[1],
			model: geometry.model,
			interior: knownInterior(state),
			width,
			height
		})
	};
}
async function candidatesOf(workers, state, left) {
	const settings = settingsOf(state);
	if (left < 0 || 3 * left >= pointsOf(state, "left").points.length || comparesGreyValues(settings)) return new Float64Array();
	const worker = workers.client("pair");
	if (!comparesGradients(settings)) return worker.call("candidates", {
		...matchInput(state),
		index: left,
		options: settings.matching
	});
	const [of, among] = [pointsOf(state, "left").gradients, pointsOf(state, "right").gradients];
	return worker.call("gradientCandidates", {
		index: left,
		left: of,
		right: among,
		most: MOST_CANDIDATES
	});
}
async function parallaxOf(workers, state, left) {
	const { matching } = settingsOf(state);
	const { points } = pointsOf(state, "left");
	const offset = comparesGradients(settingsOf(state)) ? null : state.results.offset?.value ?? null;
	if (left < 0 || 3 * left >= points.length || offset === null) return null;
	const { rules, places } = needed(state, "match");
	return await workers.client("pair").call("parallaxDeviation", {
		index: left,
		points,
		match: {
			rules,
			places
		},
		offset,
		options: matching
	}) ?? null;
}
async function comparedOf(workers, state, left) {
	const { best, places } = matchOf$1(state);
	const { selection } = state;
	const right = selection?.side === "right" ? selection.index : best[left] ?? -1;
	if (comparesGradients(settingsOf(state))) {
		const [ofLeft, ofRight] = await Promise.all([featureAt(workers, state, "left", left), featureAt(workers, state, "right", right)]);
		const edited = editedPair(state);
		const byHand = edited !== null && isMeasured(edited, standingOf(state.history.edits, state.history.done), left);
		return {
			left: null,
			right: null,
			features: {
				left: ofLeft ?? await placeAt(workers, state, "left", pointAt(state, "left", left), ofRight, byHand),
				right: ofRight ?? await placeAt(workers, state, "right", placeOf(places, left), ofLeft, byHand)
			}
		};
	}
	const rightAt = selection?.side === "right" ? pointAt(state, "right", selection.index) : placeOf(places, left);
	const [ofLeft, ofRight] = await Promise.all([windowAt(workers, state, "left", pointAt(state, "left", left)), windowAt(workers, state, "right", rightAt)]);
	return {
		left: ofLeft,
		right: ofRight,
		features: null
	};
}
var inspection = async (state, workers) => {
	const { best, rules } = matchOf$1(state);
	const left = leftIndexOf(state, best, rules);
	const [compared, candidates, parallax, line] = await Promise.all([
		comparedOf(workers, state, left),
		candidatesOf(workers, state, left),
		parallaxOf(workers, state, left),
		lineOf(workers, state)
	]);
	return {
		...compared,
		candidates,
		parallax,
		line
	};
};
var line = async (state, workers) => {
	const { draft } = state;
	const from = draft === null ? null : otherSide(draft.side);
	const at = from === null ? null : draft?.places[from];
	return from === null || at == null ? null : seenFrom(workers, state, from, [at[0], at[1]]);
};
// www/pair/engine/runs.ts
var OFFSET_SIDE = 1024;
function open(side) {
	return async (state, workers) => {
		const image = state.images[side];
		if (image === null) throw new Error(`there is no ${side} image`);
		return workers.open(side, image);
	};
}
var NONE$1 = {
	moments: new Float64Array(),
	gradients: new Uint8Array()
};
function points(side) {
	return async (state, workers) => {
		const settings = settingsOf(state);
		const input = {
			settings,
			mask: state.masks[side]?.grey ?? null
		};
		const worker = await workers.withImage(side, state);
		if (comparesGradients(settings)) return worker.call("features", input);
		return {
			...await worker.call("detect", input),
			gradients: NONE$1.gradients
		};
	};
}
function descriptors(side) {
	return async (state, workers) => {
		const found = needed(state, side === "left" ? "pointsLeft" : "pointsRight");
		const settings = settingsOf(state);
		if (!comparesMoments(settings)) return {
			...NONE$1,
			gradients: found.gradients
		};
		const { window, matching } = settings;
		const worker = await workers.withImage(side, state);
		return {
			...NONE$1,
			moments: await worker.call("describe", {
				points: found.points,
				window,
				strategy: matching.strategy
			})
		};
	};
}
var offset = async (state, workers) => {
	if (state.offset !== null) {
		const [dx, dy] = state.offset;
		return workers.client("pair").call("constantOffset", {
			dx,
			dy
		});
	}
	const reduced = async (side) => (await workers.withImage(side, state)).call("reduced", { maxSide: OFFSET_SIDE });
	const [left, right] = await Promise.all([reduced("left"), reduced("right")]);
	return workers.client("pair").call("offset", {
		left,
		right
	}, [left.grey.buffer, right.grey.buffer]);
};
var match = async (state, workers) => {
	const settings = settingsOf(state);
	const ofPair = (settings.matching.epipolar || comparesGradients(settings)) && isCurrent(state, "interiorLeft") && isCurrent(state, "interiorRight") ? knownInterior(state) : null;
	const input = matchInput(state);
	const { gradients: ofLeft = NONE$1.gradients } = input.left;
	const { gradients: ofRight = NONE$1.gradients } = input.right;
	const [worker, nearest] = await Promise.all([workers.withPair(state), comparesGradients(settings) ? workers.nearest(ofLeft, ofRight) : null]);
	return worker.call("match", {
		...input,
		interior: ofPair,
		settings,
		nearest
	});
};
function interior(side) {
	return async (state, workers) => {
		const { info } = needed(state, side === "left" ? "openLeft" : "openRight");
		const cameras = pairCameras(state);
		if ("missing" in cameras) throw new Error(message("no_orientation", cameras.missing));
		const { origin } = state.photos[side];
		return workers.client("pair").call("interior", {
			width: info.width,
			height: info.height,
			camera: cameras[side],
			pairFocalMm: cameras.left.focal_mm,
			fiducials: wholeMarks(state.photos[side]),
			model: state.fiducialModel,
			origin
		});
	};
}
function edited(state) {
	const pair = editedPair(state);
	if (pair === null) throw new Error("the matches are of other points");
	return pair;
}
var orientation = async (state, workers) => {
	const { left, match: used } = edited(state);
	const { matches, fits } = used;
	const ofPair = interiorInUse(state);
	if (ofPair === null) throw new Error("no interior orientation is known");
	const points = [left.length / 3, needed(state, "pointsRight").points.length / 3];
	return workers.client("pair").call("orient", {
		matches,
		fits,
		interior: ofPair,
		options: settingsOf(state).orientation,
		points
	});
};
var score = async (state, workers) => {
	const truth = truthOf(state);
	if (truth === null) throw new Error("these images have no truth");
	const { info } = needed(state, "openRight");
	return workers.client("pair").call("score", {
		matches: edited(state).match.matches,
		leftPoints: edited(state).left,
		rightPosition: truth.rightPosition,
		left: {
			width: truth.leftWidth,
			height: truth.leftHeight
		},
		right: {
			width: info.width,
			height: info.height
		}
	});
};
var difference = async (state, workers) => (await workers.withPair(state)).call("difference", null);
var RUNS = {
	openLeft: open("left"),
	openRight: open("right"),
	pointsLeft: points("left"),
	pointsRight: points("right"),
	descriptorsLeft: descriptors("left"),
	descriptorsRight: descriptors("right"),
	offset,
	match,
	interiorLeft: interior("left"),
	interiorRight: interior("right"),
	orientation,
	score,
	difference,
	inspection,
	line
};
// www/pair/engine/engine.ts
var DEBOUNCE_MS$1 = 150;
var OVERVIEW_SIDE = 2048;
var Engine = class {
	store;
	clients = {
		left: new WorkerClient(say("left-image")),
		right: new WorkerClient(say("right-image")),
		pair: new WorkerClient("pair"),
		preview: new WorkerClient("preview"),
		report: new WorkerClient("report")
	};
	pool = new WorkerPool();
	opened = new Map();
	held = null;
	timer;
	constructor(store) {
		this.store = store;
		store.watch([
			"settings",
			"camera",
			"photos",
			"masks",
			"offset",
			"fiducialModel"
		], () => this.later());
		store.watch([
			"images",
			"selection",
			"history",
			"draft",
			"paused",
			"failures"
		], () => this.update());
	}
	client(name) {
		return this.clients[name];
	}
	open(side, image) {
		if (image.source.kind === "project") return Promise.reject(new Error(say("the-project-does-not-hold", { name: image.name })));
		const client = this.clients[side];
		const tag = lifeTag(client, String(image.id));
		const held = this.opened.get(client);
		if (held?.tag === tag) return held.answer;
		const answer = client.call("open", {
			source: image.source,
			overviewSide: OVERVIEW_SIDE
		});
		this.opened.set(client, {
			tag,
			answer
		});
		answer.catch(() => {
			if (this.opened.get(client)?.answer === answer) this.opened.delete(client);
		});
		return answer;
	}
	async withImage(side, state) {
		const client = this.clients[side];
		const image = state.images[side];
		if (image === null) throw new Error(`there is no ${side} image`);
		await this.open(side, image);
		return client;
	}
	async withPair(state) {
		const client = this.clients.pair;
		const tag = lifeTag(client, `${String(state.images.left?.id)}:${String(state.images.right?.id)}`);
		if (this.held?.tag !== tag) this.held = {
			tag,
			answer: this.holdPair(client, state)
		};
		const { held } = this;
		held.answer.catch(() => {
			if (this.held === held) this.held = null;
		});
		await held.answer;
		return client;
	}
	nearest(left, right) {
		return nearestPieces(left, right, this.pool.size, (first, end) => this.pool.call("nearest", {
			left,
			first,
			end,
			right
		}));
	}
	async holdPair(client, state) {
		const greyOf = async (side) => (await this.withImage(side, state)).call("grey", null);
		const [left, right] = await Promise.all([greyOf("left"), greyOf("right")]);
		return client.call("hold", {
			left,
			right
		}, [left.grey.buffer, right.grey.buffer]);
	}
	cancel() {
		this.stopWorkers();
		this.store.dispatch({ type: "cancelled" });
	}
	swap() {
		this.clients = {
			...this.clients,
			left: this.clients.right,
			right: this.clients.left
		};
		this.store.dispatch({ type: "swap" });
	}
	update() {
		window.clearTimeout(this.timer);
		for (const stage of STAGE_NAMES) {
			const { state } = this.store;
			if (state.paused && !isOfMarks(state, stage) || state.running[stage] !== void 0) continue;
			const key = wantedKeys(state)[stage];
			if (key === null || state.results[stage]?.key === key || state.failures[stage]?.key === key) continue;
			if (isReady(state, stage)) this.run(stage, key);
		}
	}
	later() {
		window.clearTimeout(this.timer);
		this.timer = window.setTimeout(() => this.update(), DEBOUNCE_MS$1);
	}
	stopWorkers() {
		for (const client of Object.values(this.clients)) client.cancel();
		this.pool.cancel();
	}
	async run(stage, key) {
		this.store.dispatch({
			type: "stageStarted",
			stage,
			key
		});
		const started = performance.now();
		const { state } = this.store;
		try {
			const value = await RUNS[stage](state, this);
			const of = stage === "orientation" ? matchesOf(state) : null;
			const result = {
				key,
				value,
				milliseconds: performance.now() - started,
				...of === null ? {} : { of }
			};
			this.store.dispatch({
				type: "stageDone",
				stage,
				result
			});
		} catch (error) {
			this.failed(stage, key, error);
		}
		this.update();
	}
	failed(stage, key, error) {
		if (error instanceof Cancelled) {
			this.store.dispatch({
				type: "stageStopped",
				stage
			});
			return;
		}
		const ended = error instanceof CallError && error.ended;
		const refused = error instanceof CallError ? error.failure.error ?? null : null;
		this.store.dispatch({
			type: "stageFailed",
			stage,
			failure: {
				key,
				ended,
				error: refused,
				message: plainMessage(stage, error, this.store.state.catalogue)
			}
		});
	}
};
function isOfMarks({ tool }, stage) {
	return tool === "fiducials" && (stage === "interiorLeft" || stage === "interiorRight");
}
function matchesOf(state) {
	const pair = editedPair(state);
	return pair === null ? null : {
		...pair,
		key: state.results.match?.key ?? ""
	};
}
function lifeTag(client, what) {
	return `${String(client.generation)}:${what}`;
}
function isReady(state, stage) {
	const { needs, uses = [] } = STAGES[stage];
	const keys = wantedKeys(state);
	const current = (input) => state.results[input]?.key === keys[input];
	return needs.every((input) => keys[input] === null || current(input)) && uses.every((input) => keys[input] === null || current(input) || state.failures[input]?.key === keys[input]);
}
// www/shared/engine/fit.ts
var SEARCH_PX = 9;
function fitInput(left, right, settings) {
	return {
		left: Float64Array.of(...left, 0),
		offset: constant_offset(right[0] - left[0], right[1] - left[1]),
		settings: {
			...settings,
			matching: {
				...settings.matching,
				strategy: "least-squares",
				refine: null,
				epipolar: false,
				search: SEARCH_PX,
				left_right: false
			}
		}
	};
}
function placeOfFit(matches) {
	const [, , x, y] = matches;
	return x === void 0 || y === void 0 ? null : [x, y];
}
// www/pair/engine/fit.ts
async function fitted(state, workers, left, right) {
	const { left: point, offset, settings } = fitInput(left, right, settingsOf(state));
	const { matches } = await (await workers.withPair(state)).call("match", {
		left: { points: point },
		right: { points: new Float64Array() },
		offset,
		interior: null,
		settings,
		nearest: null
	});
	return placeOfFit(matches);
}
function bytesOf$2(edit) {
	return 40 * (edit.kind === "reject" || edit.kind === "restore" ? edit.of.length : 2);
}
function editFrom(value, name) {
	const edit = objectOf(value, name);
	const kind = likeOf(edit.kind, "", `${name}.kind`);
	switch (kind) {
		case "reject":
		case "restore": return {
			kind,
			of: listOf$1(edit.of, `${name}.of`, targetFrom)
		};
		case "add": return {
			kind,
			id: likeOf(edit.id, 0, `${name}.id`),
			at: placeFrom(edit.at, `${name}.at`)
		};
		case "move": return {
			kind,
			of: targetFrom(edit.of, `${name}.of`),
			to: placeFrom(edit.to, `${name}.to`)
		};
		default: throw new Error(say("the-field-kind-is-damaged", { name }));
	}
}
function targetFrom(value, name) {
	return typeof value === "number" ? likeOf(value, 0, name) : placeFrom(value, name);
}
function placeFrom(value, name) {
	const [xl = NaN, yl = NaN, xr = NaN, yr = NaN, ...more] = listOf$1(value, name, (number, at) => likeOf(number, 0, at));
	if (more.length > 0 || [
		xl,
		yl,
		xr,
		yr
	].some(Number.isNaN)) throw new Error(say("the-field-is-damaged", { name }));
	return [
		xl,
		yl,
		xr,
		yr
	];
}
function draftFrom(value, name) {
	const { of, places, side } = objectOf(value, name);
	const { left, right } = objectOf(places, `${name}.places`);
	const placed = (at, own) => orNull(at, (given) => positionFrom(given, `${name}.places.${own}`));
	if (side !== "left" && side !== "right") throw new Error(say("the-field-is-damaged", { name: `${name}.side` }));
	return {
		of: orNull(of, (given) => targetFrom(given, `${name}.of`)),
		places: {
			left: placed(left, "left"),
			right: placed(right, "right")
		},
		side
	};
}
// www/pair/files/sources.ts
var FILE = "pair/file/";
function keptSource(source) {
	return [FILE + nameOf$1(source), {
		value: source,
		bytes: bytesOf$1(source),
		alone: true
	}];
}
function sourceFrom(parts, file) {
	const source = objectOf(parts.get(FILE + file), `file ${file}`);
	if (source.kind === "file" && !(source.file instanceof Blob)) throw new Error(say("an-image-is-damaged"));
	nameOf$1(source, file);
	return source;
}
var keptMask = ({ name, source }) => ({
	name,
	file: nameOf$1(source)
});
function maskFrom(parts, { name, file }) {
	return {
		name,
		source: sourceFrom(parts, file)
	};
}
function bytesOf$1(source) {
	switch (source.kind) {
		case "file": return source.file.size;
		case "grey": return source.grey.byteLength;
		case "project": return 0;
	}
}
// www/pair/files/steps.ts
var OF_STEP = 80;
var OF_CORNER = 24;
var OF_MARK = 80;
var keptSteps = new WeakMap();
var keptMaskSteps = remember(({ edits, done }) => ({
	edits: edits.map(keptMaskStep),
	done
}));
function keptMaskStep(step) {
	const kept = keptSteps.get(step) ?? ("given" in step ? {
		side: step.side,
		given: orNull(step.given, keptMask)
	} : step);
	keptSteps.set(step, kept);
	return kept;
}
function maskStepsFrom(parts, { edits, done }) {
	const own = (kept) => {
		const step = "given" in kept ? {
			side: kept.side,
			given: orNull(kept.given, (mask) => maskFrom(parts, mask))
		} : kept;
		keptSteps.set(step, kept);
		return step;
	};
	return {
		edits: edits.map(own),
		done
	};
}
function bytesOfMaskStep(step) {
	return OF_STEP + ("given" in step ? 0 : OF_CORNER * step.corners.length);
}
function bytesOfMarkStep({ out, put }) {
	return OF_STEP + OF_MARK * (out.length + put.length);
}
function maskStepFrom(value, name) {
	const { side, given, corners, masked } = objectOf(value, name);
	const own = { side: sideFrom(side, `${name}.side`) };
	if (given !== void 0) return {
		...own,
		given: orNull(given, (mask) => keptMaskFrom(mask, `${name}.given`))
	};
	return {
		...own,
		corners: listOf$1(corners, `${name}.corners`, positionFrom),
		masked: likeOf(masked, true, `${name}.masked`)
	};
}
function markStepFrom(value, name) {
	const { side, deed, at, out, put } = objectOf(value, name);
	return {
		side: sideFrom(side, `${name}.side`),
		deed: likeOf(deed, "", `${name}.deed`),
		at: likeOf(at, 0, `${name}.at`),
		out: listOf$1(out, `${name}.out`, markFrom),
		put: listOf$1(put, `${name}.put`, markFrom)
	};
}
function markFrom(value, name) {
	return objectOf(value, name);
}
function keptMaskFrom(value, name) {
	const { name: called, file } = objectOf(value, name);
	return {
		name: likeOf(called, "", `${name}.name`),
		file: likeOf(file, "", `${name}.file`)
	};
}
function sideFrom(value, name) {
	if (value !== "left" && value !== "right") throw new Error(say("the-field-is-damaged", { name }));
	return value;
}
// www/pair/files/journal.ts
var DRAFT = "pair/draft";
var SHELF = "pair/shelf";
var Journal = class {
	edits = new Journal$1("pair/edits", editFrom, bytesOf$2);
	masks = new Journal$1("pair/masks", maskStepFrom, bytesOfMaskStep);
	marks = new Journal$1("pair/marks", markStepFrom, bytesOfMarkStep);
	parts({ history, maskSteps, markSteps, draft, shelf }) {
		const parts = new Map([
			...this.edits.parts(history),
			...this.masks.parts(keptMaskSteps(maskSteps)),
			...this.marks.parts(markSteps)
		]);
		if (draft !== null) parts.set(DRAFT, {
			value: draft,
			bytes: 40
		});
		if (shelf.size > 0) parts.set(SHELF, {
			value: shelf,
			bytes: [...shelf.values()].reduce((sum, other) => sum + this.edits.size(other.edits) + 40, 0)
		});
		return parts;
	}
	read(parts) {
		return {
			history: this.edits.read(parts),
			maskSteps: maskStepsFrom(parts, this.masks.read(parts)),
			markSteps: this.marks.read(parts),
			draft: orNull(parts.get(DRAFT), (draft) => draftFrom(draft, "draft")),
			shelf: shelfFrom(parts.get(SHELF))
		};
	}
};
function shelfFrom(value) {
	if (value === void 0) return new Map();
	if (!(value instanceof Map)) throw new Error(say("the-edits-of-other-pairs"));
	const entry = ([key, kept]) => {
		const { edits, done, draft } = objectOf(kept, "shelf");
		const list = listOf$1(edits, "shelf.edits", editFrom);
		const own = {
			edits: list,
			done: doneFrom(done, list.length, "shelf.done")
		};
		return [likeOf(key, "", "shelf"), {
			...own,
			draft: orNull(draft, (given) => draftFrom(given, "shelf.draft"))
		}];
	};
	return new Map([...value].map(entry));
}
// www/pair/files/export.ts
function rows(values, stride) {
	return Array.from({ length: values.length / stride }, (_, i) => Array.from({ length: stride }, (_, k) => values[i * stride + k] ?? NaN));
}
function imageOf(state, side) {
	const opened = state.results[side === "left" ? "openLeft" : "openRight"]?.value;
	return {
		name: state.images[side]?.name ?? null,
		width: opened?.info.width ?? null,
		height: opened?.info.height ?? null,
		format: opened?.info.format ?? null,
		exif: opened?.info.camera ?? null,
		fiducials: wholeMarks(state.photos[side]),
		origin: state.photos[side].origin,
		mask: state.masks[side]?.name ?? null
	};
}
function framesOf(state, side) {
	const found = state.results[side === "left" ? "pointsLeft" : "pointsRight"]?.value;
	return found === void 0 || found.frames.length === 0 ? null : rows(found.frames, 2);
}
function verdicts(state) {
	const { match } = shownPair(state);
	if (match === null) return null;
	return Array.from(match.rules, (rule, i) => ({
		rule: CODES[rule] ?? String(rule),
		best: match.best[i] === -1 ? null : match.best[i] ?? null,
		place: rows(match.places.subarray(2 * i, 2 * i + 2), 2).map((place) => place.map(finite))[0] ?? null,
		measure: finite(match.measures[2 * i]),
		second: finite(match.measures[2 * i + 1])
	}));
}
function finite(value) {
	return value !== void 0 && Number.isFinite(value) ? value : null;
}
function countsOf(state) {
	const match = (editedPair(state)?.match ?? state.results.match?.value)?.counts;
	const { matches, ...rejected } = match ?? { matches: null };
	return {
		left: state.results.pointsLeft?.value.counts ?? null,
		right: state.results.pointsRight?.value.counts ?? null,
		matches,
		rejected: match === void 0 ? null : rejected
	};
}
function verdictOf$1(state) {
	const verdict = isCurrent(state, "orientation") ? state.results.orientation?.value.verdict : void 0;
	return verdict === void 0 ? null : {
		...verdict,
		text: message$1("pair_verdict", verdict)
	};
}
function camerasOf(state) {
	const cameras = pairCameras(state);
	return "missing" in cameras ? cameras : {
		...cameras,
		from: state.camera === null ? "exif" : "given"
	};
}
function editsOf$1(state) {
	const edited = editedPair(state);
	if (edited === null) return null;
	const { rules, matches } = edited.match;
	const off = Array.from(rules, (_, left) => left).filter((left) => rules[left] === BY_HAND);
	const manual = Array.from({ length: matches.length / 5 }, (_, row) => row).filter((row) => isManual(edited.match, row));
	if (off.length + manual.length === 0) return null;
	return {
		rejected_by_hand: off.map((left) => placeOfLeft(edited, left)),
		measured_by_hand: manual
	};
}
function everything(state) {
	const { left, right, match, orientation } = shownPair(state);
	return {
		program: "tiepoint",
		version: state.catalogue?.version ?? null,
		conventions: {
			pixel: "the centre of the top-left pixel is (0.5, 0.5); x to the right, y down",
			photo: "mm, x to the right, y up, origin at the principal point",
			points: "[x, y, interest value]",
			frames: "for points of many scales: [scale in px, direction in rad from x towards y]",
			matches: "[x left, y left, x right, y right, measure]; the measure of one that was measured by hand is -1",
			match_indices: "[index of the left point, index of the right point], the right one null where the place found is no interest point",
			fits: "least squares matching of each match: [correlation, covariance xx, xy, yy of the right position in px², iterations], null for one that it did not confirm",
			orientation_points: "a match: [residual y-parallax mm, redundancy number, standardised residual, detectable blunder mm, external reliability, weight, X, Y, Z mm]",
			edits: "rejected_by_hand: [x left, y left, x right, y right] of each match; measured_by_hand: indices of matches; left points measured by hand follow those that were found",
			verdicts: "one a left point: the rule that decided, the index of the best right point and its place, the best and the second best measure"
		},
		verdict: verdictOf$1(state),
		settings: state.settings,
		images: {
			left: imageOf(state, "left"),
			right: imageOf(state, "right")
		},
		camera: camerasOf(state),
		fiducial_model: state.fiducialModel,
		given_offset: state.offset,
		offset: isCurrent(state, "offset") ? state.results.offset?.value ?? null : null,
		counts: countsOf(state),
		thresholds: {
			left: state.results.pointsLeft?.value.threshold ?? null,
			right: state.results.pointsRight?.value.threshold ?? null
		},
		points: {
			left: left === null ? null : rows(left, 3),
			right: right === null ? null : rows(right, 3)
		},
		frames: {
			left: framesOf(state, "left"),
			right: framesOf(state, "right")
		},
		matches: match === null ? null : rows(match.matches, 5),
		match_indices: match === null ? null : rows(match.indices, 2).map((pair) => pair.map((index) => index === 4294967295 ? null : index)),
		edits: editsOf$1(state),
		fits: match === null || match.fits.every(Number.isNaN) ? null : rows(match.fits, 5).map((fit) => fit.every(Number.isNaN) ? null : fit.map(finite)),
		verdicts: verdicts(state),
		geometry: match?.geometry ?? null,
		no_geometry: match?.no_geometry == null ? null : {
			...match.no_geometry,
			text: message$1("no_geometry", match.no_geometry)
		},
		interior: {
			left: state.results.interiorLeft?.value ?? null,
			right: state.results.interiorRight?.value ?? null,
			estimated: "missing" in pairCameras(state) ? interiorInUse(state) : null
		},
		orientation: orientation === null ? null : {
			...orientation,
			points: rows(orientation.points, 9).map((point) => point.map(finite))
		},
		truth: trueOrientation(state),
		score: scoreOf(state)
	};
}
function trueOrientation(state) {
	const truth = truthOf(state);
	return truth === null ? null : {
		...truth.orientation,
		base_mm: truth.baseMm
	};
}
function scoreOf(state) {
	const score = state.results.score?.value;
	return score === void 0 || !isCurrent(state, "score") ? null : {
		matches: score.matches,
		strict: score.strict,
		right: score.right,
		missed: score.missed
	};
}
async function exportMatches(state, engine) {
	const { match, orientation } = shownPair(state);
	if (match === null) return null;
	const text = await engine.client("pair").call("matchesCsv", {
		matches: match.matches,
		rejected: orientation?.rejected ?? null
	});
	return save(new Blob([text], { type: "text/csv" }), `${baseName(state)}-matches.csv`);
}
function exportEverything(state) {
	return save(new Blob([JSON.stringify(everything(state))], { type: "application/json" }), `${baseName(state)}.json`);
}
async function exportPicture(state, view) {
	const canvas = view.snapshot();
	const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
	if (blob === null) throw new Error(say("the-picture-is-too-large"));
	return save(blob, `${baseName(state)}.png`);
}
function baseName(state) {
	return [state.images.left?.name, state.images.right?.name].map((name) => (name ?? "image").replace(/\.[^.]+$/u, "")).join("-").replace(/[^\p{L}\p{N}._-]+/gu, "_");
}
// www/pair/files/project.ts
var STANDING_SIDE = 256;
var STANDING_GREY = 128;
async function exportProject(store, engine) {
	const { state } = store;
	const text = await projectText(state, engine);
	if (text === null) throw new Error(say("the-pair-is-not-matched"));
	return save(new Blob([text], { type: "application/octet-stream" }), `${baseName(state)}.tiepoint`);
}
async function projectText(state, engine) {
	const [left, right] = await Promise.all(SIDES.map((side) => contentOf(state, engine, side)));
	const project = projectOf(state, {
		left: left ?? null,
		right: right ?? null
	});
	return project === null ? null : engine.client("pair").call("projectWrite", project);
}
var digests = new WeakMap();
function knowDigest(source, digest) {
	if (source.kind === "file" && digest !== null) digests.set(source.file, digest);
}
function contentOf({ images }, engine, side) {
	return digestOf(images[side]?.source, engine);
}
async function digestOf(source, engine) {
	switch (source?.kind) {
		case "file": {
			const digest = digests.get(source.file) ?? await engine.client("pair").call("digest", { file: source.file });
			digests.set(source.file, digest);
			return digest;
		}
		case "project": return source.content;
		default: return null;
	}
}
async function haveSameContent(a, b, engine) {
	const content = await digestOf(a, engine);
	return content !== null && content === await digestOf(b, engine);
}
async function readProject(engine, file, nextId) {
	const bytes = new Uint8Array(await file.arrayBuffer());
	const project = await engine.client("pair").call("projectOpen", { bytes }, [bytes.buffer]);
	const [left, right] = project.images;
	const of = {
		left,
		right
	};
	const image = (side) => ({
		id: nextId(),
		name: of[side].name,
		source: {
			kind: "project",
			content: of[side].content ?? null
		}
	});
	const overviews = {
		left: await standingFor(left.width_px, left.height_px),
		right: await standingFor(right.width_px, right.height_px)
	};
	const mask = (side) => {
		const { mask: name, width_px: width, height_px: height } = of[side];
		return name == null ? null : {
			id: nextId(),
			name,
			source: {
				kind: "project",
				content: null
			},
			width,
			height,
			grey: new Uint8Array(),
			leftOut: NaN,
			overlay: overviews[side].clear
		};
	};
	return {
		project,
		overviews,
		images: {
			left: image("left"),
			right: image("right")
		},
		masks: {
			left: mask("left"),
			right: mask("right")
		}
	};
}
async function standingFor(width, height) {
	const halvings = Math.max(0, Math.ceil(Math.log2(Math.max(width, height) / STANDING_SIDE)));
	const data = new ImageData(Math.ceil(width / 2 ** halvings), Math.ceil(height / 2 ** halvings));
	const clear = await createImageBitmap(data);
	data.data.fill(STANDING_GREY).forEach((_, i) => {
		if (i % 4 === 3) data.data[i] = 255;
	});
	return {
		bitmap: await createImageBitmap(data),
		halvings,
		clear
	};
}
async function sideOfFile({ images }, engine, file) {
	for (const side of SIDES) {
		const image = images[side];
		if (image?.source.kind !== "project" || image.name !== file.name || image.source.content === null) continue;
		if (await engine.client("pair").call("digest", { file }) === image.source.content) return side;
	}
	return null;
}
// www/pair/files/keep.ts
var GIVEN$1 = "pair";
var RESULT = "pair/result";
var SMALL = 4096;
var QUIET_MS = 300;
var WATCHED = [
	"settings",
	"camera",
	"photos",
	"fiducialModel",
	"offset",
	"images",
	"masks",
	"truth",
	"flight",
	"display",
	"results",
	"history",
	"maskSteps",
	"markSteps",
	"draft",
	"shelf",
	"running",
	"paused"
];
var KeptPairs = class {
	store;
	engine;
	catalogue;
	mode = "pair";
	made = null;
	making = null;
	journal = new Journal();
	timer;
	changed = () => void 0;
	constructor(store, engine, catalogue) {
		this.store = store;
		this.engine = engine;
		this.catalogue = catalogue;
	}
	watch(changed) {
		this.changed = changed;
		this.store.watch(WATCHED, () => {
			changed();
			window.clearTimeout(this.timer);
			this.timer = window.setTimeout(() => void this.make(), QUIET_MS);
		});
	}
	images() {
		const { images } = this.store.state;
		return SIDES.flatMap((side) => images[side]?.name ?? []);
	}
	parts() {
		const { state } = this.store;
		const parts = new Map();
		const given = isBlank(state) ? null : givenOf(state);
		if (given === null) return parts;
		parts.set(GIVEN$1, {
			value: given,
			bytes: SMALL
		});
		for (const [part, kept] of this.journal.parts(state)) parts.set(part, kept);
		for (const given of sourcesOf(state)) if (given !== null) parts.set(...keptSource(given.source));
		const places = state.truth?.rightPosition;
		if (places !== void 0) parts.set(FILE + nameOf$1(places), {
			value: places,
			bytes: places.byteLength,
			alone: true
		});
		if (this.made !== null && this.made.kept.of === filesOf$1(state)) {
			const { kept } = this.made;
			const { descriptorsLeft: left, descriptorsRight: right } = kept.beside;
			const bytes = [left, right].reduce((sum, given) => sum + (given?.gradients.byteLength ?? 0) + (given?.moments.byteLength ?? 0), 0);
			parts.set(RESULT, {
				value: kept,
				bytes: SMALL + kept.project.length + bytes
			});
		}
		return parts;
	}
	async read(parts) {
		const value = parts.get(GIVEN$1);
		if (value === void 0) return () => void 0;
		const kept = givenFrom(value, this.catalogue);
		const { typed, display, flight, paused } = kept;
		const images = bothSides((side) => orNull(kept.images[side], ({ name, file }) => ({
			id: freshId(),
			name,
			source: sourceFrom(parts, file)
		})));
		const byHand = this.journal.read(parts);
		const givenMasks = bothSides((side) => orNull(kept.givenMasks[side], (mask) => maskFrom(parts, mask)));
		const result = await this.result(parts, kept);
		SIDES.forEach((side, place) => {
			const image = images[side];
			if (image !== null) knowDigest(image.source, result?.project.images[place]?.content ?? null);
		});
		const masks = await this.masks(kept, parts, result?.masks ?? {
			left: null,
			right: null
		});
		const opened = { ...result?.standing };
		await Promise.all(SIDES.map(async (side) => {
			const image = images[side];
			if (image !== null && image.source.kind !== "project") opened[side === "left" ? "openLeft" : "openRight"] = await this.engine.open(side, image);
		}));
		const truth = orNull(kept.truth, (known) => truthFrom(known, kept, parts, images));
		return () => {
			this.store.dispatch({
				type: "restored",
				restored: {
					typed,
					display,
					flight,
					paused,
					images,
					masks,
					givenMasks,
					truth,
					...byHand,
					opened,
					result
				}
			});
			if (result !== null) this.made = {
				kept: result.kept,
				results: resultsOf(unedited(this.store.state))
			};
			const names = this.images();
			if (names.length === 0) return;
			const text = say("restored-from-this-browser-2", { title_of: titleOf({
				name: null,
				images: names
			}) });
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "info",
					text
				}
			});
		};
	}
	clear() {
		this.made = null;
		if (Object.keys(this.store.state.running).length > 0) this.engine.cancel();
		this.store.dispatch({ type: "cleared" });
	}
	async settled() {
		window.clearTimeout(this.timer);
		await this.make();
	}
	make() {
		this.making ??= this.makeAll().finally(() => {
			this.making = null;
		});
		return this.making;
	}
	async makeAll() {
		for (;;) {
			const { state } = this.store;
			const typed = typedOf(state);
			if (typed === null || !isWhole(state)) return;
			const results = resultsOf(state);
			if (this.made !== null && areSame(this.made.results, results)) return;
			try {
				const project = await projectText(unedited(state), this.engine);
				if (project !== null) this.made = {
					results,
					kept: {
						project,
						typed,
						of: filesOf$1(state),
						...besideOf(state)
					}
				};
			} catch {}
			this.changed();
			if (this.store.state === state) return;
		}
	}
	async masks({ masks }, parts, standing) {
		const read = async (side) => {
			const kept = masks[side];
			if (kept === null) return null;
			const source = sourceFrom(parts, kept.file);
			if (source.kind !== "file") return orNull(standing[side], (mask) => ({
				...mask,
				source
			}));
			return {
				...await this.engine.client("pair").call("mask", {
					file: source.file,
					overlaySide: MASK_SIDE
				}),
				id: freshId(),
				name: kept.name,
				source
			};
		};
		const [left, right] = await Promise.all([read("left"), read("right")]);
		return {
			left,
			right
		};
	}
	async result(parts, { images, masks }) {
		if (!parts.has(RESULT)) return null;
		const value = objectOf(parts.get(RESULT), "result");
		const kept = {
			project: likeOf(value.project, "", "result.project"),
			typed: typedFrom(value.typed, this.catalogue, "result.typed"),
			of: likeOf(value.of, "", "result.of"),
			beside: objectOf(value.beside, "result.beside"),
			times: objectOf(value.times, "result.times")
		};
		const opened = await readProject(this.engine, new Blob([kept.project]), freshId);
		const files = [
			images.left,
			images.right,
			masks.left,
			masks.right
		].map((given) => given?.file ?? null);
		if (kept.of !== JSON.stringify(files)) return null;
		return {
			...kept,
			kept: value,
			project: opened.project,
			masks: opened.masks,
			standing: standingFor$1(opened)
		};
	}
};
function sourcesOf({ images, masks, givenMasks, maskSteps }) {
	const given = maskSteps.edits.map((step) => "given" in step ? step.given : null);
	return [...[
		images,
		masks,
		givenMasks
	].flatMap((of) => Object.values(of)), ...given];
}
function filesOf$1({ images, masks }) {
	const files = [
		images.left,
		images.right,
		masks.left,
		masks.right
	].map((given) => given === null ? null : nameOf$1(given.source));
	return JSON.stringify(files);
}
function givenOf(state) {
	const typed = typedOf(state);
	const { settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, givenMasks, truth } = state;
	return typed === null ? null : given(settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, givenMasks, truth);
}
var given = remember((settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, givenMasks, truth) => {
	if (settings === null) return null;
	const file = ({ id, name, source }) => ({
		id,
		name,
		file: nameOf$1(source)
	});
	return {
		typed: {
			settings,
			camera,
			photos,
			fiducialModel,
			offset
		},
		display,
		flight,
		paused,
		images: bothSides((side) => orNull(images[side], file)),
		masks: bothSides((side) => orNull(masks[side], file)),
		givenMasks: bothSides((side) => orNull(givenMasks[side], keptMask)),
		truth: orNull(truth, ({ rightPosition, ...known }) => ({
			...known,
			file: nameOf$1(rightPosition)
		}))
	};
});
function givenFrom(value, catalogue) {
	const kept = objectOf(value, "pair");
	const file = (one, name) => ({
		id: likeOf(objectOf(one, name).id, 0, `${name}.id`),
		...keptMaskFrom(one, name)
	});
	const files = (name, read) => {
		const sides = objectOf(kept[name], name);
		return bothSides((side) => orNull(sides[side], (one) => read(one, `${name}.${side}`)));
	};
	const masks = files("masks", file);
	return {
		typed: typedFrom(kept.typed, catalogue, "typed"),
		display: fitted$1(kept.display, INITIAL.display, "display"),
		flight: orNull(kept.flight, (flight) => fitted$1(flight, catalogue.flights[0]?.flight ?? {}, "flight")) ?? null,
		paused: kept.paused === true,
		images: files("images", file),
		masks,
		givenMasks: kept.givenMasks === void 0 ? masks : files("givenMasks", keptMaskFrom),
		truth: orNull(kept.truth, (truth) => objectOf(truth, "truth")) ?? null
	};
}
function typedFrom(value, { defaults }, name) {
	const kept = objectOf(value, name);
	const settings = fitted$1(kept.settings, defaults, `${name}.settings`);
	resolved(settings);
	const camera = orNull(kept.camera, (given) => objectOf(given, `${name}.camera`));
	if (camera !== null) parse_camera(JSON.stringify(camera));
	const offset = orNull(kept.offset, (given) => positionFrom(given, `${name}.offset`));
	if (offset !== null) constant_offset(...offset);
	const photos = objectOf(kept.photos, `${name}.photos`);
	const photo = (side) => {
		const at = `${name}.photos.${side}`;
		const { fiducials, origin } = objectOf(photos[side], at);
		return {
			fiducials: listOf$1(fiducials, `${at}.fiducials`, markFrom),
			origin: orNull(origin, (given) => positionFrom(given, `${at}.origin`))
		};
	};
	const fiducialModel = likeOf(kept.fiducialModel, "", `${name}.fiducialModel`);
	return {
		settings,
		camera,
		photos: bothSides(photo),
		fiducialModel,
		offset
	};
}
function truthFrom(truth, kept, parts, images) {
	const { file, ...known } = truth;
	const rightPosition = parts.get(FILE + file);
	if (!(rightPosition instanceof Float32Array)) throw new Error(say("the-truth-of-the-simulated"));
	nameOf$1(rightPosition, file);
	const idOf = (id) => {
		const side = SIDES.find((one) => kept.images[one]?.id === id);
		return (side === void 0 ? null : images[side]?.id) ?? NaN;
	};
	return {
		...known,
		rightPosition,
		leftId: idOf(truth.leftId),
		rightId: idOf(truth.rightId)
	};
}
// www/pair/files/aside.ts
var PairAside = class {
	store;
	putAside;
	constructor(store, putAside) {
		this.store = store;
		this.putAside = putAside;
	}
	async leave(marksGo, here) {
		here();
		if (!marksGo && !isWorthKeeping(this.store.state)) return [];
		const names = SIDES.flatMap((side) => this.store.state.images[side]?.name ?? []);
		const stays = await this.putAside();
		here();
		if (stays) return [info(say("stay-under-projects", { title_of: titleOf({
			name: null,
			images: names
		}) }))];
		const question = say("cannot-be-kept-in-this", {
			edits: say("the-pair-with-its-marks"),
			step: say("open-the-other-pair"),
			length: 1
		});
		return window.confirm(question) ? [] : null;
	}
};
// www/pair/files/images.ts
var MOST_BYTES = 2 ** 30;
var done = (told) => ({
	told,
	isCancelled: false
});
var ImageFiles = class {
	store;
	engine;
	telling;
	aside;
	toBlock;
	takeHere;
	constructor(store, engine, telling, aside, toBlock, takeHere) {
		this.store = store;
		this.engine = engine;
		this.telling = telling;
		this.aside = aside;
		this.toBlock = toBlock;
		this.takeHere = takeHere;
	}
	async take(files, side, asks, here) {
		const tooLarge = files.find((file) => file.size > MOST_BYTES);
		if (tooLarge !== void 0) return done([problem(say("has-mb-up-to-1", {
			name: tooLarge.name,
			size: Math.round(tooLarge.size / 2 ** 20)
		}))]);
		const known = await Promise.all(files.map((file) => sideOfFile(this.store.state, this.engine, file)));
		here();
		if (known.every((place) => place !== null)) return this.takeFound(files, known, here);
		const sides = files.length === 2 ? ["left", "right"] : [side ?? this.freeSide()];
		const images = {};
		for (const [i, file] of files.entries()) {
			const target = sides[i];
			if (target !== void 0) images[target] = {
				id: freshId(),
				name: file.name,
				source: {
					kind: "file",
					file
				}
			};
		}
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "busy",
				text: say("reading-2", { join: files.map((file) => file.name).join(say("and-between")) })
			}
		});
		return this.check(images, "images", here, asks);
	}
	async takeFound(files, sides, here) {
		const images = {};
		for (const [i, side] of sides.entries()) {
			const [image, file] = [this.store.state.images[side], files[i]];
			if (image !== null && file !== void 0) images[side] = {
				...image,
				source: {
					kind: "file",
					file
				}
			};
		}
		return this.check(images, "found", here);
	}
	async check(images, type, here, asks = false) {
		const entries = Object.entries(images);
		const outcomes = await Promise.allSettled(entries.map(([side, image]) => this.engine.open(side, image)));
		here();
		const isCancelled = outcomes.some((outcome) => outcome.status === "rejected" && outcome.reason instanceof Cancelled);
		if (type === "images" && isCancelled && entries.every(([side]) => this.store.state.images[side] === null)) return {
			told: this.leaveToRun(entries, outcomes),
			isCancelled
		};
		const told = this.failedImages(outcomes.flatMap((outcome, i) => outcome.status === "rejected" ? [{
			name: entries[i]?.[1].name ?? say("the-file"),
			error: outcome.reason
		}] : []));
		if (told.length > 0) {
			const { left, right } = this.store.state.images;
			const opened = entries.filter((_, i) => outcomes[i]?.status === "fulfilled");
			if (left === null && right === null && opened.length > 0) this.store.dispatch({
				type,
				images: Object.fromEntries(opened)
			});
			return {
				told,
				isCancelled
			};
		}
		if (type === "found") {
			this.store.dispatch({
				type,
				images
			});
			return done([]);
		}
		const question = asks ? await this.askOfThird(images) : null;
		here();
		return question === null ? this.show(images, here) : done([question]);
	}
	leaveToRun(entries, outcomes) {
		const refused = (i) => {
			const outcome = outcomes[i];
			return outcome?.status === "rejected" && !(outcome.reason instanceof Cancelled) ? [{
				name: entries[i]?.[1].name ?? "",
				error: outcome.reason
			}] : [];
		};
		const images = Object.fromEntries(entries.filter((_, i) => refused(i).length === 0));
		this.store.dispatch({
			type: "images",
			images,
			waits: true
		});
		return this.failedImages(entries.flatMap((_, i) => refused(i)));
	}
	async askOfThird(images) {
		const { left, right } = this.store.state.images;
		const [[side, third], another] = Object.entries(images);
		const files = [
			left,
			right,
			third
		].flatMap((image) => image === null ? [] : fileOf$2(image));
		if (another !== void 0 || files.length < 3 || await this.isSame(this.store.state.images[side], third)) return null;
		const beside = otherSide(side);
		if (await this.isSame(this.store.state.images[beside], third)) return info(say("is-the-other-image-already", {
			name: third.name,
			side: beside
		}));
		const dismiss = () => this.store.dispatch({
			type: "notice",
			notice: null
		});
		const choices = [
			{
				text: say("open-three-as-a-block"),
				act: () => {
					dismiss();
					this.toBlock(files, []);
				}
			},
			{
				text: say("replace-the-image", { side }),
				act: () => void this.replace(images)
			},
			{
				text: say("keep-the-pair"),
				act: dismiss
			}
		];
		return {
			kind: "info",
			text: say("is-a-third-image", {
				name: third.name,
				side
			}),
			choices
		};
	}
	replace(images) {
		const names = Object.values(images).map(({ name }) => name);
		return this.takeHere(names, async (here) => {
			const before = this.store.state.images;
			const { told } = await this.show(images, here);
			this.telling.tell([...told, this.cameraStays(before)]);
		});
	}
	cameraStays(before) {
		const { images, camera } = this.store.state;
		return SIDES.some((side) => before[side] !== null && images[side]?.id !== before[side].id) && camera !== null && calibrationBehind(camera) === null ? info(say("the-camera-that-was-given-stays")) : null;
	}
	async show(images, here) {
		const { photos, images: former } = this.store.state;
		const marked = await this.marked(images);
		const replaces = SIDES.some((side) => images[side] !== void 0 && former[side] !== null);
		here();
		const aside = replaces ? await this.aside.leave(marked.gone.length > 0, here) : [];
		if (aside === null) return {
			told: [unchanged()],
			isCancelled: true
		};
		this.store.dispatch({
			type: "images",
			images,
			same: marked.same
		});
		return done([...aside, ...marked.gone.map((side) => info(say("marks-went-with-the-image", {
			side,
			marks: photos[side].fiducials.length
		})))]);
	}
	async marked(images) {
		const { images: former, photos, truth } = this.store.state;
		const sides = SIDES.filter((side) => truth === null && images[side] !== void 0 && former[side] !== null && hasData(photos[side]));
		const areSame = await Promise.all(sides.map((side) => this.isSame(former[side], images[side])));
		return {
			same: sides.filter((_, i) => areSame[i]),
			gone: sides.filter((_, i) => !areSame[i])
		};
	}
	isSame(a, b) {
		return a === null || b === void 0 ? Promise.resolve(false) : haveSameContent(a.source, b.source, this.engine);
	}
	failedImages(failed) {
		const refused = [];
		const told = [];
		for (const { name, error } of failed) {
			const breakdown = breakdownOf(error);
			if (breakdown !== null) told.push(problem(say("could-not-be-opened-try", {
				name,
				breakdown
			})));
			else if (!(error instanceof Cancelled)) refused.push({
				name,
				reason: readable(this.store.state.catalogue, messageOf(error))
			});
		}
		if (failed.some(({ error }) => error instanceof Cancelled)) told.push(unchanged());
		return refused.length === 0 ? told : [...told, problem(refusedText(refused))];
	}
	freeSide() {
		const { images, activeSide } = this.store.state;
		if (images.left === null) return "left";
		return images.right === null ? "right" : activeSide;
	}
};
function fileOf$2({ name, source }) {
	if (source.kind !== "file") return [];
	return [source.file instanceof File ? source.file : new File([source.file], name)];
}
// www/pair/files/sort.ts
function sortFiles(files) {
	const isTable = (file) => /\.(csv|txt)$/iu.test(file.name) || file.type === "text/csv";
	const isCamera = (file) => /\.json$/iu.test(file.name) || file.type === "application/json";
	const isProject = (file) => /\.tiepoint$/iu.test(file.name);
	const isMask = (file) => !isTable(file) && !isCamera(file) && !isProject(file) && /(^|[^a-z])masks?([^a-z]|$)/iu.test(file.name);
	return {
		masks: files.filter(isMask),
		tables: files.filter(isTable),
		cameras: files.filter(isCamera),
		projects: files.filter(isProject),
		images: files.filter((file) => !isTable(file) && !isCamera(file) && !isMask(file) && !isProject(file)).sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }))
	};
}
// www/pair/files/open.ts
function editsToldOf({ project }) {
	const { rejected, manual } = editsOfFile(project);
	const of = (number, what) => number === 0 ? [] : [say("matches-by-hand", {
		number,
		what
	})];
	const said = [...of(rejected, "rejected"), ...of(manual, "measured")];
	return said.length === 0 ? null : info(say("it-holds-the-history-of", { join: said.join(say("and-between")) }));
}
var Files = class {
	store;
	engine;
	openProject;
	elsewhere;
	isReady = false;
	started = () => void 0;
	ready = new Promise((resolve) => {
		this.started = resolve;
	});
	telling;
	aside;
	beside;
	images;
	constructor(store, engine, openProject, elsewhere, putAside) {
		this.store = store;
		this.engine = engine;
		this.openProject = openProject;
		this.elsewhere = elsewhere;
		this.telling = new Telling(store);
		this.aside = new PairAside(store, putAside);
		this.beside = new BesideFiles(store, engine, this.telling);
		this.images = new ImageFiles(store, engine, this.telling, this.aside, elsewhere.toBlock, (names, take) => this.takeHere(names, take));
	}
	begin() {
		this.isReady = true;
		this.started();
	}
	async give(found, side, asks = side === null) {
		if (await this.elsewhere.toGround(found)) return;
		await this.take(found.map(({ file }) => file), side, asks);
	}
	async take(files, side, asks = side === null) {
		if (files.length === 0) return;
		await this.takeHere(files.map(({ name }) => name), (here) => this.takeKinds(files, side, asks, here));
	}
	takeHere(names, take) {
		const tell = () => this.telling.tell([info(say("were-not-taken-the-project", {
			files: names.length,
			names: namesText(names)
		}))]);
		return takeHere(this.elsewhere.left, take, tell);
	}
	async takeKinds(files, side, asks, here) {
		this.store.dispatch({
			type: "notice",
			notice: null
		});
		const refused = await refusedKinds(files);
		here();
		const { images, masks, tables, cameras, projects } = sortFiles(files.filter((file) => !refused.has(file)));
		const [project] = projects;
		if (project !== void 0) {
			await this.openProject(project);
			here();
			const others = files.filter((file) => !projects.includes(file));
			if (others.length > 0) await this.take(others, side, asks);
			return;
		}
		if (images.length > 2) {
			this.elsewhere.toBlock(files.filter((file) => !masks.includes(file)), masks);
			return;
		}
		const before = this.store.state.images;
		const told = refused.size === 0 ? [] : [problem(kindsText(refused))];
		const camera = cameras[0];
		if (camera !== void 0) told.push(await this.beside.camera(camera, here));
		const { told: ofImages, isCancelled } = images.length > 0 ? await this.images.take(images, side, asks, here) : {
			told: [],
			isCancelled: false
		};
		if (isCancelled) {
			const names = [...tables, ...masks].map(({ name }) => name);
			this.telling.tell([
				...told,
				...ofImages,
				names.length === 0 ? null : info(say("cancelled-before-they-were-read", {
					files: names.length,
					names: namesText(names)
				}))
			], before);
			return;
		}
		for (const [i, table] of tables.entries()) told.push(await this.beside.fiducials(table, side ?? this.beside.sideOfTable(table, i), here));
		told.push(...ofImages);
		if (camera === void 0) told.push(this.images.cameraStays(before));
		for (const [i, mask] of masks.entries()) told.push(await this.beside.mask(mask, masks.length === 1 && side !== null ? side : sideOfMask(mask, i), here));
		this.telling.tell(told, before);
	}
	takeProject(file) {
		return this.takeHere([file.name], async (here) => {
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "busy",
					text: say("reading", { name: file.name })
				}
			});
			try {
				const opened = await readProject(this.engine, file, freshId);
				const aside = await this.aside.leave(hasMarks(this.store.state), here);
				if (aside === null) return this.telling.tell([unchanged()]);
				this.store.dispatch({
					type: "opened",
					opened
				});
				this.telling.tell([
					info(say("was-opened-the-file-does-not", { name: file.name })),
					editsToldOf(opened),
					...aside
				]);
			} catch (error) {
				this.telling.tell([this.telling.failed(say("cannot-be-opened", { name: file.name }), error, here)]);
			}
		});
	}
	takeMask(file, side) {
		return this.takeHere([file.name], async (here) => {
			this.store.dispatch({
				type: "notice",
				notice: null
			});
			this.telling.tell([await this.beside.mask(file, side, here)]);
		});
	}
	takeFlight(name, flight) {
		const names = bothSides((side) => `${name} ${side}`);
		return this.takeHere(Object.values(names), async (here) => {
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "busy",
					text: say("rendering-the-pair-a-simulated")
				}
			});
			try {
				const pair = await this.engine.client("pair").call("simulate", flight);
				const given = (side) => ({
					id: freshId(),
					name: names[side],
					source: {
						kind: "grey",
						...pair[side]
					}
				});
				const aside = await this.aside.leave(hasMarks(this.store.state), here);
				if (aside === null) return this.telling.tell([unchanged()]);
				this.store.dispatch({
					type: "simulated",
					left: given("left"),
					right: given("right"),
					pair
				});
				this.telling.tell(aside);
			} catch (error) {
				this.telling.tell([this.telling.failed(say("the-pair-could-not-be"), error, here)]);
			}
		});
	}
	async takeSample() {
		const sample = this.store.state.catalogue?.flights.find(({ name }) => name === "sample");
		if (sample !== void 0) await this.takeFlight(sample.name, sample.flight);
	}
};
// www/pair/view/geometry.ts
var GAP = 10;
var CLEARLY = 1.2;
function ratioOf({ openLeft, openRight }) {
	const ratios = [openLeft, openRight].flatMap((opened) => opened === void 0 ? [] : [opened.value.info.width / opened.value.info.height]);
	return ratios.length === 0 ? null : ratios.reduce((sum, ratio) => sum + ratio, 0) / ratios.length;
}
function isBeside(width, height, ratio) {
	if (ratio === null) return width >= .85 * height;
	return Math.min(height / 2, width / ratio) <= CLEARLY * Math.min(height, width / 2 / ratio);
}
function panesOf({ results }, width, height) {
	if (isBeside(width, height, ratioOf(results))) {
		const pane = Math.max(1, Math.floor((width - GAP) / 2));
		return {
			left: {
				left: 0,
				top: 0,
				width: pane,
				height
			},
			right: {
				left: width - pane,
				top: 0,
				width: pane,
				height
			}
		};
	}
	const pane = Math.max(1, Math.floor((height - GAP) / 2));
	return {
		left: {
			left: 0,
			top: 0,
			width,
			height: pane
		},
		right: {
			left: 0,
			top: height - pane,
			width,
			height: pane
		}
	};
}
// www/pair/files/taker.ts
function takerOf(store, view, files) {
	const sideAt = (event) => {
		const box = view.host.getBoundingClientRect();
		const panes = panesOf(store.state, box.width, box.height);
		return SIDES.find((side) => contains(panes[side], event.clientX - box.left, event.clientY - box.top));
	};
	return {
		isActive: () => true,
		markAt: (event) => sideAt(event) ?? "page",
		take: (found, at) => void files.give(found, SIDES.find((side) => side === at) ?? null, true)
	};
}
// www/pair/files/painted.ts
async function paintedMask(engine, state, side, over, areas) {
	try {
		return over === null || over instanceof Uint8Array || areas.length > 0 ? await painted(engine, state, side, over, areas) : await read(engine, over);
	} catch (error) {
		if (error instanceof Cancelled) return null;
		throw error;
	}
}
var worker = (engine) => engine.client("preview");
async function painted(engine, { images }, side, over, areas) {
	const image = images[side];
	if (image === null) throw new Error(`there is no ${side} image`);
	const { info } = await engine.open(side, image);
	const { width, height } = info;
	const under = over === null || over instanceof Uint8Array ? over : fileOf$1(over);
	const { png, ...mask } = await worker(engine).call("paintMask", {
		over: under,
		width,
		height,
		areas,
		overlaySide: MASK_SIDE
	});
	const name = `${image.name.replace(/\.[^.]+$/u, "")}-mask-${side}.png`;
	return {
		...mask,
		id: freshId(),
		name,
		source: {
			kind: "file",
			file: new File([png], name, { type: "image/png" })
		}
	};
}
async function read(engine, file) {
	const { name, source } = file;
	return {
		...await worker(engine).call("mask", {
			file: fileOf$1(file),
			overlaySide: MASK_SIDE
		}),
		id: freshId(),
		name,
		source
	};
}
function fileOf$1({ source }) {
	if (source.kind !== "file") throw new Error(say("an-image-is-damaged"));
	return source.file;
}
// www/pair/state/labels.ts
var EDITED = {
	rejected_by_hand: {
		text: say("matched-then-rejected-by-hand"),
		label: say("rejected-by-hand")
	},
	manual: {
		text: say("measured-by-hand"),
		label: say("measured-by-hand-2")
	}
};
function textOfCode(code, part = "text") {
	const name = CODES[code] ?? "undecided";
	if (name === "rejected_by_hand" || name === "manual") return EDITED[name][part];
	return message("verdict", name, part === "label" ? part : null);
}
// www/pair/state/off-geometry.ts
function distanceFrom(positions, [x, y]) {
	let nearest = Infinity;
	for (let k = 0; k < positions.length; k += 2) {
		const [u = NaN, v = NaN, p = u, q = v] = positions.subarray(k, k + 4);
		const [along, across] = [p - u, q - v];
		const share = ((x - u) * along + (y - v) * across) / (along ** 2 + across ** 2);
		const at = Number.isNaN(share) ? 0 : Math.min(1, Math.max(0, share));
		nearest = Math.min(nearest, Math.hypot(u + at * along - x, v + at * across - y));
	}
	return Number.isFinite(nearest) ? nearest : null;
}
function offGeometryPx(state, { geometry, best, rules, places }) {
	const { selection } = state;
	const line = isCurrent(state, "inspection") ? state.results.inspection?.value.line : null;
	if (selection === null || geometry === null || line == null) return null;
	const left = leftIndexOf(state, best, rules);
	const [x, y] = state.results.pointsLeft?.value.points.subarray(3 * left, 3 * left + 2) ?? [];
	const at = selection.side === "left" ? placeOf(places, left) : x === void 0 || y === void 0 ? null : [x, y];
	const distance = at === null ? null : distanceFrom(line.positions, at);
	return distance !== null && distance > geometry.threshold_px ? distance : null;
}
// www/pair/state/predicted.ts
function isPredicted$1({ best, measures, geometry }, left) {
	return geometry !== null && best[left] === -1 && Number.isFinite(measures[2 * left]);
}
var measuresOf = remember((match) => Float64Array.from({ length: match.matches.length / 5 }, (_, row) => {
	const measure = match.matches[5 * row + 4] ?? NaN;
	return measure === -1 || isPredicted$1(match, match.indices[2 * row] ?? -1) ? NaN : measure;
}));
// www/pair/panel/verdict.ts
function verdictOf(state, shown, match) {
	const { selection, settings } = state;
	const leftIndex = leftIndexOf(state, match.best, match.rules);
	if (selection === null || settings === null) return {
		code: MATCHED,
		text: ""
	};
	if (leftIndex < 0) return {
		code: UNDECIDED,
		text: comparesGreyValues(settings) ? say("no-left-point-was-matched") : say("no-left-point-has-this")
	};
	const code = leftCodes(shown.left, match, shown.orientation)[leftIndex] ?? UNDECIDED;
	const own = selection.side === "left" ? code : rightCodes(shown.right, match, shown.orientation)[selection.index] ?? UNDECIDED;
	const beside = code === CODES.indexOf("parallax") ? besideNeighbours(state) : null;
	return {
		code,
		text: `${selection.side === "right" && own === UNDECIDED ? `${say("candidate-of", { point: leftIndex + 1 })} ` : ""}${beside ?? `${textOfCode(code)} ${numbers(CODES[code] ?? "undecided", leftIndex, match, state, settings)}`}`.trimEnd()
	};
}
function besideNeighbours(state) {
	const { parallax = null } = isCurrent(state, "inspection") ? state.results.inspection?.value ?? {} : {};
	return parallax !== null && parallax.deviation_px > parallax.allowed_px ? say("parallax-beside", { ...parallax }) : null;
}
function numbers(code, index, match, state, settings) {
	const { matching } = settings;
	const gradients = comparesGradients(settings);
	const byGrey = comparesGreyValues(settings);
	const largest = resolved(settings).matching.ambiguity ?? 1;
	const best = match.measures[2 * index] ?? Infinity;
	const second = match.measures[2 * index + 1] ?? Infinity;
	const compared = {
		best,
		second,
		ratio: best / second,
		correlation: 1 - best,
		largest
	};
	switch (code) {
		case "matched":
		case "gross_error":
			if (!Number.isFinite(best)) return "";
			if (isPredicted$1(match, index)) return say("predicted-match", compared);
			if (gradients) return say(agreeing(best, second, largest), compared);
			return byGrey ? say("correlation", compared) : say("good-measure", {
				...compared,
				most: matching.max_measure
			});
		case "threshold":
			if (!Number.isFinite(best)) return "";
			return byGrey ? say("low-correlation", {
				...compared,
				least: matching.min_correlation
			}) : say("large-measure", {
				...compared,
				most: matching.max_measure
			});
		case "ambiguous": return say("ambiguous", compared);
		case "parallax": return gradients ? outOfGeometry(match, {
			...compared,
			off_px: offGeometryPx(state, match)
		}) : say("parallax", { tolerance: matching.parallax_tolerance });
		case "border":
		case "left_right":
			if (byGrey && Number.isFinite(best)) return say("correlation", compared);
			return gradients ? say("distance", compared) : "";
		case "imprecise": return say("imprecise", { most: matching.max_standard_error });
		default: return "";
	}
}
function agreeing(best, second, largest) {
	if (!Number.isFinite(second)) return "only-candidate";
	return best > largest * second ? "agreeing-candidate" : "clear-candidate";
}
function outOfGeometry({ geometry, no_geometry }, compared) {
	if (geometry === null) return say("no-geometry", {
		...compared,
		no_geometry: no_geometry === null ? null : message("no_geometry", no_geometry)
	});
	const off = "fundamental" in geometry.model ? "off-line" : "off-place";
	return say(off, {
		...compared,
		threshold_px: geometry.threshold_px
	});
}
// www/pair/panel/announce.ts
function mountAnnouncements(host, store, details) {
	const keys = byId("keys");
	const text = h("span", {});
	const press = button(say("details"), "selected-details", details);
	press.ariaLabel = say("details-of-the-point");
	fill(host, text, " ", press);
	store.watch([
		"selection",
		"history",
		"results"
	], ([selection]) => {
		const { state } = store;
		host.hidden = selection === null;
		keys.hidden = selection !== null;
		if (selection === null) {
			text.textContent = "";
			return;
		}
		const shown = shownPair(state);
		const points = shown[selection.side];
		const codes = selection.side === "left" ? leftCodes(shown.left, shown.match, shown.orientation) : rightCodes(shown.right, shown.match, shown.orientation);
		const [x, y] = points?.subarray(3 * selection.index, 3 * selection.index + 2) ?? [];
		const label = textOfCode(codes[selection.index] ?? UNDECIDED, "label");
		const why = shown.match === null ? "" : verdictOf(state, shown, shown.match).text;
		const said = say("point-at", {
			side: selection.side,
			index: selection.index + 1,
			x,
			y,
			what: why === "" ? say("n--4", { label }) : why
		});
		if (text.textContent !== said) text.textContent = said;
	});
}
// www/pair/state/calibration.ts
function labelOf({ camera, width, height }) {
	if (camera === null || camera.origin === "panorama" || (camera.cautions ?? []).length > 0) return null;
	return camera.make === null && camera.model === null ? null : camera_label(camera, width, height);
}
var labels = {
	left: remember(labelOf),
	right: remember(labelOf)
};
function named(state, side) {
	const stage = side === "left" ? "openLeft" : "openRight";
	const opened = state.results[stage];
	return opened === void 0 || !isCurrent(state, stage) ? void 0 : labels[side](opened.value.info);
}
function offeredCalibration(state) {
	const { camera, images, photos, results } = state;
	if (camera !== null || SIDES.some((side) => images[side]?.source.kind !== "file" || photos[side].fiducials.length > 0)) return null;
	const label = named(state, "left");
	if (label == null || label !== named(state, "right")) return null;
	return calibrationOf(label, results.openLeft?.value.info.camera?.lens ?? {});
}
function isOfOthers(state) {
	if (state.camera === null) return false;
	const behind = calibrationBehind(state.camera);
	if (behind === null) return false;
	return SIDES.some((side) => {
		const name = state.images[side]?.source.kind === "file" ? named(state, side) : void 0;
		return name !== void 0 && name !== behind.label;
	});
}
// www/pair/panel/calibration.ts
var DAY = new Intl.DateTimeFormat(LANGUAGE === "en" ? "en-GB" : `${LANGUAGE}-u-nu-latn`, { dateStyle: "medium" });
function useCalibration(store) {
	const offered = offeredCalibration(store.state);
	if (offered !== null) store.dispatch({
		type: "camera",
		camera: cameraOfPair(offered)
	});
}
function calibrationGroup(store) {
	const text = h("p", {
		class: "note",
		testid: "calibration"
	});
	const use = button(say("use-the-calibrated-camera"), "use-calibration", () => useCalibration(store));
	const forget = button(say("forget-this-calibration"), "forget-calibration", () => {
		const offered = offeredCalibration(store.state);
		if (offered === null) return;
		forgetCalibration(offered.label);
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: say("the-calibration-is-forgotten")
			}
		});
	});
	const group = h("div", {}, text, h("div", { class: "buttons" }, use, forget));
	store.watch((state) => [offeredCalibration(state)], ([offered]) => {
		group.hidden = offered === null;
		if (offered === null) return;
		const { camera, focalErrorPx: error, images, at } = offered;
		fill(text, say("a-block-calibrated-such-a-camera", {
			images,
			focal: camera.focal_px,
			error,
			day: DAY.format(at)
		}));
	});
	store.watch((state) => [isOfOthers(state)], ([others]) => {
		if (!others) return;
		store.dispatch({
			type: "camera",
			camera: null
		});
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: say("the-calibrated-camera-is-not")
			}
		});
	});
	return group;
}
// www/pair/engine/checks.ts
function refusalOf(call) {
	try {
		call();
		return null;
	} catch (error) {
		if (error instanceof Error && "code" in error) return error;
		throw error;
	}
}
function optionOf(refusal) {
	const error = "error" in refusal ? refusal.error : null;
	return error?.kind === "invalid-option" ? error : null;
}
function allowedInstead(call) {
	const refusal = refusalOf(call);
	if (refusal === null) return null;
	const option = optionOf(refusal);
	return option === null ? messageOf(refusal) : message("allowed", option.allowed);
}
function allowedOfCamera(part) {
	return allowedInstead(() => parse_camera(JSON.stringify({
		focal_mm: 1,
		...part
	})));
}
function allowedOfFocalPx(px, camera) {
	return allowedInstead(() => camera_of_focal_px(px)) ?? allowedOfCamera(camera(px));
}
function allowedOfOffset(dx, dy) {
	return allowedInstead(() => constant_offset(dx, dy));
}
var MARKS = [
	[0, 0],
	[1, 0],
	[0, 1]
].map(([col = 0, row = 0]) => ({
	col,
	row,
	x_mm: col,
	y_mm: -row
}));
function allowedOfOrigin(col, row) {
	return allowedInstead(() => interior$1({ focal_mm: 1 }, {
		width: 1,
		height: 1,
		fiducials: MARKS,
		origin: [col, row]
	}));
}
function problemOfFlight(flight) {
	const refusal = refusalOf(() => check_flight(flight));
	return refusal === null ? null : {
		field: optionOf(refusal)?.field ?? null,
		text: messageOf(refusal)
	};
}
// www/pair/state/focal.ts
function focalOf(state) {
	const { match, orientation } = state.results;
	const [camera] = (isCurrent(state, "orientation") ? orientation?.value.cameras : null) ?? [];
	const interior = interiorInUse(state);
	if (camera === void 0 || interior === null) return null;
	const pixel = pixelMm(interior.left);
	const isEstimated = "missing" in pairCameras(state) && (match?.value.geometry?.focal != null || camera.focal_mm !== interior.focal_mm);
	return {
		focalPx: camera.focal_mm / pixel,
		errorPx: camera.focal_standard_error_mm / pixel,
		isEstimated
	};
}
// www/pair/state/given-camera.ts
var DIGITS = 12;
var DIGITS_OF_FILES = 7;
function rounded(value, digits = DIGITS) {
	return Number(value.toPrecision(digits));
}
function focalPxOf({ focal_mm, pixel_mm }) {
	return pixel_mm == null ? null : rounded(focal_mm / pixel_mm);
}
function withFocalPx(camera, px) {
	if (camera === null) return camera_of_focal_px(px);
	const { focal_mm, pixel_mm } = camera;
	return pixel_mm == null ? {
		...camera,
		pixel_mm: rounded(focal_mm / px)
	} : {
		...camera,
		focal_mm: rounded(pixel_mm * px)
	};
}
function withoutFocalPx(camera) {
	if (camera === null) return null;
	const px = focalPxOf(camera);
	return px !== null && JSON.stringify(camera) === JSON.stringify(camera_of_focal_px(px)) ? null : {
		...camera,
		pixel_mm: null
	};
}
function cameraForBoth(state) {
	const { openLeft, openRight } = state.results;
	if (state.camera !== null || openLeft === void 0 || openRight === void 0) return null;
	const [left, right] = photoFacts(state);
	if (left.width_px !== right.width_px || left.height_px !== right.height_px) return null;
	const [one, other] = SIDES.flatMap((side) => {
		const facts = side === "left" ? left : right;
		const cameras = pair_cameras(null, facts, facts);
		return "missing" in cameras ? [] : [{
			side,
			camera: cameras[side]
		}];
	});
	return one === void 0 || other !== void 0 ? null : {
		...one,
		camera: asTyped(one.camera)
	};
}
function asTyped(camera) {
	const { focal_mm, pixel_mm } = camera;
	const pixel = pixel_mm == null ? {} : { pixel_mm: rounded(pixel_mm, DIGITS_OF_FILES) };
	return {
		...camera,
		focal_mm: rounded(focal_mm, DIGITS_OF_FILES),
		...pixel
	};
}
// www/pair/panel/camera.ts
var NUMBERS = [
	{
		label: say("focal-length"),
		unit: "mm",
		testid: "camera-focal",
		of: (c) => c.focal_mm,
		alone: (v) => ({ focal_mm: v })
	},
	{
		label: say("pixel-size"),
		unit: "mm",
		testid: "camera-pixel",
		of: (c) => c.pixel_mm,
		alone: (v) => ({ pixel_mm: v })
	},
	{
		label: say("principal-pt-x"),
		unit: "mm",
		testid: "camera-x0",
		of: (c) => c.principal_point_mm?.[0],
		alone: (v) => ({ principal_point_mm: [v, 0] })
	},
	{
		label: say("principal-pt-y"),
		unit: "mm",
		testid: "camera-y0",
		of: (c) => c.principal_point_mm?.[1],
		alone: (v) => ({ principal_point_mm: [0, v] })
	},
	{
		label: "k1",
		unit: "mm⁻²",
		testid: "camera-k1",
		of: (c) => c.radial_distortion?.[0],
		alone: (v) => ({ radial_distortion: [
			v,
			0,
			0
		] })
	},
	{
		label: "k2",
		unit: "mm⁻⁴",
		testid: "camera-k2",
		of: (c) => c.radial_distortion?.[1],
		alone: (v) => ({ radial_distortion: [
			0,
			v,
			0
		] })
	},
	{
		label: "k3",
		unit: "mm⁻⁶",
		testid: "camera-k3",
		of: (c) => c.radial_distortion?.[2],
		alone: (v) => ({ radial_distortion: [
			0,
			0,
			v
		] })
	},
	{
		label: "p1",
		unit: "mm⁻¹",
		testid: "camera-p1",
		of: (c) => c.tangential_distortion?.[0],
		alone: (v) => ({ tangential_distortion: [v, 0] })
	},
	{
		label: "p2",
		unit: "mm⁻¹",
		testid: "camera-p2",
		of: (c) => c.tangential_distortion?.[1],
		alone: (v) => ({ tangential_distortion: [0, v] })
	}
];
function cameraOf(numbers, last) {
	const [focal, pixel, x0 = 0, y0 = 0, k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0] = numbers;
	if (focal === void 0) return null;
	const lens = {
		radial_distortion: [
			k1,
			k2,
			k3
		],
		tangential_distortion: [p1, p2]
	};
	const uncertain = last?.uncertainty === void 0 ? {} : { uncertainty: last.uncertainty };
	return {
		focal_mm: focal,
		principal_point_mm: [x0, y0],
		...pixel === void 0 ? {} : { pixel_mm: pixel },
		...lens,
		...uncertain
	};
}
function focalPxField(store) {
	const label = say("focal-length");
	const change = () => {
		const last = store.state.camera;
		const before = (last === null ? null : focalPxOf(last)) ?? void 0;
		const px = readNumber(field, (value) => allowedOfFocalPx(value, (given) => withFocalPx(last, given)), before);
		if (px !== before) store.dispatch({
			type: "camera",
			camera: px === void 0 ? withoutFocalPx(last) : withFocalPx(last, px)
		});
		store.dispatch({
			type: "refused",
			part: "camera",
			label: firstRefused([[label, field.input]])
		});
	};
	const field = numberField$1(label, "px", "camera-focal-px", change);
	const note = h("p", {
		class: "note",
		id: "focal-px-note",
		testid: "focal-px-note"
	});
	field.input.setAttribute("aria-describedby", `${field.problem.id} ${note.id}`);
	store.watch((s) => [s.camera, SIDES.some((side) => wholeMarks(s.photos[side]).length > 0)], ([camera, areScans]) => {
		showNumber(field, camera === null ? null : focalPxOf(camera));
		field.input.disabled = areScans;
		note.textContent = say("focal-length-in-px-sets", { what: areScans ? "scans" : camera !== null && camera.pixel_mm == null ? "pixel" : "focal" });
	});
	return {
		...field,
		note
	};
}
function focusFocalLength(host) {
	host.querySelector("[data-testid^=\"camera-focal\"]:enabled")?.focus();
}
function sharedCamera(store, fields) {
	const use = button("", "camera-for-both", () => {
		const shared = cameraForBoth(store.state);
		if (shared === null) return;
		store.dispatch({
			type: "camera",
			camera: shared.camera
		});
		fields.find(({ input }) => !input.disabled)?.input.focus();
	});
	const group = h("div", { class: "buttons" }, use);
	store.watch((s) => [
		s.camera,
		s.photos,
		s.results.openLeft,
		s.results.openRight
	], () => {
		const shared = cameraForBoth(store.state);
		group.hidden = shared === null;
		if (shared !== null) use.textContent = say("use-the-camera-for-both", { side: shared.side });
	});
	return group;
}
var IN_TEXT = [
	"openLeft",
	"openRight",
	"interiorLeft",
	"interiorRight",
	"match",
	"orientation"
];
function mountCamera(host, store, loadFile) {
	const change = () => {
		const last = store.state.camera;
		const camera = cameraOf(fields.map((field, i) => {
			const number = NUMBERS[i];
			return number === void 0 ? void 0 : readNumber(field, (value) => allowedOfCamera(number.alone(value)), (last === null ? null : number.of(last)) ?? void 0);
		}), last);
		if (!NUMBERS.every(({ of }) => (camera === null ? null : of(camera) ?? null) === (last === null ? null : of(last) ?? null))) store.dispatch({
			type: "camera",
			camera
		});
		store.dispatch({
			type: "refused",
			part: "camera",
			label: firstRefused(fields.map(({ input }, i) => [NUMBERS[i]?.label ?? "", input]))
		});
	};
	const fields = NUMBERS.map(({ label, unit, testid }) => numberField$1(label, unit, testid, change));
	const inPixels = focalPxField(store);
	const source = h("p", {
		class: "note",
		testid: "camera-source"
	});
	const load = button(say("load-camera-json"), "load-camera", loadFile);
	const clear = button(say("clear"), "clear-camera", () => store.dispatch({
		type: "camera",
		camera: null
	}));
	declareLack([clear], () => store.state.camera === null ? say("no-camera-is-given") : "");
	host.append(h("fieldset", { class: "group" }, h("legend", {}, say("camera")), source, calibrationGroup(store), sharedCamera(store, [inPixels, ...fields]), h("div", { class: "pairs" }, inPixels.element, ...fields.map(({ element }) => element)), inPixels.note, h("div", { class: "buttons" }, load, clear)), offsetGroup(store));
	store.watch(["camera"], ([camera]) => {
		fields.forEach((field, i) => {
			showNumber(field, camera === null ? null : NUMBERS[i]?.of(camera));
		});
		clear.disabled = camera === null;
	});
	store.watch((s) => [
		s.camera,
		s.photos,
		s.truth,
		isCurrent(s, "orientation"),
		...IN_TEXT.map((stage) => s.results[stage])
	], () => fill(source, sourceText(store.state)));
}
function exifText(name, exif) {
	if (exif.origin === "panorama") return (exif.cautions ?? []).map((caution) => say("the-image-is", {
		name,
		message: message("camera_caution", caution)
	})).join(" ");
	const camera = [exif.make != null && exif.model?.startsWith(exif.make) === true ? null : exif.make, exif.model].filter((part) => part != null).join(" ");
	const pixel = exif.pixel_mm == null ? say("no-pixel-size") : say("pixel-mm", { pixel_mm: significant(exif.pixel_mm) });
	const cautions = (exif.cautions ?? []).map((caution) => say("caution", { message: message("camera_caution", caution) })).join("");
	return say("f-mm", {
		message: message("camera_origin", exif.origin ?? "exif_focal_plane"),
		name,
		what: camera === "" ? say("camera-not-named") : camera,
		focal_mm: significant(exif.focal_mm),
		pixel,
		cautions
	});
}
function sourceText(state) {
	const exif = [["left", state.results.openLeft], ["right", state.results.openRight]].map(([name, opened]) => opened?.value.info.camera == null ? "" : exifText(name, opened.value.info.camera)).filter((text) => text !== "").join(" ");
	const used = pairCameras(state);
	const focal = focalOf(state);
	const told = focalText(focal);
	if (state.camera !== null && "missing" in used) return say("the-focal-length-is-not-used-yet", { exif });
	if (state.camera !== null) return say("in-use-the-values-below", {
		what: state.truth === null ? "" : say("they-came-with-the-sample"),
		told,
		exif
	});
	if (!("missing" in used)) return say("in-use-the-photos-own", {
		told,
		exif
	});
	if (interiorInUse(state) !== null) return say("no-camera-is-known", {
		source: focal?.isEstimated === true ? "estimated" : "assumed",
		told,
		exif
	});
	return say("orientation-needs-a-focal-length", { exif });
}
function focalText(focal) {
	return focal === null ? "" : say("focal-length-px", {
		focal: focal.focalPx,
		error: focal.errorPx
	});
}
function offsetGroup(store) {
	const change = () => {
		const offset = readPair([dx.input, dy.input], problem, allowedOfOffset);
		if (offset !== void 0) store.dispatch({
			type: "offset",
			offset
		});
		store.dispatch({
			type: "refused",
			part: "offset",
			label: firstRefused([[say("offset-dx"), dx.input], [say("offset-dy"), dy.input]])
		});
	};
	const problem = problemLine("offset");
	const dx = numberField$1("dx", "px", "offset-dx", change, problem);
	const dy = numberField$1("dy", "px", "offset-dy", change, problem);
	const found = h("p", {
		class: "note",
		testid: "offset-found"
	});
	store.watch(["offset"], ([offset]) => {
		showNumber(dx, offset?.[0]);
		showNumber(dy, offset?.[1]);
	});
	store.watch((s) => [
		s.results.offset,
		s.offset,
		s.settings
	], ([result, given, settings]) => {
		if (settings !== null && comparesGradients(settings)) {
			fill(found, say("matching-by-gradients-searches-the"));
			return;
		}
		if (given !== null || result === void 0) {
			fill(found, given !== null ? say("given-clear-both-fields-to") : say("right-minus-left-position-empty"));
			return;
		}
		const [mx, my] = result.value.median_px;
		const correlation = result.value.correlation;
		fill(found, say("estimated-median-px", {
			mx: significant(mx),
			my: significant(my),
			what: correlation == null ? "" : say("correlation-2", { correlation }),
			what_2: correlation != null && correlation < .5 ? say("low-do-the-images-overlap") : ""
		}));
	});
	return h("fieldset", { class: "group" }, h("legend", {}, say("offset-of-the-right-image")), found, h("div", { class: "pairs" }, dx.element, dy.element), problem);
}
// www/pair/panel/presets.ts
var TEXTS = {
	defaults: "preset-defaults",
	"many-points": "preset-many-points",
	"little-in-common": "preset-little-in-common",
	"zahran-2007": "preset-zahran-2007"
};
var OWN = "own";
function makePresets(presets, take) {
	let offered = new Map();
	const names = ["defaults", ...presets.map(({ name }) => name)];
	const help = h("p", {
		class: "help",
		id: "preset-help",
		testid: "preset-help"
	});
	const select = h("select", {
		id: "preset",
		testid: "preset",
		aria: { describedby: help.id }
	});
	const own = new Option(say("preset-own"), OWN);
	own.hidden = true;
	own.disabled = true;
	select.append(...names.map((name) => new Option(say(TEXTS[name]), name)), own);
	select.addEventListener("change", () => {
		const chosen = offered.get(select.value);
		if (chosen !== void 0) take(chosen);
	});
	const show = (settings, standard) => {
		const { base_mm } = standard.orientation;
		const ready = presets.map(({ name, settings: of }) => [name, {
			...of,
			orientation: {
				...of.orientation,
				base_mm
			}
		}]);
		offered = new Map([["defaults", standard], ...ready]);
		const now = JSON.stringify(settings);
		const found = names.find((name) => JSON.stringify(offered.get(name)) === now);
		select.value = found ?? OWN;
		fill(help, found === void 0 ? "" : known$1(TEXTS[found], "help") ?? "");
	};
	return {
		element: h("div", { class: "control" }, h("div", { class: "control-head" }, h("label", { for: "preset" }, say("ready-made-settings"))), select, help),
		show
	};
}
// www/pair/panel/controls.ts
function mountControls(host, store, opener) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue !== null) whenQuiet(() => show(catalogue));
	});
	function show(catalogue) {
		let acts = resolved(catalogue.defaults);
		const { elements, show: showValues } = makeFolded(catalogue.parameters, {
			change: (key, value) => change(store, key, value),
			defaults: () => standardOf(store.state, catalogue),
			resolved: () => acts,
			refused: ({ label }) => store.dispatch({
				type: "refused",
				part: "settings",
				label
			})
		}, {
			title: say("method"),
			first: ["matching.strategy", "matching.refine"],
			of: "pair",
			take: (settings) => store.dispatch({
				type: "settings",
				settings
			}),
			changed: (count) => fill(opener, settingsText(count))
		});
		const presets = makePresets(catalogue.presets, (settings) => store.dispatch({
			type: "settings",
			settings
		}));
		fill(host, presets.element, ...elements);
		store.watch(["settings", "truth"], ([settings]) => {
			if (settings === null) return;
			acts = resolved(settings);
			showValues(settings, acting_parameters(settings));
			presets.show(settings, standardOf(store.state, catalogue));
		});
	}
}
var EXCLUSIVE = {
	"points.threshold": "points.fraction",
	"points.fraction": "points.threshold"
};
var OF_ANOTHER = { "points.operator": "points.threshold" };
function change(store, key, value) {
	const { settings } = store.state;
	if (settings === null) return;
	const other = OF_ANOTHER[key] ?? (value === null ? void 0 : EXCLUSIVE[key]);
	const free = other === void 0 ? settings : withSetting(settings, other, null);
	store.dispatch({
		type: "settings",
		settings: withSetting(free, key, value)
	});
}
function standardOf({ truth }, { defaults }) {
	return truth === null ? defaults : {
		...defaults,
		orientation: {
			...defaults.orientation,
			base_mm: truth.baseMm === 0 ? null : truth.baseMm
		}
	};
}
// www/pair/state/paper.ts
function hasPaperCamera(state) {
	const paper = state.catalogue?.flights.find(({ name }) => name === "paper");
	const cameras = pairCameras(state);
	return paper !== void 0 && !("missing" in cameras) && cameras.left.focal_mm === paper.flight.focal_mm;
}
// www/pair/state/display.ts
var MATCHES = [
	MATCHED,
	MANUAL,
	BY_HAND
];
function isCodeShown({ points, hidden }, code) {
	if (code === 255 || hidden.includes(code)) return false;
	return points === "all" || points === "matched" && MATCHES.includes(code);
}
var REJECTED = [
	...REFUSALS.map(codeOf),
	GROSS_ERROR,
	UNDECIDED
];
function withCode(display, code, on) {
	const { points } = display;
	const others = (points === "all" ? display.hidden : [...points === "none" ? MATCHES : display.hidden, ...REJECTED]).filter((other) => other !== code);
	return {
		points: on ? "all" : points,
		hidden: on ? others : [...display.hidden.filter((other) => other !== code), code]
	};
}
var withListed = remember((display) => {
	return display.points === "matched" && !display.hidden.includes(GROSS_ERROR) ? withCode(display, GROSS_ERROR, true) : display;
});
// www/pair/view/palette.ts
var STYLE_OF = {
	matched: ACCEPTED,
	no_descriptor: {
		colour: "#b0b0b0",
		shape: SHAPES.dot
	},
	no_candidate: {
		colour: "#ffffff",
		shape: SHAPES.plus
	},
	threshold: {
		colour: "#e69f00",
		shape: SHAPES.triangleUp
	},
	ambiguous: {
		colour: "#cc79a7",
		shape: SHAPES.square
	},
	many_to_one: {
		colour: "#f0e442",
		shape: SHAPES.cross
	},
	parallax: {
		colour: "#0a84d6",
		shape: SHAPES.triangleDown
	},
	border: {
		colour: "#e69f00",
		shape: SHAPES.square
	},
	left_right: {
		colour: "#cc79a7",
		shape: SHAPES.cross
	},
	not_converged: {
		colour: "#56b4e9",
		shape: SHAPES.diamond
	},
	imprecise: {
		colour: "#f0e442",
		shape: SHAPES.triangleUp
	},
	frame: {
		colour: "#b0b0b0",
		shape: SHAPES.square
	},
	gross_error: REJECTED$1,
	undecided: {
		colour: "#56b4e9",
		shape: SHAPES.plus
	},
	rejected_by_hand: REJECTED_BY_HAND,
	manual: MEASURED
};
var STYLES = CODES.map((name) => STYLE_OF[name]);
function styleOf(code) {
	const style = STYLES[code];
	if (style === void 0) throw new Error(`no style for code ${String(code)}`);
	return style;
}
var DRAWN = [
	UNDECIDED,
	...REFUSALS.map(codeOf),
	BY_HAND,
	GROSS_ERROR,
	MATCHED,
	MANUAL
];
var LINE = "rgb(0 222 160 / 0.5)";
var LINE_REJECTED = "rgb(255 110 20 / 0.85)";
// www/pair/panel/counts.ts
var PAPER = {
	candidates: 0,
	after_roundness: null,
	after_suppression: 1
};
var PAPER_MATCHES = 2;
var PHASES = [
	["candidates", say("operator")],
	["after_roundness", say("roundness")],
	["after_suppression", say("suppression")]
];
function countsAsPaper({ settings }) {
	return settings !== null && comparesMoments(settings) && resolved(settings).points.operator === resolved({ matching: { strategy: "moments" } }).points.operator;
}
var RARE = new Set([
	"border",
	"left_right",
	"not_converged",
	"imprecise",
	"frame"
]);
function mountCounts(host, store) {
	const phases = h("div", {});
	const rules = h("div", {});
	const points = section(say("points"), "counts-section", phases);
	const matches = section(say("matches-2"), "matches-section", rules);
	host.append(points, matches);
	store.watch((s) => [
		s.results,
		s.history,
		s.settings,
		s.images,
		s.display,
		s.camera,
		s.photos,
		s.offset,
		s.fiducialModel,
		s.failures
	], whenInSight(host, () => {
		const { state } = store;
		points.classList.toggle("is-stale", pointsAreStale(state));
		matches.classList.toggle("is-stale", isStale(state, "match"));
		fill(phases, phaseTable(state));
		fill(rules, ruleTable(state, store), scoreLines(state));
	}));
}
function pointsAreStale(state) {
	return isStale(state, "pointsLeft") || isStale(state, "pointsRight");
}
function cell(testid, text) {
	return h("td", {
		testid,
		class: "number"
	}, text);
}
function phaseTable(state) {
	const left = state.results.pointsLeft?.value;
	const right = state.results.pointsRight?.value;
	const matches = matchOf(state)?.counts.matches;
	const printed = hasPaperCamera(state) && countsAsPaper(state) ? state.catalogue?.paper : void 0;
	const paper = (text) => printed === void 0 ? [] : [h("td", { class: "number paper" }, text(printed))];
	const counted = (place) => paper(({ points }) => place === null ? "–" : points[place].map(count).join(" / "));
	const body = PHASES.map(([field, label]) => row(label, cell(`count-left-${field}`, count(left?.counts[field])), cell(`count-right-${field}`, count(right?.counts[field])), ...counted(PAPER[field])));
	const threshold = (value) => value === void 0 ? "–" : significant(value);
	return h("table", { aria: { label: say("points-after-each-phase") } }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, say("phase")), h("th", { scope: "col" }, say("left")), h("th", { scope: "col" }, say("right")), printed !== void 0 ? h("th", {
		scope: "col",
		class: "paper",
		title: say("the-papers-table-1-for")
	}, say("paper-l-r")) : null)), h("tbody", {}, ...body, markStale(row(say("matching"), cell("count-left-matches", count(matches)), cell("count-right-matches", count(matches)), ...counted(PAPER_MATCHES)), isStale(state, "match") && !pointsAreStale(state)), row(say("threshold"), cell("threshold-left", threshold(left?.threshold)), cell("threshold-right", threshold(right?.threshold)), ...paper((of) => [of.threshold, of.threshold].map(count).join(" / ")))));
}
function matchOf(state) {
	return editedPair(state)?.match ?? state.results.match?.value;
}
function ruleTable(state, store) {
	const result = matchOf(state);
	const total = result?.rules.length ?? 0;
	const shareOf = (all) => (n) => n === void 0 || all === void 0 || all === 0 ? "–" : percent(n / all);
	const share = shareOf(total);
	const ofThese = shareOf(result?.counts.matches);
	const refused = REFUSALS.filter((rule) => !RARE.has(rule) || (result?.counts[rule] ?? 0) > 0).map((rule) => ruleRow(codeOf(rule), `refused-${rule}`, result?.counts[rule], share, state, store));
	const gross = shownPair(state).orientation?.rejected.length;
	return h("table", { aria: { label: say("what-became-of-the-left") } }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, say("left-points")), h("th", { scope: "col" }, say("number")), h("th", { scope: "col" }, say("share")), h("th", { scope: "col" }, say("show")))), h("tbody", {}, ruleRow(MATCHED, "count-matches", result?.counts.matches, share, state, store), markStale(ruleRow(GROSS_ERROR, "count-gross-errors", gross, ofThese, state, store, say("of-these-gross-errors")), gross !== void 0 && isStale(state, "orientation") && !isStale(state, "match")), ...byHand(result).map(([code, testid, value, label]) => ruleRow(code, testid, value, code === MANUAL ? ofThese : share, state, store, label)), h("tr", { class: "subhead" }, h("th", {
		scope: "rowgroup",
		colspan: 4
	}, say("rejected-by"))), ...refused));
}
function byHand(result) {
	if (result === void 0) return [];
	const { rejected, manual } = countsByHand(result);
	return [[
		MANUAL,
		"count-manual",
		manual,
		say("of-these-measured-by-hand")
	], [
		BY_HAND,
		"count-rejected-by-hand",
		rejected
	]].filter(([, , value]) => value > 0);
}
function ruleRow(code, testid, value, share, state, store, label) {
	const own = textOfCode(code, "label");
	const toggle = h("input", {
		type: "checkbox",
		testid: `show-${String(code)}`,
		aria: { label: say("show-2", { own }) }
	});
	toggle.checked = isCodeShown(state.display, code);
	toggle.addEventListener("change", () => {
		store.dispatch({
			type: "display",
			display: withCode(store.state.display, code, toggle.checked)
		});
		document.querySelector(`[data-testid="show-${String(code)}"]`)?.focus();
	});
	const name = h("span", { title: textOfCode(code) }, label ?? own);
	return row(h("span", { class: "legend" }, swatch(styleOf(code)), name), cell(testid, count(value)), h("td", { class: "number" }, share(value)), h("td", { class: "centre" }, toggle));
}
function scoreLines(state) {
	const score = state.results.score?.value;
	const { match } = shownPair(state);
	if (score === void 0 || match === null || !isCurrent(state, "score") || score.matches === 0) return null;
	const line = (name, testid, value, of, title) => h("tr", { title }, h("th", { scope: "row" }, name), cell(testid, count(value)), h("td", { class: "number" }, of));
	const share = (value) => percent(value / score.matches);
	return h("table", {
		testid: "score",
		aria: { label: say("matches-against-the-truth") }
	}, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, say("against-the-truth")), h("th", { scope: "col" }, say("number")), h("th", { scope: "col" }, say("share")))), h("tbody", {}, line(say("right-matches"), "score-right", score.right, share(score.right), say("within-1-5-px-of")), line(say("strictly-right"), "score-strict", score.strict, share(score.strict), say("within-1-5-px-of-where")), line(say("missed"), "score-missed", score.missed, "", say("left-points-that-are-visible"))));
}
function summary(state) {
	const shown = shownPair(state);
	if (shown.match === null) return "";
	const codes = leftCodes(shown.left, shown.match, shown.orientation);
	return say("matched", {
		matches: shown.match.counts.matches,
		points: codes.length
	});
}
// www/pair/state/statistics.ts
var POSITION = [{
	key: "x",
	label: "x",
	unit: "px",
	digits: 1,
	help: say("column-of-the-left-point")
}, {
	key: "y",
	label: "y",
	unit: "px",
	digits: 1,
	help: say("row-of-the-left-point")
}];
var MEASURE = {
	key: "measure",
	label: say("measure-2"),
	unit: "",
	digits: 4,
	help: say("dissimilarity-of-the-points-by"),
	total: "mean"
};
var CORRELATION = {
	key: "correlation",
	label: say("correlation-of-a-match"),
	unit: "",
	digits: 4,
	help: say("correlation-after-least-squares"),
	total: "mean"
};
var FIT = {
	key: "standard_error",
	label: "s(x, y)",
	unit: "px",
	digits: 3,
	help: say("standard-error-of-the-right"),
	total: "rms"
};
var ADJUSTED = [
	{
		key: "v",
		label: say("y-parallax"),
		unit: "px",
		digits: 3,
		inPixels: true,
		help: say("residual-y-parallax-the-distance"),
		total: "rms"
	},
	{
		key: "r",
		label: "r",
		unit: "",
		digits: 3,
		help: say("redundancy-number-the-share-of"),
		total: "sum"
	},
	{
		key: "w",
		label: "w",
		unit: "",
		digits: 2,
		help: say("w-statistic-standardised-residual-data"),
		total: "rms"
	},
	{
		key: "detectable",
		label: "∇",
		unit: "px",
		digits: 3,
		inPixels: true,
		help: say("minimal-detectable-bias-mdb-across"),
		total: "mean"
	},
	{
		key: "influence",
		label: "δ",
		unit: "",
		digits: 2,
		help: say("external-reliability-the-largest-effect"),
		total: "mean"
	},
	{
		key: "weight",
		label: say("weight"),
		unit: "",
		digits: 2,
		help: say("weight-in-the-adjustment-0"),
		total: "mean"
	},
	{
		key: "model_x",
		label: "X",
		unit: "mm",
		digits: 2,
		ofModel: true,
		help: say("model-coordinate-at-photo-scale")
	},
	{
		key: "model_y",
		label: "Y",
		unit: "mm",
		digits: 2,
		ofModel: true,
		help: say("model-coordinate-at-photo-scale-across")
	},
	{
		key: "model_z",
		label: "Z",
		unit: "mm",
		digits: 2,
		ofModel: true,
		help: say("model-coordinate-at-photo-scale-upwards")
	}
];
function worstError(fits, match) {
	if (5 * match >= fits.length) return NaN;
	const [xx = NaN, xy = NaN, yy = NaN] = fits.subarray(5 * match + 1, 5 * match + 4);
	return Math.sqrt(.5 * (xx + yy) + Math.hypot(.5 * (xx - yy), xy));
}
var statisticsOf = remember((left, match, orientation, score, pixel) => {
	const used = match.matches.length / 5;
	const off = Uint32Array.from(match.rules, (_, left) => left).filter((left) => match.rules[left] === BY_HAND);
	const count = used + off.length;
	const lefts = Uint32Array.from({ length: count }, (_, i) => i < used ? match.indices[2 * i] ?? 0 : off[i - used] ?? 0);
	const at = (i, k) => (i < used ? match.matches[5 * i + k] : left?.[3 * (lefts[i] ?? 0) + k]) ?? NaN;
	const compared = measuresOf(match);
	const measure = (i) => {
		if (i < used) return compared[i] ?? NaN;
		const [index = 0, own = NaN] = [lefts[i], match.measures[2 * (lefts[i] ?? 0)]];
		return Number.isFinite(own) && !isPredicted$1(match, index) ? own : NaN;
	};
	const figure = ({ key, label, unit, digits, help, ...told }, value) => numbers$2(key, label, unit, digits, value, help, told);
	const columns = POSITION.map((column, k) => figure(column, (i) => at(i, k)));
	columns.push(figure(MEASURE, measure));
	if (!match.fits.every(Number.isNaN)) {
		if (match.geometry !== null) columns.push(figure(CORRELATION, (i) => match.fits[5 * i] ?? NaN));
		columns.push(figure(FIT, (i) => worstError(match.fits, i)));
	}
	const codes = new Uint8Array(count).fill(BY_HAND);
	codes.set(matchCodes(match, orientation));
	if (orientation !== null) {
		const { points, base_mm: base } = orientation;
		ADJUSTED.forEach(({ inPixels = false, ofModel = false, digits, ...column }, k) => {
			const scale = inPixels ? pixel ?? NaN : 1;
			const shown = ofModel ? decimalsOfError(base / 1e3, digits) : digits;
			columns.push(figure({
				...column,
				digits: shown
			}, (i) => (points[9 * i + k] ?? NaN) / scale));
		});
	}
	return {
		count,
		columns,
		codes,
		lefts,
		rightness: score !== null && score.rightness.length === used ? score.rightness : null
	};
});
function statisticsOfState(state) {
	const { left, match, orientation, edited } = shownPair(state);
	if (match === null || edited?.found.counts.matches === 0) return null;
	const interior = interiorInUse(state)?.left;
	return statisticsOf(left, match, orientation, state.results.score?.value ?? null, interior === void 0 ? null : pixelMm(interior));
}
// www/pair/state/listed.ts
var STATES = {
	[GROSS_ERROR]: say("gross-error"),
	[BY_HAND]: say("rejected-by-hand-2"),
	[MANUAL]: say("by-hand")
};
var RIGHTNESS = [
	say("wrong"),
	say("at-an-edge"),
	say("correct")
];
var columnsOf = remember(({ columns, codes, rightness }) => [
	{
		key: "match",
		label: say("match-2"),
		unit: "",
		help: say("number-of-the-match-in"),
		value: (match) => match + 1,
		text: (match) => count(match + 1)
	},
	...columns,
	words("state", say("state-2"), (match) => STATES[codes[match] ?? 0] ?? say("used"), say("whether-the-adjustment-used-the")),
	...rightness === null ? [] : [words("truth", say("truth"), (match) => RIGHTNESS[rightness[match] ?? 0] ?? "", say("whether-the-match-is-right"))]
]);
function kindOf(statistics, { kind }) {
	return kind === "wrong" && statistics?.rightness == null ? "all" : kind;
}
function isOf({ codes, rightness }, kind, match) {
	switch (kind) {
		case "all": return true;
		case "used": return codes[match] === MATCHED || codes[match] === MANUAL;
		case "rejected": return codes[match] === GROSS_ERROR;
		case "by-hand": return codes[match] === BY_HAND || codes[match] === MANUAL;
		case "wrong": return rightness?.[match] === 0;
	}
}
var leftOutOf = remember((statistics, filter, match, rights) => {
	const kind = kindOf(statistics, filter);
	const meets = maskOf(statistics.count, columnsOf(statistics), filter.conditions);
	if (kind === "all" && meets === null) return null;
	const matches = Uint8Array.from({ length: statistics.count }, (_, row) => Number(!isOf(statistics, kind, row) || meets?.[row] === 0));
	const [left, right] = [new Uint8Array(match.rules.length), new Uint8Array(rights)];
	const used = match.matches.length / 5;
	const rightOf = (row) => (row < used ? match.indices[2 * row + 1] : match.best[statistics.lefts[row] ?? -1]) ?? -1;
	matches.forEach((out, row) => {
		left[statistics.lefts[row] ?? -1] = out;
		if (out === 1) right[rightOf(row)] = 1;
	});
	matches.forEach((out, row) => {
		if (out === 0) right[rightOf(row)] = 0;
	});
	return {
		left,
		right,
		matches
	};
});
function leftOut(state) {
	const { filter } = state;
	if (filter.kind === "all" && Object.keys(filter.conditions).length === 0) return null;
	const statistics = statisticsOfState(state);
	const { match, right } = shownPair(state);
	return statistics === null || match === null ? null : leftOutOf(statistics, filter, match, (right?.length ?? 0) / 3);
}
function makeListed() {
	return remember((codes, out) => out === null ? codes : codes.map((code, i) => out[i] === 1 ? 255 : code));
}
var listedPlaces = remember((places, out) => {
	return out === null ? places : {
		...places,
		codes: places.codes.map((code, i) => out.left[places.lefts[i] ?? -1] === 1 ? 255 : code)
	};
});
// www/pair/state/choice.ts
var NONE = [];
var leftsOf = remember((edited, chosen) => {
	const lefts = leftsByTarget(edited);
	return chosen.flatMap((key) => lefts.get(key) ?? []);
});
function chosenLefts(state) {
	const edited = editedPair(state);
	return edited === null || state.chosen.length === 0 ? NONE : leftsOf(edited, state.chosen);
}
var listedOf = remember((lefts, out) => out === null ? lefts : lefts.filter((left) => out.left[left] !== 1));
function listedLefts(state) {
	const lefts = chosenLefts(state);
	return lefts.length === 0 ? lefts : listedOf(lefts, leftOut(state));
}
function notListed(state) {
	return chosenLefts(state).length - listedLefts(state).length;
}
function concerned(state, edited) {
	if (chosenLefts(state).length > 0) return listedLefts(state);
	const left = leftIndexOf(state, edited.match.best, edited.match.rules);
	return left < 0 ? NONE : [left];
}
function editOfChoice(state, kind) {
	const edited = editedPair(state);
	if (edited === null) return null;
	const rule = kind === "reject" ? MATCHED : BY_HAND;
	const of = concerned(state, edited).flatMap((left) => {
		const target = edited.match.rules[left] === rule ? targetOfLeft(edited, left) : null;
		return target === null ? [] : [target];
	});
	return of.length === 0 ? null : {
		kind,
		of
	};
}
var lackOfMatches = (state) => editedPair(state) === null ? say("needs-matches") : "";
var lackOfSelected = (state) => state.selection === null ? say("no-point-is-selected") : "";
function lackOfBegun({ tool, draft, outline, chosen, selection }) {
	return tool === "look" && draft === null && outline === null && chosen.length === 0 && selection === null ? say("nothing-is-chosen") : "";
}
var lackOfEdit = (state, kind) => editOfChoice(state, kind) === null ? say("no-such-match-is-chosen") : "";
function keysOfLefts(edited, lefts) {
	return [...lefts].flatMap((left) => {
		const target = targetOfLeft(edited, left);
		return target === null ? [] : [keyOfTarget(target)];
	});
}
function keysWithin(edited, side, [left, top, right, bottom], isShown) {
	const inside = [];
	const first = side === "left" ? 0 : 2;
	edited.match.rules.forEach((rule, index) => {
		if (rule !== MATCHED && rule !== BY_HAND || !isShown(index)) return;
		const place = placeOfLeft(edited, index);
		const [x, y] = [place[first] ?? NaN, place[first + 1] ?? NaN];
		if (x >= left && x <= right && y >= top && y <= bottom) inside.push(index);
	});
	return keysOfLefts(edited, inside);
}
function toggled(chosen, keys) {
	const own = new Set(chosen);
	const all = keys.every((key) => own.has(key));
	for (const key of keys) if (all) own.delete(key);
	else own.add(key);
	return [...own];
}
// www/pair/state/on-image.ts
function sizeOf({ results }, side) {
	return results[side === "left" ? "openLeft" : "openRight"]?.value.info ?? null;
}
function isOnImage(state, side, [x, y]) {
	const size = sizeOf(state, side);
	return size === null || x >= 0 && y >= 0 && x <= size.width && y <= size.height;
}
// www/pair/state/draft.ts
function nearest({ match }, side, [x, y]) {
	const first = side === "left" ? 0 : 2;
	const rows = Array.from({ length: match.matches.length / 5 }, (_, row) => {
		const [u = NaN, v = NaN] = match.matches.subarray(5 * row + first, 5 * row + first + 2);
		return {
			row,
			distance: (u - x) ** 2 + (v - y) ** 2
		};
	});
	rows.sort((a, b) => a.distance - b.distance);
	return rows.slice(0, 12).map(({ row }) => {
		const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = match.matches.subarray(5 * row, 5 * row + 4);
		return side === "left" ? [
			xl,
			yl,
			xr,
			yr
		] : [
			xr,
			yr,
			xl,
			yl
		];
	});
}
function byNeighbours(edited, side, at) {
	return movedWith(nearest(edited, side, at), at);
}
var predicted = remember((edited, draft, line) => {
	const place = draft.places[otherSide(draft.side)];
	if (place === null) return null;
	const known = [place[0], place[1]];
	const around = byNeighbours(edited, otherSide(draft.side), known);
	return around === null || line?.side !== draft.side ? around : onLine(line.positions, around);
});
function expectedPlace(state) {
	const edited = editedPair(state);
	if (edited === null || state.draft === null) return null;
	return predicted(edited, state.draft, lineOfDraft(state));
}
function lineOfDraft(state) {
	return state.draft !== null && isCurrent(state, "line") ? state.results.line?.value ?? null : null;
}
function placeOfDraft(state, side) {
	const { draft } = state;
	if (draft === null) return null;
	const own = draft.places[side];
	if (own !== null) return [own[0], own[1]];
	return side === draft.side ? expectedPlace(state) : null;
}
function placed(state, draft, side, [x, y]) {
	const { width, height } = sizeOf(state, side) ?? {
		width: Infinity,
		height: Infinity
	};
	const at = [roundedPx(Math.min(width, Math.max(0, x))), roundedPx(Math.min(height, Math.max(0, y)))];
	return {
		...draft,
		places: {
			...draft.places,
			[side]: at
		}
	};
}
function begun(state, side, at) {
	return {
		...placed(state, {
			of: null,
			places: {
				left: null,
				right: null
			},
			side
		}, side, at),
		side: otherSide(side)
	};
}
function moving(state) {
	const edited = editedPair(state);
	if (edited === null) return null;
	const left = leftIndexOf(state, edited.match.best, edited.match.rules);
	const target = left < 0 ? null : targetOfLeft(edited, left);
	const rule = edited.match.rules[left];
	if (target === null || rule !== MATCHED && rule !== BY_HAND) return null;
	const [xl, yl, xr, yr] = placeOfLeft(edited, left);
	return {
		of: target,
		places: {
			left: [xl, yl],
			right: [xr, yr]
		},
		side: state.selection?.side === "left" ? "right" : state.selection?.side ?? "right"
	};
}
function exchangedDraft({ of, places, side }) {
	return {
		of: of === null ? null : exchangedTarget(of),
		places: {
			left: places.right,
			right: places.left
		},
		side: otherSide(side)
	};
}
var PLACE = "place";
function stepsWithDraft({ history, draft }) {
	return draft === null ? history : recorded(history, PLACE);
}
var nameOfStep = (step) => step === "place" ? say("step-of-draft") : nameOfEdit(step);
function withoutPlace(draft) {
	const { of, places, side } = draft;
	const placed = places[side] === null ? otherSide(side) : side;
	if (of !== null || places[otherSide(placed)] === null) return null;
	return {
		...draft,
		places: {
			...places,
			[placed]: null
		},
		side: placed
	};
}
function isPredicted(state) {
	const { draft } = state;
	return draft !== null && draft.places[draft.side] === null && expectedPlace(state) !== null;
}
function editOfDraft(state) {
	const { draft, history } = state;
	const [left, right] = [placeOfDraft(state, "left"), placeOfDraft(state, "right")];
	if (draft === null || left === null || right === null) return null;
	if (draft.of === null && (draft.places.left === null || draft.places.right === null)) return null;
	const at = [
		roundedPx(left[0]),
		roundedPx(left[1]),
		roundedPx(right[0]),
		roundedPx(right[1])
	];
	if (draft.of === null) return {
		kind: "add",
		id: freshNumber(history),
		at
	};
	const own = (k, side, value) => draft.places[side]?.[k] ?? value;
	return {
		kind: "move",
		of: draft.of,
		to: [
			own(0, "left", at[0]),
			own(1, "left", at[1]),
			own(0, "right", at[2]),
			own(1, "right", at[3])
		]
	};
}
// www/pair/panel/draft.ts
function mountDraft(host, store, editing, { follow, begun, ended }) {
	const tool = button(say("add-match"), "tool-measure", () => {
		editing.toggle("measure");
		begun();
	}, say("measure-a-match-by-hand"));
	const text = h("span", {
		testid: "draft-text",
		role: "status"
	});
	const accept = button(say("accept"), "draft-accept", () => {
		editing.accept();
		ended();
	}, say("the-match-is-measured-enter"));
	const fit = button(say("fit"), "draft-fit", () => void editing.fit(), say("move-the-right-point-to"));
	const exchange = button(say("other-image"), "draft-exchange", () => {
		editing.exchange();
		follow();
	}, say("go-on-with-the-point"));
	const cancel = button(say("cancel"), "draft-cancel", () => {
		editing.leave();
		ended();
	}, say("give-this-match-up-escape"));
	const bar = h("div", {
		class: "drafting",
		testid: "draft",
		role: "group",
		aria: { label: say("match-measured-by-hand") }
	}, text, accept, exchange, fit, cancel);
	declareLack([tool], () => lackOfMatches(store.state));
	declareLack([bar], () => store.state.draft === null ? say("nothing-is-measured") : "");
	host.append(tool, bar);
	store.watch((s) => [
		s.tool,
		s.draft,
		s.results,
		s.history,
		s.images
	], () => {
		const { state } = store;
		tool.setAttribute("aria-pressed", String(state.tool === "measure"));
		tool.disabled = editedPair(state) === null;
		bar.hidden = state.tool !== "measure";
		accept.disabled = editOfDraft(state) === null;
		exchange.disabled = state.draft === null;
		fit.disabled = accept.disabled && !isPredicted(state);
		const now = textOf$2(state);
		if (text.textContent !== now) text.textContent = now;
	});
}
function textOf$2(state) {
	const { draft } = state;
	if (draft === null) return say("new-match-press-a-point");
	const place = (side) => {
		const at = placeOfDraft(state, side);
		return at === null ? `${side} –` : `${side} ${fixed(at[0], 2)}, ${fixed(at[1], 2)}`;
	};
	if (isPredicted(state)) return say("px-predicted", {
		place: place("left"),
		place_2: place("right"),
		side: draft.side
	});
	const what = draft.of === null ? say("new-match") : say("moved-match");
	return say("px-place-the-point-press", {
		what,
		place: place("left"),
		place_2: place("right"),
		side: draft.side
	});
}
// www/pair/state/compared.ts
function comparedEdit(state) {
	const { before, history, results } = state;
	if (history.edits.length === 0 || before === null || before.run !== runKey(state)) return null;
	const now = isCurrent(state, "orientation") ? results.orientation?.value ?? null : null;
	return {
		before: before.orientation,
		now,
		comes: now === null && whyNone(state) === null
	};
}
// www/pair/state/mark-steps.ts
function withMarkStep({ photos, markSteps }, step) {
	return {
		photos: stepped(photos, step),
		markSteps: isFirst(markSteps, step) ? markSteps : recordedStep(markSteps, step)
	};
}
function withMarkStepsDone({ photos, markSteps }, done) {
	const next = wentTo(markSteps, done);
	const { edits } = markSteps;
	const again = edits.slice(markSteps.done, next.done);
	return {
		photos: [...edits.slice(next.done, markSteps.done).reverse().map((step) => ({
			...step,
			out: step.put,
			put: step.out
		})), ...again].reduce(stepped, photos),
		markSteps: next
	};
}
function stepped(photos, { side, at, out, put }) {
	const { fiducials } = photos[side];
	return {
		...photos,
		[side]: {
			...photos[side],
			fiducials: [
				...fiducials.slice(0, at),
				...put,
				...fiducials.slice(at + out.length)
			]
		}
	};
}
function isFirst({ edits }, { side, deed, out }) {
	return deed === "given" && out.length === 0 && edits.every((step) => step.side !== side);
}
function recordedStep(history, step) {
	const last = history.edits[history.done - 1];
	return step.deed === "nudged" && last?.deed === "nudged" && last.side === step.side && last.at === step.at ? recorded(wentTo(history, history.done - 1), {
		...step,
		out: last.out
	}) : recorded(history, step);
}
function nameOfMarkStep({ deed, at, side }, images) {
	return say("step-of-mark", {
		deed,
		number: at + 1,
		image: images[side]?.name ?? say(side === "left" ? "left-image" : "right-image")
	});
}
// www/pair/panel/marking.ts
function marksHaveKeys({ tool }) {
	const held = document.activeElement?.closest("[data-testid=\"fiducials\"]") ?? null;
	return tool === "fiducials" || held !== null;
}
function mountMarking(bar, store, marking) {
	const text = h("span", {
		testid: "mark-text",
		role: "status"
	});
	const former = button(say("mark-before"), "mark-before", () => void marking.go(-1), say("the-mark-before-p"));
	const next = button(say("next-mark"), "mark-next", () => void marking.go(1), say("the-next-mark-enter"));
	const clear = button(say("clear-mark"), "mark-clear", () => marking.clear(), say("the-mark-is-not-measured"));
	const undo = button(say("undo-sign"), "mark-undo", () => marking.step(-1));
	const redo = button(say("redo-sign"), "mark-redo", () => marking.step(1));
	const end = button(say("end-marking"), "mark-end", () => store.dispatch({
		type: "tool",
		tool: "look"
	}));
	const buttons = h("div", {
		class: "drafting",
		testid: "marking",
		role: "group",
		aria: { label: say("fiducial-marks-measured") }
	}, text, former, next, clear, undo, redo, end);
	declareLack([buttons], () => store.state.tool === "fiducials" ? "" : say("nothing-is-measured"));
	bar.append(buttons);
	undoKeys(() => byId("view").offsetParent !== null && marksHaveKeys(store.state), (by) => marking.step(by));
	store.watch((s) => [
		s.tool,
		s.mark,
		s.photos,
		s.markSteps,
		s.images
	], () => {
		const { state } = store;
		const held = document.activeElement;
		buttons.hidden = state.tool !== "fiducials" || state.mark === null;
		former.disabled = state.mark === null || state.mark.index === 0;
		next.disabled = markInHand(state) === void 0;
		clear.disabled = placeInHand(state) === null;
		showSteps(undo, redo, state.markSteps, (one) => nameOfMarkStep(one, state.images));
		if (buttons.contains(held)) passFocus(held, [byId("view")]);
		const now = textOf$1(state);
		if (text.textContent !== now) text.textContent = now;
	});
}
var placeInHand = (state) => state.mark === null ? null : placeOfMark(state.photos[state.mark.side], markInHand(state));
function textOf$1(state) {
	const { mark } = state;
	if (mark === null) return "";
	const one = markInHand(state);
	const at = placeInHand(state);
	const photo = one !== void 0 && Number.isFinite(one.x_mm) && Number.isFinite(one.y_mm) ? say("mark-at-mm", {
		x: fixed(one.x_mm, 3),
		y: fixed(one.y_mm, 3)
	}) : "";
	const number = mark.index + 1;
	if (at !== null) return say("mark-is-at", {
		number,
		photo,
		column: fixed(at[0], 2),
		row: fixed(at[1], 2)
	});
	if (one === void 0) return say("new-mark-press-it", {
		number,
		side: mark.side
	});
	return mark.expected === null ? say("mark-press-it", {
		number,
		photo,
		side: mark.side
	}) : say("mark-is-expected", {
		number,
		photo,
		side: mark.side
	});
}
// www/pair/panel/unknowns.ts
var UNKNOWNS = [
	{
		field: "omega_deg",
		symbol: "ω",
		unit: "°",
		digits: 4
	},
	{
		field: "phi_deg",
		symbol: "φ",
		unit: "°",
		digits: 4
	},
	{
		field: "kappa_deg",
		symbol: "κ",
		unit: "°",
		digits: 4
	},
	{
		field: "by_mm",
		symbol: "by",
		unit: "mm",
		digits: 4
	},
	{
		field: "bz_mm",
		symbol: "bz",
		unit: "mm",
		digits: 4
	}
];
// www/pair/panel/edits.ts
function several(edit) {
	return edit !== null && edit.of.length > 1 ? ` ${count(edit.of.length)}` : "";
}
function sayLacks(store, reject, restore) {
	declareLack([reject], () => lackOfEdit(store.state, "reject"));
	declareLack([restore], () => lackOfEdit(store.state, "restore"));
}
function mountEdits(host, store, editing, follow) {
	const reject = button(say("reject"), "reject", () => editing.edit("reject"), say("take-the-chosen-matches-out"));
	const restore = button(say("restore"), "restore", () => editing.edit("restore"), say("use-the-chosen-matches-again"));
	const move = button(say("move"), "move", () => {
		editing.move();
		follow();
	}, say("measure-the-selected-match-anew"));
	const undo = button(say("undo"), "undo", () => editing.step(-1), say("take-back-the-last-edit"));
	const redo = button(say("redo"), "redo", () => editing.step(1), say("make-the-edit-again-that"));
	sayLacks(store, reject, restore);
	declareLack([move], () => lackOfSelected(store.state));
	hasKeys(undo, UNDO_KEYS);
	hasKeys(redo, REDO_KEYS);
	const others = new NotListed("not-listed", [reject, restore]);
	const hint = h("p", {
		class: "note",
		testid: "edit-hint"
	}, say("to-reject-wrong-matches-choose"));
	const compared = h("div", {
		testid: "edit-compared",
		role: "status"
	});
	const panel = h("section", {
		class: "edits",
		testid: "edits",
		aria: { label: say("edits-by-hand") }
	});
	panel.append(h("div", { class: "buttons" }, reject, restore, move, undo, redo), others.element, hint, compared);
	host.append(panel);
	store.watch((s) => [
		s.results,
		s.history,
		s.draft,
		s.chosen,
		s.filter,
		s.selection,
		s.before,
		s.images,
		s.settings,
		s.camera,
		s.photos,
		s.failures
	], () => {
		const { state } = store;
		panel.hidden = editedPair(state) === null;
		const [off, on] = [editOfChoice(state, "reject"), editOfChoice(state, "restore")];
		set(reject, `${say("reject")}${several(off)}`, off === null);
		set(restore, `${say("restore")}${several(on)}`, on === null);
		others.show(notListed(state));
		move.disabled = moving(state) === null;
		const { edits } = state.history;
		const names = steps(stepsWithDraft(state), nameOfStep);
		set(undo, names.undo === null ? say("undo") : say("undo-3", { undo: names.undo }), names.undo === null);
		set(redo, names.redo === null ? say("redo") : say("redo-3", { redo: names.redo }), names.redo === null);
		undo.hidden = edits.length === 0 && state.draft === null;
		redo.hidden = names.redo === null;
		hint.hidden = edits.length > 0 || chosenLefts(state).length > 0;
		fill(compared, ...comparison(state));
	});
}
var ANGLES = [
	"omega_deg",
	"phi_deg",
	"kappa_deg"
];
function comparison(state) {
	const compared = comparedEdit(state);
	if (compared === null) return [];
	const { before, now, comes } = compared;
	const interior = interiorInUse(state)?.left;
	const pixel = interior === void 0 ? NaN : pixelMm(interior);
	const used = (of) => count(countsOf$1(of).used);
	const sigma = ({ sigma0_mm }) => fixed(sigma0_mm === null ? null : sigma0_mm / pixel, 3);
	const error = (field) => (of) => {
		const own = (of.total_standard_errors ?? of.standard_errors)?.[field];
		return fixed(own, decimalsOfError(own, 4));
	};
	const line = (name, testid, text) => row(name, h("td", {
		class: "number",
		testid: `${testid}-before`
	}, text(before)), h("td", {
		class: "number",
		testid: `${testid}-now`
	}, now === null ? comes ? "…" : "–" : text(now)));
	const head = h("tr", {}, h("th", { scope: "col" }, say("orientation")), h("th", { scope: "col" }, say("before")), h("th", { scope: "col" }, say("now-2")));
	const angles = ANGLES.map((field) => {
		const symbol = UNKNOWNS.find((unknown) => unknown.field === field)?.symbol ?? field;
		return line(say("standard-error-of-4", { symbol }), `compared-${field}`, error(field));
	});
	const body = h("tbody", {}, line("σ₀, px", "compared-sigma0", sigma), line(say("points-used"), "compared-points", used), ...angles);
	return [h("table", {
		class: "tight",
		aria: { label: say("orientation-before-and-after-the") }
	}, h("thead", {}, head), body)];
}
function mountEditTools(host, bar, store, editing) {
	const choose = button(say("choose"), "tool-choose", () => editing.toggle("choose"));
	choose.title = say("choose-matches-by-a-rectangle");
	const undo = button(say("undo-sign"), "tool-undo", () => editing.step(-1));
	const redo = button(say("redo-sign"), "tool-redo", () => editing.step(1));
	const reject = button(say("reject"), "tool-reject", () => editing.edit("reject"), say("take-the-chosen-matches-out"));
	const restore = button(say("restore"), "tool-restore", () => editing.edit("restore"), say("use-the-chosen-matches-again"));
	declareLack([choose], () => lackOfMatches(store.state));
	sayLacks(store, reject, restore);
	host.append(h("span", { class: "divider" }), choose, undo, redo);
	const others = new NotListed("tool-not-listed", [reject, restore]);
	bar.append(reject, restore, others.element);
	store.watch((s) => [
		s.tool,
		s.history,
		s.draft,
		s.chosen,
		s.filter,
		s.selection,
		s.results
	], () => {
		const { state } = store;
		choose.setAttribute("aria-pressed", String(state.tool === "choose"));
		choose.disabled = editedPair(state) === null;
		byId("view").dataset.tool = state.tool;
		const [off, on] = [editOfChoice(state, "reject"), editOfChoice(state, "restore")];
		set(reject, `${say("reject")}${several(off)}`, off === null);
		set(restore, `${say("restore")}${several(on)}`, on === null);
		reject.hidden = state.tool !== "choose" && state.chosen.length === 0;
		restore.hidden = reject.hidden || on === null;
		others.show(reject.hidden ? 0 : notListed(state));
		showSteps(undo, redo, stepsWithDraft(state), nameOfStep);
	});
}
var hasSteps = ({ history, draft }) => history.edits.length > 0 || draft !== null;
function mountEditKeys(list, store, editing, follow) {
	undoKeys(() => byId("view").offsetParent !== null && hasSteps(store.state) && store.state.tool !== "mask" && !marksHaveKeys(store.state), (by) => editing.step(by));
	const move = () => {
		editing.move();
		follow();
	};
	const keys = [
		{
			keys: ["Delete", "Backspace"],
			does: say("rejects-the-chosen-matches"),
			lacks: () => lackOfEdit(store.state, "reject"),
			run: () => editing.edit("reject")
		},
		{
			keys: ["r"],
			does: say("restores-the-chosen-matches"),
			lacks: () => lackOfEdit(store.state, "restore"),
			run: () => editing.edit("restore")
		},
		{
			keys: ["x"],
			does: say("chooses-the-selected-match-beside"),
			lacks: () => lackOfSelected(store.state),
			run: () => editing.choose(store.state.selection)
		},
		{
			keys: ["e"],
			does: say("measures-the-selected-match-anew"),
			lacks: () => lackOfSelected(store.state),
			run: move
		},
		{
			keys: ["Escape"],
			does: say("gives-up"),
			lacks: () => lackOfBegun(store.state),
			run: () => void editing.leave()
		}
	];
	listenKeys(list, declare({
		where: say("list-of-matches"),
		host: list,
		list: keys
	}));
}
// www/pair/panel/fiducials.ts
var FIELDS$1 = [
	"col",
	"row",
	"x_mm",
	"y_mm"
];
var HEADS = {
	col: say("col-px"),
	row: say("row-px"),
	x_mm: `x ${unitText("mm")}`,
	y_mm: `y ${unitText("mm")}`
};
function mountFiducials(host, store, loadFile, marking, measure) {
	const model = h("select", {
		id: "fiducial-model",
		testid: "fiducial-model"
	});
	model.append(new Option(say("affine-6-parameters"), "affine"), new Option(say("similarity-4-parameters"), "similarity"));
	model.addEventListener("change", () => {
		store.dispatch({
			type: "fiducialModel",
			model: model.value === "similarity" ? "similarity" : "affine"
		});
	});
	store.watch(["fiducialModel"], ([value]) => {
		model.value = value;
	});
	host.append(h("fieldset", {
		class: "group",
		testid: "fiducials"
	}, h("legend", {}, say("interior-orientation")), h("div", { class: "control" }, h("label", { for: "fiducial-model" }, say("transformation")), model), photo("left", store, loadFile, marking, measure), photo("right", store, loadFile, marking, measure)));
}
function photo(side, store, loadFile, marking, measure) {
	const table = scrolledByKeys(h("div", { class: "scroll fiducials-table" }));
	const result = h("p", {
		class: "note",
		testid: `interior-${side}`
	});
	const name = say("image-4", { name: side === "left" ? say("left") : say("right") });
	const add = button(say("add-mark"), `add-fiducial-${side}`, () => marking.add(side));
	const load = button(say("load-csv"), `load-fiducials-${side}`, () => loadFile(side));
	const inPicture = button(say("measure-in-the-image"), `measure-fiducials-${side}`, () => measure(side), say("press-each-mark-in-the-image"));
	store.watch((s) => [
		s.images[side],
		s.tool,
		s.mark
	], ([image, tool, mark]) => {
		inPicture.disabled = image === null;
		inPicture.setAttribute("aria-pressed", String(tool === "fiducials" && mark?.side === side));
	});
	const other = otherSide(side);
	const asOther = button(say("as-in-the-other-image", { side: other }), `coordinates-fiducials-${side}`, () => marking.takeCoordinates(side), say("takes-the-photo-coordinates", { side: other }));
	store.watch((s) => [s.photos.left.fiducials, s.photos.right.fiducials], ([left, right]) => {
		const [own, others] = side === "left" ? [left, right] : [right, left];
		const held = asOther === document.activeElement ? asOther : null;
		asOther.hidden = withCoordinatesOf(own, others) === null;
		passFocus(held, [asOther, inPicture]);
	});
	const clear = button(say("clear"), `clear-fiducials-${side}`, () => marking.removeAll(side));
	declareLack([inPicture], () => store.state.images[side] === null ? say("needs-a-photo") : "");
	declareLack([clear], () => store.state.photos[side].fiducials.length === 0 ? say("nothing-is-measured") : "");
	const undo = button(say("undo-sign"), `undo-fiducials-${side}`, () => marking.step(-1));
	const redo = button(say("redo-sign"), `redo-fiducials-${side}`, () => marking.step(1));
	let shown = null;
	const stage = side === "left" ? "interiorLeft" : "interiorRight";
	store.watch((s) => [s.markSteps, s.images], ([history, images]) => {
		const held = [undo, redo].find((press) => press === document.activeElement) ?? null;
		showSteps(undo, redo, history, (step) => nameOfMarkStep(step, images));
		undo.hidden = history.edits[history.done - 1]?.side !== side;
		redo.hidden = history.edits[history.done]?.side !== side;
		passFocus(held, [
			undo,
			redo,
			add
		]);
	});
	store.watch((s) => [
		s.photos[side].fiducials,
		s.results[stage],
		isPixelMissing(s, side)
	], ([fiducials, interior, isWithoutPixel]) => {
		const held = table.contains(document.activeElement) || clear === document.activeElement ? document.activeElement : null;
		const whole = fiducials.filter(isWhole$1).length;
		const residuals = interior?.value.fiducials?.residuals_mm ?? [];
		if (shown !== fiducials) {
			if (shown?.length !== fiducials.length) fill(table, marksTable(side, marking, fiducials.length));
			shown = fiducials;
			showMarks(table, fiducials);
		}
		showResiduals(table, fiducials, residuals.length === whole ? residuals : []);
		clear.disabled = fiducials.length === 0;
		passFocus(held, [undo, add]);
		const incomplete = fiducials.length - whole;
		const { sigma0_mm, degrees_of_freedom } = interior?.value.fiducials ?? {};
		const told = isWithoutPixel ? say("no-fiducial-marks-and-no-pixel") : interiorText(sigma0_mm, degrees_of_freedom, whole);
		fill(result, incomplete === 0 ? told : `${told} ${say("incomplete-marks", { incomplete })}`);
	});
	return h("div", {
		class: "photo twin",
		role: "group",
		aria: { label: name }
	}, h("h3", {}, name), result, table, h("div", { class: "buttons" }, inPicture, add, asOther, load, clear, undo, redo), originFields(side, store));
}
function isPixelMissing({ camera, photos, results }, side) {
	const ofFile = results[side === "left" ? "openLeft" : "openRight"]?.value.info.camera;
	return wholeMarks(photos[side]).length === 0 && (camera ?? ofFile)?.pixel_mm == null;
}
function interiorText(sigma, freedom, marks) {
	if (marks === 0) return say("no-fiducial-marks-the-pixel");
	if (freedom === void 0) return say("marks", { marks });
	return say("marks-degrees-of-freedom", {
		marks,
		what: sigma == null ? say("not-determined") : say("um-1", { value: 1e3 * sigma }),
		freedom
	});
}
function marksTable(side, marking, rows) {
	if (rows === 0) return "";
	const body = Array.from({ length: rows }, (_, i) => h("tr", {}, h("th", { scope: "row" }, String(i + 1)), ...FIELDS$1.map((field) => h("td", {}, markInput(side, marking, i, field))), h("td", { class: "number residual" }, h("span", {})), h("td", {}, removeButton(side, marking, i))));
	return h("table", {
		class: "marks",
		testid: `fiducials-${side}`,
		aria: { label: say("fiducial-marks", { side }) }
	}, h("thead", {}, h("tr", {}, h("td", {}, ""), ...FIELDS$1.map((field) => h("th", { scope: "col" }, HEADS[field])), h("th", {
		scope: "col",
		class: "residual",
		title: say("residuals-vx-vy")
	}, h("span", {}, `v ${unitText("µm")}`)), h("td", {}, ""))), h("tbody", {}, ...body));
}
function markInput(side, marking, index, field) {
	const input = h("input", {
		type: "number",
		aria: { label: say("mark", {
			index: index + 1,
			heads: HEADS[field]
		}) }
	});
	input.step = "any";
	input.addEventListener("change", () => marking.type(side, index, { [field]: input.valueAsNumber }));
	return input;
}
function removeButton(side, marking, index) {
	const remove = button("×", `remove-fiducial-${side}-${String(index)}`, () => marking.remove(side, index));
	remove.className = "icon";
	remove.setAttribute("aria-label", say("remove-mark", { index: index + 1 }));
	return remove;
}
function showMarks(table, fiducials) {
	table.querySelectorAll("tbody tr").forEach((line, i) => {
		line.querySelectorAll("input").forEach((input, f) => {
			const field = FIELDS$1[f];
			const value = field === void 0 ? void 0 : fiducials[i]?.[field];
			if (value === void 0 || Object.is(input.valueAsNumber, value)) return;
			input.value = Number.isFinite(value) ? String(value) : "";
		});
	});
}
function showResiduals(table, fiducials, residuals) {
	const parts = fiducials.map((mark, i) => isWhole$1(mark) ? residuals[fiducials.slice(0, i).filter(isWhole$1).length] : void 0);
	table.querySelectorAll("tbody tr").forEach((line, i) => {
		const cell = line.querySelector(".residual span");
		const [vx, vy] = parts[i] ?? [];
		if (cell !== null) cell.textContent = vx === void 0 ? "" : `${fixed(1e3 * vx, 0)}, ${fixed(1e3 * (vy ?? NaN), 0)}`;
	});
}
function originFields(side, store) {
	const problem = problemLine(`origin-${side}`);
	const change = () => {
		const origin = readPair(inputs, problem, allowedOfOrigin);
		if (origin !== void 0) store.dispatch({
			type: "photo",
			side,
			photo: { origin }
		});
		store.dispatch({
			type: "refused",
			part: "photos",
			label: firstRefused(inputs.map((input) => [say("origin-of-the-image-in", { side }), input]))
		});
	};
	const field = (name, testid) => {
		const input = numberInput(testid, problem, change);
		input.setAttribute("aria-label", say("image-in-the-scan-px", {
			side,
			name
		}));
		return input;
	};
	const inputs = [field("column", `origin-${side}-col`), field("row", `origin-${side}-row`)];
	store.watch((s) => [s.photos[side].origin], ([origin]) => {
		inputs.forEach((input, axis) => {
			showNumber({
				input,
				problem
			}, origin?.[axis]);
		});
	});
	return h("div", { class: "control compact origin" }, h("span", { title: say("column-and-row-of-this") }, say("origin-in-the-scan"), h("span", { class: "unit" }, say("col-row-px"))), ...inputs, problem);
}
// www/pair/panel/geometry.ts
function mountGeometry(host, store) {
	const body = h("div", {});
	const panel = section(say("geometry-of-the-two-views"), "geometry-section", body);
	host.append(panel);
	store.watch([
		"results",
		"settings",
		"images",
		"camera",
		"photos",
		"masks"
	], whenInSight(host, () => {
		const { state } = store;
		panel.hidden = state.settings === null || !comparesGradients(state.settings);
		panel.classList.toggle("is-stale", isStale(state, "match"));
		if (!panel.hidden) fill(body, ...content$2(state));
	}));
}
function content$2(state) {
	const { match } = shownPair(state);
	if (match === null) return [h("p", { class: "note" }, say("not-computed-yet"))];
	if (match.geometry === null) {
		const none = match.no_geometry;
		return [h("p", {
			class: none === null ? "note" : "field-problem",
			testid: "geometry-reason"
		}, none === null ? say("not-computed-yet") : say("none", { message: message("no_geometry", none) }))];
	}
	const degenerate = oneImage(state) === null ? match.geometry.degenerate : null;
	return [...degenerate === null ? [] : [h("p", {
		class: "field-problem",
		testid: `degenerate-${degenerate}`
	}, message("degeneracy", degenerate))], facts(figures(match, match.geometry))];
}
function modelText({ model: { kind }, focal }) {
	return message("two_view_model", { kind }, kind === "calibrated" && focal !== null ? "estimated" : "label");
}
function figures(match, geometry) {
	const { model: { kind }, sigma_px: sigma, threshold_px: threshold, focal } = geometry;
	return [
		{
			name: say("model"),
			testid: "geometry-kind",
			value: modelText(geometry),
			help: message("two_view_model", { kind }, "help")
		},
		{
			name: say("matches-that-agree"),
			testid: "geometry-matches",
			value: count(match.counts.matches),
			help: say("all-others-are-rejected-matches")
		},
		{
			name: say("standard-error-of-a-coordinate"),
			testid: "geometry-sigma",
			value: say("px-3", { value: sigma }),
			help: say("from-the-distances-of-these")
		},
		{
			name: say("threshold"),
			testid: "geometry-threshold",
			value: say("px-2", { value: threshold }),
			help: say("largest-distance-of-a-match")
		},
		...focal === null ? [] : [{
			name: say("focal-length-estimated"),
			testid: "geometry-focal",
			value: say("px-5", {
				focal_px: focal.focal_px,
				standard_error_px: focal.standard_error_px
			}),
			help: say("of-both-cameras-from-the")
		}]
	];
}
// www/pair/files/epipolar.ts
async function exportEpipolar(store, engine) {
	const { state } = store;
	const { left, right } = state.images;
	if (left === null || right === null) return null;
	const client = engine.client("report");
	const tell = (kind, text) => store.dispatch({
		type: "notice",
		notice: {
			kind,
			text
		}
	});
	try {
		tell("busy", say("epipolar-images-are-made"));
		const project = await projectText(state, engine);
		if (project === null) throw new Error(say("the-pair-is-not-matched"));
		const { archive, geometry } = await client.call("epipolar", {
			project,
			images: [left.source, right.source]
		});
		save(new Blob([archive], { type: "application/zip" }), `${baseName(state)}-epipolar.zip`);
		const { points = 0, y_rms_px: left_over = 0 } = geometry.parallaxes ?? {};
		tell("info", say("epipolar-images-were-saved", {
			points,
			left_over
		}));
	} catch (error) {
		if (!(error instanceof Cancelled)) throw error;
		tell("info", say("cancelled-nothing-was-saved-the-epipolar"));
	} finally {
		client.cancel();
	}
	return null;
}
// www/pair/files/report.ts
function editsOf(state) {
	const edited = isEdited(state) ? editedPair(state) : null;
	if (edited === null || edited.match === edited.found) return null;
	const { left, match, found } = edited;
	const { matches, fits, indices } = match;
	const added = left.subarray(3 * found.rules.length);
	const { rejected, manual } = countsByHand(match);
	return {
		match: {
			matches,
			fits,
			indices
		},
		added_px: Float64Array.from({ length: 2 * added.length / 3 }, (_, i) => added[3 * Math.floor(i / 2) + i % 2] ?? NaN),
		rejected,
		measured: manual
	};
}
function inputOf(state) {
	const { left, right } = state.images;
	const { settings, camera, photos, masks, offset, fiducialModel } = state;
	if (left === null || right === null || settings === null) return null;
	const truth = truthOf(state);
	const photo = (side) => ({
		...measuredPhoto(photos[side]),
		model: fiducialModel
	});
	return {
		images: [left.source, right.source],
		names: [left.name, right.name],
		input: {
			camera,
			offset,
			left: photo("left"),
			right: photo("right")
		},
		settings,
		truth: truth === null ? null : {
			orientation: truth.orientation,
			base_mm: truth.baseMm,
			right_position: truth.rightPosition
		},
		masks: [masks.left?.grey ?? null, masks.right?.grey ?? null],
		edits: editsOf(state)
	};
}
async function exportReport(store, engine) {
	const input = inputOf(store.state);
	if (input === null) return null;
	const tell = (text) => store.dispatch({
		type: "notice",
		notice: {
			kind: "busy",
			text
		}
	});
	const client = engine.client("report");
	try {
		tell(say("report-reading-the-images"));
		const steps = await client.call("reportOpen", input);
		for (const [i, step] of steps.entries()) {
			tell(say("report-step-of-matching", {
				i: i + 1,
				steps: steps.length + 1,
				step
			}));
			await client.call("reportStep", null);
		}
		tell(say("report-step-of-writing", { steps: steps.length + 1 }));
		const page = await client.call("reportPage", null);
		const name = save(new Blob([page], { type: "text/html" }), `${baseName(store.state)}-report.html`);
		const text = [say("was-saved", { name }), input.edits === null ? "" : say("its-run-has-the-edits")].join(" ").trimEnd();
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text,
				beside: true
			}
		});
	} catch (error) {
		if (!(error instanceof Cancelled)) throw error;
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: say("the-report-was-cancelled")
			}
		});
	} finally {
		client.cancel();
	}
	return null;
}
// www/pair/state/savable.ts
var EXPORTS = [
	"csv",
	"json",
	"project",
	"report",
	"epipolar",
	"png"
];
function savable(state) {
	const { images, results } = state;
	const rests = images.left !== null && images.right !== null && !isBusy(state);
	const { wanted, done } = progress(state);
	const areThere = ![images.left, images.right].some((image) => image?.source.kind === "project");
	const { match, orientation } = shownPair(state);
	return {
		csv: rests && match !== null,
		json: rests && done === wanted && results.pointsLeft !== void 0,
		project: rests && isCurrent(state, "match"),
		report: rests && areThere && (!isEdited(state) || isCurrent(state, "match")),
		epipolar: rests && areThere && orientation !== null && isCurrent(state, "match") && isCurrent(state, "orientation"),
		png: images.left !== null || images.right !== null
	};
}
// www/pair/panel/header.ts
function pickerOf(files) {
	const input = byId("file-input");
	let wanted = {
		side: null,
		what: "any"
	};
	input.addEventListener("change", () => {
		if (!files.isReady) return;
		const given = [...input.files ?? []];
		const [first] = given;
		if (wanted.what === "mask" && wanted.side !== null && first !== void 0) files.takeMask(first, wanted.side);
		else files.give(given.map((file) => ({
			file,
			path: ""
		})), wanted.side);
		input.value = "";
		input.multiple = true;
		wanted = {
			side: null,
			what: "any"
		};
	});
	files.ready.then(() => {
		if ((input.files?.length ?? 0) > 0) input.dispatchEvent(new Event("change"));
	});
	return (side, what = "any") => {
		wanted = {
			side,
			what
		};
		input.multiple = side === null;
		input.click();
	};
}
var WANTED = [
	"settings",
	"camera",
	"photos",
	"masks",
	"fiducialModel",
	"offset",
	"failures",
	"history"
];
function mountHeader({ store, engine, view, files, pick, attempt, saving, sampleBlock }) {
	const on = (id, action) => {
		byId(id).addEventListener("click", () => void attempt(action));
	};
	const onExport = (id, write) => {
		byId(id).addEventListener("click", () => void saving("export-menu", write));
	};
	for (const id of ["open", "open-first"]) on(id, () => pick(null));
	for (const id of ["sample", "sample-first"]) on(id, () => files.takeSample());
	on("sample-block-first", sampleBlock);
	mountMenu(byId("export-menu"), byId("exports"));
	declareLack([byId("swap")], () => SIDES.every((side) => store.state.images[side] === null) ? say("needs-two-photos") : "");
	declareLack([byId("exports")], () => lackOfMatches(store.state));
	on("swap", () => swap(store, engine));
	onExport("export-csv", () => exportMatches(store.state, engine));
	onExport("export-json", () => exportEverything(store.state));
	onExport("export-project", () => exportProject(store, engine));
	onExport("export-report", () => exportReport(store, engine));
	onExport("export-epipolar", () => exportEpipolar(store, engine));
	onExport("export-png", () => exportPicture(store.state, view));
	store.watch([
		"images",
		"results",
		"catalogue",
		"notice",
		"running",
		...WANTED
	], ([images, , catalogue]) => {
		const none = images.left === null && images.right === null;
		const set = (id, disabled) => {
			byId(id).disabled = disabled;
		};
		set("swap", none);
		set("sample", catalogue === null);
		set("sample-first", catalogue === null);
		set("sample-block-first", catalogue === null);
		const now = savable(store.state);
		for (const what of EXPORTS) set(`export-${what}`, !now[what]);
		leaveWelcome(!none);
	});
}
function swap(store, engine) {
	const known = truthOf(store.state) !== null;
	engine.swap();
	if (known) store.dispatch({
		type: "notice",
		notice: {
			kind: "info",
			text: say("the-truth-of-the-simulated-pair")
		}
	});
}
function leaveWelcome(left) {
	const welcome = byId("welcome");
	const { activeElement } = document;
	const focused = welcome.contains(activeElement) || !welcome.hidden && [
		byId("open"),
		byId("sample"),
		byId("menu")
	].some((press) => press === activeElement);
	welcome.hidden = left;
	if (left && focused) byId("view").focus({ preventScroll: true });
}
// www/pair/state/mask-steps.ts
function compositionOf(given, { edits, done }, side) {
	let file = given;
	let areas = [];
	for (const step of edits.slice(0, done)) {
		if (step.side !== side) continue;
		if ("given" in step) [file, areas] = [step.given, []];
		else areas.push(step);
	}
	return {
		file,
		areas
	};
}
function areasAfter(now, then) {
	return now.file === then.file && now.areas.every((area, i) => area === then.areas[i]) ? then.areas.slice(now.areas.length) : null;
}
function withGivenMask({ masks, givenMasks, maskSteps }, side, mask) {
	const given = mask === null ? null : {
		name: mask.name,
		source: mask.source
	};
	const before = masks[side];
	const isGiven = (before === null || before.source.kind === "project") && maskSteps.edits.every((step) => step.side !== side) ? {
		givenMasks: {
			...givenMasks,
			[side]: given
		},
		maskSteps
	} : {
		givenMasks,
		maskSteps: recorded(maskSteps, {
			side,
			given
		})
	};
	return {
		masks: {
			...masks,
			[side]: mask
		},
		...isGiven
	};
}
var CORNER$1 = "corner";
function stepsWithOutline({ maskSteps, outline }) {
	return outline === null ? maskSteps : recorded(maskSteps, CORNER$1);
}
function nameOfMaskStep(step, images) {
	if (step === "corner") return say("step-of-outline");
	const image = images[step.side]?.name ?? "";
	if (!("given" in step)) return say("step-of-mask", {
		deed: step.masked ? "masked" : "unmasked",
		mask: "",
		image
	});
	return say("step-of-mask", {
		deed: step.given === null ? "removed" : "given",
		mask: step.given?.name ?? "",
		image
	});
}
// www/pair/panel/history.ts
var PARTS = [
	"history",
	"maskSteps",
	"markSteps"
];
function mountHistory(host, store, go) {
	const unfold = h("summary", {}, "");
	const details = h("details", { testid: "history-section" }, unfold);
	const section = h("div", { class: "edits" }, details);
	const lists = [
		listOf(store, "", say("matches-2"), say("as-matched"), "history", nameOfEdit, go.matches),
		listOf(store, "masks-", say("history-of-masks"), say("masks-as-given"), "maskSteps", nameOfMaskStep, go.masks),
		listOf(store, "marks-", say("history-of-marks"), say("marks-as-given"), "markSteps", nameOfMarkStep, go.marks)
	];
	details.append(...lists.map(({ element }) => element));
	host.append(section);
	store.watch(PARTS, (histories) => {
		const counts = histories.map(({ edits }) => edits.length);
		const edits = counts.reduce((sum, count) => sum + count, 0);
		section.hidden = edits === 0;
		fill(unfold, say("history-2", { edits }));
		lists.forEach(({ element, title }, i) => {
			element.hidden = counts[i] === 0;
			title.hidden = edits === counts[0];
		});
	});
}
function listOf(store, prefix, name, first, part, nameOf, go) {
	const list = h("ol", {
		class: "history",
		testid: `${prefix}history`,
		aria: { label: name }
	});
	store.watch([part, "images"], ([history, images]) => showHistory(list, prefix, first, history, (step) => nameOf(step, images), go));
	const title = h("p", { class: "group-label" }, name);
	return {
		element: h("div", {}, title, list),
		title
	};
}
// www/pair/state/histogram.ts
function quantile(sorted, q) {
	return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? NaN;
}
function columnOf(values, stride, at) {
	const column = new Float64Array(Math.floor(values.length / stride));
	for (let i = 0; i < column.length; i++) column[i] = values[i * stride + at] ?? NaN;
	return column;
}
function sortedFinite(values) {
	const sorted = values.slice().sort();
	let end = sorted.length;
	while (end > 0 && !((sorted[end - 1] ?? NaN) < Infinity)) end -= 1;
	let start = 0;
	while (start < end && sorted[start] === -Infinity) start += 1;
	return sorted.subarray(start, end);
}
function histogram(values, bins, { symmetric = false, from } = {}) {
	const sorted = sortedFinite(values);
	let low = from ?? quantile(sorted, .005);
	let high = quantile(sorted, .995);
	if (symmetric) {
		high = Math.max(Math.abs(low), Math.abs(high));
		low = -high;
	}
	if (!(high > low)) high = low + 1;
	const counts = new Array(bins).fill(0);
	let outside = 0;
	for (const value of sorted) {
		if (value < low || value > high) outside += 1;
		const bin = Math.min(bins - 1, Math.max(0, Math.floor((value - low) / (high - low) * bins)));
		counts[bin] = (counts[bin] ?? 0) + 1;
	}
	return {
		low,
		high,
		counts,
		outside,
		total: sorted.length,
		median: quantile(sorted, .5)
	};
}
// www/pair/panel/histograms.ts
var BINS = 40;
var WIDTH = 320;
var HEIGHT = 84;
var measures = remember((compared) => histogram(compared, BINS, { from: 0 }));
var residuals = remember((values) => histogram(values, BINS, { symmetric: true }));
var interestLeft = remember((points) => histogram(columnOf(points, 3, 2), BINS));
var interestRight = remember((points) => histogram(columnOf(points, 3, 2), BINS));
function mountHistograms(host, store) {
	const body = h("div", { class: "histograms" });
	const panel = section(say("histograms"), "histograms-section", body);
	host.append(panel);
	let round = 0;
	store.watch([
		"results",
		"history",
		"images",
		"settings",
		"camera",
		"photos",
		"offset",
		"fiducialModel",
		"failures"
	], whenInSight(host, () => {
		panel.classList.toggle("is-stale", isStale(store.state, "match"));
		round += 1;
		update(body, store, () => round, round);
	}));
}
async function update(body, store, round, own) {
	const charts = [];
	for (const make of CHARTS) {
		await new Promise((resolve) => window.setTimeout(resolve, 0));
		if (round() !== own) return;
		const made = make(store.state);
		if (made !== null) charts.push(made);
	}
	fill(body, ...charts.length > 0 ? charts : [h("p", { class: "note" }, say("no-points-yet"))]);
}
var CHARTS = [
	(state) => {
		const { match } = shownPair(state);
		return match === null || match.counts.matches === 0 ? null : chart(say("measure-of-the-matches"), "", measures(measuresOf(match)), "histogram-measure");
	},
	(state) => {
		const { orientation } = shownPair(state);
		const interior = interiorInUse(state)?.left;
		if (orientation === null || interior === void 0) return null;
		const figure = chart(say("y-parallax-residuals-of-the"), "px", residuals(parallaxResiduals(orientation, interior)), "histogram-residuals");
		return markStale(figure, isStale(state, "orientation") && !isStale(state, "match"));
	},
	(state) => {
		const { left } = shownPair(state);
		return left === null || left.length === 0 ? null : chart(say("interest-value-left"), "", interestLeft(left), "histogram-interest-left");
	},
	(state) => {
		const { right } = shownPair(state);
		return right === null || right.length === 0 ? null : chart(say("interest-value-right"), "", interestRight(right), "histogram-interest-right");
	}
];
function chart(title, unit, data, testid) {
	const most = Math.max(...data.counts, 1);
	const width = WIDTH / data.counts.length;
	const bars = data.counts.map((n, i) => {
		const bar = Math.round(HEIGHT * n / most * 100) / 100;
		return n === 0 ? "" : `M${String(i * width + .5)} ${String(HEIGHT)}v-${String(bar)}h${String(width - 1)}v${String(bar)}z`;
	}).join("");
	const at = (value) => WIDTH * (value - data.low) / (data.high - data.low);
	const suffix = unit === "" ? "" : ` ${unitText(unit)}`;
	const words = say("values-median-shown-from-to", {
		title,
		total: data.total,
		median: significant(data.median),
		suffix,
		low: significant(data.low),
		high: significant(data.high),
		most
	});
	const picture = svg("svg", {
		viewBox: `0 0 ${String(WIDTH)} ${String(85)}`,
		class: "histogram",
		role: "img",
		"aria-label": words,
		preserveAspectRatio: "none"
	}, svg("path", {
		d: bars,
		class: "bars"
	}), svg("path", {
		d: `M0 ${String(84.5)}h${String(WIDTH)}`,
		class: "axis"
	}), svg("path", {
		d: `M${String(at(data.median))} 0v${String(HEIGHT)}`,
		class: "median"
	}));
	return h("figure", { testid }, h("figcaption", {}, title, h("span", { class: "unit" }, `${suffix} · n = ${count(data.total)}`)), picture, h("div", { class: "scale" }, h("span", {}, significant(data.low)), h("span", {}, say("median", { median: significant(data.median) })), h("span", {}, significant(data.high))));
}
// www/pair/panel/masking.ts
function mountMasking(host, bar, store, masking, { paint, step, giveUp }) {
	const tool = button(say("mask-areas"), "tool-mask", () => masking.toggle(), say("outline-areas-in-which-no"));
	const text = h("span", {
		testid: "mask-text",
		role: "status"
	});
	const mask = button(say("mask-it"), "mask-area", () => paint(true), say("no-points-in-the-outlined"));
	const unmask = button(say("unmask-it"), "unmask-area", () => paint(false), say("points-in-the-outlined-area"));
	const undo = button(say("undo-sign"), "mask-undo", () => step(-1));
	const redo = button(say("redo-sign"), "mask-redo", () => step(1));
	const keep = button(say("save-masks"), "mask-save", () => saveMasks(store), say("masks-as-png-files-for"));
	const end = button(say("end-masking"), "mask-end", () => masking.toggle());
	const buttons = h("div", {
		class: "drafting",
		testid: "masking",
		role: "group",
		aria: { label: say("masks-of-the-pictures") }
	}, text, mask, unmask, undo, redo, keep, end);
	declareLack([buttons], () => store.state.tool === "mask" ? "" : say("nothing-is-outlined"));
	host.append(tool);
	undoKeys(() => byId("view").offsetParent !== null && store.state.tool === "mask" && !marksHaveKeys(store.state), step);
	const leave = declare({
		where: say("anywhere-while-masking"),
		host: buttons,
		list: [{
			keys: ["Escape"],
			does: say("gives-the-outline-up"),
			can: () => store.state.outline !== null && byId("view").offsetParent !== null,
			run: giveUp
		}]
	});
	document.addEventListener("keydown", (event) => {
		if (event.defaultPrevented || hasOwnUndo(event.target) || event.target instanceof Element && event.target.closest("select") !== null) return;
		if (leave(event.key, event.shiftKey)) event.preventDefault();
	});
	bar.append(buttons);
	store.watch((s) => [
		s.tool,
		s.outline,
		s.images,
		s.masks,
		s.maskSteps
	], () => {
		const { state } = store;
		const held = document.activeElement;
		tool.setAttribute("aria-pressed", String(state.tool === "mask"));
		tool.disabled = !masking.can();
		buttons.hidden = state.tool !== "mask";
		mask.disabled = !masking.isArea();
		unmask.disabled = mask.disabled;
		showSteps(undo, redo, stepsWithOutline(state), (one) => nameOfMaskStep(one, state.images));
		keep.disabled = SIDES.every((side) => fileOf(state, side) === null);
		if (buttons.contains(held)) passFocus(held, [byId("view")]);
		const corners = state.outline?.corners.length ?? 0;
		const now = masking.isArea() ? say("the-area-is-outlined", { corners }) : say("draw-round-an-area-or", { corners });
		if (text.textContent !== now) text.textContent = now;
	});
}
function fileOf(state, side) {
	const source = state.masks[side]?.source;
	return source?.kind === "file" ? source.file : null;
}
function saveMasks(store) {
	const { state } = store;
	for (const side of SIDES) {
		const file = fileOf(state, side);
		if (file !== null) save(file, state.masks[side]?.name ?? "mask.png");
	}
	if (state.notice?.kind !== "busy") store.dispatch({
		type: "notice",
		notice: null
	});
}
// pkg/pair/at-base.js
function atBase(orientation, baseMm, otherMm) {
	const scale = baseMm === 0 ? NaN : otherMm / baseMm;
	return {
		...orientation,
		by_mm: scale * orientation.by_mm,
		bz_mm: scale * orientation.bz_mm
	};
}
// www/pair/panel/matrix.ts
var CELL = 44;
var HEAD = 26;
var FOOT = 12;
function correlationPicture({ correlations }) {
	const size = HEAD + CELL * UNKNOWNS.length;
	const words = UNKNOWNS.flatMap(({ symbol }, i) => UNKNOWNS.slice(i + 1).map((other, k) => say("and", {
		symbol,
		symbol_2: other.symbol,
		correlations: correlations[i]?.[i + 1 + k]
	})));
	const heads = UNKNOWNS.flatMap(({ symbol }, i) => [svg("text", {
		x: HEAD + CELL * (i + .5),
		y: 18,
		class: "matrix-name"
	}, symbol), svg("text", {
		x: HEAD / 2,
		y: HEAD + CELL * (i + .5) + 4,
		class: "matrix-name"
	}, symbol)]);
	const cells = UNKNOWNS.flatMap((_, i) => UNKNOWNS.map((__, j) => cellOf(correlations[i]?.[j] ?? NaN, i, j)));
	return h("figure", { testid: "correlations" }, h("figcaption", { title: say("from-the-inverse-of-the") }, say("correlations-of-the-unknowns")), svg("svg", {
		viewBox: `0 0 ${String(size)} ${String(size)}`,
		class: "correlations",
		role: "img",
		"aria-label": say("correlations", { join: words.join(", ") })
	}, ...heads, ...cells));
}
function cellOf(value, row, column) {
	const side = 28 * Math.sqrt(Math.min(1, Math.abs(value)));
	const x = HEAD + CELL * (column + .5);
	const y = HEAD + CELL * (row + .5);
	const middle = y - FOOT / 2;
	return svg("g", { "data-testid": `correlation-${String(row)}-${String(column)}` }, svg("rect", {
		x: x - CELL / 2,
		y: y - CELL / 2,
		width: CELL,
		height: CELL,
		class: "matrix-cell"
	}), svg("rect", {
		x: x - side / 2,
		y: middle - side / 2,
		width: side,
		height: side,
		class: value < 0 ? "negative" : "positive"
	}), svg("text", {
		x,
		y: y + CELL / 2 - 3,
		class: "matrix-value"
	}, fixed(value, 2)));
}
var PLOT = 150;
function ellipsePicture(ellipse, of95, deviation) {
	const { semi_major: major, semi_minor: minor, bearing_deg: angle } = ellipse;
	const reach = Math.max((of95 ?? ellipse).semi_major, ...(deviation ?? []).map((d) => 1.15 * Math.abs(d)));
	const scale = PLOT / 2 / reach;
	const words = say("standard-error-ellipse-of-by", {
		major: significant(major),
		minor: significant(minor),
		angle
	});
	const truth = deviation === null ? [] : [svg("path", {
		d: cross(-deviation[0] * scale, deviation[1] * scale),
		class: "truth"
	})];
	return h("figure", { testid: "ellipse" }, h("figcaption", { title: words }, say("by-bz-ellipse-m", {
		major: significant(1e3 * major),
		minor: significant(1e3 * minor),
		what: [of95 ? say("dashed-95") : "", deviation === null ? "" : say("cross-truth")].join("")
	})), svg("svg", {
		viewBox: `${String(-75)} ${String(-75)} ${String(PLOT)} ${String(PLOT)}`,
		class: "ellipse",
		role: "img",
		"aria-label": words
	}, svg("path", {
		d: `M${String(-75)} 0h${String(PLOT)}M0 ${String(-75)}v${String(PLOT)}`,
		class: "axis"
	}), svg("ellipse", {
		...axesOf(ellipse, scale),
		class: "outline"
	}), ...of95 ? [svg("ellipse", {
		...axesOf(of95, scale),
		class: "outline faint"
	})] : [], ...truth, svg("text", {
		x: 59,
		y: -5,
		class: "matrix-name"
	}, "by"), svg("text", {
		x: 12,
		y: -63,
		class: "matrix-name"
	}, "bz")));
}
var axesOf = ({ semi_major: major, semi_minor: minor, bearing_deg: angle }, scale) => ({
	rx: major * scale,
	ry: minor * scale,
	transform: `rotate(${String(-angle)})`
});
function cross(x, y) {
	return `M${String(x - 5)} ${String(y - 5)}l10 10M${String(x + 5)} ${String(y - 5)}l-10 10`;
}
// www/pair/panel/orientation.ts
var SIGMA_CAVEAT = say("is-computed-from-y-parallaxes");
function mountOrientation(host, store) {
	const body = h("div", {});
	const panel = section(say("relative-orientation"), "orientation-section", body);
	host.append(panel);
	store.watch([
		"results",
		"settings",
		"images",
		"failures",
		"camera",
		"photos",
		"offset",
		"fiducialModel"
	], whenInSight(host, () => {
		const { state } = store;
		panel.classList.toggle("is-stale", whyNotOriented(state) === null && isStale(state, "orientation"));
		fill(body, ...content$1(state));
	}));
}
function content$1(state) {
	const reason = whyNotOriented(state);
	if (reason !== null) return [h("p", {
		class: "note",
		testid: "orientation-reason"
	}, reason)];
	const result = state.results.orientation?.value;
	if (result === void 0) return [h("p", {
		class: "note",
		testid: "orientation-reason"
	}, say("not-computed-yet"))];
	return [
		...estimatedFocal(state),
		valueTable(state, result),
		...result.turn_deg === 0 ? [] : [h("p", {
			class: "note",
			testid: "axes-turned"
		}, say("axes-turned"))],
		...warnings(result),
		precision(state, result),
		h("p", {
			class: "caveat",
			testid: "sigma-caveat"
		}, SIGMA_CAVEAT),
		pictures(state, result)
	];
}
function estimatedFocal(state) {
	const text = estimatedFocalText(state);
	return text === null ? [] : [h("p", {
		class: "note",
		testid: "estimated-focal"
	}, text)];
}
function estimatedFocalText(state) {
	const focal = focalOf(state);
	return focal?.isEstimated === true ? say("estimated-focal", {
		focal_px: focal.focalPx,
		error_px: focal.errorPx
	}) : null;
}
function whyNotOriented(state) {
	if (state.images.left === null || state.images.right === null) return say("two-images-are-needed");
	const reason = whyNone(state);
	if (reason === null || reason.kind === "refused") {
		const failure = failureOf(state);
		return failure === null ? null : say("not-oriented-3", { message: failure.message });
	}
	switch (reason.kind) {
		case "no_geometry": return say("not-oriented-do-both-photos", { message: message("no_geometry", reason.no_geometry) });
		case "no_camera":
		case "no_focal_length":
		case "no_pixel_size": {
			const untold = isCurrent(state, "match") && state.results.match?.value.geometry != null ? say("and-the-matches-do-not") : "";
			return say("not-oriented-give-the-focal", {
				message: message("no_orientation", reason),
				untold
			});
		}
		default: return say("not-oriented-2", { message: message("no_orientation", reason) });
	}
}
function truthFor(state, { base_mm: base }) {
	const truth = truthOf(state);
	return truth === null ? null : atBase(truth.orientation, truth.baseMm, base);
}
function valueTable(state, result) {
	const truth = truthFor(state, result);
	const paper = truth === null && hasPaperCamera(state) ? state.catalogue?.paper : void 0;
	const { standard_errors: errors, total_standard_errors: total, half_widths_95: half } = result;
	const number = (testid, value, digits, kind = "") => h("td", {
		testid,
		class: `number ${kind}`
	}, fixed(value, digits));
	const rows = UNKNOWNS.map(({ field, symbol, unit, digits: printedDigits }) => {
		const digits = decimalsOfError(errors?.[field], printedDigits);
		const error = truth === null ? NaN : result[field] - truth[field];
		const own = [number(`orientation-${field}`, result[field], digits), number(`error-${field}`, errors?.[field], digits)];
		const withInterior = total === null ? [] : [number(`total-error-${field}`, total[field], digits)];
		const interval = number(`interval-${field}`, half?.[field], digits);
		const printed = paper === void 0 ? [] : [number(`paper-${field}`, paper.orientations[2].values[field], printedDigits, "paper"), number(`paper-error-${field}`, paper.standard_errors[field], printedDigits, "paper")];
		const compared = truth === null ? printed : [number(`deviation-${field}`, error, digits), number(`deviation-ratio-${field}`, error / ((total ?? errors)?.[field] ?? NaN), 1)];
		return row(h("span", {}, h("i", {}, symbol), h("span", { class: "unit" }, ` ${unitText(unit)}`)), ...own, ...withInterior, interval, ...compared);
	});
	const heads = [
		[say("value"), say("the-right-photo-relative-to")],
		[say("std-error"), say("what-the-scatter-of-the")],
		...total === null ? [] : [[say("in-total"), say("standard-error-including-what-does")]],
		["95 % ±", say("half-width-of-the-interval")],
		...paper !== void 0 ? [[
			say("paper-2"),
			say("the-papers-table-3-of"),
			"paper"
		], [
			say("its-error"),
			say("the-papers-table-2"),
			"paper"
		]] : [],
		...truth === null ? [] : [[say("true-error"), say("value-minus-truth-by-and")], [say("in-std-errors"), say("the-true-error-divided-by")]]
	];
	const note = paper !== void 0 ? h("p", { class: "note" }, paperNote(state, paper)) : null;
	return h("div", {}, scrolledByKeys(h("div", { class: "scroll" }, h("table", {
		class: "tight",
		aria: { label: say("relative-orientation") }
	}, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, say("unknown")), ...heads.map(([text, title, kind = ""]) => h("th", {
		scope: "col",
		title,
		class: kind
	}, text)))), h("tbody", {}, ...rows)))), note);
}
function paperNote({ catalogue }, { pixel_mm: pixel }) {
	const flight = catalogue?.flights.find(({ name }) => name === "paper")?.flight;
	return say("paper", {
		focal_mm: flight?.focal_mm ?? null,
		base_mm: flight?.base_mm ?? null,
		pixel_um: 1e3 * pixel
	});
}
function warnings({ warnings: found }) {
	return found.map((warning) => h("p", {
		class: "field-problem",
		testid: `warning-${warning.kind}`
	}, message("warning", warning)));
}
function precision(state, result) {
	const interior = interiorInUse(state)?.left;
	const pixel = interior === void 0 ? null : pixelMm(interior);
	const sigma = result.sigma0_mm;
	const { all, used } = countsOf$1(result);
	const test = result.global_test;
	const printed = hasPaperCamera(state) ? state.catalogue?.paper : void 0;
	return facts([
		{
			name: say("of-a-photo-coordinate"),
			testid: "sigma0",
			value: sigma == null ? "–" : `${withUnit(fixed(1e3 * sigma, 2), "µm")}${pixel === null ? "" : say("px-6", { sigma: sigma / pixel })}`,
			help: say("standard-error-of-one-photo", { sigma_caveat: SIGMA_CAVEAT })
		},
		{
			name: say("of-a-y-parallax-2"),
			testid: "sigma-parallax",
			value: sigma == null || pixel === null ? "–" : say("px-3", { value: Math.SQRT2 * sigma / pixel }),
			help: say("standard-error-of-the-y")
		},
		...test === null ? [] : [{
			name: say("global-test-2"),
			testid: "global-test",
			value: `${fixed(test.statistic, 1)}: ${test.passed ? say("passed") : say("failed-3")}`,
			...test.passed ? {} : { kind: "problem" },
			help: say("global-test", {
				lower: test.lower,
				upper: test.upper
			})
		}],
		{
			name: say("degrees-of-freedom"),
			testid: "degrees-of-freedom",
			value: count(result.degrees_of_freedom),
			help: say("matches-used-minus-the-five")
		},
		{
			name: say("matches-used"),
			testid: "matches-used",
			value: say("of-7", {
				used,
				residuals_mm: all
			}),
			help: say("data-snooping-rejected-the-others")
		},
		{
			name: say("condition"),
			testid: "condition",
			value: significant(result.condition),
			help: say("largest-by-smallest-eigenvalue-of")
		},
		{
			name: say("misfit-to-a-plane"),
			testid: "plane-misfit",
			value: result.plane_misfit === null ? "–" : `${significant(result.plane_misfit)} σ₀`,
			help: say("how-far-the-matches-deviate")
		},
		{
			name: say("parallax-beside-a-rotation"),
			testid: "rotation-parallax",
			value: pixel === null ? say("mm-2", { value: significant(result.parallax_beside_rotation_mm) }) : say("px-7", { value: significant(result.parallax_beside_rotation_mm / pixel) }),
			help: say("median-parallax-that-the-best")
		},
		{
			name: say("spread"),
			testid: "spread",
			value: `${fixed(result.spread, 3)} f`,
			help: say("root-mean-square-distance-of-the")
		},
		{
			name: say("iterations-last-step"),
			testid: "iterations",
			value: say("of-the-tolerance", {
				iterations: String(result.iterations),
				step: significant(result.last_step)
			}),
			help: say("the-last-step-relative-to")
		},
		{
			name: say("base-b-principal-distance"),
			testid: "base",
			value: say("mm-mm", {
				base_mm: significant(result.base_mm),
				focal_mm: significant(result.focal_mm)
			}),
			help: say("the-base-component-that-was")
		},
		...printed !== void 0 ? [{
			name: say("paper-2"),
			testid: "paper-sigma0",
			value: say("paper-sigma", {
				sigma0_mm: printed.sigma0_mm,
				sigma0_px: printed.sigma0_mm / printed.pixel_mm
			}),
			help: say("what-the-paper-printed-for")
		}] : []
	]);
}
function pictures(state, result) {
	const truth = truthFor(state, result);
	const deviation = truth === null || Number.isNaN(truth.by_mm) ? null : [result.by_mm - truth.by_mm, result.bz_mm - truth.bz_mm];
	const ellipse = result.base_ellipse_mm;
	return h("div", { class: "precision-pictures" }, correlationPicture(result), ellipse === null ? null : ellipsePicture(ellipse, result.base_ellipse_95_mm ?? void 0, deviation));
}
// www/pair/panel/panes.ts
function mountPanes(view, store, actions) {
	const labels = {
		left: label("left", actions),
		right: label("right", actions)
	};
	view.host.append(labels.left.element, labels.right.element);
	const place = () => {
		const panes = panesOf(store.state, view.host.clientWidth, view.host.clientHeight);
		for (const side of SIDES) {
			const { style } = labels[side].element;
			const { left, top, width, height } = panes[side];
			Object.assign(style, {
				width: `${String(width)}px`,
				height: `${String(height)}px`
			});
			style.setProperty("--left", `${String(left)}px`);
			style.setProperty("--top", `${String(top)}px`);
		}
	};
	place();
	new ResizeObserver(place).observe(view.host);
	store.watch((s) => [
		s.images,
		s.masks,
		s.results.openLeft,
		s.results.openRight,
		s.activeSide
	], () => {
		place();
		for (const side of SIDES) {
			labels[side].element.classList.toggle("is-active", store.state.activeSide === side);
			labels[side].element.classList.toggle("is-empty", store.state.images[side] === null);
			labels[side].show(store.state);
		}
	});
}
function label(side, actions) {
	const name = h("span", {
		class: "pane-name",
		testid: `name-${side}`
	});
	const replace = button(say("replace"), `replace-${side}`, () => actions.open(side));
	replace.setAttribute("aria-label", say("replace-the-image", { side }));
	const empty = button(say("open-the-image-2", { side }), `open-${side}`, () => actions.open(side));
	empty.className = "invitation";
	const mask = button(say("mask"), `mask-${side}`, () => actions.mask(side), say("an-image-of-the-same"));
	const unmask = button(say("mask-2"), `unmask-${side}`, () => actions.unmask(side));
	unmask.setAttribute("aria-label", say("remove-the-mask-of-the", { side }));
	const of = say("image-4", { name: side === "left" ? say("left") : say("right") });
	const head = h("div", {
		class: "pane-head twin",
		role: "group",
		aria: { label: of }
	}, name, replace, mask, unmask);
	const element = h("div", {
		class: "pane-frame",
		testid: `pane-${side}`
	}, head, empty);
	const show = (state) => {
		const image = state.images[side];
		const opened = state.results[side === "left" ? "openLeft" : "openRight"];
		const given = state.masks[side];
		head.hidden = image === null;
		mask.hidden = given !== null;
		unmask.hidden = given === null;
		unmask.title = given === null ? "" : say("remove-3", { name: given.name });
		empty.hidden = image !== null;
		const size = opened === void 0 || image === null ? "" : say("px-8", {
			width: opened.value.info.width,
			height: opened.value.info.height
		});
		name.title = image === null ? "" : `${asFigure(image.name)}${size}`;
		fill(name, h("span", {}, image?.name ?? ""), h("span", {}, size));
	};
	return {
		element,
		show
	};
}
// www/pair/panel/feature.ts
var PIXEL = 3;
var SIZE = 112 * PIXEL;
var STAR = "#ffd400";
var GRID = "rgb(255 212 0 / 0.55)";
var featurePictures = remember(({ features }) => {
	if (features === null) return [];
	const both = (name, testid, placed, picture, text) => {
		const one = (side, label) => {
			const feature = features[side];
			if (feature === null) return h("figure", {}, h("p", { class: "note" }, say("no-point")), h("figcaption", {}, label));
			if (feature.descriptor === null) return placeFigure(feature, label, placed);
			const canvas = picture(feature);
			canvas.setAttribute("aria-label", say("point-2", {
				label,
				name
			}));
			return h("figure", {}, canvas, h("figcaption", {}, `${label}${text(feature)}`));
		};
		return [h("h4", {}, name), h("div", {
			class: "windows",
			testid
		}, one("left", say("left")), one("right", say("right")))];
	};
	return [...both(say("turned-and-scaled-to-the"), "point-patches", false, turnedPicture, () => ""), ...both(say("descriptor-as-it-lies-in"), "point-descriptors", true, uprightPicture, ({ scale, direction, reach }) => say("scale-px-direction-px-wide", {
		scale,
		direction: direction * 180 / Math.PI,
		reach
	}))];
});
function placeFigure({ upright, byHand }, label, placed) {
	const why = say("no-interest-point-here", { by: byHand ? "hand" : "least_squares" });
	if (!placed) return h("figure", {}, h("p", { class: "note" }, why), h("figcaption", {}, label));
	const [canvas] = canvasOf(upright);
	canvas.setAttribute("aria-label", say("point-2", {
		label,
		name: why
	}));
	return h("figure", {}, canvas, h("figcaption", {}, label));
}
function stretched(grey) {
	const [low, high] = grey.reduce(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [255, 0]);
	return grey.map((value) => 255 * (value - low) / Math.max(1, high - low));
}
function canvasOf(grey) {
	const canvas = h("canvas", {
		class: "window",
		role: "img"
	});
	canvas.width = SIZE;
	canvas.height = SIZE;
	const context = canvas.getContext("2d");
	if (context === null) return [canvas, context];
	const samples = stretched(grey);
	const pixels = context.createImageData(SIZE, SIZE);
	for (let i = 0; i < SIZE * SIZE; i++) {
		const sample = 112 * Math.floor(i / SIZE / PIXEL) + Math.floor(i % SIZE / PIXEL);
		pixels.data.fill(samples[sample] ?? 0, 4 * i, 4 * i + 3);
		pixels.data[4 * i + 3] = 255;
	}
	context.putImageData(pixels, 0, 0);
	return [canvas, context];
}
function turnedPicture({ turned }) {
	return canvasOf(turned)[0];
}
function uprightPicture({ upright, descriptor, direction }) {
	const [canvas, context] = canvasOf(upright);
	if (context === null) return canvas;
	context.translate(SIZE / 2, SIZE / 2);
	context.rotate(direction);
	drawGrid(context, SIZE / SURROUNDINGS);
	drawStars(context, SIZE / SURROUNDINGS, descriptor);
	return canvas;
}
function drawGrid(context, side) {
	context.strokeStyle = GRID;
	context.lineWidth = 1.5;
	context.beginPath();
	for (let k = 0; k <= 4; k++) {
		const at = side * (k / 4 - .5);
		context.moveTo(at, -side / 2);
		context.lineTo(at, side / 2);
		context.moveTo(-side / 2, at);
		context.lineTo(side / 2, at);
	}
	context.moveTo(side / 2, 0);
	context.lineTo(side / 2 + 14, 0);
	context.stroke();
}
function drawStars(context, side, descriptor) {
	const cell = side / 4;
	const most = descriptor.reduce((a, b) => Math.max(a, b), 1);
	context.strokeStyle = STAR;
	context.lineWidth = 2.5;
	context.beginPath();
	descriptor.forEach((value, i) => {
		const place = Math.floor(i / 8);
		const x = (place % 4 + .5) * cell - side / 2;
		const y = (Math.floor(place / 4) + .5) * cell - side / 2;
		const angle = i % 8 * 2 * Math.PI / 8;
		const length = .5 * cell * value / most;
		context.moveTo(x, y);
		context.lineTo(x + length * Math.cos(angle), y + length * Math.sin(angle));
	});
	context.stroke();
}
// www/pair/panel/window.ts
function windowPicture(report, col, row, axis) {
	const { side } = report;
	const canvas = h("canvas", {
		class: "window",
		role: "img",
		aria: { label: say("px-window-enlarged", { side }) }
	});
	const pixel = Math.max(2, Math.floor(264 / side));
	canvas.width = side * pixel;
	canvas.height = side * pixel;
	const context = canvas.getContext("2d");
	if (context === null) return canvas;
	for (let i = 0; i < side * side; i++) {
		const grey = String(report.grey[i] ?? 0);
		context.fillStyle = report.mask[i] === false ? `rgb(${grey} ${grey} ${grey} / 0.25)` : `rgb(${grey} ${grey} ${grey})`;
		context.fillRect(i % side * pixel, Math.floor(i / side) * pixel, pixel, pixel);
	}
	if (axis) drawAxis(context, report, [report.centroid_px[0] - col - .5, report.centroid_px[1] - row - .5], pixel);
	return canvas;
}
function drawAxis(context, report, [dx, dy], pixel) {
	const middle = report.side * pixel / 2;
	const x = middle + dx * pixel;
	const y = middle + dy * pixel;
	const angle = report.axis_angle_deg * Math.PI / 180;
	const reach = .45 * report.side * pixel;
	context.strokeStyle = "#ffd400";
	context.lineWidth = 2;
	context.beginPath();
	context.moveTo(x - reach * Math.cos(angle), y - reach * Math.sin(angle));
	context.lineTo(x + reach * Math.cos(angle), y + reach * Math.sin(angle));
	context.stroke();
	context.beginPath();
	context.arc(x, y, 5, 0, 2 * Math.PI);
	context.stroke();
}
// www/pair/panel/point.ts
var MOST_ROWS = 50;
function mountPoint(host, store, select) {
	const body = h("div", { testid: "point-panel" });
	host.append(body);
	store.watch([
		"selection",
		"results",
		"history",
		"images",
		"settings",
		"failures"
	], whenInSight(host, () => {
		const { state } = store;
		body.classList.toggle("is-stale", state.selection !== null && state.results.match !== void 0 && !isCurrent(state, "match"));
		const focused = body.contains(document.activeElement);
		fill(body, ...content(state, select));
		if (focused) host.focus({ preventScroll: true });
	}));
}
function content(state, select) {
	const { selection } = state;
	const shown = shownPair(state);
	const points = selection === null ? null : shown[selection.side];
	if (selection === null || points === null || 3 * selection.index >= points.length) return [h("p", { class: "note" }, say("click-a-point-in-an"))];
	const at = points.subarray(3 * selection.index, 3 * selection.index + 3);
	const parts = [h("h3", {}, say("point-3", {
		what: selection.side === "left" ? say("left") : say("right"),
		index: selection.index + 1
	})), h("p", {
		class: "facts-line",
		testid: "point-position"
	}, say("x-px-y-px-interest", {
		at: at[0],
		at_2: at[1],
		significant: significant(at[2] ?? 0)
	}))];
	if (shown.match === null) return [...parts, h("p", { class: "note" }, say("not-matched-yet"))];
	parts.push(verdict(state, shown, shown.match));
	const inspection = state.results.inspection?.value;
	if (inspection === void 0 || !isCurrent(state, "inspection")) return [...parts, h("p", { class: "note" }, problemOr(state, say("loading-the-window-and-the")))];
	const byGrey = state.settings !== null && comparesGreyValues(state.settings);
	const compared = state.settings !== null && comparesGradients(state.settings) ? featurePictures(inspection) : [windows(inspection, !byGrey), ...byGrey ? [] : moments(inspection)];
	return [
		...parts,
		...compared,
		...lineNote(inspection, shown.match),
		...matchStatistics(state, shown.match),
		...candidateTable(state, shown.match, inspection, select)
	];
}
function lineNote({ line }, { geometry }) {
	if (line === null || geometry === null) return [];
	const text = "fundamental" in geometry.model ? say("the-dashed-line-in-the", { side: line.side }) : say("the-cross-in-the-image", { side: line.side });
	return [h("p", {
		class: "note",
		testid: "point-line"
	}, line.positions.length === 0 ? say("by-the-geometry-of-the", { side: line.side }) : text)];
}
function problemOr(state, text) {
	return state.failures.inspection?.message ?? text;
}
function verdict(state, shown, match) {
	const { code, text } = verdictOf(state, shown, match);
	return h("p", {
		class: "verdict",
		testid: "point-verdict"
	}, swatch(styleOf(code)), h("span", {}, text));
}
function windows({ left, right }, axes) {
	const one = (name, window) => {
		const report = window?.report ?? null;
		const picture = window === null || report === null ? h("p", { class: "note" }, window?.problem ?? say("no-point")) : windowPicture(report, window.col, window.row, axes);
		return h("figure", {}, picture, h("figcaption", {}, name, report === null || !axes ? "" : say("axis", { axis_angle_deg: report.axis_angle_deg })));
	};
	return h("div", {
		class: "windows",
		testid: "point-windows"
	}, one(say("left-window"), left), one(say("right-window"), right));
}
var MOMENTS = [
	["mu20", "µ′₂₀"],
	["mu11", "µ′₁₁"],
	["mu02", "µ′₀₂"],
	["mu30", "µ′₃₀"],
	["mu21", "µ′₂₁"],
	["mu12", "µ′₁₂"],
	["mu03", "µ′₀₃"]
];
function moments({ left, right }) {
	if ((left?.report ?? right?.report ?? null) === null) return [];
	const value = (number) => h("td", { class: "number" }, number === void 0 ? "–" : significant(number));
	const head = (text) => h("thead", {}, h("tr", {}, h("th", { scope: "col" }, text), h("th", { scope: "col" }, say("left")), h("th", { scope: "col" }, say("right"))));
	return [h("div", { class: "moments" }, h("table", {
		testid: "point-moments",
		aria: { label: say("normalised-central-moments") }
	}, head(say("moment")), h("tbody", {}, ...MOMENTS.map(([field, name]) => row(name, value(left?.report?.normalized[field]), value(right?.report?.normalized[field]))))), h("table", {
		testid: "point-invariants",
		aria: { label: say("invariants") }
	}, head(say("invariant")), h("tbody", {}, ...MOMENTS.map((_, i) => row(`I${"₀₁₂₃₄₅₆".charAt(i)}`, value(left?.report?.invariants[i]), value(right?.report?.invariants[i]))))))];
}
function matchStatistics(state, match) {
	const index = matchOfLeft(match)[leftIndexOf(state, match.best, match.rules)] ?? -1;
	if (index < 0) return [];
	const columns = statisticsOfState(state)?.columns ?? [];
	const right = match.matches.subarray(5 * index + 2, 5 * index + 4);
	const list = [{
		name: say("right-position"),
		testid: "match-right",
		value: say("px-9", {
			right: right[0],
			right_2: right[1]
		}),
		help: say("where-the-match-lies-in")
	}, ...columns.filter(({ key }) => key !== "x" && key !== "y").map(({ key, label, unit, help, text }) => ({
		name: label,
		testid: `match-${key}`,
		value: withUnit(text(index), unit),
		help
	}))];
	return [h("h4", {}, say("match", { index: index + 1 })), facts(list)];
}
function candidateTable(state, match, { candidates }, select) {
	const points = state.results.pointsRight?.value.points;
	const total = candidates.length / 2;
	const leftIndex = leftIndexOf(state, match.best, match.rules);
	if (points === void 0 || leftIndex < 0 || total === 0) return [];
	const rows = Array.from({ length: Math.min(total, MOST_ROWS) }, (_, i) => {
		const index = candidates[2 * i] ?? 0;
		const go = h("button", {
			type: "button",
			class: "link",
			aria: { label: say("select-right-point", { index: index + 1 }) }
		}, count(index + 1));
		go.addEventListener("click", () => select("right", index));
		const cells = [points[3 * index], points[3 * index + 1]].map((v) => h("td", { class: "number" }, fixed(v, 1)));
		const [least = NaN, own = NaN] = [candidates[1], candidates[2 * i + 1]];
		return h("tr", { class: index === match.best[leftIndex] ? "best" : "" }, h("td", {}, String(i + 1)), h("td", {}, go), ...cells, h("td", { class: "number" }, fixed(own, 4)), h("td", { class: "number" }, i === 0 ? "" : fixed(least / own, 3)));
	});
	const measure = state.settings !== null && comparesGradients(state.settings) ? say("distance-2") : say("measure");
	const heads = [
		say("rank"),
		say("right-point"),
		`x ${unitText("px")}`,
		`y ${unitText("px")}`,
		measure
	].map((text) => h("th", { scope: "col" }, text));
	heads.push(h("th", {
		scope: "col",
		title: say("the-smallest-measure-divided-by")
	}, say("ratio-2")));
	const caption = say("of-left-point", {
		total,
		left_index: leftIndex + 1,
		what: total > MOST_ROWS ? say("the-best", { most_rows: MOST_ROWS }) : ""
	});
	return [
		h("h4", {}, caption),
		...isPredicted$1(match, leftIndex) ? [h("p", {
			class: "note",
			testid: "point-predicted"
		}, say("the-match-is-none-of-these"))] : [],
		h("div", { class: "scroll candidates" }, h("table", {
			testid: "point-candidates",
			aria: { label: caption }
		}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows)))
	];
}
// www/pair/panel/simulate.ts
var PREVIEW_SIDE = 240;
var DEBOUNCE_MS = 120;
var PRESETS = {
	sample: say("sample-the-built-in-pair"),
	paper: say("paper-its-geometry-and-angles"),
	hard: say("hard-high-relief-blur-noise"),
	lively: say("lively-river-traffic-grain-haze")
};
function mountSimulate(host, store, engine, render) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue !== null) whenQuiet(() => new SimulatePanel(host, store, engine, catalogue, render));
	});
}
var SimulatePanel = class {
	host;
	store;
	engine;
	catalogue;
	preset = h("select", {
		id: "flight-preset",
		testid: "flight-preset"
	});
	problem = h("p", {
		class: "field-problem",
		role: "alert",
		testid: "flight-problem"
	});
	pictures = [h("canvas", {
		class: "preview",
		testid: "preview-left"
	}), h("canvas", {
		class: "preview",
		testid: "preview-right"
	})];
	sections;
	timer;
	rendering = false;
	shown = null;
	constructor(host, store, engine, catalogue, render) {
		this.host = host;
		this.store = store;
		this.engine = engine;
		this.catalogue = catalogue;
		for (const { name } of catalogue.flights) this.preset.append(new Option(PRESETS[name] ?? name, name));
		this.preset.addEventListener("change", () => store.dispatch({
			type: "flight",
			flight: this.standard()
		}));
		this.sections = makeSections(catalogue.flightParameters, {
			change: (key, value) => {
				const { flight } = store.state;
				if (flight !== null) store.dispatch({
					type: "flight",
					flight: withSetting(flight, key, value)
				});
			},
			defaults: () => this.standard()
		});
		const go = button(say("render-this-pair"), "render-flight", () => {
			const { flight } = store.state;
			if (flight !== null) render(this.preset.value, flight);
		});
		go.className = "primary";
		const another = button(say("another-town"), "flight-reseed", () => {
			const { flight } = store.state;
			if (flight !== null) store.dispatch({
				type: "flight",
				flight: {
					...flight,
					seed: (flight.seed + 1) % 2 ** 32
				}
			});
		}, say("the-next-seed"));
		host.append(h("p", { class: "note" }, say("a-flight-over-a-synthetic")), h("div", { class: "control" }, h("label", { for: "flight-preset" }, say("preset")), this.preset), h("div", { class: "previews" }, ...this.pictures), this.problem, h("div", { class: "buttons" }, go, another), ...this.sections.elements);
		store.watch(["flight"], ([flight]) => {
			if (flight === null) return;
			this.sections.show(flight);
			this.later();
		});
		new IntersectionObserver(() => this.later()).observe(host);
	}
	standard() {
		const found = this.catalogue.flights.find(({ name }) => name === this.preset.value) ?? this.catalogue.flights[0];
		if (found === void 0) throw new Error("the program names no flight");
		return found.flight;
	}
	later() {
		window.clearTimeout(this.timer);
		this.timer = window.setTimeout(() => void this.preview(), DEBOUNCE_MS);
	}
	async preview() {
		const { flight } = this.store.state;
		if (this.rendering || flight === null || flight === this.shown || this.host.offsetParent === null) return;
		this.shown = flight;
		const problem = problemOfFlight(flight);
		this.tell(problem?.text ?? null);
		if (problem !== null) {
			this.sections.controls.find(({ parameter }) => parameter.key === problem.field)?.refuse(`${readable(this.catalogue, problem.text)}.`);
			return;
		}
		this.rendering = true;
		try {
			const { left, right } = await this.engine.client("preview").call("simulate", reduced(flight, this.catalogue));
			paint(this.pictures[0], left, say("preview-of-the-left-image"));
			paint(this.pictures[1], right, say("preview-of-the-right-image"));
		} catch (error) {
			if (error instanceof CallError) this.tell(say("no-preview", { message: error.message }));
			else if (!(error instanceof Cancelled)) throw error;
		} finally {
			this.rendering = false;
		}
		if (this.store.state.flight !== flight) this.later();
	}
	tell(problem) {
		this.problem.textContent = problem === null ? "" : `${readable(this.catalogue, problem)}.`;
	}
};
function reduced(flight, { flightParameters }) {
	const { pixel_mm: pixel, width_px: width, height_px: height } = flight;
	const range = (field) => {
		const parameter = flightParameters.find(({ key }) => key === `flight.${field}`);
		return parameter?.kind === "integer" || parameter?.kind === "real" ? parameter : {
			min: 1,
			max: Infinity
		};
	};
	const thinnest = Math.min(width / range("width_px").min, height / range("height_px").min);
	const factor = Math.max(1, Math.floor(Math.min(Math.ceil(Math.max(width, height) / PREVIEW_SIDE), range("pixel_mm").max / pixel, thinnest)));
	return {
		...flight,
		pixel_mm: pixel * factor,
		width_px: Math.floor(width / factor),
		height_px: Math.floor(height / factor)
	};
}
function paint(canvas, { width, height, grey }, words) {
	canvas.width = width;
	canvas.height = height;
	canvas.setAttribute("role", "img");
	canvas.setAttribute("aria-label", words);
	const pixels = new ImageData(width, height);
	grey.forEach((value, i) => {
		pixels.data.fill(value, 4 * i, 4 * i + 3);
		pixels.data[4 * i + 3] = 255;
	});
	canvas.getContext("2d")?.putImageData(pixels, 0, 0);
}
// www/pair/panel/statistics.ts
var KINDS = [
	["all", say("all-matches")],
	["used", say("used")],
	["rejected", say("gross-errors")],
	["by-hand", say("by-hand")],
	["wrong", say("wrong-by-the-truth")]
];
function mountStatistics(host, store, editing, select) {
	const kinds = h("select", {
		testid: "statistics-filter",
		aria: { label: say("matches-to-show") }
	});
	const all = button(say("choose-all"), "choose-listed", () => chooseListed(), say("choose-the-matches-that-the"));
	const filterBy = (filter) => store.dispatch({
		type: "filter",
		filter: {
			...store.state.filter,
			...filter
		}
	});
	kinds.addEventListener("change", () => filterBy({ kind: kinds.value }));
	const table = new Table(host, {
		testid: "statistics",
		words: {
			table: say("matches-2"),
			region: say("table-of-matches")
		},
		file: "pair-matches.csv",
		tools: [kinds, all],
		filter: (conditions) => filterBy({ conditions }),
		showAll: () => filterBy(ALL_MATCHES),
		choose: (match) => {
			const left = statistics?.lefts[match];
			editing.chooseNone();
			if (left !== void 0) select("left", left);
		},
		chooseMore: (rows) => editing.chooseLefts(leftsOf(rows)),
		isChosen: (match) => chosen.has(statistics?.lefts[match] ?? -1)
	});
	const sideways = sidewaysNote("statistics-sideways");
	table.scroller.before(sideways);
	watchSideways(sideways, table);
	let chosen = new Set();
	let statistics = null;
	let found = null;
	let filter = null;
	const leftsOf = (rows) => [...rows].flatMap((row) => statistics?.lefts[row] ?? []);
	const chooseListed = () => {
		editing.chooseNone();
		editing.chooseLefts(leftsOf(table.listed));
	};
	const show = (now, wanted) => {
		[statistics, filter] = [now, wanted];
		const offered = KINDS.filter(([kind]) => kind !== "wrong" || now?.rightness != null);
		if (kinds.options.length !== offered.length) fill(kinds, ...offered.map(([kind, text]) => new Option(text, kind)));
		const kind = kindOf(now, wanted);
		kinds.value = kind;
		const keeps = (match) => now !== null && isOf(now, kind, match);
		const shown = table.show(now?.count ?? 0, now === null ? [] : columnsOf(now), keeps, wanted.conditions);
		all.disabled = shown === 0;
	};
	const follow = () => {
		const { state } = store;
		table.scroller.classList.toggle("is-stale", isStale(state, "match") || shownPair(state).orientation !== null && isStale(state, "orientation"));
		const now = statistics !== null && isAwaited(state, found) ? statistics : statisticsOfState(state);
		const lefts = chosenLefts(state);
		const isOther = lefts.length !== chosen.size || !lefts.every((left) => chosen.has(left));
		if (isOther) chosen = new Set(lefts);
		if (now !== statistics || state.filter !== filter) {
			if (now !== statistics) found = shownPair(state).edited?.found ?? null;
			show(now, state.filter);
		} else if (isOther) table.redraw();
		table.mark(selectedMatch(state, statistics));
	};
	const seen = whenInSight(host, follow);
	store.watch([
		"selection",
		"chosen",
		"filter"
	], seen);
	store.watch([
		"results",
		"running",
		"history",
		"images",
		"settings",
		"camera",
		"photos",
		"offset",
		"fiducialModel",
		"failures"
	], afterFrame(seen));
}
function isAwaited(state, found) {
	const { edited } = shownPair(state);
	const { orientation, score } = state.running;
	return (orientation !== void 0 || score !== void 0) && edited !== null && edited.found === found;
}
function selectedMatch(state, statistics) {
	const { match } = shownPair(state);
	if (match === null || statistics === null || state.selection === null) return -1;
	return statistics.lefts.indexOf(leftIndexOf(state, match.best, match.rules));
}
// pkg/pair/camera-wanted.js
var GIVEN = [
	"no_camera",
	"no_focal_length",
	"no_pixel_size",
	"altered",
	"plane_without_camera",
	"unknown_camera",
	"resized_or_cropped",
	"cropped",
	"other_pixels"
];
var OTHER = [
	"focal_length",
	"wide_angle",
	"contradicted_focal",
	"doubtful_focal",
	"far_principal_point"
];
function cameraWanted(verdict) {
	if (verdict.kind === "oriented") return null;
	const { kind } = verdict.kind === "weak" ? verdict.warning : verdict.no_orientation;
	if (GIVEN.includes(kind)) return "given";
	return OTHER.includes(kind) ? "other" : null;
}
// www/pair/panel/answer.ts
function resting(state, waiting, actions) {
	const { images } = state;
	const line = (kind, text, next = null) => ({
		kind,
		text,
		verdict: null,
		next
	});
	if (state.catalogue === null) return line("busy", say("loading-the-program"));
	if (images.left === null && images.right === null) return line("idle", say("ready-open-two-overlapping-images"));
	const missing = SIDES.find((side) => images[side] === null);
	if (missing !== void 0) return line("idle", say("one-image-is-open-open", { missing }), {
		text: say("open-the-image", { missing }),
		act: () => actions.open(missing)
	});
	return waiting ? line("busy", say("waiting")) : answered(state, actions);
}
function answered(state, actions) {
	const milliseconds = Object.entries(state.results).reduce((sum, [stage, result]) => sum + (stage === "inspection" || stage === "line" || stage === "difference" ? 0 : result.milliseconds), 0);
	const matched = milliseconds === 0 ? `${summary(state)}.` : say("worked", {
		matched: summary(state),
		seconds: milliseconds / 1e3
	});
	const reason = whyNotOriented(state);
	const oriented = reason === null && isCurrent(state, "orientation") ? state.results.orientation?.value : void 0;
	const verdict = oriented?.verdict;
	const hint = hintFor(state, verdict);
	const more = `${matched}${hint === null ? "" : ` ${message("pair_hint", hint)}`}`;
	if (oriented === void 0 || verdict === void 0) {
		const next = hint === null ? nextWithout(state, actions) : {
			text: say("use-auto"),
			act: actions.otherStrategy
		};
		if (reason === null) return {
			kind: "partial",
			verdict: "not_oriented",
			text: more,
			next
		};
		return {
			kind: "partial",
			verdict: "not_oriented",
			text: reason,
			more,
			figures: figuresWithout(state),
			next
		};
	}
	const answer = {
		text: message("pair_verdict", verdict),
		more,
		figures: figuresOf(state, oriented)
	};
	if (verdict.kind === "oriented") return {
		...answer,
		kind: "done",
		verdict: "oriented",
		next: calibrated(state, actions) ?? nextAfter(state, actions)
	};
	const next = cameraWanted(verdict) !== null ? cameraNext(state, actions) : {
		text: say("show-why"),
		act: actions.why
	};
	return {
		...answer,
		kind: "partial",
		verdict: verdict.kind,
		next
	};
}
function hintFor(state, verdict) {
	const none = whyNone(state);
	const { value: difference } = isCurrent(state, "difference") && state.results.difference || { value: null };
	const { value: offset } = isCurrent(state, "offset") && state.results.offset || { value: null };
	const judged = verdict ?? (none === null ? null : {
		kind: "not_oriented",
		no_orientation: none
	});
	return state.settings === null || judged === null || isWithoutPoints(state) ? null : pair_hint(judged, state.settings, difference, offset);
}
function isWithoutPoints(state) {
	const { left, right } = shownPair(state);
	return left?.length === 0 || right?.length === 0;
}
function figuresOf(state, result) {
	const { used } = countsOf$1(result);
	const interior = interiorInUse(state)?.left;
	const half = result.half_widths_95?.kappa_deg;
	const digits = decimalsOfError(half, 2);
	return [
		{
			value: count(used),
			label: say("points-on-both-photos")
		},
		...interior === void 0 || result.sigma0_mm == null ? [] : [{
			value: say("px-2", { value: result.sigma0_mm / pixelMm(interior) }),
			label: say("sigma-of-image-observations")
		}],
		...half == null ? [] : [{
			value: `${fixed(result.kappa_deg, digits)}° ± ${fixed(half, digits)}°`,
			label: say("right-photo-turned")
		}]
	];
}
function figuresWithout(state) {
	const { match, left } = shownPair(state);
	if (match === null || left === null) return [];
	return [{
		value: count(match.counts.matches),
		label: say("points-on-both-photos")
	}, {
		value: count(left.length / 3),
		label: say("points-tried")
	}];
}
function nextWithout(state, actions) {
	const none = whyNone(state);
	const why = {
		text: say("show-why"),
		act: actions.why
	};
	if (none === null) return why;
	const { kind } = none;
	if (kind === "no_geometry" || kind === "too_few_matches" || kind === "parts_of_one_image") return {
		text: say("open-other-photos"),
		act: () => actions.open(null)
	};
	if (kind === "one_photo") return {
		text: say("replace-the-right-image"),
		act: () => actions.open("right")
	};
	return cameraWanted({
		kind: "not_oriented",
		no_orientation: none
	}) === null ? why : cameraNext(state, actions);
}
function calibrated(state, actions) {
	return offeredCalibration(state) === null ? null : {
		text: say("use-the-calibrated-camera"),
		act: actions.calibrated
	};
}
function cameraNext(state, actions) {
	return calibrated(state, actions) ?? {
		text: say("give-the-camera"),
		act: actions.camera
	};
}
function nextAfter({ images }, { open, save }) {
	return SIDES.some((side) => images[side]?.source.kind === "grey") ? {
		text: say("open-your-photos"),
		act: () => open(null)
	} : {
		text: say("save-the-project"),
		act: save
	};
}
// www/pair/panel/status.ts
var PATIENCE_MS$1 = 250;
function mountStatus(store, actions) {
	const show = answerCard(byId("answer"), byId("status"), byId("answer-actions"), "");
	const bar = byId("progress");
	const cancel = byId("cancel");
	declareLack([cancel], () => cancel.disabled || cancel.hidden ? say("nothing-is-running") : "");
	const run = byId("run");
	cancel.addEventListener("click", actions.cancel);
	run.addEventListener("click", actions.run);
	let timer;
	store.watch((s) => [s], ([state]) => {
		const busy = isBusy(state);
		const { wanted, done } = progress(state);
		bar.max = Math.max(1, wanted);
		bar.value = done;
		cancel.disabled = !busy;
		run.hidden = !(state.paused && (state.images.left !== null || state.images.right !== null)) && currentFailure(state)?.ended !== true;
		show(answerOf(state, actions));
		document.body.classList.toggle("is-pending", anyStale(state));
		if (!busy) {
			window.clearTimeout(timer);
			timer = void 0;
			bar.classList.remove("is-on");
		} else timer ??= window.setTimeout(() => bar.classList.add("is-on"), PATIENCE_MS$1);
	});
}
function answerOf(state, actions) {
	const notice = ofLine(state.notice);
	if (notice?.choices !== void 0) return question(notice.text, notice.choices, isBusy(state));
	if (notice?.kind !== "problem") return answerWith(state, notice, actions);
	const answer = answerWith(state, null, actions);
	return answer.kind === "idle" ? {
		...answer,
		kind: "problem",
		text: notice.text,
		more: ""
	} : {
		...answer,
		problem: notice.text
	};
}
function question(text, [next, ...others], busy) {
	return {
		kind: busy ? "busy" : "idle",
		verdict: null,
		text,
		next: next ?? null,
		others
	};
}
function answerWith(state, notice, actions) {
	const line = (kind, text) => ({
		kind,
		text,
		verdict: null
	});
	const failure = currentFailure(state);
	const { running, wanted, done } = progress(state);
	if (running.length > 0) return line("busy", say("step", {
		step: Math.min(done + 1, wanted),
		steps: wanted,
		stages: running.map((stage) => STAGES[stage].label).join("; ")
	}));
	if (notice?.kind === "busy") return line("busy", notice.text);
	if (state.paused) {
		const { openLeft, openRight } = state.results;
		const opened = openLeft === void 0 && openRight === void 0 ? "cancelled-the-images-stay" : "cancelled-results-on-the-screen";
		return {
			...line("idle", say(waitsForMarks(state) ? "the-images-wait-for-run" : opened)),
			more: notice?.text ?? ""
		};
	}
	if (failure !== null && !isOrientation(failure)) return line("problem", `${failure.message} ${matchedAllTheSame(state, failure.stage)}`.trimEnd());
	const [refused] = Object.values(state.refused);
	if (refused !== void 0) return line("problem", refusedText$1(refused));
	const answer = resting(state, done < wanted, actions);
	if (notice === null) return answer;
	if (notice.beside === true) return {
		...answer,
		said: notice.text
	};
	if (answer.verdict === null) return line("idle", notice.text);
	return {
		...answer,
		more: `${answer.more ?? ""} ${notice.text}`.trimStart()
	};
}
function waitsForMarks(state) {
	return !(isCurrent(state, "pointsLeft") || isCurrent(state, "pointsRight")) && (state.tool === "fiducials" || hasMarks(state));
}
function isOrientation({ stage, ended }) {
	return !ended && stage === "orientation";
}
function matchedAllTheSame(state, failed) {
	const matches = summary(state);
	return (failed === "interiorLeft" || failed === "interiorRight") && matches !== "" ? say("not-oriented-4", { matches }) : "";
}
// www/pair/view/frames.ts
var SCALES = 2;
var LEAST_RADIUS = 6;
var MOST_DRAWN = 250;
var LEAST_SCALE = 1;
function haveDirections(settings) {
	return settings !== null && comparesGradients(settings) && !settings.gradient.upright;
}
function drawFrames(context, state, shown, pane, transform, clip) {
	const { points, frames, codes } = pane;
	if (points === null || frames === null || frames.length === 0 || state.display.points === "none") return;
	if (state.display.points === "matched" && transform.scale < LEAST_SCALE) return;
	const ticks = haveDirections(state.settings);
	const paths = new Map();
	let drawn = 0;
	codes.forEach((code, i) => {
		const radius = SCALES * (frames[2 * i] ?? 0) * transform.scale;
		if (drawn > MOST_DRAWN || radius < LEAST_RADIUS || !isCodeShown(shown, code)) return;
		const [x, y] = toCanvas(transform, points[3 * i] ?? 0, points[3 * i + 1] ?? 0);
		if (x + radius < clip.left || x - radius > clip.left + clip.width || y + radius < clip.top || y - radius > clip.top + clip.height) return;
		drawn += 1;
		const path = paths.get(code) ?? new Path2D();
		paths.set(code, path);
		addFrame(path, [x, y], radius, ticks ? frames[2 * i + 1] ?? 0 : null);
	});
	if (drawn > MOST_DRAWN) return;
	context.lineWidth = 1;
	for (const [code, path] of paths) {
		context.strokeStyle = STYLES[code]?.colour ?? "#ffffff";
		context.stroke(path);
	}
}
function addFrame(path, [x, y], radius, direction) {
	path.moveTo(x + radius, y);
	path.arc(x, y, radius, 0, 2 * Math.PI);
	if (direction === null) return;
	path.moveTo(x, y);
	path.lineTo(x + radius * Math.cos(direction), y + radius * Math.sin(direction));
}
function drawSupport(context, settings, { points, frames, transform }, index) {
	if (index < 0) return;
	const [x, y] = points?.subarray(3 * index, 3 * index + 2) ?? [];
	const [scale, direction = 0] = frames?.subarray(2 * index, 2 * index + 2) ?? [];
	if (x === void 0 || y === void 0 || scale === void 0) return;
	const half = 2 * settings.gradient.cell * scale * transform.scale;
	context.save();
	context.translate(...toCanvas(transform, x, y));
	context.rotate(direction);
	context.lineWidth = 1.5;
	context.strokeStyle = SELECTED;
	context.strokeRect(-half, -half, 2 * half, 2 * half);
	context.beginPath();
	context.moveTo(0, 0);
	context.lineTo(half, 0);
	context.stroke();
	context.restore();
}
var ALL = 4294967295;
var NOT_DRAWN = 255;
function stylesAt(scale) {
	const half = halfSize(scale);
	const rows = DRAWN.map((code) => {
		const matched = OF_MATCHES.includes(code);
		return [
			STYLES[code]?.shape ?? 0,
			matched ? half : .75 * half,
			matched ? 1.6 : 1.2
		];
	});
	return {
		styles: Float64Array.from(rows.flat()),
		colours: DRAWN.map((code) => STYLES[code]?.colour ?? "#ffffff")
	};
}
function makeSlots() {
	return remember((codes, points, hidden) => {
		const slots = Uint8Array.from(STYLES, (_, code) => isCodeShown({
			points,
			hidden
		}, code) ? DRAWN.indexOf(code) : NOT_DRAWN);
		return codes.map((code) => slots[code] ?? NOT_DRAWN);
	});
}
var slotsOf = {
	left: makeSlots(),
	right: makeSlots()
};
var slotsOfPlaces = makeSlots();
function drawPoints(context, state, scene, pane, transform, clip) {
	const { points, hidden } = scene.shown;
	if (pane.points === null || points === "none") return;
	const { styles, colours } = stylesAt(transform.scale);
	const view = drawView(transform, clip);
	draw_points(context, pane.points, slotsOf[pane.side](pane.codes, points, hidden), styles, colours, view);
	drawFrames(context, state, scene.shown, pane, transform, clip);
	if (pane.side === "right") draw_points(context, scene.places.points, slotsOfPlaces(scene.places.codes, points, hidden), styles, colours, view);
}
function drawLines(context, state, scene) {
	const { lines } = state.display;
	if (scene.match === null || lines === "none") return;
	const { left, right } = scene.panes;
	const { shown } = scene;
	const rejected = isCodeShown({
		...shown,
		points: shown.points === "none" ? "matched" : shown.points
	}, GROSS_ERROR) ? 1 : NOT_DRAWN;
	const codes = scene.matchCodes.map((code) => code === 255 ? NOT_DRAWN : code === GROSS_ERROR ? rejected : 0);
	draw_match_lines(context, scene.match.matches, codes, Float64Array.of(1, 1), [LINE, LINE_REJECTED], drawView(left.transform, left.rect), drawView(right.transform, right.rect), lines === "all" ? ALL : 100);
}
function drawResiduals(context, state, scene, pane) {
	if (pane.vectors === null || state.display.vectors === 0) return;
	const codes = scene.matchCodes.map((code) => code === 255 ? NOT_DRAWN : code === GROSS_ERROR ? 1 : 0);
	draw_vectors(context, pane.vectors, codes, Float64Array.of(1.4, 1.4), [RESIDUAL, RESIDUAL_REJECTED], state.display.vectors, drawView(pane.transform, pane.rect));
}
function drawMarks(context, state, scene) {
	drawLines(context, state, scene);
	for (const side of SIDES) {
		const pane = scene.panes[side];
		within(context, pane.rect, () => {
			drawPoints(context, state, scene, pane, pane.transform, pane.rect);
			drawResiduals(context, state, scene, pane);
		});
	}
}
// www/pair/panel/toolbar.ts
function mountToolbar(host, store, navigator) {
	const set = (display) => store.dispatch({
		type: "display",
		display
	});
	const shows = (points) => set({
		points,
		hidden: []
	});
	const points = toggle(say("points"), "layer-points", say("show-the-matched-points"), (on) => shows(on ? "matched" : "none"));
	const unmatched = toggle(say("unmatched"), "layer-unmatched", say("show-rejected-points-too-marked"), (on) => shows(on ? "all" : "matched"));
	const [lines, lineSelect] = choice(say("lines"), "layer-lines", [
		["none", say("no-lines")],
		["some", `≤ ${String(100)}`],
		["all", say("all-lines")]
	], (value) => set({ lines: value }));
	const [vectors, vectorSelect] = vectorChoice("layer-vectors", (vectors) => set({ vectors }));
	const linked = toggle(say("linked"), "linked", say("pan-and-zoom-both-images"), (on) => set({ linked: on }));
	const magnifier = toggle(say("magnifier"), "magnifier", say("enlarge-what-is-under-the-pointer"), (on) => set({ magnifier: on }));
	const unfoldLight = labelled("◐", "view-light", say("brightness-and-contrast"), () => void 0);
	const unfold = h("button", {
		type: "button",
		class: "menu-button",
		testid: "view-menu"
	}, say("view"));
	const light = makeLight("view-", byId("view"), set, [[unfoldLight, say("brightness-and-contrast")], [unfold, say("view-2")]]);
	const sliders = h("div", {
		class: "menu",
		id: "view-light"
	}, ...light.elements);
	mountMenu(unfoldLight, sliders);
	const more = h("div", {
		class: "more",
		id: "view-more"
	}, lines, vectors, h("span", { class: "divider" }), linked, magnifier, labelled("1:1", "zoom-actual", say("n-1-1-one-image-pixel"), () => navigator.actualSize()), h("div", { class: "light" }, unfoldLight, sliders), h("span", { class: "divider" }), labelled("‹", "previous-point", say("previous-point-p"), () => navigator.step(-1)), labelled("›", "next-point", say("next-point-n"), () => navigator.step(1)));
	mountMenu(unfold, more);
	host.append(points, unmatched, h("span", { class: "divider" }), ...zoomButtons("", say("whole-images"), () => navigator), unfold, more);
	store.watch(["results"], () => {
		const { left, match } = shownPair(store.state);
		const others = match === null || left === null ? 0 : left.length / 3 - match.counts.matches;
		fill(unmatched, say("unmatched"), others === 0 ? null : h("span", { class: "number-of" }, ` (${count(others)})`));
	});
	store.watch(["display"], ([display]) => {
		points.setAttribute("aria-pressed", String(display.points !== "none"));
		unmatched.setAttribute("aria-pressed", String(display.points === "all"));
		lineSelect.value = display.lines;
		vectorSelect.value = String(display.vectors);
		linked.setAttribute("aria-pressed", String(display.linked));
		magnifier.setAttribute("aria-pressed", String(display.magnifier));
		light.show(display);
	});
}
// www/pair/state/editing.ts
var Editing = class {
	store;
	fitter;
	constructor(store, fitter) {
		this.store = store;
		this.fitter = fitter;
	}
	edit(kind) {
		const edit = editOfChoice(this.store.state, kind);
		if (edit !== null) this.store.dispatch({
			type: "edit",
			edit
		});
	}
	step(by) {
		const { draft } = this.store.state;
		if (draft !== null) {
			if (by < 0) this.withoutPlace(draft);
			return;
		}
		this.store.dispatch({
			type: "goto",
			done: this.store.state.history.done + by
		});
	}
	choose(selection) {
		const { state } = this.store;
		const edited = editedPair(state);
		if (edited === null || selection === null) return;
		const left = leftIndexOf({ selection }, edited.match.best, edited.match.rules);
		this.chooseAll(keysOfLefts(edited, left < 0 ? [] : [left]));
	}
	chooseLefts(lefts) {
		const edited = editedPair(this.store.state);
		if (edited !== null) this.chooseAll(keysOfLefts(edited, lefts));
	}
	chooseNone() {
		if (this.store.state.chosen.length > 0) this.store.dispatch({
			type: "choose",
			chosen: []
		});
	}
	toggle(tool) {
		const { state } = this.store;
		const next = state.tool === tool || editedPair(state) === null ? "look" : tool;
		if (next !== state.tool) this.store.dispatch({
			type: "tool",
			tool: next
		});
	}
	move() {
		const draft = moving(this.store.state);
		if (draft === null) return;
		this.store.dispatch({
			type: "tool",
			tool: "measure"
		});
		this.store.dispatch({
			type: "draft",
			draft
		});
	}
	place(side, at) {
		const { state } = this.store;
		const { draft } = state;
		this.store.dispatch({
			type: "draft",
			draft: draft === null ? begun(state, side, at) : placed(state, draft, side, at)
		});
	}
	nudge(dx, dy) {
		const { draft } = this.store.state;
		const at = draft === null ? null : placeOfDraft(this.store.state, draft.side);
		if (draft !== null && at !== null) this.place(draft.side, [at[0] + dx, at[1] + dy]);
	}
	exchange() {
		const { state } = this.store;
		const { draft } = state;
		if (draft === null) return;
		this.store.dispatch({
			type: "draft",
			draft: {
				...draft,
				side: otherSide(draft.side)
			}
		});
	}
	async fit() {
		const { state } = this.store;
		const { draft } = state;
		const [left, right] = [placeOfDraft(state, "left"), placeOfDraft(state, "right")];
		if (draft === null || left === null || right === null) return;
		const found = await this.fitter(left, right);
		const now = this.store.state.draft;
		if (now === null || now.of !== draft.of || now.places !== draft.places) return;
		if (found !== null) this.store.dispatch({
			type: "draft",
			draft: placed(state, placed(state, now, "left", left), "right", found)
		});
		const text = say("least-squares-matching-confirms-no");
		this.store.dispatch({
			type: "notice",
			notice: found === null ? {
				kind: "info",
				text
			} : null
		});
	}
	accept() {
		const edit = editOfDraft(this.store.state);
		if (edit === null || edit.kind !== "add" && edit.kind !== "move") return;
		this.store.dispatch({
			type: "edit",
			edit
		});
		this.store.dispatch(edit.kind === "add" ? {
			type: "draft",
			draft: null
		} : {
			type: "tool",
			tool: "look"
		});
		const edited = editedPair(this.store.state);
		const left = edited === null ? void 0 : leftsByTarget(edited).get(keyOfTarget(edit.kind === "add" ? edit.id : edit.of));
		if (left !== void 0) this.store.dispatch({
			type: "select",
			selection: {
				side: "left",
				index: left
			}
		});
	}
	leave() {
		const { tool, chosen, draft, outline } = this.store.state;
		if (draft !== null && draft.of === null) this.store.dispatch({
			type: "draft",
			draft: null
		});
		else if (outline !== null) this.store.dispatch({
			type: "outline",
			outline: null
		});
		else if (tool !== "look") this.store.dispatch({
			type: "tool",
			tool: "look"
		});
		else if (chosen.length > 0) this.chooseNone();
		else return false;
		return true;
	}
	withoutPlace(draft) {
		if (draft.of === null) this.store.dispatch({
			type: "draft",
			draft: withoutPlace(draft)
		});
		else this.leave();
	}
	chooseAll(keys) {
		if (keys.length > 0) this.store.dispatch({
			type: "choose",
			chosen: toggled(this.store.state.chosen, keys)
		});
	}
};
// www/pair/state/marking.ts
var LEAST_SIMILARITY = 2;
var LEAST_AFFINE = 3;
var FIELDS = [
	"col",
	"row",
	"x_mm",
	"y_mm"
];
var Marking = class {
	store;
	orienter;
	show;
	refusal = null;
	constructor(store, orienter, show) {
		this.store = store;
		this.orienter = orienter;
		this.show = show;
		store.watch(["photos", "fiducialModel"], () => {
			const { mark } = store.state;
			if (mark !== null) this.take(mark.side, mark.index);
		});
	}
	toggle(side) {
		const { tool, mark, images, photos } = this.store.state;
		const ends = tool === "fiducials" && mark?.side === side;
		this.store.dispatch({
			type: "tool",
			tool: ends || images[side] === null ? "look" : "fiducials"
		});
		if (ends || images[side] === null) return;
		const { fiducials } = photos[side];
		const first = fiducials.findIndex((one) => !isMeasured$1(one));
		this.goTo(side, first < 0 ? fiducials.length : first);
		this.store.dispatch({
			type: "activeSide",
			side
		});
	}
	place(side, at) {
		this.put(side, at, isMeasured$1(markInHand(this.store.state) ?? UNMEASURED) ? "moved" : "measured");
	}
	nudge(dx, dy) {
		const { mark, photos } = this.store.state;
		const at = mark === null ? null : placeOfMark(photos[mark.side], markInHand(this.store.state));
		if (mark !== null && at !== null) this.put(mark.side, [at[0] + dx, at[1] + dy], "nudged");
	}
	put(side, [x, y], deed) {
		const { mark, photos } = this.store.state;
		if (mark === null || mark.side !== side || this.refuses(side, [x, y])) return;
		const { fiducials, origin } = photos[side];
		const [left, top] = origin ?? [0, 0];
		const [col = NaN, row = NaN] = [x + left, y + top].map(roundedPx);
		this.change(side, deed, mark.index, {
			...fiducials[mark.index] ?? UNMEASURED,
			col,
			row
		});
	}
	refuses(side, at) {
		const { store, refusal } = this;
		const refused = !isOnImage(store.state, side, at);
		this.refusal = refused ? {
			kind: "info",
			text: say("mark-beside-the-picture")
		} : null;
		if (refused || refusal !== null && store.state.notice === refusal) store.dispatch({
			type: "notice",
			notice: this.refusal
		});
		return refused;
	}
	async go(by) {
		const { mark, photos } = this.store.state;
		if (mark === null) return;
		const { side, index } = mark;
		const last = photos[side].fiducials.length;
		await this.goTo(side, Math.min(last, Math.max(0, index + by)));
	}
	clear() {
		const { mark } = this.store.state;
		const cleared = markInHand(this.store.state);
		if (mark === null || cleared === void 0 || !isMeasured$1(cleared)) return;
		this.change(mark.side, "cleared", mark.index, {
			...cleared,
			col: NaN,
			row: NaN
		});
	}
	type(side, index, numbers) {
		const { fiducials } = this.store.state.photos[side];
		const now = fiducials[index];
		if (now === void 0 || FIELDS.every((field) => Object.is(numbers[field] ?? now[field], now[field]))) return;
		this.change(side, "typed", index, {
			...now,
			...numbers
		});
	}
	takeCoordinates(side) {
		const { photos } = this.store.state;
		const marks = photos[side].fiducials;
		const all = withCoordinatesOf(marks, photos[otherSide(side)].fiducials);
		if (all === null) return;
		const first = all.findIndex((mark, i) => mark !== marks[i]);
		this.set({
			side,
			deed: "coordinates",
			at: first,
			out: marks.slice(first),
			put: all.slice(first)
		});
	}
	add(side) {
		this.change(side, "added", this.store.state.photos[side].fiducials.length, UNMEASURED);
	}
	remove(side, index) {
		this.change(side, "removed", index);
	}
	removeAll(side) {
		const { fiducials } = this.store.state.photos[side];
		if (fiducials.length > 0) this.set({
			side,
			deed: "all_removed",
			at: 0,
			out: fiducials,
			put: []
		});
	}
	step(by) {
		const { tool, markSteps } = this.store.state;
		const { edits, done } = markSteps;
		const step = by === 0 ? void 0 : edits[by < 0 ? done + by : done + by - 1];
		if (step === void 0) return;
		this.store.dispatch({
			type: "marksAfter",
			done: done + by
		});
		if (tool !== "fiducials") return;
		const { side } = step;
		this.resume(side, Math.min(step.at, this.store.state.photos[side].fiducials.length));
		this.store.dispatch({
			type: "activeSide",
			side
		});
	}
	change(side, deed, at, ...put) {
		this.set({
			side,
			deed,
			at,
			out: this.store.state.photos[side].fiducials.slice(at, at + 1),
			put
		});
	}
	set(step) {
		const { tool, mark } = this.store.state;
		const { side, at } = step;
		this.store.dispatch({
			type: "marked",
			step
		});
		if (tool !== "fiducials" || mark?.side !== side || this.store.state.mark !== null) return;
		this.resume(side, Math.min(at, this.store.state.photos[side].fiducials.length));
	}
	resume(side, index) {
		if (this.store.state.tool !== "fiducials") this.store.dispatch({
			type: "tool",
			tool: "fiducials"
		});
		this.goTo(side, index);
	}
	async goTo(side, index) {
		const at = await this.take(side, index);
		if (at !== null) this.show(side, at);
	}
	async take(side, index) {
		this.store.dispatch({
			type: "mark",
			mark: {
				side,
				index,
				expected: null
			}
		});
		const photo = this.store.state.photos[side];
		const wanted = photo.fiducials[index];
		const at = placeOfMark(photo, wanted);
		const known = wholeMarks(photo);
		if (at !== null || wanted === void 0 || known.length < LEAST_SIMILARITY) return at;
		const model = known.length < LEAST_AFFINE ? "similarity" : this.store.state.fiducialModel;
		const found = await this.orienter(known, model);
		const expected = found === null ? null : positionOf(photo, found, wanted);
		const { mark, photos } = this.store.state;
		if (expected === null || photos[side] !== photo || mark?.side !== side || mark.index !== index) return null;
		this.store.dispatch({
			type: "mark",
			mark: {
				side,
				index,
				expected
			}
		});
		return expected;
	}
};
function positionOf({ origin }, { parameters }, { x_mm, y_mm }) {
	const [[a, b, tx], [d, e, ty]] = parameters;
	const [u, v, determinant] = [
		x_mm - tx,
		y_mm - ty,
		a * e - b * d
	];
	const [left, top] = origin ?? [0, 0];
	const at = [(e * u - b * v) / determinant - left, (a * v - d * u) / determinant - top];
	return at.every(Number.isFinite) ? at : null;
}
// www/pair/state/masking.ts
var LEAST_CORNERS = 3;
var Masking = class {
	store;
	painter;
	former = null;
	isTraced = false;
	isTracing = false;
	painting = Promise.resolve();
	going = null;
	sources = new WeakMap();
	constructor(store, painter) {
		this.store = store;
		this.painter = painter;
	}
	can() {
		return Object.values(this.store.state.images).some((image) => image !== null && image.source.kind !== "project");
	}
	toggle() {
		const next = this.store.state.tool === "mask" || !this.can() ? "look" : "mask";
		this.store.dispatch({
			type: "tool",
			tool: next
		});
	}
	place(side, at) {
		const { outline } = this.store.state;
		const before = outline?.side === side ? outline.corners : [];
		this.isTraced = false;
		this.store.dispatch({
			type: "outline",
			outline: {
				side,
				corners: [...before, at]
			}
		});
	}
	trace(side, corners, ended) {
		if (!this.isTracing) this.former = this.store.state.outline;
		this.isTracing = !ended;
		this.isTraced = true;
		this.store.dispatch({
			type: "outline",
			outline: {
				side,
				corners
			}
		});
	}
	giveUp() {
		if (!this.isTracing) return;
		this.isTracing = false;
		this.isTraced = false;
		this.store.dispatch({
			type: "outline",
			outline: this.former
		});
	}
	back() {
		const { outline } = this.store.state;
		if (outline === null) return;
		const corners = this.isTraced ? [] : outline.corners.slice(0, -1);
		this.store.dispatch({
			type: "outline",
			outline: corners.length === 0 ? null : {
				...outline,
				corners
			}
		});
	}
	isArea() {
		return (this.store.state.outline?.corners.length ?? 0) >= LEAST_CORNERS;
	}
	paint(masked) {
		const { outline, images } = this.store.state;
		const image = outline === null ? null : images[outline.side];
		if (outline === null || image === null || !this.isArea()) return Promise.resolve();
		this.store.dispatch({
			type: "outline",
			outline: null
		});
		this.going = null;
		return this.next(() => this.painted(image.id, {
			corners: outline.corners,
			masked
		}));
	}
	step(by) {
		if (this.store.state.outline !== null) {
			if (by < 0) this.back();
			return Promise.resolve();
		}
		if (this.going !== null) {
			this.going.by += by;
			return this.painting;
		}
		const going = { by };
		this.going = going;
		return this.next(() => {
			if (this.going === going) this.going = null;
			return this.went(going.by);
		});
	}
	goTo(done) {
		this.going = null;
		return this.next(() => this.went(done - this.store.state.maskSteps.done));
	}
	next(job) {
		this.painting = this.painting.catch(() => {}).then(job);
		return this.painting;
	}
	async went(by) {
		const { state } = this.store;
		const steps = wentTo(state.maskSteps, state.maskSteps.done + by);
		const masks = { ...state.masks };
		for (const side of SIDES) {
			const made = await this.made(state, side, steps);
			if (made === "cancelled") return;
			masks[side] = made;
		}
		const { masks: now, maskSteps, images } = this.store.state;
		if (now === state.masks && maskSteps === state.maskSteps && images === state.images) this.store.dispatch({
			type: "masksAfter",
			done: steps.done,
			masks
		});
	}
	async made(state, side, steps) {
		const given = state.givenMasks[side];
		const then = compositionOf(given, steps, side);
		const more = areasAfter(compositionOf(given, state.maskSteps, side), then);
		const present = state.masks[side];
		if (more?.length === 0) return present;
		if (then.file === null && then.areas.length === 0) return null;
		const mask = await (more === null ? this.painter(state, side, then.file, then.areas) : this.painter(state, side, present?.grey ?? null, more));
		if (mask === null) return "cancelled";
		const last = steps.edits.slice(0, steps.done).findLast((step) => step.side === side);
		const source = (last && this.sources.get(last)) ?? mask.source;
		if (last !== void 0) this.sources.set(last, source);
		return {
			...mask,
			source
		};
	}
	async painted(imageId, area) {
		const { corners } = area;
		const { state } = this.store;
		const side = sideOf(this.store.state, imageId);
		if (side === void 0) return;
		const before = state.masks[side];
		const tell = (kind, text) => this.store.dispatch({
			type: "notice",
			notice: {
				kind,
				text
			}
		});
		if (before?.source.kind === "project") {
			tell("problem", say("the-mask-is-not-here", { name: before.name }));
			this.outlinedAgain(imageId, corners);
			return;
		}
		let mask = null;
		try {
			mask = await this.painter(state, side, before?.grey ?? null, [area]);
		} finally {
			if (mask === null) this.outlinedAgain(imageId, corners);
		}
		const now = sideOf(this.store.state, imageId);
		if (mask === null || now === void 0 || this.store.state.masks[now] !== before) {
			tell("info", say("no-area-was-painted"));
			this.outlinedAgain(imageId, corners);
			return;
		}
		const step = {
			side: now,
			...area
		};
		this.sources.set(step, mask.source);
		this.store.dispatch({
			type: "painted",
			step,
			mask
		});
		tell("info", say("masks-of-the-image", {
			name: mask.name,
			left_out: 100 * mask.leftOut,
			side: now
		}));
	}
	outlinedAgain(imageId, corners) {
		const side = sideOf(this.store.state, imageId);
		const { outline, tool } = this.store.state;
		if (side !== void 0 && outline === null && tool === "mask") this.store.dispatch({
			type: "outline",
			outline: {
				side,
				corners
			}
		});
	}
};
function sideOf({ images: { left, right } }, imageId) {
	return left?.id === imageId ? "left" : right?.id === imageId ? "right" : void 0;
}
// www/pair/state/of-sides.ts
function withoutSides({ edits, done }, sides) {
	const stays = ({ side }) => !sides.includes(side);
	const all = edits.filter(stays);
	return all.length === 0 ? NO_HISTORY : {
		edits: all,
		done: edits.slice(0, done).filter(stays).length
	};
}
function exchangedSides({ edits, done }) {
	return {
		edits: edits.map((step) => ({
			...step,
			side: otherSide(step.side)
		})),
		done
	};
}
// www/pair/state/reducer.ts
var NO_DATA = {
	fiducials: [],
	origin: null
};
var DEEDS = new Set([
	"images",
	"simulated",
	"opened",
	"restored",
	"cleared",
	"found",
	"flight",
	"swap",
	"settings",
	"camera",
	"photo",
	"marked",
	"marksAfter",
	"mask",
	"painted",
	"masksAfter",
	"fiducialModel",
	"offset",
	"display",
	"resume",
	"edit",
	"goto"
]);
function reduce(state, action) {
	const next = withTool(withShown(state, changed(state, action)), action);
	return DEEDS.has(action.type) && next.notice !== null && next.notice.kind !== "busy" ? {
		...next,
		notice: null
	} : next;
}
function withTool(next, action) {
	return next.tool === "fiducials" && next.mark === null && action.type !== "tool" ? {
		...next,
		tool: "look"
	} : next;
}
function markAmong({ mark, photos }, next) {
	if (mark === null) return null;
	const [before, now] = [photos, next].map((of) => of[mark.side].fiducials.length);
	return now < before || mark.index > now ? null : mark;
}
function withMarks(state, marked) {
	return {
		...state,
		...marked,
		mark: markAmong(state, marked.photos),
		paused: state.paused && state.tool === "fiducials"
	};
}
function withShown(state, next) {
	const shown = TYPED_PARTS.filter((part) => part in next.refused && next[part] !== state[part]);
	return shown.length === 0 ? next : {
		...next,
		refused: shown.reduce(without, next.refused)
	};
}
function changed(state, action) {
	switch (action.type) {
		case "ready": return {
			...state,
			catalogue: action.catalogue,
			settings: action.catalogue.defaults,
			flight: action.catalogue.flights[0]?.flight ?? null
		};
		case "images": return {
			...withImages(state, action.images, action.same),
			paused: action.waits === true
		};
		case "simulated": return withSimulated(state, action);
		case "opened": return withProject(state, action.opened);
		case "restored": return withKept(state, action.restored);
		case "cleared": return state.catalogue === null ? state : changed(INITIAL, {
			type: "ready",
			catalogue: state.catalogue
		});
		case "found": return withFiles(state, action.images);
		case "flight": return {
			...state,
			flight: action.flight
		};
		case "swap": return swapped(state);
		case "settings": return {
			...state,
			settings: action.settings,
			paused: false
		};
		case "refused": return {
			...state,
			refused: action.label === null ? without(state.refused, action.part) : {
				...state.refused,
				[action.part]: action.label
			}
		};
		case "camera": return {
			...state,
			camera: action.camera,
			paused: false
		};
		case "photo": return withMarks(state, {
			photos: {
				...state.photos,
				[action.side]: {
					...state.photos[action.side],
					...action.photo
				}
			},
			markSteps: action.photo.fiducials === void 0 ? state.markSteps : withoutSides(state.markSteps, [action.side])
		});
		case "marked": return withMarks(state, withMarkStep(state, action.step));
		case "marksAfter": return withMarks(state, withMarkStepsDone(state, action.done));
		case "wait": return {
			...state,
			paused: true
		};
		case "mask": return {
			...state,
			...withGivenMask(state, action.side, action.mask),
			paused: false
		};
		case "painted": return {
			...state,
			masks: {
				...state.masks,
				[action.step.side]: action.mask
			},
			maskSteps: recorded(state.maskSteps, action.step),
			paused: false
		};
		case "masksAfter": return {
			...state,
			masks: action.masks,
			maskSteps: wentTo(state.maskSteps, action.done),
			paused: false
		};
		case "fiducialModel": return {
			...state,
			fiducialModel: action.model,
			paused: false
		};
		case "offset": return {
			...state,
			offset: action.offset,
			paused: false
		};
		case "select": return {
			...state,
			selection: action.selection,
			activeSide: action.selection?.side ?? state.activeSide
		};
		case "edit": return withHistory(state, recorded(state.history, action.edit));
		case "goto": return withHistory(state, wentTo(state.history, action.done));
		case "choose": return {
			...state,
			chosen: action.chosen
		};
		case "filter": return {
			...state,
			filter: action.filter
		};
		case "tool": return {
			...state,
			tool: action.tool,
			draft: null,
			outline: null,
			mark: null
		};
		case "draft": return {
			...state,
			draft: action.draft
		};
		case "mark": return {
			...state,
			mark: action.mark
		};
		case "outline": return {
			...state,
			outline: action.outline
		};
		case "activeSide": return {
			...state,
			activeSide: action.side
		};
		case "views": return {
			...state,
			views: {
				...state.views,
				...action.views
			}
		};
		case "display": return {
			...state,
			display: {
				...state.display,
				...action.display
			}
		};
		case "notice": return {
			...state,
			notice: action.notice
		};
		default: return withRun(state, action);
	}
}
function withRun(state, action) {
	switch (action.type) {
		case "stageStarted": return {
			...state,
			running: {
				...state.running,
				[action.stage]: action.key
			}
		};
		case "stageDone": return withKeptEdits(action.stage, {
			...state,
			running: without(state.running, action.stage),
			failures: without(state.failures, action.stage),
			results: {
				...state.results,
				[action.stage]: action.result
			},
			selection: action.stage === (state.selection?.side === "left" ? "pointsLeft" : "pointsRight") ? null : state.selection
		});
		case "stageFailed": return {
			...state,
			running: without(state.running, action.stage),
			failures: {
				...state.failures,
				[action.stage]: action.failure
			}
		};
		case "stageStopped": return {
			...state,
			running: without(state.running, action.stage)
		};
		case "cancelled": return {
			...state,
			running: {},
			paused: state.paused || Object.keys(state.running).length > 0
		};
		case "resume": return {
			...state,
			paused: false,
			failures: {}
		};
	}
}
function without(object, key) {
	if (!(key in object)) return object;
	const copy = { ...object };
	delete copy[key];
	return copy;
}
function withKeptEdits(stage, state) {
	const edited = stage === "match" ? editedPair(state) : null;
	const text = edited === null ? null : keptText(edited);
	return text === null || state.notice?.kind === "problem" ? state : {
		...state,
		notice: {
			kind: "info",
			text
		}
	};
}
function withHistory(state, history) {
	if (history.done === state.history.done && history.edits === state.history.edits) return state;
	const { orientation } = state.results;
	const before = isCurrent(state, "orientation") && orientation !== void 0 ? {
		run: runKey(state),
		orientation: orientation.value
	} : state.before;
	return {
		...state,
		history,
		before,
		paused: false
	};
}
function withImages(state, images, same = []) {
	const before = state.truth === null ? state : withoutTruth(state);
	const all = {
		...before.images,
		...images
	};
	const unmarked = SIDES.filter((side) => replaced(before, images, side) && !same.includes(side));
	const unmasked = SIDES.filter((side) => images[side] !== void 0);
	const without = (of, sides, none) => bothSides((side) => sides.includes(side) ? none : of[side]);
	return {
		...before,
		images: all,
		photos: without(before.photos, unmarked, NO_DATA),
		masks: without(before.masks, unmasked, null),
		givenMasks: without(before.givenMasks, unmasked, null),
		selection: null,
		paused: false,
		failures: {},
		views: {
			left: null,
			right: null
		},
		...UNEDITED,
		maskSteps: withoutSides(before.maskSteps, unmasked),
		markSteps: withoutSides(before.markSteps, unmarked),
		...exchangedPair(state, all)
	};
}
function replaced({ images }, given, side) {
	return images[side] !== null && given[side] !== void 0;
}
function withoutTruth(state) {
	return {
		...state,
		settings: withBase(state, state.catalogue?.defaults.orientation.base_mm ?? null),
		truth: null,
		camera: null,
		photos: {
			left: NO_DATA,
			right: NO_DATA
		},
		markSteps: NO_HISTORY,
		offset: null
	};
}
function withBase({ settings }, base) {
	return settings === null ? null : {
		...settings,
		orientation: {
			...settings.orientation,
			base_mm: base
		}
	};
}
function withSimulated(state, { left, right, pair }) {
	const given = withImages({
		...state,
		truth: null
	}, {
		left,
		right
	});
	return {
		...given,
		settings: withBase(given, pair.base_mm === 0 ? null : pair.base_mm),
		camera: pair.camera,
		photos: {
			left: {
				fiducials: pair.left_fiducials,
				origin: pair.left_origin
			},
			right: {
				fiducials: pair.right_fiducials,
				origin: pair.right_origin
			}
		},
		markSteps: NO_HISTORY,
		offset: null,
		truth: {
			leftId: left.id,
			rightId: right.id,
			orientation: pair.truth,
			baseMm: pair.base_mm,
			rightPosition: pair.right_position,
			leftWidth: pair.left.width,
			leftHeight: pair.left.height
		}
	};
}
function swapped(state) {
	const results = { ...state.results };
	exchange(results, "openLeft", "openRight");
	exchange(results, "pointsLeft", "pointsRight");
	exchange(results, "descriptorsLeft", "descriptorsRight");
	return {
		...state,
		results,
		images: {
			left: state.images.right,
			right: state.images.left
		},
		photos: {
			left: state.photos.right,
			right: state.photos.left
		},
		masks: {
			left: state.masks.right,
			right: state.masks.left
		},
		givenMasks: {
			left: state.givenMasks.right,
			right: state.givenMasks.left
		},
		offset: state.offset === null ? null : [-state.offset[0], -state.offset[1]],
		views: {
			left: state.views.right,
			right: state.views.left
		},
		...UNEDITED,
		history: exchanged(state.history),
		maskSteps: exchangedSides(state.maskSteps),
		markSteps: exchangedSides(state.markSteps),
		...measuredOn(state.draft === null ? null : exchangedDraft(state.draft), state.tool),
		selection: null,
		failures: {},
		paused: false
	};
}
function exchange(results, a, b) {
	const kept = results[a];
	results[a] = results[b];
	results[b] = kept;
}
// www/pair/state/store.ts
var Store = class extends Holder {
	constructor() {
		super(INITIAL, reduce);
	}
};
// www/pair/view/scene.ts
function pictureOf(state, side) {
	const stage = side === "left" ? "openLeft" : "openRight";
	const image = state.images[side];
	const opened = state.results[stage];
	if (image === null || opened === void 0 || opened.key !== wantedKeys(state)[stage]) return null;
	const { info, overview } = opened.value;
	return {
		imageId: image.id,
		width: info.width,
		height: info.height,
		overview
	};
}
var listed = {
	left: makeListed(),
	right: makeListed(),
	matches: makeListed()
};
function marksOf(state) {
	const { left, right, match, orientation } = shownPair(state);
	const interior = state.display.vectors === 0 ? null : interiorInUse(state);
	const vectors = (side) => match === null || orientation === null || interior === null ? null : residualVectors[side](match, orientation, interior[side]);
	const ofMatches = matchCodes(match, orientation);
	const out = leftOut(state);
	return {
		points: {
			left,
			right
		},
		codes: {
			left: listed.left(leftCodes(left, match, orientation), out?.left ?? null),
			right: listed.right(rightCodes(right, match, orientation), out?.right ?? null)
		},
		match,
		matchCodes: listed.matches(ofMatches, out?.matches ?? null),
		places: listedPlaces(loosePlaces(match, ofMatches), out),
		vectors: {
			left: vectors("left"),
			right: vectors("right")
		},
		shown: out === null ? state.display : withListed(state.display)
	};
}
function sceneOf(state, width, height) {
	const rects = panesOf(state, width, height);
	const marks = marksOf(state);
	const pane = (side) => {
		const picture = pictureOf(state, side);
		const own = state.views[side];
		const whole = picture === null ? {
			x: 0,
			y: 0,
			scale: 1
		} : fitView(rects[side], picture.width, picture.height);
		const view = own === null ? whole : inPane(own, rects[side]);
		return {
			side,
			rect: rects[side],
			transform: transformOf(rects[side], view),
			picture,
			points: picture === null ? null : marks.points[side],
			frames: state.results[side === "left" ? "pointsLeft" : "pointsRight"]?.value.frames ?? null,
			codes: marks.codes[side],
			vectors: marks.vectors[side]
		};
	};
	const { match, matchCodes: ofMatches, places, shown } = marks;
	return {
		panes: {
			left: pane("left"),
			right: pane("right")
		},
		match,
		matchCodes: ofMatches,
		places,
		shown
	};
}
function paneAt(scene, x, y) {
	const side = SIDES.find((s) => contains(scene.panes[s].rect, x, y));
	return side === void 0 ? null : scene.panes[side];
}
var middleOf = ({ rect, transform }) => toPosition(transform, rect.left + rect.width / 2, rect.top + rect.height / 2);
// www/pair/view/input.ts
function mountInput(view, store, navigator, { editing, masking, marking, paint }) {
	const { host } = view;
	const activate = (side) => {
		if (store.state.activeSide !== side) store.dispatch({
			type: "activeSide",
			side
		});
	};
	const look = declare({
		where: say("pictures-of-a-pair"),
		host,
		list: pictureKeys(view, store, navigator, editing, masking)
	});
	const measuring = declare({
		where: say("pictures-of-a-pair-while"),
		host,
		list: measuringKeys(store, navigator, editing),
		lacks: say("nothing-is-measured")
	});
	const masks = declare({
		where: say("pictures-of-a-pair-while-masking"),
		host,
		list: maskingKeys(store, navigator, masking, paint),
		lacks: say("nothing-is-outlined")
	});
	const marks = declare({
		where: say("pictures-of-a-pair-while-marking"),
		host,
		list: markingKeys(store, navigator, marking),
		lacks: say("nothing-is-measured")
	});
	listen(host, {
		at: (x, y) => {
			const pane = paneAt(view.scene(), x, y);
			return pane?.picture == null ? null : pane.side;
		},
		focused: () => store.state.activeSide,
		pan: (side, dx, dy) => navigator.pan(side, dx, dy),
		zoom: (side, factor, x, y) => navigator.zoom(side, factor, x, y),
		zoomMiddle: (factor) => navigator.zoomMiddle(factor),
		fit: () => navigator.fit(),
		grabbed: activate,
		pressed: (x, y, more) => {
			if (store.state.tool === "measure") measure(view, x, y, editing, navigator);
			else if (store.state.tool === "mask") corner(view, x, y, masking);
			else if (store.state.tool === "fiducials") mark(view, x, y, marking);
			else press(view.hit(x, y), more, editing, navigator);
		},
		encloses: (shift) => shift || store.state.tool === "choose" || store.state.tool === "mask",
		enclosed: (side, from, to, ended, path) => {
			if (store.state.tool === "mask") outline(view, side, path, ended, masking);
			else enclose(view, store, side, from, to, ended);
		},
		pointed: (at) => view.point(at),
		command: (key, shift) => measuring(key, shift) || masks(key, shift) || marks(key, shift) || look(key, shift)
	}, host.closest(".stage") ?? host);
}
function press(hit, more, editing, navigator) {
	if (more) {
		editing.choose(hit);
		return;
	}
	editing.chooseNone();
	navigator.select(hit);
}
function enclose(view, store, side, from, to, ended) {
	const rect = to === null ? null : between(from, to);
	view.enclose(ended ? null : rect);
	const edited = editedPair(store.state);
	if (!ended || rect === null || edited === null) return;
	const { panes, shown } = view.scene();
	const { transform } = panes[side];
	const [left, top] = toPosition(transform, rect.left, rect.top);
	const [right, bottom] = toPosition(transform, rect.left + rect.width, rect.top + rect.height);
	const { codes } = panes.left;
	store.dispatch({
		type: "choose",
		chosen: keysWithin(edited, side, [
			left,
			top,
			right,
			bottom
		], (index) => isCodeShown(shown, codes[index] ?? 0))
	});
}
function between([x, y], [u, v]) {
	return {
		left: Math.min(x, u),
		top: Math.min(y, v),
		width: Math.abs(u - x),
		height: Math.abs(v - y)
	};
}
function measure(view, x, y, editing, navigator) {
	const pane = paneAt(view.scene(), x, y);
	if (pane?.picture == null) return;
	editing.place(pane.side, toPosition(pane.transform, x, y));
	navigator.followDraft();
}
function corner(view, x, y, masking) {
	const pane = paneAt(view.scene(), x, y);
	if (pane?.picture != null) masking.place(pane.side, toPosition(pane.transform, x, y));
}
function outline(view, side, path, ended, masking) {
	const { transform } = view.scene().panes[side];
	const corners = path.map(([x, y]) => toPosition(transform, x, y));
	if (corners.length === 0) masking.giveUp();
	else masking.trace(side, corners, ended);
}
function mark(view, x, y, marking) {
	const pane = paneAt(view.scene(), x, y);
	if (pane?.picture != null) marking.place(pane.side, toPosition(pane.transform, x, y));
}
function markingKeys(store, navigator, marking) {
	const marks = () => store.state.tool === "fiducials" && store.state.mark !== null;
	const isMeasured = () => marks() && placeOfMark(store.state.photos[store.state.mark?.side ?? "left"], markInHand(store.state)) !== null;
	const nudge = (key, dx, dy) => ({
		keys: [key],
		does: say("moves-the-mark-by"),
		can: isMeasured,
		run: (shift) => marking.nudge((shift ? COARSE : FINE) * dx, (shift ? COARSE : FINE) * dy)
	});
	const middle = () => {
		const at = navigator.middle(store.state.mark?.side);
		if (at !== null) marking.place(...at);
	};
	return [
		nudge("ArrowLeft", -1, 0),
		nudge("ArrowRight", 1, 0),
		nudge("ArrowUp", 0, -1),
		nudge("ArrowDown", 0, 1),
		{
			keys: ["Enter"],
			does: say("goes-to-the-next-mark"),
			can: isMeasured,
			run: () => void marking.go(1)
		},
		{
			keys: ["Enter"],
			does: say("measures-the-mark-in-the-middle"),
			can: marks,
			run: middle
		},
		{
			keys: ["n"],
			does: say("goes-to-the-next-mark"),
			can: marks,
			run: () => void marking.go(1)
		},
		{
			keys: ["p"],
			does: say("goes-to-the-mark-before"),
			can: marks,
			run: () => void marking.go(-1)
		},
		{
			keys: ["Backspace", "Delete"],
			does: say("takes-the-mark-back"),
			can: marks,
			run: () => marking.clear()
		}
	];
}
function maskingKeys(store, navigator, masking, paint) {
	const masks = () => store.state.tool === "mask";
	const encloses = () => masks() && masking.isArea();
	const place = () => {
		const middle = navigator.middle();
		if (middle !== null) masking.place(...middle);
	};
	return [
		{
			keys: ["Enter"],
			does: say("places-a-corner-in-the-middle"),
			can: masks,
			run: place
		},
		{
			keys: ["Backspace", "Delete"],
			does: say("takes-the-last-corner-back"),
			can: masks,
			run: () => masking.back()
		},
		{
			keys: ["k"],
			does: say("masks-the-outlined-area"),
			can: encloses,
			run: () => paint(true)
		},
		{
			keys: ["u"],
			does: say("unmasks-the-outlined-area"),
			can: encloses,
			run: () => paint(false)
		}
	];
}
var FINE = .1;
var COARSE = 1;
function measuringKeys(store, navigator, editing) {
	const measures = () => store.state.tool === "measure";
	const drafts = () => measures() && store.state.draft !== null;
	const nudge = (key, dx, dy) => ({
		keys: [key],
		does: say("moves-the-measured-point-by"),
		can: drafts,
		run: (shift) => {
			const step = shift ? COARSE : FINE;
			editing.nudge(step * dx, step * dy);
			navigator.followDraft();
		}
	});
	const begin = () => {
		const middle = navigator.middle();
		if (middle === null) return;
		editing.place(...middle);
		navigator.followDraft();
	};
	const exchange = () => {
		editing.exchange();
		navigator.followDraft();
	};
	return [
		{
			keys: ["Enter"],
			does: say("takes-the-middle-of-the-picture"),
			can: () => measures() && !drafts() && navigator.middle() !== null,
			run: begin
		},
		nudge("ArrowLeft", -1, 0),
		nudge("ArrowRight", 1, 0),
		nudge("ArrowUp", 0, -1),
		nudge("ArrowDown", 0, 1),
		{
			keys: ["Enter"],
			does: say("accepts-the-measured-match"),
			can: drafts,
			run: () => editing.accept()
		},
		{
			keys: ["o"],
			does: say("goes-to-the-point-in"),
			can: drafts,
			run: exchange
		},
		{
			keys: ["f"],
			does: say("fits-the-point-by-least"),
			can: drafts,
			run: () => void editing.fit()
		}
	];
}
function pictureKeys(view, store, navigator, editing, masking) {
	const show = (display) => store.dispatch({
		type: "display",
		display
	});
	const measures = (begins) => () => {
		begins();
		navigator.followDraft();
		if (store.state.tool === "measure") view.takeKeys();
	};
	const isBegun = () => lackOfBegun(store.state) === "";
	const leave = () => {
		if (!editing.leave()) navigator.select(null);
	};
	return [
		{
			keys: ["n"],
			does: say("selects-the-next-point"),
			run: () => navigator.step(1)
		},
		{
			keys: ["p"],
			does: say("selects-the-previous-point"),
			run: () => navigator.step(-1)
		},
		{
			keys: ["1"],
			does: say("shows-one-image-pixel-as"),
			run: () => navigator.actualSize()
		},
		{
			keys: ["o"],
			does: say("goes-to-the-other-picture"),
			run: () => store.dispatch({
				type: "activeSide",
				side: otherSide(store.state.activeSide)
			})
		},
		{
			keys: ["l"],
			does: say("links-both-pictures-or-no"),
			run: () => show({ linked: !store.state.display.linked })
		},
		{
			keys: ["m"],
			does: say("shows-the-magnifier-or-no"),
			run: () => show({ magnifier: !store.state.display.magnifier })
		},
		{
			keys: ["x"],
			does: say("chooses-the-selected-match-beside"),
			lacks: () => lackOfSelected(store.state),
			run: () => editing.choose(store.state.selection)
		},
		{
			keys: ["s"],
			does: say("chooses-matches-by-rectangles"),
			run: () => editing.toggle("choose")
		},
		{
			keys: ["Delete", "Backspace"],
			does: say("rejects-the-chosen-matches"),
			lacks: () => lackOfEdit(store.state, "reject"),
			run: () => editing.edit("reject")
		},
		{
			keys: ["r"],
			does: say("restores-the-chosen-matches"),
			lacks: () => lackOfEdit(store.state, "restore"),
			run: () => editing.edit("restore")
		},
		{
			keys: ["a"],
			does: say("adds-a-match-by-measuring"),
			run: measures(() => editing.toggle("measure"))
		},
		{
			keys: ["w"],
			does: say("outlines-areas-to-be-masked"),
			run: () => masking.toggle()
		},
		{
			keys: ["e"],
			does: say("measures-the-selected-match-anew"),
			lacks: () => lackOfSelected(store.state),
			run: measures(() => editing.move())
		},
		{
			keys: ["Escape"],
			does: say("gives-up-or-selects-nothing"),
			can: isBegun,
			lacks: () => lackOfBegun(store.state),
			run: leave
		}
	];
}
// www/pair/state/offset.ts
function along(position, spacing, nodes) {
	const place = Math.min(nodes - 1, Math.max(0, position / spacing));
	const first = Math.min(Math.floor(place), Math.max(0, nodes - 2));
	return [
		first,
		Math.min(first + 1, nodes - 1),
		place - first
	];
}
function expectedPosition(field, [x, y]) {
	const [left, right, u] = along(x, field.spacing_px, field.columns);
	const [top, bottom, v] = along(y, field.spacing_px, field.rows);
	const node = (column, row, axis) => field.offsets[row * field.columns + column]?.[axis] ?? 0;
	const offset = (axis) => {
		const above = node(left, top, axis) * (1 - u) + node(right, top, axis) * u;
		const below = node(left, bottom, axis) * (1 - u) + node(right, bottom, axis) * u;
		return above * (1 - v) + below * v;
	};
	return [x + offset(0), y + offset(1)];
}
function expectedOrigin(field, [x, y]) {
	let at = [x - field.median_px[0], y - field.median_px[1]];
	for (let i = 0; i < 3; i++) {
		const [ex, ey] = expectedPosition(field, at);
		at = [at[0] + x - ex, at[1] + y - ey];
	}
	return at;
}
// www/pair/state/follow.ts
var LEAST_MATCHES = 10;
var ALONG_A_LINE = 1e-6;
var mapOf = remember((matches) => {
	const count = matches.length / 5;
	const place = (i) => [
		matches[5 * i] ?? NaN,
		matches[5 * i + 1] ?? NaN,
		matches[5 * i + 2] ?? NaN,
		matches[5 * i + 3] ?? NaN
	];
	return count < LEAST_MATCHES ? null : fitted$2(count, place, ALONG_A_LINE);
});
function sameGround(state, side, at) {
	const { settings, results } = state;
	if (settings !== null && comparesGradients(settings)) {
		const map = results.match !== void 0 && isCurrent(state, "match") ? mapOf(results.match.value.matches) : null;
		if (map === null) return null;
		return mapped(side === "left" ? map : inverse(map), ...at);
	}
	const field = isCurrent(state, "offset") ? results.offset?.value : void 0;
	if (field === void 0) return null;
	return side === "left" ? expectedPosition(field, at) : expectedOrigin(field, at);
}
// www/pair/view/navigate.ts
var Navigator = class {
	store;
	view;
	constructor(store, view) {
		this.store = store;
		this.view = view;
	}
	pan(side, dx, dy) {
		this.change(side, (pane, own) => ({
			...own,
			x: own.x - dx / pane.transform.scale,
			y: own.y - dy / pane.transform.scale
		}));
	}
	zoom(side, factor, x, y) {
		const origin = this.view.scene().panes[side].rect;
		this.change(side, (pane, own, least) => zoomed(pane.rect, own, factor, x - origin.left + pane.rect.left, y - origin.top + pane.rect.top, least));
	}
	zoomMiddle(factor) {
		const pane = this.activePane();
		const { rect } = pane;
		const middle = [rect.left + rect.width / 2, rect.top + rect.height / 2];
		this.zoom(pane.side, factor, ...this.selectedPlace(pane) ?? middle);
	}
	fit() {
		this.store.dispatch({
			type: "views",
			views: {
				left: null,
				right: null
			}
		});
	}
	actualSize() {
		this.zoomMiddle(1 / this.activePane().transform.scale);
	}
	step(by) {
		const { state } = this.store;
		const { panes, shown } = this.view.scene();
		const pane = panes[state.activeSide];
		const count = pane.codes.length;
		const start = state.selection?.side === pane.side ? state.selection.index : by > 0 ? -1 : count;
		for (let i = start + by; i >= 0 && i < count; i += by) if (isCodeShown(shown, pane.codes[i] ?? 0)) {
			this.select({
				side: pane.side,
				index: i
			});
			return;
		}
	}
	select(selection) {
		this.store.dispatch({
			type: "select",
			selection
		});
		if (selection === null) return;
		const scene = this.view.scene();
		this.bringIntoView(scene, selection);
		const partner = partnerOf(scene, selection);
		if (partner !== null) this.bringIntoView(scene, partner);
	}
	followDraft() {
		const { state } = this.store;
		const scene = this.view.scene();
		const scale = Math.max(...SIDES.map((side) => scene.panes[side].transform.scale));
		const views = SIDES.flatMap((side) => {
			const { rect, transform } = scene.panes[side];
			const at = placeOfDraft(state, side);
			if (at === null || contains(inner(rect), ...toCanvas(transform, ...at)) && transform.scale === scale) return [];
			return [[side, {
				x: at[0],
				y: at[1],
				scale
			}]];
		});
		if (views.length > 0) this.store.dispatch({
			type: "views",
			views: Object.fromEntries(views)
		});
	}
	show(side, at) {
		const { rect, transform } = this.view.scene().panes[side];
		if (contains(inner(rect), ...toCanvas(transform, ...at))) return;
		this.store.dispatch({
			type: "views",
			views: { [side]: {
				x: at[0],
				y: at[1],
				scale: transform.scale
			} }
		});
	}
	middle(of) {
		const { side, ...pane } = of === void 0 ? this.activePane() : this.view.scene().panes[of];
		return pane.picture === null ? null : [side, middleOf(pane)];
	}
	activePane() {
		return this.view.scene().panes[this.store.state.activeSide];
	}
	selectedPlace(pane) {
		const { selection } = this.store.state;
		if (selection?.side !== pane.side) return null;
		const x = pane.points?.[3 * selection.index];
		const y = pane.points?.[3 * selection.index + 1];
		if (x === void 0 || y === void 0) return null;
		const place = toCanvas(pane.transform, x, y);
		return contains(pane.rect, ...place) ? place : null;
	}
	bringIntoView(scene, { side, index }) {
		const pane = scene.panes[side];
		const x = pane.points?.[3 * index];
		const y = pane.points?.[3 * index + 1];
		if (x === void 0 || y === void 0 || contains(pane.rect, ...toCanvas(pane.transform, x, y))) return;
		this.store.dispatch({
			type: "views",
			views: { [side]: {
				x,
				y,
				scale: pane.transform.scale
			} }
		});
	}
	change(side, next) {
		const scene = this.view.scene();
		const { state } = this.store;
		const move = (pane) => {
			if (pane.picture === null) return [];
			const whole = fitView(pane.rect, pane.picture.width, pane.picture.height);
			const own = state.views[pane.side];
			return [[pane.side, clamped(next(pane, own === null ? whole : inPane(own, pane.rect), whole.scale / 4), pane.picture)]];
		};
		const own = move(scene.panes[side]);
		const other = state.display.linked ? move(scene.panes[otherSide(side)]) : [];
		this.store.dispatch({
			type: "views",
			views: Object.fromEntries([...own, ...other.map((entry) => this.followed(side, own[0]?.[1], entry))])
		});
	}
	followed(side, leader, [other, view]) {
		const ground = leader === void 0 ? null : sameGround(this.store.state, side, [leader.x, leader.y]);
		return ground === null ? [other, view] : [other, {
			x: ground[0],
			y: ground[1],
			scale: view.scale
		}];
	}
};
function inner({ left, top, width, height }) {
	return {
		left: left + width / 8,
		top: top + height / 8,
		width: .75 * width,
		height: .75 * height
	};
}
function partnerOf(scene, { side, index }) {
	const best = scene.match?.best;
	if (best === void 0) return null;
	const found = side === "left" ? best[index] ?? -1 : best.findIndex((right, left) => right === index && scene.match?.rules[left] === 0);
	return found < 0 ? null : {
		side: otherSide(side),
		index: found
	};
}
// www/pair/view/chosen.ts
var RADIUS = 6;
function drawChosen(context, state, scene) {
	const edited = editedPair(state);
	const lefts = chosenLefts(state).filter((left) => scene.panes.left.codes[left] !== 255);
	if (edited === null || lefts.length === 0) return;
	for (const side of SIDES) {
		const { rect, transform } = scene.panes[side];
		const path = new Path2D();
		for (const left of lefts) {
			const place = placeOfLeft(edited, left);
			const [x, y] = toCanvas(transform, ...side === "left" ? [place[0], place[1]] : [place[2], place[3]]);
			path.moveTo(x + RADIUS, y);
			path.arc(x, y, RADIUS, 0, 2 * Math.PI);
		}
		within(context, rect, () => {
			context.lineWidth = 3.5;
			context.strokeStyle = "rgb(0 0 0 / 0.6)";
			context.stroke(path);
			context.lineWidth = 1.8;
			context.strokeStyle = SELECTED;
			context.stroke(path);
		});
	}
}
function drawRectangle(context, { left, top, width, height }) {
	context.fillStyle = "rgb(255 212 0 / 0.12)";
	context.fillRect(left, top, width, height);
	context.lineWidth = 3;
	context.strokeStyle = "rgb(0 0 0 / 0.5)";
	context.strokeRect(left, top, width, height);
	context.setLineDash([6, 4]);
	context.lineWidth = 1.5;
	context.strokeStyle = SELECTED;
	context.strokeRect(left, top, width, height);
	context.setLineDash([]);
}
// www/pair/view/draft.ts
function drawDraft(context, state, scene) {
	const { draft } = state;
	if (draft === null) return;
	const line = lineOfDraft(state);
	if (line !== null) drawLine(context, scene.panes[line.side], line.positions);
	const expected = expectedPlace(state);
	if (expected !== null && draft.places[draft.side] !== null) drawExpected(context, scene.panes[draft.side], expected);
	for (const side of SIDES) {
		const at = placeOfDraft(state, side);
		if (at !== null) drawCross(context, scene.panes[side], at, side === draft.side);
	}
}
// www/pair/view/fiducials.ts
function drawFiducials(context, state, scene) {
	const { tool, mark, photos } = state;
	if (tool !== "fiducials") return;
	for (const side of SIDES) for (const [index, one] of photos[side].fiducials.entries()) {
		const at = placeOfMark(photos[side], one);
		if (at !== null) drawCross(context, scene.panes[side], at, mark?.side === side && mark.index === index);
	}
	if (mark === null) return;
	if (placeOfMark(photos[mark.side], markInHand(state)) !== null) return;
	const pane = scene.panes[mark.side];
	drawCross(context, pane, middleOf(pane), false);
	if (mark.expected !== null) drawExpected(context, pane, [mark.expected[0], mark.expected[1]]);
}
// www/pair/view/tilecache.ts
var MOST_TILES = 96;
var MOST_REQUESTS = 3;
var TileCache = class {
	fetch;
	arrived;
	tiles = new Map();
	requested = new Set();
	constructor(fetch, arrived) {
		this.fetch = fetch;
		this.arrived = arrived;
	}
	get(imageId, level, column, row) {
		const name = [
			imageId,
			level,
			column,
			row
		].join("/");
		const tile = this.tiles.get(name);
		if (tile !== void 0) {
			this.tiles.delete(name);
			this.tiles.set(name, tile);
			return tile;
		}
		if (!this.requested.has(name) && this.requested.size < MOST_REQUESTS) {
			this.requested.add(name);
			this.fetch(imageId, level, column, row).then((bitmap) => this.keep(name, bitmap), () => this.requested.delete(name));
		}
		return null;
	}
	keep(name, bitmap) {
		this.requested.delete(name);
		this.tiles.set(name, bitmap);
		for (const [oldest, old] of this.tiles) {
			if (this.tiles.size <= MOST_TILES) break;
			old.close();
			this.tiles.delete(oldest);
		}
		this.arrived();
	}
};
// www/pair/view/picture.ts
function paintPicture(context, picture, t, clip, ratio, tiles) {
	within(context, clip, () => {
		smooth(context, t.scale, ratio);
		const part = visiblePart(picture, t, clip);
		paintBitmap(context, picture.overview.bitmap, 0, 0, 2 ** picture.overview.halvings, part, t);
		const level = wantedLevel(t.scale, ratio);
		if (tiles === null || level >= picture.overview.halvings) return;
		const step = 2 ** level;
		const side = 512 * step;
		for (let row = Math.floor(part[1] / side); row * side < part[3]; row++) for (let column = Math.floor(part[0] / side); column * side < part[2]; column++) {
			const tile = tiles.get(picture.imageId, level, column, row);
			if (tile !== null) paintBitmap(context, tile, column * side, row * side, step, part, t);
		}
	});
}
function paintMask(context, { overlay, width, height }, t, clip) {
	within(context, clip, () => {
		context.imageSmoothingEnabled = false;
		context.drawImage(overlay, t.x, t.y, t.scale * width, t.scale * height);
	});
}
// www/pair/view/lenses.ts
var CORNER_SIDE = 168;
var CORNER_SCALE = 12;
var EDGE = 8;
function lensesOfMeasured(state, scene) {
	const { mark, tool } = state;
	const ofMark = tool === "fiducials" && mark !== null ? placeOfMark(state.photos[mark.side], markInHand(state)) : null;
	return SIDES.flatMap((side) => [mark?.side === side ? ofMark : null, placeOfDraft(state, side)].flatMap((at) => at === null ? [] : inCorner(scene.panes[side], at)));
}
function magnifierAt(scene, at, bounds) {
	const pane = paneAt(scene, ...at);
	if (pane === null) return [];
	const scale = Math.min(48, Math.max(4, pane.transform.scale * 4));
	return lens(pane, toPosition(pane.transform, ...at), lensRect(at, bounds), scale);
}
function lens(pane, at, rect, scale) {
	return pane.picture === null ? [] : [{
		pane,
		rect,
		transform: lensTransform(rect, at, scale)
	}];
}
var inCorner = (pane, at) => lens(pane, at, cornerOf(pane), Math.max(CORNER_SCALE, pane.transform.scale));
function cornerOf({ rect, side }) {
	const length = Math.max(40, Math.min(CORNER_SIDE, rect.width * .45, rect.height * .45));
	return {
		left: side === "left" ? rect.left + EDGE : rect.left + rect.width - EDGE - length,
		top: rect.top + rect.height - EDGE - length,
		width: length,
		height: length
	};
}
function paintLenses(context, lenses, ratio, tiles) {
	for (const { pane, rect, transform } of lenses) within(context, rect, () => {
		context.fillStyle = "#000000";
		context.fillRect(rect.left, rect.top, rect.width, rect.height);
		if (pane.picture !== null) paintPicture(context, pane.picture, transform, rect, ratio, tiles);
	});
}
function drawOverLenses(context, state, scene, lenses) {
	for (const { pane, rect, transform } of lenses) {
		within(context, rect, () => {
			drawPoints(context, state, scene, pane, transform, rect);
			crosshair(context, rect);
		});
		lensFrame(context, rect);
	}
}
// www/pair/view/outline.ts
var CORNER = 3;
function drawOutline(context, { outline, tool, activeSide }, scene) {
	const active = scene.panes[activeSide];
	if (tool === "mask" && active.picture !== null) drawCross(context, active, middleOf(active), false);
	if (outline === null) return;
	const { rect, transform } = scene.panes[outline.side];
	const corners = outline.corners.map(([x, y]) => toCanvas(transform, x, y));
	const path = new Path2D();
	for (const [i, [x, y]] of corners.entries()) if (i === 0) path.moveTo(x, y);
	else path.lineTo(x, y);
	path.closePath();
	within(context, rect, () => {
		context.fillStyle = "rgb(255 212 0 / 0.2)";
		context.fill(path);
		context.lineWidth = 3;
		context.strokeStyle = "rgb(0 0 0 / 0.6)";
		context.stroke(path);
		context.lineWidth = 1.5;
		context.strokeStyle = SELECTED;
		context.stroke(path);
		context.fillStyle = SELECTED;
		if (corners.length <= 64) for (const [x, y] of corners) context.fillRect(x - CORNER, y - CORNER, 6, 6);
	});
}
// www/pair/view/overlay.ts
var MOST_CANDIDATES_DRAWN = 200;
var MOST_GRADIENT_CANDIDATES_DRAWN = 10;
function pointOf(pane, index) {
	const x = pane.points?.[3 * index];
	const y = pane.points?.[3 * index + 1];
	return x === void 0 || y === void 0 ? null : [x, y];
}
function square(context, pane, [x, y], side, colour, dash) {
	const [left, top] = toCanvas(pane.transform, x - side / 2, y - side / 2);
	context.setLineDash(dash);
	context.lineWidth = 1.5;
	context.strokeStyle = colour;
	context.strokeRect(left, top, side * pane.transform.scale, side * pane.transform.scale);
	context.setLineDash([]);
}
function drawSelection(context, state, scene) {
	const { selection, settings } = state;
	if (selection === null || settings === null) return;
	const own = scene.panes[selection.side];
	const at = pointOf(own, selection.index);
	if (at === null) return;
	within(context, own.rect, () => {
		if (comparesGradients(settings)) drawSupport(context, settings, own, selection.index);
		else square(context, own, at, comparesGreyValues(settings) ? settings.matching.template : settings.window.side, SELECTED, []);
		ring(context, own, at, 9, SELECTED, 2.5);
	});
	if (scene.match === null) return;
	const line = isCurrent(state, "inspection") ? state.results.inspection?.value.line : void 0;
	if (line != null) drawLine(context, scene.panes[line.side], line.positions);
	const leftIndex = leftIndexOf(state, scene.match.best, scene.match.rules);
	const leftAt = pointOf(scene.panes.left, leftIndex);
	if (leftAt === null) return;
	if (selection.side === "right") within(context, scene.panes.left.rect, () => ring(context, scene.panes.left, leftAt, 9, SELECTED, 2));
	drawCandidates(context, state, scene, leftIndex, leftAt, placeOf(scene.match.places, leftIndex));
}
function drawCandidates(context, state, scene, leftIndex, leftAt, best) {
	const pane = scene.panes.right;
	within(context, pane.rect, () => {
		const { settings } = state;
		const gradients = settings !== null && comparesGradients(settings);
		const field = isCurrent(state, "offset") ? state.results.offset?.value : void 0;
		if (field !== void 0) square(context, pane, expectedPosition(field, leftAt), state.settings?.matching.search ?? 0, CANDIDATE, [5, 4]);
		if (isCurrent(state, "inspection")) {
			const list = state.results.inspection?.value.candidates ?? new Float64Array();
			const most = gradients ? MOST_GRADIENT_CANDIDATES_DRAWN : MOST_CANDIDATES_DRAWN;
			for (let i = 0; i < Math.min(list.length / 2, most); i++) {
				const at = pointOf(pane, list[2 * i] ?? -1);
				if (at !== null) ring(context, pane, at, 4, CANDIDATE, 1.2);
			}
		}
		if (gradients) drawSupport(context, settings, pane, scene.match?.best[leftIndex] ?? -1);
		if (best !== null) ring(context, pane, best, 9, SELECTED, state.selection?.side === "right" ? 2.5 : 2);
	});
}
// www/pair/view/view.ts
var LAYERS = [
	"pictures",
	"masks",
	"marks",
	"overlay",
	"lenses",
	"glass"
];
var ABOVE = [
	"overlay",
	"lenses",
	"glass"
];
var CLICK_RADIUS = 14;
var gridOf = {
	left: remember((points, width, height) => new PointGrid(points, width, height)),
	right: remember((points, width, height) => new PointGrid(points, width, height))
};
var gridOfPlaces = remember((points, width, height) => new PointGrid(points, width, height));
var View = class {
	host;
	store;
	layers;
	tiles;
	pointer = null;
	rectangle = null;
	constructor(host, store, engine) {
		this.host = host;
		this.store = store;
		this.layers = new Layers(host, LAYERS, (name, context) => this.draw(name, context));
		this.tiles = new TileCache(async (imageId, level, column, row) => {
			const side = SIDES.find((s) => store.state.images[s]?.id === imageId);
			if (side === void 0) throw new Error("the image is no longer shown");
			return (await engine.withImage(side, store.state)).call("tile", {
				level,
				column,
				row,
				side: 512
			});
		}, () => this.layers.redraw("pictures", "lenses"));
		store.watch((s) => [
			s.views,
			s.images,
			s.masks,
			s.results.openLeft,
			s.results.openRight
		], () => this.layers.redraw());
		store.watch((s) => {
			const { points, codes, match, matchCodes, places, vectors, shown } = marksOf(s);
			const { left, right } = vectors;
			return [
				points.left,
				points.right,
				codes.left,
				codes.right,
				match,
				matchCodes,
				places,
				left,
				right,
				shown,
				s.display,
				s.catalogue
			];
		}, () => this.layers.redraw("marks", ...ABOVE));
		store.watch((s) => [
			s.selection,
			s.chosen,
			s.draft,
			s.outline,
			s.mark,
			s.photos,
			s.tool,
			s.activeSide,
			s.results.line,
			s.results.inspection,
			s.settings,
			s.results.offset
		], () => this.layers.redraw(...ABOVE));
	}
	scene() {
		return sceneOf(this.store.state, this.layers.width, this.layers.height);
	}
	takeKeys() {
		this.host.focus({ preventScroll: true });
	}
	point(at) {
		this.pointer = at;
		if (this.store.state.display.magnifier) this.layers.redraw("lenses", "glass");
	}
	enclose(rectangle) {
		this.rectangle = rectangle;
		this.layers.redraw("overlay");
	}
	hit(x, y) {
		const scene = this.scene();
		const pane = paneAt(scene, x, y);
		if (pane?.picture == null || pane.points === null) return null;
		const { width, height } = pane.picture;
		const at = toPosition(pane.transform, x, y);
		const radius = CLICK_RADIUS / pane.transform.scale;
		const found = gridOf[pane.side](pane.points, width, height).nearest(...at, radius, (i) => isCodeShown(scene.shown, pane.codes[i] ?? 0));
		const index = found < 0 ? null : {
			side: pane.side,
			index: found
		};
		if (pane.side === "left" || scene.match === null) return index;
		const { places } = scene;
		const place = gridOfPlaces(places.points, width, height).nearest(...at, radius, (i) => isCodeShown(scene.shown, places.codes[i] ?? 0));
		return place < 0 ? index : {
			side: "left",
			index: places.lefts[place] ?? 0
		};
	}
	snapshot() {
		return this.layers.snapshot();
	}
	draw(name, context) {
		const { state } = this.store;
		const scene = this.scene();
		switch (name) {
			case "pictures":
				for (const side of SIDES) this.drawPicture(context, scene.panes[side]);
				break;
			case "masks":
				for (const { side, picture, transform, rect } of SIDES.map((one) => scene.panes[one])) {
					const mask = state.masks[side];
					if (picture !== null && mask !== null) paintMask(context, mask, transform, rect);
				}
				break;
			case "marks":
				if (state.catalogue !== null) drawMarks(context, state, scene);
				break;
			case "overlay":
				drawChosen(context, state, scene);
				drawSelection(context, state, scene);
				drawDraft(context, state, scene);
				drawOutline(context, state, scene);
				drawFiducials(context, state, scene);
				if (this.rectangle !== null) drawRectangle(context, this.rectangle);
				break;
			case "lenses":
				paintLenses(context, this.lenses(state, scene), this.layers.ratio, this.tiles);
				break;
			case "glass": if (state.catalogue !== null) drawOverLenses(context, state, scene, this.lenses(state, scene));
		}
	}
	lenses(state, scene) {
		const { width, height } = this.layers;
		const at = this.pointer ?? selectedPlace(state, scene);
		const magnifies = state.display.magnifier && state.draft === null && at !== null && state.catalogue !== null;
		return [...lensesOfMeasured(state, scene), ...magnifies ? magnifierAt(scene, at, {
			left: 0,
			top: 0,
			width,
			height
		}) : []];
	}
	drawPicture(context, pane) {
		if (pane.picture === null) return;
		const current = wantedKeys(this.store.state)[pane.side === "left" ? "openLeft" : "openRight"] !== null;
		paintPicture(context, pane.picture, pane.transform, pane.rect, this.layers.ratio, current ? this.tiles : null);
	}
};
function selectedPlace(state, scene) {
	if (state.selection === null) return null;
	const { points, transform } = scene.panes[state.selection.side];
	const x = points?.[3 * state.selection.index];
	const y = points?.[3 * state.selection.index + 1];
	return x === void 0 || y === void 0 ? null : toCanvas(transform, x, y);
}
// www/pair/mount.ts
async function mountPair(catalogue, { openProject, toBlock, toGround, sampleBlock, putAside, left: projectLeft }) {
	const store = new Store();
	const { element: left, panels: [settings, camera, simulate] } = tabbed("settings", say("settings"), [
		["settings", say("settings")],
		["camera", say("camera")],
		["simulate", say("simulate")]
	]);
	const { element: right, panels: [results, point, matches] } = tabbed("details", say("results"), [
		["results", say("results")],
		["point", say("point")],
		["matches", say("matches-2")]
	]);
	byId("stage").before(left);
	byId("stage").after(right);
	const settingsButton = drawerButton("settings", say("settings"), "settings", left);
	byId("menu").before(h("div", {
		class: "drawers",
		aria: { label: say("settings-of-the-pair") },
		role: "group"
	}, settingsButton));
	byId("answer-actions").append(drawerButton("details", say("details"), "details", right, say("details-of-the-results")));
	const engine = new Engine(store);
	const view = new View(byId("view"), store, engine);
	const navigator = new Navigator(store, view);
	await breath();
	const kept = new KeptPairs(store, engine, catalogue);
	const files = new Files(store, engine, openProject, {
		toBlock,
		toGround,
		left: projectLeft
	}, () => putAside(kept));
	const attempt = async (action) => {
		try {
			await action();
		} catch (error) {
			store.dispatch({
				type: "notice",
				notice: {
					kind: "problem",
					text: `${readable(store.state.catalogue, messageOf(error))}.`
				}
			});
		}
	};
	const saving = async (near, write) => {
		const { notice: before } = store.state;
		try {
			const name = await write();
			const { notice } = store.state;
			if (name === null || notice?.kind === "busy" || notice !== before && notice?.beside !== true) return;
			store.dispatch({
				type: "notice",
				notice: {
					kind: "info",
					text: say("was-saved", { name }),
					beside: true
				}
			});
		} catch (error) {
			store.dispatch({
				type: "notice",
				notice: {
					kind: "problem",
					text: sentence(readable(store.state.catalogue, messageOf(error))),
					near
				}
			});
		}
	};
	const editing = new Editing(store, (left, right) => fitted(store.state, engine, left, right));
	const masking = new Masking(store, (state, side, over, areas) => paintedMask(engine, state, side, over, areas));
	const paint = (masked) => void attempt(() => masking.paint(masked));
	const stepMasks = (by) => void attempt(() => masking.step(by));
	const marking = new Marking(store, (fiducials, model) => engine.client("preview").call("orientMarks", {
		fiducials: [...fiducials],
		model
	}).catch(() => null), (side, at) => navigator.show(side, at));
	mountInput(view, store, navigator, {
		editing,
		masking,
		marking,
		paint
	});
	mountToolbar(byId("toolbar"), store, navigator);
	declareLack([byId("toolbar"), byId("view")], () => SIDES.some((side) => store.state.images[side] === null) ? say("needs-two-photos") : "");
	mountEditTools(byId("view-more"), byId("toolbar"), store, editing);
	const measured = () => {
		if (store.state.tool !== "measure") return;
		uncoverPictures();
		navigator.followDraft();
		view.takeKeys();
	};
	mountDraft(byId("toolbar"), store, editing, {
		follow: () => navigator.followDraft(),
		begun: measured,
		ended: () => view.takeKeys()
	});
	mountMasking(byId("view-more"), byId("toolbar"), store, masking, {
		paint,
		step: stepMasks,
		giveUp: () => void editing.leave()
	});
	mountMarking(byId("toolbar"), store, marking);
	await breath();
	const pick = pickerOf(files);
	mountPanes(view, store, {
		open: (side) => pick(side),
		mask: (side) => pick(side, "mask"),
		unmask: (side) => store.dispatch({
			type: "mask",
			side,
			mask: null
		})
	});
	await breath();
	mountControls(settings, store, settingsButton);
	mountCamera(camera, store, () => pick(null));
	await breath();
	const measureMarks = (side) => {
		marking.toggle(side);
		if (store.state.tool !== "fiducials") return;
		uncoverPictures();
		byId("view").focus();
	};
	mountFiducials(camera, store, (side) => pick(side), marking, measureMarks);
	await breath();
	mountCounts(results, store);
	mountGeometry(results, store);
	mountOrientation(results, store);
	mountHistograms(results, store);
	await breath();
	mountPoint(point, store, (side, index) => navigator.select({
		side,
		index
	}));
	declareLack([matches], () => lackOfMatches(store.state));
	mountEdits(matches, store, editing, measured);
	mountHistory(matches, store, {
		matches: (done) => store.dispatch({
			type: "goto",
			done
		}),
		masks: (done) => void attempt(() => masking.goTo(done)),
		marks: (done) => marking.step(done - store.state.markSteps.done)
	});
	mountEditKeys(matches, store, editing, measured);
	mountStatistics(matches, store, editing, (side, index) => navigator.select({
		side,
		index
	}));
	await breath();
	mountSimulate(simulate, store, engine, (name, flight) => void attempt(() => files.takeFlight(name, flight)));
	mountAnnouncements(byId("announce"), store, () => {
		showTab("tab-point");
		setDrawer("details", true);
		reveal$1(right);
	});
	mountStatus(store, {
		cancel: () => engine.cancel(),
		run: () => store.dispatch({ type: "resume" }),
		open: (side) => pick(side),
		camera: () => {
			setDrawer("settings", true);
			showTab("tab-camera");
			focusFocalLength(camera);
		},
		calibrated: () => useCalibration(store),
		otherStrategy: () => {
			const { settings: wanted } = store.state;
			if (wanted !== null) store.dispatch({
				type: "settings",
				settings: withSetting(wanted, "matching.strategy", readSetting(catalogue.defaults, "matching.strategy"))
			});
		},
		why: () => {
			showTab("tab-results");
			setDrawer("details", true);
			const oriented = shownPair(store.state).orientation !== null;
			if (!oriented) store.dispatch({
				type: "display",
				display: {
					points: "all",
					hidden: []
				}
			});
			queueMicrotask(() => results.querySelector(`[data-testid="${oriented ? "orientation" : "matches"}-section"]`)?.scrollIntoView({ block: "start" }));
		},
		save: () => void saving("next", () => exportProject(store, engine))
	});
	mountHeader({
		store,
		engine,
		view,
		files,
		pick,
		attempt,
		saving,
		sampleBlock
	});
	const near = makeNear("near", () => store.dispatch({
		type: "notice",
		notice: null
	}));
	byId("stage").after(near.element);
	store.watch(["notice"], ([notice]) => near.show(notice));
	store.watch(["selection"], ([selection]) => {
		if (selection !== null && matches.hidden) showTab("tab-point");
	});
	return {
		store,
		engine,
		kept,
		measureMarks,
		begin: () => files.begin(),
		taker: takerOf(store, view, files),
		open: (file) => files.takeProject(file),
		save: (near) => saving(near, () => exportProject(store, engine))
	};
}
// www/shared/engine/release.ts
var SCRIPT = "service-worker.js";
var ASK_AGAIN_MS = 36e5;
async function keepRelease({ ready, replaced }) {
	const { serviceWorker } = navigator;
	if (serviceWorker === void 0 || !besideFiles() || false) return;
	const isKept = serviceWorker.controller !== null;
	const registration = await serviceWorker.register(scriptAddress(new URL(SCRIPT, document.baseURI).href), { updateViaCache: "none" });
	const offer = () => {
		const { waiting } = registration;
		if (waiting !== null && isKept) ready(() => waiting.postMessage("take over"));
	};
	offer();
	registration.addEventListener("updatefound", () => registration.installing?.addEventListener("statechange", offer));
	serviceWorker.addEventListener("controllerchange", () => {
		if (isKept) replaced();
	});
	let asked = Date.now();
	document.addEventListener("visibilitychange", () => {
		if (document.visibilityState !== "visible" || Date.now() - asked < ASK_AGAIN_MS) return;
		asked = Date.now();
		registration.update().catch(() => void 0);
	});
}
function watchLaunches(open) {
	if (typeof launchQueue === "undefined") return;
	launchQueue.setConsumer(({ files }) => {
		for (const file of files) file.getFile().then(open);
	});
}
// www/shared/engine/start.ts
async function loadCatalogue() {
	await __wbg_init({ module_or_path: await wasmModule() });
	return catalogueInLanguage(readCatalogue());
}
// node_modules/idb/build/index.js
var instanceOfAny = (object, constructors) => constructors.some((c) => object instanceof c);
var idbProxyableTypes;
var cursorAdvanceMethods;
function getIdbProxyableTypes() {
	return idbProxyableTypes || (idbProxyableTypes = [
		IDBIndex,
		IDBObjectStore,
		IDBCursor,
		IDBDatabase,
		IDBTransaction
	]);
}
function getCursorAdvanceMethods() {
	return cursorAdvanceMethods || (cursorAdvanceMethods = [
		"advance",
		"continue",
		"continuePrimaryKey"
	].map((method) => IDBCursor.prototype[method]));
}
var transactionDoneMap = new WeakMap();
var transformCache = new WeakMap();
var reverseTransformCache = new WeakMap();
function promisifyRequest(request) {
	const promise = new Promise((resolve, reject) => {
		const unlisten = () => {
			request.removeEventListener("success", success);
			request.removeEventListener("error", error);
		};
		const success = () => {
			resolve(wrap(request.result));
			unlisten();
		};
		const error = () => {
			reject(request.error);
			unlisten();
		};
		request.addEventListener("success", success);
		request.addEventListener("error", error);
	});
	reverseTransformCache.set(promise, request);
	return promise;
}
function cacheDonePromiseForTransaction(tx) {
	if (transactionDoneMap.has(tx)) return;
	const done = new Promise((resolve, reject) => {
		const unlisten = () => {
			tx.removeEventListener("complete", complete);
			tx.removeEventListener("error", error);
			tx.removeEventListener("abort", error);
		};
		const complete = () => {
			resolve();
			unlisten();
		};
		const error = () => {
			reject(tx.error || new DOMException("AbortError", "AbortError"));
			unlisten();
		};
		tx.addEventListener("complete", complete);
		tx.addEventListener("error", error);
		tx.addEventListener("abort", error);
	});
	transactionDoneMap.set(tx, done);
}
var idbProxyTraps = {
	get(target, prop, receiver) {
		if (target instanceof IDBTransaction) {
			if (prop === "done") return transactionDoneMap.get(target);
			if (prop === "store") return receiver.objectStoreNames[1] ? void 0 : receiver.objectStore(receiver.objectStoreNames[0]);
		}
		return wrap(target[prop]);
	},
	set(target, prop, value) {
		target[prop] = value;
		return true;
	},
	has(target, prop) {
		if (target instanceof IDBTransaction && (prop === "done" || prop === "store")) return true;
		return prop in target;
	}
};
function replaceTraps(callback) {
	idbProxyTraps = callback(idbProxyTraps);
}
function wrapFunction(func) {
	if (getCursorAdvanceMethods().includes(func)) return function(...args) {
		func.apply(unwrap(this), args);
		return wrap(this.request);
	};
	return function(...args) {
		return wrap(func.apply(unwrap(this), args));
	};
}
function transformCachableValue(value) {
	if (typeof value === "function") return wrapFunction(value);
	if (value instanceof IDBTransaction) cacheDonePromiseForTransaction(value);
	if (instanceOfAny(value, getIdbProxyableTypes())) return new Proxy(value, idbProxyTraps);
	return value;
}
function wrap(value) {
	if (value instanceof IDBRequest) return promisifyRequest(value);
	if (transformCache.has(value)) return transformCache.get(value);
	const newValue = transformCachableValue(value);
	if (!Object.is(newValue, value)) {
		transformCache.set(value, newValue);
		reverseTransformCache.set(newValue, value);
	}
	return newValue;
}
var unwrap = (value) => reverseTransformCache.get(value);
function openDB(name, version, { blocked, upgrade, blocking, terminated } = {}) {
	const request = indexedDB.open(name, version);
	const openPromise = wrap(request);
	if (upgrade) request.addEventListener("upgradeneeded", (event) => {
		upgrade(wrap(request.result), event.oldVersion, event.newVersion, wrap(request.transaction), event);
	});
	if (blocked) request.addEventListener("blocked", (event) => blocked(event.oldVersion, event.newVersion, event));
	openPromise.then((db) => {
		if (terminated) db.addEventListener("close", () => terminated());
		if (blocking) db.addEventListener("versionchange", (event) => blocking(event.oldVersion, event.newVersion, event));
	}).catch(() => {});
	return openPromise;
}
var readMethods = [
	"get",
	"getKey",
	"getAll",
	"getAllKeys",
	"count"
];
var writeMethods = [
	"put",
	"add",
	"delete",
	"clear"
];
var cachedMethods = {};
function getMethod(target, prop) {
	if (!(target instanceof IDBDatabase && !(prop in target) && typeof prop === "string")) return;
	if (cachedMethods[prop]) return cachedMethods[prop];
	const targetFuncName = prop.replace(/FromIndex$/, "");
	const useIndex = prop !== targetFuncName;
	const isWrite = writeMethods.includes(targetFuncName);
	if (!(targetFuncName in (useIndex ? IDBIndex : IDBObjectStore).prototype) || !(isWrite || readMethods.includes(targetFuncName))) return;
	const method = async function(storeName, ...args) {
		const tx = this.transaction(storeName, isWrite ? "readwrite" : "readonly");
		let target = tx.store;
		if (useIndex) target = target.index(args.shift());
		return (await Promise.all([target[targetFuncName](...args), isWrite && tx.done]))[0];
	};
	return cachedMethods[prop] = method;
}
replaceTraps((oldTraps) => ({
	...oldTraps,
	get: (target, prop, receiver) => getMethod(target, prop) || oldTraps.get(target, prop, receiver),
	has: (target, prop) => !!getMethod(target, prop) || oldTraps.has(target, prop)
}));
var advanceMethodProps = [
	"advance",
	"continue",
	"continuePrimaryKey"
];
var methodMap = {};
var advanceResults = new WeakMap();
var ittrProxiedCursorToOriginalProxy = new WeakMap();
var cursorIteratorTraps = { get(target, prop) {
	if (!advanceMethodProps.includes(prop)) return target[prop];
	let cachedFunc = methodMap[prop];
	if (!cachedFunc) cachedFunc = methodMap[prop] = function(...args) {
		advanceResults.set(this, ittrProxiedCursorToOriginalProxy.get(this)[prop](...args));
	};
	return cachedFunc;
} };
async function* iterate(...args) {
	let cursor = this;
	if (!(cursor instanceof IDBCursor)) cursor = await cursor.openCursor(...args);
	if (!cursor) return;
	cursor = cursor;
	const proxiedCursor = new Proxy(cursor, cursorIteratorTraps);
	ittrProxiedCursorToOriginalProxy.set(proxiedCursor, cursor);
	reverseTransformCache.set(proxiedCursor, unwrap(cursor));
	while (cursor) {
		yield proxiedCursor;
		cursor = await (advanceResults.get(proxiedCursor) || cursor.continue());
		advanceResults.delete(proxiedCursor);
	}
}
function isIteratorProp(target, prop) {
	return prop === Symbol.asyncIterator && instanceOfAny(target, [
		IDBIndex,
		IDBObjectStore,
		IDBCursor
	]) || prop === "iterate" && instanceOfAny(target, [IDBIndex, IDBObjectStore]);
}
replaceTraps((oldTraps) => ({
	...oldTraps,
	get(target, prop, receiver) {
		if (isIteratorProp(target, prop)) return iterate;
		return oldTraps.get(target, prop, receiver);
	},
	has(target, prop) {
		return isIteratorProp(target, prop) || oldTraps.has(target, prop);
	}
}));
// www/shared/files/connection.ts
var Connection = class {
	open;
	lost = () => void 0;
	opening = null;
	constructor(open) {
		this.open = open;
	}
	ready() {
		if (this.opening !== null) return this.opening;
		const opening = this.open(() => this.lose(opening));
		this.opening = opening;
		opening.catch(() => {
			if (this.opening === opening) this.opening = null;
		});
		return opening;
	}
	async use(work) {
		const opening = this.ready();
		const db = await opening;
		try {
			return await work(db);
		} catch (error) {
			if (!isClosed(error)) throw error;
			this.lose(opening);
			return work(await this.ready());
		}
	}
	lose(opening) {
		if (this.opening !== opening) return;
		this.opening = null;
		this.lost();
	}
};
function isClosed(error) {
	return error instanceof DOMException && error.name === "InvalidStateError";
}
// www/shared/files/database.ts
var NAME$1 = "tiepoint";
var VERSION = 1;
var PATIENCE_MS = 5e3;
var KeepError = class extends Error {
	kind;
	name = "KeepError";
	constructor(kind, message) {
		super(message);
		this.kind = kind;
	}
};
var partsOf = (project) => IDBKeyRange.bound([project], [project, []]);
var Database = class Database {
	connection = new Connection((lost) => opened(lost));
	constructor() {}
	static async open() {
		const database = new Database();
		await database.connection.ready();
		return database;
	}
	watch(lost) {
		this.connection.lost = lost;
	}
	async projects() {
		return (await this.read((db) => db.getAll("projects"))).sort((a, b) => b.changed - a.changed);
	}
	project(id) {
		return this.read((db) => db.get("projects", id));
	}
	async parts(id) {
		const rows = await this.read((db) => db.getAll("parts", partsOf(id)));
		return new Map(rows.map(({ part, value }) => [part, value]));
	}
	bytesOf(id) {
		return this.read(async (db) => {
			let sum = 0;
			let cursor = await db.transaction("parts").store.index("sizes").openKeyCursor(IDBKeyRange.bound([id], [id, []]));
			while (cursor !== null) {
				sum += cursor.key[1];
				cursor = await cursor.continue();
			}
			return sum;
		});
	}
	async write(row, { put, drop }, isNew) {
		await this.change(async (projects, parts) => {
			const there = await projects.get(row.id);
			if (there !== void 0 && there.writer !== row.writer) throw new KeepError("taken", say("another-tab-has-taken-the"));
			if (there !== void 0 && there.form > row.form) throw new KeepError("other", say("a-later-version-of-this"));
			if (there === void 0 && !isNew) throw new KeepError("gone", say("the-project-is-no-longer"));
			await Promise.all([
				projects.put(row),
				...[...put].map(([part, { value, bytes }]) => parts.put({
					project: row.id,
					part,
					bytes,
					value
				})),
				...drop.map((part) => parts.delete([row.id, part]))
			]);
		});
	}
	async claim(id, writer, from) {
		await this.change(async (projects) => {
			const there = await projects.get(id);
			if (there === void 0) throw new KeepError("gone", say("the-project-is-no-longer"));
			if (there.writer === writer) return;
			if (from !== void 0 && there.writer !== from) throw new KeepError("taken", say("another-tab-has-taken-the"));
			await projects.put({
				...there,
				writer
			});
		});
	}
	async rename(id, name) {
		await this.change(async (projects) => {
			const there = await projects.get(id);
			if (there === void 0) throw new KeepError("gone", say("the-project-is-no-longer"));
			await projects.put({
				...there,
				name
			});
		});
	}
	async duplicate(id, row) {
		let needed = 0;
		try {
			await this.change(async (projects, parts) => {
				const there = await projects.get(id);
				if (there === void 0) throw new KeepError("gone", say("the-project-is-no-longer"));
				const all = await parts.getAll(partsOf(id));
				needed = all.reduce((sum, { bytes }) => sum + bytes, 0);
				await projects.put({
					...there,
					...row,
					writer: ""
				});
				for (const part of all) await parts.put({
					...part,
					project: row.id
				});
			});
		} catch (error) {
			if (!(error instanceof KeepError) || error.kind !== "full") throw error;
			throw new KeepError("full", say("the-copy-needs-about", { size: sizeText(needed) }));
		}
	}
	async separate(id, row, names) {
		await this.change(async (projects, parts) => {
			const there = await projects.get(id);
			if (there === void 0) throw new KeepError("gone", say("the-project-is-no-longer"));
			if (there.writer !== row.writer) throw new KeepError("taken", say("another-tab-has-taken-the"));
			await projects.put({
				...row,
				writer: ""
			});
			for (const name of names) {
				const part = await parts.get([id, name]);
				if (part === void 0) continue;
				await parts.put({
					...part,
					project: row.id
				});
				await parts.delete([id, name]);
			}
		});
	}
	async remove(id) {
		await this.change(async (projects, parts) => {
			await Promise.all([projects.delete(id), parts.delete(partsOf(id))]);
		});
	}
	async read(work) {
		try {
			return await this.connection.use(work);
		} catch (error) {
			throw keepError(error);
		}
	}
	change(work) {
		return this.read((db) => transacted(db, work));
	}
};
async function opened(lost) {
	const late = new Promise((_, reject) => setTimeout(() => setTimeout(() => reject(new Error(say("the-storage-does-not-answer")))), PATIENCE_MS));
	late.catch(() => {});
	try {
		return await Promise.race([connected(lost), late]);
	} catch (error) {
		throw new KeepError("closed", reasonOf(error));
	}
}
function connected(lost) {
	return openDB(NAME$1, VERSION, {
		upgrade: (db) => {
			db.createObjectStore("projects", { keyPath: "id" });
			db.createObjectStore("parts", { keyPath: ["project", "part"] }).createIndex("sizes", ["project", "bytes"]);
		},
		blocking: (_, __, event) => {
			event.target.close();
			lost();
		},
		terminated: lost
	});
}
async function transacted(db, work) {
	let done = null;
	let abort = () => {};
	try {
		const transaction = db.transaction(["projects", "parts"], "readwrite", { durability: "strict" });
		done = transaction.done;
		done.catch(() => {});
		abort = () => transaction.abort();
		await work(transaction.objectStore("projects"), transaction.objectStore("parts"));
		await done;
	} catch (error) {
		throw await ended(error, done, abort);
	}
}
async function ended(error, done, abort) {
	try {
		abort();
		return error;
	} catch {
		return done === null ? error : done.then(() => error, (reason) => reason ?? error);
	}
}
function keepError(error) {
	if (error instanceof KeepError) return error;
	if (error instanceof DOMException && error.name === "QuotaExceededError") return new KeepError("full", say("the-storage-is-full"));
	return new KeepError("other", reasonOf(error));
}
function reasonOf(error) {
	if (!(error instanceof DOMException)) return messageOf(error);
	return error.name === "VersionError" ? say("a-later-version-of-this") : say("the-storage-failed", { name: error.name });
}
// www/shared/state/keeping.ts
var NOT_KEPT = [
	"absent",
	"full",
	"failed",
	"closed",
	"cleared",
	"reading",
	"taken"
];
var UNTIL_WRITTEN = [
	"no-room",
	"full",
	"failed",
	"closed",
	"cleared"
];
function makeKeeping() {
	return new Holder({
		project: "",
		name: null,
		trouble: null,
		works: false,
		opening: null
	}, (state, changed) => ({
		...state,
		...changed
	}));
}
function isKept({ works, trouble }) {
	return works && (trouble === null || !NOT_KEPT.includes(trouble.kind));
}
function endsWhenWritten({ trouble }) {
	return trouble !== null && UNTIL_WRITTEN.includes(trouble.kind);
}
// www/shared/files/claim.ts
var LEAVING_MS = 1e3;
var ANSWER_MS = 1500;
var Claims = class {
	tab;
	held = new Map();
	channel = typeof BroadcastChannel === "undefined" ? null : new BroadcastChannel("tiepoint-projects");
	constructor(tab) {
		this.tab = tab;
		this.channel?.addEventListener("message", ({ data }) => {
			if (data.from === tab || !this.held.has(data.project)) return;
			if (data.kind === "ask") this.post("here", data.project);
			if (data.kind === "taken") this.lose(data.project);
		});
	}
	async take(project, steal, lost) {
		const held = this.held.get(project);
		if (held !== void 0) return held.claim;
		const release = await this.claimed(project, steal);
		if (release === null) return null;
		const claim = { release: () => {
			this.held.delete(project);
			release();
		} };
		this.held.set(project, {
			claim,
			lost
		});
		if (steal) this.post("taken", project);
		return claim;
	}
	async elsewhere(project) {
		if (this.held.has(project)) return false;
		const release = await this.claimed(project, false);
		release?.();
		return release === null;
	}
	lose(project) {
		const held = this.held.get(project);
		held?.claim.release();
		held?.lost();
	}
	post(kind, project) {
		this.channel?.postMessage({
			kind,
			project,
			from: this.tab
		});
	}
	claimed(project, steal) {
		const locks = navigator.locks;
		if (locks === void 0) return steal ? Promise.resolve(() => void 0) : this.asked(project);
		return new Promise((resolve) => {
			let granted = false;
			const how = steal ? { steal } : { signal: AbortSignal.timeout(LEAVING_MS) };
			locks.request(`tiepoint-project-${project}`, how, () => {
				granted = true;
				return new Promise((release) => resolve(release));
			}).catch(() => {
				resolve(null);
				if (granted) this.lose(project);
			});
		});
	}
	asked(project) {
		const { channel } = this;
		if (channel === null) return Promise.resolve(() => void 0);
		return new Promise((resolve) => {
			const answer = (release) => {
				channel.removeEventListener("message", listen);
				resolve(release);
			};
			const listen = ({ data }) => {
				if (data.kind === "here" && data.project === project) answer(null);
			};
			channel.addEventListener("message", listen);
			this.post("ask", project);
			setTimeout(() => answer(() => void 0), ANSWER_MS);
		});
	}
};
// www/shared/files/reading.ts
var HANDOVER_MS = 400;
var ProjectReader = class {
	keepables;
	claims;
	tab;
	constructor(keepables, claims, tab) {
		this.keepables = keepables;
		this.claims = claims;
		this.tab = tab;
	}
	async read(database, id, how, { held, lost }) {
		const row = await database.project(id);
		if (row === void 0) return null;
		const title = titleOf(row);
		const refused = (kind, reason) => ({
			kind,
			reason,
			project: {
				id,
				title
			}
		});
		if (row.form > 1) return refused("unreadable", say("a-later-version-of-this-page"));
		const looks = how === "look";
		const claim = looks ? null : await this.claims.take(id, how === "steal", lost);
		if (claim === null && !looks) return refused("elsewhere", "");
		try {
			if (how === "steal") await new Promise((resolve) => setTimeout(resolve, HANDOVER_MS));
			const unnamed = looks ? null : await this.named(database, id);
			const parts = await database.parts(id);
			return {
				row,
				title,
				parts,
				claim,
				unnamed,
				shows: await Promise.all(this.keepables.map((keepable) => keepable.read(parts, looks)))
			};
		} catch (error) {
			if (claim !== null && held() !== claim) claim.release();
			return refused("unreadable", messageOf(error));
		}
	}
	async named(database, id) {
		try {
			await database.claim(id, this.tab);
			return null;
		} catch (error) {
			if (error instanceof KeepError && (error.kind === "full" || error.kind === "other")) return error;
			throw error;
		}
	}
};
// www/shared/files/remembered.ts
var TAB_PROJECT = "tiepoint-project";
var BROKE_OFF = "tiepoint-broke-off";
var MOST_BREAKS = 2;
function allowed(action, otherwise) {
	try {
		return action();
	} catch {
		return otherwise;
	}
}
var rememberedProject = () => allowed(() => sessionStorage.getItem(TAB_PROJECT), null);
var rememberProject = (id) => allowed(() => sessionStorage.setItem(TAB_PROJECT, id), void 0);
function breaks(id) {
	const [project, count] = (allowed(() => localStorage.getItem(BROKE_OFF), null) ?? "").split(" ");
	return project === id ? Number(count) || 0 : 0;
}
var countBreak = (id) => allowed(() => localStorage.setItem(BROKE_OFF, `${id} ${String(breaks(id) + 1)}`), void 0);
var forgetBreaks = () => allowed(() => localStorage.removeItem(BROKE_OFF), void 0);
var breaksOff = (project) => breaks(project) >= MOST_BREAKS;
// www/shared/files/written.ts
var PORTION_BYTES = 32e6;
var Written = class {
	keepables;
	parts = new Map();
	mode = "";
	isNew = true;
	isGone = false;
	former = null;
	constructor(keepables) {
		this.keepables = keepables;
	}
	begin() {
		this.isNew = true;
		this.isGone = false;
		this.former = null;
		this.parts = new Map();
	}
	opened(parts, former) {
		this.isNew = false;
		this.isGone = false;
		this.former = former;
		this.parts = new Map(parts);
	}
	shown() {
		for (const [part, { value }] of this.present()) if (this.parts.has(part)) this.parts.set(part, value);
	}
	gone() {
		this.begin();
		this.isGone = true;
	}
	doubt(writer) {
		if (!this.isNew) this.former ??= writer;
	}
	get isInDoubt() {
		return this.former !== null;
	}
	async ensure(database, id, writer) {
		if (this.former === null) return;
		await database.claim(id, writer, this.former);
		this.former = null;
	}
	forget(parts) {
		for (const gone of parts) this.parts.delete(gone);
	}
	present() {
		return new Map(this.keepables.flatMap((keepable) => [...keepable.parts()]));
	}
	changes() {
		const parts = this.present();
		return {
			put: new Map([...parts].filter(([part, { value }]) => !this.parts.has(part) || this.parts.get(part) !== value)),
			drop: [...this.parts.keys()].filter((part) => !parts.has(part))
		};
	}
	isChanged() {
		const { put, drop } = this.changes();
		return drop.length > 0 || [...put.values()].some(({ again }) => again !== true);
	}
	async write(database, row, put, drop) {
		const write = async (some, gone) => {
			await database.write(row, {
				put: some,
				drop: gone
			}, this.isNew);
			this.isNew = false;
			for (const [part, { value }] of some) this.parts.set(part, value);
			for (const part of gone) this.parts.delete(part);
		};
		for (const portion of portionsOf(put)) await write(portion, []);
		const rest = new Map([...put].filter(([part]) => this.parts.get(part) !== put.get(part)?.value || !this.parts.has(part)));
		try {
			await write(rest, drop);
		} catch (error) {
			const needed = new Map([...rest].filter(([, { again }]) => again !== true));
			if (!(error instanceof KeepError) || error.kind !== "full" || needed.size === rest.size) throw error;
			await write(needed, drop);
			this.isGone = false;
			throw error;
		}
		this.isGone = false;
	}
};
function portionsOf(put) {
	const portions = [];
	let room = 0;
	for (const [part, kept] of put) {
		if (kept.alone !== true) continue;
		if (room < kept.bytes) {
			portions.push(new Map());
			room = PORTION_BYTES;
		}
		portions.at(-1)?.set(part, kept);
		room -= kept.bytes;
	}
	return portions;
}
// www/shared/files/keeper.ts
var GATHER_MS = 200;
var CALM_MS = 15e3;
var Keeper = class {
	keepables;
	mode;
	keeping = makeKeeping();
	tab = randomName();
	claims = new Claims(this.tab);
	claim = null;
	database = null;
	reader;
	written;
	timer;
	saving = Promise.resolve();
	leaving = new Leaving();
	constructor(keepables, mode) {
		this.keepables = keepables;
		this.mode = mode;
		this.reader = new ProjectReader(keepables, this.claims, this.tab);
		this.written = new Written(keepables);
	}
	async start(opening, ready) {
		let show = () => {};
		try {
			this.database = await opening;
			this.database.watch(() => this.closed());
			this.keeping.dispatch({ works: true });
			show = await this.first(this.database);
		} catch (error) {
			this.database = null;
			this.keeping.dispatch({
				works: false,
				trouble: {
					kind: "absent",
					reason: messageOf(error),
					project: null
				}
			});
		}
		await ready();
		await this.shown(show);
		this.keeping.dispatch({ opening: null });
		if (this.claim === null) await this.begin();
		this.written.mode = this.mode.now();
		for (const keepable of this.keepables) keepable.watch(() => this.later());
		this.mode.watch(() => this.later());
		document.addEventListener("visibilitychange", () => {
			if (document.visibilityState === "hidden") this.flush();
		});
		window.addEventListener("pagehide", () => {
			forgetBreaks();
			this.flush();
		});
	}
	get isLost() {
		if (this.keeping.state.trouble?.kind === "reading") return this.written.isChanged();
		return !isKept(this.keeping.state) && this.keepables.some((keepable) => keepable.parts().size > 0);
	}
	async projects() {
		const { database } = this;
		if (database === null) return [];
		await this.flush();
		const rows = await database.projects();
		return Promise.all(rows.map(async (row) => ({
			...row,
			bytes: await database.bytesOf(row.id)
		})));
	}
	open(id, how = "claim") {
		return this.leaving.inTurn(() => this.opened(id, how));
	}
	async opened(id, how) {
		await this.settle();
		const show = await this.read(id, how);
		if (show === null) return;
		this.leaving.leave();
		await this.settle();
		for (const keepable of this.keepables) keepable.clear();
		await this.shown(show);
		this.written.mode = this.mode.now();
	}
	async shown(show) {
		try {
			show();
		} catch (error) {
			const { project } = this.keeping.state;
			this.keeping.dispatch({ project: "" });
			for (const keepable of this.keepables) keepable.clear();
			await this.begin();
			this.keeping.dispatch({ trouble: {
				kind: "unreadable",
				reason: messageOf(error),
				project: {
					id: project,
					title: say("the-project")
				}
			} });
		}
	}
	anew() {
		return this.leaving.inTurn(() => this.begun());
	}
	left() {
		return this.leaving.left();
	}
	stays() {
		return this.leaving.stays();
	}
	async begun() {
		this.leaving.leave();
		await this.settle();
		await this.begin();
		for (const keepable of this.keepables) keepable.clear();
		this.keeping.dispatch({ trouble: null });
	}
	putAside(part) {
		const { count } = this.leaving;
		return this.leaving.inTurn(async () => count !== this.leaving.count || this.putsAside(part));
	}
	async putsAside(part) {
		await this.settle();
		if (this.written.isNew || !isKept(this.keeping.state)) return false;
		if (this.keepables.some((keepable) => keepable.mode !== part.mode && keepable.parts().size > 0)) return this.separate(part);
		await this.begin();
		return true;
	}
	async separate(part) {
		const { project, name } = this.keeping.state;
		const { mode } = part;
		const parts = [...part.parts().keys()];
		const takesName = mode === "block";
		const row = {
			id: randomName(),
			form: 1,
			name: takesName ? name : null,
			images: part.images(),
			mode,
			changed: Date.now(),
			writer: this.tab
		};
		try {
			if (this.database !== null) await this.written.ensure(this.database, project, this.tab);
			await this.database?.separate(project, row, parts);
		} catch (error) {
			this.failed(error, project);
			return false;
		}
		this.written.forget(parts);
		if (takesName) this.keeping.dispatch({ name: null });
		this.later();
		return true;
	}
	keepAsNew() {
		return this.leaving.inTurn(async () => {
			await this.begin();
			this.keeping.dispatch({ trouble: null });
			await this.flush();
		});
	}
	async rename(id, name) {
		await this.database?.rename(id, name);
		if (id === this.keeping.state.project) this.keeping.dispatch({ name });
	}
	async duplicate(id, name) {
		await this.flush();
		await this.database?.duplicate(id, {
			id: randomName(),
			name,
			changed: Date.now()
		});
	}
	async remove(id) {
		if (await this.claims.elsewhere(id)) throw new Error(say("another-tab-has-this-project"));
		if (id === this.keeping.state.project) await this.anew();
		await this.database?.remove(id);
	}
	async partsOf(id) {
		return await this.database?.parts(id) ?? new Map();
	}
	dismiss() {
		this.keeping.dispatch({ trouble: null });
	}
	async settle() {
		await Promise.all(this.keepables.map((keepable) => keepable.settled?.()));
		await this.flush();
	}
	flush() {
		window.clearTimeout(this.timer);
		this.timer = void 0;
		this.saving = this.saving.then(() => this.save());
		return this.saving;
	}
	closed() {
		this.written.doubt(this.tab);
		this.later();
	}
	later() {
		this.timer ??= window.setTimeout(() => void this.flush(), GATHER_MS);
	}
	async first(database) {
		const remembered = rememberedProject();
		const rows = await database.projects();
		const row = remembered === null ? rows[0] : rows.find(({ id }) => id === remembered);
		const nothing = () => {};
		if (row === void 0) return nothing;
		if (breaksOff(row.id)) {
			this.keeping.dispatch({ trouble: {
				kind: "broke-off",
				reason: "",
				project: {
					id: row.id,
					title: titleOf(row)
				}
			} });
			return nothing;
		}
		countBreak(row.id);
		window.setTimeout(forgetBreaks, CALM_MS);
		this.keeping.dispatch({ opening: titleOf(row) });
		return await this.read(row.id, "claim") ?? nothing;
	}
	async read(id, how) {
		const { database } = this;
		if (database === null) return null;
		const read = await this.reader.read(database, id, how, {
			held: () => this.claim,
			lost: () => this.lost(id)
		});
		if (read === null) return null;
		if ("kind" in read) {
			this.keeping.dispatch({ trouble: read });
			return null;
		}
		const { row, title, parts, claim, unnamed, shows } = read;
		const trouble = (kind) => ({
			kind,
			reason: unnamed?.message ?? "",
			project: {
				id,
				title
			}
		});
		const unwritten = unnamed === null ? null : trouble(unnamed.kind === "full" ? "no-room" : "failed");
		return () => {
			if (this.claim !== claim) this.claim?.release();
			this.claim = claim;
			this.written.opened(parts, unnamed === null ? null : row.writer);
			this.keeping.dispatch({
				project: id,
				name: row.name,
				trouble: claim === null ? trouble("reading") : unwritten
			});
			rememberProject(id);
			for (const show of shows) show();
			this.written.shown();
			this.mode.show(row.mode);
		};
	}
	async begin() {
		const project = randomName();
		this.claim?.release();
		this.claim = await this.claims.take(project, true, () => this.lost(project));
		this.written.begin();
		this.keeping.dispatch({
			project,
			name: null
		});
		if (this.database !== null) rememberProject(project);
	}
	lost(id) {
		if (id !== this.keeping.state.project) return;
		const taken = () => this.keeping.dispatch({ trouble: {
			kind: "taken",
			reason: "",
			project: {
				id,
				title: this.title()
			}
		} });
		this.flush().then(taken);
	}
	title() {
		return titleOf({
			name: this.keeping.state.name,
			images: this.images()
		});
	}
	images() {
		return this.keepables.map((keepable) => keepable.images()).find((images) => images.length > 0) ?? [];
	}
	async save() {
		const { database, keeping } = this;
		const { project, name, trouble } = keeping.state;
		if (database === null || project === "" || trouble?.kind === "taken" || trouble?.kind === "reading") return;
		const { put, drop } = this.written.changes();
		const mode = this.mode.now();
		const isSame = put.size === 0 && drop.length === 0 && (this.written.isNew || mode === this.written.mode);
		if (isSame && !this.written.isInDoubt) return;
		const row = {
			id: project,
			form: 1,
			name,
			images: this.images(),
			mode,
			changed: Date.now(),
			writer: this.tab
		};
		try {
			await this.written.ensure(database, project, this.tab);
			if (!isSame) await this.written.write(database, row, put, drop);
			this.written.mode = mode;
			if (endsWhenWritten(keeping.state)) keeping.dispatch({ trouble: null });
		} catch (error) {
			this.failed(error, project);
		}
	}
	failed(error, id) {
		const kind = error instanceof KeepError ? error.kind : "other";
		if (kind === "taken") {
			this.keeping.dispatch({ trouble: {
				kind: "taken",
				reason: "",
				project: {
					id,
					title: this.title()
				}
			} });
			return;
		}
		if (kind === "gone") {
			this.written.gone();
			rememberProject(id);
			this.later();
			return;
		}
		this.keeping.dispatch({ trouble: {
			kind: this.unkept(kind),
			reason: messageOf(error),
			project: {
				id,
				title: this.title()
			}
		} });
	}
	unkept(failure) {
		if (this.written.isGone) return "cleared";
		if (failure === "closed") return "closed";
		if (failure !== "full") return "failed";
		return this.written.isInDoubt && !this.written.isChanged() ? "no-room" : "full";
	}
};
// www/shared/files/late.ts
var LateKeepable = class {
	mode;
	load;
	part = null;
	changed = null;
	constructor(mode, load) {
		this.mode = mode;
		this.load = load;
	}
	arrive(part) {
		this.part = part;
		if (this.changed !== null) part.watch(this.changed);
	}
	watch(changed) {
		this.changed = changed;
		this.part?.watch(changed);
	}
	settled() {
		return this.part?.settled?.() ?? Promise.resolve();
	}
	parts() {
		return this.part?.parts() ?? new Map();
	}
	images() {
		return this.part?.images() ?? [];
	}
	async read(parts, looks) {
		if ([...parts.keys()].some((name) => name.startsWith(this.mode))) await this.load();
		return await this.part?.read(parts, looks) ?? (() => void 0);
	}
	clear() {
		this.part?.clear();
	}
};
// www/shared/panel/about-dialog.ts
function aboutDialog(name, { CRATES, LICENCES }) {
	const heading = h("h2", { id: "about-heading" }, name);
	const dialog = h("dialog", {
		class: "dialog",
		testid: "about-dialog",
		aria: { labelledby: heading.id }
	});
	const holds = LICENCES.map(({ name: of, version, licence, text }) => licenceOf(`licence-${of}`, `${of} ${version} (${licence})`, text));
	const crates = CRATES.crates.map(({ name: of, version, licence, text }) => licenceOf(`crate-${of}-${version}`, `${of} ${version} (${licence})`, CRATES.texts[text] ?? ""));
	const close = button(say("close-2"), "about-close", () => dialog.close());
	dialog.append(h("div", { class: "dialog-head" }, heading, close), h("p", {}, say("matches-and-orients-overlapping-photographs")), h("h3", {}, say("the-page-holds")), ...holds, h("h3", {}, say("its-module-holds")), h("details", {
		class: "group",
		testid: "crates"
	}, h("summary", {}, say("so-many-crates", { crates: crates.length })), ...crates));
	return dialog;
}
function licenceOf(testid, title, text) {
	const [name, own] = [h("bdi", {}, title), h("pre", { class: "licence" }, text)];
	for (const part of [name, own]) Object.assign(part, {
		lang: "en",
		dir: "ltr"
	});
	return h("details", {
		class: "group",
		testid
	}, h("summary", {}, name), own);
}
// www/shared/panel/version.ts
function nameVersion(press, version) {
	const name = `Tiepoint ${version}`;
	press.textContent = name;
	press.title = say("version-and-licences");
	const dialog = new LatePart(async () => {
		const made = aboutDialog(name, await loadPart("about.js", () => __vitePreload(() => import("./about.js"), [], import.meta.url)));
		document.body.append(made);
		return made;
	});
	press.addEventListener("click", () => {
		dialog.get().then((made) => {
			press.textContent = name;
			made.showModal();
		}, (error) => {
			press.textContent = `${name}: ${sentence(messageOf(error))}`;
		});
	});
}
// www/shared/files/rescue.ts
async function archiveOf(parts) {
	const archive = new Archive();
	for (const [part, value] of parts) for (const [name, content] of filesOf(part, value)) archive.add(name, await bytesOf(content), true);
	return archive.end();
}
function filesOf(part, value) {
	if (value instanceof Blob) return [[part, value]];
	const { project, file } = typeof value === "object" && value !== null ? value : {};
	const held = [];
	if (file instanceof Blob) held.push([`${part}/${file instanceof File ? file.name : "file"}`, file]);
	if (typeof project === "string" || project instanceof Blob) held.push([`${part}.tiepoint`, project]);
	const text = JSON.stringify(value, (name, one) => ArrayBuffer.isView(one) || name === "project" && typeof one === "string" ? void 0 : one);
	return [...held, [`${part}.json`, text ?? ""]];
}
async function bytesOf(content) {
	if (typeof content === "string") return new TextEncoder().encode(content);
	try {
		return new Uint8Array(await content.arrayBuffer());
	} catch (error) {
		return new TextEncoder().encode(String(error));
	}
}
// www/shared/panel/keeping.ts
function mountKeeping(host, keeper, actions) {
	keeper.keeping.watch(["trouble"], ([trouble]) => {
		const held = host.contains(document.activeElement);
		host.hidden = trouble === null;
		fill(host, ...trouble === null ? [] : [h("p", {}, textOf(trouble)), ...buttonsFor(trouble, keeper, actions)]);
		if (held) byId("projects").focus();
	});
}
function textOf({ kind, reason, project }) {
	const title = `“${project?.title ?? ""}”`;
	switch (kind) {
		case "absent": return say("this-browser-keeps-nothing-of", { reason });
		case "no-room": return say("the-storage-is-full-and-is", { title });
		case "full": return say("the-storage-of-this-browser");
		case "failed": return say("the-last-changes-could-not", { reason });
		case "closed": return say("the-browser-has-closed-its", { reason });
		case "cleared": return say("what-this-browser-had-kept", {
			title,
			reason
		});
		case "elsewhere": return say("is-open-in-another-tab", { title });
		case "reading": return say("is-open-in-another-tab-this", { title });
		case "taken": return say("another-tab-has-taken-over", { title });
		case "unreadable": return say("cannot-be-restored-it-stays", {
			title,
			reason
		});
		case "broke-off": return say("was-not-opened-the-page", { title });
	}
}
function buttonsFor({ kind, project }, keeper, { projects, saveFiles, saveProject }) {
	const id = project?.id ?? "";
	const take = () => void keeper.open(id, "steal");
	const look = () => void keeper.open(id, "look");
	const asNew = () => void keeper.keepAsNew();
	const list = button(say("projects"), "keeping-projects", projects);
	const close = button(say("close-2"), "keeping-close", () => keeper.dismiss());
	const asFile = button(say("save-the-project"), "keeping-save-project", () => saveProject("keeping-save-project"));
	switch (kind) {
		case "elsewhere": return [
			button(say("look-at-it"), "keeping-look", look),
			button(say("take-it-over"), "keeping-take", take),
			close
		];
		case "reading": return [
			button(say("show-the-latest"), "keeping-look", look, say("reads-again-what-the-other")),
			button(say("take-it-over"), "keeping-take", take, say("goes-on-with-the-project")),
			button(say("keep-this-as-a-new"), "keeping-new", asNew)
		];
		case "taken": return [button(say("take-it-back"), "keeping-take", take, say("shows-the-project-as-the")), button(say("keep-this-as-a-new"), "keeping-new", asNew)];
		case "unreadable": return [
			button(say("save-its-files"), "keeping-save", () => saveFiles(id)),
			list,
			close
		];
		case "broke-off": return [
			button(say("open-it"), "keeping-open", () => void keeper.open(id)),
			button(say("save-its-files"), "keeping-save", () => saveFiles(id)),
			close
		];
		case "no-room":
		case "full": return [
			list,
			asFile,
			close
		];
		case "failed":
		case "closed":
		case "cleared": return [asFile, close];
		default: return [close];
	}
}
// www/shared/panel/projects.ts
var DATE = new Intl.DateTimeFormat(LANGUAGE === "en" ? "en-GB" : `${LANGUAGE}-u-nu-latn`, {
	dateStyle: "medium",
	timeStyle: "short"
});
function mountProjects(keeper, saveProject) {
	const anew = byId("anew");
	const press = byId("projects");
	const list = new ProjectList(keeper);
	document.body.append(list.dialog);
	anew.addEventListener("click", () => {
		if (mayLeave(keeper)) keeper.anew();
	});
	press.addEventListener("click", () => void list.open());
	mountKeeping(byId("keeping"), keeper, {
		projects: () => void list.open(),
		saveFiles: (project) => void saveFiles(keeper, project, "tiepoint-project"),
		saveProject
	});
	keeper.keeping.watch(["works", "project"], ([works, project]) => {
		anew.disabled = project === "";
		press.disabled = !works || project === "";
	});
}
function mayLeave({ isLost }) {
	return !isLost || window.confirm(say("the-last-changes-on-the"));
}
async function saveFiles(keeper, project, name) {
	save(await archiveOf(await keeper.partsOf(project)), `${name}.zip`);
}
var ProjectList = class {
	keeper;
	dialog;
	rows = h("ul", {
		class: "projects",
		testid: "project-list"
	});
	room = h("p", {
		class: "note",
		testid: "project-room"
	});
	problem = h("p", {
		class: "field-problem",
		role: "alert",
		testid: "project-problem"
	});
	stay = button(say("ask-the-browser-never-to"), "project-persist", () => void this.attempt(() => this.persist()));
	constructor(keeper) {
		this.keeper = keeper;
		const close = button(say("close-2"), "projects-close", () => this.dialog.close());
		const anew = button(say("new-project"), "project-new", () => void this.leave(() => keeper.anew()));
		anew.className = "primary";
		const heading = h("h2", { id: "projects-heading" }, say("projects-2"));
		const note = h("p", { class: "note" }, say("this-browser-keeps-each-project"));
		const foot = h("div", { class: "buttons" }, this.stay, close);
		this.dialog = h("dialog", {
			class: "dialog",
			testid: "projects-dialog",
			aria: { labelledby: heading.id }
		});
		this.dialog.append(h("div", { class: "dialog-head" }, heading, anew), note, this.rows, this.problem, this.room, foot);
	}
	async open() {
		this.problem.textContent = "";
		await this.attempt(() => this.show());
		if (!this.dialog.open) this.dialog.showModal();
	}
	async leave(action) {
		if (mayLeave(this.keeper) && await this.attempt(action)) this.dialog.close();
	}
	async attempt(action) {
		this.problem.textContent = "";
		try {
			await action();
			return true;
		} catch (error) {
			this.problem.textContent = sentence(messageOf(error));
			return false;
		}
	}
	async change(action, focus) {
		await this.attempt(async () => {
			await action();
			await this.show(focus);
		});
	}
	async show(focus) {
		const projects = await this.keeper.projects();
		const none = h("li", { class: "note" }, say("nothing-is-kept-yet"));
		fill(this.rows, ...projects.length === 0 ? [none] : projects.map((row) => this.row(row)));
		if (focus !== void 0) (this.rows.querySelector(`[data-testid="${focus()}"]`) ?? this.dialog.querySelector("button"))?.focus();
		await this.showRoom(projects);
	}
	async showRoom(projects) {
		const own = projects.reduce((sum, { bytes }) => sum + bytes, 0);
		const storage = navigator.storage;
		const { usage = 0, quota = 0 } = await storage?.estimate().catch(() => void 0) ?? {};
		const left = quota > usage ? say("about-are-left", { quota: sizeText(quota - usage) }) : "";
		const persisted = await storage?.persisted?.().catch(() => false) ?? false;
		this.stay.hidden = storage === void 0 || persisted || projects.length === 0;
		const may = persisted ? "" : say("the-browser-may-clear-it");
		this.room.textContent = say("the-projects-take-about", {
			own: sizeText(own),
			left,
			may
		});
	}
	async persist() {
		if (!await navigator.storage.persist()) throw new Error(say("the-browser-does-not-promise"));
		await this.show();
	}
	row(row) {
		const { id } = row;
		const title = titleOf(row);
		const current = id === this.keeper.keeping.state.project;
		const open = button(title, `project-open-${id}`, () => void this.leave(() => current ? Promise.resolve() : this.keeper.open(id)), say("open-this-project"));
		open.className = "link";
		const parts = [
			say("so-many-images", { images: row.images.length }),
			sizeText(row.bytes),
			DATE.format(row.changed)
		].flatMap((text) => [" · ", h("bdi", {}, text)]).slice(1);
		const facts = h("span", { class: "note" }, ...parts, current ? say("on-the-page") : "");
		const named = (text, what, action) => {
			const made = button(text, `project-${what}-${id}`, action);
			made.setAttribute("aria-label", `${text}: ${title}`);
			return made;
		};
		const element = h("li", {
			testid: "project",
			...current ? { aria: { current: "true" } } : {}
		});
		const buttons = h("div", { class: "buttons" }, named(say("rename"), "rename", () => this.rename(element, row)), named(say("duplicate"), "duplicate", () => void this.change(() => this.keeper.duplicate(id, say("copy", { title })), () => `project-duplicate-${id}`)), named(say("save-files"), "save", () => void this.attempt(() => saveFiles(this.keeper, id, "tiepoint-project"))), named(say("delete"), "delete", () => this.confirm(element, row)));
		element.append(h("div", { class: "project-name" }, open, facts), buttons);
		return element;
	}
	rename(element, { id, ...row }) {
		const input = h("input", {
			type: "text",
			testid: "project-name",
			aria: { label: say("new-name-of", { row: titleOf(row) }) }
		});
		input.value = titleOf(row);
		const take = () => {
			const name = input.value.trim();
			this.change(() => this.keeper.rename(id, name === "" ? null : name), () => `project-rename-${id}`);
		};
		const cancel = () => void this.change(() => Promise.resolve(), () => `project-rename-${id}`);
		input.addEventListener("keydown", (event) => {
			if (event.key === "Enter") take();
			if (event.key !== "Escape") return;
			event.preventDefault();
			cancel();
		});
		fill(element, input, h("div", { class: "buttons" }, button(say("rename"), "project-name-take", take), button(say("cancel"), "project-name-cancel", cancel)));
		input.focus();
		input.select();
	}
	confirm(element, row) {
		const keep = button(say("keep"), "project-keep", () => void this.change(() => Promise.resolve(), () => `project-delete-${row.id}`));
		const remove = button(say("delete"), "project-delete", () => void this.change(() => this.keeper.remove(row.id), () => ""));
		const question = h("p", { role: "alert" }, say("delete-with-its-images-and", { row: titleOf(row) }));
		fill(element, question, h("div", { class: "buttons" }, remove, keep));
		keep.focus();
	}
};
// www/shared/panel/releases.ts
function mountReleases(host, keeper) {
	const tell = (text, ...buttons) => {
		fill(host, h("p", {}, text), ...buttons);
		host.hidden = false;
	};
	const reload = () => void keeper.flush().then(() => location.reload());
	const ready = (take) => {
		const update = button(say("update"), "update-take", () => void keeper.flush().then(() => keeper.isLost ? lose(take) : take()));
		tell(say("a-new-version-of-tiepoint"), update, button(say("later"), "update-later", () => {
			host.hidden = true;
		}));
	};
	const lose = (take) => {
		tell(say("the-last-changes-on-the-page"), button(say("update-all-the-same"), "update-take", take));
	};
	const replaced = () => {
		keeper.flush().then(() => {
			if (!keeper.isLost) location.reload();
			else tell(say("another-tab-has-updated-tiepoint"), button(say("load-again"), "update-reload", reload));
		});
	};
	keepRelease({
		ready,
		replaced
	}).catch(() => void 0);
}
// www/shared/panel/theme.ts
var NEXT = {
	auto: "light",
	light: "dark",
	dark: "auto"
};
var NAME = "tiepoint-theme";
function mountTheme(button) {
	const show = (theme) => {
		document.documentElement.dataset.theme = theme;
		button.textContent = {
			auto: say("theme-auto"),
			light: say("theme-light"),
			dark: say("theme-dark")
		}[theme] ?? say("theme");
	};
	const saved = keptChoice(NAME);
	show(saved !== null && saved in NEXT ? saved : "auto");
	button.addEventListener("click", () => {
		const theme = NEXT[document.documentElement.dataset.theme ?? "auto"] ?? "auto";
		show(theme);
		keepChoice(NAME, theme);
	});
}
// www/program.ts
var START_BYTES = 1024;
var keeping = null;
async function startProgram(serveDrop) {
	mountTheme(byId("theme"));
	mountLanguage(byId("language"), () => keeping);
	mountActions(byId("actions"));
	mountMenu(byId("menu"), byId("bar-menu"));
	const opening = Database.open();
	opening.catch(() => void 0);
	try {
		await startParts(opening, serveDrop);
	} catch (error) {
		byId("answer").dataset.kind = "problem";
		byId("status").textContent = messageOf(error);
	}
}
async function startParts(opening, serveDrop) {
	const catalogue = await loadCatalogue();
	checkRules(catalogue.rules);
	nameVersion(byId("about"), catalogue.version);
	await breath();
	const modes = makeModes();
	const takers = [];
	const pair = await mountPair(catalogue, {
		openProject,
		toBlock,
		toGround,
		sampleBlock,
		putAside: (kept) => keeper.putAside(kept),
		left: () => keeper.left()
	});
	showIn(modes, "pair", [...document.querySelectorAll(".bar .actions, .bar .drawers, body > main")]);
	document.querySelector(".bar h1")?.after(modeSwitch(modes, (mode) => void show(mode)));
	await breath();
	const blocks = new LatePart(async () => {
		const block = await loadBlock(catalogue, pair, {
			modes,
			openProject,
			putAside: (kept) => keeper.putAside(kept),
			left: () => keeper.left(),
			stays: () => keeper.stays()
		});
		keptBlock.arrive(block.kept);
		takers.unshift(block.taker);
		return block;
	});
	beforeSearch(() => blocks.get());
	const keptBlock = new LateKeepable("block", () => blocks.get());
	async function withBlock(act) {
		const block = await blocks.get().catch((error) => {
			pair.store.dispatch({
				type: "notice",
				notice: {
					kind: "problem",
					text: say("the-block-was-not-loaded", { error: sentence(messageOf(error)) })
				}
			});
		});
		if (block !== void 0) await act(block);
	}
	async function show(mode, isKept = false) {
		const to = isKept ? { kept: mode } : mode;
		if (mode === "pair") modes.dispatch(to);
		else await withBlock(() => modes.dispatch(to));
	}
	const inBlock = (act) => withBlock(async (block) => {
		modes.dispatch("block");
		await act(block);
	});
	async function openProject(file) {
		await keeper.left();
		const mode = project_kind(new Uint8Array(await file.slice(0, START_BYTES).arrayBuffer())) ?? modes.state.mode;
		if (mode === "block") return inBlock((block) => block.open(file));
		modes.dispatch(mode);
		await pair.open(file);
	}
	function toBlock(files, masks) {
		inBlock((block) => block.give(files, masks));
	}
	async function toGround(found) {
		if (!await hasGround(found)) return false;
		await inBlock((block) => block.taker.take(found, null));
		return true;
	}
	function sampleBlock() {
		inBlock((block) => block.sample());
	}
	const keeper = new Keeper([keptBlock, pair.kept], {
		now: () => modes.state.mode,
		show: (kept) => {
			if (isMode(kept)) show(kept, true);
		},
		watch: (changed) => modes.watch(["mode"], changed)
	});
	keeping = keeper;
	mountProjects(keeper, (near) => modes.state.mode === "pair" ? void pair.save(near) : void withBlock((block) => block.save(near)));
	sayOpening(keeper, pair);
	await keeper.start(opening, () => {
		pair.store.dispatch({
			type: "ready",
			catalogue
		});
		return breath();
	});
	pair.begin();
	takers.push(pair.taker);
	serveDrop(takers);
	watchLaunches(openProject);
	mountReleases(byId("update"), keeper);
}
function sayOpening(keeper, { store }) {
	let said = null;
	keeper.keeping.watch(["opening"], ([title]) => {
		document.body.classList.toggle("is-opening", title !== null);
		if (title === null && (said === null || store.state.notice !== said)) return;
		said = title === null ? null : {
			kind: "info",
			text: say("opening-kept-work", { title })
		};
		store.dispatch({
			type: "notice",
			notice: said
		});
	});
}
async function loadBlock(catalogue, pair, elsewhere) {
	await learnPart("block");
	const { blockCatalogue, masksOf, matchesOf, mountBlock, openPair, scansBeside } = await loadPart("block.js", () => __vitePreload(() => import("./block.js"), [], import.meta.url));
	const ofBlocks = blockCatalogue(catalogue);
	const projects = {
		putAside: () => elsewhere.putAside(pair.kept),
		stays: elsewhere.stays
	};
	const block = await mountBlock(ofBlocks, {
		...elsewhere,
		pair: {
			names: () => [pair.store.state.images.left?.name ?? null, pair.store.state.images.right?.name ?? null],
			masks: () => masksOf(pair.store.state),
			matches: () => matchesOf(pair.store.state),
			watch: (changed) => pair.store.watch(["images", "masks"], changed),
			watchMatches: (changed) => pair.store.watch(["results", "history"], changed)
		},
		openPair: (store, images) => openPair(store, elsewhere.modes, pair, projects, images),
		scans: (store) => scansBeside(store, elsewhere.modes, pair, projects)
	});
	block.store.dispatch({
		type: "ready",
		catalogue: ofBlocks
	});
	return block;
}
export { ACCEPTED, Archive, BY_HAND, CANDIDATE, CallError, Cancelled, EPIPOLAR, GEO_KEYS, Holder, IMAGE_FILE, Journal$1 as Journal, Layers, MASK_SIDE, MEASURED, MODEL_TYPE, NO_HISTORY, NotListed, OWN_LIGHT, OWN_SETTINGS, PointGrid, REDO_KEYS, REJECTED$1 as REJECTED, REJECTED_BY_HAND, RESIDUAL, RESIDUAL_REJECTED, SCALE, SELECTED, SHAPES, SIDES, TIES, TRANSFORMATION, Table, UNDO_KEYS, WorkerClient, WorkerPool, acting_block_parameters, affine, answerCard, asGiven, beforeSearch, block_flight_parameters, block_flight_preset, block_parameters, block_settings, breakdownOf, breath, byKeys, byReason, call_parameters, cameraFrom, carried_steps, check_cameras, check_control, check_geoid, choice, clamped, contains, crosshair, crossing, declare, declareLack, declarePlace, doHere, doneFrom, drawCross, drawExpected, drawLine, drawView, draw_points, draw_vectors, drawerButton, facts, fieldsOf, fileButton, film_cameras, film_measurements, film_pattern, firstNamed, fitView, fitted$1 as fitted, fitted$2 as fitted$1, geoKeys, geographic_positions, halfSize, hasData, hasKeys, image_measurement_table, inPane, interior$1 as interior, inverse, isCurrent, isHidden, isMeasured$1 as isMeasured, isMode, isNothing, isOpen, isWhole$1 as isWhole, isWorthKeeping, keeping$1 as keeping, kindsText, labelled, lensFrame, lensRect, lensTransform, likeOf, lineSwatch, listOf$1 as listOf, listen, listenKeys, local_positions, makeFolded, makeLight, makeNear, makeSections, mapped, maskOf, masks_of_images, message, messageOf, mountMenu, movedWith, nameOf$1 as nameOf, namesText, numberInput, numbers$2 as numbers, objectOf, ofLine, onLine, optionInLanguage, orNull, orient_fiducials, otherSide, paintBitmap, panned, parse_camera, parse_camera_rules, parse_fiducials, parse_ground_control_points, parse_image_measurements, parse_image_positions, passFocus, photo_camera, placeOfLeft, placeOfMark, placed_tables, placesByHand, placing_defaults, placing_parameters, positionFrom, positions_of_images, problemLine, readable, recorded, refusedKinds, remember, rememberCalibrations, resized, reveal, reveal$1, ring, roundedPx, save, saveCsv, set, setDrawer, settingsText, showHistory, showIn, showSteps, showTab, shownPair, sidewaysNote, smooth, sortRasters, standingOf, startProgram, swatch, system_coordinates, system_positions, tabbed, takeHere, targetOfLeft, textIn, tiffDirectory, titleOf, toCanvas, toPosition, toggle, transformOf, typed, uncoverPictures, undoKeys, unfolded, unitText, unlessLeft, vectorChoice, visiblePart, wantedLevel, watchDrawers, watchSideways, wentTo, whenInSight, withCoordinatesOf, withSetting, withUnit, within, words, zoomButtons, zoomed, zoomedAbout };
