// SPDX-License-Identifier: Apache-2.0
// The recursive coordinate bisection of Zoltan (Devine et al., Comput. Sci. Eng. 4 (2002) 90).
#include <mpi.h>
#include <zoltan.h>

#include <cstddef>
#include <string>

#include "core/error.hpp"
#include "distributed/partition.hpp"
#include "parallel/ranks.hpp"

namespace kerf {
namespace {

using Points = std::vector<PointOfWork>;

const Points& points_at(void* data) {
  return *static_cast<const Points*>(data);
}

int number_of_points(void* data, int* error) {
  *error = ZOLTAN_OK;
  return static_cast<int>(points_at(data).size());
}

// An object has the number of its rank and its own number there.
// budget: arguments: those of a callback of Zoltan
void list_points(void* data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float* work,
                 int* error) {
  const Points& points = points_at(data);
  for (std::size_t k = 0; k < points.size(); ++k) {
    global[2 * k] = static_cast<ZOLTAN_ID_TYPE>(ranks::number());
    global[2 * k + 1] = local[k] = static_cast<ZOLTAN_ID_TYPE>(k);
    work[k] = points[k].work;
  }
  *error = ZOLTAN_OK;
}

// Zoltan holds a partition for each object of its library.
class ZoltanPartition : public Partition {
 public:
  ZoltanPartition(const Points& points, int dimension, int parts)
      : points_(points), dimension_(dimension), zoltan_(Zoltan_Create(MPI_COMM_WORLD)) {
    require(zoltan_ != nullptr, "memory for Zoltan");
    for (const auto& [name, value] : {std::pair{"DEBUG_LEVEL", "0"},
                                      {"LB_METHOD", "RCB"},
                                      {"KEEP_CUTS", "1"},
                                      {"RETURN_LISTS", "NONE"},
                                      {"NUM_GID_ENTRIES", "2"},
                                      {"NUM_LID_ENTRIES", "1"},
                                      {"OBJ_WEIGHT_DIM", "1"}})
      Zoltan_Set_Param(zoltan_, name, value);
    Zoltan_Set_Param(zoltan_, "NUM_GLOBAL_PARTS", std::to_string(parts).c_str());
    Zoltan_Set_Num_Obj_Fn(zoltan_, number_of_points, &points_);
    Zoltan_Set_Obj_List_Fn(zoltan_, list_points, &points_);
    Zoltan_Set_Num_Geom_Fn(zoltan_, number_of_coordinates, this);
    Zoltan_Set_Geom_Multi_Fn(zoltan_, list_coordinates, this);
    divide();
    points_.clear();
  }
  ~ZoltanPartition() override { Zoltan_Destroy(&zoltan_); }
  ZoltanPartition(const ZoltanPartition&) = delete;
  ZoltanPartition& operator=(const ZoltanPartition&) = delete;

  int owner(const std::array<double, 3>& point) const override {
    auto coordinates = point;
    int rank = 0, part = 0;
    const int code = Zoltan_LB_Point_PP_Assign(zoltan_, coordinates.data(), &rank, &part);
    require(code == ZOLTAN_OK, "the part of a point");
    return part;
  }

 private:
  static const ZoltanPartition& self(void* data) {
    return *static_cast<const ZoltanPartition*>(data);
  }
  static int number_of_coordinates(void* data, int* error) {
    *error = ZOLTAN_OK;
    return self(data).dimension_;
  }
  // budget: arguments: those of a callback of Zoltan
  static void list_coordinates(void* data, int, int, int number, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local,
                               int dimension, double* coordinates, int* error) {
    const auto wide = static_cast<std::size_t>(dimension);
    for (std::size_t k = 0; k < static_cast<std::size_t>(number); ++k)
      for (std::size_t a = 0; a < wide; ++a)
        coordinates[wide * k + a] = self(data).points_[local[k]].position[a];
    *error = ZOLTAN_OK;
  }
  void divide() {
    int changes = 0, global_size = 0, local_size = 0, imports = 0, exports = 0;
    ZOLTAN_ID_PTR import_global = nullptr, import_local = nullptr, export_global = nullptr,
                  export_local = nullptr;
    int *import_ranks = nullptr, *import_parts = nullptr, *export_ranks = nullptr,
        *export_parts = nullptr;
    const int code =
        Zoltan_LB_Partition(zoltan_, &changes, &global_size, &local_size, &imports, &import_global,
                            &import_local, &import_ranks, &import_parts, &exports, &export_global,
                            &export_local, &export_ranks, &export_parts);
    require(code == ZOLTAN_OK || code == ZOLTAN_WARN, "a partition by Zoltan");
  }

  Points points_;
  int dimension_;
  Zoltan_Struct* zoltan_;
};

}  // namespace

std::shared_ptr<const Partition> make_partition(const std::vector<PointOfWork>& points,
                                                int dimension, int parts) {
  static const int version_read = [] {
    float version = 0.0f;
    return Zoltan_Initialize(0, nullptr, &version);
  }();
  require(version_read == ZOLTAN_OK, "Zoltan");
  return std::make_shared<const ZoltanPartition>(points, dimension, parts);
}

}  // namespace kerf
