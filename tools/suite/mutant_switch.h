// tools/suite/mutant_switch.h: chooses at run time which mutant of a mutated build is active (mutation
// testing). Mutants are built in a copy of the source tree, in which every C++ source includes this header
// first (see tree.py). Normal builds do not use it.
#pragma once
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace thaum_mutants {

struct Switch {
    int active = 0;                    ///< number of the active mutant; 0: none
    unsigned char* reached = nullptr;  ///< one byte for each mutant, in a shared file; null: no file
    int count = 0;                     ///< number of bytes in `reached`
};

/// Reads THAUM_MUTANT (a number) and maps the file that THAUM_MUTANTS_REACHED names. The file is shared
/// memory, so the mutants that a program reached are known even if it is killed.
inline Switch read_environment() {
    Switch result;
    if (const char* active = std::getenv("THAUM_MUTANT")) result.active = std::atoi(active);
    const char* name = std::getenv("THAUM_MUTANTS_REACHED");
    const int file = name != nullptr ? ::open(name, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0) return result;
    struct stat about {};
    if (::fstat(file, &about) == 0 && about.st_size > 0) {
        const auto size = static_cast<unsigned long>(about.st_size);
        void* map = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (map != MAP_FAILED) {
            result.reached = static_cast<unsigned char*>(map);
            result.count = static_cast<int>(size);
        }
    }
    ::close(file);
    return result;
}

/// Returns true if the mutant is active, and notes that its line was reached. Works in constructors of static
/// objects and on any thread. Allocates nothing.
inline bool on(int mutant) {
    static const Switch the_switch = read_environment();
    // A byte that is set already is not written again, so that threads do not compete for the cache line.
    if (mutant < the_switch.count && __atomic_load_n(the_switch.reached + mutant, __ATOMIC_RELAXED) == 0)
        __atomic_store_n(the_switch.reached + mutant, static_cast<unsigned char>(1), __ATOMIC_RELAXED);
    return mutant == the_switch.active;
}

}  // namespace thaum_mutants
