# What users compile, with the compiler and the options of the rest. Included, not a folder of its own to CMake: what the compiler
# takes longest for is then what Ninja begins with.

# All headers, in one source
shape_characteristics_public_headers(public)
list(TRANSFORM public REPLACE "(.+)" "#include <\\1>")
list(JOIN public "\n" includes)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/usage/all_headers.cpp CONTENT "${includes}\n")
add_library(all_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/usage/all_headers.cpp)
target_link_libraries(all_headers PRIVATE
  Shape_characteristics_development $<TARGET_NAME_IF_EXISTS:Shape_characteristics::OpenGL_support>)

# The program in README.md
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/README.md)
file(READ ${PROJECT_SOURCE_DIR}/README.md readme)
if(NOT readme MATCHES "\n```cpp\n([^`]*)\n```")
  message(FATAL_ERROR "README.md has no program: a block that begins with ```cpp")
endif()
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/usage/readme_program.cpp CONTENT "${CMAKE_MATCH_1}\n")
shape_characteristics_add_program(readme_program ${CMAKE_CURRENT_BINARY_DIR}/usage/readme_program.cpp)
add_test(NAME usage/readme_program COMMAND readme_program ${SHAPE_CHARACTERISTICS_DATA_DIR}/meshes/elephant.off)

# The installed library serves a project of its own
set(parallel OFF)
if(TARGET Shape_characteristics::TBB_support)
  list(APPEND parallel ON)
endif()
foreach(value IN LISTS parallel)
  add_test(NAME usage/consumer_parallel_${value} COMMAND ${CMAKE_COMMAND}
    -D BUILD_DIR=${PROJECT_BINARY_DIR}
    -D CONSUMER=${CMAKE_CURRENT_LIST_DIR}/consumer
    -D SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/usage/consumer_parallel_${value}
    -D PARALLEL=${value}
    -D COMPILER=${CMAKE_CXX_COMPILER}
    -D FLAGS=${CMAKE_CXX_FLAGS_RELEASE}
    -P ${CMAKE_CURRENT_LIST_DIR}/install_and_consume.cmake)
  set_tests_properties(usage/consumer_parallel_${value} PROPERTIES TIMEOUT 600)
  add_test(NAME usage/contained_parallel_${value} COMMAND ${CMAKE_COMMAND}
    -D SOURCES=${PROJECT_SOURCE_DIR}
    -D CONSUMER=${CMAKE_CURRENT_LIST_DIR}/consumer
    -D SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/usage/contained_parallel_${value}
    -D PARALLEL=${value}
    -D COMPILER=${CMAKE_CXX_COMPILER}
    -P ${CMAKE_CURRENT_LIST_DIR}/contain_sources.cmake)
endforeach()
