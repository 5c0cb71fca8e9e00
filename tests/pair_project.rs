//! The project file of a pair: it holds all that was known, gives the same back, and refuses what is damaged.

use std::collections::BTreeSet;
use std::sync::OnceLock;
use tiepoint::{
    DenseTruth, EditedMatch, Error, GreyImage, Match, NoOrientation, PairEdit, PairEdits, PairImage, PairInput, PairPhoto, PairResult,
    PairRun, PairSettings, PairTruth, PhotoInput, Project, ProjectKind, Refinement, Sample, Strategy, match_pair, project_kind,
    read_project, sample_pair, score_matches, write_pair_project,
};

fn sample() -> &'static Sample {
    static SAMPLE: OnceLock<Sample> = OnceLock::new();
    SAMPLE.get_or_init(|| sample_pair(1).unwrap())
}

fn dense_truth() -> DenseTruth<'static> {
    let Sample { left, right, right_position, .. } = sample();
    let (left_width, left_height) = (left.width(), left.height());
    DenseTruth { right_position, left_width, left_height, right_width: right.width(), right_height: right.height() }
}

/// What is known of the sample.
fn known() -> PairInput {
    let photo = |fiducials: &[tiepoint::Fiducial], origin| PhotoInput {
        fiducials: fiducials.to_vec(),
        origin: Some(origin),
        ..PhotoInput::default()
    };
    let sample = sample();
    PairInput {
        camera: Some(sample.camera),
        left: photo(&sample.left_fiducials, sample.left_origin),
        right: photo(&sample.right_fiducials, sample.right_origin),
        offset: None,
    }
}

fn matched(left: &GreyImage, right: &GreyImage, input: &PairInput, settings: &PairSettings) -> PairResult {
    let [left, right] = [left, right].map(|image| PairImage { grey: image.view(), exif: None, mask: None });
    match_pair(left, right, input, settings).unwrap()
}

fn photo(name: &str, image: &GreyImage) -> PairPhoto {
    PairPhoto {
        name: name.into(),
        content: Some("00".repeat(32)),
        width_px: image.width(),
        height_px: image.height(),
        format: "PNG".into(),
        bits_per_sample: 8,
        mask: Some("a \"mask\".png".into()),
        camera: None,
    }
}

fn run(input: PairInput, settings: PairSettings, result: PairResult, truth: Option<PairTruth>) -> PairRun {
    let images = [photo("left.png", &sample().left), photo("=right, 1.png", &sample().right)];
    PairRun::new(images, (input, settings), result, truth).unwrap()
}

fn strategy(strategy: Strategy) -> PairSettings {
    let mut settings = PairSettings::default();
    settings.matching.strategy = strategy;
    settings
}

/// The sample by moments refined by least squares matching, with its truth.
pub fn refined() -> &'static PairRun {
    static REFINED: OnceLock<PairRun> = OnceLock::new();
    REFINED.get_or_init(|| {
        let mut settings = strategy(Strategy::Moments);
        settings.matching.refine = Some(Refinement::LeastSquares);
        settings.orientation.base_mm = Some(sample().base_mm);
        let result = matched(&sample().left, &sample().right, &known(), &settings);
        let positions = |m: &Match| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]];
        let matches: Vec<[f64; 4]> = result.matching.matches.iter().map(positions).collect();
        let points: Vec<[f64; 2]> = result.left.points.iter().map(|p| [p.x, p.y]).collect();
        let score = score_matches(&matches, &points, &dense_truth()).unwrap();
        let truth = PairTruth { orientation: sample().truth, base_mm: sample().base_mm, score };
        run(known(), settings, result, Some(truth))
    })
}

fn read(text: &str) -> PairRun {
    match read_project(text.as_bytes()).unwrap() {
        Project::Pair(run) => *run,
        Project::Block(_) => panic!("a pair was written"),
    }
}

/// A file whose first line fits this body.
fn file(body: &str) -> String {
    let crc = crc32fast::hash(body.as_bytes());
    format!("{{\"format\":\"tiepoint-project\",\"version\":2,\"bytes\":{},\"crc32\":\"{crc:08x}\"}}\n{body}", body.len())
}

#[test]
fn a_pair_reads_back_as_it_was_and_gives_the_same_text() {
    let run = refined();
    let result = &run.result;
    let oriented = result.orientation.as_ref().unwrap();
    assert!(result.matching.matches.len() > 500 && result.matching.matches.iter().any(|found| found.fit.is_some()));
    assert!(oriented.points.iter().flatten().count() > 500 && oriented.total_standard_errors.is_some());
    let text = write_pair_project(run).unwrap();
    assert_eq!(&read(&text), run);
    assert_eq!(write_pair_project(&read(&text)).unwrap(), text);
    assert_eq!(project_kind(&text.as_bytes()[..1024]), Some(ProjectKind::Pair));
}

