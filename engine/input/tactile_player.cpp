#include "input/tactile_player.h"

#include <utility>

namespace thaum::input {

bool TactilePlayer::feel(const tactile::TactileFrame& frame) { return thread_.work().feel(frame); }
void TactilePlayer::try_out(const tactile::TactileFrame& frame) { thread_.work().try_out(frame); }
void TactilePlayer::use(std::unique_ptr<TactileOutput> output) { thread_.work().use(std::move(output)); }
std::string TactilePlayer::status() const {
    return thread_.refused().empty() ? thread_.work().status() : thread_.refused();
}
TactileReport TactilePlayer::report() const { return thread_.work().report(); }
bool TactilePlayer::is_open() const { return thread_.work().is_open(); }

}  // namespace thaum::input
