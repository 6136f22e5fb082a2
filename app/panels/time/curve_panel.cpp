#include "app/panels/time/curve_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/document/document.h"
#include "app/panels/time/curve_editor.h"
#include "app/widgets/rows.h"

namespace brume {

CurvePanel::CurvePanel(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      track_(named(new QComboBox(this), "curve_track")),
      editor_(named(new CurveEditor(timeline, document, this), "curves")) {
  track_->setToolTip(tr("The animated value whose curves are shown"));
  track_->setFocusPolicy(Qt::ClickFocus);
  track_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  track_->setEnabled(false);
  auto* fit = named(new QToolButton(this), "fit_curves");
  fit->setText(tr("Fit"));
  fit->setToolTip(tr("Show the whole curves (Home)"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 2, 8, 2);
  row->addWidget(track_);
  row->addWidget(fit);
  row->addStretch();
  column->addLayout(row);
  column->addWidget(editor_, 1);
  connect(track_, &QComboBox::currentIndexChanged, this, &CurvePanel::show_chosen);
  connect(fit, &QToolButton::clicked, editor_, &CurveEditor::fit);
  on_change(document, Change::scene | Change::part, this, &CurvePanel::refresh);
  refresh();
}

void CurvePanel::refresh() {
  std::vector<Track> rows = tracks_with_keys(document_.scene());
  const auto is_same = [](const Track& a, const Track& b) {
    return a.title == b.title && a.part == b.part && a.first == b.first && a.count == b.count;
  };
  if (std::ranges::equal(rows, rows_, is_same)) return;
  const QString chosen = track_->currentText();
  rows_ = std::move(rows);
  {
    const QSignalBlocker blocker(track_);
    track_->clear();
    for (const Track& row : rows_) track_->addItem(row.title);
    track_->setCurrentIndex(rows_.empty() ? -1 : std::max(0, track_->findText(chosen)));
  }
  track_->setEnabled(!rows_.empty());
  show_chosen();
}

// A value may be in a track with others.
void CurvePanel::show_track(const Track& track) {
  const auto found = std::ranges::find_if(rows_, [&track](const Track& row) {
    return row.part == track.part && track.first - row.first < row.count;
  });
  if (found != rows_.end()) track_->setCurrentIndex(static_cast<int>(found - rows_.begin()));
}

void CurvePanel::show_chosen() {
  const auto k = static_cast<std::size_t>(track_->currentIndex());
  editor_->set_track(k < rows_.size() ? std::optional(rows_[k]) : std::nullopt);
}

}  // namespace brume
