//! Blocks in the system of an orthophoto, beside their truth.

use super::shown::{Shown, shown};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock, PoisonError};
use tiepoint::{
    Axis, BlockEdit, BlockFiles, BlockFlight, BlockLinks, BlockModel, BlockRun, BlockScene, BlockSettings, BlockVerdict, BlockWarning,
    CameraUncertainty, ControlRole, ControlTexts, DecodeLimits, HeightModel, Heights, MeasuredBy, MultiscaleOptions, NotLinked,
    OnOrthophoto, Orthophoto, OverviewWarning, PlacingOptions, PointSource, Remark, RunInput, SearchArea, Texts, control_by_hand, decode,
    parse_ground_control_points, read_project, run_block, write_block_project,
};

/// Of the map, from that of the scene.
const FAR: [f64; 2] = [350_000.0, 5_800_000.0];

fn flight(seed: u32) -> BlockFlight {
    BlockFlight { strips: 2, exposures: 4, width_px: 480, height_px: 360, pixel_mm: 0.075, relief_m: 40.0, seed, ..BlockFlight::default() }
}

fn options() -> PlacingOptions {
    PlacingOptions { points: 3000, ..PlacingOptions::default() }
}

/// The orthophoto of a scene in the system of a map.
fn orthophoto(scene: &BlockScene) -> Orthophoto {
    let made = scene.orthophoto(0.8).unwrap();
    let mut georeference = made.georeference;
    (0..2).for_each(|k| georeference.origin[k] += FAR[k]);
    let Heights::Model(mut model) = made.heights.clone() else { panic!("a scene has a model of its heights") };
    (0..2).for_each(|k| model.georeference.origin[k] += FAR[k]);
    Orthophoto::new(made.grey().unwrap(), georeference, Heights::Model(model)).unwrap()
}

struct Flown {
    scene: BlockScene,
    photos: Vec<PathBuf>,
    folder: PathBuf,
}

/// A scene with its photos on disk.
fn flown() -> &'static Flown {
    static FLOWN: OnceLock<Flown> = OnceLock::new();
    FLOWN.get_or_init(|| {
        let scene = BlockScene::new(&flight(3)).unwrap();
        let folder = std::env::temp_dir().join(format!("tiepoint-on-orthophoto-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let photo = |index: usize| {
            let path = folder.join(format!("photo_{index:05}.png"));
            fs::write(&path, scene.photo_file(index).unwrap()).unwrap();
            path
        };
        let photos = (0..scene.photos()).map(photo).collect();
        Flown { scene, photos, folder }
    })
}

fn run(control: Option<ControlTexts>) -> BlockRun {
    // All share the records of the images: one run at a time has their folder.
    static FOLDER: Mutex<()> = Mutex::new(());
    let _mine = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    let Flown { photos, folder, scene } = flown();
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 2500, ..settings.features.multiscale };
    // Over ground that is nearly flat a focal length that is estimated takes the height with it.
    let focal_px = scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}, "fixed": true}}]}}"#));
    let input = RunInput { settings, cameras, use_gnss: control.is_none(), control, ..RunInput::default() };
    run_block(photos, &[], input, &folder.join("work"), 2, drop).unwrap()
}

/// The block of the flight, placed by its GNSS positions on the earth.
fn block() -> &'static BlockRun {
    static BLOCK: OnceLock<BlockRun> = OnceLock::new();
    BLOCK.get_or_init(|| run(None))
}

fn placed(block: &BlockRun, reference: &Orthophoto) -> BlockLinks {
    let area = SearchArea::new(reference, &options()).unwrap();
    let mut links = BlockLinks::default();
    for (index, path) in flown().photos.iter().enumerate() {
        let grey = decode(&fs::read(path).unwrap(), &DecodeLimits::default()).unwrap().grey;
        links.place(block, index, grey.view(), reference, &area, &options()).unwrap();
    }
    links
}

/// The orthophoto of the scene, and where its photos lie on it: that follows from cameras and photos, whatever else is known of the block.
fn own() -> &'static (Orthophoto, BlockLinks) {
    static OWN: OnceLock<(Orthophoto, BlockLinks)> = OnceLock::new();
    OWN.get_or_init(|| {
        let reference = orthophoto(&flown().scene);
        let links = placed(block(), &reference);
        (reference, links)
    })
}

fn linked(block: &BlockRun) -> BlockRun {
    let (reference, links) = own();
    links.linked(block, reference, &options()).unwrap()
}

fn outcome(block: &BlockRun) -> OnOrthophoto {
    block.orthophoto.clone().unwrap()
}

