//! Tests: tables whose names of columns, codes and empty cells are those of further programs.

use super::control::{parse_ground_control_points, points_without_coordinates, unnamed_errors, unread_columns};
use super::control_forms::{first, message};
use super::marks::{parse_image_measurements, unread_mark_columns};
use super::position_forms::read as positions;
use super::positions::{parse_image_positions, position_head};

#[test]
fn commas_of_codes_and_notes_say_nothing_of_those_of_coordinates() {
    let coded = "name\tx\ty\tz\tcode\nP1\t446833.25\t5594521.5\t124.5\t12,345\n";
    assert_eq!(first(coded).1, [446_833.25, 5_594_521.5, 124.5]);
    let noted = "name\tx\ty\tz\tnote\nP1\t446,833\t594,521\t124\t1,5\n";
    assert!(message(noted).contains("whether commas"), "{}", message(noted));
    let quoted = "name,x,y,z,note\nP1,\"446,833\",\"594,521\",124,\"1,5\"\n";
    assert!(message(quoted).contains("whether commas"), "{}", message(quoted));
    // A point elsewhere is rather one behind thousands.
    assert!(message("name\tx\ty\tz\nP1\t446,833\t594,521\t124.5\n").contains("whether commas"));
    // A standard error tells it.
    let stated = "name\tx\ty\tz\tsigma_xy\tsigma_z\nP1\t446,833\t594,521\t124\t0,02\t0,03\n";
    assert_eq!(first(stated).1, [446.833, 594.521, 124.0]);
    let noted = "image\tx\ty\tnote\na.jpg\t446,833\t594,521\t1,5\n";
    assert!(parse_image_positions(noted).unwrap_err().to_string().contains("whether commas"));
}

#[test]
fn brackets_that_hold_no_unit_leave_a_column_what_it_is() {
    for head in [
        "Punkt;Ost (UTM32);Nord (UTM32);Höhe [m NHN]",
        "Punkt;E (UTM);N (UTM);Höhe (m ü. NHN)",
        "Point;Easting;Northing;Elevation (NAVD88)",
        "Punkt;Ost;Nord;H (DHHN2016)",
        "Punkt;X;Y;Z (EGM96)",
        "Punkt;X;Y;Altitude (m MSL)",
        "Pt;E LV95;N LV95;H LN02",
        "Point;Longitude (dd);Latitude (WGS84);Altitude",
        "Point;Longitude [deg E];Latitude [deg N];Altitude",
    ] {
        assert_eq!(first(&format!("{head}\n7;1,5;2,5;3,5\n")), ("7".into(), [1.5, 2.5, 3.5], None), "{head}");
    }
    // What is of something else is no coordinate, and longitudes to the west are refused.
    assert!(message("name,x,y,h (antenna)\nA,1.5,2,3\n").contains("neither a column 'z'"));
    let west = message("name,Longitude [deg W],Latitude,z\nA,1.5,2,3\n");
    assert!(west.contains("the column 'Longitude [deg W]', in a unit that is not known; allowed: degrees or"), "{west}");
    let rod = message("name,x,y,H (rod)\nA,1.5,2,3\n");
    assert!(rod.contains("not known; allowed: mm, cm"), "{rod}");
}

#[test]
fn numbers_behind_the_coordinates_that_can_be_no_standard_errors_are_refused() {
    for text in ["1,446833.2,5594521.7,124.0,101,3\n", "1;446833,2;5594521,7;124,0;3;101\n"] {
        let refused = message(text);
        assert!(refused.contains("5 numbers behind the name in line 1") && refused.contains("up to 10 m"), "{refused}");
    }
    assert_eq!(first("1,446833.2,5594521.7,124.0,10,3\n").2, Some([10.0, 3.0]));
}

#[test]
fn names_with_signs_and_systems_in_them_are_known() {
    for head in [
        "Point #;X;Y;Z",
        "Pt#;X;Y;Z",
        "n;x;y;z",
        "Point;Easting;Northing;Ellip. Hgt.",
        "Point;Local E;Local N;Local H",
        "Point;E LV95;N LV95;H LN02",
        "Punkt;UTM-Ost;UTM-Nord;NHN-Höhe",
    ] {
        assert_eq!(first(&format!("{head}\n7;1,5;2,5;3,5\n")), ("7".into(), [1.5, 2.5, 3.5], None), "{head}");
    }
    for head in ["Photo #;X;Y", "Nom de l'image;X;Y", "اسم الصورة;X;Y"] {
        assert_eq!(parse_image_positions(&format!("{head}\na.jpg;1000,5;2,5\n")).unwrap().rows[0].image, "a.jpg", "{head}");
        let mark = parse_image_measurements(&format!("P;{head};Point #\n1;a.jpg;10,5;20;P1\n")).unwrap().remove(0);
        assert_eq!((&mark.image[..], &mark.point[..], mark.x_px), ("a.jpg", "P1", 10.5), "{head}");
    }
}

