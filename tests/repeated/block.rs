//! A bundle adjustment by `orientation.json` alone.

use super::super::coordinate_system::{GEOID_M, UTM, control, files, flown};
use super::equations::{Equations, Factor};
use super::inner::Inner;
use super::rotation::{angles, rotation, times};
use super::{farthest, items, largest_share, number, numbers};
use serde_json::Value;
use tiepoint::{BlockRun, BlockSettings, MultiscaleOptions, RunInput, run_block};

/// One image observation that took part, in px.
struct Seen {
    image: usize,
    /// Place among the points.
    point: usize,
    at: [f64; 2],
    weight: f64,
    /// Whether no standard error of its own is stated: then it shares errors with the others of its image, and tells σ₀.
    shares: bool,
}

/// A value that was observed or known itself.
struct Direct {
    unknown: usize,
    value: f64,
    weight: f64,
}

/// A known direction of view.
struct Axis {
    image: usize,
    direction: [f64; 3],
    weight: f64,
}

/// What the file holds of a model: six unknowns of each image, those of the cameras, three of each point.
struct Exported {
    cameras: Vec<[f64; 8]>,
    sizes: Vec<[f64; 2]>,
    camera_of: Vec<usize>,
    /// Camera and parameter of the unknowns behind those of the images.
    parameters: Vec<(usize, usize)>,
    seen: Vec<Seen>,
    direct: Vec<Direct>,
    axes: Vec<Axis>,
    /// Adjusted values, and the standard errors of those that are given.
    values: Vec<f64>,
    errors: Vec<Option<f64>>,
    sigma0: f64,
    unit_error: f64,
    variance_left: f64,
    shared_errors: f64,
    freedom: usize,
    last_step: f64,
    is_free: bool,
    /// Of coordinates of the object space, for differences.
    step: f64,
}

fn camera_values(camera: &Value) -> [f64; 8] {
    let [cx, cy] = numbers(&camera["principal_point_px"]);
    let [k1, k2, k3] = numbers(&camera["radial"]);
    let [p1, p2] = numbers(&camera["tangential"]);
    [number(&camera["focal_px"]), cx, cy, k1, k2, k3, p1, p2]
}

/// Which parameters of a camera were estimated.
fn free_parameters(camera: &Value, statistics: &Value) -> Vec<usize> {
    const NAMES: [&str; 8] = ["focal", "principal_x", "principal_y", "k1", "k2", "k3", "p1", "p2"];
    let free = &camera["free"];
    let (focal, point, tangential) = (free["focal"] == true, free["principal_point"] == true, free["tangential"] == true);
    let radial = free["radial"].as_u64().unwrap();
    let wanted = [focal, point, point, radial > 0, radial > 1, radial > 2, tangential, tangential];
    let is_fixed = |k: usize| items(&statistics["fixed"]).any(|fixed| fixed["parameter"] == NAMES[k]);
    (0..8).filter(|k| wanted[*k] && !is_fixed(*k)).collect()
}

