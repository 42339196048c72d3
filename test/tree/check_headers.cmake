# The headers of the library keep the rules of headers.cmake.
#   cmake -D HEADERS=<tree>/include/Shape_characteristics -D NAMED_PARAMETERS=<tree>/doc/named_parameters.dox
#         -D ALIASES=<tree>/doc/Doxyfile.in -P check_headers.cmake
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)

find_wrong_includes(includes ${HEADERS})
find_wrong_guards(guards ${HEADERS})
find_output(output ${HEADERS})
find_missing_libraries(libraries ${HEADERS})
find_unlisted_parameters(parameters ${HEADERS} ${NAMED_PARAMETERS} ${ALIASES})
set(wrong ${includes} ${guards} ${output} ${libraries} ${parameters})
if(wrong)
  list(JOIN wrong "\n" wrong)
  message(FATAL_ERROR "${wrong}")
endif()
