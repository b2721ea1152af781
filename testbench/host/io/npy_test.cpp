#include "sailmap/npy.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>

#include "error_matchers.hpp"
#include "needs.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using testing::TemporaryFolder;

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string output;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), part.size(), pipe.get()) != nullptr) output += part.data();
  return output;
}

const std::string python = "/usr/bin/python3 -c 'import sys, numpy\n";

// What NumPy makes of a file: its type, shape, order and samples.
std::string as_numpy_reads(const std::filesystem::path& path) {
  return output_of(python +
                   "a = numpy.load(sys.argv[1])\n"
                   "print(a.dtype.str, a.shape, a.flags.c_contiguous, a.tolist())' " +
                   path.string());
}

class Npy : public ::testing::Test {
 protected:
  void SetUp() override {
    SAILMAP_NEEDS_TOOL(output_of(python + "print(1)' 2>/dev/null") == "1\n", "/usr/bin/python3 with numpy");
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "map.npy";
};

// 3 wide, 2 high: (x, y) holds 10 y + x.
template <class T>
Plane<T> counting_plane() {
  Plane<T> plane(3, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) plane(x, y) = static_cast<T>(10 * y + x);
  }
  return plane;
}

TEST_F(Npy, WritesDoubles) {
  Plane<double> plane = counting_plane<double>();
  plane(2, 1) = 0.1;
  write_npy(path_, plane);
  EXPECT_EQ(as_numpy_reads(path_), "<f8 (2, 3) True [[0.0, 1.0, 2.0], [10.0, 11.0, 0.1]]\n");
}

TEST_F(Npy, WritesFloats) {
  write_npy(path_, counting_plane<float>());
  EXPECT_EQ(as_numpy_reads(path_), "<f4 (2, 3) True [[0.0, 1.0, 2.0], [10.0, 11.0, 12.0]]\n");
}

TEST_F(Npy, Writes16BitIntegers) {
  Plane<std::uint16_t> plane = counting_plane<std::uint16_t>();
  plane(0, 1) = std::numeric_limits<std::uint16_t>::max() - 1;
  write_npy(path_, plane);
  EXPECT_EQ(as_numpy_reads(path_), "<u2 (2, 3) True [[0, 1, 2], [65534, 11, 12]]\n");
}

TEST_F(Npy, Writes32BitIntegers) {
  Plane<std::uint32_t> plane = counting_plane<std::uint32_t>();
  plane(1, 0) = 0xDEADBEEF;
  write_npy(path_, plane);
  EXPECT_EQ(as_numpy_reads(path_), "<u4 (2, 3) True [[0, 3735928559, 2], [10, 11, 12]]\n");
}

TEST_F(Npy, WritesTheRawSamplesOfAMap) {
  write_npy(path_, Map{.samples = counting_plane<std::uint16_t>(), .lsb = 0.25, .format = "u8.2"});
  EXPECT_EQ(as_numpy_reads(path_), "<u2 (2, 3) True [[0, 1, 2], [10, 11, 12]]\n");
  write_npy(path_, Map{.samples = counting_plane<double>()});
  EXPECT_EQ(as_numpy_reads(path_), "<f8 (2, 3) True [[0.0, 1.0, 2.0], [10.0, 11.0, 12.0]]\n");
}

TEST_F(Npy, WritesAnEmptyPlane) {
  write_npy(path_, Plane<double>{});
  EXPECT_EQ(as_numpy_reads(path_), "<f8 (0, 0) True []\n");
}

TEST(NpyFile, HasItsSamplesAtAMultipleOf64Bytes) {
  const TemporaryFolder folder;
  for (const int width : {1, 10, 100, 1000, 100000}) {
    write_npy(folder.path() / "a.npy", Plane<std::uint16_t>(width, 1));
    const auto size = std::filesystem::file_size(folder.path() / "a.npy");
    EXPECT_EQ((size - 2 * static_cast<std::size_t>(width)) % 64, 0U) << width;
  }
}

TEST(NpyFile, CannotBeWrittenIntoAMissingFolder) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "missing" / "a.npy";
  EXPECT_THAT([&] { write_npy(path, Plane<double>(1, 1)); },
              testing::throws_naming(path, "cannot be written"));
}

}  // namespace
}  // namespace sailmap
