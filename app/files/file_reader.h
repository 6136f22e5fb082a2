#pragma once

#include <QObject>
#include <QString>
#include <exception>
#include <filesystem>
#include <functional>

#include "app/jobs/job_thread.h"

namespace brume {

// Reads files of one kind in the background and delivers them in the thread of `owner`, which holds
// this object. Only the latest request counts.
template <class T>
class FileReader {
 public:
  using Read = std::function<T(const std::filesystem::path&)>;  // may throw
  using Use = std::function<void(const T&)>;
  using Refuse = std::function<void(const QString& problem)>;

  FileReader(QObject* owner, Read read)
      : owner_(owner),
        read_(std::move(read)),
        thread_([this](const Job& job, const std::stop_token&) { work(job); }) {}

  void start(const std::filesystem::path& file, Use use, Refuse refuse) {
    thread_.start({++ticket_, file, std::move(use), std::move(refuse)});
  }
  void cancel() {
    ++ticket_;
    thread_.cancel();
  }

 private:
  struct Job {
    int ticket;
    std::filesystem::path file;
    Use use;
    Refuse refuse;
  };

  void work(const Job& job) {
    try {
      answer(job, [use = job.use, result = read_(job.file)] { use(result); });
    } catch (const std::exception& error) {
      answer(job, [refuse = job.refuse, text = QString::fromUtf8(error.what())] { refuse(text); });
    }
  }

  template <class Call>
  void answer(const Job& job, Call call) {
    QMetaObject::invokeMethod(
        owner_,
        [this, ticket = job.ticket, call] {
          if (ticket == ticket_) call();
        },
        Qt::QueuedConnection);
  }

  QObject* owner_;
  Read read_;
  int ticket_ = 0;  // used in the owner's thread
  JobThread<Job> thread_;
};

}  // namespace brume
