#include "input/log.h"

// The file is read twice, with one block in memory at a time. `open` checks and decodes every block, so a
// replay knows the log's length, ending and hashes before its first tick. `next` decodes the blocks again.
// Decoding a block costs far less than playing its 512 ticks.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/text.h"
#include "core/write_rule.h"
#include "input/detail/block.h"

namespace thaum::input {

struct LogDescriptor {
    int fd = -1;
    std::size_t size = 0;

    LogDescriptor(int descriptor, std::size_t bytes) : fd(descriptor), size(bytes) {}
    LogDescriptor(LogDescriptor&& other) noexcept : fd(std::exchange(other.fd, -1)), size(other.size) {}
    LogDescriptor& operator=(LogDescriptor&&) = delete;
    ~LogDescriptor() {
        if (fd >= 0) ::close(fd);
    }

    /// Reads the bytes at a position. Returns false if the file has fewer bytes or the disk cannot read them.
    bool read_at(std::size_t at, std::span<std::byte> into) const {
        while (!into.empty()) {
            const auto n = ::pread(fd, into.data(), into.size(), static_cast<off_t>(at));
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) return false;
            at += static_cast<std::size_t>(n);
            into = into.subspan(static_cast<std::size_t>(n));
        }
        return true;
    }
};

namespace {

/// Size of the file up to its last byte that is not zero.
std::size_t size_without_zeros(const LogDescriptor& file) {
    Bytes piece(std::size_t{1} << 20U);
    for (auto end = file.size; end > 0;) {
        const auto begin = end > piece.size() ? end - piece.size() : 0;
        const auto part = std::span(piece).first(end - begin);
        if (!file.read_at(begin, part)) return file.size;
        const auto last =
            std::find_if(part.rbegin(), part.rend(), [](std::byte b) { return b != std::byte{}; });
        if (last != part.rend()) return end - static_cast<std::size_t>(last - part.rbegin());
        end = begin;
    }
    return 0;
}

Expected<LogDescriptor> open_file(const std::string& path) {
    // O_NONBLOCK: opening a fifo without a writer must not hang.
    LogDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK), 0);
    struct stat info {};
    if (file.fd < 0) return fail(text(path, ": cannot open: ", std::strerror(errno)));
    if (::fstat(file.fd, &info) != 0) return fail(text(path, ": cannot read: ", std::strerror(errno)));
    if (!S_ISREG(info.st_mode)) return fail(text(path, ": not an ordinary file"));
    file.size = static_cast<std::size_t>(info.st_size);
    if (file.size == 0) return fail(text(path, ": not a Thaum log (empty file)"));
    declare_read(path);
    return file;
}

}  // namespace

struct OpenedLog {
    LogDescriptor file;
    LogHeader header;
    detail::Preamble preamble;
    std::size_t header_size;
};

namespace {

Expected<OpenedLog> open_log(const std::string& path) {
    const auto bad = [&](std::string_view what) { return fail(text(path, ": ", what)); };
    auto file = open_file(path);
    if (!file) return file.error();
    Bytes bytes(std::min(file->size, detail::preamble_size));
    if (!file->read_at(0, bytes)) return bad("cannot read");
    const auto preamble = detail::decode_preamble(bytes);
    if (!preamble) return bad(preamble.error().message);
    if (file->size > detail::file_limit) return bad("larger than a log can be (1 GiB)");
    const auto header_size = detail::preamble_size + preamble->body_size;
    if (header_size > file->size) return bad("the header is cut off or damaged");
    bytes.resize(header_size);
    if (!file->read_at(0, bytes)) return bad("cannot read");
    auto header = detail::decode_header(bytes, *preamble);
    if (!header) return bad(header.error().message);
    return OpenedLog{std::move(*file), std::move(*header), *preamble, header_size};
}

}  // namespace

/// Position of a block of ticks in the file.
struct BlockPlace {
    Tick first{};  ///< number of the first frame of the block, from 0
    std::size_t at{};
};

/// Smallest number of zero bytes at the end of a log that is taken as a power cut. With fewer it is
/// uncertain, because a block may end with zeros.
constexpr std::size_t min_zeros = 16;

struct LogReader::State {
    State(std::string name, OpenedLog opened)
        : path(std::move(name)),
          log(std::move(opened)),
          unpacker(log.header.devices.size(), log.preamble),
          payload(detail::packed_limit),
          at(log.header_size) {}

