/* tslint:disable */
/* eslint-disable */

/**
 * The text of a message of a family, or, by its name, another text that belongs to it, as its `label`; in English, or in the language of a tag
 * (`ar`) that there is a catalogue of.
 */
export function message<F extends keyof Messages>(family: F, message: Messages[F], attribute?: string | null, language?: string | null): string;



/** A file that is read in parts: `read` gives so many bytes from a place on, at once. In a worker of a browser a `FileReaderSync` does that, in Node `fs.readSync`. */
export interface FileInParts {
    /** Its length in bytes. */
    readonly size: number;
    read(at: number, length: number): Uint8Array;
}



/** A pair that was matched and oriented, with all that was given for it. */
export interface PairProject {
    /** The left and the right one. */
    images: [PairPhoto, PairPhoto];
    input: Given<PairInput>;
    settings: Given<PairSettings>;
    output: PairOutput;
    /** What is known of a simulated pair. */
    truth: PairTruth | null;
    /** What was changed by hand; null where nothing was. */
    edited?: PairEdits | null;
}

/** Edits of the matches of a pair, and the matches that were found: the output has the edited ones. */
export interface PairEdits {
    /** In their order. */
    edits: readonly PairEdit[];
    /** Of the left points before those that were measured by hand, which come last. */
    found: Omit<MatchResult, "geometry" | "no_geometry">;
}

/** The truth of a simulated pair. */
export interface PairTruth {
    /** by and bz at the scale of `base_mm`. */
    orientation: FiveParameters;
    base_mm: number;
    score: MatchScore;
}



/** A scan of film, resampled to the image of an ideal camera. */
export interface FilmFiles {
    /** PNG, grey or in colours, with the position that the metadata of the scan record. */
    image: Uint8Array;
    /** PNG: 0 where the image shows a fiducial mark, its surroundings, nothing of the scan, or what the mask of the scan leaves out. */
    mask: Uint8Array;
    /** As a file of cameras has it, of this image alone: `film_cameras` gives that of all images of a film. */
    camera: CameraRule;
    /** How the scan lies to the image, by which `film_positions` leads from one to the other, and how the marks give it. */
    scan: FilmScan;
    /** Root mean square length of the residuals of the marks in mm. */
    rmse_mm: number;
}

/** What the image of a scan is to be. */
export interface FrameWanted {
    /** What it is called. */
    image: string;
    /** The side of a pixel, which is to be the same for all scans of a film, as are its marks: see `film_pixel_mm`. */
    pixel_mm: number;
    /** The file of an image as large as the scan that is 0 where no features are wanted. */
    mask?: { name: string; file: Uint8Array } | null;
}



/** An orthophoto that was read: `gsd` is the side of a pixel, `heights` the lowest and the highest of its ground. */
export interface OrthophotoInfo {
    width: number;
    height: number;
    gsd: number;
    georeference: Georeference;
    epsg: number | null;
    /** What its system is called where it has one without a code. */
    described: string | null;
    /** Whether it says a system that is known here, so that GNSS positions are led into it. */
    on_earth: boolean;
    heights: [number, number];
    /** What they count from, by the name of a vertical system, where their file says it. */
    heights_from: string | null;
    /** The unit in which their file says that they are, where they were converted from it. */
    heights_given_in: string | null;
    /** Share of the picture that has a height, 0 to 1. */
    heights_share: number;
    /** Whether its pixels are read where they are needed. */
    in_parts: boolean;
}

/** What an image is oriented by without matching. */
export interface ByLinks {
    links: readonly GivenLink[];
    /** Where it was placed, which says whether it is a scan of film; absent: by resection of the links. */
    placement?: Placement | null;
    /** The text of a file of cameras, as of `place`. */
    cameras?: string | null;
    /** As of `search`; absent: those that it had. */
    options?: Given<PlacingOptions> | null;
    /** Of a scan of film that was not placed, as of `place`. */
    film?: Given<FilmInput> | null;
    /** As of `place`. */
    position?: GivenPosition | null;
}

/** A place of the ground that becomes a ground control point of a block. */
export interface PlaceByHand extends CountedFrom {
    /** X and Y in the system of the orthophoto. */
    place: readonly [number, number];
    /** Its number among the places by hand, from 1, which names it. */
    number: number;
    /** The coordinate reference system that the block has; absent: its control points are in the system of the orthophoto. */
    crs?: string | null;
    /** As of `search`; absent: those that it had. */
    options?: Given<PlacingOptions> | null;
}



/** Epipolar images as PNG files, of one size, and how they lie. */
export interface EpipolarFiles {
    left: Uint8Array;
    right: Uint8Array;
    /** Both in one, for red-cyan glasses. */
    anaglyph: Uint8Array;
    /** JSON: an `EpipolarGeometry` with the names of the images. */
    parameters: string;
}



/** Grey values 0..255, row by row. */
export interface SampleImage { width: number; height: number; grey: Uint8Array }

/** A simulated pair and its truth. */
export interface SamplePair {
    left: SampleImage;
    right: SampleImage;
    camera: CameraMm;
    base_mm: number;
    left_fiducials: Fiducial[];
    right_fiducials: Fiducial[];
    left_origin: [number, number];
    right_origin: [number, number];
    /** The true relative orientation. */
    truth: FiveParameters;
    /** For each left pixel, row by row, the x and y in px at which the right image shows the same; NaN where hidden or outside. */
    right_position: Float32Array;
}

/** How right matches are. */
export interface MatchScore {
    matches: number;
    /** Within 1.5 px of where the surface at the left pixel is seen. */
    strict: number;
    /** The same, or of where the surface at one of its 8 neighbours is seen. */
    right: number;
    /** Left points that are seen in the right image and have no right match. */
    missed: number;
    /** For each match 0 wrong, 1 right at an edge only, 2 strictly right. */
    rightness: Uint8Array;
}



/** Matches of descriptors. */
export interface DescriptorMatches {
    /** Index of the left and of the right descriptor of each match; stride 2. */
    indices: Uint32Array;
    /** Square of the distance of each match, and that of the second nearest right descriptor, 4294967295 where there is none; stride 2. */
    squares: Uint32Array;
}

/** Nearest neighbours of consecutive left descriptors; 4294967295 where there is none. */
export interface NearestPiece {
    /** The first left descriptor. */
    first: number;
    /** Of each left descriptor the nearest right one, the square of its distance and that of the second nearest; stride 3. */
    left: Uint32Array;
    /** Of each right descriptor the nearest of these left ones and the square of its distance; stride 2. */
    right: Uint32Array;
}



/** Matches of features that agree with the geometry of their two images. */
export interface VerifiedMatches extends DescriptorMatches {
    /** What relates the views; null where there is nothing, and then there are no matches. */
    geometry: Omit<TwoView, "inliers"> | null;
    /** Why there is no geometry. */
    no_geometry: NoGeometry | null;
}



/** Options of which any may be absent: these take their defaults. */
export type Given<T> = T extends unknown[] ? T : T extends object ? { [K in keyof T]?: Given<T[K]> } : T;

/** One option, or a value of a call. */
export type Parameter = {
    /** What messages call it, as "multiscale.number". */
    key: string;
    /** Where it stands in the object of options, as "features.multiscale.number" of a block; of a value of a call the name of the argument. */
    path: string;
    /** The heading under which it stands. */
    section: string;
    label: string;
    unit: string;
    help: string;
    /** What holds where it is absent, in words; empty where it is never absent. */
    absent: string;
    /** When it has an effect, as "matching.strategy is gradient"; empty: always. */
    acts: string;
    /** Its name in the command where that is not the field's; empty otherwise. */
    named: string;
} & ParameterKind;

/** What every refused call throws. */
export interface TiepointError extends Error {
    name: "TiepointError";
    /** Stable for programs. */
    code: ErrorCode;
    /** Whether the caller's options are at fault rather than the data. */
    usage: boolean;
    /** What was wrong, with its figures: `message("error", error.error, null, "ar")` is the text in another language. */
    error: Messages["error"];
}

/** What a refused call says to programs; codes do not change between versions. */
export type ErrorCode =
| "constant-window"
| "degenerate"
| "image-too-small"
| "interrupted"
| "invalid-input"
| "invalid-json"
| "invalid-option"
| "not-converged"
| "not-loaded"
| "not-written"
| "too-few"
| "too-many-pixels"
| "too-much-memory"
| "unreadable-file"
| "unreadable-image"
| "unsupported-image"
| "window-outside";



/** Points with their descriptors. */
export interface Features {
    /** x, y and scale in px, the dominant direction in rad from x towards y, and the weight: stride 5. */
    points: Float64Array;
    /** 128 bytes a point. */
    descriptors: Uint8Array;
}



/** The families of messages, each with what it says. */
export interface Messages {
    warning: Warning;
    block_warning: BlockWarning;
    unoriented: UnorientedReason;
    connection: Connection;
    outcome: PairOutcome;
    failure: Failure;
    remark: Remark;
    no_geometry: NoGeometry;
    no_orientation: NoOrientation;
    pair_verdict: PairVerdict;
    pair_hint: PairHint;
    block_verdict: BlockVerdict;
    degeneracy: Degeneracy;
    two_view_model: Pick<TwoViewModel, "kind">;
    verdict: Rule | "gross_error" | "undecided";
    camera_caution: CameraCaution;
    camera_origin: CameraOrigin;
    camera_parameter: CameraParameter;
    error: { kind: string };
    allowed: { kind: string };
    overview_warning: OverviewWarning;
    observation_group: { kind: ObservationGroup };
    placing_verdict: PlacingVerdict;
    place_search: PlaceSearch;
    image_reason: ImageReason;
    on_orthophoto: OnOrthophoto;
}



/** The known answer of a simulated pair, as `simulate` gives it. */
export interface ReportTruth { orientation: FiveParameters; base_mm: number; right_position: Float32Array }

/** The matches of a run after edits by hand, in place of those that it finds. */
export interface ReportEdits {
    /** Those that take part, as a `MatchResult` has them. */
    match: Pick<MatchResult, "matches" | "fits" | "indices">;
    /** Left positions in px of the points that were measured by hand beside those that the operator finds; stride 2. */
    added_px: Float64Array;
    /** How many matches were rejected by hand. */
    rejected: number;
    /** How many matches have a place that was measured by hand. */
    measured: number;
}



/** The outcome of matching. */
export interface MatchResult {
    counts: MatchCounts;
    /** x and y of the left point, x and y of the right point in px, measure; stride 5. */
    matches: Float64Array;
    /** Index of the left and of the right point of each match, 4294967295 where the place found is no interest point; stride 2. */
    indices: Uint32Array;
    /** What least squares matching found: correlation, covariance xx, xy, yy of the right position in px², iterations; stride 5. NaN where none took place. */
    fits: Float64Array;
    /** For each left point the rule that decided: an index into `rule_names()`. */
    rules: Uint8Array;
    /** For each left point the index of its best right point, -1 without one. */
    best: Int32Array;
    /** For each left point the best place in the right image in px, NaN without one; stride 2. */
    places: Float64Array;
    /** For each left point the best and the second best measure, Infinity where there is none; stride 2. */
    measures: Float64Array;
    /** What relates the views, by which the strategy gradient verified its matches; null for the others and where there is nothing. */
    geometry: Omit<TwoView, "inliers"> | null;
    /** Why there is no geometry, where one was looked for. */
    no_geometry: NoGeometry | null;
}

/** Points as matching takes them: `DescribedPoints`, or what of it the strategy needs. */
export type GivenPoints = Pick<DescribedPoints, "points"> & Partial<Pick<DescribedPoints, "frames" | "moments" | "gradients">>;


/** The outcome of a whole pair. */
export interface PairOutput extends MatchedPair {
    left: DetectedPoints;
    right: DetectedPoints;
}

/** A relative orientation of matches, with what it is worth. */
export type OrientedPair = RelativeOrientation & { verdict: PairVerdict };

/** What becomes of the points of a pair. */
export interface MatchedPair {
    /** Absent where the strategy needs none. */
    offset: OffsetField | null;
    match: MatchResult;
    interior: PairInterior | null;
    /** Side of a left pixel in mm. */
    pixel_mm: number | null;
    orientation: OrientedPair | null;
    /** Why there is no orientation. */
    no_orientation: NoOrientation | null;
    /** What the result is worth. */
    verdict: PairVerdict;
}



/** The points of the model that is written. */
export interface PointColumns {
    /** What the points are called by. */
    numbers: Uint32Array;
    rays: Uint16Array;
    /** NaN where a point is not adjusted. */
    rmse_px: Float64Array;
    /** X, Y, Z; NaN where a point is not intersected; stride 3. */
    positions: Float64Array;
    /** Standard errors of X, Y, Z; NaN where there are none; stride 3. */
    errors: Float64Array;
    /** Probability, 0..1, that all rays belong together. */
    confidence: Float64Array;
}

/** The observations of an image. */
export interface ImagePoints {
    /** Index of the point of each in the model that is written. */
    points: Uint32Array;
    /** Column and row in px; stride 2. */
    places: Float64Array;
    /** Observed minus computed in px; NaN where there is none; stride 2. */
    residuals: Float64Array;
    /** Redundancy numbers r, 0..1, of column and row; NaN where there are none, as of `w` and `detectable`; stride 2. */
    redundancy: Float64Array;
    /** Residuals by their standard errors (Baarda's w); stride 2. */
    w: Float64Array;
    /** Minimal detectable errors in px, found with a probability of 0.80; NaN where nothing checks the coordinate; stride 2. */
    detectable: Float64Array;
    /** 0: it takes part; 1: it was rejected; 2: it was rejected by hand. */
    parts: Uint8Array;
}

/** A message and its text. */
export type WithText<M> = M & { text: string };

/** Takes the path of a file, with slashes and relative to the folder of the block, and its text. */
export type Emit = (path: string, text: string) => void;

/** A map of expected standard errors, on a grid over the ground. */
export interface AccuracyFiles {
    /** GeoTIFF of floating-point numbers: the standard error in plan, that in height, and the number of images; NaN stands for nothing. */
    plan: Uint8Array;
    height: Uint8Array;
    images: Uint8Array;
    /** The same as a table. */
    table: string;
    summary: AccuracySummary;
}



/** What is known of a decoded image. */
export interface PhotoInfo { width: number; height: number; format: string; bits_per_sample: number; camera: ExifCamera | null; drone: DroneRecord | null }

/** An image halved a number of times: grey values 0..255, row by row. */
export interface ReducedImage { width: number; height: number; halvings: number; grey: Uint8Array }

/** Interest points: x and y in px and the interest value, stride 3; in raster order, those of many scales by octave. */
export interface DetectedPoints {
    counts: PointCounts;
    threshold: number;
    points: Float64Array;
    /** Of each point scale in px and dominant direction in rad from x towards y, stride 2; empty for operators that look at one scale. */
    frames: Float64Array;
}

/** Interest points with what a strategy compares them by. */
export interface DescribedPoints extends DetectedPoints {
    /** Seven numbers a point for the strategies that compare moments, NaN where a window leaves the image or is constant; else empty. */
    moments: Float64Array;
    /** 128 bytes a point for the strategy that compares gradients; else empty. */
    gradients: Uint8Array;
}

/** The window of a point: its grey values row by row, which of them lie within the outline, and its moments. */
export interface WindowReport {
    side: number;
    grey: number[];
    mask: boolean[];
    /** The centroid in image coordinates, px. */
    centroid_px: [number, number];
    axis_angle_deg: number;
    central: Record<"mu00" | "mu20" | "mu11" | "mu02" | "mu30" | "mu21" | "mu12" | "mu03", number>;
    normalized: Record<"mu20" | "mu11" | "mu02" | "mu30" | "mu21" | "mu12" | "mu03", number>;
    invariants: number[];
}



/** What is to be done for a job, beside the bytes of its files. */
export interface Work {
    /** Of the record that comes of it: a kept one is as good, and a new one is kept. Null where nothing is kept. */
    key: string | null;
    /** For `execute_job`. Null where the run takes the bytes of the only record, or nothing, and computes itself. */
    task: string | null;
    /** Keys of kept records whose bytes it takes, after those of the files. */
    records: string[];
    /** Bytes that it takes after those of the records. */
    input: Uint8Array | null;
}



/** Where the heights of a coordinate reference system count from; above the ellipsoid of WGS 84 where both are absent. */
export interface CountedFrom {
    /** How high their zero is above the ellipsoid wherever the places are, in m. */
    geoid_m?: number | null;
    /** In place of it the part of a geoid about the places, as a block has it. */
    geoid?: Geoid | null;
}



/** `TwoView` with its matches as a typed array. */
export type TwoViewResult = Omit<TwoView, "inliers"> & { inliers: Uint32Array };

/** Where a left point may be seen: a matrix of nine numbers by rows, of homogeneous positions in px. */
export type MatchGuide = { fundamental: Float64Array | number[] } | { homography: Float64Array | number[] };



export interface RelativeOrientation {
    /** Corrections of x and y in the left and in the right photo in mm, of every observation, the rejected ones included; stride 4. */
    residuals_mm: Float64Array;
    /**
     * For each observation: residual y-parallax in mm, redundancy number, standardised residual w, minimal detectable displacement of the
     * right point across its epipolar line in mm, external reliability, weight (0 where rejected), model X, Y, Z in mm; stride 9. NaN where absent.
     */
    points: Float64Array;
}


/**
 * A [`KnownCamera`] by its name, as results and project files hold it.
 */
export interface InitialCamera {
    /**
     * Make, model, focal length and size, or the pattern of the rule and the size.
     */
    label: string;
    width_px: number;
    height_px: number;
    /**
     * Absent where it is not known.
     */
    focal_px: number | null;
    principal_point_px: [number, number];
    radial: [number, number, number];
    tangential: [number, number];
    pixel_mm: number | null;
    /**
     * Whether the block takes it as it is.
     */
    fixed: boolean;
    /**
     * How well it is known, by where it is known from; absent in blocks of former versions.
     */
    uncertainty?: CameraUncertainty;
}

/**
 * A block before its run: files by their names, whose bytes come with the jobs that need them.
 */
export interface RunInput {
    /**
     * Names of the images in the order in which they follow each other; no two are the same.
     */
    images?: string[];
    /**
     * Names of masks: images that are 0 (black) where no features are wanted, each as large as the image whose name it has.
     */
    masks?: string[];
    settings?: BlockSettings;
    /**
     * A file of cameras, which take the place of those of EXIF.
     */
    cameras?: string | null;
    /**
     * Whether GNSS positions of the images choose near images and, without ground control points, georeference the block.
     */
    use_gnss?: boolean;
    control?: ControlTexts | null;
    /**
     * Name of the file of a geoid, from which the heights of the coordinate system count: a GeoTIFF of longitudes and latitudes, GTX, or PGM of
     * GeographicLib.
     */
    geoid?: string;
    /**
     * GNSS positions of images, which take the place of those that the files of these images record: the text of a table.
     */
    positions?: string;
    /**
     * Whether an orthophoto is to place the block afterwards: then one or two control points, and check points alone, are of use.
     */
    on_orthophoto?: boolean;
    /**
     * Whether masks that belong to none of the images are refused, in place of listed: an image whose mask has a slip in its name would have none. It
     * is of the call: a run does not keep it.
     */
    refuse_stray_masks?: boolean;
}

/**
 * A block of images with approximate values, or an adjusted one.
 */
export interface Block {
    cameras: Camera[];
    images: BlockImage[];
    points: [number, number, number][];
    /**
     * In any order; an image sees a point at most once.
     */
    rays: BlockObservation[];
    control?: ControlPoint[];
    /**
     * What is known of cameras beforehand; a camera has one at most.
     */
    camera_priors?: CameraPrior[];
}

/**
 * A block: whatever is not known yet is absent.
 */
export interface BlockModel {
    cameras: Camera[];
    images: ModelImage[];
    points: ObjectPoint[];
    /**
     * Where on the earth the object space is; absent for a block in a system of its own.
     */
    origin?: GeographicOrigin | null;
}

/**
 * A camera before its calibration.
 */
export interface CameraSummary extends InitialCamera {
    images: number;
}

/**
 * A camera before its calibration; symbols as at [`Camera`](crate::Camera). Rules of files (`CameraRule`) and rows of a run (`InitialCamera`)
 * are this camera as they write it.
 */
export interface KnownCamera {
    width_px: number;
    height_px: number;
    /**
     * Approximate principal distance in px; absent: not known. It is guessed then, and estimated in any case.
     */
    focal_px?: number | null;
    /**
     * Approximate principal point in px; absent: the middle of the image.
     */
    principal_point_px?: [number, number] | null;
    radial?: [number, number, number];
    tangential?: [number, number];
    /**
     * What the block estimates of it, where it determines that: by default all but k3.
     */
    free?: FreeParameters;
    /**
     * Side of a pixel in mm, for exports in photo coordinates.
     */
    pixel_mm?: number | null;
    /**
     * Standard deviations of the values above, which enter the adjustment as prior information; absent: as
     * [`known_within`](Self::known_within) says.
     */
    uncertainty?: CameraUncertainty;
}

/**
 * A camera by its number, from 1, and by its images: files number cameras from 0.
 */
export interface NamedCamera {
    /**
     * Whether the block has no other.
     */
    only: boolean;
    number: number;
    /**
     * Name of its first image.
     */
    first: string | null;
    /**
     * How many images it has beside that.
     */
    more: number;
}

/**
 * A camera of a finished block.
 */
export interface CameraRow {
    label: string;
    images: number;
    /**
     * What was known before; absent where its focal length was not.
     */
    given: Camera | null;
    /**
     * As the block adjusted it; absent where no image of it is oriented.
     */
    calibrated: Camera | null;
    /**
     * Standard error of the focal length.
     */
    focal_error_px: number | null;
}

/**
 * A camera parameter that was to be estimated and was fixed, since the block does not determine it.
 */
export interface FixedParameter {
    parameter: CameraParameter;
    /**
     * By how much one standard error of it would move a ray at the edge of the image, in px; absent where nothing determines it at all.
     */
    effect_px: number | null;
}

/**
 * A camera that is not known without error: prior information, and where its pair tells more, matches with it, in the millimetres of its photo
 * coordinates.
 */
export interface EstimatedCamera {
    focal_mm: number;
    focal_standard_error_mm: number;
    principal_point_mm: [number, number];
    principal_point_standard_errors_mm: [number, number];
    /**
     * The first term of the radial distortion, as [`Interior::photo_mm`](crate::Interior::photo_mm) has it, in mm⁻².
     */
    k1_per_mm2: number;
    k1_standard_error_per_mm2: number;
}

/**
 * A camera without distortion.
 */
export interface Pinhole {
    /**
     * Focal length in px; absent: unknown, the same in both images, and estimated where the matches determine it.
     */
    focal_px?: number | null;
    /**
     * Principal point in px.
     */
    principal_px: [number, number];
}

/**
 * A camera, and the images that it took.
 */
export interface CameraRule {
    /**
     * Names of images: `*` stands for any characters, `?` for one, large and small letters are the same. The first rule that fits holds.
     */
    images?: string;
    /**
     * Principal distance in px, 1 to 10,000,000.
     */
    focal_px: number;
    /**
     * `[c_x, c_y]` in px, the centre of the top-left pixel at (0.5, 0.5); absent: the middle of the image.
     */
    principal_point_px?: [number, number] | null;
    /**
     * As in [`Camera`].
     */
    radial?: [number, number, number];
    tangential?: [number, number];
    pixel_mm?: number | null;
    /**
     * Whether the block takes the camera as it is; otherwise it is calibrated from these values.
     */
    fixed?: boolean;
    /**
     * What is not known of a camera that is not fixed; absent: as much as of one of EXIF.
     */
    uncertainty?: CameraUncertainty;
}

/**
 * A change of a finished block by hand. Images count as those of the block.
 */
export type BlockEdit = { kind: "reject_observations"; observations: PointImage[] } | { kind: "restore_observations"; observations: PointImage[] } | { kind: "reject_points"; points: PointSource[] } | { kind: "restore_points"; points: PointSource[] } | { kind: "reject_images"; images: number[] } | { kind: "restore_images"; images: number[] } | { kind: "reject_pairs"; pairs: [number, number][] } | { kind: "restore_pairs"; pairs: [number, number][] } | { kind: "measure"; point: PointSource; image: number; x_px: number; y_px: number; by?: MeasuredBy } | { kind: "add_point"; observations: HandMeasurement[] } | { kind: "add_control"; name: string; position: [number, number, number]; standard_errors?: [number, number]; sigma_px?: number; use?: ControlRole; epsg?: number; remarks?: Remark[] } | { kind: "set_use"; point: number; use?: ControlRole | null };

/**
 * A change of the matches of a pair by hand.
 */
export type PairEdit = { kind: "reject"; of: EditedMatch[] } | { kind: "restore"; of: EditedMatch[] } | { kind: "add"; id: number; at: [number, number, number, number] } | { kind: "move"; of: EditedMatch; to: [number, number, number, number] };

/**
 * A column of Table 3.
 */
export interface PrintedOrientation {
    /**
     * By which way: `correlation`, `least-squares` or `moments`.
     */
    name: string;
    values: FiveParameters;
}

/**
 * A coordinate axis.
 */
export type Axis = "x" | "y" | "z";

/**
 * A fiducial mark: where it was measured and where the calibration has it.
 */
export interface Fiducial {
    /**
     * Measured column in px; the centre of the top-left pixel is 0.5.
     */
    col: number;
    /**
     * Measured row in px; the centre of the top-left pixel is 0.5.
     */
    row: number;
    /**
     * Calibrated x in mm, to the right.
     */
    x_mm: number;
    /**
     * Calibrated y in mm, up.
     */
    y_mm: number;
}

/**
 * A file by its place among the names that the run was given.
 */
export type FileNeeded = { kind: "image"; index: number } | { kind: "mask"; index: number } | { kind: "geoid"; index: number };

/**
 * A focal length that was estimated from the matches.
 */
export interface FocalEstimate {
    /**
     * Of both cameras, in px.
     */
    focal_px: number;
    /**
     * Its standard error in px, from the precision of the matches and from what an error of 1 % of half the diagonal of what is matched in either
     * coordinate of the principal points, and in the distortion of the corners, would do.
     */
    standard_error_px: number;
}

