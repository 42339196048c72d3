#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BATCHED_HERMITE_RBF_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BATCHED_HERMITE_RBF_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Axis_scaling.h>
#include <Shape_characteristics/internal/Rounded_distance.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/log_of_sum.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/internal/Exact_fit_attempts.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_functions.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_output.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>
#include <Shape_characteristics/interpolation/internal/Sample_patches.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  Does what Local_hermite_rbf with a positive definite basis function does, sample by sample, but faster by an order of
  magnitude: some fits are solved side by side, and, if fits are shared, one fit serves the samples near its center as
  well.

  Samples come in patches, each a range of an order in which close samples are close. Fits are shared within a patch; so
  patches don't depend on each other. Without sharing, nothing depends on the patches.
*/
template <typename SampledSurface, typename RadialBasisFunction>
class Batched_hermite_rbf
{
  using Vector = Eigen::Vector3d;
  using Index = std::uint32_t;

  // a fit to be made
  struct Task
  {
    std::size_t first_point, number_of_points;  // in the workspace
    std::size_t first_served, number_of_served; // in the workspace; the center is the first
    Estimation_status status;
    double scale;
    Axis_scaling scaling; // as in Scaled_neighborhood
    double shape_parameter;
    Vector trend;
    Exact_fit_attempts exact;
    Noisy_fit_attempts noisy;
    std::size_t first_kept =
        0; // in the workspace: what the first attempt is at what is served, if it is doubted
  };

  struct Served
  {
    Index sample;
    Index point; // of the task's
  };

  // the fit whose center is nearest to a sample, of those that may serve it
  struct Nearest_center
  {
    double squared_distance; // in units of the neighborhood's size, rounded; negative if there is an answer
    Index task;
    Index point; // of the task's
  };

public:
  using Output = Hermite_fit_output;

  struct Options
  {
    bool normals_are_exact = false;
    bool exactness_is_checked = true; // see Local_hermite_rbf
    double noise_level = 1e-6;        // see Local_hermite_rbf
    double normal_noise_level = Noisy_fit_attempts::default_normal_noise_level;
    bool fits_are_shared = true;
    bool large_weights_are_refined = true;
    bool rings_are_evened_out = true; // see Scaled_neighborhood
  };

  class Workspace
  {
    friend class Batched_hermite_rbf;
    typename SampledSurface::Workspace m_surface;
    Scaled_neighborhood m_neighborhood;
    std::vector<Vector> m_points, m_normals; // of all tasks of a patch
    std::vector<Served> m_served;
    std::vector<Nearest_center> m_nearest; // for the samples of a patch
    std::vector<Task> m_tasks, m_next_tasks;
    std::vector<Index> m_rim;   // centers to be
    std::vector<Index> m_order; // tasks by size
    std::vector<Index> m_left;  // samples for which the fit of another was not good enough
    std::vector<double> m_kept; // of Hermite_evaluation
    Hermite_batch m_batch;
  };

  // `max_lanes`: fits side by side, at most
  Batched_hermite_rbf(const SampledSurface& surface,
                      const RadialBasisFunction& phi,
                      const Options& options,
                      std::size_t max_lanes = Hermite_batch::max_lanes)
    : m_surface(surface),
      m_phi(phi),
      m_unit_phi(unit_shape(phi)),
      m_options(options),
      m_functions(Hermite_batch_functions<RadialBasisFunction>::best(max_lanes))
  {
    // One ring ends where served samples are.
    const Neighborhood& neighborhood = surface.neighborhood();
    if(neighborhood.kind() == Neighborhood::Kind::RINGS && neighborhood.count() < 2)
      m_options.fits_are_shared = false;
  }

