//! Many edits of a block by hand, undone and redone as a user does.

use super::shown::shown;
use std::fs;
use std::time::Instant;
use tiepoint::{
    BlockEdit, BlockFlight, BlockRun, BlockScene, BlockSettings, ControlRole, ControlTexts, HandMeasurement, MeasuredBy, MultiscaleOptions,
    ObservationPart, PairOutcome, PointDetail, PointImage, PointSource, Project, RunInput, point_detail, read_project, run_block,
    write_block_project,
};

const OPERATIONS: usize = 100_000;
/// The block is adjusted anew after so many.
const ADJUSTED_EVERY: usize = 10_000;

/// A small block with surveyed points.
fn surveyed_block() -> BlockRun {
    let folder = std::env::temp_dir().join(format!("tiepoint-long-histories-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let flight = BlockFlight {
        strips: 2,
        exposures: 3,
        width_px: 480,
        height_px: 360,
        pixel_mm: 0.12,
        relief_m: 30.0,
        seed: 5,
        ..BlockFlight::default()
    };
    let scene = BlockScene::new(&flight).unwrap();
    let photo = |index: usize| {
        let path = folder.join(format!("photo_{index}.png"));
        fs::write(&path, scene.photo_file(index).unwrap()).unwrap();
        path
    };
    let photos: Vec<_> = (0..scene.photos()).map(photo).collect();
    let at_px = [[120.0, 90.0], [360.0, 90.0], [240.0, 180.0], [120.0, 270.0], [360.0, 270.0]];
    let places: Vec<_> = shown(&scene, &[1, 4], &at_px).into_iter().filter(|(_, seen)| seen.len() >= 3).collect();
    assert!(places.len() >= 4, "{}", places.len());
    let mut points = "name,x,y,z\n".to_string();
    let mut marks = "image,point,x,y\n".to_string();
    for (number, ([x, y, z], seen)) in places.iter().enumerate() {
        points += &format!("G{number},{x:.4},{y:.4},{z:.4}\n");
        seen.iter().for_each(|(image, [x, y])| marks += &format!("photo_{image}.png,G{number},{x:.3},{y:.3}\n"));
    }
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 1200, ..settings.features.multiscale };
    let focal_px = scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}, "fixed": true}}]}}"#));
    let input = RunInput { settings, cameras, use_gnss: false, control: Some(ControlTexts { points, marks }), ..RunInput::default() };
    let run = run_block(&photos, &[], input, &folder.join("work"), 2, drop).unwrap();
    fs::remove_dir_all(folder).unwrap();
    run
}

/// Numbers that look random, the same in every run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, count: usize) -> usize {
        // Knuth's MMIX.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % count
    }

    fn one<'a, T>(&mut self, of: &'a [T]) -> &'a T {
        &of[self.below(of.len())]
    }
}

/// What a user does with a block: each a step of the history.
struct Hands {
    tie_points: Vec<PointDetail>,
    surveyed: Vec<PointDetail>,
    images: Vec<usize>,
    /// Those that matches connect.
    pairs: Vec<[usize; 2]>,
    chance: Chance,
}

impl Hands {
    fn new(run: &BlockRun) -> Self {
        let details = (0..run.model.points.len()).map(|point| point_detail(run, point).unwrap());
        let (surveyed, tie_points): (Vec<_>, Vec<_>) = details.partition(|detail| matches!(detail.id, Some(PointSource::GroundControl(_))));
        let images: Vec<usize> = (0..run.model.images.len()).filter(|image| run.model.images[*image].pose.is_some()).collect();
        let matched = run.connections.iter().filter(|pair| matches!(pair.outcome, PairOutcome::Connected { .. }));
        let pairs = matched.map(|pair| pair.images.map(|image| image as usize));
        let pairs = pairs.filter(|pair| pair.iter().all(|image| images.contains(image))).collect();
        Self { tie_points, surveyed, images, pairs, chance: Chance(15) }
    }

    /// A step that can be done whatever was done before. `manual`: how many points were added before.
    fn step(&mut self, manual: u32) -> Vec<BlockEdit> {
        let detail = self.chance.one(&self.tie_points).clone();
        let point = detail.id.unwrap();
        let seen = self.chance.one(&detail.observations).clone();
        let observations = vec![PointImage { point, image: seen.image }];
        let points = vec![point];
        let at =
            |by| BlockEdit::Measure { point, image: seen.image, x_px: seen.x_px.clamp(1.0, 479.0), y_px: seen.y_px.clamp(1.0, 359.0), by };
        match self.chance.below(15) {
            0 => vec![BlockEdit::RejectObservations { observations }],
            1 => vec![BlockEdit::RestoreObservations { observations }],
            2 => vec![BlockEdit::RejectPoints { points }],
            3 => vec![BlockEdit::RestorePoints { points }],
            4 => vec![BlockEdit::RestorePoints { points }, at(MeasuredBy::Hand)],
            5 => vec![BlockEdit::RestorePoints { points }, at(MeasuredBy::LeastSquares)],
            // One image at most is left out: the others hold together.
            6 => vec![
                BlockEdit::RestoreImages { images: self.images.clone() },
                BlockEdit::RejectImages { images: vec![*self.chance.one(&self.images)] },
            ],
            7 => vec![BlockEdit::RestoreImages { images: self.images.clone() }],
            8 => split(&detail),
            9 => vec![BlockEdit::AddPoint { observations: measured(&detail) }],
            10 if manual > 0 => {
                let points = vec![PointSource::Manual(self.chance.below(manual as usize) as u32)];
                vec![if self.chance.below(2) == 0 { BlockEdit::RejectPoints { points } } else { BlockEdit::RestorePoints { points } }]
            }
            11 => {
                let PointSource::GroundControl(point) = self.chance.one(&self.surveyed).id.unwrap() else {
                    unreachable!("of surveyed points")
                };
                vec![BlockEdit::SetUse { point, role: *self.chance.one(&[None, Some(ControlRole::Check), Some(ControlRole::Control)]) }]
            }
            // As with images.
            12 => vec![
                BlockEdit::RestorePairs { pairs: self.pairs.clone() },
                BlockEdit::RejectPairs { pairs: vec![*self.chance.one(&self.pairs)] },
            ],
            13 => vec![BlockEdit::RestorePairs { pairs: self.pairs.clone() }],
            _ => joined(&detail, self.chance.one(&self.tie_points)),
        }
    }
}

