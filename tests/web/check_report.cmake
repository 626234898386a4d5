# SPDX-License-Identifier: Apache-2.0
# Runs CASE into FOLDER and tests its report with web/test/page.mjs.
if(NOT EXISTS ${WEB}/node_modules)
  message("the viewer was not built")
  return()
endif()
execute_process(COMMAND ${KERF} run ${CASE} --out ${FOLDER} --force --quiet
  COMMAND_ERROR_IS_FATAL ANY)
file(SIZE ${FOLDER}/report.html size)
if(size GREATER 15000000)
  message(FATAL_ERROR "report.html has ${size} bytes")
endif()
execute_process(COMMAND ${NODE} ${WEB}/test/page.mjs ${FOLDER}/report.html --result ${FOLDER}/result.json
  COMMAND_ERROR_IS_FATAL ANY)
