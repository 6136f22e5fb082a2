#include "app/panels/gaussians/gaussian_table_model.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <array>
#include <utility>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/document.h"
#include "app/document/text/number_text.h"
#include "app/widgets/color_button.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

// The rows of entries of an edit, if they follow each other.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;  // 0: they do not
};

// Entries ascend in their ids, rows as well.
template <class RowOf>
Run run_of(const std::vector<MediumEdit::Entry>& entries, RowOf row_of) {
  const auto first = static_cast<std::size_t>(*row_of(entries.front().id));
  const auto last = static_cast<std::size_t>(*row_of(entries.back().id));
  return last - first + 1 == entries.size() ? Run{first, entries.size()} : Run{};
}

bool is_shown_alike(const Gaussian& a, const Gaussian& b, GaussianAttribute field) {
  switch (field) {
    case GaussianAttribute::albedo:
      return a.optics.albedo == b.optics.albedo;
    case GaussianAttribute::emission:
      return a.optics.emission == b.optics.emission;
    case GaussianAttribute::radius_x:
    case GaussianAttribute::radius_y:
    case GaussianAttribute::radius_z:
      return a.radius == b.radius && a.shape.stretch == b.shape.stretch;
    case GaussianAttribute::rotation_x:
    case GaussianAttribute::rotation_y:
    case GaussianAttribute::rotation_z:
      return a.shape.rotation == b.shape.rotation;
    case GaussianAttribute::elongation:
      return a.shape.stretch == b.shape.stretch;
    default:
      return attribute_value(a, field) == attribute_value(b, field);
  }
}

bool is_color(GaussianAttribute field) {
  return field == GaussianAttribute::albedo || field == GaussianAttribute::emission;
}

constexpr QSize swatch_size(8, 12);  // columns are narrow

// The colour of its albedo or emission; nothing where the Gaussian has none of its own.
QVariant swatch(const GaussianOptics& optics, GaussianAttribute field) {
  if (field == GaussianAttribute::albedo && optics.albedo)
    return color_swatch(*optics.albedo, swatch_size);
  if (field == GaussianAttribute::emission && optics.emission != glm::dvec3(0.0)) {
    return color_swatch(emission_color(optics.emission), swatch_size);
  }
  return {};
}

// Columns are narrow, and more so beside a swatch; the tool tip has more digits.
QString cell_text(double value, GaussianAttribute field) {
  return number_text(value, is_color(field) ? 3 : 4);
}

// The group is chosen elsewhere, and what is too long could be so in several ways. Rotations are of
// the inspector, which knows the angles that were entered: here one would change the two others.
bool is_editable(const QModelIndex& index) {
  const auto column = static_cast<std::size_t>(index.column());
  return column < gaussian_attributes.size() &&
         gaussian_attributes[column] < GaussianAttribute::rotation_x;
}

QString channels_text(const glm::dvec3& rgb) {
  return QString("%1, %2, %3").arg(number_text(rgb.r), number_text(rgb.g), number_text(rgb.b));
}

}  // namespace

GaussianTableModel::GaussianTableModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document), rows_(document) {}

void GaussianTableModel::reload() {
  beginResetModel();
  rows_.arrange();
  endResetModel();
}

void GaussianTableModel::sort(int column, Qt::SortOrder order) {
  beginResetModel();
  rows_.sort_by(column, order);
  endResetModel();
}

void GaussianTableModel::set_filter(GaussianFilter filter) {
  beginResetModel();
  rows_.set_filter(std::move(filter));
  endResetModel();
}

bool GaussianTableModel::follow(const MediumEdit& edit) {
  const auto& added = edit.added();
  const auto& removed = edit.removed();
  if (added.empty() && removed.empty()) return follow_changes(edit);
  if (!rows_.is_as_in_medium() || (!added.empty() && !removed.empty())) return false;
  if (!removed.empty()) {
    const Run run = run_of(removed, [this](GaussianId id) { return rows_.row(id); });
    if (run.count == 0) return false;
    beginRemoveRows({}, static_cast<int>(run.first), static_cast<int>(run.first + run.count) - 1);
    rows_.erase(run.first, run.count);
    endRemoveRows();
  } else {
    const Medium& medium = document_.medium();
    const Run run = run_of(added, [&](GaussianId id) { return medium.index_of(id); });
    if (run.count == 0) return false;
    beginInsertRows({}, static_cast<int>(run.first), static_cast<int>(run.first + run.count) - 1);
    rows_.insert(run.first, run.count);
    endInsertRows();
  }
  return follow_changes(edit);
}

bool GaussianTableModel::follow_changes(const MediumEdit& edit) {
  // Only the columns that changed: rows that are sorted by another one stay where they are.
  std::array<bool, id_column + 1> changed{};
  for (const auto& change : edit.changed()) {
    for (std::size_t k = 0; k < gaussian_attributes.size(); ++k) {
      const GaussianAttribute field = gaussian_attributes[k];
      changed[k] = changed[k] || !is_shown_alike(change.before, change.after, field);
    }
    changed[group_column] = changed[group_column] || change.before.group != change.after.group;
  }
  for (int k = 0; k < columnCount(); ++k) {
    if (changed[static_cast<std::size_t>(k)] && rows_.depends_on(k)) return false;
  }
  if (rowCount() == 0) return true;
  for (int k = 0; k < columnCount(); ++k) {
    if (changed[static_cast<std::size_t>(k)]) {
      Q_EMIT dataChanged(index(0, k), index(rowCount() - 1, k));
    }
  }
  return true;
}

