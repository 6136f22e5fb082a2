#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "render/display/color_view.h"

namespace brume {

// The view transform of all views, and of what is exported to be shown. Kept in the settings.
class ColorManagement : public QObject {
  Q_OBJECT
 public:
  // Takes the choice of the settings; Brume's own view if that cannot be used any more.
  explicit ColorManagement(QObject* parent = nullptr);

  [[nodiscard]] const std::shared_ptr<const ColorView>& view() const { return view_; }
  // Nullopt: Brume's own view. Throws InputError, and keeps the one before.
  void choose(const std::optional<ColorChoice>& choice);

  // The configuration of which displays and views are offered: the last one chosen, else
  // default_color_config().
  [[nodiscard]] std::string config() const;
  // Throws InputError.
  void set_config(const std::string& config);

 Q_SIGNALS:
  void view_changed();

 private:
  std::shared_ptr<const ColorView> view_;  // null: Brume's own
  std::string config_;                     // empty: the default
};

}  // namespace brume
