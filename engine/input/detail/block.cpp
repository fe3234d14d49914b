#include "input/detail/block.h"

// Before zstd packs a block, it is stored by column: one field of a device over 512 ticks. Most columns are
// idle or hold a level, so a run of unchanged values takes two bytes. The rest is noise of a few bits, which
// zstd's entropy coder packs close to its bound. Each column states whether it holds values (shorter for a
// mouse) or differences (shorter for a stick).
#include <zstd.h>

#include <algorithm>

#include "core/assert.h"
#include "core/hash.h"

namespace thaum::input::detail {
namespace {

constexpr std::uint32_t block_magic = 0x4b4c4254;  // the characters "TBLK"
constexpr std::size_t block_checksum_offset = 32;
constexpr int compression_level = 3;

/// Largest unpacked size of a block (bytes). In a column (one field of a device over all ticks), a tick takes
/// at most a token, which begins a run of values, (2 bytes) and a residual, which is a value or a difference
/// (5 bytes). A record of hashes takes at most 18 bytes and a mark 8. Counts, lengths and the total take at
/// most 10.
constexpr std::size_t max_raw(BlockKind kind, std::size_t ticks, std::uint32_t format) {
    if (kind == BlockKind::end) return 10 + 4 + result_limit + 16;
    return max_devices * columns(format) * (1 + ticks * 7) + block_hashes * 18 + block_marks * 8 + 8;
}
static_assert(max_raw(BlockKind::ticks, block_ticks, format_version) <= raw_limit);

using Column = std::array<std::uint32_t, block_ticks>;

/// Numbers of the columns (one field of a device over all ticks of a block) that follow those of the device's
/// counts.
constexpr std::size_t buttons_column = max_counts, model_age_column = buttons_column + 1,
                      skips_column = model_age_column + 1, wand_column = skips_column + 1,
                      state_column = wand_column + 1;
// Bits of the state of a device in one tick: whether the device is away, and which fader (for the forces at
// the hand) has changed, with its new value.
constexpr std::uint32_t away_bit = 1;
constexpr unsigned fader_shift = 8, percent_shift = 16;

std::uint32_t state_of(const DeviceSample& s) {
    return (s.away ? away_bit : 0U) | std::uint32_t{s.change.fader} << fader_shift |
           std::uint32_t{s.change.percent} << percent_shift;
}

/// Sets two fields of a sample from the number that `state_of` gives: whether the device is away, and the
/// change of a fader for the forces at the hand. Returns false if `state_of` never gives this number.
bool set_state(DeviceSample& s, std::uint32_t state) {
    s.away = (state & away_bit) != 0;
    s.change = {static_cast<std::uint8_t>(state >> fader_shift),
                static_cast<std::uint8_t>(state >> percent_shift)};
    return is_valid(s.change) && state == state_of(s);
}

std::uint32_t field(const DeviceSample& s, std::size_t column) {
    switch (column) {
        case buttons_column: return s.buttons;
        case model_age_column: return s.model_age;
        case skips_column: return s.skips;
        case wand_column: return s.wand;
        case state_column: return state_of(s);
        default: return static_cast<std::uint32_t>(s.counts[column]);
    }
}

/// Sets the field of a sample that belongs to a column. Returns false if the value does not fit.
bool set_field(DeviceSample& s, std::size_t column, std::uint32_t value) {
    switch (column) {
        case buttons_column: s.buttons = value; return true;
        case model_age_column: s.model_age = static_cast<std::uint16_t>(value); return value <= 0xffffU;
        case skips_column: s.skips = static_cast<std::uint16_t>(value); return value <= 0xffffU;
        case wand_column: s.wand = static_cast<std::uint8_t>(value); return value <= max_wands;
        case state_column: return set_state(s, value);
        default: s.counts[column] = static_cast<std::int32_t>(value); return true;
    }
}

/// Moves the wand out of the buttons of format 1, where bits 11 to 15 are wands 1 to 5 and bits 19 to 22 are
/// wands 6 to 9. If several bits are set, the highest counts.
void split_off_wand(DeviceSample& s) {
    constexpr std::uint32_t wand_bits = 0x1fU << 11U | 0xfU << 19U;
    s.wand = 0;
    for (std::uint8_t wand = 1; wand <= max_wands; ++wand) {
        const auto bit = 1U << (wand <= 5 ? 10U + wand : 13U + wand);
        if ((s.buttons & bit) != 0) s.wand = wand;
    }
    s.buttons &= ~wand_bits;
}

// Zigzag form of a difference: small ones of either sign become small unsigned numbers. Arithmetic is modulo
// 2^32, so that every difference of two values has a form of 32 bits.
std::uint32_t zigzag(std::uint32_t v) { return (v << 1U) ^ (0U - (v >> 31U)); }
std::uint32_t unzigzag(std::uint32_t z) { return (z >> 1U) ^ (0U - (z & 1U)); }

// Encoding of columns --------------------------------------------------------------------------------

void put_residuals(Bytes& bytes, std::span<const std::uint32_t> residuals) {
    ByteWriter out(bytes);
    for (std::size_t at = 0; at < residuals.size();) {
        const bool literal = residuals[at] != 0;
        std::size_t end = at;
        while (end < residuals.size() && (residuals[end] != 0) == literal) ++end;
        out.put_varint((end - at) << 1U | (literal ? 1U : 0U));
        for (; literal && at < end; ++at) out.put_varint(zigzag(residuals[at]));
        at = end;
    }
}

Column values_of(const Block& block, std::size_t device, std::size_t column) {
    Column values{};
    for (std::size_t t = 0; t < block.ticks; ++t) values[t] = field(block.frames[t].devices[device], column);
    return values;
}

Column differences_of(const Column& values, std::size_t ticks) {
    Column result{};
    std::uint32_t before = 0;
    for (std::size_t t = 0; t < ticks; ++t) {
        result[t] = values[t] - before;
        before = values[t];
    }
    return result;
}

// Decoding of columns --------------------------------------------------------------------------------

bool get_residuals(ByteReader& in, std::span<std::uint32_t> residuals) {
    for (std::size_t at = 0; at < residuals.size();) {
        const auto token = in.get_varint();
        const auto n = token >> 1U;
        if (!in.ok() || n == 0 || n > residuals.size() - at) return false;
        for (const auto end = at + n; at < end; ++at) {
            const auto z = (token & 1U) != 0 ? in.get_varint() : 0;
            if (z > 0xffffffffU) return false;
            residuals[at] = unzigzag(static_cast<std::uint32_t>(z));
        }
    }
    return in.ok();
}

bool get_hashes(ByteReader& in, Block& block) {
    block.hash_count = in.get_varint();
    if (block.hash_count > block_hashes) return false;
    for (std::size_t i = 0; i < block.hash_count; ++i) {
        const auto offset = in.get_varint();
        const auto tick = block.first + offset;
        if (offset > block.ticks || tick % hash_interval != 0) return false;
        if (i > 0 && tick <= block.hashes[i - 1].tick) return false;
        block.hashes[i].tick = tick;
        block.hashes[i].state = in.get<std::uint64_t>();
        block.hashes[i].force = in.get<std::uint64_t>();
    }
    return in.ok();
}

bool get_marks(ByteReader& in, Block& block) {
    block.mark_count = in.get_varint();
    if (block.mark_count > block_marks) return false;
    for (std::size_t i = 0; i < block.mark_count; ++i) {
        const auto offset = in.get_varint();
        const auto kind = in.get<std::uint8_t>();
        const auto number = in.get_varint();
        if (offset > block.ticks || kind > 1 || number > 0xffffffffU) return false;
        block.marks[i] = {block.first + offset, MarkKind{kind}, static_cast<std::uint32_t>(number)};
    }
    return in.ok();
}

std::uint64_t checksum_of_header(std::span<const std::byte> block, std::uint64_t salt) {
    return hash_bytes(block.first(block_checksum_offset), salt);
}

}  // namespace

// Packer -------------------------------------------------------------------------------------------

Packer::Packer(std::size_t devices, std::uint64_t salt)
    : devices_(devices), salt_(salt), zstd_(ZSTD_createCCtx()), packed_(block_header_size + packed_limit) {
    THAUM_ASSERT(ZSTD_compressBound(raw_limit) <= packed_limit, "a full block may not fit");
    raw_.reserve(raw_limit);
    head_.reserve(block_header_size);
    column_a_.reserve(1 + block_ticks * 7);
    column_b_.reserve(1 + block_ticks * 7);
}

Packer::~Packer() { ZSTD_freeCCtx(zstd_); }

std::span<const std::byte> Packer::ticks(const Block& block) {
    raw_.clear();
    ByteWriter out(raw_);
    for (std::size_t device = 0; device < devices_; ++device) {
        for (std::size_t column = 0; column < columns(format_version); ++column) {
            const auto values = values_of(block, device, column);
            const auto differences = differences_of(values, block.ticks);
            column_a_.assign(1, std::byte{0});
            column_b_.assign(1, std::byte{1});
            put_residuals(column_a_, std::span(values).first(block.ticks));
            put_residuals(column_b_, std::span(differences).first(block.ticks));
            out.put_bytes(column_b_.size() < column_a_.size() ? column_b_ : column_a_);
        }
    }
    out.put_varint(block.hash_count);
    for (const auto& hash : std::span(block.hashes).first(block.hash_count)) {
        out.put_varint(hash.tick - block.first);
        out.put(hash.state);
        out.put(hash.force);
    }
    out.put_varint(block.mark_count);
    for (const auto& mark : std::span(block.marks).first(block.mark_count)) {
        out.put_varint(mark.tick - block.first);
        out.put(mark.kind);
        out.put_varint(mark.number);
    }
    return pack({BlockKind::ticks, block.ticks, 0, 0, block.first, 0});
}

std::span<const std::byte> Packer::end(Tick total, const EndBlock& end) {
    raw_.clear();
    ByteWriter out(raw_);
    out.put_varint(total);
    out.put_string(std::string_view(end.result).substr(0, result_limit));
    if (end.last) {
        out.put(end.last->state);
        out.put(end.last->force);
    }
    return pack({BlockKind::end, 0, 0, 0, total, 0});
}

std::span<const std::byte> Packer::pack(BlockHeader header) {
    const auto room = std::span(packed_).subspan(block_header_size);
    const auto size =
        ZSTD_compressCCtx(zstd_, room.data(), room.size(), raw_.data(), raw_.size(), compression_level);
    THAUM_ASSERT(ZSTD_isError(size) == 0, "zstd cannot pack a block that fits its buffer");
    head_.clear();
    ByteWriter out(head_);
    out.put(block_magic);
    out.put(header.kind);
    out.put(static_cast<std::uint16_t>(header.ticks));
    out.put(static_cast<std::uint32_t>(raw_.size()));
    out.put(static_cast<std::uint32_t>(size));
    out.put(header.first);
    out.put(hash_bytes(room.first(size), salt_));
    out.put(checksum_of_header(head_, salt_));
    std::copy(head_.begin(), head_.end(), packed_.begin());
    return {packed_.data(), block_header_size + size};
}

// Unpacker -----------------------------------------------------------------------------------------

std::optional<BlockHeader> decode_block_header(std::span<const std::byte> bytes, const Preamble& log) {
    ByteReader in(bytes);
    const auto magic = in.get<std::uint32_t>();
    BlockHeader header;
    header.kind = in.get<BlockKind>();
    header.ticks = in.get<std::uint16_t>();
    header.raw_size = in.get<std::uint32_t>();
    header.packed_size = in.get<std::uint32_t>();
    header.first = in.get<std::uint64_t>();
    header.payload_checksum = in.get<std::uint64_t>();
    if (in.get<std::uint64_t>() != checksum_of_header(bytes, log.salt) || magic != block_magic) return {};
    const bool sizes = header.raw_size <= max_raw(header.kind, header.ticks, log.format) &&
                       header.packed_size <= ZSTD_COMPRESSBOUND(header.raw_size);
    const bool ticks = header.kind == BlockKind::ticks && header.ticks >= 1 && header.ticks <= block_ticks;
    const bool end = header.kind == BlockKind::end && header.ticks == 0;
    if (!sizes || !(ticks || end) || header.first > tick_limit) return {};
    return header;
}

Unpacker::Unpacker(std::size_t devices, const Preamble& log)
    : devices_(devices), log_(log), zstd_(ZSTD_createDCtx()), raw_(raw_limit) {}

Unpacker::~Unpacker() { ZSTD_freeDCtx(zstd_); }

bool Unpacker::unpack(const BlockHeader& header, std::span<const std::byte> payload) {
    if (hash_bytes(payload, log_.salt) != header.payload_checksum) return false;
    // The payload must be a single zstd frame of the size that the block header states. Otherwise a few bytes
    // could request any amount of work.
    if (ZSTD_getFrameContentSize(payload.data(), payload.size()) != header.raw_size) return false;
    if (ZSTD_findFrameCompressedSize(payload.data(), payload.size()) != payload.size()) return false;
    const auto size =
        ZSTD_decompressDCtx(zstd_, raw_.data(), header.raw_size, payload.data(), payload.size());
    return ZSTD_isError(size) == 0 && size == header.raw_size;
}

bool Unpacker::get_column(ByteReader& in, Block& block, std::size_t device, std::size_t column) const {
    Column residuals{};
    const auto mode = in.get<std::uint8_t>();
    if (mode > 1 || !get_residuals(in, std::span(residuals).first(block.ticks))) return false;
    std::uint32_t value = 0;
    for (std::size_t t = 0; t < block.ticks; ++t) {
        auto& sample = block.frames[t].devices[device];
        value = mode == 1 ? value + residuals[t] : residuals[t];
        if (!set_field(sample, column, value)) return false;
        if (log_.format == 1 && column == buttons_column) split_off_wand(sample);
    }
    return true;
}

bool Unpacker::ticks(const BlockHeader& header, std::span<const std::byte> payload, Block& block) {
    if (!unpack(header, payload)) return false;
    block.first = header.first;
    block.ticks = header.ticks;
    ByteReader in(std::span<const std::byte>(raw_).first(header.raw_size));
    for (std::size_t device = 0; device < devices_; ++device) {
        for (std::size_t column = 0; column < columns(log_.format); ++column) {
            if (!get_column(in, block, device, column)) return false;
        }
    }
    return get_hashes(in, block) && get_marks(in, block) && in.left() == 0;
}

std::optional<EndBlock> Unpacker::end(const BlockHeader& header, std::span<const std::byte> payload) {
    if (!unpack(header, payload)) return {};
    ByteReader in(std::span<const std::byte>(raw_).first(header.raw_size));
    const auto total = in.get_varint();
    EndBlock end{in.get_string()};
    if (in.left() != 0) {
        const auto state = in.get<std::uint64_t>();
        end.last = HashRecord{total, state, in.get<std::uint64_t>()};
    }
    if (!in.ok() || in.left() != 0 || total != header.first || end.result.size() > result_limit) return {};
    return end;
}

}  // namespace thaum::input::detail
