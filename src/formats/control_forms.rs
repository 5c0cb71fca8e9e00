//! Tests: tables of control points and image measurements in the forms of surveyors' programs.

use super::columns::UnreadColumns;
use super::control::{ground_control_table, parse_ground_control_points, points_without_coordinates, stated_units, unread_columns};
use super::marks::{ImageMeasurementRow, image_measurement_table, parse_image_measurements};
use super::positions::parse_image_positions;
use crate::ControlRole;

/// Name, position and standard errors of the first point.
pub(super) fn first(text: &str) -> (String, [f64; 3], Option<[f64; 2]>) {
    let point = parse_ground_control_points(text).unwrap_or_else(|error| panic!("{text}: {error}")).remove(0);
    (point.name, point.position, point.standard_errors)
}

/// Why a table of points is refused.
pub(super) fn message(text: &str) -> String {
    parse_ground_control_points(text).unwrap_err().to_string()
}

fn marks_message(text: &str) -> String {
    parse_image_measurements(text).unwrap_err().to_string()
}

#[test]
fn names_behind_a_comment_sign_say_what_columns_hold() {
    let metashape = "# CoordinateSystem: PROJCS[\"WGS 84 / UTM zone 32N\",1,2]\n\
        #Label,X/Easting,Y/Northing,Z/Altitude,Error_(m),X_error,Y_error,Z_error\nP1,412630.5,5316020.25,104.5,0.031,0.01,-0.02,0.02\n# Total Error\n";
    assert_eq!(first(metashape), ("P1".into(), [412_630.5, 5_316_020.25, 104.5], None));
    assert_eq!(unread_columns(metashape).unwrap().unknown, ["Error_(m)", "X_error", "Y_error", "Z_error"]);
    let with_enable = "#Label,Enable,X/Easting,Y/Northing,Z/Altitude\nP1,1,412630,5316020,104\n";
    assert_eq!(first(with_enable).1, [412_630.0, 5_316_020.0, 104.0]);
    assert_eq!(unread_columns(with_enable).unwrap(), UnreadColumns::default());
    for head in [
        "#name,northing,easting,height",
        "# name;northing;easting;height",
        "//name,northing,easting,height",
        "// a list\n#name,northing,easting,height\n",
    ] {
        assert_eq!(first(&format!("{head}\nA,2,1,3\n")).1, [1.0, 2.0, 3.0], "{head}");
    }
    assert_eq!(stated_units("#name,northing (ft),easting (ft),height\nA,2,1,3\n").unwrap().len(), 2);
    let read = |text: &str| parse_image_measurements(text).unwrap().remove(0);
    let mark = read("#image,point,row,col\na.jpg,P1,20,10.5\n");
    assert_eq!([mark.x_px, mark.y_px], [10.5, 20.0]);
    // Folders of a network begin like a comment.
    assert_eq!(read("//nas/a.jpg,P1,10.5,20\n").image, "//nas/a.jpg");
}

#[test]
fn comments_that_name_no_columns_leave_these_in_order_and_those_that_name_some_elsewhere_are_refused() {
    for comment in ["# GCPs, measured 3.5.2024, N", "#name,x,y,z", "# x is east, y is north", "#"] {
        assert_eq!(first(&format!("{comment}\nA,1,2,3,0.02,0.03\n")), ("A".into(), [1.0, 2.0, 3.0], Some([0.02, 0.03])), "{comment}");
    }
    // The names stand directly above the rows.
    assert_eq!(first("#name,y,x,z\n# of a map\nA,1,2,3\n").1, [1.0, 2.0, 3.0]);
    let refused = message("#name,northing,easting,ht\nA,2,1,3\n");
    assert!(refused.contains("neither a column 'z'") && refused.contains("'name,northing,easting,ht'"), "{refused}");
    let refused = marks_message("#image,Ziel,row,col\na.jpg,P1,20,10.5\n");
    assert!(refused.contains("no column 'point'") || refused.contains("'image,target,row,col'"), "{refused}");
    assert!(message("#name,y,x,z\nA,2,1,3,0.02,0.03\n").contains("more fields than the 4 columns"));
    // The sign may itself be the name of the first column.
    assert_eq!(first("#,Y,X,Z\n7,2,1,3\n"), ("7".into(), [1.0, 2.0, 3.0], None));
}