/**
 * A format that blocks are written in.
 */
export type ExportFormat = "colmap" | "micmac" | "bundler" | "nvm" | "opensfm" | "bingo" | "isat" | "agisoft" | "patb" | "csv" | "json" | "geojson";

/**
 * A format that was asked for.
 */
export interface ExportOutcome {
    format: ExportFormat;
    /**
     * Why the block cannot be written so; absent where it was.
     */
    refused: string | null;
}

/**
 * A frame of a scan: what both are called, and how they lie to each other.
 */
export interface FrameOfScan {
    /**
     * The name of the scan, as image measurements have it.
     */
    scan: string;
    /**
     * The name of its frame.
     */
    image: string;
    film: FilmScan;
}

/**
 * A job that can be done now. The host reads its files, asks [`Run::prepare`](super::Run::prepare) what is to be done with them, and hands back the bytes that come of it.
 */
export interface Job {
    id: number;
    files: FileNeeded[];
}

/**
 * A match that an edit is about.
 */
export type EditedMatch = number | [number, number, number, number];

/**
 * A model of a block.
 */
export interface ModelSummary {
    images: number;
    names: string[];
    in_system: boolean;
    datum: Datum;
    sigma0_px: number | null;
    rmse_px: number;
    rmse_by_rays: RayCountRmse[];
    degrees_of_freedom: number;
    /**
     * By what standard errors grow for intervals, ellipses and ellipsoids of 95 %; absent without standard errors.
     */
    factors_95: Factors95 | null;
    /**
     * Medians over the images of the total standard errors of positions and of ω φ κ, along and about the axes of the adjustment; absent without
     * statistics.
     */
    position_errors_m: [number, number, number] | null;
    angle_errors_deg: [number, number, number] | null;
    rays_rejected: number;
    /**
     * Root mean square residuals of the GNSS positions that took part, of each coordinate; absent without any.
     */
    position_rmse_m: [number, number, number] | null;
    /**
     * How large errors are beside the stated standard errors, by the residuals.
     */
    components: ComponentSummary[];
    /**
     * Systematic errors of GNSS positions that were to be estimated; absent where none was.
     */
    systematic?: SystematicSummary[];
    /**
     * Absent without check points.
     */
    checks: CheckSummary | null;
    warnings: WithText<BlockWarning>[];
}

/**
 * A model: images that are oriented to each other, adjusted.
 */
export interface ReconstructedModel {
    /**
     * The image of the block that each image of the adjusted one is, ascending.
     */
    images: number[];
    /**
     * The camera of the block that each camera of the adjusted one is, ascending.
     */
    cameras: number[];
    /**
     * Cameras of the block whose focal length was not known.
     */
    guessed_focal: number[];
    /**
     * What each point of the adjusted block is.
     */
    points: PointSource[];
    /**
     * What each ray of the adjusted block is.
     */
    rays: ObservationSource[];
    /**
     * Rays of its images that do not fit, left out before the bundle adjustment; their points are those of the adjusted block.
     */
    rejected: RejectedObservation[];
    adjusted: AdjustmentResult;
    /**
     * Tie points by which it was adjusted, too, and which are not given: with those of the adjusted block they repeat the adjustment.
     */
    supporting?: SupportingPoint[];
    /**
     * The surveyed points, where it lies in their system.
     */
    surveyed?: SurveyedPoint[];
    /**
     * Whether it lies in the system of the observed positions; otherwise its place, turn and scale mean nothing.
     */
    in_system: boolean;
    warnings: BlockWarning[];
}

/**
 * A pair that was chosen, and its outcome.
 */
export interface Connection {
    /**
     * In ascending order.
     */
    images: [number, number];
    rule: PairRule;
    outcome: PairOutcome;
}

/**
 * A pair that was chosen.
 */
export interface PairRow {
    /**
     * In ascending order.
     */
    images: [number, number];
    rule: PairRule;
    outcome: PairOutcome;
    /**
     * Why the images are connected or are not, in words.
     */
    reason: string;
    /**
     * Absent where nothing relates the views.
     */
    geometry: TwoView | null;
    /**
     * Tie points that both images see.
     */
    common_points: number;
    /**
     * Those of the model that is written.
     */
    chosen_points: number;
    rejected_by_hand: boolean;
}

/**
 * A pair to be matched; its images are in ascending order.
 */
export interface ChosenPair {
    images: [number, number];
    rule: PairRule;
}

/**
 * A photo of a pair.
 */
export interface PairPhoto {
    /**
     * File name.
     */
    name: string;
    /**
     * SHA-256 of the file in hexadecimal digits; absent for a photo that was simulated.
     */
    content: string | null;
    width_px: number;
    height_px: number;
    /**
     * Of its file.
     */
    format: string;
    bits_per_sample: number;
    /**
     * File name of its mask.
     */
    mask: string | null;
    /**
     * The camera that its EXIF data name.
     */
    camera: ExifCamera | null;
}

/**
 * A photo of a pair.
 */
export type Side = "left" | "right";

/**
 * A place in an image that was measured.
 */
export interface HandMeasurement {
    image: number;
    /**
     * Column and row in px.
     */
    x_px: number;
    y_px: number;
    by?: MeasuredBy;
}

/**
 * A place in an image.
 */
export interface ImagePlace {
    /**
     * Index of the image in the block.
     */
    image: number;
    /**
     * Column and row in px.
     */
    x_px: number;
    y_px: number;
}

/**
 * A place of an orthophoto in the images that show it.
 */
export interface SeenPlace {
    seen: SeenIn[];
}

/**
 * A place on the earth as a receiver had it.
 */
export interface ExifPosition {
    /**
     * East positive.
     */
    longitude_deg: number;
    /**
     * North positive.
     */
    latitude_deg: number;
    /**
     * Above the level that the camera refers to, which most do not tell; absent where there is none.
     */
    height_m: number | null;
    /**
     * Horizontal positioning error that the receiver states.
     */
    error_m: number | null;
}

/**
 * A place that lies where one lay when the block was placed before.
 */
export interface PlaceAgain {
    /**
     * Its number among the surveyed points before, and now.
     */
    before: number;
    now: number;
    /**
     * Whether it is the same spot, so that what was measured of it by hand holds.
     */
    is_same_spot: boolean;
    /**
     * Indices of the images that it was found in, ascending.
     */
    images: number[];
}

/**
 * A point of an image and the place of the orthophoto that shows it, as somebody gives them.
 */
export interface GivenLink {
    /**
     * Column and row in px; the centre of the top-left pixel is (0.5, 0.5).
     */
    at: [number, number];
    /**
     * X and Y in the system of the orthophoto; its height is looked up.
     */
    place: [number, number];
    use: GivenUse;
    /**
     * Whether it was measured by eye, to about a pixel of both pictures.
     */
    by_hand?: boolean;
}

/**
 * A point of the image and the place that the orthophoto has for it.
 */
export interface Link {
    /**
     * Column and row in px; the centre of the top-left pixel is (0.5, 0.5).
     */
    at: [number, number];
    /**
     * In the system of the orthophoto; the height that of the height model.
     */
    place: [number, number, number];
    /**
     * Observed minus computed column and row in px; absent where the image does not see the place.
     */
    residual_px: [number, number] | null;
    /**
     * Standard error of each of its coordinates in the image, in px, in which that of its place has its part; absent without redundancy.
     */
    sigma_px?: number | null;
    role: LinkUse;
    /**
     * Whether it was measured by eye.
     */
    by_hand?: boolean;
}

/**
 * A point of the model that is written, with its observations.
 */
export interface PointDetail {
    /**
     * What it is, whatever its index; absent in a block that is not oriented.
     */
    id: PointSource | null;
    /**
     * Of a surveyed point.
     */
    name: string | null;
    role: ControlRole | null;
    /**
     * X, Y, Z; absent where it is not intersected.
     */
    position: [number, number, number] | null;
    /**
     * Their standard errors.
     */
    errors: [number, number, number] | null;
    rmse_px: number | null;
    /**
     * Probability, 0..1, that its observations belong together.
     */
    confidence: number;
    observations: ObservationDetail[];
    /**
     * Where the other oriented images should show it.
     */
    elsewhere: ImagePlace[];
}

/**
 * A point whose coordinates are known.
 */
export interface GroundControlRow {
    name: string;
    /**
     * `[x, y, z]` in the unit of the file.
     */
    position: [number, number, number];
    /**
     * Standard errors of the place and of the height, above 0; absent where the file has none.
     */
    standard_errors: [number, number] | null;
    /**
     * What it is for; absent where it is not used at all.
     */
    role?: ControlRole | null;
    /**
     * Standard error of a coordinate of its image measurements in px, above 0; absent where the file has none.
     */
    sigma_px?: number | null;
}

/**
 * A point with known coordinates.
 */
export interface ControlPoint {
    /**
     * Index of the point.
     */
    point: number;
    position: [number, number, number];
    /**
     * Standard error of each coordinate, above 0.
     */
    sigma: [number, number, number];
}

/**
 * A point with known object coordinates, with the images in which it was measured.
 */
export interface GroundControlPoint {
    name: string;
    position: ObservedPosition;
    role?: ControlRole;
    /**
     * Standard error of a coordinate of its image measurements in px, above 0; absent: that of the options.
     */
    sigma_px?: number;
    /**
     * Inside their images, one in each.
     */
    measurements: ImageObservation[];
}

/**
 * A position that was observed. All of a block are of the same kind; or those of its images are of one and those of three ground control
 * points or more of the other, which alone georeference the block: then distances between the images are compared with those of the GNSS
 * positions, and it is reported where the ground control points have another unit.
 */
export type ObservedPosition = { system: "local"; position: [number, number, number]; sigma: [number, number, number] } | { system: "geographic"; longitude_deg: number; latitude_deg: number; height_m?: number | null; sigma_m: [number, number, number] };

/**
 * A ray that does not fit to its point.
 */
export interface RejectedObservation {
    /**
     * Index of the image in the adjusted block.
     */
    image: number;
    /**
     * Index of the point in the adjusted block.
     */
    point: number;
    /**
     * Column and row in px.
     */
    x_px: number;
    y_px: number;
    /**
     * Length of its residual before the bundle adjustment in px; absent where the point lies behind the image.
     */
    residual_px: number | null;
    /**
     * Whether it was rejected by hand.
     */
    by_hand?: boolean;
    /**
     * Whether it had been measured by hand.
     */
    measured?: boolean;
}

/**
 * A slip of writing that explains wrong coordinates. Numbers are as they were written.
 */
export type Mistake = { kind: "exchanged" } | { kind: "sign"; axis: Axis; given: string } | { kind: "decimal_point"; axis: Axis; given: string; likely: string } | { kind: "feet"; given: string; likely: string } | { kind: "metres"; given: string; likely: string } | { kind: "digit"; axis: Axis; given: string; likely: string } | { kind: "transposed"; axis: Axis; given: string; likely: string } | { kind: "zone"; zone: number } | { kind: "name"; other: string };

/**
 * A surveyed point as it was measured in an image.
 */
export interface ImageMeasurementRow {
    /**
     * File name of the image.
     */
    image: string;
    /**
     * Name of the point.
     */
    point: string;
    /**
     * Column and row in px; the centre of the top-left pixel is (0.5, 0.5).
     */
    x_px: number;
    y_px: number;
}

/**
 * A surveyed point beside its adjusted place.
 */
export interface SurveyedPoint {
    name: string;
    role: ControlRole;
    /**
     * Image measurements that took part.
     */
    rays: number;
    /**
     * Surveyed, in the system of the model.
     */
    position: [number, number, number];
    /**
     * Adjusted minus surveyed in m.
     */
    difference_m: [number, number, number];
    /**
     * Standard errors of the difference: of a check point those of both places together, of a control point those of a residual; absent without
     * statistics, and for coordinates that nothing checks.
     */
    standard_errors_m: [number | null, number | null, number | null];
    /**
     * Of a control point: the same where it takes no part, which tells what it is worth as a check point would; absent where the other
     * observations do not determine it.
     */
    left_out?: LeftOut;
    /**
     * Of a control point: the error of each coordinate in m that its test finds with a probability of 0.80; absent where nothing checks it.
     */
    detectable_m?: [number | null, number | null, number | null];
    /**
     * Of a control point whose coordinates contradict the other observations.
     */
    refused?: RefusedControl;
}

/**
 * A systematic error as the adjustment has it, or had it before it was fixed at zero.
 */
export interface SystematicStatistics {
    error: SystematicError;
    verdict: SystematicVerdict;
    /**
     * In the unit of the positions, as the standard errors; 0, without a standard error, for a value that nothing determines.
     */
    estimate: [number, number, number];
    /**
     * Absent for a value that was not estimated, and without statistics.
     */
    standard_errors: [number | null, number | null, number | null];
    /**
     * The mean square of the estimate in its standard errors, correlations taken into account; absent where it was not tested.
     */
    test: number | null;
    /**
     * Above it, the test says that the error is not zero: the quantile of the F distribution (of χ² by its degrees of freedom where σ₀ is known).
     */
    limit: number | null;
}

/**
 * A systematic error of GNSS positions, and what became of it.
 */
export interface SystematicSummary extends SystematicStatistics {
    /**
     * In words.
     */
    name: string;
    /**
     * The images of its strip, from the first to the last; absent where it is that of no strip.
     */
    images?: string[];
}

/**
 * A tie point or control point.
 */
export interface ObjectPoint {
    /**
     * By which files and views call it, counted from 1: the same whatever of its block is rejected. Absent where it has none but its place.
     */
    number?: number;
    /**
     * Absent where it is not intersected.
     */
    position?: [number, number, number] | null;
    /**
     * Red, green, blue.
     */
    colour?: [number, number, number];
    /**
     * Root mean square length of its residuals in px.
     */
    rmse_px?: number | null;
    /**
     * Probability, 0..1, that its observations belong together.
     */
    confidence?: number;
    /**
     * Of a ground control or check point.
     */
    name?: string;
    rays: ImageObservation[];
    /**
     * How many of these were measured by hand.
     */
    by_hand?: number;
}

/**
 * A tie point that took part in the adjustment and is not given.
 */
export interface SupportingPoint {
    /**
     * Index of the tie point.
     */
    point: number;
    /**
     * Adjusted.
     */
    position: [number, number, number];
    rays: SupportingRay[];
}

/**
 * An adjusted block with its precision and reliability.
 *
 * Standard errors are with σ₀ a priori where that is given, else with the estimated one, enlarged by what rejections took from the
 * estimate; those of a free network are with respect to its inner constraints.
 */
export interface AdjustmentResult {
    /**
     * The adjusted values; points without rays are as they were given.
     */
    block: Block;
    datum: Datum;
    /**
     * Standard error of one image coordinate of weight 1 in px, made consistent where the rejection has cut the residuals; absent without
     * redundancy.
     */
    sigma0_px: number | null;
    sigma0_a_priori_px: number | null;
    /**
     * Standard error of a coordinate of weight 1 by which everything was weighted whose standard error is stated: the weight of a GNSS coordinate
     * that is stated as σ is the square of this by σ and the factor of its group. Absent in older projects.
     */
    weighted_by_px?: number | null;
    /**
     * Standard error of a coordinate of weight 1 by which cofactors become the covariances of what was estimated. Absent in older projects.
     */
    unit_error_px?: number | null;
    /**
     * What rejections have left of the variance of good observations, 1 without any: σ₀² is v'Pv by the degrees of freedom divided by it, and so is
     * the square of `unit_error_px` beside that of σ₀. Absent in older projects.
     */
    variance_left?: number;
    /**
     * Standard deviation of the shared errors that standard errors hold, in standard errors of an observation.
     */
    shared_errors?: number;
    degrees_of_freedom: number;
    /**
     * Root mean square length of the residuals of all accepted rays in px.
     */
    rmse_px: number;
    /**
     * The same of the points of each number of rays, from 1 on, since a surveyed position counts as a ray; those without points are left
     * out.
     */
    rmse_by_rays: RayCountRmse[];
    /**
     * Those of `weighting` not counted.
     */
    iterations: number;
    /**
     * Root mean square of the last step in standard errors of the unknowns.
     */
    last_step: number;
    /**
     * Adjustments until the set of accepted rays had settled; those of `weighting` not counted.
     */
    rounds: number;
    cameras: CameraStatistics[];
    images: ImageStatistics[];
    /**
     * Absent for points without accepted rays.
     */
    points: (ObjectPointStatistics | null)[];
    rays: ObservationStatistics[];
    /**
     * One for each control point; absent where the datum does not use it.
     */
    control: (PriorStatistics | null)[];
    /**
     * How large the errors of observations are beside their stated standard errors, group by group; empty where no group states any.
     */
    components?: VarianceComponent[];
    /**
     * How weights by the residuals were reached; absent where variance components were not to be estimated.
     */
    weighting?: GroupWeighting;
    /**
     * What systematic errors GNSS positions have; absent where none were to be estimated, or the datum uses no positions.
     */
    systematic?: SystematicResult;
}

/**
 * An error that GNSS positions have in common, with three values in the unit of the positions: metres in a georeferenced block.
 */
export type SystematicError = { kind: "lever_arm"; camera: number } | { kind: "offset" } | { kind: "strip_offset"; strip: number } | { kind: "strip_drift"; strip: number };

/**
 * An image as interior orientation needs it: its size, and what is known of its fiducials.
 */
export interface PhotoGeometry {
    /**
     * In px.
     */
    width: number;
    height: number;
    fiducials?: Fiducial[];
    model?: FiducialModel;
    /**
     * Place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured.
     */
    origin?: [number, number] | null;
}

/**
 * An image before its orientation.
 */
export interface KnownImage {
    /**
     * File name; no two images have the same.
     */
    name: string;
    /**
     * Index of its camera.
     */
    camera: number;
    /**
     * Where GNSS has the projection centre.
     */
    position?: ObservedPosition | null;
    /**
     * The direction of view that a drone recorded, of length 1: east, north, up. It levels a block that its positions hardly level.
     */
    view?: [number, number, number];
}

/**
 * An image by its name, and why it is not in the block.
 */
export interface NamedReason {
    name: string;
    reason: WithText<Failure>;
}

/**
 * An image of a finished block.
 */
export interface ImageRow {
    name: string;
    width_px: number;
    height_px: number;
    /**
     * Index of its camera.
     */
    camera: number;
    /**
     * Index of the model that it is in; absent where it is not oriented.
     */
    model: number | null;
    /**
     * Whether it is oriented in the model that is written.
     */
    is_oriented: boolean;
    /**
     * Its projection centre there.
     */
    position: [number, number, number] | null;
    /**
     * Why it is not; absent where it is.
     */
    reason: WithText<ImageReason> | null;
    /**
     * Points found and described; absent where an older project file does not say.
     */
    features: number | null;
    /**
     * In the model that is written.
     */
    observations: number;
    /**
     * Of the nine von Gruber positions, those that hold one of these.
     */
    positions: number;
    /**
     * Root mean square length of the residuals of its observations in px; absent where it has none that are adjusted.
     */
    rmse_px: number | null;
    /**
     * As the image's EXIF says, 1..8.
     */
    exif_orientation: number | null;
    gnss: ExifPosition | null;
}

/**
 * An image that is in no model, and why.
 */
export interface NotOriented {
    name: string;
    reason: WithText<UnorientedReason>;
}

/**
 * An image that is in no model.
 */
export interface UnorientedImage {
    /**
     * Index of the image.
     */
    image: number;
    reason: UnorientedReason;
}

/**
 * An image that is not in the block, and why.
 */
export interface SkippedImage {
    name: string;
    reason: Failure;
}

/**
 * An image that was read.
 */
export interface ReadImage {
    /**
     * Its place among the names that the run was given.
     */
    index: number;
    name: string;
    width_px: number;
    height_px: number;
    features: number;
    exif: ExifImage;
    /**
     * The GNSS position that a table gives it, in place of that of the file.
     */
    given?: GivenPosition;
    /**
     * As far as this image says.
     */
    camera: InitialCamera;
}

/**
 * An image that was read.
 */
export interface RunImage {
    /**
     * File name; no two images have the same.
     */
    name: string;
    /**
     * Of its record of features.
     */
    key: string;
    /**
     * SHA-256 of the file in hexadecimal digits.
     */
    content: string;
    width_px: number;
    height_px: number;
    /**
     * Absent where an older project file does not say.
     */
    features: number | null;
    /**
     * Whether a mask belongs to it.
     */
    masked: boolean;
    exif: ExifImage;
    /**
     * The GNSS position that a table gave, in place of that of the file.
     */
    given?: GivenPosition;
    /**
     * Index of its camera.
     */
    camera: number;
}

/**
 * An image whose GNSS position does not fit, and its distance from the adjusted one.
 */
export interface RejectedPosition {
    name: string;
    distance_m: number;
}

/**
 * An image with a GNSS position, or a height of it, that cannot be.
 */
export interface ImpossiblePosition {
    name: string;
    /**
     * As the file has it.
     */
    value: string;
}

/**
 * An image with its verdict.
 */
export interface PlacedImage {
    verdict: PlacingVerdict;
    /**
     * Absent where there is none.
     */
    placement: Placement | null;
    /**
     * Absent where it was not sought by a GNSS position.
     */
    search?: PlaceSearch;
}

/**
 * An image.
 */
export interface ModelImage {
    /**
     * File name; no two images have the same.
     */
    name: string;
    /**
     * Index of its camera.
     */
    camera: number;
    /**
     * Absent where it is not oriented.
     */
    pose?: Pose | null;
}

/**
 * An observation of a point.
 */
export interface ObservationDetail {
    /**
     * Index of the image in the block.
     */
    image: number;
    /**
     * Column and row in px.
     */
    x_px: number;
    y_px: number;
    part: ObservationPart;
    /**
     * Whether it was measured by hand.
     */
    by_hand: boolean;
    /**
     * Observed minus computed.
     */
    residual_px: [number, number] | null;
    /**
     * r, 0..1, of column and row: the share of an error that shows in the residual.
     */
    redundancy: [number, number] | null;
    /**
     * Residuals by their standard errors (Baarda's w).
     */
    w: [number, number] | null;
    /**
     * The error that its test finds with a probability of 0.80.
     */
    detectable_px: [number | null, number | null];
    /**
     * Where the adjusted point is in the image; absent behind it.
     */
    predicted_px: [number, number] | null;
}

/**
 * An observation of such a point.
 */
export interface SupportingRay {
    /**
     * Index of the image in the adjusted block.
     */
    image: number;
    /**
     * Column and row in px, in the precision of features.
     */
    x_px: number;
    y_px: number;
    /**
     * Whether the adjustment rejected it; older projects do not say, and hold few that it did.
     */
    rejected?: boolean;
}

/**
 * An observed position beside where its point is without it.
 */
export interface LeftOut {
    /**
     * Adjusted without it minus observed.
     */
    difference: [number, number, number];
    /**
     * Standard errors of that difference.
     */
    standard_errors: [number, number, number];
}

/**
 * An observed position with the standard error of each of its coordinates.
 */
export interface PositionPrior {
    position: [number, number, number];
    /**
     * Above 0; absent for a coordinate that was not observed: its place in `position` means nothing.
     */
    sigma: [number | null, number | null, number | null];
}

/**
 * An unknown of a camera.
 */
export type CameraParameter = "focal" | "principal_x" | "principal_y" | "k1" | "k2" | "k3" | "p1" | "p2";

/**
 * Angles as they were recorded.
 */
export interface Attitude {
    /**
     * From north to east.
     */
    yaw_deg: number;
    pitch_deg: number;
    roll_deg: number;
}

/**
 * By what standard errors grow for a region to hold the truth with a probability of 95 %.
 */
export interface Factors95 {
    /**
     * Of one unknown: the half-width of its interval by its standard error.
     */
    interval: number;
    /**
     * Of two unknowns that belong together: their ellipse by the standard error ellipse.
     */
    ellipse: number;
    /**
     * Of three: their ellipsoid by the standard error ellipsoid.
     */
    ellipsoid: number;
}

/**
 * By what the differences of the heights from their mean would have to be multiplied to fit the image best.
 */
export interface HeightFactor {
    factor: number;
    standard_error: number;
}

/**
 * Edits that hold of a block that was placed anew.
 */
export interface CarriedEdits {
    edits: BlockEdit[];
    /**
     * What was done to so many places of the orthophoto, or to observations of them, holds.
     */
    held: number;
    /**
     * Of so many something does not: nothing lies there now, the image does not show it, what was measured by hand is of another spot, or it is a place
     * by hand whose coordinates are of another system.
     */
    lost: number;
}

/**
 * Errors that GNSS positions share.
 */
export type GnssErrors = "none" | "offset" | "strip-offsets" | "strip-drifts";

/**
 * Expected offsets (right minus left position) at the nodes of a square grid over the left image, in between bilinear.
 */
export interface OffsetField {
    columns: number;
    rows: number;
    /**
     * Distance of the nodes in px; the first lies at (0, 0).
     */
    spacing_px: number;
    /**
     * `[dx, dy]` in px of each node, row by row.
     */
    offsets: [number, number][];
    /**
     * Median of the offsets that were found, in px.
     */
    median_px: [number, number];
    /**
     * Median correlation of the nodes that were found; absent for a given offset.
     */
    correlation: number | null;
}

/**
 * Figures of a map.
 */
export interface AccuracySummary {
    /**
     * Standard error of an image coordinate of the points that would be measured, in px.
     */
    sigma_px: number;
    /**
     * Side of a cell.
     */
    cell: number;
    /**
     * Cells that two or more images show.
     */
    cells: number;
    /**
     * Of these the share that three or more show, 0 to 1.
     */
    three_or_more: number;
    /**
     * Of these the median standard errors, and those that 95 % of the cells do not exceed.
     */
    plan: [number, number];
    height: [number, number];
    /**
     * Mean number of images that show a cell.
     */
    images: number;
}

/**
 * Flights of blocks that are ready made.
 */
export type BlockPreset = "features" | "photos" | "small_photos" | "network";

/**
 * Flights that are ready made.
 */
export type Preset = "sample" | "paper" | "hard" | "lively";

