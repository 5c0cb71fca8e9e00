# Texts of the page of a pair, in English; an entry is named by its first words.

## engine/engine

left-image = left image
right-image = right image
the-project-does-not-hold = the project does not hold its images; open { $name } too

## engine/failure

images-settings-and-earlier-results = Images, settings and earlier results are kept.
try-a-smaller-image-or = Try a smaller image, or close other tabs.
try-a-higher-threshold-or = Try a higher threshold or a smaller image, then run again.
try-fewer-points-a-higher = Try fewer points (a higher threshold, a larger suppression window) or a smaller search window, then run again.
change-a-setting-or-run = Change a setting or run again.
failed = { $label } failed: { $text }. { $kept }
memory-ran-out-while = Memory ran out while { $label } ({ $text }). { $kept } { $stage }
the-program-broke-off-while = The program broke off while { $label } ({ $text }): a fault of its own, please report it. { $kept } { $stage }
failed-2 = { $label } failed: { $text }. { $kept } { $stage }

## files/journal

the-edits-of-other-pairs = the edits of other pairs are damaged

## files/keep

restored-from-this-browser-2 = Restored from this browser: { $title_of }.
an-image-is-damaged = an image is damaged
the-truth-of-the-simulated = the truth of the simulated pair is damaged

## files/export

the-picture-is-too-large = the picture is too large for this browser to encode; make the window smaller

## files/open, with images, beside, aside and told

it-holds-the-history-of = It holds { $join }; the history of these edits is not in the file, so they cannot be undone.
was-opened-the-file-does-not = { $name } was opened. The file does not hold its images: open them too to see them.
is-a-mask-of-the = { $name } is a mask of the { $side ->
        [left] left
       *[right] right
    } image, which is not open. Open that first.
has-px-the-image-px = { $name } has { $width } × { $height } px, the { $side ->
        [left] left
       *[right] right
    } image { $width_2 } × { $height_2 } px: a mask is as large as its image. Nothing was changed.
masks-of-the-image = { $name } masks { FIXED($left_out, digits: 1) } % of the { $side ->
        [left] left
       *[right] right
    } image.
cannot-be-used-as-a = { $name } cannot be used as a mask
cancelled-before-they-were-read = { $names } { $files ->
        [one] was
       *[other] were
    } not read: give { $files ->
        [one] it
       *[other] them
    } again.
rendering-the-pair-a-simulated = Rendering the pair: a simulated flight over a synthetic scene …
the-pair-could-not-be = The pair could not be rendered
the-open-images-are-kept = {" "}The open images are kept.
fiducial-of-the-image-from = { $fiducials } fiducial { $fiducials ->
        [one] mark
       *[other] marks
    } of the { $side ->
        [left] left
       *[right] right
    } image from { $name }.
is-no-photograph-and-no-table = { $name } is no photograph and no table that is known here
is-a-table-of-a-block = { $name } holds no fiducial marks: it can be read as control points, image measurements or GNSS positions, which belong to a block. Give it with the photos under “Block”.
camera-data-from = Camera data from { $name }.
holds-no-camera-data = { $name } holds no camera data
has-mb-up-to-1 = { $name } has { $size } MB; up to 1,024 MB are read.
reading-2 = Reading { $join } …
the-file = the file
marks-went-with-the-image = The { $marks ->
        [0] place in the scan
        [one] fiducial mark
       *[other] { $marks } fiducial marks
    } of the { $side ->
        [left] left
       *[right] right
    } image went with it.
stay-under-projects = { $title_of } stay under Projects.
open-the-other-pair = Open the other pair
could-not-be-opened-try = { $name } could not be opened: { $breakdown }. Try a smaller image, or close other tabs.

## files/project

the-pair-is-not-matched = the pair is not matched with the present settings yet

## files/report

report-reading-the-images = Report: reading the images …
report-step-of-matching = Report, step { $i } of { $steps }: matching, { $step } …
report-step-of-writing = Report, step { $steps } of { $steps }: writing …
its-run-has-the-edits = Its run has the edits by hand; the other strategies match by themselves.
the-report-was-cancelled = The report was cancelled.
epipolar-images-are-made = Epipolar images: resampling …
epipolar-images-were-saved = The epipolar images were saved: left, right and an anaglyph. Residual y-parallax of { COUNT($points) } points: { FIXED($left_over, digits: 2) } px (RMS).
cancelled-nothing-was-saved-the-epipolar = Cancelled: no epipolar images were made.

## mount

settings-of-the-pair = Settings of the pair

## panel/announce

details-of-the-point = Details of the selected point
n--4 = { $label }.
point-at =
    { $side ->
        [left] Left
       *[right] Right
    } point { COUNT($index) } at { FIXED($x, digits: 1) }, { FIXED($y, digits: 1) } px. { $what }

## panel/answer

