# Texts of the page of a block, in English; an entry is named by its first words.

## engine/block-placing

placing-on-the-orthophoto = Placing { $name } on the orthophoto
adjusting-by-the-orthophoto = Adjusting the block by the orthophoto

## engine/engine

not-run = Not run: { $problem }

## engine/link-hands

n- = {" "}({ $last })
not-done = Not done{ $what }: { $sentence }

## engine/outcome

not-oriented-yet = not oriented yet

## engine/placing

looking-for-points-of-the = Looking for points of the orthophoto
placing = Placing { $name }
placing-2 = Placing
is-not-placed = { $name } is not placed
laying-out-the-orthomosaic = Laying out the orthomosaic
orthomosaic = Orthomosaic: { $name }
writing-the-orthomosaic = Writing the orthomosaic

## engine/session


## files/files, with actions, aside, beside, simulated and told

cameras = Cameras
ground-control-points = Ground control points
image-measurements = Image measurements
image-positions = GNSS positions of images
a-block-needs-two-images = A block needs two images or more; an orthophoto places a single one.
that-say-where-they-lie = { $taken } that say where they lie are taken as photographs: an orthophoto is given by itself.
cancelled-what-was-placed-stays = Cancelled. What was placed stays.
nothing-was-placed = Nothing was placed: { $sentence }
more-than-two-images-are = More than two images are a block.
making-the-orthophoto-of-the = Making the orthophoto of the synthetic scene …
the-orthophoto-could-not-be = The orthophoto could not be simulated
photos-of-a-simulated-block = { $files } photos of a simulated block. Press Run.
building-the-synthetic-scene = Building the synthetic scene …
photographing-the-simulated-block-of = Photographing the simulated block: { $count } of { $of } …
photograph-another-block = Photograph another block
the-block-could-not-be = The block could not be simulated
from = { $texts } from { $name }.
from-2 = { $texts } from { $name }. { $problem }.
the-block-cannot-be-run = { $problem } The block cannot be run with it.
the-block-cannot-be-run-with = { $problem } The block cannot be run with them.
open-the-other-project = Open the other project
the-former-block-stays-under = {" "}The former block stays under Projects.
was-opened-the-file-does = { $name } was opened. The file does not hold its images: drop them too to open pairs.{ $former }
a-run-needs-files = A new run needs { $files ->
        [one] a file
       *[other] { $files } files
    } that the project file does not hold: give { $files ->
        [one] it
       *[other] them
    } again under Files in the settings, or remove { $files ->
        [one] it
       *[other] them
    } there.
a-run-needs-its-orthophoto = A new run needs the orthophoto again, which the project file does not hold: without it the new block does not lie on it.
masks-are-not-in-the-file = { $masks ->
        [one] the mask { $name } is not in the project file: give it
       *[other] { $masks } masks, as { $name }, are not in the project file: give them
    } again, or remove { $masks ->
        [one] it
       *[other] them
    } to run the block without.
system-cannot-be-read = it cannot be read. Allowed: an EPSG code (EPSG:25832), PROJ text (+proj=utm +zone=32) or WKT
geoid-is-not-in-the-file = the geoid { $name } is not in the project file: give it again, or remove it to run the block without.
keeping-the-pair = Keeping the pair …
open-the-pair-of-the-block = Open the pair of the block
keeping-the-edited-block = Keeping the edited block …
run-it-again = Run it again
the-former-block-stays-under-projects = { $text } The former block stays under Projects.
remove-all-images = Remove all images
project = project
oriented-block = oriented block
what-was-set-up = What was set up
the-block-of-these-photos = The block of these photographs
edited-block = edited block
the-stays-under-projects = The { $what } stays under Projects.
what-was-placed-on-the = What was placed on the orthophoto
the-edit-by-hand-of = The edit by hand of this block
the-edits-by-hand-of = The { $length } edits by hand of this block
in-the-block = { $sorted } in the block.
skipped-their-names-are-in = { $twice } skipped: their names are in the block already.
cameras-are-put-aside = { $problem } The file is put aside.
holds-no-cameras = { $problem } It holds no cameras and is put aside.
is-no-table-of = { $name } is put aside, neither control points nor image measurements, GNSS positions or fiducial marks: { $why }
it-has-no-rows = it has no rows
its-values-stand-between-spaces = its values stand between spaces, and are not name, x, y, z or image, point, x, y, as many in each line; names with spaces are read between commas, semicolons or tabs
its-first-column-names-no-images = its first column has to name images with their endings, as DSC_0001.JPG, and { $name } is none. The columns of image measurements are image, point, x and y in px, in this order
its-rows-are-images = its rows are images of a result, neither surveyed points nor GNSS positions
its-rows-name-no-images = its rows name no images: { $name } is none of the block, and has no ending as DSC_0001.JPG
its-rows-are-tie-points = its rows are tie points of a result, not surveyed points
skipped-not-an-image-by = { $aside } { $aside ->
        [one] file
       *[other] files
    } skipped: not an image by name.
press-place = Press Place.
press-run = Press Run.
open-the-setting = Open “{ $label }”
press-frames = Press { $make } under Scanned film, in the settings of the orthophoto.
press-measure-marks = Press { $measure } under Scanned film, in the settings of the orthophoto, or give a table of fiducial marks for each scan.
the-block-is-unchanged = { $what }: { $error }. The block is unchanged.
all-images-of-the-block = All images of the block are there.
of-of-the-block-are = { $files } of { $size } of the block are there.

## files/ground

metres = { $value } m
feet = { $value } ft
skipped-a-project-has-one = { $more } skipped: a project has one orthophoto.
skipped-an-orthophoto-has-one = { $others } skipped: an orthophoto has one height model.
reading-the-orthophoto = Reading the orthophoto { $name } …
cannot-be-used-as-an = { $name } cannot be used as an orthophoto
is-a-grid-at-longitudes = { $name } is a grid of numbers at longitudes and latitudes, and put aside. If it is a geoid, give it under Geoid in the settings; heights of the ground have to be in a projected system.
holds-heights-give-their-orthophoto = { $name } holds heights: give their orthophoto first, or both together.
reading-the-heights = Reading the heights { $name } …
the-ground-is-level-at = The ground is level at { $name }.
heights-from-to = Heights from { $name }: { FIXED($from, digits: 1) } to { FIXED($to, digits: 1) } { $unit }.
cannot-be-used-as-heights = { $name } cannot be used as heights
says-where-a-picture-of = { $name } says where a picture of the same name lies: give both together.
placed-by = , placed by { $name }
in-the-system-of = , in the system of { $name }
epsg = , EPSG:{ $epsg }
orthophoto-px-of = Orthophoto { $name }: { COUNT($width) } × { COUNT($height) } px of { $gsd }{ $what }{ $by }.{ $degrees }
an-orthophoto-in-degrees = {" "}It is in degrees ({ $crs }): it lies under the map, and is shown by itself in { $shown }{ $departs ->
        [none] {""}
       *[other] , where it is off by up to { FIXED($departs, digits: 1) } px
    }. Images are placed on one in a projected system alone: reproject it for that, with gdalwarp -t_srs say.

## files/keep

the-work-that-was-done = {" "}The work that was done is kept: Run goes on from there.
restored-from-this-browser = Restored from this browser: { $title_of }.{ $goes_on }
the-finished-block-is-damaged = the finished block is damaged
edits-of-former-blocks-are-left-out = Edits of blocks before this one are left out: { $error }.
the-image-is-damaged = the image { $name } is damaged

## files/runs

taking-the-block-off-the = Opening the block as it was without the orthophoto …
the-block-stays-as-it = The block stays as it was: { $sentence }
a-block-is-placed-by = A block is placed by its images, and none of them is there: drop them.
cancelled-the-block-is-as = Cancelled: the block is as it was.

## mount

