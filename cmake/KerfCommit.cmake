# SPDX-License-Identifier: Apache-2.0
# Runs at build time and writes OUTPUT, a header that names the commit of SOURCE, with "+" if files
# have uncommitted changes. It does not touch a header that is up to date.
cmake_minimum_required(VERSION 3.25)
find_package(Git QUIET)
set(commit "unknown")
if(Git_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --abbrev=40 --exclude=* --dirty=+
    OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(commit "${said}")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "// Made by cmake/KerfCommit.cmake.
#pragma once

namespace kerf {

inline constexpr const char* build_commit = \"${commit}\";

}  // namespace kerf
")
