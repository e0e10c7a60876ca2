#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a .vts file with VTK and prints its size, its names, and what its cells hold:

    SIZE NAME cells=N folded=N least=CELL worst=CELL,CELL,...

LEAST is the cell of the least scaled Jacobian as VTK itself has it, counted from 0; WORST are the cells marked 1, 2,
... Exit 77: VTK is not installed (Debian: python3-vtk9).
"""
import sys

try:
    import vtk
except ImportError:
    print("skipped: VTK's Python modules are not installed (Debian: python3-vtk9)")
    sys.exit(77)


def values(data, name):
    array = data.GetArray(name)
    return [array.GetValue(n) for n in range(array.GetNumberOfTuples())]


def main():
    reader = vtk.vtkXMLStructuredGridReader()
    failures = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda _, kind: failures.append(kind))
    reader.SetFileName(sys.argv[1])
    reader.Update()
    if failures:
        print(f"VTK reports {failures[0]}")
        return 2
    grid = reader.GetOutput()
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(grid)
    quality.SetQuadQualityMeasureToScaledJacobian()
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    theirs = values(quality.GetOutput().GetCellData(), "Quality")
    folded = values(grid.GetCellData(), "folded")
    marks = values(grid.GetCellData(), "worst")
    least = min(range(len(theirs)), key=lambda n: theirs[n])
    worst = sorted((rank, n) for n, rank in enumerate(marks) if rank)
    size = "x".join(str(nodes) for nodes in grid.GetDimensions())
    name = grid.GetFieldData().GetAbstractArray("Name").GetValue(0)
    print(f"{size} {name} cells={grid.GetNumberOfCells()} folded={int(sum(folded))} least={least} "
          f"worst={','.join(str(n) for _, n in worst)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
