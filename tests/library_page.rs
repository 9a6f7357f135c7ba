//! The page of the standard library, written from its files, and its figure, drawn from their drives.

use std::fmt::Write;
use tissue::output::{Axis, Figure, Mark, Provenance, Scale, Series};
use tissue::run::{DriveJob, drive};
use tissue::scene::{Document, Drive, LibraryFile, Memory, library, resolve};
use tissue::syntax::Source;

const PAGE: &str = "docs/library.md";
const FIGURE: &str = "docs/library.svg";

fn files(name: &str) -> impl Iterator<Item = &'static LibraryFile> {
    library().iter().filter(move |file| file.library == name)
}

/// The comment above the first block, its line breaks kept, and the block itself.
fn parts(file: &LibraryFile, kind: &str) -> (String, String) {
    let start = file.text.find(&format!("\n{kind} ")).expect("the file declares what it is named after") + 1;
    let comment: Vec<&str> = file.text[..start].lines().filter_map(|line| line.strip_prefix("# ")).collect();
    let block = &file.text[start..];
    let end = block.find("\n}").map_or(block.len(), |end| end + 2);
    (comment.join("\n"), block[..end].to_string())
}

fn document(file: &LibraryFile, set: &[(String, String)]) -> Option<Document> {
    let source = Source { name: file.name.into(), text: file.text.into() };
    let (document, mistakes) = resolve(&source, &Memory::default(), set);
    mistakes.is_empty().then_some(document)
}

fn page() -> String {
    let mut page = String::from(
        "# The standard library\n\nWritten from the files under `specs/energies` and `specs/materials`. Every material is \
         driven in incompressible tension\nand held to a value of another program, to 1e-7 (`tissue verify benchmarks`);\nits comment says whether its constants were read at their source. Take one with \
         `import std.materials { carotid_media }`, a law with `import std.energies { hgo }`.\n\n\
         ![First Piola-Kirchhoff stress over stretch of every material](library.svg)\n\n\
         Each curve ends at the greatest of a few stretches at which the law still has an equilibrium and the stress\n\
         is below twenty times its golden value.\n\n## Energies\n",
    );
    for file in files("energies") {
        let (comment, block) = parts(file, "energy");
        let users: Vec<&str> = files("materials")
            .filter(|material| material.text.contains(&format!("{}(", file.name)))
            .filter(|_| !file.name.starts_with("vol_"))
            .map(|material| material.name)
            .collect();
        let _ = write!(page, "\n### {}\n\n{comment}\n\n```tissue\n{block}\n```\n", file.name);
        if !users.is_empty() {
            let users: Vec<String> = users.iter().map(|user| format!("[`{user}`](#{user})")).collect();
            let _ = write!(page, "\nMaterials: {}.\n", users.join(", "));
        }
    }
    page.push_str("\n## Materials\n");
    for file in files("materials") {
        let (comment, block) = parts(file, "material");
        let _ = write!(page, "\n### {}\n\n{comment}\n\n```tissue\n{block}\n```\n", file.name);
        let expected = file.text.lines().filter_map(|line| line.trim().strip_prefix("expect "));
        let expected: Vec<String> = expected.map(|line| format!("- `{line}`")).collect();
        let _ = write!(page, "\nHeld:\n\n{}\n", expected.join("\n"));
    }
    page
}

/// The first drive of a material led as far as it goes.
fn curve(file: &LibraryFile) -> Vec<(f64, f64)> {
    let own = document(file, &[]).expect("the library has no mistakes");
    let first = &own.drives[0];
    let golden = last(&points(first).expect("its own drive ends")).1.abs();
    let (word, _) = first.written.split_once("stretch = 1 ..").expect("a tension");
    let ends: &[f64] =
        if first.range.1 < 1.0 { &[0.5, 0.7, 0.8, 0.9] } else { &[4.0, 2.0, 1.5, 1.3, 1.2, 1.1, 1.05] };
    let led = ends.iter().find_map(|end| {
        let path = format!("{word}stretch = 1 .. {end}, steps = 60)");
        let further = document(file, &[(format!("{}.path", first.name), path)])?;
        points(&further.drives[0]).filter(|points| last(points).1.abs() <= 20.0 * golden)
    });
    led.expect("the golden stretch is among the ends")
}

fn last(points: &[(f64, f64)]) -> (f64, f64) {
    *points.last().expect("a path has points")
}

fn points(described: &Drive) -> Option<Vec<(f64, f64)>> {
    let provenance = Provenance::new("library", "", &described.name);
    let outcome = drive(&DriveJob { drive: described, provenance, folder: None }).ok()?;
    let position = outcome.tables[0].position("P").expect("a column of the library's drives");
    let rows = outcome.tables[0].rows.iter();
    outcome.failure.is_none().then(|| rows.map(|row| (row[0], row[position])).collect())
}

const COLUMNS: usize = 4;
const WIDTH: usize = 320;
const HEIGHT: usize = 240;

fn figure() -> String {
    let panels: Vec<String> = files("materials").map(|file| panel(file.name, curve(file))).collect();
    let (width, height) = (COLUMNS * WIDTH, panels.len().div_ceil(COLUMNS) * HEIGHT);
    let mut text =
        format!("<svg width=\"{width}\" height=\"{height}\" xmlns=\"http://www.w3.org/2000/svg\">\n");
    for (index, panel) in panels.iter().enumerate() {
        let (x, y) = (index % COLUMNS * WIDTH, index / COLUMNS * HEIGHT);
        let size = format!("<svg x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{HEIGHT}\"");
        let (_, drawing) = panel.split_once(" viewBox").expect("a drawing has a frame");
        let _ = writeln!(text, "{size} viewBox{}", drawing.trim_end());
    }
    text.push_str("</svg>\n");
    text
}

fn panel(name: &str, points: Vec<(f64, f64)>) -> String {
    let figure = Figure {
        title: name.replace('_', " "),
        x: Axis { label: "stretch".into(), unit: String::new(), scale: Scale::Linear, range: None },
        y: Axis { label: "P".into(), unit: "Pa".into(), scale: Scale::Linear, range: None },
        series: vec![Series { label: String::new(), points, mark: Mark::Line, colour: None }],
        ..Figure::default()
    };
    figure.to_svg().expect("the curve can be drawn")
}

/// Run with `UPDATE_LIBRARY=1` to write page and figure anew.
#[test]
fn page_and_figure_are_those_of_the_files() {
    for (path, written) in [(PAGE, page()), (FIGURE, figure())] {
        if std::env::var_os("UPDATE_LIBRARY").is_some() {
            std::fs::write(path, &written).expect("the file can be written");
        }
        let kept = std::fs::read_to_string(path).expect("it is in the repository");
        assert!(kept == written, "{path} is not what the library gives: write it with UPDATE_LIBRARY=1");
    }
}
