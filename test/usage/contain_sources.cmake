# Configures test/usage/consumer with the sources of the library as a part of it: its targets have to be known there.
#   cmake -D SOURCES=<sources of the library> -D CONSUMER=<test/usage/consumer> -D SCRATCH=<folder> -D PARALLEL=<ON|OFF>
#         -D COMPILER=<C++ compiler> -P contain_sources.cmake
cmake_minimum_required(VERSION 3.22)

file(REMOVE_RECURSE ${SCRATCH})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH} -D SOURCES=${SOURCES} -D PARALLEL=${PARALLEL}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
  COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
