#pragma once

#include <string>

namespace omega_slam::test {

/// What must hold whatever the text is: `graph::readGraph` gives a graph that is finite and in
/// itself consistent, and writing it as g2o, or as TORO where that can hold it, and reading it
/// again gives the same bits; or it throws a std::runtime_error, whose message is a printable line
/// of less than 300 characters that begins with the name of the file.
/// @return the first of these that is broken, with its place; empty if none is
[[nodiscard]] std::string brokenLawOfReading(const std::string& text);

}  // namespace omega_slam::test
