# The texts of messages in English. An entry is named `family-kind`; its variables are the fields of the message.
#
# FIXED($x, digits: n) writes n digits after the point, SIGNIFICANT n significant digits, POWER a power of ten, PERCENT a share in per cent.
# A list $images has its first five items; $images_count all of them are, and $images_more of them are not named.

## Errors. They follow `error: ` or stand in a sentence: no capital, no full stop.

error-invalid-option = { $field } is { $got }; allowed: { $allowed }
error-invalid-json = { $what }: { $reason }
error-invalid-input = { $what }: got { $got }; allowed: { $allowed }
error-unreadable-image = the image cannot be read: { $image_fault }
error-unsupported-image = { $what } is not supported; allowed: { $allowed }
error-too-many-pixels = the image declares { $width } x { $height } px = { FIXED($megapixels, digits: 1) } MP; allowed: up to { FIXED($max_megapixels, digits: 1) } MP
error-too-much-memory = decoding { $width } x { $height } px needs about { $needed_mb } MB; allowed: up to { $max_mb } MB
error-image-too-small = the image has { $width } x { $height } px; { $operation } needs at least { $min_side } px a side
error-window-outside = the window of { $side } x { $side } px at column { $col }, row { $row } leaves the image of { $width } x { $height } px
error-constant-window = the window of { $side } x { $side } px at column { $col }, row { $row } is constant: it has no moments
error-too-few = { $what }: { $got } given; at least { $needed } are needed
error-degenerate = the observations do not determine { $computation }: { $cause }
error-undetermined-image = { $computation } does not determine image { $image } (counted from 0): { $cause }
error-not-converged = { $computation } does not converge in { $iterations } iterations: { $cause }
error-not-exportable = these images cannot be exported as { $formats } ({ $reason }): rename them, or leave out what cannot hold their names
error-interrupted = the run cannot go on: { $interruption }
error-unreadable-file = { $what } cannot be read: { $place }: { $file_fault }
error-not-written = { $what } cannot be written: the output takes no more text

image-fault-empty = the file is empty
image-fault-damaged = { $format }: { $message }
image-fault-mask = its mask { $name }: { $error }

file-fault-system = { $message }
file-fault-not-text = it is not text (UTF-8)
file-fault-content = { $message }
file-fault-no-project = '{ $line }' is not the first line of a project, or the only one
file-fault-no-header = '{ $line }' is not the first line of a project ({ $message })
file-fault-other-format = its format is '{ $format }', not '{ $wanted }'
file-fault-other-version = it is of version { $version }; this program reads versions 1 to { $newest }
file-fault-other-length = { $bytes } bytes follow the first line, which declares { $declared }: the file is cut off or was changed
file-fault-other-checksum = the checksum of the first line does not fit the rest: the file is damaged or was changed by hand
file-fault-holds-pair = it holds a pair, not a block
file-fault-holds-block = it holds a block, not a pair
file-fault-record-changed = it was removed or changed while the run went on: start the run again
file-fault-in-use = it is in use by { $owner }: wait for that, or remove the lock if no such process runs

interruption-image-changed = { $name } was changed while the run went on: start the run again
interruption-unreadable-work = what came of a job does not read as it was written
interruption-unfinished = it was ended before all of its jobs were done
interruption-job = { $failure }
interruption-refinement = the observations of { $name } cannot be refined: { $failure }

## What is computed.

computation-affine-transformation = the affine transformation
computation-bundle-adjustment = the bundle adjustment
computation-by-and-bz = by and bz
computation-datum = the datum
computation-determinant-form = the determinant form
computation-distortion-correction = the correction of distortion
computation-free-network = the free network
computation-fundamental-matrix = the fundamental matrix
computation-homography = the homography
computation-omega-and-kappa = ω and κ
computation-relative-orientation = the relative orientation
computation-two-view-geometry = the geometry of the two views

## Why observations do not determine something, or iterations do not converge.

