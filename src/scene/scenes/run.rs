//! `run`: end time and numerical choices, defaults filled in by the scheme.

use super::super::file::Reported;
use super::super::members::{COMMAND_LINE, Members, Site};
use super::super::model::*;
use super::super::words::RUN;
use super::stage::Stage;
use crate::discretisation::{Consistency, Kernel};
use crate::syntax::{Block, Code, Span};
use crate::unit::Dimension;
use std::rc::Rc;

/// Spacings the kernel reaches where nothing is said and gradients are exact for quadratic fields: fourteen
/// conditions a particle want the 57 neighbours of this reach; with the 33 of 2.02 gradients change by more than
/// their own size, and thin or displaced lattices are unstable.
const QUADRATIC_REACH: f64 = 2.4;

/// The choices of a scheme; the Courant number fits its integrator.
pub(super) fn defaults(scheme: Scheme, place: Place, until: f64) -> Run {
    let seed = scheme == Scheme::Seed;
    Run {
        place,
        until,
        scheme,
        formulation: seed.then_some(Formulation::Pfhj),
        loading: Loading::Dynamic,
        integrator: if seed { Integrator::TvdRk2 } else { Integrator::VelocityVerlet },
        cfl: if seed { 0.3 } else { 0.9 },
        kernel: Kernel::WendlandC2,
        smoothing: 1.01,
        consistency: if seed { Consistency::Kernel } else { Consistency::Integration },
        momentum_dissipation: if seed { InterfaceStates::Constant } else { InterfaceStates::Variational },
        pressure_wave_weight: 1.0,
        shear_wave_weight: 1.0,
        hourglass_stiffness: if seed { 0.0 } else { 1.0 },
        volume_dissipation: if seed { VolumeDissipation::On } else { VolumeDissipation::Off },
        volume_wave_weight: 1.0,
        angular_momentum: AngularMomentum::Free,
        wave_speed_every: if seed { 0 } else { 100 },
        written: Vec::new(),
        set: Vec::new(),
    }
}

impl Stage<'_> {
    pub(super) fn run(&mut self, block: &Block) -> Result<(), Reported> {
        self.run_seen = Some(block.kind.clone());
        self.only_one(block)?;
        let file = Rc::clone(&self.file);
        let scene = self.name.text.clone();
        let members = Members::read_with(self.mistakes, &file, &RUN, block, self.overrides, &[&scene, "run"]);
        let until = members.required(self.mistakes, &file, &RUN, block, "until").and_then(|site| {
            self.until = Some((Rc::clone(&site.file), site.file.span(site.id)));
            self.positive(&site, "until", Dimension::TIME)
        });
        let mut reader = Reader { stage: self, members: &members, sound: true };
        let scheme = match reader.choice("scheme") {
            Some("seed") => Scheme::Seed,
            _ => Scheme::Improved,
        };
        let mut run = defaults(scheme, file.place(&block.kind.span), until.unwrap_or(f64::NAN));
        reader.fill(&mut run);
        let sound = reader.sound;
        run.written = RUN
            .keys
            .iter()
            .filter(|key| members.written(key.name).is_some())
            .map(|key| key.name.into())
            .collect();
        let given =
            |key: &&String| members.written(key).is_some_and(|site| site.file.source.name == COMMAND_LINE);
        run.set = run.written.iter().filter(given).cloned().collect();
        self.consistent(&run, &members, &block.kind.span)?;
        if sound && until.is_ok() {
            self.run = Some(run);
        }
        Ok(())
    }

    /// Refuses choices that contradict one another.
    fn consistent(&mut self, run: &Run, members: &Members, block: &Span) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let at = |key: &str| {
            members.written(key).map_or((Rc::clone(&file), block.clone()), |site| {
                (Rc::clone(&site.file), site.file.span(site.id))
            })
        };
        let mut refuse = |key: &str, message: &str, help: &str| {
            let (file, span) = at(key);
            Err(self.mistakes.report(&file, Code::Conflict, span, message, "", Some(help.into())))
        };
        if members.written("damping").is_some() && run.loading == Loading::Dynamic {
            let message = "`damping` belongs to quasi-static loading, but `loading` is dynamic";
            return refuse("damping", message, "write `loading = quasi_static`");
        }
        if run.volume_dissipation != VolumeDissipation::Off && run.formulation == Some(Formulation::Pf) {
            let message = "`volume_dissipation` acts on an evolved J, but `formulation = pF` derives it";
            let help = "write `formulation = pFJ` or `volume_dissipation = off`";
            return refuse("volume_dissipation", message, help);
        }
        if members.written("volume_wave_weight").is_some() && run.volume_dissipation == VolumeDissipation::Off
        {
            let message = "`volume_wave_weight` scales D(J), which is off";
            return refuse("volume_wave_weight", message, "write `volume_dissipation = on`");
        }
        let restoring = matches!(run.volume_dissipation, VolumeDissipation::Restoring { .. });
        if members.written("volume_relaxation").is_some() && !restoring {
            let message = "`volume_relaxation` belongs to the restoring term of D(J), which is not asked for";
            return refuse("volume_relaxation", message, "write `volume_dissipation = restoring`");
        }
        if run.angular_momentum == AngularMomentum::Projected && run.loading != Loading::Dynamic {
            let message = "quasi-static loading damps the motion, so `angular_momentum` cannot be kept";
            return refuse("angular_momentum", message, "write `loading = dynamic` or leave it out");
        }
        Ok(())
    }
}

