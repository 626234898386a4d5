// SPDX-License-Identifier: Apache-2.0
// random_number() returns the n-th random number of a seed, the same on every machine and in every
// order of calls. Steele, Lea & Flood, "Fast splittable pseudorandom number generators", OOPSLA
// 2014, 453: SplitMix64, whose n-th state is seed + n gamma.
#pragma once

#include <cstdint>

#include "core/host_device.hpp"

namespace kerf {

// Returns the n-th 64 random bits, n = 0, 1, ...
KERF_FUNCTION std::uint64_t random_bits(std::uint64_t seed, std::uint64_t n) {
  std::uint64_t z = seed + (n + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

// Returns the n-th number between 0 and 1, both excluded.
KERF_FUNCTION double random_number(std::uint64_t seed, std::uint64_t n) {
  constexpr double step = 1.0 / 4503599627370496.0;  // 2^-52
  return (static_cast<double>(random_bits(seed, n) >> 12) + 0.5) * step;
}

}  // namespace kerf
