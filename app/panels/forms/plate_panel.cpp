#include "app/panels/forms/plate_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QImageReader>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QVariantMap>
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/commands/objects/edit_cameras.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "brume/error.h"
#include "core/io/frame_pattern.h"
#include "core/number_domain.h"

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

// The last file of a numbered sequence up to a frame, or its first one.
std::filesystem::path file_of_frame(const std::filesystem::path& file, int frame) {
  const auto files = FramePattern::around(file.string());
  if (!files) return file;
  const std::vector<int> numbers = files->frames();
  if (numbers.empty()) return file;
  const auto later = std::ranges::upper_bound(numbers, frame);
  return files->file_of(later == numbers.begin() ? *later : *std::prev(later));
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

}  // namespace

PlatePanel::PlatePanel(Document& document, std::function<QString()> camera, QWidget* parent)
    : SceneForm(document, parent), camera_(std::move(camera)) {
  auto* form = new_form(0);
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
         change([opacity](Plate& plate) { plate.opacity = opacity; });
       }})
      ->setToolTip(tr("0 shows the scene alone, 1 the plate alone"));
  auto* sequence = named(new QCheckBox(tr("Plate of each frame"), this), "plate_sequence",
                         tr("The picture is one of several, whose names differ in the number of "
                            "the frame: shows the last one up to the current frame"));
  form->addRow({}, sequence);
  auto* behind = named(new QCheckBox(tr("Behind the fog"), this), "plate_behind",
                       tr("The plate is seen through the fog, in place of the environment, and "
                          "where surfaces are held out (panel Surface)"));
  form->addRow({}, behind);
  connect(behind, &QCheckBox::clicked, this, [this](bool on) {
    change([on](Plate& plate) {
      plate.is_behind = on;
      if (on) plate.opacity = 1.0;
    });
  });
  connect(sequence, &QCheckBox::clicked, this,
          [this](bool on) { change([on](Plate& plate) { plate.is_sequence = on; }); });
  on_refresh([this, choose, remove, sequence, behind] {
    const QString file = plate().file;
    choose->setText(file.isEmpty() ? tr("Choose…") : to_qstring(to_path(file).filename()));
    choose->setToolTip(plain_tool_tip(
        file.isEmpty()
            ? tr("A photographed picture over the frame of the camera, or behind its fog, "
                 "to match the scene with. It is not rendered, and not saved with the "
                 "scene")
            : file));
    for (QWidget* widget : std::initializer_list<QWidget*>{remove, sequence, behind}) {
      widget->setEnabled(!file.isEmpty());
    }
    sequence->setChecked(plate().is_sequence);
    behind->setChecked(plate().is_behind);
  });
  on_change(document_, Change::scene, this, &PlatePanel::restore);
  on_change(document_, Change::file, this, &PlatePanel::store);
  // The stack tells once the document has its new revision.
  connect(&document_.undo_stack(), &QUndoStack::indexChanged, this, &PlatePanel::follow_cameras);
  const auto go_on = [this] {
    choices_.pop_front();
    read_next();
  };
  connect(&choosing_, &BackgroundJob::finished, this, go_on);
  connect(&choosing_, &BackgroundJob::failed, this, go_on);
  for (const BackgroundJob* job : {&reading_, &choosing_}) {
    connect(job, &BackgroundJob::failed, this, &PlatePanel::refused);
  }
  restore();
}

PlatePanel::CameraKey PlatePanel::key_of(const QString& camera) const {
  const auto known = since_.find(camera);
  if (known == since_.end()) return {camera, 0};
  const auto later = known->second.upper_bound(document_.revision());
  return {camera, later == known->second.begin() ? 0 : *std::prev(later)};
}

PlatePanel::CameraKey PlatePanel::in_use() const {
  return key_of(QString::fromStdString(document_.scene().camera_name));
}

PlatePanel::Plate PlatePanel::plate_of(const CameraKey& camera) const {
  const auto found = plates_.find(camera);
  return found == plates_.end() ? Plate() : found->second;
}

void PlatePanel::change(const std::function<void(Plate&)>& how) {
  how(plates_[camera()]);
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
    std::erase_if(choices_, [this](const Choice& choice) { return choice.camera == camera(); });
    read_next();
    return change([](Plate& plate) { plate = {}; });
  }
  choices_.push_back({camera(), std::filesystem::absolute(file)});
  if (choices_.size() == 1) read_next();
}

