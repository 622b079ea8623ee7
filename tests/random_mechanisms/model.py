# SPDX-License-Identifier: LGPL-2.1-or-later
"""A planar mechanism for both sides of the comparison: bodies, joints and what acts on
them, given in the configuration at time 0, and its parameter file.

Points and vectors are complex numbers, so that turning by an angle is a product.
"""

import cmath
import math
from dataclasses import dataclass, field

GROUND = None


@dataclass
class Body:
    """Mass and inertia about the centre of mass, which is at `position` with the frame
    turned by `angle` at time 0; velocities as the parameter file gives them."""

    name: str
    mass: float
    inertia: float
    position: complex
    angle: float
    velocity: complex = 0j
    angular_velocity: float = 0.0
    markers: dict = field(default_factory=dict)


@dataclass
class Joint:
    """`kind` as in the parameter file; markers are (body, point in its frame). Joints of
    the tree carry the coordinates, the others close loops."""

    name: str
    kind: str
    first: tuple
    second: tuple
    axis: float = 0.0
    relative_angle: float = 0.0
    in_tree: bool = True


@dataclass
class Driver:
    """Angle of `second` body relative to `first`, or distance of two markers:
    offset + speed t + amplitude sin(frequency t)."""

    name: str
    kind: str
    first: tuple
    second: tuple
    offset: float
    speed: float
    amplitude: float
    frequency: float

    def value(self, t):
        return self.offset + self.speed * t + self.amplitude * math.sin(self.frequency * t)

    def rate(self, t):
        w = self.frequency
        return self.speed + self.amplitude * w * math.cos(w * t)

    def second_rate(self, t):
        w = self.frequency
        return -self.amplitude * w * w * math.sin(w * t)


@dataclass
class Spring:
    name: str
    first: tuple
    second: tuple
    stiffness: float
    damping: float
    reference_length: float


@dataclass
class RotationalSpring:
    name: str
    body: object
    reference: object
    stiffness: float
    damping: float
    reference_angle: float


@dataclass
class Force:
    """Amplitude times cos(frequency t), in global axes or those of the body."""

    name: str
    marker: tuple
    vector: complex
    frequency: float
    turns_with_body: bool


@dataclass
class Torque:
    name: str
    body: object
    reference: object
    torque: float
    frequency: float