loading-the-program = Loading the program …
loading-the-program-files =
    Loading the program … { $files ->
        [one] 1 file waits
       *[other] { COUNT($files) } files wait
    } to be opened.
ready-open-two-overlapping-images = Ready. Open two overlapping images, or use the sample pair.
one-image-is-open-open = One image is open. Open the { $missing ->
        [left] left
       *[right] right
    } one.
open-the-image = Open the { $missing ->
        [left] left
       *[right] right
    } image …
waiting = Waiting …
use-auto = Use “auto”
give-the-camera = Give the camera
open-other-photos = Open other photos …
is-a-third-image = { $name } is a third image: open all three as a block, or replace the { $side ->
        [left] left
       *[right] right
    } image with it?
is-the-other-image-already = { $name } is the { $side ->
        [left] left
       *[right] right
    } image already. Nothing was changed.
open-three-as-a-block = Open all three as a block
keep-the-pair = Keep the pair
replace-the-right-image = Replace the right image …
use-the-calibrated-camera = Use the calibrated camera
points-on-both-photos = points on both photos
right-photo-turned = right photo turned (κ)
points-tried = points tried

## panel/camera

principal-pt-x = Principal pt x
principal-pt-y = Principal pt y
forget-this-calibration = Forget this calibration
the-calibration-is-forgotten = The calibration is forgotten.
the-camera-that-was-given-stays = The camera that was given stays in use.
the-calibrated-camera-is-not = The calibrated camera is not that of these photographs: their own is in use.
a-block-calibrated-such-a-camera = A block with { COUNT($images) } images by a camera of this make and model calibrated it on { $day }: focal length { FIXED($focal, digits: 1) } ± { FIXED($error, digits: 1) } px.
load-camera-json = Load camera.json …
the-image-is = The { $name ->
        [left] left
       *[right] right
    } image is { $message }.
no-pixel-size = no pixel size
pixel-mm = pixel { $pixel_mm } mm
caution = {" "}Caution: { $message }.
camera-not-named = camera not named
f-mm = { $message }, { $name ->
        [left] left
       *[right] right
    }: { $what }, f = { $focal_mm } mm, { $pixel }.{ $cautions }
they-came-with-the-sample = {" "}(they came with the sample)
in-use-the-values-below = In use: the values below{ $what }{ $told }. { $exif }
the-focal-length-is-not-used-yet = The focal length is not used yet: give the pixel size, the focal length in px, or the fiducial marks of both images. { $exif }
focal-length-in-px-sets = { $what ->
        [scans] With fiducial marks the focal length is in mm.
        [pixel] The focal length in px sets the pixel size, by the focal length in mm.
       *[focal] The focal length in px sets that in mm, by the pixel size; where there is none, of pixels of 0.001 mm. Focal length and pixel size in mm replace it.
    }
use-the-camera-for-both = Use the { $side ->
        [left] left
       *[right] right
    } photo's camera for both
in-use-the-photos-own = In use: the photos' own camera{ $told }. Values below replace it. { $exif }
no-camera-is-known = No camera is known: { $source ->
        [estimated] the matches estimate one
       *[assumed] that of most photographs is assumed
    }{ $told }. Values below replace it. { $exif }
orientation-needs-a-focal-length = Orientation needs a focal length in px, or in mm with a pixel size or fiducial marks. With matches of gradients it does without. { $exif }
focal-length-px = , focal length { FIXED($focal, digits: 0) } ± { FIXED($error, digits: 0) } px
offset-dx = Offset dx
offset-dy = Offset dy
matching-by-gradients-searches-the = Matching by gradients searches the whole right image: it needs no offset.
given-clear-both-fields-to = Given. Clear both fields to estimate it.
right-minus-left-position-empty = Right minus left position. Empty: estimated by correlation, coarse to fine.
correlation-2 = , correlation { FIXED($correlation, digits: 2) }
low-do-the-images-overlap = : low. Do the images overlap? A given offset may help
estimated-median-px = Estimated: median { $mx }, { $my } px{ $what }{ $what_2 }.
offset-of-the-right-image = Offset of the right image

## panel/counts

operator = Operator
roundness = Roundness
suppression = Suppression
points-after-each-phase = Points after each phase
phase = Phase
left = Left
right = Right
the-papers-table-1-for = The paper's Table 1, for its own pair
paper-l-r = Paper, l / r
matching = Matching
threshold = Threshold
what-became-of-the-left = What became of the left points
left-points = Left points
number = Number
share = Share
of-these-gross-errors = of these, gross errors
rejected-by = Rejected by
of-these-measured-by-hand = of these, measured by hand
show-2 = Show: { $own }
matches-against-the-truth = Matches against the truth
right-matches = Correct
within-1-5-px-of = Within 1.5 px of where the surface at the left pixel, or at one of its 8 neighbours, is seen: points lie on edges, where the surface may jump between two pixels.
strictly-right = Strictly correct
within-1-5-px-of-where = Within 1.5 px of where the surface at the left pixel itself is seen.
missed = Missed
left-points-that-are-visible = Left points that are visible in the right image and have no correct match.

