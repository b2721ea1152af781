// Drives the Verilog of one top, as Verilator compiles it, with the words of a file (the format is that of
// scripts/vitis/testbench.hpp) and compares every word that comes out. C++17; no code of the kernels, and
// none of Bambu's own test bench.
//
//   bench VECTORS SEED [network|ahead]   SEED 0: no stalls; any other: random stalls on every stream
//
// A kernel is started for each call and says when it is done. The stages of a network start themselves again
// as long as the start signal is there, so frames overlap: frames of one size are one run, and a reset goes
// before another size.
//
// `ahead`: a kernel that takes words of the next call, all but its last (store.hpp). At the ports of a top
// Bambu's try_read waits, so the first call's words are there once more behind the last call's.
//
// Checked: every word and the number of them in every call, that all input of a call was read and none of the
// next but `ahead`, that a word stays as it is while it waits to be taken (AXI4-Stream), that calls follow
// each other at once, and that something moves: `patience` cycles without a word are reported as a deadlock,
// with what each stream waits for. Prints one line of JSON: cycles of each call (of a network: from the last
// word of the frame before to its own) and the faults. Exit code 0: all right, 1: faults, 2: wrong use.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace sailmap {
namespace rtl {

// The words of one call.
struct Call {
  std::map<std::string, std::uint32_t> scalars;
  std::map<std::string, std::vector<std::uint64_t>> words;
};

[[noreturn]] inline void stop(const std::string& what) {
  std::cerr << "bench: " << what << '\n';
  std::exit(2);
}

inline std::vector<Call> read_calls(const std::string& path) {
  std::ifstream file(path);
  std::vector<Call> calls;
  std::string keyword;
  std::string port;
  while (file >> keyword) {
    if (keyword == "call") {
      calls.emplace_back();
      continue;
    }
    std::uint64_t number = 0;
    if (calls.empty() || !(file >> port >> std::dec >> number)) stop(path + ": broken at " + keyword);
    if (keyword == "scalar") {
      calls.back().scalars[port] = static_cast<std::uint32_t>(number);
      continue;
    }
    std::vector<std::uint64_t>& words = calls.back().words[port];
    words.resize(number);
    for (std::uint64_t& word : words) {
      if (!(file >> std::hex >> word)) stop(path + ": too few words of " + port);
    }
  }
  if (calls.empty()) stop(path + ": no vectors");
  return calls;
}

// Runs and pauses of random length, some of them long.
class Stalls {
 public:
  explicit Stalls(std::uint32_t seed) : random_(seed), stalls_(seed != 0) {}
  // Whether the stream stands still this cycle.
  bool next() {
    if (!stalls_) return false;
    if (left_ == 0) {
      paused_ = !paused_;
      left_ = random_() % 16 == 0 ? random_() % 200 + 1 : random_() % 8 + 1;
    }
    --left_;
    return paused_;
  }

