// SPDX-License-Identifier: Apache-2.0
// Every row of the tables of case keys is read into its member, refused if it is wrong, written and
// documented. The tests cover all rows, so that a new row needs no test of its own.
#include "input/schema.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "schema_rows.hpp"

namespace kerf {
namespace {

using namespace test;

// Returns whether the stored value is that of value_text(key, number_of(key), dimension).
struct IsStored {
  const Key& key;
  int dimension;
  double number = number_of(key);

  bool operator()(const double* value) const { return *value == number; }
  bool operator()(const int* value) const { return *value == number; }
  bool operator()(const std::uint64_t* value) const {
    return static_cast<double>(*value) == number;
  }
  bool operator()(const bool* value) const { return *value == (key.standard.text != "true"); }
  bool operator()(const std::string* value) const {
    return *value == (key.kind == ValueKind::expression ? "0.5" : "sample");
  }
  bool operator()(const Point* value) const {
    Point expected{};
    for (int a = 0; a < dimension; ++a) expected[static_cast<std::size_t>(a)] = number;
    return *value == expected;
  }
  bool operator()(const std::array<std::string, 3>* value) const {
    return (*value)[0] == "0.5" && (*value)[1] == "0.5" &&
           (*value)[2] == (dimension == 3 ? "0.5" : "0");
  }
  bool operator()(const std::vector<double>* value) const {
    return *value == std::vector<double>{number};
  }
  bool operator()(const std::vector<std::array<double, 2>>* value) const {
    return *value == std::vector<std::array<double, 2>>(3, {number, number});
  }
  bool operator()(const Faces* value) const {
    Faces expected;
    expected.maximum[key.choices.size() / 2 - 1] = true;
    return *value == expected;
  }
  bool operator()(const WordReference& word) const {
    return word.get(word.value) == key.choices.size() - 1;
  }
};

// The structures of a section after a table was read, and the messages.
struct ReadTable {
  std::vector<Storage> storages;
  std::string problems;

