// SPDX-License-Identifier: Apache-2.0
// The emulated GPU: it runs the GPU code path of the engine on CPU threads.
// It serves tests and development of the engine without a GPU.
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
