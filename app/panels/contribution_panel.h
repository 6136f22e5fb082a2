#pragma once

#include <QTimer>
#include <QWidget>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/authoring/contribution.h"

namespace brume {

class Document;
class ViewGrid;
class Viewport;

// What a Gaussian does to the pixel under the mouse, in bars: its optical depth there, how much of
// the light behind it takes away, and what it scatters to the eye from each light. That is the
// selected one, or else the one that does most. The others that the pixel's ray meets are listed;
// a click selects one.
class ContributionPanel : public QWidget {
  Q_OBJECT
 public:
  ContributionPanel(Document& document, ViewGrid& views, QWidget* parent);

  struct LightShare {
    QString name;
    QColor color;
    glm::dvec3 radiance{0.0};
  };
  struct Facts {
    GaussianId id = 0;
    Contribution contribution;
    std::vector<LightShare> lights;
    std::vector<std::pair<GaussianId, double>> met;  // with their shares, the greatest first
  };
  // Of the last position of the mouse; nullopt: no Gaussian there.
  [[nodiscard]] const std::optional<Facts>& facts() const { return facts_; }

  [[nodiscard]] QSize sizeHint() const override { return {240, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void look(Viewport& view, QPointF position);
  void compute();
  [[nodiscard]] int row_height() const;

  Document& document_;
  QTimer timer_;  // or every small move of the mouse would be followed
  Viewport* view_ = nullptr;
  QPointF position_;
  std::optional<Facts> facts_;
  int first_met_row_ = 0;
};

}  // namespace brume
