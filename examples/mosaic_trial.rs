//! Half of the images of a folder placed on an orthomosaic that the block makes of the others, beside their places in the block. Arguments: the
//! folder of images, a folder for the records and `mosaic.tif`.

use std::fs::File;
use std::path::PathBuf;
use std::sync::Arc;
use tiepoint::{
    CameraUncertainty, DecodeLimits, DiskFile, Heights, Mosaic, Orthophoto, PlacingCamera, PlacingOptions, RunInput, SearchArea, decode,
    decode_bands, heights_of_points, images_in, place_image, run_block,
};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [folder, out] = arguments.as_slice() else { return Err("usage: mosaic_trial IMAGES OUT".into()) };
    let images = images_in(folder)?;
    let threads = std::thread::available_parallelism()?.get();
    let run = run_block(&images, &[], RunInput::default(), &out.join("work"), threads, |_| ())?;
    let model = &run.model;
    let heights = Heights::Model(heights_of_points(model)?);
    let bytes = |index: usize| std::fs::read(folder.join(&model.images[index].name));
    let grey = |index: usize| -> Result<_, Failure> { Ok(decode(&bytes(index)?, &DecodeLimits::default())?.grey) };
    let is_kept = |index: &usize| index.is_multiple_of(2);
    let mut mosaic = Mosaic::new(model, heights.clone(), None)?;
    let path = out.join("mosaic.tif");
    let mut file = File::create(&path)?;
    for index in mosaic.order().into_iter().filter(|index| !is_kept(index)) {
        mosaic.leave_out(index, &mut file)?;
    }
    for index in mosaic.order().into_iter().filter(is_kept) {
        mosaic.add(index, &decode_bands(&bytes(index)?, &DecodeLimits::default())?, &mut file)?;
    }
    mosaic.finish(&mut file)?;
    let file = DiskFile::new(File::open(&path)?)?;
    let orthophoto = Orthophoto::open(Arc::new(file), None, heights, &DecodeLimits::default())?;
    let [width, height] = orthophoto.size();
    println!("mosaic of {width} x {height} px, {:.4} a pixel", orthophoto.georeference.gsd());
    let options = PlacingOptions::default();
    let area = SearchArea::new(&orthophoto, &options)?;
    for index in (0..model.images.len()).filter(|index| !is_kept(index)) {
        let image = &model.images[index];
        let Some(pose) = image.pose else { continue };
        let known = PlacingCamera { camera: model.cameras[image.camera], uncertainty: CameraUncertainty::NONE, decentring: None };
        let start = std::time::Instant::now();
        let placed = place_image(grey(index)?.view(), &known, &orthophoto, &area, &options)?;
        println!("{}: {} {:.1} s", image.name, placed.verdict, start.elapsed().as_secs_f64());
        if let Some(placement) = placed.placement {
            let off = [0, 1, 2].map(|k| placement.pose.position[k] - pose.position[k]);
            let errors = placement.position_errors_m;
            println!("    off by {off:.3?}, standard errors {errors:.3?}, pixel on the ground {:.4}", placement.gsd_m);
        }
    }
    Ok(())
}
