# One test for each suite of a GoogleTest program, not for each case: starting the program takes
# longer than most cases, and cases of a suite can share what they compare with. Output of a suite
# that fails names the cases. As gtest_discover_tests() the program lists them after each build.
function(brume_suites target)
  set(suites "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS "${suites}" VERBATIM
    COMMAND "${CMAKE_COMMAND}" -D "program=$<TARGET_FILE:${target}>" -D "file=${suites}"
      -D "environment=${BRUME_TEST_MEMORY}" -P "${PROJECT_SOURCE_DIR}/tests/list_suites.cmake")
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
  file(WRITE "${include}"
    "if(EXISTS \"${suites}\")\n  include(\"${suites}\")\nelse()\n  add_test(${target}_NOT_BUILT none)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()
