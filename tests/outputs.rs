//! What a finished block writes and shows, before it is saved and after it is opened again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::sync::OnceLock;
use tiepoint::{
    BlockEdit, BlockFlight, BlockOverview, BlockRun, BlockScene, BlockSettings, BlockVerdict, BlockWarning, ExportFormat, HandMeasurement,
    ImagePlace, MeasuredBy, MultiscaleOptions, ObservationDetail, ObservationPart, OverviewWarning, PointColumns, PointDetail, PointImage,
    PointSource, Project, RefinementMethod, RunInput, UnorientedReason, accuracy_map, block_covariances, block_epipolar_line, block_files,
    covariance_table, coverage, image_points, images_in, meeting_place, planned_files, point_detail, point_ids, read_project, run_block,
    write_block_project,
};

/// A small simulated block, one image of which has nothing in common with the others.
fn finished() -> &'static BlockRun {
    static RUN: OnceLock<BlockRun> = OnceLock::new();
    RUN.get_or_init(|| {
        let at = std::env::temp_dir().join(format!("tiepoint-outputs-{}", std::process::id()));
        fs::create_dir_all(&at).unwrap();
        let flight =
            |seed| BlockFlight { strips: 1, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.12, seed, ..BlockFlight::default() };
        for (seed, names) in [(1, ["a.pgm", "b.pgm", "c.pgm"].as_slice()), (9, &["=other, \"d\".pgm"])] {
            let scene = BlockScene::new(&flight(seed)).unwrap();
            for (index, name) in names.iter().enumerate() {
                let photo = scene.photo(index).unwrap();
                let bytes = [format!("P5 {} {} 255\n", photo.width(), photo.height()).as_bytes(), photo.data()].concat();
                fs::write(at.join(name), bytes).unwrap();
            }
        }
        fs::write(at.join("broken.pgm"), b"P5 9").unwrap();
        let mut settings = BlockSettings::default();
        settings.features.multiscale = MultiscaleOptions { number: 1000, ..settings.features.multiscale };
        settings.refinement.method = RefinementMethod::LeastSquares;
        let input = RunInput { settings, cameras: Some(r#"{"cameras": [{"focal_px": 708.33}]}"#.into()), ..RunInput::default() };
        let run = run_block(&images_in(&at).unwrap(), &[], input, &at.join("work"), 2, |_| {}).unwrap();
        fs::remove_dir_all(at).unwrap();
        run
    })
}

fn files(run: &BlockRun) -> BTreeMap<String, String> {
    let mut files = BTreeMap::new();
    let mut emit = |path: &str, text: &str| {
        assert!(files.insert(path.to_string(), text.to_string()).is_none(), "{path} is written twice");
        Ok(())
    };
    // A name with blanks is none for COLMAP.
    let summary = block_files(run, &[ExportFormat::Colmap, ExportFormat::Csv, ExportFormat::Json], None, &mut emit).unwrap();
    let has_blanks = run.images.iter().any(|image| image.name.contains(' '));
    assert_eq!(summary.exports.iter().map(|export| export.refused.is_some()).collect::<Vec<_>>(), [has_blanks, false, false]);
    files
}

fn opened(text: &str) -> BlockRun {
    match read_project(text.as_bytes()).unwrap() {
        Project::Block(run) => *run,
        Project::Pair(_) => unreachable!("a block was written"),
    }
}

#[test]
fn a_block_that_was_saved_is_shown_as_before() {
    let older = [include_str!("project/version-1.tiepoint"), include_str!("project/version-2.tiepoint")].map(opened);
    for run in older.iter().chain([finished()]) {
        let text = write_block_project(run).unwrap();
        let again = opened(&text);
        assert_eq!(again, *run);
        assert_eq!(write_block_project(&again).unwrap(), text);
        assert_eq!(BlockOverview::new(&again).unwrap(), BlockOverview::new(run).unwrap());
        // Numbers that are none are unequal to themselves.
        assert_eq!(format!("{:?}", PointColumns::new(&again)), format!("{:?}", PointColumns::new(run)));
        assert_eq!(files(&again), files(run));
    }
}

#[test]
fn a_block_that_an_earlier_release_saved_shows_what_that_release_printed_and_is_edited() {
    let run = opened(include_str!("project/version-2.tiepoint"));
    let adjusted = &run.reconstruction.as_ref().unwrap().models[0].adjusted;
    assert_eq!(adjusted.sigma0_px, Some(0.08684089863409522));
    let files = files(&run);
    assert_eq!(["points.csv", "rays.csv"].map(|name| files[name].lines().count() - 1), [58, 130]);
    assert_eq!(BlockOverview::new(&run).unwrap().skipped.len(), 3);
    let edited = run.with_edits(&[BlockEdit::RejectImages { images: vec![2] }]).unwrap();
    assert_eq!(BlockOverview::new(&edited).unwrap().oriented, 2);
    assert_eq!(edited.with_edits(&[]).unwrap(), run);
}

#[test]
fn all_files_give_the_same_numbers_of_points_and_observations() {
    let run = finished();
    let files = files(run);
    let rows = |name: &str| files[name].lines().count() - 1;
    let overview = BlockOverview::new(run).unwrap();
    let observations: usize = overview.images.iter().map(|image| image.observations).sum();
    assert_eq!((rows("images.csv"), rows("points.csv"), rows("rays.csv")), (4, PointColumns::new(run).rays.len(), observations));
    assert_eq!(rows("pairs.csv"), 6);
    assert_eq!(coverage(&run.model).iter().map(|image| image.observations).sum::<usize>(), observations);
    assert_eq!((overview.oriented, overview.skipped.len()), (3, 1));
    assert!(overview.by_rays.iter().map(|group| group.points).sum::<usize>() >= rows("points.csv"));
    assert!(
        overview.images[0].reason.as_ref().unwrap().text == "it has no tie points" && overview.images[1].reason.is_none(),
        "{:?}",
        overview.images[0]
    );
    // Spreadsheets take the name for a text.
    assert!(files["images.csv"].contains("\n0,\"'=other, \"\"d\"\".pgm\",0,480,360,"), "{}", files["images.csv"]);
    let refined = files["rays.csv"].lines().filter(|line| line.contains(",refined,0.")).count();
    assert!(2 * refined > rows("points.csv"), "{refined}");
}

/// The cells of a column of a table whose texts have no line breaks and no commas in that column's way: counted from the end of each line.
fn cells(table: &str, column: &str) -> Vec<String> {
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let from_end = names.iter().rev().position(|name| *name == column).unwrap();
    table.lines().skip(1).map(|line| line.rsplit(',').nth(from_end).unwrap().to_string()).collect()
}

#[test]
fn tables_have_the_standard_errors_of_the_adjustment() {
    let run = finished();
    let files = files(run);
    let adjusted = &run.reconstruction.as_ref().unwrap().models[0].adjusted;
    let written = |value: f64| value.to_string();
    for (k, [at, turn]) in [["sigma_x", "sigma_omega_deg"], ["sigma_y", "sigma_phi_deg"], ["sigma_z", "sigma_kappa_deg"]].iter().enumerate()
    {
        // The first image is not oriented.
        let positions = adjusted.images.iter().map(|image| written(image.position_errors.unwrap()[k]));
        assert_eq!(cells(&files["images.csv"], at), [String::new()].into_iter().chain(positions).collect::<Vec<_>>());
        let angles = adjusted.images.iter().map(|image| written(image.angle_errors_deg.unwrap()[k]));
        assert_eq!(cells(&files["images.csv"], turn), [String::new()].into_iter().chain(angles).collect::<Vec<_>>());
        let points: Vec<String> = adjusted.points.iter().flatten().map(|point| written(point.errors.unwrap()[k])).collect();
        assert_eq!(cells(&files["points.csv"], at), points);
    }
}

#[test]
fn the_files_are_known_before_the_run() {
    let run = finished();
    let names: Vec<String> = run.images.iter().map(|image| image.name.clone()).collect();
    let planned = planned_files(&names, &[ExportFormat::Csv, ExportFormat::Json]).unwrap();
    for path in files(run).keys().filter(|path| !path.starts_with("colmap/")) {
        assert!(planned.contains(path), "{path}: {planned:?}");
    }
}

#[test]
fn points_and_images_tell_the_same_observations() {
    let run = finished();
    let ids = point_ids(run);
    assert_eq!(ids.len(), run.model.points.len());
    let of_images: Vec<_> = (0..run.images.len()).map(|image| image_points(run, image).unwrap()).collect();
    let mut accepted = 0;
    for (index, known) in run.model.points.iter().enumerate() {
        let detail = point_detail(run, index).unwrap();
        assert_eq!((detail.id, detail.position), (Some(ids[index]), known.position));
        let errors = detail.errors.unwrap();
        assert!(errors.iter().all(|error| *error > 0.0 && error.is_finite()), "{errors:?}");
        let taking_part: Vec<_> = detail.observations.iter().filter(|seen| seen.part == ObservationPart::Accepted).collect();
        assert_eq!(taking_part.len(), known.rays.len());
        accepted += taking_part.len();
        let squares = taking_part.iter().flat_map(|seen| seen.residual_px.unwrap()).map(|v| v * v).sum::<f64>();
        assert!(((squares / taking_part.len() as f64).sqrt() - known.rmse_px.unwrap()).abs() < 1e-9);
        for seen in &detail.observations {
            let of_image = of_images[seen.image].iter().find(|other| other.point == index).unwrap();
            assert_eq!((of_image.place_px, of_image.part), ([seen.x_px, seen.y_px], seen.part));
            assert_eq!((of_image.redundancy, of_image.w, of_image.detectable_px), (seen.redundancy, seen.w, seen.detectable_px));
            let [x, y] = seen.predicted_px.unwrap();
            let [dx, dy] = seen.residual_px.unwrap();
            assert!((seen.x_px - x - dx).abs() < 1e-6 && (seen.y_px - y - dy).abs() < 1e-6);
        }
        for place in &detail.elsewhere {
            assert!(run.model.images[place.image].pose.is_some() && detail.observations.iter().all(|seen| seen.image != place.image));
            assert!((0.0..=480.0).contains(&place.x_px) && (0.0..=360.0).contains(&place.y_px));
        }
    }
    let of_images: usize = of_images.iter().flatten().filter(|seen| seen.part == ObservationPart::Accepted).count();
    assert!(accepted > 50 && of_images == accepted, "{accepted} {of_images}");
    assert!(point_detail(run, ids.len()).unwrap_err().to_string().contains("point"));
    assert!(image_points(run, 99).unwrap_err().to_string().contains("image"));
}

#[test]
fn what_images_say_of_the_reliability_of_their_observations_is_what_the_file_of_the_adjustment_has() {
    let run = finished();
    let file: serde_json::Value = serde_json::from_str(&files(run)["orientation.json"]).unwrap();
    let model = &file["models"][0];
    let numbers = |value: &serde_json::Value| [0, 1].map(|k| value[k].as_f64());
    let (mut told, mut checked) = (0, 0);
    for (image, known) in model["images"].as_array().unwrap().iter().enumerate() {
        let own = image_points(run, known.as_u64().unwrap() as usize).unwrap();
        for (ray, said) in model["adjusted"]["block"]["rays"].as_array().unwrap().iter().zip(model["adjusted"]["rays"].as_array().unwrap())
        {
            if ray["image"] != image {
                continue;
            }
            let at = ["x_px", "y_px"].map(|axis| ray[axis].as_f64().unwrap());
            // A point that has no observation left is not written.
            let Some(seen) = own.iter().find(|seen| seen.place_px == at) else { continue };
            told += 1;
            assert_eq!(seen.redundancy.unwrap().map(Some), numbers(&said["redundancy"]));
            assert_eq!(seen.w.unwrap().map(Some), numbers(&said["w"]));
            assert_eq!(seen.detectable_px, numbers(&said["detectable_px"]));
            let [r, _] = seen.redundancy.unwrap();
            checked += usize::from(seen.part == ObservationPart::Accepted && r > 0.0 && r < 1.0 && seen.detectable_px[0].unwrap() > 0.0);
        }
    }
    assert!(told > 100 && checked > 50, "{told} {checked}");
}

#[test]
fn the_epipolar_line_of_an_observation_passes_by_the_others_of_its_point() {
    let run = finished();
    let mut tried = 0;
    for index in 0..run.model.points.len() {
        let seen = point_detail(run, index).unwrap().observations;
        let [a, b, ..] = &seen[..] else { continue };
        if [a, b].iter().any(|seen| seen.part != ObservationPart::Accepted) {
            continue;
        }
        let line = block_epipolar_line(run, a.image, [a.x_px, a.y_px], b.image).unwrap();
        let steps = line.windows(2).map(|ends| distance([b.x_px, b.y_px], ends[0], ends[1]));
        let least = steps.fold(f64::INFINITY, f64::min);
        assert!(least < 3.0, "point {index}: {least} px");
        tried += 1;
    }
    assert!(tried > 20, "{tried}");
    // The first image is not oriented.
    assert_eq!(block_epipolar_line(run, 3, [10.0, 10.0], 0).unwrap(), Vec::<[f64; 2]>::new());
    assert_eq!(block_epipolar_line(run, 0, [10.0, 10.0], 3).unwrap(), Vec::<[f64; 2]>::new());
}

#[test]
fn measurements_of_a_point_meet_near_it() {
    let run = finished();
    let measurements = |seen: &[ObservationDetail]| -> Vec<HandMeasurement> {
        seen.iter().map(|seen| HandMeasurement { image: seen.image, x_px: seen.x_px, y_px: seen.y_px, by: MeasuredBy::Hand }).collect()
    };
    let adjusted = (0..run.model.points.len()).map(|index| point_detail(run, index).unwrap());
    let known = adjusted.filter(|point| point.observations.iter().all(|seen| seen.part == ObservationPart::Accepted));
    let mut tried = 0;
    for PointDetail { position, errors, observations, .. } in known {
        let (Some(position), Some(errors)) = (position, errors) else { continue };
        let place = meeting_place(run, &measurements(&observations)).unwrap().unwrap();
        let off = (0..3).map(|axis| (place[axis] - position[axis]).abs() / errors[axis]).fold(0.0, f64::max);
        assert!(off < 1.0, "{off} standard errors");
        tried += 1;
    }
    assert!(tried > 50, "{tried}");
    let [first, ..] = &measurements(&point_detail(run, 0).unwrap().observations)[..] else { unreachable!("a point is seen") };
    assert_eq!(meeting_place(run, &[*first]).unwrap(), None);
    // The first image is not oriented.
    assert_eq!(meeting_place(run, &[*first, HandMeasurement { image: 0, ..*first }]).unwrap(), None);
    let refused = meeting_place(run, &[HandMeasurement { image: 9, ..*first }]).unwrap_err().to_string();
    assert!(refused.contains('9') && refused.contains('4'), "{refused}");
}

/// From a place to a piece of a line.
fn distance(at: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let along = (((at[0] - from[0]) * dx + (at[1] - from[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (at[0] - from[0] - along * dx).hypot(at[1] - from[1] - along * dy)
}

/// An observation that takes part, of a point of three rays.
fn an_observation(run: &BlockRun) -> (usize, PointSource, ObservationDetail) {
    let of = |index| point_detail(run, index).unwrap();
    let is_of_three = |index: &usize| of(*index).observations.iter().filter(|seen| seen.part == ObservationPart::Accepted).count() == 3;
    let index = (0..run.model.points.len()).find(is_of_three).unwrap();
    (index, point_ids(run)[index], of(index).observations[1].clone())
}

/// The detail of a point by what it is.
fn detail_of(run: &BlockRun, point: PointSource) -> tiepoint::PointDetail {
    point_detail(run, point_ids(run).iter().position(|id| *id == point).unwrap()).unwrap()
}

fn measure(point: PointSource, image: usize, [x_px, y_px]: [f64; 2]) -> BlockEdit {
    BlockEdit::Measure { point, image, x_px, y_px, by: MeasuredBy::Hand }
}

#[test]
fn the_support_of_a_block_repeats_its_adjustment() {
    let run = finished();
    let (_, point, _) = an_observation(run);
    let model = |run: &BlockRun| run.reconstruction.as_ref().unwrap().models[0].clone();
    assert!(!model(run).supporting.is_empty());
    let again = run.with_edits(&[BlockEdit::RestorePoints { points: vec![point] }]).unwrap();
    let (before, after) = (model(run), model(&again));
    assert!((before.adjusted.sigma0_px.unwrap() - after.adjusted.sigma0_px.unwrap()).abs() < 1e-6);
    for (a, b) in before.adjusted.block.images.iter().zip(&after.adjusted.block.images) {
        let moved = [0, 1, 2].map(|k| (a.pose.position[k] - b.pose.position[k]).abs());
        let errors = before.adjusted.images[0].position_errors.unwrap();
        assert!((0..3).all(|k| moved[k] < 1e-3 * errors[k]), "{moved:?} of {errors:?}");
    }
    assert_eq!((before.points, before.supporting.len()), (after.points, after.supporting.len()));
}

#[test]
fn covariances_of_an_opened_block_are_those_of_its_standard_errors() {
    let run = &opened(&write_block_project(finished()).unwrap());
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    let names = ["c.pgm".into(), format!("point:{}", run.model.point_numbers()[1]), "a.pgm".into()];
    let found = block_covariances(run, &names).unwrap();
    let statistics = |image: usize| &model.adjusted.images[image];
    let of_image = |image: usize| [statistics(image).angle_errors_deg.unwrap(), statistics(image).position_errors.unwrap()].concat();
    let of_point = model.adjusted.points.iter().flatten().nth(1).unwrap().errors.unwrap();
    let printed = [of_image(2), of_point.to_vec(), of_image(0)].concat();
    assert_eq!(found.unknowns.len(), printed.len());
    for (k, (one, printed)) in found.unknowns.iter().zip(&printed).enumerate() {
        assert!((found.rows[k][k].sqrt() / printed - 1.0).abs() < 1e-5, "{one:?}: {} for {printed}", found.rows[k][k].sqrt());
        assert!((0..k).all(|other| found.rows[k][other] == found.rows[other][k] && found.rows[k][other] != 0.0), "{one:?}");
    }
    assert_eq!((&found.unknowns[1].name[..], found.unknowns[1].unit, found.unknowns[8].unit), ("phi", "deg", "unit"));
    let text = covariance_table(&found);
    assert!(text.starts_with("of,unknown,unit,value,standard_error,c.pgm omega [deg],"), "{text}");
    assert_eq!(text.lines().count(), 1 + printed.len());
    // All of the block: the same figures, each once.
    let all = block_covariances(run, &["all".to_string()]).unwrap();
    let points = model.adjusted.points.iter().flatten().count();
    let parameters = model.adjusted.cameras.iter().flat_map(|camera| camera.standard_errors).flatten().count();
    assert_eq!(all.unknowns.len(), 6 * model.images.len() + parameters + 3 * points);
    let at = |of: &str, name: &str| all.unknowns.iter().position(|one| one.of == of && one.name == name).unwrap();
    let (of_point, of_image) = (at(&names[1], "z"), at("a.pgm", "x"));
    assert!((all.rows[of_point][of_image] / found.rows[8][12] - 1.0).abs() < 1e-6, "{:?}", found.unknowns);
    for wrong in [&["all", "a.pgm"][..], &["z.pgm"], &["point:99999"], &["broken.pgm"], &["a.pgm", "a.pgm"], &[]] {
        let names: Vec<String> = wrong.iter().map(ToString::to_string).collect();
        assert_eq!(block_covariances(run, &names).unwrap_err().code(), "invalid-input", "{wrong:?}");
    }
}

#[test]
fn what_is_expected_of_a_point_is_what_the_adjustment_says_of_tie_points_there() {
    let run = finished();
    let map = accuracy_map(run, None, None).unwrap();
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    // Of tie points that all images see: a new point at their place has as many observations.
    let mut ratios = Vec::new();
    for (point, statistics) in model.adjusted.block.points.iter().zip(&model.adjusted.points) {
        let Some((statistics, errors)) = statistics.as_ref().and_then(|statistics| Some((statistics, statistics.errors?))) else {
            continue;
        };
        let [column, row] = map.georeference.pixel([point[0], point[1]]);
        if column < 0.0 || row < 0.0 || column >= map.width as f64 || row >= map.height as f64 {
            continue;
        }
        let cell = map.cells[row as usize * map.width + column as usize];
        if cell.images == statistics.rays && cell.plan.is_finite() {
            ratios.push([errors[0].hypot(errors[1]) / cell.plan, errors[2] / cell.height]);
        }
    }
    assert!(ratios.len() > 20, "{}", ratios.len());
    for axis in 0..2 {
        let mut own: Vec<f64> = ratios.iter().map(|ratio| ratio[axis]).collect();
        own.sort_by(f64::total_cmp);
        let middle = own[own.len() / 2];
        assert!((0.8..1.2).contains(&middle), "{axis}: {middle}");
    }
    let summary = map.summary();
    assert!(summary.cells > 100 && summary.plan[0] > 0.0 && summary.plan[0] <= summary.plan[1] && summary.height[0] > summary.plan[0]);
    // Observations of half the standard error leave the orientations' own.
    let finer = accuracy_map(run, None, Some(0.5 * map.sigma_px)).unwrap().summary();
    assert!(finer.plan[0] < summary.plan[0] && finer.plan[0] > 0.5 * summary.plan[0], "{finer:?}");
    assert_eq!(map.table().lines().count(), 1 + map.cells.iter().filter(|cell| cell.images > 0).count());
    for (cell, sigma) in [(Some(0.0), None), (Some(1e9), None), (None, Some(0.0)), (None, Some(f64::NAN))] {
        assert_eq!(accuracy_map(run, cell, sigma).unwrap_err().code(), "invalid-input", "{cell:?} {sigma:?}");
    }
}

#[test]
fn a_rejected_observation_takes_no_part_until_it_is_restored() {
    let run = finished();
    let (_, point, seen) = an_observation(run);
    let observations = vec![PointImage { point, image: seen.image }];
    let rejected = run.with_edits(&[BlockEdit::RejectObservations { observations: observations.clone() }]).unwrap();
    let part = |run: &BlockRun| detail_of(run, point).observations.iter().find(|o| o.image == seen.image).unwrap().part;
    assert_eq!((part(run), part(&rejected)), (ObservationPart::Accepted, ObservationPart::RejectedByHand));
    let count = |run: &BlockRun| run.model.points.iter().map(|point| point.rays.len()).sum::<usize>();
    assert_eq!(count(&rejected) + 1, count(run));
    let both = [BlockEdit::RejectObservations { observations: observations.clone() }, BlockEdit::RestoreObservations { observations }];
    let restored = run.with_edits(&both).unwrap();
    assert_eq!(part(&restored), ObservationPart::Accepted);
    let untouched = run.with_edits(&[BlockEdit::RestorePoints { points: vec![point] }]).unwrap();
    assert_eq!(restored.model, untouched.model);
}

#[test]
fn an_observation_that_is_moved_far_off_is_found_by_its_test() {
    let run = finished();
    let (_, point, seen) = an_observation(run);
    let to = [seen.x_px + 25.0, seen.y_px - 20.0];
    let moved = run.with_edits(&[measure(point, seen.image, to)]).unwrap();
    let now = detail_of(&moved, point).observations.into_iter().find(|o| o.image == seen.image).unwrap();
    assert_eq!(([now.x_px, now.y_px], now.by_hand, now.part), (to, true, ObservationPart::GrossError));
    let back = run.with_edits(&[measure(point, seen.image, to), measure(point, seen.image, [seen.x_px, seen.y_px])]).unwrap();
    let now = detail_of(&back, point).observations.into_iter().find(|o| o.image == seen.image).unwrap();
    assert_eq!((now.by_hand, now.part), (true, ObservationPart::Accepted));
}

#[test]
fn observations_that_a_rejected_image_leaves_alone_are_no_gross_errors() {
    let run = finished();
    let image = run.images.iter().position(|image| image.name == "c.pgm").unwrap();
    let left = run.with_edits(&[BlockEdit::RejectImages { images: vec![image] }]).unwrap();
    let model = &left.reconstruction.as_ref().unwrap().models[0];
    let alone = model.adjusted.points.iter().filter(|point| point.is_none()).count();
    assert!(alone > 5, "{alone} points have lost their second ray");
    assert!(!model.warnings.iter().any(|warning| matches!(warning, BlockWarning::ManyRejected { .. })), "{:?}", model.warnings);
}

#[test]
fn a_block_without_a_tie_point_left_is_weak() {
    let run = finished();
    let points = (0..run.model.points.len()).filter_map(|index| point_detail(run, index).unwrap().id).collect();
    let bare = run.with_edits(&[BlockEdit::RejectPoints { points }]).unwrap();
    let is_bare = |run: &BlockRun| matches!(BlockVerdict::of(run), BlockVerdict::Weak { overview_warning: OverviewWarning::NoPoints, .. });
    assert!(bare.model.points.is_empty() && is_bare(&bare) && !is_bare(run), "{}", BlockVerdict::of(&bare));
}

#[test]
fn what_is_refused_of_a_point_names_it_by_its_number() {
    let run = finished();
    let (_, point, _) = an_observation(run);
    let observations = detail_of(run, point).observations.into_iter().filter(|seen| seen.part == ObservationPart::Accepted);
    let own =
        observations.map(|seen| HandMeasurement { image: seen.image, x_px: seen.x_px, y_px: seen.y_px, by: MeasuredBy::LeastSquares });
    let points = vec![point];
    let edits = [
        BlockEdit::RejectPoints { points: points.clone() },
        BlockEdit::AddPoint { observations: own.collect() },
        BlockEdit::RestorePoints { points },
    ];
    let made = run.with_edits(&edits[..2]).unwrap();
    let number = made.point_number(PointSource::Manual(0)).unwrap();
    assert!(made.model.points.iter().any(|point| point.number == Some(number)) && number > 2000, "{number}");
    let text = run.with_edits(&edits).unwrap_err().to_string();
    assert!(text.contains(&format!("of which point by hand {number} was made")), "{text}");
}

#[test]
fn a_point_that_is_measured_in_three_images_lies_where_its_rays_meet() {
    let run = finished();
    let (index, ..) = an_observation(run);
    let known = point_detail(run, index).unwrap();
    let place = known.position.unwrap().map(|value| value + 0.01);
    let near = |image: &ImagePlace| HandMeasurement { image: image.image, x_px: image.x_px, y_px: image.y_px, by: MeasuredBy::Hand };
    let predicted = known.observations.iter().map(|seen| {
        let [x_px, y_px] = seen.predicted_px.unwrap();
        near(&ImagePlace { image: seen.image, x_px, y_px })
    });
    let observations: Vec<HandMeasurement> = predicted.collect();
    let added = run.with_edits(&[BlockEdit::AddPoint { observations: observations.clone() }]).unwrap();
    let manual = detail_of(&added, PointSource::Manual(0));
    let errors = manual.errors.unwrap();
    let apart = [0, 1, 2].map(|k| (manual.position.unwrap()[k] - place[k]).abs());
    assert!((0..3).all(|k| apart[k] < 0.2 * errors[k] + 0.05), "{apart:?} of {errors:?}");
    assert!(manual.observations.iter().all(|seen| seen.by_hand && seen.part == ObservationPart::Accepted));
    // What is pointed at weighs less than what is matched.
    assert!((0..3).all(|k| errors[k] > known.errors.unwrap()[k]), "{errors:?}");
    let mut apart = observations;
    apart[0].y_px += 80.0;
    apart.truncate(2);
    let refused = run.with_edits(&[BlockEdit::AddPoint { observations: apart }]).unwrap_err().to_string();
    assert!(refused.contains("point by hand "), "{refused}");
}

#[test]
fn a_rejected_image_is_not_oriented_and_says_why() {
    let run = finished();
    let without = run.with_edits(&[BlockEdit::RejectImages { images: vec![2] }]).unwrap();
    assert_eq!(without.model.images.iter().map(|image| image.pose.is_some()).collect::<Vec<_>>(), [false, true, false, true]);
    let unoriented = &without.reconstruction.as_ref().unwrap().unoriented;
    assert!(unoriented.iter().any(|image| (image.image, image.reason) == (2, UnorientedReason::RejectedByHand)));
    let overview = BlockOverview::new(&without).unwrap();
    assert_eq!(overview.images[2].reason.as_ref().unwrap().text, "it was rejected by hand");
    assert!(image_points(&without, 2).unwrap().is_empty());
}

#[test]
fn a_rejected_pair_is_marked_and_supports_no_point_until_it_is_restored() {
    let run = finished();
    let reject = BlockEdit::RejectPairs { pairs: vec![[3, 2]] };
    let edited = run.with_edits(std::slice::from_ref(&reject)).unwrap();
    let shown_by = |run: &BlockRun, pair: [usize; 2]| {
        let takes = |seen: &ObservationDetail| matches!(seen.part, ObservationPart::Accepted | ObservationPart::GrossError);
        let images = (0..run.model.points.len()).map(|point| {
            let observations = point_detail(run, point).unwrap().observations;
            observations.iter().filter(|seen| takes(seen)).map(|seen| seen.image).collect::<BTreeSet<usize>>()
        });
        images.filter(|images| *images == BTreeSet::from(pair)).count()
    };
    assert!(shown_by(run, [2, 3]) > 0);
    assert_eq!(shown_by(&edited, [2, 3]), 0);
    let rejected = |run: &BlockRun| -> Vec<[u32; 2]> {
        BlockOverview::new(run).unwrap().pairs.iter().filter(|pair| pair.rejected_by_hand).map(|pair| pair.images).collect()
    };
    assert_eq!((rejected(run), rejected(&edited)), (Vec::new(), vec![[2, 3]]));
    let table = &files(&edited)["pairs.csv"];
    assert!(table.starts_with("first,second,") && table.lines().next().unwrap().ends_with(",reason,rejected_by_hand"), "{table}");
    let marked: Vec<&str> = table.lines().filter(|line| line.ends_with(",1")).collect();
    assert!(marked.len() == 1 && marked[0].starts_with("2,3,"), "{table}");
    let saved = opened(&write_block_project(&edited).unwrap());
    assert_eq!(saved, edited);
    assert_eq!(write_block_project(&saved.with_edits(&[]).unwrap()).unwrap(), write_block_project(run).unwrap());
    let restored = run.with_edits(&[reject, BlockEdit::RestorePairs { pairs: vec![[2, 3]] }]).unwrap();
    assert_eq!((shown_by(&restored, [2, 3]), rejected(&restored)), (shown_by(run, [2, 3]), Vec::new()));
}

#[test]
fn edits_that_were_made_together_stay_together_in_the_file() {
    let run = finished();
    let edits = [1, 2, 3].map(|point| BlockEdit::RejectPoints { points: vec![PointSource::TiePoint(point)] });
    let edited = run.with_edits(&edits).unwrap();
    assert_eq!(edited.edit_steps(), [1, 1, 1]);
    let stepped = edited.clone().in_steps(&[1, 2]).unwrap();
    let again = opened(&write_block_project(&stepped).unwrap());
    assert_eq!((again.edits(), again.edit_steps()), (&edits[..], vec![1, 2]));
    // A step an edit is not written down.
    assert_eq!(write_block_project(&edited.clone().in_steps(&[1, 1, 1]).unwrap()).unwrap(), write_block_project(&edited).unwrap());
    assert_eq!(run.clone().in_steps(&[]).unwrap(), *run);
    let refused = |steps: &[usize]| edited.clone().in_steps(steps).unwrap_err().to_string();
    assert_eq!(refused(&[1, 1]), "edits of all steps together: got 2; allowed: 3");
    assert!(refused(&[usize::MAX, 5]).starts_with("edits of all steps together: got "));
    assert_eq!(refused(&[3, 0]), "steps of the edits: got one without edits; allowed: one edit or more in each");
    let mut damaged = stepped;
    damaged.edited.as_mut().unwrap().steps = vec![7];
    assert!(write_block_project(&damaged).unwrap_err().to_string().contains("edits of all steps together"));
}

#[test]
fn edits_of_what_is_not_there_are_refused_by_name() {
    let run = finished();
    let (_, point, seen) = an_observation(run);
    let refused = |edit: BlockEdit| run.with_edits(&[edit]).err().unwrap().to_string();
    let of = |text: String, words: &[&str]| assert!(words.iter().all(|word| text.contains(word)), "{text}");
    of(refused(BlockEdit::RejectPoints { points: vec![PointSource::TiePoint(u32::MAX)] }), &["tie point 4294967295"]);
    of(refused(BlockEdit::RejectImages { images: vec![0] }), &["=other, \"d\".pgm", "not oriented"]);
    of(refused(BlockEdit::RejectImages { images: vec![77] }), &["index 77"]);
    of(refused(BlockEdit::RejectPairs { pairs: vec![[0, 2]] }), &["=other, \"d\".pgm", "not oriented"]);
    of(refused(BlockEdit::RejectPairs { pairs: vec![[2, 2]] }), &["pair of images: got [2, 2]"]);
    of(refused(measure(point, seen.image, [480.5, 10.0])), &["outside the image", "480 x 360"]);
    of(refused(measure(point, seen.image, [f64::NAN, 10.0])), &["outside the image"]);
    of(refused(measure(PointSource::GroundControl(0), seen.image, [1.0, 1.0])), &["ground control or check point 0"]);
    of(refused(BlockEdit::AddPoint { observations: Vec::new() }), &["images of a new point"]);
    of(refused(BlockEdit::SetUse { point: 0, role: None }), &["ground control or check point", "index 0"]);
    let all: Vec<PointSource> = point_ids(run);
    assert!(run.with_edits(&[BlockEdit::RejectImages { images: vec![1, 2, 3] }]).is_err());
    // The support holds the block without any of the points that are given.
    run.with_edits(&[BlockEdit::RejectPoints { points: all }]).unwrap();
}

#[test]
fn edits_are_kept_with_the_block_and_undone_to_the_byte() {
    let run = finished();
    let text = write_block_project(run).unwrap();
    let ids = point_ids(run);
    let mut edits = Vec::new();
    for k in 0..24 {
        let point = ids[(k * 7) % ids.len()];
        let seen = detail_of(run, point).observations[k % 2].clone();
        let observations = vec![PointImage { point, image: seen.image }];
        edits.push(match k % 4 {
            0 => BlockEdit::RejectObservations { observations },
            1 => measure(point, seen.image, [(seen.x_px + 0.3).min(479.0), (seen.y_px - 0.2).max(1.0)]),
            2 => BlockEdit::RejectPoints { points: vec![point] },
            _ => BlockEdit::RestoreObservations { observations },
        });
        if k % 8 != 7 {
            continue;
        }
        let edited = run.with_edits(&edits).unwrap();
        assert_eq!(edited.edits(), edits);
        let saved = write_block_project(&edited).unwrap();
        let again = opened(&saved);
        assert_eq!(again, edited);
        assert_eq!(BlockOverview::new(&again).unwrap(), BlockOverview::new(&edited).unwrap());
        // Edits are applied to the block as it was found, in one step or in several.
        assert_eq!(again.with_edits(&edits).unwrap(), edited);
        assert_eq!(write_block_project(&again.with_edits(&[]).unwrap()).unwrap(), text);
        let files = files(&edited);
        let measured = files["rays.csv"].lines().skip(1).filter(|line| line.ends_with(",1")).count();
        let summary: serde_json::Value = serde_json::from_str(&files["summary.json"]).unwrap();
        assert_eq!(summary["edits"], edits.len());
        assert!(measured > 0 && measured <= edits.len(), "{measured}");
    }
}