impl Exported {
    fn read(text: &str) -> Self {
        let file: Value = serde_json::from_str(text).unwrap();
        let model = &file["models"][0];
        let (adjusted, block) = (&model["adjusted"], &model["adjusted"]["block"]);
        let weighted_by = number(&adjusted["weighted_by_px"]);
        let weight = |sigma: f64| (weighted_by / sigma).powi(2);
        let factor = |group: &str| {
            let found = items(&adjusted["components"]).find(|component| component["group"] == group && component["applied"] == true);
            found.map_or(1.0, |component| number(&component["factor"]))
        };
        let by_axis = |plan: &str, height: &str| [factor(plan), factor(plan), factor(height)];
        let (of_gnss, of_control) = (by_axis("gnss_plan", "gnss_height"), by_axis("control_plan", "control_height"));

        let cameras: Vec<[f64; 8]> = items(&block["cameras"]).map(camera_values).collect();
        let sizes = items(&block["cameras"]).map(|camera| [number(&camera["width_px"]), number(&camera["height_px"])]).collect();
        let (mut values, mut errors) = (Vec::new(), Vec::new());
        for (image, statistics) in items(&block["images"]).zip(items(&adjusted["images"])) {
            let rows: [[f64; 3]; 3] = [0, 1, 2].map(|row| numbers(&image["pose"]["rotation"][row]));
            values.extend(angles(&rows).into_iter().chain(numbers::<3>(&image["pose"]["position"])));
            let turns = numbers::<3>(&statistics["angle_errors_deg"]).map(f64::to_radians);
            errors.extend(turns.into_iter().chain(numbers::<3>(&statistics["position_errors"])).map(Some));
        }
        let mut direct = Vec::new();
        let mut parameters = Vec::new();
        for (index, (camera, statistics)) in items(&block["cameras"]).zip(items(&adjusted["cameras"])).enumerate() {
            let prior = items(&block["camera_priors"]).find(|prior| prior["camera"] == index);
            for parameter in free_parameters(camera, statistics) {
                if let Some((prior, sigma)) = prior.and_then(|prior| Some((prior, prior["sigma"][parameter].as_f64()?))) {
                    direct.push(Direct { unknown: values.len(), value: number(&prior["values"][parameter]), weight: weight(sigma) });
                }
                parameters.push((index, parameter));
                values.push(cameras[index][parameter]);
                errors.push(Some(number(&statistics["standard_errors"][parameter])));
            }
        }
        let first = values.len();
        let mut seen = Vec::new();
        // Points that took part, in the order of the file.
        let mut place = vec![None; items(&block["points"]).count()];
        let mut points = 0;
        for (ray, statistics) in items(&block["rays"]).zip(items(&adjusted["rays"])).filter(|(_, s)| s["verdict"] == "accepted") {
            let index = ray["point"].as_u64().unwrap() as usize;
            let point = *place[index].get_or_insert_with(|| {
                values.extend(numbers::<3>(&block["points"][index]));
                errors.extend(numbers::<3>(&adjusted["points"][index]["errors"]).map(Some));
                points += 1;
                points - 1
            });
            let (image, weight) = (ray["image"].as_u64().unwrap() as usize, number(&ray["weight"]));
            assert!(statistics["redundancy"].is_array());
            seen.push(Seen { image, point, at: [number(&ray["x_px"]), number(&ray["y_px"])], weight, shares: ray["sigma_px"].is_null() });
        }
        for point in items(&model["supporting"]) {
            let before = seen.len();
            for ray in items(&point["rays"]).filter(|ray| ray["rejected"] != true) {
                // Numbers of 32 bits.
                let at = ["x_px", "y_px"].map(|name| f64::from(ray[name].to_string().parse::<f32>().unwrap()));
                seen.push(Seen { image: ray["image"].as_u64().unwrap() as usize, point: points, at, weight: 1.0, shares: true });
            }
            // All observations of some were rejected.
            if seen.len() > before {
                values.extend(numbers::<3>(&point["position"]));
                errors.extend([None; 3]);
                points += 1;
            }
        }
        let datum = adjusted["datum"].as_str().unwrap();
        let mut axes = Vec::new();
        for (index, (image, statistics)) in items(&block["images"]).zip(items(&adjusted["images"])).enumerate() {
            if datum.contains("gnss") && statistics["gnss"]["accepted"] == true {
                for k in 0..3 {
                    let Some(sigma) = image["gnss"]["sigma"][k].as_f64() else { continue };
                    let value = number(&image["gnss"]["position"][k]);
                    direct.push(Direct { unknown: 6 * index + 3 + k, value, weight: weight(of_gnss[k] * sigma) });
                }
            }
            if let Some(sigma_deg) = image["axis"]["sigma_deg"].as_f64().filter(|_| datum != "free") {
                axes.push(Axis { image: index, direction: numbers(&image["axis"]["direction"]), weight: weight(sigma_deg.to_radians()) });
            }
        }
        for known in items(&block["control"]).filter(|_| datum.contains("control")) {
            let Some(point) = place[known["point"].as_u64().unwrap() as usize] else { continue };
            let (position, sigma) = (numbers::<3>(&known["position"]), numbers::<3>(&known["sigma"]));
            let of = |k: usize| Direct { unknown: first + 3 * point + k, value: position[k], weight: weight(of_control[k] * sigma[k]) };
            direct.extend([0, 1, 2].map(of));
        }
        let mut exported = Self {
            cameras,
            sizes,
            camera_of: items(&block["images"]).map(|image| image["camera"].as_u64().unwrap() as usize).collect(),
            parameters,
            seen,
            direct,
            axes,
            values,
            errors,
            sigma0: number(&adjusted["sigma0_px"]),
            unit_error: number(&adjusted["unit_error_px"]),
            variance_left: number(&adjusted["variance_left"]),
            shared_errors: number(&adjusted["shared_errors"]),
            freedom: adjusted["degrees_of_freedom"].as_u64().unwrap() as usize,
            last_step: number(&adjusted["last_step"]),
            is_free: datum == "free",
            step: 0.0,
        };
        exported.step = 1e-6 * exported.distance(&exported.values);
        exported
    }