/// Places that hold a block in the system of the orthophoto, that check it, and that are rejected.
fn counted(block: &BlockRun) -> [usize; 3] {
    match outcome(block) {
        OnOrthophoto::Linked { points, checks, rejected, .. } => [points, checks, rejected],
        other => panic!("{other}"),
    }
}

/// Errors of the projection centres in m, and by their standard errors.
fn errors(run: &BlockRun, truth: &BlockModel) -> Vec<[(f64, f64); 3]> {
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    let of_image = |(image, statistics): (&usize, &tiepoint::ImageStatistics)| {
        let own = run.model.images[*image].pose.unwrap().position;
        let known = truth.images[*image].pose.unwrap().position;
        let sigma = statistics.position_errors.unwrap();
        [0, 1, 2].map(|k| {
            let off = own[k] - known[k] - [FAR[0], FAR[1], 0.0][k];
            (off, off / sigma[k])
        })
    };
    model.images.iter().zip(&model.adjusted.images).map(of_image).collect()
}

#[test]
fn a_block_comes_into_the_system_of_its_orthophoto() {
    let Flown { scene, .. } = flown();
    let before = block();
    let found = linked(before);
    let OnOrthophoto::Linked { linked, images, points, checks, .. } = outcome(&found) else { panic!("{}", outcome(&found)) };
    assert!(linked == 8 && images == 8 && points >= 40 && checks >= 8, "{}", outcome(&found));
    assert!(matches!(BlockVerdict::of(&found), BlockVerdict::Oriented { .. }), "{}", BlockVerdict::of(&found));
    let errors = errors(&found, &scene.truth());
    println!("{} {errors:.3?}", outcome(&found));
    let largest = errors.iter().flatten().map(|(off, _)| off.abs()).fold(0.0, f64::max);
    assert!(largest < 1.6, "{largest} m, two px of the orthophoto, from 785 m above it");
    // Errors of the images of a block are common to them: some mean squares of all tell little of one axis.
    let mean_square = errors.iter().flatten().map(|(_, ratio)| ratio * ratio).sum::<f64>() / (3 * errors.len()) as f64;
    assert!((0.05..4.0).contains(&mean_square), "{mean_square}");
    let model = &found.reconstruction.as_ref().unwrap().models[0];
    let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
    let squares: Vec<f64> = checks
        .iter()
        .flat_map(|point| (0..3).map(|k| point.difference_m[k] / point.standard_errors_m[k].unwrap()))
        .map(|r| r * r)
        .collect();
    let ratio = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    assert!((0.2..2.0).contains(&ratio), "{ratio}");
    // Residuals have weighted the points: at first each stood for all others. A check point stands for itself.
    let rows = parse_ground_control_points(&found.input.control.as_ref().unwrap().points).unwrap();
    let sigma = |role, k: usize| {
        let of_role = rows.iter().filter(|row| row.role == Some(role));
        of_role.map(|row| row.standard_errors.unwrap()[k]).fold(f64::INFINITY, f64::min)
    };
    let at_first = (1.0 + 0.25 * points as f64).sqrt();
    for k in 0..2 {
        let times = sigma(ControlRole::Control, k) / sigma(ControlRole::Check, k);
        println!("a place stands for as many errors as {times:.2} of its own, {at_first:.2} at first");
        assert!((1.0..0.9 * at_first).contains(&times), "{times} {at_first}");
    }
    // The block that it was is not changed, and edits are applied to the one that is linked.
    assert!(before.orthophoto.is_none() && found.found() == found);
    let name = model.surveyed[0].name.clone();
    assert!(name.starts_with("orthophoto_"), "{name}");
}

#[test]
fn a_focal_length_that_contradicts_what_was_known_is_said_of_a_block_on_an_orthophoto() {
    let found = linked(block());
    let focal_px = found.model.cameras[0].focal_px;
    let verdict = |times: f64, uncertainty: CameraUncertainty, orthophoto: Option<OnOrthophoto>| {
        let mut run = BlockRun { orthophoto, ..found.clone() };
        run.cameras[0].focal_px = Some(times * focal_px);
        run.cameras[0].uncertainty = Some(uncertainty);
        BlockVerdict::of(&run)
    };
    let on = || found.orthophoto.clone();
    let by_hand = Some(OnOrthophoto::ByHand { linked: 8, images: 8, points: 4, in_crs: false, epsg: None });
    let said = verdict(1.25, CameraUncertainty::EXIF, by_hand);
    assert!(matches!(&said, BlockVerdict::Weak { overview_warning: OverviewWarning::FocalApart { .. }, .. }), "{said}");
    let said = verdict(1.25, CameraUncertainty::EXIF, on());
    let BlockVerdict::Weak { overview_warning: OverviewWarning::FocalApart { estimated_px, prior_px, apart, .. }, .. } = &said else {
        panic!("{said}")
    };
    assert_eq!((*estimated_px, *prior_px), (focal_px, 1.25 * focal_px));
    assert!((apart - 0.25 / 1.25 / CameraUncertainty::EXIF.focal).abs() < 1e-9, "{apart}");
    assert!(said.to_string().contains("4.0 standard deviations"), "{said}");
    // Within what was known; of a camera that nobody knew; so near that it does not matter; and without an orthophoto.
    for (times, uncertainty, orthophoto) in [
        (1.09, CameraUncertainty::EXIF, on()),
        (1.25, CameraUncertainty::ASSUMED, on()),
        (1.015, CameraUncertainty::GIVEN, on()),
        (1.25, CameraUncertainty::EXIF, None),
    ] {
        let verdict = verdict(times, uncertainty, orthophoto);
        assert!(matches!(verdict, BlockVerdict::Oriented { .. }), "{times}: {verdict}");
    }
}

