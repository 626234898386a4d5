// SPDX-License-Identifier: Apache-2.0
// Sums in a fixed order. Floating-point addition is not associative, so that a parallel reduction
// would depend on the number of threads. Blocks of fixed length are summed in parallel, their sums
// one after the other.
#pragma once

#include "parallel/loops.hpp"

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
  KERF_FUNCTION void join(const Terms& other) {
    for (int k = 0; k < N; ++k) value[k] += other.value[k];
  }
};

template <class Sum, class Value>
struct SumBlock {
  static constexpr Index length = on_gpu ? 32 : 512;  // of one thread
  Index count;
  Value value;
  Sum* partial;

  KERF_FUNCTION void operator()(Index block) const {
    Sum sum = Sum::zero();
    const Index begin = block * length;
    const Index end = begin + length < count ? begin + length : count;
    if constexpr (requires { value.add_all(begin, end, sum); })
      value.add_all(begin, end, sum);
    else
      for (Index i = begin; i < end; ++i) value.add(i, sum);
    partial[block] = sum;
  }
};

template <class Sum>
struct JoinBlock {
  static constexpr Index length = 32;
  Index count;
  const Sum* partial;
  Sum* joined;

  KERF_FUNCTION void operator()(Index block) const {
    const Index begin = block * length;
    const Index end = begin + length < count ? begin + length : count;
    Sum sum = partial[begin];
    for (Index i = begin + 1; i < end; ++i) sum.join(partial[i]);
    joined[block] = sum;
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
    using Block = SumBlock<Sum, Value>;
    Index blocks = blocks_of(count, Block::length);
    make_room(blocks);
    for_each_index(blocks, Block{count, value, pointer(partial_)});
    if constexpr (on_gpu) blocks = join_on_device(blocks);
    thrust::copy(partial_.begin(), partial_.begin() + blocks, host_.begin());
    Sum total = Sum::zero();
    for (Index block = 0; block < blocks; ++block) total.join(host_[block]);
    return total;
  }

 private:
  static Index blocks_of(Index count, Index length) { return (count + length - 1) / length; }

  void make_room(Index blocks) {
    if (partial_.size() >= blocks) return;
    partial_.resize(blocks);
    host_.resize(blocks);
    if (on_gpu) joined_.resize(blocks);
  }

  // Joins the sums on the device, so that one sum is copied to the host.
  Index join_on_device(Index blocks) {
    while (blocks > 1) {
      const JoinBlock<Sum> join{blocks, pointer(partial_), pointer(joined_)};
      blocks = blocks_of(blocks, JoinBlock<Sum>::length);
      for_each_index(blocks, join);
      partial_.swap(joined_);
    }
    return blocks;
  }

  Array<Sum> partial_, joined_;
  std::vector<Sum> host_;
};

template <int N>
using OrderedSum = OrderedFold<Terms<N>>;

}  // namespace kerf
