//! From a folder of images to the files of a block, the same bytes as the command's: `cargo run --release --example run_block -- FOLDER OUT`.

use std::path::Path;
use tiepoint::{Error, News, RunInput, block_files, images_in, replace_file, run_block};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folders: Vec<String> = std::env::args().skip(1).collect();
    let [images, out] = folders.as_slice() else { return Err("usage: run_block FOLDER OUT".into()) };
    Ok(run(Path::new(images), Path::new(out))?)
}

pub fn run(images: &Path, out: &Path) -> Result<(), Error> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let tell = |news| {
        if let News::Step(step) = news {
            eprintln!("{:?}: {} of {} {}", step.stage, step.done, step.total, step.name);
        }
    };
    let run = run_block(&images_in(images)?, &[], RunInput::default(), &out.join("work"), threads, tell)?;
    block_files(&run, &[], None, &mut |path, text| replace_file(&out.join(path), text.as_bytes()))?;
    Ok(())
}
