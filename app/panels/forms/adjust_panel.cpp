#include "app/panels/forms/adjust_panel.h"

#include <QEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/commands/gaussians/operation_numbers.h"
#include "app/document/document.h"
#include "app/panels/forms/numbers_form.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "core/scene/fields/emitter_fields.h"

namespace brume {
namespace {

constexpr int margin = 8;
constexpr int axes_height = 80;  // of the world's axes, which are in the same corner
constexpr int form_width = 300;

}  // namespace

AdjustPanel::AdjustPanel(Document& document, QWidget* views)
    : QFrame(views),
      document_(document),
      title_(named(new PlainLabel(this), "adjust_title")),
      layout_(new QVBoxLayout(this)) {
  setObjectName("adjust_panel");
  setAutoFillBackground(true);
  setFrameShape(StyledPanel);
  layout_->setContentsMargins(margin, 4, margin, margin);
  auto* close = named(new QToolButton(this), "adjust_close", tr("Close"));
  close->setText(QString(QChar(0x2715)));
  close->setAutoRaise(true);
  LastOperation& last = document.last_operation();
  connect(close, &QToolButton::clicked, &last, &LastOperation::forget);
  layout_->addLayout(row_of({title_, close}));
  connect(&last, &LastOperation::changed, this, &AdjustPanel::show_operation);
  views->installEventFilter(this);
  hide();
}

template <class Numbers>
bool AdjustPanel::show_numbers() {
  const auto get = [this]() -> const Numbers* {
    const auto& operation = document_.last_operation().operation();
    return operation ? std::any_cast<Numbers>(&operation->numbers) : nullptr;
  };
  if (!get()) return false;
  form_ = new NumbersForm(document_, "adjust_", std::function<const Numbers*()>(get),
                          std::function<void(const Numbers&)>([this](const Numbers& numbers) {
                            document_.last_operation().adjust(numbers);
                            if (form_) form_->refresh();
                          }),
                          this);
  return true;
}

void AdjustPanel::show_operation() {
  if (form_) {
    form_->hide();
    form_->deleteLater();  // it may be in one of its own edits
  }
  form_ = nullptr;
  const auto& operation = document_.last_operation().operation();
  const bool has_form =
      operation && (show_numbers<FogShape>() || show_numbers<FogColumn>() ||
                    show_numbers<EvenFog>() || show_numbers<Emitter>() ||
                    show_numbers<ImportPlacement>() || show_numbers<SimplifyNumbers>());
  setVisible(has_form);
  if (!has_form) return;
  title_->setText(operation->title);
  connect(form_, &SceneForm::refused, this, &AdjustPanel::refused);
  layout_->addWidget(form_);
  form_->setFixedWidth(form_width);
  form_->show();
  place();
  raise();
}

void AdjustPanel::place() {
  layout_->activate();
  resize(sizeHint());
  const int bottom = parentWidget()->height() - axes_height;
  move(margin, std::max(margin, bottom - height()));
}

bool AdjustPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace brume
