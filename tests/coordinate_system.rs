//! Blocks with GNSS positions on WGS 84 and control points in a coordinate reference system, beside their truth.

#[path = "coordinate_system/flown.rs"]
mod flown;
#[path = "coordinate_system/geoid.rs"]
mod geoid;
#[path = "coordinate_system/mosaic.rs"]
mod mosaic;
#[path = "coordinate_system/orthophoto.rs"]
mod orthophoto;
#[path = "coordinate_system/positions.rs"]
mod positions;
#[path = "coordinate_system/stated_errors.rs"]
mod stated_errors;

pub use flown::{GEOID_M, UTM, control, files, flown};
use flown::{both, by_gnss, in_utm, numbers, run, run_of};
use proj_core::Transform;
use std::collections::BTreeMap;
use tiepoint::{
    Axis, BlockEdit, BlockOverview, BlockRun, BlockVerdict, BlockWarning, ControlRole, ControlTexts, Datum, ExportFormat, Mistake,
    OverviewWarning, Remark, RunInput, export_run,
};

#[test]
fn gnss_positions_and_control_points_of_a_map_georeference_one_block() {
    let run = both();
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    assert!(model.in_system && model.adjusted.datum == Datum::GnssAndControl, "{:?}", model.adjusted.datum);
    let accepted = model.adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
    assert!(accepted >= 7, "{accepted} GNSS positions took part");
    let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
    assert!(checks.len() >= 3, "{}", checks.len());
    for point in &checks {
        println!("{} {:.3?} {:.3?}", point.name, point.difference_m, point.standard_errors_m);
        for k in 0..3 {
            assert!(
                point.difference_m[k].abs() < (4.0 * point.standard_errors_m[k].unwrap()).max(0.05),
                "{} {:?}",
                point.name,
                point.difference_m
            );
        }
    }
}

#[test]
fn tables_are_in_the_system_of_the_control_points() {
    let (run, truth) = (both(), flown().scene.truth());
    let files = files(run);
    let images = numbers(&files["images.csv"], &["x", "y", "z", "sigma_x", "sigma_y", "sigma_z", "kappa_deg"]);
    for (row, image) in images.iter().zip(&truth.images) {
        let pose = image.pose.unwrap();
        let known = in_utm(pose.position);
        for k in 0..3 {
            assert!((row[k] - known[k]).abs() < (4.0 * row[3 + k]).max(0.1), "{}: {row:?} {known:?}", image.name);
        }
        // Grid north is the convergence away from the meridian, by which the truth counts: tan γ is nearly tan Δλ sin φ.
        let convergence_deg = libm::atan(libm::tan((-1f64).to_radians()) * libm::sin(50f64.to_radians())).to_degrees();
        let apart = (row[6] - pose.angles()[2].to_degrees() - convergence_deg).rem_euclid(360.0);
        assert!(apart.min(360.0 - apart) < 0.1, "{}: κ is off by {apart}", image.name);
    }
    // As they were given, to 0.1 mm.
    let given = control(|place| place).points;
    let surveyed = numbers(&files["surveyed.csv"], &["x", "y", "z", "dx", "dy", "dz"]);
    let wanted = numbers(&given, &["x", "y", "z"]);
    assert_eq!(surveyed.len(), wanted.len());
    for row in &surveyed {
        assert!(wanted.iter().any(|point| (0..3).all(|k| (point[k] - row[k]).abs() < 2e-4)), "{row:?}");
        assert!((3..6).all(|k| row[k].abs() < 0.5), "{row:?}");
    }
    let points = numbers(&files["points.csv"], &["x", "y"]);
    assert!(
        points.iter().all(|at| (428_000.0..429_500.0).contains(&at[0]) && (5_538_000.0..5_540_500.0).contains(&at[1])),
        "{:?}",
        points[0]
    );
    // Those that are exported by themselves are the same.
    let mut exported = BTreeMap::new();
    export_run(run, ExportFormat::Csv, &mut |path, text| {
        exported.insert(path.to_string(), text.to_string());
        Ok(())
    })
    .unwrap();
    for (file, columns) in [("images.csv", &["x", "y", "z", "kappa_deg"][..]), ("points.csv", &["x", "y", "z"])] {
        assert_eq!(numbers(&exported[file], columns), numbers(&files[file], columns), "{file}");
    }
    for file in ["summary.json", "orientation.json", "report.html"] {
        assert!(files[file].contains("ETRS89 / UTM zone 32N"), "{file}");
    }
}

