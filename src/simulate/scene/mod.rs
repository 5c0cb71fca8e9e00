//! The made scene: what stands where, what a ray meets first, and how bright it is there.

mod axes;
mod blocks;
mod building;
mod facade;
mod ground;
mod moment;
mod planting;
mod river;
mod solid;
mod span;
mod streets;
mod sun;
mod terrain;
mod tree;

use super::buckets::Rectangle;
use super::flight::Flight;
use super::photo::Ray;
use super::random::{Random, Stream};
use blocks::Blocks;
pub(super) use moment::Moment;
use nalgebra::Vector3;
use planting::Site;
use river::River;
use solid::Solid;
pub(super) use span::Box3;
use streets::Streets;
use sun::Sun;
pub(super) use terrain::Ground;
use terrain::Terrain;

/// Ground, streets and solids over an area.
pub(super) struct Scene {
    terrain: Terrain,
    streets: Streets,
    blocks: Blocks,
    river: Option<River>,
    /// Way in m that cars in the lanes have driven by the second exposure.
    driven_m: f64,
    solids: Vec<Solid>,
    sun: Sun,
    floor_m: f64,
}

/// Where a ray meets the scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hit {
    pub(super) point: Vector3<f64>,
    surface: Surface,
}

#[derive(Debug, Clone, Copy)]
enum Surface {
    /// The ground, by its normal.
    Ground(Vector3<f64>),
    /// A solid, by its index, and its face.
    Solid(u32, usize),
}

impl Scene {
    /// Builds the flight's scene over `area`, a rectangle of ground in m.
    pub(super) fn new(flight: &Flight, area: Rectangle) -> Self {
        let stream = |purpose| Random::new(flight.seed, purpose);
        let terrain = Terrain::new(area, flight.relief_m, &mut stream(Stream::Relief));
        let streets = Streets::new(area, &mut stream(Stream::Streets));
        let blocks = Blocks::new(&streets, &mut stream(Stream::Blocks));
        let river = (flight.river_m > 0.0).then(|| River::new(area, flight.river_m, &mut stream(Stream::River)));
        let solids = planting::solids(&Site { area, terrain: &terrain, streets: &streets, blocks: &blocks, river: river.as_ref() }, flight);
        let floor_m = -0.5 * flight.relief_m;
        let sun = Sun::new(area, floor_m, &solids);
        Self { terrain, streets, blocks, river, driven_m: flight.driven_m, solids, sun, floor_m }
    }

    /// The boxes around the solids, in the order of their indices.
    pub(super) fn bounds(&self) -> impl Iterator<Item = Box3> {
        self.solids.iter().map(|solid| solid.bounds(self.floor_m))
    }

    /// Where a falling ray meets the ground, solids left out.
    pub(super) fn ground(&self, ray: &Ray) -> Ground {
        self.terrain.meet(ray)
    }

    /// What a falling ray meets first: the given tangent plane of the ground or one of the solids with the given indices.
    pub(super) fn first_hit(&self, ray: &Ray, ground: &Ground, candidates: &[u32]) -> Hit {
        let mut t = ground.meet(ray);
        let mut surface = Surface::Ground(ground.normal);
        for &index in candidates {
            if let Some(span) = self.solids[index as usize].span(ray).filter(|span| span.enter < t) {
                (t, surface) = (span.enter, Surface::Solid(index, span.face));
            }
        }
        Hit { point: ray.at(t), surface }
    }

    /// Whether the ground at a hit lies under a moving car in either exposure.
    pub(super) fn is_unsteady(&self, hit: &Hit) -> bool {
        let on_ground = matches!(hit.surface, Surface::Ground(_)) && self.driven_m > 0.0;
        on_ground && !self.is_water(hit) && ground::is_under_moving_car(&self.streets, hit.point.x, hit.point.y, [0.0, self.driven_m])
    }

    fn is_water(&self, hit: &Hit) -> bool {
        self.river.as_ref().is_some_and(|river| river.holds(hit.point.x, hit.point.y))
    }

    /// The light that comes from a point, as a grey value of an ideal camera.
    pub(super) fn grey(&self, hit: &Hit, moment: Moment) -> f64 {
        let point = hit.point;
        let (tone, normal, own) = match hit.surface {
            Surface::Ground(normal) if self.is_water(hit) => (river::tone(point.x, point.y, moment), normal, None),
            Surface::Ground(normal) => {
                let driven_m = if moment == Moment::Second { self.driven_m } else { 0.0 };
                (ground::tone(&self.streets, &self.blocks, point.x, point.y, driven_m), normal, None)
            }
            Surface::Solid(index, face) => {
                let (tone, normal) = self.solids[index as usize].look(face, point);
                (tone, normal, Some(index))
            }
        };
        tone * self.sun.light(&self.solids, point, normal, own)
    }
}

#[cfg(test)]
impl Scene {
    pub(super) fn height_above_ground(&self, point: Vector3<f64>) -> f64 {
        point.z - self.terrain.at(point.x, point.y).point.z
    }

    /// Whether a point lies in the earth or in a solid.
    pub(super) fn is_inside(&self, point: Vector3<f64>) -> bool {
        self.height_above_ground(point) < 0.0 || self.solids.iter().any(|solid| solid.contains(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let flight = Flight { lowest_building_m: 4.0, highest_building_m: 40.0, relief_m: 20.0, ..Flight::default() };
        Scene::new(&flight, [-150.0, -120.0, 150.0, 120.0])
    }

    #[test]
    fn buildings_stand_on_the_ground_and_do_not_touch() {
        let scene = scene();
        let buildings: Vec<_> =
            scene.solids.iter().filter_map(|solid| if let Solid::Building(b) = solid { Some(b) } else { None }).collect();
        assert!(buildings.len() > 50, "{} buildings", buildings.len());
        for (index, building) in buildings.iter().enumerate() {
            let [x, y] = building.axes.origin;
            assert!(scene.height_above_ground(Vector3::new(x, y, building.base_m)).abs() < 1e-12);
            let [hu, hv] = building.half_m;
            for (su, sv) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                let [cx, cy] = building.axes.to_ground(su * hu, sv * hv);
                let corner = Vector3::new(cx, cy, building.base_m + 1.0);
                let touched = buildings.iter().enumerate().position(|(other, b)| other != index && b.contains(corner));
                assert_eq!(touched, None, "building {index} reaches into another");
            }
        }
    }

    #[test]
    fn a_shadow_is_where_the_way_to_the_sun_is_blocked() {
        let scene = scene();
        let (mut dark, mut bright) = (0, 0);
        for k in 0..4000 {
            let (x, y) = (f64::from(k % 80) * 3.1 - 124.0, f64::from(k / 80) * 4.1 - 102.0);
            let point = scene.terrain.at(x, y).point + Vector3::new(0.0, 0.0, 0.02);
            if scene.solids.iter().any(|solid| solid.contains(point)) {
                continue;
            }
            let shaded = scene.sun.light(&scene.solids, point, Vector3::z(), None) < 0.9;
            // In steps of 5 cm: a solid that the ray only grazes may be missed by the steps, never by the light.
            let blocked = (1..1400).map(|step| point + scene.sun.direction * (0.05 * f64::from(step)));
            let blocked = blocked.into_iter().any(|place| scene.solids.iter().any(|solid| solid.contains(place)));
            assert!(shaded || !blocked, "light at {x} {y} where a solid is in the way");
            dark += usize::from(shaded);
            bright += usize::from(shaded != blocked);
        }
        assert!(dark > 400, "{dark} places in the shade");
        assert!(bright <= 8, "{bright} places in the shade of nothing");
    }
}
