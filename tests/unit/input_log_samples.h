// Logs for tests: a temporary folder, headers, frames computed from the tick, and the bytes of a file.
#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <random>

#include "core/file.h"
#include "core/hash.h"
#include "core/text.h"
#include "input/detail/block.h"
#include "input/log.h"

namespace thaum::input::samples {

struct Folder : TemporaryFolder {
    std::filesystem::path operator/(std::string_view name) const { return path() / name; }
};

/// A file whose contents a test replaces again and again, which is much faster than to create new files.
class Scratch {
public:
    explicit Scratch(std::filesystem::path where)
        : path(std::move(where)), fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600)) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { ::close(fd_); }

    /// Replaces the contents of the file. Returns false if the bytes could not be written.
    bool set(std::span<const std::byte> bytes) const {
        return set_from(0, bytes) && ::ftruncate(fd_, static_cast<off_t>(bytes.size())) == 0;
    }
    bool set_from(std::size_t at, std::span<const std::byte> bytes) const {
        return ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(at)) ==
               static_cast<ssize_t>(bytes.size());
    }

    const std::filesystem::path path;

private:
    int fd_;
};

inline bool contains(const std::string& s, std::string_view part) {
    return s.find(part) != std::string::npos;
}

inline LogHeader header(std::size_t devices = 2) {
    LogHeader h;
    h.program = "1.0.0";
    h.rules_version = 3;
    h.rule_set = "thaum";
    h.arena = "courtyard";
    h.seed = 0x1234567890abcdefULL;
    h.maths_probe = 0xfeedULL;
    h.players = {"human", "bot 1"};
    for (std::size_t i = 0; i < devices; ++i) {
        DeviceSpec device;
        device.player = static_cast<std::uint32_t>(i % 2);
        device.kind = i == 0 ? DeviceKind::keyboard_mouse : DeviceKind::pad;
        device.name = text("device ", i);
        device.invert_y = i == 1;
        if (i == 1) device.set_carried_percent(75, 0);
        if (i == 1) device.box_um = {160'000, 1, DeviceSpec::max_box_um};
        for (std::size_t source = 0; source < fluid_faders && i > 0; ++source)
            device.set_fluid_percent(source, static_cast<std::uint32_t>(16 * source));
        h.devices.push_back(device);
    }
    h.files = {{"wands/lift.toml", 1}, {"wands/blast.toml", 2}};
    h.overrides = {"lift.reach=3"};
    h.parameters = {"kills=5", "seconds=240"};
    h.physics_library = "Bullet 3.24";
    h.physics_precision = "double";
    h.kinds = {{"cause", {{0, "bolt"}, {65535, "the last"}}}, {"event", {}}, {"wand", {{1, "bolt"}}}};
    h.profile = {{"gesture", "circle", 0, {std::byte{0}, std::byte{255}}}, {"gesture", "circle", 1, {}}};
    return h;
}

/// A header with two devices that format 1 can hold.
inline LogHeader header_1() {
    auto h = header(2);
    h.physics_library = h.physics_precision = {};
    h.kinds.clear();
    h.profile.clear();
    return h;
}

/// Frames in which every field takes small, zero and extreme values.
inline InputFrame random_frame(Tick tick, std::size_t devices, std::uint64_t seed = 0) {
    std::mt19937_64 random(hash_combine(seed, tick));
    InputFrame frame;
    for (std::size_t d = 0; d < devices; ++d) {
        auto& s = frame.devices[d];
        for (auto& count : s.counts) {
            constexpr std::int32_t extremes[] = {INT32_MIN, INT32_MAX, -1, 0, 1, INT32_MIN + 1};
            const auto r = random();
            if (r % 4 == 0) count = extremes[r / 8 % 6];
            if (r % 4 == 1) count = static_cast<std::int32_t>(r >> 32U);
            if (r % 4 == 2) count = static_cast<std::int32_t>(r / 4 % 21) - 10;
        }
        s.buttons = static_cast<std::uint32_t>(random());
        s.wand = static_cast<std::uint8_t>(random() % (max_wands + 1));
        s.model_age = static_cast<std::uint16_t>(random());
        s.skips = static_cast<std::uint16_t>(random());
        s.away = s.skips % 2 != 0;
    }
    return frame;
}

/// Frames that change little from tick to tick, so that a log stays small.
inline InputFrame calm_frame(Tick tick) {
    InputFrame frame;
    frame.devices[0].counts[hand::look_right] = static_cast<std::int32_t>(tick / 100);
    frame.devices[0].counts[hand::forward] = tick % 400 < 200 ? 127 : 0;
    frame.devices[1].buttons = tick % 300 < 150 ? 1 : 0;
    return frame;
}

/// Frames of the stored log of format 1, which has neither all bits of the buttons nor lost devices.
inline InputFrame frame_1(Tick tick) {
    auto frame = tick % 50 == 0 ? random_frame(tick, 2) : calm_frame(tick);
    for (auto& sample : frame.devices) {
        sample.buttons &= ~(0x1fU << 11U | 0xfU << 19U);
        sample.away = false;
    }
    return frame;
}

inline HashRecord hash_of(Tick tick) { return {tick, hash_value(tick, 1), hash_value(tick, 2)}; }

/// Appends to a log in the way of the game: a frame, then, at every multiple of 128, the hashes of the state
/// after it.
template <class Frame>
void record(LogWriter& writer, Tick count, Frame frame_at) {
    for (Tick t = writer.ticks(); count > 0; --count) {
        writer.append(frame_at(t));
        if (++t % hash_interval == 0) writer.append_hash(t, hash_of(t).state, hash_of(t).force);
        if (t % keyframe_interval == 0) writer.mark(0, MarkKind::keyframe);
    }
}

/// Overwrites an existing log, which our own writers never do.
inline Expected<void> put_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    std::filesystem::remove(path);
    return write_file(path, bytes);
}

