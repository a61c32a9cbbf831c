# SPDX-License-Identifier: GPL-3.0-or-later
# Tests of the 3D page in viewer/: its modules under Node.js, that the page in viewer/dist is what its sources make, and the page in
# headless Chromium. Where Node.js, npm, its registry or Chromium is missing they are skipped and say so.
set(viewer_tests "${PROJECT_SOURCE_DIR}/viewer/tests/ctest.sh")
set(viewer_copy "${PROJECT_BINARY_DIR}/viewer")
foreach(name unit packages build browser)
    add_test(NAME viewer.${name} COMMAND bash "${viewer_tests}" ${name} "${viewer_copy}" "$<TARGET_FILE:stratareeb>")
    set_tests_properties(viewer.${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
set_tests_properties(viewer.packages PROPERTIES FIXTURES_SETUP viewer_packages)
set_tests_properties(viewer.build viewer.browser PROPERTIES FIXTURES_REQUIRED viewer_packages RESOURCE_LOCK viewer_copy)
# It draws without a graphics card, on all cores.
set_tests_properties(viewer.browser PROPERTIES COST 500 PROCESSORS 2)
