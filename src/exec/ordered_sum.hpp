// SPDX-License-Identifier: Apache-2.0
// Sums in a fixed order: floating-point addition is not associative, so a parallel reduction would
// give other last digits for other numbers of threads. Blocks of fixed length are summed in
// parallel, their sums one after the other.
#pragma once

#include "exec/exec.hpp"

namespace kerf {

// N numbers summed together.
template <int N>
struct Terms {
  double value[N];

  KERF_FUNCTION static Terms zero() {
    Terms t;
    for (int k = 0; k < N; ++k) t.value[k] = 0.0;
    return t;
  }
};

template <int N, class Value>
struct SumBlock {
  static constexpr Index length = 512;
  Index count;
  Value value;
  Terms<N>* partial;

  KERF_FUNCTION void operator()(Index block) const {
    Terms<N> sum = Terms<N>::zero();
    const Index begin = block * length;
    const Index end = begin + length < count ? begin + length : count;
    for (Index i = begin; i < end; ++i) value.add(i, sum);
    partial[block] = sum;
  }
};

// Keeps its scratch space, so that summing in a step does not allocate.
template <int N>
class OrderedSum {
 public:
  // `Value` has `void add(Index i, Terms<N>& sum) const`.
  template <class Value>
  Terms<N> operator()(Index count, const Value& value) {
    if (count == 0) return Terms<N>::zero();
    using Block = SumBlock<N, Value>;
    const Index blocks = (count + Block::length - 1) / Block::length;
    if (partial_.size() < blocks) {
      partial_.resize(blocks);
      host_.resize(blocks);
    }
    for_each_index(blocks, Block{count, value, pointer(partial_)});
    thrust::copy(partial_.begin(), partial_.begin() + blocks, host_.begin());
    Terms<N> total = Terms<N>::zero();
    for (Index block = 0; block < blocks; ++block)
      for (int k = 0; k < N; ++k) total.value[k] += host_[block].value[k];
    return total;
  }

 private:
  Array<Terms<N>> partial_;
  std::vector<Terms<N>> host_;
};

}  // namespace kerf
