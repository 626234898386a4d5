// SPDX-License-Identifier: Apache-2.0
// libFuzzer: whatever the text, the reader either refuses it with a UserError or returns a case
// that comes back bit for bit from what write_used makes of it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const kerf::Case read = kerf::parse_case(text, "fuzz.toml");
    if (kerf::parse_case(kerf::write_used(read), "case.used.toml") != read) std::abort();
  } catch (const kerf::UserError&) {
    return 0;
  }
  return 0;
}
