// In a file of its own: PCL's headers are slow to compile.
#include "pcl_descriptors.h"

#ifdef SHAPE_CHARACTERISTICS_BENCHMARK_PCL

#include <pcl/console/print.h>
#include <pcl/features/fpfh.h>
#include <pcl/features/pfh.h>
#include <pcl/features/shot.h>
#include <pcl/features/spin_image.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>

namespace descriptors {
namespace {

template <typename Signature>
const float* values_of(const Signature& s)
{
  return s.histogram;
}

const float* values_of(const pcl::SHOT352& s)
{
  return s.descriptor;
}

template <typename Estimation, typename Signature>
Peer_result estimate(const Oriented_cloud& cloud, double radius)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const auto &p = cloud.points[i], &n = cloud.normals[i];
    points->push_back(pcl::PointXYZ(p[0], p[1], p[2]));
    normals->push_back(pcl::Normal(n[0], n[1], n[2]));
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // silent where there is no descriptor
  const auto start = std::chrono::steady_clock::now();
  Estimation estimation;
  estimation.setInputCloud(points);
  estimation.setInputNormals(normals);
  estimation.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  estimation.setRadiusSearch(radius);
  pcl::PointCloud<Signature> signatures;
  estimation.compute(signatures);
  Peer_result result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for(const Signature& s : signatures)
    std::copy_n(values_of(s), Signature::descriptorSize(), std::back_inserter(result.values));
  return result;
}

} // namespace

Peer_result pcl_fpfh(const Oriented_cloud& cloud, double radius)
{
  using Estimation = pcl::FPFHEstimation<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33>;
  return estimate<Estimation, pcl::FPFHSignature33>(cloud, radius);
}

Peer_result pcl_pfh(const Oriented_cloud& cloud, double radius)
{
  using Estimation = pcl::PFHEstimation<pcl::PointXYZ, pcl::Normal, pcl::PFHSignature125>;
  return estimate<Estimation, pcl::PFHSignature125>(cloud, radius);
}

Peer_result pcl_shot(const Oriented_cloud& cloud, double radius)
{
  using Estimation = pcl::SHOTEstimation<pcl::PointXYZ, pcl::Normal, pcl::SHOT352>;
  return estimate<Estimation, pcl::SHOT352>(cloud, radius);
}

Peer_result pcl_spin_images(const Oriented_cloud& cloud, double radius)
{
  using Image = pcl::Histogram<153>;
  Peer_result result =
      estimate<pcl::SpinImageEstimation<pcl::PointXYZ, pcl::Normal, Image>, Image>(cloud, radius);
  for(float& value : result.values)
    value *= 100.f; // its sum is 1
  return result;
}

} // namespace descriptors

#else

namespace descriptors {

Peer_result pcl_fpfh(const Oriented_cloud&, double)
{
  return {};
}

Peer_result pcl_pfh(const Oriented_cloud&, double)
{
  return {};
}

Peer_result pcl_shot(const Oriented_cloud&, double)
{
  return {};
}

Peer_result pcl_spin_images(const Oriented_cloud&, double)
{
  return {};
}

} // namespace descriptors

#endif
