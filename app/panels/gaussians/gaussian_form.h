#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/euler_angles.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/text/arithmetic.h"
#include "app/widgets/optics_editor.h"

class QFormLayout;
class QLayout;

namespace brume {

class Document;
class ValueField;

// Fields of the selection's attributes: the common value, or "mixed". Edits apply to all selected
// Gaussians; rotations to the ellipsoids among them.
class GaussianForm : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianForm(Document& document, QWidget* parent = nullptr);

  static constexpr std::array attributes{
      GaussianAttribute::center_x,   GaussianAttribute::center_y,  GaussianAttribute::center_z,
      GaussianAttribute::radius,     GaussianAttribute::density,   GaussianAttribute::radius_x,
      GaussianAttribute::radius_y,   GaussianAttribute::radius_z,  GaussianAttribute::rotation_x,
      GaussianAttribute::rotation_y, GaussianAttribute::rotation_z};

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  void add_field(std::size_t k);
  void refresh();
  void set(GaussianAttribute field, double value, MergeId gesture);
  void adjust(GaussianAttribute field, const Adjustment& adjustment);
  [[nodiscard]] std::vector<GaussianId> selected_ellipsoids() const;
  // Sets that angle of ellipsoids to what it becomes.
  void rotate(std::span<const GaussianId> ids, GaussianAttribute field,
              const std::function<double(double)>& becomes, const QString& text, MergeId gesture);

  Document& document_;
  std::array<ValueField*, attributes.size()> fields_{};
  EnteredAngles entered_angles_;
  // The selection before the first step of a gesture.
  struct Start {
    MergeId gesture = no_merge;
    std::vector<GaussianId> ids;
    std::vector<Gaussian> gaussians;
  };
  Start start_;
  bool applying_ = false;
  QFormLayout* layout_ = nullptr;
  QLayout* rotation_ = nullptr;     // its row, shown for ellipsoids
  OpticsEditor* optics_ = nullptr;  // shows the first of the selection
  glm::dvec3 shown_albedo_{0.0};    // of the medium
};

}  // namespace brume