#[test]
fn standard_errors_are_known_in_other_languages_and_by_horizontal_and_vertical() {
    for (head, values) in [
        ("Précision XY;Précision Z", "0,02;0,03"),
        ("Ecart-type XY;Ecart-type Z", "0,02;0,03"),
        ("Écart-type XY;Écart-type Z", "0,02;0,03"),
        ("StdAbw Ost;StdAbw Nord;StdAbw Höhe", "0,01;0,02;0,03"),
        ("HRMS;VRMS", "0,02;0,03"),
        ("H Precision;V Precision", "0,02;0,03"),
        ("VRMS;HRMS", "0,03;0,02"),
    ] {
        assert_eq!(first(&format!("name;x;y;z;{head}\nA;1,5;2,5;3,5;{values}\n")).2, Some([0.02, 0.03]), "{head}");
    }
    assert_eq!(first("name,x,y,z,Accuracy_X/Y/Z_(m)\nA,1.5,2,3,0.02\n").2, Some([0.02, 0.02]));
    // By itself the letter may be of either.
    assert_eq!(unread_columns("name,x,y,z,HRMS\nA,1.5,2,3,0.4\n").unwrap().unknown, ["HRMS"]);
}

#[test]
fn dashes_stand_for_numbers_that_are_none() {
    for dash in ["-", "–"] {
        for head in ["name,x,y,z\n", ""] {
            let text = format!("{head}P1,446833.2,5594521.7,124.5\nP2,{dash},{dash},{dash}\n");
            assert_eq!(parse_ground_control_points(&text).unwrap().len(), 1, "{text}");
            assert_eq!(points_without_coordinates(&text).unwrap(), ["P2"], "{text}");
        }
        let positions = parse_image_positions(&format!(
            "image,x,y,z\nb.jpg,{dash},{dash},{dash}\na.jpg,446833.2,5594521.7,124.5\nc.jpg,446833.2,5594521.7,{dash}\n"
        ));
        assert_eq!(positions.unwrap().rows.iter().map(|row| row.height).collect::<Vec<_>>(), [Some(124.5), None]);
        let stated = format!("name,x,y,z,sigma_xy,sigma_z\nA,1.5,2,3,{dash},{dash}\n");
        assert_eq!(first(&stated).2, None);
        assert!(message(&format!("name,x,y,z\nA,1.5,{dash},3\n")).contains("for y in line 2"));
    }
}

#[test]
fn longitudes_and_latitudes_are_read_with_their_hemispheres() {
    let south = "name,longitude,latitude,height\nA,8.25 W,33.5 S,3\n";
    assert_eq!(first(south).1, [-8.25, -33.5, 3.0]);
    let [x, y, _] = first("name;Länge;Breite;Höhe\nA;8°15'0\" E;33° 30' N;3\n").1;
    assert!((x - 8.25).abs() < 1e-12 && (y - 33.5).abs() < 1e-12, "{x} {y}");
    for wrong in ["name,longitude,latitude,height\nA,-8.25 E,33.5,3\n", "name,x,y,z\nA,8.25 W,33.5,3\n"] {
        assert!(message(wrong).contains("for x in line 2"), "{wrong}: {}", message(wrong));
    }
}

#[test]
fn heights_are_read_under_many_names_or_it_is_said_that_they_are_not() {
    for name in [
        "Höhe [m NHN]",
        "Elevation (NAVD88)",
        "AbsoluteAltitude",
        "Hauteur ellipsoïdale",
        "Altitude ellipsoïdale",
        "Altura elipsoidal",
        "Ellip. Hgt.",
    ] {
        let text = format!("image,x,y,{name}\na.jpg,446833.25,5594521.5,171.5\n");
        assert_eq!(positions(&text).rows[0].height, Some(171.5), "{name}");
        assert_eq!(position_head(&text).unwrap().unread_height, None, "{name}");
    }
    for name in ["Height (rod)", "Antenna height", "h (ft/10)"] {
        let text = format!("image,x,y,{name}\na.jpg,446833.25,5594521.5,171.5\n");
        assert_eq!(positions(&text).rows[0].height, None, "{name}");
        assert_eq!(position_head(&text).unwrap().unread_height, Some((name.into(), 1)), "{name}");
    }
    let without = "image,x,y,height accuracy,yaw\na.jpg,446833.25,5594521.5,1.5,91\n";
    assert_eq!(position_head(without).unwrap().unread_height, None);
}

