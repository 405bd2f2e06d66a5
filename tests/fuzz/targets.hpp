#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// The targets of the fuzzers. Each function takes any bytes. It throws, or a sanitizer stops it, if
// and only if the program breaks a promise of its headers.

namespace tautline::fuzz {

/// Reads the bytes as a case file of either kind, an ensemble spec, a limits file and a contract
/// file. Each reader accepts the text or refuses it in sentences. An accepted case or system has no
/// problems, and its text reads back bit by bit.
void fuzz_files(std::string_view input);

/// Reads the bytes as an answer from another process. The first byte chooses the request: 'a' to
/// 'e' are requests of the protocol, whose answer is a line; 'f' is a request to a worker.
void fuzz_protocol(std::string_view input);

/// Reads the bytes as report.json, suite.json and the file of a run. The reader of reports accepts
/// the text or refuses it in sentences. An accepted report can be judged, compared and written, and
/// its text reads back.
void fuzz_reports(std::string_view input);

/// Solves a system with extreme numbers, which the bytes choose, if it has no `problems`. The
/// motion keeps its limits of events and steps, its times rise, its numbers are finite, and
/// `solve_batch` finds the same one.
void fuzz_systems(std::string_view input);

/// Throws std::logic_error with `claim`, which does not hold.
inline void require(bool holds, const std::string& claim) {
  if (!holds) {
    throw std::logic_error(claim);
  }
}

/// Requires sentences that a terminal can show: at least one if `some`, otherwise none.
inline void require_sentences(const std::vector<std::string>& sentences, bool some) {
  require(sentences.empty() != some,
          some ? "what is refused has a reason" : "what is accepted has no problem");
  for (const std::string& sentence : sentences) {
    require(!sentence.empty(), "a reason is a sentence");
    for (const char one : sentence) {
      require(static_cast<unsigned char>(one) >= ' ' && one != '\x7f',
              "a sentence has no control characters: " + sentence);
    }
  }
}

}  // namespace tautline::fuzz
