//! Known parameters found again from data with known noise.
//!
//! The data are those of the laws themselves with a noise added whose generator is a few lines of
//! integers, so the true parameters are known and the standard errors can be held to their meaning.

use super::super::energies::laws::Random;
use super::Claim;
use crate::output::{FitReport, Provenance};
use crate::run::{DriveJob, FitJob, drive, fit};
use crate::scene::{Document, Memory, resolve};
use crate::syntax::Source;
use crate::verify::claim::Topic;
use nalgebra::DMatrix;

/// A problem with a closed form.
pub(crate) const LINE: Claim = Claim {
    topic: Topic::Energies,
    claim: "the modulus of a neo-Hookean bar and its standard error are those of linear regression",
    source: "P = mu (l - 1/l^2): mu = sum(f y)/sum(f f), error^2 = sum(r r)/(n - 1)/sum(f f)",
    because: "data written with 17 digits, stresses good to 1e-13, sums of twelve terms; the residuals, 5 % of \
              the data, have lost a digit and a half",
    bound: 1e-11,
    measure: || line(1.0),
    control: || line(1.000_001),
};

/// Relative difference of modulus and error to linear regression, the moduli's factor off by `factor`.
fn line(factor: f64) -> f64 {
    let text = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel { energy = neo_hooke(mu = 10 kPa) + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }
drive pull { material = gel  volume = incompressible  path = uniaxial(x, stretch = 1 .. 2, steps = 10) }
fit f {
  drive = pull
  data = csv(\"data.csv\", stretch = \"stretch\", P.xx = \"P_Pa\")
  vary = [gel.mu]
  weights = uniform
}";
    let mut random = Random(11);
    let data: Vec<(f64, f64)> = (0..12)
        .map(|i| 1.05 + 0.08 * f64::from(i))
        .map(|l| (l, 7e3 * (l - 1.0 / (l * l)) * (1.0 + random.around_zero(0.05))))
        .collect();
    let Some(report) =
        fitted(text, &[table(&["P_Pa"], &data.iter().map(|&(l, y)| (l, vec![y])).collect::<Vec<_>>())])
    else {
        return f64::INFINITY;
    };
    let f = |l: f64| factor * (l - 1.0 / (l * l));
    let ff: f64 = data.iter().map(|&(l, _)| f(l) * f(l)).sum();
    let mu = data.iter().map(|&(l, y)| f(l) * y).sum::<f64>() / ff;
    let rr: f64 = data.iter().map(|&(l, y)| (mu * f(l) - y) * (mu * f(l) - y)).sum();
    let error = (rr / 11.0 / ff).sqrt();
    let found = &report.parameters[0];
    let of_error = found.standard_error.map_or(f64::INFINITY, |found| (found / error - 1.0).abs());
    (found.value / mu - 1.0).abs().max(of_error)
}

/// A law whose parameters are to be found again.
struct Known {
    /// Material, with `{…}` for the parameters, and the drives; up to the fit.
    text: &'static str,
    /// True values as written, and where the fit starts.
    parameters: &'static [(&'static str, &'static str, &'static str)],
    /// Drives with their abscissae from and to, and what is measured.
    drives: &'static [(&'static str, f64, f64, &'static [&'static str])],
}

const LAWS: [Known; 3] = [
    Known {
        text: "tissue 1
import std.energies { yeoh, vol_quadratic }
material m { energy = yeoh(C10 = {C10}, C20 = {C20}, C30 = {C30}) + vol_quadratic(K = 1 GPa)  density = 1000 kg/m^3 }
drive pull { material = m  volume = incompressible  path = uniaxial(x, stretch = 1 .. 4, steps = 30) }
",
        parameters: &[
            ("C10", "0.2 MPa", "0.35 MPa"),
            ("C20", "-4 kPa", "1 kPa"),
            ("C30", "0.5 kPa", "0.1 kPa"),
        ],
        drives: &[("pull", 1.05, 4.0, &["P.xx"])],
    },
    Known {
        text: "tissue 1
import std.energies { ogden, vol_quadratic }
material m { energy = ogden(mu = [{mu}], al = [{al}]) + vol_quadratic(K = {K})  density = 1000 kg/m^3 }
drive pull { material = m  path = uniaxial(x, stretch = 1 .. 2, steps = 30) }
",
        parameters: &[("mu", "20 kPa", "60 kPa"), ("al", "6", "3"), ("K", "300 kPa", "900 kPa")],
        drives: &[("pull", 1.05, 1.9, &["sigma.xx", "F.yy"])],
    },
    Known {
        text: "tissue 1
import std.energies { goh, vol_quadratic }
material m {
  energy = goh(C = {C}, k1 = {k1}, k2 = {k2}, kappa = {kappa}) + vol_quadratic(K = 1 GPa)
  density = 1000 kg/m^3
  fibre a1 = unit([1, 0.8, 0])
  fibre a2 = unit([1, -0.8, 0])
}
drive sheet { material = m  volume = incompressible  path = biaxial(x, y, stretch = 1 .. 1.3, ratio = 0.7, steps = 30) }
drive pull { material = m  volume = incompressible  path = uniaxial(y, x, stretch = 1 .. 1.4, steps = 40) }
",
        parameters: &[
            ("C", "8 kPa", "15 kPa"),
            ("k1", "60 kPa", "30 kPa"),
            ("k2", "4", "8"),
            ("kappa", "0.12", "0.2"),
        ],
        drives: &[("sheet", 1.02, 1.3, &["sigma.xx", "sigma.yy"]), ("pull", 1.03, 1.4, &["sigma.xx"])],
    },
];

