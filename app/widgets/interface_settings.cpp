#include "app/widgets/interface_settings.h"

#include <QColor>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/document/text/number_text.h"
#include "app/widgets/color_button.h"

namespace brume {
namespace {

constexpr const char* unit_key = "display/length_unit";
constexpr const char* colors_key = "display/color_numbers";
constexpr const char* handles_key = "display/handle_scale";
constexpr double max_handle_scale = 3.0;
constexpr const char* language_key = "interface/language";
constexpr const char* scale_key = "interface/scale";
constexpr const char* undo_key = "interface/undo_limit";
constexpr const char* frames_key = "interface/frame_memory_mb";
constexpr int default_frame_memory = 512;

// The codes, in the order of the enumeration.
constexpr std::array languages{"", "en", "de"};

Language language_of(const QString& code) {
  const auto* found = std::ranges::find(languages, code);
  return found == languages.end() ? Language::system
                                  : static_cast<Language>(found - languages.begin());
}

// Values that are not numbers, or not finite, are 0.
double number_of(const QVariant& value) {
  const double number = value.toDouble();
  return std::isfinite(number) ? number : 0.0;
}

double clamped_scale(double scale) {
  return scale == 0.0 ? 0.0
                      : std::clamp(scale, InterfaceSettings::min_interface_scale,
                                   InterfaceSettings::max_interface_scale);
}

int clamped(double value, int low, int high) {
  return static_cast<int>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

int clamped_undo_limit(double steps) {
  return steps == 0.0
             ? 0
             : clamped(steps, InterfaceSettings::min_undo_limit, InterfaceSettings::max_undo_limit);
}

int clamped_frame_memory(double megabytes) {
  return clamped(megabytes, InterfaceSettings::min_frame_memory,
                 InterfaceSettings::max_frame_memory);
}

}  // namespace

double handle_scale_of(double dots_per_inch) {
  constexpr double usual = 96.0;
  return std::clamp(std::round(4.0 * dots_per_inch / usual) / 4.0, 1.0, max_handle_scale);
}

InterfaceSettings& InterfaceSettings::instance() {
  static InterfaceSettings settings;
  return settings;
}

void InterfaceSettings::load() {
  const QSettings settings;
  length_unit_ = settings.value(unit_key).toString().left(max_unit_length);
  color_numbers_ =
      settings.value(colors_key) == "linear" ? ColorNumbers::linear : ColorNumbers::srgb;
  const double scale = settings.value(handles_key).toDouble();
  chosen_handle_scale_ = scale >= 1.0 && scale <= max_handle_scale ? scale : 0.0;
  language_ = language_of(settings.value(language_key).toString());
  interface_scale_ = clamped_scale(number_of(settings.value(scale_key)));
  undo_limit_ = clamped_undo_limit(number_of(settings.value(undo_key)));
  frame_memory_ = clamped_frame_memory(number_of(settings.value(frames_key, default_frame_memory)));
  update_handle_scale();
  Q_EMIT changed();
}

void InterfaceSettings::store(const char* key, const QVariant& value) {
  QSettings().setValue(key, value);
  Q_EMIT changed();
}

void InterfaceSettings::set_language(Language language) {
  language_ = language;
  store(language_key, languages.at(static_cast<std::size_t>(language)));
}

void InterfaceSettings::set_interface_scale(double scale) {
  interface_scale_ = clamped_scale(scale);
  store(scale_key, interface_scale_);
}

void InterfaceSettings::set_undo_limit(int steps) {
  undo_limit_ = clamped_undo_limit(steps);
  store(undo_key, undo_limit_);
}

void InterfaceSettings::set_frame_memory(int megabytes) {
  frame_memory_ = clamped_frame_memory(megabytes);
  store(frames_key, frame_memory_);
}

void InterfaceSettings::set_length_unit(const QString& unit) {
  length_unit_ = unit.simplified().left(max_unit_length);
  store(unit_key, length_unit_);
}

void InterfaceSettings::set_color_numbers(ColorNumbers numbers) {
  color_numbers_ = numbers;
  store(colors_key, numbers == ColorNumbers::linear ? "linear" : "srgb");
}

void InterfaceSettings::set_handle_scale(double scale) {
  chosen_handle_scale_ = scale;
  update_handle_scale();
  store(handles_key, scale);
}

void InterfaceSettings::update_handle_scale() {
  const QScreen* screen = QGuiApplication::primaryScreen();
  const double by_screen = screen ? handle_scale_of(screen->logicalDotsPerInch()) : 1.0;
  handle_scale_ = chosen_handle_scale_ > 0.0 ? chosen_handle_scale_ : by_screen;
}

QString color_numbers_text(const glm::dvec3& linear) {
  if (InterfaceSettings::instance().color_numbers() == InterfaceSettings::ColorNumbers::linear) {
    return QCoreApplication::translate("InterfaceSettings", "linear %1, %2, %3")
        .arg(number_text(linear.r, 3), number_text(linear.g, 3), number_text(linear.b, 3));
  }
  const QColor color = to_color(linear);
  return QCoreApplication::translate("InterfaceSettings", "sRGB %1, %2, %3")
      .arg(color.red())
      .arg(color.green())
      .arg(color.blue());
}

}  // namespace brume
