/* tslint:disable */
/* eslint-disable */

/** Grey values 0..255, row by row. */
export interface SampleImage { width: number; height: number; grey: Uint8Array }

/** A simulated pair and its truth. */
export interface SamplePair {
    left: SampleImage;
    right: SampleImage;
    camera: Camera;
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
    geometry_reason: string | null;
}



/** Multi-ray points: the rays of point i are those from starts[i] to before starts[i + 1]. */
export interface RayTable {
    starts: Uint32Array;
    /** Image and feature of each ray; stride 2. */
    rays: Uint32Array;
    /** Probability, 0..1, that a ray belongs to its point. */
    ray_confidence: Float32Array;
    /** Probability, 0..1, that all rays of a point belong together. */
    confidence: Float32Array;
}

/** Points that were chosen, with the rays and the filled von Gruber places of each image. */
export interface SelectedRays { points: Uint32Array; rays_of_images: Uint32Array; places_of_images: Uint32Array }



/** Options of which any may be absent: these take their defaults. */
export type Given<T> = T extends unknown[] ? T : T extends object ? { [K in keyof T]?: Given<T[K]> } : T;

/** One tunable: `key` is its place in PairSettings, as "points.threshold". */
export type Parameter = { key: string; label: string; unit: string; help: string } & ParameterKind;

/** What an operator does where an option is absent. */
export interface OperatorDefaults { threshold: number; roundness: number; operator_window: number }

/** What every refused call throws. */
export interface TiepointError extends Error {
    name: "TiepointError";
    /** Stable for programs, as "invalid-option". */
    code: string;
    /** Whether the caller's options are at fault rather than the data. */
    usage: boolean;
}



/** Points with their descriptors. */
export interface Features {
    /** x, y and scale in px, the dominant direction in rad from x towards y, and the weight: stride 5. */
    points: Float64Array;
    /** 128 bytes a point. */
    descriptors: Uint8Array;
}



/** The known answer of a simulated pair, as `simulate` gives it. */
export interface ReportTruth { orientation: FiveParameters; base_mm: number; right_position: Float32Array }



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
    geometry_reason: string | null;
}

/** Points as matching takes them: `DescribedPoints`, or what of it the strategy needs. */
export type GivenPoints = Pick<DescribedPoints, "points"> & Partial<Pick<DescribedPoints, "frames" | "moments" | "gradients">>;


/** The outcome of a whole pair. */
export interface PairOutput extends MatchedPair {
    left: DetectedPoints;
    right: DetectedPoints;
}

/** What becomes of the points of a pair. */
export interface MatchedPair {
    /** Absent where the strategy needs none. */
    offset: OffsetField | null;
    match: MatchResult;
    interior: PairInterior | null;
    /** Side of a left pixel in mm. */
    pixel_mm: number | null;
    orientation: RelativeOrientation | null;
    /** Why there is no orientation. */
    orientation_reason: string | null;
}



/** What is known of a decoded image. */
export interface PhotoInfo { width: number; height: number; format: string; bits_per_sample: number; camera: ExifCamera | null }

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



/** Windows of an image around rays. */
export interface RayWindowTable {
    /** Of each window px. */
    side: number;
    /** Of each window the index of its ray, halvings of the image, column and row of its first pixel there; stride 4. */
    places: Uint32Array;
    /** Grey values, side x side a window, row by row. */
    grey: Uint8Array;
}



/** `TwoView` with its matches as a typed array. */
export type TwoViewResult = Omit<TwoView, "inliers"> & { inliers: Uint32Array };

/** Where a left point may be seen: a matrix of nine numbers by rows, of homogeneous positions in px. */
export type MatchGuide = { fundamental: Float64Array | number[] } | { homography: Float64Array | number[] };



export interface RelativeOrientation {
    /**
     * For each observation: residual y-parallax in mm, redundancy number, standardised residual w, minimal detectable displacement of the
     * right point across its epipolar line in mm, external reliability, weight (0 where rejected), model X, Y, Z in mm; stride 9. NaN where absent.
     */
    points: Float64Array;
}


/**
 * A block of images with approximate values, or an adjusted one.
 */
export interface Block {
    cameras: BlockCamera[];
    images: BlockImage[];
    points: BlockPoint[];
    /**
     * In any order; an image sees a point at most once.
     */
    rays: Ray[];
    control?: ControlPoint[];
}

/**
 * A block to be simulated; [`NETWORK_PARAMETERS`] tells units and ranges. Lengths are in m, the ground's mean height is 0.
 */
export interface NetworkFlight {
    kind?: NetworkKind;
    strips?: number;
    /**
     * Of a strip.
     */
    stations?: number;
    /**
     * Above the mean ground.
     */
    flying_height_m?: number;
    /**
     * Range of the heights of the relief, up to half the flying height.
     */
    relief_m?: number;
    width_px?: number;
    height_px?: number;
    focal_px?: number;
    /**
     * Overlap along the strip, as a share.
     */
    end_lap?: number;
    /**
     * Overlap between strips, as a share.
     */
    side_lap?: number;
    /**
     * Distortion of all cameras.
     */
    radial?: [number, number, number];
    tangential?: [number, number];
    /**
     * Ground points for the area of one image.
     */
    points_per_image?: number;
    /**
     * Standard deviation of an image coordinate.
     */
    noise_px?: number;
    /**
     * Share of the rays that are gross errors, up to `gross_px` in each coordinate.
     */
    gross_share?: number;
    gross_px?: number;
    /**
     * Standard deviation of a GPS coordinate; 0: no GPS.
     */
    gps_sigma_m?: number;
    /**
     * Control points, spread over the block, with `control_sigma_m`.
     */
    control_points?: number;
    control_sigma_m?: number;
    /**
     * Standard deviation of the errors of the approximate positions of images and points; angles err by as much at the
     * distance of the ground. Up to a fifth of the flying height.
     */
    approximate_m?: number;
    seed?: number;
}

/**
 * A block with what was chosen and found on the way to it.
 */
export interface Project {
    block: BlockModel;
    /**
     * The pairs that were chosen, with their outcomes.
     */
    connections: Connection[];
    joining: BlockOptions;
    selection: SelectOptions;
}

/**
 * A block: whatever is not known yet is absent.
 */
export interface BlockModel {
    cameras: ModelCamera[];
    images: ModelImage[];
    points: ModelPoint[];
    /**
     * Where on the earth the object space is; absent for a block in a system of its own.
     */
    origin?: GeographicOrigin | null;
}

/**
 * A camera before its calibration; symbols as at [`BlockCamera`](crate::BlockCamera).
 */
export interface AssemblyCamera {
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
     * What the block estimates of it, where it determines that: by default all but k3, p1 and p2.
     */
    free?: FreeParameters;
    /**
     * Side of a pixel in mm, for exports in photo coordinates.
     */
    pixel_mm?: number | null;
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
     * As in [`ModelCamera`].
     */
    radial?: [number, number, number];
    tangential?: [number, number];
    pixel_mm?: number | null;
    /**
     * Whether the block takes the camera as it is; otherwise it is calibrated from these values.
     */
    fixed?: boolean;
}

/**
 * A camera. With x = U/-W, y = -V/-W of photo = (U, V, W) = M·(X - X₀) and r² = x² + y², a point is seen at
 * col = c_x + f (x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²)), row = c_y + f (y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy).
 *
 * # Source
 * Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.
 */
export interface ModelCamera {
    width_px: number;
    height_px: number;
    focal_px: number;
    /**
     * `[c_x, c_y]` in px; the centre of the top-left pixel is (0.5, 0.5).
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
     * Side of a pixel in mm, which formats with photo coordinates need.
     */
    pixel_mm?: number | null;
}

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
 * A model: images that are oriented to each other, adjusted.
 */
