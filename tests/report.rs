//! The report: whole, self-contained, the same every time; and the tracked reports of the project's own pairs.

use super::read::assert_arabic;
use std::fs;
use std::path::{Path, PathBuf};
use tiepoint::{
    CameraOrigin, CameraUncertainty, Denominator, ExifCamera, Flight, GreyImage, Match, Operator, PairImage, PairInput, PairResult,
    PairSettings, PhotoInput, Preset, Refinement, Report, ReportEdits, ReportImage, ReportStep, ReportTruth, Sample, Strategy, Texts,
    match_pair, orient_matches, simulate,
};

/// The report of a flight, as `tiepoint simulate` and `tiepoint report` make it.
fn report_of(flight: &Flight, name: &str) -> Report {
    report_with(flight, name, |settings, base_mm| settings.orientation.base_mm = Some(base_mm))
}

/// The report of a flight by settings that `change` makes of the defaults and the true base in mm.
fn report_with(flight: &Flight, name: &str, change: impl Fn(&mut PairSettings, f64)) -> Report {
    let Sample { left, right, camera, left_fiducials, right_fiducials, left_origin, right_origin, base_mm, truth, right_position } =
        simulate(flight).unwrap();
    let image = |side: &str, grey: GreyImage| ReportImage { name: format!("{name} {side}"), grey, exif: None, mask: None };
    let photo = |fiducials, origin| PhotoInput { fiducials, origin: Some(origin), ..PhotoInput::default() };
    let input = PairInput {
        camera: Some(camera),
        left: photo(left_fiducials, left_origin),
        right: photo(right_fiducials, right_origin),
        offset: None,
    };
    let mut settings = PairSettings::default();
    change(&mut settings, base_mm);
    let truth = ReportTruth { orientation: truth, base_mm, right_position };
    Report::new([image("left", left), image("right", right)], input, settings, Some(truth))
}

/// Compares with a tracked report, or rewrites it where `TIEPOINT_REPORT=write` says so.
fn check_tracked(preset: Preset, name: &str, file: &str) {
    let html = report_of(&preset.flight(), name).html(Texts::english()).unwrap();
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(file);
    if std::env::var("TIEPOINT_REPORT").as_deref() == Ok("write") {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, &html).unwrap();
    }
    let tracked = fs::read_to_string(&path).unwrap_or_default();
    assert!(tracked == html, "docs/{file} is not what the report is now: TIEPOINT_REPORT=write cargo test --lib integration::report::");
}

#[test]
fn the_report_of_the_sample_is_the_tracked_one() {
    check_tracked(Preset::Sample, "sample", "sample-report.html");
}

#[test]
fn the_report_of_the_papers_geometry_is_the_tracked_one() {
    check_tracked(Preset::Paper, "paper", "paper-report.html");
}

/// A flight that is matched in a moment.
fn small() -> Flight {
    Flight { width_px: 200, height_px: 220, ..Flight::default() }
}

#[test]
fn a_report_is_whole_and_refers_to_nothing_outside() {
    let html = report_of(&small(), "small").html(Texts::english()).unwrap();
    for part in [
        "Table 1.",
        "Table 2.",
        "Table 3.",
        "least squares",
        "invariants",
        "correlation",
        "Reliability",
        "Parameters",
        "matching.strategy",
        "46\u{202f}695",
        "0.0477",
        "data:image/png;base64,",
    ] {
        assert!(html.contains(part), "no {part}");
    }
    assert!(html.starts_with("<!DOCTYPE html>") && html.ends_with("</html>"));
    // References: data of its own, and names within the page.
    for (at, _) in html.match_indices("href=\"") {
        let rest = &html[at + 6..];
        assert!(rest.starts_with("data:") || rest.starts_with('#'), "{}", &rest[..60]);
    }
    assert!(!html.contains("<script") && !html.contains("http:") && !html.contains("https:"));
    assert_eq!(html, report_of(&small(), "small").html(Texts::english()).unwrap());
}

