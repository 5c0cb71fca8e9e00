//! The report of a block: whole, self-contained, with the figures of the other files.

use super::read::assert_arabic;
use std::fs;
use std::sync::OnceLock;
use tiepoint::{
    BlockFiles, BlockFlight, BlockRun, BlockScene, BlockSettings, BlockVerdict, ControlRole, ControlTexts, MultiscaleOptions,
    ObservationVerdict, PointSource, Project, RunInput, SurveyedPoint, Texts, images_in, read_project, run_block,
};

/// The name of an image and of points that would be markup. No file can have a slash in its name.
const HOSTILE: &str = "<script>alert('1')<\\script>&\"x\".pgm";

/// Three photos of a simulated block, one of another scene and one that cannot be read.
fn block(name: &str, control: impl Fn(&BlockScene, &[&str]) -> Option<ControlTexts>) -> BlockRun {
    let at = std::env::temp_dir().join(format!("tiepoint-{name}-{}", std::process::id()));
    fs::create_dir_all(&at).unwrap();
    let flight =
        |seed| BlockFlight { strips: 1, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.12, seed, ..BlockFlight::default() };
    let names = [HOSTILE, "b.pgm", "c.pgm"];
    let scene = BlockScene::new(&flight(1)).unwrap();
    let other = BlockScene::new(&flight(9)).unwrap();
    let photos = (0..3).map(|index| (names[index], scene.photo(index).unwrap())).chain([("other.pgm", other.photo(0).unwrap())]);
    for (name, photo) in photos {
        fs::write(at.join(name), [format!("P5 {} {} 255\n", photo.width(), photo.height()).as_bytes(), photo.data()].concat()).unwrap();
    }
    fs::write(at.join("broken.pgm"), b"P5 9").unwrap();
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 1200, ..settings.features.multiscale };
    let cameras = Some(r#"{"cameras": [{"focal_px": 708.33}]}"#.into());
    let input = RunInput { settings, cameras, control: control(&scene, &names), ..RunInput::default() };
    let run = run_block(&images_in(&at).unwrap(), &[], input, &at.join("work"), 2, |_| {}).unwrap();
    fs::remove_dir_all(at).unwrap();
    run
}

/// A free network.
fn free() -> &'static BlockRun {
    static RUN: OnceLock<BlockRun> = OnceLock::new();
    RUN.get_or_init(|| block("report-free", |_, _| None))
}

/// A block with ground control points, one of which is a check point.
fn controlled() -> &'static BlockRun {
    static RUN: OnceLock<BlockRun> = OnceLock::new();
    RUN.get_or_init(|| block("report-control", |scene, names| Some(control_of(scene, names))))
}

/// Nine points that the middle photo shows, and where all photos show them.
fn control_of(scene: &BlockScene, names: &[&str]) -> ControlTexts {
    let truth = scene.truth();
    let places: Vec<[f64; 2]> = [170.0, 240.0, 310.0].iter().flat_map(|x| [60.0, 180.0, 300.0].map(|y| [*x, y])).collect();
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let (mut points, mut marks) = ("name,x,y,z,use\n".to_string(), "image,point,x,y\n".to_string());
    for (number, position) in scene.surface_at(1, &places).unwrap().into_iter().enumerate() {
        let name = quoted(&format!("{HOSTILE}{number}"));
        let [x, y, z] = position;
        points += &format!("{name},{x},{y},{z},{}\n", if number == 4 { "check" } else { "control" });
        for (image, file) in truth.images.iter().zip(names) {
            let (camera, pose) = (&truth.cameras[image.camera], image.pose.unwrap());
            let [right, up, back] =
                [0, 1, 2].map(|row| (0..3).map(|k| pose.rotation[row][k] * (position[k] - pose.position[k])).sum::<f64>());
            let [middle_x, middle_y] = camera.principal_point_px;
            let (column, row) = (middle_x - camera.focal_px * right / back, middle_y + camera.focal_px * up / back);
            if (0.0..480.0).contains(&column) && (0.0..360.0).contains(&row) {
                marks += &format!("{},{name},{column},{row}\n", quoted(file));
            }
        }
    }
    ControlTexts { points, marks }
}

/// `report.html` of a block.
fn report(run: &BlockRun) -> String {
    report_in(Texts::english(), run)
}

