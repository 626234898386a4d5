// SPDX-License-Identifier: Apache-2.0
// A thin layer on the HDF5 C library. Files are made in memory and returned as bytes, so that a
// full disk is found by one plain write (output/files.hpp) and not inside the library.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kerf::hdf5 {

// An error of the library: a file is not HDF5, or does not contain the requested object.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// An identifier that closes itself.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  // Throws Error when `id` reports a failure; `what` names the attempt.
  Handle(hid_t id, Close close, const char* what);
  ~Handle();
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t get() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

void check(herr_t status, const char* what);

template <class T>
hid_t type_of();
template <>
inline hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t type_of<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t type_of<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t type_of<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}
template <>
inline hid_t type_of<std::uint32_t>() {
  return H5T_NATIVE_UINT32;
}
template <>
inline hid_t type_of<std::uint16_t>() {
  return H5T_NATIVE_UINT16;
}
template <>
inline hid_t type_of<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

// A file in memory.
Handle create();
std::string bytes_of(const Handle& file);
Handle open(const std::filesystem::path& path);

Handle create_group(const Handle& parent, const std::string& name);
Handle open_group(const Handle& parent, const std::string& name);
// Visits every array below a group, by its path from there, "inner/name", in order of name.
std::vector<std::string> arrays_in(const Handle& group);

// An array in memory, rows of `components` numbers; components = 1 makes it one-dimensional.
struct Block {
  const void* data = nullptr;
  hid_t type = H5I_INVALID_HID;
  std::size_t rows = 0;
  std::size_t components = 1;
};

template <class T>
Block block(const std::vector<T>& values) {
  return {values.data(), type_of<T>(), values.size(), 1};
}

enum class Packing { none, deflate };

// Writes an array. A name may be a path, "inner/name"; the groups on the path are made.
Handle write(const Handle& parent, const std::string& name, const Block& block,
             Packing packing = Packing::none);
// Writes texts of variable length, which VTK reads.
void write_texts(const Handle& parent, const std::string& name,
                 const std::vector<std::string>& texts);

// Writes fixed-length ASCII, as the VTKHDF format requires.
void write_text_attribute(const Handle& object, const std::string& name, const std::string& text);
// Returns the text of an attribute; empty where the object has none of that name.
std::string read_text_attribute(const Handle& object, const std::string& name);
void write_attribute(const Handle& object, const std::string& name,
                     const std::vector<std::int64_t>& values);

Handle open_dataset(const Handle& parent, const std::string& name);
std::size_t size_of(const Handle& dataset);
void read(const Handle& dataset, hid_t type, void* values);
// Returns whether the array is stored as the type of T.
bool stored_as(const Handle& dataset, hid_t type);

template <class T>
std::vector<T> read_array(const Handle& parent, const std::string& name) {
  const Handle dataset = open_dataset(parent, name);
  std::vector<T> values(size_of(dataset));
  read(dataset, type_of<T>(), values.data());
  return values;
}

}  // namespace kerf::hdf5
