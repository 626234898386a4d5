// SPDX-License-Identifier: Apache-2.0
// This header declares the case file that kerf view --edit edits.
#pragma once

#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace kerf {

// The case of a pilot run, and what differs from the case that is edited, a sentence each.
struct PilotFile {
  std::filesystem::path file;
  std::vector<std::string> changes;
};

class CaseEditor {
 public:
  using Json = nlohmann::ordered_json;

  // `file` may not exist yet. An empty one gets its name with the first call of save(), in
  // `folder`.
  CaseEditor(std::filesystem::path file, std::filesystem::path folder);

  // Returns the name of the file, empty as long as it has none.
  std::filesystem::path file() const;

  // Each takes and returns what web/README.md describes; they may be called at the same time. They
  // throw RefusedRequest.
  Json read() const;
  Json check(const Json& request) const;
  Json add(const Json& request) const;
  Json remove(const Json& request) const;
  Json save(const Json& request);
  // Writes the case of the pilot run beside the case file. Returns the file and the changes.
  PilotFile write_pilot(const Json& request) const;
  // Returns the text of a template. Writes its meshes into the folder of the case, as kerf new
  // does.
  Json from_template(const Json& request) const;

 private:
  std::filesystem::path named(const Json& request) const;
  // Returns the name in messages.
  std::string shown_name() const;

  std::filesystem::path file_, folder_;
  mutable std::mutex mutex_;
};

}  // namespace kerf
