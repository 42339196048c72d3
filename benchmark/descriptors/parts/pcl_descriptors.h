#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_DESCRIPTORS_PCL_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_DESCRIPTORS_PCL_DESCRIPTORS_H

#include <array>
#include <vector>

// No type of a library goes from the one side to the other: they are compiled for different processors.
namespace descriptors {

/// points with unit normals
struct Oriented_cloud
{
  std::vector<std::array<float, 3>> points, normals;
};

/// the descriptors one after the other, and how long they took, their search tree included; no values where PCL isn't found
struct Peer_result
{
  std::vector<float> values;
  double seconds = 0.;
};

/// `pcl::FPFHEstimation` with the points within `radius`, by one thread
[[gnu::visibility("default")]] Peer_result pcl_fpfh(const Oriented_cloud& cloud, double radius);

/// `pcl::PFHEstimation` with the points within `radius`, by one thread
[[gnu::visibility("default")]] Peer_result pcl_pfh(const Oriented_cloud& cloud, double radius);

/// `pcl::SHOTEstimation` with the points within `radius`, by one thread
[[gnu::visibility("default")]] Peer_result pcl_shot(const Oriented_cloud& cloud, double radius);

/// `pcl::SpinImageEstimation` with the points within `radius`, by one thread; in percent
[[gnu::visibility("default")]] Peer_result pcl_spin_images(const Oriented_cloud& cloud, double radius);

} // namespace descriptors

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_DESCRIPTORS_PCL_DESCRIPTORS_H
