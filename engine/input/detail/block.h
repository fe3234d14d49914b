// input/detail/block.h: encoding of the log's blocks, independent of files. FORMAT.md is the reference.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "input/detail/header.h"

// zstd's contexts, declared here so that its header stays in block.cpp.
struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace thaum::input::detail {

inline constexpr std::size_t file_limit = std::size_t{1} << 30U;
inline constexpr Tick tick_limit = Tick{1} << 27U;
inline constexpr std::size_t mark_limit = std::size_t{1} << 17U;

inline constexpr std::size_t block_ticks = 512;
inline constexpr std::size_t block_hashes = block_ticks / hash_interval + 1;
inline constexpr std::size_t block_marks = 64;
inline constexpr std::size_t block_header_size = 40;
inline constexpr std::size_t raw_limit = 256 * 1024;
inline constexpr std::size_t packed_limit = 288 * 1024;
inline constexpr std::size_t result_limit = 4096;

/// Number of columns for a device: each value of a sample has its own.
constexpr std::size_t columns(std::uint32_t format) { return max_counts + (format == 1 ? 3 : 5); }

/// Input of up to 512 ticks, with their hashes and marks.
struct Block {
    Tick first{};
    std::size_t ticks{};
    std::size_t hash_count{};
    std::size_t mark_count{};
    std::array<InputFrame, block_ticks> frames{};
    std::array<HashRecord, block_hashes> hashes{};
    std::array<Mark, block_marks> marks{};
};

/// Contents of an end block, the last block of a log that was closed.
struct EndBlock {
    std::string result;
    std::optional<HashRecord> last{};  ///< hashes of the last state; logs of older programs have none
};

enum class BlockKind : std::uint16_t { ticks = 1, end = 2 };

struct BlockHeader {
    BlockKind kind{};
    std::size_t ticks{};
    std::size_t raw_size{};
    std::size_t packed_size{};
    Tick first{};
    std::uint64_t payload_checksum{};
};

/// Decodes a block header. Returns nothing if the bytes are damaged.
std::optional<BlockHeader> decode_block_header(std::span<const std::byte> bytes, const Preamble& log);

/// Packs blocks of format_version. Its buffers have the size of the largest block from the start, so it never
/// allocates later.
class Packer {
public:
    Packer(std::size_t devices, std::uint64_t salt);
    Packer(const Packer&) = delete;
    Packer& operator=(const Packer&) = delete;
    ~Packer();

    /// Packs a block of ticks. Returns block header and payload, valid until the next call.
    std::span<const std::byte> ticks(const Block& block);
    std::span<const std::byte> end(Tick total, const EndBlock& end);

private:
    std::span<const std::byte> pack(BlockHeader header);
    std::size_t devices_;
    std::uint64_t salt_;
    ZSTD_CCtx_s* zstd_;
    Bytes raw_, packed_, head_, column_a_, column_b_;
};

/// Unpacks blocks of any format. A false or empty result means damage.
class Unpacker {
public:
    Unpacker(std::size_t devices, const Preamble& log);
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;
    ~Unpacker();

    bool ticks(const BlockHeader& header, std::span<const std::byte> payload, Block& block);
    std::optional<EndBlock> end(const BlockHeader& header, std::span<const std::byte> payload);

private:
    bool unpack(const BlockHeader& header, std::span<const std::byte> payload);
    bool get_column(ByteReader& in, Block& block, std::size_t device, std::size_t column) const;
    std::size_t devices_;
    Preamble log_;
    ZSTD_DCtx_s* zstd_;
    Bytes raw_;
};

}  // namespace thaum::input::detail
