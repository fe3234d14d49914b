// input/log.h: the input log (.thaumlog): everything needed to play a match again, and hashes to check the
// replay. FORMAT.md describes every byte.
//
// Recording must not disturb a match, and the log must survive a crash of the program. The simulation thread
// copies frames into blocks of 512 ticks. A thread of the log packs and writes them, so kill -9, a crash or a
// full disk costs the last block or two. It flushes them to the disk every second, so a power cut costs a few
// seconds. A reader does not trust the file: every byte is under a checksum, and every size has a limit.
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

/// A data file on which the match depends.
struct DataFile {
    std::string name;      ///< path of the file below assets/
    std::uint64_t hash{};  ///< hash of the file's keys and values
    bool operator==(const DataFile&) const = default;
};

/// A kind of thing, such as an event or a wand, and the number by which saved states and samples name it.
struct Kind {
    std::uint16_t number{};
    std::string name;
    bool operator==(const Kind&) const = default;
};

/// The kinds of one group, such as all wands, with the numbers that identify them.
struct KindTable {
    std::string group;        ///< name of the group: "event", "cause", "wand"
    std::vector<Kind> kinds;  ///< kinds in ascending order of their numbers; at most 1,000
    bool operator==(const KindTable&) const = default;
};

/// Data of a player's profile on which the match depends, such as recorded gestures. The log holds the data
/// itself, because a profile changes between matches.
struct ProfileData {
    std::string kind;        ///< kind of the data, such as gestures, which decides the meaning of `bytes`
    std::string name;        ///< name within the kind and the player
    std::uint32_t player{};  ///< index into LogHeader::players
    std::vector<std::byte> bytes;
    bool operator==(const ProfileData&) const = default;
};

/// Everything that decides a match, except the frames.
struct LogHeader {
    std::string program;            ///< version of the recording program, for display
    std::uint32_t rules_version{};  ///< version of the rules; a replay needs the same one
    std::string rule_set;           ///< name of the rule set: "thaum" or "classic"
    std::string arena;              ///< name of the arena; its content is among `files`
    std::uint64_t seed{};
    /// Hash of the results of elementary functions; another value means a faulty build, which cannot replay
    /// this log.
    std::uint64_t maths_probe{};
    std::string physics_library;  ///< name and version, such as "Bullet 3.24"; empty in format 1
    /// Precision of the physics library's numbers, such as "double"; empty in format 1.
    std::string physics_precision;
    std::vector<std::string> players;  ///< a name for each player, such as "human" or "bot 1"; at most 16
    /// Devices, at most max_devices; each has its own columns of samples.
    std::vector<DeviceSpec> devices;
    std::vector<DataFile> files;         ///< data files on which the match depends; at most 1,000
    std::vector<std::string> overrides;  ///< values of the option --set, "key=value", in order; at most 1,000
    /// Parameters of the match, "key=value": kills to win, seconds; at most 1,000.
    std::vector<std::string> parameters;
    /// Numbers that identify the kinds of each group, such as wands; at most 16, sorted; none in format 1.
    std::vector<KindTable> kinds;
    std::vector<ProfileData> profile;  ///< data of players' profiles; at most 1,000
    /// Names of the players for display; an empty one means the team's name. There are at most as many as
    /// `players`.
    std::vector<std::string> names;
    bool operator==(const LogHeader&) const = default;
};

/// Hashes of the state after `tick` ticks, and of all forces since the last multiple of hash_interval before.
/// `tick` is a multiple of hash_interval, or the log's last tick.
struct HashRecord {
    Tick tick{};
    std::uint64_t state{};
    std::uint64_t force{};
    bool operator==(const HashRecord&) const = default;
};

/// Reason for a mark: a user asked for it, or the program made a keyframe (rebuilt physics from the state).
enum class MarkKind : std::uint8_t { user, keyframe };

/// A tick that was marked in order to find it again.
struct Mark {
    Tick tick{};
    MarkKind kind{};
    std::uint32_t number{};
    bool operator==(const Mark&) const = default;
};

/// Behaviour of `append` when blocks fill faster than the disk takes them.
enum class WhenBehind : std::uint8_t {
    /// for matches in real time: never waits; allocates more blocks, up to 2 minutes of them, then stops
    /// recording
    allocate,
    wait,  ///< for matches faster than real time: waits until a block is free
};

/// Records a match. One thread appends; any thread may call `error` and `ticks_on_disk`.
class LogWriter {
public:
    /// Creates the file and writes the header. The error names the path and says that the file exists, that
    /// it cannot be created, or that the header exceeds the format's limits. A log is never overwritten, so
    /// two programs never share one.
    static Expected<LogWriter> create(const std::filesystem::path& path, const LogHeader& header,
                                      WhenBehind when_behind = WhenBehind::allocate);

