#include "game/app/shots.h"

#include <algorithm>

#include "core/file.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/match/tables.h"
#include "game/settings/recorded_names.h"
#include "game/settings/settings.h"

namespace thaum::game::inline app {
namespace {

/// The tick with leading zeros to eight digits, so that file names sort by time. Ten hours need eight digits.
std::string padded(Tick tick) {
    const auto digits = text(tick);
    return std::string(digits.size() < 8 ? 8 - digits.size() : 0, '0') + digits;
}

}  // namespace

std::unique_ptr<Senses> senses_of(const MatchData& data, const std::filesystem::path& assets) {
    auto loaded = SenseData::load(assets, audio::WithSamples::no);
    if (loaded) return Senses::create(*loaded, *data.presentation);
    tell_user(text("pictures show nothing that is heard or felt: ", loaded.error().message));
    return nullptr;
}

HudSettings hud_of(const Playback& playback) {
    const PlayerSettings usual;
    return {.names = recorded_names(playback.log().header()), .heard = {usual.heard, usual.heard}};
}

bool ShotPlan::any() const {
    return every != 0 || !at.empty() || on_marks || std::find(on.begin(), on.end(), true) != on.end();
}

Expected<Shots> Shots::create(ShotPlan plan, const MatchData& data, const std::filesystem::path& assets) {
    if (auto made = make_folder(plan.folder); !made) return made.error();
    if (auto free = check_output(plan.folder / "shot_00000000.png"); !free) return free.error();
    auto still = Still::create(data, assets, plan.size);
    if (!still) return still.error();
    return Shots(std::move(plan), std::move(*still), senses_of(data, assets));
}

/// Ending of the file name for a picture that is due now; std::nullopt if none is due.
std::optional<std::string> Shots::due(const Playback& playback) {
    const auto& match = playback.match();
    const auto now = match.now();
    std::optional<std::string> what;
    if (plan_.every != 0 && now % plan_.every == 0) what = "";
    for (; next_at_ < plan_.at.size() && plan_.at[next_at_] <= now; ++next_at_) what = "";
    match.events().each_new(seen_, [&](const Event& event) {
        const auto kind = static_cast<std::size_t>(event.kind);
        if (plan_.on[kind]) what = text("_", name_of(event.kind));
    });
    const auto& marks = playback.log().marks();
    for (; next_mark_ < marks.size() && marks[next_mark_].tick <= now; ++next_mark_) {
        if (plan_.on_marks && marks[next_mark_].kind == input::MarkKind::user)
            what = text("_mark_", marks[next_mark_].number);
    }
    return what;
}

Expected<void> Shots::follow(const Playback& playback) {
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

}  // namespace thaum::game::inline app
