// The exact reference as a front end.
#include <utility>

#include "frontends.hpp"
#include "sailmap/error.hpp"
#include "sailmap/ref/model.hpp"

namespace sailmap {
namespace {

class Reference : public Frontend {
 public:
  [[nodiscard]] std::string_view name() const override { return "reference"; }

  void compute(const ImageView& image, Maps& maps) override {
    check_image_size(image);
    ref::Model model = ref::compute<ref::Exact>(image);
    maps.image_width = image.width;
    maps.image_height = image.height;
    for (std::size_t i = 0; i < feature_count; ++i) maps.features[i].samples = std::move(model.features[i]);
    maps.feature_statistics = model.feature_statistics;
    for (std::size_t i = 0; i < conspicuity_count; ++i) {
      maps.conspicuities[i].samples = std::move(model.conspicuities[i]);
    }
    maps.conspicuity_statistics = model.conspicuity_statistics;
    maps.saliency.samples = std::move(model.saliency);
  }
};

}  // namespace

std::unique_ptr<Frontend> make_reference() { return std::make_unique<Reference>(); }

}  // namespace sailmap
