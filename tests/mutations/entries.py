# SPDX-License-Identifier: LGPL-2.1-or-later

"""What the entries of a parameter file are, independent of the program.

By hand from the meaning of each entry in the manual, not from its source: mutate_parameters.py
finds with this table what the program has accepted and should not have. A kind is a
dimension ('kg m2 s-2'; '1' for a number without one), 'point DIMENSION' for two
quantities, 'markers', 'integer', 'name', 'names', 'expression', 'word' or 'text'.
"""

import math
import re

from units import UnknownUnit, dimension, parse_unit

NAMED = (
    "Body",
    "Joint",
    "Spring",
    "Rotational spring",
    "Driver",
    "Force",
    "Torque",
    "Material",
    "Bushing",
    "Load case",
    "Watched marker",
)

#: Kind of subsection -> entry -> kind of value. 'Bushing/Mesh' is one in another.
TABLE = {
    "": {
        "Title": "text",
        "Cycles": "integer",
        "Gravity": "point m s-2",
        "Bodies": "names",
        "Joints": "names",
        "Springs": "names",
        "Rotational springs": "names",
        "Drivers": "names",
        "Forces": "names",
        "Torques": "names",
        "Materials": "names",
        "Bushings": "names",
        "Watched markers": "names",
        "Load cases": "names",
        "Order of load cases": "word",
        "Stop at time": "s",
        "Operating share": "1",
        "Ambient temperature": "K",
    },
    "Load case": {
        "Cycles": "1",
        "Duration": "s",
        "Share": "1",
        "Wear coefficient factor": "1",
        "Gravity": "point m s-2",
        "Ambient temperature": "K",
    },
    "Ground": {"Markers": "markers"},
    "Body": {
        "Mass": "kg",
        "Moment of inertia": "kg m2",
        "Markers": "markers",
        "Initial position": "point m",
        "Initial angle": "rad",
        "Initial velocity": "point m s-1",
        "Initial angular velocity": "rad s-1",
    },
    "Joint": {
        "Type": "word",
        "Pin marker": "name",
        "Bushing marker": "name",
        "Model": "word",
        "Pin radius": "m",
        "Bushing radius": "m",
        "Pin material": "name",
        "Bushing material": "name",
        "Contact force law": "word",
        "Radii of contact stiffness": "word",
        "Worn contact geometry": "word",
        "Restitution coefficient": "1",
        "Contact stiffness": "kg s-2",
        "Contact damping": "kg s-1",
        "Foundation length": "m",
        "Foundation thickness": "m",
        "Foundation modulus": "kg m-1 s-2",
        "Capture speed": "m s-1",
        "Minimum approach speed": "m s-1",
        "Friction law": "word",
        "Friction coefficient": "1",
        "Friction regularisation speed": "m s-1",
        "Tangential damping": "kg s-1",
        "Friction lower speed": "m s-1",
        "Friction upper speed": "m s-1",
        "Static friction coefficient": "1",
        "Stribeck speed": "m s-1",
        "Viscous friction": "s m-1",
        "Bristle stiffness": "m-1",
        "Bristle damping": "s m-1",
        "First marker": "name",
        "Second marker": "name",
        "Axis": "rad",
        "Relative angle": "rad",
    },
    "Spring": {
        "First marker": "name",
        "Second marker": "name",
        "Stiffness": "kg s-2",
        "Reference length": "m",
        "Force at reference length": "kg m s-2",
        "Damping": "kg s-1",
    },
    "Rotational spring": {
        "Body": "name",
        "Reference body": "name",
        "Stiffness": "kg m2 s-2 rad-1",
        "Reference angle": "rad",
        "Torque at reference angle": "kg m2 s-2",
        "Damping": "kg m2 s-1 rad-1",
    },
    "Driver": {
        "Type": "word",
        "Body": "name",
        "Reference body": "name",
        "Speed": "rad s-1",
        "Initial angle": "rad",
        "Angle amplitude": "rad",
        "First marker": "name",
        "Second marker": "name",
        "Initial distance": "m",
        "Distance speed": "m s-1",
        "Distance amplitude": "m",
        "Time function": "expression",
        "Table": "text",
        "Table column": "text",
        "Table period": "s",
        "Interpolation": "word",
    },
    "Force": {
        "Marker": "name",
        "Vector": "point kg m s-2",
        "Axes": "word",
        "Time function": "expression",
        "Table": "text",
        "Table column": "text",
        "Table period": "s",
        "Interpolation": "word",
    },
    "Torque": {
        "Body": "name",
        "Reference body": "name",
        "Torque": "kg m2 s-2",
        "Time function": "expression",
        "Table": "text",
        "Table column": "text",
        "Table period": "s",
        "Interpolation": "word",
    },
    "Material": {
        "Young's modulus": "kg m-1 s-2",
        "Poisson's ratio": "1",
        "Density": "kg m-3",
        "Thermal conductivity": "kg m s-3 K-1",
        "Thermal expansion": "K-1",
        "Maximum pressure": "kg m-1 s-2",
        "Maximum speed": "m s-1",
        "Maximum pv": "kg s-3",
        "Maximum temperature": "K",
    },
    "Bushing": {
        "Duty cycle file": "text",
        "Axial length": "m",
        "Outer radius": "m",
        "Plane state": "word",
        "Pressure model": "word",
        "Pin": "word",
        "Pin hole radius": "m",
        "Element degree": "integer",
        "Stiffness solver": "word",
        "Wear coefficient": "kg-1 m s2",
        "Wear coefficient table": "text",
        "Wear coefficient basis": "word",
        "Pin wear coefficient": "kg-1 m s2",
        "Wear coefficient factor": "expression",
        "Pin wear coefficient factor": "expression",
        "Running-in factor": "1",
        "Running-in distance": "m",
        "Stop at maximum depth": "m",
        "Stop at clearance": "m",
        "Stop at worn volume": "m3",
        "Stop at worn mass": "kg",
        "Comparison source": "text",
        "Comparison maximum depth": "m",
        "Comparison worn mass": "kg",
        "Outer shape": "word",
        "Second semi-axis": "m",
        "Outer centre": "point m",
        "Outer support": "word",
        "Foundation normal stiffness": "kg m-2 s-2",
        "Foundation tangential stiffness": "kg m-2 s-2",
        "Housing gap": "m",
    },
    "Watched marker": {"Stop at deviation": "m"},
    "Bushing/Heat": {
        "Temperature": "word",
        "Rim": "word",
        "Heat transfer coefficient": "kg s-3 K-1",
        "Thermal resistance": "kg-1 m-2 s3 K",
        "Shaft conductance": "kg m2 s-3 K-1",
        "Reference temperature": "K",
        "Modulus factor": "expression",
        "Friction factor": "expression",
        "Temperature tolerance": "K",
    },
    "Bushing/Mesh": {
        "Bore cells": "integer",
        "Radial cells": "integer",
        "Grading": "1",
        "Nodes across contact": "integer",
        "Sector refinements": "integer",
        "Refined sector": "point rad",
        "File": "text",
        "Bore boundary id": "integer",
        "Rim boundary id": "integer",
        "File length unit": "m",
        "File refinements": "integer",
    },
    "Bushing/Contact solver": {
        "Tolerance": "1",
        "Maximum iterations": "integer",
        "Maximum linearisations": "integer",
    },
    "Dynamics": {
        "Analysis": "word",
        "Cycle duration": "s",
        "Joint motion": "word",
        "Accuracy": "1",
        "Maximum order": "integer",
        "Samples per cycle": "integer",
        "Sampling tolerance": "1",
        "Settling tolerance": "1",
        "Maximum settling cycles": "integer",
        "Averaged cycles": "integer",
        "Maximum steps per cycle": "integer",
        "Start": "word",
        "Energy balance": "word",
    },
    "Wear": {
        "Scheme": "word",
        "Extrapolation": "word",
        "Tolerance": "1",
        "Cycles per step": "1",
        "Compliance update": "1",
        "Mesh error estimate": "word",
        "Dynamics update": "1",
    },
    "Output": {"Directory": "text", "Number of outputs": "integer"},
}

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
#: Functions of expressions that take several values.
SEVERAL = re.compile(r"(?:min|max|if|atan2|pow|sum|avg)\s*$")


