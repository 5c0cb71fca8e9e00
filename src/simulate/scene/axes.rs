//! A turned horizontal system: of the street grid, of a building.

/// A local system `(u, v)` of the ground plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axes {
    pub(super) origin: [f64; 2],
    pub(super) cos: f64,
    pub(super) sin: f64,
}

impl Axes {
    /// u is x turned by `angle_rad` towards y.
    pub(super) fn new(origin: [f64; 2], angle_rad: f64) -> Self {
        let (sin, cos) = libm::sincos(angle_rad);
        Self { origin, cos, sin }
    }

    /// The same directions at another origin.
    pub(super) fn moved(&self, origin: [f64; 2]) -> Self {
        Self { origin, ..*self }
    }

    pub(super) fn to_local(self, x: f64, y: f64) -> [f64; 2] {
        self.turn(x - self.origin[0], y - self.origin[1])
    }

    /// A direction's local components.
    pub(super) fn turn(self, x: f64, y: f64) -> [f64; 2] {
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }

    pub(super) fn to_ground(self, u: f64, v: f64) -> [f64; 2] {
        let [x, y] = self.turn_back(u, v);
        [self.origin[0] + x, self.origin[1] + y]
    }

    /// A local direction's ground components.
    pub(super) fn turn_back(self, u: f64, v: f64) -> [f64; 2] {
        [self.cos * u - self.sin * v, self.sin * u + self.cos * v]
    }
}
