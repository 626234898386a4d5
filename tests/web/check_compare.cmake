# SPDX-License-Identifier: Apache-2.0
# Runs CASE and the same case with another speed and end, and compares both with web/test/compare_page.mjs.
if(NOT EXISTS ${WEB}/node_modules)
  message("the viewer was not built")
  return()
endif()
file(READ ${CASE} text)
string(REPLACE "speed = \"5 m/s\"" "speed = \"7 m/s\"" other "${text}")
string(REPLACE "end = \"12 ms\"" "end = \"8 ms\"" other "${other}")
if(other STREQUAL text)
  message(FATAL_ERROR "the speed and the end of ${CASE} are written otherwise")
endif()
file(WRITE ${FOLDER}/first.toml "${text}")
file(WRITE ${FOLDER}/second.toml "${other}")
foreach(name first second)
  execute_process(COMMAND ${KERF} run ${FOLDER}/${name}.toml --out ${FOLDER}/${name} --force --quiet
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${NODE} ${WEB}/test/compare_page.mjs ${KERF} ${FOLDER}/first ${FOLDER}/second
  COMMAND_ERROR_IS_FATAL ANY)