/**
 * Ground control points and their image measurements, as the texts of two files.
 */
export interface ControlTexts {
    points: string;
    marks: string;
}

/**
 * How a place was measured, which says what it weighs.
 */
export type MeasuredBy = "hand" | "least_squares";

/**
 * How a point's position is found between the pixels.
 */
export type PointPosition = "quadratic" | "forstner";

/**
 * How an image with a GNSS position was sought on an orthophoto whose system is known.
 */
export type PlaceSearch = { kind: "gnss"; within_m: number; plan_m?: number } | { kind: "apart_from_gnss"; plan_m: number; usual_m: number } | { kind: "far_from_gnss"; distance_km: number; place_slip: PlaceSlip } | { kind: "height_apart_from_gnss"; height_m: number; usual_m: number } | { kind: "beyond_gnss"; within_m: number };

/**
 * How an orthophoto may have come to lie elsewhere than the images that are to be placed on it.
 */
export type PlaceSlip = { kind: "zone"; zone: number } | { kind: "exchanged" } | { kind: "other_half" } | { kind: "unit"; given_in: string } | { kind: "coordinate"; likely: string } | { kind: "exchanged_positions" } | { kind: "latitude_sign" } | { kind: "longitude_sign" } | { kind: "both_signs" } | { kind: "unknown" };

/**
 * How far a stage is.
 */
export interface Step {
    stage: StageName;
    done: number;
    total: number;
    /**
     * What was done last: the name of an image, or of both of a pair; empty where there is none.
     */
    name: string;
    /**
     * How many of those done are from an earlier run.
     */
    found: number;
}

/**
 * How far the y-parallax of a point is from those of its nearest matches, and how far it may be, in px.
 */
export interface ParallaxDeviation {
    deviation_px: number;
    /**
     * The tolerance, or 3 times the scatter of the neighbours where that is larger.
     */
    allowed_px: number;
}

/**
 * How grey values I become the weights g of the moments.
 */
export type Brightness = "sum" | "range" | "unit";

/**
 * How many left points each rule refused.
 */
export interface MatchCounts {
    matches: number;
    no_descriptor: number;
    no_candidate: number;
    threshold: number;
    ambiguous: number;
    many_to_one: number;
    parallax: number;
    border: number;
    left_right: number;
    not_converged: number;
    imprecise: number;
    frame: number;
}

/**
 * How many points are kept, and where.
 */
export interface SelectOptions {
    /**
     * The number of its points that an image keeps, spread evenly; its connections may need more.
     */
    per_image: number;
    /**
     * The number of common points that two overlapping images keep, or all where they have fewer.
     */
    per_connection: number;
}

/**
 * How many points each phase left (the first rows of the paper's Table 1).
 */
export interface PointCounts {
    /**
     * Pixels (or windows) that passed the operator's threshold.
     */
    candidates: number;
    /**
     * Of these, the ones that passed the threshold of roundness; all of them where the operator has none.
     */
    after_roundness: number;
    /**
     * Of these, the ones that suppression of non-maxima left.
     */
    after_suppression: number;
}

/**
 * How matches are joined to tie points.
 */
export interface BlockOptions {
    /**
     * What is done where matches give a point two observations in one image: the least probable matches are cut, or the point is dropped.
     */
    conflicts: Conflicts;
    /**
     * The expected share of points with an observation that does not belong to them: matches that third images confirm too little are
     * ignored, and more gives more points of two images where the overlap is small.
     */
    impure: number;
    /**
     * The minimum number of images that show a point: more leave fewer, more certain points.
     */
    min_rays: number;
    /**
     * The expected share of right matches where no third image decides, as in a block of two images: higher keeps more points.
     */
    expected_right: number;
}

/**
 * How near a block is to its truth.
 */
export interface BlockScore {
    /**
     * Images of the truth that the block has, and those of them that it has oriented.
     */
    images: number;
    oriented: number;
    /**
     * Root mean square errors of x, y, z of the perspective centres in m, after the similarity transformation that brings all of them
     * nearest to the truth: what the placing of the block adds is no part of it. Absent for fewer than three or those in one place.
     */
    position_rmse_m: [number, number, number] | null;
    /**
     * Root mean square angle in degrees between the oriented and the true directions, after the same transformation.
     */
    angle_rmse_deg: number | null;
    /**
     * Points with two or more rays in images of the truth.
     */
    points: number;
    /**
     * Those of which all rays meet, by the true orientations, within 1.5 px in each image. Of two rays only the error across the epipolar
     * line shows.
     */
    right_points: number;
    /**
     * Root mean square distance in px of the rays of right points from where they meet.
     */
    right_rmse_px: number | null;
}

/**
 * How observations that survived the rejection are weighted down for their residuals.
 */
export type Weighting = "none" | "huber" | "danish";

/**
 * How observations with large residuals are weighted down until the gross errors are found.
 */
export type Loss = "squares" | "huber" | "cauchy";

/**
 * How the observations of chosen points are refined.
 */
export type RefinementMethod = "none" | "least-squares";

/**
 * How the photos of a block look at the ground.
 */
export type BlockView = "nadir" | "oblique" | "two-heights";

/**
 * How the right point of a left one is found.
 */
export type Strategy = "auto" | "moments" | "invariants" | "correlation" | "least-squares" | "gradient";

/**
 * How the scan of a photo on film lies to its frame: the image of a camera without distortion, with square pixels, along the photo's axes, of what lies
 * within the marks.
 */
export interface FilmScan {
    /**
     * Of the scan.
     */
    width_px: number;
    height_px: number;
    focal_mm: number;
    /**
     * Of the scan.
     */
    interior: Interior;
    /**
     * How the marks give it.
     */
    marks: FiducialOrientation;
    /**
     * Side of a pixel of the frame.
     */
    pixel_mm: number;
    /**
     * Where the top-left corner of the frame lies among the undistorted positions of the scan: see [`Interior::undistorted_px`].
     */
    corner_px: [number, number];
    /**
     * Width and height of the frame.
     */
    frame_px: [number, number];
}

/**
 * How the weights of groups of observations were found.
 */
export interface GroupWeighting {
    /**
     * Times that a group was weighted anew.
     */
    rounds: number;
    /**
     * Of all adjustments after the first of these.
     */
    iterations: number;
    /**
     * Whether nothing was left to change; otherwise weights still changed when the rounds were spent.
     */
    converged: boolean;
}

/**
 * How two epipolar images lie: cameras without distortion, of one focal length, with the same axes, whose x axis is the base.
 *
 * A point of the object is seen at col = c_x + f·U/(-W), row = c_y - f·V/(-W) with (U, V, W) = M·(X - X₀), M being `rotation` and X₀ the
 * projection centre of either image. Both have the same row; its distance from the base in the direction of the axis is
 * -W = f·base / ((col_left - c_x left) - (col_right - c_x right)).
 */
export interface EpipolarGeometry {
    /**
     * Of either image.
     */
    width_px: number;
    height_px: number;
    focal_px: number;
    /**
     * Of the left and the right image: they differ in the column, so that the median x-parallax is about 0. The centre of the top-left pixel is (0.5, 0.5).
     */
    principal_points_px: [[number, number], [number, number]];
    /**
     * Rows of M, from the object to the photos: x along the base from left to right, y up, z against the view.
     */
    rotation: [[number, number, number], [number, number, number], [number, number, number]];
    /**
     * Projection centres of the left and the right image.
     */
    projection_centres: [[number, number, number], [number, number, number]];
    /**
     * Distance of the projection centres, in units of the block; of a pair in mm at the scale of the photo coordinates.
     */
    base: number;
    /**
     * Parallaxes of the points that both show; absent where none is known.
     */
    parallaxes: Parallaxes | null;
}

/**
 * Image measurements, those of scans in px of their frames.
 */
export interface FramedMeasurements {
    /**
     * In their order; those of other images are as they were given.
     */
    measurements: ImageMeasurementRow[];
    /**
     * So many of them were made in scans.
     */
    moved: number;
    /**
     * Those, as they were given, that lie beside the frame of their scan, and so have none there.
     */
    beside: ImageMeasurementRow[];
}

/**
 * Images that were read and those that were not.
 */
export interface ImageCounts {
    read: number;
    left_out: NamedReason[];
    masked: number;
    /**
     * Masks that belong to no image.
     */
    stray_masks: string[];
    /**
     * Images that image measurements name and that are not in the block.
     */
    stray_marks: string[];
    /**
     * Absent where an older project file does not say.
     */
    features: number | null;
}

/**
 * Images that were taken one after the other along a line.
 */
export interface Strip {
    /**
     * By their indices, in the order in which they were taken.
     */
    images: number[];
    /**
     * The place of each along the line: 0 on average, from the first to the last one 1.
     */
    places: number[];
}

/**
 * Observations whose standard errors are stated together.
 */
export type ObservationGroup = "marks" | "gnss_plan" | "gnss_height" | "control_plan" | "control_height";

/**
 * One image.
 */
export interface BlockImage {
    /**
     * Index of its camera.
     */
    camera: number;
    pose: Pose;
    /**
     * Where GNSS has the projection centre, but for systematic errors of the positions.
     */
    gnss?: PositionPrior | null;
    /**
     * Where its axis is known to point in the system of the observed positions; a free network does not use it.
     */
    axis?: AxisPrior;
}

/**
 * One number for each of the five unknowns.
 */
export interface FiveParameters {
    omega_deg: number;
    phi_deg: number;
    kappa_deg: number;
    by_mm: number;
    bz_mm: number;
}

/**
 * Options of [`adjust_block`](crate::adjust_block).
 */
export interface AdjustmentOptions {
    /**
     * What says where the block lies: its approximate values (free network), GNSS positions, control points.
     */
    datum: Datum;
    /**
     * How large residuals are weighted down until the gross errors are found.
     */
    loss: Loss;
    /**
     * Rejects gross errors by the tests of their residuals.
     */
    snooping: boolean;
    /**
     * The probability with which data snooping rejects a good coordinate: higher rejects more; 0.001 rejects beyond 3.29 standard errors
     * (Baarda 1968).
     */
    alpha0: number;
    /**
     * The standard error of an image coordinate of weight 1 that is known before: a larger one rejects fewer observations.
     */
    sigma0_px: number | null;
    /**
     * A free camera parameter is fixed where its standard error moves an observation at the edge of the image by more than this: higher
     * estimates more parameters.
     */
    calibration_limit_px: number;
    /**
     * Estimates how much larger or smaller the errors of image measurements, GNSS positions and control points are than stated, and weights
     * them by it where that is certain.
     */
    variance_components: boolean;
    /**
     * The offset of GNSS positions that is estimated: one of all, or one of each strip, alone or with a drift that is linear along it. It is kept
     * where it differs from zero by more than chance, at the significance α₀.
     */
    gnss_errors: GnssErrors;
    /**
     * Estimates the lever arm of each camera, from its projection centre to the antenna of GNSS; it is kept where it differs from zero by more
     * than chance.
     */
    gnss_lever_arm: boolean;
    /**
     * The standard deviation, in standard errors of an observation, of errors that the observations of an image share, as those of matches do:
     * standard errors hold it. 0: observations are independent.
     */
    shared_errors: number;
    /**
     * The maximum number of iterations of one adjustment.
     */
    max_iterations: number;
    /**
     * Computes standard errors, redundancies and tests, which data snooping needs; they take about as long as the adjustment.
     */
    statistics: boolean;
}

/**
 * Options of [`detect`](crate::detect). All but the operator are of those that look at one scale.
 */
export interface PointOptions {
    /**
     * The interest operator: ground 2 is the paper's choice, multiscale finds points of many sizes for images of different scales.
     */
    operator: Operator | null;
    /**
     * A higher threshold finds fewer points. Ground: grey difference (paper: 40). Förstner: factor of the mean weight (0.5 to 1.5).
     * Moravec: sum of squared grey differences.
     */
    threshold: number | null;
    /**
     * The share of all pixels that become candidates, in place of a threshold (paper: 0.148): more give more points. It is independent of
     * contrast.
     */
    fraction: number | null;
    /**
     * A higher minimum keeps fewer, rounder points: 1 is a corner or spot, 0 an edge (ground 2: 0.32 to 0.5, Förstner: 0.5 to 0.75).
     */
    roundness: number | null;
    /**
     * A larger window finds larger structures: Moravec 4 or 8, Förstner 5 or 7; the ground operators always use 3.
     */
    operator_window: number | null;
    /**
     * Moravec: windows side by side, as first published, in place of one at each pixel.
     */
    tiled: boolean;
    /**
     * A point is suppressed where this window around it holds a greater value (paper: 3): larger windows leave fewer, better spread points;
     * 1 suppresses none.
     */
    suppression_window: number;
    /**
     * Whether all of several equal values in the suppression window survive, or the first in raster order.
     */
    ties: Ties;
}

/**
 * Options of [`features`](crate::features).
 */
export interface FeatureOptions {
    multiscale: MultiscaleOptions;
    gradient: GradientOptions;
}

/**
 * Options of [`gradient_features`](crate::gradient_features).
 */
export interface GradientOptions {
    /**
     * No dominant direction is sought: better and faster where the images are not rotated against each other.
     */
    upright: boolean;
    /**
     * A point with several dominant directions gets a descriptor for each, up to this many: more match more points and take longer.
     */
    orientations: number;
    /**
     * The side of one of the 4 x 4 cells in scales of the point: larger cells tell more points apart and tolerate less relief.
     */
    cell: number;
    /**
     * Square roots of the histograms are compared, so that strong gradients do not outweigh the others.
     */
    roots: boolean;
}

/**
 * Options of [`guided_matches`].
 */
export interface GuidedOptions {
    /**
     * The distance from the epipolar line, or from the place that a plane gives, within which right points are candidates: more finds
     * points of less exact geometries.
     */
    radius_px: number;
    /**
     * The ratio to the second nearest among the candidates, of which there are few: higher keeps more, less certain matches.
     */
    ratio: number;
    /**
     * The Euclidean distance of two descriptors beyond which they never match: more keeps more, less certain matches.
     */
    largest_distance: number | null;
}

/**
 * Options of [`match_features`].
 */
export interface FeatureMatchOptions {
    nearest: NearestOptions;
    /**
     * Width and height of both images in px: what lies at the same place of both frames is left out then, as film borders are. Absent:
     * nothing is.
     */
    sizes: [[number, number], [number, number]] | null;
    /**
     * What is known of the cameras, and the search for what relates the views.
     */
    geometry: TwoViewOptions;
}

/**
 * Options of [`multiscale_points`](crate::multiscale_points).
 */
export interface MultiscaleOptions {
    /**
     * The maximum number of points per image: more take longer; they are distributed so that dull regions keep their share.
     */
    number: number;
    /**
     * The steps of the pyramid while the scale doubles: more find points of more exact scales and take longer.
     */
    levels: number;
    /**
     * A lower minimum contrast of a point to its surroundings finds more, noisier points.
     */
    contrast: number;
    /**
     * A higher minimum keeps fewer, rounder points at the point's scale: 1 is a corner or spot, 0 an edge.
     */
    roundness: number;
    /**
     * The cells on the longer side of the image, over which half of the points are distributed equally: more spread the points more
     * evenly; 1 keeps the best of the whole image.
     */
    cells: number;
    /**
     * The maximum of a quadratic through the responses, or the corner or centre of a circle by least squares (Förstner).
     */
    position: PointPosition;
}

/**
 * Options of [`nearest_matches`].
 */
export interface NearestOptions {
    /**
     * A match is rejected as ambiguous unless its distance is below this share of that of the second nearest descriptor: higher keeps more,
     * less certain matches; 1 asks only that it is nearer.
     */
    ratio: number;
    /**
     * A match stands only where each of its two descriptors is the nearest of the other.
     */
    mutual: boolean;
    /**
     * The Euclidean distance of two descriptors beyond which they never match: more keeps more, less certain matches.
     */
    largest_distance: number | null;
}

/**
 * Options of [`orient_relative`](crate::orient_relative).
 */
export interface OrientationOptions {
    /**
     * Rigorous: all four photo coordinates are observed. Determinant: the textbook form with unweighted determinants.
     */
    method: OrientationMethod;
    /**
     * Starts from the consensus of minimal samples and rejects gross errors; without it one blunder can carry the solution away.
     */
    robust: boolean;
    /**
     * The share of good matches that data snooping rejects by mistake: higher rejects more; 0.001 rejects beyond 3.29 standard errors
     * (Baarda 1968).
     */
    alpha0: number;
    /**
     * The probability with which a blunder of the minimal detectable size is found: higher makes that size larger.
     */
    beta0: number;
    /**
     * Weighs matches with large residuals down, in addition to their rejection.
     */
    weighting: Weighting;
    /**
     * The standard error of a photo coordinate that is known before: standard errors and tests use it, a global test compares it with the
     * residuals, and a larger one rejects fewer matches.
     */
    sigma0_mm: number | null;
    /**
     * The start of the random numbers of the consensus: the same seed gives the same result.
     */
    seed: number;
    /**
     * The length b of the base at photo scale, not 0, by which by and bz grow in proportion; its sign is that of the geometry, so that a
     * minus changes nothing.
     */
    base_mm: number | null;
}

/**
 * Options of [`place_image`](crate::place_image).
 */
export interface PlacingOptions {
    /**
     * The place near which the image was taken, in the system of the orthophoto: X; the search goes no farther than the radius.
     */
    near_x: number | null;
    /**
     * The same: Y.
     */
    near_y: number | null;
    /**
     * The distance from that place within which the image may show the ground.
     */
    within_m: number;
    /**
     * The maximum number of points of the image that are sought on the orthophoto: more find harder places and take longer.
     */
    points: number;
    /**
     * The standard error of a place of the orthophoto, in its px: a larger one enlarges the standard errors of the image.
     */
    place_sigma_px: number;
    /**
     * The standard error of a height of the ground, by which all heights of a model may be wrong together: a larger one enlarges the standard errors of the image, and weakens links far from the nadir.
     */
    height_sigma_m: number | null;
    /**
     * The height of the zero of the heights of the ground above the ellipsoid of WGS 84, where their file does not say that they count from the ellipsoid: that of the geoid for heights above sea level, 0 for ellipsoidal ones.
     * The height of a precise GNSS position, which is above the ellipsoid, is then compared with that of the image.
     */
    heights_geoid_m: number | null;
    /**
     * The share of the links that takes no part and checks the orientation instead.
     */
    check_share: number;
    /**
     * The start of the random numbers: the same seed gives the same result.
     */
    seed: number;
}

/**
 * Options of [`reconstruct_block`](crate::reconstruct_block).
 */
export interface ReconstructionOptions {
    /**
     * What says where the block lies, in place of the datum of the adjustment.
     */
    datum: Datum | null;
    /**
     * The observations per image by which the block is oriented and, where points are chosen, adjusted: more are more precise, fewer are
     * faster.
     */
    growing_rays: number;
    /**
     * The minimum number of observations that agree on the orientation of an image: more orient fewer images, more certainly.
     */
    least_rays: number;
    /**
     * The minimum angle between two rays of a point: a larger one ignores more points of uncertain depth.
     */
    least_angle_deg: number;
    /**
     * The maximum residual of an observation while the block grows; it follows the residuals down from there.
     */
    largest_residual_px: number;
    /**
     * The standard error of a measured coordinate of a control point: higher gives it less weight beside tie points; measurements beyond
     * five times as much do not fit.
     */
    mark_sigma_px: number;
    /**
     * The maximum number of models that are given where the block falls apart, the largest first.
     */
    most_models: number;
    /**
     * The start of the random numbers: the same seed gives the same result.
     */
    seed: number;
    /**
     * Control points, the first so many of the description, that are rejected and named where they contradict the other observations; absent: all.
     */
    tested_control: number | null;
    /**
     * How many tie points there were to choose from, as far as that is known: above these count the numbers by which texts name other points.
     */
    found_points: number;
    /**
     * The points that are given of the adjusted block; absent: all are adjusted and given.
     */
    selection: SelectOptions | null;
    /**
     * By default as [`AdjustmentOptions`] is, but that camera parameters are fixed beyond 20 px.
     */
    adjustment: AdjustmentOptions;
}

/**
 * Options of [`two_view`](crate::two_view).
 */
export interface TwoViewOptions {
    /**
     * The maximum distance of a good match from the geometry: higher keeps more, less exact matches.
     */
    threshold_px: number | null;
    /**
     * The upper limit of the threshold that follows from the matches: raise it for coarse matches.
     */
    largest_threshold_px: number;
    /**
     * The probability of drawing at least one sample of good matches only: higher draws more samples.
     */
    confidence: number;
    /**
     * The maximum number of samples: more take longer where few matches are good.
     */
    max_samples: number;
    /**
     * The start of the random numbers: the same seed gives the same result.
     */
    seed: number;
    /**
     * The cameras; absent: nothing is known of them. Both or neither.
     */
    left: Pinhole | null;
    right: Pinhole | null;
}

/**
 * Options of a block from its images to its tie points.
 */
export interface BlockSettings {
    features: FeatureOptions;
    pairs: PairChoice;
    nearest: NearestOptions;
    /**
     * Its cameras are those of the block.
     */
    geometry: TwoViewOptions;
    placing: GeoreferencingOptions;
    block: BlockOptions;
    selection: SelectOptions;
    refinement: RefinementOptions;
}

/**
 * Options of the matching.
 */
export interface MatchOptions {
    /**
     * Moments and invariants compare interest points of both images, invariants also where these are rotated; correlation and least
     * squares compare grey values; gradient matches photos of any rotation, scale and obliquity and needs no offset; auto does so and
     * refines the matches.
     */
    strategy: Strategy;
    /**
     * Least squares matching moves each right position to a hundredth of a pixel; what does not fit is rejected, or stays where it is.
     */
    refine: Refinement | null;
    /**
     * Points without a match are matched by least squares from where the matches around them predict them, if they lie near their
     * epipolar lines. Matches that it does not confirm are rejected where confirmed ones around them lead elsewhere.
     */
    fill_in: boolean;
    /**
     * Once the pair is oriented, it is matched again near the epipolar lines, until nothing changes; this needs a camera. Gradient always
     * does so once, with a camera or without.
     */
    epipolar: boolean;
    /**
     * What a difference is divided by: the larger magnitude, or at least the median magnitude over all points, which keeps small moments
     * from dominating.
     */
    denominator: Denominator;
    /**
     * The side of the window around the expected position in which right points are candidates (paper: 25): a larger one admits larger
     * parallaxes and more wrong matches.
     */
    search: number;
    /**
     * The best candidate is rejected unless its measure is below this (paper: 3): higher keeps more, less certain matches.
     */
    max_measure: number;
    /**
     * A match is rejected as ambiguous where the best measure exceeds this share of the second best: higher keeps more, less certain
     * matches; 1 switches the rule off.
     */
    ambiguity: number | null;
    /**
     * The nearest matches that give the expected y-parallax: more follow its changes less closely; 0 switches the rule off.
     */
    parallax_neighbours: number;
    /**
     * A y-parallax that deviates from the neighbours' median by more than this, and by more than 3 times their scatter, is rejected:
     * higher keeps more matches.
     */
    parallax_tolerance: number;
    /**
     * The side of the window whose grey values correlation and least squares matching compare: larger ones are more distinct and
     * tolerate less relief.
     */
    template: number;
    /**
     * A match by grey values with a lower correlation coefficient is rejected: higher keeps fewer, more certain matches.
     */
    min_correlation: number;
    /**
     * Correlation: the window that is found must correlate best with the left point it came from. Gradient: the descriptor that is found
     * must be nearest to that of the left point.
     */
    left_right: boolean;
    /**
     * A least squares match whose right position has a larger standard error is rejected, as on an edge along which it can slide: higher
     * keeps more, less precise matches.
     */
    max_standard_error: number;
    /**
     * Ignores what lies at the same place of both frames and matches by itself, as film borders, fiducial marks and data strips.
     */
    without_frame: boolean;
}

/**
 * Options of the window around a point.
 */
export interface WindowOptions {
    /**
     * The side of the window whose moments describe a point (paper: 11): larger windows are more distinct and tolerate less relief.
     */
    side: number;
    /**
     * A circular window does not change when the image is rotated; a square one does.
     */
    shape: WindowShape;
    /**
     * How grey values become weights: sum and range do not change with gain and offset; unit is grey / 255.
     */
    brightness: Brightness;
}

/**
 * Pairs by their outcomes.
 */
export interface PairCounts {
    tried: number;
    connected: number;
    too_few_matches: number;
    not_oriented: number;
    failed: number;
    /**
     * Verified matches of all connected pairs.
     */
    matches: number;
}

/**
 * Parallaxes of known points in the epipolar images.
 */
export interface Parallaxes {
    points: number;
    /**
     * Root mean square of the residual y-parallaxes: differences of rows, left minus right.
     */
    y_rms_px: number;
    /**
     * The smallest, the median and the largest difference of columns, left minus right.
     */
    x_px: [number, number, number];
}

/**
 * Parameters of a simulated pair. The default is the paper's geometry over a synthetic town.
 */
