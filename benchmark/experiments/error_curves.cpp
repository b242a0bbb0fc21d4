#include "experiments/error_curves.h"

#include "experiments/csv_file.h"
#include "experiments/scan_trial.h"
#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr std::uint32_t kErrorStream = 3;
constexpr std::uint32_t kDirectionStream = 7;
constexpr double kFarthest = 4.0;             // [m]
constexpr std::uint32_t kTranslations = 160;  // steps of 2.5 cm
constexpr std::uint32_t kRotations = 180;     // steps of a degree
constexpr int kSingles = 720;                 // steps of half a degree

struct Curve {
  const char* name;
  OdometryNoise noise;
  double highest;
  std::uint32_t steps;
};

void writeMean(const Curve& curve, const std::vector<ScanError>& errors, std::uint32_t seed,
               CsvFile& csv) {
  for (std::uint32_t step = 0; step <= curve.steps; ++step) {
    const double displacement = curve.highest * step / curve.steps;
    double sum = 0.0;
    for (std::uint32_t k = 0; k < errors.size(); ++k) {
      // A place keeps its direction, so that the curve shows nothing but the displacement.
      auto random = generatorFor({seed, kDirectionStream, k});
      sum += errors[k].at(drawOdometry(curve.noise, displacement, random));
    }
    csv.row(curve.name, displacement, sum / static_cast<double>(errors.size()));
  }
}

void writeSingle(const ScanError& error, CsvFile& csv) {
  for (int step = 0; step <= kSingles; ++step) {
    const double angle = geometry::kPi * (2.0 * step / kSingles - 1.0);
    csv.row("single", angle, error.at({0.0, 0.0, angle}));
  }
}

}  // namespace

void runErrorCurves(const Arena& arena, std::size_t scans, std::uint32_t seed,
                    const std::filesystem::path& folder) {
  std::vector<ScanError> errors;
  auto random = generatorFor({seed, kErrorStream});
  for (const Pose2& place : drawPlaces(arena, scans, seed)) {
    const TwoScans pair = takeTwoScans(arena, place, random);
    errors.emplace_back(pair.reference, pair.scan);
  }
  CsvFile csv(folder / ("errors_" + arena.name + ".csv"), "kind,displacement,squared_error");
  writeMean({"translation", OdometryNoise::kTranslation, kFarthest, kTranslations}, errors, seed,
            csv);
  writeMean({"rotation", OdometryNoise::kRotation, geometry::kPi, kRotations}, errors, seed, csv);
  writeSingle(errors.front(), csv);
}

}  // namespace omega_slam::experiments
