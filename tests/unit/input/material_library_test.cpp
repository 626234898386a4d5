// SPDX-License-Identifier: Apache-2.0
// The files of the library, its sources, and its use in a case.
#include "input/material_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include "input/read.hpp"
#include "input/schema.hpp"
#include "input/units.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

const std::filesystem::path library = KERF_SOURCE_DIR "/materials";

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(MaterialLibrary, EqualsTheFolder) {
  std::set<std::string> files, embedded;
  for (const auto& entry : std::filesystem::directory_iterator(library))
    files.insert(entry.path().filename());
  for (const EmbeddedText& text : material_files()) {
    const std::string file = std::string(text.name) + ".toml";
    embedded.insert(file);
    EXPECT_EQ(text.text, content(library / file)) << file;
  }
  EXPECT_EQ(embedded, files);
  EXPECT_EQ(material_library().size(), files.size());
}

TEST(MaterialLibrary, HasTheRequiredMaterials) {
  for (const char* name : {"tofu",
                           "gelatin-5",
                           "gelatin-10",
                           "gelatin-20",
                           "silicone",
                           "polyurethane-foam",
                           "liver",
                           "cortical-bone",
                           "trabecular-bone",
                           "pmma",
                           "sandstone",
                           "granite",
                           "concrete",
                           "aluminium-6061",
                           "copper",
                           "glass",
                           "muscle",
                           "skin",
                           "apple",
                           "natural-rubber",
                           "leather",
                           "polyethylene-foam",
                           "softwood",
                           "polyacrylamide",
                           "agar",
                           "bread",
                           "cardboard",
                           "fat"})
    EXPECT_NE(find_library_material(name), nullptr) << name;
  EXPECT_EQ(find_library_material("unobtainium"), nullptr);
}

// The values of these three materials equal the published ones bit for bit.
TEST(MaterialLibrary, ReferenceMaterialsHaveTheirPublishedValues) {
  Material tofu;
  tofu.name = "tofu";
  tofu.kind = MaterialKind::elastic;
  tofu.density = 940.0;
  tofu.youngs_modulus = 1.0e5;
  tofu.poisson_ratio = 0.3;
  tofu.failure_strain = 0.1;
  tofu.artificial_linear = tofu.artificial_quadratic = 0.5;
  tofu.source =
      "Kerf's library: Bean curd as the founding paper has it; real tofu is nearly incompressible";
  EXPECT_EQ(find_library_material("tofu")->material(), tofu);
  tofu.artificial_linear = tofu.artificial_quadratic = 2.5;  // of the paper
  EXPECT_EQ(find_library_material("tofu")->material(Formulation::shinohara2004), tofu);
  Material water;
  water.name = "water";
  water.viscosity = 1.0e-3;
  water.artificial_linear = 0.01;
  water.source =
      "Kerf's library: Water at 20 C; its speed of sound is ten times the fastest speed of the "
      "case, eq. (18)";
  EXPECT_EQ(find_library_material("water")->material(), water);
  Material rubber;
  rubber.name = "rubber";
  rubber.kind = MaterialKind::elastic;
  rubber.youngs_modulus = 1.0e7;
  rubber.poisson_ratio = 0.3975;
  rubber.artificial_linear = rubber.artificial_quadratic = 1.0;
  rubber.artificial_softening = 0.01;
  rubber.source = "Kerf's library: Rubber of the colliding rings of Gray, Monaghan & Swift (2001)";
  EXPECT_EQ(find_library_material("rubber")->material(), rubber);
}

// A source has author and year, or an address; a chosen number has its reason.
void expect_source(const LibraryMaterial& material, const LibraryValue& value) {
  static const std::regex named(
      "(19|20)[0-9][0-9]|https?://[a-z]+|^chosen: |^never fractures: |^reference density ");
  EXPECT_GT(value.source.size(), 10u) << material.name << ' ' << value.name;
  EXPECT_TRUE(std::regex_search(value.source, named))
      << material.name << ' ' << value.name << ": " << value.source;
  if (value.interval) {
    EXPECT_TRUE(std::regex_search(value.interval->sources, named))
        << material.name << ' ' << value.name << ": " << value.interval->sources;
    EXPECT_LT(value.interval->low, value.interval->high) << material.name << ' ' << value.name;
    EXPECT_LE(value.interval->low, value.value) << material.name << ' ' << value.name;
    EXPECT_GE(value.interval->high, value.value) << material.name << ' ' << value.name;
  }
  EXPECT_EQ((value.source + value.note).find('|'), std::string::npos) << "breaks a table";
}

