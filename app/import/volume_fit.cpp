#include "app/import/volume_fit.h"

#include <algorithm>
#include <numeric>

namespace brume {
namespace {

SequenceFrame to_frame(const std::vector<Gaussian>& gaussians,
                       std::span<const GaussianNumber> ids) {
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  SequenceFrame frame;
  for (const std::size_t i : order) {
    frame.ids.push_back(ids[i]);
    frame.gaussians.push_back(gaussians[i]);
  }
  return frame;
}

}  // namespace

std::optional<std::vector<Gaussian>> fit_volume(const std::filesystem::path& file,
                                                const VolumeFit& how, const Job& job) {
  auto fitted = VolumeFitter(how).next(file, job.stop, job.progress);
  if (!fitted) return std::nullopt;
  return fitted->gaussians();
}

std::vector<SequenceFrame> fit_volumes(const std::vector<std::filesystem::path>& files,
                                       const VolumeFit& how, const Job& job) {
  std::vector<SequenceFrame> frames;
  VolumeFitter fitter(how);
  const auto count = static_cast<double>(files.size());
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Job sub_job =
        job.subrange(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
    const auto fitted = fitter.next(files[k], sub_job.stop, sub_job.progress);
    if (!fitted) break;
    frames.push_back(to_frame(fitted->gaussians(), fitter.ids()));
  }
  return frames;
}

}  // namespace brume
