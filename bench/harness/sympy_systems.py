"""The cases in SymPy's mechanics package, by Kane's method, each in the coordinates that suit SymPy best.

Each function returns coordinates, speeds, mass matrix and forcing (M u' = f), kinematics solved for q' (None: q' = u), whether M is
symmetric, and the numbers of its parameters.
"""

import inspect
import textwrap
from types import SimpleNamespace

import sympy as sm
import sympy.physics.mechanics as me

T = me.dynamicsymbols._t


def solved(kane, q, u, numbers, is_symmetric, has_kinematics=False):
    rates = kane.kindiffdict()
    M, f = me.msubs(kane.mass_matrix, rates), me.msubs(kane.forcing, rates)
    kinematics = sm.Matrix([me.msubs(rates[x.diff(T)], {}) for x in q]) if has_kinematics else None
    return SimpleNamespace(q=list(q), u=list(u), M=M, f=f, kinematics=kinematics, is_symmetric=is_symmetric, numbers=numbers)


def rod(place, frame, name, m, J, along):
    centre = place.locatenew(name, -sm.Symbol("L") / 2 * frame.z)
    return centre, me.RigidBody(name, centre, frame, m, (me.inertia(frame, J, J, along), centre))


def chain(turns, q, u):
    """Rods that hang from each other; `turns(i, above)` is the frame of rod i."""
    m, L, g, along = sm.symbols("m L g Ja")
    space = me.ReferenceFrame("N")
    place = me.Point("O")
    place.set_vel(space, 0)
    bodies, loads, above = [], [], space
    for i in range(turns.count):
        frame = turns(i, above, space)
        centre, body = rod(place, frame, f"rod{i}", m, m * L**2 / 12, along)
        end = place.locatenew(f"E{i}", -L * frame.z)
        for point in (centre, end):
            point.v2pt_theory(place, space, frame)
        bodies.append(body)
        loads.append((centre, -m * g * space.z))
        place, above = end, frame
    kane = me.KanesMethod(space, q_ind=q, u_ind=u, kd_eqs=[a - b.diff(T) for a, b in zip(u, q)])
    kane.kanes_equations(bodies, loads)
    return solved(kane, q, u, {m: 1.3, L: 0.7, g: 9.81, along: 0.001}, True)


def planar_chain(n):
    """Angles against the vertical: in relative ones the expressions grow out of bounds."""
    q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")

    def turns(i, _above, space):
        frame = space.orientnew(f"B{i}", "Axis", [q[i], space.y])
        frame.set_ang_vel(space, u[i] * space.y)
        return frame
    turns.count = n
    return chain(turns, q, u)


def planar_pendulum(n):
    """Angles against the vertical, likewise."""
    q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")
    masses, lengths, g = sm.symbols(f"m1:{n + 1}"), sm.symbols(f"l1:{n + 1}"), sm.Symbol("g")
    space = me.ReferenceFrame("N")
    place = me.Point("O")
    place.set_vel(space, 0)
    bobs, loads = [], []
    for i in range(n):
        frame = space.orientnew(f"B{i}", "Axis", [q[i], space.y])
        frame.set_ang_vel(space, u[i] * space.y)
        end = place.locatenew(f"E{i}", -lengths[i] * frame.z)
        end.v2pt_theory(place, space, frame)
        bobs.append(me.Particle(f"bob{i}", end, masses[i]))
        loads.append((end, -masses[i] * g * space.z))
        place = end
    kane = me.KanesMethod(space, q_ind=q, u_ind=u, kd_eqs=[a - b.diff(T) for a, b in zip(u, q)])
    kane.kanes_equations(bobs, loads)
    numbers = {symbol: start + sm.Rational(i, 100) for symbols, start in ((masses, 1), (lengths, sm.Rational(1, 2)))
               for i, symbol in enumerate(symbols, 1)}
    return solved(kane, q, u, {**numbers, g: sm.Float("9.81")}, True)


def spatial_chain(n):
    q, u = me.dynamicsymbols(f"q:{2 * n}"), me.dynamicsymbols(f"u:{2 * n}")

    def turns(i, above, _space):
        half = above.orientnew(f"X{i}", "Axis", [q[2 * i], above.x])
        frame = half.orientnew(f"B{i}", "Axis", [q[2 * i + 1], half.y])
        half.set_ang_vel(above, u[2 * i] * above.x)
        frame.set_ang_vel(half, u[2 * i + 1] * half.y)
        return frame
    turns.count = n
    return chain(turns, q, u)