cause-points-on-line = all points of the { $side } photo lie on a line (width / length = { POWER($width, digits: 1) }; at least { POWER($least, digits: 0) } is needed)
cause-marks-on-line =
    the { $calibrated ->
        [true] calibrated
       *[false] measured
    } marks lie on a line (width / length = { POWER($width, digits: 1) }; at least { POWER($least, digits: 0) } is needed)
cause-positions-on-line = the GNSS positions and GCPs lie on a line (width / length = { POWER($width, digits: 1) }; at least { POWER($least, digits: 0) } is needed)
cause-no-extent = the approximate positions have no extent
cause-one-position = all images have the same position
cause-no-parallax = both photos have the same coordinates, so there is no parallax
cause-no-base = no base (pure rotation): the median parallax beside a rotation is { FIXED($parallax, digits: 1) } standard errors of a photo coordinate; more than { $least } are needed
cause-inseparable = the unknowns are hardly separable, as over a critical cylinder or without a base (condition { POWER($condition, digits: 1) }; up to { POWER($most, digits: 0) } is sound)
cause-large-errors = the standard error of an angle or of the direction of the base is { FIXED($largest_deg, digits: 0) }°
cause-large-residuals = σ0 is { FIXED($sigma0_px, digits: 1) } px; matching reaches { FIXED($most_px, digits: 1) } px: the matches are wrong, as those of photos that lie upside down or do not overlap, or the camera is
cause-weak-support = only { $agreeing } of { $observations } observations agree, too few to show which are right: measure more points, or adjust all without robustness
cause-behind-cameras = only { $in_front } of { $points } points would lie in front of both cameras
cause-singular-normals = the normal equations are singular (1 - R² = { POWER($share, digits: 1) }; more than { POWER($least, digits: 0) } is needed)
cause-base-across-x = the base has { POWER($along_x, digits: 1) } of its length along x (at least { $least } is needed), so by and bz have no size in units of b; turn both photos by 90°
cause-no-base-along-x = the base has no component along x, by which this form divides; the rigorous form takes any base
cause-gimbal-lock = φ is ±90°, where both turn about the same axis
cause-chance = { $agreeing } of { $matches } matches agree on one, no more than would by chance
cause-several-matrices = more than one matrix fits them
cause-too-many-on-line = too many of the points lie on a line
cause-turned-away = it leaves the start: the right photo turns by more than 60°; the robust start takes any rotation
cause-rising-base = it leaves the start: the base rises by more than 60°; the robust start takes any base
cause-long-steps = the last step is { POWER($ratio, digits: 1) } times as long as one that counts as converged
cause-stalled = no step reduces the residuals any further, and the last one is { POWER($last_step, digits: 1) } standard errors long
cause-unsettled = { $unsettled } still changes after { $rounds } rounds
cause-point-in-plane = a point lies in the plane of a projection centre
cause-no-rotation = nothing determines its rotation
cause-no-position = nothing determines its position
cause-few-observations = it has { $observations } observations of points that others see; at least { $needed } are needed
cause-no-camera-parameter = nothing determines { $camera_parameter } of camera { $camera } (counted from 0)
cause-parts = the block falls into { $parts } parts that share no points; images { $first } and { $second } (counted from 0) are in different ones
cause-folded-at = the camera's distortion has no inverse at ({ $x_px }, { $y_px }) px
cause-folded-beyond = the camera's distortion has no inverse { FIXED($radius_px, digits: 0) } px from the principal point

unsettled-gross-errors = the rejection of gross errors
unsettled-positions = the rejection of GNSS positions
unsettled-weights = the weight of the observed positions

side-left = left
side-right = right

## Why a pair has no geometry of the two views, or no orientation. They follow `not oriented: `.

no-geometry-too-few-matches = { $matches } different matches are given; at least { $needed } are needed
no-geometry-chance = { $agreeing } of { $matches } matches agree on one geometry, no more than would by chance