export interface Flight {
    /**
     * Everything random follows from it: the same seed gives the same pair.
     */
    seed: number;
    /**
     * The height of the left photo above the mean ground: a larger one makes the scale smaller.
     */
    flying_height_m: number;
    /**
     * The base component b at photo scale, of a frame of 230 mm: a longer base leaves less overlap.
     */
    base_mm: number;
    /**
     * The rotation of the right photo about x against the left one.
     */
    omega_deg: number;
    /**
     * The rotation of the right photo about y against the left one.
     */
    phi_deg: number;
    /**
     * The rotation of the right photo about z against the left one.
     */
    kappa_deg: number;
    /**
     * The base component across the flight, at photo scale.
     */
    by_mm: number;
    /**
     * The base component upwards, at photo scale.
     */
    bz_mm: number;
    /**
     * The tilt of the left photo about x against the ground.
     */
    left_omega_deg: number;
    /**
     * The tilt of the left photo about y against the ground.
     */
    left_phi_deg: number;
    /**
     * The rotation of the left photo against the flight line.
     */
    left_kappa_deg: number;
    /**
     * The principal distance of the camera: a longer one makes the scale larger.
     */
    focal_mm: number;
    /**
     * The principal point in the system of the fiducial marks.
     */
    principal_x_mm: number;
    /**
     * The principal point in the system of the fiducial marks.
     */
    principal_y_mm: number;
    /**
     * Corrected coordinates are measured ones times 1 + k₁ r²: 0.0000001 moves a corner of the frame by some 0.3 mm.
     */
    distortion: number;
    /**
     * The side of a pixel of the scan: larger pixels show less detail.
     */
    pixel_mm: number;
    /**
     * The columns of the patches that are cut from the scans; the overlap limits them.
     */
    width_px: number;
    /**
     * The rows of the patches that are cut from the scans; the frame limits them.
     */
    height_px: number;
    /**
     * The standard deviation of a measured fiducial coordinate.
     */
    fiducial_noise_px: number;
    /**
     * The range of the terrain's heights, up to a tenth of the flying height.
     */
    relief_m: number;
    /**
     * The number of buildings; fewer stand where there are fewer lots.
     */
    buildings: number;
    /**
     * The height of the lowest eaves above ground.
     */
    lowest_building_m: number;
    /**
     * The height of the highest eaves above ground, up to a tenth of the flying height.
     */
    highest_building_m: number;
    /**
     * The number of trees; a few less stand, since none grows in a house, a street or the river.
     */
    trees: number;
    /**
     * The width of a river through the town, whose surface looks different in each exposure; 0: none.
     */
    river_m: number;
    /**
     * The distance that cars in the lanes drive between the exposures; 0: they stand.
     */
    driven_m: number;
    /**
     * The standard deviation of the lens's point spread, to which the pixel's own square adds: a larger one blurs more.
     */
    psf_px: number;
    /**
     * The standard deviation of a blur of the right image in addition to the point spread.
     */
    right_blur_px: number;
    /**
     * The standard deviation of independent noise in both images.
     */
    noise_grey: number;
    /**
     * The standard deviation of noise that neighbouring pixels share.
     */
    grain_grey: number;
    /**
     * The standard deviation of the grain's spread: larger grains share their noise over more pixels.
     */
    grain_px: number;
    /**
     * The grey values of the right image are those of the scene times the gain, plus the offset.
     */
    gain: number;
    /**
     * The grey values of the right image are those of the scene times the gain, plus the offset.
     */
    offset_grey: number;
    /**
     * The share of the light that is haze of a uniform grey of 190 in both images: more leaves less contrast.
     */
    haze: number;
}

/**
 * Points of one number of rays.
 */
export interface RayCount {
    rays: number;
    points: number;
    /**
     * Root mean square length of the residuals of their observations; absent before the adjustment.
     */
    rmse_px: number | null;
}

/**
 * Precision of a camera.
 */
export interface CameraStatistics {
    /**
     * Of f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂; absent for what was not estimated.
     */
    standard_errors: [number | null, number | null, number | null, number | null, number | null, number | null, number | null, number | null];
    /**
     * Between the parameters that were estimated, in their order, row by row; empty without any.
     */
    correlations?: number[][];
    fixed: FixedParameter[];
}

/**
 * Precision of an image.
 */
export interface ImageStatistics {
    /**
     * Accepted rays.
     */
    rays: number;
    /**
     * Root mean square length of the residuals of its accepted rays in px; 0 without any.
     */
    rmse_px: number;
    /**
     * Standard errors of ω, φ, κ; absent without statistics, and where φ is ±90°.
     */
    angle_errors_deg: [number, number, number] | null;
    /**
     * Standard errors of X₀; absent without statistics.
     */
    position_errors: [number, number, number] | null;
    /**
     * Correlations of X₀ with Y₀, of X₀ with Z₀, of Y₀ with Z₀; absent without statistics.
     */
    position_correlations?: [number, number, number] | null;
    /**
     * Of its GNSS position, where the datum uses it.
     */
    gnss: PriorStatistics | null;
}

/**
 * Precision of an object point.
 */
export interface ObjectPointStatistics {
    /**
     * Accepted rays.
     */
    rays: number;
    /**
     * Root mean square length of the residuals of its accepted rays in px.
     */
    rmse_px: number;
    /**
     * Standard errors of X, Y, Z; absent without statistics.
     */
    errors: [number, number, number] | null;
    /**
     * Correlations of X with Y, of X with Z, of Y with Z; absent without statistics.
     */
    correlations?: [number, number, number] | null;
}

/**
 * Printed values.
 */
export interface Paper {
    /**
     * Left and right counts of Table 1: after the operator, after suppression, after matching.
     */
    points: [[number, number], [number, number], [number, number]];
    /**
     * Of the operator.
     */
    threshold: number;
    /**
     * Table 2: standard errors of the proposed method.
     */
    standard_errors: FiveParameters;
    /**
     * Table 3: the orientation by correlation, by least squares matching and by the proposed method (moments).
     */
    orientations: [PrintedOrientation, PrintedOrientation, PrintedOrientation];
    /**
     * Standard error of unit weight in mm, 0.6 of its pixels.
     */
    sigma0_mm: number;
    pixel_mm: number;
}

/**
 * Ready-made settings for tasks that the defaults serve less well.
 */
export type PairPreset = "many-points" | "little-in-common" | "zahran-2007";

/**
 * Residuals of the points of one number of rays.
 */
export interface RayCountRmse {
    /**
     * Accepted rays of each of these points.
     */
    rays: number;
    points: number;
    rmse_px: number;
}

/**
 * Standard deviations of the constants of a camera before its images are measured. They enter the adjustment of a pair or block as prior
 * information: what the images determine is estimated, what they do not determine is counted in the total standard errors. From 0 to 1; in blocks
 * what is below 1e-9 counts as 0.
 */
export interface CameraUncertainty {
    /**
     * Of the focal length, as a share of it.
     */
    focal: number;
    /**
     * Of each coordinate of the principal point, in focal lengths.
     */
    principal_point: number;
    /**
     * Of the first term of the radial distortion, in units of the focal length: the share by which it moves a point at 45°.
     */
    k1: number;
}

/**
 * Steps of edits of a block, and the block that they are carried to.
 */
export interface Carrying {
    /**
     * What was done at once.
     */
    steps: BlockEdit[][];
    /**
     * So many of them, the first, are in force; the others were undone.
     */
    done: number;
    before: EditNames;
    after: EditNames;
    /**
     * Whether both have the same tie points.
     */
    same_tie_points: boolean;
    /**
     * Which places of the orthophoto lie where they lay, by numbers of both.
     */
    again: PlaceAgain[];
}

/**
 * The GNSS position of an image that a table gives.
 */
export interface GivenPosition {
    /**
     * Its height is above the ellipsoid; of one in the coordinate reference system above the zero of that, where it is not known how high this lies.
     */
    position: ExifPosition;
    /**
     * Standard errors of the place and of the height in m, above 0; each is absent where the table has none.
     */
    standard_errors_m: [number | null, number | null];
    /**
     * Whether it was given in the coordinate reference system of the block, whose heights it has.
     */
    in_crs: boolean;
}

/**
 * The angle, or the direction of the base, with the widest interval.
 */
export type KnownWorst = "omega" | "phi" | "kappa" | "base";

/**
 * The camera of one or more images.
 *
 * With x = -U/W, y = V/W of photo = (U, V, W) = M·(X - X₀), so that y goes down as rows do, and r² = x² + y²:
 * col = c_x + f (x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²)), row = c_y + f (y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy).
 *
 * # Source
 * Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.
 */
export interface Camera {
    width_px: number;
    height_px: number;
    /**
     * Principal distance f, 1 to 10,000,000; in mm it is this times the side of a pixel.
     */
    focal_px: number;
    /**
     * Principal point `[c_x, c_y]`; the centre of the top-left pixel is (0.5, 0.5).
     */
    principal_point_px: [number, number];
    /**
     * `[k1, k2, k3]`, without unit.
     */
    radial?: [number, number, number];
    /**
     * `[p1, p2]`, without unit.
     */
    tangential?: [number, number];
    /**
     * Side of a pixel, which formats with photo coordinates need.
     */
    pixel_mm?: number | null;
    /**
     * What an adjustment estimates of it.
     */
    free?: FreeParameters;
}

/**
 * The camera that a file names, by EXIF, XMP and the table of sensors.
 */
export interface ExifCamera {
    make: string | null;
    model: string | null;
    /**
     * Focal length in mm.
     */
    focal_mm: number;
    /**
     * Side of a pixel of the stored image in mm; absent where nothing tells it. The focal length in px is `focal_mm / pixel_mm`.
     */
    pixel_mm: number | null;
    /**
     * Where the focal length in px comes from.
     */
    origin?: CameraOrigin;
    /**
     * What XMP says of the lens, in px of the stored image; absent where that is no more than a focal length.
     */
    lens?: Camera;
    /**
     * What speaks against it.
     */
    cautions?: CameraCaution[];
}

/**
 * The cameras and images of a block with whatever positions were observed.
 */
export interface BlockDescription {
    cameras: KnownCamera[];
    images: KnownImage[];
    control?: GroundControlPoint[];
}

/**
 * The cameras of both photos.
 */
export interface PairCameras {
    left: CameraMm;
    right: CameraMm;
    /**
     * As in [`PairInterior`](super::PairInterior).
     */
    doubt?: Warning;
    /**
     * As in [`PairInterior`](super::PairInterior).
     */
    one_lens: boolean;
    /**
     * As in [`PairInterior`](super::PairInterior).
     */
    are_scans: boolean;
}

/**
 * The constants of a camera.
 */
export interface CameraMm {
    /**
     * Principal distance in mm, above 0 and up to 100,000.
     */
    focal_mm: number;
    /**
     * Principal point `[x, y]` in mm: in the system of the calibrated fiducials, or from the middle of the image, x right, y up.
     */
    principal_point_mm?: [number, number];
    /**
     * Side of a pixel in mm, 0.000001 to 10; needed where there are no fiducials.
     */
    pixel_mm?: number | null;
    /**
     * `[k1, k2, k3]` in mm⁻², mm⁻⁴, mm⁻⁶. What was measured at x, y mm from the principal point, r mm away, is corrected to
     * x · (1 + k1·r² + k2·r⁴ + k3·r⁶) + p1·(r² + 2x²) + 2·p2·x·y and y · (1 + k1·r² + k2·r⁴ + k3·r⁶) + p2·(r² + 2y²) + 2·p1·x·y: a positive k1
     * moves points outwards, against a barrel distortion.
     */
    radial_distortion?: [number, number, number];
    /**
     * `[p1, p2]` in mm⁻¹, of the same correction.
     */
    tangential_distortion?: [number, number];
    /**
     * What is not known of these; absent: nothing where photos have fiducial marks, of digital ones [`CameraUncertainty::GIVEN`].
     */
    uncertainty?: CameraUncertainty;
}

/**
 * The coordinate reference system of the results of a block.
 */
export interface ResultSystem {
    /**
     * As the EPSG registry has it, or the text.
     */
    name: string;
    /**
     * As it was given.
     */
    definition: string;
    /**
     * What the registry calls the operation to WGS 84; absent for what the text states, and where none is needed.
     */
    operation: string | null;
    /**
     * Accuracy of this operation, as the registry states it.
     */
    accuracy_m: number | null;
    /**
     * The height of the zero of its heights above the ellipsoid of WGS 84, in the middle of the block; absent where it is not known.
     */
    geoid_m: number | null;
    /**
     * Name of the file of the geoid from which they count; absent where none was given.
     */
    geoid?: string;
    /**
     * How much higher the GNSS positions are than where the block has them, where their heights took no part.
     */
    gnss_above_m: number | null;
}

/**
 * The coordinate system; standard errors of GNSS positions and control points that state none, of image measurements, and what errors share.
 */
export interface GeoreferencingOptions {
    /**
     * The coordinate reference system of the control points, in which tables give the results, too: an EPSG code (EPSG:25832), PROJ text or WKT. GNSS positions, control points and an orthophoto then georeference the block together.
     */
    crs: string | null;
    /**
     * The height of the zero of the heights of this system above the ellipsoid of WGS 84, as the geoid has it at the block: 0 for ellipsoidal heights. A geoid file gives it at each place.
     * Heights of GNSS positions, which are above the ellipsoid, then take part beside those of control points.
     */
    geoid_m: number | null;
    /**
     * The standard error of east and of north of GNSS positions that state none, some metres, or centimetres where they were corrected:
     * higher gives them less weight.
     */
    receiver_across_m: number;
    /**
     * The standard error of the height of GNSS positions that state none: higher gives it less weight.
     */
    receiver_up_m: number;
    /**
     * The standard error of x and of y of control points that state none: higher gives them less weight.
     */
    surveyed_across_m: number;
    /**
     * The standard error of the height of control points that state none: higher gives it less weight.
     */
    surveyed_up_m: number;
    /**
     * The standard error of a coordinate of an image measurement of a control or check point: higher gives it less weight beside tie points.
     * Measurements beyond five times as much do not fit.
     */
    mark_sigma_px: number;
    /**
     * Whether standard errors of image measurements, GNSS positions and control points are estimated from the residuals, and weights follow
     * them where they differ from what is stated by more than chance.
     */
    variance_components: boolean;
    /**
     * The offset of GNSS positions that is estimated: one of all, or one of each strip of the flight, alone or with a drift that is linear along it.
     * It is kept where it differs from zero by more than chance. Without control points only differences between strips can be told.
     */
    gnss_errors: GnssErrors;
    /**
     * Whether the lever arm of each camera is estimated, from its projection centre to the antenna of GNSS, and kept where it differs from zero by
     * more than chance.
     */
    gnss_lever_arm: boolean;
    /**
     * The standard deviation of errors that the observations of an image share, as matches do, in standard errors of an observation: higher
     * makes the printed standard errors larger. 0: observations are independent.
     */
    shared_errors: number | null;
}

/**
 * The dependent relative orientation of the right photo, with its precision.
 */
export interface RelativeOrientation extends FiveParameters {
    /**
     * The angle by which the photo axes of ω φ κ by bz, the base and the points in the model are turned anticlockwise from those of the
     * photo coordinates: 0, or 90 where [`orient_matches`](crate::orient_matches) met a base across the x axis.
     */
    turn_deg: number;
    /**
     * The base component b that was fixed.
     */
    base_mm: number;
    focal_mm: number;
    method: OrientationMethod;
    /**
     * With σ₀ a priori where that is given and the global test does not contradict it; else with the estimated σ₀, and absent without redundancy.
     */
    standard_errors: FiveParameters | null;
    /**
     * The same with what makes observations depend on each other: the errors of cameras and interior orientations, and what matches
     * share. They are no less than the others; absent where neither is known.
     */
    total_standard_errors: FiveParameters | null;
    /**
     * Half-widths of the intervals in which the unknowns lie with a probability of 95 %: the total standard errors, or the others where these are
     * absent, times the limit of Student's distribution: for the degrees of freedom of σ₀, and of the σ₀ of the fiducial marks as far as their errors
     * count (Welch and Satterthwaite); 1.96 where all are known.
     */
    half_widths_95: FiveParameters | null;
    /**
     * Standard error of one photo coordinate of weight 1 in mm (a y-parallax has √2 of it), from the residuals, made consistent where the
     * rejection has cut their distribution; absent without redundancy.
     */
    sigma0_mm: number | null;
    /**
     * The σ₀ that was known before.
     */
    sigma0_a_priori_mm: number | null;
    /**
     * What the rejection has left of the variance of good observations, 1 without a rejection: σ₀² and the cofactors are those of the accepted
     * observations divided by it. Absent in older projects.
     */
    variance_left?: number;
    /**
     * Present with σ₀ a priori and redundancy.
     */
    global_test: GlobalTest | null;
    degrees_of_freedom: number;
    iterations: number;
    /**
     * Size of the last step relative to a millionth of the standard errors, or to rounding where these are smaller: below 1 it has converged.
     */
    last_step: number;
    /**
     * Cofactors of ω φ κ (radians), by bz (mm) for σ₀ = 1 mm: variances are σ₀² times the diagonal.
     */
    cofactors: [[number, number, number, number, number], [number, number, number, number, number], [number, number, number, number, number], [number, number, number, number, number], [number, number, number, number, number]];
    /**
     * Of ω φ κ by bz, from the inverse of the normal equations.
     */
    correlations: [[number, number, number, number, number], [number, number, number, number, number], [number, number, number, number, number], [number, number, number, number, number], [number, number, number, number, number]];
    /**
     * Largest by smallest eigenvalue of the matrix of correlations: 1 for independent unknowns.
     */
    condition: number;
    /**
     * How far the points deviate from the best projective map of a plane, in standard errors of a coordinate: about 1 over a plane. Absent
     * with fewer than ten points.
     */
    plane_misfit: number | null;
    /**
     * The spread of the points in the left photo: root mean square distance from their middle, in focal lengths.
     */
    spread: number;
    /**
     * Median parallax that the best rotation leaves, in mm: what of the photos' difference only a base explains.
     */
    parallax_beside_rotation_mm: number;
    warnings: Warning[];
    /**
     * Standard error ellipse of by and bz in mm, with what the interior orientations add where that is known.
     */
    base_ellipse_mm: ErrorEllipse | null;
    /**
     * The ellipse in which by and bz both lie with a probability of 95 %.
     */
    base_ellipse_95_mm: ErrorEllipse | null;
    /**
     * δ₀: how many standard errors a residual is shifted by an error that its test finds with the probability β₀. Absent where fewer than two
     * degrees of freedom estimate σ₀, by which none is found.
     */
    noncentrality: number | null;
    /**
     * Corrections `[vx_left, vy_left, vx_right, vy_right]` in mm of every observation, the rejected ones included.
     */
    residuals_mm: Float64Array;
    /**
     * One for each observation.
     */
    points: Float64Array;
    /**
     * Indices of the observations that were left out as gross errors.
     */
    rejected: number[];
    /**
     * The left and the right camera where they are not known without error, in the photo axes of ω φ κ by bz; absent where both are.
     */
    cameras?: [EstimatedCamera, EstimatedCamera];
}

/**
 * The exterior orientation of an image.
 */
export interface Pose {
    /**
     * Rows of M, from object to photo, x right, y up, against the view: photo = M·(X - X₀).
     */
    rotation: [[number, number, number], [number, number, number], [number, number, number]];
    /**
     * Projection centre X₀, in m where the object space has a scale.
     */
    position: [number, number, number];
}

/**
 * The figures of a finished block.
 */
export interface Summary {
    verdict: WithText<BlockVerdict>;
    images: ImageCounts;
    /**
     * What of the input was not taken as it was given, or is hardly right.
     */
    remarks: WithText<Remark>[];
    cameras: CameraSummary[];
    pairs: PairCounts;
    /**
     * The names of the images that are connected with each other, the largest group first.
     */
    groups: string[][];
    /**
     * Absent where an older project file does not say.
     */
    points: TiePointCounts | null;
    selection: SelectionCounts;
    /**
     * Absent where observations are not refined.
     */
    refinement: RefinementCounts | null;
    orientation: OrientationSummary;
    /**
     * The coordinate reference system of images.csv, points.csv and surveyed.csv; absent where it is that of the adjustment.
     */
    crs?: ResultSystem;
    /**
     * What came of the orthophoto that the block was given; absent where it was given none.
     */
    orthophoto?: WithText<OnOrthophoto>;
    /**
     * Changes by hand.
     */
    edits: number;
    exports: ExportOutcome[];
    settings: BlockSettings;
    /**
     * How near a simulated block is to its truth.
     */
    score?: BlockScore;
}

/**
 * The geometry of two views: [`two_view`](crate::two_view).
 */
export interface TwoView {
    model: TwoViewModel;
    /**
     * The matches that agree with the model, in ascending order; left out where all given ones do.
     */
    inliers?: number[];
    /**
     * The largest distance of these from the model, in px.
     */
    threshold_px: number;
    /**
     * Standard error of a coordinate of these, in px.
     */
    sigma_px: number;
    degenerate: Degeneracy | null;
    /**
     * Of a plane or a rotation the map from the left to the right image, in px.
     */
    homography: [[number, number, number], [number, number, number], [number, number, number]] | null;
    focal: FocalEstimate | null;
}

/**
 * The interior orientation of one image: from its pixels to photo coordinates.
 */
export interface Interior {
    /**
     * `[[a, b, tx], [d, e, ty]]`: x = a·col + b·row + tx, y = d·col + e·row + ty in mm, before the principal point is taken off;
     * col and row of this image in px, the centre of its top-left pixel at (0.5, 0.5).
     */
    parameters: [[number, number, number], [number, number, number]];
    /**
     * Principal point `[x, y]` in mm, in the same system.
     */
    principal_point_mm: [number, number];
    /**
     * `[k1, k2, k3]` in mm⁻², mm⁻⁴, mm⁻⁶, of the correction that `CameraMm` says.
     */
    radial_distortion: [number, number, number];
    /**
     * `[p1, p2]` in mm⁻¹.
     */
    tangential_distortion?: [number, number];
    /**
     * Covariance of the three parameters of a row, the same for both rows, which are independent; absent where it is not known.
     */
    covariance?: [[number, number, number], [number, number, number], [number, number, number]] | null;
    /**
     * Degrees of freedom of the σ₀ by which the covariance is; absent where that is known.
     */
    degrees_of_freedom?: number;
    /**
     * What is not known of the camera; absent: nothing.
     */
    uncertainty?: CameraUncertainty;
}

/**
 * The interior orientation that the marks give.
 */
export interface FiducialOrientation {
    model: FiducialModel;
    /**
     * `[[a, b, tx], [d, e, ty]]`: x_mm = a·col + b·row + tx, y_mm = d·col + e·row + ty.
     */
    parameters: [[number, number, number], [number, number, number]];
    /**
     * Transformed minus calibrated `[x, y]` of each mark in mm.
     */
    residuals_mm: [number, number][];
    /**
     * Standard error of one photo coordinate in mm; absent without redundancy.
     */
    sigma0_mm: number | null;
    degrees_of_freedom: number;
    /**
     * Standard errors of `parameters`; absent without redundancy.
     */
    standard_errors: [[number, number, number], [number, number, number]] | null;
    /**
     * Half the widths of their intervals of 95 %, by Student's distribution; absent without redundancy.
     */
    half_widths_95?: [[number, number, number], [number, number, number]] | null;
    /**
     * Covariance of the three parameters of a row, the same for both rows, which are independent; absent without redundancy and for a
     * similarity, whose rows are not independent.
     */
    covariance: [[number, number, number], [number, number, number], [number, number, number]] | null;
}

/**
 * The interior orientations of a pair, of one focal length.
 */
export interface PairInterior {
    left: Interior;
    right: Interior;
    focal_mm: number;
    /**
     * What speaks against the focal lengths before anything is matched.
     */
    doubt?: Warning;
    /**
     * Whether both photos are known to be of one lens at one focal length, however their images are turned or resized.
     */
    one_lens?: boolean;
    /**
     * Whether fiducial marks were measured in both: then they are two photographs, however alike.
     */
    are_scans?: boolean;
}

/**
 * The known direction of a camera axis.
 */
export interface AxisPrior {
    /**
     * Against the direction of view, of length 1: (0, 0, 1) looks down.
     */
    direction: [number, number, number];
    /**
     * Standard error across it in degrees.
     */
    sigma_deg: number;
}

/**
 * The measured position of a point in one image.
 */
export interface BlockObservation {
    /**
     * Index of the image.
     */
    image: number;
    /**
     * Index of the point.
     */
    point: number;
    /**
     * Column in px; the centre of the top-left pixel is 0.5.
     */
    x_px: number;
    /**
     * Row in px; the centre of the top-left pixel is 0.5.
     */
    y_px: number;
    /**
     * Above 0; the variance of both coordinates is σ₀² / weight.
     */
    weight?: number;
    /**
     * Standard error of both coordinates in px, above 0, where it is known beside that of the other rays: the weight follows from it and σ₀.
     */
    sigma_px?: number;
}

/**
 * The measured position of a point in one image.
 */
export interface ImageObservation {
    /**
     * Index of the image.
     */
    image: number;
    /**
     * Measured column and row in px; the centre of the top-left pixel is (0.5, 0.5).
     */
    x_px: number;
    y_px: number;
    /**
     * Probability, 0..1, that it belongs to its point.
     */
    confidence?: number;
}

/**
 * The model that is written.
 */
export interface SelectionCounts {
    points: number;
    rays: number;
    /**
     * Of the oriented images, or of all where none is.
     */
    least_rays_of_an_image: number;
    least_places_of_an_image: number;
}

/**
 * The models of a block, the one with most images first, and the images that are in none.
 */
export interface Reconstruction {
    models: ReconstructedModel[];
    unoriented: UnorientedImage[];
    /**
     * Where (0, 0, 0) of the models that lie in the system of geographic positions is.
     */
    origin: GeographicOrigin | null;
}

/**
 * The observation of a point in an image.
 */
export interface PointImage {
    point: PointSource;
    image: number;
}

/**
 * The options of all stages.
 */
export interface PairSettings {
    points: PointOptions;
    /**
     * Of the operator of that name.
     */
    multiscale: MultiscaleOptions;
    window: WindowOptions;
    /**
     * Of the strategy of that name.
     */
    gradient: GradientOptions;
    matching: MatchOptions;
    /**
     * The geometry of the two views, by which the strategy gradient verifies its matches. Cameras that the pair knows take the place of
     * those named here.
     */
    geometry: TwoViewOptions;
    orientation: OrientationOptions;
}

/**
 * The orientation of a block that has one.
 */
export interface Oriented {
    oriented: number;
    points: number;
    rays: number;
    models: ModelSummary[];
    cameras: Camera[];
    unoriented: NotOriented[];
    origin: GeographicOrigin | null;
}

/**
 * The orientation of a block.
 */
export type OrientationSummary = { oriented: number; reason: WithText<Failure> } | Oriented;

/**
 * The orientation of an image in the system of an orthophoto.
 *
 * Standard errors count what the links, the height model and the camera do not tell; an error that all places of the orthophoto share is in
 * none of them.
 */
