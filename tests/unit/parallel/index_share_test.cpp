// SPDX-License-Identifier: Apache-2.0
#include "parallel/index_share.hpp"

#include <gtest/gtest.h>

namespace kerf {
namespace {

// The shares follow one another from 0 to the last number, and a rank that has none has no part of
// a block either.
TEST(IndexShare, SharesDivideAllNumbersIntoWholeBlocks) {
  for (const Index count : {1u, 512u, 700u, 5000u, 100001u})
    for (const int ranks : {1, 2, 3, 8}) {
      Index next = 0;
      for (int rank = 0; rank < ranks; ++rank) {
        const IndexShare share = IndexShare::of(count, rank, ranks);
        EXPECT_EQ(share.first, next);
        EXPECT_EQ(share.first % IndexShare::block, 0u);
        EXPECT_TRUE(share.is_part);
        EXPECT_LE(share.size(), count / static_cast<Index>(ranks) + 2 * IndexShare::block);
        EXPECT_EQ(share.has(share.first), share.size() > 0);
        EXPECT_FALSE(share.has(share.last));
        next = share.last;
      }
      EXPECT_EQ(next, count);
    }
}

}  // namespace
}  // namespace kerf
