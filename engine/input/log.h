// input/log.h: the input log (.thaumlog): everything a match needs to be played again, and hashes to check that it
// was. FORMAT.md gives every byte.
//
// Recording must not disturb a match and must outlive it: the simulation thread copies frames into blocks of 512
// ticks; a thread of the log packs and writes them, so kill -9, a crash or a full disk costs the last block or two, and
// forces them onto the disk every second, so a power cut costs a few seconds.
// Reading trusts nothing: every byte is under a checksum, every size has a limit.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/units.h"
#include "input/frame.h"

namespace thaum::input {

/// A data file that the match depends on.
struct DataFile {
    std::string name;      ///< path below assets/
    std::uint64_t hash{};  ///< hash of its keys and values
    bool operator==(const DataFile&) const = default;
};

/// All that decides a match, but for the frames.
struct LogHeader {
    std::string program;            ///< version of the program that recorded, for people
    std::uint32_t rules_version{};  ///< a replay needs the same
    std::string rule_set;           ///< "thaum" or "classic"
    std::string arena;              ///< its name; its content is among `files`
    std::uint64_t seed{};
    std::uint64_t maths_probe{};          ///< hash of the elementary functions' results
    std::vector<std::string> players;     ///< "human", "bot 1"; at most 16
    std::vector<DeviceSpec> devices;      ///< at most max_devices; one column of samples each
    std::vector<DataFile> files;          ///< at most 1,000
    std::vector<std::string> overrides;   ///< --set, "key=value", in order; at most 1,000
    std::vector<std::string> parameters;  ///< of the match, "key=value": kills to win, seconds; at most 1,000
    bool operator==(const LogHeader&) const = default;
};

/// Hashes of the state after `tick` ticks; tick is a multiple of hash_interval, or that of the log's last state.
struct HashRecord {
    Tick tick{};
    std::uint64_t state{};
    std::uint64_t force{};
    bool operator==(const HashRecord&) const = default;
};

enum class MarkKind : std::uint8_t { user, keyframe };

/// A place worth finding again.
struct Mark {
    Tick tick{};
    MarkKind kind{};
    std::uint32_t number{};
    bool operator==(const Mark&) const = default;
};

/// What `append` does when blocks fill faster than the disk takes them.
enum class WhenBehind : std::uint8_t {
    allocate,  ///< a match in real time: never wait; more blocks, up to 2 minutes of them, then recording stops
    wait,      ///< faster than real time, where nobody is kept waiting: until a block is free
};

/// Records a match. One thread appends; `error` and `ticks_on_disk` may be asked from any.
class LogWriter {
public:
    /// Creates the file and writes the header. The error names the path: it exists (a log is never written over,
    /// so two programs never share one), it cannot be created, or the header is beyond the format's limits.
    static Expected<LogWriter> create(const std::filesystem::path& path, const LogHeader& header,
                                      WhenBehind when_behind = WhenBehind::allocate);

    LogWriter(LogWriter&&) noexcept;
    LogWriter& operator=(LogWriter&&) noexcept;
    /// Without `close` the log keeps all that was appended but reads as cut off.
    ~LogWriter();

    /// The frame of the next tick; devices beyond the header's must be zero. No file access, no lock; no allocation
    /// while the disk is less than 4 s behind.
    void append(const InputFrame& frame);
    /// Hashes of the state after `tick` ticks: a multiple of hash_interval, rising, and not beyond what was
    /// appended. Give them before the next frame is appended.
    void append_hash(Tick tick, std::uint64_t state, std::uint64_t force);
    /// Marks the state after `ticks()` ticks. At most 64 in a block of 512 ticks; more are dropped.
    void mark(std::uint32_t number, MarkKind kind = MarkKind::user);

    /// Ticks appended so far.
    Tick ticks() const;
    /// Ticks that lie in the file.
    Tick ticks_on_disk() const;
    /// Blocks that had to be allocated because the disk was slow; 0 in a normal match.
    std::size_t extra_blocks() const;
    /// Why recording ended early (a full disk), in one line that says what was kept. The match goes on.
    std::optional<Error> error() const;

    /// Writes what is left, and into the end block `result` (one line, at most 4,096 bytes kept) and the hashes of the
    /// last state, where they are given; their tick is `ticks()`. The error is that of `error`.
    Expected<void> close(std::string_view result, std::optional<HashRecord> last = {});

private:
    struct State;
    explicit LogWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// How a log ends.
enum class LogEnding {
    clean,    ///< closed by the program
    cut_off,  ///< the program or machine stopped while recording (zeros at the end: by a power cut): a warning
    damaged,  ///< bytes are not those that were written: `replay --verify` fails
};

/// Reads a log. Memory stays below 64 MiB whatever the file holds.
class LogReader {
public:
    /// Reads and checks the whole file, so that all below is known. The error is one line with the path: no
    /// ordinary file, no log, a newer format, a damaged or cut-off header. Damage or cut-off later on is no
    /// error: the log reads up to the last whole block before it.
    static Expected<LogReader> open(const std::filesystem::path& path);

    LogReader(LogReader&&) noexcept;
    LogReader& operator=(LogReader&&) noexcept;
    ~LogReader();

    const LogHeader& header() const;
    /// Ticks that can be read.
    Tick ticks() const;
    LogEnding ending() const;
    bool ended_cleanly() const { return ending() == LogEnding::clean; }
    /// One line with the path unless the ending is clean: "F: cut off after tick 4096 (part of a block)",
    /// "F: tick 4096: block damaged (payload)".
    const std::string& ending_reason() const;
    /// The text given to close; empty unless the ending is clean.
    const std::string& result() const;

    /// By rising tick, that of the end block included.
    const std::vector<HashRecord>& hashes() const;
    std::optional<HashRecord> hash_at(Tick tick) const;
    /// In the order in which they were made.
    const std::vector<Mark>& marks() const;

    /// The next frame; false after `ticks()` of them. Also false, and the ending becomes damaged, where the file
    /// was changed after `open`.
    bool next(InputFrame& frame);
    /// `next` starts again at tick 0.
    void rewind();

private:
    struct State;
    explicit LogReader(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Is it being recorded now, by this or another program?
bool log_in_use(const std::filesystem::path& path);

/// Removes the log of an earlier run, so that the next one can have its name; no error where nothing is there. The
/// error names what lies there and stays: no log, or one that is being recorded.
Expected<void> remove_log(const std::filesystem::path& path);

/// Only the header, for lists of logs. Errors as LogReader::open.
Expected<LogHeader> read_log_header(const std::filesystem::path& path);

}  // namespace thaum::input
