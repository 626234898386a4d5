# SPDX-License-Identifier: Apache-2.0
# Run by kerf_embed at build time: writes OUTPUT, a C++ file that holds FILES as texts.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  if(WITH_FOLDER)
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(folder ${folder} NAME)
    set(name ${folder}/${name})
  endif()
  file(READ ${file} text)
  # Compilers take texts of up to 64 KiB; one line of a case is far shorter.
  string(LENGTH "${text}" length)
  if(length GREATER 60000 OR text MATCHES "\\)embedded\"")
    message(FATAL_ERROR "${file} cannot be embedded")
  endif()
  string(APPEND entries "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by cmake/KerfEmbedScript.cmake.
#include <span>

#include \"core/embedded_text.hpp\"

namespace kerf {

namespace {
constexpr EmbeddedText texts[] = {
${entries}};
}  // namespace

std::span<const EmbeddedText> ${FUNCTION}() { return texts; }

}  // namespace kerf
")