## panel/draft

add-match = Add match
measure-a-match-by-hand = Measure a match by hand (A)
the-match-is-measured-enter = The match is measured (Enter)
move-the-right-point-to = Move the right point to where least squares matching finds it (F)
other-image = Other image
go-on-with-the-point = Go on with the point in the other image (O)
give-this-match-up-escape = Give this match up (Escape)
match-measured-by-hand = Match measured by hand
new-match-press-a-point = New match: press a point in either picture, or Enter for the middle of the active one.
new-match = New match
moved-match = Moved match
px-predicted = New match: { $place } · { $place_2 } px. The { $side ->
        [left] left
       *[right] right
    } point is predicted: press it, move it by arrows, or let least squares find it (F).
px-place-the-point-press = { $what }: { $place } · { $place_2 } px. Place the { $side ->
        [left] left
       *[right] right
    } point: press, or arrows by 0.1 px, with Shift by 1 px.

## panel/edits

take-the-chosen-matches-out = Take the chosen matches out of the orientation (Delete)
use-the-chosen-matches-again = Use the chosen matches again (R)
move = Move
measure-the-selected-match-anew = Measure the selected match anew, in either image (E)
take-back-the-last-edit = Take back the last edit (Ctrl+Z)
make-the-edit-again-that = Make the edit again that was undone (Ctrl+Shift+Z or Ctrl+Y)
to-reject-wrong-matches-choose = To reject wrong matches, choose them: press a row or a point, with Ctrl for more of them, or draw a rectangle in a picture with Shift. Then press Delete.
history-2 = History: { COUNT($edits) } { $edits ->
        [one] edit
       *[other] edits
    }
history-of-masks = Masks
history-of-marks = Fiducial marks
masks-as-given = masks as given
marks-as-given = marks as given
as-matched = as matched
now-2 = now
standard-error-of-4 = standard error of { $symbol }, °
points-used = points used
orientation-before-and-after-the = Orientation before and after the edit
choose = Choose
choose-matches-by-a-rectangle = Choose matches by a rectangle, to reject or restore them (S; or Shift with a drag)
rejects-the-chosen-matches = rejects the chosen matches
needs-two-photos = needs two photos
needs-a-photo = needs a photo
no-camera-is-given = no camera is given
nothing-is-outlined = no area is outlined
needs-matches = needs matched photos
no-such-match-is-chosen = no such match is chosen
no-point-is-selected = no point is selected
restores-the-chosen-matches = restores the chosen matches
chooses-the-selected-match-beside = chooses the selected match beside others, or no longer
measures-the-selected-match-anew = measures the selected match anew
gives-up = gives up
list-of-matches = List of matches

## panel/feature

no-point = No point.
no-interest-point-here = { $by ->
        [hand] Placed by hand: no interest point here.
       *[least_squares] Placed by least squares: no interest point here.
    }
point-2 = { $label } point, { $name }
turned-and-scaled-to-the = Turned and scaled to the point, contrast stretched
descriptor-as-it-lies-in = Descriptor, as it lies in the image
scale-px-direction-px-wide = {" "}· scale { FIXED($scale, digits: 1) } px, direction { FIXED($direction, digits: 0) }°, { FIXED($reach, digits: 0) } px wide

## panel/fiducials

col-px = col px
row-px = row px
affine-6-parameters = Affine, 6 parameters
similarity-4-parameters = Similarity, 4 parameters
interior-orientation = Interior orientation
transformation = Transformation
add-mark = Add mark
load-csv = Load CSV …
image-4 = { $name } image
no-fiducial-marks-and-no-pixel = No fiducial marks, and no pixel size is known.
no-fiducial-marks-the-pixel = No fiducial marks. The pixel size is used.
measure-in-the-image = Measure in the image
press-each-mark-in-the-image = Press each mark in the image; where two or more are known, the next one is expected at a dashed ring
incomplete-marks = { $incomplete ->
    [one] One mark is incomplete and takes no part.
   *[other] { $incomplete } marks are incomplete and take no part.
}
marks = { $marks ->
    [one] One mark.
   *[other] { $marks } marks.
}
not-determined = not determined
um-1 = { FIXED($value, digits: 1) } µm
marks-degrees-of-freedom = { $marks } marks, σ₀ { $what }, { $freedom } degrees of freedom.
fiducial-marks = Fiducial marks, { $side ->
        [left] left
       *[right] right
    }
residuals-vx-vy = Residuals vx, vy
mark = Mark { $index }, { $heads }
remove-mark = Remove mark { $index }
origin-of-the-image-in = Origin of the { $side ->
        [left] left
       *[right] right
    } image in the scan
