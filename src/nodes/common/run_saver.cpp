#include "nodes/common/run_saver.h"

#include <omega_slam/SaveGraph.h>
#include <omega_slam/SaveMap.h>
#include <ros/ros.h>

#include <chrono>
#include <filesystem>
#include <utility>

#include "nodes/common/names.h"

namespace omega_slam {
namespace {

/// Calls a service that saves to a path. @return a sentence
template <class Service>
std::string call(ros::NodeHandle& nh, const std::string& name, const std::filesystem::path& path) {
  Service service;
  service.request.path = path.string();
  if (!nh.serviceClient<Service>(name).call(service)) {
    return "The service " + name + " does not answer: nothing was saved by it.";
  }
  return service.response.message;
}

}  // namespace

RunSaver::RunSaver(const ros::NodeHandle& nh, std::string folder)
    : nh_(nh), folder_(std::move(folder)) {}

void RunSaver::save() {
  if (folder_.empty()) {
    return;
  }
  finish();
  saving_ = std::async(
      std::launch::async, [nh = nh_, folder = std::filesystem::absolute(folder_)]() mutable {
        return call<SaveMap>(nh, names::kSaveMapService, folder / "map") + ' ' +
               call<SaveGraph>(nh, std::string("graph_slam/") + names::kSaveGraphService,
                               folder / "graph.g2o");
      });
}

void RunSaver::poll() {
  if (saving_.valid() && saving_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    report();
  }
}

void RunSaver::finish() {
  if (saving_.valid()) {
    report();
  }
}

void RunSaver::report() {
  const std::string text = saving_.get();
  if (ros::ok()) {
    ROS_INFO_STREAM(text);
  }
}

}  // namespace omega_slam
