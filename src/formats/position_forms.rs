//! Tests: tables of image positions in the forms of receivers and other programs.

use super::columns::UnreadColumns;
use super::positions::{ImagePositions, parse_image_positions, position_head};

/// The positions of a table.
pub(super) fn read(text: &str) -> ImagePositions {
    parse_image_positions(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn message(text: &str) -> String {
    parse_image_positions(text).unwrap_err().to_string()
}

fn unread(text: &str) -> UnreadColumns {
    position_head(text).unwrap().unread
}

#[test]
fn titles_and_units_stand_about_the_names_and_commas_are_no_decimal_ones() {
    let own = read("image,x,y,z\na.jpg,446833.25,5594521.5,171\n").rows[0].clone();
    for text in [
        "Flight of May\nimage,x,y,z\na.jpg,446833.25,5594521.5,171\n",
        "image,x,y,z\n,m,m,m\na.jpg,446833.25,5594521.5,171\n",
        "image x y z\na.jpg 446833.25 5594521.5 171\n",
        "a.jpg 446833.25 5594521.5 171\n",
    ] {
        let row = read(text).rows[0].clone();
        assert_eq!((row.place, row.height), (own.place, own.height), "{text}");
    }
    for text in ["image,x,y,z\na.jpg,446833,25,5594521,5,171,5\n", "a.jpg,446833,25,5594521,5,171,5\n"] {
        let told = message(text);
        assert!(told.starts_with("the table of image positions: got 'a.jpg,446833,25,") && told.contains("decimal commas"), "{told}");
    }
    // Whole metres are no halves of numbers.
    assert_eq!(read("a.jpg,446833,5594521,171\n").rows[0].place, [446833.0, 5594521.0]);
}

#[test]
fn standard_errors_have_the_units_of_their_names() {
    let row = &read("image,x,y,z,sigma_xy (mm),sigma_z (cm)\na.jpg,446833,5594521,171,20,4\n").rows[0];
    let [across, up] = row.standard_errors.map(Option::unwrap);
    assert!((across - 0.02).abs() < 1e-12 && (up - 0.04).abs() < 1e-12, "{across} {up}");
}

#[test]
fn tables_of_many_programs_give_the_same_positions() {
    let wanted = [("a.jpg", [8.25, 50.5], 171.5), ("b.jpg", [8.26, 50.51], 172.0)];
    for (text, errors) in [
        // Pix4D, with the names that its documents give.
        (
            "imagename,latitude [decimal degrees],longitude [decimal degrees],altitude [meter],accuracy horz [meter],accuracy vert [meter]\n\
             a.jpg,50.5,8.25,171.5,0.02,0.04\nb.jpg,50.51,8.26,172,0.02,0.04\n",
            [0.02, 0.04],
        ),
        (
            "image,latitude,longitude,altitude,acc horz,acc vert\na.jpg,50.5,8.25,171.5,0.02,0.04\nb.jpg,50.51,8.26,172,0.02,0.04\n",
            [0.02, 0.04],
        ),
        // Metashape: names behind a `#`, with other comments before and behind.
        (
            "# CoordinateSystem: GEOGCS[\"WGS 84\"]\n#Label,X/Longitude,Y/Latitude,Z/Altitude,Error_(m),X_error,X_est\na.jpg,8.25,50.5,171.5,,,\nb.jpg,8.26,50.51,172,1,2,3\n# Total error\n",
            [f64::NAN; 2],
        ),
        // Emlid: x and y of a system beside, and two heights.
        (
            "Name,Easting,Northing,Elevation,Longitude,Latitude,Ellipsoidal height,Easting RMS,Northing RMS,Elevation RMS\n\
             a.jpg,446833.2,5594521.7,124,8.25,50.5,171.5,0.01,0.02,0.04\nb.jpg,446833.2,5594521.7,125,8.26,50.51,172,0.02,0.01,0.04\n",
            [0.02, 0.04],
        ),
        // ExifTool.
        ("SourceFile,GPSLatitude,GPSLongitude,GPSAltitude\na.jpg,50.5,8.25,171.5\nb.jpg,50.51,8.26,172\n", [f64::NAN; 2]),
        ("Bild;Länge;Breite;Höhe;Sigma Lage;Sigma Höhe\na.jpg;8,25;50,5;171,5;0,02;0,04\nb.jpg;8,26;50,51;172;0,02;0,04\n", [0.02, 0.04]),
        (
            "photo\tlat\tlng\tellipsoidal height (m)\taccuracy\na.jpg\t50,5\t8,25\t171,5\t0,03\nb.jpg\t50,51\t8,26\t172\t0,03\n",
            [0.03, 0.03],
        ),
        ("file,x,y,z,sigma_xy,sigma_z\na.jpg,8.25,50.5,171.5,0.02,0.04\n\n# b\nb.jpg,8.26,50.51,172,0.02,0.04\n", [0.02, 0.04]),
    ] {
        let found = read(text);
        assert!(found.is_geographic, "{text}");
        let rows: Vec<_> = found.rows.iter().map(|row| (row.image.as_str(), row.place, row.height.unwrap())).collect();
        assert_eq!(rows, wanted, "{text}");
        let errors = errors.map(|error| Some(error).filter(|error| !error.is_nan()));
        assert!(found.rows.iter().all(|row| row.standard_errors == errors), "{text}: {found:?}");
    }
}

#[test]
fn coordinates_of_a_plane_are_told_from_degrees() {
    for (text, errors) in [
        ("name;Rechtswert;Hochwert;Höhe\na;446833,25;5594521,5;171,5\n", [None, None]),
        ("image,easting,northing,elev\na,446833.25,5594521.5,171.5\n", [None, None]),
        ("#Label,X/Easting,Y/Northing,Z/Altitude\na,446833.25,5594521.5,171.5\n", [None, None]),
        ("# a flight\na,446833.25,5594521.5,171.5\n", [None, None]),
        ("a,446833.25,5594521.5,171.5,0.02,0.04\n", [Some(0.02), Some(0.04)]),
        ("a,446833.25,5594521.5,171.5,1,2,3,0.02,0.04\n", [Some(0.02), Some(0.04)]),
        ("a,446833.25,5594521.5,171.5,1,2,3\n", [None, None]),
        ("a,446833.25,5594521.5,171.5,91,2\n", [None, None]),
        // One for all is stated, and what varies by metres is something else.
        ("a,446833.25,5594521.5,171.5,5,10\nb,446833.25,5594521.5,171.5,5,10\n", [Some(5.0), Some(10.0)]),
        ("a,446833.25,5594521.5,171.5,0.02,0.04\nb,446833.25,5594521.5,171.5,0.9,0.8\n", [Some(0.02), Some(0.04)]),
        ("a,446833.25,5594521.5,171.5,12,2\nb,446833.25,5594521.5,171.5,13,2.5\n", [None, None]),
        ("a,446833.25,5594521.5,171.5,0.9,14\nb,446833.25,5594521.5,171.5,0.9,15\n", [None, None]),
        ("EPSG:25832\na 446833.25 5594521.5 171.5 0.5 0.2\n", [None, None]),
        ("EPSG:25832\na 446833.25 5594521.5 171.5 12 2 1 0.02 0.04\n", [Some(0.02), Some(0.04)]),
        ("a,446833.25,5594521.5,171.5,TP,bolt\n", [None, None]),
    ] {
        let found = read(text);
        assert!(!found.is_geographic, "{text}");
        let row = &found.rows[0];
        assert_eq!((row.place, row.height, row.standard_errors), ([446_833.25, 5_594_521.5], Some(171.5), errors), "{text}");
    }
    assert_eq!(unread("a,446833.25,5594521.5,171.5,91,2\n").unknown, ["#5", "#6"]);
    let unnamed = |text: &str| position_head(text).unwrap().unnamed_errors;
    assert_eq!(unnamed("a,446833.25,5594521.5,171.5,0.5,10\n"), ["#5", "#6"]);
    assert!(unnamed("a,446833.25,5594521.5,171.5,0.02,0.04\n").is_empty());
    assert!(unnamed("image,x,y,z,sigma_xy,sigma_z\na,446833.25,5594521.5,171.5,5,10\n").is_empty());
    // `x` of a plane is no longitude where one row lies beyond.
    assert!(!read("image,x,y\na,10,20\nb,1000,20\n").is_geographic);
}

#[test]
fn degrees_without_names_are_read_where_their_order_is_certain() {
    for text in ["a,-98.5,19.25,5\nb,-80,19.25,5\n", "a,19.25,-98.5,5\nb,19.25,-80,5\n"] {
        let found = read(text);
        assert!(found.is_geographic && found.rows[0].place == [-98.5, 19.25] && found.rows[1].place == [-80.0, 19.25], "{found:?}");
    }
    let refused = message("# x\na.jpg,50.5,8.25,171.5\n");
    assert!(
        refused.contains("50.5, 8.25") && refused.contains("line 2") && refused.contains("image,latitude,longitude,height"),
        "{refused}"
    );
    // One way round for all.
    assert!(!read("a,-98.5,19.25,5\nb,19.25,-98.5,5\n").is_geographic);
}

#[test]
fn heights_and_standard_errors_may_be_absent() {
    let rows = read("image,lon,lat,height,sigma_xy,sigma_z\na,8,50,,,\nb,8,50,100,,0.05\nc,,,,,\nd,8,50,100,0.02,\n").rows;
    assert_eq!(
        rows.iter().map(|row| (row.image.as_str(), row.height)).collect::<Vec<_>>(),
        [("a", None), ("b", Some(100.0)), ("d", Some(100.0))]
    );
    assert_eq!(rows.iter().map(|row| row.standard_errors).collect::<Vec<_>>(), [[None, None], [None, Some(0.05)], [Some(0.02), None]]);
    assert_eq!(rows[2].line, 5);
    assert_eq!(read("image,lon,lat\na,8,50\n").rows[0].height, None);
    // Above the geoid is not above the ellipsoid.
    let orthometric = "image,lon,lat,orthometric height\na,8.5,50,100\n";
    assert_eq!(read(orthometric).rows[0].height, None);
    assert_eq!(unread(orthometric).unknown, ["orthometric height"]);
}

#[test]
fn columns_that_are_not_read_are_named() {
    let text = "Label,Longitude,Latitude,Altitude,Yaw,Pitch,Roll,Easting,Northing\na,8.5,50,100,1,2,3,400000,5500000\n";
    assert_eq!(unread(text).unknown, ["Yaw", "Pitch", "Roll"]);
    assert_eq!(unread(text).doubled, ["Easting (Longitude)", "Northing (Latitude)"]);
    assert_eq!(unread("a,400000.5,5500000,100,1,2,3\n").unknown, ["#5", "#6", "#7"]);
    let feet = position_head("image,easting (ft),northing (ft),height (m)\na,1400000,5500000,1\n").unwrap().stated_units;
    assert_eq!(feet.iter().map(|stated| (stated.unit, stated.is_height)).collect::<Vec<_>>(), [("ft", false), ("ft", false), ("m", true)]);
}

#[test]
fn angles_behind_a_commented_head_are_no_standard_errors() {
    let row = read("#image,easting,northing,altitude,yaw\na.jpg,446833,5594521.5,2300,91,\n").rows.remove(0);
    assert_eq!((row.place, row.height, row.standard_errors), ([446_833.0, 5_594_521.5], Some(2300.0), [None; 2]));
    let degrees = "#image,longitude,latitude,altitude\na.jpg,8.25,50.5,171.5,\n";
    assert_eq!((read(degrees).is_geographic, read(degrees).rows[0].place), (true, [8.25, 50.5]));
    assert_eq!(unread("a.jpg,446833,5594521.5,2300,91,\n").unknown, ["#5"]);
    assert_eq!(read("a.jpg,446833,5594521.5,2300,91,\n").rows[0].standard_errors, [None; 2]);
    // Names for fewer columns than there are do not leave the others to their order.
    assert!(message("#image,x,y,z\na.jpg,446833,5594521.5,2300,1,2\n").contains("more fields than the 4 columns"));
}

#[test]
fn hemispheres_in_columns_of_their_own_and_beside_numbers_are_read() {
    let head = "image,GPSLatitudeRef,GPSLatitude,GPSLongitudeRef,GPSLongitude,GPSAltitude,GPSAltitudeRef\n";
    for row in [
        "a,S,49.99,W,8.5,171.5,1",
        "a,south,49.99,West,8.5,171.5,Below Sea Level",
        // As `exiftool -n` has them beside the numbers of EXIF.
        "a,S,-49.99,W,-8.5,-171.5,1",
        "a,S,\"49 deg 59' 24.00\"\"\",W,\"8 deg 30' 0.00\"\"\",171.5 m,1",
    ] {
        let text = format!("{head}{row}\n");
        let row = &read(&text).rows[0];
        assert!((row.place[0] + 8.5).abs() < 1e-12 && (row.place[1] + 49.99).abs() < 1e-12, "{text}: {row:?}");
        assert_eq!(row.height, Some(-171.5), "{text}");
        assert_eq!(unread(&text), UnreadColumns::default(), "{text}");
    }
    for (head, row) in [
        (
            "SourceFile,GPSLatitude,GPSLongitude,GPSAltitude",
            "./a.JPG,\"49 deg 59' 24.00\"\" S\",\"8 deg 30' 0.00\"\" W\",171.5 m Below Sea Level",
        ),
        ("image;Latitude;N/S;Longitude;E/W;Altitude", "a;49,99;S;8,5;W;-171,5"),
        ("image,lat,lat hemisphere,lon,lon hemisphere,alt", "a,49.99,S,8.5,W,-171.5"),
        ("image,lat,lon,alt", "a,49.99 S,W 8.5,-171.5"),
    ] {
        let row = &read(&format!("{head}\n{row}\n")).rows[0];
        assert!((row.place[0] + 8.5).abs() < 1e-12 && (row.place[1] + 49.99).abs() < 1e-12, "{row:?}");
        assert_eq!(row.height, Some(-171.5), "{row:?}");
    }
    for (row, named) in [
        ("a,E,49.99,W,8.5,171.5,0", "'E' for GPSLatitudeRef beside '49.99' in line 2"),
        ("a,,49.99,W,8.5,171.5,0", "'' for GPSLatitudeRef"),
        ("a,N,-49.99,W,8.5,171.5,0", "'N' for GPSLatitudeRef beside '-49.99'"),
        ("a,N,49.99,E,8.5,-171.5,2", "'2' for GPSAltitudeRef beside '-171.5'"),
        ("a,N,49.99 X,E,8.5,171.5,0", "'49.99 X' for GPSLatitude in line 2; allowed: finite numbers (as ExifTool writes them with -n)"),
    ] {
        let refused = message(&format!("{head}{row}\n"));
        assert!(refused.contains(named), "{row}: {refused}");
    }
    assert_eq!(read(&format!("{head}a,N,49.99,E,8.5,171.5,\n")).rows[0].height, Some(171.5));
    // Surfaces that heights refer to are no sides, nor are numbers of satellites hemispheres.
    let others = "image,lat,lon,alt,Height Ref,ns\na,49.99,8.5,171.5,geoid,12\n";
    assert_eq!((read(others).rows[0].height, unread(others).unknown), (Some(171.5), vec!["Height Ref".into(), "ns".into()]));
}

#[test]
fn decimal_commas_do_not_hide_in_named_columns_that_are_left_over() {
    for text in [
        "image,lon,lat,alt,yaw,pitch,roll\na.jpg,8,25,50,5,171,5\n",
        "image,lon,lat,height,accuracy\na.jpg,8,25,50,5\n",
        "image,x,y,z\na.jpg,446833,05,5594521\n",
        "a.jpg,446833,05,5594521\n",
        "image,x,y,z,acc horz,acc vert\na.jpg,446833,25,5594521,5,171\n",
    ] {
        assert!(message(text).contains("may be meant as decimal commas"), "{text}: {}", message(text));
    }
    // Whole numbers in the columns that are read, or beside one with a point.
    assert_eq!(read("image,x,y,z\na.jpg,446833,5594521,171\n").rows[0].height, Some(171.0));
    assert_eq!(read("id,image,x,y,z\n7,a.jpg,446833,5594521,171\n").rows[0].height, Some(171.0));
    assert_eq!(read("image,x,y,z,accuracy\na.jpg,446833,5594521,171,3\n").rows[0].standard_errors, [Some(3.0); 2]);
    assert_eq!(read("image,x,y,z,yaw\na.jpg,446833,5594521,171,91\n").rows[0].height, Some(171.0));
    assert_eq!(read("image,x,y,z,yaw\na.jpg,446833,5594521,171,91\nb.jpg,446833,5594521,171,91.5\n").rows.len(), 2);
}

#[test]
fn tables_without_a_position_are_refused() {
    for (text, named) in [
        ("", "got no row and no position"),
        ("image,lon,lat\n", "got no row and no position"),
        ("# all\n", "got no row and no position"),
        ("image,lon,lat\na.jpg,,\n", "got one row without coordinates and no position"),
        ("image,lon,lat\na.jpg,,\nb.jpg,,\n", "got 2 rows without coordinates and no position"),
        ("image,lon,lat,note\na.jpg,8,50,\"bolt\nb.jpg,8,51,\n", "from line 2 on, a field in quotes"),
    ] {
        assert!(message(text).contains(named), "{text}: {}", message(text));
        assert!(position_head(text).is_err(), "{text}");
    }
    assert_eq!(read("#image,lat,lon\ra.jpg,50.5,8.25\rb.jpg,50.5,8.5\r").rows.len(), 2);
}

#[test]
fn places_without_heights_stand_between_blanks_too() {
    for text in ["EPSG:32615\na.jpg 446833.25 5594521.5\n", "image x y\na.jpg 446833,25 5594521,5\n"] {
        assert_eq!((read(text).rows[0].place, read(text).rows[0].height), ([446_833.25, 5_594_521.5], None), "{text}");
    }
}

#[test]
fn longitude_and_latitude_0_are_no_position() {
    let text = "image,lon,lat\na,0,0\nb,8,50\nc,0,50\n";
    assert_eq!(read(text).rows.iter().map(|row| row.image.as_str()).collect::<Vec<_>>(), ["b", "c"]);
    assert_eq!(position_head(text).unwrap().nowhere, ["a"]);
    assert_eq!(read("image,easting,northing\na,0,0\n").rows.len(), 1);
}

#[test]
fn images_without_coordinates_may_stand_first() {
    for head in ["#Label,X/Longitude,Y/Latitude,Z/Altitude", "Label,X/Longitude,Y/Latitude,Z/Altitude"] {
        let rows = read(&format!("{head}\na.jpg,,,\nb.jpg,8.25,50.5,171.5\n")).rows;
        assert_eq!(rows.iter().map(|row| (row.image.as_str(), row.line)).collect::<Vec<_>>(), [("b.jpg", 3)]);
    }
    assert_eq!(read("a.jpg,,,\nb.jpg,446833.25,5594521.5,171.5\n").rows[0].place, [446_833.25, 5_594_521.5]);
}

#[test]
fn what_is_wrong_is_named_by_line() {
    for (text, named) in [
        ("image,lon,lat,height\na,8,50,1\nb,8,x,1\n", "'x' for lat in line 3"),
        ("image,lon,lat,height\na,8,50,high\n", "'high' for height in line 2"),
        ("image,lon,lat\n# one\n,8,50\n", "the name '' in line 3"),
        ("image,lon,lat,acc\na,8.5,50,0\n", "0 in line 2"),
        ("image,lon,lat\na,8,50\nb,50,98\n", "longitude 50 and latitude 98 in line 3"),
        ("image,lon,northing\na,8,50\n", "'lon' beside 'northing'"),
        ("station,lon,lat\na,8,50\n", "no column 'image' (or photo, picture,"),
        ("image,lon,h\na,8,50\n", "no column 'latitude' (or "),
        ("image,lat,h\na,8,50\n", "no column 'longitude' (or "),
        ("a,446833.25,5594521.5,171.5\nb,446833.25,x,1\n", "'x' for #3 in line 2"),
    ] {
        let refused = message(text);
        assert!(refused.contains(named), "{text}: {refused}");
    }
}