image-in-the-scan-px =
    { $side ->
        [left] left
       *[right] right
    } image in the scan, { $name }, px
column-and-row-of-this = Column and row of this image’s top-left corner in the scan in which the marks were measured. Empty: the image is the whole scan.
origin-in-the-scan = Origin in the scan{" "}
col-row-px = col, row px

## panel/geometry

geometry-of-the-two-views = Geometry of the two views
not-computed-yet = Not computed yet.
none = None: { $message }.
model = Model
matches-that-agree = Matches that agree
all-others-are-rejected-matches = All others are rejected. Matches that only the geometry made unambiguous are among them.
standard-error-of-a-coordinate = Standard error of a coordinate
from-the-distances-of-these = From the distances of these matches to their epipolar lines, or to their predicted positions.
largest-distance-of-a-match = Largest distance of a match that agrees. It follows from the scatter of the matches where none is given.
focal-length-estimated = Focal length, estimated
px-5 = { FIXED($focal_px, digits: 0) } ± { FIXED($standard_error_px, digits: 0) } px
of-both-cameras-from-the = Of both cameras, from the matches alone, with its standard error. The principal point is assumed at the image centre. A relative error of a tenth is small enough for the relative orientation.

## panel/header

the-truth-of-the-simulated-pair = The truth of the simulated pair holds in its own order only: swap again to compare.

## panel/histograms

histograms = Histograms
no-points-yet = No points yet.
measure-of-the-matches = Measure of the matches
y-parallax-residuals-of-the = y-parallax residuals of the matches used
interest-value-left = Interest value, left
interest-value-right = Interest value, right
values-median-shown-from-to = { $title }: { COUNT($total) } values, median { $median }{ $suffix }, shown from { $low } to { $high }{ $suffix }, at most { COUNT($most) } in a bar
median = median { $median }

## panel/marking

mark-before = Previous
the-mark-before-p = The mark before (P)
next-mark = Next
the-next-mark-enter = The next mark (Enter)
clear-mark = Clear
the-mark-is-not-measured = The mark counts as not measured
end-marking = Close
step-of-mark = { $deed ->
        [measured] measure fiducial mark { $number } of { $image }
        [moved] move fiducial mark { $number } of { $image }
        [nudged] move fiducial mark { $number } of { $image }
        [cleared] clear fiducial mark { $number } of { $image }
        [typed] change fiducial mark { $number } of { $image }
        [coordinates] take photo coordinates for { $image }
        [added] add fiducial mark { $number } to { $image }
        [removed] remove fiducial mark { $number } of { $image }
        [given] take a table of fiducial marks for { $image }
       *[all_removed] remove all fiducial marks of { $image }
    }
step-of-mask = { $deed ->
        [masked] mask an area of { $image }
        [unmasked] unmask an area of { $image }
        [given] use { $mask } as the mask of { $image }
       *[removed] remove the mask of { $image }
    }
as-in-the-other-image = x, y as in the { $side ->
        [left] left
       *[right] right
    } image
takes-the-photo-coordinates = Takes the photo coordinates x, y that are missing here from the marks of the { $side ->
        [left] left
       *[right] right
    } image, in their order: those of one camera are the same
fiducial-marks-measured = Fiducial marks, measured in the image
mark-at-mm = { " " }({ $x }, { $y } mm)
mark-is-at = Mark { $number }{ $photo } lies at { $column }, { $row } px of the image. Arrows move it; Enter goes on.
mark-beside-the-picture = The mark was not placed: that is beside the picture.
new-mark-press-it = New mark { $number }: press it in the { $side ->
        [left] left
       *[right] right
    } image; type its photo coordinates under “Camera”.
mark-press-it = Mark { $number }{ $photo }: press it in the { $side ->
        [left] left
       *[right] right
    } image.
mark-is-expected = Mark { $number }{ $photo }: press it in the { $side ->
        [left] left
       *[right] right
    } image, near the dashed ring.

## panel/masking

mask-areas = Mask areas
outline-areas-in-which-no = Outline areas in which no points are wanted: water, cars, the edge of a scan (W)
mask-it = Mask
no-points-in-the-outlined = No points in the outlined area (K)
unmask-it = Unmask
points-in-the-outlined-area = Points in the outlined area again (U)
save-masks = Save masks
masks-as-png-files-for = The masks as PNG files, for later use or for the command
no-area-was-painted = No area was painted: it was cancelled, or the image or its mask has changed meanwhile.
end-masking = Close
masks-of-the-pictures = Masks of the pictures
the-area-is-outlined = An area of { $corners } corners: mask it, or unmask it.
draw-round-an-area-or = { $corners ->
    [0] Draw round an area, or press its corners one after the other. By keys: Enter places one at the cross in the middle.
    [one] One corner: an area has three at least.
   *[other] { $corners } corners: an area has three at least.
}
the-mask-is-not-here = The file of { $name } is not here: open it again, or remove the mask, before an area is painted.

