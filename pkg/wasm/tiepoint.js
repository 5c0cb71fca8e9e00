/* @ts-self-types="./tiepoint.d.ts" */

/**
 * The images of an oriented block while they are placed on an orthophoto, one after the other, in wasm memory. Call `free` when it is no longer
 * needed.
 */
export class BlockOnOrthophoto {
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
    /**
     * The block in the system of the orthophoto, adjusted by places of its ground; what came of it stands in the summary. Where it could not be
     * linked it is as it was.
     * @param {FinishedBlock} block
     * @param {OrthophotoReference} reference
     * @returns {FinishedBlock}
     */
    linked(block, reference) {
        _assertClass(block, FinishedBlock);
        _assertClass(reference, OrthophotoReference);
        const ret = wasm.blockonorthophoto_linked(this.__wbg_ptr, block.__wbg_ptr, reference.__wbg_ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return FinishedBlock.__wrap(ret[0]);
    }
    /**
     * None is placed yet.
     */
    constructor() {
        const ret = wasm.blockonorthophoto_new();
        this.__wbg_ptr = ret;
        BlockOnOrthophotoFinalization.register(this, this.__wbg_ptr, this);
        return this;
    }
    /**
     * Places an image of the block, by its index, with the camera that the block has adjusted; null for one that is not oriented.
     * @param {FinishedBlock} block
     * @param {number} index
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} file
     * @param {OrthophotoReference} reference
     * @returns {PlacingVerdict | null}
     */
    place(block, index, file, reference) {
        _assertClass(block, FinishedBlock);
        _assertClass(reference, OrthophotoReference);
        const ret = wasm.blockonorthophoto_place(this.__wbg_ptr, block.__wbg_ptr, index, file, reference.__wbg_ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
}
if (Symbol.dispose) BlockOnOrthophoto.prototype[Symbol.dispose] = BlockOnOrthophoto.prototype.free;

/**
 * The scene below a simulated block in wasm memory. Call `free` when it is no longer needed.
 */
export class BlockScene {
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
    /**
     * Builds the scene of a flight; parameters that are absent take their defaults.
     * @param {Given<BlockFlight>} flight
     */
    constructor(flight) {
        const ret = wasm.blockscene_new(flight);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
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
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Takes a photo.
     * @param {number} index
     * @returns {SampleImage}
     */
    photo(index) {
        const ret = wasm.blockscene_photo(this.__wbg_ptr, index);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Takes a photo as a PNG file, with its camera and recorded position as EXIF.
     * @param {number} index
     * @returns {Uint8Array}
     */
    photo_file(index) {
        const ret = wasm.blockscene_photo_file(this.__wbg_ptr, index);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
        return v1;
    }
    /**
     * How many photos the flight takes.
     * @returns {number}
     */
    get photos() {
        const ret = wasm.blockscene_photos(this.__wbg_ptr);
        return ret >>> 0;
    }
    /**
     * Places x, y, z in m on the first surface that a photo sees at positions x, y in px (stride 2); stride 3.
     * @param {number} index
     * @param {Float64Array | readonly number[]} positions
     * @returns {Float64Array}
     */
    surface_at(index, positions) {
        const ret = wasm.blockscene_surface_at(this.__wbg_ptr, index, positions);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The true cameras and exterior orientations.
     * @returns {BlockModel}
     */
    truth() {
        const ret = wasm.blockscene_truth(this.__wbg_ptr);
        return ret;
    }
}
if (Symbol.dispose) BlockScene.prototype[Symbol.dispose] = BlockScene.prototype.free;

/**
 * The files of a block, of which each step writes some.
 */
export class BlockWriting {
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
    /**
     * Writes the next files; gives the summary after the last one, null before.
     * @param {Emit} emit
     * @returns {Summary | null}
     */
    step(emit) {
        const ret = wasm.blockwriting_step(this.__wbg_ptr, emit);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
}
if (Symbol.dispose) BlockWriting.prototype[Symbol.dispose] = BlockWriting.prototype.free;

/**
 * Two oriented images of a project, to be resampled so that what both show lies in the same row of either. Call `free` when it is no longer
 * needed.
 */
export class EpipolarPair {
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
    /**
     * SHA-256 of the files of the left and the right image in hexadecimal digits; null for photos that were simulated.
     * @returns {(string | null)[]}
     */
    get contents() {
        const ret = wasm.epipolarpair_contents(this.__wbg_ptr);
        return ret;
    }
    /**
     * How the epipolar images lie.
     * @returns {EpipolarGeometry}
     */
    get geometry() {
        const ret = wasm.epipolarpair_geometry(this.__wbg_ptr);
        return ret;
    }
    /**
     * Whether the left image stands second in the project.
     * @returns {boolean}
     */
    get is_swapped() {
        const ret = wasm.epipolarpair_is_swapped(this.__wbg_ptr);
        return ret !== 0;
    }
    /**
     * The names of the left and the right image.
     * @returns {string[]}
     */
    get names() {
        const ret = wasm.epipolarpair_names(this.__wbg_ptr);
        var v1 = getArrayJsValueFromWasm0(ret[0], ret[1]);
        wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
        return v1;
    }
    /**
     * Of a project file. `names`: the left and the right image; absent: those of a pair, or the two of a block that have most points in common, in
     * that order in which the base goes to the right.
     * @param {string | Uint8Array | Uint8ClampedArray | ArrayBuffer} project
     * @param {readonly string[] | null} [names]
     * @returns {EpipolarPair}
     */
    static open(project, names) {
        const ret = wasm.epipolarpair_open(project, isLikeNone(names) ? 0 : addToExternrefTable0(names));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return EpipolarPair.__wrap(ret[0]);
    }
    /**
     * Resamples the grey values of both images, which are given in the order of `names`.
     * @param {Photo} left
     * @param {Photo} right
     * @returns {EpipolarFiles}
     */
    resample(left, right) {
        _assertClass(left, Photo);
        _assertClass(right, Photo);
        const ret = wasm.epipolarpair_resample(this.__wbg_ptr, left.__wbg_ptr, right.__wbg_ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Resamples both images in the colours of their files, which are given in the order of `names`.
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} left
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} right
     * @returns {EpipolarFiles}
     */
    resample_files(left, right) {
        const ret = wasm.epipolarpair_resample_files(this.__wbg_ptr, left, right);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
}
if (Symbol.dispose) EpipolarPair.prototype[Symbol.dispose] = EpipolarPair.prototype.free;

/**
 * A block that was run, or opened from its project file; its owner frees it.
 */
export class FinishedBlock {
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
    /**
     * A map of the standard errors that are expected of points that would be measured in the block. `cell`: the side of a cell, in units of the block;
     * `sigma_px`: the standard error of an image coordinate. Absent: an eightieth of the longer side; σ₀ of the block.
     * @param {number | null} [cell]
     * @param {number | null} [sigma_px]
     * @returns {AccuracyFiles}
     */
    accuracy(cell, sigma_px) {
        const ret = wasm.finishedblock_accuracy(this.__wbg_ptr, isLikeNone(cell) ? 0 : addToExternrefTable0(cell), isLikeNone(sigma_px) ? 0 : addToExternrefTable0(sigma_px));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The edits of the same block as it was placed before, for this one, to which `edited` applies them; those of places hold where the places lie again.
     * @param {FinishedBlock} before
     * @returns {CarriedEdits}
     */
    carried_edits(before) {
        _assertClass(before, FinishedBlock);
        const ret = wasm.finishedblock_carried_edits(this.__wbg_ptr, before.__wbg_ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The covariances of images, points and cameras with these names as a table of text: each row an unknown with its unit, adjusted value and standard
     * error, then its covariances with all of them. `all` names the whole block.
     * @param {readonly string[]} names
     * @returns {string}
     */
    covariances(names) {
        let deferred2_0;
        let deferred2_1;
        try {
            const ret = wasm.finishedblock_covariances(this.__wbg_ptr, names);
            var ptr1 = ret[0];
            var len1 = ret[1];
            if (ret[3]) {
                ptr1 = 0; len1 = 0;
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
     * How many edits each step has.
     * @returns {number[]}
     */
    edit_steps() {
        const ret = wasm.finishedblock_edit_steps(this.__wbg_ptr);
        return ret;
    }
    /**
     * The block as it was found with these edits, whatever edits it has, adjusted anew; without any, as it was found. `steps`: how many of them each
     * step has that is undone at once; one where it is absent.
     * @param {readonly BlockEdit[]} edits
     * @param {readonly number[]} [steps]
     * @returns {FinishedBlock}
     */
    edited(edits, steps) {
        const ret = wasm.finishedblock_edited(this.__wbg_ptr, edits, steps);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return FinishedBlock.__wrap(ret[0]);
    }
    /**
     * The edits that it has.
     * @returns {BlockEdit[]}
     */
    edits() {
        const ret = wasm.finishedblock_edits(this.__wbg_ptr);
        return ret;
    }
    /**
     * The epipolar line of a place of one image in another one: x, y in px, stride 2, as far as that shows it, from near to far.
     * @param {number} from
     * @param {number} x_px
     * @param {number} y_px
     * @param {number} to
     * @returns {Float64Array}
     */
    epipolar_line(from, x_px, y_px, to) {
        const ret = wasm.finishedblock_epipolar_line(this.__wbg_ptr, from, x_px, y_px, to);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
        return v1;
    }
    /**
     * Writes it in one format; tables are in the coordinate reference system of the results.
     * @param {ExportFormat} format
     * @param {Emit} emit
     */
    export(format, emit) {
        const ret = wasm.finishedblock_export(this.__wbg_ptr, format, emit);
        if (ret[1]) {
            throw takeFromExternrefTable0(ret[0]);
        }
    }
    /**
     * All its files, in steps of about one. `score`: what the summary holds of a simulated block; `language`: the tag of that of the report, `en`
     * where it is absent.
     * @param {readonly ExportFormat[]} formats
     * @param {BlockScore | null} [score]
     * @param {string | null} [language]
     * @returns {BlockWriting}
     */
    files(formats, score, language) {
        const ret = wasm.finishedblock_files(this.__wbg_ptr, formats, score, isLikeNone(language) ? 0 : addToExternrefTable0(language));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return BlockWriting.__wrap(ret[0]);
    }
    /**
     * The observations of an image.
     * @param {number} image
     * @returns {ImagePoints}
     */
    image_points(image) {
        const ret = wasm.finishedblock_image_points(this.__wbg_ptr, image);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The place that is nearest to the rays of measurements that take no part: X, Y, Z; absent where they do not meet.
     * @param {readonly HandMeasurement[]} measurements
     * @returns {Float64Array | undefined}
     */
    meeting_place(measurements) {
        const ret = wasm.finishedblock_meeting_place(this.__wbg_ptr, measurements);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        let v1;
        if (ret[0] !== 0) {
            v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
            wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
        }
        return v1;
    }
    /**
     * The model that is written.
     * @returns {BlockModel}
     */
    model() {
        const ret = wasm.finishedblock_model(this.__wbg_ptr);
        return ret;
    }
    /**
     * What came of the orthophoto that the block was given; null where it was given none.
     * @returns {OnOrthophoto | null}
     */
    on_orthophoto() {
        const ret = wasm.finishedblock_on_orthophoto(this.__wbg_ptr);
        return ret;
    }
    /**
     * Opens a project file; one that is damaged or of another kind is refused whole.
     * @param {string | Uint8Array | Uint8ClampedArray | ArrayBuffer} file
     * @returns {FinishedBlock}
     */
    static open(file) {
        const ret = wasm.finishedblock_open(file);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return FinishedBlock.__wrap(ret[0]);
    }
    /**
     * What is shown of it.
     * @returns {BlockOverview & { points: PointColumns }}
     */
    overview() {
        const ret = wasm.finishedblock_overview(this.__wbg_ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Its places of an orthophoto, by which edits of them are carried to the same block once it is placed anew.
     * @returns {BlockPlaces}
     */
    places() {
        const ret = wasm.finishedblock_places(this.__wbg_ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Which of its places lie where those of the same block lay when it was placed before.
     * @param {BlockPlaces} before
     * @returns {PlaceAgain[]}
     */
    places_again(before) {
        const ret = wasm.finishedblock_places_again(this.__wbg_ptr, before);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * All that is known of a point of the model that is written.
     * @param {number} point
     * @returns {PointDetail}
     */
    point(point) {
        const ret = wasm.finishedblock_point(this.__wbg_ptr, point);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The points of the model that is written by what they are, whatever their indices; empty for a block that is not oriented.
     * @returns {PointSource[]}
     */
    point_ids() {
        const ret = wasm.finishedblock_point_ids(this.__wbg_ptr);
        return ret;
    }
    /**
     * The number of a point, also where it is rejected; absent for a block that is not oriented.
     * @param {PointSource} point
     * @returns {number | undefined}
     */
    point_number(point) {
        const ret = wasm.finishedblock_point_number(this.__wbg_ptr, point);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return ret[0] === Number.MAX_SAFE_INTEGER ? undefined : ret[0];
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
                ptr1 = 0; len1 = 0;
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
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
}
if (Symbol.dispose) FinishedBlock.prototype[Symbol.dispose] = FinishedBlock.prototype.free;

/**
 * A quick orthomosaic of an oriented block in wasm memory: each place is taken from the image whose projection centre is nearest in plan. Its file, a
 * tiled GeoTIFF, is returned in parts: append what `add`, `leave_out` and `finish().end` return, then overwrite the first bytes with `finish().beginning`.
 * Call `free` when it is no longer needed.
 */
export class OrthoMosaic {
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
    /**
     * Adds an image, by its index; one that is not oriented adds nothing. Gives what the file goes on with.
     * @param {number} index
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} file
     * @returns {Uint8Array}
     */
    add(index, file) {
        const ret = wasm.orthomosaic_add(this.__wbg_ptr, index, file);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
        return v1;
    }
    /**
     * What the file ends with, and the bytes that it begins with in place of those that were given first.
     * @returns {{ end: Uint8Array; beginning: Uint8Array }}
     */
    finish() {
        const ptr = this.__destroy_into_raw();
        const ret = wasm.orthomosaic_finish(ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The heights on which it lies, as GeoTIFF; absent where these are one for all.
     * @returns {Uint8Array | undefined}
     */
    heights() {
        const ret = wasm.orthomosaic_heights(this.__wbg_ptr);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        let v1;
        if (ret[0] !== 0) {
            v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
            wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
        }
        return v1;
    }
    /**
     * An image, by its index, that will not be added. Gives what the file goes on with.
     * @param {number} index
     * @returns {Uint8Array}
     */
    leave_out(index) {
        const ret = wasm.orthomosaic_leave_out(this.__wbg_ptr, index);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
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
     * pixel; absent: that of the images. In the coordinate reference system of the block, where it has one; `in_adjustment`: in the system of its
     * adjustment, as the map of the page is. `images`: the names of those that it is made of; absent: all.
     * @param {string | Uint8Array | Uint8ClampedArray | ArrayBuffer} project
     * @param {number | Uint8Array | FileInParts | null} heights
     * @param {Given<Sidecars> | null | undefined} heights_sidecars
     * @param {number | null} [gsd]
     * @param {boolean | null} [in_adjustment]
     * @param {readonly string[] | null} [images]
     * @returns {OrthoMosaic}
     */
    static open(project, heights, heights_sidecars, gsd, in_adjustment, images) {
        const ret = wasm.orthomosaic_open(project, heights, heights_sidecars, isLikeNone(gsd) ? 0 : addToExternrefTable0(gsd), isLikeNone(in_adjustment) ? 0xFFFFFF : in_adjustment ? 1 : 0, isLikeNone(images) ? 0 : addToExternrefTable0(images));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return OrthoMosaic.__wrap(ret[0]);
    }
    /**
     * The indices of the oriented images that it is made of, in an order in which little waits in memory for images to come.
     * @returns {Uint32Array}
     */
    order() {
        const ret = wasm.orthomosaic_order(this.__wbg_ptr);
        var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
        return v1;
    }
    /**
     * What is to be said of the heights that were given, or of the system; null where there is nothing.
     * @returns {Remark | null}
     */
    remark() {
        const ret = wasm.orthomosaic_remark(this.__wbg_ptr);
        return ret;
    }
    /**
     * Width and height in px.
     * @returns {Uint32Array}
     */
    size() {
        const ret = wasm.orthomosaic_size(this.__wbg_ptr);
        var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
        return v1;
    }
}
if (Symbol.dispose) OrthoMosaic.prototype[Symbol.dispose] = OrthoMosaic.prototype.free;

/**
 * An orthophoto with the heights of its ground in wasm memory, on which images are placed. Call `free` when it is no longer needed.
 */
export class OrthophotoReference {
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
    /**
     * Orients an image by links that are given, in their order; nothing is matched.
     * @param {string} name
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} file
     * @param {ByLinks} given
     * @returns {PlacedImage}
     */
    adjust(name, file, given) {
        const ret = wasm.orthophotoreference_adjust(this.__wbg_ptr, name, file, given);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The same in colours: red, green, blue and alpha of each pixel, alpha 0 where it shows nothing.
     * @param {number} column
     * @param {number} row
     * @param {number} width
     * @param {number} height
     * @param {number} halvings
     * @returns {Uint8Array}
     */
    colours(column, row, width, height, halvings) {
        const ret = wasm.orthophotoreference_colours(this.__wbg_ptr, column, row, width, height, halvings);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
        return v1;
    }
    /**
     * The edit that adds a place of the ground, measured by eye, as a ground control point to a block; edits after it measure it in images.
     * @param {PlaceByHand} given
     * @returns {Extract<BlockEdit, { kind: 'add_control' }>}
     */
    control_by_hand(given) {
        const ret = wasm.orthophotoreference_control_by_hand(this.__wbg_ptr, given);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * What is to be said of images that record these GNSS positions (`image_position`) before they are placed: that none lies near
     * the orthophoto, and what would bring it to them; null where one does, or where nothing says where both are. `options`: as of `search`; absent: those
     * that it had.
     * @param {readonly ExifPosition[]} positions
     * @param {Given<PlacingOptions>} [options]
     * @returns {Remark | null}
     */
    elsewhere(positions, options) {
        const ret = wasm.orthophotoreference_elsewhere(this.__wbg_ptr, positions, options);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The ground X, Y, Z, stride 3, that positions of a placed image show, stride 2; no numbers where they show none.
     * @param {Placement} placement
     * @param {Float64Array | readonly number[]} positions
     * @returns {Float64Array}
     */
    ground_positions(placement, positions) {
        const ret = wasm.orthophotoreference_ground_positions(this.__wbg_ptr, placement, positions);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
        return v1;
    }
    /**
     * The heights of places X, Y, stride 2; no number where there is none.
     * @param {Float64Array | readonly number[]} places
     * @returns {Float64Array}
     */
    heights_at(places) {
        const ret = wasm.orthophotoreference_heights_at(this.__wbg_ptr, places);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
        return v1;
    }
    /**
     * Where places X, Y of the ground, stride 2, are in a placed image: x and y in px, stride 2, no numbers where it does not show them.
     * @param {Placement} placement
     * @param {Float64Array | readonly number[]} places
     * @returns {Float64Array}
     */
    image_positions(placement, places) {
        const ret = wasm.orthophotoreference_image_positions(this.__wbg_ptr, placement, places);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
        return v1;
    }
    /**
     * Size, place and heights.
     * @returns {OrthophotoInfo}
     */
    info() {
        const ret = wasm.orthophotoreference_info(this.__wbg_ptr);
        return ret;
    }
    /**
     * Opens a GeoTIFF, or an image with its world file: all of its bytes, or a file from which large ones are read in parts. Its ground is level at 0 until
     * heights are given.
     * @param {Uint8Array | FileInParts} file
     * @param {Given<Sidecars>} [sidecars]
     * @returns {OrthophotoReference}
     */
    static open(file, sidecars) {
        const ret = wasm.orthophotoreference_open(file, sidecars);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return OrthophotoReference.__wrap(ret[0]);
    }
    /**
     * Grey values of a part of the picture that was halved so many times: `width` times `height` of them from a column and row of the halved
     * picture on, 0 where it shows nothing.
     * @param {number} column
     * @param {number} row
     * @param {number} width
     * @param {number} height
     * @param {number} halvings
     * @returns {Uint8Array}
     */
    picture(column, row, width, height, halvings) {
        const ret = wasm.orthophotoreference_picture(this.__wbg_ptr, column, row, width, height, halvings);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
        return v1;
    }
    /**
     * Places an image. Its camera is that of `cameras`, the text of a file of cameras as blocks take it, whose pattern its name fits, or that
     * of its EXIF and XMP, or a usual one. Where it records a GNSS position and the system of the orthophoto is known, it is sought there first, within
     * `within_m`, then on all of the orthophoto. `film`: of the scan of a photo on film, its calibrated camera and the fiducial marks that were measured in it,
     * in place of what is known otherwise. `position`: its GNSS position in a table (`positions_of_images`), in place of that which its file records.
     * @param {string} name
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} file
     * @param {string | null | undefined} cameras
     * @param {Given<FilmInput> | null} [film]
     * @param {GivenPosition | null} [position]
     * @returns {PlacedImage}
     */
    place(name, file, cameras, film, position) {
        const ret = wasm.orthophotoreference_place(this.__wbg_ptr, name, file, isLikeNone(cameras) ? 0 : addToExternrefTable0(cameras), film, position);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * A placed image resampled to the ground, in its colours, as GeoTIFF.
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} file
     * @param {Placement} placement
     * @returns {Uint8Array}
     */
    rectified(file, placement) {
        const ret = wasm.orthophotoreference_rectified(this.__wbg_ptr, file, placement);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
        return v1;
    }
    /**
     * How images are placed; those that are absent take their defaults. Finds the points of the orthophoto among which images are sought, and
     * gives how many they are. Where they are refused the former ones hold.
     * @param {Given<PlacingOptions>} options
     * @returns {number}
     */
    search(options) {
        const ret = wasm.orthophotoreference_search(this.__wbg_ptr, options);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return ret[0] >>> 0;
    }
    /**
     * The heights of its ground: one for all, or a file: a GeoTIFF or an ESRI ASCII grid, with what stands beside it, or the project of an oriented block.
     * @param {number | Uint8Array | FileInParts} heights
     * @param {Given<Sidecars>} [sidecars]
     */
    set_heights(heights, sidecars) {
        const ret = wasm.orthophotoreference_set_heights(this.__wbg_ptr, heights, sidecars);
        if (ret[1]) {
            throw takeFromExternrefTable0(ret[0]);
        }
    }
}
if (Symbol.dispose) OrthophotoReference.prototype[Symbol.dispose] = OrthophotoReference.prototype.free;

/**
 * A grey image in wasm memory. Call `free` when it is no longer needed.
 */
export class Photo {
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
    /**
     * Decodes a JPEG, PNG, TIFF, BMP, PNM or WebP file.
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} bytes
     * @returns {Photo}
     */
    static decode(bytes) {
        const ret = wasm.photo_decode(bytes);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return Photo.__wrap(ret[0]);
    }
    /**
     * Describes points (stride 3) by the seven numbers each that a strategy compares; NaN where a window leaves the image or is constant.
     * Empty for the strategies that compare grey values.
     * @param {Float64Array | readonly number[]} point_list
     * @param {Given<WindowOptions>} window
     * @param {Strategy} strategy
     * @returns {Float64Array}
     */
    describe(point_list, window, strategy) {
        const ret = wasm.photo_describe(this.__wbg_ptr, point_list, window, strategy);
        if (ret[3]) {
            throw takeFromExternrefTable0(ret[2]);
        }
        var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
        wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
        return v1;
    }
    /**
     * Finds interest points and describes them as the strategy of the settings needs it.
     * @param {Given<PairSettings>} settings
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null} [mask]
     * @returns {DescribedPoints}
     */
    describe_points(settings, mask) {
        const ret = wasm.photo_describe_points(this.__wbg_ptr, settings, isLikeNone(mask) ? 0 : addToExternrefTable0(mask));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Finds interest points by the groups `points` and `multiscale` of the settings. Points whose pixel is 0 in the mask, of the image's size
     * and row by row, are left out.
     * @param {Given<PairSettings>} settings
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null} [mask]
     * @returns {DetectedPoints}
     */
    detect(settings, mask) {
        const ret = wasm.photo_detect(this.__wbg_ptr, settings, isLikeNone(mask) ? 0 : addToExternrefTable0(mask));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Finds points distinct in position and scale and describes them by the gradients around them. Points whose pixel is 0 in the mask,
     * of the image's size and row by row, are left out.
     * @param {Given<FeatureOptions>} options
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null} [mask]
     * @returns {Features}
     */
    features(options, mask) {
        const ret = wasm.photo_features(this.__wbg_ptr, options, isLikeNone(mask) ? 0 : addToExternrefTable0(mask));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * Takes grey values 0..255, row by row.
     * @param {number} width
     * @param {number} height
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} grey
     * @returns {Photo}
     */
    static from_grey(width, height, grey) {
        const ret = wasm.photo_from_grey(width, height, grey);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
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
        const ret = wasm.photo_height(this.__wbg_ptr);
        return ret >>> 0;
    }
    /**
     * Size, format, camera and drone.
     * @returns {PhotoInfo}
     */
    info() {
        const ret = wasm.photo_info(this.__wbg_ptr);
        return ret;
    }
    /**
     * The image halved until its longer side is at most `max_side` px.
     * @param {number} max_side
     * @returns {ReducedImage}
     */
    reduced(max_side) {
        const ret = wasm.photo_reduced(this.__wbg_ptr, max_side);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * @returns {number}
     */
    get width() {
        const ret = wasm.photo_width(this.__wbg_ptr);
        return ret >>> 0;
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
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
}
if (Symbol.dispose) Photo.prototype[Symbol.dispose] = Photo.prototype.free;

/**
 * The report of a pair in the making: `step` until it says false, then `html`.
 */
export class Report {
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
    /**
     * The page, which holds everything it shows; in English, or in the language of a tag. Does the steps that are left.
     * @param {string | null} [language]
     * @returns {string}
     */
    html(language) {
        let deferred2_0;
        let deferred2_1;
        try {
            const ret = wasm.report_html(this.__wbg_ptr, isLikeNone(language) ? 0 : addToExternrefTable0(language));
            var ptr1 = ret[0];
            var len1 = ret[1];
            if (ret[3]) {
                ptr1 = 0; len1 = 0;
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
     * and row by row, are left out. With edits the run is that of the edited matches; the other strategies match by themselves.
     * @param {Photo} left
     * @param {Photo} right
     * @param {[string, string]} names
     * @param {Given<PairInput>} input
     * @param {Given<PairSettings>} settings
     * @param {ReportTruth | null} truth
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null | undefined} left_mask
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null | undefined} right_mask
     * @param {ReportEdits | null} [edits]
     */
    constructor(left, right, names, input, settings, truth, left_mask, right_mask, edits) {
        _assertClass(left, Photo);
        _assertClass(right, Photo);
        const ret = wasm.report_new(left.__wbg_ptr, right.__wbg_ptr, names, input, settings, truth, isLikeNone(left_mask) ? 0 : addToExternrefTable0(left_mask), isLikeNone(right_mask) ? 0 : addToExternrefTable0(right_mask), edits);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
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
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return ret[0] !== 0;
    }
    /**
     * What each step does, in their order; in English, or in the language of a tag.
     * @param {string | null} [language]
     * @returns {string[]}
     */
    steps(language) {
        const ret = wasm.report_steps(this.__wbg_ptr, isLikeNone(language) ? 0 : addToExternrefTable0(language));
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * The verdict on this run; null before the first step.
     * @returns {PairVerdict | null}
     */
    verdict() {
        const ret = wasm.report_verdict(this.__wbg_ptr);
        return ret;
    }
}
if (Symbol.dispose) Report.prototype[Symbol.dispose] = Report.prototype.free;

/**
 * The run of a block. Its host does the jobs of `next`, in any order and any number at the same time: it reads the files, asks `prepare`,
 * looks for a kept record of the key, which goes to `found`, and else calls `execute_job`, keeps what comes of it and hands it to `complete`.
 */
export class Run {
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
    /**
     * Takes the bytes that came of a job.
     * @param {number} id
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} bytes
     */
    complete(id, bytes) {
        const ret = wasm.run_complete(this.__wbg_ptr, id, bytes);
        if (ret[1]) {
            throw takeFromExternrefTable0(ret[0]);
        }
    }
    /**
     * Takes why a job could not be done: an image or a pair is left out with it, where these are to blame.
     * @param {number} id
     * @param {Failure} failure
     */
    failed(id, failure) {
        const ret = wasm.run_failed(this.__wbg_ptr, id, failure);
        if (ret[1]) {
            throw takeFromExternrefTable0(ret[0]);
        }
    }
    /**
     * What the run has found; frees it.
     * @returns {FinishedBlock}
     */
    finish() {
        const ptr = this.__destroy_into_raw();
        const ret = wasm.run_finish(ptr);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return FinishedBlock.__wrap(ret[0]);
    }
    /**
     * Takes a kept record; one that does not read well is not taken, and the job is still to be done.
     * @param {number} id
     * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} record
     * @returns {boolean}
     */
    found(id, record) {
        const ret = wasm.run_found(this.__wbg_ptr, id, record);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return ret[0] !== 0;
    }
    /**
     * A run of which nothing is done; what can be refused before the images are read is refused here.
     * @param {Given<RunInput>} input
     */
    constructor(input) {
        const ret = wasm.run_new(input);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        this.__wbg_ptr = ret[0];
        RunFinalization.register(this, this.__wbg_ptr, this);
        return this;
    }
    /**
     * What was found since the last call, and how far the stages are.
     * @returns {News[]}
     */
    news() {
        const ret = wasm.run_news(this.__wbg_ptr);
        return ret;
    }
    /**
     * Jobs that can be done now, at most so many. Where there are none, and none is under way, the run is over.
     * @param {number} most
     * @returns {Job[]}
     */
    next(most) {
        const ret = wasm.run_next(this.__wbg_ptr, most);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
    /**
     * What is to be done for a job whose files have these digests, SHA-256 in hexadecimal digits.
     * @param {number} id
     * @param {readonly string[]} digests
     * @returns {Work}
     */
    prepare(id, digests) {
        const ret = wasm.run_prepare(this.__wbg_ptr, id, digests);
        if (ret[2]) {
            throw takeFromExternrefTable0(ret[1]);
        }
        return takeFromExternrefTable0(ret[0]);
    }
}
if (Symbol.dispose) Run.prototype[Symbol.dispose] = Run.prototype.free;

/**
 * The keys of the options of a block that have an effect with these settings.
 * @param {Given<BlockSettings>} settings
 * @returns {string[]}
 */
export function acting_block_parameters(settings) {
    const ret = wasm.acting_block_parameters(settings);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The keys of the options of a pair that have an effect with these settings.
 * @param {Given<PairSettings>} settings
 * @returns {string[]}
 */
export function acting_parameters(settings) {
    const ret = wasm.acting_parameters(settings);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The interior orientations of a pair of whose cameras nothing is known but what its geometry tells; null where it is the map of a plane.
 * @param {Omit<TwoView, "inliers">} geometry
 * @param {PhotoFacts} left
 * @param {PhotoFacts} right
 * @returns {PairInterior | null}
 */
export function assumed_interior(geometry, left, right) {
    const ret = wasm.assumed_interior(geometry, left, right);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Every parameter of a block's flight on which photos depend.
 * @returns {Parameter[]}
 */
export function block_flight_parameters() {
    const ret = wasm.block_flight_parameters();
    return ret;
}

/**
 * A ready-made flight of a block.
 * @param {BlockPreset} name
 * @returns {BlockFlight}
 */
export function block_flight_preset(name) {
    const ret = wasm.block_flight_preset(name);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Every option of a block, in the order of the pipeline.
 * @returns {Parameter[]}
 */
export function block_parameters() {
    const ret = wasm.block_parameters();
    return ret;
}

/**
 * All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
 * @param {Given<BlockSettings>} given
 * @returns {BlockSettings}
 */
export function block_settings(given) {
    const ret = wasm.block_settings(given);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * What calls are given beside settings, by the names of their arguments.
 * @returns {Parameter[]}
 */
export function call_parameters() {
    const ret = wasm.call_parameters();
    return ret;
}

/**
 * What a block calls the camera of a photograph of this size in px: make, model, focal length and size.
 * @param {ExifCamera} camera
 * @param {number} width
 * @param {number} height
 * @returns {string}
 */
export function camera_label(camera, width, height) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.camera_label(camera, width, height);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * The camera of an EXIF block, with what is not known of it.
 * @param {ExifCamera} exif
 * @returns {CameraMm}
 */
export function camera_of_exif(exif) {
    const ret = wasm.camera_of_exif(exif);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The camera of a photo of which nothing but the focal length in px is known.
 * @param {number} focal_px
 * @returns {CameraMm}
 */
export function camera_of_focal_px(focal_px) {
    const ret = wasm.camera_of_focal_px(focal_px);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The candidates of one left point, the best first: index of the right point and measure, stride 2.
 * @param {number} index
 * @param {Float64Array | readonly number[]} left_points
 * @param {Float64Array | readonly number[]} left_descriptors
 * @param {Float64Array | readonly number[]} right_points
 * @param {Float64Array | readonly number[]} right_descriptors
 * @param {OffsetField} offset
 * @param {Given<MatchOptions>} options
 * @returns {Float64Array}
 */
export function candidates(index, left_points, left_descriptors, right_points, right_descriptors, offset, options) {
    const ret = wasm.candidates(index, left_points, left_descriptors, right_points, right_descriptors, offset, options);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
    return v1;
}

/**
 * The steps of edits that hold in another block, that was found or placed anew: by names of images and surveyed points, and by where places lie.
 * @param {Carrying} carrying
 * @returns {CarriedSteps}
 */
export function carried_steps(carrying) {
    const ret = wasm.carried_steps(carrying);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Refuses a truth of other images.
 * @param {BlockModel} truth
 * @param {readonly string[]} names
 */
export function check_block_truth(truth, names) {
    const ret = wasm.check_block_truth(truth, names);
    if (ret[1]) {
        throw takeFromExternrefTable0(ret[0]);
    }
}

/**
 * Refuses a file of cameras that cannot be read, or fits no image of these names, where there are any.
 * @param {string} text
 * @param {readonly string[]} names
 */
export function check_cameras(text, names) {
    const ret = wasm.check_cameras(text, names);
    if (ret[1]) {
        throw takeFromExternrefTable0(ret[0]);
    }
}

/**
 * Refuses ground control points and image measurements that a run of these images would refuse, as far as their names say. `on_orthophoto`:
 * whether one places the block afterwards.
 * @param {string} points
 * @param {string} marks
 * @param {readonly string[]} names
 * @param {Given<GeoreferencingOptions>} [placing]
 * @param {boolean} [on_orthophoto]
 */
export function check_control(points, marks, names, placing, on_orthophoto) {
    const ret = wasm.check_control(points, marks, names, placing, isLikeNone(on_orthophoto) ? 0xFFFFFF : on_orthophoto ? 1 : 0);
    if (ret[1]) {
        throw takeFromExternrefTable0(ret[0]);
    }
}

/**
 * Refuses a flight that [`simulate`] refuses, without rendering it; parameters that are absent are those of the sample.
 * @param {Given<Flight>} flight
 */
export function check_flight(flight) {
    const ret = wasm.check_flight(flight);
    if (ret[1]) {
        throw takeFromExternrefTable0(ret[0]);
    }
}

/**
 * Refuses the file of a geoid beside its height, and one without a coordinate system whose heights count from it.
 * @param {string} name
 * @param {Given<GeoreferencingOptions>} [placing]
 */
export function check_geoid(name, placing) {
    const ret = wasm.check_geoid(name, placing);
    if (ret[1]) {
        throw takeFromExternrefTable0(ret[0]);
    }
}

/**
 * Refuses what is no height of the ground, nor a file of heights.
 * @param {number | Uint8Array | FileInParts} heights
 * @param {Given<Sidecars>} [sidecars]
 */
export function check_heights(heights, sidecars) {
    const ret = wasm.check_heights(heights, sidecars);
    if (ret[1]) {
        throw takeFromExternrefTable0(ret[0]);
    }
}

/**
 * The groups of connected images of a block, the largest first.
 * @param {number} images
 * @param {Connection[]} connections
 * @returns {number[][]}
 */
export function connected_groups(images, connections) {
    const ret = wasm.connected_groups(images, connections);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The same offset (right minus left position, px) everywhere.
 * @param {number} dx
 * @param {number} dy
 * @returns {OffsetField}
 */
export function constant_offset(dx, dy) {
    const ret = wasm.constant_offset(dx, dy);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The defaults of all options.
 * @returns {PairSettings}
 */
export function defaults() {
    const ret = wasm.defaults();
    return ret;
}

/**
 * Draws the lines of matches whose two ends are both in view, from the left image's view to the right one's; returns how many.
 *
 * `matches`: stride 5, `x left, y left, x right, y right, measure` in px. `codes`: one a match, the index of its style; a code without
 * a style is not drawn. `widths` and `colours`: one a style. Views as of `draw_points`. Where more than `most` are in view, evenly many are drawn.
 * @param {CanvasRenderingContext2D} context
 * @param {Float64Array | readonly number[]} matches
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} codes
 * @param {Float64Array | readonly number[]} widths
 * @param {readonly string[]} colours
 * @param {Float64Array | readonly number[]} left_view
 * @param {Float64Array | readonly number[]} right_view
 * @param {number} most
 * @returns {number}
 */
export function draw_match_lines(context, matches, codes, widths, colours, left_view, right_view, most) {
    const ret = wasm.draw_match_lines(context, matches, codes, widths, colours, left_view, right_view, most);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return ret[0] >>> 0;
}

/**
 * Draws points; returns how many were drawn.
 *
 * `points`: stride 3, `x, y, value` in px. `codes`: one a point, the index of its style; a code without a style is not drawn.
 * `styles`: stride 3, `shape, half size, line width` in canvas units (shapes: 0 dot, 1 circle, 2 plus, 3 cross, 4 square,
 * 5 triangle up, 6 triangle down, 7 diamond). `colours`: one CSS colour a style. `view`: scale, shift x, shift y,
 * left, top, right, bottom: a position of the canvas is scale times that of the image plus the shift, and marks are drawn within the last four, in canvas
 * units. Styles are drawn in order,
 * the last on top; where points crowd, some are left out.
 * @param {CanvasRenderingContext2D} context
 * @param {Float64Array | readonly number[]} points
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} codes
 * @param {Float64Array | readonly number[]} styles
 * @param {readonly string[]} colours
 * @param {Float64Array | readonly number[]} view
 * @returns {number}
 */
export function draw_points(context, points, codes, styles, colours, view) {
    const ret = wasm.draw_points(context, points, codes, styles, colours, view);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return ret[0] >>> 0;
}

/**
 * Draws vectors as arrows from their points, enlarged `factor` times; returns how many.
 *
 * `vectors`: stride 4, `x, y, dx, dy` in px of the image. `codes`: one a vector, the index of its style; a code without a style is not drawn.
 * `widths` and `colours`: one a style. `view`: as of `draw_points`.
 * @param {CanvasRenderingContext2D} context
 * @param {Float64Array | readonly number[]} vectors
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} codes
 * @param {Float64Array | readonly number[]} widths
 * @param {readonly string[]} colours
 * @param {number} factor
 * @param {Float64Array | readonly number[]} view
 * @returns {number}
 */
export function draw_vectors(context, vectors, codes, widths, colours, factor, view) {
    const ret = wasm.draw_vectors(context, vectors, codes, widths, colours, factor, view);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return ret[0] >>> 0;
}

/**
 * Where a point of one image may be seen in the other, by the geometry that `match_photos` gave with the same interior orientations:
 * positions x, y in px along its epipolar line, or the one place that the map of a plane or a rotation gives; stride 2. Empty where the
 * line passes the other image, whose width and height are given.
 * @param {"left" | "right"} from
 * @param {number} x
 * @param {number} y
 * @param {TwoViewModel} model
 * @param {PairInterior | null} interior
 * @param {number} other_width
 * @param {number} other_height
 * @returns {Float64Array}
 */
export function epipolar_line(from, x, y, model, interior, other_width, other_height) {
    const ret = wasm.epipolar_line(from, x, y, model, interior, other_width, other_height);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
    return v1;
}

/**
 * Estimates the offsets between two images from `Photo.reduced(1024)` of each.
 * @param {ReducedImage} left
 * @param {ReducedImage} right
 * @returns {OffsetField}
 */
export function estimate_offset(left, right) {
    const ret = wasm.estimate_offset(left, right);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Does the task of a job: the same bytes give the same bytes, on every machine.
 * @param {string} task
 * @param {readonly Uint8Array[]} inputs
 * @returns {Uint8Array}
 */
export function execute_job(task, inputs) {
    const ret = wasm.execute_job(task, inputs);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
    return v1;
}

/**
 * The names of the formats that blocks are written in.
 * @returns {ExportFormat[]}
 */
export function export_formats() {
    const ret = wasm.export_formats();
    return ret;
}

/**
 * The defaults of the options of features.
 * @returns {FeatureOptions}
 */
export function feature_defaults() {
    const ret = wasm.feature_defaults();
    return ret;
}

/**
 * Why so few matches have no orientation, whatever else is missing; null where they are enough.
 * @param {number} matches
 * @returns {NoOrientation | null}
 */
export function few_matches(matches) {
    const ret = wasm.few_matches(matches);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The cameras of frames as a file of cameras has them, from that of each, before those that it has (`given`): frames of one film have one, for all images
 * whose names fit `pattern`, as `film_pattern` gives it.
 * @param {string} pattern
 * @param {CameraRule[]} rules
 * @param {CameraRule[]} given
 * @returns {CameraRule[]}
 */
export function film_cameras(pattern, rules, given) {
    const ret = wasm.film_cameras(pattern, rules, given);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Resamples the file of a scan by the fiducial marks that were measured in it: all scans of a camera become images of one ideal camera, of which a block
 * is made.
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} scan
 * @param {Given<FilmInput>} film
 * @param {FrameWanted} wanted
 * @returns {FilmFiles}
 */
export function film_frame(scan, film, wanted) {
    const ret = wasm.film_frame(scan, film, wanted);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Takes image measurements that were made in scans into their frames.
 * @param {ImageMeasurementRow[]} measurements
 * @param {FrameOfScan[]} frames
 * @returns {FramedMeasurements}
 */
export function film_measurements(measurements, frames) {
    const ret = wasm.film_measurements(measurements, frames);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The pattern of the names of frames of one film, whose first one has the camera `rule`, beside those of other films, whose cameras are `given`.
 * @param {CameraRule} rule
 * @param {CameraRule[]} given
 * @returns {string}
 */
export function film_pattern(rule, given) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.film_pattern(rule, given);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * The side of a pixel of a scan in mm, as its fiducial marks have it.
 * @param {Given<FilmInput>} film
 * @returns {number}
 */
export function film_pixel_mm(film) {
    const ret = wasm.film_pixel_mm(film);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return ret[0];
}

/**
 * Positions of a scan in its frame, or of a frame in its scan: x, y, x, y … in px, the centre of the top-left pixel at (0.5, 0.5). NaN where there is none,
 * as beside the frame. `to`: `frame` or `scan`.
 * @param {FilmScan} scan
 * @param {Float64Array | readonly number[]} positions
 * @param {'frame' | 'scan'} to
 * @returns {Float64Array}
 */
export function film_positions(scan, positions, to) {
    const ret = wasm.film_positions(scan, positions, to);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * What is to be said of the camera of a scan: that the side of a pixel that it gives is another than that of the marks, and not used; null where there is
 * nothing.
 * @param {Given<FilmInput>} film
 * @returns {Warning | null}
 */
export function film_warning(film) {
    const ret = wasm.film_warning(film);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Every parameter of a flight.
 * @returns {Parameter[]}
 */
export function flight_parameters() {
    const ret = wasm.flight_parameters();
    return ret;
}

/**
 * A ready-made flight.
 * @param {Preset} name
 * @returns {Flight}
 */
export function flight_preset(name) {
    const ret = wasm.flight_preset(name);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The names of the ready-made flights.
 * @returns {Preset[]}
 */
export function flight_presets() {
    const ret = wasm.flight_presets();
    return ret;
}

/**
 * Longitudes, latitudes and heights (stride 3) of positions in m east, north and up of an origin, which is their first row: of the others alone.
 * @param {Float64Array | readonly number[]} positions
 * @returns {Float64Array}
 */
export function geographic_positions(positions) {
    const ret = wasm.geographic_positions(positions);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The right points in the order of their distance from the left one of an index, up to `most`: index and measure, stride 2.
 * @param {number} index
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} left_gradients
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} right_gradients
 * @param {number} most
 * @returns {Float64Array}
 */
export function gradient_candidates(index, left_gradients, right_gradients, most) {
    const ret = wasm.gradient_candidates(index, left_gradients, right_gradients, most);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
    return v1;
}

/**
 * Writes grey values as a PNG file, with the camera and the position of `exif` where it is given.
 * @param {number} width
 * @param {number} height
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} grey
 * @param {ExifImage} [exif]
 * @returns {Uint8Array}
 */
export function grey_png(width, height, grey, exif) {
    const ret = wasm.grey_png(width, height, grey, exif);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
    return v1;
}

/**
 * The table of image measurements, which reads back as they are.
 * @param {ImageMeasurementRow[]} measurements
 * @returns {string}
 */
export function image_measurement_table(measurements) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.image_measurement_table(measurements);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * The GNSS position that an image records; null where it records none. Of a file in parts no more than its EXIF is read: of a TIFF its directories, wherever
 * they lie, of other images what stands in their first 256 KiB.
 * @param {Uint8Array | FileInParts} file
 * @returns {ExifPosition | null}
 */
export function image_position(file) {
    const ret = wasm.image_position(file);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The interior orientation of an image: from its fiducials, or from the camera's pixel size.
 * @param {CameraMm} camera
 * @param {PhotoGeometry} photo
 * @returns {Interior}
 */
export function interior(camera, photo) {
    const ret = wasm.interior(camera, photo);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The matches of pieces that follow each other from the first left descriptor to the last: those of the whole, whatever the pieces.
 * @param {NearestPiece[]} pieces
 * @param {Given<NearestOptions>} options
 * @returns {DescriptorMatches}
 */
export function join_nearest(pieces, options) {
    const ret = wasm.join_nearest(pieces, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Positions in m east, north and up of the first known one: of longitude, latitude in degrees and height in m (stride 3), NaN where not known.
 * @param {Float64Array | readonly number[]} geographic
 * @returns {Float64Array}
 */
export function local_positions(geographic) {
    const ret = wasm.local_positions(geographic);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The index of the mask of each image, by their names; -1 for an image without one. Refuses two masks of one image.
 * @param {readonly string[]} names
 * @param {readonly string[]} masks
 * @returns {Int32Array}
 */
export function masks_of_images(names, masks) {
    const ret = wasm.masks_of_images(names, masks);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayI32FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
    return v1;
}

/**
 * Matches and orients two photos whose points are described: the rest of `match_pair`. For the strategy gradient the nearest descriptors may
 * have been searched for already: the pieces that `nearest_piece` made of all left points, in their order.
 * @param {Photo} left
 * @param {Photo} right
 * @param {GivenPoints} left_points
 * @param {GivenPoints} right_points
 * @param {Given<PairInput>} input
 * @param {Given<PairSettings>} settings
 * @param {NearestPiece[]} [nearest]
 * @returns {MatchedPair}
 */
export function match_described_pair(left, right, left_points, right_points, input, settings, nearest) {
    _assertClass(left, Photo);
    _assertClass(right, Photo);
    const ret = wasm.match_described_pair(left.__wbg_ptr, right.__wbg_ptr, left_points, right_points, input, settings, nearest);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Matches byte descriptors of 128 bytes each: exact nearest neighbours, the ratio to the second nearest, the same from both sides.
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} left
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} right
 * @param {Given<NearestOptions>} options
 * @returns {DescriptorMatches}
 */
export function match_descriptors(left, right, options) {
    const ret = wasm.match_descriptors(left, right, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Matches the features of two images (positions x, y in px, stride 2; 128 bytes each) by nearest descriptors, verified by the geometry of
 * the two views and completed along its lines. Where `options.geometry` names cameras, positions are those of cameras without distortion.
 * @param {Float64Array | readonly number[]} left_positions
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} left_descriptors
 * @param {Float64Array | readonly number[]} right_positions
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} right_descriptors
 * @param {Given<FeatureMatchOptions>} options
 * @returns {VerifiedMatches}
 */
export function match_features(left_positions, left_descriptors, right_positions, right_descriptors, options) {
    const ret = wasm.match_features(left_positions, left_descriptors, right_positions, right_descriptors, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Matches byte descriptors near the epipolar line, or the place, of each left point: positions x, y in px (stride 2), 128 bytes each.
 * @param {Float64Array | readonly number[]} left_positions
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} left_descriptors
 * @param {Float64Array | readonly number[]} right_positions
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} right_descriptors
 * @param {MatchGuide} guide
 * @param {Given<GuidedOptions>} options
 * @returns {DescriptorMatches}
 */
export function match_guided_descriptors(left_positions, left_descriptors, right_positions, right_descriptors, guide, options) {
    const ret = wasm.match_guided_descriptors(left_positions, left_descriptors, right_positions, right_descriptors, guide, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Matches and orients a pair on one thread. Points whose pixel is 0 in the mask of their image, of its size and row by row, are left out.
 * @param {Photo} left
 * @param {Photo} right
 * @param {Given<PairInput>} input
 * @param {Given<PairSettings>} settings
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null} [left_mask]
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer | null} [right_mask]
 * @returns {PairOutput}
 */
export function match_pair(left, right, input, settings, left_mask, right_mask) {
    _assertClass(left, Photo);
    _assertClass(right, Photo);
    const ret = wasm.match_pair(left.__wbg_ptr, right.__wbg_ptr, input, settings, isLikeNone(left_mask) ? 0 : addToExternrefTable0(left_mask), isLikeNone(right_mask) ? 0 : addToExternrefTable0(right_mask));
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Matches two photos by any strategy.
 *
 * With `matching.epipolar` and an interior orientation the pair is oriented and matched again along the epipolar lines, until nothing
 * changes. Only the strategy gradient does without an offset. It finds the nearest descriptors itself, unless it is given the pieces that
 * `nearest_piece` made of all left points, in their order: the matches are the same.
 * @param {Photo} left
 * @param {Photo} right
 * @param {GivenPoints} left_points
 * @param {GivenPoints} right_points
 * @param {OffsetField | null} offset
 * @param {PairInterior | null} interior
 * @param {Given<PairSettings>} settings
 * @param {NearestPiece[]} [nearest]
 * @returns {MatchResult}
 */
export function match_photos(left, right, left_points, right_points, offset, interior, settings, nearest) {
    _assertClass(left, Photo);
    _assertClass(right, Photo);
    const ret = wasm.match_photos(left.__wbg_ptr, right.__wbg_ptr, left_points, right_points, offset, interior, settings, nearest);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Matches described points: points of stride 3, descriptors of stride 7.
 * @param {Float64Array | readonly number[]} left_points
 * @param {Float64Array | readonly number[]} left_descriptors
 * @param {Float64Array | readonly number[]} right_points
 * @param {Float64Array | readonly number[]} right_descriptors
 * @param {OffsetField} offset
 * @param {Given<MatchOptions>} options
 * @returns {MatchResult}
 */
export function match_points(left_points, left_descriptors, right_points, right_descriptors, offset, options) {
    const ret = wasm.match_points(left_points, left_descriptors, right_points, right_descriptors, offset, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Writes matches (stride 5) as CSV, each with its state: used or rejected by the orientation whose `rejected` is given, empty without.
 * @param {Float64Array | readonly number[]} matches
 * @param {readonly number[] | null} [rejected]
 * @returns {string}
 */
export function matches_csv(matches, rejected) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.matches_csv(matches, rejected);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * The text of a message, or, by its name, another text that belongs to it, as its `label`; in English, or in the language of a tag (`ar`)
 * that there is a catalogue of.
 * @param {string} family
 * @param {any} message
 * @param {string | null} [attribute]
 * @param {string | null} [language]
 * @returns {string}
 */
export function message(family, message, attribute, language) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.message(family, message, isLikeNone(attribute) ? 0 : addToExternrefTable0(attribute), isLikeNone(language) ? 0 : addToExternrefTable0(language));
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * Object points of observations (stride 4) that are oriented as `orient_relative` does: X, Y, Z, their standard errors (NaN where there are
 * none), 1 where the observation took part and 0 where it was rejected; stride 7, NaN for parallel rays. `base`: the length of the base in
 * the unit that the points shall have; 1: the base is the unit.
 * @param {Float64Array | readonly number[]} observations
 * @param {number} focal_mm
 * @param {Given<OrientationOptions>} options
 * @param {number} base
 * @param {Float64Array | readonly number[] | null} [weights]
 * @returns {Float64Array}
 */
export function model_points(observations, focal_mm, options, base, weights) {
    const ret = wasm.model_points(observations, focal_mm, options, base, isLikeNone(weights) ? 0 : addToExternrefTable0(weights));
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
    return v1;
}

/**
 * Writes object points of a pair (stride 7, as `model_points` gives them) as CSV.
 * @param {Float64Array | readonly number[]} points
 * @returns {string}
 */
export function model_points_csv(points) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.model_points_csv(points);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * The nearest right descriptors of left ones from `first` to before `end`: a piece of the work, for `join_nearest` and
 * `match_photos`.
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} left
 * @param {number} first
 * @param {number} end
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} right
 * @returns {NearestPiece}
 */
export function nearest_piece(left, first, end, right) {
    const ret = wasm.nearest_piece(left, first, end, right);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Photo coordinates x, y left, x, y right in mm (stride 4) of matches (stride 5).
 * @param {Float64Array | readonly number[]} matches
 * @param {Interior} left
 * @param {Interior} right
 * @returns {Float64Array}
 */
export function observations(matches, left, right) {
    const ret = wasm.observations(matches, left, right);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
    return v1;
}

/**
 * Why matches (stride 5) between images of these sizes in px have no base: they are one photo twice, or parts of one image. Null where
 * they are neither.
 * @param {Float64Array | readonly number[]} matches
 * @param {number} left_width
 * @param {number} left_height
 * @param {number} right_width
 * @param {number} right_height
 * @returns {NoOrientation | null}
 */
export function one_image(matches, left_width, left_height, right_width, right_height) {
    const ret = wasm.one_image(matches, left_width, left_height, right_width, right_height);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Opens the project file of a pair; one that is damaged or of another kind is refused whole.
 * @param {string | Uint8Array | Uint8ClampedArray | ArrayBuffer} file
 * @returns {PairProject}
 */
export function open_pair_project(file) {
    const ret = wasm.open_pair_project(file);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Interior orientation by fiducial marks.
 * @param {Fiducial[]} fiducials
 * @param {FiducialModel} model
 * @returns {FiducialOrientation}
 */
export function orient_fiducials(fiducials, model) {
    const ret = wasm.orient_fiducials(fiducials, model);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Relative orientation from matches (stride 5) with what least squares matching found of them (stride 5, as `MatchResult.fits`; empty: all
 * of weight 1), with the verdict on it. `points`: how many the left and the right image have, where they were matched. The total standard errors hold those of the interior orientations, where these have covariances.
 * @param {Float64Array | readonly number[]} matches
 * @param {Float64Array | readonly number[]} fits
 * @param {PairInterior} interior
 * @param {Given<OrientationOptions>} options
 * @param {[number, number]} [points]
 * @returns {OrientedPair}
 */
export function orient_matches(matches, fits, interior, options, points) {
    const ret = wasm.orient_matches(matches, fits, interior, options, points);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Relative orientation of observations x, y left, x, y right in mm (stride 4), each of its weight, or all of weight 1, with the verdict on it.
 * @param {Float64Array | readonly number[]} observations
 * @param {number} focal_mm
 * @param {Given<OrientationOptions>} options
 * @param {Float64Array | readonly number[] | null} [weights]
 * @returns {OrientedPair}
 */
export function orient_relative(observations, focal_mm, options, weights) {
    const ret = wasm.orient_relative(observations, focal_mm, options, isLikeNone(weights) ? 0 : addToExternrefTable0(weights));
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The cameras of a pair, the given one or those of its files, with what speaks against them; or what is missing.
 * @param {CameraMm | null} given
 * @param {PhotoFacts} left
 * @param {PhotoFacts} right
 * @returns {PairCameras | { missing: NoOrientation }}
 */
export function pair_cameras(given, left, right) {
    const ret = wasm.pair_cameras(given, left, right);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * What else would do for a pair of this verdict and these settings; null where nothing is known to. With how the photos lie to each other
 * (`photo_difference`), and the offset by which matches were looked for, it says which of that the strategy does not take.
 * @param {PairVerdict} verdict
 * @param {Given<PairSettings>} settings
 * @param {PhotoDifference | null} [difference]
 * @param {OffsetField | null} [offset]
 * @returns {PairHint | null}
 */
export function pair_hint(verdict, settings, difference, offset) {
    const ret = wasm.pair_hint(verdict, settings, difference, offset);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Ready-made settings.
 * @param {PairPreset} name
 * @returns {PairSettings}
 */
export function pair_preset(name) {
    const ret = wasm.pair_preset(name);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The names of ready-made settings.
 * @returns {PairPreset[]}
 */
export function pair_presets() {
    const ret = wasm.pair_presets();
    return ret;
}

/**
 * What the paper printed for its own pair.
 * @returns {Paper}
 */
export function paper() {
    const ret = wasm.paper();
    return ret;
}

/**
 * How far the y-parallax of one left point is from those of its nearest matches, and how far it may be; absent where it has no place or nothing is near.
 * Rules and places are those of a `MatchResult`.
 * @param {number} index
 * @param {Float64Array | readonly number[]} left_points
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} rules
 * @param {Float64Array | readonly number[]} places
 * @param {OffsetField} offset
 * @param {Given<MatchOptions>} options
 * @returns {ParallaxDeviation | undefined}
 */
export function parallax_deviation(index, left_points, rules, places, offset, options) {
    const ret = wasm.parallax_deviation(index, left_points, rules, places, offset, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Every option of a pair, in the order of the pipeline.
 * @returns {Parameter[]}
 */
export function parameters() {
    const ret = wasm.parameters();
    return ret;
}

/**
 * Reads a camera: {"focal_mm", "principal_point_mm", "pixel_mm", "radial_distortion", "tangential_distortion"}.
 * @param {string} json
 * @returns {CameraMm}
 */
export function parse_camera(json) {
    const ret = wasm.parse_camera(json);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Reads cameras that hold for the images whose names fit a pattern.
 * @param {string} json
 * @returns {CameraRule[]}
 */
export function parse_camera_rules(json) {
    const ret = wasm.parse_camera_rules(json);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Reads fiducial marks: columns col, row, x_mm, y_mm.
 * @param {string} csv
 * @returns {Fiducial[]}
 */
export function parse_fiducials(csv) {
    const ret = wasm.parse_fiducials(csv);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Reads surveyed points: lines of name, x, y, z and perhaps two standard errors.
 * @param {string} text
 * @returns {GroundControlRow[]}
 */
export function parse_ground_control_points(text) {
    const ret = wasm.parse_ground_control_points(text);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Reads where images show surveyed points: lines of image, point, x, y in px. `images`: names of images, which stand in the rows where the
 * table means them, by other capitals, with a folder or without their ending.
 * @param {string} text
 * @param {readonly string[] | null} [images]
 * @returns {ImageMeasurementRow[]}
 */
export function parse_image_measurements(text, images) {
    const ret = wasm.parse_image_measurements(text, isLikeNone(images) ? 0 : addToExternrefTable0(images));
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Reads GNSS positions of images: lines of image, longitude, latitude and height, or of image, x, y and height, and perhaps two standard errors.
 * @param {string} text
 * @returns {ImagePositions}
 */
export function parse_image_positions(text) {
    const ret = wasm.parse_image_positions(text);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Reads photo coordinates: columns x_left_mm, y_left_mm, x_right_mm, y_right_mm; stride 4.
 * @param {string} csv
 * @returns {Float64Array}
 */
export function parse_observations(csv) {
    const ret = wasm.parse_observations(csv);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayF64FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 8, 8);
    return v1;
}

/**
 * A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
 * @param {Camera} camera
 * @returns {CameraMm}
 */
export function photo_camera(camera) {
    const ret = wasm.photo_camera(camera);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * How the right photo lies to the left one in their planes; null where they do not match, however they lie.
 * @param {Photo} left
 * @param {Photo} right
 * @returns {PhotoDifference | null}
 */
export function photo_difference(left, right) {
    _assertClass(left, Photo);
    _assertClass(right, Photo);
    const ret = wasm.photo_difference(left.__wbg_ptr, right.__wbg_ptr);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The tables of images that were placed: of the images, and of their links.
 * @param {readonly string[]} names
 * @param {readonly PlacedImage[]} placed
 * @returns {{ placed: string; links: string }}
 */
export function placed_tables(names, placed) {
    const ret = wasm.placed_tables(names, placed);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Their defaults.
 * @returns {PlacingOptions}
 */
export function placing_defaults() {
    const ret = wasm.placing_defaults();
    return ret;
}

/**
 * Every option of placing images.
 * @returns {Parameter[]}
 */
export function placing_parameters() {
    const ret = wasm.placing_parameters();
    return ret;
}

/**
 * The files that a block of images with these names is written to, but for those of which there is one for each two images.
 * @param {readonly string[]} names
 * @param {readonly ExportFormat[]} formats
 * @returns {string[]}
 */
export function planned_files(names, formats) {
    const ret = wasm.planned_files(names, formats);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayJsValueFromWasm0(ret[0], ret[1]);
    wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
    return v1;
}

/**
 * Writes points (stride 3) as CSV.
 * @param {Float64Array | readonly number[]} points
 * @returns {string}
 */
export function points_csv(points) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.points_csv(points);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
 * The GNSS position that a table gives to each image, by their names; null where it gives none. Refuses a table that a run of these images would refuse.
 * Heights in a coordinate reference system whose geoid is a file count from its zero here.
 * @param {string} text
 * @param {readonly string[]} names
 * @param {Given<GeoreferencingOptions>} [placing]
 * @returns {(GivenPosition | null)[]}
 */
export function positions_of_images(text, names, placing) {
    const ret = wasm.positions_of_images(text, names, placing);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * What a project file holds, by its first kilobyte; null for what is no project.
 * @param {string | Uint8Array | Uint8ClampedArray | ArrayBuffer} start
 * @returns {ProjectKind | null}
 */
export function project_kind(start) {
    const ret = wasm.project_kind(start);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * What EXIF tells of an image of this size beside its pixels.
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} file
 * @param {number} width
 * @param {number} height
 * @returns {ExifImage}
 */
export function read_exif(file, width, height) {
    const ret = wasm.read_exif(file, width, height);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Why a file is refused whose first bytes, or the ending of whose name where these say nothing, are those of a kind that is not decoded (HEIC, raw, film, …);
 * null for all others. 64 bytes tell every kind but raw files that are TIFFs.
 * @param {string} name
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} start
 * @returns {{ kind: string } | null}
 */
export function refused_kind(name, start) {
    const ret = wasm.refused_kind(name, start);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * What is to be said of a table of GNSS positions beside images of these names: columns that are not understood, rows of other images.
 * @param {string} text
 * @param {readonly string[]} names
 * @returns {Remark[]}
 */
export function remarks_of_positions(text, names) {
    const ret = wasm.remarks_of_positions(text, names);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Settings with every absent option that follows from the others, as all calls take them; what follows from the images stays absent.
 * @param {Given<PairSettings>} settings
 * @returns {PairSettings}
 */
export function resolved(settings) {
    const ret = wasm.resolved(settings);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The names of the rules, in the order of their codes.
 * @returns {Rule[]}
 */
export function rule_names() {
    const ret = wasm.rule_names();
    return ret;
}

/**
 * The same rays at a focal length `factor` times as long: two photos of different focal lengths are oriented at one of them.
 * @param {Interior} interior
 * @param {number} factor
 * @returns {Interior}
 */
export function scaled_interior(interior, factor) {
    const ret = wasm.scaled_interior(interior, factor);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Scores an oriented block by the truth of its photos, which have the same names.
 * @param {BlockModel} model
 * @param {BlockModel} truth
 * @returns {BlockScore}
 */
export function score_block(model, truth) {
    const ret = wasm.score_block(model, truth);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Scores matches (stride 5) of left points (stride 3) by the truth of a simulated pair.
 * @param {Float64Array | readonly number[]} matches
 * @param {Float64Array | readonly number[]} left_points
 * @param {Float32Array | readonly number[]} right_position
 * @param {number} left_width
 * @param {number} left_height
 * @param {number} right_width
 * @param {number} right_height
 * @returns {MatchScore}
 */
export function score_matches(matches, left_points, right_position, left_width, left_height, right_width, right_height) {
    const ret = wasm.score_matches(matches, left_points, right_position, left_width, left_height, right_width, right_height);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * SHA-256 (FIPS 180-4) of bytes: 32 bytes.
 * @param {Uint8Array | Uint8ClampedArray | ArrayBuffer} bytes
 * @returns {Uint8Array}
 */
export function sha256(bytes) {
    const ret = wasm.sha256(bytes);
    if (ret[3]) {
        throw takeFromExternrefTable0(ret[2]);
    }
    var v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
    wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
    return v1;
}

/**
 * Renders the pair of a flight; parameters that are absent are those of the sample.
 * @param {Given<Flight>} flight
 * @returns {SamplePair}
 */
export function simulate(flight) {
    const ret = wasm.simulate(flight);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Coordinates in a system (an EPSG code, PROJ text or WKT) of longitudes, latitudes in degrees and heights in m (stride 3): x, east or longitude,
 * first; NaN outside the system, an error where the median of the places lies there.
 * @param {string} crs
 * @param {Float64Array | readonly number[]} geographic
 * @param {CountedFrom | null} [heights]
 * @returns {Float64Array}
 */
export function system_coordinates(crs, geographic, heights) {
    const ret = wasm.system_coordinates(crs, geographic, heights);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The way back: longitudes, latitudes and heights of coordinates in a system (stride 3).
 * @param {string} crs
 * @param {Float64Array | readonly number[]} coordinates
 * @param {CountedFrom | null} [heights]
 * @returns {Float64Array}
 */
export function system_positions(crs, coordinates, heights) {
    const ret = wasm.system_positions(crs, coordinates, heights);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * Throws a panic as an error named `Panic`, which is a bug: a trap without one is memory that ran out.
 */
export function throw_panics() {
    wasm.throw_panics();
}

/**
 * The geometry of two images from matches x, y left, x, y right in px (stride 4), of which many may be wrong.
 * @param {Float64Array | readonly number[]} points
 * @param {Given<TwoViewOptions>} options
 * @returns {TwoViewResult}
 */
export function two_view(points, options) {
    const ret = wasm.two_view(points, options);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

/**
 * The version of the crate.
 * @returns {string}
 */
export function version() {
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

/**
 * Writes the project file of a pair.
 * @param {PairProject} project
 * @returns {string}
 */
export function write_pair_project(project) {
    let deferred2_0;
    let deferred2_1;
    try {
        const ret = wasm.write_pair_project(project);
        var ptr1 = ret[0];
        var len1 = ret[1];
        if (ret[3]) {
            ptr1 = 0; len1 = 0;
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
    const import0 = {
        __proto__: null,
        __wbg___wbindgen_debug_string_f249a2a76caa9a55: function(arg0, arg1) {
            const ret = debugString(arg1);
            const ptr1 = passStringToWasm0(ret, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
            const len1 = WASM_VECTOR_LEN;
            getDataViewMemory0().setInt32((arg0 >>> 0) + 4 * 1, len1, true);
            getDataViewMemory0().setInt32((arg0 >>> 0) + 4 * 0, ptr1, true);
        },
        __wbg___wbindgen_is_bigint_5fa10641e039d3ef: function(arg0) {
            const ret = typeof(arg0) === 'bigint';
            return ret;
        },
        __wbg___wbindgen_is_function_741ff2bb612836f5: function(arg0) {
            const ret = typeof(arg0) === 'function';
            return ret;
        },
        __wbg___wbindgen_is_null_c22311b1cc228e3a: function(arg0) {
            const ret = arg0 === null;
            return ret;
        },
        __wbg___wbindgen_is_object_8b968c3ab8e96595: function(arg0) {
            const val = arg0;
            const ret = typeof(val) === 'object' && val !== null;
            return ret;
        },
        __wbg___wbindgen_is_symbol_f846131a047725ea: function(arg0) {
            const ret = typeof(arg0) === 'symbol';
            return ret;
        },
        __wbg___wbindgen_is_undefined_be5b34249ff1fc15: function(arg0) {
            const ret = arg0 === undefined;
            return ret;
        },
        __wbg___wbindgen_number_get_934b640d0889af78: function(arg0, arg1) {
            const obj = arg1;
            const ret = typeof(obj) === 'number' ? obj : undefined;
            getDataViewMemory0().setFloat64((arg0 >>> 0) + 8 * 1, isLikeNone(ret) ? 0 : ret, true);
            getDataViewMemory0().setInt32((arg0 >>> 0) + 4 * 0, !isLikeNone(ret), true);
        },
        __wbg___wbindgen_rethrow_d953c34c2e20677f: function(arg0) {
            throw arg0;
        },
        __wbg___wbindgen_string_get_7ce8eee7fd327545: function(arg0, arg1) {
            const obj = arg1;
            const ret = typeof(obj) === 'string' ? obj : undefined;
            var ptr1 = isLikeNone(ret) ? 0 : passStringToWasm0(ret, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
            var len1 = WASM_VECTOR_LEN;
            getDataViewMemory0().setInt32((arg0 >>> 0) + 4 * 1, len1, true);
            getDataViewMemory0().setInt32((arg0 >>> 0) + 4 * 0, ptr1, true);
        },
        __wbg___wbindgen_throw_4c88d8bf264fd984: function(arg0, arg1) {
            const words = getStringFromWasm0(arg0, arg1);
        if (words !== 'null pointer passed to rust') throw new Error(words);
        const error = { kind: 'invalid-input', refusal: { kind: 'freed_object' } };
        throw Object.assign(new Error(message('error', error)), { name: 'TiepointError', code: 'invalid-input', usage: false, error });
        },
        __wbg___wbindgen_typeof_ee4990276e02f607: function(arg0) {
            const ret = typeof arg0;
            return ret;
        },
        __wbg__wbg_cb_unref_09736879a3f67559: function(arg0) {
            arg0._wbg_cb_unref();
        },
        __wbg_arc_df3f7eb77e59876f: function() { return handleError(function (arg0, arg1, arg2, arg3, arg4, arg5) {
            arg0.arc(arg1, arg2, arg3, arg4, arg5);
        }, arguments); },
        __wbg_assign_6b6bb30388088072: function(arg0, arg1) {
            const ret = Object.assign(arg0, arg1);
            return ret;
        },
        __wbg_beginPath_ab690dc0c7efe6dc: function(arg0) {
            arg0.beginPath();
        },
        __wbg_call_fc92fee6137d452d: function() { return handleError(function (arg0, arg1, arg2, arg3) {
            const ret = arg0.call(arg1, arg2, arg3);
            return ret;
        }, arguments); },
        __wbg_closePath_e9e11e034c5d75a3: function(arg0) {
            arg0.closePath();
        },
        __wbg_deleteProperty_3ad7a085da623822: function() { return handleError(function (arg0, arg1) {
            const ret = Reflect.deleteProperty(arg0, arg1);
            return ret;
        }, arguments); },
        __wbg_fill_cb36fe21a8d46cd7: function(arg0) {
            arg0.fill();
        },
        __wbg_from_eac91875c8a5ffa4: function(arg0) {
            const ret = Array.from(arg0);
            return ret;
        },
        __wbg_get_2080c49015e35254: function() { return handleError(function (arg0, arg1) {
            const ret = Reflect.get(arg0, arg1);
            return ret;
        }, arguments); },
        __wbg_get_unchecked_e6325ad374eff861: function(arg0, arg1) {
            const ret = arg0[arg1 >>> 0];
            return ret;
        },
        __wbg_instanceof_Error_74e3cca0c4a69161: function(arg0) {
            let result;
            try {
                result = arg0 instanceof Error;
            } catch (_) {
                result = false;
            }
            const ret = result;
            return ret;
        },
        __wbg_instanceof_Float32Array_94718abab7dc1d7f: function(arg0) {
            let result;
            try {
                result = arg0 instanceof Float32Array;
            } catch (_) {
                result = false;
            }
            const ret = result;
            return ret;
        },
        __wbg_instanceof_Uint32Array_ba721c3060d01f9a: function(arg0) {
            let result;
            try {
                result = arg0 instanceof Uint32Array;
            } catch (_) {
                result = false;
            }
            const ret = result;
            return ret;
        },
        __wbg_instanceof_Uint8Array_d7aeb0dcb3108fea: function(arg0) {
            let result;
            try {
                result = arg0 instanceof Uint8Array;
            } catch (_) {
                result = false;
            }
            const ret = result;
            return ret;
        },
        __wbg_isArray_bcf1376d0d732d08: function(arg0) {
            const ret = Array.isArray(arg0);
            return ret;
        },
        __wbg_length_03a2b32a9178fe11: function(arg0) {
            const ret = arg0.length;
            return ret;
        },
        __wbg_length_186163212ffe79c3: function(arg0) {
            const ret = arg0.length;
            return ret;
        },
        __wbg_length_5a8bb8abe1e54e15: function(arg0) {
            const ret = arg0.length;
            return ret;
        },
        __wbg_length_6e9d2869242cabf3: function(arg0) {
            const ret = arg0.length;
            return ret;
        },
        __wbg_length_b03a0fabb109b1e9: function(arg0) {
            const ret = arg0.length;
            return ret;
        },
        __wbg_length_c702d06d28b96b72: function(arg0) {
            const ret = arg0.length;
            return ret;
        },
        __wbg_lineTo_91262b25fb37c461: function(arg0, arg1, arg2) {
            arg0.lineTo(arg1, arg2);
        },
        __wbg_message_43d8c8f1d543a349: function(arg0) {
            const ret = arg0.message;
            return ret;
        },
        __wbg_moveTo_b4cd3b0b7e1585a5: function(arg0, arg1, arg2) {
            arg0.moveTo(arg1, arg2);
        },
        __wbg_new_13de428334042d26: function(arg0) {
            const ret = new Uint8Array(arg0);
            return ret;
        },
        __wbg_new_22589e9be6cca455: function(arg0) {
            const ret = new Float64Array(arg0);
            return ret;
        },
        __wbg_new_37eb45aaf5eeb820: function() {
            const ret = new Array();
            return ret;
        },
        __wbg_new_68957d2a912dfa0a: function(arg0) {
            const ret = new Int32Array(arg0);
            return ret;
        },
        __wbg_new_787b9fb330d55d78: function(arg0, arg1) {
            const ret = new Error(getStringFromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_a2eeb1f991f36b47: function(arg0) {
            const ret = new Uint32Array(arg0);
            return ret;
        },
        __wbg_new_cd4348290afae586: function() {
            const ret = new Object();
            return ret;
        },
        __wbg_new_from_slice_1ed4a41a79189233: function(arg0, arg1) {
            const ret = new Uint16Array(getArrayU16FromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_from_slice_3512352010266e02: function(arg0, arg1) {
            const ret = new Uint32Array(getArrayU32FromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_from_slice_355c10c5d8f2addb: function(arg0, arg1) {
            const ret = new Float32Array(getArrayF32FromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_from_slice_aaf85a9746711968: function(arg0, arg1) {
            const ret = new Float64Array(getArrayF64FromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_from_slice_b8daf545a41c6aa0: function(arg0, arg1) {
            const ret = new Uint8Array(getArrayU8FromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_from_slice_e0c60a796e12bb7c: function(arg0, arg1) {
            const ret = new Int32Array(getArrayI32FromWasm0(arg0, arg1));
            return ret;
        },
        __wbg_new_with_length_07edd8a7019b8c30: function(arg0) {
            const ret = new Float64Array(arg0 >>> 0);
            return ret;
        },
        __wbg_parse_c3f72b5a24f83c01: function() { return handleError(function (arg0, arg1) {
            const ret = JSON.parse(getStringFromWasm0(arg0, arg1));
            return ret;
        }, arguments); },
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
        __wbg_read_c75dcf30dfdc2d25: function() { return handleError(function (arg0, arg1, arg2) {
            const ret = arg0.read(arg1, arg2);
            return ret;
        }, arguments); },
        __wbg_rect_ab5601e64afdbc33: function(arg0, arg1, arg2, arg3, arg4) {
            arg0.rect(arg1, arg2, arg3, arg4);
        },
        __wbg_set_2793479888329cb6: function() { return handleError(function (arg0, arg1, arg2) {
            const ret = Reflect.set(arg0, arg1, arg2);
            return ret;
        }, arguments); },
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
            const ret = arg0.size;
            return ret;
        },
        __wbg_stringify_b090af1e2fcbfede: function() { return handleError(function (arg0, arg1) {
            const ret = JSON.stringify(arg0, arg1);
            return ret;
        }, arguments); },
        __wbg_stroke_19fa3f3ec093bc25: function(arg0) {
            arg0.stroke();
        },
        __wbg_toStringTag_1bdd39ac5d866229: function() {
            const ret = Symbol.toStringTag;
            return ret;
        },
        __wbindgen_generic_0000000000000001: function(arg0, arg1) {
            // Cast intrinsic for `Closure(Closure { owned: true, function: Function { arguments: [Externref, Externref], shim_idx: 18, ret: Result(Externref), inner_ret: Some(Result(Externref)) }, mutable: false }) -> Externref`.
            const ret = makeClosure(arg0, arg1, wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9);
            return ret;
        },
        __wbindgen_generic_0000000000000002: function(arg0) {
            // Cast intrinsic for `F64 -> Externref`.
            const ret = arg0;
            return ret;
        },
        __wbindgen_generic_0000000000000003: function(arg0, arg1) {
            // Cast intrinsic for `Ref(String) -> Externref`.
            const ret = getStringFromWasm0(arg0, arg1);
            return ret;
        },
        __wbindgen_init_externref_table: function() {
            const table = wasm.__wbindgen_externrefs;
            table.set(0, undefined);
            table.set(1024, undefined);
            table.set(1025, null);
            table.set(1026, true);
            table.set(1027, false);
        },
    };
    return {
        __proto__: null,
        "./tiepoint_bg.js": import0,
    };
}

function wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9(arg0, arg1, arg2, arg3) {
    const ret = wasm.wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9(arg0, arg1, arg2, arg3);
    if (ret[2]) {
        throw takeFromExternrefTable0(ret[1]);
    }
    return takeFromExternrefTable0(ret[0]);
}

const BlockOnOrthophotoFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_blockonorthophoto_free(ptr, 1));
const BlockSceneFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_blockscene_free(ptr, 1));
const BlockWritingFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_blockwriting_free(ptr, 1));
const EpipolarPairFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_epipolarpair_free(ptr, 1));
const FinishedBlockFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_finishedblock_free(ptr, 1));
const OrthoMosaicFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_orthomosaic_free(ptr, 1));
const OrthophotoReferenceFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_orthophotoreference_free(ptr, 1));
const PhotoFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_photo_free(ptr, 1));
const ReportFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_report_free(ptr, 1));
const RunFinalization = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(ptr => wasm.__wbg_run_free(ptr, 1));

function addToExternrefTable0(obj) {
    const idx = wasm.__externref_table_alloc();
    wasm.__wbindgen_externrefs.set(idx, obj);
    return idx;
}

function _assertClass(instance, klass) {
    if (!(instance instanceof klass)) {
        const got = instance?.constructor?.name ?? (instance === null ? 'null' : typeof instance);
        const error = { kind: 'invalid-argument', what: 'argument', got, wanted: klass.name };
        throw Object.assign(new Error(message('error', error)), { name: 'TiepointError', code: 'invalid-input', usage: false, error });
    }
}

const CLOSURE_DTORS = (typeof FinalizationRegistry === 'undefined')
    ? { register: () => {}, unregister: () => {} }
    : new FinalizationRegistry(state => wasm.__wbindgen_destroy_closure(state.a, state.b));

function debugString(val) {
    switch (typeof val) {
        // primitive types
        case 'number':
        case 'boolean':
        case 'undefined':
        return `${val}`;
        case 'string':
        return JSON.stringify(val);
        case 'bigint':
        return `${val}n`;
        case 'symbol':
        return val.description !== undefined
            ? `Symbol(${val.description})`
            : 'Symbol';
        case 'function':
        return typeof val.name === 'string' && val.name !== ''
            ? `Function(${val.name})`
            : 'Function';
        case 'object': {
            if (val === null) {
                return 'null';
            }
            // objects
            if (Array.isArray(val)) {
                return '[' + Array.from(val, debugString).join(', ') + ']';
            }
            // errors
            if (val instanceof Error) {
                return `${val.name}: ${val.message}\n${val.stack}`;
            }

            const toStringOutput = toString.call(val);
            // Test for built-in
            const className = /\[object ([^\]]+)\]/.exec(toStringOutput)?.[1];

            // Failed to match the standard '[object ClassName]'
            if (className === undefined) {
                return toStringOutput;
            }
            if (className === 'Object') {
                // we're a user defined class or Object
                // JSON.stringify avoids problems with cycles, and is generally much
                // easier than looping through ownProperties of `val`.
                try {
                    return 'Object(' + JSON.stringify(val) + ')';
                } catch (_) {
                    return 'Object';
                }
            }
            // TODO we could test for more things here, like `Set`s and `Map`s.
            return className;
        }
        // Per MDN: 'This list of values is exhaustive.'
        // https://developer.mozilla.org/en-US/docs/Web/JavaScript/Reference/Operators/typeof#description
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
    for (let i = ptr; i < ptr + 4 * len; i += 4) {
        result.push(wasm.__wbindgen_externrefs.get(mem.getUint32(i, true)));
    }
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

let cachedDataViewMemory0 = null;
function getDataViewMemory0() {
    if (cachedDataViewMemory0 === null || cachedDataViewMemory0.buffer.detached === true || (cachedDataViewMemory0.buffer.detached === undefined && cachedDataViewMemory0.buffer !== wasm.memory.buffer)) {
        cachedDataViewMemory0 = new DataView(wasm.memory.buffer);
    }
    return cachedDataViewMemory0;
}

let cachedFloat32ArrayMemory0 = null;
function getFloat32ArrayMemory0() {
    if (cachedFloat32ArrayMemory0 === null || cachedFloat32ArrayMemory0.byteLength === 0) {
        cachedFloat32ArrayMemory0 = new Float32Array(wasm.memory.buffer);
    }
    return cachedFloat32ArrayMemory0;
}

let cachedFloat64ArrayMemory0 = null;
function getFloat64ArrayMemory0() {
    if (cachedFloat64ArrayMemory0 === null || cachedFloat64ArrayMemory0.byteLength === 0) {
        cachedFloat64ArrayMemory0 = new Float64Array(wasm.memory.buffer);
    }
    return cachedFloat64ArrayMemory0;
}

let cachedInt32ArrayMemory0 = null;
function getInt32ArrayMemory0() {
    if (cachedInt32ArrayMemory0 === null || cachedInt32ArrayMemory0.byteLength === 0) {
        cachedInt32ArrayMemory0 = new Int32Array(wasm.memory.buffer);
    }
    return cachedInt32ArrayMemory0;
}

function getStringFromWasm0(ptr, len) {
    ptr = ptr >>> 0;
    return decodeText(getUint8ArrayMemory0().subarray(ptr, ptr + len));
}

let cachedUint16ArrayMemory0 = null;
function getUint16ArrayMemory0() {
    if (cachedUint16ArrayMemory0 === null || cachedUint16ArrayMemory0.byteLength === 0) {
        cachedUint16ArrayMemory0 = new Uint16Array(wasm.memory.buffer);
    }
    return cachedUint16ArrayMemory0;
}

let cachedUint32ArrayMemory0 = null;
function getUint32ArrayMemory0() {
    if (cachedUint32ArrayMemory0 === null || cachedUint32ArrayMemory0.byteLength === 0) {
        cachedUint32ArrayMemory0 = new Uint32Array(wasm.memory.buffer);
    }
    return cachedUint32ArrayMemory0;
}

let cachedUint8ArrayMemory0 = null;
function getUint8ArrayMemory0() {
    if (cachedUint8ArrayMemory0 === null || cachedUint8ArrayMemory0.byteLength === 0) {
        cachedUint8ArrayMemory0 = new Uint8Array(wasm.memory.buffer);
    }
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
    return x === undefined || x === null;
}

function makeClosure(arg0, arg1, f) {
    const state = { a: arg0, b: arg1, cnt: 1 };
    const real = (...args) => {

        // First up with a closure we increment the internal reference
        // count. This ensures that the Rust closure environment won't
        // be deallocated while we're invoking it.
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
    if (realloc === undefined) {
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
        if (code > 0x7F) break;
        mem[ptr + offset] = code;
    }
    if (offset !== len) {
        if (offset !== 0) {
            arg = arg.slice(offset);
        }
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

let cachedTextDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
cachedTextDecoder.decode();
const MAX_SAFARI_DECODE_BYTES = 2146435072;
let numBytesDecoded = 0;
function decodeText(bytes) {
    numBytesDecoded += bytes.length;
    if (numBytesDecoded >= MAX_SAFARI_DECODE_BYTES) {
        cachedTextDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
        cachedTextDecoder.decode();
        numBytesDecoded = bytes.length;
    }
    return cachedTextDecoder.decode(bytes);
}

const cachedTextEncoder = new TextEncoder();

if (!('encodeInto' in cachedTextEncoder)) {
    cachedTextEncoder.encodeInto = function (arg, view) {
        const buf = cachedTextEncoder.encode(arg);
        view.set(buf);
        return {
            read: arg.length,
            written: buf.length
        };
    };
}

let WASM_VECTOR_LEN = 0;

const unloaded = new Proxy({}, { get() {
    throw Object.assign(new Error('the module is not loaded: call load(), the default export of tiepoint, and wait for it first'), { name: 'TiepointError', code: 'not-loaded', usage: false, error: { kind: 'not-loaded' } });
} });
let wasmModule, wasmInstance, wasm = unloaded;
function __wbg_finalize_init(instance, module) {
    wasmInstance = instance;
    wasm = instance.exports;
    wasmModule = module;
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
    if (typeof Response === 'function' && module instanceof Response) {
        if (!module.ok) {
            throw new Error(`failed to fetch Wasm: ${module.status} ${module.statusText} fetching '${module.url}'`);
        }

        if (typeof WebAssembly.instantiateStreaming === 'function') {
            try {
                return await WebAssembly.instantiateStreaming(module, imports);
            } catch (e) {
                const validResponse = expectedResponseType(module.type);

                if (validResponse && module.headers.get('Content-Type') !== 'application/wasm') {
                    console.warn("`WebAssembly.instantiateStreaming` failed because your server does not serve Wasm with `application/wasm` MIME type. Falling back to `WebAssembly.instantiate` which is slower. Original error:\n", e);

                } else { throw e; }
            }
        }

        const bytes = await module.arrayBuffer();
        return await WebAssembly.instantiate(bytes, imports);
    } else {
        const instance = await WebAssembly.instantiate(module, imports);

        if (instance instanceof WebAssembly.Instance) {
            return { instance, module };
        } else {
            return instance;
        }
    }

    function expectedResponseType(type) {
        switch (type) {
            case 'basic': case 'cors': case 'default': return true;
        }
        return false;
    }
}

function initSync(module) {
    if (wasm !== unloaded) return wasm;


    if (module !== undefined) {
        if (Object.getPrototypeOf(module) === Object.prototype) {
            ({module} = module)
        } else {
            console.warn('using deprecated parameters for `initSync()`; pass a single object instead')
        }
    }

    const imports = __wbg_get_imports();
    if (!(module instanceof WebAssembly.Module)) {
        module = new WebAssembly.Module(module);
    }
    const instance = new WebAssembly.Instance(module, imports);
    return __wbg_finalize_init(instance, module);
}

let __wbg_init_promise;
async function __wbg_init(module_or_path) {
    if (wasm !== unloaded) return wasm;
    if (__wbg_init_promise === undefined) {
        __wbg_init_promise = __wbg_init_once(module_or_path);
        __wbg_init_promise.catch(() => { __wbg_init_promise = undefined; });
    }
    return __wbg_init_promise;
}

async function __wbg_init_once(module_or_path) {

    if (module_or_path !== undefined) {
        if (Object.getPrototypeOf(module_or_path) === Object.prototype) {
            ({module_or_path} = module_or_path)
        } else {
            console.warn('using deprecated parameters for the initialization function; pass a single object instead')
        }
    }


    const imports = __wbg_get_imports();

    if (typeof module_or_path === 'string' || (typeof Request === 'function' && module_or_path instanceof Request) || (typeof URL === 'function' && module_or_path instanceof URL)) {
        module_or_path = fetch(module_or_path);
    }

    const { instance, module } = await __wbg_load(await module_or_path, imports);

    return __wbg_finalize_init(instance, module);
}

export { initSync, __wbg_init as default };
