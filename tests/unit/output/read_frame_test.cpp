// SPDX-License-Identifier: Apache-2.0
#include "output/read_frame.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "output/files.hpp"
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

// The HDF5 library may crash on a damaged file, and is not given one.
TEST(ReadFrame, RefusesEveryDamagedFile) {
  const test::TemporaryFolder folder;
  Frame frame;
  test::add_particle(frame, {1e-3, 0.0, 0.0}, Category::solid, 1e-3);
  FrameWriter(folder.path(), "case").write(frame);
  const auto file = folder / "frames/case_00000.vtkhdf";
  const std::string whole = read_file(file);
  const auto refused = [&](const std::string& content) {
    write_file(file, content);
    return test::message_of<UserError>([&] { read_frame(file, 2); });
  };
  EXPECT_EQ(refused(whole), "");
  for (std::size_t at = 0; at < whole.size(); at += 199) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    for (const std::string& content : {changed, whole.substr(0, at)})
      EXPECT_EQ(refused(content).find(file.string() + ": the file is damaged"), 0u) << at;
  }
}

}  // namespace
}  // namespace kerf
