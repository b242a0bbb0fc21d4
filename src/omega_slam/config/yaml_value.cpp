#include "omega_slam/config/yaml_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <regex>

#include "omega_slam/io/plain_text.h"

namespace omega_slam::config {
namespace {

constexpr double kLongInteger = 1e9;         // from which on an exponent is easier to read
constexpr std::size_t kLongestQuote = 60;    // letters of a text that a message repeats
constexpr std::size_t kLongestNumber = 200;  // letters; std::regex recurses once for each

bool isOneOf(const std::string& text, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool isTrue(const std::string& text) {
  return isOneOf(text, {"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON"});
}

bool isFalse(const std::string& text) {
  return isOneOf(text, {"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF"});
}

bool isInfinite(const std::string& text) {
  return isOneOf(text,
                 {".inf", ".Inf", ".INF", "+.inf", "+.Inf", "+.INF", "-.inf", "-.Inf", "-.INF"});
}

bool isNan(const std::string& text) { return isOneOf(text, {".nan", ".NaN", ".NAN"}); }

ValueKind kindOfPlain(const std::string& text) {
  if (text.empty() || isOneOf(text, {"~", "null", "Null", "NULL"})) {
    return ValueKind::kEmpty;
  }
  if (isTrue(text) || isFalse(text)) {
    return ValueKind::kBool;
  }
  if (isInfinite(text) || isNan(text)) {
    return ValueKind::kReal;
  }
  if (text.size() > kLongestNumber) {
    return ValueKind::kText;
  }
  const std::regex integer("[-+]?(0|[1-9][0-9]*)");
  const std::regex real("([-+]?[0-9]+\\.[0-9]*|\\.[0-9]+)([eE][-+][0-9]+)?");
  const std::regex foreign("[-+]?(0[0-7_]+|0b[01_]+|0x[0-9a-fA-F_]+|[0-9][0-9_.:]*[_:][0-9_.:]*)");
  if (std::regex_match(text, integer)) {
    return ValueKind::kInteger;
  }
  if (std::regex_match(text, real)) {
    return ValueKind::kReal;
  }
  return std::regex_match(text, foreign) ? ValueKind::kForeign : ValueKind::kText;
}

/// Looks like a number to a person, but YAML 1.1 takes it for text.
bool isAlmostNumber(const std::string& text) {
  return text.size() <= kLongestNumber &&
         std::regex_match(text, std::regex("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?"));
}

std::string quoted(const std::string& text) {
  std::string shown;
  for (const char letter : text.substr(0, kLongestQuote)) {
    const bool control = static_cast<unsigned char>(letter) < 0x20;
    shown += control ? ' ' : letter;
  }
  return '"' + shown + (text.size() > kLongestQuote ? "..." : "") + '"';
}

/// C++ writes 1e-06 where YAML 1.1 wants 1.0e-6.
std::string withYamlExponent(const std::string& text) {
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) {
    return text;
  }
  const std::string mantissa = text.substr(0, exponent);
  const std::size_t digits = std::min(text.find_first_not_of('0', exponent + 2), text.size() - 1);
  return mantissa + (mantissa.find('.') == std::string::npos ? ".0" : "") +
         text.substr(exponent, 2) + text.substr(digits);
}

}  // namespace

ValueKind kindOf(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) {
    return ValueKind::kEmpty;
  }
  if (node.IsMap()) {
    return ValueKind::kMap;
  }
  if (node.IsSequence()) {
    return ValueKind::kList;
  }
  // yaml-cpp tags a plain scalar "?", a quoted one "!"; one made by a program has no tag.
  const std::string& tag = node.Tag();
  if (tag == "!" || tag == "tag:yaml.org,2002:str") {
    return ValueKind::kText;
  }
  return tag.empty() || tag == "?" ? kindOfPlain(node.Scalar()) : ValueKind::kForeign;
}

bool boolOf(const YAML::Node& node) { return isTrue(node.Scalar()); }

double numberOf(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  if (isNan(text)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (isInfinite(text)) {
    const double infinity = std::numeric_limits<double>::infinity();
    return text.front() == '-' ? -infinity : infinity;
  }
  return io::parseDecimal(text);
}

std::string describe(const YAML::Node& node) {
  switch (kindOf(node)) {
    case ValueKind::kEmpty:
      return "empty";
    case ValueKind::kBool:
      return boolOf(node) ? "true" : "false";
    case ValueKind::kInteger:
    case ValueKind::kReal:
      return node.Scalar();
    case ValueKind::kText:
      return "the text " + quoted(node.Scalar()) +
             (isAlmostNumber(node.Scalar())
                  ? " (a number is written without quotes, and as 1.0e-3 rather than 1e-3)"
                  : "");
    case ValueKind::kForeign:
      return quoted(node.Scalar()) + ", which not every reader of YAML takes for the same";
    case ValueKind::kList:
      return fmt::format("a list of {} value{}", node.size(), node.size() == 1 ? "" : "s");
    case ValueKind::kMap:
      return "a group of keys";
  }
  return "unknown";
}

std::string numberText(double value) {
  if (!std::isfinite(value)) {
    return std::isnan(value) ? ".nan" : value > 0.0 ? ".inf" : "-.inf";
  }
  if (std::trunc(value) == value && std::abs(value) < kLongInteger) {
    return fmt::format("{:.0f}", value);
  }
  for (const int digits : {6, 15, 16}) {
    const std::string text = fmt::format("{:.{}g}", value, digits);
    if (io::parseDecimal(text) == value) {
      return withYamlExponent(text);
    }
  }
  return withYamlExponent(fmt::format("{:.17g}", value));
}

}  // namespace omega_slam::config
