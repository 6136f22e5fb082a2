#pragma once

#include <QPointF>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/view/drawing/overlay.h"
#include "brume/frame.h"
#include "brume/medium.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Handles of Gaussians: a dot per center, and for selected ones the outline at 1/e of the density.
// Works in film space, so picking needs no OpenGL.
class Handles {
 public:
  // Hidden Gaussians are excluded, locked ones cannot be picked. Ids are sorted.
  void restrict(const Medium& medium, std::span<const GaussianId> hidden,
                std::span<const GaussianId> locked);
  // Projects centers to the film, for the queries below; drawing needs no more than it draws.
  void project(const Medium& medium, const CameraRays& rays);

  // Colours of their groups, without alpha; 0: of none. Empty: all in none.
  void set_colors(std::vector<QRgb> colors) { colors_ = std::move(colors); }

  // Gaussians are behind surfaces by the depth of a frame of these rays; none without depth.
  void set_depth(const CameraRays& rays, const Frame& frame);

  // Indices of Gaussians: the one under the mouse (the front one of ties), and all with center
  // inside an area.
  [[nodiscard]] std::optional<std::size_t> pick(QPointF position) const;
  [[nodiscard]] std::vector<std::size_t> inside(const std::function<bool(QPointF)>& area) const;

  // Film position and depth of a Gaussian's centre; depth <= 0 is behind the eye.
  [[nodiscard]] const glm::dvec3& position(std::size_t index) const { return positions_[index]; }

  // The part of selected Gaussians that is drawn: all, or only their outlines, or small handles
  // and the outline of one under the mouse.
  enum class Marks { all, outlines, quiet };
  // `selected`: sorted ids. In a crowd one handle for each small square of the film, and of very
  // many an even choice.
  void draw(Overlay& overlay, const Medium& medium, const CameraRays& rays,
            std::span<const GaussianId> selected, std::optional<GaussianId> hovered,
            Marks marks) const;

  // Draws outlines of all visible Gaussians, only the nearest if many.
  void draw_outlines(Overlay& overlay, const Medium& medium, const CameraRays& rays) const;

 private:
  // The color of its group, or else `other`.
  [[nodiscard]] QRgb color_of(std::size_t index, QRgb other) const {
    return index < colors_.size() && colors_[index] != 0 ? colors_[index] : other;
  }

  [[nodiscard]] bool is_hidden(std::size_t index) const {
    return index < hidden_.size() && hidden_[index];
  }
  [[nodiscard]] bool is_locked(std::size_t index) const {
    return index < locked_.size() && locked_[index];
  }
  [[nodiscard]] bool is_behind_surface(const glm::dvec3& center) const;

  std::vector<glm::dvec3> positions_;
  std::vector<bool> hidden_, locked_;  // empty: none are
  std::vector<QRgb> colors_;

  struct FilmDepth {
    CameraRays rays;
    Film film;
    std::vector<float> depth;
  };
  std::optional<FilmDepth> depth_;
};

}  // namespace brume
