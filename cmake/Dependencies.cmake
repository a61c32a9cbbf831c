# SPDX-License-Identifier: GPL-3.0-or-later
# Every outside library that the rooms use, and how it is found. All of them are Debian 12 packages
# (scripts/packages.txt). The installed package reads this file too, to find what the static libraries link.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(Threads REQUIRED)
find_package(Eigen3 CONFIG REQUIRED)  # CONFIG: CGAL ships a find module of that name which defines no target
find_package(CGAL REQUIRED)
find_package(OpenMesh CONFIG REQUIRED)
find_package(OpenSubdiv MODULE REQUIRED)  # MODULE: FindOpenSubdiv.cmake says why
find_package(GDAL REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)

add_library(stratareeb_cairo INTERFACE IMPORTED)
target_link_libraries(stratareeb_cairo INTERFACE PkgConfig::CAIRO)

# lib3MF and OpenCASCADE are linked by name: their CMake packages name parts that Debian leaves out.
find_path(LIB3MF_INCLUDE_DIR NAMES Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf REQUIRED)
find_library(LIB3MF_LIBRARY NAMES 3MF REQUIRED)
add_library(stratareeb_3mf INTERFACE IMPORTED)
target_include_directories(stratareeb_3mf SYSTEM INTERFACE ${LIB3MF_INCLUDE_DIR})
target_link_libraries(stratareeb_3mf INTERFACE ${LIB3MF_LIBRARY})

find_path(OCCT_INCLUDE_DIR NAMES Standard_Version.hxx PATH_SUFFIXES opencascade REQUIRED)
add_library(stratareeb_occt INTERFACE IMPORTED)
target_include_directories(stratareeb_occt SYSTEM INTERFACE ${OCCT_INCLUDE_DIR})
target_link_libraries(stratareeb_occt INTERFACE TKXDESTEP TKSTEP TKSTEPAttr TKSTEPBase TKXSBase TKXCAF TKCAF TKLCAF
                      TKCDF TKShHealing TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
