// Background jobs: what is delivered, and what is not.

#include <QLabel>
#include <QToolButton>
#include <atomic>
#include <semaphore>
#include <stdexcept>
#include <vector>

#include "app/jobs/background_job.h"
#include "app/jobs/job_bar.h"
#include "tests/app/test_window.h"

using namespace brume;
using Policy = BackgroundJob::Policy;

namespace {

// The signals of a job, in order.
class Told : public QStringList {
 public:
  explicit Told(BackgroundJob& job) {
    QObject::connect(&job, &BackgroundJob::ended, &job, [this] { push_back("ended"); });
    QObject::connect(&job, &BackgroundJob::finished, &job, [this] { push_back("finished"); });
    QObject::connect(&job, &BackgroundJob::cancelled, &job, [this] { push_back("cancelled"); });
    QObject::connect(&job, &BackgroundJob::failed, &job,
                     [this](const QString& why) { push_back("failed: " + why); });
  }
};

// Work that ends when it is stopped.
BackgroundJob::Apply endless(const Job& job) {
  std::binary_semaphore stopped(0);
  const std::stop_callback release(job.stop, [&] { stopped.release(); });
  stopped.acquire();
  return {};
}

}  // namespace

class JobsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_result_is_applied_in_the_main_thread() {
    Told* told = nullptr;
    std::thread::id applied;
    std::thread::id worked;
    BackgroundJob job(Policy::one_at_a_time);
    Told all(job);
    told = &all;
    QVERIFY(job.start([&](const Job&) {
      worked = std::this_thread::get_id();
      return [&] {
        applied = std::this_thread::get_id();
        told->push_back("applied");
      };
    }));
    QVERIFY(job.is_running());
    QTRY_VERIFY(!job.is_running());
    QCOMPARE(all, (QStringList{"ended", "applied", "finished"}));
    QVERIFY(applied == std::this_thread::get_id());
    QVERIFY(worked != applied);
  }

  void exceptions_are_reported() {
    BackgroundJob job(Policy::one_at_a_time);
    Told told(job);
    job.start([](const Job&) -> BackgroundJob::Apply { throw std::runtime_error("no luck"); });
    QTRY_VERIFY(!job.is_running());
    job.start([](const Job&) -> BackgroundJob::Apply { throw 1; });
    QTRY_VERIFY(!job.is_running());
    QCOMPARE(told, (QStringList{"ended", "failed: no luck", "ended", "failed: Unknown error"}));
  }

  void one_at_a_time_refuses_others() {
    BackgroundJob job(Policy::one_at_a_time);
    QVERIFY(job.start(endless));
    QVERIFY(!job.start(endless));
    job.cancel();
    QVERIFY(job.is_running());
    QVERIFY(!job.start(endless));
    QTRY_VERIFY(!job.is_running());
    QVERIFY(job.start(endless));
  }

  void the_latest_wins() {
    BackgroundJob job(Policy::latest_wins);
    Told told(job);
    std::vector<int> applied;
    // Replaced before it runs, while it runs, and after it has ended but is not delivered yet.
    std::binary_semaphore ran(0);
    const auto work = [&](int k) {
      return [&, k](const Job&) {
        ran.release();
        return [&, k] { applied.push_back(k); };
      };
    };
    job.start(endless);
    job.start(work(1));
    ran.acquire();
    job.start(endless);
    job.start(endless);
    job.start(work(2));
    QTRY_VERIFY(!job.is_running());
    QCOMPARE(applied, std::vector{2});
    QCOMPARE(told, (QStringList{"ended", "finished"}));
  }

  void cancelling_before_while_and_after() {
    for (const Policy policy : {Policy::one_at_a_time, Policy::latest_wins}) {
      BackgroundJob job(policy);
      Told told(job);
      bool applied = false;
      const auto apply = [&applied] { applied = true; };
      job.cancel();  // nothing runs
      QVERIFY(told.isEmpty());

      job.start([&](const Job&) { return apply; });
      job.cancel();  // perhaps before it has begun
      QTRY_VERIFY(!job.is_running());
      QCOMPARE(told, (QStringList{"ended", "cancelled"}));

      std::binary_semaphore begun(0);
      told.clear();
      job.start([&](const Job& work) -> BackgroundJob::Apply {
        begun.release();
        endless(work);
        return apply;
      });
      begun.acquire();
      job.cancel();
      QCOMPARE(job.is_running(), policy == Policy::one_at_a_time);
      QTRY_VERIFY(!job.is_running());
      QCOMPARE(told, (QStringList{"ended", "cancelled"}));

      // Done, but not delivered.
      told.clear();
      job.start([&](const Job&) -> BackgroundJob::Apply {
        begun.release();
        return apply;
      });
      begun.acquire();
      job.cancel();
      job.cancel();
      QTRY_VERIFY(!job.is_running());
      QCOMPARE(told, (QStringList{"ended", "cancelled"}));

      // A failure after that is none.
      told.clear();
      job.start([&](const Job& work) -> BackgroundJob::Apply {
        endless(work);
        throw std::runtime_error("stopped");
      });
      job.cancel();
      QTRY_VERIFY(!job.is_running());
      QCOMPARE(told, (QStringList{"ended", "cancelled"}));
      QVERIFY(!applied);

      told.clear();
      job.start([&](const Job&) { return apply; });
      QTRY_VERIFY(!job.is_running());
      job.cancel();  // too late
      QCOMPARE(told, (QStringList{"ended", "finished"}));
      QVERIFY(applied);
    }
  }

  void parts_and_progress_come_until_a_stop() {
    BackgroundJob job(Policy::one_at_a_time);
    std::vector<int> parts;
    std::vector<int> percents;
    connect(&job, &BackgroundJob::progressed, this,
            [&](int percent) { percents.push_back(percent); });
    const auto work = [&](const Job& running) -> BackgroundJob::Apply {
      for (const int k : {1, 2, 3}) {
        running.progress(k / 4.0);
        running.progress(k / 4.0);
        job.deliver(running, [&parts, k] { parts.push_back(k); });
      }
      return {};
    };
    job.start(work);
    QTRY_VERIFY(!job.is_running());
    QCOMPARE(parts, (std::vector{1, 2, 3}));
    QCOMPARE(percents, (std::vector{25, 50, 75}));

    std::binary_semaphore done(0);
    job.start([&](const Job& running) {
      work(running);
      done.release();
      return BackgroundJob::Apply();
    });
    done.acquire();
    job.cancel();
    QTRY_VERIFY(!job.is_running());
    QCOMPARE(parts.size(), 3u);
    QCOMPARE(percents.size(), 3u);
  }

  void destruction_stops_and_delivers_nothing() {
    bool told = false;
    std::weak_ptr<int> kept;
    for (const Policy policy : {Policy::one_at_a_time, Policy::latest_wins}) {
      std::binary_semaphore begun(0);
      std::atomic<bool> ended = false;
      {
        BackgroundJob job(policy);
        for (const auto signal : {&BackgroundJob::ended, &BackgroundJob::cancelled}) {
          connect(&job, signal, this, [&] { told = true; });
        }
        job.start([&](const Job& work) {
          begun.release();
          endless(work);
          ended = true;
          return [&] { told = true; };
        });
        begun.acquire();
      }
      QVERIFY(ended);
      {
        // The result is on its way while the main thread waits.
        BackgroundJob job(policy);
        auto result = std::make_shared<int>(1);
        kept = result;
        job.start([&, result = std::move(result)](const Job& work) {
          job.deliver(work, [&] { told = true; });
          begun.release();
          return [&, result] { told = true; };
        });
        begun.acquire();
      }
      QVERIFY(kept.expired());
    }
    QCoreApplication::processEvents();
    QVERIFY(!told);
  }

  void a_job_may_be_deleted_by_its_own_result() {
    auto* job = new BackgroundJob(Policy::one_at_a_time);
    const QPointer<BackgroundJob> alive(job);
    job->start([job](const Job&) { return [job] { delete job; }; });
    QTRY_VERIFY(!alive);
    job = new BackgroundJob(Policy::latest_wins);
    const QPointer<BackgroundJob> other(job);
    connect(job, &BackgroundJob::ended, this, [job] { delete job; });
    job->start(endless);
    job->cancel();
    QVERIFY(!other);
  }

  void a_result_may_start_the_next() {
    BackgroundJob job(Policy::one_at_a_time);
    int runs = 0;
    std::function<void()> again = [&] {
      if (++runs < 5) QVERIFY(job.start([&](const Job&) { return again; }));
    };
    again();
    QTRY_COMPARE(runs, 5);
    QTRY_VERIFY(!job.is_running());
  }

  void a_thousand_quick_restarts() {
    BackgroundJob job(Policy::latest_wins);
    std::vector<int> applied;
    std::atomic<int> at_once = 0;
    bool overlap = false;
    for (int k = 0; k < 1000; ++k) {
      job.start([&, k](const Job& work) {
        overlap = overlap || ++at_once > 1;
        if (k % 3 == 0 && k != 999) endless(work);
        --at_once;
        return [&, k] { applied.push_back(k); };
      });
      if (k % 7 == 0) job.cancel();
      if (k % 11 == 0) QCoreApplication::processEvents();
    }
    QTRY_VERIFY(!job.is_running());
    QVERIFY(!overlap);
    QCOMPARE(applied.back(), 999);
    QVERIFY(std::ranges::is_sorted(applied));
  }

  void the_bar_shows_titled_work_and_cancels_it() {
    BackgroundJob job(Policy::one_at_a_time);
    JobBar bar(job);
    QVERIFY(bar.isHidden());
    job.start(endless, "Counting sheep");
    QVERIFY(!bar.isHidden());
    QCOMPARE(bar.findChild<QLabel*>()->text(), "Counting sheep");
    bar.findChild<QToolButton*>()->click();
    QTRY_VERIFY(!job.is_running());
    QVERIFY(bar.isHidden());
    job.start(endless);
    QVERIFY(bar.isHidden());
  }
};

BRUME_APP_SUITE("jobs", JobsTest)
#include "jobs_test.moc"
