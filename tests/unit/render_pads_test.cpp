// Tests of the places of pads: a pad that comes back gets its place again.
#include <gtest/gtest.h>

#include "render/detail/pad_places.h"

namespace thaum::render {
namespace {

std::array<int, 4> ids_of(const PadPlaces& places) {
    return {places[0].id, places[1].id, places[2].id, places[3].id};
}
using Ids = std::array<int, 4>;

TEST(PadPlaces, PadsOfTwoModelsComeBackInAnyOrder) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "ps"}});
    EXPECT_EQ(ids_of(places), (Ids{0, 1, -1, -1}));
    place_pads(places, {});
    EXPECT_EQ(ids_of(places), (Ids{-1, -1, -1, -1}));
    // The window system gives its first number to the pad that comes back first.
    place_pads(places, {{0, "ps"}});
    EXPECT_EQ(ids_of(places), (Ids{-1, 0, -1, -1}));
    place_pads(places, {{0, "ps"}, {1, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{1, 0, -1, -1}));
}

TEST(PadPlaces, OnePadOfTwoEqualOnesComesBackToItsPlace) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "xbox"}});
    place_pads(places, {{0, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{0, -1, -1, -1}));
    place_pads(places, {{0, "xbox"}, {1, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{0, 1, -1, -1}));
    place_pads(places, {{1, "xbox"}});
    place_pads(places, {{0, "xbox"}, {1, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{0, 1, -1, -1}));
}

TEST(PadPlaces, AnUnknownPadLeavesThePlaceOfAnUnpluggedOneWhileThereAreOthers) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}, {1, "ps"}});
    place_pads(places, {{1, "ps"}});
    place_pads(places, {{0, "other"}, {1, "ps"}});
    EXPECT_EQ(ids_of(places), (Ids{-1, 1, 0, -1}));
    place_pads(places, {{0, "other"}, {1, "ps"}, {2, "fourth"}, {3, "fifth"}});
    EXPECT_EQ(ids_of(places), (Ids{3, 1, 0, 2})) << "with all places used the unplugged pad loses its own";
    place_pads(places, {{0, "other"}, {1, "ps"}, {2, "fourth"}, {3, "fifth"}, {4, "xbox"}});
    EXPECT_EQ(ids_of(places), (Ids{3, 1, 0, 2})) << "there are only four";
}

TEST(PadPlaces, ANumberThatAnotherModelTakesAtOnceIsAnotherPad) {
    PadPlaces places;
    place_pads(places, {{0, "xbox"}});
    place_pads(places, {{0, "ps"}});
    EXPECT_EQ(ids_of(places), (Ids{-1, 0, -1, -1}));
}

}  // namespace
}  // namespace thaum::render
