// The rows of the output panel about samples: of pixels, and of the time that the shutter is open.

#include <QCheckBox>
#include <QFormLayout>
#include <cmath>

#include "app/commands/objects/edit_output.h"
#include "app/document/document.h"
#include "app/panels/forms/output_panel.h"
#include "app/widgets/rows.h"
#include "brume/limits.h"
#include "core/number_domain.h"
#include "render/samples/exposure.h"

namespace brume {
namespace {

constexpr NumberDomain sample_count{1, limits::samples, "a whole number from 1 to 4096"};

}  // namespace

void OutputPanel::add_samples(QFormLayout& form) {
  auto* chosen = named(
      new QCheckBox(tr("Choose samples"), this), "samples_chosen",
      tr("As many samples of a pixel as it needs: %1 at the edges of surfaces, %2 of all pixels "
         "where the lens or the shutter blurs")
          .arg(edge_samples)
          .arg(blur_samples));
  form.addRow({}, chosen);
  const auto set = [this](std::optional<int> samples, MergeId gesture = no_merge) {
    change_output(document_, tr("Set samples of output"), gesture,
                  [samples](Output& output) { output.samples = samples; });
  };
  connect(chosen, &QCheckBox::clicked, this, [this, set](bool on) {
    const bool is_blurred = document_.scene().camera.aperture > 0.0 || output().shutter;
    set(on ? std::nullopt : std::optional(is_blurred ? blur_samples : edge_samples));
  });
  add_number(form, tr("Samples per pixel"),
             {"output_samples", sample_count, ValueField::Scale::logarithmic, 0.02,
              [this]() -> std::optional<double> {
                return output().samples ? std::optional<double>(*output().samples) : std::nullopt;
              },
              [set](double value, MergeId gesture) {
                set(static_cast<int>(std::lround(value)), gesture);
              }})
      ->setToolTip(tr("Of pixels at edges, filtered; 1 takes the centres of all pixels. Where the "
                      "lens or the shutter blurs, as many whole frames are rendered"));
  on_refresh([this, chosen] { chosen->setChecked(!output().samples); });
}

void OutputPanel::add_shutter(QFormLayout& form) {
  auto* blur = named(
      new QCheckBox(tr("Motion blur"), this), "motion_blur",
      tr("What moves while the shutter is open is blurred: camera, lights and fog. Every sample "
         "takes a whole frame"));
  form.addRow({}, blur);
  const auto set = [this](std::optional<Shutter> shutter, MergeId gesture = no_merge) {
    change_output(document_, tr("Set motion blur"), gesture,
                  [shutter](Output& output) { output.shutter = shutter; });
  };
  connect(blur, &QCheckBox::clicked, this,
          [set](bool on) { set(on ? std::optional(Shutter{}) : std::nullopt); });
  const auto add = [&](const QString& title, const char* name, double Shutter::*moment,
                       const QString& tip) {
    add_number(form, title,
               {name, domain::shutter, ValueField::Scale::linear, 0.01,
                [this, moment]() -> std::optional<double> {
                  const std::optional<Shutter>& shutter = output().shutter;
                  return shutter ? std::optional((*shutter).*moment) : std::nullopt;
                },
                [this, set, moment](double value, MergeId gesture) {
                  Shutter shutter = output().shutter.value_or(Shutter{});
                  shutter.*moment = value;
                  if (!(shutter.open < shutter.close)) {
                    Q_EMIT refused(tr("The shutter closes after it opens."));
                    return refresh();
                  }
                  set(shutter, gesture);
                }})
        ->setToolTip(tip);
  };
  add(tr("Shutter opens, frames"), "shutter_open", &Shutter::open,
      tr("After the time of the frame; negative before it"));
  add(tr("Shutter closes, frames"), "shutter_close", &Shutter::close,
      tr("After the time of the frame. Half a frame after it opens is usual for film"));
  on_refresh([this, blur] { blur->setChecked(output().shutter.has_value()); });
}

}  // namespace brume