  /*
    Fits the samples of a patch and gives each fit to `output`. `is_served` is scratch memory, a number for
    each sample of the surface, zero before the call; other patches read and write other parts of it.
  */
  void operator()(const Sample_patches& patches,
                  std::size_t patch,
                  std::vector<unsigned char>& is_served,
                  Workspace& workspace,
                  const Output& output) const
  {
    const std::size_t begin = patches.begin(patch), end = patches.end(patch);
    workspace.m_points.clear();
    workspace.m_normals.clear();
    workspace.m_tasks.clear();
    workspace.m_kept.clear();
    workspace.m_nearest.assign(end - begin, {std::numeric_limits<double>::infinity(), 0, 0});
    // the entry of a sample that may be served; null if it belongs to another patch
    const auto nearest_to = [&](const Index j) -> Nearest_center*
    {
      if(!patches.is_between(j, begin, end) || m_surface.status(j) != Estimation_status::ESTIMATED)
        return nullptr;
      return &workspace.m_nearest[patches.place(j) - begin];
    };
    // Centers are best as far from each other as what they serve allows: the next one is the first that was found on the
    // rim of a neighborhood.
    std::vector<Index>& rim = workspace.m_rim;
    rim.clear();
    std::size_t next = 0;
    for(std::size_t k = begin; k < end; ++k)
      while(!is_served[patches.sample(k)])
      {
        while(next < rim.size() && is_served[rim[next]])
          ++next;
        const Index center = next < rim.size() ? rim[next] : patches.sample(k);
        is_served[center] = 1;
        Nearest_center& nearest = workspace.m_nearest[patches.place(center) - begin];
        nearest = {-1., 0, 0};
        if(add_task(center, workspace, workspace.m_tasks, output))
        {
          nearest = {0., Index(workspace.m_tasks.size() - 1), 0};
          if(m_options.fits_are_shared)
            offer_to_neighbors(nearest_to, is_served, workspace);
        }
      }
    assign(patches, begin, workspace);
    while(!workspace.m_tasks.empty())
      make_all(workspace, output);
  }

  /*
    The logarithm of the probability density of the data at each of `samples` and its nearest neighbors, for each of
    `noise_levels`, up to a constant for each sample; NaN where there is no fit. The levels of a sample are next to each
    other. The shape parameter is the usual one times any of `shape_factors`, which are equally probable.
  */
  std::vector<double> log_likelihoods(const std::vector<Index>& samples,
                                      const std::vector<double>& noise_levels,
                                      std::size_t number_of_neighbors,
                                      const std::vector<double>& shape_factors) const
  {
    Workspace workspace;
    const std::size_t shapes = shape_factors.size();
    std::vector<double> of_shape(samples.size() * noise_levels.size() * shapes,
                                 std::numeric_limits<double>::quiet_NaN());
    for(std::size_t k = 0; k < samples.size(); ++k)
    {
      Scaled_neighborhood& neighborhood = workspace.m_neighborhood;
      const Estimation_status status =
          m_options.rings_are_evened_out
              ? neighborhood.collect_evenly(m_surface, samples[k], workspace.m_surface, number_of_neighbors,
                                            number_of_neighbors, false, Scaled_neighborhood::crowd)
              : neighborhood.collect(m_surface, samples[k], workspace.m_surface, number_of_neighbors,
                                     number_of_neighbors);
      if(!is_estimated(status))
        continue;
      Task task = store(neighborhood, workspace);
      const double shape_parameter = task.shape_parameter;
      for(std::size_t level = 0; level < noise_levels.size(); ++level)
      {
        task.noisy = Noisy_fit_attempts(neighborhood, noise_levels[level], m_options.normal_noise_level);
        task.noisy.keep_trend_straight();
        for(std::size_t s = 0; s < shapes; ++s)
        {
          task.shape_parameter = shape_factors[s] * shape_parameter;
          // nothing is served: where the answer goes
          task.first_served = (k * noise_levels.size() + level) * shapes + s;
          workspace.m_tasks.push_back(task);
        }
      }
    }
    sort_by_size(workspace);
    Hermite_batch& batch = workspace.m_batch;
    const std::size_t lanes = m_functions.lanes;
    for(std::size_t first = 0; first < workspace.m_tasks.size(); first += lanes)
    {
      const std::size_t last = (std::min)(first + lanes, workspace.m_tasks.size());
      fill_batch(first, last, workspace);
      m_functions.assemble(batch, m_unit_phi);
      m_functions.solve(batch);
      for(std::size_t t = first; t < last; ++t)
        if(batch.is_positive_definite[t - first] != 0.)
        {
          // The density is that of values times the shape parameter.
          const Task& task = workspace.m_tasks[workspace.m_order[t]];
          of_shape[task.first_served] = batch.log_likelihood_of(t - first) +
                                        double(task.number_of_points) * std::log(task.shape_parameter);
        }
    }
    std::vector<double> result(samples.size() * noise_levels.size());
    for(std::size_t k = 0; k < result.size(); ++k)
    {
      const double* const first = of_shape.data() + k * shapes;
      result[k] = log_of_sum(first, first + shapes);
    }
    return result;
  }

private:
  // Samples that are served by the fit of another, as well as by one of their own: near its center, where the surface bends
  // little.
  struct Reach
  {
    double distance; // in units of the neighborhood's size
    double rim;      // the next center is sought farther away
    double cosine;   // of the angle between their normals
  };
  static constexpr Reach s_exact_reach = {1., 1.6, 0.94}, s_noisy_reach = {0.75, 1.25, 0.97};
  static constexpr double s_served_curvature = 2.; // largest there, in units of the inverse size
  // Of exact normals, only the direction is data, but at the center, where the gradient has length 1. Beside it, it has nearly that
  // length if the normals are those of a surface, and shrinks if they are not.
  static constexpr double s_served_length = 0.2;       // largest difference to 1
  static constexpr double s_imbalance = 0.5;           // largest distance of the centroid from the center
  static constexpr std::size_t s_smallest_shared = 12; // points of a neighborhood that may be shared