#[test]
fn heights_that_are_off_in_a_part_leave_the_block_right_or_say_so() {
    let (right, _) = own();
    let [width, height] = right.size();
    for share in [0.35, 0.5] {
        let raised = |k: usize| {
            let (column, row) = (k % width, k / width);
            let own = right.heights.at(right.georeference.ground([column as f64 + 0.5, row as f64 + 0.5])).unwrap_or(f64::NAN);
            (own + if column as f64 > (1.0 - share) * width as f64 { 5.0 } else { 0.0 }) as f32
        };
        let model = HeightModel::new(width, height, (0..width * height).map(raised).collect(), right.georeference).unwrap();
        let reference = Orthophoto::new(right.grey().unwrap(), right.georeference, Heights::Model(model)).unwrap();
        let found = placed(block(), &reference).linked(block(), &reference, &options()).unwrap();
        let verdict = BlockVerdict::of(&found);
        let is_linked = matches!(outcome(&found), OnOrthophoto::Linked { .. });
        let is_moved = is_linked && errors(&found, &flown().scene.truth()).iter().any(|[.., (z, _)]| z.abs() > 2.0);
        println!("{share}: {} {is_moved} {verdict}", outcome(&found));
        assert!(matches!(verdict, BlockVerdict::Weak { .. }) || (is_linked && !is_moved), "{share}: {verdict}");
    }
}

#[test]
fn an_orthophoto_of_elsewhere_leaves_the_block_as_it_was_and_says_so() {
    let other = orthophoto(&BlockScene::new(&BlockFlight { exposures: 2, ..flight(4) }).unwrap());
    let found = placed(block(), &other).linked(block(), &other, &options()).unwrap();
    let OnOrthophoto::NotLinked { not_linked } = outcome(&found) else { panic!("{}", outcome(&found)) };
    assert!(matches!(not_linked, NotLinked::FewImages { placed: 0, images: 8, .. }), "{not_linked}");
    assert_eq!(BlockRun { orthophoto: None, ..found.clone() }, *block());
    let BlockVerdict::Weak { overview_warning, .. } = BlockVerdict::of(&found) else { panic!("{}", BlockVerdict::of(&found)) };
    assert!(matches!(overview_warning, OverviewWarning::NotOnOrthophoto { .. }));
}

/// Ground control points by the truth, their heights raised, and the x of the third wrong.
fn surveyed(raised_m: f64, wrong_m: f64) -> ControlTexts {
    let places = shown(&flown().scene, &[0, 2, 5, 7], &[[150.0, 120.0], [330.0, 240.0]]);
    let (mut points, mut marks) = ("name,x,y,z,sigma_xy,sigma_z,sigma_px\n".to_string(), "image,point,x,y\n".to_string());
    for (number, (place, images)) in (1..).zip(&places) {
        let x = place[0] + FAR[0] + if number == 3 { wrong_m } else { 0.0 };
        points += &format!("G{number},{x},{},{},0.05,0.05,0.1\n", place[1] + FAR[1], place[2] + raised_m);
        marks += &images.iter().map(|(image, [x, y])| format!("photo_{image:05}.png,G{number},{x},{y}\n")).collect::<String>();
    }
    assert!(places.len() >= 4, "{}", places.len());
    ControlTexts { points, marks }
}

