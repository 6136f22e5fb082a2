// The interface in other languages.

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabBar>
#include <QTranslator>
#include <QTreeWidget>

#include "app/document/text/words.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/translation.h"
#include "tests/app/every_dialog.h"

using namespace brume;

namespace {

// Translates as long as it is there.
class Translated {
 public:
  explicit Translated(Language language) {
    const auto before = translators();
    install_translations(*qApp, language);
    for (QTranslator* translator : translators()) {
      if (!before.contains(translator)) added_ << translator;
    }
  }
  ~Translated() {
    for (QTranslator* translator : added_) delete translator;
    keep_titles_in_sentences(false);
  }

 private:
  static QList<QTranslator*> translators() { return qApp->findChildren<QTranslator*>(); }

  QList<QTranslator*> added_;
};

// Marks what goes through translation.
class Marker : public QTranslator {
 public:
  Marker() { QCoreApplication::installTranslator(this); }
  ~Marker() override { QCoreApplication::removeTranslator(this); }
  [[nodiscard]] bool isEmpty() const override { return false; }
  QString translate(const char* /*context*/, const char* text, const char* /*meaning*/,
                    int /*count*/) const override {
    return QString(QChar(0x2020)) + QString::fromUtf8(text);
  }
};

QStringList texts_of(const QWidget& widget) {
  QStringList texts{widget.toolTip(), widget.windowTitle()};
  for (const char* property : {"text", "title", "placeholderText", "specialValueText", "suffix"}) {
    texts << widget.property(property).toString();
  }
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    for (int k = 0; k < box->count(); ++k) texts << box->itemText(k);
  }
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
    for (int k = 0; k < tabs->count(); ++k) texts << tabs->tabText(k);
  }
  if (const auto* tree = qobject_cast<const QTreeWidget*>(&widget)) {
    for (int k = 0; k < tree->columnCount(); ++k) texts << tree->headerItem()->text(k);
  }
  for (const QAction* action : widget.actions()) texts << action->text();
  return texts;
}

QStringList unmarked(const QWidget& root) {
  // Names and numbers of the scene, of files, of languages, of programs, and of keys.
  static const QRegularExpression word("[A-Za-z]{3}");
  static const QRegularExpression exempt(
      "^(#.*|English|Deutsch|RGB|sRGB|CPU.*|[0-9.,×±%~ ]+ ?(mm|ms|stops)?)$|\\.(brume|vdb|png|glb)|"
      "Ctrl|Shift|/|Brume$");
  // Whose entries are data.
  static const QStringList data{"header_camera", "color_menu", "cameras"};
  QStringList found;
  for (const QWidget* widget : root.findChildren<QWidget*>()) {
    const QString name = widget->objectName();
    if (data.contains(name) || name.startsWith("volume_")) continue;
    for (const QString& text : texts_of(*widget)) {
      if (text.contains(word) && !text.contains(QChar(0x2020)) && !text.contains(exempt)) {
        found << QString("%1 \"%2\": %3").arg(widget->metaObject()->className(), name, text);
      }
    }
  }
  return found;
}

}  // namespace

class TranslationsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void german_is_the_interface_of_who_chooses_it() {
    const Translated german(Language::german);
    TestWindow window;
    QStringList menus;
    for (const QAction* action : window->menuBar()->actions()) {
      menus << without_mnemonic(action->text());
      QVERIFY2(!QKeySequence::mnemonic(action->text()).isEmpty(), qPrintable(action->text()));
    }
    QVERIFY2(menus.contains("Datei") && menus.contains("Bearbeiten"), qPrintable(menus.join(' ')));
    QCOMPARE(label_text(*window, "camera_focus_distance_title"), "Schärfeentfernung, u");
    Document& document = window.document();
    const std::vector<GaussianId> ids(document.medium().ids().begin(),
                                      document.medium().ids().end());
    document.select({ids[0]});
    type(*window, "density", "0.5");
    QCOMPARE(last_step(document), "Dichte von 1 Gaußfunktion auf 0.5 setzen");
    document.select({ids[0], ids[1]});
    invoke(*window, "edit.delete");
    QCOMPARE(last_step(document), "Löschen: 2 Gaußfunktionen");
  }

  void all_texts_go_through_translation() {
    const Marker marker;
    TestWindow window;
    QStringList found = unmarked(*window);
    visit_dialogs(window, [&](QWidget& dialog) { found << unmarked(dialog); });
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n').left(900)));
  }
};

BRUME_APP_SUITE("translations", TranslationsTest)
#include "translations_test.moc"
