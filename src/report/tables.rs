//! The paper's Tables 1, 2 and 3 for all strategies, beside what it printed, and what sets the two apart.

use super::input::ReportTruth;
use super::paper::PAPER;
use super::steps::Report;
use super::study::Study;
use super::unknowns::{PRINTED_DIGITS, UNKNOWNS, five};
use crate::html::{count, digits_of_error, fixed, percent, significant};
use crate::{Denominator, FiveParameters, MatchOptions, MatchScore, Rule, Texts};
use maud::{Markup, html};

/// Table 1: how many points each phase left.
pub fn counts(report: &Report) -> Markup {
    let first = &report.studies[0].result;
    let phases = [
        ("Operator", first.left.counts.candidates, first.right.counts.candidates, Some(PAPER.points[0])),
        ("Threshold of roundness", first.left.counts.after_roundness, first.right.counts.after_roundness, None),
        ("Suppression of non-maxima", first.left.counts.after_suppression, first.right.counts.after_suppression, Some(PAPER.points[1])),
    ];
    html! {
        table tabindex="0" {
            caption { "Table 1. Points after each phase" }
            thead { tr { th { "Phase" } th { "Left" } th { "Right" } th.paper { "Paper, left" } th.paper { "Paper, right" } } }
            tbody {
                @for (name, left, right, printed) in phases {
                    tr { th { (name) } td { (count(left)) } td { (count(right)) } (paper_counts(printed)) }
                }
                @for study in &report.studies {
                    @let matches = study.result.matching.counts.matches;
                    @let printed = (study.name == "moments").then_some(PAPER.points[2]);
                    tr { th { "Matching: " (study.name) } td { (count(matches)) } td { (count(matches)) } (paper_counts(printed)) }
                }
            }
        }
    }
}

fn paper_counts(printed: Option<[usize; 2]>) -> Markup {
    html! { @for side in 0..2 { td.paper { (printed.map_or_else(|| "–".into(), |counts| count(counts[side]))) } } }
}

/// What became of the left points, by rule.
pub fn refusals(report: &Report) -> Markup {
    let number = |study: &Study, rule: Rule| study.result.matching.verdicts.iter().filter(|v| v.rule == rule).count();
    let applied = Rule::ALL.into_iter().filter(|rule| report.studies.iter().any(|study| number(study, *rule) > 0));
    html! {
        table tabindex="0" {
            caption { "What became of the left points" }
            (head(&report.studies, "", false))
            tbody {
                @for rule in applied { tr { th { @if rule != Rule::Matched { "Rejected: " } (Texts::english().label(&rule)) } @for study in &report.studies { td { (count(number(study, rule))) } } } }
                @if let Some(edits) = &report.edits {
                    (of_this_run(report, "of these: rejected by hand", edits.rejected))
                    (of_this_run(report, "measured by hand, in their place or beside them", edits.measured))
                }
                tr {
                    th { "of the matched: gross errors" }
                    @for study in &report.studies { td { (count(study.result.matching.matches.len() - study.used())) } }
                }
            }
        }
    }
}

/// A row of a figure that this run alone has.
fn of_this_run(report: &Report, title: &str, number: usize) -> Markup {
    html! { tr { th { (title) } td { (count(number)) } @for _ in 1..report.studies.len() { td { "–" } } } }
}

/// A count of a score.
type Counted = fn(&MatchScore) -> usize;

/// How right the matches are, where the truth is known.
pub fn scores(report: &Report) -> Markup {
    let rows: [(&str, Counted); 3] =
        [("right, at edges too", |s| s.right), ("strictly right", |s| s.strict), ("seen in both, but not matched rightly", |s| s.missed)];
    html! {
        table tabindex="0" {
            caption { "Matches against the truth" }
            (head(&report.studies, "", false))
            tbody {
                @for (k, (name, of)) in rows.into_iter().enumerate() {
                    tr {
                        th { (name) }
                        @for study in &report.studies {
                            @let score = study.score.as_ref();
                            td {
                                (score.map_or_else(|| "–".into(), |s| count(of(s))))
                                @if k < 2 { " " small { (score.map_or_else(String::new, |s| percent(of(s), s.rightness.len()))) } }
                            }
                        }
                    }
                }
            }
        }
        p.note {
            "Strictly right: the right point lies within 1.5 px of where the surface at the left pixel is seen. At edges too: or at one of its "
            "8 neighbours, since points lie on edges, where the surface may jump between two pixels."
        }
    }
}

