# Programs of one source file each, compiled as one: they instantiate much the same templates, which takes a compiler longer than
# what is their own. What CMAKE_UNITY_BUILD does with the sources of a program.
#
# shape_characteristics_may_be_joined()  whether a source can be
# shape_characteristics_join_program()   adds a program to those that are

# Sets `result` to whether `source` has no directives but #include: it is read in a namespace, after the headers of all.
function(shape_characteristics_may_be_joined result source)
  file(STRINGS ${source} directives REGEX "^[ \t]*#")
  list(FILTER directives EXCLUDE REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
  if(directives)
    set(${result} FALSE PARENT_SCOPE)
  else()
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()

# Adds the program `target` from `source`. It is a link to the program `joined`, which looks by which name it was called.
function(shape_characteristics_join_program joined target source)
  if(NOT TARGET ${joined})
    set(all ${CMAKE_CURRENT_BINARY_DIR}/${joined}.cpp)
    file(GENERATE OUTPUT ${all} INPUT ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/joined_programs.cpp.in TARGET ${joined})
    shape_characteristics_add_program(${joined} ${all})
    shape_characteristics_use_precompiled(${joined})
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source}) # which headers it includes
  file(STRINGS ${source} headers REGEX "^[ \t]*#[ \t]*include")
  foreach(header IN LISTS headers)
    if(header MATCHES "\"(.*)\"")
      get_filename_component(header ${CMAKE_MATCH_1} ABSOLUTE BASE_DIR ${CMAKE_CURRENT_SOURCE_DIR}/${source}/..)
      set(header "#include \"${header}\"")
    endif()
    set_property(TARGET ${joined} APPEND PROPERTY JOINED_HEADERS "${header}")
  endforeach()
  set_property(TARGET ${joined} APPEND PROPERTY JOINED_SOURCES
    "namespace ${target} {\n#include \"${CMAKE_CURRENT_SOURCE_DIR}/${source}\"\n}")
  set_property(TARGET ${joined} APPEND PROPERTY JOINED_CALLS "  {\"${target}\", &call<&${target}::main>},")

  set(link ${CMAKE_CURRENT_BINARY_DIR}/${target})
  add_custom_command(TARGET ${joined} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E create_symlink $<TARGET_FILE_NAME:${joined}> ${link}
    BYPRODUCTS ${link}
    VERBATIM)
  add_executable(${target} IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${link})
  add_dependencies(${target} ${joined})
endfunction()
