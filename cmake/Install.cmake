# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install build`: the program, one static library a room, their headers, and what find_package(stratareeb) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/stratareeb")
get_property(rooms GLOBAL PROPERTY STRATAREEB_ROOMS)

install(TARGETS stratareeb RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
foreach(room ${rooms})
    install(TARGETS stratareeb_${room} EXPORT stratareeb_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/${room}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/stratareeb"
            FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT stratareeb_targets NAMESPACE stratareeb:: FILE stratareebTargets.cmake DESTINATION "${package_dir}")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/stratareebConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/stratareebConfig.cmake" INSTALL_DESTINATION "${package_dir}"
                              NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/stratareebConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/stratareebConfig.cmake" "${PROJECT_BINARY_DIR}/stratareebConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/Dependencies.cmake" "${PROJECT_SOURCE_DIR}/cmake/FindOpenSubdiv.cmake"
        DESTINATION "${package_dir}")
