//! A wanted number of points, well distributed: half of them equally over the cells of a grid, the others where they are best.

/// Chooses `number` of the points, in their order; `of` gives the cell and the weight of a point.
///
/// Each cell keeps its best points, as many as any other may keep, until half the number is reached; a cell that has fewer keeps them
/// all. The other half are the greatest weights of what is left; of equal weights, the first.
pub(super) fn well_distributed<P: Copy>(points: &[P], number: usize, of: impl Fn(&P) -> (usize, f64)) -> Vec<P> {
    if points.len() <= number {
        return points.to_vec();
    }
    let (cells, weights): (Vec<usize>, Vec<f64>) = points.iter().map(of).unzip();
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_unstable_by(|a, b| weights[*b].total_cmp(&weights[*a]).then(a.cmp(b)));
    // How many better ones each point has in its cell.
    let mut filled = vec![0usize; cells.iter().max().map_or(0, |most| most + 1)];
    let mut ranks = vec![0usize; points.len()];
    for place in &order {
        ranks[*place] = filled[cells[*place]];
        filled[cells[*place]] += 1;
    }
    let mut of_rank = vec![0usize; filled.iter().max().map_or(0, |most| *most)];
    ranks.iter().for_each(|rank| of_rank[*rank] += 1);
    let mut left = number / 2;
    let share = of_rank.iter().take_while(|points| left.checked_sub(**points).inspect(|rest| left = *rest).is_some()).count();
    let mut chosen: Vec<usize> = (0..points.len()).filter(|place| ranks[*place] < share).collect();
    let others = number - chosen.len();
    chosen.extend(order.into_iter().filter(|place| ranks[*place] >= share).take(others));
    chosen.sort_unstable();
    chosen.into_iter().map(|place| points[place]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(cells: &[usize], weights: &[f64], number: usize) -> Vec<usize> {
        let places: Vec<usize> = (0..cells.len()).collect();
        well_distributed(&places, number, |place| (cells[*place], weights[*place]))
    }

    #[test]
    fn dull_cells_keep_their_share() {
        let cells = [0, 0, 0, 0, 0, 1, 1, 2];
        let weights = [90.0, 80.0, 70.0, 60.0, 50.0, 2.0, 3.0, 1.0];
        // Half of 6 are one a cell, the others the best of what is left.
        assert_eq!(chosen(&cells, &weights, 6), [0, 1, 2, 3, 6, 7]);
        assert_eq!(chosen(&cells, &weights, 4), [0, 1, 2, 3]);
        assert_eq!(chosen(&cells, &weights, 7), [0, 1, 2, 3, 4, 6, 7]);
        assert_eq!(chosen(&cells, &weights, 8).len(), 8);
        assert!(chosen(&cells, &weights, 0).is_empty());
    }

    #[test]
    fn of_equal_weights_the_first_stay() {
        assert_eq!(chosen(&[0; 6], &[1.0; 6], 4), [0, 1, 2, 3]);
    }
}
