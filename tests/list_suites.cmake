# Writes ctest's tests of a GoogleTest program to a file:
#   cmake -D program=... -D file=... [-D bundles=n] [-D environment=...] -P this
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${output}")
set(tests "")

function(add_suites name filter)
  string(APPEND tests
    "add_test([==[${name}]==] [==[${program}]==] --gtest_brief=1 \"--gtest_filter=${filter}\")\n"
    "set_tests_properties([==[${name}]==] PROPERTIES ENVIRONMENT [==[${environment}]==])\n")
  set(tests "${tests}" PARENT_SCOPE)
endfunction()

list(LENGTH suites count)
set(place 0)
set(bundle 0)
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n|\\.$" "" suite "${suite}")
  if(NOT bundles)
    add_suites("${suite}" "${suite}.*")
    continue()
  endif()
  string(APPEND filter "${suite}.*:")
  math(EXPR place "${place} + 1")
  math(EXPR next "${place} * ${bundles} / ${count}")
  if(next GREATER bundle)
    set(bundle ${next})
    string(REGEX REPLACE ".*/test_" "" name "${program}")
    if(bundles GREATER 1)
      string(APPEND name ".${bundle}")
    endif()
    add_suites("${name}" "${filter}")
    set(filter "")
  endif()
endforeach()
file(WRITE "${file}" "${tests}")