  // Rounding would be seen in such weights, in units of the neighborhood's size: when waves and polynomials were scaled, by 1e-9 of the
  // largest curvature on point sets, where neighbors are on one side more often, and at borders, and by some 1e-8 over rings elsewhere.
  // There, most fits to exact normals of random points have weights of 1e4 and more: to refine as many would take much longer.
  static constexpr double s_large_exact_weight = 2e3, s_large_noisy_weight = 5e4;
  static constexpr double s_large_exact_weight_of_rings = 2e5, s_large_noisy_weight_of_rings = 3e5;

  static RadialBasisFunction unit_shape(const RadialBasisFunction& phi)
  {
    if constexpr(RadialBasisFunction::has_shape_parameter)
      return phi.with_shape_parameter(1.);
    else
      return phi;
  }

  // The last task, that of the neighborhood in the workspace, may serve the samples near its center.
  template <typename Nearest_to>
  void offer_to_neighbors(const Nearest_to& nearest_to,
                          std::vector<unsigned char>& is_served,
                          Workspace& workspace) const
  {
    const Task& task = workspace.m_tasks.back();
    if(task.status != Estimation_status::ESTIMATED || task.number_of_points < s_smallest_shared)
      return;
    const Scaled_neighborhood& neighborhood = workspace.m_neighborhood;
    // Near a border, which point sets know nothing of, all the neighbors are on one side.
    Vector sum = Vector::Zero();
    for(const Vector& p : neighborhood.points)
      sum += p;
    if(sum.norm() > s_imbalance * double(neighborhood.points.size()))
      return;
    const auto number = Index(workspace.m_tasks.size() - 1);
    const Reach& reach = m_options.normals_are_exact ? s_exact_reach : s_noisy_reach;
    for(std::size_t n = 1; n < neighborhood.samples.size(); ++n)
    {
      const Index j = neighborhood.samples[n];
      Nearest_center* const nearest = nearest_to(j);
      if(nearest == nullptr)
        continue;
      const double squared_distance = neighborhood.points[n].squaredNorm();
      if(squared_distance < reach.distance * reach.distance &&
         neighborhood.normals[n].dot(neighborhood.normals[0]) > reach.cosine)
      {
        is_served[j] = 1;
        if(const double rounded = Rounded_distance(1.)(squared_distance); rounded < nearest->squared_distance)
          *nearest = {rounded, number, Index(n)};
      }
      else if(squared_distance > reach.rim * reach.rim && !is_served[j])
        workspace.m_rim.push_back(j);
    }
  }