images-of-the-block = Images of the block
export-of-the-block = Export of the block
export-of-the-placed-images = Export of the placed images
edits = Edits
views-of-the-block = Views of the block
settings-of-the-block = Settings of the block
images = Images …
images-cameras-or-project-of = Images, cameras or project of a block
image-files-a-cameras-file = Image files; a cameras file or a saved project too
folder = Folder …
folder-of-images = Folder of images
all-images-of-a-folder = All images of a folder
simulated-block = Simulated block
photos-of-a-synthetic-scene = Photos of a synthetic scene, rendered in this tab
removes-all-images-an-edited = Removes all images; an oriented or edited block stays under Projects

## pair

the-files-of-these-images = The files of these images are not open: drop them and try again.
the-pair-cannot-be-shown = The pair cannot be shown: { $error }.

## panel/components

stated-standard-errors = Stated standard errors
by-residuals-stated = By residuals / stated
interval-of-95 = 95 % interval
weights-by = Weights by
weights-by-residuals = residuals
weights-by-stated = stated standard errors
weights-by-stated-held = stated standard errors (held)
components-explained = Standard errors by the residuals beside those that were stated. Beyond 1 they were stated too small. Where the interval holds 1, the residuals do not contradict them.

## panel/dock

pairs = Pairs
tie-points = Tie points
observations = Observations
control-and-check-points = Control and check points
tables = Tables
of-what-is-chosen = Of what is chosen
shows-the-observations-of-the = Shows the observations of the chosen points, image or pair alone
table = Table: { $title }
height-of-the-tables = Height of the tables

## panel/edits, with edit-bar, edit-keys and edit-panel

points-2 = points
observations-5 = observations
point-of-kind = { $kind ->
        [tie_point] tie point
        [ground_control] ground control
       *[manual] manual
    } { $number }
take-what-is-chosen-out = Take what is chosen out of the adjustment (Delete)
reject-point = Reject point
take-the-point-with-all = Take the point with all its observations out (Shift+Delete)
use-what-is-chosen-again = Use what is chosen again (R)
remove-image = Remove image
take-the-chosen-image-out = Take what is chosen of the images out of the block; only what depends on it is computed again
measure-it = Measure
measure-the-chosen-point-in = Measure the chosen point in the images that are shown (E)
add-point = Add point
measure-a-new-tie-point = Measure a new tie point in two or more images (A)
not-joined = Not joined: in { $image } these points lie { $px } px apart, and one point has one place in an image. Reject the wrong observation first.
join = Join
the-chosen-points-are-one = The chosen points are one: it gets all their observations; where two have one in the same image, that of the point with more rays
split = Split
the-point-is-two-one = The point is two: one of the observations in the images that are shown, one of the others. Close the images that show another point
match-it = Match
match-the-point-in-the = Match the point in the other images by least squares (F)
match-here = Match here
match-the-point-here = Match the point in the active image alone, by another one that is shown, by least squares (Shift+F)
the-point-is-measured-enter = The point is measured (Enter)
give-what-is-measured-up = Give what is measured up (Escape)
use-as = Use
control-point = control point
check-point = check point
not-used = not used
new-point = New point
where-it-lies-is-not-known = {" "}{ $by ->
        [system] Where images show it is not known: with the coordinate system of the control points in the settings (“Coordinate system”), points open where they are expected.
       *[points] Where images show it is not known: once it is placed in two images, it is expected in the others where their epipolar lines cross.
    }
measured-points-are-not-in-it = { $points ->
        [one] 1 measured point is
       *[other] { $points } measured points are
    } not in the block, nor in the file: this browser keeps their image measurements, until a run takes them in.
accepted-as-placed = { $name } was accepted as it was placed in { $images ->
        [one] 1 image
       *[other] { $images } images
    }; ↶ takes it back.
two-images-or-more-are = {" "}Two images or more are needed.
placed-in-press-its-place = { $what }: placed in { $placed } { $placed ->
        [one] image
       *[other] images
    }. Press its place in a pane, or arrows by 0.1 px, with Shift by 1 px; Enter for the middle or the expected place.{ $more }
adjusting-the-block = Adjusting the block …
edits-wait-for-the-run = A run goes on: edit its block when it has ended.
n-0-px = σ₀ { $sigma0_px } → { $sigma0_px_2 } px
rmse-px = RMSE { $rmse_px } → { $rmse_px_2 } px
check-points-m = check points { $checks_m } → { $checks_m_2 } m{ $of }
of-so-many-check-points = {" "}({ COUNT($points) } → { COUNT($points_2) } { $points_2 ->
        [one] point
       *[other] points
    })
images-oriented = { COUNT($oriented) } → { COUNT($oriented_2) } images oriented
rejects-what-is-chosen-with = rejects what is chosen; with Shift its whole point
nothing-to-reject-is-chosen = nothing is chosen that can be rejected
nothing-rejected-is-chosen = nothing rejected is chosen
needs-a-block = needs a finished block
no-plot-is-shown = no plot is shown
needs-images = needs images
no-chosen-image = no image is chosen that can be taken out
no-points-to-join = no points are chosen that can be one
no-point-to-split = no point is chosen that can be split
no-pair-is-chosen = no pair is chosen
no-link-is-chosen = no link is chosen
needs-two-shown = needs two images that are shown
needs-an-orthophoto = needs an orthophoto
needs-marked-scans = needs a film camera and fiducial marks of scans
no-point-is-chosen = no point is chosen
uses-what-is-chosen-again = uses what is chosen again
views-and-tables-of-a = Views and tables of a block
choose-an-image-a-tie = Choose an image, a pair of images, a tie point or its observation in table, map or images, and press Delete to reject it. In Images, E measures the chosen point and A adds a new one. The block is adjusted again after each edit; undo has no limit.
history = History
as-found = as found
restore-2 = Restore { $name }
in = { $point } in { $image }
now = now
rmse-px-2 = RMSE, px
check-points-rmse-m = check points, RMSE, m
check-points-compared = check points
images-oriented-2 = images oriented
block-before-and-after-the = Block before and after the edit

## panel/exports

project-file = Project file
everything-zip = Everything (.zip)
bundler = Bundler
nvm-visualsfm = NVM (VisualSFM)
agisoft = Agisoft
csv-tables = CSV tables
format = Format
orthomosaic-geotiff = Orthomosaic (GeoTIFF)
chosen-images-on-the-ground = Chosen images on the ground (GeoTIFF)
choose-one-or-more-images = Choose one or more images first.
pixel-of-the-orthomosaic = Side of a pixel of the orthomosaic, in units of the block; empty: that of the images
pixel-as-the-images = Pixel: as the images
writing = Writing { $names } …
cancelled-nothing-was-saved-the = Cancelled: nothing was saved. The block is unchanged.
was-not-written = { $names } was not written: { $reason }.

## panel/flight

photograph-this-block = Photograph this block
a-flight-in-strips-over = A flight in strips over a synthetic scene. Larger photos take longer: 12 million pixels some seconds each.

## panel/images-view