def kind_of(subsections, name):
    """The kind of value of an entry, None if there is no such entry."""
    section = list(subsections)
    if section:
        # A load case repeats other subsections.
        if section[0].startswith("Load case ") and len(section) > 1:
            return kind_of(section[1:], name)
        for named in sorted(NAMED, key=len, reverse=True):
            if section[0].startswith(named + " "):
                section[0] = named
                break
    return TABLE.get("/".join(section), {}).get(name)


def fault_of_quantity(text, wanted):
    """What is wrong with an accepted quantity, None if nothing is."""
    number = NUMBER.match(text)
    if not number:
        return f"'{text}' does not begin with a number"
    value, unit_text = float(number.group()), text[number.end() :].strip()
    if wanted == "1":
        return f"'{text}' is more than a number" if unit_text else None
    if not unit_text:
        return f"'{text}' has no unit"
    try:
        factor, exponents = parse_unit(unit_text)
    except UnknownUnit:
        return f"'{text}' has no unit that is known here"
    if exponents != dimension(wanted):
        return f"'{text}' has not the dimension {wanted}"
    if not math.isfinite(value * factor):
        return f"'{text}' is not finite"
    return None


def fault_of_point(text, wanted):
    parts = text.split(",")
    if len(parts) != 2:
        return f"'{text}' is not two quantities"
    faults = [fault_of_quantity(part.strip(), wanted) for part in parts]
    return faults[0] or faults[1]


def fault_of_markers(text):
    for item in filter(str.strip, text.split(";")):
        name, colon, place = item.partition(":")
        if not colon or not re.fullmatch(r"\s*[\w+-]+\s*", name, re.ASCII):
            return f"'{item}' is no marker"
        fault = fault_of_point(place, "m")
        if fault:
            return fault
    return None


def fault_of_expression(text):
    """A comma that is not between the values of a function, as in '0,5*t'."""
    opened = []
    for place, character in enumerate(text):
        if character == "(":
            opened.append(bool(SEVERAL.search(text[:place])))
        elif character == ")" and opened:
            opened.pop()
        elif character == "," and not (opened and opened[-1]):
            return f"'{text}' has a comma outside of a function"
    return None


def fault_of_value(kind, text):
    """What is wrong with an accepted value of that kind, None if nothing is."""
    if kind in ("text", "word", "name", "names"):
        return None
    if kind == "markers":
        return fault_of_markers(text)
    if kind == "integer":
        return None if re.fullmatch(r"\d+", text, re.ASCII) else f"'{text}' is no integer"
    if kind == "expression":
        return fault_of_expression(text)
    if kind.startswith("point "):
        return fault_of_point(text, kind[len("point ") :])
    return fault_of_quantity(text, kind)
