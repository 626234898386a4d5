# SPDX-License-Identifier: Apache-2.0
# CPack runs this before it packs: a Debian package has a compressed manual page and changelog, and a
# `copyright` that refers to the licences of the system.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH where that is set
find_program(GZIP gzip REQUIRED)
file(GLOB components ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*)
foreach(component IN LISTS components)
  set(share ${component}/usr/share)
  get_filename_component(name ${component} NAME)
  string(TOUPPER ${name} name)
  set(package ${CPACK_DEBIAN_${name}_PACKAGE_NAME})
  set(doc ${share}/doc/${package})
  if(EXISTS ${share}/zsh/site-functions)  # the zsh of Debian does not look there
    file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
  endif()
  if(EXISTS ${doc}/CHANGELOG.md)
    file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
    execute_process(COMMAND ${GZIP} -9n ${doc}/changelog ${share}/man/man1/kerf.1 COMMAND_ERROR_IS_FATAL ANY)
  endif()
  file(WRITE ${doc}/changelog.Debian "kerf (${CPACK_PACKAGE_VERSION}-1) unstable; urgency=medium

  * The changes are in changelog.gz of the package kerf.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${day}
")
  execute_process(COMMAND ${GZIP} -9n ${doc}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  # The package is not uploaded to Debian, where its first version would close a bug. CPack calls ldconfig from
  # scripts of its own, and the library is installed where other systems have it, too.
  set(overrides initial-upload-closes-no-bugs)
  if(name STREQUAL LIBRARY)
    list(APPEND overrides lacks-ldconfig-trigger maintscript-calls-ldconfig)
  elseif(name STREQUAL DEVELOPMENT)
    list(APPEND overrides pkg-config-unavailable-for-cross-compilation)
  endif()
  list(TRANSFORM overrides PREPEND "${package}: ")
  list(JOIN overrides "\n" overrides)
  file(WRITE ${share}/lintian/overrides/${package} "${overrides}\n")
  file(REMOVE ${doc}/LICENSE)
  file(WRITE ${doc}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
Copyright: 2026 The Kerf project
License: Apache-2.0
 On Debian systems the licence is in /usr/share/common-licenses/Apache-2.0.
")
endforeach()
