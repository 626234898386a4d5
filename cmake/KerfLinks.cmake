# SPDX-License-Identifier: Apache-2.0
# The libraries that each library links to, from the lowest layer to the highest (KerfLayers.cmake).
target_link_libraries(kerf_model PUBLIC fmt::fmt PRIVATE PkgConfig::muparser Boost::headers)
target_link_libraries(kerf_parallel PUBLIC kerf_flags kerf_thrust)
target_link_libraries(kerf_geometry PUBLIC kerf_model
  PRIVATE kerf_parallel Boost::headers assimp::assimp)
target_link_libraries(kerf_machine PUBLIC kerf_geometry PRIVATE Boost::headers)
target_link_libraries(kerf_input PUBLIC kerf_machine
  PRIVATE tomlplusplus::tomlplusplus udunits2 Boost::headers)
target_link_libraries(kerf_simd PUBLIC kerf_parallel)
target_link_libraries(kerf_simulation PUBLIC kerf_input kerf_parallel kerf_thrust Eigen3::Eigen
  PRIVATE Boost::headers)
target_link_libraries(kerf_engine PUBLIC kerf_simulation kerf_simd_baseline
  PRIVATE Boost::headers Boost::filesystem)
target_link_libraries(kerf_analysis PUBLIC kerf_simulation Boost::headers)
target_include_directories(kerf_output SYSTEM PRIVATE ${HDF5_INCLUDE_DIRS})
target_link_libraries(kerf_output PUBLIC kerf_engine kerf_analysis nlohmann_json::nlohmann_json
  PRIVATE ${HDF5_LIBRARIES} Boost::headers)
target_link_libraries(kerf_report PUBLIC kerf_output PkgConfig::cairo
  PRIVATE Boost::headers Boost::filesystem ZLIB::ZLIB)
target_link_libraries(kerf_verification PUBLIC kerf_output tomlplusplus::tomlplusplus)
target_include_directories(kerf_study SYSTEM PRIVATE ${HDF5_INCLUDE_DIRS})
target_link_libraries(kerf_study PUBLIC kerf_report tomlplusplus::tomlplusplus
  PRIVATE SQLiteCpp Boost::headers Boost::filesystem PkgConfig::nlopt Threads::Threads)
target_link_libraries(kerf_app PUBLIC kerf_study kerf_verification CLI11::CLI11 spdlog::spdlog
  PRIVATE PkgConfig::httplib Threads::Threads)
target_link_libraries(kerf_library PUBLIC kerf_app)
kerf_precompile_headers(headers
  LAYERS model geometry machine parallel simd simulation engine analysis output)
# These layers read files and call the others; -O3 would compile them for a third longer.
kerf_precompile_headers(command_headers HEADERS <fmt/format.h> <nlohmann/json.hpp> LIBRARIES fmt::fmt
  OPTIONS $<$<CONFIG:Release>:-O1> LAYERS input report verification study app library)
