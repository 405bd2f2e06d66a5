#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "bench/run/protocol/child.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {

/// The protocol with one child: a call is a request and its answer. Throws ProtocolError where the
/// child breaks the protocol, and EngineRefusal where it says that it cannot.
class Conversation {
 public:
  /// Starts the child and asks who it is.
  explicit Conversation(const KeptCommand& command);

  [[nodiscard]] const ChildInfo& info() const { return info_; }
  [[nodiscard]] pid_t process() const { return child_.process(); }

  /// False once the child broke the protocol: another run needs another child.
  [[nodiscard]] bool sound() const { return sound_; }

  /// Begins a run, and ends the one before.
  template <class TheCase>  // Case or SpatialSystem
  [[nodiscard]] ChildStart start(const TheCase& the_case, const ChildModel& model,
                                 const RunSettings& settings);
  [[nodiscard]] ChildSteps step(double dt, std::size_t count);
  [[nodiscard]] std::vector<double> fly(double dt);
  template <class TheState>  // State or SpatialSystemState
  [[nodiscard]] std::vector<double> place(const TheState& state);
  [[nodiscard]] ChildSolve solve(CableSet cables, const CableVector& rates);

 private:
  /// `request(id)` is the text of a request, `answer(line, id)` reads what comes back.
  template <class Request, class Answer>
  [[nodiscard]] auto exchange(std::string_view method, const Request& request,
                              const Answer& answer);

  Child child_;
  int id_ = 0;  // of the latest request
  bool sound_ = true;
  std::size_t cables_ = 0;  // of the case that runs
  StateForm form_;          // of its states
  ChildInfo info_;
};

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
