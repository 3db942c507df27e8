#include "jobs/api_key.h"

#include "base/error.h"
#include "store_places.h"

namespace regarment {
namespace {

using KeyTest = JobStoreTest;

TEST_F(KeyTest, OpensWithTheSecretAndNothingElse) {
  const std::string text = issue_key(*store_, "scanner", {Scope::Submit, Scope::Read});
  const auto key = find_presented_key(*store_, text);
  ASSERT_TRUE(key);
  EXPECT_EQ(key->name, "scanner");
  EXPECT_EQ(key->created, time_.now());
  EXPECT_TRUE(key->may(Scope::Submit) && key->may(Scope::Read));
  EXPECT_FALSE(key->may(Scope::Review) || key->may(Scope::Admin));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string wrong = text;
    wrong[i] = wrong[i] == '0' ? '1' : '0';
    EXPECT_FALSE(find_presented_key(*store_, wrong)) << i;
  }
  EXPECT_FALSE(find_presented_key(*store_, ""));
  EXPECT_FALSE(find_presented_key(*store_, text + "0"));
  EXPECT_FALSE(find_presented_key(*store_, std::string(5000, 'x')));
}

TEST_F(KeyTest, StoresNoSecret) {
  const std::string text = issue_key(*store_, "k", {Scope::Admin});
  const auto stored = store_->find_key(text.substr(4, 12));
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->hash, key_hash(text.substr(17)));
  EXPECT_EQ(stored->hash.find(text.substr(17)), std::string::npos);
  EXPECT_TRUE(stored->key.may(Scope::Review));  // an administrator may everything
}

TEST_F(KeyTest, ClosesOnceRevoked) {
  const std::string text = issue_key(*store_, "k", {Scope::Read});
  issue_key(*store_, "l", {Scope::Read});
  const std::string id = find_presented_key(*store_, text)->id;
  EXPECT_TRUE(store_->revoke_key(id));
  EXPECT_FALSE(store_->revoke_key(id));
  EXPECT_FALSE(find_presented_key(*store_, text));
  ASSERT_EQ(store_->keys().size(), 2U);
  EXPECT_EQ(store_->keys()[0].revoked, time_.now());
  EXPECT_FALSE(store_->keys()[1].revoked);
}

TEST_F(KeyTest, NeedsANameAndAScope) {
  EXPECT_THROW(issue_key(*store_, "", {Scope::Read}), UsageError);
  EXPECT_THROW(issue_key(*store_, std::string(101, 'x'), {Scope::Read}), UsageError);
  EXPECT_THROW(issue_key(*store_, "k", {}), UsageError);
  EXPECT_TRUE(store_->keys().empty());
}

}  // namespace
}  // namespace regarment
