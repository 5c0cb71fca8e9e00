//! Right and wrong matches told apart where it is known what wrong ones look like: the local false discovery rate.

use super::evidence::Evidence;

/// Matches that were found, and wrong ones made at random beside them, by what is around them.
pub(super) struct Group {
    pub found: Vec<Evidence>,
    pub wrong: Vec<Evidence>,
}

/// What tells right matches from wrong ones in all groups.
pub(super) struct TwoGroups {
    /// The share of wrong matches.
    wrong: f64,
    places: Places,
}

/// Expected shares count as much as this many matches.
const PRIOR_MATCHES: f64 = 20.0;

/// So many wrong matches have triangles that close, since what they show repeats, to one whose triangles stay open.
const CLOSED_BY_REPETITION: f64 = 0.01;

impl TwoGroups {
    /// What all groups have in common.
    ///
    /// Matches over which triangles stay open and none closes are held for wrong, and tell how many are wrong: among the wrong ones they are as
    /// frequent as among those made at random. Where many are wrong, right ones are among them, beside sides that are wrong: then more are held
    /// for wrong than are, and those that no triangle confirms are not trusted.
    ///
    /// # Source
    /// Efron 2008, Microarrays, empirical Bayes and the two-groups model; that triangles of matches tell right from wrong: Zach, Klopschitz &
    /// Pollefeys 2010, Disambiguating visual relations using loop constraints.
    pub(super) fn of(groups: &[Group], expected_right: f64) -> Self {
        let found = Counts::of(groups.iter().flat_map(|group| &group.found));
        let wrong = Counts::of(groups.iter().flat_map(|group| &group.wrong));
        let shares: [f64; PLACES] = std::array::from_fn(|place| found.share(place));
        let closed: f64 = shares[CLOSED..].iter().sum();
        // Where few wrong ones were made, they are taken to find as many partners as the found ones, and other ones.
        let expected = |place: usize| match place {
            AGAINST => shares[place] + (1.0 - CLOSED_BY_REPETITION) * closed,
            CLOSED.. => CLOSED_BY_REPETITION * shares[place],
            _ => shares[place],
        };
        let wrong: [f64; PLACES] = std::array::from_fn(|place| wrong.share_beside(place, expected(place)));
        let repeated = CLOSED_BY_REPETITION * wrong[AGAINST] / closed.max(f64::MIN_POSITIVE);
        let places =
            Places { found: shares, wrong: std::array::from_fn(|p| wrong[p] + if p >= CLOSED { repeated * shares[p] } else { 0.0 }) };
        Self { wrong: places.share_of_wrong(&found, 1.0 - expected_right), places }
    }

    /// The probability that each match of a group is right, in their order: groups differ in how many are wrong, and in what is around them.
    pub(super) fn right_of(&self, group: &Group) -> Vec<f64> {
        let [found, wrong] = [&group.found, &group.wrong].map(|list| Counts::of(list.iter()));
        let places = Places {
            found: std::array::from_fn(|place| found.share_beside(place, self.places.found[place])),
            wrong: std::array::from_fn(|place| wrong.share_beside(place, self.places.wrong[place])),
        };
        let share = places.share_of_wrong(&found, self.wrong);
        group.found.iter().map(|e| 1.0 - places.wrong_at(place(*e), share)).collect()
    }
}

/// By what is around it a match has one of these places: its triangles stay open; it has none, by the images in which one of its features lacks a
/// partner; or one closes, by how many have three sides and by how many lack one. That a right match has few partners says how seldom its
/// features are found; what wrong matches have in the same place decides.
const MISSING: usize = 5;
const TOLD: usize = 3;
const AGAINST: usize = 0;
const ALONE: usize = 1;
const CLOSED: usize = ALONE + MISSING;
const PLACES: usize = CLOSED + TOLD * MISSING;

/// Missing sides are counted in ever wider steps: 0, 1, 2, 3 and 4, 5 and more.
fn place(e: Evidence) -> usize {
    let missing = match e.missing {
        few @ 0..=2 => usize::from(few),
        3..=4 => 3,
        _ => 4,
    };
    match (e.closed, usize::from(e.told())) {
        (0, 0) => ALONE + missing,
        (0, _) => AGAINST,
        (_, told) => CLOSED + (told.min(TOLD) - 1) * MISSING + missing,
    }
}