#[test]
fn a_pair_without_orientation_keeps_the_reason_with_its_figures() {
    let (left, right) = (&sample().left, &sample().right);
    let far = PairInput { offset: Some([4000.0, 0.0]), ..known() };
    let flat = GreyImage::new(80, 60, vec![50; 4800]).unwrap();
    let (moments, gradients) = (strategy(Strategy::Moments), strategy(Strategy::Gradient));
    let cases = [
        (matched(left, right, &far, &moments), far, "too few"),
        (matched(left, right, &PairInput::default(), &moments), PairInput::default(), "no camera"),
        (matched(&flat, &flat, &known_digital(), &gradients), known_digital(), "no geometry"),
    ];
    for (result, input, told) in cases {
        let run = run(input, PairSettings::default(), result, None);
        let back = read(&write_pair_project(&run).unwrap());
        assert_eq!(back, run, "{told}");
        let (Err(before), Err(after)) = (&run.result.orientation, &back.result.orientation) else { panic!("{told}") };
        assert_eq!(before.to_string(), after.to_string());
        let kind = match after {
            NoOrientation::TooFewMatches { .. } => "too few",
            NoOrientation::NoCamera { .. } => "no camera",
            NoOrientation::NoGeometry { .. } => "no geometry",
            _ => "another",
        };
        assert_eq!(kind, told);
    }
}

/// A digital camera.
fn known_digital() -> PairInput {
    let camera = serde_json::from_str("{\"focal_mm\": 0.6, \"pixel_mm\": 0.001}").unwrap();
    PairInput { camera: Some(camera), ..PairInput::default() }
}

#[test]
fn gradients_without_a_camera_keep_geometry_scales_and_the_estimated_focal_length() {
    let settings = strategy(Strategy::Gradient);
    let result = matched(&sample().left, &sample().right, &PairInput::default(), &settings);
    let geometry = result.geometry.clone().unwrap().unwrap();
    assert!(!geometry.inliers.is_empty() && !result.left.frames.is_empty());
    let run = run(PairInput::default(), settings, result, None);
    let back = read(&write_pair_project(&run).unwrap());
    assert_eq!(back, run);
    assert_eq!(back.result.geometry.unwrap().unwrap().sigma_px, geometry.sigma_px);
}

#[test]
fn numbers_that_are_infinite_come_back() {
    let mut run = refined().clone();
    let Ok(orientation) = &mut run.result.orientation else { panic!("it is oriented") };
    (orientation.condition, orientation.last_step) = (f64::INFINITY, f64::INFINITY);
    orientation.points[0].as_mut().unwrap().detectable_mm = f64::INFINITY;
    assert_eq!(read(&write_pair_project(&run).unwrap()), run);
    let cause = tiepoint::Cause::Inseparable { condition: f64::INFINITY, most: 2e4 };
    let error = Error::Degenerate { computation: tiepoint::Computation::RelativeOrientation, cause };
    run.result.orientation = Err(NoOrientation::Refused { error });
    assert_eq!(read(&write_pair_project(&run).unwrap()), run);
}

/// Bytes of a file, damaged in one of five ways; the same number gives the same damage.
fn damaged(text: &str, number: usize) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    let at = number.wrapping_mul(2_654_435_761) % bytes.len();
    match number % 5 {
        0 => bytes.truncate(at),
        1 => bytes[at] ^= 1 << (number % 8),
        2 => drop(bytes.remove(at)),
        3 => bytes.insert(at, b'7'),
        _ => {
            let piece = bytes[at..(at + 9).min(bytes.len())].to_vec();
            bytes.splice(at..at, piece);
        }
    }
    bytes
}

#[test]
fn a_damaged_pair_gives_a_clear_error() {
    let text = write_pair_project(refined()).unwrap();
    for number in 0..100 {
        let error = read_project(&damaged(&text, number)).expect_err(&format!("damage {number} was not seen"));
        assert!(matches!(error, Error::UnreadableFile { .. }), "{number}: {error}");
        assert!(error.to_string().len() < 300, "{number}: {error}");
    }
}

/// Changes the JSON of a pair.
type Change = fn(&mut serde_json::Value);

#[test]
fn parts_that_do_not_fit_together_are_refused_although_the_checksum_fits() {
    let text = write_pair_project(refined()).unwrap();
    let body = text.split_once('\n').unwrap().1;
    let mut told = BTreeSet::new();
    let cases: [(&str, Change); 6] = [
        ("verdicts of the pair", |pair| drop(pair["result"]["matching"]["verdicts"].as_array_mut().unwrap().pop())),
        ("match of the pair", |pair| pair["result"]["matching"]["matches"][0]["left"] = 10_000_000.into()),
        ("observations of the pair", |pair| drop(pair["result"]["orientation"]["Ok"]["points"].as_array_mut().unwrap().pop())),
        ("rejected match", |pair| pair["result"]["orientation"]["Ok"]["rejected"] = vec![9_999_999].into()),
        ("scores of the pair", |pair| drop(pair["truth"]["score"]["rightness"].as_array_mut().unwrap().pop())),
        ("extra: unknown field", |pair| pair["extra"] = 1.into()),
    ];
    for (expected, change) in cases {
        let mut whole: serde_json::Value = serde_json::from_str(body).unwrap();
        change(&mut whole["pair"]);
        let error = read_project(file(&whole.to_string()).as_bytes()).unwrap_err().to_string();
        assert!(error.contains(expected), "{expected}: {error}");
        told.insert(error);
    }
    assert_eq!(told.len(), 6);
}

