# SPDX-License-Identifier: LGPL-2.1-or-later

"""Arithmetic of units, independent of the one that the program uses.

Only the units that mutate_parameters.py writes, and those of the files that it
begins with, are known here. A unit is (factor to SI, exponents of kg, m, s, rad, K, A):
radians count as a dimension, as they do in the program, so that 30 Hz is no angular
speed.
"""

import math
import re

BASES = ("kg", "m", "s", "rad", "K", "A")


class UnknownUnit(Exception):
    """Something that is not in the table or breaks the grammar."""


def dimension(text):
    """The exponents of 'kg m2 s-2'."""
    exponents = dict.fromkeys(BASES, 0)
    for base, exponent in re.findall(r"([a-zA-Z]+)(-?\d+)?", text):
        exponents[base] += int(exponent or 1)
    return tuple(exponents[base] for base in BASES)


POUND, INCH, GRAVITY = 0.45359237, 0.0254, 9.80665

#: Name -> (factor, exponents, whether prefixes may stand before it).
UNITS = {
    name: (factor, dimension(exponents), prefixed)
    for names, factor, exponents, prefixed in (
        ("m meter metre meters", 1, "m", True),
        ("g gram", 1e-3, "kg", True),
        ("s sec second seconds", 1, "s", True),
        ("rad radian", 1, "rad", True),
        ("K kelvin", 1, "K", True),
        ("degC", 1, "K", False),
        ("A ampere", 1, "A", True),
        ("N newton newtons", 1, "kg m s-2", True),
        ("Pa pascal", 1, "kg m-1 s-2", True),
        ("Nm", 1, "kg m2 s-2", False),  # of a wear coefficient
        ("J joule", 1, "kg m2 s-2", True),
        ("W watt", 1, "kg m2 s-3", True),
        ("Hz hertz", 1, "s-1", True),
        ("V volt", 1, "kg m2 s-3 A-1", True),
        ("L l", 1e-3, "m3", True),
        ("bar", 1e5, "kg m-1 s-2", True),
        ("t", 1e3, "kg", False),
        ("min minute", 60, "s", False),
        ("h hr hour", 3600, "s", False),
        ("d day", 86400, "s", False),
        ("deg degree degrees °", math.pi / 180, "rad", False),
        ("turn revolution", 2 * math.pi, "rad", False),
        ("rpm", 2 * math.pi / 60, "rad s-1", False),
        ("in inch", INCH, "m", False),
        ("ft foot", 12 * INCH, "m", False),
        ("lb", POUND, "kg", False),
        ("lbf", POUND * GRAVITY, "kg m s-2", False),
        ("psi", POUND * GRAVITY / INCH**2, "kg m-1 s-2", False),
        ("1", 1, "", False),
    )
    for name in names.split()
}

PREFIXES = {
    "T": 1e12, "G": 1e9, "M": 1e6, "k": 1e3, "h": 1e2, "d": 1e-1, "c": 1e-2,
    "m": 1e-3, "u": 1e-6, "n": 1e-9, "p": 1e-12, "f": 1e-15,
    "giga": 1e9, "mega": 1e6, "kilo": 1e3, "milli": 1e-3, "micro": 1e-6,
}  # fmt: skip

TOKEN = re.compile(r"\s*(\*\*|\^|[-*/().]|[a-zA-Z]+|°|\d+)")


def find_unit(name):
    """(factor, exponents) of a name, with or without a prefix."""
    if name in UNITS:
        return UNITS[name][:2]
    for prefix, factor in PREFIXES.items():
        rest = UNITS.get(name[len(prefix) :]) if name.startswith(prefix) else None
        if rest and rest[2]:
            return factor * rest[0], rest[1]
    raise UnknownUnit(name)


class Parser:
    """Products and quotients from left to right, powers, parentheses."""

    def __init__(self, text):
        self.tokens = []
        place = 0
        while text[place:].strip():
            token = TOKEN.match(text, place)
            if not token:
                raise UnknownUnit(text)
            self.tokens.append(token.group(1))
            place = token.end()
        self.place = 0

    def next(self):
        return self.tokens[self.place] if self.place < len(self.tokens) else None

    def take(self):
        token = self.next()
        if token is None:
            raise UnknownUnit("ends too early")
        self.place += 1
        return token

    def integer(self):
        sign = -1 if self.next() == "-" else 1
        if sign < 0:
            self.take()
        token = self.take()
        if not token.isdigit() or len(token) > 2:
            raise UnknownUnit(token)
        return sign * int(token)

    def factor(self):
        token = self.take()
        if token == "(":
            unit = self.product()
            if self.take() != ")":
                raise UnknownUnit("a parenthesis is not closed")
        else:
            unit = find_unit(token)
        following = self.next()
        power = 1
        if following in ("^", "**"):
            self.take()
            power = self.integer()
        elif token != "1" and following and (following.isdigit() or following == "-"):
            power = self.integer()
        try:
            return unit[0] ** power, tuple(power * e for e in unit[1])
        except OverflowError as error:
            raise UnknownUnit(token) from error

    def product(self):
        factor, exponents = self.factor()
        while self.next() not in (None, ")"):
            sign = -1 if self.next() == "/" else 1
            if self.next() in ("/", "*", "."):
                self.take()
            other = self.factor()
            factor *= other[0] ** sign
            exponents = tuple(a + sign * b for a, b in zip(exponents, other[1]))
        return factor, exponents


def parse_unit(text):
    """(factor, exponents) of 'mm^3/(N m)'. Raises UnknownUnit."""
    parser = Parser(text)
    try:
        unit = parser.product()
    except RecursionError as error:
        raise UnknownUnit(text) from error
    if parser.next() is not None:
        raise UnknownUnit(text)
    return unit