    fn first_point(&self) -> usize {
        6 * self.camera_of.len() + self.parameters.len()
    }

    /// The mean distance of the points from the images that observe them.
    fn distance(&self, values: &[f64]) -> f64 {
        let of = |seen: &Seen| {
            let (image, point) = (6 * seen.image + 3, self.first_point() + 3 * seen.point);
            (0..3).map(|k| (values[point + k] - values[image + k]).powi(2)).sum::<f64>().sqrt()
        };
        self.seen.iter().map(of).sum::<f64>() / self.seen.len() as f64
    }

    /// The datum of a free network.
    fn inner(&self, values: &[f64]) -> Option<Inner> {
        self.is_free.then(|| Inner::new(values, self.camera_of.len(), self.first_point(), self.distance(values)))
    }

    /// The unknowns that an image observation depends on, with steps for differences.
    fn unknowns_of(&self, seen: &Seen) -> Vec<(usize, f64)> {
        const STEPS: [f64; 8] = [1e-2, 1e-2, 1e-2, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5];
        let camera = self.camera_of[seen.image];
        let of_image = (0..6).map(|k| (6 * seen.image + k, if k < 3 { 1e-5 } else { self.step }));
        let of_camera = self.parameters.iter().enumerate().filter(|(_, (own, _))| *own == camera);
        let of_camera = of_camera.map(|(k, (_, parameter))| (6 * self.camera_of.len() + k, STEPS[*parameter]));
        let of_point = (0..3).map(|k| (self.first_point() + 3 * seen.point + k, self.step));
        of_image.chain(of_camera).chain(of_point).collect()
    }

