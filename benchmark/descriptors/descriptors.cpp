// Point feature histograms, SHOT and spin images, ours and PCL's: points per second on one thread, and whether the values are the
// same, as a table in Markdown.
//
//   build/benchmark/benchmark/benchmark_descriptors_descriptors [--points 10000] [--neighbours 10,60,150]
//                                                               [--repetitions 5] [--seed 1] [--quick]
//
// The cloud is of random points of the graph of f1e, with its normals and a tenth of noise in them. The time goes from
// coordinates to descriptors, search structure included; the quickest repetition counts. `--quick` takes small clouds once
// and fails where values differ from PCL's by more than single precision explains: a pair of points whose feature lies at
// the edge of a bin may fall into the bin beside it.
#include "parts/pcl_descriptors.h"

#include "Command_line.h"
#include "Random.h"
#include "test_functions.h"

#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/Pfh_descriptor.h>
#include <Shape_characteristics/descriptors/Shot_descriptor.h>
#include <Shape_characteristics/descriptors/Shot_variant.h>
#include <Shape_characteristics/descriptors/Spin_image_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using namespace benchmark_support;
using descriptors::Oriented_cloud;
using descriptors::Peer_result;

// coordinates that single precision holds exactly: PCL sees the same points
Oriented_cloud random_cloud(std::size_t count, std::uint64_t seed)
{
  const Explicit_function& f = explicit_function("f1e");
  Random random(seed);
  Oriented_cloud cloud;
  for(std::size_t i = 0; i < count; ++i)
  {
    const double x = random.uniform(-f.half, f.half), y = random.uniform(-f.half, f.half);
    const Vector p = f.point(x, y), exact = f.exact(x, y).normal;
    Eigen::Vector3d n(exact.x, exact.y, exact.z);
    for(Eigen::Index k = 0; k < 3; ++k)
      n[k] += random.uniform(-.1, .1);
    n.normalize();
    cloud.points.push_back({float(p.x), float(p.y), float(p.z)});
    cloud.normals.push_back({float(n.x()), float(n.y()), float(n.z())});
  }
  return cloud;
}

SC::Point_set_samples samples_of(const Oriented_cloud& cloud, double radius)
{
  std::vector<Eigen::Vector3d> points, normals;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const auto &p = cloud.points[i], &n = cloud.normals[i];
    points.emplace_back(p[0], p[1], p[2]);
    normals.emplace_back(n[0], n[1], n[2]);
  }
  SC::Point_set_samples samples(points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                                SC::Neighborhood::ball(radius));
  samples.set_normals(std::move(normals));
  return samples;
}

// the radius in which a sample has so many neighbors on average
double radius_for(const Oriented_cloud& cloud, double neighbours)
{
  double low = 0., high = 100.;
  for(int step = 0; step < 40; ++step)
  {
    const double radius = (low + high) / 2.;
    std::size_t pairs = 0, centers = 0;
    const std::size_t stride = std::max<std::size_t>(cloud.points.size() / 200, 1);
    for(std::size_t i = 0; i < cloud.points.size(); i += stride, ++centers)
      for(const auto& q : cloud.points)
      {
        const auto& p = cloud.points[i];
        pairs += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= radius;
      }
    (double(pairs) / double(centers) - 1. < neighbours ? low : high) = radius;
  }
  return high;
}

SC::Descriptor_matrix our_fpfh(const Oriented_cloud& cloud, double radius)
{
  const SC::Point_set_samples samples = samples_of(cloud, radius);
  const SC::Fpfh_descriptor<SC::Point_set_samples> descriptor(samples, SC::Fpfh_variant::PCL,
                                                              CGAL::Sequential_tag());
  return SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, samples.size());
}

SC::Descriptor_matrix our_pfh(const Oriented_cloud& cloud, double radius)
{
  const SC::Point_set_samples samples = samples_of(cloud, radius);
  const SC::Pfh_descriptor<SC::Point_set_samples> descriptor(samples);
  return SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, samples.size());
}

SC::Descriptor_matrix our_shot(const Oriented_cloud& cloud, double radius)
{
  const SC::Point_set_samples samples = samples_of(cloud, radius);
  const SC::Shot_descriptor<SC::Point_set_samples> descriptor(samples, SC::Shot_variant::PCL);
  return SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, samples.size());
}

