# SPDX-License-Identifier: Apache-2.0
# Run by KerfWeb.cmake at build time: leaves script.js and style.css (of reports), study_script.js and
# study_style.css in FOLDER, built by NPM from a copy of SOURCE, or empty ones where that is not possible.
function(leave_empty why)
  message("Reports are built without their viewer: ${why}. They will have static pictures.")
  foreach(name script.js style.css study_script.js study_style.css)
    file(WRITE ${FOLDER}/${name} "")
  endforeach()
endfunction()

if(NOT NPM OR NPM MATCHES "NOTFOUND")
  leave_empty("npm is not installed (Debian: nodejs, npm)")
  return()
endif()
set(work ${FOLDER}/build)
file(COPY ${SOURCE}/ DESTINATION ${work} PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE)
# Not "npm ci": with Rollup it asks the lock file for packages of other systems.
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
