// SPDX-License-Identifier: Apache-2.0
// budget: file: the conditions and the system that they form read best in one place
// These factors correct the weights of pairs where the spacing of a body jumps. A particle there
// has smaller neighbours over a shorter kernel on one side than on the other; its sums are not
// balanced, and a uniform stress or pressure would exert a force on it. So every pair near a jump
// gets a factor s_ij = s_ji of its weight, with which each particle i has nearly the sums of a
// neighbourhood that has the spacing of i throughout (the tilde; the lattices of two levels are
// nested):
//   sum_j s_ij w_ij R = sum~ w R,     sum_j s_ij w_ij R (x) R = sum~ w R (x) R,
// 0 and that of the lattice inside a body, those of the face at a face. They minimise
//   sum (s - 1)^2 + (1 / e) sum_i [(gap of the first)^2 + (theta gap of the second)^2].
// With A (s - 1) = b for the conditions this is  s - 1 = A^T lambda,  (A A^T + e) lambda = b,
// solved by conjugate gradients, once, on the host. The other end of a bond may be a mirror image
// (core/mirror_planes.hpp); its conditions are the mirrored ones of its particle, so that a part
// has the factors of the whole. The second condition has little weight: to meet
// both takes factors from 0.2 to 3. These are the factors of pairs with pressures from their
// densities. Bonds use corrected gradients, so that theirs have  sum_j s_ij w_ij (C_i + C_j) R / 2
// in the first condition, C_i = (sum~ w R (x) R) (sum s w R (x) R)^-1, found in a few rounds. A
// pair keeps its factor as it moves. See docs/theory/graded_resolution.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/matrix.hpp"
#include "solid/conjugate_gradients.hpp"
#include "solid/find_bonds.hpp"

namespace kerf {

struct BondFit {
  // s, per entry of the bond lists; empty: there are no levels.
  std::vector<double> of_bond, of_pair;
  std::vector<std::uint8_t> fitted;  // per particle: 1 where a factor may differ from 1
};

template <int D>
class LevelFit {
  static constexpr std::size_t rows = D + D * (D + 1) / 2;  // conditions of a particle
  using Row = std::array<double, rows>;
  using Rows = Blocks<rows>;
  using Position = Vector<D, double>;
  using Seen = std::array<std::vector<Index>, std::size_t(1) << (2 * D)>;

 public:
  // `accuracy`: of the solution, as a share of what the sums lack with factors of 1.
  LevelFit(const SolidLayout<D>& layout, const BondLists& bonds, double accuracy = 1e-4)
      : layout_(layout), bonds_(bonds), scales_(layout.media), accuracy_(accuracy) {}

  BondFit solve() {
    BondFit fit;
    if (layout_.body.empty() || !find_jumps()) return fit;
    list_pairs();
    match_.assign(layout_.reference.size(), identity<D, double>());
    const Rows wanted = resampled_sums();
    fit.of_pair = factors(wanted);
    fit.of_bond = fit.of_pair;
    for (int round = 0; round < rounds; ++round) {
      match_corrections(wanted, fit.of_bond);
      fit.of_bond = factors(wanted);
    }
    fit.fitted.assign(layout_.reference.size(), 0);
    for (const Index i : particle_of_) fit.fitted[i] = 1;
    return fit;
  }

 private:
  // Every bond keeps a positive weight.
  static constexpr double least_factor = 0.05;
  static constexpr double softness = 1e-3;      // e
  static constexpr double second_weight = 0.1;  // theta
  static constexpr int rounds = 3;              // a fourth does not improve the balance

  struct Entry {
    Index own, other;  // rows of i and j
    Index bond, back;  // in the lists of i and of j; the first names j, or its image
    double weight;     // w_ij
    Position apart;    // R, m
    Position matched;  // (C_i + C_j) R / 2, m
  };