/// Reads the keys of `run`, each only if it is written.
struct Reader<'s, 'a, 'm> {
    stage: &'s mut Stage<'a>,
    members: &'s Members<'m>,
    sound: bool,
}

impl Reader<'_, '_, '_> {
    fn fill(&mut self, run: &mut Run) {
        match self.choice("formulation") {
            Some("auto") => run.formulation = None,
            Some("pF") => run.formulation = Some(Formulation::Pf),
            Some("pFJ") => run.formulation = Some(Formulation::Pfj),
            Some("pFHJ") => run.formulation = Some(Formulation::Pfhj),
            _ => {}
        }
        let damping = self.value("damping", Dimension::FREQUENCY, (0.0, f64::INFINITY), true);
        if self.choice("loading") == Some("quasi_static") {
            run.loading = Loading::QuasiStatic { damping };
        }
        match self.choice("integrator") {
            Some("tvd_rk2") => (run.integrator, run.cfl) = (Integrator::TvdRk2, 0.3),
            Some("ssp_rk3") => (run.integrator, run.cfl) = (Integrator::SspRk3, 0.8),
            Some("velocity_verlet") => (run.integrator, run.cfl) = (Integrator::VelocityVerlet, 0.9),
            _ => {}
        }
        run.cfl = self.value("cfl", Dimension::NUMBER, (0.0, 10.0), false).unwrap_or(run.cfl);
        match self.choice("kernel") {
            Some("wendland_c2") => run.kernel = Kernel::WendlandC2,
            Some("cubic_spline") => run.kernel = Kernel::CubicSpline,
            Some("quintic_spline") => run.kernel = Kernel::QuinticSpline,
            Some("quadratic") => run.kernel = Kernel::Quadratic,
            _ => {}
        }
        match self.choice("integration_consistency") {
            Some("on") => run.consistency = Consistency::Integration,
            Some("off") => run.consistency = Consistency::Kernel,
            _ => {}
        }
        if self.choice("completeness") == Some("quadratic") {
            match run.consistency {
                Consistency::Kernel => self.refuse(
                    "completeness",
                    "`completeness = quadratic` corrects the gradients that `integration_consistency = on` makes, \
                     which is off",
                    "write `integration_consistency = on` or `completeness = linear`",
                ),
                _ => {
                    run.consistency = Consistency::Quadratic;
                    run.smoothing = QUADRATIC_REACH / run.kernel.support();
                }
            }
        }
        if self.choice("boundary_gradients") == Some("centroid") {
            match run.consistency {
                Consistency::Kernel => self.refuse(
                    "boundary_gradients",
                    "`boundary_gradients = centroid` wants boundary areas in balance, but \
                     `integration_consistency` is off",
                    "write `integration_consistency = on` or `boundary_gradients = one_sided`",
                ),
                Consistency::Quadratic => self.refuse(
                    "boundary_gradients",
                    "`boundary_gradients = centroid` is a choice among linear gradients, but \
                     `completeness` is quadratic",
                    "write `completeness = linear`, or leave `boundary_gradients` out",
                ),
                Consistency::Integration | Consistency::Centroid => run.consistency = Consistency::Centroid,
            }
        }
        run.smoothing =
            self.value("smoothing", Dimension::NUMBER, (0.75, 3.0), false).unwrap_or(run.smoothing);
        match self.choice("momentum_dissipation") {
            Some("off") => run.momentum_dissipation = InterfaceStates::Off,
            Some("constant") => run.momentum_dissipation = InterfaceStates::Constant,
            Some("variational") => run.momentum_dissipation = InterfaceStates::Variational,
            _ => {}
        }
        let weight = (0.0, 100.0);
        let pressure = self.value("pressure_wave_weight", Dimension::NUMBER, weight, true);
        run.pressure_wave_weight = pressure.unwrap_or(run.pressure_wave_weight);
        let shear = self.value("shear_wave_weight", Dimension::NUMBER, weight, true);
        run.shear_wave_weight = shear.unwrap_or(run.shear_wave_weight);
        let hourglass = self.value("hourglass_stiffness", Dimension::NUMBER, (0.0, 1e6), true);
        run.hourglass_stiffness = hourglass.unwrap_or(run.hourglass_stiffness);
        let volume = self.value("volume_wave_weight", Dimension::NUMBER, (0.0, 100.0), false);
        run.volume_wave_weight = volume.unwrap_or(run.volume_wave_weight);
        let rate = self.value("volume_relaxation", Dimension::FREQUENCY, (0.0, f64::INFINITY), false);
        match self.choice("volume_dissipation") {
            Some("on") => run.volume_dissipation = VolumeDissipation::On,
            Some("off") => run.volume_dissipation = VolumeDissipation::Off,
            Some("restoring") => run.volume_dissipation = VolumeDissipation::Restoring { rate },
            _ => {}
        }
        if self.choice("angular_momentum") == Some("projected") {
            run.angular_momentum = AngularMomentum::Projected;
        }
        run.wave_speed_every = self.count("wave_speed_every").unwrap_or(run.wave_speed_every);
    }

    /// Refuses a key that contradicts another.
    fn refuse(&mut self, key: &str, message: &str, help: &str) {
        let Some(site) = self.site(key) else { return };
        let span = site.file.span(site.id);
        self.stage.mistakes.report(&site.file, Code::Conflict, span, message, "", Some(help.into()));
        self.sound = false;
    }

    fn site(&self, key: &str) -> Option<Site> {
        self.members.written(key).cloned()
    }

    fn choice(&mut self, key: &str) -> Option<&'static str> {
        let site = self.site(key)?;
        let choice = self.stage.choice(&site, &RUN, key);
        self.sound &= choice.is_ok();
        choice.ok()
    }

    /// A value between two ends, the lower one allowed or not.
    fn value(
        &mut self,
        key: &str,
        dimension: Dimension,
        (low, high): (f64, f64),
        closed: bool,
    ) -> Option<f64> {
        let site = self.site(key)?;
        let value = self.stage.constant(&site, key, dimension);
        let value = value.and_then(|value| {
            if value <= high && (value > low || (closed && value == low)) {
                return Ok(value);
            }
            let lower = if closed { ">=" } else { ">" };
            let upper = if high.is_finite() { format!(" and <= {high}") } else { String::new() };
            let message = format!("`{key}` must be {lower} {low}{upper}, but the value is {value}");
            let span = site.file.span(site.id);
            Err(self.stage.mistakes.report(
                &site.file,
                Code::ParameterOutOfRange,
                span,
                message,
                "outside",
                None,
            ))
        });
        self.sound &= value.is_ok();
        value.ok()
    }

    fn count(&mut self, key: &str) -> Option<u32> {
        let site = self.site(key)?;
        let value = self.stage.constant(&site, key, Dimension::NUMBER).and_then(|value| {
            if value >= 0.0 && value.fract() == 0.0 && value <= 1e6 {
                return Ok(value as u32);
            }
            let message =
                format!("`{key}` must be a whole number from 0 to 1000000, but the value is {value}");
            let span = site.file.span(site.id);
            Err(self.stage.mistakes.report(
                &site.file,
                Code::ParameterOutOfRange,
                span,
                message,
                "outside",
                None,
            ))
        });
        self.sound &= value.is_ok();
        value.ok()
    }
}
