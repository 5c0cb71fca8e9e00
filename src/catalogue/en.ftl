# The texts of messages in English. An entry is named `family-kind`; its variables are the fields of the message.
#
# FIXED($x, digits: n) writes n digits after the point, SIGNIFICANT n significant digits, POWER a power of ten, PERCENT a share in per cent.
# HEX n hexadecimal digits. A list $images has its first five items; $images_count all of them are, and $images_more of them are not named.

## Errors. They follow `error: ` or stand in a sentence: no capital, no full stop.

error-invalid-option =
    { $field } is { $got ->
        [none] absent
       *[other] { $got }
    }; allowed: { $allowed }
error-invalid-json = { $document }: { $json_fault }
error-wrong-type =
    { $document }: { $field ->
        [none] {""}
       *[other] { $field }:{" "}
    }got { $json_kind }; allowed: { $allowed }
error-invalid-argument = { $what }: got { $got }; allowed: { $wanted }
error-invalid-input = { $refusal }
error-unreadable-image = the image cannot be read: { $image_fault }
error-unsupported-image = { $unsupported }
error-too-many-pixels = the image declares { $width } x { $height } px = { FIXED($megapixels, digits: 1) } MP; allowed: up to { FIXED($max_megapixels, digits: 1) } MP
error-too-much-memory = an image of { $width } x { $height } px needs about { $needed_mb } MB of memory; allowed: up to { $max_mb } MB
error-image-too-small = the image has { $width } x { $height } px; { $image_operation } needs at least { $min_side } px a side
error-window-outside = the window of { $side } x { $side } px at column { $col }, row { $row } leaves the image of { $width } x { $height } px
error-constant-window = the window of { $side } x { $side } px at column { $col }, row { $row } is constant: it has no moments
error-too-few = { $few }: { $got } given; at least { $needed } are needed
error-degenerate = the observations do not determine { $computation }: { $cause }
error-undetermined-image = { $computation } does not determine image { $image } (counted from 0): { $cause }
error-not-converged = { $computation } does not converge in { $iterations } iterations: { $cause }
error-not-exportable = these images cannot be exported as { $formats } ({ $error }): rename them, or do not export what cannot hold their names
error-interrupted = the run cannot go on: { $interruption }
error-unreadable-file =
    { $document } cannot be read: { $file_place ->
        [none] {""}
       *[other] { $file_place }:{" "}
    }{ $file_fault }
error-not-written = { $document } cannot be written: the output takes no more text
error-not-loaded = the module is not loaded: call load(), the default export of tiepoint, and wait for it first

json-fault-value =
    { $field ->
        [none] {""}
       *[other] { $field }:{" "}
    }{ $json_slip }{ $line ->
        [none] {""}
       *[other] {" "}at line { $line } column { $column }
    }
json-fault-syntax =
    { $json_syntax }{ $line ->
        [none] {""}
       *[other] {" "}at line { $line } column { $column }
    }
json-fault-field =
    { $field }: { $words }{ $line ->
        [none] {""}
       *[other] {" "}at line { $line } column { $column }
    }
json-fault-text =
    { $words }{ $line ->
        [none] {""}
       *[other] {" "}at line { $line } column { $column }
    }

json-slip-other-kind = got { $json_kind }; allowed: { $json_wanted }
json-slip-other-value = got { $value }; allowed: { $json_wanted }
json-slip-other-length =
    got a list of { $items }{ $wanted_items ->
        [none] {""}
       *[other] ; allowed: a list of { $wanted_items }
    }
json-slip-unknown-field =
    unknown field{ $known ->
        [none] {""}
       *[other] ; allowed: { $known }
    }
json-slip-missing = missing
json-slip-twice = given twice
json-slip-deep = lists and objects inside each other; allowed: up to { $most } levels
json-slip-not-in-json = got { $value_kind }, which JSON does not have

json-wanted-of-kind = { $json_kind }
json-wanted-whole = whole numbers from { $min } to { $max }
json-wanted-match = the number of a match, or a list of four numbers, its place
json-wanted-words = { $words }
json-wanted-other = another value

json-syntax-ended = the text ends before its value does
json-syntax-continued = more text follows the value
json-syntax-no-value = there is no value where one should be
json-syntax-no-name = the name of a field is not in double quotes
json-syntax-no-colon = there is no colon between the name of a field and its value
json-syntax-no-comma-in-list = there is neither a comma nor ] behind an item of a list
json-syntax-no-comma-in-object = there is neither a comma nor {"}"} behind a field of an object
json-syntax-last-comma = there is a comma behind the last item or field
json-syntax-number = a number is not written as JSON writes numbers
json-syntax-large-number = a number is too large
json-syntax-escape = a backslash in a text stands before what may not follow it
json-syntax-control-character = a text holds a line break or another control character
json-syntax-deep = lists and objects stand too deep inside each other

json-kind-null = null
json-kind-boolean = true or false
json-kind-number = a number
json-kind-text = a text
json-kind-list = a list
json-kind-object = an object

# What an option allows. It follows `allowed: `, and stands in the help of the command.
allowed-integer =
    { $odd ->
        [true] odd whole numbers
       *[false] whole numbers
    } from { $min } to { $max }
allowed-real = { $min } to { $max }
allowed-flag = yes or no
allowed-text = text
allowed-object = an object of options
allowed-words = { $words }
allowed-two-numbers =
    { $px ->
        [true] two numbers of px
       *[false] two numbers
    } from { $min } to { $max }
allowed-above-up-to = above { $above }, up to { $max }
allowed-at-least = { $min } or more
allowed-but-zero = { $min } to { $max }, but not 0
allowed-unfolded = terms in mm⁻², mm⁻⁴ and mm⁻⁶ by which the distance from the principal point grows up to { FIXED($reach_mm, digits: 2) } mm, where the corners of the image are
allowed-finite =
    { $numbers ->
        [2] two finite numbers
        [3] three finite numbers
       *[other] { $numbers } finite numbers
    }
allowed-one-of-two = { $first } or { $second }, not both
allowed-odd-for-forstner = odd sides for the Förstner operator
allowed-without-fiducials = { $min } to { $max } where there are no fiducials
allowed-for-photo-coordinates = { $min } to { $max } in formats with photo coordinates
allowed-photo-rows = up to { FIXED($most, digits: 0) } with this width, so that a photo has at most 100 MP
allowed-photo-relief = 0 to { $most_m } for photos, a tenth of the flying height
allowed-height-above-buildings = { $least_m } or more, or no buildings
allowed-small-images-of-tilted = so large that all rays of the tilted cameras fall at 24 degrees or steeper: smaller images
allowed-small-pixels = so small that all rays fall at 24 degrees or steeper
allowed-long-focal-length = long enough that, with these tilts, all rays fall at 24 degrees or steeper
allowed-orthophoto-pixel = above { FIXED($above, digits: 3) }, so that it has at most 100 MP
allowed-height-over-ground =
    up to { FIXED($most_m, digits: 0) } m, so that the { $block ->
        [true] block
       *[false] patch
    } shows at most { $longest_m } m of ground

few-agreeing-observations = observations that agree on a relative orientation
few-different-observations = different observations for the relative orientation
few-different-matches = different matches for the geometry of two views
few-matches-for-fundamental-matrix = matches for the fundamental matrix
few-matches-for-homography = matches for the homography
few-fiducial-marks = fiducial marks
few-images-of-block = images of a block
few-observations-of-point = observations of a point
few-observed-coordinates = too few points for the unknowns of images, points and cameras, counted in image coordinates
few-positions-for-datum = GNSS positions or control points with two observations, for the datum
few-control-points-for-datum = control points, for the datum
few-degrees-of-freedom = degrees of freedom, for covariances
few-intersected-points = intersected points, for the heights of the ground
few-links = links that take part

document-named = { $name }
document-block = the block
document-camera = the camera
document-cameras = the cameras
document-export = the export
document-file = a file
document-folder = the folder
document-geo-tiff = the GeoTIFF
document-heights = the heights
document-kept-record = a kept record
document-orthophoto = the orthophoto
document-project = the project file
document-task = the task of a job

file-place-path = { $path }
file-place-line = line { $line }
file-place-byte = byte { $byte }
file-place-length = length
file-place-checksum = checksum
file-place-content = content

image-operation-forstner-window = the Förstner operator's window
image-operation-ground-operator = the ground operator
image-operation-moravec-window = the Moravec operator's window
image-operation-placing-on-orthophoto = placing on an orthophoto
image-operation-pyramid-of-scales = the pyramid of scales

image-fault-empty = the file is empty
image-fault-damaged = { $format }: { $damage }
image-fault-mask = its mask { $name }: { $error }

## Where an image contradicts its format. They follow the name of the format.

damage-decoder = { $words }
damage-truncated = the file ends before its image does: it is truncated
damage-too-short = it is truncated: { $width } x { $height } px take at least { $least_bytes } bytes, and the file has { $bytes }
damage-no-pixels = it declares { $width } x { $height } px; a side has at least 1 px
damage-beyond-addresses = its size is beyond all addresses
damage-two-sizes = it declares two sizes
damage-other-than-header = the decoder gave another size than the header declares
damage-other-than-directory = the decoder gave another size than the directory declares
damage-unknown-pam-line = its PAM header has an unknown line
damage-incomplete-pam-header = its PAM header lacks WIDTH, HEIGHT, MAXVAL or a DEPTH of 1 to 4
damage-long-header = its header has more than { $most_bytes } bytes
damage-no-number = its header has '{ $word }' where a number belongs
damage-other-canvas = its canvas of ({ $canvas }) px holds a frame of ({ $frame }) px
damage-segment-length = the segment with marker { HEX($marker, digits: 2) } has the length { $length }
damage-unexpected-marker = it has the unexpected marker { HEX($marker, digits: 2) }
damage-no-frame-header = its image data come before its frame header
damage-two-frame-headers = it has two frame headers
damage-frame-header-length = the length of its frame header does not fit its components
damage-restart-interval = its restart interval is cut off
damage-restart-markers = it has { $markers } of { $expected } restart markers, or not in order: data are missing
damage-short-scan = a scan ends before the image does: data are missing
damage-no-image-data = it ends before its image data
damage-no-width = it does not declare its width
damage-no-height = it does not declare its height
damage-two-directory-sizes = its directory declares two sizes
damage-many-tags = its directory has { $tags } tags; up to { $most } are read
damage-many-values = tag { $tag } has { $values } values; up to { $most } are read
damage-colour-map = its colour map has not 3 x 256 entries

## Kinds of files that are not decoded, and what to make of them.

file-kind-heic = HEIC pictures are not read: export them as JPEG (on an iPhone, for new ones: Settings, Camera, Formats, Most Compatible)
file-kind-avif = AVIF pictures are not read: save them as JPEG or PNG
file-kind-jpeg-xl = JPEG XL pictures are not read: save them as JPEG or PNG
file-kind-jpeg2000 = JPEG 2000 pictures are not read: save them as TIFF (gdal_translate in.jp2 out.tif keeps where they lie)
file-kind-ecw = ECW pictures are not read: save them as GeoTIFF (gdal_translate or QGIS keeps where they lie)
file-kind-mr-sid = MrSID pictures are not read: save them as GeoTIFF (gdal_translate or QGIS keeps where they lie)
file-kind-camera-raw = raw pictures of cameras ({ $ending }) are not read: develop them as JPEG or TIFF, at full size and without cropping
file-kind-photoshop = Photoshop documents are not read: save them as TIFF or PNG
file-kind-gif = GIF pictures are not read: save them as PNG
file-kind-pdf = PDF documents are not read: export their pictures as TIFF or PNG
file-kind-video = films are not read: save single pictures of them as JPEG or PNG
file-kind-archive = archives (ZIP, 7z, RAR) are not read: unpack them and give the pictures in them

## What is not decoded.

unsupported-kind = { $file_kind }; allowed: { $formats }
unsupported-file = this kind of file is not supported; allowed: { $formats }
unsupported-decoder = this { $format } ({ $words }) is not supported; allowed: { $formats }
unsupported-tiff-decoder = this TIFF ({ $words }) is not supported; allowed: grey and RGB of 8 or 16 bits, in strips or tiles
unsupported-samples = { $format } with samples { $samples } is not supported; allowed: 8 or 16 bits
unsupported-animated-webp = an animated WebP is not supported; allowed: still images
unsupported-jpeg-arithmetic = arithmetic-coded JPEG (SOF{ $frame }) is not supported; allowed: baseline, extended and progressive Huffman-coded JPEG
unsupported-jpeg-lossless = lossless or hierarchical JPEG (SOF{ $frame }) is not supported; allowed: baseline, extended and progressive Huffman-coded JPEG
unsupported-jpeg-bits = JPEG of { $bits } bits is not supported; allowed: JPEG of 8 bits
unsupported-jpeg-components = JPEG of { $components } components (4: CMYK) is not supported; allowed: grey and three-component colour JPEG
unsupported-jpeg-sampling = JPEG with the sampling factors [{ $sampling }] is not supported; allowed: the first component sampled 1, 2 or 4 times, the others once
unsupported-jpeg-scans = JPEG of more than { $most } scans is not supported; allowed: up to { $most } scans
unsupported-jpeg-rgb-apart = baseline JPEG of RGB whose scans are not one of each component is not supported; allowed: one scan of all components, or one of each
unsupported-jpeg-luma-apart = baseline JPEG with scans of luma and one chroma apart is not supported; allowed: one scan of all components, or one of luma alone
unsupported-tiff-floats = TIFF with floating-point samples is not supported; allowed: unsigned integers of 8 or 16 bits
unsupported-tiff-signed = TIFF with signed or undefined samples is not supported; allowed: unsigned integers of 8 or 16 bits
unsupported-tiff-bits = TIFF of { $bits } bits a sample is not supported; allowed: 8 or 16 bits a sample
unsupported-tiff-colours = TIFF of photometric interpretation { $photometric } with { $samples } samples of { $bits } bits is not supported; allowed: grey (0, 1), RGB (2) with 3 or more samples, palette (3) of 8 bits
unsupported-tiff-compression =
    TIFF with compression { $compression ->
        [50000] 50000 (ZSTD)
        [50001] 50001 (WebP)
        [34925] 34925 (LZMA)
        [34887] 34887 (LERC)
        [34712] 34712 (JPEG 2000)
       *[other] { $compression }
    } is not supported; allowed: none, LZW, JPEG, Deflate, PackBits (1, 5, 7, 8, 32946, 32773), as gdal_translate -co COMPRESS=DEFLATE writes it
