// Logs for tests: a folder that goes away, headers, frames that are a function of the tick, and the bytes of a file.
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

/// How often this program has called `new`.
std::size_t allocations();

struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "thaum-log-XXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path operator/(std::string_view name) const { return path / name; }
};

/// One file whose bytes change often: far quicker than a new file each time.
class Scratch {
public:
    explicit Scratch(std::filesystem::path where)
        : path(std::move(where)), fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600)) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { ::close(fd_); }

    /// False where the disk did not take them.
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
        device.flags = i == 1 ? DeviceSpec::invert_y : 0;
        if (i == 1) device.ask_for_carried(75, 0);
        if (i == 1) device.box_um = {160'000, 1, DeviceSpec::most_box_um};
        for (std::size_t source = 0; source < fluid_faders && i > 0; ++source)
            device.ask_for_fluid(source, static_cast<std::uint32_t>(16 * source));
        h.devices.push_back(device);
    }
    h.files = {{"wands/lift.toml", 1}, {"wands/blast.toml", 2}};
    h.overrides = {"lift.reach=3"};
    h.parameters = {"kills=5", "seconds=240"};
    return h;
}

/// Every field takes small, zero and extreme values.
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
        s.buttons = static_cast<std::uint32_t>(random()) & ~(0x1fU << 11U | 0xfU << 19U);
        s.wand = static_cast<std::uint32_t>(random() % (most_wands + 1));
        s.model_age = static_cast<std::uint16_t>(random());
        s.skips = static_cast<std::uint16_t>(random());
    }
    return frame;
}

/// Mostly the same from tick to tick, so that a log is small.
inline InputFrame calm_frame(Tick tick) {
    InputFrame frame;
    frame.devices[0].counts[hand::look_right] = static_cast<std::int32_t>(tick / 100);
    frame.devices[0].counts[hand::forward] = tick % 400 < 200 ? 127 : 0;
    frame.devices[1].buttons = tick % 300 < 150 ? 1 : 0;
    return frame;
}

inline HashRecord hash_of(Tick tick) { return {tick, hash_value(tick, 1), hash_value(tick, 2)}; }

/// Appends as the game does: frame, then at every multiple of 128 the hashes after it.
template <class Frame>
void record(LogWriter& writer, Tick count, Frame frame_at) {
    for (Tick t = writer.ticks(); count > 0; --count) {
        writer.append(frame_at(t));
        if (++t % hash_interval == 0) writer.append_hash(t, hash_of(t).state, hash_of(t).force);
        if (t % keyframe_interval == 0) writer.mark(0, MarkKind::keyframe);
    }
}

/// Writes the file where a log may lie already, which no writer of ours replaces.
inline Expected<void> put_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    std::filesystem::remove(path);
    return write_file(path, bytes);
}

inline Bytes bytes_of(const std::filesystem::path& path) { return read_file(path, 1U << 28U).value(); }

/// A closed log of 1,100 calm ticks: three blocks and the end.
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

struct BlockPlace {
    std::size_t begin, end;  ///< bytes
    Tick first, last;        ///< ticks
};

/// Where the blocks of an undamaged log lie (the end block too).
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

inline std::uint64_t salt_of(const Bytes& log) {
    return ByteReader(std::span(log).subspan(16)).get<std::uint64_t>();
}

template <class T>
void put_at(Bytes& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// The block at `at` with a payload of the caller's; its checksums and sizes are right.
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
