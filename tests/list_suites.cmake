# Writes `count` tests of ctest, of a GoogleTest program's suites, to a file:
#   cmake -D program=... -D file=... -D name=... -D count=... -D environment=... -P this
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${output}")
# Suites of one file follow each other and cost alike: they are dealt out.
set(next 0)
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n|\\.$" "" suite "${suite}")
  math(EXPR number "${next} % ${count} + 1")
  math(EXPR next "${next} + 1")
  list(APPEND labels_${number} "${suite}")
  string(APPEND filter_${number} "${suite}.*:")
endforeach()
set(tests "")
foreach(number RANGE 1 ${count})
  string(APPEND tests
    "add_test(${name}.${number} [==[${program}]==] --gtest_brief=1 \"--gtest_filter=${filter_${number}}\")\n"
    "set_tests_properties(${name}.${number} PROPERTIES ENVIRONMENT [==[${environment}]==] LABELS [==[${labels_${number}}]==])\n")
endforeach()
file(WRITE "${file}" "${tests}")
