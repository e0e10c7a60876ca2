#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a .vtm file with VTK and prints a line per structured grid in it:

    BLOCK/NAME SIZE SUM FIELD=VALUE ...

SUM adds all coordinates in the order of the file, so that one bit that is wrong shows. Exit 77: VTK is not installed
(Debian: python3-vtk9); any other: VTK could not read the file.
"""
import sys

try:
    import vtk
except ImportError:
    print("skipped: VTK's Python modules are not installed (Debian: python3-vtk9)")
    sys.exit(77)


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
    size = "x".join(str(nodes) for nodes in grid.GetDimensions())
    return " ".join([size, number(total)] + [f"{key}={fields[key]}" for key in sorted(fields)])


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
    reader = vtk.vtkXMLMultiBlockDataReader()
    failures = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda _, kind: failures.append(kind))
    reader.SetFileName(sys.argv[1])
    reader.Update()
    if failures:
        print(f"VTK reports {failures[0]}")
        return 2
    walk(reader.GetOutput(), [])
    return 0


if __name__ == "__main__":
    sys.exit(main())
