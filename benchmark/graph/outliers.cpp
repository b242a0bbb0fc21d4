#include "graph/outliers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "experiments/cpu_timer.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/graph/descent.h"
#include "omega_slam/graph/first_guess.h"
#include "omega_slam/graph/graph_system.h"
#include "omega_slam/graph/linearization.h"
#include "omega_slam/graph/robust_loops.h"
#include "omega_slam/graph/selected_inverse.h"
#include "omega_slam/graph/solver.h"
#include "omega_slam/graph/topology.h"

namespace omega_slam::experiments {

using geometry::Pose2;
using graph::Constraint;
using graph::ConstraintKind;
using graph::NodeId;
using graph::PoseGraph;

namespace {

constexpr double kReach = 10.0;       // [m] of a false claim
constexpr double kKernelWidth = 3.0;  // [standard deviations]

graph::KernelConfig noKernels() {
  graph::KernelConfig kernels;
  kernels.loop.kind = graph::KernelKind::kNone;
  return kernels;
}

double statedNoise(const PoseGraph& solution) {
  graph::GraphSystem system;
  system.prepare(solution, graph::spanningForest(solution).roots);
  graph::fillForm(solution, graph::Weighing(noKernels(), solution), system.form());
  if (!system.solve()) {
    throw std::runtime_error("the clean graph's information matrix is singular");
  }
  const graph::SelectedInverse inverse(system.cholesky().columns());
  double sum = 0.0;
  for (NodeId node = 0; node < solution.poses.size(); ++node) {
    const bool is_held = std::count(system.held().begin(), system.held().end(), node) > 0;
    sum += is_held ? 0.0 : inverse.block(node, node).topLeftCorner<2, 2>().trace();
  }
  return std::sqrt(sum / static_cast<double>(solution.poses.size()));
}

Eigen::Matrix3d meanInformation(const PoseGraph& graph) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double count = 0.0;
  for (const Constraint& constraint : graph.constraints) {
    if (constraint.kind == ConstraintKind::kLoop) {
      sum += constraint.information;
      count += 1.0;
    }
  }
  return sum / std::max(count, 1.0);
}

std::vector<double> solveByKernel(PoseGraph& graph, graph::KernelKind kind) {
  graph::SolverConfig config;
  config.kernels.loop = {kind, kKernelWidth};
  config.limits.max_iterations = 100;
  const bool is_plain = kind == graph::KernelKind::kNone;
  graph::applyGuess(graph, is_plain ? graph::FirstGuess::kBest : graph::FirstGuess::kOdometry);
  return graph::solve(graph, config).weights;
}

double errorAgainst(const PoseGraph& truth, const PoseGraph& graph) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.poses.size(); ++i) {
    sum += (truth.poses[i].translation() - graph.poses[i].translation()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(truth.poses.size()));
}

}  // namespace

CleanGraph cleanGraph(std::string name, const PoseGraph& graph) {
  CleanGraph clean{std::move(name), graph, graph, 0.0, 0.0};
  graph::SolverConfig config;
  config.kernels = noKernels();
  config.limits.max_iterations = 100;
  graph::applyGuess(clean.solution, graph::FirstGuess::kBest);
  const auto report = graph::solve(clean.solution, config);
  clean.stated_noise = statedNoise(clean.solution);
  const auto freedom = static_cast<double>(3 * (graph.constraints.size() + 1)) -
                       static_cast<double>(3 * graph.poses.size());
  clean.shown_noise = clean.stated_noise * std::sqrt(report.chi_square / freedom);
  return clean;
}