#[test]
fn a_report_in_arabic_is_arabic_and_has_the_same_figures() {
    let mut made = report_of(&small(), "small");
    let (html, english) = (made.html(Texts::arabic()).unwrap(), made.html(Texts::english()).unwrap());
    assert_arabic(&html, &["small left", "small right"]);
    assert!(super::read::english(&english, &["small left", "small right"]).len() > 100);
    for part in ["الجدول 3.", "المربعات الصغرى", "matching.strategy", "46\u{202f}695", "0.0477", "المستعملة"] {
        assert!(html.contains(part), "no {part}");
    }
    // Numbers are written as in English, with Western digits.
    let figures = |html: &str| -> Vec<String> {
        let cells = html.split("<td>").skip(1).map(|cell| cell[..cell.find('<').unwrap()].to_string());
        cells.filter(|cell| cell.contains(|c: char| c.is_ascii_digit()) && !cell.contains(char::is_alphabetic)).collect()
    };
    assert_eq!(figures(&html), figures(&english));
    assert!(!html.contains(|c: char| ('٠'..='٩').contains(&c)));
    let steps: Vec<String> = made.steps().iter().map(|step| Texts::arabic().text(step)).collect();
    assert_eq!(steps[0], "هذا التشغيل");
}

#[test]
fn a_pair_without_camera_or_truth_has_a_report_that_says_so() {
    let flight = simulate(&small()).unwrap();
    let image = |grey: GreyImage| ReportImage { name: "<b>&\"x\"</b>.png".into(), grey, exif: None, mask: None };
    let mut settings = PairSettings::default();
    settings.matching.strategy = tiepoint::Strategy::Moments;
    let mut report = Report::new([image(flight.left), image(flight.right)], PairInput::default(), settings, None);
    let steps: Vec<String> = report.steps().iter().map(ToString::to_string).collect();
    assert_eq!(steps, ["this run", "moments", "invariants", "correlation", "least squares", "gradients"]);
    let mut steps = 0;
    while report.step().unwrap() {
        steps += 1;
    }
    assert_eq!(steps, 6);
    let html = report.html(Texts::english()).unwrap();
    assert!(html.contains("Not oriented: no camera") && !html.contains("against the truth"));
    assert!(html.contains("there are no photo coordinates") && !html.contains("follow from the pixel size"));
    assert!(html.contains("&lt;b&gt;") && !html.contains("<b>&"));
}

#[test]
fn bad_settings_are_refused() {
    let flight = simulate(&small()).unwrap();
    let image = |grey: GreyImage| ReportImage { name: "a".into(), grey, exif: None, mask: None };
    let mut settings = PairSettings::default();
    settings.matching.search = 4;
    let refused =
        Report::new([image(flight.left), image(flight.right)], PairInput::default(), settings, None).html(Texts::english()).unwrap_err();
    assert!(refused.is_usage() && refused.to_string().contains("search"), "{refused}");
}

/// The cells of the first row that begins with an unknown's symbol after a text.
fn row_after<'a>(html: &'a str, text: &str, symbol: &str) -> Vec<&'a str> {
    let rest = &html[html.find(text).unwrap()..];
    let row = &rest[rest.find(&format!("<th><i>{symbol}</i>")).unwrap()..];
    row[..row.find("</tr>").unwrap()].split("<td>").skip(1).collect()
}

#[test]
fn true_errors_do_not_depend_on_the_base_but_by_scale() {
    let of = |change: fn(&mut PairSettings, f64)| report_with(&small(), "small", change).html(Texts::english()).unwrap();
    let (own, double) = (of(|s, base| s.orientation.base_mm = Some(base)), of(|s, base| s.orientation.base_mm = Some(2.0 * base)));
    // In standard errors, which follow the same scale, the true errors are the same.
    let ratios = |html: &str| -> Vec<String> {
        row_after(html, "true errors, and how many", "by").iter().map(|cell| cell[cell.find('(').unwrap()..].to_string()).collect()
    };
    assert_eq!(ratios(&own).len(), 6);
    assert_eq!(ratios(&own), ratios(&double));
    assert!(double.contains("at the scale of that base") && !own.contains("at the scale of that base"));
}

