// SPDX-License-Identifier: Apache-2.0
#include "output/read_frame.hpp"

#include <gtest/gtest.h>

#include "output/vtkhdf.hpp"
#include "support/frames.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

Frame written_and_read(const Frame& frame) {
  const test::TemporaryFolder folder;
  FrameWriter(folder.path(), "case").write(frame);
  return read_frame(folder / "frames/case_00000.vtkhdf", frame.dimension);
}

TEST(ReadFrame, HasThePiecesOfTheFrameExactly) {
  Frame frame;
  for (int i = 0; i < 3; ++i)
    test::add_particle(frame, {1e-3 * i, 0.0, 0.0}, Category::solid, 1e-3);
  // Ids above 2^24 have no exact value in single precision.
  frame.piece = {4000000001u, 4000000001u, 4000000003u};
  frame.body_piece = {4000000001u, 4000000002u, 4000000003u};
  frame.joined_planes = {1, 0, 33};
  const Frame read = written_and_read(frame);
  EXPECT_EQ(read.piece, frame.piece);
  EXPECT_EQ(read.body_piece, frame.body_piece);
  EXPECT_EQ(read.joined_planes, frame.joined_planes);
  EXPECT_TRUE(read.columns.empty());
}

// Frames of formulations without bonds, and those of earlier versions, have none.
TEST(ReadFrame, MayHaveNoPieces) {
  Frame frame;
  test::add_particle(frame, {1e-3, 0.0, 0.0}, Category::solid, 1e-3);
  const Frame read = written_and_read(frame);
  EXPECT_TRUE(read.piece.empty());
  EXPECT_TRUE(read.body_piece.empty());
  EXPECT_TRUE(read.joined_planes.empty());
}

}  // namespace
}  // namespace kerf
