#include "app/widgets/frame_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "app/document/text/number_text.h"
#include "brume/frame.h"
#include "brume/render.h"
#include "render/quality/frame_errors.h"
#include "render/settings.h"

namespace brume {
namespace {

constexpr double min_shown = 1e-4;

int decimals(double share) {
  return share >= 0.0995 ? 0 : share >= 0.00995 ? 1 : 2;
}

QString frame_words(const char* text, int count = -1) {
  return QCoreApplication::translate("Frame", text, nullptr, count);
}

QString number(double share, int digits) {
  return fixed_text(100.0 * share, digits);
}

}  // namespace

QString count_text(std::uint64_t count) {
  return QLocale(QLocale::English).toString(qulonglong{count});
}

QString settings_text(const Settings& settings) {
  switch (settings.airlight) {
    case AirlightMethod::sliced:
      return frame_words("%n slice(s)", settings.slices);
    case AirlightMethod::paper:
      return frame_words("paper's method");
    case AirlightMethod::reference:
      return frame_words("reference");
    case AirlightMethod::path:
      return frame_words("path tracing");
    case AirlightMethod::auto_:
      break;
  }
  return QString::fromStdString(airlight_name(settings));
}

QString backend_text(const FrameStatistics& statistics) {
  return statistics.backend == "gl"
             ? frame_words("OpenGL on %1").arg(QString::fromStdString(statistics.device))
             : QString("CPU");
}

QString fallback_text(const FrameStatistics& statistics) {
  const auto frame = std::ranges::find(statistics.on_cpu, Stage::frame, &SkippedStage::stage);
  return frame == statistics.on_cpu.end() ? QString() : QString::fromStdString(frame->why);
}

QString paths_text(const Frame& frame) {
  if (const std::optional<RelativeNoise> noise = relative_noise(frame)) {
    return frame_words("%1 path(s), noise %2", static_cast<int>(noise->paths))
        .arg(count_text(static_cast<std::uint64_t>(noise->paths)), percent_text(noise->picture));
  }
  const std::vector<StageTime>& stages = frame.statistics.stages;
  const auto traced = std::ranges::find(stages, Stage::paths, &StageTime::stage);
  if (traced == stages.end()) return {};
  const RenderRequest* request = frame.request.get();
  return request && request->denoise != Denoising::none
             ? frame_words("%1 path(s), denoised", request->paths)
                   .arg(count_text(static_cast<std::uint64_t>(request->paths)))
             : frame_words("%1 path(s)", 1).arg(1);
}

QString scattering_text(const Frame& frame) {
  if (const QString paths = paths_text(frame); !paths.isEmpty()) {
    return frame_words("all orders, %1").arg(paths);
  }
  const std::optional<Convergence>& solved = frame.statistics.scattering;
  if (!solved) return frame_words("once");
  return frame_words("all orders, converged to %1 in %n sweep(s)", solved->sweeps)
      .arg(percent_text(solved->residual));
}

QString bound_text(double share) {
  return number_text(100.0 * share, 3) + " %";
}

QString error_text(const ErrorEstimate& error) {
  if (error.high < min_shown) return "< 0.01 %";
  const int digits = decimals(error.rel_rmse);
  return QString("%1 ± %2 %")
      .arg(number(error.rel_rmse, digits), number(error.high - error.rel_rmse, digits));
}

QString errors_text(const FrameError& error) {
  const QString airlight = error_text(error.airlight);
  const QString picture = error.picture ? error_text(*error.picture) : airlight;
  return picture == airlight ? airlight : frame_words("%1, picture %2").arg(airlight, picture);
}

QString block_error_text(const ErrorEstimate& error) {
  const int digits = decimals(error.block_median);
  return QString("%1 %, %2 to %3 %")
      .arg(number(error.block_median, digits), number(error.block_low, digits),
           number(error.block_high, digits));
}

QString interval_text(const ErrorEstimate& error) {
  const int digits = decimals(error.low);
  return QString("%1 to %2 %").arg(number(error.low, digits), number(error.high, digits));
}

}  // namespace brume
