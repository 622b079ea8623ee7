#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the table of prm/four_stroke_slider_crank.prm: the gas force on a piston.

An idealised indicator diagram of a four-stroke engine with spark ignition over 720 deg of
crank angle theta, 0 where it fires. With the volume

    V = V_c + A (r (1 - cos theta) + l - sqrt(l^2 - r^2 sin^2 theta)),
    V_c = 2 r A/(compression ratio - 1),

the pressure is

    compression   p_c = p_0 (V_max/V)^n_c     540 to 720 deg, polytropic
    expansion     p_e = p_3 (V_c/V)^n_e       0 to 140 deg, polytropic from
                                              p_3 = (pressure ratio) p_c(0)
    combustion    (1 - w) p_c + w p_e         -15 to 25 deg
    blow-down     (1 - w) p_e + w p_0         140 to 200 deg
    gas exchange  p_0                         200 to 540 deg

with w from 0 to 1 like (1 - cos)/2. With w a step at 0 deg and at 180 deg it is the Otto
cycle; that pressures of burnt and unburnt mixture are blended is the model of Eriksson
and Andersson (SAE 2002-01-0371). The force is (p - p_0) A.

Usage: four_stroke_gas.py > prm/tables/four_stroke_gas.csv
"""

import math

# Ours, illustrative, but for the air; exponents are the usual ones of engines.
BORE, CRANK, ROD = 60e-3, 25e-3, 90e-3  # [m]
SPEED = 1500 / 60  # [turns/s]
COMPRESSION_RATIO, PRESSURE_RATIO = 8.0, 3.0
N_COMPRESSION, N_EXPANSION = 1.32, 1.28
ATMOSPHERE = 1.01325e5  # [Pa]
COMBUSTION, BLOW_DOWN, INTAKE_CLOSES = (-15.0, 25.0), (140.0, 200.0), 540.0  # [deg]
STEP = 3  # [deg]

AREA = math.pi * BORE**2 / 4
CLEARANCE_VOLUME = 2 * CRANK * AREA / (COMPRESSION_RATIO - 1)


def volume(degrees):
    theta = math.radians(degrees)
    travel = CRANK * (1 - math.cos(theta)) + ROD
    travel -= math.sqrt(ROD**2 - (CRANK * math.sin(theta)) ** 2)
    return CLEARANCE_VOLUME + AREA * travel


def compression(degrees):
    return ATMOSPHERE * (volume(180) / volume(degrees)) ** N_COMPRESSION


def expansion(degrees):
    highest = PRESSURE_RATIO * compression(0)
    return highest * (CLEARANCE_VOLUME / volume(degrees)) ** N_EXPANSION


def blend(degrees, interval):
    """From 0 at the beginning of the interval to 1 at its end."""
    begin, end = interval
    x = min(max((degrees - begin) / (end - begin), 0.0), 1.0)
    return (1 - math.cos(math.pi * x)) / 2


def pressure(degrees):
    """@param degrees in [-180, 540)."""
    burnt = blend(degrees, COMBUSTION)
    closed = (1 - burnt) * compression(degrees) + burnt * expansion(degrees)
    opened = blend(degrees, BLOW_DOWN)
    return (1 - opened) * closed + opened * ATMOSPHERE


def main():
    print("# Gas force on the piston of prm/four_stroke_slider_crank.prm, by")
    print("# doc/four_stroke_gas.py, which has the formulas. crank_angle 0: it fires.")
    print("time [ms], crank_angle [deg], pressure [bar], force [N]")
    for degrees in range(0, 720 + STEP, STEP):
        p = pressure(degrees if degrees < INTAKE_CLOSES else degrees - 720)
        print(
            f"{degrees / 360 / SPEED * 1e3:.10g}, {degrees}, {p / 1e5:.6g}, "
            f"{(p - ATMOSPHERE) * AREA:.7g}"
        )


if __name__ == "__main__":
    main()