camera-origin-xmp-calibration = XMP (calibrated)
camera-origin-xmp-dewarped = XMP (calibrated, distortion already removed)
camera-origin-xmp-design = XMP (as designed)
camera-origin-exif-focal-plane = EXIF
camera-origin-exif35-mm = EXIF (35 mm equivalent)
camera-origin-sensor-table = EXIF and the listed size of its sensor
camera-origin-focal-length-alone = EXIF (focal length in mm alone)
camera-origin-panorama = XMP (panorama)

camera-caution-resized = taken with { $taken_width_px } x { $taken_height_px } px, resized to { $width_px } x { $height_px } px: its focal length in px is scaled
camera-caution-cropped = taken with { $taken_width_px } x { $taken_height_px } px, but { $width_px } x { $height_px } px large: it was cropped, and its focal length in px is not known; give the camera if you know it
camera-caution-focal-plane = EXIF gives pixels of { SIGNIFICANT($pixel_um, digits: 2) } µm, but with this sensor or its 35 mm equivalent those of this photo are { SIGNIFICANT($expected_um, digits: 2) } µm large: it was resized or cropped, and its focal length in px is not known; give the camera if you know it
camera-caution-contradiction = XMP gives a focal length of { FIXED($xmp_focal_px, digits: 0) } px, EXIF of { FIXED($exif_focal_px, digits: 0) } px: that of EXIF is used
camera-caution-panorama = a panorama ({ $projection }): it has no central perspective, and no camera

no-orientation-no-camera = no camera is given and the { $side } image names no focal length
no-orientation-no-focal-length = fiducial marks are given, but no focal length
no-orientation-no-pixel-size = the { $side } image has neither fiducial marks nor a pixel size
no-orientation-panorama = the { $side } image is a panorama: it has no central perspective, and no camera
no-orientation-no-geometry = no geometry of the two views: { $no_geometry }
no-orientation-pure-rotation = no base (pure rotation): the photos differ by a rotation alone
no-orientation-refused = { $error }

## What the result of a pair is worth.

pair-verdict-oriented = Oriented from { $points } points, σ0 { FIXED($sigma0_px, digits: 2) } px; the right photo is turned by { FIXED($kappa_deg, digits: 2) }° ± { SIGNIFICANT($half_width_deg, digits: 2) }° (95 %).
    .label = oriented
pair-verdict-weak = Weak orientation from { $points } points. { $warning }
    .label = weak
pair-verdict-not-oriented = Not oriented: { $no_orientation }.
    .label = not oriented

## What else would do for a pair.

pair-hint-other-strategy = This strategy compares windows as they stand in both photos: where these are turned, of another scale or overlap elsewhere, the strategy “auto” finds more.

## What the geometry of two views is, and where it is degenerate.

two-view-model-calibrated = orientation of calibrated cameras
    .label = calibrated cameras
    .short = relative orientation
    .help = Orientation of cameras that are known, or whose focal length the matches determine: a match lies on its epipolar line and in front of both cameras.
two-view-model-fundamental = epipolar geometry of unknown cameras
    .label = unknown cameras
    .short = fundamental matrix
    .help = Epipolar geometry (fundamental matrix): a match lies on its epipolar line; nothing of the cameras is known.
two-view-model-homography = homography of a plane
    .label = homography of a plane
    .short = plane
    .help = All points lie in a plane: each point of one image has one position in the other.
two-view-model-rotation = rotation without a base
    .label = rotation
    .short = pure rotation
    .help = No base (pure rotation): each point of one image has one position in the other, whatever its distance.

degeneracy-plane = Nearly all points lie in a plane: without known cameras the orientation is not determined; with them, its warnings say whether that matters.
    .short = ground nearly plane
degeneracy-pure-rotation = No base (pure rotation): the photos differ by a rotation alone, so nothing can be oriented.
    .short = no base

## Warnings about a relative orientation.

