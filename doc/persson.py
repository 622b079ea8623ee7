#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pressure between a disc and the hole of an infinite plate of the same material.

Persson's problem (1964): no friction, small clearance dR, load Q per length. A
pressure p cos(n t) presses hole and disc apart by (2R/E') 2n/(n^2-1) p cos(n t),
n >= 2, and by (2R/E') p for n = 0. Twice differentiated and added to itself, the
condition of contact dR - d cos t + u(t) = 0 becomes, with the operator
|D| cos(n t) = n cos(n t),

    2 |D| p = A + B cos t,   A = E' dR/(2R) + p_0,   B = 2 p_1 = 2 Q/(pi R),

on the arc of contact, p = 0 at its ends. In s = tan(t/2)/tan(a/2), |D| of
sqrt(1-s^2) U_k(s) is a multiple of U_k(s) (Chebyshev polynomials of the second
kind), so that a quadrature with n points gives n digits or so.

Prints, for each E' dR/Q: half-angle a [deg], peak pressure p R/Q, integral of the
pressure over its force. Needs python3-numpy.
"""

import sys

import numpy as np


def solve_for_half_angle(half_angle, n=200):
    """E' dR/Q, peak p R/Q and integral of p R dt/Q."""
    b = np.tan(half_angle / 2)
    k = np.arange(1, n + 1)
    phi = k * np.pi / (n + 1)
    # Of integrals of f(s) sqrt(1-s^2).
    weights = np.pi / (n + 1) * np.sin(phi) ** 2
    t = b * np.cos(phi)
    cosine = (1 - t * t) / (1 + t * t)
    angle_per_s = 2 * b / (1 + t * t)

    chebyshev = np.sin(np.outer(phi, k)) / np.sin(phi)[:, None]
    right_hand_sides = np.stack([1 / (1 + t * t), cosine / (1 + t * t)], 1)
    coefficients = (
        (2 / np.pi)
        * (chebyshev.T @ (weights[:, None] * right_hand_sides))
        * b
        / k[:, None]
    )
    pressure = chebyshev @ coefficients
    p_0 = (weights * angle_per_s) @ pressure / (2 * np.pi)
    p_1 = (weights * angle_per_s * cosine) @ pressure / np.pi

    factors = np.array([1.0, 2 * p_1[0] / (1 - 2 * p_1[1])])
    load = np.pi * factors[1] / 2
    ratio = 4 * (1 - p_0 @ factors) / (np.pi * factors[1])
    peak = np.sin(k * np.pi / 2) @ (coefficients @ factors) / load
    return ratio, peak, 2 * np.pi * (p_0 @ factors) / load


def find_half_angle(ratio):
    """By bisection: the ratio falls as the half-angle grows."""
    low, high = 1e-3, 1.6
    while high - low > 1e-14:
        middle = 0.5 * (low + high)
        if solve_for_half_angle(middle)[0] > ratio:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


if __name__ == "__main__":
    ratios = [float(x) for x in sys.argv[1:]] or [0, 0.1, 0.2, 0.5, 1, 2, 5]
    for ratio in ratios:
        half_angle = find_half_angle(ratio)
        _, peak, integral = solve_for_half_angle(half_angle)
        print(f"{ratio:g}  {np.degrees(half_angle):.7f}  {peak:.9f}  {integral:.9f}")
