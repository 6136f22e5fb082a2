#include "app/export/export_frames.h"

#include <QCoreApplication>
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace brume {
namespace {

// The first failure, and how many others there are.
std::string summary(const FrameLoop::Result& result) {
  const auto& [frame, why] = result.failed.front();
  const std::size_t complete = result.made.size() + result.skipped.size();
  const QString first =
      QCoreApplication::translate("export", "Frame %1: %2").arg(frame).arg(why.c_str());
  const std::size_t all = complete + result.failed.size();
  const QString rest = QCoreApplication::translate("export", "(%1 of %n frame(s) are written)",
                                                   nullptr, static_cast<int>(all))
                           .arg(complete);
  return (first + " " + rest).toStdString();
}

}  // namespace

void export_frames(int first, int last, const Job& job, const ExportFrame& make,
                   const std::set<int>& complete, const FrameFailed& failed) {
  std::vector<int> frames(static_cast<std::size_t>(last - first + 1));
  std::iota(frames.begin(), frames.end(), first);
  const int count = last - first + 1;
  FrameLoop::Steps steps;
  steps.make = [&](int frame, const std::string&) {
    if (job.stop.stop_requested()) throw Cancelled();
    return make(frame, frame - first, count);
  };
  steps.skips = [&](int frame) { return complete.contains(frame); };
  const auto first_made = std::ranges::find_if_not(frames, steps.skips);
  steps.failed = [&](int frame, const std::string& why) {
    if (failed) failed(frame, why);
    if (frame == *first_made) throw std::runtime_error(why);
  };
  const FrameLoop::Result result = FrameLoop::run(frames, steps);
  if (job.stop.stop_requested()) throw Cancelled();
  if (!result.failed.empty()) throw std::runtime_error(summary(result));
}

}  // namespace brume
