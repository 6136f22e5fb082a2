# Writes ctest's tests of a GoogleTest program to a file:
#   cmake -D program=... -D file=... -D environment=... -P this
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${output}")
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n|\\.$" "" suite "${suite}")
  string(APPEND tests
    "add_test([==[${suite}]==] [==[${program}]==] --gtest_brief=1 \"--gtest_filter=${suite}.*\")\n"
    "set_tests_properties([==[${suite}]==] PROPERTIES ENVIRONMENT [==[${environment}]==])\n")
endforeach()
file(WRITE "${file}" "${tests}")