 private:
  std::mt19937 random_;
  bool stalls_;
  bool paused_ = false;
  std::uint64_t left_ = 0;
};

// One AXI4-Stream of the top, seen from outside.
struct Stream {
  std::string name;
  bool is_input;
  std::function<void(std::uint64_t)> set_data;  // inputs
  std::function<std::uint64_t()> data;          // outputs
  CData* valid;                                 // driven for inputs
  CData* ready;                                 // driven for outputs
  Stalls stalls;
  std::vector<std::uint64_t> words;  // of all calls: to send, or expected
  std::vector<std::size_t> ends;     // behind the last word of each call
  std::size_t limit = 0;             // of the words that may be sent now
  std::size_t done = 0;              // words sent or received
  bool offered = false;              // a word waits
  std::uint64_t offered_word = 0;
};

template <class Model>
class Bench {
 public:
  Bench(int argc, char** argv) {
    if (argc < 3) stop("usage: bench VECTORS SEED [network|ahead]");
    const std::string kind = argc > 3 ? argv[3] : "";
    network_ = kind == "network";
    ahead_ = kind == "ahead";
    calls_ = read_calls(argv[1]);
    seed_ = static_cast<std::uint32_t>(std::stoul(argv[2]));
    // Registers and memories start with random contents: nothing may depend on what was there before.
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed_ + 1));
    model_ = std::make_unique<Model>(&context_);
  }

  Model& model() { return *model_; }

  template <class Data>
  void input(const std::string& name, Data& data, CData& valid, CData& ready) {
    Stream& stream = add(name, true, valid, ready);
    stream.set_data = [&data](std::uint64_t word) { data = static_cast<Data>(word); };
  }
  template <class Data>
  void output(const std::string& name, Data& data, CData& valid, CData& ready) {
    Stream& stream = add(name, false, valid, ready);
    stream.data = [&data] { return static_cast<std::uint64_t>(data); };
  }
  template <class Data>
  void scalar(const std::string& name, Data& data) {
    scalars_.emplace_back(name, [&data](std::uint32_t value) { data = static_cast<Data>(value); });
  }

  int run() {
    reset();
    if (!network_) {
      offer(calls_.size());
      for (std::size_t call = 0; call < calls_.size() && faults_.empty(); ++call) run_call(call);
    }
    for (std::size_t call = 0; network_ && call < calls_.size() && faults_.empty();) call = run_frames(call);
    for (int i = 0; i < 100 && faults_.empty(); ++i) cycle();  // nothing may follow
    if (faults_.empty()) check_counts(calls_.size() - 1);
    model_->final();
    report();
    return faults_.empty() ? 0 : 1;
  }

 private:
  // More than from the last pixel of a VGA frame to its record: two replays and the search for the regions.
  static constexpr std::uint64_t patience = 1000000;

  Stream& add(const std::string& name, bool is_input, CData& valid, CData& ready) {
    Stream stream{name,
                  is_input,
                  {},
                  {},
                  &valid,
                  &ready,
                  Stalls(seed_ == 0 ? 0 : seed_ * 1000 + static_cast<std::uint32_t>(streams_.size())),
                  {},
                  {}};
    for (const Call& call : calls_) {
      const auto words = call.words.find(name);
      if (words == call.words.end()) stop("no words of " + name);
      stream.words.insert(stream.words.end(), words->second.begin(), words->second.end());
      stream.ends.push_back(stream.words.size());
    }
    if (ahead_ && is_input) {
      const std::vector<std::uint64_t> first(
          stream.words.begin(), stream.words.begin() + static_cast<std::ptrdiff_t>(stream.ends[0]));
      stream.words.insert(stream.words.end(), first.begin(), first.end());
    }
    streams_.push_back(std::move(stream));
    return streams_.back();
  }

  void reset() {
    model_->clock = 0;
    model_->reset = 0;  // active low
    model_->start_port = 0;
    for (Stream& stream : streams_) (stream.is_input ? *stream.valid : *stream.ready) = 0;
    for (int i = 0; i < 4; ++i) edge();
    model_->reset = 1;
    edge();
  }

  void edge() {
    model_->clock = 0;
    model_->eval();
    model_->clock = 1;
    model_->eval();
    ++now_;
  }

  // One clock cycle with all streams; true when the call is done.
  bool cycle() {
    for (Stream& stream : streams_) {
      const bool pause = stream.stalls.next();
      if (!stream.is_input) {
        *stream.ready = pause ? 0 : 1;
        continue;
      }
      // Once offered, a word stays.
      stream.offered = stream.offered || (!pause && stream.done < stream.limit);
      *stream.valid = stream.offered ? 1 : 0;
      // Where nothing is offered the lines carry rubbish.
      stream.set_data(stream.offered ? stream.words[stream.done] : 0xa5a5a5a5a5a5a5a5U ^ now_);
    }
    model_->clock = 0;
    model_->eval();
    const bool done = model_->done_port != 0;
    for (Stream& stream : streams_) transfer(stream);
    model_->clock = 1;
    model_->eval();
    ++now_;
    return done;
  }

  void transfer(Stream& stream) {
    const bool moves = *stream.valid != 0 && *stream.ready != 0;
    if (moves) last_move_ = now_;
    if (stream.is_input) {
      if (moves) {
        stream.offered = false;
        ++stream.done;
      }
      return;
    }
    const std::uint64_t word = *stream.valid != 0 ? stream.data() : 0;
    if (stream.offered && *stream.valid == 0) fault(stream, "a word withdrawn");
    if (stream.offered && *stream.valid != 0 && word != stream.offered_word) fault(stream, "a word changed");
    stream.offered = *stream.valid != 0 && !moves;
    stream.offered_word = word;
    if (!moves) return;
    if (stream.done >= stream.words.size()) {
      fault(stream, "a word too many");
    } else if (word != stream.words[stream.done]) {
      std::ostringstream what;
      what << "word " << stream.done << " is " << std::hex << word << ", not " << stream.words[stream.done];
      fault(stream, what.str());
    }
    ++stream.done;
  }

  // Words of the calls before `end` may be sent.
  void offer(std::size_t end) {
    for (Stream& stream : streams_) stream.limit = ahead_ ? stream.words.size() : stream.ends[end - 1];
  }

  void set_scalars(std::size_t call) {
    for (const auto& scalar : scalars_) {
      const auto value = calls_[call].scalars.find(scalar.first);
      if (value == calls_[call].scalars.end()) stop("no scalar " + scalar.first);
      scalar.second(value->second);
    }
  }

  bool received(std::size_t call) const {
    for (const Stream& stream : streams_) {
      if (!stream.is_input && stream.done < stream.ends[call]) return false;
    }
    return true;
  }

  // All frames from `first` on that have its size; the number of the frame behind them.
  std::size_t run_frames(std::size_t first) {
    std::size_t end = first + 1;
    while (end < calls_.size() && calls_[end].scalars == calls_[first].scalars) ++end;
    reset();
    set_scalars(first);
    offer(end);
    model_->start_port = 1;
    last_move_ = now_;
    for (std::size_t call = first; call < end && faults_.empty(); ++call) {
      const std::uint64_t start = now_;
      while (!received(call) && faults_.empty()) {
        cycle();
        if (now_ - last_move_ > patience) deadlock(call);
      }
      cycles_.push_back(now_ - start);
    }
    for (int i = 0; i < 100 && faults_.empty(); ++i) cycle();  // nothing may follow
    model_->start_port = 0;
    if (faults_.empty()) check_counts(end - 1);
    return end;
  }

  void run_call(std::size_t call) {
    set_scalars(call);
    const std::uint64_t start = now_;
    last_move_ = now_;
    model_->start_port = 1;
    bool done = cycle();
    model_->start_port = 0;
    while (!done && faults_.empty()) {
      done = cycle();
      if (now_ - last_move_ > patience) deadlock(call);
    }
    cycles_.push_back(now_ - start);
    if (faults_.empty()) check_counts(call);
  }

  void check_counts(std::size_t call) {
    for (const Stream& stream : streams_) {
      if (stream.done == stream.ends[call]) continue;
      if (ahead_ && stream.is_input && stream.done > stream.ends[call] &&
          stream.done < end_of_next(stream, call))
        continue;
      fault(stream, std::to_string(stream.done) + " words by the end of call " + std::to_string(call + 1) +
                        ", not " + std::to_string(stream.ends[call]));
    }
  }

  static std::size_t end_of_next(const Stream& stream, std::size_t call) {
    return call + 1 < stream.ends.size() ? stream.ends[call + 1] : stream.words.size();
  }

  void deadlock(std::size_t call) {
    for (const Stream& stream : streams_) {
      fault(stream, "deadlock in call " + std::to_string(call + 1) + " at word " +
                        std::to_string(stream.done) + " of " + std::to_string(stream.ends[call]));
    }
  }

  void fault(const Stream& stream, const std::string& what) {
    faults_.push_back("cycle " + std::to_string(now_) + ", " + stream.name + ": " + what);
  }

  void report() const {
    std::cout << "{\"cycles\": [";
    for (std::size_t i = 0; i < cycles_.size(); ++i) std::cout << (i == 0 ? "" : ", ") << cycles_[i];
    std::cout << "], \"faults\": [";
    for (std::size_t i = 0; i < faults_.size(); ++i)
      std::cout << (i == 0 ? "" : ", ") << '"' << faults_[i] << '"';
    std::cout << "]}\n";
  }

  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  std::vector<Call> calls_;
  std::uint32_t seed_ = 0;
  bool network_ = false;
  bool ahead_ = false;
  std::vector<Stream> streams_;
  std::vector<std::pair<std::string, std::function<void(std::uint32_t)>>> scalars_;
  std::uint64_t now_ = 0;
  std::uint64_t last_move_ = 0;
  std::vector<std::uint64_t> cycles_;
  std::vector<std::string> faults_;
};

}  // namespace rtl
}  // namespace sailmap
