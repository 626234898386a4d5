// SPDX-License-Identifier: Apache-2.0
#include "output/hdf5.hpp"

#include <algorithm>
#include <array>

namespace kerf::hdf5 {
namespace {

constexpr std::size_t memory_growth = 1 << 22;  // bytes

// The library prints its errors by default; here each is reported once, by the exception.
void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle property_list(hid_t kind) {
  return Handle(H5Pcreate(kind), H5Pclose, "make a property list");
}

herr_t add_array(hid_t group, const char* name, const H5L_info_t*, void* names) {
  H5O_info_t object;
  if (H5Oget_info_by_name(group, name, &object, H5P_DEFAULT) < 0) return -1;
  if (object.type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

Handle::Handle(hid_t id, Close close, const char* what) : id_(id), close_(close) {
  if (id_ < 0) throw Error(what);
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

void check(herr_t status, const char* what) {
  if (status < 0) throw Error(what);
}

Handle create() {
  silence();
  const Handle access = property_list(H5P_FILE_ACCESS);
  check(H5Pset_fapl_core(access.get(), memory_growth, 0), "make a file in memory");
  return Handle(H5Fcreate("in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
                "make a file");
}

std::string bytes_of(const Handle& file) {
  check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "finish a file");
  const ssize_t size = H5Fget_file_image(file.get(), nullptr, 0);
  if (size < 0) throw Error("measure a file");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file.get(), bytes.data(), bytes.size()) != size)
    throw Error("copy a file from memory");
  return bytes;
}

Handle open(const std::filesystem::path& path) {
  silence();
  return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open a file");
}

Handle create_group(const Handle& parent, const std::string& name) {
  return Handle(H5Gcreate2(parent.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                H5Gclose, "make a group");
}

Handle open_group(const Handle& parent, const std::string& name) {
  return Handle(H5Gopen2(parent.get(), name.c_str(), H5P_DEFAULT), H5Gclose, "open a group");
}

std::vector<std::string> arrays_in(const Handle& group) {
  std::vector<std::string> names;
  check(H5Lvisit(group.get(), H5_INDEX_NAME, H5_ITER_INC, add_array, &names), "list a group");
  return names;
}

namespace {

// Bytes of like rank are put together and deflated, a chunk of rows at a time.
void pack(const Handle& properties, const std::array<hsize_t, 2>& extent, int rank) {
  constexpr hsize_t most_rows = 1 << 16;
  constexpr unsigned level = 4;
  const std::array<hsize_t, 2> chunk{std::min(extent[0], most_rows), extent[1]};
  check(H5Pset_chunk(properties.get(), rank, chunk.data()), "set a chunk");
  check(H5Pset_shuffle(properties.get()), "set a filter");
  check(H5Pset_deflate(properties.get(), level), "set a filter");
}

}  // namespace

void write_texts(const Handle& parent, const std::string& name,
                 const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a type");
  check(H5Tset_size(type.get(), H5T_VARIABLE), "set a size");
  write(parent, name, {pointers.data(), type.get(), pointers.size(), 1});
}

Handle write(const Handle& parent, const std::string& name, const Block& block, Packing packing) {
  const std::array<hsize_t, 2> extent{block.rows, block.components};
  const int rank = block.components == 1 ? 1 : 2;
  const Handle space(H5Screate_simple(rank, extent.data(), nullptr), H5Sclose, "make a space");
  const Handle properties = property_list(H5P_DATASET_CREATE);
  // Times are not stored, so that equal data make equal bytes.
  check(H5Pset_obj_track_times(properties.get(), false), "set a property");
  if (packing == Packing::deflate && block.rows > 0) pack(properties, extent, rank);
  const Handle link = property_list(H5P_LINK_CREATE);
  check(H5Pset_create_intermediate_group(link.get(), 1), "set a property");
  Handle dataset(H5Dcreate2(parent.get(), name.c_str(), block.type, space.get(), link.get(),
                            properties.get(), H5P_DEFAULT),
                 H5Dclose, "make an array");
  if (block.rows > 0)
    check(H5Dwrite(dataset.get(), block.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, block.data),
          "write an array");
  return dataset;
}

void write_text_attribute(const Handle& object, const std::string& name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a type");
  check(H5Tset_size(type.get(), std::max<std::size_t>(text.size(), 1)), "set a size");
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "set a padding");
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a space");
  const Handle attribute(
      H5Acreate2(object.get(), name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "make an attribute");
  check(H5Awrite(attribute.get(), type.get(), text.c_str()), "write an attribute");
}

std::string read_text_attribute(const Handle& object, const std::string& name) {
  if (H5Aexists(object.get(), name.c_str()) <= 0) return "";
  const Handle attribute(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT), H5Aclose,
                         "open an attribute");
  const Handle type(H5Aget_type(attribute.get()), H5Tclose, "read the type of an attribute");
  std::string text(H5Tget_size(type.get()), '\0');
  check(H5Aread(attribute.get(), type.get(), text.data()), "read an attribute");
  return text.substr(0, text.find('\0'));
}

void write_attribute(const Handle& object, const std::string& name,
                     const std::vector<std::int64_t>& values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "make a space");
  const Handle attribute(H5Acreate2(object.get(), name.c_str(), H5T_NATIVE_INT64, space.get(),
                                    H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "make an attribute");
  check(H5Awrite(attribute.get(), H5T_NATIVE_INT64, values.data()), "write an attribute");
}

Handle open_dataset(const Handle& parent, const std::string& name) {
  return Handle(H5Dopen2(parent.get(), name.c_str(), H5P_DEFAULT), H5Dclose, "open an array");
}

std::size_t size_of(const Handle& dataset) {
  const Handle space(H5Dget_space(dataset.get()), H5Sclose, "open a space");
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0) throw Error("measure an array");
  return static_cast<std::size_t>(count);
}

void read(const Handle& dataset, hid_t type, void* values) {
  check(H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "read an array");
}

bool stored_as(const Handle& dataset, hid_t type) {
  const Handle stored(H5Dget_type(dataset.get()), H5Tclose, "open a type");
  return H5Tequal(stored.get(), type) > 0;
}

}  // namespace kerf::hdf5
