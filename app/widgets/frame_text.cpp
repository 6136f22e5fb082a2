#include "app/widgets/frame_text.h"

#include <QLocale>
#include <algorithm>

#include "render/frame.h"
#include "render/quality/error_estimate.h"
#include "render/settings.h"

namespace brume {
namespace {

constexpr double min_shown = 1e-4;

int decimals(double share) {
  return share >= 0.0995 ? 0 : share >= 0.00995 ? 1 : 2;
}

QString number(double share, int digits) {
  return QString::number(100.0 * share, 'f', digits);
}

}  // namespace

QString count_text(std::uint64_t count) {
  return QLocale(QLocale::English).toString(qulonglong{count});
}

QString settings_text(const Settings& settings) {
  const QString name = QString::fromStdString(airlight_name(settings));
  return settings.airlight == AirlightMethod::sliced
             ? QString("%1 %2").arg(name).arg(settings.slices)
             : name;
}

QString backend_text(const FrameStatistics& statistics) {
  return statistics.backend == "gl"
             ? QString("OpenGL on %1").arg(QString::fromStdString(statistics.device))
             : QString("CPU");
}

QString fallback_text(const FrameStatistics& statistics) {
  const auto frame = std::ranges::find(statistics.on_cpu, Stage::frame, &SkippedStage::stage);
  return frame == statistics.on_cpu.end() ? QString() : QString::fromStdString(frame->why);
}

QString paths_text(const Frame& frame) {
  if (const std::optional<RelativeNoise> noise = relative_noise(frame)) {
    return QString("%1 paths, noise %2")
        .arg(count_text(static_cast<std::uint64_t>(noise->paths)), percent_text(noise->picture));
  }
  const std::vector<StageTime>& stages = frame.statistics.stages;
  const auto traced = std::ranges::find(stages, Stage::paths, &StageTime::stage);
  return traced == stages.end() ? QString() : QString("1 path");
}

QString scattering_text(const Frame& frame) {
  if (const QString paths = paths_text(frame); !paths.isEmpty()) {
    return QString("all orders, %1").arg(paths);
  }
  const std::optional<Convergence>& solved = frame.statistics.scattering;
  if (!solved) return "once";
  return QString("all orders, converged to %1 in %2 sweeps")
      .arg(percent_text(solved->residual))
      .arg(solved->sweeps);
}

QString percent_text(double share) {
  if (share > 0.0 && share < min_shown) return "< .01 %";
  return number(share, decimals(share)) + " %";
}

QString bound_text(double share) {
  return QString::number(100.0 * share, 'g', 3) + " %";
}

QString error_text(const ErrorEstimate& error) {
  if (error.high < min_shown) return "< .01 %";
  const int digits = decimals(error.rel_rmse);
  QString either_way = number(error.high - error.rel_rmse, digits);
  if (either_way.startsWith("0.")) either_way.remove(0, 1);
  return QString("%1 ± %2 %").arg(number(error.rel_rmse, digits), either_way);
}

QString interval_text(const ErrorEstimate& error) {
  const int digits = decimals(error.low);
  return QString("%1 to %2 %").arg(number(error.low, digits), number(error.high, digits));
}

}  // namespace brume