unsupported-tiff-tile-side = TIFF with a tile side of more than 65,536 px is not supported; allowed: tile sides of up to 65,536 px
unsupported-tiff-tile-row = TIFF with { $bytes } bytes in a row of a tile is not supported; allowed: up to 16,777,216
unsupported-tiff-bands = TIFF of { $bands } bands with a predictor is not supported; allowed: 1, 3 or 4 bands (the fourth alpha), or no predictor

file-fault-system = { $message }
file-fault-not-text = it is not text (UTF-8)
file-fault-content = { $json_fault }
file-fault-no-number = { $field } is '{ $word }', not a finite number
file-fault-no-whole-number = { $field } is '{ $word }', not a whole number of its range
file-fault-short-line = it ends before { $field }
file-fault-camera-again = camera { $camera } again
file-fault-image-again = image { $image } again
file-fault-point-again = point { $point } again
file-fault-no-camera = camera { $camera } is not in cameras.txt
file-fault-no-image = image { $image } is not in images.txt
file-fault-no-feature = image { $image } has no point { $feature }
file-fault-camera-model = { $model } with { $parameters } parameters; allowed: SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV of one focal length and up to three radial coefficients
file-fault-zero-quaternion = the quaternion is zero
file-fault-after-name = '{ $word }' after the name
file-fault-no-features = the line of its points is missing
file-fault-no-project = it is no project of Tiepoint: its first line is '{ $line }'
file-fault-no-header = it is no project of Tiepoint: its first line is '{ $line }' ({ $json_fault })
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

## Why an input is refused: what it is, what was got, what is allowed.

# General.
refusal-value = { $input }: got { $value } in { $location }; allowed: { $low } to { $high }
refusal-parameter = { $input }: got { $value } in { $field } of { $location }; allowed: { $low } to { $high }
refusal-index =
    { $input }: got index { $index }; allowed: { $count ->
        [0] none, since there are none
       *[other] indices below { $count }
    }
refusal-below = { $input }: got { $index }; allowed: below { $count }
refusal-index-as = { $input }: got { $index } as { $location }; allowed: 0 to { $last }
refusal-nothing-as = { $input }: got { $index } as { $location }; allowed: none: there are none
refusal-count = { $input }: got { $got }; allowed: { $wanted }
refusal-bytes = { $input }: got { $bytes } bytes; allowed: a multiple of { $each } bytes
refusal-numbers = { $input }: got { $numbers } numbers; allowed: a multiple of { $each } numbers
refusal-in-edit = { $refusal } (edit { $edit })

# Cameras and fiducial marks.
refusal-mark-coordinate = fiducial marks: got { $coordinate } = { $value } in mark { $mark }; allowed: numbers from -{ $limit } to { $limit }
refusal-marks-again = fiducial marks: got marks { $first } and { $second } in the same place; allowed: each mark once
refusal-panorama = the camera of the file: got a panorama; allowed: a photograph of a central perspective
refusal-mark-outside = fiducial marks: got a mark at { $col }, { $row } px of an image of { $width } × { $height } px; allowed: marks within the image, or the origin of the image in the scan in which they were measured
refusal-marks-sigma0 = fiducial marks: got σ0 of { FIXED($sigma0_mm, digits: 3) } mm; allowed: up to { $most_mm } mm: marks are exchanged, or one is mistyped
refusal-marks-mirrored = fiducial marks: got marks that lie mirrored in the scan; allowed: a scan of the film as it is seen from above: mirror the scan where the film was scanned from the wrong side, or correct the coordinates
refusal-marks-skew = fiducial marks: got columns and rows of the scan { FIXED($skew_deg, digits: 1) }° off a right angle; allowed: up to { $most_deg }°: marks are exchanged, or one is mistyped
refusal-marks-scales = fiducial marks: got columns and rows of the scan whose lengths on the film differ by { PERCENT($scales, digits: 1) }; allowed: up to { PERCENT($most, digits: 0) }: a coordinate of several marks may be mistyped
refusal-film-beside = scan of film: got { $width_px } x { $height_px } px that lie outside the fiducial marks; allowed: an image with a part of the photograph within its marks
refusal-film-pixel = pixel size of the resampled scan: got { $pixel_mm } mm; allowed: { FIXED($least, digits: 5) } to { FIXED($most, digits: 5) } mm, half to twice that of the scan
refusal-film-without-camera = the camera of the film: got none beside the fiducial marks; allowed: a calibrated camera with its focal length in mm
refusal-lone-origin = origin in the scan: got { $origin } without fiducials; allowed: an origin together with the fiducials measured in that scan
refusal-one-camera = the cameras: got one camera; allowed: both or neither
refusal-one-focal-length = the cameras: got one focal length; allowed: both or neither
refusal-cameras-of-block =
    the camera of a pair: got { $cameras ->
        [one] 1 camera
       *[other] { $cameras } cameras
    } of a block, by the names of their images; allowed: one camera, as a focal length in px or a file with focal_mm, principal_point_mm and pixel_mm, or the project of the block, by which its images have their cameras
refusal-no-cameras = the cameras: got an empty list; allowed: one camera or more
refusal-empty-pattern = the cameras: got an empty pattern of camera { $camera }; allowed: a pattern of names as DJI_*.JPG
refusal-unused-patterns = the cameras: got { $patterns }, which fit no image; allowed: patterns that fit names as { $names }

# The model of a block.
refusal-image-name = image of the block: got the name { $name } of image { $image } (counted from 0); allowed: a name without control characters
refusal-copy-of-image = image of the block: got the same picture as { $name }; allowed: each image once
refusal-image-name-again = image of the block: got the name '{ $name }' for images { $first } and { $second } (counted from 0); allowed: each name once
refusal-camera-of-image = camera of an image: got index { $camera } for '{ $name }'; allowed: indices below { $cameras }
refusal-point-number-again = point of the block: got the number { $number } for points { $first } and { $second } (counted from 0); allowed: each number once
refusal-point-numbers = point of the block: got { $position } with residuals of { $rmse_px } px as point { $point } (counted from 0); allowed: finite numbers
refusal-confidence = point of the block: got a confidence of point { $point } (counted from 0) outside 0 to 1; allowed: 0 to 1
refusal-image-of-point = point of the block: got image { $image } of point { $point } (counted from 0); allowed: indices below { $images }
refusal-ray-outside = point of the block: got the observation of point { $point } (counted from 0) at ({ $x_px }, { $y_px }) in '{ $name }'; allowed: positions within { $width_px } x { $height_px } px
refusal-two-rays = point of the block: got two observations of point { $point } (counted from 0) in '{ $name }'; allowed: one observation per image
refusal-rotation = image of the block: got { $rotation } as rotation of '{ $name }'; allowed: a rotation matrix
refusal-image-position = image of the block: got { $position } as position of '{ $name }'; allowed: finite numbers
refusal-origin = origin of the block: got longitude { $longitude_deg }°, latitude { $latitude_deg }°, height { $height_m } m; allowed: a longitude, a latitude and a height up to 1000 km
refusal-other-coordinates = check point: got another kind of coordinates for { $point }; allowed: those of the control points
refusal-no-height = height: got none of GCP { $point }; allowed: -100000 to 1000000
refusal-measured-image = image measurement of a GCP: got index { $image } as image of GCP { $point }; allowed: indices below { $images }
refusal-measured-outside = image measurement of a GCP: got ({ $x_px }, { $y_px }) for { $point } in { $name }, outside the image; allowed: positions within its { $width_px } x { $height_px } px
refusal-measured-twice = image measurement of a GCP: got two for { $point } in { $name }; allowed: one in an image

# Points and their descriptors.
refusal-mask-size = mask: got { $width } x { $height } px; allowed: the image's { $image_width } x { $image_height } px
refusal-raster-order = points for suppression: got an order or a repetition that is not raster order; allowed: at most one point per pixel, by row, then column
refusal-described-point = point to describe: got ({ $x }, { $y }) with a scale of { $scale_px } px; allowed: positions within the image of { $width } x { $height } px and scales above 0, up to its longer side
refusal-no-moments = descriptors: got { $described } for { $points } points; allowed: moments of each point
refusal-no-gradients = descriptors: got { $described } for { $points } points; allowed: a gradient descriptor of each point

# Matching.
refusal-neighbours-of-others = nearest neighbours: got those of the left points { $rows } among { $among } right ones; allowed: those of the left points 0..{ $left } among { $right } right ones
refusal-left-point = index of a left point: got { $index }; allowed: below { $count }, the number of left points
refusal-guide-matrix = the matrix that guides: got { $value }; allowed: finite numbers
refusal-described-positions = { $input }: got { $positions } positions with { $descriptors } descriptors; allowed: as many descriptors as positions
refusal-described-points = { $input }: got { $points } points with { $descriptors } descriptors; allowed: as many descriptors as points
refusal-described-bytes = { $input }: got { $positions } positions with { $bytes } bytes of descriptors; allowed: { $each } bytes for each position
refusal-far-position = { $input }: got a position of ({ $x }, { $y }); allowed: positions from -1e6 to 1e6 px
refusal-left-rows = rows of left descriptors: got { $first } to { $end }; allowed: ascending, up to { $left }
refusal-piece-lengths = a piece of nearest neighbours: got { $left } and { $right } numbers; allowed: three for each left and two for each right descriptor
refusal-piece-descriptor = a piece of nearest neighbours: got the descriptor { $index }; allowed: descriptors of the piece
refusal-piece-start = a piece of nearest neighbours: got no whole number as first; allowed: one
refusal-next-piece = the next piece of nearest neighbours: got rows from { $row } with { $right } right descriptors; allowed: rows from { $next_row } with { $of_right } right descriptors
refusal-offset-field = offset field: got { $columns } x { $rows } nodes, { $offsets } offsets, spacing { $spacing_px } px; allowed: columns x rows finite offsets and a spacing above 0
refusal-match-position = positions of matches: got { $position } in match { $index } (counted from 0); allowed: -1e6 to 1e6 px

# Orientation.
refusal-shared-errors = shared errors: got effects on { $effects } of { $observations } observations; allowed: one effect for each observation
refusal-oriented-observations = observations: got { $observations }; allowed: the { $oriented } that were oriented
refusal-observation-weight = weight: got { $weight } for observation { $observation } (counted from 0); allowed: 1e-12 to 1e12
refusal-photo-coordinates =
    photo coordinates: got { FIXED($value_mm, digits: 3) } mm in observation { $observation } (counted from 0); allowed: -{ $largest_mm } to { $largest_mm } mm, { $focal_lengths } focal lengths{ $tiny_mm ->
        [none] {""}
       *[other] ; the focal length of { $tiny_mm } mm may be given in metres
    }

# Tie points.
refusal-place-of-image = position of an image: got { $position } of image { $image }; allowed: finite numbers in m
refusal-similar-image = similar images: got image { $other } with similarity { $similarity } in the list of image { $image }; allowed: images below { $images } and numbers
refusal-pair-of-images = pair of images: got [{ $images }]; allowed: two different images of { $count }
refusal-pair-again = pair of images: got [{ $images }] again; allowed: each pair once
refusal-many-features = features of the block: got { $features } or more; allowed: up to { $most } features in all images
refusal-many-matches = pair of images: got more than { $most } matches with it; allowed: fewer matches in all pairs
refusal-matched-features = match: got features [{ $features }] with strength { $strength } as match { $index } of images [{ $images }]; allowed: feature indices below { $left } and { $right }, a strength that is a number
refusal-features-of-images = { $input }: got features of { $images } images; allowed: those of the block's { $wanted } images
refusal-no-feature = points of the block: got feature { $feature } of image { $image }; allowed: features that exist
refusal-no-tie-point = points of the block: got point { $point }; allowed: points below { $points }
refusal-feature-outside = features of the images: got { $position } in image { $image } of { $width_px } x { $height_px } px; allowed: positions inside their image
refusal-lost-feature = features of the images: got none for feature { $feature } of image { $image }; allowed: a position for each observation of the points
refusal-ray-numbers = observation: got position { $position } with scale { $scale_px }; allowed: finite numbers, a scale above 0 px
refusal-ray-direction = direction of an observation: got { $direction_rad }; allowed: finite numbers
refusal-ray-place = observation: got position { $position }; allowed: positions inside the image of { $width } x { $height } px
refusal-window-values = windows of observations: got { $values } grey values for { $windows } windows; allowed: { $side } x { $side } values each
refusal-window-halvings = windows of observations: got { $halvings } halvings; allowed: 0 to { $most }
refusal-window-order = windows of observations: got another order; allowed: windows ordered by observation and halvings, each once

