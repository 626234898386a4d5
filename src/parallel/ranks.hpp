// SPDX-License-Identifier: Apache-2.0
// The ranks of a run: the processes that mpirun starts, each of which computes a part of the
// particles (docs/mpi.md). They are numbered from 0. Without MPI in the build there is one rank,
// and these functions do nothing. All ranks must call them in the same order, on the thread that
// opened the session.
#pragma once

#include <build_options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace kerf::ranks {

using Bytes = std::vector<std::byte>;

#if defined(KERF_MPI) && !defined(KERF_ON_GPU)

inline constexpr bool exist = true;

// Opens MPI for the life of the object.
class Session {
 public:
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

int count();   // 1 without a session
int number();  // of this one
// Ends all ranks at once with an exit code.
[[noreturn]] void abort(int code);

// Sets `all` to the `bytes` bytes at `own` of every rank, one after the other.
void gather_from_all(const void* own, std::size_t bytes, void* all);
// Replaces whole numbers by their sums over the ranks.
void add_over_all(std::int64_t* values, std::size_t number);
// Replaces the bytes by those of rank 0.
void broadcast(Bytes& bytes);
// Sends to[r] to rank r and returns what each rank has sent.
std::vector<Bytes> exchange(const std::vector<Bytes>& to);
// The same, where the lengths of what comes are those of `from`.
void exchange_known(const std::vector<Bytes>& to, std::vector<Bytes>& from);

#else

inline constexpr bool exist = false;

class Session {
 public:
  Session(int&, char**&) {}
};

constexpr int count() {
  return 1;
}
constexpr int number() {
  return 0;
}
inline void gather_from_all(const void* own, std::size_t bytes, void* all) {
  std::memcpy(all, own, bytes);
}
inline void add_over_all(std::int64_t*, std::size_t) {}
inline std::vector<Bytes> exchange(const std::vector<Bytes>& to) {
  return to;
}
inline void exchange_known(const std::vector<Bytes>& to, std::vector<Bytes>& from) {
  from = to;
}

#endif

inline bool are_several() {
  return exist && count() > 1;
}

// Returns what each rank has.
template <class T>
std::vector<T> all(const T& own) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> values(static_cast<std::size_t>(count()), own);
  if (are_several()) gather_from_all(&own, sizeof(T), values.data());
  return values;
}

// Returns what the ranks have, combined in the order of their numbers.
template <class T, class Combine>
T combined(const T& own, const Combine& combine) {
  if (!are_several()) return own;
  const std::vector<T> values = all(own);
  T result = values.front();
  for (std::size_t r = 1; r < values.size(); ++r) result = combine(result, values[r]);
  return result;
}

inline bool any(bool own) {
  const auto either = [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); };
  return combined(static_cast<std::uint8_t>(own ? 1 : 0), either) != 0;
}

template <class Whole>
std::uint64_t total(Whole own) {
  return combined(static_cast<std::uint64_t>(own),
                  [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

// Returns the entries as a message.
template <class T>
Bytes to_bytes(const std::vector<T>& entries) {
  static_assert(std::is_trivially_copyable_v<T>);
  Bytes message(entries.size() * sizeof(T));
  if (!entries.empty()) std::memcpy(message.data(), entries.data(), message.size());
  return message;
}
// Appends the entries of a message.
template <class T>
void append_entries(const Bytes& message, std::vector<T>& entries) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t before = entries.size();
  entries.resize(before + message.size() / sizeof(T));
  if (!message.empty()) std::memcpy(entries.data() + before, message.data(), message.size());
}

// Returns the entries of all ranks, one rank after the other.
template <class T>
std::vector<T> collected(const std::vector<T>& own) {
  if (!are_several()) return own;
  std::vector<T> result;
  const std::vector<Bytes> to(static_cast<std::size_t>(count()), to_bytes(own));
  for (const Bytes& message : exchange(to)) append_entries(message, result);
  return result;
}

}  // namespace kerf::ranks