#[test]
fn every_given_point_has_a_row_whatever_became_of_it() {
    let mut texts = control(|place| place);
    let of = |name: &str| texts.points.lines().find(|line| line.starts_with(name)).unwrap()[name.len()..].to_string();
    let [control_cells, check_cells] = [of("G1,"), of("G3,")];
    let place: Vec<&str> = control_cells.split(',').take(3).collect();
    let off_cells = control_cells.replace(",control", ",off");
    // One that no image shows, one that one image shows, one of which no two image measurements fit, and one that is switched off.
    texts.points += &format!("X1,{control_cells}\nX2,{check_cells}\nX3,{control_cells}\nX4,{off_cells}\n");
    texts.marks += "photo_00000.png,X2,200,200\nphoto_00000.png,X3,20,30\nphoto_00001.png,X3,460,340\nphoto_00002.png,X4,100,100\n";
    let run = run(UTM, None, Some(texts.clone())).unwrap();
    let rows = |run: &BlockRun| -> Vec<Vec<String>> {
        files(run)["surveyed.csv"].lines().skip(1).map(|line| line.split(',').map(String::from).collect()).collect()
    };
    let told = |rows: &[Vec<String>], name: &str| {
        let own: Vec<_> = rows.iter().filter(|row| row[0] == name).collect();
        assert_eq!(own.len(), 1, "{name}: {own:?}");
        let row = own[0];
        if name.starts_with('X') {
            // Positions to 0.1 mm, and no figure of the block.
            assert_eq!((&row[2][..], row.len()), ("0", rows[0].len()), "{row:?}");
            assert!(row[6..22].iter().all(String::is_empty), "{row:?}");
        }
        (row[1].clone(), row[22].clone())
    };
    let pair = |a: &str, b: &str| (a.to_string(), b.to_string());
    let all = rows(&run);
    assert_eq!(all.len(), texts.points.lines().count() - 1);
    assert_eq!(told(&all, "G1"), pair("control", "used"));
    // By the number and the position it is known in points.csv, by its name in markers.xml.
    let number: u32 = all.iter().find(|row| row[0] == "G4").unwrap()[21].parse().unwrap();
    let at = run.model.points.iter().position(|point| point.number == Some(number)).unwrap();
    assert_eq!(run.model.points[at].name.as_deref(), Some("G4"));
    let written = files(&run);
    let given: Vec<f64> = numbers(&written["points.csv"], &["x", "y", "z"])[at].clone();
    let surveyed = written["surveyed.csv"].lines().find(|line| line.starts_with("G4,")).unwrap().split(',').map(String::from);
    let surveyed: Vec<f64> = surveyed.skip(3).take(3).map(|cell| cell.parse().unwrap()).collect();
    assert!((0..3).all(|k| (given[k] - surveyed[k]).abs() < 0.5), "{given:?} {surveyed:?}");
    assert_eq!(told(&all, "X1"), pair("control", "not measured"));
    let is_listed = |remark: &Remark| matches!(remark, Remark::UnmeasuredPoints { points } if *points == ["X1"]);
    assert!(run.remarks.iter().any(is_listed), "{:?}", run.remarks);
    assert_eq!(told(&all, "X2"), pair("check", "not determined"));
    assert_eq!(told(&all, "X3"), pair("control", "untested"));
    assert_eq!(told(&all, "X4"), pair("off", "off"));
    let own = all.iter().find(|row| row[0] == "X1").unwrap();
    assert!((0..3).all(|k| own[3 + k].parse::<f64>().unwrap() == place[k].parse::<f64>().unwrap()), "{own:?} {place:?}");
    let report = &files(&run)["report.html"];
    let section = report.split("without figures").nth(1).unwrap();
    assert!(["X1", "X2", "X3", "X4", "not measured", "untested", "not determined"].iter().all(|word| section.contains(word)));
    assert!(!files(both())["report.html"].contains("without figures"));
    // Those that are switched off by hand have their rows, too; G1 is the first that is not switched off.
    let off = run.with_edits(&[BlockEdit::SetUse { point: 0, role: None }]).unwrap();
    let edited = rows(&off);
    assert_eq!((edited.len(), told(&edited, "G1")), (all.len(), pair("off", "off")));
    // An edited block says of each whether it was added by hand.
    assert!(all.iter().all(|row| row.len() == 23) && edited.iter().all(|row| row.len() == 24 && row[23] == "0"), "{edited:?}");
    // Two control points of a system of their own place nothing, and nothing is compared with check points.
    let given = (0..).zip(texts.points.lines().skip(1).filter(|line| !line.ends_with("off")));
    let control = given.filter(|(_, line)| line.ends_with("control"));
    let edits: Vec<BlockEdit> = control.skip(2).map(|(point, _)| BlockEdit::SetUse { point, role: None }).collect();
    let local = run_of(None, None, RunInput { control: Some(texts.clone()), ..RunInput::default() }).unwrap();
    // GNSS positions, of which nothing leads to that system, take no part, and a remark says so.
    let without_system =
        |run: &BlockRun| files(run)["summary.json"].contains("no part: the coordinate reference system of the control points is not named");
    let unused = run_of(None, None, RunInput { control: Some(texts.clone()), use_gnss: false, ..RunInput::default() }).unwrap();
    assert!(without_system(&local) && !without_system(both()) && !without_system(by_gnss()) && !without_system(&unused));
    let free = rows(&local.with_edits(&edits).unwrap());
    assert_eq!((free.len(), told(&free, "G1"), told(&free, "G3")), (all.len(), pair("control", "not placed"), pair("check", "not placed")));
    assert_eq!((told(&free, "G4"), told(&free, "X4")), (pair("off", "off"), pair("off", "off")));
}

