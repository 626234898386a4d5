// SPDX-License-Identifier: Apache-2.0
// Loads and stores of records of packed numbers, on a GPU 16 bytes at a time, and past the cache
// that is kept coherent: nothing may write records in the loop that loads them.
#pragma once

#include <cstdint>
#include <cstring>

#include "core/host_device.hpp"

namespace kerf {

template <class Record>
KERF_FUNCTION Record load_record(const Record* from) {
  static_assert(alignof(Record) % 16 == 0);
#if defined(__CUDA_ARCH__)
  Record record;
  const uint4* parts = reinterpret_cast<const uint4*>(from);
  uint4* const loaded = reinterpret_cast<uint4*>(&record);
#pragma unroll
  for (std::size_t part = 0; part < sizeof(Record) / 16; ++part) loaded[part] = __ldg(parts + part);
  return record;
#else
  return *from;
#endif
}
template <class Record>
KERF_FUNCTION void store_record(const Record& record, Record* to) {
  static_assert(alignof(Record) % 16 == 0);
#if defined(__CUDA_ARCH__)
  const uint4* parts = reinterpret_cast<const uint4*>(&record);
  uint4* const stored = reinterpret_cast<uint4*>(to);
#pragma unroll
  for (std::size_t part = 0; part < sizeof(Record) / 16; ++part) stored[part] = parts[part];
#else
  *to = record;
#endif
}

// Records in parts of 16 bytes: the first parts of all records, then the second ones, and so on, so
// that the threads of a warp load adjacent parts of adjacent records.
struct alignas(16) RecordPart {
  std::uint32_t word[4];
};
// Sets the first `number` parts of each record.
template <class Record>
struct SplitRecords {
  const Record* records;
  std::uint32_t count, number;
  RecordPart* parts;

  KERF_FUNCTION void operator()(std::uint32_t i) const {
    const auto* from = reinterpret_cast<const RecordPart*>(records + i);
    for (std::uint32_t part = 0; part < number; ++part)
      parts[std::size_t(part) * count + i] = load_record(from + part);
  }
};
// Loads the first `number` parts of record i of `count`; the others are undefined.
template <std::uint32_t number, class Record>
KERF_FUNCTION void load_parts(const RecordPart* parts, std::uint32_t count, std::uint32_t i,
                              Record& to) {
  static_assert(number * sizeof(RecordPart) <= sizeof(Record));
  RecordPart loaded[number];
  for (std::uint32_t part = 0; part < number; ++part)
    loaded[part] = load_record(parts + std::size_t(part) * count + i);
  std::memcpy(static_cast<void*>(&to), loaded, sizeof loaded);
}

}  // namespace kerf
