# SPDX-License-Identifier: Apache-2.0
# Embeds text files in a program, so that it needs no data folder:
#   kerf_embed(target function files...)
# adds to `target` a source file that defines, in namespace kerf,
#   std::span<const EmbeddedText> function();
# with the names (without extension) and contents of the files (core/embedded_text.hpp). With
# WITH_FOLDER a name starts with that of the folder of the file ("rod-wave/case").
set(KERF_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/KerfEmbedScript.cmake)

function(kerf_embed target function)
  cmake_parse_arguments(ARG "WITH_FOLDER" "" "" ${ARGN})
  set(output ${CMAKE_BINARY_DIR}/generated/embedded/${target}/${function}.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${function}
            -DWITH_FOLDER=${ARG_WITH_FOLDER} "-DFILES=${ARG_UNPARSED_ARGUMENTS}"
            -P ${KERF_EMBED_SCRIPT}
    DEPENDS ${ARG_UNPARSED_ARGUMENTS} ${KERF_EMBED_SCRIPT}
    COMMENT "Embedding ${function}"
    VERBATIM)
  # The C++ standard requires compilers to support only 65536 characters.
  set_source_files_properties(${output} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
  # A library of its own: within `target` the command would wait for all libraries that the target links to.
  add_library(kerf_${function} OBJECT ${output})
  kerf_layer_folder(core folder)
  target_include_directories(kerf_${function} PRIVATE ${folder})
  target_link_libraries(kerf_${function} PRIVATE kerf_flags)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:kerf_${function}>)
endfunction()

file(GLOB kerf_material_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/materials/*.toml)
kerf_embed(kerf_input material_files ${kerf_material_files})
file(GLOB kerf_case_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/cases/*.toml
  ${CMAKE_SOURCE_DIR}/cases/machine/*.toml ${CMAKE_SOURCE_DIR}/cases/cuts/*.toml)
kerf_embed(kerf_app case_templates ${kerf_case_files})
file(GLOB kerf_mesh_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/cases/machine/*.stl)
kerf_embed(kerf_app case_meshes ${kerf_mesh_files})
file(GLOB kerf_study_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/cases/studies/*.toml)
kerf_embed(kerf_app study_templates ${kerf_study_files})
file(GLOB kerf_validation_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/validation/*/*.toml)
kerf_embed(kerf_app validation_texts WITH_FOLDER ${kerf_validation_files})
file(GLOB kerf_experiment_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/experiments/*/*.toml)
kerf_embed(kerf_app experiment_texts WITH_FOLDER ${kerf_experiment_files})
