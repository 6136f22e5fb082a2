#pragma once

#include <QObject>
#include <QString>
#include <glm/vec3.hpp>

class QScreen;

namespace brume {

// Languages of the interface; `system`: that of the desktop where there is a translation.
enum class Language { system, english, german };

// How the editor looks and works, by the user's choice; kept for later sessions. Nothing of it
// changes a scene.
class InterfaceSettings : public QObject {
  Q_OBJECT
 public:
  static InterfaceSettings& instance();
  void load();  // what is stored

  // Shown behind lengths, which it does not scale; empty: nothing.
  [[nodiscard]] const QString& length_unit() const { return length_unit_; }
  void set_length_unit(const QString& unit);
  static constexpr int max_unit_length = 8;

  // The numbers of colours.
  enum class ColorNumbers { srgb, linear };
  [[nodiscard]] ColorNumbers color_numbers() const { return color_numbers_; }
  void set_color_numbers(ColorNumbers numbers);

  // Size of handles and lines in the views, 1 to 3; 0: by the screen.
  [[nodiscard]] double chosen_handle_scale() const { return chosen_handle_scale_; }
  void set_handle_scale(double scale);
  [[nodiscard]] double handle_scale() const { return handle_scale_; }

  // The language, and the scale of letters and widgets (0: by the screen), from the next start on.
  [[nodiscard]] Language language() const { return language_; }
  void set_language(Language language);
  static constexpr double min_interface_scale = 0.5;
  static constexpr double max_interface_scale = 3.0;
  [[nodiscard]] double interface_scale() const { return interface_scale_; }
  void set_interface_scale(double scale);

  // The number of steps that can be undone; 0: all.
  static constexpr int min_undo_limit = 10;
  static constexpr int max_undo_limit = 100'000;
  [[nodiscard]] int undo_limit() const { return undo_limit_; }
  void set_undo_limit(int steps);

  // Memory for the frames of an animation that have been played [MB].
  static constexpr int min_frame_memory = 16;
  static constexpr int max_frame_memory = 65'536;
  [[nodiscard]] int frame_memory() const { return frame_memory_; }
  void set_frame_memory(int megabytes);

 Q_SIGNALS:
  void changed();

 private:
  InterfaceSettings() { load(); }
  void store(const char* key, const QVariant& value);
  void update_handle_scale();

  QString length_unit_;
  ColorNumbers color_numbers_ = ColorNumbers::srgb;
  double chosen_handle_scale_ = 0.0;
  double handle_scale_ = 1.0;
  Language language_ = Language::system;
  double interface_scale_ = 0.0;
  int undo_limit_ = 0;
  int frame_memory_ = 512;
};

// For a screen whose density the window system does not scale for itself: 1 to 3, in quarters.
double handle_scale_of(double dots_per_inch);

// The factor by which handles, the lines of overlays, and the distances at which they are picked
// are multiplied by.
inline double handle_scale() {
  return InterfaceSettings::instance().handle_scale();
}

// The numbers of a colour, linear RGB, as chosen: "sRGB 188, 124, 89", "linear 0.5, 0.2, 0.1".
QString color_numbers_text(const glm::dvec3& linear);

}  // namespace brume