press-a-point-every-image = Press a point: every image that shows it opens at it. Drag pans · wheel and + − zoom · 0 whole images · 1 one to one · arrows pan · N P points · O next pane · Page Down, Page Up images · L linked · M loupe · U where it is not measured · Escape nothing chosen. Edits: Delete rejects, R restores · E measures the point, A a new one: arrows move by 0.1 px, Enter accepts, F matches.
images-of-the-block-2 = images of the block
images-side-by-side-with = Images side by side with their tie points
add-images = Add images …
close = Close { $own }
the-file-of-this-image = The file of this image is not open: a project does not hold its images.
this-image-cannot-be-decoded = This image cannot be decoded.
the-place-on-the-orthophoto = The place on the orthophoto that is measured, under the cross
rejected-gross-error = rejected: gross error
rejected-behind-the-image = rejected: behind the image
rejected-its-point-has-too = rejected: its point has too few rays
rejected-does-not-fit = rejected: does not fit
not-adjusted = not adjusted
predicted-not-measured = predicted, not measured
legend-of-marks = What the marks mean
legend-measured-by-hand = measured by hand
legend-residual = residual
legend-residual-rejected = residual of a rejected observation
legend-chosen = chosen point
legend-predicted = where the adjustment expects it
legend-placed = where it is placed
legend-epipolar = epipolar line
v-px = v { FIXED($residual, digits: 2) } { FIXED($residual_2, digits: 2) } px
mdb-px = MDB { FIXED($mdb, digits: 1) } px
point-by-hand = Point by hand
tie-point = Tie point
not-intersected = not intersected
rays-rejected = , { COUNT($rejected) } rejected
shown = , { COUNT($seen) } shown
rays = { COUNT($observations) } rays{ $what }
rmse-px-3 = RMSE { FIXED($rmse_px, digits: 2) } px
largest-w-in = largest w { FIXED($w, digits: 1) } in { $name }
not-measured-in-more = not measured in { COUNT($elsewhere) } more
px = { $name }: { FIXED($at, digits: 1) }, { FIXED($at_2, digits: 1) } px
mm = { FIXED($mm, digits: 3) }, { FIXED($mm_2, digits: 3) } mm
ground-about = ground about { $join }
show-the-observations-of-tie = Show the observations of tie points
pan-and-zoom-all-images = Pan and zoom all images together (L)
loupe = Loupe
enlarge-what-is-under-the = Enlarge what is under the pointer, in all images (M)
unmeasured = Unmeasured
show-a-chosen-point-where = Show a chosen point where it is not measured too (U)
image = image …
other-images = Other images
other-images-title = Show the next images (Page Down); those in which the measured point is placed stay
open-as-pair = Open as pair
match-the-two-images-that = Match the two images that are shown, in the view of pairs

## panel/map-view

oriented-positions-from-above = Oriented positions, from above
gnss-positions-from-above = GNSS positions, from above
arranged-by-connections-positions-have = Arranged by connections: positions have no meaning
metres-east-and-north-of = metres east and north of the origin
system-of-the-control-points = system of the control points
system-of-the-orthophoto = system of the orthophoto
the-blocks-own-system-without = the block’s own system, without scale and north
by-residual = by residual
by-rays = by rays
by-height = by height
not-shown = not shown
press-an-image-a-point = Press an image, a point or a line to choose it; press a pair again, or Enter, to open it. Shift and drag chooses tie points. Drag pans · wheel and + − zoom · 0 fit · N P images · C pairs of an image · arrows pan.
map = Map
map-of-the-block = map of the block
images-and-tie-points-of = Images and tie points of the block from above
lines-between-connected-images-wider = Lines between connected images, wider with their common points; dashed those of pairs that were rejected by hand
photos = Photos
small-photos-where-they-have = Small photos where they have room
footprints = Footprints
what-each-image-covers-of = What each image covers of level ground at the height of its points
offsets = Offsets
gnss-positions-and-differences-of = GNSS positions and differences of ground control and check points, drawn longer than they are
the-orthomosaic-of-the-block = The orthomosaic of the block, under all else
the-orthophoto-that-is-given = The orthophoto that is given, under all else
lasso = Lasso
shift-and-a-drag-chooses = Shift and a drag chooses tie points within a free outline, in place of a rectangle
orthomosaic-2 = Orthomosaic
makes-a-quick-orthomosaic-of = Makes a quick orthomosaic of the block and lays it under the map
common-points = { COUNT($most) } common points
matches = { COUNT($matches) } matches
widest-line = Widest line: { $widest }.
the-orthomosaic-is-of-an = {" "}The orthomosaic is of an earlier run.
the-orthophoto-is-in-another = {" "}The orthophoto is in another system: place the block on it, or images of it, and it lies under them.
orthophoto-laid-under-by-positions = {" "}Orthophoto laid under by the positions of both on the earth ({ $crs }{ $departs ->
        [none] {""}
       *[other] ; off by up to { FIXED($departs, digits: 1) } px
    }).
the-orthophoto-is-not-laid-under = {" "}The orthophoto is not laid under the block: { $reason }
the-block-is-outside-the-system = {" "}The orthophoto is not laid under the block: the block lies outside its system ({ $crs }).
the-orthophoto-lies-elsewhere = {" "}The orthophoto lies elsewhere than the block ({ $crs }): give one of the same ground.
orthophoto-laid-under-by-placed = {" "}Orthophoto laid under by { COUNT($images) } { $images ->
        [one] image
       *[other] images
    } placed on it.
images-oriented-connected-pairs = { $view } { COUNT($images) } images, { COUNT($oriented) } oriented, { COUNT($connected) } connected pairs
and-rejected-by-hand = {" "}and { COUNT($gone) } rejected by hand
tie-points-from-to = { COUNT($taking) } tie points{ $what }; { $title } from { $from } to { $to } { $unit }
ground-sample-distance = Median ground sample distance { $gsd }
gsd = GSD { $gsd }
gnss-positions-differ-by-up = GNSS positions differ by up to { $gnss }
surveyed-points-differ-by-up = { COUNT($surveyed) } ground control and check points differ by up to { $surveyed_2 }
in-plan-and-height = { $plan } in plan{ $height ->
        [none] {""}
       *[other] , { $height } in height
    }
the-images-lie-within-by = The images lie within { $length_text } by { $length_text_2 }
length-in-units-of-the-block = { $length } units

## panel/matrix-view

press-a-cell-to-choose = Press a cell to choose its pair; press it again, or Enter, to open the pair. Drag pans · wheel and + − zoom · 0 fit · arrows choose.
matrix = Matrix
matrix-of-matches = matrix of matches
images-by-images-arrow-keys = Images by images; arrow keys choose a pair
strongest-cell-matches-small-square = Strongest cell: { COUNT($view) } matches. Small square: not connected. Hollow: rejected by hand. Blank: not tried.

## panel/mode

back-to-the-block = ← Back to the block
use-masks-in-the-block = Use the masks in the block
what-they-mask-holds-no = What they mask holds no points in the block either, from its next run on
masks-are-of-the-block = The masks of { $names } are those of the block now.
block-has-no-mask-of = The block has no mask of { $names } now.
reject-matches-in-the-block = Reject { $matches ->
        [one] 1 match
       *[other] { COUNT($matches) } matches
    } in the block, too
rejects-their-observations = Rejects both observations of each tie point that they joined, as one step of the block’s edits, which is undone there
measured-matches-into-the-block = Take { $matches ->
        [one] 1 measured match
       *[other] { COUNT($matches) } measured matches
    } into the block
they-become-tie-points = What was measured by hand becomes tie points of the block, and a match that was moved moves the observations of its tie point, as one step of the block’s edits
rejected-without-tie-point = Rejected here without a tie point in the block: { COUNT($without) } of { COUNT($rejected) }.
edit-and-figures = In the block: { $edit }; { $figures }.
pairs-of-the-block-open-here = Pairs of the block open here, too: { $names } has most matches; others are chosen on its map, in its matrix or table.

## panel/scans-line

marks-of-this-scan = Marks of { $name }
use-marks-in-the-block = Use the marks in the block
the-tables-of-marks-become = The measured marks become the tables of marks of these scans, in place of those that they have
next-scans = Next scans
next-scans-help = The next one or two scans without marks; once all have marks, one after the other again
# $worst: the mark that fits worst; 0 where none stands out.
marks-far-off = { $name }: σ₀ of its marks is { FIXED($px, digits: 1) } px of the scan; { $worst ->
        [0] one of them is measured wrongly, or its x and y are mistyped: look at each again.
       *[other] mark { COUNT($worst) } fits worst: measure it again, or correct its x and y.
    }