  const Medium<double>& medium(Index i) const { return layout_.media[layout_.medium_index[i]]; }
  // Below, `end` is a particle with the code of its image.
  Index particle(Index end) const { return layout_.mirrors.particle(end); }
  MirrorCode code(Index end) const { return layout_.mirrors.code(end); }
  const Medium<double>& medium_of(Index end) const { return medium(particle(end)); }
  Position bond(Index i, Index end) const {
    return -1.0 * layout_.mirrors.separation(code(end), layout_.reference[i],
                                             layout_.reference[particle(end)]);
  }
  double weight(Index i, Index end) const {
    return scales_(layout_.medium_index[i], layout_.medium_index[particle(end)])
        .weight(norm(bond(i, end)));
  }
  bool has_finest_spacing(Index i) const {
    const auto& media = layout_.media;
    for (std::size_t m = 0; m < media.size(); ++m)
      if (layout_.body[m] == layout_.body[layout_.medium_index[i]] &&
          media[m].spacing < medium(i).spacing)
        return false;
    return true;
  }
  bool same_body(Index i, Index end) const {
    return layout_.body[layout_.medium_index[i]] ==
           layout_.body[layout_.medium_index[particle(end)]];
  }

  // Marks the particles with neighbours of another level.
  bool find_jumps() {
    at_jump_.assign(layout_.reference.size(), 0);
    bool any = false;
    for (Index i = 0; i < static_cast<Index>(at_jump_.size()); ++i)
      for (Index k = bonds_.begin[i]; k < bonds_.begin[i + 1]; ++k) {
        const Index j = particle(bonds_.neighbour[k]);
        if (layout_.medium_index[i] == layout_.medium_index[j] || !same_body(i, j)) continue;
        at_jump_[i] = 1;
        any = true;
      }
    return any;
  }

  // Finds the pairs that may change, and their particles.
  void list_pairs() {
    std::vector<Index> row_of(layout_.reference.size(), none);
    for_each_pair_at_jumps([&](Index i, Index) {
      if (row_of[i] != none) return;
      row_of[i] = static_cast<Index>(particle_of_.size());
      particle_of_.push_back(i);
    });
    for_each_pair_at_jumps([&](Index i, Index k) {
      const Index end = bonds_.neighbour[k], j = particle(end);
      if (i > j) return;
      const Position apart = bond(i, end);
      pairs_.push_back(
          {row_of[i], row_of[j], k, entry_of(j, i | code(end)), weight(i, end), apart, apart});
    });
  }
  // Calls visit(i, k) for entry k of the bonds of i, where one of its ends is at a jump.
  template <class Visit>
  void for_each_pair_at_jumps(const Visit& visit) const {
    for (Index i = 0; i < static_cast<Index>(at_jump_.size()); ++i)
      for (Index k = bonds_.begin[i]; k < bonds_.begin[i + 1]; ++k) {
        const Index j = particle(bonds_.neighbour[k]);
        if (same_body(i, j) && (at_jump_[i] || at_jump_[j])) visit(i, k);
      }
  }
  MirrorCode code(const Entry& pair) const { return code(bonds_.neighbour[pair.bond]); }
  Index entry_of(Index i, Index end) const {
    const auto first = bonds_.neighbour.begin() + bonds_.begin[i];
    const auto last = bonds_.neighbour.begin() + bonds_.begin[i + 1];
    return static_cast<Index>(std::lower_bound(first, last, end) - bonds_.neighbour.begin());
  }

  // Returns the dimensionless terms of a neighbour at R of volume V in the sums of a particle of
  // spacing d: V |W'| / R times (d C R, theta R (x) R).
  static Row conditions(const Position& bond, const Position& matched, double weight,
                        double spacing) {
    Row row{};
    std::size_t n = 0;
    for (int a = 0; a < D; ++a) row[n++] = weight * spacing * matched[a];
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) row[n++] = second_weight * weight * bond[a] * bond[b];
    return row;
  }
  Row conditions(Index i, Index end) const {
    return conditions(bond(i, end), matched(i, end), weight(i, end) / medium(i).reference_volume(),
                      medium(i).spacing);
  }
  Position matched(Index i, Index end) const {
    const auto other = MirrorPlanes<D>::image(code(end), match_[particle(end)]);
    return 0.5 * ((match_[i] + other) * bond(i, end));
  }
  static void add(Row& sum, const Row& row, double share) {
    for (std::size_t n = 0; n < rows; ++n) sum[n] += share * row[n];
  }

