#include "bench/measure/certification.hpp"

#include <utility>

#include "bench/base/process.hpp"
#include "bench/solution/certify.hpp"

namespace tautline::bench {
namespace {

/// Decimal digits of the other solution. It loses as many as the double does, which has 16: of 30
/// more than 9 are right wherever the double has one.
constexpr int many_digits = 30;

CertifiedDigits certified(const ReferenceCase& reference) {
  const Certificate certificate =
      certify(reference.the_case, {.law = reference.law}, reference.solution, many_digits);
  return {certificate.digits, {certificate.correct.begin(), certificate.correct.end()}};
}

}  // namespace

Certification::Certification(const std::vector<Reference>& references, bool wanted)
    : digits_(references.size()) {
  if (wanted) {
    thread_ =
        std::jthread([this, &references](const std::stop_token& stop) { work(stop, references); });
  }
}

std::vector<std::optional<CertifiedDigits>> Certification::digits() {
  if (thread_.joinable()) {
    thread_.join();
  }
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  return std::move(digits_);
}

void Certification::work(const std::stop_token& stop, const std::vector<Reference>& references) {
  try {
    for (std::size_t place = 0;
         place < references.size() && !stop.stop_requested() && !interruption(); ++place) {
      if (const auto* const of_case = std::get_if<ReferenceCase>(&references[place])) {
        digits_[place] = certified(*of_case);
      }
    }
  } catch (...) {
    failure_ = std::current_exception();
  }
}

}  // namespace tautline::bench
