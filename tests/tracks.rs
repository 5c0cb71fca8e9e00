//! Multi-ray points of simulated blocks, of which it is known what belongs together.

use std::collections::BTreeMap;
use tiepoint::{
    BlockFlight, BlockOptions, BlockView, Conflicts, JoinCounts, SelectOptions, SelectedPoints, SimulatedBlock, TiePoints, select_points,
    shared_points, simulate_block, tie_points,
};

const VIEWS: [BlockView; 3] = [BlockView::Nadir, BlockView::Oblique, BlockView::TwoHeights];

fn flown(view: BlockView, wrong: f64) -> SimulatedBlock {
    simulate_block(&BlockFlight { view, wrong, ..BlockFlight::default() }).unwrap()
}

fn joined(block: &SimulatedBlock, conflicts: Conflicts) -> (TiePoints, JoinCounts) {
    tie_points(&block.matches().unwrap(), &block.image_features(), &BlockOptions { conflicts, ..BlockOptions::default() }).unwrap()
}

/// The share of points whose rays all show the same ground.
fn pure(block: &SimulatedBlock, points: &TiePoints) -> f64 {
    let belongs = |rays: &&[tiepoint::FeatureObservation]| {
        rays.windows(2).all(|r| block.is_right((r[0].image, r[0].feature), (r[1].image, r[1].feature)))
    };
    points.iter().filter(belongs).count() as f64 / points.len() as f64
}

fn share_of_wrong(block: &SimulatedBlock) -> f64 {
    let right = |[a, b]: [u32; 2], m: &tiepoint::FeatureMatch| block.is_right((a, m.features[0]), (b, m.features[1]));
    let counts = block.pairs.iter().map(|(images, list)| (list.iter().filter(|m| !right(*images, m)).count(), list.len()));
    let (wrong, all) = counts.fold((0, 0), |(w, n), (wrong, all)| (w + wrong, n + all));
    wrong as f64 / all as f64
}

/// The points among those of some rays that a perfect matching would give.
fn seen_by(block: &SimulatedBlock, least: usize) -> usize {
    let mut rays = BTreeMap::new();
    block.owners.iter().flatten().flatten().for_each(|owner| *rays.entry(*owner).or_insert(0_usize) += 1);
    rays.values().filter(|count| **count >= least).count()
}

#[test]
fn the_rays_of_a_point_belong_together_though_two_matches_of_five_are_wrong() {
    for view in VIEWS {
        for (wrong, least_found) in [(0.05, 0.6), (0.4, 0.3)] {
            let block = flown(view, wrong);
            assert!((share_of_wrong(&block) - wrong).abs() < 0.03, "{view:?}: {}", share_of_wrong(&block));
            let (points, counts) = joined(&block, Conflicts::Resolve);
            let found = points.iter().filter(|rays| rays.len() >= 3).count() as f64 / seen_by(&block, 3) as f64;
            println!("{view:?}, {wrong}: {} points, pure {:.4}, found {found:.3}, {counts:?}", points.len(), pure(&block, &points));
            assert!(pure(&block, &points) >= 0.995, "{view:?}, {wrong}: pure {}", pure(&block, &points));
            assert!(found > least_found, "{view:?}, {wrong}: found {found}");
        }
    }
}

#[test]
fn resolved_conflicts_keep_more_rays_than_dropped_ones() {
    let mut more = 0;
    for view in VIEWS {
        let block = flown(view, 0.4);
        let [resolved, dropped] = [Conflicts::Resolve, Conflicts::Drop].map(|conflicts| joined(&block, conflicts).0.ray_count());
        let plain = rays_of_plain_components(&block);
        println!("{view:?}: {resolved} rays resolved, {dropped} dropped, {plain} right ones in plain components without conflict");
        assert!(resolved > plain, "{view:?}: {resolved} resolved, {plain} in plain components");
        assert!(resolved >= dropped, "{view:?}: {resolved} resolved, {dropped} dropped");
        more += resolved - dropped;
    }
    assert!(more > 0);
}

