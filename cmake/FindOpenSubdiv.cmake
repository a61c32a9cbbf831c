# SPDX-License-Identifier: GPL-3.0-or-later
# OpenSubdiv's CPU library as the target OpenSubdiv::osdCPU. Its own CMake package names static libraries and a GPU one that Debian's
# libosd-dev leaves out, and fails without them.
find_path(OpenSubdiv_INCLUDE_DIR NAMES opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdiv_LIBRARY NAMES osdCPU)
mark_as_advanced(OpenSubdiv_INCLUDE_DIR OpenSubdiv_LIBRARY)

if(OpenSubdiv_INCLUDE_DIR AND EXISTS "${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h")
    file(STRINGS "${OpenSubdiv_INCLUDE_DIR}/opensubdiv/version.h" version_line REGEX "define OPENSUBDIV_VERSION v[0-9_]+")
    string(REGEX REPLACE ".*v([0-9]+)_([0-9]+)_([0-9]+).*" "\\1.\\2.\\3" OpenSubdiv_VERSION "${version_line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdiv REQUIRED_VARS OpenSubdiv_LIBRARY OpenSubdiv_INCLUDE_DIR
                                  VERSION_VAR OpenSubdiv_VERSION)

if(OpenSubdiv_FOUND AND NOT TARGET OpenSubdiv::osdCPU)
    add_library(OpenSubdiv::osdCPU UNKNOWN IMPORTED)
    set_target_properties(OpenSubdiv::osdCPU PROPERTIES IMPORTED_LOCATION "${OpenSubdiv_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${OpenSubdiv_INCLUDE_DIR}")
endif()