# Adjustment and reconstruction.
refusal-rotation-as = rotation of an image: got { $rotation } as { $location }; allowed: rows at right angles, of length 1, right-handed
refusal-axis-direction = direction of an axis: got { $direction } as { $location }; allowed: a vector of length 1
refusal-prior-again = priors of cameras: got camera { $camera } (counted from 0) twice; allowed: each camera once
refusal-control-again = control points: got point { $point } (counted from 0) twice; allowed: each point once
refusal-ray-again = observations: got two of image { $image } of point { $point } (counted from 0); allowed: at most one for each image and point
refusal-mixed-positions = observed positions: got { $geographic } geographic and { $local } local ones; allowed: either all local or all geographic, or those of images alone and those of { $placing } or more GCPs
refusal-no-model = model of the reconstruction: got { $model }; allowed: models below { $models }
refusal-no-intersection = observations of a point: got { $rays } of { $point_name } that do not meet, or at too small an angle; allowed: rays that meet within { $largest_px } px, at { $least_angle_deg } deg or more
refusal-covariance-image = covariances: got image { $image } of the adjustment (counted from 0), which looks along the X axis; allowed: images with φ off ±90°: there ω and κ are one angle
refusal-covariance-point = covariances: got point { $point } of the adjustment (counted from 0) without accepted observations; allowed: points that took part

# Edits.
refusal-no-observation = image of an observation: got { $location }, which has none of { $point_name }; allowed: images that show the point
refusal-replaced-point = point to restore: got one of which { $point_name } was made and has observations; allowed: undo the step that made { $point_name }, or reject that first
refusal-rejected-point = measured point: got { $point_name }, which takes no part; allowed: points that take part: restore it first
refusal-new-point-images = images of a new point: got { $images } of { $observations } observations; allowed: two or more, each once
refusal-measured-place = measured place: got ({ $x_px }, { $y_px }) in { $location }, outside the image; allowed: places within its { $width_px } x { $height_px } px
refusal-unknown-point = point of an edit: got { $point_name }; allowed: points of the block
refusal-image-not-oriented = image of an edit: got { $location }, which is not oriented; allowed: images of the block that are oriented
refusal-pair-not-connected = pair of an edit: got { $first } and { $second }, which no matches connect; allowed: connected pairs of the block
refusal-block-not-oriented = block of the edits: got one that is not oriented; allowed: an oriented one
refusal-edits-of-other-block = block of the edits: got one of other images, tie points or ground control points; allowed: the same block, placed on an orthophoto or not
refusal-added-control-name = name of a new ground control point: got { $name }, which is empty or that of another one; allowed: a name of its own
refusal-added-control-errors = standard errors of a new ground control point: got { $errors } for { $name }; allowed: numbers above 0

# Exchange formats and tables.
refusal-feature-numbers = COLMAP feature: got { $numbers } as feature { $feature }; allowed: finite numbers
refusal-feature-descriptor = COLMAP feature: got { $numbers } numbers in the descriptor of feature { $feature }; allowed: { $needed } numbers
refusal-own-system = GeoJSON: got a block in a system of its own; allowed: a block whose origin is known: GeoJSON has longitudes and latitudes alone
refusal-name-with-blanks = { $format }: got the image name '{ $name }'; allowed: names without blanks
refusal-name-of-no-file = { $format }: got the image name '{ $name }'; allowed: names of files in a folder
refusal-long-name = { $format }: got the image name '{ $name }' of { $bytes } bytes; allowed: names of up to { $most } bytes
refusal-no-records = { $input }: got { $words }; allowed: lines of fields between semicolons, tabs, commas or blanks
refusal-quoted-lines = { $input }: got '{ $record }' from line { $line } on, a field in quotes that goes on in the next line; allowed: quotes that are closed in their line
refusal-no-column = { $input }: got no column { $column } in the first line '{ $names }'; allowed: a first line that names the columns { $columns }
refusal-column-again = { $input }: got column { $column } twice; allowed: a first line that names the columns { $columns }
refusal-no-value = { $input }: got no value for { $column } in line { $line }; allowed: finite numbers with a decimal point
refusal-no-number = { $input }: got '{ $word }' for { $column } in line { $line }; allowed: finite numbers with a decimal point
refusal-more-fields = { $input }: got '{ $record }' in line { $line }, with more fields than the { $columns } columns that are named: commas separate them here and are no decimal commas; allowed: decimal points, or columns between semicolons or tabs
refusal-blank-fields = { $input }: got '{ $record }' in line { $line }, between blanks where the table has { $columns } columns; allowed: as many words in each line, none of them empty, or columns between semicolons, tabs or commas
refusal-control-column = the table of control points: got neither a column '{ $column }' (or { $known }) nor a point in the first line '{ $names }'; allowed: lines of name, x, y, z and perhaps both standard errors, of place and of height, between semicolons, tabs, commas or blanks
refusal-head-unit = { $input }: got the column '{ $column }' in { $given_in }; allowed: coordinates in { $own }, or in a coordinate system of that unit (--crs)
refusal-control-error-column = the table of control points: got the column '{ $column }' without the other standard errors; allowed: lines of name, x, y, z and perhaps both standard errors, of place and of height
refusal-control-error-unit = the table of control points: got the column '{ $column }', in a unit that is not known; allowed: standard errors in { $units }
refusal-control-numbers = the table of control points: got { $numbers } numbers behind the name in line { $line } ('{ $record }') and no names of columns; allowed: x, y, z; these and both standard errors, of place and of height; or these and those of x, y and height, each above 0 and up to { $most_m } m. Decimal commas are read between semicolons, tabs or blanks
refusal-control-lone-error = the table of control points: got one number, '{ $word }', behind the coordinates in line { $line } and no names of columns; allowed: both standard errors, of place and of height, or a line that names the columns
refusal-decimal-commas = { $input }: got '{ $record }' in line { $line }, whose commas separate columns, and may be meant as decimal commas; allowed: decimal points, in one of the numbers at least (1024.0 for 1024), or columns between semicolons, tabs or blanks
refusal-thousands = { $input }: got '{ $word }' for { $column } in line { $line }, which seems to have signs before its thousands; allowed: numbers without them
refusal-thousands-commas = { $input }: got '{ $record }' in line { $line }, where no number of the table says whether commas stand before thousands or are decimal commas; allowed: decimal points, and no signs before thousands
refusal-column-unit =
    { $input }: got the column '{ $column }', in a unit that is not known; allowed: { $degrees ->
        [true] degrees or { $units }
       *[false] { $units }
    }
refusal-system-line = { $input }: got the first line '{ $words }', as tables of OpenDroneMap begin; allowed: lines of name, x, y, z of points in one table and of image, point, x, y of their measurements in another, and the coordinate system by itself (--crs)
refusal-control-number = the table of control points: got '{ $word }' for { $column } in line { $line }; allowed: lines of name, x, y, z and perhaps both standard errors, of place and of height
refusal-control-name = the table of control points: got the name '{ $name }' in line { $line }, which is empty or comes twice; allowed: lines of name, x, y, z and perhaps both standard errors, of place and of height
refusal-control-errors = the table of control points: got standard errors { $errors } in line { $line }, which are not above 0; allowed: lines of name, x, y, z and perhaps both standard errors, of place and of height
refusal-reserved-name = name of a ground control point: got { $name }; allowed: names that do not begin with { $begins }, as those of places of an orthophoto do
refusal-control-use = the table of control points: got '{ $word }' as use in line { $line }; it is control (or GCP), check (or check point) or off, and a lone CP may be either of the first two; allowed: lines of name, x, y, z and perhaps both standard errors, of place and of height
refusal-measured-column = the table of image measurements: got no column '{ $column }' (or { $known }) in the first line '{ $names }', which names others elsewhere than in the order of image, point, x, y; allowed: a first line that names all four, or lines of image, point, x, y
refusal-measured-numbers = the table of image measurements: got '{ $x }', '{ $y }' as place in line { $line }; allowed: lines of image, point, x, y with decimal points, each point once in an image
refusal-measured-names = the table of image measurements: got no name of image or point in line { $line }; allowed: lines of image, point, x, y with decimal points, each point once in an image
refusal-measured-again = the table of image measurements: got point '{ $point }' in image '{ $image }' again in line { $line }; allowed: lines of image, point, x, y with decimal points, each point once in an image
refusal-position-column = the table of image positions: got no column '{ $column }' (or { $known }) in the first line '{ $names }'; allowed: a first line of column names, as image,latitude,longitude,height or image,easting,northing,height, or lines of image, x, y, height
refusal-position-kinds = the table of image positions: got the column '{ $x }' beside '{ $y }'; allowed: longitude beside latitude, or easting beside northing
refusal-position-number = the table of image positions: got '{ $word }' for { $column } in line { $line }; allowed: finite numbers (as ExifTool writes them with -n), in a row with any coordinate at least longitude and latitude, or x and y
refusal-position-side = the table of image positions: got '{ $word }' for { $column } beside '{ $value }' in line { $line }; allowed: N or S beside a latitude and E or W beside a longitude, whose signs do not contradict them; 0 or 1 beside an altitude above or below sea level
refusal-no-positions =
    the table of image positions: got { $rows ->
        [0] no row
        [1] one row without coordinates
       *[other] { $rows } rows without coordinates
    } and no position; allowed: lines of image, longitude, latitude, height or image, x, y, height below a line that names these columns
refusal-position-name = the table of image positions: got the name '{ $name }' in line { $line }; allowed: file names of images, not empty and without control characters
refusal-position-errors = the table of image positions: got the standard error { $errors } in line { $line }; allowed: numbers above 0, or empty fields
refusal-position-again = the table of image positions: got a position of '{ $image }' again in line { $line }; allowed: each image once
refusal-position-order = the table of image positions: got { $x }, { $y } in line { $line }, which may be latitude and longitude or longitude and latitude; allowed: a first line that names the columns, as image,latitude,longitude,height
refusal-position-degrees = the table of image positions: got longitude { $longitude_deg } and latitude { $latitude_deg } in line { $line }; allowed: longitudes -180 to 180 and latitudes -90 to 90, in degrees

# Coordinate reference systems.
refusal-unknown-crs = coordinate reference system: got { $crs }, a code that is unknown here, or of a projection or a kind that is not supported; allowed: EPSG codes of geographic and projected systems, or PROJ text
refusal-crs-text = coordinate reference system: got { $crs }, which cannot be read ({ $reason }); allowed: an EPSG code (EPSG:25832), WKT, or PROJ text with one of the projections { $projections }
refusal-geocentric-crs = coordinate reference system: got { $crs }, whose axes meet in the centre of the earth; allowed: geographic and projected systems
refusal-crs-axes = coordinate reference system: got { $crs }, which states a datum shift and has north before east; allowed: east before north beside a stated shift
refusal-no-datum-shift =
    coordinate reference system: got { $crs }{ $name ->
        [none] {""}
       *[other] {" "}({ $name })
    }, whose datum no known shift without a grid leads to WGS 84 from; allowed: PROJ text with +datum=WGS84, or with the shift as +towgs84 (+towgs84=0,0,0 where the datum is WGS 84 but for some decimetres)
refusal-crs-area = coordinate reference system: got { $crs } at longitude { FIXED($longitude_deg, digits: 4) }°, latitude { FIXED($latitude_deg, digits: 4) }°, where no shift of its datum to WGS 84 is known; allowed: positions in { $areas }. Check the zone and the order of the coordinates
refusal-crs-place =
    coordinates: got ({ $x }, { $y }), which lie outside { $crs }; allowed: { $degrees ->
        [true] longitude as x, -180 to 180, and latitude as y, -90 to 90, in degrees
       *[false] easting as x and northing as y in the unit of this system
    }
refusal-outside-crs = places: got longitude { FIXED($longitude_deg, digits: 4) }°, latitude { FIXED($latitude_deg, digits: 4) }°, which lie outside { $crs }; allowed: longitude and latitude of places that its projection shows
refusal-control-place =
    ground control point { $point }: got ({ $x }, { $y }), which lie outside { $crs }; allowed: { $degrees ->
        [true] longitude as x, -180 to 180, and latitude as y, -90 to 90, in degrees
       *[false] easting as x and northing as y in the unit of this system
    }
refusal-control-degrees = ground control point { $point }: got ({ $x }, { $y }), which look like degrees; allowed: easting as x and northing as y, as { $crs } has them
refusal-control-system =
    the table of control points: got the coordinate system '{ $words }' in line { $line } { $crs ->
        [none] and no other
       *[other] beside { $crs }
    }; allowed: points in the coordinate system of the block (--crs)
