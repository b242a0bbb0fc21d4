#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace omega_slam::io {

/// Calls `visit(number of the line, counted from 1; the line without its end)` for each.
template <typename Visitor>
void forEachLine(std::string_view text, Visitor&& visit) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    visit(number, text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
}

/// Takes the next word from the front of a line: what stands between blanks, tabs and the like.
/// @return empty where there is none left
[[nodiscard]] std::string_view takeWord(std::string_view& rest);

/// The double nearest to a number in decimal notation, as "-12.5e3", with a point in every locale.
/// Infinite if it is too large for a double.
/// @return NaN for all that is no such number: words, hexadecimal numbers, "inf"
[[nodiscard]] double parseDecimal(std::string_view word);

}  // namespace omega_slam::io
