# SPDX-License-Identifier: Apache-2.0
# kerf_embed runs this script at build time. It writes OUTPUT, a C++ file that contains FILES as texts.
set(texts "")
set(entries "")
set(number 0)
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  if(WITH_FOLDER)
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(folder ${folder} NAME)
    set(name ${folder}/${name})
  endif()
  file(READ ${file} text)
  string(LENGTH "${text}" length)
  if(length GREATER 8000000 OR text MATCHES "\\)embedded\"")
    message(FATAL_ERROR "${file} cannot be embedded")
  endif()
  # The length is explicit because compilers count long texts slowly.
  string(APPEND texts "constexpr char text_${number}[] = R\"embedded(${text})embedded\";\n")
  string(APPEND entries
    "    {\"${name}\", {text_${number}, sizeof(text_${number}) - 1}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Made by cmake/KerfEmbedScript.cmake.
#include <span>

#include \"core/embedded_text.hpp\"

namespace kerf {

namespace {
${texts}
constexpr EmbeddedText texts[] = {
${entries}};
}  // namespace

std::span<const EmbeddedText> ${FUNCTION}() { return texts; }

}  // namespace kerf
")
