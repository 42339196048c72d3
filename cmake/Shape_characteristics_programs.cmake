# What the tests, examples and benchmarks have in common.
#
# Shape_characteristics_development    the library, our warnings and sanitizers, TBB where it is found
# Shape_characteristics_OpenMesh       OpenMesh, where it is found
# Shape_characteristics_precompiled    precompiled/: headers that most programs include, and templates that most instantiate
# shape_characteristics_includes()       whether a source file includes a header
# shape_characteristics_add_program()    one program from one source file
# shape_characteristics_use_precompiled()  a program or library that is compiled and linked with what is precompiled
# shape_characteristics_do_not_sanitize()  a source file of other libraries' code
# shape_characteristics_public_headers()   the headers that a user includes
# shape_characteristics_include_each()     source files that include a header each

option(SHAPE_CHARACTERISTICS_WARNINGS_AS_ERRORS "Fail on warnings of the compiler" OFF)
option(SHAPE_CHARACTERISTICS_AVX2 "Compile for AVX2 and FMA, if this machine has them" OFF)
set(SHAPE_CHARACTERISTICS_SANITIZERS "" CACHE STRING "What to sanitize: address,undefined or thread")

add_library(Shape_characteristics_development INTERFACE)
target_link_libraries(Shape_characteristics_development INTERFACE
  Shape_characteristics::Shape_characteristics
  $<TARGET_NAME_IF_EXISTS:Shape_characteristics::TBB_support>)
target_compile_options(Shape_characteristics_development INTERFACE
  -Wall -Wextra $<$<BOOL:${SHAPE_CHARACTERISTICS_WARNINGS_AS_ERRORS}>:-Werror>
  # GCC looks for garbage in what is precompiled again and again, a tenth of its time
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1500000>)
target_compile_definitions(Shape_characteristics_development INTERFACE
  SHAPE_CHARACTERISTICS_DATA_DIR="${SHAPE_CHARACTERISTICS_DATA_DIR}"
  CGAL_DATA_DIR="${SHAPE_CHARACTERISTICS_DATA_DIR}") # where CGAL::data_file_path() looks
if(SHAPE_CHARACTERISTICS_AVX2)
  # Not -march=native: GCC 12 warns of its own headers for AVX-512.
  include(CheckCXXSourceRuns)
  check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
    SHAPE_CHARACTERISTICS_HAS_AVX2)
  if(SHAPE_CHARACTERISTICS_HAS_AVX2)
    # Without expensive ones, GCC's optimizations at -O1 leave registers in a state that makes the C library slow.
    target_compile_options(Shape_characteristics_development INTERFACE
      -mavx2 -mfma $<$<CXX_COMPILER_ID:GNU>:-fexpensive-optimizations>)
  endif()