## panel/matrix

and = { $symbol } and { $symbol_2 } { FIXED($correlations, digits: 2) }
from-the-inverse-of-the = From the inverse of the normal equations: near ±1 two unknowns are hardly separable, and an error of one passes into the other.
correlations-of-the-unknowns = Correlations of the unknowns
correlations = Correlations: { $join }
standard-error-ellipse-of-by = Standard error ellipse of by and bz: semi-axes { $major } and { $minor } mm, longer axis at { FIXED($angle, digits: 0) } degrees from by
cross-truth = ; cross: truth
by-bz-ellipse-m = by, bz: standard error ellipse, semi-axes { $major } × { $minor } µm{ $what }
dashed-95 = ; dashed: 95 %

## panel/orientation

axes-turned = Axes turned by 90°: x points up in the left image.
is-computed-from-y-parallaxes = σ₀ is computed from y-parallaxes. It sees only the component of an error across the epipolar line, and cannot prove a match right: a wrong match along the line leaves it unchanged.
relative-orientation = Relative orientation
two-images-are-needed = Two images are needed.
not-oriented-2 = Not oriented: { $message }.
not-oriented-do-both-photos = Not oriented: { $message }. Do both photos show the same ground?
and-the-matches-do-not = , and the matches do not determine the focal length
not-oriented-give-the-focal = Not oriented: { $message }{ $untold }. Give the focal length in px, or in mm with the pixel size or fiducial marks, under “Camera”.
not-oriented-3 = Not oriented. { $message }
value = Value
the-right-photo-relative-to = The right photo relative to the left one, dependent relative orientation.
std-error = Std error
what-the-scatter-of-the = What the scatter of the matches leaves uncertain.
in-total = In total
standard-error-including-what-does = Standard error including what does not average out: neighbouring matches share errors because their windows overlap, and all share those of the camera, of the measured fiducial marks, and of walls and roofs.
half-width-of-the-interval = Half-width of the interval that holds the unknown in 95 of 100 cases: of the last standard error, by the distribution of Student for the degrees of freedom.
paper-2 = Paper
the-papers-table-3-of = The paper's Table 3, of its own pair
its-error = its error
the-papers-table-2 = The paper's Table 2
true-error = True error
value-minus-truth-by-and = Value minus truth; by and bz at the scale of the base used.
in-std-errors = in std errors
the-true-error-divided-by = The true error divided by the standard error, with that of the interior orientations where known: beyond 3 in 3 of 1,000 cases.
unknown = Unknown
of-a-photo-coordinate = σ₀ of a photo coordinate
px-6 = {" "}= { FIXED($sigma, digits: 3) } px
standard-error-of-one-photo = Standard error of one photo coordinate of weight 1, from the residuals. { $sigma_caveat }
of-a-y-parallax-2 = of a y-parallax (√2 σ₀)
standard-error-of-the-y = Standard error of the y-parallax of a match: the distance at which its two rays pass each other.
global-test-2 = Global test
passed = passed
failed-3 = FAILED
degrees-of-freedom = Degrees of freedom
matches-used-minus-the-five = Matches used minus the five unknowns.
matches-used = Matches used
of-7 = { COUNT($used) } of { COUNT($residuals_mm) }
data-snooping-rejected-the-others = Data snooping rejected the others as gross errors, or their rays meet behind a camera.
condition = Condition
largest-by-smallest-eigenvalue-of = Largest by smallest eigenvalue of the matrix of correlations: 1 where the unknowns are independent, some thousands for vertical photographs, far more where they are hardly separable.
misfit-to-a-plane = Misfit to a plane
how-far-the-matches-deviate = How far the matches deviate from the best map of one plane onto another, in standard errors: about 1 over a plane, where a second orientation may fit as well; large over relief.
parallax-beside-a-rotation = Parallax beside a rotation
mm-2 = { $value } mm
px-7 = { $value } px
median-parallax-that-the-best = Median parallax that the best rotation of the right photo leaves: what of the difference of the photos only a base explains. Next to nothing where the camera only turned.
spread = Spread
root-mean-square-distance-of-the = Root mean square distance of the points from their middle in the left photo, in principal distances. Small where they cover little of the photo.
iterations-last-step = Iterations, last step
of-the-tolerance = { $iterations }; { $step } of the tolerance
the-last-step-relative-to = The tolerance of a step is a millionth of the standard errors: the adjustment has converged where the last step is less.
base-b-principal-distance = Base b, principal distance
mm-mm = { $base_mm } mm, { $focal_mm } mm
the-base-component-that-was = The base component that was fixed gives by and bz their scale.
what-the-paper-printed-for = What the paper printed for its own pair.

