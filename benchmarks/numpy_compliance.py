# SPDX-License-Identifier: LGPL-2.1-or-later

"""The compliance of the unworn ring as a careful user would script it: quadratic
cells assembled with NumPy, SciPy's sparse factor, one solution per bore node."""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg

# Gauss points and quadratic shape functions on [0, 1], and their derivatives.
POINTS = 0.5 + np.sqrt(0.15) * np.array([-1, 0, 1])
WEIGHTS = np.array([5, 8, 5]) / 18
VALUES = np.array(
    [(1 - POINTS) * (1 - 2 * POINTS), 4 * POINTS * (1 - POINTS), POINTS * (2 * POINTS - 1)]
)
SLOPES = np.array([4 * POINTS - 3, 4 - 8 * POINTS, 4 * POINTS - 1])


def compliance(radii, cells, modulus, poisson):
    """Plane strain, clamped at the last of the @p radii of the layers [m]; normal
    displacement of the bore nodes by unit forces along their normals."""
    layers = len(radii) - 1
    radii = np.insert(radii, range(1, len(radii)), (radii[1:] + radii[:-1]) / 2)
    angles = np.pi * np.arange(2 * cells) / cells
    directions = np.array([np.cos(angles), np.sin(angles)])
    # Node (j, i): on the j-th circle, the i-th around.
    x = np.einsum("j,di->jid", radii, directions).reshape(-1, 2)
    j, i = np.meshgrid(range(0, 2 * layers, 2), range(0, 2 * cells, 2), indexing="ij")
    nodes = np.stack(
        [
            ((j + b) * 2 * cells + (i + a) % (2 * cells)).ravel()
            for b in range(3)
            for a in range(3)
        ],
        axis=1,
    )
    # Derivatives on the reference cell: of shape function, by direction, at point.
    reference = np.stack(
        [
            np.einsum("bp,aq->bapq", SLOPES, VALUES).reshape(9, 9),
            np.einsum("bp,aq->bapq", VALUES, SLOPES).reshape(9, 9),
        ],
        axis=1,
    )
    jacobians = np.einsum("cnd,nep->cpde", x[nodes], reference)
    gradients = np.einsum("nep,cped->cpnd", reference, np.linalg.inv(jacobians))
    dx = np.abs(np.linalg.det(jacobians)) * np.outer(WEIGHTS, WEIGHTS).ravel()
    mu = modulus / (2 * (1 + poisson))
    lame = modulus * poisson / ((1 + poisson) * (1 - 2 * poisson))
    weighted = gradients * dx[:, :, None, None]
    products = np.einsum("cpnd,cpme->cnmde", weighted, gradients, optimize=True)
    cell = lame * products + mu * products.transpose(0, 1, 2, 4, 3)
    trace = mu * np.einsum("cnmdd->cnm", products)
    cell += trace[..., None, None] * np.eye(2)
    cell = cell.transpose(0, 1, 3, 2, 4).reshape(-1, 18, 18)
    dofs = (2 * nodes[:, :, None] + np.arange(2)).reshape(-1, 18)
    rows = np.broadcast_to(dofs[:, :, None], cell.shape)
    columns = np.broadcast_to(dofs[:, None, :], cell.shape)
    matrix = scipy.sparse.csc_matrix((cell.ravel(), (rows.ravel(), columns.ravel())))
    free = 2 * (len(x) - 2 * cells)
    factor = scipy.sparse.linalg.splu(
        matrix[:free, :free], permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}
    )
    loads = np.zeros((free, 2 * cells))
    around = np.arange(2 * cells)
    loads[2 * around, around], loads[2 * around + 1, around] = directions
    return loads.T @ factor.solve(loads)
