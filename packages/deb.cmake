# SPDX-License-Identifier: MIT
#
# One Debian package with the installed files: `cpack -G DEB`, or `./dev package`.

set(CPACK_PACKAGE_NAME libdetent-dev)
set(CPACK_PACKAGE_VENDOR detent)
set(CPACK_PACKAGE_CONTACT "the authors of detent <detent@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES OFF)  # stripping would remove the symbols of static libraries
set(CPACK_DEB_COMPONENT_INSTALL OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
find_program(DETENT_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(DETENT_SHLIBDEPS)
if(DETENT_SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
else()
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libc6, libstdc++6")
endif()
include(CPack)