## panel/panes

replace = Replace …
replace-the-image = Replace the { $side ->
        [left] left
       *[right] right
    } image
open-the-image-2 = Open the { $side ->
        [left] left
       *[right] right
    } image …
mask = Mask …
an-image-of-the-same = An image of the same size: no points are detected where it is 0 (black)
mask-2 = × mask
remove-the-mask-of-the = Remove the mask of the { $side ->
        [left] left
       *[right] right
    } image
remove-3 = Remove { $name }
px-8 = {" "}· { COUNT($width) } × { COUNT($height) } px

## panel/point

click-a-point-in-an = Click a point in an image, or press N with the image in focus, to see what was compared, its candidates and the rule that decided.
point-3 = { $what } point { COUNT($index) }
x-px-y-px-interest = x { FIXED($at, digits: 1) } px, y { FIXED($at_2, digits: 1) } px, interest value { $significant }
not-matched-yet = Not matched yet.
loading-the-window-and-the = Loading the window and the candidates …
the-dashed-line-in-the = The dashed line in the { $side ->
        [left] left
       *[right] right
    } image is the epipolar line of this point: its match lies on it, whatever the height.
the-cross-in-the-image = The cross in the { $side ->
        [left] left
       *[right] right
    } image is where the geometry has this point.
by-the-geometry-of-the = By the geometry of the two views this point lies outside the { $side ->
        [left] left
       *[right] right
    } image.
axis = {" "}· axis { FIXED($axis_angle_deg, digits: 1) }°
left-window = Left window
right-window = Right window
normalised-central-moments = Normalised central moments
moment = Moment
invariants = Invariants
invariant = Invariant
right-position = Right position
px-9 = { FIXED($right, digits: 2) }, { FIXED($right_2, digits: 2) } px
where-the-match-lies-in = Where the match lies in the right image.
match = Match { COUNT($index) }
select-right-point = Select right point { COUNT($index) }
distance-2 = Distance
measure = Measure
rank = Rank
right-point = Right point
the-smallest-measure-divided-by = The smallest measure divided by its own: that of the second decides whether the best is ambiguous.
ratio-2 = Ratio
the-match-is-none-of-these = The match is none of these: they are compared by descriptors, and least squares matching placed it from its neighbours.
the-best = , the best { $most_rows }
of-left-point = { COUNT($total) } { $total ->
        [one] candidate
       *[other] candidates
    } of left point { COUNT($left_index) }{ $what }

## panel/presets

ready-made-settings = Ready-made settings
preset-own = Your own
preset-defaults = Defaults
    .help = Right for most pairs.
preset-many-points = Many points
    .help = Twice as many points: about twice as many matches, in twice the time.
preset-little-in-common = Little in common
    .help = Larger windows for least squares matching: more matches on long bases and at other scales.
preset-zahran-2007 = Zahran 2007
    .help = The paper's method with its values: both photos of one scale, and not turned against each other.

## panel/simulate

sample-the-built-in-pair = Sample: the built-in pair
paper-its-geometry-and-angles = Paper: its geometry and angles
hard-high-relief-blur-noise = Hard: high relief, blur, noise
lively-river-traffic-grain-haze = Lively: river, traffic, grain, haze
render-this-pair = Render this pair
another-town = Another town
the-next-seed = The next seed
a-flight-over-a-synthetic = A flight over a synthetic scene. The truth is known: matches and orientation are compared with it, and errors are shown beside standard errors.
preset = Preset
preview-of-the-left-image = Preview of the left image
preview-of-the-right-image = Preview of the right image
no-preview = no preview: { $message }

state-2 = state
truth = truth
used = used
wrong = wrong
correct = right

## panel/statistics

all-matches = all matches
gross-errors = gross errors
wrong-by-the-truth = wrong by the truth
gross-error = gross error
at-an-edge = at an edge
matches-to-show = Matches to show
scroll-sideways-for-more-columns = Scroll sideways for more columns →
choose-all = Choose all
choose-the-matches-that-the = Choose the matches that the list shows, to reject or restore them
table-of-matches = Table of matches
match-2 = Match
number-of-the-match-in = Number of the match, in the order of its left points.
whether-the-adjustment-used-the = Whether the adjustment used the match, and what was done to it by hand.
whether-the-match-is-right = Whether the match is right: within 1.5 px of where the surface is seen, there or at a neighbouring pixel.

## panel/status

cancelled-the-images-stay = Cancelled. The images stay: press Run to open them.
the-images-wait-for-run = The images are not matched while their fiducial marks are measured: press Run to match them.
cancelled-results-on-the-screen = Cancelled. Results on the screen are kept. Press Run, or change a setting, to go on.
not-oriented-4 = Not oriented: { $matches }.

no-lines = none
all-lines = all

## panel/toolbar