warning-plane = All points lie in a plane within their precision: a second orientation fits nearly as well (its σ0 is { FIXED($ratio, digits: 2) } times as large; from { FIXED($least, digits: 2) } it is excluded).
warning-clustered = The points cover a small part of the photo (root mean square { FIXED($coverage, digits: 2) } focal lengths from their middle; at least { $least } is sound).
warning-rotation = The photos hardly differ but by a rotation: the base is too short to be distinguished from noise and distortion (parallax { SIGNIFICANT($parallax_deg, digits: 2) }°; at least { SIGNIFICANT($least_deg, digits: 2) }° is sound).
warning-ill-conditioned = The unknowns are hardly separable, as over a critical cylinder (condition { POWER($condition, digits: 1) }; up to { POWER($most, digits: 0) } is sound).
warning-identical =
    { $copies ->
        [one] 1 observation is the same as another
       *[other] { $copies } observations are the same as others
    } to the last digit: each counts once.
warning-behind =
    { $points ->
        [one] 1 point is
       *[other] { $points } points are
    } left out: the rays meet behind a camera, as those of wrong matches and of mirrored coordinates do.
warning-sigma = The residuals contradict the given σ0: it is { SIGNIFICANT($estimated_um, digits: 3) } µm, not { SIGNIFICANT($given_um, digits: 3) } µm. Standard errors and tests use the estimated one.
warning-few-places = The matches lie in { $places ->
        [one] 1 place
       *[other] { $places } places
    } of the photo; at least { $least } are sound.
warning-few-matches = Only { $matches } matches took part; as many may agree on a repeated pattern, at least { $least } are sound.
warning-few-agree = Only { $accepted } of { $matches } matches agree with the orientation.
warning-mirrored = The right photo shows the ground mirrored.
warning-mirrored-marks = The fiducial marks lie mirrored in the { $side } image: is the scan mirrored, or are their coordinates?
warning-unknown-camera = The focal length is hardly known and was estimated from the matches: give the camera.
warning-exact = σ0 is { SIGNIFICANT($sigma0_px, digits: 1) } px, as of parts of one image; two photographs do not agree to better than { $least_px } px.
warning-wide-angle = The points reach far from the axis for their focal length (root mean square { FIXED($coverage, digits: 2) } focal lengths from their middle; up to { $most } is common): is the focal length too short?
warning-uncertain = The rotation is known to ±{ SIGNIFICANT($half_width_deg, digits: 2) }° only (95 %); up to ±{ $most_deg }° is sound.
warning-uncertain-base = The direction of the base is known to ±{ SIGNIFICANT($half_width_deg, digits: 2) }° only (95 %); up to ±{ $most_deg }° is sound.
warning-imprecise = σ0 is { FIXED($sigma0_px, digits: 1) } px; matching reaches { FIXED($most_px, digits: 1) } px where the camera and its distortion are right.
warning-focal-length = The residuals ask for a focal length that differs by { FIXED($change_percent, digits: 2) } % ({ FIXED($w, digits: 1) } standard errors), which would move the result out of its 95 % intervals.

## Pairs of a block: what came of matching them, and why they were chosen.

connection = { $outcome }; { $rule }

outcome-waiting = not matched yet
outcome-connected = connected by { $matches } matches
outcome-too-few-matches = not connected: { $matches } matches; at least { $needed } are needed
outcome-not-oriented = not connected: { $no_geometry }
outcome-failed = not connected: { $failure }

rule-all = all pairs are tried
rule-near = chosen because the images are near each other
rule-sequence = chosen because the images follow each other
rule-alike = chosen because the images are similar

## Why a file was skipped, or a job of a run failed.

failure-unreadable = { $message }
failure-refused = { $message }
failure-broke-off = the computation broke off at a fault of the program ({ $message }): please report it
failure-out-of-memory = memory ran out ({ $message })

## Why an image is not oriented. They follow the name of the image and a colon.

