#include "app/panels/group_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "app/commands/edit_groups.h"
#include "app/document/document.h"
#include "core/number_domain.h"

namespace brume {

GroupPanel::GroupPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent), groups_(new QComboBox(this)) {
  groups_->setObjectName("group");
  groups_->setToolTip(tr("The active group: brushes, Add Gaussian and Paste add to it"));
  groups_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* hint = new QLabel(
      tr("Groups keep Gaussians together: select some and press Ctrl+G. What you set here acts on "
         "all of a group and leaves their own values as they are."),
      this);
  hint->setObjectName("group_hint");
  hint->setWordWrap(true);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(6, 6, 6, 6);
  form->addRow(hint);
  form->addRow(tr("Group"), groups_);
  add_color(*form, tr("Colour"),
            {"group_color",
             [this]() -> std::optional<glm::dvec3> {
               const Group* group = document_.active_group();
               return group ? std::optional(group->color) : std::nullopt;
             },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set colour of %1"), gesture, [&](Group& g) { g.color = color; });
             }});
  add_numbers(*form, tr("Density"), tr(", 1/u"), "group_density_factor", "group_density_offset",
              domain::not_negative, &Group::density_factor, &Group::density_offset);
  add_numbers(*form, tr("Radius"), tr(", u"), "group_radius_factor", "group_radius_offset",
              domain::length, &Group::radius_factor, &Group::radius_offset);
  add_albedo(*form);
  connect(groups_, &QComboBox::activated, this, [this](int index) {
    document_.set_active_group(groups_->itemData(index).value<GroupId>());
  });
  connect(&document_, &Document::active_group_changed, this, &GroupPanel::refresh);
  on_refresh([this, hint] {
    hint->setVisible(document_.scene().groups.empty());
    show_groups();
  });
  refresh();
}

void GroupPanel::show_groups() {
  const QSignalBlocker blocker(groups_);
  const Groups& groups = document_.scene().groups;
  groups_->clear();
  groups_->addItem(tr("None"), GroupId{0});
  for (const Group& group : groups) {
    groups_->addItem(QString::fromStdString(group.name), group.id);
  }
  const Group* active = document_.active_group();
  groups_->setCurrentIndex(groups_->findData(active ? active->id : GroupId{0}));
  groups_->setEnabled(!groups.empty());
}

void GroupPanel::add_numbers(QFormLayout& form, const QString& title, const QString& unit,
                             const char* factor, const char* offset,
                             const NumberDomain& factor_domain, double Group::*factor_value,
                             double Group::*offset_value) {
  using Scale = ValueField::Scale;
  const auto add = [&](const QString& row, const char* name, const NumberDomain& allowed,
                       Scale scale, double Group::*value, const QString& verb) {
    return add_number(form, row,
                      {name, allowed, scale, 0.01,
                       [this, value]() -> std::optional<double> {
                         const Group* group = document_.active_group();
                         return group ? std::optional(group->*value) : std::nullopt;
                       },
                       [this, value, verb](double number, MergeId gesture) {
                         change(verb, gesture, [&](Group& g) { g.*value = number; });
                       }});
  };
  const QString name = title.toLower();
  add(tr("%1 factor").arg(title), factor, factor_domain, Scale::logarithmic, factor_value,
      tr("Set %1 factor of %2").arg(name))
      ->setToolTip(tr("Multiplies the %1 of each Gaussian of the group; 1 changes nothing. Drag "
                      "to change; Ctrl for fine steps, Shift for coarse")
                       .arg(name));
  add(tr("%1 offset%2").arg(title, unit), offset, domain::coordinate, Scale::linear, offset_value,
      tr("Set %1 offset of %2").arg(name))
      ->setToolTip(tr("Added to the %1 of each Gaussian after the factor; 0 changes nothing. Drag "
                      "to change; Ctrl for fine steps, Shift for coarse")
                       .arg(name));
}

void GroupPanel::add_albedo(QFormLayout& form) {
  const auto add = [&](const QString& row, const char* name, const NumberDomain& allowed,
                       glm::dvec3 Group::*value, const QString& verb) {
    add_vector(form, row,
               {name, allowed, 0.005,
                [this, value]() -> std::optional<glm::dvec3> {
                  const Group* group = document_.active_group();
                  return group ? std::optional(group->*value) : std::nullopt;
                },
                [this, value, verb](const glm::dvec3& color, MergeId gesture) {
                  change(verb, gesture, [&](Group& g) { g.*value = color; });
                },
                "RGB"});
  };
  add(tr("Albedo factor"), "group_albedo_factor", domain::not_negative, &Group::albedo_factor,
      tr("Set albedo factor of %1"));
  add(tr("Albedo offset"), "group_albedo_offset", domain::albedo_offset, &Group::albedo_offset,
      tr("Set albedo offset of %1"));
}

void GroupPanel::change(const QString& verb, MergeId gesture,
                        const std::function<void(Group&)>& how) {
  if (const Group* group = document_.active_group()) {
    change_group(document_, group->id, verb, gesture, how);
  }
}

}  // namespace brume
