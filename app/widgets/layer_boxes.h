#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "brume/output.h"

class QCheckBox;

namespace brume {

// A box for each layer of an EXR.
class LayerBoxes : public QWidget {
 public:
  using Clicked = std::function<void(bool OutputLayers::*layer, bool on)>;
  // `clicked`: by the user. May be empty.
  explicit LayerBoxes(QWidget* parent, Clicked clicked = {});

  void set_layers(const OutputLayers& layers);
  [[nodiscard]] OutputLayers layers() const;

 private:
  std::vector<QCheckBox*> boxes_;  // in the order of layer_names
};

}  // namespace brume
