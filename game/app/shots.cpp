// thaum shots: makes the README's pictures from a replay. Also implements `replay --shots`.
#include "game/app/shots.h"

#include <algorithm>

#include "core/file.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/command_line/arguments.h"
#include "game/match/highlight.h"
#include "game/match/tables.h"
#include "game/settings/recorded_names.h"
#include "game/settings/settings.h"

namespace thaum::app {
namespace {

/// Tick with eight digits, so that file names sort by time; ten hours have eight digits.
std::string padded(Tick tick) {
    const auto digits = text(tick);
    return std::string(digits.size() < 8 ? 8 - digits.size() : 0, '0') + digits;
}

/// What is heard and felt, as the live view shows it. Null after an error, which is printed in one line.
std::unique_ptr<game::Senses> senses_of(const game::MatchData& data, const std::filesystem::path& assets) {
    auto loaded = game::SenseData::load(assets, audio::WithSamples::no);
    if (loaded) return game::Senses::create(*loaded, *data.presentation);
    tell_user(text("pictures show nothing that is heard or felt: ", loaded.error().message));
    return nullptr;
}

/// The HUD of a player who has changed no setting.
game::HudSettings hud_of(const game::Playback& playback) {
    const PlayerSettings usual;
    return {.names = recorded_names(playback.log().header()), .heard = {usual.heard, usual.heard}};
}

}  // namespace

bool ShotPlan::any() const {
    return every != 0 || !at.empty() || on_marks || std::find(on.begin(), on.end(), true) != on.end();
}

Expected<Shots> Shots::create(ShotPlan plan, const game::MatchData& data,
                              const std::filesystem::path& assets) {
    if (auto made = make_folder(plan.folder); !made) return made.error();
    if (auto free = check_output(plan.folder / "shot_00000000.png"); !free) return free.error();
    auto still = Still::create(data, assets, plan.size);
    if (!still) return still.error();
    return Shots(std::move(plan), std::move(*still), senses_of(data, assets));
}

/// Suffix of the due picture's file name; std::nullopt if no picture is due.
std::optional<std::string> Shots::due(const game::Playback& playback) {
    const auto& match = playback.match();
    const auto now = match.now();
    std::optional<std::string> what;
    if (plan_.every != 0 && now % plan_.every == 0) what = "";
    for (; next_at_ < plan_.at.size() && plan_.at[next_at_] <= now; ++next_at_) what = "";
    match.events().each_new(seen_, [&](const game::Event& event) {
        const auto kind = static_cast<std::size_t>(event.kind);
        if (plan_.on[kind]) what = text("_", game::name_of(event.kind));
    });
    const auto& marks = playback.log().marks();
    for (; next_mark_ < marks.size() && marks[next_mark_].tick <= now; ++next_mark_) {
        if (plan_.on_marks && marks[next_mark_].kind == input::MarkKind::user)
            what = text("_mark_", marks[next_mark_].number);
    }
    return what;
}

Expected<void> Shots::follow(const game::Playback& playback) {
    const auto& match = playback.match();
    if (senses_) senses_->follow(match);
    const auto what = due(playback);
    if (!what) return {};
    ++taken_;
    unconfirmed_.push_back(plan_.folder / text("shot_", padded(match.now()), *what, ".png"));
    return still_.save(match, hud_of(playback), unconfirmed_.back(), senses_.get());
}

void Shots::remove_unconfirmed() {
    std::error_code ignored;
    for (const auto& picture : unconfirmed_) std::filesystem::remove(picture, ignored);
    unconfirmed_.clear();
}

namespace {

constexpr std::string_view shots_help =
    R"(usage: thaum shots LOG --out DIR

Makes the README's pictures from a recorded match; needs no display.

  --out DIR   folder for duel.png, which replaces an older one: the moment at which the two
              wizards were closest while player 1 saw the other and something flew
)";

/// Plays the replay to its end and returns its highlight.
Highlight find_highlight(game::Playback& playback) {
    Highlight best;
    while (playback.step()) watch_for_highlight(playback.match(), best);
    return best;
}

int run_shots(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--out", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto out = arguments->value("--out");
    if (arguments->plain().size() != 1 || !out)
        return refuse({"shots needs one log and --out; see `thaum shots --help`"});
    const auto& log = arguments->plain()[0];
    const auto file = std::filesystem::path(*out) / "duel.png";
    if (const auto made = make_folder(*out); !made) return refuse(made.error());
    if (const auto free = check_output(file); !free) return refuse(free.error());
    auto playback = game::Playback::open(log, game::find_assets());
    if (!playback) return refuse(playback.error());
    const Highlight best = find_highlight(*playback);
    if (playback->divergence()) {
        refuse({text(log, ": ", game::described(*playback->divergence()))});
        return does_not_hold;
    }
    if (best.tick == 0)
        return refuse({text(log, ": the two wizards never meet in this log; take a longer match")});
    playback = game::Playback::open(log, game::find_assets());
    if (!playback) return refuse(playback.error());
    const auto& match = playback->match();
    const auto senses = senses_of(match.data(), game::find_assets());
    while (match.now() < best.tick) {
        if (!playback->step())
            return refuse({text(log, ": the file changed while it was read; start again")});
        if (senses) senses->follow(match);
    }
    auto still = Still::create(match.data(), game::find_assets(), {1280, 720});
    if (!still) return refuse(still.error());
    if (const auto saved = still->save(match, hud_of(*playback), file, senses.get()); !saved)
        return refuse(saved.error());
    print_line(text("tick ", best.tick, " in ", file.string()));
    return done;
}

}  // namespace

Command shots_command() { return {"shots", shots_help, run_shots}; }

}  // namespace thaum::app
