"""Newton's and Euler's equations of bodies with joints, solved for accelerations and reactions together.

Every body has its own six accelerations, and every constraint is an unknown force or moment beside the row that says which
accelerations agree. There is no choice of coordinates, no energy and no elimination in here: the generator does not work so.

All vectors are in space axes; numbers are long double, which is 64 bits of mantissa on x86.
"""

import numpy as np

real = np.longdouble
pi = real("3.14159265358979323846264338327950288")


def number(value):
    """Of a parameter file: strings carry more digits than a double."""
    if isinstance(value, str) and value.startswith("pi/"):
        return pi / real(value[3:])
    return real(value)


def vec(x, y, z):
    return np.array([real(x), real(y), real(z)])


EX, EY, EZ = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)
ZERO = vec(0, 0, 0)


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def unit(a):
    return a / np.sqrt(a @ a)


def rotation(axis, angle):
    """Rodrigues' formula."""
    e = unit(axis)
    skew = np.array([[real(0), -e[2], e[1]], [e[2], real(0), -e[0]], [-e[1], e[0], real(0)]])
    return np.eye(3, dtype=real) + np.sin(angle) * skew + (1 - np.cos(angle)) * (skew @ skew)


def across(axis):
    """Two directions at right angles to the axis."""
    e = unit(axis)
    first = unit(cross(e, EX if abs(e[0]) < real("0.6") else EY))
    return [first, cross(e, first)]


def solve(matrix, right):
    """Gauss's elimination with partial pivoting: LAPACK knows no long double."""
    a = np.concatenate([matrix, right.reshape(len(right), -1)], axis=1)
    n = len(matrix)
    for k in range(n):
        p = k + int(np.argmax(np.abs(a[k:, k])))
        a[[k, p]] = a[[p, k]]
        factors = a[k + 1 :, k] / a[k, k]
        a[k + 1 :, k:] -= np.outer(factors, a[k, k:])
    x = a[:, n:].copy()
    for k in range(n - 1, -1, -1):
        x[k] = (x[k] - a[k, k + 1 : n] @ x[k + 1 :]) / a[k, k]
    return x.reshape(right.shape)


class Frame:
    """Place, axes (columns of R), velocity of the origin, angular velocity."""

    def __init__(self, r=ZERO, R=None, v=ZERO, w=ZERO):
        self.r, self.R, self.v, self.w = r, np.eye(3, dtype=real) if R is None else R, v, w

    def at(self, place):
        """With the origin at a place in the axes of this frame."""
        arm = self.R @ place
        return Frame(self.r + arm, self.R, self.v + cross(self.w, arm), self.w)

    def turned(self, axis, angle, rate):
        return Frame(self.r, self.R @ rotation(axis, angle), self.v, self.w + self.R @ unit(axis) * rate)

    def slid(self, axis, way, rate):
        moved = self.at(unit(axis) * way)
        return Frame(moved.r, moved.R, moved.v + self.R @ unit(axis) * rate, moved.w)


GROUND = None  # instead of a body


