#include "app/panels/forms/emitter_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <algorithm>
#include <string_view>

#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/object_titles.h"
#include "app/document/text/words.h"
#include "app/widgets/emission_editor.h"
#include "app/widgets/keys.h"
#include "app/widgets/number_field.h"
#include "app/widgets/optics_editor.h"
#include "app/widgets/rows.h"
#include "core/scene/fields/emitter_fields.h"

namespace brume {
EmitterPanel::EmitterPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent), list_(named(new QListWidget(this), "emitters")) {
  auto* form = new_form();
  add_list(*form);
  add_span(*form);
  add_fields(*form);
  on_change(document_, Change::active_emitter, this, &EmitterPanel::refresh);
  refresh();
}

const Emitter* EmitterPanel::emitter() const {
  const Emitters& emitters = document_.scene().emitters;
  return document_.active_emitter() < emitters.size() ? &emitters[document_.active_emitter()]
                                                      : nullptr;
}

void EmitterPanel::change(const QString& text, MergeId gesture,
                          const std::function<void(Emitter&)>& how) {
  change_emitter(document_, document_.active_emitter(), text, gesture, how);
}

void EmitterPanel::add_list(QFormLayout& form) {
  list_->setMaximumHeight(80);
  auto* remove = named(new QPushButton(tr("Delete"), this), "delete_emitter");
  form.addRow(list_);
  form.addRow(remove);
  on_delete_key(*list_, [remove] { remove->click(); });
  connect(remove, &QPushButton::clicked, this, [this] {
    delete_object(document_, {ObjectRef::Kind::emitter, document_.active_emitter()});
  });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!showing_ && row >= 0) document_.set_active_emitter(static_cast<std::size_t>(row));
  });
  on_refresh([this, remove] {
    showing_ = true;
    const int count = static_cast<int>(document_.scene().emitters.size());
    while (list_->count() > count) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < count) list_->addItem(QString());
    for (int k = 0; k < count; ++k) {
      const auto index = static_cast<std::size_t>(k);
      list_->item(k)->setText(emitter_title(document_.scene().emitters[index], index));
    }
    list_->setCurrentRow(emitter() ? static_cast<int>(document_.active_emitter()) : -1);
    remove->setEnabled(emitter() != nullptr);
    showing_ = false;
  });
}

std::optional<EmissionSpan> EmitterPanel::span() const {
  return emitter() ? emission_span(*emitter()) : std::nullopt;
}

void EmitterPanel::change_span(const QString& verb, MergeId gesture,
                               const std::function<void(EmissionSpan&)>& how) {
  const auto shown = span();
  if (!shown) return;
  const std::size_t index = document_.active_emitter();
  const bool goes_on = gesture != no_merge && gesture == span_gesture_.id &&
                       index == span_gesture_.emitter && *shown == span_gesture_.last;
  if (!goes_on) span_gesture_ = {gesture, index, *shown, {}};
  EmissionSpan changed = span_gesture_.first;
  how(changed);
  change(verb, gesture, [&changed](Emitter& e) { set_emission_span(e, changed); });
  span_gesture_.last = span().value_or(changed);
}