#[test]
fn commas_that_may_be_decimal_commas_are_refused() {
    for text in [
        "101,1040,123,2040,456,116,789\n",
        "101,1040,1,2040,4,6,7\n",
        "101,1040,12,2040,45,116\n",
        "101,1040,5,2040,05,116\n",
        "101,1040,123,2040,456,116,789,0,02,0,03\n",
        "A,1.5,2.5,3.5,0.02,0.02,50\n",
    ] {
        let refused = message(text);
        assert!(refused.to_lowercase().contains("decimal commas"), "{text}: {refused}");
    }
    let more = message("name,x,y,z\n101,1040,123,2040,456,116,789\n");
    assert!(
        more.contains("'101,1040,123,2040,456,116,789' in line 2, with more fields than the 4 columns") && more.contains("decimal commas"),
        "{more}"
    );
    assert!(marks_message("a.jpg,P1,10,5,20,25\n").contains("decimal commas"));
    assert!(marks_message("image,point,x,y\na.jpg,P1,10,5,20,25\n").contains("decimal commas"));
    // Semicolons show what is more, and commas at ends of lines are spreadsheets'.
    assert_eq!(first("name,x,y,z\n101,1040,2040,116,,,\n").1, [1040.0, 2040.0, 116.0]);
    assert_eq!(unread_columns("name;x;y;z\n101;1040;2040;116;TP\n").unwrap().unknown, ["#5"]);
    // Three standard errors, and a code behind them.
    assert_eq!(first("A,1.5,2.5,3.5,0.02,0.05,0.03\n").2, Some([0.05, 0.03]));
    assert_eq!(first("A;1,5;2,5;3,5;0,05;0,02;0,03;TP\n").2, Some([0.05, 0.03]));
    assert_eq!(first("A,1,2,3,4,5\n").2, Some([4.0, 5.0]));
}

#[test]
fn decimal_commas_in_quotes_are_read_where_they_cannot_be_thousands() {
    let quoted = "name,x,y,z\nA,\"428374,069\",\"5316020,123\",\"104,500\"\n";
    assert_eq!(first(quoted).1, [428_374.069, 5_316_020.123, 104.5]);
    assert!(message("name,x,y,z\nA,\"428,374\",\"316,020\",\"104\"\n").contains("'428,374' for x in line 2"));
    assert!(message("name,x,y,z\nA,\"1,428,374\",\"0,5\",\"104\"\n").contains("'1,428,374' for x in line 2"));
}

#[test]
fn use_is_read_in_the_words_of_other_programs() {
    let roles = |text: &str| parse_ground_control_points(text).unwrap().iter().map(|point| point.role).collect::<Vec<_>>();
    let [control, check] = [Some(ControlRole::Control), Some(ControlRole::Check)];
    let table = |head: &str, words: &[&str]| {
        let rows: Vec<String> = words.iter().enumerate().map(|(row, word)| format!("P{row},1,2,3,{word}")).collect();
        format!("name,x,y,z,{head}\n{}\n", rows.join("\n"))
    };
    assert_eq!(roles(&table("Type", &["3D GCP", "Check Point", "GCP", "CP", ""])), [control, check, control, check, control]);
    assert_eq!(roles(&table("Typ", &["Passpunkt", "Kontrollpunkt"])), [control, check]);
    assert_eq!(roles(&table("use", &["Control", "off", "check_point"])), [control, None, check]);
    assert_eq!(roles(&table("enabled", &["1", "0", "TRUE", "false"])), [control, None, control, None]);
    assert_eq!(roles("name,x,y,z,Type,Enabled\na,1,2,3,Check Point,1\nb,1,2,3,Check Point,0\n"), [check, None]);
    // What is no use is left out as a column that says nothing, and one that is partly is refused.
    let natural = table("Type", &["bolt", "paint"]);
    assert_eq!((roles(&natural), unread_columns(&natural).unwrap().unknown), (vec![control; 2], vec!["Type".to_string()]));
    for (words, named) in [(&["Check Point", "2D GCP"][..], "'2D GCP' as use in line 3"), (&["CP", "CP"], "'CP' as use in line 2")] {
        let refused = message(&table("Type", words));
        assert!(refused.contains(named), "{refused}");
    }
    assert!(message(&table("enabled", &["1", "perhaps"])).contains("'perhaps' as use in line 3"));
}

