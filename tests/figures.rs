//! Figures: the quick tier of every one as recorded, and the committed ones as their tables say.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tissue::output::Table;
use tissue::run::{draw_figure, table_names};
use tissue::scene::{FigureOf, FileSystem, resolve};
use tissue::syntax::Source;

/// Every figure of the project, by number.
fn figures() -> Vec<FigureOf> {
    let entries = fs::read_dir("specs/figures").expect("the folder is in the repository");
    let mut figures = Vec::new();
    for path in entries.flatten().map(|entry| entry.path()) {
        if path.extension().is_none_or(|ending| ending != "tissue") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a file of figures is text");
        let (document, mistakes) =
            resolve(&Source { name: path.display().to_string(), text }, &FileSystem, &[]);
        assert!(mistakes.is_empty(), "{}", mistakes[0].render());
        figures.extend(document.figures);
    }
    figures.sort_by_key(|figure| figure.number);
    figures
}

fn stem(figure: &FigureOf) -> String {
    format!("{:02}_{}", figure.number, figure.name)
}

fn tables(folder: &Path, figure: &FigureOf) -> Vec<Table> {
    let read = |name: &String| {
        let path = folder.join("tables").join(format!("{}_{name}.csv", stem(figure)));
        let text = fs::read_to_string(&path).unwrap_or_else(|cause| panic!("{}: {cause}", path.display()));
        Table::parse(name, &text).expect("a table of our own")
    };
    table_names(figure).iter().map(read).collect()
}

/// The text without the hash of the input, which any comment in it changes.
fn without_hash(text: &str) -> String {
    let line = |line: &str| if line.starts_with("blake3 ") { "blake3 …".into() } else { line.to_string() };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// Size and spread of every column, to five significant digits: half a unit of the fifth is the tolerance.
fn digest(table: &Table) -> String {
    let mut text = format!("{}: {} rows\n", table.name, table.rows.len());
    for (i, column) in table.columns.iter().enumerate() {
        let values = || table.rows.iter().map(|row| row[i]);
        let (least, most) =
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let mean = values().sum::<f64>() / table.rows.len() as f64;
        let square = values().map(|value| value * value).sum::<f64>() / table.rows.len() as f64;
        text.push_str(&format!(
            "  {}: from {least:.4e} to {most:.4e}, mean {mean:.4e}, root mean square {:.4e}\n",
            column.name,
            square.sqrt()
        ));
    }
    text
}

/// One run of the tool for all, as a user would call it; the data to five digits, the drawing byte for byte.
#[test]
fn the_quick_tier_of_every_figure_is_drawn_as_recorded() {
    let home = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("figures");
    let _ = fs::remove_dir_all(&home);
    let (out, runs) = (home.join("figures"), home.join("runs"));
    let make = |more: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_tissue"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .args(["figures", "--quick", "--out"])
            .args([&out, Path::new("--runs"), &runs])
            .args(more)
            .output()
            .expect("the tool starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    make(&["--quiet"]);
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots/figures");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for figure in figures() {
            let name = stem(&figure);
            let digests: Vec<String> = tables(&out, &figure).iter().map(digest).collect();
            insta::assert_snapshot!(format!("{name}_data"), digests.join("\n"));
            let svg = fs::read_to_string(out.join(format!("{name}.svg"))).expect("the figure is drawn");
            insta::assert_snapshot!(format!("{name}_drawing"), without_hash(&svg));
        }
    });
    // nothing is run again: no line tells of particles
    let again = make(&["--only", "1"]);
    assert!(again.contains("figure 1") && !again.contains("particles"), "{again}");
    // but a run that has lost a table, which figure 1 does not read
    let run = fs::read_dir(&runs).expect("the runs").flatten().map(|entry| entry.path());
    let punch = run
        .filter(|path| path.join("probes.csv").is_file())
        .find(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("jump-plain")));
    fs::remove_file(punch.expect("a run of the punch").join("probes.csv")).expect("it is there");
    let mended = make(&["--only", "1"]);
    assert!(mended.contains("particles"), "{mended}");
}

#[test]
fn every_committed_figure_is_drawn_again_from_its_tables_to_the_last_byte() {
    let mut differing = Vec::new();
    for figure in figures() {
        let kept = tables(Path::new("figures"), &figure);
        let drawn = draw_figure(&figure, &kept).expect("drawn from its tables");
        let committed = fs::read_to_string(format!("figures/{}.svg", stem(&figure)));
        if committed.ok() != Some(drawn) {
            differing.push(stem(&figure));
        }
    }
    assert!(differing.is_empty(), "these are not what their tables say: {}", differing.join(", "));
}

/// Letters are 16 px and more, so a page of 640 px has them at 6 pt when it is printed 85 mm wide.
#[test]
fn every_figure_is_legible_at_the_width_of_a_column() {
    for figure in figures() {
        let name = format!("figures/{}.svg", stem(&figure));
        let text = fs::read_to_string(&name).expect("a committed figure");
        let width =
            text.split("width=\"").nth(1).and_then(|rest| rest.split('"').next()?.parse::<u32>().ok());
        assert!(width.is_some_and(|width| width <= 640), "{name} is {width:?} px wide");
    }
}

#[test]
fn another_number_in_a_table_is_another_figure() {
    let figures = figures();
    let figure = figures.first().expect("there are figures");
    let kept = tables(Path::new("figures"), figure);
    let mut other = kept.clone();
    let row = other[0].rows.len() / 2;
    other[0].rows[row][1] += 0.05;
    assert_ne!(draw_figure(figure, &kept), draw_figure(figure, &other));
    other[0].rows[row].pop();
    assert!(draw_figure(figure, &other).is_err(), "a row that is not complete is refused");
    let mut other = kept.clone();
    other[0].rows[row][0] = 99.0;
    let refused = draw_figure(figure, &other).expect_err("a row of an outline that is not there");
    assert!(refused.contains("a row of number 99"), "{refused}");
    let mut other = kept.clone();
    other[0].columns[1].text.clear();
    let refused = draw_figure(figure, &other).expect_err("a column whose unit is not known");
    assert!(refused.contains("no line `# column x"), "{refused}");
}

/// A figure of one plot has no title drawn above it, for a journal sets its caption; the file has it all the same.
#[test]
fn every_committed_figure_says_what_it_shows() {
    for figure in figures() {
        let text = fs::read_to_string(format!("figures/{}.svg", stem(&figure))).expect("a committed figure");
        let title = text.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
        let unescaped = title.map(|(title, _)| title.replace("&lt;", "<").replace("&amp;", "&"));
        assert_eq!(unescaped.as_deref(), Some(figure.title.as_str()));
    }
}

#[test]
fn no_two_figures_have_one_number() {
    let numbers: Vec<u32> = figures().iter().map(|figure| figure.number).collect();
    assert!(numbers.windows(2).all(|pair| pair[0] < pair[1]), "{numbers:?}");
}
