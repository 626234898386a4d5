// SPDX-License-Identifier: Apache-2.0
// A GPU that is none: the ways of a GPU through the engine, its loops on threads of this machine.
// For tests, and for those who change the engine and have no GPU.
#include "core/processor.hpp"
#include "engine/gpu/this_gpu.hpp"

namespace kerf {

std::string problem_of_gpu() {
  return "";
}

std::string name_of_gpu() {
  return "GPU emulated on " + processor_name();
}

}  // namespace kerf
