#include "app/panels/plots/performance_panel.h"

#include <QHeaderView>
#include <QSettings>
#include <QVBoxLayout>

#include "app/document/text/number_text.h"
#include "app/frames/frame_scheduler.h"
#include "app/panels/plots/frontier_plot.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

constexpr const char* max_error_key = "view/max_error";
constexpr const char* details_key = "performance/details";

// Plain names of stages whose own are of the program.
QString stage_title(Stage stage) {
  if (stage == Stage::scattering) return PerformancePanel::tr("multiple scattering");
  return to_string(stage);
}

// How a frame was rendered, in the words of View > Quality.
QString method_text(const FrameScheduler& frames, const Settings& settings) {
  const auto with_settings = [&](const QString& choice) {
    return PerformancePanel::tr("%1: %2").arg(choice, settings_text(settings));
  };
  if (settings.airlight == AirlightMethod::path) {
    return with_settings(PerformancePanel::tr("Reference"));
  }
  switch (frames.quality().airlight()) {
    case AirlightMethod::auto_:
      return with_settings(PerformancePanel::tr("Auto"));
    case AirlightMethod::paper:
      return PerformancePanel::tr("Paper's method");
    default:
      return with_settings(frames.quality().is_fast() ? PerformancePanel::tr("Fast")
                                                      : PerformancePanel::tr("Fixed"));
  }
}

// Why the frame has its settings.
QString reason(const FrameScheduler& frames) {
  if (frames.mode() == ViewMode::path_traced) {
    return PerformancePanel::tr("More paths while nothing changes.");
  }
  const FrameQuality& quality = frames.quality();
  if (!quality.is_auto()) return PerformancePanel::tr("Chosen in the View menu.");
  const QualityControl& control = quality.control();
  const QString bound = bound_text(control.max_error());
  if (!control.trials()[control.step()].error) {
    return PerformancePanel::tr("Not measured yet in this scene.");
  }
  if (control.is_exhausted() && control.may_keep_bound()) {
    return PerformancePanel::tr("The error may exceed %1, even with finer settings.").arg(bound);
  }
  if (control.is_exhausted()) {
    return PerformancePanel::tr("Finest setting; it cannot meet %1.").arg(bound);
  }
  if (control.step() == 0) {
    return PerformancePanel::tr("Cheapest setting; it meets %1.").arg(bound);
  }
  const QualityControl::Trial& cheaper = control.trials()[control.step() - 1];
  const QString name = settings_text(cheaper.settings);
  if (control.broke_bound(cheaper)) {
    return PerformancePanel::tr("Meets %1. The error of %2 was up to %3.")
        .arg(bound, name, percent_text(cheaper.error->high));
  }
  return PerformancePanel::tr("Meets %1, but not by enough to try %2.").arg(bound, name);
}

QString gaussians_text(const FrameStatistics& statistics) {
  const QString used = count_text(statistics.gaussians_used);
  if (statistics.gaussians_merged == 0) {
    return PerformancePanel::tr("%1 of %2 used").arg(used, count_text(statistics.gaussians_total));
  }
  return PerformancePanel::tr("%1 of %2 used, merged from %3")
      .arg(used, count_text(statistics.gaussians_merged), count_text(statistics.gaussians_total));
}

}  // namespace

PerformancePanel::PerformancePanel(std::function<const FrameScheduler&()> active_frames,
                                   QWidget* parent)
    : QWidget(parent),
      active_frames_(std::move(active_frames)),
      max_error_(named(new QComboBox(this), "max_error")),
      frontier_(new FrontierPlot(this)),
      stages_(named(new QTreeWidget(this), "stages")) {
  auto* form = new QFormLayout;
  max_error_->setToolTip(tr("The error that auto keeps below"));
  form->addRow(tr("Max error"), max_error_);
  time_ = add_row(*form, tr("Frame"), "frame_time",
                  tr("How long the picture took to render, in milliseconds or seconds"));
  error_ = add_row(*form, tr("Error"), "panel_error",
                   tr("Relative RMSE of the airlight against the reference, and of the whole "
                      "picture beside all the light there is; of a path-traced picture its noise. "
                      "Grey while it is being measured"));
  method_ = add_row(*form, tr("Method"), "shown",
                    tr("Chosen in View > Quality; the more slices along a ray, the more exact"));
  QWidget* details = make_details();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 0);
  layout->addLayout(form);
  layout->addWidget(make_details_button(*details), 0, Qt::AlignLeft);
  layout->addWidget(details, 1);
  layout->addStretch();

  fill_max_error();
}

