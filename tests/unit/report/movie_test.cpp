// SPDX-License-Identifier: Apache-2.0
// Movies in folders of any name.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "output/vtkhdf.hpp"
#include "report/picture.hpp"
#include "support/fake_simulation.hpp"
#include "support/frames.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;

// For ffmpeg a word that begins with a dash is an option, and what stands before a colon is a
// protocol.
TEST(Movie, IsMadeInFoldersOfAnyName) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no ffmpeg";
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  for (const char* name :
       {"-y", "two words", "x:y", "http:x", "%d", "qu\"o'te", "new\nline", "a,b[0]", "$HOME`id`"}) {
    fs::create_directory(name);
    Frame frame;
    add_particle(frame, {0.0, 0.0, 0.0}, Category::water, 1e-3);
    frame.source[0] = 0;
    FrameWriter(name, "case").write(frame);
    const fs::path movie = write_movie(name, fake_case(), [](std::size_t, std::size_t) {});
    EXPECT_EQ(movie, fs::path(name) / "movie.mp4");
    EXPECT_GT(fs::file_size(movie), 0u) << name;
  }
  fs::current_path(before);
}

}  // namespace
}  // namespace kerf::test
