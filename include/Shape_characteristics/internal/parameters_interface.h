// The list of the named parameters. No include guard: it is read several times.
// SC_new_parameter(tag type, tag, function): ours. SC_CGAL_parameter(tag type, function): CGAL's.

// neighborhoods
SC_new_parameter(number_of_rings_t, number_of_rings, number_of_rings)
    SC_new_parameter(number_of_neighbors_t, number_of_neighbors, number_of_neighbors)
        SC_CGAL_parameter(neighbor_radius_t, neighbor_radius)

    // input
    SC_CGAL_parameter(vertex_point_t, vertex_point_map) SC_CGAL_parameter(vertex_index_t, vertex_index_map)
        SC_CGAL_parameter(vertex_normal_map_t, vertex_normal_map)
            SC_CGAL_parameter(face_normal_t, face_normal_map) SC_CGAL_parameter(point_t, point_map)
                SC_CGAL_parameter(normal_t, normal_map) SC_CGAL_parameter(geom_traits_t, geom_traits)

    // output
    SC_new_parameter(principal_curvatures_and_directions_map_t,
                     principal_curvatures_and_directions_map,
                     principal_curvatures_and_directions_map)
        SC_new_parameter(mean_curvature_map_t, mean_curvature_map, mean_curvature_map)
            SC_new_parameter(Gaussian_curvature_map_t, Gaussian_curvature_map, Gaussian_curvature_map)
                SC_new_parameter(vertex_status_map_t, vertex_status_map, vertex_status_map)
                    SC_new_parameter(status_map_t, status_map, status_map)
#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0) // born in CGAL 6.0: ours before, CGAL's after
                        SC_new_parameter(vertex_principal_curvatures_and_directions_map_t,
                                         vertex_principal_curvatures_and_directions_map,
                                         vertex_principal_curvatures_and_directions_map)
                            SC_new_parameter(vertex_mean_curvature_map_t,
                                             vertex_mean_curvature_map,
                                             vertex_mean_curvature_map)
                                SC_new_parameter(vertex_Gaussian_curvature_map_t,
                                                 vertex_Gaussian_curvature_map,
                                                 vertex_Gaussian_curvature_map)
                                    SC_new_parameter(vertex_principal_curvatures_and_directions_t,
                                                     vertex_principal_curvatures_and_directions,
                                                     vertex_principal_curvatures_and_directions)
                                        SC_new_parameter(vertex_mean_curvature_t,
                                                         vertex_mean_curvature,
                                                         vertex_mean_curvature)
                                            SC_new_parameter(vertex_Gaussian_curvature_t,
                                                             vertex_Gaussian_curvature,
                                                             vertex_Gaussian_curvature)
                                                SC_new_parameter(ball_radius_t, ball_radius, ball_radius)
#else
                        SC_CGAL_parameter(vertex_principal_curvatures_and_directions_map_t,
                                          vertex_principal_curvatures_and_directions_map)
                            SC_CGAL_parameter(vertex_mean_curvature_map_t, vertex_mean_curvature_map)
                                SC_CGAL_parameter(vertex_Gaussian_curvature_map_t,
                                                  vertex_Gaussian_curvature_map)
                                    SC_CGAL_parameter(vertex_principal_curvatures_and_directions_t,
                                                      vertex_principal_curvatures_and_directions)
                                        SC_CGAL_parameter(vertex_mean_curvature_t, vertex_mean_curvature)
                                            SC_CGAL_parameter(vertex_Gaussian_curvature_t,
                                                              vertex_Gaussian_curvature)
                                                SC_CGAL_parameter(ball_radius_t, ball_radius)
