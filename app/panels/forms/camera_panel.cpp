#include "app/panels/forms/camera_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string_view>
#include <utility>

#include "app/commands/objects/edit_cameras.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/text/words.h"
#include "app/panels/forms/plate_panel.h"
#include "app/widgets/keys.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/rows.h"
#include "core/number_domain.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/camera_fields.h"

namespace brume {
namespace {

constexpr int name_role = Qt::UserRole;
constexpr int list_rows = 4;
constexpr const char* film_back_key = "camera/film_back";
constexpr NumberDomain focal_lengths{0.1, 10000.0, "a number from 0.1 to 10000 mm"};

}  // namespace

CameraPanel::CameraPanel(Document& document, std::function<Camera()> view, QWidget* parent)
    : SceneForm(document, parent),
      view_(std::move(view)),
      list_(named(new QListWidget(this), "cameras")),
      film_back_(QSettings().value(film_back_key, sensor_width).toDouble()) {
  on_refresh([this] { follow_names(); });
  auto* form = new_form();
  form->addRow(new_list());
  form->addRow(new_buttons());
  auto* toggles = new QWidget(this);
  toggles_ = new QVBoxLayout(toggles);
  toggles_->setContentsMargins(0, 0, 0, 0);
  form->addRow(toggles);
  plate_ = new PlatePanel(
      document, [this] { return name(); }, this);
  form->addRow(plate_);
  connect(plate_, &PlatePanel::plate_changed, this, &CameraPanel::plate_changed);
  add_values(*form);
  on_refresh([this] { show_cameras(); });
  refresh();
}

QWidget* CameraPanel::new_list() {
  list_->setToolTip(
      tr("The scene's cameras. That in use, in bold, is rendered. A click shows the values of one, "
         "Enter uses it, a double click or F2 renames it"));
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setFixedHeight(list_rows * list_->fontMetrics().lineSpacing() + 16);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item && !is_changing_) show_camera(item->data(name_role).toString());
  });
  on_delete_key(*list_, [this] {
    if (const QListWidgetItem* item = list_->currentItem()) {
      delete_camera(document_, item->data(name_role).toString());
    }
  });
  connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
    if (!list_->isPersistentEditorOpen(item)) {
      use_camera(document_, item->data(name_role).toString());
    }
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (is_changing_) return;
    is_changing_ = true;
    rename_camera(document_, item->data(name_role).toString(), item->text());
    is_changing_ = false;
    // Later: the editor of the name is still open.
    QMetaObject::invokeMethod(this, &CameraPanel::show_cameras, Qt::QueuedConnection);
  });
  return list_;
}

QWidget* CameraPanel::new_buttons() {
  auto* buttons = new QWidget(this);
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto react) {
    auto* button = named(new QPushButton(text, this), name, tip);
    connect(button, &QPushButton::clicked, this, react);
    row->addWidget(button);
    return button;
  };
  add(tr("Add from View"), "add_camera", tr("Adds a camera that sees what the view sees"), [this] {
    if (add_camera(document_, view_())) show_camera({});
  });
  QPushButton* use = add(tr("Use"), "use_camera", tr("Uses it: it is what is rendered"),
                         [this] { use_camera(document_, name()); });
  add(tr("Look Through"), "look_through_camera", tr("Uses it, and shows what it sees (0)"), [this] {
    use_camera(document_, name());
    Q_EMIT look_through_asked_for();
  });
  QPushButton* remove = add(tr("Delete"), "delete_camera", tr("Deletes the camera"),
                            [this] { delete_camera(document_, name()); });
  on_refresh([this, use, remove] {
    use->setEnabled(!chosen_.isEmpty());
    remove->setEnabled(!document_.scene().cameras.empty());
  });
  return buttons;
}

void CameraPanel::add_toggle(QAction* action) {
  auto* box = named(new QCheckBox(without_mnemonic(action->text()), this),
                    action->objectName() + "_box", action->toolTip());
  box->setChecked(action->isChecked());
  connect(box, &QCheckBox::toggled, action, [action](bool on) {
    if (action->isChecked() != on) action->trigger();
  });
  connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
  toggles_->addWidget(box);
}