  // Returns the sums that each particle should have.
  Rows resampled_sums() {
    Rows sums(particle_of_.size());
    Seen seen;
    for (std::size_t r = 0; r < sums.size(); ++r) {
      const Index i = particle_of_[r];
      visit_around(i, seen, [&](Index end) { add_resampled(i, end, sums[r]); });
    }
    return sums;
  }
  // Returns the sums that it has with these factors; without factors: with 1.
  Row own_sums(Index i, const std::vector<double>& factor) const {
    Row sum{};
    for (Index k = bonds_.begin[i]; k < bonds_.begin[i + 1]; ++k)
      if (same_body(i, bonds_.neighbour[k]))
        add(sum, conditions(i, bonds_.neighbour[k]), factor.empty() ? 1.0 : factor[k]);
    return sum;
  }

  std::vector<double> factors(const Rows& wanted) {
    Rows missing = wanted;
    for (std::size_t r = 0; r < missing.size(); ++r)
      add(missing[r], own_sums(particle_of_[r], {}), -1.0);
    const auto system = [this](const Rows& x) { return apply(x); };
    solution_ = conjugate_gradients<rows>(system, std::move(missing), inverse_diagonal(), accuracy_,
                                          std::move(solution_));
    const Rows multipliers = scaled(solution_);
    std::vector<double> factor(bonds_.neighbour.size(), 1.0);
    for (const Entry& pair : pairs_) {
      const double s = 1.0 + change(pair, pair_row(pair), multipliers);
      factor[pair.bond] = factor[pair.back] = s > least_factor ? s : least_factor;
    }
    return factor;
  }

