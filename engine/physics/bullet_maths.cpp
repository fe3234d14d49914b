// This file must be linked into every program that uses Bullet; Physics asserts it by calling
// require_our_maths(). Definitions in a program take precedence over those in a library, whatever the
// order on the linker's command line. The linker exports them automatically, because Bullet's libraries
// import them.
#include "physics/bullet_maths.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "core/assert.h"
#include "core/hash.h"
#include "core/maths.h"
#include "core/sin_cos.h"
#include "core/text.h"

extern "C" {
[[gnu::visibility("default")]] double sin(double x) noexcept { return thaum::det::sin(x); }
[[gnu::visibility("default")]] double cos(double x) noexcept { return thaum::det::cos(x); }
[[gnu::visibility("default")]] double acos(double x) noexcept { return thaum::det::acos(x); }
[[gnu::visibility("default")]] double asin(double x) noexcept { return thaum::det::asin(x); }
[[gnu::visibility("default")]] double atan2(double y, double x) noexcept { return thaum::det::atan2(y, x); }
[[gnu::visibility("default")]] double pow(double x, double y) noexcept { return thaum::det::pow(x, y); }
[[gnu::visibility("default")]] void sincos(double x, double* sine, double* cosine) noexcept {
    const auto both = thaum::det::sin_cos(x);
    *sine = both.sine;
    *cosine = both.cosine;
}
}

namespace thaum::physics {
namespace {

/// Functions whose result IEEE 754 or C defines to the last bit.
constexpr std::array<std::string_view, 14> exact_functions{"sqrt",  "fmod",  "floor",  "ceil",  "fabs",
                                                           "trunc", "rint",  "round",  "ldexp", "frexp",
                                                           "sqrtf", "fmodf", "floorf", "ceilf"};

/// The parts of a loaded library that list the functions it imports.
struct Imports {
    const ElfW(Sym) * symbols{};
    const char* names{};
    std::span<const ElfW(Rela)> data, calls;
};

Imports imports_of(const ElfW(Dyn) * entry) {
    Imports imports;
    const ElfW(Rela)* data = nullptr;
    const ElfW(Rela)* calls = nullptr;
    std::size_t data_bytes = 0, call_bytes = 0;
    for (; entry->d_tag != DT_NULL; ++entry) {
        const auto address = entry->d_un.d_ptr;
        if (entry->d_tag == DT_SYMTAB) imports.symbols = reinterpret_cast<const ElfW(Sym)*>(address);
        if (entry->d_tag == DT_STRTAB) imports.names = reinterpret_cast<const char*>(address);
        if (entry->d_tag == DT_RELA) data = reinterpret_cast<const ElfW(Rela)*>(address);
        if (entry->d_tag == DT_JMPREL) calls = reinterpret_cast<const ElfW(Rela)*>(address);
        if (entry->d_tag == DT_RELASZ) data_bytes = entry->d_un.d_val;
        if (entry->d_tag == DT_PLTRELSZ) call_bytes = entry->d_un.d_val;
    }
    if (data != nullptr) imports.data = {data, data_bytes / sizeof *data};
    if (calls != nullptr) imports.calls = {calls, call_bytes / sizeof *calls};
    return imports;
}

/// Handles of the system's libraries. A search in libm continues in libc, so a function counts as one of libm
/// only if libc has another one.
struct MachineLibraries {
    void* maths = dlopen("libm.so.6", RTLD_LAZY | RTLD_NOLOAD);
    void* c = dlopen("libc.so.6", RTLD_LAZY | RTLD_NOLOAD);
};

/// True if the process takes this function from the system's mathematical library and its results
/// depend on the processor.
bool is_foreign(const MachineLibraries& machine, const char* name) {
    if (name[0] == '_') return false;  // internal to C++ or the compiler, not a mathematical function
    if (std::ranges::find(exact_functions, std::string_view(name)) != exact_functions.end()) return false;
    void* const its_own = machine.maths != nullptr ? dlsym(machine.maths, name) : nullptr;
    if (its_own == nullptr || dlsym(RTLD_DEFAULT, name) != its_own) return false;
    return machine.c == nullptr || dlsym(machine.c, name) != its_own;
}

void add_foreign(const Imports& imports, std::span<const ElfW(Rela)> relocations, std::string_view library,
                 std::vector<std::string>& found) {
    const MachineLibraries machine;
    for (const auto& relocation : relocations) {
        const ElfW(Sym)& symbol = imports.symbols[ELF64_R_SYM(relocation.r_info)];
        if (symbol.st_shndx != SHN_UNDEF || symbol.st_name == 0) continue;
        const char* const name = imports.names + symbol.st_name;
        if (is_foreign(machine, name)) found.push_back(text(library, ": ", name));
    }
}

bool is_bullets(std::string_view library) {
    return library.find("libBullet") != std::string_view::npos ||
           library.find("libLinearMath") != std::string_view::npos;
}

// Hides a value from the compiler by `volatile`. Otherwise the compiler would compute the results itself,
// correctly rounded.
double opaque(double x) {
    volatile double hidden = x;
    return hidden;
}

std::uint64_t probe_at(std::uint64_t hash, double unit) {
    const double x = opaque(unit);               // an argument in (0, 1)
    const double wide = opaque(unit * 50 - 25);  // an argument of several turns
    const double arc = opaque(2 * unit - 1);
    double sine = 0, cosine = 0;
    sincos(opaque(wide * 1e5), &sine, &cosine);
    for (const double value : {std::sin(wide), std::cos(wide), sine, cosine, std::atan2(wide, x),
                               std::acos(arc), std::asin(arc), std::pow(x, opaque(0.001 + unit))}) {
        hash = hash_value(value, hash);
    }
    return hash;
}

}  // namespace

std::vector<std::string> foreign_maths() {
    std::vector<std::string> found;
    const auto* program = static_cast<const link_map*>(dlopen(nullptr, RTLD_LAZY | RTLD_NOLOAD));
    for (const auto* loaded = program; loaded != nullptr; loaded = loaded->l_next) {
        const std::string_view library = loaded->l_name;
        if (!is_bullets(library)) continue;
        const Imports imports = imports_of(loaded->l_ld);
        if (imports.symbols == nullptr || imports.names == nullptr) continue;
        add_foreign(imports, imports.data, library, found);
        add_foreign(imports, imports.calls, library, found);
    }
    return found;
}

void require_our_maths() {
    static const bool checked = [] {
        const auto foreign = foreign_maths();
        THAUM_ASSERT(
            foreign.empty(),
            text("Bullet computes with the system's mathematical functions (", foreign.front(),
                 ", ...), so this match could not be replayed on another processor: link the program with "
                 "all of thaum_physics"));
        return true;
    }();
    static_cast<void>(checked);
}

std::uint64_t maths_probe() {
    constexpr int arguments = 512;
    std::uint64_t hash = 0;
    for (int i = 0; i < arguments; ++i) hash = probe_at(hash, (i + 0.37) / arguments);
    return hash;
}

}  // namespace thaum::physics
