#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_TRIAL_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_TRIAL_H

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace registration {

/// What a trial is: with the seed of its protocol all of it follows from this.
struct Trial_id
{
  std::string surface;      ///< mesh or cloud
  std::string protocol;     ///< how the parts are made
  std::string variant;      ///< what is tried
  std::size_t neighbors;    ///< average number of points in a neighborhood
  std::size_t head, number; ///< of the head, and of the split of this head

  auto key() const { return std::tie(surface, protocol, variant, neighbors, head, number); }
  friend bool operator<(const Trial_id& a, const Trial_id& b) { return a.key() < b.key(); }
};

/// What came out.
struct Trial_result
{
  double error = 0.;                            ///< see registration_error()
  double overlap = 0.;                          ///< of the split
  double mirrored = 0.;                         ///< share of mirrored correspondences among the final inliers
  double agreement = 0.;                        ///< see Shape_characteristics::Registration_quality
  double near = 0.;                             ///< likewise: overlap
  double expected = 0.;                         ///< likewise: expected agreement
  double correlation = 0.;                      ///< likewise: of curvatures
  std::string verdict = "-";                    ///< Registration_verdict, of variants that have one
  double describe = 0., match = 0., solve = 0.; ///< seconds

  double seconds() const { return describe + match + solve; }
  bool is_correct() const { return error < .1; }
};

/// The trials done so far. Each is appended to a file as it ends, and read from it the next time, unless the name of the file
/// is empty.
class Trials
{
public:
  explicit Trials(const std::string& file);

  bool contains(const Trial_id& id) const { return m_results.count(id) != 0; }
  void add(const Trial_id& id, const Trial_result& result);
  const std::map<Trial_id, Trial_result>& results() const { return m_results; }

private:
  std::string m_file;
  std::map<Trial_id, Trial_result> m_results;
};

/// How often something happened, and between which shares the truth is likely to lie (Wilson's interval, 95 %).
struct Share
{
  std::size_t hits = 0, trials = 0;

  double value() const { return trials == 0 ? 0. : double(hits) / double(trials); }
  double lower() const { return bound(-1.); }
  double upper() const { return bound(1.); }
  /// "97 % (94-99)"
  std::string text() const;

private:
  double bound(double side) const;
};

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_TRIAL_H