#endif

    // Hermite-RBF fit
    SC_new_parameter(radial_basis_function_t, radial_basis_function, radial_basis_function)
        SC_new_parameter(normals_are_exact_t, normals_are_exact, normals_are_exact)
            SC_new_parameter(noise_level_t, noise_level, noise_level) SC_new_parameter(normal_noise_level_t,
                                                                                       normal_noise_level,
                                                                                       normal_noise_level)
                SC_new_parameter(vertex_estimator_map_t, vertex_estimator_map, vertex_estimator_map)
                    SC_new_parameter(estimator_map_t, estimator_map, estimator_map)
                        SC_new_parameter(number_of_passes_t, number_of_passes, number_of_passes)
                            SC_new_parameter(shape_parameter_box_t, shape_parameter_box, shape_parameter_box)
                                SC_new_parameter(sampling_distance_t, sampling_distance, sampling_distance)
                                    SC_new_parameter(polynomial_degree_t,
                                                     polynomial_degree,
                                                     polynomial_degree)
                                        SC_new_parameter(fits_are_shared_t, fits_are_shared, fits_are_shared)

    // other estimators
    SC_new_parameter(number_of_edges_t, number_of_edges, number_of_edges)
        SC_new_parameter(face_weighting_t, face_weighting, face_weighting)
            SC_new_parameter(patch_evaluation_t, patch_evaluation, patch_evaluation)
                SC_new_parameter(height_field_normal_t, height_field_normal, height_field_normal)
                    SC_new_parameter(normal_weighting_t, normal_weighting, normal_weighting)
                        SC_new_parameter(point_normal_method_t, point_normal_method, point_normal_method)
                            SC_CGAL_parameter(degree_fitting_t, degree_fitting)

    // saliency
    SC_new_parameter(vertex_saliency_map_t, vertex_saliency_map, vertex_saliency_map)
        SC_new_parameter(saliency_map_t, saliency_map, saliency_map)
            SC_new_parameter(saliency_scale_t, saliency_scale, saliency_scale)

    // descriptors
    SC_new_parameter(descriptor_samples_t, descriptor_samples, descriptor_samples)
        SC_new_parameter(fpfh_variant_t, fpfh_variant, fpfh_variant)
            SC_new_parameter(shot_variant_t, shot_variant, shot_variant)
                SC_new_parameter(image_width_t, image_width, image_width)
                    SC_new_parameter(support_angle_t, support_angle, support_angle)
                        SC_new_parameter(flux_method_t, flux_method, flux_method)
                            SC_new_parameter(area_map_t, area_map, area_map)
                                SC_new_parameter(signed_volume_method_t,
                                                 signed_volume_method,
                                                 signed_volume_method)
                                    SC_new_parameter(signal_scaling_t, signal_scaling, signal_scaling)

    // ambient occlusion
    SC_new_parameter(ambient_occlusion_map_t, ambient_occlusion_map, ambient_occlusion_map)
        SC_new_parameter(ambient_occlusion_mapping_t, ambient_occlusion_mapping, ambient_occlusion_mapping)
            SC_new_parameter(number_of_rays_t, number_of_rays, number_of_rays)
                SC_new_parameter(maximum_ray_length_t, maximum_ray_length, maximum_ray_length)

    // registration
    SC_new_parameter(source_samples_t, source_samples, source_samples)
        SC_new_parameter(target_samples_t, target_samples, target_samples)
            SC_new_parameter(mirrored_target_descriptors_t,
                             mirrored_target_descriptors,
                             mirrored_target_descriptors)
                SC_new_parameter(edge_length_similarity_t, edge_length_similarity, edge_length_similarity)
                    SC_new_parameter(orientation_is_tested_t, orientation_is_tested, orientation_is_tested)
                        SC_new_parameter(normals_are_tested_t, normals_are_tested, normals_are_tested)
                            SC_new_parameter(normal_tolerance_t, normal_tolerance, normal_tolerance)
                                SC_new_parameter(number_of_tuples_t, number_of_tuples, number_of_tuples)
                                    SC_new_parameter(tries_per_correspondence_t,
                                                     tries_per_correspondence,
                                                     tries_per_correspondence)
                                        SC_new_parameter(maximum_correspondence_distance_t,
                                                         maximum_correspondence_distance,
                                                         maximum_correspondence_distance)
                                            SC_new_parameter(minimum_normal_cosine_t,
                                                             minimum_normal_cosine,
                                                             minimum_normal_cosine)
                                                SC_CGAL_parameter(number_of_iterations_t,
                                                                  number_of_iterations)
                                                    SC_new_parameter(maximum_number_of_samples_t,
                                                                     maximum_number_of_samples,
                                                                     maximum_number_of_samples)

    // screen space
    SC_new_parameter(min_curvature_map_t, min_curvature_map, min_curvature_map)
        SC_new_parameter(max_curvature_map_t, max_curvature_map, max_curvature_map)
            SC_new_parameter(shape_index_map_t, shape_index_map, shape_index_map)
                SC_new_parameter(number_of_triangles_t, number_of_triangles, number_of_triangles)
                    SC_new_parameter(level_of_detail_t, level_of_detail, level_of_detail)
                        SC_new_parameter(depth_discontinuity_rule_t,
                                         depth_discontinuity_rule,
                                         depth_discontinuity_rule)
                            SC_new_parameter(pixel_radius_t, pixel_radius, pixel_radius)
                                SC_new_parameter(vertex_texture_coordinates_map_t,
                                                 vertex_texture_coordinates_map,
                                                 vertex_texture_coordinates_map)

    // features of heads
    SC_new_parameter(head_pose_t, head_pose, head_pose) SC_new_parameter(head_is_aligned_t,
                                                                         head_is_aligned,
                                                                         head_is_aligned)
        SC_new_parameter(head_feature_method_t, head_feature_method, head_feature_method)
            SC_new_parameter(curvature_estimator_t, curvature_estimator, curvature_estimator)
                SC_new_parameter(vertex_head_descriptor_map_t,
                                 vertex_head_descriptor_map,
                                 vertex_head_descriptor_map) SC_new_parameter(averaging_radius_t,
                                                                              averaging_radius,
                                                                              averaging_radius)
                    SC_new_parameter(number_of_eye_vertices_t, number_of_eye_vertices, number_of_eye_vertices)
                        SC_new_parameter(number_of_nose_vertices_t,
                                         number_of_nose_vertices,
                                         number_of_nose_vertices) SC_new_parameter(number_of_ear_vertices_t,
                                                                                   number_of_ear_vertices,
                                                                                   number_of_ear_vertices)
                            SC_new_parameter(detection_radius_t, detection_radius, detection_radius)

    // pose of heads
    SC_new_parameter(upward_direction_t, upward_direction, upward_direction)

    // deformation of heads
    SC_new_parameter(deformed_vertex_point_map_t, deformed_vertex_point_map, deformed_vertex_point_map)

    // general
    SC_CGAL_parameter(callback_t, callback) SC_CGAL_parameter(random_seed_t, random_seed)
        SC_CGAL_parameter(verbose_t, verbose)