#[test]
fn sigma0_without_rejection_stands_beside_that_with_it() {
    let of =
        |robust: bool| report_with(&small(), "small", |settings, _| settings.orientation.robust = robust).html(Texts::english()).unwrap();
    let row = |html: &str, title: &str| -> Vec<f64> {
        let row = &html[html.find(&format!("<th>{title}</th>")).unwrap()..];
        let cells = row[..row.find("</tr>").unwrap()].split("<td>").skip(1).map(|cell| cell[..cell.find('<').unwrap()].parse());
        cells.map(|number| number.unwrap_or(f64::NAN)).collect()
    };
    let robust = of(true);
    let (kept, all) = (row(&robust, "σ₀, px"), row(&robust, "σ₀ of all matches, px"));
    assert_eq!(all.len(), 6);
    assert!(kept.iter().zip(&all).all(|(kept, all)| all >= kept), "{kept:?} {all:?}");
    assert!(kept.iter().zip(&all).any(|(kept, all)| *all > 1.1 * kept), "{kept:?} {all:?}");
    // Of all matches it is what an orientation without rejection estimates.
    let plain = of(false);
    assert_eq!(row(&plain, "σ₀, px"), row(&plain, "σ₀ of all matches, px"));
    assert_eq!(row(&plain, "σ₀, px"), all);
}

#[test]
fn what_sets_the_report_apart_from_the_paper_follows_the_settings() {
    let mut report = report_with(&small(), "small", |settings, _| {
        settings.matching.denominator = Denominator::Floor;
        settings.matching.parallax_neighbours = 0;
    });
    let html = report.html(Texts::english()).unwrap();
    assert!(html.contains("or the median magnitude of the moment where that is more, is the denominator"));
    assert!(html.contains("are rejected that are ambiguous or many to one: "));
}

#[test]
fn what_masks_leave_out_is_told_and_drawn() {
    let flight = simulate(&small()).unwrap();
    let half = |grey: &GreyImage| {
        let values = (0..grey.data().len()).map(|k| if k % grey.width() < grey.width() / 2 { 0 } else { 255 }).collect();
        GreyImage::new(grey.width(), grey.height(), values).unwrap()
    };
    let report = |mask: Option<GreyImage>| {
        let left = ReportImage { name: "left".into(), grey: flight.left.clone(), exif: None, mask };
        let right = ReportImage { name: "right".into(), grey: flight.right.clone(), exif: None, mask: None };
        Report::new([left, right], PairInput::default(), PairSettings::default(), None)
    };
    let plain = report(None).html(Texts::english()).unwrap();
    let masked = report(Some(half(&flight.left))).html(Texts::english()).unwrap();
    assert!(masked.contains("A mask leaves out 50.0 % of the left image.") && !masked.contains("of the right image."));
    assert_eq!(masked.matches("class=\"left-out\"").count(), 1);
    assert!(!plain.contains("leaves out") && !plain.contains("left-out"));
    let points = |html: &str| -> usize {
        let rest = &html[html.find("<figcaption>left: ").unwrap() + 18..];
        rest[..rest.find(" points").unwrap()].chars().filter(char::is_ascii_digit).collect::<String>().parse().unwrap()
    };
    assert!(points(&masked) > 0 && points(&masked) < points(&plain));
    let strange = report(Some(GreyImage::new(7, 5, vec![0; 35]).unwrap())).html(Texts::english()).unwrap_err();
    assert!(strange.to_string().contains("mask"), "{strange}");
}

/// The cells of a row of a table after a text.
fn cells_after(html: &str, text: &str, head: &str) -> Vec<String> {
    let rest = &html[html.find(text).unwrap()..];
    let row = &rest[rest.find(&format!("<th>{head}</th>")).unwrap_or_else(|| panic!("no {head}"))..];
    let cells = row[..row.find("</tr>").unwrap()].split("<td").skip(1);
    cells.map(|cell| cell[cell.find('>').unwrap() + 1..cell.find("</td>").unwrap()].to_string()).collect()
}

/// The small flight as its run takes it, by moments on the paper's points: as the strategy of that name of a report.
fn by_moments() -> ([GreyImage; 2], PairInput, PairSettings) {
    let Sample { left, right, camera, left_fiducials, right_fiducials, left_origin, right_origin, base_mm, .. } =
        simulate(&small()).unwrap();
    let photo = |fiducials, origin| PhotoInput { fiducials, origin: Some(origin), ..PhotoInput::default() };
    let input = PairInput {
        camera: Some(camera),
        left: photo(left_fiducials, left_origin),
        right: photo(right_fiducials, right_origin),
        offset: None,
    };
    let mut settings = PairSettings::default();
    settings.matching.strategy = Strategy::Moments;
    settings.matching.refine = Some(Refinement::None);
    settings.points.operator = Some(Operator::Ground2);
    settings.orientation.base_mm = Some(base_mm);
    ([left, right], input, settings)
}

