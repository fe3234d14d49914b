// Checks that this source tree keeps the rules of structure: includes, names, lengths of files and more.
#include <gtest/gtest.h>

#include "structure/rules.h"

namespace thaum::structure {
namespace {

void expect_none(const Faults& faults) {
    for (const auto& fault : faults) ADD_FAILURE() << fault;
}

TEST(structure, includes_point_to_lower_floors) { expect_none(upward_includes(THAUM_SOURCE_DIR)); }
TEST(structure, machine_paths) { expect_none(machine_paths(THAUM_SOURCE_DIR)); }
TEST(structure, tests_are_built) { expect_none(unbuilt_tests(THAUM_SOURCE_DIR)); }
TEST(structure, headers_open_with_their_title) { expect_none(headers_without_title(THAUM_SOURCE_DIR)); }
TEST(structure, internal_headers_are_in_detail) { expect_none(internal_headers(THAUM_SOURCE_DIR)); }
TEST(structure, files_are_opened_by_the_rule) { expect_none(opens_around_the_rule(THAUM_SOURCE_DIR)); }
TEST(structure, files_are_short) { expect_none(long_files(THAUM_SOURCE_DIR)); }
TEST(structure, comments_are_narrow) { expect_none(long_comments(THAUM_SOURCE_DIR)); }
TEST(structure, rooms_have_namespaces) { expect_none(wrong_namespaces(THAUM_SOURCE_DIR)); }

}  // namespace
}  // namespace thaum::structure
