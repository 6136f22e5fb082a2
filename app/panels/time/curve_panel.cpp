#include "app/panels/time/curve_panel.h"

#include <QGridLayout>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "app/document/document.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/time_ruler.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

// Calls visit(item) for the items that stand for a curve, in the order of tracks and numbers.
void visit_curve_items(const QTreeWidget& list, auto&& visit) {
  for (int k = 0; k < list.topLevelItemCount(); ++k) {
    QTreeWidgetItem* top = list.topLevelItem(k);
    if (top->childCount() == 0) visit(top);
    for (int i = 0; i < top->childCount(); ++i) visit(top->child(i));
  }
}

QTreeWidgetItem* new_item(const QString& text, bool is_shown) {
  auto* item = new QTreeWidgetItem({text});
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
  item->setCheckState(0, is_shown ? Qt::Checked : Qt::Unchecked);
  return item;
}

}  // namespace

CurvePanel::CurvePanel(Timeline& timeline, Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      list_(named(new QTreeWidget(this), "curve_list",
                  tr("Values with keyframes: checked ones are shown, a double click shows one "
                     "alone"))),
      editor_(named(new CurveEditor(timeline, document, this), "curves")) {
  list_->setHeaderHidden(true);
  list_->setMinimumHeight(0);
  list_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
  list_->setFixedWidth(DopeSheet::names_width);
  list_->setExpandsOnDoubleClick(false);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFocusPolicy(Qt::ClickFocus);
  list_->setAccessibleName(tr("Curves"));
  auto* fit = named(new QToolButton(this), "fit_curves", tr("Show the whole curves (Home)"));
  fit->setText(tr("Fit"));
  auto* all = named(new QToolButton(this), "all_curves", tr("Show the curves of all values"));
  all->setText(tr("All"));
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(6, 0, 6, 0);
  for (QToolButton* button : {fit, all}) buttons->addWidget(button);
  buttons->addStretch();
  auto* grid = new QGridLayout(this);
  // The ruler is as long as that of the timeline, which has a scroll bar beside it.
  grid->setContentsMargins(0, 0, style()->pixelMetric(QStyle::PM_ScrollBarExtent), 0);
  grid->setSpacing(0);
  grid->addLayout(buttons, 0, 0);
  grid->addWidget(new TimeRuler(timeline, this), 0, 1);
  grid->addWidget(list_, 1, 0);
  grid->addWidget(editor_, 1, 1);
  grid->setColumnStretch(1, 1);
  grid->setRowStretch(1, 1);
  connect(fit, &QToolButton::clicked, editor_, &CurveEditor::fit);
  connect(all, &QToolButton::clicked, this, [this] { check_all(Qt::Checked); });
  connect(list_, &QTreeWidget::itemChanged, this, &CurvePanel::follow_list);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &CurvePanel::isolate);
  connect(list_, &QTreeWidget::customContextMenuRequested, this, &CurvePanel::show_menu);
  connect(&document, &Document::changed, this, [this](const DocumentChange& change) {
    if (change.places) follow(*change.places);
    if (change.what & Change::scene) return clear();
    if (change.what & Change::part && !(change.what & Change::time)) refresh();
  });
  refresh();
}

bool CurvePanel::is_row_of(const Listed& row, const KeyedTrack& keyed) {
  return row.track == keyed.track && row.track.first == keyed.track.first &&
         row.track.title() == keyed.track.title() && row.values == keyed.values;
}

void CurvePanel::clear() {
  listed_.clear();
  shown_.clear();
  hidden_.clear();
  editor_->set_tracks({}, {});
  refresh();
}

void CurvePanel::follow(const ObjectPlaces& places) {
  const std::size_t count = shown_.size();
  follow_places(shown_, places);
  std::vector<CurveEditor::Hidden> hidden;
  for (const CurveEditor::Hidden& number : hidden_) {
    std::vector<Track> track{number.track};
    follow_places(track, places);
    if (!track.empty()) hidden.push_back({track.front(), number.curve});
  }
  hidden_ = std::move(hidden);
  // Keys that are selected are those of the tracks that were shown.
  if (shown_.size() != count) editor_->set_tracks({}, {});
}

