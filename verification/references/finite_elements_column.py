"""The bending column by finite elements, independent of everything in this project.

Quadratic displacement, implicit midpoint rule, half of the column; stress and tangent by automatic differentiation
of the energy. Needs dolfinx 0.5 and MUMPS (Debian: python3-dolfinx). Writes one row every 5 ms, in SI.

    python3 finite_elements_column.py --mesh 6x3x36 --step 0.0025 --out table.csv
"""

import argparse

import numpy as np
import ufl
from dolfinx import fem, geometry, mesh
from mpi4py import MPI
from petsc4py import PETSc

from newton import Newton

arguments = argparse.ArgumentParser()
arguments.add_argument("--mesh", required=True, help="cells along x, half of y, z")
arguments.add_argument("--step", type=float, required=True, help="time step, s; divides 5 ms or is 5 ms over a whole number")
arguments.add_argument("--until", type=float, default=0.6, help="s")
arguments.add_argument("--out", required=True)
given = arguments.parse_args()

E, NU, RHO = 17e6, 0.45, 1100.0
MU, K = E / (2 * (1 + NU)), E / (3 * (1 - 2 * NU))

cells = [int(n) for n in given.mesh.split("x")]
domain = mesh.create_box(MPI.COMM_WORLD, [[-0.5, 0.0, 0.0], [0.5, 0.5, 6.0]], cells, mesh.CellType.hexahedron)
space = fem.VectorFunctionSpace(domain, ("Q", 2))
# v is the mean velocity of a step, the unknown; u + h/2 v the middle of the step
u, v, old = fem.Function(space), fem.Function(space), fem.Function(space)
h = fem.Constant(domain, PETSc.ScalarType(given.step))
test, trial = ufl.TestFunction(space), ufl.TrialFunction(space)


def energy(displacement):
    F = ufl.Identity(3) + ufl.grad(displacement)
    J = ufl.det(F)
    return MU / 2 * (J ** (-2.0 / 3) * ufl.inner(F, F) - 3) + K / 2 * (J - 1) ** 2


dx = ufl.dx(metadata={"quadrature_degree": 5})
middle = ufl.variable(ufl.grad(u + h / 2 * v))
F = ufl.Identity(3) + middle
J = ufl.det(F)
P = ufl.diff(MU / 2 * (J ** (-2.0 / 3) * ufl.inner(F, F) - 3) + K / 2 * (J - 1) ** 2, middle)
form = RHO * ufl.inner(2 * (v - old) / h, test) * dx + ufl.inner(P, ufl.grad(test)) * dx

conditions = []
base = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[2], 0))
conditions.append(fem.dirichletbc(np.zeros(3), base, space))
across = space.sub(1)
collapsed, _ = across.collapse()
plane = fem.locate_dofs_geometrical((across, collapsed), lambda x: np.isclose(x[1], 0))
conditions.append(fem.dirichletbc(fem.Function(collapsed), plane, across))

newton = Newton(form, ufl.derivative(form, v, trial), v, conditions)


def advance():
    """One step."""
    if not newton.solve(1e-9, 20):
        raise SystemExit("Newton's method does not converge")
    u.x.array[:] += given.step * v.x.array
    old.x.array[:] = 2 * v.x.array - old.x.array


points = np.array([[0.5, 0, 6], [0.0, 0, 6], [0.0, 0, 3]], dtype=float)
tree = geometry.BoundingBoxTree(domain, 3)
inside = geometry.compute_colliding_cells(domain, geometry.compute_collisions(tree, points), points)
where = [inside.links(i)[0] for i in range(len(points))]
kinetic, strain = fem.form(RHO / 2 * ufl.inner(old, old) * dx), fem.form(energy(u) * dx)

old.interpolate(lambda x: np.array([10 * x[2] / 6, 0 * x[0], 0 * x[0]]))
v.x.array[:] = old.x.array
every = round(0.005 / given.step)
with open(given.out, "w") as out:
    out.write("# kind      mathematics by another code: implicit finite elements of the same boundary value problem\n")
    out.write(f"# bending column 1x1x6 m, E=17 MPa nu=0.45 rho=1100, v_x = 10 m/s z/6 m; half of it, {given.mesh} Q2, midpoint rule, dt={given.step} s\n")
    out.write("# verification/references/finite_elements_column.py, dolfinx 0.5, MUMPS; A=(.5,0,6) edge of the tip, B=(0,0,6) its centre, M=(0,0,3)\n")
    out.write("t_s,uxA_m,uzA_m,uxB_m,uzB_m,uxM_m,kinetic_J,strain_J\n")
    for step in range(round(given.until / given.step) + 1):
        if step:
            advance()
        if step % every == 0:
            a, b, m = u.eval(points, where)
            row = [step * given.step, a[0], a[2], b[0], b[2], m[0], 2 * fem.assemble_scalar(kinetic), 2 * fem.assemble_scalar(strain)]
            out.write(",".join(f"{x:.10g}" for x in row) + "\n")
            out.flush()
