// core/sanitizers.h: which sanitizer a program is built with, for code that must not manage memory itself
// under a sanitizer. GCC and clang report a sanitizer by different macros.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define THAUM_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define THAUM_ADDRESS_SANITIZER 1
#endif
#endif
#ifndef THAUM_ADDRESS_SANITIZER
#define THAUM_ADDRESS_SANITIZER 0
#endif

#if defined(__SANITIZE_THREAD__)
#define THAUM_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define THAUM_THREAD_SANITIZER 1
#endif
#endif
#ifndef THAUM_THREAD_SANITIZER
#define THAUM_THREAD_SANITIZER 0
#endif
