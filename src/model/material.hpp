// SPDX-License-Identifier: Apache-2.0
// A material as a case or the library describes it, as plain data in SI units.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/public_symbol.hpp"
#include "fracture/criteria.hpp"
#include "materials/laws.hpp"

namespace kerf {

enum class MaterialKind { elastic, water };
inline constexpr std::array<std::string_view, 2> material_kind_words{"elastic", "water"};

struct MaterialLaws;  // model/material_laws.hpp

// A value of MaterialLaws, which is copied and compared like one. The type is incomplete here, so
// that a change of a law recompiles only the code that evaluates laws.
class KERF_PUBLIC LawParameters {
 public:
  LawParameters();
  LawParameters(const LawParameters& other);
  LawParameters(LawParameters&& other) noexcept;
  LawParameters& operator=(const LawParameters& other);
  LawParameters& operator=(LawParameters&& other) noexcept;
  ~LawParameters();

  MaterialLaws& operator*() { return *laws_; }
  const MaterialLaws& operator*() const { return *laws_; }
  MaterialLaws* operator->() { return laws_.get(); }
  const MaterialLaws* operator->() const { return laws_.get(); }
  bool operator==(const LawParameters& other) const;

 private:
  std::unique_ptr<MaterialLaws> laws_;
};

// A material as given. Members of another kind or law keep their defaults and are not read.
struct KERF_PUBLIC Material {
  std::string name;
  MaterialKind kind = MaterialKind::water;
  std::string source;  // where the values come from
  // Values that are known within an interval only, in words with the intervals; empty = none.
  std::string uncalibrated;
  double density = 1000.0;  // kg/m^3, reference
  LawParameters laws;

  // Solids.
  ElasticLaw elasticity = ElasticLaw::neo_hookean;
  PlasticLaw plasticity = PlasticLaw::none;
  BondCriterion criterion = BondCriterion::principal_strain;
  double youngs_modulus = 0.0;   // Pa
  double poisson_ratio = 0.0;    // 1
  double failure_strain = 0.0;   // 1, of the criterion; 0 = none
  double fracture_energy = 0.0;  // J/m^2 of crack; where it is given there is no failure_strain
  double friction = 0.0;         // 1, coefficient of dry friction

  // Water.
  EquationOfState equation_of_state = EquationOfState::tait;
  double viscosity = 0.0;    // Pa s
  double sound_speed = 0.0;  // m/s; resolved by the reader where it is not given

  double artificial_linear = 0.0;     // A of eq. (38)
  double artificial_quadratic = 0.0;  // B of eq. (38)
  double artificial_softening = 0.1;  // C of eq. (39)

  // Returns whether the material can break, by its fracture criterion or by ductile damage.
  bool can_break() const;
  bool operator==(const Material&) const = default;
};

}  // namespace kerf
