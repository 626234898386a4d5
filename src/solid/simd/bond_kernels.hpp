// SPDX-License-Identifier: Apache-2.0
// The SIMD kernels over bonds, chosen for this processor.
#pragma once

#include "simd/instruction_set.hpp"
#include "simd/kernels_by_type.hpp"
#include "solid/simd/packed_bonds.hpp"

namespace kerf {

template <int D, class Real>
struct BondKernelsOf {
  BondKernel<D, Real, BondGradientSum> sum_gradients;
  BondKernel<D, Real, BondForceSum> sum_forces;
  BondKernel<D, Real, BondMisfitSum> sum_misfits;
  BondKernel<D, Real, BondMoments> sum_moments;
};
using BondKernels = KernelsByType<BondKernelsOf>;

const BondKernels& bond_kernels();

}  // namespace kerf