marks-of-more-far-off = { $scans ->
        [one] The marks of 1 more scan lie far off, too.
       *[other] The marks of { COUNT($scans) } more scans lie far off, too.
    }
marks-without-mm = { $name }: { $marks ->
        [one] 1 mark has
       *[other] { COUNT($marks) } marks have
    } no x and y in mm; type them under Camera, in the settings.

## panel/mosaic

was-saved-2 = { $name } was saved.{ $store }
noted = Note: { $remark }
laying-the-orthomosaic-under-the = Laying the orthomosaic under the map …
the-orthomosaic-lies-under-the = The orthomosaic lies under the map. { $orthophoto }{ $store }
the-orthomosaic-cannot-be-shown = The orthomosaic cannot be shown: { $sentence }
an-orthomosaic-is-made-of = An orthomosaic is made of the images of the block, and none of them is there: drop them.
cancelled-no-orthomosaic-was-made = Cancelled: no orthomosaic was made.
no-orthomosaic-was-made = No orthomosaic was made: { $sentence }
missing-in-it-add-to = {" "}{ COUNT($missing) } { $missing ->
        [one] image is
       *[other] images are
    } missing in it: add { $missing ->
        [one] it
       *[other] them
    } to the project.

## panel/orthophoto-view

role-picture = picture
press-a-footprint-to-see = Press a footprint to see its image beside the orthophoto, a link to see it in both; of a block on it a footprint or a place, to choose it. Drag pans · wheel and + − zoom · 0 fit · arrows pan · N P links or places · Page Down, Page Up images · Escape nothing chosen. Links by hand: Delete rejects, R uses again, A measures a new one, Enter accepts.
orthophoto-with-the-images-that = Orthophoto with the images that are placed on it
the-chosen-image-with-its = The chosen image with its links
column-row = column { FIXED($place, digits: 1) }  row { FIXED($place_2, digits: 1) }
press-the-place-on-the-orthophoto = A new place: press it on the orthophoto, or move it under the cross and press Enter. The images that show it open next.
places-by-hand-wait = { $places ->
        [one] 1 place by hand
       *[other] { $places } places by hand
    }, { $measured } measured in two images or more: three whose measurements fit each other bring the block into the system of the orthophoto.
press-the-orthophoto-where-images = Press the orthophoto where images were taken.
a-block-that-is-placed = The map shows the block on the orthophoto.
press-a-footprint-or-a = Press a footprint or a row of the table to see its links.
a-new-link-press-the = A new link: press the same point in the image and on the orthophoto.
press-the-point-in-the = Press the point in the image.
press-the-point-on-the = Press the point on the orthophoto.
press-again-to-move-an = Press again to move an end; Enter or Accept takes the link.
adjusting = Adjusting …
of-at-least-links-by = { $name }: { COUNT($added) } of at least { COUNT($least_links) } links by hand.
the-image-does-not-see = the image does not see its place
residual-px-px = residual { FIXED($residual, digits: 2) }, { FIXED($residual_2, digits: 2) } px ({ FIXED($hypot, digits: 2) } px)
measured-by-hand-3 = , measured by hand
link-of = Link { COUNT($link) } of { COUNT($count) }{ $what }, { $name }: { $off };{" "}
links = Links:{" "}
links-by-which-the-image = Links by which the image is oriented
links-that-took-no-part = Links that took no part and check the result
links-that-were-rejected-as = Links that were rejected as gross errors
places-of-the-block = Places:{" "}
places-by-which-the-block = Places of the ground by which the block lies in the system of the orthophoto: control points
places-that-took-no-part = Places of the ground that took no part and check the result: check points
places-that-were-rejected = Places of the ground that were rejected by hand
chooses-the-next-place-of = chooses the next place of the ground
chooses-the-previous-place-of = chooses the previous place of the ground
rough-place = Rough place
the-next-press-on-the = The next press on the orthophoto says near where images were taken; they are sought within the radius that is set
over-the-orthophoto = Over the orthophoto
the-chosen-image-on-the = The chosen image on the ground, over the orthophoto: press it again and again, and see whether roads run on
everywhere = Everywhere
images-are-sought-on-the = Images are sought on the whole orthophoto
whole-orthophoto = Whole orthophoto
no-image-is-chosen = No image is chosen
reject-link = Reject link
leaves-the-chosen-link-out = Leaves the chosen link out (Delete)
use-link = Use link
lets-the-chosen-link-take = Lets the chosen link take part (R)
add-link = Add link
add-place = Add place
measures-a-place-by-hand = Measures a place of the orthophoto by hand, which then holds the block as a control point (A)
measures-a-link-by-hand = Measures a link by hand, in the image and on the orthophoto (A)
takes-the-link-that-is = Takes the link that is measured (Enter)
undo-2 = Undo: { $last }
redo-2 = Redo: { $next }
open-an-orthophoto = Open an orthophoto …
try-a-sample = Try a sample
photographs-placed-on-an-orthophoto = Photographs placed on an orthophoto
drop-an-orthophoto-and-photographs = Drop an orthophoto and photographs of the same ground anywhere on this page, one photograph or many, of another year, tilted, or scanned. You get:
where-each-was-taken-and = where each was taken and how it was turned, in the system of the orthophoto, without a control point
how-precise-that-is-and = how precise that is, and links that took no part and check it
each-photograph-on-the-ground = each photograph on the ground, as GeoTIFF
an-orthophoto-is-a-geotiff = An orthophoto is a GeoTIFF in a projected system, or a picture with a world file. Heights of its ground, as GeoTIFF or ESRI ASCII grid, are dropped with it; without them the ground is level.

## panel/placing-answer

links-3 = links
of = {" "}({ COUNT($total) } of { COUNT($total_2) })
open-an-orthophoto-photographs-are = Open an orthophoto: photographs are placed on it, without control points.
open-photos = Open photos …
can-be-placed = { $files } can be placed. { $what }
place-on-the-orthophoto = Place on the orthophoto
place-them-as-a-block = Place them as a block
its-ground-is-taken-as = Its ground is taken as level at { FIXED($height, digits: 2) } { $unit }: give its heights where it is not.
they-lie-under-of-the = {" "}They lie under { $share } % of the orthophoto: nothing is placed elsewhere.
heights-of-to =
    Heights of { $name }: { FIXED($from, digits: 1) } to { FIXED($to, digits: 1) } { $unit }{ $given_in ->
        [none] {""}
       *[other] , converted from { $given_in } as their file says
    }.{ $from_what ->
        [none] {""}
       *[other] {" "}They count from { $from_what }.
    }{ $part }
with-doubt =
    { $of ->
        [one] , with doubt
        [all] , all with doubt
       *[some] , { COUNT($weak) } of them with doubt
    }
not-placed = , { COUNT($without) } not placed
reason-of = { $name }: { $reason }
of-placed = { COUNT($placed) } of { $tried } placed{ $what }{ $what_2 }.
then = then
placed = { $stale } { $stale_2 ->
        [one] was
       *[other] were
    } placed
settings-heights-or-cameras-have = Settings, heights or cameras have changed since { $what }: press Place.
not-tried-yet-press-place = { $waiting } not tried yet: press Place.
save-positions-csv = Save positions (CSV)
open-heights = Open heights …
place-them = Place
of-2 = { COUNT($placements) } of { COUNT($tried) }
images-placed = images placed
rmse-of-check-links-on = RMSE of check links on the ground

## panel/placing-exports

positions-placed-csv = Positions (placed.csv)
links-links-csv = Links (links.csv)
all-results-result-json = All results (result.json)
chosen-image-on-the-ground = Chosen image on the ground (GeoTIFF)
all-images-on-the-ground = All images on the ground (.zip)
what-of-the-placed-images = What of the placed images is saved
cancelled-nothing-was-saved = Cancelled: nothing was saved.
nothing-was-saved = Nothing was saved: { $sentence }
no-image-is-chosen-2 = no image is chosen
resampling-to-the-ground-of = Resampling { $name } to the ground ({ $i } of { $placed }) …

