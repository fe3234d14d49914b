#include "input/log.h"

// There are two threads: the simulation fills a block, the log's thread packs and writes it. Blocks pass
// between them on two lock-free stacks: one for full blocks, one for blocks to be used again. Neither thread
// can block the other, even if the system suspends one of them at any point. A job of core/jobs.h would
// allocate for every block; this code never does.
//
// The file is a whole log at every moment: a block is written by one call, and a failed write is truncated.
// Written bytes survive a crash of the program. About once a second they are flushed to the disk, so a power
// cut costs little more than that. The log's thread waits for the flush, and no other thread does. A log is
// locked while it is recorded (flock).
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "core/assert.h"
#include "core/file.h"
#include "core/text.h"
#include "core/threads.h"
#include "input/detail/block.h"

namespace thaum::input {
namespace {

// Number of blocks of 512 ticks at the start; enough for a disk that stalls for 4 s.
constexpr std::size_t usual_blocks = 8;
constexpr std::size_t max_blocks = 256;  // largest number of blocks: 2 minutes, 22 MiB; then recording ends

using Clock = std::chrono::steady_clock;
constexpr auto sync_interval = std::chrono::seconds(1);

}  // namespace

/// Action of the log's thread after it has written a block.
enum class AfterBlock : std::uint8_t { go_on, stop, end_block };

struct QueuedBlock : detail::Block {
    AfterBlock after = AfterBlock::go_on;
    QueuedBlock* next = nullptr;
};

/// Stack of blocks. Any thread may push. One thread takes all blocks at once, so no block can return between
/// two reads of the head (no ABA problem).
class BlockStack {
public:
    void push(QueuedBlock* block) {
        block->next = head_.load(std::memory_order_relaxed);
        while (!head_.compare_exchange_weak(block->next, block, std::memory_order_release,
                                            std::memory_order_relaxed)) {}
    }

    /// Returns the list linked by `next`, the newest first.
    QueuedBlock* take_all() { return head_.exchange(nullptr, std::memory_order_acquire); }

private:
    std::atomic<QueuedBlock*> head_{nullptr};
};

namespace {

QueuedBlock* reversed(QueuedBlock* list) {
    QueuedBlock* result = nullptr;
    while (list != nullptr) {
        auto* next = list->next;
        list->next = result;
        result = list;
        list = next;
    }
    return result;
}

/// Flushes the folder, which holds the file's name and is written to the disk separately. Some file systems
/// cannot flush a folder; they flush it with the file.
void sync_folder_of(const std::filesystem::path& path) {
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) return;
    ::fsync(fd);
    ::close(fd);
}

/// Blocks signals in this thread, so that other threads handle them. Exceeding a file size limit (SIGXFSZ)
/// then makes `write` fail here.
void block_signals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

struct LogWriter::State {
    State(std::string file_name, int descriptor, std::size_t header_size, std::uint64_t salt,
          std::size_t devices, WhenBehind behind)
        : path(std::move(file_name)),
          fd(descriptor),
          device_count(devices),
          when_behind(behind),
          packer(devices, salt),
          good_size(header_size) {
        blocks.reserve(max_blocks);
        for (std::size_t i = 0; i < usual_blocks; ++i) spare = make_block(spare);
        current = take_spare();
    }

    /// Starts the log's thread, which alone writes blocks to the file. The error says why the system refuses
    /// the thread.
    Expected<void> start() {
        auto started = start_thread([this] { work(); });
        if (!started) return started.error();
        thread = std::move(*started);
        return {};
    }

    ~State() {
        finish(AfterBlock::stop);
        ::close(fd);
    }

    const std::string path;
    const int fd;
    const std::size_t device_count;
    const WhenBehind when_behind;

    // The next members are used by the appending thread.
    std::vector<std::unique_ptr<QueuedBlock>> blocks;
    QueuedBlock* current = nullptr;
    QueuedBlock* spare = nullptr;
    Tick next_hash = 0;  // smallest tick that the next hash may have
    std::size_t mark_count = 0;
    bool finished = false;

    // The next members are shared between the threads.
    BlockStack full, used;
    std::atomic<std::uint32_t> handed_over{0};
    std::atomic<Tick> appended{0};
    std::atomic<Tick> on_disk{0};
    std::atomic<std::size_t> extra_blocks{0};
    // True if recording ended early. `fault` is set before and does not change afterwards.
    std::atomic<bool> stopped{false};
    std::atomic_flag fault_taken;
    std::string fault;
    // Text for the end block, with which the log is closed; set before the last block is handed over, as is
    // `last`.
    std::string result;
    std::optional<HashRecord> last;  // hashes of the last state

