//! The paper's Tables 1, 2 and 3 for all strategies, beside what it printed.

use super::input::ReportTruth;
use super::paper::PAPER;
use super::step::ReportStep;
use super::steps::Report;
use super::study::Study;
use super::unknowns::{PRINTED_DIGITS, UNKNOWNS, five};
use crate::html::{count, fixed, in_unit, percent, said, significant};
use crate::{FiveParameters, MatchScore, Rule, Texts};
use maud::{Markup, html};

/// Table 1: how many points each phase left.
pub fn counts(texts: &Texts, report: &Report) -> Markup {
    let first = &report.studies[0].result;
    let phases = [
        ("report-operator", first.left.counts.candidates, first.right.counts.candidates, Some(PAPER.points[0])),
        ("report-roundness", first.left.counts.after_roundness, first.right.counts.after_roundness, None),
        ("report-suppression", first.left.counts.after_suppression, first.right.counts.after_suppression, Some(PAPER.points[1])),
    ];
    html! {
        table tabindex="0" {
            caption { (texts.say("report-table-1")) }
            thead {
                tr {
                    @for name in ["report-phase", "report-left", "report-right"] { th { (texts.say(name)) } }
                    @for name in ["report-paper-left", "report-paper-right"] { th.paper { (texts.say(name)) } }
                }
            }
            tbody {
                @for (name, left, right, printed) in phases {
                    tr { th { (texts.say(name)) } td { (count(left)) } td { (count(right)) } (paper_counts(printed)) }
                }
                @for study in &report.studies {
                    @let matches = study.result.matching.counts.matches;
                    @let printed = (study.step == ReportStep::Moments).then_some(PAPER.points[2]);
                    @let name = texts.with("report-matching-by", [("step", said(texts, &study.step))]);
                    tr { th { (name) } td { (count(matches)) } td { (count(matches)) } (paper_counts(printed)) }
                }
            }
        }
    }
}

fn paper_counts(printed: Option<[usize; 2]>) -> Markup {
    html! { @for side in 0..2 { td.paper { (printed.map_or_else(|| "–".into(), |counts| count(counts[side]))) } } }
}