#[test]
fn a_block_without_its_control_points_lies_where_its_gnss_positions_have_it() {
    let run = both();
    let control: Vec<usize> = run.input.control.as_ref().map_or(0..0, |texts| 0..texts.points.lines().count() - 1).collect();
    let with = |edits: Vec<BlockEdit>| {
        let edited = run.with_edits(&edits).unwrap();
        (edited.reconstruction.as_ref().unwrap().models[0].clone(), edited)
    };
    let off = |points: &[usize]| points.iter().map(|point| BlockEdit::SetUse { point: *point, role: None }).collect();
    let (model, edited) = with(off(&control));
    assert!(model.in_system && model.adjusted.datum == Datum::Gnss && model.surveyed.is_empty(), "{:?}", model.adjusted.datum);
    // With their heights, above another zero than that of the control points.
    let heights = |run: &BlockRun| numbers(&files(run)["images.csv"], &["z"]).iter().map(|row| row[0]).sum::<f64>();
    let images = model.images.len() as f64;
    assert!(((heights(&edited) - heights(run)) / images - GEOID_M).abs() < 10.0, "{} {}", heights(&edited), heights(run));
    let summary: serde_json::Value = serde_json::from_str(&files(&edited)["summary.json"]).unwrap();
    assert!(summary["crs"]["gnss_above_m"].is_null(), "{}", summary["crs"]);
    let alone = heights(by_gnss()) / images;
    assert!((heights(&edited) / images - alone).abs() < 0.5, "{} {alone}", heights(&edited) / images);
    // Two of them and positions without heights place nothing.
    let (floating, _) = with(off(&control[..control.len() - 2]));
    assert!(!floating.in_system && floating.warnings.iter().any(|warning| matches!(warning, BlockWarning::Free { .. })));
}