void CurvePanel::refresh() {
  const std::vector<KeyedTrack> keyed = keyed_tracks(document_.scene());
  const bool is_same_list = std::ranges::equal(listed_, keyed, is_row_of);
  if (!is_same_list) listed_.clear();
  for (std::size_t k = listed_.size(); k < keyed.size(); ++k) {
    Listed& row = listed_.emplace_back(Listed{keyed[k].track, keyed[k].values, {}, {}});
    for (const Curve& curve : curves_of(document_.scene(), row.track)) {
      row.curves.push_back(curve);
      row.titles.push_back(curve.title);
    }
  }
  std::vector<Track> shown;
  for (const Track& track : shown_) {
    const auto found = std::ranges::find(listed_, track, &Listed::track);
    if (found != listed_.end()) shown.push_back(found->track);
  }
  if (shown.empty() && !listed_.empty()) shown = {listed_.front().track};
  const bool is_same = shown == editor_->tracks();
  shown_ = std::move(shown);
  if (!is_same_list) fill_list();
  is_same ? editor_->update_tracks(shown_, hidden_) : editor_->set_tracks(shown_, hidden_);
  if (!is_same_list || !is_same) paint_icons();
}

void CurvePanel::fill_list() {
  const QSignalBlocker blocker(list_);
  list_->clear();
  for (const auto& [track, values, curves, titles] : listed_) {
    const bool is_shown = std::ranges::find(shown_, track) != shown_.end();
    auto* top = new_item(track.title(), is_shown);
    list_->addTopLevelItem(top);
    if (curves.size() < 2) continue;
    top->setFlags(top->flags() | Qt::ItemIsAutoTristate);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const bool is_hidden = CurveEditor::is_hidden(hidden_, track, curves[k]);
      top->addChild(new_item(titles[k], is_shown && !is_hidden));
    }
    top->setExpanded(is_shown);
  }
}

void CurvePanel::follow_list() {
  shown_.clear();
  hidden_.clear();
  for (int k = 0; k < list_->topLevelItemCount(); ++k) {
    const QTreeWidgetItem& top = *list_->topLevelItem(k);
    if (top.checkState(0) == Qt::Unchecked) continue;
    const Listed& row = listed_[static_cast<std::size_t>(k)];
    shown_.push_back(row.track);
    for (int i = 0; i < top.childCount(); ++i) {
      if (top.child(i)->checkState(0) == Qt::Checked) continue;
      hidden_.push_back(CurveEditor::to_hide(row.track, row.curves[static_cast<std::size_t>(i)]));
    }
  }
  editor_->set_tracks(shown_, hidden_);
  paint_icons();
}

// The colours of the curves that are shown.
void CurvePanel::paint_icons() {
  const QSignalBlocker blocker(list_);
  std::size_t curve = 0;
  visit_curve_items(*list_, [&](QTreeWidgetItem* item) {
    QPixmap icon(list_->iconSize().isValid() ? list_->iconSize() : QSize(12, 12));
    icon.fill(Qt::transparent);
    if (item->checkState(0) == Qt::Checked && curve < editor_->curves().size()) {
      QPainter painter(&icon);
      painter.fillRect(QRect(0, icon.height() / 3, icon.width(), icon.height() / 3),
                       editor_->color(curve++));
    }
    item->setIcon(0, icon);
  });
}

// A value may be in a track with others.
void CurvePanel::show_tracks(std::span<const Track> tracks) {
  std::vector<Track> shown;
  for (const Listed& row : listed_) {
    const Track& keyed = row.track;
    const bool is_asked = std::ranges::any_of(tracks, [&keyed](const Track& track) {
      return keyed.part == track.part && track.first - keyed.first < keyed.count;
    });
    if (is_asked) shown.push_back(keyed);
  }
  if (shown.empty()) return;
  shown_ = std::move(shown);
  hidden_.clear();
  fill_list();
  editor_->set_tracks(shown_, hidden_);
  paint_icons();
}

void CurvePanel::check_all(Qt::CheckState state) {
  {
    const QSignalBlocker blocker(list_);
    visit_curve_items(*list_, [state](QTreeWidgetItem* item) { item->setCheckState(0, state); });
  }
  follow_list();
}

void CurvePanel::isolate(QTreeWidgetItem* item) {
  {
    const QSignalBlocker blocker(list_);
    visit_curve_items(*list_, [item](QTreeWidgetItem* other) {
      const bool is_in = other == item || other->parent() == item;
      other->setCheckState(0, is_in ? Qt::Checked : Qt::Unchecked);
    });
  }
  follow_list();
}

void CurvePanel::show_menu(const QPoint& position) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (QTreeWidgetItem* item = list_->itemAt(position)) {
    menu->addAction(tr("&Isolate"), this, [this, item] { isolate(item); });
  }
  menu->addAction(tr("Show &All"), this, [this] { check_all(Qt::Checked); });
  menu->popup(list_->mapToGlobal(position));
}

}  // namespace brume
