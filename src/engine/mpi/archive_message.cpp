// SPDX-License-Identifier: Apache-2.0
#include "engine/mpi/archive_message.hpp"

#include <cstring>

#include "core/error.hpp"

namespace kerf {
namespace {

void write(const void* from, std::size_t bytes, ranks::Bytes& message) {
  const auto* first = static_cast<const std::byte*>(from);
  message.insert(message.end(), first, first + bytes);
}

// The length and then the entries.
template <class Entries>
void write_all(const Entries& entries, ranks::Bytes& message) {
  const std::uint64_t length = entries.size();
  write(&length, sizeof length, message);
  write(entries.data(), length * sizeof(typename Entries::value_type), message);
}

class Reader {
 public:
  explicit Reader(const ranks::Bytes& message) : message_(message) {}

  bool is_at_end() const { return at_ == message_.size(); }
  template <class Entries>
  Entries all() {
    std::uint64_t length = 0;
    take(&length, sizeof length);
    Entries entries;
    entries.resize(length);
    take(entries.data(), length * sizeof(typename Entries::value_type));
    return entries;
  }
  std::uint8_t byte() {
    std::uint8_t value = 0;
    take(&value, 1);
    return value;
  }

 private:
  void take(void* to, std::size_t bytes) {
    require(at_ + bytes <= message_.size(), "the length of a message between ranks");
    if (bytes > 0) std::memcpy(to, message_.data() + at_, bytes);
    at_ += bytes;
  }

  const ranks::Bytes& message_;
  std::size_t at_ = 0;
};

// Reads an array of the type with that number.
template <std::size_t type = 0>
ArchiveArray read_array(std::size_t wanted, Reader& reader) {
  if (wanted == type) return reader.all<std::variant_alternative_t<type, ArchiveArray>>();
  if constexpr (type + 1 < std::variant_size_v<ArchiveArray>)
    return read_array<type + 1>(wanted, reader);
  require(false, "the type of an array between ranks");
  return {};
}

constexpr std::uint8_t is_text = 255;  // in place of the type of an array

}  // namespace

ranks::Bytes message_of(const Archive& archive) {
  ranks::Bytes message;
  for (const auto& [name, array] : archive.arrays) {
    if (name.starts_with("particles/")) continue;
    const auto type = static_cast<std::uint8_t>(array.index());
    write(&type, 1, message);
    write_all(name, message);
    std::visit([&](const auto& values) { write_all(values, message); }, array);
  }
  for (const auto& [name, text] : archive.texts) {
    write(&is_text, 1, message);
    write_all(name, message);
    write_all(text, message);
  }
  return message;
}

Archive archive_of(const ranks::Bytes& message) {
  Archive archive;
  Reader reader(message);
  while (!reader.is_at_end()) {
    const std::uint8_t type = reader.byte();
    const auto name = reader.all<std::string>();
    if (type == is_text)
      archive.texts[name] = reader.all<std::string>();
    else
      archive.arrays[name] = read_array(type, reader);
  }
  return archive;
}

}  // namespace kerf
