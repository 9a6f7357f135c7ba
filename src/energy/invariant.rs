//! What an energy may be written in.

/// A scalar measure of the deformation; directions are indices into the material's list.
///
/// `F`, `H = cof F` and `J` are the maps of the state, `C = Fᵀ F`, directions are unit vectors of the
/// reference configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Invariant {
    /// `I1 = F : F`
    I1,
    /// `I2 = H : H`
    I2,
    /// `I3 = J²`
    I3,
    /// `J`
    J,
    /// `Ī1 = J^(-2/3) F : F`
    I1Bar,
    /// `Ī2 = J^(-4/3) H : H`
    I2Bar,
    /// Principal stretch `λ_i`, `i` in 0..3, in descending order.
    Stretch(u8),
    /// Isochoric principal stretch `λ̄_i = J^(-1/3) λ_i`.
    StretchBar(u8),
    /// `I4(a) = |F a|²`
    I4(u8),
    /// `I5(a) = |C a|²`
    I5(u8),
    /// `Ī4(a) = J^(-2/3) |F a|²`
    I4Bar(u8),
    /// `Ī5(a) = J^(-4/3) |C a|²`
    I5Bar(u8),
    /// `I8(a, b) = F a · F b`
    I8(u8, u8),
    /// `E(a, b) = ½ (F a · F b − a · b)`
    Green(u8, u8),
    /// `C_ij` in the common axes, `i` and `j` in 0..3.
    RightCauchyGreen(u8, u8),
    /// `J^(-2/3) C_ij`
    RightCauchyGreenBar(u8, u8),
    /// Component `i` of direction `a` in the common axes; no function of the deformation.
    Component(u8, u8),
}

impl Invariant {
    /// The one name of an invariant that has several: `I8(b, a)`, `I8(a, a) = I4(a)`, `E(b, a)`.
    pub fn canonical(self) -> Self {
        match self {
            Self::I8(a, b) if a == b => Self::I4(a),
            Self::I8(a, b) => Self::I8(a.min(b), a.max(b)),
            Self::Green(a, b) => Self::Green(a.min(b), a.max(b)),
            Self::RightCauchyGreen(i, j) => Self::RightCauchyGreen(i.min(j), i.max(j)),
            Self::RightCauchyGreenBar(i, j) => Self::RightCauchyGreenBar(i.min(j), i.max(j)),
            other => other,
        }
    }
}

/// A leaf of an energy's tape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Leaf {
    /// An invariant of the deformation.
    Invariant(Invariant),
    /// A material parameter, an index into the material's list.
    Parameter(u32),
    /// Component, in the common axes, of the direction an integral over directions runs over.
    Running(u8),
}