    /// Where a point is seen, in px.
    fn project(&self, values: &[f64], seen: &Seen) -> [f64; 2] {
        let camera = self.camera_of[seen.image];
        let mut constants = self.cameras[camera];
        for (k, (_, parameter)) in self.parameters.iter().enumerate().filter(|(_, (own, _))| *own == camera) {
            constants[*parameter] = values[6 * self.camera_of.len() + k];
        }
        let [f, cx, cy, k1, k2, k3, p1, p2] = constants;
        let image = &values[6 * seen.image..][..6];
        let point = &values[self.first_point() + 3 * seen.point..][..3];
        let m = rotation([image[0], image[1], image[2]]);
        let [u, v, w] = times(&m, [0, 1, 2].map(|k| point[k] - image[3 + k]));
        let (x, y) = (-u / w, v / w);
        let r2 = x * x + y * y;
        let radial = 1.0 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
        [
            cx + f * (x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x)),
            cy + f * (y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y),
        ]
    }

    /// Derivatives of column and row by differences.
    fn derivatives(&self, values: &[f64], seen: &Seen) -> [Vec<(usize, f64)>; 2] {
        let mut moved = values.to_vec();
        let mut rows = [Vec::new(), Vec::new()];
        for (unknown, step) in self.unknowns_of(seen) {
            let mut at = |step: f64| {
                moved[unknown] = values[unknown] + step;
                let at = self.project(&moved, seen);
                moved[unknown] = values[unknown];
                at
            };
            let (ahead, behind) = (at(step), at(-step));
            (0..2).for_each(|row| rows[row].push((unknown, (ahead[row] - behind[row]) / (2.0 * step))));
        }
        rows
    }

    /// The equations at some values, and v'Pv.
    fn equations(&self, values: &[f64]) -> (Equations, f64) {
        let mut equations = Equations::new(values.len());
        let mut square = 0.0;
        let mut add = |derivatives: &[(usize, f64)], difference: f64, weight: f64| {
            square += weight * difference * difference;
            equations.add(derivatives, difference, weight);
        };
        for seen in &self.seen {
            let (at, rows) = (self.project(values, seen), self.derivatives(values, seen));
            (0..2).for_each(|row| add(&rows[row], seen.at[row] - at[row], seen.weight));
        }
        for known in &self.direct {
            add(&[(known.unknown, 1.0)], known.value - values[known.unknown], known.weight);
        }
        for row in self.inner(values).iter().flat_map(Inner::rows) {
            add(&row, 0.0, 1.0);
        }
        for axis in &self.axes {
            let turns = 6 * axis.image;
            let row = |by: usize, step: f64| {
                let mut turned: [f64; 3] = std::array::from_fn(|k| values[turns + k]);
                turned[by] += step;
                rotation(turned)[2]
            };
            for k in 0..3 {
                let derivatives = [0, 1, 2].map(|by| (turns + by, (row(by, 1e-5)[k] - row(by, -1e-5)[k]) / 2e-5));
                add(&derivatives, axis.direction[k] - row(0, 0.0)[k], axis.weight);
            }
        }
        (equations, square)
    }

    /// Observed coordinates beyond the unknowns.
    fn redundancy(&self) -> usize {
        let freedoms = if self.is_free { 7 } else { 0 };
        2 * self.seen.len() + self.direct.len() + 2 * self.axes.len() + freedoms - self.values.len()
    }

    /// Adjusts from values that are off; gives the values, v'Pv and the factor of the equations.
    fn adjusted(&self) -> (Vec<f64>, f64, Factor) {
        let off =
            |(k, error): (usize, &Option<f64>)| error.map_or(50.0 * self.step, |error| 0.1 * error) * if k % 2 == 0 { 1.0 } else { -1.0 };
        let mut change: Vec<f64> = self.errors.iter().enumerate().map(off).collect();
        if let Some(inner) = self.inner(&self.values) {
            inner.take_motion(&mut change);
        }
        let mut values: Vec<f64> = self.values.iter().zip(&change).map(|(value, change)| value + change).collect();
        for _ in 0..60 {
            let (equations, square) = self.equations(&values);
            let right = equations.right.clone();
            let factor = equations.factor();
            let step = factor.solve(&right);
            // The square of the step in its standard errors is what it takes from v'Pv.
            let size: f64 = step.iter().zip(&right).map(|(step, right)| step * right).sum();
            values.iter_mut().zip(&step).for_each(|(value, step)| *value += step);
            if size < 1e-14 * square {
                return (values, square, factor);
            }
        }
        panic!("the repeated adjustment does not converge");
    }

    /// v'Pv by its redundancy: of the observations of which none is stated, where there are others and these have a redundancy of 20, else of all.
    fn variance(&self, values: &[f64], square: f64, factor: &Factor) -> f64 {
        let of_all = square / self.freedom as f64;
        if self.seen.iter().all(|seen| seen.shares) {
            return of_all;
        }
        let (mut own, mut redundancy) = (0.0, 0.0);
        for seen in self.seen.iter().filter(|seen| seen.shares) {
            let (at, rows) = (self.project(values, seen), self.derivatives(values, seen));
            for (row, derivatives) in rows.iter().enumerate() {
                let mut by = vec![0.0; values.len()];
                derivatives.iter().for_each(|(unknown, derivative)| by[*unknown] = *derivative);
                let cofactor: f64 = factor.solve(&by).iter().zip(&by).map(|(solved, derivative)| solved * derivative).sum();
                own += seen.weight * (seen.at[row] - at[row]).powi(2);
                redundancy += 1.0 - seen.weight * cofactor;
            }
        }
        if redundancy < 20.0 { of_all } else { own / redundancy }
    }

    /// Variances that shared errors of the standard deviation 1 add, for observations of the standard error 1.
    fn shared(&self, values: &[f64], factor: &Factor) -> Vec<f64> {
        let mut added = vec![0.0; values.len()];
        for image in 0..self.camera_of.len() {
            let [width, height] = self.sizes[self.camera_of[image]];
            let half = 0.5 * width.max(height);
            for mode in 0..12 {
                let mut right = vec![0.0; values.len()];
                for seen in self.seen.iter().filter(|seen| seen.image == image && seen.shares) {
                    let (x, y) = ((seen.at[0] - 0.5 * width) / half, (seen.at[1] - 0.5 * height) / half);
                    let error = [1.0, x, y, x * y, x * x, y * y][mode % 6];
                    let rows = self.derivatives(values, seen);
                    rows[mode / 6].iter().for_each(|(unknown, by)| right[*unknown] += seen.weight * by * error);
                }
                factor.solve(&right).iter().zip(&mut added).for_each(|(moved, sum)| *sum += moved * moved);
            }
        }
        added
    }
}