#[test]
fn ground_control_points_take_part_beside_the_orthophoto_or_contradict_its_heights() {
    let both = linked(&run(Some(surveyed(0.0, 0.0))));
    let OnOrthophoto::Linked { points, .. } = outcome(&both) else { panic!("{}", outcome(&both)) };
    let model = &both.reconstruction.as_ref().unwrap().models[0];
    let control = |begins: &str| model.surveyed.iter().filter(|point| point.name.starts_with(begins)).count();
    assert!(control("G") >= 4 && control("orthophoto_") >= points, "{points}");
    // A height model that is off as a whole by less than what is stated of a place, which residuals do not show, contradicts nothing.
    let found = linked(&run(Some(surveyed(0.3, 0.0))));
    assert!(matches!(outcome(&found), OnOrthophoto::Linked { .. }), "{}", outcome(&found));
    // Heights of the model that are 5 m lower than those that were surveyed.
    let low = run(Some(surveyed(5.0, 0.0)));
    let found = linked(&low);
    let OnOrthophoto::NotLinked { not_linked: NotLinked::Contradiction { x_m, y_m, z_m } } = outcome(&found) else {
        panic!("{}", outcome(&found))
    };
    assert!(x_m.abs() < 0.5 && y_m.abs() < 0.5 && (z_m + 5.0).abs() < 0.5, "{x_m} {y_m} {z_m}");
    assert_eq!(found.model, low.model);
}

/// The control points that a block rejected, as its warnings name them.
fn rejected(run: &BlockRun) -> Vec<String> {
    let of = |warning: &BlockWarning| match warning {
        BlockWarning::ControlRefused { point, axis: Axis::X, used: false, .. } => Some(point.clone()),
        _ => None,
    };
    run.reconstruction.as_ref().unwrap().models[0].warnings.iter().filter_map(of).collect()
}

#[test]
fn a_wrong_ground_control_point_is_rejected_beside_an_orthophoto_as_alone() {
    let alone = run(Some(surveyed(0.0, 30.0)));
    assert_eq!(rejected(&alone), ["G3"], "{}", BlockVerdict::of(&alone));
    let both = linked(&alone);
    let OnOrthophoto::Linked { .. } = outcome(&both) else { panic!("{}", outcome(&both)) };
    let is_right = |run: &BlockRun| {
        let model = &run.reconstruction.as_ref().unwrap().models[0];
        println!("{:?}", model.warnings);
        assert_eq!(rejected(run), ["G3"], "{:?}", model.warnings);
        assert!(matches!(BlockVerdict::of(run), BlockVerdict::Weak { .. }), "{}", BlockVerdict::of(run));
        let own = model.surveyed.iter().find(|point| point.name == "G3").unwrap();
        let left = own.left_out.unwrap();
        assert!((left.difference[0] + 30.0).abs() < 5.0 * left.standard_errors[0], "{left:?}");
        // Its image measurements are good.
        let is_blamed = |warning: &BlockWarning| matches!(warning, BlockWarning::MeasurementsRejected { point, .. } | BlockWarning::PointRejected { point, .. } if point == "G3");
        assert!(!model.warnings.iter().any(is_blamed), "{:?}", model.warnings);
    };
    is_right(&both);
    let tie_point = both.reconstruction.as_ref().unwrap().models[0].points[0];
    is_right(&both.with_edits(&[BlockEdit::RejectPoints { points: vec![tie_point] }]).unwrap());
}

/// Places of level ground near the corners of the block, each with all images that show it.
fn corners() -> Vec<Shown> {
    let (reference, _) = own();
    let at_px: Vec<[f64; 2]> = (0..63).map(|k| [60.0 + 45.0 * f64::from(k % 9), 60.0 + 40.0 * f64::from(k / 9)]).collect();
    let all = shown(&flown().scene, &[0, 3, 4, 7], &at_px);
    // Beside roofs and walls nobody measures by eye.
    let is_level = |(place, _): &Shown| {
        let added = control_by_hand(1, [place[0] + FAR[0], place[1] + FAR[1]], reference, None, &options());
        matches!(added, Ok(BlockEdit::AddControl { standard_errors: Some([_, height]), position, .. }) if height < 1.0 && (position[2] - place[2]).abs() < 0.3)
    };
    let level: Vec<Shown> = all.into_iter().filter(is_level).collect();
    // Those that lie farthest out to four sides.
    let sides = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let outermost =
        |[a, b]: [f64; 2]| level.iter().max_by(|(p, _), (q, _)| (a * p[0] + b * p[1]).total_cmp(&(a * q[0] + b * q[1]))).unwrap().clone();
    sides.map(outermost).into()
}

