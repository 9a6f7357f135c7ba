//! The raw invariants every other is made of, and of which laws are differentiated.

use super::invariant::Invariant;
use crate::expression::Scalar;

/// A polynomial invariant of the maps, or a principal stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Raw {
    /// `F : F`
    I1,
    /// `H : H`
    I2,
    /// `J`
    J,
    /// Principal stretch of `F`, descending.
    Stretch(u8),
    /// `|F a|²`
    Fourth(u8),
    /// `|Fᵀ F a|²`
    Fifth(u8),
    /// `F a · F b`, the smaller index first
    Eighth(u8, u8),
    /// `a · b`, the smaller index first; no function of the deformation
    Dot(u8, u8),
    /// `F e_i · F e_j` in the common axes, the smaller index first
    Metric(u8, u8),
    /// Component of a direction; no function of the deformation
    Component(u8, u8),
}

impl Raw {
    /// The raw invariants a named one is made of.
    pub(super) fn of(invariant: Invariant) -> Vec<Self> {
        match invariant {
            Invariant::I1 => vec![Self::I1],
            Invariant::I2 => vec![Self::I2],
            Invariant::I3 | Invariant::J => vec![Self::J],
            Invariant::I1Bar => vec![Self::I1, Self::J],
            Invariant::I2Bar => vec![Self::I2, Self::J],
            Invariant::Stretch(i) => vec![Self::Stretch(i)],
            Invariant::StretchBar(i) => vec![Self::Stretch(i), Self::J],
            Invariant::I4(a) => vec![Self::Fourth(a)],
            Invariant::I5(a) => vec![Self::Fifth(a)],
            Invariant::I4Bar(a) => vec![Self::Fourth(a), Self::J],
            Invariant::I5Bar(a) => vec![Self::Fifth(a), Self::J],
            Invariant::I8(a, b) => vec![Self::eighth(a, b)],
            Invariant::Green(a, b) => vec![Self::eighth(a, b), Self::Dot(a.min(b), a.max(b))],
            Invariant::RightCauchyGreen(i, j) => vec![Self::metric(i, j)],
            Invariant::RightCauchyGreenBar(i, j) => vec![Self::metric(i, j), Self::J],
            Invariant::Component(a, i) => vec![Self::Component(a, i)],
        }
    }

    /// Whether it does not change with the deformation.
    pub(super) fn is_fixed(self) -> bool {
        matches!(self, Self::Dot(..) | Self::Component(..))
    }

    fn metric(i: u8, j: u8) -> Self {
        Self::Metric(i.min(j), i.max(j))
    }

    fn eighth(a: u8, b: u8) -> Self {
        if a == b { Self::Fourth(a) } else { Self::Eighth(a.min(b), a.max(b)) }
    }

    /// One more than the largest direction read.
    pub(super) fn directions(self) -> usize {
        match self {
            Self::Fourth(a) | Self::Fifth(a) | Self::Component(a, _) => usize::from(a) + 1,
            Self::Eighth(_, b) | Self::Dot(_, b) => usize::from(b) + 1,
            _ => 0,
        }
    }
}

/// A named invariant as a raw one times a power of `r = J^(-1/3)`, where it is one.
pub(super) fn isochoric(invariant: Invariant) -> Option<(Raw, i32)> {
    match invariant {
        Invariant::I1Bar => Some((Raw::I1, 2)),
        Invariant::I2Bar => Some((Raw::I2, 4)),
        Invariant::StretchBar(i) => Some((Raw::Stretch(i), 1)),
        Invariant::I4Bar(a) => Some((Raw::Fourth(a), 2)),
        Invariant::I5Bar(a) => Some((Raw::Fifth(a), 4)),
        Invariant::RightCauchyGreenBar(i, j) => Some((Raw::metric(i, j), 2)),
        _ => None,
    }
}

/// A named invariant from the raw ones.
pub(super) fn invariant<T: Scalar>(invariant: Invariant, raw: &impl Fn(Raw) -> T) -> T {
    // r = J^(-1/3)
    let r2 = || {
        let r = raw(Raw::J).reciprocal_cbrt();
        r.clone() * r
    };
    let r4 = || {
        let r2 = r2();
        r2.clone() * r2
    };
    match invariant {
        Invariant::I1 => raw(Raw::I1),
        Invariant::I2 => raw(Raw::I2),
        Invariant::I3 => raw(Raw::J) * raw(Raw::J),
        Invariant::J => raw(Raw::J),
        Invariant::I1Bar => raw(Raw::I1) * r2(),
        Invariant::I2Bar => raw(Raw::I2) * r4(),
        Invariant::Stretch(i) => raw(Raw::Stretch(i)),
        Invariant::StretchBar(i) => raw(Raw::Stretch(i)) * raw(Raw::J).reciprocal_cbrt(),
        Invariant::I4(a) => raw(Raw::Fourth(a)),
        Invariant::I5(a) => raw(Raw::Fifth(a)),
        Invariant::I4Bar(a) => raw(Raw::Fourth(a)) * r2(),
        Invariant::I5Bar(a) => raw(Raw::Fifth(a)) * r4(),
        Invariant::I8(a, b) => raw(Raw::eighth(a, b)),
        Invariant::Green(a, b) => {
            (raw(Raw::eighth(a, b)) - raw(Raw::Dot(a.min(b), a.max(b)))) * T::constant(0.5)
        }
        Invariant::RightCauchyGreen(i, j) => raw(Raw::metric(i, j)),
        Invariant::RightCauchyGreenBar(i, j) => raw(Raw::metric(i, j)) * r2(),
        Invariant::Component(a, i) => raw(Raw::Component(a, i)),
    }
}
