//! The run of a block from image files to its orientation, whatever host does its jobs.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tiepoint::{
    BlockFlight, BlockRun, BlockScene, BlockSettings, BlockVerdict, ControlTexts, Error, Failure, FileNeeded, MultiscaleOptions, News,
    OverviewWarning, PairChoice, PairOutcome, PairRule, RefinementMethod, RefinementOutcome, Run, RunInput, StageName, Step, digest,
    execute, images_in, run_block, write_block_project,
};

/// A folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("tiepoint-pipeline-{}-{name}", std::process::id()));
    fs::create_dir_all(&path).unwrap();
    path
}

/// Photos of a small simulated block, by name.
fn photos() -> &'static BTreeMap<String, Vec<u8>> {
    static PHOTOS: OnceLock<BTreeMap<String, Vec<u8>>> = OnceLock::new();
    PHOTOS.get_or_init(|| {
        let flight = BlockFlight { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.12, ..BlockFlight::default() };
        let scene = BlockScene::new(&flight).unwrap();
        let file = |index| {
            let photo = scene.photo(index).unwrap();
            let bytes = [format!("P5 {} {} 255\n", photo.width(), photo.height()).as_bytes(), photo.data()].concat();
            (format!("photo_{index:05}.pgm"), bytes)
        };
        (0..scene.photos()).map(file).collect()
    })
}

fn options() -> RunInput {
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 1200, ..settings.features.multiscale };
    RunInput { settings, cameras: Some(r#"{"cameras": [{"focal_px": 708.33}]}"#.into()), ..RunInput::default() }
}

/// A host without threads, files or a clock, whose jobs end in any order.
struct Host {
    run: Run,
    images: Vec<Vec<u8>>,
    masks: Vec<Vec<u8>>,
    steps: Vec<Step>,
}

type Kept = BTreeMap<String, Vec<u8>>;

impl Host {
    fn new(input: RunInput, masks: &[(&str, Vec<u8>)]) -> Result<Self, Error> {
        let images = photos().keys().cloned().collect();
        let names = masks.iter().map(|(name, _)| name.to_string()).collect();
        let run = Run::new(RunInput { images, masks: names, ..input })?;
        let masks = masks.iter().map(|(_, bytes)| bytes.clone()).collect();
        Ok(Self { run, images: photos().values().cloned().collect(), masks, steps: Vec::new() })
    }

    fn perform(&mut self, id: u32, files: &[FileNeeded], kept: &mut Kept) -> Result<(), Error> {
        let bytes_of = |file: &FileNeeded| match file {
            FileNeeded::Image(index) => self.images[*index].clone(),
            FileNeeded::Mask(index) => self.masks[*index].clone(),
            FileNeeded::Geoid(_) => panic!("no geoid was given"),
        };
        let mut inputs: Vec<Vec<u8>> = files.iter().map(bytes_of).collect();
        let work = self.run.prepare(id, &inputs.iter().map(|bytes| digest(bytes)).collect::<Vec<_>>())?;
        if let Some(record) = work.key.as_ref().and_then(|key| kept.get(key))
            && self.run.found(id, record.clone())?
        {
            return Ok(());
        }
        inputs.extend(work.records.iter().map(|key| kept[key].clone()));
        inputs.extend(work.input);
        let borrowed: Vec<&[u8]> = inputs.iter().map(Vec::as_slice).collect();
        match work.task.map_or_else(|| Ok(borrowed.concat()), |task| execute(&task, &borrowed)) {
            Ok(bytes) => {
                kept.extend(work.key.map(|key| (key, bytes.clone())));
                self.run.complete(id, bytes)
            }
            Err(error) => self.run.failed(id, Failure::from(&error)),
        }
    }

    /// Runs to the end, with several jobs under way of which any ends first.
    fn ended(mut self, kept: &mut Kept) -> Result<(BlockRun, Vec<Step>), Error> {
        let mut underway = Vec::new();
        let mut turn = 7_usize;
        loop {
            underway.extend(self.run.next(4 - underway.len())?);
            if underway.is_empty() {
                return Ok((self.run.finish()?, self.steps));
            }
            turn = turn * 31 % 1009;
            let job = underway.swap_remove(turn % underway.len());
            self.perform(job.id, &job.files, kept)?;
            self.steps.extend(self.run.news().into_iter().filter_map(|news| if let News::Step(step) = news { Some(step) } else { None }));
        }
    }
}

/// A run from the beginning, and what it has kept.
fn whole() -> &'static (BlockRun, Vec<Step>, Kept) {
    static WHOLE: OnceLock<(BlockRun, Vec<Step>, Kept)> = OnceLock::new();
    WHOLE.get_or_init(|| {
        let mut kept = Kept::new();
        let (run, steps) = Host::new(options(), &[]).unwrap().ended(&mut kept).unwrap();
        (run, steps, kept)
    })
}