refusal-position-system =
    the table of image positions: got the coordinate system '{ $words }' in line { $line } { $crs ->
        [none] and no other
       *[other] beside { $crs }
    }; allowed: positions in the coordinate system of the block (--crs), or longitudes and latitudes of WGS 84 (EPSG:4326)
refusal-position-without-crs = the table of image positions: got ({ $x }, { $y }) in line { $line }, which are no longitude and latitude, without a coordinate system; allowed: longitudes and latitudes in degrees, or a coordinate system of x and y (--crs)
refusal-position-place =
    the table of image positions: got ({ $x }, { $y }) in line { $line }, { $degrees ->
        [true] which look like degrees; allowed: easting and northing as { $crs } has them, or columns named longitude and latitude
       *[false] which lie outside { $crs }; allowed: easting as x and northing as y in the unit of this system
    }
refusal-control-elsewhere =
    ground control point { $point }: got a place { FIXED($distance_km, digits: 0) } km from the GNSS positions of the images, as { $crs } has it; allowed: up to { $most_km } km. { $swapped ->
        [true] With x and y exchanged it lies near them: x is the easting or longitude
       *[false] { $zone ->
            [none] { $likely ->
                [none] Is the zone right, or are the GNSS positions wrong? Without these it takes part as it is
               *[other] With { $likely } it lies near them
            }
           *[other] In zone { $zone } it lies near them
        }
    }
refusal-control-zone =
    ground control points: got eastings that begin with the number of a zone ({ $zone }, in { $x }), which { $crs } has without it; allowed: { $code ->
        [none] {""}
       *[other] --crs { $code }, or{" "}
    }eastings without the { $zone } ({ $short })
refusal-control-unit =
    ground control points: got coordinates that lie { $near ->
        [true] near the images
       *[other] in the area of this system
    } if they are in { $given_in }; allowed: coordinates in { $crs }, whose unit is { $own }
refusal-geoid-of-ellipsoid = height of the geoid: got { $geoid_m } m beside { $crs }, whose heights are ellipsoidal; allowed: 0, or a system of the plane, or one with heights above sea level
refusal-geoid-file-of-ellipsoid = geoid: got { $name } beside { $crs }, whose heights are ellipsoidal; allowed: no geoid, or a system of the plane, or one with heights above sea level
refusal-no-geoid = geoid: got { $name }, which is not a geoid file that can be read; allowed: a GeoTIFF of longitudes and latitudes with north up, a GTX, or a PGM of GeographicLib
refusal-geoid-elsewhere = geoid: got { $name }, which covers longitudes { FIXED($west, digits: 2) } to { FIXED($east, digits: 2) } and latitudes { FIXED($south, digits: 2) } to { FIXED($north, digits: 2) }, for a block at { FIXED($longitude_deg, digits: 4) }, { FIXED($latitude_deg, digits: 4) }, of longitudes { FIXED($block_west, digits: 4) } to { FIXED($block_east, digits: 4) } and latitudes { FIXED($block_south, digits: 4) } to { FIXED($block_north, digits: 4) }; allowed: a geoid that covers the block
refusal-geoid-height =
    geoid: got { $height ->
        [none] no height
       *[other] { FIXED($height, digits: 2) } m
    } in { $name } at { FIXED($longitude_deg, digits: 4) }, { FIXED($latitude_deg, digits: 4) }; allowed: heights above the ellipsoid from -200 to 200 m all about the block
refusal-geoid-nodes = geoid: got { $columns } x { $rows } heights about the block in { $name }; allowed: up to { $most }
refusal-geoid-twice = height of the geoid: got { $geoid_m } m and the file { $name }; allowed: one of them
refusal-geoid-without-crs = geoid: got { $name } without a coordinate system; allowed: a system whose heights count from it (placing.crs)
refusal-geoid-without-place = geoid: got { $name } for a block that has no place on the earth; allowed: images with GNSS positions, or control points

# The run of a block.
refusal-measured-beyond = image measurements: got ({ $x_px }, { $y_px }) for { $point } in { $name }, outside any image; allowed: positions within the image
refusal-measured-unknown = image measurements: got the point { $point }; allowed: points of the table of control points
refusal-few-control-points =
    ground control points: got { $placing ->
        [0] { $checks ->
            [true] check points alone, which do not georeference the block
           *[false] none
        }
       *[other] { $seen } of { $placing }{ $checks ->
            [true] {" "}(check points do not count)
           *[false] {""}
        } measured in two images or more
    }{ $images_count ->
        [0] {""}
       *[other] ; the block does not have the images { $images }{ $images_more ->
            [0] {""}
           *[other] {" "}…
        }
    }; allowed: { $needed } or more{ $placing ->
        [0] {" "}measured in two images or more
       *[other] {""}
    }, or { $checks ->
        [true] neither ground control points nor check points
       *[false] none at all
    }; any number beside GNSS positions of three images or more in the same coordinate system (--crs), where heights count from a known zero (--geoid, --geoid-m), or beside an orthophoto (--orthophoto)
refusal-job-inputs = inputs of a job: got { $inputs }; allowed: those that it names
refusal-mask-of-image = its mask: got { $name } with { $width } x { $height } px; allowed: the image's { $image_width } x { $image_height } px
refusal-file-name-again = images of the block: got two with the name { $name }; allowed: each name once
refusal-file-name = images of the block: got the name { $name }, which holds a control character; allowed: names without them
refusal-coarse-descriptors = coarse descriptors: got { $bytes } bytes; allowed: { $each } bytes each
refusal-stray-masks =
    masks: got { $masks }{ $masks_more ->
        [0] {""}
       *[other] {" "}and { $masks_more } more
    }, { $masks_count ->
        [one] which belongs
       *[other] which belong
    } to none of the images; allowed: masks with the names of images, as IMG_1.png, IMG_1_mask.png or IMG_1.jpg.png for IMG_1.jpg
refusal-two-masks = masks: got { $first } and { $second }, which belong to the same image; allowed: one mask per image
refusal-refined-observations = observations of a point: got { $first } to { $end }; allowed: ascending indices up to { $windows }
refusal-freed-object = the object was freed, or moved into another one; allowed: objects that are neither
refusal-unknown-job = job: got { $job }; allowed: jobs that are under way
refusal-few-images =
    images of the block: got { $read } that could be read, of { $given }{ $first ->
        [none] {""}
       *[other] {" "}({ $first }: { $failure })
    }; allowed: two or more
refusal-chosen-feature = observations: got feature { $feature }; allowed: features below { $features }

# The ground: orthophotos, heights, mosaics.
refusal-link-position = position of a link: got { $position }, of link { $link }; allowed: within the image of { $width_px } x { $height_px } px
refusal-link-beside-frame = position of a link: got { $position }, of link { $link }; allowed: within the fiducial marks of the scan
refusal-link-place = place of a link: got { $place }, of link { $link }; allowed: where the ground of the orthophoto has a height
refusal-place-without-height = place of the ground: got { $place }; allowed: where the ground of the orthophoto has a height
refusal-place-system = place of an orthophoto: got one of a system from which nothing leads to { $crs } ({ $failure }); allowed: places of an orthophoto whose system leads there
refusal-world-file = world file: got { $text }; allowed: six numbers, one per line: A, D, B, E of the pixel, X and Y of the centre of the top-left pixel
refusal-georeference = georeference: got { $numbers }; allowed: finite coordinates and pixels with an extent
refusal-mirrored-picture =
    georeference of a picture of the ground: got A = { $a }, D = { $d }, B = { $b }, E = { $e } of its pixels, as a world file has them, by which { $rows_go_north ->
        [true] rows go north (E above 0)
       *[false] the picture is mirrored
    }; allowed: rows that go south where columns go east (A above 0, E below 0), or such a picture turned as a whole (A·E - B·D below 0). gdalwarp writes it so
refusal-degrees = coordinates of a picture of the ground: got longitude and latitude in degrees; allowed: a projected system in metres or feet: reproject it, with gdalwarp -t_srs say
refusal-height-count = height model: got { $heights } heights for { $width } x { $height }; allowed: one height for each node, of 2 x 2 nodes or more; a truncated file has fewer
refusal-height-range = heights of a height model: got { $low } to { $high }; allowed: -1000 to 20000, with at least one; what stands for 'no height' must be declared
refusal-no-height-model = height model: got neither a TIFF nor text; allowed: a GeoTIFF or an ESRI ASCII grid
refusal-heights-without-place = height model: got a TIFF that does not say where it lies; allowed: a GeoTIFF, or a world file beside it
refusal-many-heights = heights: got { $width } x { $height } heights; allowed: up to 100 million, or 4,000 million in a GeoTIFF whose tiles or strips have up to 16 million
refusal-heights-of-picture = heights: got a TIFF of whole numbers of 8 bits, as pictures have them; allowed: numbers of 16 bits or more, or a GeoTIFF that says by a vertical system or unit, or by scale and offset of GDAL, that they are heights
refusal-height-samples = heights: got a TIFF of samples of another kind; allowed: one sample per pixel: whole numbers or floating point
refusal-grid-word = ESRI ASCII grid: got { $name } without a number; allowed: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, nodata_value, then the heights row by row
refusal-grid-lacks = ESRI ASCII grid: got no { $name }; allowed: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, nodata_value, then the heights row by row
refusal-grid-size = ESRI ASCII grid: got { $columns } columns, { $rows } rows of { $cell }; allowed: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, nodata_value, then the heights row by row
refusal-grid-height = ESRI ASCII grid: got { $word } among the heights; allowed: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize, nodata_value, then the heights row by row
refusal-picture-without-place = orthophoto: got a { $format } that does not say where it lies; allowed: a GeoTIFF, or a world file beside the image (.tfw, .jgw, .pgw, .wld)
refusal-orthophoto-unit = orthophoto: got a unit of length with the EPSG code { $code }; allowed: 9001 (metre), 9002 (foot), 9003 (foot of the US survey)
refusal-orthophoto-system =
    coordinate reference system of an orthophoto: got { $described ->
        [none] none
       *[other] { $described }, which is described without a code, and not by all parameters of a transverse Mercator or Lambert conformal conic projection in degrees from Greenwich
    }; allowed: an EPSG code, which gdal_edit.py -a_srs EPSG:25832 writes, say, or nothing where the block has a projected system
refusal-nothing-above-ground = block for a mosaic: got no oriented image above the ground; allowed: one or more
refusal-mosaic-pixel = side of a pixel of the mosaic: got { $gsd }; allowed: { FIXED($least, digits: 4) } or more, so that the mosaic has at most { $megapixels } MP, and what waits for further images has room in memory
refusal-mosaic-name = image of a mosaic: got { $name }; allowed: oriented images of the block: { $names }
refusal-mosaic-image = image of a mosaic: got index { $image }; allowed: one of the model
refusal-mosaic-image-size = image of a mosaic: got { $width } x { $height } px; allowed: { $width_px } x { $height_px } px, as its camera
refusal-mosaic-without-images = mosaic: got no oriented image; allowed: images of the block, added one by one before it is finished
refusal-empty-mosaic = mosaic: got nothing that an image shows; allowed: heights under the images, below them, and a pixel much smaller than an image
refusal-map-in-degrees = coordinate reference system of the block: got { $crs }, in degrees; allowed for a picture of the ground: a projected system, as that of its UTM zone: run the block with another `--crs`
refusal-outside-map = place of the block: got one outside { $crs }; allowed: within that coordinate reference system
refusal-heights-system = system of the height model: got { $heights }; allowed: { $ground }, that of the orthophoto or block: convert the heights first, with gdalwarp -t_srs say
refusal-no-heights-there = heights of a height model: got none under the orthophoto; allowed: a model of the same ground in the same system
refusal-one-coordinate = place near an image: got one coordinate; allowed: near_x and near_y, or neither
refusal-near-place = place near an image: got { $place }; allowed: within { $within_m } m of the orthophoto, whose corners are at { $first } and { $last }
refusal-near-radius = radius about the place near an image: got { $within_m } m; allowed: so much that { $least_px } px of the orthophoto a side lie within it
refusal-folded-image = radial distortion of the camera of { $camera }: got { $radial }, which folds the image well within its corners; allowed: terms of distances from the principal point by the focal length, both in px, by which these grow
refusal-camera-size = camera of the image: got { $width_px } x { $height_px } px; allowed: { $width } x { $height } px, as the image
refusal-grey-values = grey image: got { $width } x { $height } px with { $values } values; allowed: sides of at least 1 px and width x height values

# Epipolar images.
refusal-epipolar-name = image of epipolar images: got { $name }; allowed: the names of images of the project
refusal-epipolar-names = images of epipolar images: got { $name } twice; allowed: two images
refusal-epipolar-not-oriented = image of epipolar images: got { $name }, which is not oriented; allowed: oriented images
refusal-epipolar-no-pair = block for epipolar images: got no two oriented images with points in common; allowed: one pair or more
refusal-epipolar-base = images of epipolar images: got { $left } and { $right }, which have no base (pure rotation); allowed: images that were taken apart
refusal-epipolar-along-base = images of epipolar images: got { $left } and { $right }, which look along their base; allowed: images that look across their base
refusal-epipolar-overlap = images of epipolar images: got { $left } and { $right }, which have no rows and columns in common; allowed: images that overlap
refusal-epipolar-image-size = image of epipolar images: got { $width } x { $height } px for { $name }; allowed: { $width_px } x { $height_px } px, as in the project

