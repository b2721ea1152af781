// One layout against many.
#pragma once

#include <memory>

#include "popcount.hpp"
#include "sailmap/place_descriptor.hpp"

namespace sailmap::context {

class LayoutQuery {
 public:
  static constexpr int reach = 4;  // columns to each side
  explicit LayoutQuery(const Layout& query);
  ~LayoutQuery();
  LayoutQuery(const LayoutQuery&) = delete;
  LayoutQuery& operator=(const LayoutQuery&) = delete;
  LayoutQuery(LayoutQuery&&) = delete;
  LayoutQuery& operator=(LayoutQuery&&) = delete;
  // See sailmap::layout_agreement.
  [[nodiscard]] double agreement(const Layout& candidate) const;

 private:
  struct Rows;
  std::unique_ptr<Rows> rows_;
};

}  // namespace sailmap::context