/// What became of the left points, by rule.
pub fn refusals(texts: &Texts, report: &Report) -> Markup {
    let number = |study: &Study, rule: Rule| study.result.matching.verdicts.iter().filter(|v| v.rule == rule).count();
    let name = |rule: Rule| match texts.label(&rule) {
        label if rule == Rule::Matched => label,
        label => texts.with("report-rejected-by", [("rule", label)]),
    };
    let applied = Rule::ALL.into_iter().filter(|rule| report.studies.iter().any(|study| number(study, *rule) > 0));
    html! {
        table tabindex="0" {
            caption { (texts.say("report-became")) }
            (head(texts, &report.studies, false))
            tbody {
                @for rule in applied {
                    tr { th { (name(rule)) } @for study in &report.studies { td { (count(number(study, rule))) } } }
                    @if let (Rule::Matched, Some(edits)) = (rule, &report.edits) {
                        (of_this_run(report, &texts.say("report-rejected-by-hand"), edits.rejected))
                        (of_this_run(report, &texts.say("report-measured-by-hand"), edits.measured))
                    }
                }
                tr {
                    th { (texts.say("report-matched-gross-errors")) }
                    @for study in &report.studies { td { (study.used().map_or_else(|| "–".into(), |used| count(study.result.matching.matches.len() - used))) } }
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
pub fn scores(texts: &Texts, report: &Report) -> Markup {
    let rows: [(&str, Counted); 3] =
        [("report-right-at-edges", |s| s.right), ("report-strictly-right", |s| s.strict), ("report-missed", |s| s.missed)];
    html! {
        table tabindex="0" {
            caption { (texts.say("report-against-truth")) }
            (head(texts, &report.studies, false))
            tbody {
                @for (k, (name, of)) in rows.into_iter().enumerate() {
                    tr {
                        th { (texts.say(name)) }
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
        p.note { (texts.say("report-strictly-right-is")) }
    }
}

/// Table 2: standard errors.
pub fn standard_errors(texts: &Texts, report: &Report) -> Markup {
    let with_interior = report.studies.iter().any(|s| s.result.orientation.as_ref().is_ok_and(|o| o.total_standard_errors.is_some()));
    let own = |study: &Study| study.result.orientation.as_ref().ok().and_then(|o| o.standard_errors).map(|e| five(&e));
    let total = |study: &Study| study.result.orientation.as_ref().ok().and_then(|o| o.total_standard_errors).map(|e| five(&e));
    let half_widths = |study: &Study| study.result.orientation.as_ref().ok().and_then(|o| o.half_widths_95).map(|e| five(&e));
    html! {
        table tabindex="0" {
            caption { (texts.say("report-table-2")) }
            (head(texts, &report.studies, true))
            tbody {
                (parameter_rows(texts, &report.studies, own, Some(&PAPER.standard_errors)))
                tr {
                    th { (in_unit(texts, "σ₀", "px")) }
                    @for study in &report.studies { td { (fixed(study.sigma0_px(), 3)) } }
                    td.paper { (fixed(PAPER.sigma0_mm / PAPER.pixel_mm, 1)) }
                }
                tr {
                    th { (in_unit(texts, &texts.say("report-sigma-of-all"), "px")) }
                    @for study in &report.studies { td { (fixed(study.sigma0_of_all_px(), 3)) } }
                    td.paper {}
                }
                tr { th { (texts.say("report-used")) } @for study in &report.studies { td { (used(texts, study)) } } td.paper { (count(PAPER.points[2][0])) } }
            }
            @if with_interior {
                tbody {
                    tr.subhead { th colspan=(report.studies.len() + 2) { (texts.say("report-in-total")) } }
                    (parameter_rows(texts, &report.studies, total, None))
                }
            }
            tbody {
                tr.subhead { th colspan=(report.studies.len() + 2) { (texts.say("report-half-widths")) } }
                (parameter_rows(texts, &report.studies, half_widths, None))
            }
        }
        p.note { (texts.say("report-sigma-of-all-is")) }
    }
}

/// How many matches an orientation used; what the strategy came to, where there is none.
fn used(texts: &Texts, study: &Study) -> String {
    study.used().map_or_else(|| texts.label(&study.result.verdict()), count)
}

/// Table 3: the orientation by each strategy, with the truth where it is known.
pub fn orientations(texts: &Texts, report: &Report) -> Markup {
    let value = |study: &Study| study.result.orientation.as_ref().ok().map(|o| five(&o.parameters));
    // The truth is compared with the most precise of them.
    let finest = |k: usize| report.studies.iter().map(|study| study.digits(k)).max().unwrap_or(PRINTED_DIGITS);
    html! {
        table tabindex="0" {
            caption { (texts.say("report-table-3")) }
            thead {
                tr {
                    th { (texts.say("report-unknown")) }
                    @for study in &report.studies { th { (said(texts, &study.step)) } }
                    @if report.truth.is_some() { th.truth { (texts.say("report-truth")) } }
                    @for printed in &PAPER.orientations {
                        th.paper { (texts.with("report-paper-by", [("way", texts.say(&format!("report-paper-{}", printed.name)))])) }
                    }
                }
            }
            tbody {
                tr {
                    th { (texts.say("report-verdict")) }
                    @for study in &report.studies { td { (texts.label(&study.result.verdict())) } }
                    @if report.truth.is_some() { td.truth {} }
                    @for _ in &PAPER.orientations { td.paper {} }
                }
                tr {
                    th { i { "b" } " " small { (texts.with("report-fixed", [("unit", texts.unit("mm"))])) } }
                    @for study in &report.studies { td { (significant(study.result.orientation.as_ref().ok().map(|o| o.base_mm))) } }
                    @if let Some(truth) = &report.truth { td.truth { (significant(truth.base_mm)) } }
                    @for _ in &PAPER.orientations { td.paper { "–" } }
                }
                @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
                    tr {
                        th { i { (symbol) } " " small { (texts.unit(unit)) } }
                        @for study in &report.studies { td { (fixed(value(study).map(|v| v[k]), study.digits(k))) } }
                        @if let Some(truth) = &report.truth { td.truth { (fixed(five(&truth.orientation)[k], finest(k))) } }
                        @for printed in &PAPER.orientations { td.paper { (fixed(five(&printed.values)[k], PRINTED_DIGITS)) } }
                    }
                }
            }
            @if report.truth.is_some() {
                tbody {
                    tr.subhead { th colspan=(report.studies.len() + 5) { (texts.say("report-true-errors")) } }
                    @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
                        tr { th { i { (symbol) } " " small { (texts.unit(unit)) } } @for study in &report.studies { (true_error(study, k)) } }
                    }
                }
            }
        }
        @if let Some(truth) = report.truth.as_ref().filter(|truth| has_other_base(report, truth)) {
            p.note { (texts.with("report-other-base", [("base", fixed(truth.base_mm, 3))])) }
        }
        p.note { (texts.say("report-paper-columns")) }
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

fn head(texts: &Texts, studies: &[Study], with_paper: bool) -> Markup {
    html! {
        thead { tr { td {} @for study in studies { th { (said(texts, &study.step)) } } @if with_paper { th.paper { (texts.say("report-paper")) } } } }
    }
}

fn parameter_rows(texts: &Texts, studies: &[Study], of: impl Fn(&Study) -> Option<[f64; 5]>, paper: Option<&FiveParameters>) -> Markup {
    html! {
        @for (k, (symbol, unit)) in UNKNOWNS.into_iter().enumerate() {
            tr {
                th { i { (symbol) } " " small { (texts.unit(unit)) } }
                @for study in studies { td { (fixed(of(study).map(|e| e[k]), study.digits(k))) } }
                @if let Some(paper) = paper { td.paper { (fixed(five(paper)[k], PRINTED_DIGITS)) } }
            }
        }
    }
}