/// Sets of noise for each law.
const SEEDS: u64 = 16;
/// Data of a column.
const ROWS: u32 = 20;
/// Standard deviation of the noise, of the column's root mean square.
const NOISE: f64 = 0.01;

/// Standard errors mean what they say.
pub(crate) const ERRORS: Claim = Claim {
    topic: Topic::Energies,
    claim: "parameters of three laws, one with fibres, are found from noisy data within their standard errors: \
            the mean square of error over standard error is 1",
    source: "theory of least squares: Cov = s^2 (J^T J)^-1",
    because: "the mean of 16 squares of unit variance each scatters by sqrt(2/16) = 0.35 if a law's parameters \
              move together; twice that for the worst of three laws",
    bound: 0.7,
    measure: || worst(false),
    // standard errors that ignore the other parameters
    control: || worst(true),
};

/// Largest distance from 1 of a law's mean square of error over standard error.
fn worst(ignores_correlation: bool) -> f64 {
    LAWS.iter().map(|law| (mean_square(law, ignores_correlation) - 1.0).abs()).fold(0.0, f64::max)
}

fn mean_square(law: &Known, ignores_correlation: bool) -> f64 {
    let exact = exact(law);
    let (mut sum, mut count) = (0.0, 0);
    for seed in 0..SEEDS {
        let mut random = Random(100 + seed);
        let tables: Vec<String> =
            exact.iter().map(|(columns, rows)| noisy(columns, rows, &mut random)).collect();
        let Some(report) = fitted(&text(law, true), &tables) else { return f64::INFINITY };
        let shares = shares(&report, ignores_correlation);
        for (parameter, share) in report.parameters.iter().zip(shares) {
            let Some(error) = parameter.standard_error else { return f64::INFINITY };
            let off = (parameter.value - known(law, &parameter.name)) / (error * share);
            sum += off * off;
            count += 1;
        }
    }
    sum / f64::from(count)
}

/// By what each standard error is multiplied: 1, or what is left of it when the others are ignored.
fn shares(report: &FitReport, ignores_correlation: bool) -> Vec<f64> {
    let n = report.parameters.len();
    let correlation = DMatrix::from_fn(n, n, |i, j| report.correlation[i][j].unwrap_or(f64::NAN));
    match correlation.try_inverse() {
        Some(inverse) if ignores_correlation => (0..n).map(|i| 1.0 / inverse[(i, i)].sqrt()).collect(),
        _ => vec![1.0; n],
    }
}

/// SI value of a parameter as it is written among the known ones.
fn known(law: &Known, name: &str) -> f64 {
    let document = described(&text(law, false), &[]);
    let material = &document.materials[0];
    let wanted = name.trim_start_matches("m.");
    let ends = |known: &str| known == wanted || known.ends_with(&format!(".{wanted}"));
    material.parameters.iter().find(|known| ends(&known.name)).map_or(f64::NAN, |known| known.value)
}

