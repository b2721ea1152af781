#include <gmock/gmock.h>
#include <matio.h>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "error_matchers.hpp"
#include "sailmap/ground_truth.hpp"
#include "sailmap_data.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::throws_naming;

using MatFile = std::unique_ptr<mat_t, decltype(&Mat_Close)>;
using Variable = std::unique_ptr<matvar_t, decltype(&Mat_VarFree)>;

class MatGroundTruth : public ::testing::Test {
 protected:
  // What the matrices below say: 3 queries, 4 candidates.
  static auto expected() { return ElementsAre(ElementsAre(3), IsEmpty(), ElementsAre(0, 1)); }

  static MatFile create(const std::filesystem::path& path, mat_ft version = MAT_FT_MAT5) {
    return {Mat_CreateVer(path.c_str(), nullptr, version), &Mat_Close};
  }

  // Adds a 3 x 4 matrix with `value` at (0,3), (2,0) and (2,1).
  template <class T>
  static void add_dense(const MatFile& file, const char* name, matio_classes kind, matio_types type, T value,
                        int flags = 0, matio_compression compression = MAT_COMPRESSION_NONE) {
    std::array<std::size_t, 2> size = {3, 4};
    std::array<T, 12> columns{};
    columns[2] = columns[5] = columns[9] = value;
    const Variable variable(Mat_VarCreate(name, kind, type, 2, size.data(), columns.data(), flags),
                            &Mat_VarFree);
    ASSERT_EQ(Mat_VarWrite(file.get(), variable.get(), compression), 0);
  }

  [[nodiscard]] auto reading() const {
    return [this] { return read_mat_ground_truth(path_, 3, 4); };
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "gt.mat";
};

TEST_F(MatGroundTruth, ReadsDenseMatricesOfAnyType) {
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 0.5);
  EXPECT_THAT(reading()().matches, expected());
  add_dense(create(path_), "m", MAT_C_SINGLE, MAT_T_SINGLE, -1.0F);
  EXPECT_THAT(reading()().matches, expected());
  add_dense(create(path_), "m", MAT_C_UINT8, MAT_T_UINT8, std::uint8_t{255});
  EXPECT_THAT(reading()().matches, expected());
  add_dense(create(path_), "m", MAT_C_UINT8, MAT_T_UINT8, std::uint8_t{1}, MAT_F_LOGICAL);
  EXPECT_THAT(reading()().matches, expected());
  add_dense(create(path_), "m", MAT_C_INT16, MAT_T_INT16, std::int16_t{256});
  EXPECT_THAT(reading()().matches, expected());
  add_dense(create(path_), "m", MAT_C_UINT32, MAT_T_UINT32, std::uint32_t{65536});
  EXPECT_THAT(reading()().matches, expected());
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0, 0, MAT_COMPRESSION_ZLIB);
  EXPECT_THAT(reading()().matches, expected());
}

TEST_F(MatGroundTruth, ReadsSparseMatrices) {
  std::array<std::size_t, 2> size = {3, 4};
  std::array<mat_uint32_t, 4> rows = {2, 2, 1, 0};
  std::array<mat_uint32_t, 5> starts = {0, 1, 2, 3, 4};
  std::array<double, 4> values = {1, 1, 0, 1};  // a stored zero is a zero
  mat_sparse_t sparse{};
  sparse.nzmax = sparse.nir = sparse.ndata = 4;
  sparse.njc = 5;
  sparse.ir = rows.data();
  sparse.jc = starts.data();
  sparse.data = values.data();
  for (const auto compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    const Variable variable(
        Mat_VarCreate("m", MAT_C_SPARSE, MAT_T_DOUBLE, 2, size.data(), &sparse, MAT_F_DONT_COPY_DATA),
        &Mat_VarFree);
    ASSERT_EQ(Mat_VarWrite(create(path_).get(), variable.get(), compression), 0);
    EXPECT_THAT(reading()().matches, expected());
  }
}

