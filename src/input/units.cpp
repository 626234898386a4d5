// SPDX-License-Identifier: Apache-2.0
#include "input/units.hpp"

#include <fmt/format.h>
#include <strings.h>
#include <udunits2.h>

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "input/trimmed.hpp"

namespace kerf {

namespace {

struct SystemDeleter {
  void operator()(ut_system* system) const { ut_free_system(system); }
};
struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct ConverterDeleter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;

// The conversion of a unit to another: a factor; none if the dimensions differ.
struct Factor {
  enum class Kind { unknown_unit, wrong_dimension, offset, good };
  Kind kind = Kind::unknown_unit;
  double factor = 0.0;
};

// UDUNITS keeps global state (its status and its message handler), hence the lock.
class UnitSystem {
 public:
  static UnitSystem& instance() {
    static UnitSystem system;
    return system;
  }

  Factor factor(const std::string& from, const std::string& to) {
    const std::scoped_lock lock(mutex_);
    const auto found = known_.find({from, to});
    if (found != known_.end()) return found->second;
    const Factor result = compute(from, to);
    if (result.kind == Factor::Kind::good) known_.emplace(std::pair{from, to}, result);
    return result;
  }

 private:
  UnitSystem() {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml(nullptr));
    if (!system_)
      throw UserError(
          "the units database of UDUNITS-2 cannot be read. Install libudunits2-data, or set "
          "UDUNITS2_XML_PATH to its udunits2.xml.",
          exit_files);
    // UDUNITS has "degree" and "arcdeg" only.
    const Unit degree(ut_get_unit_by_name(system_.get(), "arc_degree"));
    ut_map_name_to_unit("deg", UT_ASCII, degree.get());
  }

  Factor compute(const std::string& from, const std::string& to) {
    const Unit source(ut_parse(system_.get(), from.c_str(), UT_UTF8));
    const Unit target(ut_parse(system_.get(), to.c_str(), UT_UTF8));
    require(target != nullptr, "an SI unit of the schema is unknown");
    if (!source) return {Factor::Kind::unknown_unit, 0.0};
    // UDUNITS also converts a unit to its reciprocal (Hz to s), which has no value at zero.
    if (!ut_are_convertible(source.get(), target.get())) return {Factor::Kind::wrong_dimension, 0};
    const std::unique_ptr<cv_converter, ConverterDeleter> converter(
        ut_get_converter(source.get(), target.get()));
    if (!converter) return {Factor::Kind::wrong_dimension, 0.0};
    const double zero = cv_convert_double(converter.get(), 0.0);
    if (!std::isfinite(zero)) return {Factor::Kind::wrong_dimension, 0.0};
    if (zero != 0.0) return {Factor::Kind::offset, 0.0};
    double factor = cv_convert_double(converter.get(), 1.0);
    // A frequency counts revolutions; to UDUNITS the radian is 1.
    if (to == "Hz" && has_angle(source.get())) factor /= 2.0 * std::numbers::pi;
    return {Factor::Kind::good, factor};
  }

  // Returns whether a unit has one angle in it, as "rpm" and "rad/s".
  static bool has_angle(const ut_unit* unit) {
    std::array<char, 128> text{};
    const int length = ut_format(unit, text.data(), text.size() - 1, UT_ASCII | UT_DEFINITION);
    return length > 0 && (std::string(text.data()) + ' ').find("rad ") != std::string::npos;
  }

