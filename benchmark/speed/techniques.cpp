// What each technique gives the Hermite-RBF fit: times and errors on f1e, one thread, as a table in Markdown.
//
//   build/benchmark/benchmark/benchmark_speed_techniques [--points 10000] [--repetitions 9] [--quick]
//
// Samples with normals are prepared beforehand; their neighborhoods are searched within the time. The quickest repetition
// counts; repetitions of all techniques take turns, so that none is favored by what else the machine does.
#include "tessellations.h"
#include "test_functions.h"

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/internal/Batched_hermite_rbf.h>
#include <Shape_characteristics/interpolation/internal/Sample_patches.h>
#include <Shape_characteristics/interpolation/internal/for_each_patch.h>
#include <Shape_characteristics/normals/vertex_normals.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include "build_face_graph.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <chrono>
#include <cmath>
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
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Samples = SC::Face_graph_samples;
using Fits = std::vector<SC::Local_implicit_surface>;

struct Technique
{
  std::string name;
  std::function<void(Fits&)> run;
  double seconds = std::numeric_limits<double>::infinity();
  double error = 0.;
};

template <typename RadialBasisFunction>
std::function<void(Fits&)> plain(const Samples& samples, const RadialBasisFunction& phi, bool exact)
{
  using Fit = SC::Local_hermite_rbf<Samples, RadialBasisFunction>;
  return [&samples, phi, exact](Fits& fits)
  {
    typename Fit::Options options;
    options.normals_are_exact = exact;
    const Fit fit(samples, phi, options);
    typename Fit::Workspace workspace;
    for(std::size_t i = 0; i < samples.size(); ++i)
      fits[i] = fit(i, workspace);
  };
}

template <typename RadialBasisFunction>
std::function<void(Fits&)> batched(const Samples& samples,
                                   const RadialBasisFunction& phi,
                                   bool exact,
                                   std::size_t lanes,
                                   bool shared,
                                   bool refined = false)
{
  using Fit = SC::internal::Batched_hermite_rbf<Samples, RadialBasisFunction>;
  return [&samples, phi, exact, lanes, shared, refined](Fits& fits)
  {
    const std::size_t patch_size =
        SC::internal::Sample_patches::patch_size_for(samples.size(), exact ? 4 : 8);
    typename Fit::Options options;
    options.normals_are_exact = exact;
    options.fits_are_shared = shared;
    options.large_weights_are_refined = refined;
    const Fit fit(samples, phi, options, lanes);
    auto patches = SC::internal::Sample_patches::compact(samples, patch_size);
    SC::internal::for_each_patch<CGAL::Sequential_tag>(
        fit, samples.size(), patches,
        {[&](const std::size_t i, const SC::Local_implicit_surface& local) { fits[i] = local; }});
  };
}

// mean of the errors of both curvatures
double mean_error(const Fits& fits, const std::vector<Exact_curvature>& exact)
{
  double sum = 0.;
  std::size_t count = 0;
  for(std::size_t i = 0; i < fits.size(); ++i)
    if(SC::is_estimated(fits[i].status))
    {
      const double length = fits[i].gradient.norm();
      const Eigen::Vector3d n = fits[i].gradient / length;
      const Eigen::Matrix3d projection = Eigen::Matrix3d::Identity() - n * n.transpose();
      Eigen::Vector3d k =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(projection * fits[i].hessian * projection / length)
              .eigenvalues();
      // the one of the normal is zero: the others are left
      Eigen::Index zero = 0;
      k.cwiseAbs().minCoeff(&zero);
      std::swap(k[zero], k[2]);
      sum +=
          std::abs(std::max(k[0], k[1]) - exact[i].k_max) + std::abs(std::min(k[0], k[1]) - exact[i].k_min);
      ++count;
    }
  return sum / double(count);
}

