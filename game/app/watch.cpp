#include "game/app/watch.h"

#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/still.h"

namespace thaum::app {

int watch(game::Playback playback, const std::filesystem::path& out) {
    const auto& match = playback.match();
    std::error_code failed;
    std::filesystem::create_directories(out, failed);
    if (failed) return refuse({text(out.string(), ": cannot create: ", failed.message())});
    auto still = Still::create(match.data(), game::find_assets(), {1280, 720});
    if (!still) return refuse(still.error());
    const auto stem = text("replay_", match.now());
    if (const auto saved = still->save(match, {}, out / (stem + ".png")); !saved)
        return refuse(saved.error());
    Bytes state;
    match.save(state);
    if (const auto saved = write_file(out / (stem + ".dump"), state); !saved) return refuse(saved.error());
    std::printf("no display: tick %llu, state %s, in %s\n", static_cast<unsigned long long>(match.now()),
                hex(match.state_hash()).c_str(), (out / stem).string().c_str());
    return done;
}

}  // namespace thaum::app
