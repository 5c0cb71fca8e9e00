//! A relative orientation by the project file of the pair alone.

use super::super::pair_project::refined;
use super::equations::Equations;
use super::rotation::{rotation, times};
use super::{farthest, items, largest_share, number, numbers};
use serde_json::Value;
use tiepoint::{CameraUncertainty, PairRun, orient_matches, write_pair_project};

/// Photo coordinates x, y left, x, y right in mm with their weight.
struct Observed {
    at: [f64; 4],
    weight: f64,
}

/// Photo coordinates in mm of a position in px.
fn photo_mm(interior: &Value, camera: Option<&Value>, turn_deg: f64, at_px: [f64; 2]) -> [f64; 2] {
    let rows: [[f64; 3]; 2] = [0, 1].map(|row| numbers(&interior["parameters"][row]));
    let [x, y] = rows.map(|[a, b, t]| a * at_px[0] + b * at_px[1] + t);
    let [mut x0, mut y0] = numbers::<2>(&interior["principal_point_mm"]);
    let [mut k1, k2, k3] = numbers::<3>(&interior["radial_distortion"]);
    let [p1, p2] = numbers::<2>(&interior["tangential_distortion"]);
    if let Some(camera) = camera {
        let [own_x, own_y] = numbers::<2>(&camera["principal_point_mm"]);
        // Said in the axes of ω φ κ by bz.
        [x0, y0] = if turn_deg == 0.0 { [own_x, own_y] } else { [-own_y, own_x] };
        k1 = number(&camera["k1_per_mm2"]);
    }
    let (x, y) = (x - x0, y - y0);
    let r2 = x * x + y * y;
    let radial = 1.0 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
    let [x, y] = [x * radial + p1 * (r2 + 2.0 * x * x) + 2.0 * p2 * x * y, y * radial + p2 * (r2 + 2.0 * y * y) + 2.0 * p1 * x * y];
    if turn_deg == 0.0 { [x, y] } else { [y, -x] }
}

/// The observations that took part, each once.
fn observed(result: &Value, oriented: &Value) -> Vec<Observed> {
    let turn_deg = number(&oriented["turn_deg"]);
    let rejected: Vec<u64> = items(&oriented["rejected"]).map(|index| index.as_u64().unwrap()).collect();
    let cameras = oriented.get("cameras").filter(|cameras| cameras.is_array());
    // The right photo is taken to the focal length of the left one.
    let scale = cameras.map_or(1.0, |cameras| number(&cameras[0]["focal_mm"]) / number(&cameras[1]["focal_mm"]));
    let mut all: Vec<Observed> = Vec::new();
    for (index, (found, statistics)) in (0..).zip(items(&result["matching"]["matches"]).zip(items(&oriented["points"]))) {
        if rejected.contains(&index) || statistics.is_null() {
            continue;
        }
        let of = |side: &str, k: usize| {
            let camera = cameras.map(|cameras| &cameras[k]);
            photo_mm(&result["interior"][side], camera, turn_deg, numbers(&found[format!("{side}_px")]))
        };
        let ([xl, yl], right) = (of("left", 0), of("right", 1));
        let at = [xl, yl, scale * right[0], scale * right[1]];
        if all.iter().all(|other| other.at != at) {
            all.push(Observed { at, weight: number(&statistics["weight"]) });
        }
    }
    all
}

/// The triple product of base and rays, of ω φ κ (radians) by bz and b, at photo coordinates.
fn coplanarity(unknowns: &[f64; 5], b: f64, f: f64, [xl, yl, xr, yr]: [f64; 4]) -> f64 {
    let [omega, phi, kappa, by, bz] = *unknowns;
    let m = rotation([omega, phi, kappa]);
    let transposed = [0, 1, 2].map(|row| [0, 1, 2].map(|column| m[column][row]));
    let [u, v, w] = times(&transposed, [xr, yr, -f]);
    b * (yl * w + f * v) - by * (xl * w + f * u) + bz * (xl * v - yl * u)
}

struct Repeated {
    values: [f64; 5],
    errors: [f64; 5],
    sigma0_mm: f64,
    freedom: usize,
}

