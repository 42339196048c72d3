#include "Table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace screen_space {

void Table::add(std::vector<Cell> row)
{
  if(row.size() != m_columns.size())
    throw std::invalid_argument("Table: " + m_name + " has " + std::to_string(m_columns.size()) + " columns");
  m_rows.push_back(std::move(row));
}

std::string Table::csv() const
{
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  for(std::size_t c = 0; c < m_columns.size(); ++c)
    out << (c ? "," : "") << m_columns[c];
  out << '\n';
  for(const std::vector<Cell>& row : m_rows)
    for(std::size_t c = 0; c < row.size(); ++c)
    {
      out << (c ? "," : "");
      if(row[c].is_number)
        out << row[c].number;
      else if(row[c].text.find_first_of(",\"") == std::string::npos)
        out << row[c].text;
      else
        out << std::quoted(row[c].text, '"', '"');
      out << (c + 1 == row.size() ? "\n" : "");
    }
  return out.str();
}

std::string Table::markdown() const
{
  std::ostringstream out;
  out << "## " << m_title << "\n\n|";
  for(const std::string& column : m_columns)
    out << ' ' << column << " |";
  out << "\n|";
  for(std::size_t c = 0; c < m_columns.size(); ++c)
    out << (!m_rows.empty() && m_rows[0][c].is_number ? "---:|" : "---|");
  out << '\n';
  for(const std::vector<Cell>& row : m_rows)
  {
    out << '|';
    for(const Cell& cell : row)
      out << ' ' << (cell.is_number ? readable(cell.number) : cell.text) << " |";
    out << '\n';
  }
  for(const std::string& remark : m_remarks)
    out << '\n' << remark << '\n';
  out << '\n';
  return out.str();
}

std::string readable(double number, int digits)
{
  if(!std::isfinite(number))
    return "–";
  std::ostringstream out;
  if(number != 0. && (std::abs(number) < 1e-3 || std::abs(number) >= 1e7))
    out << std::scientific << std::setprecision(digits - 1) << number;
  else if(std::abs(number) >= std::pow(10., digits - 1))
    out << std::fixed << std::setprecision(0) << number;
  else
    out << std::setprecision(digits) << number;
  return out.str();
}

double median(std::vector<double> numbers)
{
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); }),
                numbers.end());
  if(numbers.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle = numbers.begin() + std::ptrdiff_t(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

} // namespace screen_space
