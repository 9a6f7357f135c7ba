//! What the drives of a fit answer at a set of parameters, beside what was measured.

use super::super::drive::{Seen, target};
use super::super::error::RunError;
use crate::drive::{Drive as MaterialPoint, DriveError, PointSlope, Volume, frame};
use crate::energy::ParameterSlopes;
use crate::expression::{Number, Tape};
use crate::fit::Linear;
use crate::scene::{Fit, FitSet, Material, PointProbe, VolumeChange, Weighing};
use crate::tensor::{Mat3, Vec3, contract};
use nalgebra::{DMatrix, DVector};
use num_dual::Dual;

/// One measured quantity at the fitted parameters.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    pub(super) drive: String,
    /// Index of the set.
    pub(super) set: usize,
    pub(super) name: String,
    pub(super) unit: String,
    /// Parameter of the path, datum, model, weight of the difference; ordered along the path.
    pub(super) rows: Vec<Row>,
}

/// One datum.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) at: f64,
    pub(super) datum: f64,
    pub(super) model: f64,
    /// Factor of the difference in the residual.
    pub(super) weight: f64,
}

impl Row {
    /// The weighted difference.
    pub(super) fn residual(&self) -> f64 {
        self.weight * (self.model - self.datum)
    }
}

impl Measured {
    /// Weighted squares about the weighted mean.
    pub(super) fn spread(&self) -> f64 {
        let weights: f64 = self.rows.iter().map(|row| row.weight * row.weight).sum();
        let mean = self.rows.iter().map(|row| row.weight * row.weight * row.datum).sum::<f64>() / weights;
        self.rows
            .iter()
            .map(|row| (row.weight * (row.datum - mean)) * (row.weight * (row.datum - mean)))
            .sum()
    }

    /// Root mean square of the differences, not weighted, in the unit of the data.
    pub(super) fn rms_difference(&self) -> f64 {
        let sum: f64 = self.rows.iter().map(|row| (row.model - row.datum) * (row.model - row.datum)).sum();
        (sum / self.rows.len() as f64).sqrt()
    }

    /// Share of the column's weighted spread the fit explains.
    pub(super) fn r_squared(&self) -> f64 {
        1.0 - self.rows.iter().map(|row| row.residual() * row.residual()).sum::<f64>() / self.spread()
    }
}

/// One set ready to be driven.
#[derive(Debug)]
struct Set<'a> {
    set: &'a FitSet,
    index: usize,
    axes: Mat3,
    directions: Vec<Vec3>,
    /// Rows in the order they are driven.
    order: Vec<usize>,
    /// Index into the materials.
    material: usize,
}

/// All drives of a fit.
#[derive(Debug)]
pub(super) struct Model<'a> {
    fit: &'a Fit,
    sets: Vec<Set<'a>>,
    materials: Vec<&'a Material>,
    /// What went wrong last.
    failure: Option<(String, Option<DriveError>)>,
}

/// What a set answers: values by row and column, and their derivatives by each parameter of the fit.
type Answer = Vec<Vec<(f64, Vec<f64>)>>;

impl<'a> Model<'a> {
    pub(super) fn new(fit: &'a Fit) -> Result<Self, RunError> {
        let mut materials: Vec<&Material> = Vec::new();
        let mut sets = Vec::new();
        for (index, set) in fit.sets.iter().enumerate() {
            let drive = &set.drive;
            // Drives may give a material other values, so the name alone does not tell.
            let known = materials.iter().position(|known| **known == drive.material);
            let material = known.unwrap_or_else(|| {
                materials.push(&drive.material);
                materials.len() - 1
            });
            let mut order: Vec<usize> = (0..set.abscissae.len()).collect();
            order.sort_by(|&a, &b| set.abscissae[a].total_cmp(&set.abscissae[b]));
            if drive.range.0 > drive.range.1 {
                order.reverse();
            }
            let axes = frame(&Vec3::from(drive.axes[0]), &Vec3::from(drive.axes[1]))?;
            let directions = drive.directions.iter().map(|&direction| Vec3::from(direction)).collect();
            sets.push(Set { set, index, axes, directions, order, material });
        }
        let model = Self { fit, sets, materials, failure: None };
        // A law that cannot be compiled is a mistake of the file, not of a step.
        let start: Vec<f64> = fit.vary.iter().map(|varied| varied.start).collect();
        for material in &model.materials {
            let (values, varied) = model.values(material, &start);
            ParameterSlopes::compile(&material.energy, &values, &varied)
                .map_err(|cause| RunError::Law { material: material.name.clone(), cause })?;
        }
        Ok(model)
    }

