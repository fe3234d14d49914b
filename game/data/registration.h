// game/data/registration.h: functions that a kind of wand or spell registers (data/wand.h, data/spell.h),
// and the choice of a kind by a data file.
#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/config.h"
#include "core/near_name.h"
#include "core/text.h"
#include "ecs/world.h"

namespace thaum::game::inline data {

/// Declares to the World the components that a kind of wand or spell needs, in this order.
template <class... Components>
void declare_all(ecs::World& world) {
    (world.declare<Components>(), ...);
}

/// Makes the rules of a wand or spell from the root table of its data file. `number`: slot of the wand, or
/// number of the spell. Rules whose state in the World outlasts a use store it there, since several files may
/// share a kind.
template <class Rules, class OfKind>
std::shared_ptr<const Rules> read_rules(const ConfigTable& root, std::uint32_t number) {
    if constexpr (std::is_constructible_v<OfKind, const ConfigTable&, std::uint32_t>)
        return std::make_shared<OfKind>(root, number);
    else
        return std::make_shared<OfKind>(root);
}

/// The kind that a wand's or spell's file names by its key `kind`; by default, the kind that has the file's
/// own name. Null after a report if there is no such kind. `what`: the noun "wand" or "spell".
template <class Kind>
const Kind* kind_of_file(const std::vector<Kind>& kinds, const ConfigTable& root, const std::string& name,
                         std::string_view what) {
    const auto wanted = root.string("kind", name);
    if (wanted != name && std::ranges::find(kinds, name, &Kind::name) != kinds.end())
        root.report("kind", text("'kind' is '", wanted, "', but the file has the name of another kind"));
    std::string all;
    for (const auto& kind : kinds) {
        if (kind.name == wanted) return &kind;
        all += text(all.empty() ? "" : ", ", kind.name);
    }
    root.report("kind", text("'kind' is '", wanted, "', which is no kind of ", what,
                             did_you_mean(wanted, kinds, &Kind::name), "; there are ", all));
    return nullptr;
}

}  // namespace thaum::game::inline data
