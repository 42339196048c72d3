#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_COMMAND_LINE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_COMMAND_LINE_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark_support {

/// The arguments of a benchmark: `--name value` for the options, `--name` for the flags it knows.
class Command_line
{
public:
  /// \throws std::invalid_argument for an unknown argument, or an option without a value
  Command_line(int argc,
               char** argv,
               const std::set<std::string>& options,
               const std::set<std::string>& flags)
  {
    for(int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      const std::string name = argument.rfind("--", 0) == 0 ? argument.substr(2) : "";
      if(flags.count(name) != 0)
        m_values[name] = "";
      else if(options.count(name) == 0)
        throw std::invalid_argument("unknown argument " + argument);
      else if(i + 1 == argc)
        throw std::invalid_argument(argument + " needs a value");
      else
        m_values[name] = argv[++i];
    }
  }

  bool has(const std::string& name) const { return m_values.count(name) != 0; }

  std::string text(const std::string& name, const std::string& otherwise) const
  {
    return has(name) ? m_values.at(name) : otherwise;
  }

  /// \throws std::invalid_argument if the value isn't a number, or is below `least`
  std::uint64_t number(const std::string& name, std::uint64_t otherwise, std::uint64_t least = 0) const
  {
    return has(name) ? parse(name, m_values.at(name), least) : otherwise;
  }

  /// the parts of a list separated by commas
  std::vector<std::string> list(const std::string& name, const std::string& otherwise) const
  {
    std::vector<std::string> parts;
    std::istringstream in(text(name, otherwise));
    for(std::string part; std::getline(in, part, ',');)
      if(!part.empty())
        parts.push_back(part);
    return parts;
  }

  std::vector<std::uint64_t> numbers(const std::string& name, const std::string& otherwise) const
  {
    std::vector<std::uint64_t> result;
    for(const std::string& part : list(name, otherwise))
      result.push_back(parse(name, part, 0));
    return result;
  }

private:
  static std::uint64_t parse(const std::string& name, const std::string& value, std::uint64_t least)
  {
    std::size_t used = 0;
    std::uint64_t result = 0;
    try
    {
      if(value.find('-') == std::string::npos)
        result = std::stoull(value, &used);
    }
    catch(const std::exception&)
    {
      used = 0;
    }
    if(used == 0 || used != value.size() || result < least)
      throw std::invalid_argument("--" + name + ": not a number of at least " + std::to_string(least) + ": " +
                                  value);
    return result;
  }

  std::map<std::string, std::string> m_values;
};

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_COMMAND_LINE_H