/// Edits that measure these places by hand in a block with so many surveyed points. `times`: how many px a usual error of the eye is, in either picture.
fn by_hand(given: usize, places: &[Shown], times: f64) -> Vec<BlockEdit> {
    let (reference, _) = own();
    let off = |k: usize| times * [0.7, -1.1, 0.4, -0.3, 1.2, -0.6, 0.2, 0.9][k % 8];
    let of_place = |(number, (place, seen)): (usize, &Shown)| {
        let at = [0, 1].map(|k| place[k] + FAR[k] + 0.8 * off(3 * number + k));
        let add = control_by_hand(number + 1, at, reference, None, &options()).unwrap();
        let measure = seen.iter().enumerate().map(move |(k, (image, [x, y]))| {
            let (x_px, y_px) = ((x + off(number + 2 * k)).clamp(0.0, 480.0), (y - off(number + 2 * k + 3)).clamp(0.0, 360.0));
            BlockEdit::Measure { point: PointSource::GroundControl(given + number), image: *image, x_px, y_px, by: MeasuredBy::Hand }
        });
        std::iter::once(add).chain(measure).collect::<Vec<BlockEdit>>()
    };
    places.iter().enumerate().flat_map(of_place).collect()
}

fn largest_m(errors: &[[(f64, f64); 3]]) -> f64 {
    errors.iter().flatten().map(|(off, _)| off.abs()).fold(0.0, f64::max)
}

/// The camera is narrow: a place that lies a px beside itself in two photos 60 m apart is 9 m too high or too low, and four of them tilt the block by a
/// degree, or 15 m at 800 m. Standard errors say so, and without errors of the eye the block is where it was photographed.
fn holds(run: &BlockRun, exact: &BlockRun) {
    let truth = flown().scene.truth();
    let (off, exact) = (errors(run, &truth), errors(exact, &truth));
    println!("{:.2} m, {:.2} m without errors: {off:.3?}", largest_m(&off), largest_m(&exact));
    let ratios: Vec<f64> = off.iter().flatten().map(|(_, ratio)| ratio.abs()).collect();
    let mean_square = ratios.iter().map(|ratio| ratio * ratio).sum::<f64>() / ratios.len() as f64;
    assert!(ratios.iter().all(|ratio| *ratio < 3.3) && (0.05..4.0).contains(&mean_square), "{mean_square} {off:.3?}");
    assert!(largest_m(&exact) < 2.5, "{exact:.3?}");
}

/// Names of the control points that take part in a block.
fn used(run: &BlockRun) -> Vec<String> {
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    model.surveyed.iter().filter(|point| point.role == ControlRole::Control).map(|point| point.name.clone()).collect()
}

fn files(run: &BlockRun) -> BTreeMap<String, String> {
    let mut written = BTreeMap::new();
    let mut files = BlockFiles::new(&[], None, Texts::english());
    while files
        .step(run, &mut |path, text| {
            written.insert(path.to_string(), text.to_string());
            Ok(())
        })
        .unwrap()
        .is_none()
    {}
    written
}

#[test]
fn four_places_by_hand_hold_a_block_whose_automatic_places_are_all_rejected() {
    let found = linked(block());
    let given = parse_ground_control_points(&found.input.control.as_ref().unwrap().points).unwrap();
    let given = given.iter().filter(|row| row.role.is_some()).count();
    let reject = BlockEdit::RejectPoints {
        points: (0..given)
            .filter(|k| found.reconstruction.as_ref().unwrap().models[0].points.contains(&PointSource::GroundControl(*k)))
            .map(PointSource::GroundControl)
            .collect(),
    };
    let places = by_hand(given, &corners(), 1.0);
    let edited = found.with_edits(&[vec![reject.clone()], places.clone()].concat()).unwrap();
    assert_eq!(used(&edited), ["orthophoto_hand_1", "orthophoto_hand_2", "orthophoto_hand_3", "orthophoto_hand_4"]);
    // What is said of the orthophoto is counted anew.
    let [points, checks, rejected] = counted(&found);
    assert_eq!(counted(&edited), [4, 0, points + checks + rejected]);
    holds(&edited, &found.with_edits(&[vec![reject.clone()], by_hand(given, &corners(), 0.0)].concat()).unwrap());
    // Without them the block would float, and beside the automatic ones they take part as any.
    let without = found.with_edits(std::slice::from_ref(&reject)).unwrap();
    let floats = matches!(outcome(&without), OnOrthophoto::NotLinked { not_linked: NotLinked::FewPoints { points: 0, .. } });
    assert!(used(&without).is_empty() && floats, "{}", outcome(&without));
    let beside = found.with_edits(&places).unwrap();
    assert_eq!(counted(&beside), [points + 4, checks, rejected]);
    let some = BlockEdit::RejectPoints { points: vec![PointSource::GroundControl(0), PointSource::GroundControl(1)] };
    let fewer = found.with_edits(std::slice::from_ref(&some)).unwrap();
    let [fewer_points, fewer_checks, more] = counted(&fewer);
    assert_eq!((fewer_points + fewer_checks + 2, more), (points + checks, rejected + 2));
    assert_eq!(fewer.found(), found);
    let all = used(&beside);
    assert!(all.len() > 40 && all.contains(&"orthophoto_hand_4".to_string()), "{all:?}");
    let better = errors(&beside, &flown().scene.truth());
    assert!(largest_m(&better) < 1.6, "{better:.3?}");

    // The tables say which they are, the project keeps them, and without edits the block is what it was.
    let written = files(&edited);
    let rows: Vec<Vec<&str>> = written["surveyed.csv"].lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0].last(), Some(&"by_hand"));
    let of = |name: &str| rows.iter().find(|row| row[0] == name).unwrap().clone();
    assert_eq!(of("orthophoto_hand_1")[rows[0].len() - 2..], ["used", "1"]);
    assert_eq!(of(&used(&found)[0])[rows[0].len() - 2..], ["off", "0"]);
    assert!(!files(&found)["surveyed.csv"].contains("by_hand"));
    let tiepoint::Project::Block(again) = read_project(write_block_project(&edited).unwrap().as_bytes()).unwrap() else {
        panic!("a block")
    };
    assert_eq!(*again, edited);
    assert_eq!(again.with_edits(&[]).unwrap(), found);
    // One that is rejected by hand, or used as a check point, is named so.
    let checked = [
        places,
        vec![
            BlockEdit::SetUse { point: given + 1, role: Some(ControlRole::Check) },
            BlockEdit::RejectPoints { points: vec![PointSource::GroundControl(given)] },
        ],
    ]
    .concat();
    let checked = files(&found.with_edits(&checked).unwrap())["surveyed.csv"].clone();
    let row = |name: &str| checked.lines().find(|line| line.starts_with(name)).unwrap().to_string();
    assert!(row("orthophoto_hand_1,").ends_with("off,1") && row("orthophoto_hand_2,check").ends_with("check,1"), "{checked}");
}

