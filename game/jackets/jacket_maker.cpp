#include "game/jackets/jacket_maker.h"

#include <algorithm>
#include <tuple>

#include "core/text.h"

namespace thaum::game::inline jackets {
namespace {

std::vector<JacketMaker>& registered() {
    static std::vector<JacketMaker> all;  // made at the first use, because registrations run in any order
    return all;
}

}  // namespace

JacketRegistration::JacketRegistration(const JacketMaker& maker) {
    auto& all = registered();
    // The linker chooses the order of registrations, so the list is sorted to be independent of it.
    const auto after = std::ranges::find_if(all, [&](const JacketMaker& other) {
        return std::tie(maker.order, maker.name) < std::tie(other.order, other.name);
    });
    all.insert(after, maker);
}

const std::vector<JacketMaker>& jacket_makers() { return registered(); }

JacketCheck check_by_opening(const Jacket&, input::TactileOutput& output) {
    if (const auto opened = output.open(); !opened)
        return {false, text(": ", opened.error().message), "it is looked for every two seconds in a session"};
    output.close();
    return {true, " can be used", ""};
}

}  // namespace thaum::game::inline jackets