fn last(steps: &[Step], stage: StageName) -> Option<(usize, usize, usize)> {
    steps.iter().rfind(|step| step.stage == stage).map(|step| (step.done, step.total, step.found))
}

#[test]
fn threads_and_a_folder_give_what_one_job_after_the_other_gives() {
    let (run, steps, _) = whole();
    assert_eq!(run.model.images.iter().filter(|image| image.pose.is_some()).count(), 6, "{:?}", run.reconstruction);
    assert_eq!((last(steps, StageName::Images), last(steps, StageName::Pairs)), (Some((6, 6, 0)), Some((15, 15, 0))));
    let at = folder("threads");
    for (name, bytes) in photos() {
        fs::write(at.join(name), bytes).unwrap();
    }
    let images = images_in(&at).unwrap();
    let natively = |threads: usize| {
        let mut steps = Vec::new();
        let tell = |news| {
            if let News::Step(step) = news {
                steps.push(step)
            }
        };
        let run = run_block(&images, &[], options(), &at.join("work"), threads, tell).unwrap();
        (run, steps)
    };
    let (threaded, _) = natively(2);
    assert_eq!(write_block_project(&threaded).unwrap(), write_block_project(run).unwrap());
    assert_eq!(threaded, *run);
    // The second time everything is there.
    let (again, steps) = natively(1);
    assert_eq!((last(&steps, StageName::Images), last(&steps, StageName::Pairs)), (Some((6, 6, 6)), Some((15, 15, 15))));
    assert_eq!(again, *run);
    fs::remove_dir_all(at).unwrap();
}

#[test]
fn a_run_whose_caller_panics_ends_though_other_threads_wait() {
    let at = folder("panicking");
    for name in ["a.png", "b.png"] {
        fs::write(at.join(name), b"no image").unwrap();
    }
    let images = images_in(&at).unwrap();
    let kept = at.join("work");
    let (said, heard) = std::sync::mpsc::channel();
    // More threads than images: the others wait for what comes of these.
    std::thread::spawn(move || {
        let told = std::panic::AssertUnwindSafe(|| run_block(&images, &[], options(), &kept, 6, |_| panic!("told too much")));
        let panic = std::panic::catch_unwind(told).unwrap_err();
        said.send(panic.downcast_ref::<&str>().map(ToString::to_string)).unwrap();
    });
    let panic = heard.recv_timeout(std::time::Duration::from_secs(120)).expect("the run ends");
    assert_eq!(panic.as_deref(), Some("told too much"));
    fs::remove_dir_all(at).unwrap();
}

#[test]
fn a_kept_record_that_is_damaged_is_made_again() {
    let (run, _, whole) = whole();
    let mut kept = whole.clone();
    for (turn, record) in kept.values_mut().enumerate().filter(|(turn, _)| turn % 3 == 0) {
        if turn % 2 == 0 { record.truncate(record.len() / 2) } else { *record.last_mut().unwrap() ^= 1 }
    }
    let (again, steps) = Host::new(options(), &[]).unwrap().ended(&mut kept).unwrap();
    assert_eq!((&again, &kept), (run, whole));
    assert_eq!((last(&steps, StageName::Images), last(&steps, StageName::Pairs)), (Some((6, 6, 4)), Some((15, 15, 10))));
}

