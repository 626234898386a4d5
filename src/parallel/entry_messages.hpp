// SPDX-License-Identifier: Apache-2.0
// Messages between ranks with chosen entries of fields, field by field.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "parallel/loops.hpp"
#include "parallel/ranks.hpp"

namespace kerf {

// Appends the entries of a field to a message, or takes them from `from`, which then moves on.
template <class T>
void put_entries(const Array<T>& field, const std::vector<Index>& which, ranks::Bytes& message) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (field.empty()) return;
  const std::size_t before = message.size();
  message.resize(before + which.size() * sizeof(T));
  std::byte* to = message.data() + before;
  for (const Index s : which) {
    std::memcpy(to, &field[s], sizeof(T));
    to += sizeof(T);
  }
}
template <class T>
void take_entries(const std::byte*& from, const std::vector<Index>& which, Array<T>& field) {
  if (field.empty()) return;
  for (const Index s : which) {
    std::memcpy(static_cast<void*>(&field[s]), from, sizeof(T));
    from += sizeof(T);
  }
}

// How many bytes an entry of each of the fields has in a message. Empty fields are left out.
template <class... T>
std::size_t bytes_of_entries(const Array<T>&... field) {
  return ((field.empty() ? 0 : sizeof(T)) + ...);
}

// Sends entries to[r] of the fields to rank r, and takes those that it sends, awaited[r]. Empty
// fields are left out.
template <class... T>
void exchange_entries(const std::vector<std::vector<Index>>& to,
                      const std::vector<std::vector<Index>>& awaited, Array<T>&... field) {
  std::vector<ranks::Bytes> messages(to.size()), from(to.size());
  const std::size_t bytes = bytes_of_entries(field...);
  for (std::size_t r = 0; r < to.size(); ++r) {
    (put_entries(field, to[r], messages[r]), ...);
    from[r].resize(awaited[r].size() * bytes);
  }
  ranks::exchange_known(messages, from);
  for (std::size_t r = 0; r < to.size(); ++r) {
    const std::byte* at = from[r].data();
    (take_entries(at, awaited[r], field), ...);
  }
}

}  // namespace kerf
