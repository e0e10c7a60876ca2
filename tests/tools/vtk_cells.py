#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a .vts file with VTK and prints its size, its names, and what its cells hold:

    SIZE NAME cells=N folded=N least=CELL worst=CELL,CELL,...

LEAST is the cell of the least scaled Jacobian as VTK itself has it, counted from 0; WORST are the cells marked 1, 2,
... Exit 77: VTK is not installed (Debian: python3-vtk9).
"""
import sys

from vtk_reading import read, size_text, vtk


def values(data, name):
    array = data.GetArray(name)
    return [array.GetValue(n) for n in range(array.GetNumberOfTuples())]


def main():
    grid = read(vtk.vtkXMLStructuredGridReader(), sys.argv[1])
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
    name = grid.GetFieldData().GetAbstractArray("Name").GetValue(0)
    print(f"{size_text(grid)} {name} cells={grid.GetNumberOfCells()} folded={int(sum(folded))} least={least} "
          f"worst={','.join(str(n) for _, n in worst)}")


if __name__ == "__main__":
    main()
