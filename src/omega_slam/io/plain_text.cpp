#include "omega_slam/io/plain_text.h"

#include <locale.h>
#include <stdlib.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace omega_slam::io {
namespace {

bool isBlank(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }

/// Powers of ten that are doubles.
constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kMostPower = 22;
constexpr int kMostDigits = 15;        // of a whole number that surely is a double
constexpr int kMostExponent = 100000;  // far beyond all doubles

/// A number as it is written: digits * 10^exponent.
struct Written {
  bool is_number{false};
  bool is_negative{false};
  std::uint64_t digits{0};  ///< the first kMostDigits at least, without zeros in front
  int count{0};             ///< of the digits
  int exponent{0};
};

/// Takes digits from the front. @return how many
int takeDigits(std::string_view& rest, Written& number) {
  int taken = 0;
  for (; !rest.empty() && isDigit(rest.front()); rest.remove_prefix(1), ++taken) {
    if (number.count > 0 || rest.front() != '0') {
      ++number.count;
    }
    if (number.count <= kMostDigits) {
      number.digits = 10 * number.digits + static_cast<std::uint64_t>(rest.front() - '0');
    }
  }
  return taken;
}

bool takeSign(std::string_view& rest) {
  const bool is_negative = !rest.empty() && rest.front() == '-';
  if (is_negative || (!rest.empty() && rest.front() == '+')) {
    rest.remove_prefix(1);
  }
  return is_negative;
}

/// Takes what is behind an "e". @return whether it is a whole number
bool takeExponent(std::string_view& rest, int& exponent) {
  const bool is_negative = takeSign(rest);
  int size = 0;
  bool any = false;
  for (; !rest.empty() && isDigit(rest.front()); rest.remove_prefix(1), any = true) {
    size = std::min(10 * size + (rest.front() - '0'), kMostExponent);
  }
  exponent += is_negative ? -size : size;
  return any;
}

Written read(std::string_view word) {
  Written number;
  number.is_negative = takeSign(word);
  int digits = takeDigits(word, number);
  if (!word.empty() && word.front() == '.') {
    word.remove_prefix(1);
    const int behind = takeDigits(word, number);
    number.exponent = -behind;
    digits += behind;
  }
  number.is_number = digits > 0;
  if (!word.empty() && (word.front() == 'e' || word.front() == 'E')) {
    word.remove_prefix(1);
    number.is_number = takeExponent(word, number.exponent) && number.is_number;
  }
  number.is_number = number.is_number && word.empty();
  return number;
}

double parseByLibrary(std::string_view word) {
  static const locale_t locale = ::newlocale(LC_ALL_MASK, "C", static_cast<locale_t>(nullptr));
  return ::strtod_l(std::string(word).c_str(), nullptr, locale);
}

}  // namespace

std::string_view takeWord(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && isBlank(rest[begin])) {
    ++begin;
  }
  std::size_t end = begin;
  while (end < rest.size() && !isBlank(rest[end])) {
    ++end;
  }
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

/// Clinger 1990, "How to read floating point numbers accurately" (PLDI): where digits and power of
/// ten are doubles, their product or quotient is rounded once, and so is the nearest double.
double parseDecimal(std::string_view word) {
  const Written number = read(word);
  if (!number.is_number) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (number.count > kMostDigits || number.exponent > kMostPower || number.exponent < -kMostPower) {
    return parseByLibrary(word);
  }
  const auto digits = static_cast<double>(number.digits);
  const double size = number.exponent < 0
                          ? digits / kPowers[static_cast<std::size_t>(-number.exponent)]
                          : digits * kPowers[static_cast<std::size_t>(number.exponent)];
  return number.is_negative ? -size : size;
}

}  // namespace omega_slam::io