# Simulated photos and their truth.
refusal-photo-position = position in a photo: got { $position }; allowed: positions inside the photo of { $width_px } x { $height_px } px
refusal-truth-of-others = truth of the block: got none of the block's images; allowed: a truth of these images
refusal-truth-not-oriented = truth of the block: got '{ $name }' without orientation; allowed: oriented images
refusal-truth-distortion = truth of the block: got distortion of camera { $camera }; allowed: cameras without distortion
refusal-truth-size = truth: got { $positions } positions for { $width } x { $height } px; allowed: one position for each pixel of the left image

# Covariances of a finished block.
refusal-covariances-not-oriented = covariances: got a block that is not oriented; allowed: an oriented block
refusal-covariances-unsupported = covariances: got a project of a former version, without all points of its adjustment; allowed: projects that keep all points of their adjustment
refusal-covariance-unknowns = covariances: got { $unknowns } unknowns; allowed: 1 to { $most } unknowns: six per image, three per point
refusal-covariance-again = name of a covariance: got { $name } twice; allowed: each name once
refusal-accuracy-images = map of the expected accuracy: got a block with { $images } images; allowed: up to { $most }
refusal-accuracy-sigma = standard error of an image coordinate: got { $sigma_px } px; allowed: above 0, up to 1000 px
refusal-accuracy-cell = side of a cell of the map: got { $cell }; allowed: { FIXED($least, digits: 4) } to { FIXED($most, digits: 4) }, in units of the block
refusal-covariance-name = name of a covariance: got { $name }; allowed: names of oriented images and of adjusted ground control and check points, point:N as in points.csv, camera:N as in images.csv, or all

# Projects.
refusal-pair-match = match of the pair: got { $left } and { $right }; allowed: points below { $points } and { $others }
refusal-pair-found = found matches of the pair: got verdicts on { $found } points; allowed: at most { $points }
refusal-pair-place = place of an edited match: got { $got }; allowed: finite numbers of px
refusal-pair-rejected = rejected match of the pair: got { $index }; allowed: matches below { $matches }
refusal-project-connection = connection of the project: got [{ $images }]; allowed: two images below { $count } in ascending order
refusal-project-geoid = geoid of the project: got numbers that are none of a grid; allowed: as many heights as it has rows and columns, two or more
refusal-step-without-edits = steps of the edits: got one without edits; allowed: one edit or more in each
refusal-project-edits = edits of the project: got those of a block that is not oriented; allowed: edits of an oriented block
refusal-project-image = image of the project: got '{ $name }' of camera { $camera }; allowed: '{ $other }' of camera { $other_camera }
refusal-project-index = model of the project: got index { $index }; allowed: images below { $images } and cameras below { $cameras }
refusal-project-camera = model of the project: got camera { $camera } of an image; allowed: cameras below { $cameras }
refusal-project-strip = model of the project: got strip { $strip } of an error of GNSS positions; allowed: strips below { $strips }
refusal-project-order = model of the project: got images that are not in order; allowed: images in ascending order, each once
refusal-project-observation = model of the project: got an observation of point { $point } in image { $image }; allowed: images below { $images } and points below { $points }

## What is given.

input-axis-sigma = sigma of an axis
input-base = base
input-camera-distortion = distortion of a camera
input-camera-focal-length = focal length of a camera
input-camera-of-image = camera of an image
input-camera-of-prior = camera of a prior
input-camera-parameter = parameter of a camera
input-camera-principal-point = principal point of a camera
input-camera-sigma = sigma of a camera
input-features-of-images = features of the images
input-fiducial-table = the table of fiducials
input-control-table = the table of control points
input-free-radial = free radial coefficients
input-height = height
input-image = image
input-image-coordinates = image coordinates
input-image-of-ray = image of an observation
input-image-size = size of the images
input-geometries-of-project = geometries of the project
input-images-of-project = images of the project
input-cameras-of-project = cameras of the project
input-points-of-project = points of the project
input-edits-of-steps = edits of all steps together
input-observations-of-point = observations of a point of the project
input-images-of-model = images of a model of the project
input-images-of-block = images of an adjusted block of the project
input-cameras-of-block = cameras of an adjusted block of the project
input-points-of-model = points of a model of the project
input-observations-of-model = observations of a model of the project
input-places-of-strip = places of the images of a strip of the project
input-verdicts-of-pair = verdicts of the pair
input-matched-of-pair = matched points of the pair
input-frames-of-pair = frames of points of the pair
input-observations-of-pair = observations of the pair
input-residuals-of-pair = residuals of the pair
input-scores-of-pair = scores of the pair
input-latitude = latitude
input-left-descriptors = left descriptors
input-left-features = left features
input-left-points = left points
input-longitude = longitude
input-mark-table = the table of image measurements
input-observation-table = the table of observations
input-photo-of-block = photo of the block
input-pixel-side = side of a pixel
input-point = point
input-point-of-control = point of a control point
input-point-of-ray = point of an observation
input-points-of-block = points of the block
input-position = position
input-position-sigma = sigma of a position
input-position-table = the table of image positions
input-mark-sigma = sigma of an image measurement
input-ray-sigma = sigma of an observation
input-right-descriptors = right descriptors
input-right-features = right features
input-right-points = right points
input-surveyed-point = ground control or check point
input-surveyed-point-of-block = ground control or check point of the block
input-text = the text
input-weight = weight

## Where a value stands.

location-camera = camera { $camera } (counted from 0)
location-named-camera = { camera }
location-camera-of-file = camera { $camera } of the file
location-camera-of-images = the camera of { $images }
location-camera-of-image = camera of the image
location-camera-of-prior = camera of a prior
location-control = GCP { $name }
location-element-of-control = { $element } of control point { $control } (counted from 0)
location-element-of-image = { $element } of image { $image } (counted from 0)
location-element-of-ray = { $element } of observation { $ray } (counted from 0)
location-geometry = geometry.{ $side }
location-image = { $name }
location-image-index = index { $image }
location-pair = the pair
location-point = point { $point } (counted from 0)
location-prior = prior of camera { $camera } (counted from 0)

element-axis-direction = direction of the axis
element-axis-sigma = sigma of the axis
element-camera = camera
element-coordinates = coordinates
element-gnss-position = GNSS position
element-gnss-sigma = GNSS sigma
element-image = image
element-point = point
element-position = position
element-rotation = rotation
element-sigma = sigma
element-weight = weight

point-name-control = { $name }
point-name-control-index = ground control or check point { $point }
point-name-manual = point by hand { $number }
point-name-tie-point = tie point { $number }

described-none = none
described-moments = { $descriptors } of moments
described-gradients = { $bytes } bytes of gradients

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

no-geometry-too-few-matches = only { $matches } different candidate matches are there, and a geometry takes at least { $needed }; none is kept
no-geometry-chance = only { $agreeing } of { $matches } candidate matches agree on one geometry, no more than would by chance; none is kept

camera-origin-xmp-calibration = XMP (calibrated)
camera-origin-xmp-dewarped = XMP (calibrated, distortion already removed)
camera-origin-xmp-design = XMP (as designed)
camera-origin-exif-focal-plane = EXIF
camera-origin-exif35-mm = EXIF (35 mm equivalent)
camera-origin-sensor-table = EXIF and the listed size of its sensor
camera-origin-focal-length-alone = EXIF (focal length in mm alone)
camera-origin-panorama = XMP (panorama)

camera-caution-resized = taken with { $taken_width_px } x { $taken_height_px } px, the file has { $width_px } x { $height_px } px: resized or cropped? Its focal length in px is that of a resized photo
camera-caution-cropped = taken with { $taken_width_px } x { $taken_height_px } px, but the file has { $width_px } x { $height_px } px: it was cropped, and its focal length in px is not known; give the camera if you know it
camera-caution-focal-plane = EXIF gives pixels of { SIGNIFICANT($pixel_um, digits: 2) } µm, but with this sensor or its 35 mm equivalent those of this photo are { SIGNIFICANT($expected_um, digits: 2) } µm large: it was resized or cropped, and its focal length in px is not known; give the camera if you know it
camera-caution-contradiction = XMP gives a focal length of { FIXED($xmp_focal_px, digits: 0) } px, EXIF of { FIXED($exif_focal_px, digits: 0) } px: that of EXIF is used
camera-caution-panorama = a panorama ({ $projection }): it has no central perspective, and no camera

no-orientation-too-few-matches =
    { $matches ->
        [0] no match was found
        [one] only 1 match was found
       *[other] only { $matches } matches were found
    }, and an orientation takes at least { $needed } (do both photos show the same ground?)
no-orientation-no-camera = no camera is given and the { $side } image names no focal length
no-orientation-no-focal-length = fiducial marks are given, but no focal length
no-orientation-no-pixel-size = the focal length of the { $side } image is known in mm, but not in px: neither fiducial marks nor a pixel size is known
no-orientation-altered = the { $side } image was altered: { $camera_caution }
no-orientation-contradicted-focal = nothing fits the given focal length of { FIXED($given_px, digits: 0) } px, and the file of the { $side } image says { FIXED($file_px, digits: 0) } px (is the camera that of another photo size, lens or zoom, or a value mistyped?)
no-orientation-far-principal-point = nothing fits the principal point, which lies { SIGNIFICANT($sides, digits: 2) } times the longer side of the { $side } image from its middle, where up to { $most } times is usual (are its coordinates in another unit, or from another origin?)
no-orientation-panorama = the { $side } image is a panorama: it has no central perspective, and no camera
no-orientation-no-geometry = no geometry of the two views: { $no_geometry }
no-orientation-pure-rotation = no base that can be told (pure rotation): within the precision of the matches the photos differ by a rotation alone, as where the base is short beside the distance of what they show
no-orientation-plane-without-camera = nearly all matches fit the homography of one plane, as those of flat ground and of a rotation alone do, and that determines no focal length: give the camera
no-orientation-one-photo = no base: both images show the same at the same places (is it one photo twice?)
no-orientation-parts-of-one-image = no base: the images differ by a shift, a turn and a scale alone; both may be parts of one image
no-orientation-refused = { $error }

## What the result of a pair is worth.

pair-verdict-oriented = Oriented from { $points } points, σ0 { $sigma0_px ->
        [none] { SIGNIFICANT($sigma0_um, digits: 2) } µm
       *[other] { FIXED($sigma0_px, digits: 2) } px
    }; the right photo is turned in its plane (κ) by { LIKE($kappa_deg, $half_width_deg, digits: 2) }° ± { SIGNIFICANT($half_width_deg, digits: 2) }°{ $axes_deg ->
        [none] {""}
       *[other] , the camera axes are { LIKE($axes_deg, $worst_half_width_deg, digits: 2) }° apart
    }{ $worst ->
        [omega] , ω is known to ± { SIGNIFICANT($worst_half_width_deg, digits: 2) }°
        [phi] , φ is known to ± { SIGNIFICANT($worst_half_width_deg, digits: 2) }°
        [base] , the direction of the base is known to ± { SIGNIFICANT($worst_half_width_deg, digits: 2) }°
       *[kappa] {""}
    } (95 %).
    .label = oriented
pair-verdict-weak = Weak orientation from { $points } points. { $warning }
    .label = weak
pair-verdict-not-oriented = Not oriented: { $no_orientation }.
    .label = not oriented

## What else would do for a pair.

pair-hint-other-strategy = This strategy compares windows as they stand in both photos: where these are turned, of another scale or overlap elsewhere, the strategy “auto” finds more.
pair-hint-unknown-camera = The strategy “auto” also orients photos of an unknown camera, which it finds by the matches; this one needs the camera.
pair-hint-turned = The right photo is turned in its plane by { FIXED($turn_deg, digits: 0) }°: this strategy compares windows as they stand in both photos, and takes up to ± { $most_deg }°. Use the strategy “auto”, or rotate the right image back first.
pair-hint-scaled = The right photo shows the same { SIGNIFICANT($scale, digits: 2) } times as large as the left one: this strategy compares windows as they stand in both photos, and takes up to { $most } times, either way. Use the strategy “auto”, or resize one image first.
pair-hint-turned-and-scaled = The right photo is turned in its plane by { FIXED($turn_deg, digits: 0) }° and shows the same { SIGNIFICANT($scale, digits: 2) } times as large as the left one: this strategy compares windows as they stand in both photos, and takes up to ± { $most_deg }° and { $most } times, either way. Use the strategy “auto”.
pair-hint-displaced = The offset of the right photo is { FIXED($dx_px, digits: 0) }, { FIXED($dy_px, digits: 0) } px, where { FIXED($expected_dx_px, digits: 0) }, { FIXED($expected_dy_px, digits: 0) } px was expected: matches were looked for within ± { $most_px } px of that. Give the offset { FIXED($dx_px, digits: 0) }, { FIXED($dy_px, digits: 0) } px, or use the strategy “auto”.