#[test]
fn heights_on_an_unknown_side_of_sea_level_are_left_out_and_counted() {
    let head = "SourceFile,GPSLatitude,GPSLongitude,GPSAltitude,GPSAltitudeRef\n";
    let text = format!("{head}a.jpg,50.5,8.25,171.5,2\nb.jpg,50.5,8.25,3,Negative Sea Level (sea-level ref)\nc.jpg,50.5,8.25,3,4\n");
    assert_eq!(positions(&text).rows.iter().map(|row| row.height).collect::<Vec<_>>(), [Some(171.5), Some(-3.0), None]);
    assert_eq!(position_head(&text).unwrap().unread_height, Some(("GPSAltitudeRef".into(), 1)));
}

#[test]
fn hemispheres_of_points_stand_in_columns_of_their_own_too() {
    let head = "name,GPSLatitude,GPSLatitudeRef,GPSLongitude,GPSLongitudeRef,height\n";
    let south = format!("{head}A,33.5,S,8.25,West,3\n");
    assert_eq!(first(&south).1, [-8.25, -33.5, 3.0]);
    assert!(unread_columns(&south).unwrap().unknown.is_empty());
    assert!(message(&format!("{head}A,-33.5,N,8.25,E,3\n")).contains("'-33.5 N' for y in line 2"));
    assert!(message(&format!("{head}A,33.5,S,8.25,,3\n")).contains("'8.25 ' for x in line 2"));
}

#[test]
fn standard_errors_are_of_any_coordinate_by_any_of_its_names() {
    let named = |head: &str| first(&format!("Name,{head}\nP1,8.5,50.5,152,0.01,0.02,0.03\n")).2;
    for head in [
        "Longitude,Latitude,Ellipsoidal height,Longitude RMS,Latitude RMS,Ellipsoidal height RMS",
        "X/Easting,Y/Northing,Z/Altitude,X/Easting_Accuracy_(m),Y/Northing_Accuracy_(m),Z/Altitude_Accuracy_(m)",
        "GPSLongitude,GPSLatitude,AbsoluteAltitude,RtkStdLon,RtkStdLat,RtkStdHgt",
        "x,y,z,sigma (x),sigma [y],sigma (z)",
    ] {
        assert_eq!(named(head), Some([0.02, 0.03]), "{head}");
    }
    for head in [
        "Précision horizontale (m);Précision verticale (m)",
        "Ecart type planimétrique;Ecart type altimétrique",
        "σ_xy;σ_z",
        "Horiz. Prec.;Vert. Prec.",
    ] {
        assert_eq!(first(&format!("name;x;y;z;{head}\nA;1,5;2,5;3,5;0,02;0,03\n")).2, Some([0.02, 0.03]), "{head}");
    }
    // Estimates of Metashape are no coordinates to the east.
    let estimated = "#Label,X/Easting,Y/Northing,Z/Altitude,X_est,Y_est,Z_est\nP1,1.5,2,3,4,5,6\n";
    assert_eq!(unread_columns(estimated).unwrap().unknown, ["X_est", "Y_est", "Z_est"]);
}

#[test]
fn heights_above_the_sea_are_none_of_longitudes_and_latitudes() {
    for name in ["Elevation (NAVD88)", "Höhe [m NHN]", "NN-Höhe", "Altitude (m MSL)", "alt_msl", "Altitude above sea level"] {
        let of = |place: &str| format!("image,{place},{name}\na.jpg,8.25,50.5,171.5\n");
        let geographic = of("lon,lat");
        assert_eq!(positions(&geographic).rows[0].height, None, "{name}");
        assert_eq!(position_head(&geographic).unwrap().unread_height, Some((name.into(), 1)), "{name}");
    }
    let both = "image,lon,lat,Elevation (NAVD88),Ellip. Hgt.\na.jpg,8.25,50.5,124.5,171.5\n";
    assert_eq!(positions(both).rows[0].height, Some(171.5));
    assert_eq!(positions("image,x,y,orthometric height\na.jpg,446833.25,5594521.5,171.5\n").rows[0].height, Some(171.5));
    assert_eq!(positions("image,x,y,orthometric height\na.jpg,8.25,50.5,171.5\n").rows[0].height, None);
    let both = "image,easting,northing,H (ell.),H (NHN)\na.jpg,446833.25,5594521.5,171.5,124.5\n";
    assert_eq!(positions(both).rows[0].height, Some(124.5));
    // In a plane heights count from where those of its system do.
    assert_eq!(positions("image,easting,northing,alt_msl\na.jpg,446833.25,5594521.5,171.5\n").rows[0].height, Some(171.5));
    let above_ground = "image,lon,lat,alt_agl\na.jpg,8.25,50.5,60\n";
    assert_eq!(position_head(above_ground).unwrap().unread_height, Some(("alt_agl".into(), 1)));
}

