// Fuzzes the reader of scenarios. Mutations change whole tokens, so many mutants still compile and start a
// match.
#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "fuzz/fuzz.h"
#include "game/scenario/runner.h"

namespace thaum::fuzz {
namespace {

std::vector<std::string> tokens_of(const std::string& source) {
    std::vector<std::string> tokens{""};
    const auto kind = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    for (const char c : source) {
        if (!tokens.back().empty() && (!kind(c) || !kind(tokens.back().back()))) tokens.emplace_back();
        tokens.back() += c;
    }
    return tokens;
}

std::string random_token(const std::vector<std::string>& known, Random& random) {
    static const char* const striking[] = {
        "nil", "0",  "-1",     "1e308", "(0/0)",      "{}",    "\"\"",   "math.huge",  "true",
        "1e5", "2",  "wizard", "spawn", "match",      "place", "1e-300", "0x7fffffff", "'x'",
        "end", "()", "(-1)",   "{1,2}", "{0,-500,0}", "\xff",  "\\",     "--[[",       "^"};
    if (random.below(2) == 0) return striking[random.below(std::size(striking))];
    return known[random.below(known.size())];
}

std::string mutate_tokens(const std::vector<std::string>& seeds, Random& random) {
    auto tokens = tokens_of(seeds[random.below(seeds.size())]);
    const auto known = tokens_of(seeds[random.below(seeds.size())]);
    for (auto n = 1 + random.below(4); n > 0; --n) {
        const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(random.below(tokens.size()));
        const auto how = random.below(8);
        if (how < 5) *at = random_token(known, random);
        if (how == 5) tokens.insert(at, random_token(known, random));
        if (how == 6 && tokens.size() > 2) tokens.erase(at);
        if (how == 7 && !at->empty()) (*at)[random.below(at->size())] = static_cast<char>(random.next());
    }
    std::string source;
    for (const auto& token : tokens) source += token;
    return source;
}

std::string mutate_script(const std::vector<std::string>& seeds, Random& random) {
    return random.below(4) == 0 ? mutate_text(seeds, random) : mutate_tokens(seeds, random);
}

game::ScenarioOptions options_of(const Places& places) {
    game::ScenarioOptions options;
    options.assets = places.assets;
    options.scripts = std::filesystem::path(THAUM_SOURCE_DIR) / "tests/scenarios";
    options.max_ticks = 40;
    options.limits = {.memory = 16U << 20U, .steps = 300'000, .output = 1000};
    return options;
}

std::vector<std::string> scripts(const Places& places) {
    std::vector<std::string> sources;
    const auto found = game::find_scenarios({}, options_of(places));
    for (const auto& path : found.value_or(std::vector<std::filesystem::path>{})) {
        if (auto source = read_text_file(path, 1U << 20U)) sources.push_back(std::move(*source));
    }
    return sources;
}

/// Runs a mutated script. It counts as accepted if it started a match.
Outcome read_script(const std::string& input, const Places& places) {
    const auto options = options_of(places);
    const auto result = game::run_scenario_source(input, "mutant", options);
    Outcome outcome{.accepted = result.ticks > 0, .refusal = result.message};
    if (result.ticks > options.max_ticks) outcome.fault = "played beyond the limit";
    if (result.message.find("different states") != std::string::npos) outcome.fault = result.message;
    if (!result.passed && result.message.empty()) outcome.fault = "failed without a message";
    return outcome;
}

}  // namespace

const Reader scenario_reader{"scenario", scripts, mutate_script, read_script};

}  // namespace thaum::fuzz