#[test]
fn a_point_meets_no_image_twice_and_its_rays_are_in_order() {
    let block = flown(BlockView::Oblique, 0.4);
    let (points, _) = joined(&block, Conflicts::Resolve);
    assert!(points.iter().all(|rays| rays.len() >= 2 && rays.windows(2).all(|r| r[0].image < r[1].image)));
    assert!(points.iter().flatten().all(|ray| (0.5..=1.0).contains(&ray.confidence)));
    assert!((0..points.len()).all(|point| (0.0..=1.0).contains(&points.confidence(point))));
}

/// Rays that belong together in the connected components of all matches that meet no image twice: what is left where nothing is judged.
fn rays_of_plain_components(block: &SimulatedBlock) -> usize {
    fn root(parent: &mut [usize], mut node: usize) -> usize {
        while parent[node] != node {
            parent[node] = parent[parent[node]];
            node = parent[node];
        }
        node
    }
    let mut starts = vec![0];
    block.features.iter().for_each(|list| starts.push(starts[starts.len() - 1] + list.len()));
    let mut parent: Vec<usize> = (0..starts[block.features.len()]).collect();
    for (images, list) in &block.pairs {
        for m in list {
            let [a, b] = [0, 1].map(|side| root(&mut parent, starts[images[side] as usize] + m.features[side] as usize));
            parent[a] = b;
        }
    }
    let mut components: BTreeMap<usize, Vec<(u32, u32)>> = BTreeMap::new();
    for (image, list) in block.features.iter().enumerate() {
        (0..list.len()).for_each(|f| components.entry(root(&mut parent, starts[image] + f)).or_default().push((image as u32, f as u32)));
    }
    let kept = |rays: &&Vec<(u32, u32)>| rays.len() >= 2 && rays.windows(2).all(|r| r[0].0 != r[1].0 && block.is_right(r[0], r[1]));
    components.values().filter(kept).map(Vec::len).sum()
}

#[test]
fn the_expected_share_of_impure_points_is_about_the_true_one() {
    let block = simulate_block(&BlockFlight { wrong: 0.4, ..BlockFlight::default() }).unwrap();
    let (points, _) =
        tie_points(&block.matches().unwrap(), &block.image_features(), &BlockOptions { impure: 0.5, ..BlockOptions::default() }).unwrap();
    let expected = (0..points.len()).map(|point| 1.0 - f64::from(points.confidence(point))).sum::<f64>() / points.len() as f64;
    let found = 1.0 - pure(&block, &points);
    println!("impure: expected {expected:.4}, found {found:.4}");
    assert!((expected - found).abs() < 0.005, "expected {expected}, found {found}");
}

fn selected(block: &SimulatedBlock, points: &TiePoints, options: &SelectOptions) -> SelectedPoints {
    select_points(points, &block.image_features(), options).unwrap()
}

/// The common points of each pair of images, of all points or of some.
fn common(points: &TiePoints, chosen: Option<&[u32]>) -> BTreeMap<[u32; 2], u32> {
    let mut counts = BTreeMap::new();
    let all: Vec<u32> = (0..points.len() as u32).collect();
    for point in chosen.unwrap_or(&all) {
        let rays = points.rays(*point as usize);
        for (index, a) in rays.iter().enumerate() {
            rays[index + 1..].iter().for_each(|b| *counts.entry([a.image, b.image]).or_insert(0) += 1);
        }
    }
    counts
}