unoriented-no-points = it has no tie points
unoriented-too-few-points =
    { $points ->
        [one] 1 of its tie points is intersected
       *[other] { $points } of its tie points are intersected
    } by oriented images; at least { $needed } are needed
unoriented-no-agreement = { $agreeing } of its { $points } observations of intersected points agree on one orientation; at least { $needed } and a fifth of them must
unoriented-narrow = its { $agreeing } observations that agree lie on a line or in one spot of the image
unoriented-no-partner = it shares too few tie points with every other image, or has no base to one
unoriented-lost =
    it was oriented, but kept only { $rays ->
        [one] 1 observation
       *[other] { $rays } observations
    }
unoriented-undetermined =
    it was oriented with { $rays ->
        [one] 1 observation
       *[other] { $rays } observations
    }; the bundle adjustment rejected too many of these

image-reason-apart = in a model of its own, of { $images } images
image-reason-unoriented = { $unoriented }
image-reason-failed = { $failure }
image-reason-unknown = not oriented

## What a block is worth.

block-verdict-oriented =
    Oriented: { $oriented } of { $images } images from { $points } points{ $sigma0_px ->
        [none] .
       *[other] , σ0 { FIXED($sigma0_px, digits: 2) } px.
    }
    .label = oriented
block-verdict-weak = Weak orientation: { $oriented } of { $images } images from { $points } points. { $overview_warning }
    .label = weak
block-verdict-not-oriented =
    Not oriented: { $connected ->
        [0] no two of the images could be connected
       *[other] { $failure ->
            [none] no image could be oriented
           *[other] { $failure }
        }
    }.
    .label = not oriented

## Warnings about a block at a glance.

overview-warning-model = { $block_warning }
overview-warning-few-oriented = { $oriented } of { $images } images are oriented.
overview-warning-apart = { $images } images are oriented apart from the others, in a model of their own.
overview-warning-none-oriented = No image could be oriented.
overview-warning-failed = No image could be oriented: { $failure }.

## Warnings about an adjusted block.

block-warning-free =
    No observed positions determine the position, rotation and scale of the model: they are arbitrary{ $cause ->
        [none] .
       *[other] {" "}({ $cause }).
    }
block-warning-unknown-rotation =
    The { $observed } do not determine the rotation of the whole block about their line{ $tilt_deg ->
        [none] .
       *[other] ; the views are { FIXED($tilt_deg, digits: 0) }° off the vertical on average.
    }
block-warning-uncertain-rotation =
    The { $observed } hardly determine the rotation of the whole block: its angles are uncertain by ± { FIXED($error_deg, digits: 0) }° or more{ $tilt_deg ->
        [none] .
       *[other] ; the views are { FIXED($tilt_deg, digits: 0) }° off the vertical on average.
    }
block-warning-levelled =
    The GNSS positions { $error_deg ->
        [none] do not determine the rotation of the whole block
       *[other] hardly determine the rotation of the whole block (± { FIXED($error_deg, digits: 0) }°)
    }: { $recorded ->
        [true] the recorded directions of view level it
       *[false] its views are taken as vertical on average
    }, assumed to ± { FIXED($level_deg, digits: 0) }°.
block-warning-imprecise =
    σ0 is { FIXED($sigma0_px, digits: 1) } px, above the { FIXED($most_px, digits: 0) } px that matching reaches with the right camera: distortion, a wrong camera or wrong matches.
block-warning-no-heights = The GNSS positions have no heights: the flight is taken as level, heights count from it, and the block may be tilted.
block-warning-positions-rejected =
    { $images_count ->
        [one] 1 GNSS position does not fit and is rejected, with its distance
       *[other] { $images_count } GNSS positions do not fit and are rejected, with their distances
    }: { $images }{ $images_more ->
        [0] .
       *[other] {" "}and { $images_more } more.
    }
    .images = { $name } ({ FIXED($distance_m, digits: 1) } m)
