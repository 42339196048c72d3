#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_TABLE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_TABLE_H

#include <string>
#include <vector>

namespace screen_space {

/// What an experiment found: rows of texts and numbers, written as CSV with all digits and as Markdown with few.
class Table
{
public:
  struct Cell
  {
    Cell(const char* t) : text(t), is_number(false) {}
    Cell(std::string t) : text(std::move(t)), is_number(false) {}
    Cell(double n) : number(n) {}
    Cell(int n) : number(n) {}
    Cell(std::size_t n) : number(double(n)) {}

    std::string text;
    double number = 0.;
    bool is_number = true;
  };

  /// \param name that of the file, without its ending
  Table(std::string name, std::string title, std::vector<std::string> columns)
    : m_name(std::move(name)),
      m_title(std::move(title)),
      m_columns(std::move(columns))
  {}

  /// \throws std::invalid_argument if there are not as many cells as columns
  void add(std::vector<Cell> row);

  /// A line of text below the table in Markdown.
  void remark(std::string text) { m_remarks.push_back(std::move(text)); }

  const std::string& name() const { return m_name; }
  const std::string& title() const { return m_title; }
  const std::vector<std::vector<Cell>>& rows() const { return m_rows; }

  std::string csv() const;
  std::string markdown() const;

private:
  std::string m_name, m_title;
  std::vector<std::string> m_columns, m_remarks;
  std::vector<std::vector<Cell>> m_rows;
};

/// A number with `digits` significant ones, for people to read.
std::string readable(double number, int digits = 3);

/// The middle one of the finite numbers (the upper one of an even number); NaN if there is none.
double median(std::vector<double> numbers);

} // namespace screen_space

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_TABLE_H