    /// Why there was no response when it was last asked for.
    pub(super) fn fault(&self) -> RunError {
        match &self.failure {
            Some((drive, cause)) => {
                RunError::FitStart { drive: drive.clone(), cause: cause.clone().map(Box::new) }
            }
            None => RunError::FitStart { drive: self.fit.name.clone(), cause: None },
        }
    }

    /// Parameters of a material, and which of them the fit varies.
    fn values(&self, material: &Material, fitted: &[f64]) -> (Vec<f64>, Vec<u32>) {
        let mut values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
        let mut varied = Vec::new();
        for (found, &value) in self.fit.vary.iter().zip(fitted) {
            if found.material == material.name {
                values[found.index] = value;
                varied.push(found.index as u32);
            }
        }
        (values, varied)
    }

    /// Residuals and their derivatives; `None` where a drive fails or a formula leaves its range.
    pub(super) fn linear(&mut self, fitted: &[f64]) -> Option<Linear> {
        let measured = self.answer(fitted)?;
        let count: usize = measured.iter().map(|(_, column, _)| column.rows.len()).sum();
        let mut linear =
            Linear { residuals: DVector::zeros(count), jacobian: DMatrix::zeros(count, fitted.len()) };
        let mut at = 0;
        for (_, column, slopes) in &measured {
            for (row, slopes) in column.rows.iter().zip(slopes) {
                linear.residuals[at] = row.residual();
                for (j, slope) in slopes.iter().enumerate() {
                    linear.jacobian[(at, j)] = row.weight * slope;
                }
                at += 1;
            }
        }
        if linear.jacobian.iter().all(|slope| slope.is_finite()) {
            return Some(linear);
        }
        let drive =
            measured.iter().find(|(_, _, slopes)| !slopes.iter().flatten().all(|slope| slope.is_finite()));
        self.failure = drive.map(|(_, column, _)| (column.drive.clone(), None));
        None
    }

    /// Data beside the model at these parameters.
    pub(super) fn measured(&mut self, fitted: &[f64]) -> Result<Vec<Measured>, RunError> {
        let answer = self.answer(fitted).ok_or_else(|| self.fault())?;
        Ok(answer.into_iter().map(|(_, column, _)| column).collect())
    }

    /// The response along a drive at places of its parameter: one value a column each.
    pub(super) fn curve(&self, set: usize, fitted: &[f64], at: &[f64]) -> Option<Vec<Vec<f64>>> {
        let set = &self.sets[set];
        let slopes = self.law(set.material, fitted)?;
        let answer = self.drive(set, &slopes, at).ok()?;
        Some(answer.into_iter().map(|row| row.into_iter().map(|(value, _)| value).collect()).collect())
    }

    fn law(&self, material: usize, fitted: &[f64]) -> Option<ParameterSlopes> {
        let material = self.materials[material];
        let (values, varied) = self.values(material, fitted);
        let mut scratch = Vec::new();
        let holds = material.constraints.iter().all(|constraint| {
            let leaf = |leaf: &crate::energy::Leaf| match leaf {
                crate::energy::Leaf::Parameter(index) => values[*index as usize],
                crate::energy::Leaf::Invariant(_) | crate::energy::Leaf::Running(_) => f64::NAN,
            };
            constraint.range.contains(constraint.value.evaluate(leaf, &mut scratch))
        });
        if !holds {
            return None;
        }
        ParameterSlopes::compile(&material.energy, &values, &varied).ok()
    }

    #[expect(clippy::type_complexity, reason = "a set, its column and the slopes of its rows")]
    fn answer(&mut self, fitted: &[f64]) -> Option<Vec<(usize, Measured, Vec<Vec<f64>>)>> {
        let laws: Option<Vec<ParameterSlopes>> =
            (0..self.materials.len()).map(|material| self.law(material, fitted)).collect();
        let laws = laws?;
        let mut all = Vec::new();
        for set in &self.sets {
            let at: Vec<f64> = set.order.iter().map(|&row| set.set.abscissae[row]).collect();
            let answer = match self.drive(set, &laws[set.material], &at) {
                Ok(answer) => answer,
                Err(cause) => {
                    self.failure = Some((set.set.drive.name.clone(), Some(cause)));
                    return None;
                }
            };
            for (index, column) in set.set.columns.iter().enumerate() {
                let scale = scale(self.fit.weighing, &column.measured);
                let mut rows = Vec::new();
                let mut slopes = Vec::new();
                for (place, &row) in set.order.iter().enumerate() {
                    let (model, slope) = &answer[place][index];
                    let datum = column.measured[row];
                    let relative = if self.fit.weighing == Weighing::Relative { datum.abs() } else { scale };
                    let weight = set.set.row_weights[row].sqrt() / relative;
                    if weight > 0.0 {
                        rows.push(Row { at: at[place], datum, model: *model, weight });
                        slopes.push(slope.clone());
                    }
                }
                // Every row weighs nothing.
                if rows.is_empty() {
                    continue;
                }
                let measured = Measured {
                    drive: set.set.drive.name.clone(),
                    set: set.index,
                    name: column.name.clone(),
                    unit: column.unit.clone(),
                    rows,
                };
                all.push((set.index, measured, slopes));
            }
        }
        Some(all)
    }