show-the-matched-points = Show the matched points
unmatched = Unmatched
show-rejected-points-too-marked = Show rejected points too, marked by the rule that rejected them: press one to see why
lines = Lines
pan-and-zoom-both-images = Pan and zoom both images together (L)
magnifier = Magnifier
enlarge-what-is-under-the-pointer = Enlarge what is under the pointer (M)
previous-point-p = Previous point (P)
next-point-n = Next point (N)
whole-images = whole images

## panel/verdict

no-left-point-was-matched = No left point was matched to this one: this strategy searches the right image itself, at the left points.
no-left-point-has-this = No left point has this point as its best candidate.

## panel/window

px-window-enlarged = { $side } × { $side } px window, enlarged

## state/edited

of-more-there-is-no = {" "}Of { $lost } more { $lost ->
        [one] rejection
       *[other] rejections
    } there is no match at the same place.
no-edits-by-hand-apply = No edits by hand apply to this result.
kept = Kept: { $join }.

## state/editing

least-squares-matching-confirms-no = Least squares matching confirms no place near this one: the windows differ too much, or are turned to each other.

## state/edits


## state/labels

matched-then-rejected-by-hand = Matched, then rejected by hand.
measured-by-hand = Measured by hand.
measured-by-hand-2 = Measured by hand

matches-by-hand = { $number } { $number ->
        [one] match
       *[other] matches
    } { $what ->
        [rejected] rejected
       *[measured] measured
    } by hand
step-matches = { $kind ->
        [reject] reject
       *[restore] restore
    } { $matches ->
        [one] 1 match
       *[other] { $matches } matches
    }
step-add-match = add 1 match
step-move-match = move 1 match
image-3 = { $side ->
        [Left] Left
       *[Right] Right
    } image:{" "}

## state/stages

matching-2 = matching
decoding-the-left-image = decoding the left image
decoding-the-right-image = decoding the right image
detecting-points-left = detecting points, left
detecting-points-right = detecting points, right
describing-points-left = describing points, left
describing-points-right = describing points, right
estimating-the-offset-of-the = estimating the offset of the images
interior-orientation-left = interior orientation, left
interior-orientation-right = interior orientation, right
relative-orientation-2 = relative orientation
comparing-with-the-truth = comparing with the truth
comparing-how-the-photos-lie = comparing how the photos lie to each other
looking-where-the-point-may = looking where the point may lie
loading-the-selected-point = loading the selected point

## state/statistics

measure-2 = measure
y-parallax = y-parallax
weight = weight
column-of-the-left-point = Column of the left point; the top-left pixel’s centre is at 0.5.
row-of-the-left-point = Row of the left point.
dissimilarity-of-the-points-by = Dissimilarity of the points: by the moments of their windows, 1 minus the correlation coefficient, or the distance of their descriptors. Small is good. Empty where a match was measured by hand, or placed from its neighbours.
correlation-of-a-match = correlation
correlation-after-least-squares = Correlation coefficient of the grey values after least squares matching. Near 1 is good.
standard-error-of-the-right = Standard error of the right position from least squares matching, in its worse direction.
residual-y-parallax-the-distance = Residual y-parallax: the distance at which the two rays pass each other, at photo scale.
redundancy-number-the-share-of = Redundancy number: the share of an error of this match that shows in its residual. Near 0 the other matches do not check it.
w-statistic-standardised-residual-data = w-statistic: standardised residual. Data snooping rejects above the limit that α₀ sets (3.29 for 0.001).
minimal-detectable-bias-mdb-across = Minimal detectable bias (MDB) across the epipolar line: an error of this size is detected with the probability β₀.
external-reliability-the-largest-effect = External reliability: the largest effect of an undetected error of that size on an unknown, in its standard errors.
weight-in-the-adjustment-0 = Weight in the adjustment; 0 where rejected.
model-coordinate-at-photo-scale = Model coordinate at photo scale, along the base.
model-coordinate-at-photo-scale-across = Model coordinate at photo scale, across the base.
model-coordinate-at-photo-scale-upwards = Model coordinate at photo scale, upwards; the photo lies at minus the principal distance.

## view/input