#[test]
fn standard_errors_in_other_units_are_converted_or_refused() {
    for (head, values, wanted) in [
        ("sigma_xy (mm),sigma_z (cm)", "20,3", [0.02, 0.03]),
        ("Accuracy Horz (m),Accuracy Vert (m)", "0.02,0.03", [0.02, 0.03]),
        ("sigma_x (mm),sigma_y (cm),sigma_z", "20,5,0.03", [0.05, 0.03]),
        ("Accuracy [mm]", "20", [0.02, 0.02]),
        ("Genauigkeit Lage,Genauigkeit Höhe", "0.02,0.03", [0.02, 0.03]),
        ("sigma E,sigma N,Höhengenauigkeit", "0.02,0.01,0.03", [0.02, 0.03]),
        ("sigma_xy (ft),sigma_z (us-ft)", "1.0,3937", [0.3048, 1200.0]),
    ] {
        let [across, up] = first(&format!("name,x,y,z,{head}\nA,1,2,3,{values}\n")).2.unwrap();
        assert!((across - wanted[0]).abs() < 1e-12 && (up - wanted[1]).abs() < 1e-9, "{head}: {across} {up}");
    }
    for unknown in ["sigma_xy (dm)", "accuracy [inch]", "sigma_x (deg)"] {
        let refused = message(&format!("name,x,y,z,{unknown}\nA,1,2,3,0.02\n"));
        assert!(
            refused.contains(&format!("the column '{unknown}', in a unit that is not known; allowed: standard errors in mm, cm, m,")),
            "{refused}"
        );
    }
    assert!(message("name,x,y,z,sigma_x (mm)\nA,1,2,3,4\n").contains("'sigma_x (mm)' without the other"));
}

#[test]
fn blanks_separate_where_nothing_else_does_and_all_lines_have_as_many_words() {
    let wanted = ("101".to_string(), [428_374.069, 5_316_020.123, 104.5], None);
    for text in [
        "101 428374.069 5316020.123 104.5\n102   428375.069  5316020.123  104.5\n",
        "  101 428374,069 5316020,123 104,5\n",
        "Punkt Rechtswert Hochwert Höhe\n101 428374.069 5316020.123 104.5\n",
        "# Punkt Rechtswert Hochwert Höhe\n101 428374.069 5316020.123 104.5\n",
        "#  Y X Z\n101 5316020.123 428374.069 104.5\n",
    ] {
        assert_eq!(first(text), wanted, "{text}");
    }
    assert_eq!(first("101 1 2 3 0.02 0.03\n").2, Some([0.02, 0.03]));
    let mark = parse_image_measurements("a.jpg 101 10.5 20\n").unwrap().remove(0);
    assert_eq!((&mark.image[..], &mark.point[..], mark.x_px, mark.y_px), ("a.jpg", "101", 10.5, 20.0));
    // A blank in a name shifts what stands behind it.
    for (text, named) in [
        ("GCP 1 428374.069 5316020.123 104.5\n", "'GCP 1 428374.069 5316020.123 104.5'"),
        ("A 1 428374.069 5316020.123 104.5 0.02\n", "5 numbers behind the name in line 1"),
        ("A 1 428374.069 5316020.123 104.5 0.02 0.03\n", "6 numbers behind the name in line 1"),
        ("101 1 2 3\nA 102 1 2 3\n", "in line 2, between blanks where the table has 4 columns"),
        ("Point No. X Y Z\n101 1 2 3\n", "in line 2, between blanks where the table has 5 columns"),
    ] {
        let refused = message(text);
        assert!(refused.contains(named), "{text}: {refused}");
    }
    // As OpenDroneMap has them, which is neither.
    for odm in ["EPSG:32632\n4490.1 5300.2 300.5 100 200 a.jpg P1\n", "4490.1 5300.2 300.5 100 200 a.jpg P1\n"] {
        message(odm);
        marks_message(odm);
    }
}