#[test]
fn heads_of_further_languages_and_programs_are_known() {
    for head in [
        "Punktnr;Öst;Norr;Höjd",
        "Punkt;E (SWEREF 99 TM);N (SWEREF 99 TM);Höjd (RH2000)",
        "Matricule;X (L93);Y (L93);Z (IGN69)",
        "Numéro;Est;Nord;Altitude NGF",
        "Point ID;Grid Easting;Grid Northing;Elevation",
        "Point Number;Easting;Northing;Point Elevation",
        "Pkt;ETRS89_Ost;ETRS89_Nord;Höhe_NHN",
        "Pkt;GK-Rechtswert;GK-Hochwert;NN-Höhe",
        "name;WGS84 Longitude;WGS84 Latitude;WGS84 Ellip. Height",
        "name;gps_lon;gps_lat;gps_alt",
        "Pkt;Längengrad;Breitengrad;Ell. Höhe",
    ] {
        assert_eq!(first(&format!("{head}\n7;1,5;2,5;3,5\n")), ("7".into(), [1.5, 2.5, 3.5], None), "{head}");
    }
    for unknown in ["name;WGS84 X;WGS84 Y;WGS84 Z", "name;e;n;geoid height"] {
        assert!(message(&format!("{unknown}\n7;1,5;2,5;3,5\n")).contains("neither a column"), "{unknown}");
    }
    for heights in ["H (ell.);H (NHN)", "H ell;H orth", "WGS84 Height;Elevation", "Alt_ell;Alt_msl"] {
        assert_eq!(first(&format!("Pkt;E;N;{heights}\n7;1,5;2,5;50,5;3,5\n")).1, [1.5, 2.5, 3.5], "{heights}");
    }
    assert_eq!(first("Pkt;Y (GK M34);X (GK M34);H\n7;2,5;1,5;3,5\n").1, [1.5, 2.5, 3.5]);
}

#[test]
fn coordinates_are_no_names() {
    for text in ["446833.2,5594521.7,124.0,1\n446834.2,5594522.7,124.5,2\n", "446833,2;5594521,7;124,0;1\n"] {
        assert!(message(text).contains("neither a column 'name'"), "{text}: {}", message(text));
    }
    assert_eq!(first("1.1,446833.2,5594521.7,124.5\n").0, "1.1");
    assert_eq!(first("1.1,446833.2,5594521.7,124\nP2,446834.2,5594522.7,125\n").0, "1.1");
}

#[test]
fn numbers_without_names_that_may_be_codes_are_named_where_they_are_read_as_standard_errors() {
    assert_eq!(unnamed_errors("1,446833.2,5594521.7,124.0,3,2\n").unwrap(), ["#5", "#6"]);
    for certain in
        ["1,446833.2,5594521.7,124.0,0.02,0.03\n", "name,x,y,z,sigma_xy,sigma_z\n1,2.5,3,4,3,2\n", "1,446833.2,5594521.7,124.0\n"]
    {
        assert!(unnamed_errors(certain).unwrap().is_empty(), "{certain}");
    }
}

#[test]
fn image_measurements_are_in_px_and_their_other_columns_are_named() {
    for (head, column) in [("x (mm),y (mm)", "x (mm)"), ("x_norm,y_norm", "x_norm"), ("x,y (up)", "y (up)"), ("x_mm,y_mm", "x_mm")] {
        let refused = parse_image_measurements(&format!("image,point,{head}\na.jpg,P1,0.5,0.2\n")).unwrap_err().to_string();
        assert!(refused.contains(&format!("the column '{column}', in a unit that is not known; allowed: px")), "{refused}");
    }
    let read = |text: &str| parse_image_measurements(text).unwrap()[0].x_px;
    assert_eq!(read("Bild;Punkt;Bildkoordinate x;Bildkoordinate y\na.jpg;P1;100,5;200,5\n"), 100.5);
    for thousands in ["image\tpoint\tx\ty\na.jpg\tP1\t1,024\t2,048\n", "a.jpg\tP1\t1,024\t2,048\n"] {
        assert!(parse_image_measurements(thousands).unwrap_err().to_string().contains("whether commas"), "{thousands}");
    }
    assert_eq!(read("image\tpoint\tx\ty\na.jpg\tP1\t1,024\t2,04\n"), 1.024);
    assert_eq!(unread_mark_columns("image,point,x,y,enabled,accuracy\na.jpg,P1,1.5,2,0,0.5\n").unwrap(), ["enabled", "accuracy"]);
    assert_eq!(unread_mark_columns("image,Ziel,x,y,weight\na.jpg,P1,1.5,2,0\n").unwrap(), ["weight"]);
    assert_eq!(unread_mark_columns("a.jpg,P1,1.5,2,7\n").unwrap(), ["#5"]);
    assert!(unread_mark_columns("image,point,x,y\na.jpg,P1,1.5,2\n").unwrap().is_empty());
}
