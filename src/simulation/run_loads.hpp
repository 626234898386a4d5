// SPDX-License-Identifier: Apache-2.0
// The loads of a run, as the engines take them: forces at points, and their histories.
#pragma once

#include <cstdint>
#include <vector>

#include "model/expression.hpp"
#include "model/point.hpp"
#include "simulation/media_order.hpp"

namespace kerf {

struct Case;
struct NewParticle;

// A part of a loaded face.
struct LoadedElement {
  Point position{};  // m
  Point force{};     // N (2D: N/m), at the factor 1
};

struct RunLoad {
  std::size_t source = 0;                // body
  bool follows = false;                  // whether the force turns with the surface: a pressure
  bool is_all_around = false;            // a pressure on the whole surface of the body
  double pressure = 0.0;                 // Pa, at the factor 1
  std::vector<LoadedElement> faces;      // of a traction or pressure
  std::vector<std::uint32_t> particles;  // ids, of a body force
  Point acceleration{};                  // m/s^2, of them
  Expression history{"1", {"t"}};        // 1, in t (s)
};

// `particles` of the start, in the order of their ids; `origins` of all media.
std::vector<RunLoad> run_loads(const Case& description, const std::vector<NewParticle>& particles,
                               const std::vector<MediumOrigin>& origins);

}  // namespace kerf
