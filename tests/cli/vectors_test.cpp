// Loops over lanes are compiled for vectors of several widths, of which the processor's
// widest run: no operation is fused, so that the answers are the same to the last bit.
#include <gtest/gtest.h>
#include <stdlib.h>

#include "program.h"

namespace delos::test {
namespace {

/// Sets what programs find in the environment, for as long as it lives.
class Vectors {
 public:
  explicit Vectors(const char* width) { ::setenv("DELOS_VECTORS", width, 1); }
  ~Vectors() { ::unsetenv("DELOS_VECTORS"); }
  Vectors(const Vectors&) = delete;
  Vectors& operator=(const Vectors&) = delete;
};

std::string field_in(const char* width, const std::string& name) {
  const Vectors vectors(width);
  const Folder folder;
  const Finished done =
      run({"field", scene(name), "--out", "f.csv", "--threads", "2"}, folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  return read_file(folder / "f.csv");
}

// Ranges, cameras, and beacons of a HiBall.
TEST(Vectors, OfAnyWidthGiveTheSameBytes) {
  for (const char* name : {"01-acoustic", "02-eight-cameras", "hiball/six-lepd"}) {
    const std::string baseline = field_in("baseline", name);
    EXPECT_GT(baseline.size(), 1000u);
    EXPECT_EQ(field_in("avx2", name), baseline) << name;
    EXPECT_EQ(field_in("avx512", name), baseline) << name;
  }
}

}  // namespace
}  // namespace delos::test
