# Texts of both parts of the page, in English; an entry is named by its first words.

## Several parts

the-field-kind-is-damaged = the field { $name }.kind is damaged
the-field-is-damaged = the field { $name } is damaged
reading = Reading { $name } …
cannot-be-opened = { $name } cannot be opened
cancelled-nothing-was-changed = Cancelled. Nothing was changed.
were-not-taken-the-project = { $names } { $files ->
        [one] was
       *[other] were
    } not taken: the project was left before { $files ->
        [one] it was
       *[other] they were
    } read.
cannot-be-kept-in-this = { $edits } cannot be kept in this browser. { $step } without { $length ->
        [one] it
       *[other] them
    }?
the-pair-with-its-marks = The pair on the page, with its matches, marks, masks and camera,
settings = Settings
named-settings = Settings: { $settings }
geoid = Geoid
orthophoto = Orthophoto
simulate = Simulate
results = Results
details = Details
more-of-the-answer = More
less-of-the-answer = Less
details-of-the-results = Details of the results
clear = Clear
reject = Reject
restore = Restore
accept = Accept
cancel = Cancel
edits-by-hand = Edits by hand
point = Point
rejected-by-hand = Rejected by hand
before = before
save = Save
rejected-by-hand-2 = rejected by hand
by-hand = by hand
points = Points
linked = Linked
show = Show
view = View ▾
undo-sign = ↶
redo-sign = ↷
undo = Undo
redo = Redo
no-edit-to-undo = there is no edit to undo
no-edit-to-redo = there is no edit to redo
chosen-not-listed = { COUNT($others) } more chosen, not listed
nothing-is-chosen = nothing is chosen
nothing-is-measured = nothing is measured
nothing-is-running = nothing is running
nothing-is-changed = nothing is changed
show-why = Show why
orientation = Orientation
against-the-truth = Against the truth
matches-2 = Matches
px-3 = { FIXED($value, digits: 3) } px
camera = Camera
method = Method
files = Files
open-your-photos = Open your photos …
save-the-project = Save the project
was-saved = { $name } was saved.
px-2 = { FIXED($value, digits: 2) } px
sigma-of-image-observations = σ₀ of image observations
moves-the-measured-point-by = moves the measured point by 0.1 px; with Shift by 1 px
n-1-1-one-image-pixel = 1:1: one image pixel to one screen pixel (1)
shows-one-image-pixel-as = shows one image pixel as one screen pixel
this-browser-offers-no-canvas = this browser offers no canvas to draw on
focal-length = Focal length
pixel-size = Pixel size
fit = Fit
undo-3 = Undo: { $undo }
redo-3 = Redo: { $redo }

## engine/client

the-worker-ran-out-of = the worker ran out of memory ({ $message })
the-worker-broke-off-at = the worker broke off at a fault of the program ({ $message }): please report it
cancelled = Cancelled
the-worker-could-not-start = the worker could not start

## engine/platform

the-program-file-could-not = The program file { $file } could not be loaded (HTTP { $status }). Reload the page.

## files/database

the-storage-does-not-answer = the storage does not answer
another-tab-has-taken-the = another tab has taken the project over
a-later-version-of-this = a later version of this page wrote the project
the-project-is-no-longer = the project is no longer in the storage
the-storage-is-full = the storage of this browser is full, and has no room for this change: delete projects that you no longer need
the-copy-needs-about = the copy needs about { $size }, which the storage of this browser has no room for: delete projects that you no longer need
the-storage-failed = the storage of this browser failed ({ $name })

## files/keeper and files/reading

the-project = The project
another-tab-has-this-project = another tab has this project open: close it there first
a-later-version-of-this-page = a later version of this page wrote it

## panel/about-dialog

version-and-licences = Version and licences
close-2 = Close
matches-and-orients-overlapping-photographs = Matches and orients overlapping photographs, on this computer alone. Licensed under Apache-2.0 or MIT, as you choose.
the-page-holds = The page holds
its-module-holds = Its module holds
so-many-crates =
    { $crates ->
        [one] 1 Rust crate
       *[other] { COUNT($crates) } Rust crates
    }