#[test]
fn check_points_alone_and_one_control_point_are_taken_beside_gnss_positions_of_their_system() {
    let with = |controls: usize| {
        let texts = control(|place| place);
        let mut left = controls;
        let row = |line: &str| {
            let is_kept = line.ends_with(",control") && left > 0;
            left -= usize::from(is_kept);
            if is_kept { format!("{line}\n") } else { format!("{}\n", line.replace(",control", ",check")) }
        };
        ControlTexts { points: texts.points.lines().map(row).collect(), ..texts }
    };
    // Of heights that count from elsewhere nothing is known.
    let refused = run(UTM, None, Some(with(0))).unwrap_err().to_string();
    assert!(refused.contains("check points alone") && refused.contains("(--geoid, --geoid-m)"), "{refused}");
    assert!(run(None, None, Some(with(0))).unwrap_err().to_string().contains("check points alone"));
    for (controls, datum) in [(0, Datum::Gnss), (1, Datum::GnssAndControl)] {
        let run = run(UTM, Some(GEOID_M), Some(with(controls))).unwrap();
        let model = &run.reconstruction.as_ref().unwrap().models[0];
        assert!(model.in_system && model.adjusted.datum == datum, "{:?}", model.adjusted.datum);
        let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
        assert_eq!(checks.len() + controls, control(|place| place).points.lines().count() - 1);
        for point in checks {
            println!("{controls}: {} {:.3?} {:.3?}", point.name, point.difference_m, point.standard_errors_m);
            assert!((0..3).all(|k| point.difference_m[k].abs() < 4.0 * point.standard_errors_m[k].unwrap()), "{point:?}");
        }
        let table = files(&run)["surveyed.csv"].clone();
        assert_eq!(table.lines().filter(|line| line.contains(",check,")).count(), table.lines().count() - 1 - controls);
        assert!(!table.contains("not placed"), "{table}");
    }
}

#[test]
fn the_rmse_of_check_points_is_that_of_their_rows_in_the_table() {
    let (run, files) = (both(), files(both()));
    let table = &files["surveyed.csv"];
    let checks: String =
        table.lines().filter(|line| line.starts_with("name,") || line.contains(",check,")).map(|line| format!("{line}\n")).collect();
    let rows = numbers(&checks, &["dx", "dy", "dz"]);
    let rmse = |of: &dyn Fn(&[f64]) -> f64| (rows.iter().map(|row| of(row)).sum::<f64>() / rows.len() as f64).sqrt();
    let summary: serde_json::Value = serde_json::from_str(&files["summary.json"]).unwrap();
    let told = &summary["orientation"]["models"][0]["checks"];
    assert!(rows.len() >= 3 && told["points"] == rows.len(), "{told}");
    let near = |told: &serde_json::Value, own: f64| assert!((told.as_f64().unwrap() - own).abs() < 1e-9, "{told} {own}");
    (0..3).for_each(|k| near(&told["rmse_m"][k], rmse(&|row| row[k] * row[k])));
    near(&told["plan_rmse_m"], rmse(&|row| row[0] * row[0] + row[1] * row[1]));
    near(&told["height_rmse_m"], rmse(&|row| row[2] * row[2]));
    // Along the axes of the adjustment it is another one: the meridians converge by 0.8°.
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    let own: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).map(|point| point.difference_m).collect();
    let along_x = (own.iter().map(|apart| apart[0] * apart[0]).sum::<f64>() / own.len() as f64).sqrt();
    assert!((along_x - told["rmse_m"][0].as_f64().unwrap()).abs() > 1e-6, "{along_x} {told}");
    assert_eq!(serde_json::to_value(BlockOverview::new(run).unwrap().checks).unwrap(), *told);
    assert!(files["report.html"].contains(", along the axes of ETRS89 / UTM zone 32N"));
}

