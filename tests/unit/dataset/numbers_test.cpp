// SPDX-License-Identifier: MIT
// Random numbers and hashes against published vectors, functions against the library's.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "dermis/error.h"
#include "support/files.h"
#include "support/thrown.h"
#include "tools/dataset/exact.h"
#include "tools/dataset/philox.h"
#include "tools/dataset/sha256.h"

namespace dermis::dataset {
namespace {

// kat_vectors of Random123, "philox4x32 10".
TEST(Philox, GivesTheKnownAnswers) {
  constexpr std::uint32_t ones = 0xFFFFFFFFu;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, StreamsAreUniformAndApart) {
  double sum = 0, squares = 0, product = 0;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const double a = Stream(7, "a", static_cast<std::uint64_t>(i)).next() - 0.5,
                 b = Stream(7, "b", static_cast<std::uint64_t>(i)).next() - 0.5;
    ASSERT_GE(a, -0.5);
    ASSERT_LT(a, 0.5);
    sum += a, squares += a * a, product += a * b;
  }
  EXPECT_NEAR(sum / count, 0, 0.01);
  EXPECT_NEAR(squares / count, 1.0 / 12, 0.002);
  EXPECT_NEAR(product / count, 0, 0.002);
  EXPECT_NE(Stream(7, "a", 1).next(), Stream(8, "a", 1).next());
  EXPECT_NE(Stream(7, "a", 1).next(), Stream(7, "a", std::uint64_t{1} << 32).next());
}

// FNV's own test: the empty text, and "foobar".
TEST(Philox, PathsAreHashedByFnv) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);
}

TEST(Exact, FunctionsAreThoseOfTheLibrary) {
  for (const double x : {1e-300, 1e-8, 0.3, 0.7071, 0.99999, 1.0, 1.5, 42.0, 1e300})
    EXPECT_NEAR(exact_log(x), std::log(x), 2e-15 * std::max(1.0, std::abs(std::log(x)))) << x;
  for (const double x : {-700.0, -3.3, -0.2, 0.0, 1e-9, 0.34, 1.0, 20.0, 700.0})
    EXPECT_NEAR(exact_exp(x) / std::exp(x), 1, 2e-13) << x;
  for (const double p : {1e-12, 1e-4, 0.02, 0.3, 0.5, 0.9, 0.99999}) {
    const double z = normal_quantile(p);
    EXPECT_NEAR(0.5 * std::erfc(-z / std::sqrt(2.0)) / p, 1, 2e-7) << p;
  }
}

// FIPS 180-4's examples, and a million times "a".
TEST(Sha256, GivesTheKnownAnswers) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  Sha256 hash;
  for (int i = 0; i < 1000; ++i) hash.add(std::string(1000, 'a'));
  EXPECT_EQ(hash.digest(), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnPieces) {
  for (std::size_t size = 0; size < 200; ++size) {
    const std::string text(size, 'x');
    Sha256 hash;
    for (std::size_t at = 0; at < size; at += 7) hash.add(std::string_view(text).substr(at, 7));
    EXPECT_EQ(hash.digest(), sha256(text)) << size;
  }
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
  const tests::TempFolder folder;
  const std::string text(3'000'000, 'q');
  tests::write_text(folder.path() / "a", text);
  EXPECT_EQ(hash_of_file(folder.path() / "a"), (FileHash{sha256(text), text.size()}));
  EXPECT_NE(tests::thrown<InputError>([&] { hash_of_file(folder.path() / "b"); }).find("no such file"),
            std::string::npos);
}

}  // namespace
}  // namespace dermis::dataset
