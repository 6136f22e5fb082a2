#pragma once

#include <QTimer>
#include <QWidget>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/authoring/contribution.h"

namespace brume {

class Document;
class View;

// Shows what a Gaussian contributes to the pixel under the mouse: optical depth, absorbed fraction
// of the background, emitted radiance, and scattered radiance per light. Shows the selected
// Gaussian, or the dominant one; others on the ray are listed and can be selected.
class ContributionPanel : public QWidget {
  Q_OBJECT
 public:
  ContributionPanel(Document& document, QWidget* parent);

  // Shows what is at a position of the mouse.
  void inspect(View& view, QPointF position);

  struct LightShare {
    QString name;
    QColor color;
    glm::dvec3 radiance{0.0};
  };
  struct Facts {
    GaussianId id = 0;
    Contribution contribution;
    std::vector<LightShare> lights;
    std::vector<std::pair<GaussianId, Contribution>> met;  // by their effect, descending
  };
  // At the last mouse position; nullopt: no Gaussian.
  [[nodiscard]] const std::optional<Facts>& facts() const { return facts_; }

  [[nodiscard]] QSize sizeHint() const override { return {240, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void compute();
  [[nodiscard]] int row_height() const;

  Document& document_;
  QTimer timer_;  // throttles mouse moves
  View* view_ = nullptr;
  QPointF position_;
  std::optional<Facts> facts_;
  int first_met_row_ = 0;
};

}  // namespace brume