  std::mutex mutex_;
  std::unique_ptr<ut_system, SystemDeleter> system_;
  std::map<std::pair<std::string, std::string>, Factor> known_;
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) > 127;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t skip(std::string_view text, std::size_t at, bool (*belongs)(char)) {
  while (at < text.size() && belongs(text[at])) ++at;
  return at;
}

// Accepts names with exponents, as in "m/s2", "m s^-2", "kg.m-3" or "1/s". UDUNITS accepts more,
// such as numbers within a unit ("5 3 m") and times since a date; Kerf needs none of these, and the
// parser of UDUNITS leaks memory when it refuses them.
bool is_unit_syntax(std::string_view unit) {
  constexpr std::size_t longest = 32, longest_exponent = 2;
  if (unit.empty() || unit.size() > longest) return false;
  const auto is_blank = [](char c) { return c == ' '; };
  std::size_t at = unit.front() == '1' ? skip(unit, 1, is_blank) : 0;
  if (at > 0 && (at == unit.size() || unit[at] != '/')) return false;
  if (at > 0) at = skip(unit, at + 1, is_blank);
  while (true) {
    const std::size_t name_end = skip(unit, at, is_letter);
    const std::string_view name = unit.substr(at, name_end - at);
    for (const char* word : {"", "per", "PER", "since", "after", "from", "ref"})
      if (name == word) return false;
    at = name_end;
    const bool marked = at < unit.size() && (unit[at] == '^' || unit[at] == '-');
    if (at < unit.size() && unit[at] == '^') ++at;
    if (at < unit.size() && unit[at] == '-') ++at;
    const std::size_t exponent = skip(unit, at, is_digit) - at;
    if (exponent > longest_exponent || (marked && exponent == 0)) return false;
    at += exponent;
    if (at == unit.size()) return true;
    const std::size_t separator = at;
    at = skip(unit, at, [](char c) { return c == ' '; });
    if (at < unit.size() && std::string_view("/*.").find(unit[at]) != std::string_view::npos) ++at;
    at = skip(unit, at, [](char c) { return c == ' '; });
    if (at == separator) return false;
  }
}

// "50 mm" must be the double nearest to 0.05: dividing by 1000 is correctly rounded, multiplying by
// 0.001 is not. UDUNITS returns integer factors, and reciprocals of integers, with rounding errors.
double scaled(double number, double factor) {
  constexpr double rounding = 1e-14;
  const double whole = std::round(factor), inverse = std::round(1.0 / factor);
  if (factor > 0.5 && std::abs(factor - whole) < rounding * factor) return number * whole;
  if (factor < 1.0 && std::abs(factor * inverse - 1.0) < rounding) return number / inverse;
  return number * factor;
}

struct DimensionName {
  const char* unit;
  const char* name;
  const char* example;
};
constexpr DimensionName dimension_names[] = {
    {"m", "a length", "2 mm"},
    {"s", "a time", "10 ms"},
    {"m/s", "a speed", "5 m/s"},
    {"m/s2", "an acceleration", "-9.81 m/s2"},
    {"m2/s2", "a speed squared", "25 m2/s2"},
    {"Pa", "a pressure", "100 kPa"},
    {"Pa s", "a dynamic viscosity", "1 mPa s"},
    {"kg/m3", "a density", "1000 kg/m3"},
    {"J/kg/K", "a specific heat", "385 J/kg/K"},
    {"K", "a temperature", "300 K"},
    {"s-1", "a rate", "1 s-1"},
    {"Hz", "a frequency", "500 Hz"},
    {"rad", "an angle", "60 deg"},
    {"J/m2", "an energy per area", "10 J/m2"},
    {"m-3", "a number per volume", "1e6 m-3"},
    {"J/m3", "an energy per volume", "2e8 J/m3"},
    {"m2", "an area", "2 mm2"},
    {"m3", "a volume", "2 mm3"},
    {"m2/s", "an area per time", "2 mm2/s"},
    {"m3/s", "a volume per time", "2 mm3/s"},
    {"kg", "a mass", "2 g"},
    {"kg/m", "a mass per length", "2 g/m"},
    {"W", "a power", "2 kW"},
    {"W/m", "a power per length", "2 kW/m"},
};

// Units that are written with other letters by mistake.
constexpr const char* usual_units[] = {
    "Pa",   "kPa",  "MPa",   "GPa",  "bar",   "psi",  "m",     "cm",    "mm",     "um",   "s",
    "ms",   "us",   "min",   "h",    "Hz",    "kHz",  "MHz",   "K",     "J",      "kJ",   "g",
    "kg",   "W",    "kW",    "deg",  "rad",   "m/s",  "mm/s",  "m/min", "mm/min", "cm/s", "km/h",
    "m/s2", "Pa s", "mPa s", "J/m2", "kJ/m2", "J/m3", "kg/m3", "g/cm3", "J/kg/K", "mm2",  "mm3"};

// Returns "; write "UNIT"", or nothing.
std::string spelling_of(const std::string& unit, const std::string& si_unit) {
  for (const char* usual : usual_units)
    if (strcasecmp(unit.c_str(), usual) == 0 &&
        UnitSystem::instance().factor(usual, si_unit).kind == Factor::Kind::good)
      return fmt::format("; write \"{}\"", usual);
  return {};
}

const DimensionName& named(const std::string& si_unit) {
  for (const auto& entry : dimension_names)
    if (si_unit == entry.unit) return entry;
  require(false, "a unit of the schema has no name");
  return dimension_names[0];
}

}  // namespace