QWidget* PerformancePanel::make_details() {
  auto* details = new QWidget(this);
  auto* form = new QFormLayout;
  why_ = add_row(*form, {}, "why", {});
  why_->setWordWrap(true);
  scattering_ = add_row(
      *form, tr("Scattering"), "panel_scattering",
      tr("How often light is scattered, chosen in the panel Medium. All orders are solved on a "
         "grid, by sweeps over it, until a sweep changes hardly anything"));
  scattering_->setWordWrap(true);
  backend_ = add_row(*form, tr("Render device"), "backend", tr("Chosen in View > Render Device"));
  backend_->setWordWrap(true);
  auto* numbers = new QFormLayout;
  interval_ = add_row(*numbers, tr("Interval"), "interval",
                      tr("Contains the error of all the airlight in 95% of cases"));
  blocks_ = add_row(*numbers, tr("Blocks"), "block_error",
                    tr("Median error of blocks of 8 × 8 pixels, each relative to its own airlight, "
                       "and its interval: what the eye sees in dark parts beside bright ones"));
  picture_blocks_ = add_row(*numbers, tr("Picture's blocks"), "picture_block_error",
                            tr("The same of the whole picture: with surfaces, mirrors, panes, what "
                               "shines and the environment, beside all the light that there is"));
  gaussians_ = add_row(*numbers, tr("Gaussians"), "gaussians_used",
                       tr("Those that this view needs, of all"));
  pairs_ = add_row(*numbers, tr("Pairs"), "pairs",
                   tr("Evaluated pairs of Gaussian and ray, from the eye and from the lights"));
  picture_ = add_row(*numbers, tr("Picture"), "picture", tr("Width and height in pixels"));

  stages_->setHeaderLabels({tr("Render stage"), tr("Milliseconds")});
  stages_->setRootIsDecorated(false);
  stages_->setSelectionMode(QAbstractItemView::NoSelection);
  stages_->setFocusPolicy(Qt::NoFocus);
  stages_->header()->setStretchLastSection(true);
  stages_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  stages_->setMinimumHeight(50);

  auto* layout = new QVBoxLayout(details);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(form);
  auto* beside = new QHBoxLayout;
  beside->addLayout(numbers);
  beside->addWidget(frontier_, 1);
  layout->addLayout(beside);
  layout->addWidget(stages_, 1);
  return details;
}

QToolButton* PerformancePanel::make_details_button(QWidget& details) {
  auto* button = named(new QToolButton(this), "performance_details");
  button->setText(tr("Details"));
  button->setToolTip(tr("The state of auto, the settings tried, and the time of each stage"));
  button->setCheckable(true);
  button->setAutoRaise(true);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const auto unfold = [button, &details](bool open) {
    button->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    details.setVisible(open);
  };
  const bool was_open = QSettings().value(details_key).toBool();
  button->setChecked(was_open);
  unfold(was_open);
  connect(button, &QToolButton::toggled, this, [unfold](bool open) {
    QSettings().setValue(details_key, open);
    unfold(open);
  });
  return button;
}

QLabel* PerformancePanel::add_row(QFormLayout& form, const QString& title, const char* name,
                                  const QString& tip) {
  auto* value = named(new PlainLabel(this), name, tip);
  if (title.isEmpty()) {
    form.addRow(value);
    return value;
  }
  form.addRow(title, value);
  if (QWidget* label = form.labelForField(value)) label->setToolTip(tip);
  return value;
}