/// Table 2: standard errors.
pub fn standard_errors(report: &Report) -> Markup {
    let with_interior = report.studies.iter().any(|s| s.result.orientation.as_ref().is_ok_and(|o| o.total_standard_errors.is_some()));
    let own = |study: &Study| study.result.orientation.as_ref().ok().and_then(|o| o.standard_errors).map(|e| five(&e));
    let total = |study: &Study| study.result.orientation.as_ref().ok().and_then(|o| o.total_standard_errors).map(|e| five(&e));
    let half_widths = |study: &Study| study.result.orientation.as_ref().ok().and_then(|o| o.half_widths_95).map(|e| five(&e));
    html! {
        table tabindex="0" {
            caption { "Table 2. Standard errors" }
            (head(&report.studies, "Paper", true))
            tbody {
                (parameter_rows(&report.studies, own, Some(&PAPER.standard_errors)))
                tr {
                    th { "σ₀, px" }
                    @for study in &report.studies { td { (fixed(study.sigma0_px(), 3)) } }
                    td.paper { (fixed(PAPER.sigma0_mm / PAPER.pixel_mm, 1)) }
                }
                tr { th { "σ₀ of all matches, px" } @for study in &report.studies { td { (fixed(study.sigma0_of_all_px(), 3)) } } td.paper {} }
                tr { th { "matches used" } @for study in &report.studies { td { (count(study.used())) } } td.paper { (count(PAPER.points[2][0])) } }
            }
            @if with_interior {
                tbody {
                    tr.subhead { th colspan=(report.studies.len() + 2) { "in total: with what matches share, and the errors of the camera and of measured fiducial marks" } }
                    (parameter_rows(&report.studies, total, None))
                }
            }
            tbody {
                tr.subhead { th colspan=(report.studies.len() + 2) { "half-widths of the intervals that hold the unknowns in 95 % of cases" } }
                (parameter_rows(&report.studies, half_widths, None))
            }
        }
        p.note {
            "σ₀ of all matches: least squares from the vertical pair without rejection of gross errors and without robust weights. It is absent where that "
            "does not converge, and where cameras were estimated."
        }
    }
}

/// Table 3: the orientation by each strategy, with the truth where it is known.
pub fn orientations(report: &Report) -> Markup {
    let value = |study: &Study| study.result.orientation.as_ref().ok().map(|o| five(&o.parameters));
    // The truth is compared with the most precise of them.
    let finest = |k: usize| report.studies.iter().map(|study| study.digits(k)).max().unwrap_or(PRINTED_DIGITS);
    html! {
        table tabindex="0" {
            caption { "Table 3. Relative orientation by each strategy" }
            thead {
                tr {
                    th { "Unknown" }
                    @for study in &report.studies { th { (study.name) } }
                    @if report.truth.is_some() { th.truth { "truth" } }
                    @for printed in &PAPER.orientations { th.paper { "Paper: " (printed.name) } }
                }
            }
            tbody {
                tr {
                    th { "verdict" }
                    @for study in &report.studies { td { (Texts::english().label(&study.result.verdict())) } }
                    @if report.truth.is_some() { td.truth {} }
                    @for _ in &PAPER.orientations { td.paper {} }
                }
                tr {
                    th { i { "b" } " " small { "mm, fixed" } }
                    @for study in &report.studies { td { (significant(study.result.orientation.as_ref().ok().map(|o| o.base_mm))) } }
                    @if let Some(truth) = &report.truth { td.truth { (significant(truth.base_mm)) } }
                    @for _ in &PAPER.orientations { td.paper { "–" } }
                }
                @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
                    tr {
                        th { i { (symbol) } " " small { (unit) } }
                        @for study in &report.studies { td { (fixed(value(study).map(|v| v[k]), study.digits(k))) } }
                        @if let Some(truth) = &report.truth { td.truth { (fixed(five(&truth.orientation)[k], finest(k))) } }
                        @for printed in &PAPER.orientations { td.paper { (fixed(five(&printed.values)[k], PRINTED_DIGITS)) } }
                    }
                }
            }
            @if report.truth.is_some() {
                tbody {
                    tr.subhead { th colspan=(report.studies.len() + 5) { "true errors, and how many of its standard errors each is" } }
                    @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
                        tr { th { i { (symbol) } " " small { (unit) } } @for study in &report.studies { (true_error(study, k)) } }
                    }
                }
            }
        }
        @if let Some(truth) = report.truth.as_ref().filter(|truth| has_other_base(report, truth)) {
            p.note {
                "by and bz of the truth belong to its base of " (fixed(truth.base_mm, 3)) " mm. Where a strategy was oriented with another base, its true "
                "errors are those against the truth at the scale of that base."
            }
        }
        p.note {
            "The paper's columns by correlation and by least squares come from 15 points that earlier work measured on scans of 600 dpi: they have errors of "
            "their own."
        }
    }
}

