// Adds a kind of event by this source file, which records it, and a row of events.toml, without a change of
// the game's files.
#include <gtest/gtest.h>

#include "game/data/event_kinds.h"
#include "game/match/kind_tables.h"
#include "seams/assets.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

const EventRegistration sneeze({.name = "sneeze",
                                .cause = "pepper",
                                .with = EventWith::own_name,
                                .unit = "hp",
                                .placed = true,
                                .has_subject = true});
const EventRegistration cough({.name = "cough", .cause = {}, .placed = true});

constexpr std::string_view rows = R"(
[sneeze]
mark = "hit"
feed = "{whom} sneezed"
[cough]
)";

const std::filesystem::path& with_rows() {
    static SeamAssets assets;
    static const bool added = (assets.append(".", "events.toml", rows), true);
    EXPECT_TRUE(added);
    return assets.path();
}

TEST(NewEvent, HasANumberByItsNameAndChangesNoOther) {
    const auto& all = event_kinds();
    EXPECT_EQ(all.fault, "");
    constexpr auto last = static_cast<std::uint32_t>(EventKind::tool_taken);
    EXPECT_EQ(static_cast<std::uint32_t>(cough.kind()), last + 1);
    EXPECT_EQ(static_cast<std::uint32_t>(sneeze.kind()), last + 2);
    EXPECT_EQ(event_kind("sneeze"), sneeze.kind());
    const auto without = number_event_kinds(all.hits);
    ASSERT_EQ(without.kinds.size(), last + 1);
    for (std::size_t i = 0; i < without.kinds.size(); ++i)
        EXPECT_EQ(without.kinds[i].name, all.kinds[i].name) << i;
    EXPECT_EQ(cause_of(cough.kind()), max_causes);
    EXPECT_EQ(cause_of(sneeze.kind()), without.causes.size());
    EXPECT_EQ(causes()[cause_of(sneeze.kind())], "pepper");
}

TEST(NewEvent, IsRecordedCountedAndShownAsAnyOther) {
    auto data = load_match_data(with_rows(), {});
    ASSERT_TRUE(data) << data.error().message;
    EXPECT_EQ(row_of(data->presentation->events, sneeze.kind()).feed, "{whom} sneezed");
    const auto tables = kind_tables(*data);
    const auto events = std::ranges::find(tables, "event", &input::KindTable::group);
    EXPECT_NE(std::ranges::find(events->kinds, "sneeze", &input::Kind::name), events->kinds.end())
        << "a log's header has it";
    Simulation match(std::make_shared<const MatchData>(std::move(*data)), two_hands());
    match.tick({});
    auto& context = match.context_to_change();
    hurt(context, wizard_of(match.world(), 1), 1, {.points = 5, .by = 0, .how = sneeze.kind()});
    record(context, {.tick = 1, .kind = cough.kind(), .by = 1});
    std::vector<std::string_view> names;
    std::uint64_t seen = 0;
    match.events().each_new(seen, [&](const Event& event) { names.push_back(name_of(event.kind)); });
    EXPECT_NE(std::ranges::find(names, "sneeze"), names.end());
    EXPECT_EQ(names.back(), "cough");
    EXPECT_EQ(match.world().single<EventLog>().match_stats[0][cause_of(sneeze.kind())].damage, 5);
}

TEST(NewEvent, WithoutARowTheGameDoesNotStart) {
    const auto data = load_match_data(assets(), {});
    ASSERT_FALSE(data);
    EXPECT_NE(data.error().message.find("event 'cough' has no row: add a table of that name"),
              std::string::npos)
        << data.error().message;
}

TEST(NewEvent, TwoOfOneNameAreAFault) {
    const std::vector<EventKindInfo> twice(2, {.name = "yawn", .cause = {}});
    EXPECT_NE(number_event_kinds({}, twice).fault.find("registered twice"), std::string::npos);
    const std::vector<EventKindInfo> taken{{.name = "death", .cause = {}}};
    EXPECT_NE(number_event_kinds({}, taken).fault.find("registered twice"), std::string::npos);
}

}  // namespace
}  // namespace thaum::game::test
