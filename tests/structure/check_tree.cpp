// Applies the rules to this source tree.
#include <gtest/gtest.h>

#include "structure/rules.h"

namespace thaum::structure {
namespace {

void expect_none(const Faults& faults) {
    for (const auto& fault : faults) ADD_FAILURE() << fault;
}

TEST(structure, arrows) { expect_none(upward_arrows(THAUM_SOURCE_DIR)); }
TEST(structure, machine_paths) { expect_none(machine_paths(THAUM_SOURCE_DIR)); }
TEST(structure, tests_are_built) { expect_none(unbuilt_tests(THAUM_SOURCE_DIR)); }
TEST(structure, headers_open_with_their_idea) { expect_none(headers_without_idea(THAUM_SOURCE_DIR)); }

}  // namespace
}  // namespace thaum::structure
