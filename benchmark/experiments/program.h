#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>

namespace omega_slam::experiments {

/// The whole life of an experiment program: reads its command line into what `app` was told of,
/// then calls `run()`. Whatever that throws ends the program with a sentence on stderr.
///
/// @return the process's exit code: 0, 1 where run() has thrown, or CLI11's for the command line
template <typename Run>
int runProgram(CLI::App& app, int argc, char** argv, const Run& run) {
  CLI11_PARSE(app, argc, argv);
  try {
    run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", std::filesystem::path(argv[0]).filename().string(),
               error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace omega_slam::experiments