#[test]
fn observations_are_refined_and_similar_images_are_matched_in_any_order_of_jobs() {
    let mut input = options();
    input.settings.refinement.method = RefinementMethod::LeastSquares;
    input.settings.pairs = PairChoice { rule: Some(PairRule::Alike), alike: 3, ..PairChoice::default() };
    let mut kept = Kept::new();
    let (run, steps) = Host::new(input.clone(), &[]).unwrap().ended(&mut kept).unwrap();
    let table = run.refinement.as_ref().unwrap();
    let refined = table.observations.iter().filter(|ray| ray.outcome == RefinementOutcome::Refined).count();
    assert!(2 * refined > table.observations.len() / 2, "{refined} of {}", table.observations.len());
    assert!(table.observations.iter().all(|ray| ray.standard_error_px.is_some() == (ray.outcome == RefinementOutcome::Refined)));
    assert_eq!(table.starts.last().copied(), Some(table.observations.len() as u32));
    assert_eq!((last(&steps, StageName::Likeness), last(&steps, StageName::Windows)), (Some((5, 5, 0)), Some((6, 6, 0))));
    assert!(run.connections.iter().all(|pair| pair.rule == PairRule::Alike) && run.connections.len() < 15);
    let (again, steps) = Host::new(input, &[]).unwrap().ended(&mut kept).unwrap();
    assert_eq!(again, run);
    assert_eq!(last(&steps, StageName::Windows), Some((6, 6, 6)));
}

#[test]
fn an_image_that_cannot_be_read_and_a_pair_that_breaks_off_are_told_and_the_rest_goes_on() {
    let mut host = Host::new(options(), &[("photo_00001.pgm", b"no image".to_vec()), ("other.pgm", Vec::new())]).unwrap();
    host.images[0].truncate(100);
    let mut kept = Kept::new();
    let mut broken = false;
    loop {
        let jobs = host.run.next(1).unwrap();
        let Some(job) = jobs.first() else { break };
        // Only preparing tells what a job is; that of images compares the digests of their files.
        let is_pair = !broken && host.run.prepare(job.id, &[String::new()]).unwrap().key.is_some_and(|key| key.starts_with("pairs/"));
        if is_pair {
            broken = true;
            host.run.failed(job.id, Failure::BrokeOff { message: "unreachable".into() }).unwrap();
        } else {
            host.perform(job.id, &job.files, &mut kept).unwrap();
        }
    }
    let run = host.run.finish().unwrap();
    let skipped: Vec<(String, String)> = run.skipped.iter().map(|image| (image.name.clone(), image.reason.to_string())).collect();
    assert_eq!(skipped[0].0, "photo_00000.pgm");
    assert!(skipped[1].1.contains("its mask photo_00001.pgm: "), "{skipped:?}");
    assert_eq!((run.images.len(), run.unused_masks), (4, vec!["other.pgm".to_string()]));
    assert_eq!(run.connections[0].outcome, PairOutcome::Failed { failure: Failure::BrokeOff { message: "unreachable".into() } });
    assert_eq!(run.connections.len(), 6);
}