## panel/film-settings

scanned-film = Scanned film
film-camera = Film camera
marks-of-scans = Fiducial marks of scans
none-film-camera = No film camera. The calibrated camera of scanned photos on film, a JSON file: { $example }.
none-marks-of-scans = No fiducial marks. A table of col, row, x_mm, y_mm for each scan, named as its image: { $example } for { $image }.
marks-of-no-image = No image has the name of { $name }: fiducial marks are named as the image of their scan.
measure-marks = Measure marks
measure-marks-help = Opens scans without fiducial marks, two at a time, in the view of pairs, where their marks are pressed in the pictures
marks-of-some-scans = Marks of { COUNT($measured) } of { $scans ->
        [one] 1 scan
       *[other] { COUNT($scans) } scans
    }.
make-frames = Make images of one camera
make-frames-help = For a block: resamples each scan by its fiducial marks to the image of an ideal camera, one for all of them, without distortion. These images take the place of the scans, with masks of the marks and the file of their camera. Masks of the scans, image measurements that were made in them, and their GNSS positions go along.
resampling-scan = Resampling { $name }
two-scans-of-one-name = { $name } and another scan would become images of one name: rename one of them.
frame-is-there = { $name }, the image of a scan, is there already. Nothing was changed: remove the scan, or that image.
scans-became-frames =
    { $frames ->
        [one] 1 scan was resampled to an image
       *[other] { COUNT($frames) } scans were resampled to images
    } of one camera, { $known ->
        [yes] which counts as calibrated
       *[no] which the block calibrates within what its calibration and the errors of the fiducial marks leave open
    }. Masks leave out the fiducial marks.
measurements-carried =
    { $moved ->
        [one] 1 image measurement was
       *[other] { COUNT($moved) } image measurements were
    } carried over.
measurements-beside-frames =
    { $count ->
        [one] 1 image measurement lies
       *[other] { COUNT($count) } image measurements lie
    } beside the images of scans, which end within the fiducial marks: { $listed }. Skipped.
no-frames-were-made = No images were made of the scans: { $sentence }
camera-of-frames = camera of the film
marks-need-their-camera = Fiducial marks need the film camera with its focal length in mm.

## files/film

cannot-be-used-of-film = { $name } cannot be used: { $problem }

## panel/placing-settings

none-a-geotiff-in-a = None. A GeoTIFF in a projected system, or a picture with its world file (.tfw, .jgw, .pgw, .wld) and perhaps its system (.prj): choose them together.
none-the-ground-is-level = None: the ground is level. A GeoTIFF of heights or an ESRI ASCII grid, in the system and unit of the orthophoto.
orthophoto-2 = Orthophoto …
file-orthophoto = File: Orthophoto
heights = Heights …
file-heights = File: Heights
remove = Remove
remove-orthophoto = Remove: Orthophoto
from-to = { $name }: { FIXED($from, digits: 1) } to { FIXED($to, digits: 1) } { $unit }.
level-ground-at = Level ground at
level-of-block = Its height is the median of the tie points of the block: { $height }.
what-is-done-with-it = Used for
purpose-block = the block
purpose-images = each image
purpose-map = the map

## panel/placing-tables

placed-images = Placed images
links-2 = Links
table-placed-images = Table: Placed images
links-of-the-chosen-image = Links of the chosen image
table-links-of-the-chosen = Table: Links of the chosen image

## panel/placing-words

not-read = Not read: { $problem }

## panel/plots-view

role-plot = plot
press-a-value-to-choose = Press a value to choose what it is about; Shift and drag chooses all in a rectangle. Drag pans · wheel and + − zoom · 0 whole plot · Escape nothing chosen.
plots = Plots
plot-of-the-block = Plot of the block
plot = Plot
saves-the-plot-as-it = Saves the plot as it is shown, as a picture
saves-the-values-of-the = Saves the values of the plot
this-block-has-none = There are no such values: this block has none.
there-are-no-such-values = There are no such values: this block has none, or is not oriented yet.
n--2 = {" "}{ $unit }
axis-title = { $label }, { $unit }
values-over-median-from-to = { COUNT($sorted) } values over { $to_lower_case }. { $label }: median { $at }, from { $at_2 } to { $at_3 }{ $what }.
unchecked-at-the-top = { COUNT($unchecked) } { $unchecked ->
        [one] more stands
       *[other] more stand
    } at the top: nothing checks one of the two coordinates.

## panel/progress

seconds = { $value } s
hours = { $value } h
images-features = Images: features
similarity-of-images = Similarity of images
pairs-matches = Pairs: matches
windows-of-observations = Windows of observations
refinement = Refinement
from-an-earlier-run = , { COUNT($found) } from an earlier run
of-3 = { COUNT($done) } of { COUNT($total) }{ $what }
about-left = , about { $seconds_left } left
starting = Starting …
min = { $minutes } min

## panel/results

without-the-orthophoto = Without the orthophoto
the-block-as-it-was = Gives the block as it was before it was placed on the orthophoto

one-group = one
unknown-2 = unknown
no-block-yet-drop-images = No block yet. Drop images or a folder, or simulate a block, then press Run.
so-far = So far
masks-without-an-image = Masks without an image
no-image-has-their-name = no image has their name
image-measurements-without-an-image = Image measurements without an image
not-among-the-images-read = not among the images read
remarks = Remarks
warnings = Warnings
tie-points-by-number-of = Points by number of rays
images-read = Images read
images-whose-features-are-detected = Images whose features are detected.
connected-pairs = Connected pairs
of-tried = { COUNT($connected) } of { COUNT($connections) } tried
pairs-with-enough-matches-that = Pairs with enough matches that agree with one geometry.
verified-matches-of-all-connected = Verified matches of all connected pairs.
check-points-rmse = Check points, RMSE
predicted = , { FIXED($ratio, digits: 2) } times the predicted standard errors
m-points = { $join } m, { COUNT($points) } points{ $what }
root-mean-square-difference-of = Root mean square difference of x, y, z between adjusted and given coordinates of the check points, whose coordinates took no part (their image measurements did, as those of tie points), in m along the axes of the coordinate system of the results; then the same divided by the predicted standard errors, about 1 where these hold.
check-points-mean = Check points, mean
mean-m = { $join } m
mean-difference-of-check-points = Mean difference of x, y, z between adjusted and given coordinates of the check points, in m along the axes of the coordinate system of the results. One that is large beside their root mean square is a shift that all of them share.
images-oriented-3 = Images oriented
of-4 = { COUNT($oriented) } of { COUNT($images) }
images-with-an-exterior-orientation = Images with an exterior orientation: position and attitude in object space.
pairs-with-enough-matches-that-agree = Pairs with enough matches that agree with one geometry. The matrix states for each pair why it is connected or not.
groups = Groups
images-that-are-connected-directly = Images that are connected directly or through others. Images are oriented to each other only within a group.
observations-2 = { COUNT($points) }, { COUNT($rays) } observations
points-seen-in-two-or = Points seen in two or more images. A well distributed selection of them is adjusted.
selected-tie-points = Selected tie points
the-tie-points-of-the = The tie points of the block that are adjusted, and their image observations, without ground control and check points.
control-and-check-points-of-the = The ground control and check points of the block, and their image measurements without rejected ones.
root-mean-square-length-of = Root mean square length of the residuals of all accepted observations after the adjustment.
standard-error-of-one-image = Standard error of one image coordinate, from the adjustment.
did-not-converge = did not converge
at-the-border = at the border
moved-too-far = moved too far
low-correlation-2 = low correlation
no-texture = no texture
inconsistent = inconsistent
refined-observations = Refined observations
of-5 = { COUNT($refined) } of { COUNT($refined_2) }
n--3 = : { $join }
observations-moved-by-least-squares = Observations moved by least squares matching to the reference observations of { COUNT($reference) } points. The others keep their positions{ $what }.
right-points = Right points
of-6 = { COUNT($right_points) } of { COUNT($points) }
points-whose-observations-all-agree = Points whose observations all agree within 1.5 px in each image, by the true orientations.
their-observations = Their observations
root-mean-square-distance-of = Root mean square distance of the observations of right points from their intersection.
positions = Positions
root-mean-square-errors-of = Root mean square errors of x, y, z of the projection centres after the best similarity transformation to the truth.
angles = Angles
root-mean-square-angle-between = Root mean square angle between the oriented and the true attitudes after the same transformation.
single = , { COUNT($alone) } single
the-largest-of = { COUNT($sizes) } (the largest of { COUNT($largest) }){ $what }
other-files-skipped = Other files, skipped
no-images-by-their-names = no images by their names
skipped-that-cannot-be-read = Skipped: { COUNT($left_out) } that cannot be used
take-these-out = Take these out
not-oriented = Not oriented: { COUNT($lost) }
and-more-in-the-table = and { COUNT($rest) } more in the table of images
rays-2 = Rays
rmse-px-4 = RMSE px
given-f-px = Given f px
calibrated-f-px = Calibrated f px