#[test]
fn heights_of_another_zero_are_told_apart_and_joined_by_the_geoid() {
    let above = |run: &BlockRun| {
        let summary: serde_json::Value = serde_json::from_str(&files(run)["summary.json"]).unwrap();
        summary["crs"]["gnss_above_m"].as_f64()
    };
    let found = above(both()).unwrap();
    // The median of eight heights of some metres each.
    assert!((found - GEOID_M).abs() < 5.0, "{found}");
    let with_geoid = run(UTM, Some(GEOID_M), Some(control(|place| place))).unwrap();
    assert_eq!(above(&with_geoid), None);
    let residuals = |run: &BlockRun| {
        let images = &run.reconstruction.as_ref().unwrap().models[0].adjusted.images;
        images.iter().filter_map(|image| image.gnss.map(|gnss| gnss.residual[2])).collect::<Vec<_>>()
    };
    assert!(residuals(both()).iter().all(|residual| *residual == 0.0));
    assert!(residuals(&with_geoid).iter().all(|residual| *residual != 0.0 && residual.abs() < 20.0), "{:?}", residuals(&with_geoid));
    // Tables have heights above the same zero.
    let heights = |run: &BlockRun| numbers(&files(run)["images.csv"], &["z"])[0][0];
    assert!((heights(&with_geoid) - heights(both())).abs() < 0.5);
}

#[test]
fn control_points_in_degrees_are_the_same_points() {
    let back = Transform::new(UTM, "EPSG:4258").unwrap();
    let run = run(
        "EPSG:4258",
        None,
        Some(control(|[x, y, z]| {
            let (longitude, latitude) = back.convert((x, y)).unwrap();
            [longitude, latitude, z]
        })),
    )
    .unwrap();
    let own = |run: &BlockRun| run.model.images.iter().map(|image| image.pose.unwrap().position).collect::<Vec<_>>();
    for (a, b) in own(&run).iter().zip(own(both())) {
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 2e-3), "{a:?} {b:?}");
    }
    let [longitude, latitude] = numbers(&files(&run)["images.csv"], &["x", "y"])[0][..] else { panic!("two columns") };
    assert!((longitude - 8.0).abs() < 0.02 && (latitude - 50.0).abs() < 0.02, "{longitude} {latitude}");
}

#[test]
fn results_without_control_points_are_in_the_system_too() {
    let run = run(UTM, None, None).unwrap();
    let known = in_utm(flown().scene.truth().images[0].pose.unwrap().position);
    let row = &numbers(&files(&run)["images.csv"], &["x", "y", "z"])[0];
    // Heights are those of GNSS, above the ellipsoid.
    assert!(
        (row[0] - known[0]).abs() < 15.0 && (row[1] - known[1]).abs() < 15.0 && (row[2] - known[2] - GEOID_M).abs() < 30.0,
        "{row:?} {known:?}"
    );
}

#[test]
fn heights_above_the_ellipsoid_do_not_go_under_the_name_of_others() {
    let is_said = |crs: &str, geoid_m: Option<f64>| {
        let summary: serde_json::Value = serde_json::from_str(&files(&run(crs, geoid_m, None).unwrap())["summary.json"]).unwrap();
        summary["remarks"].to_string().contains("are above the ellipsoid, as those of the GNSS positions, and not those of ")
    };
    assert!(is_said("EPSG:25832+7837", None));
    assert!(!is_said("EPSG:25832+7837", Some(GEOID_M)) && !is_said(UTM, None));
}

#[test]
fn control_points_that_cannot_be_in_the_system_are_refused_with_figures() {
    let told = |crs: &str, write: fn([f64; 3]) -> [f64; 3]| run(crs, None, Some(control(write))).unwrap_err().to_string();
    let wrong_zone = told("EPSG:25833", |place| place);
    assert!(wrong_zone.contains("km from the GNSS positions") && wrong_zone.contains("In zone 32 it lies near them"), "{wrong_zone}");
    let exchanged = told(UTM, |[x, y, z]| [y, x, z]);
    assert!(
        exchanged.contains("exchanged") || exchanged.contains("outside") || exchanged.contains("order of the coordinates"),
        "{exchanged}"
    );
    let degrees = told(UTM, |_| [8.0, 50.0, 100.0]);
    assert!(degrees.contains("look like degrees") && degrees.contains("G1"), "{degrees}");
    let metres = told("EPSG:4326", |place| place);
    assert!(metres.contains("longitude as x"), "{metres}");
    let lambert = told("EPSG:2154", |place| place);
    assert!(lambert.contains("RGF93") || lambert.contains("EPSG:2154"), "{lambert}");
}

