#pragma once

#include <memory>
#include <vector>

#include "bench/run/protocol/conversation.hpp"

namespace tautline::bench {

/// The processes of one engine: a process does one run at a time, and the next one after it.
class Children {
 public:
  explicit Children(KeptCommand command) : command_(std::move(command)) {}

  /// A process for one run, which goes back when the run is over.
  class Lease {
   public:
    explicit Lease(Children& from) : from_(&from), conversation_(from.take()) {}
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    ~Lease() { from_->give_back(conversation_); }

    Conversation* operator->() const { return conversation_; }
    Conversation& operator*() const { return *conversation_; }

   private:
    Children* from_;
    Conversation* conversation_;
  };

  [[nodiscard]] double processor_time() const;  // [s], of those that are alive
  [[nodiscard]] double peak_memory() const;     // [bytes], of the largest
  void forget_peak_memory() const;              // from here on it is what is held from here on

 private:
  [[nodiscard]] Conversation* take();
  void give_back(Conversation* conversation);

  struct Process {
    std::unique_ptr<Conversation> conversation;
    bool busy;
  };
  KeptCommand command_;
  std::vector<Process> processes_;
};

}  // namespace tautline::bench
