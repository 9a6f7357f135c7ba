//! Verdicts as one page of HTML that needs nothing else.
//!
//! Owns the page. It judges nothing; figures come drawn.

use super::claim::{CONTROL_FACTOR, Topic, Verdict};
use super::report::Report;
use std::fmt::Write;

/// A figure that shows what a claim says.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// The claim.
    pub claim: String,
    /// Where the claim is from, if others may have the same words.
    pub source: Option<String>,
    /// The figure as SVG.
    pub svg: String,
}

impl Shown {
    fn is_of(&self, verdict: &Verdict) -> bool {
        self.claim == verdict.claim && self.source.as_ref().is_none_or(|source| *source == verdict.source)
    }
}

/// Width of the strip of a claim's numbers, units.
const STRIP: f64 = 420.0;
/// Room at both ends of the strip, units.
const MARGIN: f64 = 14.0;

impl Report {
    /// The report as HTML: a summary, a table by topic, every claim with its numbers on a logarithmic strip, its
    /// source, the reason of its bound and its figure where it has one.
    pub fn to_html(&self, figures: &[Shown]) -> String {
        let mut page = String::from(HEAD);
        let held = self.claims.iter().filter(|verdict| verdict.holds).count();
        let (class, word) = if self.holds { ("holds", "holds") } else { ("fails", "FAILS") };
        let _ = write!(
            page,
            "<header><h1>tissue {}: what is claimed, and what was measured</h1>\
             <p class=\"verdict {class}\"><b>{word}</b>: {held} of {} claims hold.</p>\
             <p>A claim holds where its measured error is within its bound and a variant made wrong on purpose, the \
             control, misses the bound at least tenfold. Each bound has its reason. Lines of <code>expect</code> are \
             claims of the files they stand in.</p>\
             <p>On each strip the dot is the measured error, the tick the bound and the cross the control; grey begins at \
             ten bounds. Where a claim is about an order, its error is what the order falls short by; the order itself \
             is in the figure.</p></header>",
            escaped(&self.version),
            self.claims.len()
        );
        self.summary(&mut page);
        for topic in Topic::ALL {
            let claims: Vec<&Verdict> = self.claims.iter().filter(|verdict| verdict.topic == topic).collect();
            if claims.is_empty() {
                continue;
            }
            let _ = write!(page, "<section id=\"{topic}\"><h2>{topic}</h2>");
            for verdict in claims {
                card(&mut page, verdict, figures);
            }
            page.push_str("</section>");
        }
        page.push_str("</main></body></html>\n");
        page
    }

    /// Topics with their counts, and the claims that fail by name.
    fn summary(&self, page: &mut String) {
        page.push_str(
            "<nav><table><thead><tr><th>topic</th><th>claims</th><th>hold</th></tr></thead><tbody>",
        );
        for topic in Topic::ALL {
            let of: Vec<&Verdict> = self.claims.iter().filter(|verdict| verdict.topic == topic).collect();
            if of.is_empty() {
                continue;
            }
            let held = of.iter().filter(|verdict| verdict.holds).count();
            let class = if held == of.len() { "" } else { " class=\"fails\"" };
            let _ = write!(
                page,
                "<tr{class}><td><a href=\"#{topic}\">{topic}</a></td><td>{}</td><td>{held}</td></tr>",
                of.len()
            );
        }
        page.push_str("</tbody></table>");
        let failed: Vec<&Verdict> = self.claims.iter().filter(|verdict| !verdict.holds).collect();
        if !failed.is_empty() {
            page.push_str("<h2>What fails</h2><ul class=\"fails\">");
            for verdict in failed {
                let fault = verdict.fault().map_or_else(String::new, |fault| format!(": {fault}"));
                let _ = write!(page, "<li>{}{}</li>", escaped(&verdict.claim), escaped(&fault));
            }
            page.push_str("</ul>");
        }
        page.push_str("</nav><main>");
    }
}

