// SPDX-License-Identifier: Apache-2.0
// With symmetry planes a run simulates a part of the workpiece. A frame of the whole one consists
// of the part and its mirror images, so that every measurement is that of the whole workpiece.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/frame.hpp"

namespace kerf {

struct Case;
struct JetAxis;

// The planes in which a part is mirrored, at most one for each axis. Bit p of the number of an
// image says whether it is mirrored in plane p; image 0 is the part itself.
struct SymmetryImages {
  struct Plane {
    std::size_t axis = 0;
    double position = 0.0;                                   // m
    std::uint8_t joins = 0;                                  // its bit in Frame::joined_planes
    bool is_low() const { return joins == 1u << 2 * axis; }  // the part is above it
  };
  std::vector<Plane> planes;
  int jets = 1;  // the first jet and its images: a plane through the axis adds none

  std::uint32_t count() const { return std::uint32_t(1) << planes.size(); }
};

// Returns the planes of a case. Of two opposite planes, which repeat the workpiece without end, the
// one counts that contains the axis of the first jet, else none: the whole is one period.
SymmetryImages symmetry_images(const Case& description);

// Returns the point of the simulated part of which a point of the whole workpiece is an image, or
// the point itself.
std::array<double, 3> point_of_part(std::array<double, 3> x, const SymmetryImages& images);

// Returns by how many jets a jet acts on the whole workpiece: 1 if its axis lies in all planes,
// else with its images.
int images_of(const JetAxis& jet, const SymmetryImages& images);

// Returns the axes of all jets of a case and of their images, the first jet first.
std::vector<JetAxis> axes_of_jets(const Case& description, const SymmetryImages& images);

// Returns the number of jets that act on the whole workpiece: of the case and of their images.
std::size_t jets_of_whole(const Case& description);

// Returns the part followed by its images in the order of their numbers, with the pieces of the
// whole workpiece; the rows of each image have the order of the part, and its ids. Of the further
// columns it has those with one component.
Frame whole_frame(const Frame& part, const SymmetryImages& images);

// The frame of the whole workpiece, which without planes is that of the run.
class WholeFrame {
 public:
  WholeFrame(const Frame& part, const SymmetryImages& images) : part_(part) {
    if (!images.planes.empty()) whole_ = whole_frame(part, images);
  }
  const Frame& get() const { return whole_ ? *whole_ : part_; }

 private:
  const Frame& part_;
  std::optional<Frame> whole_;
};

}  // namespace kerf