    /// Drives one set; places that repeat are driven once.
    fn drive(&self, set: &Set<'_>, slopes: &ParameterSlopes, at: &[f64]) -> Result<Answer, DriveError> {
        let drive = &set.set.drive;
        let incompressible = drive.volume == VolumeChange::Incompressible;
        let volume = if incompressible { Volume::Incompressible } else { Volume::Compressible };
        let point = MaterialPoint { law: slopes.law(), directions: &set.directions, frame: set.axes, volume };
        let own: Vec<usize> = (0..self.fit.vary.len())
            .filter(|&index| self.fit.vary[index].material == drive.material.name)
            .collect();
        let mut distinct: Vec<f64> = at.to_vec();
        distinct.dedup();
        let mut found: Answer = Vec::with_capacity(distinct.len());
        let path = |parameter| target(&drive.path, parameter, incompressible);
        point.visit_with_slopes(path, &distinct, slopes, |point, slopes| {
            let seen = Seen::from(point, &set.axes);
            let turned: Vec<PointSlope> = slopes.iter().map(|slope| turned(slope, &set.axes)).collect();
            let columns = set.set.columns.iter();
            found.push(
                columns
                    .map(|column| value(&column.value, &seen, &turned, &own, self.fit.vary.len()))
                    .collect(),
            );
        })?;
        let mut place = 0;
        let all = at.iter().enumerate().map(|(row, value)| {
            if row > 0 && *value != at[row - 1] {
                place += 1;
            }
            found[place].clone()
        });
        Ok(all.collect())
    }
}

/// What a column's differences are divided by.
fn scale(weighing: Weighing, measured: &[f64]) -> f64 {
    match weighing {
        Weighing::Column => {
            let sum: f64 = measured.iter().map(|value| value * value).sum();
            (sum / measured.len() as f64).sqrt()
        }
        Weighing::Uniform | Weighing::Relative => 1.0,
    }
}

/// A slope with its tensors in the axes of the path.
fn turned(slope: &PointSlope, axes: &Mat3) -> PointSlope {
    let turned = |tensor: &Mat3| axes.transpose() * tensor * axes;
    PointSlope {
        f: turned(&slope.f),
        first_piola: turned(&slope.first_piola),
        cauchy: turned(&slope.cauchy),
        ..*slope
    }
}

/// A column at a point, and its derivative by each parameter of the fit; `own` are those of the material.
fn value(
    tape: &Tape<PointProbe>,
    seen: &Seen,
    slopes: &[PointSlope],
    own: &[usize],
    count: usize,
) -> (f64, Vec<f64>) {
    let value = tape.evaluate(|probe| seen.value(*probe), &mut Vec::new());
    let mut all = vec![0.0; count];
    let mut scratch = Vec::new();
    for (&index, slope) in own.iter().zip(slopes) {
        let dual = tape.evaluate(
            |probe| Dual::new(Number(seen.value(*probe)), Number(probe_slope(*probe, seen, slope))),
            &mut scratch,
        );
        all[index] = dual.eps.0;
    }
    (value, all)
}

/// Derivative of what a probe reads.
fn probe_slope(probe: PointProbe, seen: &Seen, slope: &PointSlope) -> f64 {
    let at = |tensor: &Mat3, i: u8, j: u8| tensor[(usize::from(i), usize::from(j))];
    match probe {
        PointProbe::Parameter | PointProbe::Residual => 0.0,
        PointProbe::F(i, j) => at(&slope.f, i, j),
        PointProbe::P(i, j) => at(&slope.first_piola, i, j),
        PointProbe::Sigma(i, j) => at(&slope.cauchy, i, j),
        PointProbe::Psi => slope.psi,
        PointProbe::J => slope.j,
        PointProbe::VonMises => {
            // d √(3/2 s:s) = 3/2 s:dσ/σ_v
            let deviator = seen.cauchy - seen.cauchy.trace() / 3.0 * Mat3::identity();
            let size = seen.value(PointProbe::VonMises);
            if size > 0.0 { 1.5 * contract(&deviator, &slope.cauchy) / size } else { 0.0 }
        }
        PointProbe::Pressure => slope.cauchy.trace() / 3.0,
        PointProbe::ConstraintStress => slope.constraint_stress,
    }
}
