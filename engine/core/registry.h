// core/registry.h: lists to which the source files of a program add values, such as wands, commands or
// drivers.
//
//     struct WandKind { std::string_view name; ... };
//     using WandRegistration = Registration<WandKind>;
//
//     const WandRegistration registration({.name = "bolt", ...});     // in wands/bolt.cpp
//     for (const auto& kind : registry_of<WandKind>().all()) ...      // after the start of main
//
// Registrations run before `main`, in an order that the linker chooses. A list is sorted, so this order makes
// no difference. The linker must keep the object file of each registration: link whole libraries.
#pragma once
#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "core/assert.h"
#include "core/text.h"

namespace thaum {

/// Values with different names, sorted. `Kind` has a member `name` by which it is found, and may have a
/// member `order`: smaller orders come first.
template <class Kind>
class Registry {
public:
    /// Adds a value. Its name must be new: two parts of a program with one name are our own mistake.
    void add(const Kind& kind) {
        THAUM_ASSERT(find(kind.name) == nullptr, text("two parts of the program have the name ", kind.name));
        kinds_.insert(std::ranges::upper_bound(kinds_, place_of(kind), {}, place_of), kind);
    }
    /// All values, sorted by order and name.
    const std::vector<Kind>& all() const { return kinds_; }
    /// The value of this name; null if there is none. The pointer is valid until the next `add`.
    const Kind* find(std::string_view name) const {
        const auto found = std::ranges::find(kinds_, name, &Kind::name);
        return found == kinds_.end() ? nullptr : &*found;
    }

private:
    static auto place_of(const Kind& kind) {
        if constexpr (requires { kind.order; })
            return std::pair(kind.order, kind.name);
        else
            return kind.name;
    }

    std::vector<Kind> kinds_{};
};

/// The program's registry of a kind. It is made at the first use, which may be before `main`.
template <class Kind>
Registry<Kind>& registry_of() {
    static Registry<Kind> registry;
    return registry;
}

/// Adds a value to the program's registry when the program starts.
template <class Kind>
struct Registration {
    explicit Registration(const Kind& kind) { registry_of<Kind>().add(kind); }
};

}  // namespace thaum
