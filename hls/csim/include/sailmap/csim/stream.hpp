// C simulation: what stands for the tool's hls::stream when g++ compiles the kernels.
//
// Bounded at the hardware's depth, named, one writer and one reader. Faults are errors, never warnings: see
// Scheduler.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "sailmap/csim/scheduler.hpp"

namespace sailmap::csim {

// What a FIFO is apart from its words.
class Fifo {
 public:
  explicit Fifo(std::string name) : name_(std::move(name)) {}
  virtual ~Fifo() {
    if (owner_ != nullptr) owner_->forget(*this);
  }
  Fifo(const Fifo&) = delete;
  Fifo& operator=(const Fifo&) = delete;
  Fifo(Fifo&&) = delete;
  Fifo& operator=(Fifo&&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

 protected:
  // Returns once the running task, the only writer, may write one word.
  void before_write() {
    if (writer_ == nullptr || owner_->running() != writer_) bind(writer_, "writer");
    while (count_ == depth_) wait();
  }
  void after_write() {
    if (++count_ > most_) most_ = count_;
    wake_waiting();
  }
  void before_read() {
    if (reader_ == nullptr || owner_->running() != reader_) bind(reader_, "reader");
    while (count_ == 0) wait();
  }
  // Whether the running task, the only reader, may read one word without waiting.
  bool may_read() {
    if (reader_ == nullptr || owner_->running() != reader_) bind(reader_, "reader");
    return count_ != 0;
  }
  void after_read() {
    --count_;
    wake_waiting();
  }
  [[nodiscard]] std::size_t depth() const { return depth_; }

  // The words of a run that begins: room for `depth` of them.
  virtual void prepare(std::size_t depth) = 0;

 private:
  friend class Scheduler;

  void bind(Task*& end, const char* role);
  void wait();
  void wake_waiting() {
    if (waiting_ != nullptr) owner_->wake(*std::exchange(waiting_, nullptr));
  }
  // The run begins to use the FIFO; `task` is one of the two that will.
  void connect(Scheduler& owner, Task& task);
  void detach();
  // The task at the other end.
  [[nodiscard]] const Task* peer(const Task& task) const { return users_[users_[0] == &task ? 1 : 0]; }
  [[nodiscard]] std::string state() const;

  std::string name_;
  Scheduler* owner_ = nullptr;  // of the run that uses the FIFO now
  Task* writer_ = nullptr;
  Task* reader_ = nullptr;
  Task* users_[2] = {nullptr, nullptr};
  Task* waiting_ = nullptr;  // one at most: the FIFO cannot be full and empty
  std::size_t depth_ = 0;
  std::size_t count_ = 0;
  std::size_t most_ = 0;
};

template <class T>
class Stream : public Fifo {
 public:
  using Fifo::Fifo;

  void write(const T& word) {
    before_write();
    words_[put_] = word;
    if (++put_ == depth()) put_ = 0;
    after_write();
  }

  T read() {
    before_read();
    return take();
  }

  bool try_read(T& word) {
    if (!may_read()) return false;
    word = take();
    return true;
  }

 private:
  T take() {
    const T word = words_[get_];
    if (++get_ == depth()) get_ = 0;
    after_read();
    return word;
  }

  void prepare(std::size_t depth) override {
    words_.assign(depth, T{});
    put_ = 0;
    get_ = 0;
  }

  std::vector<T> words_;
  std::size_t put_ = 0;
  std::size_t get_ = 0;
};

namespace detail {

template <class Argument>
void add_if_fifo(std::vector<Fifo*>& fifos, Argument& argument) {
  if constexpr (std::is_base_of_v<Fifo, Argument>) fifos.push_back(&argument);
}

}  // namespace detail

// Queues a call of a stage function: streams are passed on by reference, scalars by value. Calls of one
// function run one after another, calls of different ones side by side.
template <class... Parameters, class... Arguments>
void launch(const char* name, void (*stage)(Parameters...), Arguments&&... arguments) {
  std::vector<Fifo*> fifos;
  (detail::add_if_fifo(fifos, arguments), ...);
  std::tuple<Parameters...> bound(std::forward<Arguments>(arguments)...);
  Scheduler::current().launch(name, reinterpret_cast<const void*>(stage), fifos,
                              [stage, bound] { std::apply(stage, bound); });
}

}  // namespace sailmap::csim
