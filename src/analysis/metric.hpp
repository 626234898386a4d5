// SPDX-License-Identifier: Apache-2.0
// A metric is one number or word that describes a run. Each is defined once, beside the record that
// holds it, with its name, unit, label and meaning. result.json, series.csv, the report, the tables
// of a study, the signals of `kerf verify` and docs/metrics.md follow from the definitions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace kerf {

// An SI unit: "m", "J/m3"; "1" for pure numbers and words.
struct MetricUnit {
  std::string in_space;    // in three dimensions
  bool extensive = false;  // in two dimensions the quantity is counted per metre of depth
  bool is_share = false;   // a pure number that is shown in per cent

  MetricUnit(const char* unit, bool is_extensive = false)
      : in_space(unit), extensive(is_extensive) {}
  // The unit in two or three dimensions: "kg/m" and "kg", "m2" and "m3".
  std::string in(int dimension) const;
};
inline MetricUnit extensive(const char* unit) {
  return {unit, true};
}
inline MetricUnit share() {
  MetricUnit unit("1");
  unit.is_share = true;
  return unit;
}

enum class MetricKind { number, count, flag, text, numbers };

// The description of a metric.
struct MetricText {
  std::string name;  // key in its record; a dot leads into a record inside: "top.width"
  MetricUnit unit;
  std::string label;    // as it stands beside the number: "depth of the kerf"
  std::string meaning;  // one sentence
  MetricKind kind = MetricKind::number;
  bool may_be_missing = false;  // the value may be null
};

// A value of a metric: none, a flag, a count, a number (NaN = none), a text, or several numbers.
using MetricValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>>;

// The value as a number: a flag counts 1 or 0; nan where there is none.
double number_of(const MetricValue& value);

namespace detail {

template <class T>
struct MetricType {
  static constexpr MetricKind kind = std::is_same_v<T, bool>       ? MetricKind::flag
                                     : std::is_integral_v<T>       ? MetricKind::count
                                     : std::is_floating_point_v<T> ? MetricKind::number
                                                                   : MetricKind::text;
  static constexpr bool may_be_missing = kind == MetricKind::number;
  static MetricValue value(const T& raw) {
    if constexpr (kind == MetricKind::count)
      return static_cast<std::int64_t>(raw);
    else if constexpr (kind == MetricKind::text)
      return std::string(raw);
    else
      return raw;
  }
};
template <class T>
struct MetricType<std::optional<T>> {
  static constexpr MetricKind kind = MetricType<T>::kind;
  static constexpr bool may_be_missing = true;
  static MetricValue value(const std::optional<T>& raw) {
    return raw ? MetricType<T>::value(*raw) : MetricValue();
  }
};
template <std::size_t Count>
struct MetricType<std::array<double, Count>> {
  static constexpr MetricKind kind = MetricKind::numbers;
  static constexpr bool may_be_missing = false;
  static MetricValue value(const std::array<double, Count>& raw) {
    return std::vector<double>(raw.begin(), raw.end());
  }
};
template <>
struct MetricType<std::vector<double>> {
  static constexpr MetricKind kind = MetricKind::numbers;
  static constexpr bool may_be_missing = false;
  static MetricValue value(const std::vector<double>& raw) { return raw; }
};

}  // namespace detail

// A metric of a record. `read` is a member of the record or a function of it; its type decides the
// kind.
template <class Record>
struct Metric : MetricText {
  template <class Read>
  Metric(const char* name_, MetricUnit unit_, const char* label_, const char* meaning_, Read read)
      : MetricText{name_, std::move(unit_), label_, meaning_} {
    using Type = detail::MetricType<std::decay_t<std::invoke_result_t<Read, const Record&>>>;
    kind = Type::kind;
    may_be_missing = Type::may_be_missing;
    value = [read](const Record& record) { return Type::value(std::invoke(read, record)); };
  }
  Metric(MetricText text, std::function<MetricValue(const Record&)> read)
      : MetricText(std::move(text)), value(std::move(read)) {}

  std::function<MetricValue(const Record&)> value;
};

template <class Record>
using MetricList = std::vector<Metric<Record>>;

// Replaces each "{}" of a text by `word`.
std::string with_word(std::string text, const std::string& word);

// Adds the metrics of an inner record, which `reach` finds in the outer one. Their names follow
// `prefix`;
// "{}" in their labels and meanings becomes `word`.
template <class Outer, class Inner, class Reach>
void add_metrics(MetricList<Outer>& list, const MetricList<Inner>& inner, const std::string& prefix,
                 const std::string& word, Reach reach) {
  for (const Metric<Inner>& metric : inner) {
    MetricText text = metric;
    text.name = prefix + text.name;
    text.label = with_word(text.label, word);
    text.meaning = with_word(text.meaning, word);
    list.push_back({std::move(text), [read = metric.value, reach](const Outer& outer) {
                      return read(std::invoke(reach, outer));
                    }});
  }
}

}  // namespace kerf
