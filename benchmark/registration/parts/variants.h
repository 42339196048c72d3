#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_VARIANTS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_VARIANTS_H

#include "Trial.h"
#include "splits.h"

#include <cstddef>
#include <string>
#include <vector>

namespace registration {

/// A way to register two parts.
struct Variant
{
  std::string name, description;
};

const std::vector<Variant>& variants();

/// registers the parts, and compares what comes out with the truth
/// \throws std::invalid_argument if there is no such variant
Trial_result run_variant(const std::string& name, const Split& split, std::size_t neighbors);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_VARIANTS_H
