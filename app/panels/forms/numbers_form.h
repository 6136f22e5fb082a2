#pragma once

#include <QFormLayout>

#include "app/panels/forms/scene_form.h"

namespace brume {

// A form for the values of an object that core/scene/fields or operation_numbers.h describes, but
// for those that may be absent.
class NumbersForm : public SceneForm {
 public:
  // `prefix`: of the object names of the fields. `get` may return nullptr: there is none.
  template <class Owner>
  NumbersForm(Document& document, const QString& prefix, std::function<const Owner*()> get,
              std::function<void(const Owner&)> set, QWidget* parent)
      : SceneForm(document, parent) {
    auto* form = new_form(0);
    const Fields<Owner> numbers{
        .prefix = prefix,
        .get = std::move(get),
        .set = [set = std::move(set)](const Owner& changed, const FieldInfo&,
                                      MergeId) { set(changed); },
        .track = {}};
    visit_fields<Owner>([&]<class F>(const F& field) {
      if constexpr (!may_be_absent<typename F::Value>) add_field(*form, field, numbers);
    });
    refresh();
  }

  using SceneForm::refresh;
};

}  // namespace brume
