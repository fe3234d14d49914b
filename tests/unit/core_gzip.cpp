// Tests of packing and unpacking gzip data, also of data that are cut off, damaged or larger than allowed.
#include "core/gzip.h"

#include <gtest/gtest.h>

#include <span>
#include <string>

#include "core/random.h"

namespace thaum {
namespace {

Bytes packed(std::string_view words) { return pack_gzip(std::as_bytes(std::span(words))); }

Bytes joined(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::string noise(std::size_t size) {
    Random random{3};
    std::string out(size, '\0');
    for (char& c : out) c = static_cast<char>(random.below(256));
    return out;
}

TEST(CoreGzip, UnpacksWhatItPacked) {
    for (const std::string& words :
         {std::string(), std::string("a"), std::string(300'000, 'x'), noise(300'000), noise(1U << 18U)})
        EXPECT_EQ(unpack_gzip(packed(words), 300'000).value_or("none"), words);
    EXPECT_LT(packed(std::string(300'000, 'x')).size(), 1000);
    EXPECT_EQ(packed("again"), packed("again"));
}

TEST(CoreGzip, UnpacksMembersThatComeByteByByte) {
    const std::string words = noise(3000);
    const Bytes bytes = joined(joined(packed(words), packed("end")), Bytes{std::byte{0x1f}, std::byte{7}});
    for (const auto rest : {GzipReader::Rest::ignored, GzipReader::Rest::damage}) {
        std::size_t next = 0;
        GzipReader reader(
            [&](std::span<std::byte> out) -> Expected<std::size_t> {
                if (next == bytes.size()) return std::size_t{0};
                out[0] = bytes[next++];
                return std::size_t{1};
            },
            rest);
        std::string out(words.size() + 3, ' ');
        EXPECT_EQ(reader.read(std::as_writable_bytes(std::span(out))), out.size());
        EXPECT_EQ(out, words + "end");
        std::byte more{};
        const auto count = reader.read(std::span(&more, 1));
        EXPECT_EQ(count.has_value(), rest == GzipReader::Rest::ignored) << "two bytes that are no member";
        if (count) EXPECT_EQ(*count, 0U);
        EXPECT_EQ(reader.is_followed(), rest == GzipReader::Rest::ignored);
    }
}

TEST(CoreGzip, UnpacksSeveralMembers) {
    const std::string words(300'000, 'x');
    EXPECT_EQ(unpack_gzip(joined(packed(words), packed("end")), 1U << 20U).value_or(""), words + "end");
}

TEST(CoreGzip, RefusesWhatIsCutOffDamagedOrTooLarge) {
    Bytes bytes = packed(std::string(300'000, 'x'));
    EXPECT_EQ(unpack_gzip(bytes, 299'999).error().message, "the gzip data hold more than 299999 bytes");
    EXPECT_TRUE(unpack_gzip(bytes, 300'000));
    for (std::size_t length = 0; length < bytes.size(); length += 7)
        EXPECT_FALSE(unpack_gzip(std::span(bytes).first(length), 1U << 20U)) << length;
    bytes[bytes.size() - 6] ^= std::byte{1};  // a byte of the checksum
    EXPECT_FALSE(unpack_gzip(bytes, 1U << 20U));
    EXPECT_FALSE(unpack_gzip(std::as_bytes(std::span("plain words")), 1U << 20U));
}

TEST(CoreGzip, ABombStopsAtTheLimit) {
    const Bytes bomb = packed(std::string(8'000'000, '\0'));
    EXPECT_LT(bomb.size(), 10'000);
    EXPECT_FALSE(unpack_gzip(bomb, 1000));
}

}  // namespace
}  // namespace thaum
