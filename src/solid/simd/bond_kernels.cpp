// SPDX-License-Identifier: Apache-2.0
#include "solid/simd/bond_kernels.hpp"

#include "simd/kernel_table.hpp"
#include "solid/simd/bond_kernel.hpp"

namespace kerf {

namespace simd::KERF_SIMD {
template <int D, class Real>
inline constexpr BondKernelsOf<D, Real> kernels_of{sum_gradients<D, Real>, sum_forces<D, Real>,
                                                   sum_misfits<D, Real>, sum_moments<D, Real>};
}

KERF_DEFINE_KERNELS(BondKernels, bond_kernels, kernels_of<2, float>, kernels_of<3, float>,
                    kernels_of<2, double>, kernels_of<3, double>)

}  // namespace kerf