export interface Placement {
    /**
     * Of the image; of a scan of film that of its frame.
     */
    camera: Camera;
    /**
     * Of f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂; absent for what was not estimated.
     */
    camera_errors: [number | null, number | null, number | null, number | null, number | null, number | null, number | null, number | null];
    pose: Pose;
    /**
     * ω, φ, κ.
     */
    angles_deg: [number, number, number];
    angle_errors_deg: [number, number, number] | null;
    position_errors_m: [number, number, number] | null;
    above_ground_m: number;
    /**
     * Side of a pixel on the ground, in the mean of the image.
     */
    gsd_m: number;
    /**
     * Where the border of the image meets level ground, from its top-left corner on to the right.
     */
    footprint: [number, number][];
    /**
     * Standard error of a coordinate of the image whose place is known as well as those of all links in the mean.
     */
    sigma0_px: number | null;
    rmse_px: number;
    degrees_of_freedom: number;
    /**
     * Share of the cells of the image that hold a link.
     */
    coverage: number;
    links: Link[];
    checks: LinkChecks | null;
    /**
     * What the image says of the heights.
     */
    relief?: Relief;
    /**
     * How a scan of film lies to its frame: positions and residuals of links are those of the scan. Absent where the image is of a camera without film.
     */
    film?: FilmScan;
}

/**
 * The parameters of a camera that an adjustment estimates, where the block determines them; the others stay as they are given.
 */
export interface FreeParameters {
    focal?: boolean;
    principal_point?: boolean;
    /**
     * How many of k1, k2, k3, from the first on: 0 to 3.
     */
    radial?: number;
    tangential?: boolean;
}

/**
 * The part of a geoid about a block: how high it lies above the ellipsoid at the nodes of a grid, between which it is interpolated in both directions.
 */
export interface Geoid {
    /**
     * Of the file that it is from.
     */
    name: string;
    /**
     * Longitude and latitude of the first node in degrees.
     */
    south_west_deg: [number, number];
    /**
     * From a node to the next one east and north of it.
     */
    step_deg: [number, number];
    /**
     * Of a row: two or more.
     */
    columns: number;
    /**
     * Row by row from the south, each from the west; two rows or more.
     */
    heights_m: number[];
}

/**
 * The parts of a run, in their order.
 */
export type StageName = "images" | "geoid" | "likeness" | "pairs" | "points" | "windows" | "refinement" | "orientation";

/**
 * The place of (0, 0, 0) of an object space whose x goes east, y north and z up, all in m.
 */
export interface GeographicOrigin {
    /**
     * WGS 84.
     */
    longitude_deg: number;
    latitude_deg: number;
    /**
     * Above the ellipsoid.
     */
    height_m: number;
}

/**
 * The points that two images have in common.
 */
export interface SharedPoints {
    /**
     * In ascending order.
     */
    images: [number, number];
    points: number;
}

/**
 * The position of an image as a table has it.
 */
export interface ImagePositionRow {
    /**
     * The image as the table names it: its file name, perhaps with a folder or without its ending.
     */
    image: string;
    /**
     * Longitude and latitude in degrees, or x and y in the unit of the coordinate reference system.
     */
    place: [number, number];
    /**
     * Absent where the table has none.
     */
    height: number | null;
    /**
     * Standard errors of the place and of the height in m, above 0; each is absent where the table has none.
     */
    standard_errors: [number | null, number | null];
    /**
     * The line of the table, counted from 1.
     */
    line: number;
}

/**
 * The positions of images that a table has.
 */
export interface ImagePositions {
    /**
     * Whether places are longitude and latitude of WGS 84 in degrees, with heights above the ellipsoid; else they are x and y of a coordinate reference system.
     */
    is_geographic: boolean;
    rows: ImagePositionRow[];
}

/**
 * The published interest operators, and points of many scales.
 */
export type Operator = "ground2" | "ground1" | "forstner" | "moravec" | "multiscale";

/**
 * The rule that decided on a left point.
 */
export type Rule = "matched" | "no_descriptor" | "no_candidate" | "threshold" | "ambiguous" | "many_to_one" | "parallax" | "border" | "left_right" | "not_converged" | "imprecise" | "frame";

/**
 * The similarity that takes positions of the left image to those of the right one.
 */
export interface PhotoDifference {
    /**
     * By how much the right photo is turned in its plane, as κ is.
     */
    turn_deg: number;
    /**
     * How many px of the right image one of the left image has.
     */
    scale: number;
    /**
     * Right minus left position in px, in the middle of what both show.
     */
    offset_px: [number, number];
    /**
     * That middle in the left image.
     */
    middle_px: [number, number];
}

/**
 * The standard error ellipse of two unknowns.
 */
export interface ErrorEllipse {
    semi_major: number;
    semi_minor: number;
    /**
     * Of the long axis, from the first unknown's axis towards that of the second, -90 to 90.
     */
    bearing_deg: number;
}

/**
 * The surveyed points of a block as far as edits of places of an orthophoto name them.
 */
export interface BlockPlaces {
    /**
     * The names of the images, by their indices.
     */
    images: string[];
    /**
     * How many tie points were joined, and their observations; absent where an older project file does not say.
     */
    tie_points: [number, number] | null;
    /**
     * How many surveyed points were given: the first ones.
     */
    given: number;
    /**
     * The system of their coordinates: that which was chosen for the block, else `EPSG:` and the code of the orthophoto; absent where none is known.
     */
    system?: string;
    /**
     * Those that were found on the orthophoto, behind them; one that is not in the block is seen nowhere.
     */
    places: SeenPlace[];
}

/**
 * The systematic errors of GNSS positions that were to be estimated.
 */
export interface SystematicResult {
    /**
     * The strips whose errors were to be estimated. Images that follow no line are in none.
     */
    strips: Strip[];
    errors: SystematicStatistics[];
    /**
     * Motions of the whole block that nothing tells from all of these errors together: those that are estimated are relative to each other, or to those
     * that were fixed at zero.
     */
    constraints: number;
    /**
     * Images in no strip whose positions therefore take no part: errors of strips say nothing of theirs.
     */
    left_out?: number[];
}

/**
 * The test whether σ₀ agrees with the one that was known before.
 */
export interface GlobalTest {
    /**
     * Degrees of freedom times σ₀² / σ₀² a priori: follows χ².
     */
    statistic: number;
    /**
     * Between these it lies in 95 of 100 adjustments.
     */
    lower: number;
    upper: number;
    passed: boolean;
}

/**
 * The texts of files beside a raster, which say what it does not say itself.
 */
export interface Sidecars {
    /**
     * Of a world file: where its pixels lie.
     */
    world_file?: string | null;
    /**
     * Of a file `.prj`: its coordinate reference system as WKT.
     */
    projection?: string | null;
}

/**
 * The transformation from pixels to photo coordinates.
 */
export type FiducialModel = "affine" | "similarity";

/**
 * The way from pixels to the ground and back: (X, Y) = origin + x · `by_column` + y · `by_row` of a position (x, y) in px, the centre of
 * the top-left pixel at (0.5, 0.5).
 */
export interface Georeference {
    /**
     * The top-left corner of the top-left pixel, in units of the map.
     */
    origin: [number, number];
    /**
     * One px to the right.
     */
    by_column: [number, number];
    /**
     * One px down.
     */
    by_row: [number, number];
}

/**
 * The window's outline.
 */
export type WindowShape = "square" | "circle";

/**
 * Tie points and their observations.
 */
export interface FoundPoints {
    points: number;
    rays: number;
}

/**
 * Tie points before some are chosen.
 */
export interface TiePointCounts {
    found: number;
    rays: number;
    /**
     * How many points have so many rays.
     */
    with_rays: Record<number, number>;
    joining: JoinCounts;
}

/**
 * Units of length that are taken for metres.
 */
export type LengthUnit = "millimetres" | "centimetres" | "inches" | "feet" | "kilometres";

/**
 * What EXIF and XMP of an image tell beside its pixels; what they do not tell is absent.
 */
export interface ExifImage {
    /**
     * Also where the focal length is not told.
     */
    make: string | null;
    model: string | null;
    camera: ExifCamera | null;
    /**
     * How the stored image is turned for display, 1..8 as the standard counts: 1 not at all, 3 half round, 6 a quarter to the right, 8 a
     * quarter to the left, the others mirrored too. Positions in px are always those of the stored image.
     */
    orientation: number | null;
    position: ExifPosition | null;
    /**
     * What of the recorded position cannot be and was left out, with its value: all of it, or the height alone.
     */
    impossible?: string;
    /**
     * Of the drone that took it; absent where it recorded nothing.
     */
    drone?: DroneRecord;
}

/**
 * What a drone recorded of itself and its camera.
 */
export interface DroneRecord {
    /**
     * Of the gimbal that carries the camera: a pitch of -90° looks down.
     */
    gimbal: Attitude | null;
    /**
     * Of the aircraft: a pitch of 0° is level.
     */
    aircraft: Attitude | null;
    /**
     * Of the camera, as Pix4D defines it: a pitch of 0° looks down.
     */
    camera: Attitude | null;
    /**
     * Above the place of take-off.
     */
    relative_height_m: number | null;
    /**
     * Above the ellipsoid or the sea: makers do not agree.
     */
    absolute_height_m: number | null;
    rtk: RtkSolution | null;
}

/**
 * What a finished block is worth.
 */
export type BlockVerdict = { kind: "oriented"; oriented: number; images: number; points: number; sigma0_px: number | null } | { kind: "weak"; oriented: number; images: number; points: number; overview_warning: OverviewWarning } | { kind: "not_oriented"; connected: number; failure: Failure | null };

/**
 * What a given link is for.
 */
export type GivenUse = "used" | "check" | "rejected";

/**
 * What a link is for.
 */
export type LinkUse = "used" | "rejected" | "check";

/**
 * What a point of an adjusted block is.
 */
export type PointSource = { tie_point: number } | { ground_control: number } | { manual: number };

/**
 * What a project file holds.
 */
export type ProjectKind = "block" | "pair";

/**
 * What a ray of an adjusted block is.
 */
export interface ObservationSource {
    /**
     * Index of the feature in its image; absent for a ray to a surveyed point.
     */
    feature: number | null;
    /**
     * Probability, 0..1, that it belongs to its point, as the matches have it.
     */
    confidence: number;
    /**
     * Whether it was measured by hand.
     */
    by_hand?: boolean;
}

/**
 * What a run finds on its way.
 */
export type News = ({ kind: "step" } & Step) | ({ kind: "image" } & ReadImage) | { kind: "skipped"; name: string; reason: string } | { kind: "pair"; connection: Connection; geometry: TwoView | null };

/**
 * What became of a control point that a test refuses.
 */
export interface RefusedControl {
    /**
     * The coordinate whose test is largest; absent where nothing tests them, or they are right within chance and the block is not placed with the point.
     */
    axis: Axis | null;
    /**
     * Whether it takes part all the same, since too little is left without it to tell whether it is wrong.
     */
    is_used: boolean;
}

/**
 * What became of a ray.
 */
export type RefinementOutcome = "reference" | "refined" | "not_converged" | "left_image" | "moved_too_far" | "low_correlation" | "no_texture" | "inconsistent";

/**
 * What became of a systematic error.
 */
export type SystematicVerdict = "kept" | "not_significant" | "undetermined";

/**
 * What became of an observation.
 */
export interface RefinedObservation {
    /**
     * Index of the image.
     */
    image: number;
    /**
     * Where it is now, in px.
     */
    position_px: [number, number];
    outcome: RefinementOutcome;
    /**
     * Relative to the observation to which it was matched, in px; absent, as the correlation, where it was not refined.
     */
    standard_error_px: number | null;
    /**
     * Of the matched windows, -1..1.
     */
    correlation: number | null;
}

/**
 * What became of the matches.
 */
export interface JoinCounts {
    matches: number;
    /**
     * Too improbable to join anything.
     */
    cut_as_improbable: number;
    /**
     * Cut because they would have given a point two rays in one image.
     */
    cut_as_conflict: number;
    /**
     * Points of too few rays, and points in conflict where these are dropped.
     */
    dropped_points: number;
    dropped_rays: number;
    reliability: MatchReliability;
}

/**
 * What became of the observations that were refined, those of each point one after the other.
 */
export interface RefinementTable {
    /**
     * The observations of point i are those from `starts[i]` to before `starts[i + 1]`.
     */
    starts: number[];
    observations: RefinedObservation[];
}

/**
 * What became of the observations that were refined.
 */
export interface RefinementCounts {
    method: RefinementMethod;
    points: number;
    rays: number;
    references: number;
    refined: number;
    /**
     * Those that keep their positions, by the reason.
     */
    kept: Record<Exclude<RefinementOutcome, "reference" | "refined">, number>;
}

/**
 * What came of joining the matches of all pairs.
 */
export interface JoinedPoints {
    join: JoinCounts;
    count: number;
    /**
     * Observations of all points.
     */
    rays: number;
    /**
     * How many points have 0, 1, 2, … rays.
     */
    histogram: number[];
    /**
     * The points that each two images have in common.
     */
    shared: SharedPoints[];
}

/**
 * What came of matching a pair.
 */
export type PairOutcome = { kind: "waiting" } | { kind: "connected"; matches: number } | { kind: "too_few_matches"; matches: number; needed: number } | { kind: "not_oriented"; no_geometry: NoGeometry } | { kind: "failed"; failure: Failure };

/**
 * What came of the orthophoto that a block was given.
 */
export type OnOrthophoto = { kind: "linked"; linked: number; images: number; points: number; checks: number; rejected: number; in_crs?: boolean; epsg?: number } | { kind: "by_hand"; linked: number; images: number; points: number; in_crs?: boolean; epsg?: number } | { kind: "not_linked"; not_linked: NotLinked };

/**
 * What check points say of a model: differences, adjusted minus surveyed, as `surveyed.csv` has them: in m on the ground along the axes of the coordinate
 * reference system of the results, where one was chosen, and otherwise along those of the adjustment.
 */
export interface CheckSummary {
    points: number;
    /**
     * Root mean squares of x, y, z.
     */
    rmse_m: [number, number, number];
    /**
     * Root mean squares of the length of x and y, and of the height.
     */
    plan_rmse_m: number;
    height_rmse_m: number;
    mean_m: [number, number, number];
    /**
     * Root mean square of the differences by their predicted standard errors: about 1 where these hold; absent without statistics.
     */
    ratio: number | null;
}

/**
 * What edits of a block name by numbers.
 */
export interface EditNames {
    /**
     * The names of the images, by their indices.
     */
    images: string[];
    /**
     * Surveyed points by their numbers, with their names.
     */
    surveyed: [number, string][];
    /**
     * The pairs that matches connect.
     */
    connected: [number, number][];
    /**
     * How many surveyed points the block was found with, the first ones: those that edits add are numbered behind them.
     */
    found: number;
    /**
     * The system of their coordinates; absent where none is known.
     */
    system?: string | null;
}

/**
 * What holds a block where it lies.
 */
export type ControlKind = "surveyed" | "places" | "both";

/**
 * What is computed.
 */
export type Computation = "affine_transformation" | "bundle_adjustment" | "by_and_bz" | "datum" | "determinant_form" | "distortion_correction" | "free_network" | "fundamental_matrix" | "homography" | "omega_and_kappa" | "relative_orientation" | "two_view_geometry";

/**
 * What is done to the matches of any strategy.
 */
export type Refinement = "none" | "least-squares" | "where-possible";

/**
 * What is done with matches that would give a point two observations in one image.
 */
export type Conflicts = "resolve" | "drop";

/**
 * What is flown, seen and matched.
 */
export interface BlockFlight {
    /**
     * Straight down; one camera down and four tilted by 45°; or straight down with every other strip at 1.5 times the height.
     */
    view: BlockView;
    /**
     * The number of strips that are flown side by side.
     */
    strips: number;
    /**
     * The number of exposures per strip, each by one camera, or by five in an oblique block.
     */
    exposures: number;
    /**
     * The overlap of photos that follow one another in a strip.
     */
    forward_overlap: number;
    /**
     * The overlap of neighbouring strips.
     */
    side_overlap: number;
    /**
     * The columns of a photo, across the flight.
     */
    width_px: number;
    /**
     * The rows of a photo, along the flight.
     */
    height_px: number;
    /**
     * The side of a pixel, with principal distances of 85 mm and 65 mm: larger pixels show more ground.
     */
    pixel_mm: number;
    /**
     * The height above the mean ground: a larger one makes the scale smaller.
     */
    flying_height_m: number;
    /**
     * The range of the ground's heights.
     */
    relief_m: number;
    /**
     * The standard deviation of a coordinate of a GNSS position.
     */
    receiver_m: number;
    /**
     * The buildings of a photographed scene; fewer stand where there are fewer lots.
     */
    buildings: number;
    /**
     * The trees of a photographed scene, where gardens are left for them.
     */
    trees: number;
    /**
     * Everything random follows from it: the same seed gives the same block.
     */
    seed: number;
    /**
     * The number of features per image, on average.
     */
    features: number;
    /**
     * The share of the features that no other image shows.
     */
    clutter: number;
    /**
     * The probability that a feature which two images show is matched between them.
     */
    matched: number;
    /**
     * The share of the matches that join different places.
     */
    wrong: number;
    /**
     * The share of the wrong matches that join the same two places in every pair of images.
     */
    repeated: number;
    /**
     * The standard deviation of a feature's coordinate.
     */
    noise_px: number;
    /**
     * The ground points in the area of one image.
     */
    points_per_image: number;
    /**
     * The share of the observations that are gross errors.
     */
    gross_share: number;
    /**
     * The largest gross error in each coordinate.
     */
    gross_px: number;
    /**
     * The number of control points, spread over the block.
     */
    control_points: number;
    /**
     * The standard deviation of a coordinate of a control point.
     */
    control_sigma_m: number;
    /**
     * The standard deviation of the approximate positions of images and points, up to a fifth of the flying height; angles err by as much
     * at the distance of the ground.
     */
    approximate_m: number;
    /**
     * Distortion of all cameras of a network.
     */
    radial: [number, number, number];
    tangential: [number, number];
}

/**
 * What is known of a pair beside its grey values.
 */
export interface PairInput {
    /**
     * The camera of both images; absent: that of their EXIF.
     */
    camera: CameraMm | null;
    left: PhotoInput;
    right: PhotoInput;
    /**
     * Right minus left position `[dx, dy]` in px; absent: estimated.
     */
    offset: [number, number] | null;
}

/**
 * What is known of one image of a pair.
 */
export interface PhotoInput {
    /**
     * Measured fiducial marks; none for a digital camera.
     */
    fiducials: Fiducial[];
    model: FiducialModel;
    /**
     * Place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured.
     */
    origin: [number, number] | null;
}

/**
 * What is known of the parameters of a camera beforehand. A parameter that is not free keeps the value that the block has.
 */
export interface CameraPrior {
    /**
     * Index of the camera.
     */
    camera: number;
    /**
     * f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂.
     */
    values: [number, number, number, number, number, number, number, number];
    /**
     * Standard errors of these, above 0; absent for what is not known: its place in `values` means nothing.
     */
    sigma: [number | null, number | null, number | null, number | null, number | null, number | null, number | null, number | null];
}

/**
 * What is known of the scan of a photo on film.
 */
export interface FilmInput {
    /**
     * The calibrated camera: its focal length, and where they are known principal point and distortion, in the system of the calibrated marks.
     */
    camera: CameraMm | null;
    /**
     * The fiducial marks that were measured in the scan.
     */
    scan: PhotoInput;
    /**
     * All marks of the film as they are calibrated, x and y in mm, those that no one measured included: they say where the photograph ends. Empty: those
     * that were measured.
     */
    marks_mm?: [number, number][];
}

/**
 * What is left of steps in another block.
 */
export interface CarriedSteps {
    steps: BlockEdit[][];
    /**
     * Of none of the former steps, of the first, of the first two and so on so many are left.
     */
    left: number[];
    /**
     * So many edits that were in force do not hold there.
     */
    lost: number;
    /**
     * What edits in force do to so many places of the orthophoto, or to observations of them, holds.
     */
    places_held: number;
    /**
     * Of so many something does not.
     */
    places_lost: number;
    /**
     * Of the edits that are lost so many are for these.
     */
    lost_for_places: number;
    /**
     * Former steps, by their indices, that were undone and cannot be done again there.
     */
    aside: number[];
}

/**
 * What is minimised.
 */
export type OrientationMethod = "rigorous" | "determinant";

/**
 * What is shown of a finished block, but for its points: [`PointColumns`].
 */
export interface BlockOverview {
    verdict: WithText<BlockVerdict>;
    images: ImageRow[];
    skipped: NamedReason[];
    /**
     * Masks that belong to no image.
     */
    unused_masks: string[];
    /**
     * Images that image measurements name and that are not in the block.
     */
    unknown_images: string[];
    /**
     * What of the input was not taken as it was given, or is hardly right.
     */
    remarks: WithText<Remark>[];
    cameras: CameraRow[];
    pairs: PairRow[];
    /**
     * Images that are connected with each other, the largest group first.
     */
    groups: number[][];
    /**
     * Tie points before some were chosen; absent where an older project file does not say.
     */
    found: FoundPoints | null;
    /**
     * How many observations had each outcome; absent where none were refined.
     */
    refinement: Record<RefinementOutcome, number> | null;
    /**
     * Of the points of the model that is written, by their number of rays.
     */
    by_rays: RayCount[];
    /**
     * Oriented images.
     */
    oriented: number;
    /**
     * Root mean square length of the residuals of all observations in px; absent before the adjustment.
     */
    rmse_px: number | null;
    sigma0_px: number | null;
    /**
     * How large errors are beside the stated standard errors, by the residuals; empty where none are stated.
     */
    components: VarianceComponent[];
    /**
     * In the system of the results; absent without check points.
     */
    checks: CheckSummary | null;
    /**
     * The surveyed points of the model that is written.
     */
    surveyed: SurveyedPoint[];
    /**
     * How many surveyed points the block was found with: edits count those that they add from there on.
     */
    given_control: number;
    /**
     * Where its system touches the earth; absent where that is not known.
     */
    origin: GeographicOrigin | null;
    /**
     * The coordinate reference system that was chosen for control points and results, as it was given.
     */
    crs: string | null;
    /**
     * The height of the zero of its heights above the ellipsoid of WGS 84, in the middle of the block; absent where it is not known.
     */
    geoid_m: number | null;
    /**
     * The part about the block of the geoid from which they count; absent where none was given.
     */
    geoid: Geoid | null;
    /**
     * Changes by hand.
     */
    edits: number;
    /**
     * What is weak about the block.
     */
    warnings: WithText<OverviewWarning>[];
}

/**
 * What is weak about a block at a glance.
 */
export type OverviewWarning = { kind: "model"; block_warning: BlockWarning } | { kind: "few_oriented"; oriented: number; images: number } | { kind: "apart"; images: number } | { kind: "none_oriented" } | { kind: "few_matches"; matches: number; least: number } | { kind: "no_points" } | { kind: "focal_apart"; label: string; estimated_px: number; prior_px: number; apart: number } | { kind: "not_on_orthophoto"; not_linked: NotLinked } | { kind: "doubtful_camera"; remark: Remark } | { kind: "failed"; failure: Failure };

/**
 * What is weak about a model.
 */
export type BlockWarning = { kind: "free"; cause: Cause | null; without_heights?: number } | { kind: "unknown_rotation"; observed: Observed; tilt_deg: number | null } | { kind: "uncertain_rotation"; observed: Observed; error_deg: number; tilt_deg: number | null } | { kind: "looking_up"; observed: Observed; tilt_deg: number } | { kind: "levelled"; recorded: boolean; error_deg: number | null; level_deg: number } | { kind: "no_heights" } | { kind: "positions_rejected"; images: RejectedPosition[] } | { kind: "positions_apart"; axis: Axis; difference_m: number; times: number; images_m?: number | null; focal?: boolean; control?: boolean; held_by?: ControlKind } | { kind: "positions_elsewhere"; images: number; distance_km: number; place_slip: PlaceSlip | null; in_crs?: boolean } | { kind: "imprecise"; sigma0_px: number; most_px: number } | { kind: "weights_not_converged"; rounds: number } | { kind: "position_errors_undetermined"; errors: number } | { kind: "position_errors_relative"; motions: number } | { kind: "control_refused"; point: string; axis: Axis; difference_m: number; error_m: number; detectable_m: number | null; used: boolean; certain?: boolean; mistake: Mistake | null } | { kind: "control_untested"; point: string; measurements: number } | { kind: "control_unplaced"; point: string; measurements: number } | { kind: "control_contradicts"; refused: number; points: number; w?: number | null } | { kind: "control_tests_stopped"; left_out: number; points: number } | { kind: "control_unadjusted"; names: string[] } | { kind: "control_lost"; lost: number; points: number; from_bottom: boolean; control_apart?: ControlApart | null } | { kind: "control_without_place"; given: number; measured: number; taken: number } | { kind: "control_shape"; names: string[]; ratio: number; longest: string; shortest: string; point: string | null } | { kind: "few_control"; points: number; positions?: number; detectable_m: number | null } | { kind: "control_span"; points: number; span_percent: number } | { kind: "control_on_line"; points: number; width_percent: number; error_deg: number | null } | { kind: "scale"; ratio: number; unit: LengthUnit | null } | { kind: "degrees" } | { kind: "point_rejected"; point: string; measurements: number; check?: boolean } | { kind: "measurements_rejected"; point: string; measurements: number; images: string[]; check?: boolean } | { kind: "check_refused"; point: string; axis: Axis; difference_m: number; error_m: number; mistake: Mistake | null } | { kind: "checks_apart"; axis: Axis; points: number; difference_m: number; error_m: number } | { kind: "stated_errors"; observed: Observed; columns: string[]; stated: number; residual_m: number | null; unit: LengthUnit } | { kind: "control_elsewhere"; points: number; images: string[]; check: boolean } | { kind: "focal_estimated"; camera: NamedCamera; error_px: number } | { kind: "focal_undetermined"; camera: NamedCamera } | { kind: "focal_of_ground"; camera: NamedCamera; images_px: number; images_error_px: number; images_unit_px?: number; ground_px: number; ground_error_px: number } | { kind: "orthophoto_apart"; images: number; plan_m: number; usual_m: number } | { kind: "orthophoto_heights_apart"; images: number; height_m: number; usual_m: number } | { kind: "orthophoto_heights_scatter"; checks: number; scatter_m: number; stated_m: number } | { kind: "parameter_fixed"; camera: NamedCamera; camera_parameter: CameraParameter } | { kind: "few_observations"; images: string[]; least: number } | { kind: "two_rays"; two: number; points: number } | { kind: "many_rejected"; rejected: number; observations: number };

