#include "omega_slam/config/yaml_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "omega_slam/config/parameter_reader.h"

namespace omega_slam::config {
namespace {

std::string readText(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw ConfigurationError(path + ": this is a folder, not a file.");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw ConfigurationError(fmt::format("{}: can't be read: {}.", path, std::strerror(errno)));
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<YAML::Node> parse(const std::string& path, const std::string& text) {
  try {
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(
        fmt::format("{}:{}: this is not YAML: {}.", path, error.mark.line + 1, error.msg));
  }
}

}  // namespace

YAML::Node loadYamlFile(const std::string& path) {
  const std::vector<YAML::Node> documents = parse(path, readText(path));
  if (documents.empty() || (documents.size() == 1 && documents.front().IsNull())) {
    throw ConfigurationError(path + ": the file is empty.");
  }
  if (documents.size() > 1) {
    throw ConfigurationError(
        fmt::format("{}: the file holds {} documents, separated by ---; one is expected.", path,
                    documents.size()));
  }
  return documents.front();
}

}  // namespace omega_slam::config
