#include "core/io/gaussians/gaussian_csv.h"

#include <gtest/gtest.h>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/random.h"

namespace brume {
namespace {

using GaussianCsv = FolderTest;

TEST_F(GaussianCsv, ReadsBackExactlyWhatWasWritten) {
  Random random(1);
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 1000; ++i) {
    gaussians.push_back({random.point(1e3), random.power(-9, 9), random.power(-9, 9)});
  }
  write_gaussians_csv(folder_ / "a.csv", gaussians);
  EXPECT_EQ(read_gaussians_csv(folder_ / "a.csv"), gaussians);
}

TEST_F(GaussianCsv, FindsItsColumnsByName) {
  const auto file = folder_.write(
      "a.csv", "id, density,radius ,z,y,x,note\r\n7,1,2,3,4,5,a b\r\n\r\n8, 0.5,2e-1,-3,4,5,");
  const std::vector<Gaussian> expected{{{5, 4, 3}, 2, 1}, {{5, 4, -3}, 0.2, 0.5}};
  EXPECT_EQ(read_gaussians_csv(file), expected);
}

// The two Gaussians that each of these tables holds.
const std::vector<Gaussian> tabled{{{1, 2, 3}, 0.25, 0.5}, {{-4, 5, 6}, 1, 2}};

TEST_F(GaussianCsv, ReadsWhatSpreadsheetsAndOtherProgramsWrite) {
  const std::pair<const char*, std::string> tables[] = {
      {"a byte order mark", "\xef\xbb\xbfx,y,z,radius,density\r\n1,2,3,.25,.5\r\n-4,5,6,1,2\r\n"},
      {"semicolons and decimal commas", "x;y;z;radius;density\n1,0;2;3;0,25;5E-1\n-4;5;6;1;2\n"},
      {"a line that names the separator",
       "sep=;\nx;y;z;radius;density;a,b,c,d,e,f\n1;2;3;,25;,5\n-4;5;6;1;2\n"},
      {"tabs", "x\ty\tz\tradius\tdensity\n1\t2\t3\t0,25\t0,5\n-4\t5\t6\t1\t2\n"},
      {"blanks", "x y  z radius density \n1 2 3 .25 .5\n -4 5  6 1 2 \n"},
      {"quotes", "\"x\",\"y\",\"z\",\"radius\",\"density\"\n\"1\",2,3,\"0.25\",.5\n-4,5,6,1,2\n"},
      {"quoted separators and lines",
       "note,x,y,z,radius,density\n\"a, \"\"b\"\"\nc\",1,2,3,.25,.5\n5\" d,-4,5,6,1,2\n"},
      {"names of rows",
       "\"x\",\"y\",\"z\",\"radius\",\"density\"\n\"1\",1,2,3,.25,.5\n\"2\",-4,5,6,1,2"},
      {"names of rows under no name",
       "\"\",\"x\",\"y\",\"z\",\"radius\",\"density\"\n\"1\",1,2,3,.25,.5\n\"2\",-4,5,6,1,2"},
      {"names of ParaView",
       "\"radius\",\"density\",\"Points:0\",\"Points:1\",\"Points:2\"\n.25,.5,1,2,3\n1,2,-4,5,6\n"},
      {"capitals and blanks", " X , Y,Z ,Radius,DENSITY\n1 , 2,3,.25,.5\n-4,5,6,1,2\n"},
      {"comments",
       "# by \"hand\n\nx,y,z,radius,density\n#9,9,9,9,9\n1,2,3,.25,.5\n,,,,\n  # x\n-4,5,6,1,2\n"},
      {"a heading in a comment", "# of numpy\n# x,y,z,radius,density\n1,2,3,.25,.5\n-4,5,6,1,2\n"},
      {"line ends of the Macintosh", "x,y,z,radius,density\r1,2,3,.25,.5\r-4,5,6,1,2\r"},
      {"separators at the ends", "x,y,z,radius,density,\n1,2,3,.25,.5,\n-4,5,6,1,2,,\n"},
  };
  for (const auto& [what, text] : tables) {
    const auto file = folder_.write("a.csv", text);
    EXPECT_EQ(read_gaussians(file), tabled) << what;
    EXPECT_GE(max_gaussian_count(file), tabled.size()) << what;
  }
}

TEST_F(GaussianCsv, ReadsUtf16) {
  const std::string text = "x\ty\tz\tradius\tdensity\r\n1\t2\t3\t0,25\t0,5\r\n-4\t5\t6\t1\t2\r\n";
  std::string little = "\xff\xfe";
  std::string big = "\xfe\xff";
  for (const char c : text) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  EXPECT_EQ(read_gaussians(folder_.write("little.csv", little)), tabled);
  EXPECT_EQ(read_gaussians(folder_.write("big.csv", big)), tabled);
}

TEST_F(GaussianCsv, ErrorsNameLineAndColumn) {
  const auto refusal = [&](std::string_view text) {
    const auto file = folder_.write("a.csv", text);
    return error_of([&] { read_gaussians_csv(file); });
  };
  const std::string header = "x,y,z,radius,density\n";
  EXPECT_TRUE(contains(refusal(""), "empty"));
  EXPECT_TRUE(contains(refusal("x,y,z,radius\n"), "density"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4\n"), "line 2, density: is missing"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,5\n1,2,abc,4,5\n"), "line 3, z: found abc"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,0,5\n"), "line 2, radius: found 0"));
  EXPECT_TRUE(contains(refusal(header + "1,nan,3,1,5\n"), "line 2, y: found nan"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,1,-5\n"), "line 2, density"));
  EXPECT_TRUE(
      contains(refusal("lon,lat,alt\n1,2,3\n"), "line 1: there is no column x; found lon,lat"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,5\n1,2,3,4,5,6\n"), "line 3: found 6 cells"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,\"5,5\"\n"), "line 2, density: found 5,5"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,\"5\n1,2,3,4,5\n"), "line 2, density: found \"5"));
  EXPECT_TRUE(contains(refusal("x;y;z;radius;density\n1.5;2;3;4;1,234\n"), "one decimal sign"));
  EXPECT_TRUE(contains(refusal(std::string("\0\1x,y", 5)), "is no text"));
  EXPECT_TRUE(contains(refusal("# nothing else\n"), "empty"));
}

TEST(GaussianIds, RoundTrip) {
  const TemporaryFolder folder;
  const std::vector<Gaussian> gaussians{{{1, 2, 3}, 0.5, 0.25}, {{4, 5, 6}, 1.5, 2.0}};
  const std::vector<GaussianNumber> ids{4294967295, 0};
  for (const char* name : {"a.csv", "a.ply"}) {
    write_gaussians(folder / name, gaussians, ids);
    std::vector<GaussianNumber> read;
    EXPECT_EQ(read_gaussians(folder / name, &read), gaussians);
    EXPECT_EQ(read, ids);
    EXPECT_EQ(read_gaussians(folder / name), gaussians);
  }
  std::vector<GaussianNumber> none;
  read_gaussians(folder.write("b.csv", "x,y,z,radius,density\n1,2,3,1,1\n"), &none);
  EXPECT_TRUE(none.empty());
  for (const char* id : {"-1", "0.5", "4294967296", "nan", "", "x"}) {
    const auto file =
        folder.write("c.csv", std::string("id,x,y,z,radius,density\n") + id + ",1,2,3,1,1\n");
    EXPECT_THROW(read_gaussians(file, &none), InputError) << id;
  }
}

}  // namespace
}  // namespace brume