#[test]
fn heads_in_other_languages_below_titles_and_above_units_are_read() {
    for head in [
        "Matricule;Est;Nord;Altitude",
        "N°;Est;Nord;Altitude",
        "Punto;Este;Norte;Cota",
        "Punto;Est;Nord;Quota",
        "Ponto;Este;Norte;Cota",
        "النقطة;الشرق;الشمال;الارتفاع",
        "Punkt;Y (Ost);X (Nord);Höhe",
        "Punkt;Rechtswert (Y);Hochwert (X);Höhe",
        "Punkt;Y/Rechtswert;X_Hochwert;Z (Höhe)",
        "Passpunkte Flug 7\nStand;3.5.2024\nPunkt;Rechtswert;Hochwert;Höhe",
        "Passpunkte Flug 7, Stand 3.5.2024\nPunkt;Rechtswert;Hochwert;Höhe",
        "Punkt;Rechtswert;Hochwert;Höhe\n;[m];[m];[m]",
    ] {
        assert_eq!(first(&format!("{head}\n7;1,5;2,5;3,5\n")), ("7".into(), [1.5, 2.5, 3.5], None), "{head}");
    }
    assert_eq!(first("Punkt;X (Nord);Y (Ost);Z\n7;2;1;3\n").1, [1.0, 2.0, 3.0]);
    // Units below names count as those behind them.
    let in_feet = "name,easting,northing,height,sigma_xy,sigma_z\n,ft,ft,m,mm,mm\nA,1,2,3,20,30\n";
    assert_eq!(stated_units(in_feet).unwrap().iter().map(|is| is.unit).collect::<Vec<_>>(), ["ft", "ft", "m"]);
    assert_eq!(first(in_feet), ("A".into(), [1.0, 2.0, 3.0], Some([0.02, 0.03])));
    assert_eq!(parse_image_measurements("image,point,x,y\n,,px,px\na.jpg,P1,1,2\n").unwrap().len(), 1);
    // Words that contradict each other name nothing, and a title over rows without names is none of their rows.
    assert!(message("Punkt;Ost (Nord);Nord (Ost);Z\n7;2;1;3\n").contains("neither a column 'x'"));
    assert!(message("Passpunkte\n7;2;1;3\n").contains("'Passpunkte'"));
    // A message shows the line that names most.
    assert!(message("Liste\nPunkt;Rechts;Hoch;Koten\n7;2;1;3\n").contains("neither a column 'z'"));
}

