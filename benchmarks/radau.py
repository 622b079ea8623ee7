#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tribody's dynamics beside SciPy's Radau on the same equations.

Usage: radau.py BENCHMARK_DYNAMICS DIRECTORY_WITH_PRM_FILES [CASE ...]

Runs the program benchmark_dynamics and then integrates the mechanisms that it
describes: accelerations and reactions from the equations of motion with the
constraints differentiated twice, contact by Lankarani and Nikravesh with
regularised friction, restarted at every onset of contact. Both integrate the
same two cycles from the same start. The error of either is that of the joint
force at the samples of the second cycle, rms over its mean, against Tribody
with a tolerance 1000 times below the default. The last column is SciPy's time
over that of Tribody at the same or a smaller error.

Needs python3-scipy. A chain of 40 four-bars takes SciPy hours and is left out.
"""
import json
import subprocess
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp


def turned(s, angle):
    c, sine = np.cos(angle), np.sin(angle)
    return np.array([c * s[0] - sine * s[1], sine * s[0] + c * s[1]])


def perpendicular(a):
    return np.array([-a[1], a[0]])


class Mechanism:
    def __init__(self, data):
        self.data = data
        self.masses = np.array(data["masses"])
        self.weights = np.array(data["weights"])
        self.n = len(self.masses)
        self.springs = data.get("springs") or []
        self.contact = None
        self.constraints = []
        self.rows = {}
        self.m = 0
        for joint in data["joints"]:
            if joint["type"] == "clearance":
                self.contact = joint
                continue
            self.rows[joint["name"]] = self.m
            self.constraints.append((joint, self.m))
            self.m += 1 if joint["type"] == "driver" else 2

    def point(self, marker, q, v):
        """Lever, position, velocity and its part quadratic in the angular
        speed."""
        s = np.array([marker["x"], marker["y"]])
        if marker["body"] < 0:
            return s, s, np.zeros(2), np.zeros(2)
        i = 3 * marker["body"]
        a = turned(s, q[i + 2])
        return (a, q[i:i + 2] + a, v[i:i + 2] + v[i + 2] * perpendicular(a),
                -v[i + 2] ** 2 * a)

    def constraint_terms(self, q, v):
        """Phi_q, and what the accelerations must fulfil."""
        phi_q = np.zeros((self.m, self.n))
        gamma = np.zeros(self.m)
        for joint, row in self.constraints:
            if joint["type"] == "driver":
                phi_q[row, 2] = 1.
                continue
            pin, bushing = joint["pin"], joint["bushing"]
            a, _, _, c = self.point(pin, q, v)
            b, _, _, d = self.point(bushing, q, v)
            if joint["type"] == "revolute":
                for marker, lever, sign in ((pin, a, 1.), (bushing, b, -1.)):
                    if marker["body"] >= 0:
                        i = 3 * marker["body"]
                        phi_q[row:row + 2, i:i + 2] = sign * np.eye(2)
                        phi_q[row:row + 2, i + 2] = sign * perpendicular(lever)
                gamma[row:row + 2] = d - c
            else:  # a guide on the ground
                i = 3 * bushing["body"]
                normal = perpendicular(turned((1., 0.), joint["axis"]))
                phi_q[row, i:i + 2] = normal
                phi_q[row, i + 2] = normal @ perpendicular(b)
                phi_q[row + 1, i + 2] = 1.
                gamma[row] = -normal @ d
        return phi_q, gamma

    def penetration(self, q):
        zero = np.zeros(self.n)
        e = (self.point(self.contact["pin"], q, zero)[1] -
             self.point(self.contact["bushing"], q, zero)[1])
        return np.hypot(*e) - self.contact["contact"]["clearance"]

    def contact_force(self, q, v, approach_speed):
        """Force on the bushing, tangential force, direction."""
        k = self.contact["contact"]
        pin, bushing = self.contact["pin"], self.contact["bushing"]
        _, p, p_t, _ = self.point(pin, q, v)
        _, r, r_t, _ = self.point(bushing, q, v)
        e, e_t = p - r, p_t - r_t
        length = np.hypot(*e)
        delta = length - k["clearance"]
        if delta <= 0:
            return np.zeros(2), 0., 0.
        n = e / length
        t = perpendicular(n)
        loss = 0.75 * (1 - k["restitution"] ** 2) / approach_speed
        normal = k["stiffness"] * delta ** 1.5 * max(
            0., 1 + loss * (n @ e_t))
        arm = k["pin_radius"] + k["clearance"]
        slide = (t @ e_t + k["pin_radius"] * v[3 * pin["body"] + 2] -
                 arm * v[3 * bushing["body"] + 2])
        tangential = k["friction"] * normal * np.tanh(slide / k["v_0"])
        return normal * n + tangential * t, tangential, n @ e_t

    def forces(self, q, v, approach_speed):
        f = self.weights.copy()

        def apply(marker, force):
            if marker["body"] >= 0:
                i = 3 * marker["body"]
                lever = self.point(marker, q, v)[0]
                f[i:i + 2] += force
                f[i + 2] += perpendicular(lever) @ force

        for spring in self.springs:
            line = (self.point(spring["second"], q, v)[1] -
                    self.point(spring["first"], q, v)[1])
            length = np.hypot(*line)
            tension = (spring["force"] + spring["stiffness"] *
                       (length - spring["length"])) * line / length
            apply(spring["first"], tension)
            apply(spring["second"], -tension)
        if self.contact is not None:
            k = self.contact["contact"]
            force, tangential, _ = self.contact_force(q, v, approach_speed)
            apply(self.contact["pin"], -force)
            apply(self.contact["bushing"], force)
            f[3 * self.contact["pin"]["body"] + 2] -= (
                k["pin_radius"] * tangential)
            f[3 * self.contact["bushing"]["body"] + 2] += (
                (k["pin_radius"] + k["clearance"]) * tangential)
        return f

    def accelerations(self, y, approach_speed):
        q, v = y[:self.n], y[self.n:]
        phi_q, gamma = self.constraint_terms(q, v)
        matrix = np.zeros((self.n + self.m, self.n + self.m))
        np.fill_diagonal(matrix[:self.n, :self.n], self.masses)
        matrix[self.n:, :self.n] = phi_q
        matrix[:self.n, self.n:] = phi_q.T
        x = np.linalg.solve(
            matrix,
            np.concatenate((self.forces(q, v, approach_speed), gamma)))
        return x[:self.n], x[self.n:]

    def joint_force(self, name, y, approach_speed):
        if self.contact is not None and name == self.contact["name"]:
            return self.contact_force(y[:self.n], y[self.n:],
                                      approach_speed)[0]
        row = self.rows[name]
        return self.accelerations(y, approach_speed)[1][row:row + 2]


def integrate(mechanism, rtol, atol):
    """Joint force at the samples of the second cycle, and seconds per cycle."""
    data = mechanism.data
    period, n_samples = data["period"], data["samples"]
    samples = period * (1 + np.arange(n_samples) / n_samples)
    slowest = 0.
    event = None
    if mechanism.contact is not None:
        slowest = mechanism.contact["contact"]["minimum_approach_speed"]

        # The onset that an integration starts from is not to be found again.
        def event(now, y):
            just_begun = now <= t + 1e-6
            return 1. if just_begun else mechanism.penetration(y[:mechanism.n])
        event.terminal, event.direction = True, 1

    # SciPy's own difference quotients overflow for coordinates that nothing
    # depends on.
    increments = np.repeat((1e-9, 1e-6), mechanism.n)
    n_evaluations = 0

    def rate(_, y):
        return np.concatenate(
            (y[mechanism.n:], mechanism.accelerations(y, approach_speed)[0]))

    def jacobian(t, y):
        nonlocal n_evaluations
        n_evaluations += len(y)
        here = rate(t, y)
        columns = []
        for i, increment in enumerate(increments):
            moved = y.copy()
            moved[i] += increment
            columns.append((rate(t, moved) - here) / increment)
        return np.column_stack(columns)

    t, y = 0., np.concatenate((data["q"], data["v"]))
    approach_speed = slowest
    forces = []
    begin = time.perf_counter()
    while t < 2 * period:
        solution = solve_ivp(
            rate, (t, 2 * period), y, method="Radau", rtol=rtol, atol=atol,
            jac=jacobian,
            t_eval=samples[(samples >= t) & (len(forces) <=
                                             np.arange(n_samples))],
            events=event)
        n_evaluations += solution.nfev
        for state in (solution.y.T if len(solution.t) else ()):
            forces.append(mechanism.joint_force(data["joint"], state,
                                                approach_speed))
        if solution.status == 1:
            t, y = solution.t_events[0][0], solution.y_events[0][0]
            q, v = y[:mechanism.n], y[mechanism.n:]
            e_t = (mechanism.point(mechanism.contact["pin"], q, v)[2] -
                   mechanism.point(mechanism.contact["bushing"], q, v)[2])
            e = (mechanism.point(mechanism.contact["pin"], q, v)[1] -
                 mechanism.point(mechanism.contact["bushing"], q, v)[1])
            approach_speed = max(slowest, e @ e_t / np.hypot(*e))
        else:
            break
    seconds = (time.perf_counter() - begin) / 2
    return np.array(forces), seconds, n_evaluations / 2


def main():
    program, directory, *cases = sys.argv[1:]
    cases = cases or ["validation", "0.5um", "5mm", "chain2", "chain10"]
    output = subprocess.run([program, directory, "--json", *cases], check=True,
                            capture_output=True, text=True).stdout
    for data in json.loads(output):
        print(data["name"])
        for run in data["runs"]:
            print("  Tribody  accuracy %7.0e  %7.0f residuals  %9.2f ms/cycle"
                  "  error %7.1e" % (run["accuracy"], run["residuals"],
                                     1e3 * run["seconds"], run["error"]))
        mechanism = Mechanism(data)
        exact = np.column_stack((data["force_x"], data["force_y"]))
        for rtol in (1e-4, 1e-5, 1e-6, 1e-7):
            forces, seconds, n_evaluations = integrate(
                mechanism, rtol, 1e-3 * rtol)
            error = (np.sqrt(np.mean(np.sum((forces - exact) ** 2, axis=1))) /
                     data["mean"])
            as_good = [run["seconds"] for run in data["runs"]
                       if run["error"] <= error]
            ratio = ("%.0f" % (seconds / min(as_good)) if as_good else
                     "none as accurate")
            print("  Radau    rtol     %7.0e  %7.0f residuals  %9.2f ms/cycle"
                  "  error %7.1e  over Tribody: %s" % (
                      rtol, n_evaluations, 1e3 * seconds, error, ratio),
                  flush=True)


if __name__ == "__main__":
    main()