    std::string path;
    OpenedLog log;
    detail::Unpacker unpacker;
    Bytes payload;
    std::vector<HashRecord> hashes;
    std::vector<Mark> marks;
    std::string result;
    std::string reason;
    LogEnding ending = LogEnding::cut_off;
    Tick ticks = 0;  // number of ticks in complete blocks
    // Positions of some blocks, from which `seek` starts; not of all, because damaged logs may have many
    // small blocks.
    std::vector<BlockPlace> kept;

    // Position of the next read: the block at `at` (bytes), or frame `at_frame` of the block decoded last.
    std::size_t at;
    std::size_t at_frame = 0;
    detail::Block block;

    /// Notes how and why the log ends. Returns false, which the caller returns as well.
    bool end(LogEnding how, std::string_view what) {
        ending = how;
        reason = how == LogEnding::damaged ? text(path, ": tick ", ticks, ": block damaged (", what, ")")
                                           : text(path, ": cut off after tick ", ticks, " (", what, ")");
        return false;
    }
    /// Handles a block whose bytes, up to `end`, differ from those that were written. A power cut leaves a
    /// file of its full size whose last pages are zeros. Other damage seldom does, so zeros are reported as a
    /// cut-off.
    bool damaged_or_unwritten(std::size_t end, std::string_view what) {
        const auto written = size_without_zeros(log.file);
        const bool zeros = written < end && log.file.size - written >= min_zeros;
        return zeros ? cut_off("zeros at the end") : damaged(what);
    }
    bool cut_off(std::string_view what) { return end(LogEnding::cut_off, what); }
    bool damaged(std::string_view what) { return end(LogEnding::damaged, what); }

    /// Reads the header of the block at `at`, and the block's bytes into `payload`.
    bool read_block(detail::BlockHeader& header) {
        std::array<std::byte, detail::block_header_size> head{};
        const auto left = log.file.size - at;
        if (left == 0) return cut_off("no end block");
        if (left < head.size()) return cut_off("part of a block");
        if (!log.file.read_at(at, head)) return damaged("cannot read");
        const auto found = detail::decode_block_header(head, log.preamble);
        if (!found) return damaged_or_unwritten(at + head.size(), "block header");
        header = *found;
        if (header.first != ticks) return damaged("blocks missing");
        if (left - head.size() < header.packed_size) return cut_off("part of a block");
        if (!log.file.read_at(at + head.size(), std::span(payload).first(header.packed_size))) {
            return damaged("cannot read");
        }
        at += head.size() + header.packed_size;
        return true;
    }

    /// Decodes the next block of ticks into `block`. Returns false at the end of the log; `ending` and
    /// `reason` then say why it ended.
    bool decode_block() {
        detail::BlockHeader header;
        if (!read_block(header)) return false;
        const auto bytes = std::span<const std::byte>(payload).first(header.packed_size);
        if (header.kind == detail::BlockKind::end) return read_end(header, bytes);
        return unpacker.ticks(header, bytes, block) || damaged_or_unwritten(at, "payload");
    }

    bool read_end(const detail::BlockHeader& header, std::span<const std::byte> bytes) {
        auto end_block = unpacker.end(header, bytes);
        if (!end_block) return damaged_or_unwritten(at, "payload");
        if (at != log.file.size) return damaged("bytes after the end");
        if (end_block->last && !add_last(*end_block->last)) return damaged("payload");
        ending = LogEnding::clean;
        result = std::move(end_block->result);
        return false;
    }

    /// Adds the hashes of the last state. Returns false if the log's last block has other hashes for the same
    /// tick.
    bool add_last(const HashRecord& last) {
        if (!hashes.empty() && hashes.back().tick == last.tick) return hashes.back() == last;
        hashes.push_back(last);
        return true;
    }

    /// Adds the hashes and marks of `block` to those of the blocks before it. Returns false, and the log ends
    /// as damaged, if the block's first hash is not later than the last hash so far, or if there are too many
    /// marks.
    bool collect() {
        const auto new_hashes = std::span(block.hashes).first(block.hash_count);
        const auto new_marks = std::span(block.marks).first(block.mark_count);
        const bool rising =
            new_hashes.empty() || hashes.empty() || new_hashes.front().tick > hashes.back().tick;
        if (!rising || marks.size() + new_marks.size() > detail::mark_limit) {
            return damaged("payload");
        }
        hashes.insert(hashes.end(), new_hashes.begin(), new_hashes.end());
        marks.insert(marks.end(), new_marks.begin(), new_marks.end());
        return true;
    }

