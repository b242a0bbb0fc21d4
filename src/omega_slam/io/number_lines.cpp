#include "omega_slam/io/number_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::io {
namespace {

std::size_t countWords(const std::string& text) {
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string word; stream >> word;) {
    ++count;
  }
  return count;
}

/// @return an empty string, or what is wrong
std::string parse(const std::string& row, std::size_t count, std::vector<double>& values) {
  std::istringstream fields(row);
  fields.imbue(std::locale::classic());
  double value = 0.0;
  while (fields >> value) {
    if (!std::isfinite(value)) {
      return "a number is not finite";
    }
    values.push_back(value);
  }
  fields.clear();
  if (std::string word; fields >> word) {
    return fmt::format("'{}' is not a finite number", word);
  }
  if (values.size() != count) {
    return fmt::format("{} numbers where {} are expected", values.size(), count);
  }
  return {};
}

}  // namespace

std::vector<NumberLine> readNumberLines(const std::filesystem::path& path,
                                        const std::string& columns) {
  const std::size_t count = countWords(columns);
  std::istringstream text(grid::readFile(path));
  std::vector<NumberLine> lines;
  std::string row;
  for (int number = 1; std::getline(text, row); ++number) {
    row.erase(std::min(row.find('#'), row.size()));
    if (row.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    NumberLine line{number, {}};
    if (const std::string why = parse(row, count, line.values); !why.empty()) {
      throw std::runtime_error(fmt::format("{}:{}: {} ({}).", path.string(), number, why, columns));
    }
    lines.push_back(std::move(line));
  }
  if (lines.empty()) {
    throw std::runtime_error(fmt::format("{}: no line of numbers is in it.", path.string()));
  }
  return lines;
}

}  // namespace omega_slam::io