/**
 * What makes an orientation weak although it could be computed.
 */
export type Warning = { kind: "plane"; ratio: number; least: number } | { kind: "clustered"; coverage: number; least: number } | { kind: "rotation"; parallax_deg: number; least_deg: number } | { kind: "ill_conditioned"; condition: number; most: number } | { kind: "unchecked"; observations: number } | { kind: "identical"; copies: number; rejected?: number } | { kind: "behind"; points: number } | { kind: "sigma"; estimated_um: number; given_um: number } | { kind: "focal_length"; change_percent: number; w: number } | { kind: "unchecked_focal"; ratio: number; least: number } | { kind: "doubtful_base"; base_mm: number; times: number; most: number } | { kind: "few_places"; places: number; least: number } | { kind: "few_matches"; matches: number; least: number } | { kind: "few_agree"; accepted: number; matches: number } | { kind: "mirrored" } | { kind: "mirrored_marks"; side: Side } | { kind: "unknown_camera" } | { kind: "contradicted_focal"; side: Side; given_px: number; file_px: number } | { kind: "doubtful_focal"; side: Side; sides: number; least: number; most: number } | { kind: "far_principal_point"; side: Side; sides: number; most: number } | { kind: "doubtful_distortion"; side: Side; factor: number; least: number; most: number } | { kind: "resized_or_cropped"; side: Side; taken_width_px: number; taken_height_px: number; width_px: number; height_px: number } | { kind: "cropped"; side: Side; taken_width_px: number; taken_height_px: number; width_px: number; height_px: number } | { kind: "other_pixels"; side: Side; pixel_um: number; expected_um: number } | { kind: "unused_pixel"; pixel_mm: number; marks_mm: number } | { kind: "similarity_alone" } | { kind: "exact"; sigma0_px: number; least_px: number } | { kind: "wide_angle"; coverage: number; most: number } | { kind: "uncertain"; half_width_deg: number; most_deg: number } | { kind: "uncertain_base"; half_width_deg: number; most_deg: number } | { kind: "imprecise"; sigma0_px: number; most_px: number } | { kind: "coarse"; sigma0_um: number; most_um: number };

/**
 * What may change from round to round of an adjustment.
 */
export type Unsettled = "gross_errors" | "positions" | "weights";

/**
 * What of a photo tells its camera, before its interior orientation.
 */
export interface PhotoFacts {
    /**
     * Of its image.
     */
    width_px: number;
    height_px: number;
    exif: ExifCamera | null;
    /**
     * Whether fiducial marks were measured in it.
     */
    has_marks: boolean;
}

/**
 * What relates the views; matrices by rows, of homogeneous positions in px and of norm 1.
 */
export type TwoViewModel = { kind: "calibrated"; fundamental: [[number, number, number], [number, number, number], [number, number, number]]; rotation: [[number, number, number], [number, number, number], [number, number, number]]; base: [number, number, number] } | { kind: "fundamental"; fundamental: [[number, number, number], [number, number, number], [number, number, number]] } | { kind: "homography"; homography: [[number, number, number], [number, number, number], [number, number, number]] } | { kind: "rotation"; homography: [[number, number, number], [number, number, number], [number, number, number]]; rotation: [[number, number, number], [number, number, number], [number, number, number]] };

/**
 * What says where the block lies in object space.
 */
export type Datum = "free" | "gnss" | "control" | "gnss_and_control";

/**
 * What speaks against the camera that a file names.
 */
export type CameraCaution = { kind: "resized"; taken_width_px: number; taken_height_px: number; width_px: number; height_px: number } | { kind: "cropped"; taken_width_px: number; taken_height_px: number; width_px: number; height_px: number } | { kind: "focal_plane"; pixel_um: number; expected_um: number } | { kind: "contradiction"; xmp_focal_px: number; exif_focal_px: number } | { kind: "panorama"; projection: string };

/**
 * What speaks against the orientation of an image on an orthophoto.
 */
export type PlacingWeakness = { kind: "few_links"; links: number; needed: number } | { kind: "coverage"; share: number; needed: number } | { kind: "checks"; beyond: number; checks: number } | { kind: "rejected"; rejected: number; links: number } | { kind: "height"; height_m: number; half_width_m: number } | { kind: "plan"; height_m: number; half_width_m: number } | { kind: "camera"; camera_parameter: CameraParameter; estimated_px: number; prior_px: number; apart: number } | { kind: "contradicted_focal"; given_px: number; file_px: number } | { kind: "height_factor"; factor: number; standard_error: number } | { kind: "relief"; displaced: number } | { kind: "gnss"; plan_m: number; usual_m: number } | { kind: "far_from_gnss"; distance_km: number; place_slip: PlaceSlip } | { kind: "gnss_height"; height_m: number; usual_m: number } | { kind: "noise"; rmse_px: number; usual_px: number };

/**
 * What the adjustment says of an observed position; 0 for a coordinate that was not observed.
 */
export interface PriorStatistics {
    /**
     * Whether it took part; otherwise it lies too far from where the other observations have it.
     */
    accepted: boolean;
    /**
     * Observed minus adjusted: of a GNSS position with its systematic errors.
     */
    residual: [number, number, number];
    /**
     * r, 0..1, of each coordinate; absent without statistics.
     */
    redundancy: [number, number, number] | null;
    /**
     * Residual by its standard error (Baarda's w), of a new observation where it took no part; absent without statistics.
     */
    w: [number, number, number] | null;
    /**
     * The error that its test finds with a probability of 0.80 (internal reliability); absent where nothing checks the coordinate.
     */
    detectable?: [number | null, number | null, number | null];
    /**
     * External reliability: no function of the unknowns changes by more than so many of its standard errors by an undetected error of that size.
     */
    influence?: [number | null, number | null, number | null];
    /**
     * How far an undetected error of that size moves the adjusted coordinate.
     */
    moves?: [number | null, number | null, number | null];
    /**
     * Of a control point: its place by all other observations; absent where these do not determine it, and without statistics.
     */
    left_out?: LeftOut;
}

/**
 * What the adjustment says of one ray, accepted or not.
 */
export interface ObservationStatistics {
    verdict: ObservationVerdict;
    /**
     * Observed minus computed column and row in px.
     */
    residual_px: [number, number];
    /**
     * r, 0..1, of column and row: the share of an error that shows in the residual; absent without statistics.
     */
    redundancy: [number, number] | null;
    /**
     * Residuals by their standard errors (Baarda's w), of a new observation for a rejected one; absent without statistics.
     */
    w: [number, number] | null;
    /**
     * The error that its test finds with a probability of 0.80 (internal reliability); absent where nothing checks the coordinate.
     */
    detectable_px?: [number | null, number | null];
    /**
     * External reliability: no function of the unknowns changes by more than so many of its standard errors by an undetected error of that size.
     */
    influence?: [number | null, number | null];
    /**
     * How far an undetected error of that size moves its object point; absent in a free network, where that depends on the inner constraints.
     */
    moves_point?: [number | null, number | null];
}

/**
 * What the coordinates of a surveyed point are for.
 */
export type ControlRole = "control" | "check";

/**
 * What the difference of two moments is divided by.
 */
export type Denominator = "maxabs" | "floor";

/**
 * What the image says of the heights of the ground.
 */
export interface Relief {
    /**
     * Absent where the ground has no relief by which it could be told.
     */
    factor?: HeightFactor;
    /**
     * The share of the cells of the image, of those with enough points, whose points lie together elsewhere than the heights put them. Absent where there
     * are few such cells.
     */
    displaced?: number;
}

/**
 * What the links say that took no part.
 */
export interface LinkChecks {
    number: number;
    /**
     * So many are as far off as gross errors are.
     */
    beyond: number;
    /**
     * Root mean square length of the residuals of the others, in px of the image.
     */
    rmse_px: number;
    /**
     * The same on the ground.
     */
    rmse_m: number;
}

/**
 * What the matches of a block say about their own reliability.
 */
export interface MatchReliability {
    /**
     * Share of right matches among those about which a third image says something.
     */
    right: number;
    /**
     * The same among the others.
     */
    right_alone: number;
    /**
     * Matches about which a third image says something.
     */
    observed: number;
}

/**
 * What the place of an image on an orthophoto is worth.
 */
export type PlacingVerdict = { kind: "placed"; links: number; sigma0_px: number; half_width_m: number } | { kind: "weak"; links: number; placing_weakness: PlacingWeakness } | { kind: "not_placed"; not_placed: NotPlaced };

/**
 * What the receiver of a drone says of its solution.
 */
export interface RtkSolution {
    /**
     * 0 no position, 16 single point (metres), 32 to 49 floating solution (decimetres), 50 fixed solution (centimetres).
     */
    flag: number;
    /**
     * Standard deviations east, north and up; absent where one is not given.
     */
    standard_deviations_m: [number, number, number] | null;
}

/**
 * What the residuals of a group say of its stated standard errors.
 */
export interface VarianceComponent {
    group: ObservationGroup;
    /**
     * Coordinates that took part.
     */
    observations: number;
    /**
     * Sum of their redundancies.
     */
    redundancy: number;
    /**
     * Standard errors by the residuals are so many times those that were stated; 1 where it is held.
     */
    factor: number;
    /**
     * That holds the true factor in 95 of 100 cases at least; absent where it is held.
     */
    interval: [number, number] | null;
    /**
     * Whether the observations are weighted by it; otherwise by what was stated.
     */
    applied: boolean;
    /**
     * Whether it was not estimated, since the redundancy does not determine it.
     */
    held?: boolean;
}

/**
 * What the residuals say of the stated standard errors of some observations.
 */
export interface ComponentSummary extends VarianceComponent {
    /**
     * Of which, in words.
     */
    name: string;
}

/**
 * What the result of a pair is worth.
 */
export type PairVerdict = { kind: "oriented"; points: number; sigma0_px: number | null; sigma0_um?: number | null; kappa_deg: number; half_width_deg: number; axes_deg?: number | null; worst?: KnownWorst; worst_half_width_deg?: number } | { kind: "weak"; points: number; warning: Warning } | { kind: "not_oriented"; no_orientation: NoOrientation };

/**
 * What the run reports of its input beside the images that it skips.
 */
export type Remark = { kind: "unused_camera"; images: string } | { kind: "doubtful_focal"; label: string; focal_px: number; sides: number; least: number; most: number; in_mm: boolean } | { kind: "far_principal_point"; label: string; sides: number; most: number } | { kind: "contradicted_focal"; label: string; focal_px: number; file_px: number; images: string[] } | { kind: "cautioned_cameras"; camera_caution: CameraCaution; images: string[] } | { kind: "like_scans"; images: string[] } | { kind: "impossible_positions"; images: ImpossiblePosition[] } | { kind: "unknown_columns"; columns: string[] } | { kind: "doubled_columns"; columns: string[] } | { kind: "unnamed_errors"; columns: string[] } | { kind: "unknown_mark_columns"; columns: string[] } | { kind: "unknown_position_columns"; columns: string[] } | { kind: "unnamed_position_errors"; columns: string[] } | { kind: "position_heights"; column: string; positions: number } | { kind: "doubled_position_columns"; columns: string[] } | { kind: "positions_of_other_images"; images: string[]; all: boolean } | { kind: "points_without_coordinates"; points: string[] } | { kind: "unmeasured_points"; points: string[] } | { kind: "unknown_points"; points: string[] } | { kind: "unsupported_edits" } | { kind: "result_system"; crs: string; operation: string | null; accuracy_m: number | null; gnss_above_m: number | null } | { kind: "ellipsoidal_heights"; crs: string } | { kind: "gnss_without_system"; positions: number } | { kind: "geoid"; name: string; low_m: number; high_m: number } | { kind: "orthophoto_system_assumed"; crs: string } | { kind: "orthophoto_converted"; orthophoto: string; crs: string; accuracy_m: number | null } | { kind: "orthophoto_elsewhere"; images: number; within_m: number; distance_km: number; crs: string; place_slip: PlaceSlip } | { kind: "orthophoto_units"; unit_m: number; height_unit_m: number } | { kind: "orthophoto_heights"; heights: string; from_ellipsoid: boolean; crs: string; above_m: number | null } | { kind: "mosaic_heights"; heights: string; from_ellipsoid: boolean; crs: string; above_m: number | null } | { kind: "mosaic_without_place" } | { kind: "mosaic_without_system"; latitude_deg: number; longitude_deg: number } | { kind: "no_result_system"; crs: string } | { kind: "older_project"; version: number };

/**
 * What two points are compared by.
 */
export type Measure = "dm" | "di";

/**
 * What values a parameter takes.
 */
export type ParameterKind = { kind: "integer"; min: number; max: number; odd: boolean } | { kind: "real"; min: number; max: number } | { kind: "choice"; values: string[]; labels: string[] } | { kind: "flag" } | { kind: "text" };

/**
 * What was observed of positions.
 */
export type Observed = "positions" | "points" | "both";

/**
 * What would do where the strategy of a pair did not: it compares windows of grey values as they stand in both photos.
 */
export type PairHint = { kind: "other_strategy" } | { kind: "unknown_camera" } | { kind: "turned"; turn_deg: number; most_deg: number; scale: number } | { kind: "scaled"; scale: number; most: number; turn_deg: number } | { kind: "turned_and_scaled"; turn_deg: number; most_deg: number; scale: number; most: number } | { kind: "displaced"; dx_px: number; dy_px: number; expected_dx_px: number; expected_dy_px: number; most_px: number; turn_deg: number; scale: number };

/**
 * Where an image shows a place.
 */
export interface SeenIn {
    /**
     * Index of the image.
     */
    image: number;
    /**
     * Column and row in px.
     */
    at_px: [number, number];
    /**
     * The longer side of the image in px.
     */
    side_px: number;
}

/**
 * Where the focal length in px of a file's camera comes from, the most certain first.
 */
export type CameraOrigin = "xmp_calibration" | "xmp_dewarped" | "xmp_design" | "exif_focal_plane" | "exif35_mm" | "sensor_table" | "focal_length_alone" | "panorama";

/**
 * Where the image measurements of GCPs meet: so far from their coordinates in plan, and so far above them, in m, in the median of their coordinates.
 */
export type ControlApart = { kind: "heights"; up_m: number } | { kind: "places"; across_m: number; up_m: number };

/**
 * Whether an observation takes part in the adjustment, or why not.
 */
export type ObservationPart = "accepted" | "gross_error" | "behind" | "lost_point" | "does_not_fit" | "rejected_by_hand" | "not_adjusted";

/**
 * Whether and how observations are refined before the block is oriented.
 */
export interface RefinementOptions {
    /**
     * Whether the observations of chosen points are moved to where their grey values fit those of a reference observation best.
     */
    method: RefinementMethod;
    /**
     * The number of observations per image that are refined and orient the block, where there are as many: more make it more stable and
     * take longer.
     */
    per_image: number;
    /**
     * The side of the window that is matched, in the image or, for points of large scales, in a reduced one: larger ones are more exact on
     * even ground, and wrong where it is broken.
     */
    window: number;
    /**
     * The maximum move of an observation in scales of its point; one that would go farther stays in place.
     */
    farthest: number;
    /**
     * The minimum correlation of a window with that of the reference: higher leaves more observations in place.
     */
    least_correlation: number;
}

/**
 * Which of equal neighbouring values survive the suppression of non-maxima.
 */
export type Ties = "keep" | "first";

/**
 * Which pairs of a block are tried, and what connects them.
 */
export interface PairChoice {
    /**
     * Which pairs are tried: all; images near each other by their positions; images that follow each other by name; images that look
     * alike.
     */
    rule: PairRule | null;
    /**
     * The number of nearest images with which each image is tried: more connect more and take longer.
     */
    near: number;
    /**
     * The number of following images with which each image is tried: more connect more and take longer.
     */
    sequence: number;
    /**
     * The number of most similar images with which each image is tried: more connect more and take longer.
     */
    alike: number;
    /**
     * The minimum number of matches of one geometry that connect a pair: more leave fewer, more certain connections.
     */
    least_matches: number;
}

/**
 * Why a block is not in the system of an orthophoto.
 */
export type NotLinked = { kind: "not_oriented" } | { kind: "own_system"; crs: string } | { kind: "other_system"; orthophoto: string | null; crs: string; failure: Failure } | { kind: "few_images"; placed: number; images: number; needed: number } | { kind: "few_points"; points: number; needed: number } | { kind: "disagreement"; rejected: number; points: number } | { kind: "contradiction"; x_m: number; y_m: number; z_m: number } | { kind: "failed"; failure: Failure };

/**
 * Why a job of a run, or the reading of a file that it needs, failed.
 */
export type Failure = { kind: "unreadable"; message: string } | { kind: "refused"; code: string; message: string; usage: boolean; error?: { kind: string } | null } | { kind: "broke_off"; message: string } | { kind: "out_of_memory"; message: string };

/**
 * Why a pair has no orientation.
 */
export type NoOrientation = { kind: "too_few_matches"; matches: number; needed: number } | { kind: "no_camera"; side: Side } | { kind: "no_focal_length" } | { kind: "no_pixel_size"; side: Side } | { kind: "altered"; side: Side; camera_caution: CameraCaution } | { kind: "contradicted_focal"; side: Side; given_px: number; file_px: number } | { kind: "far_principal_point"; side: Side; sides: number; most: number } | { kind: "panorama"; side: Side } | { kind: "no_geometry"; no_geometry: NoGeometry } | { kind: "pure_rotation" } | { kind: "plane_without_camera" } | { kind: "one_photo" } | { kind: "parts_of_one_image" } | { kind: "refused"; error: { kind: string } };

/**
 * Why a pair was chosen.
 */
export type PairRule = "all" | "near" | "sequence" | "alike";

/**
 * Why a ray takes part, or does not.
 */
export type ObservationVerdict = "accepted" | "gross_error" | "behind" | "lost_point";

/**
 * Why an image has no place on an orthophoto.
 */
export type NotPlaced = { kind: "no_common_place"; matches: number; agreeing: number } | { kind: "no_orientation"; points: number } | { kind: "not_confirmed"; links: number; agreeing: number } | { kind: "failed"; failure: Failure };

/**
 * Why an image is not oriented in the model that is written.
 */
export type ImageReason = { kind: "apart"; images: number } | { kind: "unoriented"; unoriented: UnorientedReason } | { kind: "failed"; failure: Failure } | { kind: "unknown" };

/**
 * Why an image is not oriented.
 */
export type UnorientedReason = { kind: "no_points" } | { kind: "too_few_points"; points: number; needed: number } | { kind: "no_agreement"; agreeing: number; points: number; needed: number } | { kind: "narrow"; agreeing: number } | { kind: "no_partner" } | { kind: "lost"; rays: number } | { kind: "undetermined"; rays: number } | { kind: "rejected_by_hand" };

/**
 * Why matches give no geometry of two views.
 */
export type NoGeometry = { kind: "too_few_matches"; matches: number; needed: number } | { kind: "chance"; agreeing: number; matches: number };

/**
 * Why observations do not determine what is computed, or why its iterations do not converge.
 */
export type Cause = { kind: "points_on_line"; side: Side; width: number; least: number } | { kind: "marks_on_line"; calibrated: boolean; width: number; least: number } | { kind: "positions_on_line"; width: number; least: number } | { kind: "no_extent" } | { kind: "one_position" } | { kind: "no_parallax" } | { kind: "no_base"; parallax: number; least: number } | { kind: "inseparable"; condition: number; most: number } | { kind: "large_errors"; largest_deg: number } | { kind: "large_residuals"; sigma0_px: number; most_px: number } | { kind: "weak_support"; agreeing: number; observations: number } | { kind: "behind_cameras"; in_front: number; points: number } | { kind: "singular_normals"; share: number; least: number } | { kind: "base_across_x"; along_x: number; least: number } | { kind: "no_base_along_x" } | { kind: "gimbal_lock" } | { kind: "chance"; agreeing: number; matches: number } | { kind: "several_matrices" } | { kind: "too_many_on_line" } | { kind: "turned_away" } | { kind: "rising_base" } | { kind: "long_steps"; ratio: number } | { kind: "stalled"; last_step: number } | { kind: "unsettled"; unsettled: Unsettled; rounds: number } | { kind: "point_in_plane" } | { kind: "no_rotation" } | { kind: "no_position" } | { kind: "few_observations"; observations: number; needed: number } | { kind: "no_camera_parameter"; camera: number; camera_parameter: CameraParameter } | { kind: "parts"; parts: number; first: number; second: number } | { kind: "folded_at"; x_px: number; y_px: number } | { kind: "folded_beyond"; radius_px: number };

/**
 * Why the general geometry is not determined.
 */
export type Degeneracy = "plane" | "pure-rotation";


/**
 * The images of an oriented block while they are placed on an orthophoto, one after the other, in wasm memory. Call `free` when it is no longer
 * needed.
 */
export class BlockOnOrthophoto {
    free(): void;
    [Symbol.dispose](): void;
    /**
     * The block in the system of the orthophoto, adjusted by places of its ground; what came of it stands in the summary. Where it could not be
     * linked it is as it was.
     */
    linked(block: FinishedBlock, reference: OrthophotoReference): FinishedBlock;
    /**
     * None is placed yet.
     */
    constructor();
    /**
     * Places an image of the block, by its index, with the camera that the block has adjusted; null for one that is not oriented.
     */
    place(block: FinishedBlock, index: number, file: Uint8Array | Uint8ClampedArray | ArrayBuffer, reference: OrthophotoReference): PlacingVerdict | null;
}

/**
 * The scene below a simulated block in wasm memory. Call `free` when it is no longer needed.
 */
export class BlockScene {
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Builds the scene of a flight; parameters that are absent take their defaults.
     */
    constructor(flight: Given<BlockFlight>);
    /**
     * The orthophoto of all that the photos show and the heights of its surface, as GeoTIFF files; `gsd_m` is the side of a pixel.
     */
    orthophoto(gsd_m: number): { picture: Uint8Array; heights: Uint8Array };
    /**
     * Takes a photo.
     */
    photo(index: number): SampleImage;
    /**
     * Takes a photo as a PNG file, with its camera and recorded position as EXIF.
     */
    photo_file(index: number): Uint8Array;
    /**
     * Places x, y, z in m on the first surface that a photo sees at positions x, y in px (stride 2); stride 3.
     */
    surface_at(index: number, positions: Float64Array | readonly number[]): Float64Array;
    /**
     * The true cameras and exterior orientations.
     */
    truth(): BlockModel;
    /**
     * How many photos the flight takes.
     */
    readonly photos: number;
}

/**
 * The files of a block, of which each step writes some.
 */
export class BlockWriting {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Writes the next files; gives the summary after the last one, null before.
     */
    step(emit: Emit): Summary | null;
}

/**
 * Two oriented images of a project, to be resampled so that what both show lies in the same row of either. Call `free` when it is no longer
 * needed.
 */
export class EpipolarPair {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Of a project file. `names`: the left and the right image; absent: those of a pair, or the two of a block that have most points in common, in
     * that order in which the base goes to the right.
     */
    static open(project: string | Uint8Array | Uint8ClampedArray | ArrayBuffer, names?: readonly string[] | null): EpipolarPair;
    /**
     * Resamples the grey values of both images, which are given in the order of `names`.
     */
    resample(left: Photo, right: Photo): EpipolarFiles;
    /**
     * Resamples both images in the colours of their files, which are given in the order of `names`.
     */
    resample_files(left: Uint8Array | Uint8ClampedArray | ArrayBuffer, right: Uint8Array | Uint8ClampedArray | ArrayBuffer): EpipolarFiles;
    /**
     * SHA-256 of the files of the left and the right image in hexadecimal digits; null for photos that were simulated.
     */
    readonly contents: (string | null)[];
    /**
     * How the epipolar images lie.
     */
    readonly geometry: EpipolarGeometry;
    /**
     * Whether the left image stands second in the project.
     */
    readonly is_swapped: boolean;
    /**
     * The names of the left and the right image.
     */
    readonly names: string[];
}

/**
 * A block that was run, or opened from its project file; its owner frees it.
 */
