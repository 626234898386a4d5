// SPDX-License-Identifier: Apache-2.0
#include "analysis/derived.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "input/read.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf {
namespace {

DerivedNumbers of(const char* name) {
  return derive(read_case(std::string(KERF_SOURCE_DIR "/cases/") + name + ".toml"));
}

Case tofu_at(double speed) {
  Case description = read_case(KERF_SOURCE_DIR "/cases/tofu-5ms.toml");
  description.jets[0].speed = speed;
  for (Material& material : description.materials)
    if (material.kind == MaterialKind::water) material.sound_speed = 10.0 * speed;
  return description;
}

// The values are computed by hand from E = 1e5 Pa, nu = 0.3, rho = 940 kg/m3: K = E / 1.2, G = E /
// 2.6.
TEST(Derived, WaveSpeedsOfThePaper) {
  const DerivedNumbers numbers = of("tofu-5ms");
  EXPECT_NEAR(numbers.bulk_modulus, 1e5 / 1.2, 1e-9 * 1e5);
  EXPECT_NEAR(numbers.shear_modulus, 1e5 / 2.6, 1e-9 * 1e5);
  EXPECT_NEAR(numbers.bulk_speed, 9.416, 1e-3);
  EXPECT_NEAR(numbers.longitudinal_speed, 11.967, 1e-3);
  EXPECT_NEAR(numbers.shear_speed, 6.3966, 1e-3);
  EXPECT_NEAR(numbers.rayleigh_speed, 5.9, 0.05);
}

// Exact roots of Rayleigh's equation: nu = 1/4, x = 2 - 2 / sqrt(3); nu -> 1/2, c_R = 0.95531 c_s;
// nu = 0, x = 3 - sqrt(5).
TEST(Derived, RayleighSpeedIsTheTrueRoot) {
  const struct {
    double poisson, ratio, tolerance;
  } table[] = {{0.25, std::sqrt(2.0 - 2.0 / std::sqrt(3.0)), 1e-12},
               {0.0, std::sqrt(3.0 - std::sqrt(5.0)), 1e-12},
               {0.4999999, 0.955313, 1e-5}};
  for (const auto& entry : table) {
    Case description = tofu_at(5.0);
    for (Material& material : description.materials)
      if (material.kind == MaterialKind::elastic) material.poisson_ratio = entry.poisson;
    const DerivedNumbers numbers = derive(description);
    EXPECT_NEAR(numbers.rayleigh_speed / numbers.shear_speed, entry.ratio,
                entry.tolerance * entry.ratio);
  }
}

TEST(Derived, DimensionlessGroupsOfThePaper) {
  const DerivedNumbers slow = of("tofu-5ms"), fast = of("tofu-50ms");
  EXPECT_NEAR(slow.stagnation_pressure, 12.5e3, 1e-9 * 12.5e3);
  EXPECT_NEAR(slow.cauchy_number, 0.25, 1e-12);
  EXPECT_NEAR(slow.mach, 0.1, 1e-12);
  EXPECT_NEAR(slow.hammer_pressure_numerical, 0.25e6, 1e-3);
  EXPECT_NEAR(slow.hammer_pressure_real, 7.4e6, 0.01 * 7.4e6);
  EXPECT_NEAR(slow.contact_stress, 45.9e3, 0.005 * 45.9e3);
  EXPECT_NEAR(slow.hydrodynamic_front_speed, 2.54, 0.005 * 2.54);
  EXPECT_NEAR(fast.cauchy_number, 25.0, 1e-9);
  EXPECT_NEAR(fast.contact_stress, 550e3, 0.005 * 550e3);
  EXPECT_NEAR(fast.speed_over_longitudinal, 4.2, 0.01 * 4.2);
  EXPECT_NEAR(fast.hydrodynamic_front_speed, 25.4, 0.005 * 25.4);
  EXPECT_EQ(slow.jet_resolution, 10.0);
  EXPECT_NEAR(slow.solid_to_water_spacing, 2.0, 1e-12);
}

// A stiff layer below the block of the paper, whichever the case names first, and beside it.
TEST(Derived, AreThoseOfTheBodyThatTheWaterMeetsFirst) {
  const DerivedNumbers alone = of("tofu-5ms");
  Case description = tofu_at(5.0);
  const auto upper =
      std::find_if(description.bodies.begin(), description.bodies.end(),
                   [](const Body& body) { return body.role == Role::elastic && !body.fixed; });
  ASSERT_NE(upper, description.bodies.end());
  Body lower = *upper;
  lower.name = "lower";
  lower.material = static_cast<int>(description.materials.size());
  description.materials.push_back(description.materials.at(std::size_t(upper->material)));
  description.materials.back().youngs_modulus *= 10.0;
  for (const std::size_t axis : {1u, 0u}) {  // below and beside
    Body moved = lower;
    Box& box = moved.shape.box;
    const double shift = box.maximum[axis] - box.minimum[axis];
    box.minimum[axis] -= shift;
    box.maximum[axis] -= shift;
    Case last = description, first = description;
    last.bodies.push_back(moved);
    first.bodies.insert(first.bodies.begin(), moved);
    for (const Case& each : {last, first}) {
      const DerivedNumbers numbers = derive(each);
      EXPECT_EQ(numbers.rayleigh_speed, alone.rayleigh_speed) << axis;
      EXPECT_EQ(numbers.resistance, alone.resistance) << axis;
      EXPECT_EQ(numbers.cauchy_number, alone.cauchy_number) << axis;
    }
  }
}

TEST(Derived, Regimes) {
  EXPECT_EQ(derive(tofu_at(2.0)).regime, "elastic dimple");
  EXPECT_EQ(derive(tofu_at(5.0)).regime, "crack-led");
  EXPECT_EQ(derive(tofu_at(20.0)).regime, "erosion");
  EXPECT_EQ(derive(tofu_at(50.0)).regime, "hydrodynamic");
  EXPECT_EQ(of("rings").regime, "no jet");

  // The failure strain follows from the fracture energy: Gc = w d M strain^2 / 2, with the spacing
  // of the block of 2 mm.
  Case tough = tofu_at(5.0);
  for (Material& material : tough.materials)
    if (material.kind == MaterialKind::elastic) {
      material.failure_strain = 0.0;
      material.fracture_energy = 40.0;
    }
  const double m = 1e5 * 0.7 / (1.3 * 0.4);
  EXPECT_NEAR(derive(tough).failure_strain, std::sqrt(2.0 * 40.0 / (3.2 * 2e-3 * m)), 1e-12);
  EXPECT_EQ(derive(tough).regime, "elastic dimple");
}

// Every limit of a material counts, and a material without one resists by its stiffness.
TEST(Derived, ResistanceIsTheLeastStressAtWhichTheSolidGivesWay) {
  const double shear = 1e5 / 2.6;
  const auto changed = [](double speed, const std::function<void(Material&)>& change) {
    Case description = tofu_at(speed);
    description.formulation = Formulation::standard;
    for (Material& material : description.materials)
      if (material.kind == MaterialKind::elastic) {
        material.failure_strain = 0.0;
        change(material);
      }
    return derive(description);
  };
  // 5/2 G is 96 kPa, the stagnation pressure of water at 13.9 m/s.
  const auto none = [](Material&) {};
  EXPECT_NEAR(changed(5.0, none).resistance, 2.5 * shear, 1e-9 * shear);
  EXPECT_EQ(changed(13.8, none).regime, "elastic dimple");
  EXPECT_EQ(changed(14.0, none).regime, "erosion");
  EXPECT_EQ(changed(600.0, none).regime, "hydrodynamic");
  const auto brittle = [](Material& material) {
    material.criterion = BondCriterion::principal_stress;
    material.laws->principal_stress.tensile_strength = 8e3;
  };
  EXPECT_NEAR(changed(5.0, brittle).resistance, 8e3, 1e-9);
  EXPECT_EQ(changed(3.9, brittle).regime, "elastic dimple");
  EXPECT_EQ(changed(4.1, brittle).regime, "crack-led");
  const auto ductile = [](Material& material) {
    material.plasticity = PlasticLaw::von_mises;
    material.laws->plastic.von_mises.yield_stress = 2e3;
  };
  EXPECT_NEAR(changed(5.0, ductile).resistance, 2e3, 1e-9);
  // One flaw per particle of (2 mm)^2 x 1 m in the mean at a strain of 0.02.
  const auto flawed = [](Material& material) {
    material.criterion = BondCriterion::grady_kipp;
    material.laws->grady_kipp.weibull_m = 6.0;
    material.laws->grady_kipp.weibull_k = std::pow(0.02, -6.0) / 4e-6;
  };
  EXPECT_NEAR(changed(5.0, flawed).resistance, 0.02 * 1e5, 1e-6);
}

// A jet of 200 MPa on the foam of the library, which has no limit.
TEST(Derived, AJetThatDwarfsTheSolidMakesNoDimple) {
  Case description = tofu_at(632.0);
  for (Material& material : description.materials)
    if (material.kind == MaterialKind::elastic) {
      material.youngs_modulus = 0.27e6;
      material.poisson_ratio = 0.0;
      material.density = 90.0;
      material.failure_strain = 0.0;
    }
  const DerivedNumbers numbers = derive(description);
  EXPECT_GT(numbers.cauchy_number, 1300.0);
  EXPECT_EQ(numbers.regime, "hydrodynamic");
}

// With softening the failure strain is that of the material; if the spacing is too coarse for that,
// it is the strain at which w d E strain^2 / 2 is the fracture energy (Bazant & Oh 1983). 2 Gc / (w
// E strain^2) is 0.75 mm for 1 J/m2.
TEST(Derived, StrengthOfAMaterialThatSoftens) {
  Case soft = tofu_at(5.0);
  soft.formulation = Formulation::standard;
  for (double energy : {10.0, 1.0}) {
    for (Material& material : soft.materials)
      if (material.kind == MaterialKind::elastic) {
        material.criterion = BondCriterion::crack_band;
        material.fracture_energy = energy;
      }
    const double brittle = std::sqrt(2.0 * energy / (2.65 * 2e-3 * 1e5));
    EXPECT_NEAR(derive(soft).failure_strain, std::min(0.1, brittle), 1e-12);
  }
}

// Block 50 x 25, plate 61 x 2; 5 m/s x 10 mm x 30 ms = 1500 mm2 of water at 1 mm.
TEST(Derived, ParticlesAndSteps) {
  const DerivedNumbers numbers = of("tofu-5ms");
  EXPECT_EQ(numbers.particles_initial, 50u * 25u + 61u * 2u);
  EXPECT_NEAR(static_cast<double>(numbers.particles_expected), 1250.0 + 122.0 + 1500.0, 1.0);
  // The water limits the step: 0.25 x 1.5 mm / (50 + 5 + 1.2 x 0.01 x 50) m/s.
  EXPECT_NEAR(numbers.time_step, 0.25 * 1.5e-3 / 55.6, 1e-12);
  EXPECT_NEAR(numbers.steps, 0.03 * 55.6 / (0.25 * 1.5e-3), 1.0);
  // Round jet of 10 mm in 3D.
  const DerivedNumbers space = of("tofu-5ms-3d");
  EXPECT_EQ(space.particles_initial, 20u * 10u * 20u + 26u * 2u * 26u);
  const double water = 5.0 * 0.02 * 3.14159265 * 25e-6 / 1e-9;
  EXPECT_NEAR(static_cast<double>(space.particles_expected - space.particles_initial), water, 1.0);
}

// A run that ends once its part is passed: the flight from the simulated nozzle, then two streams
// of water and foam. A solid that resists, or a run that goes on, ends at the end of the case.
TEST(Derived, RunsThatEndEarlyHaveTheirLikelyEnd) {
  const std::string text = R"(title = "foam"
dimension = 3
quality = "draft"
[machine]
pressure = "200 MPa"
orifice_diameter = "0.15 mm"
standoff = "3 mm"
traverse_speed = "1 m/s"
[workpiece]
material = "polyurethane-foam"
size = ["300 mm", "5 mm", "200 mm"]
)";
  const Case foam = parse_case(text, "foam.toml", quick_look);
  const DerivedNumbers numbers = derive(foam);
  const double ratio = foam.materials[1].density / foam.materials[0].density;
  const double density = std::min(ratio, 1.0 / ratio);  // of the foam over that of the water
  const double front = numbers.jet_speed / (1.0 + std::sqrt(density));
  const double likely = foam.jets[0].standoff / numbers.jet_speed + 5e-3 / front +
                        20.0 * foam.jets[0].width / numbers.jet_speed;
  EXPECT_NEAR(numbers.likely_end, likely, 1e-3 * likely);
  EXPECT_NEAR(numbers.steps, likely / numbers.time_step, 2.0);
  const Case whole = parse_case(text + "[time]\nafter_cut = \"1 s\"\n", "foam.toml", quick_look);
  EXPECT_EQ(derive(whole).likely_end, whole.time.end);
  Case strong = foam;
  for (Material& material : strong.materials)
    if (material.kind != MaterialKind::water) material.youngs_modulus *= 1e6;
  EXPECT_LT(numbers.likely_end, foam.time.end);
  EXPECT_EQ(derive(strong).likely_end, strong.time.end);
}