    // The next members are used by the log's thread.
    detail::Packer packer;
    std::size_t good_size;  // size of the file up to the last whole block (bytes)
    bool write_failed = false;
    Clock::time_point synced{};
    std::jthread thread;

    // Functions of the appending thread --------------------------------------------------------------

    QueuedBlock* make_block(QueuedBlock* next) {
        blocks.push_back(std::make_unique<QueuedBlock>());
        blocks.back()->next = next;
        return blocks.back().get();
    }

    QueuedBlock* take_spare() {
        if (spare == nullptr) spare = used.take_all();
        while (spare == nullptr && when_behind == WhenBehind::wait) {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
            spare = used.take_all();
        }
        if (spare == nullptr && blocks.size() < max_blocks) {
            spare = make_block(nullptr);
            extra_blocks.fetch_add(1, std::memory_order_relaxed);
        }
        auto* block = spare;
        if (block != nullptr) spare = block->next;
        return block;
    }

    void begin_block() {
        current->first = appended.load(std::memory_order_relaxed);
        current->ticks = current->hash_count = current->mark_count = 0;
        current->after = AfterBlock::go_on;
    }

    void hand_over(AfterBlock after) {
        current->after = after;
        full.push(current);
        handed_over.fetch_add(1, std::memory_order_release);
        handed_over.notify_one();
    }

    /// Hands over the full block and takes a free one. Returns false if none is free; the full block then
    /// stays the current one, and `finish` writes it.
    bool next_block() {
        auto* next = take_spare();
        if (next == nullptr) {
            stop(text("the disk is too slow; kept up to tick ", appended.load()));
            return false;
        }
        hand_over(AfterBlock::go_on);
        current = next;
        begin_block();
        return true;
    }

    bool recording() const { return !finished && !stopped.load(std::memory_order_relaxed); }

    void append(const InputFrame& frame) {
        if (!recording()) return;
        for (auto i = device_count; i < max_devices; ++i) {
            THAUM_ASSERT(frame.devices[i] == DeviceSample{}, "a sample of a device that the header lacks");
        }
        const auto tick = appended.load(std::memory_order_relaxed);
        if (tick >= detail::tick_limit) return stop(text("a log holds ", tick, " ticks and no more"));
        if (current->ticks == detail::block_ticks && !next_block()) return;
        current->frames[current->ticks++] = frame;
        appended.store(tick + 1, std::memory_order_relaxed);
    }

    void append_hash(const HashRecord& hash) {
        if (!recording()) return;
        THAUM_ASSERT(hash.tick % hash_interval == 0, "hash at a tick that is no multiple of hash_interval");
        THAUM_ASSERT(hash.tick >= next_hash && hash.tick >= current->first, "hash for an earlier tick");
        THAUM_ASSERT(hash.tick <= current->first + current->ticks, "hash for a tick not yet appended");
        next_hash = hash.tick + 1;
        current->hashes[current->hash_count++] = hash;
    }

    void mark(std::uint32_t number, MarkKind kind) {
        const bool room = mark_count < detail::mark_limit && current->mark_count < detail::block_marks;
        if (!recording() || !room) return;
        ++mark_count;
        current->marks[current->mark_count++] = {appended.load(std::memory_order_relaxed), kind, number};
    }

    /// Waits until the log's thread has written everything.
    void finish(AfterBlock after) {
        if (finished) return;
        finished = true;
        if (!thread.joinable()) return;  // nothing to wait for, because the thread could not be started
        hand_over(after);
        thread.join();
    }

    // Records why recording stopped; either thread may call it. Only the first reason is kept.
    void stop(std::string_view why) {
        if (fault_taken.test_and_set()) return;
        fault = text(path, ": recording stopped: ", why);
        stopped.store(true, std::memory_order_release);
    }

    // Functions of the log's thread ------------------------------------------------------------------

    void work() {
        block_signals();
        sync_folder_of(path);
        for (;;) {
            const auto seen = handed_over.load(std::memory_order_acquire);
            auto* list = reversed(full.take_all());
            if (list == nullptr) handed_over.wait(seen, std::memory_order_acquire);
            while (list != nullptr) {
                auto* block = list;
                list = block->next;
                const auto after = block->after;
                write_block(*block);
                used.push(block);
                if (after != AfterBlock::go_on) return;
            }
        }
    }