def rolling(space, body, centre, q, u, constraints, independent, numbers, weight):
    """u = q'; the first two speeds follow from the others."""
    kane = me.KanesMethod(space, q_ind=q, u_ind=[u[i] for i in independent], u_dependent=[u[0], u[1]], velocity_constraints=constraints,
                          kd_eqs=[a - b.diff(T) for a, b in zip(u, q)])
    kane.kanes_equations([body], [(centre, weight)])
    order = [u[i] for i in independent] + [u[0], u[1]]
    return solved(kane, [q[i] for i in independent] + [q[0], q[1]], order, numbers, False)


def sphere(_n):
    q, u = me.dynamicsymbols("chi zeta phi psi theta"), me.dynamicsymbols("u:5")
    chi, zeta, phi, psi, theta = q
    m, r, R, g = sm.symbols("m r R g")
    space = me.ReferenceFrame("N")
    wall = space.orientnew("A", "Axis", [chi, space.z])
    ball = space.orientnew("S", "Body", [psi, theta, phi], "ZXZ")
    turning = me.msubs(ball.ang_vel_in(space), dict(zip([x.diff(T) for x in q], u)))
    ball.set_ang_vel(space, turning)
    wall.set_ang_vel(space, u[0] * space.z)
    centre = me.Point("O").locatenew("C", (R - r) * wall.x + zeta * space.z)
    centre.set_vel(space, (R - r) * u[0] * wall.y + u[1] * space.z)
    touching = centre.vel(space) + turning.cross(r * wall.x)
    J = sm.Rational(2, 5) * m * r**2
    body = me.RigidBody("ball", centre, ball, m, (me.inertia(ball, J, J, J), centre))
    return rolling(space, body, centre, q, u, [touching.dot(wall.y), touching.dot(wall.z)], [2, 3, 4],
                   {m: 0.5, r: 0.1, R: 0.6, g: 9.81}, -m * g * space.z)


def rolling_disc(_n):
    q, u = me.dynamicsymbols("x y psi theta phi"), me.dynamicsymbols("u:5")
    _x, _y, psi, theta, phi = q
    m, R, g = sm.symbols("m R g")
    space = me.ReferenceFrame("N")
    heading = space.orientnew("H", "Axis", [psi, space.z])
    tilt = heading.orientnew("T", "Axis", [theta, heading.x])
    disc = tilt.orientnew("D", "Axis", [phi, tilt.z])
    heading.set_ang_vel(space, u[2] * space.z)
    tilt.set_ang_vel(heading, u[3] * heading.x)
    disc.set_ang_vel(tilt, u[4] * tilt.z)
    centre = me.Point("C")
    centre.set_vel(space, u[0] * space.x + u[1] * space.y + R * sm.cos(theta) * u[3] * space.z)
    touching = centre.vel(space) + disc.ang_vel_in(space).cross(-R * tilt.y)
    J = m * R**2 / 4
    body = me.RigidBody("disc", centre, disc, m, (me.inertia(tilt, J, J, 2 * J), centre))
    return rolling(space, body, centre, q, u, [touching.dot(space.x), touching.dot(space.y)], [2, 3, 4], {m: 1, R: 0.5, g: 9.81},
                   -m * g * space.z)


def bicycle(_n):
    """SymPy's own model, from the tests that it comes with: taken from there as it runs, and nothing of it is copied.

    In another order of its constraints: in that of the test the first pivot of their elimination, the way of the front contact along x as
    the bicycle yaws, vanishes without steer, and the code loses all its digits around there.
    """
    from sympy.physics.mechanics.tests import test_kane3 as source
    text = inspect.getsource(source.test_bicycle)
    model = text[text.index("    q1, q2, q4, q5 = dynamicsymbols"):text.index("    # This is the start of entering")]
    values = text[text.index("    PaperRadRear "):text.index("    # Linearizes the forcing vector")]
    names = {**vars(source), "evalf": sm}  # the test takes evalf.N
    kinematics, equations = model[:model.index("    KM = KanesMethod")], model[model.index("    KM = KanesMethod"):]
    exec(textwrap.dedent(kinematics), names)  # noqa: S102
    along, across, upwards = names["conlist_speed"]
    names["conlist_speed"] = [across, upwards, along]
    exec(textwrap.dedent(equations), names)  # noqa: S102
    exec(textwrap.dedent(values), names)  # noqa: S102
    kane = names["KM"]
    # Of the numbers there some are of the state at which it is linearised.
    numbers = {symbol: float(value) for symbol, value in names["val_dict"].items()
               if isinstance(symbol, sm.Symbol) and sm.sympify(value).is_number}
    return solved(kane, kane.q, kane.u, numbers, False, has_kinematics=True)