  // Each sample that has a fit is served by that of the nearest center.
  static void assign(const Sample_patches& patches, std::size_t begin, Workspace& workspace)
  {
    std::vector<Task>& tasks = workspace.m_tasks;
    const auto has_task = [](const Nearest_center& nearest)
    { return nearest.squared_distance >= 0. && std::isfinite(nearest.squared_distance); };
    for(Task& task : tasks)
      task.number_of_served = 0;
    for(const Nearest_center& nearest : workspace.m_nearest)
      if(has_task(nearest))
        ++tasks[nearest.task].number_of_served;
    std::size_t first = 0;
    for(Task& task : tasks)
    {
      task.first_served = first;
      first += task.number_of_served;
      task.number_of_served = 1; // the center comes first
    }
    workspace.m_served.resize(first);
    for(std::size_t k = 0; k < workspace.m_nearest.size(); ++k)
      if(const Nearest_center& nearest = workspace.m_nearest[k]; has_task(nearest))
      {
        Task& task = tasks[nearest.task];
        workspace.m_served[task.first_served + (nearest.point == 0 ? 0 : task.number_of_served++)] = {
            patches.sample(begin + k), nearest.point};
      }
  }

  // Whether there is a task: else the answer has been given. What it serves is for the caller to say.
  bool add_task(Index i, Workspace& workspace, std::vector<Task>& tasks, const Output& output) const
  {
    Scaled_neighborhood& neighborhood = workspace.m_neighborhood;
    const bool is_exact = m_options.normals_are_exact;
    const Estimation_status status = neighborhood.collect_evenly(
        m_surface, i, workspace.m_surface, largest_neighborhood(m_surface.neighborhood(), is_exact),
        desired_neighborhood(m_surface, i, is_exact), is_exact);
    if(!is_estimated(status))
    {
      output.surface(i, failure(status));
      return false;
    }
    if(is_exact && contradicts_others(neighborhood.normals))
    {
      output.surface(i, failure(Estimation_status::DEGENERATE));
      return false;
    }
    Task task = store(neighborhood, workspace);
    task.status = status;
    if(is_exact)
      task.exact = Exact_fit_attempts(neighborhood);
    else
      task.noisy = Noisy_fit_attempts(neighborhood, m_options.noise_level, m_options.normal_noise_level);
    tasks.push_back(task);
    return true;
  }

  // a task for what was collected
  Task store(const Scaled_neighborhood& neighborhood, Workspace& workspace) const
  {
    Task task;
    task.first_point = workspace.m_points.size();
    task.number_of_points = neighborhood.points.size();
    task.scale = neighborhood.scale;
    task.scaling = neighborhood.scaling;
    task.shape_parameter = shape_parameter_of_fit(m_phi, task.number_of_points, m_options.normals_are_exact);
    task.trend =
        m_options.normals_are_exact ? neighborhood.normals[0] : trend_of_noisy_fit(neighborhood.normals);
    workspace.m_points.insert(workspace.m_points.end(), neighborhood.points.begin(),
                              neighborhood.points.end());
    workspace.m_normals.insert(workspace.m_normals.end(), neighborhood.normals.begin(),
                               neighborhood.normals.end());
    return task;
  }

  static Local_implicit_surface failure(Estimation_status status)
  {
    Local_implicit_surface result;
    result.status = status;
    return result;
  }

  // Makes all tasks, those with as many points together. What failed becomes the tasks of the next round.
  void make_all(Workspace& workspace, const Output& output) const
  {
    workspace.m_next_tasks.clear();
    workspace.m_left.clear();
    sort_by_size(workspace);
    const std::size_t lanes = m_functions.lanes;
    for(std::size_t first = 0; first < workspace.m_tasks.size(); first += lanes)
      make_batch(first, (std::min)(first + lanes, workspace.m_tasks.size()), workspace, output);

    for(const Index i : workspace.m_left)
      if(add_task(i, workspace, workspace.m_next_tasks, output))
      {
        Task& task = workspace.m_next_tasks.back();
        task.first_served = workspace.m_served.size();
        task.number_of_served = 1;
        workspace.m_served.push_back({i, 0});
      }
    std::swap(workspace.m_tasks, workspace.m_next_tasks);
  }