  const Storage* of(const Key& key) const {
    for (const Storage& storage : storages)
      if (storage.id == key.member.structure) return &storage;
    return nullptr;
  }
  bool complains_of(const Key& key) const {
    return problems.find(fmt::format("{}.{} = ", table_path, key.name)) != std::string::npos;
  }
};

ReadTable read_table(const std::string& section, const Surroundings& around,
                     const toml::table& table) {
  Reading reading{Problems("case.toml"),
                  {},
                  around.description.dimension,
                  formulation_name(around.description.formulation)};
  Section keys(reading, table, section, table_path);
  for (const std::string& condition : around.conditions) keys.assume(condition);
  ReadTable result{storages_of(section), {}};
  for (Storage& storage : result.storages) storage.read(keys);
  try {
    reading.problems.throw_if_any();
  } catch (const UserError& error) {
    result.problems = error.what();
  }
  return result;
}

ReadTable read_with(const std::string& section, const Surroundings& around, const Key& key,
                    const std::string& value) {
  toml::table table = around.table;
  const toml::table given = toml::parse(fmt::format("{} = {}", key.name, value));
  given.get(key.name)->visit([&](const auto& node) { table.insert_or_assign(key.name, node); });
  return read_table(section, around, table);
}

void for_each_row(const std::function<void(const std::string&, const Key&)>& visit) {
  for (const SchemaSection& section : schema())
    for (const Key& key : section.keys) visit(std::string(section.name), key);
}
void for_each_stored_row(
    const std::function<void(const std::string&, const Key&, const Surroundings&)>& visit) {
  for_each_row([&](const std::string& section, const Key& key) {
    if (key.member.structure == nullptr) return;
    SCOPED_TRACE(fmt::format("[{}] {}", section, key.name));
    Surroundings around;
    satisfy(section, key, around);
    visit(section, key, around);
  });
}

TEST(Schema, EveryRowIsReadAndWrittenBack) {
  for_each_stored_row([](const std::string& section, const Key& key, const Surroundings& around) {
    const int dimension = around.description.dimension;
    const IsStored is_stored{key, dimension};
    const auto read = read_with(section, around, key, value_text(key, number_of(key), dimension));
    EXPECT_FALSE(read.complains_of(key)) << read.problems;
    const Storage* storage = read.of(key);
    ASSERT_NE(storage, nullptr);
    EXPECT_TRUE(std::visit(is_stored, storage->value(key)));
    if (!storage->is_model) return;
    Case description = around.description;
    if (key.name == "formulation") description.formulation = Formulation::shinohara2004;
    TomlWriter writer(description);
    storage->write(writer, section, around.conditions);
    const ReadTable again = read_table(section, around, toml::parse(writer.result()));
    EXPECT_FALSE(again.complains_of(key)) << again.problems;
    EXPECT_TRUE(std::visit(is_stored, again.of(key)->value(key))) << writer.result();
  });
}

// The values are out of range, or of another type if any number is allowed.
std::vector<std::string> wrong_values(const Key& key, int dimension) {
  std::vector<std::string> values;
  const Range& range = key.range;
  const bool has_numbers = !entry_text(key, 1.0).empty();
  if (has_numbers && std::isfinite(range.minimum)) {
    values.push_back(value_text(key, range.minimum - 1.0, dimension));
    if (range.open_minimum) values.push_back(value_text(key, range.minimum, dimension));
  }
  if (has_numbers && std::isfinite(range.maximum)) {
    values.push_back(value_text(key, range.maximum + 1.0, dimension));
    if (range.open_maximum) values.push_back(value_text(key, range.maximum, dimension));
  }
  const bool is_text = key.kind == ValueKind::text || key.kind == ValueKind::name;
  values.emplace_back(is_text ? "1" : "\"1 +\"");
  return values;
}

TEST(Schema, EveryRowIsRefusedOutOfItsRange) {
  for_each_stored_row([](const std::string& section, const Key& key, const Surroundings& around) {
    for (const std::string& value : wrong_values(key, around.description.dimension)) {
      const ReadTable read = read_with(section, around, key, value);
      EXPECT_TRUE(read.complains_of(key)) << value << '\n' << read.problems;
      EXPECT_NE(read.problems.find("Allowed: "), std::string::npos) << read.problems;
    }
  });
}

TEST(Schema, EveryRowIsRequiredOrHasADefault) {
  for_each_stored_row([](const std::string& section, const Key& key, const Surroundings& around) {
    const ReadTable read = read_table(section, around, around.table);
    const std::string missing = fmt::format("{}.{}: the key is missing", table_path, key.name);
    EXPECT_EQ(read.problems.find(missing) != std::string::npos, key.required()) << read.problems;
    if (key.required() || key.computed()) return;
    const ValueReference value = read.of(key)->value(key);
    if (const auto* number = std::get_if<double*>(&value)) {
      EXPECT_EQ(**number, standard_number(key));
    } else if (const auto* whole = std::get_if<int*>(&value)) {
      EXPECT_EQ(**whole, standard_number(key));
    } else if (const auto* flag = std::get_if<bool*>(&value)) {
      EXPECT_EQ(**flag, key.standard.text == "true");
    } else if (const auto* word = std::get_if<WordReference>(&value)) {
      EXPECT_EQ(key.choices[word->get(word->value)], key.standard.text);
    }
  });
}

// Only these values are read by separate code; all others are stored by their rows.
TEST(Schema, RowsWithoutAMemberAreListed) {
  std::set<std::string> by_hand;
  for_each_row([&](const std::string& section, const Key& key) {
    const bool is_table = key.kind == ValueKind::table || key.kind == ValueKind::tables;
    if (!is_table && key.member.structure == nullptr)
      by_hand.insert(fmt::format("{}.{}", section, key.name));
  });
  EXPECT_EQ(by_hand, (std::set<std::string>{"materials.base", "body.velocity", "jet.profile",
                                            "output.frame_interval"}));
}

TEST(Schema, IsConsistent) {
  for_each_row([](const std::string& section, const Key& key) {
    SCOPED_TRACE(fmt::format("[{}] {}", section, key.name));
    EXPECT_FALSE(key.sentence.empty() || key.sentence.back() == '.');
    const bool has_choices = key.kind == ValueKind::word || key.kind == ValueKind::faces ||
                             key.kind == ValueKind::expression ||
                             key.kind == ValueKind::expressions;
    EXPECT_EQ(has_choices, !key.choices.empty());
    const bool is_number = key.kind == ValueKind::number || key.kind == ValueKind::quantity;
    if (is_number && !key.computed() && !key.required() && !key.may_be_none()) {
      EXPECT_TRUE(in_range(key, standard_number(key)));
    }
  });
}

TEST(Schema, KeysPageIsUpToDate) {
  std::ifstream stream(KERF_SOURCE_DIR "/docs/keys.md");
  const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_EQ(page, keys_page()) << "write it again: kerf check --keys > docs/keys.md";
}

}  // namespace
}  // namespace kerf
