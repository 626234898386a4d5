// SPDX-License-Identifier: Apache-2.0
#include "analysis/torn_mass.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "analysis/unbroken.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {

std::vector<std::uint8_t> mark_near_jets(const Workpiece& workpiece) {
  std::vector<std::uint8_t> near(workpiece.position.size(), 0);
  constexpr double whole_path = std::numeric_limits<double>::infinity();
  for (const JetAxis& jet : workpiece.jets) {
    const KerfAxes axes(jet, {}, workpiece.dimension);
    std::map<std::uint16_t, double> reach;  // m, from the axis, by body
    for (const WorkpieceBody& body : workpiece.bodies)
      reach[body.body] = jet.width / 2.0 + side_layers(workpiece, body.body, axes).reach;
    for (std::size_t slot = 0; slot < near.size(); ++slot)
      if (jet.distance(jet.swept(workpiece.position[slot], whole_path)) <=
          reach.at(workpiece.body[slot]))
        near[slot] = 1;
  }
  return near;
}

void note_torn(const KerfView& view, const std::vector<std::uint8_t>& near,
               std::vector<BodyCut>& bodies) {
  const Workpiece& workpiece = view.workpiece;
  const std::vector<double> loss = find_bond_loss(workpiece, view.frame, view.rows);
  for (std::size_t n = 0; n < bodies.size(); ++n) {
    const WorkpieceBody& body = workpiece.bodies[n];
    BodyCut& cut = bodies[n];
    if (!body.is_in_way || !body.can_break || cut.through || cut.left) continue;
    cut.torn = 0.0;
    for (std::size_t slot = 0; slot < near.size(); ++slot) {
      const std::uint8_t standing = view.standing[slot];
      if (near[slot] == 0 || workpiece.body[slot] != body.body || standing == stands_as_laid_out)
        continue;
      cut.torn += workpiece.mass[slot] * (standing == 0 ? 1.0 : loss[slot]);
    }
  }
}

}  // namespace kerf