fn report_in(texts: &Texts, run: &BlockRun) -> String {
    let mut html = None;
    let mut emit = |path: &str, text: &str| {
        if path == "report.html" {
            html = Some(text.to_string());
        }
        Ok(())
    };
    let mut files = BlockFiles::new(&[], None, texts);
    while files.step(run, &mut emit).unwrap().is_none() {}
    html.unwrap()
}

/// The cells of the first row under a heading whose own cell begins with a text.
fn row<'a>(html: &'a str, under: &str, first: &str) -> Vec<&'a str> {
    let rest = &html[html.find(under).unwrap_or_else(|| panic!("no {under}"))..];
    let body = &rest[rest.find("<tbody>").unwrap()..];
    let row = &body[body.find(&format!("<tr><th>{first}")).unwrap_or_else(|| panic!("no {first}: {body}"))..];
    row[..row.find("</tr>").unwrap()].split("<td").skip(1).map(|cell| cell.split(['>', '<']).nth(1).unwrap()).collect()
}

fn number(value: f64, digits: usize) -> String {
    format!("{value:.digits$}").replace('-', "−")
}

#[test]
fn a_report_is_whole_and_runs_nothing() {
    let Project::Block(older) = read_project(include_bytes!("project/version-1.tiepoint")).unwrap() else { unreachable!() };
    for run in [free(), controlled(), &older] {
        let html = &report(run);
        assert!(html.starts_with("<!DOCTYPE html>") && html.ends_with("</html>"));
        assert!(html.contains("default-src 'none'") && !html.contains("<script") && !html.contains("src=\"") && !html.contains("href="));
        assert!(!html.contains("http:") && !html.contains("https:") && !html.contains("NaN"));
        assert!(html.contains("selection.") && html.contains(&BlockVerdict::of(run).to_string()), "{html}");
        assert_eq!(*html, report(run));
    }
    let html = report(controlled());
    assert!(html.contains("&lt;script&gt;alert('1')") && html.contains("&amp;&quot;x&quot;.pgm"), "{html}");
    assert!(report(&older).contains("There are no standard errors."));
}

#[test]
fn a_report_has_the_figures_of_the_other_files() {
    let run = free();
    let (html, model) = (&report(run), &run.reconstruction.as_ref().unwrap().models[0]);
    let adjusted = &model.adjusted;
    let figure = |name: &str| {
        let rest = html.split(&format!("<dt>{name}</dt>")).nth(1).unwrap_or_else(|| panic!("no {name}: {html}"));
        rest.split("<dd>").nth(1).unwrap().split("</dd>").next().unwrap()
    };
    assert_eq!(figure("σ₀"), format!("{} px", number(adjusted.sigma0_px.unwrap(), 3)));
    assert_eq!(figure("RMSE of observations"), format!("{} px", number(adjusted.rmse_px, 3)));
    assert_eq!(figure("Images"), "3 oriented of 4 read; 1 could not be read");
    assert!(figure("Georeferenced by").starts_with("nothing"));
    for group in &adjusted.rmse_by_rays {
        let cells = row(html, "By the number of rays", &format!("{}<", group.rays));
        assert_eq!(cells, [group.points.to_string(), number(group.rmse_px, 3)]);
    }
    let rejected = model.rejected.len() + adjusted.rays.iter().filter(|ray| ray.verdict != ObservationVerdict::Accepted).count();
    assert_eq!(figure("Observations rejected"), rejected.to_string());
    assert!(html.contains(&format!("<p>{rejected} of ")), "{html}");
    // The title of the page, and that of the ellipse of each oriented image.
    assert_eq!(html.matches("<title>").count(), 1 + 3);
    let camera = &adjusted.cameras[0];
    assert_eq!(camera.correlations.len(), camera.standard_errors.iter().flatten().count());
    assert_eq!(html.contains("Correlations of the estimated parameters"), camera.correlations.len() > 1);
    // Intervals by Student's distribution, ellipses and ellipsoids by F.
    let factors = adjusted.factors_95().unwrap();
    assert!(
        html.contains(&format!("{} and {} times the standard ones", number(factors.ellipse, 2), number(factors.ellipsoid, 2))),
        "{html}"
    );
    assert!(html.contains(&format!("95 % of cases, {} times the standard error ellipses", number(factors.ellipse, 2))));
    let precision = row(html, "Standard errors of projection centres", "X₀");
    let half_width = html[html.find("Standard errors of projection centres").unwrap()..].split("± ").nth(2).unwrap().split('<').next();
    let errors: Vec<f64> = precision.iter().map(|cell| cell.trim().parse().unwrap()).collect();
    let ratio = half_width.unwrap().parse::<f64>().unwrap() / errors[0];
    assert!((ratio / factors.interval - 1.0).abs() < 0.01, "{ratio} {factors:?}");
    for part in ["Longest semi-axes of the 95 % ellipsoids", "The points with the longest 95 % ellipsoids", "The largest influences"] {
        assert!(html.contains(part), "no {part}");
    }
    for part in ["it has no tie points", "broken.pgm", "Mean residuals over the image", "redundancy number r"] {
        assert!(html.contains(part), "no {part}");
    }
}

