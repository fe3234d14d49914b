#include "game/match/record.h"

#include "core/one_line.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/match/kind_tables.h"
#include "game/match/own_gestures.h"
#include "physics/bullet_build.h"
#include "physics/bullet_maths.h"

namespace thaum::game::inline match {
namespace {

constexpr std::string_view match_parameter = "match=";
/// A mutator by name, for people: what it changed stands in the header's overrides.
constexpr std::string_view mutator_parameter = "mutator=";

/// Data file that affects how a crystal feels. Older recordings do not list it, so its absence there is no
/// difference.
constexpr std::string_view joined_later = "materials.toml";

/// First difference between the data files of a recording and the present ones, as one line; empty if there
/// is none.
std::string changed_file(const std::vector<input::DataFile>& recorded,
                         const std::vector<input::DataFile>& here) {
    for (const auto& file : recorded) {
        const auto same_name =
            std::find_if(here.begin(), here.end(), [&](const auto& f) { return f.name == file.name; });
        if (same_name == here.end()) return text("data file ", file.name, " is not part of this version");
        if (same_name->hash != file.hash)
            return text("data file ", file.name, " has changed since the recording");
    }
    for (const auto& file : here) {
        const auto known =
            std::any_of(recorded.begin(), recorded.end(), [&](const auto& f) { return f.name == file.name; });
        if (!known && file.name != joined_later)
            return text("data file ", file.name, " did not exist when this was recorded");
    }
    return {};
}

std::vector<std::string> names_of(const std::vector<input::DataFile>& files) {
    std::vector<std::string> names;
    for (const auto& file : files) names.push_back(file.name);
    return names;
}

}  // namespace

input::LogHeader log_header(const MatchData& data, const MatchSetup& setup,
                            std::vector<std::string> players) {
    input::LogHeader header;
    header.program = THAUM_VERSION;
    header.rules_version = rules_version;
    header.rule_set = data.choice.rules;
    header.arena = data.choice.arena;
    header.seed = setup.seed;
    header.maths_probe = physics::maths_probe();
    auto bullet = physics::bullet_build();
    header.physics_library = std::move(bullet.library);
    header.physics_precision = std::move(bullet.precision);
    header.players = std::move(players);
    header.devices = setup.devices;
    header.files = data.files;
    header.overrides = data.overrides;
    header.parameters = {text(match_parameter, data.choice.match)};
    for (const auto& name : data.choice.mutators) header.parameters.push_back(text(mutator_parameter, name));
    header.kinds = kind_tables(data);
    header.profile = setup.profile;
    return header;
}

void record_tick(const Simulation& match, const input::InputFrame& frame, input::LogWriter& log) {
    log.append(frame);
    if (match.now() % hash_interval == 0)
        log.append_hash(match.now(), match.state_hash(), match.force_hash());
    if (match.now() % keyframe_interval == 0) {
        log.mark(static_cast<std::uint32_t>(match.now() / keyframe_interval), input::MarkKind::keyframe);
    }
}

void tick_and_record(Simulation& match, const input::InputFrame& frame, input::LogWriter* log) {
    match.tick(frame);
    if (log != nullptr) record_tick(match, frame, *log);
}

Expected<void> close_log(input::LogWriter& log, const Simulation& match) {
    return log.close(result_line(match),
                     input::HashRecord{match.now(), match.state_hash(), match.force_hash()});
}

std::string result_line(const Simulation& match, const std::array<std::string, players>& winner_names) {
    std::array<std::int32_t, players> kills{};
    match.world().view<const Wizard, const Score>().each(
        [&](const Wizard& wizard, const Score& score) { kills[wizard.player] = score.kills; });
    const auto& state = match.match();
    std::string score = text(kills[0], " : ", kills[1]);
    if (match.data().round.rounds > 1)
        score += text(", rounds ", state.rounds_won[0], " : ", state.rounds_won[1]);
    const auto time = fixed(seconds(state.played), 1);
    if (state.phase != Phase::over) return text("stopped after ", time, " s, score ", score);
    const auto how = state.ending == Ending::kills        ? "by kills"
                     : state.ending == Ending::great_work ? "by the Great Work"
                     : state.ending == Ending::boil_over  ? "in the Boil-over"
                                                          : "on time";
    const auto winner = ahead(state);
    if (winner == no_player) return text("a draw ", how, ", score ", score, ", after ", time, " s");
    const auto& name = winner_names[winner];
    return text(name.empty() ? text("player ", winner + 1) : name, " wins ", how, ", score ", score,
                ", after ", time, " s");
}

Expected<std::unique_ptr<Simulation>> match_of_log(const input::LogHeader& header,
                                                   const std::filesystem::path& assets) {
    if (header.rules_version != rules_version) {
        return fail(text("recorded under rules version ", header.rules_version,
                         ", this program plays version ", rules_version,
                         "; it replays only in a build of Thaum whose rules version is ",
                         header.rules_version));
    }
    DataChoice choice;
    choice.rules = header.rule_set;
    choice.arena = header.arena;
    choice.overrides = header.overrides;
    choice.files = names_of(header.files);
    for (const auto& parameter : header.parameters) {
        if (parameter.starts_with(mutator_parameter)) continue;
        if (!parameter.starts_with(match_parameter)) return fail(text("unknown parameter '", parameter, "'"));
        choice.match = parameter.substr(match_parameter.size());
    }
    auto data = load_match_data(assets, choice);
    if (!data) return data.error();
    if (const auto changed = changed_file(header.files, data->files); !changed.empty()) return fail(changed);
    // Logs of format 1 have no tables of kinds. Their kinds were registered in the same way, so comparing
    // data files is enough.
    if (!header.kinds.empty()) {
        if (const auto other = kind_difference(header.kinds, kind_tables(*data)); !other.empty())
            return fail(other);
    }
    // A thread of its own computes the brew while the ticks go on.
    MatchSetup setup{.seed = header.seed, .devices = header.devices, .workers = processors() > 1 ? 1U : 0U};
    if (auto used = use_profile(*data, header.profile, setup); !used) return used.error();
    return std::make_unique<Simulation>(std::make_shared<const MatchData>(std::move(*data)),
                                        std::move(setup));
}

std::string build_warning(const input::LogHeader& header) {
    if (header.maths_probe != physics::maths_probe())
        return "recorded by a program whose elementary functions compute other bits: the replay may differ";
    const auto here = physics::bullet_build();
    const bool same = header.physics_library == here.library && header.physics_precision == here.precision;
    if (same || header.physics_library.empty()) return {};
    return text("recorded with ", in_one_line(header.physics_library), " (",
                in_one_line(header.physics_precision), "), this program has ", here.library, " (",
                here.precision, "): the replay may differ");
}

}  // namespace thaum::game::inline match
