# SPDX-License-Identifier: Apache-2.0
# Builds web/, the scripts of reports, study pages and the editor of cases, with npm and Vite, and embeds it in the program. The
# program is complete without it: where npm is missing or cannot reach its packages, reports have
# still pictures, studies a table and a plain map, and cases are edited as text.
find_program(KERF_NPM npm)
set(kerf_web_folder ${CMAKE_BINARY_DIR}/generated/web)
file(GLOB_RECURSE kerf_web_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/web/src/*)
list(APPEND kerf_web_files ${CMAKE_SOURCE_DIR}/web/package.json ${CMAKE_SOURCE_DIR}/web/package-lock.json
  ${CMAKE_SOURCE_DIR}/web/vite.config.js ${CMAKE_SOURCE_DIR}/web/tsconfig.json)
set(kerf_web_outputs ${kerf_web_folder}/script.js ${kerf_web_folder}/style.css
  ${kerf_web_folder}/study_script.js ${kerf_web_folder}/study_style.css
  ${kerf_web_folder}/edit_script.js ${kerf_web_folder}/edit_style.css)
add_custom_command(
  OUTPUT ${kerf_web_outputs}
  COMMAND ${CMAKE_COMMAND} -DNPM=${KERF_NPM} -DSOURCE=${CMAKE_SOURCE_DIR}/web
          -DFOLDER=${kerf_web_folder} -P ${CMAKE_CURRENT_LIST_DIR}/KerfWebScript.cmake
  DEPENDS ${kerf_web_files} ${CMAKE_CURRENT_LIST_DIR}/KerfWebScript.cmake
  COMMENT "Building the viewer of reports"
  VERBATIM)
kerf_embed(kerf_report viewer_files ${kerf_web_outputs})
