# The texts of the reports of pairs and blocks in English, by name: figures are written before they come here.

report-language = en
    .direction = ltr

## Both reports

report-settings = Parameters
report-default = default
report-default-is = default: { $value }
report-footer = Tiepoint { $version }. The same images and parameters give the same report.
report-separator = {", "}
report-quantity = { $value } { $unit }
report-head = { $name } { $unit }
report-in-unit = { $name }, { $unit }
report-of = { $part } of { $all }
report-residuals = Residuals
report-reliability = Reliability
report-cameras = Cameras
report-truth = truth
report-state = state
report-state-used = used
report-state-check = check
report-state-doubtful = doubtful
report-state-rejected = rejected
report-state-gross-error = gross error
report-state-off = off
report-state-not-measured = not measured
report-state-untested = untested
report-state-not-determined = not determined
report-state-not-placed = not placed
report-redundancy-number = redundancy number r
report-median = median
report-largest-w = The largest standardised residuals w
report-degrees-of-freedom = Degrees of freedom

## Of a pair: its page

report-title = Tiepoint report: { $left }, { $right }
report-images-points-and-matches = Images, points and matches
report-all-strategies = All strategies
report-compared-on = The other strategies are compared on { $left_taken } of { $left } left and { $right_taken } of { $right } right points: a suppression window of { $window } px keeps those that stand out most. Gradients compare every left point with every right one, and all of them would take minutes.
report-interior-orientation = Interior orientation
report-relative-orientation = Relative orientation of this run
report-not-oriented = Not oriented: { $reason }.
report-size = { $name }, { $size } px
report-sizes = Left: { $left }; right: { $right }.
report-mask-of-left = A mask leaves out { $share } of the left image.
report-mask-of-right = A mask leaves out { $share } of the right image.
report-matches-of-points = { $matches } matches of { $points } left points by this run's strategy.
report-edits-of-pair = Edits by hand: { $rejected } matches rejected, { $measured } measured. This run is that of the edited matches; the other strategies match by themselves.
report-took-part = { $used } matches took part, σ₀ { $sigma0 } px; { $rejected } gross errors rejected.
report-right-by-truth = { $share } of the matches are correct, as the known answer of the simulated pair tells.
report-points-and-matches = { $name }: { $points } points, { $matches } matches
report-legend-matched = matched
report-legend-other = other interest point
report-legend-masked = masked out

## Of a pair: its cameras

report-origin = { $origin }: { $camera }
report-camera-given = given
report-focal-by-geometry = not known: a focal length by the geometry of the two views
report-camera-assumed = not known: that of most photographs is assumed
report-focal-length = Focal length
report-principal-point = Principal point { $axis }
report-distortion = Distortion { $term }
report-left = Left
report-right = Right
report-as-known = as it was known
report-estimated = estimated
report-from = From
report-camera-errors = ±: standard errors; a constant without one is taken as free of errors.
report-camera-estimated = Estimated: together with the orientation, from the matches and from what was known.
report-camera-axes = The principal point is counted from the middle of the image, or in the system of the fiducial marks, x to the right and y up. Distortion: terms of Brown's correction in units of the focal length, so that k1 is the share by which it moves a point at 45°.
report-pixel-unknown = The size of a pixel is not known: where other tables have mm, a pixel is taken to be 0.001 mm large.

## Of a pair: the details of its run

