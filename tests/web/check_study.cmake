# SPDX-License-Identifier: Apache-2.0
# Makes the runs of STUDY in FOLDER and tests its page with web/test/study_page.mjs.
if(NOT EXISTS ${WEB}/node_modules)
  message("the viewer was not built")
  return()
endif()
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${KERF} study ${STUDY} --out ${FOLDER} --jobs 2 --quiet
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} ${WEB}/test/study_page.mjs ${FOLDER}/study.html
  COMMAND_ERROR_IS_FATAL ANY)