/// Repeats an adjustment, and compares it with what was exported.
fn repeat(what: &str, run: &BlockRun) -> Exported {
    let exported = Exported::read(&files(run)["orientation.json"]);
    let (values, square, factor) = exported.adjusted();
    assert_eq!(exported.redundancy(), exported.freedom, "{what}");
    let sigma0 = (exported.variance(&values, square, &factor) / exported.variance_left).sqrt();
    let unit_error = sigma0 / exported.variance_left.sqrt();
    let shared = exported.shared(&values, &factor);
    let variance = |(cofactor, shared): (f64, f64)| cofactor + exported.shared_errors.powi(2) * shared;
    let mut cofactors = factor.cofactors();
    let mut change: Vec<f64> = values.iter().zip(&exported.values).map(|(own, exported)| own - exported).collect();
    if let Some(inner) = exported.inner(&values) {
        inner.constrain(&mut cofactors);
        inner.take_motion(&mut change);
    }
    let errors: Vec<f64> = cofactors.into_iter().zip(shared).map(|both| unit_error * variance(both).sqrt()).collect();
    let given: Vec<usize> = (0..values.len()).filter(|k| exported.errors[*k].is_some()).collect();
    let exported_errors: Vec<f64> = given.iter().map(|k| exported.errors[*k].unwrap()).collect();
    let own_errors: Vec<f64> = given.iter().map(|k| errors[*k]).collect();
    let (moved, widened) = (farthest(&change, &vec![0.0; change.len()], &errors), largest_share(&own_errors, &exported_errors));
    let (sigma0_off, unit_off) = ((sigma0 / exported.sigma0 - 1.0).abs(), (unit_error / exported.unit_error - 1.0).abs());
    println!(
        "{what}: {} unknowns, {} degrees of freedom, variance left {}, last step {:.1e}; values {moved:.1e} standard errors off, σ₀ {sigma0_off:.1e}, \
         standard errors {widened:.1e} of themselves",
        values.len(),
        exported.freedom,
        exported.variance_left,
        exported.last_step
    );
    // Steps of the adjustment end where they are that small.
    assert!(moved < 1e-5, "{what}: {moved} standard errors");
    assert!(sigma0_off < 1e-6 && unit_off < 1e-6, "{what}: σ₀ {sigma0_off} {unit_off}");
    // They are those of the last round of checks, before the last steps.
    assert!(widened < 1e-4, "{what}: standard errors {widened}");
    exported
}

/// A block of these photos whose focal length is known as that of EXIF.
fn block(photos: &[usize], input: RunInput, mut settings: BlockSettings) -> BlockRun {
    let flown = flown();
    let focal_px = flown.scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}}}]}}"#));
    settings.features.multiscale = MultiscaleOptions { number: 2000, ..settings.features.multiscale };
    let photos: Vec<_> = photos.iter().map(|index| flown.photos[*index].clone()).collect();
    let folder = flown.folder.join(format!("repeated-{}", photos.len()));
    run_block(&photos, &[], RunInput { settings, cameras, ..input }, &folder, 2, drop).unwrap()
}

#[test]
fn a_block_of_gnss_positions_and_control_points_is_repeated_from_its_file() {
    let mut settings = BlockSettings::default();
    (settings.placing.crs, settings.placing.geoid_m) = (Some(UTM.into()), Some(GEOID_M));
    let input = RunInput { control: Some(control(|place| place)), ..RunInput::default() };
    let exported = repeat("GNSS and control", &block(&[1, 2, 3, 5, 6], input, settings));
    assert_eq!(exported.camera_of.len(), 5);
    assert!(exported.parameters.len() >= 4 && exported.direct.len() >= exported.parameters.len() + 3 * 5 + 3 * 3);
}

#[test]
fn a_block_that_is_levelled_is_repeated_from_its_file() {
    // Positions along one line leave its roll to the level.
    let exported = repeat("levelled", &block(&[0, 1, 2, 3], RunInput::default(), BlockSettings::default()));
    assert!(!exported.axes.is_empty());
}

#[test]
fn a_free_network_is_repeated_from_its_file() {
    let input = RunInput { use_gnss: false, ..RunInput::default() };
    let exported = repeat("free network", &block(&[1, 2, 5], input, BlockSettings::default()));
    assert!(exported.is_free && !exported.direct.is_empty());
}
