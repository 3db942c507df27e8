#include "service/upload.h"

#include <gtest/gtest.h>

#include "report/files.h"
#include "service/submit.h"
#include "support/folders.h"

namespace regarment {
namespace {

class UploadTest : public testing::Test {
 protected:
  static void add(Upload& upload, const FormPart& part, const std::string& data) {
    upload.begin_part(part);
    if (!data.empty()) upload.take_data(data);
    upload.end_part();
  }
  std::string hash_of(const std::vector<std::pair<std::string, std::string>>& parts) {
    Upload upload(folders_, {{"scan", 100}}, true);
    for (const auto& [name, data] : parts) add(upload, {name, {}, {}}, data);
    return upload.hash();
  }

  TemporaryFolder folder_;
  JobFolders folders_{folder_.path() / "data"};
};

TEST_F(UploadTest, FilesGoToTheDiskAndTextsStay) {
  Upload upload(folders_, {{"scan", 100}}, false);
  add(upload, {"scan", "../../a.ply", {}}, "bytes");
  add(upload, {"options", {}, {}}, "{}");
  EXPECT_EQ(read_file(upload.file("scan"), 100), "bytes");
  EXPECT_EQ(upload.file("scan").parent_path(), upload.folder());
  EXPECT_EQ(upload.text("options"), "{}");
  EXPECT_EQ(upload.filename("scan"), "../../a.ply");
  EXPECT_EQ(upload.text("missing"), "");
}

TEST_F(UploadTest, LeavesNothingUnlessItIsKept) {
  { const Upload upload(folders_, {}, false); }
  EXPECT_TRUE(names_in(folder_.path() / "data/incoming").empty());
  std::string id;
  {
    Upload upload(folders_, {}, false);
    id = upload.id();
    upload.accept();
    upload.keep();
  }
  EXPECT_EQ(names_in(folder_.path() / "data/jobs"), std::vector<std::string>{id});
}

TEST_F(UploadTest, RefusesTooMuchAndTheSameTwice) {
  Upload upload(folders_, {{"scan", 4}}, false);
  add(upload, {"scan", {}, {}}, "1234");
  EXPECT_THROW(upload.begin_part({"scan", {}, {}}), HttpProblem);
  upload.begin_part({"text", {}, {}});
  EXPECT_THROW(upload.take_data(std::string(70'000, 'x')), HttpProblem);
}

TEST_F(UploadTest, TheHashSpeaksOfNamesAndBytesAndNotOfTheirOrder) {
  const std::string hash = hash_of({{"scan", "1"}, {"options", "2"}});
  EXPECT_EQ(hash, hash_of({{"options", "2"}, {"scan", "1"}}));
  EXPECT_NE(hash, hash_of({{"options", "1"}, {"scan", "2"}}));
  EXPECT_NE(hash, hash_of({{"scan", "12"}, {"options", ""}}));
}

TEST_F(UploadTest, AScanIsNamedByWhatItIs) {
  Upload upload(folders_, {{"scan", 100}}, false);
  add(upload, {"scan", "a.txt", {}}, "ply\nformat ascii 1.0\n");
  place_scan(upload, "scan", upload.folder() / "scan");
  EXPECT_EQ(names_in(upload.folder()), std::vector<std::string>{"scan.ply"});
}

TEST_F(UploadTest, WhatIsNoScanIsRefused) {
  for (const auto& [name, bytes, status] :
       std::vector<std::tuple<std::string, std::string, int>>{{"a.ply", "", 422},
                                                              {"a.ply", "\x1f\x8b", 415},
                                                              {"a.obj", "ply\n", 415},
                                                              {"a", "v 0 0 0\n", 415}}) {
    Upload upload(folders_, {{"scan", 100}}, false);
    add(upload, {"scan", name, {}}, bytes);
    try {
      place_scan(upload, "scan", upload.folder() / "scan");
      ADD_FAILURE() << name;
    } catch (const HttpProblem& problem) {
      EXPECT_EQ(problem.status, status) << name;
    }
  }
}

}  // namespace
}  // namespace regarment