#[test]
fn edits_of_places_hold_once_the_block_is_placed_anew() {
    let (before, (reference, links)) = (linked(block()), own());
    // Other check points and standard errors, and every image but one: places have other names.
    let other = PlacingOptions { check_share: 0.35, place_sigma_px: 0.8, ..options() };
    let mut fewer = BlockLinks::default();
    let area = SearchArea::new(reference, &other).unwrap();
    for (index, path) in flown().photos.iter().enumerate().skip(1) {
        let grey = decode(&fs::read(path).unwrap(), &DecodeLimits::default()).unwrap().grey;
        fewer.place(block(), index, grey.view(), reference, &area, &other).unwrap();
    }
    let same = links.linked(block(), reference, &PlacingOptions { check_share: 0.35, ..options() }).unwrap();
    let now = fewer.linked(block(), reference, &other).unwrap();
    let (places, there) = (before.places().unwrap(), now.places().unwrap());
    let again = there.again(&places);
    println!("{} places before, {} now, {} again", places.places.len(), there.places.len(), again.len());
    assert!(again.len() > there.places.len() / 2 && again.len() < places.places.len(), "{}", again.len());
    assert!(again.iter().any(|one| one.before != one.now), "names are others");
    // Placed by the same links they lie where they lay, but for what other check points make of the limits.
    let all = same.places().unwrap().again(&places);
    assert!(
        20 * all.len() >= 19 * places.places.len() && all.iter().all(|one| one.is_same_spot),
        "{} of {}",
        all.len(),
        places.places.len()
    );

    let lie = |run: &BlockRun, number: usize| {
        let rows = parse_ground_control_points(&run.input.control.as_ref().unwrap().points).unwrap();
        rows.into_iter().filter(|row| row.role.is_some()).nth(number).unwrap().position
    };
    for one in &again {
        let (a, b) = (lie(&before, one.before), lie(&now, one.now));
        // Half a square is 24 px of some 0.8 m.
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 30.0, "{one:?}: {a:?} and {b:?}");
    }
    // One that is there again is rejected, one that is gone is lost; a measurement holds of the same spot, and that of a place by hand.
    let held = again.iter().find(|one| one.is_same_spot && one.before != one.now).unwrap();
    let gone = (0..places.places.len()).find(|k| again.iter().all(|one| one.before != *k) && !places.places[*k].seen.is_empty()).unwrap();
    let point = |number: usize| PointSource::GroundControl(number);
    let [image, ..] = held.images[..] else { panic!() };
    let measure = |number: usize| BlockEdit::Measure { point: point(number), image, x_px: 100.0, y_px: 50.0, by: MeasuredBy::Hand };
    let given = places.places.len();
    let edits = [
        vec![measure(held.before), BlockEdit::RejectPoints { points: vec![point(gone), point(held.before)] }],
        vec![BlockEdit::SetUse { point: gone, role: Some(ControlRole::Check) }, BlockEdit::RejectImages { images: vec![7] }],
        by_hand(given, &corners(), 1.0),
    ]
    .concat();
    let carried = now.carried_edits(&places, &edits).unwrap();
    let wanted = [
        vec![measure(held.now), BlockEdit::RejectPoints { points: vec![point(held.now)] }, BlockEdit::RejectImages { images: vec![7] }],
        by_hand(there.places.len(), &corners(), 1.0),
    ]
    .concat();
    assert_eq!((carried.edits.clone(), carried.held, carried.lost), (wanted, 1, 1));
    // They are edits of the block: the place does not take part.
    let name = |run: &BlockRun, number: usize| {
        let rows = parse_ground_control_points(&run.input.control.as_ref().unwrap().points).unwrap();
        rows.into_iter().filter(|row| row.role.is_some()).nth(number).unwrap().name
    };
    let edited = now.with_edits(&carried.edits).unwrap();
    assert!(used(&now).contains(&name(&now, held.now)) && !used(&edited).contains(&name(&now, held.now)));
    // Off the orthophoto, and of another block.
    let off = block().carried_edits(&places, &edits).unwrap();
    assert_eq!((off.held, off.lost), (0, 2));
    let others = tiepoint::BlockPlaces { images: vec!["other.png".into()], ..places.clone() };
    let refused = now.carried_edits(&others, &edits).unwrap_err().to_string();
    assert!(refused.contains("other images, tie points or ground control points"), "{refused}");
}