## What the geometry of two views is, and where it is degenerate.

two-view-model-calibrated = orientation of calibrated cameras
    .label = calibrated cameras
    .estimated = cameras with the focal length estimated from the matches
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
degeneracy-pure-rotation = No base that can be told (pure rotation): within the precision of the matches the photos differ by a rotation alone, so nothing can be oriented.
    .short = no base

## Warnings about a relative orientation.

warning-plane = All points lie in a plane within their precision: a second orientation fits nearly as well (its σ0 is { FIXED($ratio, digits: 2) } times as large; from { FIXED($least, digits: 2) } it is excluded).
warning-clustered = The points cover a small part of the photo (root mean square { FIXED($coverage, digits: 2) } focal lengths from their middle; at least { $least } is sound).
warning-rotation = The photos differ by little more than a rotation: the base is too short to be distinguished from noise and distortion (parallax { SIGNIFICANT($parallax_deg, digits: 2) }°; at least { SIGNIFICANT($least_deg, digits: 2) }° is sound).
warning-ill-conditioned = The unknowns are hardly separable, as over a critical cylinder (condition { POWER($condition, digits: 1) }; up to { POWER($most, digits: 0) } is sound).
warning-unchecked = { $observations } observations hardly check each other: a gross error in one of them is not found unless it is very large, nor do the standard errors show it. Measure more points.
warning-identical =
    { $copies ->
        [one] 1 observation is the same as another
       *[other] { $copies } observations are the same as others
    } to the last digit: each counts once.
warning-behind =
    { $points ->
        [one] 1 point is
       *[other] { $points } points are
    } rejected: the rays meet behind a camera, as those of wrong matches and of mirrored coordinates do.
warning-sigma = The residuals contradict the given σ0: it is { SIGNIFICANT($estimated_um, digits: 3) } µm, not { SIGNIFICANT($given_um, digits: 3) } µm. Standard errors and tests use the estimated one.
warning-doubtful-base = The given base of { SIGNIFICANT($base_mm, digits: 3) } mm is { SIGNIFICANT($times, digits: 2) } times as long as that at photo scale; up to { $most } times is plausible. by and bz are as many times too long: is it the base on the ground, or in another unit?
warning-few-places = The matches lie in { $places ->
        [one] 1 place
       *[other] { $places } places
    } of the photo; at least { $least } are needed.
warning-few-matches = Only { $matches } matches took part: so few can agree on a repeated pattern. At least { $least } are needed to exclude it.
warning-few-agree = Only { $accepted } of { $matches } matches agree with the orientation.
warning-mirrored = The right photo shows the ground mirrored.
warning-mirrored-marks = The fiducial marks lie mirrored in the { $side } image: is the scan mirrored, or are their coordinates?
warning-unknown-camera = The focal length is hardly known, and the matches do not determine it; the intervals may not hold: give the camera.
warning-contradicted-focal = The given focal length is { FIXED($given_px, digits: 0) } px, but the file of the { $side } image says { FIXED($file_px, digits: 0) } px: is the camera that of another photo size, lens or zoom?
warning-doubtful-focal = The focal length of the { $side } photo is { SIGNIFICANT($sides, digits: 2) } times the longer side of its image, where { $least } to { $most } times are usual: check the focal length and the pixel size.
warning-far-principal-point = The principal point of the { $side } photo lies { SIGNIFICANT($sides, digits: 2) } times the longer side of its image from the middle, where up to { $most } times is usual: check its coordinates and their unit.
warning-doubtful-distortion = The distortion of the { $side } photo takes a corner of its image to { SIGNIFICANT($factor, digits: 2) } times its distance from the principal point, where { $least } to { $most } times are usual: check the terms, which are in mm⁻², mm⁻⁴ and mm⁻⁶.
warning-resized-or-cropped = The file of the { $side } image has fewer pixels than its EXIF data says ({ $width_px } x { $height_px }, not { $taken_width_px } x { $taken_height_px }): resized or cropped? Its camera is hardly known, and the intervals may not hold: give the camera.
warning-cropped = The { $side } image was cropped: its file has { $width_px } x { $height_px } px, its EXIF data says { $taken_width_px } x { $taken_height_px }. Its camera is hardly known, and the intervals may not hold: give the camera.
warning-unused-pixel = The pixel size of the camera, { SIGNIFICANT($pixel_mm, digits: 3) } mm, is not used: by the fiducial marks a pixel of the scan is { SIGNIFICANT($marks_mm, digits: 3) } mm large.
warning-other-pixels = The { $side } image was resized or cropped: its EXIF data gives pixels of { SIGNIFICANT($pixel_um, digits: 2) } µm, where its sensor or its 35 mm equivalent gives { SIGNIFICANT($expected_um, digits: 2) } µm. Its camera is hardly known, and the intervals may not hold: give the camera.
warning-similarity-alone = The images hardly differ by more than a shift, a turn and a scale, as parts of one image do and level photos over flat ground may: where they are parts of one image, the orientation is wrong.
warning-exact = σ0 is { SIGNIFICANT($sigma0_px, digits: 1) } px, as of parts of one image; two photographs do not agree to better than { $least_px } px.
warning-wide-angle = The points reach far from the axis for their focal length (root mean square { FIXED($coverage, digits: 2) } focal lengths from their middle; up to { $most } is common): is the focal length too short?
warning-uncertain = The rotation is known to ± { SIGNIFICANT($half_width_deg, digits: 2) }° only (95 %); up to ± { $most_deg }° is acceptable.
warning-uncertain-base = The direction of the base is known to ± { SIGNIFICANT($half_width_deg, digits: 2) }° only (95 %); up to ± { $most_deg }° is acceptable.
warning-imprecise = σ0 is { FIXED($sigma0_px, digits: 1) } px; matching reaches { FIXED($most_px, digits: 1) } px where the camera and its distortion are right. The intervals may not hold.
warning-coarse = σ0 is { SIGNIFICANT($sigma0_um, digits: 2) } µm, where measuring reaches { SIGNIFICANT($most_um, digits: 2) } µm at this focal length: many of the observations are grossly wrong and no test tells which, or the focal length is in another unit.
warning-focal-length = The residuals ask for a focal length that differs by { FIXED($change_percent, digits: 2) } % ({ FIXED($w, digits: 1) } standard errors), which would move the result out of its 95 % intervals.
warning-unchecked-focal = Half the focal length fits nearly as well (its σ0 is { FIXED($ratio, digits: 2) } times as large; from { FIXED($least, digits: 2) } it is excluded): the view is narrow and the ground nearly level, so that the photos do not check the given one.

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
failure-refused =
    { $error ->
        [none] { $message }
       *[other] { $error }
    }
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
unoriented-rejected-by-hand = it was rejected by hand

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
overview-warning-few-oriented = More than a fifth of the images could not be oriented.
overview-warning-apart = { $images } images are oriented apart from the others, in a model of their own.
overview-warning-not-on-orthophoto = The block is not in the system of the orthophoto, and is as it was without it: { $not_linked }.
overview-warning-focal-apart = With the orthophoto the focal length of { $label } is { FIXED($estimated_px, digits: 1) } px where { FIXED($prior_px, digits: 1) } px was known, { FIXED($apart, digits: 1) } standard deviations of that apart: check the camera, the heights and their unit.
overview-warning-few-matches = Only { $matches } matches join the two images: so few can agree on a repeated pattern. At least { $least } are needed to exclude it.
overview-warning-no-points = No tie point is left: nothing that takes part shows how the images lie.
overview-warning-none-oriented = No image could be oriented.
overview-warning-doubtful-camera = A camera is hardly the right one ({ $remark }).
overview-warning-failed = No image could be oriented: { $failure }.

## Warnings about an adjusted block.

