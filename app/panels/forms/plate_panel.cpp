#include "app/panels/forms/plate_panel.h"

#include <QFormLayout>
#include <QImageReader>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QVariantMap>
#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "brume/error.h"

namespace brume {
namespace {

constexpr const char* plates_key = "plates";
constexpr qsizetype max_plates = 100;  // in the settings; the oldest go
constexpr int max_plate_side = 4096;   // pixels; larger pictures are made smaller

QImage read_plate(const std::filesystem::path& file) {
  QImageReader reader(to_qstring(file));
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (std::max(size.width(), size.height()) > max_plate_side) {
    reader.setScaledSize(size.scaled(max_plate_side, max_plate_side, Qt::KeepAspectRatio));
  }
  QImage picture = reader.read();
  if (picture.isNull()) throw InputError(file, {}, reader.errorString().toStdString());
  return picture;
}

QString picture_filter() {
  QStringList patterns;
  for (const QByteArray& format : QImageReader::supportedImageFormats()) {
    patterns << "*." + QString::fromLatin1(format);
  }
  return PlatePanel::tr("Pictures (%1)").arg(patterns.join(' '));
}

QString scene_of(const QVariant& entry) {
  return entry.toMap().value("scene").toString();
}

QStringList camera_names(const Scene& scene) {
  QStringList names{QString::fromStdString(scene.camera_name)};
  for (const NamedCamera& camera : scene.cameras) names << QString::fromStdString(camera.name);
  return names;
}

}  // namespace

PlatePanel::PlatePanel(Document& document, QWidget* parent) : SceneForm(document, parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  auto* choose = named(new QPushButton(this), "plate_picture");
  auto* remove = named(new QToolButton(this), "plate_remove", tr("Removes the plate"));
  remove->setText(QStringLiteral("×"));
  form->addRow(tr("Plate"), row_of({choose, remove}));
  connect(choose, &QPushButton::clicked, this, &PlatePanel::choose);
  connect(remove, &QToolButton::clicked, this, [this] { set_picture({}); });
  add_number(
      *form, tr("Plate opacity"),
      {"plate_opacity", domain::unit, ValueField::Scale::linear, 0.005,
       [this] { return plate().file.isEmpty() ? std::nullopt : std::optional(plate().opacity); },
       [this](double opacity, MergeId) {
         set_plate({plate().file, opacity});
       }})
      ->setToolTip(tr("0 shows the scene alone, 1 the plate alone"));
  on_refresh([this, choose, remove] {
    const QString file = plate().file;
    choose->setText(file.isEmpty() ? tr("Choose…") : to_qstring(to_path(file).filename()));
    choose->setToolTip(plain_tool_tip(
        file.isEmpty() ? tr("A photographed picture over the frame of the camera, to match the "
                            "scene with. It is not rendered, and not saved with the scene")
                       : file));
    remove->setEnabled(!file.isEmpty());
  });
  on_change(document_, Change::scene, this, &PlatePanel::restore);
  on_change(document_, Change::file, this, &PlatePanel::store);
  on_change(document_, Change::part, this, &PlatePanel::follow_cameras);
  for (const BackgroundJob* job : {&reading_, &choosing_}) {
    connect(job, &BackgroundJob::failed, this, &PlatePanel::refused);
  }
  restore();
}

QString PlatePanel::camera_name() const {
  return QString::fromStdString(document_.scene().camera_name);
}

PlatePanel::Plate PlatePanel::plate() const {
  const auto found = plates_.find(camera_name());
  return found == plates_.end() ? Plate() : found->second;
}

void PlatePanel::set_plate(const Plate& plate) {
  plates_[camera_name()] = plate;
  store();
  show_plate();
}

void PlatePanel::choose() {
  const auto file =
      ask_for_file(this, FileKind::plate, tr("Plate"), picture_filter(), document_.folder());
  if (!file.empty()) set_picture(file);
}

void PlatePanel::set_picture(const std::filesystem::path& file) {
  if (file.empty()) {
    if (chosen_for_ == camera_name()) choosing_.cancel();
    return set_plate({});
  }
  // Only a picture that can be read takes the place of another.
  chosen_for_ = camera_name();
  choosing_.start([this, file = std::filesystem::absolute(file)](const Job&) {
    return [this, file, picture = read_plate(file)] {
      Plate& plate = plates_[chosen_for_];
      plate.file = to_qstring(file);
      if (chosen_for_ == camera_name()) {
        reading_.cancel();
        shown_ = plate.file;
        picture_ = picture;
      }
      store();
      show_plate();
    };
  });
}

void PlatePanel::restore() {
  for (BackgroundJob* job : {&reading_, &choosing_}) job->cancel();
  plates_.clear();
  shown_.clear();
  picture_ = {};
  cameras_ = camera_names(document_.scene());
  const QString scene = to_qstring(document_.file());
  for (const QVariant& entry : QSettings().value(plates_key).toList()) {
    if (scene.isEmpty() || scene_of(entry) != scene) continue;
    const QVariantMap values = entry.toMap();
    plates_[values.value("camera").toString()] = {values.value("picture").toString(),
                                                  values.value("opacity").toDouble()};
  }
  show_plate();
}

void PlatePanel::store() const {
  const QString scene = to_qstring(document_.file());
  if (scene.isEmpty()) return;
  QSettings settings;
  QVariantList entries = settings.value(plates_key).toList();
  entries.removeIf([&](const QVariant& entry) { return scene_of(entry) == scene; });
  for (const QString& camera : camera_names(document_.scene())) {
    const auto found = plates_.find(camera);
    if (found == plates_.end() || found->second.file.isEmpty()) continue;
    entries.prepend(QVariantMap{{"scene", scene},
                                {"camera", camera},
                                {"picture", found->second.file},
                                {"opacity", found->second.opacity}});
  }
  settings.setValue(plates_key, QVariantList(entries.mid(0, max_plates)));
}

// A camera with another name keeps its plate, and one that is deleted until it is added again.
void PlatePanel::follow_cameras() {
  const QStringList names = camera_names(document_.scene());
  if (names == cameras_) return;
  const QStringList previous = std::exchange(cameras_, names);
  for (qsizetype k = 0; names.size() == previous.size() && k < names.size(); ++k) {
    if (previous.contains(names[k]) || names.contains(previous[k])) continue;
    if (chosen_for_ == previous[k]) chosen_for_ = names[k];
    plates_.erase(names[k]);  // of a deleted camera
    auto plate = plates_.extract(previous[k]);
    if (!plate) continue;
    plate.key() = names[k];
    plates_.insert(std::move(plate));
  }
  store();
  show_plate();
}

void PlatePanel::show_plate() {
  const Plate shown = plate();
  if (shown.file != shown_) {
    shown_ = shown.file;
    picture_ = {};
    reading_.cancel();
    if (!shown_.isEmpty()) {
      reading_.start([this, file = to_path(shown_)](const Job&) {
        return [this, picture = read_plate(file)] {
          picture_ = picture;
          show_plate();
        };
      });
    }
  }
  refresh();
  Q_EMIT plate_changed(picture_, shown.opacity);
}

}  // namespace brume