TEST(Derived, WithoutAJet) {
  const DerivedNumbers rods = of("rod-impact");
  EXPECT_NEAR(rods.jet_speed, 0.5, 1e-12);
  EXPECT_NEAR(rods.longitudinal_speed, 100.0, 1e-9);
  // Equal impedances give half of rho c v.
  EXPECT_NEAR(rods.contact_stress, 0.5 * 1000.0 * 100.0 * 0.5, 1e-6);
  EXPECT_NEAR(of("tank").water_sound_speed, 10.0 * std::sqrt(2.0 * 9.81 * 0.1), 1e-9);
}

// 2 L / c_p with the nearest side of the block that is neither absorbing nor a plane of symmetry.
TEST(Derived, WavesReflectFromTheNearestReflectingEdge) {
  Case description = tofu_at(5.0);
  const double c = of("tofu-5ms").longitudinal_speed;
  Body* block = nullptr;
  for (Body& body : description.bodies)
    if (body.role == Role::elastic) block = &body;
  ASSERT_NE(block, nullptr);
  block->shape.box.minimum[0] = -0.03;
  block->shape.box.maximum[0] = 0.05;
  description.jets[0].position[0] = 0.0;
  EXPECT_NEAR(derive(description).reflection_time, 0.06 / c, 1e-12);
  description.symmetry.minimum[0] = true;
  EXPECT_NEAR(derive(description).reflection_time, 0.10 / c, 1e-12);
  block->absorbing.maximum[0] = true;
  EXPECT_EQ(derive(description).reflection_time, 0.0);
  description.symmetry.minimum[0] = false;
  description.jets[0].position[0] = 1.0;  // beside the block
  EXPECT_EQ(derive(description).reflection_time, 0.0);
}