#[test]
fn settings_that_a_file_does_not_name_take_their_defaults() {
    let text = write_pair_project(refined()).unwrap();
    let mut whole: serde_json::Value = serde_json::from_str(text.split_once('\n').unwrap().1).unwrap();
    whole["pair"]["settings"].as_object_mut().unwrap().remove("gradient");
    assert_eq!(&read(&file(&whole.to_string())), refined());
}

#[test]
fn the_kind_of_a_file_is_known_from_its_start() {
    let older = include_bytes!("project/version-1.tiepoint");
    assert_eq!(project_kind(&older[..200]), Some(ProjectKind::Block));
    for other in [&b""[..], b"\n", b"{\"pair\":", b"no project\n{}", &[0xff, b'\n', 0xfe]] {
        assert_eq!(project_kind(other), None);
    }
}

/// The pair with its first match rejected by hand, which its result has no more, and one that was measured.
fn edited() -> PairRun {
    let found = refined().result.matching.clone();
    let mut run = PairRun { truth: None, ..refined().clone() };
    let PairResult { left, matching, orientation, .. } = &mut run.result;
    let of = |m: &Match| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]];
    let (first, last) = (found.matches[0], found.matches[1]);
    matching.matches.remove(0);
    matching.verdicts[first.left].rule = tiepoint::Rule::NoCandidate;
    left.points.push(left.points[last.left]);
    matching.verdicts.push(tiepoint::Verdict { best: None, fit: None, ..matching.verdicts[last.left] });
    matching.matches.push(Match { left: left.points.len() - 1, right: None, measure: -1.0, fit: None, ..last });
    *orientation = Err(NoOrientation::PureRotation);
    let edits = vec![
        PairEdit::Reject { of: vec![EditedMatch::Found(of(&first))] },
        PairEdit::Add { id: 1, at: of(&last) },
        PairEdit::Move { of: EditedMatch::Measured(1), to: of(&last) },
        PairEdit::Restore { of: vec![EditedMatch::Measured(1)] },
    ];
    run.edited(PairEdits { edits, found }).unwrap()
}

#[test]
fn edits_are_kept_with_the_matches_that_were_found() {
    let run = edited();
    let text = write_pair_project(&run).unwrap();
    assert!(text.starts_with("{\"format\":\"tiepoint-project\",\"version\":3,"), "{}", &text[..60]);
    assert!(text.contains(r#"{"kind":"move","of":1,"to":["#));
    let back = read(&text);
    assert_eq!(back, run);
    assert_eq!(back.edited.as_ref().unwrap().found, refined().result.matching);
    assert_eq!(write_pair_project(&back).unwrap(), text);
    // Without any it is the file of a pair that was never edited, which older versions read.
    let none = PairEdits { edits: Vec::new(), found: refined().result.matching.clone() };
    let plain = refined().clone().edited(none.clone()).unwrap();
    assert_eq!(write_pair_project(&plain).unwrap(), write_pair_project(refined()).unwrap());
    let empty = PairRun { edited: Some(none), ..refined().clone() };
    assert_eq!(write_pair_project(&empty).unwrap(), write_pair_project(refined()).unwrap());
}

#[test]
fn edits_of_another_pair_are_refused() {
    let PairEdits { edits, found } = edited().edited.unwrap();
    let told = |edits: Vec<PairEdit>, found: tiepoint::MatchSet| {
        refined().clone().edited(PairEdits { edits, found }).expect_err("it does not fit").to_string()
    };
    let mut more = found.clone();
    more.verdicts.extend(found.verdicts.iter().filter(|verdict| verdict.rule != tiepoint::Rule::Matched).take(1));
    assert!(told(edits.clone(), more).contains("found matches of the pair: got verdicts"));
    let mut beyond = found.clone();
    beyond.matches[0].right = Some(9_999_999);
    assert!(told(edits.clone(), beyond).contains("match of the pair"));
    let mut fewer = found.clone();
    fewer.matches.pop();
    assert!(told(edits, fewer).contains("matched points of the pair"));
    let nowhere = PairEdit::Add { id: 2, at: [1.0, f64::NAN, 1.0, 1.0] };
    assert!(told(vec![nowhere], found).contains("place of an edited match: got NaN"));
}
