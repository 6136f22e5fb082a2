#include "app/files/recent_pictures.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QMenu>
#include <QPixmap>
#include <QStandardPaths>

#include "app/document/paths.h"
#include "app/document/private_files.h"
#include "app/widgets/editor_style.h"
#include "brume/error.h"

namespace brume {
namespace {

constexpr QSize menu_size{96, 64};
constexpr QSize picture_size{336, 224};  // enough for the start page on screens with fine pixels

class LargeIcons : public EditorStyle {
 public:
  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    return metric == PM_SmallIconSize ? menu_size.width()
                                      : EditorStyle::pixelMetric(metric, option, widget);
  }
};

QString picture_file(const std::filesystem::path& scene) {
  const QByteArray name = to_qstring(scene).toUtf8();
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/recent/" +
         QCryptographicHash::hash(name, QCryptographicHash::Sha1).toHex() + ".png";
}

}  // namespace

void save_recent_picture(const std::filesystem::path& scene, const QImage& picture) {
  const QString file = picture_file(scene);
  const QImage large =
      picture.scaled(picture_size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QPoint corner((large.width() - picture_size.width()) / 2,
                      (large.height() - picture_size.height()) / 2);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QImage cut = large.copy(QRect(corner, picture_size));
  for (const QString& key : picture.textKeys()) cut.setText(key, picture.text(key));
  cut.save(&buffer, "PNG");
  try {
    make_private_folder(to_path(file).parent_path());
    write_private(to_path(file), std::string_view(bytes.constData(), bytes.size()));
  } catch (const InputError&) {
    // A cache: where nothing can be written, there is no picture, and that is all.
  }
}

QIcon recent_picture(const std::filesystem::path& scene) {
  const QImage picture = recent_image(scene);
  return picture.isNull() ? QIcon() : QIcon(QPixmap::fromImage(picture));
}

QImage recent_image(const std::filesystem::path& scene) {
  return QImage(picture_file(scene));
}

void show_large_icons(QMenu& menu) {
  auto* style = new LargeIcons;
  style->setParent(&menu);
  menu.setStyle(style);
}

}  // namespace brume