TEST(MaterialLibrary, EveryValueHasASource) {
  for (const LibraryMaterial& material : material_library()) {
    EXPECT_FALSE(material.title.empty() || material.title.back() == '.') << material.name;
    EXPECT_GE(material.values.size(), 3u) << material.name;
    for (const LibraryValue& value : material.values) expect_source(material, value);
    for (const LibraryValue& value : material.known) expect_source(material, value);
  }
}

// Not to be cut: the published rings bounce, and metals need an abrasive.
const std::set<std::string> not_to_be_cut{"rubber", "copper", "aluminium-6061"};

// A fracture energy is a value, or known besides where the process zone of a crack is wider than
// jets are, so that the strength decides; else a note says that none was found.
TEST(MaterialLibrary, EveryMaterialToBeCutHasAStrength) {
  const std::set<std::string> published{"tofu"};
  for (const LibraryMaterial& entry : material_library()) {
    if (entry.kind == MaterialKind::water) continue;
    EXPECT_EQ(entry.material().can_break(), not_to_be_cut.count(entry.name) == 0) << entry.name;
    bool has_energy = false, says_so = false;
    for (const auto* list : {&entry.values, &entry.known})
      for (const LibraryValue& value : *list) {
        has_energy = has_energy || value.name == "fracture_energy";
        says_so = says_so || value.note.find("o fracture energy was found") != std::string::npos;
      }
    EXPECT_TRUE(has_energy || says_so || not_to_be_cut.count(entry.name) != 0 ||
                published.count(entry.name) != 0)
        << entry.name;
  }
}

// A value with the name of a case key belongs to [[values]]. Exceptions are a key that replaces a
// strain in one formulation, and keys of laws of plasticity, which a case chooses.
TEST(MaterialLibrary, InformativeValuesAreNotCaseKeys) {
  for (const KnownQuantity& quantity : known_quantities()) {
    const std::set<std::string> plain{"elastic", "water", "standard", "none"};
    const Key* key = find_key("materials", quantity.name, plain);
    const bool is_key = key && key->applies_under(plain);
    EXPECT_EQ(is_key, quantity.name == "fracture_energy") << quantity.name;
  }
}

// A wrong prefix (MPa instead of kPa) would appear in the wave speed or in the order of the
// strengths.
TEST(MaterialLibrary, ValuesArePhysical) {
  const auto known = [](const LibraryMaterial& material, const std::string& name) {
    for (const LibraryValue& value : material.known)
      if (value.name == name) return value.value;
    const LibraryValue* used = material.find(name);
    return used ? used->value : 0.0;
  };
  for (const LibraryMaterial& entry : material_library()) {
    const Material material = entry.material();
    EXPECT_GT(material.density, 20.0) << entry.name;
    EXPECT_LT(material.density, 10000.0) << entry.name;
    if (material.kind == MaterialKind::water) continue;
    const double rod_speed = std::sqrt(material.youngs_modulus / material.density);
    EXPECT_GT(rod_speed, 1.0) << entry.name;
    EXPECT_LT(rod_speed, 6000.0) << entry.name;
    // Brittle materials are stronger in compression, and the strengths of stiff ones are far below
    // the modulus; soft ones stretch far before they break.
    const double tension = known(entry, "tensile_strength");
    const double compression = known(entry, "compressive_strength");
    if (compression > 0.0 && tension > 0.0) {
      EXPECT_GT(compression, tension) << entry.name;
    }
    if (material.youngs_modulus > 1e8) {
      EXPECT_LT(tension, 0.1 * material.youngs_modulus) << entry.name;
    }
  }
}

std::string case_of(const std::string& material) {
  return "title = \"a block\"\ndimension = 2\n[time]\nend = \"1 ms\"\n[[body]]\nname = \"block\"\n"
         "material = \"" +
         material +
         "\"\nshape = { type = \"box\", minimum = [\"0 mm\", \"0 mm\"], maximum = [\"20 mm\", \"20 "
         "mm\"] }\nspacing = \"2 mm\"\n[[jet]]\nname = \"jet\"\nspeed = \"50 m/s\"\nwidth = \"10 "
         "mm\"\nposition = [\"10 mm\", \"20 mm\"]\nstandoff = \"20 mm\"\nspacing = \"1 mm\"\n";
}

