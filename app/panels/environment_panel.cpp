#include "app/panels/environment_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/panels/environment_picture.h"
#include "app/widgets/plain_text.h"
#include "core/io/image/radiance_map_file.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr int picture_width = 180;

}  // namespace

EnvironmentPanel::EnvironmentPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  add_file(*form);
  const auto add = [&](const QString& title, const char* widget, const NumberDomain& domain,
                       ValueField::Scale scale, double step, double Environment::*number,
                       const QString& text) {
    add_number(*form, title,
               {widget, domain, scale, step,
                [this, number]() -> std::optional<double> {
                  const auto& environment = document_.scene().environment;
                  return environment ? std::optional((*environment).*number) : std::nullopt;
                },
                [this, number, text](double value, MergeId gesture) {
                  std::optional<Environment> environment = document_.scene().environment;
                  (*environment).*number = value;
                  set_scene_part(document_, std::move(environment), text, gesture);
                }});
  };
  add(tr("Intensity"), "environment_intensity", domain::not_negative,
      ValueField::Scale::logarithmic, 0.01, &Environment::intensity,
      tr("Set intensity of environment"));
  add(tr("Rotation, degrees"), "environment_rotation", domain::degrees, ValueField::Scale::linear,
      0.5, &Environment::rotation, tr("Rotate environment"));
  connect(&document_, &Document::scene_replaced, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, [this](const QString& problem) {
    show_picture();
    Q_EMIT refused(problem);
  });
  refresh();
}

void EnvironmentPanel::add_file(QFormLayout& form) {
  auto* name = new PlainLabel(this);
  name->setObjectName("environment_file");
  auto* choose = new QPushButton(tr("Choose…"), this);
  auto* remove = new QPushButton(tr("Remove"), this);
  remove->setObjectName("remove_environment");
  auto* row = new QHBoxLayout;
  row->addWidget(name, 1);
  row->addWidget(choose);
  row->addWidget(remove);
  form.addRow(tr("Environment"), row);
  picture_ = new PlainLabel(this);
  picture_->setObjectName("environment_picture");
  picture_->setToolTip(tr("The environment as rotated: −z in the centre, +x to the right"));
  form.addRow({}, picture_);
  connect(choose, &QPushButton::clicked, this, &EnvironmentPanel::choose);
  connect(remove, &QPushButton::clicked, this, [this] {
    set_scene_part(document_, std::optional<Environment>(), tr("Remove environment"));
  });
  on_refresh([this, name, remove] {
    const auto& environment = document_.scene().environment;
    name->setText(environment ? to_qstring(environment->file.filename()) : tr("none"));
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
      ask_for_file(this, FileKind::environment, tr("Choose an environment"),
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
      set_scene_part(document_, std::optional(std::move(environment)), tr("Set environment"));
    };
  });
}

void EnvironmentPanel::show_picture() {
  const auto& environment = document_.scene().environment;
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
