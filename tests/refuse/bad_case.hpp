// SPDX-License-Identifier: Apache-2.0
// A valid case and changes that make it invalid.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {

inline const std::string paper = "formulation = \"shinohara2004\"",
                         gravity = "\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]",
                         block_material = "material = \"tofu\"", speed = "speed = \"5 m/s\"";

inline const std::string good_case = R"(title = "good"
dimension = 2
formulation = "shinohara2004"
gravity = ["0 m/s2", "-9.81 m/s2"]

[time]
end = "10 ms"

[domain]
minimum = ["-100 mm", "-20 mm"]
maximum = ["100 mm", "100 mm"]

[materials.gel]
kind = "elastic"
density = "1000 kg/m3"
youngs_modulus = "60 kPa"
poisson_ratio = 0.4

[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "20 mm"] }
spacing = "2 mm"

[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-40 mm", "-4 mm"], maximum = ["40 mm", "0 mm"] }
spacing = "2 mm"

[[jet]]
name = "jet"
speed = "5 m/s"
width = "10 mm"
position = ["0 mm", "20 mm"]
standoff = "20 mm"
spacing = "1 mm"
)";

struct BadCase {
  std::string name;
  std::string from;                   // text of the valid case ...
  std::string to;                     // ... and its replacement
  std::string at;                     // text in the line that the message must name
  std::string start;                  // what follows "bad.toml:LINE: "
  std::vector<std::string> contains;  // allowed range and remedy
};

inline std::string changed_text(const BadCase& bad) {
  std::string text = good_case;
  const auto place = text.find(bad.from);
  EXPECT_NE(place, std::string::npos) << bad.name;
  if (place != std::string::npos) text.replace(place, bad.from.size(), bad.to);
  return text;
}

// Returns the line of the first occurrence of `what`, from 1.
inline int line_with(const std::string& text, const std::string& what) {
  const auto place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  int line = 1;
  for (std::size_t i = 0; i < place && i < text.size(); ++i) line += text[i] == '\n';
  return line;
}

inline std::string message_of(const std::string& text) {
  try {
    parse_case(text, "bad.toml");
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_bad_input);
    return error.what();
  }
  return "(no error)";
}

inline void expect_refused(const std::vector<BadCase>& table) {
  for (const BadCase& bad : table) {
    const std::string text = changed_text(bad);
    const std::string message = message_of(text);
    const std::string start =
        "bad.toml:" + std::to_string(line_with(text, bad.at)) + ": " + bad.start;
    EXPECT_NE(message.find(start), std::string::npos)
        << bad.name << "\n  wanted " << start << "\n  got    " << message;
    for (const std::string& part : bad.contains)
      EXPECT_NE(message.find(part), std::string::npos)
          << bad.name << "\n  wanted " << part << "\n  got    " << message;
  }
}

}  // namespace kerf