  static Matrix<D, double> second_moment(const Row& row) {
    Matrix<D, double> moment;
    std::size_t n = D;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) moment(a, b) = moment(b, a) = row[n++];
    return moment;
  }
  // Computes C of every particle with these factors.
  void match_corrections(const Rows& wanted, const std::vector<double>& factor) {
    for (std::size_t r = 0; r < wanted.size(); ++r) {
      const Index i = particle_of_[r];
      auto match = second_moment(wanted[r]);
      if (divide(match, second_moment(own_sums(i, factor)), 1e-6)) match_[i] = match;
    }
    for (Entry& pair : pairs_)
      pair.matched = matched(particle_of_[pair.own], bonds_.neighbour[pair.bond]);
  }

  // Visits all of its body within the own kernel of i: its neighbours, and smaller particles beyond
  // the shorter reach of a pair, which are neighbours of those of its neighbours at a jump. `seen`
  // holds, for each image, the last particle that visited it.
  template <class Visit>
  void visit_around(Index i, Seen& seen, const Visit& visit) const {
    const auto visit_neighbours = [&](Index of) {
      const Index middle = particle(of);
      for (Index k = bonds_.begin[middle]; k < bonds_.begin[middle + 1]; ++k) {
        Index end = bonds_.neighbour[k];
        if (!same_body(i, end) || !see_in(code(of), end)) continue;
        auto& last = seen[code(end) >> MirrorPlanes<D>::shift];
        if (last.empty()) last.assign(layout_.reference.size(), none);
        if (std::exchange(last[particle(end)], i) != i) visit(end);
      }
    };
    visit_neighbours(i);
    if (has_finest_spacing(i)) return;
    for (Index k = bonds_.begin[i]; k < bonds_.begin[i + 1]; ++k)
      if (at_jump_[particle(bonds_.neighbour[k])]) visit_neighbours(bonds_.neighbour[k]);
  }
  // Turns an end into its image in these planes; false where that is an image in two opposite
  // planes, which is out of reach.
  bool see_in(MirrorCode planes, Index& end) const {
    const MirrorCode own = code(end);
    for (int a = 0; a < D; ++a) {
      const MirrorCode faces = MirrorPlanes<D>::low_face(a) | MirrorPlanes<D>::high_face(a);
      if (((own ^ planes) & faces) == faces) return false;
    }
    end ^= planes;
    return true;
  }

  // Adds the terms of the volume of j as if that had the spacing of i: a share of one site of its
  // lattice, or several sites.
  void add_resampled(Index i, Index end, Row& sum) const {
    if (i == end) return;
    const double spacing = medium(i).spacing, ratio = medium_of(end).spacing / spacing;
    const Position apart = bond(i, end);
    if (ratio < 0.75) {
      Position site;
      for (int a = 0; a < D; ++a) site[a] = spacing * std::round(apart[a] / spacing);
      add_site(i, site, std::pow(ratio, D), sum);
      return;
    }
    const int across = static_cast<int>(std::lround(ratio));
    const int count = D == 3 ? across * across * across : across * across;
    for (int k = 0; k < count; ++k) {
      Position site = apart;
      for (int a = 0, rest = k; a < D; ++a, rest /= across)
        site[a] += spacing * (rest % across - 0.5 * (across - 1));
      add_site(i, site, 1.0, sum);
    }
  }
  void add_site(Index i, const Position& site, double share, Row& sum) const {
    const double distance = norm(site);
    const auto& own = medium(i);
    if (distance < 0.5 * own.spacing) return;  // itself
    const double weight =
        scales_(layout_.medium_index[i], layout_.medium_index[i]).weight(distance);
    add(sum, conditions(site, site, weight / own.reference_volume(), own.spacing), share);
  }

  // A and its transpose are products of a part of each particle, which scales its rows, and a part
  // of each pair, whose row is the same for both ends but for the sign of the first condition:
  // w_ij (+- C R, R (x) R).
  Rows scaled(Rows x) const {
    for (std::size_t r = 0; r < x.size(); ++r) {
      const auto& own = medium(particle_of_[r]);
      const double volume = own.reference_volume();
      for (std::size_t n = 0; n < rows; ++n)
        x[r][n] *= (n < D ? own.spacing : second_weight) / volume;
    }
    return x;
  }
  Row pair_row(const Entry& pair) const {
    Row row;
    std::size_t n = 0;
    for (int a = 0; a < D; ++a) row[n++] = pair.weight * pair.matched[a];
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) row[n++] = pair.weight * pair.apart[a] * pair.apart[b];
    return row;
  }
  // The conditions of the image of a particle.
  static Row image(MirrorCode code, Row row) {
    if (code == 0) return row;
    std::size_t n = 0;
    for (int a = 0; a < D; ++a, ++n)
      if (MirrorPlanes<D>::flips(code, a)) row[n] = -row[n];
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b, ++n)
        if (MirrorPlanes<D>::flips(code, a) != MirrorPlanes<D>::flips(code, b)) row[n] = -row[n];
    return row;
  }
  // Returns s - 1 of the pair of this row.
  double change(const Entry& pair, const Row& row, const Rows& multipliers) const {
    const Row& own = multipliers[pair.own];
    const Row other = image(code(pair), multipliers[pair.other]);
    double sum = 0.0;
    for (std::size_t n = 0; n < D; ++n) sum += row[n] * (own[n] - other[n]);
    for (std::size_t n = D; n < rows; ++n) sum += row[n] * (own[n] + other[n]);
    return sum;
  }
  // Returns (A A^T + e) x. A pair of a particle and its own image is one condition of one particle,
  // and half a pair of the whole.
  Rows apply(const Rows& x) const {
    const Rows from = scaled(x);
    Rows result(x.size());
    for (const Entry& pair : pairs_) {
      Row row = pair_row(pair);
      const double s = change(pair, row, from);
      add(result[pair.own], row, s);
      if (pair.own == pair.other) continue;
      for (std::size_t n = 0; n < D; ++n) row[n] = -row[n];
      add(result[pair.other], image(code(pair), row), s);
    }
    result = scaled(std::move(result));
    add_blocks(result, x, softness);
    return result;
  }
  // Returns 1 / the diagonal of A A^T + e of the whole.
  Rows inverse_diagonal() const {
    Rows diagonal(particle_of_.size());
    for (const Entry& pair : pairs_) {
      const Row row = pair_row(pair);
      const Index i = pair.own, j = pair.other;
      for (std::size_t n = 0; n < rows; ++n) diagonal[i][n] += row[n] * row[n];
      for (std::size_t n = 0; n < rows && j != i; ++n) diagonal[j][n] += row[n] * row[n];
    }
    diagonal = scaled(scaled(std::move(diagonal)));
    for (Row& row : diagonal)
      for (double& value : row) value = 1.0 / (value + softness);
    return diagonal;
  }

  static constexpr Index none = 0xffffffffu;
  const SolidLayout<D>& layout_;
  const BondLists& bonds_;
  BondScales<D> scales_;
  double accuracy_;
  std::vector<std::uint8_t> at_jump_;
  std::vector<Entry> pairs_;
  std::vector<Index> particle_of_;        // of each row
  std::vector<Matrix<D, double>> match_;  // C, per particle
  Rows solution_;                         // lambda of the last round, with which the next begins
};

}  // namespace kerf