class System:
    def __init__(self, gravity):
        self.gravity = gravity
        self.bodies, self.rows, self.names = [], [], {}

    def body(self, mass, inertia, frame, centre=ZERO):
        """inertia about the mass centre: a matrix, three moments or one, in the axes of the frame. Returns its number."""
        I = np.array(inertia, dtype=real)
        if I.ndim < 2:
            I = np.diag(I * np.ones(3, dtype=real))
        at = frame.at(centre)
        I = at.R @ I @ at.R.T
        self.bodies.append((real(mass), I, at, real(mass) * self.gravity, -cross(at.w, I @ at.w)))
        return len(self.bodies) - 1

    def frame(self, body):
        return Frame() if body is GROUND else self.bodies[body][2]

    def push(self, body, force, place=None):
        if body is GROUND:
            return
        _, _, at, total, moment = self.bodies[body]
        total += force
        if place is not None:
            moment += cross(place - at.r, force)

    def twist(self, body, moment):
        if body is not GROUND:
            self.bodies[body][4][:] += moment

    def _row(self, name, entries, right):
        self.names.setdefault(name, []).append(len(self.rows))
        self.rows.append((entries, right))

    def _entry(self, body, direction, place, sign):
        return (body, sign * direction, sign * cross(place - self.frame(body).r, direction))

    def _centripetal(self, body, place):
        w = self.frame(body).w
        return cross(w, cross(w, place - self.frame(body).r))

    def pin(self, name, first, second, place, directions=(EX, EY, EZ), moves=ZERO):
        """The material places of both bodies stay together; force on the second, never the ground. `moves`: relative acceleration."""
        for n in directions:
            entries = [self._entry(b, n, place, s) for b, s in ((second, 1), (first, -1)) if b is not GROUND]
            right = -n @ self._centripetal(second, place)
            if first is not GROUND:
                right = right + n @ self._centripetal(first, place)
            self._row(name, entries, right + n @ moves)

    def align(self, name, first, second, directions):
        """No relative turning about directions in space, other than about a common axis; moment on the second."""
        w1, w2 = self.frame(first).w, self.frame(second).w
        for n in directions:
            entries = [(b, ZERO, s * n) for b, s in ((second, 1), (first, -1)) if b is not GROUND]
            self._row(name, entries, n @ cross(w1, w2))

    def hinge(self, name, first, second, place, axis):
        self.pin(name, first, second, place)
        self.align(name + ".moment", first, second, across(axis))

    def roll(self, name, wheel, place, place_rate, directions=(EX, EY, EZ)):
        """The wheel touches the ground at a place that wanders: v + w x arm = 0, differentiated; force on the wheel."""
        at = self.frame(wheel)
        for n in directions:
            right = -n @ cross(at.w, place_rate - at.v)
            self._row(name, [self._entry(wheel, n, place, 1)], right)

    def velocities(self, name):
        """What the rows of `name` say about velocities; 0 where the state satisfies them."""
        result = []
        for k in self.names[name]:
            parts = [d @ self.frame(b).v + m @ self.frame(b).w for b, d, m in self.rows[k][0]]
            result.append(sum(parts, real(0)))
        return result

    def solve(self):
        """(a, alpha) for each body; forces or moments for each name, summed over its directions."""
        n, m = 6 * len(self.bodies), len(self.rows)
        matrix, right = np.zeros((n + m, n + m), dtype=real), np.zeros(n + m, dtype=real)
        for k, (mass, I, _, force, moment) in enumerate(self.bodies):
            matrix[6 * k : 6 * k + 3, 6 * k : 6 * k + 3] = mass * np.eye(3, dtype=real)
            matrix[6 * k + 3 : 6 * k + 6, 6 * k + 3 : 6 * k + 6] = I
            right[6 * k : 6 * k + 6] = np.concatenate([force, moment])
        for k, (entries, value) in enumerate(self.rows):
            right[n + k] = value
            for body, linear, angular in entries:
                row = np.concatenate([linear, angular])
                matrix[n + k, 6 * body : 6 * body + 6] += row
                matrix[6 * body : 6 * body + 6, n + k] -= row
        x = solve(matrix, right)
        found = [(x[6 * k : 6 * k + 3], x[6 * k + 3 : 6 * k + 6]) for k in range(len(self.bodies))]
        forces = {}
        for name, rows in self.names.items():
            entries = [self.rows[k][0][0] for k in rows]
            turning = [linear @ linear == 0 for _, linear, _ in entries]
            directions = [angular if turn else linear for (_, linear, angular), turn in zip(entries, turning)]
            forces[name] = sum((x[n + k] * d for k, d in zip(rows, directions)), ZERO)
        return found, forces

    def acceleration(self, found, body, place):
        """Of a material place of a body, from what `solve` found."""
        a, alpha = found[body]
        return a + cross(alpha, place - self.frame(body).r) + self._centripetal(body, place)


def integrate(rate, state, times, step, columns=8):
    """Gragg's extrapolated midpoint rule of order 2*columns with fixed steps; the states at the times."""
    counts = [2 * (k + 1) for k in range(columns)]

    def advance(t, y, h):
        table = []
        for k, n in enumerate(counts):
            s = h / n
            before, now = y, y + s * rate(t, y)
            for i in range(1, n):
                before, now = now, before + 2 * s * rate(t + i * s, now)
            row = [(before + now + s * rate(t + h, now)) / 2]
            for j in range(1, k + 1):
                ratio = real(counts[k]) / counts[k - j]
                row.append(row[j - 1] + (row[j - 1] - table[k - 1][j - 1]) / (ratio * ratio - 1))
            table.append(row)
        return table[-1][-1]

    t, result = real(0), []
    for end in times:
        steps = int(np.ceil((real(end) - t) / step - real("1e-9")))
        h = (real(end) - t) / steps
        for _ in range(steps):
            state = advance(t, state, h)
            t = t + h
        t = real(end)
        result.append(state)
    return result