#[test]
fn decimal_commas_do_not_hide_in_named_columns_that_are_left_over() {
    for text in [
        "name,x,y,z,sigma_xy,sigma_z,code\nA,428374,069,5316020,123,104,5\n",
        "name,x,y,z,sigma_xy,sigma_z\nA,428374,5,5316020,123,104\n",
        "name,x,y,z,date,remark,crew\nA,428374,5,5316020,123,104\n",
        "name,x,y,z,date,remark\nA,428374,5,5316020,123,104\n",
        "name,longitude,latitude,z,code,crew\nA,8,25,50,5,104\n",
        "name,x,y,z\nA,428374,069,5316020\n",
        "A,428374,069,5316020\n",
    ] {
        assert!(message(text).contains("may be meant as decimal commas"), "{text}: {}", message(text));
    }
    assert!(marks_message("image,point,x,y,error,size,note\na.jpg,P1,10,5,20,25\n").contains("may be meant as decimal commas"));
    // The message names what makes whole numbers certain.
    let certain = "name,x,y,z,date,crew\nA,428374,5316020,104,5\n";
    assert!(message(certain).contains("(1024.0 for 1024)"), "{}", message(certain));
    assert_eq!(first(&certain.replace("104", "104.0")).1, [428_374.0, 5_316_020.0, 104.0]);
    // With decimals rows would have more fields than names.
    let full = "name,x,y,z,date\nA,428374,5316020,104,5\nB,428474,5316120,105,\n";
    assert_eq!(first(full).1, [428_374.0, 5_316_020.0, 104.0]);
    assert!(message(&full.replace("105,", "105")).contains("may be meant as decimal commas"));
    let boxes = "image,marker,x,y,w,h\na.jpg,1,100,200,40,40\n";
    assert_eq!(parse_image_measurements(boxes).unwrap()[0].x_px, 100.0);
    // Tables of whole numbers have as many as are read, and a point anywhere shows that commas are none.
    assert_eq!(first("name,x,y,z\nA,428374,5316020,104\n").1, [428_374.0, 5_316_020.0, 104.0]);
    assert_eq!(first("name,x,y,z,sigma_xy,sigma_z,code\nA,428374,5316020,104,1,2,TP\n").2, Some([1.0, 2.0]));
    assert_eq!(first("x,y,z,nr\n428374,5316020,104,7\n").0, "7");
    assert_eq!(first("name,x,y,z,enabled,code\nA,428374,5316020,104,1,TP\n").1[2], 104.0);
    assert_eq!(first("name,x,y,z,code\nA,428374,5316020,104,5\nB,428374.5,5316020,104,5\n").1[2], 104.0);
    for text in ["image,point,x,y\na.jpg,P1,10,5\n", "id,image,point,x,y\n7,a.jpg,1,10,5\n", "x,y,point,image\n10,5,1,a.jpg\n"] {
        let mark = parse_image_measurements(text).unwrap().remove(0);
        assert_eq!([mark.x_px, mark.y_px], [10.0, 5.0], "{text}");
    }
}