fn images_of(images: [GreyImage; 2]) -> [ReportImage; 2] {
    images.map(|grey| ReportImage { name: "small.png".into(), grey, exif: None, mask: None })
}

#[test]
fn a_report_of_edited_matches_is_of_them_and_says_so() {
    let (images, input, settings) = by_moments();
    let [left, right] = images.each_ref().map(|grey| PairImage { grey: grey.view(), exif: None, mask: None });
    let PairResult { matching, interior, left: points, .. } = match_pair(left, right, &input, &settings).unwrap();
    let plain = Report::new(images_of(images.clone()), input.clone(), settings.clone(), None).html(Texts::english()).unwrap();
    assert!(!plain.contains("by hand") && plain.contains("<th>this run</th>"));
    // A third is rejected by hand, and a point is added.
    let mut matches: Vec<Match> = matching.matches.iter().enumerate().filter(|(k, _)| k % 3 != 0).map(|(_, kept)| *kept).collect();
    let rejected = matching.matches.len() - matches.len();
    let added = Match { left: points.points.len(), right: None, measure: -1.0, fit: None, ..matches[0] };
    matches.push(Match {
        left_px: [added.left_px[0] + 0.25, added.left_px[1]],
        right_px: [added.right_px[0] + 0.25, added.right_px[1]],
        ..added
    });
    let oriented = orient_matches(&matches, &interior.unwrap(), &settings.orientation).unwrap();
    let used = matches.len() - oriented.rejected.len();
    let edits = ReportEdits { added_px: vec![matches[matches.len() - 1].left_px], rejected, measured: 1, matches };
    let mut report = Report::new(images_of(images), input, settings, None).edited(edits.clone());
    assert_eq!(report.steps()[..2], [ReportStep::ThisRunEdited, ReportStep::Moments]);
    let html = report.html(Texts::english()).unwrap();
    assert!(html.contains(&format!("Edits by hand: {rejected} matches rejected, 1 measured.")));
    assert!(html.contains(&format!("{} matches of {} left points", edits.matches.len(), points.points.len() + 1)));
    assert!(html.contains(&format!("Oriented from {used} points")) || html.contains(&format!("from {used} points")));
    // Values, counts and errors of this run are those of the edited matches; the strategy of the same settings is as it was found.
    let [with, without] = [&html, &plain].map(|html| cells_after(html, "Table 2.", "matches used"));
    assert_eq!(with[0], used.to_string());
    assert_eq!(with[1..], without[1..]);
    assert_ne!(with[0], without[0]);
    assert_eq!(without[0], without[1]);
    let by_hand = cells_after(&html, "What became of the left points", "of the matched: rejected by hand");
    assert_eq!(by_hand, [rejected.to_string().as_str(), "–", "–", "–", "–", "–"]);
    let kappa = row_after(&html, "Table 3.", "κ");
    let digits = kappa[0][kappa[0].find('.').unwrap() + 1..].find('<').unwrap();
    assert!(kappa[0].starts_with(&format!("{:.digits$}<", oriented.parameters.kappa_deg).replace('-', "−")), "{}", kappa[0]);
}

#[test]
fn errors_and_what_they_belong_to_have_two_significant_digits_of_them() {
    // by and bz and their errors are a ten-thousandth of the true ones.
    let html = report_with(&small(), "small", |settings, base_mm| settings.orientation.base_mm = Some(1e-4 * base_mm))
        .html(Texts::english())
        .unwrap();
    for symbol in ["ω", "φ", "κ", "by", "bz"] {
        let text = |cell: &&str| cell[..cell.find('<').unwrap()].to_string();
        let errors: Vec<String> = row_after(&html, "Table 2.", symbol).iter().map(text).collect();
        let values: Vec<String> = row_after(&html, "Table 3.", symbol).iter().map(text).collect();
        assert_eq!((errors.len(), values.len()), (6, 6));
        for (error, value) in errors.iter().zip(&values).filter(|(error, _)| *error != "–") {
            let significant = error.trim_start_matches(['0', '.']).chars().filter(char::is_ascii_digit).count();
            // 0.0995 is written as 0.100.
            assert!(significant == 2 || (significant == 3 && error.ends_with("00")), "{symbol}: {error}");
            let digits = |number: &str| number.split('.').nth(1).map_or(0, str::len);
            assert_eq!(digits(error), digits(value), "{symbol}: {value} ± {error}");
        }
    }
    assert!(!html.contains("ellipse of 0.000") && !html.contains("ellipse 0.0 ×"));
}

