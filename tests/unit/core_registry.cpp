// Tests of lists to which sources add themselves: they do not depend on the order of additions.
#include "core/registry.h"

#include <gtest/gtest.h>

namespace thaum {
namespace {

struct Spice {
    std::string_view name;
    int grams{};
};

struct Course {
    std::string_view name;
    int order = 100;
};

template <class Kind>
std::vector<std::string_view> names_of(const Registry<Kind>& registry) {
    std::vector<std::string_view> names;
    for (const auto& kind : registry.all()) names.push_back(kind.name);
    return names;
}

/// The names in a new registry, after these values were added to it in this order.
template <class Kind>
std::vector<std::string_view> names_after(const std::vector<Kind>& added) {
    Registry<Kind> registry;
    for (const auto& kind : added) registry.add(kind);
    return names_of(registry);
}

TEST(Registry, AnEmptyOneFindsNothing) {
    const Registry<Spice> registry;
    EXPECT_TRUE(registry.all().empty());
    EXPECT_EQ(registry.find("salt"), nullptr);
    EXPECT_EQ(registry.find(""), nullptr);
}

TEST(Registry, IsSortedInWhateverOrderValuesAreAdded) {
    std::vector<Spice> spices{{"anise"}, {"clove"}, {"mace"}, {"salt"}};
    const std::vector<std::string_view> sorted{"anise", "clove", "mace", "salt"};
    std::size_t orders = 0;
    do {
        EXPECT_EQ(names_after(spices), sorted);
        ++orders;
    } while (std::ranges::next_permutation(spices, {}, &Spice::name).found);
    EXPECT_EQ(orders, 24U);
}

TEST(Registry, AnOrderComesBeforeTheName) {
    const std::vector<Course> courses{{"soup", 1}, {"cake"}, {"apple"}, {"bread", 1}};
    EXPECT_EQ(names_after(courses), (std::vector<std::string_view>{"bread", "soup", "apple", "cake"}));
}

TEST(Registry, FindsAValueByItsWholeName) {
    Registry<Spice> registry;
    registry.add({"salt", 5});
    registry.add({"mace", 2});
    ASSERT_NE(registry.find("salt"), nullptr);
    EXPECT_EQ(registry.find("salt")->grams, 5);
    EXPECT_EQ(registry.find("mace")->grams, 2);
    EXPECT_EQ(registry.find("sal"), nullptr);
}

TEST(RegistryDeathTest, ANameTwiceStopsTheProgramAndIsTold) {
    Registry<Course> registry;
    registry.add({"soup", 1});
    EXPECT_DEATH(registry.add({"soup", 2}), "two parts of the program have the name soup");
}

/// Number of spices (values that this test registers) found by an initialiser that runs before the
/// registrations below.
const std::size_t found_first = registry_of<Spice>().all().size();
const Registration<Spice> second({"thyme", 2});
const Registration<Spice> first({"basil", 1});

TEST(Registry, RegistrationsBeforeMainAreInTheProgramsRegistry) {
    EXPECT_EQ(found_first, 0U);
    EXPECT_EQ(names_of(registry_of<Spice>()), (std::vector<std::string_view>{"basil", "thyme"}));
}

}  // namespace
}  // namespace thaum
