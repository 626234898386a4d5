// SPDX-License-Identifier: Apache-2.0
// Sums in a fixed order. Floating-point addition is not associative, so that a parallel reduction
// would depend on the number of threads. Blocks of fixed length are summed in parallel, their sums
// one after the other; on a GPU both in trees of a fixed shape (parallel/gpu_loops.hpp).
#pragma once

#include "parallel/index_share.hpp"
#include "parallel/loops.hpp"

namespace kerf {

// N numbers summed together.
template <int N>
struct Terms {
  static constexpr int terms = N;
  double value[N];

  KERF_FUNCTION static Terms zero() {
    Terms t;
    for (int k = 0; k < N; ++k) t.value[k] = 0.0;
    return t;
  }
  KERF_FUNCTION void join(const Terms& other) {
    for (int k = 0; k < N; ++k) value[k] += other.value[k];
  }
};

// Adds the values of begin .. end - 1 in their order: value.add(i, sum), or value.add_all() at
// once.
template <class Sum, class Value>
KERF_FUNCTION void add_range(const Value& value, Index begin, Index end, Sum& sum) {
  if constexpr (requires { value.add_all(begin, end, sum); })
    value.add_all(begin, end, sum);
  else
    for (Index i = begin; i < end; ++i) value.add(i, sum);
}

template <class Sum, class Value>
struct SumBlock {
  static constexpr Index length = 512;
  Index count;
  Value value;
  Sum* partial;

  KERF_FUNCTION void operator()(Index block) const {
    Sum sum = Sum::zero();
    const Index begin = block * length;
    const Index end = begin + length < count ? begin + length : count;
    add_range(value, begin, end, sum);
    partial[block] = sum;
  }
};

// The object keeps its scratch space, so that a sum in a step does not allocate. `Sum` has a static
// zero() and join(other), where `other` is the sum of later particles.
template <class Sum>
class OrderedFold {
 public:
  // `Value` has `void add(Index i, Sum& sum) const`, or add_all(begin, end, sum) for a block.
  template <class Value>
  Sum operator()(Index count, const Value& value) {
    if (count == 0) return Sum::zero();
#if defined(__CUDACC__)
    return gpu::fold<Sum>(count, gpu::Addition<Sum, Value>{value});
#else
    using Block = SumBlock<Sum, Value>;
    const Index blocks = (count + Block::length - 1) / Block::length;
    if (partial_.size() < blocks) partial_.resize(blocks);
    for_each_index(blocks, Block{count, value, pointer(partial_)});
    Sum total = Sum::zero();
    for (Index block = 0; block < blocks; ++block) total.join(partial_[block]);
    return total;
#endif
  }

  // The sum over all numbers, of which each rank adds those of its share: block by block, so that
  // it is the same for any number of ranks.
  template <class Value>
  Sum operator()(const IndexShare& share, const Value& value) {
    if constexpr (ranks::exist) {
      if (share.is_part) return over_ranks(share, value);
    }
    return (*this)(share.last, value);
  }

 private:
  template <class Value>
  Sum over_ranks(const IndexShare& share, const Value& value) {
    using Block = SumBlock<Sum, Value>;
    static_assert(IndexShare::block == Block::length);
    const IndexShare blocks{share.first / Block::length,
                            (share.last + Block::length - 1) / Block::length};
    std::vector<Sum> own(blocks.size());
    for_each_index(blocks, Block{share.last, value, own.data() - blocks.first});
    Sum total = Sum::zero();
    for (const Sum& block : ranks::collected(own)) total.join(block);
    return total;
  }

  Array<Sum> partial_;
};

template <int N>
using OrderedSum = OrderedFold<Terms<N>>;

}  // namespace kerf
