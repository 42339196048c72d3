# The headers of the library may be included by several sources of one program.
#   cmake -D NM=<nm> -D LIBRARY=<library of objects that include one each> -P check_definitions.cmake
# Fails if the objects define what a program may have once only: a function or a variable that is not inline.
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND ${NM} --extern-only --defined-only --demangle ${LIBRARY}
  OUTPUT_VARIABLE symbols RESULT_VARIABLE status ERROR_QUIET)
if(NOT status EQUAL 0 OR NOT symbols MATCHES "\\.o:\n")
  message(FATAL_ERROR "${NM} doesn't read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[0-9a-f]+ [ABCDGRST] [^\n]*" definitions "${symbols}")
if(definitions)
  list(JOIN definitions "\n  " definitions)
  message(FATAL_ERROR "Not inline:\n  ${definitions}")
endif()