export interface AssembledModel {
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
    points: AssembledPoint[];
    /**
     * What each ray of the adjusted block is.
     */
    rays: AssembledRay[];
    /**
     * Rays of its images that do not fit, left out before the bundle adjustment; their points are those of the adjusted block.
     */
    rejected: RejectedRay[];
    adjusted: BundleResult;
    /**
     * Whether it lies in the system of the observed positions; otherwise its place, turn and scale mean nothing.
     */
    in_system: boolean;
    /**
     * What is weak about it, in words.
     */
    weaknesses: string[];
}

/**
 * A multi-ray point.
 */
export interface ModelPoint {
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
     * Probability, 0..1, that its rays belong together.
     */
    confidence?: number;
    rays: ModelRay[];
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
 * A pair to be matched; its images are in ascending order.
 */
export interface ChosenPair {
    images: [number, number];
    rule: PairRule;
}

/**
 * A parameter of a camera.
 */
export type CameraParameter = "focal" | "principal_x" | "principal_y" | "k1" | "k2" | "k3" | "p1" | "p2";

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
 * A point as one image sees it.
 */
export interface Ray {
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
}

/**
 * A point in an image.
 */
export interface ModelRay {
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
 * A point of the object.
 */
export interface BlockPoint {
    position: [number, number, number];
}

/**
 * A point whose coordinates are known.
 */
export interface SurveyedPoint {
    name: string;
    /**
     * `[x, y, z]` in the unit of the file.
     */
    position: [number, number, number];
    /**
     * Standard errors of the place and of the height, above 0; absent where the file has none.
     */
    standard_errors: [number, number] | null;
}

/**
 * A point whose position was surveyed.
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
 * A position that was observed. All of a block are of the same kind; or those of its images are of one and those of three surveyed points or
 * more of the other, which alone place the block: then distances between the images are compared with the recorded ones, and it is told
 * where the surveyed points have another unit.
 */
export type ObservedPosition = { system: "local"; position: [number, number, number]; sigma: [number, number, number] } | { system: "geographic"; longitude_deg: number; latitude_deg: number; height_m?: number | null; sigma_m: [number, number, number] };

/**
 * A ray that does not fit to its point.
 */
export interface RejectedRay {
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
}

/**
 * A surveyed point as an image shows it.
 */
export interface ControlRay {
    /**
     * Index of the image.
     */
    image: number;
    /**
     * Column and row in px, inside the image; the centre of the top-left pixel is (0.5, 0.5).
     */
    x_px: number;
    y_px: number;
}

/**
 * A surveyed point as it was measured in an image.
 */
export interface ImageMark {
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
 * A surveyed point with the images in which it was measured.
 */
export interface AssemblyControl {
    name: string;
    position: ObservedPosition;
    rays: ControlRay[];
}

/**
 * An adjusted block with its precision and reliability.
 *
 * Standard errors are with σ₀ a priori where that is given, else with the estimated one; those of a free network are with respect to its
 * inner constraints.
 */
export interface BundleResult {
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
    iterations: number;
    /**
     * Root mean square of the last step in standard errors of the unknowns.
     */
    last_step: number;
    /**
     * Adjustments until the set of accepted rays had settled.
     */
    rounds: number;
    cameras: CameraStatistics[];
    images: ImageStatistics[];
    /**
     * Absent for points without accepted rays.
     */
    points: (ObjectPointStatistics | null)[];
    rays: RayStatistics[];
    /**
     * One for each control point; absent where the datum does not use it.
     */
    control: (PriorStatistics | null)[];
}

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
export interface AssemblyImage {
    /**
     * File name; no two images have the same.
     */
    name: string;
    /**
     * Index of its camera.
     */
    camera: number;
    /**
     * Where GPS has the perspective centre.
     */
    position?: ObservedPosition | null;
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
    /**
     * The same in words.
     */
    text: string;
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
    pose?: ModelPose | null;
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
 * Camera data of an EXIF block.
 */
export interface ExifCamera {
    make: string | null;
    model: string | null;
    /**
     * Focal length in mm.
     */
    focal_mm: number;
    /**
     * Side of a pixel of the stored image in mm, from the focal-plane resolution or the 35 mm equivalent; absent where neither is given.
     */
    pixel_mm: number | null;
}

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
 * Flights that are ready made.
 */
export type Preset = "sample" | "paper" | "hard" | "lively";

/**
 * How a point's position is found between the pixels.
 */
export type PointPosition = "quadratic" | "forstner";

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
     * Rays an image should have.
     */
    per_image?: number;
    /**
     * Points that a pair of images keeps in common, or as many as it has.
     */
    per_connection?: number;
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
 * How matches are joined to multi-ray points.
 */
export interface BlockOptions {
    conflicts?: Conflicts;
    /**
     * Expected share of points with a ray that does not belong to them, 0..0.5: matches join until it is reached.
     */
    impure?: number;
    /**
     * Points with fewer rays are left out, 2 or more.
     */
    min_rays?: number;
    /**
     * Share of right matches that is expected where no third image tells, above 0 and below 1.
     */
    expected_right?: number;
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
 * How rays with large residuals are weighted down until the gross errors are found.
 */
export type Loss = "squares" | "huber" | "cauchy";

/**
 * How the images of a simulated block look down.
 */
export type NetworkKind = "nadir" | "oblique" | "two_heights";

/**
 * How the photos of a block look at the ground.
 */
export type BlockView = "nadir" | "oblique" | "two-heights";

/**
 * How the rays of chosen points are refined.
 */
export type RefinementMethod = "none" | "least-squares";

/**
 * How the right point of a left one is found.
 */
export type Strategy = "moments" | "invariants" | "correlation" | "least-squares" | "gradient";

/**
 * One image.
 */
export interface BlockImage {
    /**
     * Index of its camera.
     */
    camera: number;
    /**
     * Rows of M, from object to photo; see [`rotation_from_angles`](crate::rotation_from_angles).
     */
    rotation: [[number, number, number], [number, number, number], [number, number, number]];
    /**
     * Perspective centre X₀.
     */
    position: [number, number, number];
    /**
     * Where GPS has the perspective centre.
     */
    gps?: PositionPrior | null;
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
export interface BundleOptions {
    datum?: Datum;
    loss?: Loss;
    /**
     * Reject gross errors by data snooping.
     */
    snooping?: boolean;
    /**
     * Probability α₀ with which data snooping rejects a good coordinate (Baarda 1968).
     */
    alpha0?: number;
    /**
     * Standard error of an image coordinate of weight 1 in px that was known before; absent: estimated from the residuals.
     */
    sigma0_px?: number | null;
    /**
     * A free camera parameter is fixed where its standard error moves a ray at the edge of the image by more than this, in px.
     */
    calibration_limit_px?: number;
    /**
     * Iterations that one adjustment may take.
     */
    max_iterations?: number;
    /**
     * Compute standard errors, redundancies and tests; data snooping needs them.
     */
    statistics?: boolean;
}

/**
 * Options of [`assemble_block`](crate::assemble_block).
 */
export interface AssemblyOptions {
    /**
     * What says where the block lies, in place of that of `bundle`; absent: the observed positions that suffice for it, else none.
     */
    datum?: Datum | null;
    /**
     * Rays an image has while the block grows, and in its adjustment where points are chosen: more are more precise, fewer are faster.
     */
    growing_rays?: number;
    /**
     * Least number of rays that agree on the orientation of an image.
     */
    least_rays?: number;
    /**
     * Least angle in degrees between two rays of a point.
     */
    least_angle_deg?: number;
    /**
     * Largest residual of a ray in px while the block grows; it follows the residuals down from there.
     */
    largest_residual_px?: number;
    /**
     * Standard error of a coordinate of a mark, where an image shows a surveyed point, in px.
     */
    mark_sigma_px?: number;
    /**
     * The points that are given of the adjusted block; absent: all are adjusted and given.
     */
    selection?: SelectOptions | null;
    /**
     * Models that are given at most where the block falls apart, the largest first.
     */
    most_models?: number;
    /**
     * Start of the random numbers.
     */
    seed?: number;
    /**
     * By default as [`BundleOptions`] is, but that camera parameters are fixed beyond 20 px.
     */
    bundle?: BundleOptions;
}

/**
 * Options of [`detect`](crate::detect). What is absent takes the operator's own default; all but the operator is of those that look at one
 * scale.
 */
export interface PointOptions {
    operator: Operator;
    /**
     * Moravec: sum of squared grey differences. Förstner: factor of the mean weight. Ground: grey difference. Absent, as is
     * `fraction`: the operator's default, lowered where it leaves less than 5 % of the pixels as candidates.
     */
    threshold: number | null;
    /**
     * Instead of a threshold: the share of all pixels that are to be candidates, 0..1.
     */
    fraction: number | null;
    /**
     * Least roundness q (Förstner, ground 2), 0..1.
     */
    roundness: number | null;
    /**
     * Side of the operator's window in px (Moravec 4 or 8, Förstner 5 or 7; any from 2 or 3 up is taken).
     */
    operator_window: number | null;
    /**
     * Moravec: windows side by side in place of one at each pixel.
     */
    tiled: boolean;
    /**
     * Side of the suppression window in px, odd; 1 suppresses nothing.
     */
    suppression_window: number;
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
     * The grid's rows lie along the image's: for images that are not rotated against each other.
     */
    upright: boolean;
    /**
     * Most dominant directions of a point, each of which gets its own descriptor.
     */
    orientations: number;
    /**
     * Side of one of the 4 x 4 cells, in scales of the point.
     */
    cell: number;
    /**
     * Square roots of the histogram are compared.
     */
    roots: boolean;
}

/**
 * Options of [`guided_matches`].
 */
export interface GuidedOptions {
    /**
     * Largest distance from the line or the place in px.
     */
    radius_px: number;
    /**
     * As that of [`NearestOptions`], among the candidates.
     */
    ratio: number;
    /**
     * Largest distance of two descriptors; absent: any.
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
     * Most points.
     */
    number: number;
    /**
     * Levels of an octave of the pyramid, in which the scale doubles.
     */
    levels: number;
    /**
     * Least contrast of a point, the root of its response, in grey values.
     */
    contrast: number;
    /**
     * Least roundness q of the Förstner tensor at a point, 0..1; the determinant of the Hessian refuses most edges by itself.
     */
    roundness: number;
    /**
     * Cells on the image's longer side of the grid over which half of the points are distributed equally; 1 chooses the most distinct.
     */
    cells: number;
    position: PointPosition;
}

/**
 * Options of [`nearest_matches`].
 */
export interface NearestOptions {
    /**
     * A match is ambiguous, and none, unless its distance is below this share of that of the second nearest (0 to 1; 1: no test but that
     * it is nearer).
     */
    ratio: number;
    /**
     * Whether the left descriptor must be the nearest of the right one too.
     */
    mutual: boolean;
    /**
     * Largest distance of two descriptors; absent: any.
     */
    largest_distance: number | null;
}

/**
 * Options of [`orient_relative`](crate::orient_relative).
 */
export interface OrientationOptions {
    method: OrientationMethod;
    /**
     * Start from the consensus of minimal samples and reject gross errors.
     */
    robust: boolean;
    /**
     * Probability α₀ with which data snooping rejects a good observation: 0.001 rejects beyond 3.29 standard errors (Baarda 1968).
     */
    alpha0: number;
    /**
     * Probability β₀ with which a blunder of the minimal detectable size is found.
     */
    beta0: number;
    weighting: Weighting;
    /**
     * Standard error of a photo coordinate of weight 1 in mm that was known before; absent: estimated from the residuals. Observations are
     * rejected by it, or by the estimated one where that is larger.
     */
    sigma0_mm: number | null;
    /**
     * Start of the random numbers.
     */
    seed: number;
    /**
     * Photo base b in mm; absent: the median x-parallax of the accepted observations.
     */
    base_mm: number | null;
}

/**
 * Options of [`two_view`](crate::two_view).
 */
export interface TwoViewOptions {
    /**
     * The cameras; absent: nothing is known of them. Both or neither.
     */
    left: Pinhole | null;
    right: Pinhole | null;
    /**
     * Largest distance of a good match from the geometry in px; absent: it follows from the precision of the matches.
     */
    threshold_px: number | null;
    /**
     * Bound of the threshold that follows from the matches, in px.
     */
    largest_threshold_px: number;
    /**
     * Probability of drawing at least one sample of good matches only.
     */
    confidence: number;
    /**
     * Most samples that are drawn.
     */
    max_samples: number;
    /**
     * Start of the random numbers.
     */
    seed: number;
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
    placing: PlacingOptions;
    block: BlockOptions;
    selection: SelectOptions;
    refinement: RefinementOptions;
}

/**
 * Options of the matching.
 */
export interface MatchOptions {
    strategy: Strategy;
    refine: Refinement;
    /**
     * Once the pair is oriented, matches again along the epipolar lines, until nothing changes; gradients always do, once.
     */
    epipolar: boolean;
    denominator: Denominator;
    /**
     * Side of the search window in px, odd.
     */
    search: number;
    /**
     * The best measure must be below this.
     */
    max_measure: number;
    /**
     * Refused when the best measure exceeds this share of the second best, 0..1; absent: 0.9, for gradients 0.8.
     */
    ambiguity: number | null;
    /**
     * Number of nearest matches that give the expected y-parallax; 0 switches the rule off.
     */
    parallax_neighbours: number;
    /**
     * Least deviation of the y-parallax that is refused, in px.
     */
    parallax_tolerance: number;
    /**
     * Side of the window whose grey values are compared by correlation and least squares matching, in px, odd.
     */
    template: number;
    /**
     * Least correlation coefficient of a match by grey values, -1..1.
     */
    min_correlation: number;
    /**
     * Refuses a match whose right window correlates better with another place in the left image, or whose right descriptor is nearer to
     * another left one.
     */
    left_right: boolean;
    /**
     * Largest standard error of a right position found by least squares matching, in px.
     */
    max_standard_error: number;
    /**
     * Gradients: leaves out what lies at the same place of both frames, as the film's border, fiducial marks and data strip.
     */
    without_frame: boolean;
}

/**
 * Options of the window around a point.
 */
export interface WindowOptions {
    /**
     * Side in px, odd.
     */
    side: number;
    shape: WindowShape;
    brightness: Brightness;
}

/**
 * Parameters of a simulated pair; [`FLIGHT_PARAMETERS`] tells their units and ranges. The default is the paper's geometry over a town.
 */
export interface Flight {
    focal_mm: number;
    principal_x_mm: number;
    principal_y_mm: number;
    distortion: number;
    pixel_mm: number;
    flying_height_m: number;
    base_mm: number;
    width_px: number;
    height_px: number;
    omega_deg: number;
    phi_deg: number;
    kappa_deg: number;
    by_mm: number;
    bz_mm: number;
    left_omega_deg: number;
    left_phi_deg: number;
    left_kappa_deg: number;
    relief_m: number;
    buildings: number;
    lowest_building_m: number;
    highest_building_m: number;
    trees: number;
    river_m: number;
    driven_m: number;
    psf_px: number;
    right_blur_px: number;
    noise_grey: number;
    grain_grey: number;
    grain_px: number;
    gain: number;
    offset_grey: number;
    haze: number;
    fiducial_noise_px: number;
    seed: number;
}

/**
 * Precision of a camera.
 */
export interface CameraStatistics {
    /**
     * Of f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂; absent for what was not estimated.
     */
    standard_errors: [number | null, number | null, number | null, number | null, number | null, number | null, number | null, number | null];
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
     * Of its GPS position, where the datum uses it.
     */
    gps: PriorStatistics | null;
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
}

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
 * Standard errors in m of recorded positions and surveyed points that state none.
 */
export interface PlacingOptions {
    /**
     * Of east and of north of a recorded position.
     */
    receiver_across_m: number;
    /**
     * Of its height.
     */
    receiver_up_m: number;
    /**
     * Of x and of y of a surveyed point.
     */
    surveyed_across_m: number;
    /**
     * Of its height.
     */
    surveyed_up_m: number;
}

/**
 * The camera of one or more images.
 *
 * With x = -U/W, y = V/W of photo = (U, V, W), so that y goes down as rows do, and r² = x² + y²:
 * col = c_x + f (x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy + p₂(r² + 2x²)), row = c_y + f (y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy).
 *
 * # Source
 * Brown 1971, Close-range camera calibration, in the direction from object to image, as OpenCV and COLMAP write it.
 */
export interface BlockCamera {
    /**
     * Principal distance f in px, 1 to 10,000,000; in mm it is this times the side of a pixel.
     */
    focal_px: number;
    /**
     * Principal point `[col, row]` in px; the centre of the top-left pixel is (0.5, 0.5).
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
     * What the adjustment estimates.
     */
    free?: FreeParameters;
}

/**
 * The cameras and images of a block with whatever positions were observed.
 */
export interface BlockDescription {
    cameras: AssemblyCamera[];
    images: AssemblyImage[];
    control?: AssemblyControl[];
}

/**
 * The constants of a camera.
 */
export interface Camera {
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
     * `[k1, k2, k3]` in mm⁻², mm⁻⁴, mm⁻⁶: see [`Interior::photo_mm`].
     */
    radial_distortion?: [number, number, number];
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
     * With σ₀ a priori where that is given; else with the estimated σ₀, and absent without redundancy.
     */
    standard_errors: FiveParameters | null;
    /**
     * The same with what makes observations depend on each other: the errors of the interior orientations, and what neighbouring matches
     * share. They are no less than the others; absent where neither is known.
     */
    total_standard_errors: FiveParameters | null;
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
    weaknesses: Weakness[];
    /**
     * Standard error ellipse of by and bz in mm, with what the interior orientations add where that is known.
     */
    base_ellipse_mm: ErrorEllipse | null;
    /**
     * Corrections `[vx_left, vy_left, vx_right, vy_right]` in mm of every observation, the rejected ones included.
     */
    residuals_mm: [number, number, number, number][];
    /**
     * Indices of the observations that were left out as gross errors.
     */
    rejected: number[];
}

/**
 * The exterior orientation of an image.
 */
export interface ModelPose {
    /**
     * Rows of M, from object to photo, x right, y up, against the view: photo = M·(X - X₀).
     */
    rotation: [[number, number, number], [number, number, number], [number, number, number]];
    /**
     * X₀, in m where the object space has a scale.
     */
    position: [number, number, number];
}

/**
 * The geometry of two views: [`two_view`](crate::two_view).
 */
export interface TwoView {
    model: TwoViewModel;
    /**
     * The matches that agree with the model, in ascending order.
     */
    inliers: number[];
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
     * `[k1, k2, k3]` in mm⁻², mm⁻⁴, mm⁻⁶.
     */
    radial_distortion: [number, number, number];
    /**
     * Covariance of the three parameters of a row, the same for both rows, which are independent; absent where it is not known.
     */
    covariance?: [[number, number, number], [number, number, number], [number, number, number]] | null;
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
}

/**
 * The models of a block, the one with most images first, and the images that are in none.
 */
export interface Assembly {
    models: AssembledModel[];
    unoriented: UnorientedImage[];
    /**
     * Where (0, 0, 0) of the models that lie in the system of geographic positions is.
     */
    origin: GeographicOrigin | null;
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
 * The oriented part of an exchanged block, as an adjustment takes it.
 */
export interface OrientedPart {
    block: Block;
    /**
     * The image of the exchanged block that each image is.
     */
    images: number[];
    /**
     * The point of the exchanged block that each point is.
     */
    points: number[];
}

/**
 * The parameters of a camera that the adjustment estimates, where the block determines them; the others stay as they are given.
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
 * The published interest operators, and points of many scales.
 */
export type Operator = "moravec" | "forstner" | "ground1" | "ground2" | "multiscale";

/**
 * The rule that decided on a left point.
 */
export type Rule = "matched" | "no_descriptor" | "no_candidate" | "threshold" | "ambiguous" | "many_to_one" | "parallax" | "border" | "left_right" | "not_converged" | "imprecise" | "frame";

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
 * The transformation from pixels to photo coordinates.
 */
export type FiducialModel = "affine" | "similarity";

/**
 * The window's outline.
 */
export type WindowShape = "square" | "circle";

/**
 * What a point of an adjusted block is.
 */
export type AssembledPoint = { multi_ray: number } | { control: number };

/**
 * What a ray of an adjusted block is.
 */
export interface AssembledRay {
    /**
     * Index of the feature in its image; absent for a ray to a surveyed point.
     */
    feature: number | null;
    /**
     * Probability, 0..1, that it belongs to its point, as the matches have it.
     */
    confidence: number;
}

/**
 * What an exchanged camera has beside its calibration.
 */
export interface CameraLabel {
    width_px: number;
    height_px: number;
    /**
     * Side of a pixel in mm.
     */
    pixel_mm?: number | null;
}

/**
 * What became of a ray.
 */
export type RayOutcome = "reference" | "refined" | "not_converged" | "left_image" | "moved_too_far" | "low_correlation" | "no_texture" | "inconsistent";

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
     * Rays that too few of the other rays of their point confirm.
     */
    cut_rays: number;
    /**
     * Points of too few rays, points beyond the allowed share of impure ones, and points in conflict where these are dropped.
     */
    dropped_points: number;
    dropped_rays: number;
    reliability: MatchReliability;
}

/**
 * What came of matching a pair.
 */
export type PairOutcome = { kind: "waiting" } | { kind: "connected"; matches: number } | { kind: "too_few_matches"; matches: number; needed: number } | { kind: "not_oriented"; matches: number; reason: string } | { kind: "failed"; reason: string };

/**
 * What is done to the matches of any strategy.
 */
export type Refinement = "none" | "least-squares";

/**
 * What is done with matches that would give a point two rays in one image.
 */
export type Conflicts = "resolve" | "drop";

/**
 * What is flown, seen and matched. Units are in the names.
 */
export interface BlockFlight {
    view?: BlockView;
    strips?: number;
    /**
     * Exposures of a strip.
     */
    exposures?: number;
    forward_overlap?: number;
    side_overlap?: number;
    width_px?: number;
    height_px?: number;
    pixel_mm?: number;
    flying_height_m?: number;
    relief_m?: number;
    /**
     * Features an image has on average, of which `clutter` show no point that another image shows.
     */
    features?: number;
    clutter?: number;
    /**
     * Probability that a feature that two images have is matched between them.
     */
    matched?: number;
    /**
     * Share of wrong matches, and the share of these that join the same two places again and again, as repeated structures do.
     */
    wrong?: number;
    repeated?: number;
    /**
     * Standard deviation of a feature's coordinate.
     */
    noise_px?: number;
    /**
     * Standard deviation of each coordinate of a position that the receiver records.
     */
    receiver_m?: number;
    /**
     * Houses and trees on a km² of a photographed scene, where lots and gardens are left for them.
     */
    buildings?: number;
    trees?: number;
    seed?: number;
}

/**
 * What is known of a pair beside its grey values.
 */
export interface PairInput {
    /**
     * The camera of both images; absent: that of their EXIF.
     */
    camera: Camera | null;
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
 * What is minimised.
 */
export type OrientationMethod = "rigorous" | "determinant";

/**
 * What makes an orientation weak although it could be computed.
 */
export type Weakness = "plane" | "clustered" | "rotation" | "ill_conditioned";

/**
 * What relates the views; matrices by rows, of homogeneous positions in px and of norm 1.
 */
export type TwoViewModel = { kind: "calibrated"; fundamental: [[number, number, number], [number, number, number], [number, number, number]]; rotation: [[number, number, number], [number, number, number], [number, number, number]]; base: [number, number, number] } | { kind: "fundamental"; fundamental: [[number, number, number], [number, number, number], [number, number, number]] } | { kind: "homography"; homography: [[number, number, number], [number, number, number], [number, number, number]] } | { kind: "rotation"; homography: [[number, number, number], [number, number, number], [number, number, number]]; rotation: [[number, number, number], [number, number, number], [number, number, number]] };

/**
 * What says where the block lies in object space.
 */
export type Datum = "free" | "gps" | "control" | "gps_and_control";

/**
 * What the EXIF of an image tells beside its pixels; what it does not tell is absent.
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
}

/**
 * What the adjustment says of an observed position; 0 for a coordinate that was not observed.
 */
export interface PriorStatistics {
    /**
     * Whether it took part; otherwise it lies too far from where the other observations have it.
     */
    accepted: boolean;
    /**
     * Observed minus adjusted.
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
}

/**
 * What the adjustment says of one ray, accepted or not.
 */
export interface RayStatistics {
    verdict: RayVerdict;
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
}

/**
 * What the difference of two moments is divided by.
 */
export type Denominator = "maxabs" | "floor";

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
     * Shares of the triangles over a right match that close, that stay open, and that miss a side.
     */
    triangles_right: [number, number, number];
    /**
     * The same over a wrong match, which closes them by chance or by repetition.
     */
    triangles_wrong: [number, number, number];
    /**
     * Matches about which a third image says something.
     */
    observed: number;
}

/**
 * What two points are compared by.
 */
export type Measure = "dm" | "di";

/**
 * What values a parameter takes.
 */
export type ParameterKind = { kind: "integer"; min: number; max: number; odd: boolean } | { kind: "real"; min: number; max: number } | { kind: "choice"; values: string[] } | { kind: "flag" };

/**
 * Whether and how rays are refined before the block is oriented.
 */
export interface RefinementOptions {
    method?: RefinementMethod;
    /**
     * Rays an image that are refined at least; the block is oriented by these.
     */
    per_image?: number;
    /**
     * Side of the windows in px, odd, of the image or of a reduced one by the scale of the point.
     */
    window?: number;
    /**
     * How far a ray may move, in multiples of its scale.
     */
    farthest?: number;
    /**
     * Correlation of the matched windows at least, 0..1.
     */
    least_correlation?: number;
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
     * Absent: all pairs of few images; of more, near ones where each image has a position, else those alike.
     */
    rule: PairRule | null;
    /**
     * The so many nearest ones of each image.
     */
    near: number;
    /**
     * The so many that follow each image.
     */
    sequence: number;
    /**
     * The so many most similar ones of each image.
     */
    alike: number;
    /**
     * A pair is connected by so many verified matches.
     */
    least_matches: number;
}

/**
 * Why a pair was chosen.
 */
export type PairRule = "all" | "near" | "sequence" | "alike";

/**
 * Why a ray takes part, or does not.
 */
export type RayVerdict = "accepted" | "gross_error" | "behind" | "lost_point";

/**
 * Why an image is not oriented.
 */
export type UnorientedReason = { kind: "no_points" } | { kind: "too_few_points"; points: number; needed: number } | { kind: "no_agreement"; agreeing: number; points: number; needed: number } | { kind: "narrow"; agreeing: number } | { kind: "no_partner" } | { kind: "lost"; rays: number } | { kind: "undetermined"; rays: number };

/**
 * Why the general geometry is not determined.
 */
export type Degeneracy = "plane" | "pure-rotation";


/**
 * The features and matches of a block in wasm memory, and the points made of them. Call `free` when it is no longer needed.
 *
 * First every image with `set_image`, then every pair with `add_pair`, in any order each, then `join`.
 */
export class BlockPoints {
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Takes the matches of two images: the features of each match (stride 2), and how strong it is.
     */
    add_pair(first: number, second: number, indices: Uint32Array | number[], strengths: Float32Array | number[]): void;
    /**
     * Orients the images and adjusts the block. `model` is the largest of its models as a block that is exchanged; null without one.
     */
    assemble(description: BlockDescription, options: Given<AssemblyOptions>): { assembly: Assembly; model: BlockModel | null };
    /**
     * Joins the matches to multi-ray points, in place of those made before.
     */
    join(options: Given<BlockOptions>): JoinCounts;
    /**
     * The block with these of its points, before any of it is oriented.
     */
    model(description: BlockDescription, chosen: Uint32Array | number[]): BlockModel;
    /**
     * A block of these of the points alone, with their rays at these positions x, y in px (stride 2, in the order of points and rays).
     */
    moved(chosen: Uint32Array | number[], positions: Float32Array | number[]): BlockPoints;
    /**
     * A block of images with these numbers of features.
     */
    constructor(counts: Uint32Array | number[]);
    /**
     * How many points have 2, 3, 4, … rays, from 0 rays on.
     */
    ray_histogram(): Uint32Array;
    /**
     * Chooses few points, well distributed.
     */
    select(options: Given<SelectOptions>): SelectedRays;
    /**
     * Takes the size of an image in px and the positions x, y of its features in px (stride 2).
     */
    set_image(image: number, width_px: number, height_px: number, positions: Float32Array | number[]): void;
    /**
     * For each two images with points in common: both and how many; stride 3.
     */
    shared(): Uint32Array;
    /**
     * All points.
     */
    table(): RayTable;
    /**
     * How many points there are.
     */
    readonly count: number;
    /**
     * How many rays they have together.
     */
    readonly ray_count: number;
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
     * Takes a photo.
     */
    photo(index: number): SampleImage;
    /**
     * Longitude and latitude in degrees and height in m as the receiver recorded them.
     */
    recorded_position(index: number): Float64Array;
    /**
     * Places x, y, z in m on the first surface that a photo sees at positions x, y in px (stride 2); stride 3.
     */
    surface_at(index: number, positions: Float64Array | number[]): Float64Array;
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
 * A grey image in wasm memory. Call `free` when it is no longer needed.
 */
export class Photo {
    private constructor();
    free(): void;
    [Symbol.dispose](): void;
    /**
     * Decodes a JPEG, PNG, TIFF, BMP, PNM or WebP file.
     */
    static decode(bytes: Uint8Array | number[]): Photo;
    /**
     * Describes points (stride 3) by the seven numbers each that a strategy compares; NaN where a window leaves the image or is constant.
     * Empty for the strategies that compare grey values.
     */
    describe(point_list: Float64Array | number[], window: Given<WindowOptions>, strategy: Strategy): Float64Array;
    /**
     * Finds interest points and describes them as the strategy of the settings needs it.
     */
    describe_points(settings: Given<PairSettings>, mask?: Uint8Array | number[] | null): DescribedPoints;
    /**
     * Finds interest points by the groups `points` and `multiscale` of the settings. Points whose pixel is 0 in the mask, of the image's size
     * and row by row, are left out.
     */
    detect(settings: Given<PairSettings>, mask?: Uint8Array | number[] | null): DetectedPoints;
    /**
     * Finds points distinct in position and scale and describes them by the gradients around them. Points whose pixel is 0 in the mask,
     * of the image's size and row by row, are left out.
     */
    features(options: Given<FeatureOptions>, mask?: Uint8Array | number[] | null): Features;
    /**
     * Takes grey values 0..255, row by row.
     */
    static from_grey(width: number, height: number, grey: Uint8Array | number[]): Photo;
    /**
     * A copy of the grey values, row by row.
     */
    grey(): Uint8Array;
    /**
     * Size, format and camera.
     */
    info(): PhotoInfo;
    /**
     * Cuts windows around rays: x, y and scale in px; stride 3.
     */
    ray_windows(rays: Float64Array | number[], options: Given<RefinementOptions>): RayWindowTable;
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
     * The page, which holds everything it shows. Does the steps that are left.
     */
    html(): string;
    /**
     * Takes copies of both images; `names` are what the report calls them. Points whose pixel is 0 in the mask of their image, of its size
     * and row by row, are left out.
     */
    constructor(left: Photo, right: Photo, names: [string, string], input: Given<PairInput>, settings: Given<PairSettings>, truth: ReportTruth | null, left_mask?: Uint8Array | number[] | null, right_mask?: Uint8Array | number[] | null);
    /**
     * Does the next step; false when all were done.
     */
    step(): boolean;
    /**
     * What each step does, in their order.
     */
    steps(): string[];
}

/**
 * The ambiguity ratio of each strategy where none is chosen.
 */
export function ambiguity_defaults(): Record<Strategy, number>;

/**
 * The defaults of the options of the assembly.
 */
export function assembly_defaults(): AssemblyOptions;

/**
 * Every tunable of the assembly and of the bundle adjustment.
 */
export function assembly_parameters(): Parameter[];

/**
 * The default flight of a block.
 */
export function block_flight_defaults(): BlockFlight;

/**
 * Every parameter of a block's flight with label, unit, range and help.
 */
export function block_flight_parameters(): Parameter[];

/**
 * Every tunable of a block's pairs, of multi-ray points and of the choice among them.
 */
export function block_parameters(): Parameter[];

/**
 * All settings of a block: those given, the others from the defaults. Values of pairs, points and selection outside their ranges are refused.
 */
export function block_settings(given: Given<BlockSettings>): BlockSettings;

/**
 * For each name of an image the index of the first rule that it fits, -1 without one.
 */
export function camera_rules_of(rules: CameraRule[], names: string[]): Int32Array;

/**
 * The candidates of one left point, the best first: index of the right point and measure, stride 2.
 */
export function candidates(index: number, left_points: Float64Array | number[], left_descriptors: Float64Array | number[], right_points: Float64Array | number[], right_descriptors: Float64Array | number[], offset: OffsetField, options: Given<MatchOptions>): Float64Array;

/**
 * Refuses what is known of a block where no block can be so, before its images are matched.
 */
export function check_block_description(description: BlockDescription): void;

/**
 * Refuses a flight that [`simulate`] refuses, without rendering it; parameters that are absent are those of the sample.
 */
export function check_flight(flight: Given<Flight>): void;

/**
 * The pairs of a block that are tried, each once: `positions` as in `pair_rule`; `similar`: two images and their similarity; stride 3.
 */
export function choose_pairs(positions: Float64Array | number[], similar: Float64Array | number[], choice: Given<PairChoice>): ChosenPair[];

/**
 * The same offset (right minus left position, px) everywhere.
 */
export function constant_offset(dx: number, dy: number): OffsetField;

/**
 * Writes a field of a table between commas, in quotation marks where it needs them.
 */
export function csv_field(text: string): string;

/**
 * The defaults of all options.
 */
export function defaults(): PairSettings;

/**
 * Draws the lines of matches whose two ends are both in view, from the left image's view to the right one's; returns how many.
 *
 * `matches`: stride 5, `x left, y left, x right, y right, measure` in px. `codes`: one a match, the index of its style; a code without
 * a style is not drawn. `widths` and `colours`: one a style. Where more than `most` are in view, evenly many are drawn.
 */
export function draw_match_lines(context: CanvasRenderingContext2D, matches: Float64Array | number[], codes: Uint8Array | number[], widths: Float64Array | number[], colours: string[], left_view: Float64Array | number[], right_view: Float64Array | number[], most: number): number;

/**
 * Draws points; returns how many were drawn.
 *
 * `points`: stride 3, `x, y, value` in px. `codes`: one a point, the index of its style; a code without a style is not drawn.
 * `styles`: stride 3, `shape, half size, line width` in canvas units (shapes: 0 dot, 1 circle, 2 plus, 3 cross, 4 square,
 * 5 triangle up, 6 triangle down, 7 diamond). `colours`: one CSS colour a style. `view`: see [`View::new`]. Styles are drawn in order,
 * the last on top; where points crowd, some are left out.
 */
export function draw_points(context: CanvasRenderingContext2D, points: Float64Array | number[], codes: Uint8Array | number[], styles: Float64Array | number[], colours: string[], view: Float64Array | number[]): number;

/**
 * Draws vectors as arrows from their points, enlarged `factor` times; returns how many.
 *
 * `vectors`: stride 4, `x, y, dx, dy` in px of the image. `codes`: one a vector, the index of its style; a code without a style is not drawn.
 * `widths` and `colours`: one a style.
 */
export function draw_vectors(context: CanvasRenderingContext2D, vectors: Float64Array | number[], codes: Uint8Array | number[], widths: Float64Array | number[], colours: string[], factor: number, view: Float64Array | number[]): number;

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
 * The interior orientations of a pair whose focal length only the matches tell; null where they do not tell it to a tenth. Sizes in px.
 */
export function estimated_interior(focal: FocalEstimate | null, left_width: number, left_height: number, right_width: number, right_height: number): PairInterior | null;

/**
 * Why the pairs of a block are or are not connected, in words, in their order; and the groups of connected images, the largest first.
 */
export function explain_connections(images: number, connections: Connection[]): { reasons: string[]; groups: number[][] };

/**
 * Writes a block in one format: `emit` is called with the path, relative to a folder, and the text of each file in turn.
 */
export function export_block(model: BlockModel, format: ExportFormat, emit: (path: string, text: string) => void): void;

/**
 * The names of the formats that blocks are written in.
 */
export function export_formats(): ExportFormat[];

/**
 * The defaults of the options of features.
 */
export function feature_defaults(): FeatureOptions;

/**
 * Every tunable of features with label, unit, range and help.
 */
export function feature_parameters(): Parameter[];

/**
 * Every parameter of a flight with label, unit, range and help.
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
 * Every tunable of matching by descriptors and of two-view geometry.
 */
export function geometry_parameters(): Parameter[];

/**
 * The right points in the order of their distance from the left one of an index, up to `most`: index and measure, stride 2.
 */
export function gradient_candidates(index: number, left_gradients: Uint8Array | number[], right_gradients: Uint8Array | number[], most: number): Float64Array;

/**
 * Positions in px (stride 2) freed of a camera's distortion; NaN where it folds the image, so that it has no inverse.
 */
export function ideal_positions(camera: ModelCamera, positions: Float64Array | number[]): Float64Array;

/**
 * The interior orientation of an image: from its fiducials, or from the camera's pixel size.
 */
export function interior(camera: Camera, photo: PhotoGeometry): Interior;

/**
 * The matches of pieces that follow each other from the first left descriptor to the last: those of the whole, whatever the pieces.
 */
export function join_nearest(pieces: NearestPiece[], options: Given<NearestOptions>): DescriptorMatches;

/**
 * Positions in m east, north and up of the first known one: of longitude, latitude in degrees and height in m (stride 3), NaN where not known.
 */
export function local_positions(geographic: Float64Array | number[]): Float64Array;

/**
 * Matches and orients two photos whose points are described: the rest of `match_pair`. For the strategy gradient the nearest descriptors may
 * have been searched for already: the pieces that `nearest_piece` made of all left points, in their order.
 */
export function match_described_pair(left: Photo, right: Photo, left_points: GivenPoints, right_points: GivenPoints, input: Given<PairInput>, settings: Given<PairSettings>, nearest?: NearestPiece[]): MatchedPair;

/**
 * Matches byte descriptors of 128 bytes each: exact nearest neighbours, the ratio to the second nearest, the same from both sides.
 */
export function match_descriptors(left: Uint8Array | number[], right: Uint8Array | number[], options: Given<NearestOptions>): DescriptorMatches;

/**
 * Matches the features of two images (positions x, y in px, stride 2; 128 bytes each) by nearest descriptors, verified by the geometry of
 * the two views and completed along its lines. Where `options.geometry` names cameras, positions are those of cameras without distortion.
 */
export function match_features(left_positions: Float64Array | number[], left_descriptors: Uint8Array | number[], right_positions: Float64Array | number[], right_descriptors: Uint8Array | number[], options: Given<FeatureMatchOptions>): VerifiedMatches;

/**
 * Matches byte descriptors near the epipolar line, or the place, of each left point: positions x, y in px (stride 2), 128 bytes each.
 */
export function match_guided_descriptors(left_positions: Float64Array | number[], left_descriptors: Uint8Array | number[], right_positions: Float64Array | number[], right_descriptors: Uint8Array | number[], guide: MatchGuide, options: Given<GuidedOptions>): DescriptorMatches;

/**
 * Matches and orients a pair on one thread. Points whose pixel is 0 in the mask of their image, of its size and row by row, are left out.
 */
export function match_pair(left: Photo, right: Photo, input: Given<PairInput>, settings: Given<PairSettings>, left_mask?: Uint8Array | number[] | null, right_mask?: Uint8Array | number[] | null): PairOutput;

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
export function match_points(left_points: Float64Array | number[], left_descriptors: Float64Array | number[], right_points: Float64Array | number[], right_descriptors: Float64Array | number[], offset: OffsetField, options: Given<MatchOptions>): MatchResult;

/**
 * Writes matches (stride 5) as CSV.
 */
export function matches_csv(matches: Float64Array | number[]): string;

/**
 * The nearest right descriptors of left ones from `first` to before `end`: a piece of the work, for `join_nearest` and
 * `match_photos`.
 */
export function nearest_piece(left: Uint8Array | number[], first: number, end: number, right: Uint8Array | number[]): NearestPiece;

/**
 * Photo coordinates x, y left, x, y right in mm (stride 4) of matches (stride 5).
 */
export function observations(matches: Float64Array | number[], left: Interior, right: Interior): Float64Array;

/**
 * The defaults of each operator for the options that are absent by default.
 */
export function operator_defaults(): Record<Operator, OperatorDefaults>;

/**
 * Interior orientation by fiducial marks.
 */
export function orient_fiducials(fiducials: Fiducial[], model: FiducialModel): FiducialOrientation;

/**
 * Relative orientation from matches (stride 5) with what least squares matching found of them (stride 5, as `MatchResult.fits`; empty: all
 * of weight 1). The total standard errors hold those of the interior orientations, where these have covariances.
 */
export function orient_matches(matches: Float64Array | number[], fits: Float64Array | number[], interior: PairInterior, options: Given<OrientationOptions>): RelativeOrientation;

/**
 * Relative orientation of observations x, y left, x, y right in mm (stride 4), each of its weight, or all of weight 1.
 */
export function orient_relative(observations: Float64Array | number[], focal_mm: number, options: Given<OrientationOptions>, weights?: Float64Array | number[] | null): RelativeOrientation;

/**
 * The rule that chooses the pairs of a block. `positions`: x, y, z in m of each image, NaN where it has none; stride 3.
 */
export function pair_rule(positions: Float64Array | number[], choice: Given<PairChoice>): PairRule;

/**
 * Every tunable with label, unit, range and help, in the order of the pipeline.
 */
export function parameters(): Parameter[];

/**
 * Reads a camera: {"focal_mm", "principal_point_mm", "pixel_mm", "radial_distortion"}.
 */
export function parse_camera(json: string): Camera;

/**
 * Reads cameras that hold for the images whose names fit a pattern.
 */
export function parse_camera_rules(json: string): CameraRule[];

/**
 * Reads fiducial marks: columns col, row, x_mm, y_mm.
 */
export function parse_fiducials(csv: string): Fiducial[];

/**
 * Reads where images show surveyed points: lines of image, point, x, y in px.
 */
export function parse_image_marks(text: string): ImageMark[];

/**
 * Reads photo coordinates: columns x_left_mm, y_left_mm, x_right_mm, y_right_mm; stride 4.
 */
export function parse_observations(csv: string): Float64Array;

/**
 * Reads surveyed points: lines of name, x, y, z and perhaps two standard errors.
 */
export function parse_surveyed_points(text: string): SurveyedPoint[];

/**
 * A block's camera as a photo of a pair has it: lengths in mm, the radial distortion as a correction of what was measured.
 */
export function photo_camera(camera: ModelCamera): Camera;

/**
 * Writes points (stride 3) as CSV.
 */
export function points_csv(points: Float64Array | number[]): string;

/**
 * What can become of a ray that is refined, in the order of its codes.
 */
export function ray_outcomes(): RayOutcome[];

/**
 * What EXIF tells of an image of this size beside its pixels.
 */
export function read_exif(file: Uint8Array | number[], width: number, height: number): ExifImage;

/**
 * Reads a project; a file that is damaged or of another kind is refused whole.
 */
export function read_project(bytes: Uint8Array | number[]): Project;

/**
 * Refines the rays of points by their windows. The rays of point i are those from `starts[i]` to before `starts[i + 1]`, each with x, y and
 * scale in px and direction in rad (stride 4); `places` and `grey` as `ray_windows` gives them, their rays counted from 0 over all points.
 *
 * Of each ray the place of its outcome among `ray_outcomes`, x, y, the standard error in px and the correlation (NaN where it was not
 * refined); stride 5.
 */
export function refine_points(starts: Uint32Array | number[], rays: Float64Array | number[], places: Uint32Array | number[], grey: Uint8Array | number[], options: Given<RefinementOptions>): Float64Array;

/**
 * The names of the rules, in the order of their codes.
 */
export function rule_names(): Rule[];

/**
 * The seed of the built-in sample pair.
 */
export function sample_seed(): number;

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
export function score_matches(matches: Float64Array | number[], left_points: Float64Array | number[], right_position: Float32Array | number[], left_width: number, left_height: number, right_width: number, right_height: number): MatchScore;

/**
 * SHA-256 (FIPS 180-4) of bytes: 32 bytes.
 */
export function sha256(bytes: Uint8Array | number[]): Uint8Array;

/**
 * Renders the pair of a flight; parameters that are absent are those of the sample.
 */
export function simulate(flight: Given<Flight>): SamplePair;

/**
 * The geometry of two images from matches x, y left, x, y right in px (stride 4), of which many may be wrong.
 */
export function two_view(points: Float64Array | number[], options: Given<TwoViewOptions>): TwoViewResult;

/**
 * The version of the crate.
 */
export function version(): string;

/**
 * Writes a project.
 */
export function write_project(project: Project): string;

export type InitInput = RequestInfo | URL | Response | BufferSource | WebAssembly.Module;

export interface InitOutput {
    readonly memory: WebAssembly.Memory;
    readonly __wbg_blockpoints_free: (a: number, b: number) => void;
    readonly __wbg_blockscene_free: (a: number, b: number) => void;
    readonly __wbg_photo_free: (a: number, b: number) => void;
    readonly __wbg_report_free: (a: number, b: number) => void;
    readonly ambiguity_defaults: () => any;
    readonly assembly_defaults: () => any;
    readonly assembly_parameters: () => any;
    readonly block_flight_defaults: () => any;
    readonly block_flight_parameters: () => any;
    readonly block_parameters: () => any;
    readonly block_settings: (a: any) => [number, number, number];
    readonly blockpoints_add_pair: (a: number, b: number, c: number, d: number, e: number, f: number, g: number) => [number, number];
    readonly blockpoints_assemble: (a: number, b: any, c: any) => [number, number, number];
    readonly blockpoints_count: (a: number) => number;
    readonly blockpoints_join: (a: number, b: any) => [number, number, number];
    readonly blockpoints_model: (a: number, b: any, c: number, d: number) => [number, number, number];
    readonly blockpoints_moved: (a: number, b: number, c: number, d: number, e: number) => [number, number, number];
    readonly blockpoints_new: (a: number, b: number) => [number, number, number];
    readonly blockpoints_ray_count: (a: number) => number;
    readonly blockpoints_ray_histogram: (a: number) => [number, number];
    readonly blockpoints_select: (a: number, b: any) => [number, number, number];
    readonly blockpoints_set_image: (a: number, b: number, c: number, d: number, e: number, f: number) => [number, number];
    readonly blockpoints_shared: (a: number) => [number, number];
    readonly blockpoints_table: (a: number) => any;
    readonly blockscene_new: (a: any) => [number, number, number];
    readonly blockscene_photo: (a: number, b: number) => [number, number, number];
    readonly blockscene_photos: (a: number) => number;
    readonly blockscene_recorded_position: (a: number, b: number) => [number, number, number, number];
    readonly blockscene_surface_at: (a: number, b: number, c: number, d: number) => [number, number, number];
    readonly blockscene_truth: (a: number) => any;
    readonly camera_rules_of: (a: any, b: any) => [number, number, number, number];
    readonly candidates: (a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number, j: any, k: any) => [number, number, number, number];
    readonly check_block_description: (a: any) => [number, number];
    readonly check_flight: (a: any) => [number, number];
    readonly choose_pairs: (a: number, b: number, c: number, d: number, e: any) => [number, number, number];
    readonly constant_offset: (a: number, b: number) => [number, number, number];
    readonly csv_field: (a: number, b: number) => [number, number];
    readonly defaults: () => any;
    readonly draw_match_lines: (a: any, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number, j: number, k: number, l: number, m: number, n: number) => [number, number, number];
    readonly draw_points: (a: any, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number, j: number, k: number) => [number, number, number];
    readonly draw_vectors: (a: any, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number, j: number, k: number, l: number) => [number, number, number];
    readonly epipolar_line: (a: any, b: number, c: number, d: any, e: any, f: number, g: number) => [number, number, number, number];
    readonly estimate_offset: (a: any, b: any) => [number, number, number];
    readonly estimated_interior: (a: any, b: number, c: number, d: number, e: number) => [number, number, number];
    readonly explain_connections: (a: number, b: any) => [number, number, number];
    readonly export_block: (a: any, b: any, c: any) => [number, number];
    readonly export_formats: () => any;
    readonly feature_defaults: () => any;
    readonly feature_parameters: () => any;
    readonly flight_parameters: () => any;
    readonly flight_preset: (a: any) => [number, number, number];
    readonly flight_presets: () => any;
    readonly geometry_parameters: () => any;
    readonly gradient_candidates: (a: number, b: number, c: number, d: number, e: number, f: number) => [number, number, number, number];
    readonly ideal_positions: (a: any, b: number, c: number) => [number, number, number];
    readonly interior: (a: any, b: any) => [number, number, number];
    readonly join_nearest: (a: any, b: any) => [number, number, number];
    readonly local_positions: (a: number, b: number) => [number, number, number];
    readonly match_described_pair: (a: number, b: number, c: any, d: any, e: any, f: any, g: any) => [number, number, number];
    readonly match_descriptors: (a: number, b: number, c: number, d: number, e: any) => [number, number, number];
    readonly match_features: (a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: any) => [number, number, number];
    readonly match_guided_descriptors: (a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: any, j: any) => [number, number, number];
    readonly match_pair: (a: number, b: number, c: any, d: any, e: number, f: number, g: number, h: number) => [number, number, number];
    readonly match_photos: (a: number, b: number, c: any, d: any, e: any, f: any, g: any, h: any) => [number, number, number];
    readonly match_points: (a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: any, j: any) => [number, number, number];
    readonly matches_csv: (a: number, b: number) => [number, number, number, number];
    readonly nearest_piece: (a: number, b: number, c: number, d: number, e: number, f: number) => [number, number, number];
    readonly observations: (a: number, b: number, c: any, d: any) => [number, number, number, number];
    readonly operator_defaults: () => any;
    readonly orient_fiducials: (a: any, b: any) => [number, number, number];
    readonly orient_matches: (a: number, b: number, c: number, d: number, e: any, f: any) => [number, number, number];
    readonly orient_relative: (a: number, b: number, c: number, d: any, e: number, f: number) => [number, number, number];
    readonly pair_rule: (a: number, b: number, c: any) => [number, number, number];
    readonly parameters: () => any;
    readonly parse_camera: (a: number, b: number) => [number, number, number];
    readonly parse_camera_rules: (a: number, b: number) => [number, number, number];
    readonly parse_fiducials: (a: number, b: number) => [number, number, number];
    readonly parse_image_marks: (a: number, b: number) => [number, number, number];
    readonly parse_observations: (a: number, b: number) => [number, number, number, number];
    readonly parse_surveyed_points: (a: number, b: number) => [number, number, number];
    readonly photo_camera: (a: any) => [number, number, number];
    readonly photo_decode: (a: number, b: number) => [number, number, number];
    readonly photo_describe: (a: number, b: number, c: number, d: any, e: any) => [number, number, number, number];
    readonly photo_describe_points: (a: number, b: any, c: number, d: number) => [number, number, number];
    readonly photo_detect: (a: number, b: any, c: number, d: number) => [number, number, number];
    readonly photo_features: (a: number, b: any, c: number, d: number) => [number, number, number];
    readonly photo_from_grey: (a: number, b: number, c: number, d: number) => [number, number, number];
    readonly photo_grey: (a: number) => [number, number];
    readonly photo_height: (a: number) => number;
    readonly photo_info: (a: number) => any;
    readonly photo_ray_windows: (a: number, b: number, c: number, d: any) => [number, number, number];
    readonly photo_reduced: (a: number, b: number) => any;
    readonly photo_width: (a: number) => number;
    readonly photo_window_moments: (a: number, b: number, c: number, d: any) => [number, number, number];
    readonly points_csv: (a: number, b: number) => [number, number, number, number];
    readonly ray_outcomes: () => any;
    readonly read_exif: (a: number, b: number, c: number, d: number) => any;
    readonly read_project: (a: number, b: number) => [number, number, number];
    readonly refine_points: (a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: any) => [number, number, number];
    readonly report_html: (a: number) => [number, number, number, number];
    readonly report_new: (a: number, b: number, c: any, d: any, e: any, f: any, g: number, h: number, i: number, j: number) => [number, number, number];
    readonly report_step: (a: number) => [number, number, number];
    readonly report_steps: (a: number) => any;
    readonly rule_names: () => any;
    readonly sample_seed: () => number;
    readonly scaled_interior: (a: any, b: number) => [number, number, number];
    readonly score_block: (a: any, b: any) => [number, number, number];
    readonly score_matches: (a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number, j: number) => [number, number, number];
    readonly sha256: (a: number, b: number) => [number, number];
    readonly simulate: (a: any) => [number, number, number];
    readonly two_view: (a: number, b: number, c: any) => [number, number, number];
    readonly version: () => [number, number];
    readonly write_project: (a: any) => [number, number, number, number];
    readonly wasm_bindgen__convert__closures_____invoke__h33682bcdd9276de4: (a: number, b: number, c: any, d: any) => any;
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
