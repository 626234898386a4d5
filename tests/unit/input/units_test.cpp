// SPDX-License-Identifier: Apache-2.0
#include "input/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

namespace kerf {
namespace {

struct Reading {
  const char* text;
  const char* unit;
  double value;
};

// The literal on the right is the double nearest to the decimal number, which the value must equal.
TEST(Units, DecimalPrefixesAreCorrectlyRounded) {
  for (const Reading& reading : {Reading{"0.3 mm", "m", 0.3e-3},
                                 {"50 mm", "m", 0.05},
                                 {"-50 mm", "m", -0.05},
                                 {"35 mm", "m", 0.035},
                                 {"10 ms", "s", 0.01},
                                 {"0.7 ms", "s", 0.7e-3},
                                 {"1.5 ms", "s", 1.5e-3},
                                 {"300 MPa", "Pa", 300e6},
                                 {"60kPa", "Pa", 60e3},
                                 {"1 mPa s", "Pa s", 1e-3},
                                 {" 25 m2/s2 ", "m2/s2", 25.0},
                                 {"5 um", "m", 5e-6},
                                 {"-9.81 m/s2", "m/s2", -9.81},
                                 {"1 g/cm3", "kg/m3", 1000.0}}) {
    const Quantity quantity = read_quantity(reading.text, reading.unit);
    EXPECT_EQ(quantity.problem, "") << reading.text;
    EXPECT_EQ(quantity.value, reading.value) << reading.text;
  }
}

// Definitions of the units: 1200 mm/min = 0.02 m/s, 1 psi = 6894.757293168361 Pa (NIST SP 811),
// 1 inch = 25.4 mm, 1 bar = 100 kPa.
TEST(Units, OtherUnits) {
  for (const Reading& reading : {Reading{"60 deg", "rad", std::numbers::pi / 3.0},
                                 {"60 degree", "rad", std::numbers::pi / 3},
                                 {"1200 mm/min", "m/s", 0.02},
                                 {"1 psi", "Pa", 6894.757293168361},
                                 {"1 inch", "m", 0.0254},
                                 {"2 bar", "Pa", 2e5},
                                 {"36 km/h", "m/s", 10.0},
                                 {"1 N/mm^2", "Pa", 1e6},
                                 {"1000 1/s", "Hz", 1000.0},
                                 {"2 1/mm", "m-1", 2000.0},
                                 {"3 1 / ms", "Hz", 3000.0}}) {
    const Quantity quantity = read_quantity(reading.text, reading.unit);
    EXPECT_EQ(quantity.problem, "") << reading.text;
    EXPECT_NEAR(quantity.value, reading.value, 1e-14 * reading.value) << reading.text;
  }
}

TEST(Units, WrittenQuantitiesAreReadBackBitForBit) {
  std::mt19937_64 random(1);
  for (const char* unit : {"m", "s", "m/s", "m/s2", "m2/s2", "Pa", "Pa s", "kg/m3", "rad"}) {
    std::uniform_real_distribution<double> exponent(-12.0, 12.0);
    for (int i = 0; i < 2000; ++i) {
      const double value = (i % 2 ? -1.0 : 1.0) * std::pow(10.0, exponent(random));
      EXPECT_EQ(read_quantity(write_quantity(value, unit), unit).value, value);
    }
  }
}

// What a message says is allowed is accepted when it is typed.
TEST(Units, ShownBoundsAreAllowed) {
  EXPECT_EQ(show_quantity(0.02651650429449553, "m"), "0.0265165 m");
  EXPECT_EQ(show_quantity(0.02651650429449553, "m", Bound::least), "0.0265166 m");
  EXPECT_EQ(show_quantity(1e6, "m", Bound::most), "1000000 m");
  EXPECT_EQ(show_quantity(3.141592653589793, "rad", Bound::most), "180 deg");
  EXPECT_EQ(show_quantity(-0.7853981633974483, "rad", Bound::least), "-45 deg");
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-9.0, 9.0);
  for (int n = 0; n < 2000; ++n) {
    const double value = (n % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, exponent(random));
    for (const char* unit : {"m", "Pa"}) {
      const double least = read_quantity(show_quantity(value, unit, Bound::least), unit).value;
      const double most = read_quantity(show_quantity(value, unit, Bound::most), unit).value;
      EXPECT_GE(least, value);
      EXPECT_LE(most, value);
      EXPECT_NEAR(least, value, 1e-5 * std::abs(value));
      EXPECT_NEAR(most, value, 1e-5 * std::abs(value));
    }
  }
}

// A unit in other letters, and a decimal comma, are told as such.
// An angle is 1 to UDUNITS, and a frequency of revolutions would be 2 pi times too large.
TEST(Units, FrequenciesCountRevolutions) {
  for (const Reading& reading : {Reading{"60000 rpm", "Hz", 1000.0},
                                 {"50 rps", "Hz", 50.0},
                                 {"60 cycle/min", "Hz", 1.0},
                                 {"180 deg/s", "Hz", 0.5},
                                 {"3000 1/min", "Hz", 50.0},
                                 {"2 kHz", "Hz", 2000.0}}) {
    const Quantity quantity = read_quantity(reading.text, reading.unit);
    EXPECT_EQ(quantity.problem, "") << reading.text;
    EXPECT_NEAR(quantity.value, reading.value, 1e-13 * reading.value) << reading.text;
  }
}

TEST(Units, MistakesAreNamed) {
  struct Mistake {
    const char *text, *unit, *problem;
  };
  for (const Mistake& mistake :
       {Mistake{"30 kpa", "Pa", "the unit \"kpa\" is unknown; write \"kPa\""},
        {"30 Mpa", "Pa", "the unit \"Mpa\" is unknown; write \"MPa\""},
        {"3000 PSI", "Pa", "the unit \"PSI\" is unknown; write \"psi\""},
        {"2 MM", "m", "the unit \"MM\" is unknown; write \"mm\""},
        {"2 furlongs/moment", "m/s", "the unit \"furlongs/moment\" is unknown"},
        {"0,05 MPa", "Pa", "a number has a decimal point, not a comma"},
        {"2 kg", "m", "\"kg\" is not the unit of a length"}})
    EXPECT_EQ(read_quantity(mistake.text, mistake.unit).problem, mistake.problem) << mistake.text;
}

TEST(Units, ManyThreadsAgree) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t k = 0; k < wrong.size(); ++k)
    threads.emplace_back([&wrong, k] {
      for (int i = 0; i < 500; ++i) {
        wrong[k] += read_quantity("3 mm", "m").value != 3e-3;
        wrong[k] += read_quantity("3 mm", "s").problem.empty();
        wrong[k] += read_quantity("3 grobs", "m").problem.empty();
      }
    });
  for (auto& thread : threads) thread.join();
  for (const int count : wrong) EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace kerf
