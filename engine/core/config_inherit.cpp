// A file that is based on another one: it holds only what differs.
#include "core/config.h"
#include "core/detail/config_state.h"

namespace thaum {
namespace {

/// Adds to `table` every key of `base` that it lacks, also in tables that both have.
void add_missing_keys(toml::table& table, const toml::table& base) {
    for (const auto& [key, node] : base) {
        const auto name = key.str();
        auto* own = table.get(name);
        if (own == nullptr)
            node.visit([&table, name](const auto& value) { table.insert(name, value); });
        else if (own->is_table() && node.is_table())
            add_missing_keys(*own->as_table(), *node.as_table());
    }
}

}  // namespace

void Config::inherit(const Config& base) { add_missing_keys(state_->root, base.state_->root); }

}  // namespace thaum