## panel/actions

so-many-actions =
    { $actions ->
        [one] 1 action
       *[other] { $actions } actions
    }
anywhere = Anywhere
finds-any-action = finds any action
lists-all-keys = lists all keys
action-about = { $about }: { $action }
setting = Setting
find-an-action = Find an action
actions = Actions
all-keys = All keys
what-do-you-want-to = What do you want to do?
tab = tab
no-action-has-these-words = No action has these words.
not-possible-now = not possible now
every-picture = Every picture
keys = Keys

## panel/choice

no-residuals = none
residuals = Residuals

## panel/control

default-4 = default
default = Default
default-2 = { $label }: default
help = Help: { $label }
default-3 = default: { $meant }
a-number = a number
or-empty = , or empty
allowed-the-last-valid-value = Allowed: { $parameter }{ $what }. The last valid value stays in use.
empty = Empty: { $absent }
slider = { $label }, slider

## panel/dom

earlier-settings-2 = earlier settings

## panel/drawers

close-3 = Close: { $text }

## panel/history

anywhere-after-edits = Anywhere, after edits
takes-back-the-last-edit = takes back the last edit
makes-the-edit-again = makes the edit again

## panel/keeping

this-browser-keeps-nothing-of = This browser keeps nothing of the page (a private window, or its storage is blocked): save the project as a file before you leave. { $reason }
the-storage-of-this-browser = The storage of this browser is full: the last changes are not kept. What was kept before is whole. Delete projects that you no longer need, or save this one as a file.
the-storage-is-full-and-is = The storage of this browser is full. { $title } is shown as it was kept last: changes that found no room are not in it, and new ones are not kept. Delete projects that you no longer need, or save this one as a file.
the-last-changes-could-not = The last changes could not be kept: { $reason }. What was kept before is whole. Save the project as a file before you leave.
the-browser-has-closed-its = The browser has closed its storage, and it cannot be opened again: { $reason }. What was kept may be gone. Save the project as a file before you leave.
what-this-browser-had-kept = What this browser had kept was deleted, and { $title } could not be kept again: { $reason }. Save the project as a file before you leave.
is-open-in-another-tab = { $title } is open in another tab. This tab has a project of its own. You can look at what is kept of it, or go on with it here.
is-open-in-another-tab-this = { $title } is open in another tab. This is what that tab has kept so far; what is changed here is not kept.
another-tab-has-taken-over = Another tab has taken { $title } over. What is changed here is no longer kept.
cannot-be-restored-it-stays = { $title } cannot be restored: { $reason }. It stays in the storage as it is.
was-not-opened-the-page = { $title } was not opened: the page broke off the last times that it was. This is a new project.
projects = Projects …
look-at-it = Look at it
take-it-over = Take it over
show-the-latest = Show the latest
reads-again-what-the-other = Reads again what the other tab has kept
goes-on-with-the-project = Goes on with the project in this tab
keep-this-as-a-new = Keep this as a new project
take-it-back = Take it back
shows-the-project-as-the = Shows the project as the other tab has kept it
save-its-files = Save its files
open-it = Open it

## panel/light

brightness = Brightness
contrast = Contrast
brightness-and-contrast = Brightness and contrast
light-changed = { $label }: brightness { $brightness } %, contrast { $contrast } %
light-reset = Reset
light-reset-title = Show the pictures as bright as they are in their files
light-percent = { $percent } %

## panel/numberfield

the-last-valid-value-stays = The last valid value stays in use.
allowed-or-empty = Allowed: { $instead }, or empty. { $stays }
give-both-numbers-or-empty = Give both numbers, or empty both. { $stays }
two-numbers = two numbers
allowed = Allowed: { $instead }. { $stays }

## panel/own

