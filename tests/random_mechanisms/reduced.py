# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference solution of a mechanism in joint coordinates.

The joints of a tree have one coordinate for each freedom; what closes loops, and the
drivers, are equations between these. As many coordinates as there are degrees of freedom
are independent (QR with pivoting); the others follow by Newton's method, their rates
linearly (embedding). The equations of motion of the independent ones are integrated by
DOP853, and the reactions follow from the balances of Newton and Euler of each body.
Nothing of this is in the program, which has three coordinates for each body, Lagrange
multipliers and BDF.
"""

import cmath

import numpy as np
from scipy.integrate import DOP853
from scipy.linalg import lstsq, qr

from model import GROUND


class Refused(Exception):
    """The mechanism locks, or is about to: there is no motion to compare."""


# Of the Jacobian of the dependent coordinates; beyond it a position is singular.
WORST_CONDITION = 3e4


def dot(a, b):
    return (np.conj(a) * b).real


class Pose:
    """Position and angle of a body, their derivatives by the coordinates, and the
    accelerations at constant rates of these."""

    __slots__ = ("r", "phi", "turn", "r_z", "phi_z", "v", "omega", "r_bias", "phi_bias")

    def __init__(self, r, phi, r_z, phi_z, v, omega, r_bias, phi_bias):
        self.r, self.phi, self.turn = r, phi, cmath.exp(1j * phi)
        self.r_z, self.phi_z = r_z, phi_z
        self.v, self.omega = v, omega
        self.r_bias, self.phi_bias = r_bias, phi_bias

    def point(self, s):
        """Place of a marker, derivatives, velocity and acceleration at constant rates."""
        a = self.turn * s
        return (self.r + a, self.r_z + 1j * a * self.phi_z, self.v + 1j * a * self.omega,
                self.r_bias + 1j * a * self.phi_bias - a * self.omega**2)


class Solver:
    def __init__(self, mechanism):
        self.m = mechanism
        self.number = {id(b): i for i, b in enumerate(mechanism.bodies)}
        self.tree = [j for j in mechanism.joints if j.in_tree]
        self.loops = [j for j in mechanism.joints if not j.in_tree]
        self.first_coordinate = []
        lengths = []
        self.z_start = []
        for joint in self.tree:
            self.first_coordinate.append(len(lengths))
            p, c = joint.first, joint.second
            parent_angle = 0.0 if p[0] is GROUND else p[0].angle
            turn = c[0].angle - parent_angle
            way = self._start_point(c) - self._start_point(p)
            along = dot(cmath.exp(1j * (parent_angle + joint.axis)), way)
            if joint.kind in ("translational", "point on line"):
                lengths.append(True)
                self.z_start.append(along)
            if joint.kind in ("revolute", "point on line"):
                lengths.append(False)
                self.z_start.append(turn)
        self.n = len(lengths)
        self.z_start = np.array(self.z_start, dtype=float)
        self.scale = np.where(lengths, mechanism.size, 1.0) if self.n else np.zeros(0)
        masses = [(b.mass, b.inertia) for b in mechanism.bodies]
        self.masses = np.array([x[0] for x in masses])
        self.inertias = np.array([x[1] for x in masses])
        self._phi_equations = self._count_equations()
        self.n_free = self.n - self._phi_equations

    @staticmethod
    def _start_point(marker):
        body, s = marker
        return s if body is GROUND else body.position + cmath.exp(1j * body.angle) * s

    def _count_equations(self):
        count = {"revolute": 2, "translational": 2, "point on line": 1, "rigid": 3}
        return sum(count[j.kind] for j in self.loops) + len(self.m.drivers)

    # Kinematics -----------------------------------------------------------------------

    def poses(self, z, z_rate):
        n = self.n
        zero_r, zero_phi = np.zeros(n, dtype=complex), np.zeros(n)
        ground = Pose(0j, 0.0, zero_r, zero_phi, 0j, 0.0, 0j, 0.0)
        result = {None: ground}
        for joint, k in zip(self.tree, self.first_coordinate):
            parent = result[None if joint.first[0] is GROUND else id(joint.first[0])]
            p, p_z, v, bias = parent.point(joint.first[1])
            phi, phi_z, omega, phi_bias = (parent.phi, parent.phi_z, parent.omega,
                                           parent.phi_bias)
            if joint.kind in ("translational", "point on line"):
                u = parent.turn * cmath.exp(1j * joint.axis)
                d, d_rate = z[k], z_rate[k]
                p = p + d * u
                p_z = p_z + 1j * d * u * phi_z
                p_z[k] += u
                v = v + d_rate * u + 1j * d * u * omega
                bias = (bias + 2j * d_rate * omega * u + 1j * d * u * phi_bias
                        - d * u * omega**2)
                k += 1
            if joint.kind in ("revolute", "point on line"):
                phi = phi + z[k]
                phi_z = phi_z.copy()
                phi_z[k] += 1.0
                omega = omega + z_rate[k]
            else:
                phi = phi + joint.relative_angle
            a = cmath.exp(1j * phi) * joint.second[1]
            result[id(joint.second[0])] = Pose(
                p - a, phi, p_z - 1j * a * phi_z, phi_z, v - 1j * a * omega, omega,
                bias - 1j * a * phi_bias + a * omega**2, phi_bias)
        return result

    @staticmethod
    def _pose(poses, body):
        return poses[None if body is GROUND else id(body)]

    def equations(self, poses, t):
        """Loops and drivers: values, derivatives by z and t, and the terms of their
        second derivatives that are not by accelerations. Lengths in units of the size."""
        rows = []
        size = self.m.size
        for joint in self.loops:
            first = self._pose(poses, joint.first[0])
            second = self._pose(poses, joint.second[0])
            p1, j1, v1, b1 = first.point(joint.first[1])
            p2, j2, v2, b2 = second.point(joint.second[1])
            way, way_z, way_v, way_b = ((p2 - p1) / size, (j2 - j1) / size,
                                        (v2 - v1) / size, (b2 - b1) / size)
            if joint.kind in ("revolute", "rigid"):
                rows.append((way.real, way_z.real, 0.0, way_b.real))
                rows.append((way.imag, way_z.imag, 0.0, way_b.imag))
            else:
                u = first.turn * cmath.exp(1j * joint.axis)
                w = first.omega
                rows.append((dot(1j * u, way),
                             dot(1j * u, way_z) - dot(u, way) * first.phi_z, 0.0,
                             dot(1j * u, way_b) - 2 * w * dot(u, way_v)
                             - dot(u, way) * first.phi_bias - dot(1j * u, way) * w * w))
            if joint.kind in ("translational", "rigid"):
                angle = second.phi - first.phi - joint.relative_angle
                rows.append((np.remainder(angle + np.pi, 2 * np.pi) - np.pi,
                             second.phi_z - first.phi_z, 0.0,
                             second.phi_bias - first.phi_bias))
        for driver in self.m.drivers:
            rows.append(self._driver_row(poses, driver, t))
        if not rows:
            return np.zeros(0), np.zeros((0, self.n)), np.zeros(0), np.zeros(0)
        return tuple(np.array(column) for column in zip(*rows))

    def _driver_row(self, poses, driver, t):
        first = self._pose(poses, driver.first[0])
        second = self._pose(poses, driver.second[0])
        if driver.kind == "angle":
            return (second.phi - first.phi - driver.value(t), second.phi_z - first.phi_z,
                    -driver.rate(t),
                    second.phi_bias - first.phi_bias - driver.second_rate(t))
        p1, j1, v1, b1 = first.point(driver.first[1])
        p2, j2, v2, b2 = second.point(driver.second[1])
        length = abs(p2 - p1)
        u = (p2 - p1) / length
        v = v2 - v1
        size = self.m.size
        return ((length - driver.value(t)) / size, dot(u, j2 - j1) / size,
                -driver.rate(t) / size,
                (dot(u, b2 - b1) + dot(1j * u, v)**2 / length - driver.second_rate(t)) / size)

    # Independent and dependent coordinates ---------------------------------------------

    def split(self, z, t):
        """Numbers of the dependent and the independent coordinates."""
        _, g_z, _, _ = self.equations(self.poses(z, np.zeros(self.n)), t)
        if g_z.shape[0] == 0:
            return np.zeros(0, dtype=int), np.arange(self.n)
        _, r, pivots = qr(g_z * self.scale, mode="economic", pivoting=True)
        diagonal = abs(np.diag(r))
        if diagonal[-1] * WORST_CONDITION < diagonal[0]:
            raise Refused("singular position")
        m = g_z.shape[0]
        return np.sort(pivots[:m]), np.sort(pivots[m:])

    def close(self, z, t, dependent):
        """Newton's method for the dependent coordinates."""
        z = z.copy()
        if len(dependent) == 0:
            return z
        still = np.zeros(self.n)
        best = np.inf
        for _ in range(40):
            g, g_z, _, _ = self.equations(self.poses(z, still), t)
            change = np.linalg.solve(g_z[:, dependent] * self.scale[dependent], -g)
            length = np.linalg.norm(change)
            if not np.isfinite(length):
                break
            z[dependent] += min(1.0, 0.5 / max(length, 1e-300)) * change * self.scale[dependent]
            if length < 1e-11 and length >= 0.3 * best or length < 1e-15:
                return z
            best = min(best, length)
        raise Refused("no position")

    def rates(self, z, t, dependent, independent, u_rate):
        """All rates for those of the independent coordinates, and their derivatives."""
        g, g_z, g_t, _ = self.equations(self.poses(z, np.zeros(self.n)), t)
        rate = np.zeros(self.n)
        rate[independent] = u_rate
        if len(dependent):
            jacobian = g_z[:, dependent] * self.scale[dependent]
            rate[dependent] = self.scale[dependent] * np.linalg.solve(
                jacobian, -g_t - g_z[:, independent] @ u_rate)
        return rate

    # Dynamics -------------------------------------------------------------------------

    def loads(self, poses, t):
        """Forces and torques on the bodies about their centres of mass."""
        n = len(self.m.bodies)
        force = self.masses * self.m.gravity + np.zeros(n, dtype=complex)
        torque = np.zeros(n)

        def add(marker, f):
            body, s = marker
            if body is not GROUND:
                i = self.number[id(body)]
                force[i] += f
                torque[i] += dot(1j * self._pose(poses, body).turn * s, f)

        def add_torque(body, value):
            if body is not GROUND:
                torque[self.number[id(body)]] += value

        for s in self.m.springs:
            p1, _, v1, _ = self._pose(poses, s.first[0]).point(s.first[1])
            p2, _, v2, _ = self._pose(poses, s.second[0]).point(s.second[1])
            length = abs(p2 - p1)
            u = (p2 - p1) / length
            tension = (s.stiffness * (length - s.reference_length)
                       + s.damping * dot(u, v2 - v1))
            add(s.first, tension * u)
            add(s.second, -tension * u)
        for s in self.m.rotational_springs:
            body, reference = self._pose(poses, s.body), self._pose(poses, s.reference)
            value = -(s.stiffness * (body.phi - reference.phi - s.reference_angle)
                      + s.damping * (body.omega - reference.omega))
            add_torque(s.body, value)
            add_torque(s.reference, -value)
        for f in self.m.forces:
            turn = self._pose(poses, f.marker[0]).turn if f.turns_with_body else 1.0
            add(f.marker, f.vector * turn * np.cos(f.frequency * t))
        for f in self.m.torques:
            value = f.torque * np.cos(f.frequency * t)
            add_torque(f.body, value)
            add_torque(f.reference, -value)
        return force, torque

    def accelerations(self, z, z_rate, t, dependent, independent):
        """Second derivatives of the coordinates; poses with the rates."""
        poses = self.poses(z, z_rate)
        _, g_z, _, g_bias = self.equations(poses, t)
        # z'' = B u'' + b
        m = len(dependent)
        b_matrix = np.zeros((self.n, len(independent)))
        offset = np.zeros(self.n)
        b_matrix[independent, np.arange(len(independent))] = 1.0
        if m:
            solved = np.linalg.solve(
                g_z[:, dependent] * self.scale[dependent],
                np.column_stack([-g_z[:, independent], -g_bias]))
            solved *= self.scale[dependent][:, None]
            b_matrix[dependent] = solved[:, :-1]
            offset[dependent] = solved[:, -1]
        if len(independent) == 0:
            return offset, poses
        each = [poses[id(b)] for b in self.m.bodies]
        r_z = np.array([p.r_z for p in each])
        phi_z = np.array([p.phi_z for p in each])
        r_bias = np.array([p.r_bias for p in each])
        phi_bias = np.array([p.phi_bias for p in each])
        force, torque = self.loads(poses, t)
        mass_matrix = (np.conj(r_z).T @ (self.masses[:, None] * r_z)).real \
            + phi_z.T @ (self.inertias[:, None] * phi_z)
        right = (np.conj(r_z).T @ (force - self.masses * r_bias)).real \
            + phi_z.T @ (torque - self.inertias * phi_bias)
        reduced = b_matrix.T @ mass_matrix @ b_matrix
        scale = self.scale[independent]
        u_accelerations = scale * np.linalg.solve(
            reduced * np.outer(scale, scale),
            scale * (b_matrix.T @ (right - mass_matrix @ offset)))
        return b_matrix @ u_accelerations + offset, poses

    def reactions(self, poses, z_acceleration, t):
        """Force [N] and moment about its second marker [N m] of each joint on its second
        body, by the balances of all bodies."""
        n = len(self.m.bodies)
        size = self.m.size
        columns, owners = [], []

        def column(first, second, point, f, moment, first_point=None):
            c = np.zeros(3 * n)
            for body, sign, place in ((second, 1.0, point),
                                      (first, -1.0, point if first_point is None
                                       else first_point)):
                if body is not GROUND:
                    i = 3 * self.number[id(body)]
                    arm = place - self._pose(poses, body).r
                    c[i] += sign * f.real
                    c[i + 1] += sign * f.imag
                    c[i + 2] += sign * (dot(1j * arm, f) + moment) / size
            columns.append(c)

        for k, joint in enumerate(self.m.joints):
            first, second = joint.first[0], joint.second[0]
            point = self._pose(poses, second).point(joint.second[1])[0]
            if joint.kind in ("revolute", "rigid"):
                column(first, second, point, 1 + 0j, 0.0)
                column(first, second, point, 1j, 0.0)
                owners += [(k, 1 + 0j, 0.0), (k, 1j, 0.0)]
            else:
                normal = 1j * self._pose(poses, first).turn * cmath.exp(1j * joint.axis)
                column(first, second, point, normal, 0.0)
                owners.append((k, normal, 0.0))
            if joint.kind in ("translational", "rigid"):
                column(first, second, point, 0j, size)
                owners.append((k, 0j, size))
        for driver in self.m.drivers:
            first, second = driver.first[0], driver.second[0]
            if driver.kind == "angle":
                column(first, second, 0j, 0j, size)
            else:
                p1 = self._pose(poses, first).point(driver.first[1])[0]
                p2 = self._pose(poses, second).point(driver.second[1])[0]
                column(first, second, p2, (p2 - p1) / abs(p2 - p1), 0.0, p1)
            owners.append((None, 0j, 0.0))
        force, torque = self.loads(poses, t)
        right = np.zeros(3 * n)
        for i, body in enumerate(self.m.bodies):
            p = poses[id(body)]
            a = p.r_z @ z_acceleration + p.r_bias
            alpha = p.phi_z @ z_acceleration + p.phi_bias
            rest = body.mass * a - force[i]
            right[3 * i:3 * i + 3] = (rest.real, rest.imag,
                                      (body.inertia * alpha - torque[i]) / size)
        unknowns = lstsq(np.array(columns).T, right)[0] if columns else np.zeros(0)
        result = np.zeros((len(self.m.joints), 2), dtype=complex)
        for value, (k, f, moment) in zip(unknowns, owners):
            if k is not None:
                result[k] += np.array([value * f, value * moment])
        return result

    # Motion ---------------------------------------------------------------------------

    def sample(self, z, z_rate, t, dependent, independent):
        acceleration, poses = self.accelerations(z, z_rate, t, dependent, independent)
        each = [poses[id(b)] for b in self.m.bodies]
        return {"position": np.array([p.r for p in each]),
                "angle": np.array([p.phi for p in each]),
                "velocity": np.array([p.v for p in each]),
                "angular_velocity": np.array([p.omega for p in each]),
                "reactions": self.reactions(poses, acceleration, t)}

    def given_motion(self, times):
        """Samples of a mechanism whose drivers leave nothing free."""
        dependent, independent = self.split(self.z_start, 0.0)
        start = self.close(self.z_start, 0.0, dependent)
        samples = {}
        for direction in (sorted(t for t in times if t >= 0),
                          sorted((t for t in times if t < 0), reverse=True)):
            z, before = start, 0.0
            for end in direction:
                n_steps = max(1, int(np.ceil(abs(end - before) / self.m.duration * 400)))
                for t in np.linspace(before, end, n_steps + 1)[1:]:
                    self.split(z, t)
                    z = self.close(z, t, dependent)
                before = end
                rate = self.rates(z, end, dependent, independent, np.zeros(0))
                samples[end] = self.sample(z, rate, end, dependent, independent)
        return [samples[t] for t in times]

    def start_rates(self, wanted):
        """Rates that obey loops and drivers at time 0, near the wanted ones of the
        coordinates, and where the bodies are and how they move then, for the parameter
        file: a body that was beside its guide starts on it."""
        dependent, independent = self.split(self.z_start, 0.0)
        self.z_start = self.close(self.z_start, 0.0, dependent)
        rate = self.rates(self.z_start, 0.0, dependent, independent, wanted[independent])
        poses = self.poses(self.z_start, rate)
        for body in self.m.bodies:
            body.position = complex(poses[id(body)].r)
            body.angle = float(poses[id(body)].phi)
            body.velocity = complex(poses[id(body)].v)
            body.angular_velocity = float(poses[id(body)].omega)
        self.rate_start = rate

    def free_motion(self, times, tolerance):
        """Samples of a mechanism with degrees of freedom, from time 0 on."""
        z, rate, t = self.z_start, self.rate_start, 0.0
        samples = []
        for end in times:
            while t < end:
                z, rate, t = self._integrate(z, rate, t, end, tolerance)
            samples.append(self.sample(z, rate, t, *self.split(z, t)))
        return samples

    def _integrate(self, z, rate, t, end, tolerance):
        """Until the end, or until other coordinates had better be the independent ones."""
        dependent, independent = self.split(z, t)
        n = len(independent)
        guess = z.copy()

        def derivative(time, state):
            guess[independent] = state[:n]
            here = self.close(guess, time, dependent)
            guess[:] = here
            rates = self.rates(here, time, dependent, independent, state[n:])
            a, _ = self.accelerations(here, rates, time, dependent, independent)
            return np.concatenate([state[n:], a[independent]])

        def condition():
            if len(dependent) == 0:
                return 1.0
            _, g_z, _, _ = self.equations(self.poses(guess, np.zeros(self.n)), t)
            return np.linalg.cond(g_z[:, dependent] * self.scale[dependent])

        span = self.scale[independent]
        solver = DOP853(derivative, t, np.concatenate([z[independent], rate[independent]]),
                        end, rtol=tolerance, max_step=self.m.duration / 50,
                        atol=tolerance * np.concatenate([span, span / self.m.duration]))
        at_start = condition()
        while solver.status == "running":
            solver.step()
            if condition() > 3 * at_start:
                self.split(guess, solver.t)
                break
        if solver.status == "failed":
            raise Refused("integration ended at " + repr(solver.t))
        guess[independent] = solver.y[:n]
        z = self.close(guess, solver.t, dependent)
        return z, self.rates(z, solver.t, dependent, independent, solver.y[n:]), solver.t
