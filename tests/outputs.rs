//! What a finished block writes and shows, before it is saved and after it is opened again.

use std::collections::BTreeMap;
use std::fs;
use std::sync::OnceLock;
use tiepoint::{
    BlockFlight, BlockOverview, BlockRun, BlockScene, BlockSettings, ExportFormat, MultiscaleOptions, PointColumns, Project,
    RefinementMethod, RunInput, block_files, coverage, images_in, planned_files, read_project, run_block, write_block_project,
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
        settings.features.multiscale = MultiscaleOptions { number: 1200, ..settings.features.multiscale };
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
    assert_eq!(summary.exports.iter().map(|export| export.refused.is_some()).collect::<Vec<_>>(), [true, false, false]);
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
    let older = opened(include_str!("project/version-1.tiepoint"));
    for run in [finished(), &older] {
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

#[test]
fn the_files_are_known_before_the_run() {
    let run = finished();
    let names: Vec<String> = run.images.iter().map(|image| image.name.clone()).collect();
    let planned = planned_files(&names, &[ExportFormat::Csv, ExportFormat::Json]).unwrap();
    for path in files(run).keys().filter(|path| !path.starts_with("colmap/")) {
        assert!(planned.contains(path), "{path}: {planned:?}");
    }
}