export class FinishedBlock {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * A map of the standard errors that are expected of points that would be measured in the block. `cell`: the side of a cell, in units of the block;
     * `sigma_px`: the standard error of an image coordinate. Absent: an eightieth of the longer side; σ₀ of the block.
     */
    accuracy(cell?: number | null, sigma_px?: number | null): AccuracyFiles;
    /**
     * The edits of the same block as it was placed before, for this one, to which `edited` applies them; those of places hold where the places lie again.
     */
    carried_edits(before: FinishedBlock): CarriedEdits;
    /**
     * The covariances of images, points and cameras with these names as a table of text: each row an unknown with its unit, adjusted value and standard
     * error, then its covariances with all of them. `all` names the whole block.
     */
    covariances(names: readonly string[]): string;
    /**
     * How many edits each step has.
     */
    edit_steps(): number[];
    /**
     * The block as it was found with these edits, whatever edits it has, adjusted anew; without any, as it was found. `steps`: how many of them each
     * step has that is undone at once; one where it is absent.
     */
    edited(edits: readonly BlockEdit[], steps?: readonly number[]): FinishedBlock;
    /**
     * The edits that it has.
     */
    edits(): BlockEdit[];
    /**
     * The epipolar line of a place of one image in another one: x, y in px, stride 2, as far as that shows it, from near to far.
     */
    epipolar_line(from: number, x_px: number, y_px: number, to: number): Float64Array;
    /**
     * Writes it in one format; tables are in the coordinate reference system of the results.
     */
    export(format: ExportFormat, emit: Emit): void;
    /**
     * All its files, in steps of about one. `score`: what the summary holds of a simulated block; `language`: the tag of that of the report, `en`
     * where it is absent.
     */
    files(formats: readonly ExportFormat[], score?: BlockScore | null, language?: string | null): BlockWriting;
    /**
     * The observations of an image.
     */
    image_points(image: number): ImagePoints;
    /**
     * The place that is nearest to the rays of measurements that take no part: X, Y, Z; absent where they do not meet.
     */
    meeting_place(measurements: readonly HandMeasurement[]): Float64Array | undefined;
    /**
     * The model that is written.
     */
    model(): BlockModel;
    /**
     * What came of the orthophoto that the block was given; null where it was given none.
     */
    on_orthophoto(): OnOrthophoto | null;
    /**
     * Opens a project file; one that is damaged or of another kind is refused whole.
     */
    static open(file: string | Uint8Array | Uint8ClampedArray | ArrayBuffer): FinishedBlock;
    /**
     * What is shown of it.
     */
    overview(): BlockOverview & { points: PointColumns };
    /**
     * Its places of an orthophoto, by which edits of them are carried to the same block once it is placed anew.
     */
    places(): BlockPlaces;
    /**
     * Which of its places lie where those of the same block lay when it was placed before.
     */
    places_again(before: BlockPlaces): PlaceAgain[];
    /**
     * All that is known of a point of the model that is written.
     */
    point(point: number): PointDetail;
    /**
     * The points of the model that is written by what they are, whatever their indices; empty for a block that is not oriented.
     */
    point_ids(): PointSource[];
    /**
     * The number of a point, also where it is rejected; absent for a block that is not oriented.
     */
    point_number(point: PointSource): number | undefined;
    /**
     * The text of its project file.
     */
    project(): string;
    /**
     * How near a simulated block is to its truth.
     */
    score(truth: BlockModel): BlockScore;
}

/**
 * A quick orthomosaic of an oriented block in wasm memory: each place is taken from the image whose projection centre is nearest in plan. Its file, a
 * tiled GeoTIFF, is returned in parts: append what `add`, `leave_out` and `finish().end` return, then overwrite the first bytes with `finish().beginning`.
 * Call `free` when it is no longer needed.
 */
export class OrthoMosaic {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Adds an image, by its index; one that is not oriented adds nothing. Gives what the file goes on with.
     */
    add(index: number, file: Uint8Array | Uint8ClampedArray | ArrayBuffer): Uint8Array;
    /**
     * What the file ends with, and the bytes that it begins with in place of those that were given first.
     */
    finish(): { end: Uint8Array; beginning: Uint8Array };
    /**
     * The heights on which it lies, as GeoTIFF; absent where these are one for all.
     */
    heights(): Uint8Array | undefined;
    /**
     * An image, by its index, that will not be added. Gives what the file goes on with.
     */
    leave_out(index: number): Uint8Array;
    /**
     * Lays it out for the block of a project file. `heights`: one height for all or a file; null: those of the tie points. `gsd`: the side of a
     * pixel; absent: that of the images. In the coordinate reference system of the block, where it has one; `in_adjustment`: in the system of its
     * adjustment, as the map of the page is. `images`: the names of those that it is made of; absent: all.
     */
    static open(project: string | Uint8Array | Uint8ClampedArray | ArrayBuffer, heights: number | Uint8Array | FileInParts | null, heights_sidecars?: Given<Sidecars> | null, gsd?: number | null, in_adjustment?: boolean | null, images?: readonly string[] | null): OrthoMosaic;
    /**
     * The indices of the oriented images that it is made of, in an order in which little waits in memory for images to come.
     */
    order(): Uint32Array;
    /**
     * What is to be said of the heights that were given, or of the system; null where there is nothing.
     */
    remark(): Remark | null;
    /**
     * Width and height in px.
     */
    size(): Uint32Array;
    /**
     * The names of the block's images.
     */
    readonly names: string[];
}

/**
 * An orthophoto with the heights of its ground in wasm memory, on which images are placed. Call `free` when it is no longer needed.
 */
export class OrthophotoReference {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Orients an image by links that are given, in their order; nothing is matched.
     */
    adjust(name: string, file: Uint8Array | Uint8ClampedArray | ArrayBuffer, given: ByLinks): PlacedImage;
    /**
     * The same in colours: red, green, blue and alpha of each pixel, alpha 0 where it shows nothing.
     */
    colours(column: number, row: number, width: number, height: number, halvings: number): Uint8Array;
    /**
     * The edit that adds a place of the ground, measured by eye, as a ground control point to a block; edits after it measure it in images.
     */
    control_by_hand(given: PlaceByHand): Extract<BlockEdit, { kind: 'add_control' }>;
    /**
     * What is to be said of images that record these GNSS positions (`image_position`) before they are placed: that none lies near
     * the orthophoto, and what would bring it to them; null where one does, or where nothing says where both are. `options`: as of `search`; absent: those
     * that it had.
     */
    elsewhere(positions: readonly ExifPosition[], options?: Given<PlacingOptions>): Remark | null;
    /**
     * The ground X, Y, Z, stride 3, that positions of a placed image show, stride 2; no numbers where they show none.
     */
    ground_positions(placement: Placement, positions: Float64Array | readonly number[]): Float64Array;
    /**
     * The heights of places X, Y, stride 2; no number where there is none.
     */
    heights_at(places: Float64Array | readonly number[]): Float64Array;
    /**
     * Where places X, Y of the ground, stride 2, are in a placed image: x and y in px, stride 2, no numbers where it does not show them.
     */
    image_positions(placement: Placement, places: Float64Array | readonly number[]): Float64Array;
    /**
     * Size, place and heights.
     */
    info(): OrthophotoInfo;
    /**
     * Opens a GeoTIFF, or an image with its world file: all of its bytes, or a file from which large ones are read in parts. Its ground is level at 0 until
     * heights are given.
     */
    static open(file: Uint8Array | FileInParts, sidecars?: Given<Sidecars>): OrthophotoReference;
    /**
     * Grey values of a part of the picture that was halved so many times: `width` times `height` of them from a column and row of the halved
     * picture on, 0 where it shows nothing.
     */
    picture(column: number, row: number, width: number, height: number, halvings: number): Uint8Array;
    /**
     * Places an image. Its camera is that of `cameras`, the text of a file of cameras as blocks take it, whose pattern its name fits, or that
     * of its EXIF and XMP, or a usual one. Where it records a GNSS position and the system of the orthophoto is known, it is sought there first, within
     * `within_m`, then on all of the orthophoto. `film`: of the scan of a photo on film, its calibrated camera and the fiducial marks that were measured in it,
     * in place of what is known otherwise. `position`: its GNSS position in a table (`positions_of_images`), in place of that which its file records.
     */
    place(name: string, file: Uint8Array | Uint8ClampedArray | ArrayBuffer, cameras?: string | null, film?: Given<FilmInput> | null, position?: GivenPosition | null): PlacedImage;
    /**
     * A placed image resampled to the ground, in its colours, as GeoTIFF.
     */
    rectified(file: Uint8Array | Uint8ClampedArray | ArrayBuffer, placement: Placement): Uint8Array;
    /**
     * How images are placed; those that are absent take their defaults. Finds the points of the orthophoto among which images are sought, and
     * gives how many they are. Where they are refused the former ones hold.
     */
    search(options: Given<PlacingOptions>): number;
    /**
     * The heights of its ground: one for all, or a file: a GeoTIFF or an ESRI ASCII grid, with what stands beside it, or the project of an oriented block.
     */
    set_heights(heights: number | Uint8Array | FileInParts, sidecars?: Given<Sidecars>): void;
}

/**
 * A grey image in wasm memory. Call `free` when it is no longer needed.
 */
export class Photo {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Decodes a JPEG, PNG, TIFF, BMP, PNM or WebP file.
     */
    static decode(bytes: Uint8Array | Uint8ClampedArray | ArrayBuffer): Photo;
    /**
     * Describes points (stride 3) by the seven numbers each that a strategy compares; NaN where a window leaves the image or is constant.
     * Empty for the strategies that compare grey values.
     */
    describe(point_list: Float64Array | readonly number[], window: Given<WindowOptions>, strategy: Strategy): Float64Array;
    /**
     * Finds interest points and describes them as the strategy of the settings needs it.
     */
    describe_points(settings: Given<PairSettings>, mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null): DescribedPoints;
    /**
     * Finds interest points by the groups `points` and `multiscale` of the settings. Points whose pixel is 0 in the mask, of the image's size
     * and row by row, are left out.
     */
    detect(settings: Given<PairSettings>, mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null): DetectedPoints;
    /**
     * Finds points distinct in position and scale and describes them by the gradients around them. Points whose pixel is 0 in the mask,
     * of the image's size and row by row, are left out.
     */
    features(options: Given<FeatureOptions>, mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null): Features;
    /**
     * Takes grey values 0..255, row by row.
     */
    static from_grey(width: number, height: number, grey: Uint8Array | Uint8ClampedArray | ArrayBuffer): Photo;
    /**
     * A copy of the grey values, row by row.
     */
    grey(): Uint8Array;
    /**
     * Size, format, camera and drone.
     */
    info(): PhotoInfo;
    /**
     * The image halved until its longer side is at most `max_side` px.
     */
    reduced(max_side: number): ReducedImage;
    /**
     * The window around a pixel (column and row from 0) with its moments.
     */
    window_moments(col: number, row: number, window: Given<WindowOptions>): WindowReport;
    readonly height: number;
    readonly width: number;
}

/**
 * The report of a pair in the making: `step` until it says false, then `html`.
 */
export class Report {
    free(): void;
    [Symbol.dispose](): void;
    /**
     * The page, which holds everything it shows; in English, or in the language of a tag. Does the steps that are left.
     */
    html(language?: string | null): string;
    /**
     * Takes copies of both images; `names` are what the report calls them. Points whose pixel is 0 in the mask of their image, of its size
     * and row by row, are left out. With edits the run is that of the edited matches; the other strategies match by themselves.
     */
    constructor(left: Photo, right: Photo, names: [string, string], input: Given<PairInput>, settings: Given<PairSettings>, truth: ReportTruth | null, left_mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null, right_mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null, edits?: ReportEdits | null);
    /**
     * Does the next step; false when all were done.
     */
    step(): boolean;
    /**
     * What each step does, in their order; in English, or in the language of a tag.
     */
    steps(language?: string | null): string[];
    /**
     * The verdict on this run; null before the first step.
     */
    verdict(): PairVerdict | null;
}

/**
 * The run of a block. Its host does the jobs of `next`, in any order and any number at the same time: it reads the files, asks `prepare`,
 * looks for a kept record of the key, which goes to `found`, and else calls `execute_job`, keeps what comes of it and hands it to `complete`.
 */
export class Run {
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Takes the bytes that came of a job.
     */
    complete(id: number, bytes: Uint8Array | Uint8ClampedArray | ArrayBuffer): void;
    /**
     * Takes why a job could not be done: an image or a pair is left out with it, where these are to blame.
     */
    failed(id: number, failure: Failure): void;
    /**
     * What the run has found; frees it.
     */
    finish(): FinishedBlock;
    /**
     * Takes a kept record; one that does not read well is not taken, and the job is still to be done.
     */
    found(id: number, record: Uint8Array | Uint8ClampedArray | ArrayBuffer): boolean;
    /**
     * A run of which nothing is done; what can be refused before the images are read is refused here.
     */
    constructor(input: Given<RunInput>);
    /**
     * What was found since the last call, and how far the stages are.
     */
    news(): News[];
    /**
     * Jobs that can be done now, at most so many. Where there are none, and none is under way, the run is over.
     */
    next(most: number): Job[];
    /**
     * What is to be done for a job whose files have these digests, SHA-256 in hexadecimal digits.
     */
    prepare(id: number, digests: readonly string[]): Work;
}

/**
 * The keys of the options of a block that have an effect with these settings.
 */
export function acting_block_parameters(settings: Given<BlockSettings>): string[];

/**
 * The keys of the options of a pair that have an effect with these settings.
 */
export function acting_parameters(settings: Given<PairSettings>): string[];

/**
 * The interior orientations of a pair of whose cameras nothing is known but what its geometry tells; null where it is the map of a plane.
 */
export function assumed_interior(geometry: Omit<TwoView, "inliers">, left: PhotoFacts, right: PhotoFacts): PairInterior | null;

/**
 * Every parameter of a block's flight on which photos depend.
 */
export function block_flight_parameters(): Parameter[];

/**
 * A ready-made flight of a block.
 */
export function block_flight_preset(name: BlockPreset): BlockFlight;

/**
 * Every option of a block, in the order of the pipeline.
 */
export function block_parameters(): Parameter[];

/**
 * All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
 */
export function block_settings(given: Given<BlockSettings>): BlockSettings;

/**
 * What calls are given beside settings, by the names of their arguments.
 */
export function call_parameters(): Parameter[];

/**
 * What a block calls the camera of a photograph of this size in px: make, model, focal length and size.
 */
export function camera_label(camera: ExifCamera, width: number, height: number): string;

/**
 * The camera of an EXIF block, with what is not known of it.
 */
export function camera_of_exif(exif: ExifCamera): CameraMm;

/**
 * The camera of a photo of which nothing but the focal length in px is known.
 */
export function camera_of_focal_px(focal_px: number): CameraMm;

/**
 * The candidates of one left point, the best first: index of the right point and measure, stride 2.
 */
export function candidates(index: number, left_points: Float64Array | readonly number[], left_descriptors: Float64Array | readonly number[], right_points: Float64Array | readonly number[], right_descriptors: Float64Array | readonly number[], offset: OffsetField, options: Given<MatchOptions>): Float64Array;

/**
 * The steps of edits that hold in another block, that was found or placed anew: by names of images and surveyed points, and by where places lie.
 */
export function carried_steps(carrying: Carrying): CarriedSteps;

/**
 * Refuses a truth of other images.
 */
export function check_block_truth(truth: BlockModel, names: readonly string[]): void;

/**
 * Refuses a file of cameras that cannot be read, or fits no image of these names, where there are any.
 */
export function check_cameras(text: string, names: readonly string[]): void;

/**
 * Refuses ground control points and image measurements that a run of these images would refuse, as far as their names say. `on_orthophoto`:
 * whether one places the block afterwards.
 */
export function check_control(points: string, marks: string, names: readonly string[], placing?: Given<GeoreferencingOptions>, on_orthophoto?: boolean): void;

/**
 * Refuses a flight that [`simulate`] refuses, without rendering it; parameters that are absent are those of the sample.
 */
export function check_flight(flight: Given<Flight>): void;

/**
 * Refuses the file of a geoid beside its height, and one without a coordinate system whose heights count from it.
 */
export function check_geoid(name: string, placing?: Given<GeoreferencingOptions>): void;

/**
 * Refuses what is no height of the ground, nor a file of heights.
 */
export function check_heights(heights: number | Uint8Array | FileInParts, sidecars?: Given<Sidecars>): void;

/**
 * The groups of connected images of a block, the largest first.
 */
export function connected_groups(images: number, connections: Connection[]): number[][];

/**
 * The same offset (right minus left position, px) everywhere.
 */
export function constant_offset(dx: number, dy: number): OffsetField;

/**
 * The defaults of all options.
 */
export function defaults(): PairSettings;

/**
 * Draws the lines of matches whose two ends are both in view, from the left image's view to the right one's; returns how many.
 *
 * `matches`: stride 5, `x left, y left, x right, y right, measure` in px. `codes`: one a match, the index of its style; a code without
 * a style is not drawn. `widths` and `colours`: one a style. Views as of `draw_points`. Where more than `most` are in view, evenly many are drawn.
 */
export function draw_match_lines(context: CanvasRenderingContext2D, matches: Float64Array | readonly number[], codes: Uint8Array | Uint8ClampedArray | ArrayBuffer, widths: Float64Array | readonly number[], colours: readonly string[], left_view: Float64Array | readonly number[], right_view: Float64Array | readonly number[], most: number): number;

/**
 * Draws points; returns how many were drawn.
 *
 * `points`: stride 3, `x, y, value` in px. `codes`: one a point, the index of its style; a code without a style is not drawn.
 * `styles`: stride 3, `shape, half size, line width` in canvas units (shapes: 0 dot, 1 circle, 2 plus, 3 cross, 4 square,
 * 5 triangle up, 6 triangle down, 7 diamond). `colours`: one CSS colour a style. `view`: scale, shift x, shift y,
 * left, top, right, bottom: a position of the canvas is scale times that of the image plus the shift, and marks are drawn within the last four, in canvas
 * units. Styles are drawn in order,
 * the last on top; where points crowd, some are left out.
 */
export function draw_points(context: CanvasRenderingContext2D, points: Float64Array | readonly number[], codes: Uint8Array | Uint8ClampedArray | ArrayBuffer, styles: Float64Array | readonly number[], colours: readonly string[], view: Float64Array | readonly number[]): number;

/**
 * Draws vectors as arrows from their points, enlarged `factor` times; returns how many.
 *
 * `vectors`: stride 4, `x, y, dx, dy` in px of the image. `codes`: one a vector, the index of its style; a code without a style is not drawn.
 * `widths` and `colours`: one a style. `view`: as of `draw_points`.
 */
export function draw_vectors(context: CanvasRenderingContext2D, vectors: Float64Array | readonly number[], codes: Uint8Array | Uint8ClampedArray | ArrayBuffer, widths: Float64Array | readonly number[], colours: readonly string[], factor: number, view: Float64Array | readonly number[]): number;

/**
 * Where a point of one image may be seen in the other, by the geometry that `match_photos` gave with the same interior orientations:
 * positions x, y in px along its epipolar line, or the one place that the map of a plane or a rotation gives; stride 2. Empty where the
 * line passes the other image, whose width and height are given.
 */
export function epipolar_line(from: "left" | "right", x: number, y: number, model: TwoViewModel, interior: PairInterior | null, other_width: number, other_height: number): Float64Array;

/**
 * Estimates the offsets between two images from `Photo.reduced(1024)` of each.
 */
export function estimate_offset(left: ReducedImage, right: ReducedImage): OffsetField;

/**
 * Does the task of a job: the same bytes give the same bytes, on every machine.
 */
export function execute_job(task: string, inputs: readonly Uint8Array[]): Uint8Array;

/**
 * The names of the formats that blocks are written in.
 */
export function export_formats(): ExportFormat[];

/**
 * The defaults of the options of features.
 */
export function feature_defaults(): FeatureOptions;

/**
 * Why so few matches have no orientation, whatever else is missing; null where they are enough.
 */
export function few_matches(matches: number): NoOrientation | null;

/**
 * The cameras of frames as a file of cameras has them, from that of each, before those that it has (`given`): frames of one film have one, for all images
 * whose names fit `pattern`, as `film_pattern` gives it.
 */
export function film_cameras(pattern: string, rules: CameraRule[], given: CameraRule[]): CameraRule[];

/**
 * Resamples the file of a scan by the fiducial marks that were measured in it: all scans of a camera become images of one ideal camera, of which a block
 * is made.
 */
export function film_frame(scan: Uint8Array | Uint8ClampedArray | ArrayBuffer, film: Given<FilmInput>, wanted: FrameWanted): FilmFiles;

/**
 * Takes image measurements that were made in scans into their frames.
 */
export function film_measurements(measurements: ImageMeasurementRow[], frames: FrameOfScan[]): FramedMeasurements;

/**
 * The pattern of the names of frames of one film, whose first one has the camera `rule`, beside those of other films, whose cameras are `given`.
 */
export function film_pattern(rule: CameraRule, given: CameraRule[]): string;

/**
 * The side of a pixel of a scan in mm, as its fiducial marks have it.
 */
export function film_pixel_mm(film: Given<FilmInput>): number;

/**
 * Positions of a scan in its frame, or of a frame in its scan: x, y, x, y … in px, the centre of the top-left pixel at (0.5, 0.5). NaN where there is none,
 * as beside the frame. `to`: `frame` or `scan`.
 */
export function film_positions(scan: FilmScan, positions: Float64Array | readonly number[], to: 'frame' | 'scan'): Float64Array;

/**
 * What is to be said of the camera of a scan: that the side of a pixel that it gives is another than that of the marks, and not used; null where there is
 * nothing.
 */
export function film_warning(film: Given<FilmInput>): Warning | null;

/**
 * Every parameter of a flight.
 */
export function flight_parameters(): Parameter[];

/**
 * A ready-made flight.
 */
export function flight_preset(name: Preset): Flight;

/**
 * The names of the ready-made flights.
 */
export function flight_presets(): Preset[];

/**
 * Longitudes, latitudes and heights (stride 3) of positions in m east, north and up of an origin, which is their first row: of the others alone.
 */
export function geographic_positions(positions: Float64Array | readonly number[]): Float64Array;

/**
 * The right points in the order of their distance from the left one of an index, up to `most`: index and measure, stride 2.
 */
export function gradient_candidates(index: number, left_gradients: Uint8Array | Uint8ClampedArray | ArrayBuffer, right_gradients: Uint8Array | Uint8ClampedArray | ArrayBuffer, most: number): Float64Array;

/**
 * Writes grey values as a PNG file, with the camera and the position of `exif` where it is given.
 */
export function grey_png(width: number, height: number, grey: Uint8Array | Uint8ClampedArray | ArrayBuffer, exif?: ExifImage): Uint8Array;

/**
 * The table of image measurements, which reads back as they are.
 */
export function image_measurement_table(measurements: ImageMeasurementRow[]): string;

/**
 * The GNSS position that an image records; null where it records none. Of a file in parts no more than its EXIF is read: of a TIFF its directories, wherever
 * they lie, of other images what stands in their first 256 KiB.
 */
export function image_position(file: Uint8Array | FileInParts): ExifPosition | null;

/**
 * The interior orientation of an image: from its fiducials, or from the camera's pixel size.
 */
export function interior(camera: CameraMm, photo: PhotoGeometry): Interior;

/**
 * The matches of pieces that follow each other from the first left descriptor to the last: those of the whole, whatever the pieces.
 */
export function join_nearest(pieces: NearestPiece[], options: Given<NearestOptions>): DescriptorMatches;

/**
 * Positions in m east, north and up of the first known one: of longitude, latitude in degrees and height in m (stride 3), NaN where not known.
 */
export function local_positions(geographic: Float64Array | readonly number[]): Float64Array;

/**
 * The index of the mask of each image, by their names; -1 for an image without one. Refuses two masks of one image.
 */
export function masks_of_images(names: readonly string[], masks: readonly string[]): Int32Array;

/**
 * Matches and orients two photos whose points are described: the rest of `match_pair`. For the strategy gradient the nearest descriptors may
 * have been searched for already: the pieces that `nearest_piece` made of all left points, in their order.
 */
export function match_described_pair(left: Photo, right: Photo, left_points: GivenPoints, right_points: GivenPoints, input: Given<PairInput>, settings: Given<PairSettings>, nearest?: NearestPiece[]): MatchedPair;

/**
 * Matches byte descriptors of 128 bytes each: exact nearest neighbours, the ratio to the second nearest, the same from both sides.
 */
export function match_descriptors(left: Uint8Array | Uint8ClampedArray | ArrayBuffer, right: Uint8Array | Uint8ClampedArray | ArrayBuffer, options: Given<NearestOptions>): DescriptorMatches;

/**
 * Matches the features of two images (positions x, y in px, stride 2; 128 bytes each) by nearest descriptors, verified by the geometry of
 * the two views and completed along its lines. Where `options.geometry` names cameras, positions are those of cameras without distortion.
 */
export function match_features(left_positions: Float64Array | readonly number[], left_descriptors: Uint8Array | Uint8ClampedArray | ArrayBuffer, right_positions: Float64Array | readonly number[], right_descriptors: Uint8Array | Uint8ClampedArray | ArrayBuffer, options: Given<FeatureMatchOptions>): VerifiedMatches;

/**
 * Matches byte descriptors near the epipolar line, or the place, of each left point: positions x, y in px (stride 2), 128 bytes each.
 */
export function match_guided_descriptors(left_positions: Float64Array | readonly number[], left_descriptors: Uint8Array | Uint8ClampedArray | ArrayBuffer, right_positions: Float64Array | readonly number[], right_descriptors: Uint8Array | Uint8ClampedArray | ArrayBuffer, guide: MatchGuide, options: Given<GuidedOptions>): DescriptorMatches;

/**
 * Matches and orients a pair on one thread. Points whose pixel is 0 in the mask of their image, of its size and row by row, are left out.
 */
export function match_pair(left: Photo, right: Photo, input: Given<PairInput>, settings: Given<PairSettings>, left_mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null, right_mask?: Uint8Array | Uint8ClampedArray | ArrayBuffer | null): PairOutput;

/**
 * Matches two photos by any strategy.
 *
 * With `matching.epipolar` and an interior orientation the pair is oriented and matched again along the epipolar lines, until nothing
 * changes. Only the strategy gradient does without an offset. It finds the nearest descriptors itself, unless it is given the pieces that
 * `nearest_piece` made of all left points, in their order: the matches are the same.
 */
export function match_photos(left: Photo, right: Photo, left_points: GivenPoints, right_points: GivenPoints, offset: OffsetField | null, interior: PairInterior | null, settings: Given<PairSettings>, nearest?: NearestPiece[]): MatchResult;

/**
 * Matches described points: points of stride 3, descriptors of stride 7.
 */
export function match_points(left_points: Float64Array | readonly number[], left_descriptors: Float64Array | readonly number[], right_points: Float64Array | readonly number[], right_descriptors: Float64Array | readonly number[], offset: OffsetField, options: Given<MatchOptions>): MatchResult;

/**
 * Writes matches (stride 5) as CSV, each with its state: used or rejected by the orientation whose `rejected` is given, empty without.
 */
export function matches_csv(matches: Float64Array | readonly number[], rejected?: readonly number[] | null): string;

/**
 * Object points of observations (stride 4) that are oriented as `orient_relative` does: X, Y, Z, their standard errors (NaN where there are
 * none), 1 where the observation took part and 0 where it was rejected; stride 7, NaN for parallel rays. `base`: the length of the base in
 * the unit that the points shall have; 1: the base is the unit.
 */
export function model_points(observations: Float64Array | readonly number[], focal_mm: number, options: Given<OrientationOptions>, base: number, weights?: Float64Array | readonly number[] | null): Float64Array;

