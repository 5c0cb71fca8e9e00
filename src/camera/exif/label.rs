//! What a camera of photographs is called: photographs of one camera at one focal length have one name.

/// Make, model, focal length in mm and size in px, as far as they are known.
pub(crate) fn camera_label(make: Option<&str>, model: Option<&str>, focal_mm: Option<f64>, [width_px, height_px]: [u32; 2]) -> String {
    // Models of some makers begin with the make.
    let make = make.filter(|make| !model.is_some_and(|model| model.starts_with(make)));
    let name: Vec<&str> = make.into_iter().chain(model).collect();
    let parts = [
        (!name.is_empty()).then(|| name.join(" ")),
        focal_mm.map(|focal| format!("{} mm", (focal * 1e3).round() / 1e3)),
        Some(format!("{width_px} x {height_px} px")),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}
