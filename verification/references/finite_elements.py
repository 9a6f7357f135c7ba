"""Strips of artery by mixed finite elements, independent of everything in this project.

Quadratic displacement, discontinuous linear pressure, perturbed Lagrangian; stress and tangent by automatic
differentiation of the energy. With --drift the pressure is continuous and volume flows down its gradient while the load
grows, as it does in mixed elements stabilised in the rate of the volume. Needs dolfinx 0.5 and MUMPS (Debian: python3-dolfinx). Writes one row a load step, in
mm, N and MPa; the pressure of the elements, not D and det F, makes the Cauchy stress.

    python3 finite_elements.py --angles 40.02,-40.02 --kappa 0 --mesh 28x10x3 --grade 1.5 --out table.csv
"""

import argparse
import itertools

import numpy as np
import ufl
from dolfinx import fem, geometry, mesh
from mpi4py import MPI
from petsc4py import PETSc

from newton import Newton

arguments = argparse.ArgumentParser()
arguments.add_argument("--angles", required=True, help="of the fibre families to the length, degrees")
arguments.add_argument("--kappa", type=float, required=True)
arguments.add_argument("--C", type=float, default=0.00764, help="MPa")
arguments.add_argument("--D", type=float, default=0.1, help="1/MPa; 0 is incompressible")
arguments.add_argument("--drift", type=float, default=0.0, help="tau, mm^2/(MPa s); 2 N are reached in 1 s")
arguments.add_argument("--growth", type=float, default=1.35, help="of the force in a step, above which steps shrink")
arguments.add_argument("--bracket", type=int, default=1, help="0: fibres resist compression")
arguments.add_argument("--mesh", required=True, help="cells along length, width, thickness of the model")
arguments.add_argument("--full", action="store_true", help="half the thickness, not an eighth")
arguments.add_argument("--grade", type=float, default=1.0, help="above 1: finer towards the grips")
arguments.add_argument("--step", type=float, default=0.2, help="first step of the end displacement, mm")
arguments.add_argument("--force", type=float, default=2.1, help="N, where to end")
arguments.add_argument("--out", required=True)
given = arguments.parse_args()
if given.drift > 0 and given.D > 0:
    arguments.error("--drift goes with --D 0")

LENGTH, WIDTH, THICKNESS = 10.0, 3.0, 0.5
K1, K2 = 0.9966, 524.6
ANGLES = [np.radians(float(angle)) for angle in given.angles.split(",")]
SHARE = 2 if given.full else 4  # the whole section's force over the model's

cells = [int(n) for n in given.mesh.split("x")]
start = [-LENGTH / 2, -WIDTH / 2, 0.0] if given.full else [0.0, 0.0, 0.0]
domain = mesh.create_box(
    MPI.COMM_WORLD, [start, [LENGTH / 2, WIDTH / 2, THICKNESS / 2]], cells, mesh.CellType.hexahedron
)
place = domain.geometry.x[:, 0] / (LENGTH / 2)
domain.geometry.x[:, 0] = np.sign(place) * (1 - (1 - abs(place)) ** given.grade) * LENGTH / 2

pressure = ufl.FiniteElement("Q" if given.drift > 0 else "DPC", domain.ufl_cell(), 1)
element = ufl.MixedElement([ufl.VectorElement("Q", domain.ufl_cell(), 2), pressure])
space = fem.FunctionSpace(domain, element)
state = fem.Function(space)
u, p = ufl.split(state)
F = ufl.Identity(3) + ufl.grad(u)
J = ufl.det(F)
F_bar = J ** (-1.0 / 3) * F
I1 = ufl.inner(F_bar, F_bar)
energy = given.C * (I1 - 3)
for angle in ANGLES:
    fibre = F_bar * ufl.as_vector([np.cos(angle), np.sin(angle), 0])
    E = given.kappa * (I1 - 3) + (1 - 3 * given.kappa) * (ufl.dot(fibre, fibre) - 1)
    if given.bracket:
        E = (E + abs(E)) / 2
    energy += K1 / (2 * K2) * (ufl.exp(K2 * E * E) - 1)
energy += p * (J - 1)
if given.D > 0:
    # less the complementary energy: U'(J) = (J - 1/J)/D = p at J_p
    J_p = (given.D * p + ufl.sqrt((given.D * p) ** 2 + 4)) / 2
    energy -= p * (J_p - 1) - ((J_p * J_p - 1) / 2 - ufl.ln(J_p)) / given.D
test, trial = ufl.TestFunction(space), ufl.TrialFunction(space)
dx = ufl.dx(metadata={"quadrature_degree": 5})
residual = ufl.derivative(energy * dx, state, test)
# drift: det F of the step before for 1, and over the step's duration J' = -tau div grad p, in space
earlier, duration = fem.Function(space), fem.Constant(domain, PETSc.ScalarType(0))
if given.drift > 0:
    q, out_of = ufl.TestFunctions(space)[1], ufl.inv(F)
    J_earlier = ufl.det(ufl.Identity(3) + ufl.grad(ufl.split(earlier)[0]))
    flow = given.drift * duration * J * ufl.inner(ufl.dot(ufl.grad(p), out_of), ufl.dot(ufl.grad(q), out_of))
    residual += (q * (1 - J_earlier) - flow) * dx

conditions, moved = [], []