/// Whether an orientation has another base than the truth, and with it another scale of its by and bz.
fn has_other_base(report: &Report, truth: &ReportTruth) -> bool {
    report.studies.iter().any(|study| study.result.orientation.as_ref().is_ok_and(|o| o.base_mm != truth.base_mm))
}

fn true_error(study: &Study, k: usize) -> Markup {
    let standard = study.result.orientation.as_ref().ok().and_then(|o| o.total_standard_errors.or(o.standard_errors)).map(|e| five(&e)[k]);
    let error = study.errors.map(|e| e[k]);
    html! { td { (fixed(error, study.digits(k))) " " small { "(" (fixed(error.zip(standard).map(|(e, s)| e / s), 1)) ")" } } }
}

fn head(studies: &[Study], last: &str, paper: bool) -> Markup {
    html! { thead { tr { td {} @for study in studies { th { (study.name) } } @if paper { th.paper { (last) } } } } }
}

fn parameter_rows(studies: &[Study], of: impl Fn(&Study) -> Option<[f64; 5]>, paper: Option<&FiveParameters>) -> Markup {
    html! {
        @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
            tr {
                th { i { (symbol) } " " small { (unit) } }
                @for study in studies { td { (fixed(of(study).map(|e| e[k]), study.digits(k))) } }
                @if let Some(paper) = paper { td.paper { (fixed(five(paper)[k], PRINTED_DIGITS)) } }
            }
        }
    }
}

/// Where the tables differ from the printed ones, and why: each reason with the figure that shows it on this pair.
pub fn differences(report: &Report) -> Markup {
    let Some(moments) = report.studies.iter().find(|study| study.name == "moments") else { return html! {} };
    html! {
        h3 { "Where this differs from the paper, and why" }
        ul {
            li { (difference_of_pairs(report.truth.as_ref())) }
            li { (difference_of_matches(moments)) }
            li { (difference_of_precision(moments)) }
            li {
                "Table 3. The paper's three columns were made from one pair, and differ by up to 0.127° in κ and 0.354 mm in by: 6.3 and 2.6 of the "
                "standard errors that its Table 2 states. Standard errors from residuals along y-parallaxes do not show blunders that were "
                "adjusted with the rest, nor errors of the interior orientation, which all points of a photo share."
                @if let Some(worst) = worst_ratio(report) {
                    " Here the same strategies stand beside the truth: the largest true error is " (fixed(worst.1, 1)) " of its standard errors (" (worst.0) ")."
                }
            }
        }
    }
}

