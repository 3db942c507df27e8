#include "base/sha256.h"

#include <gtest/gtest.h>

#include <span>
#include <string>

namespace regarment {
namespace {

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

// The examples NIST publishes with FIPS 180.
TEST(Sha256, PublishedExamples) {
  EXPECT_EQ(sha256_hex(bytes("")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex(bytes("abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex(bytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(bytes("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
                             "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu")),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(sha256_hex(bytes(std::string(1'000'000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Padding changes its shape at 55, 56, 63 and 64 bytes; pieces must not matter at any of them.
TEST(Sha256, PiecesGiveTheSameAsTheWhole) {
  for (std::size_t length = 0; length <= 130; ++length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i) text += static_cast<char>('a' + i % 26);
    for (const std::size_t cut : {std::size_t{0}, length / 3, length / 2, length}) {
      Sha256 sha;
      sha.add(bytes(text).first(cut));
      sha.add(bytes(text).subspan(cut));
      EXPECT_EQ(sha.hex(), sha256_hex(bytes(text))) << length << " cut at " << cut;
    }
  }
}

TEST(Sha256, ADigestOnTheWayChangesNothing) {
  Sha256 sha;
  sha.add(bytes("a"));
  EXPECT_EQ(sha.hex(), sha256_hex(bytes("a")));
  sha.add(bytes("bc"));
  EXPECT_EQ(sha.hex(), sha256_hex(bytes("abc")));
}

TEST(Sha256, BeginsAgainWhenAnotherIsAssigned) {
  Sha256 sha;
  sha.add(bytes("ab"));
  sha = {};
  sha.add(bytes("abc"));
  EXPECT_EQ(sha.hex(), sha256_hex(bytes("abc")));
}

// Computed with sha256sum of coreutils: one length on each side of every change of padding.
TEST(Sha256, LengthsAroundABlock) {
  EXPECT_EQ(sha256_hex(bytes(std::string(55, 'a'))),
            "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
  EXPECT_EQ(sha256_hex(bytes(std::string(56, 'a'))),
            "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
  EXPECT_EQ(sha256_hex(bytes(std::string(63, 'a'))),
            "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34");
  EXPECT_EQ(sha256_hex(bytes(std::string(64, 'a'))),
            "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

}  // namespace
}  // namespace regarment