/// How many matches have which place.
struct Counts {
    of: [f64; PLACES],
    all: f64,
}

impl Counts {
    fn of<'a>(evidence: impl Iterator<Item = &'a Evidence>) -> Self {
        let mut new = Self { of: [0.0; PLACES], all: 0.0 };
        for e in evidence {
            new.of[place(*e)] += 1.0;
            new.all += 1.0;
        }
        new
    }

    fn share(&self, place: usize) -> f64 {
        self.of[place] / self.all.max(1.0)
    }

    /// The share of a place where few were counted: the expected share counts as some more.
    fn share_beside(&self, place: usize, expected: f64) -> f64 {
        (self.of[place] + PRIOR_MATCHES * expected) / (self.all + PRIOR_MATCHES)
    }
}

/// The shares of the places of found and of wrong matches.
struct Places {
    found: [f64; PLACES],
    wrong: [f64; PLACES],
}

impl Places {
    /// The share of wrong ones of some matches where a share is expected.
    fn share_of_wrong(&self, found: &Counts, expected: f64) -> f64 {
        let were_all_wrong = self.wrong[AGAINST] * found.all;
        ((found.of[AGAINST] + PRIOR_MATCHES * expected) / (were_all_wrong + PRIOR_MATCHES)).min(1.0)
    }

    /// The probability that a match here is wrong, where a share of all is.
    fn wrong_at(&self, place: usize, share: f64) -> f64 {
        match place {
            AGAINST => 1.0,
            _ => (share * self.wrong[place] / self.found[place]).min(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(closed: u8, open: u8, missing: u8) -> Evidence {
        Evidence { closed, open, missing }
    }

    fn repeated(list: &[(Evidence, usize)]) -> Vec<Evidence> {
        list.iter().flat_map(|(e, count)| std::iter::repeat_n(*e, *count)).collect()
    }

    fn right_at(group: &Group, e: Evidence, expected_right: f64) -> f64 {
        let p = TwoGroups::of(std::slice::from_ref(group), expected_right).right_of(group);
        p[group.found.iter().position(|found| *found == e).unwrap()]
    }

    /// Half of the right features are seldom found again: that is no sign of a wrong match where wrong ones are mostly told by their triangles.
    #[test]
    fn matches_of_seldom_found_features_are_judged_by_what_wrong_ones_find() {
        let right = [(of(3, 0, 1), 4800), (of(0, 0, 4), 3000), (of(0, 0, 0), 1800)];
        let wrong = [(of(0, 2, 2), 200), (of(0, 1, 3), 160), (of(0, 0, 4), 40)];
        let group = Group { found: repeated(&[right.as_slice(), &wrong].concat()), wrong: repeated(&wrong) };
        let at = |e| right_at(&group, e, 0.998);
        assert!((at(of(0, 0, 4)) - 3000.0 / 3040.0).abs() < 0.005, "{}", at(of(0, 0, 4)));
        assert!(at(of(0, 0, 0)) > 0.998 && at(of(3, 0, 1)) > 0.999 && at(of(0, 1, 3)) == 0.0);
    }

    /// Wrong matches of a group that has many of them are not hidden by those of the others.
    #[test]
    fn a_group_with_more_wrong_matches_is_trusted_less() {
        let wrong = [(of(0, 1, 1), 100), (of(0, 0, 1), 100)];
        let group = |wrong_ones| Group {
            found: repeated(&[(of(2, 0, 0), 500), (of(0, 0, 1), 200 + wrong_ones), (of(0, 1, 1), wrong_ones)]),
            wrong: repeated(&wrong),
        };
        let groups = [group(5), group(100)];
        let both = TwoGroups::of(&groups, 0.998);
        let [good, bad] = groups.each_ref().map(|group| both.right_of(group)[500]);
        assert!(good > 0.96 && (0.6..0.75).contains(&bad), "{good} {bad}");
    }

    #[test]
    fn without_triangles_the_expected_share_stands() {
        let group = Group { found: vec![Evidence::default(); 60], wrong: vec![Evidence::default(); 200] };
        assert!((right_at(&group, Evidence::default(), 0.998) - 0.998).abs() < 1e-12);
    }
}