fn difference_of_pairs(truth: Option<&ReportTruth>) -> Markup {
    html! {
        "The pair. The photographs of the paper are not published. "
        @if truth.is_some() {
            "This pair is simulated: a synthetic scene seen by a camera of known position. Its texture and contrast are not those of the "
            "paper's scene, and with them the counts of Table 1 differ; the paper does not give its base, for which 60 % overlap is taken."
        } @else {
            "This is another pair: every figure depends on its scene, its scale and its scan; only their kind can be compared."
        }
    }
}

fn difference_of_matches(moments: &Study) -> Markup {
    let points = moments.result.left.points.len();
    let denominator = match moments.settings.matching.denominator {
        Denominator::Maxabs => "the larger magnitude is the denominator",
        Denominator::Floor => "the larger magnitude, or the median magnitude of the moment where that is more, is the denominator",
    };
    html! {
        "Matches. The paper accepts the smallest measure below 3 in the search window. As printed, its measure has a denominator that can vanish, and "
        "a best candidate of many is below 3 nearly always. Here " (denominator) ", and matches "
        "are rejected that are " (inconsistent(&moments.settings.matching)) ": " (count(moments.result.matching.matches.len())) " of " (count(points)) " left points ("
        (percent(moments.result.matching.matches.len(), points)) ") are matched; in the paper " (count(PAPER.points[2][0])) " of " (count(PAPER.points[1][0])) " ("
        (percent(PAPER.points[2][0], PAPER.points[1][0])) ")."
    }
}

/// Which matches the rules of consistency refuse, of those that are switched on.
fn inconsistent(options: &MatchOptions) -> &'static str {
    match (options.ambiguity() < 1.0, options.parallax_neighbours > 0) {
        (true, true) => "ambiguous, many to one, or off the y-parallax of their neighbours",
        (true, false) => "ambiguous or many to one",
        (false, true) => "many to one, or off the y-parallax of their neighbours",
        (false, false) => "many to one",
    }
}

fn difference_of_precision(moments: &Study) -> Markup {
    let scaled = moments.standard_errors_at(PAPER.sigma0_mm, PAPER.points[2][0]);
    html! {
        "Table 2. The paper's σ₀ of 0.150 mm is 0.6 px; by moments "
        @if moments.sigma0_px().is_some() {
            "it is " (fixed(moments.sigma0_px(), 2)) " px here, after robust estimation and data snooping"
        } @else {
            "this pair is not oriented"
        }
        @if let Some(of_all) = moments.sigma0_of_all_px() { ", and " (fixed(of_all, 2)) " px of all matches without either" }
        ". "
        @if let Some(scaled) = scaled {
            "Standard errors grow with σ₀ and fall with the root of the number of matches. With the paper's σ₀ and number of matches, the "
            "geometry of this pair gives "
            @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
                @if k > 0 { ", " } i { (symbol) } " " (fixed(scaled[k], digits_of_error(scaled[k], PRINTED_DIGITS))) @if unit != "°" { " " } (unit) " (printed "
                (fixed(five(&PAPER.standard_errors)[k], PRINTED_DIGITS)) ")"
            }
            ". "
            @let ratios = std::array::from_fn::<f64, 5, _>(|k| five(&PAPER.standard_errors)[k] / scaled[k]);
            "The printed ones are " (significant(ratios.into_iter().fold(f64::INFINITY, f64::min))) " to " (significant(ratios.into_iter().fold(0.0, f64::max)))
            " times these: σ₀ and number do not explain that, and the paper gives neither its base nor where its points lie."
        }
    }
}

/// The largest true error in standard errors, and of which strategy and unknown.
fn worst_ratio(report: &Report) -> Option<(String, f64)> {
    let ratios = report.studies.iter().flat_map(|study| {
        let standard = study.result.orientation.as_ref().ok().and_then(|o| o.total_standard_errors.or(o.standard_errors)).map(|e| five(&e));
        let pairs = study.errors.zip(standard).into_iter();
        pairs.flat_map(move |(e, s)| (0..5).map(move |k| (format!("{}, {}", UNKNOWNS[k].0, study.name), (e[k] / s[k]).abs())))
    });
    ratios.filter(|(_, ratio)| ratio.is_finite()).max_by(|a, b| a.1.total_cmp(&b.1))
}
