#include "core/bytes.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/random.h"

namespace thaum {
namespace {

constexpr auto max_64 = std::numeric_limits<std::uint64_t>::max();

Bytes bytes_of(std::initializer_list<unsigned> values) {
    Bytes result;
    for (const auto v : values) result.push_back(static_cast<std::byte>(v));
    return result;
}

/// Value of `bytes` read as one varint, and whether the reader accepted it.
std::pair<std::uint64_t, bool> varint_of(const Bytes& bytes) {
    ByteReader reader(bytes);
    const auto value = reader.get_varint();
    return {value, reader.ok()};
}

TEST(CoreBytes, ValuesLieLittleEndian) {
    Bytes out;
    ByteWriter(out).put(std::uint32_t{0x01020304});
    EXPECT_EQ(out, bytes_of({4, 3, 2, 1}));
}

TEST(CoreBytes, EveryKindReadsBack) {
    enum class Colour : std::uint8_t { red, green = 7 };
    Bytes out;
    ByteWriter writer(out);
    writer.put(std::int8_t{-5});
    writer.put(true);
    writer.put(Colour::green);
    writer.put(-0.0);
    writer.put(1.5F);
    writer.put_string("tick");
    writer.put_string("");
    ByteReader reader(out);
    EXPECT_EQ(reader.get<std::int8_t>(), -5);
    EXPECT_TRUE(reader.get<bool>());
    EXPECT_EQ(reader.get<Colour>(), Colour::green);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(reader.get<double>()), 1ULL << 63U);
    EXPECT_EQ(reader.get<float>(), 1.5F);
    EXPECT_EQ(reader.get_string(), "tick");
    EXPECT_EQ(reader.get_string(), "");
    EXPECT_TRUE(reader.ok());
    EXPECT_EQ(reader.left(), 0);
    EXPECT_EQ(reader.position(), out.size());
}

TEST(CoreBytes, VarintsAtTheirEdges) {
    for (unsigned bits = 0; bits <= 64; ++bits) {
        const std::uint64_t edge = bits == 64 ? max_64 : (1ULL << bits);
        for (const auto value : {edge - 1, edge, edge + 1}) {
            Bytes out;
            ByteWriter(out).put_varint(value);
            EXPECT_LE(out.size(), 10);
            EXPECT_EQ(varint_of(out), std::pair(value, true)) << value;
        }
    }
}

TEST(CoreBytes, WrongVarintsAreRefused) {
    EXPECT_FALSE(varint_of({}).second);
    EXPECT_FALSE(varint_of(bytes_of({0x80})).second);
    EXPECT_FALSE(varint_of(Bytes(10, std::byte{0x80})).second);
    Bytes too_large(9, std::byte{0xff});
    too_large.push_back(std::byte{0x02});  // sets a 65th bit, one too many
    EXPECT_FALSE(varint_of(too_large).second);
    too_large.back() = std::byte{0x01};
    EXPECT_EQ(varint_of(too_large), std::pair(max_64, true));
}

TEST(CoreBytes, ABoolIsNoughtOrOne) {
    for (const unsigned value : {2U, 0x80U, 0xffU}) {
        const auto bytes = bytes_of({value});
        ByteReader reader(bytes);
        EXPECT_FALSE(reader.get<bool>());
        EXPECT_FALSE(reader.ok());
    }
}

TEST(CoreBytes, EveryCutIsNoticedAndGivesZeros) {
    Bytes whole;
    ByteWriter writer(whole);
    writer.put(std::uint64_t{max_64});
    writer.put_varint(max_64);
    writer.put_string("a longer text");
    for (std::size_t cut = 0; cut < whole.size(); ++cut) {
        const std::span<const std::byte> all(whole);
        ByteReader reader(all.first(cut));
        const auto number = reader.get<std::uint64_t>();
        reader.get_varint();
        EXPECT_EQ(reader.get_string(), "") << cut;
        EXPECT_FALSE(reader.ok()) << cut;
        EXPECT_EQ(number, cut >= 8 ? max_64 : 0) << cut;
    }
}

TEST(CoreBytes, AFailedReaderStaysFailed) {
    const auto bytes = bytes_of({1, 2, 3});
    ByteReader reader(bytes);
    EXPECT_TRUE(reader.get_bytes(4).empty());
    EXPECT_EQ(reader.get<std::uint8_t>(), 0);
    EXPECT_EQ(reader.get_varint(), 0);
    EXPECT_TRUE(reader.get_bytes(0).empty());
    EXPECT_EQ(reader.left(), 3);
    EXPECT_FALSE(reader.ok());
}

TEST(CoreBytes, HugeLengthsReadNothing) {
    Bytes bytes;
    ByteWriter(bytes).put(std::numeric_limits<std::uint32_t>::max());
    ByteReader text_reader(bytes);
    EXPECT_EQ(text_reader.get_string(), "");
    EXPECT_FALSE(text_reader.ok());
    ByteReader reader(bytes);
    EXPECT_TRUE(reader.get_bytes(std::numeric_limits<std::size_t>::max()).empty());
    EXPECT_FALSE(reader.ok());
}

TEST(CoreBytes, RandomBytesNeverReadPastTheEnd) {
    Random random{1};
    for (int round = 0; round < 20'000; ++round) {
        Bytes bytes(random.below(40));
        for (auto& b : bytes) b = static_cast<std::byte>(random.next());
        ByteReader reader(bytes);
        while (reader.ok() && reader.left() > 0) {
            const auto before = reader.position();
            switch (random.below(4)) {
                case 0: reader.get_varint(); break;
                case 1: reader.get_string(); break;
                case 2: reader.get<double>(); break;
                default: reader.get<bool>(); break;
            }
            ASSERT_TRUE(!reader.ok() || reader.position() > before);
            ASSERT_LE(reader.position(), bytes.size());
        }
    }
}

}  // namespace
}  // namespace thaum