report-photo-coordinates = No fiducial marks: photo coordinates follow from the pixel size.
report-no-photo-coordinates = Neither fiducial marks nor a camera with its pixel size is known: there are no photo coordinates.
report-no-marks = no marks
report-affine = affine
report-similarity = similarity
report-interior-by-marks = Interior orientation by fiducial marks
report-photo = Photo
report-left-photo = left
report-right-photo = right
report-marks = Marks
report-transformation = Transformation
report-largest-residual = Largest residual
report-y-parallaxes = Residual y-parallaxes over the left image
report-y-parallaxes-enlarged = Residual y-parallaxes, { $factor } times enlarged; rejected ones in orange
report-y-parallaxes-of = y-parallaxes of the { $matches } matches used; their standard error is { $sigma } px
report-detectable-blunder = minimal detectable bias
report-external = external reliability δ
report-weight = weight
report-reliability-of = Reliability of the matches used (α₀ { $alpha0 }, β₀ { $beta0 })
report-least = minimum
report-largest = maximum
report-reliability-of-pair = r is the share of an error that shows in the residual. A gross error of that size is found with the probability β₀; one that is not found changes no unknown by more than δ of its standard errors.
report-most-unfound = The matches with the largest external reliability
report-match = Match
report-y-parallax = y-parallax
report-sigma-of-coordinate = σ₀ of a photo coordinate
report-sigma-value = { $um } µm = { $px } px
report-matches-used = Matches used
report-base-together = by and bz together, 95 %
report-ellipse-of = ellipse with semi-axes of { $axes } mm
report-condition = Condition
report-plane-misfit = Misfit to a plane
report-parallax-beside = Parallax beside a rotation
report-global-test = Global test
report-global-passed = { $statistic }, expected between { $lower } and { $upper }: passed
report-global-failed = { $statistic }, expected between { $lower } and { $upper }: failed
report-axes = Axes
report-axes-turned = turned by 90°: x points up in the left image
report-warning = Warning
report-sigma-from-parallaxes = σ₀ is computed from y-parallaxes: a wrong match along its epipolar line leaves it unchanged.
report-correlations = Correlations of the unknowns
report-error-ellipse = by, bz: standard error ellipse, semi-axes { $axes } µm
report-ellipse-dashed = ; dashed: 95 %
report-ellipse-cross = ; cross: truth

## Of a pair: the tables of the paper

report-table-1 = Table 1. Points after each phase
report-phase = Phase
report-operator = Operator
report-roundness = Threshold of roundness
report-suppression = Suppression of non-maxima
report-paper = Paper
report-paper-left = Paper, left
report-paper-right = Paper, right
report-matching-by = Matching: { $step }
report-became = What became of the left points
report-rejected-by = Rejected: { $rule }
report-rejected-by-hand = of the matched: rejected by hand
report-measured-by-hand = measured by hand, in their place or beside them
report-matched-gross-errors = of the matched: gross errors
report-against-truth = Matches against the truth
report-right-at-edges = right, at edges too
report-strictly-right = strictly right
report-missed = seen in both, but not matched rightly
report-strictly-right-is = Strictly right: the right point lies within 1.5 px of where the surface at the left pixel is seen. At edges too: or at one of its 8 neighbours, since points lie on edges, where the surface may jump between two pixels.
report-table-2 = Table 2. Standard errors
report-sigma-of-all = σ₀ of all matches
report-used = matches used
report-in-total = in total: with what matches share, and the errors of the camera and of measured fiducial marks
report-half-widths = half-widths of the intervals that hold the unknowns in 95 % of cases
report-sigma-of-all-is = σ₀ of all matches: least squares from the vertical pair without rejection of gross errors and without robust weights. It is absent where that does not converge, and where cameras were estimated.
report-table-3 = Table 3. Relative orientation by each strategy
report-unknown = Unknown
report-paper-by = Paper: { $way }
report-paper-correlation = correlation
report-paper-least-squares = least squares
report-paper-moments = proposed (moments)
report-verdict = verdict
report-fixed = { $unit }, fixed
report-true-errors = true errors, and how many of its standard errors each is
report-other-base = by and bz of the truth belong to its base of { $base } mm. Where a strategy was oriented with another base, its true errors are those against the truth at the scale of that base.
report-paper-columns = The paper's columns by correlation and by least squares come from 15 points that earlier work measured on scans of 600 dpi: they have errors of their own.

## Of a pair: what sets it apart from the paper