void GaussianTableModel::follow_albedo() {
  const auto found = std::ranges::find(gaussian_attributes, GaussianAttribute::albedo);
  follow_column(static_cast<int>(found - gaussian_attributes.begin()));
}

void GaussianTableModel::follow_groups() {
  follow_column(group_column);
}

void GaussianTableModel::follow_column(int column) {
  if (rows_.depends_on(column)) return reload();
  if (rowCount() > 0) Q_EMIT dataChanged(index(0, column), index(rowCount() - 1, column));
}

int GaussianTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int GaussianTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : id_column + 1;
}

QVariant GaussianTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::TextAlignmentRole) {
    const bool is_text = index.column() == group_column;
    return static_cast<int>((is_text ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  const auto row_index = document_.medium().index_of(id(index.row()));
  if (!row_index) return {};
  if (index.column() == id_column) {
    return role == Qt::DisplayRole ? QVariant(qulonglong{id(index.row())}) : QVariant();
  }
  if (index.column() == group_column) return group_data(document_.medium().group(*row_index), role);
  const GaussianAttribute field = gaussian_attributes[static_cast<std::size_t>(index.column())];
  const GaussianOptics own_optics = document_.medium().optics(*row_index);
  const Gaussian gaussian = document_.effective_gaussian(*row_index);
  const bool is_of_medium = field == GaussianAttribute::albedo && !own_optics.albedo;
  switch (role) {
    case Qt::DisplayRole:
      return cell_text(attribute_value(gaussian, field), field);
    case Qt::EditRole:
      // It is text: the editor that Qt offers for numbers rounds them.
      return exact_number_text(attribute_value(gaussian, field));
    case Qt::DecorationRole:
      return swatch(own_optics, field);
    case Qt::ForegroundRole:
      return is_of_medium ? QGuiApplication::palette().brush(QPalette::PlaceholderText)
                          : QVariant();
    case Qt::ToolTipRole:
      if (is_of_medium)
        return tr("The medium's albedo: %1").arg(channels_text(*gaussian.optics.albedo));
      if (field == GaussianAttribute::albedo) return channels_text(*own_optics.albedo);
      if (field == GaussianAttribute::emission) return channels_text(own_optics.emission);
      return number_text(attribute_value(gaussian, field));
    default:
      return {};
  }
}

QVariant GaussianTableModel::group_data(GroupId id, int role) const {
  const Group* group = find_group(document_.scene().groups, id);
  if (!group) return {};
  const QString name = QString::fromStdString(group->name);
  if (role == Qt::DisplayRole) return name;
  if (role != Qt::ToolTipRole) return {};
  const Group* outer = find_group(document_.scene().groups, group->parent);
  return plain_tool_tip(outer ? tr("%1, in %2").arg(name, QString::fromStdString(outer->name))
                              : name);
}

bool GaussianTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole || !is_editable(index)) return false;
  const std::array one{id(index.row())};
  if (!document_.medium().index_of(one[0])) return false;  // not yet reloaded
  const std::vector<GaussianId> selection = document_.selection();
  const std::span<const GaussianId> targets =
      document_.is_selected(one[0]) ? std::span<const GaussianId>(selection) : one;
  const GaussianAttribute field = gaussian_attributes[static_cast<std::size_t>(index.column())];
  const auto color = is_color(field) ? parse_color(value.toString()) : std::nullopt;
  const QString problem =
      color ? set_color(targets, field, *color)
            : set_attribute(document_, targets, field, parse_number(value.toString()));
  if (!problem.isEmpty()) Q_EMIT refused(problem);
  return problem.isEmpty();
}

QString GaussianTableModel::set_color(std::span<const GaussianId> ids, GaussianAttribute field,
                                      const TypedColor& color) {
  for (int k = 0; k < 3 && !color.is_shade; ++k) {
    if (QString problem = attribute_problem(field, color.linear[k]); !problem.isEmpty()) {
      return problem;
    }
  }
  change_optics(document_, ids, [&color, field](GaussianOptics& optics) {
    if (field == GaussianAttribute::albedo) {
      optics.albedo = color.linear;
    } else if (color.is_shade && color.linear != glm::dvec3(0.0)) {
      const double strength = emission_strength(optics.emission);
      optics.emission = (strength > 0.0 ? strength : 1.0) * emission_color(color.linear);
    } else {
      optics.emission = color.linear;
    }
  });
  return {};
}

QVariant GaussianTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const auto column = static_cast<std::size_t>(section);
  if (orientation == Qt::Horizontal && role == Qt::ToolTipRole &&
      column < gaussian_attributes.size() && is_color(gaussian_attributes[column])) {
    return tr("A number, or a colour: 0.9 0.2 0.1, #e6331a or 2700 K");
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return QAbstractTableModel::headerData(section, orientation, role);
  }
  // So many titles stand beside each other.
  if (section == group_column) return tr("Group");
  if (section == id_column) return tr("Id");
  if (section < 3) return QString("XYZ"[section]);
  return attribute_title(gaussian_attributes[static_cast<std::size_t>(section)]);
}

Qt::ItemFlags GaussianTableModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
  return is_editable(index) ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace brume
