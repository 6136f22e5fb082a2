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
  on_change(document, Change::scene | Change::part, this, &CurvePanel::refresh);
  refresh();
}

void CurvePanel::refresh() {
  std::vector<Track> keyed = tracks_with_keys(document_.scene());
  if (keyed == keyed_) return;
  keyed_ = std::move(keyed);
  const std::size_t count = shown_.size();
  std::erase_if(shown_, [this](const Track& track) {
    return std::ranges::find(keyed_, track) == keyed_.end();
  });
  const bool is_same = shown_.size() == count && count > 0;
  if (shown_.empty() && !keyed_.empty()) shown_ = {keyed_.front()};
  fill_list();
  if (!is_same) editor_->set_tracks(shown_, hidden_);
  paint_icons();
}

void CurvePanel::fill_list() {
  const QSignalBlocker blocker(list_);
  list_->clear();
  for (const Track& track : keyed_) {
    const bool is_shown = std::ranges::find(shown_, track) != shown_.end();
    auto* top = new_item(track.title(), is_shown);
    list_->addTopLevelItem(top);
    const std::vector<Curve> curves = curves_of(document_.scene(), track);
    if (curves.size() < 2) continue;
    top->setFlags(top->flags() | Qt::ItemIsAutoTristate);
    for (const Curve& curve : curves) {
      const bool is_hidden = std::ranges::any_of(hidden_, [&](const CurveEditor::Hidden& hidden) {
        return hidden.track == track && hidden.curve.value == curve.value &&
               hidden.curve.component == curve.component;
      });
      top->addChild(new_item(curve.title, is_shown && !is_hidden));
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
    const Track& track = keyed_[static_cast<std::size_t>(k)];
    shown_.push_back(track);
    const std::vector<Curve> curves = curves_of(document_.scene(), track);
    for (int i = 0; i < top.childCount(); ++i) {
      if (top.child(i)->checkState(0) == Qt::Checked) continue;
      hidden_.push_back({track, curves.at(static_cast<std::size_t>(i))});
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
  for (const Track& keyed : keyed_) {
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