TEST_F(MatGroundTruth, IgnoresWhatIsNoMatrix) {
  {
    const MatFile file = create(path_);
    std::array<std::size_t, 2> size = {1, 5};
    std::string text = "about";
    const Variable about(Mat_VarCreate("about", MAT_C_CHAR, MAT_T_UTF8, 2, size.data(), text.data(), 0),
                         &Mat_VarFree);
    ASSERT_EQ(Mat_VarWrite(file.get(), about.get(), MAT_COMPRESSION_NONE), 0);
    add_dense(file, "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0);
  }
  EXPECT_THAT(reading()().matches, expected());
}

TEST_F(MatGroundTruth, MustHoldOneMatrix) {
  { const MatFile nothing = create(path_); }
  EXPECT_THAT(reading(), throws_naming(path_, "no real two-dimensional numeric or logical matrix"));
  {
    const MatFile file = create(path_);
    add_dense(file, "first", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0);
    add_dense(file, "second", MAT_C_UINT8, MAT_T_UINT8, std::uint8_t{1});
  }
  EXPECT_THAT(reading(), throws_naming(path_, "several matrices (first, second)"));
}

TEST_F(MatGroundTruth, MustFitTheImages) {
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0);
  EXPECT_THAT([&] { read_mat_ground_truth(path_, 4, 4); },
              throws_naming(path_, "matrix of 3 x 4, but there are 4 queries and 4 candidates"));
  EXPECT_THAT([&] { read_mat_ground_truth(path_, 3, 3); },
              throws_naming(path_, "3 queries and 3 candidates"));
}

TEST_F(MatGroundTruth, MustHoldNumbers) {
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(reading(), throws_naming(path_, "not a number"));
}

TEST_F(MatGroundTruth, MustBeAMatlab5File) {
  EXPECT_THAT(reading(), throws_naming(path_, "no such file"));
  for (const std::string& content :
       {std::string(), std::string("text"), std::string(500, 'x'), std::string(500, '\0')}) {
    static_cast<void>(folder_.file("gt.mat", content));
    EXPECT_THAT(reading(), throws_naming(path_, "not a MATLAB file of version 5 to 7.2"));
  }
  add_dense(create(path_, MAT_FT_MAT73), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0);
  EXPECT_THAT(reading(), throws_naming(path_, "not a MATLAB file of version 5 to 7.2"));
}

// matio itself reads zeros, or what the memory held, where the file has ended.
TEST_F(MatGroundTruth, CutAnywhereIsAnError) {
  for (const auto compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0, 0, compression);
    const std::string whole = testing::content_of(path_);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      static_cast<void>(folder_.file("gt.mat", std::string_view(whole).substr(0, size)));
      EXPECT_THAT(reading(), throws_naming(path_, "")) << size << " of " << whole.size();
    }
  }
}

// A flipped bit may leave what is unpacked as it was (a hint in the zlib header, another copy of the same
// zeros).
TEST_F(MatGroundTruth, DamagedCompressedVariableIsAnErrorOrHarmless) {
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0, 0, MAT_COMPRESSION_ZLIB);
  const std::string whole = testing::content_of(path_);
  const std::size_t begin = 128 + 8;
  std::size_t errors = 0;
  for (std::size_t at = begin; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    static_cast<void>(folder_.file("gt.mat", damaged));
    try {
      EXPECT_THAT(reading()().matches, expected()) << at;
    } catch (const Error& error) {
      ++errors;
      EXPECT_THAT(error.what(), ::testing::HasSubstr("gt.mat: damaged MATLAB file")) << at;
    }
  }
  EXPECT_GT(errors, (whole.size() - begin) * 9 / 10);
}

// matio would take them at their word: gigabytes for a file of 400 bytes.
TEST_F(MatGroundTruth, SizesThatDoNotFitTheFileAreErrors) {
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0);
  const std::string whole = testing::content_of(path_);
  // The highest bytes of the sizes of the flags, the dimensions, the name (in its own tag) and the numbers.
  for (const std::size_t at : std::array<std::size_t, 4>{143, 159, 171, 183}) {
    std::string damaged = whole;
    damaged[at] = '\x60';
    static_cast<void>(folder_.file("gt.mat", damaged));
    EXPECT_THAT(reading(), throws_naming(path_, "damaged MATLAB file")) << at;
  }
}

TEST_F(MatGroundTruth, CellsAndStructuresAreNotRead) {
  add_dense(create(path_), "m", MAT_C_DOUBLE, MAT_T_DOUBLE, 1.0);
  std::string structure = testing::content_of(path_);
  structure[144] = MAT_C_STRUCT;
  static_cast<void>(folder_.file("gt.mat", structure));
  EXPECT_THAT(reading(), throws_naming(path_, "holds cells, structures or objects"));
}

