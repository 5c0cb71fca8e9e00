//! Every exchange format as text: a tiny block, written and compared to the last letter.

use super::{ExportFormat, export_block, read_colmap_model};
use crate::model::tiny_block;
use crate::{BlockModel, Camera, Error, ObjectPoint, Pose, geographic_from_local, rotation_from_angles};
use std::collections::BTreeMap;

fn files(model: &BlockModel, format: ExportFormat) -> Result<BTreeMap<String, String>, Error> {
    let mut files = BTreeMap::new();
    export_block(model, format, &mut |path, text| {
        assert!(files.insert(path.to_string(), text.to_string()).is_none(), "{path} twice");
        Ok(())
    })?;
    Ok(files)
}

fn file(format: ExportFormat, path: &str) -> String {
    files(&tiny_block(), format).unwrap().remove(path).unwrap_or_else(|| panic!("no {path}"))
}

/// A block with all distortion parameters, turned images and names that need care.
fn distorted_block() -> BlockModel {
    let mut model = tiny_block();
    model.cameras[0] = Camera { radial: [-0.05, 0.01, -0.002], tangential: [4e-4, -3e-4], ..model.cameras[0] };
    let m = rotation_from_angles(0.02, -0.03, 1.2);
    model.images[1].pose = model.images[1].pose.map(|pose| Pose::new(&m, pose.position));
    model
}

#[test]
fn colmap() {
    let files = files(&tiny_block(), ExportFormat::Colmap).unwrap();
    let names: Vec<&str> = files.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        [
            "features/a.jpg.txt",
            "features/b.jpg.txt",
            "features/c.jpg.txt",
            "matches.txt",
            "sparse/cameras.txt",
            "sparse/images.txt",
            "sparse/points3D.txt"
        ]
    );
    let zeros = " 0".repeat(128);
    assert_eq!(files["features/a.jpg.txt"], format!("2 128\n225 150 1 0{zeros}\n225 100 1 0{zeros}\n"));
    assert_eq!(files["matches.txt"], "a.jpg b.jpg\n0 0\n1 1\n\na.jpg c.jpg\n0 0\n\nb.jpg c.jpg\n0 0\n2 1\n\n");
    let read = read_colmap_model(&files["sparse/cameras.txt"], &files["sparse/images.txt"], &files["sparse/points3D.txt"]).unwrap();
    assert_eq!((read.images.len(), read.points.len(), read.points[0].rays.len()), (2, 2, 2));
}

#[test]
fn micmac() {
    let files = files(&tiny_block(), ExportFormat::Micmac).unwrap();
    assert_eq!(files.len(), 6);
    assert_eq!(files["Homol/Pastisa.jpg/b.jpg.txt"], "224.5 149.5 174.5 149.5 1\n224.5 99.5 174.5 99.5 1\n");
    assert_eq!(files["Homol/Pastisb.jpg/a.jpg.txt"], "174.5 149.5 224.5 149.5 1\n174.5 99.5 224.5 99.5 1\n");
    assert_eq!(files["Homol/Pastisc.jpg/b.jpg.txt"], "100 19.75 174.5 149.5 1\n29.5 39.5 9.5 19.5 1\n");
}

#[test]
fn bundler() {
    assert_eq!(
        file(ExportFormat::Bundler, "bundle.out"),
        "# Bundle file v0.3\n3 2\n\
         500 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -100\n\
         500 0 0\n1 0 0\n0 1 0\n0 0 1\n-10 0 -100\n\
         0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n\
         5 0 0\n10 20 30\n2 0 0 25 0 1 0 -25 0\n\
         5 10 0\n10 20 30\n2 0 1 25 50 1 1 -25 50\n"
    );
    assert_eq!(file(ExportFormat::Bundler, "list.txt"), "a.jpg 0 500\nb.jpg 0 500\nc.jpg\n");
}