## panel/settings

use-gnss-positions = Use GNSS positions
they-choose-near-pairs-and = They choose near pairs and georeference the block.
wait-for-run = Wait for Run
images-that-are-given-wait = Images that are given wait until Run is pressed, so that settings and files come first. Otherwise they run at once.
from-exif-a-json-file = From EXIF. A JSON file overrides it: { $example }, with principal_point_px, radial, tangential, fixed where known.
none-two-files-georeference-the = None. Ground control points (name, x, y, z, optionally two standard errors) georeference the block with their image measurements (image, point, column, row), one per line. Without a file of these, measure the points in the images.
none-positions-of-images = None. GNSS positions of images (image, longitude, latitude and height above the ellipsoid or, in the coordinate system that is set below, x, y and height; optionally two standard errors) take the place of those that the files record. A first line names the columns.
none-images-of-the-same = None. Images of the same size, black where no features are detected; IMG_1.png, IMG_1_mask.png or IMG_1.jpg.png is the mask of IMG_1.jpg.
masks = Masks
none-a-file-from-which = None. The geoid to which heights of the coordinate system refer: a GeoTIFF of longitudes and latitudes, GTX (which can be dropped), or PGM of GeographicLib.
masks-2 = { $given } masks: { $names }{ $what }
file = File: { $title }
remove-2 = Remove: { $title }

## panel/stage

whole-block = whole block
view-of-the-block = View of the block
table-2 = Table
pair-and-its-block = The pair and its block
open-this-pair = Open this pair
point-at-an-image-a = Point at an image, a line or a cell to see what it is and why a pair is not connected.
try-a-sample-orthophoto = Try a sample orthophoto
where-each-photo-was-taken = where each photo was taken and how it was turned
points-that-several-photos-show = points that several photos show, in space, and how precise they are
files-for-other-programs-colmap = files for other programs: COLMAP, MicMac, OpenSfM, Agisoft and more
where-did-each-photo-stand = Where was each photo taken from?
drop-the-photographs-of-a = Drop the photographs of a flight or of a walk around something, or a folder of them, anywhere on this page. You get:
nothing-leaves-this-computer-work = Nothing leaves this computer. Work is kept in this browser: a run that was cancelled, or ended with its tab, goes on from there.
are-placed-on-the-orthophoto =
    { $placed ->
        [one] 1 of them is
       *[other] { $placed } of them are
    } on the orthophoto, each by itself: see the view Orthophoto. This view shows them once they are run as a block.
images-3 =
    { $names ->
        [one] 1 image
       *[other] { $names } images
    }: { $join }{ $what }

## panel/status

go-on = Go on
the-screen-shows-the-former = {" "}The screen shows the former block.
shown-and = shown and{" "}
cancelled-the-work-done-is = Cancelled.{ $former } The work done is { $what }kept: Go on continues from there.
the-work-done-is-kept = {" "}The work done is kept.
the-block-was-not-finished = The block was not finished: { $failure }{ $what }
images-or-settings-have-changed = Images or settings have changed: press Run.
open-the-images-of-a = Open the images of a block: files, a folder, or a simulated block.
tie-points-used = tie points used
rmse-of-check-points = { $points ->
    [one] 1 check point, RMSE in plan · in height
   *[other] { COUNT($points) } check points, RMSE in plan · in height
}
median-errors-of-tie-points = tie points, median σ in plan · in height
plan-and-height-of = { $plan } · { $height } m
plan-and-height-m = { FIXED($plan, digits: 3) } · { FIXED($height, digits: 3) } m
control-places-the-block = The block lies where its control points place it. It can be placed on the orthophoto, too.
a-block-on-an-orthophoto = The block can be placed on it: it then lies in its system, without a control point.
place-the-block-on-the = Place the block on the orthophoto
place-each-image = Place each image by itself
only-under-the-map = Only under the map
not-now = Not now
the-block-is-not-on = The block is not placed on the orthophoto by these settings.
places-found-hold-it-too = Places that are found on the orthophoto can hold it, too.

oriented = oriented
accepted = accepted
rejected-2 = rejected
too-few-rays = rejected: too few rays that meet
role = { $role ->
        [control] control
       *[check] check
    }

## state/columns

projection-centre-in-m-where = Projection centre, { $key }; in m where the block has a scale.
image-2 = Image
file-name-press-it-to = File name. Press it to choose the image in all views; with Shift or Ctrl several.
no = No.
row-and-column-in-the = Row and column in the matrix.
features = Features
points-detected-and-described = Points detected and described.
obs = Obs.
observations-of-selected-tie-points = Observations of selected tie points, and of ground control and check points, without rejected ones.
cov = Cov.
coverage-how-many-of-the = Coverage: how many of the nine von Gruber positions hold a selected tie point.
root-mean-square-length-of-the = Root mean square length of the residuals of its observations.
images-of-one-camera-are = Images of one camera are calibrated together: { $join }.
state = State
whether-the-image-is-oriented = Whether the image is oriented, and if not, why.
the-image-of-the-pair = The image of the pair that comes first. Press a row to choose its pair in all views.
with = With
the-other-image-of-the = The other image of the pair.
verified-matches-of-a-connected = Verified matches of a connected pair.
common = Common
tie-points-that-both-images = Tie points that both images show.
selected = Selected
of-them-those-that-were = Of them, those that were selected and kept.
geometry-2 = Geometry
what-relates-the-two-views = What relates the two views, with the standard error of a coordinate.
outcome = Outcome
why-the-images-are-connected = Why the images are connected or are not.
object-coordinate-in-m-where = Object coordinate, in m where the block has a scale.
standard-error-of-from-the = Standard error of { $label }, from the adjustment.
number-of-the-point-press = Number of the tie point, or name of the ground control or check point. Press a row to choose it in all views; with Shift or Ctrl several.
observations-of-the-point = Observations of the point, without rejected ones.
kind = Kind
tie-point-2 = tie point
tie-point-or-control = Whether it is a tie point, a ground control point or a check point.
probability = Probability
probability-that-all-its-observations = Probability that all its observations show one point, from the matches alone.
part = Part
whether-the-point-takes-part = Whether the point takes part in the adjustment.
name-of-the-surveyed-point = Name of the ground control or check point. Press a row to choose it in all views.
use = Use
control-points-place-the-block = Control points place the block; check points judge it, and take no part.
image-measurements-that-took-part = Image measurements that took part.
surveyed-in-the-system-of = Surveyed { $axis }, in the system of the block.
as-given = { $axis } as given
in-system = { $axis } { $code }
coordinate-in-system = { $axis } in { $name }, the coordinate reference system of the results.
in-the-unit-and-the = { $axis } as the file gives it, in its unit and system.
adjusted-minus-surveyed = Adjusted minus surveyed { $axis }.
standard-error-of = Standard error of Δ{ $axis }.
difference-by-standard-error = Difference of { $axis } by its predicted standard error: of a control point that where it is left out, as far as it is known. Beyond 2 it is larger than predicted, beyond 3 rarely by chance.
difference-left-out = Δ{ $axis } left out
where-the-other-observations-have = Of a control point: { $axis } where the other observations have it, without its own coordinates, minus surveyed: what it is worth as a check point.
standard-error-left-out = σ Δ{ $axis } left out
standard-error-of-where-the = Standard error of Δ{ $axis } where the control point is left out.
the-image-that-shows-the = The image that shows the point. Press a row to choose its point, as this image shows it, in all views.
number-of-the-point = Number of the tie point, or name of the ground control or check point.
column-the-centre-of-the = Column; the centre of the top-left pixel is at 0.5.
row = Row.
residual-in-x-observed-minus = Residual in x: observed minus computed.
residual-in-y-observed-minus = Residual in y: observed minus computed.
residual = Residual
length-of-the-residual = Length of the residual.
redundancy-number-of-an-observation = Redundancy number of { $axis }, 0 to 1: the share of an error of the coordinate that shows in its residual. Near 0 nothing checks it.
w-statistic-of-an-observation = w-statistic of { $axis }: residual by its standard error (Baarda). Data snooping rejects the largest.
mdb-of-an-observation = Minimal detectable bias (MDB) of { $axis }: the test of the coordinate finds an error of this size with a probability of 0.80. It grows as the redundancy number falls.
whether-the-adjustment-accepted-the = Whether the adjustment accepted the observation, and if not, who rejected it.