pictures-of-a-pair-while = Pictures of a pair, while a match is measured
pictures-of-a-pair-while-marking = Pictures of a pair, while fiducial marks are measured
moves-the-mark-by = moves the mark by 0.1 px; with Shift by 1 px
goes-to-the-next-mark = goes to the next mark
goes-to-the-mark-before = goes to the mark before
measures-the-mark-in-the-middle = measures the mark in the middle of the picture
takes-the-mark-back = clears the measured place of the mark
pictures-of-a-pair-while-masking = Pictures of a pair, while areas are masked
places-a-corner-in-the-middle = places a corner of the area in the middle of the picture
takes-the-last-corner-back = takes the last corner back
step-of-draft = place a point of the match
step-of-outline = the last part of the outline
anywhere-while-masking = Anywhere, while an area is outlined
gives-the-outline-up = gives the outline up
masks-the-outlined-area = masks the outlined area
unmasks-the-outlined-area = takes the mask off the outlined area
outlines-areas-to-be-masked = outlines areas to be masked
pictures-of-a-pair = Pictures of a pair
takes-the-middle-of-the-picture = takes the middle of the picture for the first point
accepts-the-measured-match = accepts the measured match
goes-to-the-point-in = goes to the point in the other picture
fits-the-point-by-least = fits the point by least squares matching
selects-the-next-point = selects the next point
selects-the-previous-point = selects the previous point
goes-to-the-other-picture = goes to the other picture
links-both-pictures-or-no = links both pictures, or no longer
shows-the-magnifier-or-no = shows the magnifier, or no longer
chooses-matches-by-rectangles = chooses matches by rectangles
adds-a-match-by-measuring = adds a match by measuring it
gives-up-or-selects-nothing = gives up, or selects nothing

## Points and results

candidate-of = Not matched. It is the best candidate of left point { COUNT($point) }, which is rejected.
ratio =
    { $second ->
        [none] without a second candidate
       *[other] { FIXED($ratio, digits: 3) } of the second best ({ FIXED($second, digits: 4) })
    }
correlation = Correlation { FIXED($correlation, digits: 4) }, measure { FIXED($best, digits: 4) }.
low-correlation = Correlation { FIXED($correlation, digits: 4) }; { $least } or more is allowed.
good-measure = Its best measure { FIXED($best, digits: 4) } is below { $most }, and { ratio }.
large-measure = Best measure { FIXED($best, digits: 4) }; below { $most } is allowed.
ambiguous = Its best measure { FIXED($best, digits: 4) } is { ratio }; up to { $largest } is allowed.
parallax-beside = Rejected: its y-parallax differs from that of its nearest matches by { FIXED($deviation_px, digits: 2) } px; { FIXED($allowed_px, digits: 2) } px is allowed, the tolerance or three times their scatter where that is more.
parallax = Tolerance: { $tolerance } px, or three times the scatter of its neighbours where that is more.
imprecise = Up to { $most } px is allowed.
distance = Distance { FIXED($best, digits: 4) }, { ratio }.
only-candidate = Distance { FIXED($best, digits: 4) }, the only candidate that agrees with the geometry of the two views.
predicted-match = Its descriptor found no match: least squares matching placed it where the matches around it predict it, correlation { FIXED($correlation, digits: 4) }.
clear-candidate = Distance { FIXED($best, digits: 4) }, { ratio }. It agrees with the geometry of the two views.
agreeing-candidate = Distance { FIXED($best, digits: 4) }, { ratio }: more than { $largest }, but it agrees with the geometry of the two views, which leaves few candidates.
no-geometry =
    Distance { FIXED($best, digits: 4) }, { ratio }. No geometry of the two views was found{ $no_geometry ->
        [none] .
       *[other] : { $no_geometry }.
    }
off-line =
    Distance { FIXED($best, digits: 4) }, { ratio }; but it does not fit: { $off_px ->
        [none] up to { FIXED($threshold_px, digits: 2) } px from its epipolar line is allowed.
       *[other] it lies { FIXED($off_px, digits: 2) } px from its epipolar line; up to { FIXED($threshold_px, digits: 2) } px is allowed.
    }
off-place =
    Distance { FIXED($best, digits: 4) }, { ratio }; but it does not fit: { $off_px ->
        [none] up to { FIXED($threshold_px, digits: 2) } px from its predicted position is allowed.
       *[other] it lies { FIXED($off_px, digits: 2) } px from its predicted position; up to { FIXED($threshold_px, digits: 2) } px is allowed.
    }
matched = { COUNT($matches) } matches of { COUNT($points) } left points
step = Step { $step } of { $steps }: { $stages }
worked = { $matched }, { FIXED($seconds, digits: 2) } s of work.
estimated-focal = With the focal length estimated from the matches: { FIXED($focal_px, digits: 0) } ± { FIXED($error_px, digits: 0) } px. The standard errors “In total” hold its error. Lengths in mm are those of pixels of 0.001 mm.
global-test = The weighted sum of squared residuals over the given σ₀²: with good matches between { FIXED($lower, digits: 1) } and { FIXED($upper, digits: 1) } in 95 of 100 cases. Above: the matches are worse than the given σ₀, or the model does not hold. Below: the given σ₀ is too large.
paper = Paper: its Tables 2 and 3, of its own pair (f = { $focal_mm } mm, pixel { FIXED($pixel_um, digits: 0) } µm, assumed b = { $base_mm } mm).
paper-sigma = σ₀ { FIXED($sigma0_mm, digits: 3) } mm = { FIXED($sigma0_px, digits: 1) } px