  // `m_order`: the largest tasks first; of those, the ones that serve most
  static void sort_by_size(Workspace& workspace)
  {
    const std::vector<Task>& tasks = workspace.m_tasks;
    workspace.m_order.resize(tasks.size());
    std::iota(workspace.m_order.begin(), workspace.m_order.end(), Index(0));
    std::sort(workspace.m_order.begin(), workspace.m_order.end(),
              [&](const Index a, const Index b)
              {
                const Task &t = tasks[a], &u = tasks[b];
                if(t.number_of_points != u.number_of_points)
                  return t.number_of_points > u.number_of_points;
                return t.number_of_served != u.number_of_served ? t.number_of_served > u.number_of_served
                                                                : a < b;
              });
  }

  // the task of a lane, if the batch is made of those from `m_order[first]` to `m_order[last - 1]`; lanes to spare
  // repeat the last one
  static const Task&
  task_of(std::size_t lane, std::size_t first, std::size_t last, const Workspace& workspace)
  {
    return workspace.m_tasks[workspace.m_order[(std::min)(first + lane, last - 1)]];
  }

  // sets up the tasks from `m_order[first]`, the largest, to `m_order[last - 1]` in a batch
  void fill_batch(std::size_t first, std::size_t last, Workspace& workspace) const
  {
    Hermite_batch& batch = workspace.m_batch;
    batch.clear(m_functions.lanes, task_of(0, first, last, workspace).number_of_points,
                m_options.normals_are_exact ? Hermite_equations::TANGENTS : Hermite_equations::GRADIENTS);
    for(std::size_t lane = 0; lane < m_functions.lanes; ++lane)
      fill_lane(task_of(lane, first, last, workspace), lane, workspace);
  }

  // data of a task, its points scaled by the shape parameter: values are so as well
  void fill_lane(const Task& task, std::size_t lane, Workspace& workspace) const
  {
    Hermite_batch& batch = workspace.m_batch;
    const double unit = task.shape_parameter;
    const Vector* const points = workspace.m_points.data() + task.first_point;
    const Vector* const normals = workspace.m_normals.data() + task.first_point;
    for(std::size_t k = 0; k < batch.centers(); ++k)
    {
      const std::size_t point = k < task.number_of_points ? k : 0;
      batch.set_vector(batch.points, 3 * k, lane, unit * points[point]);
      batch.set_vector(batch.normals, 3 * k, lane, normals[point]);
    }
    const bool is_exact = m_options.normals_are_exact;
    const double value_variance = is_exact ? task.exact.value_variance() : task.noisy.value_variance();
    batch.set_vector(batch.trend, 0, lane, task.trend);
    batch.set_count(lane, task.number_of_points);
    batch.set_scaling(lane, task.scaling);
    batch.set(batch.unit, 0, lane, unit);
    batch.set(batch.value_noise, 0, lane, unit * unit * value_variance);
    batch.set(batch.derivative_noise, 0, lane,
              is_exact ? task.exact.derivative_variance() : task.noisy.derivative_variance());
    batch.set(batch.bends, 0, lane, task.noisy.bends_trend() ? 1. : 0.);
  }

  // what becomes of a fit
  enum class Use
  {
    NONE, // there is another attempt
    ANSWER,
    KEEP,        // until other attempts tell whether it is the answer
    FIRST_ANSWER // that is what the first attempt was
  };
  using Uses = std::array<Use, Hermite_batch::max_lanes>;

  static bool is_evaluated(Use use) { return use == Use::ANSWER || use == Use::KEEP; }

