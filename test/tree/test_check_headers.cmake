# The rules of headers.cmake find what breaks them, and only that.
#   cmake -D SCRATCH=<folder> -P test_check_headers.cmake
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)

# Writes a header with its include guard and the given lines.
function(write_header path)
  string(TOUPPER "SHAPE_CHARACTERISTICS_${path}" guard)
  string(REGEX REPLACE "[/.]" "_" guard ${guard})
  list(JOIN ARGN "\n" lines)
  file(WRITE ${SCRATCH}/${path} "#ifndef ${guard}\n#define ${guard}\n${lines}\n#endif\n")
endfunction()

# `rule` says what is wrong with the headers of the moment: `expected`, a list of regular expressions.
function(expect rule)
  cmake_language(CALL ${rule} wrong ${SCRATCH})
  list(LENGTH wrong number_found)
  list(LENGTH ARGN number_expected)
  set(agree TRUE)
  if(NOT number_found EQUAL number_expected)
    set(agree FALSE)
  endif()
  foreach(pair IN ZIP_LISTS wrong ARGN)
    if(NOT "${pair_0}" MATCHES "${pair_1}")
      set(agree FALSE)
    endif()
  endforeach()
  if(NOT agree)
    message(SEND_ERROR "${rule} found '${wrong}' where '${ARGN}' is expected")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
write_header(Root.h "#include <vector>" "#include <Shape_characteristics/internal/shared.h>")
write_header(internal/shared.h)
write_header(normals/normals.h "#include <Shape_characteristics/Root.h>")
write_header(curvature/internal/fit.h "#include <Shape_characteristics/normals/normals.h>")
write_header(curvature/curvature.h
  "#include <Shape_characteristics/internal/shared.h>" "#include <Shape_characteristics/curvature/internal/fit.h>"
  "inline void f(char* s) { std::snprintf(s, 1, \"\")\; }")
expect(find_wrong_includes)
expect(find_wrong_guards)
expect(find_output)

write_header(normals/to_the_right.h "#include <Shape_characteristics/curvature/curvature.h>")
expect(find_wrong_includes "^normals/to_the_right.h: includes curvature/curvature.h, which builds on normals")
file(REMOVE ${SCRATCH}/normals/to_the_right.h)

write_header(Root.h "#  include <Shape_characteristics/normals/normals.h> // comment")
expect(find_wrong_includes "^Root.h: includes normals/normals.h, which builds on root")
write_header(Root.h)

write_header(characteristics/internal_of_others.h "#include <Shape_characteristics/curvature/internal/fit.h>")
expect(find_wrong_includes "^characteristics/internal_of_others.h: .*curvature/internal/fit.h, which is for curvature")
file(REMOVE ${SCRATCH}/characteristics/internal_of_others.h)

write_header(normals/quoted.h "#include \"normals.h\"")
write_header(normals/gone.h "#include <Shape_characteristics/normals/nothing.h>")
expect(find_wrong_includes "^normals/gone.h: .*does not exist" "^normals/quoted.h: ")
file(REMOVE ${SCRATCH}/normals/quoted.h ${SCRATCH}/normals/gone.h)

write_header(attic/old.h)
expect(find_wrong_includes "^attic/old.h: the folder attic has no place")
file(REMOVE ${SCRATCH}/attic/old.h)

file(WRITE ${SCRATCH}/normals/copied.h "#ifndef SHAPE_CHARACTERISTICS_NORMALS_NORMALS_H\n#endif\n")
file(WRITE ${SCRATCH}/normals/unguarded.h "struct S {};\n")
expect(find_wrong_guards "^normals/copied.h: " "^normals/unguarded.h: ")
file(REMOVE ${SCRATCH}/normals/copied.h ${SCRATCH}/normals/unguarded.h)

file(WRITE ${SCRATCH}/normals/prints.h
  "#include <iostream>\ninline void f() { std::cerr << 1; }\nvoid g()\n{\n  printf(\"\");\n}\n")
expect(find_output "^normals/prints.h: #include <iostream>" "std::cerr << 1" "printf")

file(REMOVE ${SCRATCH}/normals/prints.h)

write_header(normals/matrix.h "#include <Eigen/Core>" "using Matrix = Eigen::Matrix3d\;")
write_header(curvature/has_matrix.h "#include <Shape_characteristics/normals/matrix.h>" "using A = Eigen::Array3d\;")
write_header(curvature/has_none.h "#include <Shape_characteristics/normals/matrix.h>" "// of CGAL::Point_3"
  "using Map = boost::property_map<int, int>\;")
expect(find_missing_libraries "^curvature/has_none.h: names boost::")

file(REMOVE_RECURSE ${SCRATCH})
write_header(normals/normals.h "\\cgalParamNBegin{point_map}" "\\cgalParamNBegin{point}")
file(WRITE ${SCRATCH}/table "<td class=\"paramname\">point_map</td>")
find_unlisted_parameters(wrong ${SCRATCH} ${SCRATCH}/table)
if(NOT wrong MATCHES "^normals/normals.h: the parameter point is not in [^;]*$")
  message(SEND_ERROR "find_unlisted_parameters found '${wrong}'")
endif()
file(WRITE ${SCRATCH}/aliases "one=\\cgalParamNBegin{point_map} x \\cgalParamNEnd \\cgalParamNBegin{other_map} y \\cgalParamNEnd")
write_header(normals/normals.h "\\cgalParamNBegin{point_map}")
find_unlisted_parameters(wrong ${SCRATCH} ${SCRATCH}/table ${SCRATCH}/aliases)
if(NOT wrong MATCHES "/aliases: the parameter other_map is not in [^;]*$")
  message(SEND_ERROR "find_unlisted_parameters found '${wrong}' in aliases")
endif()
