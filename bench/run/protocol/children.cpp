#include "bench/run/protocol/children.hpp"

#include <algorithm>

#include "bench/base/process.hpp"

namespace tautline::bench {

double Children::processor_time() const {
  double sum = 0.0;
  for (const Process& process : processes_) {
    sum += processor_time_of(process.conversation->process());
  }
  return sum;
}

double Children::peak_memory() const {
  double most = 0.0;
  for (const Process& process : processes_) {
    most = std::max(most, peak_memory_of(process.conversation->process()));
  }
  return most;
}

void Children::forget_peak_memory() const {
  for (const Process& process : processes_) {
    forget_peak_memory_of(process.conversation->process());
  }
}

Conversation* Children::take() {
  const auto idle = std::find_if(processes_.begin(), processes_.end(),
                                 [](const Process& process) { return !process.busy; });
  if (idle != processes_.end()) {
    idle->busy = true;
    return idle->conversation.get();
  }
  processes_.push_back({std::make_unique<Conversation>(command_), true});
  return processes_.back().conversation.get();
}

void Children::give_back(Conversation* conversation) {
  const auto process = std::find_if(processes_.begin(), processes_.end(), [&](const Process& one) {
    return one.conversation.get() == conversation;
  });
  process->busy = false;
  if (!conversation->sound()) {
    processes_.erase(process);
  }
}

}  // namespace tautline::bench
