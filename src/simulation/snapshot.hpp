// SPDX-License-Identifier: Apache-2.0
// This file copies the particles to the host as a frame. Those that have left the domain and wait
// to be removed are not in it: their bonds are broken, but no crack has broken them.
#pragma once

#include "particles/fields.hpp"
#include "simulation/frame.hpp"
#include "simulation/media_order.hpp"

namespace kerf {

inline Category category_of(Phase phase, bool fractured) {
  if (phase == Phase::water) return Category::water;
  if (phase == Phase::rigid) return Category::rigid;
  return fractured ? Category::fractured : Category::solid;
}

// The row of a column that holds a number, a vector, or a symmetric tensor in the order
// xx yy zz xy yz xz that ParaView expects.
template <class T>
void append_row(const T& value, std::vector<float>& values) {
  values.push_back(static_cast<float>(value));
}
template <int D, class T>
void append_row(const Vector<D, T>& value, std::vector<float>& values) {
  for (int a = 0; a < 3; ++a) values.push_back(a < D ? static_cast<float>(value[a]) : 0.0f);
}
template <int D, class T>
void append_row(const SymmetricTensor<D, T>& s, std::vector<float>& values) {
  for (int a = 0; a < 3; ++a) values.push_back(static_cast<float>(s(a, a)));
  values.push_back(static_cast<float>(s(0, 1)));
  values.push_back(D == 3 ? static_cast<float>(s(D - 2, D - 1)) : 0.0f);
  values.push_back(D == 3 ? static_cast<float>(s(0, D - 1)) : 0.0f);
}

// The particles that a frame has, and the media of all.
struct ShownParticles {
  std::vector<std::size_t> which;
  std::vector<std::uint16_t> source;  // of all
};

// The column of a field of the table.
template <class Field, class Value>
void add_column(const Field& field, const ShownField<Value>& shown,
                const std::vector<Medium<double>>& media, const ShownParticles& particles,
                Frame& frame) {
  const auto entries = to_host(field);
  Column column{shown.column, shown.unit, 1, {}, shown.label};
  for (const std::size_t i : particles.which)
    append_row(shown.value(entries[i], media[particles.source[i]]), column.values);
  if (const std::size_t rows = particles.which.size(); rows > 0)
    column.components = static_cast<int>(column.values.size() / rows);
  frame.columns.push_back(std::move(column));
}
template <class Field>
void add_column(const Field&, Hidden, const std::vector<Medium<double>>&, const ShownParticles&,
                Frame&) {}

template <int D, class P>
Frame make_frame(const Particles<D, P>& particles, const std::vector<Medium<double>>& media,
                 const std::vector<MediumOrigin>& origins) {
  Frame frame;
  frame.dimension = D;
  const auto position = to_host(particles.position);
  const auto velocity = to_host(particles.velocity);
  const auto fractured = to_host(particles.fractured);
  const auto flags = to_host(particles.flags);
  ShownParticles shown{{}, to_host(particles.source)};
  for (std::size_t i = 0; i < flags.size(); ++i)
    if ((flags[i] & flag::outside) == 0) shown.which.push_back(i);
  const auto compression = to_host(particles.compression);
  const auto pressure = to_host(particles.pressure);
  const auto id = to_host(particles.id);
  for (const std::size_t i : shown.which) {
    const std::uint16_t source = shown.source[i];
    const Medium<double>& medium = media[source];
    frame.id.push_back(id[i]);
    std::array<double, 3> x{}, v{};
    for (int a = 0; a < D; ++a) {
      x[static_cast<std::size_t>(a)] = position[i][a];
      v[static_cast<std::size_t>(a)] = velocity[i][a];
    }
    frame.position.push_back(x);
    frame.velocity.push_back(v);
    frame.source.push_back(origins[source].source);
    frame.category.push_back(category_of(medium.phase, fractured[i] != 0));
    frame.spacing.push_back(static_cast<float>(medium.spacing));
    frame.mass.push_back(static_cast<float>(medium.mass));
    frame.density.push_back(
        static_cast<float>(medium.density * (1.0 + static_cast<double>(compression[i]))));
    frame.pressure.push_back(static_cast<float>(pressure[i]));
    frame.upstream.push_back((flags[i] & flag::upstream) != 0 ? 1 : 0);
  }
  particles.for_each_field([&](const auto&, const auto& field, const auto& column) {
    add_column(field, column, media, shown, frame);
  });
  return frame;
}

}  // namespace kerf
