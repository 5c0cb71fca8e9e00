//! Nested dissection: the nodes that separate a large graph into halves are eliminated after both.

/// A part of so many nodes is not cut any more: there the minimum degree alone does as well.
const LEAST_PART: usize = 400;
/// A separator with more than this share of its part separates nothing.
const LARGEST_SEPARATOR: f64 = 0.25;

/// The node belongs to a separator.
const SEPARATES: u32 = u32::MAX;

/// The turn in which each node is eliminated: 0 for those in parts, later ones for separators, those of the largest parts last.
///
/// `places` are where nodes lie in space: a part is cut across one of the axes, where that parts as few couplings as any.
///
/// # Source
/// George 1973, Nested dissection of a regular finite element mesh.
pub(super) fn turns(neighbours: &[Vec<u32>], places: &[[f64; 3]]) -> Vec<u32> {
    let mut part = vec![0; neighbours.len()];
    let mut depth_of = vec![None; neighbours.len()];
    let mut open = vec![((0..neighbours.len() as u32).collect::<Vec<u32>>(), 0_u32)];
    let (mut parts, mut deepest) = (0, 0);
    while let Some((nodes, depth)) = open.pop() {
        if nodes.len() <= LEAST_PART {
            continue;
        }
        let ends = [parts + 1, parts + 2];
        let cuts = [0, 1, 2].map(|axis| halves(&nodes, places, axis));
        let separators = cuts.each_ref().map(|halves| separator(halves, ends, neighbours, &mut part));
        let Some(axis) = (0..3).min_by_key(|axis| separators[*axis].len()) else { continue };
        if separators[axis].len() as f64 > LARGEST_SEPARATOR * nodes.len() as f64 {
            continue;
        }
        parts += 2;
        deepest = deepest.max(depth + 1);
        label(&cuts[axis], ends, &mut part);
        for node in &separators[axis] {
            (part[*node as usize], depth_of[*node as usize]) = (SEPARATES, Some(depth));
        }
        for half in &cuts[axis] {
            open.push((half.iter().copied().filter(|node| part[*node as usize] != SEPARATES).collect(), depth + 1));
        }
    }
    depth_of.into_iter().map(|depth| depth.map_or(0, |depth| deepest - depth)).collect()
}

/// The nodes of a part in two halves along an axis.
fn halves(nodes: &[u32], places: &[[f64; 3]], axis: usize) -> [Vec<u32>; 2] {
    let mut sorted = nodes.to_vec();
    let at = |node: &u32| places[*node as usize][axis];
    sorted.sort_unstable_by(|a, b| at(a).total_cmp(&at(b)).then(a.cmp(b)));
    let second = sorted.split_off(nodes.len() / 2);
    [sorted, second]
}

fn label(halves: &[Vec<u32>; 2], ends: [u32; 2], part: &mut [u32]) {
    halves.iter().zip(ends).for_each(|(half, end)| half.iter().for_each(|node| part[*node as usize] = end));
}

/// The nodes of one half that are neighbours of the other, of the half that has fewer of them.
fn separator(halves: &[Vec<u32>; 2], ends: [u32; 2], neighbours: &[Vec<u32>], part: &mut [u32]) -> Vec<u32> {
    label(halves, ends, part);
    let [first, second] = [0, 1].map(|side| {
        let beyond = ends[1 - side];
        let borders = |node: &u32| neighbours[*node as usize].iter().any(|other| part[*other as usize] == beyond);
        halves[side].iter().copied().filter(borders).collect::<Vec<u32>>()
    });
    if first.len() <= second.len() { first } else { second }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adjustment::sparse::ordering::minimum_degree;

    /// A grid of nodes with all neighbours within `reach` along and across.
    fn grid(side: usize, reach: usize) -> (Vec<Vec<u32>>, Vec<[f64; 3]>) {
        let near = |a: usize| a.saturating_sub(reach)..(a + reach + 1).min(side);
        let of = |row: usize, column: usize| {
            let all = near(row).flat_map(|r| near(column).map(move |c| r * side + c));
            all.filter(|node| *node != row * side + column).map(|node| node as u32).collect()
        };
        let nodes = || (0..side).flat_map(|row| (0..side).map(move |column| (row, column)));
        (nodes().map(|(row, column)| of(row, column)).collect(), nodes().map(|(r, c)| [c as f64, r as f64, 0.0]).collect())
    }

    #[test]
    fn separators_come_after_what_they_separate_and_keep_the_factor_sparse() {
        let (neighbours, places) = grid(40, 2);
        let turns = turns(&neighbours, &places);
        assert_eq!(turns.iter().filter(|turn| **turn == 2).count(), 2 * 40, "the first cut is two columns wide");
        assert!(turns.contains(&1));
        // No way leads from one half to the other but through the separator.
        let mut reached = vec![false; turns.len()];
        let mut open = vec![0_u32];
        while let Some(node) = open.pop() {
            let is_new = turns[node as usize] < 2 && !std::mem::replace(&mut reached[node as usize], true);
            open.extend(neighbours[node as usize].iter().filter(|_| is_new));
        }
        let count = reached.iter().filter(|reached| **reached).count();
        assert!((600..900).contains(&count), "{count}");
        let work = |turns: &[u32]| minimum_degree(neighbours.clone(), turns).columns.iter().map(|c| c.len() * c.len()).sum::<usize>();
        assert!(work(&turns) < work(&vec![0; 1600]), "{} {}", work(&turns), work(&vec![0; 1600]));
    }

    #[test]
    fn small_and_complete_graphs_are_not_cut() {
        let (neighbours, places) = grid(20, 1);
        assert!(turns(&neighbours, &places).iter().all(|turn| *turn == 0));
        let complete: Vec<Vec<u32>> = (0..500).map(|a| (0..500).filter(|b| *b != a).collect()).collect();
        assert!(turns(&complete, &vec![[0.0; 3]; 500]).iter().all(|turn| *turn == 0));
    }
}
