// SPDX-License-Identifier: Apache-2.0
// libFuzzer: whatever a checkpoint holds, a run continues from it for two steps or refuses it. Most
// inputs are changes of the arrays and texts of a real checkpoint, which is then written with its
// checksum; the others are changes of the bytes of its file, whose checksum is then wrong.
#include "fuzz/fuzzed.hpp"
#include "fuzz/small_run.hpp"
#include "output/checkpoint.hpp"
#include "output/files.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

struct SavedRun {
  SavedRun() {
    RunLoop loop(small_settings(folder.path(), Existing::refuse), make_simulation);
    loop.start();
    int steps = 0;
    loop.advance([&] { return ++steps > 8; });
    loop.save();
    case_text = loop.settings().case_text;
    file = content_of(checkpoint());
    series = content_of(folder / "series.csv");
    content = read_checkpoint(checkpoint(), case_text);
  }
  std::filesystem::path checkpoint() const { return folder / "checkpoint.h5"; }

  TemporaryFolder folder;
  std::string case_text, file, series;
  Checkpoint content;
};

SavedRun& saved_run() {
  static SavedRun made;
  return made;
}

template <class T>
void change_values(std::vector<T>& values, unsigned kind, std::size_t place, std::uint64_t bits) {
  T value{};
  std::memcpy(&value, &bits, sizeof(T));
  if (kind == 0) values.resize(place % 4096);
  if (kind == 1) values.insert(values.end(), place % 64, value);
  if (kind >= 2 && !values.empty()) values[place % values.size()] = value;
}

void change_archive(Archive& archive, Numbers& numbers) {
  const auto choice = numbers.take<std::uint16_t>();
  const unsigned kind = numbers.take<std::uint8_t>() % 8;
  const auto place = numbers.take<std::uint16_t>();
  const auto bits = numbers.take<std::uint64_t>();
  const std::size_t all = archive.arrays.size() + archive.texts.size();
  const std::size_t n = all == 0 ? 0 : choice % all;
  if (n < archive.arrays.size()) {
    const auto entry = std::next(archive.arrays.begin(), static_cast<std::ptrdiff_t>(n));
    if (kind == 6)
      archive.arrays.erase(entry);
    else if (kind == 7)
      entry->second = std::vector<float>(place % 256, 1.0f);
    else
      std::visit([&](auto& values) { change_values(values, kind, place, bits); }, entry->second);
  } else if (all > 0) {
    const auto entry =
        std::next(archive.texts.begin(), static_cast<std::ptrdiff_t>(n - archive.arrays.size()));
    if (kind == 6)
      archive.texts.erase(entry);
    else
      entry->second = std::string(reinterpret_cast<const char*>(&bits), place % 9);
  }
}

// Each change: where in the file, what is done there, and a byte.
std::string changed_file(Numbers& numbers) {
  std::string file = saved_run().file;
  while (!numbers.empty()) {
    const auto place = numbers.take<std::uint32_t>() % (file.size() + 1);
    const auto kind = numbers.take<std::uint8_t>() % 4;
    const auto byte = static_cast<char>(numbers.take<std::uint8_t>());
    if (kind == 0)
      file.resize(place);
    else if (kind == 1)
      file.erase(place, static_cast<unsigned char>(byte));
    else if (place < file.size())
      file[place] = kind == 2 ? byte : static_cast<char>(file[place] ^ byte);
    if (file.empty()) break;
  }
  return file;
}

void resume() {
  RunLoop loop(small_settings(saved_run().folder.path(), Existing::resume), make_simulation);
  if (!loop.start()) return;
  int steps = 0;
  loop.advance([&] { return ++steps > 2; });
}

}  // namespace
}  // namespace kerf::test

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace kerf::test;
  saved_run();
  std::vector<std::string> inputs{std::string(9, '\0')};
  for (char n = 0; n < 100; n = static_cast<char>(n + 1))
    for (const char kind : {0, 2, 6}) {
      std::string input{'\1', n, '\0', kind, '\2', '\0'};
      inputs.push_back(input + "\xff\xff\xff\xff\xff\xff\xef\x7f");
    }
  put_first_inputs(*argc, *argv, inputs);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kerf::test;
  Numbers numbers(data, size);
  put(saved_run().folder / "series.csv", saved_run().series);
  if (numbers.take<std::uint8_t>() % 4 == 0) {
    put(saved_run().checkpoint(), changed_file(numbers));
  } else {
    kerf::Checkpoint changed = saved_run().content;
    while (!numbers.empty())
      change_archive(numbers.take<std::uint8_t>() % 4 == 0 ? changed.run : changed.simulation,
                     numbers);
    kerf::write_checkpoint(saved_run().checkpoint(), saved_run().case_text, changed);
  }
  read_or_refuse(saved_run().folder.path().string(), resume);
  return 0;
}