TEST_F(MatGroundTruth, KeepsTheDiagonalOfTwoTraverses) {
  std::array<std::size_t, 2> size = {2, 2};
  std::array<double, 4> identity = {1, 0, 0, 1};
  {
    const Variable m(Mat_VarCreate("m", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), identity.data(), 0),
                     &Mat_VarFree);
    ASSERT_EQ(Mat_VarWrite(create(path_).get(), m.get(), MAT_COMPRESSION_NONE), 0);
  }
  EXPECT_THAT(read_ground_truth(path_, {.queries = 2, .candidates = 2, .same_sequence = false}).matches,
              ElementsAre(ElementsAre(0), ElementsAre(1)));
  EXPECT_THAT(read_ground_truth(path_, {.queries = 2, .candidates = 2}).matches,
              ElementsAre(IsEmpty(), IsEmpty()));
}

class FabMap : public ::testing::Test {
 protected:
  static GroundTruth read(const std::string& name, int images, bool oxford = false, Side side = Side::left) {
    return read_ground_truth(testing::data_folder() / "fabmap_ground_truth" / name,
                             {.queries = images, .candidates = images, .oxford = oxford, .side = side});
  }
  [[nodiscard]] static std::size_t pairs(const GroundTruth& truth) {
    std::size_t count = 0;
    for (const auto& matches : truth.matches) count += matches.size();
    return count;
  }
};

// The counts of matches here and below were taken from the matrices with SciPy.
TEST_F(FabMap, NewCollegeIsTheSameAsMatlabAndAsText) {
  SAILMAP_NEEDS_DATA("fabmap_ground_truth");
  const GroundTruth matlab = read("NewCollegeGroundTruth.mat", 2146);
  EXPECT_EQ(matlab.matches, read("NewCollegeGroundTruth.txt", 2146).matches);
  EXPECT_EQ(pairs(matlab), 14832U);
}

TEST_F(FabMap, CityCentreIsTheSameAsMatlabAndAsText) {
  SAILMAP_NEEDS_DATA("fabmap_ground_truth");
  const GroundTruth matlab = read("CityCentreGroundTruth_pairs.mat", 1237);
  EXPECT_EQ(matlab.matches, read("CityCentreGroundTruth_pairs.txt", 1237).matches);
  EXPECT_EQ(pairs(matlab), 8252U);
}

TEST_F(FabMap, NewCollegeHasASideEach) {
  SAILMAP_NEEDS_DATA("fabmap_ground_truth");
  for (const char* name : {"NewCollegeGroundTruth.mat", "NewCollegeGroundTruth.txt"}) {
    EXPECT_EQ(pairs(read(name, 1073, true, Side::left)), 3541U) << name;
    EXPECT_EQ(pairs(read(name, 1073, true, Side::right)), 3543U) << name;
  }
  // Image 2145, the last on the right, matches 29 31 33 35 37 ... on the right: pairs 14 15 16 17 18.
  const auto last = read("NewCollegeGroundTruth.mat", 1073, true, Side::right).matches.back();
  EXPECT_THAT(std::vector<int>(last.begin(), last.begin() + 5), ElementsAre(14, 15, 16, 17, 18));
}

TEST_F(FabMap, CityCentreIsOverPairsForEitherSide) {
  SAILMAP_NEEDS_DATA("fabmap_ground_truth");
  const GroundTruth pairs_of_images = read("CityCentreGroundTruth_pairs.mat", 1237);
  for (const Side side : {Side::left, Side::right}) {
    EXPECT_EQ(read("CityCentreGroundTruth_pairs.mat", 1237, true, side).matches, pairs_of_images.matches);
    EXPECT_EQ(read("CityCentreGroundTruth_pairs.txt", 1237, true, side).matches, pairs_of_images.matches);
  }
}

TEST_F(FabMap, WrongNumberOfImagesIsAnError) {
  SAILMAP_NEEDS_DATA("fabmap_ground_truth");
  EXPECT_THAT([] { read("NewCollegeGroundTruth.mat", 1000); },
              throws_naming(testing::data_folder() / "fabmap_ground_truth/NewCollegeGroundTruth.mat",
                            "matrix of 2146 x 2146, but there are 1000 queries"));
  EXPECT_THAT([] { read("CityCentreGroundTruth_pairs.mat", 1300, true); }, ::testing::Throws<Error>());
}

}  // namespace
}  // namespace sailmap
