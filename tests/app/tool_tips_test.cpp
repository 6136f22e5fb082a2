// Rows of forms say what they are where the mouse rests.

#include <QApplication>
#include <QFormLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>

#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// The text that resting the mouse over a widget shows; empty: none.
QString tool_tip(QWidget& widget) {
  const QPoint middle = widget.rect().center();
  QToolTip::showText(widget.mapToGlobal(middle), "nothing", &widget);
  QHelpEvent rest(QEvent::ToolTip, middle, widget.mapToGlobal(middle));
  QApplication::sendEvent(&widget, &rest);
  const QString text = QToolTip::text();
  return text == "nothing" ? QString() : text;
}

}  // namespace

class ToolTipsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rows_of_all_forms_say_what_they_are() {
    QStringList without;
    for (const QFormLayout* form : window_->findChildren<QFormLayout*>()) {
      for (int row = 0; row < form->rowCount(); ++row) {
        QLayoutItem* title = form->itemAt(row, QFormLayout::LabelRole);
        QLayoutItem* value = form->itemAt(row, QFormLayout::FieldRole);
        if (!title || !value || !title->widget()) continue;
        while (value->layout()) value = value->layout()->itemAt(0);
        for (QWidget* widget : {title->widget(), value->widget()}) {
          const QString tip = tool_tip(*widget);
          if (tip.isEmpty()) without << title->widget()->property("text").toString();
          const auto* number = qobject_cast<ValueField*>(value->widget());
          if (number) QVERIFY2(tip.isEmpty() || tip.contains("Allowed: a"), qPrintable(tip));
        }
      }
    }
    without.removeDuplicates();
    QVERIFY2(without.isEmpty(), qPrintable(without.join("; ")));
  }

  void tool_tips_of_values_have_sentence_unit_and_range_but_no_syntax() {
    auto& focus = *window_->findChild<ValueField*>("camera_focus_distance");
    const QString tip = tool_tip(focus);
    QVERIFY2(tip.contains("Distance along the view axis of the plane in focus<br>Unit: u<"),
             qPrintable(tip));
    QVERIFY2(tip.endsWith("Allowed: a number &gt; 0 (from 1e-12 to 1e12)"), qPrintable(tip));
    QCOMPARE(tool_tip(focus.number()), tip);
    QCOMPARE(tool_tip(*window_->findChild<QLabel*>("camera_focus_distance_title")), tip);
  }

 private:
  TestWindow window_;  // for all tests, which only look
};

BRUME_APP_SUITE("tool_tips", ToolTipsTest)
#include "tool_tips_test.moc"
