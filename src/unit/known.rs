//! The dimensions that have names, and the units to suggest for them.

use super::dimension::Dimension;

/// A dimension with a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Known {
    /// Its name in a file: `pressure`.
    pub name: &'static str,
    /// Other names of the same dimension.
    pub aliases: &'static [&'static str],
    /// The dimension.
    pub dimension: Dimension,
    /// Its SI symbol, usable as a unit text; empty for a number.
    pub symbol: &'static str,
    /// Unit texts to suggest.
    pub units: &'static [&'static str],
}

macro_rules! known {
    ($($name:literal $($alias:literal)* : $dimension:expr, $symbol:literal, $units:expr;)*) => {
        &[$(Known { name: $name, aliases: &[$($alias),*], dimension: $dimension, symbol: $symbol,
            units: &$units }),*]
    };
}

const NEWTON_PER_METRE: Dimension = Dimension::whole(0, 1, -2);

static KNOWN: &[Known] = known![
    "number" "angle" "ratio": Dimension::NUMBER, "", ["deg", "rad", "%"];
    "length": Dimension::LENGTH, "m", ["m", "mm", "um"];
    "area": Dimension::AREA, "m^2", ["m^2", "mm^2"];
    "volume": Dimension::VOLUME, "m^3", ["m^3", "mm^3"];
    "mass": Dimension::MASS, "kg", ["kg", "g", "mg"];
    "time": Dimension::TIME, "s", ["s", "ms", "us"];
    "frequency" "rate": Dimension::FREQUENCY, "Hz", ["Hz", "s^-1", "kHz"];
    "velocity" "speed": Dimension::VELOCITY, "m/s", ["m/s", "mm/s"];
    "acceleration": Dimension::ACCELERATION, "m/s^2", ["m/s^2"];
    "force": Dimension::FORCE, "N", ["N", "mN", "kN"];
    "pressure" "stress" "modulus" "energy_density": Dimension::PRESSURE, "Pa", ["Pa", "kPa", "MPa"];
    "density": Dimension::DENSITY, "kg/m^3", ["kg/m^3", "g/cm^3"];
    "energy" "work" "torque": Dimension::ENERGY, "J", ["J", "mJ", "uJ"];
    "power": Dimension::whole(2, 1, -3), "W", ["W", "mW"];
    "momentum" "impulse": Dimension::MOMENTUM, "N*s", ["N*s", "kg*m/s"];
    "angular_momentum": Dimension::ANGULAR_MOMENTUM, "kg*m^2/s", ["kg*m^2/s"];
    "stiffness": NEWTON_PER_METRE, "N/m", ["N/m", "N/mm"];
    "viscosity": Dimension::whole(-1, 1, -1), "Pa*s", ["Pa*s", "mPa*s"];
    "force_density": Dimension::whole(-2, 1, -2), "N/m^3", ["N/m^3"];
    "momentum_density": Dimension::whole(-2, 1, -1), "kg/m^2/s", ["kg/m^2/s"];
];

/// Every dimension that has a name, in the order of the reference.
pub fn known_dimensions() -> &'static [Known] {
    KNOWN
}

impl Dimension {
    /// The dimension of a name or another name of it: `pressure`, `stress`.
    pub fn named(name: &str) -> Option<Self> {
        KNOWN.iter().find(|k| k.name == name || k.aliases.contains(&name)).map(|k| k.dimension)
    }

    /// Its row of [`known_dimensions`].
    pub fn known(self) -> Option<&'static Known> {
        KNOWN.iter().find(|k| k.dimension == self)
    }

    /// Its name: `pressure`, or `1/pressure` if only the reciprocal has one.
    pub fn name(self) -> Option<&'static str> {
        if let Some(known) = self.known() {
            return Some(known.name);
        }
        RECIPROCALS.iter().find(|(_, dimension)| dimension.recip() == self).map(|(name, _)| *name)
    }

    /// What it is in a sentence: `a pressure`, `a number`, `an energy`, `1/pressure`, `kg^2 m^-2 s^-4`.
    pub fn describe(self) -> String {
        match self.name() {
            Some(name) if name.starts_with("1/") => name.into(),
            Some(name) => {
                let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
                format!("{article} {}", name.replace('_', " "))
            }
            None => self.base_symbol(),
        }
    }

    /// The SI symbol: `Pa`, `kg/m^3`, `Pa^-1`, `kg^2 m^-2 s^-4`; empty for a number.
    pub fn si_symbol(self) -> String {
        if let Some(known) = self.known() {
            return known.symbol.into();
        }
        if self == Dimension::PRESSURE.recip() {
            return "Pa^-1".into();
        }
        self.base_symbol()
    }

    /// Unit texts to suggest for it: `["Pa", "kPa", "MPa"]`; its SI symbol if it has no name.
    ///
    /// Each is a text [`super::parse_unit`] reads as this dimension.
    pub fn suggested_units(self) -> Vec<String> {
        match self.known() {
            Some(known) => known.units.iter().map(|u| (*u).into()).collect(),
            None if !self.is_representable() => Vec::new(),
            None => vec![self.si_symbol().replace(' ', "*")],
        }
    }
}

const RECIPROCALS: &[(&str, Dimension)] = &[
    ("1/pressure", Dimension::PRESSURE),
    ("1/length", Dimension::LENGTH),
    ("1/area", Dimension::AREA),
    ("1/volume", Dimension::VOLUME),
    ("1/density", Dimension::DENSITY),
    ("1/force", Dimension::FORCE),
];

#[cfg(test)]
mod tests {
    use super::super::parse_unit;
    use super::*;

    #[test]
    fn every_suggested_unit_and_symbol_has_the_dimension_it_is_suggested_for() {
        let reciprocals = RECIPROCALS.iter().map(|(_, d)| d.recip());
        let odd = [Dimension::PRESSURE.powi(2), Dimension::LENGTH.sqrt()];
        for dimension in KNOWN.iter().map(|k| k.dimension).chain(reciprocals).chain(odd) {
            for unit in dimension.suggested_units() {
                assert_eq!(parse_unit(&unit).map(|u| u.dimension), Ok(dimension), "{unit}");
            }
        }
        for known in KNOWN.iter().filter(|k| !k.symbol.is_empty()) {
            let unit = parse_unit(known.symbol).expect("an SI symbol is a unit");
            assert_eq!((unit.dimension, unit.factor()), (known.dimension, 1.0), "{}", known.symbol);
        }
    }

    #[test]
    fn no_two_dimensions_share_a_name_and_no_two_names_a_row() {
        let mut names: Vec<_> =
            KNOWN.iter().flat_map(|k| [k.name].into_iter().chain(k.aliases.to_vec())).collect();
        let mut dimensions: Vec<_> = KNOWN.iter().map(|k| k.dimension).collect();
        let (n, d) = (names.len(), dimensions.len());
        names.sort_unstable();
        names.dedup();
        dimensions.sort_unstable();
        dimensions.dedup();
        assert_eq!((names.len(), dimensions.len()), (n, d));
    }

    #[test]
    fn a_dimension_is_described_with_its_article() {
        assert_eq!(Dimension::PRESSURE.describe(), "a pressure");
        assert_eq!(Dimension::ENERGY.describe(), "an energy");
        assert_eq!(Dimension::PRESSURE.recip().describe(), "1/pressure");
        assert_eq!(Dimension::PRESSURE.powi(2).describe(), "kg^2 m^-2 s^-4");
    }
}