#[test]
fn places_by_hand_bring_a_block_that_could_not_be_linked_into_the_system_of_the_orthophoto() {
    let (reference, _) = own();
    let found = BlockLinks::default().linked(block(), reference, &options()).unwrap();
    assert!(
        matches!(outcome(&found), OnOrthophoto::NotLinked { not_linked: NotLinked::FewImages { placed: 0, .. } }),
        "{}",
        outcome(&found)
    );
    let places = by_hand(0, &corners(), 1.0);
    // What is adjusted anew without a change.
    let tie_point =
        *found.reconstruction.as_ref().unwrap().models[0].points.iter().find(|point| matches!(point, PointSource::TiePoint(_))).unwrap();
    let as_it_was = found.with_edits(&[BlockEdit::RestorePoints { points: vec![tie_point] }]).unwrap();
    // Two do not suffice, however often they are measured: they wait, and the block stays where its GNSS positions have it.
    let third = places.iter().enumerate().filter(|(_, edit)| matches!(edit, BlockEdit::AddControl { .. })).nth(2).unwrap().0;
    let two = found.with_edits(&places[..third]).unwrap();
    assert_eq!(two.reconstruction, as_it_was.reconstruction);
    assert_eq!(outcome(&two), outcome(&found));
    assert!(files(&two)["surveyed.csv"].lines().skip(1).all(|line| line.ends_with("not placed,1")), "{}", files(&two)["surveyed.csv"]);
    // Nor does a third that one image shows.
    let three = found.with_edits(&places[..third + 2]).unwrap();
    assert_eq!(three.reconstruction, as_it_was.reconstruction);

    // Nor do three of which one was measured at another place in each image: its rays do not meet.
    let mut apart: Vec<BlockEdit> = by_hand(0, &corners()[..3], 1.0);
    let of_first = apart.iter_mut().filter_map(|edit| match edit {
        BlockEdit::Measure { point: PointSource::GroundControl(0), x_px, y_px, .. } => Some((x_px, y_px)),
        _ => None,
    });
    for (k, (x_px, y_px)) in of_first.enumerate() {
        (*x_px, *y_px) = ((*x_px + 97.0 * (k + 1) as f64) % 480.0, (*y_px + 151.0 * (k * k + 1) as f64) % 360.0);
    }
    assert_eq!(found.with_edits(&apart).unwrap().reconstruction, as_it_was.reconstruction);

    let edited = found.with_edits(&places).unwrap();
    let OnOrthophoto::ByHand { linked, images: 8, points: 4, in_crs: false, .. } = outcome(&edited) else { panic!("{}", outcome(&edited)) };
    assert!(linked >= 4, "{linked}");
    assert!(
        edited.model.origin.is_none()
            && !matches!(BlockVerdict::of(&edited), BlockVerdict::Weak { overview_warning: OverviewWarning::NotOnOrthophoto { .. }, .. })
    );
    holds(&edited, &found.with_edits(&by_hand(0, &corners(), 0.0)).unwrap());
    // Places that are found once more and do not suffice are said of the block as it was found: these hold it where they brought it.
    let again = BlockLinks::default().linked(&edited, reference, &options()).unwrap();
    assert_eq!(again, edited);
    let without = BlockRun { orthophoto: None, ..found.clone() }.with_edits(&places).unwrap();
    assert_eq!(BlockLinks::default().linked(&without, reference, &options()).unwrap(), edited);
    // Nor do edits of a block that lies nowhere else go.
    let restored = found.with_edits(&[BlockEdit::RestorePoints { points: vec![tie_point] }]).unwrap();
    assert_eq!(BlockLinks::default().linked(&restored, reference, &options()).unwrap(), restored);
    // Undone, it is what it was.
    assert_eq!(edited.found(), found);
    let tiepoint::Project::Block(again) = read_project(write_block_project(&edited).unwrap().as_bytes()).unwrap() else {
        panic!("a block")
    };
    assert_eq!(again.with_edits(&places[..third]).unwrap(), two);

    // What is to be said of the orthophoto is said as long as a place of it is there, of each kind once.
    let heights = Remark::OrthophotoHeights { heights: "EGM96".into(), from_ellipsoid: false, crs: "EPSG:4979".into(), above_m: None };
    let of_another_kind = Remark::UnknownColumns { columns: vec!["x".into()] };
    let mut noted = places.clone();
    for edit in &mut noted {
        if let BlockEdit::AddControl { remarks, .. } = edit {
            *remarks = vec![heights.clone(), of_another_kind.clone()];
        }
    }
    let said = found.with_edits(&noted).unwrap();
    assert_eq!(said.remarks, [found.remarks.as_slice(), std::slice::from_ref(&heights)].concat());
    assert_eq!(said.found(), found);
    let known = BlockRun { remarks: vec![heights.clone()], ..found.clone() };
    assert_eq!(known.with_edits(&noted).unwrap().remarks, std::slice::from_ref(&heights));
    assert_eq!(known.with_edits(&noted).unwrap().found(), known);
    let tiepoint::Project::Block(again) = read_project(write_block_project(&said).unwrap().as_bytes()).unwrap() else { panic!("a block") };
    assert_eq!(*again, said);
}