void PerformancePanel::fill_max_error() {
  const double remembered = QSettings().value(max_error_key).toDouble();
  for (const double bound : {0.01, 0.02, 0.05, 0.1}) {
    max_error_->addItem(tr("%1").arg(bound_text(bound)), bound);
  }
  const int chosen = max_error_->findData(remembered);
  max_error_->setCurrentIndex(
      chosen >= 0 ? chosen : max_error_->findData(active_frames_().quality().max_error()));
  connect(max_error_, &QComboBox::activated, this, [this] {
    QSettings().setValue(max_error_key, max_error());
    Q_EMIT max_error_changed(max_error());
  });
}

double PerformancePanel::max_error() const {
  return max_error_->currentData().toDouble();
}

void PerformancePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  update_frame();
}

void PerformancePanel::clear_numbers() {
  for (QLabel* label : {interval_, blocks_, picture_blocks_}) label->clear();
}

void PerformancePanel::update_quality() {
  if (!isVisible()) return;
  const FrameQuality& quality = active_frames_().quality();
  why_->setText(reason(active_frames_()));
  frontier_->show_quality(quality);
  for (QLabel* label : {error_, interval_, blocks_, picture_blocks_})
    label->setEnabled(active_frames_().is_measured());
  const RenderedFrame* frame = active_frames_().shown();
  if (const QString paths = frame ? paths_text(frame->frame) : QString(); !paths.isEmpty()) {
    error_->setText(paths);
    clear_numbers();
  } else if (const std::optional<FrameError>& error = quality.error()) {
    const ErrorEstimate& airlight = error->airlight;
    error_->setText(errors_text(*error));
    interval_->setText(
        tr("%1 (%2 pixels)").arg(interval_text(airlight), count_text(airlight.pixels)));
    blocks_->setText(block_error_text(airlight));
    picture_blocks_->setText(error->picture ? block_error_text(*error->picture) : QString());
  } else {
    error_->setText(tr("measuring"));
    clear_numbers();
  }
}

void PerformancePanel::update_frame() {
  if (!isVisible()) return;
  update_quality();
  const RenderedFrame* frame = active_frames_().shown();
  if (!frame) return;
  const FrameStatistics& statistics = frame->frame.statistics;
  const Film& film = frame->frame.film;
  time_->setText(duration_text(frame->milliseconds));
  method_->setText(method_text(active_frames_(), frame->request.settings));
  scattering_->setText(scattering_text(frame->frame));
  gaussians_->setText(gaussians_text(statistics));
  pairs_->setText(tr("%1 eye, %2 lights")
                      .arg(count_text(statistics.view_pairs), count_text(statistics.light_pairs)));
  const QString size = tr("%1 × %2").arg(film.width).arg(film.height);
  picture_->setText(frame->request.moving && !active_frames_().is_settled()
                        ? tr("%1 in motion").arg(size)
                        : size);
  const QString why_not_gl = fallback_text(statistics);
  const QString backend = backend_text(statistics);
  backend_->setText(why_not_gl.isEmpty() ? backend : tr("%1: %2").arg(backend, why_not_gl));

  show_stages(*frame);
}

void PerformancePanel::show_stages(const RenderedFrame& frame) {
  const FrameStatistics& statistics = frame.frame.statistics;
  QList<QTreeWidgetItem*> rows;
  for (const StageTime& stage : statistics.stages) {
    rows << new QTreeWidgetItem({stage_title(stage.stage), fixed_text(stage.milliseconds, 1)});
  }
  rows << new QTreeWidgetItem({tr("frame"), fixed_text(frame.milliseconds, 1)});
  const auto add_notes = [&rows](const std::vector<SkippedStage>& stages, const QString& text) {
    for (const SkippedStage& stage : stages) {
      const QString why = text.arg(QString::fromStdString(stage.why));
      auto* row = new QTreeWidgetItem({stage_title(stage.stage), why});
      row->setToolTip(1, plain_tool_tip(why));
      row->setDisabled(true);
      rows << row;
    }
  };
  add_notes(statistics.on_cpu, tr("on the CPU: %1"));
  add_notes(statistics.skipped, tr("skipped: %1"));
  stages_->clear();
  stages_->addTopLevelItems(rows);
}

}  // namespace brume
