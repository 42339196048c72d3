# Every source is as clang-format 14 with the .clang-format of the tree writes it.
#   cmake -D SOURCE_DIR=<tree> -P check_format.cmake
cmake_minimum_required(VERSION 3.22)

find_program(clang_format NAMES clang-format-14 clang-format)
if(NOT clang_format)
  message("skipped: there is no clang-format")
  return()
endif()
execute_process(COMMAND ${clang_format} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT version MATCHES "version 14\\.")
  message("skipped: other versions than 14 write other formats, and this one is ${version}")
  return()
endif()

set(sources "")
foreach(folder IN ITEMS benchmark cmake doc examples include test)
  file(GLOB_RECURSE found RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cpp)
  list(APPEND sources ${found})
endforeach()
execute_process(COMMAND ${clang_format} --dry-run --Werror ${sources}
  WORKING_DIRECTORY ${SOURCE_DIR} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE complaints)
if(result)
  string(REGEX MATCHALL "[^\n ]+:[0-9]+:[0-9]+: error" wrong "${complaints}")
  list(TRANSFORM wrong REPLACE ":[0-9]+:[0-9]+: error$" "")
  list(REMOVE_DUPLICATES wrong)
  list(JOIN wrong " " wrong)
  message(FATAL_ERROR "Wanted:\n  clang-format -i ${wrong}\n")
endif()
