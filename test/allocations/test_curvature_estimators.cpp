#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <tuple>
#include <vector>

#include <malloc.h>

// How much memory the estimators take beyond the caller's input and output, by counting what is allocated.

namespace {

std::atomic<std::ptrdiff_t> bytes{0}, peak{0};
std::atomic<std::size_t> allocations{0};

void* counted(void* p)
{
  if(p == nullptr)
    throw std::bad_alloc();
  ++allocations;
  const std::ptrdiff_t now = bytes += std::ptrdiff_t(malloc_usable_size(p));
  std::ptrdiff_t before = peak;
  while(before < now && !peak.compare_exchange_weak(before, now))
  {}
  return p;
}

void release(void* p) noexcept
{
  bytes -= std::ptrdiff_t(malloc_usable_size(p)); // 0 of a null pointer
  std::free(p);
}

} // namespace

void* operator new(std::size_t size)
{
  return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  void* p = nullptr;
  return counted(posix_memalign(&p, std::size_t(alignment), size) == 0 ? p : nullptr);
}
void operator delete(void* p) noexcept
{
  release(p);
}
void operator delete(void* p, std::size_t) noexcept
{
  release(p);
}
void operator delete(void* p, std::align_val_t) noexcept
{
  release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  release(p);
}

BOOST_AUTO_TEST_SUITE(curvature_estimators)

namespace {

namespace SC = Shape_characteristics;
namespace sp = SC::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

struct Use
{
  double bytes = 0.;
  std::size_t allocations = 0;
};

Use use_of(const std::function<void()>& function)
{
  const std::ptrdiff_t before = bytes;
  peak = before;
  const std::size_t allocations_before = allocations;
  function();
  return {double(peak - before), allocations - allocations_before};
}

// What each further sample takes, and the number of allocations it makes: workspaces and arrays of fixed size are not
// counted.
Use per_sample(const std::function<std::function<void()>(std::size_t)>& make)
{
  const std::size_t few = 150 * 150, many = 300 * 300;
  const auto of_few = make(150), of_many = make(300);
  const Use a = use_of(of_few), b = use_of(of_many);
  return {(b.bytes - a.bytes) / double(many - few),
          std::size_t((double(b.allocations) - double(a.allocations)) / double(many - few) + .5)};
}

test_support::Analytic_surface surface(std::size_t n)
{
  return test_support::waves(.1, 4., 1., unsigned(n) - 1, .2);
}

// `Function` as for `per_sample()`, of a mesh and its maps; normals are computed, or given
template <typename Estimate>
Use on_mesh(const Estimate& estimate, bool normals_are_given)
{
  return per_sample(
      [&](const std::size_t n) -> std::function<void()>
      {
        const auto s = surface(n);
        auto mesh = std::make_shared<Surface_mesh>(test_support::build_mesh<Surface_mesh>(s));
        const auto result = mesh->add_property_map<Surface_mesh::Vertex_index, Curvatures>("v:k").first;
        const auto normals = mesh->add_property_map<Surface_mesh::Vertex_index, Vector_3>("v:n").first;
        for(const auto v : mesh->vertices())
        {
          const auto& normal = s.exact[std::size_t(v)].normal;
          put(normals, v, Vector_3(normal[0], normal[1], normal[2]));
        }
        return [=]
        {
          const auto np = sp::vertex_principal_curvatures_and_directions_map(result);
          BOOST_TEST((normals_are_given ? estimate(*mesh, np.vertex_normal_map(normals))
                                        : estimate(*mesh, np)) == 0u);
        };
      });
}

using Item = std::tuple<Point_3, Vector_3, Curvatures>;
using Point_map = CGAL::Nth_of_tuple_property_map<0, Item>;
using Normal_map = CGAL::Nth_of_tuple_property_map<1, Item>;
using Result_map = CGAL::Nth_of_tuple_property_map<2, Item>;

template <typename Estimate>
Use on_points(const Estimate& estimate)
{
  return per_sample(
      [&](const std::size_t n) -> std::function<void()>
      {
        const auto s = surface(n);
        auto points = std::make_shared<std::vector<Item>>(s.points.size());
        for(std::size_t i = 0; i < s.points.size(); ++i)
        {
          const auto &p = s.points[i], &normal = s.exact[i].normal;
          (*points)[i] = {Point_3(p[0], p[1], p[2]), Vector_3(normal[0], normal[1], normal[2]), Curvatures()};
        }
        return [=]
        {
          BOOST_TEST(estimate(*points, sp::point_map(Point_map())
                                           .normal_map(Normal_map())
                                           .principal_curvatures_and_directions_map(Result_map())) == 0u);
        };
      });
}

void check(const std::string& name, const Use& use, bool allocates_for_each = false)
{
  BOOST_TEST_MESSAGE("  " << name << ": " << use.bytes << " bytes a sample, " << use.allocations
                          << " allocations");
  BOOST_TEST(use.bytes <= 200., name << " takes " << use.bytes << " bytes a sample");
  if(!allocates_for_each)
    BOOST_TEST(use.allocations == 0u, name << " allocates " << use.allocations << " times a sample");
}

using Tag = CGAL::Sequential_tag;

} // namespace

BOOST_AUTO_TEST_CASE(the_count_is_right)
{
  const Use use = use_of(
      []
      {
        const std::vector<char> first(100000), second(50000);
        BOOST_TEST(first.size() + second.size() == 150000u);
      });
  BOOST_TEST(use.bytes >= 150000.);
  BOOST_TEST(use.bytes < 160000.);
}

BOOST_AUTO_TEST_CASE(triangles)
{
  for(const bool given : {false, true})
  {
    const std::string normals = given ? ", normals given" : ", normals computed";
    check("rusinkiewicz_curvatures" + normals,
          on_mesh([](const auto& mesh, const auto& np) { return SC::rusinkiewicz_curvatures<Tag>(mesh, np); },
                  given));
    check("tangent_space_curvatures" + normals,
          on_mesh([](const auto& mesh, const auto& np)
                  { return SC::tangent_space_curvatures<Tag>(mesh, np); },
                  given));
  }
}

// CGAL's fit allocates its matrices.
BOOST_AUTO_TEST_CASE(jets)
{
  check("jet_fitting_curvatures",
        on_mesh([](const auto& mesh, const auto& np)
                { return SC::jet_fitting_curvatures<Tag>(mesh, np.degree_fitting(2)); },
                false),
        true);
  check("jet_fitting_curvatures of points",
        on_points([](auto& points, const auto& np)
                  { return SC::jet_fitting_curvatures<Tag>(points, np.degree_fitting(2)); }),
        true);
}

BOOST_AUTO_TEST_CASE(hermite_rbf)
{
  for(const bool given : {false, true})
    check(std::string("hrbf_curvatures") + (given ? ", exact normals" : ""),
          on_mesh([given](const auto& mesh, const auto& np)
                  { return SC::hrbf_curvatures<Tag>(mesh, np.normals_are_exact(given)); },
                  given));
  for(const bool exact : {false, true})
    check(std::string("hrbf_curvatures of points") + (exact ? ", exact normals" : ""),
          on_points([exact](auto& points, const auto& np)
                    { return SC::hrbf_curvatures<Tag>(points, np.normals_are_exact(exact)); }));
}

BOOST_AUTO_TEST_SUITE_END()
