#include "app/window/status_line.h"

#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>

#include "app/document/document.h"
#include "app/document/text/number_text.h"
#include "app/frames/quality_words.h"
#include "app/jobs/job_bar.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/viewport/viewport.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "app/window/pages/message_bar.h"

namespace brume {
namespace {

bool has_fog(const Scene& scene) {
  return !scene.medium.empty() || scene.medium.homogeneous_density() > 0.0 ||
         !scene.density_keys.empty() || !scene.emitters.empty() || !scene.sequences.empty();
}

}  // namespace

StatusLine::StatusLine(const Workspace& work, QMainWindow& window,
                       const std::vector<BackgroundJob*>& jobs)
    : QObject(&window),
      work_(work),
      hint_(new PlainLabel(&window)),
      numbers_(new PlainLabel(&window)),
      error_(named(new PlainLabel(&window), "error")),
      quality_(named(new PlainLabel(&window), "quality")) {
  // Menu bars do not follow when what is in their corner grows.
  quality_->setMinimumWidth(quality_->fontMetrics().horizontalAdvance("paper's method"));
  quality_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  quality_->setContentsMargins(0, 4, 8, 0);
  window.menuBar()->setCornerWidget(quality_);
  QStatusBar* bar = window.statusBar();
  bar->addWidget(hint_, 1);
  for (BackgroundJob* job : jobs) bar->addPermanentWidget(new JobBar(*job));
  bar->addPermanentWidget(numbers_);
  bar->addPermanentWidget(error_);

  const ViewGrid& views = work_.views;
  for (const auto signal : {&ViewGrid::frame_shown, &ViewGrid::active_changed}) {
    connect(&views, signal, this, &StatusLine::update_numbers);
    connect(&views, signal, this, &StatusLine::update_error);
    connect(&views, signal, this, &StatusLine::show_fallback);
    connect(&views, signal, this, &StatusLine::show_unreadable_frame);
  }
  connect(&views, &ViewGrid::error_changed, this, &StatusLine::update_error);
  connect(&views, &ViewGrid::mode_changed, this, &StatusLine::update_error);
  connect(&views, &ViewGrid::backend_changed, this, [this] { fallback_.clear(); });
  connect(&work_.tools, &ToolBox::activated, this, &StatusLine::update_numbers);
  on_change(work_.document, Change::medium | Change::selection | Change::part, this,
            &StatusLine::update_numbers);
  on_change(work_.document, Change::scene, this, [this] {
    fallback_.clear();
    unreadable_.clear();
  });
  update_numbers();
}

void StatusLine::hide_scene(bool hidden) {
  for (QLabel* label : {hint_, numbers_, error_, quality_}) label->setVisible(!hidden);
}

void StatusLine::update_numbers() {
  const std::size_t count = work_.document.medium().size();
  const std::size_t selected = work_.document.selection().size();
  QString text = tr("%1 Gaussian(s)", nullptr, static_cast<int>(count)).arg(count_text(count));
  if (selected > 0) text += tr(", %1 selected").arg(count_text(selected));
  if (const RenderedFrame* frame = work_.views.active().frames().shown()) {
    const bool gl = frame->frame.statistics.backend == "gl";
    text += tr(" · %1%2 ·").arg(duration_text(frame->milliseconds), gl ? tr(", OpenGL") : "");
  }
  numbers_->setText(text);
  const bool is_select = work_.tools.active() == 0;
  hint_->setText(
      !has_fog(work_.document.scene()) && is_select
          ? tr("No fog yet. Press B to paint fog, or Shift+A to add a Gaussian under the "
               "mouse.")
          : work_.tools.tool().hint());
}

void StatusLine::update_error() {
  const Viewport& view = work_.views.active();
  const RenderedFrame* frame = view.frames().shown();
  if (!frame) return;
  QString numbers = tr("The error is being measured");
  if (const QString paths = paths_text(frame->frame); !paths.isEmpty()) {
    numbers = paths;
  } else if (const auto& error = view.frames().quality().error()) {
    numbers = tr("Error %1").arg(errors_text(*error));
  }
  error_->setText(quality_words(quality_state(view.frames())));
  error_->setToolTip(
      plain_tool_tip(numbers) + "<br><br>" +
      tr("Relative RMSE of the airlight against the reference, measured on this frame, and of the "
         "whole picture beside all the light there is. Of a path-traced picture: its noise, the "
         "standard error relative to the RMS"));
  quality_->setText(settings_text(frame->request.settings));
  for (QLabel* label : {error_, quality_}) label->setEnabled(view.frames().is_measured());
}

void StatusLine::show_fallback() {
  const RenderedFrame* frame = work_.views.active().frames().shown();
  // Paths are traced on the CPU by choice.
  if (!frame || frame->request.settings.airlight == AirlightMethod::path) return;
  const QString why = fallback_text(frame->frame.statistics);
  if (why == fallback_) return;
  fallback_ = why;
  if (!why.isEmpty()) {
    work_.messages.show_note(tr("Rendered on the CPU instead of OpenGL: %1").arg(why));
  }
}

// Once for each, however often it is played.
void StatusLine::show_unreadable_frame() {
  const QString& why = work_.views.active().problem();
  if (why.isEmpty() || why == unreadable_) return;
  unreadable_ = why;
  work_.messages.show_error(why);
}

}  // namespace brume
