# Sets examples_with_figures to the examples (targets) whose pictures the manual shows; to none where the manual isn't written.
set(examples_with_figures "")
if(SHAPE_CHARACTERISTICS_BUILD_DOCUMENTATION AND DOXYGEN_FOUND)
  set(examples_with_figures
    example_figures_hero
    example_figures_characteristics
    example_figures_neighborhoods
    example_characteristics_saliency
    example_characteristics_sharp_vertices
    example_curvature_compare_estimators
    example_descriptors_spin_image_descriptors
    example_screen_space_screen_space_curvature
    example_screen_space_ambient_occlusion
    example_head_features_head_features
    example_head_features_deform_head)
endif()
