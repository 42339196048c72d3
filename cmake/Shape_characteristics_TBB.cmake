# Shape_characteristics::TBB_support: what makes `CGAL::Parallel_if_available_tag` parallel.
# There is no such target where there is no TBB.
if(TARGET TBB::tbb AND TARGET TBB::tbbmalloc AND NOT TARGET Shape_characteristics::TBB_support)
  add_library(Shape_characteristics::TBB_support INTERFACE IMPORTED)
  set_target_properties(Shape_characteristics::TBB_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS "CGAL_LINKED_WITH_TBB;NOMINMAX"
    INTERFACE_LINK_LIBRARIES "Shape_characteristics::Shape_characteristics;TBB::tbb;TBB::tbbmalloc")
endif()
