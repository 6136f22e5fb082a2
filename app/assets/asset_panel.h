#pragma once

#include <QFileSystemWatcher>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/assets/asset_pictures.h"

class QComboBox;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QMenu;

namespace brume {

class Document;
class ToolBox;

// The files of the asset library: those in the user's folder, and in the folder beside the scene.
// They are dragged into a view, or added by Enter and a double click; what is chosen in the scene
// is saved as one.
class AssetPanel : public QWidget {
  Q_OBJECT
 public:
  AssetPanel(Document& document, const ToolBox& tools, QWidget* parent);

  // Ask for a file. The first saves what chosen_kind() says.
  void save_chosen();
  void save_chosen(AssetKind kind);
  void save_chosen(AssetKind kind, const std::filesystem::path& file);
  // The kind that "Save as Asset" means: that of the chosen object, else of the selected Gaussians,
  // else of the brush, else of the camera. Nullopt: the object is of a kind that is not saved.
  [[nodiscard]] std::optional<AssetKind> chosen_kind() const;

 Q_SIGNALS:
  void add_asked(const std::filesystem::path& file);
  void told(const QString& text);
  void refused(const QString& problem);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* new_head();
  QListWidget* new_list();
  void fill_save_menu(QMenu& menu);
  void show_menu(const QPoint& position);
  void find();  // in the background; only what is seen is worth it
  void show_assets(const std::vector<Asset>& assets);
  void filter();
  [[nodiscard]] const Asset* asset_of(const QListWidgetItem* item) const;

  Document& document_;
  const ToolBox& tools_;
  QLineEdit* filter_;
  QComboBox* kinds_;
  QListWidget* list_;
  std::vector<Asset> assets_;
  QFileSystemWatcher watcher_;
  AssetPictures pictures_;
  BackgroundJob finding_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
