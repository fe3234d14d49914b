#include "game/scenario/force_trace.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "core/hash.h"
#include "core/text.h"
#include "physics/bullet_maths.h"

namespace thaum::game::inline scenario {
namespace {

constexpr std::uint64_t block_ticks = 128;
constexpr int decimals = 4;

std::vector<std::string> lines_of(const std::string& file) {
    std::vector<std::string> lines;
    std::istringstream in(file);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Returns the value that follows `key` in the first line.
std::string told(const std::string& first, std::string_view key) {
    const auto at = first.find(key);
    if (at == std::string::npos) return {};
    const auto from = at + key.size();
    return first.substr(from, first.find_first_of(", ", from) - from);
}

}  // namespace

void ForceRecord::add(Tick now, std::span<const vec3, players> forces) {
    for (std::size_t player = 0; player < players; ++player) {
        const vec3 force = forces[player];
        sums_[player].peak = std::max(sums_[player].peak, glm::length(force));
        sums_[player].sum += force;
        const auto bytes = std::as_bytes(std::span(&force, 1));
        hash_ = hash_bytes(bytes, hash_);
        block_hash_ = hash_bytes(bytes, block_hash_);
    }
    now_ = now;
    if (++ticks_ % block_ticks == 0) end_block();
}

void ForceRecord::end_block() {
    const auto count = (ticks_ - 1) % block_ticks + 1;
    const bool felt = std::any_of(sums_.begin(), sums_.end(), [](const Sums& s) { return s.peak > 0; });
    if (felt) {
        append_text(rows_, text(now_ - count));
        for (const auto& [peak, sum] : sums_) {
            const vec3 mean = sum / static_cast<double>(count);
            append_text(rows_, text(",", fixed(peak, decimals), ",", fixed(mean.x, decimals), ",",
                                    fixed(mean.y, decimals), ",", fixed(mean.z, decimals)));
        }
        append_text(rows_, text(",", hex(block_hash_).substr(0, 8), "\n"));
    }
    sums_ = {};
    block_hash_ = 0;
}

std::string ForceRecord::file(std::uint32_t rules) {
    if (ticks_ % block_ticks != 0) end_block();
    return text("# thaum forces, rules ", rules, ", maths ", hex(physics::maths_probe()), ", ", ticks_,
                " ticks, hash ", hex(hash_),
                "\nfrom_tick,p1_peak_n,p1_x_n,p1_y_n,p1_z_n,p2_peak_n,p2_x_n,p2_y_n,p2_z_n,hash\n", rows_);
}

std::string difference_of_forces(const std::string& kept, const std::string& now) {
    if (kept == now) return {};
    const auto a = lines_of(kept), b = lines_of(now);
    if (a.empty()) return "the kept force trace is empty";
    const auto rules = told(a[0], "rules ");
    if (rules != told(b[0], "rules "))
        return text("the kept force trace is of rules version ", rules, ", this program plays ",
                    told(b[0], "rules "));
    if (told(a[0], "maths ") != told(b[0], "maths "))
        return text("the kept force trace was made with other elementary functions: probe ",
                    told(a[0], "maths "), ", here ", told(b[0], "maths "));
    for (std::size_t i = 1; i < std::min(a.size(), b.size()); ++i)
        if (a[i] != b[i]) return text("forces differ: kept ", a[i], ", now ", b[i]);
    return text("forces differ: kept ", a[0], ", now ", b[0]);
}

}  // namespace thaum::game::inline scenario
