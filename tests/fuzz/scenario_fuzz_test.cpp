// Mutated scenarios, always the same ones: each must end with a result, never with a crash, an assertion or a hang.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/file.h"
#include "core/random.h"
#include "game/scenario/runner.h"

namespace thaum::game {
namespace {

/// What stands between two blanks; replaced as a whole, so that many mutants still compile.
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

std::string mutated(const std::vector<std::string>& tokens, const std::vector<std::string>& known,
                    Random& random) {
    auto changed = tokens;
    for (auto n = 1 + random.below(4); n > 0; --n) {
        const auto at = changed.begin() + static_cast<std::ptrdiff_t>(random.below(changed.size()));
        const auto how = random.below(8);
        if (how < 5) *at = random_token(known, random);
        if (how == 5) changed.insert(at, random_token(known, random));
        if (how == 6 && changed.size() > 2) changed.erase(at);
        if (how == 7 && !at->empty()) (*at)[random.below(at->size())] = static_cast<char>(random.next());
    }
    std::string source;
    for (const auto& token : changed) source += token;
    return source;
}

struct Corpus {
    std::vector<std::vector<std::string>> scripts;
    std::vector<std::string> known;
};

Corpus load_corpus(const ScenarioOptions& options) {
    Corpus corpus;
    const auto scripts = find_scenarios({}, options).value();
    for (const auto& path : scripts) {
        corpus.scripts.push_back(tokens_of(read_text_file(path, 1U << 20U).value()));
        const auto& tokens = corpus.scripts.back();
        corpus.known.insert(corpus.known.end(), tokens.begin(), tokens.end());
    }
    return corpus;
}

TEST(ScenarioFuzz, FiveThousandMutants) {
    ScenarioOptions options;
    options.assets = std::filesystem::path(THAUM_SOURCE_DIR) / "assets";
    options.scripts = scenarios_beside(options.assets);
    options.most_ticks = 40;
    options.limits = {.memory = 16U << 20U, .steps = 300'000, .output = 1000};
    const auto corpus = load_corpus(options);
    Random random = random_stream(20240601, 0);
    int played = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto& tokens = corpus.scripts[static_cast<std::size_t>(i) % corpus.scripts.size()];
        const auto source = mutated(tokens, corpus.known, random);
        const auto result = run_scenario_source(source, "mutant", options);
        EXPECT_TRUE(result.passed || !result.message.empty()) << source;
        EXPECT_LE(result.ticks, options.most_ticks);
        EXPECT_EQ(result.message.find("different states"), std::string::npos) << source << result.message;
        played += result.ticks > 0 ? 1 : 0;
    }
    EXPECT_GT(played, 500) << "too few mutants reach the match";
}

}  // namespace
}  // namespace thaum::game
