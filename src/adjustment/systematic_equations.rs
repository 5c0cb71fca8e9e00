//! What an observed position adds to the normal equations beyond its projection centre: turns of the image, and systematic errors.

use super::reduced::{Problem, Reduced};
use super::sparse::N;
use super::state::State;

impl Problem<'_> {
    /// Adds what the position of an image says of its turns and of the systematic errors, with the weights of its coordinates; `off`: observed
    /// minus computed. What it says of the projection centre alone is in the equations already.
    pub fn add_systematic(&self, state: &State, image: usize, weight: &[f64; 3], off: &[f64; 3], reduced: &mut Reduced) {
        let (q, at) = (self.columns.number(), self.network.pattern.place[image] as usize);
        let turns = self.systematic.by_turns(state, image);
        let own = self.systematic.by_columns(self.columns, state, image);
        for k in 0..3 {
            let mut row = [0.0; N];
            row[..3].copy_from_slice(&turns[k]);
            row[3 + k] = 1.0;
            for (r, c) in (0..N * N).map(|index| (index % N, index / N)).filter(|place| *place != (3 + k, 3 + k)) {
                reduced.matrix.diagonal[at][c * N + r] += weight[k] * row[r] * row[c];
            }
            for r in 0..3 {
                reduced.scale[at][r] += weight[k] * row[r] * row[r];
                reduced.right[at * N + r] += weight[k] * row[r] * off[k];
            }
            for (column, slope) in &own {
                let weighted = weight[k] * slope[k];
                (0..N).for_each(|r| reduced.border[*column][at * N + r] += weighted * row[r]);
                own.iter().for_each(|(other, second)| reduced.corner[other * q + column] += weighted * second[k]);
                reduced.corner_scale[*column] += weighted * slope[k];
                reduced.corner_right[*column] += weighted * off[k];
            }
        }
    }
}