#[test]
fn points_without_coordinates_are_skipped_and_named() {
    for text in [
        "#Label,X/Easting,Y/Northing,Z/Altitude\nP0,,,\nP1,412630.5,5316020.25,104.5\nP2,,,\n",
        "#Label,X/Easting,Y/Northing,Z/Altitude,X_est,Y_est,Z_est\nP0,,,,412630.1,5316020.1,104\nP1,412630.5,5316020.25,104.5,1,2,3\nP2,,,,,,\n",
        "name,x,y,z\nP0,,,\nP1,412630.5,5316020.25,104.5\nP2,,,\n",
        "P0;;;\nP1;412630,5;5316020,25;104,5\nP2;;;\n",
    ] {
        let points = parse_ground_control_points(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let names: Vec<&str> = points.iter().map(|point| point.name.as_str()).collect();
        assert_eq!((names, points[0].position), (vec!["P1"], [412_630.5, 5_316_020.25, 104.5]), "{text}");
        assert_eq!(points_without_coordinates(text).unwrap(), ["P0", "P2"], "{text}");
    }
    assert!(message("name,x,y,z\nP0,412630.5,,\nP1,1,2,3\n").contains("'' for y in line 2"));
    assert!(message("name,x,y,z\nP1,1,2,3\nTotal\n").contains("'' for x in line 3"));
}

#[test]
fn names_that_begin_as_a_comment_does_read_back() {
    let points = parse_ground_control_points("x,y,z,name\n1.5,2,3,#1\n2.5,3,4,# 2\n").unwrap();
    assert_eq!(points[1].name, "# 2");
    assert_eq!(parse_ground_control_points(&ground_control_table(&points)).unwrap(), points);
    let marks = parse_image_measurements("point,image,x,y\n#1,x/#1.jpg,1.5,2\nP,#1.jpg,1.5,2\n").unwrap();
    assert_eq!(marks.len(), 1, "a line that begins with the sign is a comment");
    let marks = [ImageMeasurementRow { image: "#1.jpg".into(), point: "#1".into(), x_px: 1.5, y_px: 2.0 }];
    assert_eq!(parse_image_measurements(&image_measurement_table(&marks)).unwrap(), marks);
}

#[test]
fn a_column_that_may_be_something_else_is_read_where_no_better_one_is_named() {
    let wanted = [446_833.2, 5_594_521.7, 124.0];
    for text in [
        "Nr,Easting,Northing,Height,N\n1,446833.2,5594521.7,124,5\n",
        "N,Easting,Northing,Height,Point\n5,446833.2,5594521.7,124,1\n",
        "Point,Northing,Easting,Elevation,h\n1,5594521.7,446833.2,124,1.8\n",
        "Point,N,E,h\n1,5594521.7,446833.2,124\n",
        "Point,Longitude,Latitude,E,N,H\n1,8.25,50.5,446833.2,5594521.7,124\n",
        "Point,x,y,z,lon,lat,h\n1,446833.2,5594521.7,124,8.25,50.5,171\n",
    ] {
        assert_eq!(first(text).1, wanted, "{text}");
    }
    assert_eq!(first("Point,Longitude,Latitude,Height,N\n1,8.25,50.5,124,5\n").1, [8.25, 50.5, 124.0]);
    // Emlid: the lateral error is of both axes together.
    let emlid = "Name,Easting,Northing,Elevation,Easting RMS,Northing RMS,Elevation RMS,Lateral RMS\nP1,1,2,3,0.010,0.012,0.020,0.016\n";
    assert_eq!((first(emlid).2, unread_columns(emlid).unwrap().doubled), (Some([0.012, 0.02]), vec!["Lateral RMS (Easting RMS)".into()]));
    for head in ["SdE,SdN,SdH", "Std Dev E,Std Dev N,Std Dev H", "sigma_e,sigma_n,sigma_h"] {
        assert_eq!(first(&format!("Point,East,North,Height,{head}\nP1,1,2,3,0.01,0.03,0.02\n")).2, Some([0.03, 0.02]), "{head}");
    }
    for head in ["image,point,X,Y,Z,x_px,y_px", "image,point,X,Y,Z,Column (px),Row (px)", "image,point,x,y,z,px,py"] {
        let mark = parse_image_measurements(&format!("{head}\na.jpg,P1,446833.5,5594521,124,10,20\n")).unwrap().remove(0);
        assert_eq!([mark.x_px, mark.y_px], [10.0, 20.0], "{head}");
    }
}

#[test]
fn arabic_tables_are_read_with_longitudes_and_arabic_commas() {
    assert_eq!(first("اسم النقطة؛شرقيات؛شماليات؛منسوب\nP1؛446833,25؛5594521,5؛124,5\n").1, [446_833.25, 5_594_521.5, 124.5]);
    assert_eq!(first("الاسم،الشرق،الشمال،الارتفاع\nP1،446833.25،5594521.5،124.5\n").1, [446_833.25, 5_594_521.5, 124.5]);
    for head in ["الصورة;خط الطول;خط العرض;الارتفاع", "صورة;خط طول;خط عرض;ارتفاع"] {
        let positions = parse_image_positions(&format!("{head}\na.jpg;8.25;50.5;171.5\n")).unwrap();
        assert_eq!(
            (positions.is_geographic, positions.rows[0].place, positions.rows[0].height),
            (true, [8.25, 50.5], Some(171.5)),
            "{head}"
        );
    }
}

#[test]
fn further_names_of_other_programs_are_known() {
    for head in [
        "PktNr;Rechtswert;Hochwert;Hoehe",
        "Pkt;Y (Ost);X (Nord);H",
        "Nom du point;Est (m);Nord (m);Altitude (m)",
        "Punto;Coordenada X;Coordenada Y;Cota",
        "Point;Easting;Northing;Ortho Height",
    ] {
        assert_eq!(first(&format!("{head}\n7;1,5;2,5;3,5\n")), ("7".into(), [1.5, 2.5, 3.5], None), "{head}");
    }
    assert_eq!(parse_image_positions("Nom;Latitude;Longitude;Altitude\na.jpg;50,5;8,25;171,5\n").unwrap().rows[0].image, "a.jpg");
    // Metashape.
    let mark = parse_image_measurements("#Label,Camera,X,Y\nP1,a.jpg,10.5,20\n").unwrap().remove(0);
    assert_eq!((&mark.image[..], &mark.point[..], mark.x_px), ("a.jpg", "P1", 10.5));
    let feet = "Point,Easting (sFT),Northing (ift),Elev (International feet)\n1,1,2,3\n";
    assert_eq!(stated_units(feet).unwrap().iter().map(|is| is.unit).collect::<Vec<_>>(), ["us-ft", "ft", "ft"]);
}

#[test]
fn units_that_are_not_known_thousands_and_tables_of_opendronemap_are_refused_for_what_they_are() {
    for (text, named) in [
        (
            "Point,Easting [inch],Northing [inch],H\n1,1.5,2,3\n",
            "the column 'Easting [inch]', in a unit that is not known; allowed: degrees or mm,",
        ),
        ("Point,Easting,Northing,H (rod)\n1,1.5,2,3\n", "the column 'H (rod)', in a unit"),
        (
            "Punkt;Rechtswert;Hochwert;Höhe\nP1;446.833,25;5.594.521,50;124,5\n",
            "'446.833,25' for x in line 2, which seems to have signs before its thousands",
        ),
        ("Punkt;Rechtswert;Hochwert;Höhe\nP1;446 833,25;5 594 521,50;124,5\n", "'446 833,25' for x in line 2, which seems"),
        ("Punkt;Y;X;H\nP1;2'600'000.12;1'200'000.34;540.1\n", "'1'200'000.34' for x in line 2, which seems"),
        (
            "name\tx\ty\tz\nP1\t446,833\t594,521\t124\n",
            "'P1 446,833 594,521 124' in line 2, where no number of the table says whether commas",
        ),
        (
            "EPSG:32632\n4490.1 5300.2 300.5 100 200 a.jpg P1\n",
            "the table of control points: got the first line 'EPSG:32632', as tables of OpenDroneMap begin",
        ),
        ("+proj=utm +zone=10 +ellps=WGS84\n544256.7 5320919.9 5 3044 2622 a.jpg P1\n", "as tables of OpenDroneMap begin"),
    ] {
        assert!(message(text).contains(named), "{text}: {}", message(text));
    }
    assert!(
        marks_message("EPSG:32632\n4490.1 5300.2 300.5 100 200 a.jpg P1\n").contains("the table of image measurements: got the first line")
    );
    // A local net to the millimetre, as tables with semicolons have it.
    let local = parse_ground_control_points("Punkt;Rechts;Hoch;H\nP1;446,833;594,521;124,020\n").unwrap();
    assert_eq!(local[0].position, [446.833, 594.521, 124.02]);
    let inches = parse_image_positions("image,Easting [inch],Northing [inch]\na,1.5,2\n").unwrap_err().to_string();
    assert!(inches.contains("the table of image positions: got the column 'Easting [inch]', in a unit"), "{inches}");
    let thousands = parse_image_positions("Bild;Rechtswert;Hochwert\na;446.833,25;5.594.521,50\n").unwrap_err().to_string();
    assert!(thousands.contains("'446.833,25' for Rechtswert in line 2, which seems"), "{thousands}");
    assert!(parse_image_positions("image\tx\ty\na\t446,833\t594,521\n").unwrap_err().to_string().contains("whether commas"));
    // One comma that can only be decimal says it of all.
    assert_eq!(first("name;x;y;z\nP1;446,833;594,521;0,240\n").1, [446.833, 594.521, 0.24]);
}