report-differs = Where this differs from the paper, and why
report-pair = The pair. The photographs of the paper are not published.
report-pair-simulated = This pair is simulated: a synthetic scene seen by a camera of known position. Its texture and contrast are not those of the paper's scene, and with them the counts of Table 1 differ; the paper does not give its base, for which 60 % overlap is taken.
report-pair-other = This is another pair: every figure depends on its scene, its scale and its scan; only their kind can be compared.
report-denominator-larger = the larger magnitude is the denominator
report-denominator-median = the larger magnitude, or the median magnitude of the moment where that is more, is the denominator
report-ambiguous-many-parallax = ambiguous, many to one, or off the y-parallax of their neighbours
report-ambiguous-many = ambiguous or many to one
report-many-parallax = many to one, or off the y-parallax of their neighbours
report-many = many to one
report-matches-differ = Matches. The paper accepts the smallest measure below 3 in the search window. As printed, its measure has a denominator that can vanish, and a best candidate of many is below 3 nearly always. Here { $denominator }, and matches are rejected that are { $inconsistent }: { $matches } of { $points } left points ({ $share }) are matched; in the paper { $paper_matches } of { $paper_points } ({ $paper_share }).
report-sigma-of-paper = Table 2. The paper's σ₀ of 0.150 mm is 0.6 px; by moments
report-sigma-here = it is { $sigma0 } px here, after robust estimation and data snooping
report-pair-not-oriented = this pair is not oriented
report-sigma-of-all-here = , and { $sigma0 } px of all matches without either
report-errors-grow = Standard errors grow with σ₀ and fall with the root of the number of matches. With the paper's σ₀ and number of matches, the geometry of this pair gives
report-beside-printed = { $value } (printed { $printed })
report-printed-times = The printed ones are { $least } to { $most } times these: σ₀ and number do not explain that, and the paper gives neither its base nor where its points lie.
report-orientations-differ = Table 3. The paper's three columns were made from one pair, and differ by up to 0.127° in κ and 0.354 mm in by: 6.3 and 2.6 of the standard errors that its Table 2 states. Standard errors from residuals along y-parallaxes do not show blunders that were adjusted with the rest, nor errors of the interior orientation, which all points of a photo share.
report-largest-true-error = Here the same strategies stand beside the truth: the largest true error is { $times } of its standard errors ({ $unknown }, { $step }).

## Of a block: its head

report-block-title = Tiepoint report: block of { $images } images
report-plan = Projection centres and connections
report-images = Images
report-oriented-of = { $oriented } oriented of { $read } read
report-not-read = ; { $images } could not be read
report-with-masks = ; { $images } with masks
report-pairs = Pairs
report-connected-of = { $connected } connected of { $tried } tried
report-points-found = Tie points found
report-points-written = Tie points written
report-with-observations = { $points } with { $observations } observations
report-coordinate-system = Coordinate system of the tables
report-axes-of-report = Axes of this report
report-axes-local = X east, Y north, Z up in the middle of the block, in m
report-edits-of-block = Edits by hand
report-models = The block fell apart into { $models } models, of { $images } images. This report is of the first.
report-georeferenced-by = Georeferenced by
report-datum-none = nothing: position, rotation and scale mean nothing
report-datum-control = ground control points
report-datum-gnss-and-control = GNSS positions and ground control points
report-datum-gnss = GNSS positions
report-rmse-of-observations = RMSE of observations
report-observations-rejected = Observations rejected
report-rmse-of-gnss = RMSE of GNSS positions
report-in-xyz = { $x }, { $y }, { $z } m in X, Y, Z
report-rmse-of-checks = RMSE of { $points } check points
report-checks = { $x }, { $y }, { $z } m in X, Y, Z (plan { $plan } m), mean { $mean_x }, { $mean_y }, { $mean_z } m
report-along-axes = , along the axes of { $crs }
report-ratio-of-checks = ; { $ratio } of their standard errors
report-block-against-truth = Against the truth
report-right-points = { $right } of { $points } points are right
report-truth-positions = ; after a similarity that brings it onto the truth, RMSE of positions { $x }, { $y }, { $z } m
report-truth-angles = , of angles { $angle }°
report-warnings = Warnings
report-remarks = Remarks on what was given
report-more-in-summary = { $number } more are in summary.json.

## Of a block: its plan

