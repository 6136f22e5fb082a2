#pragma once

#include <filesystem>

#include "app/panels/forms/scene_form.h"

class QAction;
class QCheckBox;
class QComboBox;

namespace brume {

class Timeline;
struct Output;
struct Playback;

// Output to files: size, method, frames, format, layers and colour. It belongs to the scene, but
// for the bits of a PNG, which are a setting, and whether the view is rendered.
class OutputPanel : public SceneForm {
  Q_OBJECT
 public:
  // `exposure`: of the view, in stops. The actions render one frame and all of them.
  OutputPanel(Document& document, const Timeline& timeline, std::function<double()> exposure,
              QAction* render, QAction* render_animation, QWidget* parent);

  // The view is rendered in place of what the scene's camera sees.
  [[nodiscard]] bool renders_view() const;
  [[nodiscard]] int png_bits() const;  // of each value

 Q_SIGNALS:
  void clear_region_asked_for();

 public Q_SLOTS:
  // The part of the picture that is rendered; empty: all of it.
  void show_region(const QString& text);

 private:
  [[nodiscard]] QComboBox* new_format();
  void add_bits(QFormLayout& form);
  void add_view(QFormLayout& form);
  void add_size(QFormLayout& form);
  void add_region(QFormLayout& form);
  void add_method(QFormLayout& form);
  void add_samples(QFormLayout& form);
  void add_shutter(QFormLayout& form);
  void add_frames(QFormLayout& form);
  void add_file(QFormLayout& form);
  void add_layers(QFormLayout& form);
  void add_exposure(QFormLayout& form);
  void add_buttons(QFormLayout& form, QAction* render, QAction* render_animation);
  void set_side(bool is_width, double pixels, MergeId gesture);
  void set_playback(const Playback& playback);
  void set_file(std::filesystem::path file);
  void browse();
  [[nodiscard]] const Output& output() const;

  const Timeline& timeline_;
  std::function<double()> exposure_;
  bool locks_aspect_ = false;
  double aspect_ = 1.0;  // width over height, if it is locked
  QWidget* region_ = nullptr;
  QComboBox* bits_ = nullptr;
  QCheckBox* from_view_ = nullptr;
};

}  // namespace brume
