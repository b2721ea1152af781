#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "error_matchers.hpp"
#include "sailmap/image_source.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;
using testing::throws_naming;

class ImageList : public ::testing::Test {
 protected:
  // The listed images, relative to the test's folder.
  [[nodiscard]] std::vector<std::string> listed(const std::string& source) const {
    std::vector<std::string> names;
    for (const auto& path : list_images((folder_.path() / source).string())) {
      names.push_back(path.lexically_relative(folder_.path()).string());
    }
    return names;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  void touch(const std::string& name) const { static_cast<void>(folder_.file(name, "x")); }

  testing::TemporaryFolder folder_;
};

TEST_F(ImageList, FolderHasItsImagesInNaturalOrder) {
  for (const char* name : {"s/10.png", "s/9.JPG", "s/1.tiff", "s/notes.txt", "s/deeper/2.png", "s/.3.png",
                           "s/._9.JPG", "s/png", "s/movie.mp4"}) {
    touch(name);
  }
  std::filesystem::create_directory(path("s/folder.png"));
  EXPECT_THAT(listed("s"), ElementsAre("s/1.tiff", "s/9.JPG", "s/10.png"));
  EXPECT_TRUE(is_image_list(path("s")));
}

TEST_F(ImageList, FolderWithoutImagesIsAnError) {
  touch("s/notes.txt");
  EXPECT_THAT([&] { list_images(path("s")); }, throws_naming(path("s"), "no image in this folder"));
}

TEST_F(ImageList, GlobMatchesOverFolders) {
  for (const char* name : {"run10/1.png", "run2/10.png", "run2/9.png", "run2/9.txt", "other/1.png"})
    touch(name);
  EXPECT_THAT(listed("run*/*"), ElementsAre("run2/9.png", "run2/10.png", "run10/1.png"));
  EXPECT_THAT(listed("run[0-9]/?.png"), ElementsAre("run2/9.png"));
  EXPECT_TRUE(is_image_list(path("run*/*")));
}

TEST_F(ImageList, GlobWithoutMatchesIsAnError) {
  touch("a.txt");
  EXPECT_THAT([&] { list_images(path("*.png")); }, throws_naming(path("*.png"), "no image matches"));
  EXPECT_THAT([&] { list_images(path("*.txt")); }, throws_naming(path("*.txt"), "no image matches"));
}

TEST_F(ImageList, NameWithBracketsThatExistsIsNoGlob) {
  touch("a[1].png");
  touch("a1.png");
  EXPECT_THAT(listed("a[1].png"), ElementsAre("a[1].png"));
}

TEST_F(ImageList, ListKeepsItsOrderAndIsRelativeToItsFolder) {
  touch("lists/b.png");
  touch("lists/sub/a name.jpg");
  touch("c.png");
  const auto list = folder_.file(
      "lists/l.txt", "\xEF\xBB\xBF# comment\nb.png\r\n\n  sub/a name.jpg \n" + path("c.png") + "\nb.png");
  EXPECT_THAT(listed("lists/l.txt"),
              ElementsAre("lists/b.png", "lists/sub/a name.jpg", "c.png", "lists/b.png"));
  EXPECT_TRUE(is_image_list(list.string()));
}

TEST_F(ImageList, ListThatNamesAMissingFileIsAnErrorWithItsLine) {
  touch("b.png");
  const auto list = folder_.file("l.txt", "b.png\n\nc.png\n");
  EXPECT_THAT([&] { list_images(list.string()); },
              throws_naming(list.string() + ":3", "no such file: " + path("c.png")));
}

TEST_F(ImageList, ListThatNamesAFolderIsAnErrorWithItsLine) {
  std::filesystem::create_directory(path("d"));
  const auto list = folder_.file("l.txt", "d\n");
  EXPECT_THAT([&] { list_images(list.string()); }, throws_naming(list.string() + ":1", "a folder"));
}

TEST_F(ImageList, EmptyOrBinaryOrMissingListIsAnError) {
  const auto empty = folder_.file("l.txt", "# nothing\n\n");
  EXPECT_THAT([&] { list_images(empty.string()); }, throws_naming(empty, "no image in this list"));
  const auto binary = folder_.file("b.txt", std::string("\0\1\2", 3));
  EXPECT_THAT([&] { list_images(binary.string()); }, throws_naming(binary, "not a text file"));
  EXPECT_THAT([&] { list_images(path("m.txt")); }, throws_naming(path("m.txt"), "no such file"));
}

TEST_F(ImageList, SingleImageIsAList) {
  touch("a.webp");
  EXPECT_THAT(listed("a.webp"), ElementsAre("a.webp"));
  EXPECT_THAT([&] { list_images(path("b.png")); }, throws_naming(path("b.png"), "no such file"));
  EXPECT_TRUE(is_image_list(path("b.png")));
}

TEST_F(ImageList, VideoOrCameraIsNoList) {
  touch("a.mp4");
  EXPECT_FALSE(is_image_list(path("a.mp4")));
  EXPECT_FALSE(is_image_list("0"));
  EXPECT_THAT([&] { list_images(path("a.mp4")); },
              throws_naming(path("a.mp4"), "not a folder, glob, list file"));
}

TEST(ImagePath, IsKnownByItsExtension) {
  for (const char* name :
       {"a.jpg", "a.JPEG", "b/c.d.png", "a.bmp", "a.tif", "a.TIFF", "a.webp", "a.ppm", "a.pgm"}) {
    EXPECT_TRUE(is_image_path(name)) << name;
  }
  for (const char* name : {"a.txt", "a", "jpg", "a.jpg.txt", "a.mp4", "a.exr", "jpg/a", ".png"}) {
    EXPECT_FALSE(is_image_path(name)) << name;
  }
}

}  // namespace
}  // namespace sailmap