## state/editing

the-edit-was-not-made = The edit was not made: { $reason } The block is unchanged.

## state/given

image-measurements-need-their-ground = Image measurements need their ground control points: give that file too

placed-2 = placed
link-use = { $use ->
        [used] used
        [check] check
       *[rejected] rejected
    }

## state/placed-columns

with-doubt-2 = with doubt
not-placed-2 = not placed
not-read-2 = not read
file-name-press-a-row = File name. Press a row to see the image beside the orthophoto.
verdict = Verdict
earlier-settings = {" "}(earlier settings)
what-the-place-of-the = What the place of the image is worth.
projection-centre-in-the-system = Projection centre, { $axis }, in the system of the orthophoto.
standard-error-of-2 = Standard error of { $axis }.
rotation = Rotation { $angle }.
standard-error-of-3 = Standard error of { $angle }.
points-of-the-image-and = Points of the image and their places on the orthophoto by which it is oriented.
rejected = Rejected
links-rejected-as-gross-errors = Links rejected as gross errors.
root-mean-square-length-of-the-residuals = Root mean square length of the residuals of its links.
checks = Checks
links-that-took-no-part-and = Links that took no part and check the result.
check-rmse = Check RMSE
root-mean-square-length-of-the-residuals-of = Root mean square length of the residuals of check links, without gross errors.
on-the-ground = on the ground
the-same-on-the-ground = The same on the ground.
ground-sample-distance-the-side = Ground sample distance: the side of a pixel of the image on the ground.
above-ground = Above ground
height-of-the-projection-centre = Height of the projection centre above ground.
why = Why
the-verdict-in-a-sentence = The verdict in a sentence.
link = Link
number-of-the-link-press = Number of the link. Press a row to see it in image and orthophoto.
used-for-the-orientation-kept = Used for the orientation, kept out to check it, or rejected, by hand or as a gross error.
column = Column
position-in-the-image-the = Position in the image; the centre of the top-left pixel is (0.5, 0.5).
row-2 = Row
position-in-the-image = Position in the image.
place-on-the-orthophoto-2 = Place on the orthophoto.
height-of-the-ground-at = Height of the ground at that place.
residual-x = Residual x
observed-minus-computed-column = Observed minus computed column.
residual-y = Residual y
observed-minus-computed-row = Observed minus computed row.
length = Length

## state/plots

residuals-by-image = Residuals by image
residuals-of-observations = Residuals of observations
w-against-the-normal-distribution = w-statistics against the normal distribution
minimal-detectable-biases-by-image = Minimal detectable biases by image
tie-points-by-rays = Tie points by rays
standard-errors-in-plan-along = Standard errors in plan, along the block
standard-errors-in-height-along = Standard errors in height, along the block
gnss-positions = GNSS positions
control-and-check-points-plan = Control and check points, plan
control-and-check-points-height = Control and check points, height
rmse-of-the-residuals = RMSE of the residuals
gnss-minus-adjusted-position = GNSS minus adjusted position
standard-error-in-plan = Standard error in plan
standard-error-in-height = Standard error in height
adjusted-minus-surveyed-place = Adjusted minus surveyed place
adjusted-minus-surveyed-height = Adjusted minus surveyed height
control-point-left-out = control point, left out
control-point-adjusted = control point, in the adjustment
whiskers-of-95 = ± 1.96 standard errors
surveyed-value = { $name }, { $kind }: { FIXED($difference, digits: 3) }{ $known ->
    [yes] {" "}m, σ { FIXED($error, digits: 3) } m, Δ/σ { FIXED($ratio, digits: 1) }
   *[no] {" "}m
}
residual-vx = Residual vx
residual-vy = Residual vy
w-of-normal-errors = w of normally distributed errors
w-statistic = w-statistic
image-coordinate = Coordinate
minimal-detectable-bias = Minimal detectable bias

by-hand-kept = { $edits } { $edits ->
        [one] edit
       *[other] edits
    } by hand { $edits ->
        [one] was
       *[other] were
    } kept.
edits-of-places = { $lost ->
        [0] What was done to { $held } { $held ->
            [one] place
           *[other] places
        } of the orthophoto holds where { $held ->
            [one] it lies
           *[other] they lie
        } again.
       *[other] What was done to places of the orthophoto holds for { $held } that lie there again, and not for { $lost }: nothing was found there, or what was measured is of another spot.
    }
edits-of-places-wait = { $edits } { $edits ->
        [one] edit of places of the orthophoto waits
       *[other] edits of places of the orthophoto wait
    } until the block lies on it again.
of-points-of-the-former = { $lost } { $lost ->
        [one] edit
       *[other] edits
    } of points of the former block { $lost ->
        [one] does
       *[other] do
    } not apply to the new one.
cannot-be-done-again = { $undone } undone { $undone ->
        [one] edit
       *[other] edits
    } of points of the former block cannot be redone in the new one: { $steps }.
places-set-aside = { $steps } { $steps ->
        [one] step
       *[other] steps
    } of places by hand { $steps ->
        [one] was
       *[other] were
    } undone, since they bring the block onto the orthophoto: Redo makes them again.

## state/naming

nothing = nothing
step-join = join { $points ->
        [one] 1 point
       *[other] { $points } points
    }
step-split = split 1 point into { $added }
step-edits = { $edits ->
        [one] 1 edit
       *[other] { $edits } edits
    }
step-measure-in = { $verb ->
        [match] match
       *[measure] measure
    } { $what } in { $images }
step-measure = { $verb ->
        [match] match
       *[measure] measure
    } { $observations ->
        [one] 1 observation
       *[other] { $observations } observations
    }{ $place }
step-observations = { $verb ->
        [reject] reject
       *[restore] restore
    } { $observations ->
        [one] 1 observation
       *[other] { $observations } observations
    }{ $place }
step-points = { $verb ->
        [reject] reject
       *[restore] restore
    } { $points ->
        [one] 1 point
       *[other] { $points } points
    }
