// Tests of the end of a log and of the limits of its blocks, with correct checksums.
#include <gtest/gtest.h>
#include <zstd.h>

#include "unit/input_log_samples.h"

namespace thaum::input {
namespace {

using samples::blocks_of;
using samples::Folder;

TEST(InputLog, TheEndBlockHasTheHashesOfTheLastState) {
    const Folder folder;
    for (const Tick count : {Tick{0}, Tick{1}, Tick{128}, Tick{1100}}) {
        const auto path = folder / text("log", count);
        auto writer = LogWriter::create(path, samples::header()).value();
        samples::record(writer, count, samples::calm_frame);
        const HashRecord last{count, samples::hash_of(count).state, samples::hash_of(count).force};
        ASSERT_TRUE(writer.close("end", last));
        auto reader = LogReader::open(path).value();
        EXPECT_TRUE(reader.ended_cleanly()) << reader.ending_reason();
        EXPECT_EQ(reader.hash_at(count), last);
        EXPECT_EQ(reader.hashes().size(), count / 128 + (count % 128 == 0 && count > 0 ? 0 : 1));
        EXPECT_EQ(reader.result(), "end");
    }
    // If the last block and the end block disagree, one of them is wrong.
    auto writer = LogWriter::create(folder / "two", samples::header()).value();
    samples::record(writer, 128, samples::calm_frame);
    ASSERT_TRUE(writer.close("end", HashRecord{128, 1, 2}));
    EXPECT_EQ(LogReader::open(folder / "two").value().ending(), LogEnding::damaged);
}

/// A few bytes that claim to hold megabytes, with correct checksums, are refused because of the claim.
TEST(InputLog, ABlockThatClaimsMoreThanItCanHoldIsRefused) {
    const Folder folder;
    const auto log = samples::small_log(folder);
    const auto place = blocks_of(log)[0];
    const auto refused = [&](std::span<const std::byte> payload, std::size_t raw_size) {
        const auto forged =
            samples::with_block(log, place, samples::signed_block(log, place.begin, payload, raw_size));
        EXPECT_TRUE(
            samples::put_file(folder / text("forged", payload.size(), "-", raw_size), forged).has_value());
        const auto header = detail::decode_block_header(
            std::span(forged).subspan(place.begin, detail::block_header_size), samples::preamble_of(forged));
        detail::Unpacker unpacker(2, samples::preamble_of(forged));
        detail::Block block;
        return !header || !unpacker.ticks(*header, payload, block);
    };
    const auto packed = [](std::size_t size) {
        const Bytes raw(size);
        Bytes out(ZSTD_compressBound(size));
        out.resize(ZSTD_compress(out.data(), out.size(), raw.data(), raw.size(), 19));
        return out;
    };
    const auto zeros = packed(22'000'000);
    EXPECT_LT(zeros.size(), 5000U);
    for (const std::size_t claim : {std::size_t{22'000'000}, detail::raw_limit, std::size_t{1000}})
        EXPECT_TRUE(refused(zeros, claim)) << claim;
    // The block has two zstd frames, of which the second is empty. It is refused,
    // because it would cost needless work.
    auto two = packed(1000);
    const auto more = packed(0);
    two.insert(two.end(), more.begin(), more.end());
    EXPECT_TRUE(refused(two, 1000));
    // A block of one tick may not be as large as one of 512 ticks.
    Bytes header(log.begin() + static_cast<std::ptrdiff_t>(place.begin),
                 log.begin() + static_cast<std::ptrdiff_t>(place.begin + detail::block_header_size));
    samples::put_at(header, 6, std::uint16_t{1});
    samples::put_at(header, 8, static_cast<std::uint32_t>(detail::raw_limit / 2));
    samples::put_at(header, 32, hash_bytes(std::span(header).first(32), samples::salt_of(log)));
    EXPECT_FALSE(detail::decode_block_header(header, samples::preamble_of(log)));
}

}  // namespace
}  // namespace thaum::input
