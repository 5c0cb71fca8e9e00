//! The order of elimination that keeps the factor sparse, and the factor's structure in it.

use std::collections::BTreeSet;

/// The order of elimination, and for each node in it the later ones that its column of the factor holds.
pub(super) struct Elimination {
    pub order: Vec<u32>,
    /// Nodes by their own numbers, not by their places.
    pub columns: Vec<Vec<u32>>,
}

/// Eliminates the node of the fewest neighbours first (the lower number among equals), all of a turn before those of later ones.
///
/// `neighbours` of each node are sorted, without itself; `turns` says in which turn each goes.
///
/// # Source
/// Tinney & Walker 1967, Direct solutions of sparse network equations by optimally ordered triangular factorization (scheme 2).
pub(super) fn minimum_degree(mut neighbours: Vec<Vec<u32>>, turns: &[u32]) -> Elimination {
    let key = |degree: usize, node: u32| (turns[node as usize], degree as u32, node);
    let mut queue: BTreeSet<(u32, u32, u32)> = neighbours.iter().enumerate().map(|(node, list)| key(list.len(), node as u32)).collect();
    let mut elimination = Elimination { order: Vec::with_capacity(neighbours.len()), columns: Vec::with_capacity(neighbours.len()) };
    let mut merged = Vec::new();
    while let Some((_, _, node)) = queue.pop_first() {
        let column = std::mem::take(&mut neighbours[node as usize]);
        for &other in &column {
            let list = &mut neighbours[other as usize];
            let before = list.len();
            merge(list, &column, [node, other], &mut merged);
            std::mem::swap(list, &mut merged);
            if list.len() != before {
                queue.remove(&key(before, other));
                queue.insert(key(list.len(), other));
            }
        }
        elimination.order.push(node);
        elimination.columns.push(column);
    }
    elimination
}

/// The union of two sorted lists without two of their numbers.
fn merge(a: &[u32], b: &[u32], without: [u32; 2], out: &mut Vec<u32>) {
    out.clear();
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let (x, y) = (a.get(i).copied().unwrap_or(u32::MAX), b.get(j).copied().unwrap_or(u32::MAX));
        let next = x.min(y);
        i += usize::from(x == next);
        j += usize::from(y == next);
        if next != without[0] && next != without[1] {
            out.push(next);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_eliminated_without_fill() {
        let chain = (0..7u32).map(|k| [k.wrapping_sub(1), k + 1].into_iter().filter(|n| *n < 7).collect()).collect();
        let elimination = minimum_degree(chain, &[0; 7]);
        assert_eq!(elimination.columns.iter().map(Vec::len).max(), Some(1));
        let mut order = elimination.order.clone();
        order.sort_unstable();
        assert_eq!(order, (0..7).collect::<Vec<_>>());
    }

    #[test]
    fn the_centre_of_a_star_comes_late() {
        let star = (0..6u32).map(|k| if k == 0 { (1..6).collect() } else { vec![0] }).collect();
        let elimination = minimum_degree(star, &[0; 6]);
        assert!(elimination.columns.iter().all(|column| column.len() <= 1));
        assert!(elimination.order.iter().position(|n| *n == 0) >= Some(4));
    }
}
