#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace sailmap::app {

using Clock = std::chrono::steady_clock;

Progress::Progress(std::string what, std::optional<int> total)
    : what_(std::move(what)), total_(total), watched_(::isatty(STDERR_FILENO) != 0), start_(Clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::step_to(int done) {
  if (!watched_) return;
  const auto now = Clock::now();
  const bool last = total_ && done >= *total_;
  if (!last && drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  draw(done);
}

void Progress::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  drawn_ = false;
}

void Progress::draw(int done) {
  constexpr int width = 30;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = seconds > 0 ? done / seconds : 0;
  if (total_ && *total_ > 0) {
    const int filled = static_cast<int>(static_cast<long>(width) * std::min(done, *total_) / *total_);
    const double left = rate > 0 ? (*total_ - done) / rate : 0;
    fmt::print(stderr, "\r\033[K{} [{:=<{}}{: <{}}] {}/{}  {:.1f}/s  {:.0f} s left", what_, "", filled, "",
               width - filled, done, *total_, rate, left);
  } else {
    fmt::print(stderr, "\r\033[K{} {}  {:.1f}/s", what_, done, rate);
  }
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace sailmap::app
