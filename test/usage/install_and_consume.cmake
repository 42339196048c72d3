# Installs the library, then configures, builds and runs test/usage/consumer against what was installed.
#   cmake -D BUILD_DIR=<build folder of the library> -D CONSUMER=<test/usage/consumer> -D SCRATCH=<folder>
#         -D PARALLEL=<ON|OFF> -D COMPILER=<C++ compiler> -D FLAGS=<its flags in Release> -P install_and_consume.cmake
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${SCRATCH}/installed)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build
  -D CMAKE_PREFIX_PATH=${SCRATCH}/installed -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_CXX_FLAGS_RELEASE=${FLAGS} -D PARALLEL=${PARALLEL})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)

execute_process(COMMAND ${SCRATCH}/build/consumer
  OUTPUT_VARIABLE output ECHO_OUTPUT_VARIABLE COMMAND_ERROR_IS_FATAL ANY)
if(PARALLEL)
  set(expected "^parallel: ")
else()
  set(expected "^sequential: ")
endif()
if(NOT output MATCHES ${expected})
  message(FATAL_ERROR "'${expected}' is expected")
endif()