#[test]
fn what_no_run_can_be_is_refused_before_anything_is_computed() {
    let names = |list: &[&str]| list.iter().map(|name| name.to_string()).collect::<Vec<_>>();
    let refused = |input: RunInput| Run::new(input).err().map(|error| error.to_string()).unwrap_or_default();
    let two = RunInput { images: names(&["a.png", "b.png"]), ..RunInput::default() };
    assert!(
        refused(RunInput { images: names(&["a.png", "a.png"]), ..two.clone() })
            .contains("two with the name a.png; allowed: each name once")
    );
    assert!(
        refused(RunInput { images: names(&["a\nb.png"]), ..two.clone() })
            .contains(r#"the name "a\nb.png", which holds a control character"#)
    );
    assert!(refused(RunInput { masks: names(&["a.png", "a_mask.png"]), ..two.clone() }).contains("one mask per image"));
    let masked = |refuse_stray_masks| RunInput { masks: names(&["a.png", "zz.png"]), refuse_stray_masks, ..two.clone() };
    assert!(
        refused(masked(true))
            .starts_with("masks: got zz.png, which belongs to none of the images; allowed: masks with the names of images")
    );
    assert_eq!(refused(masked(false)), "");
    assert!(refused(RunInput::default()).starts_with("images of the block: got 0 that could be read, of 0; allowed: two or more"));
    let cameras = Some(r#"{"cameras": [{"images": "DJI_*", "focal_px": 500}]}"#.into());
    assert!(refused(RunInput { cameras, ..two.clone() }).contains("DJI_*, which fit no image"));
    let control = Some(ControlTexts { points: "a,0,0,0\n".into(), marks: "a.png,a,1,1\n".into() });
    assert!(refused(RunInput { control, ..two.clone() }).contains("0 of 1 measured in two images or more"));
    let mut wrong = two.clone();
    wrong.settings.features.multiscale.contrast = -1.0;
    assert!(refused(wrong).contains("multiscale.contrast is -1; allowed"));
    assert_eq!(refused(two), "");
    let alone = Path::new("none.png").to_path_buf();
    let error = run_block(&[alone], &[], RunInput::default(), &folder("none"), 1, |_| {}).unwrap_err().to_string();
    assert!(error.starts_with("images of the block: got 0 that could be read, of 1 (none.png: "), "{error}");
}

#[test]
fn two_images_that_few_matches_join_are_weak_as_a_pair_is_and_a_third_image_checks_them() {
    let of = |number: usize| {
        let folder = folder(&format!("few{number}"));
        let paths: Vec<PathBuf> = photos().keys().take(number).map(|name| folder.join(name)).collect();
        for (path, bytes) in paths.iter().zip(photos().values()) {
            fs::write(path, bytes).unwrap();
        }
        run_block(&paths, &[], options(), &folder.join("work"), 2, drop).unwrap()
    };
    let judged = |mut run: BlockRun, joined: u32| {
        run.images.iter_mut().for_each(|image| image.features = Some(8000));
        run.connections.iter_mut().for_each(|pair| pair.outcome = PairOutcome::Connected { matches: joined });
        BlockVerdict::of(&run)
    };
    let (two, three) = (of(2), of(3));
    let weak = judged(two.clone(), 239);
    let BlockVerdict::Weak { overview_warning: OverviewWarning::FewMatches { matches: 239, least: 240 }, .. } = weak else {
        panic!("{weak}")
    };
    assert_eq!(weak.to_string().matches("Only 239 matches").count(), 1, "{weak}");
    for enough in [judged(two, 240), judged(three, 239)] {
        assert!(!matches!(enough, BlockVerdict::Weak { overview_warning: OverviewWarning::FewMatches { .. }, .. }), "{enough}");
    }
}

#[test]
fn a_copy_of_an_image_is_left_out_and_named() {
    let folder = folder("copy");
    let copy = ("photo_00001 again.pgm".to_string(), photos()["photo_00001.pgm"].clone());
    // The same picture in another file.
    let noted = photos()["photo_00002.pgm"].clone();
    let noted = ("photo_00002 noted.pgm".to_string(), [&noted[..2], b"\n# noted\n", &noted[2..]].concat());
    let mut paths: Vec<PathBuf> = Vec::new();
    for (name, bytes) in photos().iter().chain([(&copy.0, &copy.1), (&noted.0, &noted.1)]) {
        let path = folder.join(name);
        fs::write(&path, bytes).unwrap();
        paths.push(path);
    }
    paths.sort();
    let run = run_block(&paths, &[], options(), &folder.join("work"), 2, drop).unwrap();
    let told: Vec<(&str, String)> = run.skipped.iter().map(|image| (image.name.as_str(), image.reason.to_string())).collect();
    // In the order of names a blank comes before the full stop.
    for ((name, reason), (left_out, like)) in
        told.iter().zip([("photo_00001.pgm", "photo_00001 again.pgm"), ("photo_00002.pgm", "photo_00002 noted.pgm")])
    {
        assert!(*name == left_out && reason.contains(like), "{told:?}");
    }
    assert_eq!(told.len(), 2);
    assert_eq!(run.images.len(), photos().len());
    assert_eq!(run.reconstruction.unwrap().models[0].images.len(), photos().len());
}
