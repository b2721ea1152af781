#include "independent_model.hpp"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace sailmap::testing {
namespace {

namespace fs = std::filesystem;

// NumPy's format, version 1.0: magic (6 bytes), version (2), header length (2, little endian), header,
// samples.
cv::Mat read_npy(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  char start[10] = {};
  in.read(start, sizeof start);
  const auto byte = [&start](int i) { return static_cast<std::uint8_t>(start[i]); };
  std::string header(byte(8) + 256U * byte(9), ' ');
  in.read(header.data(), static_cast<std::streamsize>(header.size()));
  const std::string doubles = "{'descr': '<f8', 'fortran_order': False, 'shape': (";
  if (!in || !header.starts_with(doubles)) throw std::runtime_error(path.string() + ": no npy of doubles");
  std::istringstream shape(header.substr(doubles.size()));
  int height = 0;
  int width = 0;
  char comma = 0;
  if (!(shape >> height >> comma >> width))
    throw std::runtime_error(path.string() + ": no npy of two dimensions");
  cv::Mat out(height, width, CV_64F);
  in.read(out.ptr<char>(), static_cast<std::streamsize>(out.total() * sizeof(double)));
  if (!in) throw std::runtime_error(path.string() + ": truncated");
  return out;
}

}  // namespace

bool has_independent_model() { return !std::string(SAILMAP_PYTHON).empty(); }

IndependentModel run_independent_model(const fs::path& image, const fs::path& folder) {
  std::ostringstream command;
  command << SAILMAP_PYTHON << ' ' << std::quoted(SAILMAP_INDEPENDENT_MODEL) << ' ' << image << ' ' << folder;
  if (std::system(command.str().c_str()) != 0) throw std::runtime_error("failed: " + command.str());
  IndependentModel out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".npy") out.maps[entry.path().stem().string()] = read_npy(entry.path());
  }
  std::ifstream in(folder / "maps.json");
  const auto statistics = nlohmann::json::parse(in);
  for (const auto& [name, values] : statistics.items()) {
    out.maxima[name] = values.at("maxima").get<int>();
  }
  return out;
}

}  // namespace sailmap::testing
