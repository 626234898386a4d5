# SPDX-License-Identifier: Apache-2.0
"""Frames as datasets of VTK and PyVista."""

from __future__ import annotations

from typing import Any

from kerf._kerf import Frame


def to_vtk(frame: Frame) -> Any:
    """Return the particles as a `vtkPolyData` with a vertex and all columns per particle.

    Vectors and tensors have the order of components that ParaView expects. The arrays share the
    memory of the frame, which the dataset keeps. VTK (python3-vtk9) must be installed.
    """
    # PyVista brings its own VTK, and so do other packages: import it only where it is asked for.
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    import numpy as np

    points = vtkPoints()
    points.SetData(numpy_to_vtk(frame["position"]))
    count = len(frame)
    cells = np.column_stack([np.ones(count, np.int64), np.arange(count, dtype=np.int64)])
    vertices = vtkCellArray()
    vertices.SetCells(count, numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(vertices)
    for name in frame.keys():
        if name != "position":
            array = numpy_to_vtk(frame[name])
            array.SetName(name)
            data.GetPointData().AddArray(array)
    data._kerf_frame = frame
    return data


def to_pyvista(frame: Frame) -> Any:
    """Return the particles as a `pyvista.PolyData` with all columns; PyVista must be installed."""
    import pyvista

    cloud = pyvista.PolyData(frame["position"])
    for name in frame.keys():
        if name != "position":
            cloud.point_data[name] = frame[name]
    return cloud