fn card(page: &mut String, verdict: &Verdict, figures: &[Shown]) {
    let (class, word) = if verdict.holds { ("holds", "holds") } else { ("fails", "FAILS") };
    let Verdict { claim, source, because, measured, bound, control, cause, .. } = verdict;
    let _ = write!(
        page,
        "<article class=\"{class}\"><div><h3><span class=\"mark\">{word}</span> {}</h3>{}\
         <dl><dt>measured</dt><dd>{measured:.3e}</dd><dt>bound</dt><dd>{bound:.3e}</dd>\
         <dt>control</dt><dd>{control:.3e}</dd></dl>\
         <p><b>source</b> {}</p><p><b>bound because</b> {}</p>",
        escaped(claim),
        strip(verdict),
        escaped(source),
        escaped(because)
    );
    if let Some(cause) = cause {
        let _ = write!(page, "<p><b>cause</b> {}</p>", escaped(cause));
    }
    page.push_str("</div>");
    let mut drawn = figures.iter().filter(|shown| shown.is_of(verdict)).peekable();
    if drawn.peek().is_some() {
        page.push_str("<div>");
        for shown in drawn {
            let _ = write!(page, "<figure>{}</figure>", shown.svg);
        }
        page.push_str("</div>");
    }
    page.push_str("</article>");
}

