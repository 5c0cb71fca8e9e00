//! Writes a simulated block in every format, for other programs to read: `cargo run --example export_block -- FOLDER`.

use std::path::Path;
use tiepoint::{
    BlockFlight, BlockModel, BlockOptions, BlockView, Error, ExportFormat, GeographicOrigin, SelectOptions, SimulatedBlock, TiePoints,
    export_block, select_points, simulate_block, tie_points,
};

fn main() -> Result<(), Error> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "export".into());
    let block = simulate_block(&BlockFlight { view: BlockView::Oblique, strips: 3, exposures: 4, ..BlockFlight::default() })?;
    let (points, _) = tie_points(&block.matches()?, &block.image_features(), &BlockOptions::default())?;
    let chosen = select_points(&points, &block.image_features(), &SelectOptions::default())?;
    let model = model_of(&block, &points, &chosen.points)?;
    for format in ExportFormat::ALL {
        let name = format!("{format:?}").to_lowercase();
        let mut files = 0;
        export_block(&model, format, &mut |path, text| {
            let path = Path::new(&folder).join(&name).join(path);
            let made = path.parent().map_or(Ok(()), std::fs::create_dir_all);
            files += 1;
            made.and_then(|()| std::fs::write(&path, text)).map_err(|_| Error::NotWritten { document: tiepoint::Document::Export })
        })?;
        println!("{name}: {files} files");
    }
    Ok(())
}

/// The block with its true orientations and points.
fn model_of(block: &SimulatedBlock, points: &TiePoints, chosen: &[u32]) -> Result<BlockModel, Error> {
    let origin = Some(GeographicOrigin { longitude_deg: 8.0, latitude_deg: 50.0, height_m: 0.0 });
    let mut model = BlockModel { origin, ..block.truth.clone() };
    model.images.iter_mut().for_each(|image| image.name += ".jpg");
    model.add_points(points, chosen, &block.image_features())?;
    for (point, index) in model.points.iter_mut().zip(chosen) {
        let owner = points.rays(*index as usize).iter().find_map(|ray| block.owners[ray.image as usize][ray.feature as usize]);
        point.position = owner.map(|owner| block.ground[owner as usize]);
    }
    Ok(model)
}
