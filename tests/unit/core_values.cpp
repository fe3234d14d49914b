// Tests of the small parts of core: hashes, random numbers, text, units, assertions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/assert.h"
#include "core/environment.h"
#include "core/hash.h"
#include "core/one_line.h"
#include "core/random.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/units.h"
#include "core/utf8.h"

namespace thaum {
namespace {

std::uint64_t hash_text(std::string_view s, std::uint64_t seed = 0) {
    return hash_bytes(std::as_bytes(std::span(s.data(), s.size())), seed);
}

/// Hash of the bytes 0, 1, 2, ... n-1.
std::uint64_t hash_of_count(std::size_t n) {
    std::vector<std::byte> bytes(n);
    for (std::size_t i = 0; i < n; ++i) bytes[i] = static_cast<std::byte>(i);
    return hash_bytes(bytes);
}

TEST(CoreHash, IsXxh3) {
    EXPECT_EQ(hash_text(""), 0x2d06800538d394c2U);
    EXPECT_EQ(hash_bytes({}), 0x2d06800538d394c2U);
    EXPECT_EQ(hash_text("a"), 0xe6c632b61e964e1fU);
    EXPECT_EQ(hash_text("abc"), 0x78af5f94892f3950U);
    EXPECT_EQ(hash_of_count(1), 0xc44bdff4074eecdbU);
    EXPECT_EQ(hash_of_count(3), 0x5f4299fc161c9cbbU);
    EXPECT_EQ(hash_of_count(7), 0x0cd2084a62406b69U);
    EXPECT_EQ(hash_of_count(15), 0x55ecedc2b87bb042U);
    EXPECT_EQ(hash_of_count(32), 0x3523581fe96e4c05U);
    EXPECT_EQ(hash_of_count(64), 0x6187eb9089b0ed55U);
}

TEST(CoreHash, TheSeedMatters) {
    EXPECT_EQ(hash_bytes({}, 0x9e3779b185ebca8dU), 0xa8a6b918b2f0364aU);
    EXPECT_NE(hash_text("abc", 1), hash_text("abc", 2));
}

TEST(CoreHash, PiecesHashAsTheWhole) {
    std::vector<std::byte> bytes(1500);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7);
    const std::span<const std::byte> all = bytes;
    for (std::size_t n = 0; n <= bytes.size(); n += 50) {
        for (const std::size_t step : {1U, 16U, 120U, 1000U}) {
            HashOfPieces hash;
            for (std::size_t at = 0; at < n; at += step) hash.add(all.subspan(at, std::min(step, n - at)));
            EXPECT_EQ(hash.value(), hash_bytes(all.first(n))) << n << " bytes by " << step;
        }
    }
}

TEST(CoreHash, EveryBitOfAValueMatters) {
    std::set<std::uint64_t> seen{hash_value(std::uint64_t{0})};
    for (unsigned bit = 0; bit < 64; ++bit) seen.insert(hash_value(std::uint64_t{1} << bit));
    EXPECT_EQ(seen.size(), 65);
    EXPECT_NE(hash_value(0.0), hash_value(-0.0));
}

TEST(CoreHash, CombiningDependsOnTheOrder) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t a = 0; a < 100; ++a) {
        for (std::uint64_t b = 0; b < 100; ++b) seen.insert(hash_combine(a, b));
    }
    EXPECT_EQ(seen.size(), 10'000);
}

TEST(CoreRandom, IsSplitMix64) {
    Random random{1234567};
    for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                         4593380528125082431U, 16408922859458223821U}) {
        EXPECT_EQ(random.next(), expected);
    }
}

TEST(CoreRandom, UniformHasItsMeanAndVariance) {
    constexpr int n = 1'000'000;
    Random random{42};
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform();
        ASSERT_TRUE(u >= 0 && u < 1);
        sum += u;
        squares += (u - 0.5) * (u - 0.5);
    }
    EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
    EXPECT_NEAR(squares / n, 1.0 / 12, 5 * std::sqrt(1.0 / 180 / n));
}

TEST(CoreRandom, UniformStaysInItsInterval) {
    Random random{7};
    for (int i = 0; i < 100'000; ++i) {
        const double u = random.uniform(-3, 5);
        ASSERT_TRUE(u >= -3 && u < 5);
    }
}

/// Pearson's chi-squared statistic for ten faces. With 9 degrees of freedom it exceeds 27.9 once in a
/// thousand.
TEST(CoreRandom, BelowIsEven) {
    constexpr int n = 100'000;
    Random random{3};
    std::array<int, 10> counts{};
    for (int i = 0; i < n; ++i) ++counts.at(random.below(10));
    double chi = 0;
    for (const int c : counts) chi += (c - n / 10.0) * (c - n / 10.0) / (n / 10.0);
    EXPECT_LT(chi, 27.9);
}

