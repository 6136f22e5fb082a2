#include "app/assets/asset_panel.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "app/assets/save_asset.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/private_files.h"
#include "app/files/file_dialogs.h"
#include "app/tools/tool_box.h"
#include "app/widgets/icons.h"
#include "app/widgets/keys.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "brume/error.h"

namespace brume {
namespace {

constexpr QSize icon_size{84, 56};
constexpr int file_role = Qt::UserRole;

struct KindText {
  AssetKind kind;
  const char* list;  // in the list of kinds
  const char* save;  // in the menu that saves one; null: none is saved
  const char* icon;
};
constexpr std::array kind_texts{
    KindText{AssetKind::surface, QT_TR_NOOP("Surfaces"), QT_TR_NOOP("Surface “%1”…"), "box"},
    KindText{AssetKind::fog, QT_TR_NOOP("Fog"), QT_TR_NOOP("Selected Fog “%1”…"), "emitter"},
    KindText{AssetKind::light, QT_TR_NOOP("Lights"), QT_TR_NOOP("Light “%1”…"), "light"},
    KindText{AssetKind::camera, QT_TR_NOOP("Cameras"), QT_TR_NOOP("Camera “%1”…"), "camera"},
    KindText{AssetKind::brush, QT_TR_NOOP("Brushes"), QT_TR_NOOP("Brush “%1”…"), "paintbrush"},
    KindText{AssetKind::scene, QT_TR_NOOP("Scenes"), nullptr, "box"}};

const KindText& text_of(AssetKind kind) {
  return kind_texts.at(static_cast<std::size_t>(kind));
}

// Drags the file of an asset.
class AssetList : public QListWidget {
 public:
  using QListWidget::QListWidget;

 protected:
  // Says how assets come here, where none is shown.
  void paintEvent(QPaintEvent* event) override {
    QListWidget::paintEvent(event);
    for (int row = 0; row < count(); ++row) {
      if (!item(row)->isHidden()) return;
    }
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QString text = count() == 0
                             ? AssetPanel::tr(
                                   "No assets yet. Save what is selected, or put meshes, volumes "
                                   "and scenes into the folder.")
                             : AssetPanel::tr("No asset is of this kind and has this in its name.");
    painter.drawText(viewport()->rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     text);
  }
  [[nodiscard]] QStringList mimeTypes() const override { return {asset_mime}; }
  [[nodiscard]] QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override {
    if (items.isEmpty()) return nullptr;
    auto* dragged = new QMimeData;
    dragged->setData(asset_mime, items.front()->data(file_role).toString().toUtf8());
    return dragged;
  }
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }
};

}  // namespace

AssetPanel::AssetPanel(Document& document, const ToolBox& tools, QWidget* parent)
    : QWidget(parent), document_(document), tools_(tools) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 0, 4, 0);
  layout->setSpacing(2);
  layout->addWidget(new_head());
  layout->addWidget(list_ = new_list(), 1);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &AssetPanel::find);
  connect(&pictures_, &AssetPictures::made, this, [this](std::size_t asset, const QImage& picture) {
    QListWidgetItem* item = list_->item(static_cast<int>(asset));
    if (item) item->setIcon(QPixmap::fromImage(picture));
  });
  on_change(document_, Change::scene | Change::file, this, &AssetPanel::find);
}

// Folders that are new have not been watched.
void AssetPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  find();
}

void AssetPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  finding_.cancel();
  pictures_.cancel();
}

QWidget* AssetPanel::new_head() {
  auto* head = new QWidget(this);
  filter_ = named(new QLineEdit(head), "asset_filter", tr("Shows assets whose names have this"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  connect(filter_, &QLineEdit::textChanged, this, &AssetPanel::filter);
  kinds_ = named(new QComboBox(head), "asset_kinds", tr("The kind of assets that are shown"));
  kinds_->addItem(tr("All"), -1);
  for (const KindText& text : kind_texts) {
    kinds_->addItem(tr(text.list), static_cast<int>(text.kind));
  }
  connect(kinds_, &QComboBox::currentIndexChanged, this, &AssetPanel::filter);
  auto* save = named(new QToolButton(head), "asset_save",
                     tr("Saves what is selected, the camera or the brush as an asset"));
  save->setText(tr("Save"));
  save->setPopupMode(QToolButton::InstantPopup);
  auto* menu = named(new QMenu(save), "asset_save_menu");
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill_save_menu(*menu); });
  save->setMenu(menu);
  auto* folder = named(new QToolButton(head), "asset_folder",
                       tr("Opens your folder of assets. What is put into it is listed here, and so "
                          "is the folder “assets” beside the scene"));
  folder->setText(tr("Folder"));
  connect(folder, &QToolButton::clicked, this, [] {
    QDesktopServices::openUrl(
        QUrl::fromLocalFile(to_qstring(make_private_folder(user_asset_folder()))));
  });
  auto* row = row_of({filter_, kinds_, save, folder});
  row->setContentsMargins(0, 0, 0, 0);
  head->setLayout(row);
  return head;
}

QListWidget* AssetPanel::new_list() {
  auto* list = named(new AssetList(this), "assets",
                     tr("Drag an asset into a view: it lands on what is under the mouse"));
  list->setAccessibleName(tr("Assets"));
  list->setViewMode(QListView::IconMode);
  list->setMovement(QListView::Static);
  list->setResizeMode(QListView::Adjust);
  list->setIconSize(icon_size);
  list->setUniformItemSizes(true);
  list->setMinimumHeight(icon_size.height() / 2);
  list->setGridSize({icon_size.width() + 16, icon_size.height() + 28});
  list->setTextElideMode(Qt::ElideMiddle);
  list->setDragEnabled(true);
  list->setDragDropMode(QAbstractItemView::DragOnly);
  list->setContextMenuPolicy(Qt::CustomContextMenu);
  const auto add = [this](QListWidgetItem* item) {
    if (const Asset* asset = asset_of(item)) Q_EMIT add_asked(asset->file);
  };
  connect(list, &QListWidget::itemActivated, this, add);
  connect(list, &QWidget::customContextMenuRequested, this, &AssetPanel::show_menu);
  return list;
}

