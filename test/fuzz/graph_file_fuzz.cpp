// A fuzz target: whatever the text, the readers of pose graphs give a good graph, which survives
// being written and read again, or a complaint that a person can read.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "omega_slam/graph/graph_file.h"
#include "support/graph_file_laws.h"

namespace {

void fail(const std::string& what) {
  static_cast<void>(std::fprintf(stderr, "BROKEN LAW: %s\n", what.c_str()));
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  if (const std::string broken = omega_slam::test::brokenLawOfReading(text); !broken.empty()) {
    fail(broken);
  }
  return 0;
}