block-warning-free =
    { $without_heights ->
        [0] No observed positions determine the position, rotation and scale of the model
        [one] The GNSS position does not determine the position, rotation and scale of the model, since its height above the zero of the control points is not known (--geoid, --geoid-m), and no control points that fit do
       *[other] The { $without_heights } GNSS positions do not determine the position, rotation and scale of the model, since their heights above the zero of the control points are not known (--geoid, --geoid-m), and no control points that fit do
    }: they are arbitrary{ $cause ->
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
block-warning-looking-up = Most views look up, { FIXED($tilt_deg, digits: 0) }° off the vertical. Unless they show a ceiling, two axes of the { $observed } are exchanged, as where a file has north before east, or heights point down.
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
block-warning-weights-not-converged = Weights by the residuals still changed after { $rounds } rounds of weighting: standard errors that were stated do not fit each other.
block-warning-no-heights = No heights of GNSS positions take part: the flight is taken as level, heights count from it, and the block may be tilted.
block-warning-positions-rejected =
    { $images_count ->
        [one] 1 GNSS position does not fit and is rejected, with its distance
       *[other] { $images_count } GNSS positions do not fit and are rejected, with their distances
    }: { $images }{ $images_more ->
        [0] .
       *[other] {" "}and { $images_more } more.
    }
    .images = { $name } ({ FIXED($distance_m, digits: 1) } m)
block-warning-positions-apart =
    In { $axis } all GNSS positions differ alike from what { $held_by ->
        [places] the places of the orthophoto
        [both] the control points and places of the orthophoto
       *[surveyed] the control points
    } say, by { FIXED($difference_m, digits: 2) } m, { FIXED($times, digits: 1) } times the standard error of this difference: { $axis ->
        [z] { $held_by ->
            [places] they and the heights of the orthophoto may count from different zeros, such as the ellipsoid and sea level (--geoid-m), these may be off as a whole, or
            [both] they, the control points and the heights of the orthophoto may count from different zeros, such as the ellipsoid and sea level (--geoid-m), heights may be off as a whole, or
           *[surveyed] they and the control points may count heights from different zeros, such as the ellipsoid and sea level (--geoid-m), or
        }
       *[other] they and { $held_by ->
            [places] the orthophoto
            [both] the control points and the orthophoto
           *[surveyed] the control points
        } may be in different systems, or
    } the positions have an offset in common (--gnss-errors offset).{ $images_m ->
        [none] {""}
       *[other] {" "}The images have followed them by { FIXED($images_m, digits: 2) } m, which their standard errors do not cover.
    }{ $focal ->
        [true] {" "}Focal lengths that are estimated, and the heights of the images with them, are wrong by part of it.
       *[false] {""}
    }{ $control ->
        [true] {" "}Control points that do not fit may be right.
       *[false] {""}
    }
block-warning-positions-elsewhere =
    The GNSS positions of the table lie { SIGNIFICANT($distance_km, digits: 3) } km from those that { $images ->
        [one] the file of 1 image records
       *[other] the files of { $images } images record, in the median
    }. { $place_slip ->
        [none] { $in_crs ->
            [true] Are they of these images and in the system that is named, or are those of the files wrong?
           *[false] Are they of these images, or are those of the files wrong?
        }
       *[other] { $place_slip }
    }
block-warning-position-errors-undetermined =
    { $errors ->
        [one] 1 systematic error of GNSS positions is not determined and taken as zero
       *[other] { $errors } systematic errors of GNSS positions are not determined and taken as zero
    }: ground control points determine offsets, and images flown in several directions lever arms.
block-warning-position-errors-relative = Offsets and drifts of GNSS positions are relative to each other: there are too few ground control points to determine { $motions } of the 7 parameters that position, rotate and scale the whole block.
block-warning-control-refused =
    { $used ->
        [true] The { $axis } of control point { $point } does not fit
       *[false] The { $axis } of control point { $point } is rejected
    }: the other observations differ from it by { FIXED($difference_m, digits: 3) } m ± { FIXED($error_m, digits: 3) } m{ $detectable_m ->
        [none] {""}
       *[other] {" "}(minimal detectable bias { FIXED($detectable_m, digits: 3) } m)
    }. { $used ->
        [true] The point stays used, since too little is left without it to tell whether it is wrong.
       *[false] { $certain ->
            [true] The point takes no part.
           *[false] The point takes no part, since its image measurements do not fit its coordinates. Too little is left without it to tell whether it or another GCP is wrong.
        }
    }{ $mistake ->
        [none] {""}
       *[other] {" "}{ $mistake }
    }
block-warning-control-untested =
    Control point { $point } takes no part: { $measurements ->
        [one] it has one image measurement only
       *[other] fewer than two of its { $measurements } image measurements fit the other observations
    }, so that nothing tests its coordinates. Check both.
block-warning-control-unplaced =
    Control point { $point } is rejected and takes no part: with it the GCPs do not place the block, though its coordinates fit the other observations. Check its { $measurements ->
        [one] image measurement
       *[other] { $measurements } image measurements
    }.
block-warning-control-contradicts =
    { $refused } of { $points } GCPs contradict each other or the other observations{ $w ->
        [none] {""}
       *[other] {" "}by up to w = { FIXED($w, digits: 1) }
    }, and nothing tells which of them are wrong: they stay used. Check their coordinates and standard errors, their system and units, and the GNSS positions.
block-warning-control-tests-stopped =
    The tests of the GCPs stopped: they were to leave out { $left_out } of { $points }, without { $left_out ->
        [one] which
       *[other] all of which
    } the block cannot be adjusted. All GCPs stay used, wrong ones too. Check their coordinates and image measurements.
block-warning-control-unadjusted =
    The block cannot be adjusted with { $names_count ->
        [one] control point { $names }, which lies
       *[other] { $names_count } control points, which lie
    } far from where the others have { $names_count ->
        [one] it. It takes
       *[other] them: { $names }{ $names_more ->
            [0] .
           *[other] {" "}and { $names_more } more.
        } They take
    } no part, and the block is adjusted without being georeferenced. Check coordinates and image measurements.
block-warning-control-lost =
    { $lost } of { $points } measured GCPs { $lost ->
        [one] takes no part, or by one image measurement alone, since its image measurements do not fit
       *[other] take no part, or by one image measurement alone, since their image measurements do not fit
    }{ $control_apart ->
        [none] {""}
       *[other] {" "}their coordinates
    }: { $from_bottom ->
        [true] they would with rows counted from the bottom of the images. Here y is 0 at the top: use the height of the image minus y.
       *[other] { $control_apart ->
            [none] check which images and points they name, and that they are in px of these images, x to the right, y from the top down.
           *[other] { $control_apart }
        }
    }
block-warning-check-refused =
    The { $axis } of check point { $point } differs from the block by { FIXED($difference_m, digits: 3) } m ± { FIXED($error_m, digits: 3) } m (adjusted minus surveyed): its coordinates or its image measurements are wrong, or the block is where it lies.{ $mistake ->
        [none] {""}
       *[other] {" "}{ $mistake }
    }
block-warning-checks-apart =
    { $points ->
        [one] The check point differs
       *[other] The { $points } check points all differ
    } from the block in { $axis }, by { FIXED($difference_m, digits: 2) } ± { FIXED($error_m, digits: 2) } m (adjusted minus surveyed): { $axis ->
        [z] do their heights count from another zero, such as the ellipsoid or sea level, or from another point of the marks?
       *[other] are they in another coordinate reference system?
    }
block-warning-stated-errors =
    { $columns_count ->
        [one] The column
       *[other] The columns
    } { $columns } of the { $observed } { $columns_count ->
        [one] gives
       *[other] give
    } standard errors of { SIGNIFICANT($stated, digits: 2) } in the median, taken as metres{ $residual_m ->
        [none] {""}
       *[other] , though residuals are those of { SIGNIFICANT($residual_m, digits: 2) } m
    }: the { $observed } hardly count. If the numbers are in { $unit }, write that behind the { $columns_count ->
        [one] name of the column
       *[other] names of the columns
    }: { $unit ->
        [millimetres] (mm)
       *[other] (cm)
    }.
block-warning-control-elsewhere =
    No image measurement of the { $points ->
        [one] { $check ->
            [true] check point
           *[false] GCP
        }
       *[other] { $points } { $check ->
            [true] check points
           *[false] GCPs
        }
    } is in an image of the block. { $images_count ->
        [0] The table of measurements names none of the points.
       *[other] The table of measurements names { $images }{ $images_more ->
            [0] {""}
           *[other] {" "}and { $images_more } more
        }: give images in it the names of their files.
    }
block-warning-control-without-place =
    { $given ->
        [one] The GCP does
       *[other] The { $given } GCPs do
    } not place the block: { $measured } of them { $measured ->
        [one] is
       *[other] are
    } measured in two of its images or more, and the measurements of { $taken } meet. Three are needed, or GNSS positions beside them.
block-warning-control-shape =
    Control points { $names }{ $names_more ->
        [0] {""}
       *[other] {" "}and { $names_more } more
    } do not fit together, so that they do not place the block: by their coordinates the block is { SIGNIFICANT($ratio, digits: 3) } times as large between { $longest } as between { $shortest }. { $point ->
        [none] Nothing tells which of them is wrong: check the coordinates of all.
       *[other] Without { $point } the others fit together: check its coordinates first.
    }
block-warning-few-control =
    { $points ->
        [one] Only 1 GCP
       *[other] Only { $points } GCPs
    } and { $positions ->
        [0] no GNSS positions
        [one] 1 GNSS position
       *[other] { $positions } GNSS positions
    } place the block: { $detectable_m ->
        [none] nothing checks some of the coordinates, and an error in them does not show.
       *[other] they hardly check each other, and the minimal detectable bias of a coordinate is { FIXED($detectable_m, digits: 2) } m.
    }
block-warning-control-span = The { $points } GCPs span { FIXED($span_percent, digits: 1) } % of the ground of the block: beyond them errors grow with the distance.
block-warning-control-on-line =
    The { $points } GCPs lie almost on a line, { FIXED($width_percent, digits: 1) } % as wide as long: they hardly determine the rotation about it{ $error_deg ->
        [none] .
       *[other] , and the angles of all images are uncertain by ± { SIGNIFICANT($error_deg, digits: 2) }° or more.
    }
block-warning-scale =
    The GCPs make the block { SIGNIFICANT($ratio, digits: 2) } times as large as the GNSS positions: { $unit ->
        [none] metres are needed.
       *[other] are they in { $unit }?
    }
block-warning-degrees = The x and y of the GCPs look like longitude and latitude: name their coordinate system (--crs EPSG:4326), or give coordinates in metres.
block-warning-point-rejected =
    { $check ->
        [true] Check point { $point } is not determined
       *[false] Control point { $point } takes no part
    }: { $measurements ->
        [one] it is measured in one oriented image.
       *[other] its { $measurements } image measurements in oriented images do not meet.
    }
block-warning-measurements-rejected =
    { $images_count } of the { $measurements ->
        [one] 1 image measurement
       *[other] { $measurements } image measurements
    } of { $check ->
        [true] check
       *[false] control
    } point { $point } { $images_count ->
        [one] does
       *[other] do
    } not fit: { $images }{ $images_more ->
        [0] .
       *[other] {" "}and { $images_more } more.
    }
block-warning-focal-estimated = The focal length of { $camera } is not known; it is estimated with a standard error of ± { FIXED($error_px, digits: 1) } px.
block-warning-focal-undetermined = The focal length of { $camera } is not known, and the block does not determine it: the scale of the heights is wrong.
block-warning-focal-of-ground = The images by themselves make the focal length of { $camera } { FIXED($images_px, digits: 1) } ± { FIXED($images_error_px, digits: 1) } px, the places of the orthophoto { FIXED($ground_px, digits: 1) } ± { FIXED($ground_error_px, digits: 1) } px, further apart than chance has them: heights of the images may be as wrong. Give a calibrated camera, or check the orthophoto and its heights.
block-warning-orthophoto-apart =
    The orthophoto has the block { AMOUNT($plan_m, digits: 0) } m from the GNSS positions of its images in plan, in the median of { $images }, where { AMOUNT($usual_m, digits: 0) } m are usual at most: check the coordinate system of the orthophoto and the positions.
block-warning-orthophoto-heights-apart =
    The orthophoto has the block { AMOUNT($height_m, digits: 1) } m { SIGN($height_m) ->
        [minus] below
       *[plus] above
    } the GNSS positions of its images, in the median of { $images }, where { FIXED($usual_m, digits: 1) } m are usual at most: check the heights, which are off as a whole or count from another zero than the positions, as sea level in place of the ellipsoid (--heights-geoid-m), and the positions.
block-warning-orthophoto-heights-scatter = Heights of the orthophoto's ground lie ± { FIXED($scatter_m, digits: 1) } m about where the block has them, by { $checks } places that check it, where ± { FIXED($stated_m, digits: 1) } m are stated: some are off, as in a part of the ground, or all are less precise (--height-sigma-m); heights of the images may be as wrong.
block-warning-parameter-fixed = The block does not determine { $camera_parameter } of { $camera }; it keeps its approximate value.
block-warning-few-observations =
    { $images_count ->
        [one] 1 image has
       *[other] { $images_count } images have
    } fewer than { $least } observations: { $images }{ $images_more ->
        [0] .
       *[other] {" "}and { $images_more } more.
    }
block-warning-two-rays = { $two } of { $points } points of the adjustment have two rays only: their errors along the base do not show.
block-warning-many-rejected = { $rejected } of { $observations } observations are gross errors.

observed-positions = GNSS positions
observed-points = GCPs
observed-both = GNSS positions and GCPs

axis-x = x
axis-y = y
axis-z = z

mistake-exchanged = Its x and y seem to be exchanged.
mistake-sign = The sign of its { $axis } seems to be wrong: { $given }.
mistake-decimal-point = The decimal point of its { $axis } seems to be misplaced: { $given } where { $likely } would fit.
mistake-feet = Its height seems to be in feet: { $given } ft are { $likely } m.
mistake-metres = Its height seems to be in metres: { $given } m are { $likely } ft.
mistake-digit = A digit of its { $axis } seems to be mistyped: { $given } where { $likely } would fit.
mistake-transposed = Two neighbouring digits of its { $axis } seem to be transposed: { $given } where { $likely } would fit.
mistake-zone = Its coordinates seem to be those of zone { $zone }.
mistake-name = Its image measurements fit the coordinates of { $other }: the names of the two seem to be exchanged.

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
remark-result-system =
    images.csv, points.csv and surveyed.csv are in { $crs }{ $accuracy_m ->
        [none] {""}
       *[other] . The shift from WGS 84 is that of { $operation }, accurate to { SIGNIFICANT($accuracy_m, digits: 1) } m
    }{ $gnss_above_m ->
        [none] {""}
       *[other] . Its heights count from a level of their own: heights of GNSS positions took no part. They are about { AMOUNT($gnss_above_m, digits: 0) } m { SIGN($gnss_above_m) ->
            [minus] lower
           *[plus] higher
        } than those of the block: roughly the height of the geoid (--geoid, --geoid-m) where they are above the ellipsoid
    }
remark-ellipsoidal-heights = heights in images.csv, points.csv and surveyed.csv are above the ellipsoid, as those of the GNSS positions, and not those of { $crs }: the geoid is not given (--geoid, --geoid-m)
remark-gnss-without-system =
    the GNSS { $positions ->
        [one] position of 1 image takes
       *[other] positions of { $positions } images take
    } no part: the coordinate reference system of the control points is not named; name it (--crs)
remark-geoid = heights count from the geoid of { $name }, which lies { FIXED($low_m, digits: 2) } to { FIXED($high_m, digits: 2) } m above the ellipsoid where the images are
remark-no-result-system = the results are not in { $crs }: the block is not georeferenced, which control points that fit would do, or GNSS positions whose heights count from the same zero
remark-orthophoto-system-assumed = the orthophoto does not say its coordinate reference system: it is taken to be in { $crs }
remark-orthophoto-converted =
    places of the orthophoto were converted from { $orthophoto } to { $crs }{ $accuracy_m ->
        [none] {""}
       *[other] , accurate to { SIGNIFICANT($accuracy_m, digits: 1) } m by the shifts of their datums
    }
remark-orthophoto-elsewhere =
    { $images ->
        [1] the GNSS position of the image does not lie
       *[other] no GNSS position of the { $images } images lies
    } within { FIXED($within_m, digits: 0) } m of the orthophoto: as { $crs } has it, the nearest is { SIGNIFICANT($distance_km, digits: 3) } km from it. { $place_slip } All of it is searched
remark-orthophoto-heights =
    heights of the orthophoto's ground count from { $from_ellipsoid ->
        [true] the ellipsoid
       *[false] a geoid or level of the sea
    }, as their file says ({ $heights }), those of { $crs } from { $from_ellipsoid ->
        [true] a geoid
       *[false] the ellipsoid
    }: the block lies { $above_m ->
        [none] off in height by the height of the geoid
       *[other] { AMOUNT($above_m, digits: 1) } m too { SIGN($above_m) ->
            [minus] low
           *[plus] high
        }
    }; convert the heights, or say with --geoid, --geoid-m or --crs that both count from one zero
remark-mosaic-heights =
    heights of the mosaic's ground count from { $from_ellipsoid ->
        [true] the ellipsoid
       *[false] a geoid or level of the sea
    }, as their file says ({ $heights }), those of { $crs } from { $from_ellipsoid ->
        [true] a geoid
       *[false] the ellipsoid
    }: the ground lies { $above_m ->
        [none] off in height by the height of the geoid
       *[other] { AMOUNT($above_m, digits: 1) } m too { SIGN($above_m) ->
            [minus] low
           *[plus] high
        }
    }, and what images show of it is off in plan; convert the heights
remark-mosaic-without-place = the block has neither GNSS positions nor control points: the mosaic is in a system of the block's own, in which lengths are no metres, north is not known, and the ground need not be level
remark-mosaic-without-system = the mosaic's coordinates are metres east and north of latitude { FIXED($latitude_deg, digits: 6) }, longitude { FIXED($longitude_deg, digits: 6) }, which its file cannot say: with --crs the block has a system that it can
remark-orthophoto-units = the orthophoto has eastings and northings in units of { $unit_m } m; heights of its ground are taken in units of { $height_unit_m } m
remark-unsupported-edits = the project file was written before all adjusted points were kept: with edits the block is adjusted by the selected ones alone, and is less precise
remark-unmeasured-points =
    no image measurement names these control and check points, which take no part: { $points }{ $points_more ->
        [0] {""}
       *[other] {" "}and { $points_more } more
    }
