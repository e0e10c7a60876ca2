#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the measures that stand at the cells of .vts files with those of VTK's own vtkMeshQuality.

    vtk_quality.py FILE...

The files have the cell arrays scaled_jacobian, jacobian, volume and skip (1: not to be compared, for a corner is flat
or at a pole). VTK takes the least of a hexahedron's corners and of its centre, hexweave of the corners alone; so the
centre is worked out here as well, from the mean edges. Prints how many cells were compared and the greatest relative
difference of each measure over all files. Exit 77: VTK is not installed (Debian: python3-vtk9); any other: VTK could
not read a file.
"""
import sys

from vtk_reading import read, vtk

try:
    import numpy
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    print("skipped: numpy is not installed (Debian: python3-numpy)")
    sys.exit(77)


def theirs(grid, hexahedron, quadrilateral):
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(grid)
    getattr(quality, f"SetHexQualityMeasureTo{hexahedron}")()
    getattr(quality, f"SetQuadQualityMeasureTo{quadrilateral}")()
    quality.Update()
    return vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))


def corners_of(grid):
    """(cells, 8, 3): the corners of every hexahedron, bit a of a corner's number set at the high end of axis a."""
    ni, nj, nk = grid.GetDimensions()
    x = vtk_to_numpy(grid.GetPoints().GetData()).reshape(nk, nj, ni, 3)
    return numpy.stack([x[c >> 2:nk - 1 + (c >> 2), (c >> 1) & 1:nj - 1 + ((c >> 1) & 1), c & 1:ni - 1 + (c & 1)]
                        .reshape(-1, 3) for c in range(8)], axis=1)


def trilinear(corners, at):
    weights = [numpy.prod([at[a] if c >> a & 1 else 1 - at[a] for a in range(3)]) for c in range(8)]
    return numpy.tensordot(corners, weights, axes=([1], [0]))


def at_centres(corners):
    """Jacobian and scaled Jacobian at the centre of every hexahedron."""
    edges = [numpy.mean([corners[:, c | 1 << a] - corners[:, c] for c in range(8) if not c >> a & 1], axis=0)
             for a in range(3)]
    jacobian = (numpy.cross(edges[0], edges[1]) * edges[2]).sum(axis=1)
    return jacobian, jacobian / numpy.prod([numpy.linalg.norm(edge, axis=1) for edge in edges], axis=0)


def volumes(corners):
    """VTK's volume of a hexahedron is the Jacobian at its centre. That of a small one round each of eight Gauss points
    gives the Jacobian there, and their mean the integral, exactly."""
    half = 0.1
    order = (0, 1, 3, 2, 4, 5, 7, 6)
    total = numpy.zeros(len(corners))
    for point in range(8):
        centre = [0.5 + (0.5 if point >> a & 1 else -0.5) / numpy.sqrt(3) for a in range(3)]
        around = [trilinear(corners, [centre[a] + (half if c >> a & 1 else -half) for a in range(3)]) for c in order]
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(numpy.stack(around, axis=1).reshape(-1, 3), deep=True))
        cells = vtk.vtkCellArray()
        cells.SetData(8, numpy_to_vtk(numpy.arange(8 * len(corners)), deep=True, array_type=vtk.VTK_ID_TYPE))
        grid = vtk.vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.SetCells(vtk.VTK_HEXAHEDRON, cells)
        total += theirs(grid, "Volume", "Area") / (2 * half) ** 3
    return total / 8


def compare(grid, worst):
    """Returns how many cells were compared."""
    ours = {name: vtk_to_numpy(grid.GetCellData().GetArray(name))
            for name in ("scaled_jacobian", "jacobian", "volume", "skip")}
    if grid.GetDimensions()[2] == 1:
        area = theirs(grid, "Volume", "Area")
    else:
        corners = corners_of(grid)
        area = volumes(corners)
        centre, scaled_centre = at_centres(corners)
        ours["jacobian"] = numpy.minimum(ours["jacobian"], centre)
        ours["scaled_jacobian"] = numpy.minimum(ours["scaled_jacobian"], scaled_centre)
    found = {"scaled_jacobian": theirs(grid, "ScaledJacobian", "ScaledJacobian"),
             "jacobian": theirs(grid, "Jacobian", "Jacobian"), "volume": area}
    compared = ours["skip"] == 0
    for name, values in found.items():
        a, b = values[compared], ours[name][compared]
        worst[name] = max(worst[name], (abs(a - b) / numpy.maximum(abs(a), abs(b))).max())
    return int(compared.sum())


def main():
    worst = {"scaled_jacobian": 0.0, "jacobian": 0.0, "volume": 0.0}
    cells = sum(compare(read(vtk.vtkXMLStructuredGridReader(), path), worst) for path in sys.argv[1:])
    print(cells, *(f"{difference:.1e}" for difference in worst.values()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
