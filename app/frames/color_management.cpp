#include "app/frames/color_management.h"

#include <QSettings>
#include <utility>

#include "brume/error.h"

namespace brume {
namespace {

constexpr const char* config_key = "color/config";
constexpr const char* display_key = "color/display";
constexpr const char* view_key = "color/view";  // empty: Brume's own

std::string setting(const char* key) {
  return QSettings().value(key).toString().toStdString();
}

}  // namespace

ColorManagement::ColorManagement(QObject* parent) : QObject(parent), config_(setting(config_key)) {
  const std::string view = setting(view_key);
  if (view.empty()) return;
  try {
    view_ = std::make_shared<const ColorView>(ColorChoice{config(), setting(display_key), view});
  } catch (const InputError&) {
    config_.clear();  // the file is gone, or another
  }
}

void ColorManagement::choose(const std::optional<ColorChoice>& choice) {
  std::shared_ptr<const ColorView> chosen;
  if (choice) chosen = std::make_shared<const ColorView>(*choice);
  view_ = std::move(chosen);
  if (view_) config_ = view_->choice().config;
  QSettings settings;
  settings.setValue(config_key, QString::fromStdString(config_));
  settings.setValue(display_key, view_ ? QString::fromStdString(view_->choice().display) : "");
  settings.setValue(view_key, view_ ? QString::fromStdString(view_->choice().view) : "");
  Q_EMIT view_changed();
}

std::string ColorManagement::config() const {
  return config_.empty() ? default_color_config() : config_;
}

void ColorManagement::set_config(const std::string& config) {
  choose(ColorChoice{config, {}, {}});
}

}  // namespace brume