    void write_block(const QueuedBlock& block) {
        if (block.ticks > 0 && write_whole(packer.ticks(block))) {
            on_disk.store(block.first + block.ticks, std::memory_order_relaxed);
        }
        // The appending thread may have stopped early because it had no free block. Then the log was not
        // closed cleanly.
        const bool whole = !stopped.load(std::memory_order_acquire);
        if (block.after == AfterBlock::end_block && whole) {
            write_whole(packer.end(block.first + block.ticks, {result, last}));
        }
        if (block.after != AfterBlock::go_on || Clock::now() >= synced + sync_interval) sync();
    }

    /// Flushes the file to the disk. A full disk may report its error only here, not at the write.
    void sync() {
        if (write_failed) return;
        synced = Clock::now();
        if (flush_to_disk(fd)) return;
        write_failed = true;
        stop(text(std::strerror(errno), " (flushing); kept up to about tick ", on_disk.load()));
    }

    /// Writes a whole block. After the first failure nothing more is written, because a later block would
    /// leave a gap.
    bool write_whole(std::span<const std::byte> bytes) {
        if (write_failed) return false;
        const bool fits = good_size + bytes.size() <= detail::file_limit;
        if (fits && write_all(fd, bytes)) {
            good_size += bytes.size();
            return true;
        }
        write_failed = true;
        const auto why = fits ? std::strerror(errno) : "a log holds 1 GiB and no more";
        // If truncating fails too, readers find a cut-off block, which they leave out as well.
        const bool cut = ::ftruncate(fd, static_cast<off_t>(good_size)) == 0;
        stop(text(why, "; kept up to tick ", on_disk.load(), cut ? "" : " and part of a block"));
        return false;
    }
};

LogWriter::LogWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
LogWriter::LogWriter(LogWriter&&) noexcept = default;
LogWriter& LogWriter::operator=(LogWriter&&) noexcept = default;
LogWriter::~LogWriter() = default;

Expected<LogWriter> LogWriter::create(const std::filesystem::path& path, const LogHeader& header,
                                      WhenBehind when_behind) {
    const auto bytes = detail::encode_header(header);
    if (!bytes) return fail(text(path.string(), ": ", bytes.error().message));
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0 && errno == EEXIST) {
        return fail(
            text(path.string(), ": exists already, and a log is never overwritten: give another name"));
    }
    if (fd < 0) return fail(text(path.string(), ": cannot create: ", std::strerror(errno)));
    ::flock(fd, LOCK_EX | LOCK_NB);  // this cannot fail, because the file is new
    if (!write_all(fd, *bytes)) {
        const auto why = std::strerror(errno);
        ::close(fd);
        ::unlink(path.c_str());
        return fail(text(path.string(), ": cannot write: ", why));
    }
    const auto salt = detail::decode_preamble(*bytes)->salt;
    auto state =
        std::make_unique<State>(path.string(), fd, bytes->size(), salt, header.devices.size(), when_behind);
    if (const auto started = state->start(); !started) {
        ::unlink(path.c_str());
        return fail(text(path.string(), ": cannot record: ", started.error().message));
    }
    return LogWriter(std::move(state));
}

void LogWriter::append(const InputFrame& frame) { state_->append(frame); }

void LogWriter::append_hash(Tick tick, std::uint64_t state, std::uint64_t force) {
    state_->append_hash({tick, state, force});
}

void LogWriter::mark(std::uint32_t number, MarkKind kind) { state_->mark(number, kind); }

Tick LogWriter::ticks() const { return state_->appended.load(std::memory_order_relaxed); }
Tick LogWriter::ticks_on_disk() const { return state_->on_disk.load(std::memory_order_relaxed); }
std::size_t LogWriter::extra_blocks() const { return state_->extra_blocks.load(std::memory_order_relaxed); }

std::optional<Error> LogWriter::error() const {
    if (!state_->stopped.load(std::memory_order_acquire)) return {};
    return Error{state_->fault};
}

Expected<void> LogWriter::close(std::string_view result, std::optional<HashRecord> last) {
    if (!state_->finished) {
        state_->result = result;
        // Hashes for another tick are dropped: a log that stopped early gets no end block to hold them.
        if (last && last->tick == ticks()) state_->last = last;
    }
    state_->finish(AfterBlock::end_block);
    if (auto fault = error()) return Error(std::move(*fault));
    return {};
}

}  // namespace thaum::input