#[test]
fn a_report_names_its_cameras_and_where_they_come_from() {
    let (images, input, settings) = by_moments();
    let report = |input: &PairInput, exif: Option<ExifCamera>, settings: &PairSettings| {
        let images = images_of(images.clone()).map(|image| ReportImage { exif: exif.clone(), ..image });
        Report::new(images, input.clone(), settings.clone(), None).html(Texts::english()).unwrap()
    };
    let camera = input.camera.unwrap();
    // A given camera of measured marks is known without error.
    let given = report(&input, None, &settings);
    assert_eq!(cells_after(&given, "<caption>Cameras", "From"), ["given"; 2]);
    let focal = format!("{}", camera.focal_mm);
    assert_eq!(cells_after(&given, "<caption>Cameras", "Focal length, mm"), [focal.as_str(); 2]);
    let focal_px: f64 = cells_after(&given, "<caption>Cameras", "Focal length, px")[0].parse().unwrap();
    assert!((focal_px * 0.254 / camera.focal_mm - 1.0).abs() < 0.01, "{focal_px} px");
    assert!(!given.contains(">estimated<") && !given.contains("The size of a pixel is not known"));
    // What is not known of one stands beside it. These few matches tell no more of it.
    let hardly = PairInput { camera: Some(tiepoint::CameraMm { uncertainty: Some(CameraUncertainty::EXIF), ..camera }), ..input.clone() };
    assert_eq!(cells_after(&report(&hardly, None, &settings), "<caption>Cameras", "Focal length, mm"), ["153.4 ± 7.7"; 2]);
    // What the file of a digital photo names, without marks.
    let exif = ExifCamera {
        make: Some("Maker".into()),
        model: Some("M1".into()),
        focal_mm: 24.0,
        pixel_mm: Some(0.06),
        origin: CameraOrigin::Exif35Mm,
        ..ExifCamera::default()
    };
    let digital = report(&PairInput::default(), Some(exif), &settings);
    let from = cells_after(&digital, "<caption>Cameras", "From");
    assert!(from[0].starts_with("EXIF (35 mm equivalent): Maker M1"), "{from:?}");
    assert!(cells_after(&digital, "<caption>Cameras", "Focal length, mm")[0].starts_with("24.0 ± 1.2"));
    assert!(cells_after(&digital, "<caption>Cameras", "Focal length, px")[0].starts_with("400 ± 20"));
    // A focal length in px has no mm.
    let in_px = report(&PairInput { camera: Some(tiepoint::CameraMm::of_focal_px(400.0)), ..PairInput::default() }, None, &settings);
    assert!(in_px.contains("<th>Focal length, px</th>") && !in_px.contains("<th>Focal length, mm</th>"));
    assert!(in_px.contains("The size of a pixel is not known"));
}

#[test]
fn a_strategy_that_is_not_oriented_has_used_no_matches_and_a_run_by_it_says_what_would_do() {
    let nowhere = |settings: &mut PairSettings, _: f64| {
        settings.matching.strategy = Strategy::Moments;
        // Nothing is found that is not where it is expected to the pixel.
        (settings.matching.search, settings.matching.max_measure) = (1, 0.01);
    };
    let mut report = report_with(&small(), "small", nowhere);
    assert_eq!(report.verdict(), None);
    let html = report.html(Texts::english()).unwrap();
    let verdict = report.verdict().unwrap();
    assert!(verdict.to_string().starts_with("Not oriented: "), "{verdict}");
    let row = html.split("<th>matches used</th>").nth(1).unwrap().split("</tr>").next().unwrap();
    let cells: Vec<&str> = row.split("<td>").skip(1).map(|cell| cell.split("</td>").next().unwrap()).collect();
    assert_eq!(cells[0], "not oriented", "{row}");
    assert!(cells.iter().any(|cell| cell.parse::<usize>().is_ok_and(|used| used > 100)), "{row}");
    assert!(html.contains("the strategy “auto”"), "no hint");
}
