// Arenas, rules and wands that went wrong: thousands of small corruptions of the shipped files. Each is refused with one line,
// or makes a match that runs; nothing crashes or hangs.
#include "core/file.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

/// One random slip of the keyboard.
std::string slipped(std::string text, Random& random) {
    static constexpr std::string_view keys = "0123456789.-[]\"=\n#eE_+xinfa{},";
    const auto at = static_cast<std::size_t>(random.below(text.size()));
    const char key = keys[static_cast<std::size_t>(random.below(keys.size()))];
    switch (random.below(4)) {
        case 0: text[at] = key; break;
        case 1: text.insert(at, 1, key); break;
        case 2: text.erase(at, 1 + static_cast<std::size_t>(random.below(20))); break;
        default: text.insert(at, text.substr(at, static_cast<std::size_t>(random.below(200))));
    }
    return text;
}

TEST(ArenaFuzz, EverySlipIsRefusedInOneLineOrMakesAMatchThatRuns) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "thaum_arena_fuzz";
    std::filesystem::remove_all(folder);
    std::filesystem::copy(assets(), folder, std::filesystem::copy_options::recursive);
    Random random{2026};
    int refused = 0, played = 0;
    for (const auto* name :
         {"arenas/boiling_court.toml", "rules/quick.toml", "rules/thaum.toml", "wizards/wizard.toml", "wands/bolt.toml"}) {
        const auto original = read_text_file(folder / name, 1U << 20U).value();
        for (int i = 0; i < 400; ++i) {
            auto text = original;
            for (auto slips = 1 + random.below(3); slips > 0; --slips)
                text = slipped(std::move(text), random);
            ASSERT_TRUE(write_text_file(folder / name, text).has_value());
            auto data = load_match_data(folder, {});
            if (!data) {
                ++refused;
                ASSERT_FALSE(data.error().message.empty());
                ASSERT_EQ(data.error().message.find('\n'), std::string::npos) << data.error().message;
                continue;
            }
            ++played;
            Simulation match(std::make_shared<const MatchData>(std::move(*data)),
                             {1, {bot_device(0, 1), bot_device(1, 1)}});
            input::InputFrame frame;
            for (auto& device : frame.devices) device.counts[input::hand::forward] = 127;
            for (auto& device : frame.devices) device.press(input::Button::fire);
            for (Tick t = 0; t < 40; ++t) match.tick(frame);
        }
        ASSERT_TRUE(write_text_file(folder / name, original).has_value());
    }
    EXPECT_GT(refused, 300);
    EXPECT_GT(played, 100);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace thaum::game::test