#[test]
fn the_selection_fills_every_image_and_thins_no_connection_away() {
    for view in VIEWS {
        let block = flown(view, 0.05);
        let (points, _) = joined(&block, Conflicts::Resolve);
        let per_connection = if view == BlockView::Nadir { 6 } else { SelectOptions::default().per_connection };
        let chosen = selected(&block, &points, &SelectOptions { per_connection, ..SelectOptions::default() });
        let (before, after) = (common(&points, None), common(&points, Some(&chosen.points)));
        let told: BTreeMap<_, _> = shared_points(&points, block.exposures.len()).iter().map(|s| (s.images, s.points)).collect();
        assert_eq!(before, told);
        for (images, count) in &before {
            let left = after.get(images).copied().unwrap_or(0);
            assert!(left >= (*count).min(per_connection as u32), "{view:?} {images:?}: {left} of {count}");
        }
        let mut rays = chosen.rays_of_images.clone();
        rays.sort_unstable();
        println!(
            "{view:?}: {} of {} points, rays an image {} to {}, median {}",
            chosen.points.len(),
            points.len(),
            rays[0],
            rays[rays.len() - 1],
            rays[rays.len() / 2]
        );
        assert!(rays[0] >= 40, "{view:?}: an image has {} rays", rays[0]);
        assert!(rays[rays.len() / 2] <= 70, "{view:?}: half of the images have more than {} rays", rays[rays.len() / 2]);
        assert!(chosen.places_of_images.iter().all(|places| *places >= 8), "{view:?}: {:?}", chosen.places_of_images);
        assert!(chosen.points.windows(2).all(|p| p[0] < p[1]));
    }
}

#[test]
fn few_points_are_all_kept_and_more_are_chosen_where_more_are_wanted() {
    let block = flown(BlockView::Nadir, 0.05);
    let (points, _) = joined(&block, Conflicts::Resolve);
    let count = |per_image| selected(&block, &points, &SelectOptions { per_image, ..SelectOptions::default() }).points.len();
    let counts = [9, 40, 100, 10_000].map(count);
    assert!(counts.windows(2).all(|c| c[0] < c[1]), "{counts:?}");
    assert_eq!(counts[3], points.len());
}

#[test]
fn the_same_block_gives_the_same_points() {
    let flight = BlockFlight { strips: 3, exposures: 4, wrong: 0.3, ..BlockFlight::default() };
    let (block, again) = (simulate_block(&flight).unwrap(), simulate_block(&flight).unwrap());
    assert_eq!(block, again);
    let (points, counts) = joined(&block, Conflicts::Resolve);
    let mut turned = block.clone();
    turned.pairs.reverse();
    turned.pairs.iter_mut().for_each(|(images, list)| {
        images.swap(0, 1);
        list.reverse();
        list.iter_mut().for_each(|m| m.features.swap(0, 1));
    });
    assert_eq!(joined(&turned, Conflicts::Resolve), (points, counts));
}

#[test]
fn a_flight_that_cannot_be_flown_is_refused_by_name() {
    for (flight, name) in [
        (BlockFlight { strips: 0, ..BlockFlight::default() }, "block_flight.strips"),
        (BlockFlight { wrong: f64::NAN, ..BlockFlight::default() }, "block_flight.wrong"),
        (BlockFlight { forward_overlap: 1.0, ..BlockFlight::default() }, "block_flight.forward_overlap"),
    ] {
        assert!(matches!(simulate_block(&flight), Err(tiepoint::Error::InvalidOption { field, .. }) if field == name));
    }
}

#[test]
fn rays_without_a_feature_are_refused() {
    let block = flown(BlockView::Nadir, 0.05);
    let (points, _) = joined(&block, Conflicts::Resolve);
    let mut features = block.image_features();
    features[3].positions = &[];
    assert!(select_points(&points, &features, &SelectOptions::default()).unwrap_err().to_string().contains("image 3"));
    assert!(select_points(&points, &features[..10], &SelectOptions::default()).is_err());
    let outside = [[f32::NAN, 1.0]];
    features[3].positions = &outside;
    assert!(select_points(&points, &features, &SelectOptions::default()).unwrap_err().to_string().contains("image 3 of 4000 x 3000"));
}