// Sound of water behind a shock, by the slope of p = rho_0 c^2 eta / (1 - s eta)^2 over rho, in a
// jet of 245 m/s on foam, which it compacts to a wall: eta = u / U, U = c + s u.
TEST(Derived, StepsOfFastWaterAreThoseBehindItsShock) {
  const Case description = read_case(KERF_SOURCE_DIR "/cases/machine/foam-30mpa.toml");
  const DerivedNumbers numbers = derive(description);
  const double c = 1481.0, s = 1.975, u = numbers.jet_speed;
  const auto pressure = [&](double rho) {
    const double eta = 1.0 - 998.2 / rho;
    return 998.2 * c * c * eta / std::pow(1.0 - s * eta, 2);
  };
  const double rho = 998.2 / (1.0 - u / (c + s * u)), small = 1e-4 * rho;
  const double sound = std::sqrt((pressure(rho + small) - pressure(rho - small)) / (2.0 * small));
  EXPECT_GT(sound, 1.4 * c);
  const auto water = static_cast<std::size_t>(description.jets[0].material);
  const double damping = 1.2 * description.materials[water].artificial_linear * c;
  const double step = 0.45 * 1.3 * description.jets[0].spacing / (sound + u + damping);
  EXPECT_NEAR(numbers.time_step, step, 1e-4 * step);
}

}  // namespace
}  // namespace kerf