#[test]
fn nvm() {
    assert_eq!(
        file(ExportFormat::Nvm, "block.nvm"),
        "NVM_V3\n\n2\na.jpg 500 0 1 0 0 0 0 100 0 0\nb.jpg 500 0 1 0 0 10 0 100 0 0\n\n2\n\
         5 0 0 10 20 30 2 0 0 25 0 1 0 -25 0\n5 10 0 10 20 30 2 0 1 25 -50 1 1 -25 -50\n\n0\n"
    );
}

#[test]
fn opensfm() {
    let text = file(ExportFormat::Opensfm, "tracks.csv");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "OPENSFM_TRACKS_VERSION_v2");
    assert_eq!(lines[1], "a.jpg\t0\t0\t0.0625\t0\t0.0025\t10\t20\t30\t-1\t-1");
    assert_eq!(lines[3], "c.jpg\t0\t0\t-0.24875\t-0.324375\t0.0025\t10\t20\t30\t-1\t-1");
    assert_eq!(lines.len(), 8);
}

#[test]
fn bingo() {
    assert_eq!(
        file(ExportFormat::Bingo, "bingo.dat"),
        "a.jpg 1\n1 0.25000 0.00000\n2 0.25000 0.50000\n\n\
         b.jpg 1\n1 -0.25000 0.00000\n2 -0.25000 0.50000\n3 -1.90000 1.30000\n\n\
         c.jpg 1\n1 -0.99500 1.29750\n3 -1.70000 1.10000\n\n"
    );
}

#[test]
fn isat() {
    let text = file(ExportFormat::Isat, "isat_photo");
    assert!(text.contains(
        "begin photo_measurements a.jpg\n 1 250.00 0.00 250.00 0.00 1\n 2 250.00 500.00 250.00 500.00 1\nend photo_measurements\n"
    ));
    assert_eq!(text.matches("begin photo_measurements").count(), 3);
}

#[test]
fn patb() {
    let text = file(ExportFormat::Patb, "patb.im");
    let first: Vec<&str> = text.lines().take(4).collect();
    assert_eq!(first[0], "         1       5000.0");
    assert_eq!(first[1], "         1        250.0          0.0 1");
    assert_eq!(first[2], "         2        250.0        500.0 1");
    assert_eq!(first[3].trim(), "-99");
    assert_eq!(file(ExportFormat::Patb, "patb_photos.txt"), "1 a.jpg\n2 b.jpg\n3 c.jpg\n");
}

#[test]
fn agisoft() {
    let mut model = tiny_block();
    model.images[2].name = "c & \"d\".jpg".into();
    model.points[0].name = Some("GCP <1>".into());
    model.points[2].name = Some("church".into());
    let text = files(&model, ExportFormat::Agisoft).unwrap().remove("markers.xml").unwrap();
    assert!(text.contains("<camera id=\"2\" label=\"c &amp; &quot;d&quot;.jpg\" sensor_id=\"0\" enabled=\"1\"/>"));
    assert!(text.contains("<marker id=\"1\" label=\"point 2\">\n        <reference x=\"5\" y=\"10\" z=\"0\" enabled=\"0\"/>\n"));
    // Surveyed points keep their names.
    assert!(text.contains("<marker id=\"0\" label=\"GCP &lt;1&gt;\">\n") && text.contains("<marker id=\"2\" label=\"church\"/>\n"));
    assert!(text.contains("<marker marker_id=\"2\">\n            <location camera_id=\"1\" pinned=\"1\" x=\"10\" y=\"20\"/>\n"));
    // Every element that is opened is closed.
    let closed = text.matches("</").count() + text.matches("/>").count();
    assert_eq!(text.matches('<').count() - text.matches("</").count() - 1, closed);
}

