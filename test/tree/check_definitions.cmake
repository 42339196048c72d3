# Fails if an object file of a header defines what the linker would find twice in a program of two source files: a function or a
# variable that isn't inline.
#   cmake -D NM=<nm> -D OBJECTS=<file with the names of the object files> -P check_definitions.cmake
cmake_minimum_required(VERSION 3.22)

file(STRINGS ${OBJECTS} objects)
list(FILTER objects EXCLUDE REGEX "\\.[gp]ch$") # CMake counts precompiled headers among them
list(LENGTH objects count)
if(count EQUAL 0)
  message(FATAL_ERROR "no object files")
endif()
execute_process(COMMAND ${NM} --demangle --defined-only --extern-only --print-file-name ${objects}
  OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
list(FILTER symbols INCLUDE REGEX ": *[0-9a-fA-F]* [A-TX-Z] ") # weak ones are V, W, or u
if(symbols)
  list(JOIN symbols "\n" symbols)
  message(FATAL_ERROR "not inline:\n${symbols}")
endif()
message(STATUS "${count} object files define nothing that isn't inline")