/// Measured error, bound and control on one logarithmic axis; nothing where there is no number to place.
fn strip(verdict: &Verdict) -> String {
    let Verdict { measured, bound, control, .. } = *verdict;
    let positive = [measured, bound, control].into_iter().filter(|value| *value > 0.0 && value.is_finite());
    let (low, high) =
        positive.fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    if !(bound > 0.0 && bound.is_finite()) || low >= high {
        return String::new();
    }
    let (low, high) =
        (libm::floor(libm::log10(low)), libm::ceil(libm::log10(high)).max(libm::log10(bound) + 1.5));
    let at = |value: f64| {
        let part = if value > 0.0 { (libm::log10(value) - low) / (high - low) } else { 0.0 };
        MARGIN + (STRIP - 2.0 * MARGIN) * part.clamp(0.0, 1.0)
    };
    let mut svg = format!(
        "<svg class=\"strip\" viewBox=\"0 0 {STRIP} 54\" role=\"img\" aria-label=\"measured {measured:.1e}, bound \
         {bound:.1e}, control {control:.1e}\">"
    );
    let (end, tenfold) = (at(bound), at(CONTROL_FACTOR * bound));
    let (start, last) = (MARGIN, STRIP - MARGIN);
    let _ = write!(
        svg,
        "<rect x=\"{start:.1}\" y=\"20\" width=\"{:.1}\" height=\"10\" class=\"within\"/>\
         <rect x=\"{tenfold:.1}\" y=\"20\" width=\"{:.1}\" height=\"10\" class=\"beyond\"/>\
         <line x1=\"{start:.1}\" y1=\"30\" x2=\"{last:.1}\" y2=\"30\" class=\"axis\"/>",
        end - start,
        (last - tenfold).max(0.0)
    );
    let step = libm::ceil((high - low) / 8.0).max(1.0);
    let mut power = low;
    while power <= high + 1e-9 {
        let x = MARGIN + (STRIP - 2.0 * MARGIN) * (power - low) / (high - low);
        let _ = write!(
            svg,
            "<line x1=\"{x:.1}\" y1=\"30\" x2=\"{x:.1}\" y2=\"34\" class=\"axis\"/>\
             <text x=\"{x:.1}\" y=\"47\">1e{power}</text>"
        );
        power += step;
    }
    let (m, c) = (at(measured), at(control));
    let _ = write!(
        svg,
        "<line x1=\"{end:.1}\" y1=\"14\" x2=\"{end:.1}\" y2=\"30\" class=\"bound\"/><text x=\"{end:.1}\" y=\"11\">bound</text>\
         <circle cx=\"{m:.1}\" cy=\"25\" r=\"5\" class=\"measured\"/>"
    );
    if control.is_finite() {
        let _ = write!(
            svg,
            "<path d=\"M{:.1} 20 L{:.1} 30 M{:.1} 30 L{:.1} 20\" class=\"control\"/>",
            c - 5.0,
            c + 5.0,
            c - 5.0,
            c + 5.0
        );
    }
    svg.push_str("</svg>");
    svg
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

const HEAD: &str = "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">\
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>tissue: claims and verdicts</title><style>
body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fff; max-width: 76rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.5rem; line-height: 1.25; } h2 { font-size: 1.2rem; border-bottom: 1px solid #ccc; margin-top: 2.2rem; }
h3 { font-size: 1rem; margin: 0 0 .4rem; }
article { border: 1px solid #ddd; border-left: 5px solid #0072b2; padding: .8rem 1rem; margin: .9rem 0; display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 28rem); gap: 0 1.5rem; }
@media (max-width: 52rem) { article { display: block; } }
article.fails { border-left-color: #d55e00; background: #fff6ef; }
.mark { font-size: .8rem; padding: .1rem .45rem; border-radius: .25rem; background: #e3f0f8; color: #00507d; }
.fails .mark, li, .verdict.fails b { color: #a33f00; } .fails .mark { background: #fde6d8; }
dl { display: grid; grid-template-columns: repeat(3, max-content 1fr); gap: 0 .6rem; margin: .4rem 0; }
dt { color: #555; } dd { margin: 0; font-variant-numeric: tabular-nums; }
p { margin: .3rem 0; } p b { font-weight: 600; color: #555; margin-right: .3rem; } .verdict b { margin: 0; color: #00507d; }
table { border-collapse: collapse; } th, td { text-align: left; padding: .2rem 1rem .2rem 0; } tr.fails td { color: #a33f00; font-weight: 600; }
.strip { width: 100%; max-width: 34rem; display: block; } .strip text { font: 10px system-ui, sans-serif; text-anchor: middle; fill: #555; }
.within { fill: #cfe6f3; } .beyond { fill: #eee; } .axis { stroke: #777; stroke-width: 1; } .bound { stroke: #222; stroke-width: 1.5; }
.measured { fill: #0072b2; } .fails .measured { fill: #d55e00; } .control { stroke: #222; stroke-width: 1.8; fill: none; }
figure { margin: 0; } figure svg { width: 100%; max-width: 34rem; height: auto; }
@media print { body { font-size: 12px; padding: 0; max-width: none; } article { break-inside: avoid; display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 19rem); } h2 { break-after: avoid; } }
</style></head><body>";

#[cfg(test)]
mod tests {
    use super::super::claim::Claim;
    use super::*;

    fn report() -> Report {
        let claim = Claim {
            topic: Topic::Energies,
            claim: "stress < derivative & nothing else",
            source: "a book",
            because: "ten round-offs",
            bound: 1e-14,
            measure: || 2e-16,
            control: || 1e-3,
        };
        let broken = Claim { claim: "a broken one", measure: || 1.0, ..claim };
        let stopped = Claim { claim: "one that stops", measure: || panic!("J <= 0"), ..claim };
        Report { version: "0.1.0".into(), ..Report::of(&[claim, stopped, broken]) }
    }

    #[test]
    fn the_page_shows_every_claim_with_its_numbers_and_names_what_fails() {
        let figure =
            Shown { claim: "a broken one".into(), source: None, svg: "<svg id=\"shown\"></svg>".into() };
        let page = report().to_html(&[figure]);
        insta::assert_snapshot!("page", page);
        assert!(page.contains("1 of 3 claims hold") && page.contains("<li>a broken one: the measured error"));
        assert!(page.contains("<li>one that stops: it could not be measured: J &lt;= 0</li>"));
        assert!(page.contains("stress &lt; derivative &amp; nothing else"));
        // the figure stands in the card of its claim, the last
        let (before, after) = page.split_once("<svg id=\"shown\">").expect("the figure is on the page");
        assert!(before.ends_with("<figure>") && after.starts_with("</svg></figure></div></article>"));
    }

    #[test]
    fn a_figure_of_one_source_is_not_shown_beside_the_same_words_from_another() {
        let of = |source: &str| Shown {
            claim: "a broken one".into(),
            source: Some(source.into()),
            svg: "<svg id=\"shown\"></svg>".into(),
        };
        assert!(report().to_html(&[of("a book")]).contains("id=\"shown\""));
        assert!(!report().to_html(&[of("another book")]).contains("id=\"shown\""));
    }

    #[test]
    fn the_page_needs_nothing_from_elsewhere() {
        let page = report().to_html(&[]);
        for outside in ["http", "<script", "src=", "url(", "@import"] {
            assert!(!page.contains(outside), "{outside}");
        }
    }
}