#[test]
fn csv() {
    let mut model = tiny_block();
    model.images[2].name = "c,\"d\".jpg".into();
    let files = files(&model, ExportFormat::Csv).unwrap();
    let lines = |name: &str| files[name].lines().map(str::to_string).collect::<Vec<_>>();
    assert_eq!(lines("images.csv")[1], "0,a.jpg,0,400,300,500,0,0,100,0,0,0");
    assert_eq!(lines("images.csv")[3], "2,\"c,\"\"d\"\".jpg\",0,400,300,500,,,,,,");
    assert_eq!(lines("points.csv")[1..], ["1,5,0,0,10,20,30,3,1,0.25", "2,5,10,0,10,20,30,2,1,0.25", "3,,,,10,20,30,2,1,0.25"]);
    assert_eq!(lines("rays.csv")[3], "1,2,\"c,\"\"d\"\".jpg\",100.5,20.25,1");
}

#[test]
fn json() {
    let text = file(ExportFormat::Json, "block.json");
    assert_eq!(serde_json::from_str::<BlockModel>(&text).unwrap(), tiny_block());
    assert!(text.starts_with("{\"cameras\":[{\"width_px\":400,\"height_px\":300,\"focal_px\":500.0,"));
}

#[test]
fn geojson() {
    let text = file(ExportFormat::Geojson, "block.geojson");
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    let features = value["features"].as_array().unwrap();
    assert_eq!(features.len(), 4);
    let image = &features[1];
    assert_eq!(image["properties"]["name"], "b.jpg");
    let [longitude, latitude, height] = geographic_from_local([10.0, 0.0, 100.0], [8.0, 50.0, 200.0]);
    let found: Vec<f64> = image["geometry"]["coordinates"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    assert!((found[0] - longitude).abs() < 1e-9 && (found[1] - latitude).abs() < 1e-9 && (found[2] - height).abs() < 1e-3, "{found:?}");
    assert!((found[0] - 8.000_139_5).abs() < 1e-6 && (found[2] - 300.0).abs() < 1e-3, "{found:?}");
}

#[test]
fn what_a_format_cannot_hold_is_refused_by_name() {
    let refused = |change: &dyn Fn(&mut BlockModel), format: ExportFormat, word: &str| {
        let mut model = tiny_block();
        change(&mut model);
        let message = files(&model, format).unwrap_err().to_string();
        assert!(message.contains(word), "{format:?}: {message}");
    };
    for format in
        [ExportFormat::Colmap, ExportFormat::Micmac, ExportFormat::Bundler, ExportFormat::Nvm, ExportFormat::Bingo, ExportFormat::Isat]
    {
        refused(&|m| m.images[0].name = "a b.jpg".into(), format, "names without blanks");
    }
    for format in [ExportFormat::Colmap, ExportFormat::Micmac] {
        refused(&|m| m.images[0].name = "../a.jpg".into(), format, "names of files in a folder");
    }
    for format in [ExportFormat::Bingo, ExportFormat::Isat, ExportFormat::Patb] {
        refused(&|m| m.cameras[0].pixel_mm = None, format, "pixel_mm");
    }
    refused(&|m| m.origin = None, ExportFormat::Geojson, "longitudes");
    for format in ExportFormat::ALL {
        refused(&|m| m.points[0].rays[0].x_px = f64::NAN, format, "point 0");
    }
}

#[test]
fn the_error_of_the_one_who_takes_the_files_comes_through() {
    for format in ExportFormat::ALL {
        let full = Error::NotWritten { document: crate::Document::File };
        assert_eq!(export_block(&tiny_block(), format, &mut |_, _| Err(full.clone())), Err(full));
    }
}

/// Where formats take positions without distortion, the ray through such a position is that of the camera.
#[test]
fn formats_without_room_for_distortion_get_corrected_positions() {
    let model = distorted_block();
    let camera = &model.cameras[0];
    let measured = model.points[0].rays[0];
    let ([k1, k2, k3], [p1, p2]) = (camera.radial, camera.tangential);
    let seen = |x: f64, y: f64| {
        let r2 = x * x + y * y;
        let radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
        let shift = [2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x), p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y];
        [200.0 + 500.0 * (x * radial + shift[0]), 150.0 + 500.0 * (y * radial + shift[1])]
    };
    let near = |[x, y]: [f64; 2], tolerance: f64| (x - measured.x_px).abs() < tolerance && (y - measured.y_px).abs() < tolerance;
    let numbers = |text: &str| text.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).collect::<Vec<_>>();
    let nvm = &files(&model, ExportFormat::Nvm).unwrap()["block.nvm"];
    let of = numbers(nvm.lines().find(|line| line.starts_with("5 0 0 ")).unwrap());
    assert!(near(seen(of[9] / 500.0, of[10] / 500.0), 1e-9), "{of:?}");
    let bundle = &files(&model, ExportFormat::Bundler).unwrap()["bundle.out"];
    let of = numbers(bundle.lines().find(|line| line.starts_with("2 0 0 ")).unwrap());
    assert!(near(seen(of[3] / 500.0, -of[4] / 500.0), 1e-9), "{of:?}");
    let isat = &files(&model, ExportFormat::Isat).unwrap()["isat_photo"];
    let of = numbers(isat.lines().nth(2).unwrap());
    assert!(near(seen(of[3] / 5000.0, -of[4] / 5000.0), 2e-3), "{of:?}");
    // Bundler's own two coefficients stay where they are enough.
    let mut model = model.clone();
    model.cameras[0] = Camera { radial: [k1, k2, 0.0], tangential: [0.0; 2], ..model.cameras[0] };
    let bundle = &files(&model, ExportFormat::Bundler).unwrap()["bundle.out"];
    assert!(bundle.contains("500 -0.05 0.01\n") && bundle.contains("2 0 0 25 0 1 0 -25 0\n"), "{bundle}");
}

