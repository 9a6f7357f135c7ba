"""Newton's method with a direct solver, for the finite elements of this folder."""

import numpy as np
from dolfinx import fem
from dolfinx.fem.petsc import apply_lifting, assemble_matrix, assemble_vector, create_matrix, create_vector, set_bc
from petsc4py import PETSc


class Newton:
    """Solves residual = 0 for `state` with its derivative `tangent`, both forms of ufl, under Dirichlet conditions."""

    def __init__(self, residual, tangent, state, conditions):
        self.residual, self.tangent = fem.form(residual), fem.form(tangent)
        self.state, self.conditions = state, conditions
        self.matrix, self.vector = create_matrix(self.tangent), create_vector(self.residual)
        self.change = fem.Function(state.function_space)
        self.solver = PETSc.KSP().create()
        self.solver.setType("preonly")
        self.solver.getPC().setType("lu")
        self.solver.getPC().setFactorSolverType("mumps")
        self.solver.setOperators(self.matrix)

    def reactions(self):
        """The residual of the state as it is, before conditions."""
        with self.vector.localForm() as local:
            local.set(0)
        assemble_vector(self.vector, self.residual)
        return self.vector.array

    def solve(self, tolerance, iterations):
        """Whether the change of the state fell below `tolerance` of it."""
        for iteration in range(iterations):
            self.matrix.zeroEntries()
            assemble_matrix(self.matrix, self.tangent, bcs=self.conditions)
            self.matrix.assemble()
            self.reactions()
            apply_lifting(self.vector, [self.tangent], [self.conditions], x0=[self.state.vector], scale=-1.0)
            set_bc(self.vector, self.conditions, self.state.vector, -1.0)
            size = np.linalg.norm(self.vector.array)
            if not np.isfinite(size) or size > 1e12:
                return False
            self.solver.solve(self.vector, self.change.vector)
            if not np.all(np.isfinite(self.change.x.array)):
                return False
            self.state.x.array[:] -= self.change.x.array
            if iteration and np.linalg.norm(self.change.x.array) < tolerance * np.linalg.norm(self.state.x.array):
                return True
        return False
