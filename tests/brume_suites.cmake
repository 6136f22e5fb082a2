# The suites of a GoogleTest program as so many tests of ctest, NAME.1, NAME.2 and so on: starting
# the program takes a tenth of a second, longer than most suites, and cases of a suite can share
# what they compare with. Each suite is a label of its test, and output of one that fails names the
# cases. As gtest_discover_tests() the program lists them after each build.
function(brume_suites target name count)
  set(suites "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS "${suites}" VERBATIM
    COMMAND "${CMAKE_COMMAND}" -D "program=$<TARGET_FILE:${target}>" -D "file=${suites}"
      -D "name=${name}" -D "count=${count}" -D "environment=${BRUME_TEST_MEMORY}"
      -P "${PROJECT_SOURCE_DIR}/tests/list_suites.cmake")
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
  file(WRITE "${include}"
    "if(EXISTS \"${suites}\")\n  include(\"${suites}\")\nelse()\n  add_test(${target}_NOT_BUILT none)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()
