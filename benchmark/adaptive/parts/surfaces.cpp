#include "surfaces.h"

#include "Second_order_number.h"
#include "delaunay_triangles.h"
#include "dual_contouring.h"
#include "marching_cubes.h"
#include "tessellations.h"
#include "test_functions.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace adaptive {
namespace {

using benchmark_support::Edge_crossing;
using benchmark_support::Exact_curvature;
using benchmark_support::Triangle_arrays;
using benchmark_support::Vector;
using Function = std::function<Number(const Number&, const Number&, const Number&)>;

// tessellations that are tried in fewer conditions
const char* const stretched = "stretched grid";
const char* const dual = "dual contouring";

Number at(const Function& f, const Vector& p)
{
  return f(Number::coordinate(p.x, 0), Number::coordinate(p.y, 1), Number::coordinate(p.z, 2));
}

Exact_curvature exact_at(const Function& f, const Vector& p)
{
  const Number n = at(f, p);
  return exact_curvature(n.gradient, n.hessian);
}

/// z = f(x, y) over [-half, half]^2, by random points, a grid, or one whose triangles are long
void add_graph(std::vector<Surface>& list,
               const std::string& name,
               double half,
               double points,
               const std::function<Number(const Number&, const Number&)>& f)
{
  const Function level = [f](const Number& x, const Number& y, const Number& z) { return z - f(x, y); };
  const auto point = [f](double x, double y) { return Vector{x, y, f(Number(x), Number(y)).value}; };
  const auto exact = [level](const Vector& p) { return exact_at(level, p); };
  const auto count = std::size_t(points);
  list.push_back({name, "random",
                  [=](std::uint64_t seed)
                  {
                    benchmark_support::Random random(seed);
                    Triangle_arrays mesh;
                    for(std::size_t i = 0; i < count; ++i)
                    {
                      const double x = random.uniform(-half, half), y = random.uniform(-half, half);
                      mesh.points.push_back(point(x, y));
                    }
                    mesh.triangles = benchmark_support::delaunay_triangles(mesh.points);
                    return mesh;
                  },
                  exact});
  const auto add_grid = [&](const std::string& tessellation, double aspect)
  {
    list.push_back({name, tessellation,
                    [=](std::uint64_t)
                    {
                      return benchmark_support::grid(half, std::size_t(std::sqrt(points * aspect)),
                                                     std::size_t(std::sqrt(points / aspect)), point);
                    },
                    exact});
  };
  add_grid("grid", 1.);
  add_grid(stretched, double(2 + list.size() % 7));
}

/// F(x, y, z) = 0, outside where it is positive, by marching cubes; `tolerance`: of F, if the crossing is exact
void add_cubes(std::vector<Surface>& list,
               const std::string& name,
               const std::string& tessellation,
               double half,
               double samples,
               const Function& f,
               Edge_crossing crossing,
               double tolerance)
{
  list.push_back({name, tessellation,
                  [=](std::uint64_t)
                  {
                    return benchmark_support::marching_cubes(
                        [&](const Vector& p) { return f(p.x, p.y, p.z).value; }, {-half, -half, -half},
                        {half, half, half}, std::size_t(samples), crossing, tolerance);
                  },
                  [f](const Vector& p) { return exact_at(f, p); }});
}

/// by both variants of marching cubes, and by dual contouring
void add_level_set(std::vector<Surface>& list,
                   const std::string& name,
                   double half,
                   double samples,
                   const Function& f)
{
  constexpr double of_thesis = 1e-7;
  add_cubes(list, name, "exact cubes", half, samples, f, Edge_crossing::EXACT, of_thesis);
  add_cubes(list, name, "original cubes", half, samples, f, Edge_crossing::LINEAR, of_thesis);
  list.push_back({name, dual,
                  [=](std::uint64_t)
                  {
                    return benchmark_support::dual_contouring(
                        [&](const Vector& p) { return at(f, p).value; },
                        [&](const Vector& p) { return at(f, p).gradient; }, {-half, -half, -half},
                        {half, half, half}, std::size_t(samples));
                  },
                  [f](const Vector& p) { return exact_at(f, p); }});
}

bool is_dual(const Surface& surface)
{
  return surface.tessellation == dual;
}

bool is_stretched(const Surface& surface)
{
  return surface.tessellation == stretched;
}

/// with all digits
void add_shape(std::vector<Surface>& list,
               const std::string& name,
               double half,
               double samples,
               const Function& f)
{
  add_cubes(list, name, "", half, samples, f, Edge_crossing::EXACT, 0.);
}

Vector random_direction(benchmark_support::Random& random)
{
  Vector direction;
  for(std::size_t i = 0; i < 3; ++i)
    direction[i] = random.gaussian();
  return normalized(direction);
}

// a sum of waves in random directions; `shortest` is that of their lengths
class Random_waves
{
public:
  Random_waves(benchmark_support::Random& random, double shortest, double steepness)
  {
    constexpr int number = 5;
    for(int k = 0; k < number; ++k)
    {
      const double length = shortest * std::pow(4., random.uniform(0., 1.));
      const Vector direction = random_direction(random);
      m_waves.push_back({(2. * CGAL_PI / length) * direction, random.uniform(0., 2. * CGAL_PI),
                         steepness * length / (2. * CGAL_PI * std::sqrt(double(number)))});
    }
  }

