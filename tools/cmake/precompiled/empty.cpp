// Empty on purpose: in CMake a precompiled header belongs to a target, and the target needs a source file.
