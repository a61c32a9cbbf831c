# SPDX-License-Identifier: GPL-3.0-or-later
# A room is a folder of sources at the top of the tree and one static library, stratareeb::<room>.

add_library(stratareeb_options INTERFACE)
# Options are given as {.levels = 2}: what is left out has its default on purpose. -Wrestrict is wrong about "a" + string
# in g++ 12 (its bug 105651).
target_compile_options(stratareeb_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                       -Wno-missing-field-initializers $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(STRATAREEB_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()

# For each executable.
function(stratareeb_executable name)
    if(STRATAREEB_SANITIZE)
        target_sources(${name} PRIVATE "${PROJECT_SOURCE_DIR}/cmake/library_leaks.cpp")
    endif()
endfunction()

function(stratareeb_room name)
    file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${name}/*.cpp")
    file(GLOB headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${name}/*.h")
    add_library(stratareeb_${name} STATIC ${sources} ${headers})
    add_library(stratareeb::${name} ALIAS stratareeb_${name})
    set_target_properties(stratareeb_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    target_compile_features(stratareeb_${name} PUBLIC cxx_std_20)
    target_include_directories(stratareeb_${name} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
                               "$<INSTALL_INTERFACE:include/stratareeb>")
    cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
    target_link_libraries(stratareeb_${name} PUBLIC ${ARG_PUBLIC}
                          PRIVATE ${ARG_PRIVATE} "$<BUILD_INTERFACE:stratareeb_options>")
    set_property(GLOBAL APPEND PROPERTY STRATAREEB_ROOMS ${name})
endfunction()

# The program is main.cpp and a library of its commands, so that tests can call them too.
function(stratareeb_program)
    find_package(CLI11 REQUIRED)
    file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/apps/*.cpp")
    list(REMOVE_ITEM sources "${PROJECT_SOURCE_DIR}/apps/main.cpp")
    add_library(stratareeb_apps STATIC ${sources})
    target_link_libraries(stratareeb_apps PUBLIC stratareeb_io CLI11::CLI11 nlohmann_json::nlohmann_json fmt::fmt
                          PRIVATE stratareeb_options)
    add_executable(stratareeb "${PROJECT_SOURCE_DIR}/apps/main.cpp")
    stratareeb_executable(stratareeb)
    target_link_libraries(stratareeb PRIVATE stratareeb_apps stratareeb_options)
    target_compile_definitions(stratareeb PRIVATE STRATAREEB_VERSION="${PROJECT_VERSION}")
    set_target_properties(stratareeb PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")
endfunction()
