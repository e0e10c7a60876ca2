# SPDX-License-Identifier: Apache-2.0
"""What the tools that read our files with VTK share. Importing it exits with 77 where VTK is not installed (Debian:
python3-vtk9)."""
import sys

try:
    import vtk
except ImportError:
    print("skipped: VTK's Python modules are not installed (Debian: python3-vtk9)")
    sys.exit(77)


def read(reader, path):
    """What an XML reader of VTK makes of a file; exits with 2, and says so, where VTK has anything to report."""
    failures = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda _, kind: failures.append(kind))
    reader.SetFileName(path)
    reader.Update()
    if failures:
        print(f"VTK reports {failures[0]}")
        sys.exit(2)
    return reader.GetOutput()


def size_text(grid):
    """The nodes of a structured grid: 17x9x1."""
    return "x".join(str(nodes) for nodes in grid.GetDimensions())