inline Bytes bytes_of(const std::filesystem::path& path) { return read_file(path, 1U << 28U).value(); }

/// A closed log of 1,100 quiet ticks: three blocks and the end.
inline Bytes small_log(const Folder& folder) {
    const auto path = folder / "small.thaumlog";
    auto writer = LogWriter::create(path, header()).value();
    record(writer, 1100, calm_frame);
    writer.mark(7);
    (void)writer.close("2 : 1");
    return bytes_of(path);
}

inline std::uint32_t u32_at(const Bytes& bytes, std::size_t at) {
    return ByteReader(std::span(bytes).subspan(at)).get<std::uint32_t>();
}

/// A closed log of 1,100 ticks with header_1() and frame_1(), recorded by a program that wrote format 1.
inline Bytes log_1() { return bytes_of(THAUM_SOURCE_DIR "/tests/fuzz/seeds/log/format_1.thaumlog"); }

/// A log of 1,100 ticks in three blocks and the end, with its frames.
struct StoredLog {
    Bytes bytes;
    InputFrame (*frame_at)(Tick);
};

/// One log in each format.
inline std::vector<StoredLog> logs_of_all_formats(const Folder& folder) {
    return {{small_log(folder), calm_frame}, {log_1(), frame_1}};
}

struct BlockPlace {
    std::size_t begin, end;  ///< offsets in the file (bytes)
    Tick first, last;        ///< the block's first and last tick
};

/// Positions of the blocks of an undamaged log, with the end block.
inline std::vector<BlockPlace> blocks_of(const Bytes& log) {
    std::vector<BlockPlace> places;
    std::size_t at = detail::preamble_size + u32_at(log, 12);
    Tick tick = 0;
    while (at < log.size()) {
        const auto end = at + detail::block_header_size + u32_at(log, at + 12);
        const auto ticks = u32_at(log, at + 4) >> 16U;
        places.push_back({at, end, tick, tick + ticks});
        at = end;
        tick += ticks;
    }
    return places;
}

inline detail::Preamble preamble_of(const Bytes& log) { return detail::decode_preamble(log).value(); }

inline std::uint64_t salt_of(const Bytes& log) {
    return ByteReader(std::span(log).subspan(16)).get<std::uint64_t>();
}

template <class T>
void put_at(Bytes& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// The block at `at` with another payload, and with correct checksums and sizes.
inline Bytes signed_block(const Bytes& log, std::size_t at, std::span<const std::byte> payload,
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

inline Bytes with_block(const Bytes& log, const BlockPlace& place, const Bytes& block) {
    Bytes result(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(place.begin));
    result.insert(result.end(), block.begin(), block.end());
    result.insert(result.end(), log.begin() + static_cast<std::ptrdiff_t>(place.end), log.end());
    return result;
}

}  // namespace thaum::input::samples
