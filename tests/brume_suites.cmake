# Tests of a GoogleTest program: one for each suite, or so many of about as many suites each. Starting
# the program takes longer than most cases and suites, and cases of a suite can share what they
# compare with. Output of a test that fails names the cases. As gtest_discover_tests() the program
# lists its suites after each build.
#
#   brume_suites(test_NAME [BUNDLES n])    tests NAME.1 to NAME.n, or NAME of all
function(brume_suites target)
  cmake_parse_arguments(arg "" "BUNDLES" "" ${ARGN})
  set(suites "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS "${suites}" VERBATIM
    COMMAND "${CMAKE_COMMAND}" -D "program=$<TARGET_FILE:${target}>" -D "file=${suites}"
      -D "bundles=${arg_BUNDLES}" -D "environment=${BRUME_TEST_MEMORY}"
      -P "${PROJECT_SOURCE_DIR}/tests/list_suites.cmake")
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
  file(WRITE "${include}"
    "if(EXISTS \"${suites}\")\n  include(\"${suites}\")\nelse()\n  add_test(${target}_NOT_BUILT none)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()