/// The file with the true or the starting values, without data a drive records what is measured.
fn text(law: &Known, is_fit: bool) -> String {
    let mut text = law.text.to_string();
    for (name, exact, start) in law.parameters {
        text = text.replace(&format!("{{{name}}}"), if is_fit { start } else { exact });
    }
    if !is_fit {
        return text;
    }
    let names: Vec<&str> = law.drives.iter().map(|(name, ..)| *name).collect();
    let data = law.drives.iter().enumerate().map(|(index, (_, _, _, columns))| {
        let columns: Vec<String> =
            columns.iter().map(|column| format!("{column} = \"{}\"", header(column))).collect();
        format!("csv(\"data{index}.csv\", stretch = \"stretch\", {})", columns.join(", "))
    });
    let data: Vec<String> = data.collect();
    let vary: Vec<String> = law
        .parameters
        .iter()
        .map(|(name, ..)| match *name {
            "mu" | "al" => format!("m.{name}[1]"),
            name => format!("m.{name}"),
        })
        .collect();
    text.push_str(&format!(
        "fit f {{\n  drive = [{}]\n  data = [{}]\n  vary = [{}]\n}}\n",
        names.join(", "),
        data.join(", "),
        vary.join(", ")
    ));
    text
}

/// A column's name in the file, its unit last.
fn header(column: &str) -> String {
    let unit = if column.starts_with('F') { "" } else { "_Pa" };
    format!("{}{unit}", column.replace('.', "x"))
}

/// Columns and rows without noise, a table each drive.
type Exact = (Vec<String>, Vec<(f64, Vec<f64>)>);

fn exact(law: &Known) -> Vec<Exact> {
    law.drives
        .iter()
        .map(|(name, from, to, columns)| {
            // the drive itself, with a record of what is measured, led over the places of the data
            let head = text(law, false);
            let records: Vec<String> =
                columns.iter().map(|column| format!("{} = {column}", column.replace('.', "x"))).collect();
            let written = head.replace(
                &format!("drive {name} {{"),
                &format!("drive {name} {{ record r {{ {} }}", records.join(" ")),
            );
            let mut document = described(&written, &[]);
            let position = document.drives.iter().position(|drive| drive.name == *name);
            let mut driven = document.drives.swap_remove(position.expect("the drive is in the text"));
            driven.range = (*from, *to);
            driven.steps = ROWS - 1;
            let job = DriveJob { drive: &driven, provenance: Provenance::default(), folder: None };
            let outcome = drive(&job).expect("the laws of the claims can be driven");
            let rows = outcome.tables[0].rows.iter().map(|row| (row[0], row[1..].to_vec())).collect();
            (columns.iter().map(|column| header(column)).collect(), rows)
        })
        .collect()
}

/// A table as text.
fn table(columns: &[&str], rows: &[(f64, Vec<f64>)]) -> String {
    let mut text = format!("stretch,{}\n", columns.join(","));
    for (at, values) in rows {
        let values: Vec<String> = values.iter().map(|value| format!("{value:e}")).collect();
        text.push_str(&format!("{at:e},{}\n", values.join(",")));
    }
    text
}

/// The same with noise: a normal variate of [`NOISE`] of the column's root mean square at each datum.
fn noisy(columns: &[String], rows: &[(f64, Vec<f64>)], random: &mut Random) -> String {
    let sizes: Vec<f64> = (0..columns.len())
        .map(|k| (rows.iter().map(|(_, row)| row[k] * row[k]).sum::<f64>() / rows.len() as f64).sqrt())
        .collect();
    // the sum of twelve evenly distributed numbers is nearly normal, of variance 1
    let mut normal = || (0..12).map(|_| random.number()).sum::<f64>() - 6.0;
    let rows: Vec<(f64, Vec<f64>)> = rows
        .iter()
        .map(|(at, row)| (*at, row.iter().zip(&sizes).map(|(y, size)| y + NOISE * size * normal()).collect()))
        .collect();
    table(&columns.iter().map(String::as_str).collect::<Vec<_>>(), &rows)
}

fn described(text: &str, tables: &[String]) -> Document {
    let mut files = Memory::default();
    for (index, table) in tables.iter().enumerate() {
        files.files.insert(format!("data{index}.csv"), table.clone());
    }
    if let [one] = tables {
        files.files.insert("data.csv".into(), one.clone());
    }
    let (document, mistakes) =
        resolve(&Source { name: "claim.tissue".into(), text: text.into() }, &files, &[]);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    document
}

/// The report of the only fit of a text; none if it did not arrive.
fn fitted(text: &str, tables: &[String]) -> Option<FitReport> {
    let document = described(text, tables);
    let fit_described = document.fits.first()?;
    let job =
        FitJob { fit: fit_described, provenance: Provenance::new("claim.tissue", "", "f"), folder: None };
    Some(fit(&job).ok()?.report)
}
