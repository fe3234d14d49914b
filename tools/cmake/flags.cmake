# Compiler flags of the whole project (engine/ARCHITECTURE.md, "Build"). Optimisation and debug symbols are
# the build type's; CMakePresets.json sets them for our own builds. These use clang, which compiles the game
# in half of GCC's time and makes a faster game. Tests compare a match that GCC's build plays, and the
# examples beside an installed engine: both compilers come to the same bits.
#
# -ffp-contract=off: a fused multiply-add rounds once instead of twice, so results would depend on the
# compiler's choice of what to fuse. No fast-math for the same reason. With these flags all builds agree to
# the bit, whatever their optimisation. A user's own flags are kept, except for fast-math.
if(CMAKE_C_FLAGS OR CMAKE_CXX_FLAGS OR CMAKE_EXE_LINKER_FLAGS)
    string(APPEND CMAKE_C_FLAGS " -fno-fast-math")
    string(APPEND CMAKE_CXX_FLAGS " -fno-fast-math")
    string(APPEND CMAKE_EXE_LINKER_FLAGS " -fno-fast-math")
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

option(THAUM_PORTABLE "Build for any x86-64, not only for x86-64-v3 (AVX2)" OFF)
set(THAUM_SANITIZE "" CACHE STRING "Sanitizers: empty, 'address,undefined' or 'thread'")

# Compiling several sources of a folder as one halves the time of a whole build, which mostly instantiates the same
# templates again and again. Batches are small, so that a change of one source compiles in seconds; those of builds
# that only the tests make are larger (CMakePresets.json). The code must compile in any batches: tools/tidy.sh compiles
# each source on its own.
option(CMAKE_UNITY_BUILD "Compile several sources as one" ON)
set(THAUM_BATCH 12 CACHE STRING "How many sources are compiled as one at most")
set(CMAKE_UNITY_BUILD_BATCH_SIZE ${THAUM_BATCH})

option(THAUM_WARNINGS_AS_ERRORS "Stop a build at its first warning" OFF)
option(THAUM_HARDENED "Let programs end where memory is overrun, and name no folder of the build" OFF)

# Flags on which the bits of results depend. Programs that use the installed engine are compiled with them too,
# because much of the engine's arithmetic stands in its headers.
add_library(thaum_arithmetic INTERFACE)
add_library(Thaum::arithmetic ALIAS thaum_arithmetic)
set(THAUM_ARITHMETIC -ffp-contract=off)
if(THAUM_PORTABLE)
    # Vectors of eight floats are passed differently with and without AVX. All code that passes them is
    # compiled here, in one way, so the warning of it is turned off.
    list(APPEND THAUM_ARITHMETIC -Wno-psabi)
else()
    # No FMA: GCC 12 joins neighbouring additions and subtractions into vfmaddsub whatever -ffp-contract says,
    # and then two builds differ in the last bit.
    list(APPEND THAUM_ARITHMETIC -march=x86-64-v3 -mno-fma)
endif()
target_compile_options(thaum_arithmetic INTERFACE "$<$<COMPILE_LANGUAGE:C,CXX>:${THAUM_ARITHMETIC}>")
target_compile_features(thaum_arithmetic INTERFACE cxx_std_20)
set_target_properties(thaum_arithmetic PROPERTIES EXPORT_NAME arithmetic)

# Flags of our own builds alone.
add_library(thaum_flags INTERFACE)
target_link_libraries(thaum_flags INTERFACE thaum_arithmetic)
target_compile_options(thaum_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# No code reads errno after a mathematical function. Without it a square root is one instruction. No result
# changes.
target_compile_options(thaum_flags INTERFACE -fno-math-errno)
if(THAUM_WARNINGS_AS_ERRORS)
    target_compile_options(thaum_flags INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Keeps the compiler from collecting garbage below this many kB; collecting takes a tenth of its time.
    target_compile_options(thaum_flags INTERFACE --param=ggc-min-heapsize=1000000)
elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # LLVM's linker takes half the time of the usual one, a third under sanitizers.
    find_program(LLD ld.lld)
    if(LLD)
        target_link_options(thaum_flags INTERFACE -fuse-ld=lld)
    endif()
    # Loops carry a hint for GCC (ivdep) that clang does not know and would warn of.
    target_compile_options(thaum_flags INTERFACE -Wno-unknown-pragmas)
endif()
# Protections against buffer overruns, because the program reads files from strangers and may use devices.
# Builds with sanitizers do without: sanitizers have better checks of their own, and their traces and
# tools/suite need whole paths of files, which this shortens.
if(THAUM_HARDENED AND NOT THAUM_SANITIZE)
    # Code that only computes numbers (HOT) has no checks of stack and copies, which would cost the fluid 4 to
    # 9 %, mostly by _FORTIFY_SOURCE, which changes what is inlined. Debian's GCC may define that already, so
    # it is undefined first. glibc warns of it in code that is not optimised.
    set(watched "$<NOT:$<BOOL:$<TARGET_PROPERTY:THAUM_HOT>>>")
    set(optimised "$<AND:$<CONFIG:Release>,$<NOT:$<BOOL:$<TARGET_PROPERTY:THAUM_UNOPTIMISED>>>>")
    target_compile_options(thaum_flags INTERFACE $<${watched}:-fstack-protector-strong>
        "$<$<AND:${watched},${optimised}>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
    # Addresses of called functions are found at the start, and their table is then made read-only.
    target_link_options(thaum_flags INTERFACE -Wl,-z,relro,-z,now,-z,noexecstack)
    # Assertions, failed tests and debuggers name files from the root of the tree.
    target_compile_options(thaum_flags INTERFACE
        -ffile-prefix-map=${PROJECT_SOURCE_DIR}=. -ffile-prefix-map=${PROJECT_BINARY_DIR}=.)
endif()

# Flags for sources that run before the processor check, and before the sanitizers have set up their memory.
set(THAUM_ANY_PROCESSOR -march=x86-64 -fno-sanitize=all)
if(THAUM_SANITIZE)
    target_compile_options(thaum_flags INTERFACE -fsanitize=${THAUM_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(thaum_flags INTERFACE -fsanitize=${THAUM_SANITIZE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # The sanitizers' code confuses this warning of GCC, even in std::regex. The release build has the
        # warning.
        target_compile_options(thaum_flags INTERFACE -Wno-maybe-uninitialized)
    endif()
    if(THAUM_SANITIZE MATCHES "undefined")
        # Leaves out three checks that slow builds and tests down. A null pointer that is dereferenced ends
        # the program anyway, with the same trace; unseen are a null that is only bound to a reference, and a
        # call of a member function that reads no member. A pointer beyond its object is found by the address
        # sanitizer when it is used; unseen is one that is only computed (pointer-overflow, object-size).
        target_compile_options(thaum_flags INTERFACE -fno-sanitize-recover=undefined
            -fno-sanitize=null,pointer-overflow,object-size)
        if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
            # Clang also checks the types of called functions. Those of an arm's library, which come by dlsym, are
            # of C, so their types have other names.
            target_compile_options(thaum_flags INTERFACE -fno-sanitize=function)
        endif()
    endif()
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    # Without the settings pch_defines and time_macros, ccache does not cache a source with a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(thaum_flags INTERFACE -fpch-preprocess)
    endif()
endif()
