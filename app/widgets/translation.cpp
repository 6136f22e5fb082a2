#include "app/widgets/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "app/document/text/words.h"

namespace brume {
namespace {

class Translator : public QTranslator {
 public:
  using QTranslator::QTranslator;

  QString translate(const char* /*context*/, const char* text, const char* meaning,
                    int count) const override {
    return QTranslator::translate("brume", text, meaning, count);
  }
};

void install(QTranslator* translator, const QString& name, const QString& folder) {
  if (translator->load(name, folder)) QCoreApplication::installTranslator(translator);
}

// The system's language of numbers may be another one than that of texts.
bool is_german(Language language) {
  if (language == Language::system) {
    return QLocale(QLocale::system().uiLanguages().value(0)).language() == QLocale::German;
  }
  return language == Language::german;
}

}  // namespace

void install_translations(QCoreApplication& application, Language language) {
  const QString folder = ":/translations";
  install(new Translator(&application), "brume_en", folder);
  keep_titles_in_sentences(is_german(language));
  if (!is_german(language)) return;
  install(new QTranslator(&application), "qtbase_de",
          QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(new Translator(&application), "brume_de", folder);
}

}  // namespace brume