  Number operator()(const Number& x, const Number& y, const Number& z) const
  {
    Number sum(0.);
    for(const Wave& wave : m_waves)
      sum = sum + wave.height * sin(wave.direction.x * x + wave.direction.y * y + wave.direction.z * z +
                                    Number(wave.phase));
    return sum;
  }

private:
  struct Wave
  {
    Vector direction;
    double phase, height;
  };
  std::vector<Wave> m_waves;
};

Vector random_vector(benchmark_support::Random& random, double half)
{
  Vector v;
  for(std::size_t i = 0; i < 3; ++i)
    v[i] = random.uniform(-half, half);
  return v;
}

// a sum of bells at random places
class Random_bells
{
public:
  // widths from `narrowest` to four times that; `steepness`: of one of them
  Random_bells(benchmark_support::Random& random, std::size_t number, double narrowest, double steepness)
  {
    for(std::size_t k = 0; k < number; ++k)
    {
      const double width = narrowest * std::pow(4., random.uniform(0., 1.));
      const double sign = random.uniform(-1., 1.) < 0. ? -1. : 1.;
      m_bells.push_back({random_vector(random, 1.), width, sign * steepness * width});
    }
  }

  Number operator()(const Number& x, const Number& y, const Number& z) const
  {
    Number sum(0.);
    for(const Bell& bell : m_bells)
      sum =
          sum + bell.height *
                    exp(-1. / (bell.width * bell.width) *
                        (square(x - bell.center.x) + square(y - bell.center.y) + square(z - bell.center.z)));
    return sum;
  }

private:
  struct Bell
  {
    Vector center;
    double width, height;
  };
  std::vector<Bell> m_bells;
};

// Many surfaces, each of which is tried in a few conditions: what is learned of them is to hold for others.
void add_random_surfaces(std::vector<Surface>& list, double n, double m)
{
  benchmark_support::Random random(17);
  const auto name = [](const char* kind, int k) { return std::string(kind) + " " + std::to_string(k); };
  // between two lengths, evenly in their logarithms
  const auto length = [&](double least, double largest)
  { return least * std::pow(largest / least, random.uniform(0., 1.)); };
  for(int k = 0; k < 20; ++k)
  {
    const Random_bells bells(random, std::size_t(6 + k), length(.07, .4), random.uniform(.3, 1.2));
    add_graph(list, name("knolls", k), 1., n,
              [bells](const Number& x, const Number& y) { return bells(x, y, Number(0.)); });
  }
  for(int k = 0; k < 20; ++k)
  {
    const double of_first = length(.22, 2.), of_second = length(.22, 2.), steepness = random.uniform(.2, 1.),
                 bend = random.uniform(-.3, .3), tilt = random.uniform(-.5, .5);
    const double a = 2. * CGAL_PI / of_first, b = 2. * CGAL_PI / of_second;
    add_graph(list, name("crossed waves", k), 1., n,
              [=](const Number& x, const Number& y)
              {
                return steepness / (a + b) * sin(a * (x + tilt * y)) * cos(b * (y - tilt * x) + Number(.4)) +
                       bend * x * x;
              });
  }
  for(int k = 0; k < 14; ++k)
  {
    const Random_waves waves(random, length(.13, 1.5), random.uniform(.2, .8));
    add_graph(list, name("lake", k), 1., n,
              [waves](const Number& x, const Number& y) { return waves(x, y, Number(0.)); });
  }
  for(int k = 0; k < 16; ++k)
  {
    const Random_waves waves(random, length(.35, 2.5), random.uniform(.1, .5));
    const Random_bells bells(random, 5, length(.25, .8), random.uniform(.1, .6));
    const double a = random.uniform(.7, 1.4), b = random.uniform(.7, 1.4);
    add_level_set(list, name("rock", k), 1.9, m,
                  [=](const Number& x, const Number& y, const Number& z) {
                    return sqrt(a * x * x + b * y * y + z * z) - 1.05 + .5 * waves(x, y, z) - bells(x, y, z);
                  });
  }
  for(int k = 0; k < 16; ++k)
  {
    const double a = length(1.2, 4.), b = length(1.2, 4.), c = length(1.2, 4.),
                 level = random.uniform(-.4, .4);
    const Vector shift = random_vector(random, 1.);
    add_level_set(list, name("lattice", k), 1., m,
                  [=](const Number& x, const Number& y, const Number& z)
                  {
                    return sin(a * x + Number(shift.x)) * cos(b * y) +
                           sin(b * y + Number(shift.y)) * cos(c * z) +
                           sin(c * z + Number(shift.z)) * cos(a * x) - Number(level);
                  });
  }
  for(int k = 0; k < 16; ++k)
  {
    const double a = random.uniform(.6, 1.6), b = random.uniform(.6, 1.6), c = random.uniform(.6, 1.6),
                 ab = random.uniform(0., 2.), bc = random.uniform(0., 2.), round = random.uniform(0., .8);
    const Vector tilt = random_vector(random, .25);
    add_level_set(list, name("soap", k), 1.6, m,
                  [=](const Number& x, const Number& y, const Number& z)
                  {
                    const Number xx = square(x + tilt.x * y), yy = square(y + tilt.y * z),
                                 zz = square(z + tilt.z * x);
                    return a * xx * xx + b * yy * yy + c * zz * zz + ab * xx * yy + bc * yy * zz +
                           round * (xx + yy + zz) - 1.;
                  });
  }
  for(int k = 0; k < 14; ++k)
  {
    const double radius = length(.2, .5), a = 2. * CGAL_PI / length(1., 4.),
                 b = 2. * CGAL_PI / length(1., 4.), wide = random.uniform(.1, .4),
                 high = random.uniform(0., .3);
    add_level_set(list, name("winding tube", k), 1., m,
                  [=](const Number& x, const Number& y, const Number& z)
                  {
                    return square(x + wide * sin(a * z)) + square(y + wide * cos(b * z)) -
                           square(radius + high * radius * sin(b * z + Number(1.)));
                  });
  }
  for(int k = 0; k < 14; ++k)
  {
    const Random_bells bells(random, std::size_t(4 + k), length(.2, .8), random.uniform(.05, .8));
    const Vector d = random_direction(random);
    add_level_set(list, name("moor", k), 1., m,
                  [=](const Number& x, const Number& y, const Number& z)
                  { return d.x * x + d.y * y + d.z * z + bells(x, y, z); });
  }
  // parts of rounded boxes: what marching cubes interpolate wrongly is nothing on their sides, and much beside them
  const auto rounded_box = [&](const bool is_sharp) -> Function
  {
    const double a = random.uniform(.8, 1.2), b = random.uniform(.8, 1.2);
    return [=](const Number& x, const Number& y, const Number& z)
    {
      const Number xx = square(x), yy = square(y), zz = square(z);
      return is_sharp ? a * xx * xx * xx + b * yy * yy * yy + zz * zz - 1.
                      : a * xx * xx + b * yy * yy + zz * zz - 1.;
    };
  };
  const auto add_part = [&](const std::string& of_box, const Function& box, double size, const Vector& middle)
  {
    add_level_set(list, of_box, 1., m,
                  [=](const Number& x, const Number& y, const Number& z) {
                    return box(1. / size * x + middle.x, 1. / size * y + middle.y, 1. / size * z + middle.z);
                  });
  };
  for(int k = 0; k < 14; ++k)
  {
    const double size = length(1.1, 2.4);
    Vector middle;
    for(std::size_t i = 0; i < 3; ++i)
      middle[i] = 1. - (1. - random.uniform(.1, .8)) / size;
    add_part(name("block", k), rounded_box(k % 3 == 2), size, middle);
  }
  for(int k = 0; k < 18; ++k)
  {
    const double size = length(1.5, 6.);
    const Function box = rounded_box(k % 3 == 2);
    const Vector direction = random_direction(random);
    double inside = 0., outside = 2.;
    for(int step = 0; step < 50; ++step)
    {
      const double between = .5 * (inside + outside);
      (at(box, between * direction).value < 0. ? inside : outside) = between;
    }
    add_part(name("side", k), box, size, inside * direction);
  }
}

std::vector<Surface> calibration(double scale)
{
  std::vector<Surface> list;
  const double n = 1250. * scale, m = std::round(24. * std::sqrt(scale));
  add_graph(list, "bell", 2., n, [](const Number& x, const Number& y) { return exp(-(x * x + y * y)); });
  add_graph(list, "waves", 2., n,
            [](const Number& x, const Number& y) { return .3 * sin(2. * x) * cos(1.5 * y) + .1 * x * y; });
  add_graph(list, "short waves", 1., n,
            [](const Number& x, const Number& y) { return .1 * sin(9. * x + 3. * y) + .08 * cos(11. * y); });
  add_graph(list, "coarse waves", 1., n,
            [](const Number& x, const Number& y)
            { return .05 * sin(24. * x + 5. * y) + .05 * cos(19. * y) + .02 * sin(15. * (x + y)); });
  add_graph(list, "steep waves", 1., n,
            [](const Number& x, const Number& y)
            { return .09 * sin(16. * x) + .07 * cos(14. * y - 4. * x); });
  add_graph(list, "ridge", 1., n,
            [](const Number& x, const Number& y) { return sqrt(.01 + x * x) + .3 * y * y; });
  add_graph(list, "hill", 2., n,
            [](const Number& x, const Number& y) { return inverse(1. + x * x + 2. * y * y); });
  add_graph(list, "meadow", 1., n,
            [](const Number& x, const Number& y)
            { return .2 * x * x - .1 * y * y + .05 * x * x * x + .1 * sin(x + y); });
  add_level_set(list, "gyroid", 1.8, m,
                [](const Number& x, const Number& y, const Number& z)
                { return sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x); });
  add_level_set(list, "metaballs", 2.2, m,
                [](const Number& x, const Number& y, const Number& z)
                {
                  const Number r = y * y + z * z;
                  return .5 - exp(-(square(x - .8) + r)) - exp(-(square(x + .8) + 1.5 * r));
                });
  add_level_set(list, "undulating cylinder", 1.1, m,
                [](const Number& x, const Number& y, const Number& z)
                { return x * x + y * y - square(1. + .3 * cos(3. * z)); });
  add_level_set(list, "Schwarz P", .9, m,
                [](const Number& x, const Number& y, const Number& z)
                { return cos(3. * x) + cos(3. * y) + cos(3. * z); });
  add_level_set(list, "dented sphere", 1.4, m,
                [](const Number& x, const Number& y, const Number& z)
                { return x * x + y * y + z * z - 1. - .2 * sin(5. * x + 3. * y) * cos(2. * z); });
  // surfaces that are sampled coarsely
  add_graph(list, "bumps", 1., n,
            [](const Number& x, const Number& y)
            { return .08 * sin(17. * x) * sin(15. * y) + .03 * cos(23. * (x - y)); });
  add_graph(list, "rough waves", 1., n,
            [](const Number& x, const Number& y)
            { return .03 * sin(31. * x + 7. * y) + .03 * cos(27. * y - 9. * x) + .02 * sin(24. * (x + y)); });
  add_graph(list, "furrows", 1., n,
            [](const Number& x, const Number& y) { return .1 * sin(14. * x + y) + .2 * y * y; });
  add_level_set(list, "knobbly ball", 1.4, m,
                [](const Number& x, const Number& y, const Number& z)
                { return x * x + y * y + z * z - 1. - .12 * sin(9. * x) * sin(8. * y + 1.) * cos(7. * z); });
  add_level_set(list, "cushion", 1.6, m,
                [](const Number& x, const Number& y, const Number& z)
                { return x * x * x * x + .5 * y * y + z * z + .2 * x * y * z - 1.; });
  // and such as nobody thought of
  benchmark_support::Random random(3);
  for(int k = 0; k < 10; ++k)
  {
    const double shortest = .15 * std::pow(10., k / 9.);
    const Random_waves waves(random, shortest, .3 + .1 * (k % 4));
    add_graph(list, "sea " + std::to_string(k), 1., n,
              [waves](const Number& x, const Number& y) { return waves(x, y, Number(0.)); });
  }
  for(int k = 0; k < 8; ++k)
  {
    const double shortest = .4 * std::pow(6., k / 7.);
    const Random_waves waves(random, shortest, .2 + .1 * (k % 4));
    const double a = random.uniform(.7, 1.4), b = random.uniform(.7, 1.4);
    add_level_set(list, "boulder " + std::to_string(k), 1.9, m,
                  [waves, a, b](const Number& x, const Number& y, const Number& z)
                  { return sqrt(a * x * x + b * y * y + z * z) - 1.05 + waves(x, y, z); });
  }
  // such as bend little from sample to sample
  for(int k = 0; k < 8; ++k)
  {
    const double shortest = std::pow(8., k / 7.);
    const Random_waves waves(random, shortest, .2 + .1 * (k % 4));
    const Vector d = random_direction(random);
    add_level_set(list, "plain " + std::to_string(k), 1., m,
                  [waves, d](const Number& x, const Number& y, const Number& z)
                  { return d.x * x + d.y * y + d.z * z + waves(x, y, z); });
  }
  // and rounded boxes: on their sides, what marching cubes interpolate wrongly varies slowly
  for(int k = 0; k < 10; ++k)
  {
    const double a = random.uniform(.7, 1.6), b = random.uniform(.7, 1.6), c = random.uniform(.7, 1.6),
                 twist = random.uniform(-.2, .2);
    add_level_set(list, "box " + std::to_string(k), 1.6, m,
                  [=](const Number& x, const Number& y, const Number& z)
                  {
                    const Number xx = square(x + twist * z), yy = square(y - twist * x), zz = square(z);
                    return k % 2 == 0 ? a * xx * xx + b * yy * yy + c * zz * zz - 1.
                                      : a * xx * xx + b * yy * yy * yy + c * zz - 1.;
                  });
  }
  // and balls that have flowed into one another: necks and holes
  for(int k = 0; k < 6; ++k)
  {
    struct Ball
    {
      Vector center;
      double width;
    };
    std::vector<Ball> balls(std::size_t(4 + k));
    for(Ball& ball : balls)
    {
      for(std::size_t i = 0; i < 3; ++i)
        ball.center[i] = random.uniform(-1., 1.);
      ball.width = random.uniform(.4, .7);
    }
    add_level_set(list, "blobs " + std::to_string(k), 2., m,
                  [balls](const Number& x, const Number& y, const Number& z)
                  {
                    Number sum(.5);
                    for(const Ball& ball : balls)
                      sum = sum - exp(-1. / (ball.width * ball.width) *
                                      (square(x - ball.center.x) + square(y - ball.center.y) +
                                       square(z - ball.center.z)));
                    return sum;
                  });
  }
  const std::size_t regular = list.size();
  add_random_surfaces(list, n, m);
  // the many are tried in a third of the conditions, and these two tessellations in half of those of the others
  for(std::size_t k = 0; k < list.size(); ++k)
    list[k].share = (k < regular ? 1. : 1. / 3.) * (is_dual(list[k]) || is_stretched(list[k]) ? .5 : 1.);
  // the last ones, so that the conditions of the others, which are random, are the same with or without them
  std::stable_partition(list.begin(), list.end(),
                        [](const Surface& surface) { return !is_stretched(surface); });
  return list;
}

