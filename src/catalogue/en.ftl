# The texts of messages in English. An entry is named `family-kind`; its variables are the fields of the message.
#
# FIXED($x, digits: n) writes n digits after the point, SIGNIFICANT n significant digits, POWER a power of ten, PERCENT a share in per cent.
# A list $images has its first five items; $images_count all of them are, and $images_more of them are not named.

## Errors. They follow `error: ` or stand in a sentence: no capital, no full stop.

error-invalid-option = { $field } is { $got }; allowed: { $allowed }
error-invalid-json = { $what }: { $reason }
error-invalid-input = { $what }: got { $got }; allowed: { $allowed }
error-unreadable-image = the image cannot be read: { $reason }
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
error-interrupted = the run cannot go on: { $reason }
error-unreadable-file = { $what } cannot be read: { $place }: { $reason }
error-not-written = { $what } cannot be written: its sink takes no more text

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
cause-inseparable = the unknowns can hardly be told apart, as over a critical cylinder or without a base (condition { POWER($condition, digits: 1) }; up to { POWER($most, digits: 0) } is sound)
cause-large-errors = the standard error of an angle or of the direction of the base is { FIXED($largest_deg, digits: 0) }°
cause-large-residuals = σ0 is { FIXED($sigma0_px, digits: 1) } px; matching reaches { FIXED($most_px, digits: 1) } px: the matches are wrong, as those of photos that lie upside down or do not overlap, or the camera is
cause-weak-support = only { $agreeing } of { $observations } observations agree, which chance explains, and all together have no orientation
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
cause-stalled = no step lowers the residuals any more, and the last one is { POWER($last_step, digits: 1) } standard errors long
cause-unsettled = { $unsettled } still changes after { $rounds } rounds
cause-point-in-plane = a point lies in the plane of a projection centre
cause-no-rotation = its rotation follows from nothing
cause-no-position = its position follows from nothing
cause-few-observations = it has { $observations } observations of points that others see; at least { $needed } are needed
cause-no-camera-parameter = { $camera_parameter } of camera { $camera } (counted from 0) follows from nothing
cause-parts = the block falls into { $parts } parts without common points; images { $first } and { $second } (counted from 0) are in different ones
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

no-orientation-no-camera = no camera is given and the { $side } image names no focal length
no-orientation-no-focal-length = fiducial marks are given, but no focal length
no-orientation-no-pixel-size = the { $side } image has neither fiducial marks nor a pixel size
no-orientation-no-geometry = no geometry of the two views: { $no_geometry }
no-orientation-pure-rotation = no base (pure rotation): the photos differ by a rotation alone
no-orientation-refused = { $error }

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
    .help = All points lie in a plane: each point of one image has one place in the other.
two-view-model-rotation = rotation without a base
    .label = rotation
    .short = pure rotation
    .help = No base (pure rotation): each point of one image has one place in the other, whatever its distance.

degeneracy-plane = Nearly all points lie in a plane: without known cameras the orientation is not determined; with them, its warnings say whether that matters.
    .short = ground nearly plane
degeneracy-pure-rotation = No base (pure rotation): the photos differ by a rotation alone, so nothing can be oriented.
    .short = no base

## Warnings about a relative orientation.

warning-plane = All points lie in a plane within their precision: a second orientation fits nearly as well (misfit { FIXED($misfit, digits: 1) } σ0; from { $least } on a plane is excluded).
warning-clustered = The points cover a small part of the photo (root mean square { FIXED($coverage, digits: 2) } focal lengths from their middle; at least { $least } is sound).
warning-rotation = The photos hardly differ but by a rotation: the base is too short to be told from noise and distortion (parallax { SIGNIFICANT($parallax_deg, digits: 2) }°; at least { SIGNIFICANT($least_deg, digits: 2) }° is sound).
warning-ill-conditioned = The unknowns can hardly be told apart, as over a critical cylinder (condition { POWER($condition, digits: 1) }; up to { POWER($most, digits: 0) } is sound).
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
warning-focal-length = The residuals ask for a focal length that differs by { FIXED($change_percent, digits: 2) } % ({ FIXED($w, digits: 1) } standard errors), which would move the result out of its 95 % intervals.

## Pairs of a block: what came of matching them, and why they were chosen.

connection = { $outcome }; { $rule }

outcome-waiting = not matched yet
outcome-connected = connected by { $matches } matches
outcome-too-few-matches = not connected: { $matches } matches; at least { $needed } are needed
outcome-not-oriented = not connected: { $no_geometry }
outcome-failed = not connected: { $failure }

rule-all = all pairs are tried
rule-near = chosen as near each other
rule-sequence = chosen as following each other
rule-alike = chosen as similar

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
unoriented-no-agreement = { $agreeing } of its { $points } observations of intersected points agree on one orientation; at least { $needed } must, and a fifth
unoriented-narrow = its { $agreeing } observations that agree lie on a line or in one spot of the image
unoriented-no-partner = it has too few points in common with any image, or no base to one
unoriented-lost =
    it was oriented and kept only { $rays ->
        [one] 1 observation
       *[other] { $rays } observations
    }
unoriented-undetermined =
    it was oriented with { $rays ->
        [one] 1 observation
       *[other] { $rays } observations
    }; the bundle adjustment rejected too many of them

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
block-warning-degrees = The x and y of the GCPs look like longitude and latitude: metres are needed, not degrees.
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
block-warning-focal-estimated = The focal length of { $camera } is not known; it is estimated to ± { FIXED($error_px, digits: 1) } px.
block-warning-focal-undetermined = The focal length of { $camera } is not known, and the block does not determine it: heights are wrong in scale.
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
verdict-no-candidate = Rejected: there is nothing in reach that could be compared with it.
    .label = No candidate
verdict-threshold = Rejected: its best candidate is not similar enough.
    .label = Threshold
verdict-ambiguous = Rejected: its second best candidate is nearly as good as its best.
    .label = Ambiguous
verdict-many-to-one = Rejected: another left point matches the same place better.
    .label = Many to one
verdict-parallax = Rejected: its y-parallax deviates from that of the nearest matches, or it does not fit the geometry of the two views.
    .label = y-parallax
verdict-border = Rejected: the best place lies on the border of its search window, so a better one may lie beyond.
    .label = Border
verdict-left-right = Rejected: from the right image back, another place of the left image is more similar.
    .label = Left-right check
verdict-not-converged = Rejected: least squares matching does not converge within its limits of shape, distance and iterations.
    .label = Not converged
verdict-imprecise = Rejected: the standard error of its right position is too large, as on an edge along which it can slide.
    .label = Imprecise
verdict-frame = Rejected: it lies at the same place of both frames, as the border of the film, fiducial marks and data strips do.
    .label = Frame
verdict-gross-error = Matched, then rejected from the relative orientation: its standardised residual exceeds the limit that α₀ sets.
    .label = Gross error
verdict-undecided = No match uses this point.
    .label = Not matched
