#include "app/import/volume_fit.h"

#include <algorithm>
#include <any>
#include <numeric>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/import/add_imported.h"

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

void show_preview(Document& document, const std::shared_ptr<VolumePreview>& preview) {
  LastOperation& last = document.last_operation();
  const QString verb = Document::tr("Import");
  last.perform({verb, ImportPlacement(), [&document, preview, verb](const std::any& placement) {
                  preview->placement = std::any_cast<ImportPlacement>(placement);
                  const std::size_t before = document.medium().size();
                  add_gaussians(document, placed(preview->gaussians, preview->placement), verb);
                  const auto added = document.medium().ids().subspan(before);
                  preview->ids.assign(added.begin(), added.end());
                }});
  QObject::connect(
      &last, &LastOperation::changed, &document, [preview] { preview->is_last_operation = false; },
      Qt::SingleShotConnection);
  on_change(document, Change::scene, &document, [preview] { preview->ids.clear(); });
}

void refine_preview(Document& document, VolumePreview& preview,
                    const std::vector<Gaussian>& gaussians) {
  std::erase_if(preview.ids, [&](GaussianId id) { return !document.medium().index_of(id); });
  if (preview.ids.empty()) return;
  preview.gaussians = gaussians;
  if (preview.is_last_operation) return document.last_operation().adjust(preview.placement);
  replace_gaussians(document, preview.ids, placed(gaussians, preview.placement),
                    Document::tr("Refine %1").arg(gaussians_text(preview.ids.size())));
}

}  // namespace brume