TEST(CoreRandom, BelowReachesItsEnds) {
    Random random{9};
    EXPECT_EQ(random.below(1), 0);
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 1000; ++i) seen.insert(random.below(3));
    EXPECT_EQ(seen, (std::set<std::uint64_t>{0, 1, 2}));
    EXPECT_LT(random.below(std::numeric_limits<std::uint64_t>::max()),
              std::numeric_limits<std::uint64_t>::max());
}

TEST(CoreRandom, StreamsStartApart) {
    std::set<std::uint64_t> states;
    for (std::uint64_t stream = 0; stream < 10'000; ++stream) states.insert(random_stream(5, stream).state);
    EXPECT_EQ(states.size(), 10'000);
    EXPECT_NE(random_stream(1, 0).state, random_stream(2, 0).state);
}

TEST(CoreText, JoinsItsParts) {
    EXPECT_EQ(text("tick ", 12, " differs"), "tick 12 differs");
    EXPECT_EQ(text(), "");
    EXPECT_EQ(text('a', true, false, std::string("b"), std::string_view("c")), "atruefalsebc");
    EXPECT_EQ(text(std::uint8_t{7}, ' ', std::int8_t{-7}), "7 -7");
    EXPECT_EQ(text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
    EXPECT_EQ(text(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
}

TEST(CoreText, NumbersReadBack) {
    Random random{11};
    for (int i = 0; i < 20'000; ++i) {
        const auto value = std::bit_cast<double>(random.next());
        if (!std::isfinite(value)) continue;
        EXPECT_EQ(std::strtod(text(value).c_str(), nullptr), value);
    }
    EXPECT_EQ(text(0.1), "0.1");
    EXPECT_EQ(text(-0.0), "-0");
    EXPECT_EQ(text(0.1F), "0.1");
    EXPECT_EQ(text(std::numeric_limits<double>::infinity()), "inf");
}

TEST(CoreText, FixedPlaces) {
    EXPECT_EQ(fixed(1.25, 1), "1.2");
    EXPECT_EQ(fixed(-1.0, 3), "-1.000");
    EXPECT_EQ(fixed(2.5, 0), "2");
    EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 60).size(), 309 + 1 + 60);
    EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
}

TEST(CoreText, Clock) {
    EXPECT_EQ(clock_text(0), "0:00");
    EXPECT_EQ(clock_text(59), "0:59");
    EXPECT_EQ(clock_text(245), "4:05");
    EXPECT_EQ(clock_text(6000), "100:00");
    EXPECT_EQ(clock_text(~0ULL), "307445734561825860:15");
}

TEST(CoreText, Hex) {
    EXPECT_EQ(hex(0), "0000000000000000");
    EXPECT_EQ(hex(0xdeadbeefULL), "00000000deadbeef");
    EXPECT_EQ(hex(~0ULL), "ffffffffffffffff");
}

TEST(CoreUnits, TicksAndSeconds) {
    EXPECT_EQ(ticks(0), 0);
    EXPECT_EQ(ticks(0.0004), 0);
    EXPECT_EQ(ticks(0.0006), 1);
    EXPECT_EQ(ticks(60), 60'000);
    EXPECT_DOUBLE_EQ(seconds(1500), 1.5);
    for (Tick t = 0; t < 100'000; t += 7) ASSERT_EQ(ticks(seconds(t)), t);
    EXPECT_EQ(keyframe_interval % hash_interval, 0);
}

TEST(CoreAssertDeathTest, NamesFileLineAndMessage) {
    EXPECT_DEATH(THAUM_ASSERT(1 > 2, "one is " + text(1)), "core_values\\.cpp:[0-9]+: one is 1");
    EXPECT_DEATH((void)fixed(1, 61), "digits from 0 to 60");
    EXPECT_DEATH((void)fixed(1, -1), "digits from 0 to 60");
}

TEST(CoreAssert, LeavesAMetConditionAloneAndItsMessageUnbuilt) {
    int built = 0;
    const auto message = [&built] {
        ++built;
        return std::string("unused");
    };
    THAUM_ASSERT(true, message());
    EXPECT_EQ(built, 0);
}

TEST(Printable, LeavesPrintableCharacters) {
    for (const auto* words : {"", "Touch F0000001", "größer", "触覚", "\xf0\x9f\x8e\xae"})
        EXPECT_EQ(printable(words, 80), words);
}

TEST(Printable, NamesTheBytesOfControlCharacters) {
    EXPECT_EQ(printable("a\x1b[2Jb\r\n\x7f", 80), "a\\x1b[2Jb\\x0d\\x0a\\x7f");
    EXPECT_EQ(printable("\xc2\x9b 31m", 80), "\\xc2\\x9b 31m") << "a control character of two bytes";
    for (const auto& [turns_writing, bytes] : {std::pair{"\xe2\x80\xae", "\\xe2\\x80\\xae"},
                                               {"\xe2\x80\x8e", "\\xe2\\x80\\x8e"},
                                               {"\xe2\x80\x8f", "\\xe2\\x80\\x8f"},
                                               {"\xd8\x9c", "\\xd8\\x9c"}})
        EXPECT_EQ(printable(turns_writing, 80), bytes);
    EXPECT_EQ(printable(std::string_view("\0", 1), 80), "\\x00");
}

TEST(Printable, NamesBytesThatAreNoUtf8) {
    EXPECT_EQ(printable("\xff", 80), "\\xff");
    EXPECT_EQ(printable("\xc0\xaf", 80), "\\xc0\\xaf") << "longer encoding than necessary";
    EXPECT_EQ(printable("\xed\xa0\x80", 80), "\\xed\\xa0\\x80") << "half of a surrogate pair";
    EXPECT_EQ(printable("\xf4\x90\x80\x80", 80), "\\xf4\\x90\\x80\\x80") << "beyond the last character";
    EXPECT_EQ(printable("\xe8\xa7", 80), "\\xe8\\xa7") << "cut off";
}

TEST(Printable, CutsBetweenCharacters) {
    EXPECT_EQ(printable(std::string(100, 'x'), 10), "xxxxxxxxxx...");
    EXPECT_EQ(printable("aaaaaaaaa\x1b", 10), "aaaaaaaaa...");
    EXPECT_EQ(printable("ab\xe8\xa7\xa6", 4), "ab...");
}

TEST(Printable, InOneLineHasBlanksForEndsOfLinesAlone) {
    EXPECT_EQ(in_one_line("two\r\nlines\tand \x1b[2J"), "two  lines and \\x1b[2J");
    EXPECT_EQ(in_one_line("\xc2\x9b\xff"), "\\xc2\\x9b\\xff");
    EXPECT_EQ(in_one_line(std::string(1000, 'x') + "\xc3\xbc"), std::string(1000, 'x') + "...");
    EXPECT_EQ(in_one_line(std::string(999, 'x') + "\xc3\xbc"), std::string(999, 'x') + "...");
}

TEST(Environment, AnEmptyVariableIsNotSet) {
    ::setenv("THAUM_TEST_VARIABLE", "", 1);
    EXPECT_EQ(environment_value("THAUM_TEST_VARIABLE"), std::nullopt);
    ::setenv("THAUM_TEST_VARIABLE", " ", 1);
    EXPECT_EQ(environment_value("THAUM_TEST_VARIABLE"), " ");
    ::unsetenv("THAUM_TEST_VARIABLE");
    EXPECT_EQ(environment_value("THAUM_TEST_VARIABLE"), std::nullopt);
}

TEST(CoreUtf8, EveryCodePointReadsBack) {
    for (char32_t c = 0; c < 0x110000; c += c < 0x3000 ? 1 : 257) {
        const bool surrogate = c >= 0xD800 && c < 0xE000;
        EXPECT_EQ(decode_utf8(encode_utf8(c)), std::u32string(1, surrogate ? U'\uFFFD' : c));
    }
    EXPECT_EQ(encode_utf8(0x110000), encode_utf8(0xFFFD));
}

TEST(CoreUtf8, CapitalsAreThoseOfTheSystemsTable) {
    const std::u32string small = U"azàéöøþÿāıĳĸňżßάέόώαςσϋжяёґѓћӂӏӧ1.ツ";
    std::u32string capitals;
    for (const char32_t c : small) capitals += upper_case(c);
    EXPECT_EQ(capitals, U"AZÀÉÖØÞŸĀIĲĸŇŻßΆΈΌΏΑΣΣΫЖЯЁҐЃЋӁӏӦ1.ツ");
}

TEST(CoreExceptionDeathTest, AnExceptionOfAThreadIsOneLine) {
    EXPECT_EXIT(
        {
            tell_unhandled_exceptions();
            std::thread([] { throw std::runtime_error("two\nlines"); }).join();
        },
        ::testing::KilledBySignal(SIGABRT), "^thaum: a fault of the program: two lines\n$");
}

}  // namespace
}  // namespace thaum
