# The rules of the library's headers, each a function that sets `result` to the list of what breaks it.

# The folders, in the order in which they build on each other: a header includes headers of its own folder and of
# folders to the left. What lies directly in Shape_characteristics/, with its internal/, is for all.
set(folders root sampling interpolation normals curvature characteristics descriptors screen_space head_features
    registration)

# Sets `result` to the folder that the header with the path `path` (relative to Shape_characteristics/) belongs to.
function(folder_of result path)
  if(path MATCHES "^([^/]+)/" AND NOT CMAKE_MATCH_1 STREQUAL "internal")
    set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
  else()
    set(${result} root PARENT_SCOPE)
  endif()
endfunction()

# Includes point one way, and internal/ of a folder is for that folder.
function(find_wrong_includes result headers)
  set(wrong "")
  file(GLOB_RECURSE found RELATIVE ${headers} ${headers}/*.h)
  foreach(header IN LISTS found)
    folder_of(folder ${header})
    list(FIND folders ${folder} rank)
    if(rank EQUAL -1)
      list(JOIN folders ", " order)
      list(APPEND wrong "${header}: the folder ${folder} has no place in the order ${order}")
      continue()
    endif()
    file(STRINGS ${headers}/${header} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      if(line MATCHES "include[ \t]*\"")
        list(APPEND wrong "${header}: ${line}: is to be written with < > and the whole path")
      elseif(line MATCHES "<Shape_characteristics/(.*)>")
        set(included ${CMAKE_MATCH_1})
        folder_of(included_folder ${included})
        list(FIND folders ${included_folder} included_rank)
        if(NOT EXISTS ${headers}/${included})
          list(APPEND wrong "${header}: includes ${included}, which does not exist")
        elseif(included_rank GREATER rank)
          list(APPEND wrong "${header}: includes ${included}, which builds on ${folder}")
        elseif(included MATCHES "/internal/" AND NOT included_folder STREQUAL folder)
          list(APPEND wrong "${header}: includes ${included}, which is for ${included_folder} only")
        endif()
      endif()
    endforeach()
  endforeach()
  set(${result} "${wrong}" PARENT_SCOPE)
endfunction()

# Include guards tell the path: curvature/hrbf_curvatures.h has SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H.
function(find_wrong_guards result headers)
  set(wrong "")
  file(GLOB_RECURSE found RELATIVE ${headers} ${headers}/*.h)
  list(REMOVE_ITEM found internal/parameters_interface.h) # a list, read several times
  foreach(header IN LISTS found)
    string(TOUPPER "SHAPE_CHARACTERISTICS_${header}" guard)
    string(REGEX REPLACE "[/.]" "_" guard ${guard})
    file(STRINGS ${headers}/${header} directives REGEX "^[ \t]*#" LIMIT_COUNT 2)
    if(NOT directives STREQUAL "#ifndef ${guard};#define ${guard}")
      list(JOIN directives " " directives)
      list(APPEND wrong "${header}: begins with '${directives}', not with the include guard ${guard}")
    endif()
  endforeach()
  set(${result} "${wrong}" PARENT_SCOPE)
endfunction()

# The library does not print.
function(find_output result headers)
  set(wrong "")
  file(GLOB_RECURSE found RELATIVE ${headers} ${headers}/*.h)
  foreach(header IN LISTS found)
    file(STRINGS ${headers}/${header} lines
      REGEX "(std::(cout|cerr|clog)|(^|[^a-zA-Z_])v?f?(printf|puts|putchar)[ ]*\\(|include[ \t]*<(iostream|cstdio|stdio\\.h)>)")
    foreach(line IN LISTS lines)
      string(REPLACE ";" "" line "${line}") # it would end the element of the list
      list(APPEND wrong "${header}: ${line}")
    endforeach()
  endforeach()
  set(${result} "${wrong}" PARENT_SCOPE)
endfunction()
