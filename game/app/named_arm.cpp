#include "game/app/named_arm.h"

#include <optional>

#include "core/text.h"

namespace thaum::game::inline app {

Expected<std::unique_ptr<input::OpenArm>> open_named_arm(std::string_view option, const std::string& name) {
    std::string found;
    std::optional<Error> first;
    const auto places = input::arm_places();
    for (std::size_t i = 0; i < places.size(); ++i) {
        auto arm = input::open_arm(places[i]);
        if (!arm && !first) first = arm.error();
        if (!arm) continue;
        const auto& facts = (*arm)->facts();
        if (name == text("arm:", i) || input::is_called(facts, name)) return arm;
        found += text(found.empty() ? "" : ", ", input::name_of(facts), " (or: arm:", i,
                      facts.family.empty() ? "" : ", ", facts.family, ")");
    }
    if (found.empty() && first) return fail(text(option, " ", name, ": ", first->message));
    return fail(text(option, " '", name, "': this device was not found; found ",
                     found.empty() ? "no device" : found));
}

}  // namespace thaum::game::inline app
