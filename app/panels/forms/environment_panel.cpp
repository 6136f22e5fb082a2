#include "app/panels/forms/environment_panel.h"

#include <QFormLayout>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "app/commands/objects/edit_environment.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/text/words.h"
#include "app/files/file_dialogs.h"
#include "app/frames/view_mode.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "brume/frame.h"
#include "core/io/image/radiance_map_file.h"
#include "core/scene/fields/environment_fields.h"
#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/lights/sky.h"

namespace brume {
namespace {

constexpr int picture_width = 180;

// The environment has the map of its sky.
std::optional<Environment> shown_environment(const Scene& scene) {
  Scene lit;
  lit.environment = scene.environment;
  apply_sky(lit);
  return lit.environment;
}

// A thumbnail of an environment as rotated by the scene: -z in the center, +x right, +y up;
// automatic exposure.
QImage environment_picture(const Environment& environment, int width, int height) {
  Frame frame;
  frame.film = {width, height};
  RadianceMap grid;  // for its directions only
  grid.width = width;
  grid.height = height;
  double sum = 0.0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 radiance =
          environment_radiance(environment, map_direction(grid, {x + 0.5, y + 0.5}));
      for (int c = 0; c < 3; ++c) {
        frame.beauty.push_back(static_cast<float>(radiance[c]));
        sum += radiance[c] / 3.0;
      }
      frame.beauty.push_back(1.0F);
    }
  }
  // A sun's worth of light in few pixels must not leave the rest black.
  const double mean = sum / (static_cast<double>(width) * height);
  const double exposure = mean > 0.0 ? std::clamp(std::log2(0.4 / mean), -30.0, 30.0) : 0.0;
  return to_picture(frame, {exposure, nullptr}, ViewMode::final);
}

}  // namespace

EnvironmentPanel::EnvironmentPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent) {
  auto* form = new_form(0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);  // docks are narrow
  add_file(*form);
  add_fields<Environment>(
      *form, {.prefix = "environment_",
              .get =
                  [this] {
                    const auto& environment = document_.scene().environment;
                    return environment ? &*environment : nullptr;
                  },
              .set =
                  [this](const Environment& environment, const FieldInfo& info, MergeId gesture) {
                    set_scene_part(document_, std::optional(environment),
                                   tr("Set %1 of environment").arg(in_sentence(field_label(info))),
                                   gesture);
                  },
              .track =
                  [](const Scene& scene, const FieldInfo& info) {
                    return value_track<std::optional<Environment>>(scene, info.name);
                  }});
  add_fields<Sky>(*form,
                  {.prefix = "sky_",
                   .get =
                       [this] {
                         const auto& environment = document_.scene().environment;
                         return environment && environment->sky ? &*environment->sky : nullptr;
                       },
                   .set =
                       [this](const Sky& sky, const FieldInfo& info, MergeId gesture) {
                         Environment changed = *document_.scene().environment;
                         changed.sky = sky;
                         set_scene_part(document_, std::optional(std::move(changed)),
                                        tr("Set %1 of sky").arg(in_sentence(field_label(info))),
                                        gesture);
                       },
                   .track =
                       [](const Scene& scene, const FieldInfo& info) {
                         constexpr std::size_t sky = 1;
                         return value_track<std::optional<Environment>>(scene, info.name, sky);
                       }});
  on_change(document_, Change::scene, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, [this](const QString& problem) {
    show_picture();
    Q_EMIT refused(problem);
  });
  refresh();
}

void EnvironmentPanel::add_file(QFormLayout& form) {
  auto* name = named(new PlainLabel(this), "environment_file");
  auto* choose = new QPushButton(tr("Choose…"), this);
  auto* sky = named(new QPushButton(tr("Sky"), this), "add_sky",
                    tr("A clear sky with its sun, which can be dragged in the view"));
  auto* remove = named(new QPushButton(tr("Remove"), this), "remove_environment");
  form.addRow(tr("Environment"), row_of({name, choose, sky, remove}));
  picture_ = new PlainLabel(this);
  picture_->setObjectName("environment_picture");
  picture_->setToolTip(tr("The environment as rotated: −z in the centre, +x to the right"));
  form.addRow({}, picture_);
  connect(choose, &QPushButton::clicked, this, &EnvironmentPanel::choose);
  connect(sky, &QPushButton::clicked, this, [this] { add_sky(document_); });
  connect(remove, &QPushButton::clicked, this, [this] {
    set_scene_part(document_, std::optional<Environment>(), tr("Remove environment"));
  });
  on_refresh([this, name, sky, remove] {
    const auto& environment = document_.scene().environment;
    name->setText(environment ? environment_text(*environment) : tr("none"));
    sky->setEnabled(!environment || !environment->sky);
    remove->setEnabled(environment.has_value());
    // Thousands of directions: not for each drag of a light.
    if (environment != pictured_) {
      pictured_ = environment;
      show_picture();
    }
  });
}

void EnvironmentPanel::choose() {
  const std::filesystem::path file =
      ask_for_file(this, FileKind::environment, tr("Choose an Environment"),
                   tr("Radiance maps (*.exr *.hdr);;All files (*)"), document_.folder());
  if (!file.empty()) load(to_qstring(file));
}

void EnvironmentPanel::load(const QString& file) {
  const std::filesystem::path path = std::filesystem::absolute(to_path(file));
  picture_->setText(tr("Reading %1 …").arg(to_qstring(path.filename())));
  reading_.start([this, path](const Job&) {
    std::vector<std::string> warnings;
    const auto map = read_radiance_map(path, &warnings);
    return [this, path, map, warnings] {
      for (const std::string& warning : warnings) Q_EMIT refused(QString::fromStdString(warning));
      Environment environment = document_.scene().environment.value_or(Environment{});
      environment.file = path;
      environment.map = map;
      environment.sky.reset();
      set_scene_part(document_, std::optional(std::move(environment)), tr("Set environment"));
    };
  });
}

void EnvironmentPanel::show_picture() {
  const auto environment = shown_environment(document_.scene());
  if (environment && environment->map) {
    const double scale = devicePixelRatioF();
    QImage image = environment_picture(*environment, static_cast<int>(scale * picture_width),
                                       static_cast<int>(scale * picture_width / 2));
    image.setDevicePixelRatio(scale);
    picture_->setPixmap(QPixmap::fromImage(image));
  } else {
    picture_->clear();
  }
}

}  // namespace brume
