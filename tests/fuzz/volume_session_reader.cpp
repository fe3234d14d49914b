// Fuzzes the reader of saved sessions of the volume lab (scans to feel and carve). An accepted session, when
// written, must be readable again.
#include "fuzz/fuzz.h"
#include "game/lab/volume_session.h"

namespace thaum::fuzz {
namespace {

std::vector<std::string> sessions(const Places&) {
    game::VolumeSession session, plain;
    session.first.volume = "sphere";
    session.beside.resize(1);
    session.beside[0].volume = "vortices";
    plain.first.volume = "head.nrrd";
    session.opacity = field::window(0, 255, 0, 0.3);
    session.modes = {{.name = "isosurface", .filters = {{field::FilterKind::smooth, 1}}},
                     {.name = "viscosity"}};
    session.feel = {{game::FeelKind::wall, {500, 0.8, 0.2}}, {game::FeelKind::shell, {0, 100, 1, 1}}};
    for (auto& mode : session.modes) mode.settings.strength = mode.settings.friction = field::constant(1);
    return {game::session_text(session), game::session_text(plain)};
}

Outcome read_saved_session(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "session.toml", 1);
    if (!config) return {.refusal = config.error().message};
    const auto session = game::read_session(*config);
    if (!session) return {.refusal = session.error().message};
    const auto again = Config::parse(game::session_text(*session), "session.toml", 1);
    if (!again || !game::read_session(*again)) return {.accepted = true, .fault = "it cannot be read again"};
    return {.accepted = true};
}

}  // namespace

const Reader volume_session_reader{"session", sessions, mutate_text, read_saved_session};

}  // namespace thaum::fuzz