    void scan() {
        for (auto begin = at; decode_block() && collect(); begin = at) {
            if (kept.empty() || ticks >= kept.back().first + detail::block_ticks)
                kept.push_back({ticks, begin});
            ticks += block.ticks;
        }
        seek(0);
    }

    void seek(Tick tick) {
        const auto after = std::upper_bound(kept.begin(), kept.end(), tick,
                                            [](Tick t, const BlockPlace& place) { return t < place.first; });
        const auto place = after == kept.begin() ? BlockPlace{0, log.header_size} : *std::prev(after);
        at = place.at;
        at_frame = 0;
        block.first = place.first;
        block.ticks = 0;
        while (block.first + block.ticks <= tick && next_block()) {}
        at_frame = std::min<std::size_t>(tick - std::min(tick, block.first), block.ticks);
    }

    bool next(InputFrame& frame) {
        if (at_frame == block.ticks && !next_block()) return false;
        frame = block.frames[at_frame++];
        return true;
    }

    /// Decodes the next block. `open` has checked it, so any fault means that the file has changed since.
    bool next_block() {
        const auto all = ticks;
        const auto first = block.first + block.ticks;
        if (first >= all) return false;
        ticks = first;  // number of ticks so far, which read_block uses in messages
        const bool decoded = decode_block() && first + block.ticks <= all;
        if (!decoded) {
            damaged("changed while it was read");
            at_frame = block.ticks = 0;
            block.first = first;
            return false;
        }
        ticks = all;
        at_frame = 0;
        return true;
    }
};

LogReader::LogReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
LogReader::LogReader(LogReader&&) noexcept = default;
LogReader& LogReader::operator=(LogReader&&) noexcept = default;
LogReader::~LogReader() = default;

Expected<LogReader> LogReader::open(const std::filesystem::path& path) {
    auto log = open_log(path.string());
    if (!log) return log.error();
    LogReader reader(std::make_unique<State>(path.string(), std::move(*log)));
    reader.state_->scan();
    return reader;
}

const LogHeader& LogReader::header() const { return state_->log.header; }
std::uint32_t LogReader::format() const { return state_->log.preamble.format; }
Tick LogReader::ticks() const { return state_->ticks; }
LogEnding LogReader::ending() const { return state_->ending; }
const std::string& LogReader::ending_reason() const { return state_->reason; }
const std::string& LogReader::result() const { return state_->result; }
const std::vector<HashRecord>& LogReader::hashes() const { return state_->hashes; }
const std::vector<Mark>& LogReader::marks() const { return state_->marks; }

std::optional<HashRecord> LogReader::hash_at(Tick tick) const {
    const auto& all = state_->hashes;
    const auto found = std::lower_bound(all.begin(), all.end(), tick,
                                        [](const HashRecord& h, Tick t) { return h.tick < t; });
    if (found == all.end() || found->tick != tick) return {};
    return *found;
}

bool LogReader::next(InputFrame& frame) { return state_->next(frame); }
void LogReader::seek(Tick tick) { state_->seek(tick); }

bool log_in_use(const std::filesystem::path& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) return false;
    const bool locked = ::flock(fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(fd);
    return locked;
}

Expected<void> remove_log(const std::filesystem::path& path) {
    const auto stays = [&](std::string_view why) {
        return fail(text(path.string(), ": not removed: ", why));
    };
    std::error_code failed;
    if (!std::filesystem::exists(std::filesystem::symlink_status(path, failed))) return {};
    const bool is_empty =
        std::filesystem::is_regular_file(path, failed) && std::filesystem::is_empty(path, failed);
    if (!is_empty && !begins_like_recording(path)) return stays("it is not a log");
    if (log_in_use(path)) return stays("a program is recording into it");
    if (std::filesystem::remove(path, failed)) return {};
    return stays(failed.message());
}

Expected<LogHeader> read_log_header(const std::filesystem::path& path) {
    auto log = open_log(path.string());
    if (!log) return log.error();
    return std::move(log->header);
}

}  // namespace thaum::input