def hold(axis, where, share=0.0):
    """Holds a component, or moves it by a share of the end displacement."""
    component = space.sub(0).sub(axis)
    collapsed, _ = component.collapse()
    value = fem.Function(collapsed)
    found = fem.locate_dofs_geometrical((component, collapsed), where)
    conditions.append(fem.dirichletbc(value, found, component))
    moved.append((value, share))
    return found[0]


right = lambda x: np.isclose(x[0], LENGTH / 2)
left = lambda x: np.isclose(x[0], start[0])
grip = hold(0, right, 0.5)
hold(1, right), hold(2, right), hold(2, lambda x: np.isclose(x[2], 0))
if given.full:
    hold(0, left, -0.5), hold(1, left), hold(2, left)
else:
    hold(0, left), hold(1, lambda x: np.isclose(x[1], 0))

newton = Newton(residual, ufl.derivative(residual, state, trial), state, conditions)


def equilibrium(displacement):
    """Whether there is one, found from the state as it is."""
    for value, share in moved:
        value.x.array[:] = share * displacement
    return newton.solve(1e-7, 14)


def force():
    """Of the whole section, N."""
    return SHARE * newton.reactions()[grip].sum()


points = np.array([[0, 0, 0], [0, WIDTH / 2, 0], [0, 0, THICKNESS / 2], [0, -WIDTH / 2, 0]], dtype=float)
points = points[: 4 if given.full else 3]
tree = geometry.BoundingBoxTree(domain, 3)
inside = geometry.compute_colliding_cells(domain, geometry.compute_collisions(tree, points), points)


def deviatoric(F):
    """Deviatoric Cauchy stress of the law, MPa."""
    free = lambda M: M - np.trace(M) / 3 * np.eye(3)
    J = np.linalg.det(F)
    b = J ** (-2 / 3) * F @ F.T
    stress = 2 * given.C / J * free(b)
    for angle in ANGLES:
        fibre = F @ [np.cos(angle), np.sin(angle), 0]
        a = J ** (-2 / 3) * np.outer(fibre, fibre)
        E = given.kappa * (np.trace(b) - 3) + (1 - 3 * given.kappa) * (np.trace(a) - 1)
        E = max(E, 0) if given.bracket else E
        stress += 2 / J * K1 * E * np.exp(K2 * E * E) * free(given.kappa * b + (1 - 3 * given.kappa) * a)
    return stress


# Gauss points, where the gradient of quadratic elements is of one order more than at their corners: the share of a side
# from the centre and the weight that carries an even field to the centre, exact to its second degree
near, far = (1 - 3**-0.5) / 2, (1 + 3**-0.5) / 2
gauss = [(near, far**2 / (far**2 - near**2)), (far, -(near**2) / (far**2 - near**2))]


def at_centre(moves, pressures):
    """Stress, det F, pressure and stretch: the even part over the cells that meet there, from their Gauss points."""
    values = np.zeros(6)
    cells = inside.links(0)
    for cell in cells:
        corners = domain.geometry.x[domain.geometry.dofmap.links(cell)]
        sides = corners.mean(0) * 2  # from the centre, with their signs
        for weights in itertools.product(gauss, repeat=3):
            point = sides * [share for share, _ in weights]
            F = np.eye(3)
            for k in range(3):  # central differences are exact for the quadratic of the cell
                step = np.zeros(3)
                step[k] = 1e-4
                F[:, k] += (moves.eval(point + step, cell) - moves.eval(point - step, cell)) / 2e-4
            pressure = pressures.eval(point, cell)[0]
            stress = deviatoric(F) + pressure * np.eye(3)
            here = [stress[0, 0], stress[0, 1], stress[2, 2], np.linalg.det(F), pressure, F[0, 0]]
            values += np.prod([weight for _, weight in weights]) * np.array(here) / len(cells)
    return values


def row(displacement):
    """What is written: force and sizes of the whole specimen, and the centre."""
    moves, pressures = state.sub(0).collapse(), state.sub(1).collapse()
    at = [moves.eval(point, inside.links(i)[0]) for i, point in enumerate(points)]
    width = WIDTH + (at[1][1] - at[3][1] if given.full else 2 * at[1][1])
    return [displacement, force(), width, THICKNESS + 2 * at[2][2], *at_centre(moves, pressures)]


with open(given.out, "w") as table:
    names = "end_disp_mm,force_N,width_mid_mm,thick_mid_centre_mm"
    table.write(names + ",sxx_centre_MPa,sxy_centre_MPa,szz_centre_MPa,J_centre,p_centre_MPa,F11_centre\n")
    displacement, step, before, reached = 0.0, given.step, None, 0.0
    while reached < given.force and step > 1e-3:
        here = state.x.array.copy()
        earlier.x.array[:] = here
        for guess in (before, None):  # first along the last change, then from where it stands
            state.x.array[:] = here if guess is None else here + (here - guess[0]) * step / guess[1]
            found = equilibrium(displacement + step)
            for _ in range(2 if given.drift > 0 else 0):  # the step takes as long as its force grows
                duration.value = (force() - reached) / 2.0
                found = found and equilibrium(displacement + step)
            if found:
                break
        else:
            state.x.array[:] = here
            step /= 2
            continue
        before, displacement = (here, step), displacement + step
        values = row(displacement)
        table.write(",".join(f"{value:.8g}" for value in values) + "\n")
        table.flush()
        growth, reached = values[1] / max(reached, 1e-9), values[1]
        if growth > given.growth and reached > 0.05:
            step = max(step / 1.5, 0.005)
        elif growth < min(1.2, given.growth):
            step = min(1.3 * step, 0.25)
