# SPDX-License-Identifier: Apache-2.0
# Who may know whom.
target_link_libraries(kerf_case PUBLIC fmt::fmt PRIVATE tomlplusplus::tomlplusplus udunits2
  PkgConfig::muparser Boost::headers assimp::assimp)
target_link_libraries(kerf_engine PUBLIC kerf_case kerf_thrust Eigen3::Eigen
  PRIVATE Boost::headers Boost::filesystem)
target_link_libraries(kerf_measure PUBLIC kerf_case Boost::headers)
target_include_directories(kerf_output SYSTEM PRIVATE ${HDF5_INCLUDE_DIRS})
target_link_libraries(kerf_output PUBLIC kerf_engine kerf_measure nlohmann_json::nlohmann_json
  PRIVATE ${HDF5_LIBRARIES} Boost::headers)
target_link_libraries(kerf_report PUBLIC kerf_output PkgConfig::cairo
  PRIVATE PkgConfig::plplot Boost::headers Boost::filesystem ZLIB::ZLIB nlohmann_json::nlohmann_json)
target_link_libraries(kerf_verify PUBLIC kerf_engine kerf_measure kerf_output tomlplusplus::tomlplusplus
  PRIVATE nlohmann_json::nlohmann_json)
target_include_directories(kerf_study SYSTEM PRIVATE ${HDF5_INCLUDE_DIRS})
target_link_libraries(kerf_study PUBLIC kerf_case kerf_measure kerf_output kerf_report tomlplusplus::tomlplusplus
  Eigen3::Eigen PRIVATE SQLiteCpp nlohmann_json::nlohmann_json Boost::headers Boost::filesystem
  PkgConfig::nlopt Threads::Threads)
target_link_libraries(kerf_app PUBLIC kerf_engine kerf_measure kerf_report kerf_study kerf_verify
  CLI11::CLI11 spdlog::spdlog
  PRIVATE httplib)
