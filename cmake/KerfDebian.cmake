# SPDX-License-Identifier: Apache-2.0
# CPack runs this before it packs: a Debian package has a compressed manual page and changelog, and a
# `copyright` that refers to the licences of the system.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
set(doc ${share}/doc/kerf)
file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH where that is set
file(WRITE ${doc}/changelog.Debian "kerf (${CPACK_PACKAGE_VERSION}-1) unstable; urgency=medium

  * The changes are in changelog.gz.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${day}
")
find_program(GZIP gzip REQUIRED)
execute_process(COMMAND ${GZIP} -9n ${doc}/changelog ${doc}/changelog.Debian ${share}/man/man1/kerf.1
  COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${doc}/LICENSE)
file(WRITE ${doc}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
Copyright: 2026 The Kerf project
License: Apache-2.0
 On Debian systems the licence is in /usr/share/common-licenses/Apache-2.0.
")