PoseGraph withFalseLoops(const CleanGraph& clean, const FalseLoops& wanted) {
  PoseGraph spoilt = clean.graph;
  const auto& poses = clean.solution.poses;
  const Eigen::Matrix3d information = meanInformation(clean.graph);
  const auto size = static_cast<NodeId>(wanted.group);
  std::mt19937_64 random(wanted.seed);
  std::uniform_int_distribution<NodeId> node(0, static_cast<NodeId>(poses.size()) - size);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (std::size_t group = 0; group < wanted.count / wanted.group;) {
    const NodeId from = node(random);
    const NodeId to = node(random);
    const double x = kReach * unit(random);
    const double y = kReach * unit(random);
    const Pose2 claim{x, y, geometry::kPi * unit(random)};
    if (std::max(from, to) - std::min(from, to) < 2) {
      continue;
    }
    ++group;
    for (NodeId i = 0; i < size; ++i) {
      Constraint loop;
      loop.from = from + i;
      loop.to = to + i;
      loop.T_from_to = relativePose(poses[loop.from], poses[from]) * claim *
                       relativePose(poses[to], poses[loop.to]);
      loop.information = information;
      loop.kind = ConstraintKind::kLoop;
      spoilt.constraints.push_back(loop);
    }
  }
  return spoilt;
}

std::string outlierHead() {
  return "graph,poses,solver,false_loops,group,seed,true_loops,false_kept,true_dropped,error,"
         "stated_noise,shown_noise,milliseconds";
}

std::string outlierRow(const OutlierAccount& account) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g}", account.graph,
                     account.poses, account.solver, account.wanted.count, account.wanted.group,
                     account.wanted.seed, account.true_loops, account.false_kept,
                     account.true_dropped, account.error, account.stated_noise, account.shown_noise,
                     account.milliseconds);
}

std::vector<std::string> doubtingSolverNames() {
  return {"doubt", "plain", "huber", "cauchy", "scaling", "graduated"};
}

DoubtingSolver doubtingSolver(const std::string& name) {
  const auto names = doubtingSolverNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::invalid_argument(fmt::format("'{}' is no solver that doubts loops; known are {}",
                                            name, fmt::join(names, ", ")));
  }
  if (name == "doubt") {
    return [](PoseGraph& graph) { return graph::solveWithDoubtfulLoops(graph).solution.weights; };
  }
  const auto kind = name == "plain" ? graph::KernelKind::kNone : graph::kernelFromName(name);
  return [kind](PoseGraph& graph) { return solveByKernel(graph, kind); };
}

OutlierAccount outlierAccountFor(const CleanGraph& clean, const FalseLoops& wanted,
                                 const std::string& solver) {
  OutlierAccount account;
  account.graph = clean.name;
  account.poses = clean.graph.poses.size();
  account.solver = solver;
  account.wanted = wanted;
  account.stated_noise = clean.stated_noise;
  account.shown_noise = clean.shown_noise;
  const DoubtingSolver solve = doubtingSolver(solver);
  PoseGraph graph = withFalseLoops(clean, wanted);
  const CpuTimer timer;
  const std::vector<double> weights = solve(graph);
  account.milliseconds = 1e3 * timer.seconds();
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const bool is_loop = graph.constraints[k].kind == ConstraintKind::kLoop;
    const bool is_false = k >= clean.graph.constraints.size();
    const bool is_kept = weights[k] >= 0.5;
    account.true_loops += is_loop && !is_false ? 1 : 0;
    account.false_kept += is_false && is_kept ? 1 : 0;
    account.true_dropped += is_loop && !is_false && !is_kept ? 1 : 0;
  }
  account.error = errorAgainst(clean.solution, graph);
  return account;
}

void sweepOutliers(const CleanGraph& clean, const OutlierSweep& sweep,
                   const std::function<void(const OutlierAccount&)>& report) {
  report(outlierAccountFor(clean, {0, 1, 0}, sweep.solver));
  for (const std::size_t group : sweep.groups) {
    for (const std::size_t count : sweep.counts) {
      for (std::size_t seed = 0; seed < sweep.seeds; ++seed) {
        report(outlierAccountFor(clean, {count, group, 1000 * count + seed}, sweep.solver));
      }
    }
  }
}

}  // namespace omega_slam::experiments