#[test]
fn a_mistyped_control_point_is_explained_by_the_numbers_that_were_written() {
    let mut texts = control(|place| place);
    let row = texts.points.lines().find(|line| line.starts_with("G4,")).unwrap().to_string();
    let written = row.split(',').nth(1).unwrap();
    let right: f64 = written.parse().unwrap();
    let step = if (right / 10.0).floor() % 10.0 < 5.0 { 30.0 } else { -30.0 };
    texts.points = texts.points.replace(&format!("G4,{written},"), &format!("G4,{},", right + step));
    let run = run(UTM, None, Some(texts)).unwrap();
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    let told: Vec<&BlockWarning> = model.warnings.iter().filter(|w| matches!(w, BlockWarning::ControlRefused { .. })).collect();
    let [BlockWarning::ControlRefused { point, axis: Axis::X, difference_m, used: false, mistake: Some(mistake), .. }] = told[..] else {
        panic!("{:?}", model.warnings)
    };
    let Mistake::Digit { axis: Axis::X, likely, .. } = mistake else { panic!("{mistake:?}") };
    assert!(point == "G4" && (difference_m + step).abs() < 1.0 && (likely.parse::<f64>().unwrap() - right).abs() < 1e-3, "{told:?}");
    let BlockVerdict::Weak { overview_warning: OverviewWarning::Model { block_warning }, .. } = BlockVerdict::of(&run) else {
        panic!("{}", BlockVerdict::of(&run))
    };
    assert_eq!(&block_warning, told[0]);
    let files = files(&run);
    let state = |name: &str| files["surveyed.csv"].lines().find(|line| line.starts_with(name)).unwrap().rsplit(',').next().unwrap();
    assert_eq!([state("G4,"), state("G1,"), state("G3,")], ["rejected", "used", "check"]);
    assert!(files["summary.json"].contains("control_refused") && files["report.html"].contains("<td>rejected</td>"));
}

#[test]
fn a_far_off_control_point_differs_by_its_coordinates() {
    let mut texts = control(|place| place);
    let row = texts.points.lines().find(|line| line.starts_with("G4,")).unwrap().to_string();
    let [x, y] = [1, 2].map(|k| row.split(',').nth(k).unwrap().to_string());
    texts.points = texts.points.replace(&format!("G4,{x},{y},"), &format!("G4,{y},{x},"));
    // GNSS positions would have it refused before the images are matched.
    let run = run_of(UTM, None, RunInput { control: Some(texts), use_gnss: false, ..RunInput::default() }).unwrap();
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    let told = model.warnings.iter().find_map(|warning| match warning {
        BlockWarning::ControlRefused { point, mistake, .. } if point == "G4" => Some(mistake),
        _ => None,
    });
    assert_eq!(told, Some(&Some(Mistake::Exchanged)), "{:?}", model.warnings);
    let files = files(&run);
    let table = &files["surveyed.csv"];
    let row = table.lines().find(|line| line.starts_with("G4,")).unwrap();
    let columns = ["x", "y", "z", "dx", "dy", "dz", "left_out_dx", "left_out_dy", "left_out_dz"];
    let own = &numbers(&format!("{}\n{row}\n", table.lines().next().unwrap()), &columns)[0];
    let written: [f64; 2] = [&x, &y].map(|v| v.parse().unwrap());
    // What is surveyed and the difference are where the point is.
    for k in 0..2 {
        assert!((own[k] - written[1 - k]).abs() < 2e-4 && (own[k] + own[3 + k] - written[k]).abs() < 1.0, "{own:?} {written:?}");
        assert!((own[6 + k] - own[3 + k]).abs() < 1.0, "{own:?}");
    }
    assert!(own[5].abs() < 5.0, "{own:?}");
    // The report has the residual, which is the other way around.
    let report = &files["report.html"];
    let row = report.split("<tr>").find(|row| row.contains(">G4<") && row.contains(">rejected<")).unwrap();
    let cells: Vec<f64> =
        row.split("<td>").skip(2).take(2).map(|cell| cell.split('<').next().unwrap().replace('\u{2212}', "-").parse().unwrap()).collect();
    assert!((0..2).all(|k| (cells[k] + own[3 + k]).abs() < 1e-3 * own[3 + k].abs()), "{row}");
}