SC::Descriptor_matrix our_spin_images(const Oriented_cloud& cloud, double radius)
{
  const SC::Point_set_samples samples = samples_of(cloud, radius);
  // neighbors with all normals count, as PCL's do
  const SC::Spin_image_descriptor<SC::Point_set_samples> descriptor(samples, 8, CGAL_PI);
  return SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, samples.size());
}

struct Descriptor
{
  std::string name;
  float one_pair; // how much of a value one pair of points in ten thousand may be
  std::function<SC::Descriptor_matrix(const Oriented_cloud&, double)> ours;
  std::function<Peer_result(const Oriented_cloud&, double)> peer;
};

// the share of the rows that differ by more than `one_pair`, and the median difference
std::pair<double, double>
compare(const SC::Descriptor_matrix& ours, const std::vector<float>& peer, float one_pair)
{
  std::vector<float> differences;
  const std::size_t dimension = std::size_t(ours.values.cols());
  for(std::size_t i = 0; i < ours.status.size(); ++i)
    if(SC::is_estimated(ours.status[i]))
    {
      const float *const a = ours.values.data() + i * dimension, *const b = peer.data() + i * dimension;
      float largest = 0.f;
      for(std::size_t k = 0; k < dimension; ++k)
        largest = std::max(largest, std::abs(a[k] - b[k]));
      differences.push_back(largest);
    }
  if(differences.empty())
    return {1., std::numeric_limits<double>::infinity()};
  const auto median = differences.begin() + std::ptrdiff_t(differences.size() / 2);
  std::nth_element(differences.begin(), median, differences.end());
  const auto different = std::count_if(differences.begin(), differences.end(),
                                       [one_pair](const float d) { return !(d < one_pair); });
  return {double(different) / double(differences.size()), double(*median)};
}

int run(const Command_line& arguments)
{
  const bool is_quick = arguments.has("quick");
  const std::size_t points = std::size_t(arguments.number("points", is_quick ? 1000 : 10000, 1));
  const std::uint64_t repetitions = arguments.number("repetitions", is_quick ? 1 : 5, 1);
  const Oriented_cloud cloud = random_cloud(points, arguments.number("seed", 1));
  const std::vector<Descriptor> all = {{"FPFH", .05f, our_fpfh, descriptors::pcl_fpfh},
                                       {"PFH", .05f, our_pfh, descriptors::pcl_pfh},
                                       // a unit vector, where the others sum up to 300 and 100
                                       {"SHOT", 1e-3f, our_shot, descriptors::pcl_shot},
                                       {"spin image", .05f, our_spin_images, descriptors::pcl_spin_images}};

  std::cout << points << " points, one thread, thousands of points per second\n\n"
            << "| descriptor | neighbours | ours | PCL | times faster | other rows | median difference |\n"
            << "|---|---:|---:|---:|---:|---:|---:|\n";
  bool is_right = true, has_peer = false;
  for(const Descriptor& descriptor : all)
    for(const std::string& neighbours : arguments.list("neighbours", "10,60,150"))
    {
      const double radius = radius_for(cloud, std::stod(neighbours));
      double seconds = std::numeric_limits<double>::infinity();
      SC::Descriptor_matrix ours;
      Peer_result peer;
      for(std::uint64_t r = 0; r < repetitions; ++r)
      {
        const auto start = std::chrono::steady_clock::now();
        ours = descriptor.ours(cloud, radius);
        seconds = std::min(seconds,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        // seconds per point: one is enough
        const bool is_slow = descriptor.name == "PFH" && r > 0;
        const Peer_result again = is_slow ? peer : descriptor.peer(cloud, radius);
        if(r == 0 || again.seconds < peer.seconds)
          peer = again;
      }
      const auto per_second = [&](const double s) { return 1e-3 * double(points) / s; };
      std::cout << "| " << descriptor.name << " | " << neighbours << " | " << std::setprecision(3)
                << per_second(seconds) << " | ";
      if(peer.values.empty())
        std::cout << " | | | |\n";
      else
      {
        has_peer = true;
        const auto [share, median] = compare(ours, peer.values, descriptor.one_pair);
        is_right = is_right && share < .05 && median < 5e-3;
        std::cout << per_second(peer.seconds) << " | " << peer.seconds / seconds << " | " << 100. * share
                  << " % | " << median << " |\n";
      }
    }
  if(!has_peer)
    std::cout << "\nskipped: PCL isn't found, nothing was compared\n";
  return is_quick && !is_right ? 1 : 0;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    return run(Command_line(argc, argv, {"points", "neighbours", "repetitions", "seed"}, {"quick"}));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
