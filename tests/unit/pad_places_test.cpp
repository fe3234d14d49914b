// Tests of the places of pads (first to fourth pad): a pad that is plugged in again gets its old place.
#include <gtest/gtest.h>

#include "input/detail/pad_places.h"

namespace thaum::input {
namespace {

std::array<std::int32_t, 4> ids_of(const PadPlaces& places) {
    return {places[0].id, places[1].id, places[2].id, places[3].id};
}
using Ids = std::array<std::int32_t, 4>;

TEST(PadPlaces, PadsOfTwoModelsComeBackInAnyOrder) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "ps"}});
    EXPECT_EQ(ids_of(places), (Ids{0, 1, -1, -1}));
    place_pads(places, {});
    EXPECT_EQ(ids_of(places), (Ids{-1, -1, -1, -1}));
    place_pads(places, {{2, "ps"}});
    EXPECT_EQ(ids_of(places), (Ids{-1, 2, -1, -1}));
    place_pads(places, {{2, "ps"}, {3, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{3, 2, -1, -1}));
}

TEST(PadPlaces, OnePadOfTwoEqualOnesComesBackToItsPlace) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "xbox"}});
    place_pads(places, {{0, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{0, -1, -1, -1}));
    place_pads(places, {{0, "xbox"}, {2, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{0, 2, -1, -1}));
    place_pads(places, {{2, "xbox"}});
    place_pads(places, {{2, "xbox"}, {3, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{3, 2, -1, -1}));
}

TEST(PadPlaces, AnUnknownPadLeavesThePlaceOfAnUnpluggedOneWhileThereAreOthers) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "ps"}});
    place_pads(places, {{1, "ps"}});
    place_pads(places, {{1, "ps"}, {2, "other"}});
    EXPECT_EQ(ids_of(places), (Ids{-1, 1, 2, -1}));
    place_pads(places, {{1, "ps"}, {2, "other"}, {3, "fourth"}, {4, "fifth"}});
    EXPECT_EQ(ids_of(places), (Ids{4, 1, 2, 3})) << "with all places used the unplugged pad loses its own";
    place_pads(places, {{1, "ps"}, {2, "other"}, {3, "fourth"}, {4, "fifth"}, {5, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{4, 1, 2, 3})) << "there are only four";
}

TEST(PadPlaces, APadThatIsBackBeforeAnybodyLookedKeepsItsPlace) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "ps"}});
    place_pads(places, {{1, "ps"}, {2, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{2, 1, -1, -1}));
}

}  // namespace
}  // namespace thaum::input
