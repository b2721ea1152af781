// C simulation: the stages of a dataflow region as tasks that take turns on one thread.
//
// A task is a Boost.Context fibre; it runs until a FIFO stops it (reading an empty one, writing a full one)
// or its work ends. Which task goes on next depends on nothing but the order of launching, so every run is
// the same run. A network of blocking FIFOs is deterministic beyond that (Kahn): whether it deadlocks at a
// depth does not depend on how fast its stages are, so a C simulation at depth 2 speaks for the hardware with
// FIFOs of depth 2 or more.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace sailmap::csim {

class Fifo;
class Task;

// The network is wrong: deadlock, words left in a FIFO at the end, a FIFO with two readers or two writers.
// The message names the FIFOs and the stages.
class NetworkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr std::size_t default_depth = 2;

// Runs one network on the calling thread. While a Scheduler lives it is the thread's current one; stages
// launched and FIFOs used on that thread belong to it.
class Scheduler {
 public:
  // `depth`: words every FIFO holds.
  explicit Scheduler(std::size_t depth = default_depth);
  ~Scheduler();
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;
  Scheduler(Scheduler&&) = delete;
  Scheduler& operator=(Scheduler&&) = delete;

  // Queues a piece of work on the task of that key, which uses those FIFOs. Work of one task is done in
  // order, as a hardware stage handles frame after frame; different tasks run side by side.
  void launch(const std::string& name, const void* key, const std::vector<Fifo*>& fifos,
              std::function<void()> work);
  // Queues work on a task of its own.
  void launch(const std::string& name, const std::vector<Fifo*>& fifos, std::function<void()> work);

  // Runs until all work is done. Throws NetworkError, or what a stage threw; the FIFOs are empty afterwards
  // either way.
  void run();

  // Most words each FIFO held in the run, by FIFO name.
  [[nodiscard]] const std::map<std::string, std::size_t>& high_water() const { return high_water_; }
  [[nodiscard]] std::size_t depth() const { return depth_; }

  // Throws std::logic_error when the thread has none.
  static Scheduler& current();

 private:
  friend class Fifo;

  Task& add_task(const std::string& name);
  void attach(Fifo& fifo) { fifos_.push_back(&fifo); }
  // A FIFO goes before the run's end.
  void forget(const Fifo& fifo) { std::erase(fifos_, &fifo); }
  // Called inside a task: leaves it until wake().
  void suspend();
  void wake(Task& task) { ready_.push_back(&task); }
  [[nodiscard]] Task* running() const { return running_; }

  void resume(Task& task);
  void check_all_ended() const;
  [[nodiscard]] static std::vector<const Task*> circle_from(const Task& start);
  void check_no_leftovers() const;
  void finish();

  std::size_t depth_;
  Scheduler* outer_;
  std::vector<std::unique_ptr<Task>> tasks_;  // in order of launching
  std::map<const void*, Task*> task_of_key_;
  std::deque<Task*> ready_;
  Task* running_ = nullptr;
  std::vector<Fifo*> fifos_;
  std::map<std::string, std::size_t> high_water_;
};

}  // namespace sailmap::csim
