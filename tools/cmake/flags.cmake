# Compiler flags of the whole project (design: architecture.md, "Packages and build").
#
# -ffp-contract=off: a fused multiply-add rounds once instead of twice, so it would make results depend on what the
# compiler chose to fuse. No fast-math for the same reason. With these builds agree to the bit, whatever they optimise.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

option(THAUM_PORTABLE "Build for any x86-64, not only for x86-64-v3 (AVX2)" OFF)
set(THAUM_SANITIZE "" CACHE STRING "Sanitizers: empty, 'address,undefined' or 'thread'")

# Several sources as one halve the time of a whole build, most of which goes into the same headers again and again.
# Turn it off where one file is changed over and over; either way must compile.
option(CMAKE_UNITY_BUILD "Compile several sources as one" ON)
# What is not optimised takes its time for the headers alone.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
if(THAUM_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug")
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
endif()

add_library(thaum_flags INTERFACE)
target_compile_options(thaum_flags INTERFACE
    -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Up to so many kB the compiler does not tidy up its memory, which takes a tenth of its time.
    target_compile_options(thaum_flags INTERFACE --param=ggc-min-heapsize=1000000)
endif()
if(CMAKE_UNITY_BUILD)
    # GCC takes the anonymous namespaces of sources that are included for a header's.
    target_compile_options(thaum_flags INTERFACE -Wno-subobject-linkage)
endif()
# For sources that run before we know the processor, and before the sanitizers know the memory.
set(THAUM_ANY_PROCESSOR -march=x86-64 -fno-sanitize=all)
if(THAUM_PORTABLE)
    # Vectors of eight floats are passed in another way with AVX than without; all that passes them is compiled here, in one way.
    target_compile_options(thaum_flags INTERFACE -Wno-psabi)
else()
    # Without FMA: GCC 12 joins additions and subtractions side by side into vfmaddsub whatever -ffp-contract says, and then two
    # builds differ in the last bit.
    target_compile_options(thaum_flags INTERFACE -march=x86-64-v3 -mno-fma)
endif()
if(THAUM_SANITIZE)
    target_compile_options(thaum_flags INTERFACE -fsanitize=${THAUM_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(thaum_flags INTERFACE -fsanitize=${THAUM_SANITIZE})
    # What sanitizers add confuses this warning of GCC, even in std::regex; the release build has it.
    target_compile_options(thaum_flags INTERFACE -Wno-maybe-uninitialized)
    if(THAUM_SANITIZE MATCHES "undefined")
        # A null pointer that is followed ends the program anyway, with the same trace; to ask before each costs time in all that is built
        # and run. What this leaves unseen: a null that is only bound to a reference, or whose member is called and touches nothing.
        target_compile_options(thaum_flags INTERFACE -fno-sanitize-recover=undefined -fno-sanitize=null)
    endif()
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -g1")
set(CMAKE_CXX_FLAGS_DEBUG "-O0 -g1")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")

find_program(CCACHE ccache)
if(CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