// The keyframes of the rate hold when it emits.
void EmitterPanel::add_span(QFormLayout& form) {
  QLabel* start_title = add_number(form, tr("Start, s"),
                                   {"emitter_start", emission_time, ValueField::Scale::linear, 0.02,
                                    [this] {
                                      const auto shown = span();
                                      return shown ? std::optional(shown->start) : std::nullopt;
                                    },
                                    [this](double time, MergeId gesture) {
                                      change_span(tr("Set start of %1"), gesture,
                                                  [time](EmissionSpan& s) { s.start = time; });
                                    }});
  start_title->setToolTip(tr("When it begins to emit; its rate is 0 before, by keyframes"));
  QWidget* ends =
      add_toggle(form, tr("Ends"),
                 {"emitter_ends",
                  [this] {
                    const auto shown = span();
                    return shown ? std::optional(shown->end.has_value()) : std::nullopt;
                  },
                  [this](bool is_on, MergeId gesture) {
                    constexpr double usual_length = 2.0;  // seconds
                    change_span(is_on ? tr("Set end of %1") : tr("Remove end of %1"), gesture,
                                [this, is_on](EmissionSpan& s) {
                                  s.end.reset();
                                  if (is_on)
                                    s.end = std::max(document_.time(), s.start + usual_length);
                                });
                  }});
  QLabel* end_title = add_number(form, tr("End, s"),
                                 {"emitter_end", emission_time, ValueField::Scale::linear, 0.02,
                                  [this] {
                                    const auto shown = span();
                                    return shown ? shown->end : std::nullopt;
                                  },
                                  [this](double time, MergeId gesture) {
                                    change_span(tr("Set end of %1"), gesture,
                                                [time](EmissionSpan& s) { s.end = time; });
                                  }});
  end_title->setToolTip(tr("When it emits no more; its particles live on"));
  const auto number = [this](const char* name) { return &findChild<ValueField*>(name)->number(); };
  for (QWidget* widget : std::initializer_list<QWidget*>{start_title, number("emitter_start"), ends,
                                                         end_title, number("emitter_end")}) {
    on_refresh([this, widget, usual = widget->toolTip()] {
      widget->setToolTip(emitter() && !span() ? tr("The rate is 0, or has keyframes of its own: "
                                                   "edit them in the dope sheet")
                                              : usual);
    });
  }
}

void EmitterPanel::add_fields(QFormLayout& form) {
  const Fields<Emitter> values{
      .prefix = "emitter_",
      .get = [this] { return emitter(); },
      .set =
          [this](const Emitter& changed, const FieldInfo& info, MergeId gesture) {
            change(tr("Set %1 of %2").arg(in_sentence(field_label(info)), "%1"), gesture,
                   [&changed](Emitter& e) { e = changed; });
          },
      .track =
          [this](const Scene& scene, const FieldInfo& info) {
            return value_track<Emitters>(scene, info.name, document_.active_emitter());
          }};
  visit_fields<Emitter>([&]<class F>(const F& field) {
    const std::string_view name = field.info.name;
    if (name == "albedo") add_optics(form);
    // Colors have editors of their own; what hides and locks it is in the outliner.
    const bool is_color = name == "albedo" || name.starts_with("emission");
    if constexpr (!may_be_absent<typename F::Value>) {
      if (!is_color && !std::is_same_v<typename F::Value, bool>) add_field(form, field, values);
    }
  });
}

void EmitterPanel::add_optics(QFormLayout& form) {
  auto* optics = new OpticsEditor(form, tr("Emission at birth"), "emitter", this);
  auto* at_death = new EmissionEditor(tr("at death"), "emitter_death", this);
  form.addRow(at_death->title(), at_death);
  connect(optics, &OpticsEditor::edited, this,
          [this](const OpticsEditor::Change& set, MergeId gesture) {
            change(tr("Set colours of %1"), gesture, [&](Emitter& e) {
              set(e.optics);
              if (!e.optics.albedo) e.keys.albedo.clear();
            });
          });
  connect(at_death, &EmissionEditor::edited, this,
          [this](const EmissionEditor::Change& set, MergeId gesture) {
            change(tr("Set emission of %1"), gesture,
                   [&](Emitter& e) { set(e.emission_at_death); });
          });
  connect(optics, &OpticsEditor::refused, this, &EmitterPanel::refused);
  connect(at_death, &EmissionEditor::refused, this, &EmitterPanel::refused);
  on_refresh([this, optics, at_death] {
    const Emitter* shown = emitter();
    optics->show_optics(shown ? std::optional(shown->optics) : std::nullopt,
                        document_.scene().optics.albedo);
    at_death->show_emission(shown ? std::optional(shown->emission_at_death) : std::nullopt);
  });
}

}  // namespace brume
