# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random mechanisms of the kinds that machines are made of, from 0.1 mm to 1 km.

Each is built from points in the plane at time 0, so that it is closed there; what
follows, a full turn for example, is left to chance where both sides must refuse alike.
"""

import cmath
import math

import numpy as np

from model import (GROUND, Driver, Force, Joint, Mechanism, RotationalSpring, Spring,
                   Torque)

DENSITY = 300.0


class Builder:
    """A mechanism of one size; lengths are in units of it, times of sqrt(size/g)."""

    def __init__(self, rng, title, size=None):
        self.rng = rng
        self.size = 10 ** rng.uniform(-4, 3) if size is None else size
        self.time = math.sqrt(self.size / 9.81)
        self.mass = DENSITY * self.size**3
        self.weight = self.mass * 9.81
        gravity = rng.choice([0.0, 1.0], p=[0.2, 0.8]) * -9.81j
        self.m = Mechanism(title, self.size, complex(gravity), self.time, 16)

    def between(self, low, high):
        return float(self.rng.uniform(low, high))

    def sign(self):
        return float(self.rng.choice([-1.0, 1.0]))

    def chance(self, probability):
        return self.rng.random() < probability

    def body(self, name, *points):
        """With its centre of mass near the middle of some points and any frame."""
        middle = sum(points) / len(points)
        spread = max(abs(p - middle) for p in points) or 0.2 * self.size
        centre = middle + 0.2 * spread * complex(self.between(-1, 1), self.between(-1, 1))
        mass = self.mass * self.between(0.2, 1.0) * min(1.0, max(0.1, spread / self.size))
        inertia = mass * spread**2 * self.between(0.2, 0.6)
        return self.m.body(name, mass, inertia, centre, self.between(-3.1, 3.1))

    def _joint(self, kind, first, second, first_point, second_point, axis, in_tree):
        m = self.m
        one = m.marker(first, first_point)
        two = m.marker(second, second_point)
        first_angle = 0.0 if first is GROUND else first.angle
        second_angle = 0.0 if second is GROUND else second.angle
        m.joints.append(Joint(f"j{len(m.joints)}", kind, one, two, axis - first_angle,
                              second_angle - first_angle, in_tree))

    def pin(self, first, second, point, in_tree=True):
        self._joint("revolute", first, second, point, point, 0.0, in_tree)

    def weld(self, first, second, point):
        self._joint("rigid", first, second, point, point, 0.0, True)

    def slide(self, first, second, first_point, second_point, axis, in_tree=True):
        """`axis`: its direction in the plane at time 0."""
        self._joint("translational", first, second, first_point, second_point, axis, in_tree)

    def slot(self, first, second, first_point, second_point, axis, in_tree=False):
        self._joint("point on line", first, second, first_point, second_point, axis, in_tree)

    def motor(self, body, reference=GROUND, turns=None, swing=None):
        """Turns in the cycle, or a swing to either side [rad] with a frequency of it."""
        m = self.m
        reference_angle = 0.0 if reference is GROUND else reference.angle
        speed = 0.0 if turns is None else 2 * math.pi * turns / m.duration
        amplitude, frequency = (0.0, 0.0) if swing is None else swing
        m.drivers.append(Driver(f"d{len(m.drivers)}", "angle", (reference, 0j), (body, 0j),
                                body.angle - reference_angle, speed, amplitude,
                                2 * math.pi * frequency / m.duration))

    def cylinder_motion(self, first, second, first_point, second_point, stroke, frequency):
        m = self.m
        m.drivers.append(Driver(f"d{len(m.drivers)}", "distance",
                                m.marker(first, first_point), m.marker(second, second_point),
                                abs(second_point - first_point), 0.0, stroke,
                                2 * math.pi * frequency / m.duration))

    def cylinder(self, name, first, second, first_point, second_point, driven=True,
                 stroke=0.1):
        """Barrel and rod between two pins, driven or with a spring and damper."""
        way = second_point - first_point
        barrel = self.body(name + "_barrel", first_point, first_point + 0.6 * way)
        rod = self.body(name + "_rod", first_point + 0.4 * way, second_point)
        self.pin(first, barrel, first_point)
        self.slide(barrel, rod, first_point, second_point, cmath.phase(way))
        self.pin(second, rod, second_point, in_tree=False)
        if driven:
            self.cylinder_motion(barrel, rod, first_point, second_point,
                                 self.sign() * stroke * abs(way), self.rng.integers(1, 3))
        else:
            self.spring(first, second, first_point, second_point)

    def spring(self, first, second, first_point, second_point):
        m = self.m
        length = abs(second_point - first_point)
        stiffness = self.weight / self.size * self.between(0.5, 8)
        m.springs.append(Spring(f"s{len(m.springs)}", m.marker(first, first_point),
                                m.marker(second, second_point), stiffness,
                                stiffness * self.time * self.between(0, 0.2),
                                length * self.between(0.7, 1.3)))

    def rotational_spring(self, body, reference=GROUND):
        m = self.m
        stiffness = self.weight * self.size * self.between(0.3, 3)
        angle = body.angle - (0.0 if reference is GROUND else reference.angle)
        m.rotational_springs.append(RotationalSpring(
            f"r{len(m.rotational_springs)}", body, reference, stiffness,
            stiffness * self.time * self.between(0, 0.2), angle + self.between(-0.5, 0.5)))

    def force(self, body, point):
        m = self.m
        vector = self.weight * self.between(0.1, 1) * cmath.exp(1j * self.between(0, 6.28))
        m.forces.append(Force(f"f{len(m.forces)}", m.marker(body, point), vector,
                              2 * math.pi * int(self.rng.integers(0, 3)) / m.duration,
                              bool(self.chance(0.5))))

    def torque(self, body, reference=GROUND):
        m = self.m
        m.torques.append(Torque(f"t{len(m.torques)}", body, reference,
                                self.sign() * self.weight * self.size * self.between(0.05, 0.5),
                                2 * math.pi * int(self.rng.integers(0, 3)) / m.duration))

    def loads(self):
        """A few, on any bodies."""
        bodies = self.m.bodies
        for _ in range(self.rng.integers(0, 3)):
            body = bodies[self.rng.integers(len(bodies))]
            kind = self.rng.integers(4)
            if kind == 0:
                self.force(body, body.position + 0.3 * self.size * self.direction())
            elif kind == 1:
                self.torque(body)
            elif kind == 2:
                self.spring(GROUND, body, body.position + self.size
                            * self.between(0.6, 1.5) * self.direction(),
                            body.position + 0.2 * self.size * self.direction())
            else:
                self.rotational_spring(body)

    def direction(self):
        return cmath.exp(1j * self.between(0, 2 * math.pi))

    def finish(self, is_driven):
        """Given motions start from a rough place; others exactly, with velocities."""
        m = self.m
        if not is_driven:
            m.duration *= self.between(0.7, 1.5)
            return m
        turns = not m.rotational_springs
        for body in m.bodies:
            m.misplacement[body.name] = (
                0.01 * self.size * self.between(0, 1) * self.direction(),
                self.between(-0.02, 0.02)
                + (2 * math.pi * int(self.rng.integers(-1, 2)) if turns else 0.0))
        return m


def tree(rng, is_driven):
    b = Builder(rng, "tree")
    L = b.size
    links = [(GROUND, 0j)]
    for i in range(rng.integers(1, 7)):
        parent, near = links[rng.integers(len(links))]
        start = near + L * b.between(0.0, 0.4) * b.direction()
        end = start + L * b.between(0.5, 1.2) * b.direction()
        body = b.body(f"b{i}", start, end)
        kind = rng.choice(4, p=[0.6, 0.2, 0.1, 0.1])
        if kind == 0:
            b.pin(parent, body, start)
        elif kind == 1:
            b.slide(parent, body, near, start, b.between(-3, 3))
            if not is_driven:
                b.spring(parent, body, near + 2 * L * b.direction(), end)
        elif kind == 2 and i > 0:
            b.weld(parent, body, start)
        else:
            b.slot(parent, body, near, start, b.between(-3, 3), in_tree=True)
            if not is_driven:
                b.spring(parent, body, near + 2 * L * b.direction(), end)
        links.append((body, end))
        if is_driven and kind != 1 and not (kind == 2 and i > 0):
            b.motor(body, parent if b.chance(0.5) else GROUND,
                    swing=(b.between(0.1, 1.0), int(rng.integers(1, 3))))
        if is_driven and (kind == 1 or kind == 3 or (kind == 2 and i == 0)):
            # Far enough from the axis, so that it cannot stand across.
            joint = b.m.joints[-1]
            angle = joint.axis + (0.0 if parent is GROUND else parent.angle)
            b.cylinder_motion(parent, body, start - 2 * L * cmath.exp(1j * angle), start,
                              0.3 * L, int(rng.integers(1, 3)))
    b.loads()
    return b.finish(is_driven)


def four_bar_points(b, turning):
    """Pins A, B, C, D with A and D in the ground; crank AB the shortest if it turns."""
    L = b.size
    while True:
        ground, crank, coupler, rocker = (b.between(0.3, 1.0) for _ in range(4))
        if turning:
            crank = b.between(0.1, 0.25)
        longest = max(ground, coupler, rocker)
        shortest = min(ground, coupler, rocker)
        if turning and crank + longest > 0.97 * (ground + coupler + rocker - longest):
            continue
        if turning and crank > shortest:
            continue
        A, D = 0j, L * ground * b.direction()
        B = L * crank * b.direction()
        way = D - B
        d = abs(way)
        if not abs(coupler - rocker) * L * 1.1 < d < 0.9 * (coupler + rocker) * L:
            continue
        along = (d * d + (coupler * L)**2 - (rocker * L)**2) / (2 * d)
        across = math.sqrt((coupler * L)**2 - along**2)
        C = B + (along + 1j * b.sign() * across) * way / d
        return A, B, C, D


def four_bar(rng, is_driven, builder=None):
    b = builder or Builder(rng, "four-bar")
    # Now and then one that may lock: both sides must refuse.
    A, B, C, D = four_bar_points(b, is_driven and not b.chance(0.1))
    crank, coupler, rocker = b.body("crank", A, B), b.body("coupler", B, C), b.body("rocker", C, D)
    b.pin(GROUND, crank, A)
    b.pin(crank, coupler, B)
    b.pin(coupler, rocker, C)
    b.pin(GROUND, rocker, D, in_tree=False)
    if is_driven:
        b.motor(crank, turns=b.sign())
    else:
        b.torque(crank)
        b.rotational_spring(rocker)
    if builder:
        return b, (A, B, C, D), (crank, coupler, rocker)
    b.loads()
    return b.finish(is_driven)


def six_bar(rng, is_driven):
    """Watt's: the dyad on coupler and rocker; Stephenson's: on coupler and ground."""
    is_watt = rng.random() < 0.5
    b = Builder(rng, "Watt six-bar" if is_watt else "Stephenson six-bar")
    b, (A, B, C, D), (crank, coupler, rocker) = four_bar(rng, is_driven, b)
    L = b.size
    E = C + L * b.between(0.2, 0.5) * b.direction()
    G = (D if is_watt else E) + L * b.between(0.4, 0.8) * b.direction()
    way = G - E
    reach = abs(way) / 2
    F = (E + G) / 2 + 1j * b.sign() * way / abs(way) * math.sqrt((1.5 * L)**2 + reach**2)
    one, two = b.body("link", E, F), b.body("output", F, G)
    b.pin(coupler, one, E)
    b.pin(one, two, F)
    b.pin(rocker if is_watt else GROUND, two, G, in_tree=False)
    b.loads()
    return b.finish(is_driven)


def yoke(rng, is_driven):
    b = Builder(rng, "Scotch yoke")
    L = b.size
    A = L * b.between(0.2, 0.6) * b.direction()
    guide = b.between(-3, 3)
    slant = b.between(-0.4, 0.4)
    crank = b.body("crank", 0j, A)
    place = A + L * b.between(0.3, 0.8) * cmath.exp(1j * guide)
    cross = b.body("yoke", A, place)
    b.pin(GROUND, crank, 0j)
    b.slide(GROUND, cross, 0j, place, guide)
    # The guide goes through the place of the marker.
    b.m.joints[-1].first = b.m.marker(GROUND, place - L * cmath.exp(1j * guide))
    b.slot(cross, crank, A, A, guide + math.pi / 2 + slant)
    if is_driven:
        b.motor(crank, turns=b.sign())
    else:
        b.torque(crank)
        b.spring(GROUND, cross, place + 2 * L * cmath.exp(1j * guide), place)
    b.loads()
    return b.finish(is_driven)


def slider_crank(rng, is_driven):
    b = Builder(rng, "slider-crank")
    L = b.size
    crank_length, rod_length = b.between(0.1, 0.3), b.between(0.6, 1.2)
    offset = L * b.between(-0.15, 0.15)
    turn = b.direction()
    A = L * crank_length * b.direction()
    rise = offset - A.imag
    B = complex(A.real + b.sign() * math.sqrt((L * rod_length)**2 - rise**2), offset)
    crank, rod, slider = b.body("crank", 0j, turn * A), b.body("rod", turn * A, turn * B), \
        b.body("slider", turn * B)
    b.pin(GROUND, crank, 0j)
    b.pin(crank, rod, turn * A)
    b.pin(rod, slider, turn * B)
    b.slide(GROUND, slider, turn * complex(0, offset), turn * B, cmath.phase(turn),
            in_tree=False)
    if is_driven:
        b.motor(crank, turns=b.sign())
    else:
        b.torque(crank)
        b.spring(GROUND, slider, turn * (B + 2 * L), turn * B)
    b.loads()
    return b.finish(is_driven)


def excavator(rng, is_driven):
    """Boom, stick and bucket, each on a cylinder."""
    b = Builder(rng, "excavator")
    L = b.size
    parent, base, heading = GROUND, 0j, b.between(0.2, 1.0)
    for i in range(rng.integers(1, 4)):
        u = cmath.exp(1j * heading)
        tip = base + L * b.between(0.6, 1.0) * u
        arm = b.body(f"arm{i}", base, tip)
        b.pin(parent, arm, base)
        foot = base + 0.4 * L * u * cmath.exp(1j * b.sign() * b.between(1.2, 2.0))
        b.cylinder(f"c{i}", parent, arm, foot, base + 0.5 * (tip - base), is_driven,
                   b.between(0.03, 0.12))
        parent, base = arm, tip
        heading += b.between(-1.2, 0.2)
    b.force(parent, base)
    return b.finish(is_driven)


def telescope(rng, is_driven):
    """A boom of sliding sections on a cylinder."""
    b = Builder(rng, "telescope")
    L = b.size
    u = cmath.exp(1j * b.between(0.1, 1.3))
    boom = b.body("boom", 0j, L * u)
    b.pin(GROUND, boom, 0j)
    b.cylinder("lift", GROUND, boom, L * b.between(0.3, 0.5), 0.6 * L * u, is_driven,
               b.between(0.02, 0.1))
    parent, base = boom, 0j
    for i in range(rng.integers(1, 4)):
        start = base + 0.3 * L * u
        section = b.body(f"section{i}", start, start + L * u)
        b.slide(parent, section, base, start, cmath.phase(u))
        if is_driven:
            b.cylinder_motion(parent, section, base, start, 0.1 * L, int(rng.integers(1, 3)))
        else:
            b.spring(parent, section, base - 0.5 * L * u, start)
        parent, base = section, start
    b.force(parent, base + L * u)
    return b.finish(is_driven)


def five_bar(rng, is_driven):
    """Two cranks and a dyad: two drivers, the second of any number of turns."""
    b = Builder(rng, "five-bar")
    L = b.size
    A, E = 0j, L * b.between(0.6, 1.0) * b.direction()
    B = A + L * b.between(0.1, 0.25) * b.direction()
    D = E + L * b.between(0.1, 0.25) * b.direction()
    reach = abs(D - B) / 2
    C = (B + D) / 2 + 1j * b.sign() * (D - B) / abs(D - B) * math.sqrt((1.2 * L)**2 - reach**2)
    one, two = b.body("crank1", A, B), b.body("crank2", E, D)
    left, right = b.body("left", B, C), b.body("right", D, C)
    b.pin(GROUND, one, A)
    b.pin(GROUND, two, E)
    b.pin(one, left, B)
    b.pin(two, right, D)
    b.pin(left, right, C, in_tree=False)
    if is_driven:
        b.motor(one, turns=1)
        b.motor(two, turns=int(rng.integers(1, 4)) * b.sign())
    else:
        b.torque(one)
        b.torque(two, one)
        b.rotational_spring(left, right)
    b.loads()
    return b.finish(is_driven)


def quick_return(rng, is_driven):
    """A crank whose pin slides in the slot of a swinging arm."""
    b = Builder(rng, "quick return")
    L = b.size
    A = L * b.between(0.15, 0.3) * b.direction()
    O = L * b.between(0.5, 0.9) * b.direction()
    tip = A + 0.5 * (A - O)
    crank, arm = b.body("crank", 0j, A), b.body("arm", O, tip)
    b.pin(GROUND, crank, 0j)
    b.pin(GROUND, arm, O)
    b.slot(arm, crank, O, A, cmath.phase(A - O))
    if is_driven:
        b.motor(crank, turns=b.sign())
    else:
        b.torque(crank)
        b.rotational_spring(arm)
    b.loads()
    return b.finish(is_driven)


FAMILIES = (tree, four_bar, six_bar, yoke, slider_crank, excavator, telescope, five_bar,
            quick_return)


def make(seed):
    """The mechanism of a number; even ones have a given motion."""
    rng = np.random.default_rng(seed)
    is_driven = seed % 2 == 0
    return FAMILIES[seed // 2 % len(FAMILIES)](rng, is_driven), is_driven, rng