remark-points-without-coordinates =
    these points have no coordinates in the table of control points and take no part: { $points }{ $points_more ->
        [0] {""}
       *[other] {" "}and { $points_more } more
    }
remark-unknown-points =
    image measurements of these points take no part, since the table of control points does not have them: { $points }{ $points_more ->
        [0] {""}
       *[other] {" "}and { $points_more } more
    }
remark-unknown-columns =
    columns of the table of control points are not understood and not read: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}and { $columns_more } more
    }
remark-doubled-columns =
    columns of the table of control points give what another column gives (in brackets) and are not read: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}and { $columns_more } more
    }
remark-unnamed-errors =
    columns of the table of control points without names are read as standard errors in m: { $columns }; name the columns where they are something else
remark-unknown-mark-columns =
    columns of the table of image measurements are not understood and not read: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}and { $columns_more } more
    }
remark-unnamed-position-errors =
    columns of the table of image positions without names are read as standard errors in m: { $columns }; name the columns where they are something else
remark-unknown-position-columns =
    columns of the table of image positions are not understood and not read: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}and { $columns_more } more
    }
remark-position-heights =
    heights are not read for { $positions ->
        [one] 1 position
       *[other] { $positions } positions
    } of the table of image positions: its column '{ $column }' is not understood, or has no heights above the ellipsoid, which longitudes and latitudes need
remark-doubled-position-columns =
    columns of the table of image positions give what another column gives (in brackets) and are not read: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}and { $columns_more } more
    }
remark-positions-of-other-images =
    { $all ->
        [true] the table of image positions names none of the images, and no position of it is used; it names
       *[false] the table of image positions names other images, too:
    } { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}and { $images_more } more
    }
remark-unused-camera = the camera of { $images } fits the name of no image
remark-doubtful-focal =
    the focal length of { $label } is { $focal_px } px, { SIGNIFICANT($sides, digits: 2) } of the longer side of the image, where { $least } to { $most } are usual{ $in_mm ->
        [true] : is it in mm?
       *[false] {""}
    }
remark-far-principal-point = the principal point of { $label } lies { SIGNIFICANT($sides, digits: 2) } times the longer side of the image from its middle, where up to { $most } times is usual
remark-contradicted-focal =
    the focal length of { $label } is given as { SIGNIFICANT($focal_px, digits: 4) } px, where the files of these images say { SIGNIFICANT($file_px, digits: 4) } px: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}and { $images_more } more
    }
remark-cautioned-cameras =
    { $camera_caution }: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}and { $images_more } more
    }
remark-like-scans =
    { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}and { $images_more } more
    } look like scans of film, by a frame that they have in common or by sizes that differ a little: if they are, measure their fiducial marks and make images of one camera of them (tiepoint film), of which a block is made
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
verdict-not-converged = Rejected: least squares matching does not confirm it within its limits of shape, distance and iterations; or it does not confirm the match of its descriptor, and confirmed matches around it lead elsewhere.
    .label = Not confirmed
verdict-imprecise = Rejected: the standard error of its right position is too large, as on an edge along which it can slide.
    .label = Imprecise
verdict-frame = Rejected: it has the same position in both frames, as the border of the film, fiducial marks and data strips have.
    .label = Frame
verdict-gross-error = Matched, then rejected from the relative orientation: its standardised residual exceeds the limit that α₀ sets.
    .label = Gross error
verdict-undecided = No match uses this point.
    .label = Not matched

# What came of the orthophoto that a block was given.
on-orthophoto-linked =
    { $in_crs ->
        [true] The block is adjusted by the orthophoto in its coordinate reference system,
       *[false] The block lies in the system of the orthophoto,
    } by { $points } places that { $linked } of { $images } images show{ $checks ->
        [0] , without check points
        [one] ; 1 more checks it
       *[other] ; { $checks } more check it
    }{ $rejected ->
        [0] .
       *[other] ; { $rejected } were rejected.
    }
on-orthophoto-by-hand =
    { $in_crs ->
        [true] The block is adjusted by the orthophoto in its coordinate reference system,
       *[false] The block lies in the system of the orthophoto,
    } by { $points } places that were measured by hand in { $linked } of { $images } images.
on-orthophoto-not-linked = The block is not in the system of the orthophoto, and is as it was without it: { $not_linked }.

# Where the image measurements of control points meet.
control-apart-heights = these meet { AMOUNT($up_m, digits: 2) } m { SIGN($up_m) ->
        [minus] below
       *[plus] above
    } them in the median, and hardly apart in plan. Do the heights count from another zero (--geoid-m), or are they in another unit?
control-apart-places = these meet { FIXED($across_m, digits: 2) } m from them in plan and { AMOUNT($up_m, digits: 2) } m { SIGN($up_m) ->
        [minus] below
       *[plus] above
    } them, in the median. Are they in another coordinate reference system, or in another unit?

# How an orthophoto, or positions of a table, may have come to lie elsewhere than the images.
place-slip-zone = In zone { $zone } of UTM that would be the place: is the system named wrong?
place-slip-exchanged = With x and y exchanged that would be the place: x is the easting.
place-slip-other-half = In the same zone of the other half of the earth (north or south) that would be the place: is the system named wrong?
place-slip-unit = With coordinates in { $given_in } that would be the place.
place-slip-coordinate = With { $likely } in the middle that would be the place.
place-slip-exchanged-positions = With latitude and longitude exchanged in the positions these would be there: check their order.
place-slip-latitude-sign = With latitudes of the other sign the positions would be there: is north written for south, or the sign missing?
place-slip-longitude-sign = With longitudes of the other sign the positions would be there: is east written for west, or the sign missing?
place-slip-both-signs = With latitudes and longitudes of the other sign the positions would be there: are the signs missing?
place-slip-unknown = Is it the orthophoto of these images, is its system the right one, or are the positions wrong?

# Why a block is not in the system of an orthophoto.
not-linked-not-oriented = it is not oriented
not-linked-own-system = it has the coordinate reference system { $crs }, in which the version that ran it did not adjust by an orthophoto
not-linked-other-system =
    its coordinate reference system is { $crs }, and nothing leads there from that of the orthophoto{ $orthophoto ->
        [none] {""}
       *[other] , { $orthophoto }
    } ({ $failure }). Give --crs the system of the orthophoto, or reproject the orthophoto
not-linked-few-images = { $placed } of { $images } images could be placed on the orthophoto, { $needed } are needed: check that it shows the same ground, and that the heights are those of this ground
not-linked-few-points = { $points } places of its ground are shown by two images or more, { $needed } are needed
not-linked-disagreement = { $rejected } of { $points } places of its ground contradict the block: check the heights
not-linked-contradiction = the ground control points contradict it. The orthophoto has the block { FIXED($x_m, digits: 2) } m in X, { FIXED($y_m, digits: 2) } m in Y and { AMOUNT($z_m, digits: 2) } m { SIGN($z_m) ->
        [minus] below
       *[plus] above
    } where they have it: check the system and the heights of both
not-linked-failed = { $failure }

# Why an image has no place on an orthophoto.
not-placed-no-common-place =
    { $matches ->
        [0] no point resembles a place of the orthophoto
       *[other] of { $matches } points that resemble places of the orthophoto, { $agreeing } agree on one place, as chance would have it
    }
not-placed-no-orientation = { $points } points agree on a place, and no orientation of the image fits them: the camera may be wrong, the heights, or the place and pixels of the orthophoto
not-placed-not-confirmed = { $agreeing } of { $links } points lie where the orientation that was found has them, as chance would have it
not-placed-failed = { $failure }

# What speaks against the place of an image.
placing-weakness-few-links = Only { $links } points link it with the orthophoto; { $needed } are needed.
placing-weakness-coverage = Points lie in { PERCENT($share, digits: 0) } of the image; { PERCENT($needed, digits: 0) } are needed.
placing-weakness-checks = { $beyond } of { $checks } points that took no part contradict the orientation.
placing-weakness-height = The height above ground, { FIXED($height_m, digits: 0) } m, is known to ± { SIGNIFICANT($half_width_m, digits: 2) } m only (95 %): give a calibrated camera, and how well the heights are known (--height-sigma-m).
placing-weakness-rejected = { $rejected } of { $links } points were rejected: check the heights and the camera.
placing-weakness-plan = The place of the projection centre is known to ± { SIGNIFICANT($half_width_m, digits: 2) } m only (95 %), { FIXED($height_m, digits: 0) } m above ground: check the camera, the heights, and how well they are known (--height-sigma-m).
placing-weakness-camera = The points ask for { $camera_parameter } of { FIXED($estimated_px, digits: 1) } px where { FIXED($prior_px, digits: 1) } px was known, { FIXED($apart, digits: 1) } standard deviations of that apart: check the camera and the heights.
placing-weakness-contradicted-focal = The focal length is given as { SIGNIFICANT($given_px, digits: 4) } px, where the file of the image says { SIGNIFICANT($file_px, digits: 4) } px: with a wrong one the height is wrong by as much. Check the camera.
placing-weakness-height-factor = The points ask for differences of height { FIXED($factor, digits: 2) } ± { SIGNIFICANT($standard_error, digits: 1) } times those of the heights: check that the heights are of this ground, and in the unit of the orthophoto.
placing-weakness-relief = In { PERCENT($displaced, digits: 0) } of the image the points lie together elsewhere than the heights put them: check that the heights are of this ground, and in the unit of the orthophoto. One level stands for level ground alone.
placing-weakness-gnss = It lies { FIXED($plan_m, digits: 0) } m from its GNSS position in plan, where { FIXED($usual_m, digits: 0) } m are usual at most: check the coordinate system of the orthophoto, the heights and the position.
placing-weakness-far-from-gnss = It lies { SIGNIFICANT($distance_km, digits: 3) } km from its GNSS position. { $place_slip }
placing-weakness-gnss-height =
    It lies { AMOUNT($height_m, digits: 1) } m { SIGN($height_m) ->
        [minus] below
       *[plus] above
    } its GNSS position, where { FIXED($usual_m, digits: 1) } m are usual at most: check the heights, which are off as a whole or count from another zero than the position, as sea level in place of the ellipsoid (--heights-geoid-m), and the position.
placing-weakness-noise = Residuals are { FIXED($rmse_px, digits: 2) } px in the root mean square, where good pictures reach { FIXED($usual_px, digits: 2) } px: check the heights and the age of the orthophoto.

# How an image with a GNSS position was sought on an orthophoto.
place-search-gnss = Found within { FIXED($within_m, digits: 0) } m of its GNSS position, { FIXED($plan_m, digits: 1) } m from it in plan.
place-search-apart-from-gnss = It lies { FIXED($plan_m, digits: 0) } m from its GNSS position in plan, which is right to { FIXED($usual_m, digits: 0) } m as a rule: check the coordinate system of the orthophoto, the heights and the position.
place-search-far-from-gnss = It lies { SIGNIFICANT($distance_km, digits: 3) } km from its GNSS position. { $place_slip }
place-search-height-apart-from-gnss =
    It lies { AMOUNT($height_m, digits: 1) } m { SIGN($height_m) ->
        [minus] below
       *[plus] above
    } its GNSS position, which is right to { FIXED($usual_m, digits: 1) } m: check the heights, which are off as a whole or count from another zero than the position, as sea level in place of the ellipsoid (--heights-geoid-m), and the position.
place-search-beyond-gnss = Not found within { FIXED($within_m, digits: 0) } m of its GNSS position; all of the orthophoto was searched.

# What the place of an image is worth.
placing-verdict-placed = Placed by { $links } points, σ0 { FIXED($sigma0_px, digits: 2) } px; projection centre ± { SIGNIFICANT($half_width_m, digits: 2) } m (95 %).
placing-verdict-weak = Placed with doubt by { $links } points. { $placing_weakness }
placing-verdict-not-placed = Not placed: { $not_placed }.

## Of the adjustment of a block: observations whose standard errors are stated together, and systematic errors of GNSS positions.

observation-group-marks = image measurements
observation-group-gnss-plan = GNSS positions, horizontal
observation-group-gnss-height = GNSS positions, vertical
observation-group-control-plan = control points, horizontal
observation-group-control-height = control points, vertical
place-group-places-plan = places of the orthophoto, horizontal
place-group-places-height = places of the orthophoto, vertical
place-group-control-and-places-plan = control points and places of the orthophoto, horizontal
place-group-control-and-places-height = control points and places of the orthophoto, vertical

# Cameras and strips are counted from 0: NTH gives the number that people count by.
systematic-error-lever-arm = lever arm of camera { NTH($camera) }
systematic-error-offset = offset of GNSS positions
systematic-error-strip-offset = GNSS offset of strip { NTH($strip) }
systematic-error-strip-drift = GNSS drift of strip { NTH($strip) }

systematic-verdict-kept = kept
systematic-verdict-not-significant = not significant, zero
systematic-verdict-undetermined = not determined, zero

## The steps of the report of a pair.

report-step-this-run = this run
report-step-this-run-edited = this run, edited
report-step-moments = moments
report-step-invariants = invariants
report-step-correlation = correlation
report-step-least-squares = least squares
report-step-gradients = gradients