endif()
if(SHAPE_CHARACTERISTICS_SANITIZERS)
  # Without the checks of every pointer and reference: they make the compiler three times slower, and what they would
  # find makes the program end in the address sanitizer (null, out of an object; an offset alone does no harm) or in Eigen's
  # vector instructions (misaligned).
  target_compile_options(Shape_characteristics_development INTERFACE
    -fsanitize=${SHAPE_CHARACTERISTICS_SANITIZERS}
    -fno-sanitize=alignment,null,object-size,pointer-overflow,vptr$<$<CXX_COMPILER_ID:Clang>:,function>
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(Shape_characteristics_development INTERFACE
    -fsanitize=${SHAPE_CHARACTERISTICS_SANITIZERS})
endif()

function(shape_characteristics_do_not_sanitize source)
  if(SHAPE_CHARACTERISTICS_SANITIZERS)
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -fno-sanitize=all SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# Sets `result` to the headers that a user includes, as he writes them. Without libepoxy those that need it are left out.
function(shape_characteristics_public_headers result)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/*.h)
  list(FILTER found EXCLUDE REGEX "/internal/")
  if(NOT TARGET Shape_characteristics::OpenGL_support)
    list(FILTER found EXCLUDE REGEX "/OpenGL/")
  endif()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# Sets `result` to source files below `folder`, one for each of the headers that follow: it includes that header after `preamble`.
function(shape_characteristics_include_each result folder preamble)
  set(sources "")
  foreach(header IN LISTS ARGN)
    string(REGEX REPLACE "\\.h$" ".cpp" source ${folder}/${header})
    file(CONFIGURE OUTPUT ${source} CONTENT "${preamble}#include <${header}>\n")
    list(APPEND sources ${source})
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

if(SHAPE_CHARACTERISTICS_SANITIZERS STREQUAL "thread")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON) # for a few programs they take longer than they save
endif()
if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
  # then programs know nothing of the lists of templates
  add_library(Shape_characteristics_precompiled INTERFACE)
  target_link_libraries(Shape_characteristics_precompiled INTERFACE Shape_characteristics_development)
else()
  file(GLOB lists CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR}/precompiled ${CMAKE_CURRENT_LIST_DIR}/precompiled/templates/*.h)
  # of other libraries' code, which isn't sanitized: in one source, for the second has most of the first, and without the rest of what
  # is precompiled
  set(lists_of_others templates/decompositions.h templates/other_libraries.h)
  list(REMOVE_ITEM lists ${lists_of_others})
  set(definition "#define SHAPE_CHARACTERISTICS_TEMPLATE template\n")
  shape_characteristics_include_each(sources ${CMAKE_CURRENT_BINARY_DIR}/precompiled
    "#include <precompiled.h>\n${definition}" ${lists})
  list(TRANSFORM lists_of_others REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE includes)
  list(JOIN includes "" includes)
  set(source_of_others ${CMAKE_CURRENT_BINARY_DIR}/precompiled/of_other_libraries.cpp)
  file(CONFIGURE OUTPUT ${source_of_others} CONTENT "${definition}${includes}")
  add_library(Shape_characteristics_precompiled STATIC EXCLUDE_FROM_ALL ${sources} ${source_of_others})
  target_include_directories(Shape_characteristics_precompiled PUBLIC ${CMAKE_CURRENT_LIST_DIR}/precompiled)
  target_precompile_headers(Shape_characteristics_precompiled PRIVATE ${CMAKE_CURRENT_LIST_DIR}/precompiled/precompiled.h)
  target_link_libraries(Shape_characteristics_precompiled PUBLIC Shape_characteristics_development)
  shape_characteristics_do_not_sanitize(${source_of_others})
endif()

# OpenMesh's own CMake files name include directories that Debian doesn't have
find_path(OPENMESH_INCLUDE_DIR OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh)
find_library(OPENMESH_CORE_LIBRARY OpenMeshCore)
mark_as_advanced(OPENMESH_INCLUDE_DIR OPENMESH_CORE_LIBRARY)
add_library(Shape_characteristics_OpenMesh INTERFACE)
if(OPENMESH_INCLUDE_DIR AND OPENMESH_CORE_LIBRARY)
  target_include_directories(Shape_characteristics_OpenMesh SYSTEM INTERFACE ${OPENMESH_INCLUDE_DIR})
  target_link_libraries(Shape_characteristics_OpenMesh INTERFACE ${OPENMESH_CORE_LIBRARY})
  target_compile_definitions(Shape_characteristics_OpenMesh INTERFACE CGAL_USE_OPENMESH) # as CGAL's own tests say it
  # OpenMesh's vectors start without values
  target_compile_options(Shape_characteristics_OpenMesh INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# Sets `result` to whether the file `source` includes a header whose name matches the regular expression `header`.
function(shape_characteristics_includes result source header)
  file(STRINGS ${source} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]${header}[>\"]")
  if(lines)
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

# Compiles `target` with what is precompiled, and links it.
function(shape_characteristics_use_precompiled target)
  target_precompile_headers(${target} REUSE_FROM Shape_characteristics_precompiled)
  target_link_libraries(${target} PRIVATE Shape_characteristics_precompiled)
endfunction()

# Adds the program `target` from `source`, linked with the libraries that follow.
function(shape_characteristics_add_program target source)
  add_executable(${target} ${source})
  target_link_libraries(${target} PRIVATE Shape_characteristics_development ${ARGN})
endfunction()