// Only a picture that can be read takes the place of another.
void PlatePanel::read_next() {
  choosing_.cancel();
  if (choices_.empty()) return;
  choosing_.start([this, file = choices_.front().file](const Job&) {
    return [this, file, picture = read_plate(file)] {
      const CameraKey chosen_for = choices_.front().camera;
      Plate& plate = plates_[chosen_for];
      plate.file = to_qstring(file);
      if (chosen_for == in_use()) {
        reading_.cancel();
        shown_ = {plate.file, -1};  // of a sequence it is another one
        picture_ = picture;
      }
      store();
      show_plate();
    };
  });
}

void PlatePanel::restore() {
  for (BackgroundJob* job : {&reading_, &choosing_}) job->cancel();
  choices_.clear();
  plates_.clear();
  since_.clear();
  shown_ = {};
  picture_ = {};
  last_revision_ = document_.revision();
  cameras_.clear();
  for (const QString& name : camera_names(document_.scene())) cameras_.push_back(key_of(name));
  const QString scene = to_qstring(document_.file());
  for (const QVariant& entry : QSettings().value(plates_key).toList()) {
    if (scene.isEmpty() || scene_of(entry) != scene) continue;
    const QVariantMap values = entry.toMap();
    const double opacity = values.value("opacity").toDouble();
    const bool is_allowed = domain::unit.contains(opacity);
    plates_[key_of(values.value("camera").toString())] = {
        values.value("picture").toString(), is_allowed ? opacity : Plate().opacity,
        values.value("sequence").toBool(), values.value("behind").toBool()};
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
    const auto found = plates_.find(key_of(camera));
    if (found == plates_.end() || found->second.file.isEmpty()) continue;
    entries.prepend(QVariantMap{{"scene", scene},
                                {"camera", camera},
                                {"picture", found->second.file},
                                {"opacity", found->second.opacity},
                                {"sequence", found->second.is_sequence},
                                {"behind", found->second.is_behind}});
  }
  settings.setValue(plates_key, QVariantList(entries.mid(0, max_plates)));
}

// A camera with another name keeps its plate, and one that is deleted until that is undone.
void PlatePanel::follow_cameras() {
  const bool is_new_state = document_.revision() > last_revision_;
  last_revision_ = std::max(last_revision_, document_.revision());
  QStringList previous_names;
  for (const CameraKey& key : cameras_) previous_names << key.first;
  const QStringList names = camera_names(document_.scene());
  if (names == previous_names) return;
  std::vector<CameraKey> cameras;
  for (const QString& name : names) {
    if (is_new_state && !previous_names.contains(name)) since_[name].insert(last_revision_);
    cameras.push_back(key_of(name));
  }
  for (const CameraKey& key : std::exchange(cameras_, cameras)) {
    const QString name = camera_name_after(previous_names, names, key.first);
    if (name.isEmpty() || name == key.first) continue;
    for (Choice& choice : choices_) {
      if (choice.camera == key) choice.camera = key_of(name);
    }
    auto plate = plates_.extract(key);
    if (!plate) continue;
    plate.key() = key_of(name);
    plates_.insert(std::move(plate));
  }
  store();
  show_plate();
}

void PlatePanel::show_frame(int frame) {
  frame_ = frame;
  if (plate_of(in_use()).is_sequence) show_plate();
}

void PlatePanel::show_plate() {
  const Plate shown = plate_of(in_use());
  const std::pair wanted(shown.file, shown.is_sequence ? frame_ : -1);
  // Frames that come while one is read are left out of playback.
  const bool is_same = wanted.first == shown_.first;
  if (wanted != shown_ && !(is_same && reading_.is_running())) {
    if (!is_same) picture_ = {};
    shown_ = wanted;
    reading_.cancel();
    if (!shown.file.isEmpty()) {
      reading_.start([this, file = to_path(shown.file), frame = wanted.second](const Job&) {
        const auto numbered = frame < 0 ? file : file_of_frame(file, frame);
        return [this, picture = read_plate(numbered)] {
          picture_ = picture;
          show_plate();
        };
      });
    }
  }
  refresh();
  Q_EMIT plate_changed(picture_, shown.opacity, shown.is_behind);
}

}  // namespace brume
