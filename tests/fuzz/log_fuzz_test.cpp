// Corrupted logs, always the same ones: the reader must end with an error, a shorter log or the right one, never with
// a crash. Plain damage stops at the checksums, so two kinds are signed again and reach zstd and the decoder behind.
#include <gtest/gtest.h>
#include <zstd.h>

#include "unit/input_log_samples.h"

namespace thaum::input {
namespace {

using samples::blocks_of;
using samples::Folder;

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t n) { return static_cast<std::size_t>(random() % n); }

template <class T>
void put_at(Bytes& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// Some bytes become others; sometimes some go or come.
void damage(Bytes& bytes, std::size_t begin, Random& random, bool keep_size) {
    for (auto n = 1 + below(random, 8); n > 0 && bytes.size() > begin; --n) {
        const auto at = begin + below(random, bytes.size() - begin);
        const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
        const auto how = keep_size ? 0 : below(random, 8);
        constexpr int striking[] = {0x00, 0xff, 0x7f, 0x80, 0x01};
        const auto value = static_cast<std::byte>(random() % 2 == 0 ? striking[random() % 5]
                                                                    : static_cast<int>(random() & 0xffU));
        if (how < 6) *place = value;
        if (how == 6) bytes.insert(place, 1 + below(random, 20), value);
        if (how == 7)
            bytes.erase(place, place + static_cast<std::ptrdiff_t>(
                                           std::min(bytes.size() - at, 1 + below(random, 20))));
    }
}

std::uint64_t salt_of(const Bytes& log) {
    return ByteReader(std::span(log).subspan(16)).get<std::uint64_t>();
}

/// One block with a payload of the caller's; its checksums and sizes are right.
Bytes signed_block(const Bytes& log, std::size_t at, std::span<const std::byte> payload,
                   std::size_t raw_size) {
    Bytes block(log.begin() + static_cast<std::ptrdiff_t>(at),
                log.begin() + static_cast<std::ptrdiff_t>(at + detail::block_header_size));
    put_at(block, 8, static_cast<std::uint32_t>(raw_size));
    put_at(block, 12, static_cast<std::uint32_t>(payload.size()));
    put_at(block, 24, hash_bytes(payload, salt_of(log)));
    put_at(block, 32, hash_bytes(std::span(block).first(32), salt_of(log)));
    block.insert(block.end(), payload.begin(), payload.end());
    return block;
}

Bytes with_block(const Bytes& log, const samples::BlockPlace& place, const Bytes& block) {
    Bytes result(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(place.begin));
    result.insert(result.end(), block.begin(), block.end());
    result.insert(result.end(), log.begin() + static_cast<std::ptrdiff_t>(place.end), log.end());
    return result;
}

Bytes damaged_payload(const Bytes& log, Random& random) {
    const auto blocks = blocks_of(log);
    const auto& place = blocks[below(random, blocks.size())];
    Bytes payload(log.begin() + static_cast<std::ptrdiff_t>(place.begin + detail::block_header_size),
                  log.begin() + static_cast<std::ptrdiff_t>(place.end));
    const auto raw_size = samples::u32_at(log, place.begin + 8);
    damage(payload, 0, random, false);
    return with_block(log, place, signed_block(log, place.begin, payload, raw_size));
}

Bytes damaged_columns(const Bytes& log, Random& random) {
    const auto blocks = blocks_of(log);
    const auto& place = blocks[below(random, blocks.size())];
    Bytes raw(samples::u32_at(log, place.begin + 8));
    ZSTD_decompress(raw.data(), raw.size(), log.data() + place.begin + detail::block_header_size,
                    place.end - place.begin - detail::block_header_size);
    damage(raw, 0, random, random() % 2 == 0);
    Bytes packed(ZSTD_compressBound(raw.size()));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), 1));
    return with_block(log, place, signed_block(log, place.begin, packed, raw.size()));
}

/// Only the header is read from this: the blocks' checksums belong to another salt.
Bytes damaged_header(const Bytes& log, Random& random) {
    const auto body_end = detail::preamble_size + samples::u32_at(log, 12);
    Bytes header(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(body_end));
    damage(header, detail::preamble_size, random, false);
    put_at(header, 12, static_cast<std::uint32_t>(header.size() - detail::preamble_size));
    const auto bytes = std::span<const std::byte>(header);
    put_at(header, 16, hash_bytes(bytes.subspan(detail::preamble_size), hash_bytes(bytes.first(16))));
    return header;
}

Bytes damaged_anywhere(Bytes log, Random& random) {
    damage(log, 0, random, false);
    return log;
}

/// Opens and reads to the end; true where the header was read.
bool survives(const std::filesystem::path& path) {
    auto reader = LogReader::open(path);
    if (!reader) {
        EXPECT_FALSE(reader.error().message.empty());
        return false;
    }
    Tick ticks = 0;
    for (InputFrame frame; reader->next(frame);) ++ticks;
    EXPECT_EQ(ticks, reader->ticks());
    EXPECT_LE(ticks, 4 * detail::block_ticks);
    EXPECT_EQ(reader->ended_cleanly(), reader->ending_reason().empty());
    return true;
}

TEST(LogFuzz, TenThousandCorruptions) {
    const Folder folder;
    const auto log = samples::small_log(folder);
    const samples::Scratch file(folder / "corrupt");
    Random random{20240501};
    std::array<int, 4> opened{};
    for (int i = 0; i < 10000; ++i) {
        const auto kind = static_cast<std::size_t>(i % 4);
        Bytes corrupt;
        if (kind == 0) corrupt = damaged_anywhere(log, random);
        if (kind == 1) corrupt = damaged_payload(log, random);
        if (kind == 2) corrupt = damaged_columns(log, random);
        if (kind == 3) corrupt = damaged_header(log, random);
        ASSERT_TRUE(file.set(corrupt));
        opened[kind] += survives(file.path) ? 1 : 0;
    }
    EXPECT_GT(opened[0], 0);
    EXPECT_EQ(opened[1], 2500);
    EXPECT_EQ(opened[2], 2500);
    EXPECT_GT(opened[3], 0);
}

/// 100 MiB of zeros in a few kilobytes, signed and said to be small: only the promised size is unpacked.
TEST(LogFuzz, ZipBombIsRefused) {
    const Folder folder;
    const auto log = samples::small_log(folder);
    const auto place = blocks_of(log)[0];
    const Bytes zeros(100U << 20U);
    Bytes packed(ZSTD_compressBound(zeros.size()));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 19));
    for (const std::size_t said : {std::size_t{1000}, detail::raw_limit, zeros.size()}) {
        ASSERT_TRUE(write_file(folder / "bomb",
                               with_block(log, place, signed_block(log, place.begin, packed, said))));
        const auto reader = LogReader::open(folder / "bomb").value();
        EXPECT_EQ(reader.ending(), LogEnding::damaged);
        EXPECT_EQ(reader.ticks(), 0U);
    }
}

}  // namespace
}  // namespace thaum::input
