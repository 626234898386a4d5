// SPDX-License-Identifier: Apache-2.0
#include "output/paraview_macro.hpp"

#include <nlohmann/json.hpp>

namespace kerf {

namespace {

// The colours are those of the pictures.
constexpr const char* script = R"py(
import os
from paraview.simple import *

folder = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
run = OpenDataFile(os.path.join(folder, series))
view = GetActiveViewOrCreate("RenderView")
shown = Show(run, view)
shown.SetRepresentationType("Point Gaussian")
shown.ScaleByArray = 1
shown.SetScaleArray = ["POINTS", "spacing"]
shown.ScaleTransferFunction = "PiecewiseFunction"
shown.GaussianRadius = 0.5
shown.UseScaleFunction = 0
ColorBy(shown, ("POINTS", "category"))
colours = GetColorTransferFunction("category")
colours.InterpretValuesAsCategories = 1
colours.Annotations = ["0", "water", "1", "solid", "2", "fractured", "3", "rigid"]
colours.IndexedColors = [0.36, 0.77, 0.54, 0.70, 0.15, 0.16, 0.17, 0.38, 0.85, 0.94, 0.77, 0.18]
legend = GetScalarBar(colours, view)
legend.Title = "state of the matter"
legend.ComponentTitle = ""
shown.SetScalarBarVisibility(view, True)
view.OrientationAxesVisibility = 1
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
ResetCamera(view)
Render(view)
)py";

}  // namespace

std::string paraview_macro(const std::string& name) {
  const std::string series = nlohmann::json(name + ".vtkhdf.series").dump();
  return "# Opens the run in ParaView 5.11 or later: File, Load State, or paraview --script=FILE\n"
         "series = " +
         series + script;
}

}  // namespace kerf
