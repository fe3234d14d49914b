// ecs/view.h: iteration over the entities that have some components and lack others. Included by ecs/world.h.
//
//     world.view<Pose, const Velocity, Maybe<const Health>, Wizard, Without<Dead>>()
//         .each([](Entity e, Pose& p, const Velocity& v, const Health* h) { ... });
//
// The entity argument may be left out. Tags (here Wizard) and Without only filter. Tables are visited in the
// order of their creation, rows from first to last. Inside `each` no entity may be created or destroyed, and
// no component added or removed: use commands() instead.
#pragma once
#include <bit>
#include <type_traits>

#include "ecs/world.h"

namespace thaum::ecs {

/// View term: a pointer to the component, or null if the entity lacks it.
template <class C>
struct Maybe {};

/// View term: only entities without this component or tag.
template <class C>
struct Without {};

namespace detail {

template <class T>
struct Term {
    using component = std::remove_const_t<T>;
    static constexpr bool tag = Tag<component>;
    static constexpr bool required = true, excluded = false, optional = false;
    static constexpr bool writes = !std::is_const_v<T> && !tag;
    using value = T;
};
template <class T>
struct Term<Maybe<T>> {
    using component = std::remove_const_t<T>;
    static_assert(!Tag<component>, "ask has<Tag>() instead");
    static constexpr bool tag = false, required = false, excluded = false, optional = true;
    static constexpr bool writes = !std::is_const_v<T>;
    using value = T;
};
template <class T>
struct Term<Without<T>> {
    using component = T;
    static constexpr bool tag = Tag<T>;
    static constexpr bool required = false, excluded = true, optional = false, writes = false;
    using value = const T;
};

template <class T>
inline constexpr bool passed = !Term<T>::tag && !Term<T>::excluded;

/// What the function passed to `each` gets for one term of a view (such as a component) in one row: a
/// reference, or a pointer that may be null.
template <class T>
decltype(auto) argument(typename Term<T>::value* base, const Entity* entities, std::size_t row) {
    const auto place = StaysInPlace<typename Term<T>::component> ? entities[row].index : row;
    if constexpr (Term<T>::optional) {
        return base == nullptr ? nullptr : base + place;
    } else {
        return (base[place]);
    }
}

template <class... Ts>
struct Terms {};

/// The terms of a view that are passed as arguments, as a list Terms<...>. Tags and Without are not passed.
template <class Kept, class... Left>
struct Arguments;
template <class... Kept>
struct Arguments<Terms<Kept...>> {
    using type = Terms<Kept...>;
};
template <class... Kept, class T, class... Left>
struct Arguments<Terms<Kept...>, T, Left...>
    : Arguments<std::conditional_t<passed<T>, Terms<Kept..., T>, Terms<Kept...>>, Left...> {};

}  // namespace detail

/// The entities of a World that match all terms (World::view).
template <class... Terms>
class View {
public:
    View(const World& world, World::Query& query) : world_(world), query_(query) {}

    /// Calls f([entity,] component, ...) for each matching entity, in the order of tables and rows.
    template <class F>
    void each(F&& f) const {
        const Lock lock(world_);
        for (const auto t : query_.tables) {
            const auto& table = *world_.tables_[t];
            if (table.rows > 0) each_in(table, f);
        }
    }

    /// Number of entities that match.
    std::size_t count() const {
        std::size_t n = 0;
        each([&](Entity, const auto&...) { ++n; });
        return n;
    }

    /// Returns the first match, or `no_entity` if there is none.
    Entity first() const {
        for (const auto t : query_.tables) {
            const auto& table = *world_.tables_[t];
            for (std::uint32_t row = 0; row < table.rows; row += 64) {
                const auto word = matching(table, row);
                if (word != 0)
                    return table.entities()[row + static_cast<std::uint32_t>(std::countr_zero(word))];
            }
        }
        return no_entity;
    }

private:
    struct Lock {
        const World& world;
        explicit Lock(const World& w) : world(w) { ++world.locks_; }
        ~Lock() { --world.locks_; }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
    };

    static constexpr bool filters_tags = (detail::Term<Terms>::tag || ...);

    template <class T>
    typename detail::Term<T>::value* base(const Table& table) const {
        return table.template cells_of<typename detail::Term<T>::value>(
            world_.template known_id<typename detail::Term<T>::component>());
    }

    /// Those of the 64 rows from `row` on whose entities match the view, as one bit for each row.
    std::uint64_t matching(const Table& table, std::uint32_t row) const {
        const auto left = table.rows - row;
        std::uint64_t word = left >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << left) - 1;
        const auto apply = [&]<class T>(std::type_identity<T>) {
            using Term = detail::Term<T>;
            if constexpr (Term::tag) {
                const auto at = table.tag_of[world_.template known_id<typename Term::component>()];
                const auto bits = at == no_tag ? 0 : table.tags[at].words[row / 64];
                word &= Term::excluded ? ~bits : bits;
            }
        };
        (apply(std::type_identity<Terms>{}), ...);
        return word;
    }

    template <class F>
    void each_in(const Table& table, F& f) const {
        each_row(table, f, typename detail::Arguments<detail::Terms<>, Terms...>::type{});
    }

    template <class F, class... Passed>
    void each_row(const Table& table, F& f, detail::Terms<Passed...>) const {
        each_row_of<F, Passed...>(table, f, base<Passed>(table)...);
    }

    template <class F, class... Passed>
    void each_row_of(const Table& table, F& f, typename detail::Term<Passed>::value*... bases) const {
        const auto* entities = table.entities();
        const auto call = [&](std::size_t row) {
            if constexpr (std::is_invocable_v<F&, Entity,
                                              decltype(detail::argument<Passed>(bases, entities, row))...>) {
                f(entities[row], detail::argument<Passed>(bases, entities, row)...);
            } else {
                f(detail::argument<Passed>(bases, entities, row)...);
            }
        };
        if constexpr (!filters_tags) {
            const std::size_t rows = table.rows;
            for (std::size_t row = 0; row < rows; ++row) call(row);
        } else {
            for (std::uint32_t row = 0; row < table.rows; row += 64) {
                for (auto word = matching(table, row); word != 0; word &= word - 1) {
                    call(row + static_cast<std::size_t>(std::countr_zero(word)));
                }
            }
        }
    }

    const World& world_;
    World::Query& query_;
};

template <class... Terms>
View<Terms...> World::view() const {
    const auto type = detail::type_number<View<Terms...>>;
    if (!queries_[type]) [[unlikely]] {
        auto made = make_pooled<Query>(memory_);
        made->tables.reserve(usual_tables);
        const auto note = [&]<class T>(std::type_identity<T>) {
            using Term = detail::Term<T>;
            const auto c = id<typename Term::component>();
            if (!Term::tag && Term::required) made->required.set(c);
            if (!Term::tag && Term::excluded) made->excluded.set(c);
        };
        (note(std::type_identity<Terms>{}), ...);
        queries_[type] = std::move(made);
    }
    auto& query = *queries_[type];
    if (access_ != nullptr) [[unlikely]] {
        (check_access(id<typename detail::Term<Terms>::component>(), detail::Term<Terms>::writes), ...);
    }
    if (query.tables_seen != tables_.size()) [[unlikely]] {
        refresh(query);
    }
    return {*this, query};
}

template <class... Terms>
View<Terms...> World::view() {
    return std::as_const(*this).template view<Terms...>();
}

}  // namespace thaum::ecs