fn measured(detail: &PointDetail) -> Vec<HandMeasurement> {
    let taking = detail.observations.iter().filter(|seen| seen.part == ObservationPart::Accepted);
    taking.map(|seen| HandMeasurement { image: seen.image, x_px: seen.x_px, y_px: seen.y_px, by: MeasuredBy::LeastSquares }).collect()
}

/// As the page splits a point: it is rejected, and others have its observations.
fn split(detail: &PointDetail) -> Vec<BlockEdit> {
    let observations = measured(detail);
    let parts: Vec<Vec<HandMeasurement>> = if observations.len() < 4 {
        vec![observations]
    } else {
        observations.chunks(2).filter(|part| part.len() == 2).map(<[_]>::to_vec).collect()
    };
    let rejected = BlockEdit::RejectPoints { points: vec![detail.id.unwrap()] };
    std::iter::once(rejected).chain(parts.into_iter().map(|observations| BlockEdit::AddPoint { observations })).collect()
}

/// As the page joins two points; they show two places, so that one has all observations of the first alone.
fn joined(first: &PointDetail, second: &PointDetail) -> Vec<BlockEdit> {
    let points = vec![first.id.unwrap(), second.id.unwrap()];
    vec![BlockEdit::RejectPoints { points }, BlockEdit::AddPoint { observations: measured(first) }]
}

#[test]
fn a_hundred_thousand_edits_that_are_undone_leave_the_bytes_of_the_project() {
    let found = surveyed_block();
    let bytes = write_block_project(&found).unwrap();
    let mut hands = Hands::new(&found);
    assert!(hands.tie_points.iter().any(|detail| detail.observations.len() >= 4) && hands.surveyed.len() >= 4);
    let started = Instant::now();

    // Steps, how many of them hold, and how many points the first of them add.
    let mut steps: Vec<Vec<BlockEdit>> = Vec::new();
    let mut added: Vec<u32> = vec![0];
    let mut done = 0;
    let in_force = |steps: &[Vec<BlockEdit>]| steps.concat();
    let mut block = found.clone();
    let (mut adjusted, mut kinds, mut longest) = (0, std::collections::BTreeSet::new(), 0);
    for operation in 1..=OPERATIONS {
        match hands.chance.below(20) {
            // Undone, by one step or several; done again; gone to anywhere in the list, which is rare.
            0..=7 => done -= (1 + hands.chance.below(2)).min(done),
            8..=9 => done = (done + 1).min(steps.len()),
            10 if hands.chance.below(400) == 0 => done = hands.chance.below(steps.len() + 1),
            _ => {
                steps.truncate(done);
                added.truncate(done + 1);
                let step = hands.step(added[done]);
                let new = step.iter().filter(|edit| matches!(edit, BlockEdit::AddPoint { .. })).count() as u32;
                kinds.extend(step.iter().map(|edit| format!("{edit:?}").split([' ', '{']).next().map(String::from)));
                added.push(added[done] + new);
                steps.push(step);
                done += 1;
            }
        }
        longest = longest.max(done);
        if operation % ADJUSTED_EVERY == 0 {
            let edits = in_force(&steps[..done]);
            block = block.with_edits(&edits).unwrap();
            assert_eq!(block.edits(), edits);
            adjusted += usize::from(block.model != found.model);
        }
    }
    assert_eq!(kinds.len(), 11, "{kinds:?}");
    assert!(adjusted >= 5 && longest > 80, "{adjusted} adjustments that changed the block, at most {longest} steps");

    // Some hold at the end; the same ones after all were undone and done again, from a file that was saved between.
    steps.truncate(done);
    while done < 50 {
        steps.push(vec![BlockEdit::RejectPoints { points: vec![hands.chance.one(&hands.tie_points).id.unwrap()] }]);
        done += 1;
    }
    let edited = block.with_edits(&in_force(&steps)).unwrap();
    let saved = write_block_project(&edited).unwrap();
    assert_ne!(saved, bytes);
    let Project::Block(again) = read_project(saved.as_bytes()).unwrap() else { unreachable!("a block was written") };
    let undone = again.with_edits(&[]).unwrap();
    assert_eq!(write_block_project(&undone).unwrap(), bytes);
    assert_eq!(write_block_project(&undone.with_edits(&in_force(&steps)).unwrap()).unwrap(), saved);
    println!("{OPERATIONS} operations, at most {longest} steps, {:.1} s", started.elapsed().as_secs_f64());
}