/// Least squares of the corrections of all four coordinates (Gauss-Helmert), linearised at the adjusted coordinates; derivatives by differences.
fn repeated(all: &[Observed], start: [f64; 5], b: f64, f: f64, variance_left: f64) -> Repeated {
    const STEPS: [f64; 5] = [1e-5, 1e-5, 1e-5, 1e-3, 1e-3];
    let mut values = start;
    let mut adjusted: Vec<[f64; 4]> = all.iter().map(|one| one.at).collect();
    for _ in 0..50 {
        let mut equations = Equations::new(5);
        let mut lines = Vec::new();
        for (one, at) in all.iter().zip(&adjusted) {
            let by_unknowns: [f64; 5] = std::array::from_fn(|k| {
                let moved = |step: f64| {
                    let mut moved = values;
                    moved[k] += step;
                    coplanarity(&moved, b, f, *at)
                };
                (moved(STEPS[k]) - moved(-STEPS[k])) / (2.0 * STEPS[k])
            });
            let by_coordinates: [f64; 4] = std::array::from_fn(|k| {
                let moved = |step: f64| {
                    let mut moved = *at;
                    moved[k] += step;
                    coplanarity(&values, b, f, moved)
                };
                (moved(1e-3) - moved(-1e-3)) / 2e-3
            });
            let back: f64 = (0..4).map(|k| by_coordinates[k] * (one.at[k] - at[k])).sum();
            let misclosure = coplanarity(&values, b, f, *at) + back;
            let gradient = by_coordinates.iter().map(|v| v * v).sum::<f64>();
            let derivatives: [(usize, f64); 5] = std::array::from_fn(|k| (k, by_unknowns[k]));
            equations.add(&derivatives, -misclosure, one.weight / gradient);
            lines.push((by_unknowns, by_coordinates, misclosure, gradient));
        }
        let right = equations.right.clone();
        let factor = equations.factor();
        let step = factor.solve(&right);
        let mut square = 0.0;
        for (((by_unknowns, by_coordinates, misclosure, gradient), one), at) in lines.iter().zip(all).zip(&mut adjusted) {
            let left = misclosure + (0..5).map(|k| by_unknowns[k] * step[k]).sum::<f64>();
            *at = std::array::from_fn(|k| one.at[k] - by_coordinates[k] * left / gradient);
            square += one.weight * left * left / gradient;
        }
        (0..5).for_each(|k| values[k] += step[k]);
        let size: f64 = step.iter().zip(&right).map(|(step, right)| step * right).sum();
        if size < 1e-18 * square {
            let freedom = all.len() - 5;
            let sigma0_mm = (square / freedom as f64 / variance_left).sqrt();
            let cofactors = factor.cofactors();
            let errors = std::array::from_fn(|k| sigma0_mm * (cofactors[k] / variance_left).sqrt());
            return Repeated { values, errors, sigma0_mm, freedom };
        }
    }
    panic!("the repeated orientation does not converge");
}

fn five(value: &Value) -> [f64; 5] {
    let angles = ["omega_deg", "phi_deg", "kappa_deg"].map(|name| number(&value[name]).to_radians());
    [angles[0], angles[1], angles[2], number(&value["by_mm"]), number(&value["bz_mm"])]
}

/// Repeats the orientation of a project, and compares it with what the file holds.
fn repeat(what: &str, run: &PairRun) {
    let text = write_pair_project(run).unwrap();
    let file: Value = serde_json::from_str(text.split_once('\n').unwrap().1).unwrap();
    let result = &file["pair"]["result"];
    let oriented = &result["orientation"]["Ok"];
    let (exported, exported_errors) = (five(oriented), five(&oriented["standard_errors"]));
    let start = std::array::from_fn(|k| exported[k] + 20.0 * exported_errors[k] * if k % 2 == 0 { 1.0 } else { -1.0 });
    let variance_left = number(&oriented["variance_left"]);
    let all = observed(result, oriented);
    let found = repeated(&all, start, number(&oriented["base_mm"]), number(&oriented["focal_mm"]), variance_left);
    assert_eq!(Some(found.freedom as u64), oriented["degrees_of_freedom"].as_u64(), "{what}");
    let moved = farthest(&found.values, &exported, &exported_errors);
    let (widened, sigma0_off) =
        (largest_share(&found.errors, &exported_errors), (found.sigma0_mm / number(&oriented["sigma0_mm"]) - 1.0).abs());
    println!(
        "{what}: {} of {} observations, variance left {variance_left}; values {moved:.1e} standard errors off, σ₀ {sigma0_off:.1e}, standard \
         errors {widened:.1e} of themselves",
        all.len(),
        items(&oriented["points"]).count()
    );
    assert!(moved < 1e-6 && sigma0_off < 1e-6 && widened < 1e-6, "{what}: {moved} {sigma0_off} {widened}");
}

#[test]
fn a_pair_with_fiducial_marks_is_repeated_from_its_file() {
    let run = refined();
    assert!(!run.result.orientation.as_ref().unwrap().rejected.is_empty());
    repeat("fiducial marks", run);
}

#[test]
fn a_pair_whose_cameras_are_estimated_is_repeated_from_its_file() {
    let mut run = refined().clone();
    let interior = run.result.interior.as_mut().unwrap();
    interior.left.uncertainty = Some(CameraUncertainty::ASSUMED);
    interior.right.uncertainty = Some(CameraUncertainty { focal: 0.05, ..CameraUncertainty::ASSUMED });
    let oriented = orient_matches(&run.result.matching.matches, interior, &run.settings.orientation).unwrap();
    assert!(oriented.cameras.is_some_and(|cameras| (cameras[0].focal_mm - interior.focal_mm).abs() > 1e-6));
    run.result.orientation = Ok(oriented);
    repeat("estimated cameras", &run);
}
