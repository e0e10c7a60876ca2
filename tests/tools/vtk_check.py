#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Opens a CGNS file with VTK's reader, as a user of ParaView would, and prints what it found.

    vtk_check.py FILE                                       print one line per zone and patch
    vtk_check.py FILE --zones A=5x5x5 B=5x9x5 --families wall far
                                                            and compare: exit 0 same, 1 different

Families are those that the reader lists for the base; every patch that it loads must belong to one of
them.
Exit 77: VTK is not installed (Debian: python3-vtk9); any other: VTK could not read the file.
"""
import argparse
import sys

from vtk_reading import vtk


def children(block):
    """(name, metadata, child) of each block of a multi-block data set."""
    for index in range(block.GetNumberOfBlocks() if block else 0):
        metadata = block.GetMetaData(index)
        named = metadata is not None and metadata.Has(vtk.vtkCompositeDataSet.NAME())
        name = metadata.Get(vtk.vtkCompositeDataSet.NAME()) if named else ""
        yield name, metadata, block.GetBlock(index)


def size(grid):
    return "x".join(str(nodes) for nodes in grid.GetDimensions())


def read(path):
    reader = vtk.vtkCGNSReader()
    failures = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda _, kind: failures.append(kind))
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetLoadBndPatch(True)
    reader.EnableAllBases()
    reader.Update()
    selection = reader.GetFamilySelection()
    families = {selection.GetArrayName(i) for i in range(selection.GetNumberOfArrays())}
    if failures:
        print(f"VTK reports {failures[0]} for {path}")
        sys.exit(2)
    return reader.GetOutput(), families


def list_contents(output):
    """{zone: size} and {(zone, patch): (family, size)}."""
    zones, patches = {}, {}
    for _, _, base in children(output):
        for zone, _, block in children(base):
            if block.IsA("vtkStructuredGrid"):
                zones[zone] = size(block)
                continue
            for part, _, content in children(block):
                if part != "Patches":
                    zones[zone] = size(content)
                    continue
                for patch, metadata, grid in children(content):
                    key = vtk.vtkCGNSReader.FAMILY()
                    family = metadata.Get(key) if metadata.Has(key) else ""
                    patches[zone, patch] = family, size(grid)
    return zones, patches


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("file")
    parser.add_argument("--zones", nargs="*", help="expected: NAME=NIxNJxNK")
    parser.add_argument("--families", nargs="*", help="expected names")
    arguments = parser.parse_args()
    output, families = read(arguments.file)
    zones, patches = list_contents(output)
    for zone, extent in sorted(zones.items()):
        print(f"zone {zone} {extent}")
    for family in sorted(families):
        print(f"family {family}")
    for (zone, patch), (family, extent) in sorted(patches.items()):
        print(f"patch {zone}/{patch} {family} {extent}")
    wrong = False
    if arguments.zones is not None:
        expected = dict(zone.split("=", 1) for zone in arguments.zones)
        if expected != zones:
            print(f"expected zones {sorted(expected.items())}")
            wrong = True
    if arguments.families is not None:
        loaded = {family for family, _ in patches.values()}
        if families != set(arguments.families) or not loaded <= families:
            print(f"expected families {sorted(arguments.families)}, found {sorted(families)}, "
                  f"on patches {sorted(loaded)}")
            wrong = True
    return 1 if wrong or not zones else 0


if __name__ == "__main__":
    sys.exit(main())
