#include "app/panels/gaussians/gaussian_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QSettings>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <vector>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/document/document.h"
#include "app/panels/gaussians/filter_bar.h"
#include "app/panels/gaussians/gaussian_form.h"
#include "app/panels/gaussians/gaussian_histogram.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "app/widgets/keys.h"
#include "app/widgets/rows.h"
#include "brume/limits.h"

namespace brume {
namespace {

// A table of so many rows takes longer to load than a picture.
constexpr int many_rows = 20'000;
constexpr int reload_after = 250;  // milliseconds

// Qt compares every range of a selection with every other: quadratic. More scattered selections are
// not mirrored in the view; rows are painted from the document anyway.
constexpr std::size_t max_ranges = 500;

class RowDelegate : public QStyledItemDelegate {
 public:
  RowDelegate(const Document& document, const GaussianTableModel& model, QObject* parent)
      : QStyledItemDelegate(parent), document_(document), model_(model) {}

  // Digits stay where they were.
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) line->setAlignment(Qt::AlignRight);
    return editor;
  }

  // Opening a cell and leaving it must not write its value into the whole selection.
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override {
    const auto* line = qobject_cast<QLineEdit*>(editor);
    if (!line || line->isModified()) QStyledItemDelegate::setModelData(editor, model, index);
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    option->state.setFlag(QStyle::State_Selected, document_.is_selected(model_.id(index.row())));
  }

 private:
  const Document& document_;
  const GaussianTableModel& model_;
};

}  // namespace

GaussianPanel::GaussianPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new GaussianTableModel(document, this)),
      table_(new QTableView(this)),
      filter_(new FilterBar(this)) {
  auto* form = new GaussianForm(document, this);
  table_->setModel(model_);
  if (auto* corner = table_->findChild<QAbstractButton*>()) {
    corner->setAccessibleName(tr("Select all"));
  }
  table_->setItemDelegate(new RowDelegate(document, *model_, this));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setTabKeyNavigation(false);  // Tab goes through the panels, and would select rows
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  table_->setAlternatingRowColors(true);
  table_->setMinimumHeight(44);  // the head and a row
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSortIndicatorClearable(true);  // the third click: as they came
  table_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
  table_->setSortingEnabled(true);
  connect(model_, &QAbstractItemModel::modelAboutToBeReset, this, &GaussianPanel::remember_place);
  connect(model_, &QAbstractItemModel::modelReset, this, &GaussianPanel::restore_place);
  table_->installEventFilter(this);
  connect(filter_, &FilterBar::asked, model_, &GaussianTableModel::set_filter);
  connect(filter_, &FilterBar::select_asked, this,
          [this] { select_gaussians(document_, shown()); });
  connect(filter_, &FilterBar::group_asked, this, &GaussianPanel::group_shown);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(form);
  using Attribute = GaussianAttribute;
  for (const auto& row : {std::vector{Attribute::radius, Attribute::density, Attribute::elongation},
                          std::vector{Attribute::albedo, Attribute::emission}}) {
    auto* histograms = new QHBoxLayout;
    histograms->setContentsMargins(6, 0, 6, 0);
    for (const Attribute field : row) {
      // Wider for a longer title, which is between two numbers.
      histograms->addWidget(new GaussianHistogram(document, field, this),
                            static_cast<int>(attribute_title(field).size()) + 6);
    }
    layout->addLayout(histograms);
  }
  layout->addWidget(filter_);
  layout->addWidget(table_, 1);

  connect(form, &GaussianForm::refused, this, &GaussianPanel::refused);
  connect(model_, &GaussianTableModel::refused, this, &GaussianPanel::refused);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &GaussianPanel::adopt_selection);
  reload_timer_.setSingleShot(true);
  connect(&reload_timer_, &QTimer::timeout, this, &GaussianPanel::reload);
  on_change(document_, Change::scene, this, &GaussianPanel::reload);
  on_medium_edit(document_, this, &GaussianPanel::follow);
  const auto count = [this] {
    filter_->show_count(static_cast<std::size_t>(model_->rowCount()), document_.medium().size());
  };
  connect(model_, &QAbstractItemModel::modelReset, this, count);
  on_change(document_, Change::medium, this, count);
  count();
  // After the rows have followed.
  on_change(document_, Change::selection, this, &GaussianPanel::select_rows);
  const auto show_groups = [this] {
    table_->setColumnHidden(GaussianTableModel::group_column, document_.scene().groups.empty());
  };
  on_change(document_, Change::scene, this, show_groups);
  on_change(document_, Change::groups, this, [this, show_groups] {
    show_groups();
    model_->follow_groups();
  });
  show_groups();
  add_column_menu();
  on_change(document_, Change::part, this, [this] {
    const glm::dvec3& albedo = document_.scene().optics.albedo;
    if (std::exchange(shown_albedo_, albedo) != albedo) model_->follow_albedo();
  });
}

void GaussianPanel::add_column_menu() {
  QHeaderView* header = table_->horizontalHeader();
  header->setContextMenuPolicy(Qt::ActionsContextMenu);
  const auto add = [this, header](int column, const QString& id, const QString& title,
                                  bool is_shown) {
    const QString name = "column_" + id;
    auto* action = named(new QAction(title, header), name);
    action->setCheckable(true);
    const QString key = "gaussians/" + name;
    action->setChecked(QSettings().value(key, is_shown).toBool());
    table_->setColumnHidden(column, !action->isChecked());
    connect(action, &QAction::toggled, table_, [this, column, key](bool shown) {
      table_->setColumnHidden(column, !shown);
      QSettings().setValue(key, shown);
    });
    header->addAction(action);
  };
  constexpr int id_column = GaussianTableModel::id_column;
  add(id_column, "id", tr("Id"), true);
  header->moveSection(id_column, 0);
  header->setSectionResizeMode(id_column, QHeaderView::Interactive);
  header->resizeSection(id_column, header->fontMetrics().horizontalAdvance("0000000"));
  for (std::size_t k = 3; k < gaussian_attributes.size(); ++k) {  // always the center
    const GaussianAttribute field = gaussian_attributes[k];
    // There is room for few, unless more were asked for.
    add(static_cast<int>(k), attribute_id(field), attribute_title(field), !is_of_shape(field));
  }
}

