#pragma once

#include "app/commands/objects/edit_emitters.h"
#include "app/panels/forms/scene_form.h"

class QListWidget;

namespace brume {

// List of emitters, and the parameters of the active one.
class EmitterPanel : public SceneForm {
  Q_OBJECT
 public:
  EmitterPanel(Document& document, QWidget* parent);

 private:
  void add_list(QFormLayout& form);
  void add_fields(QFormLayout& form);
  void add_span(QFormLayout& form);
  void add_optics(QFormLayout& form);
  [[nodiscard]] const Emitter* emitter() const;            // the active one; may be null
  [[nodiscard]] std::optional<EmissionSpan> span() const;  // of it
  void change(const QString& text, MergeId gesture, const std::function<void(Emitter&)>& how);
  void change_span(const QString& verb, MergeId gesture,
                   const std::function<void(EmissionSpan&)>& how);

  // Each step of a gesture changes the span that there was before the first: a start that has
  // pushed the end returns it.
  struct SpanGesture {
    MergeId id = no_merge;
    std::size_t emitter = 0;
    EmissionSpan first;
    EmissionSpan last;  // as the last step has left it
  };

  QListWidget* list_;
  bool showing_ = false;
  SpanGesture span_gesture_;
};

}  // namespace brume
