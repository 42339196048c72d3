# Shape_characteristics::OpenGL_support: what the headers of screen_space/OpenGL/ need beside the library, libepoxy.
# There is no such target where there is none.
find_path(EPOXY_INCLUDE_DIR epoxy/gl.h)
find_library(EPOXY_LIBRARY epoxy)
mark_as_advanced(EPOXY_INCLUDE_DIR EPOXY_LIBRARY)
if(EPOXY_INCLUDE_DIR AND EPOXY_LIBRARY AND NOT TARGET Shape_characteristics::OpenGL_support)
  add_library(Shape_characteristics::OpenGL_support INTERFACE IMPORTED)
  set_target_properties(Shape_characteristics::OpenGL_support PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${EPOXY_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "Shape_characteristics::Shape_characteristics;${EPOXY_LIBRARY}")
endif()
