// Numbers as the editor shows them.

#include <limits>

#include "app/document/text/number_text.h"
#include "tests/app/test_window.h"

using namespace brume;

class NumberTextTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void numbers_are_plain() {
    QCOMPARE(number_text(0.918), "0.918");
    QCOMPARE(number_text(0.7), "0.7");
    QCOMPARE(number_text(-0.25), "-0.25");
    QCOMPARE(number_text(0.1 + 0.2), "0.3");
    QCOMPARE(number_text(1.0 / 3.0), "0.333333");
    QCOMPARE(number_text(1.0 / 3.0, 3), "0.333");
    QCOMPARE(number_text(0.0001), "0.0001");
    QCOMPARE(number_text(120.0), "120");
    QCOMPARE(number_text(1234567.0), "1234567");
    QCOMPARE(number_text(9.9999999), "10");
    QCOMPARE(number_text(999.96, 3), "1000");
  }

  void what_is_next_to_nothing_is_zero() {
    for (const double value : {0.0, -0.0, 1e-17, -1e-17, 5e-324}) {
      QCOMPARE(number_text(value), "0");
    }
    // The smallest radius there is.
    QCOMPARE(number_text(1e-12), "1e-12");
    QCOMPARE(exact_number_text(-0.0), "0");
    QCOMPARE(fixed_text(-0.04, 1), "0.0");
    QCOMPARE(fixed_text(-0.06, 1), "-0.1");
  }

  void exponents_are_short() {
    QCOMPARE(number_text(1.2e-5), "1.2e-5");
    QCOMPARE(number_text(-4e12), "-4e12");
    QCOMPARE(exact_number_text(1e-5), "1e-5");
    QVERIFY(!number_text(std::numeric_limits<double>::infinity()).isEmpty());
  }

  void exact_numbers_come_back() {
    for (const double value : {0.1, 1.0 / 3.0, 1e-12, 12345678901.5, 1e300, -7.25e-9}) {
      QCOMPARE(exact_number_text(value).toDouble(), value);
    }
  }

  void shares_and_times() {
    QCOMPARE(percent_text(0.007), "0.7 %");
    QCOMPARE(percent_text(0.014), "1.4 %");
    QCOMPARE(percent_text(0.35), "35 %");
    QCOMPARE(percent_text(0.0), "0 %");
    QCOMPARE(percent_text(1e-6), "< 0.01 %");
    QCOMPARE(duration_text(8.24), "8.2 ms");
    QCOMPARE(duration_text(140.4), "140 ms");
    QCOMPARE(duration_text(999.7), "1.0 s");
    QCOMPARE(estimated_time_text(0.2), "1 s");
    QCOMPARE(estimated_time_text(184.0), "3 min 4 s");
    QCOMPARE(estimated_time_text(7800.0), "2 h 10 min");
  }
};

BRUME_APP_SUITE("number_text", NumberTextTest)
#include "number_text_test.moc"
