#include "Calibration_row.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace adaptive {
namespace {

static_assert(std::is_trivially_copyable_v<Vertex_record>);

template <typename T>
void write(std::ostream& out, const T* first, std::size_t count)
{
  out.write(reinterpret_cast<const char*>(first), std::streamsize(count * sizeof(T)));
}

template <typename T>
void read(std::istream& in, T* first, std::size_t count)
{
  if(!in.read(reinterpret_cast<char*>(first), std::streamsize(count * sizeof(T))))
    throw std::runtime_error("the file of rows ends within one");
}

bool has_estimate(const Vertex_record& vertex)
{
  return std::any_of(vertex.errors.begin(), vertex.errors.end(),
                     [](const Vertex_record::Error& error) { return std::isfinite(error.k_max); });
}

// what the file must begin with
constexpr std::uint64_t heading = number_of_statistics * 1000 + number_of_candidates;

} // namespace

Calibration_row calibration_row(const Row& row, std::size_t at_most)
{
  Calibration_row result;
  result.group = row.shape;
  const std::size_t step = (std::max)(row.vertices.size() / at_most, std::size_t(1));
  for(std::size_t k = 0; k < row.vertices.size(); k += step)
    if(has_estimate(row.vertices[k]))
      result.vertices.push_back(row.vertices[k]);
  result.best_error = std::numeric_limits<double>::infinity();
  for(std::size_t c = 0; c < number_of_candidates; ++c)
    result.best_error = (std::min)(result.best_error, mean_error(result.vertices, c));
  return result;
}

void write_rows(const std::string& file, const std::vector<Calibration_row>& rows)
{
  std::ofstream out(file, std::ios::binary);
  write(out, &heading, 1);
  for(const Calibration_row& row : rows)
  {
    const std::uint64_t sizes[] = {row.group.size(), row.vertices.size()};
    write(out, sizes, 2);
    write(out, row.group.data(), row.group.size());
    write(out, &row.best_error, 1);
    write(out, row.vertices.data(), row.vertices.size());
  }
  if(!out.flush())
    throw std::runtime_error("cannot write " + file);
}

std::vector<Calibration_row> read_rows(const std::string& file)
{
  std::vector<Calibration_row> rows;
  std::ifstream in(file, std::ios::binary);
  if(!in)
    return rows;
  std::uint64_t first = 0;
  read(in, &first, 1);
  if(first != heading)
    throw std::runtime_error(file + " has rows of other statistics or candidates");
  while(in.peek() != std::ifstream::traits_type::eof())
  {
    std::uint64_t sizes[2];
    read(in, sizes, 2);
    Calibration_row row;
    row.group.resize(sizes[0]);
    row.vertices.resize(sizes[1]);
    read(in, &row.group[0], row.group.size());
    read(in, &row.best_error, 1);
    read(in, row.vertices.data(), row.vertices.size());
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace adaptive