block-warning-scale =
    The GCPs make the block { SIGNIFICANT($ratio, digits: 2) } times as large as the GNSS positions: { $unit ->
        [none] metres are needed.
       *[other] are they in { $unit }?
    }
block-warning-degrees = The x and y of the GCPs look like longitude and latitude: coordinates in metres are needed, not degrees.
block-warning-point-rejected =
    The GCP { $point } is rejected: { $measurements ->
        [one] it has one image measurement in oriented images.
       *[other] its { $measurements } image measurements in oriented images do not meet.
    }
block-warning-measurements-rejected =
    { $images_count } of the { $measurements ->
        [one] 1 image measurement
       *[other] { $measurements } image measurements
    } of the GCP { $point } { $images_count ->
        [one] does
       *[other] do
    } not fit: { $images }{ $images_more ->
        [0] .
       *[other] {" "}and { $images_more } more.
    }
block-warning-focal-estimated = The focal length of { $camera } is not known; it is estimated with a standard error of ± { FIXED($error_px, digits: 1) } px.
block-warning-focal-undetermined = The focal length of { $camera } is not known, and the block does not determine it: the scale of the heights is wrong.
block-warning-parameter-fixed = The block does not determine { $camera_parameter } of { $camera }; it stays as it was.
block-warning-few-observations =
    { $images_count ->
        [one] 1 image has
       *[other] { $images_count } images have
    } fewer than { $least } observations: { $images }{ $images_more ->
        [0] .
       *[other] {" "}and { $images_more } more.
    }
block-warning-two-rays = { $two } of { $points } points of the adjustment have two rays only: their errors along the base do not show.
block-warning-many-rejected = { $rejected } of { $observations } observations do not fit.

observed-positions = GNSS positions
observed-points = GCPs
observed-both = GNSS positions and GCPs

unit-millimetres = millimetres
unit-centimetres = centimetres
unit-inches = inches
unit-feet = feet
unit-kilometres = kilometres

# `first`: the name of its first image; `more`: how many it has beside that.
camera =
    { $only ->
        [true] the camera
       *[false] camera { $number }{ $first ->
            [none] {""}
           *[other] {" "}({ $first }{ $more ->
                [0] {""}
                [one] {" "}and 1 more image
               *[other] {" "}and { $more } more images
            })
        }
    }

camera-parameter-focal = the focal length
camera-parameter-principal-x = the principal point's column
camera-parameter-principal-y = the principal point's row
camera-parameter-k1 = k1
camera-parameter-k2 = k2
camera-parameter-k3 = k3
camera-parameter-p1 = p1
camera-parameter-p2 = p2

## Remarks on what a run was given.

remark-older-project = the project file is of version { $version }: it does not hold features, cameras as given, or standard errors
remark-unused-camera = the camera of { $images } fits the name of no image
remark-doubtful-focal =
    the focal length of { $label } is { $focal_px } px, { SIGNIFICANT($sides, digits: 2) } of the longer side of the image, where { $least } to { $most } are usual{ $in_mm ->
        [true] : is it in mm?
       *[false] {""}
    }
remark-cautioned-cameras =
    { $camera_caution }: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}and { $images_more } more
    }
remark-impossible-positions =
    impossible GNSS positions and heights are ignored: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}and { $images_more } more
    }
    .images = { $name } ({ $value })

## What became of a point of the left image. `label`: as a list or a legend has it.

verdict-matched = Matched: no rule rejects it.
    .label = Matched
verdict-no-descriptor = Rejected: its window leaves the image or all its grey values are equal, so there is nothing to compare.
    .label = No window
verdict-no-candidate = Rejected: its search window holds no candidate.
    .label = No candidate
verdict-threshold = Rejected: its best candidate is not similar enough.
    .label = Threshold
verdict-ambiguous = Rejected: its second best candidate is nearly as good as its best.
    .label = Ambiguous
