(function() {
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
	function call_parameters() {
		return wasm.call_parameters();
	}
	function candidates(index, left_points, left_descriptors, right_points, right_descriptors, offset, options) {
		const ret = wasm.candidates(index, left_points, left_descriptors, right_points, right_descriptors, offset, options);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	function connected_groups(images, connections) {
		const ret = wasm.connected_groups(images, connections);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function constant_offset(dx, dy) {
		const ret = wasm.constant_offset(dx, dy);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function defaults() {
		return wasm.defaults();
	}
	function epipolar_line(from, x, y, model, interior, other_width, other_height) {
		const ret = wasm.epipolar_line(from, x, y, model, interior, other_width, other_height);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	function estimate_offset(left, right) {
		const ret = wasm.estimate_offset(left, right);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function execute_job(task, inputs) {
		const ret = wasm.execute_job(task, inputs);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	function export_formats() {
		return wasm.export_formats();
	}
	function film_frame(scan, film, wanted) {
		const ret = wasm.film_frame(scan, film, wanted);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function film_pixel_mm(film) {
		const ret = wasm.film_pixel_mm(film);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return ret[0];
	}
	function gradient_candidates(index, left_gradients, right_gradients, most) {
		const ret = wasm.gradient_candidates(index, left_gradients, right_gradients, most);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
		return v1;
	}
	function grey_png(width, height, grey, exif) {
		const ret = wasm.grey_png(width, height, grey, exif);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	function image_position(file) {
		const ret = wasm.image_position(file);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function interior(camera, photo) {
		const ret = wasm.interior(camera, photo);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function local_positions(geographic) {
		const ret = wasm.local_positions(geographic);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function match_photos(left, right, left_points, right_points, offset, interior, settings, nearest) {
		_assertClass(left, Photo);
		_assertClass(right, Photo);
		const ret = wasm.match_photos(left.__wbg_ptr, right.__wbg_ptr, left_points, right_points, offset, interior, settings, nearest);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function matches_csv(matches, rejected) {
		let deferred2_0;
		let deferred2_1;
		try {
			const ret = wasm.matches_csv(matches, rejected);
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
	function nearest_piece(left, first, end, right) {
		const ret = wasm.nearest_piece(left, first, end, right);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function open_pair_project(file) {
		const ret = wasm.open_pair_project(file);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function orient_fiducials(fiducials, model) {
		const ret = wasm.orient_fiducials(fiducials, model);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function orient_matches(matches, fits, interior, options, points) {
		const ret = wasm.orient_matches(matches, fits, interior, options, points);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function parallax_deviation(index, left_points, rules, places, offset, options) {
		const ret = wasm.parallax_deviation(index, left_points, rules, places, offset, options);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function parse_camera(json) {
		const ret = wasm.parse_camera(json);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function parse_fiducials(csv) {
		const ret = wasm.parse_fiducials(csv);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function photo_difference(left, right) {
		_assertClass(left, Photo);
		_assertClass(right, Photo);
		const ret = wasm.photo_difference(left.__wbg_ptr, right.__wbg_ptr);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function scaled_interior(interior, factor) {
		const ret = wasm.scaled_interior(interior, factor);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function score_matches(matches, left_points, right_position, left_width, left_height, right_width, right_height) {
		const ret = wasm.score_matches(matches, left_points, right_position, left_width, left_height, right_width, right_height);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function sha256(bytes) {
		const ret = wasm.sha256(bytes);
		if (ret[3]) throw takeFromExternrefTable0(ret[2]);
		var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
		wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
		return v1;
	}
	function simulate(flight) {
		const ret = wasm.simulate(flight);
		if (ret[2]) throw takeFromExternrefTable0(ret[1]);
		return takeFromExternrefTable0(ret[0]);
	}
	function write_pair_project(project) {
		let deferred2_0;
		let deferred2_1;
		try {
			const ret = wasm.write_pair_project(project);
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
	function initSync(module) {
		if (wasm !== unloaded) return wasm;
		if (module !== void 0) {
			if (Object.getPrototypeOf(module) === Object.prototype) ({module} = module);
			else console.warn("using deprecated parameters for `initSync()`; pass a single object instead");
		}
		const imports = __wbg_get_imports();
		if (!(module instanceof WebAssembly.Module)) module = new WebAssembly.Module(module);
		return __wbg_finalize_init(new WebAssembly.Instance(module, imports), module);
	}
	// pkg/block/jobs.js
	var jobs = { block: async ({ task, inputs }) => execute_job(task, inputs) };
	// pkg/block/wire.js
	function plainError(thrown) {
		if (typeof thrown !== "object" || thrown === null || !("message" in thrown)) return {
			name: "Error",
			message: String(thrown)
		};
		const { name, message, code, usage, error } = thrown;
		return {
			name: typeof name === "string" ? name : "Error",
			message: String(message),
			...typeof code === "string" && { code },
			...typeof usage === "boolean" && { usage },
			...typeof error === "object" && error !== null && { error }
		};
	}
	var errorOf = ({ message, ...fields }) => Object.assign(new Error(message), fields);
	// pkg/block/film.js
	var SAME_FILM = .01;
	var ROUNDING = 1e-9;
	function pixelOfFilm(focal_mm, pixel_mm, given) {
		const share = (own, wanted) => Math.abs(own / wanted - 1);
		return given.flatMap(({ focal_px, pixel_mm: own }) => typeof own === "number" && share(focal_px * own, focal_mm) <= ROUNDING && share(own, pixel_mm) <= SAME_FILM ? [own] : []).sort((a, b) => share(a, pixel_mm) - share(b, pixel_mm))[0] ?? pixel_mm;
	}
	// www/block/engine/film.ts
	function readFilm({ camera, marks }) {
		const scan = { fiducials: parse_fiducials(marks) };
		return camera === null ? { scan } : {
			camera: parse_camera(camera),
			scan
		};
	}
	function filmPlan({ films, given }) {
		const marks = new Map();
		for (const { x_mm: x, y_mm: y } of films.flatMap((film) => parse_fiducials(film.marks))) marks.set(`${String(x)},${String(y)}`, [x, y]);
		const largest = Math.max(...films.map((film) => film_pixel_mm(readFilm(film))));
		const focalMm = films.flatMap(({ camera }) => camera === null ? [] : [parse_camera(camera).focal_mm])[0];
		return {
			pixelMm: focalMm === void 0 ? largest : pixelOfFilm(focalMm, largest, given),
			marksMm: [...marks.values()]
		};
	}
	async function filmFrame({ file, film, plan, image, mask }) {
		const known = {
			...readFilm(film),
			marks_mm: plan.marksMm
		};
		const bytes = async (of) => new Uint8Array(await of.arrayBuffer());
		const hidden = mask === null ? null : {
			name: mask.name,
			file: await bytes(mask.file)
		};
		const made = film_frame(await bytes(file), known, {
			image,
			pixel_mm: plan.pixelMm,
			mask: hidden
		});
		const png = (of) => new Blob([of], { type: "image/png" });
		return {
			image: png(made.image),
			mask: png(made.mask),
			camera: made.camera,
			scan: made.scan
		};
	}
	// www/block/state/links.ts
	var USES = [
		"used",
		"check",
		"rejected"
	];
	function inColumns({ placement, ...image }, size) {
		return {
			...image,
			size,
			placement: placement === null ? null : {
				...placement,
				links: columnsOf(placement.links)
			}
		};
	}
	function columnsOf(links) {
		return {
			count: links.length,
			at: Float64Array.from(links.flatMap(({ at }) => at)),
			places: Float64Array.from(links.flatMap(({ place }) => place)),
			residuals: Float64Array.from(links.flatMap(({ residual_px: residual }) => residual ?? [NaN, NaN])),
			sigmas: Float64Array.from(links, ({ sigma_px: sigma }) => sigma ?? NaN),
			uses: Uint8Array.from(links, ({ role }) => USES.indexOf(role)),
			byHand: Uint8Array.from(links, ({ by_hand: byHand }) => byHand ? 1 : 0)
		};
	}
	// www/block/engine/orthophoto.ts
	var held$2 = null;
	async function opened$2({ picture, heights, keys }) {
		if (held$2?.keys.picture !== keys.picture) {
			held$2?.reference.free();
			held$2 = null;
			const reference = OrthophotoReference.open(inParts(picture.file), picture.sidecars);
			held$2 = {
				keys: {
					picture: keys.picture,
					heights: ""
				},
				reference,
				info: reference.info(),
				searched: ""
			};
		}
		if (held$2.keys.heights !== keys.heights) {
			const { reference } = held$2;
			if (typeof heights === "number") reference.set_heights(heights);
			else reference.set_heights(inParts(heights.file), heights.sidecars);
			held$2 = {
				keys,
				reference,
				info: reference.info(),
				searched: ""
			};
		}
		return held$2;
	}
	function inParts(file) {
		const reader = new FileReaderSync();
		return {
			size: file.size,
			read: (at, length) => new Uint8Array(reader.readAsArrayBuffer(file.slice(at, at + length)))
		};
	}
	async function bytesOf$1(file) {
		return new Uint8Array(await file.arrayBuffer());
	}
	async function orthoInfo(ground) {
		return (await opened$2(ground)).info;
	}
	async function orthoTile({ ground, level, column, row }) {
		const { info, reference } = await opened$2(ground);
		const step = 2 ** level;
		const [left, top] = [column * 256 * step, row * 256 * step];
		const width = Math.min(256, Math.ceil((info.width - left) / step));
		const height = Math.min(256, Math.ceil((info.height - top) / step));
		return bitmapOf$1(reference, [column * 256, row * 256], [width, height], level);
	}
	function bitmapOf$1(reference, [column, row], [width, height], halvings) {
		const colours = reference.colours(column, row, width, height, halvings);
		return createImageBitmap(new ImageData(new Uint8ClampedArray(colours.buffer, colours.byteOffset, colours.length), width, height));
	}
	async function orthoElsewhere({ ground, options, positions }) {
		return (await opened$2(ground)).reference.elsewhere(positions, options);
	}
	function imagePosition({ file }) {
		return image_position(inParts(file));
	}
	async function orthoSearch({ ground, options }) {
		const now = await opened$2(ground);
		const points = now.reference.search(options);
		now.searched = JSON.stringify(options);
		return points;
	}
	async function orthoReference(input) {
		const now = await opened$2(input.ground);
		if (now.searched !== JSON.stringify(input.options)) await orthoSearch(input);
		return now.reference;
	}
	async function orthoPlace({ ground, options, name, file, cameras, film, position }) {
		const reference = await orthoReference({
			ground,
			options
		});
		const bytes = await bytesOf$1(file);
		const placed = reference.place(name, bytes, cameras, film && readFilm(film), position);
		return inColumns(placed, sizeOf(placed, bytes));
	}
	function sizeOf({ placement }, file) {
		if (placement !== null) {
			const { width_px: width, height_px: height } = placement.film ?? placement.camera;
			return [width, height];
		}
		const photo = Photo.decode(file);
		const size = [photo.width, photo.height];
		photo.free();
		return size;
	}
	async function orthoAdjust({ ground, options, name, file, cameras, film, position, links, start, size }) {
		const { reference } = await opened$2(ground);
		const given = {
			links,
			placement: start,
			cameras,
			options,
			film: film && readFilm(film),
			position
		};
		return inColumns(reference.adjust(name, await bytesOf$1(file), given), size);
	}
	async function orthoPredict({ ground, placement, at, place }) {
		const { reference } = await opened$2(ground);
		const [x = NaN, y = NaN] = at === null ? reference.image_positions(placement, Float64Array.from(place ?? [])) : reference.ground_positions(placement, Float64Array.from(at));
		return Number.isNaN(x) ? null : [x, y];
	}
	async function orthoControl({ ground, options, place, number, crs, heights }) {
		const { reference } = await opened$2(ground);
		return reference.control_by_hand({
			place,
			number,
			crs,
			...heights,
			options
		});
	}
	async function orthoRectified({ ground, file, placement }) {
		const { reference } = await opened$2(ground);
		return reference.rectified(await bytesOf$1(file), placement);
	}
	async function orthoLaid({ ground, file, placement, side }) {
		const { reference } = await opened$2(ground);
		const laid = OrthophotoReference.open(reference.rectified(await bytesOf$1(file), placement));
		try {
			const { width, height, georeference } = laid.info();
			const halvings = Math.max(0, Math.ceil(Math.log2(Math.max(width, height) / side)));
			const step = 2 ** halvings;
			const [columns, rows] = [Math.floor(width / step), Math.floor(height / step)];
			return {
				bitmap: await bitmapOf$1(laid, [0, 0], [columns, rows], halvings),
				step,
				georeference
			};
		} finally {
			laid.free();
		}
	}
	var mosaic = null;
	var written = [];
	async function mosaicOpen({ project, heights, inAdjustment, gsd, images, names }) {
		mosaic?.free();
		mosaic = null;
		written = [];
		const model = typeof heights === "object" && heights !== null ? inParts(heights.file) : heights;
		const sidecars = typeof heights === "object" && heights !== null ? heights.sidecars : null;
		const made = OrthoMosaic.open(await bytesOf$1(project), model, sidecars, gsd ?? void 0, inAdjustment, images ?? void 0);
		mosaic = made;
		const own = made.names;
		const order = [...made.order()].map((index) => ({
			name: own[index] ?? "",
			index
		}));
		for (const { index } of order.filter(({ name }) => !names.includes(name))) write(made.leave_out(index));
		return {
			order: order.filter(({ name }) => names.includes(name)),
			remark: made.remark() ?? null
		};
	}
	async function mosaicAdd({ index, file }) {
		if (mosaic !== null) write(mosaic.add(index, await bytesOf$1(file)));
		return null;
	}
	function write(bytes) {
		if (bytes.length > 0) written.push(new Blob([bytes]));
	}
	function mosaicFinish() {
		const made = mosaic;
		mosaic = null;
		if (made === null) throw new Error("no mosaic is laid out");
		const { end, beginning } = made.finish();
		write(end);
		const rest = new Blob(written).slice(beginning.length);
		written = [];
		return new Blob([beginning, rest], { type: "image/tiff" });
	}
	function sceneOrthophoto({ flight, gsd }) {
		const scene = new BlockScene(flight);
		try {
			return scene.orthophoto(gsd);
		} finally {
			scene.free();
		}
	}
	// www/block/engine/block-links.ts
	var placing = null;
	async function linksOpen({ project, ground, options }) {
		const reference = await orthoReference({
			ground,
			options
		});
		const block = FinishedBlock.open(new Uint8Array(await project.arrayBuffer()));
		placing = {
			block,
			links: new BlockOnOrthophoto(),
			reference
		};
		return block.model().images.map(({ name, pose }) => pose == null ? null : name);
	}
	async function linksPlace({ index, file }) {
		const { block, links, reference } = opened$1();
		return links.place(block, index, new Uint8Array(await file.arrayBuffer()), reference);
	}
	function linksFinish() {
		const { block, links, reference } = opened$1();
		return new TextEncoder().encode(links.linked(block, reference).project());
	}
	function opened$1() {
		if (placing === null) throw new Error("no block is held");
		return placing;
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
	// www/shared/engine/tiles.ts
	function bitmapOf(grey, width, height) {
		const pixels = new Uint32Array(width * height);
		for (let i = 0; i < pixels.length; i++) pixels[i] = 4278190080 | (grey[i] ?? 0) * 65793;
		return createImageBitmap(new ImageData(new Uint8ClampedArray(pixels.buffer), width, height));
	}
	function tileOf(grey, width, height, level, column, row, side) {
		const step = 2 ** level;
		const left = column * side * step;
		const top = row * side * step;
		const columns = Math.min(side, Math.ceil((width - left) / step));
		const rows = Math.min(side, Math.ceil((height - top) / step));
		const tile = new Uint8Array(columns * rows);
		for (let r = 0; r < rows; r++) for (let c = 0; c < columns; c++) tile[r * columns + c] = blockMean(grey, width, height, left + c * step, top + r * step, step);
		return bitmapOf(tile, columns, rows);
	}
	function blockMean(grey, width, height, x, y, step) {
		const right = Math.min(x + step, width);
		const bottom = Math.min(y + step, height);
		let sum = 0;
		for (let row = y; row < bottom; row++) for (let col = x; col < right; col++) sum += grey[row * width + col] ?? 0;
		return Math.round(sum / ((right - x) * (bottom - y)));
	}
	function greyAt(grey, width, height, x, y) {
		const [px, py] = [Math.min(width - 1, Math.max(0, x - .5)), Math.min(height - 1, Math.max(0, y - .5))];
		const [col, row] = [Math.min(Math.floor(px), Math.max(0, width - 2)), Math.min(Math.floor(py), Math.max(0, height - 2))];
		const [right, below] = [Math.min(1, width - 1), height > 1 ? width : 0];
		const at = row * width + col;
		const [a = 0, b = 0, c = 0, d = 0] = [
			grey[at],
			grey[at + right],
			grey[at + below],
			grey[at + below + right]
		];
		const [fx, fy] = [px - col, py - row];
		return (a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy;
	}
	// www/block/engine/match.ts
	var SIDE = 81;
	function blockWindow({ file, at, turn }) {
		return file.arrayBuffer().then((bytes) => {
			const photo = Photo.decode(new Uint8Array(bytes));
			const { width, height } = photo;
			const grey = photo.grey();
			photo.free();
			const shift = turn === null ? [at[0] - Math.floor(at[0]) - .5, at[1] - Math.floor(at[1]) - .5] : [0, 0];
			const [ax, ay, bx, by] = turn ?? [
				1,
				0,
				0,
				1
			];
			const half = 40;
			return {
				grey: Uint8Array.from({ length: 6561 }, (_, i) => {
					const [u, v] = [i % SIDE - half - shift[0], Math.floor(i / SIDE) - half - shift[1]];
					return Math.round(greyAt(grey, width, height, at[0] + u * ax + v * bx, at[1] + u * ay + v * by));
				}),
				at: [40.5 + shift[0], 40.5 + shift[1]]
			};
		});
	}
	function blockFit({ left, right }) {
		const [first, second] = [left, right].map(({ grey }) => Photo.from_grey(SIDE, SIDE, grey));
		if (first === void 0 || second === void 0) return null;
		try {
			const { left: point, offset, settings } = fitInput(left.at, right.at, defaults());
			const found = placeOfFit(match_photos(first, second, { points: point }, { points: new Float64Array() }, offset, null, settings, void 0).matches);
			return found === null ? null : [found[0] - right.at[0], found[1] - right.at[1]];
		} finally {
			first.free();
			second.free();
		}
	}
	// pkg/block/photo.js
	var kept = null;
	function sceneOf(flight) {
		const key = JSON.stringify(flight);
		if (kept?.key !== key) {
			kept?.scene.free();
			kept = null;
			kept = {
				key,
				scene: new BlockScene(flight)
			};
		}
		return kept.scene;
	}
	function photoTruth(flight) {
		const truth = sceneOf(flight).truth();
		return {
			...truth,
			images: truth.images.map((image) => ({
				...image,
				name: `${image.name}.png`
			}))
		};
	}
	var photoFile = ({ flight, index }) => sceneOf(flight).photo_file(index);
	// www/block/engine/photo.ts
	function blockPlan(flight) {
		return photoTruth(flight);
	}
	function blockPhoto(job) {
		return photoFile(job);
	}
	// www/block/engine/grey.ts
	async function blockGrey({ file }) {
		const photo = Photo.decode(new Uint8Array(await file.arrayBuffer()));
		try {
			return await bitmapOf(photo.grey(), photo.width, photo.height);
		} finally {
			photo.free();
		}
	}
	// pkg/block/faults.js
	function breakdownOf(error) {
		const { name, message } = plainError(error);
		switch (name) {
			case "RuntimeError": return /unreachable/i.test(message) ? "memory" : "fault";
			case "RangeError": return /call stack/i.test(message) ? "fault" : "memory";
			case "WorkerError": return /memory/i.test(message) ? "memory" : "fault";
			case "Panic": return "fault";
			default: return null;
		}
	}
	// pkg/block/kind.js
	function kindOf(value) {
		if (value === null) return "null";
		return typeof value === "object" ? Object.prototype.toString.call(value).slice(8, -1) : typeof value;
	}
	// pkg/block/given.js
	var OPTIONS = [
		"settings",
		"cameras",
		"gps",
		"control",
		"masks",
		"strayMasks",
		"geoid",
		"positions",
		"onOrthophoto"
	];
	function checkGiven(sources, options, surroundings) {
		if (!isObject(options)) refuse("options", options, "object");
		const unknown = Object.keys(options).find((name) => !OPTIONS.includes(name));
		if (unknown !== void 0) refuseField(unknown);
		const { cameras, gps, masks, strayMasks, geoid, positions, onOrthophoto } = options;
		if (isGiven(cameras)) {
			if (!isObject(cameras)) refuse("cameras", cameras, "{ name, text }");
			checkType("cameras.text", cameras.text, "string");
		}
		if (gps !== void 0 && gps !== "use" && gps !== "ignore") refuse("gps", gps, "use, ignore");
		if (strayMasks !== void 0 && strayMasks !== "refuse" && strayMasks !== "list") refuse("strayMasks", strayMasks, "refuse, list");
		if (onOrthophoto !== void 0 && typeof onOrthophoto !== "boolean") refuse("onOrthophoto", onOrthophoto, "true, false");
		if (isGiven(positions)) checkType("positions", positions, "string");
		checkSources("images", sources);
		checkSources("masks", masks ?? []);
		if (isGiven(geoid)) checkSource("geoid", geoid);
		if (!isObject(surroundings)) refuse("surroundings", surroundings, "{ pool, store }");
		const { pool, store } = surroundings;
		if (typeof pool?.run !== "function") refuse("pool", pool, "{ size, run }");
		const allowed = allowedWorkers();
		if (!Number.isInteger(pool.size) || pool.size < allowed.min || pool.size > allowed.max) refuse("pool.size", pool.size, allowed);
		if (typeof store?.get !== "function" || typeof store.put !== "function") refuse("store", store, "{ get, put }");
	}
	function checkSources(field, sources) {
		if (!Array.isArray(sources)) refuse(field, sources, "[{ name, bytes }]");
		sources.forEach((source, index) => {
			checkSource(`${field}[${index}]`, source);
		});
	}
	function checkSource(field, source) {
		if (!isObject(source)) refuse(field, source, "{ name, bytes }");
		const { name, bytes } = source;
		checkType(`${field}.name`, name, "string");
		checkType(`${field}.bytes`, bytes, "function");
	}
	function checkType(field, value, type) {
		if (typeof value !== type) refuse(field, isObject(value) || !isGiven(value) ? value : `${shown(value)} (${typeof value})`, type);
	}
	function allowedWorkers() {
		const workers = call_parameters().find(({ key }) => key === "workers");
		if (workers?.kind !== "integer") throw new Error("the crate says no range of workers");
		return workers;
	}
	var isObject = (value) => typeof value === "object" && value !== null;
	var isGiven = (value) => value !== void 0 && value !== null;
	function refuse(field, got, allowed) {
		const words = typeof allowed === "string" ? {
			kind: "words",
			words: allowed
		} : {
			kind: "integer",
			min: allowed.min,
			max: allowed.max,
			odd: false
		};
		throwRefusal("invalid-option", {
			kind: "invalid-option",
			field,
			got: shown(got),
			allowed: words
		});
	}
	function refuseField(field) {
		throwRefusal("invalid-json", {
			kind: "invalid-json",
			document: {
				kind: "named",
				name: "options"
			},
			json_fault: {
				kind: "value",
				field,
				json_slip: {
					kind: "unknown_field",
					known: OPTIONS.join(", ")
				},
				line: null,
				column: null
			}
		});
	}
	function throwRefusal(code, error) {
		throw errorOf({
			name: "TiepointError",
			message: message$1("error", error),
			code,
			usage: true,
			error
		});
	}
	function shown(value) {
		if (!isGiven(value)) return null;
		if (Array.isArray(value)) return `[${value.length}]`;
		if (!isObject(value)) return String(value);
		return kindOf(value) === "Object" ? `{ ${Object.keys(value).join(", ")} }` : kindOf(value);
	}
	// pkg/block/own-bytes.js
	function ownBytes(given) {
		switch (kindOf(given)) {
			case "Uint8Array":
			case "Uint8ClampedArray": {
				const { buffer, byteOffset, byteLength } = given;
				const bytes = new Uint8Array(buffer, byteOffset, byteLength);
				return kindOf(buffer) === "SharedArrayBuffer" ? bytes.slice() : bytes;
			}
			case "ArrayBuffer": return new Uint8Array(given);
			default: {
				const error = {
					kind: "invalid-argument",
					what: "bytes",
					got: kindOf(given),
					wanted: "Uint8Array"
				};
				throw new TypeError(message$1("error", error));
			}
		}
	}
	// pkg/block/timed.js
	function timed(width) {
		let last = null;
		let began = 0;
		return ({ stage, done, total, found, name }) => {
			if (stage !== last) [last, began] = [stage, performance.now()];
			const seconds = (performance.now() - began) / 1e3;
			const made = done - found;
			const left = made >= 2 * width || made > 0 && done === total ? { secondsLeft: seconds / made * (total - done) } : {};
			return {
				stage,
				done,
				total,
				found,
				seconds,
				...name && { name },
				...left
			};
		};
	}
	// pkg/block/run.js
	async function runBlock(sources, options, surroundings) {
		checkGiven(sources, options, surroundings);
		const { settings = {}, cameras, gps, control, geoid, positions, onOrthophoto = false, strayMasks } = options;
		const masks = options.masks ?? [];
		const { pool, progress, news, signal } = surroundings;
		const names = (files) => files.map(({ name }) => name);
		const run = new Run({
			images: names(sources),
			masks: names(masks),
			settings,
			cameras: cameras?.text ?? null,
			use_gnss: gps !== "ignore",
			control: control ?? null,
			...geoid && { geoid: geoid.name },
			...positions !== void 0 && positions !== null && { positions },
			on_orthophoto: onOrthophoto,
			refuse_stray_masks: strayMasks !== "list"
		});
		const width = pool.size + 1;
		const step = timed(width);
		const tell = () => {
			for (const found of run.news()) if (found.kind === "step") progress?.(step(found));
			else news?.(found);
		};
		const underway = new Set();
		let failure = null;
		const perform = (job) => {
			const done = performed(job, run, {
				image: sources,
				mask: masks,
				geoid: geoid ? [geoid] : []
			}, surroundings).catch((error) => {
				failure ??= { error };
			}).finally(() => underway.delete(done));
			underway.add(done);
		};
		try {
			for (;;) {
				if (signal?.aborted) throw signal.reason;
				run.next(width - underway.size).forEach(perform);
				tell();
				if (underway.size === 0) break;
				await Promise.race(underway);
				if (failure) throw failure.error;
			}
		} catch (error) {
			await Promise.all(underway);
			if (breakdownOf(error) === null) run.free();
			throw error;
		}
		return run.finish();
	}
	async function performed({ id, files: needed }, run, files, { pool, store }) {
		let inputs;
		try {
			inputs = await Promise.all(needed.map(async ({ kind, index }) => ownBytes(await files[kind][index].bytes())));
		} catch (error) {
			return run.failed(id, {
				kind: "unreadable",
				message: plainError(error).message
			});
		}
		const { key, task, records, input } = run.prepare(id, await Promise.all(inputs.map(digest)));
		const kept = key === null ? null : await store.get(key);
		if (kept && run.found(id, kept)) return;
		for (const place of records) {
			const record = await store.get(place);
			if (!record) return run.failed(id, {
				kind: "refused",
				code: "unreadable-file",
				message: `the kept record ${place} was removed while the run went on: start the run again`,
				usage: false
			});
			inputs.push(record);
		}
		if (input) inputs.push(input);
		if (task === null) return run.complete(id, inputs[0] ?? new Uint8Array());
		let output;
		try {
			output = await pool.run("block", {
				task,
				inputs
			}, input ? [input.buffer] : []);
		} catch (error) {
			return run.failed(id, failureOf$1(error));
		}
		if (key !== null) await store.put(key, output);
		run.complete(id, output);
	}
	async function digest(bytes) {
		const own = globalThis.crypto?.subtle;
		const sum = own ? new Uint8Array(await own.digest("SHA-256", bytes)) : sha256(bytes);
		return Array.from(sum, (byte) => byte.toString(16).padStart(2, "0")).join("");
	}
	function failureOf$1(error) {
		const { name, message, code = "", usage = false, error: refusal } = plainError(error);
		if (name === "TiepointError") return {
			kind: "refused",
			code,
			message,
			usage,
			...refusal && { error: refusal }
		};
		const breakdown = breakdownOf(error);
		if (breakdown === null) throw error;
		return {
			kind: breakdown === "memory" ? "out_of_memory" : "broke_off",
			message
		};
	}
	// www/shared/choices.ts
	function keptChoice(name) {
		try {
			return localStorage.getItem(name);
		} catch {
			return null;
		}
	}
	// www/shared/text/language.ts
	var LANGUAGES = {
		en: {
			name: "English",
			direction: "ltr"
		},
		ar: {
			name: "العربية",
			direction: "rtl"
		}
	};
	var NAME = "tiepoint-language";
	function isLanguage(tag) {
		return typeof tag === "string" && Object.hasOwn(LANGUAGES, tag);
	}
	var LANGUAGE = typeof document === "undefined" ? told() : preferred(keptChoice(NAME), navigator.languages);
	function told() {
		const tag = String(globalThis.name ?? "").split(" ").at(-1);
		return isLanguage(tag) ? tag : "en";
	}
	function preferred(chosen, liked) {
		if (isLanguage(chosen)) return chosen;
		return liked.map((tag) => tag.split("-")[0]).find(isLanguage) ?? "en";
	}
	// www/shared/text/direction.ts
	var IS_FROM_RIGHT = LANGUAGES[LANGUAGE].direction === "rtl";
	var [LRI, RLI, PDI] = [
		"⁦",
		"⁧",
		"⁩"
	];
	var FSI = "⁨";
	var ISOLATE = /[\u2066-\u2068]/u;
	var LETTER = /\p{L}/u;
	var FROM_RIGHT = /\p{Script=Arabic}/u;
	var NUMBER = /\u2068([^\u2066-\u2069]+)\u2069(°?)/u.source;
	var WITH_ERROR = new RegExp(`${NUMBER}([ \\u00a0]±[ \\u00a0])${NUMBER}`, "gu");
	function asClauses(text, isFromRight = IS_FROM_RIGHT) {
		if (!isFromRight) return text;
		return ofParts(text.replaceAll(WITH_ERROR, `${LRI}$1$2$3$4$5${PDI}`).replaceAll(`${PDI}°`, `°${PDI}`).replaceAll(/\u2068(?=[\u2067\u2068]*[\s،؛,;:·(])/gu, RLI));
	}
	function ofParts(text) {
		const letters = [...text];
		const open = [];
		letters.forEach((letter, at) => {
			const part = open.at(-1);
			if (ISOLATE.test(letter)) open.push({
				at,
				isOwn: false,
				hasWords: false
			});
			else if (letter === PDI && part !== void 0) {
				open.pop();
				if (letters[part.at] === FSI && !part.isOwn && part.hasWords) letters[part.at] = RLI;
			} else if (part !== void 0 && LETTER.test(letter)) {
				part.isOwn = true;
				if (FROM_RIGHT.test(letter)) for (const around of open) around.hasWords = true;
			}
		});
		return letters.join("");
	}
	// www/shared/text/format.ts
	function count(value) {
		return value == null ? "–" : String(value).replace(/\B(?=(\d{3})+$)/gu, " ");
	}
	function grouped(text) {
		return text.replaceAll(/(?<![\p{L}\d_.,−-])\d{4,}(?![\p{L}\d_-]|[.,]\d|\.\p{L})/gu, (digits) => count(Number(digits)));
	}
	function withMinus(text) {
		return text.replaceAll(/(?<![\p{L}\p{N}_.,)−-])-(?=\d)/gu, "−");
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
	// www/block/engine/layout.ts
	var MOST_STEPS = 2e8;
	function layoutOf(centres, recordings, connections) {
		const oriented = centres.map((centre) => centre?.slice(0, 2) ?? null);
		if (oriented.some((place) => place !== null)) return {
			kind: "oriented",
			places: completed(oriented, connections)
		};
		const recorded = recordedPlaces(recordings);
		if (2 * recorded.filter((place) => place !== null).length > centres.length) return {
			kind: "recorded",
			places: completed(recorded, connections)
		};
		return {
			kind: "connections",
			places: arranged(centres.length, connections)
		};
	}
	function recordedPlaces(recordings) {
		const geographic = recordings.flatMap((position) => position === null ? [
			NaN,
			NaN,
			NaN
		] : [
			position.longitude_deg,
			position.latitude_deg,
			position.height_m ?? 0
		]);
		const local = local_positions(Float64Array.from(geographic));
		return recordings.map((_, i) => {
			const place = [...local.subarray(3 * i, 3 * i + 2)];
			return place.every(Number.isFinite) ? place : null;
		});
	}
	function completed(places, connections) {
		const step = usualStep(places);
		const means = meansOfNeighbours(places, connections);
		const taken = new Set(places.flatMap((place) => place === null ? [] : [cellOf(place, step)]));
		const found = places.map((place, i) => place ?? (means[i] == null ? null : freePlace(means[i], step, taken)));
		const apart = placesApart(found, step);
		return Float64Array.from(found.flatMap((place) => place ?? apart.next().value ?? [0, 0]));
	}
	function usualStep(places) {
		const { low, high, count } = extentOf(places);
		const span = Math.max(high[0] - low[0], high[1] - low[1]);
		return span > 0 ? span / Math.ceil(Math.sqrt(count)) : 1;
	}
	function extentOf(places) {
		const low = [Infinity, Infinity];
		const high = [-Infinity, -Infinity];
		let count = 0;
		for (const place of places) {
			if (place === null) continue;
			count += 1;
			for (const axis of [0, 1]) {
				low[axis] = Math.min(low[axis], place[axis] ?? 0);
				high[axis] = Math.max(high[axis], place[axis] ?? 0);
			}
		}
		return {
			low,
			high,
			count
		};
	}
	function meansOfNeighbours(places, connections) {
		const sums = places.map(() => ({
			x: 0,
			y: 0,
			count: 0
		}));
		for (const { images: [a, b], outcome } of connections) {
			if (outcome.kind !== "connected") continue;
			for (const [of, from] of [[a, b], [b, a]]) {
				const [place, sum] = [places[from], sums[of]];
				if (place == null || sum === void 0) continue;
				sum.x += place[0] ?? 0;
				sum.y += place[1] ?? 0;
				sum.count += 1;
			}
		}
		return sums.map(({ x, y, count }) => count === 0 ? null : [x / count, y / count]);
	}
	var CELLS = 3;
	var cellOf = ([x = 0, y = 0], step) => `${String(Math.round(CELLS * x / step))} ${String(Math.round(CELLS * y / step))}`;
	function freePlace([x, y], step, taken) {
		let place = [x, y];
		for (let k = 1; taken.has(cellOf(place, step)); k++) place = [x - k * step / CELLS, y - k * step / CELLS];
		taken.add(cellOf(place, step));
		return place;
	}
	var LEAST_COLUMN = 4;
	function* placesApart(known, step) {
		const { low } = extentOf(known);
		const rows = Math.max(LEAST_COLUMN, Math.ceil(Math.sqrt(known.filter((place) => place === null).length)));
		for (let k = 0;; k++) yield [low[0] - (1 + Math.floor(k / rows)) * step, low[1] - (.5 + k % rows) * step];
	}
	function arranged(count, connections) {
		const places = Float64Array.from({ length: 2 * count }, (_, i) => {
			const angle = 2 * Math.PI * Math.floor(i / 2) / Math.max(1, count);
			return (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle)) * Math.sqrt(count);
		});
		const edges = connections.filter(({ outcome }) => outcome.kind === "connected");
		const rounds = Math.min(300, Math.floor(MOST_STEPS / (count * count + edges.length + 1)));
		const moves = new Float64Array(2 * count);
		for (let round = 0; round < rounds; round++) {
			moves.fill(0);
			for (let a = 0; a < count; a++) for (let b = a + 1; b < count; b++) push(places, moves, a, b, (d) => 1 / Math.max(d, .001));
			for (const { images: [a, b], shared, outcome } of edges) {
				const strength = Math.min(1, Math.max(shared, "matches" in outcome ? outcome.matches : 0) / 200);
				push(places, moves, a, b, (d) => -strength * d * d);
			}
			const heat = .3 * Math.sqrt(count) * (1 - round / rounds);
			for (let i = 0; i < count; i++) {
				const [x = 0, y = 0] = moves.subarray(2 * i, 2 * i + 2);
				const share = Math.min(1, heat / Math.max(Math.hypot(x, y), 1e-9));
				places[2 * i] = (places[2 * i] ?? 0) + share * x;
				places[2 * i + 1] = (places[2 * i + 1] ?? 0) + share * y;
			}
		}
		return places;
	}
	function push(places, moves, a, b, force) {
		const x = (places[2 * a] ?? 0) - (places[2 * b] ?? 0);
		const y = (places[2 * a + 1] ?? 0) - (places[2 * b + 1] ?? 0);
		const distance = Math.hypot(x, y);
		const by = force(distance) / Math.max(distance, .001);
		moves[2 * a] = (moves[2 * a] ?? 0) + by * x;
		moves[2 * a + 1] = (moves[2 * a + 1] ?? 0) + by * y;
		moves[2 * b] = (moves[2 * b] ?? 0) - by * x;
		moves[2 * b + 1] = (moves[2 * b + 1] ?? 0) - by * y;
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
	// www/block/state/selection.ts
	function keyOfPair([a, b]) {
		return a < b ? `${String(a)},${String(b)}` : `${String(b)},${String(a)}`;
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
	// www/block/engine/outcome.ts
	function viewOf(block) {
		const onOrthophoto = block.on_orthophoto();
		const { images, skipped, unused_masks, unknown_images, remarks, cameras, pairs, groups, found, refinement, by_rays, oriented, rmse_px, sigma0_px, warnings, verdict, components, checks, surveyed, given_control: givenControl, origin, crs, geoid_m, geoid, points } = block.overview();
		const connections = pairs.map(connectionOf);
		const ids = block.point_ids();
		const added = new Set(block.edits().flatMap((edit) => edit.kind === "add_control" ? [edit.name] : []));
		const controls = ids.flatMap((id, point) => "ground_control" in id ? [{
			control: id.ground_control,
			point
		}] : []);
		return {
			partial: false,
			images: images.map(({ name, width_px: width, height_px: height, camera, features, positions: places, observations: rays, rmse_px: rmsePx, is_oriented, position, exif_orientation: exifOrientation, reason: why }) => ({
				name,
				width,
				height,
				camera,
				features,
				places,
				rays,
				rmsePx,
				oriented: is_oriented,
				position,
				exifOrientation,
				why: why === null ? "" : message("image_reason", why)
			})),
			leftOut: skipped.map(({ name, reason }) => ({
				name,
				reason: message("failure", reason)
			})),
			strayMasks: unused_masks,
			strayMarks: unknown_images,
			remarks: remarks.map((remark) => message("remark", remark)),
			cameras: cameras.map(({ label, images: count, given, calibrated, focal_error_px: focalErrorPx }) => ({
				label,
				images: count,
				given,
				calibrated,
				focalErrorPx
			})),
			connections,
			groups,
			layout: layoutOf(images.map(({ position }) => position), images.map(({ gnss }) => gnss), connections),
			points: {
				count: points.rays.length,
				taking: points.rays.length,
				lost: new Set(),
				sources: Float64Array.from(ids, codeOfSource),
				numbers: points.numbers,
				rays: points.rays,
				rmsePx: points.rmse_px,
				positions: points.positions,
				errors: points.errors,
				confidence: points.confidence
			},
			found,
			refinement,
			byRays: by_rays.map(({ rays, points: count, rmse_px: rmsePx }) => ({
				rays,
				points: count,
				rmsePx
			})),
			oriented,
			verdict: {
				kind: verdict.kind,
				text: message("block_verdict", verdict)
			},
			orthophoto: onOrthophoto === null ? null : {
				kind: onOrthophoto.kind,
				inCrs: onOrthophoto.kind !== "not_linked" && onOrthophoto.in_crs === true,
				text: message("on_orthophoto", onOrthophoto)
			},
			origin,
			crs,
			system: remarks.find((remark) => remark.kind === "result_system")?.crs ?? null,
			geoidM: geoid_m,
			geoid,
			rmsePx: rmse_px,
			sigma0Px: sigma0_px,
			components,
			checks,
			surveyed: surveyed.map((known, i) => ({
				...known,
				...controls[i] ?? {
					control: -1,
					point: -1
				},
				isUsed: known.refused?.is_used ?? true,
				byHand: added.has(known.name)
			})),
			givenControl,
			score: null,
			warnings: warnings.map((warning) => message("overview_warning", warning)),
			formats: export_formats()
		};
	}
	function viewOfParts(read, connections, geometries) {
		const own = read.map(({ camera }) => JSON.stringify(camera));
		const kinds = [...new Set(own)];
		const cameras = kinds.map((kind) => read[own.indexOf(kind)]?.camera).filter((camera) => camera !== void 0);
		const links = connections.map((connection, i) => ({
			...connection,
			reason: message("connection", connection),
			geometry: geometryOf(geometries[i] ?? null),
			shared: 0,
			chosen: 0,
			rejected: false
		}));
		const none = new Float64Array();
		return {
			partial: true,
			images: read.map(({ name, width_px: width, height_px: height, features, exif }, i) => ({
				name,
				width,
				height,
				camera: kinds.indexOf(own[i] ?? ""),
				features,
				places: null,
				rays: 0,
				rmsePx: null,
				oriented: false,
				position: null,
				exifOrientation: exif.orientation,
				why: null
			})),
			leftOut: [],
			strayMasks: [],
			strayMarks: [],
			remarks: [],
			cameras: cameras.map(({ label, fixed: _, focal_px, ...camera }, i) => ({
				label,
				images: own.filter((kind) => kind === kinds[i]).length,
				given: focal_px === null ? null : {
					...camera,
					focal_px
				},
				calibrated: null,
				focalErrorPx: null
			})),
			connections: links,
			groups: connected_groups(read.length, [...connections]),
			layout: layoutOf(read.map(() => null), read.map(({ exif, given }) => given?.position ?? exif.position), links),
			points: {
				count: 0,
				taking: 0,
				lost: new Set(),
				sources: none,
				numbers: new Uint32Array(),
				rays: new Uint16Array(),
				rmsePx: none,
				positions: none,
				errors: none,
				confidence: none
			},
			found: null,
			refinement: null,
			byRays: [],
			oriented: 0,
			verdict: null,
			orthophoto: null,
			origin: null,
			crs: null,
			geoidM: null,
			rmsePx: null,
			sigma0Px: null,
			components: [],
			checks: null,
			surveyed: [],
			givenControl: 0,
			score: null,
			warnings: [],
			formats: export_formats()
		};
	}
	function connectionOf({ images, rule, outcome, geometry, common_points: shared, chosen_points: chosen, rejected_by_hand: rejected }) {
		return {
			images,
			rule,
			outcome,
			reason: message("connection", {
				images,
				rule,
				outcome
			}),
			geometry: geometryOf(geometry),
			shared,
			chosen,
			rejected
		};
	}
	function geometryOf(geometry) {
		if (geometry === null) return null;
		const { model, degenerate, sigma_px: sigmaPx } = geometry;
		return {
			kind: model.kind,
			degenerate,
			sigmaPx
		};
	}
	// www/block/engine/coming.ts
	var PAUSE_MS = 250;
	var SHARE = .05;
	var Coming = class {
		show;
		images = new Map();
		leftOut = [];
		connections = [];
		geometries = [];
		nextAt = 0;
		timer = null;
		constructor(show) {
			this.show = show;
		}
		take(news) {
			if (news.kind === "image") this.images.set(news.index, news);
			else if (news.kind === "skipped") {
				this.leftOut.push({
					name: news.name,
					reason: news.reason
				});
				for (const [index, { name }] of this.images) if (name === news.name) this.images.delete(index);
			} else {
				this.connections.push(news.connection);
				this.geometries.push(news.geometry);
			}
			this.timer ??= setTimeout(() => {
				this.timer = null;
				const began = performance.now();
				this.tell();
				const ended = performance.now();
				this.nextAt = ended + Math.max(PAUSE_MS, (ended - began) / SHARE);
			}, Math.max(0, this.nextAt - performance.now()));
		}
		tell() {
			if (this.images.size > 0) this.show(this.view());
		}
		end() {
			if (this.timer !== null) clearTimeout(this.timer);
		}
		view() {
			return {
				...viewOfParts([...this.images].sort(([a], [b]) => a - b).map(([, image]) => image), this.connections, this.geometries),
				leftOut: this.leftOut
			};
		}
	};
	function median(values) {
		const sorted = Float64Array.from(values).sort();
		return sorted[Math.floor(sorted.length / 2)] ?? NaN;
	}
	// www/block/engine/ground.ts
	var FARTHEST = 12;
	function groundOf(block) {
		const model = block.model();
		const heights = heightsOf(model);
		const depths = depthsOf(model);
		const count = model.images.length;
		const footprints = new Float64Array(8 * count).fill(NaN);
		const gsd = new Float64Array(count).fill(NaN);
		model.images.forEach(({ camera: index, pose }, i) => {
			const camera = model.cameras[index];
			if (pose == null || camera === void 0) return;
			footprints.set(footprintOf(camera, pose, heights[i] ?? NaN), 8 * i);
			gsd[i] = (depths[i] ?? NaN) / camera.focal_px;
		});
		return {
			footprints,
			gsd,
			gnss: gnssOf(block, model),
			origin: model.origin ?? null
		};
	}
	function heightsOf({ images, points }) {
		const own = images.map(() => []);
		const all = [];
		for (const { position, rays } of points) {
			if (position == null) continue;
			all.push(position[2]);
			for (const { image } of rays) own[image]?.push(position[2]);
		}
		const usual = median(all);
		return Float64Array.from(own, (heights) => heights.length === 0 ? usual : median(heights));
	}
	function depthsOf({ images, points }) {
		const own = images.map(() => []);
		for (const { position, rays } of points) {
			if (position == null) continue;
			for (const { image } of rays) {
				const pose = images[image]?.pose;
				if (pose != null) own[image]?.push(Math.abs(depthOf(pose, position)));
			}
		}
		return Float64Array.from(own, median);
	}
	function depthOf({ rotation, position: centre }, position) {
		return rotation[2].reduce((sum, value, axis) => sum + value * ((position[axis] ?? 0) - (centre[axis] ?? 0)), 0);
	}
	function footprintOf({ width_px: width, height_px: height, focal_px: focal, principal_point_px: [cx, cy] }, { rotation, position }, ground) {
		const places = [
			[0, 0],
			[width, 0],
			[width, height],
			[0, height]
		].flatMap(([column, row]) => {
			const photo = [
				column - cx,
				cy - row,
				-focal
			];
			const [x = 0, y = 0, z = 0] = [
				0,
				1,
				2
			].map((axis) => rotation.reduce((sum, line, i) => sum + (line[axis] ?? 0) * (photo[i] ?? 0), 0));
			const along = (ground - position[2]) / z;
			return along > 0 && Math.hypot(x, y) < FARTHEST * Math.abs(z) ? [position[0] + along * x, position[1] + along * y] : [NaN, NaN];
		});
		return places.some(Number.isNaN) ? places.map(() => NaN) : places;
	}
	function gnssOf(block, { origin, images }) {
		if (origin == null) return new Float64Array(3 * images.length).fill(NaN);
		const recorded = block.overview().images.flatMap(({ gnss }) => gnss === null ? [
			NaN,
			NaN,
			NaN
		] : [
			gnss.longitude_deg,
			gnss.latitude_deg,
			gnss.height_m ?? NaN
		]);
		return local_positions(Float64Array.from([
			origin.longitude_deg,
			origin.latitude_deg,
			origin.height_m,
			...recorded
		])).subarray(3);
	}
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
	function deflateSync(data, opts) {
		return dopt(data, opts || {}, 0, 0);
	}
	var fltn = function(d, p, t, o) {
		for (var k in d) {
			var val = d[k], n = p + k, op = o;
			if (Array.isArray(val)) op = mrg(o, val[1]), val = val[0];
			if (ArrayBuffer.isView(val)) t[n] = [val, op];
			else {
				t[n += "/"] = [new u8(0), op];
				fltn(val, n, t, o);
			}
		}
	};
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
	function zipSync(data, opts) {
		if (!opts) opts = {};
		var r = {};
		var files = [];
		fltn(data, "", r, opts);
		var o = 0;
		var tot = 0;
		for (var fn in r) {
			var _a = r[fn], file = _a[0], p = _a[1];
			var compression = p.level == 0 ? 0 : 8;
			var f = strToU8(fn), s = f.length;
			var com = p.comment, m = com && strToU8(com), ms = m && m.length;
			var exl = exfl(p.extra);
			if (s > 65535) err(11);
			var d = compression ? deflateSync(file, p) : file, l = d.length;
			var c = crc();
			c.p(file);
			files.push(mrg(p, {
				size: file.length,
				crc: c.d(),
				c: d,
				f,
				m,
				u: s != fn.length || m && com.length != ms,
				o,
				compression
			}));
			o += 30 + s + exl + l;
			tot += 76 + 2 * (s + exl) + (ms || 0) + l;
		}
		var out = new u8(tot + 22), oe = o, cdl = tot - o;
		for (var i = 0; i < files.length; ++i) {
			var f = files[i];
			wzh(out, f.o, f, f.f, f.u, f.c.length);
			var badd = 30 + f.f.length + exfl(f.extra);
			out.set(f.c, f.o + badd);
			wzh(out, o, f, f.f, f.u, f.c.length, f.o, f.m), o += 16 + badd + (f.m ? f.m.length : 0);
		}
		wzf(out, o, files.length, cdl, oe);
		return out;
	}
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
	// www/block/engine/made.ts
	async function made(block, kind, name, signal) {
		const files = new Map();
		const write = (path, text) => files.set(path, text);
		if (kind === "project") write(`${name}-project.tiepoint`, block.project());
		else if (kind === "everything") await inSteps(block.files(export_formats(), null, LANGUAGE), write, signal);
		else if (kind === "csv") await inSteps(block.files([], null, LANGUAGE), tablesTo(write), signal, () => files.size > 0);
		else block.export(kind, write);
		return packed(files, `${name}-${kind}`, signal);
	}
	function tablesTo(write) {
		return (path, text) => {
			if (path.endsWith(".csv")) write(path, text);
		};
	}
	async function inSteps(writing, write, signal, isDone = () => false) {
		try {
			while (writing.step(write) === null && !isDone()) await pause(signal);
		} finally {
			writing.free();
		}
	}
	async function pause(signal) {
		await new Promise((resolve) => setTimeout(resolve));
		signal.throwIfAborted();
	}
	async function packed(files, name, signal) {
		const encoder = new TextEncoder();
		const [first, ...others] = files;
		if (first === void 0) throw new Error("the block gives no file in this format");
		const [path, text] = first;
		if (others.length === 0) {
			const plain = path.split("/").at(-1) ?? path;
			return {
				name: plain.startsWith(name.replace(/-[^-]*$/u, "")) ? plain : `${name}-${plain}`,
				type: "text/plain",
				bytes: encoder.encode(text)
			};
		}
		const archive = new Archive();
		for (const [at, content] of files) {
			await pause(signal);
			archive.add(at, encoder.encode(content), false);
		}
		return {
			name: `${name}.zip`,
			type: "application/zip",
			bytes: new Uint8Array(await archive.end().arrayBuffer())
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
	// www/block/engine/rejected.ts
	var REJECTED = 1;
	var BY_HAND = 2;
	var Found = class {
		block;
		givenControl;
		sources;
		places;
		columns;
		surveyed;
		constructor(block, surveyed, givenControl) {
			this.block = block;
			this.givenControl = givenControl;
			this.sources = block.point_ids();
			this.places = new Map(this.sources.map((id, point) => [codeOfSource(id), point]));
			this.columns = block.overview().points;
			this.surveyed = new Map(surveyed.map((known) => [known.control, known]));
		}
		indexOf(code) {
			return this.places.get(code) ?? -1;
		}
		column(name, index) {
			return this.columns[name][index] ?? NaN;
		}
		surveyedPoint(control) {
			return this.surveyed.get(control);
		}
	};
	var Rejected = class {
		found;
		edits;
		taking;
		gone;
		byHand;
		byIndex;
		constructor(found, edits, taking, sources) {
			this.found = found;
			this.edits = edits;
			this.taking = taking;
			const { points, unused, observations } = standingOf(edits);
			const named = [
				...points.values(),
				...[...unused].map((control) => ({ ground_control: control })),
				...[...observations.values()].map(({ point }) => point)
			];
			const rejected = new Set(named.map(codeOfSource));
			const has = new Set(sources);
			const codes = new Map([...named, ...tiePoints(found, edits)].map((source) => [codeOfSource(source), source]));
			this.gone = [...codes].filter(([code]) => !has.has(code)).map(([code, source]) => ({
				source,
				isLost: !rejected.has(code),
				index: found.indexOf(code)
			}));
			this.byHand = measuredByHand(edits);
			this.byIndex = new Map(this.gone.flatMap(({ index }, place) => index < 0 ? [] : [[index, place]]));
		}
		inView(view) {
			const { gone, taking, found } = this;
			if (gone.length === 0) return view;
			const { points } = view;
			const all = {
				...points,
				count: taking + gone.length,
				lost: new Set(gone.flatMap(({ isLost }, place) => isLost ? [taking + place] : [])),
				sources: longer(points.sources, gone.length),
				numbers: longer(points.numbers, gone.length),
				rays: longer(points.rays, gone.length),
				rmsePx: longer(points.rmsePx, gone.length),
				positions: longer(points.positions, 3 * gone.length),
				errors: longer(points.errors, 3 * gone.length),
				confidence: longer(points.confidence, gone.length)
			};
			gone.forEach(({ source, index }, place) => {
				const at = taking + place;
				all.sources[at] = codeOfSource(source);
				all.numbers[at] = index < 0 ? found.block.point_number(source) ?? 0 : found.column("numbers", index);
				all.rays[at] = index < 0 ? this.handsOf(source).size : found.column("rays", index);
				all.rmsePx[at] = NaN;
				all.confidence[at] = index < 0 ? 1 : found.column("confidence", index);
				const met = index < 0 ? this.meetingOf(source) : null;
				for (const axis of [
					0,
					1,
					2
				]) {
					all.positions[3 * at + axis] = index < 0 ? met?.[axis] ?? NaN : found.column("positions", 3 * index + axis);
					all.errors[3 * at + axis] = NaN;
				}
			});
			return {
				...view,
				points: all,
				surveyed: [...view.surveyed, ...this.surveyed(taking)]
			};
		}
		inImage(of, image) {
			const { gone, byIndex, taking } = this;
			if (gone.length === 0) return of;
			const found = new Map();
			const before = this.found.block.image_points(image);
			before.points.forEach((index, row) => {
				const place = byIndex.get(index);
				if (place !== void 0) found.set(place, [before.places[2 * row] ?? NaN, before.places[2 * row + 1] ?? NaN]);
			});
			gone.forEach(({ source }, place) => {
				const own = this.handsOf(source).get(image);
				if (own !== void 0) found.set(place, [own.x_px, own.y_px]);
			});
			const points = [...found.keys()];
			const places = [...found.values()].flat();
			const rows = of.points.length;
			const all = {
				points: longer(of.points, points.length),
				places: longer(of.places, places.length),
				residuals: longer(of.residuals, places.length).fill(NaN, 2 * rows),
				redundancy: longer(of.redundancy, places.length).fill(NaN, 2 * rows),
				w: longer(of.w, places.length).fill(NaN, 2 * rows),
				detectable: longer(of.detectable, places.length).fill(NaN, 2 * rows),
				parts: longer(of.parts, points.length).fill(BY_HAND, rows)
			};
			points.forEach((place, row) => {
				if (gone[place]?.isLost === true) all.parts[rows + row] = REJECTED;
			});
			all.points.set(points.map((place) => taking + place), rows);
			all.places.set(places, 2 * rows);
			return all;
		}
		detail(point) {
			const gone = this.gone[point - this.taking];
			if (gone === void 0) return null;
			const { source, isLost, index } = gone;
			const partOf = (part) => part !== "accepted" ? part : isLost ? "lost_point" : "rejected_by_hand";
			const known = index < 0 ? null : this.found.block.point(index);
			const observations = new Map(known?.observations.map((one) => [one.image, one]));
			for (const [image, one] of this.handsOf(source)) observations.set(image, {
				...UNADJUSTED,
				...one,
				part: "accepted",
				by_hand: true
			});
			return {
				id: source,
				name: known?.name ?? this.added(source)?.edit.name ?? null,
				role: null,
				position: known?.position ?? this.meetingOf(source),
				errors: null,
				rmse_px: null,
				confidence: known?.confidence ?? 1,
				observations: [...observations.values()].map(({ part, image, x_px, y_px, by_hand }) => ({
					...UNADJUSTED,
					part: partOf(part),
					image,
					x_px,
					y_px,
					by_hand
				})),
				elsewhere: []
			};
		}
		surveyed(taking) {
			return this.gone.flatMap(({ source }, place) => {
				const known = "ground_control" in source ? this.found.surveyedPoint(source.ground_control) ?? this.surveyedByHand(source) : void 0;
				return known === void 0 ? [] : [{
					...known,
					rays: 0,
					difference_m: [
						NaN,
						NaN,
						NaN
					],
					standard_errors_m: [
						null,
						null,
						null
					],
					point: taking + place,
					isUsed: false
				}];
			});
		}
		added(source) {
			if (!("ground_control" in source)) return void 0;
			return [...addedPoints(this.edits, this.found.givenControl).values()].find(({ control }) => control === source.ground_control);
		}
		surveyedByHand(source) {
			const added = this.added(source);
			if (added === void 0) return void 0;
			const { name, position, use } = added.edit;
			return {
				standard_errors_m: [
					null,
					null,
					null
				],
				detectable_m: [
					null,
					null,
					null
				],
				difference_m: [
					NaN,
					NaN,
					NaN
				],
				name,
				role: use ?? "control",
				rays: 0,
				position,
				control: added.control,
				point: -1,
				isUsed: false,
				byHand: true
			};
		}
		meetingOf(source) {
			const measurements = [...this.handsOf(source).values()].map(({ image, x_px, y_px }) => ({
				image,
				x_px,
				y_px
			}));
			const [x, y, z] = this.found.block.meeting_place(measurements) ?? [];
			return x === void 0 || y === void 0 || z === void 0 ? null : [
				x,
				y,
				z
			];
		}
		handsOf(source) {
			return this.byHand.get(codeOfSource(source)) ?? NO_HANDS;
		}
	};
	var NO_HANDS = new Map();
	function measuredByHand(edits) {
		const added = edits.filter((edit) => edit.kind === "add_point").flatMap(({ observations }, manual) => observations.map((one) => ({
			...one,
			point: { manual }
		})));
		const hands = new Map();
		for (const { point, ...one } of [...added, ...edits.filter((edit) => edit.kind === "measure")]) {
			const code = codeOfSource(point);
			hands.set(code, (hands.get(code) ?? new Map()).set(one.image, one));
		}
		return hands;
	}
	function tiePoints(found, edits) {
		const added = edits.filter((edit) => edit.kind === "add_point").map((_, manual) => ({ manual }));
		return [...found.sources.filter((source) => !("ground_control" in source)), ...added];
	}
	var UNADJUSTED = {
		part: "rejected_by_hand",
		by_hand: false,
		residual_px: null,
		redundancy: null,
		w: null,
		detectable_px: [null, null],
		predicted_px: null
	};
	function longer(of, more) {
		const copy = new of.constructor(of.length + more);
		copy.set(of);
		return copy;
	}
	// www/block/engine/project-input.ts
	var BEGINNING = "{\"block\":{\"input\":";
	var GEOID = ",\"geoid\":";
	var END = /\}\}\s*$/u;
	var [LINE_END, QUOTE, BACKSLASH, OPENS, CLOSES] = [..."\n\"\\{}"].map((sign) => sign.charCodeAt(0));
	function projectInputOf(file, block) {
		const bytes = startOf(file) === null ? new TextEncoder().encode(block.project()) : file;
		const start = startOf(bytes);
		if (start === null) throw new Error("no input is held");
		const input = JSON.parse(new TextDecoder().decode(bytes.subarray(start, endOfObject(bytes, start))));
		return {
			input,
			geoid: input.geoid === void 0 ? null : geoidOf(bytes)
		};
	}
	function startOf(bytes) {
		const line = bytes.indexOf(LINE_END ?? 0) + 1;
		const start = line + 18;
		return new TextDecoder().decode(bytes.subarray(line, start)) === BEGINNING ? start : null;
	}
	function endOfObject(bytes, start) {
		let depth = 0;
		let quoted = false;
		for (let at = start; at < bytes.length; at++) {
			const sign = bytes[at];
			if (quoted && sign === BACKSLASH) at++;
			else if (sign === QUOTE) quoted = !quoted;
			else if (!quoted && sign === OPENS) depth++;
			else if (!quoted && sign === CLOSES && --depth === 0) return at + 1;
		}
		return bytes.length;
	}
	function geoidOf(bytes) {
		const tail = new TextDecoder().decode(bytes.subarray(-16777216));
		const at = tail.lastIndexOf(`${GEOID}{`);
		return at < 0 ? null : gtxOf(JSON.parse(tail.slice(at + 9).replace(END, "")));
	}
	function gtxOf({ south_west_deg: [west, south], step_deg: [east, north], columns, heights_m: heights }) {
		const HEAD = 40;
		const file = new DataView(new ArrayBuffer(HEAD + 4 * heights.length));
		for (const [i, degrees] of [
			south,
			west,
			north,
			east
		].entries()) file.setFloat64(8 * i, degrees);
		for (const [i, count] of [heights.length / columns, columns].entries()) file.setInt32(32 + 4 * i, count);
		for (const [i, height] of heights.entries()) file.setFloat32(HEAD + 4 * i, height);
		return new Uint8Array(file.buffer);
	}
	// www/block/engine/session.ts
	var held$1 = null;
	var found = null;
	var rejected = null;
	function heldBlock() {
		if (held$1 === null) throw new Error("no block is held");
		return held$1;
	}
	async function blockRun({ files, options, masks, geoid, truth, workers, kept, port }) {
		const link = new Link(port);
		const coming = new Coming((view) => link.send({
			kind: "part",
			view
		}));
		try {
			return hold$1(await runBlock(files.map(sourceOf), {
				...options,
				masks: masks.map(sourceOf),
				strayMasks: "list",
				...geoid && { geoid: sourceOf(geoid) }
			}, {
				pool: link.pool(workers),
				store: storeOf(kept, link),
				progress: (step) => link.send({
					kind: "step",
					step
				}),
				news: (news) => coming.take(news),
				signal: link.stopped.signal
			}), truth, "another");
		} catch (error) {
			coming.tell();
			throw error;
		} finally {
			coming.end();
			port.close();
		}
	}
	function blockOpen({ bytes, truth }) {
		const block = FinishedBlock.open(bytes);
		return {
			view: hold$1(block, truth, "another"),
			steps: stepsIn(block),
			made: projectInputOf(bytes, block)
		};
	}
	function stepsIn(block) {
		const edits = block.edits();
		return block.edit_steps().map((length) => edits.splice(0, length));
	}
	function blockEdited({ steps, truth }) {
		return hold$1(heldBlock().edited(steps.flat(), steps.map(({ length }) => length)), truth, "edited");
	}
	function hold$1(block, truth, kind) {
		try {
			const view = {
				...viewOf(block),
				score: truth === null ? null : block.score(truth)
			};
			const edits = block.edits();
			const before = kind === "edited" ? found : null;
			const own = edits.length === 0 ? null : before ?? foundOf(block);
			const gone = own === null ? null : new Rejected(own, edits, view.points.count, view.points.sources);
			const shown = gone === null ? view : gone.inView(view);
			held$1?.free();
			if (found !== own) found?.block.free();
			[held$1, found, rejected] = [
				block,
				own,
				gone
			];
			return shown;
		} catch (error) {
			block.free();
			throw error;
		}
	}
	function foundOf(block) {
		const before = block.edited([]);
		const { surveyed, givenControl } = viewOf(before);
		return new Found(before, surveyed, givenControl);
	}
	function imagePoints(image) {
		const of = heldBlock().image_points(image);
		return rejected === null ? of : rejected.inImage(of, image);
	}
	function blockImagePoints({ image }) {
		return imagePoints(image);
	}
	function blockObservations({ images }) {
		const each = Array.from({ length: images }, (_, image) => imagePoints(image));
		const total = each.reduce((sum, { points }) => sum + points.length, 0);
		const all = {
			images: new Uint32Array(total),
			points: new Uint32Array(total),
			places: new Float64Array(2 * total),
			residuals: new Float64Array(2 * total),
			redundancy: new Float64Array(2 * total),
			w: new Float64Array(2 * total),
			detectable: new Float64Array(2 * total),
			parts: new Uint8Array(total)
		};
		let at = 0;
		each.forEach((own, image) => {
			const { points } = own;
			all.images.fill(image, at, at + points.length);
			all.points.set(points, at);
			all.parts.set(own.parts, at);
			for (const column of [
				"places",
				"residuals",
				"redundancy",
				"w",
				"detectable"
			]) all[column].set(own[column], 2 * at);
			at += points.length;
		});
		return all;
	}
	function blockGround() {
		return groundOf(heldBlock());
	}
	function blockPlaces() {
		return heldBlock().places();
	}
	function blockPlacesAgain({ before }) {
		return heldBlock().places_again(before);
	}
	function blockPoint({ point }) {
		return rejected?.detail(point) ?? heldBlock().point(point);
	}
	function blockLine({ from, x, y, to }) {
		return heldBlock().epipolar_line(from, x, y, to);
	}
	async function blockExport({ kind, name, stop }) {
		const stopped = new AbortController();
		stop.onmessage = () => stopped.abort();
		try {
			return await made(heldBlock(), kind, name, stopped.signal);
		} finally {
			stop.close();
		}
	}
	function sourceOf({ name, file }) {
		return {
			name,
			bytes: async () => new Uint8Array(await file.arrayBuffer())
		};
	}
	function storeOf(kept, link) {
		const records = new Map(kept);
		return {
			get: async (key) => {
				const record = records.get(key);
				return record === void 0 ? null : new Uint8Array(await record.arrayBuffer());
			},
			put: (key, bytes) => {
				const record = new Blob([bytes]);
				records.set(key, record);
				link.send({
					kind: "keep",
					key,
					record
				});
				return Promise.resolve();
			}
		};
	}
	var Link = class {
		port;
		stopped = new AbortController();
		waiting = new Map();
		nextId = 1;
		constructor(port) {
			this.port = port;
			port.onmessage = (event) => this.receive(event.data);
		}
		send(message, transfer = []) {
			this.port.postMessage(message, transfer);
		}
		pool(size) {
			return {
				size,
				run: (_, job, transfer) => this.ask(job, transfer)
			};
		}
		ask(job, transfer) {
			return new Promise((resolve, reject) => {
				this.stopped.signal.throwIfAborted();
				const id = this.nextId++;
				this.waiting.set(id, {
					resolve,
					reject
				});
				this.send({
					kind: "job",
					id,
					job
				}, transfer);
			});
		}
		receive(message) {
			if (message.kind === "stop") {
				this.stopped.abort();
				for (const { reject } of this.waiting.values()) reject(this.stopped.signal.reason);
				this.waiting.clear();
				return;
			}
			const waiting = this.waiting.get(message.id);
			this.waiting.delete(message.id);
			if (message.kind === "broke") waiting?.reject(named("WorkerError", message.message));
			else settle(waiting, message.answer);
		}
	};
	function settle(waiting, answer) {
		if ("made" in answer) waiting?.resolve(answer.made);
		else waiting?.reject(errorOf(answer.refusal));
	}
	function named(name, message) {
		const error = new Error(message);
		error.name = name;
		return error;
	}
	// www/block/engine/handlers.ts
	async function blockJob(job) {
		try {
			return { made: await jobs.block(job) };
		} catch (error) {
			if (!(error instanceof Error) || error.name !== "TiepointError") throw error;
			return { refusal: plainError(error) };
		}
	}
	var BLOCK_HANDLERS = {
		blockJob,
		blockPlan,
		blockPhoto,
		blockGrey,
		blockWindow,
		blockFit,
		blockRun,
		blockOpen,
		blockPlaces,
		blockPlacesAgain,
		blockEdited,
		blockImagePoints,
		blockObservations,
		blockGround,
		blockPoint,
		blockLine,
		blockExport,
		imagePosition,
		orthoInfo,
		orthoTile,
		orthoElsewhere,
		orthoSearch,
		orthoPlace,
		orthoRectified,
		orthoAdjust,
		orthoControl,
		orthoPredict,
		orthoLaid,
		linksOpen,
		linksPlace,
		linksFinish,
		filmPlan,
		filmFrame,
		mosaicOpen,
		mosaicAdd,
		mosaicFinish,
		sceneOrthophoto
	};
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
	// www/pair/engine/colour.ts
	var MOST_PIXELS = 5e7;
	var STRIDE = 7;
	var GREY = 6;
	var LEAST_COLOURED = .001;
	var LEAST_CORRELATION = .9;
	function reducedColour(colour, grey, width, height) {
		if (colour.width !== width || colour.height !== height || width * height > MOST_PIXELS) return null;
		const canvas = new OffscreenCanvas(grey.width, grey.height);
		const context = canvas.getContext("2d");
		if (context === null) return null;
		const step = 2 ** grey.halvings;
		context.imageSmoothingQuality = "high";
		context.drawImage(colour, 0, 0, width / step, height / step);
		const { data } = context.getImageData(0, 0, grey.width, grey.height);
		return isColoured(data) && correlation(data, grey.grey) >= LEAST_CORRELATION ? canvas.transferToImageBitmap() : null;
	}
	function colourTile(colour, level, column, row, side) {
		const step = 2 ** level;
		const [left, top] = [column * side * step, row * side * step];
		const [width, height] = [Math.min(side * step, colour.width - left), Math.min(side * step, colour.height - top)];
		const canvas = new OffscreenCanvas(Math.ceil(width / step), Math.ceil(height / step));
		const context = canvas.getContext("2d");
		if (context === null) throw new Error("no canvas can be drawn on here");
		context.imageSmoothingQuality = "high";
		context.drawImage(colour, left, top, width, height, 0, 0, width / step, height / step);
		return canvas.transferToImageBitmap();
	}
	function isColoured(data) {
		let coloured = 0;
		for (let i = 0; i < data.length; i += 28) {
			const [r, g, b] = [
				data[i] ?? 0,
				data[i + 1] ?? 0,
				data[i + 2] ?? 0
			];
			if (Math.max(r, g, b) - Math.min(r, g, b) > GREY) coloured += 1;
		}
		return coloured > LEAST_COLOURED * data.length / 28;
	}
	function correlation(data, grey) {
		let [n, x, y, xx, yy, xy] = [
			0,
			0,
			0,
			0,
			0,
			0
		];
		for (let i = 0; i < grey.length; i += STRIDE) {
			const bright = .299 * (data[4 * i] ?? 0) + .587 * (data[4 * i + 1] ?? 0) + .114 * (data[4 * i + 2] ?? 0);
			const own = grey[i] ?? 0;
			n += 1;
			x += bright;
			y += own;
			xx += bright * bright;
			yy += own * own;
			xy += bright * own;
		}
		return (n * xy - x * y) / Math.sqrt((n * xx - x * x) * (n * yy - y * y));
	}
	// www/pair/engine/mask.ts
	var LEFT_OUT = 2569545944;
	function overlayOf(grey, width, height, most) {
		const step = Math.max(1, Math.ceil(Math.max(width, height) / most));
		const [columns, rows] = [Math.ceil(width / step), Math.ceil(height / step)];
		const pixels = new Uint32Array(columns * rows);
		for (let i = 0; i < pixels.length; i++) {
			const at = Math.floor(i / columns) * step * width + i % columns * step;
			pixels[i] = grey[at] === 0 ? LEFT_OUT : 0;
		}
		return createImageBitmap(new ImageData(new Uint8ClampedArray(pixels.buffer), columns, rows));
	}
	function shareLeftOut(grey) {
		let zeros = 0;
		for (const value of grey) if (value === 0) zeros += 1;
		return zeros / grey.length;
	}
	function fill(grey, width, height, corners, value) {
		for (const [row, crossings] of crossingsOf(corners, height)) {
			crossings.sort(([a], [b]) => a - b);
			let winding = 0;
			for (const [i, [from, turn]] of crossings.entries()) {
				winding += turn;
				const to = crossings[i + 1]?.[0] ?? from;
				if (winding !== 0) grey.fill(value, row * width + columnAfter(from, width), row * width + columnAfter(to, width));
			}
		}
	}
	function crossingsOf(corners, height) {
		const rows = new Map();
		for (const [i, [x, y]] of corners.entries()) {
			const [u, v] = corners[i + 1] ?? corners[0] ?? [x, y];
			const [top, bottom] = [Math.min(y, v), Math.max(y, v)];
			for (let row = Math.max(0, Math.floor(top - .5)); row < Math.min(height, bottom); row++) {
				const middle = row + .5;
				if (middle < top || middle >= bottom) continue;
				const crossings = rows.get(row) ?? [];
				crossings.push([x + (middle - y) / (v - y) * (u - x), y < v ? 1 : -1]);
				rows.set(row, crossings);
			}
		}
		return rows;
	}
	var columnAfter = (x, width) => Math.min(width, Math.max(0, Math.ceil(x - .5)));
	// www/pair/engine/patch.ts
	function patchOf(grey, width, height, { x, y, direction, reach, side }) {
		const fine = Math.max(1, Math.round(reach / side));
		const step = reach / (side * fine);
		const [cos, sin] = [Math.cos(direction) * step, Math.sin(direction) * step];
		const middle = (side * fine - 1) / 2;
		return Uint8Array.from({ length: side * side }, (_, i) => {
			let sum = 0;
			for (let k = 0; k < fine * fine; k++) {
				const u = i % side * fine + k % fine - middle;
				const v = Math.floor(i / side) * fine + Math.floor(k / fine) - middle;
				sum += greyAt(grey, width, height, x + u * cos - v * sin, y + u * sin + v * cos);
			}
			return Math.round(sum / (fine * fine));
		});
	}
	// www/pair/engine/handlers.ts
	var opened = null;
	function photo() {
		if (opened === null) throw new Error("no image is open in this worker");
		return opened;
	}
	async function decode(source) {
		switch (source.kind) {
			case "file": return Photo.decode(await bytesOf(source.file));
			case "grey": return Photo.from_grey(source.width, source.height, source.grey);
			case "project": throw new Error("a project does not hold its images");
		}
	}
	async function open({ source, overviewSide }) {
		opened?.photo.free();
		opened?.colour?.close();
		opened = null;
		const bytes = source.kind === "file" ? new Uint8Array(await source.file.arrayBuffer()) : null;
		const coming = bytes === null ? null : decodeColour(bytes);
		const decoded = bytes === null ? await decode(source) : Photo.decode(bytes);
		opened = {
			photo: decoded,
			grey: null,
			colour: null
		};
		const reduced = decoded.reduced(overviewSide);
		const colour = await coming;
		const coloured = colour == null ? null : reducedColour(colour, reduced, decoded.width, decoded.height);
		if (coloured === null) colour?.close();
		else opened.colour = colour;
		return {
			info: decoded.info(),
			overview: {
				bitmap: coloured ?? await bitmapOf(reduced.grey, reduced.width, reduced.height),
				halvings: reduced.halvings
			}
		};
	}
	function greyOf(current) {
		current.grey ??= current.photo.grey();
		return current.grey;
	}
	function tile({ level, column, row, side }) {
		const current = photo();
		if (current.colour !== null) return colourTile(current.colour, level, column, row, side);
		return tileOf(greyOf(current), current.photo.width, current.photo.height, level, column, row, side);
	}
	async function decodedGrey(file) {
		const decoded = await decode({
			kind: "file",
			file
		});
		const { width, height } = decoded;
		const grey = decoded.grey();
		decoded.free();
		return {
			width,
			height,
			grey
		};
	}
	async function mask({ file, overlaySide }) {
		const decoded = await decodedGrey(file);
		const { width, height, grey } = decoded;
		return {
			...decoded,
			leftOut: shareLeftOut(grey),
			overlay: await overlayOf(grey, width, height, overlaySide)
		};
	}
	async function paintMask({ over, width, height, areas, overlaySide }) {
		const grey = (over instanceof Blob ? (await decodedGrey(over)).grey : over) ?? new Uint8Array(width * height).fill(255);
		for (const { corners, masked } of areas) fill(grey, width, height, corners, masked ? 0 : 255);
		const png = grey_png(width, height, grey);
		return {
			width,
			height,
			grey,
			leftOut: shareLeftOut(grey),
			overlay: await overlayOf(grey, width, height, overlaySide),
			png
		};
	}
	var held = null;
	function hold({ left, right }) {
		held?.left.free();
		held?.right.free();
		held = null;
		held = {
			left: Photo.from_grey(left.width, left.height, left.grey),
			right: Photo.from_grey(right.width, right.height, right.grey)
		};
		return null;
	}
	function match(m) {
		if (held === null) throw new Error("no pair is held in this worker");
		const { left, right } = held;
		return match_photos(left, right, m.left, m.right, m.offset, m.interior, m.settings, m.nearest ?? void 0);
	}
	function difference() {
		if (held === null) throw new Error("no pair is held in this worker");
		return photo_difference(held.left, held.right);
	}
	function candidatesOf({ left, right, offset, index, options }) {
		if (offset === null) throw new Error("these candidates lie around an expected place");
		const none = new Float64Array();
		return candidates(index, left.points, left.moments ?? none, right.points, right.moments ?? none, offset, options);
	}
	var digestOf = (bytes) => Array.from(sha256(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");
	var report = null;
	function reportInHand() {
		if (report === null) throw new Error("no report is begun in this worker");
		return report;
	}
	async function reportOpen({ images, names, input, settings, truth, masks: [ofLeft, ofRight], edits }) {
		report?.free();
		report = null;
		const left = await decode(images[0]);
		const right = await decode(images[1]);
		report = new Report(left, right, names, input, settings, truth, ofLeft, ofRight, edits);
		left.free();
		right.free();
		return report.steps(LANGUAGE);
	}
	async function epipolar({ project, images: [ofLeft, ofRight] }) {
		const encoder = new TextEncoder();
		const pair = EpipolarPair.open(encoder.encode(project));
		const [first, second] = pair.is_swapped ? [ofRight, ofLeft] : [ofLeft, ofRight];
		try {
			const { left, right, anaglyph, parameters } = await resampled(pair, first, second);
			return {
				archive: zipSync({
					"left.png": left,
					"right.png": right,
					"anaglyph.png": anaglyph,
					"epipolar.json": encoder.encode(parameters)
				}, {
					level: 0,
					mtime: ARCHIVE_TIME
				}),
				geometry: pair.geometry
			};
		} finally {
			pair.free();
		}
	}
	async function resampled(pair, left, right) {
		if (left.kind === "file" && right.kind === "file") return pair.resample_files(await bytesOf(left.file), await bytesOf(right.file));
		const photos = [await decode(left), await decode(right)];
		try {
			return pair.resample(...photos);
		} finally {
			for (const held of photos) held.free();
		}
	}
	async function bytesOf(file) {
		return new Uint8Array(await file.arrayBuffer());
	}
	function interiorOf({ width, height, camera, pairFocalMm, fiducials, model, origin }) {
		return {
			interior: scaled_interior(interior(camera, {
				width,
				height,
				fiducials,
				model,
				origin
			}), pairFocalMm / camera.focal_mm),
			fiducials: fiducials.length > 0 ? orient_fiducials(fiducials, model) : null
		};
	}
	var PAIR_HANDLERS = {
		open,
		tile,
		reduced: ({ maxSide }) => photo().photo.reduced(maxSide),
		detect: ({ settings, mask: left }) => photo().photo.detect(settings, left),
		features: ({ settings, mask: left }) => photo().photo.describe_points(settings, left),
		describe: ({ points, window, strategy }) => photo().photo.describe(points, window, strategy),
		grey: () => ({
			width: photo().photo.width,
			height: photo().photo.height,
			grey: photo().photo.grey()
		}),
		patch: (input) => patchOf(greyOf(photo()), photo().photo.width, photo().photo.height, input),
		moments: ({ col, row, window }) => photo().photo.window_moments(col, row, window),
		simulate: (flight) => simulate(flight),
		hold,
		offset: ({ left, right }) => estimate_offset(left, right),
		constantOffset: ({ dx, dy }) => constant_offset(dx, dy),
		match,
		nearest: ({ left, first, end, right }) => nearest_piece(left, first, end, right),
		difference,
		candidates: candidatesOf,
		parallaxDeviation: ({ index, points, match: { rules, places }, offset, options }) => parallax_deviation(index, points, rules, places, offset, options),
		gradientCandidates: ({ index, left, right, most }) => gradient_candidates(index, left, right, most),
		epipolarLine: ({ from, x, y, model, interior: ofPair, width, height }) => epipolar_line(from, x, y, model, ofPair, width, height),
		score: (s) => score_matches(s.matches, s.leftPoints, s.rightPosition, s.left.width, s.left.height, s.right.width, s.right.height),
		interior: interiorOf,
		orient: ({ matches, fits, interior: ofPair, options, points }) => orient_matches(matches, fits, ofPair, options, points),
		reportOpen,
		reportStep: () => reportInHand().step(),
		reportPage: () => reportInHand().html(LANGUAGE),
		epipolar,
		parseFiducials: ({ text }) => parse_fiducials(text),
		orientMarks: ({ fiducials, model }) => {
			try {
				return orient_fiducials(fiducials, model);
			} catch {
				return null;
			}
		},
		parseCamera: ({ text }) => parse_camera(text),
		mask,
		paintMask,
		digest: async ({ file }) => digestOf(new Uint8Array(await file.arrayBuffer())),
		projectOpen: ({ bytes }) => open_pair_project(bytes),
		projectWrite: (project) => write_pair_project(project),
		matchesCsv: ({ matches, rejected }) => matches_csv(matches, rejected)
	};
	// www/shared/engine/compile.ts
	async function compiled(address) {
		try {
			const response = await fetch(address);
			if (!response.ok) return {
				status: response.status,
				message: ""
			};
			return { compiled: response.headers.get("content-type")?.startsWith("application/wasm") === true ? await WebAssembly.compileStreaming(response) : await WebAssembly.compile(await response.arrayBuffer()) };
		} catch (error) {
			return {
				status: null,
				message: messageOf(error)
			};
		}
	}
	// www/shared/engine/serve.ts
	function transferables(value) {
		if (value instanceof ImageBitmap) return [value];
		if (ArrayBuffer.isView(value)) return value.buffer instanceof ArrayBuffer ? [value.buffer] : [];
		if (typeof value !== "object" || value === null || Array.isArray(value)) return [];
		return Object.values(value).flatMap(transferables);
	}
	function failureOf(error) {
		const message = messageOf(error);
		const code = error instanceof Error && "code" in error && typeof error.code === "string" ? error.code : null;
		const breakdown = breakdownOf(error);
		if (breakdown !== null) return {
			kind: breakdown,
			code,
			message
		};
		return {
			kind: code === null ? "other" : "refused",
			code,
			message,
			error: error instanceof Error && "error" in error ? error.error : null
		};
	}
	var startFailure = null;
	function start(message) {
		try {
			initSync({ module: message.module });
		} catch (error) {
			startFailure = { error };
		}
	}
	function serve(handlers) {
		const answer = async ({ id, call, input }) => {
			try {
				if (startFailure !== null) throw startFailure.error;
				const output = await handlers[call](input);
				postMessage({
					id,
					output
				}, { transfer: transferables(output) });
			} catch (error) {
				postMessage({
					id,
					failure: failureOf(error)
				});
			}
		};
		let queue = Promise.resolve();
		addEventListener("message", (event) => {
			const message = event.data;
			if ("compile" in message) compiled(message.compile).then((made) => postMessage(made));
			else if ("module" in message) start(message);
			else queue = queue.then(() => answer(message));
		});
	}
	// www/worker.ts
	serve({
		...PAIR_HANDLERS,
		...BLOCK_HANDLERS
	});
})();