#[test]
fn control_points_that_cannot_be_added_are_refused_by_their_edit() {
    let found = linked(block());
    let (reference, _) = own();
    let at = corners()[0].0;
    let add = control_by_hand(1, [at[0] + FAR[0], at[1] + FAR[1]], reference, None, &options()).unwrap();
    let refused = |edits: &[BlockEdit]| found.with_edits(edits).unwrap_err().to_string();
    let told = refused(&[add.clone(), add.clone()]);
    assert!(told.contains("\"orthophoto_hand_1\", which is empty or that of another one") && told.contains("(edit 2)"), "{told}");
    let BlockEdit::AddControl { position, .. } = add.clone() else { panic!("{add:?}") };
    let named = |name: &str, position: [f64; 3], standard_errors: Option<[f64; 2]>, sigma_px: Option<f64>| BlockEdit::AddControl {
        name: name.into(),
        position,
        standard_errors,
        sigma_px,
        role: ControlRole::Control,
        epsg: None,
        remarks: Vec::new(),
    };
    assert!(refused(&[named("orthophoto_1", position, None, None)]).contains("that of another one"));
    assert!(refused(&[named("", position, None, None)]).contains("which is empty"));
    let told = refused(&[named("P", position, Some([0.1, -1.0]), None)]);
    assert!(told.contains("got [0.1, -1.0] for P; allowed: numbers above 0"), "{told}");
    for sigma_px in [0.0, -1.0, f64::NAN] {
        let told = refused(&[add.clone(), named("P", position, None, Some(sigma_px))]);
        assert!(told.contains(&format!("got {sigma_px} in GCP P; allowed: 0.01 to 100")) && told.contains("(edit 2)"), "{told}");
    }
    for x in [f64::NAN, f64::INFINITY, 1e9] {
        let told = refused(&[add.clone(), named("P", [x, position[1], position[2]], None, None)]);
        assert!(told.contains("in GCP P; allowed: -1") && told.contains("(edit 2)"), "{told}");
    }
    // What is not added yet is not measured.
    let given = parse_ground_control_points(&found.input.control.as_ref().unwrap().points).unwrap();
    let given = given.iter().filter(|row| row.role.is_some()).count();
    let measure = BlockEdit::Measure { point: PointSource::GroundControl(given), image: 0, x_px: 10.0, y_px: 10.0, by: MeasuredBy::Hand };
    assert!(refused(&[measure, add.clone()]).contains("(edit 1)"));
    assert!(refused(&[BlockEdit::SetUse { point: given, role: None }, add]).contains("(edit 1)"));
}