void CameraPanel::add_values(QFormLayout& form) {
  const Fields<Camera> values{
      .prefix = "camera_",
      .get = [this] { return &camera(); },
      .set = std::bind_front(&CameraPanel::set_field, this),
      .track =
          [this](const Scene& scene, const FieldInfo& info) {
            if (chosen_.isEmpty()) return value_track<KeyedCamera>(scene, info.name);
            const auto found =
                std::ranges::find(scene.cameras, chosen_.toStdString(), &NamedCamera::name);
            return value_track<Cameras>(scene, info.name,
                                        static_cast<std::size_t>(found - scene.cameras.begin()));
          }};
  visit_fields<Camera>([&](const auto& field) {
    const std::string_view name = field.info.name;
    if (name == "vertical_fov") {
      add_projection(form);
      add_film_backs(form);
      add_lenses(form);
      add_focal_length(form);
    }
    if (name == "focus_distance") add_focus(form);
    add_field(form, field, values);
  });
}

void CameraPanel::set_field(const Camera& camera, const FieldInfo& info, MergeId gesture) {
  if (const auto why = refusal(camera)) {
    Q_EMIT refused(field_label(info) + ": " + why->message);
    return refresh();
  }
  set_camera(camera, in_sentence(field_label(info)), gesture);
}

void CameraPanel::set_camera(const Camera& camera, const QString& what, MergeId gesture) {
  brume::set_camera(document_, name(), camera, what, gesture);
}

void CameraPanel::add_projection(QFormLayout& form) {
  auto* projection = named(new QComboBox(this), "camera_projection");
  projection->addItems({tr("Perspective"), tr("Orthographic")});
  projection->setToolTip(
      tr("Perspective: nearer things look larger, as through a lens. Orthographic: rays are "
         "parallel, as on a map or a plan. Both show as much at what the camera looks at"));
  form.addRow(tr("Projection"), projection);
  connect(projection, &QComboBox::activated, this, [this](int index) {
    if (camera().height.has_value() == (index == 1)) return;
    set_camera(index == 1 ? orthographic(camera()) : perspective(camera()), tr("projection"),
               no_merge);
  });
  on_refresh([this, projection] { projection->setCurrentIndex(camera().height ? 1 : 0); });
}

// The same picture takes a shorter lens before a smaller film back.
void CameraPanel::add_film_backs(QFormLayout& form) {
  struct FilmBack {
    double width;  // [mm]
    const char* name;
  };
  static constexpr auto film_backs =
      std::to_array<FilmBack>({{sensor_width, QT_TR_NOOP("36 mm, full frame")},
                               {52.48, QT_TR_NOOP("52.48 mm, 65 mm film")},
                               {43.8, QT_TR_NOOP("43.8 mm, medium format")},
                               {24.89, QT_TR_NOOP("24.89 mm, Super 35")},
                               {23.6, QT_TR_NOOP("23.6 mm, APS-C")},
                               {17.3, QT_TR_NOOP("17.3 mm, Four Thirds")},
                               {13.2, QT_TR_NOOP("13.2 mm, 1 inch")},
                               {12.52, QT_TR_NOOP("12.52 mm, Super 16")}});
  auto* box = named(new QComboBox(this), "camera_film_back",
                    tr("Width of the sensor or film that focal lengths are before. The picture "
                       "stays; it is a setting of yours, not of the scene"));
  for (const FilmBack& back : film_backs) box->addItem(tr(back.name));
  const auto* found = std::ranges::find(film_backs, film_back_, &FilmBack::width);
  if (found == film_backs.end()) found = film_backs.begin();
  film_back_ = found->width;
  box->setCurrentIndex(static_cast<int>(found - film_backs.begin()));
  form.addRow(tr("Film back"), box);
  connect(box, &QComboBox::activated, this, [this](int index) {
    film_back_ = film_backs[static_cast<std::size_t>(index)].width;
    QSettings().setValue(film_back_key, film_back_);
    refresh();
  });
}

double CameraPanel::focal_length() const {
  return brume::focal_length(camera().vertical_fov, document_.scene().film) * film_back_ /
         sensor_width;
}

void CameraPanel::set_focal_length(double length, MergeId gesture) {
  Camera changed = camera();
  changed.vertical_fov = vertical_fov(length * sensor_width / film_back_, document_.scene().film);
  set_camera(changed, tr("focal length"), gesture);
}