Quantity read_quantity(std::string_view text, const std::string& si_unit) {
  const std::string_view whole = trimmed(text);
  double number = 0.0;
  const auto [end, error] = std::from_chars(whole.data(), whole.data() + whole.size(), number);
  if (error == std::errc::result_out_of_range) return {0.0, "the number is too large or too small"};
  if (error != std::errc{} || !std::isfinite(number))
    return {0.0, "there is no finite number in front of the unit"};
  const std::string unit(trimmed(whole.substr(static_cast<std::size_t>(end - whole.data()))));
  if (unit.empty()) return {0.0, "a unit is missing"};
  if (unit.front() == ',' && unit.size() > 1 && is_digit(unit[1]))
    return {0.0, "a number has a decimal point, not a comma"};
  if (!is_unit_syntax(unit)) return {0.0, fmt::format("\"{}\" is not a unit", unit)};
  const Factor factor = UnitSystem::instance().factor(unit, si_unit);
  switch (factor.kind) {
    case Factor::Kind::unknown_unit:
      return {0.0, fmt::format("the unit \"{}\" is unknown{}", unit, spelling_of(unit, si_unit))};
    case Factor::Kind::wrong_dimension:
      return {0.0, fmt::format("\"{}\" is not the unit of {}{}", unit, dimension_of(si_unit),
                               spelling_of(unit, si_unit))};
    case Factor::Kind::offset:
      return {0.0, fmt::format("the unit \"{}\" has a zero of its own", unit)};
    case Factor::Kind::good:
      break;
  }
  const double value = scaled(number, factor.factor);
  if (!std::isfinite(value)) return {0.0, "the number is too large"};
  return {value, {}};
}

std::string shortest(double value) {
  return fmt::format("{}", value);
}

std::string write_quantity(double value, const std::string& si_unit) {
  return shortest(value) + " " + si_unit;
}

std::string show_quantity(double value, const std::string& si_unit, Bound bound) {
  constexpr double degree = 3.141592653589793 / 180.0;
  const bool is_angle = si_unit == "rad";
  double shown = is_angle ? value / degree : value;
  const double size = std::abs(shown);
  if (bound != Bound::none && std::isfinite(size) && size > 0.0) {
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - 5.0);
    const double nearest = std::round(shown / unit), rounding = 1e-14 * std::abs(nearest);
    const double units = std::abs(shown / unit - nearest) <= rounding ? nearest
                         : bound == Bound::least                      ? std::ceil(shown / unit)
                                                                      : std::floor(shown / unit);
    shown = units * unit;
  }
  return shortest(std::stod(fmt::format("{:.6g}", shown))) + " " + (is_angle ? "deg" : si_unit);
}

std::string dimension_of(const std::string& si_unit) {
  return named(si_unit).name;
}

std::string example_of(const std::string& si_unit) {
  return named(si_unit).example;
}

}  // namespace kerf