holds-settings = { $name } holds settings: load it under Settings. It is put aside.
the-file-holds-no-settings = the file holds no settings of this page
the-file-holds-settings-of = the file holds settings of a { $subject }, not of a { $of ->
        [pair] pair
       *[block] block
    }
there-is-no-setting = there is no setting { $key }
is-not-allowed = { $label }: { $value } is not allowed

## panel/projects

delete = Delete
so-many-images =
    { $images ->
        [one] 1 image
       *[other] { COUNT($images) } images
    }
the-last-changes-on-the = The last changes on the page could not be kept in this browser. Leave them?
ask-the-browser-never-to = Ask the browser never to clear it
new-project = New project
projects-2 = Projects
this-browser-keeps-each-project = This browser keeps each project as it changes. Nothing leaves this computer.
nothing-is-kept-yet = Nothing is kept yet.
about-are-left = {" "}About { $quota } are left.
the-browser-may-clear-it = {" "}The browser may clear it where room is short.
the-projects-take-about = The projects take about { $own }.{ $left }{ $may }
the-browser-does-not-promise = the browser does not promise it: save what matters as a file
open-this-project = Open this project
on-the-page = {" "}· on the page
rename = Rename
duplicate = Duplicate
copy = { $title } (copy)
save-files = Save files
new-name-of = New name of { $row }
keep = Keep
delete-with-its-images-and = Delete “{ $row }” with its images and results? This cannot be undone.

## panel/releases

update = Update
a-new-version-of-tiepoint = A new version of Tiepoint is ready. The page is loaded again with it; your work is kept.
later = Later
the-last-changes-on-the-page = The last changes on the page could not be kept in this browser: save them as a file first.
update-all-the-same = Update all the same
another-tab-has-updated-tiepoint = Another tab has updated Tiepoint. What is on this page is not kept: save it as a file, then load the page again.
load-again = Load again

## panel/sections

set-all-back = Set all back
fold-all = Fold all
unfold-all = Unfold all
changed = { $here } changed
n-1-setting-differs-from-its = 1 setting differs from its default.
settings-differ-from-their-defaults = { $all } settings differ from their defaults.
load = Load …
settings-of-a-as-a = Settings of a { $of ->
        [pair] pair
       *[block] block
    }, as a file
takes-settings-that-were-saved = Takes settings that were saved; all others have their defaults then
saves-what-differs-from-the = Saves what differs from the defaults, as JSON
settings-as-a-file = Settings as a file
settings-2 = Settings · { $changed }

## panel/table and panel/table-bar

mean = mean
contains = contains
rows-that-contain-this-text = rows that contain this text
rows-within-these-limits-as = rows within these limits, as 2..5, >2 or ≤0.5
is-no-number-or-range = “{ $typed }” is no number or range. Allowed: 2, 2..5, >2 or ≤0.5. The rows stay as they are.
in-2 = {" "}in { $unit }
filter = Filter: { $label }{ $what }
show-all = Show all
takes-away-what-is-typed = Takes away the filters of this table
saves-the-rows-and-columns = Saves the rows and columns that are shown
copy-2 = Copy
copies-the-rows-and-columns = Copies the rows and columns that are shown, for a spreadsheet
columns = Columns ▾
of-8 = { $shown } of{" "}
copied = Copied
not-copied = Not copied

## panel/theme

theme-auto = Theme: auto
theme-light = Theme: light
theme-dark = Theme: dark
theme = Theme
language-of-the-page = Language of the page: English or Arabic
light-dark-or-as-the = Light, dark, or as the system has it

## panel/zoom

zoom-out = Zoom out (−)
zoom-in = Zoom in (+)
fit-0 = Fit: { $whole } (0)

## text/names

principal-point = Principal point
radial-distortion = Radial distortion
tangential-distortion = Tangential distortion
origin-in-the-scan-2 = Origin in the scan

## text/words

this-value-is-not-allowed = { $label }: this value is not allowed. The last valid one stays in use.

## text/project