void print(const std::string& title,
           std::vector<Technique>& techniques,
           const std::vector<Exact_curvature>& exact,
           int repetitions)
{
  Fits fits(exact.size());
  for(int r = 0; r < repetitions; ++r)
    for(Technique& t : techniques)
    {
      const auto start = std::chrono::steady_clock::now();
      t.run(fits);
      t.seconds = std::min(t.seconds,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      t.error = mean_error(fits, exact);
    }
  std::cout << "\n### " << title
            << "\n\n| technique | µs/vertex | times faster | MAE |\n|---|---:|---:|---:|\n";
  for(const Technique& t : techniques)
    std::cout << "| " << t.name << " | " << std::setprecision(3) << 1e6 * t.seconds / double(exact.size())
              << " | " << techniques.front().seconds / t.seconds << " | " << std::setprecision(2) << t.error
              << " |\n";
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t points = 10000;
  int repetitions = 9;
  for(int k = 1; k < argc; ++k)
  {
    const std::string argument = argv[k];
    if(argument == "--quick")
    {
      points = 600;
      repetitions = 1;
    }
    else if(argument == "--points" && k + 1 < argc)
      points = std::stoul(argv[++k]);
    else if(argument == "--repetitions" && k + 1 < argc)
      repetitions = std::stoi(argv[++k]);
    else
    {
      std::cerr << "usage: benchmark_speed_techniques [--points N] [--repetitions N] [--quick]\n";
      return 1;
    }
  }

  const Explicit_function& f = explicit_function("f1e");
  const Triangle_arrays arrays = random_tessellation(f, points, 1);
  const Mesh mesh = build_face_graph<Mesh>(arrays.points, arrays.triangles);
  std::vector<Exact_curvature> exact;
  std::vector<Eigen::Vector3d> normals;
  for(const Vector& p : arrays.points)
  {
    exact.push_back(f.exact(p.x, p.y));
    normals.emplace_back(exact.back().normal.x, exact.back().normal.y, exact.back().normal.z);
  }
  Samples with_exact(mesh, mesh.points(), SC::Neighborhood::rings(2));
  Samples with_estimated(mesh, mesh.points(), SC::Neighborhood::rings(2));
  with_exact.set_normals(std::move(normals));
  with_estimated.set_normals(
      SC::vertex_normals<CGAL::Sequential_tag>(with_estimated, SC::Normal_weighting::MAX));

  const SC::Inverse_multiquadric multiquadric;
  const SC::Matern_9_2 matern;
  std::vector<Technique> of_exact = {
      {"thesis: 4m equations, r^5, LU", plain(with_exact, SC::Polyharmonic<5>(), true)},
      {"3m + 1 equations, positive definite, Cholesky", plain(with_exact, multiquadric, true)},
      {"the same in batches of equal size, one by one", batched(with_exact, multiquadric, true, 1, false)},
      {"... 2 side by side (SSE2)", batched(with_exact, multiquadric, true, 2, false)},
      {"... 4 side by side (AVX2)", batched(with_exact, multiquadric, true, 4, false)},
      {"... 8 side by side (AVX-512)", batched(with_exact, multiquadric, true, 8, false)},
      {"a fit serves the samples near its center, 4 side by side",
       batched(with_exact, multiquadric, true, 4, true)},
      {"... 8 side by side", batched(with_exact, multiquadric, true, 8, true)},
      {"... and large weights are refined", batched(with_exact, multiquadric, true, 8, true, true)}};
  std::vector<Technique> of_estimated = {
      {"4m equations, positive definite, Cholesky", plain(with_estimated, matern, false)},
      {"batches, 8 side by side", batched(with_estimated, matern, false, 8, false)},
      {"a fit serves the samples near its center", batched(with_estimated, matern, false, 8, true)},
      {"... and large weights are refined", batched(with_estimated, matern, false, 8, true, true)}};
  std::cout << "f1e, " << points << " random points, 2 rings; this processor runs "
            << SC::internal::Hermite_batch_functions<SC::Matern_9_2>::best().lanes << " fits side by side.\n";
  print("Exact normals", of_exact, exact, repetitions);
  print("Normals estimated from the mesh", of_estimated, exact, repetitions);
  return 0;
}
