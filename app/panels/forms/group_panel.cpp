#include "app/panels/forms/group_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>

#include "app/commands/gaussians/edit_groups.h"
#include "app/document/document.h"
#include "app/document/text/words.h"
#include "app/widgets/rows.h"
#include "core/scene/fields/group_fields.h"

namespace brume {

GroupPanel::GroupPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent), groups_(named(new QComboBox(this), "group")) {
  groups_->setToolTip(tr("The active group: brushes, Add Gaussian and Paste add to it"));
  groups_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* hint = named(new QLabel(tr("Groups keep Gaussians together: select some and press Ctrl+G. "
                                   "What you set here acts on "
                                   "all of a group and leaves their own values as they are."),
                                this),
                     "group_hint");
  hint->setWordWrap(true);
  auto* form = new_form();
  form->addRow(hint);
  form->addRow(tr("Group"), groups_);
  add_color(*form, tr("Colour"),
            {"group_color", [this] { return value_if(document_.active_group(), &Group::color); },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set colour of %1"), gesture, [&](Group& g) { g.color = color; });
             }});
  const Fields<Group> values{
      .prefix = "group_",
      .get = [this] { return document_.active_group(); },
      .set =
          [this](const Group& changed, const FieldInfo& info, MergeId gesture) {
            change(tr("Set %1 of %2").arg(in_sentence(field_label(info)), "%1"), gesture,
                   [&](Group& group) { group = changed; });
          },
      .track =
          [this](const Scene& scene, const FieldInfo& info) {
            const auto group =
                std::ranges::find(scene.groups, document_.active_group()->id, &Group::id);
            return value_track<Groups>(scene, info.name,
                                       static_cast<std::size_t>(group - scene.groups.begin()));
          }};
  visit_fields<Group>([&]<class F>(const F& field) {
    if constexpr (F::can_have_keys) add_field(*form, field, values);
  });
  connect(groups_, &QComboBox::activated, this, [this](int index) {
    document_.set_active_group(groups_->itemData(index).value<GroupId>());
  });
  on_change(document_, Change::active_group, this, &GroupPanel::refresh);
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

void GroupPanel::change(const QString& verb, MergeId gesture,
                        const std::function<void(Group&)>& how) {
  if (const Group* group = document_.active_group()) {
    change_group(document_, group->id, verb, gesture, how);
  }
}

}  // namespace brume
