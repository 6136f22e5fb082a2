#include "app/view/shown_handles.h"

#include <map>
#include <utility>

#include "app/document/document.h"
#include "app/view/camera/camera_controller.h"
#include "app/widgets/color_button.h"

namespace brume {

ShownHandles::ShownHandles(const Document& document, const CameraController& camera)
    : document_(document), camera_(camera) {
  connect(&camera, &CameraController::moved, this, &ShownHandles::project);
  on_change(document, Change::medium | Change::groups, this, [this] {
    color_by_group();
    project();
  });
  on_change(document, Change::hidden_or_locked, this, &ShownHandles::project);
  on_change(document, Change::selection, this, &ShownHandles::changed);
  connect(&document.last_operation(), &LastOperation::changed, this, &ShownHandles::changed);
  on_change(document, Change::scene, this, [this] {
    hovered_.reset();
    color_by_group();
  });
}

void ShownHandles::set_hovered(std::optional<GaussianId> id) {
  if (id == hovered_) return;
  hovered_ = id;
  Q_EMIT changed();
}

void ShownHandles::show_centers(bool centers) {
  centers_ = centers;
  Q_EMIT changed();
}

void ShownHandles::project() {
  handles_.restrict(document_.grouped_medium(), document_.all_hidden(), document_.all_locked());
  is_projected_ = false;
  Q_EMIT changed();
}

const Handles& ShownHandles::handles() const {
  if (!std::exchange(is_projected_, true)) {
    handles_.project(document_.grouped_medium(), camera_.rays());
  }
  return handles_;
}

void ShownHandles::color_by_group() {
  std::vector<QRgb> colors;
  const auto& groups = document_.scene().groups;
  if (!groups.empty()) {
    std::map<GroupId, QRgb> by_group;
    for (const Group& group : groups) by_group[group.id] = to_color(group.color).rgb();
    const Medium& medium = document_.medium();
    colors.resize(medium.size());
    GroupId last = 0;
    QRgb color = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const GroupId group = medium.group(i);
      if (group != last) {
        const auto found = by_group.find(group);
        color = found == by_group.end() ? 0 : found->second;
        last = group;
      }
      colors[i] = color;
    }
  }
  handles_.set_colors(std::move(colors));
}

void ShownHandles::set_depth(const Camera& camera, const Frame& frame) {
  handles_.set_depth({camera, frame.film}, frame);
  Q_EMIT changed();
}

bool ShownHandles::use_depth() const {
  return centers_ || !document_.selection().empty();
}

void ShownHandles::draw(Overlay& overlay) const {
  handles_.draw(overlay, document_.grouped_medium(), camera_.rays(), document_.selection(),
                hovered_,
                !centers_                                ? Handles::Marks::outlines
                : document_.last_operation().operation() ? Handles::Marks::quiet
                                                         : Handles::Marks::all);
}

void ShownHandles::draw_outlines(Overlay& overlay) const {
  handles().draw_outlines(overlay, document_.grouped_medium(), camera_.rays());
}

}  // namespace brume
