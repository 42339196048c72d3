# The meshes and point sets that the tests, examples and benchmarks read are those that CGAL's authors publish
# with their programs. Debian packs them in libcgal-demo; they are unpacked once into the build folder.
#
# SHAPE_CHARACTERISTICS_DATA_DIR: the folder with `meshes/` and `points_3/`. It may be given to use others.
set(SHAPE_CHARACTERISTICS_DATA_DIR ${PROJECT_BINARY_DIR}/data CACHE PATH "The folder of CGAL's meshes/ and points_3/")
set(data_archive /usr/share/doc/libcgal-dev/data.tar.gz)

if(NOT EXISTS ${SHAPE_CHARACTERISTICS_DATA_DIR}/meshes AND EXISTS ${data_archive})
  message(STATUS "Unpacking CGAL's meshes and point sets into ${SHAPE_CHARACTERISTICS_DATA_DIR}")
  # first aside, then renamed: a configuration that was interrupted leaves no half of them
  set(data_aside ${PROJECT_BINARY_DIR}/data_being_unpacked)
  file(REMOVE_RECURSE ${data_aside})
  file(ARCHIVE_EXTRACT INPUT ${data_archive} DESTINATION ${data_aside} PATTERNS data/meshes data/points_3)
  file(RENAME ${data_aside}/data ${SHAPE_CHARACTERISTICS_DATA_DIR})
  file(REMOVE_RECURSE ${data_aside})
endif()
if(NOT EXISTS ${SHAPE_CHARACTERISTICS_DATA_DIR}/meshes)
  message(WARNING "No meshes in ${SHAPE_CHARACTERISTICS_DATA_DIR}: tests and examples that read them will fail. "
                  "Install Debian's package libcgal-demo, or set SHAPE_CHARACTERISTICS_DATA_DIR to the folder "
                  "Data/data of CGAL's sources.")
endif()
