#include "app/panels/forms/output_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/objects/edit_output.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/time/timeline.h"
#include "app/files/picture_format.h"
#include "app/widgets/layer_boxes.h"
#include "app/widgets/method_box.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "brume/limits.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr NumberDomain film_side{1, limits::film_side, "a whole number from 1 to 16384"};
constexpr NumberDomain path_count{1, limits::paths, "a whole number from 1 to 1000000"};
constexpr NumberDomain frame_number{0, limits::frame, "a whole number from 0 to 1000000"};

struct SizePreset {
  const char* title;
  Film film;
};
constexpr std::array size_presets{
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "HD, 1280 × 720"), {1280, 720}},
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "Full HD, 1920 × 1080"), {1920, 1080}},
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "4K UHD, 3840 × 2160"), {3840, 2160}},
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "Cinema 2K, 2048 × 858"), {2048, 858}},
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "Square, 1080 × 1080"), {1080, 1080}},
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "Upright, 1080 × 1920"), {1080, 1920}},
    SizePreset{QT_TRANSLATE_NOOP("brume::OutputPanel", "4:3, 800 × 600"), {800, 600}},
};

int rounded_to_int(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

OutputPanel::OutputPanel(Document& document, const Timeline& timeline,
                         std::function<double()> exposure, QAction* render,
                         QAction* render_animation, QWidget* parent)
    : SceneForm(document, parent), timeline_(timeline), exposure_(std::move(exposure)) {
  auto* form = new_form();
  add_buttons(*form, render, render_animation);
  add_file(*form);
  add_view(*form);
  add_size(*form);
  add_region(*form);
  add_method(*form);
  add_samples(*form);
  add_shutter(*form);
  add_frames(*form);
  add_layers(*form);
  add_exposure(*form);
  connect(&timeline_, &Timeline::changed, this, &OutputPanel::refresh);
  on_change(document_, Change::file, this, &OutputPanel::refresh);
  refresh();
}

const Output& OutputPanel::output() const {
  return document_.scene().output;
}

void OutputPanel::add_view(QFormLayout& form) {
  from_view_ = named(new QCheckBox(tr("Seen from the view"), this), "output_from_view",
                     tr("Renders what the view sees, not the scene's camera. It is not saved with "
                        "the scene"));
  form.addRow({}, from_view_);
  on_change(document_, Change::scene, from_view_, [this] { from_view_->setChecked(false); });
}

bool OutputPanel::renders_view() const {
  return from_view_->isChecked();
}

void OutputPanel::add_size(QFormLayout& form) {
  auto* presets =
      named(new QComboBox(this), "size_preset", tr("Usual sizes of pictures, in pixels"));
  presets->addItem(tr("Custom"));
  for (const SizePreset& preset : size_presets) presets->addItem(tr(preset.title));
  form.addRow(tr("Size"), presets);
  connect(presets, &QComboBox::activated, this, [this](int index) {
    if (index > 0) set_film(document_, size_presets.at(static_cast<std::size_t>(index - 1)).film);
  });
  const auto film = [this]() -> const Film& { return document_.scene().film; };
  for (const bool is_width : {true, false}) {
    add_number(form, is_width ? tr("Width, px") : tr("Height, px"),
               {is_width ? "film_width" : "film_height", film_side, ValueField::Scale::linear, 1.0,
                [film, is_width] {
                  return std::optional<double>(is_width ? film().width : film().height);
                },
                [=, this](double value, MergeId gesture) { set_side(is_width, value, gesture); }})
        ->setToolTip(tr("Of the rendered picture, in pixels"));
  }
  auto* lock = named(new QCheckBox(tr("Lock aspect ratio"), this), "lock_aspect",
                     tr("Width and height change together"));
  connect(lock, &QCheckBox::toggled, this, [this, film](bool on) {
    locks_aspect_ = on;
    aspect_ = static_cast<double>(film().width) / film().height;
  });
  form.addRow({}, lock);
  on_refresh([this, presets, film] {
    // Steps of whole pixels do not change the ratio that is locked.
    if (std::abs(film().width - aspect_ * film().height) > std::max(1.0, aspect_)) {
      aspect_ = static_cast<double>(film().width) / film().height;
    }
    const auto* found = std::ranges::find(size_presets, film(), &SizePreset::film);
    presets->setCurrentIndex(
        found == size_presets.end() ? 0 : static_cast<int>(found - size_presets.begin()) + 1);
  });
}

void OutputPanel::set_side(bool is_width, double pixels, MergeId gesture) {
  Film film = document_.scene().film;
  (is_width ? film.width : film.height) = rounded_to_int(pixels);
  if (locks_aspect_) {
    int& other = is_width ? film.height : film.width;
    const double wanted = is_width ? film.width / aspect_ : film.height * aspect_;
    other = std::clamp(rounded_to_int(wanted), 1, limits::film_side);
  }
  set_film(document_, film, gesture);
}

void OutputPanel::add_region(QFormLayout& form) {
  region_ = new QWidget(this);
  auto* row = new QHBoxLayout(region_);
  row->setContentsMargins(0, 0, 0, 0);
  auto* text = named(new PlainLabel(region_), "region_text");
  auto* clear = named(new QPushButton(tr("Whole Picture"), region_), "clear_region",
                      tr("Renders the whole picture again, not only the region"));
  row->addWidget(text, 1);
  row->addWidget(clear);
  connect(clear, &QPushButton::clicked, this, &OutputPanel::clear_region_asked_for);
  form.addRow(region_);
  region_->hide();
  // It is marked in the picture of the scene's camera.
  connect(from_view_, &QCheckBox::toggled, region_, &QWidget::setDisabled);
}

void OutputPanel::show_region(const QString& text) {
  region_->findChild<QLabel*>("region_text")->setText(text);
  region_->setVisible(!text.isEmpty());
}

void OutputPanel::add_method(QFormLayout& form) {
  auto* method = named(new MethodBox(this), "output_method");
  form.addRow(tr("Method"), method);
  const auto shown = [this]() -> std::optional<Denoising> {
    return output().paths ? std::optional(output().denoise) : std::nullopt;
  };
  connect(method, &QComboBox::activated, this, [this, method, shown] {
    const std::optional<Denoising> chosen = method->paths();
    if (chosen == shown()) return;
    change_output(document_, tr("Set method of rendering"), no_merge, [chosen](Output& output) {
      output.denoise = chosen.value_or(Denoising::none);
      output.paths.reset();
      if (chosen) output.paths = MethodBox::first_paths(*chosen);
    });
  });
  add_number(form, tr("Paths per pixel"),
             {"output_paths", path_count, ValueField::Scale::logarithmic, 0.02,
              [this]() -> std::optional<double> {
                return output().paths ? std::optional<double>(*output().paths) : std::nullopt;
              },
              [this](double value, MergeId gesture) {
                change_output(document_, tr("Set paths per pixel"), gesture,
                              [value](Output& output) { output.paths = rounded_to_int(value); });
              }})
      ->setToolTip(tr("Samples of each pixel: four times as many halve the noise and take four "
                      "times as long"));
  on_refresh([method, shown] { method->set_paths(shown()); });
}

void OutputPanel::add_frames(QFormLayout& form) {
  const auto add = [&](const QString& title, const char* name, const NumberDomain& domain,
                       const auto& get, const auto& change, const QString& tip) {
    add_number(form, title,
               {name, domain, ValueField::Scale::linear, 0.25,
                [get] { return std::optional<double>(get()); },
                [this, change](double value, MergeId) {
                  Playback playback{timeline_.first(), timeline_.last(), timeline_.loops(),
                                    timeline_.frames_per_second()};
                  change(playback, value);
                  set_playback(playback);
                }})
        ->setToolTip(tip);
  };
  add(
      tr("First frame"), "output_first", frame_number, [this] { return timeline_.first(); },
      [](Playback& playback, double value) {
        playback.first = rounded_to_int(value);
        playback.last = std::max(playback.first, playback.last);
      },
      tr("Of the animation; the same as in the timeline"));
  add(
      tr("Last frame"), "output_last", frame_number, [this] { return timeline_.last(); },
      [](Playback& playback, double value) {
        playback.last = rounded_to_int(value);
        playback.first = std::min(playback.first, playback.last);
      },
      tr("Of the animation; the same as in the timeline"));
  add(
      tr("Frames per second"), "output_rate", domain::frame_rate,
      [this] { return timeline_.frames_per_second(); },
      [](Playback& playback, double value) { playback.frames_per_second = value; },
      tr("Of the timeline and of videos. Keyframes keep their times in seconds"));
}

void OutputPanel::set_playback(const Playback& playback) {
  set_scene_part(document_, std::optional(playback), tr("Set playback range"));
}

void OutputPanel::add_layers(QFormLayout& form) {
  auto* layers = new LayerBoxes(this, [this](bool OutputLayers::*layer, bool on) {
    change_output(document_, tr("Set layers of output"), no_merge,
                  [=](Output& output) { output.layers.*layer = on; });
  });
  on_refresh([this, layers] { layers->set_layers(output().layers); });
  form.addRow(tr("Layers"), layers);
  on_refresh([this, layers] {
    layers->setEnabled(picture_format(output().file) == ".exr");
    layers->setToolTip(layers->isEnabled() ? QString() : tr("Only flat EXR files have layers"));
  });
}

void OutputPanel::add_exposure(QFormLayout& form) {
  auto* from_view =
      named(new QCheckBox(tr("Exposure as in the view"), this), "exposure_of_view",
            tr("Pictures are as bright as the view (+ and -). EXR files are never changed"));
  form.addRow({}, from_view);
  const auto set = [this](std::optional<double> stops, MergeId gesture = no_merge) {
    change_output(document_, tr("Set exposure of output"), gesture,
                  [stops](Output& output) { output.exposure = stops; });
  };
  connect(from_view, &QCheckBox::clicked, this, [this, set](bool on) {
    set(on ? std::nullopt : std::optional(std::clamp(exposure_(), -60.0, 60.0)));
  });
  add_number(form, tr("Exposure, stops"),
             {"output_exposure", domain::stops, ValueField::Scale::linear, 0.02,
              [this] { return output().exposure; },
              [set](double value, MergeId gesture) { set(value, gesture); }})
      ->setToolTip(tr("One stop more is twice as bright. Of PNG and MP4; shown by Khronos PBR "
                      "Neutral in sRGB"));
  on_refresh([this, from_view] { from_view->setChecked(!output().exposure); });
}

void OutputPanel::add_buttons(QFormLayout& form, QAction* render, QAction* render_animation) {
  auto* row = new QHBoxLayout;
  for (QAction* action : {render, render_animation}) {
    auto* button = named(new QPushButton(without_mnemonic(action->text()), this),
                         action->objectName() + "_button", action->toolTip());
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    row->addWidget(button);
  }
  form.addRow(row);
}

}  // namespace brume