std::vector<Surface> validation(double scale)
{
  std::vector<Surface> list;
  const double n = 5000. * scale, m = 45. * std::sqrt(scale);
  add_graph(list, "saddle with ridges", 1., n,
            [](const Number& x, const Number& y)
            { return .3 * x * x - .3 * y * y + .04 * sin(12. * x) + .02 * sin(17. * (x - y)); });
  add_graph(list, "monkey saddle", 1., n,
            [](const Number& x, const Number& y) { return .4 * (x * x * x - 3. * x * y * y); });
  add_graph(list, "ripples", 1., n,
            [](const Number& x, const Number& y) { return .06 * cos(25. * sqrt(.02 + x * x + y * y)); });
  add_level_set(list, "torus", 1.5, m,
                [](const Number& x, const Number& y, const Number& z)
                { return square(sqrt(x * x + y * y) - 1.) + z * z - .16; });
  add_level_set(list, "ellipsoid", 1.6, m,
                [](const Number& x, const Number& y, const Number& z)
                { return (1. / 2.25) * x * x + y * y + 3. * z * z - 1.; });
  add_level_set(list, "wavy sphere", 1.4, m,
                [](const Number& x, const Number& y, const Number& z)
                { return sqrt(x * x + y * y + z * z) - 1. - .08 * sin(6. * x) * sin(5. * y) * sin(4. * z); });
  add_level_set(list, "Goursat", 2.6, m,
                [](const Number& x, const Number& y, const Number& z)
                {
                  const Number a = x * x, b = y * y, c = z * z;
                  return a * a + b * b + c * c - 4. * (a + b + c) + 9.;
                });
  add_level_set(list, "blend", 1.8, m,
                [](const Number& x, const Number& y, const Number& z)
                {
                  const Number f = x * x + y * y - .25, g = x * x + z * z - .25;
                  return f * g - .15;
                });
  // these two bend little from sample to sample
  add_level_set(list, "vault", 1., m,
                [](const Number& x, const Number& y, const Number& z)
                { return square(.8 * y + .6 * z) + square(x - 1.6) * .3 + .1 * x * y - .9; });
  add_level_set(list, "pass", 1., m,
                [](const Number& x, const Number& y, const Number& z)
                { return .9 * z + .3 * x - .2 * y + .25 * x * x - .3 * y * y + .1 * x * y * z; });
  for(Surface& surface : list)
    surface.is_noise_added = !is_dual(surface) && !is_stretched(surface);
  return list;
}