#[test]
fn a_report_in_arabic_is_arabic() {
    let Project::Block(older) = read_project(include_bytes!("project/version-1.tiepoint")).unwrap() else { unreachable!() };
    let names: Vec<String> = (0..9).map(|number| format!("{HOSTILE}{number}")).chain([HOSTILE.into()]).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).chain(["PNM", "=other, 1.png"]).collect();
    for run in [free(), controlled(), &older] {
        let html = report_in(Texts::arabic(), run);
        assert_arabic(&html, &names);
    }
    let html = report_in(Texts::arabic(), controlled());
    for part in ["نقاط الضبط الأرضي</h2>", "نقاط التحقق</h2>", "مستعملة", "بنقاط الضبط الأرضي"]
    {
        assert!(html.contains(part), "no {part}");
    }
}

#[test]
fn a_report_shows_what_control_and_check_points_say() {
    let run = controlled();
    let (html, model) = (&report(run), &run.reconstruction.as_ref().unwrap().models[0]);
    assert!(model.in_system && model.surveyed.len() == 9, "{:?}", model.warnings);
    let check = model.surveyed.iter().find(|point| point.role == ControlRole::Check).unwrap();
    let cells = row(html, "Check points</h2>", "");
    let ratio = number(check.difference_m[2] / check.standard_errors_m[2].unwrap(), 2);
    assert_eq!((cells.len(), cells[0], cells[9]), (10, check.rays.to_string().as_str(), ratio.as_str()));
    let largest = |point: &&SurveyedPoint| point.difference_m.map(|d| d * d).iter().sum::<f64>();
    let control = model.surveyed.iter().filter(|point| point.role == ControlRole::Control);
    let worst = control.max_by(|a, b| largest(a).total_cmp(&largest(b))).unwrap();
    let cells = row(html, "Ground control points</h2>", "");
    let places = model.points.iter().enumerate().filter(|(_, source)| matches!(source, PointSource::GroundControl(_)));
    let place = places.zip(&model.surveyed).find(|(_, point)| point.name == worst.name).unwrap().0.0;
    let index = model.adjusted.block.control.iter().position(|control| control.point == place).unwrap();
    let statistics = model.adjusted.control[index].unwrap();
    let (w, r) = (number(statistics.w.unwrap()[2], 2), number(statistics.redundancy.unwrap()[2], 3));
    assert_eq!((cells.len(), cells[0], cells[6], cells[9]), (18, worst.rays.to_string().as_str(), w.as_str(), r.as_str()));
    let moves = cells[13].parse::<f64>().unwrap() / statistics.moves[0].unwrap();
    assert!((moves - 1.0).abs() < 0.006, "{cells:?} {moves}");
    let alone = model.surveyed.iter().filter_map(|point| point.left_out);
    let alone =
        alone.max_by(|a, b| a.difference.map(|d| d * d).iter().sum::<f64>().total_cmp(&b.difference.map(|d| d * d).iter().sum())).unwrap();
    let cells = row(html, "The same points without themselves", "");
    assert_eq!((cells.len(), cells[9]), (10, number(alone.difference[2] / alone.standard_errors[2], 2).as_str()));
    assert!(html.contains("Image measurements of these points") && html.contains("ground control points (green)"));
}