#[test]
fn a_block_with_all_parameters_comes_back_from_colmap() {
    let model = distorted_block();
    let files = files(&model, ExportFormat::Colmap).unwrap();
    let read = read_colmap_model(&files["sparse/cameras.txt"], &files["sparse/images.txt"], &files["sparse/points3D.txt"]).unwrap();
    assert_eq!(read.cameras[0], Camera { pixel_mm: None, ..model.cameras[0] });
    for (image, wanted) in read.images.iter().zip(&model.images) {
        let (pose, wanted) = (image.pose.unwrap(), wanted.pose.unwrap());
        let difference = pose.rotation.iter().flatten().zip(wanted.rotation.iter().flatten()).map(|(a, b)| (a - b).abs());
        assert!(difference.fold(0.0, f64::max) < 1e-14);
        assert!(pose.position.iter().zip(wanted.position).all(|(a, b)| (a - b).abs() < 1e-12));
    }
    assert_eq!(read.points[1], ObjectPoint { number: Some(2), ..model.points[1].clone() });
}

#[test]
fn files_call_points_by_their_numbers() {
    let mut model = tiny_block();
    for (point, number) in model.points.iter_mut().zip([7, 30, 1001]) {
        point.number = Some(number);
    }
    model.check().unwrap();
    let text = |format, name: &str| files(&model, format).unwrap()[name].clone();
    for (format, name, said) in [
        (ExportFormat::Csv, "points.csv", "\n30,5,10,0,"),
        (ExportFormat::Csv, "rays.csv", "\n1001,1,b.jpg,10,20,"),
        (ExportFormat::Colmap, "sparse/points3D.txt", "\n30 5 10 0 "),
        (ExportFormat::Colmap, "sparse/images.txt", "\n225 150 7 225 100 30\n"),
        (ExportFormat::Agisoft, "markers.xml", "label=\"point 1001\""),
        (ExportFormat::Bingo, "bingo.dat", "\n30 "),
        (ExportFormat::Patb, "patb.im", "\n      1001 "),
        (ExportFormat::Isat, "isat_photo", "\n 7 "),
        (ExportFormat::Geojson, "block.geojson", "\"point\":30,"),
    ] {
        assert!(text(format, name).contains(said), "{name}: {}", text(format, name));
    }
    model.points[1].number = Some(7);
    assert!(model.check().unwrap_err().to_string().contains("got the number 7 for points 0 and 1"));
    model.points[1].number = None;
    assert_eq!(model.point_numbers(), [1, 2, 3]);
}
