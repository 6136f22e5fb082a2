// Programs that read the screen, and the keyboard, have what they need: names of all widgets,
// letters of all entries; and how menus and dialogs are titled.

#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>

#include "app/tools/tool_box.h"
#include "app/widgets/mnemonics.h"
#include "tests/app/every_dialog.h"

using namespace brume;

namespace {

// Whether a user acts on it, and it is not a part that Qt makes of a widget.
bool is_operated(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(&widget) ||
      qobject_cast<const QLabel*>(&widget)) {
    return false;
  }
  const auto* tabs = qobject_cast<const QTabBar*>(&widget);
  if (tabs && tabs->count() == 0) return false;  // of docks that are no tabs now
  for (const QWidget* above = widget.parentWidget(); above; above = above->parentWidget()) {
    if (qobject_cast<const QComboBox*>(above) || qobject_cast<const QAbstractSpinBox*>(above) ||
        qobject_cast<const QLineEdit*>(above)) {
      return false;
    }
  }
  return qobject_cast<const QAbstractButton*>(&widget) || widget.focusPolicy() != Qt::NoFocus;
}

QStringList nameless(QWidget& root) {
  QStringList found;
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (!is_operated(*widget)) continue;
    widget->ensurePolished();  // as when it is shown
    const QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
    if (face && !face->text(QAccessible::Name).trimmed().isEmpty()) continue;
    QStringList path;
    for (const QWidget* above = widget; above != root.window() && above;
         above = above->parentWidget()) {
      path.prepend(QString("%1 \"%2\"").arg(above->metaObject()->className(), above->objectName()));
    }
    found << path.join(" > ");
  }
  return found;
}

// Texts without a letter of their own among those that are shown together.
QStringList without_letter(const QStringList& texts) {
  QStringList found;
  QString taken;
  for (const QString& text : texts) {
    const QString letter = QKeySequence::mnemonic(text).toString().right(1);
    if (letter.isEmpty() || taken.contains(letter)) found << text;
    taken += letter;
  }
  return found;
}

bool has_letters(const QString& text) {
  static const QRegularExpression letter("[A-Za-z]");
  return text.contains(letter);
}

// What of a dialog the keyboard is to reach by letters.
QStringList labelled_texts(const QWidget& dialog) {
  QStringList texts;
  for (const QFormLayout* form : dialog.findChildren<QFormLayout*>()) {
    for (int row = 0; row < form->rowCount(); ++row) {
      const QLayoutItem* title = form->itemAt(row, QFormLayout::LabelRole);
      const auto* label = title ? qobject_cast<QLabel*>(title->widget()) : nullptr;
      QLayoutItem* value = form->itemAt(row, QFormLayout::FieldRole);
      const bool shows_text = value && qobject_cast<QLabel*>(value->widget());
      if (label && !shows_text) texts << label->text();
    }
  }
  for (const auto* button : dialog.findChildren<QAbstractButton*>()) texts << button->text();
  for (const QTabBar* tabs : dialog.findChildren<QTabBar*>()) {
    for (int k = 0; k < tabs->count(); ++k) texts << tabs->tabText(k);
  }
  texts.removeIf([](const QString& text) { return !has_letters(text); });
  return texts;
}

// Words that are small and should not be; what stands behind a colon or in parentheses explains.
QStringList small_words(const QString& title) {
  static const QRegularExpression explanation(R"(:.*|\(.*|“.*)");
  static const QStringList small{"a",  "an", "and", "as",   "at",   "by",   "for", "in", "of",
                                 "on", "or", "to",  "from", "into", "with", "out", "the"};
  QStringList found;
  QStringList words = without_mnemonic(title).remove(explanation).split(' ', Qt::SkipEmptyParts);
  for (qsizetype k = 0; k < words.size(); ++k) {
    const bool is_small = words[k].front().isLower() && words[k] != "sRGB";
    if (is_small && (k == 0 || !small.contains(words[k]))) found << words[k];
  }
  return found;
}

}  // namespace

class AccessibilityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void widgets_of_the_window_have_names() {
    QStringList found;
    for (const auto& entry : window_->tools().entries()) {
      window_->tools().activate(entry.name);
      found << nameless(*window_);
    }
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n').left(800)));
  }

  void widgets_of_dialogs_have_names() {
    QStringList found;
    const int count = visit_dialogs(window_, [&](QWidget& dialog) {
      for (const QString& path : nameless(dialog)) found << dialog.windowTitle() + ": " + path;
    });
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n').left(800)));
    QCOMPARE(count, 14);
  }

  void fields_are_named_by_their_rows() {
    const auto name = [&](const char* widget) {
      auto* named = window_->findChild<QWidget*>(widget);
      if (auto* field = qobject_cast<ValueField*>(named)) named = &field->number();
      named->ensurePolished();
      return QAccessible::queryAccessibleInterface(named)->text(QAccessible::Name);
    };
    QCOMPARE(name("camera_focus_distance"), "Focus distance, u");
    QCOMPARE(name("camera_eye_y"), "Position y");
    QCOMPARE(name("light_color"), "Colour");
    QVERIFY2(name("camera_eye_key").startsWith("Position: "), qPrintable(name("camera_eye_key")));
  }

  void entries_of_menus_have_letters_of_their_own() {
    QStringList bar;
    for (const QAction* action : window_->menuBar()->actions()) bar << action->text();
    QCOMPARE(without_letter(bar), QStringList());
    int count = 0;
    for (QMenu* menu : window_->findChildren<QMenu*>()) {
      menu->popup({});
      QStringList texts;
      for (const QAction* action : menu->actions()) {
        if (!action->isSeparator() && has_letters(action->text())) texts << action->text();
      }
      menu->close();
      count += static_cast<int>(texts.size());
      QVERIFY2(without_letter(texts).isEmpty(), qPrintable(without_letter(texts).join("; ")));
    }
    QVERIFY(count > 100);
  }

  void labels_and_buttons_of_dialogs_have_letters_of_their_own() {
    visit_dialogs(window_, [&](QWidget& dialog) {
      const QStringList found = without_letter(labelled_texts(dialog));
      QVERIFY2(found.isEmpty(), qPrintable(dialog.windowTitle() + ": " + found.join("; ")));
    });
  }

  void letters_move_the_focus_in_dialogs() {
    visit_dialogs(window_, [](QWidget& dialog) {
      if (dialog.objectName() != "fog_shape_dialog") return;
      dialog.activateWindow();
      QTRY_COMPARE(QApplication::activeWindow(), &dialog);
      auto* field = dialog.findChild<ValueField*>("fog_shape_density");
      const auto* label = dialog.findChild<QLabel*>("fog_shape_density_title");
      const QKeyCombination letter = QKeySequence::mnemonic(label->text())[0];
      QTest::keyClick(&dialog, letter.key(), letter.keyboardModifiers());
      QVERIFY(field->number().hasFocus());
    });
  }

  void actions_and_dialogs_are_titled_alike() {
    TestWindow window;  // whose menus have no names of files and presets yet
    QStringList found;
    for (const QAction* action : window->findChildren<QAction*>()) {
      const bool is_history = action->objectName() == "edit.undo" || action->data().isValid();
      if (!is_history && !small_words(action->text()).isEmpty()) found << action->text();
    }
    visit_dialogs(window, [&](QWidget& dialog) {
      const QString title = dialog.windowTitle();
      if (!title.startsWith("Import ") && !small_words(title).isEmpty()) found << title;
    });
    QVERIFY2(found.isEmpty(), qPrintable(found.join("; ")));
  }

  void counts_have_their_plurals() {
    auto& document = window_.document();
    const std::vector<GaussianId> ids(document.medium().ids().begin(),
                                      document.medium().ids().end());
    document.select({ids[0]});
    invoke(*window_, "edit.delete");
    QCOMPARE(last_step(document), "Delete 1 Gaussian");
    document.select({ids[1], ids[2]});
    invoke(*window_, "edit.delete");
    QCOMPARE(last_step(document), "Delete 2 Gaussians");
  }

 private:
  TestWindow window_;  // for all tests: no other meets what one leaves
};

BRUME_APP_SUITE("accessibility", AccessibilityTest)
#include "accessibility_test.moc"