class Mechanism:
    def __init__(self, title, size, gravity, duration, samples):
        self.title = title
        self.size = size
        self.gravity = gravity
        self.duration = duration
        self.samples = samples
        self.bodies = []
        self.joints = []
        self.drivers = []
        self.springs = []
        self.rotational_springs = []
        self.forces = []
        self.torques = []
        self.ground_markers = {}
        # What the parameter file says of position and angle besides the truth.
        self.misplacement = {}

    def body(self, name, mass, inertia, position, angle=0.0):
        self.bodies.append(Body(name, mass, inertia, position, angle))
        return self.bodies[-1]

    def marker(self, body, point):
        """The marker of a body that is at a point of the plane at time 0."""
        if body is not GROUND:
            point = (point - body.position) * cmath.exp(-1j * body.angle)
        return (body, point)

    def _marker_name(self, marker):
        body, point = marker
        markers = self.ground_markers if body is GROUND else body.markers
        for name, place in markers.items():
            if place == point:
                break
        else:
            name = f"m{len(markers)}"
            markers[name] = point
        return f"{'ground' if body is GROUND else body.name}.{name}"

    @staticmethod
    def _body_name(body):
        return "ground" if body is GROUND else body.name

    def _joint_lines(self, joint):
        if joint.kind == "revolute":
            return [("Pin marker", self._marker_name(joint.first)),
                    ("Bushing marker", self._marker_name(joint.second))]
        lines = [("Type", joint.kind),
                 ("First marker", self._marker_name(joint.first)),
                 ("Second marker", self._marker_name(joint.second))]
        if joint.kind != "rigid":
            lines.append(("Axis", f"{joint.axis!r} rad"))
        if joint.kind != "point on line":
            lines.append(("Relative angle", f"{joint.relative_angle!r} rad"))
        return lines

    def _driver_lines(self, driver):
        function = f"sin({driver.frequency!r}*t)" if driver.amplitude else "0"
        if driver.kind == "angle":
            return [("Body", self._body_name(driver.second[0])),
                    ("Reference body", self._body_name(driver.first[0])),
                    ("Initial angle", f"{driver.offset!r} rad"),
                    ("Speed", f"{driver.speed!r} rad/s"),
                    ("Angle amplitude", f"{driver.amplitude!r} rad"),
                    ("Time function", function)]
        return [("Type", "distance"),
                ("First marker", self._marker_name(driver.first)),
                ("Second marker", self._marker_name(driver.second)),
                ("Initial distance", f"{driver.offset!r} m"),
                ("Distance speed", f"{driver.speed!r} m/s"),
                ("Distance amplitude", f"{driver.amplitude!r} m"),
                ("Time function", function)]

    def _load_sections(self):
        for s in self.springs:
            yield f"Spring {s.name}", [
                ("First marker", self._marker_name(s.first)),
                ("Second marker", self._marker_name(s.second)),
                ("Stiffness", f"{s.stiffness!r} N/m"),
                ("Damping", f"{s.damping!r} N s/m"),
                ("Reference length", f"{s.reference_length!r} m")]
        for s in self.rotational_springs:
            yield f"Rotational spring {s.name}", [
                ("Body", self._body_name(s.body)),
                ("Reference body", self._body_name(s.reference)),
                ("Stiffness", f"{s.stiffness!r} N m/rad"),
                ("Damping", f"{s.damping!r} N m s/rad"),
                ("Reference angle", f"{s.reference_angle!r} rad")]
        for f in self.forces:
            yield f"Force {f.name}", [
                ("Marker", self._marker_name(f.marker)),
                ("Vector", f"{f.vector.real!r} N, {f.vector.imag!r} N"),
                ("Axes", "body" if f.turns_with_body else "global"),
                ("Time function", f"cos({f.frequency!r}*t)")]
        for f in self.torques:
            yield f"Torque {f.name}", [
                ("Body", self._body_name(f.body)),
                ("Reference body", self._body_name(f.reference)),
                ("Torque", f"{f.torque!r} N m"),
                ("Time function", f"cos({f.frequency!r}*t)")]

    def _body_section(self, body):
        shift, turn = self.misplacement.get(body.name, (0j, 0.0))
        position = body.position + shift
        lines = [("Mass", f"{body.mass!r} kg"),
                 ("Moment of inertia", f"{body.inertia!r} kg m^2"),
                 ("Initial position", f"{position.real!r} m, {position.imag!r} m"),
                 ("Initial angle", f"{body.angle + turn!r} rad"),
                 ("Initial velocity", f"{body.velocity.real!r} m/s, {body.velocity.imag!r} m/s"),
                 ("Initial angular velocity", f"{body.angular_velocity!r} rad/s")]
        return f"Body {body.name}", lines

    @staticmethod
    def _markers_line(markers):
        return "; ".join(f"{name}: {p.real!r} m, {p.imag!r} m" for name, p in markers.items())

    def parameter_file(self, accuracy):
        """The text of the parameter file."""
        sections = [(f"Joint {j.name}", self._joint_lines(j)) for j in self.joints]
        sections += [(f"Driver {d.name}", self._driver_lines(d)) for d in self.drivers]
        sections += self._load_sections()
        # By now all markers have their names.
        for body in self.bodies:
            name, lines = self._body_section(body)
            if body.markers:
                lines.append(("Markers", self._markers_line(body.markers)))
            sections.append((name, lines))
        if self.ground_markers:
            sections.append(("Ground", [("Markers", self._markers_line(self.ground_markers))]))
        sections.append(("Dynamics", [("Cycle duration", f"{self.duration!r} s"),
                                      ("Maximum settling cycles", "0"),
                                      ("Samples per cycle", str(self.samples)),
                                      ("Accuracy", repr(accuracy))]))
        g = self.gravity
        top = [("Title", self.title), ("Cycles", "0"),
               ("Gravity", f"{g.real!r} m/s^2, {g.imag!r} m/s^2")]
        for title, entries in (("Bodies", self.bodies), ("Joints", self.joints),
                               ("Drivers", self.drivers), ("Springs", self.springs),
                               ("Rotational springs", self.rotational_springs),
                               ("Forces", self.forces), ("Torques", self.torques)):
            if entries:
                top.append((title, ", ".join(entry.name for entry in entries)))
        text = "".join(f"set {key} = {value}\n" for key, value in top)
        for name, lines in sections:
            text += f"subsection {name}\n"
            text += "".join(f"  set {key} = {value}\n" for key, value in lines)
            text += "end\n"
        return text
