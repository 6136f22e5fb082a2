#include "app/import/volume_fit.h"

#include <algorithm>
#include <any>
#include <numeric>

#include "app/commands/gaussians/edit_medium.h"
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

bool is_gone(const Document& document, const VolumePreview& preview) {
  return std::ranges::none_of(
      preview.ids, [&](GaussianId id) { return document.medium().index_of(id).has_value(); });
}

bool is_as_added(const Document& document, const VolumePreview& preview) {
  const Medium& medium = document.medium();
  for (std::size_t i = 0; i < preview.ids.size(); ++i) {
    const auto index = medium.index_of(preview.ids[i]);
    if (!index || medium.gaussian(*index) != preview.added[i]) return false;
    if (!document.is_editable(preview.ids[i])) return false;
  }
  return true;
}

// Imports it again, which by itself would select it.
void adjust_preview(Document& document, VolumePreview& preview) {
  const std::optional<ObjectRef> object = document.object();
  std::vector<GaussianId> selection = document.selection();
  const bool was_selected =
      std::ranges::any_of(preview.ids, [&](GaussianId id) { return document.is_selected(id); });
  document.last_operation().adjust(preview.placement);
  if (was_selected) selection.insert(selection.end(), preview.ids.begin(), preview.ids.end());
  document.select(std::move(selection));
  document.set_object(object);
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
  const QString verb = Document::tr("Import");
  document.last_operation().perform(
      {verb, ImportPlacement(), [&document, preview, verb](const std::any& placement) {
         preview->placement = std::any_cast<ImportPlacement>(placement);
         const Medium& medium = document.medium();
         const std::size_t first = medium.size();
         add_gaussians(document, placed(preview->gaussians, preview->placement), verb);
         const auto ids = medium.ids().subspan(first);
         preview->ids.assign(ids.begin(), ids.end());
         preview->added.clear();
         for (std::size_t i = first; i < medium.size(); ++i) {
           preview->added.push_back(medium.gaussian(i));
         }
       }});
  preview->is_last_operation = true;
}

void follow_preview(Document& document, const std::shared_ptr<VolumePreview>& preview,
                    QObject* receiver, const std::function<void()>& gone) {
  QObject::connect(&document.last_operation(), &LastOperation::changed, receiver,
                   [preview] { preview->is_last_operation = false; });
  on_change(document, Change::scene, receiver, gone);
  on_change(document, Change::medium, receiver, [&document, preview, gone] {
    // An adjustment takes it back for a moment.
    if (preview->ids.empty() || document.last_operation().is_adjusting()) return;
    if (is_gone(document, *preview)) gone();
  });
}

bool refine_preview(Document& document, VolumePreview& preview,
                    const std::vector<Gaussian>& gaussians) {
  if (is_gone(document, preview)) return true;
  if (!is_as_added(document, preview)) return false;
  preview.gaussians = gaussians;
  if (preview.is_last_operation) {
    adjust_preview(document, preview);
  } else {
    replace_gaussians(document, preview.ids, placed(gaussians, preview.placement),
                      Document::tr("Refine %1").arg(gaussians_text(preview.ids.size())));
  }
  return true;
}

}  // namespace brume