and-between = {" "}and{" "}
files-cannot-be-opened =
    { $files ->
        [one] { $names } cannot be opened: { $reason }
       *[other] { COUNT($files) } files cannot be opened ({ $names }): { $reason }
    }
comma-between-names = ,{" "}
names-and-more = { $first } and { COUNT($more) } more
without-images = Without images
two-names = { $first } and { $second }
and-more-images = { $first } and { COUNT($images) } more images
kb = { COUNT($bytes) } kB

## view/commands

or = {" "}or{" "}

## view/gestures

moves-the-picture-with-shift = moves the picture; with Shift farther
key-enlarges = enlarges
makes-smaller = makes smaller
shows-the-whole-picture = shows the whole picture

## The page as it is before the program is there. [K] is a key.

tiepoint-image-matching-and-relative = Tiepoint: image matching and relative orientation
to-the-images = To the images
menu = Menu
open-images = Open images …
sample-pair = Sample pair
exchange-the-left-and-the = Exchange the left and the right image
swap = Swap
export-2 = Export ▾
all-that-is-known-of = All that is known of the pair: open it here again
project-2 = Project
matches-csv = Matches CSV
all-json = All JSON
one-html-file-with-pictures = One HTML file with pictures, tables of all strategies, residuals, reliability and parameters
report = Report
both-images-without-distortion-with = Both images without distortion, with what they show in the same rows; an anaglyph; their parameters
epipolar-images = Epipolar images
picture-png = Picture PNG
project-and-page = Project and page
puts-this-project-aside-in = Puts this project aside, in the list of projects, and begins a new one
new = New
projects-that-this-browser-keeps = Projects that this browser keeps: open, rename, duplicate, delete
finds-any-action-ctrl-k = Finds any action (Ctrl+K); ? lists all keys
find = Find …
image-fiducial-camera-or-project = Image, fiducial, camera or project files
progress-of-the-run = Progress of the run
image-pair = image pair
left-and-right-image-with = Left and right image with points and match lines
where-did-each-photo-stand-2 = Where was each photo taken from, and what do both show?
drop-overlapping-photographs-anywhere-on = Drop overlapping photographs anywhere on this page, two or many. You get:
where-the-cameras-stood-to = where the cameras were, relative to each other, and how they were turned
points-that-the-photos-have = points that the photos have in common, and how precise they are
files-for-other-programs-and = files for other programs, and a report
try-a-sample-pair = Try a sample pair
nothing-leaves-this-computer-jpeg = Nothing leaves this computer. JPEG, PNG, TIFF (8 and 16 bit), BMP, PNM, WebP; fiducial marks (CSV), camera data (JSON) and masks (images with “mask” in their name) can be dropped too.
images-are-processed-on-this = Images are processed on this computer; nothing is sent.
keys-hint = Drag or arrows pan · wheel, [+] [−] zoom · [N] [P] points · [?] all keys · [Ctrl] [K] finds any action
finds-tie-points-of-overlapping = Finds tie points of overlapping photographs and orients pairs and blocks of them, in the browser.
images-2 = Images
block = Block
export = Export
pair = Pair
what-is-matched = What is matched
run = Run
view-2 = View
try-a-sample-block = Try a sample block
a-plain-word-on-whether = a plain word on whether the result can be trusted, and why
the-file-of-the-page =
    { $status ->
        [none] a file of the page, { $file }, could not be loaded
       *[other] a file of the page, { $file }, could not be loaded: HTTP { $status }
    }
the-block-was-not-loaded = The part of the page for blocks is not there: { $error } Press again to try once more.
a-part-of-the-page = A part of the page could not be loaded.
try-again = Try again
opening-kept-work = Opening “{ $title }”, which this browser kept …
history-earlier = { $edits ->
    [one] 1 earlier edit …
   *[other] { $edits } earlier edits …
  }
history-later = { $edits ->
    [one] 1 later edit …
   *[other] { $edits } later edits …
  }
