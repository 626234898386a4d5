# SPDX-License-Identifier: Apache-2.0
# Edits and runs a case in FOLDER by the page of kerf view --edit, with web/test/edit_page.mjs.
if(NOT EXISTS ${WEB}/node_modules)
  message("the viewer was not built")
  return()
endif()
execute_process(COMMAND ${NODE} ${WEB}/test/edit_page.mjs ${KERF} ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