const Asset* AssetPanel::asset_of(const QListWidgetItem* item) const {
  if (!item) return nullptr;
  return &assets_.at(static_cast<std::size_t>(list_->row(item)));
}

void AssetPanel::show_menu(const QPoint& position) {
  const Asset* asset = asset_of(list_->itemAt(position));
  if (!asset) return;
  auto* menu = named(new QMenu(this), "asset_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const std::filesystem::path file = asset->file;
  menu->addAction(asset->kind == AssetKind::brush ? tr("Use") : tr("Add"), this,
                  [this, file] { Q_EMIT add_asked(file); });
  menu->addAction(tr("Show in Its Folder"), this, [file] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(to_qstring(file.parent_path())));
  });
  menu->addAction(tr("Move to the Trash"), this, [this, file] {
    if (!QFile::moveToTrash(to_qstring(file))) {
      Q_EMIT refused(tr("%1 cannot be moved to the trash").arg(to_qstring(file.filename())));
    }
    find();
  });
  menu->popup(list_->viewport()->mapToGlobal(position));
}

void AssetPanel::fill_save_menu(QMenu& menu) {
  menu.clear();
  for (const KindText& text : kind_texts) {
    if (!text.save) continue;
    const auto chosen = chosen_name(document_, tools_, text.kind);
    if (!chosen) continue;
    menu.addAction(tr(text.save).arg(QString(*chosen).replace('&', "&&")), this,
                   [this, kind = text.kind] { save_chosen(kind); });
  }
}

std::optional<AssetKind> AssetPanel::chosen_kind() const {
  if (const auto& object = document_.object()) {
    if (object->kind == ObjectRef::Kind::light) return AssetKind::light;
    if (object->kind == ObjectRef::Kind::surface) return AssetKind::surface;
    return std::nullopt;
  }
  for (const AssetKind kind : {AssetKind::fog, AssetKind::brush}) {
    if (chosen_name(document_, tools_, kind)) return kind;
  }
  return AssetKind::camera;
}

void AssetPanel::save_chosen() {
  if (const auto kind = chosen_kind()) return save_chosen(*kind);
  Q_EMIT told(tr("An emitter cannot be saved as an asset"));
}

void AssetPanel::save_chosen(AssetKind kind) {
  const auto chosen = chosen_name(document_, tools_, kind);
  if (!chosen) return;
  const QString extension = QString::fromStdString(asset_extension(kind));
  const QString folder =
      last_folder(FileKind::asset, to_qstring(make_private_folder(user_asset_folder())));
  const QString start = folder + '/' + QString(*chosen).replace('/', '-') + extension;
  const QString wanted = QFileDialog::getSaveFileName(this, tr("Save as Asset"), start,
                                                      tr("Assets (*%1)").arg(extension));
  if (wanted.isEmpty()) return;
  const std::filesystem::path file = asset_file(to_path(wanted), kind);
  // The dialog has asked about the name that it was given.
  if (file != to_path(wanted) && !may_replace(this, file, std::nullopt)) return;
  remember_folder(FileKind::asset, file);
  save_chosen(kind, file);
}

void AssetPanel::save_chosen(AssetKind kind, const std::filesystem::path& file) {
  if (!chosen_name(document_, tools_, kind)) return;
  try {
    save_asset(document_, tools_, kind, file);
    Q_EMIT told(tr("Saved as the asset %1").arg(asset_name(file)));
  } catch (const InputError& error) {
    Q_EMIT refused(QString::fromUtf8(error.what()));
  }
  find();
}

void AssetPanel::find() {
  if (!isVisible()) return;
  std::vector<std::filesystem::path> folders;
  if (!document_.file().empty()) folders.push_back(scene_asset_folder(document_.file()));
  folders.push_back(user_asset_folder());
  if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) watcher_.addPath(to_qstring(folder));
  }
  finding_.start([this, folders](const Job& job) -> BackgroundJob::Apply {
    std::vector<Asset> all;
    for (const std::filesystem::path& folder : folders) {
      const std::vector<Asset> found = find_assets(folder, job.stop);
      all.insert(all.end(), found.begin(), found.end());
    }
    return [this, all] { show_assets(all); };
  });
}

void AssetPanel::show_assets(const std::vector<Asset>& assets) {
  assets_ = assets;
  list_->clear();
  std::array<QIcon, kind_texts.size()> icons;
  std::ranges::transform(kind_texts, icons.begin(),
                         [](const KindText& text) { return load_icon(text.icon); });
  for (const Asset& asset : assets_) {
    const KindText& text = text_of(asset.kind);
    auto* item = new QListWidgetItem(icons.at(static_cast<std::size_t>(asset.kind)),
                                     asset_name(asset.file), list_);
    item->setData(file_role, to_qstring(asset.file));
    item->setToolTip(plain_tool_tip(tr("%1: %2").arg(tr(text.list), to_qstring(asset.file))));
  }
  filter();
  pictures_.make(assets_);
}

void AssetPanel::filter() {
  const int kind = kinds_->currentData().toInt();
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    const Asset& asset = assets_[static_cast<std::size_t>(row)];
    const bool suits = (kind < 0 || static_cast<int>(asset.kind) == kind) &&
                       item->text().contains(filter_->text().trimmed(), Qt::CaseInsensitive);
    item->setHidden(!suits);
  }
}

}  // namespace brume