TEST(MaterialLibrary, EveryMaterialMakesACase) {
  for (const LibraryMaterial& entry : material_library()) {
    const Case read = parse_case(case_of(entry.name), "block.toml");
    const Material& used = read.materials.at(static_cast<std::size_t>(read.bodies.at(0).material));
    Material expected = entry.material(read.formulation);
    expected.sound_speed = used.sound_speed;  // computed from the case
    EXPECT_EQ(used, expected) << entry.name;
  }
}

// Values that a file omits have the defaults of a case file.
TEST(MaterialLibrary, MissingValuesHaveTheDefaults) {
  const Material copper = find_library_material("copper")->material();
  EXPECT_EQ(copper.failure_strain, 0.0);
  EXPECT_EQ(copper.artificial_linear, 0.5);
  EXPECT_EQ(copper.artificial_quadratic, 0.5);
  EXPECT_EQ(copper.artificial_softening, 0.1);
}

TEST(MaterialLibrary, PageIsUpToDate) {
  EXPECT_EQ(content(KERF_SOURCE_DIR "/docs/materials.md"), materials_page())
      << "write it again: kerf materials --page > docs/materials.md";
}

const std::string good =
    "title = \"gum\"\nkind = \"elastic\"\n"
    "[[values]]\nkey = \"density\"\nvalue = \"1 g/cm3\"\nsource = \"weighed\"\n"
    "[[values]]\nkey = \"youngs_modulus\"\nvalue = \"2 kPa\"\nsource = \"pulled\"\nnote = "
    "\"cold\"\n"
    "[[values]]\nkey = \"poisson_ratio\"\nvalue = 0.25\nsource = \"pulled\"\n"
    "[[known]]\nname = \"fracture_energy\"\nvalue = \"1 kJ/m2\"\nsource = \"test\"\n";

TEST(MaterialFile, IsRead) {
  const LibraryMaterial gum = read_library_material("gum", good);
  EXPECT_EQ(gum.name, "gum");
  EXPECT_EQ(gum.title, "gum");
  EXPECT_EQ(gum.values.at(0).value, 1000.0);
  EXPECT_EQ(gum.values.at(1).written, "2 kPa");
  EXPECT_EQ(gum.values.at(1).source, "pulled");
  EXPECT_EQ(gum.values.at(1).note, "cold");
  EXPECT_EQ(gum.known.at(0).name, "fracture_energy");
  EXPECT_EQ(gum.known.at(0).value, 1000.0);
  EXPECT_EQ(gum.material().youngs_modulus, 2000.0);
}

void expect_refused(const std::string& from, const std::string& to, const std::string& because) {
  std::string text = good;
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    read_library_material("gum", text);
    ADD_FAILURE() << "read with " << to;
  } catch (const std::logic_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("materials/gum.toml: "));
    EXPECT_THAT(error.what(), testing::HasSubstr(because));
  }
}

TEST(MaterialFile, RefusesForeignKeys) {
  expect_refused("source = \"weighed\"\n", "", "source must be a text");
  expect_refused("source = \"test\"\n", "source = \"\"\n", "source must be a text");
  expect_refused("\"1 g/cm3\"", "1000", "value must be a text");
  expect_refused("\"1 g/cm3\"", "\"1 g/cm2\"", "\"g/cm2\" is not the unit of a density");
  expect_refused("\"1 kJ/m2\"", "\"1 kJ\"", "\"kJ\" is not the unit of an energy per area");
  expect_refused("0.25", "\"0.25\"", "poisson_ratio must be a number");
  expect_refused("0.25", "0.5", "poisson_ratio = 0.5 is out of range");
  expect_refused("\"density\"", "\"viscosity\"",
                 "\"viscosity\" is no number of a material of this kind");
  expect_refused("\"density\"", "\"mass\"", "\"mass\" is no number of a material of this kind");
  expect_refused("\"density\"", "\"poisson_ratio\"", "poisson_ratio must be a number");
  expect_refused("\"fracture_energy\"", "\"toughness\"", "none of the known quantities");
  expect_refused("note", "remark", "unknown key \"remark\"");
  expect_refused("kind = \"elastic\"", "kind = \"gas\"", "unknown kind \"gas\"");
  expect_refused("[[known]]",
                 "[[values]]\nkey = \"density\"\nvalue = \"1 kg/m3\"\nsource = "
                 "\"again\"\n[[known]]",
                 "density is there twice");
  expect_refused("title = \"gum\"", "title = ", "line 1");
  const std::string poisson =
      good.substr(good.rfind("[[values]]"), good.find("[[known]]") - good.rfind("[[values]]"));
  expect_refused(poisson, "", "poisson_ratio is missing");
}

}  // namespace
}  // namespace kerf
