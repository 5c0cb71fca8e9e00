//! The matches between the photos of a block: right ones, chance ones, and those that repeated structures bring.

use super::features::Seen;
use super::flight::BlockFlight;
use crate::FeatureMatch;
use crate::simulate::random::{Random, Stream};
use std::collections::BTreeMap;

/// Pairs with fewer common features are not matched.
const LEAST_COMMON: usize = 8;

/// A right match has on average this much more strength than a wrong one, in standard deviations of either.
const STRONGER: f64 = 1.0;

pub(super) fn matches(flight: &BlockFlight, seen: &Seen) -> Vec<([u32; 2], Vec<FeatureMatch>)> {
    let sightings = sightings(seen);
    let mut random = Random::new(flight.seed, Stream::BlockMatches);
    let mut pairs = Vec::new();
    let mut common: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
    for (image, owners) in seen.owners.iter().enumerate() {
        common.clear();
        for (feature, owner) in owners.iter().enumerate() {
            let others = owner.iter().flat_map(|owner| sightings.of(*owner)).filter(|(other, _)| *other as usize > image);
            others.for_each(|(other, partner)| common.entry(*other).or_default().push([feature as u32, *partner]));
        }
        for (other, list) in common.iter().filter(|(_, list)| list.len() >= LEAST_COMMON) {
            let images = [image as u32, *other];
            pairs.push((images, match_pair(flight, seen, &sightings, images, list, &mut random)));
        }
    }
    pairs
}

/// The features that show each ground point, as image and feature.
struct Sightings {
    starts: Vec<u32>,
    list: Vec<(u32, u32)>,
}

impl Sightings {
    fn of(&self, owner: u32) -> &[(u32, u32)] {
        &self.list[self.starts[owner as usize] as usize..self.starts[owner as usize + 1] as usize]
    }

    fn in_image(&self, owner: u32, image: u32) -> Option<u32> {
        let list = self.of(owner);
        list.binary_search_by_key(&image, |(image, _)| *image).ok().map(|index| list[index].1)
    }
}

fn sightings(seen: &Seen) -> Sightings {
    let mut starts = vec![0_u32; seen.ground.len() + 1];
    let owners = || seen.owners.iter().enumerate();
    owners().flat_map(|(_, list)| list.iter().flatten()).for_each(|owner| starts[*owner as usize + 1] += 1);
    for index in 1..starts.len() {
        starts[index] += starts[index - 1];
    }
    let mut places = starts.clone();
    let mut list = vec![(0, 0); starts[seen.ground.len()] as usize];
    for (image, owners) in owners() {
        for (feature, owner) in owners.iter().enumerate() {
            let Some(owner) = owner else { continue };
            list[places[*owner as usize] as usize] = (image as u32, feature as u32);
            places[*owner as usize] += 1;
        }
    }
    Sightings { starts, list }
}

/// Each feature is matched at most once, as matching makes sure.
fn match_pair(
    flight: &BlockFlight,
    seen: &Seen,
    sightings: &Sightings,
    images: [u32; 2],
    common: &[[u32; 2]],
    random: &mut Random,
) -> Vec<FeatureMatch> {
    let [left, right] = images.map(|image| &seen.owners[image as usize]);
    let (mut used_left, mut used_right) = (vec![false; left.len()], vec![false; right.len()]);
    let mut found = Vec::new();
    let mut add = |features: [u32; 2], strength: f64, used_left: &mut [bool], used_right: &mut [bool]| {
        if !used_left[features[0] as usize] && !used_right[features[1] as usize] {
            used_left[features[0] as usize] = true;
            used_right[features[1] as usize] = true;
            found.push(FeatureMatch { features, strength: strength as f32 });
        }
    };
    for features in common {
        if !random.chance(flight.matched) {
            continue;
        }
        let noise = random.normal_pair().x;
        if !random.chance(flight.wrong) {
            add(*features, STRONGER + noise, &mut used_left, &mut used_right);
            continue;
        }
        // A repeated structure looks like the same other one in every photo that shows both.
        let twin = left[features[0] as usize]
            .filter(|_| random.chance(flight.repeated))
            .and_then(|owner| sightings.in_image(twin_of(owner, seen), images[1]));
        let partner = twin.unwrap_or_else(|| ((random.uniform() * right.len() as f64) as u32).min(right.len() as u32 - 1));
        add([features[0], partner], noise, &mut used_left, &mut used_right);
    }
    found
}

/// Neighbours in the order of the ground, which is that of its squares, are taken for repetitions of each other.
fn twin_of(owner: u32, seen: &Seen) -> u32 {
    (owner ^ 1).min(seen.ground.len() as u32 - 1)
}
