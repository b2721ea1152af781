// A value that most owners do not have: one pointer in size until it is given.
#pragma once

#include <memory>
#include <utility>

namespace sailmap {

// Behaves as a T; one that was never given equals T{}.
template <class T>
class OnDemand {
 public:
  OnDemand() = default;
  OnDemand(T value) : value_(std::make_unique<T>(std::move(value))) {}
  OnDemand(const OnDemand& other) : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
  OnDemand(OnDemand&&) noexcept = default;
  OnDemand& operator=(const OnDemand& other) {
    if (this != &other) *this = OnDemand(other);
    return *this;
  }
  OnDemand& operator=(OnDemand&&) noexcept = default;
  ~OnDemand() = default;

  [[nodiscard]] const T& get() const {
    static const T none{};
    return value_ ? *value_ : none;
  }
  operator const T&() const { return get(); }
  bool operator==(const OnDemand& other) const { return get() == other.get(); }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace sailmap
