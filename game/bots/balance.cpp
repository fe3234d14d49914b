#include "game/bots/balance.h"

#include <algorithm>

#include "game/components/wizard.h"
#include "game/data/event_kinds.h"

namespace thaum::game::inline bots {

bool BalanceCounter::use(std::uint32_t player, Magic source) {
    if (player >= players) return false;
    return count_.used[player][static_cast<std::size_t>(source)] = true;
}

void BalanceCounter::note(const Event& event) {
    if (event.kind == EventKind::round_begin) {
        *this = {};
        last_kill_ = event.tick;
    }
    if (event.subject >= players) return;
    Enchantment& own = acting_[event.subject];
    switch (event.kind) {
        case EventKind::death: return note_death(event);
        case EventKind::cast: own.spell_until = event.tick + spell_acts; return;
        case EventKind::held_off: use(event.subject, Magic::spells); return;
        case EventKind::pushed:
            own.pushed_until = event.tick + push_acts;
            use(event.by, Magic::spells);
            return;
        case EventKind::boon: use(event.subject, Magic::pot); return;
        case EventKind::potion:
            own.potion_until = std::max(own.potion_until, event.tick + ticks(event.amount));
            return;
        case EventKind::scried:
            if (event.amount > 0) use(event.subject, Magic::orb);
            return;
        case EventKind::lens: own.lens = true; return;
        case EventKind::lens_lost: own.lens = false; return;
        default:
            if (!info_of(event.kind).cause.empty()) note_blow(event);
    }
}

void BalanceCounter::note_blow(const Event& blow) {
    const bool from_pot = blow.kind == EventKind::poison || blow.kind == EventKind::spoilt;
    bool magic = false;
    const Enchantment& victim = acting_[blow.subject];
    if (blow.tick < victim.potion_until) use(blow.subject, Magic::pot);
    // A fall is nobody's blow, but after a push it is the pusher's.
    const auto by = blow.by >= players && blow.tick < victim.pushed_until ? 1 - blow.subject : blow.by;
    if (by < players && by != blow.subject) {
        const Enchantment& striker = acting_[by];
        if (from_pot || blow.tick < striker.potion_until) magic = use(by, Magic::pot);
        if (blow.tick < std::max(striker.spell_until, victim.pushed_until)) magic = use(by, Magic::spells);
        if (striker.lens) magic = use(by, Magic::crystal);
    }
    auto& harms = harms_[blow.subject];
    harms.push_back({blow.amount, magic});
    // Only the newest blows that make up the judged health are needed.
    double points = 0;
    auto first = harms.end();
    while (first != harms.begin() && points < judged_health) points += (--first)->points;
    harms.erase(harms.begin(), first);
}

void BalanceCounter::note_death(const Event& death) {
    auto& harms = harms_[death.subject];
    double left = judged_health, by_magic = 0;
    for (auto harm = harms.rbegin(); harm != harms.rend(); ++harm) {
        const double points = std::min(left, harm->points);
        left -= points;
        if (harm->magic) by_magic += points;
    }
    const bool magic = by_magic > 0 && 2 * by_magic >= judged_health - left;
    harms.clear();
    acting_[death.subject] = {};
    if (death.by < players && death.by != death.subject) {
        count_.kills.push_back({death.tick - last_kill_, magic});
        last_kill_ = death.tick;
        ++score_[death.by];
    } else {
        --score_[death.subject];
    }
    if (score_[0] == score_[1]) return;
    const std::uint32_t ahead_now = score_[0] > score_[1] ? 0 : 1;
    if (leader_ != no_player && leader_ != ahead_now) ++count_.lead_changes;
    leader_ = ahead_now;
}

}  // namespace thaum::game::inline bots