step-named = { $verb ->
        [reject] reject
       *[restore] restore
    } { $name }
step-add-point = add 1 point in { $images ->
        [one] 1 image
       *[other] { $images } images
    }
step-add-place = add the place { $name }
step-use = { $use ->
        [none] leave { $name } out
        [control] use { $name } as control point
       *[check] use { $name } as check point
    }
so-many-pairs = { $pairs ->
        [one] 1 pair
       *[other] { COUNT($pairs) } pairs
    }
one-surveyed-point = 1 ground control or check point
in-image = {" "}in { $name }

## state/steps

rejected-as-a-gross-error = rejected as a gross error
link-measured-by-hand = measured by hand, { $use ->
        [used] used
        [check] check
        [by_hand] rejected by hand
       *[gross_error] rejected as a gross error
    }
add-a-link = add a link
link-2 = { $kind ->
        [reject] reject
       *[restore] restore
    } link { $link }

## state/words

features-2 = { COUNT($features) } features,{" "}
in-of-9-von-gruber = {" "}in { $places } of 9 von Gruber positions
observations-4 = { $name }: { $what }{ COUNT($rays) } observations{ $what_2 }
connected-with-of-images = connected with { COUNT($partners) } of { COUNT($images) } images
used-as-stored-exif-orientation = used as stored, EXIF orientation { $exif_orientation }
pair-rejected-by-hand = rejected by hand; { $reason }
this-pair-was-not-tried = { $names }: this pair was not tried (the choice of pairs skips it).
common-points-selected = { COUNT($shared) } common points, { COUNT($chosen) } selected
rays-3 = { $name }: { COUNT($rays) } rays
to = { COUNT($least) } to { COUNT($most) }
rmse-px-5 = ; RMSE { FIXED($squares, digits: 2) } px
rejected-by-hand-3 = ; { COUNT($gone) } rejected by hand
tie-points-of-rays = { $surveyed ->
        [0] { COUNT($chosen) } tie points
        [one] { COUNT($chosen) } points, 1 of them a ground control or check point,
       *[other] { COUNT($chosen) } points, { COUNT($surveyed) } of them ground control or check points,
    } of { $rays } rays{ $what }{ $what_2 }.

## view/chart

opens-the-chosen-pair = opens the chosen pair
chooses-nothing = chooses nothing

## view/images/images

images-of-a-block-measuring = Images of a block, measuring
images-of-a-block = Images of a block

## view/images/keys

measures-the-chosen-point = measures the chosen point
measures-a-new-tie-point = measures a new tie point
matches-the-point-in-the = matches the point in the other images by least squares; with Shift in the active image alone, by another one
gives-up-measuring = gives up measuring
takes-the-middle-of-the = takes the middle of the pane, then the expected place, then accepts the point
chooses-the-next-tie-point = chooses the next tie point of the active image
chooses-the-previous-tie-point = chooses the previous tie point of the active image
shows-the-next-images = shows the next images
shows-the-previous-images = shows the previous images
goes-to-the-next-pane = goes to the next pane
links-all-panes-or-no = links all panes, or no longer
shows-the-loupe-or-no = shows the loupe, or no longer
shows-images-in-which-the = shows images in which the point is not measured

## view/images/measuring

matching-in-the-other-images = Matching in the other images by { $image } …
matching-in-one-image = Matching in { $image } …
matched-in-one-image = Matched in { $image } by { $by }. { $what }
no-other-has-the-point = Not matched: no other image that is shown has the point.
cancelled-nothing-was-matched = Cancelled. Nothing was matched.
not-matched = Not matched: { $error }.
enter-accepts = Enter accepts.
matched-in-of-images = Matched in { $count } of { $found } images. { $what }
images-4 = { $lost } images
no-match-is-confirmed-in = { $done } No match is confirmed in { $where }: there is too little texture, or they look too different.

## view/images/observations

px-4 = { $px } px × { $factor }

## view/map/map

drawn-longer = drawn × { $factor }
between-clauses = ;{" "}
chooses-the-next-image = chooses the next image
chooses-the-previous-image = chooses the previous image
chooses-the-next-pair-of = chooses the next pair of the image
gnss-minus-adjusted-up-to = GNSS minus adjusted: up to { $gnss }
adjusted-minus-surveyed-up-to = adjusted minus surveyed: up to { $surveyed }

## view/orthophoto/plan

sought-from-here = sought from here

## The answer

block-images = { COUNT($images) } images.
block-done =
    { $verdict } { $images ->
        [one] 1 image
       *[other] { COUNT($images) } images
    }{ $skipped ->
        [0] {""}
        [1] , { $name } skipped ({ $reason })
       *[other] , { COUNT($skipped) } skipped, the first of them { $name } ({ $reason })
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
    }{ $surveyed ->
        [0] {""}
        [one] , 1 control or check point
       *[other] , { COUNT($surveyed) } control and check points
    }.{ $time ->
        [none] {""}
       *[other] {" "}{ $time }.
    }{ $warnings ->
        [0] {""}
        [one] {" "}1 warning, see Details.
       *[other] {" "}{ COUNT($warnings) } warnings, see Details.
    }
block-not-oriented =
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
geometry =
    { $model }{ $weak ->
        [none] {""}
       *[other] , { $weak }
    }, ± { FIXED($sigma_px, digits: 2) } px

## view/orthophoto/keys

gives-up-or-chooses-nothing = gives up, or chooses nothing
accepts-the-link-that-is = accepts the link that is measured
adds-a-place-or = measures a place of the orthophoto for the block, or gives it up
takes-the-place-under-the-cross = takes the place under the cross
adds-no-place = gives the place up
measures-a-new-link-or = measures a new link, or gives it up
uses-the-chosen-link-again = uses the chosen link again
rejects-the-chosen-link = rejects the chosen link
chooses-the-previous-image-that = chooses the previous image that was placed
chooses-the-next-image-that = chooses the next image that was placed
chooses-the-previous-link-of = chooses the previous link of the image
chooses-the-next-link-of = chooses the next link of the image
point-of-number = point { COUNT($number) }
within = ± { $length }
projection-centres-95 = projection centres (95 %)

use-by-hand = { $use }, by hand
given-use = { $role ->
    [control] control
    [check] check
   *[none] not used
  } · { $images ->
    [0] not measured
    [one] measured in 1 image
   *[other] measured in { $images } images
  }
given-point = { $name }: X Y Z { $place }; { $use }.
given-point-of-file = { $name }: X Y Z as given { $place }; { $use }.
measured = measured
marks-by-hand = Image measurements by hand
mark-of = { $point } in { $image }
several-pairs = { COUNT($pairs) } pairs: { $names }.
several-observations = { COUNT($observations) } observations of { $points ->
        [one] 1 point
       *[other] { COUNT($points) } points
    }.
several-images = { COUNT($images) } images: { $names }.
step-remove-images = remove { $images ->
        [one] 1 image
       *[other] { COUNT($images) } images
    }
step-make-frames = make images of one camera of { $scans ->
        [one] 1 scan
       *[other] { COUNT($scans) } scans
    }
step-beside-images = a measurement beside the images of scans
step-place-in = place the point in { $image }
step-unmark = remove { $what } in { $images }
control-waits = The control points take no part yet: { $twice ->
    [0] none is
    [one] 1 is
   *[other] { $twice } are
  } measured in two images or more, { $needed ->
    [one] 1 is
   *[other] { $needed } are
  } needed. Choose them in the table of control and check points, and press Measure.
control-can-be-taken = { $twice ->
    [one] 1 point is
   *[other] { $twice } points are
  } measured in two images or more.
taking-the-control = The block is adjusted again with them from what was matched, which takes seconds.{ $kept ->
    [edits] { " " }Edits by hand stay, but for those of its tie points.
   *[none] { "" }
  }
take-the-control = Take them into the block
