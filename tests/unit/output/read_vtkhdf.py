# SPDX-License-Identifier: Apache-2.0
"""Reads a VTKHDF file with VTK's own reader and prints what it found as JSON."""
import json
import math
import sys

from vtkmodules.vtkIOHDF import vtkHDFReader



def rows(array):
    """The tuples of a VTK array; single numbers where it has one component."""
    tuples = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
    tuples = [tuple(None if math.isnan(x) else x for x in t) for t in tuples]
    return [t[0] for t in tuples] if array.GetNumberOfComponents() == 1 else tuples


reader = vtkHDFReader()
if not reader.CanReadFile(sys.argv[1]):
    sys.exit("vtkHDFReader cannot read " + sys.argv[1])
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
data = grid.GetPointData()
fields = grid.GetFieldData()
arrays = {}
for i in range(data.GetNumberOfArrays()):
    array = data.GetArray(i)
    arrays[array.GetName()] = {
        "type": array.GetDataTypeAsString(),
        "values": rows(array),
    }
texts = {}
for i in range(fields.GetNumberOfArrays()):
    array = fields.GetAbstractArray(i)
    if array.IsA("vtkStringArray"):
        texts[array.GetName()] = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
print(json.dumps({
    "texts": texts,
    "class": grid.GetClassName(),
    "points": rows(grid.GetPoints().GetData()),
    "points_type": grid.GetPoints().GetData().GetDataTypeAsString(),
    "cell_types": [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())],
    "cell_points": [grid.GetCell(i).GetPointId(0) for i in range(grid.GetNumberOfCells())],
    "bounds": grid.GetBounds(),
    "arrays": arrays,
    "time": fields.GetArray("TimeValue").GetValue(0) if fields.GetArray("TimeValue") else None,
}))
