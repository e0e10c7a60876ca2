#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a .vtm file with VTK and prints a line per structured grid in it:

    BLOCK/NAME SIZE SUM FIELD=VALUE ...

SUM adds all coordinates in the order of the file, so that one bit that is wrong shows. Exit 77: VTK is not installed
(Debian: python3-vtk9); any other: VTK could not read the file.
"""
import sys

from vtk_reading import read, size_text, vtk


def number(value):
    """As C++ prints a double that has no fraction: without '.0'."""
    text = repr(value)
    return text[:-2] if text.endswith(".0") else text


def describe(grid):
    total = 0.0
    for n in range(grid.GetNumberOfPoints()):
        for coordinate in grid.GetPoint(n):
            total += coordinate
    data = grid.GetFieldData()
    fields = {}
    for n in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(n)
        fields[array.GetName()] = array.GetValue(0)
    return " ".join([size_text(grid), number(total)] + [f"{key}={fields[key]}" for key in sorted(fields)])


def walk(block, path):
    for index in range(block.GetNumberOfBlocks()):
        name = block.GetMetaData(index).Get(vtk.vtkCompositeDataSet.NAME())
        child = block.GetBlock(index)
        here = path + [name]
        if child is None:
            print("/".join(here), "is empty")
        elif child.IsA("vtkMultiBlockDataSet"):
            walk(child, here)
        else:
            print("/".join(here), describe(child))


def main():
    walk(read(vtk.vtkXMLMultiBlockDataReader(), sys.argv[1]), [])


if __name__ == "__main__":
    main()