verdict-many-to-one = Rejected: another left point matches the same position better.
    .label = Many to one
verdict-parallax = Rejected: its y-parallax deviates from that of the nearest matches, or it does not fit the geometry of the two views.
    .label = y-parallax
verdict-border = Rejected: the best position lies on the border of its search window; a better one may lie beyond it.
    .label = Border
verdict-left-right = Rejected: matched from the right image back, another position in the left image is more similar.
    .label = Left-right check
verdict-not-converged = Rejected: least squares matching does not converge within its limits of shape, distance and iterations.
    .label = Not converged
verdict-imprecise = Rejected: the standard error of its right position is too large, as on an edge along which it can slide.
    .label = Imprecise
verdict-frame = Rejected: it has the same position in both frames, as the border of the film, fiducial marks and data strips have.
    .label = Frame
verdict-gross-error = Matched, then rejected from the relative orientation: its standardised residual exceeds the limit that α₀ sets.
    .label = Gross error
verdict-undecided = No match uses this point.
    .label = Not matched

## The page. COUNT($n) writes a whole number in groups of three.

page-candidate-of = Not matched. It is the best candidate of left point { COUNT($point) }, which is rejected.

# What the rule compared. `second`: the measure of the second best candidate, `ratio`: the best by it.
page-ratio =
    { $second ->
        [none] without a second candidate
       *[other] { FIXED($ratio, digits: 3) } of the second best ({ FIXED($second, digits: 4) })
    }
page-correlation = Correlation { FIXED($correlation, digits: 4) }, measure { FIXED($best, digits: 4) }.
page-low-correlation = Correlation { FIXED($correlation, digits: 4) }; { $least } or more is allowed.
page-good-measure = Its best measure { FIXED($best, digits: 4) } is below { $most }, and { page-ratio }.
page-large-measure = Best measure { FIXED($best, digits: 4) }; below { $most } is allowed.
page-ambiguous = Its best measure { FIXED($best, digits: 4) } is { page-ratio }; up to { $largest } is allowed.
page-parallax = Tolerance: { $tolerance } px, or three times the scatter of its neighbours where that is more.
page-imprecise = Up to { $most } px is allowed.
page-distance = Distance { FIXED($best, digits: 4) }, { page-ratio }.
page-only-candidate = Distance { FIXED($best, digits: 4) }, the only candidate that agrees with the geometry of the two views.
page-clear-candidate = Distance { FIXED($best, digits: 4) }, { page-ratio }. It agrees with the geometry of the two views.
page-agreeing-candidate = Distance { FIXED($best, digits: 4) }, { page-ratio }: more than { $largest }, but it agrees with the geometry of the two views, which leaves few candidates.
page-no-geometry =
    Distance { FIXED($best, digits: 4) }, { page-ratio }. No geometry of the two views was found{ $no_geometry ->
        [none] .
       *[other] : { $no_geometry }.
    }
page-off-line = Distance { FIXED($best, digits: 4) }, { page-ratio }; but it does not fit: up to { FIXED($threshold_px, digits: 2) } px from its epipolar line is allowed.
page-off-place = Distance { FIXED($best, digits: 4) }, { page-ratio }; but it does not fit: up to { FIXED($threshold_px, digits: 2) } px from its predicted position is allowed.

page-matched = { COUNT($matches) } matches of { COUNT($points) } left points
page-step = Step { $step } of { $steps }: { $stages }
page-worked = { $matched }, { FIXED($seconds, digits: 2) } s of work.

