# SPDX-License-Identifier: Apache-2.0
# KerfWeb.cmake runs this script at build time. It writes script.js and style.css (of reports), study_script.js,
# study_style.css, edit_script.js and edit_style.css into FOLDER, built by NPM from a copy of SOURCE, or empty files where that is not possible.
function(leave_empty why)
  message("Reports are built without their viewer: ${why}. They will have static pictures.")
  foreach(name script.js style.css study_script.js study_style.css edit_script.js edit_style.css)
    file(WRITE ${FOLDER}/${name} "")
  endforeach()
endfunction()

if(NOT NPM OR NPM MATCHES "NOTFOUND")
  leave_empty("npm is not installed (Debian: nodejs, npm)")
  return()
endif()
set(work ${FOLDER}/build)
file(COPY ${SOURCE}/ DESTINATION ${work} PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE)
# "npm ci" fails here: with Rollup it requires packages of other systems from the lock file.
foreach(step "install;--no-audit;--no-fund" "run;build")
  execute_process(COMMAND ${NPM} ${step} WORKING_DIRECTORY ${work} RESULT_VARIABLE status
    OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    string(REPLACE ";" " " step "${step}")
    message("${said}")
    leave_empty("\"npm ${step}\" failed")
    return()
  endif()
endforeach()
file(COPY_FILE ${work}/dist/viewer.js ${FOLDER}/script.js)
file(COPY_FILE ${work}/dist/viewer.css ${FOLDER}/style.css)
file(COPY_FILE ${work}/dist/study.js ${FOLDER}/study_script.js)
file(COPY_FILE ${work}/dist/study.css ${FOLDER}/study_style.css)
file(COPY_FILE ${work}/dist/edit.js ${FOLDER}/edit_script.js)
file(COPY_FILE ${work}/dist/edit.css ${FOLDER}/edit_style.css)
