#include "core/detail/config_faults.h"

#include <algorithm>
#include <optional>

#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::detail {
namespace {

constexpr std::size_t max_listed = 12;  // most names that are listed in a message about an unknown key

/// An unknown key, with the known key that was probably meant.
struct Stray {
    const UnknownKey* unknown{};
    std::string meant;  ///< the known key that was probably meant; empty: none
    bool doubtful{};    ///< true: a wrong value misled the reader of this table, so the key may be correct
    bool told = false;
};

class Telling {
public:
    Telling(const std::string& file, const std::vector<ConfigFault>& faults,
            const std::vector<UnknownKey>& unknown, const AskedKeys& asked)
        : file_(file), faults_(faults), asked_(asked) {
        for (const auto& one : unknown)
            strays_.push_back({.unknown = &one, .meant = meaning_of(one), .doubtful = is_doubtful(one)});
    }

    std::optional<Error> tell() {
        for (const auto& fault : faults_) {
            tell_strays_before(fault);
            if (!is_slip(fault)) add(fault.line, text(fault.message, place_of_misplaced(fault)));
        }
        for (auto& stray : strays_) tell_stray(stray);
        return std::move(error_);
    }

private:
    /// Names of the keys that readers asked for in the table of this unknown key, which may be one of them
    /// misspelt.
    std::vector<std::string_view> open_names(const UnknownKey& key) const {
        const auto found = asked_.find(key.table);
        if (found == asked_.end()) return {};
        return {found->second.begin(), found->second.end()};
    }

    std::string meaning_of(const UnknownKey& key) const {
        return std::string(near_name(key.key, open_names(key)));
    }

    bool is_doubtful(const UnknownKey& key) const {
        return std::ranges::any_of(faults_, [&](const ConfigFault& fault) {
            return fault.table == key.table && (fault.misleads || fault.kind == FaultKind::told);
        });
    }

    /// Whether some unknown key is this missing key, misspelt.
    bool is_slip(const ConfigFault& fault) const {
        if (fault.kind != FaultKind::missing && fault.kind != FaultKind::told) return false;
        return std::ranges::any_of(strays_, [&](const Stray& stray) {
            return stray.unknown->table == fault.table && !stray.meant.empty() && stray.meant == fault.key;
        });
    }

    /// Words for a message about a missing key: where the same key stands in another table, in which nobody
    /// asks for it.
    std::string place_of_misplaced(const ConfigFault& fault) {
        if (fault.kind != FaultKind::missing) return {};
        const auto stray = std::ranges::find_if(strays_, [&](const Stray& one) {
            return !one.told && one.unknown->key == fault.key && one.unknown->table != fault.table;
        });
        if (stray == strays_.end()) return {};
        stray->told = true;
        return text("; line ", stray->unknown->line, " has it in another table, as '", stray->unknown->path,
                    "': move it");
    }

    void tell_strays_before(const ConfigFault& fault) {
        for (auto& stray : strays_) {
            if (stray.unknown->table != fault.table || fault.kind == FaultKind::value) continue;
            if (!stray.meant.empty() || fault.kind == FaultKind::missing) tell_stray(stray);
        }
    }

    void tell_stray(Stray& stray) {
        if (stray.told || (stray.doubtful && stray.meant.empty())) return;
        stray.told = true;
        const auto& key = *stray.unknown;
        auto line = text("unknown key '", key.path, "'");
        if (!stray.meant.empty()) {
            line += text("; did you mean '", stray.meant, "'?");
        } else {
            line += known_here(open_names(key));
        }
        add(key.line, line);
    }

    static std::string known_here(std::vector<std::string_view> names) {
        std::erase(names, "version");
        if (names.empty() || names.size() > max_listed) return "";
        std::string list;
        for (const auto name : names) list += text(list.empty() ? "" : ", ", name);
        return text("; known here: ", list);
    }

    void add(std::size_t line, std::string_view what) {
        add_faults(error_, Error{line == 0 ? text(file_, ": ", in_one_line(what))
                                           : text(file_, ":", line, ": ", in_one_line(what))});
    }

    const std::string& file_;
    const std::vector<ConfigFault>& faults_;
    const AskedKeys& asked_;
    std::vector<Stray> strays_;
    std::optional<Error> error_;
};

}  // namespace

std::optional<Error> told_faults(const std::string& file, const std::vector<ConfigFault>& faults,
                                 const std::vector<UnknownKey>& unknown, const AskedKeys& asked) {
    return Telling(file, faults, unknown, asked).tell();
}

}  // namespace thaum::detail
