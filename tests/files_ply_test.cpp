// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "files_samples.h"
#include "files_vcg_reader.h"
#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/ply_writer.h"

namespace mgf::io {
namespace {

using test::bytes_of;
using test::TemporaryFolder;
using test::VcgPlyElement;

TEST(PlyWriter, WritesTheseBytes) {
  const TemporaryFolder folder;
  const std::vector<double> reals{1.0, -2.0};
  const std::vector<Index> indices{258, kNone};
  PlyElement element{{"thing", 2, {}}, std::nullopt};
  element.table.columns = {real_column("real", reals),
                           index_column("index", indices),
                           {"byte", NumberType::kByte, [](std::size_t) { return 255.0; }}};
  write_ply(folder / "a.ply", "three kinds of number", {element});

  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment three kinds of number\n"
      "element thing 2\nproperty double real\nproperty int index\nproperty uchar byte\n"
      "end_header\n";
  using std::string_literals::operator""s;
  EXPECT_EQ(bytes_of(folder / "a.ply"), header + "\0\0\0\0\0\0\xF0\x3F"s + "\x02\x01\0\0"s +
                                            "\xFF" + "\0\0\0\0\0\0\0\xC0"s + "\xFF\xFF\xFF\xFF" +
                                            "\xFF");
}

TEST(PlyWriter, CountsLongListsWithAnInt) {
  const TemporaryFolder folder;
  Rows<Index> rows;
  rows.items.resize(256);
  std::iota(rows.items.begin(), rows.items.end(), Index{0});
  rows.close_row();
  const PlyElement element{{"face", 1, {}},
                           ListColumn{"vertex_indices", [&](std::size_t f) { return rows[f]; }}};
  write_ply(folder / "a.ply", "a polygon of 256 corners", {element});
  const std::string bytes = bytes_of(folder / "a.ply");
  EXPECT_NE(bytes.find("property list int int vertex_indices\n"), std::string::npos);
  EXPECT_EQ(bytes.size(), bytes.find("end_header\n") + 11 + std::size_t{4} * 257);
}

TEST(PlyWriter, KeepsEveryBitOfADouble) {
  const TemporaryFolder folder;
  const std::vector<double> reals{0.1, -0.0, std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::max(), 1.0 / 3.0};
  write_ply(folder / "a.ply", "reals", {{{"row", 5, {real_column("real", reals)}}, std::nullopt}});
  EXPECT_EQ(VcgPlyElement(folder / "a.ply", "row").scalars<double>("real"), reals);
}

TEST(PlyWriter, RefusesWhatNoReaderUnderstands) {
  const TemporaryFolder folder;
  const auto write = [&](double value, NumberType type) {
    const Column column{"measure", type, [value](std::size_t) { return value; }};
    write_ply(folder / "a.ply", "bad", {{{"vertex", 1, {column}}, std::nullopt}});
  };
  EXPECT_THROW(write(std::numeric_limits<double>::quiet_NaN(), NumberType::kReal), FileError);
  EXPECT_THROW(write(std::numeric_limits<double>::infinity(), NumberType::kReal), FileError);
  EXPECT_THROW(write(2147483648.0, NumberType::kInteger), FileError);
  EXPECT_THROW(write(std::numeric_limits<double>::quiet_NaN(), NumberType::kInteger), FileError);
  EXPECT_THROW(write(-1.0, NumberType::kByte), FileError);
  EXPECT_EQ(folder.file_count(), 0U);
  EXPECT_NO_THROW(write(2147483647.0, NumberType::kInteger));
}

TEST(PlyWriter, NamesTheRefusedNumber) {
  const TemporaryFolder folder;
  const std::vector<double> values{1.0, std::numeric_limits<double>::quiet_NaN()};
  try {
    write_ply(folder / "a.ply", "bad",
              {{{"edge", 2, {real_column("girth", values)}}, std::nullopt}});
    FAIL() << "written";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("edge 1: girth is"), std::string::npos)
        << error.what();
    EXPECT_EQ(error.path(), folder / "a.ply");
  }
}

TEST(AtomicFile, ReplacesAnOlderFileOnlyWhenWhole) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "old";
  {
    AtomicFile file(folder / "a.txt");
    file.append("new");
    EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
    file.commit();
  }
  EXPECT_EQ(bytes_of(folder / "a.txt"), "new");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(AtomicFile, LeavesNothingWhenGivenUp) {
  const TemporaryFolder folder;
  {
    AtomicFile file(folder / "a.txt");
    file.append(std::string(std::size_t{3} << 20, 'x'));
  }
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(AtomicFile, PassesOverWhatAKilledRunLeft) {
  const TemporaryFolder folder;
  const std::string left = ".a.txt." + std::to_string(::getpid()) + "-0.part";
  std::ofstream(folder / left) << "half";
  AtomicFile file(folder / "a.txt");
  file.append("whole");
  file.commit();
  EXPECT_EQ(bytes_of(folder / "a.txt"), "whole");
  EXPECT_EQ(bytes_of(folder / left), "half");
}

TEST(AtomicFile, IsReadableLikeAnyNewFile) {
  const TemporaryFolder folder;
  std::ofstream(folder / "other.txt") << "x";
  AtomicFile file(folder / "a.txt");
  file.commit();
  EXPECT_EQ(std::filesystem::status(folder / "a.txt").permissions(),
            std::filesystem::status(folder / "other.txt").permissions());
}

TEST(AtomicFile, SaysWhyAFolderCantBeWritten) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "no folder";
  EXPECT_THROW(AtomicFile(folder / "missing" / "a.txt"), FileError);
  EXPECT_THROW(AtomicFile(folder / "file" / "a.txt"), FileError);
  EXPECT_THROW(AtomicFile("/proc/a.txt"), FileError);
  try {
    const AtomicFile file(folder / "missing" / "a.txt");
    FAIL() << "opened";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos);
  }
}

TEST(AtomicFile, DoesNotTakeThePlaceOfAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a.txt");
  {
    AtomicFile file(folder / "a.txt");
    file.append("x");
    EXPECT_THROW(file.commit(), FileError);
  }
  EXPECT_EQ(folder.file_count(), 1U);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a.txt"));
}

// Stands for a full disk: the system refuses to let files grow past a limit.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &former_);
    former_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, former_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  FileSizeLimit(FileSizeLimit&&) = delete;
  FileSizeLimit& operator=(FileSizeLimit&&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &former_);
    std::signal(SIGXFSZ, former_handler_);
  }

 private:
  rlimit former_{};
  void (*former_handler_)(int) = nullptr;
};

TEST(AtomicFile, LeavesTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "old";
  {
    const FileSizeLimit limit(100'000);
    AtomicFile file(folder / "a.txt");
    EXPECT_THROW(
        {
          file.append(std::string(200'000, 'x'));
          file.commit();
        },
        FileError);
  }
  EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1U);
}

}  // namespace
}  // namespace mgf::io
