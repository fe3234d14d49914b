// core/detail/config_state.h: what a Config holds: the tables of a file, and the faults found in it.
#pragma once
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/detail/config_faults.h"
#include "core/detail/toml_parse.h"

namespace thaum {

struct Config::State {
    toml::table root;
    std::string name;
    std::vector<detail::ConfigFault> faults;
    std::set<const toml::node*> asked;
    detail::AskedKeys asked_keys;

    /// Marks all keys within a value as asked for by a reader. Otherwise a table that stands in the place of
    /// a number would be reported again for each of its keys, as an unknown one.
    void mark_asked(const toml::node& value);
    /// Adds a fault to those of the file. `misleads`: true if the fault keeps the reader from knowing which
    /// keys belong to this table.
    void report(const toml::node* where, detail::FaultKind kind, std::string_view key, std::string what,
                bool misleads = false);
};

}  // namespace thaum
