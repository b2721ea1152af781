#include "sailmap/csim/scheduler.hpp"

#include <algorithm>
#include <boost/context/fiber.hpp>
#include <boost/context/fixedsize_stack.hpp>
#include <boost/context/preallocated.hpp>
#include <boost/context/stack_context.hpp>
#include <exception>
#include <utility>

#include "sailmap/csim/stream.hpp"
#include "stack_switch.hpp"

namespace sailmap::csim {
namespace {

namespace context = boost::context;

constexpr std::size_t stack_bytes = std::size_t{128} * 1024;

Scheduler*& current_of_thread() {
  thread_local Scheduler* current = nullptr;
  return current;
}

// "(stage<A, 3>)" as the macro spells it, without the brackets.
std::string without_brackets(const std::string& name) {
  const bool bracketed = name.size() > 2 && name.front() == '(' && name.back() == ')';
  return bracketed ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

class Task {
 public:
  explicit Task(std::string name) : name_(std::move(name)) {
    context::fixedsize_stack allocator(stack_bytes);
    const context::stack_context memory = allocator.allocate();
    stack_ = {static_cast<const char*>(memory.sp) - memory.size, memory.size};
    fibre_ = context::fiber(std::allocator_arg, context::preallocated(memory.sp, memory.size, memory),
                            allocator, [this](context::fiber&& caller) { return body(std::move(caller)); });
  }
  // Unwinds the task where it hangs.
  ~Task() {
    if (!started_) {
      work_.clear();
      resume();
    }
    if (ended()) return;
    void* kept = nullptr;
    leave_for(stack_, &kept);
    fibre_ = context::fiber();
    arrived(kept);
  }
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  Task(Task&&) = delete;
  Task& operator=(Task&&) = delete;

  void add(std::function<void()> work) { work_.push_back(std::move(work)); }
  void resume() {
    void* kept = nullptr;
    leave_for(stack_, &kept);
    fibre_ = std::move(fibre_).resume();
    arrived(kept);
  }
  void suspend() {
    Absence absence(*this);
    caller_ = std::move(caller_).resume();
  }

  [[nodiscard]] bool ended() const { return !fibre_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::exception_ptr failure() const { return failure_; }

  // The FIFO the task waits for, and how.
  const Fifo* blocked_on = nullptr;
  bool blocked_writing = false;

 private:
  // The time between leaving the task's stack and being back, by return or by unwinding.
  class Absence {
   public:
    explicit Absence(Task& task) : task_(task) { leave_for(task_.caller_stack_, &kept_); }
    ~Absence() { task_.caller_stack_ = arrived(kept_); }
    Absence(const Absence&) = delete;
    Absence& operator=(const Absence&) = delete;
    Absence(Absence&&) = delete;
    Absence& operator=(Absence&&) = delete;

   private:
    Task& task_;
    void* kept_ = nullptr;
  };

  context::fiber body(context::fiber&& caller) {
    caller_stack_ = arrived(nullptr);
    started_ = true;
    caller_ = std::move(caller);
    try {
      while (!work_.empty()) {
        const std::function<void()> work = std::move(work_.front());
        work_.pop_front();
        work();
      }
    } catch (const context::detail::forced_unwind&) {
      leave_for(caller_stack_, nullptr);
      throw;  // the task is being destroyed
    } catch (...) {
      failure_ = std::current_exception();
    }
    leave_for(caller_stack_, nullptr);
    return std::move(caller_);
  }

  std::string name_;
  std::deque<std::function<void()>> work_;
  bool started_ = false;
  StackBounds stack_;
  StackBounds caller_stack_;
  context::fiber fibre_;
  context::fiber caller_;
  std::exception_ptr failure_;
};

Scheduler::Scheduler(std::size_t depth) : depth_(depth), outer_(std::exchange(current_of_thread(), this)) {
  if (depth == 0) throw std::invalid_argument("a FIFO of depth 0 passes nothing");
}

Scheduler::~Scheduler() {
  finish();
  current_of_thread() = outer_;
}

Scheduler& Scheduler::current() {
  if (current_of_thread() == nullptr)
    throw std::logic_error("a stage or FIFO is used without a csim::Scheduler");
  return *current_of_thread();
}

Task& Scheduler::add_task(const std::string& name) {
  if (running_ != nullptr) throw std::logic_error("'" + name + "' is launched while the network runs");
  tasks_.push_back(std::make_unique<Task>(without_brackets(name)));
  ready_.push_back(tasks_.back().get());
  return *tasks_.back();
}

void Scheduler::launch(const std::string& name, const void* key, const std::vector<Fifo*>& fifos,
                       std::function<void()> work) {
  Task*& task = task_of_key_[key];
  if (task == nullptr) task = &add_task(name);
  for (Fifo* fifo : fifos) fifo->connect(*this, *task);
  task->add(std::move(work));
}

void Scheduler::launch(const std::string& name, const std::vector<Fifo*>& fifos, std::function<void()> work) {
  Task& task = add_task(name);
  for (Fifo* fifo : fifos) fifo->connect(*this, task);
  task.add(std::move(work));
}

void Scheduler::run() {
  high_water_.clear();
  try {
    while (!ready_.empty()) {
      Task& task = *ready_.front();
      ready_.pop_front();
      resume(task);
      if (task.failure()) std::rethrow_exception(task.failure());
    }
    check_all_ended();
    check_no_leftovers();
  } catch (...) {
    finish();
    throw;
  }
  finish();
}

void Scheduler::resume(Task& task) {
  running_ = &task;
  task.resume();
  running_ = nullptr;
}

void Scheduler::suspend() { running_->suspend(); }

// Each task that hangs waits for the task at the other end of one FIFO. Following these waits from any task
// leads into a circle, which is the fault, or to a task whose partner has ended.
std::vector<const Task*> Scheduler::circle_from(const Task& start) {
  std::vector<const Task*> path = {&start};
  while (true) {
    const Task* const next = path.back()->blocked_on->peer(*path.back());
    if (next == nullptr || next->ended()) return {path.back()};
    const auto seen = std::find(path.begin(), path.end(), next);
    if (seen != path.end()) return {seen, path.end()};
    path.push_back(next);
  }
}

void Scheduler::check_all_ended() const {
  const auto hangs = [](const auto& task) { return !task->ended(); };
  const auto first = std::find_if(tasks_.begin(), tasks_.end(), hangs);
  if (first == tasks_.end()) return;
  std::string waits;
  for (const Task* task : circle_from(**first)) {
    waits += (waits.empty() ? "" : "; ") + task->name() +
             (task->blocked_writing ? " waits to write " : " waits to read ") + task->blocked_on->state();
  }
  throw NetworkError("deadlock of " + std::to_string(std::count_if(tasks_.begin(), tasks_.end(), hangs)) +
                     " stages, because " + waits);
}

void Scheduler::check_no_leftovers() const {
  std::string left;
  for (const Fifo* fifo : fifos_) {
    if (fifo->count_ == 0) continue;
    left += (left.empty() ? "" : "; ") + fifo->state();
  }
  if (!left.empty()) throw NetworkError("words left at the end: " + left);
}

// Unwinds what still hangs and gives the FIFOs back, empty.
void Scheduler::finish() {
  tasks_.clear();
  task_of_key_.clear();
  ready_.clear();
  for (Fifo* fifo : fifos_) {
    std::size_t& most = high_water_[fifo->name_];
    most = std::max(most, fifo->most_);
    fifo->detach();
  }
  fifos_.clear();
}

void Fifo::connect(Scheduler& owner, Task& task) {
  if (owner_ == nullptr) {
    owner_ = &owner;
    owner_->attach(*this);
    depth_ = owner_->depth();
    prepare(depth_);
  }
  if (users_[0] == &task || users_[1] == &task) return;
  if (users_[1] != nullptr) {
    throw NetworkError("FIFO '" + name_ + "' has more than two ends: " + users_[0]->name() + ", " +
                       users_[1]->name() + " and " + task.name());
  }
  users_[users_[0] == nullptr ? 0 : 1] = &task;
}

void Fifo::bind(Task*& end, const char* role) {
  Scheduler& scheduler = owner_ != nullptr ? *owner_ : Scheduler::current();
  Task* const task = scheduler.running();
  if (task == nullptr) throw std::logic_error("FIFO '" + name_ + "' is used outside a stage");
  connect(scheduler, *task);
  if (end != nullptr) {
    throw NetworkError("FIFO '" + name_ + "' has a second " + role + ": " + end->name() + " and " +
                       task->name());
  }
  end = task;
}

void Fifo::wait() {
  Task* const task = owner_->running();
  task->blocked_on = this;
  task->blocked_writing = task == writer_ && count_ == depth_;
  waiting_ = task;
  owner_->suspend();
}

void Fifo::detach() {
  owner_ = nullptr;
  writer_ = nullptr;
  reader_ = nullptr;
  users_[0] = nullptr;
  users_[1] = nullptr;
  waiting_ = nullptr;
  count_ = 0;
  most_ = 0;
}

std::string Fifo::state() const {
  const char* const filling = count_ == 0 ? "empty" : count_ == depth_ ? "full" : "filled";
  std::string others;
  for (const Task* user : users_) {
    if (user != nullptr && user->ended()) others += ", " + user->name() + " has ended";
  }
  if (users_[1] == nullptr) others += ", with one end only";
  return "'" + name_ + "' (" + filling + ", " + std::to_string(count_) + " of " + std::to_string(depth_) +
         others + ")";
}

}  // namespace sailmap::csim
