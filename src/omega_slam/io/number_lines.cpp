#include "omega_slam/io/number_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/io/plain_text.h"

namespace omega_slam::io {
namespace {

std::size_t countWords(std::string_view text) {
  std::size_t count = 0;
  while (!takeWord(text).empty()) {
    ++count;
  }
  return count;
}

/// @return an empty string, or what is wrong
std::string parse(std::string_view row, std::size_t count, std::vector<double>& values) {
  for (auto word = takeWord(row); !word.empty(); word = takeWord(row)) {
    values.push_back(parseDecimal(word));
    if (!std::isfinite(values.back())) {
      return fmt::format("'{}' is not a finite number", word);
    }
  }
  if (!values.empty() && values.size() != count) {
    return fmt::format("{} numbers where {} are expected", values.size(), count);
  }
  return {};
}

}  // namespace

std::vector<NumberLine> readNumberLines(const std::filesystem::path& path,
                                        const std::string& columns) {
  const std::size_t count = countWords(columns);
  const std::string text = grid::readFile(path);
  std::vector<NumberLine> lines;
  forEachLine(text, [&](std::size_t number, std::string_view row) {
    NumberLine line{static_cast<int>(number), {}};
    const std::string why = parse(row.substr(0, row.find('#')), count, line.values);
    if (!why.empty()) {
      throw std::runtime_error(fmt::format("{}:{}: {} ({}).", path.string(), number, why, columns));
    }
    if (!line.values.empty()) {
      lines.push_back(std::move(line));
    }
  });
  if (lines.empty()) {
    throw std::runtime_error(fmt::format("{}: no line of numbers is in it.", path.string()));
  }
  return lines;
}

}  // namespace omega_slam::io