std::vector<Surface> shapes(double scale)
{
  std::vector<Surface> list;
  const double m = 45. * std::sqrt(scale);
  add_shape(list, "sphere", 1.2, m,
            [](const Number& x, const Number& y, const Number& z) { return x * x + y * y + z * z - 1.; });
  add_shape(list, "cylinder", 1.2, m,
            [](const Number& x, const Number& y, const Number&) { return x * x + y * y - 1.; });
  add_shape(list, "cone", 1.2, m,
            [](const Number& x, const Number& y, const Number& z)
            { return x * x + y * y - .09 * square(z + 2.); });
  add_shape(list, "ellipsoid", 1.2, m,
            [](const Number& x, const Number& y, const Number& z)
            { return x * x + 2. * y * y + 3. * z * z - 1.; });
  add_shape(list, "torus", 1.5, m,
            [](const Number& x, const Number& y, const Number& z)
            { return square(sqrt(x * x + y * y) - 1.) + z * z - .16; });
  return list;
}

std::vector<Surface> tables(double scale)
{
  std::vector<Surface> list;
  const auto points = std::size_t(10000. * scale);
  const auto samples = std::size_t(128. * std::sqrt(scale));
  for(const bool is_random : {true, false})
    for(const benchmark_support::Explicit_function& f : benchmark_support::explicit_functions())
      list.push_back({f.name, is_random ? "random" : "grid",
                      [=](std::uint64_t seed)
                      {
                        return is_random ? random_tessellation(f, points, seed)
                                         : grid_tessellation(f, std::size_t(std::sqrt(double(points))));
                      },
                      [f](const Vector& p) { return f.exact(p.x, p.y); }, is_random});
  for(const bool is_exact : {true, false})
    for(const benchmark_support::Implicit_function& f : benchmark_support::implicit_functions())
      list.push_back({f.name, is_exact ? "exact cubes" : "original cubes",
                      [=](std::uint64_t) {
                        return marching_cubes_tessellation(
                            f, samples, is_exact ? Edge_crossing::EXACT : Edge_crossing::LINEAR);
                      },
                      [f](const Vector& p) { return f.exact(p); }, f.name == "f1i" && is_exact});
  for(const benchmark_support::Implicit_function& f : benchmark_support::implicit_functions())
    list.push_back({f.name, dual,
                    [=](std::uint64_t)
                    { return benchmark_support::dual_contouring_tessellation(f, samples); },
                    [f](const Vector& p) { return f.exact(p); }, false});
  return list;
}

} // namespace

std::vector<Surface> surfaces(Purpose purpose, double scale)
{
  switch(purpose)
  {
  case Purpose::CALIBRATION:
    return calibration(scale);
  case Purpose::TABLES:
    return tables(scale);
  case Purpose::SHAPES:
    return shapes(scale);
  case Purpose::VALIDATION:
    break;
  }
  return validation(scale);
}

} // namespace adaptive