page-estimated-focal = With the focal length estimated from the matches: { FIXED($focal_px, digits: 0) } ± { FIXED($error_px, digits: 0) } px, which the standard errors below assume to be free of error. Lengths in mm are those of pixels of 0.001 mm.
page-global-test = The weighted sum of squared residuals over the given σ₀²: with good matches between { FIXED($lower, digits: 1) } and { FIXED($upper, digits: 1) } in 95 of 100 cases. Above: the matches are worse than the given σ₀, or the model does not hold. Below: the given σ₀ is too large.
page-paper = Paper: its Tables 2 and 3, of its own pair (f = { $focal_mm } mm, pixel { FIXED($pixel_um, digits: 0) } µm, assumed b = { $base_mm } mm).
page-paper-sigma = σ₀ { FIXED($sigma0_mm, digits: 3) } mm = { FIXED($sigma0_px, digits: 1) } px

page-block-images = { COUNT($images) } images.
page-block-done =
    { $verdict } { $images ->
        [one] 1 image
       *[other] { COUNT($images) } images
    }{ $skipped ->
        [0] {""}
       *[other] , { COUNT($skipped) } skipped
    }, { $pairs ->
        [one] 1 pair
       *[other] { COUNT($pairs) } pairs
    } connected, { $found ->
        [none] { $points ->
            [one] 1 tie point
           *[other] { COUNT($points) } tie points
        }
       *[other] { COUNT($points) } of { $found ->
            [one] 1 tie point
           *[other] { COUNT($found) } tie points
        } selected
    }.{ $time ->
        [none] {""}
       *[other] {" "}{ $time }.
    }{ $warnings ->
        [0] {""}
        [one] {" "}1 warning, see Results.
       *[other] {" "}{ COUNT($warnings) } warnings, see Results.
    }
page-block-not-oriented =
    { $why }{ $group ->
        [none] {""}
       *[other] {" "}The largest group of connected images has { COUNT($group) } of { COUNT($images) }: do they overlap?
    } Kept: { COUNT($images) } images with their features, { $pairs ->
        [one] 1 connected pair
       *[other] { COUNT($pairs) } connected pairs
    }, { $points ->
        [one] 1 tie point
       *[other] { COUNT($points) } tie points
    }.
page-geometry =
    { $model }{ $weak ->
        [none] {""}
       *[other] , { $weak }
    }, ± { FIXED($sigma_px, digits: 2) } px

# Why an image has no place on an orthophoto.
not-placed-no-common-place = of { $matches } points that resemble places of the orthophoto, { $agreeing } agree on one place, as chance would have it
not-placed-no-orientation = { $points } points agree on a place, and no orientation of the image fits them: the camera may be wrong, or the heights
not-placed-not-confirmed = { $agreeing } of { $links } points lie where the orientation that was found has them, as chance would have it
not-placed-failed = { $failure }

# What speaks against the place of an image.
placing-weakness-few-links = Only { $links } points link it with the orthophoto; { $needed } are needed.
placing-weakness-coverage = Points lie in { PERCENT($share, digits: 0) } of the image; { PERCENT($needed, digits: 0) } are needed.
placing-weakness-checks = { $beyond } of { $checks } points that took no part contradict the orientation.
placing-weakness-height = The height above ground, { FIXED($height_m, digits: 0) } m, is known to ± { SIGNIFICANT($half_width_m, digits: 2) } m only (95 %): give the camera.
placing-weakness-rejected = { $rejected } of { $links } points were rejected: check the heights and the camera.
placing-weakness-plan = The place of the projection centre is known to ± { SIGNIFICANT($half_width_m, digits: 2) } m only (95 %), { FIXED($height_m, digits: 0) } m above ground: check the heights and the camera.
placing-weakness-noise = Residuals are { FIXED($rmse_px, digits: 2) } px in the root mean square, where good pictures reach { FIXED($usual_px, digits: 2) } px: check the heights and the age of the orthophoto.

# What the place of an image is worth.
placing-verdict-placed = Placed by { $links } points, σ0 { FIXED($sigma0_px, digits: 2) } px; projection centre ± { SIGNIFICANT($half_width_m, digits: 2) } m (95 %).
placing-verdict-weak = Placed with doubt by { $links } points. { $placing_weakness }
placing-verdict-not-placed = Not placed: { $not_placed }.