report-plan-of = Plan of { $centres } projection centres
report-ellipses-95 = Ellipses that hold the projection centres in 95 % of cases, { $grown } times the standard error ellipses, at { $factor } times the scale of the plan
report-ellipses-standard = Standard error ellipses, at { $factor } times the scale of the plan
report-one-of = ; one of { $step } is drawn
report-no-standard-errors = There are no standard errors.
report-triangles = Triangles: ground control points (green) and check points (blue).
report-plane-of-images = The block has no system: the plane is the one that its images look at.
report-no-links = No two images have points in common.
report-links = Lines join images with points in common: up to { $bounds } of them, the wider the more.
report-strongest-links = Of { $links } lines the { $drawn } strongest are drawn.
report-scale-of-plan = plan: { $length } { $unit }
report-scale-of-ellipses = ellipses: { $length } { $unit }
report-model-units = model units

## Of a block: its precision

report-precision = Precision
report-minimum = minimum
report-maximum = maximum
report-point-coordinate = points, { $axis }
report-projection-centres = projection centres
report-points = points
report-longest-semi-axes = Longest semi-axes of the 95 % ellipsoids
report-inner-constraints = With respect to the inner constraints of a free network.
report-standard-errors = Standard errors of projection centres, angles and points
report-and-95 = , ± 95 %
report-fewest-observations = The images with the fewest observations
report-and-errors-95 = ; standard errors ± 95 %
report-image = Image
report-observations = observations
report-von-gruber = von Gruber positions
report-of-nine = { $positions } of 9
report-ellipsoid-95 = 95 % ellipsoid
report-longest-ellipsoids = The points with the longest 95 % ellipsoids; standard errors ± 95 %
report-point = Point
report-points-numbered = Points have the numbers of points.csv, ground control and check points with their names.
report-semi-axes = Ellipsoid: its semi-axes, the longest first.
report-images-not-oriented = Images that are not oriented
report-images-not-read = Images that could not be read
report-reason = Reason
report-interval-95 = ±: half-width of the interval that holds the truth in 95 % of cases, { $interval } standard errors (Student's distribution of the degrees of freedom; the normal distribution where σ₀ was given).
report-ellipses-and-ellipsoids = Ellipses and ellipsoids hold two or three coordinates together in 95 % of cases: they are { $ellipse } and { $ellipsoid } times the standard ones (F distribution).

## Of a block: its cameras

report-more-cameras = { $number } more cameras are in summary.json.
report-camera = Camera { $number }: { $label }, { $images } images of { $size } px
report-given = given
report-calibrated = calibrated
report-standard-error = standard error
report-parameter-correlations = Correlations of the estimated parameters
report-not-determined-by = not determined: one standard error would move an observation by { $effect } px
report-not-determined = not determined
report-not-estimated = not estimated
report-few-residuals = Too few residuals for a residual field.
report-mean-residuals = Mean residuals over the image, { $observations } observations: RMS { $rms } px, by chance alone { $chance } px
report-enlarged = ; { $factor } times enlarged

## Of a block: its observations

report-residuals-of = Residuals of { $observations } accepted observations, columns and rows; σ₀ is { $sigma0 } px
report-by-rays = By the number of rays of their points
report-rays = Rays
report-detectable-error = detectable error
report-influence = influence
report-moves-its-point = undetected, it moves its point by
report-no-statistics = There are no statistics.
report-accepted-observations = Columns and rows of all accepted observations
report-reliability-of-block = r is the share of an error that shows in the residual. An error of the detectable size is found with a probability of 0.80. Undetected, it moves no unknown by more than the influence, in standard errors.
report-unchecked = Observations with a coordinate that nothing checks: { $observations }.
report-largest-detectable = The largest detectable errors
report-largest-influences = The largest influences
report-did-not-fit = it did not fit its point while the block grew
report-lay-behind = its point lay behind the image while the block grew
report-by-hand = it was rejected by hand
report-snooped = data snooping found a gross error
report-lies-behind = its point lies behind the image
report-lost-point = its point has fewer than two rays left, or rays that do not meet
report-rejected-observations = Rejected observations
report-rejected-of = { $rejected } of { $observations } observations ({ $share }) were rejected.
report-gross-errors = Gross errors with the largest standardised residuals w
report-observed-point = point
report-moves-by = moves its point by

## Of a block: positions of images, control points and check points

report-gnss = GNSS positions
report-all-took-part = { $part } of { $all } took part.
report-part-took-part = { $part } of { $all } took part; the others lie too far from where the images have them.
report-part-took-part-in-strips = { $part } of { $all } took part; the others lie too far from where the images have them, or are in no strip.
report-gnss-that-took-part = GNSS positions that took part
report-absolute-residual = |residual| { $axis }
report-redundancy-of = redundancy number r { $axis }
report-detectable-error-of = detectable error { $axis }
report-moves-of = undetected, it moves { $axis } by
report-influence-of = influence of { $axis }
report-all-gnss = All GNSS positions, the largest standardised residuals w first
report-gnss-residuals = Residual: observed minus adjusted. r is the share of an error that shows in the residual; a detectable error is found with a probability of 0.80. Undetected, it moves the adjusted coordinate by "moves", and no unknown by more than "influence", in standard errors.
report-control = Ground control points
report-image-measurements = image measurements
report-residual-of = residual { $axis }
report-moves = moves { $axis }
report-control-residuals = Residual: surveyed minus adjusted; w is that of a new observation where a point was rejected, since the other observations contradict it. A point that is doubtful contradicts them, too, and is used since too few are left to tell which is wrong.
report-control-as-gnss = r, ∇, moves and influence as for GNSS positions: what an undetected error of the size ∇ moves the point by, and the most that it moves any unknown by, in standard errors. Points beyond { $most } are in surveyed.csv.
report-control-axes = Residuals of points that are used count along the axes of the adjustment, those of refused points, and all differences, along those of { $crs }.
report-left-out = The same points without themselves
report-left-out-is = Where all other observations have each of these points, minus surveyed: what it is worth as a check point.
report-check-points = Check points
report-check-differences = Differences: adjusted minus surveyed. They took no part in the adjustment.
report-check-differences-along = Differences: adjusted minus surveyed, along the axes of { $crs }. They took no part in the adjustment.
report-without-figures = Control and check points without figures
report-use = use
report-use-control = control
report-use-check = check
report-use-off = off
report-states-explained = Not measured: no image measurement names the point. Untested, not determined: fewer than two image measurements of the point fit the block; a control point takes no part then. Not placed: no control points place the block. Rejected: a place of the orthophoto that contradicts the others.
report-points-beyond = Points beyond { $most } are in surveyed.csv.
report-stated-errors = Stated standard errors
report-group = Observations
report-coordinates = coordinates
report-redundancy = redundancy
report-by-residuals = by residuals / stated
report-interval = 95 % interval
report-weights-by = weights by
report-by-their-residuals = residuals
report-by-stated-held = stated standard errors (held)
report-by-stated = stated standard errors
report-components-explained = Variance components: standard errors by the residuals beside stated standard errors. A factor that the redundancy does not determine is held at 1.
report-weights-follow = Weights follow the residuals where 1 lies outside the interval, and go on doing so.
report-weights-stated = Weights are those of the stated standard errors.
report-rounds = Rounds of weighting: { $rounds }.
report-weights-did-not-converge = The weights did not converge.
report-systematic = Systematic errors of GNSS positions
report-error = Error
report-test = test
report-limit = limit
report-strip = Strip { $number }: { $images } images from { $first } to { $last }.
report-systematic-explained = Observed position = projection centre + error. A lever arm is in the axes of the camera (x right, y up, z against the direction of view); a drift is what the error grows by from the first image of a strip to the last. Test: the mean square in standard errors, above the limit not by chance.
report-few-control = There are too few ground control points: what the errors would move, turn or scale the block by as a whole is none of theirs.
report-measurements = Image measurements of these points
report-measurements-took-part = { $part } of { $all } took part; RMSE { $rmse } px.
report-largest-residuals = The largest residuals
report-moves-point-by = moves the point by
