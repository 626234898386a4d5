// SPDX-License-Identifier: Apache-2.0
// Pictures are read back pixel by pixel.
#include "report/picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "report/canvas.hpp"
#include "report/palette.hpp"
#include "report/picture_panels.hpp"
#include "support/fake_simulation.hpp"

namespace kerf {
namespace {

struct Bytes {
  const std::string& content;
  std::size_t at = 0;
};

cairo_status_t next_bytes(void* closure, unsigned char* data, unsigned int length) {
  auto& bytes = *static_cast<Bytes*>(closure);
  if (bytes.at + length > bytes.content.size()) return CAIRO_STATUS_READ_ERROR;
  std::copy_n(bytes.content.data() + bytes.at, length, data);
  bytes.at += length;
  return CAIRO_STATUS_SUCCESS;
}

class Image {
 public:
  explicit Image(const std::string& png) {
    Bytes bytes{png};
    surface_.reset(cairo_image_surface_create_from_png_stream(next_bytes, &bytes));
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  std::uint32_t pixel(int x, int y) const {
    const auto* row = cairo_image_surface_get_data(surface_.get()) +
                      y * cairo_image_surface_get_stride(surface_.get());
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xffffff;
  }
  int count(std::uint32_t colour) const {
    int sum = 0;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x) sum += pixel(x, y) == colour ? 1 : 0;
    return sum;
  }

 private:
  CairoSurface surface_;
};

std::uint32_t code(Colour colour) {
  const auto byte = [](double share) {
    return static_cast<std::uint32_t>(std::lround(255 * share));
  };
  return byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

Case case_2d() {
  return test::fake_case();
}

Frame frame_with(const std::array<double, 3>& place, Category category, double spacing) {
  Frame frame;
  test::add_particle(frame, place, category, spacing);
  return frame;
}

// The number of pixels of the dot in the legend of every picture.
int dot_pixels(Colour colour) {
  return Image(draw_picture(Frame{}, case_2d())).count(code(colour));
}

TEST(Window, ContainsBodiesAndNozzleWithinTheDomain) {
  const Case description = case_2d();
  const Box window = picture_window(description);
  EXPECT_LT(window.minimum[0], -14e-3);
  EXPECT_GT(window.maximum[0], 14e-3);
  EXPECT_LT(window.minimum[1], -4e-3);
  EXPECT_GT(window.maximum[1], 16e-3);  // 6 mm of standoff above 10 mm
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GE(window.minimum[k], description.domain.minimum[k]);
    EXPECT_LE(window.maximum[k], description.domain.maximum[k]);
  }
}

TEST(Picture, DistantDropsDoNotChangeTheWindow) {
  const Case description = case_2d();
  Frame frame = frame_with({0, 0.005, 0}, Category::solid, 2e-3);
  const Image near(draw_picture(frame, description));
  test::add_particle(frame, {5.0, 7.0, 0.0}, Category::water, 1e-3);
  const Image far(draw_picture(frame, description));
  EXPECT_EQ(near.width(), far.width());
  EXPECT_EQ(near.height(), far.height());
  EXPECT_EQ(near.count(code(palette::solid)), far.count(code(palette::solid)));
}

// A disc of diameter d covers pi d^2 / 4; its antialiased edge is about one pixel wide.
TEST(Picture, ParticlesAreDiscsOfTheirSpacingAtTrueScale) {
  const Case description = case_2d();
  const Box window = picture_window(description);
  const double width = window.maximum[0] - window.minimum[0];
  for (const double spacing : {1e-3, 2e-3, 4e-3}) {
    const Frame frame = frame_with({0.0, 5e-3, 0.0}, Category::solid, spacing);
    const Image image(draw_picture(frame, description));
    const double scale = (image.width() - 112.0) / width;  // px/m; 112 px are margins
    const double radius = 0.5 * spacing * scale;
    const int pixels = image.count(code(palette::solid)) - dot_pixels(palette::solid);
    EXPECT_NEAR(pixels, M_PI * radius * radius, 2.0 * M_PI * radius) << spacing;
  }
}

TEST(Picture, EveryCategoryHasItsColour) {
  const Case description = case_2d();
  const std::pair<Category, Colour> kinds[] = {{Category::water, palette::water},
                                               {Category::solid, palette::solid},
                                               {Category::fractured, palette::fractured},
                                               {Category::rigid, palette::plate}};
  for (const auto& [category, colour] : kinds) {
    const Image image(draw_picture(frame_with({0, 5e-3, 0}, category, 4e-3), description));
    EXPECT_GT(image.count(code(colour)), dot_pixels(colour) + 1000) << static_cast<int>(category);
  }
}

TEST(Picture, EqualFramesGiveEqualBytes) {
  const Frame frame = test::FakeSimulation(case_2d()).frame();
  EXPECT_EQ(draw_picture(frame, case_2d()), draw_picture(frame, case_2d()));
}

Case case_3d() {
  Case description = case_2d();
  description.dimension = 3;
  for (Body& body : description.bodies) {
    body.shape.box.minimum[2] = -10e-3;
    body.shape.box.maximum[2] = 10e-3;
  }
  description.domain = {{-1, -1, -1}, {1, 1, 1}};
  return description;
}

TEST(Picture, ShowsTheBackHalfAndTheMiddleSliceIn3D) {
  const Case description = case_3d();
  const auto blue = [&](double z) {
    Frame frame = frame_with({0, 5e-3, z}, Category::fractured, 4e-3);
    frame.dimension = 3;
    const Image image(draw_picture(frame, description));
    int left = 0, right = 0;  // pixels near the colour, shaded ones too
    for (int y = 0; y < image.height() * 8 / 10; ++y)
      for (int x = 0; x < image.width(); ++x) {
        const std::uint32_t p = image.pixel(x, y);
        const int r = p >> 16, b = p & 255;
        if (b > r + 60) ++(2 * x < image.width() ? left : right);
      }
    return std::pair{left, right};
  };
  const auto [behind_left, behind_right] = blue(-8e-3);
  EXPECT_GT(behind_left, 500);
  EXPECT_EQ(behind_right, 0);
  const auto [middle_left, middle_right] = blue(0.0);
  EXPECT_GT(middle_left, 500);
  EXPECT_GT(middle_right, 500);
  const auto [front_left, front_right] = blue(8e-3);
  EXPECT_EQ(front_left, 0);
  EXPECT_EQ(front_right, 0);
}

// At half the size a quarter of the pixels have the colour of the water.
TEST(Picture, IsScaledUniformly) {
  const Case description = case_2d();
  const Frame frame = frame_with({0, 5e-3, 0}, Category::water, 8e-3);
  const Image whole(draw_picture(frame, description)), half(draw_picture(frame, description, 0.5));
  EXPECT_NEAR(half.width(), 0.5 * whole.width(), 1.0);
  EXPECT_NEAR(half.height(), 0.5 * whole.height(), 1.0);
  const double in_whole = whole.count(code(palette::water));
  EXPECT_GT(in_whole, 1000.0);
  EXPECT_NEAR(half.count(code(palette::water)) / in_whole, 0.25, 0.02);
}

TEST(RoundInterval, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_interval(0.14, 8.0), 0.02);
  EXPECT_DOUBLE_EQ(round_interval(80.0, 8.0), 10.0);
  EXPECT_DOUBLE_EQ(round_interval(33.0, 8.0), 5.0);
}

}  // namespace
}  // namespace kerf
