// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include <boost/process.hpp>
#include <string>

#include "core/error.hpp"
#include "model/case.hpp"
#include "output/read_frame.hpp"
#include "report/picture.hpp"

namespace kerf {

namespace fs = std::filesystem;
namespace process = boost::process;

namespace {

constexpr double duration = 8.0;                 // s, duration of a movie with many frames
constexpr double slowest = 5.0, fastest = 30.0;  // frames per second

// Returns the file as ffmpeg takes any path: one that begins with a dash would be an option, and
// what stands before a colon a protocol.
std::string address_of(const fs::path& file) {
  return "file:" + fs::absolute(file).string();
}

}  // namespace

fs::path write_movie(const fs::path& folder, const Case& description,
                     const std::function<void(std::size_t, std::size_t)>& progress) {
  const auto ffmpeg = process::search_path("ffmpeg");
  if (ffmpeg.empty())
    throw UserError(
        "--movie: there is no ffmpeg. Install it (Debian: apt-get install ffmpeg), or "
        "watch the animation in report.html.",
        exit_files);
  const auto files = frame_files(folder);
  if (files.empty())
    throw UserError(fmt::format("--movie: {} has no frames yet.", folder.string()), exit_files);
  const double rate =
      std::min(fastest, std::max(slowest, static_cast<double>(files.size()) / duration));
  const fs::path target = folder / "movie.mp4";
  process::opstream pictures;
  // H.264 requires even sizes.
  process::child encoder(ffmpeg, "-loglevel", "error", "-y", "-f", "image2pipe", "-framerate",
                         fmt::format("{:.3f}", rate), "-c:v", "png", "-i", "-", "-vf",
                         "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-pix_fmt",
                         "yuv420p", "-movflags", "+faststart", address_of(target),
                         process::std_in < pictures);
  for (std::size_t n = 0; n < files.size() && pictures; ++n) {
    const std::string png =
        draw_picture(read_frame(files[n].path, description.dimension), description);
    pictures.write(png.data(), static_cast<std::streamsize>(png.size()));
    progress(n + 1, files.size());
  }
  pictures.flush();
  pictures.pipe().close();
  encoder.wait();
  if (encoder.exit_code() != 0 || !fs::exists(target))
    throw UserError(fmt::format("{}: ffmpeg could not make the movie (it ended with {}).",
                                target.string(), encoder.exit_code()),
                    exit_files);
  return target;
}

}  // namespace kerf
