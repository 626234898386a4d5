// SPDX-License-Identifier: Apache-2.0
// compute_fluid_sums() runs the SIMD pair kernel that fits each particle: by the equation of state
// of its fluid, and by whether its neighbours have one spacing.
#pragma once

#include "fluid/simd/fluid_pair_kernel.hpp"

namespace kerf::simd::KERF_SIMD {

// Computes the sums of particles `first` .. `last` - 1, which are of one fluid.
template <int D, class Real>
struct SumsOfLaw {
  const FluidKernelTask<D, Real>& task;
  std::uint32_t first, last;
  FluidSums<D, Real>* sums;

  template <class Equation>
  void operator()(const Equation& equation) const {
    if constexpr (Equation::is_weakly_compressible)
      run(WeaklyCompressible{});
    else
      run(equation);
  }

 private:
  template <class Equation>
  void run(const Equation& equation) const {
    // Graded solids are weakly compressible.
    constexpr bool may_be_graded = std::is_same_v<Equation, WeaklyCompressible>;
    const FluidLaw<Real>& law = task.laws[task.source[first]];
    FluidPairKernel<D, Real, Equation> kernel(task, law, equation);
    FluidPairKernel<D, Real, Equation, may_be_graded> graded_kernel(task, law, equation);
    FluidSums<D, Real>* results = sums;
    for (std::uint32_t from = first, to; from < last; from = to) {
      const bool graded = may_be_graded && is_graded(from);
      for (to = from + 1; to < last && is_graded(to) == graded; ++to) {
      }
      if (graded)
        graded_kernel.run(from, to, results);
      else
        kernel.run(from, to, results);
      results += to - from;
    }
  }
  bool is_graded(std::uint32_t i) const { return task.graded != nullptr && task.graded[i] != 0; }
};

template <int D, class Real>
[[gnu::flatten]] void compute_fluid_sums(const FluidKernelTask<D, Real>& task, std::uint32_t first,
                                         std::uint32_t last) {
  FluidSums<D, Real>* sums = task.results;
  while (first < last) {
    std::uint32_t end = first + 1;
    while (end < last && task.source[end] == task.source[first]) ++end;
    const FluidLaw<Real>& law = task.laws[task.source[first]];
    EquationOfStateSet<Real>::visit(law.equations, law.equation_of_state,
                                    SumsOfLaw<D, Real>{task, first, end, sums});
    sums += end - first;
    first = end;
  }
}

}  // namespace kerf::simd::KERF_SIMD