void CameraPanel::add_lenses(QFormLayout& form) {
  struct Lens {
    double focal_length;  // [mm]
    const char* name;
  };
  static constexpr auto lenses = std::to_array<Lens>({{18.0, QT_TR_NOOP("18 mm, very wide")},
                                                      {24.0, QT_TR_NOOP("24 mm, wide")},
                                                      {35.0, QT_TR_NOOP("35 mm, reportage")},
                                                      {50.0, QT_TR_NOOP("50 mm, normal")},
                                                      {85.0, QT_TR_NOOP("85 mm, portrait")},
                                                      {135.0, QT_TR_NOOP("135 mm, far")}});
  auto* box = named(new QComboBox(this), "camera_lens",
                    tr("Usual lenses, with names for a sensor 36 mm wide: sets the focal length"));
  for (const Lens& lens : lenses) box->addItem(tr(lens.name));
  box->setPlaceholderText(tr("Another"));
  form.addRow(tr("Lens"), box);
  connect(box, &QComboBox::activated, this, [this](int index) {
    set_focal_length(lenses[static_cast<std::size_t>(index)].focal_length, no_merge);
  });
  on_refresh([this, box] {
    const double length = focal_length();
    const auto found = std::ranges::find_if(lenses, [length](const Lens& lens) {
      return std::abs(lens.focal_length - length) < 1e-6 * length;
    });
    box->setEnabled(!camera().height);
    box->setCurrentIndex(found == lenses.end() ? -1 : static_cast<int>(found - lenses.begin()));
  });
}

void CameraPanel::add_focal_length(QFormLayout& form) {
  add_number(form, tr("Focal length, mm"),
             {"focal_length", focal_lengths, ValueField::Scale::logarithmic, 0.005,
              [this] { return camera().height ? std::nullopt : std::optional(focal_length()); },
              std::bind_front(&CameraPanel::set_focal_length, this)})
      ->setToolTip(
          tr("Of a lens before the film back: of 36 mm, 24 is wide, 50 normal, 85 and more "
             "make things seem closer. The same as the field of view"));
}

void CameraPanel::add_focus(QFormLayout& form) {
  auto* on_target = named(new QCheckBox(tr("Focus on what it looks at"), this), "focus_on_target");
  form.addRow({}, on_target);
  connect(on_target, &QCheckBox::clicked, this, [this](bool on) {
    Camera changed = camera();
    changed.focus_distance.reset();
    if (!on) changed.focus_distance = glm::length(changed.target - changed.eye);
    set_camera(changed, tr("focus distance"), no_merge);
  });
  on_refresh([this, on_target] {
    on_target->setChecked(!camera().focus_distance);
    on_target->setEnabled(camera().aperture > 0.0);
  });
}

QString CameraPanel::name_in_use() const {
  return QString::fromStdString(document_.scene().camera_name);
}

QString CameraPanel::name() const {
  return chosen_.isEmpty() ? name_in_use() : chosen_;
}

const Camera& CameraPanel::camera() const {
  const Camera* found = find_camera(document_.scene(), chosen_);
  return found ? *found : document_.scene().camera;
}

void CameraPanel::show_camera(const QString& name) {
  chosen_ = name;
  refresh();
  plate_->refresh();
}

void CameraPanel::show_frame(int frame) {
  plate_->show_frame(frame);
}

void CameraPanel::follow_names() {
  const QStringList before = std::exchange(names_, camera_names(document_.scene()));
  chosen_ = camera_name_after(before, names_, chosen_);
  if (chosen_ == name_in_use()) chosen_.clear();
}

void CameraPanel::show_cameras() {
  if (is_changing_) return;
  QStringList names = names_;
  names.sort(Qt::CaseInsensitive);
  is_changing_ = true;
  while (list_->count() > names.size()) delete list_->takeItem(list_->count() - 1);
  while (list_->count() < names.size()) list_->addItem(QString());
  for (int k = 0; k < list_->count(); ++k) {
    QListWidgetItem* item = list_->item(k);
    const bool in_use = names[k] == name_in_use();
    item->setText(names[k]);
    item->setData(name_role, names[k]);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    QFont font = list_->font();
    font.setBold(in_use);
    item->setFont(font);
    if (names[k] == name()) list_->setCurrentItem(item);
  }
  is_changing_ = false;
}

}  // namespace brume
