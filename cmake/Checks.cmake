# SPDX-License-Identifier: GPL-3.0-or-later
# Tests of the tree itself rather than of the code's results: lints, stand-alone headers, the installed package.

# Every header compiles alone. One with a source of its name is that source's first include (lint.py sees to it); for each of the
# others there is a generated source.
file(GLOB headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/*/*.h")
set(header_sources)
foreach(header ${headers})
    string(REGEX REPLACE "\\.h$" ".cpp" own_source "${header}")
    if(EXISTS "${PROJECT_SOURCE_DIR}/${own_source}")
        continue()
    endif()
    string(REPLACE "/" "_" name "${header}")
    set(source "${PROJECT_BINARY_DIR}/headers/${name}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${header}\"\n#include \"${header}\"  // twice: guarded\n")
    list(APPEND header_sources "${source}")
endforeach()
add_library(stratareeb_headers OBJECT ${header_sources})
target_link_libraries(stratareeb_headers PRIVATE stratareeb_apps Eigen3::Eigen stratareeb_options)
target_compile_definitions(stratareeb_headers PRIVATE STRATAREEB_SOURCE_DIR="" STRATAREEB_PROGRAM="")

find_package(Python3 COMPONENTS Interpreter REQUIRED)
foreach(lint includes text format tidy)
    add_test(NAME lint.${lint} COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/lint.py" ${lint}
             --build "${PROJECT_BINARY_DIR}" WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set_tests_properties(lint.${lint} PROPERTIES LABELS lint)
endforeach()
set_tests_properties(lint.tidy PROPERTIES TIMEOUT 1800 COST 1000)  # the longest: ctest starts it first

# An outside project finds the installed package, builds and runs.
set(flags "$<$<BOOL:${STRATAREEB_SANITIZE}>:-fsanitize=address,undefined>")
add_test(NAME package COMMAND "${CMAKE_COMMAND}"
         -D "build=${PROJECT_BINARY_DIR}" -D "source=${PROJECT_SOURCE_DIR}/tests/package" -D "flags=${flags}"
         -D "generator=${CMAKE_GENERATOR}" -D "compiler=${CMAKE_CXX_COMPILER}"
         -P "${PROJECT_SOURCE_DIR}/tests/package/run.cmake")

# Every command that README.md and docs/ show runs.
add_test(NAME docs_commands COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/docs_commands_test.py"
         "$<TARGET_FILE:stratareeb>")
set_tests_properties(docs_commands PROPERTIES TIMEOUT 1200)