  void make_batch(std::size_t first, std::size_t last, Workspace& workspace, const Output& output) const
  {
    Hermite_batch& batch = workspace.m_batch;
    fill_batch(first, last, workspace);
    m_functions.assemble(batch, m_unit_phi);
    m_functions.solve(batch);

    Uses uses{};
    std::size_t most_served = 0;
    for(std::size_t lane = 0; first + lane < last; ++lane)
    {
      Task& task = workspace.m_tasks[workspace.m_order[first + lane]];
      uses[lane] = use_of(task, lane, workspace);
      if(is_evaluated(uses[lane]))
        most_served = (std::max)(most_served, task.number_of_served);
    }
    refine(uses, first, last, workspace);
    for(std::size_t s = 0; s < most_served; ++s)
    {
      std::array<Vector, Hermite_batch::max_lanes> displacement;
      const auto set_where = [&](const std::size_t lane)
      {
        const Task& task = task_of(lane, first, last, workspace);
        Vector x = displacement[lane];
        if(s < task.number_of_served)
          x += workspace.m_points[task.first_point + workspace.m_served[task.first_served + s].point];
        batch.set_vector(batch.where, 0, lane, task.shape_parameter * x);
      };
      for(std::size_t lane = 0; lane < m_functions.lanes; ++lane)
      {
        displacement[lane].setZero();
        set_where(lane);
      }
      m_functions.evaluate(batch, m_unit_phi);
      if(!m_options.normals_are_exact)
      {
        std::array<bool, Hermite_batch::max_lanes> moves{};
        const auto step = [&](const std::size_t lane)
        {
          Hermite_jet jet = batch.evaluation_of(lane).jet();
          const Task& task = task_of(lane, first, last, workspace);
          jet.value /= task.shape_parameter;
          step_to_zero_set(jet, task.scaling, displacement[lane]);
        };
        for(std::size_t lane = 0; lane < m_functions.lanes; ++lane)
        {
          step(lane);
          moves[lane] = !is_negligible(displacement[lane]);
          if(moves[lane])
            set_where(lane);
        }
        if(std::find(moves.begin(), moves.end(), true) != moves.end())
        {
          m_functions.evaluate_value(batch, m_unit_phi);
          for(std::size_t lane = 0; lane < m_functions.lanes; ++lane)
            if(moves[lane])
            {
              step(lane);
              set_where(lane);
            }
          m_functions.evaluate(batch, m_unit_phi); // where nothing moved, with the same result
        }
      }
      for(std::size_t lane = 0; first + lane < last; ++lane)
        if(const Task& task = task_of(lane, first, last, workspace);
           s < task.number_of_served && is_evaluated(uses[lane]))
        {
          const Hermite_evaluation evaluation = batch.evaluation_of(lane);
          if(uses[lane] == Use::KEEP)
            for(std::size_t k = 0; k < Hermite_evaluation::size; ++k)
              kept_evaluation(task, s, workspace)[k] = evaluation[k];
          else
            answer(task, s, batch.is_positive_definite[lane] != 0., evaluation, displacement[lane], workspace,
                   output);
        }
    }
    for(std::size_t lane = 0; first + lane < last; ++lane)
      if(uses[lane] == Use::FIRST_ANSWER)
      {
        const Task& task = task_of(lane, first, last, workspace);
        for(std::size_t s = 0; s < task.number_of_served; ++s)
          answer(task, s, true, Hermite_evaluation(kept_evaluation(task, s, workspace), 1), Vector::Zero(),
                 workspace, output);
      }
  }

  // the solutions of those lanes in which rounding would be seen
  void refine(const Uses& uses, std::size_t first, std::size_t last, Workspace& workspace) const
  {
    Hermite_batch& batch = workspace.m_batch;
    bool is_any = false;
    for(std::size_t lane = 0; lane < m_functions.lanes; ++lane)
    {
      const bool is_refined =
          is_evaluated(uses[lane]) && has_large_weights(task_of(lane, first, last, workspace), batch, lane);
      batch.is_refined[lane] = is_refined ? 1. : 0.;
      is_any = is_any || is_refined;
    }
    if(is_any)
      m_functions.refine(batch, m_unit_phi);
  }

  bool has_large_weights(const Task& task, const Hermite_batch& batch, std::size_t lane) const
  {
    if(!m_options.large_weights_are_refined || batch.is_positive_definite[lane] == 0.)
      return false;
    const bool has_rings_around = m_surface.neighborhood().kind() == Neighborhood::Kind::RINGS &&
                                  task.status != Estimation_status::BORDER;
    const double large_exact = has_rings_around ? s_large_exact_weight_of_rings : s_large_exact_weight;
    const double large_noisy = has_rings_around ? s_large_noisy_weight_of_rings : s_large_noisy_weight;
    return task.shape_parameter * std::sqrt(batch.weight_square[lane]) >
           (m_options.normals_are_exact ? large_exact : large_noisy);
  }