/**
 * Writes object points of a pair (stride 7, as `model_points` gives them) as CSV.
 */
export function model_points_csv(points: Float64Array | readonly number[]): string;

/**
 * The nearest right descriptors of left ones from `first` to before `end`: a piece of the work, for `join_nearest` and
 * `match_photos`.
 */
export function nearest_piece(left: Uint8Array | Uint8ClampedArray | ArrayBuffer, first: number, end: number, right: Uint8Array | Uint8ClampedArray | ArrayBuffer): NearestPiece;

/**
 * Photo coordinates x, y left, x, y right in mm (stride 4) of matches (stride 5).
 */
export function observations(matches: Float64Array | readonly number[], left: Interior, right: Interior): Float64Array;

/**
 * Why matches (stride 5) between images of these sizes in px have no base: they are one photo twice, or parts of one image. Null where
 * they are neither.
 */
export function one_image(matches: Float64Array | readonly number[], left_width: number, left_height: number, right_width: number, right_height: number): NoOrientation | null;

/**
 * Opens the project file of a pair; one that is damaged or of another kind is refused whole.
 */
export function open_pair_project(file: string | Uint8Array | Uint8ClampedArray | ArrayBuffer): PairProject;

/**
 * Interior orientation by fiducial marks.
 */
export function orient_fiducials(fiducials: Fiducial[], model: FiducialModel): FiducialOrientation;

/**
 * Relative orientation from matches (stride 5) with what least squares matching found of them (stride 5, as `MatchResult.fits`; empty: all
 * of weight 1), with the verdict on it. `points`: how many the left and the right image have, where they were matched. The total standard errors hold those of the interior orientations, where these have covariances.
 */
export function orient_matches(matches: Float64Array | readonly number[], fits: Float64Array | readonly number[], interior: PairInterior, options: Given<OrientationOptions>, points?: [number, number]): OrientedPair;

/**
 * Relative orientation of observations x, y left, x, y right in mm (stride 4), each of its weight, or all of weight 1, with the verdict on it.
 */
export function orient_relative(observations: Float64Array | readonly number[], focal_mm: number, options: Given<OrientationOptions>, weights?: Float64Array | readonly number[] | null): OrientedPair;

/**
 * The cameras of a pair, the given one or those of its files, with what speaks against them; or what is missing.
 */
export function pair_cameras(given: CameraMm | null, left: PhotoFacts, right: PhotoFacts): PairCameras | { missing: NoOrientation };

/**
 * What else would do for a pair of this verdict and these settings; null where nothing is known to. With how the photos lie to each other
 * (`photo_difference`), and the offset by which matches were looked for, it says which of that the strategy does not take.
 */
export function pair_hint(verdict: PairVerdict, settings: Given<PairSettings>, difference?: PhotoDifference | null, offset?: OffsetField | null): PairHint | null;

/**
 * Ready-made settings.
 */
export function pair_preset(name: PairPreset): PairSettings;

/**
 * The names of ready-made settings.
 */
export function pair_presets(): PairPreset[];

/**
 * What the paper printed for its own pair.
 */
export function paper(): Paper;

/**
 * How far the y-parallax of one left point is from those of its nearest matches, and how far it may be; absent where it has no place or nothing is near.
 * Rules and places are those of a `MatchResult`.
 */
export function parallax_deviation(index: number, left_points: Float64Array | readonly number[], rules: Uint8Array | Uint8ClampedArray | ArrayBuffer, places: Float64Array | readonly number[], offset: OffsetField, options: Given<MatchOptions>): ParallaxDeviation | undefined;

/**
 * Every option of a pair, in the order of the pipeline.
 */
export function parameters(): Parameter[];

/**
 * Reads a camera: {"focal_mm", "principal_point_mm", "pixel_mm", "radial_distortion", "tangential_distortion"}.
 */
export function parse_camera(json: string): CameraMm;

/**
 * Reads cameras that hold for the images whose names fit a pattern.
 */
export function parse_camera_rules(json: string): CameraRule[];

/**
 * Reads fiducial marks: columns col, row, x_mm, y_mm.
 */
export function parse_fiducials(csv: string): Fiducial[];

/**
 * Reads surveyed points: lines of name, x, y, z and perhaps two standard errors.
 */
export function parse_ground_control_points(text: string): GroundControlRow[];

/**
 * Reads where images show surveyed points: lines of image, point, x, y in px. `images`: names of images, which stand in the rows where the
 * table means them, by other capitals, with a folder or without their ending.
 */
export function parse_image_measurements(text: string, images?: readonly string[] | null): ImageMeasurementRow[];

/**
 * Reads GNSS positions of images: lines of image, longitude, latitude and height, or of image, x, y and height, and perhaps two standard errors.
 */
export function parse_image_positions(text: string): ImagePositions;

/**
 * Reads photo coordinates: columns x_left_mm, y_left_mm, x_right_mm, y_right_mm; stride 4.
 */
export function parse_observations(csv: string): Float64Array;

/**
 * A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
 */
export function photo_camera(camera: Camera): CameraMm;

/**
 * How the right photo lies to the left one in their planes; null where they do not match, however they lie.
 */
export function photo_difference(left: Photo, right: Photo): PhotoDifference | null;

/**
 * The tables of images that were placed: of the images, and of their links.
 */
export function placed_tables(names: readonly string[], placed: readonly PlacedImage[]): { placed: string; links: string };

/**
 * Their defaults.
 */
export function placing_defaults(): PlacingOptions;

/**
 * Every option of placing images.
 */
export function placing_parameters(): Parameter[];

/**
 * The files that a block of images with these names is written to, but for those of which there is one for each two images.
 */
export function planned_files(names: readonly string[], formats: readonly ExportFormat[]): string[];

/**
 * Writes points (stride 3) as CSV.
 */
export function points_csv(points: Float64Array | readonly number[]): string;

/**
 * The GNSS position that a table gives to each image, by their names; null where it gives none. Refuses a table that a run of these images would refuse.
 * Heights in a coordinate reference system whose geoid is a file count from its zero here.
 */
export function positions_of_images(text: string, names: readonly string[], placing?: Given<GeoreferencingOptions>): (GivenPosition | null)[];

/**
 * What a project file holds, by its first kilobyte; null for what is no project.
 */
export function project_kind(start: string | Uint8Array | Uint8ClampedArray | ArrayBuffer): ProjectKind | null;

/**
 * What EXIF tells of an image of this size beside its pixels.
 */
export function read_exif(file: Uint8Array | Uint8ClampedArray | ArrayBuffer, width: number, height: number): ExifImage;

/**
 * Why a file is refused whose first bytes, or the ending of whose name where these say nothing, are those of a kind that is not decoded (HEIC, raw, film, …);
 * null for all others. 64 bytes tell every kind but raw files that are TIFFs.
 */
export function refused_kind(name: string, start: Uint8Array | Uint8ClampedArray | ArrayBuffer): { kind: string } | null;

/**
 * What is to be said of a table of GNSS positions beside images of these names: columns that are not understood, rows of other images.
 */
export function remarks_of_positions(text: string, names: readonly string[]): Remark[];

/**
 * Settings with every absent option that follows from the others, as all calls take them; what follows from the images stays absent.
 */
export function resolved(settings: Given<PairSettings>): PairSettings;

/**
 * The names of the rules, in the order of their codes.
 */
export function rule_names(): Rule[];

/**
 * The same rays at a focal length `factor` times as long: two photos of different focal lengths are oriented at one of them.
 */
export function scaled_interior(interior: Interior, factor: number): Interior;

/**
 * Scores an oriented block by the truth of its photos, which have the same names.
 */
export function score_block(model: BlockModel, truth: BlockModel): BlockScore;

/**
 * Scores matches (stride 5) of left points (stride 3) by the truth of a simulated pair.
 */
export function score_matches(matches: Float64Array | readonly number[], left_points: Float64Array | readonly number[], right_position: Float32Array | readonly number[], left_width: number, left_height: number, right_width: number, right_height: number): MatchScore;

/**
 * SHA-256 (FIPS 180-4) of bytes: 32 bytes.
 */
export function sha256(bytes: Uint8Array | Uint8ClampedArray | ArrayBuffer): Uint8Array;

/**
 * Renders the pair of a flight; parameters that are absent are those of the sample.
 */
export function simulate(flight: Given<Flight>): SamplePair;

/**
 * Coordinates in a system (an EPSG code, PROJ text or WKT) of longitudes, latitudes in degrees and heights in m (stride 3): x, east or longitude,
 * first; NaN outside the system, an error where the median of the places lies there.
 */
export function system_coordinates(crs: string, geographic: Float64Array | readonly number[], heights?: CountedFrom | null): Float64Array;

/**
 * The way back: longitudes, latitudes and heights of coordinates in a system (stride 3).
 */
export function system_positions(crs: string, coordinates: Float64Array | readonly number[], heights?: CountedFrom | null): Float64Array;

/**
 * Throws a panic as an error named `Panic`, which is a bug: a trap without one is memory that ran out.
 */
export function throw_panics(): void;

/**
 * The geometry of two images from matches x, y left, x, y right in px (stride 4), of which many may be wrong.
 */
export function two_view(points: Float64Array | readonly number[], options: Given<TwoViewOptions>): TwoViewResult;

/**
 * The version of the crate.
 */
export function version(): string;

/**
 * Writes the project file of a pair.
 */
export function write_pair_project(project: PairProject): string;

export type InitInput = RequestInfo | URL | Response | BufferSource | WebAssembly.Module;

export interface InitOutput {
    readonly memory: WebAssembly.Memory;
    readonly __wbg_blockonorthophoto_free: (a: number, b: number) => void;
    readonly __wbg_blockscene_free: (a: number, b: number) => void;
    readonly __wbg_blockwriting_free: (a: number, b: number) => void;
    readonly __wbg_epipolarpair_free: (a: number, b: number) => void;
    readonly __wbg_finishedblock_free: (a: number, b: number) => void;
    readonly __wbg_orthomosaic_free: (a: number, b: number) => void;
    readonly __wbg_orthophotoreference_free: (a: number, b: number) => void;
    readonly __wbg_photo_free: (a: number, b: number) => void;
    readonly __wbg_report_free: (a: number, b: number) => void;
    readonly __wbg_run_free: (a: number, b: number) => void;
    readonly acting_block_parameters: (a: any) => [number, number, number];
    readonly acting_parameters: (a: any) => [number, number, number];
    readonly assumed_interior: (a: any, b: any, c: any) => [number, number, number];
    readonly block_flight_parameters: () => any;
    readonly block_flight_preset: (a: any) => [number, number, number];
    readonly block_parameters: () => any;
    readonly block_settings: (a: any) => [number, number, number];
    readonly blockonorthophoto_linked: (a: number, b: number, c: number) => [number, number, number];
    readonly blockonorthophoto_new: () => number;
    readonly blockonorthophoto_place: (a: number, b: number, c: any, d: any, e: number) => [number, number, number];
    readonly blockscene_new: (a: any) => [number, number, number];
    readonly blockscene_orthophoto: (a: number, b: any) => [number, number, number];
    readonly blockscene_photo: (a: number, b: any) => [number, number, number];
    readonly blockscene_photo_file: (a: number, b: any) => [number, number, number, number];
    readonly blockscene_photos: (a: number) => number;
    readonly blockscene_surface_at: (a: number, b: any, c: any) => [number, number, number];
    readonly blockscene_truth: (a: number) => any;
    readonly blockwriting_step: (a: number, b: any) => [number, number, number];
    readonly call_parameters: () => any;
    readonly camera_label: (a: any, b: any, c: any) => [number, number, number, number];
    readonly camera_of_exif: (a: any) => [number, number, number];
    readonly camera_of_focal_px: (a: any) => [number, number, number];
    readonly candidates: (a: any, b: any, c: any, d: any, e: any, f: any, g: any) => [number, number, number, number];
    readonly carried_steps: (a: any) => [number, number, number];
    readonly check_block_truth: (a: any, b: any) => [number, number];
    readonly check_cameras: (a: any, b: any) => [number, number];
    readonly check_control: (a: any, b: any, c: any, d: any, e: number) => [number, number];
    readonly check_flight: (a: any) => [number, number];
    readonly check_geoid: (a: any, b: any) => [number, number];
    readonly check_heights: (a: any, b: any) => [number, number];
    readonly connected_groups: (a: any, b: any) => [number, number, number];
    readonly constant_offset: (a: any, b: any) => [number, number, number];
    readonly defaults: () => any;
    readonly draw_match_lines: (a: any, b: any, c: any, d: any, e: any, f: any, g: any, h: number) => [number, number, number];
    readonly draw_points: (a: any, b: any, c: any, d: any, e: any, f: any) => [number, number, number];
    readonly draw_vectors: (a: any, b: any, c: any, d: any, e: any, f: number, g: any) => [number, number, number];
    readonly epipolar_line: (a: any, b: any, c: any, d: any, e: any, f: any, g: any) => [number, number, number, number];
    readonly epipolarpair_contents: (a: number) => any;
    readonly epipolarpair_geometry: (a: number) => any;
    readonly epipolarpair_is_swapped: (a: number) => number;
    readonly epipolarpair_names: (a: number) => [number, number];
    readonly epipolarpair_open: (a: any, b: number) => [number, number, number];
    readonly epipolarpair_resample: (a: number, b: number, c: number) => [number, number, number];
    readonly epipolarpair_resample_files: (a: number, b: any, c: any) => [number, number, number];
    readonly estimate_offset: (a: any, b: any) => [number, number, number];
    readonly execute_job: (a: any, b: any) => [number, number, number, number];
    readonly export_formats: () => any;
    readonly feature_defaults: () => any;
    readonly few_matches: (a: any) => [number, number, number];
    readonly film_cameras: (a: any, b: any, c: any) => [number, number, number];
    readonly film_frame: (a: any, b: any, c: any) => [number, number, number];
    readonly film_measurements: (a: any, b: any) => [number, number, number];
    readonly film_pattern: (a: any, b: any) => [number, number, number, number];
    readonly film_pixel_mm: (a: any) => [number, number, number];
    readonly film_positions: (a: any, b: any, c: any) => [number, number, number];
    readonly film_warning: (a: any) => [number, number, number];
    readonly finishedblock_accuracy: (a: number, b: number, c: number) => [number, number, number];
    readonly finishedblock_carried_edits: (a: number, b: number) => [number, number, number];
    readonly finishedblock_covariances: (a: number, b: any) => [number, number, number, number];
    readonly finishedblock_edit_steps: (a: number) => any;
    readonly finishedblock_edited: (a: number, b: any, c: any) => [number, number, number];
    readonly finishedblock_edits: (a: number) => any;
    readonly finishedblock_epipolar_line: (a: number, b: any, c: any, d: any, e: any) => [number, number, number, number];
    readonly finishedblock_export: (a: number, b: any, c: any) => [number, number];
    readonly finishedblock_files: (a: number, b: any, c: any, d: number) => [number, number, number];
    readonly finishedblock_image_points: (a: number, b: any) => [number, number, number];
    readonly finishedblock_meeting_place: (a: number, b: any) => [number, number, number, number];
    readonly finishedblock_model: (a: number) => any;
    readonly finishedblock_on_orthophoto: (a: number) => any;
    readonly finishedblock_open: (a: any) => [number, number, number];
    readonly finishedblock_overview: (a: number) => [number, number, number];
    readonly finishedblock_places: (a: number) => [number, number, number];
    readonly finishedblock_places_again: (a: number, b: any) => [number, number, number];
    readonly finishedblock_point: (a: number, b: any) => [number, number, number];
    readonly finishedblock_point_ids: (a: number) => any;
    readonly finishedblock_point_number: (a: number, b: any) => [number, number, number];
    readonly finishedblock_project: (a: number) => [number, number, number, number];
    readonly finishedblock_score: (a: number, b: any) => [number, number, number];
    readonly flight_parameters: () => any;
    readonly flight_preset: (a: any) => [number, number, number];
    readonly flight_presets: () => any;
    readonly geographic_positions: (a: any) => [number, number, number];
    readonly gradient_candidates: (a: any, b: any, c: any, d: any) => [number, number, number, number];
    readonly grey_png: (a: any, b: any, c: any, d: any) => [number, number, number, number];
    readonly image_measurement_table: (a: any) => [number, number, number, number];
    readonly image_position: (a: any) => [number, number, number];
    readonly interior: (a: any, b: any) => [number, number, number];
    readonly join_nearest: (a: any, b: any) => [number, number, number];
    readonly local_positions: (a: any) => [number, number, number];
    readonly masks_of_images: (a: any, b: any) => [number, number, number, number];
    readonly match_described_pair: (a: number, b: number, c: any, d: any, e: any, f: any, g: any) => [number, number, number];
    readonly match_descriptors: (a: any, b: any, c: any) => [number, number, number];
    readonly match_features: (a: any, b: any, c: any, d: any, e: any) => [number, number, number];
    readonly match_guided_descriptors: (a: any, b: any, c: any, d: any, e: any, f: any) => [number, number, number];
    readonly match_pair: (a: number, b: number, c: any, d: any, e: number, f: number) => [number, number, number];
    readonly match_photos: (a: number, b: number, c: any, d: any, e: any, f: any, g: any, h: any) => [number, number, number];
    readonly match_points: (a: any, b: any, c: any, d: any, e: any, f: any) => [number, number, number];
    readonly matches_csv: (a: any, b: any) => [number, number, number, number];
    readonly message: (a: any, b: any, c: number, d: number) => [number, number, number, number];
    readonly model_points: (a: any, b: any, c: any, d: any, e: number) => [number, number, number, number];
    readonly model_points_csv: (a: any) => [number, number, number, number];
    readonly nearest_piece: (a: any, b: any, c: any, d: any) => [number, number, number];
    readonly observations: (a: any, b: any, c: any) => [number, number, number, number];
    readonly one_image: (a: any, b: any, c: any, d: any, e: any) => [number, number, number];
    readonly open_pair_project: (a: any) => [number, number, number];
    readonly orient_fiducials: (a: any, b: any) => [number, number, number];
    readonly orient_matches: (a: any, b: any, c: any, d: any, e: any) => [number, number, number];
    readonly orient_relative: (a: any, b: any, c: any, d: number) => [number, number, number];
    readonly orthomosaic_add: (a: number, b: any, c: any) => [number, number, number, number];
    readonly orthomosaic_finish: (a: number) => [number, number, number];
    readonly orthomosaic_heights: (a: number) => [number, number, number, number];
    readonly orthomosaic_leave_out: (a: number, b: any) => [number, number, number, number];
    readonly orthomosaic_names: (a: number) => [number, number];
    readonly orthomosaic_open: (a: any, b: any, c: any, d: number, e: number, f: number) => [number, number, number];
    readonly orthomosaic_order: (a: number) => [number, number];
    readonly orthomosaic_remark: (a: number) => any;
    readonly orthomosaic_size: (a: number) => [number, number];
    readonly orthophotoreference_adjust: (a: number, b: any, c: any, d: any) => [number, number, number];
    readonly orthophotoreference_colours: (a: number, b: any, c: any, d: any, e: any, f: any) => [number, number, number, number];
    readonly orthophotoreference_control_by_hand: (a: number, b: any) => [number, number, number];
    readonly orthophotoreference_elsewhere: (a: number, b: any, c: any) => [number, number, number];
    readonly orthophotoreference_ground_positions: (a: number, b: any, c: any) => [number, number, number, number];
    readonly orthophotoreference_heights_at: (a: number, b: any) => [number, number, number, number];
    readonly orthophotoreference_image_positions: (a: number, b: any, c: any) => [number, number, number, number];
    readonly orthophotoreference_info: (a: number) => any;
    readonly orthophotoreference_open: (a: any, b: any) => [number, number, number];
    readonly orthophotoreference_picture: (a: number, b: any, c: any, d: any, e: any, f: any) => [number, number, number, number];
    readonly orthophotoreference_place: (a: number, b: any, c: any, d: number, e: any, f: any) => [number, number, number];
    readonly orthophotoreference_rectified: (a: number, b: any, c: any) => [number, number, number, number];
    readonly orthophotoreference_search: (a: number, b: any) => [number, number, number];
    readonly orthophotoreference_set_heights: (a: number, b: any, c: any) => [number, number];
    readonly pair_cameras: (a: any, b: any, c: any) => [number, number, number];
    readonly pair_hint: (a: any, b: any, c: any, d: any) => [number, number, number];
    readonly pair_preset: (a: any) => [number, number, number];
    readonly pair_presets: () => any;
    readonly paper: () => any;
    readonly parallax_deviation: (a: any, b: any, c: any, d: any, e: any, f: any) => [number, number, number];
    readonly parameters: () => any;
    readonly parse_camera: (a: any) => [number, number, number];
    readonly parse_camera_rules: (a: any) => [number, number, number];
    readonly parse_fiducials: (a: any) => [number, number, number];
    readonly parse_ground_control_points: (a: any) => [number, number, number];
    readonly parse_image_measurements: (a: any, b: number) => [number, number, number];
    readonly parse_image_positions: (a: any) => [number, number, number];
    readonly parse_observations: (a: any) => [number, number, number, number];
    readonly photo_camera: (a: any) => [number, number, number];
    readonly photo_decode: (a: any) => [number, number, number];
    readonly photo_describe: (a: number, b: any, c: any, d: any) => [number, number, number, number];
    readonly photo_describe_points: (a: number, b: any, c: number) => [number, number, number];
    readonly photo_detect: (a: number, b: any, c: number) => [number, number, number];
    readonly photo_difference: (a: number, b: number) => [number, number, number];
    readonly photo_features: (a: number, b: any, c: number) => [number, number, number];
    readonly photo_from_grey: (a: any, b: any, c: any) => [number, number, number];
    readonly photo_grey: (a: number) => [number, number];
    readonly photo_height: (a: number) => number;
    readonly photo_info: (a: number) => any;
    readonly photo_reduced: (a: number, b: any) => [number, number, number];
    readonly photo_width: (a: number) => number;
    readonly photo_window_moments: (a: number, b: any, c: any, d: any) => [number, number, number];
    readonly placed_tables: (a: any, b: any) => [number, number, number];
    readonly placing_defaults: () => any;
    readonly placing_parameters: () => any;
    readonly planned_files: (a: any, b: any) => [number, number, number, number];
    readonly points_csv: (a: any) => [number, number, number, number];
    readonly positions_of_images: (a: any, b: any, c: any) => [number, number, number];
    readonly project_kind: (a: any) => [number, number, number];
    readonly read_exif: (a: any, b: any, c: any) => [number, number, number];
    readonly refused_kind: (a: any, b: any) => [number, number, number];
    readonly remarks_of_positions: (a: any, b: any) => [number, number, number];
    readonly report_html: (a: number, b: number) => [number, number, number, number];
    readonly report_new: (a: number, b: number, c: any, d: any, e: any, f: any, g: number, h: number, i: any) => [number, number, number];
    readonly report_step: (a: number) => [number, number, number];
    readonly report_steps: (a: number, b: number) => [number, number, number];
    readonly report_verdict: (a: number) => any;
    readonly resolved: (a: any) => [number, number, number];
    readonly rule_names: () => any;
    readonly run_complete: (a: number, b: number, c: any) => [number, number];
    readonly run_failed: (a: number, b: number, c: any) => [number, number];
    readonly run_finish: (a: number) => [number, number, number];
    readonly run_found: (a: number, b: number, c: any) => [number, number, number];
    readonly run_new: (a: any) => [number, number, number];
    readonly run_news: (a: number) => any;
    readonly run_next: (a: number, b: number) => [number, number, number];
    readonly run_prepare: (a: number, b: number, c: any) => [number, number, number];
    readonly scaled_interior: (a: any, b: any) => [number, number, number];
    readonly score_block: (a: any, b: any) => [number, number, number];
    readonly score_matches: (a: any, b: any, c: any, d: any, e: any, f: any, g: any) => [number, number, number];
    readonly sha256: (a: any) => [number, number, number, number];
    readonly simulate: (a: any) => [number, number, number];
    readonly system_coordinates: (a: any, b: any, c: any) => [number, number, number];
    readonly system_positions: (a: any, b: any, c: any) => [number, number, number];
    readonly throw_panics: () => void;
    readonly two_view: (a: any, b: any) => [number, number, number];
    readonly version: () => [number, number];
    readonly write_pair_project: (a: any) => [number, number, number, number];
    readonly wasm_bindgen__convert__closures_____invoke__ha83204a696ef78e9: (a: number, b: number, c: any, d: any) => [number, number, number];
    readonly __wbindgen_malloc: (a: number, b: number) => number;
    readonly __wbindgen_realloc: (a: number, b: number, c: number, d: number) => number;
    readonly __wbindgen_free: (a: number, b: number, c: number) => void;
    readonly __wbindgen_exn_store: (a: number) => void;
    readonly __externref_table_alloc: () => number;
    readonly __wbindgen_externrefs: WebAssembly.Table;
    readonly __wbindgen_destroy_closure: (a: number, b: number) => void;
    readonly __externref_table_dealloc: (a: number) => void;
    readonly __externref_drop_slice: (a: number, b: number) => void;
    readonly __wbindgen_start: () => void;
}

export type SyncInitInput = BufferSource | WebAssembly.Module;

/**
 * Instantiates the given `module`, which can either be bytes or
 * a precompiled `WebAssembly.Module`.
 *
 * @param {{ module: SyncInitInput }} module - Passing `SyncInitInput` directly is deprecated.
 *
 * @returns {InitOutput}
 */
export function initSync(module: { module: SyncInitInput } | SyncInitInput): InitOutput;

/**
 * If `module_or_path` is {RequestInfo} or {URL}, makes a request and
 * for everything else, calls `WebAssembly.instantiate` directly.
 *
 * @param {{ module_or_path: InitInput | Promise<InitInput> }} module_or_path - Passing `InitInput` directly is deprecated.
 *
 * @returns {Promise<InitOutput>}
 */
export default function __wbg_init (module_or_path: { module_or_path: InitInput | Promise<InitInput> } | InitInput | Promise<InitInput>): Promise<InitOutput>;
