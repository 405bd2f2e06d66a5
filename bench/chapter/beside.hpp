#pragma once

#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "bench/chapter/study.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// The source chapter computed again, as "chapter" of bench/report/report.schema.json: its tables,
/// its corrections (the swing it missed first), and its figures as curves thinned to what a plot
/// needs.
[[nodiscard]] nlohmann::ordered_json chapter_row(const ChapterStudy& study);

/// True if `options` runs all of the chapter's cases, each to its end.
[[nodiscard]] bool runs_the_chapter(const SuiteOptions& options);

/// The chapter, solved in a thread of its own while the runs go on.
class ChapterBeside {
 public:
  /// Starts if `wanted`. Destroyed, it gives up.
  explicit ChapterBeside(bool wanted);
  ~ChapterBeside() = default;
  ChapterBeside(const ChapterBeside&) = delete;
  ChapterBeside& operator=(const ChapterBeside&) = delete;
  ChapterBeside(ChapterBeside&&) = delete;
  ChapterBeside& operator=(ChapterBeside&&) = delete;

  /// Waits for the end: `chapter_row`, or null if it is not wanted, was interrupted or failed. To
  /// be called once.
  [[nodiscard]] nlohmann::ordered_json result();

  /// What went wrong, or "". To be asked after `result`.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  std::string failure_;
  std::promise<nlohmann::ordered_json> promise_;
  std::jthread thread_;
};

}  // namespace tautline::bench
