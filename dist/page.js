// pkg/wasm/tiepoint.js
/**
* The scene below a simulated block in wasm memory. Call `free` when it is no longer needed.
*/
var BlockScene = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		BlockSceneFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		wasm.__wbg_blockscene_free(ptr, 0);
	}
	/**
	* Builds the scene of a flight; parameters that are absent take their defaults.
	* @param {Given<BlockFlight>} flight
	*/
	constructor(flight) {
		const ret = wasm.blockscene_new(flight);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		this.__wbg_ptr = ret[0];
		BlockSceneFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	/**
	* The orthophoto of all that the photos show and the heights of its surface, as GeoTIFF files; `gsd_m` is the side of a pixel.
	* @param {number} gsd_m
	* @returns {{ picture: Uint8Array; heights: Uint8Array }}
	*/
	orthophoto(gsd_m) {
		const ret = wasm.blockscene_orthophoto(this.__wbg_ptr, gsd_m);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* Takes a photo.
	* @param {number} index
	* @returns {SampleImage}
	*/
	photo(index) {
		const ret = wasm.blockscene_photo(this.__wbg_ptr, index);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* Takes a photo as a PNG file, with its camera and recorded position as EXIF.
	* @param {number} index
	* @returns {Uint8Array}
	*/
	photo_file(index) {
		const ret = wasm.blockscene_photo_file(this.__wbg_ptr, index);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	/**
	* How many photos the flight takes.
	* @returns {number}
	*/
	get photos() {
		return wasm.blockscene_photos(this.__wbg_ptr) >>> 0;
	}
	/**
	* Places x, y, z in m on the first surface that a photo sees at positions x, y in px (stride 2); stride 3.
	* @param {number} index
	* @param {Float64Array | number[]} positions
	* @returns {Float64Array}
	*/
	surface_at(index, positions) {
		const val2 = +index;
		const ptr0 = passArrayF64ToWasm0(positions, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.blockscene_surface_at(this.__wbg_ptr, val2, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* The true cameras and exterior orientations.
	* @returns {BlockModel}
	*/
	truth() {
		return wasm.blockscene_truth(this.__wbg_ptr);
	}
};
if (Symbol.dispose) BlockScene.prototype[Symbol.dispose] = BlockScene.prototype.free;
/**
* The files of a block, of which each step writes some.
*/
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
		wasm.__wbg_blockwriting_free(ptr, 0);
	}
	/**
	* Writes the next files; gives the summary after the last one, null before.
	* @param {Emit} emit
	* @returns {Summary | null}
	*/
	step(emit) {
		const ret = wasm.blockwriting_step(this.__wbg_ptr, emit);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) BlockWriting.prototype[Symbol.dispose] = BlockWriting.prototype.free;
/**
* A block that was run, or opened from its project file; its owner frees it.
*/
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
		wasm.__wbg_finishedblock_free(ptr, 0);
	}
	/**
	* Writes it in one format.
	* @param {ExportFormat} format
	* @param {Emit} emit
	*/
	export(format, emit) {
		const ret = wasm.finishedblock_export(this.__wbg_ptr, format, emit);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	/**
	* All its files, in steps of about one. `score`: what the summary holds of a simulated block.
	* @param {readonly ExportFormat[]} formats
	* @param {BlockScore | null} [score]
	* @returns {BlockWriting}
	*/
	files(formats, score) {
		const ret = wasm.finishedblock_files(this.__wbg_ptr, formats, score);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return BlockWriting.__wrap(ret[0]);
	}
	/**
	* The model that is written.
	* @returns {BlockModel}
	*/
	model() {
		return wasm.finishedblock_model(this.__wbg_ptr);
	}
	/**
	* Opens a project file; one that is damaged or of another kind is refused whole.
	* @param {Uint8Array | number[]} bytes
	* @returns {FinishedBlock}
	*/
	static open(bytes) {
		const ptr0 = passArray8ToWasm0(bytes, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.finishedblock_open(ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return FinishedBlock.__wrap(ret[0]);
	}
	/**
	* What is shown of it.
	* @returns {BlockOverview & { points: PointColumns }}
	*/
	overview() {
		const ret = wasm.finishedblock_overview(this.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* The text of its project file.
	* @returns {string}
	*/
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
	/**
	* How near a simulated block is to its truth.
	* @param {BlockModel} truth
	* @returns {BlockScore}
	*/
	score(truth) {
		const ret = wasm.finishedblock_score(this.__wbg_ptr, truth);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) FinishedBlock.prototype[Symbol.dispose] = FinishedBlock.prototype.free;
/**
* A quick orthomosaic of an oriented block in wasm memory: each place is taken from the image whose projection centre is nearest in plan. Call
* `free` when it is no longer needed.
*/
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
		wasm.__wbg_orthomosaic_free(ptr, 0);
	}
	/**
	* Adds an image, by its index; one that is not oriented adds nothing.
	* @param {number} index
	* @param {Uint8Array | number[]} file
	*/
	add(index, file) {
		const val2 = +index;
		const ptr0 = passArray8ToWasm0(file, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.orthomosaic_add(this.__wbg_ptr, val2, ptr0, len0);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	/**
	* The mosaic, grey, as GeoTIFF.
	* @returns {Uint8Array}
	*/
	finish() {
		const ptr = this.__destroy_into_raw();
		const ret = wasm.orthomosaic_finish(ptr);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	/**
	* The names of the block's images.
	* @returns {string[]}
	*/
	get names() {
		const ret = wasm.orthomosaic_names(this.__wbg_ptr);
		var v1 = getArrayJsValueFromWasm0(ret[0], ret[1]);
		wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
		return v1;
	}
	/**
	* Lays it out for the block of a project file. `heights`: one height for all or a file; null: those of the tie points. `gsd`: the side of a
	* pixel; absent: that of the images.
	* @param {Uint8Array | number[]} project
	* @param {number | Uint8Array | null} heights
	* @param {string | null} [heights_world_file]
	* @param {number | null} [gsd]
	* @returns {OrthoMosaic}
	*/
	static open(project, heights, heights_world_file, gsd) {
		const val3 = +(isLikeNone(gsd) ? 0 : gsd);
		let ptr0, len0, ptr1, len1;
		try {
			ptr0 = passArray8ToWasm0(project, wasm.__wbindgen_malloc);
			len0 = WASM_VECTOR_LEN;
			ptr1 = isLikeNone(heights_world_file) ? 0 : passStringToWasm0(heights_world_file, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
			len1 = WASM_VECTOR_LEN;
		} catch (e) {
			if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
			if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
			throw e;
		}
		const ret = wasm.orthomosaic_open(ptr0, len0, heights, ptr1, len1, !isLikeNone(gsd), val3);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return OrthoMosaic.__wrap(ret[0]);
	}
};
if (Symbol.dispose) OrthoMosaic.prototype[Symbol.dispose] = OrthoMosaic.prototype.free;
/**
* An orthophoto with the heights of its ground in wasm memory, on which images are placed. Call `free` when it is no longer needed.
*/
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
		wasm.__wbg_orthophotoreference_free(ptr, 0);
	}
	/**
	* Size, place and heights.
	* @returns {OrthophotoInfo}
	*/
	info() {
		return wasm.orthophotoreference_info(this.__wbg_ptr);
	}
	/**
	* Reads a GeoTIFF, or an image with its world file. Its ground is level at 0 until heights are given.
	* @param {Uint8Array | number[]} file
	* @param {string | null} [world_file]
	* @returns {OrthophotoReference}
	*/
	static open(file, world_file) {
		let ptr0, len0, ptr1, len1;
		try {
			ptr0 = passArray8ToWasm0(file, wasm.__wbindgen_malloc);
			len0 = WASM_VECTOR_LEN;
			ptr1 = isLikeNone(world_file) ? 0 : passStringToWasm0(world_file, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
			len1 = WASM_VECTOR_LEN;
		} catch (e) {
			if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
			if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
			throw e;
		}
		const ret = wasm.orthophotoreference_open(ptr0, len0, ptr1, len1);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return OrthophotoReference.__wrap(ret[0]);
	}
	/**
	* Places an image. Its camera is that of `cameras`, the text of a file of cameras as blocks take it, whose pattern its name fits, or that
	* of its EXIF and XMP, or a usual one.
	* @param {string} name
	* @param {Uint8Array | number[]} file
	* @param {string | null} [cameras]
	* @returns {PlacedImage}
	*/
	place(name, file, cameras) {
		let ptr0, len0, ptr1, len1, ptr2, len2;
		try {
			ptr0 = passStringToWasm0(name, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
			len0 = WASM_VECTOR_LEN;
			ptr1 = passArray8ToWasm0(file, wasm.__wbindgen_malloc);
			len1 = WASM_VECTOR_LEN;
			ptr2 = isLikeNone(cameras) ? 0 : passStringToWasm0(cameras, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
			len2 = WASM_VECTOR_LEN;
		} catch (e) {
			if (ptr2) wasm.__wbindgen_free(ptr2, len2 * 1, 1);
			if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
			if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
			throw e;
		}
		const ret = wasm.orthophotoreference_place(this.__wbg_ptr, ptr0, len0, ptr1, len1, ptr2, len2);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* A placed image resampled to the ground, grey, as GeoTIFF.
	* @param {Uint8Array | number[]} file
	* @param {Placement} placement
	* @returns {Uint8Array}
	*/
	rectified(file, placement) {
		const ptr0 = passArray8ToWasm0(file, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.orthophotoreference_rectified(this.__wbg_ptr, ptr0, len0, placement);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v2 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v2;
	}
	/**
	* How images are placed; those that are absent take their defaults. Finds the points of the orthophoto among which images are sought, and
	* gives how many they are.
	* @param {Given<PlacingOptions>} options
	* @returns {number}
	*/
	search(options) {
		const ret = wasm.orthophotoreference_search(this.__wbg_ptr, options);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] >>> 0;
	}
	/**
	* The heights of its ground: one for all, or a file, a GeoTIFF or an ESRI ASCII grid, with its world file perhaps.
	* @param {number | Uint8Array} heights
	* @param {string | null} [world_file]
	*/
	set_heights(heights, world_file) {
		var ptr0 = isLikeNone(world_file) ? 0 : passStringToWasm0(world_file, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
		var len0 = WASM_VECTOR_LEN;
		const ret = wasm.orthophotoreference_set_heights(this.__wbg_ptr, heights, ptr0, len0);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) OrthophotoReference.prototype[Symbol.dispose] = OrthophotoReference.prototype.free;
/**
* A grey image in wasm memory. Call `free` when it is no longer needed.
*/
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
		wasm.__wbg_photo_free(ptr, 0);
	}
	/**
	* Decodes a JPEG, PNG, TIFF, BMP, PNM or WebP file.
	* @param {Uint8Array | number[]} bytes
	* @returns {Photo}
	*/
	static decode(bytes) {
		const ptr0 = passArray8ToWasm0(bytes, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.photo_decode(ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return Photo.__wrap(ret[0]);
	}
	/**
	* Describes points (stride 3) by the seven numbers each that a strategy compares; NaN where a window leaves the image or is constant.
	* Empty for the strategies that compare grey values.
	* @param {Float64Array | number[]} point_list
	* @param {Given<WindowOptions>} window
	* @param {Strategy} strategy
	* @returns {Float64Array}
	*/
	describe(point_list, window, strategy) {
		const ptr0 = passArrayF64ToWasm0(point_list, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.photo_describe(this.__wbg_ptr, ptr0, len0, window, strategy);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v2 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v2;
	}
	/**
	* Finds interest points and describes them as the strategy of the settings needs it.
	* @param {Given<PairSettings>} settings
	* @param {Uint8Array | number[] | null} [mask]
	* @returns {DescribedPoints}
	*/
	describe_points(settings, mask) {
		var ptr0 = isLikeNone(mask) ? 0 : passArray8ToWasm0(mask, wasm.__wbindgen_malloc);
		var len0 = WASM_VECTOR_LEN;
		const ret = wasm.photo_describe_points(this.__wbg_ptr, settings, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* Finds interest points by the groups `points` and `multiscale` of the settings. Points whose pixel is 0 in the mask, of the image's size
	* and row by row, are left out.
	* @param {Given<PairSettings>} settings
	* @param {Uint8Array | number[] | null} [mask]
	* @returns {DetectedPoints}
	*/
	detect(settings, mask) {
		var ptr0 = isLikeNone(mask) ? 0 : passArray8ToWasm0(mask, wasm.__wbindgen_malloc);
		var len0 = WASM_VECTOR_LEN;
		const ret = wasm.photo_detect(this.__wbg_ptr, settings, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* Finds points distinct in position and scale and describes them by the gradients around them. Points whose pixel is 0 in the mask,
	* of the image's size and row by row, are left out.
	* @param {Given<FeatureOptions>} options
	* @param {Uint8Array | number[] | null} [mask]
	* @returns {Features}
	*/
	features(options, mask) {
		var ptr0 = isLikeNone(mask) ? 0 : passArray8ToWasm0(mask, wasm.__wbindgen_malloc);
		var len0 = WASM_VECTOR_LEN;
		const ret = wasm.photo_features(this.__wbg_ptr, options, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* Takes grey values 0..255, row by row.
	* @param {number} width
	* @param {number} height
	* @param {Uint8Array | number[]} grey
	* @returns {Photo}
	*/
	static from_grey(width, height, grey) {
		const val2 = +width;
		const val3 = +height;
		const ptr0 = passArray8ToWasm0(grey, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.photo_from_grey(val2, val3, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return Photo.__wrap(ret[0]);
	}
	/**
	* A copy of the grey values, row by row.
	* @returns {Uint8Array}
	*/
	grey() {
		const ret = wasm.photo_grey(this.__wbg_ptr);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	/**
	* @returns {number}
	*/
	get height() {
		return wasm.photo_height(this.__wbg_ptr) >>> 0;
	}
	/**
	* Size, format, camera and drone.
	* @returns {PhotoInfo}
	*/
	info() {
		return wasm.photo_info(this.__wbg_ptr);
	}
	/**
	* The image halved until its longer side is at most `max_side` px.
	* @param {number} max_side
	* @returns {ReducedImage}
	*/
	reduced(max_side) {
		return wasm.photo_reduced(this.__wbg_ptr, max_side);
	}
	/**
	* @returns {number}
	*/
	get width() {
		return wasm.photo_width(this.__wbg_ptr) >>> 0;
	}
	/**
	* The window around a pixel (column and row from 0) with its moments.
	* @param {number} col
	* @param {number} row
	* @param {Given<WindowOptions>} window
	* @returns {WindowReport}
	*/
	window_moments(col, row, window) {
		const ret = wasm.photo_window_moments(this.__wbg_ptr, col, row, window);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) Photo.prototype[Symbol.dispose] = Photo.prototype.free;
/**
* The report of a pair in the making: `step` until it says false, then `html`.
*/
var Report = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		ReportFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		wasm.__wbg_report_free(ptr, 0);
	}
	/**
	* The page, which holds everything it shows. Does the steps that are left.
	* @returns {string}
	*/
	html() {
		let deferred2_0;
		let deferred2_1;
		try {
			const ret = wasm.report_html(this.__wbg_ptr);
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
	/**
	* Takes copies of both images; `names` are what the report calls them. Points whose pixel is 0 in the mask of their image, of its size
	* and row by row, are left out.
	* @param {Photo} left
	* @param {Photo} right
	* @param {[string, string]} names
	* @param {Given<PairInput>} input
	* @param {Given<PairSettings>} settings
	* @param {ReportTruth | null} truth
	* @param {Uint8Array | number[] | null} [left_mask]
	* @param {Uint8Array | number[] | null} [right_mask]
	*/
	constructor(left, right, names, input, settings, truth, left_mask, right_mask) {
		_assertClass(left, Photo);
		_assertClass(right, Photo);
		let ptr0, len0, ptr1, len1;
		try {
			ptr0 = isLikeNone(left_mask) ? 0 : passArray8ToWasm0(left_mask, wasm.__wbindgen_malloc);
			len0 = WASM_VECTOR_LEN;
			ptr1 = isLikeNone(right_mask) ? 0 : passArray8ToWasm0(right_mask, wasm.__wbindgen_malloc);
			len1 = WASM_VECTOR_LEN;
		} catch (e) {
			if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
			if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
			throw e;
		}
		const ret = wasm.report_new(left.__wbg_ptr, right.__wbg_ptr, names, input, settings, truth, ptr0, len0, ptr1, len1);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		this.__wbg_ptr = ret[0];
		ReportFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	/**
	* Does the next step; false when all were done.
	* @returns {boolean}
	*/
	step() {
		const ret = wasm.report_step(this.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] !== 0;
	}
	/**
	* What each step does, in their order.
	* @returns {string[]}
	*/
	steps() {
		return wasm.report_steps(this.__wbg_ptr);
	}
};
if (Symbol.dispose) Report.prototype[Symbol.dispose] = Report.prototype.free;
/**
* The run of a block. Its host does the jobs of `next`, in any order and any number at the same time: it reads the files, asks `prepare`,
* looks for a kept record of the key, which goes to `found`, and else calls `execute_job`, keeps what comes of it and hands it to `complete`.
*/
var Run = class {
	__destroy_into_raw() {
		const ptr = this.__wbg_ptr;
		this.__wbg_ptr = 0;
		RunFinalization.unregister(this);
		return ptr;
	}
	free() {
		const ptr = this.__destroy_into_raw();
		wasm.__wbg_run_free(ptr, 0);
	}
	/**
	* Takes the bytes that came of a job.
	* @param {number} id
	* @param {Uint8Array | number[]} bytes
	*/
	complete(id, bytes) {
		const val2 = +id;
		const ptr0 = passArray8ToWasm0(bytes, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.run_complete(this.__wbg_ptr, val2, ptr0, len0);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	/**
	* Takes why a job could not be done: an image or a pair is left out with it, where these are to blame.
	* @param {number} id
	* @param {Failure} failure
	*/
	failed(id, failure) {
		const ret = wasm.run_failed(this.__wbg_ptr, id, failure);
		if (ret[1]) throw takeFromExternrefTable0(ret[0]);
	}
	/**
	* What the run has found; frees it.
	* @returns {FinishedBlock}
	*/
	finish() {
		const ptr = this.__destroy_into_raw();
		const ret = wasm.run_finish(ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return FinishedBlock.__wrap(ret[0]);
	}
	/**
	* Takes a kept record; one that does not read well is not taken, and the job is still to be done.
	* @param {number} id
	* @param {Uint8Array | number[]} record
	* @returns {boolean}
	*/
	found(id, record) {
		const val2 = +id;
		const ptr0 = passArray8ToWasm0(record, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.run_found(this.__wbg_ptr, val2, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0] !== 0;
	}
	/**
	* A run of which nothing is done; what can be refused before the images are read is refused here.
	* @param {Given<RunInput>} input
	*/
	constructor(input) {
		const ret = wasm.run_new(input);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		this.__wbg_ptr = ret[0];
		RunFinalization.register(this, this.__wbg_ptr, this);
		return this;
	}
	/**
	* What was found since the last call, and how far the stages are.
	* @returns {News[]}
	*/
	news() {
		return wasm.run_news(this.__wbg_ptr);
	}
	/**
	* Jobs that can be done now, at most so many. Where there are none, and none is under way, the run is over.
	* @param {number} most
	* @returns {Job[]}
	*/
	next(most) {
		const ret = wasm.run_next(this.__wbg_ptr, most);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	/**
	* What is to be done for a job whose files have these digests, SHA-256 in hexadecimal digits.
	* @param {number} id
	* @param {string[]} digests
	* @returns {Work}
	*/
	prepare(id, digests) {
		const val2 = +id;
		const ptr0 = passArrayJsValueToWasm0(digests, wasm.__wbindgen_malloc);
		const len0 = WASM_VECTOR_LEN;
		const ret = wasm.run_prepare(this.__wbg_ptr, val2, ptr0, len0);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
};
if (Symbol.dispose) Run.prototype[Symbol.dispose] = Run.prototype.free;
/**
* The keys of the options of a block that have an effect with these settings.
* @param {Given<BlockSettings>} settings
* @returns {string[]}
*/
function acting_block_parameters(settings) {
	const ret = wasm.acting_block_parameters(settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* The keys of the options of a pair that have an effect with these settings.
* @param {Given<PairSettings>} settings
* @returns {string[]}
*/
function acting_parameters(settings) {
	const ret = wasm.acting_parameters(settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* Every parameter of a block's flight on which photos depend.
* @returns {Parameter[]}
*/
function block_flight_parameters() {
	return wasm.block_flight_parameters();
}
/**
* A ready-made flight of a block.
* @param {BlockPreset} name
* @returns {BlockFlight}
*/
function block_flight_preset(name) {
	const ret = wasm.block_flight_preset(name);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* Every option of a block, in the order of the pipeline.
* @returns {Parameter[]}
*/
function block_parameters() {
	return wasm.block_parameters();
}
/**
* All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
* @param {Given<BlockSettings>} given
* @returns {BlockSettings}
*/
function block_settings(given) {
	const ret = wasm.block_settings(given);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* The camera of an EXIF block, with what is not known of it.
* @param {ExifCamera} exif
* @returns {CameraMm}
*/
function camera_of_exif(exif) {
	const ret = wasm.camera_of_exif(exif);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* Refuses a file of cameras that cannot be read, or fits no image of these names, where there are any.
* @param {string} text
* @param {string[]} names
*/
function check_cameras(text, names) {
	let ptr0, len0, ptr1, len1;
	try {
		ptr0 = passStringToWasm0(text, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
		len0 = WASM_VECTOR_LEN;
		ptr1 = passArrayJsValueToWasm0(names, wasm.__wbindgen_malloc);
		len1 = WASM_VECTOR_LEN;
	} catch (e) {
		if (ptr1) {
			wasm.__externref_drop_slice(ptr1, len1);
			wasm.__wbindgen_free(ptr1, len1 * 4, 4);
		}
		if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
		throw e;
	}
	const ret = wasm.check_cameras(ptr0, len0, ptr1, len1);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
/**
* Refuses ground control points and image measurements that a run of these images would refuse, as far as their names say.
* @param {string} points
* @param {string} marks
* @param {string[]} names
* @param {GeoreferencingOptions} placing
*/
function check_control(points, marks, names, placing) {
	let ptr0, len0, ptr1, len1, ptr2, len2;
	try {
		ptr0 = passStringToWasm0(points, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
		len0 = WASM_VECTOR_LEN;
		ptr1 = passStringToWasm0(marks, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
		len1 = WASM_VECTOR_LEN;
		ptr2 = passArrayJsValueToWasm0(names, wasm.__wbindgen_malloc);
		len2 = WASM_VECTOR_LEN;
	} catch (e) {
		if (ptr2) {
			wasm.__externref_drop_slice(ptr2, len2);
			wasm.__wbindgen_free(ptr2, len2 * 4, 4);
		}
		if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
		if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
		throw e;
	}
	const ret = wasm.check_control(ptr0, len0, ptr1, len1, ptr2, len2, placing);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
/**
* Refuses a flight that [`simulate`] refuses, without rendering it; parameters that are absent are those of the sample.
* @param {Given<Flight>} flight
*/
function check_flight(flight) {
	const ret = wasm.check_flight(flight);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
/**
* Refuses two masks of one image.
* @param {string[]} names
* @param {string[]} masks
*/
function check_masks(names, masks) {
	let ptr0, len0, ptr1, len1;
	try {
		ptr0 = passArrayJsValueToWasm0(names, wasm.__wbindgen_malloc);
		len0 = WASM_VECTOR_LEN;
		ptr1 = passArrayJsValueToWasm0(masks, wasm.__wbindgen_malloc);
		len1 = WASM_VECTOR_LEN;
	} catch (e) {
		if (ptr1) {
			wasm.__externref_drop_slice(ptr1, len1);
			wasm.__wbindgen_free(ptr1, len1 * 4, 4);
		}
		if (ptr0) {
			wasm.__externref_drop_slice(ptr0, len0);
			wasm.__wbindgen_free(ptr0, len0 * 4, 4);
		}
		throw e;
	}
	const ret = wasm.check_masks(ptr0, len0, ptr1, len1);
	if (ret[1]) throw takeFromExternrefTable0(ret[0]);
}
/**
* The same offset (right minus left position, px) everywhere.
* @param {number} dx
* @param {number} dy
* @returns {OffsetField}
*/
function constant_offset(dx, dy) {
	const ret = wasm.constant_offset(dx, dy);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* The defaults of all options.
* @returns {PairSettings}
*/
function defaults() {
	return wasm.defaults();
}
/**
* Draws the lines of matches whose two ends are both in view, from the left image's view to the right one's; returns how many.
*
* `matches`: stride 5, `x left, y left, x right, y right, measure` in px. `codes`: one a match, the index of its style; a code without
* a style is not drawn. `widths` and `colours`: one a style. Where more than `most` are in view, evenly many are drawn.
* @param {CanvasRenderingContext2D} context
* @param {Float64Array | number[]} matches
* @param {Uint8Array | number[]} codes
* @param {Float64Array | number[]} widths
* @param {string[]} colours
* @param {Float64Array | number[]} left_view
* @param {Float64Array | number[]} right_view
* @param {number} most
* @returns {number}
*/
function draw_match_lines(context, matches, codes, widths, colours, left_view, right_view, most) {
	const val7 = +most;
	let ptr0, len0, ptr1, len1, ptr2, len2, ptr3, len3, ptr4, len4, ptr5, len5;
	try {
		ptr0 = passArrayF64ToWasm0(matches, wasm.__wbindgen_malloc);
		len0 = WASM_VECTOR_LEN;
		ptr1 = passArray8ToWasm0(codes, wasm.__wbindgen_malloc);
		len1 = WASM_VECTOR_LEN;
		ptr2 = passArrayF64ToWasm0(widths, wasm.__wbindgen_malloc);
		len2 = WASM_VECTOR_LEN;
		ptr3 = passArrayJsValueToWasm0(colours, wasm.__wbindgen_malloc);
		len3 = WASM_VECTOR_LEN;
		ptr4 = passArrayF64ToWasm0(left_view, wasm.__wbindgen_malloc);
		len4 = WASM_VECTOR_LEN;
		ptr5 = passArrayF64ToWasm0(right_view, wasm.__wbindgen_malloc);
		len5 = WASM_VECTOR_LEN;
	} catch (e) {
		if (ptr5) wasm.__wbindgen_free(ptr5, len5 * 8, 8);
		if (ptr4) wasm.__wbindgen_free(ptr4, len4 * 8, 8);
		if (ptr3) {
			wasm.__externref_drop_slice(ptr3, len3);
			wasm.__wbindgen_free(ptr3, len3 * 4, 4);
		}
		if (ptr2) wasm.__wbindgen_free(ptr2, len2 * 8, 8);
		if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
		if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 8, 8);
		throw e;
	}
	const ret = wasm.draw_match_lines(context, ptr0, len0, ptr1, len1, ptr2, len2, ptr3, len3, ptr4, len4, ptr5, len5, val7);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return ret[0] >>> 0;
}
/**
* Draws points; returns how many were drawn.
*
* `points`: stride 3, `x, y, value` in px. `codes`: one a point, the index of its style; a code without a style is not drawn.
* `styles`: stride 3, `shape, half size, line width` in canvas units (shapes: 0 dot, 1 circle, 2 plus, 3 cross, 4 square,
* 5 triangle up, 6 triangle down, 7 diamond). `colours`: one CSS colour a style. `view`: see [`View::new`]. Styles are drawn in order,
* the last on top; where points crowd, some are left out.
* @param {CanvasRenderingContext2D} context
* @param {Float64Array | number[]} points
* @param {Uint8Array | number[]} codes
* @param {Float64Array | number[]} styles
* @param {string[]} colours
* @param {Float64Array | number[]} view
* @returns {number}
*/
function draw_points(context, points, codes, styles, colours, view) {
	let ptr0, len0, ptr1, len1, ptr2, len2, ptr3, len3, ptr4, len4;
	try {
		ptr0 = passArrayF64ToWasm0(points, wasm.__wbindgen_malloc);
		len0 = WASM_VECTOR_LEN;
		ptr1 = passArray8ToWasm0(codes, wasm.__wbindgen_malloc);
		len1 = WASM_VECTOR_LEN;
		ptr2 = passArrayF64ToWasm0(styles, wasm.__wbindgen_malloc);
		len2 = WASM_VECTOR_LEN;
		ptr3 = passArrayJsValueToWasm0(colours, wasm.__wbindgen_malloc);
		len3 = WASM_VECTOR_LEN;
		ptr4 = passArrayF64ToWasm0(view, wasm.__wbindgen_malloc);
		len4 = WASM_VECTOR_LEN;
	} catch (e) {
		if (ptr4) wasm.__wbindgen_free(ptr4, len4 * 8, 8);
		if (ptr3) {
			wasm.__externref_drop_slice(ptr3, len3);
			wasm.__wbindgen_free(ptr3, len3 * 4, 4);
		}
		if (ptr2) wasm.__wbindgen_free(ptr2, len2 * 8, 8);
		if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
		if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 8, 8);
		throw e;
	}
	const ret = wasm.draw_points(context, ptr0, len0, ptr1, len1, ptr2, len2, ptr3, len3, ptr4, len4);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return ret[0] >>> 0;
}
/**
* Draws vectors as arrows from their points, enlarged `factor` times; returns how many.
*
* `vectors`: stride 4, `x, y, dx, dy` in px of the image. `codes`: one a vector, the index of its style; a code without a style is not drawn.
* `widths` and `colours`: one a style.
* @param {CanvasRenderingContext2D} context
* @param {Float64Array | number[]} vectors
* @param {Uint8Array | number[]} codes
* @param {Float64Array | number[]} widths
* @param {string[]} colours
* @param {number} factor
* @param {Float64Array | number[]} view
* @returns {number}
*/
function draw_vectors(context, vectors, codes, widths, colours, factor, view) {
	const val6 = +factor;
	let ptr0, len0, ptr1, len1, ptr2, len2, ptr3, len3, ptr4, len4;
	try {
		ptr0 = passArrayF64ToWasm0(vectors, wasm.__wbindgen_malloc);
		len0 = WASM_VECTOR_LEN;
		ptr1 = passArray8ToWasm0(codes, wasm.__wbindgen_malloc);
		len1 = WASM_VECTOR_LEN;
		ptr2 = passArrayF64ToWasm0(widths, wasm.__wbindgen_malloc);
		len2 = WASM_VECTOR_LEN;
		ptr3 = passArrayJsValueToWasm0(colours, wasm.__wbindgen_malloc);
		len3 = WASM_VECTOR_LEN;
		ptr4 = passArrayF64ToWasm0(view, wasm.__wbindgen_malloc);
		len4 = WASM_VECTOR_LEN;
	} catch (e) {
		if (ptr4) wasm.__wbindgen_free(ptr4, len4 * 8, 8);
		if (ptr3) {
			wasm.__externref_drop_slice(ptr3, len3);
			wasm.__wbindgen_free(ptr3, len3 * 4, 4);
		}
		if (ptr2) wasm.__wbindgen_free(ptr2, len2 * 8, 8);
		if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
		if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 8, 8);
		throw e;
	}
	const ret = wasm.draw_vectors(context, ptr0, len0, ptr1, len1, ptr2, len2, ptr3, len3, val6, ptr4, len4);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return ret[0] >>> 0;
}
/**
* Every parameter of a flight.
* @returns {Parameter[]}
*/
function flight_parameters() {
	return wasm.flight_parameters();
}
/**
* A ready-made flight.
* @param {Preset} name
* @returns {Flight}
*/
function flight_preset(name) {
	const ret = wasm.flight_preset(name);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* The names of the ready-made flights.
* @returns {Preset[]}
*/
function flight_presets() {
	return wasm.flight_presets();
}
/**
* The interior orientation of an image: from its fiducials, or from the camera's pixel size.
* @param {CameraMm} camera
* @param {PhotoGeometry} photo
* @returns {Interior}
*/
function interior$1(camera, photo) {
	const ret = wasm.interior(camera, photo);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* The English text of a message, or, by its name, another text that belongs to it, as its `label`.
* @param {keyof Messages} family
* @param {Messages[keyof Messages]} message
* @param {string | null} [attribute]
* @returns {string}
*/
function message(family, message, attribute) {
	let deferred4_0;
	let deferred4_1;
	try {
		let ptr0, len0, ptr1, len1;
		try {
			ptr0 = passStringToWasm0(family, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
			len0 = WASM_VECTOR_LEN;
			ptr1 = isLikeNone(attribute) ? 0 : passStringToWasm0(attribute, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
			len1 = WASM_VECTOR_LEN;
		} catch (e) {
			if (ptr1) wasm.__wbindgen_free(ptr1, len1 * 1, 1);
			if (ptr0) wasm.__wbindgen_free(ptr0, len0 * 1, 1);
			throw e;
		}
		const ret = wasm.message(ptr0, len0, message, ptr1, len1);
		var ptr3 = ret[0];
		var len3 = ret[1];
		if (ret[3]) {
			ptr3 = 0;
			len3 = 0;
			throw takeFromExternrefTable0(ret[2]);
		}
		deferred4_0 = ptr3;
		deferred4_1 = len3;
		return getStringFromWasm0(ptr3, len3);
	} finally {
		wasm.__wbindgen_free(deferred4_0, deferred4_1, 1);
	}
}
/**
* What else would do for a pair of this verdict and these settings; null where nothing is known to.
* @param {PairVerdict} verdict
* @param {Given<PairSettings>} settings
* @returns {PairHint | null}
*/
function pair_hint(verdict, settings) {
	const ret = wasm.pair_hint(verdict, settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* What the paper printed for its own pair.
* @returns {Paper}
*/
function paper() {
	return wasm.paper();
}
/**
* Every option of a pair, in the order of the pipeline.
* @returns {Parameter[]}
*/
function parameters() {
	return wasm.parameters();
}
/**
* Reads a camera: {"focal_mm", "principal_point_mm", "pixel_mm", "radial_distortion", "tangential_distortion"}.
* @param {string} json
* @returns {CameraMm}
*/
function parse_camera(json) {
	const ptr0 = passStringToWasm0(json, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
	const len0 = WASM_VECTOR_LEN;
	const ret = wasm.parse_camera(ptr0, len0);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* Reads surveyed points: lines of name, x, y, z and perhaps two standard errors.
* @param {string} text
* @returns {GroundControlRow[]}
*/
function parse_ground_control_points(text) {
	const ptr0 = passStringToWasm0(text, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
	const len0 = WASM_VECTOR_LEN;
	const ret = wasm.parse_ground_control_points(ptr0, len0);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* Reads where images show surveyed points: lines of image, point, x, y in px.
* @param {string} text
* @returns {ImageMeasurementRow[]}
*/
function parse_image_measurements(text) {
	const ptr0 = passStringToWasm0(text, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
	const len0 = WASM_VECTOR_LEN;
	const ret = wasm.parse_image_measurements(ptr0, len0);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
* @param {Camera} camera
* @returns {CameraMm}
*/
function photo_camera(camera) {
	const ret = wasm.photo_camera(camera);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* What a project file holds, by its first kilobyte; null for what is no project.
* @param {Uint8Array | number[]} start
* @returns {ProjectKind | null}
*/
function project_kind(start) {
	const ptr0 = passArray8ToWasm0(start, wasm.__wbindgen_malloc);
	const len0 = WASM_VECTOR_LEN;
	return wasm.project_kind(ptr0, len0);
}
/**
* Settings with every absent option that follows from the others, as all calls take them; what follows from the images stays absent.
* @param {Given<PairSettings>} settings
* @returns {PairSettings}
*/
function resolved(settings) {
	const ret = wasm.resolved(settings);
	if (ret[2]) throw takeFromExternrefTable0(ret[1]);
	return takeFromExternrefTable0(ret[0]);
}
/**
* The names of the rules, in the order of their codes.
* @returns {Rule[]}
*/
function rule_names() {
	return wasm.rule_names();
}
/**
* The version of the crate.
* @returns {string}
*/
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
			__wbg___wbindgen_is_null_c22311b1cc228e3a: function(arg0) {
				return arg0 === null;
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
				throw new Error(getStringFromWasm0(arg0, arg1));
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
				return /* @__PURE__ */ new Object();
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
			__wbg_stringify_b090af1e2fcbfede: function() {
				return handleError(function(arg0, arg1) {
					return JSON.stringify(arg0, arg1);
				}, arguments);
			},
			__wbg_stroke_19fa3f3ec093bc25: function(arg0) {
				arg0.stroke();
			},
			__wbindgen_generic_0000000000000001: function(arg0, arg1) {
				return makeClosure(arg0, arg1, wasm_bindgen__convert__closures_____invoke__h30864ba12fdd530c);
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
function wasm_bindgen__convert__closures_____invoke__h30864ba12fdd530c(arg0, arg1, arg2, arg3) {
	return wasm.wasm_bindgen__convert__closures_____invoke__h30864ba12fdd530c(arg0, arg1, arg2, arg3);
}
var BlockSceneFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_blockscene_free(ptr, 1));
var BlockWritingFinalization = typeof FinalizationRegistry === "undefined" ? {
	register: () => {},
	unregister: () => {}
} : new FinalizationRegistry((ptr) => wasm.__wbg_blockwriting_free(ptr, 1));
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
	if (!(instance instanceof klass)) throw new Error(`expected instance of ${klass.name}`);
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
function passArray8ToWasm0(arg, malloc) {
	const ptr = malloc(arg.length * 1, 1) >>> 0;
	getUint8ArrayMemory0().set(arg, ptr / 1);
	WASM_VECTOR_LEN = arg.length;
	return ptr;
}
function passArrayF64ToWasm0(arg, malloc) {
	const ptr = malloc(arg.length * 8, 8) >>> 0;
	getFloat64ArrayMemory0().set(arg, ptr / 8);
	WASM_VECTOR_LEN = arg.length;
	return ptr;
}
function passArrayJsValueToWasm0(array, malloc) {
	const ptr = malloc(array.length * 4, 4) >>> 0;
	for (let i = 0; i < array.length; i++) {
		const add = addToExternrefTable0(array[i]);
		getDataViewMemory0().setUint32(ptr + 4 * i, add, true);
	}
	WASM_VECTOR_LEN = array.length;
	return ptr;
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
var wasm;
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
function initSync(module) {
	if (wasm !== void 0) return wasm;
	if (module !== void 0) {
		if (Object.getPrototypeOf(module) === Object.prototype) ({module} = module);
		else console.warn("using deprecated parameters for `initSync()`; pass a single object instead");
	}
	const imports = __wbg_get_imports();
	if (!(module instanceof WebAssembly.Module)) module = new WebAssembly.Module(module);
	return __wbg_finalize_init(new WebAssembly.Instance(module, imports), module);
}
// www/block/engine/catalogue.ts
/** What the crate says of blocks, read on the main thread once its module is there. */
/** The page offers one parameter of the features, and those of the block; the strategy of the pair explains the others. */
var offered = (key) => key === "multiscale.number" || !/^(?:multiscale|gradient|nearest|geometry)\./u.test(key);
function blockCatalogue({ parameters, flightParameters }) {
	const own = block_parameters();
	const ofFlight = block_flight_parameters();
	return {
		parameters: own.filter(({ key }) => offered(key)),
		defaults: block_settings({}),
		flightParameters: ofFlight,
		flight: block_flight_preset("small_photos"),
		labels: {
			parameters: [...parameters, ...own],
			flightParameters: [...flightParameters, ...ofFlight]
		}
	};
}
// www/shared/panel/dom.ts
/** An element with attributes and children. */
function h(tag, attributes = {}, ...children) {
	const element = document.createElement(tag);
	for (const [name, value] of Object.entries(attributes)) setAttribute(element, name, value);
	element.append(...children.filter((child) => child !== null));
	return element;
}
function setAttribute(element, name, value) {
	if (value === void 0 || value === false) return;
	if (typeof value === "object") {
		for (const [aria, text] of Object.entries(value)) element.setAttribute(`aria-${aria}`, text);
		return;
	}
	element.setAttribute({
		testid: "data-testid",
		key: "data-key"
	}[name] ?? name, value === true ? "" : String(value));
}
/** Replaces what an element holds. */
function fill(element, ...children) {
	element.replaceChildren(...children.filter((child) => child !== null));
}
function button(text, testid, onClick, title) {
	const made = h("button", {
		type: "button",
		testid,
		...title === void 0 ? {} : { title }
	}, text);
	made.addEventListener("click", onClick);
	return made;
}
var SVG = "http://www.w3.org/2000/svg";
function svg(tag, attributes, ...children) {
	const element = document.createElementNS(SVG, tag);
	for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
	element.append(...children.filter((child) => child !== null));
	return element;
}
/** An element that must be in the page. */
function byId(id) {
	const element = document.getElementById(id);
	if (element === null) throw new Error(`the page has no element "${id}"`);
	return element;
}
/** A section of a panel with a heading. */
function section(title, testid, ...children) {
	const id = `h-${testid}`;
	return h("section", {
		class: "section",
		testid,
		aria: { labelledby: id }
	}, h("h3", { id }, title), ...children);
}
/** Marks a row or a figure, within a panel that is up to date, whose numbers other settings made. */
function markStale(element, stale) {
	if (stale) {
		element.classList.add("is-earlier");
		element.querySelector("th, figcaption")?.append(h("span", { class: "earlier" }, "earlier settings"));
	}
	return element;
}
/** A table row: a heading and cells. */
function row(heading, ...cells) {
	return h("tr", {}, h("th", { scope: "row" }, heading), ...cells.map((cell) => cell instanceof HTMLTableCellElement ? cell : h("td", {}, cell)));
}
// www/shared/state/choices.ts
/** Choices of the page's looks that last from one visit to the next. */
/** Storage may be switched off, or absent on file://: a choice then lasts as long as the page. */
function keptChoice(name) {
	try {
		return localStorage.getItem(name);
	} catch {
		return null;
	}
}
function keepChoice(name, value) {
	try {
		localStorage.setItem(name, value);
	} catch {}
}
// www/shared/panel/drawers.ts
/** What is closed at first and opened by a button: the settings, the details of the results, the settings that few need. It stays as it was left. */
var NAME$2 = "tiepoint-open";
var open$2 = new Set((keptChoice(NAME$2) ?? "").split(" "));
var watchers = [];
/** Calls back now and whenever a drawer is opened or closed. */
function watchDrawers(callback) {
	watchers.push(callback);
	callback();
}
function isOpen(drawer) {
	return open$2.has(drawer);
}
function setDrawer(drawer, wanted) {
	if (isOpen(drawer) === wanted) return;
	if (wanted) open$2.add(drawer);
	else open$2.delete(drawer);
	keepChoice(NAME$2, [...open$2].filter((name) => name !== "").join(" "));
	for (const callback of watchers) callback();
}
/** A button that opens a drawer and closes it; the drawer itself gets a button that closes it. */
function drawerButton(drawer, text, testid, element) {
	const made = button(text, testid, () => {
		setDrawer(drawer, !isOpen(drawer));
		if (isOpen(drawer)) reveal(element);
	});
	const close = button("×", `close-${testid}`, () => {
		setDrawer(drawer, false);
		made.focus();
	});
	close.className = "icon close";
	close.setAttribute("aria-label", `Close: ${text}`);
	element.append(close);
	watchDrawers(() => {
		element.classList.toggle("is-closed", !isOpen(drawer));
		made.setAttribute("aria-expanded", String(isOpen(drawer)));
	});
	return made;
}
/** Brings what lies below the picture into sight. */
function reveal(element) {
	const { top } = element.getBoundingClientRect();
	if (top < 0 || top > .8 * window.innerHeight) element.scrollIntoView({ block: "start" });
}
// www/shared/panel/picker.ts
/** A hidden field for files, and the button that opens it. */
/** The field of files; `take` gets what was chosen, and the same file can be chosen again. */
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
/** The button with its field. */
function fileButton(text, picked, take, title) {
	const input = fileInput(picked, take);
	return [button(text, picked.testid, () => input.click(), title), input];
}
// www/shared/panel/tabs.ts
/** Tabs: one panel of a list is shown; arrow keys move between them. */
/** A column of tabs with a panel each. Panel and tab are named after the tab's id. */
function tabbed(label, tabs) {
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
			const step = {
				ArrowRight: 1,
				ArrowLeft: -1
			}[event.key];
			if (step === void 0) return;
			event.preventDefault();
			const next = (i + step + tabs.length) % tabs.length;
			choose(next);
			buttons[next]?.focus();
		});
	});
	choose(0);
	return {
		element: h("section", {
			class: "side",
			aria: { label }
		}, h("div", {
			class: "tabs",
			role: "tablist",
			aria: { label }
		}, ...buttons), ...panels),
		panels
	};
}
/** Shows the panel of a tab. */
function showTab(id) {
	document.getElementById(id)?.click();
}
// www/shared/state/store.ts
/** Holds a state and tells who asked when a part of it changed. */
/** A state `S` that changes by actions `A` alone. */
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
	/** Applies an action, then tells the listeners. An action dispatched by a listener follows after all have been told. */
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
// www/shared/engine/trusted.ts
/** The page's own files, and what it made itself. */
function own(address) {
	const { origin, protocol } = new URL(address, location.href);
	if (origin !== location.origin && protocol !== "blob:") throw new TypeError(`${address} is no script of this page`);
	return address;
}
/** The one policy that the content-security policy names; absent in browsers without Trusted Types. */
var policy = typeof trustedTypes === "undefined" ? void 0 : trustedTypes.createPolicy("tiepoint", { createScriptURL: own });
/** An address that a worker may be started from. */
function scriptAddress(address) {
	return policy === void 0 ? own(address) : policy.createScriptURL(address);
}
// www/shared/engine/platform.ts
/**
* Where the worker's script and the wasm module come from: files beside the page, or, in the page in one file, inert elements of the
* document. Such a page runs from file:// too, where nothing beside it can be fetched and a module worker does not start from a Blob:
* the worker is therefore one classic script everywhere.
*
* The module is compiled once and handed to each worker in its first message: a worker loads nothing by itself.
*/
/** As `tools/lib/page.mjs` names the files and `tools/lib/compose.mjs` the elements. */
var WORKER = {
	file: "worker.js",
	element: "tiepoint-worker"
};
var WASM = {
	file: "tiepoint_bg.wasm",
	element: "tiepoint-wasm"
};
/** The text of an element of the page in one file; null in a page with files beside it. */
function embedded(id) {
	return document.getElementById(id)?.textContent ?? null;
}
var workerUrl;
/** A fresh worker, waiting for the module as its first message. */
function spawnWorker(name) {
	const code = embedded(WORKER.element);
	workerUrl ??= code === null ? new URL(WORKER.file, document.baseURI).href : URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
	return new Worker(scriptAddress(workerUrl), {
		name,
		type: "classic"
	});
}
var compiled;
/** The compiled wasm module; compiled on the first call, and again after a failure. */
function wasmModule() {
	compiled ??= compileWasm().catch((error) => {
		compiled = void 0;
		throw error;
	});
	return compiled;
}
async function compileWasm() {
	const deflated = embedded(WASM.element);
	if (deflated !== null) return WebAssembly.compile(await inflated(deflated.trim()));
	const response = await fetch(new URL(WASM.file, document.baseURI));
	if (!response.ok) throw new Error(`The program file ${WASM.file} could not be loaded (HTTP ${String(response.status)}). Reload the page.`);
	if (response.headers.get("content-type")?.startsWith("application/wasm") === true) return WebAssembly.compileStreaming(response);
	return WebAssembly.compile(await response.arrayBuffer());
}
/** Bytes of base64 text, deflated without a header. */
function inflated(base64) {
	const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
	return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).arrayBuffer();
}
// www/shared/text/format.ts
/** Numbers as the panels write them. */
/** A number with its minus sign as typography has it; a dash where there is none. */
function fixed(value, digits) {
	if (value == null || Number.isNaN(value)) return "–";
	if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
	return value.toFixed(digits).replace("-", "−");
}
/** A whole number in groups of three, set apart by narrow spaces. */
function count(value) {
	return value == null ? "–" : String(value).replace(/\B(?=(\d{3})+$)/gu, " ");
}
/** Four significant digits, with a power of ten where the number is very small or large. */
function significant(value) {
	if (value === 0) return "0";
	const size = Math.abs(value);
	if (size >= .001 && size < 1e5) return fixed(value, Math.max(0, 3 - Math.floor(Math.log10(size))));
	const [mantissa = "", exponent = ""] = value.toExponential(3).split("e");
	const power = [...exponent.replace("+", "")].map((c) => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹".charAt(Number(c))).join("");
	return `${mantissa.replace("-", "−")}·10${power}`;
}
function percent(share) {
	return `${(100 * share).toFixed(1)} %`;
}
/** With one full stop at its end. */
function sentence(text) {
	return `${text.replace(/\.$/u, "")}.`;
}
/** What is said while a field holds a value that is not allowed. */
function refusedText(label) {
	return `${label}: this value is not allowed. The last valid one stays in use.`;
}
/** What is said of whatever was thrown. */
function messageOf(error) {
	return error instanceof Error ? error.message : String(error);
}
// www/shared/engine/client.ts
/** A call that was refused or failed. `ended`: the worker is gone, and with it what it held. */
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
/** What ended the worker, in words; null where it lives on.  */
function breakdownOf(error) {
	if (!(error instanceof CallError) || !error.ended) return null;
	return error.failure.kind === "memory" ? `the worker ran out of memory (${error.message})` : `the worker broke off at a fault of the program (${error.message}): please report it`;
}
/** A call that the user cancelled. */
var Cancelled = class extends Error {
	name = "Cancelled";
};
var WorkerClient = class {
	name;
	worker = null;
	pending = /* @__PURE__ */ new Map();
	nextId = 1;
	/** Changes when a worker ends: what it held is lost. */
	generation = 0;
	constructor(name) {
		this.name = name;
	}
	/** Asks the worker, starting one where there is none. Rejects with `CallError` or `Cancelled`; no promise stays open. */
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
			worker.ready.then(() => {
				if (this.pending.has(id)) worker.handle.postMessage(request, transfer);
			}, (error) => this.end(new CallError(otherFailure(error), true)));
		});
	}
	/** Ends the worker and rejects what waits for it. The next call starts a fresh one. */
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
				message: event.message || "the worker could not start"
			}, true));
		};
		return {
			handle,
			ready: wasmModule().then((module) => {
				const start = { module };
				handle.postMessage(start);
			})
		};
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
// www/shared/engine/pool.ts
/** As many workers as the processor allows: each does one call at a time, the others wait in order. */
/** More workers than these would share memory bandwidth and take memory for an image each. */
var MOST_WORKERS = 8;
var WorkerPool = class {
	size = Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency || 1));
	idle = Array.from({ length: this.size }, (_, i) => new WorkerClient(`pool ${String(i + 1)}`));
	all = [...this.idle];
	waiting = [];
	/** Rejects with `CallError` or `Cancelled`; no promise stays open. */
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
	/** Ends all workers and what waits for them. The next call starts fresh ones. */
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
// www/shared/state/remember.ts
/** Remembers the last result of a function of a few arguments, compared by identity. */
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
// www/block/state/given.ts
/** What is wrong with the files that a run is given beside its images: read as the run reads them, once they are there. */
/** Control points and their marks are of use together. */
var PARTNER_MISSING = {
	control: "Ground control points need their image measurements: give both files, or neither",
	marks: "Image measurements need their ground control points: give both files, or neither"
};
function problemsOf({ files, options }) {
	return problems(files, options.settings?.placing ?? null, options.cameras, options.control, options.marks, options.masks);
}
/** The first of them; null where there is none. */
function firstProblem(state) {
	return Object.values(problemsOf(state))[0] ?? null;
}
var problems = remember((files, placing, cameras, control, marks, masks) => {
	if (placing === null) return {};
	const names = files.map(({ name }) => name);
	const found = {};
	const look = (given, name, read) => {
		try {
			read();
			return true;
		} catch (error) {
			found[given] = `${name === "" ? "" : `${name}: `}${messageOf(error)}`;
			return false;
		}
	};
	if (cameras !== null) look("cameras", cameras.name, () => check_cameras(cameras.text, names));
	const pointsRead = control !== null && look("control", control.name, () => parse_ground_control_points(control.text));
	const marksRead = marks !== null && look("marks", marks.name, () => parse_image_measurements(marks.text));
	if (pointsRead && marksRead) look("marks", marks.name, () => check_control(control.text, marks.text, names, placing));
	if (control !== null && marks === null) found.control ??= PARTNER_MISSING.control ?? "";
	if (marks !== null && control === null) found.marks ??= PARTNER_MISSING.marks ?? "";
	look("masks", "", () => check_masks(names, masks.map(({ name }) => name)));
	return found;
});
// www/block/state/state.ts
function isMode(text) {
	return text === "pair" || text === "block";
}
var BLOCK_INITIAL = {
	mode: "pair",
	catalogue: null,
	files: [],
	truth: null,
	options: {
		settings: null,
		gps: "use",
		cameras: null,
		control: null,
		marks: null,
		masks: []
	},
	refused: null,
	flight: null,
	running: { kind: "no" },
	shown: null,
	choice: null,
	opened: null,
	notice: null
};
/** Names what a run of the present files and options would be made from. */
function wantedKey({ files, options }) {
	return JSON.stringify([files.map(({ id }) => id), options]);
}
/** Whether other files or options made the block on the screen. */
function isOutdated(state) {
	return state.shown !== null && state.shown.files.length > 0 && state.shown.key !== wantedKey(state);
}
function isBusy$1({ running, notice }) {
	return running.kind === "yes" || notice?.kind === "busy";
}
// www/block/engine/engine.ts
/** How long a run that was stopped may take to end by itself, in ms; computing what cannot be interrupted it is ended with its worker. */
var PATIENCE_MS$2 = 80;
var BlockEngine = class {
	store;
	pool = new WorkerPool();
	/** Holds the block of the last run. */
	block = new WorkerClient("block");
	/** Records of images and pairs that were done, by key: what is done once is not done again. */
	kept = /* @__PURE__ */ new Map();
	recorded = () => void 0;
	port = null;
	/** Of the export that is written. */
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
					text: `Not run: ${sentence(problem)}`
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
				options: runOptions(state.options, settings),
				masks: state.options.masks,
				truth,
				workers: this.pool.size,
				kept: this.kept,
				port: channel.port2
			};
			const view = await this.block.call("blockRun", input, [channel.port2]);
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
				failure: stopped || error instanceof Cancelled ? null : reasonOf(error)
			});
		} finally {
			channel.port1.close();
			if (this.port === channel.port1) this.port = null;
		}
	}
	/** Ends the run, the export, or whatever else the workers do. What was done is kept. */
	cancel() {
		const { port, writing } = this;
		this.port = null;
		this.writing = null;
		this.pool.cancel();
		port?.postMessage({ kind: "stop" });
		writing?.postMessage("stop");
		if (port === null && writing === null) return;
		window.setTimeout(() => {
			if (isBusy$1(this.store.state) && this.port === null && this.writing === null) this.block.cancel();
		}, PATIENCE_MS$2);
	}
	/** Records of images and pairs that were done. */
	get records() {
		return this.kept;
	}
	/** Takes records of earlier runs, in place of those that are there. */
	takeRecords(records) {
		this.kept.clear();
		for (const [key, record] of records) this.kept.set(key, record);
	}
	/** Calls back whenever there is another record. */
	watchRecords(recorded) {
		this.recorded = recorded;
	}
	/** The project file of the block that is held. */
	async project() {
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
	/** Holds the block of a project file; what is shown stays. */
	read(bytes) {
		return this.block.call("blockOpen", { bytes }, [bytes.buffer]);
	}
	async open(bytes) {
		const view = await this.read(bytes);
		this.store.dispatch({
			type: "openedFile",
			view
		});
	}
	/** Rejects with `Cancelled` where the user ends it. */
	async export(kind, name) {
		const { port1, port2 } = new MessageChannel();
		this.writing = port1;
		try {
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
	/** Takes the photos of the flight that is set, on all workers. */
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
		const say = (message, transfer = []) => port.postMessage(message, transfer);
		try {
			if (this.port !== port) return;
			const answer = await this.pool.call("blockJob", job, buffersOf(job));
			say({
				kind: "answer",
				id,
				answer
			}, "made" in answer ? [answer.made.buffer] : []);
		} catch (error) {
			if (!(error instanceof Cancelled)) say({
				kind: "broke",
				id,
				message: reasonOf(error)
			});
		}
	}
};
function runOptions({ gps, cameras, control, marks }, settings) {
	return {
		settings,
		gps,
		...cameras === null ? {} : { cameras },
		...control === null || marks === null ? {} : { control: {
			points: control.text,
			marks: marks.text
		} }
	};
}
/** The memory of a job's bytes, which are copies that the run made for it. */
function buffersOf({ inputs }) {
	return [...new Set(inputs.map(({ buffer }) => buffer))];
}
function reasonOf(error) {
	return breakdownOf(error) ?? messageOf(error);
}
// www/shared/files/save.ts
/** Files that the page gives. */
function save(blob, name) {
	const link = document.createElement("a");
	link.href = URL.createObjectURL(blob);
	link.download = name;
	link.click();
	window.setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
}
// www/block/panel/exports.ts
/** Saving a block: its own file, everything, or what another program reads. */
var NAMES$2 = {
	project: "Project file",
	everything: "Everything (.zip)",
	colmap: "COLMAP",
	micmac: "MicMac",
	bundler: "Bundler",
	nvm: "NVM (VisualSFM)",
	opensfm: "OpenSfM",
	bingo: "BINGO",
	isat: "ISAT",
	agisoft: "Agisoft",
	patb: "PAT-B",
	csv: "CSV tables",
	json: "JSON",
	geojson: "GeoJSON"
};
function mountExports(host, store, engine) {
	const select = h("select", {
		id: "block-export-kind",
		testid: "block-export-kind",
		aria: { label: "Format" }
	});
	const press = button("Save", "block-export", () => void saveAs(store, engine, select.value));
	host.append(h("span", { class: "group-label" }, "Export"), select, press);
	store.watch([
		"shown",
		"running",
		"notice"
	], ([shown]) => {
		const whole = shown !== null && !shown.view.partial;
		press.disabled = !whole || isBusy$1(store.state);
		select.disabled = !whole;
	});
	store.watch(["shown"], ([shown]) => {
		const kinds = [
			"project",
			"everything",
			...shown?.view.formats ?? []
		];
		const { value } = select;
		fill(select, ...kinds.map((kind) => new Option(NAMES$2[kind], kind)));
		if (kinds.includes(value)) select.value = value;
	});
}
async function saveAs(store, engine, kind) {
	store.dispatch({
		type: "notice",
		notice: {
			kind: "busy",
			text: `Writing ${NAMES$2[kind]} …`
		}
	});
	try {
		const { name, type, bytes } = await engine.export(kind, "block");
		save(new Blob([bytes], { type }), name);
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: `${name} was saved.`
			}
		});
	} catch (error) {
		if (error instanceof Cancelled) {
			store.dispatch({
				type: "notice",
				notice: {
					kind: "info",
					text: "Cancelled: nothing was saved. The block is unchanged."
				}
			});
			return;
		}
		const reason = messageOf(error);
		store.dispatch({
			type: "notice",
			notice: {
				kind: "problem",
				text: `${NAMES$2[kind]} was not written: ${reason}.`
			}
		});
	}
}
// www/block/files/files.ts
var IMAGE = /\.(?:jpe?g|png|tiff?|bmp|webp|p[gpn]m)$/iu;
var PROJECT = /\.tiepoint$/iu;
var CAMERAS$1 = /\.json$/iu;
var nextId$2 = 1;
/** Later files have other numbers than these. */
function passIds(taken) {
	for (const id of taken) nextId$2 = Math.max(nextId$2, id + 1);
}
var TEXTS = {
	cameras: "Cameras",
	control: "Ground control points",
	marks: "Image measurements"
};
var WAITS = "tiepoint-wait";
var BlockFiles = class {
	store;
	engine;
	openProject;
	/** Images that are given wait until Run is pressed: large blocks have settings and files that come first. */
	waiting = keptChoice(WAITS) === "yes";
	constructor(store, engine, openProject) {
		this.store = store;
		this.engine = engine;
		this.openProject = openProject;
	}
	get waits() {
		return this.waiting;
	}
	set waits(waits) {
		this.waiting = waits;
		keepChoice(WAITS, waits ? "yes" : "no");
	}
	/** Takes what is dropped on the page while the block is shown. */
	taker = {
		isActive: () => this.store.state.mode === "block",
		markAt: () => "block",
		take: (found) => void this.take(found)
	};
	/** Adds images to the block; what a folder holds besides images is left aside. `why` is said first. */
	async take(found, why = "") {
		const alone = found.filter(({ path }) => path === "");
		const project = alone.find(({ file }) => PROJECT.test(file.name));
		const cameras = alone.find(({ file }) => CAMERAS$1.test(file.name));
		const images = found.filter(({ file }) => IMAGE.test(file.name) || file.type.startsWith("image/"));
		if (project !== void 0) await this.openProject(project.file);
		if (cameras !== void 0) await this.takeText("cameras", cameras.file);
		const aside = found.length - images.length - (project === void 0 ? 0 : 1) - (cameras === void 0 ? 0 : 1);
		if (images.length > 0 || aside > 0) this.add(images, aside, why);
	}
	/** Takes more images than a pair has, which were given there. */
	async give(files, masks) {
		await this.take(files.map((file) => ({
			file,
			path: ""
		})), "More than two images are a block.");
		if (masks.length > 0) this.takeMasks(masks);
	}
	/** Photographs a block and runs it, whatever waits. */
	async sample(flight) {
		if (await this.simulate(flight)) await this.engine.run();
	}
	/** Photographs the simulated block that is set and runs it. */
	async photograph() {
		const { flight } = this.store.state;
		if (flight === null || !await this.simulate(flight)) return;
		if (this.waits) this.say("info", `${String(this.store.state.files.length)} photos of a simulated block. Press Run.`);
		else await this.engine.run();
	}
	/** Photographs a flight, in place of the images that are there; false where that failed. */
	async simulate(flight) {
		this.say("busy", "Building the synthetic scene …");
		try {
			const { files, truth } = await this.engine.photograph(flight, (count, of) => this.say("busy", `Photographing the simulated block: ${String(count)} of ${String(of)} …`));
			this.store.dispatch({
				type: "files",
				files: files.map((file) => ({
					...file,
					id: nextId$2++
				})),
				truth
			});
			return true;
		} catch (error) {
			this.failed("The block could not be simulated", error);
			return false;
		}
	}
	/** Takes a file of text and says what is wrong with it; it stays beside its field until another is given or it is removed. */
	async takeText(given, file) {
		this.store.dispatch({
			type: "options",
			options: { [given]: {
				name: file.name,
				text: await file.text()
			} }
		});
		const problem = problemsOf(this.store.state)[given];
		if (problem === void 0) this.say("info", `${TEXTS[given]} from ${file.name}.`);
		else if (problem === PARTNER_MISSING[given]) this.say("info", `${TEXTS[given]} from ${file.name}. ${problem}.`);
		else this.say("problem", `${sentence(problem)} The block cannot be run with it.`);
	}
	/** Takes masks in place of those that are there. */
	takeMasks(files) {
		this.store.dispatch({
			type: "options",
			options: { masks: files.map((file) => ({
				id: nextId$2++,
				name: file.name,
				file
			})) }
		});
		const problem = problemsOf(this.store.state).masks;
		if (problem !== void 0) this.say("problem", `${sentence(problem)} The block cannot be run with them.`);
	}
	/** Opens a block that was saved. */
	async open(file) {
		this.say("busy", `Reading ${file.name} …`);
		try {
			await this.engine.open(new Uint8Array(await file.arrayBuffer()));
			this.say("info", `${file.name} was opened. The file does not hold its images: drop them too to open pairs.`);
		} catch (error) {
			this.failed(`${file.name} cannot be opened`, error);
		}
	}
	add(found, aside, why) {
		const files = new Map(this.store.state.files.map((file) => [file.name, file]));
		const before = files.size;
		for (const { file, path } of found) {
			const name = [file.name, path].find((text) => text !== "" && !files.has(text));
			if (name !== void 0) files.set(name, {
				id: nextId$2++,
				name,
				file
			});
		}
		const twice = found.length - (files.size - before);
		const sorted = [...files.values()].sort((a, b) => a.name < b.name ? -1 : 1);
		if (sorted.length > before) {
			this.store.dispatch({
				type: "files",
				files: sorted,
				truth: this.store.state.truth
			});
			if (sorted.length >= 2 && !this.waits) this.engine.run();
		}
		const runs = this.store.state.running.kind === "yes";
		const notes = [
			why,
			runs ? "" : `${images(sorted.length)} in the block.`,
			twice > 0 ? `${images(twice)} skipped: their names are in the block already.` : "",
			aside > 0 ? `${String(aside)} ${aside === 1 ? "file" : "files"} skipped: not an image by name.` : "",
			runs ? "" : sorted.length >= 2 ? "Press Run." : "A block needs two images or more."
		].filter((note) => note !== "");
		if (notes.length === 0 || this.store.state.notice?.kind === "problem") return;
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: notes.join(" "),
				beside: runs
			}
		});
	}
	say(kind, text) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind,
				text
			}
		});
	}
	failed(what, error) {
		if (error instanceof Cancelled) this.say("info", "Cancelled. Nothing was changed.");
		else this.say("problem", `${what}: ${messageOf(error)}. The block is unchanged.`);
	}
};
function images(count) {
	return `${String(count)} ${count === 1 ? "image" : "images"}`;
}
// www/shared/files/keepable.ts
var names = /* @__PURE__ */ new WeakMap();
/** A name of a value for its part of a project: the same as long as it is the same object. `kept`: the name that it has in the storage. */
function nameOf(value, kept) {
	const name = names.get(value) ?? kept ?? randomName();
	names.set(value, name);
	return name;
}
/** No two are the same, on plain http too. */
function randomName() {
	return Array.from(crypto.getRandomValues(/* @__PURE__ */ new Uint8Array(12)), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
/** A field of what was kept is not as it should be. */
function wrong(name) {
	return /* @__PURE__ */ new Error(`the field ${name} is damaged`);
}
/** A kept object. @throws Error where it is none */
function objectOf(value, name) {
	if (typeof value !== "object" || value === null || Array.isArray(value)) throw wrong(name);
	return value;
}
/** A kept value of one of the types of `like`. @throws Error where it is of another */
function likeOf(value, like, name) {
	if (typeof value !== typeof like || typeof value === "number" && Number.isNaN(value)) throw wrong(name);
	return value;
}
/** @throws Error where it is no list, or one of its elements is not as `element` reads it */
function listOf$1(value, name, element) {
	if (!Array.isArray(value)) throw wrong(name);
	return value.map((one, i) => element(one, `${name}[${String(i)}]`));
}
/** Null stays null. */
function orNull(value, read) {
	return value == null ? null : read(value);
}
/**
* The values of a kept object in the shape of another: fields that a later version added have their default, fields that it dropped are left
* out. Where the default is null, or is a list, what was kept stands. @throws Error where a field is of another type
*/
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
// www/shared/text/project.ts
/** What a project is called. */
/** Called after its images, unless it was given a name. */
function titleOf({ name, images }) {
	if (name !== null) return name;
	const [first, second] = images;
	if (first === void 0) return "Without images";
	if (second === void 0) return first;
	return images.length === 2 ? `${first} and ${second}` : `${first} and ${count(images.length - 1)} more images`;
}
/** Bytes as a size in MB, or kB where there are few. */
function sizeText(bytes) {
	if (bytes < 1e6) return `${count(Math.ceil(bytes / 1e3))} kB`;
	if (bytes < 1e9) return `${(bytes / 1e6).toFixed(1)} MB`;
	return `${(bytes / 1e9).toFixed(1)} GB`;
}
// www/block/state/kept.ts
/** Whether there is nothing yet that would have to be kept. */
function isBlank$1({ catalogue, files, shown, options, flight }) {
	const { settings, gps, cameras, control, marks, masks } = options;
	const noText = cameras === null && control === null && marks === null;
	const untouched = settings === catalogue?.defaults && flight === catalogue?.flight && gps === "use" && noText && masks.length === 0;
	return catalogue === null || files.length === 0 && shown === null && untouched;
}
// www/block/files/keep.ts
var GIVEN$1 = "block";
var SHOWN = "block/shown";
var FILE$1 = "block/file/";
var RECORD = "block/record/";
/** Room of what is small and not counted, in bytes. */
var SMALL$1 = 4096;
var KeptBlocks = class {
	store;
	engine;
	catalogue;
	/** The finished block on the screen as it is kept; null until its file is written. */
	made = null;
	making = false;
	changed = () => void 0;
	constructor(store, engine, catalogue) {
		this.store = store;
		this.engine = engine;
		this.catalogue = catalogue;
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
			"mode",
			"running"
		], () => {
			changed();
			this.make();
		});
	}
	images() {
		const { files, shown } = this.store.state;
		return (files.length > 0 ? files : shown?.view.images ?? []).map(({ name }) => name);
	}
	parts() {
		const { state } = this.store;
		const parts = /* @__PURE__ */ new Map();
		if (isBlank$1(state)) return parts;
		const { files, options, flight, truth, opened, shown } = state;
		parts.set(GIVEN$1, {
			value: given$3(files, options, flight, truth, opened),
			bytes: SMALL$1
		});
		if (truth !== null) parts.set(FILE$1 + nameOf(truth), {
			value: truth,
			bytes: SMALL$1,
			alone: true
		});
		for (const { file } of [
			...files,
			...options.masks,
			...shown?.files ?? []
		]) parts.set(FILE$1 + nameOf(file), {
			value: file,
			bytes: file.size,
			alone: true
		});
		const { made } = this;
		if (made !== null && made.shown === shown) parts.set(SHOWN, {
			value: made.kept,
			bytes: SMALL$1 + made.kept.project.size
		});
		if (files.length > 0) for (const [key, record] of this.engine.records) parts.set(RECORD + key, {
			value: record,
			bytes: record.size,
			again: true
		});
		return parts;
	}
	async read(parts) {
		if (!parts.has(GIVEN$1)) return () => void 0;
		const kept = givenFrom$1(parts.get(GIVEN$1), this.catalogue);
		const files = kept.files.map((file) => fileFrom(parts, file));
		const masks = kept.masks.map((file) => fileFrom(parts, file));
		const finished = await this.finished(parts);
		const truth = orNull(kept.truth, (name) => truthFrom$1(parts, name));
		const records = new Map([...parts].flatMap(([part, record]) => part.startsWith(RECORD) && record instanceof Blob ? [[part.slice(13), record]] : []));
		const shown = finished?.shown ?? null;
		const count = shown?.view.images.length ?? 0;
		const opened = kept.opened?.every((image) => image < count) === true ? kept.opened : null;
		return () => {
			passIds([
				...files,
				...masks,
				...shown?.files ?? []
			].map(({ id }) => id));
			this.engine.takeRecords(records);
			this.made = finished;
			this.store.dispatch({
				type: "restored",
				restored: {
					files,
					options: {
						...kept.options,
						masks
					},
					flight: kept.flight,
					truth,
					shown,
					opened
				}
			});
			const names = this.images();
			if (names.length === 0) return;
			const goesOn = records.size > 0 && shown === null ? " The work that was done is kept: Run goes on from there." : "";
			const text = `Restored from this browser: ${titleOf({
				name: null,
				images: names
			})}.${goesOn}`;
			this.store.dispatch({
				type: "notice",
				notice: {
					kind: "info",
					text,
					beside: true
				}
			});
		};
	}
	clear() {
		this.made = null;
		if (this.store.state.running.kind === "yes") this.engine.cancel();
		this.engine.takeRecords(/* @__PURE__ */ new Map());
		this.store.dispatch({ type: "cleared" });
	}
	/** Writes the finished block as a project file; its worker may be busy with another one, or be ended: then after the next change. */
	async make() {
		const { shown, running } = this.store.state;
		if (this.making || shown === null || shown.view.partial || running.kind === "yes" || this.made?.shown === shown) return;
		this.making = true;
		try {
			const project = await this.engine.project();
			const { key, files, steps, seconds, view } = shown;
			if (this.store.state.shown === shown) this.made = {
				shown,
				kept: {
					project,
					key,
					files: files.map(keptFile),
					steps,
					seconds,
					score: view.score
				}
			};
		} catch {}
		this.making = false;
		this.changed();
		if (this.store.state.shown !== shown) this.make();
	}
	async finished(parts) {
		if (!parts.has(SHOWN)) return null;
		const value = objectOf(parts.get(SHOWN), "shown");
		const { project } = value;
		if (!(project instanceof Blob)) throw new Error("the finished block is damaged");
		const kept = {
			project,
			key: likeOf(value["key"], "", "shown.key"),
			files: listOf$1(value["files"], "shown.files", fileOf$1),
			steps: objectOf(value["steps"], "shown.steps"),
			seconds: likeOf(value["seconds"], 0, "shown.seconds"),
			score: orNull(value["score"], (score) => objectOf(score, "shown.score"))
		};
		const files = kept.files.map((file) => fileFrom(parts, file));
		const view = await this.engine.read(new Uint8Array(await project.arrayBuffer()));
		const { key, steps, seconds, score } = kept;
		return {
			shown: {
				key,
				files,
				steps,
				seconds,
				view: {
					...view,
					score
				}
			},
			kept: value
		};
	}
};
function keptFile({ id, name, file }) {
	return {
		id,
		name,
		file: nameOf(file)
	};
}
/** All but files and the finished block; the same object while nothing of it has changed. */
var given$3 = remember((files, { masks, ...options }, flight, truth, opened) => ({
	files: files.map(keptFile),
	options,
	masks: masks.map(keptFile),
	flight,
	truth: orNull(truth, (known) => nameOf(known)),
	opened
}));
function fileOf$1(value, name) {
	const { id, name: called, file } = objectOf(value, name);
	return {
		id: likeOf(id, 0, `${name}.id`),
		name: likeOf(called, "", `${name}.name`),
		file: likeOf(file, "", `${name}.file`)
	};
}
/** @throws Error naming the field that is damaged */
function givenFrom$1(value, catalogue) {
	const kept = objectOf(value, "block");
	const options = objectOf(kept["options"], "options");
	const text = (name) => orNull(options[name], (given) => {
		const { name: called, text: content } = objectOf(given, `options.${name}`);
		return {
			name: likeOf(called, "", `options.${name}.name`),
			text: likeOf(content, "", `options.${name}.text`)
		};
	});
	const opened = orNull(kept["opened"], (pair) => listOf$1(pair, "opened", (image, name) => likeOf(image, 0, name)));
	return {
		files: listOf$1(kept["files"], "files", fileOf$1),
		masks: listOf$1(kept["masks"], "masks", fileOf$1),
		options: {
			settings: orNull(options["settings"], (settings) => fitted$1(settings, catalogue.defaults, "options.settings")),
			gps: options["gps"] === "ignore" ? "ignore" : "use",
			cameras: text("cameras"),
			control: text("control"),
			marks: text("marks")
		},
		flight: orNull(kept["flight"], (flight) => fitted$1(flight, catalogue.flight, "flight")),
		truth: orNull(kept["truth"], (name) => likeOf(name, "", "truth")),
		opened: opened?.length === 2 ? opened : null
	};
}
/** @throws Error where the file is not there */
function fileFrom(parts, { id, name, file: at }) {
	const file = parts.get(FILE$1 + at);
	if (!(file instanceof Blob)) throw new Error(`the image ${name} is damaged`);
	nameOf(file, at);
	return {
		id,
		name,
		file
	};
}
function truthFrom$1(parts, name) {
	const truth = objectOf(parts.get(FILE$1 + name), "truth");
	nameOf(truth, name);
	return truth;
}
// www/shared/panel/control.ts
/** Beyond this many steps, or this range of a real number, a slider is too coarse to be of use. */
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
	const reset = button("↺", `reset-${parameter.key}`, () => binding.set(binding.standard()), "Default");
	reset.className = "icon";
	reset.setAttribute("aria-label", `${parameter.label}: default`);
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
	made.setAttribute("aria-label", `Help: ${parameter.label}`);
	return made;
}
function makeField(parameter, id, binding) {
	switch (parameter.kind) {
		case "flag": return flagField(parameter, id, binding);
		case "choice": return choiceField(parameter, id, binding);
		default: return numberField$1(parameter, id, binding);
	}
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
	const empty = new Option("default", "");
	empty.title = absent;
	if (standard() === null) select.append(empty);
	values.forEach((value, i) => {
		select.append(new Option(labels[i] ?? value, value));
	});
	select.addEventListener("change", () => set(select.value === "" ? null : select.value));
	const show = (value) => {
		const meant = labels[values.indexOf(String(whenEmpty()))];
		empty.text = meant === void 0 ? "default" : `default: ${meant}`;
		select.value = String(value ?? "");
	};
	return {
		elements: [select],
		show,
		onProblem: () => void 0
	};
}
/** The step of a whole number; null where any number between is allowed. */
function stepOf(parameter) {
	if (parameter.kind === "real") return null;
	return parameter.odd ? 2 : 1;
}
function rangeText(parameter) {
	return `${{
		2: "an odd number",
		1: "a whole number",
		any: "a number"
	}[stepOf(parameter) ?? "any"] ?? "a number"} from ${String(parameter.min)} to ${String(parameter.max)}`;
}
function numberField$1(parameter, id, { set, standard, whenEmpty }) {
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
			tell(`Allowed: ${rangeText(parameter)}${optional() ? ", or empty" : ""}. The last valid value stays in use.`);
			return;
		}
		set(input.valueAsNumber);
	});
	slider?.addEventListener("input", () => set(slider.valueAsNumber));
	const show = (value) => {
		input.removeAttribute("aria-invalid");
		const absent = optional() ? whenEmpty() : null;
		input.placeholder = optional() ? String(absent ?? "default") : "";
		input.title = optional() ? `Empty: ${String(absent ?? parameter.absent)}` : "";
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
		aria: { label: `${parameter.label}, slider` }
	});
	slider.min = String(parameter.min);
	slider.max = String(parameter.max);
	slider.step = String(step ?? range / 100);
	return slider;
}
// www/shared/panel/settings.ts
/** The path of a key: groups of features lie a step deeper in a block's settings, and a group that stands alone has its fields at the top. */
function pathOf(settings, key) {
	const [group = "", field = ""] = key.split(".");
	if (group in settings) return [group, field];
	return typeof settings["features"] === "object" ? [
		"features",
		group,
		field
	] : [field];
}
/** The value of a setting; null where it is absent. */
function readSetting(settings, key) {
	return pathOf(settings, key).reduce((at, name) => at?.[name], settings) ?? null;
}
/** The settings with one value changed. */
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
/** The same with few settings in sight, the number of those that were changed, and one button that sets all back. */
function makeFolded(parameters, bound, { title, first, reset, changed }) {
	const controls = parameters.map((parameter) => controlOf(parameter, bound));
	const ahead = controls.filter(({ parameter }) => first.includes(parameter.key));
	const folds = [];
	const groups = groupsOf(controls.filter((control) => !ahead.includes(control)), (name, elements) => {
		const fold = h("details", { class: "group" }, h("summary", {}, name, " ", h("span", { class: "changed" })), ...elements);
		folds.push(fold);
		return fold;
	});
	const number = h("span", { testid: "changed-settings" });
	const back = h("p", { class: "buttons" }, number, button("Set all back", "reset-settings", reset));
	const unfold = button("", "all-settings", () => setDrawer("all-settings", !isOpen("all-settings")));
	let unfolded = null;
	watchDrawers(() => {
		if (unfolded === isOpen("all-settings")) return;
		unfolded = isOpen("all-settings");
		for (const fold of folds) fold.open = unfolded;
		unfold.textContent = unfolded ? "Fold all" : "Unfold all";
	});
	const show = (settings, acting) => {
		showAll(controls, groups, settings, acting);
		const all = controls.filter(({ element }) => element.classList.contains("is-changed")).length;
		for (const { own, element } of groups) {
			const here = own.filter((control) => control.element.classList.contains("is-changed")).length;
			fill(element.querySelector(".changed") ?? element, here === 0 ? "" : `${String(here)} changed`);
		}
		back.hidden = all === 0;
		number.textContent = all === 1 ? "1 setting differs from its default." : `${String(all)} settings differ from their defaults.`;
		changed(all);
	};
	return {
		controls,
		elements: [
			back,
			h("fieldset", { class: "group" }, h("legend", {}, title), ...ahead.map(({ element }) => element)),
			h("p", { class: "buttons folds" }, unfold),
			...groups.map(({ element }) => element)
		],
		show
	};
}
/** What a button says that opens settings. */
function settingsText(changed) {
	return changed === 0 ? "Settings" : `Settings · ${String(changed)}`;
}
function controlOf(parameter, { change, defaults, resolved, refused }) {
	return makeControl(parameter, {
		set: (value) => change(parameter.key, value),
		standard: () => readSetting(defaults(), parameter.key),
		whenEmpty: () => resolved === void 0 ? null : readSetting(resolved(), parameter.key),
		refused: () => refused?.(parameter.label)
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
// www/block/panel/flight.ts
/** The simulated block: a control for each parameter of its flight that photos depend on. */
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
		const take = button("Photograph this block", "block-photograph", () => void files.photograph());
		take.className = "primary";
		fill(host, h("p", { class: "note" }, "A flight in strips over a made town. Larger photos take longer: 12 million pixels some seconds each."), h("div", { class: "buttons" }, take), ...sections.elements);
		store.watch(["flight"], ([flight]) => {
			if (flight !== null) sections.show(flight);
		});
		store.watch(["running", "notice"], () => {
			take.disabled = isBusy$1(store.state);
		});
	});
}
// www/block/state/words.ts
/** What the page says of an image or a pair of a block. */
/** The connection of two images; undefined where they were not tried. */
function connectionOf(view, [a, b]) {
	return connectionsOf(view).get(pairKey(a, b));
}
function pairKey(a, b) {
	return a < b ? `${String(a)},${String(b)}` : `${String(b)},${String(a)}`;
}
var CONNECTIONS = /* @__PURE__ */ new WeakMap();
/** All connections by their images. */
function connectionsOf(view) {
	const known = CONNECTIONS.get(view);
	if (known !== void 0) return known;
	const made = new Map(view.connections.map((connection) => [pairKey(...connection.images), connection]));
	CONNECTIONS.set(view, made);
	return made;
}
function matchesOf({ outcome }) {
	return outcome.kind === "connected" ? outcome.matches : 0;
}
function describe(view, choice) {
	return choice.kind === "image" ? describeImage(view, choice.image) : describePair(view, choice.images);
}
function describeImage(view, index) {
	const image = view.images[index];
	if (image === void 0) return "";
	const partners = view.connections.filter(({ images, outcome }) => images.includes(index) && outcome.kind === "connected").length;
	return `${[
		`${image.name}: ${image.features === null ? "" : `${count(image.features)} features, `}${count(image.rays)} observations${image.places === null ? "" : ` in ${String(image.places)} of 9 von Gruber positions`}`,
		`connected with ${count(partners)} of ${count(view.images.length - 1)} images`,
		image.rmsePx === null ? "" : `RMSE ${fixed(image.rmsePx, 2)} px`,
		image.oriented ? "oriented" : image.why,
		image.exifOrientation === null || image.exifOrientation === 1 ? "" : `used as stored, EXIF orientation ${String(image.exifOrientation)}`
	].filter((part) => part !== "").join("; ")}.`;
}
function describePair(view, images) {
	const names = images.map((image) => view.images[image]?.name ?? "").join(" – ");
	const connection = connectionOf(view, images);
	if (connection === void 0) return `${names}: this pair was not tried (the choice of pairs skips it).`;
	const { reason, geometry, shared, chosen } = connection;
	return `${names}: ${[
		reason.replace(/\.$/u, ""),
		geometry,
		shared > 0 ? `${count(shared)} common points, ${count(chosen)} selected` : ""
	].filter((part) => part !== "").join("; ")}.`;
}
// www/block/panel/mode.ts
/** The switch between the pair and the block, and the way back from a pair of the block. */
var MODES = [["pair", "Pair"], ["block", "Block"]];
/** `parts`: what is shown in each mode alone. */
function mountMode(store, parts) {
	const buttons = MODES.map(([mode, text]) => ({
		mode,
		press: button(text, `mode-${mode}`, () => store.dispatch({
			type: "mode",
			mode
		}))
	}));
	store.watch(["mode"], ([mode]) => {
		for (const { mode: own, press } of buttons) press.setAttribute("aria-pressed", String(own === mode));
		for (const [own] of MODES) for (const part of parts[own]) part.hidden = own !== mode;
		document.querySelector(".skip")?.setAttribute("href", mode === "pair" ? "#view" : "#block-view");
		document.body.dataset.mode = mode;
	});
	return h("div", {
		class: "mode",
		role: "group",
		aria: { label: "What is matched" }
	}, ...buttons.map(({ press }) => press));
}
/** A line over the pair that says which pair of the block it is. */
function mountBack(store) {
	const text = h("span", { testid: "of-block" });
	const line = h("div", { class: "of-block" }, button("← Back to the block", "back-to-block", () => {
		store.dispatch({
			type: "mode",
			mode: "block"
		});
		document.getElementById("block-view")?.focus();
	}), text);
	store.watch(["opened", "shown"], ([opened, shown]) => {
		line.hidden = opened === null || shown === null;
		fill(text, opened === null || shown === null ? "" : describe(shown.view, {
			kind: "pair",
			images: opened
		}));
	});
	return line;
}
// www/block/panel/progress.ts
var STAGES$1 = {
	photos: "Photos",
	images: "Images: features",
	likeness: "Similarity of images",
	pairs: "Pairs: matches",
	points: "Tie points",
	windows: "Windows of observations",
	refinement: "Refinement",
	orientation: "Orientation"
};
/** Stages whose steps are parts of one computation, none that the user counts. */
var OF_ONE_PIECE = /* @__PURE__ */ new Set(["points", "orientation"]);
/** Stages in their order. */
var NAMES$1 = Object.keys(STAGES$1);
function mountProgress(host, store) {
	const body = h("div", { class: "stages" });
	const whole = section("Run", "block-progress", body);
	host.append(whole);
	store.watch(["running", "shown"], ([running, shown]) => {
		const steps = running.kind === "no" ? shown?.steps ?? {} : running.steps;
		const begun = NAMES$1.flatMap((name) => steps[name] === void 0 ? [] : [stage(name, steps[name])]);
		whole.hidden = begun.length === 0;
		fill(body, ...begun);
	});
}
function stage(name, step) {
	const line = (...parts) => h("div", {
		class: "stage-line",
		testid: `stage-${name}`
	}, h("span", {}, STAGES$1[name]), ...parts, h("span", { class: "note" }, stepText(name, step)));
	if (step.done === step.total) return line();
	const bar = h("progress", { aria: { label: STAGES$1[name] } });
	bar.max = Math.max(1, step.total);
	bar.value = step.done;
	return line(bar);
}
/** "7 of 12, 3 from an earlier run; 8 s, about 5 s left; IMG_9428.jpg"; of a stage that is done what there was and how long it took. */
function stepText(stage, { done, total, found, seconds, secondsLeft, name }) {
	const goesOn = done < total;
	return [
		OF_ONE_PIECE.has(stage) ? "" : `${count(done)} of ${count(total)}${found > 0 ? `, ${count(found)} from an earlier run` : ""}`,
		`${duration(seconds)}${secondsLeft === void 0 || !goesOn ? "" : `, about ${duration(secondsLeft)} left`}`,
		goesOn ? name ?? "" : ""
	].filter((part) => part !== "").join("; ");
}
/** What the status line says of the stage that runs. */
function runText(steps) {
	const name = NAMES$1.findLast((stage) => steps[stage] !== void 0);
	const step = name === void 0 ? void 0 : steps[name];
	return name === void 0 || step === void 0 ? "Starting …" : `${STAGES$1[name]}: ${stepText(name, step)}`;
}
function duration(seconds) {
	if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
	if (seconds < 90) return `${String(Math.round(seconds))} s`;
	const minutes = Math.round(seconds / 60);
	return minutes < 90 ? `${String(minutes)} min` : `${(seconds / 3600).toFixed(1)} h`;
}
// www/block/state/reducer.ts
function reduceBlock(state, action) {
	switch (action.type) {
		case "ready": return {
			...state,
			catalogue: action.catalogue,
			options: {
				...state.options,
				settings: action.catalogue.defaults
			},
			flight: action.catalogue.flight
		};
		case "mode": return {
			...state,
			mode: action.mode
		};
		case "files": return {
			...state,
			files: action.files,
			truth: action.truth,
			running: onOtherInput(state.running)
		};
		case "options": return {
			...state,
			options: {
				...state.options,
				...action.options
			},
			running: onOtherInput(state.running),
			notice: null,
			refused: action.options.settings === void 0 ? state.refused : null
		};
		case "refused": return {
			...state,
			refused: action.label,
			notice: state.notice?.kind === "busy" ? state.notice : null
		};
		case "flight": return {
			...state,
			flight: action.flight
		};
		case "choose": return {
			...state,
			choice: action.choice
		};
		case "openedPair": return {
			...state,
			opened: action.images
		};
		case "notice": return {
			...state,
			notice: action.notice
		};
		case "openedFile": return {
			...state,
			...blank(state),
			running: { kind: "no" },
			shown: {
				key: "",
				view: action.view,
				files: [],
				steps: {},
				seconds: 0
			}
		};
		case "restored": return {
			...BLOCK_INITIAL,
			mode: state.mode,
			catalogue: state.catalogue,
			...action.restored
		};
		case "cleared": return state.catalogue === null ? state : reduceBlock({
			...BLOCK_INITIAL,
			mode: state.mode
		}, {
			type: "ready",
			catalogue: state.catalogue
		});
		case "clear": return {
			...BLOCK_INITIAL,
			mode: state.mode,
			catalogue: state.catalogue,
			options: state.options,
			flight: state.flight
		};
		default: return withRun$1(state, action);
	}
}
/** A run that goes on keeps what it was given; of one that was ended nothing is left to take up as it was. */
function onOtherInput(running) {
	return running.kind === "yes" ? running : { kind: "no" };
}
/** What refers to the images of a block that is no longer shown. */
function blank(state) {
	return {
		choice: null,
		opened: null,
		notice: state.notice?.kind === "busy" ? null : state.notice
	};
}
/** What was chosen, by the names of its images in another view of them; null where they are not in it. */
function sameChoice({ shown, choice }, view) {
	if (shown === null || choice === null) return null;
	const place = (image) => view.images.findIndex(({ name }) => name === shown.view.images[image]?.name);
	if (choice.kind === "image") return place(choice.image) < 0 ? null : {
		kind: "image",
		image: place(choice.image)
	};
	const images = [place(choice.images[0]), place(choice.images[1])];
	return images.includes(-1) ? null : {
		kind: "pair",
		images
	};
}
/** What a run reports. */
function withRun$1(state, action) {
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
				files,
				seconds: 0,
				steps: {}
			};
			return {
				...state,
				shown,
				opened: null,
				choice: sameChoice(state, view)
			};
		}
		case "done": {
			const { key, view, files, seconds } = action;
			return {
				...state,
				...blank(state),
				choice: sameChoice(state, view),
				running: { kind: "no" },
				shown: {
					key,
					view,
					files,
					seconds,
					steps: running.kind === "yes" ? running.steps : {}
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
// www/shared/panel/facts.ts
/** Figures that explain themselves: a press on a name shows what the figure is. */
/** Names whose explanation is open: kept, since the panels are built anew with each result. */
var open$1 = /* @__PURE__ */ new Set();
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
// www/block/panel/results.ts
/** What came of a block: images oriented, points by rays, residuals, calibrated cameras, warnings, and what was skipped. */
/** Reasons listed one by one; the others are in the table of images. */
var LISTED = 50;
function mountResults(host, store) {
	const body = h("div", { testid: "block-results" });
	host.append(body);
	store.watch([
		"shown",
		"files",
		"options"
	], ([shown]) => {
		body.classList.toggle("is-stale", isOutdated(store.state));
		if (shown === null) fill(body, h("p", { class: "note" }, "No block yet. Drop images or a folder, or simulate a block, then press Run."));
		else fill(body, ...sectionsOf(shown.view));
	});
}
function sectionsOf(view) {
	if (view.partial) return [
		leftOut(view),
		section("So far", "block-facts", facts(partialFacts(view))),
		section("Cameras", "block-cameras", cameraTable(view))
	];
	return [
		leftOut(view),
		strays("Masks without an image", "block-stray-masks", view.strayMasks, "no image has their name"),
		strays("Image measurements without an image", "block-stray-marks", view.strayMarks, "not among the images read"),
		listOf("Remarks", "block-remarks", view.remarks),
		section("Block", "block-facts", facts(factsOf(view))),
		view.score === null ? null : section("Against the truth", "block-score", facts(scoreFacts(view.score))),
		listOf("Warnings", "block-warnings", view.warnings),
		notOriented(view),
		section("Tie points by number of rays", "block-by-rays", rayTable(view)),
		section("Cameras", "block-cameras", cameraTable(view))
	];
}
/** What is known before there are points. */
function partialFacts(view) {
	const connected = view.connections.filter(({ outcome }) => outcome.kind === "connected");
	return [
		{
			name: "Images read",
			testid: "block-read",
			value: count(view.images.length),
			help: "Images whose features are detected."
		},
		{
			name: "Connected pairs",
			testid: "block-connected",
			value: `${count(connected.length)} of ${count(view.connections.length)} tried`,
			help: "Pairs with enough matches that agree with one geometry."
		},
		{
			name: "Matches",
			testid: "block-matches",
			value: count(connected.reduce((sum, connection) => sum + matchesOf(connection), 0)),
			help: "Verified matches of all connected pairs."
		}
	];
}
function strays(title, testid, names, why) {
	if (names.length === 0) return null;
	return section(title, testid, h("p", {}, `${names.slice(0, LISTED).join(", ")}${names.length > LISTED ? " …" : ""}: ${why}.`));
}
function listOf(title, testid, texts) {
	return texts.length === 0 ? null : section(title, testid, h("ul", {}, ...texts.map((text) => h("li", {}, text))));
}
function checkFact({ points, rmse_m: rmse, ratio }) {
	return {
		name: "Check points, RMSE",
		testid: "block-checks",
		value: `${rmse.map((value) => fixed(value, 3)).join(" ")} m, ${count(points)} points${ratio === null ? "" : `, ${fixed(ratio, 2)} predicted`}`,
		help: "Root mean square difference of x, y, z between adjusted and surveyed check points, whose coordinates took no part; then the same in predicted standard errors, about 1 where these hold."
	};
}
function factsOf(view) {
	const connected = view.connections.filter(({ outcome }) => outcome.kind === "connected");
	const matches = connected.reduce((sum, connection) => sum + matchesOf(connection), 0);
	const rays = view.images.reduce((sum, image) => sum + image.rays, 0);
	return [
		{
			name: "Images oriented",
			testid: "block-oriented",
			value: `${count(view.oriented)} of ${count(view.images.length)}`,
			help: "Images with an exterior orientation: position and attitude in object space."
		},
		{
			name: "Connected pairs",
			testid: "block-connected",
			value: `${count(connected.length)} of ${count(view.connections.length)} tried`,
			help: "Pairs with enough matches that agree with one geometry. The matrix states for each pair why it is connected or not."
		},
		{
			name: "Groups",
			testid: "block-groups",
			value: groupText(view),
			help: "Images that are connected directly or through others. Images are oriented to each other only within a group."
		},
		{
			name: "Matches",
			testid: "block-matches",
			value: count(matches),
			help: "Verified matches of all connected pairs."
		},
		...view.found === null ? [] : [{
			name: "Tie points",
			testid: "block-found",
			value: `${count(view.found.points)}, ${count(view.found.rays)} observations`,
			help: "Points seen in two or more images. A well distributed selection of them is adjusted."
		}],
		...view.refinement === null ? [] : [refinementFact(view.refinement)],
		{
			name: "Selected tie points",
			testid: "block-points-count",
			value: `${count(view.points.count)}, ${count(rays)} observations`,
			help: "The tie points of the block and their image observations."
		},
		...view.checks === null ? [] : [checkFact(view.checks)],
		{
			name: "RMSE",
			testid: "block-rmse",
			value: `${fixed(view.rmsePx, 3)} px`,
			help: "Root mean square length of the residuals of all accepted observations after the adjustment."
		},
		{
			name: "σ₀",
			testid: "block-sigma0",
			value: `${fixed(view.sigma0Px, 3)} px`,
			help: "Standard error of one image coordinate, from the adjustment."
		}
	];
}
/** Why observations keep their positions. */
var KEPT$1 = {
	not_converged: "did not converge",
	left_image: "at the border",
	moved_too_far: "moved too far",
	low_correlation: "low correlation",
	no_texture: "no texture",
	inconsistent: "inconsistent"
};
function refinementFact(counts) {
	const { reference, refined, ...kept } = counts;
	const others = Object.values(kept).reduce((sum, number) => sum + number, 0);
	const reasons = Object.entries(KEPT$1).flatMap(([outcome, words]) => {
		const number = kept[outcome];
		return number === 0 ? [] : [`${count(number)} ${words}`];
	});
	return {
		name: "Refined observations",
		testid: "block-refined",
		value: `${count(refined)} of ${count(refined + others)}`,
		help: `Observations moved by least squares matching to the reference observations of ${count(reference)} points. The others keep their positions${reasons.length > 0 ? `: ${reasons.join(", ")}` : ""}.`
	};
}
function scoreFacts(score) {
	const positions = score.position_rmse_m?.map((error) => fixed(error, 3)).join(", ");
	return [
		{
			name: "Right points",
			testid: "score-points",
			value: `${count(score.right_points)} of ${count(score.points)}`,
			help: "Points whose observations all agree within 1.5 px in each image, by the true orientations."
		},
		{
			name: "Their observations",
			testid: "score-rays",
			value: `${fixed(score.right_rmse_px, 3)} px`,
			help: "Root mean square distance of the observations of right points from their intersection."
		},
		{
			name: "Positions",
			testid: "score-positions",
			value: positions === void 0 ? "–" : `${positions} m`,
			help: "Root mean square errors of x, y, z of the projection centres after the best similarity transformation to the truth."
		},
		{
			name: "Angles",
			testid: "score-angles",
			value: `${fixed(score.angle_rmse_deg, 4)}°`,
			help: "Root mean square angle between the oriented and the true attitudes after the same transformation."
		}
	];
}
function groupText({ groups, images }) {
	const sizes = groups.map(({ length }) => length);
	const alone = sizes.filter((size) => size === 1).length;
	const largest = sizes[0] ?? 0;
	if (largest === images.length) return "one";
	return `${count(sizes.length - alone)} (the largest of ${count(largest)})${alone > 0 ? `, ${count(alone)} single` : ""}`;
}
function leftOut(view) {
	if (view.leftOut.length === 0) return null;
	return section(`Skipped: ${count(view.leftOut.length)} that cannot be read`, "block-left-out", reasons(view.leftOut));
}
function notOriented(view) {
	const lost = view.images.filter(({ oriented }) => !oriented);
	if (view.oriented === 0 || lost.length === 0) return null;
	return section(`Not oriented: ${count(lost.length)}`, "block-not-oriented", reasons(lost.map(({ name, why }) => ({
		name,
		reason: why
	}))));
}
function reasons(list) {
	const rest = list.length - LISTED;
	return h("ul", { class: "reasons" }, ...list.slice(0, LISTED).map(({ name, reason }) => h("li", {}, h("b", {}, name), `: ${reason}`)), rest > 0 ? h("li", {}, `and ${count(rest)} more in the table of images`) : null);
}
function rayTable({ byRays }) {
	const head = h("thead", {}, h("tr", {}, ...[
		"Rays",
		"Points",
		"RMSE px"
	].map((text) => h("th", { scope: "col" }, text))));
	const number = (text) => h("td", { class: "number" }, text);
	return h("table", { testid: "by-rays" }, head, h("tbody", {}, ...byRays.map(({ rays, points, rmsePx }) => row(count(rays), number(count(points)), number(fixed(rmsePx, 3))))));
}
function cameraTable({ cameras, found }) {
	const given = ({ given: known }) => known === null ? found === null ? "–" : "unknown" : fixed(known.focal_px, 1);
	const head = h("thead", {}, h("tr", {}, ...[
		"Camera",
		"Images",
		"Given f px",
		"Calibrated f px"
	].map((text) => h("th", { scope: "col" }, text))));
	const number = (text) => h("td", { class: "number" }, text);
	return h("div", { class: "scroll" }, h("table", {
		class: "tight",
		testid: "cameras"
	}, head, h("tbody", {}, ...cameras.map((camera, i) => row(`${String(i + 1)}: ${camera.label.replace(/(\d) x (?=\d)/gu, "$1 × ")}`, number(count(camera.images)), number(given(camera)), number(camera.calibrated === null ? "–" : `${fixed(camera.calibrated.focal_px, 1)}${camera.focalErrorPx === null ? "" : ` ± ${fixed(camera.focalErrorPx, 1)}`}`))))));
}
// www/shared/crate.ts
/** The crate as the page's main thread sees it: its types, its fixed data, and drawing. Everything that computes runs in workers. */
function readCatalogue() {
	return {
		version: version(),
		parameters: parameters(),
		defaults: defaults(),
		rules: rule_names(),
		flightParameters: flight_parameters(),
		paper: paper(),
		flights: flight_presets().map((name) => ({
			name,
			flight: flight_preset(name)
		}))
	};
}
// www/block/panel/settings.ts
/** What the user chooses of a run: pairs, points, recorded positions, cameras. */
/** `opener` opens the settings, and says how many were changed. */
function mountSettings(host, store, files, opener) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue === null) return;
		const { defaults } = catalogue;
		const sections = makeFolded(catalogue.parameters, {
			change: (key, value) => {
				const { settings } = store.state.options;
				if (settings !== null) store.dispatch({
					type: "options",
					options: { settings: withSetting(settings, key, value) }
				});
			},
			defaults: () => defaults,
			refused: (label) => store.dispatch({
				type: "refused",
				label
			})
		}, {
			title: "Method",
			first: ["pairs.rule", "refinement.method"],
			reset: () => store.dispatch({
				type: "options",
				options: { settings: defaults }
			}),
			changed: (count) => fill(opener, settingsText(count))
		});
		const [back, method, ...others] = sections.elements;
		fill(host, back ?? null, method ?? null, positions(store), waiting(files), besides(store, files), ...others);
		store.watch((s) => [s.options.settings], ([settings]) => {
			if (settings !== null) sections.show(settings, acting_block_parameters(settings));
		});
	});
}
/** Whether recorded positions are used. */
function positions(store) {
	const input = h("input", {
		id: "block-gps",
		type: "checkbox",
		testid: "block-gps"
	});
	input.addEventListener("change", () => store.dispatch({
		type: "options",
		options: { gps: input.checked ? "use" : "ignore" }
	}));
	store.watch((s) => [s.options.gps], ([gps]) => {
		input.checked = gps === "use";
	});
	return h("div", { class: "control" }, h("div", { class: "control-head" }, input, h("label", { for: input.id }, "Use GNSS positions")), h("p", { class: "help" }, "They choose near pairs and georeference the block."));
}
/** Whether images that are given wait for Run. */
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
	return h("div", { class: "control" }, h("div", { class: "control-head" }, input, h("label", { for: input.id }, "Wait for Run")), h("p", { class: "help" }, "Images that are given wait until Run is pressed, so that settings and files come first. Otherwise they run at once."));
}
var CAMERAS = "From EXIF. A JSON file overrides it: {\"cameras\": [{\"images\": \"DJI_*.JPG\", \"focal_px\": 3666.7}]}, with principal_point_px, radial, tangential, fixed where known.";
var CONTROL = "None. Two files georeference the block: ground control points (name, x, y, z, optionally two standard errors) and their image measurements (image, point, column, row), one per line.";
/** Files that say more of the block than its images do. */
function besides(store, files) {
	return h("fieldset", { class: "group" }, h("legend", {}, "Files"), textFile(store, files, "cameras", "Cameras", CAMERAS, ".json,application/json"), textFile(store, files, "control", "Ground control points", CONTROL, ".txt,.csv,text/*"), textFile(store, files, "marks", "Image measurements", "", ".txt,.csv,text/*"), masks(store, files));
}
var MASKS = "None. Images of the same size, black where no features are detected; IMG_1.png, IMG_1_mask.png or IMG_1.jpg.png is the mask of IMG_1.jpg.";
/** What is wrong with what was given, beside where it is given. */
function problemOf(store, given) {
	const line = h("p", {
		class: "field-problem",
		testid: `block-${given}-problem`
	});
	store.watch(["files", "options"], () => {
		const text = problemsOf(store.state)[given] ?? "";
		if (line.textContent !== text) line.textContent = text;
	});
	return line;
}
function masks(store, files) {
	const part = besideField(store, "masks", "Masks", {
		multiple: true,
		accept: "image/*,.tif,.tiff,.pgm,.pnm"
	}, (given) => files.takeMasks(given), () => store.dispatch({
		type: "options",
		options: { masks: [] }
	}));
	store.watch((s) => [s.options.masks], ([given]) => {
		const names = given.slice(0, 3).map(({ name }) => name).join(", ");
		part.show(given.length === 0 ? null : given.length === 1 ? names : `${String(given.length)} masks: ${names}${given.length > 3 ? " …" : ""}`, MASKS);
	});
	return part.element;
}
function textFile(store, files, option, title, none, accept) {
	const part = besideField(store, option, title, { accept }, ([file]) => {
		if (file !== void 0) files.takeText(option, file);
	}, () => store.dispatch({
		type: "options",
		options: { [option]: null }
	}));
	store.watch((s) => [s.options[option]], ([given]) => part.show(given?.name ?? null, none));
	return part.element;
}
/** A file or files beside the images: a button that asks for them, their names, what is wrong with them, and a button that takes them away. */
function besideField(store, given, title, how, take, clear) {
	const [press, input] = fileButton(`${title} …`, {
		testid: `block-${given}`,
		label: `File: ${title}`,
		...how
	}, take);
	const remove = button("Remove", `block-${given}-remove`, clear);
	remove.setAttribute("aria-label", `Remove: ${title}`);
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
// www/shared/panel/zoom.ts
/** The buttons that enlarge a picture. */
var STEP = 1.5;
/** `prefix` of their test ids; `whole` says what Fit shows; `picture` is asked at each press. */
function zoomButtons(prefix, whole, picture) {
	return [
		labelled("−", `${prefix}zoom-out`, "Zoom out (−)", () => picture().zoomMiddle(1 / STEP)),
		labelled("+", `${prefix}zoom-in`, "Zoom in (+)", () => picture().zoomMiddle(STEP)),
		labelled("Fit", `${prefix}zoom-fit`, `${whole} (0)`, () => picture().fit())
	];
}
/** A button whose sign says less than its label. */
function labelled(text, testid, label, action) {
	const made = button(text, testid, action, label);
	made.setAttribute("aria-label", label);
	return made;
}
// www/shared/view/layers.ts
function contextOf(canvas) {
	const context = canvas.getContext("2d");
	if (context === null) throw new Error("this browser offers no canvas to draw on");
	return context;
}
/** Draws within a rectangle alone. */
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
	dirty = /* @__PURE__ */ new Set();
	frame = 0;
	/** Device px per CSS px. */
	ratio = 1;
	width = 1;
	height = 1;
	/** `names` from the lowest layer to the highest; `paint` draws one of them, in CSS px. */
	constructor(host, names, paint) {
		this.host = host;
		this.names = names;
		this.paint = paint;
		this.contexts = Object.fromEntries(names.map((name) => [name, contextOf(canvasIn(host, name))]));
		new ResizeObserver(() => this.resize()).observe(host);
	}
	redraw(...names) {
		for (const name of names.length > 0 ? names : this.names) this.dirty.add(name);
		if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
	}
	/** The place of a pointer, CSS px. */
	place(event) {
		const box = this.host.getBoundingClientRect();
		return [event.clientX - box.left, event.clientY - box.top];
	}
	/** The picture as it is on the screen, all layers together. */
	snapshot() {
		this.draw();
		const canvas = document.createElement("canvas");
		canvas.width = Math.round(this.width * this.ratio);
		canvas.height = Math.round(this.height * this.ratio);
		const context = contextOf(canvas);
		for (const name of this.names) context.drawImage(this.contexts[name].canvas, 0, 0);
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
/** The position that a place of the canvas shows. */
function toPosition(t, x, y) {
	return [(x - t.x) / t.scale, (y - t.y) / t.scale];
}
function panned(t, dx, dy) {
	return {
		scale: t.scale,
		x: t.x + dx,
		y: t.y + dy
	};
}
/** Enlarged by a factor about a place of the canvas, within limits of the scale. */
function zoomedAbout(t, factor, x, y, { least, most }) {
	const scale = Math.min(most, Math.max(least, t.scale * factor));
	const actual = scale / t.scale;
	return {
		scale,
		x: x + actual * (t.x - x),
		y: y + actual * (t.y - y)
	};
}
// www/shared/view/colours.ts
/** The colours of the page's theme, for canvases. */
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
/** The colours as they are now. Custom properties hold both themes' colours; an element's own colour is the one that counts. */
function themeColours() {
	known ??= readColours();
	return known;
}
function readColours() {
	const probe = document.createElement("span");
	document.body.append(probe);
	const colours = Object.fromEntries(NAMES.map((name) => {
		probe.style.color = `var(--${name})`;
		return [name, getComputedStyle(probe).color];
	}));
	probe.remove();
	return colours;
}
/** Calls back when the theme was changed, by the user or by the system. */
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
}
// www/shared/view/gestures.ts
/** Movement below which a press is a click, CSS px. */
var CLICK_SLACK = 5;
var KEY_PAN = 60;
var KEY_ZOOM = 1.25;
/** Wheels that count in lines scroll about so many px each. */
var LINE_PX = 24;
/** Natural logarithm of the enlargement a px of wheel; a pinch on a touch pad comes as a wheel event with Ctrl and small steps. */
var WHEEL_RATE = .0016;
var PINCH_RATE = .01;
var ARROWS$1 = {
	ArrowLeft: [1, 0],
	ArrowRight: [-1, 0],
	ArrowUp: [0, 1],
	ArrowDown: [0, -1]
};
/** Listens on a host, and for keys on it or on a larger element that belongs to it. */
function listen(host, movable, keyHost = host) {
	new Gestures(host, movable, keyHost);
}
var Gestures = class {
	host;
	movable;
	presses = /* @__PURE__ */ new Map();
	target = null;
	clicked = false;
	encloses = false;
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
			this.movable.enclosed?.(this.target, [press.startX, press.startY], [x, y], false);
			return;
		}
		const still = [...this.presses].find(([id]) => id !== event.pointerId)?.[1];
		if (still === void 0) this.movable.pan(this.target, x - press.x, y - press.y);
		else this.pinch(this.target, press, still, x, y);
		press.x = x;
		press.y = y;
	}
	/** Two fingers: pan by their middle, zoom by their distance. */
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
		else if (this.encloses && this.target !== null) this.movable.enclosed?.(this.target, [press.startX, press.startY], this.place(event), true);
		this.encloses = false;
	}
	leave(event) {
		this.presses.delete(event.pointerId);
		this.giveUp();
	}
	giveUp() {
		if (this.encloses && this.target !== null) this.movable.enclosed?.(this.target, [0, 0], null, false);
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
	/** The keys that move a picture; with Shift they pan farther. */
	moved({ key, shiftKey }) {
		const [dx, dy] = ARROWS$1[key] ?? [0, 0];
		const target = this.movable.focused();
		if (dx !== 0 || dy !== 0) {
			const step = KEY_PAN * (shiftKey ? 4 : 1);
			if (target !== null) this.movable.pan(target, dx * step, dy * step);
			return true;
		}
		if (key === "+" || key === "=") this.movable.zoomMiddle(KEY_ZOOM);
		else if (key === "-" || key === "_") this.movable.zoomMiddle(1 / KEY_ZOOM);
		else if (key === "0") this.movable.fit();
		else return false;
		return true;
	}
};
// www/block/view/looking.ts
/** A press chooses; a press on the pair that is chosen opens it. */
function press$1(store, looking, choice) {
	const { choice: before } = store.state;
	const again = choice?.kind === "pair" && before?.kind === "pair" && choice.images.every((image) => before.images.includes(image));
	if (choice?.kind === "pair" && again && !isBusy$1(store.state)) looking.open(choice.images);
	else looking.choose(choice);
}
// www/block/view/chart.ts
/** What the picture and the matrix of a block have in common: shown whole until it is moved, pointed at, pressed. */
var Chart = class {
	store;
	looking;
	layers;
	/** Null: all of it is shown. */
	moved = null;
	of = null;
	/** What the pointer is over. */
	hovered = null;
	constructor(host, name, store, looking) {
		this.store = store;
		this.looking = looking;
		this.layers = new Layers(host, [name], (_, context) => {
			const view = this.view();
			if (view !== null && view.images.length > 0) this.paint(context, themeColours(), view, this.current(view));
		});
		onRecolour(() => this.layers.redraw());
		listen(host, {
			at: () => this.view(),
			focused: () => this.view(),
			pan: (view, dx, dy) => this.move(view, panned(this.current(view), dx, dy)),
			zoom: (view, factor, x, y) => this.zoom(view, factor, x, y),
			zoomMiddle: (factor) => this.zoomMiddle(factor),
			fit: () => this.fit(),
			pressed: (x, y) => press$1(store, looking, this.choiceAt(x, y)),
			pointed: (at, dragging) => {
				if (!dragging) this.hover(at === null ? null : this.choiceAt(...at));
			},
			command: (key) => this.command(key) || this.commandOfChoice(key)
		});
		store.watch(["shown", "choice"], ([shown]) => {
			const same = shown?.view.partial === true && this.of?.partial === true && shown.view.layout.kind === this.of.layout.kind;
			if (shown?.view !== this.of && !same) this.moved = null;
			this.of = shown?.view ?? null;
			this.layers.redraw();
		});
	}
	/** Keeps it in sight. */
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
		return this.moved ?? this.whole(view);
	}
	move(view, t) {
		this.moved = this.held(view, t);
		this.layers.redraw();
	}
	zoom(view, factor, x, y) {
		this.move(view, zoomedAbout(this.current(view), factor, x, y, this.limits(this.whole(view).scale)));
	}
	choiceAt(x, y) {
		const view = this.view();
		return view === null ? null : this.hit(view, this.current(view), x, y);
	}
	hover(choice) {
		this.hovered = choice;
		this.looking.point(choice);
		this.layers.redraw();
	}
	commandOfChoice(key) {
		const { choice } = this.store.state;
		if (key === "Enter" && choice?.kind === "pair") this.looking.open(choice.images);
		else if (key === "Escape") this.looking.choose(null);
		else return false;
		return true;
	}
};
// www/block/view/matrix.ts
/** Side of a cell in CSS px: in the whole matrix, and enlarged. */
var LARGEST_WHOLE = 44;
var LARGEST = 160;
/** Room for the numbers of the images. */
var HEAD$3 = 30;
/** From this side on a cell holds the number of matches. */
var NUMBERED = 30;
var Matrix = class extends Chart {
	constructor(host, store, looking) {
		super(host, "matrix", store, looking);
	}
	whole({ images: { length } }) {
		const room = Math.min(this.layers.width, this.layers.height) - HEAD$3 - 4;
		const side = Math.min(LARGEST_WHOLE, room / Math.max(1, length));
		return {
			scale: side > 4 ? Math.floor(side) : side,
			x: HEAD$3,
			y: HEAD$3
		};
	}
	limits(whole) {
		return {
			least: whole,
			most: LARGEST
		};
	}
	/** It leaves the heads only towards the upper left, and its last cell comes no farther than the middle. */
	held({ images: { length } }, { scale, x, y }) {
		const within = (shift, room) => Math.min(HEAD$3, Math.max(Math.min(HEAD$3, (HEAD$3 + room) / 2 - length * scale), shift));
		return {
			scale,
			x: within(x, this.layers.width),
			y: within(y, this.layers.height)
		};
	}
	hit(view, t, x, y) {
		const [column, row] = toPosition(t, x, y).map(Math.floor);
		const inside = (index) => index >= 0 && index < view.images.length;
		return x >= HEAD$3 && y >= HEAD$3 && inside(column) && inside(row) ? choiceOf([row, column]) : null;
	}
	/** Arrows go from cell to cell. */
	command(key) {
		const step = {
			ArrowLeft: [0, -1],
			ArrowRight: [0, 1],
			ArrowUp: [-1, 0],
			ArrowDown: [1, 0]
		}[key];
		const view = this.view();
		if (step === void 0 || view === null) return false;
		const { choice } = this.store.state;
		const [row, column] = choice === null ? [0, 0] : cellOf$1(choice);
		const inside = (index) => Math.min(Math.max(index, 0), view.images.length - 1);
		const cell = [inside(row + (step[0] ?? 0)), inside(column + (step[1] ?? 0))];
		this.looking.choose(choiceOf(cell));
		this.reveal(view, cell);
		return true;
	}
	/** Brings a cell into sight. */
	reveal(view, [row, column]) {
		const t = this.current(view);
		const brought = (index, shift, room) => Math.max(HEAD$3 - index * t.scale, Math.min(shift, room - (index + 1) * t.scale - 2));
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
		const most = view.connections.reduce((high, connection) => Math.max(high, matchesOf(connection)), 1);
		for (const connection of connectionsOf(view).values()) {
			const [a, b] = connection.images;
			const matches = matchesOf(connection);
			const tried = connection.outcome.kind === "connected";
			const alpha = tried ? .15 + .85 * Math.sqrt(matches / most) : .6;
			for (const [row, column] of [[a, b], [b, a]]) {
				const [x, y] = toCanvas(t, column, row);
				if (x > this.layers.width || y > this.layers.height || x + side < HEAD$3 || y + side < HEAD$3) continue;
				context.globalAlpha = alpha;
				context.fillStyle = tried ? colours.bars : connection.outcome.kind === "failed" ? colours.problem : colours.muted;
				paintCell(context, x, y, side, tried);
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
		const { choice } = this.store.state;
		const { scale: side } = t;
		context.strokeStyle = colours.accent;
		context.lineWidth = 2;
		const cells = [choice?.kind === "pair" ? choice : null, this.hovered].filter((one) => one !== null);
		for (const [row, column] of cells.map(cellOf$1)) {
			context.strokeRect(...toCanvas(t, column, row), side, side);
			if (connectionOf(view, [row, column]) !== void 0) context.strokeRect(...toCanvas(t, row, column), side, side);
		}
		if (choice?.kind !== "image") return;
		const length = view.images.length * side;
		context.strokeRect(...toCanvas(t, 0, choice.image), length, side);
		context.strokeRect(...toCanvas(t, choice.image, 0), side, length);
	}
};
function choiceOf([row, column]) {
	return row === column ? {
		kind: "image",
		image: row
	} : {
		kind: "pair",
		images: [row, column]
	};
}
/** Of an image that on the diagonal. */
function cellOf$1(choice) {
	return choice.kind === "pair" ? choice.images : [choice.image, choice.image];
}
/** A pair that was tried in vain is a small square: told apart from a weak one without its colour. */
function paintCell(context, x, y, side, connected) {
	const gap = side > 8 ? 1 : 0;
	const share = side > 12 ? .28 : .6;
	if (connected) context.fillRect(x, y, side - gap, side - gap);
	else context.fillRect(x + .5 * (1 - share) * side, y + .5 * (1 - share) * side, share * side, share * side);
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
/** Numbers of the images, as in their table, so many that they do not touch; they stay in sight wherever the matrix is moved. */
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
		if (x > HEAD$3 && x < width) context.fillText(String(i + 1), x, 24);
		context.textAlign = "right";
		if (y > HEAD$3 && y < height) context.fillText(String(i + 1), 25, y + 3.5);
	}
}
// www/block/view/thumbs.ts
/** Longer side of a copy, px. */
var SIDE$1 = 160;
var Thumbs = class {
	arrived;
	/** By the file's number; null where the browser cannot decode it. */
	made = /* @__PURE__ */ new Map();
	waiting = [];
	making = false;
	constructor(arrived) {
		this.arrived = arrived;
	}
	/** The copy; null while there is none. */
	get(file) {
		const found = this.made.get(file.id);
		if (found === void 0 && !this.waiting.includes(file)) {
			this.waiting.push(file);
			this.make();
		}
		return found ?? null;
	}
	async make() {
		if (this.making) return;
		this.making = true;
		for (let next = this.waiting[0]; next !== void 0; next = this.waiting[0]) {
			this.made.set(next.id, await copyOf(next.file));
			this.waiting.shift();
			this.arrived();
		}
		this.making = false;
	}
};
async function copyOf(file) {
	try {
		return await createImageBitmap(file, {
			resizeWidth: SIDE$1,
			resizeQuality: "medium"
		});
	} catch {
		return null;
	}
}
// www/block/view/plan.ts
/** The plan of a block: where its images are drawn, which lines join them, and what lies at a place. Lengths are CSS px. */
var MARK_REACH = 12;
var LINE_REACH = 6;
/** The view that shows all images. The plan's y goes up, the canvas's down. */
function fitPlan({ layout: { places } }, width, height) {
	const box = [
		Infinity,
		Infinity,
		-Infinity,
		-Infinity
	];
	for (let i = 0; i < places.length; i += 2) {
		const [x = 0, y = 0] = places.subarray(i, i + 2);
		box[0] = Math.min(box[0], x);
		box[1] = Math.min(box[1], y);
		box[2] = Math.max(box[2], x);
		box[3] = Math.max(box[3], y);
	}
	if (places.length === 0) return {
		scale: 1,
		x: 0,
		y: 0
	};
	const room = (length) => Math.max(10, length - 124);
	const spread = (low, high) => Math.max(high - low, 1e-9);
	const scale = Math.min(room(width) / spread(box[0], box[2]), room(height) / spread(box[1], box[3]));
	return {
		scale,
		x: width / 2 - scale * (box[0] + box[2]) / 2,
		y: height / 2 + scale * (box[1] + box[3]) / 2
	};
}
function placeOf$1(view, plan, image) {
	const [x = 0, y = 0] = view.layout.places.subarray(2 * image, 2 * image + 2);
	return toCanvas(plan, x, -y);
}
var SPACINGS = /* @__PURE__ */ new WeakMap();
/** The least distance of two images, in units of the plan. */
function spacingOf(view) {
	const known = SPACINGS.get(view);
	if (known !== void 0) return known;
	const { places } = view.layout;
	let least = Infinity;
	for (let i = 0; i < places.length; i += 2) for (let j = 0; j < i; j += 2) least = Math.min(least, Math.hypot((places[i] ?? 0) - (places[j] ?? 0), (places[i + 1] ?? 0) - (places[j + 1] ?? 0)));
	SPACINGS.set(view, least);
	return least;
}
var WIDEST_THUMB = 110;
var LEAST_THUMB = 26;
/** How wide images are drawn, CSS px, so that they do not cover each other; 0 where they are too near to be more than dots. */
function thumbWidth(view, plan) {
	if (view.images.length > 150) return 0;
	const width = Math.min(WIDEST_THUMB, .8 * spacingOf(view) * plan.scale);
	return width < LEAST_THUMB ? 0 : width;
}
var LINES = /* @__PURE__ */ new WeakMap();
/** The lines of a block, the weakest first, so that the strong ones lie on top. */
function linesOf(view) {
	const known = LINES.get(view);
	if (known !== void 0) return known;
	const connected = view.connections.filter(({ outcome }) => outcome.kind === "connected");
	const joined = connected.some(({ shared }) => shared > 0);
	const weight = (connection) => joined ? connection.shared : matchesOf(connection);
	const most = connected.reduce((high, connection) => Math.max(high, weight(connection)), 1);
	const made = connected.map((connection) => ({
		images: connection.images,
		strength: Math.sqrt(weight(connection) / most)
	})).map((line) => ({
		...line,
		width: .6 + 6.4 * line.strength
	})).sort((a, b) => a.width - b.width);
	LINES.set(view, made);
	return made;
}
/** The image at a place, else the pair whose line passes there. */
function hitPlan(view, plan, x, y) {
	let image = -1;
	let least = Math.max(MARK_REACH, thumbWidth(view, plan) / 2);
	view.images.forEach((_, i) => {
		const [px, py] = placeOf$1(view, plan, i);
		const distance = Math.hypot(px - x, py - y);
		if (distance < least) [image, least] = [i, distance];
	});
	if (image >= 0) return {
		kind: "image",
		image
	};
	let found = null;
	let nearest = Infinity;
	for (const line of linesOf(view)) {
		const distance = toSegment(placeOf$1(view, plan, line.images[0]), placeOf$1(view, plan, line.images[1]), x, y);
		if (distance <= Math.max(LINE_REACH, line.width / 2 + 2) && distance < nearest) [found, nearest] = [line, distance];
	}
	return found === null ? null : {
		kind: "pair",
		images: found.images
	};
}
/** The distance of a place from a line between two others. */
function toSegment([ax, ay], [bx, by], x, y) {
	const [dx, dy] = [bx - ax, by - ay];
	const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / Math.max(dx * dx + dy * dy, 1e-9)));
	return Math.hypot(ax + along * dx - x, ay + along * dy - y);
}
// www/block/view/picture.ts
/** Above so many images only those that are pointed at or chosen have their names. */
var NAMED = 60;
/** Of a name: its base line below the middle of its image, its height, and the room to the next one; in CSS px. */
var NAME_BELOW = 19;
var NAME_HEIGHT = 13;
var NAME_GAP = 6;
var Picture = class extends Chart {
	thumbs = new Thumbs(() => this.layers.redraw());
	constructor(host, store, looking) {
		super(host, "plan", store, looking);
	}
	whole(view) {
		return fitPlan(view, this.layers.width, this.layers.height);
	}
	limits(whole) {
		return {
			least: .2 * whole,
			most: 200 * whole
		};
	}
	hit(view, plan, x, y) {
		return hitPlan(view, plan, x, y);
	}
	command(key) {
		switch (key) {
			case "n":
			case "N":
				this.step(1);
				return true;
			case "p":
			case "P":
				this.step(-1);
				return true;
			case "c":
			case "C":
				this.stepPair();
				return true;
			default: return false;
		}
	}
	/** Chooses the next image. */
	step(by) {
		const count = this.view()?.images.length ?? 0;
		const { choice } = this.store.state;
		const now = choice === null ? by > 0 ? -1 : 0 : choice.kind === "image" ? choice.image : choice.images[0];
		if (count > 0) this.looking.choose({
			kind: "image",
			image: (now + by + count) % count
		});
	}
	/** Chooses the next connection of the image that is chosen, or of the first of the pair. */
	stepPair() {
		const view = this.view();
		const { choice } = this.store.state;
		if (view === null || choice === null) return;
		const image = choice.kind === "image" ? choice.image : choice.images[0];
		const own = view.connections.map(({ images }) => images).filter((images) => images.includes(image)).map(([a, b]) => a === image ? [a, b] : [b, a]);
		const next = own[((choice.kind === "pair" ? own.findIndex(([, b]) => b === choice.images[1]) : -1) + 1) % Math.max(1, own.length)];
		if (next !== void 0) this.looking.choose({
			kind: "pair",
			images: next
		});
	}
	paint(context, colours, view, plan) {
		const marked = [this.store.state.choice, this.hovered].filter((choice) => choice !== null);
		paintLines(context, colours, view, plan, marked);
		paintImages(context, colours, view, plan, marked);
		paintNames(context, colours, view, plan, marked, this.paintThumbs(context, colours, view, plan, marked));
	}
	/** Paints the photos over their dots once a run has ended; gives how far below the middle of an image its name stands. */
	paintThumbs(context, colours, view, plan, marked) {
		const width = thumbWidth(view, plan);
		const { shown, files, running } = this.store.state;
		if (width === 0 || shown === null || running.kind === "yes") return NAME_BELOW;
		const ofName = new Map([...files, ...shown.files].map((file) => [file.name, file]));
		const isSound = soundness(view);
		let below = NAME_BELOW;
		view.images.forEach(({ name }, i) => {
			const file = ofName.get(name);
			const thumb = file === void 0 ? null : this.thumbs.get(file);
			if (thumb === null) return;
			const height = width * thumb.height / thumb.width;
			const [x, y] = placeOf$1(view, plan, i);
			context.drawImage(thumb, x - width / 2, y - height / 2, width, height);
			const on = marked.some((choice) => choice.kind === "image" ? choice.image === i : choice.images.includes(i));
			context.lineWidth = on ? 3 : 1.5;
			context.strokeStyle = on ? colours.accent : isSound(i) ? colours.surface : colours.problem;
			context.strokeRect(x - width / 2, y - height / 2, width, height);
			below = Math.max(below, height / 2 + NAME_HEIGHT);
		});
		return below;
	}
};
/** Tells whether an image is oriented, or at least connected with most. While a run goes on nothing is said against an image. */
function soundness(view) {
	const largest = new Set(view.groups[0]);
	return (image) => view.partial || (view.layout.kind === "oriented" ? view.images[image]?.oriented === true : largest.has(image));
}
function isOf(choice, images) {
	return choice.kind === "image" ? images.includes(choice.image) : images.every((image) => choice.images.includes(image));
}
function paintLines(context, colours, view, plan, marked) {
	context.lineCap = "round";
	for (const { images, width, strength } of linesOf(view)) {
		const on = marked.some((choice) => isOf(choice, images));
		context.globalAlpha = on ? 1 : (marked.length > 0 ? .35 : 1) * (.3 + .5 * strength);
		context.strokeStyle = on ? colours.accent : colours.bars;
		context.lineWidth = on ? Math.max(width, 2) : width;
		paintLine(context, view, plan, images);
	}
	context.globalAlpha = 1;
	paintRefused(context, colours, view, plan, marked);
}
function paintLine(context, view, plan, [a, b]) {
	context.beginPath();
	context.moveTo(...placeOf$1(view, plan, a));
	context.lineTo(...placeOf$1(view, plan, b));
	context.stroke();
}
/** Pairs that were tried in vain, dashed: those of the image that is chosen, and the pair that is chosen itself. */
function paintRefused(context, colours, view, plan, marked) {
	context.setLineDash([4, 4]);
	context.lineWidth = 1;
	for (const { images, outcome } of view.connections) {
		if (outcome.kind === "connected" || !marked.some((choice) => isOf(choice, images))) continue;
		context.strokeStyle = outcome.kind === "failed" ? colours.problem : colours.muted;
		paintLine(context, view, plan, images);
	}
	context.setLineDash([]);
}
function paintImages(context, colours, view, plan, marked) {
	const isSound = soundness(view);
	view.images.forEach((_, i) => {
		const [x, y] = placeOf$1(view, plan, i);
		const on = marked.some((choice) => choice.kind === "image" ? choice.image === i : choice.images.includes(i));
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
/** Names below their images, as far as there is room beside each other: first those that are pointed at or chosen, which always stand. */
function paintNames(context, colours, view, plan, marked, below) {
	context.font = "11px system-ui, sans-serif";
	context.textAlign = "center";
	const isMarked = (image) => marked.some((choice) => choice.kind === "image" ? choice.image === image : choice.images.includes(image));
	const all = view.images.map((_, image) => image);
	const named = [...all.filter(isMarked), ...view.images.length > NAMED ? [] : all.filter((image) => !isMarked(image))];
	const taken = [];
	for (const image of named) {
		const text = (view.images[image]?.name ?? "").replace(/\.[^.]+$/u, "");
		const [x, middle] = placeOf$1(view, plan, image);
		const [y, half] = [middle + below, .5 * context.measureText(text).width];
		if (taken.some((other) => Math.abs(other.x - x) < other.half + half + NAME_GAP && Math.abs(other.y - y) < NAME_HEIGHT) && !isMarked(image)) continue;
		taken.push({
			x,
			y,
			half
		});
		paintName(context, colours, text, x, y);
	}
}
function paintName(context, colours, text, x, y) {
	context.lineWidth = 3;
	context.strokeStyle = colours.ground;
	context.strokeText(text, x, y);
	context.fillStyle = colours.text;
	context.fillText(text, x, y);
}
// www/block/panel/stage.ts
/** The middle of the block's page: its picture or its matrix, and what is said of what is pointed at or chosen. */
var LAYOUTS = {
	oriented: "Oriented positions, from above",
	recorded: "GNSS positions, from above",
	connections: "Arranged by connections: positions have no meaning"
};
function mountStage(host, store, looking, invitation) {
	const pictureHost = h("div", {
		class: "view block-view",
		id: "block-view",
		testid: "block-picture",
		tabindex: 0,
		role: "group",
		aria: {
			roledescription: "plan of the block",
			label: "Images of the block, joined by lines whose width grows with their common points",
			describedby: "block-keys"
		}
	});
	const matrixHost = h("div", {
		class: "view block-matrix",
		testid: "block-matrix",
		tabindex: 0,
		hidden: true,
		role: "group",
		aria: {
			roledescription: "matrix of matches",
			label: "Images by images; arrow keys choose a pair",
			describedby: "block-keys"
		}
	});
	const pointed = h("p", {
		class: "pointed",
		testid: "block-pointed"
	});
	const chosen = h("p", {
		class: "chosen",
		testid: "block-chosen",
		role: "status",
		aria: { live: "polite" }
	});
	const open = button("Open this pair", "block-open-pair", () => {
		const { choice } = store.state;
		if (choice?.kind === "pair") looking.open(choice.images);
	});
	const hint = "Point at an image, a line or a cell to see what it is and why a pair is not connected.";
	let pointedAt = null;
	const showPointed = () => {
		say$1(pointed, store, pointedAt, hint);
		if (pointed.textContent === chosen.textContent) pointed.textContent = "";
	};
	const looks = {
		...looking,
		point: (choice) => {
			pointedAt = choice;
			showPointed();
		}
	};
	const picture = new Picture(pictureHost, store, looks);
	const matrix = new Matrix(matrixHost, store, looks);
	const layout = h("span", {
		class: "note",
		testid: "block-layout"
	});
	const cells = h("span", {
		class: "note",
		testid: "block-cells",
		hidden: true
	});
	const switched = switcher([[
		"Picture",
		pictureHost,
		layout
	], [
		"Matrix",
		matrixHost,
		cells
	]]);
	const tools = h("div", { class: "actions" }, ...zoomButtons("block-", "Whole block", () => matrixHost.hidden ? picture : matrix));
	host.append(h("div", {
		class: "toolbar",
		role: "toolbar",
		aria: { label: "View of the block" }
	}, switched.element, tools, layout, cells), welcomed(pictureHost, store, invitation), matrixHost, h("div", { class: "said" }, h("div", {}, chosen, pointed), open), h("p", {
		class: "keys",
		id: "block-keys"
	}, "Press an image, a line or a cell to choose it; press a pair again, or Enter, to open it. Drag pans · wheel and + − zoom · 0 fit. Picture: N P images · C pairs of an image · arrows pan. Matrix: arrows choose."));
	looks.point(null);
	store.watch(["shown"], ([shown]) => {
		if (shown === null) switched.show(0);
	});
	store.watch([
		"choice",
		"shown",
		"running",
		"notice"
	], ([choice, shown]) => {
		say$1(chosen, store, choice, "");
		showPointed();
		open.hidden = choice?.kind !== "pair" || shown === null;
		open.disabled = isBusy$1(store.state);
		fill(layout, shown === null ? "" : legend(shown.view));
		fill(cells, shown === null ? "" : cellLegend(shown.view));
	});
}
function mostMatches({ connections }) {
	return connections.reduce((high, connection) => Math.max(high, matchesOf(connection)), 0);
}
/** What cells mean. */
function cellLegend(view) {
	return `Strongest cell: ${count(mostMatches(view))} matches. Small square: not connected. Blank: not tried.`;
}
/** What places and lines mean. */
function legend(view) {
	const most = view.connections.reduce((high, { shared }) => Math.max(high, shared), 0);
	const matches = mostMatches(view);
	const widest = most > 0 ? `${count(most)} common points` : `${count(matches)} matches`;
	return `${LAYOUTS[view.layout.kind]}. ${most + matches > 0 ? `Widest line: ${widest}.` : ""}`;
}
function say$1(element, store, choice, otherwise) {
	const { shown } = store.state;
	const text = choice === null || shown === null ? otherwise : describe(shown.view, choice);
	if (element.textContent !== text) element.textContent = text;
}
/** Buttons of which one is pressed: its part is shown, with the tools that belong to it. */
function switcher(parts) {
	const buttons = parts.map(([name], i) => button(name, `block-show-${name.toLowerCase()}`, () => show(i)));
	const show = (shown) => {
		parts.forEach(([, part, tools], i) => {
			part.hidden = i !== shown;
			tools.hidden = i !== shown;
			buttons[i]?.setAttribute("aria-pressed", String(i === shown));
		});
	};
	return {
		element: h("div", {
			class: "mode",
			role: "group",
			aria: { label: "Shown" }
		}, ...buttons),
		show
	};
}
/** The picture with the invitation over it while there is no block. */
function welcomed(host, store, { sample, open }) {
	const own = button("Open your photos …", "block-open-first", open);
	own.className = "primary";
	const simulate = button("Try a sample block", "block-simulate-first", sample);
	const list = h("p", {
		class: "note",
		testid: "block-given"
	});
	const welcome = h("div", {
		class: "welcome",
		testid: "block-welcome"
	}, h("h2", {}, "Where did each photo stand?"), h("p", {}, "Drop the photographs of a flight or of a walk around something, or a folder of them, anywhere on this page. You get:"), h("ul", {}, ...[
		"where each photo was taken and how it was turned",
		"points that several photos show, in space, and how precise they are",
		"a plain word on whether the result can be trusted, and why",
		"files for other programs: COLMAP, MicMac, OpenSfM, Agisoft and more"
	].map((gain) => h("li", {}, gain))), h("p", { class: "buttons" }, own, simulate), list, h("p", { class: "note" }, "Nothing leaves this computer. Work is kept in this browser: a run that was cancelled, or ended with its tab, goes on from there."));
	host.append(welcome);
	store.watch([
		"shown",
		"files",
		"running",
		"notice",
		"catalogue"
	], ([shown, given, , , catalogue]) => {
		welcome.hidden = shown !== null;
		for (const press of [own, simulate]) press.disabled = catalogue === null || isBusy$1(store.state);
		const names = given.map(({ name }) => name);
		fill(list, names.length === 0 ? "" : `${String(names.length)} images: ${names.slice(0, 8).join(", ")}${names.length > 8 ? " …" : ""}`);
	});
	return host;
}
// www/shared/panel/answer.ts
/** The answer: what came of a run in one sentence, the figures that decided, and what to do next. It stands beside the picture, where nothing has to be scrolled. */
/** Shows answers in `host`, whose line for the sentence is `line`; the button for what is next comes before the others. */
function answerCard(host, line, buttons, prefix) {
	const figures = h("dl", {
		class: "figures",
		testid: `${prefix}figures`
	});
	let act = () => void 0;
	const press = button("", `${prefix}next`, () => act());
	press.className = "primary";
	line.after(figures);
	buttons.prepend(press);
	return ({ kind, verdict, text, more = "", figures: found = [], next = null }) => {
		host.dataset.kind = kind;
		host.dataset.verdict = verdict ?? "";
		line.dataset.kind = kind;
		if (line.textContent !== (more === "" ? text : `${text} ${more}`)) fill(line, h("strong", {}, text), more === "" ? null : " ", more === "" ? null : h("span", {}, more));
		fill(figures, ...found.map(({ value, label }) => h("div", {}, h("dt", {}, label), h("dd", {}, value))));
		figures.hidden = found.length === 0;
		act = next?.act ?? (() => void 0);
		press.hidden = next === null;
		if (press.textContent !== (next?.text ?? "")) press.textContent = next?.text ?? "";
	};
}
// www/shared/text/names.ts
/** What is no parameter of the crate's catalogue, but named in its messages. */
var OTHER = {
	"camera.focal_mm": "Focal length",
	"camera.pixel_mm": "Pixel size",
	"camera.principal_point_mm": "Principal point",
	"camera.radial_distortion": "Radial distortion",
	"camera.tangential_distortion": "Tangential distortion",
	focal_mm: "Focal length",
	origin: "Origin in the scan"
};
/** A message with the labels of the parameters that it names by their keys. */
function readable(catalogue, message) {
	const labels = new Map(Object.entries(OTHER));
	for (const { key, label } of [...catalogue?.parameters ?? [], ...catalogue?.flightParameters ?? []]) labels.set(key, label);
	return message.replace(/[a-z]+\.[a-z0-9_]+/gu, (key) => quoted(labels.get(key)) ?? key).replace(/^(\w+)(?= is )/u, (key) => quoted(labels.get(key)) ?? key).replace(/(\d) x (?=\d)/gu, "$1 × ");
}
function quoted(label) {
	return label === void 0 ? void 0 : `“${label}”`;
}
// www/shared/text/words.ts
/** Texts of the page itself, from the catalogue of the crate. */
/** The text of a kind, with the minus sign that typography has. Numbers that are not finite are none. */
function page(kind, figures = {}) {
	const known = Object.entries(figures).map(([name, value]) => [name, typeof value === "number" && !Number.isFinite(value) ? null : value]);
	return message("page", {
		kind,
		...Object.fromEntries(known)
	}).replace(/(?<!\w)-(?=\d)/gu, "−");
}
// www/block/panel/status.ts
/** The answer of a block: what came of it; while there is none what runs, how far it is, what went wrong, and what to do. */
/** `details`: the button that shows them. */
function mountBlockStatus(store, engine, actions, details) {
	const line = h("p", {
		class: "status",
		testid: "block-status",
		role: "status",
		aria: { live: "polite" }
	});
	const run = button("Run", "block-run", () => void engine.run());
	const cancel = button("Cancel", "block-cancel", () => engine.cancel());
	const buttons = h("div", { class: "answer-actions" }, run, cancel, details);
	const card = h("div", {
		class: "answer",
		testid: "block-answer"
	}, line, buttons);
	const show = answerCard(card, line, buttons, "block-");
	store.watch((s) => [s], ([state]) => {
		const answer = answerOf$1(state, actions);
		line.setAttribute("aria-live", answer.kind === "busy" ? "off" : "polite");
		show({
			...answer,
			text: readable(state.catalogue?.labels ?? null, answer.text)
		});
		run.disabled = isBusy$1(state) || state.files.length < 2;
		run.textContent = state.running.kind === "ended" ? "Go on" : "Run";
		run.classList.toggle("primary", answer.next == null);
		cancel.disabled = !isBusy$1(state);
	});
	return card;
}
function answerOf$1(state, actions) {
	const { running, notice, shown, files } = state;
	const line = (kind, text) => ({
		kind,
		text,
		verdict: null
	});
	if (running.kind === "yes") return line("busy", runText(running.steps));
	if (notice?.beside === true) {
		const answer = answerOf$1({
			...state,
			notice: null
		}, actions);
		return {
			...answer,
			more: `${answer.more ?? ""} ${notice.text}`.trimStart()
		};
	}
	if (notice !== null) return line(notice.kind === "info" ? "idle" : notice.kind, notice.text);
	if (state.refused !== null) return line("problem", refusedText(state.refused));
	if (running.kind === "ended") {
		const former = shown !== null && !shown.view.partial ? " The screen shows the former block." : "";
		if (running.failure === null) return line("idle", `Cancelled.${former} The work done is ${former === "" ? "shown and " : ""}kept: Go on continues from there.`);
		return line("problem", `The block was not finished: ${sentence(running.failure)}${former === "" ? " The work done is kept." : former}`);
	}
	if (shown !== null && !shown.view.partial && !isOutdated(state)) return answered$1(state, shown, actions);
	if (files.length >= 2) {
		const why = shown === null || shown.view.partial ? "Press Run." : "Images or settings have changed: press Run.";
		return line("idle", `${page("block_images", { images: files.length })} ${why}`);
	}
	return line("idle", "Open the images of a block: files, a folder, or a simulated block.");
}
function answered$1(state, shown, actions) {
	const { view, files } = shown;
	const why = {
		text: "Show why",
		act: actions.why
	};
	if (view.oriented > 0 || files.length === 0) {
		const sound = view.verdict?.kind === "oriented";
		const next = state.truth === null ? {
			text: "Save the project",
			act: actions.save
		} : {
			text: "Open your photos …",
			act: actions.open
		};
		return {
			kind: sound ? "done" : "partial",
			verdict: view.verdict?.kind ?? "weak",
			text: view.verdict?.text ?? "",
			more: countsOf$1(shown),
			figures: figuresOf$1(view),
			next: sound ? next : why
		};
	}
	const group = view.groups[0]?.length ?? 0;
	return {
		kind: "problem",
		verdict: "not_oriented",
		text: page("block_not_oriented", {
			why: view.warnings[0] ?? message("overview_warning", { kind: "none_oriented" }),
			group: group < view.images.length ? group : null,
			images: view.images.length,
			pairs: connectedPairs(view),
			points: view.points.count
		}),
		next: why
	};
}
function figuresOf$1(view) {
	return [
		{
			value: `${count(view.oriented)} of ${count(view.images.length)}`,
			label: "photos oriented"
		},
		{
			value: count(view.points.count),
			label: "points on several photos"
		},
		...view.sigma0Px === null ? [] : [{
			value: `${fixed(view.sigma0Px, 2)} px`,
			label: "precision (σ₀)"
		}]
	];
}
function connectedPairs({ connections }) {
	return connections.filter(({ outcome }) => outcome.kind === "connected").length;
}
/** What there is of it, after its verdict. */
function countsOf$1({ view, seconds }) {
	return page("block_done", {
		images: view.images.length,
		verdict: "",
		skipped: view.leftOut.length,
		pairs: connectedPairs(view),
		points: view.points.count,
		found: view.found?.points ?? null,
		time: seconds === 0 ? null : duration(seconds),
		warnings: view.warnings.length
	}).trim();
}
// www/shared/state/rows.ts
/** The rows that are kept, in order of a column. Equal values keep their order. */
function ordered(count, columns, { key, descending }, keep) {
	const kept = Array.from({ length: count }, (_, row) => row).filter(keep);
	const column = columns.find((candidate) => candidate.key === key);
	if (column === void 0) return kept;
	const values = new Map(kept.map((row) => [row, column.value(row)]));
	return kept.sort((a, b) => compared(values.get(a) ?? NaN, values.get(b) ?? NaN, descending) || a - b);
}
function compared(a, b, descending) {
	const sign = descending ? -1 : 1;
	if (typeof a === "string" || typeof b === "string") return sign * String(a).localeCompare(String(b), "en", { numeric: true });
	if (Number.isNaN(a) || Number.isNaN(b)) return Number(Number.isNaN(a)) - Number(Number.isNaN(b));
	return sign * (a - b);
}
// www/shared/panel/rows.ts
/** The rows of a long table: only those in sight exist, between two fillers as high as the others would be. */
/** Height of a row in CSS px, as in the style sheet. */
var ROW = 24;
/** Rows beyond the ones in sight, so that a scroll shows no gap. */
var MARGIN = 12;
/** More columns than any table has. */
var COLUMNS$1 = 20;
var RowsInSight = class {
	row;
	head = h("thead", {});
	scroller;
	body = h("tbody", {});
	count = 0;
	/** `row` builds the row at a place; a button in it that has a `data-key` keeps the keyboard while it is in sight. */
	constructor(testid, words, row) {
		this.row = row;
		const table = h("table", {
			testid,
			class: "statistics",
			aria: { label: words.table }
		}, this.head, this.body);
		this.scroller = h("div", {
			class: "rows",
			tabindex: 0,
			role: "region",
			aria: { label: words.region }
		}, table);
		this.scroller.addEventListener("scroll", () => this.draw());
		new ResizeObserver(() => this.draw()).observe(this.scroller);
	}
	/** Shows so many rows, or the same ones anew. */
	show(count) {
		this.count = count;
		this.draw();
	}
	/** Brings a row into sight; a place below 0 is none. */
	reveal(place) {
		const { scrollTop, clientHeight } = this.scroller;
		const top = place * ROW;
		if (place >= 0 && (top < scrollTop || top > scrollTop + clientHeight - 72)) this.scroller.scrollTop = Math.max(0, top - clientHeight / 2);
		this.draw();
	}
	/** Says on the heads of columns how the rows are sorted. */
	markOrder(key, descending) {
		for (const cell of this.head.querySelectorAll("th")) cell.setAttribute("aria-sort", cell.dataset.key === key ? descending ? "descending" : "ascending" : "none");
	}
	draw() {
		if (this.scroller.closest("[hidden]") !== null) return;
		const { scrollTop, clientHeight } = this.scroller;
		const first = Math.max(0, Math.floor(scrollTop / ROW) - MARGIN);
		const last = Math.min(this.count, Math.ceil((scrollTop + clientHeight) / ROW) + MARGIN);
		const seen = Array.from({ length: Math.max(0, last - first) }, (_, i) => this.row(first + i));
		const focused = this.focused();
		fill(this.body, filler(first), ...seen, filler(this.count - last));
		if (focused !== null) this.focus(focused);
	}
	/** The key of the button that has the keyboard; null where none has. */
	focused() {
		const { activeElement } = document;
		return activeElement instanceof HTMLElement && this.body.contains(activeElement) ? activeElement.dataset.key ?? "" : null;
	}
	/** Gives the keyboard back to a button that was built anew, or to the table where it is out of sight. */
	focus(key) {
		(this.body.querySelector(`button[data-key="${key}"]`) ?? this.scroller).focus({ preventScroll: true });
	}
};
/** The head of a column that rows are sorted by. */
function sortHead(column, press) {
	const { key, label, unit, help } = column;
	const button = h("button", {
		type: "button",
		class: "sort",
		testid: `sort-${key}`,
		title: help
	}, label, unit === "" ? null : h("span", { class: "unit" }, ` ${unit}`));
	button.addEventListener("click", press);
	return h("th", {
		scope: "col",
		key
	}, button);
}
function filler(rows) {
	const cell = h("td", { colspan: COLUMNS$1 });
	cell.style.height = `${String(Math.max(0, rows) * ROW)}px`;
	return h("tr", {
		class: "filler",
		aria: { hidden: "true" }
	}, cell);
}
// www/shared/panel/table.ts
/** A table of any length, sorted by any of its columns. */
var ALL$1 = () => true;
var Table = class {
	options;
	help;
	table;
	columns = [];
	count = 0;
	keep = ALL$1;
	shown = [];
	order = {
		key: "",
		descending: false
	};
	marked = -1;
	/** The row that was pressed last. */
	anchor = -1;
	constructor(host, options) {
		this.options = options;
		this.help = h("p", {
			class: "help",
			hidden: true,
			testid: `${options.testid}-help`
		});
		this.table = new RowsInSight(options.testid, options.words, (place) => this.row(this.shown[place] ?? 0));
		host.append(this.help, this.table.scroller);
	}
	get scroller() {
		return this.table.scroller;
	}
	get head() {
		return this.table.head;
	}
	/** Shows rows of other columns; `keep` leaves some of them out. Returns how many are shown. */
	show(count, columns, keep = ALL$1) {
		if (columns !== this.columns) fill(this.table.head, columns.length === 0 ? null : h("tr", {}, ...columns.map((column) => this.headCell(column))));
		Object.assign(this, {
			count,
			columns,
			keep
		});
		return this.sort();
	}
	/** Marks a row and brings it into sight; none where it is negative. */
	mark(row) {
		this.marked = row;
		this.table.reveal(this.shown.indexOf(row));
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
	press(row, event, choose) {
		const { chooseMore } = this.options;
		const [from, to] = [this.shown.indexOf(this.anchor), this.shown.indexOf(row)];
		if (chooseMore !== void 0 && event.shiftKey && from >= 0) chooseMore(this.shown.slice(Math.min(from, to), Math.max(from, to) + 1));
		else if (chooseMore !== void 0 && (event.ctrlKey || event.metaKey)) chooseMore([row]);
		else choose(row);
		if (!event.shiftKey || from < 0) this.anchor = row;
	}
	/** Draws the rows anew, as others are chosen. */
	redraw() {
		this.table.show(this.shown.length);
	}
	/** The rows that are shown, in their order. */
	get listed() {
		return this.shown;
	}
	sort() {
		this.shown = ordered(this.count, this.columns, this.order, this.keep);
		this.table.markOrder(this.order.key, this.order.descending);
		this.table.show(this.shown.length);
		return this.shown.length;
	}
	row(row) {
		const { testid, choose, chooseLabel } = this.options;
		const chosen = row === this.marked;
		const together = this.options.isChosen?.(row) === true;
		const line = h("tr", {
			class: `${chosen ? "best" : ""} ${together ? "chosen" : ""}`.trim(),
			testid: chosen ? `${testid}-selected` : `${testid}-row`
		}, ...this.columns.map(({ value, text }, i) => {
			const number = typeof value(row) === "number";
			if (i > 0 || choose === void 0) return h("td", { class: number ? "number" : "" }, text(row));
			return h("td", {}, h("button", {
				type: "button",
				class: "link",
				key: String(row),
				...chooseLabel === void 0 ? {} : { aria: { label: chooseLabel(row) } }
			}, text(row)));
		}));
		if (choose !== void 0) line.addEventListener("click", (event) => this.press(row, event, choose));
		else line.classList.add("plain");
		return line;
	}
};
// www/block/panel/tables.ts
/** The tables of a block: its images, and its points. */
function mountImages(host, store, looking) {
	const table = captioned(host, "block-images", "Images", (image) => looking.choose({
		kind: "image",
		image
	}));
	store.watch(["shown"], ([shown]) => table.show(shown === null ? NONE$2 : imageRows(shown.view)));
	store.watch(["choice"], ([choice]) => table.mark(choice?.kind === "image" ? choice.image : -1));
}
function mountPoints(host, store) {
	const table = captioned(host, "block-points", "Points");
	store.watch(["shown"], ([shown]) => table.show(shown === null ? NONE$2 : pointRows(shown.view)));
}
var NONE$2 = {
	count: 0,
	columns: []
};
/** A table under a line that counts its rows. */
function captioned(host, testid, words, choose) {
	const caption = h("p", { class: "note" });
	host.append(caption);
	const table = new Table(host, {
		testid,
		words: {
			table: words,
			region: `Table: ${words}`
		},
		...choose === void 0 ? {} : { choose }
	});
	return {
		show: (rows) => fill(caption, `${words}: ${count(table.show(rows.count, rows.columns))}`),
		mark: (row) => table.mark(row)
	};
}
/** A column of numbers with so many decimals. */
function numbers$2(key, label, unit, digits, value, help) {
	return {
		key,
		label,
		unit,
		help,
		value,
		text: (row) => digits === 0 ? count(Number.isNaN(value(row)) ? null : value(row)) : fixed(value(row), digits)
	};
}
function words(key, label, value, help) {
	return {
		key,
		label,
		unit: "",
		help,
		value,
		text: value
	};
}
function imageRows({ images, leftOut, cameras }) {
	const known = (value) => value ?? NaN;
	return {
		count: images.length + leftOut.length,
		columns: [
			words("name", "Image", (i) => images[i]?.name ?? leftOut[i - images.length]?.name ?? "", "File name. Press it to choose the image in the picture."),
			numbers$2("number", "No.", "", 0, (i) => i < images.length ? i + 1 : NaN, "Row and column in the matrix."),
			numbers$2("features", "Features", "", 0, (i) => known(images[i]?.features), "Points detected and described."),
			numbers$2("rays", "Obs.", "", 0, (i) => known(images[i]?.rays), "Observations of selected tie points, without rejected ones."),
			numbers$2("places", "Cov.", "", 0, (i) => known(images[i]?.places), "Coverage: how many of the nine von Gruber positions hold a selected tie point."),
			numbers$2("rmse", "RMSE", "px", 2, (i) => known(images[i]?.rmsePx), "Root mean square length of the residuals of its observations."),
			...cameras.length > 1 ? [numbers$2("camera", "Camera", "", 0, (i) => known(images[i]?.camera) + 1, `Images of one camera are calibrated together: ${cameras.map(({ label }, c) => `${String(c + 1)} ${label}`).join("; ")}.`)] : [],
			words("state", "State", (i) => stateOf(images[i]?.why ?? leftOut[i - images.length]?.reason ?? ""), "Whether the image is oriented, and if not, why.")
		]
	};
}
function stateOf(why) {
	return why === "" ? "oriented" : why;
}
function pointRows({ points }) {
	const axis = (key, label, offset) => [numbers$2(key, label, "", 2, (i) => points.positions[3 * i + offset] ?? NaN, "Object coordinate, in m where the block has a scale."), numbers$2(`sigma-${key}`, `σ ${label}`, "", 3, (i) => points.errors[3 * i + offset] ?? NaN, `Standard error of ${label}, from the adjustment.`)];
	return {
		count: points.count,
		columns: [
			numbers$2("point", "Point", "", 0, (i) => i + 1, "Number of the point."),
			numbers$2("point-rays", "Rays", "", 0, (i) => points.rays[i] ?? NaN, "Number of images that see the point."),
			numbers$2("point-rmse", "RMSE", "px", 2, (i) => points.rmsePx[i] ?? NaN, "Root mean square length of the residuals of its observations."),
			...axis("x", "X", 0),
			...axis("y", "Y", 1),
			...axis("z", "Z", 2),
			numbers$2("confidence", "Probability", "", 3, (i) => points.confidence[i] ?? NaN, "Probability that all its observations show one point, from the matches alone.")
		]
	};
}
// www/block/mount.ts
/** The sample has so few photos that it is done in half a minute. */
var SAMPLE = {
	strips: 3,
	exposures: 4
};
/** `openPair` shows a pair of the block by itself; `openProject` opens a project of whatever kind where it belongs. */
function mountBlock(catalogue, openPair, openProject) {
	const store = new Holder(BLOCK_INITIAL, reduceBlock);
	const engine = new BlockEngine(store);
	const files = new BlockFiles(store, engine, openProject);
	const looking = {
		choose: (choice) => store.dispatch({
			type: "choose",
			choice
		}),
		open: (images) => openPair(store, images)
	};
	const actions = h("div", {
		class: "actions",
		role: "group",
		aria: { label: "Images of the block" }
	});
	const exports = h("div", {
		class: "actions",
		role: "group",
		aria: { label: "Export of the block" }
	});
	const settings = tabbed("Settings", [["block-settings", "Settings"], ["block-flight", "Simulate"]]);
	const results = tabbed("Results", [
		["block-results", "Results"],
		["block-images", "Images"],
		["block-points", "Points"]
	]);
	const stage = h("section", {
		class: "stage",
		aria: { label: "Block" }
	});
	const main = h("main", { class: "block" }, settings.element, stage, results.element);
	const opener = drawerButton("settings", "Settings", "block-settings", settings.element);
	const drawers = h("div", {
		class: "drawers",
		role: "group",
		aria: { label: "Settings of the block" }
	}, opener);
	const heading = document.querySelector(".bar h1");
	if (heading === null) throw new Error("the page has no bar");
	const pairParts = document.querySelectorAll(".bar .actions, .bar .drawers, body > main");
	byId("page-actions").before(actions, exports);
	byId("menu").before(drawers);
	document.querySelector("body > main")?.after(main);
	const back = mountBack(store);
	document.querySelector("body > main")?.before(back);
	heading.after(mountMode(store, {
		pair: [...pairParts],
		block: [
			actions,
			exports,
			drawers,
			main
		]
	}));
	store.watch(["mode", "opened"], ([mode, opened]) => {
		back.hidden = mode !== "pair" || opened === null;
	});
	const pick = mountActions(actions, store, files);
	mountExports(exports, store, engine);
	const status = mountBlockStatus(store, engine, {
		why: () => {
			showTab("tab-block-results");
			setDrawer("details", true);
			reveal(results.element);
		},
		save: () => void saveAs(store, engine, "project"),
		open: pick
	}, drawerButton("details", "Details", "block-details", results.element));
	mountSettings(settings.panels[0], store, files, opener);
	mountFlight(settings.panels[1], store, files);
	mountProgress(results.panels[0], store);
	mountResults(results.panels[0], store);
	const sample = () => void files.sample({
		...catalogue.flight,
		...SAMPLE
	});
	mountStage(stage, store, looking, {
		sample,
		open: pick
	});
	stage.prepend(status);
	mountImages(results.panels[1], store, {
		...looking,
		point: () => void 0
	});
	mountPoints(results.panels[2], store);
	store.watch(["running"], ([running]) => {
		if (running.kind === "yes") showTab("tab-block-results");
	});
	return {
		store,
		kept: new KeptBlocks(store, engine, catalogue),
		taker: files.taker,
		give: (given, masks) => void files.give(given, masks),
		sample,
		open: (file) => files.open(file)
	};
}
/** The buttons that give images; gives what asks for images. */
function mountActions(host, store, files) {
	const take = (given) => void files.take(given.map((file) => ({
		file,
		path: file.webkitRelativePath
	})));
	const [images, imagesInput] = fileButton("Images …", {
		testid: "block-files",
		label: "Images, cameras or project of a block",
		multiple: true,
		accept: "image/*,.tif,.tiff,.pgm,.ppm,.pnm,.json,.tiepoint"
	}, take, "Image files; a cameras file or a saved project too");
	const [folder, folderInput] = fileButton("Folder …", {
		testid: "block-folder",
		label: "Folder of images",
		folder: true
	}, take, "All images of a folder");
	const buttons = [
		images,
		folder,
		button("Simulated block", "block-simulate", () => void files.photograph(), "Photos of a synthetic scene, rendered in this tab"),
		button("Clear", "block-clear", () => store.dispatch({ type: "clear" }), "Removes all images")
	];
	images.classList.add("primary");
	fill(host, ...buttons, imagesInput, folderInput);
	store.watch([
		"running",
		"notice",
		"files",
		"shown",
		"catalogue"
	], ([, , given, shown, catalogue]) => {
		for (const press of buttons) press.disabled = catalogue === null || isBusy$1(store.state);
		const last = buttons.at(-1);
		if (last !== void 0) last.disabled ||= given.length === 0 && shown === null;
	});
	return () => imagesInput.click();
}
// www/pair/state/edits.ts
/** Edits of the matches by hand: records of what was done to which match, and what stands after some of them. */
var NO_HISTORY = {
	edits: [],
	done: 0
};
var NOTHING = {
	rejected: /* @__PURE__ */ new Map(),
	placed: /* @__PURE__ */ new Map()
};
/** Keys that were made: an edit of many matches is looked at again and again. */
var keys = /* @__PURE__ */ new WeakMap();
function keyOfTarget(target) {
	if (typeof target === "number") return `#${String(target)}`;
	const key = keys.get(target) ?? target.join(" ");
	keys.set(target, key);
	return key;
}
/** What stands after the edits that hold; the same object where none does. */
var standingOf = remember((edits, done) => {
	if (done === 0) return NOTHING;
	const rejected = /* @__PURE__ */ new Map();
	const placed = /* @__PURE__ */ new Map();
	for (const edit of edits.slice(0, done)) switch (edit.kind) {
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
});
function isNothing({ rejected, placed }) {
	return rejected.size === 0 && placed.size === 0;
}
/** The history after one more edit: what was undone before is given up. */
function recorded({ edits, done }, edit) {
	return {
		edits: [...edits.slice(0, done), edit],
		done: done + 1
	};
}
/** The history with the first `done` edits. */
function wentTo({ edits }, done) {
	return {
		edits,
		done: Math.min(edits.length, Math.max(0, done))
	};
}
/** A number that no match measured by hand has yet. */
function freshNumber({ edits }) {
	return edits.reduce((most, edit) => edit.kind === "add" ? Math.max(most, edit.id) : most, 0) + 1;
}
/** What an edit did, as in "Undo: reject 14 matches". */
function nameOfEdit(edit) {
	switch (edit.kind) {
		case "reject":
		case "restore": return `${edit.kind} ${edit.of.length === 1 ? "1 match" : `${String(edit.of.length)} matches`}`;
		case "add": return "add 1 match";
		case "move": return "move 1 match";
	}
}
/** The edits of exchanged images. */
function exchanged({ edits, done }) {
	if (edits.length === 0) return NO_HISTORY;
	const place = ([xl, yl, xr, yr]) => [
		xr,
		yr,
		xl,
		yl
	];
	const target = (of) => typeof of === "number" ? of : place(of);
	const other = (edit) => {
		switch (edit.kind) {
			case "reject":
			case "restore": return {
				kind: edit.kind,
				of: edit.of.map(target)
			};
			case "add": return {
				...edit,
				at: place(edit.at)
			};
			case "move": return {
				kind: "move",
				of: target(edit.of),
				to: place(edit.to)
			};
		}
	};
	return {
		edits: edits.map(other),
		done
	};
}
// www/pair/state/state.ts
var SIDES = ["left", "right"];
function otherSide(side) {
	return side === "left" ? "right" : "left";
}
/** Parts of the state that are typed in fields. */
var TYPED_PARTS = [
	"settings",
	"camera",
	"photos",
	"offset"
];
/** What belongs to the edits of a pair goes with its images. */
var UNEDITED = {
	history: NO_HISTORY,
	chosen: [],
	before: null,
	draft: null
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
	shelf: /* @__PURE__ */ new Map(),
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
		hidden: []
	},
	notice: null
};
// www/block/pair.ts
/** From a pair of the block to the pair's part of the page, and back. */
/** The pair's own images count up from 1: those of blocks count down. */
var nextId$1 = -1;
/** Opens both images with the strategy that the block used; where one cannot be opened the block stays. */
async function openPair(block, store, engine, [a, b]) {
	const { shown } = block.state;
	if (shown === null) return;
	const [left, right] = [a, b].map((image) => fileOf(block, shown.view.images[image]?.name));
	if (left === void 0 || right === void 0) {
		say(block, "The files of these images are not open: drop them and try again.");
		return;
	}
	const images = {
		left: given$2(left),
		right: given$2(right)
	};
	let camera;
	try {
		camera = cameraOf$2(block, a, b);
		await Promise.all([engine.open("left", images.left), engine.open("right", images.right)]);
	} catch (error) {
		say(block, `The pair cannot be shown: ${messageOf(error)}.`);
		return;
	}
	readyFor(store, block, camera);
	store.dispatch({
		type: "images",
		images
	});
	block.dispatch({
		type: "openedPair",
		images: [a, b]
	});
	block.dispatch({
		type: "mode",
		mode: "pair"
	});
}
/** The block's settings of features and its camera, in place of whatever the pair before had. */
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
	for (const side of SIDES) {
		store.dispatch({
			type: "photo",
			side,
			photo: {
				fiducials: [],
				origin: null
			}
		});
		store.dispatch({
			type: "mask",
			side,
			mask: null
		});
	}
}
/** The camera of both images: as the block calibrated it, or given before that; null where they have two cameras, or nothing is known. */
function cameraOf$2(block, a, b) {
	const { images = [], cameras = [] } = block.state.shown?.view ?? {};
	const [left, right] = [images[a], images[b]];
	const camera = left !== void 0 && left.camera === right?.camera ? cameras[left.camera] : void 0;
	const known = camera?.calibrated ?? camera?.given ?? null;
	return known === null ? null : photo_camera(known);
}
function fileOf(block, name) {
	const { shown, files } = block.state;
	return [...shown?.files ?? [], ...files].find((file) => file.name === name);
}
function given$2({ name, file }) {
	return {
		id: nextId$1--,
		name,
		source: {
			kind: "file",
			file
		}
	};
}
function say(block, text) {
	block.dispatch({
		type: "notice",
		notice: {
			kind: "problem",
			text
		}
	});
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
/**
* After the rules: a match that the adjustment rejected; a point that nothing was decided about, or a right point that no match uses; what the
* user rejected and measured.
*/
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
/** Codes of matches: whatever became of them, a user looks for them among the matches. */
var OF_MATCHES = [
	MATCHED,
	GROSS_ERROR,
	BY_HAND,
	MANUAL
];
/** The rules that refuse, in the order in which the panel lists them. */
var REFUSALS = RULES.filter((rule) => rule !== "matched");
/** Throws where the page and the crate disagree on the rules: they are of different builds. */
function checkRules(names) {
	if (names.length !== RULES.length || RULES.some((rule, i) => names[i] !== rule)) throw new Error(`the page and the program do not fit each other: rules ${names.join(", ")}`);
}
// www/pair/state/edited.ts
/** The pair with the edits by hand: a pure function of what the matching found and of what stands after the edits. */
/** Stands for the right point of a match whose place is none. */
var NO_POINT = 4294967295;
/** A new run finds the place of an edit again where a left point lies this near, px. */
var SAME_PLACE_PX = .5;
/** Whether the place of a match was measured by hand. */
function isManual({ matches }, row) {
	return matches[5 * row + 4] === -1;
}
/** Rows of matches by the whole px that holds their left position. */
var rowsByPixel = remember((matches) => {
	const cells = /* @__PURE__ */ new Map();
	for (let row = 0; 5 * row < matches.length; row++) {
		const cell = pixelOf(matches[5 * row] ?? NaN, matches[5 * row + 1] ?? NaN);
		const rows = cells.get(cell);
		if (rows === void 0) cells.set(cell, [row]);
		else rows.push(row);
	}
	return cells;
});
/** More columns than any image has. */
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
/** Squares of the distances of a match from a place, in the left and in the right image. */
function distances(matches, row, [xl, yl, xr, yr]) {
	const [ul = NaN, vl = NaN, ur = NaN, vr = NaN] = matches.subarray(5 * row, 5 * row + 4);
	return [(ul - xl) ** 2 + (vl - yl) ** 2, (ur - xr) ** 2 + (vr - yr) ** 2];
}
/** The row of each target that has one: the very match where it is there, else the nearest one at the same place of the left image. */
function rowsOf(matches, targets) {
	const cells = rowsByPixel(matches);
	const taken = /* @__PURE__ */ new Set();
	const rows = /* @__PURE__ */ new Map();
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
/** Rows of matches that are gathered. */
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
/** An array with room for more at its end. */
function longer(values, more) {
	const copy = new values.constructor(values.length + more);
	copy.set(values);
	return copy;
}
/** What each edit did to the matches that were found. The same objects where nothing stands. */
function applied(left, found, standing) {
	return isNothing(standing) ? {
		left,
		match: found,
		found,
		appended: [],
		lost: 0
	} : new Applying(left, found, standing).edited();
}
/** The places by which the matches of edits are found. */
function placesOf({ rejected, placed }) {
	const places = /* @__PURE__ */ new Map();
	for (const [key, { target }] of placed) if (typeof target !== "number") places.set(key, target);
	for (const [key, target] of rejected) if (typeof target !== "number") places.set(key, target);
	for (const [key, { target, at }] of placed) if (typeof target === "number" && !rejected.has(key)) places.set(key, at);
	return places;
}
/** Goes through the matches that were found, then through those that have a place of their own. */
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
		const handled = /* @__PURE__ */ new Set();
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
	/** Does to a match that was found what stands of it; false where its place is another one in the left image, which is appended. */
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
	/** A left point of its own, with the verdict on it. */
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
	/** Of a left point of which nothing was compared, where it lies in the right image. */
	decide(index, x, y) {
		this.best[index] = -1;
		this.places.set([x, y], 2 * index);
		this.measures.fill(Infinity, 2 * index, 2 * index + 2);
	}
	/** `all`: so many left points. */
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
/** How many matches were rejected and measured by hand. */
function countsByHand(match) {
	let manual = 0;
	for (let row = 0; 5 * row < match.matches.length; row++) manual += Number(isManual(match, row));
	return {
		rejected: match.rules.reduce((sum, rule) => sum + Number(rule === BY_HAND), 0),
		manual
	};
}
/** What a run of the matching has of the edits by hand; null where there are none. */
function keptText({ match, found, lost }) {
	if (match === found && lost === 0) return null;
	const { rejected, manual } = countsByHand(match);
	const of = (number, one, more) => number === 0 ? [] : [`${String(number)} ${number === 1 ? one : more}`];
	const kept = [...of(rejected, "match rejected by hand", "matches rejected by hand"), ...of(manual, "match measured by hand", "matches measured by hand")];
	const none = lost === 0 ? "" : ` Of ${String(lost)} more ${lost === 1 ? "rejection" : "rejections"} there is no match at the same place.`;
	return `${kept.length === 0 ? "No edits by hand apply to this result." : `Kept: ${kept.join(", ")}.`}${none}`;
}
var remembered = remember(applied);
/** The pair with its edits; null while there are no matches of the points that are there. */
function editedPair({ results, history }) {
	const left = results.pointsLeft?.value.points;
	const match = results.match?.value;
	if (left === void 0 || match === void 0 || match.rules.length * 3 !== left.length) return null;
	return remembered(left, match, standingOf(history.edits, history.done));
}
/** What an edit of the match at a left point is about; null where there is no match. */
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
/** The row of the match of each left point; -1 where it has none. */
function rowsOfLefts(match) {
	const rows = new Int32Array(match.rules.length).fill(-1);
	for (let i = 0; i < match.indices.length; i += 2) rows[match.indices[i] ?? 4294967295] = i / 2;
	return rows;
}
var rowOfLeft = remember(rowsOfLefts);
/** The left points that have a match, or had one that was rejected by hand, by the keys of its target. */
var leftsByTarget = remember((edited) => {
	const lefts = /* @__PURE__ */ new Map();
	edited.match.rules.forEach((rule, left) => {
		if (rule !== MATCHED && rule !== BY_HAND) return;
		const target = targetOfLeft(edited, left);
		if (target !== null) lefts.set(keyOfTarget(target), left);
	});
	return lefts;
});
/** Where the match of a left point lies, or lay until it was rejected by hand. */
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
// www/pair/state/truth.ts
/** The truth of the images on the screen; null where they are not a simulated pair in its own order. */
function truthOf(state) {
	const { truth, images } = state;
	return truth !== null && images.left?.id === truth.leftId && images.right?.id === truth.rightId ? truth : null;
}
/** The true orientation with by and bz at the scale of another base; NaN where the true base is 0, which has no scale. */
function orientationAt({ orientation, baseMm }, otherMm) {
	const scale = baseMm === 0 ? NaN : otherMm / baseMm;
	return {
		...orientation,
		by_mm: scale * orientation.by_mm,
		bz_mm: scale * orientation.bz_mm
	};
}
// www/pair/state/keys.ts
/**
* What each stage's result depends on, as a key. A result is current where its key equals the wanted one; a stage whose key did not
* change is not computed again, whatever was changed elsewhere.
*/
var numbers$1 = /* @__PURE__ */ new Map();
/** A short name for a value: equal values get equal names. Keys of keys would otherwise grow with every stage. */
function shortName(parts) {
	const text = JSON.stringify(parts);
	let name = numbers$1.get(text);
	if (name === void 0) {
		name = `k${String(numbers$1.size)}`;
		numbers$1.set(text, name);
	}
	return name;
}
var standings = /* @__PURE__ */ new WeakMap();
var lastStanding = 0;
/** What is made of the matches depends on the edits by hand too; without any it is what it would be without editing. */
function withEdits({ history }, match) {
	const standing = standingOf(history.edits, history.done);
	if (isNothing(standing)) return match;
	const number = standings.get(standing) ?? ++lastStanding;
	standings.set(standing, number);
	return keyOf("edited", [match], number);
}
/** The key of a stage from its inputs; null where one of them is missing. */
function keyOf(kind, inputs, options = null) {
	return inputs.includes(null) ? null : shortName([
		kind,
		inputs,
		options
	]);
}
/** The camera of both images where one is given, else that of each image's EXIF, as the crate's `match_pair` takes them. */
function pairCameras(state) {
	const [left, right] = SIDES.map((side) => cameraOf$1(state, side));
	if (left !== void 0 && "kind" in left) return { missing: left };
	if (right !== void 0 && "kind" in right) return { missing: right };
	if (left === void 0 || right === void 0) throw new Error("a pair has two sides");
	return {
		left,
		right,
		from: state.camera === null ? "exif" : "given"
	};
}
var cameraOfExif = {
	left: remember(camera_of_exif),
	right: remember(camera_of_exif)
};
function cameraOf$1(state, side) {
	const exif = state.results[side === "left" ? "openLeft" : "openRight"]?.value.info.camera ?? null;
	if (state.camera === null && exif?.origin === "panorama") return {
		kind: "panorama",
		side
	};
	const marked = state.photos[side].fiducials.length > 0;
	const camera = state.camera ?? (exif === null ? null : cameraOfExif[side](exif));
	if (camera === null) return marked ? { kind: "no_focal_length" } : {
		kind: "no_camera",
		side
	};
	if (!marked && camera.pixel_mm == null) return {
		kind: "no_pixel_size",
		side
	};
	return camera;
}
/** Whether a strategy searches the right image itself, in place of its interest points. */
function comparesGreyValues({ matching }) {
	return matching.strategy === "correlation" || matching.strategy === "least-squares";
}
/** Whether a strategy compares gradient descriptors: it looks for no expected place, and the geometry of the two views verifies its matches. */
function comparesGradients(settings) {
	return inFull(settings).matching.strategy === "gradient";
}
/** The settings with what follows from them, as the strategy where it is to be chosen. */
var inFull = remember(resolved);
/** Whether a strategy compares the moments of windows. */
function comparesMoments(settings) {
	return !comparesGreyValues(settings) && !comparesGradients(settings);
}
/** What the points depend on: of the groups `multiscale` and `gradient` only what is used. */
function pointSettings(settings) {
	const gradients = comparesGradients(settings);
	const scales = gradients || settings.points.operator === "multiscale";
	return [
		settings.points,
		scales ? settings.multiscale : null,
		gradients ? settings.gradient : null
	];
}
/** What the interior orientation of the matches' own making comes from: the matches, where they tell it or are still to come. */
function estimatedFrom(state, settings, match) {
	const result = state.results.match;
	const tellsNone = result !== void 0 && result.key === match && result.value.estimated === null;
	return comparesGradients(settings) && !tellsNone ? "" : null;
}
/** Photos from one place have no base: there is nothing to orient. */
function fromOnePlace(state, match) {
	const result = state.results.match;
	return result !== void 0 && result.key === match && result.value.geometry?.degenerate === "pure-rotation";
}
function openKey(state, side) {
	const image = state.images[side];
	return image === null ? null : keyOf("open", [], image.id);
}
/** What of the cameras matching depends on: the geometry that verifies gradients, and matching along epipolar lines. */
function ofCameras(settings, interiors) {
	if (settings === null) return [];
	if (comparesGradients(settings)) return [...interiors, settings.geometry];
	return settings.matching.epipolar ? [...interiors, settings.orientation] : [];
}
/** The point whose place in the other image is looked for. */
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
		state.photos[side],
		state.fiducialModel
	]);
	const interiorLeft = interior("left", openLeft);
	const interiorRight = interior("right", openRight);
	const match = keyOf("match", [
		descriptorsLeft,
		descriptorsRight,
		gradients ? "" : offset
	], [settings?.matching, ofCameras(settings, [interiorLeft, interiorRight])]);
	const unknown = settings === null || "missing" in cameras && cameras.missing.kind === "panorama" ? null : estimatedFrom(state, settings, match);
	const interiors = "missing" in cameras ? [unknown] : [interiorLeft, interiorRight];
	const orientable = fromOnePlace(state, match) ? null : "";
	const truth = truthOf(state);
	const edited = withEdits(state, match);
	const placed = standingOf(state.history.edits, state.history.done).placed.size > 0;
	return {
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
		orientation: keyOf("orientation", [
			edited,
			orientable,
			...interiors
		], settings?.orientation),
		score: keyOf("score", [edited, truth === null ? null : ""], [truth?.leftId, truth?.rightId]),
		line: keyOf("line", [match, state.draft === null ? null : ""], knownOfDraft(state)),
		inspection: keyOf("inspection", [placed ? edited : match, state.selection === null ? null : ""], [state.selection, settings?.window])
	};
}
var last = null;
/** The wanted keys of a state; computed once a state. */
function wantedKeys(state) {
	if (last?.state !== state) last = {
		state,
		keys: compute(state)
	};
	return last.keys;
}
/** Whether a stage's result is there and made by the settings that are wanted now. */
function isCurrent(state, stage) {
	const key = wantedKeys(state)[stage];
	return key !== null && state.results[stage]?.key === key;
}
/** Whether a stage shows a result that other settings made. What is not part of the run is neither shown nor out of date. */
function isStale(state, stage) {
	const key = wantedKeys(state)[stage];
	return key !== null && state.results[stage] !== void 0 && state.results[stage].key !== key;
}
// www/pair/state/stages.ts
var STAGES = {
	openLeft: {
		label: "decoding the left image",
		worker: "left",
		needs: []
	},
	openRight: {
		label: "decoding the right image",
		worker: "right",
		needs: []
	},
	pointsLeft: {
		label: "detecting points, left",
		worker: "left",
		needs: ["openLeft"]
	},
	pointsRight: {
		label: "detecting points, right",
		worker: "right",
		needs: ["openRight"]
	},
	descriptorsLeft: {
		label: "describing points, left",
		worker: "left",
		needs: ["pointsLeft"]
	},
	descriptorsRight: {
		label: "describing points, right",
		worker: "right",
		needs: ["pointsRight"]
	},
	offset: {
		label: "estimating the offset of the images",
		worker: "pair",
		needs: ["openLeft", "openRight"]
	},
	match: {
		label: "matching",
		worker: "pair",
		needs: [
			"descriptorsLeft",
			"descriptorsRight",
			"offset"
		],
		uses: ["interiorLeft", "interiorRight"]
	},
	interiorLeft: {
		label: "interior orientation, left",
		worker: "pair",
		needs: ["openLeft"]
	},
	interiorRight: {
		label: "interior orientation, right",
		worker: "pair",
		needs: ["openRight"]
	},
	orientation: {
		label: "relative orientation",
		worker: "pair",
		needs: [
			"match",
			"interiorLeft",
			"interiorRight"
		]
	},
	score: {
		label: "comparing with the truth",
		worker: "pair",
		needs: ["match"]
	},
	line: {
		label: "looking where the point may lie",
		worker: "pair",
		needs: ["match"]
	},
	inspection: {
		label: "loading the selected point",
		worker: "pair",
		needs: ["match"]
	}
};
var STAGE_NAMES = Object.keys(STAGES);
// www/pair/engine/failure.ts
/** What the page says when a stage has no result: what happened, what is kept, what to try. */
var KEPT = "Images, settings and earlier results are kept.";
function advice(stage) {
	switch (stage) {
		case "openLeft":
		case "openRight": return "Try a smaller image, or close other tabs.";
		case "pointsLeft":
		case "pointsRight": return "Try a higher threshold or a smaller image, then run again.";
		case "descriptorsLeft":
		case "descriptorsRight":
		case "match": return "Try fewer points (a higher threshold, a larger suppression window) or a smaller search window, then run again.";
		default: return "Change a setting or run again.";
	}
}
/** A sentence or two for the user. */
function plainMessage(stage, error, catalogue) {
	const text = readable(catalogue, messageOf(error));
	if (!(error instanceof CallError)) return `${capital(STAGES[stage].label)} failed: ${text}. ${KEPT}`;
	switch (error.failure.kind) {
		case "refused": return error.failure.code === "image-too-small" ? `${sideOf(stage)}${text}.` : `${capital(text)}.`;
		case "memory": return `Memory ran out while ${STAGES[stage].label} (${text}). ${KEPT} ${advice(stage)}`;
		case "fault": return `The program broke off while ${STAGES[stage].label} (${text}): a fault of its own, please report it. ${KEPT} ${advice(stage)}`;
		case "other": return `${capital(STAGES[stage].label)} failed: ${text}. ${KEPT} ${advice(stage)}`;
	}
}
function sideOf(stage) {
	const side = /(Left|Right)$/u.exec(stage)?.[1];
	return side === void 0 ? "" : `${side} image: `;
}
function capital(text) {
	const trimmed = text.endsWith(".") ? text.slice(0, -1) : text;
	return trimmed.charAt(0).toUpperCase() + trimmed.slice(1);
}
// www/pair/engine/nearest.ts
/** The search for nearest gradient descriptors, in pieces over a pool of workers: the same result for any number of them. */
/** Pairs of descriptors that a worker compares in some ten milliseconds: fewer are not worth a message to it. */
var LEAST_PAIRS = 2e6;
/** The pieces in their order, of equal size, as many as there are workers or are worth it; null where it is not worth more than one. */
function nearestPieces(left, right, workers, search) {
	const count = left.length / 128;
	const pieces = Math.min(workers, Math.floor(count * (right.length / 128) / LEAST_PAIRS));
	if (pieces < 2) return null;
	const cut = (piece) => Math.round(count * piece / pieces);
	return Promise.all(Array.from({ length: pieces }, (_, piece) => search(cut(piece), cut(piece + 1))));
}
// www/pair/state/interior.ts
var paired = remember((left, right, focal) => ({
	left: left.interior,
	right: right.interior,
	focal_mm: focal
}));
/** Those of known cameras; null where a camera is missing or its stage has no result. */
function knownInterior(state) {
	const cameras = pairCameras(state);
	const { interiorLeft, interiorRight } = state.results;
	if ("missing" in cameras || interiorLeft === void 0 || interiorRight === void 0) return null;
	return paired(interiorLeft.value, interiorRight.value, cameras.left.focal_mm);
}
/** Those in use: where no camera is known, as the matches tell them. */
function interiorInUse(state) {
	return "missing" in pairCameras(state) ? state.results.match?.value.estimated ?? null : knownInterior(state);
}
// www/pair/engine/inputs.ts
/** What the runs of stages work with: the workers, and results of earlier stages. */
/** A result that the stage graph promised. */
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
/** Which left point a selection is about, and where its best place lies. */
/** Where the best place of a left point lies in the right image; null where it has none. */
function placeOf(places, index) {
	if (index < 0) return null;
	const [x = NaN, y = NaN] = places.subarray(2 * index, 2 * index + 2);
	return Number.isNaN(x) || Number.isNaN(y) ? null : [x, y];
}
/** The left point that a selection is about: itself, or the one that has the selected right point as its best candidate; a match of them before others. */
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
/** How much wider than the cells is what is shown of the image around them: turned by an eighth they still fit. */
var SURROUNDINGS = 1.5;
/** Candidates by gradients that are looked up. */
var MOST_CANDIDATES = 50;
/** The window whose content decided: that of the moments, or that of the grey values. */
function comparedWindow(state) {
	const settings = settingsOf(state);
	return comparesGreyValues(settings) ? {
		side: settings.matching.template,
		shape: "square"
	} : settings.window;
}
/** The matches with what was done to them by hand. */
function matchOf$1(state) {
	return editedPair(state)?.match ?? needed(state, "match");
}
function pointsOf(state, side) {
	return needed(state, side === "left" ? "pointsLeft" : "pointsRight");
}
/** A position of an image, as its points give it; null where there is no such point. */
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
	const reach = 4 * settingsOf(state).gradient.cell * scale;
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
/** The epipolar line of the selected point in the other image, where a geometry of the two views is known. */
async function lineOf(workers, state) {
	const { selection } = state;
	const at = selection === null ? null : pointAt(state, selection.side, selection.index);
	return selection === null || at === null ? null : seenFrom(workers, state, selection.side, at);
}
/** Where a place of one image may be seen in the other one; null where no geometry of the two views is known. */
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
	if (left < 0 || 3 * left >= pointsOf(state, "left").points.length || comparesGreyValues(settings)) return /* @__PURE__ */ new Float64Array();
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
/** Windows of moments or grey values; for gradients the features. */
async function comparedOf(workers, state, left) {
	const { best, places } = matchOf$1(state);
	const { selection } = state;
	const right = selection?.side === "right" ? selection.index : best[left] ?? -1;
	if (comparesGradients(settingsOf(state))) {
		const [ofLeft, ofRight] = await Promise.all([featureAt(workers, state, "left", left), featureAt(workers, state, "right", right)]);
		return {
			left: null,
			right: null,
			features: {
				left: ofLeft,
				right: ofRight
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
	const [compared, candidates, line] = await Promise.all([
		comparedOf(workers, state, left),
		candidatesOf(workers, state, left),
		lineOf(workers, state)
	]);
	return {
		...compared,
		candidates,
		line
	};
};
/** Where the point that is measured may lie. */
var line = async (state, workers) => {
	const { draft } = state;
	const from = draft === null ? null : otherSide(draft.side);
	const at = from === null ? null : draft?.places[from];
	return from === null || at == null ? null : seenFrom(workers, state, from, [at[0], at[1]]);
};
// www/pair/engine/runs.ts
/** How each stage is computed: which calls, on which worker, from which results. */
/** Longest side of the copies from which the offset is estimated, in px. */
var OFFSET_SIDE = 1024;
function open(side) {
	return async (state, workers) => {
		const image = state.images[side];
		if (image === null) throw new Error(`there is no ${side} image`);
		return workers.open(side, image);
	};
}
var NONE$1 = {
	moments: /* @__PURE__ */ new Float64Array(),
	gradients: /* @__PURE__ */ new Uint8Array()
};
/** Gradients are described where the points are found: both come from the same pyramid. */
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
		const { fiducials, origin } = state.photos[side];
		return workers.client("pair").call("interior", {
			width: info.width,
			height: info.height,
			camera: cameras[side],
			pairFocalMm: cameras.left.focal_mm,
			fiducials,
			model: state.fiducialModel,
			origin
		});
	};
}
/** The matches with what was done to them by hand. */
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
	inspection,
	line
};
// www/pair/engine/engine.ts
/** Starts what is wanted and not there, one call a stage at a time, and reports to the store. */
/** Quiet time after a change of settings before work starts, in ms. */
var DEBOUNCE_MS$1 = 150;
/** Longest side of the copy that is shown until detail tiles come, in px. */
var OVERVIEW_SIDE = 2048;
var Engine = class {
	store;
	clients = {
		left: new WorkerClient("left image"),
		right: new WorkerClient("right image"),
		pair: new WorkerClient("pair"),
		preview: new WorkerClient("preview"),
		report: new WorkerClient("report")
	};
	/** For what can be done in pieces. */
	pool = new WorkerPool();
	/** What each worker has opened last: the image, in which life of the worker, and the answer to come. */
	opened = /* @__PURE__ */ new Map();
	/** Which pair the pair's worker holds, and when it does. */
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
	/** Opens an image in the worker of a side; the earlier answer where that worker holds it already. */
	open(side, image) {
		if (image.source.kind === "project") return Promise.reject(/* @__PURE__ */ new Error(`the project does not hold its images; open ${image.name} too`));
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
	/** The worker of a side; opens the side's image in it where it holds another or none (after a cancel, a trap or a swap). */
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
	/** Ends all workers and what they do; nothing runs until the user asks or changes something. */
	cancel() {
		this.stopWorkers();
		this.store.dispatch({ type: "cancelled" });
	}
	/** Exchanges the images; each worker keeps the image it holds. */
	swap() {
		this.clients = {
			...this.clients,
			left: this.clients.right,
			right: this.clients.left
		};
		this.store.dispatch({ type: "swap" });
	}
	/** Starts every stage whose inputs are current and whose own result is not. */
	update() {
		window.clearTimeout(this.timer);
		for (const stage of STAGE_NAMES) {
			const { state } = this.store;
			if (state.paused || state.running[stage] !== void 0) continue;
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
			const of = stage === "orientation" ? editedPair(state) : null;
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
/** Names what a worker holds in one of its lives. */
function lifeTag(client, what) {
	return `${String(client.generation)}:${what}`;
}
function isReady(state, stage) {
	const { needs, uses = [] } = STAGES[stage];
	const keys = wantedKeys(state);
	const current = (input) => state.results[input]?.key === keys[input];
	return needs.every((input) => keys[input] === null || current(input)) && uses.every((input) => keys[input] === null || current(input) || state.failures[input]?.key === keys[input]);
}
// www/pair/engine/fit.ts
/** Least squares matching of one place that was measured by hand. */
/** How far around the given place is searched: a window of so many px. */
var SEARCH_PX = 9;
/** The place in the right image that least squares matching finds near a given one; null where it confirms none. */
async function fitted(state, workers, left, right) {
	const settings = settingsOf(state);
	const { matches } = await (await workers.withPair(state)).call("match", {
		left: { points: Float64Array.of(...left, 0) },
		right: { points: /* @__PURE__ */ new Float64Array() },
		offset: constant_offset(right[0] - left[0], right[1] - left[1]),
		interior: null,
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
		},
		nearest: null
	});
	const [, , x, y] = matches;
	return x === void 0 || y === void 0 ? null : [x, y];
}
// www/pair/state/shelf.ts
/** The same for the same two files, in this order; null where an image is no file. */
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
/** The edits of a pair that leaves go to the shelf, those of the one that comes leave it. */
function exchangedPair(state, images) {
	const [before, next] = [keyOfPair(state.images), keyOfPair(images)];
	const shelf = new Map(state.shelf);
	if (before !== null && state.history.edits.length > 0) shelf.set(before, state.history);
	const history = (next === null ? void 0 : shelf.get(next)) ?? NO_HISTORY;
	if (next !== null) shelf.delete(next);
	return {
		history,
		shelf: shelf.size === 0 && state.shelf.size === 0 ? state.shelf : shelf
	};
}
// www/pair/state/project.ts
/** All that is known of the pair on the screen; null while parts of it are missing or out of date. `contents`: digests of the image files. */
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
	const none = oriented === null ? whyNone(state) : null;
	const interior = interiorInUse(state);
	const points = ({ counts, threshold, points: at, frames }) => ({
		counts,
		threshold,
		points: at,
		frames
	});
	const given = (side) => ({
		...photos[side],
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
				no_orientation: none ?? whyNone(state)
			}
		},
		truth: truthFor$1(state)
	};
}
/** Points with those measured by hand, at the one scale of points that have none. */
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
/**
* Matches as a file holds them, which knows the rules of the crate alone. What was rejected by hand has no candidate there, but keeps its place:
* a point without a candidate has none.
*/
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
/** The opposite of `filed`. */
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
/** How many matches of a file were rejected and measured by hand. */
function editsOfFile({ output }) {
	return countsByHand(unfiled(output.match));
}
/** Why there is no orientation, in the order in which the crate's `match_pair` asks. */
function whyNone(state) {
	const cameras = pairCameras(state);
	const { geometry = null, no_geometry = null } = state.results.match?.value ?? {};
	if ("missing" in cameras && interiorInUse(state) === null) return cameras.missing;
	if (no_geometry !== null) return {
		kind: "no_geometry",
		no_geometry
	};
	if (geometry?.degenerate === "pure-rotation") return { kind: "pure_rotation" };
	const error = [
		"interiorLeft",
		"interiorRight",
		"orientation"
	].map((stage) => state.failures[stage]).find((failure) => failure?.error != null)?.error;
	return error == null ? {
		kind: "no_camera",
		side: "left"
	} : {
		kind: "refused",
		error
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
/** The state that shows a project: its results stand as if they had just been computed. What costs nothing and needs no image is computed. */
function withProject(state, { project, images, overviews, masks, estimated }) {
	const { input, settings, truth } = project;
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
		truth: truth === null ? null : {
			leftId: images.left.id,
			rightId: images.right.id,
			orientation: truth.orientation,
			baseMm: truth.base_mm,
			rightPosition: /* @__PURE__ */ new Float32Array(),
			leftWidth: left.width_px,
			leftHeight: left.height_px
		},
		refused: {},
		failures: {},
		paused: false,
		selection: null,
		...UNEDITED,
		...exchangedPair(state, images),
		views: {
			left: null,
			right: null
		}
	}, {
		project,
		estimated
	}, standingFor$1({
		project,
		overviews
	}), {});
}
/** What stands for images whose files are not there. */
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
/** The state with the results of a project, which it was made from: they are kept under the keys of what the state has now. */
function withResults(state, { project, estimated }, beside, times) {
	const { output, truth } = project;
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
	put("pointsLeft", {
		...output.left,
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
	const match = {
		...unfiled(output.match),
		estimated
	};
	put("match", match);
	put("orientation", output.orientation, {
		match,
		found: match
	});
	put("score", truth?.score);
	return next;
}
var nothing = () => ({
	moments: /* @__PURE__ */ new Float64Array(),
	gradients: /* @__PURE__ */ new Uint8Array()
});
/** The state with the files of images that a project names: their pixels are read, and what the project does not hold of their points is made. */
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
// www/pair/state/select.ts
/**
* The points, matches and orientation that fit each other and the images on the screen. Matches refer to points by index: once points are
* newer than the matches, the matches are no longer shown on them. An orientation is shown while another is on its way, and not where
* none will come.
*/
function shownPair(state) {
	const found = pointsOfShownImage(state, "left");
	const right = pointsOfShownImage(state, "right");
	const made = state.results.match?.value ?? null;
	const edited = made !== null && found !== null && right !== null && made.rules.length * 3 === found.length && matchIsOf(made, found, right) ? editedPair(state) : null;
	const result = wantedKeys(state).orientation !== null && !isBarred(state, "orientation") ? state.results.orientation : void 0;
	const orientation = edited === null || result === void 0 ? null : orientationOf(result.value, result.of ?? null, edited);
	return {
		left: edited?.left ?? found,
		right,
		match: edited?.match ?? null,
		orientation,
		edited
	};
}
/** The orientation of the matches as they are now. One that was made before the latest edit is shown of the matches that it knows. */
var orientationOf = remember((orientation, of, { match, found }) => {
	if (of === null || of.match === match) return orientation.residuals_mm.length * 5 === match.matches.length ? orientation : null;
	if (of.found !== found) return null;
	const rowThen = new Map(Array.from({ length: of.match.indices.length / 2 }, (_, row) => [of.match.indices[2 * row] ?? 4294967295, row]));
	const unknown = -1;
	const thenOf = Array.from({ length: match.indices.length / 2 }, (_, row) => {
		const then = rowThen.get(match.indices[2 * row] ?? 4294967295) ?? unknown;
		return [
			0,
			1,
			2,
			3
		].every((k) => of.match.matches[5 * then + k] === match.matches[5 * row + k]) ? then : unknown;
	});
	const rejected = new Set(orientation.rejected);
	const points = new Float64Array(9 * thenOf.length).fill(NaN);
	thenOf.forEach((then, row) => {
		if (then !== unknown) points.set(orientation.points.subarray(9 * then, 9 * then + 9), 9 * row);
	});
	return {
		...orientation,
		points,
		residuals_mm: thenOf.map((then) => orientation.residuals_mm[then] ?? [
			NaN,
			NaN,
			NaN,
			NaN
		]),
		rejected: thenOf.flatMap((then, row) => rejected.has(then) ? [row] : [])
	};
});
function pointsOfShownImage(state, side) {
	const opened = side === "left" ? "openLeft" : "openRight";
	if (state.results[opened] === void 0 || state.results[opened].key !== wantedKeys(state)[opened]) return null;
	return state.results[side === "left" ? "pointsLeft" : "pointsRight"]?.value.points ?? null;
}
/** Whether the first and last match start where their left points lie and refer to right points that exist. */
function matchIsOf(match, left, right) {
	const count = match.indices.length / 2;
	return [0, count - 1].every((i) => {
		if (i < 0 || count === 0) return true;
		const l = match.indices[2 * i] ?? 0;
		const r = match.indices[2 * i + 1] ?? 4294967295;
		return left[3 * l] === match.matches[5 * i] && (r === 4294967295 || 3 * r < right.length);
	});
}
/** The code of each left point: the rule that decided, or that the adjustment rejected its match. */
var leftCodes = remember((left, match, orientation) => {
	const codes = new Uint8Array((left?.length ?? 0) / 3).fill(UNDECIDED);
	if (match === null) return codes;
	codes.set(match.rules);
	for (let row = 0; 5 * row < match.matches.length; row++) if (isManual(match, row)) codes[match.indices[2 * row] ?? 4294967295] = MANUAL;
	for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i] ?? 0] = GROSS_ERROR;
	return codes;
});
/** The code of each right point: matched, rejected by hand or by the adjustment, or unused. */
var rightCodes = remember((right, match, orientation) => {
	const codes = new Uint8Array((right?.length ?? 0) / 3).fill(UNDECIDED);
	if (match === null) return codes;
	match.rules.forEach((rule, left) => {
		if (rule === BY_HAND) codes[match.best[left] ?? -1] = BY_HAND;
	});
	for (let i = 1; i < match.indices.length; i += 2) codes[match.indices[i] ?? 4294967295] = MATCHED;
	for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i + 1] ?? 4294967295] = GROSS_ERROR;
	return codes;
});
/** The code of each match: `MATCHED`, `MANUAL` or `GROSS_ERROR`. */
var matchCodes = remember((match, orientation) => {
	const codes = Uint8Array.from({ length: (match?.matches.length ?? 0) / 5 }, (_, row) => match !== null && isManual(match, row) ? MANUAL : MATCHED);
	for (const i of orientation?.rejected ?? []) codes[i] = GROSS_ERROR;
	return codes;
});
var loosePlaces = remember((match, codes) => {
	const [points, ofPlaces, lefts] = [
		[],
		[],
		[]
	];
	const put = (left, code, place) => {
		points.push(...place);
		ofPlaces.push(code);
		lefts.push(left);
	};
	match?.rules.forEach((rule, left) => {
		const at = match.places.subarray(2 * left, 2 * left + 2);
		if (rule === BY_HAND && (match.best[left] ?? -1) < 0 && !Number.isNaN(at[0])) put(left, BY_HAND, [...at, 0]);
	});
	codes.forEach((code, row) => {
		if (match?.indices[2 * row + 1] === 4294967295) put(match.indices[2 * row] ?? 0, code, match.matches.subarray(5 * row + 2, 5 * row + 5));
	});
	return {
		points: Float64Array.from(points),
		codes: Uint8Array.from(ofPlaces),
		lefts: Uint32Array.from(lefts)
	};
});
/** The match of each left point; -1 where it has none. */
var matchOfLeft = remember((match) => {
	const matches = new Int32Array(match.rules.length).fill(-1);
	for (let i = 0; i < match.indices.length; i += 2) matches[match.indices[i] ?? 4294967295] = i / 2;
	return matches;
});
/** Stages that are part of the run itself; looking at a point is not. */
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
/** Whether a stage failed for what is wanted now, or cannot be reached since one that it needs did. */
function isBarred(state, stage) {
	const failure = state.failures[stage];
	return failure !== void 0 && failure.key === wantedKeys(state)[stage] || STAGES[stage].needs.some((needed) => isBarred(state, needed));
}
/** How far the run is: stages that are wanted, and those of them that are there or will not come. */
function progress(state) {
	const keys = wantedKeys(state);
	const wanted = RUN_STAGES.filter((stage) => keys[stage] !== null);
	return {
		wanted: wanted.length,
		done: wanted.filter((stage) => state.results[stage]?.key === keys[stage] || isBarred(state, stage)).length,
		running: RUN_STAGES.filter((stage) => state.running[stage] !== void 0)
	};
}
/** The first failure that stands for what is wanted now. */
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
/** Whether any result on the screen was made by other settings than the wanted ones. */
function anyStale(state) {
	return RUN_STAGES.some((stage) => isStale(state, stage));
}
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
/** Whether there is nothing yet that would have to be kept. */
function isBlank(state) {
	const { catalogue, settings, flight, images, camera, photos, fiducialModel, offset } = state;
	return catalogue === null || images.left === null && images.right === null && settings === catalogue.defaults && flight === (catalogue.flights[0]?.flight ?? null) && camera === null && photos === INITIAL.photos && fiducialModel === INITIAL.fiducialModel && offset === null;
}
/** Whether results of the user's own photographs are there, which should not be lost to the next pair. */
function isWorthKeeping(state) {
	return SIDES.every((side) => state.images[side]?.source.kind === "file") && isCurrent(state, "match");
}
/** Stages whose results the project file holds not, or not whole. */
var BESIDE = [
	"interiorLeft",
	"interiorRight",
	"descriptorsLeft",
	"descriptorsRight"
];
/** Whether all that is wanted was computed, so that it can be kept. */
function isWhole(state) {
	const { wanted, done, running } = progress(state);
	return running.length === 0 && done === wanted && isCurrent(state, "match");
}
/** What the project file does not hold of results that are up to date. */
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
/** The pair as it would be without what was done to it by hand. */
function unedited(state) {
	return {
		...state,
		history: NO_HISTORY
	};
}
function isEdited({ history }) {
	return !isNothing(standingOf(history.edits, history.done));
}
/** In place of the results that edits change: what is kept of them are those without edits. */
var OF_EDITS = "edits";
/** The results by which what is kept of them is known to be the latest. */
function resultsOf(state) {
	const keys = wantedKeys(state);
	const changes = isEdited(state) ? /* @__PURE__ */ new Set(["orientation", "score"]) : /* @__PURE__ */ new Set();
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
/** Whether what is kept of these results is still what they are. Edits leave it as it is. */
function areSame(kept, now) {
	return now.every((value, i) => value === OF_EDITS || value === kept[i]);
}
/** The state that shows a pair as it was. Results that other settings made stay so: what is out of date is computed again. */
function withKept(state, { typed, display, flight, paused, images, masks, truth, history, shelf, opened, result }) {
	const fresh = {
		...INITIAL,
		catalogue: state.catalogue,
		notice: state.notice,
		...typed,
		display,
		flight,
		paused,
		images,
		masks,
		truth,
		shelf
	};
	if (result === null) return {
		...fresh,
		history
	};
	const made = withResults({
		...fresh,
		...result.typed
	}, result, {
		...result.beside,
		...opened
	}, result.times);
	return {
		...made,
		...typed,
		history,
		before: history.done === 0 ? null : made.results.orientation?.value ?? null
	};
}
/** The same of both sides. */
function bothSides(of) {
	const [left, right] = SIDES.map(of);
	return {
		left,
		right
	};
}
// www/pair/files/journal.ts
var HEAD$2 = "pair/edits";
var PIECE = "pair/edits/";
/** Edits of pairs that are not on the page. */
var SHELF = "pair/shelf";
/** Edits of a piece. */
var SIDE = 64;
/** About what a match takes in an edit, in bytes. */
var OF_MATCH = 40;
var Journal = class {
	head = {
		done: 0,
		pieces: 0
	};
	pieces = [];
	/** What is kept of the edits; what has not changed is the same value as before. Nothing where there are none. */
	parts({ history: { edits, done }, shelf }) {
		const parts = /* @__PURE__ */ new Map();
		if (shelf.size > 0) parts.set(SHELF, {
			value: shelf,
			bytes: [...shelf.values()].reduce((sum, other) => sum + bytesOf$2(other.edits), 0)
		});
		const pieces = Math.ceil(edits.length / SIDE);
		this.pieces = Array.from({ length: pieces }, (_, i) => same(this.pieces[i], edits, i * SIDE));
		if (this.head.done !== done || this.head.pieces !== pieces) this.head = {
			done,
			pieces
		};
		if (pieces === 0) return parts;
		parts.set(HEAD$2, {
			value: this.head,
			bytes: OF_MATCH
		});
		for (const [i, piece] of this.pieces.entries()) parts.set(PIECE + String(i), {
			value: piece,
			bytes: bytesOf$2(piece)
		});
		return parts;
	}
	/** @throws Error naming what is damaged */
	read(parts) {
		return {
			history: historyFrom(parts),
			shelf: shelfFrom(parts.get(SHELF))
		};
	}
};
function historyFrom(parts) {
	const value = parts.get(HEAD$2);
	if (value === void 0) return NO_HISTORY;
	const { done, pieces } = objectOf(value, "edits");
	const edits = Array.from({ length: likeOf(pieces, 0, "edits.pieces") }, (_, i) => parts.get(PIECE + String(i))).flatMap((piece, i) => listOf$1(piece, `edits[${String(i)}]`, editFrom));
	return {
		edits,
		done: doneFrom(done, edits, "edits.done")
	};
}
function doneFrom(value, edits, name) {
	return Math.min(edits.length, Math.max(0, Math.trunc(likeOf(value, 0, name))));
}
function shelfFrom(value) {
	if (value === void 0) return /* @__PURE__ */ new Map();
	if (!(value instanceof Map)) throw new Error("the edits of other pairs are damaged");
	const entry = ([key, kept]) => {
		const { edits, done } = objectOf(kept, "shelf");
		const list = listOf$1(edits, "shelf.edits", editFrom);
		return [likeOf(key, "", "shelf"), {
			edits: list,
			done: doneFrom(done, list, "shelf.done")
		}];
	};
	return new Map([...value].map(entry));
}
/** The piece that begins at an edit; the earlier one where it holds the same edits. */
function same(earlier, edits, from) {
	const length = Math.min(SIDE, edits.length - from);
	return earlier?.length === length && earlier.every((edit, i) => edit === edits[from + i]) ? earlier : edits.slice(from, from + length);
}
function bytesOf$2(piece) {
	return piece.reduce((sum, edit) => sum + OF_MATCH * (edit.kind === "reject" || edit.kind === "restore" ? edit.of.length : 2), 0);
}
/** @throws Error naming the field that is damaged */
function editFrom(value, name) {
	const edit = objectOf(value, name);
	const kind = likeOf(edit["kind"], "", `${name}.kind`);
	switch (kind) {
		case "reject":
		case "restore": return {
			kind,
			of: listOf$1(edit["of"], `${name}.of`, targetFrom)
		};
		case "add": return {
			kind,
			id: likeOf(edit["id"], 0, `${name}.id`),
			at: placeFrom(edit["at"], `${name}.at`)
		};
		case "move": return {
			kind,
			of: targetFrom(edit["of"], `${name}.of`),
			to: placeFrom(edit["to"], `${name}.to`)
		};
		default: throw new Error(`the field ${name}.kind is damaged`);
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
	].some(Number.isNaN)) throw new Error(`the field ${name} is damaged`);
	return [
		xl,
		yl,
		xr,
		yr
	];
}
// www/pair/view/geometry.ts
/** Where the panes lie, and how image positions become canvas positions. Lengths are CSS px; image positions are px with the centre of the top-left pixel at (0.5, 0.5). */
/** Space between the panes, crossed by the match lines. */
var GAP = 10;
/** Side by side where the canvas is wide, one above the other where it is high. */
function panesOf(width, height) {
	if (width >= .85 * height) {
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
function transformOf(pane, view) {
	return {
		scale: view.scale,
		x: pane.left + pane.width / 2 - view.scale * view.x,
		y: pane.top + pane.height / 2 - view.scale * view.y
	};
}
/** What the crate's drawing takes: `[scale, shift x, shift y, left, top, right, bottom]`. */
function drawView(t, clip) {
	return Float64Array.of(t.scale, t.x, t.y, clip.left, clip.top, clip.left + clip.width, clip.top + clip.height);
}
/** What the bar with the image's name takes of the top of its pane, as in the style sheet. */
var HEAD$1 = 40;
/** The view that shows the whole image, in the middle of its pane where the bar over it leaves that free, else below the bar. */
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
/** The view after zooming by `factor` about a canvas position, within sensible limits. */
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
/** Keeps the centre of the pane on the image. */
function clamped(view, { width, height }) {
	return {
		scale: view.scale,
		x: Math.min(width, Math.max(0, view.x)),
		y: Math.min(height, Math.max(0, view.y))
	};
}
// www/pair/files/export.ts
/** What can be taken away: matches as CSV, everything as JSON, the picture as PNG. */
/** Rows of a flat array. */
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
		fiducials: state.photos[side].fiducials,
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
/** JSON has no infinity: null stands for "no such candidate". */
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
/** What the orientation is worth, as the command's JSON has it; null without one. */
function verdictOf$1(state) {
	const verdict = isCurrent(state, "orientation") ? state.results.orientation?.value.verdict : void 0;
	return verdict === void 0 ? null : {
		...verdict,
		text: message("pair_verdict", verdict)
	};
}
/** What was done by hand; null where nothing was. */
function editsOf(state) {
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
/** Everything on the page as one object; fields named as in the command's JSON. Positions in px, the top-left pixel's centre at (0.5, 0.5). */
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
		camera: pairCameras(state),
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
		edits: editsOf(state),
		fits: match === null || match.fits.every(Number.isNaN) ? null : rows(match.fits, 5).map((fit) => fit.every(Number.isNaN) ? null : fit.map(finite)),
		verdicts: verdicts(state),
		geometry: match?.geometry ?? null,
		no_geometry: match?.no_geometry == null ? null : {
			...match.no_geometry,
			text: message("no_geometry", match.no_geometry)
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
/** The true orientation with the base that its by and bz belong to. */
function trueOrientation(state) {
	const truth = truthOf(state);
	return truth === null ? null : {
		...truth.orientation,
		base_mm: truth.baseMm
	};
}
/** How right the matches are, where the truth is known. */
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
	const { match } = shownPair(state);
	if (match === null) return;
	const text = await engine.client("pair").call("matchesCsv", { matches: match.matches });
	save(new Blob([text], { type: "text/csv" }), `${baseName(state)}-matches.csv`);
}
function exportEverything(state) {
	save(new Blob([JSON.stringify(everything(state))], { type: "application/json" }), `${baseName(state)}.json`);
}
async function exportPicture(state, view) {
	const canvas = view.snapshot();
	const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
	if (blob === null) throw new Error("the picture is too large for this browser to encode; make the window smaller");
	save(blob, `${baseName(state)}.png`);
}
function baseName(state) {
	return [state.images.left?.name, state.images.right?.name].map((name) => (name ?? "image").replace(/\.[^.]+$/u, "")).join("-").replace(/[^\p{L}\p{N}._-]+/gu, "_");
}
// www/pair/files/project.ts
/** Longest side of what stands for an image that is not there, px. */
var STANDING_SIDE = 256;
/** Its grey value. */
var STANDING_GREY = 128;
/** Writes all that is known of the pair. */
async function exportProject(store, engine) {
	const { state } = store;
	const text = await projectText(state, engine);
	if (text === null) throw new Error("the pair is not matched with the present settings yet");
	save(new Blob([text], { type: "application/octet-stream" }), `${baseName(state)}.tiepoint`);
}
/** The text of the pair's project file; null while parts of it are missing or out of date. */
async function projectText(state, engine) {
	const [left, right] = await Promise.all(SIDES.map((side) => contentOf(state, engine, side)));
	const project = projectOf(state, {
		left: left ?? null,
		right: right ?? null
	});
	return project === null ? null : engine.client("pair").call("projectWrite", project);
}
/** Digests that were made: files are large. */
var digests = /* @__PURE__ */ new WeakMap();
/** The digest of an image's file; null for an image that was simulated. */
async function contentOf({ images }, engine, side) {
	const source = images[side]?.source;
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
/** Reads a project; what stands for its images has their names and sizes. `nextId` numbers images and masks. */
async function readProject(engine, file, nextId) {
	const bytes = new Uint8Array(await file.arrayBuffer());
	const { project, estimated } = await engine.client("pair").call("projectOpen", { bytes }, [bytes.buffer]);
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
			grey: /* @__PURE__ */ new Uint8Array(),
			leftOut: NaN,
			overlay: overviews[side].clear
		};
	};
	return {
		project,
		estimated,
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
/** A grey area of the size of an image, and a clear one. */
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
/** The side of a project that was opened to which this very file belongs; null where there is none. */
async function sideOfFile({ images }, engine, file) {
	for (const side of SIDES) {
		const image = images[side];
		if (image?.source.kind !== "project" || image.name !== file.name || image.source.content === null) continue;
		if (await engine.client("pair").call("digest", { file }) === image.source.content) return side;
	}
	return null;
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
/** Takes files in: dropped, pasted, opened. A file that cannot be used changes nothing. */
/** Longest side of the copy of a mask that is shown, px. */
var MASK_SIDE = 1024;
/** Beyond this a file is refused before it is read, in bytes: a browser tab cannot hold it and its decoded copy. */
var MOST_BYTES = 2 ** 30;
var nextId = 1;
/** Differs for every image and mask ever given. */
var freshId = () => nextId++;
/** Masks named "right", or the second of two, belong right. */
function sideOfMask(mask, index) {
	if (/right/iu.test(mask.name)) return "right";
	return /left/iu.test(mask.name) || index === 0 ? "left" : "right";
}
var problem = (text) => ({
	kind: "problem",
	text
});
var info = (text) => ({
	kind: "info",
	text
});
/** A file holds the matches as the edits left them, and not the edits. */
function editsToldOf({ project }) {
	const { rejected, manual } = editsOfFile(project);
	const of = (number, what) => number === 0 ? [] : [`${String(number)} ${number === 1 ? "match" : "matches"} ${what} by hand`];
	const said = [...of(rejected, "rejected"), ...of(manual, "measured")];
	return said.length === 0 ? null : info(`It holds ${said.join(" and ")}; the history of these edits is not in the file, so they cannot be undone.`);
}
var Files = class {
	store;
	engine;
	openProject;
	toBlock;
	putAside;
	isReady = false;
	started = () => void 0;
	/** Resolves with `begin`. */
	ready = new Promise((resolve) => {
		this.started = resolve;
	});
	constructor(store, engine, openProject, toBlock, putAside) {
		this.store = store;
		this.engine = engine;
		this.openProject = openProject;
		this.toBlock = toBlock;
		this.putAside = putAside;
	}
	/** Takes files from now on: what was kept of the pair is shown. */
	begin() {
		this.isReady = true;
		this.started();
	}
	/** Takes files of any kind; `side` says where a single one belongs. */
	async take(files, side) {
		if (files.length === 0) return;
		this.store.dispatch({
			type: "notice",
			notice: null
		});
		const { images, masks, tables, cameras, projects } = sortFiles(files);
		const [project] = projects;
		if (project !== void 0) {
			await this.openProject(project);
			const others = files.filter((file) => !projects.includes(file));
			if (others.length > 0) await this.take(others, side);
			return;
		}
		if (images.length > 2) {
			this.toBlock(files.filter((file) => !masks.includes(file)), masks);
			return;
		}
		const told = [];
		const camera = cameras[0];
		if (camera !== void 0) told.push(await this.takeCamera(camera));
		for (const [i, table] of tables.entries()) told.push(await this.takeFiducials(table, side ?? this.sideOfTable(table, i)));
		if (images.length > 0) told.push(...await this.takeImages(images, side));
		for (const [i, mask] of masks.entries()) told.push(await this.readMask(mask, masks.length === 1 && side !== null ? side : sideOfMask(mask, i)));
		this.tell(told);
	}
	/** Opens a pair that was saved. */
	async takeProject(file) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "busy",
				text: `Reading ${file.name} …`
			}
		});
		try {
			const opened = await readProject(this.engine, file, freshId);
			const aside = await this.leave();
			this.store.dispatch({
				type: "opened",
				opened
			});
			this.tell([
				info(`${file.name} was opened. The file does not hold its images: open them too to see them.`),
				editsToldOf(opened),
				aside
			]);
		} catch (error) {
			this.tell([this.failed(`${file.name} cannot be opened`, error)]);
		}
	}
	/** Takes an image whose zeros say where no points are wanted; it has to be as large as the image that is open. */
	async takeMask(file, side) {
		this.tell([await this.readMask(file, side)]);
	}
	async readMask(file, side) {
		const opened = this.store.state.images[side];
		if (opened === null) return problem(`${file.name} is a mask of the ${side} image, which is not open. Open that first.`);
		try {
			const { info: photo } = await this.engine.open(side, opened);
			const mask = await this.engine.client("pair").call("mask", {
				file,
				overlaySide: MASK_SIDE
			});
			if (mask.width !== photo.width || mask.height !== photo.height) return problem(`${file.name} has ${String(mask.width)} × ${String(mask.height)} px, the ${side} image ${String(photo.width)} × ${String(photo.height)} px: a mask is as large as its image. Nothing was changed.`);
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
			return info(`${file.name} masks ${(100 * mask.leftOut).toFixed(1)} % of the ${side} image.`);
		} catch (error) {
			return this.failed(`${file.name} cannot be used as a mask`, error);
		}
	}
	/** Renders the pair of a flight in a worker and opens it. */
	async takeFlight(name, flight) {
		this.store.dispatch({
			type: "notice",
			notice: {
				kind: "busy",
				text: "Rendering the pair: a simulated flight over a synthetic scene …"
			}
		});
		try {
			const pair = await this.engine.client("pair").call("simulate", flight);
			const given = (side) => ({
				id: freshId(),
				name: `${name} ${side}`,
				source: {
					kind: "grey",
					...pair[side]
				}
			});
			const aside = await this.leave();
			this.store.dispatch({
				type: "simulated",
				left: given("left"),
				right: given("right"),
				pair
			});
			this.tell([aside]);
		} catch (error) {
			this.tell([this.failed("The pair could not be rendered", error)]);
		}
	}
	/** The built-in pair. */
	async takeSample() {
		const sample = this.store.state.catalogue?.flights.find(({ name }) => name === "sample");
		if (sample !== void 0) await this.takeFlight(sample.name, sample.flight);
	}
	/** Says together what came of files that were given together. */
	tell(told) {
		const said = told.filter((one) => one !== null);
		const bad = said.some(({ kind }) => kind === "problem");
		const { left, right } = this.store.state.images;
		const kept = bad && (left !== null || right !== null) ? " The open images are kept." : "";
		const text = `${said.map((one) => one.text).join(" ")}${kept}`;
		this.store.dispatch({
			type: "notice",
			notice: said.length === 0 ? null : {
				kind: bad ? "problem" : "info",
				text
			}
		});
	}
	failed(what, error) {
		if (error instanceof Cancelled) return info("Cancelled. Nothing was changed.");
		return problem(`${what}: ${sentence(readable(this.store.state.catalogue, messageOf(error)))}`);
	}
	/** Fiducials named "right", or the second of two tables, belong right. */
	sideOfTable(table, index) {
		if (/right/iu.test(table.name)) return "right";
		if (/left/iu.test(table.name)) return "left";
		return index > 0 || this.store.state.photos.left.fiducials.length > 0 ? "right" : "left";
	}
	async takeFiducials(file, side) {
		try {
			const fiducials = await this.engine.client("pair").call("parseFiducials", { text: await file.text() });
			this.store.dispatch({
				type: "photo",
				side,
				photo: { fiducials }
			});
			return info(`${String(fiducials.length)} fiducial ${fiducials.length === 1 ? "mark" : "marks"} of the ${side} image from ${file.name}.`);
		} catch (error) {
			return this.failed(`${file.name} holds no fiducial marks`, error);
		}
	}
	async takeCamera(file) {
		try {
			const camera = await this.engine.client("pair").call("parseCamera", { text: await file.text() });
			this.store.dispatch({
				type: "camera",
				camera
			});
			return info(`Camera data from ${file.name}.`);
		} catch (error) {
			return this.failed(`${file.name} holds no camera data`, error);
		}
	}
	/** Opens one or two images; each is decoded first, and replaces what is there only if it can be read. */
	async takeImages(files, side) {
		const tooLarge = files.find((file) => file.size > MOST_BYTES);
		if (tooLarge !== void 0) return [problem(`${tooLarge.name} has ${String(Math.round(tooLarge.size / 2 ** 20))} MB; up to 1,024 MB are read.`)];
		const known = await Promise.all(files.map((file) => sideOfFile(this.store.state, this.engine, file)));
		if (known.every((place) => place !== null)) return this.takeFound(files, known);
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
				text: `Reading ${files.map((file) => file.name).join(" and ")} …`
			}
		});
		return this.check(images);
	}
	/** The files of images that a project names take their places: nothing of the project changes. */
	async takeFound(files, sides) {
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
		return this.check(images, "found");
	}
	async check(images, type = "images") {
		const entries = Object.entries(images);
		const told = (await Promise.allSettled(entries.map(([side, image]) => this.engine.open(side, image)))).flatMap((outcome, i) => outcome.status === "rejected" ? [this.failedImage(entries[i]?.[1].name ?? "the file", outcome.reason)] : []);
		if (told.length > 0) return told;
		const aside = entries.length === 2 && type === "images" ? await this.leave() : null;
		this.store.dispatch({
			type,
			images
		});
		return [aside];
	}
	/** Before another pair takes the place of photographs that were matched: they stay in the list of projects. */
	async leave() {
		if (!isWorthKeeping(this.store.state)) return null;
		const names = SIDES.flatMap((side) => this.store.state.images[side]?.name ?? []);
		return await this.putAside() ? info(`${titleOf({
			name: null,
			images: names
		})} stay under Projects.`) : null;
	}
	failedImage(name, error) {
		const breakdown = breakdownOf(error);
		if (breakdown !== null) return problem(`${name} could not be opened: ${breakdown}. Try a smaller image, or close other tabs.`);
		return this.failed(`${name} cannot be opened`, error);
	}
	/** Where a single image goes: an empty place, else the active one. */
	freeSide() {
		const { images, activeSide } = this.store.state;
		if (images.left === null) return "left";
		return images.right === null ? "right" : activeSide;
	}
};
/** Takes what is dropped on the page while no other part does; a single image goes to the pane that it is dropped on. */
function takerOf(view, files) {
	const sideAt = (event) => {
		const box = view.host.getBoundingClientRect();
		const panes = panesOf(box.width, box.height);
		return SIDES.find((side) => contains(panes[side], event.clientX - box.left, event.clientY - box.top));
	};
	return {
		isActive: () => true,
		markAt: (event) => sideAt(event) ?? "page",
		take: (found, at) => void files.take(found.map(({ file }) => file), SIDES.find((side) => side === at) ?? null)
	};
}
// www/pair/files/keep.ts
/** Keeps the pair in the browser's storage, and reads it from there. */
var GIVEN = "pair";
var RESULT = "pair/result";
var FILE = "pair/file/";
/** Room of what is small and not counted, in bytes. */
var SMALL = 4096;
/** Results are written once nothing has changed for so long, in ms: the next ones, which a slider brings, need the worker. */
var QUIET_MS = 300;
/** What changes what is kept. */
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
	"shelf",
	"running",
	"paused"
];
var KeptPairs = class {
	store;
	engine;
	catalogue;
	made = null;
	making = false;
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
		const parts = /* @__PURE__ */ new Map();
		const given = isBlank(state) ? null : givenOf(state);
		if (given === null) return parts;
		parts.set(GIVEN, {
			value: given,
			bytes: SMALL
		});
		for (const [part, kept] of this.journal.parts(state)) parts.set(part, kept);
		for (const given of [...Object.values(state.images), ...Object.values(state.masks)]) if (given !== null) parts.set(FILE + nameOf(given.source), {
			value: given.source,
			bytes: bytesOf$1(given.source),
			alone: true
		});
		const places = state.truth?.rightPosition;
		if (places !== void 0) parts.set(FILE + nameOf(places), {
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
		const value = parts.get(GIVEN);
		if (value === void 0) return () => void 0;
		const kept = givenFrom(value, this.catalogue);
		const { typed, display, flight, paused } = kept;
		const images = bothSides((side) => orNull(kept.images[side], ({ name, file }) => ({
			id: freshId(),
			name,
			source: sourceFrom(parts, file)
		})));
		const { history, shelf } = this.journal.read(parts);
		const result = await this.result(parts, kept);
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
					truth,
					history,
					shelf,
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
			const text = `Restored from this browser: ${titleOf({
				name: null,
				images: names
			})}.`;
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
	/** Writes the results as a project file once they are all there; what is cancelled meanwhile is written after the next change. */
	async make() {
		const { state } = this.store;
		if (this.making || !isWhole(state)) return;
		const results = resultsOf(state);
		const typed = typedOf(state);
		if (typed === null || this.made !== null && areSame(this.made.results, results)) return;
		this.making = true;
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
		this.making = false;
		this.changed();
		if (this.store.state !== state) this.make();
	}
	/** `standing`: in place of masks whose files are not there. */
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
	/** The results, where they are of these very files. */
	async result(parts, { images, masks }) {
		if (!parts.has(RESULT)) return null;
		const value = objectOf(parts.get(RESULT), "result");
		const kept = {
			project: likeOf(value["project"], "", "result.project"),
			typed: typedFrom(value["typed"], this.catalogue, "result.typed"),
			of: likeOf(value["of"], "", "result.of"),
			beside: objectOf(value["beside"], "result.beside"),
			times: objectOf(value["times"], "result.times")
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
			estimated: opened.estimated,
			masks: opened.masks,
			standing: standingFor$1(opened)
		};
	}
};
/** The names under which images and masks are kept, as one text. */
function filesOf$1({ images, masks }) {
	const files = [
		images.left,
		images.right,
		masks.left,
		masks.right
	].map((given) => given === null ? null : nameOf(given.source));
	return JSON.stringify(files);
}
/** All but files and results; the same object while nothing of it has changed. */
function givenOf(state) {
	const typed = typedOf(state);
	const { settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, truth } = state;
	return typed === null ? null : given(settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, truth);
}
var given = remember((settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, truth) => {
	if (settings === null) return null;
	const file = ({ id, name, source }) => ({
		id,
		name,
		file: nameOf(source)
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
		truth: orNull(truth, ({ rightPosition, ...known }) => ({
			...known,
			file: nameOf(rightPosition)
		}))
	};
});
/** @throws Error naming the field that is damaged */
function givenFrom(value, catalogue) {
	const kept = objectOf(value, "pair");
	const file = (one, name) => {
		const { id, name: called, file: at } = objectOf(one, name);
		return {
			id: likeOf(id, 0, `${name}.id`),
			name: likeOf(called, "", `${name}.name`),
			file: likeOf(at, "", `${name}.file`)
		};
	};
	const files = (name) => {
		const sides = objectOf(kept[name], name);
		return bothSides((side) => orNull(sides[side], (one) => file(one, `${name}.${side}`)));
	};
	return {
		typed: typedFrom(kept["typed"], catalogue, "typed"),
		display: fitted$1(kept["display"], INITIAL.display, "display"),
		flight: orNull(kept["flight"], (flight) => fitted$1(flight, catalogue.flights[0]?.flight ?? {}, "flight")) ?? null,
		paused: kept["paused"] === true,
		images: files("images"),
		masks: files("masks"),
		truth: orNull(kept["truth"], (truth) => objectOf(truth, "truth")) ?? null
	};
}
/** What was typed, judged as it is where it is typed. @throws Error naming what is damaged */
function typedFrom(value, { defaults }, name) {
	const kept = objectOf(value, name);
	const settings = fitted$1(kept["settings"], defaults, `${name}.settings`);
	resolved(settings);
	const camera = orNull(kept["camera"], (given) => objectOf(given, `${name}.camera`));
	if (camera !== null) parse_camera(JSON.stringify(camera));
	const pair = (given, at) => {
		const [a, b] = listOf$1(given, at, (number, place) => likeOf(number, 0, place));
		return [a ?? NaN, b ?? NaN];
	};
	const offset = orNull(kept["offset"], (given) => pair(given, `${name}.offset`));
	if (offset !== null) constant_offset(...offset);
	const photos = objectOf(kept["photos"], `${name}.photos`);
	const photo = (side) => {
		const at = `${name}.photos.${side}`;
		const { fiducials, origin } = objectOf(photos[side], at);
		return {
			fiducials: listOf$1(fiducials, `${at}.fiducials`, (mark, place) => objectOf(mark, place)),
			origin: orNull(origin, (given) => pair(given, `${at}.origin`))
		};
	};
	const fiducialModel = likeOf(kept["fiducialModel"], "", `${name}.fiducialModel`);
	return {
		settings,
		camera,
		photos: bothSides(photo),
		fiducialModel,
		offset
	};
}
/** @throws Error where the file is not there */
function sourceFrom(parts, file) {
	const source = objectOf(parts.get(FILE + file), `file ${file}`);
	if (source.kind === "file" && !(source.file instanceof Blob)) throw new Error("an image is damaged");
	nameOf(source, file);
	return source;
}
/** The truth of images that have other numbers now. */
function truthFrom(truth, kept, parts, images) {
	const { file, ...known } = truth;
	const rightPosition = parts.get(FILE + file);
	if (!(rightPosition instanceof Float32Array)) throw new Error("the truth of the simulated pair is damaged");
	nameOf(rightPosition, file);
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
function bytesOf$1(source) {
	switch (source.kind) {
		case "file": return source.file.size;
		case "grey": return source.grey.byteLength;
		case "project": return 0;
	}
}
// www/pair/state/labels.ts
/** What is said of a point by its code. */
/** What the crate's catalogue does not know: edits are the page's. */
var EDITED = {
	rejected_by_hand: {
		text: "Matched, then rejected by hand.",
		label: "Rejected by hand"
	},
	manual: {
		text: "Measured by hand.",
		label: "Measured by hand"
	}
};
/** What a code says of a point: a sentence, or its label. */
function textOfCode(code, part = "text") {
	const name = CODES[code] ?? "undecided";
	if (name === "rejected_by_hand" || name === "manual") return EDITED[name][part];
	return message("verdict", name, part === "label" ? part : null);
}
// www/pair/panel/verdict.ts
/** Why a point was matched or refused, with the numbers that its rule compared. */
/** The rule that decided about the selected point, in words. */
function verdictOf(state, shown, match) {
	const { selection, settings } = state;
	const leftIndex = leftIndexOf(state, match.best, match.rules);
	if (selection === null || settings === null) return {
		code: MATCHED,
		text: ""
	};
	if (leftIndex < 0) return {
		code: UNDECIDED,
		text: comparesGreyValues(settings) ? "No left point was matched to this one: this strategy searches the right image itself, at the left points." : "No left point has this point as its best candidate."
	};
	const code = leftCodes(shown.left, match, shown.orientation)[leftIndex] ?? UNDECIDED;
	const own = selection.side === "left" ? code : rightCodes(shown.right, match, shown.orientation)[selection.index] ?? UNDECIDED;
	return {
		code,
		text: `${selection.side === "right" && own === UNDECIDED ? `${page("candidate_of", { point: leftIndex + 1 })} ` : ""}${textOfCode(code)} ${numbers(CODES[code] ?? "undecided", leftIndex, match, settings)}`.trimEnd()
	};
}
function numbers(code, index, match, settings) {
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
			if (gradients) return page(agreeing(best, second, largest), compared);
			return byGrey ? page("correlation", compared) : page("good_measure", {
				...compared,
				most: matching.max_measure
			});
		case "threshold":
			if (!Number.isFinite(best)) return "";
			return byGrey ? page("low_correlation", {
				...compared,
				least: matching.min_correlation
			}) : page("large_measure", {
				...compared,
				most: matching.max_measure
			});
		case "ambiguous": return page("ambiguous", compared);
		case "parallax": return gradients ? outOfGeometry(match, compared) : page("parallax", { tolerance: matching.parallax_tolerance });
		case "border":
		case "left_right":
			if (byGrey && Number.isFinite(best)) return page("correlation", compared);
			return gradients ? page("distance", compared) : "";
		case "imprecise": return page("imprecise", { most: matching.max_standard_error });
		default: return "";
	}
}
/** A verified match: where its descriptor alone would not have decided, the geometry did. */
function agreeing(best, second, largest) {
	if (!Number.isFinite(second)) return "only_candidate";
	return best > largest * second ? "agreeing_candidate" : "clear_candidate";
}
/** Its descriptor is like enough, but it lies elsewhere than the geometry has it; or there is no geometry. */
function outOfGeometry({ geometry, no_geometry }, compared) {
	if (geometry === null) return page("no_geometry", {
		...compared,
		no_geometry
	});
	return page("fundamental" in geometry.model ? "off_line" : "off_place", {
		...compared,
		threshold_px: geometry.threshold_px
	});
}
// www/pair/panel/announce.ts
/** Says beside the picture what became of the selected point, and why. */
/** `details` shows all that is known of it. */
function mountAnnouncements(host, store, details) {
	const keys = byId("keys");
	const text = h("span", {});
	fill(host, text, " ", button("Details", "selected-details", details));
	store.watch(["selection"], ([selection]) => {
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
		text.textContent = `${selection.side} point ${count(selection.index + 1)} at ${fixed(x, 1)}, ${fixed(y, 1)}. ${why === "" ? `${label}.` : why}`;
	});
}
// www/pair/engine/checks.ts
/** What the crate takes of what is typed. The crate itself is asked, so that no range stands here a second time; none of this takes time. */
/** The message of the crate's refusal; null where it takes what it is given. */
function refusalOf(call) {
	try {
		call();
		return null;
	} catch (error) {
		if (error instanceof Error && "code" in error) return error.message;
		throw error;
	}
}
/** What is allowed instead, in the crate's words; null where it takes what it is given. */
function allowedInstead(call) {
	const message = refusalOf(call);
	return message === null ? null : message.replace(/^.*; allowed: /u, "");
}
/** What of a camera is allowed; the rest of it is taken for granted. */
function allowedOfCamera(part) {
	return allowedInstead(() => parse_camera(JSON.stringify({
		focal_mm: 1,
		...part
	})));
}
function allowedOfOffset(dx, dy) {
	return allowedInstead(() => constant_offset(dx, dy));
}
/** Three marks that any camera can be oriented by. */
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
/** Why a flight cannot be flown; null where it can. */
function problemOfFlight(flight) {
	return refusalOf(() => check_flight(flight));
}
// www/pair/state/residuals.ts
/** Side of a pixel in mm: the root of the area that the interior orientation gives a pixel. */
function pixelMm(interior) {
	const [[a, b], [d, e]] = interior.parameters;
	return Math.sqrt(Math.abs(a * e - b * d));
}
/** The residual of each match at its point of one image: stride 4, x, y, dx, dy in px. */
function vectorsOf(side) {
	return remember((match, orientation, interior) => {
		const [[a, b], [d, e]] = interior.parameters;
		const determinant = a * e - b * d;
		const first = side === "left" ? 0 : 2;
		const vectors = new Float64Array(4 * orientation.residuals_mm.length);
		orientation.residuals_mm.forEach((residual, i) => {
			const [vx, vy] = [residual[first] ?? NaN, residual[first + 1] ?? NaN];
			vectors[4 * i] = match.matches[5 * i + first] ?? NaN;
			vectors[4 * i + 1] = match.matches[5 * i + first + 1] ?? NaN;
			vectors[4 * i + 2] = (e * vx - b * vy) / determinant;
			vectors[4 * i + 3] = (a * vy - d * vx) / determinant;
		});
		return vectors;
	});
}
var residualVectors = {
	left: vectorsOf("left"),
	right: vectorsOf("right")
};
/** The y-parallax left in each match that the adjustment kept, in px: the right photo's correction in y minus the left one's. */
var parallaxResiduals = remember((orientation, interior) => {
	const rejected = new Set(orientation.rejected);
	const pixel = pixelMm(interior);
	const kept = orientation.residuals_mm.filter((_, i) => !rejected.has(i));
	return Float64Array.from(kept, ([, left, , right]) => (right - left) / pixel);
});
// www/shared/panel/numberfield.ts
/** Fields for numbers that are no parameters of the crate's catalogue: what is not allowed is said, and the last valid value stays. */
var STAYS = "The last valid value stays in use.";
/** A number input that tells what it is described by; `change` is called when a number was typed. */
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
/** Where the problem of a field, or of a pair of them, is said. */
function problemLine(testid) {
	return h("p", {
		class: "field-problem",
		id: `c-${testid}-problem`,
		testid: `${testid}-problem`,
		role: "alert"
	});
}
/** A field with its label; `problem` where another line than its own says what is wrong. */
function numberField(label, unit, testid, change, problem) {
	const line = problem ?? problemLine(testid);
	const input = numberInput(testid, line, change);
	return {
		input,
		problem: line,
		element: h("div", { class: "control compact" }, h("label", { for: input.id }, label, unit === "" ? null : h("span", { class: "unit" }, ` ${unit}`)), input, problem === void 0 ? line : null)
	};
}
/** The first of some fields, by its label, in which something was typed that is not allowed; null where there is none. */
function firstRefused(fields) {
	return fields.find(([, input]) => input.getAttribute("aria-invalid") === "true" && typed(input) !== void 0)?.[0] ?? null;
}
/** The number typed: undefined where the field is empty, NaN where it holds no number. */
function typed({ value, valueAsNumber, validity }) {
	return value === "" && !validity.badInput ? void 0 : valueAsNumber;
}
function mark(input, wrong) {
	if (wrong) input.setAttribute("aria-invalid", "true");
	else input.removeAttribute("aria-invalid");
}
/** Shows a number, unless the field already says the same. */
function showNumber({ input, problem }, value) {
	if (value == null) input.value = "";
	else if (input.valueAsNumber !== value) input.value = String(value);
	mark(input, false);
	problem.textContent = "";
}
/** The number of a field, `last` where it is not allowed; `allowed` says what is instead of a value. */
function readNumber({ input, problem }, allowed, last) {
	const value = typed(input);
	const instead = value === void 0 ? null : Number.isNaN(value) ? "a number" : allowed(value);
	mark(input, instead !== null);
	problem.textContent = instead === null ? "" : `Allowed: ${instead}, or empty. ${STAYS}`;
	return instead === null ? value : last;
}
/** Two numbers that are given together: both, null where both fields are empty, undefined where they are no pair, which is then said. */
function readPair(inputs, problem, allowed) {
	const [a, b] = [typed(inputs[0]), typed(inputs[1])];
	const say = (text, wrong) => {
		problem.textContent = text;
		inputs.forEach((input, i) => {
			mark(input, wrong[i] === true);
		});
	};
	if (a === void 0 && b === void 0) {
		say("", [false, false]);
		return null;
	}
	if (a === void 0 || b === void 0) {
		say(`Give both numbers, or empty both. ${STAYS}`, [a === void 0, b === void 0]);
		return;
	}
	const instead = Number.isNaN(a + b) ? "two numbers" : allowed(a, b);
	if (instead === null) {
		say("", [false, false]);
		return [a, b];
	}
	const alone = [allowed(a, 0) !== null, allowed(0, b) !== null];
	say(`Allowed: ${instead}. ${STAYS}`, alone);
}
// www/pair/panel/camera.ts
/** The camera: typed, loaded, or from EXIF; and the offset between the images. */
var NUMBERS = [
	{
		label: "Focal length",
		unit: "mm",
		testid: "camera-focal",
		of: (c) => c.focal_mm,
		alone: (v) => ({ focal_mm: v })
	},
	{
		label: "Pixel size",
		unit: "mm",
		testid: "camera-pixel",
		of: (c) => c.pixel_mm,
		alone: (v) => ({ pixel_mm: v })
	},
	{
		label: "Principal pt x",
		unit: "mm",
		testid: "camera-x0",
		of: (c) => c.principal_point_mm?.[0],
		alone: (v) => ({ principal_point_mm: [v, 0] })
	},
	{
		label: "Principal pt y",
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
/** A camera of its numbers, in the order of `NUMBERS`; null without a focal length. */
function cameraOf([focal, pixel, x0 = 0, y0 = 0, k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0]) {
	if (focal === void 0) return null;
	const lens = {
		radial_distortion: [
			k1,
			k2,
			k3
		],
		tangential_distortion: [p1, p2]
	};
	return {
		focal_mm: focal,
		principal_point_mm: [x0, y0],
		...pixel === void 0 ? {} : { pixel_mm: pixel },
		...lens
	};
}
function mountCamera(host, store, loadFile) {
	const change = () => {
		const last = store.state.camera;
		const camera = cameraOf(fields.map((field, i) => {
			const number = NUMBERS[i];
			return number === void 0 ? void 0 : readNumber(field, (value) => allowedOfCamera(number.alone(value)), (last === null ? null : number.of(last)) ?? void 0);
		}));
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
	const fields = NUMBERS.map(({ label, unit, testid }) => numberField(label, unit, testid, change));
	const source = h("p", {
		class: "note",
		testid: "camera-source"
	});
	const load = button("Load camera.json …", "load-camera", loadFile);
	const clear = button("Clear", "clear-camera", () => store.dispatch({
		type: "camera",
		camera: null
	}));
	host.append(h("fieldset", { class: "group" }, h("legend", {}, "Camera"), source, h("div", { class: "pairs" }, ...fields.map(({ element }) => element)), h("div", { class: "buttons" }, load, clear)), offsetGroup(store));
	store.watch(["camera"], ([camera]) => {
		fields.forEach((field, i) => {
			showNumber(field, camera === null ? null : NUMBERS[i]?.of(camera));
		});
		clear.disabled = camera === null;
	});
	store.watch((s) => [
		s.camera,
		s.results.openLeft,
		s.results.openRight,
		s.results.match,
		s.photos,
		s.truth
	], () => fill(source, sourceText(store.state)));
}
function exifText(name, exif) {
	if (exif.origin === "panorama") return (exif.cautions ?? []).map((caution) => `The ${name} image is ${message("camera_caution", caution)}.`).join(" ");
	const camera = [exif.make != null && exif.model?.startsWith(exif.make) === true ? null : exif.make, exif.model].filter((part) => part != null).join(" ");
	const pixel = exif.pixel_mm == null ? "no pixel size" : `pixel ${significant(exif.pixel_mm)} mm`;
	const cautions = (exif.cautions ?? []).map((caution) => ` Caution: ${message("camera_caution", caution)}.`).join("");
	return `${message("camera_origin", exif.origin ?? "exif_focal_plane")}, ${name}: ${camera === "" ? "camera not named" : camera}, f = ${significant(exif.focal_mm)} mm, ${pixel}.${cautions}`;
}
function sourceText(state) {
	const exif = [["left", state.results.openLeft], ["right", state.results.openRight]].map(([name, opened]) => opened?.value.info.camera == null ? "" : exifText(name, opened.value.info.camera)).filter((text) => text !== "").join(" ");
	const used = pairCameras(state);
	const told = estimatedText(state);
	if (state.camera !== null) return `In use: the values below${state.truth === null ? "" : " (they came with the sample)"}. ${exif}`;
	if (!("missing" in used)) return `In use: the photos' own camera${told}. Values below replace it. ${exif}`;
	if (used.missing.kind !== "panorama" && state.results.match?.value.estimated != null) return `No camera is known: that of most photographs is assumed${told}. Values below replace it. ${exif}`;
	return `Orientation needs a focal length, and a pixel size or fiducial marks. With matches of gradients it does without. ${exif}`;
}
/** What is known of a camera that nobody calibrated. */
function estimatedText(state) {
	const camera = state.results.orientation?.value.cameras?.[0];
	const interior = interiorInUse(state)?.left;
	if (camera == null || interior === void 0) return "";
	const [focal, error] = [camera.focal_mm, camera.focal_standard_error_mm].map((v) => v / pixelMm(interior));
	return `, focal length ${fixed(focal ?? NaN, 0)} ± ${fixed(error ?? NaN, 0)} px`;
}
/** The offset of the right image: estimated, or given. */
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
			label: firstRefused([["Offset dx", dx.input], ["Offset dy", dy.input]])
		});
	};
	const problem = problemLine("offset");
	const dx = numberField("dx", "px", "offset-dx", change, problem);
	const dy = numberField("dy", "px", "offset-dy", change, problem);
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
			fill(found, "Matching by gradients searches the whole right image: it needs no offset.");
			return;
		}
		if (given !== null || result === void 0) {
			fill(found, given !== null ? "Given. Clear both fields to estimate it." : "Right minus left position. Empty: estimated by correlation, coarse to fine.");
			return;
		}
		const [mx, my] = result.value.median_px;
		const correlation = result.value.correlation;
		fill(found, `Estimated: median ${significant(mx)}, ${significant(my)} px${correlation == null ? "" : `, correlation ${correlation.toFixed(2)}`}${correlation != null && correlation < .5 ? ": low. Do the images overlap? A given offset may help" : ""}.`);
	});
	return h("fieldset", { class: "group" }, h("legend", {}, "Offset of the right image"), found, h("div", { class: "pairs" }, dx.element, dy.element), problem);
}
// www/pair/panel/controls.ts
/** The settings of the run: a control for each, in the order of the pipeline; those without effect under the others are hidden. */
/** Fills the settings panel once the crate's catalogue is there; `opener` opens it, and says how many settings were changed. */
function mountControls(host, store, opener) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue === null) return;
		let acts = resolved(catalogue.defaults);
		const { elements, show } = makeFolded(catalogue.parameters, {
			change: (key, value) => change(store, key, value),
			defaults: () => standardOf(store.state, catalogue),
			resolved: () => acts,
			refused: (label) => store.dispatch({
				type: "refused",
				part: "settings",
				label
			})
		}, {
			title: "Method",
			first: ["matching.strategy", "matching.refine"],
			reset: () => store.dispatch({
				type: "settings",
				settings: standardOf(store.state, catalogue)
			}),
			changed: (count) => fill(opener, settingsText(count))
		});
		fill(host, ...elements);
		store.watch(["settings", "truth"], ([settings]) => {
			if (settings === null) return;
			acts = resolved(settings);
			show(settings, acting_parameters(settings));
		});
	});
}
/** A threshold and a fraction of candidates exclude each other: setting one clears the other. */
var EXCLUSIVE = {
	"points.threshold": "points.fraction",
	"points.fraction": "points.threshold"
};
function change(store, key, value) {
	const { settings } = store.state;
	if (settings === null) return;
	const other = value === null ? void 0 : EXCLUSIVE[key];
	const free = other === void 0 ? settings : withSetting(settings, other, null);
	store.dispatch({
		type: "settings",
		settings: withSetting(free, key, value)
	});
}
/** The defaults. The base belongs to the simulated pair, as its camera does: without it by and bz would have another scale than the truth. */
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
/** Whether what the paper printed of its own pair can be set beside the results. */
/** Whether the images are of the paper's camera, which the flight of that name has: other pairs have nothing in common with the paper's. */
function hasPaperCamera(state) {
	const paper = state.catalogue?.flights.find(({ name }) => name === "paper");
	const cameras = pairCameras(state);
	return paper !== void 0 && !("missing" in cameras) && cameras.left.focal_mm === paper.flight.focal_mm;
}
// www/pair/state/display.ts
/** Which points the picture shows. */
/** Shown at first: accepted matches, and those that the user rejected, who may want them back. */
var MATCHES = [
	MATCHED,
	MANUAL,
	BY_HAND
];
/** Whether points of a code are shown: the others than these only where they are asked for. */
function isCodeShown({ points, hidden }, code) {
	if (hidden.includes(code)) return false;
	return points === "all" || points === "matched" && MATCHES.includes(code);
}
/** Codes of all other points. */
var REJECTED = [
	...REFUSALS.map(codeOf),
	GROSS_ERROR,
	UNDECIDED
];
/** Shows or hides the points of one code. Where only matches were shown, those of other codes stay hidden. */
function withCode(display, code, on) {
	const { points } = display;
	const others = (points === "all" ? display.hidden : [...points === "none" ? MATCHES : display.hidden, ...REJECTED]).filter((other) => other !== code);
	return {
		points: on ? "all" : points,
		hidden: on ? others : [...display.hidden.filter((other) => other !== code), code]
	};
}
// www/pair/view/palette.ts
/** Colours and shapes of points. Okabe and Ito's colours, told apart with any colour vision; shapes differ as well. */
/** Shape codes of the crate's `draw_points`. */
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
var STYLE_OF = {
	matched: {
		colour: "#00c08b",
		shape: SHAPES.circle
	},
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
	gross_error: {
		colour: "#d55e00",
		shape: SHAPES.diamond
	},
	undecided: {
		colour: "#56b4e9",
		shape: SHAPES.plus
	},
	rejected_by_hand: {
		colour: "#ff3b30",
		shape: SHAPES.cross
	},
	manual: {
		colour: "#9cff57",
		shape: SHAPES.square
	}
};
/** By code. */
var STYLES = CODES.map((name) => STYLE_OF[name]);
function styleOf(code) {
	const style = STYLES[code];
	if (style === void 0) throw new Error(`no style for code ${String(code)}`);
	return style;
}
/** The codes in drawing order: the common ones below, matches on top. */
var DRAWN = [
	UNDECIDED,
	...REFUSALS.map(codeOf),
	BY_HAND,
	GROSS_ERROR,
	MATCHED,
	MANUAL
];
var SELECTED = "#ffd400";
var CANDIDATE = "#56b4e9";
var EPIPOLAR = "#ff9ee0";
var LINE = "rgb(0 222 160 / 0.5)";
var LINE_REJECTED = "rgb(255 110 20 / 0.85)";
// www/pair/panel/swatch.ts
/** The mark of a code as a small picture, for legends. */
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
/** On a dark ground as in the image, so that white and yellow show in the light theme too. */
function swatch(code) {
	const style = styleOf(code);
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
		d: OUTLINES[style.shape] ?? "",
		fill: style.shape === SHAPES.dot ? style.colour : "none",
		stroke: style.colour,
		"stroke-width": 1.6
	}));
}
// www/pair/panel/counts.ts
/** The counts of each phase, as in the paper's Table 1, and what each rule refused. */
/** Places in the paper's Table 1; it does not count what the threshold of roundness leaves. */
var PAPER = {
	candidates: 0,
	after_roundness: null,
	after_suppression: 1
};
var PAPER_MATCHES = 2;
var PHASES = [
	["candidates", "Operator"],
	["after_roundness", "Roundness"],
	["after_suppression", "Suppression"]
];
/** The settings by which the paper counted, whose Table 1 says nothing of others. */
function countsAsPaper({ settings }) {
	return settings !== null && comparesMoments(settings) && resolved(settings).points.operator === resolved({ matching: { strategy: "moments" } }).points.operator;
}
/** Rules that only some strategies have. */
var RARE = /* @__PURE__ */ new Set([
	"border",
	"left_right",
	"not_converged",
	"imprecise",
	"frame"
]);
function mountCounts(host, store) {
	const phases = h("div", {});
	const rules = h("div", {});
	const points = section("Points", "counts-section", phases);
	const matches = section("Matches", "matches-section", rules);
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
	], () => {
		const { state } = store;
		points.classList.toggle("is-stale", pointsAreStale(state));
		matches.classList.toggle("is-stale", isStale(state, "match"));
		fill(phases, phaseTable(state));
		fill(rules, ruleTable(state, store), scoreLines(state));
	});
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
	return h("table", { aria: { label: "Points after each phase" } }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Phase"), h("th", { scope: "col" }, "Left"), h("th", { scope: "col" }, "Right"), printed !== void 0 ? h("th", {
		scope: "col",
		class: "paper",
		title: "The paper's Table 1, for its own pair"
	}, "Paper, l / r") : null)), h("tbody", {}, ...body, markStale(row("Matching", cell("count-left-matches", count(matches)), cell("count-right-matches", count(matches)), ...counted(PAPER_MATCHES)), isStale(state, "match") && !pointsAreStale(state)), row("Threshold", cell("threshold-left", threshold(left?.threshold)), cell("threshold-right", threshold(right?.threshold)), ...paper((of) => [of.threshold, of.threshold].map(count).join(" / ")))));
}
/** The matches with what was done to them by hand. */
function matchOf(state) {
	return editedPair(state)?.match ?? state.results.match?.value;
}
function ruleTable(state, store) {
	const result = matchOf(state);
	const total = result?.rules.length ?? 0;
	const share = (n) => n === void 0 || total === 0 ? "–" : percent(n / total);
	const refused = REFUSALS.filter((rule) => !RARE.has(rule) || (result?.counts[rule] ?? 0) > 0).map((rule) => ruleRow(codeOf(rule), `refused-${rule}`, result?.counts[rule], share, state, store));
	const gross = shownPair(state).orientation?.rejected.length;
	return h("table", { aria: { label: "What became of the left points" } }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Left points"), h("th", { scope: "col" }, "Number"), h("th", { scope: "col" }, "Share"), h("th", { scope: "col" }, "Show"))), h("tbody", {}, ruleRow(MATCHED, "count-matches", result?.counts.matches, share, state, store), markStale(ruleRow(GROSS_ERROR, "count-gross-errors", gross, share, state, store, "of these, gross errors"), gross !== void 0 && isStale(state, "orientation") && !isStale(state, "match")), ...byHand(result).map(([code, testid, value, label]) => ruleRow(code, testid, value, share, state, store, label)), h("tr", { class: "subhead" }, h("th", {
		scope: "rowgroup",
		colspan: 4
	}, "Rejected by")), ...refused));
}
/** What was done by hand, where anything was. */
function byHand(result) {
	if (result === void 0) return [];
	const { rejected, manual } = countsByHand(result);
	return [[
		MANUAL,
		"count-manual",
		manual,
		"of these, measured by hand"
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
		aria: { label: `Show: ${own}` }
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
	return row(h("span", { class: "legend" }, swatch(code), name), cell(testid, count(value)), h("td", { class: "number" }, share(value)), h("td", { class: "centre" }, toggle));
}
/** How many matches are right, where the truth is known. */
function scoreLines(state) {
	const score = state.results.score?.value;
	const { match } = shownPair(state);
	if (score === void 0 || match === null || !isCurrent(state, "score") || score.matches === 0) return null;
	const line = (name, testid, value, of, title) => h("tr", { title }, h("th", { scope: "row" }, name), cell(testid, count(value)), h("td", { class: "number" }, of));
	const share = (value) => percent(value / score.matches);
	return h("table", {
		testid: "score",
		aria: { label: "Matches against the truth" }
	}, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Against the truth"), h("th", { scope: "col" }, "Number"), h("th", { scope: "col" }, "Share"))), h("tbody", {}, line("Right", "score-right", score.right, share(score.right), "Within 1.5 px of where the surface at the left pixel, or at one of its 8 neighbours, is seen: points lie on edges, where the surface may jump between two pixels."), line("Strictly right", "score-strict", score.strict, share(score.strict), "Within 1.5 px of where the surface at the left pixel itself is seen."), line("Missed", "score-missed", score.missed, "", "Left points that are visible in the right image and have no right match.")));
}
/** What became of the points, in one sentence for the status line. */
function summary(state) {
	const shown = shownPair(state);
	if (shown.match === null) return "";
	const codes = leftCodes(shown.left, shown.match, shown.orientation);
	return page("matched", {
		matches: shown.match.counts.matches,
		points: codes.length
	});
}
// www/pair/state/draft.ts
/** A match that is measured by hand: where it lies so far, and where its other point may be. */
/** Matches around a place that say where it lies in the other image. */
var NEIGHBOURS = 12;
/** Fewer of them say only how far things move. */
var LEAST_OF_MAP = 6;
/** Places are kept to so many parts of a px: nobody measures better. */
var STEPS_OF_PX = 100;
/** The places of a side, then of the other, of the matches nearest to a place; nearest first. */
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
	return rows.slice(0, NEIGHBOURS).map(({ row }) => {
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
/** The median of some values; NaN of none. */
function middle(values) {
	const sorted = [...values].sort((a, b) => a - b);
	return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}
/** How one coordinate of the other image follows from a place, by least squares about the neighbours' middle; null where they lie along a line. */
function mapped$1(places, at, k) {
	const mean = (of) => places.reduce((sum, place) => sum + of(place), 0) / places.length;
	const [mx, my, mv] = [
		mean((p) => p[0]),
		mean((p) => p[1]),
		mean((p) => p[k])
	];
	let [xx, xy, yy, xv, yv] = [
		0,
		0,
		0,
		0,
		0
	];
	for (const place of places) {
		const [x, y, v] = [
			place[0] - mx,
			place[1] - my,
			place[k] - mv
		];
		xx += x * x;
		xy += x * y;
		yy += y * y;
		xv += x * v;
		yv += y * v;
	}
	const determinant = xx * yy - xy * xy;
	if (!(determinant > .001 * xx * yy)) return null;
	return mv + ((yy * xv - xy * yv) * (at[0] - mx) + (xx * yv - xy * xv) * (at[1] - my)) / determinant;
}
/** Where the ground at a place of one image lies in the other, by the matches around it; null without matches. */
function byNeighbours(edited, side, at) {
	const places = nearest(edited, side, at);
	if (places.length === 0) return null;
	const [x, y] = places.length < LEAST_OF_MAP ? [null, null] : [mapped$1(places, at, 2), mapped$1(places, at, 3)];
	if (x !== null && y !== null) return [x, y];
	return [at[0] + middle(places.map((p) => p[2] - p[0])), at[1] + middle(places.map((p) => p[3] - p[1]))];
}
/** The place nearest to another one along a line of positions (stride 2); the one place where there is only one, and the same without any. */
function onLine({ positions }, [x, y]) {
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
var predicted = remember((edited, draft, line) => {
	const place = draft.places[otherSide(draft.side)];
	if (place === null) return null;
	const known = [place[0], place[1]];
	const around = byNeighbours(edited, otherSide(draft.side), known);
	return around === null || line?.side !== draft.side ? around : onLine(line, around);
});
/** Where the point that is placed now is expected: by the matches around it, on its epipolar line where one is known. */
function expectedPlace(state) {
	const edited = editedPair(state);
	if (edited === null || state.draft === null) return null;
	return predicted(edited, state.draft, lineOfDraft(state));
}
/** Where the point may lie in the image in which it is placed now. */
function lineOfDraft(state) {
	return state.draft !== null && isCurrent(state, "line") ? state.results.line?.value ?? null : null;
}
/** Where the match lies in an image: where it was placed, else where it is expected; null where neither is known. */
function placeOfDraft(state, side) {
	const { draft } = state;
	if (draft === null) return null;
	const own = draft.places[side];
	if (own !== null) return [own[0], own[1]];
	return side === draft.side ? expectedPlace(state) : null;
}
var rounded = (value) => Math.round(value * STEPS_OF_PX) / STEPS_OF_PX;
/** The size of an image; null while it is not open. */
function sizeOf({ results }, side) {
	return results[side === "left" ? "openLeft" : "openRight"]?.value.info ?? null;
}
/** The draft with its point of a side at a place, within the image. */
function placed(state, draft, side, [x, y]) {
	const { width, height } = sizeOf(state, side) ?? {
		width: Infinity,
		height: Infinity
	};
	const at = [rounded(Math.min(width, Math.max(0, x))), rounded(Math.min(height, Math.max(0, y)))];
	return {
		...draft,
		places: {
			...draft.places,
			[side]: at
		}
	};
}
/** A new match whose first point lies at a place of an image; its other point comes next. */
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
/** The match of the selected point, to be moved; null where there is none. */
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
/** The edit that a draft becomes; null while a point of it is not placed. */
function editOfDraft(state) {
	const { draft, history } = state;
	const [left, right] = [placeOfDraft(state, "left"), placeOfDraft(state, "right")];
	if (draft === null || left === null || right === null) return null;
	const at = [
		rounded(left[0]),
		rounded(left[1]),
		rounded(right[0]),
		rounded(right[1])
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
/** While a match is measured by hand: what to do next, where its points lie, and buttons for each key. */
/** In the bar above the pictures. `follow` shows the points that are measured. */
function mountDraft(host, store, editing, follow) {
	const tool = button("Add match", "tool-measure", () => editing.toggle("measure"), "Measure a match by hand (A)");
	const text = h("span", {
		testid: "draft-text",
		role: "status"
	});
	const accept = button("Accept", "draft-accept", () => editing.accept(), "The match is measured (Enter)");
	const fit = button("Fit", "draft-fit", () => void editing.fit(), "Move the right point to where least squares matching finds it (F)");
	const exchange = button("Other image", "draft-exchange", () => {
		editing.exchange();
		follow();
	}, "Go on with the point in the other image (O)");
	const bar = h("div", {
		class: "drafting",
		testid: "draft",
		role: "group",
		aria: { label: "Match measured by hand" }
	}, text, accept, exchange, fit, button("Cancel", "draft-cancel", () => editing.leave(), "Give this match up (Escape)"));
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
		fit.disabled = accept.disabled;
		const now = textOf$1(state);
		if (text.textContent !== now) text.textContent = now;
	});
}
function textOf$1(state) {
	const { draft } = state;
	if (draft === null) return "New match: press a point in either picture, or Enter for the middle of the active one.";
	const place = (side) => {
		const at = placeOfDraft(state, side);
		return at === null ? `${side} –` : `${side} ${fixed(at[0], 2)}, ${fixed(at[1], 2)}`;
	};
	return `${draft.of === null ? "New match" : "Moved match"}: ${place("left")} · ${place("right")} px. Place the ${draft.side} point: press, or arrows by 0.1 px, with Shift by 1 px.`;
}
// www/pair/state/choice.ts
/** The matches that an edit would change: those chosen together, else that of the selected point. */
var NONE = [];
var leftsOf = remember((edited, chosen) => {
	const lefts = leftsByTarget(edited);
	return chosen.flatMap((key) => lefts.get(key) ?? []);
});
/** The left points of the matches that are chosen together. */
function chosenLefts(state) {
	const edited = editedPair(state);
	return edited === null || state.chosen.length === 0 ? NONE : leftsOf(edited, state.chosen);
}
/** The left points whose matches an edit would change. */
function concerned(state, edited) {
	const chosen = chosenLefts(state);
	if (chosen.length > 0) return chosen;
	const left = leftIndexOf(state, edited.match.best, edited.match.rules);
	return left < 0 ? NONE : [left];
}
/** What rejects or restores the chosen matches; null where none of them is there for it. */
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
/** The keys of the matches of left points; points without one have none. */
function keysOfLefts(edited, lefts) {
	return [...lefts].flatMap((left) => {
		const target = targetOfLeft(edited, left);
		return target === null ? [] : [keyOfTarget(target)];
	});
}
/** The keys of matches whose point of a side lies in a rectangle of its image. */
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
/** The choice with matches added, or taken out where all of them were in it. */
function toggled(chosen, keys) {
	const own = new Set(chosen);
	const all = keys.every((key) => own.has(key));
	for (const key of keys) if (all) own.delete(key);
	else own.add(key);
	return [...own];
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
/** What is done to the matches by hand: reject, restore, undo, redo, the history, and what became of the orientation. */
/** The name of the edit that undo takes back, and of the one that redo makes again; null where there is none. */
function steps({ history: { edits, done } }) {
	const [last, next] = [edits[done - 1], edits[done]];
	return {
		undo: last === void 0 ? null : nameOfEdit(last),
		redo: next === void 0 ? null : nameOfEdit(next)
	};
}
/** How many matches an edit is about, where it is more than one. */
function several(edit) {
	return edit !== null && edit.of.length > 1 ? ` ${count(edit.of.length)}` : "";
}
/** A button that says what it would do, and cannot be pressed where that is nothing. */
function set(made, text, disabled) {
	if (made.textContent !== text) made.textContent = text;
	made.disabled = disabled;
}
/** In the panel of the matches. */
function mountEdits(host, store, editing, follow) {
	const reject = button("Reject", "reject", () => editing.edit("reject"), "Take the chosen matches out of the orientation (Delete)");
	const restore = button("Restore", "restore", () => editing.edit("restore"), "Use the chosen matches again (R)");
	const move = button("Move", "move", () => {
		editing.move();
		follow();
	}, "Measure the selected match anew, in either image (E)");
	const undo = button("Undo", "undo", () => editing.step(-1), "Take back the last edit (Ctrl+Z)");
	const redo = button("Redo", "redo", () => editing.step(1), "Make the edit again that was undone (Ctrl+Shift+Z or Ctrl+Y)");
	const hint = h("p", {
		class: "note",
		testid: "edit-hint"
	}, "To reject wrong matches, choose them: press a row or a point, with Ctrl for more of them, or draw a rectangle in a picture with Shift. Then press Delete.");
	const compared = h("div", {
		testid: "edit-compared",
		role: "status"
	});
	const history = h("ol", {
		class: "history",
		testid: "history"
	});
	const unfold = h("summary", {}, "");
	const details = h("details", { testid: "history-section" }, unfold, history);
	const panel = h("section", {
		class: "edits",
		testid: "edits",
		aria: { label: "Edits by hand" }
	});
	panel.append(h("div", { class: "buttons" }, reject, restore, move, undo, redo), hint, compared, details);
	host.append(panel);
	store.watch((s) => [
		s.results,
		s.history,
		s.chosen,
		s.selection,
		s.before,
		s.images
	], () => {
		const { state } = store;
		panel.hidden = editedPair(state) === null;
		const [off, on] = [editOfChoice(state, "reject"), editOfChoice(state, "restore")];
		set(reject, `Reject${several(off)}`, off === null);
		set(restore, `Restore${several(on)}`, on === null);
		move.disabled = moving(state) === null;
		const { edits } = state.history;
		const names = steps(state);
		set(undo, names.undo === null ? "Undo" : `Undo: ${names.undo}`, names.undo === null);
		set(redo, names.redo === null ? "Redo" : `Redo: ${names.redo}`, names.redo === null);
		undo.hidden = edits.length === 0;
		redo.hidden = names.redo === null;
		hint.hidden = edits.length > 0 || chosenLefts(state).length > 0;
		details.hidden = edits.length === 0;
		unfold.textContent = `History: ${count(edits.length)} ${edits.length === 1 ? "edit" : "edits"}`;
		fill(compared, ...comparison(state));
	});
	store.watch(["history"], () => showHistory(history, store.state, store));
}
/** Every state can be gone to by a press. */
function showHistory(host, { history: { edits, done } }, store) {
	const focused = host.contains(document.activeElement);
	const entry = (place, name) => {
		const go = button(name, `history-${String(place)}`, () => store.dispatch({
			type: "goto",
			done: place
		}));
		go.className = "link";
		if (place === done) go.setAttribute("aria-current", "step");
		return h("li", { class: place > done ? "undone" : "" }, go);
	};
	fill(host, entry(0, "as matched"), ...edits.map((edit, i) => entry(i + 1, nameOfEdit(edit))));
	if (focused) host.querySelector("[aria-current]")?.focus({ preventScroll: true });
}
var ANGLES = [
	"omega_deg",
	"phi_deg",
	"kappa_deg"
];
/** The figures of the orientation before the latest edit and now. */
function comparison(state) {
	const { before, history } = state;
	if (history.edits.length === 0 || before === null) return [];
	const now = isCurrent(state, "orientation") ? state.results.orientation?.value ?? null : null;
	const interior = interiorInUse(state)?.left;
	const pixel = interior === void 0 ? NaN : pixelMm(interior);
	const used = ({ residuals_mm, rejected }) => count(residuals_mm.length - rejected.length);
	const sigma = ({ sigma0_mm }) => fixed(sigma0_mm === null ? null : sigma0_mm / pixel, 3);
	const error = (field) => (of) => fixed((of.total_standard_errors ?? of.standard_errors)?.[field], 4);
	const line = (name, testid, text) => row(name, h("td", {
		class: "number",
		testid: `${testid}-before`
	}, text(before)), h("td", {
		class: "number",
		testid: `${testid}-now`
	}, now === null ? "…" : text(now)));
	const head = h("tr", {}, h("th", { scope: "col" }, "Orientation"), h("th", { scope: "col" }, "before"), h("th", { scope: "col" }, "now"));
	const angles = ANGLES.map((field) => {
		const symbol = UNKNOWNS.find((unknown) => unknown.field === field)?.symbol ?? field;
		return line(`standard error of ${symbol}, °`, `compared-${field}`, error(field));
	});
	const body = h("tbody", {}, line("σ₀, px", "compared-sigma0", sigma), line("points used", "compared-points", used), ...angles);
	return [h("table", {
		class: "tight",
		aria: { label: "Orientation before and after the edit" }
	}, h("thead", {}, head), body)];
}
/** With the pictures: the tool that chooses, undo and redo; in the bar itself, which is always in sight, what is done to the choice. */
function mountEditTools(host, bar, store, editing) {
	const choose = button("Choose", "tool-choose", () => editing.toggle("choose"));
	choose.title = "Choose matches by a rectangle, to reject or restore them (S; or Shift with a drag)";
	const undo = button("↶", "tool-undo", () => editing.step(-1));
	const redo = button("↷", "tool-redo", () => editing.step(1));
	const reject = button("Reject", "tool-reject", () => editing.edit("reject"), "Take the chosen matches out of the orientation (Delete)");
	const restore = button("Restore", "tool-restore", () => editing.edit("restore"), "Use the chosen matches again (R)");
	host.append(h("span", { class: "divider" }), choose, undo, redo);
	bar.append(reject, restore);
	store.watch((s) => [
		s.tool,
		s.history,
		s.chosen,
		s.selection,
		s.results.match
	], () => {
		const { state } = store;
		choose.setAttribute("aria-pressed", String(state.tool === "choose"));
		byId("view").dataset.tool = state.tool;
		const [off, on] = [editOfChoice(state, "reject"), editOfChoice(state, "restore")];
		set(reject, `Reject${several(off)}`, off === null);
		set(restore, `Restore${several(on)}`, on === null);
		reject.hidden = state.tool !== "choose" && state.chosen.length === 0;
		restore.hidden = reject.hidden || on === null;
		const names = steps(state);
		for (const [made, name, keys] of [[
			undo,
			names.undo === null ? "Undo" : `Undo: ${names.undo}`,
			"Ctrl+Z"
		], [
			redo,
			names.redo === null ? "Redo" : `Redo: ${names.redo}`,
			"Ctrl+Shift+Z"
		]]) {
			made.title = `${name} (${keys})`;
			made.setAttribute("aria-label", name);
			made.hidden = state.history.edits.length === 0;
		}
		undo.disabled = names.undo === null;
		redo.disabled = names.redo === null;
	});
}
/** Undo and redo by their keys, wherever the keyboard is but in a field that has an undo of its own; the others in the list of matches. */
function mountEditKeys(list, store, editing) {
	document.addEventListener("keydown", (event) => {
		const { target, key } = event;
		if (!(event.ctrlKey || event.metaKey) || event.altKey || target instanceof Element && target.closest("input, textarea, select, dialog") !== null) return;
		if (byId("view").offsetParent === null || store.state.history.edits.length === 0) return;
		const letter = key.toLowerCase();
		if (letter === "z") editing.step(event.shiftKey ? 1 : -1);
		else if (letter === "y") editing.step(1);
		else return;
		event.preventDefault();
	});
	list.addEventListener("keydown", (event) => {
		const { target, key } = event;
		if (event.ctrlKey || event.metaKey || event.altKey || target instanceof Element && target.closest("input, select") !== null) return;
		if (key === "Delete" || key === "Backspace") editing.edit("reject");
		else if (key === "r" || key === "R") editing.edit("restore");
		else if (key === "x" || key === "X") editing.choose(store.state.selection);
		else if (key === "e" || key === "E") editing.move();
		else if (key === "Escape") editing.leave();
		else return;
		event.preventDefault();
	});
}
// www/pair/panel/fiducials.ts
/** Fiducial marks of one photo: a table to type into, or a CSV file. */
var FIELDS = [
	"col",
	"row",
	"x_mm",
	"y_mm"
];
var HEADS = {
	col: "col px",
	row: "row px",
	x_mm: "x mm",
	y_mm: "y mm"
};
function mountFiducials(host, store, loadFile) {
	const model = h("select", {
		id: "fiducial-model",
		testid: "fiducial-model"
	});
	model.append(new Option("Affine, 6 parameters", "affine"), new Option("Similarity, 4 parameters", "similarity"));
	model.addEventListener("change", () => {
		store.dispatch({
			type: "fiducialModel",
			model: model.value === "similarity" ? "similarity" : "affine"
		});
	});
	store.watch(["fiducialModel"], ([value]) => {
		model.value = value;
	});
	host.append(h("fieldset", { class: "group" }, h("legend", {}, "Interior orientation"), h("div", { class: "control" }, h("label", { for: "fiducial-model" }, "Transformation"), model), photo("left", store, loadFile), photo("right", store, loadFile)));
}
function photo(side, store, loadFile) {
	const table = h("div", { class: "scroll" });
	const result = h("p", {
		class: "note",
		testid: `interior-${side}`
	});
	const set = (change) => store.dispatch({
		type: "photo",
		side,
		photo: change
	});
	const name = side === "left" ? "Left" : "Right";
	const add = button("Add mark", `add-fiducial-${side}`, () => {
		set({ fiducials: [...store.state.photos[side].fiducials, {
			col: NaN,
			row: NaN,
			x_mm: NaN,
			y_mm: NaN
		}] });
	});
	const load = button("Load CSV …", `load-fiducials-${side}`, () => loadFile(side));
	const clear = button("Clear", `clear-fiducials-${side}`, () => set({ fiducials: [] }));
	let shown = null;
	const stage = side === "left" ? "interiorLeft" : "interiorRight";
	store.watch((s) => [s.photos[side].fiducials, s.results[stage]], ([fiducials, interior]) => {
		const residuals = interior?.value.fiducials?.residuals_mm ?? [];
		if (shown !== fiducials) {
			if (shown?.length !== fiducials.length) fill(table, marksTable(side, store, fiducials.length));
			shown = fiducials;
		}
		showMarks(table, fiducials, residuals.length === fiducials.length ? residuals : []);
		clear.disabled = fiducials.length === 0;
		fill(result, interiorText(interior?.value.fiducials?.sigma0_mm, interior?.value.fiducials?.degrees_of_freedom, fiducials.length));
	});
	return h("div", { class: "photo" }, h("h4", {}, `${name} image`), result, table, h("div", { class: "buttons" }, add, load, clear), originFields(side, store));
}
function interiorText(sigma, freedom, marks) {
	if (marks === 0) return "No fiducial marks. The pixel size is used.";
	if (freedom === void 0) return `${String(marks)} marks.`;
	return `${String(marks)} marks, σ₀ ${sigma == null ? "not determined" : `${fixed(1e3 * sigma, 1)} µm`}, ${String(freedom)} degrees of freedom.`;
}
function marksTable(side, store, rows) {
	if (rows === 0) return "";
	const body = Array.from({ length: rows }, (_, i) => h("tr", {}, h("th", { scope: "row" }, String(i + 1)), ...FIELDS.map((field) => h("td", {}, markInput(side, store, i, field))), h("td", { class: "number residual" }, ""), h("td", {}, removeButton(side, store, i))));
	return h("table", {
		class: "marks",
		testid: `fiducials-${side}`,
		aria: { label: `Fiducial marks, ${side}` }
	}, h("thead", {}, h("tr", {}, h("th", {}, ""), ...FIELDS.map((field) => h("th", { scope: "col" }, HEADS[field])), h("th", {
		scope: "col",
		title: "Residuals vx, vy"
	}, "v µm"), h("th", {}, ""))), h("tbody", {}, ...body));
}
function markInput(side, store, index, field) {
	const input = h("input", {
		type: "number",
		aria: { label: `Mark ${String(index + 1)}, ${HEADS[field]}` }
	});
	input.step = "any";
	input.addEventListener("change", () => {
		const fiducials = store.state.photos[side].fiducials.map((mark, i) => i === index ? {
			...mark,
			[field]: input.valueAsNumber
		} : mark);
		store.dispatch({
			type: "photo",
			side,
			photo: { fiducials }
		});
	});
	return input;
}
function removeButton(side, store, index) {
	const remove = button("×", `remove-fiducial-${side}-${String(index)}`, () => {
		store.dispatch({
			type: "photo",
			side,
			photo: { fiducials: store.state.photos[side].fiducials.filter((_, i) => i !== index) }
		});
	});
	remove.className = "icon";
	remove.setAttribute("aria-label", `Remove mark ${String(index + 1)}`);
	return remove;
}
function showMarks(table, fiducials, residuals) {
	table.querySelectorAll("tbody tr").forEach((line, i) => {
		line.querySelectorAll("input").forEach((input, f) => {
			const field = FIELDS[f];
			const value = field === void 0 ? void 0 : fiducials[i]?.[field];
			if (value === void 0 || Object.is(input.valueAsNumber, value)) return;
			input.value = Number.isFinite(value) ? String(value) : "";
		});
		const cell = line.querySelector(".residual");
		const [vx, vy] = residuals[i] ?? [];
		if (cell !== null) cell.textContent = vx === void 0 ? "" : `${fixed(1e3 * vx, 0)}, ${fixed(1e3 * (vy ?? NaN), 0)}`;
	});
}
/** Where the image lies in the scan whose marks were measured. */
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
			label: firstRefused(inputs.map((input) => [`Origin of the ${side} image in the scan`, input]))
		});
	};
	const field = (name, testid) => {
		const input = numberInput(testid, problem, change);
		input.setAttribute("aria-label", `${side} image in the scan, ${name}, px`);
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
	return h("div", { class: "control compact origin" }, h("span", { title: "Column and row of this image’s top-left corner in the scan in which the marks were measured. Empty: the image is the whole scan." }, "Origin in the scan ", h("span", { class: "unit" }, "col, row px")), ...inputs, problem);
}
// www/pair/panel/geometry.ts
/** What relates the two views, by which matches of gradients were verified: the kind of model, its precision, where it is degenerate. */
function mountGeometry(host, store) {
	const body = h("div", {});
	const panel = section("Geometry of the two views", "geometry-section", body);
	host.append(panel);
	store.watch([
		"results",
		"settings",
		"images",
		"camera",
		"photos",
		"masks"
	], () => {
		const { state } = store;
		panel.hidden = state.settings === null || !comparesGradients(state.settings);
		panel.classList.toggle("is-stale", isStale(state, "match"));
		if (!panel.hidden) fill(body, ...content$2(state));
	});
}
function content$2(state) {
	const { match } = shownPair(state);
	if (match === null) return [h("p", { class: "note" }, "Not computed yet.")];
	if (match.geometry === null) {
		const none = match.no_geometry;
		return [h("p", {
			class: none === null ? "note" : "field-problem",
			testid: "geometry-reason"
		}, none === null ? "Not computed yet." : `None: ${message("no_geometry", none)}.`)];
	}
	const { degenerate } = match.geometry;
	return [...degenerate === null ? [] : [h("p", {
		class: "field-problem",
		testid: `degenerate-${degenerate}`
	}, message("degeneracy", degenerate))], facts(figures(match, match.geometry))];
}
function figures(match, { model: { kind }, sigma_px: sigma, threshold_px: threshold, focal }) {
	return [
		{
			name: "Model",
			testid: "geometry-kind",
			value: message("two_view_model", { kind }, "label"),
			help: message("two_view_model", { kind }, "help")
		},
		{
			name: "Matches that agree",
			testid: "geometry-matches",
			value: count(match.counts.matches),
			help: "All others are rejected. Matches that only the geometry made unambiguous are among them."
		},
		{
			name: "Standard error of a coordinate",
			testid: "geometry-sigma",
			value: `${fixed(sigma, 3)} px`,
			help: "From the distances of these matches to their epipolar lines, or to their predicted positions."
		},
		{
			name: "Threshold",
			testid: "geometry-threshold",
			value: `${fixed(threshold, 2)} px`,
			help: "Largest distance of a match that agrees. It follows from the scatter of the matches where none is given."
		},
		...focal === null ? [] : [{
			name: "Focal length, estimated",
			testid: "geometry-focal",
			value: `${fixed(focal.focal_px, 0)} ± ${fixed(focal.standard_error_px, 0)} px`,
			help: "Of both cameras, from the matches alone, with its standard error. The principal point is assumed at the image centre. A relative error of a tenth is small enough for the relative orientation."
		}]
	];
}
// www/shared/panel/menu.ts
/** A menu: a button, and what it unfolds. A press elsewhere, a choice or Escape folds it again. On wide screens a style may show it unfolded. */
function mountMenu(press, panel) {
	const show = (unfolded) => {
		panel.classList.toggle("is-open", unfolded);
		press.setAttribute("aria-expanded", String(unfolded));
	};
	const isUnfolded = () => panel.classList.contains("is-open");
	press.setAttribute("aria-controls", panel.id);
	press.addEventListener("click", () => show(!isUnfolded()));
	document.addEventListener("pointerdown", ({ target }) => {
		if (isUnfolded() && target instanceof Node && !panel.contains(target) && !press.contains(target)) show(false);
	});
	panel.addEventListener("click", ({ target }) => {
		if (target instanceof Element && target.closest("button:not([aria-expanded])") !== null) show(false);
	});
	document.addEventListener("keydown", ({ key }) => {
		if (key !== "Escape" || !isUnfolded()) return;
		const held = panel.contains(document.activeElement);
		show(false);
		if (held) press.focus();
	});
	show(false);
}
// www/pair/files/report.ts
/** The report of the pair on the screen: made in a worker of its own, step by step, and saved as one file. */
/** What the report is made of; null where an image is missing. */
function inputOf(state) {
	const { left, right } = state.images;
	const { settings, camera, photos, masks, offset, fiducialModel } = state;
	if (left === null || right === null || settings === null) return null;
	const truth = truthOf(state);
	const photo = (side) => ({
		...photos[side],
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
		masks: [masks.left?.grey ?? null, masks.right?.grey ?? null]
	};
}
async function exportReport(store, engine) {
	const input = inputOf(store.state);
	if (input === null) return;
	const say = (text) => store.dispatch({
		type: "notice",
		notice: {
			kind: "busy",
			text
		}
	});
	const client = engine.client("report");
	try {
		say("Report: reading the images …");
		const steps = await client.call("reportOpen", input);
		for (const [i, step] of steps.entries()) {
			say(`Report, step ${String(i + 1)} of ${String(steps.length + 1)}: matching, ${step} …`);
			await client.call("reportStep", null);
		}
		say(`Report, step ${String(steps.length + 1)} of ${String(steps.length + 1)}: writing …`);
		const page = await client.call("reportPage", null);
		save(new Blob([page], { type: "text/html" }), `${baseName(store.state)}-report.html`);
		store.dispatch({
			type: "notice",
			notice: isEdited(store.state) ? {
				kind: "info",
				text: "The report was saved. It matches by every strategy anew: edits by hand are not in it."
			} : null
		});
	} catch (error) {
		if (!(error instanceof Cancelled)) throw error;
		store.dispatch({
			type: "notice",
			notice: {
				kind: "info",
				text: "The report was cancelled."
			}
		});
	} finally {
		client.cancel();
	}
}
// www/pair/panel/matrix.ts
var CELL = 44;
var HEAD = 26;
/** The part of a cell that the number takes, below the square: a small square would strike it through. */
var FOOT = 12;
/** The matrix of correlations: the larger the square the stronger, filled where positive and hatched by its outline where negative. */
function correlationPicture({ correlations }) {
	const size = HEAD + CELL * UNKNOWNS.length;
	const words = UNKNOWNS.flatMap(({ symbol }, i) => UNKNOWNS.slice(i + 1).map((other, k) => `${symbol} and ${other.symbol} ${fixed(correlations[i]?.[i + 1 + k], 2)}`));
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
	return h("figure", { testid: "correlations" }, h("figcaption", { title: "From the inverse of the normal equations: near ±1 two unknowns are hardly separable, and an error of one passes into the other." }, "Correlations of the unknowns"), svg("svg", {
		viewBox: `0 0 ${String(size)} ${String(size)}`,
		class: "correlations",
		role: "img",
		"aria-label": `Correlations: ${words.join(", ")}`
	}, ...heads, ...cells));
}
/** The area of the square stands for the magnitude. */
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
/** The standard error ellipse of by and bz, with the truth where it is known. */
function ellipsePicture(ellipse, deviation) {
	const { semi_major: major, semi_minor: minor, bearing_deg: angle } = ellipse;
	const reach = Math.max(2 * major, ...(deviation ?? []).map((d) => 1.15 * Math.abs(d)));
	const scale = PLOT / 2 / reach;
	const words = `Standard error ellipse of by and bz: ${significant(major)} by ${significant(minor)} mm, longer axis at ${fixed(angle, 0)} degrees from by`;
	const truth = deviation === null ? [] : [svg("path", {
		d: cross(-deviation[0] * scale, deviation[1] * scale),
		class: "truth"
	})];
	return h("figure", { testid: "ellipse" }, h("figcaption", { title: words }, `by, bz: ellipse ${significant(1e3 * major)} × ${significant(1e3 * minor)} µm; dashed: twice as large, 2 standard errors${deviation === null ? "" : "; cross: truth"}`), svg("svg", {
		viewBox: `${String(-75)} ${String(-75)} ${String(PLOT)} ${String(PLOT)}`,
		class: "ellipse",
		role: "img",
		"aria-label": words
	}, svg("path", {
		d: `M${String(-75)} 0h${String(PLOT)}M0 ${String(-75)}v${String(PLOT)}`,
		class: "axis"
	}), svg("ellipse", {
		rx: major * scale,
		ry: minor * scale,
		transform: `rotate(${String(-angle)})`,
		class: "outline"
	}), svg("ellipse", {
		rx: 2 * major * scale,
		ry: 2 * minor * scale,
		transform: `rotate(${String(-angle)})`,
		class: "outline faint"
	}), ...truth, svg("text", {
		x: 59,
		y: -5,
		class: "matrix-name"
	}, "by"), svg("text", {
		x: 12,
		y: -63,
		class: "matrix-name"
	}, "bz")));
}
function cross(x, y) {
	return `M${String(x - 5)} ${String(y - 5)}l10 10M${String(x + 5)} ${String(y - 5)}l-10 10`;
}
// www/pair/panel/orientation.ts
/** The relative orientation with its precision: the paper's Tables 2 and 3, and the correlations. */
var SIGMA_CAVEAT = "σ₀ is computed from y-parallaxes. It sees only the component of an error across the epipolar line, and cannot prove a match right: a wrong match along the line leaves it unchanged.";
function mountOrientation(host, store) {
	const body = h("div", {});
	const panel = section("Relative orientation", "orientation-section", body);
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
	], () => {
		const { state } = store;
		panel.classList.toggle("is-stale", isStale(state, "orientation"));
		fill(body, ...content$1(state));
	});
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
	}, "Not computed yet.")];
	return [
		...estimatedFocal(state),
		valueTable(state, result),
		...warnings(result),
		precision(state, result),
		h("p", {
			class: "caveat",
			testid: "sigma-caveat"
		}, SIGMA_CAVEAT),
		pictures(state, result)
	];
}
/** Says where the focal length is from, where no camera is known. */
function estimatedFocal(state) {
	const { match } = state.results;
	const focal = match?.value.geometry?.focal ?? null;
	if (!("missing" in pairCameras(state)) || focal === null || match?.value.estimated == null) return [];
	return [h("p", {
		class: "note",
		testid: "estimated-focal"
	}, page("estimated_focal", {
		focal_px: focal.focal_px,
		error_px: focal.standard_error_px
	}))];
}
/** Images are equal where nine tenths of the matches (stride 5) lie this near to the same place of both, px. */
var EQUAL_PX = .05;
function areEqual(matches) {
	let equal = 0;
	for (let i = 0; i < matches.length; i += 5) {
		const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = matches.subarray(i, i + 4);
		if (Math.abs(xr - xl) < EQUAL_PX && Math.abs(yr - yl) < EQUAL_PX) equal += 1;
	}
	return matches.length > 0 && equal > .9 * (matches.length / 5);
}
/** Why there is no orientation for what is wanted now; null where there is one, or one to come. */
function whyNotOriented(state) {
	const keys = wantedKeys(state);
	if (state.images.left === null || state.images.right === null) return "Two images are needed.";
	const match = isCurrent(state, "match") ? state.results.match?.value ?? null : null;
	if (match?.geometry?.degenerate === "pure-rotation") return areEqual(match.matches) ? "Not oriented: both images show the same at the same positions. Is it one photo twice?" : `Not oriented: ${message("no_orientation", { kind: "pure_rotation" })}.`;
	if (match?.no_geometry != null) return `Not oriented: ${message("no_geometry", match.no_geometry)}. Do both photos show the same ground?`;
	const cameras = pairCameras(state);
	if (state.results.openLeft !== void 0 && state.results.openRight !== void 0 && "missing" in cameras && keys.orientation === null) {
		if (cameras.missing.kind === "panorama") return `Not oriented: ${message("no_orientation", cameras.missing)}.`;
		const untold = match?.geometry == null ? "" : ", and the matches do not determine the focal length";
		return `Not oriented: ${message("no_orientation", cameras.missing)}${untold}. Give the focal length, and the pixel size or fiducial marks, under “Camera”.`;
	}
	for (const stage of [
		"interiorLeft",
		"interiorRight",
		"orientation"
	]) {
		const failure = state.failures[stage];
		if (failure !== void 0 && failure.key === keys[stage]) return `Not oriented. ${failure.message}`;
	}
	return null;
}
/** The true orientation at the scale of a result's base; null where it is not known. */
function truthFor(state, { base_mm: base }) {
	const truth = truthOf(state);
	return truth === null ? null : orientationAt(truth, base);
}
function valueTable(state, result) {
	const truth = truthFor(state, result);
	const paper = truth === null && hasPaperCamera(state) ? state.catalogue?.paper : void 0;
	const { standard_errors: errors, total_standard_errors: total, half_widths_95: half } = result;
	const number = (testid, value, digits, kind = "") => h("td", {
		testid,
		class: `number ${kind}`
	}, fixed(value, digits));
	const rows = UNKNOWNS.map(({ field, symbol, unit, digits }) => {
		const error = truth === null ? NaN : result[field] - truth[field];
		const own = [number(`orientation-${field}`, result[field], digits), number(`error-${field}`, errors?.[field], digits)];
		const withInterior = total === null ? [] : [number(`total-error-${field}`, total[field], digits)];
		const interval = number(`interval-${field}`, half?.[field], digits);
		const printed = paper === void 0 ? [] : [number(`paper-${field}`, paper.orientations[2].values[field], digits, "paper"), number(`paper-error-${field}`, paper.standard_errors[field], digits, "paper")];
		const compared = truth === null ? printed : [number(`deviation-${field}`, error, digits), number(`deviation-ratio-${field}`, error / ((total ?? errors)?.[field] ?? NaN), 1)];
		return row(h("span", {}, h("i", {}, symbol), h("span", { class: "unit" }, ` ${unit}`)), ...own, ...withInterior, interval, ...compared);
	});
	const heads = [
		["Value", "The right photo relative to the left one, dependent relative orientation."],
		["Std error", "What the scatter of the matches leaves uncertain."],
		...total === null ? [] : [["In total", "Standard error including what does not average out: neighbouring matches share errors because their windows overlap, and all share those of the measured fiducial marks."]],
		["95 % ±", "Half-width of the interval that holds the unknown in 95 of 100 cases: of the last standard error, by the distribution of Student for the degrees of freedom."],
		...paper !== void 0 ? [["Paper", "The paper's Table 3, of its own pair"], ["its error", "The paper's Table 2"]] : [],
		...truth === null ? [] : [["True error", "Value minus truth; by and bz at the scale of the base used."], ["in std errors", "The true error divided by the standard error, with that of the interior orientations where known: beyond 3 in 3 of 1,000 cases."]]
	];
	const note = paper !== void 0 ? h("p", { class: "note" }, paperNote(state, paper)) : null;
	return h("div", {}, h("div", { class: "scroll" }, h("table", {
		class: "tight",
		aria: { label: "Relative orientation" }
	}, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Unknown"), ...heads.map(([text, title]) => h("th", {
		scope: "col",
		title,
		class: text === "Paper" || text === "its error" ? "paper" : ""
	}, text)))), h("tbody", {}, ...rows))), note);
}
/** Whose pair it was, and with what it was photographed. */
function paperNote({ catalogue }, { pixel_mm: pixel }) {
	const flight = catalogue?.flights.find(({ name }) => name === "paper")?.flight;
	return page("paper", {
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
	const used = result.residuals_mm.length - result.rejected.length;
	const test = result.global_test;
	const printed = hasPaperCamera(state) ? state.catalogue?.paper : void 0;
	return facts([
		{
			name: "σ₀ of a photo coordinate",
			testid: "sigma0",
			value: sigma == null ? "–" : `${fixed(1e3 * sigma, 2)} µm${pixel === null ? "" : ` = ${fixed(sigma / pixel, 3)} px`}`,
			help: `Standard error of one photo coordinate of weight 1, from the residuals. ${SIGMA_CAVEAT}`
		},
		{
			name: "of a y-parallax (√2 σ₀)",
			testid: "sigma-parallax",
			value: sigma == null || pixel === null ? "–" : `${fixed(Math.SQRT2 * sigma / pixel, 3)} px`,
			help: "Standard error of the y-parallax of a match: the distance at which its two rays pass each other."
		},
		...test === null ? [] : [{
			name: "Global test",
			testid: "global-test",
			value: `${fixed(test.statistic, 1)}: ${test.passed ? "passed" : "FAILED"}`,
			...test.passed ? {} : { kind: "problem" },
			help: page("global_test", {
				lower: test.lower,
				upper: test.upper
			})
		}],
		{
			name: "Degrees of freedom",
			testid: "degrees-of-freedom",
			value: count(result.degrees_of_freedom),
			help: "Matches used minus the five unknowns."
		},
		{
			name: "Matches used",
			testid: "matches-used",
			value: `${count(used)} of ${count(result.residuals_mm.length)}`,
			help: "Data snooping rejected the others as gross errors, or their rays meet behind a camera."
		},
		{
			name: "Condition",
			testid: "condition",
			value: significant(result.condition),
			help: "Largest by smallest eigenvalue of the matrix of correlations: 1 where the unknowns are independent, some thousands for vertical photographs, far more where they are hardly separable."
		},
		{
			name: "Misfit to a plane",
			testid: "plane-misfit",
			value: result.plane_misfit === null ? "–" : `${significant(result.plane_misfit)} σ₀`,
			help: "How far the matches deviate from the best map of one plane onto another, in standard errors: about 1 over a plane, where a second orientation may fit as well; large over relief."
		},
		{
			name: "Parallax beside a rotation",
			testid: "rotation-parallax",
			value: pixel === null ? `${significant(result.parallax_beside_rotation_mm)} mm` : `${significant(result.parallax_beside_rotation_mm / pixel)} px`,
			help: "Median parallax that the best rotation of the right photo leaves: what of the difference of the photos only a base explains. Next to nothing where the camera only turned."
		},
		{
			name: "Spread",
			testid: "spread",
			value: `${fixed(result.spread, 3)} f`,
			help: "Root mean square distance of the points from their middle in the left photo, in principal distances. Small where they cover little of the photo."
		},
		{
			name: "Iterations, last step",
			testid: "iterations",
			value: `${String(result.iterations)}, ${significant(result.last_step)}`,
			help: "The last step relative to a millionth of the standard errors: below 1 the adjustment has converged."
		},
		{
			name: "Base b, principal distance",
			testid: "base",
			value: `${significant(result.base_mm)} mm, ${significant(result.focal_mm)} mm`,
			help: "The base component that was fixed gives by and bz their scale."
		},
		...printed !== void 0 ? [{
			name: "Paper",
			testid: "paper-sigma0",
			value: page("paper_sigma", {
				sigma0_mm: printed.sigma0_mm,
				sigma0_px: printed.sigma0_mm / printed.pixel_mm
			}),
			help: "What the paper printed for its own pair."
		}] : []
	]);
}
function pictures(state, result) {
	const truth = truthFor(state, result);
	const deviation = truth === null || Number.isNaN(truth.by_mm) ? null : [result.by_mm - truth.by_mm, result.bz_mm - truth.bz_mm];
	const ellipse = result.base_ellipse_mm;
	return h("div", { class: "precision-pictures" }, correlationPicture(result), ellipse === null ? null : ellipsePicture(ellipse, deviation));
}
// www/pair/panel/answer.ts
/** What came of a pair: its verdict, the figures that decided, and what to do next. */
/** The answer while nothing runs; `waiting`: something is about to. */
function resting(state, waiting, actions) {
	const { images } = state;
	const line = (kind, text, next = null) => ({
		kind,
		text,
		verdict: null,
		next
	});
	if (state.catalogue === null) return line("busy", "Loading the program …");
	if (images.left === null && images.right === null) return line("idle", "Ready. Open two overlapping images, or use the sample pair.");
	const missing = SIDES.find((side) => images[side] === null);
	if (missing !== void 0) return line("idle", `One image is open. Open the ${missing} one.`, {
		text: `Open the ${missing} image …`,
		act: () => actions.open(missing)
	});
	return waiting ? line("busy", "Waiting …") : answered(state, actions);
}
function answered(state, actions) {
	const milliseconds = Object.entries(state.results).reduce((sum, [stage, result]) => sum + (stage === "inspection" || stage === "line" ? 0 : result.milliseconds), 0);
	const matched = milliseconds === 0 ? `${summary(state)}.` : page("worked", {
		matched: summary(state),
		seconds: milliseconds / 1e3
	});
	const reason = whyNotOriented(state);
	const oriented = reason === null && isCurrent(state, "orientation") ? state.results.orientation?.value : void 0;
	const verdict = oriented?.verdict;
	const hint = state.settings === null ? null : pair_hint(verdict ?? {
		kind: "not_oriented",
		no_orientation: whyNone(state)
	}, state.settings);
	const more = `${matched}${hint === null ? "" : ` ${message("pair_hint", hint)}`}`;
	if (oriented === void 0 || verdict === void 0) {
		const next = hint === null ? nextWithout(state, actions) : {
			text: "Use “auto”",
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
		next: nextAfter(state, actions)
	};
	const next = verdict.kind === "weak" && asksForCamera(verdict.warning) ? {
		text: "Give the camera",
		act: actions.camera
	} : {
		text: "Show why",
		act: actions.why
	};
	return {
		...answer,
		kind: "partial",
		verdict: verdict.kind,
		next
	};
}
function figuresOf(state, result) {
	const used = result.residuals_mm.length - result.rejected.length;
	const interior = interiorInUse(state)?.left;
	const half = result.half_widths_95?.kappa_deg;
	return [
		{
			value: count(used),
			label: "points on both photos"
		},
		...interior === void 0 || result.sigma0_mm == null ? [] : [{
			value: `${fixed(result.sigma0_mm / pixelMm(interior), 2)} px`,
			label: "precision (σ₀)"
		}],
		...half == null ? [] : [{
			value: `${fixed(result.kappa_deg, 2)}° ± ${half < 99 ? half.toPrecision(2) : fixed(half, 0)}°`,
			label: "right photo turned"
		}]
	];
}
function figuresWithout(state) {
	const { match, left } = shownPair(state);
	if (match === null || left === null) return [];
	return [{
		value: count(match.counts.matches),
		label: "points on both photos"
	}, {
		value: count(left.length / 3),
		label: "points tried"
	}];
}
/** Warnings that another camera would answer. */
function asksForCamera({ kind }) {
	return kind === "unknown_camera" || kind === "focal_length" || kind === "wide_angle";
}
function nextWithout(state, actions) {
	const { kind } = whyNone(state);
	return kind === "no_camera" || kind === "no_focal_length" || kind === "no_pixel_size" ? {
		text: "Give the camera",
		act: actions.camera
	} : {
		text: "Show why",
		act: actions.why
	};
}
/** A sound result is saved; after a simulated one come photos of one's own. */
function nextAfter({ images }, { open, save }) {
	return SIDES.some((side) => images[side]?.source.kind === "grey") ? {
		text: "Open your photos …",
		act: () => open(null)
	} : {
		text: "Save the project",
		act: save
	};
}
// www/pair/panel/status.ts
/** What the answer says while nothing is answered yet: what runs, how far it is, what went wrong, and what to do. */
/** A run shorter than this shows no bar: it would only flicker. */
var PATIENCE_MS$1 = 250;
function mountStatus(store, actions) {
	const show = answerCard(byId("answer"), byId("status"), byId("answer-actions"), "");
	const bar = byId("progress");
	const cancel = byId("cancel");
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
		run.hidden = !(state.paused && state.images.left !== null) && currentFailure(state)?.ended !== true;
		show(answerOf(state, actions));
		document.body.classList.toggle("is-pending", anyStale(state));
		if (!busy) {
			window.clearTimeout(timer);
			timer = void 0;
			bar.classList.remove("is-on");
		} else timer ??= window.setTimeout(() => bar.classList.add("is-on"), PATIENCE_MS$1);
	});
}
function isBusy(state) {
	return Object.keys(state.running).length > 0 || state.notice?.kind === "busy";
}
function answerOf(state, actions) {
	const line = (kind, text) => ({
		kind,
		text,
		verdict: null
	});
	const failure = currentFailure(state);
	if (state.notice?.kind === "problem") return line("problem", state.notice.text);
	const { running, wanted, done } = progress(state);
	if (running.length > 0) return line("busy", page("step", {
		step: Math.min(done + 1, wanted),
		steps: wanted,
		stages: running.map((stage) => STAGES[stage].label).join("; ")
	}));
	if (state.notice?.kind === "busy") return line("busy", state.notice.text);
	if (state.paused) return line("idle", "Cancelled. Results on the screen are kept. Press Run, or change a setting, to go on.");
	if (failure !== null && !isOrientation(failure)) return line("problem", `${failure.message} ${matchedAllTheSame(state, failure.stage)}`.trimEnd());
	const [refused] = Object.values(state.refused);
	if (refused !== void 0) return line("problem", refusedText(refused));
	const answer = resting(state, done < wanted, actions);
	if (state.notice === null) return answer;
	if (answer.verdict === null) return line("idle", state.notice.text);
	return {
		...answer,
		more: `${answer.more ?? ""} ${state.notice.text}`.trimStart()
	};
}
/** Matches that determine no orientation are a result all the same. */
function isOrientation({ stage, ended }) {
	return !ended && stage === "orientation";
}
/** Without an interior orientation there are matches, but no more. */
function matchedAllTheSame(state, failed) {
	const matches = summary(state);
	return (failed === "interiorLeft" || failed === "interiorRight") && matches !== "" ? `Not oriented: ${matches}.` : "";
}
// www/pair/panel/header.ts
/** The bar of the page as the pair uses it: what opens, exchanges and exports its images. */
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
		else files.take(given, wanted.side);
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
function mountHeader({ store, engine, view, files, pick, attempt, sampleBlock }) {
	const on = (id, action) => {
		byId(id).addEventListener("click", () => void attempt(action));
	};
	for (const id of ["open", "open-first"]) on(id, () => pick(null));
	for (const id of ["sample", "sample-first"]) on(id, () => files.takeSample());
	on("sample-block-first", sampleBlock);
	mountMenu(byId("export-menu"), byId("exports"));
	on("swap", () => swap(store, engine));
	on("export-csv", () => exportMatches(store.state, engine));
	on("export-json", () => exportEverything(store.state));
	on("export-project", () => exportProject(store, engine));
	on("export-report", () => exportReport(store, engine));
	on("export-png", () => exportPicture(store.state, view));
	store.watch([
		"images",
		"results",
		"catalogue",
		"notice",
		"running"
	], ([images, , catalogue]) => {
		const both = images.left !== null && images.right !== null;
		const none = images.left === null && images.right === null;
		const set = (id, disabled) => {
			byId(id).disabled = disabled;
		};
		set("swap", none);
		set("sample", catalogue === null);
		set("sample-first", catalogue === null);
		set("sample-block-first", catalogue === null);
		set("export-csv", !both || shownPair(store.state).match === null);
		set("export-json", !both || store.state.results.pointsLeft === void 0);
		set("export-project", !both || isBusy(store.state) || !isCurrent(store.state, "match"));
		const absent = Object.values(images).some((image) => image?.source.kind === "project");
		set("export-report", !both || absent || isBusy(store.state));
		set("export-png", none);
		leaveWelcome(!none);
	});
}
/** What is known of the truth says where left pixels are seen in the right image: it holds in the simulated order alone. */
function swap(store, engine) {
	const known = truthOf(store.state) !== null;
	engine.swap();
	if (known) store.dispatch({
		type: "notice",
		notice: {
			kind: "info",
			text: "The truth of the simulated pair holds in its own order only: swap again to compare."
		}
	});
}
/** Hides the welcome; the keyboard goes on to the images where it was in there, or on the button that gave them. */
function leaveWelcome(left) {
	const welcome = byId("welcome");
	const { activeElement } = document;
	const focused = welcome.contains(activeElement) || !welcome.hidden && [
		byId("open"),
		byId("sample"),
		byId("menu")
	].some((press) => press === activeElement);
	welcome.hidden = left;
	if (left && focused) byId("view").focus();
}
// www/pair/state/histogram.ts
/** A quantile of sorted values; NaN of none. */
function quantile(sorted, q) {
	return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? NaN;
}
/** One value of each row of a flat array. */
function columnOf(values, stride, at) {
	const column = new Float64Array(Math.floor(values.length / stride));
	for (let i = 0; i < column.length; i++) column[i] = values[i * stride + at] ?? NaN;
	return column;
}
/** The finite values in ascending order. */
function sortedFinite(values) {
	const sorted = values.slice().sort();
	let end = sorted.length;
	while (end > 0 && !((sorted[end - 1] ?? NaN) < Infinity)) end -= 1;
	let start = 0;
	while (start < end && sorted[start] === -Infinity) start += 1;
	return sorted.subarray(start, end);
}
/**
* The histogram of the finite values in `bins` bins. The range is that of the values from the 0.5 % to the 99.5 % quantile, so that
* a few extreme ones do not squeeze the rest into one bin; `symmetric` centres it on 0, `from` fixes its lower end.
*/
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
/** Histograms: the measure of the matches, what the adjustment left, the interest value. */
var BINS = 40;
var WIDTH = 320;
var HEIGHT = 84;
var measures = remember((matches) => {
	return histogram(columnOf(matches, 5, 4).filter((measure) => measure !== -1), BINS, { from: 0 });
});
var residuals = remember((values) => histogram(values, BINS, { symmetric: true }));
var interestLeft = remember((points) => histogram(columnOf(points, 3, 2), BINS));
var interestRight = remember((points) => histogram(columnOf(points, 3, 2), BINS));
function mountHistograms(host, store) {
	const body = h("div", { class: "histograms" });
	const panel = section("Histograms", "histograms-section", body);
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
	], () => {
		panel.classList.toggle("is-stale", isStale(store.state, "match"));
		round += 1;
		update(body, store, () => round, round);
	});
}
/** Draws the charts one after the other, each in its own task: with many points each takes some ms, and input comes between. */
async function update(body, store, round, own) {
	const charts = [];
	for (const make of CHARTS) {
		await new Promise((resolve) => window.setTimeout(resolve, 0));
		if (round() !== own) return;
		const made = make(store.state);
		if (made !== null) charts.push(made);
	}
	fill(body, ...charts.length > 0 ? charts : [h("p", { class: "note" }, "No points yet.")]);
}
var CHARTS = [
	(state) => {
		const { match } = shownPair(state);
		return match === null || match.counts.matches === 0 ? null : chart("Measure of the matches", "", measures(match.matches), "histogram-measure");
	},
	(state) => {
		const { orientation } = shownPair(state);
		const interior = interiorInUse(state)?.left;
		if (orientation === null || interior === void 0) return null;
		return markStale(chart("y-parallax residuals of the matches used", "px", residuals(parallaxResiduals(orientation, interior)), "histogram-residuals"), isStale(state, "orientation") && !isStale(state, "match"));
	},
	(state) => {
		const { left } = shownPair(state);
		return left === null || left.length === 0 ? null : chart("Interest value, left", "", interestLeft(left), "histogram-interest-left");
	},
	(state) => {
		const { right } = shownPair(state);
		return right === null || right.length === 0 ? null : chart("Interest value, right", "", interestRight(right), "histogram-interest-right");
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
	const suffix = unit === "" ? "" : ` ${unit}`;
	const words = `${title}: ${count(data.total)} values, median ${significant(data.median)}${suffix}, shown from ${significant(data.low)} to ${significant(data.high)}${suffix}, at most ${count(most)} in a bar`;
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
	return h("figure", { testid }, h("figcaption", {}, title, h("span", { class: "unit" }, `${suffix} · n = ${count(data.total)}`)), picture, h("div", { class: "scale" }, h("span", {}, significant(data.low)), h("span", {}, `median ${significant(data.median)}`), h("span", {}, significant(data.high))));
}
// www/pair/panel/panes.ts
function mountPanes(view, store, actions) {
	const labels = {
		left: label("left", actions),
		right: label("right", actions)
	};
	view.host.append(labels.left.element, labels.right.element);
	const place = () => {
		const panes = panesOf(view.host.clientWidth, view.host.clientHeight);
		for (const side of SIDES) {
			const { style } = labels[side].element;
			const { left, top, width, height } = panes[side];
			Object.assign(style, {
				left: `${String(left)}px`,
				top: `${String(top)}px`,
				width: `${String(width)}px`,
				height: `${String(height)}px`
			});
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
	const replace = button("Replace …", `replace-${side}`, () => actions.open(side));
	replace.setAttribute("aria-label", `Replace the ${side} image`);
	const empty = button(`Open the ${side} image …`, `open-${side}`, () => actions.open(side));
	empty.className = "invitation";
	const mask = button("Mask …", `mask-${side}`, () => actions.mask(side), "An image of the same size: no points are detected where it is 0 (black)");
	const unmask = button("× mask", `unmask-${side}`, () => actions.unmask(side));
	unmask.setAttribute("aria-label", `Remove the mask of the ${side} image`);
	const head = h("div", { class: "pane-head" }, name, replace, mask, unmask);
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
		unmask.title = given === null ? "" : `Remove ${given.name}`;
		empty.hidden = image !== null;
		const size = opened === void 0 || image === null ? "" : ` · ${count(opened.value.info.width)} × ${count(opened.value.info.height)} px`;
		name.title = image === null ? "" : `${image.name}${size}`;
		fill(name, h("span", {}, image?.name ?? ""), h("span", {}, size));
	};
	return {
		element,
		show
	};
}
// www/pair/state/statistics.ts
/** Values a match has in `RelativeOrientation.points`. */
var POINT_STRIDE = 9;
var POSITION = [{
	key: "x",
	label: "x",
	unit: "px",
	digits: 1,
	help: "Column of the left point; the top-left pixel’s centre is at 0.5."
}, {
	key: "y",
	label: "y",
	unit: "px",
	digits: 1,
	help: "Row of the left point."
}];
var MEASURE = {
	key: "measure",
	label: "measure",
	unit: "",
	digits: 4,
	help: "Dissimilarity of the points: by the moments of their windows, 1 minus the correlation coefficient, or the distance of their descriptors. Small is good."
};
var FIT = {
	key: "standard_error",
	label: "s(x, y)",
	unit: "px",
	digits: 3,
	help: "Standard error of the right position from least squares matching, in its worse direction."
};
/** In the order of a row of `RelativeOrientation.points`; lengths in mm are given in px where that is easier to read. */
var ADJUSTED = [
	{
		key: "v",
		label: "y-parallax",
		unit: "px",
		digits: 3,
		inPixels: true,
		help: "Residual y-parallax: the distance at which the two rays pass each other, at photo scale."
	},
	{
		key: "r",
		label: "r",
		unit: "",
		digits: 3,
		help: "Redundancy number: the share of an error of this match that shows in its residual. Near 0 the other matches do not check it."
	},
	{
		key: "w",
		label: "w",
		unit: "",
		digits: 2,
		help: "w-statistic: standardised residual. Data snooping rejects above the limit that α₀ sets (3.29 for 0.001)."
	},
	{
		key: "detectable",
		label: "∇",
		unit: "px",
		digits: 3,
		inPixels: true,
		help: "Minimal detectable bias (MDB) across the epipolar line: an error of this size is detected with the probability β₀."
	},
	{
		key: "influence",
		label: "δ",
		unit: "",
		digits: 2,
		help: "External reliability: the largest effect of an undetected error of that size on an unknown, in its standard errors."
	},
	{
		key: "weight",
		label: "weight",
		unit: "",
		digits: 2,
		help: "Weight in the adjustment; 0 where rejected."
	},
	{
		key: "model_x",
		label: "X",
		unit: "mm",
		digits: 2,
		help: "Model coordinate at photo scale, along the base."
	},
	{
		key: "model_y",
		label: "Y",
		unit: "mm",
		digits: 2,
		help: "Model coordinate at photo scale, across the base."
	},
	{
		key: "model_z",
		label: "Z",
		unit: "mm",
		digits: 2,
		help: "Model coordinate at photo scale, upwards; the photo lies at minus the principal distance."
	}
];
/** The larger semi-axis of the error ellipse of a fit, in px. */
function worstError(fits, match) {
	if (5 * match >= fits.length) return NaN;
	const [xx = NaN, xy = NaN, yy = NaN] = fits.subarray(5 * match + 1, 5 * match + 4);
	return Math.sqrt(.5 * (xx + yy) + Math.hypot(.5 * (xx - yy), xy));
}
/** The statistics of a pair's matches, then of those that were rejected by hand; those of the adjustment where there is one. */
var statisticsOf = remember((left, match, orientation, score, pixel) => {
	const used = match.matches.length / 5;
	const off = Uint32Array.from(match.rules, (_, left) => left).filter((left) => match.rules[left] === BY_HAND);
	const count = used + off.length;
	const lefts = Uint32Array.from({ length: count }, (_, i) => i < used ? match.indices[2 * i] ?? 0 : off[i - used] ?? 0);
	const at = (i, k) => (i < used ? match.matches[5 * i + k] : left?.[3 * (lefts[i] ?? 0) + k]) ?? NaN;
	const measure = (i) => {
		const own = (i < used ? match.matches[5 * i + 4] : match.measures[2 * (lefts[i] ?? 0)]) ?? NaN;
		return own === -1 || !Number.isFinite(own) ? NaN : own;
	};
	const figure = (described, value) => ({
		...described,
		value,
		text: (i) => fixed(value(i), described.digits)
	});
	const columns = POSITION.map((column, k) => figure(column, (i) => at(i, k)));
	columns.push(figure(MEASURE, measure));
	if (!match.fits.every(Number.isNaN)) columns.push(figure(FIT, (i) => worstError(match.fits, i)));
	const codes = new Uint8Array(count).fill(BY_HAND);
	codes.set(matchCodes(match, orientation));
	if (orientation !== null) {
		const { points } = orientation;
		ADJUSTED.forEach(({ inPixels = false, ...column }, k) => {
			const scale = inPixels ? pixel ?? NaN : 1;
			columns.push(figure(column, (i) => (points[POINT_STRIDE * i + k] ?? NaN) / scale));
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
/** Whether a filter keeps a match. */
function isKept({ codes, rightness }, filter, match) {
	switch (filter) {
		case "all": return true;
		case "used": return codes[match] === MATCHED || codes[match] === MANUAL;
		case "rejected": return codes[match] === GROSS_ERROR;
		case "by-hand": return codes[match] === BY_HAND || codes[match] === MANUAL;
		case "wrong": return rightness?.[match] === 0;
	}
}
// www/pair/panel/feature.ts
/** Gradient descriptors as pictures: the patch around a point, and a star of eight directions in each of its 4 x 4 cells. */
/** Canvas px of a sample. */
var PIXEL = 3;
var SIZE = 112 * PIXEL;
var STAR = "#ffd400";
var GRID = "rgb(255 212 0 / 0.55)";
/** Both points: as they lie in their images with the grid of their descriptors, then turned and scaled to their frames. */
function featurePictures({ features }) {
	if (features === null) return [];
	const both = (name, testid, picture, text) => {
		const one = (side, label) => {
			const feature = features[side];
			if (feature === null) return h("figure", {}, h("p", { class: "note" }, "No point."), h("figcaption", {}, label));
			const canvas = picture(feature);
			canvas.setAttribute("aria-label", `${label} point, ${name}`);
			return h("figure", {}, canvas, h("figcaption", {}, `${label}${text(feature)}`));
		};
		return [h("h4", {}, name), h("div", {
			class: "windows",
			testid
		}, one("left", "Left"), one("right", "Right"))];
	};
	return [...both("Turned and scaled to the point, contrast stretched", "point-patches", turnedPicture, () => ""), ...both("Descriptor, as it lies in the image", "point-descriptors", uprightPicture, ({ scale, direction, reach }) => ` · scale ${fixed(scale, 1)} px, direction ${fixed(direction * 180 / Math.PI, 0)}°, ${fixed(reach, 0)} px wide`)];
}
/** Grey values from black to white: what is dull would show nothing. */
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
	stretched(grey).forEach((value, i) => {
		if (context === null) return;
		context.fillStyle = `rgb(${String(value)} ${String(value)} ${String(value)})`;
		context.fillRect(i % 112 * PIXEL, Math.floor(i / 112) * PIXEL, PIXEL, PIXEL);
	});
	return [canvas, context];
}
/** What the descriptor describes: of a right match it is the same in both images. */
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
/** The cells, and their first direction, which is that of the point. */
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
/** In each cell a ray a direction, as long as the descriptor's number; the longest of all reaches the cell's border. */
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
/** The pixels of the window about the pixel `col`, `row`, the ones outside a circular window darkened; the ring marks the centroid, the line the axis. */
function windowPicture(report, col, row, axis) {
	const { side } = report;
	const canvas = h("canvas", {
		class: "window",
		role: "img",
		aria: { label: `${String(side)} × ${String(side)} px window, enlarged` }
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
	], () => {
		const { state } = store;
		body.classList.toggle("is-stale", state.selection !== null && state.results.match !== void 0 && !isCurrent(state, "match"));
		const focused = body.contains(document.activeElement);
		fill(body, ...content(state, select));
		if (focused) host.focus({ preventScroll: true });
	});
}
function content(state, select) {
	const { selection } = state;
	const shown = shownPair(state);
	const points = selection === null ? null : shown[selection.side];
	if (selection === null || points === null || 3 * selection.index >= points.length) return [h("p", { class: "note" }, "Click a point in an image, or press N with the image in focus, to see what was compared, its candidates and the rule that decided.")];
	const at = points.subarray(3 * selection.index, 3 * selection.index + 3);
	const parts = [h("h3", {}, `${selection.side === "left" ? "Left" : "Right"} point ${count(selection.index + 1)}`), h("p", {
		class: "facts-line",
		testid: "point-position"
	}, `x ${fixed(at[0], 1)} px, y ${fixed(at[1], 1)} px, interest value ${significant(at[2] ?? 0)}`)];
	if (shown.match === null) return [...parts, h("p", { class: "note" }, "Not matched yet.")];
	parts.push(verdict(state, shown, shown.match));
	const inspection = state.results.inspection?.value;
	if (inspection === void 0 || !isCurrent(state, "inspection")) return [...parts, h("p", { class: "note" }, problemOr(state, "Loading the window and the candidates …"))];
	const byGrey = state.settings !== null && comparesGreyValues(state.settings);
	const compared = state.settings !== null && comparesGradients(state.settings) ? featurePictures(inspection) : [windows(inspection, !byGrey), ...byGrey ? [] : moments(inspection)];
	return [
		...parts,
		...compared,
		...lineNote(inspection, shown.match),
		...matchStatistics(state, shown, shown.match),
		...candidateTable(state, shown.match, inspection, select)
	];
}
/** What is drawn of the geometry in the other image. */
function lineNote({ line }, { geometry }) {
	if (line === null || geometry === null) return [];
	const text = "fundamental" in geometry.model ? `The dashed line in the ${line.side} image is the epipolar line of this point: its match lies on it, whatever the height.` : `The cross in the ${line.side} image is where the geometry has this point.`;
	return [h("p", {
		class: "note",
		testid: "point-line"
	}, line.positions.length === 0 ? `By the geometry of the two views this point lies outside the ${line.side} image.` : text)];
}
function problemOr(state, text) {
	return state.failures.inspection?.message ?? text;
}
function verdict(state, shown, match) {
	const { code, text } = verdictOf(state, shown, match);
	return h("p", {
		class: "verdict",
		testid: "point-verdict"
	}, swatch(code), h("span", {}, text));
}
function windows({ left, right }, axes) {
	const one = (name, window) => {
		const report = window?.report ?? null;
		return h("figure", {}, window === null || report === null ? h("p", { class: "note" }, window?.problem ?? "No point.") : windowPicture(report, window.col, window.row, axes), h("figcaption", {}, name, report === null || !axes ? "" : ` · axis ${fixed(report.axis_angle_deg, 1)}°`));
	};
	return h("div", {
		class: "windows",
		testid: "point-windows"
	}, one("Left window", left), one("Right window", right));
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
	const head = (text) => h("thead", {}, h("tr", {}, h("th", { scope: "col" }, text), h("th", { scope: "col" }, "Left"), h("th", { scope: "col" }, "Right")));
	return [h("div", { class: "moments" }, h("table", {
		testid: "point-moments",
		aria: { label: "Normalised central moments" }
	}, head("Moment"), h("tbody", {}, ...MOMENTS.map(([field, name]) => row(name, value(left?.report?.normalized[field]), value(right?.report?.normalized[field]))))), h("table", {
		testid: "point-invariants",
		aria: { label: "Invariants" }
	}, head("Invariant"), h("tbody", {}, ...MOMENTS.map((_, i) => row(`I${"₀₁₂₃₄₅₆".charAt(i)}`, value(left?.report?.invariants[i]), value(right?.report?.invariants[i]))))))];
}
/** The figures of the point's match, each with what it is. */
function matchStatistics(state, shown, match) {
	const index = matchOfLeft(match)[leftIndexOf(state, match.best, match.rules)] ?? -1;
	if (index < 0) return [];
	const interior = interiorInUse(state)?.left;
	const { columns } = statisticsOf(shown.left, match, shown.orientation, state.results.score?.value ?? null, interior === void 0 ? null : pixelMm(interior));
	const right = match.matches.subarray(5 * index + 2, 5 * index + 4);
	const list = [{
		name: "Right position",
		testid: "match-right",
		value: `${fixed(right[0], 2)}, ${fixed(right[1], 2)} px`,
		help: "Where the match lies in the right image."
	}, ...columns.filter(({ key }) => key !== "x" && key !== "y").map(({ key, label, unit, digits, help, value }) => ({
		name: label,
		testid: `match-${key}`,
		value: `${fixed(value(index), digits)}${unit === "" ? "" : ` ${unit}`}`,
		help
	}))];
	return [h("h4", {}, `Match ${count(index + 1)}`), facts(list)];
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
			aria: { label: `Select right point ${String(index + 1)}` }
		}, count(index + 1));
		go.addEventListener("click", () => select("right", index));
		const cells = [points[3 * index], points[3 * index + 1]].map((v) => h("td", { class: "number" }, fixed(v, 1)));
		const [least = NaN, own = NaN] = [candidates[1], candidates[2 * i + 1]];
		return h("tr", { class: index === match.best[leftIndex] ? "best" : "" }, h("td", {}, String(i + 1)), h("td", {}, go), ...cells, h("td", { class: "number" }, fixed(own, 4)), h("td", { class: "number" }, i === 0 ? "" : fixed(least / own, 3)));
	});
	const heads = [
		"",
		"Right point",
		"x px",
		"y px",
		state.settings !== null && comparesGradients(state.settings) ? "Distance" : "Measure"
	].map((text) => h("th", { scope: "col" }, text));
	heads.push(h("th", {
		scope: "col",
		title: "The smallest measure divided by its own: that of the second decides whether the best is ambiguous."
	}, "Ratio"));
	const caption = `${count(total)} ${total === 1 ? "candidate" : "candidates"} of left point ${count(leftIndex + 1)}${total > MOST_ROWS ? `, the best ${String(MOST_ROWS)}` : ""}`;
	return [h("h4", {}, caption), h("div", { class: "scroll candidates" }, h("table", {
		testid: "point-candidates",
		aria: { label: caption }
	}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows)))];
}
// www/pair/panel/simulate.ts
/** A flight to simulate: presets, a control for each of its parameters, and a small picture of the pair that follows every change. */
/** Longest side of the preview's images, in px. */
var PREVIEW_SIDE = 240;
/** Quiet time after a change before the preview is rendered, in ms. */
var DEBOUNCE_MS = 120;
var PRESETS = {
	sample: "Sample: the built-in pair",
	paper: "Paper: its geometry and angles",
	hard: "Hard: high relief, blur, noise",
	lively: "Lively: river, traffic, grain, haze"
};
function mountSimulate(host, store, engine, render) {
	store.watch(["catalogue"], ([catalogue]) => {
		if (catalogue !== null) new SimulatePanel(host, store, engine, catalogue, render);
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
		const go = button("Render this pair", "render-flight", () => {
			const { flight } = store.state;
			if (flight !== null) render(this.preset.value, flight);
		});
		go.className = "primary";
		const another = button("Another town", "flight-reseed", () => {
			const { flight } = store.state;
			if (flight !== null) store.dispatch({
				type: "flight",
				flight: {
					...flight,
					seed: (flight.seed + 1) % 2 ** 32
				}
			});
		}, "The next seed");
		host.append(h("p", { class: "note" }, "A flight over a synthetic scene. The truth is known: matches and orientation are compared with it, and errors are shown beside standard errors."), h("div", { class: "control" }, h("label", { for: "flight-preset" }, "Preset"), this.preset), h("div", { class: "previews" }, ...this.pictures), this.problem, h("div", { class: "buttons" }, go, another), ...this.sections.elements);
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
	/** Renders the newest flight, one rendering at a time. */
	async preview() {
		const { flight } = this.store.state;
		if (this.rendering || flight === null || flight === this.shown || this.host.offsetParent === null) return;
		this.shown = flight;
		const problem = problemOfFlight(flight);
		this.say(problem);
		if (problem !== null) {
			this.sections.controls.find(({ parameter }) => problem.startsWith(`${parameter.key} is `))?.refuse(`${readable(this.catalogue, problem)}.`);
			return;
		}
		this.rendering = true;
		try {
			const { left, right } = await this.engine.client("preview").call("simulate", reduced(flight, this.catalogue));
			paint(this.pictures[0], left, "Preview of the left image");
			paint(this.pictures[1], right, "Preview of the right image");
		} catch (error) {
			if (error instanceof CallError) this.say(`no preview: ${error.message}`);
			else if (!(error instanceof Cancelled)) throw error;
		} finally {
			this.rendering = false;
		}
		if (this.store.state.flight !== flight) this.later();
	}
	say(problem) {
		this.problem.textContent = problem === null ? "" : `${readable(this.catalogue, problem)}.`;
	}
};
/** The same flight with coarser pixels: as coarse as the preview is small, within what the crate flies. */
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
/** The table of matches: each with its statistics, sorted by any of them, linked both ways to the images. */
var FILTERS = [
	["all", "all matches"],
	["used", "used"],
	["rejected", "gross errors"],
	["by-hand", "by hand"],
	["wrong", "wrong by the truth"]
];
/** What became of a match, in a word. */
var STATES = {
	[GROSS_ERROR]: "gross error",
	[BY_HAND]: "rejected by hand",
	[MANUAL]: "by hand"
};
var RIGHTNESS = [
	"wrong",
	"at an edge",
	"right"
];
function mountStatistics(host, store, editing, select) {
	const filter = h("select", {
		testid: "statistics-filter",
		aria: { label: "Matches to show" }
	});
	const caption = h("p", {
		class: "note",
		testid: "statistics-caption"
	});
	const sideways = h("p", {
		class: "note",
		hidden: true,
		testid: "statistics-sideways"
	}, "Scroll sideways for more columns →");
	const all = button("Choose all", "choose-listed", () => chooseListed(), "Choose the matches that the list shows, to reject or restore them");
	host.append(h("div", { class: "statistics-head" }, filter, caption, all), sideways);
	const table = new Table(host, {
		testid: "statistics",
		words: {
			table: "Matches with their statistics",
			region: "Table of matches"
		},
		choose: (match) => {
			const left = statistics?.lefts[match];
			editing.chooseNone();
			if (left !== void 0) select("left", left);
		},
		chooseMore: (rows) => editing.chooseLefts(leftsOf(rows)),
		isChosen: (match) => chosen.has(statistics?.lefts[match] ?? -1),
		chooseLabel: (match) => `Select match ${String(match + 1)}`
	});
	new ResizeObserver(() => {
		sideways.hidden = table.scroller.scrollWidth <= table.scroller.clientWidth;
	}).observe(table.head);
	let chosen = /* @__PURE__ */ new Set();
	let statistics = null;
	let columns = [];
	const leftsOf = (rows) => rows.flatMap((row) => statistics?.lefts[row] ?? []);
	const chooseListed = () => {
		editing.chooseNone();
		editing.chooseLefts(leftsOf(table.listed));
	};
	const show = () => {
		const shown = table.show(statistics?.count ?? 0, columns, (match) => statistics !== null && isKept(statistics, filter.value, match));
		all.disabled = shown === 0;
		fill(caption, statistics === null ? "No matches yet." : `${count(shown)} of ${count(statistics.count)} matches`);
	};
	filter.addEventListener("change", show);
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
	], () => {
		const { state } = store;
		table.scroller.classList.toggle("is-stale", isStale(state, "match") || shownPair(state).orientation !== null && isStale(state, "orientation"));
		const now = statisticsOfState(state);
		if (now === statistics && filter.options.length > 0) return;
		statistics = now;
		columns = now === null ? [] : columnsOf(now);
		const { value } = filter;
		const offered = FILTERS.filter(([kind]) => kind !== "wrong" || now?.rightness != null);
		fill(filter, ...offered.map(([kind, text]) => new Option(text, kind, false, kind === value)));
		show();
	});
	store.watch(["selection", "results"], () => table.mark(selectedMatch(store.state, statistics)));
	store.watch([
		"chosen",
		"history",
		"results"
	], () => {
		const lefts = chosenLefts(store.state);
		if (lefts.length === 0 && chosen.size === 0) return;
		chosen = new Set(lefts);
		table.redraw();
	});
}
function columnsOf({ columns, codes, rightness }) {
	const word = (key, help, text) => ({
		key,
		label: key,
		unit: "",
		help,
		value: text,
		text
	});
	return [
		{
			key: "",
			label: "Match",
			unit: "",
			help: "Number of the match, in the order of its left points.",
			value: (match) => match,
			text: (match) => count(match + 1)
		},
		...columns,
		word("state", "Whether the adjustment used the match, and what was done to it by hand.", (match) => STATES[codes[match] ?? 0] ?? "used"),
		...rightness === null ? [] : [word("truth", "Whether the match is right: within 1.5 px of where the surface is seen, there or at a neighbouring pixel.", (match) => RIGHTNESS[rightness[match] ?? 0] ?? "")]
	];
}
function statisticsOfState(state) {
	const { left, match, orientation, edited } = shownPair(state);
	if (match === null || edited?.found.counts.matches === 0) return null;
	const interior = interiorInUse(state)?.left;
	return statisticsOf(left, match, orientation, state.results.score?.value ?? null, interior === void 0 ? null : pixelMm(interior));
}
/** The match of the selected point; -1 where it has none. */
function selectedMatch(state, statistics) {
	const { match } = shownPair(state);
	if (match === null || statistics === null || state.selection === null) return -1;
	return statistics.lefts.indexOf(leftIndexOf(state, match.best, match.rules));
}
// www/pair/view/frames.ts
/** Scales and directions of points: a circle of twice the scale, a tick in the direction; only where they are few enough to be read. */
/** Radius of the circle in scales. */
var SCALES = 2;
/** Least radius in CSS px at which a circle is drawn, and how many are: where more are in sight, zooming in shows them. */
var LEAST_RADIUS = 6;
var MOST_DRAWN = 250;
/** CSS px of an image px from which on frames of matches are drawn, where these alone are shown. */
var LEAST_SCALE = 1;
/** Whether the directions of the frames were sought. */
function haveDirections(settings) {
	return settings !== null && comparesGradients(settings) && !settings.gradient.upright;
}
/** Draws the frames of the shown points that `clip` shows. */
function drawFrames(context, state, pane, transform, clip) {
	const { points, frames, codes } = pane;
	if (points === null || frames === null || frames.length === 0 || state.display.points === "none") return;
	if (state.display.points === "matched" && transform.scale < LEAST_SCALE) return;
	const ticks = haveDirections(state.settings);
	const paths = /* @__PURE__ */ new Map();
	let drawn = 0;
	codes.forEach((code, i) => {
		const radius = SCALES * (frames[2 * i] ?? 0) * transform.scale;
		if (drawn > MOST_DRAWN || radius < LEAST_RADIUS || !isCodeShown(state.display, code)) return;
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
/** Draws what the gradient descriptor of a point describes: its cells' outline, turned and scaled, with the direction. */
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
/** Half the size of a mark in CSS px: small in the overview, larger when pixels are enlarged. */
function halfSize(scale) {
	return Math.min(7, Math.max(1.5, 2.6 * scale));
}
/** The styles in drawing order, refused points smaller than matches. */
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
/** For each point the place of its style in the drawing order; kept until codes or layers change, as a drag draws many times. */
var slotsOf = {
	left: makeSlots(),
	right: makeSlots()
};
var slotsOfPlaces = makeSlots();
/** Draws the points of one image where `clip` shows them, and the matched places that are no points. */
function drawPoints(context, state, scene, pane, transform, clip) {
	const { points, hidden } = state.display;
	if (pane.points === null || points === "none") return;
	const { styles, colours } = stylesAt(transform.scale);
	const view = drawView(transform, clip);
	draw_points(context, pane.points, slotsOf[pane.side](pane.codes, points, hidden), styles, colours, view);
	drawFrames(context, state, pane, transform, clip);
	if (pane.side === "right") draw_points(context, scene.places.points, slotsOfPlaces(scene.places.codes, points, hidden), styles, colours, view);
}
function drawLines(context, state, scene) {
	const { lines } = state.display;
	if (scene.match === null || lines === "none") return;
	const { left, right } = scene.panes;
	const rejected = isCodeShown({
		...state.display,
		points: state.display.points === "none" ? "matched" : state.display.points
	}, GROSS_ERROR) ? 1 : NOT_DRAWN;
	const codes = scene.matchCodes.map((code) => code === GROSS_ERROR ? rejected : 0);
	draw_match_lines(context, scene.match.matches, codes, Float64Array.of(1, 1), [LINE, LINE_REJECTED], drawView(left.transform, left.rect), drawView(right.transform, right.rect), lines === "all" ? ALL : 100);
}
function drawResiduals(context, state, scene, pane) {
	if (pane.vectors === null || state.display.vectors === 0) return;
	const codes = scene.matchCodes.map((code) => code === GROSS_ERROR ? 1 : 0);
	draw_vectors(context, pane.vectors, codes, Float64Array.of(1.4, 1.4), ["#f0e442", "#ff7a1a"], state.display.vectors, drawView(pane.transform, pane.rect));
}
/** Draws all layers of marks over both panes. */
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
function mountToolbar(host, store, navigator) {
	const set = (display) => store.dispatch({
		type: "display",
		display
	});
	const shows = (points) => set({
		points,
		hidden: []
	});
	const points = toggle("Points", "layer-points", "Show the matched points", (on) => shows(on ? "matched" : "none"));
	const unmatched = toggle("Unmatched", "layer-unmatched", "Show rejected points too, marked by the rule that rejected them: press one to see why", (on) => shows(on ? "all" : "matched"));
	const [lines, lineSelect] = choice("Lines", "layer-lines", [
		["none", "none"],
		["some", `≤ ${String(100)}`],
		["all", "all"]
	], (value) => set({ lines: value }));
	const [vectors, vectorSelect] = choice("Residuals", "layer-vectors", VECTOR_FACTORS.map((f) => [String(f), f === 0 ? "none" : `× ${String(f)}`]), (value) => set({ vectors: Number(value) }));
	const linked = toggle("Linked", "linked", "Pan and zoom both images together (L)", (on) => set({ linked: on }));
	const magnifier = toggle("Magnifier", "magnifier", "Enlarge what is under the pointer (M)", (on) => set({ magnifier: on }));
	const more = h("div", {
		class: "more",
		id: "view-more"
	}, lines, vectors, h("span", { class: "divider" }), linked, magnifier, labelled("1:1", "zoom-actual", "One image pixel to one screen pixel (1)", () => navigator.actualSize()), h("span", { class: "divider" }), labelled("‹", "previous-point", "Previous point (P)", () => navigator.step(-1)), labelled("›", "next-point", "Next point (N)", () => navigator.step(1)));
	const unfold = h("button", {
		type: "button",
		class: "menu-button",
		testid: "view-menu"
	}, "View ▾");
	mountMenu(unfold, more);
	host.append(points, unmatched, h("span", { class: "divider" }), ...zoomButtons("", "Whole images", () => navigator), unfold, more);
	store.watch(["results"], () => {
		const { left, match } = shownPair(store.state);
		const others = match === null || left === null ? 0 : left.length / 3 - match.counts.matches;
		fill(unmatched, "Unmatched", others === 0 ? null : h("span", { class: "number-of" }, ` (${count(others)})`));
	});
	store.watch(["display"], ([display]) => {
		points.setAttribute("aria-pressed", String(display.points !== "none"));
		unmatched.setAttribute("aria-pressed", String(display.points === "all"));
		lineSelect.value = display.lines;
		vectorSelect.value = String(display.vectors);
		linked.setAttribute("aria-pressed", String(display.linked));
		magnifier.setAttribute("aria-pressed", String(display.magnifier));
	});
}
// www/pair/state/editing.ts
/** What a user does to matches, whatever was pressed for it. */
var Editing = class {
	store;
	fitter;
	constructor(store, fitter) {
		this.store = store;
		this.fitter = fitter;
	}
	/** Rejects or restores what is chosen; nothing where there is nothing of it. */
	edit(kind) {
		const edit = editOfChoice(this.store.state, kind);
		if (edit !== null) this.store.dispatch({
			type: "edit",
			edit
		});
	}
	/** Takes edits back, or makes them again. */
	step(by) {
		this.store.dispatch({
			type: "goto",
			done: this.store.state.history.done + by
		});
	}
	/** Chooses the match of a point beside others, or no longer. */
	choose(selection) {
		const { state } = this.store;
		const edited = editedPair(state);
		if (edited === null || selection === null) return;
		const left = leftIndexOf({ selection }, edited.match.best, edited.match.rules);
		this.chooseAll(keysOfLefts(edited, left < 0 ? [] : [left]));
	}
	/** Chooses matches of left points beside others, or no longer where all of them were. */
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
	/** Takes up a tool, or puts it away where it is in use. Without matches there is nothing to be done with any. */
	toggle(tool) {
		const { state } = this.store;
		const next = state.tool === tool || editedPair(state) === null ? "look" : tool;
		if (next !== state.tool) this.store.dispatch({
			type: "tool",
			tool: next
		});
	}
	/** Measures the match of the selected point anew. */
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
	/** Places a point of the match that is measured; the first one begins it. */
	place(side, at) {
		const { state } = this.store;
		const { draft } = state;
		this.store.dispatch({
			type: "draft",
			draft: draft === null ? begun(state, side, at) : placed(state, draft, side, at)
		});
	}
	/** Moves the point that is placed now. */
	nudge(dx, dy) {
		const { draft } = this.store.state;
		const at = draft === null ? null : placeOfDraft(this.store.state, draft.side);
		if (draft !== null && at !== null) this.place(draft.side, [at[0] + dx, at[1] + dy]);
	}
	/** Goes on in the other image. */
	exchange() {
		const { state } = this.store;
		const { draft } = state;
		if (draft === null) return;
		const at = placeOfDraft(state, draft.side);
		const settled = at === null ? draft : placed(state, draft, draft.side, at);
		this.store.dispatch({
			type: "draft",
			draft: {
				...settled,
				side: otherSide(draft.side)
			}
		});
	}
	/** Finds the right place by least squares, near where it is. */
	async fit() {
		const { state } = this.store;
		const { draft } = state;
		const [left, right] = [placeOfDraft(state, "left"), placeOfDraft(state, "right")];
		if (draft === null || left === null || right === null) return;
		const found = await this.fitter(left, right);
		if (this.store.state.draft !== draft) return;
		if (found !== null) this.store.dispatch({
			type: "draft",
			draft: placed(state, placed(state, draft, "left", left), "right", found)
		});
		this.store.dispatch({
			type: "notice",
			notice: found === null ? {
				kind: "info",
				text: "Least squares matching confirms no place near this one: the windows differ too much, or are turned to each other."
			} : null
		});
	}
	/** The match is measured: it becomes an edit, and is selected. */
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
	/** Ends what was begun last: the match that is measured, the tool, the choice; false where nothing was. */
	leave() {
		const { tool, chosen, draft } = this.store.state;
		if (draft !== null && draft.of === null) this.store.dispatch({
			type: "draft",
			draft: null
		});
		else if (tool !== "look") this.store.dispatch({
			type: "tool",
			tool: "look"
		});
		else if (chosen.length > 0) this.chooseNone();
		else return false;
		return true;
	}
	chooseAll(keys) {
		if (keys.length > 0) this.store.dispatch({
			type: "choose",
			chosen: toggled(this.store.state.chosen, keys)
		});
	}
};
// www/pair/state/reducer.ts
var NO_DATA = {
	fiducials: [],
	origin: null
};
/** What a user does; what was said of an earlier deed is then over. Looking at points or moving the view is none of it. */
var DEEDS = /* @__PURE__ */ new Set([
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
	"mask",
	"fiducialModel",
	"offset",
	"display",
	"resume",
	"edit",
	"goto"
]);
function reduce(state, action) {
	const next = withShown(state, changed(state, action));
	return DEEDS.has(action.type) && next.notice !== null && next.notice.kind !== "busy" ? {
		...next,
		notice: null
	} : next;
}
/** Fields show new values in place of what they held. */
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
		case "images": return withImages(state, action.images);
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
		case "photo": return {
			...state,
			photos: {
				...state.photos,
				[action.side]: {
					...state.photos[action.side],
					...action.photo
				}
			},
			paused: false
		};
		case "mask": return {
			...state,
			masks: {
				...state.masks,
				[action.side]: action.mask
			},
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
		case "tool": return {
			...state,
			tool: action.tool,
			draft: null
		};
		case "draft": return {
			...state,
			draft: action.draft
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
/** What the engine reports. */
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
/** After a new run of the matching the user is told what of the edits by hand it has. */
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
/** The state with other edits. What they do to the orientation is compared with the one before them. */
function withHistory(state, history) {
	if (history.done === state.history.done && history.edits === state.history.edits) return state;
	const before = isCurrent(state, "orientation") ? state.results.orientation?.value ?? null : state.before;
	return {
		...state,
		history,
		before,
		paused: false
	};
}
/** New images. Data that belonged to a simulated pair goes with it; data the user gave stays. */
function withImages(state, images) {
	const before = state.truth === null ? state : withoutTruth(state);
	const all = {
		...before.images,
		...images
	};
	return {
		...before,
		images: all,
		masks: {
			left: images.left === void 0 ? before.masks.left : null,
			right: images.right === void 0 ? before.masks.right : null
		},
		selection: null,
		paused: false,
		failures: {},
		views: {
			left: null,
			right: null
		},
		...UNEDITED,
		...exchangedPair(state, all)
	};
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
/** Left becomes right: images, their data, and the results that belong to one image alone. */
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
		offset: state.offset === null ? null : [-state.offset[0], -state.offset[1]],
		views: {
			left: state.views.right,
			right: state.views.left
		},
		...UNEDITED,
		history: exchanged(state.history),
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
/** Holds the state of the pair. */
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
/** The scene on a canvas of `width` x `height` CSS px. A pane without a view shows its whole image. */
function sceneOf(state, width, height) {
	const rects = panesOf(width, height);
	const shown = shownPair(state);
	const codes = {
		left: leftCodes(shown.left, shown.match, shown.orientation),
		right: rightCodes(shown.right, shown.match, shown.orientation)
	};
	const pane = (side) => {
		const picture = pictureOf(state, side);
		const view = state.views[side] ?? (picture === null ? {
			x: 0,
			y: 0,
			scale: 1
		} : fitView(rects[side], picture.width, picture.height));
		const interior = interiorInUse(state)?.[side];
		const vectors = shown.match !== null && shown.orientation !== null && interior !== void 0 ? residualVectors[side](shown.match, shown.orientation, interior) : null;
		return {
			side,
			rect: rects[side],
			transform: transformOf(rects[side], view),
			picture,
			points: picture === null ? null : shown[side],
			frames: state.results[side === "left" ? "pointsLeft" : "pointsRight"]?.value.frames ?? null,
			codes: codes[side],
			vectors
		};
	};
	const ofMatches = matchCodes(shown.match, shown.orientation);
	return {
		panes: {
			left: pane("left"),
			right: pane("right")
		},
		match: shown.match,
		orientation: shown.orientation,
		matchCodes: ofMatches,
		places: loosePlaces(shown.match, ofMatches)
	};
}
/** The pane at a canvas position. */
function paneAt(scene, x, y) {
	const side = SIDES.find((s) => contains(scene.panes[s].rect, x, y));
	return side === void 0 ? null : scene.panes[side];
}
// www/pair/view/input.ts
/** Pointer, wheel, touch and keys on the images. */
function mountInput(view, store, navigator, editing) {
	const { host } = view;
	const activate = (side) => {
		if (store.state.activeSide !== side) store.dispatch({
			type: "activeSide",
			side
		});
	};
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
			else press(view.hit(x, y), more, editing, navigator);
		},
		encloses: (shift) => shift || store.state.tool === "choose",
		enclosed: (side, from, to, ended) => enclose(view, store, side, from, to, ended),
		pointed: (at) => view.point(at),
		command: (key, shift) => store.state.tool === "measure" && measuring(key, shift, store, navigator, editing) || command(key, store, navigator, editing)
	}, host.closest(".stage") ?? host);
}
/** Selects a point; with `more` its match is chosen beside the others, or no longer. */
function press(hit, more, editing, navigator) {
	if (more) {
		editing.choose(hit);
		return;
	}
	editing.chooseNone();
	navigator.select(hit);
}
/** Chooses the matches in a rectangle of the canvas. */
function enclose(view, store, side, from, to, ended) {
	const rect = to === null ? null : between(from, to);
	view.enclose(ended ? null : rect);
	const edited = editedPair(store.state);
	if (!ended || rect === null || edited === null) return;
	const { transform, codes } = view.scene().panes[side];
	const [left, top] = toPosition(transform, rect.left, rect.top);
	const [right, bottom] = toPosition(transform, rect.left + rect.width, rect.top + rect.height);
	const { display } = store.state;
	const ofLefts = side === "left" ? codes : view.scene().panes.left.codes;
	store.dispatch({
		type: "choose",
		chosen: keysWithin(edited, side, [
			left,
			top,
			right,
			bottom
		], (index) => isCodeShown(display, ofLefts[index] ?? 0))
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
/** Places a point of the match that is measured. */
function measure(view, x, y, editing, navigator) {
	const pane = paneAt(view.scene(), x, y);
	if (pane?.picture == null) return;
	editing.place(pane.side, toPosition(pane.transform, x, y));
	navigator.followDraft();
}
var ARROWS = {
	ArrowLeft: [-1, 0],
	ArrowRight: [1, 0],
	ArrowUp: [0, -1],
	ArrowDown: [0, 1]
};
/** How far an arrow moves a point, px; with Shift. */
var FINE = .1;
var COARSE = 1;
/** Runs the command of a key while a match is measured; false where it has none then. */
function measuring(key, shift, store, navigator, editing) {
	const { draft } = store.state;
	if (draft === null) {
		const middle = key === "Enter" ? navigator.middle() : null;
		if (middle === null) return false;
		editing.place(...middle);
		navigator.followDraft();
		return true;
	}
	const arrow = ARROWS[key];
	if (arrow !== void 0) {
		const step = shift ? COARSE : FINE;
		editing.nudge(step * arrow[0], step * arrow[1]);
		navigator.followDraft();
		return true;
	}
	switch (key) {
		case "Enter":
			editing.accept();
			return true;
		case "o":
		case "O":
			editing.exchange();
			navigator.followDraft();
			return true;
		case "f":
		case "F":
			editing.fit();
			return true;
		default: return false;
	}
}
/** Runs the command of a key; false where it has none. */
function command(key, store, navigator, editing) {
	const { activeSide, display } = store.state;
	switch (key) {
		case "1":
			navigator.actualSize();
			return true;
		case "n":
		case "N":
			navigator.step(1);
			return true;
		case "p":
		case "P":
			navigator.step(-1);
			return true;
		case "o":
		case "O":
			store.dispatch({
				type: "activeSide",
				side: otherSide(activeSide)
			});
			return true;
		case "l":
		case "L":
			store.dispatch({
				type: "display",
				display: { linked: !display.linked }
			});
			return true;
		case "m":
		case "M":
			store.dispatch({
				type: "display",
				display: { magnifier: !display.magnifier }
			});
			return true;
		case "Delete":
		case "Backspace":
			editing.edit("reject");
			return true;
		case "r":
		case "R":
			editing.edit("restore");
			return true;
		case "x":
		case "X":
			editing.choose(store.state.selection);
			return true;
		case "s":
		case "S":
			editing.toggle("choose");
			return true;
		case "a":
		case "A":
			editing.toggle("measure");
			return true;
		case "e":
		case "E":
			editing.move();
			navigator.followDraft();
			return true;
		case "Escape":
			if (!editing.leave()) navigator.select(null);
			return true;
		default: return false;
	}
}
// www/pair/state/offset.ts
/** The node below a position along one axis, the one above, and how far between them. */
function along(position, spacing, nodes) {
	const place = Math.min(nodes - 1, Math.max(0, position / spacing));
	const first = Math.min(Math.floor(place), Math.max(0, nodes - 2));
	return [
		first,
		Math.min(first + 1, nodes - 1),
		place - first
	];
}
/** The left position plus the field's offset there, bilinear between nodes, as the crate's `OffsetField::at`. */
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
/** The left position whose expected position is this right one: the field is smooth, so that a few repetitions settle. */
function expectedOrigin(field, [x, y]) {
	let at = [x - field.median_px[0], y - field.median_px[1]];
	for (let i = 0; i < 3; i++) {
		const [ex, ey] = expectedPosition(field, at);
		at = [at[0] + x - ex, at[1] + y - ey];
	}
	return at;
}
// www/pair/state/follow.ts
/** Where the ground at a place of one image lies in the other, so that linked panes show the same: by the offset, or by the matches. */
/** Matches below which a map is not trusted. */
var LEAST_MATCHES = 10;
/** The affine map from left to right that fits all matches best (stride 5); null where they are few or lie along a line. */
var affineOf = remember((matches) => {
	const count = matches.length / 5;
	if (count < LEAST_MATCHES) return null;
	const [mx = NaN, my = NaN, mu = NaN, mv = NaN] = [
		0,
		1,
		2,
		3
	].map((k) => {
		let sum = 0;
		for (let i = k; i < matches.length; i += 5) sum += matches[i] ?? 0;
		return sum / count;
	});
	let [xx, xy, yy, xu, yu, xv, yv] = [
		0,
		0,
		0,
		0,
		0,
		0,
		0
	];
	for (let i = 0; i < matches.length; i += 5) {
		const [x, y] = [(matches[i] ?? 0) - mx, (matches[i + 1] ?? 0) - my];
		const [u, v] = [(matches[i + 2] ?? 0) - mu, (matches[i + 3] ?? 0) - mv];
		xx += x * x;
		xy += x * y;
		yy += y * y;
		xu += x * u;
		yu += y * u;
		xv += x * v;
		yv += y * v;
	}
	const determinant = xx * yy - xy * xy;
	if (!(determinant > 1e-6 * xx * yy)) return null;
	const [a, b] = [(yy * xu - xy * yu) / determinant, (xx * yu - xy * xu) / determinant];
	const [d, e] = [(yy * xv - xy * yv) / determinant, (xx * yv - xy * xv) / determinant];
	return [
		a,
		b,
		mu - a * mx - b * my,
		d,
		e,
		mv - d * mx - e * my
	];
});
function mapped([a, b, c, d, e, f], [x, y]) {
	return [a * x + b * y + c, d * x + e * y + f];
}
function mappedBack([a, b, c, d, e, f], [x, y]) {
	const determinant = a * e - b * d;
	return [(e * (x - c) - b * (y - f)) / determinant, (a * (y - f) - d * (x - c)) / determinant];
}
/** The place in the other image of what lies at a place of one; null where nothing tells it yet. */
function sameGround(state, side, at) {
	const { settings, results } = state;
	if (settings !== null && comparesGradients(settings)) {
		const map = results.match !== void 0 && isCurrent(state, "match") ? affineOf(results.match.value.matches) : null;
		if (map === null) return null;
		return side === "left" ? mapped(map, at) : mappedBack(map, at);
	}
	const field = isCurrent(state, "offset") ? results.offset?.value : void 0;
	if (field === void 0) return null;
	return side === "left" ? expectedPosition(field, at) : expectedOrigin(field, at);
}
// www/pair/view/navigate.ts
/** Moves through the images and from point to point. */
var Navigator = class {
	store;
	view;
	constructor(store, view) {
		this.store = store;
		this.view = view;
	}
	/** Moves the content by CSS px; both panes where they are linked. */
	pan(side, dx, dy) {
		this.change(side, (pane, own) => ({
			...own,
			x: own.x - dx / pane.transform.scale,
			y: own.y - dy / pane.transform.scale
		}));
	}
	/** Zooms about a canvas position; in a linked pane about the same place of the pane. */
	zoom(side, factor, x, y) {
		const origin = this.view.scene().panes[side].rect;
		this.change(side, (pane, own, least) => zoomed(pane.rect, own, factor, x - origin.left + pane.rect.left, y - origin.top + pane.rect.top, least));
	}
	/** Zooms about the selected point where the active pane shows it, else about the pane's middle. */
	zoomMiddle(factor) {
		const pane = this.activePane();
		const { rect } = pane;
		const middle = [rect.left + rect.width / 2, rect.top + rect.height / 2];
		this.zoom(pane.side, factor, ...this.selectedPlace(pane) ?? middle);
	}
	/** Shows whole images. */
	fit() {
		this.store.dispatch({
			type: "views",
			views: {
				left: null,
				right: null
			}
		});
	}
	/** One image px to one CSS px. */
	actualSize() {
		this.zoomMiddle(1 / this.activePane().transform.scale);
	}
	/** Selects the next or previous shown point of the active side, in raster order. */
	step(by) {
		const { state } = this.store;
		const pane = this.activePane();
		const count = pane.codes.length;
		const start = state.selection?.side === pane.side ? state.selection.index : by > 0 ? -1 : count;
		for (let i = start + by; i >= 0 && i < count; i += by) if (isCodeShown(state.display, pane.codes[i] ?? 0)) {
			this.select({
				side: pane.side,
				index: i
			});
			return;
		}
	}
	/** Selects a point and brings it, and its match, into view. */
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
	/** Shows the points of the match that is measured, the second one as large as the first. */
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
	/** The position in the middle of the active pane; null where it shows no image. */
	middle() {
		const { rect, transform, side, picture } = this.activePane();
		return picture === null ? null : [side, toPosition(transform, rect.left + rect.width / 2, rect.top + rect.height / 2)];
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
	/** Changes the view of a side; a linked one follows to the same ground, where that is known. */
	change(side, next) {
		const scene = this.view.scene();
		const { state } = this.store;
		const move = (pane) => {
			if (pane.picture === null) return [];
			const whole = fitView(pane.rect, pane.picture.width, pane.picture.height);
			return [[pane.side, clamped(next(pane, state.views[pane.side] ?? whole, whole.scale / 4), pane.picture)]];
		};
		const own = move(scene.panes[side]);
		const other = state.display.linked ? move(scene.panes[otherSide(side)]) : [];
		this.store.dispatch({
			type: "views",
			views: Object.fromEntries([...own, ...other.map((entry) => this.followed(side, own[0]?.[1], entry))])
		});
	}
	/** The view of the linked pane, centred where the ground at the other one's centre is expected. */
	followed(side, leader, [other, view]) {
		const ground = leader === void 0 ? null : sameGround(this.store.state, side, [leader.x, leader.y]);
		return ground === null ? [other, view] : [other, {
			x: ground[0],
			y: ground[1],
			scale: view.scale
		}];
	}
};
/** A place at the very edge of a pane is hardly seen. */
function inner({ left, top, width, height }) {
	return {
		left: left + width / 8,
		top: top + height / 8,
		width: .75 * width,
		height: .75 * height
	};
}
/** The best right point of a left one, or the left point that a right one is matched to. */
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
/** The matches that are chosen together, and the rectangle that chooses them. */
var RADIUS = 6;
/** Draws a ring around both points of each chosen match, with a dark edge, so that it shows on light and dark ground. */
function drawChosen(context, state, scene) {
	const edited = editedPair(state);
	const lefts = chosenLefts(state);
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
// www/pair/view/tilecache.ts
/** Tiles kept at most: 1 MB each. */
var MOST_TILES = 96;
/** Tiles asked for at the same time: a worker that also computes is not flooded with requests for places already left. */
var MOST_REQUESTS = 3;
var TileCache = class {
	fetch;
	arrived;
	/** In order of last use. */
	tiles = /* @__PURE__ */ new Map();
	requested = /* @__PURE__ */ new Set();
	constructor(fetch, arrived) {
		this.fetch = fetch;
		this.arrived = arrived;
	}
	/** The tile, or null while it is on its way. */
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
/** Paints an image into a pane: its reduced copy at once, detail tiles as they come. */
/** The part of the image that a rectangle of the canvas shows: left, top, right, bottom in px, within the image. */
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
/** The reduction whose pixels are nearest to, and not larger than, device pixels. */
function wantedLevel(scale, ratio) {
	return Math.max(0, Math.floor(Math.log2(1 / (scale * ratio))));
}
/** Draws the part of a bitmap that is seen. `step`: image px of one bitmap px; `x`, `y`: image position of its corner. */
function paintBitmap(context, bitmap, x, y, step, part, t) {
	const left = Math.max(0, Math.floor((part[0] - x) / step));
	const top = Math.max(0, Math.floor((part[1] - y) / step));
	const right = Math.min(bitmap.width, Math.ceil((part[2] - x) / step));
	const bottom = Math.min(bitmap.height, Math.ceil((part[3] - y) / step));
	if (right <= left || bottom <= top) return;
	const size = step * t.scale;
	context.drawImage(bitmap, left, top, right - left, bottom - top, t.scale * x + t.x + left * size, t.scale * y + t.y + top * size, (right - left) * size, (bottom - top) * size);
}
/** Paints what a rectangle of the canvas shows of an image. `ratio`: device px per CSS px. */
function paintPicture(context, picture, t, clip, ratio, tiles) {
	within(context, clip, () => {
		context.imageSmoothingEnabled = t.scale * ratio < 2;
		context.imageSmoothingQuality = "medium";
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
/** Paints what a mask leaves out over its image. */
function paintMask(context, { overlay, width, height }, t, clip) {
	within(context, clip, () => {
		context.imageSmoothingEnabled = false;
		context.drawImage(overlay, t.x, t.y, t.scale * width, t.scale * height);
	});
}
// www/pair/view/overlay.ts
/** What follows the pointer and the selection: the selected point, its search window and candidates, the magnifier. */
/** Side of the magnifier in CSS px, and how much more it enlarges. */
var LENS_SIDE$1 = 176;
var LENS_FACTOR = 4;
var MOST_CANDIDATES_DRAWN = 200;
/** Candidates by gradients lie all over the image: the nearest of them. */
var MOST_GRADIENT_CANDIDATES_DRAWN = 10;
function pointOf(pane, index) {
	const x = pane.points?.[3 * index];
	const y = pane.points?.[3 * index + 1];
	return x === void 0 || y === void 0 ? null : [x, y];
}
/** A ring with a dark edge, so that it shows on light and dark ground. */
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
function square(context, pane, [x, y], side, colour, dash) {
	const [left, top] = toCanvas(pane.transform, x - side / 2, y - side / 2);
	context.setLineDash(dash);
	context.lineWidth = 1.5;
	context.strokeStyle = colour;
	context.strokeRect(left, top, side * pane.transform.scale, side * pane.transform.scale);
	context.setLineDash([]);
}
/** Draws the selection in both panes: the point, its window, its search window with all candidates, its best place. */
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
/** An epipolar line, or a cross at the one place that a map gives. */
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
function drawCandidates(context, state, scene, leftIndex, leftAt, best) {
	const pane = scene.panes.right;
	within(context, pane.rect, () => {
		const { settings } = state;
		const gradients = settings !== null && comparesGradients(settings);
		const field = isCurrent(state, "offset") ? state.results.offset?.value : void 0;
		if (field !== void 0) square(context, pane, expectedPosition(field, leftAt), state.settings?.matching.search ?? 0, CANDIDATE, [5, 4]);
		if (isCurrent(state, "inspection")) {
			const list = state.results.inspection?.value.candidates ?? /* @__PURE__ */ new Float64Array();
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
/** The magnifier at a canvas position: the image under the pointer, enlarged, with its points. */
function drawLens(context, state, scene, at, ratio, tiles, bounds) {
	const pane = contains(scene.panes.left.rect, at[0], at[1]) ? scene.panes.left : scene.panes.right;
	if (pane.picture === null || !contains(pane.rect, at[0], at[1])) return;
	const scale = Math.min(48, Math.max(4, pane.transform.scale * LENS_FACTOR));
	paintLens(context, state, scene, pane, toPosition(pane.transform, at[0], at[1]), lensRect(at, bounds), scale, ratio, tiles);
}
/** A rectangle of the canvas that shows what lies around a place of an image, enlarged, with its points. */
function paintLens(context, state, scene, pane, [x, y], rect, scale, ratio, tiles) {
	const { picture } = pane;
	if (picture === null) return;
	const transform = {
		scale,
		x: rect.left + rect.width / 2 - scale * x,
		y: rect.top + rect.height / 2 - scale * y
	};
	within(context, rect, () => {
		context.fillStyle = "#000000";
		context.fillRect(rect.left, rect.top, rect.width, rect.height);
		paintPicture(context, picture, transform, rect, ratio, tiles);
		drawPoints(context, state, scene, pane, transform, rect);
		crosshair(context, rect);
	});
	context.lineWidth = 2;
	context.strokeStyle = SELECTED;
	context.strokeRect(rect.left, rect.top, rect.width, rect.height);
}
/** Beside the pointer, on the canvas. */
function lensRect([x, y], bounds) {
	const side = Math.min(LENS_SIDE$1, bounds.width, bounds.height);
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
// www/pair/view/draft.ts
/** The match that is measured: its points, where they may lie, and both of them enlarged. */
var ARM = 12;
var LENS_SIDE = 168;
/** A px of the image in the lens, CSS px. */
var LENS_SCALE = 12;
var EDGE = 8;
/** Draws the points of the draft as crosses that leave their middle free, and what is known of where the second one may lie. */
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
/** Enlarges what lies around both points, in the lower outer corner of each pane: one place is compared with the other. */
function drawDraftLenses(context, state, scene, ratio, tiles) {
	for (const side of SIDES) {
		const pane = scene.panes[side];
		const at = placeOfDraft(state, side);
		if (at === null) continue;
		paintLens(context, state, scene, pane, at, cornerOf(pane), Math.max(LENS_SCALE, pane.transform.scale), ratio, tiles);
	}
}
function cornerOf({ rect, side }) {
	const length = Math.max(40, Math.min(LENS_SIDE, rect.width * .45, rect.height * .45));
	return {
		left: side === "left" ? rect.left + EDGE : rect.left + rect.width - EDGE - length,
		top: rect.top + rect.height - EDGE - length,
		width: length,
		height: length
	};
}
// www/pair/view/grid.ts
/** Finds the point nearest to a position: points sorted into square cells. */
var PointGrid = class {
	points;
	start;
	order;
	columns;
	rows;
	side;
	/** `points`: stride 3, x, y, value, in an image of `width` x `height` px. */
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
	/** Index of the nearest accepted point within `radius` px; -1 where there is none. */
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
// www/pair/view/view.ts
/** The canvases: images below, marks above them, selection and magnifier on top. Each is drawn again only when what it shows changed. */
var LAYERS = [
	"pictures",
	"marks",
	"overlay"
];
/** How near a click must be to a point, in CSS px. */
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
		}, () => this.layers.redraw("pictures", "overlay"));
		store.watch((s) => [
			s.views,
			s.images,
			s.masks,
			s.results.openLeft,
			s.results.openRight
		], () => this.layers.redraw());
		store.watch((s) => [
			s.results.pointsLeft,
			s.results.pointsRight,
			s.results.match,
			s.results.orientation,
			s.history,
			s.display,
			s.catalogue
		], () => this.layers.redraw("marks", "overlay"));
		store.watch((s) => [
			s.selection,
			s.chosen,
			s.draft,
			s.results.line,
			s.results.inspection,
			s.settings,
			s.results.offset
		], () => this.layers.redraw("overlay"));
	}
	/** The scene as it stands now. */
	scene() {
		return sceneOf(this.store.state, this.layers.width, this.layers.height);
	}
	/** The pointer's place over the canvas, for the magnifier; null when it left. */
	point(at) {
		this.pointer = at;
		if (this.store.state.display.magnifier) this.layers.redraw("overlay");
	}
	/** Shows a rectangle that is being drawn; null: none. */
	enclose(rectangle) {
		this.rectangle = rectangle;
		this.layers.redraw("overlay");
	}
	/** The shown point nearest to a canvas position. */
	hit(x, y) {
		const { state } = this.store;
		const scene = this.scene();
		const pane = paneAt(scene, x, y);
		if (pane?.picture == null || pane.points === null) return null;
		const { width, height } = pane.picture;
		const at = toPosition(pane.transform, x, y);
		const radius = CLICK_RADIUS / pane.transform.scale;
		const found = gridOf[pane.side](pane.points, width, height).nearest(...at, radius, (i) => isCodeShown(state.display, pane.codes[i] ?? 0));
		const index = found < 0 ? null : {
			side: pane.side,
			index: found
		};
		if (pane.side === "left" || scene.match === null) return index;
		const { places } = scene;
		const place = gridOfPlaces(places.points, width, height).nearest(...at, radius, (i) => isCodeShown(state.display, places.codes[i] ?? 0));
		return place < 0 ? index : {
			side: "left",
			index: places.lefts[place] ?? 0
		};
	}
	/** The picture as it is on the screen, all layers together. */
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
			case "marks":
				if (state.catalogue !== null) drawMarks(context, state, scene);
				break;
			case "overlay":
				drawChosen(context, state, scene);
				drawSelection(context, state, scene);
				drawDraft(context, state, scene);
				if (this.rectangle !== null) drawRectangle(context, this.rectangle);
				drawDraftLenses(context, state, scene, this.layers.ratio, this.tiles);
				if (state.draft === null) this.drawMagnifier(context, state, scene);
		}
	}
	/** At the pointer; at the selected point while the pointer is elsewhere. */
	drawMagnifier(context, state, scene) {
		const at = this.pointer ?? selectedPlace(state, scene);
		if (!state.display.magnifier || at === null || state.catalogue === null) return;
		const { width, height, ratio } = this.layers;
		drawLens(context, state, scene, at, ratio, this.tiles, {
			left: 0,
			top: 0,
			width,
			height
		});
	}
	drawPicture(context, pane) {
		if (pane.picture === null) return;
		const current = wantedKeys(this.store.state)[pane.side === "left" ? "openLeft" : "openRight"] !== null;
		paintPicture(context, pane.picture, pane.transform, pane.rect, this.layers.ratio, current ? this.tiles : null);
		const mask = this.store.state.masks[pane.side];
		if (mask !== null) paintMask(context, mask, pane.transform, pane.rect);
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
function mountPair(catalogue, { openProject, toBlock, sampleBlock, putAside }) {
	const store = new Store();
	const { element: left, panels: [settings, camera, simulate] } = tabbed("Settings", [
		["settings", "Settings"],
		["camera", "Camera"],
		["simulate", "Simulate"]
	]);
	const { element: right, panels: [results, point, matches] } = tabbed("Results", [
		["results", "Results"],
		["point", "Point"],
		["matches", "Matches"]
	]);
	byId("stage").before(left);
	byId("stage").after(right);
	const settingsButton = drawerButton("settings", "Settings", "settings", left);
	byId("menu").before(h("div", {
		class: "drawers",
		aria: { label: "Settings of the pair" },
		role: "group"
	}, settingsButton));
	byId("answer-actions").append(drawerButton("details", "Details", "details", right));
	const engine = new Engine(store);
	const view = new View(byId("view"), store, engine);
	const navigator = new Navigator(store, view);
	const kept = new KeptPairs(store, engine, catalogue);
	const files = new Files(store, engine, openProject, toBlock, () => putAside(kept));
	/** Runs an action of the user's; what goes wrong is said in the status line. */
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
	const editing = new Editing(store, (left, right) => fitted(store.state, engine, left, right));
	mountInput(view, store, navigator, editing);
	mountToolbar(byId("toolbar"), store, navigator);
	mountEditTools(byId("view-more"), byId("toolbar"), store, editing);
	mountDraft(byId("toolbar"), store, editing, () => navigator.followDraft());
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
	mountControls(settings, store, settingsButton);
	mountCamera(camera, store, () => pick(null));
	mountFiducials(camera, store, (side) => pick(side));
	mountCounts(results, store);
	mountGeometry(results, store);
	mountOrientation(results, store);
	mountHistograms(results, store);
	mountPoint(point, store, (side, index) => navigator.select({
		side,
		index
	}));
	mountEdits(matches, store, editing, () => navigator.followDraft());
	mountEditKeys(matches, store, editing);
	mountStatistics(matches, store, editing, (side, index) => navigator.select({
		side,
		index
	}));
	mountSimulate(simulate, store, engine, (name, flight) => void attempt(() => files.takeFlight(name, flight)));
	mountAnnouncements(byId("announce"), store, () => {
		showTab("tab-point");
		setDrawer("details", true);
		reveal(right);
	});
	mountStatus(store, {
		cancel: () => engine.cancel(),
		run: () => store.dispatch({ type: "resume" }),
		open: (side) => pick(side),
		camera: () => {
			setDrawer("settings", true);
			showTab("tab-camera");
		},
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
			results.querySelector(`[data-testid="${oriented ? "orientation" : "matches"}-section"]`)?.scrollIntoView({ block: "start" });
		},
		save: () => void attempt(() => exportProject(store, engine))
	});
	mountHeader({
		store,
		engine,
		view,
		files,
		pick,
		attempt,
		sampleBlock
	});
	store.watch(["selection"], ([selection]) => {
		if (selection !== null && matches.hidden) showTab("tab-point");
	});
	return {
		store,
		engine,
		kept,
		begin: () => files.begin(),
		taker: takerOf(view, files),
		open: (file) => files.takeProject(file)
	};
}
// www/shared/engine/start.ts
/** The module on the main thread: for what takes no time, as checks of fields and drawing. */
/** Loads the module and reads what the crate says of itself. */
async function loadCatalogue() {
	initSync({ module: await wasmModule() });
	return readCatalogue();
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
var transactionDoneMap = /* @__PURE__ */ new WeakMap();
var transformCache = /* @__PURE__ */ new WeakMap();
var reverseTransformCache = /* @__PURE__ */ new WeakMap();
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
/**
* Open a database.
*
* @param name Name of the database.
* @param version Schema version.
* @param callbacks Additional callbacks.
*/
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
var advanceResults = /* @__PURE__ */ new WeakMap();
var ittrProxiedCursorToOriginalProxy = /* @__PURE__ */ new WeakMap();
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
// www/shared/files/database.ts
/** The browser's own storage: projects, each kept in named parts. A change is one transaction: it is there whole, or not at all. */
var NAME$1 = "tiepoint";
/** Of the database itself; what projects look like inside has a number of its own (`FORM`). */
var VERSION = 1;
/** Storage that does not answer in this time, in ms, counts as absent. */
var PATIENCE_MS = 5e3;
var KeepError = class extends Error {
	kind;
	name = "KeepError";
	constructor(kind, message) {
		super(message);
		this.kind = kind;
	}
};
/** All parts of a project, in the order of their names. */
var partsOf = (project) => IDBKeyRange.bound([project], [project, []]);
var Database = class Database {
	db;
	constructor(db) {
		this.db = db;
	}
	/** Rejects where the browser keeps nothing: in some private windows, where storage is blocked, or where a later version of the page wrote it. */
	static async open() {
		const opening = openDB(NAME$1, VERSION, {
			upgrade: (db) => {
				db.createObjectStore("projects", { keyPath: "id" });
				db.createObjectStore("parts", { keyPath: ["project", "part"] }).createIndex("sizes", ["project", "bytes"]);
			},
			blocking: (_, __, event) => event.target.close()
		});
		const late = new Promise((_, reject) => setTimeout(() => setTimeout(() => reject(/* @__PURE__ */ new Error("the storage does not answer"))), PATIENCE_MS));
		return new Database(await Promise.race([opening, late]));
	}
	/** The one changed last comes first. */
	async projects() {
		return (await this.db.getAll("projects")).sort((a, b) => b.changed - a.changed);
	}
	project(id) {
		return this.db.get("projects", id);
	}
	async parts(id) {
		const rows = await this.db.getAll("parts", partsOf(id));
		return new Map(rows.map(({ part, value }) => [part, value]));
	}
	/** About how much room a project takes: no part is read for that. */
	async bytesOf(id) {
		let sum = 0;
		let cursor = await this.db.transaction("parts").store.index("sizes").openKeyCursor(IDBKeyRange.bound([id], [id, []]));
		while (cursor !== null) {
			sum += cursor.key[1];
			cursor = await cursor.continue();
		}
		return sum;
	}
	/** Writes what has changed of a project. `isNew`: it need not be there. @throws KeepError, with nothing changed */
	async write(row, { put, drop }, isNew) {
		await this.change(async (projects, parts) => {
			const there = await projects.get(row.id);
			if (there !== void 0 && there.writer !== row.writer) throw new KeepError("taken", "another tab has taken the project over");
			if (there !== void 0 && there.form > row.form) throw new KeepError("other", "a later version of this page wrote the project");
			if (there === void 0 && !isNew) throw new KeepError("gone", "the project is no longer in the storage");
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
	/** Changes what the list says of a project. */
	async edit(id, changed) {
		await this.change(async (projects) => {
			const there = await projects.get(id);
			if (there === void 0) throw new KeepError("gone", "the project is no longer in the storage");
			await projects.put({
				...there,
				...changed
			});
		});
	}
	async duplicate(id, row) {
		await this.change(async (projects, parts) => {
			const there = await projects.get(id);
			if (there === void 0) throw new KeepError("gone", "the project is no longer in the storage");
			await projects.put({
				...there,
				...row,
				writer: ""
			});
			for (const part of await parts.getAll(partsOf(id))) await parts.put({
				...part,
				project: row.id
			});
		});
	}
	async remove(id) {
		await this.change(async (projects, parts) => {
			await Promise.all([projects.delete(id), parts.delete(partsOf(id))]);
		});
	}
	/** One transaction, which is on the disk when this resolves. */
	async change(work) {
		let done = null;
		let abort = () => {};
		try {
			const transaction = this.db.transaction(["projects", "parts"], "readwrite", { durability: "strict" });
			done = transaction.done;
			done.catch(() => {});
			abort = () => transaction.abort();
			await work(transaction.objectStore("projects"), transaction.objectStore("parts"));
			await done;
		} catch (error) {
			const reason = await ended(error, done, abort);
			if (reason instanceof KeepError) throw reason;
			throw new KeepError(isFull(reason) ? "full" : "other", reason instanceof Error ? reason.message : String(reason));
		}
	}
};
/** Ends a transaction that failed; gives what is to blame for it: requests of a transaction that broke off say only that it did. */
async function ended(error, done, abort) {
	try {
		abort();
		return error;
	} catch {
		return done === null ? error : done.then(() => error, (reason) => reason ?? error);
	}
}
function isFull(error) {
	return error instanceof DOMException && error.name === "QuotaExceededError";
}
// www/shared/files/drop.ts
/** The first taker that is active gets what is given. Takers come once the program has loaded: what is given before is kept for them. */
function mountDrop() {
	let serving = null;
	const waiting = [];
	const loading = {
		isActive: () => true,
		markAt: () => "page",
		take: (found) => void waiting.push(...found)
	};
	const active = () => (serving ?? [loading]).find(({ isActive }) => isActive());
	const unmark = () => {
		delete document.body.dataset.drop;
	};
	document.addEventListener("dragover", (event) => {
		const taker = active();
		if (!hasFiles(event) || taker === void 0) return;
		event.preventDefault();
		document.body.dataset.drop = taker.markAt(event);
	});
	document.addEventListener("dragleave", (event) => {
		if (event.relatedTarget === null) unmark();
	});
	document.addEventListener("drop", (event) => {
		unmark();
		const taker = active();
		if (!hasFiles(event) || taker === void 0) return;
		event.preventDefault();
		const at = taker.markAt(event);
		const items = [...event.dataTransfer?.items ?? []].map((item) => ({
			entry: item.webkitGetAsEntry(),
			file: item.getAsFile()
		}));
		Promise.all(items.map(({ entry, file }) => found(entry, file))).then((lists) => {
			const late = taker === loading && serving !== null;
			(late ? active() : taker)?.take(lists.flat(), late ? null : at);
		});
	});
	document.addEventListener("paste", (event) => {
		const pasted = [...event.clipboardData?.files ?? []];
		const taker = active();
		if (pasted.length === 0 || taker === void 0) return;
		event.preventDefault();
		taker.take(pasted.map((file) => ({
			file,
			path: ""
		})), null);
	});
	return (takers) => {
		serving = takers;
		if (waiting.length > 0) active()?.take(waiting.splice(0), null);
	};
}
function hasFiles(event) {
	return event.dataTransfer?.types.includes("Files") === true;
}
/** The files of an entry, those of folders below it too. */
async function found(entry, file) {
	if (entry?.isDirectory !== true) return file === null ? [] : [{
		file,
		path: ""
	}];
	return below(entry);
}
async function below(folder) {
	return (await Promise.all((await entriesOf(folder)).map(async (entry) => {
		if (entry.isDirectory) return below(entry);
		const file = await new Promise((resolve) => entry.file(resolve, () => resolve(null)));
		return file === null ? [] : [{
			file,
			path: entry.fullPath.replace(/^\//u, "")
		}];
	}))).flat();
}
/** All entries of a folder; the reader gives them in portions, the last of which is empty. */
async function entriesOf(folder) {
	const reader = folder.createReader();
	const all = [];
	for (;;) {
		const portion = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])));
		if (portion.length === 0) return all;
		all.push(...portion);
	}
}
// www/shared/files/claim.ts
/** Which tab has a project open: one at a time, told by a lock where the browser has locks, else by asking the other tabs. */
/** A tab that is just leaving lets go of its lock within this time, in ms. */
var LEAVING_MS = 1e3;
/** Other tabs answer within this time, in ms. */
var ANSWER_MS = 1500;
var Claims = class {
	tab;
	held = /* @__PURE__ */ new Map();
	channel = typeof BroadcastChannel === "undefined" ? null : new BroadcastChannel("tiepoint-projects");
	/** `tab` names this tab. */
	constructor(tab) {
		this.tab = tab;
		this.channel?.addEventListener("message", ({ data }) => {
			if (data.from === tab || !this.held.has(data.project)) return;
			if (data.kind === "ask") this.post("here", data.project);
			if (data.kind === "taken") this.lose(data.project);
		});
	}
	/** Claims a project; null where another tab has it, unless it is to be taken from there. `lost`: another tab has taken it. */
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
	/** Whether another tab has it open. */
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
	/** What lets a project go again; null where another tab has it. */
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
// www/shared/files/keeper.ts
/** Keeps the project of this tab in the browser's storage as it changes, and shows it again. */
/** Changes are gathered for so long before they are written, in ms. */
var GATHER_MS = 200;
/** A tab that loses its project has so long to write its last changes, in ms. */
var HANDOVER_MS = 400;
/** So much of files is written in one go. */
var PORTION_BYTES = 32e6;
/** The project of this tab, which a reload opens again. */
var TAB_PROJECT = "tiepoint-project";
/** How often in a row the page broke off with a project; then it is opened only when the user asks. */
var BROKE_OFF = "tiepoint-broke-off";
var MOST_BREAKS = 2;
/** A page that lasts so long with a project, in ms, did not break off for it. */
var CALM_MS = 15e3;
var Keeper = class {
	keepables;
	mode;
	keeping = new Holder({
		project: "",
		name: null,
		trouble: null,
		works: false
	}, (state, changed) => ({
		...state,
		...changed
	}));
	tab = randomName();
	claims = new Claims(this.tab);
	claim = null;
	database = null;
	/** What stands in the storage, by the names of the parts. */
	written = /* @__PURE__ */ new Map();
	writtenMode = "";
	/** Nothing of the project is in the storage yet. */
	isNew = true;
	timer;
	saving = Promise.resolve();
	constructor(keepables, mode) {
		this.keepables = keepables;
		this.mode = mode;
	}
	/** Opens the project that this tab had, else the one changed last. `ready`: called before anything is shown, in any case. */
	async start(opening, ready) {
		let show = () => {};
		try {
			this.database = await opening;
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
		ready();
		await this.shown(show);
		if (this.claim === null) await this.begin();
		this.writtenMode = this.mode.now();
		for (const keepable of this.keepables) keepable.watch(() => this.later());
		document.addEventListener("visibilitychange", () => {
			if (document.visibilityState === "hidden") this.flush();
		});
		window.addEventListener("pagehide", () => {
			forgetBreaks();
			this.flush();
		});
	}
	/** All projects that are kept, the one changed last first. */
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
	/** Opens a kept project in place of the present one, which stays in the list; where it cannot be opened nothing changes. */
	async open(id, steal = false) {
		await this.flush();
		const show = await this.read(id, steal);
		if (show === null) return;
		await this.flush();
		for (const keepable of this.keepables) keepable.clear();
		await this.shown(show);
		this.writtenMode = this.mode.now();
	}
	/** Shows what was read. What was read well and still cannot be shown must not stop the page, and stays in the storage as it is. */
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
					title: "The project"
				}
			} });
		}
	}
	/** Puts the present project aside and begins a new one. */
	async anew() {
		await this.flush();
		await this.begin();
		for (const keepable of this.keepables) keepable.clear();
		this.keeping.dispatch({ trouble: null });
	}
	/**
	* Leaves the project in the list as it is and goes on with the same in a new one; false where nothing is kept, or another part of the page
	* has something in it too, which would be kept twice.
	*/
	async putAside(part) {
		await this.flush();
		const { trouble } = this.keeping.state;
		const others = this.keepables.some((keepable) => keepable !== part && keepable.parts().size > 0);
		if (this.isNew || trouble !== null || others) return false;
		await this.begin();
		return true;
	}
	/** Keeps what is on the page as a project of its own. */
	async keepAsNew() {
		await this.begin();
		this.keeping.dispatch({ trouble: null });
		await this.flush();
	}
	async rename(id, name) {
		await this.database?.edit(id, { name });
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
	/** Deletes a project; of the one on the page nothing is left there either. @throws Error where another tab has it open */
	async remove(id) {
		if (await this.claims.elsewhere(id)) throw new Error("another tab has this project open: close it there first");
		if (id === this.keeping.state.project) await this.anew();
		await this.database?.remove(id);
	}
	/** The parts of a project as they stand in the storage. */
	async partsOf(id) {
		return await this.database?.parts(id) ?? /* @__PURE__ */ new Map();
	}
	/** What was said is known. */
	dismiss() {
		this.keeping.dispatch({ trouble: null });
	}
	/** Resolves when all changes so far are written, or could not be. */
	flush() {
		window.clearTimeout(this.timer);
		this.timer = void 0;
		this.saving = this.saving.then(() => this.save());
		return this.saving;
	}
	later() {
		this.timer ??= window.setTimeout(() => void this.flush(), GATHER_MS);
	}
	/** Reads the project that a start shows. */
	async first(database) {
		const remembered = rememberedProject();
		const rows = await database.projects();
		const row = remembered === null ? rows[0] : rows.find(({ id }) => id === remembered);
		const nothing = () => {};
		if (row === void 0) return nothing;
		if (breaks(row.id) >= MOST_BREAKS) {
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
		return await this.read(row.id, false) ?? nothing;
	}
	/** Claims and reads a project; gives what shows it, or null where it cannot be opened, for which there is then a trouble. */
	async read(id, steal) {
		const { database } = this;
		const row = await database?.project(id);
		if (database === null || row === void 0) return null;
		const project = {
			id,
			title: titleOf(row)
		};
		const refuse = (kind, reason) => {
			this.keeping.dispatch({ trouble: {
				kind,
				reason,
				project
			} });
			return null;
		};
		if (row.form > 1) return refuse("unreadable", "a later version of this page wrote it");
		const claim = await this.claims.take(id, steal, () => this.lost(id));
		if (claim === null) return refuse("elsewhere", "");
		try {
			if (steal) await new Promise((resolve) => setTimeout(resolve, HANDOVER_MS));
			await database.edit(id, { writer: this.tab });
			const parts = await database.parts(id);
			const shows = await Promise.all(this.keepables.map((keepable) => keepable.read(parts)));
			return () => {
				if (this.claim !== claim) this.claim?.release();
				this.claim = claim;
				this.isNew = false;
				this.written = new Map(parts);
				this.keeping.dispatch({
					project: id,
					name: row.name,
					trouble: null
				});
				rememberProject(id);
				for (const show of shows) show();
				this.mode.show(row.mode);
			};
		} catch (error) {
			if (this.claim !== claim) claim.release();
			return refuse("unreadable", messageOf(error));
		}
	}
	/** Begins a project of which nothing is kept yet. */
	async begin() {
		const project = randomName();
		this.claim?.release();
		this.claim = await this.claims.take(project, true, () => this.lost(project));
		this.isNew = true;
		this.written = /* @__PURE__ */ new Map();
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
	/** Writes what has changed since it was written last. */
	async save() {
		const { database, keeping } = this;
		const { project, name, trouble } = keeping.state;
		if (database === null || project === "" || trouble?.kind === "taken") return;
		const parts = new Map(this.keepables.flatMap((keepable) => [...keepable.parts()]));
		const put = new Map([...parts].filter(([part, { value }]) => !this.written.has(part) || this.written.get(part) !== value));
		const drop = [...this.written.keys()].filter((part) => !parts.has(part));
		const mode = this.mode.now();
		if (put.size === 0 && drop.length === 0 && (this.isNew || mode === this.writtenMode)) return;
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
			await this.write(database, row, put, drop);
			this.writtenMode = mode;
			if (trouble?.kind === "full" || trouble?.kind === "failed") keeping.dispatch({ trouble: null });
		} catch (error) {
			this.failed(error, project);
		}
	}
	/** Files go first, in portions; what names them goes last, all at once. Where there is no room for all, what can be made again is left out. */
	async write(database, row, put, drop) {
		const write = async (some, gone) => {
			await database.write(row, {
				put: some,
				drop: gone
			}, this.isNew);
			this.isNew = false;
			for (const [part, { value }] of some) this.written.set(part, value);
			for (const part of gone) this.written.delete(part);
		};
		for (const portion of portionsOf(put)) await write(portion, []);
		const rest = new Map([...put].filter(([part]) => this.written.get(part) !== put.get(part)?.value || !this.written.has(part)));
		try {
			await write(rest, drop);
		} catch (error) {
			const needed = new Map([...rest].filter(([, { again }]) => again !== true));
			if (!(error instanceof KeepError) || error.kind !== "full" || needed.size === rest.size) throw error;
			await write(needed, drop);
			throw error;
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
			this.isNew = true;
			this.written = /* @__PURE__ */ new Map();
			this.later();
			return;
		}
		const project = {
			id,
			title: this.title()
		};
		this.keeping.dispatch({ trouble: {
			kind: kind === "full" ? "full" : "failed",
			reason: messageOf(error),
			project
		} });
	}
};
/** Files that may be written before the rest, in portions that take a moment each. */
function portionsOf(put) {
	const portions = [];
	let room = 0;
	for (const [part, kept] of put) {
		if (kept.alone !== true) continue;
		if (room < kept.bytes) {
			portions.push(/* @__PURE__ */ new Map());
			room = PORTION_BYTES;
		}
		portions.at(-1)?.set(part, kept);
		room -= kept.bytes;
	}
	return portions;
}
/** Runs what may be forbidden to a page: its storage of words. */
function allowed(action, otherwise) {
	try {
		return action();
	} catch {
		return otherwise;
	}
}
var rememberedProject = () => allowed(() => sessionStorage.getItem(TAB_PROJECT), null);
var rememberProject = (id) => allowed(() => sessionStorage.setItem(TAB_PROJECT, id), void 0);
/** How often in a row the page broke off with this project. */
function breaks(id) {
	const [project, count] = (allowed(() => localStorage.getItem(BROKE_OFF), null) ?? "").split(" ");
	return project === id ? Number(count) || 0 : 0;
}
var countBreak = (id) => allowed(() => localStorage.setItem(BROKE_OFF, `${id} ${String(breaks(id) + 1)}`), void 0);
var forgetBreaks = () => allowed(() => localStorage.removeItem(BROKE_OFF), void 0);
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
new u8([
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
_b.r;
var rev = new u16(32768);
for (var i = 0; i < 32768; ++i) {
	var x = (i & 43690) >> 1 | (i & 21845) << 1;
	x = (x & 52428) >> 2 | (x & 13107) << 2;
	x = (x & 61680) >> 4 | (x & 3855) << 4;
	rev[i] = ((x & 65280) >> 8 | (x & 255) << 8) >> 1;
}
var flt = new u8(288);
for (var i = 0; i < 144; ++i) flt[i] = 8;
for (var i = 144; i < 256; ++i) flt[i] = 9;
for (var i = 256; i < 280; ++i) flt[i] = 7;
for (var i = 280; i < 288; ++i) flt[i] = 8;
var fdt = new u8(32);
for (var i = 0; i < 32; ++i) fdt[i] = 5;
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
var et = /*#__PURE__*/ new u8(0);
var crct = /*#__PURE__*/ (function() {
	var t = /* @__PURE__ */ new Int32Array(256);
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
var mrg = function(a, b) {
	var o = {};
	for (var k in a) o[k] = a[k];
	for (var k in b) o[k] = b[k];
	return o;
};
var wbytes = function(d, b, v) {
	for (; v; ++b) d[b] = v, v >>>= 8;
};
var te = typeof TextEncoder != "undefined" && /*#__PURE__*/ new TextEncoder();
var td = typeof TextDecoder != "undefined" && /*#__PURE__*/ new TextDecoder();
try {
	td.decode(et, { stream: true });
} catch (e) {}
/**
* Converts a string into a Uint8Array for use with compression/decompression methods
* @param str The string to encode
* @param latin1 Whether or not to interpret the data as Latin-1. This should
*               not need to be true unless decoding a binary string.
* @returns The string encoded in UTF-8/Latin-1 binary
*/
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
/**
* A pass-through stream to keep data uncompressed in a ZIP archive.
*/
var ZipPassThrough = /* @__PURE__ */ function() {
	/**
	* Creates a pass-through stream that can be added to ZIP archives
	* @param filename The filename to associate with this data stream
	*/
	function ZipPassThrough(filename) {
		this.filename = filename;
		this.c = crc();
		this.size = 0;
		this.compression = 0;
	}
	/**
	* Processes a chunk and pushes to the output stream. You can override this
	* method in a subclass for custom behavior, but by default this passes
	* the data through. You must call this.ondata(err, chunk, final) at some
	* point in this method.
	* @param chunk The chunk to process
	* @param final Whether this is the last chunk
	*/
	ZipPassThrough.prototype.process = function(chunk, final) {
		this.ondata(null, chunk, final);
	};
	/**
	* Pushes a chunk to be added. If you are subclassing this with a custom
	* compression algorithm, note that you must push data from the source
	* file only, pre-compression.
	* @param chunk The chunk to push
	* @param final Whether this is the last chunk
	*/
	ZipPassThrough.prototype.push = function(chunk, final) {
		if (!this.ondata) err(5);
		this.c.p(chunk);
		this.size += chunk.length;
		if (final) this.crc = this.c.d();
		this.process(chunk, final || false);
	};
	return ZipPassThrough;
}();
/**
* A zippable archive to which files can incrementally be added
*/
var Zip = /* @__PURE__ */ function() {
	/**
	* Creates an empty ZIP archive to which files can be added
	* @param cb The callback to call whenever data for the generated ZIP archive
	*           is available
	*/
	function Zip(cb) {
		this.ondata = cb;
		this.u = [];
		this.d = 1;
	}
	/**
	* Adds a file to the ZIP archive
	* @param file The file stream to add
	*/
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
	/**
	* Ends the process of adding files and prepares to emit the final chunks.
	* This *must* be called after adding all desired files for the resulting
	* ZIP file to work properly.
	*/
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
	/**
	* A method to terminate any internal workers used by the stream. Subsequent
	* calls to add() will fail.
	*/
	Zip.prototype.terminate = function() {
		for (var _i = 0, _a = this.u; _i < _a.length; _i++) _a[_i].t();
		this.d = 2;
	};
	return Zip;
}();
// www/shared/files/rescue.ts
/** The parts of a kept project as files in one archive, whatever state they are in. */
async function archiveOf(parts) {
	const chunks = [];
	const archive = new Zip((error, chunk) => {
		if (error !== null) throw error;
		chunks.push(chunk);
	});
	for (const [part, value] of parts) for (const [name, content] of filesOf(part, value)) {
		const entry = new ZipPassThrough(name);
		archive.add(entry);
		entry.push(await bytesOf(content), true);
	}
	archive.end();
	return new Blob(chunks, { type: "application/zip" });
}
/** Files that a part holds, and the part itself as JSON. */
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
		case "absent": return `This browser keeps nothing of the page (a private window, or its storage is blocked): save the project as a file before you leave. ${reason}`;
		case "full": return "The storage of this browser is full: the last changes are not kept. What was kept before is whole. Delete projects that you no longer need, or save this one as a file.";
		case "failed": return `The last changes could not be kept: ${reason}. What was kept before is whole. Save the project as a file before you leave.`;
		case "elsewhere": return `${title} is open in another tab. This tab has a project of its own.`;
		case "taken": return `Another tab has taken ${title} over. What is changed here is no longer kept.`;
		case "unreadable": return `${title} cannot be restored: ${reason}. It stays in the storage as it is.`;
		case "broke-off": return `${title} was not opened: the page broke off the last times that it was. This is a new project.`;
	}
}
function buttonsFor({ kind, project }, keeper, { projects, saveFiles }) {
	const id = project?.id ?? "";
	const list = button("Projects …", "keeping-projects", projects);
	const close = button("Close", "keeping-close", () => keeper.dismiss());
	switch (kind) {
		case "elsewhere": return [button("Take it over", "keeping-take", () => void keeper.open(id, true)), close];
		case "taken": return [button("Take it back", "keeping-take", () => void keeper.open(id, true), "Shows the project as the other tab has kept it"), button("Keep this as a new project", "keeping-new", () => void keeper.keepAsNew())];
		case "unreadable": return [
			button("Save its files", "keeping-save", () => saveFiles(id)),
			list,
			close
		];
		case "broke-off": return [
			button("Open it", "keeping-open", () => void keeper.open(id)),
			button("Save its files", "keeping-save", () => saveFiles(id)),
			close
		];
		case "full": return [list, close];
		default: return [close];
	}
}
// www/shared/panel/projects.ts
var DATE = new Intl.DateTimeFormat("en-GB", {
	dateStyle: "medium",
	timeStyle: "short"
});
/** The buttons of the bar, the dialog, and the line that says what stands in the way of keeping. */
function mountProjects(keeper) {
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
		saveFiles: (project) => void saveFiles(keeper, project, "tiepoint-project")
	});
	keeper.keeping.watch(["works", "project"], ([works, project]) => {
		anew.disabled = project === "";
		press.disabled = !works || project === "";
	});
}
/** Asks before what could not be kept is lost. */
function mayLeave({ keeping }) {
	const kind = keeping.state.trouble?.kind;
	return !(kind === "full" || kind === "failed" || kind === "taken") || window.confirm("The last changes on the page could not be kept in this browser. Leave them?");
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
	stay = button("Ask the browser never to clear it", "project-persist", () => void this.attempt(() => this.persist()));
	constructor(keeper) {
		this.keeper = keeper;
		const close = button("Close", "projects-close", () => this.dialog.close());
		const anew = button("New project", "project-new", () => void this.leave(() => keeper.anew()));
		anew.className = "primary";
		const heading = h("h2", { id: "projects-heading" }, "Projects");
		const note = h("p", { class: "note" }, "This browser keeps each project as it changes. Nothing leaves this computer.");
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
	/** Does something after which the list is no longer needed. */
	async leave(action) {
		if (mayLeave(this.keeper) && await this.attempt(action)) this.dialog.close();
	}
	/** Does something, and says what went wrong. */
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
	/** Does something that changes the list. The keyboard goes on to `focus`. */
	async change(action, focus) {
		await this.attempt(async () => {
			await action();
			await this.show(focus);
		});
	}
	/** `focus`: what has the keyboard among the new rows, at once: the next key is meant for it. */
	async show(focus) {
		const projects = await this.keeper.projects();
		const none = h("li", { class: "note" }, "Nothing is kept yet.");
		fill(this.rows, ...projects.length === 0 ? [none] : projects.map((row) => this.row(row)));
		if (focus !== void 0) (this.rows.querySelector(`[data-testid="${focus()}"]`) ?? this.dialog.querySelector("button"))?.focus();
		await this.showRoom(projects);
	}
	async showRoom(projects) {
		const own = projects.reduce((sum, { bytes }) => sum + bytes, 0);
		const storage = navigator.storage;
		const { usage = 0, quota = 0 } = await storage?.estimate().catch(() => void 0) ?? {};
		const left = quota > usage ? ` About ${sizeText(quota - usage)} are left.` : "";
		const persisted = await storage?.persisted?.().catch(() => false) ?? false;
		this.stay.hidden = storage === void 0 || persisted || projects.length === 0;
		const may = persisted ? "" : " The browser may clear it where room is short.";
		this.room.textContent = `The projects take about ${sizeText(own)}.${left}${may}`;
	}
	async persist() {
		if (!await navigator.storage.persist()) throw new Error("the browser does not promise it: save what matters as a file");
		await this.show();
	}
	row(row) {
		const { id } = row;
		const title = titleOf(row);
		const current = id === this.keeper.keeping.state.project;
		const open = button(title, `project-open-${id}`, () => void this.leave(() => current ? Promise.resolve() : this.keeper.open(id)), "Open this project");
		open.className = "link";
		const facts = h("span", { class: "note" }, `${`${String(row.images.length)} ${row.images.length === 1 ? "image" : "images"}`} · ${sizeText(row.bytes)} · ${DATE.format(row.changed)}${current ? " · on the page" : ""}`);
		const named = (text, what, action) => {
			const made = button(text, `project-${what}-${id}`, action);
			made.setAttribute("aria-label", `${text}: ${title}`);
			return made;
		};
		const element = h("li", {
			testid: "project",
			...current ? { aria: { current: "true" } } : {}
		});
		const buttons = h("div", { class: "buttons" }, named("Rename", "rename", () => this.rename(element, row)), named("Duplicate", "duplicate", () => void this.change(() => this.keeper.duplicate(id, `${title} (copy)`), () => `project-duplicate-${id}`)), named("Save files", "save", () => void this.attempt(() => saveFiles(this.keeper, id, "tiepoint-project"))), named("Delete", "delete", () => this.confirm(element, row)));
		element.append(h("div", { class: "project-name" }, open, facts), buttons);
		return element;
	}
	rename(element, { id, ...row }) {
		const input = h("input", {
			type: "text",
			testid: "project-name",
			aria: { label: `New name of ${titleOf(row)}` }
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
		fill(element, input, h("div", { class: "buttons" }, button("Rename", "project-name-take", take), button("Cancel", "project-name-cancel", cancel)));
		input.focus();
		input.select();
	}
	confirm(element, row) {
		const keep = button("Keep", "project-keep", () => void this.change(() => Promise.resolve(), () => `project-delete-${row.id}`));
		const remove = button("Delete", "project-delete", () => void this.change(() => this.keeper.remove(row.id), () => ""));
		fill(element, h("p", { role: "alert" }, `Delete “${titleOf(row)}” with its images and results? This cannot be undone.`), h("div", { class: "buttons" }, remove, keep));
		keep.focus();
	}
};
// www/shared/panel/theme.ts
/** Light, dark, or as the system has it. */
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
			auto: "Theme: auto",
			light: "Theme: light",
			dark: "Theme: dark"
		}[theme] ?? "Theme";
	};
	const saved = keptChoice(NAME);
	show(saved !== null && saved in NEXT ? saved : "auto");
	button.addEventListener("click", () => {
		const theme = NEXT[document.documentElement.dataset.theme ?? "auto"] ?? "auto";
		show(theme);
		keepChoice(NAME, theme);
	});
}
// www/main.ts
/** So much of a project file says what it holds. */
var START_BYTES = 1024;
/** The module holds words and options of the page: its parts are made once it is there, and show what the browser has kept. */
async function start(opening, serveDrop) {
	const catalogue = await loadCatalogue();
	checkRules(catalogue.rules);
	byId("version").textContent = `Tiepoint ${catalogue.version}`;
	const pair = mountPair(catalogue, {
		openProject,
		toBlock,
		sampleBlock,
		putAside: (kept) => keeper.putAside(kept)
	});
	const ofBlocks = blockCatalogue(catalogue);
	const block = mountBlock(ofBlocks, (store, images) => void openPair(store, pair.store, pair.engine, images), openProject);
	/** What a file holds decides which part shows it; what is no project is refused by the part that it was given to. */
	async function openProject(file) {
		const mode = project_kind(new Uint8Array(await file.slice(0, START_BYTES).arrayBuffer())) ?? block.store.state.mode;
		block.store.dispatch({
			type: "mode",
			mode
		});
		await (mode === "pair" ? pair : block).open(file);
	}
	/** More images than two are a block. */
	function toBlock(files, masks) {
		block.store.dispatch({
			type: "mode",
			mode: "block"
		});
		block.give(files, masks);
	}
	function sampleBlock() {
		block.store.dispatch({
			type: "mode",
			mode: "block"
		});
		block.sample();
	}
	const keeper = new Keeper([block.kept, pair.kept], {
		now: () => block.store.state.mode,
		show: (kept) => {
			if (isMode(kept)) block.store.dispatch({
				type: "mode",
				mode: kept
			});
		}
	});
	mountProjects(keeper);
	await keeper.start(opening, () => {
		pair.store.dispatch({
			type: "ready",
			catalogue
		});
		block.store.dispatch({
			type: "ready",
			catalogue: ofBlocks
		});
	});
	pair.begin();
	serveDrop([block.taker, pair.taker]);
}
mountTheme(byId("theme"));
mountMenu(byId("menu"), byId("bar-menu"));
var opening = Database.open();
opening.catch(() => void 0);
start(opening, mountDrop()).catch((error) => {
	byId("answer").dataset.kind = "problem";
	byId("status").textContent = messageOf(error);
});