    LogWriter(LogWriter&&) noexcept;
    LogWriter& operator=(LogWriter&&) noexcept;
    /// Ends the recording. Without `close` before, the log keeps everything appended but reads as cut off.
    ~LogWriter();

    /// Appends the frame of the next tick. Samples of devices that the header does not list must be zero.
    /// Accesses no file and takes no lock. Allocates nothing while the disk lags less than 4 s behind.
    void append(const InputFrame& frame);
    /// Appends the hashes of state and forces after `tick` ticks. `tick` is a multiple of hash_interval,
    /// larger than at the last call, and not beyond the appended frames. Call it before the next frame is
    /// appended.
    void append_hash(Tick tick, std::uint64_t state, std::uint64_t force);
    /// Marks the state after `ticks()` ticks. A block of 512 ticks holds at most 64 marks; others are
    /// dropped.
    void mark(std::uint32_t number, MarkKind kind = MarkKind::user);

    /// Number of ticks that were appended so far, written or not.
    Tick ticks() const;
    /// Number of ticks in the file.
    Tick ticks_on_disk() const;
    /// Number of blocks allocated because the disk was slow; 0 in a normal match.
    std::size_t extra_blocks() const;
    /// Reason why recording ended early, such as a full disk, in one line that says what was kept. The match
    /// goes on.
    std::optional<Error> error() const;

    /// Writes the remaining blocks, and an end block with `result` and, if given, the hashes of the last
    /// state. `result` is one line, of which at most 4,096 bytes are kept. The tick of the hashes is
    /// `ticks()`. Returns the same error as `error`.
    Expected<void> close(std::string_view result, std::optional<HashRecord> last = {});

private:
    struct State;
    explicit LogWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Ending of a log.
enum class LogEnding {
    clean,  ///< the program closed the log
    /// The program or the machine stopped while recording (zeros at the end mean a power cut). This is only a
    /// warning.
    cut_off,
    damaged,  ///< bytes differ from those written; `replay --verify` fails
};

/// Reads a log. It uses less than 80 MiB of memory for any file.
class LogReader {
public:
    /// Opens a log and checks the whole file, so that all values below are known. The error is one line with
    /// the path: no ordinary file, no log, a newer format, or a header that is damaged or cut off. Damage
    /// after the header is no error: the log reads up to the last whole block before it.
    static Expected<LogReader> open(const std::filesystem::path& path);

    LogReader(LogReader&&) noexcept;
    LogReader& operator=(LogReader&&) noexcept;
    ~LogReader();

    /// Header of the log: program, rules, devices and data of the match.
    const LogHeader& header() const;
    /// Version of the log's format.
    std::uint32_t format() const;
    /// Number of ticks that can be read.
    Tick ticks() const;
    /// How the log ends.
    LogEnding ending() const;
    /// Whether the program closed the log.
    bool ended_cleanly() const { return ending() == LogEnding::clean; }
    /// One line with the path if the ending is not clean, such as "F: cut off after tick 4096 (part of a
    /// block)" or "F: tick 4096: block damaged (payload)".
    const std::string& ending_reason() const;
    /// The line of text with which the program closed the log; empty if the ending is not clean.
    const std::string& result() const;

    /// All hashes of state and forces by ascending tick, including those of the end block, with which a log
    /// is closed.
    const std::vector<HashRecord>& hashes() const;
    /// Hashes of state and forces recorded after `tick` ticks; std::nullopt: there are none.
    std::optional<HashRecord> hash_at(Tick tick) const;
    /// All marks, in the order in which they were made.
    const std::vector<Mark>& marks() const;

    /// Reads the next frame. Returns false after `ticks()` frames. If the file changed after `open`, returns
    /// false and the ending becomes damaged.
    bool next(InputFrame& frame);
    /// Makes `next` read the frame after `tick` frames, so that 0 starts again. The time does not depend on
    /// `tick`. Beyond the end `next` returns false.
    void seek(Tick tick);

private:
    struct State;
    explicit LogReader(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Returns true while this or another program records into the log.
bool log_in_use(const std::filesystem::path& path);

/// Removes the log of an earlier run, so that the next one can use its name. A missing file is no error. The
/// error names a file that stays because it is no log, or because it is being recorded.
Expected<void> remove_log(const std::filesystem::path& path);

/// Reads only the header, for lists of logs. The error is one line with the path: no ordinary file, no log, a
/// newer format, or a header that is damaged or cut off.
Expected<LogHeader> read_log_header(const std::filesystem::path& path);

}  // namespace thaum::input
