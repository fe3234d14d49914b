#include "game/jackets/makers/recorder.h"

#include <optional>
#include <utility>

#include "core/file_writer.h"
#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/jackets/felt_rows.h"
#include "game/jackets/jacket.h"
#include "game/jackets/jacket_output.h"
#include "game/jackets/place_name.h"

namespace thaum::game::inline jackets {
namespace {

constexpr int max_names = 10'000;
constexpr std::size_t max_of_path_shown = 200;
/// Number of rows after which they are written to the disk; few enough that a full disk is noticed within
/// seconds.
constexpr int rows_between_flushes = 125;

class FeltRecorder final : public JacketOutput {
public:
    FeltRecorder(std::filesystem::path file, std::uint32_t player)
        : wanted_(std::move(file)), player_(player) {}
    ~FeltRecorder() override { FeltRecorder::close(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override {}
    bool is_connected() override { return file_ && file_->is_whole(); }
    bool wants_every_frame() const override { return true; }
    void close() override;
    std::string name() const override {
        return text("recording of what is felt, ", printable(path_.string(), max_of_path_shown));
    }

private:
    const std::filesystem::path wanted_;
    const std::uint32_t player_;
    std::filesystem::path path_ = wanted_;
    std::optional<FileWriter> file_{};
    std::string rows_{};
    int unflushed_ = 0;
};

/// Creates a file under the first of the names FILE.csv, FILE_2.csv, ... that is free. If another program
/// takes the name between the check and the creation, the next name is tried.
Expected<FileWriter> start_new(const std::filesystem::path& wanted, std::filesystem::path& name) {
    for (int i = 1; i < max_names; ++i) {
        name = wanted;
        if (i > 1) name.replace_filename(text(wanted.stem().string(), "_", i, wanted.extension().string()));
        const auto is_there = [&] {
            std::error_code unknown;
            return std::filesystem::exists(std::filesystem::symlink_status(name, unknown));
        };
        if (is_there()) continue;
        auto made = FileWriter::create_new(name);
        if (made || !is_there()) return made;
    }
    return fail("there are too many recordings of this name; choose another");
}

Expected<void> FeltRecorder::open() {
    if (!fault_.empty()) return fail(fault_);  // after a fault, such as a full disk, no other file is tried
    close();
    auto made = start_new(wanted_, path_);
    if (!made) return made.error();
    file_.emplace(std::move(*made));
    file_->write(felt_header());
    return {};
}

void FeltRecorder::write(const tactile::TactileFrame& frame, double) {
    if (!file_) return;
    rows_.clear();
    append_felt(rows_, player_, frame);
    file_->write(rows_);
    if (++unflushed_ < rows_between_flushes) return;
    unflushed_ = 0;
    file_->flush();
    if (!file_->is_whole()) fault_ = "it cannot be written, such as on a full disk; nothing is kept";
}

/// Completes the file. Prints a fault, because nobody asks a closed output for its faults.
void FeltRecorder::close() {
    if (!file_) return;
    const bool told = !fault_.empty();
    const auto closed = file_->close();
    file_.reset();
    if (closed || told) return;
    fault_ = in_one_line(closed.error().message);
    tell_user(text("player ", player_ + 1, ": recording of what is felt: ", fault_));
}

Expected<std::string> read(std::string_view, std::string_view file) {
    if (fits_name(file) && file.ends_with(".csv") && file != ".csv" && !file.ends_with("/.csv"))
        return std::string(file);
    return fail("write \"record:FILE.csv\"");
}

std::unique_ptr<input::TactileOutput> make(const Jacket& jacket, std::uint32_t player) {
    return felt_recorder(jacket.place, player);
}

/// Checks whether the folder of the file exists, without recording.
JacketCheck check(const Jacket& jacket, input::TactileOutput&) {
    const auto folder = std::filesystem::absolute(jacket.place).parent_path();
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) return {true, "", ""};
    return {false, text(": there is no folder ", folder.string()), "make it"};
}

// A recorder keeps the layout of the body's picture, because the table has a column for each of its cells.
const JacketRegistration registration({.name = "recorder",
                                       .order = 5,
                                       .forms = {{"record", figure_layout}},
                                       .shown = {"record:FILE.csv"},
                                       .read = read,
                                       .make = make,
                                       .check = check,
                                       .keeps_layout = "a recording always has the cells of the figure"});

}  // namespace

std::unique_ptr<input::TactileOutput> felt_recorder(std::filesystem::path file, std::uint32_t player) {
    return std::make_unique<FeltRecorder>(std::move(file), player);
}

}  // namespace thaum::game::inline jackets
