// Files are replaced as a whole or not at all, and refusals say what would be right.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "output/fields.h"
#include "output/write.h"

namespace delos {
namespace {

Field small_volume() {
  return volume({{0, 0, 0}, {0.1, 0.1, 0.1}, {4, 3, 2}}, [](const Eigen::Vector3d& p) {
    return p.x() > 0.25 ? kBlind : 1 + p.y();
  });
}

void expect_says(const std::string& sentence, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(sentence.find(word), std::string::npos) << word << " in: " << sentence;
}

TEST(WriteField, WritesTheSameBytesAgain) {
  const Folder folder;
  for (const char* suffix : {".vti", ".vtp", ".csv", ".json", ".png"}) {
    ASSERT_EQ(write_field(small_volume(), folder / (std::string("a") + suffix)), "");
    ASSERT_EQ(write_field(small_volume(), folder / (std::string("b") + suffix)), "");
    const std::string bytes = bytes_of(folder / (std::string("a") + suffix));
    EXPECT_FALSE(bytes.empty());
    EXPECT_EQ(bytes, bytes_of(folder / (std::string("b") + suffix))) << suffix;
  }
  EXPECT_EQ(folder.files(), 10u) << "a temporary file was left";
}

TEST(WriteField, ReplacesAFile) {
  const Folder folder;
  write_bytes(folder / "f.csv", "old");
  ASSERT_EQ(write_field(scattered({1}), folder / "f.csv"), "");
  EXPECT_EQ(bytes_of(folder / "f.csv").substr(0, 2), "x,");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(WriteField, WritesThroughASymbolicLink) {
  const Folder folder;
  write_bytes(folder / "real.csv", "old");
  std::filesystem::create_symlink("real.csv", folder / "link.csv");
  ASSERT_EQ(write_field(scattered({1}), folder / "link.csv"), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.csv"));
  EXPECT_EQ(bytes_of(folder / "real.csv").substr(0, 2), "x,");
}

TEST(WriteField, ListsTheFormatsThatItKnows) {
  const Folder folder;
  const std::string known = "known are .vti .vtu .vtp .csv .json .png";
  expect_says(write_field(scattered({1}), folder / "f.xlsx"),
              {"f.xlsx", "'.xlsx'", known});
  expect_says(write_field(scattered({1}), folder / "f"), {"no suffix", known});
  EXPECT_EQ(write_field(scattered({1}), folder / "F.CSV"), "");
}

TEST(WriteField, SaysWhichFormatFits) {
  const Folder folder;
  expect_says(write_field(scattered({1}), folder / "f.vti"), {"volume", ".vtp"});
  expect_says(write_field(scattered({1}), folder / "f.png"),
              {"scattered", ".vtp", ".csv"});
  Field mesh = empty_field();
  add_part(mesh, {"", 0, 0, SurfaceShape{{{0, 0, 0}}}}, {{0, 0, 0}}, {1});
  expect_says(write_field(mesh, folder / "f.png"), {"on a mesh", ".vtp"});
  expect_says(write_field(mesh, folder / "f.vti"), {"volume", ".vtp"});
  EXPECT_EQ(write_field(mesh, folder / "mesh.csv"), "");
  EXPECT_EQ(write_field(mesh, folder / "mesh.json"), "");
  Field two = small_volume();
  const Field one = small_volume();
  add_part(two, one.samples.parts.front(), one.samples.points, one.value);
  expect_says(write_field(two, folder / "f.vti"),
              {"one volume", "2 sample sets", ".vtp"});
  EXPECT_EQ(write_field(two, folder / "f.png"), "");
  EXPECT_EQ(write_field(two, folder / "f.vtp"), "");
  expect_says(write_field(empty_field(), folder / "f.vti"), {"volume"});
  expect_says(write_field(empty_field(), folder / "f.png"), {"plane"});
}

TEST(WriteField, NamesAMissingFolder) {
  const Folder folder;
  expect_says(write_field(scattered({1}), folder / "no/f.csv"),
              {"no/f.csv", "doesn't exist"});
  write_bytes(folder / "file", "");
  expect_says(write_field(scattered({1}), folder / "file/f.csv"), {"is a file"});
  EXPECT_EQ(folder.files(), 1u);
}

TEST(WriteField, LeavesTheOldFileWhereNoTemporaryCanBeMade) {
  const Folder folder;
  // Longer by the temporary's ornaments, this name exceeds what Linux allows: 255
  // bytes.
  const std::string name = std::string(245, 'f') + ".csv";
  write_bytes(folder / name, "old");
  expect_says(write_field(scattered({1}), folder / name),
              {"can't be written", "File name too long"});
  EXPECT_EQ(bytes_of(folder / name), "old");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(WriteField, LeavesAFolderOfThatName) {
  const Folder folder;
  std::filesystem::create_directories(folder / "f.csv/inside");
  expect_says(write_field(scattered({1}), folder / "f.csv"), {"can't be replaced"});
  EXPECT_TRUE(std::filesystem::is_directory(folder / "f.csv/inside"));
  EXPECT_EQ(folder.files(), 1u);
}

/// Files end at `bytes` while it lives, as they do on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(WriteField, LeavesTheOldFileOnAFullDisk) {
  const Folder folder;
  const Field field = small_volume();
  for (const char* name : {"f.vti", "f.vtp", "f.csv", "f.json", "f.png"}) {
    write_bytes(folder / name, "old");
    std::string sentence;
    {
      // Less than any stream's buffer: the refusal comes as late as flush and close.
      const FullDisk disk(100);
      sentence = write_field(field, folder / name);
    }
    expect_says(sentence, {name, "can't be written", "File too large"});
    EXPECT_EQ(bytes_of(folder / name), "old") << name;
  }
  EXPECT_EQ(folder.files(), 5u) << "a temporary file was left";
}

TEST(Writable, AnswersAsWritingWould) {
  const Folder folder;
  const Field points = scattered({1});
  EXPECT_EQ(writable(small_volume().samples, folder / "f.vti"), "");
  EXPECT_EQ(writable(points.samples, folder / "f.csv"), "");
  for (const char* name : {"f.vti", "f.png", "f.doc", "no/f.csv"}) {
    const std::string why = writable(points.samples, folder / name);
    EXPECT_NE(why, "") << name;
    EXPECT_EQ(why, write_field(points, folder / name));
  }
  EXPECT_EQ(folder.files(), 0u);
}

}  // namespace
}  // namespace delos