void GaussianPanel::reload() {
  reload_timer_.stop();
  model_->reload();
}

void GaussianPanel::remember_place() {
  const QModelIndex current = table_->currentIndex();
  current_.reset();
  if (current.isValid()) current_ = model_->id(current.row());
  current_column_ = current.column();
  is_typed_ = table_->isPersistentEditorOpen(current);
  scrolled_ = table_->verticalScrollBar()->value();
}

void GaussianPanel::restore_place() {
  const auto row = current_ ? model_->row(*current_) : std::nullopt;
  if (row) {
    table_->selectionModel()->setCurrentIndex(model_->index(*row, current_column_),
                                              QItemSelectionModel::NoUpdate);
  }
  table_->verticalScrollBar()->setValue(scrolled_);
  select_rows();
  // Tab goes on to the next cell, wherever its row has gone.
  if (row && is_typed_) table_->edit(model_->index(*row, current_column_));
}

void GaussianPanel::follow(const MediumEdit& edit) {
  if (reload_timer_.isActive()) return reload_timer_.start(reload_after);  // once it pauses
  // While rows come and go the view's selection is not the user's.
  const bool was_syncing = std::exchange(syncing_, true);
  const bool has_followed = model_->follow(edit);
  syncing_ = was_syncing;
  if (!has_followed) {
    const bool is_typed = table_->isPersistentEditorOpen(table_->currentIndex());
    // The editor of a cell closes first.
    if (is_typed || model_->rowCount() > many_rows) {
      return reload_timer_.start(is_typed ? 0 : reload_after);
    }
    reload();
  } else if (!edit.added().empty() || !edit.removed().empty()) {
    select_rows();
  }
}

std::vector<GaussianId> GaussianPanel::shown() {
  if (reload_timer_.isActive()) reload();
  std::vector<GaussianId> ids;
  for (int row = 0; row < model_->rowCount(); ++row) ids.push_back(model_->id(row));
  const bool is_empty = ids.empty();
  ids = document_.selectable(std::move(ids));
  if (ids.empty() && !is_empty) Q_EMIT refused(tr("All of these are hidden or locked."));
  return ids;
}

void GaussianPanel::group_shown() {
  const std::vector<GaussianId> ids = shown();
  if (ids.empty()) return;
  if (document_.scene().groups.size() >= limits::groups) {
    Q_EMIT refused(tr("A scene has at most %L1 groups.").arg(limits::groups));
    return;
  }
  document_.undo_stack().beginMacro(tr("Save %1 as group").arg(filter_->text()));
  select_gaussians(document_, ids);
  group_selection(document_, filter_->text());
  document_.undo_stack().endMacro();
}

bool GaussianPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool is_shortcut = event->type() == QEvent::ShortcutOverride;
  if (is_shortcut || event->type() == QEvent::KeyPress) {
    const auto& key = static_cast<QKeyEvent&>(*event);
    const bool selects_all = is_key_of("select.all", key);
    if (selects_all || (is_key_of("edit.delete", key) && !is_typed(key))) {
      event->accept();
      if (is_shortcut) return true;
      if (selects_all) {
        select_gaussians(document_, shown());
      } else {
        delete_selection(document_, tr("Delete"));
      }
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void GaussianPanel::adopt_selection() {
  if (syncing_) return;
  std::vector<GaussianId> ids;
  for (const QItemSelectionRange& range : table_->selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) ids.push_back(model_->id(row));
  }
  syncing_ = true;
  select_gaussians(document_, std::move(ids));
  syncing_ = false;
  table_->viewport()->update();
}

void GaussianPanel::select_rows() {
  if (syncing_) return;
  syncing_ = true;
  std::vector<int> shown;
  for (const GaussianId id : document_.selection()) {
    if (const auto row = model_->row(id)) shown.push_back(*row);
  }
  std::sort(shown.begin(), shown.end());
  struct Range {
    int first = 0;
    int last = 0;
  };
  std::vector<Range> ranges;
  for (const int row : shown) {
    if (!ranges.empty() && ranges.back().last + 1 == row) {
      ranges.back().last = row;
    } else {
      ranges.push_back({row, row});
    }
  }
  auto* rows = table_->selectionModel();
  QItemSelection selection;
  if (ranges.size() <= max_ranges) {
    for (const Range& range : ranges) {
      selection.append(QItemSelectionRange(model_->index(range.first, 0),
                                           model_->index(range.last, model_->columnCount() - 1)));
    }
  }
  rows->select(selection, QItemSelectionModel::ClearAndSelect);
  if (!ranges.empty()) {
    const QModelIndex top = model_->index(ranges.front().first, 0);
    // Typing then edits the selection, not some row that happened to be current before.
    const QModelIndex current = table_->currentIndex();
    if (!current.isValid() || !document_.is_selected(model_->id(current.row()))) {
      rows->setCurrentIndex(top.siblingAtColumn(std::max(0, current.column())),
                            QItemSelectionModel::NoUpdate);
    }
    table_->scrollTo(top);
  }
  syncing_ = false;
  table_->viewport()->update();
}

}  // namespace brume