  // If the normals may not be exact, there is another attempt, for all that the task serves.
  Use use_of(Task& task, std::size_t lane, Workspace& workspace) const
  {
    const Hermite_batch& batch = workspace.m_batch;
    if(!(m_options.normals_are_exact && m_options.exactness_is_checked) ||
       batch.is_positive_definite[lane] == 0.)
      return Use::ANSWER;
    Fit_evidence evidence{task.number_of_points, batch.residual[lane], batch.mahalanobis_square[lane], 0.};
    if(!task.exact.is_in_doubt(evidence))
      return Use::ANSWER;
    evidence.log_likelihood = batch.log_likelihood_of(lane);
    const bool is_first = !task.exact.is_doubted();
    if(!task.exact.next_if_inexact(evidence))
      return Use::ANSWER;
    if(task.exact.is_first_again())
      return Use::FIRST_ANSWER;
    if(is_first)
    {
      task.first_kept = workspace.m_kept.size();
      workspace.m_kept.resize(task.first_kept + task.number_of_served * Hermite_evaluation::size);
    }
    workspace.m_next_tasks.push_back(task);
    return is_first ? Use::KEEP : Use::NONE;
  }

  // what the first attempt is at the `s`-th sample that a task serves
  static double* kept_evaluation(const Task& task, std::size_t s, Workspace& workspace)
  {
    return workspace.m_kept.data() + task.first_kept + s * Hermite_evaluation::size;
  }

  // gives the answer of a fit for the `s`-th sample it serves, or sees to it that there is another attempt
  void answer(const Task& task,
              std::size_t s,
              bool is_solved,
              const Hermite_evaluation& evaluation,
              const Vector& displacement,
              Workspace& workspace,
              const Output& output) const
  {
    const Served served = workspace.m_served[task.first_served + s];
    const double unit = task.shape_parameter;
    const Vector gradient = evaluation.gradient();
    Fit_quality quality = evaluation.quality();
    quality.largest_curvature *= unit;
    bool is_surface = false, is_accepted = false;
    if(is_solved && std::isfinite(quality.gradient_length) && std::isfinite(quality.largest_curvature))
    {
      if(m_options.normals_are_exact)
        is_accepted = Exact_fit_attempts::is_surface(
            quality, gradient.dot(workspace.m_normals[task.first_point + served.point]));
      else
      {
        is_surface = Noisy_fit_attempts::is_surface(quality, displacement);
        is_accepted = is_surface && Noisy_fit_attempts::is_plausible(quality);
      }
    }
    if(s > 0 && !(is_accepted && may_serve(quality)))
    {
      workspace.m_left.push_back(served.sample);
      return;
    }
    if(!is_accepted)
    {
      Task again = task;
      again.number_of_served = 1;
      const bool go_on = m_options.normals_are_exact ? again.exact.next()
                         : is_solved                 ? again.noisy.next(is_surface)
                                                     : again.noisy.next_if_indefinite();
      if(go_on)
        workspace.m_next_tasks.push_back(again);
      else
        output.surface(served.sample, failure(Estimation_status::DEGENERATE));
      return;
    }

    const Estimation_status status = m_surface.status(served.sample);
    const double factor = unit / task.scale;
    if(output.curvatures)
    {
      output.curvatures(served.sample, status, evaluation.curvatures(factor));
      return;
    }
    Local_implicit_surface result;
    result.status = status;
    result.gradient = task.scaling(gradient);
    result.hessian = task.scaling(Eigen::Matrix3d(evaluation.jet().hessian * factor));
    result.displacement = task.scale * task.scaling.inverse()(displacement);
    output.surface(served.sample, result);
  }

  // of what a fit is at a sample beside its center
  bool may_serve(const Fit_quality& quality) const
  {
    return quality.largest_curvature < s_served_curvature &&
           (!m_options.normals_are_exact || std::abs(quality.gradient_length - 1.) < s_served_length);
  }

  const SampledSurface& m_surface;
  RadialBasisFunction m_phi, m_unit_phi;
  Options m_options;
  Hermite_batch_functions<RadialBasisFunction> m_functions;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BATCHED_HERMITE_RBF_H
