#include "omega_slam/evaluation/report_markdown.h"

#include <fmt/format.h>

#include <algorithm>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::evaluation::detail {
namespace {

using geometry::radiansToDegrees;

/// Builds the table of figures, a row each.
class Table {
 public:
  void row(const std::string& what, const std::string& value) {
    rows_ += fmt::format("| {} | {} |\n", what, value);
  }
  [[nodiscard]] std::string text() const {
    return rows_.empty() ? "" : "| figure | value |\n| --- | --- |\n" + rows_;
  }

 private:
  std::string rows_;
};

std::string percent(double share) { return fmt::format("{:.2f} %", 100.0 * share); }

std::string metres(const ErrorStatistics& errors) {
  return fmt::format("mean {:.4f} m, rms {:.4f} m, largest {:.3f} m", errors.mean, errors.rms(),
                     errors.max);
}

std::string degrees(const ErrorStatistics& errors) {
  return fmt::format("mean {:.3f} deg, rms {:.3f} deg, largest {:.2f} deg",
                     radiansToDegrees(errors.mean), radiansToDegrees(errors.rms()),
                     radiansToDegrees(errors.max));
}

void addRun(const Report& report, Table& table) {
  if (report.duration) {
    table.row("time covered", fmt::format("{:.1f} s", *report.duration));
  }
  if (report.distance) {
    table.row("distance driven", fmt::format("{:.2f} m", *report.distance));
  }
  if (report.scans) {
    std::size_t rejected = 0;
    for (const auto& [reason, count] : report.scans->rejections) {
      rejected += count;
    }
    table.row("scans used", fmt::format("{}", report.scans->used));
    table.row("scans rejected", fmt::format("{}", rejected));
  }
  if (report.keyframes) {
    table.row("keyframes", fmt::format("{}", *report.keyframes));
  }
  if (report.loops) {
    table.row("loops closed", fmt::format("{}", report.loops->size()));
  }
  if (report.chi_square) {
    table.row("chi-square of the graph", fmt::format("{:.6g}", *report.chi_square));
  }
  if (report.map) {
    table.row("map", fmt::format("{} x {} cells of {:g} m", report.map->width, report.map->height,
                                 report.map->resolution));
  }
}

void addQuality(const Report& report, Table& table) {
  if (const auto& error = report.trajectory_error) {
    table.row("absolute trajectory error", metres(error->translation));
    table.row("heading error", degrees(error->rotation));
    table.row("poses with known truth",
              fmt::format("{} of {}", error->matched, error->matched + error->unmatched));
  }
  if (const auto& score = report.relations) {
    table.row("relations covered", fmt::format("{} of {}", score->covered, score->relations));
    table.row("relations, translation",
              fmt::format("{:.4f} +- {:.4f} m (squared {:.4f}, largest {:.3f})",
                          score->translation.mean, score->translation.deviation,
                          score->translation.mean_square, score->translation.max));
    table.row("relations, rotation",
              fmt::format("{:.3f} +- {:.3f} deg", radiansToDegrees(score->rotation.mean),
                          radiansToDegrees(score->rotation.deviation)));
  }
  if (const auto& map = report.resemblance) {
    table.row("resemblance", percent(map->score()));
    table.row("resemblance, walls and open space weighted equally", percent(map->balanced()));
    table.row("walls", fmt::format("precision {}, recall {}", percent(map->wallPrecision()),
                                   percent(map->wallRecall())));
    table.row("open space", fmt::format("precision {}, recall {}", percent(map->openPrecision()),
                                        percent(map->openRecall())));
    table.row("share of the world seen", percent(map->coverage()));
  }
}

std::string counts(const char* title, const std::map<std::string, std::size_t>& entries) {
  if (entries.empty()) {
    return {};
  }
  std::string text = fmt::format("\n## {}\n\n| what | scans |\n| --- | --- |\n", title);
  for (const auto& [what, count] : entries) {
    text += fmt::format("| {} | {} |\n", what, count);
  }
  return text;
}

std::string loopList(std::vector<LoopFigures> loops) {
  if (loops.empty()) {
    return {};
  }
  std::stable_sort(loops.begin(), loops.end(), [](const LoopFigures& a, const LoopFigures& b) {
    return a.chi_square > b.chi_square;
  });
  std::string text =
      "\n## Loops\n\nThe least believable first.\n\n"
      "| from | to | residual | rotation | chi-square | confidence | weight |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const LoopFigures& loop : loops) {
    const std::string weight = loop.weight ? fmt::format("{:.2f}", *loop.weight) : "-";
    text +=
        fmt::format("| {} | {} | {:.3f} m | {:.2f} deg | {:.3g} | {:.2f} | {} |\n", loop.from,
                    loop.to, loop.residual_translation, radiansToDegrees(loop.residual_rotation),
                    loop.chi_square, loop.confidence, loop.is_folded ? "folded" : weight);
  }
  return text;
}

}  // namespace

std::string reportAsMarkdown(const Report& report) {
  Table table;
  addRun(report, table);
  addQuality(report, table);
  std::string text = fmt::format("# Report: {}\n\n", report.input) + table.text();
  if (report.scans) {
    text += counts("Scans rejected", report.scans->rejections);
    text += counts("Scans repaired", report.scans->repairs);
  }
  if (report.loops) {
    text += loopList(*report.loops);
  }
  if (!report.notes.empty()) {
    text += "\n## Notes\n\n";
    for (const std::string& note : report.notes) {
      text += fmt::format("* {}\n", note);
    }
  }
  return text;
}

}  // namespace omega_slam::evaluation::detail
