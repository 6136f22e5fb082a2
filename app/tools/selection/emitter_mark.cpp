#include "app/tools/selection/emitter_mark.h"

#include <algorithm>

#include "app/tools/selection/click_target.h"
#include "app/view/drawing/overlay.h"
#include "app/widgets/interface_settings.h"
#include "brume/emitter.h"
#include "core/scene/animation/particles.h"

namespace brume {
namespace {

constexpr int path_dots = 24;
constexpr double max_outlines = 20.0;

// Outlines show particles as if the emitter had run for a lifetime at its greatest rate, at most so
// many of them. Its rate at present may be 0, before its start.
void add_particles(Overlay& overlay, const CameraRays& rays, const Emitter& emitter, QRgb color) {
  if (emitter.lifetime <= 0.0) return;
  Emitter thin = emitter;
  thin.keys = {};
  const double rate = emitter.keys.rate.empty() ? emitter.rate : upper_bound(emitter.keys.rate);
  thin.rate = std::min(rate, max_outlines / emitter.lifetime);
  for (const Gaussian& particle : particles_at(thin, emitter.lifetime)) {
    overlay.add_outline(rays, particle, color);
  }
}

bool has_hardly_begun(const Emitter& emitter, double time) {
  constexpr double hardly_any = 2.0;  // particles after the first
  return time <= 0.0 || emitted_until(emitter, time) < hardly_any;
}

}  // namespace

void add_emitter_mark(Overlay& overlay, const CameraRays& rays, const Emitter& emitter, QRgb color,
                      bool is_active, double time) {
  const glm::dvec3 projected = rays.project(emitter.position);
  if (projected.z > 0.0) {
    overlay.add_circle(projected.x, projected.y, emitter_radius * handle_scale(), color);
    overlay.marks.push_back(
        {static_cast<float>(projected.x), static_cast<float>(projected.y), color});
  }
  if (!is_active) return;
  for (int dot = 1; dot <= path_dots; ++dot) {
    const double age = emitter.lifetime * dot / path_dots;
    const glm::dvec3 on_film = rays.project(emitter.position + age * emitter.velocity +
                                            0.5 * age * age * emitter.acceleration);
    if (on_film.z <= 0.0) continue;
    overlay.dots.push_back({static_cast<float>(on_film.x), static_cast<float>(on_film.y), color});
  }
  const QRgb faint = qRgba(qRed(color), qGreen(color), qBlue(color), qAlpha(color) / 3);
  if (has_hardly_begun(emitter, time)) add_particles(overlay, rays, emitter, faint);
}

}  // namespace brume
