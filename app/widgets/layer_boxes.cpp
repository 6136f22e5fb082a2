#include "app/widgets/layer_boxes.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QGridLayout>

#include "app/widgets/rows.h"

namespace brume {
namespace {

struct LayerText {
  const char* name;  // of the box
  const char* title;
  const char* tip;
};

// In the order of layer_names.
constexpr std::array texts{
    LayerText{"layer_airlight", QT_TRANSLATE_NOOP("layers", "Airlight"),
              QT_TRANSLATE_NOOP("layers", "The light that the fog scatters to the camera")},
    LayerText{"layer_transmittance", QT_TRANSLATE_NOOP("layers", "Transmittance"),
              QT_TRANSLATE_NOOP("layers", "The share of light that the fog lets through")},
    LayerText{"layer_depth", QT_TRANSLATE_NOOP("layers", "Depth"),
              QT_TRANSLATE_NOOP("layers", "The distance along the view ray, in scene units")},
    LayerText{"layer_lights", QT_TRANSLATE_NOOP("layers", "Lights"),
              QT_TRANSLATE_NOOP("layers",
                                "Airlight and surfaces under each light alone. Takes a "
                                "render for each source of light")},
    LayerText{"layer_environment", QT_TRANSLATE_NOOP("layers", "Environment"),
              QT_TRANSLATE_NOOP("layers",
                                "Airlight and surfaces under the environment alone, and "
                                "what is seen of it. Takes a render for each source of "
                                "light")},
    LayerText{"layer_emission", QT_TRANSLATE_NOOP("layers", "Emission"),
              QT_TRANSLATE_NOOP("layers",
                                "Airlight and surfaces under what shines by itself alone. "
                                "Takes a render for each source of light")},
    LayerText{"layer_direct", QT_TRANSLATE_NOOP("layers", "Direct"),
              QT_TRANSLATE_NOOP("layers",
                                "Light that was scattered once at most. Takes another "
                                "render")},
    LayerText{"layer_multiple", QT_TRANSLATE_NOOP("layers", "Multiple"),
              QT_TRANSLATE_NOOP("layers",
                                "Light that was scattered or reflected more often. Takes "
                                "another render")},
    LayerText{"layer_reflection", QT_TRANSLATE_NOOP("layers", "Reflection"),
              QT_TRANSLATE_NOOP("layers",
                                "What smooth surfaces mirror of surfaces, fog and sky. Takes "
                                "another render where some do")},
    LayerText{"layer_optical_depth", QT_TRANSLATE_NOOP("layers", "Optical depth"),
              QT_TRANSLATE_NOOP("layers", "Minus the logarithm of the transmittance")},
    LayerText{"layer_planar_depth", QT_TRANSLATE_NOOP("layers", "Planar depth"),
              QT_TRANSLATE_NOOP("layers", "The depth along the camera's axis, in scene units")},
    LayerText{"layer_normal", QT_TRANSLATE_NOOP("layers", "Normal"),
              QT_TRANSLATE_NOOP("layers", "Of surfaces, in the world")},
    LayerText{"layer_albedo", QT_TRANSLATE_NOOP("layers", "Albedo"),
              QT_TRANSLATE_NOOP("layers", "The colour of surfaces, without light")},
    LayerText{"layer_position", QT_TRANSLATE_NOOP("layers", "Position"),
              QT_TRANSLATE_NOOP("layers", "Of surfaces, in the world")},
    LayerText{"layer_motion", QT_TRANSLATE_NOOP("layers", "Motion"),
              QT_TRANSLATE_NOOP("layers", "How far surfaces move until the next frame, in pixels")},
    LayerText{"layer_objects", QT_TRANSLATE_NOOP("layers", "Objects"),
              QT_TRANSLATE_NOOP("layers", "A Cryptomatte of surfaces by their names")},
    LayerText{"layer_materials", QT_TRANSLATE_NOOP("layers", "Materials"),
              QT_TRANSLATE_NOOP("layers", "A Cryptomatte of surfaces by their materials")}};
static_assert(texts.size() == layer_names.size());

QString translated(const char* text) {
  return QCoreApplication::translate("layers", text);
}

}  // namespace

LayerBoxes::LayerBoxes(QWidget* parent, Clicked clicked) : QWidget(parent) {
  constexpr int columns = 2;
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    auto* box = named(new QCheckBox(translated(texts[i].title), this), texts[i].name,
                      translated(texts[i].tip));
    const int place = static_cast<int>(i);
    grid->addWidget(box, place / columns, place % columns);
    boxes_.push_back(box);
    if (!clicked) continue;
    connect(box, &QCheckBox::clicked, this,
            [clicked, layer = layer_names[i].layer](bool on) { clicked(layer, on); });
  }
  set_layers({});
}

void LayerBoxes::set_layers(const OutputLayers& layers) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    boxes_[i]->setChecked(layers.*layer_names[i].layer);
  }
}

OutputLayers LayerBoxes::layers() const {
  OutputLayers layers;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    layers.*layer_names[i].layer = boxes_[i]->isChecked();
  }
  return layers;
}

}  // namespace brume
